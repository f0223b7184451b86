"""Scene Language on our bench: programs through the paper's adapter, our class and our judge.

    python -m benchmarks.rivals.scene_language [--programs DIR] [--json FILE] [--scenes S1,S7]

A program is `programs/SCENE-SAMPLE.py`; one that fails, or is not there, is a run that failed.
"""

from __future__ import annotations

import argparse
from pathlib import Path
import tempfile
from typing import Any

from benchmarks.rivals.scene_language.adapter import ProgramFailed, run_program, scene_of
from benchmarks.rivals.scene_language.requests import SAMPLES
from esg.compile import emit_class, replay_class
from esg.compile.scene import write_class
from esg.engines.base import VERIFY_DT_S
from esg.files import write_json
from esg.metrics import SceneRun, bench_json, comparison_table, judge, load_suite
from esg.metrics.models import Suite, SuiteScene

PROGRAMS = Path(__file__).parent / "programs"


def judged(path: Path, scene: SuiteScene, folder: Path) -> tuple[SceneRun, str]:
    """One program, compiled, replayed and judged; and why it failed if it did.

    Args:
        path: Of the program.
        scene: What must happen.
        folder: For the class.
    """
    sample = int(path.stem.rpartition("-")[2])
    if not path.is_file():
        return SceneRun(sample, None, "no program", 0.0), "there is no program"
    try:
        physical, program = scene_of(run_program(path.read_text("utf-8")), path.stem)
        folder.mkdir(parents=True)
        write_class(emit_class(physical, program), folder)
        rollout = replay_class(folder, dt=VERIFY_DT_S).rollout
    except (ProgramFailed, ValueError) as error:
        return SceneRun(sample, None, "crashed", 0.0), str(error)
    verdict = judge(physical, program, rollout, scene)
    faults = [e.reason for e in verdict.events if not e.completed][:1] + list(verdict.layout.faults)
    outcome = "solved" if verdict.verified else "not_converged"
    return SceneRun(sample, verdict, outcome, 0.0), "; ".join(faults)


def report(suite: Suite, programs: Path, samples: int) -> tuple[dict[str, Any], list[str]]:
    """The report of `esg bench` over programs, and a line for what failed.

    Args:
        suite: The suite.
        programs: Folder of the programs.
        samples: A scene.
    """
    runs: dict[str, list[SceneRun]] = {}
    lines: list[str] = []
    with tempfile.TemporaryDirectory() as work:
        for scene in suite.scenes:
            for sample in range(samples):
                path = programs / f"{scene.id}-{sample}.py"
                run, why = judged(path, scene, Path(work) / path.stem)
                runs.setdefault(scene.id, []).append(run)
                lines += [f"{path.stem}: {why}"] if why else []
    made = bench_json(suite, runs, strategy="scene language", engine="physx", dt=VERIFY_DT_S)
    return made, lines


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=Path, default=PROGRAMS)
    parser.add_argument("--suite", default="paper")
    parser.add_argument("--scenes", default="")
    parser.add_argument("--samples", type=int, default=SAMPLES)
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    suite = load_suite(args.suite)
    wanted = [name for name in args.scenes.split(",") if name]
    if wanted:
        left = tuple(s for s in suite.scenes if s.id in wanted)
        suite = suite.model_copy(update={"scenes": left})
    made, lines = report(suite, args.programs, args.samples)
    print(comparison_table(made, ours="Scene Language, here"), end="")
    print("".join(f"{line}\n" for line in lines), end="")
    if args.json is not None:
        write_json(args.json, made | {"failed": lines})


if __name__ == "__main__":
    main()
