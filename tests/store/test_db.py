"""The results database: ingest, views, queries, faults."""

from __future__ import annotations

import errno
import multiprocessing
import os
from pathlib import Path
import time

from filelock import FileLock
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from esg.fidelity import statement_rows
from esg.outcomes import UserError
from esg.store import db as module
from esg.store.db import migrate, migrations, query, snapshot
from esg.store.ingesting import ingest, parquet_only, rebuild
from esg.store.records import SceneRecord, make_record
from esg.store.tables import (
    ADDED_COLUMNS,
    COLUMNS,
    TABLES,
    arrow_schema,
    part_files,
    read_table,
    write_part,
    write_tables,
)
from tests.store.samples import STATEMENTS, record, records, run_info

VIEWS = (
    "bench_summary", "bench_history", "scene_outcomes", "event_timings", "constraint_errors",
    "engine_transfer", "cost_per_stage", "coverage_gaps", "not_kept", "statement_rates",
)  # fmt: skip


@pytest.fixture
def parts(tmp_path) -> Path:
    write_tables(tmp_path / "parts", records(run_info()), name="run-1")
    return tmp_path / "parts"


@pytest.fixture
def db(tmp_path, parts) -> Path:
    path = tmp_path / "esg.duckdb"
    ingest(path, [parts])
    return path


def one(db: Path, sql: str):
    rows = query(db, sql).rows
    assert len(rows) == 1
    return rows[0]


def counts(db: Path) -> dict[str, int]:
    return {t: one(db, f"SELECT count(*) FROM {t}")[0] for t in TABLES}


def test_migrations_are_numbered_and_reachable_from_schemas():
    assert [n for n, _, _ in migrations()] == list(range(1, len(migrations()) + 1))
    link = Path(__file__).parents[2] / "schemas" / "sql"
    assert sorted(p.name for p in link.glob("*.sql")) == [f"{n}.sql" for _, n, _ in migrations()]


def test_every_parquet_column_has_its_database_column(db):
    for table, columns in COLUMNS.items():
        found = {r[0] for r in query(db, f"DESCRIBE {table}").rows}
        assert set(columns) - parquet_only(table) == found - {"file"}


def test_parts_of_format_1_0_are_still_ingested(tmp_path, parts):
    """They lack the columns of sampled scenes: null in the database, beside newer files too."""
    source = part_files(parts, "scenes")[0]
    old = pq.read_table(source).drop_columns(list(ADDED_COLUMNS["scenes"]))
    old = old.replace_schema_metadata({b"esg.table": b"scenes", b"esg.format": b"1.0.0"})
    path = tmp_path / "old" / "scenes" / "old.parquet"
    path.parent.mkdir(parents=True)
    pq.write_table(old, path)
    assert read_table(path)["rule"].null_count == old.num_rows
    ingest(tmp_path / "a.duckdb", [path])
    assert one(tmp_path / "a.duckdb", "SELECT count(*), count(rule) FROM scenes") == (
        old.num_rows,
        0,
    )
    ingest(tmp_path / "b.duckdb", [path, source])
    assert one(tmp_path / "b.duckdb", "SELECT count(*) FROM scenes")[0] == old.num_rows


def as_format_1(source: Path, target: Path, texts: dict[str, list[str | None]]) -> Path:
    """The same table as version 1.4 wrote it: JSON texts where there are types now."""
    data = pq.read_table(source)
    table = data.schema.metadata[b"esg.table"].decode()
    for column, values in texts.items():
        place = data.schema.get_field_index(column)
        data = data.set_column(place, column, pa.array(values, pa.string()))
    new = {"scenes": ["preview"]}.get(table, ["prompt"])
    facts = {b"esg.table": table.encode(), b"esg.format": b"1.4.0"}
    target.parent.mkdir(parents=True, exist_ok=True)
    pq.write_table(data.drop_columns(new).replace_schema_metadata(facts), target)
    return target


def test_texts_of_format_1_read_as_types_and_are_ingested_beside_newer_files(tmp_path, parts):
    source = {t: part_files(parts, t)[0] for t in ("metrics", "scenes")}
    n = pq.read_metadata(source["metrics"]).num_rows
    metrics = as_format_1(
        source["metrics"],
        tmp_path / "old" / "metrics.parquet",
        {"measured": ['{"b": 2, "a": 1.5}'] * n},
    )
    asked = '{"id": "x", "events": [{"id": "e1", "type": "turns", "object": "car"}], "objects": ["car"]}'
    m = pq.read_metadata(source["scenes"]).num_rows
    scenes = as_format_1(
        source["scenes"],
        tmp_path / "old" / "scenes.parquet",
        {
            "parameters": ['{"mover": "car", "speed": 3}'] * m,
            "expectation": [asked] * (m - 1) + [None],
        },
    )
    read = read_table(metrics).to_pylist()[0]
    assert read["measured"] == [{"name": "a", "value": 1.5}, {"name": "b", "value": 2.0}]
    assert read["prompt"] is None
    row = read_table(scenes).to_pylist()[0]
    assert row["parameters"] == [
        {"slot": "mover", "text": "car", "number": None},
        {"slot": "speed", "text": None, "number": 3.0},
    ]
    assert row["expectation"]["objects"] == ["car"]
    assert row["expectation"]["events"][0]["type"] == "turns"
    assert read_table(scenes)["expectation"].null_count == 1

    db, sql = (
        tmp_path / "a.duckdb",
        "SELECT DISTINCT json_extract(measured, '$.a')::DOUBLE FROM metrics",
    )
    ingest(db, [metrics, scenes])
    assert query(db, sql).rows == [(1.5,)]
    assert one(db, "SELECT count(json_extract(parameters, '$.speed')) FROM scenes")[0] == m
    ingest(db, [metrics, source["metrics"]], force=True)
    assert query(db, sql).rows == [(None,)]
    assert one(db, "SELECT count(json_extract(measured, '$.impulse_ns')) FROM metrics")[0] > 0
    ingest(db, [source["metrics"], metrics], force=True)
    assert query(db, sql).rows == [(1.5,)]


def test_ingest_is_idempotent(db, parts):
    before = counts(db)
    assert before == {
        "runs": 1, "scenes": 6, "trajectories": 6, "metrics": 12, "constraints": 12,
        "coverage": 12, "timings": 12, "statements": 18,
        "plausibility_checks": 12, "clips": 6, "truth_checks": 6, "captions": 6, "questions": 6,
        "engine_events": 6, "what_ifs": 6, "meshes": 6,
    }  # fmt: skip
    again = ingest(db, [parts])
    assert (again.files, again.unchanged) == (0, len(TABLES))
    forced = ingest(db, [parts], force=True)
    assert forced.files == len(TABLES)
    assert counts(db) == before


def test_later_rows_replace_earlier_ones(db, tmp_path):
    run = run_info()
    sql = "SELECT outcome FROM scenes WHERE scene_id = 'S1' AND seed = 0"
    assert one(db, sql) == ("solved",)
    write_tables(tmp_path / "new", [record(run, "S1", 0, complete=False)], name="redo")
    ingest(db, [tmp_path / "new"])
    assert one(db, sql) == ("not_converged",)
    assert counts(db)["scenes"] == 6


def test_of_a_key_the_last_row_of_the_last_file_stays(tmp_path, monkeypatch):
    """Within a file, among files, and beside rows that were there, however files are taken."""
    names = [f"{k:03d}" for k in range(40)]

    def part(number: int, rows: list[tuple[str, str]]) -> Path:
        path = tmp_path / "parts" / "coverage" / f"{number}.parquet"
        common = {"run_id": "r", "item_index": 0}
        found = [{**common, "scene_key": k, "text": text} for k, text in rows]
        write_part(pa.Table.from_pylist(found, schema=arrow_schema("coverage")), path)
        return path

    files = [
        part(0, [(k, "first") for k in names]),
        part(1, [(names[1], "one"), (names[2], "two"), (names[1], "three")]),
        part(2, [(names[2], "four"), (names[3], "five")]),
    ]
    expected = dict.fromkeys(names, "first") | {names[1]: "three", names[2]: "four"}
    expected[names[3]] = "five"
    asked = "SELECT scene_key, text FROM coverage ORDER BY ALL"
    for size in (10**9, 1):  # all files at once, and one by one
        monkeypatch.setattr("esg.store.ingesting._PORTION_BYTES", size)
        db = tmp_path / f"{size}.duckdb"
        assert ingest(db, files).rows == {"coverage": 40}
        assert dict(query(db, asked).rows) == expected
        assert ingest(db, [part(3, [(names[1], "late"), ("new", "late")])]).rows == {"coverage": 2}
        assert dict(query(db, asked).rows) == expected | {names[1]: "late", "new": "late"}
        assert ingest(db, files, force=True).rows == {"coverage": 40}
        assert dict(query(db, asked).rows) == expected | {"new": "late"}
        (tmp_path / "parts" / "coverage" / "3.parquet").unlink()


def test_all_damaged_files_are_named_and_rows_before_them_are_not_kept(tmp_path, parts):
    db = tmp_path / "esg.duckdb"
    bad = [parts / "metrics" / "zz.parquet", parts / "timings" / "zz.parquet"]
    for path in bad:
        whole = bytearray(next(path.parent.glob("*.parquet")).read_bytes())
        whole[60] ^= 1  # a page, not the footer
        path.write_bytes(whole)
    with pytest.raises(UserError, match="nothing was ingested") as told:
        ingest(db, [parts])
    assert all(str(path) in str(told.value) for path in bad)
    for path in bad:
        path.unlink()
    migrate(db)
    assert not any(counts(db).values())


def test_rebuild_gives_the_same_database(db, parts, tmp_path):
    fresh = tmp_path / "fresh.duckdb"
    rebuild(fresh, parts)
    for table in TABLES:
        order = "ORDER BY ALL"
        assert query(db, f"FROM {table} {order}").rows == query(fresh, f"FROM {table} {order}").rows
    # Rows that are not in the folder are gone after a rebuild.
    write_tables(tmp_path / "other", records(run_info("run-2")), name="run-2")
    ingest(fresh, [tmp_path / "other"])
    assert counts(fresh)["runs"] == 2
    rebuild(fresh, parts)
    assert counts(fresh)["runs"] == 1
    with pytest.raises(UserError, match="no Parquet tables"):
        rebuild(fresh, tmp_path / "empty" if (tmp_path / "empty").mkdir() is None else parts)


def test_bench_summary_is_the_papers_definition(db):
    row = query(db, "FROM bench_summary").dicts()[0]
    # Scenes S1..S3 with seeds 0, 1: (k + seed) % 3 == 0 completes one of two events.
    # Sums: seed 0: 2 + 2 + 1, seed 1: 2 + 1 + 2.
    assert row["ecr_mean"] == pytest.approx(5.0)
    assert row["ecr_std"] == pytest.approx(0.0)
    assert (row["events"], row["scenes"], row["runs"]) == (6, 3, 2)
    assert row["slr"] == 100.0
    # Mass always scores 1, time in 4 of 6 runs.
    assert row["ppa"] == pytest.approx(100 * (6 + 4) / 12)
    assert row["seconds_per_scene"] == pytest.approx(2.0)


def test_summary_agrees_with_the_bench_report(db):
    per_seed = query(db, "SELECT seed, sum(n_completed) FROM scenes GROUP BY seed ORDER BY seed")
    assert per_seed.rows == [(0, 5), (1, 5)]


def test_history_compares_with_the_last_good_run(tmp_path):
    path = tmp_path / "h.duckdb"

    def run(name: str, day: int, complete: bool):
        info = run_info(name, day)
        items = [record(info, f"S{k}", seed, complete=complete) for k in (1, 2) for seed in (0, 1)]
        write_tables(tmp_path / name, items, name=name)
        ingest(path, [tmp_path / name])

    run("a", 1, complete=True)
    run("b", 2, complete=False)
    run("c", 3, complete=False)
    run("d", 4, complete=True)
    rows = query(path, "FROM bench_history ORDER BY started_at").dicts()
    assert [r["run_id"] for r in rows] == ["a", "b", "c", "d"]
    # b and c are both compared with a: a bad night does not become the standard.
    assert [r["last_good"] for r in rows] == [None, "a", "a", "a"]
    assert [r["regressed"] for r in rows] == [False, True, True, False]
    assert rows[1]["ecr_change"] == pytest.approx(-2.0)


def test_prompts_of_no_suite_are_not_compared(tmp_path):
    path = tmp_path / "h.duckdb"
    for day, complete in ((1, True), (2, False)):
        info = run_info(f"generate-{day}", day, kind="generate", suite="")
        items = [record(info, "S1", 0, complete=complete)]
        write_tables(tmp_path / info.run_id, items, name=info.run_id)
        ingest(path, [tmp_path / info.run_id])
    assert len(query(path, "FROM bench_summary").rows) == 2
    assert query(path, "FROM bench_history").rows == []


def test_outcomes_timings_and_errors(db):
    outcome = query(db, "FROM scene_outcomes WHERE scene_id = 'S2'").dicts()[0]
    assert (outcome["runs"], outcome["solved"], outcome["not_converged"]) == (2, 1, 1)
    assert outcome["usual_reason"] == "e2 not reached"
    timing = query(db, "FROM event_timings WHERE scene_id = 'S2' AND event_id = 'e2'").dicts()[0]
    assert timing["completion_rate"] == 0.5
    assert timing["time_mean_s"] == pytest.approx(0.8)
    errors = query(db, "FROM constraint_errors WHERE scene_id = 'S2' AND quantity = 'time'")
    assert errors.dicts()[0]["evaluated"] == 1
    assert errors.dicts()[0]["error_mean"] == pytest.approx(0.0)
    assert errors.dicts()[0]["score"] == pytest.approx(0.5)


def test_engine_transfer_pairs_replays_of_one_scene(tmp_path):
    run = run_info()
    item = record(run, "S1", 0, engines=("rapier",))
    for row in item.rows["metrics"]:
        if row["engine"] == "rapier" and row["event_id"] == "e2":
            row["time_s"] += 0.25
    write_tables(tmp_path / "p", [item], name="x")
    ingest(tmp_path / "t.duckdb", [tmp_path / "p"])
    rows = query(tmp_path / "t.duckdb", "FROM engine_transfer").dicts()
    assert [(r["engine_a"], r["engine_b"]) for r in rows] == [("rapier", "synthetic")] * 2
    assert [r["time_difference_max_s"] for r in rows] == [0.0, pytest.approx(0.25)]
    assert [r["agreement"] for r in rows] == [1.0, 1.0]


def test_cost_and_coverage(db):
    rows = query(db, "FROM cost_per_stage").dicts()
    assert [(r["stage"], r["scenes"], r["cached"]) for r in rows] == [
        ("draft", 6, 0),
        ("replay", 6, 3),
    ]
    assert sum(r["share"] for r in rows) == pytest.approx(1.0)
    gap = query(db, "FROM coverage_gaps").dicts()[0]
    assert (gap["text"], gap["status"], gap["occurrences"]) == ("gently", "not_understood", 6)


@pytest.mark.parametrize("view", VIEWS)
def test_views_answer_on_an_empty_database(tmp_path, view):
    migrate(tmp_path / "empty.duckdb")
    assert query(tmp_path / "empty.duckdb", f"FROM {view}").rows == []


@pytest.mark.parametrize(
    ("sql", "word"),
    [
        ("DROP TABLE runs", "not allowed"),
        ("INSERT INTO runs(run_id) VALUES ('x')", "not allowed"),
        ("UPDATE runs SET suite = 'x'", "not allowed"),
        ("DELETE FROM runs", "not allowed"),
        ("CREATE TABLE x AS SELECT 1", "not allowed"),
        ("ATTACH '/tmp/other.duckdb'", "not allowed"),
        ("COPY runs TO '/tmp/x.csv'", "not allowed"),
        ("EXPORT DATABASE '/tmp/x'", "not allowed"),
        ("INSTALL httpfs", "not allowed"),
        ("SET enable_external_access = true", "not allowed"),
        ("PRAGMA database_list", "not allowed"),
        ("SELECT * FROM read_csv('/etc/passwd')", "may not read files"),
        ("SELECT * FROM read_text('/etc/passwd')", "may not read files"),
        ("SELECT * FROM glob('/*')", "may not read files"),
        ("FROM '/etc/passwd'", "SQL error"),
        ("SELECT 1; DROP TABLE runs", "one SQL statement"),
        ("", "one SQL statement"),
        ("SELEC 1", "SQL error"),
        ("SELECT * FROM nope", "SQL error"),
    ],
)
def test_queries_can_only_read_the_database(db, sql, word):
    before = db.read_bytes()
    with pytest.raises(UserError, match=word):
        query(db, sql)
    assert db.read_bytes() == before


@pytest.mark.parametrize(
    "sql", ["FROM runs", "DESCRIBE runs", "SHOW TABLES", "SUMMARIZE scenes", "EXPLAIN SELECT 1"]
)
def test_reading_statements_of_every_kind_work(db, sql):
    assert query(db, sql).rows


def test_a_query_that_takes_too_long_is_stopped(db):
    start = time.monotonic()
    with pytest.raises(UserError, match="ran past its limit"):
        query(db, "SELECT sum(a.range * b.range) FROM range(10000000) a, range(10000000) b",
              timeout_s=0.3)  # fmt: skip
    assert time.monotonic() - start < 10


def test_results_can_be_cut(db):
    found = query(db, "SELECT range FROM range(10)", max_rows=3)
    assert (len(found.rows), found.truncated) == (3, True)
    assert not query(db, "SELECT range FROM range(3)", max_rows=3).truncated


def test_trusted_callers_may_write(db):
    query(db, "DELETE FROM coverage", read_only=False)
    assert counts(db)["coverage"] == 0


def test_a_missing_or_foreign_file_is_named(tmp_path):
    with pytest.raises(UserError, match="there is no database"):
        query(tmp_path / "none.duckdb", "SELECT 1")
    # `lock` in its name must not be taken for a lock on it.
    text = tmp_path / "blocked.duckdb"
    text.write_text("hello, this is no database at all" * 100)
    start = time.monotonic()
    with pytest.raises(UserError, match=r"blocked\.duckdb is no DuckDB database; check") as told:
        query(text, "SELECT 1")
    assert told.value.exit_code == 2
    assert time.monotonic() - start < 5
    with pytest.raises(UserError, match="no such file"):
        ingest(tmp_path / "x.duckdb", [tmp_path / "nowhere"])


def test_a_truncated_file_leaves_the_database_as_it_was(db, tmp_path):
    before = db.read_bytes()
    new = write_tables(tmp_path / "new", [record(run_info("run-2"), "S9", 0)], name="new")
    data = new["scenes"].read_bytes()
    new["scenes"].write_bytes(data[: len(data) // 2])
    with pytest.raises(UserError, match=r"new\.parquet is damaged"):
        ingest(db, [tmp_path / "new"])
    assert db.read_bytes() == before
    # The same with a file whose pages, not its footer, are damaged.
    broken = bytearray(data)
    broken[60:400] = bytes(340)
    new["scenes"].write_bytes(broken)
    with pytest.raises(UserError, match="nothing was ingested"):
        ingest(db, [tmp_path / "new"])
    assert db.read_bytes() == before


def test_a_truncated_database_is_named_with_its_remedy(db, tmp_path):
    """By its own name, not that of the copy that a writer works on."""
    new = write_tables(tmp_path / "new", [record(run_info("run-2"), "S9", 0)], name="new")
    with db.open("r+b") as file:
        file.truncate(db.stat().st_size // 2)
    with pytest.raises(UserError, match=r"is damaged.*esg db rebuild") as asked:
        query(db, "SELECT * FROM scenes, runs, metrics, trajectories")
    with pytest.raises(UserError, match=r"is damaged.*esg db rebuild") as filled:
        ingest(db, [tmp_path / "new"])
    for told in (asked, filled):
        assert told.value.exit_code == 2
        assert str(db) in str(told.value)
        assert ".tmp" not in str(told.value)
    assert new["scenes"].exists()


def test_a_full_disk_leaves_the_database_as_it_was(db, parts, monkeypatch):
    before = db.read_bytes()

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device", "x")

    monkeypatch.setattr(module, "sync_file", full)
    with pytest.raises(UserError, match="free some space"):
        ingest(db, [parts], force=True)
    assert db.read_bytes() == before
    assert sorted(p.name for p in db.parent.iterdir() if "duckdb" in p.name) == [
        "esg.duckdb",
        "esg.duckdb.lock",
    ]


def test_a_disk_that_fills_up_inside_duckdb_is_no_damage(db, parts, monkeypatch):
    import duckdb

    before = db.read_bytes()

    def full(*_: object) -> None:
        raise duckdb.FatalException(
            "FATAL Error: Failed to create checkpoint because of error: Could not write file "
            f'"{db}": No space left on device'
        )

    monkeypatch.setattr("esg.store.ingesting._ingest", full)
    with pytest.raises(UserError, match=r"cannot be written.*free some space") as told:
        ingest(db, [parts], force=True)
    assert "damaged" not in str(told.value)
    assert told.value.exit_code == 1
    assert db.read_bytes() == before


def test_a_newer_schema_is_not_touched(db):
    query(db, "INSERT INTO schema_migrations VALUES (99, '099_future')", read_only=False)
    with pytest.raises(UserError, match="update the software"):
        migrate(db)


def _hold(path: str, read_only: bool, ready, release) -> None:
    import duckdb

    connection = duckdb.connect(path, read_only=read_only)
    if not read_only:
        connection.execute("CREATE TABLE IF NOT EXISTS mine (x INTEGER)")
    ready.set()
    release.wait(60)
    connection.close()


def test_a_foreign_writer_is_waited_for_then_named_and_readers_use_a_copy(db, parts, monkeypatch):
    context = multiprocessing.get_context("spawn")
    ready, release = context.Event(), context.Event()
    holder = context.Process(target=_hold, args=(str(db), False, ready, release))
    holder.start()
    try:
        assert ready.wait(60)
        monkeypatch.setattr(module, "LOCK_WAIT_S", 0.3)
        with pytest.raises(UserError, match="locked by another program"):
            ingest(db, [parts], force=True)
        assert one(db, "SELECT count(*) FROM scenes") == (6,)
    finally:
        release.set()
        holder.join(30)
    assert ingest(db, [parts], force=True).files == len(TABLES)


def test_a_foreign_reader_hinders_nobody(db, parts):
    context = multiprocessing.get_context("spawn")
    ready, release = context.Event(), context.Event()
    holder = context.Process(target=_hold, args=(str(db), True, ready, release))
    holder.start()
    try:
        assert ready.wait(60)
        assert ingest(db, [parts], force=True).files == len(TABLES)
        assert one(db, "SELECT count(*) FROM scenes") == (6,)
    finally:
        release.set()
        holder.join(30)


def test_what_a_killed_foreign_writer_committed_is_kept(db, parts):
    import duckdb

    # A write-ahead log beside the database, as a killed writer leaves it.
    copy = db.with_name("copy.duckdb")
    copy.write_bytes(db.read_bytes())
    connection = duckdb.connect(str(copy))
    connection.execute("SET wal_autocheckpoint = '1 GB'")
    connection.execute("UPDATE scenes SET reason = 'mine'")
    log = copy.with_name("copy.duckdb.wal")
    assert log.stat().st_size > 0
    db.with_name(db.name + ".wal").write_bytes(log.read_bytes())
    connection.close()
    ingest(db, [parts])
    assert not db.with_name(db.name + ".wal").exists()
    assert one(db, "SELECT count(*) FROM scenes WHERE reason = 'mine'") == (6,)


def _ingest_one(path: str, folder: str, barrier) -> None:
    barrier.wait(60)
    ingest(Path(path), [Path(folder)])


def test_too_little_memory_is_not_called_damage(tmp_path, parts, monkeypatch):
    """Say that memory ran out where it did, and leave the database as it was."""
    import duckdb

    from esg.store import ingesting

    def fail(*_: object) -> int:
        raise duckdb.OutOfMemoryException("failed to allocate block (bad allocation)")

    monkeypatch.setattr(ingesting, "_insert", fail)
    with pytest.raises(UserError, match="not enough memory"):
        ingest(tmp_path / "r.duckdb", [parts])
    monkeypatch.undo()
    assert ingest(tmp_path / "r.duckdb", [parts]).files


def test_two_ingests_at_once_lose_nothing(tmp_path):
    context = multiprocessing.get_context("spawn")
    barrier = context.Barrier(3)
    for k in range(3):
        run = run_info(f"run-{k}")
        write_tables(tmp_path / f"p{k}", records(run), name=f"run-{k}")
    workers = [
        context.Process(
            target=_ingest_one, args=(str(tmp_path / "x.duckdb"), str(tmp_path / f"p{k}"), barrier)
        )
        for k in range(3)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join(180)
    assert [w.exitcode for w in workers] == [0, 0, 0]
    assert counts(tmp_path / "x.duckdb")["runs"] == 3


def test_a_writer_that_holds_the_lock_too_long_is_reported(db, parts, monkeypatch):
    monkeypatch.setattr(module, "LOCK_WAIT_S", 0.2)
    with (
        FileLock(db.with_name(db.name + ".lock")),
        pytest.raises(UserError, match="being written by another process"),
    ):
        ingest(db, [parts])
    assert one(db, "SELECT count(*) FROM scenes") == (6,)


def _die_in_ingest(path: str, folder: str) -> None:
    module.sync_file = lambda _: os.kill(os.getpid(), 9)
    ingest(Path(path), [Path(folder)], force=True)


def test_a_killed_ingest_leaves_the_old_database(db, parts):
    before = db.read_bytes()
    worker = multiprocessing.get_context("spawn").Process(
        target=_die_in_ingest, args=(str(db), str(parts))
    )
    worker.start()
    worker.join(180)
    assert worker.exitcode == -9
    assert db.read_bytes() == before
    assert [p for p in db.parent.iterdir() if p.suffix == ".tmp"]
    assert ingest(db, [parts], force=True).files == len(TABLES)
    assert not [p for p in db.parent.iterdir() if p.name.startswith(".")]


def test_snapshot_is_a_database(db, tmp_path):
    copy = snapshot(db, tmp_path / "copies" / "a.duckdb")
    assert counts(copy) == counts(db)


def test_a_folder_that_duckdb_cannot_name_is_told(parts, tmp_path):
    for name in ("really?", "back\\slash"):
        with pytest.raises(UserError, match="set ESG_DB") as told:
            ingest(tmp_path / name / "esg.duckdb", [parts])
        assert told.value.exit_code == 1
        assert not (tmp_path / name).exists()


def test_statements_are_counted_by_what_became_of_them(db):
    """Of the six scenes two are incomplete: what they say of the hit is broken."""
    rates = {
        (r["source"], r["says"]): r
        for r in query(db, "FROM statement_rates WHERE level = 'chain'").dicts()
    }
    assert set(rates) == {
        ("prompt", "touches"), ("prompt", "not_represented"), ("suite", "ends_near"),
    }  # fmt: skip
    hit = rates["prompt", "touches"]
    assert (hit["statements"], hit["kept"], hit["broken"]) == (6, 4, 2)
    assert hit["skr"] == pytest.approx(100 * 4 / 6)
    assert rates["prompt", "not_represented"]["skr"] == 0.0
    assert rates["suite", "ends_near"]["skr"] == 100.0
    scene = "SELECT fully_understood, statements_kept FROM scenes WHERE scene_id = 'S2'"
    assert query(db, f"{scene} ORDER BY seed").rows == [(False, 0.5), (False, 0.0)]
    row = query(db, "FROM scene_outcomes WHERE scene_id = 'S2'").dicts()[0]
    assert (row["partial"], row["understood_rate"], row["statements_kept"]) == (0, 0.0, 0.25)


def test_the_words_that_are_most_often_not_shown_come_first(db):
    rows = query(db, "FROM not_kept").dicts()
    assert [(r["words"], r["status"], r["says"], r["scenes"]) for r in rows] == [
        ("of scene", "not_represented", "not_represented", 6),
        ("hits ball 2", "broken", "touches", 2),
    ]
    assert rows[0]["usual_reason"] == "no such place"
    most = "SELECT words FROM not_kept WHERE status <> 'broken' LIMIT 1"
    assert one(db, most) == ("of scene",)


def test_plausibility_tells_for_every_check_how_many_fail_and_the_worst(db):
    rows = {r["check_name"]: r for r in query(db, "FROM plausibility").dicts()}
    assert list(rows) == ["braking", "speed"]
    assert (rows["braking"]["scenes"], rows["braking"]["failed"]) == (6, 0)
    speed = rows["speed"]
    assert (speed["scenes"], speed["failed"], speed["unit"]) == (6, 2, "m/s")
    assert speed["failed_percent"] == pytest.approx(100 * 2 / 6)
    assert (speed["worst_measured"], speed["worst_limit"]) == (95.6, 47.3)
    assert speed["worst_ratio"] == pytest.approx(95.6 / 47.3)
    assert (speed["worst_scene"], speed["worst_body"]) == ("S2", "ball_1")
    assert one(db, "SELECT count(*) FROM scenes WHERE plausible") == (4,)


def test_a_verb_without_an_event_is_not_kept_unless_lost_words_tell_of_it(tmp_path):
    """Verbs come from the coverage; one inside lost words is told once."""
    run = run_info()
    made = record(run, "S1", 0)
    place = {k: made.rows["coverage"][0][k] for k in ("run_id", "scene_key", "seed")}
    verbs = [
        {**place, "item_index": 10 + i, "text": text, "start": a, "stop": b, "kind": "event",
         "status": "not_understood"}
        for i, (text, a, b) in enumerate((("Wags", 40, 44), ("Scene", 10, 15)))
    ]  # fmt: skip
    rows = {**made.rows, "coverage": verbs}
    write_tables(tmp_path / "parts", [SceneRecord(rows)], name="p")
    ingest(tmp_path / "a.duckdb", [tmp_path / "parts"])
    found = query(tmp_path / "a.duckdb", "SELECT words, says FROM not_kept").rows
    assert sorted(found) == [("of scene", "not_represented"), ("wags", "event")]


def test_a_scene_that_was_never_judged_keeps_nothing(tmp_path):
    said = statement_rows({"statements": STATEMENTS})
    made = make_record(
        run_info(), scene_id="S1", seed=0, prompt="x", outcome="crashed",
        statements={"prompt": said},
    )  # fmt: skip
    write_tables(tmp_path / "parts", [made], name="p")
    ingest(tmp_path / "a.duckdb", [tmp_path / "parts"])
    rows = query(tmp_path / "a.duckdb", "SELECT statement_id, engine, status FROM statements").rows
    assert sorted(rows) == [("s1", "", "not_judged"), ("s2", "synthetic", "not_represented")]
    found = one(tmp_path / "a.duckdb", "SELECT fully_understood, statements_kept FROM scenes")
    assert found == (None, 0.0)


def test_a_database_from_before_statements_grows_and_takes_older_parts(
    tmp_path, parts, monkeypatch
):
    """Five migrations long, with parts that know nothing of statements; newer ones come beside."""
    older = tmp_path / "older"
    for table in ("runs", "scenes", "metrics", "coverage"):
        data = pq.read_table(part_files(parts, table)[0])
        new = {"fully_understood", "statements_kept", "plausible"} & set(data.column_names)
        data = data.drop_columns(sorted(new)).replace_schema_metadata(
            {b"esg.table": table.encode(), b"esg.format": b"1.2.0"}
        )
        (older / table).mkdir(parents=True)
        pq.write_table(data, older / table / "old.parquet")
    path = tmp_path / "old.duckdb"
    known = migrations()[:5]
    with monkeypatch.context() as past:
        past.setattr("esg.store.db.migrations", lambda: known)
        assert migrate(path) == 5
    assert ingest(path, [older]).rows["scenes"] == 6
    assert one(path, "SELECT count(*), count(fully_understood) FROM scenes") == (6, 0)
    assert query(path, "FROM statements").rows == []
    assert query(path, "FROM not_kept").rows == []
    assert query(path, "FROM plausibility").rows == []
    write_tables(tmp_path / "newer", records(run_info("run-2")), name="run-2")
    ingest(path, [tmp_path / "newer"])
    assert one(path, "SELECT count(DISTINCT run_id) FROM statements") == (1,)
    rebuild(tmp_path / "again.duckdb", [older, tmp_path / "newer"])
    for table in TABLES:
        rows = query(path, f"FROM {table} ORDER BY ALL").rows
        assert rows == query(tmp_path / "again.duckdb", f"FROM {table} ORDER BY ALL").rows


@pytest.mark.parametrize(
    "sql",
    ["SELECT list(range) FROM range(1000000000)",
     "SELECT count(*) FROM range(100000000) a, range(100000000) b"],
)  # fmt: skip
def test_a_query_that_needs_too_much_memory_is_refused_and_fills_no_disk(db, sql):
    before = sorted(p.name for p in db.parent.iterdir())
    with pytest.raises(UserError, match="ESG_SQL_GIB") as told:
        query(db, sql, memory_gib=0.25)
    assert told.value.exit_code == 1
    assert sorted(p.name for p in db.parent.iterdir()) == before
