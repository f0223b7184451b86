"""Every way to film: planned and kept, and broken by a camera that does another thing."""

from typing import get_args

import numpy as np
import pytest

from esg.engines.scene import Shape
from esg.filming.ways import Way, way_of
from esg.graph.filming import Shot, agree, rows
from esg.graph.models import Filming, Predicate
from esg.metrics import SuiteStatement
from esg.metrics.replay import Replay
from esg.metrics.statements import filmed
from tests.metrics.worlds import World, ball, body, line

CAR = body("car_1", Shape("box", (2.2, 0.9, 0.7)), wheeled=True)
MAN = body("man_1", Shape("box", (0.15, 0.25, 0.9)))


def driving() -> World:
    """A car that drives 32 m."""
    return World(4.0).add(CAR, x=line(0, 8), z=0.7)


def walking() -> World:
    """A man who walks 5 m to the front."""
    return World(4.0).add(MAN, y=line(0, 1.2), z=0.9, yaw_deg=90.0)


def standing() -> World:
    """A car past which a ball rolls."""
    return World(3.0).add(CAR, z=0.7).add(ball("ball_1"), x=line(-4, 3), y=2.0, z=0.1)


WORLDS = {"car": driving, "man": walking}
OTHERWISE: dict[str, str] = {
    "overhead": "eye_level",
    "aerial": "eye_level",
    "high_angle": "low_angle",
    "low_angle": "overhead",
    "eye_level": "overhead",
    "from_front": "from_behind",
    "from_behind": "from_front",
    "from_side": "from_front",
    "first_person": "from_side",
    "over_shoulder": "from_front",
    "extreme_close_up": "wide",
    "close_up": "wide",
    "medium": "extreme_close_up",
    "wide": "close_up",
    "follows": "static",
    "zooms_in": "zooms_out",
    "zooms_out": "zooms_in",
    "moves_forward": "moves_backward",
    "moves_backward": "moves_forward",
    "moves_left": "moves_right",
    "moves_right": "moves_left",
    "moves_up": "moves_down",
    "moves_down": "moves_up",
    "pans_left": "pans_right",
    "pans_right": "pans_left",
    "tilts_up": "tilts_down",
    "tilts_down": "tilts_up",
    "orbits": "from_side",
    "static": "orbits",
    "handheld": "static",
    "slow_motion": "time_lapse",
    "time_lapse": "slow_motion",
}
"""What another camera does that breaks each of them."""


def states(*words: str, object: str | None) -> list[SuiteStatement]:
    return [
        SuiteStatement.model_validate(
            {"id": f"s{k}", "says": "filmed", "filming": word, "object": object}
        )
        for k, word in enumerate(words)
    ]


def replay_of(world: World) -> Replay:
    return Replay(world.scene, world.program, world.rollout())


def way(world: World, *words: str, aspect: float = 16 / 9) -> Way:
    replay = replay_of(world)
    shot = Shot(words, (0,))  # type: ignore[arg-type]
    found = way_of(shot, replay.scene, replay.time, replay.position, replay.quaternion, aspect)
    assert found is not None
    return found


def test_every_way_has_a_row_and_a_measure():
    """Know every way to film in the table, in the judge and in these tests."""
    assert set(rows()) == set(get_args(Filming))
    assert set(OTHERWISE) | {"in_view"} == set(get_args(Filming))


@pytest.mark.parametrize("kind", WORLDS)
@pytest.mark.parametrize("word", get_args(Filming))
def test_what_is_said_is_kept(word, kind):
    """Plan a way that keeps each of them, of a car and of a man."""
    found = WORLDS[kind]().judge(statements=states(word, object=kind)).statements[0]
    assert found.kept is True, found.reason
    assert found.measured


@pytest.mark.parametrize(("word", "other"), OTHERWISE.items())
def test_another_camera_breaks_it(word, other):
    """Say of each what a camera that does another thing lacks."""
    world = walking()
    made = states(word, object="man")[0]
    found = filmed.measure(replay_of(world), way(world, other), made, (0,))
    assert found.kept is False
    assert any(c.isdigit() for c in found.reason)


def test_what_is_out_of_the_picture_is_broken():
    """Break every word whose subject the camera does not show."""
    world = driving()
    there = way(world, "follows")
    away = Way(there.time_s, there.eye, 2.0 * there.eye - there.target, there.fov)
    for word in ("in_view", "follows", "aerial", "close_up"):
        found = filmed.measure(replay_of(world), away, states(word, object="car")[0], (0,))
        assert found.kept is False
        assert "in the picture for 0%" in found.reason


@pytest.mark.parametrize(
    "words",
    [
        ("aerial", "follows", "zooms_in"),
        ("close_up", "from_side", "handheld"),
        ("wide", "static", "slow_motion"),
        ("low_angle", "from_front", "moves_backward"),
        ("medium", "eye_level", "follows"),
        ("zooms_in", "pans_left"),
    ],
)
def test_words_are_kept_together(words):
    """Keep what one shot can do at once."""
    assert all(agree(a, b) for a in words for b in words)
    found = walking().judge(statements=states(*words, object="man")).statements
    assert [s.kept for s in found] == [True] * len(words), [s.reason for s in found]


def test_one_camera_cannot_do_everything():
    """Tell two shots from one."""
    assert not agree("close_up", "wide")
    assert not agree("static", "pans_left")
    assert not agree("first_person", "aerial")
    assert not agree("slow_motion", "time_lapse")
    assert agree("aerial", "from_behind")
    for a in get_args(Filming):
        assert agree(a, a)
        for b in get_args(Filming):
            assert agree(a, b) is agree(b, a)


def test_a_ball_that_rolls_past_stays_in_the_picture():
    """Hold in the picture what moves beside what is filmed."""
    world = standing()
    shot = way(world, "orbits")
    looked = filmed.Looked(replay_of(world), shot, (1,))
    near = np.abs(looked.middle[:, 0]) < 2.0
    assert looked.inside[near].all()


def test_a_scene_without_words_has_no_way():
    """Leave the camera to the director where nothing is said of it."""
    made = SuiteStatement(id="s1", says=Predicate.STAYS_UPRIGHT, object="man")
    assert filmed.planned([made], {}, replay_of(walking())) is None


def test_a_way_is_the_same_for_every_sampling():
    """Plan the same way from a recording with half of the frames."""
    world = walking()
    full = replay_of(world)
    rare = slice(None, None, 2)
    shot = Shot(("follows", "zooms_in"), (0,))
    a = way_of(shot, full.scene, full.time, full.position, full.quaternion, 1.5)
    b = way_of(shot, full.scene, full.time[rare], full.position[rare], full.quaternion[rare], 1.5)
    assert a is not None
    assert b is not None
    np.testing.assert_allclose(a.eye, b.eye, atol=0.02)
    again = way_of(shot, full.scene, full.time, full.position, full.quaternion, 1.5)
    assert again is not None
    assert np.array_equal(a.eye, again.eye)
