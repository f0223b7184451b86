"""Distances that a prompt states, and rolling to rest."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import build_scene, start_hints
from esg.dynamics.losses.gap import surface_gap
from esg.dynamics.plan.planner import make_plan
from esg.engines import get_engine
from esg.engines.program import batch_programs
from esg.engines.scene import Body, Shape
from esg.layout import solve

STILL = (0.0, 0.0, 0.0, 1.0)


def _starts(prompt: str) -> dict[str, tuple[float, float]]:
    hints = start_hints(resolve(draft(prompt)), seed=0)
    (only,) = hints.constellations
    return {p.node: (p.x_cm, p.y_cm) for p in only.placements}


def _apart(prompt: str, a: str, b: str) -> float:
    at = _starts(prompt)
    return math.dist(at[a], at[b]) / 100.0


def test_start_is_as_far_from_the_target_as_stated() -> None:
    """Put 3 and 9 m between a robot and a crate, whatever else of them there is."""
    told = "A robot stands {} m from a crate. It drives at 1 m/s into the crate."
    near, far = (_apart(told.format(d), "robot_1", "crate_1") for d in (3, 9))
    assert far - near == pytest.approx(6.0, abs=0.1)


@pytest.mark.parametrize("how", ["at 5 m/s until they collide", "and collide after 2 seconds"])
def test_two_that_meet_start_as_far_apart_as_stated(how: str) -> None:
    """Let two cars that drive toward each other start with the stated gap."""
    told = "Two cars are {} m apart and drive toward each other " + how + "."
    near, far = (_apart(told.format(d), "car_1", "car_2") for d in (14, 20))
    assert far - near == pytest.approx(6.0, abs=0.2)


def test_a_line_on_the_road_is_measured_by_its_bounds() -> None:
    """Take the distance of a box from a body without shapes from that one's half extents."""
    box = Shape("box", (1.0, 1.0, 1.0))
    unit = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    car = Body("car", False, 1.0, unit, (box,), (0.0, 0.0, 0.0), half_extents=(1.0, 1.0, 1.0))
    line = Body("line", True, 1.0, unit, (), (4.0, 0.0, 0.0), half_extents=(0.5, 2.0, 0.005))
    q, at = np.array([STILL]), np.array([[4.0, 0.0, 0.0]])
    assert surface_gap(car, line, np.zeros((1, 3)), q, at, q) == pytest.approx(2.5)


def test_what_rolls_and_shall_stop_comes_to_rest_in_time() -> None:
    """Slow a ball that rolls over grass down to nothing; its first guess is enough."""
    doc = resolve(draft("A ball rolls over the grass and comes to rest within 2 to 3 seconds."))
    doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
    plan = make_plan(doc, build_scene(doc), seed=0)
    program = plan.compile(plan.initial())
    played = get_engine("physx").rollout(
        plan.scene, batch_programs([program], plan.scene.names), record_every=24
    )
    speed = np.linalg.norm(played.linear_velocity[0, :, plan.scene.index("ball_1")], axis=-1)
    assert speed.max() > 0.8
    assert speed[-1] < 0.1
