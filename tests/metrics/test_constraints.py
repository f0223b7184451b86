"""Every quantity on replays with known values, and the paper's PPA score."""

from __future__ import annotations

import math

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
import pytest

from esg.engines.program import AdjustProperties, HoldVelocity, SetVelocity
from esg.engines.scene import Shape
from esg.metrics import SuiteConstraint, SuiteEvent
from esg.metrics.quantities import THRESHOLDS, score, unit_factor
from tests.metrics.test_events import CHAIN, chain, slowing, turning
from tests.metrics.worlds import DT, World, ball, body, line


@pytest.mark.parametrize(
    ("measured", "target", "expected"),
    [
        # Paper, PPA: |x - x*| <= eps scores 1, else 1 - (|x - x*| - eps) / x*.
        (3.3, 3.0, 1.0),
        (2.7, 3.0, 1.0),
        (4.5, 3.0, 0.6),  # its S3 example: an error of 1.50 s scores 0.60
        (1.85, 1.0, 0.45),
        (0.0, 1.0, 0.3),
        (9.0, 1.0, 0.0),
        (0.31, 0.0, 0.0),
        (0.3, 0.0, 1.0),
    ],
)
def test_point_score(measured, target, expected):
    assert score(measured, target, None, "time") == pytest.approx(expected)


@pytest.mark.parametrize(
    ("measured", "expected"),
    # Paper: an interval scores 1 - 2 e / (b - a); its S8 example, an excess of 0.32 s in [2, 3].
    [(2.0, 1.0), (2.5, 1.0), (3.0, 1.0), (3.32, 0.36), (1.68, 0.36), (3.5, 0.0), (9.0, 0.0)],
)
def test_interval_score(measured, expected):
    assert score(measured, None, (2.0, 3.0), "time") == pytest.approx(expected)


def test_thresholds_are_the_papers():
    assert [THRESHOLDS["standard"][d] for d in ("time", "speed", "mass")] == [0.3, 1.0, 0.5]
    assert [THRESHOLDS["strict"][d] for d in ("time", "speed", "mass")] == [0.2, 0.5, 0.3]
    assert [THRESHOLDS["lenient"][d] for d in ("time", "speed", "mass")] == [0.5, 2.0, 1.0]
    # Its S8 example: a speed error of 2.92 m/s on 10 m/s scores 0.81 under the standard set.
    assert score(12.92, 10.0, None, "speed") == pytest.approx(0.808)
    assert score(12.92, 10.0, None, "speed", "strict") == pytest.approx(0.758)
    assert score(12.92, 10.0, None, "speed", "lenient") == pytest.approx(0.908)


@given(st.floats(-50, 50), st.floats(0.1, 20))
def test_score_is_a_fraction_and_lenient_is_never_below_strict(measured, target):
    values = [score(measured, target, None, "time", t) for t in ("strict", "standard", "lenient")]
    assert all(0.0 <= v <= 1.0 for v in values)
    assert values == sorted(values)


def test_nothing_measured_scores_zero():
    assert score(None, 1.0, None, "time") == 0.0
    assert score(math.nan, 1.0, None, "time") == 0.0


def test_units_of_other_dimensions_are_refused():
    with pytest.raises(ValueError, match="unit of mass"):
        unit_factor("speed", "kg")


def measured(world: World, events, **fields):
    """The verdict on one constraint."""
    item = SuiteConstraint.model_validate({"kind": "outcome", "value": 1.0, **fields})
    return world.judge(events, [item]).constraints[0]


HIT = CHAIN[:1]


def test_mass_is_the_simulated_one():
    world = World().add(body("crate_1", mass=7.5))
    found = measured(world, [], kind="initial", quantity="mass", object="crate", value=7.0)
    assert found.measured == 7.5
    assert (found.score, found.score_strict) == (1.0, pytest.approx(1 - 0.2 / 7))


def test_of_several_alike_the_one_that_acts_is_measured():
    """Take the speed of the ball that hits the box, not of another ball that lies there."""
    world = World().add(ball("ball_1"), x=line(0.0, 2.0)).add(ball("ball_2"), x=-9.0)
    world.add(body("box_1"), x=2.2).touch(1.0, "ball_1", "box_1")
    world.run(SetVelocity("ball_1", 0.0, (2, 0, 0)))
    event = SuiteEvent(id="e1", type="collision", a="ball", b="box")
    found = measured(world, [event], kind="initial", quantity="speed", object="ball", at="start")
    assert found.measured == pytest.approx(2.0, rel=1e-3)


def test_speed_at_start_is_what_the_program_sets():
    world = World().add(body("car_1"), x=line(0.0, 10.0)).run(HoldVelocity("car_1", 0, 3, 10, 0))
    found = measured(world, [], kind="initial", quantity="speed", object="car", at="start")
    assert found.measured == pytest.approx(10.0, rel=1e-3)
    later = World().add(body("car_1"), x=line(0.0, 4.0, 1.0))
    later.run(SetVelocity("car_1", 1.0, (4, 0, 0)))
    found = measured(later, [], kind="initial", quantity="speed", object="car", at="start")
    assert found.measured == pytest.approx(4.0, rel=1e-3)


def test_of_a_set_every_member_must_hold_initially():
    world = World()
    for k, speed in ((1, 6.0), (2, 12.0)):
        world.add(body(f"car_{k}"), x=line(0, speed), y=3.0 * k)
        world.run(HoldVelocity(f"car_{k}", 0, 3, speed, 0))
    found = measured(
        world, [], kind="initial", quantity="speed", object="cars", at="start",
        value=None, range=(5.0, 10.0),
    )  # fmt: skip
    assert found.measured == pytest.approx(12.0, rel=1e-3)
    assert found.score == pytest.approx(0.2, abs=0.01)


def test_speed_just_before_an_event():
    found = measured(chain(0.4, 0.8), CHAIN, quantity="speed", object="ball 1", at="e1", value=2.0)
    assert found.measured == pytest.approx(2.0, rel=1e-3)
    before = measured(chain(0.4, 0.8), CHAIN, quantity="speed", object="ball 2", at="e1")
    assert before.measured == pytest.approx(0.0, abs=1e-3)


def test_speed_after_is_the_largest_in_a_tenth_second_after_the_last_contact():
    def boosted(t: np.ndarray) -> np.ndarray:
        return 1.0 + 2.0 * np.clip(t - 0.4, 0, 0.1) + 3.0 * np.clip(t - 0.5, 0, 0.02)

    world = World().add(ball("ball_1"), x=line(0, 2, 0, 0.4)).add(ball("ball_2"), x=boosted)
    world.touch(0.4, "ball_1", "ball_2")
    ask = {"quantity": "speed_after", "object": "ball 2", "event": "e1"}
    assert measured(world, HIT, **ask).measured == pytest.approx(2.0, rel=1e-2)
    world.touch(0.44, "ball_1", "ball_2")
    assert measured(world, HIT, **ask).measured == pytest.approx(3.0, rel=1e-2)


def test_time_and_time_since():
    world = chain(0.4, 0.8)
    assert measured(world, CHAIN, quantity="time", event="e2").measured == pytest.approx(0.8)
    since = measured(world, CHAIN, quantity="time_since", event="e2", since="e1")
    assert since.measured == pytest.approx(0.4)
    start = measured(world, CHAIN, quantity="time_since", event="e2", since="start")
    assert start.measured == pytest.approx(0.8)


def test_outcome_scores_zero_if_its_event_is_incomplete():
    world = chain(0.4, 0.8)
    world.contacts = world.contacts[:1]
    found = measured(world, CHAIN, quantity="time", event="e2", value=0.8)
    assert (found.measured, found.score, found.score_lenient) == (None, 0.0, 0.0)
    assert "e2" in found.reason
    since = measured(world, CHAIN, quantity="time_since", event="e1", since="e2")
    assert since.measured is None


def test_initial_is_scored_whatever_happens():
    world = chain(0.4, 0.8)
    world.contacts = []
    found = measured(world, CHAIN, kind="initial", quantity="mass", object="ball 1")
    assert found.score == 1.0


STOP = [SuiteEvent(id="e1", type="stops", object="car")]


def braked() -> World:
    """10 m/s, linear braking from 1 s to rest at 3 s."""

    def path(t: np.ndarray) -> np.ndarray:
        s = np.clip(t - 1.0, 0.0, 2.0)
        return 10.0 * np.minimum(t, 1.0) + 10.0 * s - 2.5 * s**2

    world = World(4.0).add(body("car_1"), x=path)
    return world.run(
        HoldVelocity("car_1", 0.0, 1.0, 10.0, 0.0),
        HoldVelocity("car_1", 1.0, 3.0, 10.0, 0.0, acceleration=-5.0),
    )


def test_time_to_stop_runs_from_the_start_of_braking():
    found = measured(
        braked(), STOP, quantity="time_to_stop", object="car", event="e1",
        value=None, range=(1.0, 3.0),
    )  # fmt: skip
    # Speed falls under 0.1 m/s 0.02 s before rest.
    assert found.measured == pytest.approx(1.98, abs=2 * DT)
    assert found.score == 1.0


def test_time_to_stop_takes_several_brakings_in_a_row_as_one():
    world = World(8.0).add(body("car_1"), x=slowing(2.0))
    world.run(*(AdjustProperties("car_1", 1.0 + 0.3 * k, linear_damping=2.0 + k) for k in range(3)))
    found = measured(world, STOP, quantity="time_to_stop", object="car", event="e1")
    assert found.measured == pytest.approx(np.log(80) / 2, abs=0.02)


def test_time_to_stop_of_what_only_physics_slows():
    def path(t: np.ndarray) -> np.ndarray:
        s = np.clip(t, 0.0, 2.0)
        return 4.0 * s - s**2

    world = World(4.0).add(ball("ball_1"), x=path).run(SetVelocity("ball_1", 0.0, (4, 0, 0)))
    events = [SuiteEvent(id="e1", type="stops", object="ball")]
    found = measured(world, events, quantity="time_to_stop", object="ball", event="e1")
    assert found.measured == pytest.approx(1.95, abs=0.02)


def test_distance_to_a_target_is_between_surfaces():
    world = World().add(body("car_1"), x=line(0.0, 1.0)).add(body("wall_1", static=True), x=5.0)
    ask = {"kind": "initial", "quantity": "distance", "object": "car", "at": "start"}
    assert measured(world, [], target="wall", **ask).measured == pytest.approx(4.8)
    # Without a target: the other participant of its event.
    events = [SuiteEvent(id="e1", type="reaches", object="car", target="wall")]
    assert measured(world, events, **ask).measured == pytest.approx(4.8)
    lonely = measured(World().add(body("car_1")), [], **ask)
    assert lonely.measured is None


def test_distance_travelled():
    found = measured(braked(), STOP, quantity="distance", object="car", event="e1", value=10.0)
    assert found.measured == pytest.approx(10.0, abs=0.05)
    world = (
        World()
        .add(ball("ball_1"), x=line(0, 2, 0, 0.4))
        .add(ball("ball_2"), x=line(1, 2, 0.4, 1.9))
    )
    world.touch(0.4, "ball_1", "ball_2")
    after = measured(world, HIT, quantity="distance", object="ball 2", event="e1", value=3.0)
    assert after.measured == pytest.approx(3.0, abs=0.05)
    until = measured(world, HIT, quantity="distance", object="ball 1", at="e1")
    assert until.measured == pytest.approx(0.8, abs=0.02)


def test_height_is_of_the_lowest_point():
    world = World().add(ball("ball_1"), z=lambda t: np.maximum(0.1, 2.0 - 4.905 * t**2))
    ask = {"quantity": "height", "object": "ball"}
    start = measured(world, [], kind="initial", at="start", **ask)
    assert start.measured == pytest.approx(1.9, abs=1e-3)

    def bounce(t: np.ndarray) -> np.ndarray:
        return np.where(
            t < 0.5, 1.0 - 1.8 * t, 0.1 + np.maximum(0, 3 * (t - 0.5) - 4.9 * (t - 0.5) ** 2)
        )

    events = [SuiteEvent(id="e1", type="collision", a="ball", b="ground")]
    bouncing = World().add(ball("ball_1"), z=bounce).touch(0.5, "ball_1", "ground", 3.0)
    top = measured(bouncing, events, event="e1", **ask)
    assert top.measured == pytest.approx(9 / (4 * 4.9), abs=0.01)


def test_height_of_what_stands_on_the_ground_is_its_own():
    """A counter "90 cm high" has no other height; what hangs too low is no taller for that."""
    shape = Shape("box", (0.3, 0.6, 0.45))
    counter = body("counter_1", shape, half_extents=shape.size)
    ask = {"quantity": "height", "object": "counter", "kind": "initial", "at": "start"}
    world = World().add(counter, z=0.45)
    assert measured(world, [], value=0.9, **ask).measured == pytest.approx(0.9)
    assert measured(world, [], value=0.0, **ask).measured == pytest.approx(0.0, abs=0.01)
    hung = World().add(counter, z=0.75)
    assert measured(hung, [], value=0.9, **ask).measured == pytest.approx(0.3)


def test_angles():
    turn = [SuiteEvent(id="e1", type="turns", object="car", direction="left", degrees=60)]
    world = World().add(body("car_1"), x=line(0, 5), yaw_deg=turning(60))
    ask = {"quantity": "angle", "object": "car", "event": "e1"}
    assert measured(world, turn, **ask).measured == pytest.approx(60, abs=0.5)
    thrown = World().add(ball("ball_1"), x=line(0, 3), z=lambda t: 0.1 + 3 * t)
    thrown.run(SetVelocity("ball_1", 0.0, (3, 0, 3)))
    launch = measured(thrown, [], kind="initial", quantity="angle", object="ball", at="start")
    assert launch.measured == pytest.approx(45.0, abs=0.2)
    bounced = World().add(
        ball("ball_1"), x=line(0, 2, 0, 0.5), y=lambda t: 2 * np.maximum(t - 0.5, 0)
    )
    bounced.add(body("wall_1", static=True), x=1.2).touch(0.5, "ball_1", "wall_1")
    hit = [SuiteEvent(id="e1", type="collision", a="ball", b="wall")]
    found = measured(bounced, hit, quantity="angle", object="ball", event="e1")
    assert found.measured == pytest.approx(90.0, abs=1.0)
    toppled = World().add(body("car_1"), pitch_deg=turning(80))
    top = [SuiteEvent(id="e1", type="topples", object="car")]
    assert measured(toppled, top, **ask).measured == pytest.approx(80, abs=0.1)


def test_an_unbound_object_scores_zero():
    found = measured(World().add(body("car_1")), [], kind="initial", quantity="mass", object="ship")
    assert (found.measured, found.score) == (None, 0.0)
    assert "ship" in found.reason


def test_verdict_ppa_is_the_mean_over_constraints():
    items = [
        SuiteConstraint(kind="initial", quantity="mass", object="ball 1", value=1.0),
        SuiteConstraint(kind="outcome", quantity="time", event="e2", value=9.0),
    ]
    verdict = chain(0.4, 0.8).judge(CHAIN, items)
    assert verdict.ppa() == pytest.approx((1.0 + 1 - (8.2 - 0.3) / 9) / 2)
    assert chain(0.4, 0.8).judge(CHAIN).ppa() is None
