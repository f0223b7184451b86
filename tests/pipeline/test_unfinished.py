"""Folders whose pictures follow: who needs them waits, and is told when they never come."""

from __future__ import annotations

from collections.abc import Iterator
import json
import os
from pathlib import Path
import subprocess
import sys
import threading
import time

import pytest

from esg.outcomes import UserError
from esg.report.run import load_run
from esg.scenefolder import unfinished
from esg.scenefolder.unfinished import all_settled, announce, give_up, read, settled
from esg.strangers.sums import FINISHING, SUMS, digests, seal

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="processes are found in /proc")
PICTURES = ("preview.mp4", "preview.png")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A scene folder whose pictures this process draws."""
    path = tmp_path / "scene"
    path.mkdir()
    (path / "prompt.txt").write_text("A ball.\n")
    (path / "log.jsonl").write_text(json.dumps({"outcome": "solved", "reason": ""}) + "\n")
    announce(path, PICTURES)
    return path


@pytest.fixture
def ended() -> Iterator[int]:
    """The number of a process that has ended and is not waited for yet."""
    process = subprocess.Popen([sys.executable, "-c", ""])
    while Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z":
        time.sleep(0.01)
    yield process.pid
    process.wait()


def changed(folder: Path, **values: object) -> None:
    path = folder / FINISHING
    path.write_text(json.dumps(json.loads(path.read_text()) | values))


def test_the_mark_tells_who_draws_what(folder: Path) -> None:
    mark = read(folder)
    assert mark is not None
    assert (mark.pid, mark.files, mark.failed) == (os.getpid(), PICTURES, "")


def test_the_mark_is_no_file_of_the_scene(folder: Path) -> None:
    assert set(digests(folder)) == {"prompt.txt", "log.jsonl"}


def test_who_needs_the_pictures_waits_and_says_so(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    timer = threading.Timer(0.3, lambda: seal(folder))
    start = time.monotonic()
    timer.start()
    assert settled(folder) == ""
    assert time.monotonic() - start >= 0.25
    told = capsys.readouterr().err.splitlines()
    assert told == [
        f"esg: waiting for preview.mp4 and preview.png of {folder}, which process {os.getpid()} "
        "draws"
    ]


def test_a_finished_folder_is_not_waited_for(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    seal(folder)  # the mark has been left behind
    assert settled(folder) == ""
    (folder / FINISHING).unlink()
    assert settled(folder) == ""
    assert capsys.readouterr().err == ""


def test_nobody_waits_for_ever(folder: Path) -> None:
    assert f"process {os.getpid()} still draws them" in settled(folder, 0.1)
    start = time.monotonic()
    assert len(all_settled([folder] * 8, 1.0)) == 8
    assert time.monotonic() - start < 6.0  # one second for all of them, not one each


def test_a_process_that_has_ended_is_not_waited_for(folder: Path, ended: int) -> None:
    changed(folder, pid=ended)
    told = settled(folder)
    assert "lacks preview.mp4 and preview.png: the process that drew them has ended" in told
    assert "run the command that made it again" in told


def test_another_process_of_the_same_number_is_not_waited_for(folder: Path) -> None:
    changed(folder, started=1)
    assert "has ended" in settled(folder)


def test_a_process_of_another_machine_is_waited_for_while_it_may_live(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    changed(folder, place="elsewhere")
    assert "still draws them" in settled(folder, 0.1)
    os.utime(folder / FINISHING, (0, 0))
    assert "has ended" in settled(folder, 0.1)


def test_why_pictures_failed_is_told(folder: Path) -> None:
    give_up(folder, "No space left on device; free\nsome space")
    told = settled(folder)
    assert told.startswith(f"{folder} lacks preview.mp4 and preview.png: No space left on device")
    assert "\n" not in told


def test_a_damaged_mark_holds_nobody_up(folder: Path) -> None:
    for text in ("", "{", "[]", '{"pid": "x"}', "[" * 5000, " " * 100_000):
        (folder / FINISHING).write_text(text)
        assert "its mark cannot be read" in settled(folder)


def test_a_report_waits_and_names_what_never_comes(folder: Path, ended: int) -> None:
    changed(folder, pid=ended)
    assert any("the process that drew them has ended" in p for p in load_run(folder).problems)
    seal(folder)
    assert not any("lacks" in p for p in load_run(folder).problems)


def test_commands_wait_but_for_replays(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A replay reads what is finished, and must not be slowed by pictures."""
    from esg.api.inputs import find_scene
    from esg.api.scene import Scene
    from esg.commands.check import folder_facts
    from esg.commands.replay import replay
    from esg.commands.stored import open_scene
    from esg.study.clips import find_clips

    monkeypatch.setattr(unfinished.settled, "__defaults__", (0.1,))
    monkeypatch.setattr(unfinished.all_settled, "__defaults__", (0.1,))
    waiting = "waiting for preview.mp4"

    def heard() -> str:
        return capsys.readouterr().err

    find_scene(str(folder))
    assert waiting in heard()
    Scene.load(folder)
    assert waiting in heard()
    with open_scene(str(folder)):
        assert waiting in heard()
    assert "still draws them" in folder_facts(folder)["problem"]
    assert waiting in heard()
    with pytest.raises(UserError, match="no scene has a film"):
        find_clips(folder.parent.parent, [folder.parent.name], 0, 0)
    assert waiting in heard()
    with pytest.raises(UserError, match="no compiled scene"):
        replay(str(folder))
    assert waiting not in heard()
    assert not (folder / SUMS).exists()
