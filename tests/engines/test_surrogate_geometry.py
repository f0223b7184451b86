"""Contacts of every pair of shapes, as the surrogate's engine feels them."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from esg.engines import get_engine
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.scene import Body, Shape, SimScene

DT = 1.0 / 240.0
UNIT = ((0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1))
CORNERS = tuple((x, y, z) for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (-0.3, 0.3))
SHAPES = {
    "sphere": Shape("sphere", (0.2, 0.2, 0.2)),
    "box": Shape("box", (0.2, 0.2, 0.3)),
    "capsule": Shape("capsule", (0.2, 0.2, 0.1)),
    "cylinder": Shape("cylinder", (0.2, 0.2, 0.3)),
    "convex": Shape("convex", (0.2, 0.2, 0.3), vertices=CORNERS),
}
"""All reach 0.2 m along X."""


def body(name, shape, x, **more):
    return Body(name, False, 1.0, UNIT, (shape,), (x, 0.0, 10.0), restitution=1.0, friction=0.0,
                **more)  # fmt: skip


def collide(first, second, speed=3.0, quaternion=(0.0, 0.0, 0.0, 1.0)):
    """Two bodies without gravity, half a metre apart, one moving along X."""
    scene = SimScene(
        "pair",
        (body("a", first, 0.0), body("b", second, 0.9, quaternion=quaternion)),
        gravity=(0.0, 0.0, 0.0),
    )
    program = Program((SetVelocity("a", 0.0, (speed, 0.0, 0.0)),), 0.5)
    return get_engine("surrogate").rollout(scene, batch_programs([program], scene.names), dt=DT)


@pytest.mark.parametrize(("one", "two"), list(itertools.product(SHAPES, repeat=2)))
def test_equal_masses_exchange_their_speed_at_the_right_time(one, two):
    rollout = collide(SHAPES[one], SHAPES[two])
    v = rollout.linear_velocity[0, -1].astype(float)
    assert v[0] == pytest.approx([0.0, 0.0, 0.0], abs=0.02)
    assert v[1] == pytest.approx([3.0, 0.0, 0.0], abs=0.02)
    log = rollout.contacts
    assert log.time[0] == pytest.approx(0.5 / 3.0, abs=1.01 * DT)
    assert log.impulse.sum() == pytest.approx(3.0, rel=0.01)
    # Portal refinement finds the normal of two round sides to a fifth of a degree.
    assert log.normal[0] == pytest.approx([-1.0, 0.0, 0.0], abs=4e-3)
    assert log.depth.max() < 1e-3


@pytest.mark.parametrize("speed", [5.0, 15.0, 30.0])
def test_fast_bodies_neither_overlap_nor_pass_through(speed):
    rollout = collide(SHAPES["box"], SHAPES["cylinder"], speed)
    assert rollout.contacts.depth.max() < 1e-3
    gap = rollout.position[0, :, 1, 0] - rollout.position[0, :, 0, 0]
    assert gap.min() > 0.4 - 1e-3
    assert not rollout.extra["tunnelled"][0]


def test_the_edge_of_a_turned_box_is_where_it_should_be():
    turned = (0.0, 0.0, np.sin(np.pi / 8), np.cos(np.pi / 8))
    rollout = collide(SHAPES["box"], SHAPES["box"], quaternion=turned)
    reach = 0.2 * np.sqrt(2.0)
    assert rollout.contacts.time[0] == pytest.approx((0.7 - reach) / 3.0, abs=1.01 * DT)


def test_a_hit_falls_between_steps_without_a_trace_in_the_path():
    # Whatever the phase of the step, b has moved 3 m/s times what is left after the touch.
    ends = []
    for speed in np.linspace(3.0, 3.05, 6):
        rollout = collide(SHAPES["sphere"], SHAPES["sphere"], float(speed))
        left = rollout.time[-1] - 0.5 / speed
        ends.append(rollout.position[0, -1, 1, 0] - 0.9 - speed * left)
    assert np.abs(ends).max() < 1e-4


def test_a_body_pushed_below_the_ground_is_reported():
    ball = Body("a", False, 1.0, UNIT, (SHAPES["sphere"],), (0.0, 0.0, -1.0))
    scene = SimScene("below", (ball,))
    rollout = get_engine("surrogate").rollout(
        scene, batch_programs([Program((), 0.2)], scene.names), dt=DT
    )
    assert rollout.extra["tunnelled"].tolist() == [True]


def test_room_for_contacts_grows(monkeypatch):
    from esg.engines.surrogate import engine as surrogate

    full = collide(SHAPES["box"], SHAPES["box"])
    monkeypatch.setattr(surrogate, "CONTACTS", 1)
    monkeypatch.setattr(surrogate, "ROWS_PER_FRAME", 0)
    tight = collide(SHAPES["box"], SHAPES["box"])
    np.testing.assert_array_equal(full.position, tight.position)
    np.testing.assert_array_equal(full.contacts.impulse, tight.contacts.impulse)
