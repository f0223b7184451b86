"""Who goes steps, who throws swings through, and who kneels gets there before he is swapped."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.assets import resolve
from esg.compile.visuals.setting import by_track
from esg.draft import draft
from esg.engines.breaking.stances import LIFT_M
from esg.engines.scene import FRAGMENT, Body, ContactLog, Gesture, Rollout, Shape, SimScene
from esg.graph.models import EsgDocument
from esg.view.moments import set_off
from esg.view.parts import body_parts
from esg.view.pieces import Movers, Part, clocked
from esg.view.seeing.gaits import going
from esg.view.seeing.limbs import stepping, with_limbs
from esg.view.seeing.shows import with_shows

TIME = np.linspace(0.0, 3.0, 181)
INERTIA = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def body(name: str, height: float, at: tuple[float, float] = (0.0, 0.0), **more: object) -> Body:
    half = (0.15, 0.2, 0.5 * height)
    return Body(
        name, False, 60.0, INERTIA, (Shape("box", half),), (*at, 0.5 * height), half_extents=half,
        origin_offset=(0.0, 0.0, -0.5 * height), **more,  # type: ignore[arg-type]
    )  # fmt: skip


def played(scene: SimScene, speed: dict[str, np.ndarray]) -> Rollout:
    """Bodies that go along +X at speeds [m/s], shape [T] each; all others stay."""
    shape = (1, len(TIME), len(scene.bodies))
    at = np.tile(np.array([b.position for b in scene.bodies]), (*shape[:2], 1, 1))
    velocity = np.zeros((*shape, 3))
    for name, v in speed.items():
        way = np.concatenate([[0.0], np.cumsum(0.5 * (v[1:] + v[:-1]) * np.diff(TIME))])
        at[0, :, scene.index(name), 0] += way
        velocity[0, :, scene.index(name), 0] = v
    turn = np.tile(np.array([0, 0, 0, 1], np.float32), (*shape, 1))
    return Rollout(
        "physx", 0.01, TIME, at.astype(np.float32), turn, velocity.astype(np.float32),
        np.zeros((*shape, 3), np.float32), ContactLog.empty(), np.ones(1, np.bool_),
    )  # fmt: skip


def walker(
    prompt: str, name: str, height: float, pace: float
) -> tuple[EsgDocument, SimScene, Rollout]:
    """Somebody who stands for a second, goes for a second and stands again."""
    doc = resolve(draft(prompt))
    scene = SimScene("s", (body(name, height),))
    speed = pace * ((TIME > 1.0) & (TIME < 2.0)).astype(float)
    return doc, scene, played(scene, {name: speed})


def drawn(parts: list[Part], scene: SimScene, rollout: Rollout, name: str) -> np.ndarray:
    """Corners of the parts of a name in the world in every frame, shape [T, n, 3]."""
    from esg.units import quat_rotate

    movers = Movers(parts, len(scene.bodies))
    at, turn = movers.poses(rollout.position[0], rollout.quaternion[0], clocked(scene, rollout))
    out = []
    for part in (p for p in parts if p.name.startswith(name)):
        k = movers.of(part)
        turns = np.repeat(turn[:, k, None], len(part.vertices), axis=1)
        corners = np.broadcast_to(part.vertices, (len(TIME), *part.vertices.shape))
        out.append(at[:, k, None] + quat_rotate(turns, corners))
    return np.concatenate(out, axis=1)


@pytest.mark.parametrize(
    ("prompt", "name", "height", "pace", "legs"),
    [
        ("A man walks across a lawn.", "man_1", 1.72, 1.3, ("leg_left", "leg_right")),
        ("A man sprints across a lawn.", "man_1", 1.72, 5.0, ("leg_left", "leg_right")),
        ("A girl runs to a tree.", "girl_1", 1.18, 3.0, ("leg_left", "leg_right")),
        ("A dog runs across a lawn.", "dog_1", 0.58, 4.0, ("leg_front_left", "leg_rear_left")),
        ("A horse walks across a lawn.", "horse_1", 1.6, 1.5, ("leg_front_left", "leg_rear_left")),
    ],
)
def test_who_goes_steps_on_the_ground(
    prompt: str, name: str, height: float, pace: float, legs: tuple[str, str]
) -> None:
    """Legs swing while he goes and hang while he stands; something always is on the ground."""
    doc, scene, rollout = walker(prompt, name, height, pace)
    parts = with_limbs(body_parts(scene, doc), scene, rollout, doc)
    low = drawn(parts, scene, rollout, "leg")[..., 2].min(axis=1)
    assert np.abs(low).max() < 0.03
    ways = [drawn(parts, scene, rollout, leg)[..., 0].min(axis=1) for leg in legs]
    ways = [w - rollout.position[0, :, 0, 0] for w in ways]
    going_on = (TIME > 1.2) & (TIME < 1.8)
    for way in ways:
        assert np.ptp(way[going_on]) > 0.1 * height
        assert np.ptp(way[TIME < 0.7]) < 0.01
    apart = ways[0] - ways[1]
    assert np.ptp(apart[going_on]) > 0.1 * height


def test_who_waves_while_he_walks_steps_and_waves() -> None:
    """His hand goes to and fro over his shoulder; nods have poses of their own, without steps."""
    doc, scene, rollout = walker("A man walks across a lawn and waves.", "man_1", 1.72, 1.3)
    waves = Gesture("waves", 0.9, 0, 0.3, 0.8)
    scene = scene.with_bodies((replace(scene.bodies[0], gestures=(waves,)),))
    assert stepping(scene, rollout, doc) == frozenset({0})
    parts = with_shows(with_limbs(body_parts(scene, doc), scene, rollout, doc), scene, rollout, doc)
    low = drawn(parts, scene, rollout, "leg")[..., 2].min(axis=1)
    assert np.abs(low).max() < 0.03
    going_on = (TIME > 1.2) & (TIME < 1.8)
    leg = (
        drawn(parts, scene, rollout, "leg_left")[..., 0].min(axis=1) - rollout.position[0, :, 0, 0]
    )
    assert np.ptp(leg[going_on]) > 0.17
    hand = drawn(parts, scene, rollout, "arm_right")
    assert hand[TIME < 0.3, :, 2].max() < 1.5 and hand[going_on][..., 2].max(axis=1).min() > 1.5
    tip = int(hand[90, :, 2].argmax())
    assert np.ptp(hand[going_on, tip, 1]) > 0.15
    nods = replace(scene.bodies[0], gestures=(Gesture("nods", 0.7, 3, 0.1, 0.0),))
    assert stepping(scene.with_bodies((nods,)), rollout, doc) == frozenset()


def test_feet_stay_where_they_stand() -> None:
    """The foot of a walker that is lower than the other slides little over the ground."""
    doc, scene, rollout = walker("A man walks across a lawn.", "man_1", 1.72, 1.3)
    parts = with_limbs(body_parts(scene, doc), scene, rollout, doc)
    feet = [drawn(parts, scene, rollout, f"leg_{side}") for side in ("left", "right")]
    soles = []
    for foot in feet:
        tip = foot[0, :, 2] < 0.03
        soles.append(foot[:, tip].mean(axis=1))
    left, right = soles
    stands = np.where((left[:, 2] < right[:, 2])[:, None], left, right)
    same = (left[1:, 2] < right[1:, 2]) == (left[:-1, 2] < right[:-1, 2])
    slips = np.abs(np.diff(stands[:, 0]))[same & (TIME[1:] > 1.2) & (TIME[1:] < 1.8)]
    assert slips.mean() / (TIME[1] - TIME[0]) < 0.5


def test_who_stays_is_drawn_as_before() -> None:
    """Nobody who stands still has limbs of his own, and what has none keeps its parts."""
    doc, scene, rollout = walker("A man walks across a lawn.", "man_1", 1.72, 0.0)
    assert stepping(scene, rollout, doc) == frozenset()
    parts = body_parts(scene, doc)
    assert with_limbs(parts, scene, rollout, doc) == parts


def test_a_skirt_shortens_the_steps() -> None:
    """The steps of who wears a skirt are shorter, and so more."""
    spans = []
    for prompt in ("A man walks across a lawn.", "A woman walks across a lawn."):
        name = "man_1" if "A man" in prompt else "woman_1"
        doc, scene, rollout = walker(prompt, name, 1.72, 1.3)
        parts = with_limbs(body_parts(scene, doc), scene, rollout, doc)
        way = drawn(parts, scene, rollout, "leg_left")[..., 0].min(axis=1)
        spans.append(np.ptp((way - rollout.position[0, :, 0, 0])[(TIME > 1.2) & (TIME < 1.8)]))
    assert spans[1] < 0.8 * spans[0]


def test_who_throws_swings_through() -> None:
    """He is as he throws when the ball sets off, and stands a second later."""
    doc = resolve(draft("A boy throws a ball over a fence."))
    ball = body("ball_1", 0.2, (0.4, 0.0))
    scene = SimScene("s", (body("boy_1", 1.18), ball))
    rollout = played(scene, {"ball_1": 5.0 * (TIME > 0.5)})
    ((when, what, who),) = set_off(scene, rollout, doc)
    assert (what, who) == (1, (0,))
    assert when == pytest.approx(0.5, abs=0.03)
    parts = with_limbs(body_parts(scene, doc), scene, rollout, doc)
    top = drawn(parts, scene, rollout, "arm_right")[..., 2].max(axis=1)
    shoulder = top[-1]
    assert np.ptp(top[TIME < 0.5]) < 0.02
    assert top[0] > shoulder + 0.05
    assert np.ptp(top[TIME > 1.5]) < 0.02


def test_who_kneels_gets_there_before_the_swap() -> None:
    """His head comes down in half a second, not from one frame to the next."""
    doc = resolve(draft("A man kneels down."))
    man, kneeling = body("man_1", 1.72, postures=("man_1_kneels",)), body("man_1_kneels", 1.31)
    kneeling = Body(**{**kneeling.__dict__, "category": FRAGMENT})
    scene = SimScene("s", (man, kneeling))
    rollout = played(scene, {})
    # The one that is not there rides in the other.
    down = TIME >= 1.5
    rollout.position[0, down, 0, 2] += LIFT_M
    rollout.position[0, ~down, 1, 2] = kneeling.position[2]
    rollout.position[0, down, 1, 2] = kneeling.position[2]
    parts = with_limbs(body_parts(scene, doc), scene, rollout, doc)
    head = drawn([p for p in parts if p.body == 0], scene, rollout, "trunk")[..., 2].max(axis=1)
    before = head[TIME < 1.49]
    assert head[0] == pytest.approx(1.72, abs=0.05)
    assert before[-1] < 0.8 * head[0]
    assert np.abs(np.diff(before)).max() < 0.06
    assert np.ptp(before[TIME[: len(before)] < 1.0]) < 0.01


def test_a_limb_is_one_piece_of_an_export() -> None:
    """What moves as one is together: trunk, and two or three pieces a limb."""
    doc, scene, rollout = walker("A man walks across a lawn.", "man_1", 1.72, 1.3)
    parts = with_limbs(body_parts(scene, doc), scene, rollout, doc)
    assert len(by_track(parts)) == 1 + 2 * 3 + 2 * 2


def test_a_run_has_longer_steps_than_a_walk() -> None:
    """The way of a cycle grows with the speed, and no leg whirls."""
    ones = np.ones(len(TIME))
    cycles = {
        v: float(np.ptp(going(TIME, v * ones, ones, 0.9).phase)) for v in (1.0, 2.0, 5.0, 30.0)
    }
    ways = [3.0 * v / n for v, n in cycles.items()]
    assert ways == sorted(ways)
    assert cycles[30.0] / 3.0 < 2.5
