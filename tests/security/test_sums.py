"""The list of a scene folder: what it was when it was written."""

from __future__ import annotations

import json
from pathlib import Path
import shutil
import subprocess

import pytest

from esg.commands.check import check
from esg.commands.export import export
from esg.commands.replay import replay
from esg.commands.report import report
from esg.strangers.sums import SUMS, differences, seal


def test_a_scene_lists_all_its_files(made: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """And is as it was written; the system's own tool agrees."""
    found = differences(made)
    assert found is not None and not found.problem and found.added == ()
    assert check(made) == 0
    assert "as it was written" in capsys.readouterr().out
    if shutil.which("sha256sum"):
        subprocess.run(["sha256sum", "--check", "--quiet", SUMS], cwd=made, check=True)


@pytest.mark.parametrize("name", ["metrics.json", "manifest.json", "prompt.txt", "unreal/*.h"])
def test_a_changed_file_is_told(name: str, scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """By every command that opens the folder, and in full by `esg check`."""
    (path,) = scene.glob(name)
    path.write_text(path.read_text("utf-8") + " ", "utf-8")
    relative = path.relative_to(scene).as_posix()
    assert check(scene, json=True) == 1
    told = json.loads(capsys.readouterr().out)
    assert told["changed"] == [relative] and told["missing"] == told["added"] == []
    assert told["class"] == ("foreign" if path.suffix == ".h" else "equal")
    replay(str(scene))
    assert f"{relative} has changed since the folder was written" in capsys.readouterr().err
    assert report(scene) == 3
    assert "has changed" in capsys.readouterr().err


def test_missing_and_added_files(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What is missing is a difference; what was added, such as a report, is only named."""
    (scene / "notes.txt").write_text("mine")
    assert check(scene) == 0
    assert "added: notes.txt" in capsys.readouterr().out
    (scene / "preview.mp4").unlink()
    assert check(scene) == 1
    assert "missing: preview.mp4" in capsys.readouterr().out


def test_an_export_into_the_folder_keeps_the_list(scene: Path) -> None:
    """What a command writes there is listed as it is now."""
    (scene / "rollout.npz").write_bytes((scene / "rollout.npz").read_bytes())
    for to in ("mjcf", "usd", "glb"):
        assert export(str(scene), to=to) == 0  # type: ignore[arg-type]
    found = differences(scene)
    assert found is not None and not found.problem


@pytest.mark.parametrize("text", ["", "x\n", "../../etc/passwd\n", "\x00" * 100])
def test_a_damaged_list_is_told(text: str, scene: Path) -> None:
    """It vouches for nothing."""
    (scene / SUMS).write_text(text)
    found = differences(scene)
    assert found is not None and SUMS in found.problem


def test_a_list_cannot_name_what_lies_outside(scene: Path, tmp_path: Path) -> None:
    """Nothing is read for it."""
    (tmp_path / "key").write_text("secret")
    with (scene / SUMS).open("a") as file:
        file.write(f"{64 * '0'}  ../key\n")
    found = differences(scene)
    assert found is not None and found.missing == ("../key",)


def test_a_folder_without_a_list_is_opened_without_a_word(
    scene: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Those of earlier versions have none, and sealing only some files makes none."""
    (scene / SUMS).unlink()
    seal(scene, [scene / "prompt.txt"])
    assert not (scene / SUMS).exists()
    replay(str(scene))
    assert capsys.readouterr().err == ""
    assert check(scene) == 0
