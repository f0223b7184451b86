"""Batches: what they leave, what fails in them, resuming, and putting a dataset together."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
import errno
import json
import os
from pathlib import Path
import shutil

import pyarrow.parquet as pq
import pytest

from esg import pipeline, stages
from esg.costs.spent import Meter
from esg.dataset import running as module
from esg.dataset.batch import make_batch
from esg.dataset.card import CARD, untimed
from esg.dataset.finish import clean, finish
from esg.dataset.folder import DatasetFolder, read_mark
from esg.dataset.job import BatchJob
from esg.dataset.plan import DatasetSpec, Prompt, Shard, plan_scenes
from esg.dataset.running import mark_dead, run_scenes
from esg.dataset.writing import _as_said
from esg.outcomes import Outcome, UserError
from esg.pipeline import SceneRequest, SceneState
from esg.store.tables import part_files, read_table
from tests.dataset import fakes


@pytest.fixture(autouse=True)
def quick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Fake stages, no waiting; everything is put back."""
    for name in fakes.STAGES:
        monkeypatch.setitem(stages.SPECS, name, stages.SPECS[name])
    monkeypatch.setattr(stages, "conclude", stages.conclude)
    monkeypatch.setenv("ESG_TEST_CALLS", str(tmp_path / "calls"))
    monkeypatch.setattr(module, "PAUSES_S", (0.0, 0.0))
    monkeypatch.setattr(module, "_compile_together", lambda states: None)
    monkeypatch.setattr(stages, "load_doc", lambda state: None)
    monkeypatch.setattr("esg.store.mcap_log.write_mcap", fakes.write_mcap)
    fakes.install()
    yield


GOOD = [f"balls {k}" for k in range(10)]


def dataset(out: Path, texts: list[str], **more: object) -> list[BatchJob]:
    """The jobs of a dataset of prompts, four scenes a batch."""
    prompts = [Prompt(prompt=t) for t in texts]
    values = {"previews": "none", "batch": 4, **more}
    spec = DatasetSpec(source="prompts", n=len(texts), **values)  # type: ignore[arg-type]
    folder = DatasetFolder(out)
    run = folder.begin(spec, prompts, resume=True)
    scenes = plan_scenes(spec, prompts)
    return [
        BatchJob(n, spec, run, tuple(scenes[4 * n : 4 * n + 4]), out, out / "work" / str(n))
        for n in range(spec.n_batches)
    ]


def build(out: Path, texts: list[str], **more: object) -> None:
    jobs = dataset(out, texts, **more)
    results = {job.number: make_batch(job) for job in jobs}
    finish(DatasetFolder(out), jobs[0].spec, results)


def below(out: Path) -> dict[str, bytes]:
    """Everything but times."""
    times = ("timings/", "runs/", "meta/run.json", "meta/timings.json")
    return {
        name: untimed(p.read_text()).encode() if name == CARD else p.read_bytes()
        for p in sorted(out.rglob("*"))
        if p.is_file() and not (name := p.relative_to(out).as_posix()).startswith((*times, ".lock"))
    }


def scenes(out: Path) -> list[dict[str, object]]:
    rows = [r for p in part_files(out, "scenes") for r in read_table(p).to_pylist()]
    return sorted(rows, key=lambda r: r["scene_id"])


def test_a_dataset_holds_every_scene_and_nothing_else(tmp_path: Path) -> None:
    build(tmp_path / "a", GOOD, mcap="failed")
    rows = scenes(tmp_path / "a")
    assert [r["prompt"] for r in rows] == GOOD
    assert all(r["verified"] and r["outcome"] == "solved" and r["manifest"] for r in rows)
    top = sorted(p.name for p in (tmp_path / "a").iterdir() if not p.name.startswith("."))
    assert top == [
        "README.md",
        "meta",
        "metrics",
        "plausibility_checks",
        "runs",
        "scenes",
        "timings",
        "trajectories",
    ]
    assert sorted(p.name for p in (tmp_path / "a" / "meta").iterdir()) == [
        "duplicates.jsonl", "info.json", "plan.json", "prompts.jsonl", "run.json", "timings.json",
    ]  # fmt: skip


def test_trajectories_are_thinned_and_contacts_kept(tmp_path: Path) -> None:
    build(tmp_path / "a", GOOD[:1], fps=60.0)
    row = read_table(part_files(tmp_path / "a", "trajectories")[0]).to_pylist()[0]
    assert row["fps"] == pytest.approx(60.0)
    assert row["n_frames"] == 181
    assert len(row["position_m"]) == 181 * 3 * 3
    assert row["contact_time_s"] == pytest.approx([0.4, 0.8])


def test_failures_leave_their_reason_and_stop_nobody(tmp_path: Path) -> None:
    texts = ["balls", "a bug", "busy", "user error", "bad draft", "wrong"]
    build(tmp_path / "a", texts)
    rows = scenes(tmp_path / "a")
    assert [r["outcome"] for r in rows] == [
        "solved", "crashed", "solved", "invalid_draft", "invalid_draft", "solved",
    ]  # fmt: skip
    failed = [json.loads(t) for t in (tmp_path / "a" / "failures.jsonl").read_text().splitlines()]
    found = {f["prompt"]: (f["outcome"], f["stage"]) for f in failed}
    assert found == {
        "a bug": ("crashed", "layout"),
        "user error": ("invalid_draft", "resolve"),
        "bad draft": ("invalid_draft", "draft"),
        "wrong": ("not_as_stated", "judge"),
    }
    assert all(f["reason"] for f in failed)
    crash = json.loads((tmp_path / "a" / "meta" / "crashes.jsonl").read_text())
    assert "ZeroDivisionError" in crash["traceback"]
    card = (tmp_path / "a" / "README.md").read_text()
    assert "ZeroDivisionError: a defect" in card
    assert "6 scenes, 2 of them (33.3%)" in card


def test_the_card_says_how_it_was_made_and_what_is_inside(tmp_path: Path) -> None:
    build(tmp_path / "a", ["two | balls", "wrong"], seed=3, mcap="failed")
    card = (tmp_path / "a" / "README.md").read_text()
    assert (
        "esg dataset --prompts meta/prompts.jsonl --seed 3 --mcap failed --previews none --batch 4 "
        "--out FOLDER" in card
    )
    assert "| two \\| balls | solved | yes |" in card
    assert "| wrong | solved | no |" in card
    assert "| bodies | 3 | 3 | 3 | 3 |" in card
    assert "| length of the replay [s] | 3 | 3 | 3 | 3 |" in card


def test_partial_scenes_are_kept_but_neither_verified_nor_failed(tmp_path: Path) -> None:
    build(tmp_path / "a", ["balls", "half balls", "half wrong"], mcap="failed")
    rows = scenes(tmp_path / "a")
    assert [(r["outcome"], r["verified"], r["fully_understood"]) for r in rows] == [
        ("solved", True, True), ("partial", False, False), ("partial", False, False),
    ]  # fmt: skip
    assert [r["statements_kept"] for r in rows] == [None, 0.0, 0.0]
    failed = (tmp_path / "a" / "failures.jsonl").read_text().splitlines()
    assert [json.loads(t)["prompt"] for t in failed] == ["half wrong"]
    assert [p.stem for p in (tmp_path / "a" / "mcap").iterdir()] == [rows[2]["scene_id"]]
    said = read_table(part_files(tmp_path / "a", "statements")[0]).to_pylist()
    assert {(r["words"], r["status"], r["source"]) for r in said} == {
        ("Half", "not_represented", "prompt")
    }
    facts = json.loads((tmp_path / "a" / "meta" / "info.json").read_text())["statistics"]
    assert (facts["verified"], facts["partial"], facts["fully_understood"]) == (1, 2, 1)
    assert facts["not_represented"] == [{"words": "half", "status": "not_represented", "scenes": 2}]
    card = (tmp_path / "a" / "README.md").read_text()
    assert "1 of 3 prompts are fully understood; 2 scenes are `partial`" in card
    assert "| half | not represented | 2 |" in card


def test_a_strict_dataset_counts_partial_scenes_as_failed(tmp_path: Path) -> None:
    build(tmp_path / "a", ["balls", "half balls"], strict=True)
    failed = (tmp_path / "a" / "failures.jsonl").read_text().splitlines()
    assert [(json.loads(t)["prompt"], json.loads(t)["outcome"]) for t in failed] == [
        ("half balls", "partial")
    ]
    assert "--strict" in (tmp_path / "a" / "README.md").read_text()


def test_implausible_scenes_are_marked_told_on_the_card_and_fail_only_if_strict(
    tmp_path: Path,
) -> None:
    for strict in (False, True):
        out = tmp_path / str(strict)
        build(out, ["balls", "rockets balls"], strict=strict)
        assert [r["plausible"] for r in scenes(out)] == [True, False]
        card = (out / "README.md").read_text()
        assert "1 of 2 replays are `plausible`" in card and "| speed | 1 |" in card
        failed = out / "failures.jsonl"
        told = [json.loads(t) for t in failed.read_text().splitlines()] if failed.exists() else []
        assert [r["prompt"] for r in told] == (["rockets balls"] if strict else [])
        assert all("implausible: ball_1: speed 900" in r["reason"] for r in told)


def test_verified_asks_for_what_an_expectation_states_too() -> None:
    """Its events happen, yet something that it says beside them does not hold."""
    state = SceneState(SceneRequest("x"), outcome=Outcome.SOLVED)
    rows = [{"source": "suite", "kept": False}, {"source": "prompt", "kept": True}]
    assert _as_said(state, rows[1:]) and not _as_said(state, rows)
    given_up = SceneState(SceneRequest("x"), outcome=Outcome.NEAREST_FEASIBLE)
    assert not _as_said(given_up, [])


def test_errors_that_pass_are_retried_and_others_are_not(tmp_path: Path) -> None:
    build(tmp_path / "a", ["busy", "a bug"])
    assert fakes.calls().count("layout busy") == 2
    assert fakes.calls().count("layout a bug") == 1


def test_a_finished_batch_is_never_made_again(tmp_path: Path) -> None:
    first, *_ = dataset(tmp_path / "a", GOOD)
    result = make_batch(first)
    before = len(fakes.calls())
    assert make_batch(first) == result
    assert len(fakes.calls()) == before
    assert not first.work.exists()


@pytest.mark.parametrize("stage", fakes.STAGES)
def test_a_killed_batch_keeps_its_finished_stages(
    tmp_path: Path, stage: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Cut off at any stage of the second scene, resuming runs every stage of a scene once."""
    first, *_ = dataset(tmp_path / "a", GOOD)
    real = pipeline.run_stage

    def cut(name: str, state: pipeline.SceneState) -> pipeline.SceneState:
        if name == stage and state.request.prompt == GOOD[1]:
            raise KeyboardInterrupt
        return real(name, state)

    with monkeypatch.context() as patch:
        patch.setattr(module, "run_stage", cut)
        with pytest.raises(KeyboardInterrupt):
            make_batch(first)
    assert read_mark(first.out, first.number) is None
    make_batch(first)
    assert sorted(fakes.calls()) == sorted(f"{s} {p}" for s in fakes.STAGES for p in GOOD[:4])


@pytest.mark.parametrize("moment", ["write_tables", "write_mark", "finish", "info"])
def test_a_dataset_killed_while_writing_equals_an_uninterrupted_one(
    tmp_path: Path, moment: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    build(tmp_path / "whole", [*GOOD, "a bug"], mcap="all")
    jobs = dataset(tmp_path / "cut", [*GOOD, "a bug"], mcap="all")

    def stop(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    where = {
        "write_tables": "esg.store.tables.write_tables",
        "write_mark": "esg.dataset.batch.write_mark",
        "finish": "esg.dataset.card.sections.text",
        "info": "esg.store.assembling.write_info",
    }[moment]
    with monkeypatch.context() as patch:
        patch.setattr(where, stop)
        with pytest.raises(KeyboardInterrupt):
            build(tmp_path / "cut", [*GOOD, "a bug"], mcap="all")
    # What a SIGKILL in the middle of a write leaves behind.
    (tmp_path / "cut" / "parts" / "scenes").mkdir(parents=True, exist_ok=True)
    (tmp_path / "cut" / "parts" / "scenes" / ".x.parquet.1-ab.tmp").write_bytes(b"half")
    assert not DatasetFolder(tmp_path / "cut").finished()
    results = {job.number: make_batch(job) for job in jobs}
    finish(DatasetFolder(tmp_path / "cut"), jobs[0].spec, results)
    whole, cut = below(tmp_path / "whole"), below(tmp_path / "cut")
    assert whole.keys() == cut.keys()
    assert whole == cut


def test_a_dataset_killed_while_cleaning_up_is_complete(tmp_path: Path) -> None:
    build(tmp_path / "a", GOOD)
    shutil.copytree(tmp_path / "a" / "scenes", tmp_path / "a" / "parts" / "scenes")
    assert DatasetFolder(tmp_path / "a").finished()
    clean(tmp_path / "a")
    assert not (tmp_path / "a" / "parts").exists()


def test_the_order_of_batches_makes_no_difference(tmp_path: Path) -> None:
    build(tmp_path / "a", GOOD)
    jobs = dataset(tmp_path / "b", GOOD)
    results = {job.number: make_batch(job) for job in reversed(jobs)}
    finish(DatasetFolder(tmp_path / "b"), jobs[0].spec, results)
    assert below(tmp_path / "a") == below(tmp_path / "b")


def test_a_missing_or_damaged_part_is_made_again(tmp_path: Path) -> None:
    first, *_ = dataset(tmp_path / "a", GOOD)
    make_batch(first)
    part = part_files(first.out / "parts", "trajectories")[0]
    whole = part.read_bytes()
    for damage in (lambda: part.unlink(), lambda: part.write_bytes(whole[:100])):
        damage()
        assert read_mark(first.out, 0) is None
        make_batch(first)
        assert part.read_bytes() == whole


def test_a_truncated_recording_is_made_again(tmp_path: Path) -> None:
    first, *_ = dataset(tmp_path / "a", GOOD, mcap="all")
    make_batch(first)
    recording = sorted((first.out / "mcap").iterdir())[0]
    whole = recording.read_bytes()
    recording.write_bytes(whole[:3])
    assert read_mark(first.out, 0) is None
    make_batch(first)
    assert recording.read_bytes() == whole


def test_a_damaged_part_of_right_size_is_named(tmp_path: Path) -> None:
    jobs = dataset(tmp_path / "a", GOOD)
    results = {job.number: make_batch(job) for job in jobs}
    part = part_files(tmp_path / "a" / "parts", "scenes")[1]
    part.write_bytes(bytes(len(part.read_bytes())))
    with pytest.raises(UserError, match=r"batch-000001\.parquet is damaged"):
        finish(DatasetFolder(tmp_path / "a"), jobs[0].spec, results)
    assert not DatasetFolder(tmp_path / "a").finished()


def test_deadly_scenes_are_left_out(tmp_path: Path) -> None:
    first, *_ = dataset(tmp_path / "a", ["balls", "deadly", "balls 2"])
    mark_dead(first, 1, "the worker process ended twice")
    result = make_batch(first)
    assert result.outcomes == {"solved": 2, "crashed": 1}
    assert result.failures[0]["prompt"] == "deadly"
    assert "ended twice" in result.failures[0]["reason"]


@pytest.mark.parametrize(
    ("number", "remedy"), [(errno.ENOSPC, "free some space"), (errno.EROFS, "disk is read-only")]
)
def test_a_full_or_read_only_disk_is_told_and_keeps_what_is_done(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, remedy: str
) -> None:
    first, second, *_ = dataset(tmp_path / "a", GOOD)
    make_batch(first)

    def full(path: Path) -> None:
        raise OSError(number, os.strerror(number), str(path))

    with monkeypatch.context() as patch:
        patch.setattr("esg.files.sync_file", full)
        with pytest.raises(OSError, match=remedy):
            make_batch(second)
    assert read_mark(first.out, 0) is not None
    assert read_mark(first.out, 1) is None
    before = len(fakes.calls())
    make_batch(second)
    assert len(fakes.calls()) == before


def test_scenes_do_not_end_because_the_disk_was_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither crashed nor marked as done: the same batch succeeds once there is room."""
    first, *_ = dataset(tmp_path / "a", GOOD)

    def full(stage: str, state: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(tmp_path))

    with monkeypatch.context() as patch:
        patch.setattr("esg.dataset.running.run_stage", full)
        with pytest.raises(OSError, match="No space left"):
            make_batch(first)
    assert read_mark(first.out, 0) is None
    assert set(make_batch(first).outcomes) == {"solved"}


def test_folders_of_others_and_other_settings_are_refused(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("")
    spec = DatasetSpec(source="sample", n=4)
    mine = DatasetFolder(tmp_path / "mine")
    with (
        pytest.raises(UserError, match="holds files but no dataset"),
        mine.locked(Shard(index=1, count=1)),
    ):
        mine.begin(spec, [], resume=True)
    assert [p.name for p in mine.path.iterdir()] == ["thesis.txt"]
    folder = DatasetFolder(tmp_path / "a")
    folder.begin(spec, [], resume=False)
    with pytest.raises(UserError, match="add --resume"):
        folder.begin(spec, [], resume=False)
    with pytest.raises(UserError, match="seed: 1, not 0"):
        folder.begin(spec.model_copy(update={"seed": 1}), [], resume=True)
    assert folder.begin(spec, [], resume=True).run_id == spec.name()
    (tmp_path / "a" / "meta" / "plan.json").write_text("{")
    with pytest.raises(UserError, match=r"plan\.json is damaged"):
        folder.begin(spec, [], resume=True)


def test_another_version_does_not_go_on_with_a_dataset(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    spec = DatasetSpec(source="sample", n=4)
    DatasetFolder(tmp_path / "a").begin(spec, [], resume=False)
    monkeypatch.setattr("esg.codeversion.code_version", lambda stage: "other")
    with pytest.raises(UserError, match="scenes of two versions do not mix"):
        DatasetFolder(tmp_path / "a").begin(spec, [], resume=True)


def test_two_runs_on_one_shard_are_refused(tmp_path: Path) -> None:
    one, other = DatasetFolder(tmp_path), DatasetFolder(tmp_path)
    with one.locked(Shard(1, 2)):
        with (
            pytest.raises(UserError, match="another process is working"),
            other.locked(Shard(1, 2)),
        ):
            pass
        with other.locked(Shard(2, 2)):
            pass
    with other.locked(Shard(1, 2)):
        pass


def test_stages_run_in_order_for_the_whole_batch(tmp_path: Path) -> None:
    first, *_ = dataset(tmp_path / "a", GOOD)
    with pipeline.scratch_store(tmp_path / "store"):
        run_scenes(replace(first, scenes=first.scenes[:2]), Meter())
    stages_seen = [c.split()[0] for c in fakes.calls()]
    assert stages_seen == [s for s in fakes.STAGES for _ in range(2)]


def test_file_metadata_name_table_and_format(tmp_path: Path) -> None:
    build(tmp_path / "a", GOOD)
    for path in part_files(tmp_path / "a"):
        with pq.ParquetFile(path) as file:
            assert file.schema_arrow.metadata[b"esg.table"].decode() == path.parent.name


def test_near_duplicates_are_marked_or_left_out(tmp_path: Path) -> None:
    """All of them replay the same: what differs is a number in the prompt."""
    build(tmp_path / "marked", GOOD)
    build(tmp_path / "thin", GOOD, thin=True)
    marked = {str(s["scene_id"]): s for s in scenes(tmp_path / "marked")}
    kept = {name for name, s in marked.items() if s["duplicate_of"] is None}
    keys = {marked[name]["scene_key"] for name in kept}
    assert 0 < len(kept) < len(marked)
    assert {s["duplicate_of"] for s in marked.values() if s["duplicate_of"]} <= keys
    thin = {str(s["scene_id"]): str(s["scene_key"]) for s in scenes(tmp_path / "thin")}
    assert set(thin) == kept
    lines = (tmp_path / "thin" / "meta" / "duplicates.jsonl").read_text().splitlines()
    assert len(lines) == len(marked) - len(kept)
    for table in ("trajectories", "metrics", "coverage"):
        files = part_files(tmp_path / "thin", table)
        assert {k for p in files for k in read_table(p)["scene_key"].to_pylist()} <= {
            *thin.values()
        }
