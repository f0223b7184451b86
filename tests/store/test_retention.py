"""Old runs go, with their parts; what younger runs are compared with stays."""

from __future__ import annotations

import datetime
from pathlib import Path

import pytest

from esg.outcomes import UserError
from esg.store.db import query
from esg.store.ingesting import ingest, rebuild
from esg.store.retention import prune_runs
from esg.store.tables import TABLES, write_tables
from tests.store.samples import UTC, record, run_info

NOW = datetime.datetime(2026, 2, 1, tzinfo=UTC)


def night(parts: Path, day: int, complete: bool) -> None:
    run = run_info(f"run-{day}", day=day)
    write_tables(parts, [record(run, "S1", s, complete=complete) for s in (0, 1)], name=run.run_id)


@pytest.fixture
def db(tmp_path: Path) -> Path:
    """Runs of the days 1 (good), 2 (bad), 3 (good), 30 (bad)."""
    for day, complete in ((1, True), (2, False), (3, True), (30, False)):
        night(tmp_path / "parts", day, complete)
    ingest(tmp_path / "x.duckdb", [tmp_path / "parts"])
    return tmp_path / "x.duckdb"


def runs(db: Path, table: str = "runs") -> set[str]:
    return {r[0] for r in query(db, f"SELECT DISTINCT run_id FROM {table}").rows}


def test_old_runs_go_but_the_standard_stays(db: Path, tmp_path: Path) -> None:
    before = query(db, "SELECT last_good FROM bench_history WHERE run_id = 'run-30'").rows
    assert before == [("run-3",)]
    gone = prune_runs(db, 10, parts=tmp_path / "parts", now=NOW)
    assert gone.runs == ("run-1", "run-2")
    assert gone.kept_as_standard == ("run-3",)
    for table in TABLES:
        assert runs(db, table) == {"run-3", "run-30"}
    assert query(db, "SELECT regressed FROM bench_history WHERE run_id = 'run-30'").rows == [
        (True,)
    ]


def test_a_rebuild_does_not_bring_them_back(db: Path, tmp_path: Path) -> None:
    prune_runs(db, 10, parts=tmp_path / "parts", now=NOW)
    rebuild(db, tmp_path / "parts")
    assert runs(db) == {"run-3", "run-30"}


def test_pruned_parts_can_be_ingested_again(db: Path, tmp_path: Path) -> None:
    kept = {p: p.read_bytes() for p in (tmp_path / "parts").rglob("run-1.parquet")}
    prune_runs(db, 10, parts=tmp_path / "parts", now=NOW)
    for path, data in kept.items():
        path.write_bytes(data)
    ingest(db, [tmp_path / "parts"])
    assert "run-1" in runs(db)


def test_a_dry_run_changes_nothing(db: Path, tmp_path: Path) -> None:
    before = db.read_bytes()
    gone = prune_runs(db, 10, parts=tmp_path / "parts", now=NOW, dry_run=True)
    assert (gone.runs, gone.files > 0) == (("run-1", "run-2"), True)
    assert db.read_bytes() == before
    assert (tmp_path / "parts" / "runs" / "run-1.parquet").exists()


def test_a_missing_database_is_named(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="there is no database"):
        prune_runs(tmp_path / "no.duckdb", 1)
