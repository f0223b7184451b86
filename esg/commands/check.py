"""`esg check`: an ESG file against the schema and all rules, a scene folder against its list, the
clips of a dataset against geometry."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter


def check(
    file: Path, *, scenes: int = 20, json: Annotated[bool, Parameter(negative="")] = False
) -> int:
    """Check an ESG file, whether a scene folder is as it was written, or a dataset's ground truth.

    Of a file every violation is listed with its place and remedy; of a folder what differs from
    its SHA256SUMS, and whether its class is what this version emits; of a dataset how its clips
    (flow, boxes, tracks, coordinates) and contacts stand against geometry.

    Args:
        file: The JSON file, such as the esg.json of a scene folder, a scene folder, or a dataset.
        scenes: Of a dataset: how many are checked at most, drawn by their keys; 0 for all.
        json: Print one JSON document: path, ok, counts, violations.
    """
    from esg.commands.console import emit
    from esg.graph import check_file
    from esg.scenefolder import is_scene_folder

    if is_dataset(file):
        told = truth_facts(file, scenes)
        if json:
            emit(told)
        else:
            print(truth_text(told))
        return 0 if told["ok"] else 1
    if is_scene_folder(file):
        found = folder_facts(file)
        if json:
            emit(found)
        else:
            print(folder_text(found))
        return 0 if found["ok"] else 1
    report = check_file(file)
    if json:
        emit(report.to_json())
    else:
        print(report.text())
    return report.exit_code


def folder_facts(folder: Path) -> dict[str, Any]:
    """Whether a scene folder may be opened, is as it was written, and whose class it holds.

    Args:
        folder: Scene folder.
    """
    from dataclasses import asdict

    from esg.compile.replay import standing_in
    from esg.files import sha256_of
    from esg.scenefolder.unfinished import settled
    from esg.strangers.folders import oddity
    from esg.strangers.sums import SUMS, differences

    wrong = oddity(folder)
    lacking = "" if wrong else settled(folder)
    found = None if wrong else differences(folder)
    standing, why = ("", "") if wrong else standing_in(folder)
    listed = found is not None
    problem = wrong or lacking or ("" if found is None else found.problem)
    return {
        "path": str(folder),
        "ok": not problem and standing != "foreign",
        "problem": problem,
        "listed": listed,
        "list_sha256": sha256_of(folder / SUMS) if listed and not found.wrong else "",
        **({} if found is None else asdict(found)),
        "class": standing,
        "class_note": why,
    }


def folder_text(found: dict[str, Any]) -> str:
    """What `folder_facts` found, in lines."""
    lines = [f"{found['path']}: {'as it was written' if found['ok'] else 'NOT as it was written'}"]
    if found["problem"]:
        lines.append(f"  {found['problem']}")
    for what in ("changed", "missing", "added"):
        lines += [f"  {what}: {name}" for name in found.get(what, ())]
    if found["list_sha256"]:
        lines.append(f"  SHA256SUMS: {found['list_sha256']}")
    elif not found["listed"]:
        lines.append("  no SHA256SUMS: whether files have changed cannot be told")
    told = {
        "own": "what this version emits",
        "equal": "what this version emits",
        "foreign": f"not run without --trust: {found['class_note']}",
        "": "none",
    }
    return "\n".join([*lines, f"  class: {told[found['class']]}"])


def is_dataset(folder: Path) -> bool:
    """Whether a dataset was begun in a folder."""
    return (folder / "meta" / "plan.json").is_file()


def truth_facts(folder: Path, scenes: int) -> dict[str, Any]:
    """How the clips of a dataset stand against geometry.

    Args:
        folder: Of the dataset, finished or not.
        scenes: How many are checked at most; 0 for all.

    Raises:
        UserError: If it has no clips, or the number is negative.
    """
    from esg.commands.console import progress
    from esg.dataset.card.facts.clips import summaries
    from esg.dataset.crosscheck import check_dataset
    from esg.outcomes import UserError

    if scenes < 0:
        raise UserError(f"--scenes {scenes}: choose how many, or 0 for all")
    rows: list[dict[str, Any]] = []
    seen: set[str] = set()
    with progress(scenes or 1, "checking") as bar:
        for row in check_dataset(folder, most=scenes or None):
            rows.append(row)
            if row["scene_key"] not in seen:
                seen.add(row["scene_key"])
                bar.show(row["scene_id"])
    if not rows:
        raise UserError(f"{folder} holds no clips to check; render some: esg render {folder}")
    wrong = [r for r in rows if r["ok"] is False]
    return {
        "path": str(folder),
        "ok": not wrong,
        "scenes": len(seen),
        "checks": summaries(rows),
        "failing": [
            {k: r[k] for k in ("scene_id", "camera", "check_name", "p99", "limit_value", "note")}
            for r in wrong
        ],
    }


def truth_text(found: dict[str, Any]) -> str:
    """What `truth_facts` found, in lines."""
    lines = [
        f"{found['path']}: ground truth of {found['scenes']} scenes "
        f"{'agrees' if found['ok'] else 'DOES NOT AGREE'} with geometry",
        f"  {'check':<20}{'samples':>10}{'median 99%':>12}{'highest 99%':>13}{'limit':>14}",
    ]
    for name, c in found["checks"].items():
        p99, high = ("" if c[k] is None else f"{c[k]:.2g}" for k in ("p99", "highest_p99"))
        limit = f"{c['limit']:g} {c['unit']}"
        lines.append(f"  {name:<20}{c['samples']:>10}{p99:>12}{high:>13}{limit:>14}")
    lines += [
        f"  fails: {r['scene_id']} camera {r['camera']} {r['check_name']}: {r['note']}"
        for r in found["failing"]
    ]
    return "\n".join(lines)
