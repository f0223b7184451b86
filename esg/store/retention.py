"""Forgetting old runs: from the database and with their Parquet parts, so a rebuild agrees."""

from __future__ import annotations

from collections.abc import Sequence
import contextlib
from dataclasses import dataclass
import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from esg.store.db import apply_migrations, must_exist, query, writing
from esg.store.tables import TABLES

if TYPE_CHECKING:
    from duckdb import DuckDBPyConnection


@dataclass(frozen=True)
class Pruned:
    """What was forgotten.

    Args:
        runs: Ids of the runs.
        kept_as_standard: Old runs that newer ones are still compared with.
        files: Parquet parts that were deleted.
        rows: Rows deleted by table.
    """

    runs: tuple[str, ...]
    kept_as_standard: tuple[str, ...]
    files: int
    rows: dict[str, int]


def prune_runs(
    db: Path,
    keep_days: float,
    *,
    parts: Path | None = None,
    now: datetime.datetime | None = None,
    dry_run: bool = False,
) -> Pruned:
    """Deletes runs that began more than `keep_days` ago.

    A run that is the standard of a younger one (`bench_history.last_good`) stays however old it
    is: forgetting it would forgive every regression since.

    Args:
        db: The database.
        keep_days: Age in days.
        parts: Folder of the runs' Parquet parts (`<table>/<run id>.parquet`); they go too.
        now: Time to compare with; default the clock.
        dry_run: Only say what would go.

    Raises:
        UserError: If there is no database, or it is locked.
    """
    must_exist(db)
    moment = now or datetime.datetime.now(datetime.UTC)
    limit = moment.astimezone(datetime.UTC).replace(tzinfo=None)
    limit -= datetime.timedelta(days=keep_days)
    old = [r[0] for r in query(db, _old(limit)).rows]
    standard = {r[0] for r in query(db, _standards(limit)).rows}
    kept = tuple(r for r in old if r in standard)
    gone = tuple(r for r in old if r not in standard)
    files = _parts_of(parts, gone)
    if dry_run or not gone:
        return Pruned(gone, kept, len(files), {})
    with writing(db) as connection:
        apply_migrations(connection)
        rows = _delete(connection, gone, files)
    for path in files:
        with contextlib.suppress(FileNotFoundError):
            path.unlink()
    return Pruned(gone, kept, len(files), rows)


def _old(limit: datetime.datetime) -> str:
    return f"SELECT run_id FROM runs WHERE started_at < '{limit.isoformat()}' ORDER BY run_id"


def _standards(limit: datetime.datetime) -> str:
    return (
        "SELECT DISTINCT last_good FROM bench_history "
        f"WHERE started_at >= '{limit.isoformat()}' AND last_good IS NOT NULL"
    )


def _parts_of(parts: Path | None, runs: Sequence[str]) -> list[Path]:
    if parts is None:
        return []
    paths = (parts / table / f"{run}.parquet" for run in runs for table in TABLES)
    return [p for p in paths if p.is_file()]


def _delete(
    connection: DuckDBPyConnection, runs: Sequence[str], files: Sequence[Path]
) -> dict[str, int]:
    rows: dict[str, int] = {}
    connection.execute("BEGIN")
    for table in TABLES:
        done = connection.execute(
            f"DELETE FROM {table} WHERE list_contains($runs, run_id)", {"runs": list(runs)}
        ).fetchone()
        rows[table] = int(done[0]) if done else 0
    connection.execute(
        "DELETE FROM ingested WHERE list_contains($files, file)",
        {"files": [str(p.resolve()) for p in files]},
    )
    connection.execute("COMMIT")
    return rows
