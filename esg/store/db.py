"""The results database: DuckDB, rebuilt from Parquet at any time, never written by workers.

One writer at a time (a lock file decides) works on a copy and renames it into place. Readers open
whatever is there: they never wait for a writer, and a killed writer leaves the old database. The
schema grows by numbered migrations in `esg/store/sql` (also reachable as `schemas/sql`).
"""

from __future__ import annotations

from collections.abc import Generator, Iterable, Sequence
import contextlib
from dataclasses import dataclass
import errno
import os
from pathlib import Path
import shutil
import tempfile
import threading
import time
from typing import TYPE_CHECKING, Any

from esg.outcomes import UserError
from esg.store.files import explained, sync_file, sync_folder, temporary_name
from esg.store.tables import COLUMNS, KEYS, part_files, read_table, table_of

if TYPE_CHECKING:
    from duckdb import DuckDBPyConnection

SQL_FOLDER = Path(__file__).parent / "sql"
LOCK_WAIT_S = 20.0
_FIRST_WAIT_S = 0.05
_READ_ONLY_STATEMENTS = {"SELECT", "EXPLAIN"}
MAX_ROWS = 1_000_000
_ARRAYS = {name for name, kind in COLUMNS["trajectories"].items() if kind.startswith("list<")}


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


@dataclass(frozen=True)
class QueryResult:
    """Rows of a query.

    Args:
        columns: Column names.
        types: DuckDB type of every column.
        rows: Values; at most the asked number.
        truncated: Whether there were more rows.
    """

    columns: tuple[str, ...]
    types: tuple[str, ...]
    rows: list[tuple[Any, ...]]
    truncated: bool = False

    def dicts(self) -> list[dict[str, Any]]:
        """The rows as dictionaries."""
        return [dict(zip(self.columns, row, strict=True)) for row in self.rows]


def migrations() -> list[tuple[int, str, str]]:
    """Number, name and text of every migration, in order.

    Raises:
        RuntimeError: If numbers are missing or repeated: a packaging defect.
    """
    out = [
        (int(path.name[:3]), path.stem, path.read_text(encoding="utf-8"))
        for path in sorted(SQL_FOLDER.glob("[0-9][0-9][0-9]_*.sql"))
    ]
    if [n for n, _, _ in out] != list(range(1, len(out) + 1)):
        raise RuntimeError(f"migrations in {SQL_FOLDER} are not numbered 001, 002, ...")
    return out


def migrate(db: Path) -> int:
    """Brings a database to the newest schema, creating it if need be; returns its version.

    Raises:
        UserError: If it is locked, damaged or newer than this software.
    """
    with _writing(Path(db)) as connection:
        return _migrate(connection)


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
    with _writing(Path(db)) as connection:
        _migrate(connection)
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
    with _writing(Path(db), fresh=True) as connection:
        _migrate(connection)
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
    connection.execute("BEGIN")
    try:
        for table, found in wanted.items():
            rows[table] = _upsert(connection, found, table)
        if marks:
            connection.executemany("INSERT OR REPLACE INTO ingested VALUES (?, ?, ?, ?)", marks)
        connection.execute("COMMIT")
    except duckdb.Error as error:
        with contextlib.suppress(duckdb.Error):
            connection.execute("ROLLBACK")
        raise UserError(_blame(wanted, error)) from None
    return IngestReport(len(marks), len(files) - len(marks), rows)


def _upsert(connection: DuckDBPyConnection, files: Sequence[Path], table: str) -> int:
    """Replaces the rows of all keys that the files hold; the last row of a key wins."""
    skipped = _ARRAYS - {"bodies"} if table == "trajectories" else set()
    columns = {c: kind for c, kind in COLUMNS[table].items() if c not in skipped}
    # The database keeps plain UTC: time zone types need a package that readers may lack.
    read = ", ".join(
        f'timezone(\'UTC\', "{c}") AS "{c}"' if kind == "timestamp" else f'"{c}"'
        for c, kind in columns.items()
    )
    names = ", ".join(f'"{c}"' for c in columns)
    if table == "trajectories":
        read, names = f"{read}, filename AS file", f"{names}, file"
    keys = ", ".join(KEYS[table])
    connection.execute(
        f"""
        CREATE OR REPLACE TEMP TABLE staging AS
        SELECT {read}, listed AS file_place, file_row_number AS row_place
        FROM read_parquet($files, filename = true, file_row_number = true)
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


def _blame(files: dict[str, list[Path]], error: BaseException) -> str:
    """Which files made an ingest fail, found by reading each."""
    problems: list[str] = []
    for file in (f for found in files.values() for f in found):
        try:
            read_table(file)
        except UserError as problem:
            problems.append(str(problem))
    if not problems:
        problems = [f"{_line(error)}; rebuild the database from Parquet"]
    return "nothing was ingested:\n" + "\n".join(f"  {p}" for p in problems)


def _migrate(connection: DuckDBPyConnection) -> int:
    connection.execute(
        "CREATE TABLE IF NOT EXISTS schema_migrations (version INTEGER PRIMARY KEY, name VARCHAR)"
    )
    found = connection.execute("SELECT coalesce(max(version), 0) FROM schema_migrations").fetchone()
    version = int(found[0]) if found else 0
    known = migrations()
    if version > len(known):
        raise UserError(
            f"the database has schema version {version}, this software knows {len(known)}: update "
            "the software, or rebuild the database from Parquet"
        )
    for number, name, text in known[version:]:
        connection.execute("BEGIN")
        connection.execute(text)
        connection.execute("INSERT INTO schema_migrations VALUES (?, ?)", [number, name])
        connection.execute("COMMIT")
    return len(known)


@contextlib.contextmanager
def _writing(db: Path, *, fresh: bool = False) -> Generator[DuckDBPyConnection]:
    """A connection to a private copy of the database, which replaces it when the block succeeds."""
    import duckdb

    work = temporary_name(db)
    try:
        db.parent.mkdir(parents=True, exist_ok=True)
        with _lock(db.with_name(db.name + ".lock"), db):
            if db.exists() and not fresh:
                _settle(db)
                shutil.copyfile(db, work)
            connection = duckdb.connect(str(work))
            try:
                yield connection
                connection.execute("CHECKPOINT")
            finally:
                connection.close()
            sync_file(work)
            os.replace(work, db)
            sync_folder(db.parent)
    except OSError as error:
        raise UserError(_text(explained(error, db)), exit_code=1) from None
    except duckdb.IOException as error:
        raise UserError(f"{db} cannot be written: {_line(error)}", exit_code=1) from None
    finally:
        for leftover in (work, work.with_name(work.name + ".wal")):
            leftover.unlink(missing_ok=True)


def _text(error: OSError) -> str:
    return f"{error.filename or 'database'}: {error.strerror or error}"


def _line(error: BaseException) -> str:
    return str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__


@contextlib.contextmanager
def _lock(path: Path, db: Path) -> Generator[None]:
    """Holds the writers' lock; the system releases it when a writer dies."""
    import fcntl

    with path.open("a") as file:
        start, wait = time.monotonic(), _FIRST_WAIT_S
        while True:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                break
            except OSError as error:
                if error.errno not in (errno.EAGAIN, errno.EACCES):
                    raise
            if time.monotonic() - start > LOCK_WAIT_S:
                raise UserError(
                    f"{db} is being written by another process for more than {LOCK_WAIT_S:g} s; "
                    "wait for it to end, then run again",
                    exit_code=1,
                )
            time.sleep(wait)
            wait = min(2 * wait, 1.0)
        try:
            yield
        finally:
            fcntl.flock(file, fcntl.LOCK_UN)


def _settle(db: Path) -> None:
    """Makes sure nobody else has the database open for writing, and that no log is pending."""
    connection = _open(db, read_only=False)
    try:
        connection.execute("CHECKPOINT")
    finally:
        connection.close()


def _open(db: Path, *, read_only: bool, wait_s: float | None = None) -> DuckDBPyConnection:
    """Opens a database, with back-off while another program holds DuckDB's own lock.

    Raises:
        UserError: If the lock stays, or the file is damaged or no DuckDB database.
    """
    import duckdb

    limit = LOCK_WAIT_S if wait_s is None else wait_s
    start, wait = time.monotonic(), _FIRST_WAIT_S
    while True:
        try:
            config: dict[str, str | bool | int | float | list[str]] = {}
            if read_only:
                config["enable_external_access"] = "false"
            return duckdb.connect(str(db), read_only=read_only, config=config)
        except duckdb.IOException as error:
            if "lock" not in str(error).lower():
                raise UserError(f"{db} cannot be opened: {_line(error)}", exit_code=1) from None
            if time.monotonic() - start > limit:
                raise UserError(
                    f"{db} is locked by another program ({_line(error)}); close it there, then "
                    "run again",
                    exit_code=1,
                ) from None
        except duckdb.Error as error:
            raise UserError(
                f"{db} is damaged or no DuckDB database ({_line(error)}); rebuild it from the "
                "Parquet files",
                exit_code=1,
            ) from None
        time.sleep(wait)
        wait = min(2 * wait, 1.0)


def snapshot(db: Path, target: Path) -> Path:
    """Copies the database for a reader that wants to keep it; the copy appears whole or not at all.

    Raises:
        UserError: If there is no database or the copy cannot be written.
    """
    _must_exist(db)
    work = temporary_name(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(db, work)
        os.replace(work, target)
    except OSError as error:
        raise UserError(_text(explained(error, target)), exit_code=1) from None
    finally:
        work.unlink(missing_ok=True)
    return target


def _must_exist(db: Path) -> None:
    if not db.is_file():
        raise UserError(
            f"there is no database {db}; a benchmark or dataset run makes it, or rebuild it from "
            "Parquet"
        )


def query(
    db: Path,
    sql: str,
    *,
    timeout_s: float = 30.0,
    read_only: bool = True,
    max_rows: int = MAX_ROWS,
) -> QueryResult:
    """Runs one SQL statement.

    Read-only queries cannot touch anything but the database: no writing statements, no files, no
    other databases, no extensions, no settings.

    Args:
        db: The database.
        sql: One statement; SELECT, WITH, FROM, DESCRIBE, SHOW, SUMMARIZE or EXPLAIN.
        timeout_s: The query is stopped after this time [s].
        read_only: False lets trusted callers write (with the writers' lock and on a copy).
        max_rows: Rows to fetch at most.

    Raises:
        UserError: For anything the caller can repair: syntax, unknown tables, forbidden
            statements, the time limit, a missing or locked database.
    """
    db = Path(db)
    _must_exist(db)
    if not read_only:
        with _writing(db) as connection:
            return _run(connection, sql, timeout_s, max_rows)
    _check_statement(sql)
    with _reading(db) as connection:
        connection.execute("SET lock_configuration = true")
        return _run(connection, sql, timeout_s, max_rows)


@contextlib.contextmanager
def _reading(db: Path) -> Generator[DuckDBPyConnection]:
    """A read-only connection; beside a foreign writer, to a copy of the file."""
    try:
        connection = _open(db, read_only=True, wait_s=1.0)
    except UserError as error:
        if "locked" not in str(error):
            raise
        with tempfile.TemporaryDirectory(prefix="esg-db-") as folder:
            copy = snapshot(db, Path(folder) / db.name)
            connection = _open(copy, read_only=True, wait_s=0.0)
            try:
                yield connection
            finally:
                connection.close()
        return
    try:
        yield connection
    finally:
        connection.close()


def _check_statement(sql: str) -> None:
    import duckdb

    try:
        statements = duckdb.extract_statements(sql)
    except duckdb.Error as error:
        raise UserError(f"SQL error: {_message(error)}") from None
    if len(statements) != 1:
        raise UserError(f"expected one SQL statement, got {len(statements)}; send them one by one")
    kind = statements[0].type.name
    if kind not in _READ_ONLY_STATEMENTS:
        raise UserError(f"{kind} statements are not allowed here: queries are read-only (SELECT)")


def _run(connection: DuckDBPyConnection, sql: str, timeout_s: float, max_rows: int) -> QueryResult:
    import duckdb

    timed_out = threading.Event()

    def stop() -> None:
        timed_out.set()
        connection.interrupt()

    timer = threading.Timer(timeout_s, stop)
    timer.daemon = True
    timer.start()
    try:
        cursor = connection.execute(sql)
        description = cursor.description or []
        rows = cursor.fetchmany(max_rows + 1) if description else []
    except duckdb.InterruptException:
        if not timed_out.is_set():
            raise
        raise UserError(
            f"the query ran past its limit of {timeout_s:g} s and was stopped; narrow it with "
            "WHERE or LIMIT, or raise the limit",
            exit_code=1,
        ) from None
    except duckdb.PermissionException:
        raise UserError(
            "queries may not read files, other databases or the network; load Parquet with ingest"
        ) from None
    except duckdb.Error as error:
        raise UserError(f"SQL error: {_message(error)}") from None
    finally:
        timer.cancel()
    return QueryResult(
        columns=tuple(d[0] for d in description),
        types=tuple(str(d[1]) for d in description),
        rows=rows[:max_rows],
        truncated=len(rows) > max_rows,
    )


def _message(error: BaseException) -> str:
    return str(error).strip()
