"""Throws that go on after their first event, and what they go into."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.choreography.flights import Arc, flown_to
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.story.solid import beside_the_middle
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.story import read_story
from esg.engines.program import HoldVelocity, SetVelocity
from esg.graph.models import EsgDocument, NamedRegion
from esg.layout import solve
from esg.metrics.geometry import first_pass
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast


def _places(doc: EsgDocument) -> dict[str, np.ndarray]:
    (constellation,) = choreograph(doc).hints.constellations
    return {p.node: np.array([p.x_cm, p.y_cm]) for p in constellation.placements}


def _region(doc: EsgDocument, node: str, name: str = "inside") -> NamedRegion:
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[node].asset_id]
    return next(r for r in config.regions if r.name == name)


def test_an_arc_comes_down_as_it_would_in_free_fall() -> None:
    """Thrown up at 2 m/s from 1 m: z(t) is the height asked for, on the way down."""
    arc = Arc(0.0, 0.0, 1.0, 0.0, 3.0, 2.0)
    for height in (0.0, 0.5, 1.1):
        lasts = arc.time_to(height)
        assert 1.0 + 2.0 * lasts - 0.5 * GRAVITY_MPS2 * lasts**2 == pytest.approx(height)
        assert 2.0 - GRAVITY_MPS2 * lasts < 0.0
    assert arc.time_to(9.0) == pytest.approx(2.0 / GRAVITY_MPS2)


def test_a_car_that_flies_off_a_ramp_drives_to_it() -> None:
    """It starts on the ground, meets the ramp's foot, and takes off there, steeper than the ramp."""
    doc = cast("A car hits a ramp at 12 m/s and flies into a haystack.")
    story = read_story(doc)
    assert story.takes_off("car_1")
    assert not story.soars("car_1")
    (constellation,) = choreograph(doc).hints.constellations
    spots = {p.node: p for p in constellation.placements}
    assert spots["car_1"].z_cm is None
    facing = math.radians(spots["ramp_1"].yaw_deg - spots["car_1"].yaw_deg)
    assert math.cos(facing) == pytest.approx(-1.0)
    laid = solve(doc, hints=start_hints(doc))
    plan = make_plan(laid, build_scene(laid))
    hold, launch = plan.compile(plan.initial()).primitives
    assert isinstance(hold, HoldVelocity)
    assert hold.end == launch.time
    assert isinstance(launch, SetVelocity)
    ramp = doc.asset_configurations[doc.spatial_relation_graph.nodes["ramp_1"].asset_id]
    slope = ramp.dimensions_cm[2] / ramp.dimensions_cm[0]
    assert launch.linear[2] > slope * math.hypot(*launch.linear[:2])


def test_a_throw_past_something_is_meant_for_what_is_behind_it() -> None:
    """One flight to the bale; the scarecrow stands beside the line, not on it."""
    doc = cast("A frisbee flies past a scarecrow without touching it and hits a hay bale.")
    story = read_story(doc)
    first = story.phases["frisbee_1"][0]
    assert "scarecrow_1" in first.end.participants
    assert "hay_bale_1" in flown_to(story, first).end.participants
    at = _places(doc)
    line = at["hay_bale_1"] - at["frisbee_1"]
    offset = at["scarecrow_1"] - at["frisbee_1"]
    along = float(offset @ line) / float(line @ line)
    aside = abs(float(line[0] * offset[1] - line[1] * offset[0])) / float(np.linalg.norm(line))
    assert 0.1 < along < 0.9
    assert aside > 30.0


def test_a_ball_off_the_backboard_is_thrown_over_the_rim() -> None:
    """It flies, meets the board above the hoop, and what is left of its speed covers the gap."""
    doc = cast("A basketball bounces off the backboard and goes through the hoop.")
    story = read_story(doc)
    assert story.flies("basketball_1")
    edge = story.phases["basketball_1"][0].edge.id
    told = choreograph(doc).nominal
    region = _region(doc, "backboard_1")
    rim = (region.center_cm[2] + region.half_extents_cm[2]) / 100.0
    assert told[f"{edge}/goal_above"] + region.center_cm[2] / 100.0 > rim
    assert told[f"{edge}/goal_beyond"] > 0.0
    ball, board = prop(doc, "basketball_1"), prop(doc, "backboard_1")
    back = 0.5 * (ball.restitution + board.restitution) * told[f"{edge}/speed"]
    assert back * 0.125 == pytest.approx(told[f"{edge}/goal_beyond"], rel=0.01)


def test_what_falls_through_a_hoop_lands_below_it() -> None:
    doc = cast("A stone is thrown through a hoop and lands in a bucket.")
    at = _places(doc)
    hoop = at["hoop_1"]
    region = _region(doc, "hoop_1")
    away = float(np.linalg.norm(at["bucket_1"] - hoop))
    assert away < abs(region.center_cm[0]) + 150.0
    assert (
        away
        > 0.5
        * doc.asset_configurations[
            doc.spatial_relation_graph.nodes["bucket_1"].asset_id
        ].dimensions_cm[0]
    )


@pytest.mark.parametrize(
    ("prompt", "owner"),
    [
        ("A hockey puck hits the goal post and bounces into the net.", "net_1"),
        ("A ball rolls past a cone and enters a tent.", "tent_1"),
        ("A basketball drops through a hoop and lands in a crate.", "crate_1"),
    ],
)
def test_what_is_entered_has_an_inside(prompt: str, owner: str) -> None:
    """The region that the event names exists, and no part of the body fills its middle."""
    doc = cast(prompt)
    regions = [n.region for n in read_story(doc).nodes.values() if n.region]
    asked = [r.split("/")[1] for r in regions if r.startswith(f"{owner}/")]
    if not asked:
        pytest.skip("the draft speaks of no region here")
    region = _region(doc, owner, asked[0])
    node = doc.spatial_relation_graph.nodes[owner]
    for proxy in doc.asset_configurations[node.asset_id].proxies:
        away = np.abs(np.array(region.center_cm) - np.array(proxy.position_cm))
        assert proxy.kind.value == "convex" or np.any(away >= np.array(proxy.size_cm))


def test_what_is_low_meets_a_leg_and_not_the_air_between_two() -> None:
    """A toy car is lower than a table's top: the table is moved so that a leg is in its way."""
    doc = cast("A toy car drives into a table.")
    car, table = prop(doc, "toy_car_1"), prop(doc, "table_1")
    off = beside_the_middle(car, table, math.pi / 2)
    assert abs(off) > 0.5 * car.width
    tall = prop(cast("A van drives into a table."), "van_1")
    assert beside_the_middle(tall, table, math.pi / 2) == 0.0 or tall.height < table.height


def test_a_pass_is_the_first_one_that_comes_about_as_close() -> None:
    """A dart thrown back by its board comes by again, closer: it has passed before."""
    time = np.linspace(0.0, 2.0, 201)
    away = np.abs(time - 0.5) * 10.0 + 1.0
    again = np.abs(time - 1.6) * 10.0 + 0.4
    assert first_pass(np.minimum(away, again)) == 50
    assert first_pass(again) == 160
    assert first_pass(np.full(20, 3.0)) == 0
