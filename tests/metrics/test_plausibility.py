"""Every check of plausibility, kept and broken, on replays with known answers."""

from __future__ import annotations

from collections.abc import Callable
import csv
from dataclasses import replace
import math
from typing import get_args

import numpy as np
import pytest

from esg.engines.program import (
    AdjustProperties,
    DriveJoint,
    GuideAlong,
    HoldVelocity,
    SetVelocity,
)
from esg.engines.scene import Shape
from esg.lexicon.kinds import kinds
from esg.metrics.plausibility import CHECKS, Check, Told, assess
from esg.metrics.plausibility.limits import LIMITS, MOTION, Moves, limit, motion_of
from tests.metrics.worlds import DT, World, ball, body, line

G = 9.81
Curve = Callable[[np.ndarray], np.ndarray]


def checked(world: World, told: Told | None = None) -> dict[str, Check]:
    """The checks of a world that is under way at its first frame."""
    rollout = world.rollout()
    for series in (rollout.linear_velocity, rollout.angular_velocity):
        series[:, 0] = series[:, 1]
    found = assess(world.scene, world.program, rollout, told or Told())
    return {check.name: check for check in found.checks}


def changing(speed: float, rate: float, begin: float = 0.5, end: float = math.inf) -> Curve:
    """A way with constant speed that changes at a rate [m/s^2] from a time on, never below zero."""

    def way(t: np.ndarray) -> np.ndarray:
        rates = np.where((t >= begin) & (t < end), rate, 0.0)
        v = np.maximum(speed + np.cumsum(rates) * DT, 0.0)
        return np.cumsum(v) * DT

    return way


def car(name: str = "car_1", **more: object):
    half = (2.0, 0.9, 0.7)
    return body(name, Shape("box", half), wheeled=True, mass=1400.0, **more)


DRIVE = HoldVelocity("car_1", 0.0, math.inf, 8.0, 0.0)


def test_every_check_is_made_and_says_what_it_found() -> None:
    found = checked(World().add(car(), x=line(0.0, 8.0)).run(DRIVE))
    assert list(found) == list(CHECKS)
    assert all(check.ok for check in found.values())
    assert found["speed"].measured == pytest.approx(8.0)
    assert found["speed"].limit == motion_of("car").speed_mps
    assert found["speed"].body == "car_1"


@pytest.mark.parametrize(("rate", "ok"), [(4.5, True), (6.0, False)])
def test_a_car_gains_speed_no_faster_than_cars_can(rate: float, ok: bool) -> None:
    found = checked(World().add(car(), x=changing(2.0, rate)).run(DRIVE))["acceleration"]
    assert found.ok is ok
    assert found.measured == pytest.approx(rate, rel=0.01)


def test_a_car_that_is_under_way_within_a_step_is_accelerated_by_nothing() -> None:
    world = World().add(car(), x=line(0.0, 8.0, 0.5)).run(replace(DRIVE, start=0.5))
    found = checked(world)["acceleration"]
    assert not found.ok
    assert found.measured == pytest.approx(8.0 / limit("window"), rel=0.01)


def test_what_is_hit_or_thrown_may_gain_speed_at_once() -> None:
    thrown = World().add(ball("ball_1"), x=line(0.0, 8.0, 0.5), rolling=1.0)
    assert not checked(thrown)["acceleration"].ok
    assert checked(thrown.run(SetVelocity("ball_1", 0.5, (8.0, 0.0, 0.0))))["acceleration"].ok
    hit = World().add(car(), x=line(0.0, 8.0, 0.5)).add(car("car_2"), x=-4.0, y=0.5)
    assert checked(hit.touch(0.5, "car_1", "car_2"))["acceleration"].ok


@pytest.mark.parametrize(("falls_at", "ok"), [(4.0, True), (0.5, False)])
def test_what_lands_gains_what_friction_gives_it(falls_at: float, ok: bool) -> None:
    """A drone that has been let go tumbles along at 2 m/s after its fall: mu m g and the blow."""
    drone = body("drone_1", label="drone")
    world = World().add(
        drone,
        x=lambda t: 2.0 * np.maximum(t - 1.0, 0.0),
        z=lambda t: 0.1 + falls_at * np.maximum(1.0 - t, 0.0),
    )
    assert checked(world)["acceleration"].ok is ok


@pytest.mark.parametrize(("rate", "ok"), [(0.7, True), (0.9, False)])
def test_a_turn_needs_grip(rate: float, ok: bool) -> None:
    """Round a circle at 8 m/s: 0.9 rad/s take 7.2 m/s^2, under 0.8 g; 1.2 take 9.6."""
    omega = rate * 8.0 / 6.0
    circle = World().add(
        car(),
        x=lambda t: 8.0 / omega * np.sin(omega * t),
        y=lambda t: 8.0 / omega * (1.0 - np.cos(omega * t)),
        yaw_deg=lambda t: np.degrees(omega * t),
    )
    found = checked(circle.run(replace(DRIVE, turn_rate=omega)))["acceleration"]
    assert found.ok is ok
    assert (found.note == "in a turn") is True


@pytest.mark.parametrize(
    ("surface", "rate", "ok"),
    [("dry", 7.8, True), ("dry", 9.0, False), ("wet", 2.8, True), ("wet", 4.0, False),
     ("ice", 0.9, True), ("ice", 1.5, False)],
)  # fmt: skip
def test_braking_stays_under_friction(surface: str, rate: float, ok: bool) -> None:
    world = World().add(car(), x=changing(10.0, -rate))
    world.run(AdjustProperties("car_1", 0.5, linear_damping=4.0))
    found = checked(world, Told(surface=surface))["braking"]
    assert found.ok is ok
    assert found.measured == pytest.approx(rate, rel=0.02)


@pytest.mark.parametrize(("lost_at_once", "ok"), [(0.008, True), (0.03, False)])
def test_what_creeps_may_stop_at_once(lost_at_once: float, ok: bool) -> None:
    """A grip that takes the last centimetre a second is the engine's, not a brake's."""
    puck = body(
        "puck_1", Shape("box", (0.04, 0.04, 0.0125)), label="puck", friction=0.04, mass=0.17
    )

    def way(t: np.ndarray) -> np.ndarray:
        v = np.maximum(0.3 - 0.39 * t, 0.0)
        return np.cumsum(np.where(v > lost_at_once, v, 0.0)) * DT

    world = World().add(puck, x=way)
    floor = replace(world.scene, ground_friction=0.04)
    checks = assess(floor, world.program, world.rollout(), Told()).checks
    assert next(c for c in checks if c.name == "braking").ok is ok


@pytest.mark.parametrize(("said", "ok"), [("dry", True), ("wet", False)])
def test_a_smooth_floor_that_nobody_calls_wet_grips_as_its_pair_does(said: str, ok: bool) -> None:
    """0.45 on 0.5 are 0.475 for what slides on its soles."""
    dog = body("dog_1", Shape("box", (0.4, 0.1, 0.3)), label="dog", friction=0.5, mass=20.0)
    world = World().add(dog, x=changing(3.0, -4.6))
    floor = replace(world.scene, ground_friction=0.45)
    checks = assess(floor, world.program, world.rollout(), Told(surface=said)).checks
    assert next(c for c in checks if c.name == "braking").ok is ok


def test_icy_ground_grips_as_ice_whatever_the_prompt_says() -> None:
    world = World().add(car(), x=changing(10.0, -4.0))
    icy = replace(world.scene, ground_friction=0.05)
    rollout = world.rollout()
    checks = assess(icy, world.program, rollout, Told()).checks
    assert not next(c for c in checks if c.name == "braking").ok


@pytest.mark.parametrize(
    ("names", "moves", "speed"),
    [
        (("yellow tow truck", "steamroller"), "road", motion_of("truck").speed_mps),
        (("Ferrari", "sports_car"), "road", motion_of("sports car").speed_mps),
        (("zebra", ""), "legs", motion_of("horse").speed_mps),
        (("nurse", "person"), "legs", motion_of("person").speed_mps),
        (("pebble", "rock"), "thrown", motion_of("").speed_mps),
        (("toy truck", "toy_truck"), "road", 50.0),
    ],
)
def test_a_thing_is_what_the_prompt_calls_it(
    names: tuple[str, ...], moves: str, speed: float
) -> None:
    """An asset may stand in for another kind: the label comes first, then its category."""
    assert (motion_of(*names).moves, motion_of(*names).speed_mps) == (moves, speed)


def test_every_row_of_the_tables_has_a_source_and_a_known_way_to_move() -> None:
    with open(MOTION, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) > 50
    assert {r["moves"] for r in rows} <= set(get_args(Moves))
    assert all(len(r["source"]) > 8 for r in rows)
    known = {n.replace("_", " ") for k in kinds() for n in (k.name, *k.said_as)}
    assert not {n for r in rows for n in r["names"].split(";") if n} - known
    assert not {r["kinds"] for r in rows if r["kinds"]} - {k.kind for k in kinds()}
    with open(LIMITS, encoding="utf-8", newline="") as file:
        assert all(len(r["source"]) > 8 for r in csv.DictReader(file))


def shoved(rate: float) -> World:
    """A car that something has set sliding sideways at 4 m/s, and that slows down at a rate."""
    return World(6.0).add(car(), y=changing(4.0, -rate, 0.0))


@pytest.mark.parametrize(("rate", "ok"), [(0.8 * G, True), (0.8, False)])
def test_tyres_hold_against_a_shove(rate: float, ok: bool) -> None:
    """4 m/s slide 1.02 m at mu 0.8; ten metres are ice, or no tyres."""
    found = checked(shoved(rate))["side_slip"]
    assert found.ok is ok
    assert found.measured == pytest.approx(4.0**2 / 2.0 / rate, rel=0.05)
    assert found.limit == pytest.approx(1.02 + limit("side slip tolerance"), rel=0.05)


def test_tyres_in_the_air_do_not_hold_either() -> None:
    """Up on its rear bumper after a crash, its wheels carry nothing: it falls at g."""
    flies = World(0.8).add(car(), y=line(0.0, 4.0), z=lambda t: 0.7 + 4.0 * t - 0.5 * G * t**2)
    flies.bodies[0] = replace(flies.bodies[0], shapes=(Shape("box", (2.0, 0.9, 0.7)),
        Shape("box", (0.1, 0.1, 2.5))))  # fmt: skip
    assert checked(flies)["side_slip"].ok


@pytest.mark.parametrize(("slides", "ok"), [(0.0, True), (2.0, False)])
def test_tyres_stay_where_a_bicycle_falls_over(slides: float, ok: bool) -> None:
    """Its centre of mass goes aside by 25 cm before it leans by 30 degrees."""
    bike = body("bicycle_1", Shape("box", (0.9, 0.05, 0.5)), wheeled=True, mass=14.0)
    falls = World(0.5).add(
        bike,
        x=line(0.0, 3.0),
        y=lambda t: 0.5 * np.sin(t) + slides * t,
        z=lambda t: 0.5 * np.cos(t),
        roll_deg=lambda t: -np.degrees(t),
    )
    assert checked(falls)["side_slip"].ok is ok


def test_casters_do_not_hold() -> None:
    world = World(6.0).add(car("shopping_cart_1"), y=changing(4.0, -0.8, 0.0))
    assert checked(world)["side_slip"].measured is None


@pytest.mark.parametrize(("rolling", "ok"), [(1.0, True), (0.2, False)])
def test_a_ball_rolls_on_its_support(rolling: float, ok: bool) -> None:
    world = World().add(ball("ball_1"), x=line(0.0, 3.0), rolling=rolling)
    found = checked(world)["rolling"]
    assert found.ok is ok
    if not ok:
        slip, mu = 3.0 * (1.0 - rolling), 0.6
        expected = 2.0 * slip / (7.0 * mu * G) + limit("rolling tolerance")
        assert found.limit == pytest.approx(expected, rel=0.01)
        assert checked(world, Told(slides=frozenset({"ball_1"})))["rolling"].ok


@pytest.mark.parametrize(("factor", "ok"), [(1.0, True), (1.5, False)])
def test_a_hit_makes_no_energy(factor: float, ok: bool) -> None:
    """Equal balls hand over the speed of 2 m/s; half more of it is 2.5 J from nowhere."""
    world = World().add(ball("ball_1"), x=line(0.0, 2.0, 0.0, 0.4), rolling=1.0)
    world.add(ball("ball_2"), x=line(1.0, 2.0 * factor, 0.4), rolling=1.0)
    world.touch(0.4, "ball_1", "ball_2", 2.0)
    found = checked(world)["energy"]
    assert found.ok is ok
    if not ok:
        assert found.measured == pytest.approx(0.5 * (3.0**2 - 2.0**2) * 101.0, rel=0.02)


@pytest.mark.parametrize(("lasts", "ok"), [(0.05, True), (0.3, False)])
def test_a_contact_may_store_energy_for_a_moment(lasts: float, ok: bool) -> None:
    """Two balls come together, stand, and part at the speed at which they came."""

    def way(side: float) -> Curve:
        apart = lambda t: np.maximum(0.4 - t, 0.0) + np.maximum(t - 0.4 - lasts, 0.0)  # noqa: E731
        return lambda t: side * (0.1 + 2.0 * apart(t))

    world = World().add(ball("ball_1"), x=way(-1.0)).add(ball("ball_2"), x=way(1.0))
    for t in np.arange(0.4, 0.4 + lasts + 0.01, 0.01):
        world.touch(float(t), "ball_1", "ball_2", 1.0)
    assert checked(world)["energy"].ok is ok


def test_energy_from_the_program_is_no_gain_and_from_nowhere_is() -> None:
    rises = World().add(body("box_1"), z=line(0.1, 1.0, 0.5))
    assert not checked(rises)["energy"].ok
    path = GuideAlong(
        "box_1", 0.4, (0.0, 2.6), ((0.0, 0.0, 0.1), (0.0, 0.0, 2.6)), ((0.0, 0.0, 1.0),) * 2
    )
    assert checked(rises.run(path))["energy"].ok


def test_energy_from_a_motor_of_the_program_is_no_gain_until_it_lets_go() -> None:
    def lifted(*commands: DriveJoint) -> bool:
        world = World().add(body("lid_1"), z=line(0.1, 0.5, 0.5))
        world.join("slider", "lid_1", axis=(0.0, 0.0, 1.0), lower=0.0, upper=2.0)
        return checked(world.run(*commands))["energy"].ok

    on = DriveJoint("joint_1", 0.4, 0.5, 1.25)
    assert not lifted()
    assert lifted(on)
    assert not lifted(on, DriveJoint("joint_1", 1.0))


def dropped(begin: float, height: float, half: float) -> Curve:
    return lambda t: np.maximum(height - 0.5 * G * np.maximum(t - begin, 0.0) ** 2, half)


@pytest.mark.parametrize(("begin", "ok"), [(0.0, True), (1.0, False)])
def test_what_is_in_the_air_falls(begin: float, ok: bool) -> None:
    found = checked(World().add(body("box_1"), z=dropped(begin, 2.0, 0.1)))["hovering"]
    assert found.ok is ok
    if not ok:
        assert found.measured == pytest.approx(begin, abs=3 * DT)


def test_what_flies_is_held_or_stands_on_something_does_not_hover() -> None:
    level = HoldVelocity("drone_1", 0.0, math.inf, 1.0, 0.0, climb=0.0)
    flies = World().add(body("drone_1"), x=line(0.0, 1.0), z=2.0).run(level)
    assert checked(flies)["hovering"].ok
    shelf = body("shelf_1", Shape("box", (0.5, 0.5, 0.5)), static=True)
    assert checked(World().add(shelf).add(body("box_1"), z=1.1))["hovering"].ok


@pytest.mark.parametrize(("depth", "ok"), [(0.015, True), (0.03, False)])
def test_bodies_are_not_in_each_other_for_long(depth: float, ok: bool) -> None:
    def pressed(lasts: float) -> Check:
        world = World().add(body("box_1")).add(body("box_2"), x=0.21)
        for t in np.arange(0.5, 0.5 + lasts, DT):
            world.touch(float(t), "box_1", "box_2", 1.0, depth)
        return checked(world)["penetration"]

    assert pressed(0.1).ok
    assert pressed(0.4).ok is ok
    sunk = World().add(body("box_1"), z=0.1 - depth)
    assert checked(sunk)["penetration"].ok is ok
    together = World().add(body("box_1")).add(body("box_2"), x=0.2 - depth)
    assert checked(together)["penetration"].ok is ok


@pytest.mark.parametrize(("drift", "ok"), [(0.01, True), (0.05, False)])
def test_nothing_moves_before_it_is_touched(drift: float, ok: bool) -> None:
    settles = World().add(body("vase_1"), x=line(0.0, drift, 0.0, 1.0))
    found = checked(settles)["motion_before"]
    assert found.ok is ok
    assert found.measured == pytest.approx(drift, abs=1e-3)
    assert checked(settles, Told(movers=frozenset({"vase_1"})))["motion_before"].ok
    settles.add(ball("ball_1"), x=line(-3.0, 3.0), y=0.5).touch(0.0, "ball_1", "vase_1")
    settles.run(SetVelocity("ball_1", 0.0, (3.0, 0.0, 0.0)))
    assert checked(settles)["motion_before"].ok


@pytest.mark.parametrize(("hit", "ok"), [(True, True), (False, False)])
def test_what_is_hit_passes_it_on_before_it_has_gone_a_centimetre(hit: bool, ok: bool) -> None:
    """Of two dominoes in touch the second one moves off as soon as a marble hits the first."""
    row = World().add(ball("marble_1"), x=line(-3.0, 3.0), y=5.0)
    row.add(body("domino_1"), x=line(0.0, 0.5, 1.0, 1.01)).touch(0.2, "domino_1", "domino_2")
    row.add(body("domino_2"), x=line(0.2, 1.0, 1.0, 1.5)).touch(1.004, "domino_1", "domino_2")
    row.run(SetVelocity("marble_1", 0.0, (3.0, 0.0, 0.0)))
    if hit:
        row.touch(1.0, "marble_1", "domino_1")
    assert checked(row)["motion_before"].ok is ok


def test_a_ball_of_a_cradle_passes_a_blow_on_and_stops() -> None:
    """The middle ball moves for one frame; the last one moves off as it stops."""
    row = World().add(ball("ball_1"), x=line(-3.0, 3.0), y=5.0)
    row.add(ball("ball_2"), x=line(0.2, 2.0, 1.0, 1.0 + DT)).touch(1.0, "ball_1", "ball_2")
    row.add(ball("ball_3"), x=line(0.4, 2.0, 1.0 + 2.0 * DT, 2.0))
    row.run(SetVelocity("ball_1", 0.0, (3.0, 0.0, 0.0)))
    assert not checked(row)["motion_before"].ok
    row.touch(1.0 + 2.0 * DT, "ball_2", "ball_3")
    assert checked(row)["motion_before"].ok


def paved() -> World:
    ground = body("ground_1", static=True, shapes=(), half_extents=(20.0, 20.0, 0.01))
    road = replace(ground, name="road_1", category="road", half_extents=(20.0, 4.0, 0.01))
    return World().add(replace(ground, category="ground")).add(road)


@pytest.mark.parametrize(("across", "ok"), [(1.2, True), (2.0, False)])
def test_a_car_stays_on_its_road(across: float, ok: bool) -> None:
    world = paved().add(car(), x=line(-10.0, 3.0), y=line(0.0, across)).run(DRIVE)
    found = checked(world)["leaving"]
    assert found.ok is ok
    if not ok:
        assert found.measured == pytest.approx(3.0 * across - 4.0, abs=0.02)
        assert checked(world, Told(off_road=True))["leaving"].ok
        world.add(body("tree_1", static=True), x=-1.0, y=6.0).touch(3.0, "car_1", "tree_1")
        assert checked(world)["leaving"].ok


@pytest.mark.parametrize(("speed", "ok"), [(6.0, True), (8.0, False)])
def test_nothing_goes_beyond_the_drawn_ground(speed: float, ok: bool) -> None:
    world = paved().add(ball("ball_1"), x=line(0.0, speed), rolling=1.0)
    assert checked(world)["leaving"].ok is ok
    bare = World().add(ball("ball_1"), x=line(limit("drawn ground") - 20.0, speed), rolling=1.0)
    assert checked(bare)["leaving"].ok is ok


@pytest.mark.parametrize(("speed", "ok"), [(12.0, True), (14.0, False)])
def test_a_person_runs_no_faster_than_people(speed: float, ok: bool) -> None:
    world = World().add(body("person_1"), x=line(0.0, speed))
    found = checked(world)["speed"]
    assert found.ok is ok
    said = checked(world, Told(speeds_mps={"person_1": 14.0}))["speed"]
    assert said.ok
    assert (said.note == "prescribed by the prompt") is True


def test_a_world_that_diverged_is_not_plausible() -> None:
    world = World().add(ball("ball_1"))
    found = assess(world.scene, world.program, world.rollout(valid=False), Told())
    assert not found.plausible


@pytest.mark.parametrize(("held", "ok"), [(True, True), (False, False)])
@pytest.mark.parametrize(("struck", "passes"), [(True, True), (False, False)])
def test_what_a_joint_holds_is_moved_by_it(
    held: bool, ok: bool, struck: bool, passes: bool
) -> None:
    """A board that a crate strikes turns about its middle, and sends up what is fixed to it."""
    world = World().add(ball("crate_1"), x=line(-3.0, 3.0), y=5.0)
    world.add(body("board_1"), pitch_deg=line(0.0, 90.0, 1.0, 1.2))
    world.add(body("duck_1"), x=0.5, z=line(0.1, 2.0, 1.0, 1.5))
    world.run(SetVelocity("crate_1", 0.0, (3.0, 0.0, 0.0)))
    if held:
        world.join("fixed", "duck_1", "board_1")
    if struck:
        world.touch(1.0, "crate_1", "board_1")
    assert checked(world)["motion_before"].ok is (ok and passes)


@pytest.mark.parametrize(
    ("label", "speed", "yaw_deg", "ok"),
    [("van", 19.0, 180.0, False), ("van", 19.0, 0.0, True), ("van", 3.0, 180.0, True),
     ("bicycle", 4.0, 180.0, False), ("train", 19.0, 180.0, True)],
)  # fmt: skip
def test_reversing_has_a_limit_of_its_own(
    label: str, speed: float, yaw_deg: float, ok: bool
) -> None:
    """By where the front points: nothing is said of what the program intends."""
    world = World().add(replace(car(), label=label), x=lambda t: speed * t, yaw_deg=yaw_deg)
    assert checked(world)["speed"].ok is ok


def test_what_rolls_down_backwards_may_be_as_fast_as_its_fall_makes_it() -> None:
    """20 m down give 19.8 m/s, which no reverse gear does."""
    slope = World().add(car(), x=lambda t: 5.0 * t**2, z=lambda t: 20.6 - 5.0 * t**2, yaw_deg=180.0)
    assert checked(slope)["speed"].ok


def test_what_stands_on_what_is_let_go_may_go_with_it() -> None:
    """A tray falls away from the cup on it without a touch."""
    falling = World().add(body("tray_1"), z=line(1.0, 0.5, 0.0, 0.3))
    falling.add(body("cup_1"), z=line(1.2, 0.7, 0.0, 0.3))
    tray = frozenset({"tray_1"})
    assert not checked(falling, Told(movers=tray))["motion_before"].ok
    told = Told(movers=tray, stands_on={"cup_1": "tray_1"})
    assert checked(falling, told)["motion_before"].ok
