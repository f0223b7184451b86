"""Random physical scenes of every shape, material and command, for comparing class and program."""

from __future__ import annotations

import math

import numpy as np

from esg.compile import WatchedEvent
from esg.engines.program import (
    MAX_KNOTS,
    AdjustProperties,
    ApplyImpulse,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Primitive,
    Program,
    SetVelocity,
    Vec,
)
from esg.engines.scene import Body, Shape, SimScene

SPACING_M = 2.0


def random_scene(
    seed: int, *, guided: bool = True
) -> tuple[SimScene, Program, tuple[WatchedEvent, ...]]:
    """Up to twelve bodies on a grid (no overlap at the start) under up to ten commands.

    `guided`: paths too. A class cannot spare its bodies gravity, whose substeps in Rapier then show.
    """
    rng = np.random.default_rng(seed)
    count = int(rng.integers(2, 13))
    bodies = tuple(_body(rng, i) for i in range(count))
    moving = [b for b in bodies if not b.static and b.collides]
    if not moving:
        return random_scene(seed + 100_000, guided=guided)
    commands = [_command(rng, moving, bodies, guided) for _ in range(int(rng.integers(0, 11)))]
    program = Program(tuple(commands), float(rng.uniform(0.5, 1.5)))
    solid = [b.name for b in bodies if b.collides]
    watch = tuple(
        WatchedEvent(f"e{i}", (moving[i].name,), tuple(n for n in solid if n != moving[i].name))
        for i in range(min(3, len(moving)))
        if len(solid) > 1
    )
    scene = SimScene(
        f"random {seed}",
        bodies,
        gravity=(0.0, 0.0, float(rng.uniform(-12.0, -1.0))),
        ground_friction=float(rng.uniform(0.0, 1.2)),
        ground_restitution=float(rng.uniform(0.0, 0.9)),
        vehicle_ground_friction=float(rng.uniform(0.0, 0.2)),
    )
    return scene, program, watch


def _quaternion(rng: np.random.Generator, upright: bool) -> tuple[float, float, float, float]:
    q = rng.normal(size=4)
    if upright:
        q[:2] = 0.0
    x, y, z, w = (q / np.linalg.norm(q)).tolist()
    return x, y, z, w


def _shape(rng: np.random.Generator) -> Shape:
    kind = str(rng.choice(["sphere", "box", "capsule", "cylinder", "convex"]))
    a, b, c = rng.uniform(0.05, 0.35, 3).tolist()
    at = tuple(rng.uniform(-0.1, 0.1, 3).tolist())
    turn = _quaternion(rng, False)
    if kind == "sphere":
        return Shape("sphere", (a, a, a), at)
    if kind == "box":
        return Shape("box", (a, b, c), at, turn)
    if kind in ("capsule", "cylinder"):
        return Shape(kind, (a, a, c), at, turn)  # type: ignore[arg-type]
    points = rng.uniform(-0.3, 0.3, (12, 3))
    half = tuple(np.abs(points).max(0).tolist())
    return Shape("convex", half, at, turn, tuple(tuple(p) for p in points.tolist()))


def _body(rng: np.random.Generator, index: int) -> Body:
    name = str(rng.choice(["ball", "car", "crate", "pin", "for", "Ünit"])) + f" {index}"
    row, column = divmod(index, 4)
    wheeled = bool(rng.random() < 0.2)
    root = rng.uniform(-1.0, 1.0, (3, 3)) * 0.3
    inertia = root @ root.T + np.diag(rng.uniform(0.2, 0.6, 3))
    return Body(
        name=name,
        static=bool(rng.random() < 0.15),
        mass=float(rng.uniform(0.1, 50.0)),
        inertia=tuple(tuple(r) for r in inertia.tolist()),
        shapes=() if rng.random() < 0.08 else tuple(_shape(rng) for _ in range(rng.integers(1, 4))),
        position=(column * SPACING_M, row * SPACING_M, float(rng.uniform(0.9, 1.5))),
        quaternion=_quaternion(rng, wheeled),
        friction=float(rng.uniform(0.0, 1.0)),
        restitution=float(rng.uniform(0.0, 0.9)),
        linear_damping=float(rng.choice([0.0, rng.uniform(0.0, 1.0)])),
        angular_damping=float(rng.choice([0.0, rng.uniform(0.0, 1.0)])),
        wheeled=wheeled,
        tyre_friction=float(rng.choice([0.0, 0.8])) if wheeled else 0.0,
        tyre_drop=float(rng.choice([0.0, 0.3])) if wheeled else 0.0,
        tyre_foot=0.1 if wheeled else 0.0,
        origin_offset=tuple(rng.uniform(-0.2, 0.2, 3).tolist()),  # type: ignore[arg-type]
        half_extents=(0.4, 0.4, 0.4),
    )


def _tuples(rows: list[list[float]]) -> tuple[Vec, ...]:
    return tuple((x, y, z) for x, y, z in rows)


def _command(
    rng: np.random.Generator, moving: list[Body], bodies: tuple[Body, ...], guided: bool
) -> Primitive:
    body = moving[rng.integers(len(moving))]
    time = float(rng.uniform(0.0, 0.8))
    vector = tuple(rng.uniform(-4.0, 4.0, 3).tolist())
    kind = rng.integers(6 if guided else 5)
    if kind == 0:
        spin = tuple(rng.uniform(-5.0, 5.0, 3).tolist()) if rng.random() < 0.5 else None
        return SetVelocity(body.name, time, vector, spin)  # type: ignore[arg-type]
    if kind == 1:
        return ApplyImpulse(body.name, time, tuple(v * body.mass for v in vector))  # type: ignore[arg-type]
    if kind == 2:
        values = [float(v) if rng.random() < 0.7 else None for v in rng.uniform(0.0, 2.0, 4)]
        return AdjustProperties(body.name, time, *values)
    others = [b.name for b in bodies if b.collides and b.name != body.name]
    until = tuple(str(n) for n in rng.choice(others, min(2, len(others)), replace=False))
    if kind == 5:
        count = int(rng.integers(2, MAX_KNOTS + 1))
        times = (0.0, *np.cumsum(rng.uniform(0.1, 0.3, count - 1)).tolist())
        points = (np.array(body.position) + rng.uniform(-0.3, 0.3, (count, 3))).tolist()
        ways = rng.uniform(-1.0, 1.0, (count, 3)).tolist()
        turn = float(rng.uniform(-2.0, 2.0))
        return GuideAlong(body.name, time, times, _tuples(points), _tuples(ways), turn, until)
    if kind == 4:
        axis = _tuples(rng.normal(size=(1, 3)).tolist())[0]
        return HoldSpin(body.name, time, time + 0.3, vector[0], axis, until)
    return HoldVelocity(
        body.name,
        time,
        math.inf if rng.random() < 0.5 else time + float(rng.uniform(0.05, 0.6)),
        float(rng.uniform(0.5, 5.0)),
        float(rng.uniform(-math.pi, math.pi)),
        float(rng.uniform(-3.0, 3.0)),
        float(rng.uniform(3.0, 8.0)),
        float(rng.choice([0.0, rng.uniform(-2.0, 2.0)])),
        float(rng.choice([0.0, 0.2])),
        until if rng.random() < 0.7 else (),
    )
