"""`esg check`: an ESG file against the schema and all rules."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def check(file: Path, *, json: Annotated[bool, Parameter(negative="")] = False) -> int:
    """Check an ESG file; lists every violation with its place and remedy.

    Args:
        file: The JSON file, such as the esg.json of a scene folder.
        json: Print one JSON document: path, ok, counts, violations.
    """
    from esg.commands.console import emit
    from esg.graph import check_file

    report = check_file(file)
    if json:
        emit(report.to_json())
    else:
        print(report.text())
    return report.exit_code
