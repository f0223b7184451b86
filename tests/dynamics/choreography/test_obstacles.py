"""Who meets what ran into an obstacle, low hits, rolling balls on time, and what cannot be."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import build_scene, optimize, start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.losses.assessment import Assessment
from esg.dynamics.search import batched
from esg.dynamics.search.batched import Explored
from esg.dynamics.search.panel import Found
from esg.dynamics.story.kinematics import braking_distance
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.tipping import topple_speed
from esg.engines.program import batch_programs, program_from_json
from esg.engines.registry import get_engine
from esg.graph.models import DynamicsResult, EsgDocument
from esg.layout import solve
from esg.layout.problem.hints import Placement
from esg.metrics import expectations_from_timeline, judge


def _resolved(prompt: str) -> EsgDocument:
    return fitted(resolve(draft(prompt)))


def _played(prompt: str) -> tuple[DynamicsResult, list[tuple[int, int]]]:
    """The search's result, and events completed of all in PhysX and Rapier."""
    doc = _resolved(prompt)
    doc = optimize(solve(doc, hints=start_hints(doc)))
    result = doc.dynamics_result
    assert result is not None
    scene, program = build_scene(doc), program_from_json(result.program)
    expected = expectations_from_timeline(doc, scene)
    counts: list[tuple[int, int]] = []
    for engine in ("physx", "rapier"):
        rollout = get_engine(engine).rollout(scene, batch_programs([program], scene.names))
        verdict = judge(scene, program, rollout, expected)
        counts.append((verdict.completed, verdict.n_events))
    return result, counts


def _placements(doc: EsgDocument) -> dict[str, Placement]:
    (constellation,) = start_hints(doc).constellations
    return {p.node: p for p in constellation.placements}


@pytest.mark.parametrize(
    ("prompt", "front", "obstacle", "behind"),
    [
        ("A truck crashes into a bus stop sign, then a taxi rams the truck.", "truck", "sign",
         "taxi"),
        ("A bicycle runs into a tree and then a scooter crashes into the bicycle.", "bicycle",
         "tree", "scooter"),
        ("A red car hits a parked van, then a blue car rams the red car.", "red_car", "van",
         "blue_car"),
        ("A cyclist hits a fence and then a jogger bumps into the cyclist.", "cyclist", "fence",
         "jogger"),
    ],
)  # fmt: skip
def test_what_ran_into_an_obstacle_is_met_from_behind(
    prompt: str, front: str, obstacle: str, behind: str
) -> None:
    """Its follower's way leads over its own start, not through what stopped it."""
    doc = _resolved(prompt)
    places = _placements(doc)

    def named(word: str) -> Placement:
        return next(p for key, p in places.items() if key.startswith(word))

    a, wall, b = named(front), named(obstacle), named(behind)
    heading = math.atan2(wall.y_cm - a.y_cm, wall.x_cm - a.x_cm)
    back = math.atan2(a.y_cm - b.y_cm, a.x_cm - b.x_cm)
    assert back == pytest.approx(heading, abs=0.1)
    gap = math.hypot(a.x_cm - b.x_cm, a.y_cm - b.y_cm) / 100.0
    assert gap > 0.5 * (prop(doc, a.node).length + prop(doc, b.node).length)


def test_a_truck_at_a_sign_is_rammed_in_other_engines_too() -> None:
    """The truck is not pressed through the sign, and the taxi arrives after that hit."""
    result, counts = _played(
        "A truck drives down the street and crashes into a bus stop sign, "
        "then a taxi behind it rams the truck."
    )
    assert counts == [(2, 2), (2, 2)]
    assert not [p for p in result.parameters if p.name == "truck_1_drive_2/speed"]


def test_low_hits_get_more_speed() -> None:
    """A chair hit at its legs needs more margin than one that is hit above its middle."""
    doc = _resolved("A chair is knocked over by a rolling suitcase.")
    case, chair = prop(doc, "suitcase_1"), prop(doc, "chair_1")
    low, high = (topple_speed(case, chair, flies=flies) for flies in (False, True))
    assert high < low < 5.0
    _, counts = _played("A chair is knocked over by a rolling suitcase.")
    assert counts == [(2, 2), (2, 2)]


@pytest.mark.parametrize(
    ("prompt", "speed", "time", "both"),
    [
        ("A ball rolls at 3 m/s and hits a cone after 2 seconds.", 3.0, 2.0, False),
        ("Two balls roll towards each other at 2 m/s and collide after 1 second.", 2.0, 1.0, True),
    ],
)
def test_a_rolling_ball_is_placed_as_far_as_it_gets(
    prompt: str, speed: float, time: float, both: bool
) -> None:
    """At a prescribed speed and time the way is what damping leaves of it."""
    doc = _resolved(prompt)
    places = list(_placements(doc).values())
    ball, other = (next(p for p in places if p.node.startswith(w)) for w in ("ball", "cone")
                   ) if not both else places[:2]  # fmt: skip
    first, second = prop(doc, ball.node), prop(doc, other.node)
    way = braking_distance(speed, first.damping, time)
    assert way < 0.99 * speed * time
    gap = math.hypot(ball.x_cm - other.x_cm, ball.y_cm - other.y_cm) / 100.0
    gap -= first.half_length + second.half_length
    assert gap == pytest.approx((2.0 if both else 1.0) * way, abs=0.03)


def test_nothing_is_searched_where_physics_rules_the_event_out() -> None:
    """One look in the reference engine, then the nearest feasible with its reason."""
    doc = _resolved("A ping pong ball topples a refrigerator.")
    done = optimize(solve(doc, hints=start_hints(doc))).dynamics_result
    assert done is not None
    assert (done.outcome, done.stopped) == ("nearest_feasible", "ruled out")
    assert done.explored == 0 and done.evaluations == 8
    assert "cannot topple" in done.reason


@pytest.mark.parametrize(
    ("hits", "surrogate", "stalled", "expected"),
    [
        (False, 30.0, True, "out of reach"),
        (False, 29.0, False, "out of reach"),
        (False, 15.0, False, "polished"),
        (True, 30.0, True, "no progress"),
        (True, 15.0, True, "polished"),
    ],
)
def test_out_of_reach_in_both_engines_is_not_polished(
    hits: bool, surrogate: float, stalled: bool, expected: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Newton goes on only where it sees something else than the surrogate."""
    theta = np.zeros((1, 1))
    ensemble = Assessment(np.full(8, 30.0), {"hit": np.array([hits] + [False] * 7)})
    found = Found(theta[0], 30.0, ensemble.worlds(slice(0, 1)), ensemble)
    monkeypatch.setattr(batched, "_explore", lambda *_: Explored(theta, surrogate, stalled))
    monkeypatch.setattr(batched, "_polish", lambda *_: (found, "polished"))
    panel = cast(Any, SimpleNamespace(judge=lambda _: found, decided=np.inf))
    stopped = batched.search(cast(Any, None), panel, np.random.default_rng(0), 12)[1]
    assert stopped == expected
