"""Kinematics, gaps, units at the border, and what the choreography promises."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dynamics import start_hints
from esg.dynamics.losses.gap import surface_gap
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.plan.tyres import with_tyres
from esg.dynamics.story.kinematics import (
    Ride,
    Track,
    ballistic_velocity,
    braking_distance,
    frame_mapping,
)
from esg.dynamics.story.paces import pace
from esg.dynamics.story.stagecraft import coasting_drag, prop
from esg.dynamics.story.story import read_story
from esg.engines import get_engine
from esg.engines.program import HoldVelocity, Primitive, Program, batch_programs
from esg.engines.scene import Body, Shape
from tests.dynamics import stories
from tests.dynamics.stage import lay_out


def test_ballistic_velocity_arrives() -> None:
    """p(t) = v t - g t^2 / 2 passes through the offset at the asked time."""
    offset, t = np.array([3.0, -1.0, -0.5]), 0.8
    v = ballistic_velocity(offset.copy(), t)
    assert np.allclose(v * t - np.array([0, 0, 0.5 * 9.81 * t * t]), offset)


def test_braking_distance_tends_to_v_over_c() -> None:
    """Linear damping stops after v/c; without damping the body just goes on."""
    assert braking_distance(10.0, 2.0, 50.0) == pytest.approx(5.0)
    assert braking_distance(10.0, 0.0, 2.0) == pytest.approx(20.0)


def test_arc_has_the_radius_of_its_speed_and_rate() -> None:
    """A quarter turn at v and w ends at (v/w, v/w)."""
    track = Track(speed=6.0)
    track.arc(math.pi / 2, 0.75, Ride.under_way(track.speed))
    assert (track.x, track.y) == pytest.approx((8.0, 8.0), rel=1e-3)
    assert track.heading == pytest.approx(math.pi / 2)


def test_what_sets_off_gains_speed_evenly() -> None:
    """3 m/s^2 up to 6 m/s: 2 s and 6 m, then 6 m/s."""
    ride = Ride(0.0, 3.0, 6.0)
    assert (ride.gaining, ride.way(1.0), ride.way(4.0)) == pytest.approx((2.0, 1.5, 18.0))
    assert (ride.left(1.0), ride.left(3.0)) == pytest.approx((3.0, 6.0))
    assert [ride.lasts(w) for w in (1.5, 6.0, 18.0)] == pytest.approx([1.0, 2.0, 4.0])
    assert (ride.until(3.0), ride.until(20.0)) == pytest.approx((1.5, 6.0))
    going = Ride.under_way(5.0)
    assert (going.way(2.0), going.lasts(10.0), going.until(4.0)) == pytest.approx((10.0, 2.0, 0.0))


def test_arc_from_rest_is_as_long_as_its_ride() -> None:
    """Turning while it gains speed it covers the ride's way along the arc."""
    track, ride = Track(), Ride(0.0, 2.0, 3.0)
    track.arc(math.pi / 2, 0.5, ride)
    lasts = math.pi
    assert (track.time, track.speed) == pytest.approx((lasts, 3.0))
    steps = [math.dist(a, b) for a, b in zip(track.points, track.points[1:], strict=False)]
    assert sum(steps) == pytest.approx(ride.way(lasts), rel=0.01)
    assert steps[0] < 0.5 * steps[-1]


def test_frame_mapping_takes_one_pose_to_another() -> None:
    """Point and heading arrive where they should."""
    frame = frame_mapping((3.0, 1.0), 0.3, (-2.0, 5.0), 1.7)
    assert frame.apply(3.0, 1.0) == pytest.approx((-2.0, 5.0))
    assert frame.angle == pytest.approx(1.4)


def _body(shape: Shape) -> Body:
    return Body("b", False, 1.0, ((1, 0, 0), (0, 1, 0), (0, 0, 1)), (shape,), (0, 0, 0))


def test_surface_gap_of_analytic_pairs() -> None:
    """Sphere to sphere, sphere to box and box to cylinder are exact."""
    sphere, box = Shape("sphere", (0.5, 0.5, 0.5)), Shape("box", (1.0, 0.5, 0.25))
    cylinder = Shape("cylinder", (0.3, 0.3, 0.5))
    q = np.array([0.0, 0.0, 0.0, 1.0])
    far = np.array([3.0, 0.0, 0.0])
    zero = np.zeros(3)
    assert surface_gap(_body(sphere), _body(sphere), zero, q, far, q) == pytest.approx(2.0)
    assert surface_gap(_body(sphere), _body(box), zero, q, far, q) == pytest.approx(1.5)
    assert surface_gap(_body(box), _body(cylinder), zero, q, far, q) == pytest.approx(1.7)


def test_border_converts_to_si_about_the_centre_of_mass() -> None:
    """A 450 cm car at the origin has its centre of mass half its height up, in metres."""
    scene = build_scene(lay_out(stories.car_bin_table()))
    car = scene.body("car_1")
    assert car.position[2] == pytest.approx(0.725)
    assert car.shapes[0].size == pytest.approx((2.25, 0.9, 0.725))
    assert car.shapes[0].position == pytest.approx((0, 0, 0))
    assert car.inertia[2][2] == pytest.approx(1300 / 12 * (4.5**2 + 1.8**2))
    assert car.wheeled and car.active and not scene.body("bin_1").active
    assert scene.ground_friction == 0.7


@pytest.mark.parametrize("story", stories.EVERY, ids=lambda s: s.__name__)
@pytest.mark.parametrize("seed", [0, 7])
def test_starts_do_not_overlap(story, seed) -> None:
    """No two planned participants start inside each other."""
    scene = build_scene(lay_out(story(), seed))
    planned = {p.node for c in start_hints(story(), seed=seed).constellations for p in c.placements}
    bodies = [b for b in scene.bodies if b.shapes and b.name in planned]
    for i, a in enumerate(bodies):
        for b in bodies[i + 1 :]:
            gap = surface_gap(
                a, b, np.array(a.position), np.array(a.quaternion),
                np.array(b.position), np.array(b.quaternion),
            )  # fmt: skip
            assert gap > -1e-3, (a.name, b.name, gap)


def test_seeds_vary_the_start_and_repeat_it() -> None:
    """The same seed plans the same start, another seed another one."""
    doc = stories.car_bin_table()
    assert start_hints(doc, seed=1) == start_hints(doc, seed=1)
    assert start_hints(doc, seed=1) != start_hints(doc, seed=2)


def test_program_of_a_turn_turns_left_counter_clockwise() -> None:
    """Left is counter-clockwise: positive turn rate, heading grows by a quarter turn."""
    doc = lay_out(stories.turn_brake_hit())
    plan = make_plan(doc, build_scene(doc), seed=0)
    holds = [p for p in plan.compile(plan.initial()).primitives if p.kind == "HoldVelocity"]
    before, turn, after = holds
    assert turn.turn_rate > 0
    assert after.heading - before.heading == pytest.approx(math.pi / 2)
    assert turn.start == before.end and after.start == turn.end


def test_a_turn_ends_with_the_body_along_its_way() -> None:
    """Friction that held its turning back left it 0.8 degrees aside, to slide on like that."""
    doc = lay_out(stories.turn_brake_hit())
    scene = build_scene(doc)
    plan = make_plan(doc, scene, seed=0)
    program = plan.compile(plan.initial())
    turn = next(p for p in program.primitives if p.kind == "HoldVelocity" and p.turn_rate)
    alone = scene.with_bodies((scene.body("car_1"),))
    own = tuple(_without_touch(p) for p in program.primitives if p.body == "car_1")
    batch = batch_programs([Program(own, turn.end + 0.1)], alone.names)
    r = get_engine("physx").rollout(alone, batch, dt=1.0 / 240.0)
    k = round(turn.end * 240.0) - 2
    assert alone.bodies[0].tyre_friction > 0.0
    assert r.angular_velocity[0, k, 0, 2] == pytest.approx(turn.turn_rate, rel=1e-3)


def _without_touch(primitive: Primitive) -> Primitive:
    return (
        replace(primitive, until_contact=()) if hasattr(primitive, "until_contact") else primitive
    )


def test_what_runs_on_casters_has_no_tyres_and_other_carts_do() -> None:
    """The planner asks the table that the judge asks; tyres hold as brakes do."""
    doc = lay_out(stories.car_brakes_to_stop())
    scene = build_scene(doc)
    car = scene.body("car_1")
    tyred = {}
    for label in ("shopping cart", "pallet jack", "freight wagon", "wheelbarrow", "car"):
        called = replace(car, label=label, category="cart", tyre_friction=0.0)
        tyred[label] = with_tyres(doc, scene.with_bodies((called,))).bodies[0].tyre_friction
    assert {k for k, mu in tyred.items() if mu == 0.0} == {"shopping cart", "pallet jack"}
    assert tyred["car"] == pytest.approx(0.75)


def test_story_knows_what_an_event_waits_for() -> None:
    """The second collision of a chain follows the first."""
    story = read_story(stories.car_bin_table())
    assert story.previous_outcome("e2") == "e1" and story.previous_outcome("e1") is None


@pytest.mark.parametrize("prompt", [
    "A car hits a barrel and then drives into a wall.",
    "A cyclist bumps into a box, rides on and runs into a fence.",
])  # fmt: skip
def test_what_a_hit_has_met_goes_on_from_the_speed_that_it_left(prompt: str) -> None:
    """Only the engine knows that speed: the hold comes to its own at the pace of its kind."""
    doc = lay_out(stories.cast(prompt))
    scene = with_tyres(doc, build_scene(doc))
    plan = make_plan(doc, scene)
    holds = [p for p in plan.compile(plan.initial()).primitives if isinstance(p, HoldVelocity)]
    first, later = holds[0], holds[1:]
    assert first.gains is None and later
    usual = pace(doc, first.body)
    for hold in later:
        assert hold.gains is not None and hold.loses is not None
        # What its feet rub off on the ground within a step comes back as well.
        rubs = coasting_drag(prop(doc, hold.body))
        assert hold.gains == pytest.approx(usual.gains + rubs)
        assert 0.0 < hold.loses <= usual.brakes


def test_what_runs_off_a_thing_lands_on_its_feet() -> None:
    """Friction takes of its speed as it lands, and it does not have it back at once."""
    doc = lay_out(stories.cast("A dog runs off a table."))
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    holds = [p for p in plan.compile(plan.initial()).primitives if isinstance(p, HoldVelocity)]
    assert [h.gains is None for h in holds[:2]] == [True, False]
    assert holds[1].start == holds[0].end < 0.1
    assert holds[1].speed == pytest.approx(holds[0].speed, rel=0.1)
