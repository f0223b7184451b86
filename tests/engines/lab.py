"""Bodies and a scene in which many analytic experiments run side by side, far apart."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np

from esg.engines.program import (
    AdjustProperties,
    ApplyImpulse,
    HoldVelocity,
    Program,
    SetVelocity,
)
from esg.engines.scene import Body, Shape, SimScene
from esg.units import quat_from_euler_deg, quat_multiply, quat_rotate

DT = 1.0 / 240.0
G = 9.81


def _tensor(diagonal):
    return tuple(tuple(float(v) for v in row) for row in np.diag(diagonal))


def box(name, half, mass, position, **more):
    x, y, z = (2.0 * h for h in half)
    inertia = [
        mass / 12 * (y * y + z * z),
        mass / 12 * (x * x + z * z),
        mass / 12 * (x * x + y * y),
    ]
    return Body(name, False, mass, _tensor(inertia), (Shape("box", half),), position, **more)


def ball(name, radius, mass, position, **more):
    inertia = _tensor([0.4 * mass * radius**2] * 3)
    shape = Shape("sphere", (radius, radius, radius))
    return Body(name, False, mass, inertia, (shape,), position, roll_radius=radius, **more)


def solid(name, shape, mass, position, **more):
    """A body of one shape with the inertia of its bounding box; good enough at rest."""
    a, b, c = shape.size if shape.kind != "capsule" else (0.1, 0.1, 0.3)
    return Body(
        name, False, mass, box("", (a, b, c), mass, (0, 0, 0)).inertia, (shape,), position, **more
    )


def rotated(body, quaternion):
    """The same body described in a body frame turned by `quaternion`."""
    r = np.stack([quat_rotate(quaternion, e) for e in np.eye(3)], axis=1)
    inertia = r @ np.array(body.inertia) @ r.T
    inverse = np.array([-1, -1, -1, 1]) * np.array(quaternion)
    shapes = tuple(
        Shape(
            s.kind,
            s.size,
            tuple(quat_rotate(quaternion, s.position)),
            tuple(quat_multiply(quaternion, s.quaternion)),
        )
        for s in body.shapes
    )
    return replace(
        body,
        inertia=tuple(tuple(float(v) for v in row) for row in inertia),
        shapes=shapes,
        quaternion=tuple(float(v) for v in quat_multiply(body.quaternion, inverse)),
    )


PIT_YAW = 30.0
_PIT_QUAT = tuple(float(v) for v in quat_from_euler_deg(PIT_YAW))


def pit(position):
    """A static table of four boxes around a 0.3 m square hole, 0.5 m high."""
    h, t = 0.25, 0.2
    shapes = tuple(
        Shape("box", size, centre)
        for size, centre in (
            ((t, 0.15 + 2 * t, h), (0.15 + t, 0.0, 0.0)),
            ((t, 0.15 + 2 * t, h), (-0.15 - t, 0.0, 0.0)),
            ((0.15, t, h), (0.0, 0.15 + t, 0.0)),
            ((0.15, t, h), (0.0, -0.15 - t, 0.0)),
        )
    )
    return Body("pit", True, 0.0, _tensor([1, 1, 1]), shapes, position, quaternion=_PIT_QUAT)


def _pit_point(x, y, z):
    return tuple(float(v) for v in quat_rotate(_PIT_QUAT, (x, y, 0.0)) + np.array([0, 60, z]))


_HULL = tuple((x, y, z) for x in (-0.2, 0.2) for y in (-0.1, 0.1) for z in (-0.15, 0.15))
_TILT = quat_from_euler_deg(25.0, 40.0, 10.0)

BODIES = (
    ball("drop", 0.1, 1.0, (0, 0, 9.0), restitution=0.0),
    box("throw", (0.1, 0.2, 0.3), 2.0, (0, 4, 20.0)),
    ball("elastic 1", 0.1, 1.0, (0, 8, 50.0), restitution=1.0),
    ball("elastic 2", 0.1, 2.0, (0.5, 8, 50.0), restitution=1.0),
    ball("half 1", 0.1, 1.0, (0, 12, 50.0), restitution=0.25),
    ball("half 2", 0.1, 3.0, (0.5, 12, 50.0), restitution=0.75),
    ball("dead 1", 0.1, 1.0, (0, 16, 50.0), restitution=0.0),
    ball("dead 2", 0.1, 1.0, (0.5, 16, 50.0), restitution=0.0),
    box("slide", (0.2, 0.2, 0.1), 2.0, (0, 20, 0.1), friction=0.3),
    box("damped", (0.2, 0.2, 0.1), 2.0, (0, 24, 40), linear_damping=0.5, angular_damping=0.8),
    ball("bowl", 0.1, 1.0, (0, 28, 0.1), restitution=0.0),
    Body("wall", True, 0.0, _tensor([1, 1, 1]), (Shape("box", (0.1, 1, 1)),), (1.6, 28, 1.0)),
    box("turner", (1.0, 0.5, 0.4), 900.0, (0, 40, 0.4), wheeled=True, friction=0.0),
    ball("roller", 0.15, 2.0, (0, 70, 0.15), friction=0.5),
    box("coaster", (1.0, 0.5, 0.4), 900.0, (0, 74, 0.4), wheeled=True, friction=0.0),
    box("braker", (1.0, 0.5, 0.4), 900.0, (0, 78, 0.4), wheeled=True, friction=0.0),
    ball("kicked", 0.1, 4.0, (0, 82, 30.0)),
    pit((0, 60, 0.25)),
    ball("pocketed", 0.1, 0.5, _pit_point(0.0, 0.0, 1.0), restitution=0.0),
    ball("shelved", 0.1, 0.5, _pit_point(0.35, 0.0, 0.61), restitution=0.0),
    Body("decal", False, 1.0, _tensor([1, 1, 1]), (), (3.0, 0.0, 2.0)),
    box("racer", (0.2, 0.2, 0.2), 5.0, (0, 86, 0.2), friction=0.0, wheeled=True),
    rotated(box("spinner", (0.1, 0.2, 0.3), 2.0, (0, 90, 20.0)), _TILT),
    solid("capsule", Shape("capsule", (0.1, 0.1, 0.2)), 1.0, (0, 94, 0.3)),
    solid("cylinder", Shape("cylinder", (0.2, 0.2, 0.3)), 1.0, (0, 96, 0.3)),
    solid("convex", Shape("convex", (0.2, 0.1, 0.15), vertices=_HULL), 1.0, (0, 98, 0.15)),
    ball("bouncer", 0.1, 1.0, (0, 102, 2.1), restitution=0.8),
)

SCENE = SimScene("lab", BODIES, ground_friction=0.7, ground_restitution=0.4)

TURN_RATE = 0.5
PROGRAM = Program(
    (
        SetVelocity("throw", 0.5, (3.0, 0.0, 4.0), (0.0, 0.0, 2.0)),
        SetVelocity("elastic 1", 0.0, (2.0, 0.0, 0.0)),
        SetVelocity("half 1", 0.0, (2.0, 0.0, 0.0)),
        SetVelocity("dead 1", 0.0, (2.0, 0.0, 0.0)),
        SetVelocity("slide", 0.0, (3.0, 0.0, 0.0)),
        SetVelocity("damped", 0.0, (2.0, 0.0, 0.0), (0.0, 0.0, 3.0)),
        HoldVelocity("bowl", 0.25, math.inf, 2.0, 0.0, roll_radius=0.1, until_contact=("wall",)),
        HoldVelocity("turner", 0.0, math.inf, 4.0, 0.0, turn_rate=TURN_RATE),
        HoldVelocity("roller", 0.0, 0.5, 2.0, math.pi, roll_radius=0.15),
        SetVelocity("coaster", 0.0, (-5.0, 0.0, 0.0)),
        SetVelocity("braker", 0.0, (5.0, 0.0, 0.0)),
        AdjustProperties("braker", 0.5, friction=1.0),
        ApplyImpulse("kicked", 0.5, (4.0, 8.0, 0.0)),
        ApplyImpulse("kicked", 1.0, (4.0, 8.0, 0.0)),
        SetVelocity("kicked", 1.0, (1.0, 0.0, 0.0)),
        HoldVelocity("racer", 0.5, 1.5, 1.0, 0.0, acceleration=3.0, max_speed=2.5),
        SetVelocity("spinner", 0.0, (0.0, 0.0, 0.0), (0.0, 0.0, 5.0)),
        AdjustProperties("roller", 1.5, linear_damping=2.0),
    ),
    2.0,
)
