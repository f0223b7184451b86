"""Damaged files of a run: named on screen and on the page, and the other scenes are shown."""

from __future__ import annotations

from collections.abc import Callable
import json
from pathlib import Path
from typing import Any

import pytest

from esg.commands.render import render
from esg.commands.report import report
from esg.commands.view import view
from esg.outcomes import UserError
from esg.report import load_run, write_report
from esg.report.run import read_scene
from esg.scenereading import read_manifest, read_rollout
from tests.disks import small_files
from tests.report.folders import rollout, write_scene

AGAIN = "run the command that made it again"


def edit(path: Path, change: Callable[[dict[str, Any]], Any]) -> None:
    """Writes a JSON file again with a change."""
    value = json.loads(path.read_bytes())
    change(value)
    path.write_text(json.dumps(value))


def cut(path: Path) -> None:
    """Keeps the first half of a file."""
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def folder(path: Path) -> None:
    """Puts a folder where the file was."""
    path.unlink()
    path.mkdir()


DAMAGE: dict[str, Callable[[Path], Any]] = {
    "cut": cut,
    "empty": lambda p: p.write_bytes(b""),
    "binary": lambda p: p.write_bytes(bytes(range(256))),
    "folder": folder,
    "list": lambda p: p.write_text("[]"),
    "text": lambda p: p.write_text('"x"'),
    "deep": lambda p: p.write_text("[" * 100_000),
    "infinite": lambda p: p.write_text('{"verdict": 1e999}'),
    "nan": lambda p: p.write_text('{"verdict": NaN}'),
}
FILES = ("metrics.json", "esg.json", "manifest.json")


def index_of(page: Path) -> dict[str, Any]:
    """What a page's list shows."""
    text = page.read_text().split('id="index">', 1)[1].split("</script>", 1)[0]
    return json.loads(text)


@pytest.mark.parametrize("how", DAMAGE)
@pytest.mark.parametrize("name", FILES)
def test_a_damaged_file_is_named_and_the_other_scene_is_shown(
    name: str, how: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """One line with file, reason and remedy on screen, the same on its card; exit code 3."""
    write_scene(tmp_path / "S1-run0")
    DAMAGE[how](write_scene(tmp_path / "S2-run0") / name)
    assert report(tmp_path) == 3
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert lines[0].startswith(f"esg: {tmp_path}/S2-run0/{name} is damaged (")
    assert AGAIN in lines[0]
    first, second = index_of(tmp_path / "report.html")["scenes"]
    assert first["problems"] == []
    assert [p.startswith(f"{name} is damaged (") for p in second["problems"]] == [True]


@pytest.mark.parametrize("how", ["cut", "empty", "binary", "folder"])
@pytest.mark.parametrize("name", ["preview.png", "rollout.npz", "prompt.txt"])
def test_pictures_recordings_and_prompts_too(
    name: str, how: str, tmp_path: Path, capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    """A cut or empty prompt is still text; a folder in its place is no scene."""
    monkeypatch.setattr(
        "esg.compile.transfer.replay_scene", lambda *_, **__: (rollout(), "program")
    )  # of a damaged recording
    write_scene(tmp_path / "S1")
    DAMAGE[how](write_scene(tmp_path / "S2") / name)
    harmless = name == "prompt.txt" and how != "binary"
    assert report(tmp_path) == (0 if harmless else 3)
    told = capsys.readouterr().err
    assert (f"S2/{name} is damaged (" in told) is not harmless
    assert len(index_of(tmp_path / "report.html")["scenes"]) == (
        1 if name == "prompt.txt" and how == "folder" else 2
    )


WRONG: dict[str, tuple[str, Callable[[dict[str, Any]], Any]]] = {
    "no verdict": ("metrics.json", lambda d: d.pop("verdict")),
    "no proof": ("metrics.json", lambda d: d.pop("proof")),
    "a text for events": ("metrics.json", lambda d: d["verdict"].update(events="x")),
    "a number for an event": ("metrics.json", lambda d: d["verdict"].update(events=[3])),
    "a text for a score": (
        "metrics.json",
        lambda d: d["verdict"]["constraints"][0].update(score="x"),
    ),
    "no object for the own timeline": ("metrics.json", lambda d: d.update(own_timeline=3)),
    "no items": ("esg.json", lambda d: d["coverage"].update(items=3)),
    "no list of stages": ("esg.json", lambda d: d.update(provenance=3)),
    "another version": ("esg.json", lambda d: d.update(schema_version="99")),
    "another version of the manifest": ("manifest.json", lambda d: d.update(version=99)),
    "an unknown shape": ("manifest.json", lambda d: d["bodies"][0].update(shapes=[{}])),
}


@pytest.mark.parametrize("what", WRONG)
def test_values_of_the_wrong_type_are_damage(
    what: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Not only files that are no JSON."""
    name, change = WRONG[what]
    edit(write_scene(tmp_path / "S1") / name, change)
    assert report(tmp_path) == 3
    assert f"S1/{name} is damaged (" in capsys.readouterr().err


def test_a_log_that_was_cut_off_says_what_it_still_knows(tmp_path: Path) -> None:
    """Its entries count, the missing end is told."""
    scene = write_scene(tmp_path / "S1", seconds=2.0)
    log = scene / "log.jsonl"
    log.write_text(log.read_text().splitlines()[0] + '\n{"outc')
    entry = read_scene(scene)
    assert entry.seconds == 2.0
    assert entry.outcome == "unfinished"
    assert [p.startswith(f"{log} is damaged (line 2 is no log entry)") for p in entry.problems]


def test_a_file_that_its_stage_wrote_and_is_gone_is_damage(tmp_path: Path) -> None:
    """A scene that was solved has a verdict."""
    scene = write_scene(tmp_path / "S1")
    (scene / "metrics.json").unlink()
    assert read_scene(scene).problems == ()  # its log does not say that a judge ran
    log = scene / "log.jsonl"
    log.write_text('{"stage": "judge", "seconds": 1.0}\n' + log.read_text())
    assert [p.startswith(f"{scene}/metrics.json is damaged (missing)") for p in
            read_scene(scene).problems] == [True]  # fmt: skip


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"totals": {"slr": "x"}}', '{"totals": {}, "scenes": [3]}']
)
def test_a_damaged_results_document_is_counted_anew(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The page's figures come from its scenes then, and it says why."""
    write_scene(tmp_path / "S1")
    (tmp_path / "run.json").write_text(text)
    assert report(tmp_path) == 3
    assert f"{tmp_path}/run.json is damaged (" in capsys.readouterr().err
    index = index_of(tmp_path / "report.html")
    assert index["totals"]["slr"] == 100.0
    assert index["problems"][0].startswith("run.json is damaged (")


def test_an_earlier_run_with_damaged_scenes_is_refused(tmp_path: Path) -> None:
    """Its figures would be too low."""
    write_scene(tmp_path / "now" / "S1")
    cut(write_scene(tmp_path / "then" / "S1") / "metrics.json")
    with pytest.raises(UserError, match=r"--against: .*then/S1/metrics.json is damaged"):
        load_run(tmp_path / "now", against=tmp_path / "then")


def test_view_shows_the_rest_and_render_refuses(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The player needs no verdict; pictures for learning need all of a scene."""
    scene = write_scene(tmp_path / "drop")
    cut(scene / "metrics.json")
    assert view(str(scene), port=0, once=True) == 3
    assert "metrics.json is damaged (not JSON" in capsys.readouterr().err
    with pytest.raises(UserError, match=r"metrics\.json is damaged"):
        render(str(scene))


def test_the_json_document_lists_the_problems(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """And stderr stays empty."""
    cut(write_scene(tmp_path / "S1") / "metrics.json")
    assert report(tmp_path, json=True) == 3
    said = capsys.readouterr()
    assert "S1/metrics.json is damaged" in json.loads(said.out)["problems"][0]
    assert said.err == ""


def test_a_recording_of_other_bodies_is_refused(tmp_path: Path) -> None:
    """It would move the wrong things."""
    scene = write_scene(tmp_path / "S1")
    bodies = len(read_manifest(scene / "manifest.json").scene.bodies)
    assert read_rollout(scene / "rollout.npz", bodies).position.shape[2] == bodies
    with pytest.raises(UserError, match="not a recording of these 3 bodies"):
        read_rollout(scene / "rollout.npz", bodies + 1)


def test_a_run_without_damage_says_nothing(tmp_path: Path) -> None:
    """And its page has no room for it."""
    write_scene(tmp_path / "S1")
    told: list[str] = []
    page = write_report(load_run(tmp_path), tmp_path / "page.html", on_problem=told.append)
    assert told == []
    assert index_of(page)["problems"] == []


def test_a_full_disk_keeps_the_report_that_was_there(tmp_path: Path) -> None:
    write_scene(tmp_path / "run" / "a")
    run, page = load_run(tmp_path / "run"), tmp_path / "page.html"
    page.write_text("old")
    with pytest.raises(UserError, match=r"cannot write .*raise the limit"), small_files(1000):
        write_report(run, page)
    assert page.read_text() == "old"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["page.html", "run"]
