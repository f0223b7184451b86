"""`esg sql`: questions to the run database."""

from __future__ import annotations

from collections.abc import Callable
import csv
import io
import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.store.db import QueryResult

Form = Literal["csv", "parquet", "md"]


def sql(
    query: str,
    *,
    db: Path | None = None,
    to: Form | None = None,
    out: Path | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Query the results of all runs, read-only.

    ESG_SQL_SECONDS (30) and ESG_SQL_GIB (2) limit its time and memory; 0 sets no limit.

    Args:
        query: One SQL statement (DuckDB).
        db: The run database; default $ESG_DB or runs/esg.duckdb.
        to: Write the rows as csv, parquet or md (a Markdown table) instead of a table.
        out: File to write them to; default the output, which parquet cannot go to.
        json: Print one JSON document: columns and rows.
    """
    from esg.api.inputs import check_target, checked
    from esg.commands.console import emit, table
    from esg.files import atomic_write, refused
    from esg.runs import database_path
    from esg.settings import SQL_GIB, SQL_S
    from esg.store import query as run

    form, _ = checked(
        lambda: _form(to, out, json),
        lambda: None if out is None else check_target("--out", out, "a file"),
    )
    result = run(
        database_path() if db is None else db,
        query,
        timeout_s=SQL_S.value,
        memory_gib=SQL_GIB.value,
    )
    if form is not None:
        if out is None:
            print(_TEXTS[form](result), end="")
        else:
            with refused(out):
                out.parent.mkdir(parents=True, exist_ok=True)
                atomic_write(out, lambda partial: _save(form, result, partial))
        _say_truncated(result)
        return 0
    if json:
        rows = [[_plain(v) for v in row] for row in result.rows]
        emit({"columns": list(result.columns), "rows": rows, "truncated": result.truncated})
        return 0
    print(table(list(result.columns), [[_cell(v) for v in row] for row in result.rows]))
    if result.truncated:
        print(f"only the first {len(result.rows)} rows; add LIMIT or aggregate")
    return 0


def _form(to: Form | None, out: Path | None, json: bool) -> Form | None:
    """How rows are written, by what was asked for; None for a table or JSON.

    Raises:
        UserError: If the options contradict each other.
    """
    from esg.outcomes import UserError

    if to is None and out is not None:
        raise UserError("--out needs --to csv, parquet or md")
    if to is not None and json:
        raise UserError("--json and --to are two forms of one answer; give one of them")
    if to == "parquet" and out is None:
        raise UserError("--to parquet needs --out FILE")
    return to


def _say_truncated(result: QueryResult) -> None:
    from esg.notices import warn

    if result.truncated:
        warn([f"only the first {len(result.rows)} rows; add LIMIT or aggregate"])


def _save(form: Form, result: QueryResult, path: Path) -> None:
    if form != "parquet":
        path.write_text(_TEXTS[form](result), encoding="utf-8")
        return
    import pyarrow as pa
    import pyarrow.parquet as pq

    columns = list(zip(*result.rows, strict=True)) or [()] * len(result.columns)
    # Names may repeat: `SELECT a.id, b.id`.
    pq.write_table(pa.table([pa.array(c) for c in columns], names=list(result.columns)), path)


def _csv(result: QueryResult) -> str:
    """Rows with commas between values; none is an empty field."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(result.columns)
    writer.writerows(["" if v is None else _plain(v) for v in row] for row in result.rows)
    return text.getvalue()


def _markdown(result: QueryResult) -> str:
    """A table as GitHub draws it."""
    rows = [result.columns, ["---"] * len(result.columns)]
    rows += [[_cell(v) for v in row] for row in result.rows]
    escaped = ([c.replace("|", "\\|").replace("\n", " ") for c in row] for row in rows)
    return "".join(f"| {' | '.join(row)} |\n" for row in escaped)


_TEXTS: dict[str, Callable[[QueryResult], str]] = {"csv": _csv, "md": _markdown}
"""Forms that are text."""


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
