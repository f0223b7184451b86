"""How fast emitted classes are written, compiled and replayed.

    python -m benchmarks.compile [--classes 64] [--bodies 8] [--jobs 2] [--json FILE]
    python -m benchmarks.compile --suite RUN [--json FILE]

The first form prints classes per minute one by one and batched, on an empty cache each, with the
processor time beside the wall time, because the wall time of a shared machine says little. The
second checks class and exports of the finished scenes below a folder, such as a run of `esg bench`
(see benchmarks/compile/exports.py).
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import asdict, dataclass
import json
import math
import os
from pathlib import Path
import resource
import tempfile
import time

import numpy as np

from esg.compile import WatchedEvent, compile_many, emit_class, replay_class
from esg.compile.build import Library, read_classes
from esg.compile.scene import write_class
from esg.engines.program import AdjustProperties, HoldVelocity, Program, SetVelocity
from esg.engines.scene import Body, Shape, SimScene


@dataclass(frozen=True)
class Measurement:
    """One step of the work on all classes.

    Args:
        step: What was done.
        wall_s, cpu_s: For all classes; processor time includes compilers.
        classes_per_minute: By wall time.
        cpu_s_per_class: Processor time of one class.
    """

    step: str
    wall_s: float
    cpu_s: float
    classes_per_minute: float
    cpu_s_per_class: float


def scene(seed: int, bodies: int) -> tuple[SimScene, Program, tuple[WatchedEvent, ...]]:
    """A row of crates and balls; the first is driven into the second."""
    rng = np.random.default_rng(seed)
    out: list[Body] = []
    for i in range(bodies):
        half = tuple(rng.uniform(0.1, 0.3, 3).tolist())
        shape = Shape("sphere", (half[0],) * 3) if i % 2 else Shape("box", half)
        height = half[0] if i % 2 else half[2]
        mass = float(rng.uniform(0.5, 20.0))
        moment = 0.1 * mass
        out.append(
            Body(
                f"object_{i}", False, mass,
                ((moment, 0.0, 0.0), (0.0, moment, 0.0), (0.0, 0.0, moment)), (shape,),
                (1.5 * i, 0.0, height), origin_offset=(0.0, 0.0, -height), half_extents=half,
            )
        )  # fmt: skip
    speed = float(rng.uniform(2.0, 6.0))
    program = Program(
        (
            HoldVelocity("object_0", 0.0, math.inf, speed, 0.0, until_contact=("object_1",)),
            AdjustProperties("object_0", 1.0, linear_damping=2.0),
            SetVelocity(f"object_{bodies - 1}", 1.5, (0.0, 1.0, 2.0)),
        ),
        3.0,
    )
    watch = (WatchedEvent("hit", ("object_0",), ("object_1",)),)
    return SimScene(f"bench {seed}", tuple(out)), program, watch


def measure(step: str, classes: int, work: Callable[[], object]) -> Measurement:
    """Runs `work` once."""
    wall, cpu = time.perf_counter(), _cpu()
    work()
    wall, cpu = time.perf_counter() - wall, _cpu() - cpu
    return Measurement(step, wall, cpu, 60.0 * classes / wall, cpu / classes)


def _cpu() -> float:
    kinds = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(u.ru_utime + u.ru_stime for u in map(resource.getrusage, kinds))


def run(classes: int, bodies: int, jobs: int) -> list[Measurement]:
    """All measurements, on caches of their own."""
    out: list[Measurement] = []
    few = min(classes, 8)
    with tempfile.TemporaryDirectory() as work:
        root = Path(work)
        cases = [scene(i, bodies) for i in range(classes)]
        folders = [root / "scenes" / str(i) for i in range(classes)]

        def emit() -> None:
            for (world, program, watch), folder in zip(cases, folders, strict=True):
                write_class(emit_class(world, program, watch=watch), folder)

        def compile_all(files: list) -> None:
            wrong = [r for r in compile_many(files, jobs) if not isinstance(r, Library)]
            if wrong:
                raise SystemExit(f"{len(wrong)} classes do not compile: {wrong[0]}")

        def replay() -> None:
            for folder in folders:
                replay_class(folder)

        out.append(measure("emit", classes, emit))
        files = read_classes(folders)
        before = os.environ.get("ESG_CACHE_DIR")
        try:
            os.environ["ESG_CACHE_DIR"] = str(root / "single")
            out.append(measure("first class, empty cache", 1, lambda: compile_all(files[:1])))
            single = files[1 : few + 1]
            step = measure("one by one", len(single), lambda: [compile_all([f]) for f in single])
            out.append(step)
            os.environ["ESG_CACHE_DIR"] = str(root / "batch")
            out.append(measure("batch, empty cache", classes, lambda: compile_all(files)))
            out.append(measure("batch, cached", classes, lambda: compile_all(files)))
            out.append(measure("replay at 240 Hz, 3 s", classes, replay))
        finally:
            if before is None:
                os.environ.pop("ESG_CACHE_DIR", None)
            else:
                os.environ["ESG_CACHE_DIR"] = before
    return out


def check_suite(run: Path, out: Path | None) -> None:
    """Class and exports of the finished scenes below a folder."""
    from benchmarks.compile.exports import as_json, check_scenes, text

    result = check_scenes(run)
    print(text(result))
    if out:
        out.write_text(as_json(result), "utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.compile", description=__doc__.splitlines()[0]
    )
    parser.add_argument("--classes", type=int, default=64)
    parser.add_argument("--bodies", type=int, default=8)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--suite", type=Path, metavar="RUN", help="check these scenes instead")
    options = parser.parse_args()
    if options.suite is not None:
        check_suite(options.suite, options.json)
        return
    if min(options.classes, options.jobs) < 1 or options.bodies < 2:
        parser.error("need at least one class, one job and two bodies")
    results = run(options.classes, options.bodies, options.jobs)
    print(f"{options.classes} classes of {options.bodies} bodies, {options.jobs} jobs")
    print(f"{'step':<26}{'wall s':>9}{'cpu s':>9}{'per minute':>12}{'cpu s each':>12}")
    for m in results:
        print(f"{m.step:<26}{m.wall_s:>9.2f}{m.cpu_s:>9.2f}{m.classes_per_minute:>12.0f}"
              f"{m.cpu_s_per_class:>12.3f}")  # fmt: skip
    if options.json:
        facts = {"options": {k: v for k, v in vars(options).items() if k != "json"}}
        data = facts | {"measurements": [asdict(m) for m in results]}
        options.json.write_text(json.dumps(data, indent=2) + "\n", "utf-8")


if __name__ == "__main__":
    main()
