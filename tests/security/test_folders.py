"""Scene folders of strangers: nothing is followed out of them, nothing in them takes a run down."""

from __future__ import annotations

from collections.abc import Callable
import json
import os
from pathlib import Path
import threading
import time

import pytest

from benchmarks.faults.tampering import ODD, SECRET
from esg.commands.export import export
from esg.commands.render import render
from esg.commands.replay import replay
from esg.commands.report import report
from esg.commands.view import view
from esg.engines.base import MOST_STATES
from esg.outcomes import UserError
from esg.report.serve import serve
from esg.strangers import folders
from esg.strangers.folders import file_in, oddity
from tests.report.folders import write_scene


@pytest.fixture
def secret(tmp_path: Path) -> Path:
    (tmp_path / "home").mkdir()
    path = tmp_path / "home" / "key.txt"
    path.write_text(SECRET)
    return path


@pytest.mark.parametrize("tamper", ODD)
def test_nothing_is_followed_out_of_a_scene(
    tamper: Callable[[Path, Path], None],
    tmp_path: Path,
    secret: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One message with place and remedy; a report shows the other scenes and nothing of this."""
    run = tmp_path / "run"
    write_scene(run / "S1")
    scene = write_scene(run / "S2")
    tamper(scene, secret)
    for command in (
        lambda: view(str(scene), port=0, once=True),
        lambda: render(str(scene), out=tmp_path / "out"),
        lambda: replay(str(scene)),
        lambda: export(str(scene), to="mjcf", out=tmp_path / "out"),
    ):
        with pytest.raises(UserError) as told:
            command()
        assert str(scene) in str(told.value) and "remove it, or ask" in str(told.value)
    assert report(run) == 3
    assert SECRET not in (run / "report.html").read_text()
    assert "S2" in capsys.readouterr().err


def test_links_inside_a_scene_are_fine(tmp_path: Path) -> None:
    """And so is a scene folder that is a link itself."""
    scene = write_scene(tmp_path / "scene")
    (scene / "copy.json").symlink_to("esg.json")
    (tmp_path / "latest").symlink_to(scene)
    assert oddity(scene) == "" and oddity(tmp_path / "latest") == ""
    assert view(str(tmp_path / "latest"), port=0, once=True) == 0


def test_a_run_does_not_show_scenes_from_elsewhere(tmp_path: Path) -> None:
    """A link in a run may lead to somebody's own scenes."""
    write_scene(tmp_path / "run" / "S1")
    write_scene(tmp_path / "private" / "S9", "A prompt of nobody else's business.")
    (tmp_path / "run" / "S2").symlink_to(tmp_path / "private" / "S9")
    assert report(tmp_path / "run") == 0
    assert "nobody else" not in (tmp_path / "run" / "report.html").read_text()


@pytest.mark.parametrize("how", ["link", "pipe"])
def test_the_results_of_a_run_are_its_own(
    how: str, tmp_path: Path, secret: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Figures from elsewhere are not shown, and nobody waits for a pipe."""
    write_scene(tmp_path / "run" / "S1")
    path = tmp_path / "run" / "run.json"
    if how == "pipe":
        os.mkfifo(path)
    else:
        path.symlink_to(secret)
    assert report(tmp_path / "run") == 3
    assert "run.json is damaged (no file of this folder)" in capsys.readouterr().err


def test_a_folder_of_too_much_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By number of files, by size of one, by size of all; sparse files cost nothing to declare."""
    scene = write_scene(tmp_path / "scene")
    with (scene / "scene.glb").open("wb") as file:
        file.truncate(folders.MOST_FILE_BYTES + 1)
    assert "scene.glb has 1.0 GiB" in oddity(scene)
    (scene / "scene.glb").unlink()
    monkeypatch.setattr(folders, "MOST_FILES", 5)
    assert "more than 5 files" in oddity(scene)


@pytest.mark.parametrize(
    "path",
    ["../key.txt", "a/../../key.txt", "%2e%2e/key.txt", "link", "pipe", "", "/", ".", "a\0b",
     "/etc/passwd", "..\\key.txt", "sub", "sub/", "./esg.json"],
)  # fmt: skip
def test_no_path_leads_out_of_a_folder(path: str, tmp_path: Path) -> None:
    """Climbing, links, pipes, folders, zero bytes."""
    folder = tmp_path / "scene"
    (folder / "sub").mkdir(parents=True)
    (tmp_path / "key.txt").write_text(SECRET)
    (folder / "esg.json").write_text("{}")
    (folder / "link").symlink_to(tmp_path / "key.txt")
    os.mkfifo(folder / "pipe")
    assert file_in(folder, path) is None
    assert file_in(folder, "esg.json") == folder / "esg.json"


def test_served_files_are_kept_and_not_shown(tmp_path: Path) -> None:
    """As attachments of no type, under a policy that allows nothing; links are not served."""
    folder = tmp_path / "scene"
    folder.mkdir()
    (folder / "evil.html").write_text("<script>alert(1)</script>")
    (tmp_path / "key.txt").write_text(SECRET)
    (folder / "link.txt").symlink_to(tmp_path / "key.txt")
    os.mkfifo(folder / "pipe.txt")
    found: list[str] = []
    there = threading.Event()
    thread = threading.Thread(
        target=serve,
        args=(b"page", folder, 0, lambda url: (found.append(url), there.set())),
        kwargs={"seconds": 6},
    )
    thread.start()
    assert there.wait(5)
    status, headers = _get(found[0], "/files/evil.html")
    assert status == 200
    assert headers["Content-Disposition"].startswith("attachment")
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert headers["Content-Type"] == "application/octet-stream"
    assert "sandbox" in headers["Content-Security-Policy"]
    began = time.monotonic()
    for path in ("link.txt", "pipe.txt", "%00", "a%00b", "..%2fkey.txt", "%2e%2e/key.txt", "%ff"):
        assert _get(found[0], f"/files/{path}")[0] == 404
    assert time.monotonic() - began < 5
    assert _get(found[0], "/")[1]["X-Content-Type-Options"] == "nosniff"
    thread.join()


def _get(address: str, path: str) -> tuple[int, dict[str, str]]:
    import http.client
    from urllib.parse import urlsplit

    parts = urlsplit(address)
    assert parts.hostname
    connection = http.client.HTTPConnection(parts.hostname, parts.port, timeout=5)
    connection.request("GET", path)
    answer = connection.getresponse()
    return answer.status, dict(answer.getheaders())


def _forever(manifest: dict[str, object]) -> None:
    manifest["program"]["duration"] = 1e9  # type: ignore[index]


def _crowded(manifest: dict[str, object]) -> None:
    bodies = manifest["bodies"]
    assert isinstance(bodies, list)
    manifest["bodies"] = [{**bodies[1], "name": f"box_{i}"} for i in range(2000)]
    manifest["program"]["duration"] = MOST_STATES / 2000  # type: ignore[index]
    manifest["effective_pairs"] = manifest["watch"] = []


@pytest.mark.parametrize("much", [_forever, _crowded])
def test_a_scene_too_large_is_one_failed_scene(
    much: Callable[[dict[str, object]], None], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its card says so; the page holds the others."""
    run = tmp_path / "run"
    write_scene(run / "S1")
    scene = write_scene(run / "S2")
    (scene / "rollout.npz").unlink()
    manifest = json.loads((scene / "manifest.json").read_text())
    much(manifest)
    (scene / "manifest.json").write_text(json.dumps(manifest))
    assert report(run) == 3
    said = capsys.readouterr().err
    assert "S2" in said and "Traceback" not in said
    assert 'id="scene-1"' in (run / "report.html").read_text()
    with pytest.raises(UserError, match="more than is recorded"):
        replay(str(scene))
