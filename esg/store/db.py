"""The results database: DuckDB, rebuilt from Parquet at any time, never written by workers.

One writer at a time (a lock file decides) works on a copy and renames it into place. Readers open
whatever is there: they never wait for a writer, and a killed writer leaves the old database. The
schema grows by numbered migrations in `esg/store/sql` (also reachable as `schemas/sql`).
"""

from __future__ import annotations

from collections.abc import Generator
import contextlib
from dataclasses import dataclass
import errno
import glob
import os
from pathlib import Path
import shutil
import tempfile
import threading
import time
from typing import TYPE_CHECKING, Any

from esg.files import TEMPORARY, explained, final_names, sync_file, sync_folder, temporary_name
from esg.outcomes import UserError

if TYPE_CHECKING:
    from duckdb import DuckDBPyConnection

SQL_FOLDER = Path(__file__).parent / "sql"
LOCK_WAIT_S = 20.0
_FIRST_WAIT_S = 0.05
_READ_ONLY_STATEMENTS = {"SELECT", "EXPLAIN"}
MAX_ROWS = 1_000_000


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
    with writing(Path(db)) as connection:
        return apply_migrations(connection)


def apply_migrations(connection: DuckDBPyConnection) -> int:
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
def writing(db: Path, *, fresh: bool = False) -> Generator[DuckDBPyConnection]:
    """A connection to a private copy of the database, which replaces it when the block succeeds."""
    import duckdb

    place = str(db.absolute())
    if "?" in place or "\\" in place:
        raise UserError(
            f"DuckDB opens no file with ? or \\ in its path: {place}; set ESG_DB to another place",
            exit_code=1,
        )
    work = temporary_name(db)
    try:
        db.parent.mkdir(parents=True, exist_ok=True)
        with _lock(db.with_name(db.name + ".lock"), db):
            _sweep(db)
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
        raise _refused(db, error) from None
    except (duckdb.InternalException, duckdb.FatalException) as error:
        if os.strerror(errno.ENOSPC) in str(error):  # the copy; the database itself is whole
            raise _refused(db, error) from None
        raise broken(db, error) from None
    except duckdb.Error as error:  # a catalogue or rows that no longer fit together
        raise broken(db, error) from None
    finally:
        for leftover in (work, work.with_name(work.name + ".wal")):
            leftover.unlink(missing_ok=True)


def _sweep(db: Path) -> None:
    """Deletes the copies that killed writers left: who holds the lock is the only writer."""
    for ending in (TEMPORARY, TEMPORARY + ".wal"):
        for path in db.parent.glob(f".{glob.escape(db.name)}.*{ending}"):
            path.unlink(missing_ok=True)


def _refused(db: Path, error: BaseException) -> UserError:
    why = final_names(first_line(error))
    if "Could not read" in why:
        return broken(db, error)
    full = os.strerror(errno.ENOSPC) in str(error)
    remedy = "; free some space, or choose a folder on another disk" if full else ""
    return UserError(f"{db} cannot be written: {why}{remedy}", exit_code=1)


def _text(error: OSError) -> str:
    return f"{error.filename or 'database'}: {error.strerror or error}"


def broken(db: Path, error: BaseException) -> UserError:
    """What DuckDB found wrong inside a database file, with the remedy."""
    why = final_names(first_line(error))
    return UserError(f"{db} is damaged ({why}); rebuild it from Parquet (esg db rebuild)")


def first_line(error: BaseException) -> str:
    """The first line of a message, or the name of an error that has none."""
    return str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__


@contextlib.contextmanager
def _lock(path: Path, db: Path) -> Generator[None]:
    """Holds the writers' lock; the system releases it when a writer dies."""
    from filelock import FileLock, Timeout

    lock = FileLock(path, timeout=LOCK_WAIT_S, poll_interval=_FIRST_WAIT_S)
    try:
        lock.acquire()
    except Timeout:
        raise UserError(
            f"{db} is being written by another process for more than {LOCK_WAIT_S:g} s; "
            "wait for it to end, then run again",
            exit_code=1,
        ) from None
    try:
        yield
    finally:
        lock.release()


def _settle(db: Path) -> None:
    """Makes sure that nobody has the database open for writing and that no log is pending.

    Programs that only read it do no harm: they keep the file they opened.
    """
    _open(db, read_only=True).close()
    if db.with_name(db.name + ".wal").exists():
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
                config["temp_directory"] = ""  # a question fills no disk
            return duckdb.connect(str(db), read_only=read_only, config=config)
        except duckdb.IOException as error:
            text = str(error).replace(str(db), "").lower()
            if "not a valid duckdb" in text:
                raise UserError(
                    f"{db} is no DuckDB database; check the path, or, if it should be one, make it "
                    "again from Parquet (esg db rebuild)"
                ) from None
            if "lock" not in text:
                raise UserError(
                    f"{db} cannot be opened: {first_line(error)}", exit_code=1
                ) from None
            if time.monotonic() - start > limit:
                raise UserError(
                    f"{db} is locked by another program ({first_line(error)}); close it there, "
                    "then run again",
                    exit_code=1,
                ) from None
        except duckdb.Error as error:
            raise UserError(
                f"{db} is damaged or no DuckDB database ({first_line(error)}); rebuild it from the "
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
    must_exist(db)
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


def must_exist(db: Path) -> None:
    """Checks that there is a database.

    Raises:
        UserError: If not.
    """
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
    memory_gib: float = 0.0,
    read_only: bool = True,
    max_rows: int = MAX_ROWS,
) -> QueryResult:
    """Runs one SQL statement.

    Read-only queries cannot touch anything but the database: no writing statements, no files, no
    other databases, no extensions, no settings.

    Args:
        db: The database.
        sql: One statement; SELECT, WITH, FROM, DESCRIBE, SHOW, SUMMARIZE or EXPLAIN.
        timeout_s: The query is stopped after this time [s]; 0: never.
        memory_gib: It may keep so much in memory and nothing on the disk; 0: no limit.
        read_only: False lets trusted callers write (with the writers' lock and on a copy).
        max_rows: Rows to fetch at most.

    Raises:
        UserError: For anything the caller can repair: syntax, unknown tables, forbidden
            statements, the time limit, a missing or locked database.
    """
    db = Path(db)
    must_exist(db)
    if not read_only:
        with writing(db) as connection:
            return _run(connection, db, sql, timeout_s, max_rows)
    _check_statement(sql)
    with _reading(db) as connection:
        if memory_gib:
            connection.execute(f"SET memory_limit = '{memory_gib * 1024:.0f}MiB'")
        connection.execute("SET lock_configuration = true")
        return _run(connection, db, sql, timeout_s, max_rows)


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


def _run(
    connection: DuckDBPyConnection, db: Path, sql: str, timeout_s: float, max_rows: int
) -> QueryResult:
    import duckdb

    timed_out, ended = threading.Event(), threading.Event()

    def stop() -> None:
        # Again and again: DuckDB forgets an interrupt that falls between two of its steps.
        wait = timeout_s
        while not ended.wait(wait):
            timed_out.set()
            with contextlib.suppress(duckdb.Error):  # closed meanwhile
                connection.interrupt()
            wait = 0.1

    if timeout_s:
        threading.Thread(target=stop, daemon=True).start()
    try:
        cursor = connection.execute(sql)
        description = cursor.description or []
        rows = cursor.fetchmany(max_rows + 1) if description else []
    except duckdb.InterruptException:
        if not timed_out.is_set():
            raise
        raise UserError(
            f"the query ran past its limit of {timeout_s:g} s and was stopped; narrow it with "
            "WHERE or LIMIT, or raise the limit (ESG_SQL_SECONDS)",
            exit_code=1,
        ) from None
    except (duckdb.OutOfMemoryException, MemoryError):
        raise UserError(
            "the query needs more memory than its limit; narrow it with WHERE or LIMIT, or raise "
            "the limit (ESG_SQL_GIB)",
            exit_code=1,
        ) from None
    except duckdb.PermissionException:
        raise UserError(
            "queries may not read files, other databases or the network; load Parquet with ingest"
        ) from None
    except (duckdb.IOException, duckdb.InternalException, duckdb.FatalException) as error:
        raise broken(db, error) from None
    except duckdb.Error as error:
        raise UserError(f"SQL error: {_message(error)}") from None
    finally:
        ended.set()
    return QueryResult(
        columns=tuple(d[0] for d in description),
        types=tuple(str(d[1]) for d in description),
        rows=rows[:max_rows],
        truncated=len(rows) > max_rows,
    )


def _message(error: BaseException) -> str:
    return str(error).strip()
