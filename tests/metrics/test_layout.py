"""SLR: what is there, and what overlaps at the start."""

from __future__ import annotations

import numpy as np
import pytest

from esg.engines.program import SetVelocity
from esg.engines.scene import Shape
from esg.metrics import SuiteEvent
from tests.metrics.worlds import World, ball, body, line


@pytest.mark.parametrize(("gap", "valid"), [(-0.019, True), (-0.021, False), (0.05, True)])
def test_two_centimetres_of_overlap(gap, valid):
    world = World(0.1).add(body("box_1")).add(body("box_2"), x=0.2 + gap)
    layout = world.judge().layout
    assert layout.valid is valid
    assert layout.max_penetration_m == pytest.approx(max(0.0, -gap), abs=1e-4)
    if not valid:
        assert (layout.overlaps[0].a, layout.overlaps[0].b) == ("box_1", "box_2")
        assert layout.overlaps[0].depth_m == pytest.approx(-gap, abs=1e-4)


def test_overlap_is_measured_on_the_shapes_not_on_their_boxes():
    # Two spheres whose bounding boxes overlap in a corner by 6 cm, but which are apart.
    world = World(0.1).add(ball("ball_1")).add(ball("ball_2"), x=0.15, y=0.15)
    assert world.judge().layout.max_penetration_m == 0.0
    legs = (
        Shape("box", (0.05, 0.05, 0.4), (0.5, 0.0, 0.0)),
        Shape("box", (0.05, 0.05, 0.4), (-0.5, 0.0, 0.0)),
    )
    table = body("table_1", Shape("box", (0.5, 0.5, 0.4)), shapes=legs)
    under = World(0.1).add(table).add(ball("ball_1"))
    assert under.judge().slr


def test_overlap_is_judged_before_anything_moves():
    world = World(1.0).add(body("box_1"), x=line(0.0, 1.0)).add(body("box_2"), x=0.5)
    assert world.judge().slr


def test_a_dynamic_body_must_not_start_in_the_ground_but_a_fixed_one_may():
    sunk = World(0.1).add(body("box_1"), z=0.07)
    assert sunk.judge().layout.overlaps[0].b == "ground"
    assert World(0.1).add(body("post_1", static=True), z=0.07).judge().slr


def test_decals_overlap_nothing():
    world = World(0.1).add(body("road_1", shapes=(), static=True)).add(body("box_1"))
    assert world.judge().slr


def test_everything_the_suite_names_must_be_there():
    events = [SuiteEvent(id="e1", type="enters", object="box", target="goal")]
    verdict = World(0.1).add(body("box_1")).judge(events)
    assert not verdict.slr
    assert any("goal" in m for m in verdict.layout.missing)
    assert World(0.1).add(body("box_1")).judge(objects=["box"]).slr
    assert not World(0.1).add(body("box_1")).judge(objects=["two boxes"]).slr


def test_bindings_are_reported():
    verdict = World(0.1).add(body("box_1")).judge(objects=["the box"])
    assert verdict.bindings == {"the box": ("box_1",)}


def falling(z: float):
    return lambda t: np.maximum(z - 0.5 * 9.81 * t**2, 0.1)


def on_table(world: World, x: float = 0.0) -> World:
    """A table of 1 x 1 m, its top 0.8 m high."""
    top = body("table_1", Shape("box", (0.5, 0.5, 0.4)), static=True)
    return world.add(top, x=x)


def test_what_hangs_beside_its_support_makes_a_layout_invalid():
    beside = on_table(World(1.0)).add(body("vase_1"), x=0.7, z=falling(0.9))
    assert beside.judge().layout.hanging == ("vase_1",)
    assert not beside.judge().slr
    on_it = on_table(World(1.0)).add(body("vase_1"), x=0.3, z=0.9)
    assert on_it.judge().slr


def test_a_gap_below_two_centimetres_is_no_fault_and_what_does_not_fall_neither():
    near = on_table(World(1.0)).add(body("vase_1"), z=lambda t: np.maximum(0.915 - t, 0.9))
    assert near.judge().slr
    held = World(1.0).add(body("drone_1"), z=1.5)
    assert held.judge().slr


def test_what_the_suite_lets_fall_may_start_in_the_air():
    def start(x: float, *events: SuiteEvent):
        world = on_table(World(1.0), x=x).add(body("vase_1"), z=falling(2.0))
        return world.judge(list(events)).layout

    onto = SuiteEvent(id="e1", type="collision", a="vase", b="table")
    assert start(0.0, onto).valid
    assert start(3.0, onto).hanging == ("vase_1",)  # the table is not below
    assert start(3.0, SuiteEvent(id="e1", type="falls", object="vase")).valid
    off = SuiteEvent.model_validate(
        {"id": "e1", "type": "falls", "object": "vase", "from": "table"}
    )
    assert start(3.0, off).hanging == ("vase_1",)
    assert start(0.0, off).valid


def test_what_the_program_launches_may_start_in_the_air():
    world = World(1.0).add(body("vase_1"), z=falling(2.0))
    assert not world.judge().slr
    world.primitives.append(SetVelocity("vase_1", 0.0, linear=(1.0, 0.0, 0.0)))
    assert world.judge().slr
