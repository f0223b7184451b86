"""Down a ramp: its side view, the ride, what is cast for it, and what waits at the foot."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.choreography.hits.demands import passed_on, run_on_speed
from esg.dynamics.choreography.slopes import (
    Ride,
    Slope,
    arrival_speed,
    come_down,
    fastest_down,
    ride_of,
    rides,
    slope_of,
    slows_enough,
)
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.story import read_story
from esg.engines.program import batch_programs
from esg.engines.registry import get_engine
from esg.graph.models import AssetConfiguration, EsgDocument, Proxy, ProxyKind
from esg.layout import solve
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast

WEDGE = Slope(np.linspace(-0.7, 1.25, 98), np.linspace(0.8, 0.0, 98))


def config(doc: EsgDocument, name: str) -> AssetConfiguration:
    return doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]


def test_a_ramp_and_a_chute_have_a_slope_stairs_and_tables_have_none() -> None:
    doc = cast("A ball rolls down a ramp and hits a box. A table and a staircase stand nearby.")
    ramp = slope_of(doc, "ramp_1")
    assert ramp is not None
    assert ramp.height == pytest.approx(0.8, abs=0.02)
    assert ramp.foot == pytest.approx(1.25, abs=0.02)
    assert np.all(np.diff(ramp.z) < 0.0)
    assert slope_of(doc, "table_1") is None
    assert slope_of(doc, "staircase_1") is None
    chute = slope_of(cast("A ball rolls down a chute and hits a box."), "chute_1")
    assert chute is not None
    assert chute.steepness > ramp.steepness


def test_a_gap_before_a_surface_is_no_slope() -> None:
    doc = cast("A ball rolls down a ramp and hits a box.")
    key = doc.spatial_relation_graph.nodes["ramp_1"].asset_id
    ramp = doc.asset_configurations[key]
    boxes = tuple(
        Proxy(kind=ProxyKind.BOX, size_cm=(5, 50, 2), position_cm=(x, 0, z))
        for x, z in ((-100, 78), (100, 2))
    )
    apart = ramp.model_copy(update={"proxies": boxes})
    doc = doc.model_copy(update={"asset_configurations": {**doc.asset_configurations, key: apart}})
    with np.errstate(invalid="raise"):
        assert slope_of(doc, "ramp_1") is None


def test_a_ramp_is_one_piece_so_that_nothing_catches_on_a_seam() -> None:
    assert len(config(cast("A ball rolls down a ramp and hits a box."), "ramp_1").proxies) == 1


@pytest.mark.parametrize(("roll", "friction"), [(0.0, 0.0), (0.4, 0.0), (0.0, 0.2)])
def test_a_ride_keeps_the_energy_that_friction_and_rolling_leave(
    roll: float, friction: float
) -> None:
    ride = Ride(roll, friction, 0.0, 0.0)
    speed = come_down(WEDGE, ride, WEDGE.crest, 1.0).at(WEDGE.foot - 0.01)[1]
    way = WEDGE.foot - WEDGE.crest - 0.01
    gained = 2.0 * GRAVITY_MPS2 * (WEDGE.steepness * way / (1.0 + roll) - friction * way)
    assert speed == pytest.approx(math.sqrt(1.0 + gained), rel=0.02)


def test_what_friction_holds_does_not_come_down() -> None:
    ride = Ride(0.0, 0.6, 4.0, 0.0)
    assert come_down(WEDGE, ride, WEDGE.crest, 0.3).at(WEDGE.foot) == (math.inf, 0.0)


def test_a_speed_of_the_hit_is_the_one_at_the_foot_and_one_of_the_ride_that_at_the_top() -> None:
    at_hit = cast("A suitcase slides down a ramp and hits a wall at 3 m/s.")
    [(node, actor, _, _)] = rides(at_hit, read_story(at_hit))
    assert arrival_speed(node, actor) == pytest.approx(3.0)
    [phase] = read_story(at_hit).phases[actor]
    assert not phase.edge.speed_is_prescribed
    of_ride = cast("A suitcase slides down a ramp at 3 m/s and hits a wall.")
    [(node, actor, _, _)] = rides(of_ride, read_story(of_ride))
    assert arrival_speed(node, actor) is None
    [phase] = read_story(of_ride).phases[actor]
    assert phase.edge.params.speed == pytest.approx(300.0)


def test_what_slides_down_is_let_go_and_what_rolls_down_keeps_its_grip() -> None:
    slid = cast("A suitcase slides down a ramp and hits a wall.")
    slope = slope_of(slid, "ramp_1")
    assert slope is not None
    pull = 0.5 * (config(slid, "suitcase_1").friction + config(slid, "ramp_1").friction)
    assert pull < 0.5 * slope.steepness
    rolled = cast("A ball rolls down a ramp and hits a wall.")
    assert config(rolled, "ramp_1").friction > 0.3


@pytest.mark.parametrize("speed", [2.5, 5.0])
def test_a_ramp_is_as_high_as_a_stated_speed_at_its_foot_asks_for(speed: float) -> None:
    doc = cast(f"A crate slides down a ramp and hits a wall at {speed} m/s.")
    slope = slope_of(doc, "ramp_1")
    assert slope is not None
    ride = ride_of(prop(doc, "crate_1"), prop(doc, "ramp_1"))
    came = come_down(slope, ride, slope.crest - 0.2, 0.8).at(slope.foot + 0.3)[1]
    assert came == pytest.approx(speed, abs=0.6)
    stated = cast("A crate slides down a ramp 1 m high and hits a wall at 6 m/s.")
    assert config(stated, "ramp_1").dimensions_cm[2] == pytest.approx(100.0)


def test_a_late_hit_at_the_foot_is_on_slippery_ground() -> None:
    soon = cast("A sled slides down the hill and crashes into a tree.")
    late = cast("A sled slides down the hill and crashes into a tree after 4 seconds.")
    assert config(late, "ground_1").friction < config(soon, "ground_1").friction
    assert slows_enough(WEDGE, Ride(0.0, 0.1, 4.0, 0.0), -0.9, 0.9) is None


def test_the_target_waits_behind_the_foot_where_the_ride_is_still_fast() -> None:
    doc = cast("A suitcase slides down a ramp and hits a barrel.")
    choreography = choreograph(doc)
    [places] = choreography.hints.constellations
    slope = slope_of(doc, "ramp_1")
    assert slope is not None
    [barrel] = [p for p in places.placements if p.node == "barrel_1"]
    near = 0.01 * (barrel.x_cm - 0.5 * config(doc, "barrel_1").dimensions_cm[0]) - slope.foot
    assert prop(doc, "suitcase_1").length < near < prop(doc, "suitcase_1").length + 0.6
    assert choreography.nominal["suitcase_1_slide/speed"] < 2.0


def test_what_a_ramp_gives_limits_what_is_knocked_over() -> None:
    doc = cast("A ball rolls down a ramp and knocks over a box.")
    given = fastest_down(doc, "ball_1")
    assert given is not None
    assert 3.0 < given < 5.0
    assert fastest_down(doc, "box_1") is None


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball rolls down a ramp and hits a box after 2 seconds.",
        "A skateboard rolls down a ramp and hits a hydrant.",
    ],
)
def test_the_ride_as_told_hits_in_time(prompt: str) -> None:
    doc = cast(prompt)
    doc = solve(doc, hints=start_hints(doc))
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    told = choreograph(doc).nominal
    name = next(k for k in told if k.endswith("collision/event_time"))
    program = replace(plan.compile(plan.initial()), duration=told[name] + 1.0)
    log = get_engine("physx").rollout(scene, batch_programs([program], scene.names)).contacts
    actor = next(iter(read_story(doc).phases))
    ramp, mover = scene.index("ramp_1"), scene.index(actor)
    hits = [
        float(t)
        for t, a, b in zip(log.time, log.a, log.b, strict=True)
        if mover in (a, b) and ramp not in (a, b) and b >= 0
    ]
    assert hits
    assert hits[0] == pytest.approx(told[name], abs=0.25)


def test_the_second_target_at_the_foot_of_a_ramp_is_no_ramp_length_behind_the_first() -> None:
    """Who has hit something on the ground has left the ramp."""
    doc = cast("A ball rolls down a ramp, knocks over a bottle and hits a box.")
    found = choreograph(doc).hints.constellations
    places = {p.node: p for c in found for p in c.placements}
    gap = places["box_1"].x_cm - places["bottle_1"].x_cm
    node = doc.spatial_relation_graph.nodes["ramp_1"]
    assert 0.0 < gap < doc.asset_configurations[node.asset_id].dimensions_cm[0]


def test_what_is_pushed_on_by_something_off_a_ramp_is_light_enough_for_that() -> None:
    doc = cast("A skateboard rolls down a ramp, bumps into a plastic bin and the bin hits a curb.")
    board, waste = prop(doc, "skateboard_1"), prop(doc, "bin_1")
    came = fastest_down(doc, "skateboard_1")
    assert came is not None
    assert 0.9 * passed_on(board, waste) * came >= 0.99 * run_on_speed(waste)
