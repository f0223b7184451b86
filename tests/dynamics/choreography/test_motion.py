"""Caroms, pile-ups, timed chains, slopes and stops, before anything is searched."""

from __future__ import annotations

import itertools
import math

import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.story.kinematics import (
    back_spin,
    rolling_travel,
    sliding_travel,
    slowing,
)
from esg.dynamics.story.paces import slows_by
from esg.engines.program import HoldVelocity, SetVelocity
from esg.graph.models import AssetConfiguration, EsgDocument
from esg.layout import solve
from esg.layout.problem.hints import Placement
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast


def config(doc: EsgDocument, name: str) -> AssetConfiguration:
    return doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]


def places(doc: EsgDocument) -> dict[str, Placement]:
    return {p.node: p for c in start_hints(doc).constellations for p in c.placements}


def first_program(doc: EsgDocument) -> list[HoldVelocity | SetVelocity]:
    laid = solve(doc, hints=start_hints(doc))
    plan = make_plan(laid, build_scene(laid))
    program = plan.compile(plan.initial())
    return [p for p in program.primitives if isinstance(p, HoldVelocity | SetVelocity)]


def test_a_ball_that_hits_two_meets_the_first_one_off_its_middle() -> None:
    """The second ball lies off the line of the shot, on the side away from where the first goes."""
    doc = cast("A red ball hits a green ball and then a yellow ball.")
    spots = places(doc)
    red, green, yellow = (spots[f"{c}_ball_1"] for c in ("red", "green", "yellow"))
    assert red.yaw_deg == pytest.approx(0.0)
    off = green.y_cm - red.y_cm
    assert 8.0 < abs(off) < 22.0
    assert (yellow.y_cm - red.y_cm) * off < 0.0
    way = math.degrees(math.atan2(yellow.y_cm - red.y_cm, yellow.x_cm - green.x_cm))
    assert 5.0 < abs(way) < 90.0
    # Straight at the green ball is not where the red one aims.
    aim = choreograph(doc).nominal["red_ball_1/aim"]
    assert math.radians(1.0) < abs(aim) < math.radians(14.0)


def test_who_goes_on_in_a_pile_up_is_hit_from_behind() -> None:
    """Head-on the first car would stand where the second one has to go."""
    doc = cast(
        "Cars crash into each other: the red car hits the blue car, the blue car hits the "
        "green car, and the green car hits the yellow car."
    )
    spots = places(doc)
    red, blue = spots["red_car_1"], spots["blue_car_1"]
    assert red.yaw_deg == pytest.approx(blue.yaw_deg)
    order = [spots[f"{c}_car_1"].x_cm for c in ("red", "blue", "green", "yellow")]
    assert order == sorted(order)
    assert min(b - a for a, b in itertools.pairwise(order)) > 180.0


def test_what_slides_brakes_and_what_is_struck_spins_backwards() -> None:
    """Closed forms: half a v t to rest; a struck ball with back spin s rolls at (5 v - 2 s) / 7."""
    assert sliding_travel(4.0, 2.0, 1.0) == pytest.approx(3.0)
    assert sliding_travel(4.0, 2.0, 9.0) == pytest.approx(4.0)
    spin = back_spin(1.0, 2.0, 5.0, 10.0, 2.8)
    assert spin == pytest.approx(2.5 * 5.0 / (3.5 * 1.5) / 2.0)
    assert back_spin(1.0, 2.0, 5.0, 0.1, 2.8) == pytest.approx(0.7)
    friction = 0.7
    lasts = 2.0 / 7.0 * (2.8 + spin) / (friction * GRAVITY_MPS2)
    way, left = rolling_travel(2.8, friction, 1.0, spin)
    assert left == pytest.approx((5.0 * 2.8 - 2.0 * spin) / 7.0)
    assert way == pytest.approx(0.5 * (2.8 + left) * lasts + left * (1.0 - lasts))


@pytest.mark.parametrize(
    ("damping", "drag", "duration"),
    [(0.3, 1.2, 3.0), (2.0, 0.0, 1.0), (0.0, 2.0, 1.0), (1.0, 4.0, 9.0)],
)
def test_a_brake_slows_by_damping_and_by_friction(
    damping: float, drag: float, duration: float
) -> None:
    """The closed form is the integral of v' = -c v - a until rest."""
    step, way, speed = 1e-4, 0.0, 8.0
    for _ in range(round(duration / step)):
        way += step * speed
        speed = max(0.0, speed - step * (damping * speed + drag))
    assert slowing(8.0, damping, drag, duration) == pytest.approx((way, speed), abs=2e-3)


def test_who_brakes_into_something_on_foot_slows_down_step_by_step() -> None:
    """Soles would stop a runner within a second; the hit is asked for after two."""
    doc = cast("A runner at 6 m/s slows down but bumps into a bench after 2 seconds.")
    holds = [p for p in first_program(doc) if isinstance(p, HoldVelocity)]
    slower = next(p for p in holds if p.acceleration < 0.0)
    assert slower.speed == pytest.approx(6.0)
    at_the_hit = slower.speed + 2.0 * slower.acceleration
    assert 1.0 < at_the_hit < 3.0


def test_what_is_shaken_off_a_table_waits_for_the_hit_of_the_table() -> None:
    """The lamp does not fall before the dog has run into what it stands on."""
    doc = cast("A dog runs into the coffee table and the lamp falls off.")
    hit = choreograph(doc).nominal["dog_1_coffee_table_1_collision/event_time"]
    falls = next(p for p in first_program(doc) if isinstance(p, SetVelocity))
    assert falls.body == "lamp_1"
    assert falls.time == pytest.approx(hit + 0.15)
    alone = next(p for p in first_program(cast("A lamp falls off a coffee table.")))
    assert isinstance(alone, SetVelocity)
    assert alone.time == 0.0


def test_what_slides_is_braked_before_it_rests() -> None:
    """Friction stops a sled of a stated speed; its brake sets in while it slides."""
    doc = cast("A sled slides at 7 m/s, brakes and hits a snowman.")
    nominal = choreograph(doc).nominal
    friction = 0.5 * (config(doc, "sled_1").friction + config(doc, "ground_1").friction)
    assert nominal["sled_1_brake/time"] < 0.5 * 7.0 / (friction * GRAVITY_MPS2)


def test_a_timed_chain_reckons_with_friction() -> None:
    """A barrel that is to arrive a second later slides less far than it would without friction."""
    doc = cast(
        "A truck hits a barrel after 3 seconds, and the barrel hits a car 1 second after that."
    )
    nominal = choreograph(doc).nominal
    spots = places(doc)
    speed = nominal["truck_1_drive/speed"]
    barrel, truck = config(doc, "barrel_1"), config(doc, "truck_1")
    gain = 1.0 + 0.5 * (barrel.restitution + truck.restitution)
    struck = gain * truck.mass_kg / (truck.mass_kg + barrel.mass_kg) * speed
    sizes = config(doc, "car_1").dimensions_cm[1] + barrel.dimensions_cm[0]
    gap = 0.01 * (spots["car_1"].x_cm - spots["barrel_1"].x_cm - 0.5 * sizes)
    assert 0.5 * struck < gap < 0.85 * struck


def test_a_low_hit_topples_what_does_not_slip() -> None:
    """The bin a child runs into has rubber feet; one that is only hit keeps its own."""
    toppled = config(cast("A child runs into a trash can and knocks it over."), "trash_can_1")
    hit = config(cast("A child runs into a trash can."), "trash_can_1")
    assert toppled.friction > hit.friction


def test_what_is_pushed_on_is_light_and_smooth_enough() -> None:
    """A football at 8 m/s moves an empty crate to the wall; a stated mass is never touched."""
    story = "A boy kicks a football at 8 m/s into a crate{}, and the crate slides into a wall."
    free, stated = cast(story.format("")), cast(story.format(" weighing 15 kg"))
    assert config(free, "crate_1").mass_kg < 15.0 == config(stated, "crate_1").mass_kg
    assert config(free, "crate_1").friction <= 0.15


def test_a_prescribed_slide_gets_ice() -> None:
    """At 2.5 m/s a second of sliding needs a friction under 0.1; on concrete it lasts 0.4 s."""
    doc = cast(
        "A curling stone slides at 2.5 m/s and hits another curling stone 1.2 seconds later."
    )
    ground = next(n for n, v in doc.spatial_relation_graph.nodes.items() if v.is_structural)
    grip = 0.5 * (config(doc, "curling_stone_1").friction + config(doc, ground).friction)
    assert 1.2 * grip * GRAVITY_MPS2 < 0.5 * 2.5


def test_marbles_that_meet_in_time_are_large_enough_to_be_felt() -> None:
    """Two marbles of 5 g at 2 m/s exchange a tenth of the impulse that counts as a hit."""
    doc = cast("Two marbles roll toward each other and collide after 1.5 seconds.")
    marble = config(doc, "marble_1")
    assert 2.0 < marble.dimensions_cm[0] < 7.0
    assert (1.0 + marble.restitution) * 0.5 * marble.mass_kg * 4.0 > 0.1


def test_a_cart_has_room_on_its_ramp_and_tilts_with_the_slope() -> None:
    """A hold would keep it level; it is let go instead."""
    doc = cast("A mine cart rolls down a ramp and hits a wooden crate at the bottom.")
    ramp, cart = config(doc, "ramp_1"), config(doc, "mine_cart_1")
    top = max(ramp.support_surfaces, key=lambda s: s.center_cm[2])
    assert 2.0 * top.half_extents_cm[0] > 0.8 * cart.dimensions_cm[0]
    assert [type(p) for p in first_program(doc)] == [SetVelocity]


def test_what_runs_slows_down_in_the_time_it_is_given() -> None:
    """Friction alone would stop a horse in one second; it is asked for two."""
    doc = cast("A horse runs at 7 m/s, knocks over a fence post and stops 2 seconds later.")
    last = first_program(doc)[-1]
    assert isinstance(last, HoldVelocity) and last.acceleration < 0.0
    assert last.speed / -last.acceleration == pytest.approx(2.0, abs=0.05)


def test_what_is_pushed_arrives_with_most_of_its_speed() -> None:
    """A cart let go at 2 m/s starts close enough to be fast when it gets there."""
    doc = cast("A shopping cart is pushed at 2 m/s and hits a barrel.")
    cart, barrel = places(doc)["shopping_cart_1"], places(doc)["barrel_1"]
    drag = 0.5 * config(doc, "shopping_cart_1").friction * GRAVITY_MPS2
    half = 0.5 * (config(doc, "shopping_cart_1").dimensions_cm[0] + 60.0)
    way = 0.01 * (barrel.x_cm - cart.x_cm - half)
    assert math.sqrt(2.0**2 - 2.0 * drag * way) > 1.5


def test_the_way_of_a_stop_decides_how_hard_it_brakes() -> None:
    """v^2 / 2 s is shared between the brakes and what slows a car by itself."""
    doc = cast("A car drives at 10 m/s, brakes and stops after 20 m of braking.")
    told = choreograph(doc).nominal["car_1_brake/braking"]
    assert told + slows_by(doc, "car_1", 10.0) == pytest.approx(10.0**2 / 40.0, rel=1e-6)


def test_what_was_struck_is_met_on_the_line_it_was_sent_along() -> None:
    """The second ball comes from ahead, so that it finds the bottle wherever it lies."""
    doc = cast(
        "A bowling ball hits a bottle, and 1.5 seconds later a second ball hits the same bottle."
    )
    spots = places(doc)
    first, bottle, second = (spots[n] for n in ("bowling_ball_1", "bottle_1", "second_ball_1"))
    assert first.x_cm < bottle.x_cm < second.x_cm
    assert abs(second.y_cm - first.y_cm) < 10.0
    assert choreograph(doc).nominal["bowling_ball_1_roll/speed"] < 3.0


def test_a_stated_acceleration_decides_where_the_target_stands() -> None:
    """Four seconds at 3 m/s^2 cover 24 m, and a little more with a running start."""
    doc = cast("A motorcycle accelerates at 3 m/s2 for 4 seconds and then rams a fence.")
    spots = places(doc)
    way = 0.01 * (spots["fence_1"].x_cm - spots["motorcycle_1"].x_cm)
    assert 24.0 < way < 29.0


def test_what_accelerates_from_standstill_gets_there() -> None:
    """A start at no speed at all has a finite time of arrival."""
    doc = cast("A jeep accelerates from standstill and rams a barrier.")
    assert 0.5 < choreograph(doc).nominal["jeep_1_barrier_1_collision/event_time"] < 8.0


@pytest.mark.parametrize(
    "prompt",
    [
        "A car drives forward at 5 m/s. A ball is dropped onto the car.",
        "A car drives forward at 5 m/s. A ball is dropped onto the car from 6 m.",
    ],
)
def test_what_is_dropped_onto_what_drives_is_let_go_where_it_will_be(prompt: str) -> None:
    doc = cast(prompt)
    spots = places(doc)
    car, ball = spots["car_1"], spots["ball_1"]
    assert ball.z_cm is not None
    top = config(doc, "car_1").dimensions_cm[2]
    height = (ball.z_cm - top) / 100.0
    assert height == pytest.approx(1.0 if "6 m" not in prompt else 6.0 - top / 100.0)
    way = math.hypot(ball.x_cm - car.x_cm, ball.y_cm - car.y_cm)
    assert way == pytest.approx(500.0 * math.sqrt(2.0 * height / GRAVITY_MPS2), rel=0.01)


@pytest.mark.parametrize("met", ["wall", "cone"])
def test_what_is_dropped_onto_what_ran_into_something_falls_for_long_enough(met: str) -> None:
    doc = cast(f"A car hits a {met}, then a box is dropped onto the car.")
    top = config(doc, "car_1").dimensions_cm[2]
    falls = math.sqrt(2.0 * (places(doc)["box_1"].z_cm - top) / 100.0 / GRAVITY_MPS2)
    nominal = choreograph(doc).nominal
    assert nominal["box_1_car_1_collision/event_time"] == pytest.approx(falls)
    assert falls > nominal[f"car_1_{met}_1_collision/event_time"] + 0.3


def test_two_that_are_dropped_and_meet_are_planned_at_all() -> None:
    assert places(cast("Two balls are dropped and collide with each other."))


@pytest.mark.parametrize(
    "prompt",
    [
        "A truck is driving in the left lane at 15 m/s. A car in the right lane overtakes it, cuts "
        "in and brakes. The truck hits the car from behind. Then it is hit by a ball.",
        "Every second a ball drops into the bucket, three in all. A car crashes into it after that.",
    ],
)
def test_stories_that_go_on_after_their_usual_end_are_planned(prompt: str) -> None:
    assert places(cast(prompt))


@pytest.mark.parametrize(
    ("prompt", "least", "most"),
    [
        ("Three toy cars drive across a floor.", 20.0, 100.0),
        ("Four dogs run across a lawn.", 60.0, 300.0),
        ("Two elephants walk across a meadow.", 399.0, 401.0),
    ],
)
def test_small_things_that_go_together_are_near_each_other(
    prompt: str, least: float, most: float
) -> None:
    """As far apart as they are large, at most four metres."""
    doc = cast(prompt)
    movers = {e.actor for e in doc.timeline_system.sequence_graph.edges}
    starts = sorted(p.y_cm for p in places(doc).values() if p.node in movers)
    assert len(starts) > 1
    assert all(least <= b - a <= most for a, b in itertools.pairwise(starts))
