"""Gradients through the surrogate equal differences of the same surrogate, where they should."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics.gradient.differentiate import Regime, ad_valid, check_gradient, gradient, regimes
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import (
    AdjustProperties,
    ApplyImpulse,
    Column,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Program,
    SetVelocity,
    batch_programs,
)
from esg.engines.scene import SimScene, Variation
from esg.engines.surrogate import Seeds, TapedRollout
from tests.dynamics import stories
from tests.dynamics.stage import lay_out
from tests.engines.lab import ball, box

DT = 1.0 / 240.0


def final(scene, batch, name, field="position", variation=None):
    """Final state of a body per world, from rollouts and from the replay's derivatives."""
    taped = TapedRollout(scene, batch, dt=DT, variation=variation)
    i = scene.index(name)
    value = getattr(taped, field)[:, -1, i].astype(float)
    return taped, i, value


def table_gradient(scene, program, name, axis, column, primitive=0, field="position"):
    """d final[axis] / d table[primitive, column]: by the tape and by differences."""
    base = batch_programs([program], scene.names)
    taped, i, _ = final(scene, base, name, field)
    seed = np.zeros((1, taped.frames.n_steps + 1, len(scene.bodies), 3))
    seed[0, -1, i, axis] = 1.0
    pulled = taped.pull(Seeds(position=seed) if field == "position" else Seeds(velocity=seed))
    half = 4 * DT if column < 2 else 0.02
    probes = batch_programs([program] * 2, scene.names)
    probes.table[0, primitive, column] += half
    probes.table[1, primitive, column] -= half
    _, _, ends = final(scene, probes, name, field)
    return pulled.table[0, primitive, column], (ends[0, axis] - ends[1, axis]) / (2.0 * half)


LONE = SimScene("lone", (ball("a", 0.1, 1.0, (0, 0, 5.0), linear_damping=0.4),))
FLOOR = SimScene(
    "floor",
    (box("a", (0.2, 0.2, 0.1), 2.0, (0, 0, 0.1), friction=0.3),
     ball("b", 0.1, 1.0, (0, 3, 0.1), friction=0.5, angular_damping=0.2)),
)  # fmt: skip
PAIR = SimScene(
    "pair",
    (ball("a", 0.1, 1.0, (0, 0, 5.0), friction=0.0, restitution=0.9),
     ball("b", 0.1, 2.0, (0.8, 0.06, 5.0), friction=0.0, restitution=0.9)),
    gravity=(0.0, 0.0, 0.0),
)  # fmt: skip

PATH = GuideAlong(
    "a",
    0.2,
    (0.0, 0.3, 0.5),
    ((0.0, 0.0, 5.0), (0.3, 0.2, 5.4), (0.52, 0.3, 5.3)),
    ((0.0, 0.0, 0.0), (1.0, 0.5, 0.5), (1.0, 1.0, -1.0)),
)


@pytest.mark.parametrize(
    ("scene", "program", "body", "axis", "column", "field"),
    [
        (LONE, SetVelocity("a", 0.3, (2.0, 0.0, 3.0)), "a", 0, 2, "position"),
        (LONE, SetVelocity("a", 0.3, (2.0, 0.0, 3.0)), "a", 0, 0, "position"),
        (LONE, ApplyImpulse("a", 0.3, (2.0, 0.0, 3.0)), "a", 0, 2, "position"),
        (FLOOR, SetVelocity("a", 0.0, (2.0, 0.0, 0.0)), "a", 0, 2, "position"),
        (FLOOR, SetVelocity("b", 0.0, (2.0, 0.0, 0.0), (0.0, 20.0, 0.0)), "b", 0, 2, "position"),
        (FLOOR, HoldVelocity("b", 0.0, 0.5, 1.0, 0.4, 2.0, roll_radius=0.1), "b", 0, 4, "position"),
        (FLOOR, HoldVelocity("b", 0.0, 0.5, 1.0, 0.4, 2.0, roll_radius=0.1), "b", 1, 3, "position"),
        (FLOOR, HoldVelocity("a", 0.0, 0.5, 2.0, 0.0), "a", 0, 1, "position"),
        (LONE, HoldVelocity("a", 0.2, 0.5, 2.0, 0.4, climb=0.5), "a", 2, 8, "position"),
        (LONE, HoldVelocity("a", 0.2, 0.5, 2.0, 0.4, climb=0.5), "a", 2, 0, "position"),
        (LONE, HoldVelocity("a", 0.2, 0.5, 2.0, 0.4, climb=0.5), "a", 2, 1, "position"),
        (LONE, HoldVelocity("a", 0.2, 0.5, 2.0, 0.4, climb=0.5), "a", 0, 2, "position"),
        (LONE, HoldVelocity("a", 0.2, 0.5, 2.0, 0.4, climb=0.5), "a", 2, 8, "velocity"),
        (LONE, HoldVelocity("a", 0.2, 0.5, 2.0, 0.4, gains=3.0, loses=2.0), "a", 0, 9, "position"),
        (LONE, HoldVelocity("a", 0.2, 0.5, 2.0, 0.4, gains=30.0, loses=9.0), "a", 1, 2, "position"),
        # Place and velocity of a path's last point, and a spin.
        (LONE, PATH, "a", 0, 19, "position"),
        (LONE, PATH, "a", 1, 23, "position"),
        (FLOOR, HoldSpin("b", 0.0, 0.5, 4.0, (0.0, 1.0, 0.0)), "b", 0, 3, "position"),
        (PAIR, SetVelocity("a", 0.0, (2.0, 0.0, 0.0)), "b", 0, 2, "velocity"),
        (PAIR, SetVelocity("a", 0.0, (2.0, 0.0, 0.0)), "b", 1, 3, "velocity"),
        (PAIR, SetVelocity("a", 0.0, (2.0, 0.0, 0.0)), "b", 0, 2, "position"),
        (PAIR, SetVelocity("a", 0.2, (2.0, 0.0, 0.0)), "b", 0, 0, "position"),
        (PAIR, SetVelocity("a", 0.0, (2.0, 0.0, 0.0)), "a", 0, 2, "position"),
    ],
)  # fmt: skip
def test_derivatives_by_the_program(scene, program, body, axis, column, field):
    tape, difference = table_gradient(
        scene, Program((program,), 0.9), body, axis, column, field=field
    )
    assert abs(difference) > 0.01
    assert tape == pytest.approx(difference, rel=0.03)


@pytest.mark.parametrize("axis", [0, 2])
def test_derivative_by_the_start_of_a_path(axis):
    """What starts later is let go later."""
    batch = batch_programs([Program((PATH,), 0.9)], LONE.names)
    taped, i, _ = final(LONE, batch, "a")
    seed = np.zeros((1, taped.frames.n_steps + 1, 1, 3))
    seed[0, -1, i, axis] = 1.0
    pulled = taped.pull(Seeds(position=seed)).table[0, 0]
    moved = [Program((replace(PATH, start=0.2 + d),), 0.9) for d in (4 * DT, -4 * DT)]
    ends = final(LONE, batch_programs(moved, LONE.names), "a")[2]
    difference = (ends[0, axis] - ends[1, axis]) / (8.0 * DT)
    assert abs(difference) > 0.1
    assert pulled[0] + pulled[1] == pytest.approx(difference, rel=0.03)


def test_derivative_by_the_time_of_braking():
    scene = SimScene("brake", (ball("a", 0.1, 1.0, (0, 0, 5.0)),), gravity=(0, 0, 0))
    program = Program(
        (SetVelocity("a", 0.0, (3.0, 0.0, 0.0)), AdjustProperties("a", 0.4, linear_damping=2.0)),
        1.0,
    )
    tape, difference = table_gradient(scene, program, "a", 0, 0, primitive=1)
    # The longer it runs free, the further it gets: v (1 - exp(-2 * 0.6)).
    assert difference == pytest.approx(3.0 * (1.0 - np.exp(-1.2)), rel=0.02)
    assert tape == pytest.approx(difference, rel=0.02)


@pytest.mark.parametrize(
    ("speed", "primitive", "column", "expected"),
    [
        # Slower at the end: x = v T - b (T - t)^2 / 2.
        (3.0, 1, Column.START, 2.0 * 0.6),
        (3.0, 1, Column.BRAKING, -0.5 * 0.6**2),
        # Stopped before the end: x = v t + v^2 / (2 b).
        (1.0, 1, Column.START, 1.0),
        (1.0, 1, Column.BRAKING, -0.5 / 2.0**2),
        (1.0, 0, Column.LINEAR, 0.4 + 1.0 / 2.0),
    ],
)
def test_derivatives_by_constant_braking(speed, primitive, column, expected):
    scene = SimScene("brake", (ball("a", 0.1, 1.0, (0, 0, 5.0)),), gravity=(0, 0, 0))
    program = Program(
        (SetVelocity("a", 0.0, (speed, 0.0, 0.0)), AdjustProperties("a", 0.4, braking=2.0)), 1.0
    )
    tape, difference = table_gradient(scene, program, "a", 0, int(column), primitive=primitive)
    assert tape == pytest.approx(expected, rel=0.02)
    assert difference == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize(("column", "axis"), [(Column.LINEAR, 0), (Column.LINEAR + 1, 1)])
def test_derivatives_of_what_stands_on_tyres(column, axis):
    """On it rolls, and to the side it slides v^2 / (2 mu g)."""
    car = box("a", (2.2, 0.9, 0.6), 1400.0, (0, 0, 0.6), friction=0.0, restitution=0.0)
    scene = SimScene(
        "tyres", (type(car)(**{**car.__dict__, "wheeled": True, "tyre_friction": 0.8}),)
    )
    program = Program((SetVelocity("a", 0.1, (3.0, 2.0, 0.0)),), 1.0)
    tape, difference = table_gradient(scene, program, "a", axis, int(column))
    expected = 0.9 if axis == 0 else 2.0 / (0.8 * 9.81)
    assert tape == pytest.approx(expected, rel=0.02)
    assert difference == pytest.approx(expected, rel=0.02)


def test_a_bounce_has_the_derivative_of_the_continuous_motion():
    """x(T) = L - e v (T - L / v): a step that ignores when the wall is hit is wrong by (1 + e) L / v."""
    wall = box("wall", (0.1, 1.0, 1.0), 1.0, (1.2, 0.0, 5.0), restitution=0.8)
    scene = SimScene(
        "wall",
        (ball("a", 0.1, 1.0, (0, 0, 5.0), restitution=0.8),
         type(wall)(**{**wall.__dict__, "static": True})),
        gravity=(0, 0, 0),
    )  # fmt: skip
    program = Program((SetVelocity("a", 0.0, (2.0, 0.0, 0.0)),), 1.0)
    tape, difference = table_gradient(scene, program, "a", 0, 2)
    assert tape == pytest.approx(-0.8 * 1.0, rel=0.01)
    assert difference == pytest.approx(-0.8 * 1.0, rel=0.01)


def test_derivatives_by_start_poses():
    batch = batch_programs([Program((SetVelocity("a", 0.0, (2.0, 0.0, 0.0)),), 0.9)], PAIR.names)
    position = np.array([[b.position for b in PAIR.bodies]])
    taped, i, _ = final(PAIR, batch, "b", variation=Variation(position=position))
    seed = np.zeros((1, taped.frames.n_steps + 1, 2, 3))
    seed[0, -1, i, 1] = 1.0
    pulled = taped.pull(Seeds(position=seed)).position[0, 0, 1]
    ends = []
    for shift in (0.003, -0.003):
        moved = position.copy()
        moved[0, 0, 1] += shift
        ends.append(final(PAIR, batch, "b", variation=Variation(position=moved))[2][0, 1])
    assert pulled == pytest.approx((ends[0] - ends[1]) / 0.006, rel=0.03)


def test_the_replay_repeats_the_rollout():
    batch = batch_programs([Program((SetVelocity("a", 0.1, (2.0, 0.0, 0.0)),), 0.9)], PAIR.names)
    taped = TapedRollout(PAIR, batch, dt=DT)
    np.testing.assert_allclose(taped.replayed_position(), taped.position, atol=2e-5)


def plan_of(story):
    doc = lay_out(story)
    return make_plan(doc, build_scene(doc), seed=0)


@pytest.mark.parametrize("story", [stories.car_hits_jeep_at_3s, stories.rear_end])
def test_event_losses_have_the_gradient_of_their_differences(story):
    plan = plan_of(story())
    assert ad_valid(plan)
    spread = np.array([v.spread for v in plan.variables]) * plan.free()
    check = check_gradient(plan, np.clip(plan.initial() + 0.6 * spread, plan.lower(), plan.upper()))
    assert check.smooth and check.trusted
    assert np.linalg.norm(check.differences) > 1e-3
    assert check.cosine > 0.99 and check.error < 0.1


def test_a_step_against_the_gradient_lowers_the_loss():
    plan = plan_of(stories.car_hits_jeep_at_3s())
    spread = np.array([v.spread for v in plan.variables]) * plan.free()
    theta = np.clip(plan.initial() + spread, plan.lower(), plan.upper())
    found = gradient(plan, theta[None])
    slope = found.gradient[0] * spread
    step = 0.1 * spread * slope / np.linalg.norm(slope)
    ends = gradient(plan, np.stack([theta - step, theta + step]), with_gradient=False).loss
    assert ends[0] < found.loss[0] < ends[1]
    assert (found.gradient[0][~plan.free()] == 0.0).all()


def test_gradients_do_not_depend_on_the_batch():
    plan = plan_of(stories.car_hits_jeep_at_3s())
    theta = plan.initial()
    other = np.clip(theta + 0.01, plan.lower(), plan.upper())
    alone = gradient(plan, theta[None])
    together = gradient(plan, np.stack([other, theta, other]))
    np.testing.assert_array_equal(alone.gradient[0], together.gradient[1])
    assert alone.loss[0] == together.loss[1]


def test_worlds_that_diverge_are_flagged_and_leave_the_others_alone():
    plan = plan_of(stories.car_hits_jeep_at_3s())
    bad = plan.initial().copy()
    bad[next(i for i, v in enumerate(plan.variables) if v.name.endswith("/speed"))] = 900.0
    found = gradient(plan, np.stack([plan.initial(), bad]))
    assert found.valid.tolist() == [True, False]
    assert np.isfinite(found.gradient).all() and (found.gradient[1] == 0.0).all()


def test_chains_are_told_from_direct_hits():
    chain = regimes(plan_of(stories.three_balls()))
    assert list(chain.values()).count(Regime.DIRECT) == 1
    assert Regime.ONE_CONTACT in chain.values()
    assert set(regimes(plan_of(stories.car_hits_jeep_at_3s())).values()) == {Regime.DIRECT}
