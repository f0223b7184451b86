"""Stages over one scene: caching by content, outcomes, crashes that stay one scene's."""

from __future__ import annotations

from collections.abc import Iterator
import errno
import os
from pathlib import Path

import pytest

from esg import pipeline, stages
from esg.files import unwritable
from esg.outcomes import Outcome, UserError
from esg.pipeline import SceneRequest, SceneState, may_pass, recall, run_stage, scratch_store
from esg.stages import Spec


@pytest.fixture
def counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[dict[str, int]]:
    """Two small stages that count their runs: `draft` writes the prompt, `resolve` its length."""
    runs = {"draft": 0, "resolve": 0}

    def draft(state: SceneState, folder: Path) -> None:
        runs["draft"] += 1
        (folder / "esg.json").write_text(state.request.prompt)
        (folder / "violations.json").write_text("[]")

    def resolve(state: SceneState, folder: Path) -> None:
        runs["resolve"] += 1
        text = (state.artifact("draft") / "esg.json").read_text()
        if "user" in text:
            raise UserError("no such thing")
        if "bug" in text:
            raise ZeroDivisionError("a defect")
        if "busy" in text:
            raise ConnectionResetError("try again")
        (folder / "esg.json").write_text(str(len(text)))

    monkeypatch.setitem(stages.SPECS, "draft", Spec(draft, (), ("prompt", "seed")))
    monkeypatch.setitem(stages.SPECS, "resolve", Spec(resolve, ("draft",), ()))
    monkeypatch.setattr(pipeline, "STAGES", ("draft", "resolve"))
    with scratch_store(tmp_path / "store"):
        yield runs


def both(request: SceneRequest) -> SceneState:
    state = SceneState(request)
    for stage in ("draft", "resolve"):
        state = run_stage(stage, state)
    return state


def test_second_run_computes_nothing(counted: dict[str, int]) -> None:
    first, second = both(SceneRequest("abc")), both(SceneRequest("abc"))
    assert counted == {"draft": 1, "resolve": 1}
    assert first.artifacts == second.artifacts
    assert (first.cached_stages, second.cached_stages) == (0, 2)


def test_equal_content_is_shared_downstream(counted: dict[str, int]) -> None:
    """Another seed that drafts the same document needs no new resolve."""
    both(SceneRequest("abc", seed=1))
    second = both(SceneRequest("abc", seed=2))
    assert counted == {"draft": 2, "resolve": 1}
    assert second.cached_stages == 1


def test_code_change_invalidates_its_stage_only(
    counted: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    both(SceneRequest("abc"))
    monkeypatch.setattr("esg.codeversion.code_version", lambda stage: f"{stage}-edited")
    both(SceneRequest("abc"))
    assert counted == {"draft": 2, "resolve": 2}


def test_user_errors_end_the_scene_without_traceback(counted: dict[str, int]) -> None:
    state = both(SceneRequest("user"))
    assert state.outcome is Outcome.INVALID_DRAFT
    assert state.user_error
    assert state.reason == "no such thing"
    assert "traceback" not in state.log[-1]


def test_defects_end_the_scene_with_traceback(counted: dict[str, int]) -> None:
    state = both(SceneRequest("bug"))
    assert state.outcome is Outcome.CRASHED
    assert "ZeroDivisionError" in state.log[-1]["traceback"]
    assert "resolve" not in state.artifacts
    assert run_stage("layout", state) is state


def test_passing_errors_are_raised_for_a_retry(counted: dict[str, int]) -> None:
    with pytest.raises(ConnectionResetError):
        both(SceneRequest("busy"))


def test_only_errors_that_may_pass_are_retried() -> None:
    assert may_pass(TimeoutError())
    assert may_pass(OSError(11, "again"))
    assert not may_pass(OSError(28, "no space left"))
    assert not may_pass(FileNotFoundError(2, "gone"))
    assert not may_pass(ValueError())


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EROFS, errno.EACCES])
def test_a_disk_that_cannot_be_written_is_no_defect(
    counted: dict[str, int], monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    def full(state: SceneState, folder: Path) -> None:
        raise OSError(number, os.strerror(number), str(folder / "x"))

    monkeypatch.setitem(stages.SPECS, "draft", Spec(full, (), ("prompt",)))
    with pytest.raises(OSError, match="; ") as told:
        pipeline.run_stage("draft", SceneState(SceneRequest("a")))
    assert "choose a" in str(told.value)


def test_a_refused_connection_is_not_a_disk_that_cannot_be_written() -> None:
    assert not unwritable(PermissionError(errno.EACCES, "Permission denied"))
    assert unwritable(PermissionError(errno.EACCES, "Permission denied", "/x"))


def test_violations_make_an_invalid_draft(
    counted: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    def draft(state: SceneState, folder: Path) -> None:
        (folder / "esg.json").write_text("{}")
        found = '[{"code": "CYCLE", "message": "a cycle"}, {"code": "X", "message": "y"}]'
        (folder / "violations.json").write_text(found)

    monkeypatch.setitem(stages.SPECS, "draft", Spec(draft, (), ("prompt",)))
    state = both(SceneRequest("abc"))
    assert state.outcome is Outcome.INVALID_DRAFT
    assert state.reason == "CYCLE: a cycle (and 1 more)"
    assert not state.user_error
    assert counted["resolve"] == 0


def test_recall_finds_whole_scenes_only(counted: dict[str, int]) -> None:
    request = SceneRequest("abc")
    assert recall(request) is None
    run_stage("draft", SceneState(request))
    assert recall(request) is None
    both(request)
    before = dict(counted)
    found = recall(request)
    assert found is not None
    assert found.cached_stages == 2
    assert counted == before


def test_damaged_artifact_is_computed_again(counted: dict[str, int]) -> None:
    state = both(SceneRequest("abc"))
    (state.artifact("resolve") / "esg.json").write_text("999")
    again = both(SceneRequest("abc"))
    assert counted["resolve"] == 2
    assert (again.artifact("resolve") / "esg.json").read_text() == "3"
