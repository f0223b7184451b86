"""Scene folders appear whole or not at all."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
import json
from pathlib import Path
import re

import pytest

from esg import scenefolder
from esg.outcomes import UserError
from esg.pipeline import SceneState
from esg.scenefolder import check_writable, folder_name, is_scene_folder, publish, safe_name
from esg.strangers.sums import SUMS, Differences, differences
from tests.disks import small_files
from tests.pipeline.filled import stages_done


@pytest.fixture
def state(tmp_path: Path) -> Iterator[SceneState]:
    """A scene whose draft and judge have run."""
    files = {
        "draft": {
            "esg.json": json.dumps({"scene_definition": {"scene_id": "a scene/1"}}),
            "violations.json": "[]\n",
        },
        "judge": {"metrics.json": "{}"},
    }
    with stages_done(tmp_path / "store", files) as scene:
        yield scene


def test_folder_is_named_after_the_scene_and_safe(state: SceneState) -> None:
    assert folder_name(state) == "a_scene_1"


def test_no_name_leaves_the_folder_it_is_for() -> None:
    from esg.commands.bench import _usual_folder

    for name in ("../../x", "a/b", "..", "my suite", "日本", "a\\b\n"):
        assert _usual_folder(name, "none", "physx", False, "exact").parent == Path("runs")
        assert re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*|", safe_name(name))
    assert safe_name("paper") == "paper"


def test_publishes_documents_log_and_prompt(state: SceneState, tmp_path: Path) -> None:
    folder = publish(state, tmp_path / "out")
    names = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}
    listed = {"prompt.txt", "esg.json", "stages/1-draft.json", "metrics.json", "log.jsonl"}
    assert names == {*listed, SUMS}
    assert differences(folder) == Differences()
    assert (folder / "prompt.txt").read_text() == "A ball.\n"
    last = json.loads((folder / "log.jsonl").read_text().splitlines()[-1])
    assert last == {"outcome": "solved", "reason": ""}


def test_replaces_an_older_folder_of_the_scene(state: SceneState, tmp_path: Path) -> None:
    folder = publish(state, tmp_path / "out")
    (folder / "stale.txt").write_text("old")
    publish(state, tmp_path / "out")
    assert not (folder / "stale.txt").exists()
    assert [p.name for p in (tmp_path / "out").iterdir()] == [folder.name]


def test_never_replaces_a_folder_of_the_users(state: SceneState, tmp_path: Path) -> None:
    mine = tmp_path / "out" / "a_scene_1"
    mine.mkdir(parents=True)
    (mine / "thesis.txt").write_text("precious")
    with pytest.raises(UserError, match="not a scene folder"):
        publish(state, tmp_path / "out")
    assert (mine / "thesis.txt").read_text() == "precious"


def test_failure_leaves_the_old_folder_and_no_rest(
    state: SceneState, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = publish(state, tmp_path / "out")
    before = (folder / "log.jsonl").read_bytes()

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(scenefolder, "_copy", full)
    with pytest.raises(UserError, match="No space left"):
        publish(state, tmp_path / "out")
    assert (folder / "log.jsonl").read_bytes() == before
    assert [p.name for p in (tmp_path / "out").iterdir()] == [folder.name]


def test_commands_that_publish_one_scene_at_once_do_not_disturb_each_other(
    state: SceneState, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    with ThreadPoolExecutor(8) as pool:
        folders = set(pool.map(lambda _: publish(state, out), range(80)))
    assert [p.name for p in out.iterdir()] == [folder.name for folder in folders]
    assert is_scene_folder(folders.pop())


def test_a_folder_that_cannot_be_put_into_place_leaves_the_old_one(
    state: SceneState, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = publish(state, tmp_path / "out")
    rename = Path.rename

    def refuse(self: Path, target: Path) -> Path:
        if Path(target) == folder and self.name != "old":
            raise PermissionError(13, "Permission denied", str(target))
        return rename(self, target)

    monkeypatch.setattr(Path, "rename", refuse)
    with pytest.raises(UserError, match="Permission denied"):
        publish(state, tmp_path / "out")
    assert is_scene_folder(folder)
    assert [p.name for p in (tmp_path / "out").iterdir()] == [folder.name]


def test_check_writable_leaves_no_trace(tmp_path: Path) -> None:
    check_writable(tmp_path / "a" / "b")
    assert list(tmp_path.iterdir()) == []


def test_check_writable_names_the_obstacle(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(UserError, match="is not a folder"):
        check_writable(tmp_path / "file" / "runs")


def test_other_folders_are_no_scene_folders(tmp_path: Path) -> None:
    assert not is_scene_folder(tmp_path)
    assert not is_scene_folder(tmp_path / "missing")


def test_a_full_disk_keeps_the_scene_that_was_there(state: SceneState, tmp_path: Path) -> None:
    folder = publish(state, tmp_path / "out")
    (folder / "mine.txt").write_text("kept")
    with (
        pytest.raises(UserError, match=r"cannot write .*raise the limit") as told,
        small_files(5),
    ):
        publish(state, tmp_path / "out")
    assert told.value.exit_code == 1
    assert [p.name for p in (tmp_path / "out").iterdir()] == [folder.name]
    assert (folder / "mine.txt").read_text() == "kept"
