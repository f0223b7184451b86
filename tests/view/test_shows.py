"""What shines is drawn at its times, what falls falls, and what sways goes to and fro."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from esg.engines.scene import Body, ContactLog, Rollout, Shape, Shine, SimScene
from esg.engines.wheels import TURN_S, shining
from esg.graph.models import EsgDocument
from esg.lexicon.shown import Sway, weather_of
from esg.view.pieces import Act, Movers, Part, clocked
from esg.view.seeing.shows import there, with_shows

TIME = np.linspace(0.0, 3.0, 91)
WHITE = (1.0, 1.0, 1.0)


def thing(**more: object) -> Body:
    box = Shape("box", (0.1, 0.1, 0.5))
    inertia = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    return Body(
        "thing_1", True, 1.0, inertia, (box,), (0.0, 0.0, 0.5), half_extents=(0.1, 0.1, 0.5),
        origin_offset=(0.0, 0.0, -0.5), **more,  # type: ignore[arg-type]
    )  # fmt: skip


def still(scene: SimScene) -> Rollout:
    shape = (1, len(TIME), len(scene.bodies))
    at = np.tile(np.array([b.position for b in scene.bodies], np.float32), (*shape[:2], 1, 1))
    turn = np.tile(np.array([0, 0, 0, 1], np.float32), (*shape, 1))
    zero = np.zeros((*shape, 3), np.float32)
    return Rollout(
        "physx", 0.01, TIME, at, turn, zero, zero, ContactLog.empty(), np.ones(1, np.bool_)
    )


def sheet() -> Part:
    """A square of 1 m in the plane y = 0, from x = 0 on."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]], float)
    return Part(0, corners, np.array([[0, 1, 2], [0, 2, 3]]), WHITE, name="cloth")


@pytest.mark.parametrize(
    ("shine", "early", "late"),
    [
        (Shine("bulb", WHITE), True, True),
        (Shine("bulb", WHITE, before=False), False, True),
        (Shine("bulb", WHITE, after=False), True, False),
        (Shine("bulb", WHITE, before=False, event="hit"), False, True),
        (Shine("bulb", WHITE, before=False, event="missed"), False, False),
    ],
)
def test_lights_change_at_their_moment(shine: Shine, early: bool, late: bool) -> None:
    """Change soon after the start or at the event, and never at one that did not happen."""
    events = {"hit": 2.0, "missed": None}
    at = 2.0 if shine.event else TURN_S
    on = shining(shine, np.array([at - 0.05, at + 0.05]), events)
    assert on.tolist() == [early, late]


def test_flashes_are_intervals() -> None:
    """Shine for half of every period."""
    found = there(Shine("bulb", WHITE, period_s=0.5), TIME, {})
    assert found[:2] == (pytest.approx((0.0, 0.25)), pytest.approx((0.5, 0.75)))


def test_flames_are_there_only_while_it_burns() -> None:
    """Put flames out of sight before something catches fire, and on top of it after."""
    scene = SimScene("s", (thing(shines=(Shine("flame", WHITE, before=False),)),))
    rollout = still(scene)
    parts = with_shows([], scene, rollout, EsgDocument.model_construct())
    movers = Movers(parts, 1)
    at, turn = movers.poses(rollout.position[0], rollout.quaternion[0], clocked(scene, rollout))
    flame = movers.of(parts[0])
    bottom = at[:, flame, 2] + parts[0].vertices[:, 2].min()
    assert np.all(bottom[TIME < TURN_S - 0.01] < -10.0)
    assert np.all(bottom[TIME > TURN_S + 0.01] > 0.8)
    assert turn.shape == (len(TIME), len(movers), 4)


@pytest.mark.parametrize("how", ["bends", "waves"])
def test_what_sways_is_drawn_going_to_and_fro(how: str) -> None:
    """Move drawn vertices by as much as is said, and bring them back."""
    scene = SimScene("s", (thing(sways=Sway(how, (), 10.0, 1.0)),))  # type: ignore[arg-type]
    rollout = still(scene)
    parts = with_shows([sheet()], scene, rollout, EsgDocument.model_construct())
    far = max(parts, key=lambda p: float(p.vertices[:, 0].max()))
    assert far.act is not None
    at, turn = far.act.local(TIME)
    moved = at[:, 1] if how == "waves" else 2.0 * np.arcsin(turn[:, 1])
    reach = math.radians(10.0) * (1.0 if how == "waves" else 0.7)
    assert float(np.ptp(moved)) == pytest.approx(2.0 * reach, rel=0.05)
    assert np.count_nonzero(np.diff(np.sign(np.diff(moved)))) >= 4


def test_flags_are_cut_without_gaps() -> None:
    """Keep all of a sheet's surface when it is cut into strips."""
    scene = SimScene("s", (thing(sways=Sway("waves", (), 10.0, 1.0)),))
    parts = with_shows([sheet()], scene, still(scene), EsgDocument.model_construct())
    spans = sorted((float(p.box[0][0]), float(p.box[1][0])) for p in parts)
    assert spans[0][0] == pytest.approx(0.0)
    assert spans[-1][1] == pytest.approx(1.0)
    assert all(b[0] <= a[1] for a, b in itertools.pairwise(spans))


def test_rain_falls_at_its_speed_all_the_time() -> None:
    """Fall by the speed of the table, with streaks in the box at every moment, the same again."""
    scene = SimScene("s", (thing(),), weather=("heavy rain",))
    rollout = still(scene)
    (rain,) = with_shows([], scene, rollout, EsgDocument.model_construct())
    again = with_shows([], scene, rollout, EsgDocument.model_construct())[0]
    assert np.array_equal(rain.vertices, again.vertices)
    assert rain.act is not None
    at, _ = rain.act.local(np.array([0.0, 0.1, 1.0]))
    found = weather_of("heavy rain")
    assert found is not None
    assert at[1, 2] - at[0, 2] == pytest.approx(-0.1 * found[0].falls_mps)
    for moved in at:
        heights = rain.vertices[:, 2] + moved[2]
        counts, _ = np.histogram(heights, bins=3, range=(0.0, 9.0))
        assert counts.min() > 0.2 * counts.max()


def test_scenes_without_shows_keep_their_parts() -> None:
    """Return the very parts where nothing is shown."""
    scene = SimScene("s", (thing(),))
    part = sheet()
    assert with_shows([part], scene, still(scene), EsgDocument.model_construct()) == [part]
    assert part.act is None
    assert Act().seen(TIME).all()


def test_what_is_never_there_is_seen_at_no_time() -> None:
    """Who kneels from the start on never stands: a scene with him could not be written to GLB."""
    assert not Act(there=()).seen(TIME).any() and Act(there=()).seen(TIME).shape == TIME.shape
    assert Act(there=((TIME[0], TIME[1]),)).seen(TIME).tolist() == [True] + [False] * (
        len(TIME) - 1
    )
