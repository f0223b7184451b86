"""`esg sql`: questions to the run database."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def sql(
    query: str,
    *,
    db: Path = Path("runs/esg.duckdb"),
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Query the results of all runs, read-only.

    Args:
        query: One SQL statement (DuckDB).
        db: The run database.
        json: Print one JSON document: columns and rows.
    """
    from esg.commands.console import emit, table
    from esg.store import query as run

    columns, rows = run(db, query)
    if json:
        emit({"columns": columns, "rows": rows})
    else:
        print(table(columns, [["" if v is None else _cell(v) for v in row] for row in rows]))
    return 0


def _cell(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
