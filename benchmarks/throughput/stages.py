"""Core-milliseconds a scene by what they go to, here and in another checkout.

    python -m benchmarks.throughput.stages [--against CHECKOUT] [--scenes 96] [--batch 16]
        [--strategy batched] [--turns 1] [--keep FOLDER]

Each checkout makes the same sampled dataset in one process, one thread and no scheduler, as a warm
worker does: a first one of six scenes is not counted, and classes compiled before are not found.
Processor time counts, compilers included. Checkouts take turns; of several turns the least counts.
Tables of both datasets are compared value by value, other files byte by byte, but for times.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
from collections.abc import Callable
import json
import multiprocessing
import os
from pathlib import Path
import subprocess
import sys
import tempfile
import time
from typing import Any

HERE = Path(__file__).resolve().parents[2]
TIMED = frozenset({"seconds", "cached_stages", "artifacts", "started_at", "run_id", "code_version"})
"""Columns that hold times, or sums of code."""


class Spent:
    """Processor time by label; what is called inside another is not the other's."""

    def __init__(self) -> None:
        self.by: dict[str, float] = defaultdict(float)
        self._inside: list[float] = []

    def on(self, module: Any, name: str, label: str | Callable[..., str]) -> None:
        """Counts the calls of a function of a module."""
        function = getattr(module, name)

        def counted(*args: Any, **kwargs: Any) -> Any:
            start = cores()
            self._inside.append(0.0)
            try:
                return function(*args, **kwargs)
            finally:
                whole = cores() - start
                own = label if isinstance(label, str) else label(*args)
                self.by[own] += whole - self._inside.pop()
                if self._inside:
                    self._inside[-1] += whole

        setattr(module, name, counted)


def cores() -> float:
    """Processor time of this process and those that it has waited for [s]."""
    others = os.times()
    return time.process_time() + others.children_user + others.children_system


def inside(out: Path, scenes: int, batch: int, strategy: str, seed: int) -> dict[str, float]:
    """Makes a dataset here; core-milliseconds a scene by label."""
    from benchmarks.throughput.__main__ import make
    from esg.compile import build
    from esg.dataset import batch as batches
    from esg.dataset import running, writing
    from esg.dataset.annotations import rows
    from esg.dataset.plan import DatasetSpec
    from esg.machine.memory import give_back
    from esg.store import records, tables

    with tempfile.TemporaryDirectory() as name:
        build.cache_dir = lambda: Path(name, "classes")
        make(Path(name, "warm"), DatasetSpec(source="sample", n=6, seed=991))
        # As in a worker: what is there after its first batch is not looked through again.
        vars(multiprocessing)["parent_process"] = multiprocessing.current_process
        give_back()
        spent = Spent()
        spent.on(running, "_stage", lambda job, stage, *_: stage)
        spent.on(running, "_compile_together", "C++ compiler")
        spent.on(records, "record_of", "rows")
        spent.on(rows, "annotated", "annotations")
        spent.on(writing, "_meshes", "meshes")
        spent.on(writing, "_recordings", "contact sheets")
        spent.on(tables, "write_tables", "Parquet")
        spent.on(batches, "_marked", "mark")
        spent.on(batches, "give_back", "memory given back")
        start = cores()
        make(out, DatasetSpec(source="sample", n=scenes, seed=seed, batch=batch, strategy=strategy))
        whole = cores() - start
    spent.by["putting together, all else"] = whole - sum(spent.by.values())
    return {label: 1000 * seconds / scenes for label, seconds in spent.by.items()}


def other_values(a: Path, b: Path) -> list[str]:
    """Files that are in one dataset only or differ, tables with their columns; times left out."""
    import pyarrow.parquet as pq

    found = [{p.relative_to(r).as_posix(): p for p in r.rglob("*") if p.is_file()} for r in (a, b)]
    out = sorted(found[0].keys() ^ found[1].keys())
    for name in sorted(found[0].keys() & found[1].keys()):
        one, two = found[0][name], found[1][name]
        if one.read_bytes() == two.read_bytes() or "timings" in name:
            continue
        if one.suffix != ".parquet":
            out.append(name)
            continue
        told = [pq.read_table(path) for path in (one, two)]
        unlike = [c for c in told[0].column_names if not told[0][c].equals(told[1][c])]
        out += [f"{name}: {c}" for c in unlike if c not in TIMED]
    return out


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--against", type=Path, help="another checkout")
    parser.add_argument("--scenes", type=int, default=96)
    parser.add_argument("--batch", type=int, default=16)
    parser.add_argument("--strategy", default="batched")
    parser.add_argument("--seed", type=int, default=5)
    parser.add_argument("--turns", type=int, default=1)
    parser.add_argument("--keep", type=Path, help="keep the datasets here")
    parser.add_argument("--inside", type=Path, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.inside:
        told = inside(args.inside, args.scenes, args.batch, args.strategy, args.seed)
        args.inside.with_suffix(".json").write_text(json.dumps(told))
        return
    roots = [*([args.against] if args.against else []), HERE]
    with tempfile.TemporaryDirectory() as name:
        work = args.keep or Path(name)
        work.mkdir(parents=True, exist_ok=True)
        turns: list[list[dict[str, float]]] = [[] for _ in roots]
        for n in range(args.turns):
            for k, root in enumerate(roots):
                turns[k].append(turn(root, work / f"{k}-{n}", args))
        show([{label: min(t[label] for t in of) for label in of[0]} for of in turns])
        if args.against:
            print("different:", other_values(work / "0-0", work / "1-0") or "nothing")


def turn(root: Path, out: Path, args: argparse.Namespace) -> dict[str, float]:
    """One dataset by one checkout, in a process of its own."""
    own = [f"--{name}={getattr(args, name)}" for name in ("scenes", "batch", "strategy", "seed")]
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "ESG_THREADS": "1"}
    environment["PYTHONPATH"] = str(root)
    command = [sys.executable, str(Path(__file__).resolve()), "--inside", str(out), *own]
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    return json.loads(out.with_suffix(".json").read_text())


def show(columns: list[dict[str, float]]) -> None:
    """Prints a table of core-milliseconds a scene."""
    for label in columns[-1]:
        print(f"| {label} | " + " | ".join(f"{c.get(label, 0.0):.1f}" for c in columns) + " |")
    for name, left_out in (("without search", ("optimize",)), ("all", ())):
        sums = [sum(v for k, v in c.items() if k not in left_out) for c in columns]
        print(f"| **{name}** | " + " | ".join(f"{s:.1f}" for s in sums) + " |")


if __name__ == "__main__":
    main()
