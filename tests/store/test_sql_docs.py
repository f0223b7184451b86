"""The questions of docs/sql.md are asked of a database with the present schema."""

from __future__ import annotations

from pathlib import Path
import re

import pytest

from esg.store import ingest, query, write_tables
from tests.store.samples import record, run_info

PAGE = (Path(__file__).parents[2] / "docs" / "sql.md").read_text("utf-8")
BLOCK = re.compile(r"```sql\n(.*?)```\n+(?:\| (.*?) \|\n)?", re.DOTALL)
QUESTIONS = [(m[1].strip(), m[2].split(" | ") if m[2] else None) for m in BLOCK.finditer(PAGE)]
VIEWS = ("bench_summary", "bench_history", "scene_outcomes", "event_timings", "constraint_errors",
         "engine_transfer", "cost_per_stage", "coverage_gaps", "not_kept", "statement_rates",
         "plausibility", "engine_agreement", "what_if_agreement")  # fmt: skip


@pytest.fixture(scope="module")
def db(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("docs")
    runs = [run_info(f"run-{n}", day=n, strategy=s) for n, s in ((1, "batched"), (2, "none"))]
    records = [
        record(run, f"S{k}", seed, complete=k > 1, engines=("rapier",))
        for run in runs for k in (1, 2) for seed in (0, 1)
    ]  # fmt: skip
    write_tables(folder / "parts", records, name="runs")
    ingest(folder / "esg.duckdb", [folder / "parts"])
    return folder / "esg.duckdb"


def test_there_are_ten_questions_and_more() -> None:
    assert len(re.findall(r"^## \d+\. ", PAGE, re.MULTILINE)) == 10
    assert len(QUESTIONS) >= 10


@pytest.mark.parametrize("number", range(len(QUESTIONS)))
def test_a_question_has_the_columns_the_page_shows(db: Path, number: int) -> None:
    sql, columns = QUESTIONS[number]
    if "'parts/" in sql:
        # The page says that this one is for DuckDB itself.
        duckdb = pytest.importorskip("duckdb")
        assert duckdb.sql(sql.replace("'parts/", f"'{db.parent}/parts/")).fetchall()
        return
    found = query(db, sql)
    if columns is not None:
        assert list(found.columns) == columns


@pytest.mark.parametrize("view", VIEWS)
def test_the_page_names_every_view(db: Path, view: str) -> None:
    assert f"| `{view}` |" in PAGE
    assert query(db, f"FROM {view}").columns
