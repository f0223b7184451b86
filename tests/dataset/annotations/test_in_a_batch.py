"""What a batch writes of texts and replays, and that none of it fails a scene."""

from __future__ import annotations

from dataclasses import replace
import json
from pathlib import Path
from typing import Any

import pytest

from esg.dataset.annotations import rows as module
from esg.dataset.batch import make_batch
from esg.dataset.finish import finish
from esg.dataset.folder import DatasetFolder
from esg.dataset.job import BatchJob
from esg.dataset.plan import DatasetSpec, Prompt, plan_scenes
from esg.dataset.running import ALTERNATIVES, mark_dead
from esg.dataset.whatifs import stage
from esg.engines.registry import get_engine
from esg.store import ingest, query
from esg.store.tables import part_files, read_table
from tests.dataset.answers import wrong_answers
from tests.dataset.test_batch import below, quick
from tests.metrics.test_events import CHAIN

__all__ = ["quick"]  # its fixture: fake stages

EXPECT = json.dumps(
    {"id": "s", "prompt": "p", "events": [e.model_dump(by_alias=True) for e in CHAIN]}
)


@pytest.fixture(autouse=True)
def without_newton(monkeypatch: pytest.MonkeyPatch) -> None:
    def fast(name: str) -> object:
        return get_engine("rapier" if name == "newton" else name)

    monkeypatch.setattr("esg.dataset.whatifs.replaying.get_engine", fast)


def job(out: Path, texts: list[str], **more: Any) -> BatchJob:
    prompts = [Prompt(prompt=t, expect=EXPECT) for t in texts]
    values = {"previews": "none", "batch": 4, **more}
    spec = DatasetSpec(source="prompts", n=len(texts), **values)
    run = DatasetFolder(out).begin(spec, prompts, resume=True)
    return BatchJob(0, spec, run, tuple(plan_scenes(spec, prompts)), out, out / "work" / "0")


def rows(out: Path, table: str) -> list[dict[str, Any]]:
    return [r for p in part_files(out / "parts", table) for r in read_table(p).to_pylist()]


ASKED = {"what_if": ("mass", "gravity"), "engines": ("physx", "rapier")}


def test_every_judged_scene_has_texts_and_other_replays(tmp_path: Path) -> None:
    make_batch(job(tmp_path, ["balls 1", "balls 2", "bug"], **ASKED))
    captions = rows(tmp_path, "captions")
    assert len(captions) == 2 and all(c["prompt"].startswith("balls") for c in captions)
    assert all(c["short"].endswith(".") and len(c["event_texts"]) == 2 for c in captions)
    events = rows(tmp_path, "engine_events")
    assert len(events) == 2 * 2 * 2 * 2  # scenes, engines, steps, events
    what_ifs = rows(tmp_path, "what_ifs")
    assert {(r["variable"], r["engine"]) for r in what_ifs} == {
        (v, e) for v in ("none", "mass", "gravity") for e in ("physx", "rapier", "newton")
    }
    assert {r["pair"] for r in what_ifs} >= {"0000000/none", "0000001/gravity"}
    stages = {r["stage"] for r in rows(tmp_path, "timings")}
    assert {"engines", "what_ifs"} <= stages
    assert {s["scene_id"]: s["engines_agree"] for s in rows(tmp_path, "scenes")} == {
        "0000000": True, "0000001": True, "0000002": None,
    }  # fmt: skip
    assert len(rows(tmp_path, "questions")) > 0
    assert wrong_answers(tmp_path)[1] == []


def test_without_annotations_and_replays_there_are_no_such_tables(tmp_path: Path) -> None:
    make_batch(job(tmp_path, ["balls 1"], annotations="none"))
    found = {p.parent.name for p in part_files(tmp_path / "parts")}
    assert not found & {"captions", "questions", "engine_events", "what_ifs"}
    assert rows(tmp_path, "scenes")[0]["engines_agree"] is None


def test_replays_are_kept_when_the_batch_is_cut_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = job(tmp_path / "a", ["balls 1", "balls 2"], **ASKED)
    played: list[str] = []
    original = stage._replayed

    def noted(state: Any, asked: Any, name: str) -> Any:
        if len(played) == 1 and not (tmp_path / "again").exists():
            raise KeyboardInterrupt
        played.append(name)
        return original(state, asked, name)

    monkeypatch.setattr(stage, "_replayed", noted)
    with pytest.raises(KeyboardInterrupt):
        make_batch(first)
    (tmp_path / "again").touch()
    make_batch(first)
    assert played == ["0000000", "0000001"]
    monkeypatch.setattr(stage, "_replayed", original)
    make_batch(job(tmp_path / "b", ["balls 1", "balls 2"], **ASKED))
    one, two = below(tmp_path / "a" / "parts"), below(tmp_path / "b" / "parts")
    assert one == two and "captions/batch-000000.parquet" in one


def test_replays_that_end_the_worker_cost_their_own_rows(tmp_path: Path) -> None:
    broken = job(tmp_path, ["balls 1", "balls 2"], **ASKED)
    broken.work.mkdir(parents=True)
    (broken.work / "reached").write_text(ALTERNATIVES)
    mark_dead(broken, 1, "the worker process ended twice")
    result = make_batch(broken)
    assert result.outcomes == {"solved": 2} and not result.crashes
    failed = [r for r in rows(tmp_path, "what_ifs") if r["scene_id"] == "0000001"]
    assert {r["outcome"] for r in failed} == {"failed"}
    assert all("ended twice" in r["reason"] for r in failed)
    assert len(rows(tmp_path, "captions")) == 2


def test_a_text_that_cannot_be_made_fails_no_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*args: object) -> None:
        raise RuntimeError("a defect")

    monkeypatch.setattr(module, "text_rows", broken)
    assert make_batch(job(tmp_path, ["balls 1"])).verified == 1
    assert rows(tmp_path, "captions") == []


def test_a_finished_dataset_has_them_in_its_splits_and_its_database(tmp_path: Path) -> None:
    made = job(tmp_path, ["balls 1", "others 2"], **ASKED)
    finish(DatasetFolder(tmp_path), replace(made).spec, {0: make_batch(made)})
    card = (tmp_path / "README.md").read_text("utf-8")
    for table in ("captions", "questions", "engine_events", "what_ifs"):
        assert f"config_name: {table}" in card and f"| {table} |" in card
    ingest(tmp_path / "db.duckdb", [tmp_path])
    kept = query(tmp_path / "db.duckdb", "SELECT count(*) FROM scenes WHERE engines_agree").rows
    assert kept == [(2,)]
    agreed = query(tmp_path / "db.duckdb", "FROM what_if_agreement").dicts()
    assert {r["variable"] for r in agreed} == {"none", "mass", "gravity"}
    assert query(tmp_path / "db.duckdb", "FROM engine_agreement").dicts()[0]["agreed"] == 4
