"""Do finished scenes keep their events as USD in NVIDIA's PhysX (`ovphysx`)?

    esg bench data/suites/paper.yaml --runs 1 --out runs/paper
    python -m benchmarks.usd_player runs/paper --suite data/suites/paper.yaml \
        [--python PYTHON] [--json benchmarks/results/usd_paper.json]

Every scene folder below the run is exported, and docs/play_usd.py simulates it twice: as the file
stands, and with its control program. What it records is judged as any replay is. An event needs a
command if one acts before it other than a velocity or an impulse at time 0, which the file holds;
the times are those of the class in PhysX.

`ovphysx` asks for other versions than this package does: PYTHON is the interpreter of a virtual
environment of its own (docs/usd.md).
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
import json
from pathlib import Path
import subprocess
import sys
import tempfile
from typing import Any

from esg.api.scene import document_of, expectation
from esg.commands.console import table
from esg.compile.export import export
from esg.compile.transfer import end_distance, replay_scene
from esg.engines.manifest import load_manifest
from esg.engines.program import ApplyImpulse, Program, SetVelocity
from esg.engines.rollout_file import load_rollout
from esg.metrics import SceneVerdict, Suite, judge, load_suite
from esg.scenefolder import is_scene_folder

PLAYER = Path(__file__).parents[1] / "docs" / "play_usd.py"


@dataclass(frozen=True)
class Played:
    """One scene: its events by id, where they were completed, and how far the end is off [m]."""

    scene: str
    needs_command: dict[str, bool]
    reference: dict[str, bool]
    still: dict[str, bool]
    program: dict[str, bool]
    late_s: dict[str, float | None]
    apart_m: float

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values, to a millisecond and a millimetre."""
        late = {i: None if t is None else round(t, 3) for i, t in self.late_s.items()}
        return vars(self) | {"late_s": late, "apart_m": round(self.apart_m, 3)}


def measure(run: Path, suite: Suite | None, python: str) -> list[Played]:
    """Plays every compiled scene below a folder.

    Args:
        run: Folder of scene folders.
        suite: To judge against; None for each scene's own timeline.
        python: Interpreter that has `ovphysx`.
    """
    folders = sorted(p for p in run.iterdir() if is_scene_folder(p))
    return [play(p, suite, python) for p in folders if (p / "manifest.json").exists()]


def play(folder: Path, suite: Suite | None, python: str) -> Played:
    """Exports, plays and judges one scene.

    Raises:
        RuntimeError: If the player fails, with what it said.
    """
    expected, _ = expectation(folder, document_of(folder), suite)
    manifest = load_manifest(folder / "manifest.json")
    proven, _ = replay_scene(folder, manifest, "physx", manifest.dt)
    reference = judge(manifest.scene, manifest.program, proven, expected)
    verdicts: list[SceneVerdict] = []
    with tempfile.TemporaryDirectory() as out:
        export(folder, "usd", out, rollout=proven)
        for flags in (["--no-program"], []):
            record = Path(out) / "rollout.npz"
            command = [python, PLAYER, f"{out}/scene.usda", "--record", record, *flags]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                raise RuntimeError(f"{folder.name}: {done.stderr[-2000:]}")
            rollout = load_rollout(record)
            verdicts.append(judge(manifest.scene, manifest.program, rollout, expected))
    still, program = verdicts
    when = {e.id: e.time_s for e in reference.events}
    return Played(
        scene=folder.name,
        needs_command={i: needs_command(manifest.program, t, manifest.dt) for i, t in when.items()},
        reference=completed(reference),
        still=completed(still),
        program=completed(program),
        late_s={
            e.id: None if e.time_s is None or when[e.id] is None else e.time_s - when[e.id]
            for e in program.events
        },
        apart_m=end_distance(rollout, proven),
    )


def completed(verdict: SceneVerdict) -> dict[str, bool]:
    """Events by id."""
    return {e.id: e.completed for e in verdict.events}


def needs_command(program: Program, time_s: float | None, dt: float) -> bool:
    """Whether a command that the file's start velocities do not hold acts before a time."""
    for p in program.primitives:
        at_start = isinstance(p, SetVelocity | ApplyImpulse) and p.time <= dt / 2
        if not at_start and (time_s is None or p.time < time_s):
            return True
    return False


def report(scenes: list[Played]) -> str:
    """The table: a row a scene, and the sums."""
    rows: list[list[str]] = []
    for s in scenes:
        free = [i for i, needs in s.needs_command.items() if not needs]
        late = [abs(v) for v in s.late_s.values() if v is not None]
        rows.append(
            [
                s.scene,
                str(sum(s.reference.values())),
                str(len(free)),
                str(sum(s.still[i] for i in free)),
                str(sum(s.still.values())),
                str(sum(s.program.values())),
                f"{1000 * max(late, default=0.0):.0f}",
                f"{s.apart_m:.2f}",
            ]
        )
    sums = [str(sum(int(r[k]) for r in rows)) for k in range(1, 6)]
    rows.append(["total", *sums, "", ""])
    head = ["scene", "class", "need no command", "of these", "as exported", "with program",
            "late ms", "apart m"]  # fmt: skip
    return table(head, rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("run", type=Path)
    parser.add_argument("--suite", type=Path)
    parser.add_argument("--python", default=sys.executable)
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    suite = load_suite(options.suite) if options.suite else None
    scenes = measure(options.run, suite, options.python)
    print(report(scenes))
    if options.json:
        lines = ",\n".join(json.dumps(s.to_json()) for s in scenes)
        options.json.write_text(f'{{"scenes": [\n{lines}\n]}}\n', "utf-8")


if __name__ == "__main__":
    main()
