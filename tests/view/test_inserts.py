"""Films cut to what the sentence is about where the takes of its events leave it too small."""

from __future__ import annotations

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics.plan.build import build_scene
from esg.engines.scene import ContactLog, Rollout, SimScene
from esg.layout import solve
from esg.view.director.acting import PASSED
from esg.view.director.told import (
    GOAL_INSIDE,
    LEGIBLE,
    LEGIBLE_GESTURE,
    LEGIBLE_S,
    Told,
    legible_in,
    told_of,
)
from esg.view.film.cutting import MAX_FRAMES
from esg.view.film.inserts import LASTS_S, Shot, with_inserts
from esg.view.film.shooting import frames_of, shots_of
from tests.view.plays import CAR, Play, Thing, at, finder_of, until

BUS = Play(
    "bus_and_woman",
    (
        Thing("bus", (6.0, 1.25, 1.5), until(4.0, (0.0, 0.0, 1.5), (6.0, 0, 0))),
        Thing("woman", (0.2, 0.25, 0.85), at(-14.0, 4.0, 0.85)),
        Thing("gold", (0.05, 0.05, 0.05), at(-20.0, 4.0, 0.5)),
        Thing("chest", (0.4, 0.4, 0.5), at(-20.0, 4.0, 0.5)),
    ),
    (("moves", 0.0, ("bus",)),),
    4.0,
)
DOG = Play(
    "dog_and_tree",
    (
        Thing("dog", (0.4, 0.15, 0.35), until(3.0, (0.0, 0.0, 0.35), (2.0, 0, 0))),
        Thing("tree", (0.6, 0.6, 2.0), at(9.0, 0.0, 2.0), static=True),
    ),
    (("moves", 0.0, ("dog",)),),
    3.0,
)


def _legible_s(shots: list[Shot], told: Told, aspect: float) -> float:
    return sum(legible_in(shot.action, shot.take, told, aspect)[1] for shot in shots)


def test_a_film_cuts_to_who_waves_at_a_bus() -> None:
    """Ten pixels of her are left in the bus's take; the cut shows her and keeps the event."""
    finder = finder_of(BUS)
    action, told = finder.action, Told(1, (0.2, 4.0), LEGIBLE_GESTURE, facing=True)
    plain = shots_of(finder)
    assert _legible_s(plain, told, finder.aspect) == 0.0
    shots, lacking = with_inserts(finder, plain, [told], 0)
    assert not lacking and finder.action is action
    assert _legible_s(shots, told, finder.aspect) >= LEGIBLE_S
    starts = [float(shot.cut.time_s[0]) for shot in shots]
    assert starts == sorted(starts) and starts[0] == 0.0
    assert sum(len(shot.cut.time_s) for shot in shots) <= MAX_FRAMES
    (insert,) = (shot for shot in shots if shot.action is not action)
    assert float(np.ptp(insert.cut.time_s)) == pytest.approx(LASTS_S, abs=0.05)
    own = [shot for shot in shots if shot.action is action]
    kept = [s.beat.event for shot in own for s in finder.review(shot.take)]
    assert kept == ["e1"]
    assert len(list(frames_of(finder, shots))) == sum(len(shot.cut.time_s) for shot in shots)


def test_a_goal_is_shown_with_who_goes_to_it() -> None:
    """Out of the picture while the dog runs; both in the cut."""
    finder = finder_of(DOG)
    goal = Told(1, (0.0, 3.0), LEGIBLE, mover=0, inside=GOAL_INSIDE)
    shots, lacking = with_inserts(finder, shots_of(finder), [goal], 0)
    assert not lacking
    (insert,) = (shot for shot in shots if shot.action is not finder.action)
    for body in (0, 1):
        told = Told(body, (0.0, 3.0), LEGIBLE)
        assert legible_in(insert.action, insert.take, told, finder.aspect)[1] >= LEGIBLE_S


def test_what_is_large_enough_is_left_and_what_is_hidden_is_told() -> None:
    """The bus needs no cut; gold in a chest is seen from nowhere."""
    finder = finder_of(BUS)
    plain = shots_of(finder)
    bus, gold = Told(0, (0.0, 4.0), LEGIBLE), Told(2, (0.0, 4.0), LEGIBLE)
    assert with_inserts(finder, plain, [bus], 0) == (plain, [])
    assert with_inserts(finder, plain, [gold], 0) == (plain, [gold])


def test_gestures_and_goals_of_a_prompt_are_told() -> None:
    """Who waves, within the time of it and from ahead; the tree, with the dog that runs to it."""
    found = {}
    for prompt in ("A woman waves as a bus drives away.", "A dog runs toward a tree."):
        doc = solve(resolve(draft(prompt)))
        scene = build_scene(doc)
        for one in told_of(scene, _still(scene), None, doc):
            found[scene.bodies[one.body].name] = (one, scene.names)
    woman, _ = found["woman_1"]
    assert woman.facing and woman.least == LEGIBLE_GESTURE and 0.2 < woman.span[0] < woman.span[1]
    tree, names = found["tree_1"]
    assert tree.mover is not None and names[tree.mover] == "dog_1"
    assert "road_1" not in found and "ground_1" not in found


def _still(scene: SimScene) -> Rollout:
    time = np.linspace(0.0, 4.0, 121)
    shape = (1, len(time), len(scene.bodies))
    place = np.tile(np.array([b.position for b in scene.bodies], np.float32), (*shape[:2], 1, 1))
    turn = np.tile(np.array([b.quaternion for b in scene.bodies], np.float32), (*shape[:2], 1, 1))
    zero = np.zeros((*shape, 3), np.float32)
    empty = ContactLog.empty()
    return Rollout("physx", 0.01, time, place, turn, zero, zero, empty, np.ones(1, np.bool_))


def test_who_overtakes_is_seen_until_he_has_left_the_other_one_behind() -> None:
    """Level at 1.5 s, 4.4 m ahead two seconds later: both are in view then, too."""
    play = Play(
        "overtakes",
        (
            Thing("car", CAR, until(6.0, (-3.3, 0.0, 0.7), (8.2, 0, 0))),
            Thing("van", CAR, until(6.0, (0.0, 3.0, 0.7), (6.0, 0, 0))),
        ),
        (("misses", 1.5, ("car", "van")),),
        6.0,
    )
    finder = finder_of(play)
    assert [b.type for b in finder.action.beats] == ["misses", PASSED]
    there = finder.action.beats[-1].time_s
    assert there == pytest.approx(3.5, abs=0.05)
    shots = shots_of(finder)
    seen = {s.beat.type: s for shot in shots for s in finder.review(shot.take)}
    assert seen[PASSED].inside >= 0.95 and seen[PASSED].unobscured >= 0.6
    assert max(float(shot.cut.time_s[-1]) for shot in shots) >= there + 0.2
