"""Parquet into the results database: upsert by key, all files or none."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
import contextlib
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.files import final_names
from esg.outcomes import UserError
from esg.store.columns import MEDIA
from esg.store.db import apply_migrations, first_line, writing
from esg.store.shapes import SHAPED, as_json_sql, upgraded
from esg.store.tables import COLUMNS, KEYS, format_of, part_files, sound_table, table_of
from esg.workers import usable_cores

if TYPE_CHECKING:
    from duckdb import DuckDBPyConnection
    import pyarrow as pa

_PORTION_BYTES = 256 * 2**20
"""Rows of many small files go into the database together, up to so much memory."""
_INCOMING = "incoming"
Files = Sequence[tuple[Path, str]]
"""With the table that each holds."""

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
    changed = [(file, table) for table, found in wanted.items() for file in found]
    connection.execute("BEGIN")
    try:
        rows = _insert_all(connection, changed)
        _note(connection, marks)
        connection.execute("COMMIT")
    except UserError:
        _roll_back(connection)
        raise
    except duckdb.Error as error:
        _roll_back(connection)
        raise UserError(_blame(changed, error)) from None
    return IngestReport(len(marks), len(files) - len(marks), rows)


def _roll_back(connection: DuckDBPyConnection) -> None:
    import duckdb

    with contextlib.suppress(duckdb.Error):
        connection.execute("ROLLBACK")


def _note(connection: DuckDBPyConnection, marks: Sequence[tuple[str, str, int, int]]) -> None:
    """Notes what has been ingested, all at once: file by file it took a twentieth of the time."""
    if marks:
        connection.execute(
            "INSERT OR REPLACE INTO ingested SELECT unnest($1), unnest($2), unnest($3), unnest($4)",
            [list(column) for column in zip(*marks, strict=True)],
        )


def _insert_all(connection: DuckDBPyConnection, files: Files) -> dict[str, int]:
    """Rows of all files, by table; every file is read once, with its checksums, beside DuckDB.

    Raises:
        UserError: Naming every damaged file.
    """
    damaged: list[str] = []
    before: dict[str, int] = {}
    for portion in _portions(files, damaged):
        if damaged:
            continue  # nothing will be kept: only what else is damaged is still of interest
        if portion.table not in before:
            before[portion.table] = _last_row(connection, portion.table)
        _insert(connection, portion)
    if damaged:
        raise UserError("nothing was ingested:\n" + "\n".join(f"  {p}" for p in damaged))
    return {table: _keep_last(connection, table, row) for table, row in before.items()}


def parquet_only(table: str) -> set[str]:
    """Columns of a table that the database lacks."""
    return _IN_PARQUET.get(table, set()) | (set() if table in _WITH_PROMPT else {"prompt"})


@dataclass(frozen=True)
class _Portion:
    """Rows that go into the database together.

    Args:
        table: Of all of them.
        major: Of the format of their files.
        data: The columns that the database keeps.
    """

    table: str
    major: int
    data: pa.Table

    def like(self, other: _Portion) -> bool:
        """Whether both fit into one."""
        alike = (self.table, self.major) == (other.table, other.major)
        return alike and self.data.schema.equals(other.data.schema)


def _portions(files: Files, damaged: list[str]) -> Iterator[_Portion]:
    """Rows of files in their order, many small ones together.

    Args:
        files: Those of one table together.
        damaged: What is wrong with files that are left out is added.
    """
    parts: list[_Portion] = []
    for found in _read_ahead(files):
        if isinstance(found, str):
            damaged.append(found)
            continue
        size = sum(p.data.nbytes for p in parts) + found.data.nbytes
        if parts and (size > _PORTION_BYTES or not parts[0].like(found)):
            yield _joined(parts)
            parts = []
        parts.append(found)
    if parts:
        yield _joined(parts)


def _joined(parts: Sequence[_Portion]) -> _Portion:
    import pyarrow as pa

    return replace(parts[0], data=pa.concat_tables([p.data for p in parts]))


def _read_ahead(files: Files) -> Iterator[_Portion | str]:
    """What every file holds, or what is wrong with it; as many are read at a time as fill cores."""
    cores = usable_cores()
    with ThreadPoolExecutor(cores) as pool:
        waiting: deque[Future[_Portion | str]] = deque()
        for file, table in files:
            waiting.append(pool.submit(_portion, file, table))
            if len(waiting) > 2 * cores:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()


def _portion(file: Path, table: str) -> _Portion | str:
    """What the database keeps of a file, or what is wrong with it."""
    import pyarrow as pa

    try:
        data = sound_table(file, table)
        major = format_of(data)
        skipped = parquet_only(table)
        if major == 1:
            upgraded(table, data, COLUMNS[table])  # its texts are read as JSON, or tell
        kept = [c for c in COLUMNS[table] if c in data.column_names and c not in skipped]
        data = data.select(kept).replace_schema_metadata(None)
        if table == "trajectories":
            data = data.append_column("file", pa.repeat(str(file), data.num_rows))
    except UserError as problem:
        return str(problem)
    except ValueError as error:
        return f"{file} is damaged ({first_line(error)}); delete it and run again"
    return _Portion(table, major, data)


def _insert(connection: DuckDBPyConnection, portion: _Portion) -> None:
    """Adds rows, whether there are others with their keys or not."""
    table, names = portion.table, portion.data.column_names
    read = ", ".join(_read(table, name, portion.major) for name in names)
    into = ", ".join(f'"{name}"' for name in names)
    connection.register(_INCOMING, portion.data)
    try:
        sql = f"INSERT INTO {table} ({into}) SELECT {read} FROM {_INCOMING}"
        connection.execute(sql).fetchall()
    finally:
        connection.unregister(_INCOMING)


def _last_row(connection: DuckDBPyConnection, table: str) -> int:
    """Place of a table's last row: those that are added come after it, in the order of adding."""
    return int(_values(connection, f"SELECT coalesce(max(rowid), -1) FROM {table}")[0])


def _values(connection: DuckDBPyConnection, sql: str) -> tuple[Any, ...]:
    """The only row of an answer, to its end, before which the connection is not free."""
    (row,) = connection.execute(sql).fetchall()
    return row


def _keep_last(connection: DuckDBPyConnection, table: str, before: int) -> int:
    """Of rows with the same key leaves the last; returns how many stay of those that were added.

    Args:
        connection: In the transaction that added them.
        table: The table.
        before: Place of the last row that was there before.
    """
    keys = ", ".join(KEYS[table])
    added = f"FROM {table} WHERE rowid > {before}"

    # Hashes take a tenth of the memory of keys; two that are equal by chance cost time only.
    counted = f"SELECT count(*), count(DISTINCT hash({keys})) {added}"
    rows, different = _values(connection, counted)
    if rows != different:
        last = f"SELECT max(rowid) {added} GROUP BY {keys}"
        connection.execute(f"DELETE {added} AND rowid NOT IN ({last})")
        rows, _ = _values(connection, counted)
    if before >= 0:
        same = " AND ".join(f"{table}.{k} = added.{k}" for k in KEYS[table])
        connection.execute(
            f"DELETE FROM {table} USING (SELECT {keys} {added}) AS added "
            f"WHERE {table}.rowid <= {before} AND {same}"
        )
    return rows


def _read(table: str, column: str, major: int) -> str:
    """SQL that reads a column as the database keeps it."""
    kind = COLUMNS[table].get(column, "")
    if kind == "timestamp":
        # The database keeps plain UTC: time zone types need a package that readers may lack.
        return f'timezone(\'UTC\', "{column}") AS "{column}"'
    if major > 1 and (table, column) in SHAPED:
        return f'{as_json_sql(column, kind)} AS "{column}"'
    return f'"{column}"'


def _blame(files: Files, error: BaseException) -> str:
    """Which files made an ingest fail, found by reading each again."""
    import duckdb

    if isinstance(error, duckdb.OutOfMemoryException):
        return "nothing was ingested: there is not enough memory; free some, then run it again"
    problems = [p for p in _read_ahead(files) if isinstance(p, str)]
    if not problems:
        why = final_names(first_line(error))
        problems = [f"the database is damaged ({why}); rebuild it from Parquet (esg db rebuild)"]
    return "nothing was ingested:\n" + "\n".join(f"  {p}" for p in problems)
