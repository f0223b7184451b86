"""Rows of the run database as CSV, Parquet and Markdown."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from esg.commands.sql import sql
from esg.outcomes import UserError
from esg.store import ingest, write_tables
from tests.store.samples import record, run_info

QUERY = (
    "SELECT scene_id, seed, 1.5 AS half, NULL AS nothing, 'a|b, \"c\"' AS text FROM scenes "
    "ORDER BY seed"
)


@pytest.fixture
def db(tmp_path: Path) -> Path:
    run = run_info()
    write_tables(tmp_path / "parts", [record(run, "S1", k) for k in (0, 1)], name="run")
    ingest(tmp_path / "runs.duckdb", [tmp_path / "parts"])
    return tmp_path / "runs.duckdb"


def test_csv_reads_back(db: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert sql(QUERY, db=db, to="csv") == 0
    rows = list(csv.reader(io.StringIO(capsys.readouterr().out)))
    assert rows == [
        ["scene_id", "seed", "half", "nothing", "text"],
        ["S1", "0", "1.5", "", 'a|b, "c"'],
        ["S1", "1", "1.5", "", 'a|b, "c"'],
    ]


def test_parquet_keeps_values_and_types(db: Path, tmp_path: Path) -> None:
    out = tmp_path / "new" / "rows.parquet"
    assert sql(QUERY, db=db, to="parquet", out=out) == 0
    assert pq.read_table(out).to_pylist()[1] == {
        "scene_id": "S1", "seed": 1, "half": 1.5, "nothing": None, "text": 'a|b, "c"',
    }  # fmt: skip
    assert sql(f"SELECT * FROM ({QUERY}) WHERE seed > 9", db=db, to="parquet", out=out) == 0
    empty = pq.read_table(out)
    assert (empty.num_rows, empty.column_names[0]) == (0, "scene_id")


def test_markdown_is_a_table(db: Path, tmp_path: Path) -> None:
    out = tmp_path / "rows.md"
    assert sql(QUERY, db=db, to="md", out=out) == 0
    head, rule, first, _ = out.read_text().splitlines()
    assert head == "| scene_id | seed | half | nothing | text |"
    assert rule == "| --- | --- | --- | --- | --- |"
    assert first == '| S1 | 0 | 1.5 |  | a\\|b, "c" |'


def test_options_that_contradict_each_other_are_told(db: Path, tmp_path: Path) -> None:
    for options, word in (
        ({"out": tmp_path / "x"}, "--to"),
        ({"to": "parquet"}, "--out FILE"),
        ({"to": "csv", "json": True}, "one of them"),
        ({"to": "csv", "out": tmp_path}, "is a folder"),
    ):
        with pytest.raises(UserError, match=word):
            sql(QUERY, db=db, **options)
    assert list(tmp_path.glob("x*")) == []
