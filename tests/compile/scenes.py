"""Small physical scenes for the compile tests (SI)."""

from __future__ import annotations

import math

import numpy as np

from esg.compile import WatchedEvent
from esg.engines.program import (
    AdjustProperties,
    ApplyImpulse,
    HoldVelocity,
    Program,
    SetVelocity,
)
from esg.engines.scene import Body, Shape, SimScene


def box_inertia(mass: float, half: tuple[float, float, float]) -> tuple[tuple[float, ...], ...]:
    x, y, z = (2 * h for h in half)
    d = np.array([y * y + z * z, x * x + z * z, x * x + y * y]) * mass / 12
    return tuple(tuple(row) for row in np.diag(d).tolist())


def box(
    name: str,
    at: tuple[float, float, float],
    half: tuple[float, float, float],
    mass: float,
    yaw: float = 0.0,
    **more: object,
) -> Body:
    return Body(
        name=name,
        static=bool(more.pop("static", False)),
        mass=mass,
        inertia=box_inertia(mass, half),
        shapes=(Shape("box", half),),
        position=at,
        quaternion=(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)),
        origin_offset=(0.0, 0.0, -half[2]),
        half_extents=half,
        **more,  # type: ignore[arg-type]
    )


def ball(
    name: str, at: tuple[float, float, float], radius: float, mass: float, **more: object
) -> Body:
    i = 0.4 * mass * radius**2
    return Body(
        name=name,
        static=False,
        mass=mass,
        inertia=((i, 0.0, 0.0), (0.0, i, 0.0), (0.0, 0.0, i)),
        shapes=(Shape("sphere", (radius, radius, radius)),),
        position=at,
        roll_radius=radius,
        origin_offset=(0.0, 0.0, -radius),
        half_extents=(radius, radius, radius),
        **more,  # type: ignore[arg-type]
    )


def cylinder(
    name: str, at: tuple[float, float, float], radius: float, half: float, mass: float, **m: object
) -> Body:
    flat = mass * (3 * radius**2 + 4 * half**2) / 12
    spin = mass * radius**2 / 2
    return Body(
        name=name,
        static=False,
        mass=mass,
        inertia=((flat, 0.0, 0.0), (0.0, flat, 0.0), (0.0, 0.0, spin)),
        shapes=(Shape("cylinder", (radius, radius, half)),),
        position=at,
        origin_offset=(0.0, 0.0, -half),
        half_extents=(radius, radius, half),
        **m,  # type: ignore[arg-type]
    )


STREET_WATCH = (WatchedEvent("hit", ("car_1",), ("trash_bin_1",)),)
MARBLES_WATCH = (
    WatchedEvent("a hits b", ("ball_a",), ("ball_b",)),
    WatchedEvent("b hits c", ("ball_b",), ("ball_c",), ("a hits b",)),
)


def street() -> tuple[SimScene, Program]:
    """A driven car turns into a bin, brakes; a table is kicked; a decal and a wall stand by."""
    car = box(
        "car_1", (-6.0, -1.0, 0.75), (2.25, 0.9, 0.75), 1200.0, 0.2, friction=0.1, wheeled=True
    )
    bin_ = cylinder(
        "trash_bin_1", (1.0, 0.4, 0.45), 0.3, 0.45, 15.0, friction=0.6, linear_damping=0.05
    )
    table = box("table_1", (4.0, 1.5, 0.375), (0.6, 0.4, 0.375), 20.0, -0.7, friction=0.6)
    wall = box("wall_1", (9.0, 0.0, 1.0), (0.2, 4.0, 1.0), 500.0, 0.3, static=True)
    lane = Body("lane_1", True, 0.0, box_inertia(1.0, (1, 1, 1)), (), (0.0, 0.0, 0.0),
                half_extents=(5.0, 1.0, 0.01))  # fmt: skip
    program = Program(
        (
            HoldVelocity("car_1", 0.25, math.inf, 6.0, 0.2, 1.5, 9.0, -0.05, 0.0, ("trash_bin_1",)),
            ApplyImpulse("table_1", 0.5, (-5.0, 12.0, 30.0)),
            SetVelocity("table_1", 1.2, (0.5, -1.0, 2.0), (0.1, 0.4, -2.0)),
            AdjustProperties("car_1", 1.5, 1.8, 0.3, 0.35),
        ),
        3.0,
    )
    return SimScene("S6", (car, bin_, table, wall, lane)), program


def marbles() -> tuple[SimScene, Program]:
    """Ball A rolls into B, B into C; a bouncing capsule and a spun hull beside them."""
    balls = [
        ball(f"ball_{n}", (x, y, 0.11), 0.11, 2.0 + i, friction=0.2, restitution=0.8)
        for i, (n, x, y) in enumerate((("a", 0.0, 0.0), ("b", 1.0, 0.03), ("c", 2.0, 0.0)))
    ]
    capsule = Body(
        "pill_1", False, 0.5, ((0.004, 0.0, 0.0), (0.0, 0.004, 0.0), (0.0, 0.0, 0.001)),
        (Shape("capsule", (0.08, 0.08, 0.12)),), (0.0, 3.0, 1.0),
        quaternion=(0.3, 0.1, -0.2, math.sqrt(1 - 0.14)), restitution=0.6,
        origin_offset=(0.0, 0.0, -0.2), half_extents=(0.08, 0.08, 0.2),
    )  # fmt: skip
    tilt = np.array([[0.04, 0.004, -0.002], [0.004, 0.05, 0.003], [-0.002, 0.003, 0.03]])
    points = tuple((x, y, z) for x in (-0.2, 0.2) for y in (-0.15, 0.25) for z in (-0.1, 0.1))
    points = (*points, (0.3, 0.0, 0.3))
    hull = Body(
        "wedge_1", False, 3.0, tuple(tuple(r) for r in tilt.tolist()),
        (Shape("convex", (0.25, 0.2, 0.2), (0.01, 0.0, 0.02), vertices=points),),
        (-2.0, -2.0, 0.8), quaternion=(0.1, -0.2, 0.3, math.sqrt(1 - 0.14)),
        origin_offset=(0.02, -0.01, -0.1), half_extents=(0.3, 0.2, 0.2),
    )  # fmt: skip
    program = Program(
        (
            HoldVelocity("ball_a", 0.0, 0.4, 2.5, 0.0, roll_radius=0.11, until_contact=("ball_b",)),
            SetVelocity("pill_1", 0.0, (0.4, -0.3, 0.0), (2.0, 0.0, 1.0)),
            SetVelocity("wedge_1", 0.1, (0.0, 0.3, 1.0)),
        ),
        2.5,
    )
    return SimScene("S7", (*balls, capsule, hull)), program
