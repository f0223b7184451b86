"""`esg judge`: anybody's motion before the judge of the benchmark."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.judging.verdict import Judged
    from esg.metrics.models import SuiteScene


def judge(
    *,
    trajectories: Annotated[list[Path], Parameter(consume_multiple=True, negative="")],
    suite: Path,
    scene: str | None = None,
    names: Path | None = None,
    frame: Literal["z-up", "y-up", "unreal"] = "z-up",
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Judge trajectories by a suite: one file, or all runs of a system (docs/judging.md).

    Contacts and velocities that a file does not hold are recomputed from shapes and poses; what
    was is told. Of several files a report like that of `esg bench` is made.

    Args:
        trajectories: CSV, Parquet, NPZ, MCAP, GLB, USD or Kubric's metadata.json; several are runs.
        suite: Suite (file, or name of one that comes with the package: paper).
        scene: Id of its scene; default what the name of each file or of its folder says (S6.glb,
            S6-run2.csv, S6-run2/scene.usda).
        names: JSON or CSV file with words for bodies of the file, by name.
        frame: Axes and units of CSV, Parquet and NPZ: z-up (metres), y-up (metres) or unreal
            (left-handed, Z up, centimetres).
        json: Print one JSON document: the verdict, or the report.
    """
    from esg.api.inputs import checked, existing_file
    from esg.api.judging import load_names
    from esg.commands.console import emit
    from esg.judging.verdict import judge_file, runs_of, scene_for
    from esg.metrics import load_suite
    from esg.outcomes import UserError

    if not trajectories:
        raise UserError("--trajectories: name one file or more")
    loaded, words, *paths = checked(
        lambda: load_suite(suite),
        lambda: {} if names is None else load_names(names),
        *(lambda p=p: existing_file(p, "trajectories") for p in trajectories),
    )
    scenes: list[SuiteScene] = checked(*(lambda p=p: scene_for(p, loaded, scene) for p in paths))
    judged: list[Judged] = checked(
        *(
            lambda p=p, s=s: judge_file(p, s, frame=frame, names=words)
            for p, s in zip(paths, scenes, strict=True)
        )
    )
    if len(judged) == 1:
        result = judged[0].to_json()
        if json:
            emit(result)
        else:
            print(verdict_table(result))
        return 0 if result["verified"] else 3
    report = runs_of(loaded, list(zip(scenes, judged, strict=True)))
    if json:
        emit(report)
    else:
        _tell(report, judged)
    whole = all(outcome == "solved" for s in report["scenes"] for outcome in s["outcome"])
    return 0 if whole else 3


def verdict_table(result: dict[str, Any]) -> str:
    """What the judge says of one file, for people."""
    from esg.commands.comparing.verdicts import completed, event_rows
    from esg.commands.console import table

    verdict = result["verdict"]
    rows = event_rows(verdict)
    rows += [
        [
            "kept" if said["kept"] else "NOT KEPT",
            said["id"],
            said["says"],
            "",
            "",
            said["reason"],
        ]
        for said in verdict["statements"]
    ]
    rows += [
        [f"{100 * c['score']:.0f}%", "", c["quantity"], c["constraint"], _value(c), c["reason"]]
        for c in verdict["constraints"]
    ]
    head = (
        f"{result['file']}: {result['format']}, {result['frames_per_second']:.0f} frames a second, "
        f"judged against {result['suite_scene']}"
    )
    faults = verdict["layout"]
    lines = [f"layout: {problem}" for problem in faults["missing"]]
    lines += [
        f"layout: {o['a']} and {o['b']} overlap by {o['depth_m']:.3f} m" for o in faults["overlaps"]
    ]
    lines += [f"layout: {name} hangs in the air" for name in faults["hanging"]]
    lines += [f"note: {note}" for note in result["notes"]]
    columns = ["", "id", "what", "bodies", "value", "reason"]
    return "\n".join([table(columns, rows, head), completed(verdict), *lines])


def _value(constraint: dict[str, Any]) -> str:
    measured = constraint["measured"]
    return "" if measured is None else f"{measured:.3g} {constraint['unit']}"


def _tell(report: dict[str, Any], judged: list[Judged]) -> None:
    from esg.judging.verdict import NO_FILE
    from esg.metrics import comparison_table

    print(comparison_table(report, ours="Judged"), end="")
    files = len(judged)
    lacking = sum(outcome == NO_FILE for s in report["scenes"] for outcome in s["outcome"])
    if lacking:
        print(f"{files} files; {lacking} runs have none and count as failed")
    for note in dict.fromkeys(note for one in judged for note in one.notes):
        count = sum(note in one.notes for one in judged)
        print(f"note  {count} of {files}: {note}")
