"""Parquet into the results database: upsert by key, all files or none."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
import contextlib
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

from esg.files import final_names
from esg.outcomes import UserError
from esg.store.columns import MEDIA
from esg.store.db import apply_migrations, first_line, writing
from esg.store.shapes import SHAPED, as_json_sql
from esg.store.tables import (
    ADDED_COLUMNS,
    COLUMNS,
    KEYS,
    format_of,
    part_files,
    read_table,
    table_of,
)
from esg.workers import usable_cores

if TYPE_CHECKING:
    from duckdb import DuckDBPyConnection

_IN_PARQUET = {
    "trajectories": {n for n, k in COLUMNS["trajectories"].items() if k.startswith("list<")}
    - {"bodies"},
    "scenes": {"expectation", "manifest", "preview"},
    "meshes": {"gltf"},
    "clips": {n for n, k in COLUMNS["clips"].items() if "<" in k or k in MEDIA} - {"channels"},
}
"""Columns too heavy for the database: they stay in the Parquet files."""

_WITH_PROMPT = {"scenes", "clips"}
"""Tables that have the prompt in the database too; all have it in Parquet."""


@dataclass(frozen=True)
class IngestReport:
    """What an ingest did.

    Args:
        files: Files read.
        unchanged: Files skipped because they had been ingested as they are.
        rows: Rows upserted by table.
    """

    files: int
    unchanged: int
    rows: dict[str, int]


def ingest(db: Path, paths: Iterable[Path], *, force: bool = False) -> IngestReport:
    """Upserts Parquet files into the database by the keys of their tables.

    All files or none: a damaged file leaves the database as it was. Later files win where keys
    repeat. A file that was ingested before and has not changed is skipped.

    Args:
        db: The database; created if missing.
        paths: Parquet files, or folders of parts (`write_tables`) or of a dataset.
        force: Read unchanged files too.

    Raises:
        UserError: Naming every damaged file, or that the database is locked.
    """
    files = expand(paths)
    kinds = _tables_of(files)
    with writing(Path(db)) as connection:
        apply_migrations(connection)
        return _ingest(connection, files, kinds, force)


def rebuild(db: Path, folder: Path | Sequence[Path]) -> IngestReport:
    """Drops the database and makes it anew from Parquet. The old one stays until the new is whole.

    Raises:
        UserError: If a file is damaged or there is none.
    """
    folders = [folder] if isinstance(folder, str | Path) else list(folder)
    files = expand(folders)
    if not files:
        raise UserError(f"no Parquet tables below {', '.join(map(str, folders))}; check the path")
    kinds = _tables_of(files)
    with writing(Path(db), fresh=True) as connection:
        apply_migrations(connection)
        return _ingest(connection, files, kinds, force=True)


def expand(paths: Iterable[Path]) -> list[Path]:
    """Files among `paths`, and the Parquet files below the folders among them.

    Raises:
        UserError: Naming paths that do not exist.
    """
    out: list[Path] = []
    missing: list[str] = []
    for path in map(Path, paths):
        if path.is_dir():
            found = part_files(path) or sorted(
                p for p in path.rglob("*.parquet") if not p.name.startswith(".")
            )
            out += found
        elif path.is_file():
            out.append(path)
        else:
            missing.append(str(path))
    if missing:
        raise UserError(f"{', '.join(missing)}: no such file or folder; check the path")
    return list(dict.fromkeys(p.resolve() for p in out))


def _tables_of(files: Sequence[Path]) -> list[str]:
    kinds: list[str] = []
    problems: list[str] = []
    for file in files:
        try:
            kinds.append(table_of(file))
        except UserError as error:
            problems.append(str(error))
    if problems:
        raise UserError("nothing was ingested:\n" + "\n".join(f"  {p}" for p in problems))
    return kinds


def _ingest(
    connection: DuckDBPyConnection, files: Sequence[Path], kinds: Sequence[str], force: bool
) -> IngestReport:
    import duckdb

    known = {
        row[0]: row[1:]
        for row in connection.execute("SELECT file, size, modified_ns FROM ingested").fetchall()
    }
    wanted: dict[str, list[Path]] = {}
    marks: list[tuple[str, str, int, int]] = []
    for file, table in zip(files, kinds, strict=True):
        facts = file.stat()
        if force or known.get(str(file)) != (facts.st_size, facts.st_mtime_ns):
            wanted.setdefault(table, []).append(file)
            marks.append((str(file), table, facts.st_size, facts.st_mtime_ns))
    rows: dict[str, int] = {}
    damaged = _damaged(wanted)
    if damaged:
        raise UserError("nothing was ingested:\n" + "\n".join(f"  {p}" for p in damaged))
    connection.execute("BEGIN")
    try:
        for table, found in wanted.items():
            alike = groupby(found, key=format_of)
            rows[table] = sum(_upsert(connection, list(g), table, major) for major, g in alike)
        if marks:
            connection.executemany("INSERT OR REPLACE INTO ingested VALUES (?, ?, ?, ?)", marks)
        connection.execute("COMMIT")
    except duckdb.Error as error:
        with contextlib.suppress(duckdb.Error):
            connection.execute("ROLLBACK")
        raise UserError(_blame(wanted, error)) from None
    return IngestReport(len(marks), len(files) - len(marks), rows)


def parquet_only(table: str) -> set[str]:
    """Columns of a table that the database lacks."""
    return _IN_PARQUET.get(table, set()) | (set() if table in _WITH_PROMPT else {"prompt"})


def _upsert(connection: DuckDBPyConnection, files: Sequence[Path], table: str, major: int) -> int:
    """Replaces the rows of all keys that files of one format hold; the last row of a key wins."""
    present = _columns_of(connection, files)
    skipped = parquet_only(table) | set(ADDED_COLUMNS.get(table, ())) - present
    columns = {c: kind for c, kind in COLUMNS[table].items() if c not in skipped}
    read = ", ".join(_read(table, c, kind, major) for c, kind in columns.items())
    names = ", ".join(f'"{c}"' for c in columns)
    if table == "trajectories":
        read, names = f"{read}, filename AS file", f"{names}, file"
    keys = ", ".join(KEYS[table])
    connection.execute(
        f"""
        CREATE OR REPLACE TEMP TABLE staging AS
        SELECT {read}, listed AS file_place, file_row_number AS row_place
        FROM read_parquet(
            $files, filename = true, file_row_number = true, union_by_name = true
        )
        JOIN (
            SELECT unnest($files) AS filename, unnest(range(len($files))) AS listed
        ) USING (filename)
        """,
        {"files": [str(f) for f in files]},
    )
    repeated = connection.execute(
        f"SELECT count(*) FROM (SELECT 1 FROM staging GROUP BY {keys} HAVING count(*) > 1)"
    ).fetchone()
    last = ""
    if repeated and repeated[0]:
        last = (
            f"QUALIFY row_number() OVER (PARTITION BY {keys} "
            "ORDER BY file_place DESC, row_place DESC) = 1"
        )
    same = " AND ".join(f"{table}.{k} = staging.{k}" for k in KEYS[table])
    connection.execute(f"DELETE FROM {table} USING staging WHERE {same}")
    done = connection.execute(
        f"INSERT INTO {table} ({names}) SELECT {names} FROM staging {last}"
    ).fetchone()
    connection.execute("DROP TABLE staging")
    return int(done[0]) if done else 0


def _read(table: str, column: str, kind: str, major: int) -> str:
    """SQL that reads a column as the database keeps it."""
    if kind == "timestamp":
        # The database keeps plain UTC: time zone types need a package that readers may lack.
        return f'timezone(\'UTC\', "{column}") AS "{column}"'
    if major > 1 and (table, column) in SHAPED:
        return f'{as_json_sql(column, kind)} AS "{column}"'
    return f'"{column}"'


def _columns_of(connection: DuckDBPyConnection, files: Sequence[Path]) -> set[str]:
    found = connection.execute(
        "SELECT name FROM parquet_schema($files)", {"files": [str(f) for f in files]}
    )
    return {row[0] for row in found.fetchall()}


def _damaged(files: dict[str, list[Path]]) -> list[str]:
    """What is wrong with files, found by reading each with its checksums, which DuckDB does not."""
    with ThreadPoolExecutor(usable_cores()) as pool:
        found = pool.map(_problem, (f for files_of in files.values() for f in files_of))
        return [problem for problem in found if problem]


def _problem(file: Path) -> str:
    try:
        read_table(file)
    except UserError as problem:
        return str(problem)
    return ""


def _blame(files: dict[str, list[Path]], error: BaseException) -> str:
    """Which files made an ingest fail, found by reading each again."""
    import duckdb

    if isinstance(error, duckdb.OutOfMemoryException):
        return "nothing was ingested: there is not enough memory; free some, then run it again"
    problems = _damaged(files)
    if not problems:
        why = final_names(first_line(error))
        problems = [f"the database is damaged ({why}); rebuild it from Parquet (esg db rebuild)"]
    return "nothing was ingested:\n" + "\n".join(f"  {p}" for p in problems)
