"""`esg sql`: questions to the run database."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def sql(
    query: str,
    *,
    db: Path | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Query the results of all runs, read-only.

    ESG_SQL_SECONDS (30) and ESG_SQL_GIB (2) limit its time and memory; 0 sets no limit.

    Args:
        query: One SQL statement (DuckDB).
        db: The run database; default $ESG_DB or runs/esg.duckdb.
        json: Print one JSON document: columns and rows.
    """
    from esg.commands.console import emit, table
    from esg.runs import database_path
    from esg.settings import SQL_GIB, SQL_S
    from esg.store import query as run

    result = run(
        database_path() if db is None else db,
        query,
        timeout_s=SQL_S.value,
        memory_gib=SQL_GIB.value,
    )
    if json:
        rows = [[_plain(v) for v in row] for row in result.rows]
        emit({"columns": list(result.columns), "rows": rows, "truncated": result.truncated})
        return 0
    print(table(list(result.columns), [[_cell(v) for v in row] for row in result.rows]))
    if result.truncated:
        print(f"only the first {len(result.rows)} rows; add LIMIT or aggregate")
    return 0


def _plain(value: object) -> object:
    """A JSON value: what JSON lacks (dates, decimals, NaN) as text or null."""
    if value is None or isinstance(value, bool | int | str):
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    if isinstance(value, dict):
        return {str(k): _plain(v) for k, v in value.items()}
    return str(value)


def _cell(value: object) -> str:
    if value is None:
        return ""
    return f"{value:.4g}" if isinstance(value, float) else str(value)
