"""Pictures of a scene whose prompt says how it is filmed: sheets, films, ground truth, exports."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from esg.graph.models import EsgDocument, Filming, Predicate, Statement
from esg.view import scenery as sceneries
from esg.view.capture import capture
from esg.view.containers import read_capture
from esg.view.film.cutting import FPS, MAX_SAID_FRAMES, whole_cut
from esg.view.film.shooting import shots_of
from esg.view.filmed import said_rate, said_take
from esg.view.seeing.wanted import Settings
from esg.view.setting import setting_of
from tests.view.plays import (
    PLAYS,
    action_of,
    document_of,
    finder_of,
    parts_of,
    rollout_of,
    scene_of,
    verdict_of,
)

PLAY = next(play for play in PLAYS if play.name == "ball_and_box")
BEATS = action_of(PLAY).beats


def saying(*words: Filming, about: str = "ball") -> EsgDocument:
    """The document of the play with words about the camera."""
    told = tuple(
        Statement(
            id=f"s{k}", predicate=Predicate.FILMED, filming=word, object=(about,), text=word,
            start=0, end=1,
        )
        for k, word in enumerate(words)
    )  # fmt: skip
    return document_of(PLAY).model_copy(update={"statements": told})


def test_without_words_the_camera_is_the_directors() -> None:
    """Leave open what nobody says, also where only the pace of the film is said."""
    world = (scene_of(PLAY), rollout_of(PLAY))
    assert said_take(document_of(PLAY), *world, 1.5) is None
    assert said_take(saying("slow_motion"), *world, 1.5) is None
    assert said_rate(document_of(PLAY)) == 1.0
    assert said_rate(saying("slow_motion")) == 0.25
    assert said_rate(saying("time_lapse", "aerial")) == 4.0


@pytest.mark.parametrize("word", ["overhead", "follows", "orbits", "static"])
def test_a_film_has_one_take_without_cuts(word: Filming) -> None:
    """Show all of the replay by the camera that the prompt tells, the ball in every frame."""
    take = said_take(saying(word), scene_of(PLAY), rollout_of(PLAY), 240 / 135)
    assert take is not None
    finder = finder_of(PLAY)
    (shot,) = shots_of(finder, said=take)
    assert shot.take.kind == "as_said"
    assert shot.cut.time_s[0] == 0.0
    assert shot.cut.time_s[-1] == pytest.approx(PLAY.lasts, abs=1 / FPS)
    for k, time in enumerate(shot.cut.time_s):
        corners = finder.action.corners(finder.action.frame(float(time)), (0,))[0]
        pixels, ahead = shot.take.camera(k).project(corners, 240, 135)
        assert ahead.all()
        assert (pixels >= 0).all() and (pixels <= (240, 135)).all()


def test_a_film_is_as_fast_as_the_prompt_says() -> None:
    """Play slow motion at a quarter of the speed, around the first event where all is too long."""
    slow = whole_cut(BEATS, PLAY.lasts, 0.25)
    assert np.allclose(slow.speed, 0.25)
    assert np.allclose(np.diff(slow.time_s), 0.25 / FPS)
    assert len(slow.time_s) <= MAX_SAID_FRAMES
    assert slow.time_s[0] <= BEATS[0].time_s <= slow.time_s[-1]
    fast = whole_cut(BEATS, PLAY.lasts, 4.0)
    assert np.allclose(np.diff(fast.time_s), 4.0 / FPS)
    long = whole_cut(BEATS, 60.0, 1.0)
    assert len(long.time_s) <= MAX_SAID_FRAMES
    assert long.time_s[-1] == pytest.approx(60.0, abs=0.5)


def test_ground_truth_by_the_words(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Film with the first camera what the prompt says, at its pace; the others are the director's."""
    monkeypatch.setattr("esg.view.seeing.witness.scene_parts", lambda *_: parts_of(PLAY))
    monkeypatch.setattr(sceneries, "body_parts", lambda *_: parts_of(PLAY)[1:])
    doc = saying("overhead", "slow_motion")
    settings = Settings(("segmentation",), (96, 54), 4.0, 2, camera="auto")
    world = (scene_of(PLAY), rollout_of(PLAY), verdict_of(PLAY))
    folder = capture(*world, doc, tmp_path / "shots", settings)
    manifest = json.loads((folder / "manifest.json").read_bytes())
    first, second = manifest["cameras"]
    assert first["kind"] == "as_said"
    assert second["kind"] in ("static", "tracking")
    assert np.allclose(np.diff(manifest["time_s"]), 0.25 / 4.0, atol=2e-2)
    for row in read_capture(folder):
        if row["camera"] == 0:
            assert (row["segmentation"] == 2).any()


def test_exports_carry_the_camera() -> None:
    """Give other programs the moving camera."""
    doc = saying("orbits", about="box")
    setting = setting_of(scene_of(PLAY), rollout_of(PLAY), verdict_of(PLAY), doc)
    (view,) = setting.views
    assert len(view.time) > 2
    assert float(np.ptp(view.position, axis=0).max()) > 0.5
    assert np.allclose(np.linalg.norm(view.quaternion, axis=1), 1.0)
    plain = setting_of(scene_of(PLAY), rollout_of(PLAY), verdict_of(PLAY), document_of(PLAY))
    assert len(plain.views[0].time) == 1
