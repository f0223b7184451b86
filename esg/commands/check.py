"""`esg check`: an ESG file against the schema and all rules, a scene folder against its list."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter


def check(file: Path, *, json: Annotated[bool, Parameter(negative="")] = False) -> int:
    """Check an ESG file, or whether a scene folder is as it was written.

    Of a file every violation is listed with its place and remedy; of a folder what differs from
    its SHA256SUMS, and whether its class is what this version emits.

    Args:
        file: The JSON file, such as the esg.json of a scene folder, or a scene folder.
        json: Print one JSON document: path, ok, counts, violations.
    """
    from esg.commands.console import emit
    from esg.graph import check_file
    from esg.scenefolder import is_scene_folder

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
    from esg.strangers.folders import oddity
    from esg.strangers.sums import SUMS, differences

    wrong = oddity(folder)
    found = None if wrong else differences(folder)
    standing, why = ("", "") if wrong else standing_in(folder)
    listed = found is not None
    problem = wrong or ("" if found is None else found.problem)
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
