"""A scene that is answered for first: what its folder holds then, and how it is completed."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
import contextlib
import errno
import json
import os
from pathlib import Path
import shutil
import sys
from typing import Any

import pytest

from esg import stages
from esg.alone import finishing, guarded
from esg.alone.finishing import finish, may_follow
from esg.limits import taken
from esg.machine import answering
from esg.machine.beside import forking
from esg.outcomes import Outcome, UserError
from esg.pipeline import (
    STAGES,
    SceneRequest,
    SceneState,
    Unfinished,
    artifact_store,
    begin_record,
    run_stage,
    scratch_store,
)
from esg.scenefolder import Owed, publish, publish_unfinished
from esg.scenefolder.unfinished import read, settled
from esg.strangers.sums import FINISHING, SUMS, Differences, differences
from tests.pipeline.filled import stages_done

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="folders are followed in /proc")
FILES = {
    "draft": {
        "esg.json": json.dumps({"scene_definition": {"scene_id": "a scene"}}),
        "violations.json": "[]\n",
    },
    "compile": {"manifest.json": "{}"},
    "judge": {"metrics.json": "{}"},
    "dress": {"esg.json": "{}"},
    "replay": {"rollout.npz": "frames", "replay.json": "{}"},
}


@contextlib.contextmanager
def record(
    state: SceneState, folder: Path, *, later: bool = False
) -> Generator[Callable[[], object]]:
    """Stands in for `recording`: its film is begun when the exports are there."""
    (folder / "textures").mkdir()
    (folder / "textures" / "wood.png").write_text("wood")
    (folder / "scene.glb").write_text("glb")
    (folder / "preview.partial.mp4").write_text("fil")

    def draw() -> None:
        (folder / "preview.partial.mp4").rename(folder / "preview.mp4")
        (folder / "preview.mp4").write_text("film")
        (folder / "preview.png").write_text("sheet")

    yield draw


@pytest.fixture
def state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[SceneState]:
    """A scene whose record comes next."""
    monkeypatch.setattr(stages, "recording", record)
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "cache"))
    with stages_done(tmp_path / "store", FILES) as scene:
        yield scene


@pytest.fixture
def begun(state: SceneState, tmp_path: Path) -> tuple[Unfinished, Owed]:
    """It has been answered for."""
    _, rest = begin_record(state)
    assert rest is not None
    return rest, publish_unfinished(rest, tmp_path / "out")


def tree(folder: Path) -> dict[str, bytes]:
    return {
        p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()
    }


def done(rest: Unfinished, owed: Owed) -> None:
    finish(rest, owed, contextlib.ExitStack())


def test_all_but_pictures_and_list_are_there_with_the_answer(
    begun: tuple[Unfinished, Owed], state: SceneState, tmp_path: Path
) -> None:
    whole = publish(run_stage("record", state), tmp_path / "whole")
    there = tree(begun[1].folder)
    assert set(tree(whole)) - set(there) == {"preview.mp4", "preview.png", SUMS}
    assert set(there) - set(tree(whole)) == {FINISHING}
    assert all(data == there[name] for name, data in tree(whole).items()
               if name in there and name != "log.jsonl")  # fmt: skip


def test_the_end_is_that_of_a_scene_made_in_one_go(
    begun: tuple[Unfinished, Owed], state: SceneState, tmp_path: Path
) -> None:
    rest, owed = begun
    done(rest, owed)
    finished = run_stage("record", state)
    assert finished.log[-1]["cached"]
    ours, whole = tree(owed.folder), tree(publish(finished, tmp_path / "whole"))
    assert set(ours) == set(whole)
    assert {n for n in ours if ours[n] != whole[n]} == {SUMS, "log.jsonl"}
    assert differences(owed.folder) == Differences()
    stage, end = map(json.loads, (owed.folder / "log.jsonl").read_text().splitlines()[-2:])
    assert stage["stage"] == "record"
    assert not stage["cached"]
    assert end == {"outcome": "solved", "reason": ""}
    assert not list((artifact_store().root / "tmp").iterdir())


def test_no_name_of_a_picture_ever_stands_for_half_of_it(
    begun: tuple[Unfinished, Owed], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every file comes by a rename, the list last."""
    rest, owed = begun
    seen: list[str] = []
    replace = os.replace

    def watched(source: Path, target: Path) -> None:
        if Path(target).parent == owed.here:
            seen.append(Path(target).name)
            assert Path(source).name.endswith(".tmp")
        replace(source, target)

    monkeypatch.setattr(os, "replace", watched)
    done(rest, owed)
    assert seen == ["preview.mp4", "preview.png", "log.jsonl", SUMS]
    assert read(owed.folder) is None
    assert not (owed.folder / FINISHING).exists()


def test_a_folder_that_is_moved_is_finished_where_it_is(
    begun: tuple[Unfinished, Owed], tmp_path: Path
) -> None:
    rest, owed = begun
    moved = owed.folder.rename(tmp_path / "elsewhere")
    done(rest, owed)
    assert differences(moved) == Differences()
    assert (moved / "preview.png").read_text() == "sheet"
    assert not owed.folder.exists()


def test_a_folder_that_is_deleted_stays_so(begun: tuple[Unfinished, Owed]) -> None:
    rest, owed = begun
    shutil.rmtree(owed.folder)
    with pytest.raises(OSError, match="No such file"):
        done(rest, owed)
    assert not owed.folder.exists()
    assert artifact_store().find(rest.state.artifacts["record"]) is not None


def test_what_a_user_changes_meanwhile_is_told(begun: tuple[Unfinished, Owed]) -> None:
    rest, owed = begun
    (owed.folder / "manifest.json").write_text("[]")
    (owed.folder / "notes.txt").write_text("mine")
    done(rest, owed)
    assert differences(owed.folder) == Differences(changed=("manifest.json",), added=("notes.txt",))


def test_a_full_disk_is_told_in_the_mark(
    begun: tuple[Unfinished, Owed], monkeypatch: pytest.MonkeyPatch
) -> None:
    rest, owed = begun
    replace = os.replace

    def full(source: Path, target: Path) -> None:
        if Path(target).name == "preview.png" and Path(target).parent == owed.here:
            raise OSError(errno.ENOSPC, "No space left on device", str(target))
        replace(source, target)

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(OSError, match="No space left"):
        done(rest, owed)
    assert "No space left on device; free some space" in settled(owed.folder)
    assert not (owed.folder / SUMS).exists()
    assert not list(owed.folder.glob(".*.tmp"))


def test_a_picture_that_cannot_be_drawn_is_told_and_stores_nothing(
    begun: tuple[Unfinished, Owed], monkeypatch: pytest.MonkeyPatch
) -> None:
    rest, owed = begun

    def fail() -> None:
        raise RuntimeError("no light")

    monkeypatch.setattr(rest, "_draw", fail)
    with pytest.raises(RuntimeError):
        done(rest, owed)
    assert "RuntimeError: no light; run the command that made it again" in settled(owed.folder)
    assert artifact_store().find(rest.state.artifacts["record"]) is None
    assert not list((artifact_store().root / "tmp").iterdir())


def test_a_process_that_is_told_to_end_says_so(
    begun: tuple[Unfinished, Owed], monkeypatch: pytest.MonkeyPatch
) -> None:
    rest, owed = begun

    def terminated() -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(rest, "_draw", terminated)
    with pytest.raises(KeyboardInterrupt):
        done(rest, owed)
    assert "was told to end; run the command that made it again" in settled(owed.folder)


def test_a_picture_that_takes_too_long_is_told(
    begun: tuple[Unfinished, Owed], monkeypatch: pytest.MonkeyPatch
) -> None:
    rest, owed = begun

    def hang() -> None:
        while True:
            pass

    monkeypatch.setenv("ESG_STAGE_SECONDS", "0.2")
    monkeypatch.setattr(rest, "_draw", hang)
    with pytest.raises(BaseException, match="ESG_STAGE_SECONDS"):
        done(rest, owed)
    assert "record ran longer than its limit" in settled(owed.folder)


def test_what_is_dropped_leaves_nothing(state: SceneState) -> None:
    _, rest = begin_record(state)
    assert rest is not None
    rest.drop()
    assert artifact_store().find(rest.state.artifacts["record"]) is None
    assert not list((artifact_store().root / "tmp").iterdir())


def test_exports_that_fail_end_the_scene_as_ever(
    state: SceneState, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(state: SceneState, folder: Path, *, later: bool = False) -> None:
        raise RuntimeError("no mesh")

    monkeypatch.setattr(stages, "recording", fail)
    ended, rest = begin_record(state)
    assert rest is None
    assert (ended.outcome, ended.reason) == (Outcome.CRASHED, "RuntimeError: no mesh")
    assert not list((artifact_store().root / "tmp").iterdir())


def test_a_record_in_the_store_leaves_nothing_to_be_done(state: SceneState) -> None:
    finished = run_stage("record", state)
    ended, rest = begin_record(state)
    assert rest is None
    assert ended.artifacts == finished.artifacts


def test_the_folder_is_replaced_only_once_nobody_writes_into_it(
    begun: tuple[Unfinished, Owed], state: SceneState, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    rest, owed = begun
    monkeypatch.setattr("esg.scenefolder.unfinished.time.sleep", lambda _: done(rest, owed))
    publish(run_stage("record", state), tmp_path / "out")
    assert "waiting for preview.mp4 and preview.png" in capsys.readouterr().err
    assert differences(owed.folder) == Differences()
    assert [p.name for p in (tmp_path / "out").iterdir()] == [owed.folder.name]


def follows(state: SceneState, out: Path) -> bool:
    with contextlib.ExitStack() as held:
        return may_follow(state, out, held)


def test_pictures_follow_where_somebody_draws_them(
    state: SceneState, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert not follows(state, tmp_path / "out")
    monkeypatch.setattr(finishing, "can_go_on", lambda: True)
    assert follows(state, tmp_path / "out")
    with contextlib.ExitStack() as held:  # as many scenes as there are cores are being finished
        while taken(finishing.PLACE, finishing.usable_cores(), held):
            pass
        assert not follows(state, tmp_path / "out")
    assert follows(state, tmp_path / "out")


def test_what_was_begun_and_never_finished_is_made_before_the_answer(
    begun: tuple[Unfinished, Owed], state: SceneState, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.setattr(finishing, "can_go_on", lambda: True)
    rest, owed = begun
    monkeypatch.setattr(rest, "_draw", lambda: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        done(rest, owed)
    assert not follows(state, tmp_path / "out")
    assert differences(publish(run_stage("record", state), tmp_path / "out")) == Differences()


def test_stages_before_the_record_are_those_of_any_run(
    state: SceneState, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The question whether pictures may follow is asked when the answer is known."""
    seen: list[str] = []

    def run(stage: str, before: SceneState) -> SceneState:
        seen.append(stage)
        return state

    monkeypatch.setattr(guarded, "run_stage", run)
    _, rest = guarded.begin_guarded(state.request, lambda _: bool(seen.append("asked")))
    assert rest is None
    assert seen == [*STAGES[:-1], "asked", STAGES[-1]]
    seen.clear()
    _, rest = guarded.begin_guarded(state.request, lambda _: True)
    assert rest is not None
    assert seen == list(STAGES[:-1])
    rest.drop()


def generated(state: SceneState, out: Path, monkeypatch: pytest.MonkeyPatch, **options: Any) -> int:
    """`esg generate` of a scene whose record comes next; its exit code."""
    from esg.commands import generate as command

    def recalled(request: SceneRequest) -> None:
        return None

    def recorded(states: list[SceneState], kind: str) -> str:
        return kind

    monkeypatch.setattr(command, "_recalled", recalled)
    monkeypatch.setattr("esg.runs.record_run", recorded)
    monkeypatch.setattr(guarded, "run_stage",
                        lambda stage, before: run_stage(stage, state))  # fmt: skip
    return command.generate("A ball.", out=out, strategy="none", **options)


def test_generate_answers_first_where_it_may(
    state: SceneState, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    out = tmp_path / "out"
    monkeypatch.setattr(answering._here, "possible", True)
    monkeypatch.setattr(answering._here, "left", [])
    assert generated(state, out, monkeypatch, json=True) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["finishing"] == ["preview.mp4", "preview.png"]
    assert not (Path(told["folder"]) / SUMS).exists()
    (work,) = answering._here.left
    work()
    assert differences(Path(told["folder"])) == Differences()


def test_generate_says_how_to_wait(
    state: SceneState, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.setattr(answering._here, "possible", True)
    monkeypatch.setattr(answering._here, "left", [])
    assert generated(state, tmp_path / "out", monkeypatch) == 0
    assert "preview.mp4 and preview.png follow (--wait waits" in capsys.readouterr().out
    (work,) = answering._here.left
    work()


@pytest.mark.parametrize(("possible", "wait"), [(False, None), (False, False), (True, True)])
def test_generate_ends_with_the_whole_folder(
    state: SceneState, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str], possible: bool, wait: bool | None,
) -> None:  # fmt: skip
    """Without somebody who draws later, whatever is asked for; and where that is asked for."""
    monkeypatch.setattr(answering._here, "possible", possible)
    monkeypatch.setattr(answering._here, "left", [])
    assert generated(state, tmp_path / "out", monkeypatch, json=True, wait=wait) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["finishing"] == []
    assert differences(Path(told["folder"])) == Differences()
    assert not answering._here.left


def test_a_folder_that_cannot_be_written_leaves_nothing_to_be_done(
    state: SceneState, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(answering._here, "possible", True)
    monkeypatch.setattr(answering._here, "left", [])
    mine = tmp_path / "out" / "a_scene"
    mine.mkdir(parents=True)
    (mine / "thesis.txt").touch()
    with pytest.raises(UserError, match="not a scene folder"):
        generated(state, tmp_path / "out", monkeypatch)
    assert not answering._here.left
    assert not list((artifact_store().root / "tmp").iterdir())


def test_a_real_scene_has_the_same_bytes_either_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Exports, film and sheet, drawn in one go or in two with forks beside."""
    monkeypatch.setattr("esg.machine.beside.usable_cores", lambda: 2)
    state = SceneState(SceneRequest("A ball hits a box.", strategy="none"))
    with scratch_store(tmp_path / "one", durable=False):
        for stage in STAGES[:-1]:
            state = run_stage(stage, state)
        shutil.copytree(tmp_path / "one", tmp_path / "two")
        whole = tree(publish(run_stage("record", state), tmp_path / "whole"))
    with scratch_store(tmp_path / "two", durable=False), forking():
        _, rest = begin_record(state)
        assert rest is not None
        owed = publish_unfinished(rest, tmp_path / "out")
        done(rest, owed)
    ours = tree(owed.folder)
    assert {"preview.mp4", "preview.png", "scene.usda", "scene.glb"} <= set(ours)
    assert set(ours) == set(whole)
    assert {n for n in ours if ours[n] != whole[n]} <= {SUMS, "log.jsonl"}
