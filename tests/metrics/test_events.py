"""Every event type, completed and not, on replays with known answers."""

from __future__ import annotations

import numpy as np
import pytest

from esg.engines.program import AdjustProperties, ApplyImpulse, HoldVelocity, SetVelocity
from esg.engines.scene import Region, Shape
from esg.metrics import SuiteEvent
from tests.metrics.worlds import DT, World, ball, body, line

HIT = {"type": "collision", "a": "ball 1", "b": "ball 2"}


def two_balls(duration: float = 3.0, dt: float = DT) -> World:
    """Ball 1 rolls into ball 2 at 0.4 s and hands over its speed."""
    world = World(duration, dt)
    world.add(ball("ball_1"), x=line(0.0, 2.0, 0.0, 0.4))
    world.add(ball("ball_2"), x=line(1.0, 2.0, 0.4))
    return world


def test_collision_is_completed_at_its_first_contact():
    found = two_balls().touch(0.4, "ball_1", "ball_2", 2.0).event(**HIT)
    assert found.completed
    assert found.time_s == pytest.approx(0.4)
    assert found.bodies == ("ball_1", "ball_2")
    assert found.measured["impulse_ns"] == pytest.approx(2.0)


def test_collision_needs_a_contact():
    found = two_balls().event(**HIT)
    assert not found.completed
    assert "never touches" in found.reason


@pytest.mark.parametrize(("impulse", "completed"), [(0.1, False), (0.11, True)])
def test_collision_needs_more_than_a_tenth_newton_second(impulse, completed):
    world = two_balls().touch(0.4, "ball_1", "ball_2", impulse)
    assert world.event(**HIT).completed is completed


def test_impulse_is_accumulated_over_the_first_twentieth_second():
    world = two_balls()
    for k in range(4):
        world.touch(0.4 + k * DT, "ball_1", "ball_2", 0.03)
    assert world.event(**HIT).measured["impulse_ns"] == pytest.approx(0.12)
    late = two_balls().touch(0.4, "ball_1", "ball_2", 0.03)
    for k in range(12, 30):
        late.touch(0.4 + k * DT, "ball_1", "ball_2", 0.03)
    assert not late.event(**HIT).completed


def test_impulse_is_accumulated_over_three_frames_of_a_slow_recording():
    world = two_balls(3.0, 1 / 30)
    for k in range(3):
        world.touch(0.4 + k / 30, "ball_1", "ball_2", 0.04)
    assert world.event(**HIT).completed


@pytest.mark.parametrize(("depth", "completed"), [(0.049, True), (0.05, False)])
def test_collision_is_less_than_five_centimetres_deep(depth, completed):
    world = two_balls().touch(0.4, "ball_1", "ball_2", 2.0, depth)
    assert world.event(**HIT).completed is completed


def test_collision_fails_if_bodies_stay_inside_each_other():
    world = World()
    world.add(ball("ball_1"), x=line(0.0, 2.0, 0.0, 0.4)).add(ball("ball_2"), x=0.97)
    found = world.touch(0.4, "ball_1", "ball_2", 2.0).event(**HIT)
    assert not found.completed
    assert "0.2 s after" in found.reason


def test_collision_counts_only_within_fifteen_seconds():
    world = World(16.0, 1 / 60)
    world.add(ball("ball_1"), x=line(0.0, 2.0, 15.0, 15.4)).add(ball("ball_2"), x=1.0)
    found = world.touch(15.4, "ball_1", "ball_2", 2.0).event(**HIT)
    assert not found.completed
    assert "15 s" in found.reason


def test_collision_needs_its_recheck_within_the_replay():
    world = two_balls(0.5).touch(0.4, "ball_1", "ball_2", 2.0)
    assert "before the re-check" in world.event(**HIT).reason


def test_a_later_hit_of_the_pair_counts_if_the_first_does_not():
    world = two_balls().touch(0.4, "ball_1", "ball_2", 0.05).touch(0.9, "ball_1", "ball_2", 1.0)
    assert world.event(**HIT).time_s == pytest.approx(0.9)


def test_a_blow_on_a_resting_contact_is_a_hit_of_its_own():
    world = World().add(ball("ball_1"), x=0.0).add(ball("ball_2"), x=0.2)
    for k in range(1, 200):
        world.touch(k * DT, "ball_1", "ball_2", 0.001)
    assert not world.event(**HIT).completed
    blown = World().add(ball("ball_1"), x=0.0).add(ball("ball_2"), x=0.2)
    for k in range(1, 200):
        blown.touch(k * DT, "ball_1", "ball_2", 0.5 if k == 120 else 0.001)
    assert blown.event(**HIT).time_s == pytest.approx(0.5)


def test_pushing_is_one_hit():
    world = World().add(ball("ball_1"), x=0.0).add(ball("ball_2"), x=0.2).add(ball("ball_3"), x=9)
    for k in range(100, 400):
        world.touch(k * DT, "ball_1", "ball_2", 0.2 + 0.1 * (k % 3))
    world.touch(350 * DT, "ball_2", "ball_3", 1.0)
    events = [
        SuiteEvent(id="e1", type="collision", a="ball 2", b="ball 3"),
        SuiteEvent(id="e2", type="collision", a="ball 1", b="ball 2", after=("e1",)),
    ]
    assert [e.completed for e in world.judge(events).events] == [True, False]


def chain(first: float, second: float, **more: object) -> World:
    world = World()
    world.add(ball("ball_1"), x=line(0.0, 2.0, 0.0, first))
    world.add(ball("ball_2"), x=line(1.0, 2.0, first, second))
    world.add(ball("ball_3"), x=3.0)
    return world.touch(first, "ball_1", "ball_2").touch(second, "ball_2", "ball_3")


CHAIN = [
    SuiteEvent(id="e1", type="collision", a="ball 1", b="ball 2"),
    SuiteEvent(id="e2", type="collision", a="ball 2", b="ball 3", after=("e1",)),
]


def test_chain_in_order_is_completed():
    verdict = chain(0.4, 0.8).judge(CHAIN)
    assert [e.completed for e in verdict.events] == [True, True]
    assert verdict.completed == 2


@pytest.mark.parametrize(("second", "completed"), [(0.45, False), (0.51, True), (0.3, False)])
def test_chained_hits_are_a_tenth_of_a_second_apart_and_in_order(second, completed):
    assert chain(0.4, second).judge(CHAIN).events[1].completed is completed


def test_later_event_counts_only_if_the_earlier_one_was_completed():
    world = chain(0.4, 0.8)
    world.contacts = [c for c in world.contacts if c[2] != "ball_2"]
    verdict = world.judge(CHAIN)
    assert not verdict.events[1].completed
    assert "e1" in verdict.events[1].reason


def test_chain_takes_the_first_later_hit_of_a_pair_that_also_met_before():
    world = chain(0.4, 0.2).touch(1.2, "ball_2", "ball_3")
    assert world.judge(CHAIN).events[1].time_s == pytest.approx(1.2)


def test_any_member_of_a_plural_counts():
    world = World()
    world.add(ball("ball_1", category="bowling_ball"), x=line(0.0, 2.0, 0.0, 0.4))
    for k in range(3):
        world.add(body(f"bowling_pin_{k + 1}", category="bowling_pin"), x=1.0, y=0.3 * k)
    world.touch(0.4, "ball_1", "bowling_pin_2")
    found = world.event(type="collision", a="bowling ball", b="bowling pins")
    assert found.completed
    assert found.bodies == ("ball_1", "bowling_pin_2")


def test_hit_on_the_ground_is_read_from_the_log():
    world = World()
    world.add(ball("ball_1"), z=lambda t: np.maximum(0.1, 1.0 - 4.9 * t**2))
    world.touch(0.43, "ball_1", "ground", 2.0)
    assert world.event(type="collision", a="ball", b="ground").time_s == pytest.approx(0.43)


def test_hit_on_the_ground_is_inferred_without_ground_contacts():
    world = World()
    world.add(ball("ball_1"), z=lambda t: np.maximum(0.1, 1.0 - 4.905 * t**2))
    found = world.event(type="collision", a="ball", b="ground")
    assert found.time_s == pytest.approx((0.9 / 4.905) ** 0.5, abs=2 * DT)
    resting = World().add(ball("ball_1"))
    assert not resting.event(type="collision", a="ball", b="ground").completed


def test_moves_under_its_own_control():
    world = (
        World().add(body("car_1"), x=line(0.0, 5.0, 0.5)).run(HoldVelocity("car_1", 0.5, 3, 5, 0))
    )
    found = world.event(type="moves", object="car")
    assert found.completed
    assert found.time_s == pytest.approx(0.5, abs=2 * DT)


def test_moves_counts_a_throw_but_not_a_push():
    thrown = World().add(body("car_1"), x=line(0.0, 5.0)).run(SetVelocity("car_1", 0.0, (5, 0, 0)))
    assert thrown.event(type="moves", object="car").completed
    kicked = World().add(body("car_1"), x=line(0.0, 5.0)).run(ApplyImpulse("car_1", 0.0, (5, 0, 0)))
    assert kicked.event(type="moves", object="car").completed
    pushed = World().add(body("car_1"), x=line(0.0, 5.0))
    assert "nothing drives" in pushed.event(type="moves", object="car").reason


@pytest.mark.parametrize(("seconds", "completed"), [(0.4, False), (0.6, True)])
def test_moves_for_half_a_second(seconds, completed):
    world = World().add(body("car_1"), x=line(0.0, 1.0, 0.1, 0.1 + seconds))
    world.run(HoldVelocity("car_1", 0.1, 3.0, 1.0, 0.0))
    assert world.event(type="moves", object="car").completed is completed


def test_moves_faster_than_a_fifth_metre_per_second():
    world = World().add(body("car_1"), x=line(0.0, 0.19)).run(HoldVelocity("car_1", 0, 3, 0.19, 0))
    assert not world.event(type="moves", object="car").completed


def slowing(rate: float, start: float = 1.0, speed: float = 8.0):
    """Constant speed, then exponential decay with `rate` [1/s] from `start` on."""

    def path(t: np.ndarray) -> np.ndarray:
        s = np.maximum(t - start, 0.0)
        decayed = speed * (1 - np.exp(-rate * s)) / rate if rate else speed * s
        return speed * np.minimum(t, start) + decayed

    return path


BRAKE = AdjustProperties("car_1", 1.0, linear_damping=2.0)


def test_brakes_when_its_program_brakes_it_and_speed_halves():
    world = World().add(body("car_1"), x=slowing(2.0)).run(BRAKE)
    found = world.event(type="brakes", object="car")
    assert found.completed
    assert found.time_s == pytest.approx(1.0)
    assert found.measured["halved_at_s"] == pytest.approx(1.0 + np.log(2) / 2, abs=0.02)


def test_brakes_needs_a_braking_program():
    world = (
        World().add(body("car_1"), x=slowing(2.0)).run(HoldVelocity("car_1", 0.0, 1.0, 8.0, 0.0))
    )
    assert "never brakes" in world.event(type="brakes", object="car").reason
    lowered = World().add(body("car_1", linear_damping=3.0), x=slowing(2.0)).run(BRAKE)
    assert not lowered.event(type="brakes", object="car").completed


def test_brakes_counts_friction_and_a_decelerating_hold():
    rough = World().add(body("car_1"), x=slowing(2.0))
    rough.run(AdjustProperties("car_1", 1.0, friction=1.5))
    assert rough.event(type="brakes", object="car").completed
    hold = World().add(body("car_1"), x=slowing(2.0))
    hold.run(HoldVelocity("car_1", 1.0, 3.0, 8.0, 0.0, acceleration=-4.0))
    assert hold.event(type="brakes", object="car").completed


def test_brakes_fails_if_speed_does_not_halve():
    world = World(2.0).add(body("car_1"), x=slowing(0.5)).run(BRAKE)
    assert "slows from" in world.event(type="brakes", object="car").reason


def test_brakes_must_halve_before_the_next_event_of_the_object():
    events = [
        SuiteEvent(id="e1", type="brakes", object="car"),
        SuiteEvent(id="e2", type="collision", a="car", b="wall", after=("e1",)),
    ]

    def world(hit: float) -> World:
        w = World().add(body("car_1"), x=slowing(2.0))
        w.add(body("wall_1", static=True), x=50.0).run(BRAKE)
        return w.touch(hit, "car_1", "wall_1", 100.0)

    assert world(1.6).judge(events).completed == 2
    early = world(1.2).judge(events)
    assert [e.completed for e in early.events] == [False, False]


def test_brakes_after_an_event_must_start_later():
    events = [
        SuiteEvent(id="e1", type="collision", a="car", b="cone"),
        SuiteEvent(id="e2", type="brakes", object="car", after=("e1",)),
    ]
    world = World().add(body("car_1"), x=slowing(2.0)).add(body("cone_1"), y=5.0).run(BRAKE)
    assert world.touch(0.5, "car_1", "cone_1").judge(events).completed == 2
    world.contacts.clear()
    assert world.touch(1.5, "car_1", "cone_1").judge(events).completed == 1


def test_stops_after_it_had_moved():
    world = World().add(body("car_1"), x=line(0.0, 5.0, 0.0, 1.0))
    found = world.event(type="stops", object="car")
    assert found.time_s == pytest.approx(1.0, abs=2 * DT)
    assert "never moves" in World().add(body("car_1")).event(type="stops", object="car").reason
    going = World().add(body("car_1"), x=line(0.0, 5.0)).event(type="stops", object="car")
    assert "still moves" in going.reason


def test_stops_for_a_fifth_of_a_second():
    def pause(t: np.ndarray) -> np.ndarray:
        return 2.0 * np.minimum(t, 1.0) + 2.0 * np.maximum(t - 1.15, 0.0)

    world = World().add(body("car_1"), x=pause)
    assert not world.event(type="stops", object="car").completed


def turning(degrees: float, start: float = 0.5, seconds: float = 1.0):
    return lambda t: degrees * np.clip((t - start) / seconds, 0.0, 1.0)


TURN = {"type": "turns", "object": "car", "direction": "left"}


@pytest.mark.parametrize(
    ("degrees", "direction", "completed"),
    [
        (90, "left", True),
        (71, "left", True),
        (109, "left", True),
        (65, "left", False),
        (115, "left", False),
        (-90, "left", False),
        (-90, "right", True),
        (90, "right", False),
    ],
)
def test_turns_by_ninety_degrees_within_twenty(degrees, direction, completed):
    world = World().add(body("car_1"), x=line(0, 5), yaw_deg=turning(degrees))
    assert world.event(**{**TURN, "direction": direction}).completed is completed


def test_turns_takes_the_angle_from_the_suite_and_unwraps():
    world = World().add(body("car_1"), x=line(0, 5), yaw_deg=lambda t: 150 + turning(180)(t))
    found = world.event(**{**TURN, "degrees": 180})
    assert found.completed
    assert found.measured["turned_deg"] == pytest.approx(180, abs=1)
    # The event's time is when the heading first comes within the tolerance.
    assert found.time_s == pytest.approx(0.5 + 160 / 180, abs=0.02)


def test_turns_are_told_apart_in_sequence():
    def snake(t: np.ndarray) -> np.ndarray:
        return turning(90, 0.3, 0.7)(t) - turning(90, 1.5, 0.7)(t)

    events = [
        SuiteEvent(id="e1", type="turns", object="car", direction="left"),
        SuiteEvent(id="e2", type="turns", object="car", direction="right", after=("e1",)),
    ]
    world = World().add(body("car_1"), x=line(0, 5), yaw_deg=snake)
    assert world.judge(events).completed == 2
    events[1] = events[1].model_copy(update={"direction": "left"})
    assert world.judge(events).completed == 1


def test_a_ball_turns_with_its_course():
    def bend(t: np.ndarray) -> np.ndarray:
        return 2.0 * np.maximum(t - 1.0, 0.0)

    world = World().add(ball("ball_1"), x=line(0, 2, 0.0, 1.0), y=bend)
    assert world.event(type="turns", object="ball", direction="left").completed


def pocket_world(x) -> World:
    table = body("table_1", Shape("box", (1.0, 0.5, 0.4)), static=True)
    world = World().add(table).add(ball("ball_1", 0.03), x=x, z=0.83)
    return world.region(
        Region("table_1/corner pocket", "table_1", (0.9, 0.0, 0.4), (0.08, 0.08, 0.1), "pocket")
    )


ENTER = {"type": "enters", "object": "ball", "target": "corner pocket"}


def test_enters_and_stays():
    found = pocket_world(line(0.0, 1.0, 0.0, 0.9)).event(**ENTER)
    assert found.completed
    assert found.time_s == pytest.approx(0.82, abs=2 * DT)


def test_enters_fails_when_it_passes_through_or_misses():
    assert "only" in pocket_world(line(0.0, 2.0)).event(**ENTER).reason
    assert "never enters" in pocket_world(line(0.0, 1.0, 0.0, 0.5)).event(**ENTER).reason


def test_enters_counts_dropping_below():
    world = pocket_world(line(0.0, 2.0, 0.0, 0.45))
    drop = 0.83 - 8.0 * np.maximum(world.time - 0.42, 0.0) ** 2
    world.paths[1][:, 2] = np.where(world.time < 0.42, 0.83, drop - 0.5 * (world.time > 0.47))
    assert world.event(**ENTER).completed


def test_enters_does_not_count_what_is_inside_from_the_start():
    assert not pocket_world(0.9).event(**ENTER).completed


def test_enters_a_moving_container():
    cart = body("cart_1", Shape("box", (0.5, 0.5, 0.4)), category="cart")
    world = World().add(cart, x=line(0.0, 1.0), yaw_deg=90.0)
    world.add(ball("ball_1"), x=line(2.0, 1.0), y=0.0, z=lambda t: 0.5 + 0 * t)
    world.region(Region("cart_1/inside", "cart_1", (0.0, 0.0, 0.1), (0.4, 0.2, 0.3), "inside"))
    world.paths[1][:, 0] = world.paths[0][:, 0] + np.maximum(2.0 - 2 * world.time, 0.1)
    assert world.event(type="enters", object="ball", target="cart").completed


def fall(start: float, z0: float, floor: float):
    return lambda t: np.maximum(floor, z0 - 4.905 * np.maximum(t - start, 0.0) ** 2)


def test_falls_below_half_its_height():
    table = body("table_1", Shape("box", (0.5, 0.5, 0.4)), static=True)
    world = (
        World().add(table).add(body("vase_1"), x=line(0.3, 1.0, 0.2, 1.0), z=fall(0.5, 0.9, 0.1))
    )
    found = world.event(type="falls", object="vase", **{"from": "table"})
    assert found.completed
    assert found.time_s == pytest.approx(0.5 + (0.1 / 4.905) ** 0.5, abs=0.02)
    low = World().add(table).add(body("vase_1"), z=lambda t: 0.9 - 0.09 * (t > 1))
    assert "needs 0.10 m" in low.event(type="falls", object="vase").reason


def test_falls_from_a_support_it_was_never_on():
    table = body("table_1", Shape("box", (0.5, 0.5, 0.4)), static=True)
    world = World().add(table).add(body("vase_1"), x=5.0, z=fall(0.5, 0.9, 0.1))
    assert world.event(type="falls", object="vase").completed
    assert "was never on" in world.event(type="falls", object="vase", **{"from": "table"}).reason


@pytest.mark.parametrize(("leaves", "completed"), [(0.8, True), (0.3, False)])
def test_falls_from_what_has_toppled_under_it(leaves, completed):
    """On its way down when the pedestal counts as toppled; not if it lies there already."""
    pedestal = body("pedestal_1", Shape("box", (0.3, 0.3, 0.45)))
    world = World().add(pedestal, z=0.45, pitch_deg=turning(90))
    world.add(body("vase_1"), x=line(0.0, 3.0, leaves), z=fall(leaves, 1.05, 0.1))
    events = [
        {"id": "e1", "type": "topples", "object": "pedestal"},
        {"id": "e2", "type": "falls", "object": "vase", "from": "pedestal", "after": ["e1"]},
    ]
    toppled, fallen = world.judge(events).events
    assert toppled.completed
    assert fallen.completed is completed


def test_a_dropped_ball_falls():
    world = World().add(ball("ball_1"), z=fall(0.0, 2.0, 0.1))
    assert world.event(type="falls", object="ball").completed


@pytest.mark.parametrize(("tilt", "completed"), [(44.0, False), (46.0, True), (90.0, True)])
def test_topples_by_more_than_forty_five_degrees(tilt, completed):
    world = World().add(body("pin_1"), pitch_deg=turning(tilt))
    found = world.event(type="topples", object="pin")
    assert found.completed is completed
    yawing = World().add(body("pin_1"), yaw_deg=turning(170))
    assert not yawing.event(type="topples", object="pin").completed


@pytest.mark.parametrize(
    ("due", "completed"), [(0.5 + 30.0 / 90.0, True), (0.5 + 69.0 / 90.0, False)]
)
def test_topples_from_the_initial_pose_whatever_the_tilt_when_it_is_due(due, completed):
    """A domino of 30 degrees has 15 to go; one of 69 has toppled before and slews while it lies."""
    slews = lambda t: 80.0 * np.clip((t - 1.6) / 0.5, 0.0, 1.0)  # noqa: E731
    world = World().add(body("domino_1"), pitch_deg=turning(90), yaw_deg=slews)
    world.add(body("domino_2"), x=5.0).add(body("ball_1"), x=line(0.0, 1.0)).touch(
        due, "ball_1", "domino_2"
    )
    events = [
        {"id": "e1", "type": "collision", "a": "ball", "b": "=domino_2"},
        {"id": "e2", "type": "topples", "object": "=domino_1", "after": ["e1"]},
    ]
    found = world.judge([SuiteEvent.model_validate(e) for e in events]).events[1]
    assert found.completed is completed
    if completed:
        assert found.time_s == pytest.approx(1.0, abs=2 * DT)
    else:
        assert "tilts by 69 degrees before" in found.reason


@pytest.mark.parametrize(("gap", "completed"), [(0.29, True), (0.31, False)])
def test_reaches_within_thirty_centimetres_of_the_surface(gap, completed):
    world = World().add(body("car_1"), x=line(0.0, 1.0, 0.0, 3.0 - 0.2 - gap))
    world.add(body("wall_1", static=True), x=3.0)
    assert world.event(type="reaches", object="car", target="wall").completed is completed


def test_reaches_is_an_approach_and_may_aim_at_a_point():
    near = World().add(body("car_1")).add(body("wall_1", static=True), x=0.4)
    assert "from the start" in near.event(type="reaches", object="car", target="wall").reason
    world = World().add(body("car_1"), x=line(0.0, 1.0))
    found = world.event(type="reaches", object="car", target="@2,0,0.1")
    assert found.time_s == pytest.approx(2.0 - 0.1 - 0.3, abs=2 * DT)


def test_misses_is_the_absence_of_contact():
    world = World().add(body("car_1"), x=line(-3, 2)).add(body("bin_1"), y=1.0)
    found = world.event(type="misses", a="car", b="bin")
    assert found.time_s == pytest.approx(1.5, abs=DT)
    assert found.measured["center_distance_m"] == pytest.approx(1.0)
    assert not world.touch(1.5, "car_1", "bin_1").event(type="misses", a="car", b="bin").completed


def test_a_diverged_world_completes_nothing():
    world = two_balls().touch(0.4, "ball_1", "ball_2", 2.0)
    verdict = world.judge([SuiteEvent(id="e1", **HIT)], valid=False)
    assert verdict.completed == 0
    assert "diverged" in verdict.events[0].reason


def test_unbound_participants_make_events_incomplete_and_slr_fail():
    verdict = two_balls().judge([SuiteEvent(id="e1", type="collision", a="ball 1", b="dragon")])
    assert not verdict.slr
    assert not verdict.events[0].completed
    assert "dragon" in verdict.layout.missing[0]


def test_concurrent_events_share_their_predecessor():
    events = [
        SuiteEvent(id="e1", type="collision", a="ball 1", b="ball 2"),
        SuiteEvent(id="e2", type="stops", object="ball 1", after=("e1",)),
        SuiteEvent(id="e3", type="collision", a="ball 2", b="ball 3", after=("e1",)),
    ]
    assert chain(0.4, 0.8).judge(events).completed == 3


def test_reaches_a_region_of_a_moving_parent():
    cart = body("cart_1", Shape("box", (0.5, 0.5, 0.4)), category="cart")
    world = World().add(cart, x=line(4.0, 0.5), yaw_deg=90.0).add(ball("ball_1"), x=line(0.0, 2.5))
    world.region(Region("cart_1/loading area", "cart_1", (0.0, 1.0, 0.0), (0.3, 0.5, 0.5), "area"))
    found = world.event(type="reaches", object="ball", target="loading area")
    # The region spans x = 2.5 .. 3.5 ahead of the cart and both move: the gap closes at 2 m/s.
    assert found.time_s == pytest.approx((2.5 - 0.1 - 0.3) / 2.0, abs=2 * DT)
