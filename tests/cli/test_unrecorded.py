"""A result that could not be recorded is no success: told on stderr, exit code 1."""

from __future__ import annotations

from collections.abc import Callable
import errno
from pathlib import Path

from filelock import FileLock
import pytest

from esg.commands.bench import bench
from esg.commands.generate import generate
from esg.commands.serve import serve
from esg.outcomes import Outcome
from esg.pipeline import SceneRequest, SceneState

SUITE = """\
suite: two
scenes:
  - {id: S1, prompt: A ball rolls., events: []}
"""


def damaged(db: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    db.write_bytes(b"no database" * 1000)


def locked(db: Path, monkeypatch: pytest.MonkeyPatch) -> FileLock:
    """A second lock on the file in one process waits like another process's."""
    monkeypatch.setattr("esg.store.db.LOCK_WAIT_S", 0.2)
    held = FileLock(db.with_name(db.name + ".lock"))
    held.acquire()
    return held


def full(db: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def write(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device", str(db))

    monkeypatch.setattr("esg.store.db.sync_file", write)


def read_only(db: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def write(*_: object) -> None:
        raise OSError(errno.EROFS, "Read-only file system", str(db))

    monkeypatch.setattr("esg.store.tables.atomic_write", write)


def foreign(db: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A DuckDB database whose catalogue is not this project's."""
    import duckdb

    with duckdb.connect(str(db)) as connection:
        connection.execute("CREATE TABLE schema_migrations (version VARCHAR)")


def generated(folder: Path) -> int:
    return generate("A ball rolls.", out=folder / "out")


def benched(folder: Path) -> int:
    (folder / "two.yaml").write_text(SUITE)
    return bench(folder / "two.yaml", runs=1, out=folder / "out")


def served(folder: Path) -> int:
    (folder / "two.yaml").write_text(SUITE)
    return serve(once=True, suite=[folder / "two.yaml"], runs=1, out=folder / "out")


@pytest.mark.parametrize("command", [generated, benched, served])
@pytest.mark.parametrize("fault", [None, damaged, locked, full, read_only, foreign])
def test_a_run_that_is_not_recorded_ends_with_1(
    command: Callable[[Path], int],
    fault: Callable[[Path, pytest.MonkeyPatch], FileLock | None] | None,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    db = tmp_path / "runs" / "esg.duckdb"
    db.parent.mkdir()
    monkeypatch.setenv("ESG_DB", str(db))
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "cache"))

    def solved(request: SceneRequest) -> SceneState:
        log = ({"stage": "judge", "seconds": 0.1, "cached": True},)
        return SceneState(request, {}, log, Outcome.SOLVED)

    def night(options: dict[str, object]) -> list[dict[str, object]]:
        from esg.nightly import conclude_suite

        states = [solved(SceneRequest("A ball rolls.", name="S1-run0"))]
        (suite,) = options["suites"]  # type: ignore[misc]
        return [conclude_suite(states, suite, 1, tmp_path / "out", db).to_json()]

    monkeypatch.setattr("esg.pipeline.recall", solved)
    monkeypatch.setattr("esg.commands.serve._once", night)
    monkeypatch.setattr("esg.nightly._report", lambda *_: "")
    held = fault(db, monkeypatch) if fault else None
    code = command(tmp_path)
    if held:
        held.release()
    told = capsys.readouterr()
    assert code == (0 if fault is None else 1), told.err
    assert ("is not in the database" in told.err) is (fault is not None)
    assert "defect" not in told.err
