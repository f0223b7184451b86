"""A scene made, read, judged, replayed and exported from Python."""

from __future__ import annotations

from collections.abc import Iterator
import json
from pathlib import Path
import shutil
import subprocess
import sys

import numpy as np
from PIL import Image
import pytest

import esg
from esg.engines.scene import GROUND

PROMPT = "A ball rolls into a box."
ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Iterator[esg.Scene]:
    folder = tmp_path_factory.mktemp("api")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ESG_CACHE_DIR", str(folder / "cache"))
        yield esg.generate(PROMPT, seed=3, out=folder / "runs")


def test_importing_costs_no_heavy_library() -> None:
    heavy = ("warp", "newton", "spacy", "sapien", "pxr", "prefect", "numpy", "pydantic")
    code = f"import sys, esg; dir(esg); print([m for m in {heavy} if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=True
    )
    assert done.stdout.strip() == "[]"


def test_every_public_name_is_there_and_says_what_it_is() -> None:
    for name in esg.__all__:
        assert name.startswith("__") or getattr(esg, name).__doc__, name
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = esg.nothing  # type: ignore[attr-defined]  # what a typo meets


def test_a_scene_says_what_was_asked_and_what_came_of_it(scene: esg.Scene) -> None:
    assert (scene.prompt, scene.seed) == (PROMPT, 3)
    assert scene.outcome is esg.Outcome.SOLVED and scene.verified and scene.plausible
    assert scene.graph.scene_definition.original_description == PROMPT
    assert [e.completed for e in scene.events] == [True]
    assert scene.not_kept == [] and scene.advice
    assert scene == esg.Scene.load(scene.folder) == esg.Scene.load(str(scene.folder))


def test_trajectories_hold_together(scene: esg.Scene) -> None:
    motion = scene.trajectories
    frames, bodies = len(motion.time), len(motion.names)
    assert motion.position.shape == (frames, bodies, 3)
    assert motion.quaternion.shape == (frames, bodies, 4)
    ball = motion.of("ball_1")
    assert np.allclose(np.linalg.norm(ball.quaternion, axis=-1), 1.0, atol=1e-4)
    # Velocities are those of the positions.
    moved = np.diff(ball.position[:10], axis=0) / np.diff(ball.time[:10])[:, None]
    assert np.allclose(moved, ball.linear_velocity[1:10], atol=0.05)
    assert np.isclose(ball.speed[5], np.linalg.norm(ball.linear_velocity[5]))
    with pytest.raises(esg.UserError, match=r"no body 'cube'.*ball_1"):
        motion.of("cube")


def test_contacts_name_who_touched_whom_when_the_verdict_says(scene: esg.Scene) -> None:
    touched = [c for c in scene.trajectories.contacts if {"ball_1", "box_1"} == {c.a, c.b}]
    event = scene.events[0]
    assert event.time_s is not None
    assert touched[0].time_s == pytest.approx(event.time_s, abs=0.02)
    assert touched[0].impulse_ns > 0.0
    assert all(c.a != GROUND for c in scene.trajectories.contacts)


def test_judging_the_recorded_replay_again_gives_the_same_verdict(scene: esg.Scene) -> None:
    assert esg.judge(scene) == scene.verdict
    assert esg.judge(scene.folder) == scene.verdict


def test_a_replay_elsewhere_is_judged_by_the_same_timeline(scene: esg.Scene) -> None:
    again = scene.replay("rapier")
    assert (again.engine, again.proof) == ("rapier", "program")
    assert [e.type for e in again.verdict.events] == [e.type for e in scene.events]
    assert again.verdict.verified
    assert again.trajectories.names == scene.trajectories.names


def test_an_export_lies_where_it_was_asked_for(scene: esg.Scene, tmp_path: Path) -> None:
    files = scene.export("mjcf", tmp_path)
    assert files and all(f.is_relative_to(tmp_path) and f.is_file() for f in files)


def test_pictures_lie_where_they_were_asked_for(scene: esg.Scene, tmp_path: Path) -> None:
    """Of the size and channels that were asked for, and all mistakes at once."""
    folder = scene.render("depth,segmentation", tmp_path / "seen", size="32x24", fps=4.0)
    manifest = json.loads((folder / "manifest.json").read_bytes())
    assert folder == tmp_path / "seen" and set(manifest["channels"]) == {"depth", "segmentation"}
    pictures = [path for path in folder.rglob("*.png") if path.name != "sheet.png"]
    assert len(pictures) >= 4
    with Image.open(pictures[0]) as picture:
        assert picture.size == (32, 24)
    with pytest.raises(esg.UserError) as told:
        scene.render("smell", size="huge", camera="behind")
    assert all(word in str(told.value) for word in ("smell", "huge", "behind"))


def test_a_notebook_shows_prompt_outcome_and_pictures(scene: esg.Scene) -> None:
    page = scene._repr_html_()
    assert PROMPT in page and "solved" in page and "data:video/mp4;base64," in page


def test_many_are_made_in_order_and_the_same_as_one(
    scene: esg.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ESG_CACHE_DIR", str(scene.folder.parents[1] / "cache"))
    prompts = [PROMPT, "A box and a ball stand on a table."]
    made = list(esg.generate_many(prompts, 3, out=tmp_path, workers=2))
    assert [s.prompt for s in made] == prompts
    for name in ("esg.json", "manifest.json", "metrics.json"):
        assert (made[0].folder / name).read_bytes() == (scene.folder / name).read_bytes()


def test_all_mistakes_are_told_before_any_work(tmp_path: Path) -> None:
    with pytest.raises(esg.UserError) as told:
        esg.generate_many(["", "A ball rolls."], -1, out=tmp_path / "runs", device="gpu")
    for part in ("3 problems", "the prompt is empty", "seed -1", "'gpu'"):
        assert part in str(told.value)
    assert not (tmp_path / "runs").exists()


def test_what_is_missing_is_told(scene: esg.Scene, tmp_path: Path) -> None:
    with pytest.raises(esg.UserError, match="no scene folder"):
        esg.Scene.load("nowhere")
    broken = tmp_path / "broken"
    shutil.copytree(scene.folder, broken)
    for name in ("metrics.json", "manifest.json", "SHA256SUMS"):
        (broken / name).unlink()
    with pytest.raises(esg.UserError) as told:
        _ = esg.Scene.load(broken).verdict
    assert "manifest.json is damaged" in str(told.value)
    assert "metrics.json is damaged" in str(told.value)


def test_what_a_scene_exports_is_judged_as_the_scene_was(scene: esg.Scene, tmp_path: Path) -> None:
    suite = tmp_path / "suite.yaml"
    suite.write_text(
        f'suite: one\nscenes:\n  - id: S1\n    level: single\n    prompt: "{PROMPT}"\n'
        '    events:\n      - {id: e1, type: collision, a: "ball", b: "box"}\n'
    )
    truth = esg.judge(scene, suite)
    files = [*scene.export("glb", tmp_path), *scene.export("usd", tmp_path)]
    wanted = ("scene.glb", "scene_animation.usda")
    judged = [f for f in files if f.name in wanted] + [scene.folder / "rollout.mcap"]
    assert len(judged) == 3
    for file in judged:
        found = esg.judge_trajectories(file, suite).verdict
        assert [e.completed for e in found.events] == [e.completed for e in truth.events] == [True]
        assert found.events[0].time_s == pytest.approx(truth.events[0].time_s, abs=1 / 60)
        assert found.events[0].bodies == truth.events[0].bodies and found.slr == truth.slr
