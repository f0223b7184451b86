"""What the judge says of joints: open, closed, swung, attached, come apart, and plausible."""

import math

import numpy as np
import pytest

from esg.engines.scene import Shape
from esg.metrics.plausibility import Told, assess

from .worlds import World, ball, body

LEAF = Shape("box", (0.4, 0.02, 1.0))
DRAWER = Shape("box", (0.2, 0.2, 0.1))


def line(value, slope, start=0.0, stop=99.0):
    return lambda t: value + slope * (np.clip(t, start, stop) - start)


def door(degrees, start_deg: float = 0.0) -> World:
    """A leaf that turns about the post at its edge by a course of angles."""
    world = World(3.0)
    turn = lambda t: np.radians(degrees(t))  # noqa: E731
    world.add(body("post_1", static=True), z=1.0)
    world.add(
        body("door_1", LEAF), x=lambda t: 0.4 * np.cos(turn(t)), y=lambda t: 0.4 * np.sin(turn(t)),
        z=1.0, yaw_deg=degrees,
    )  # fmt: skip
    where = {"at": (0.0, 0.0, 1.0), "axis": (0.0, 0.0, 1.0)}
    return world.join("hinge", "door_1", "post_1", position=math.radians(start_deg), **where)


@pytest.mark.parametrize(
    ("course", "start_deg", "opens", "closes"),
    [
        (line(0, 40), 0, True, False),
        (line(0, -40), 0, True, False),
        (line(0, 20, 0, 1), 0, False, False),
        (line(60, -60, 0, 1), 60, False, True),
        (line(60, -40, 0, 1), 60, False, False),
        (line(60, 40, 0, 1), 60, True, False),
        (line(20, 20, 0, 1), 20, True, False),
    ],
)
def test_a_hinged_door_opens_and_closes_from_its_closed_place(course, start_deg, opens, closes):
    world = door(course, start_deg)
    assert world.event(type="opens", object="door", degrees=30).completed is opens
    assert world.event(type="closes", object="door", degrees=30).completed is closes


def test_a_door_off_its_hinges_opens_no_more():
    world = door(line(0, 40))
    path = world.paths[1]
    path[world.time > 0.3] += (0.5, 0.0, 0.0)
    found = world.event(type="opens", object="door", degrees=30)
    assert not found.completed
    assert found.reason == "door_1 opens to 12 degrees, 30 asked"


@pytest.mark.parametrize(("slid", "opens"), [(0.2, True), (0.1, False)])
def test_a_drawer_opens_by_a_third_of_its_way(slid, opens):
    world = World(2.0).add(body("chest_1", static=True))
    world.add(body("drawer_1", DRAWER), x=line(0.0, slid, 0.0, 1.0))
    world.join("slider", "drawer_1", "chest_1", axis=(1.0, 0.0, 0.0), lower=0.0, upper=0.45)
    assert world.event(type="opens", object="drawer").completed is opens
    # Who names the chest means what opens in it.
    assert world.event(type="opens", object="chest").completed is opens


def pendulum(x=lambda t: np.sin(0.5 * np.cos(4 * t))) -> World:
    world = World(3.0).add(body("beam_1", static=True), z=3.0)
    world.add(ball("bob_1"), x=x, z=lambda t: 3.0 - np.sqrt(1.0 - x(t) ** 2))
    return world


def test_what_hangs_on_a_rope_swings_and_hangs():
    world = pendulum().join("rope", "bob_1", "beam_1", parent_at=(0.0, 0.0, 3.0), upper=1.0)
    assert world.event(type="swings", object="bob", times=2).completed
    assert world.states(says="hangs_from", object="bob", target="beam").kept
    assert world.states(says="attached_to", object="beam", target="bob").kept
    assert not world.states(says="hangs_from", object="beam", target="bob").kept
    told = world.states(says="never_touches", a="bob", b="beam")
    assert told.kept


def test_what_bobs_on_a_spring_is_lowest_where_it_turns_round():
    world = World(3.0).add(body("beam_1", static=True), z=3.0)
    world.add(ball("bob_1"), z=lambda t: 2.0 - 0.15 * np.sin(8 * t))
    world.join("spring", "bob_1", "beam_1", parent_at=(0.0, 0.0, 3.0), upper=0.9, stiffness=64.0)
    assert world.event(type="swings", object="bob", times=3).completed
    still = World(3.0).add(body("beam_1", static=True), z=3.0).add(ball("bob_1"), z=2.0)
    still.join("spring", "bob_1", "beam_1", parent_at=(0.0, 0.0, 3.0), upper=0.9, stiffness=64.0)
    assert not still.event(type="swings", object="bob").completed


def test_nothing_hangs_without_a_joint():
    told = pendulum().states(says="hangs_from", object="bob", target="beam")
    assert not told.kept


def test_a_chain_of_joints_holds_its_ends_together_and_fixed_things_pass_nothing_on():
    world = World(1.0).add(body("beam_1", static=True), z=3.0)
    for k in range(3):
        world.add(ball(f"link_{k + 1}"), x=0.3 * k, z=2.5)
        world.join("ball", f"link_{k + 1}", f"link_{k}" if k else "beam_1")
    assert world.states(says="attached_to", object="link 3", target="beam").kept
    other = World(1.0).add(body("beam_1", static=True), z=3.0)
    other.add(ball("lamp_1"), x=1.0, z=2.5).add(ball("bell_1"), x=-1.0, z=2.5)
    other.join("ball", "lamp_1", "beam_1").join("ball", "bell_1", "beam_1")
    assert other.states(says="attached_to", object="lamp", target="beam").kept
    assert not other.states(says="attached_to", object="lamp", target="bell").kept


def test_a_torn_rope_separates_when_it_is_longer_than_it_can_be():
    world = pendulum(x=lambda t: 0.2 * t)
    world.join("rope", "bob_1", "beam_1", parent_at=(0.0, 0.0, 3.0), upper=1.0)
    assert world.event(type="separates", a="bob", b="beam").reason == "stay together"
    world.paths[1][world.time > 1.0] += (2.0, 0.0, 0.0)
    found = world.event(type="separates", a="bob", b="beam")
    assert found.time_s == pytest.approx(1.0, abs=0.01)


def test_joined_bodies_may_overlap_unless_they_collide():
    world = World(1.0).add(body("beam_1", static=True), z=3.0).add(body("arm_1"), z=3.1)
    assert world.judge(objects=["arm"]).layout.overlaps
    world.join("hinge", "arm_1", "beam_1", collide=True)
    assert world.judge(objects=["arm"]).layout.overlaps
    world.joints.clear()
    world.join("hinge", "arm_1", "beam_1")
    assert not world.judge(objects=["arm"]).layout.overlaps


def checks(world: World) -> dict[str, bool]:
    found = assess(world.scene, world.program, world.rollout(), Told(movers=frozenset({"bob_1"})))
    return {c.name: c.ok for c in found.checks}


def test_a_rope_explains_why_something_is_up_and_turns_round():
    still = pendulum(x=lambda t: 0.5 + 0.0 * t)
    assert not checks(still)["hovering"]
    held = still.join("rope", "bob_1", "beam_1", parent_at=(0.0, 0.0, 3.0), upper=1.0)
    assert checks(held)["hovering"]


def test_energy_of_a_spring_is_not_gained_from_nothing():
    g, k, m = 9.81, 100.0, 1.0
    world = World(3.0).add(body("beam_1", static=True), z=4.0)
    middle = 4.0 - 1.0 - m * g / k
    world.add(ball("bob_1"), z=lambda t: middle - 0.3 * np.cos(math.sqrt(k / m) * t))
    assert not checks(world)["energy"]
    world.join(
        "spring", "bob_1", "beam_1", parent_at=(0.0, 0.0, 4.0), upper=1.0, stiffness=k
    )  # fmt: skip
    assert checks(world)["energy"]


@pytest.mark.parametrize(
    ("height", "joined", "kept"), [(1.3, True, True), (1.3, False, False), (-0.7, True, False)]
)
def test_who_is_fixed_to_a_bike_from_above_is_carried_by_it(height, joined, kept):
    """A pillion rider sits over no surface of it; what is fixed to it from below hangs there."""
    world = World(2.0).add(body("bike_1", Shape("box", (0.8, 0.2, 0.4))), x=line(0.0, 2.0), z=2.0)
    rider = body("rider_1", Shape("box", (0.15, 0.2, 0.4)))
    world.add(rider, x=line(-0.9, 2.0), z=2.0 + height)
    if joined:
        world.join("fixed", "rider_1", "bike_1")
    assert world.states(says="supported_by", object="rider", target="bike").kept is kept
