"""A solved scene with one variable changed and nothing else.

What "one variable" touches stands in docs/dataset/whatifs.md; `tests/dataset/test_whatifs.py` holds
every change against the differences of the two manifests.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
import math

import numpy as np

from esg.dataset.whatifs.amounts import VARIABLES, Amount, Variable, amounts, picked
from esg.engines.program import (
    AdjustProperties,
    ApplyImpulse,
    BuoyUp,
    DriveJoint,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Primitive,
    Program,
    SetVelocity,
    Vec,
)
from esg.engines.scene import FRAGMENT, Body, SimScene
from esg.units import quat_from_euler_deg, quat_multiply

UNCHANGED = "none"
"""The variable of a scene in which nothing is changed: the base of every pair."""

_LEAST_SPEED_MPS = 0.05
"""What starts slower than this has no speed and no direction to change."""


class NotApplicable(Exception):
    """A scene in which a variable cannot be changed; the text says why."""


@dataclass(frozen=True)
class World:
    """One scene to replay.

    Args:
        variable: What was changed; `UNCHANGED`: nothing.
        amount: Name of the change; empty without one.
        body: Whose it is; empty: the whole scene's.
        before, after: Value of the variable: mass [kg], factor on friction, speed [m/s],
            gravity [m/s^2], heading [deg]; None where it has none.
        unit: Of both.
        scene, program: What is replayed.
        mass_scale: Factor on mass and inertia of `body`.
        friction_scale: Factor on the friction of everything.
        duration: How long it is replayed [s].
    """

    variable: str
    amount: str
    body: str
    before: float | None
    after: float | None
    unit: str
    scene: SimScene
    program: Program
    mass_scale: float = 1.0
    friction_scale: float = 1.0
    duration: float = 0.0


@dataclass(frozen=True)
class Part:
    """What a change is made from.

    Args:
        scene, program: The solved scene.
        part: Names of the bodies that take part in its events, in their order.
        seed: Of every choice.
    """

    scene: SimScene
    program: Program
    part: tuple[str, ...]
    seed: str


def unchanged(scene: SimScene, program: Program) -> World:
    """The base of every pair."""
    return World(UNCHANGED, "", "", None, None, "", scene, program, duration=program.duration)


def changed(part: Part, variable: Variable) -> World:
    """The scene with one variable changed by an amount, and of a body, that the seed picks.

    Raises:
        NotApplicable: If nothing in the scene has such a variable.
    """
    amount = picked(amounts()[variable], part.seed, variable, "amount")
    return changed_by(part, amount)


def changed_by(part: Part, amount: Amount) -> World:
    """The scene with one variable changed by a given amount.

    Raises:
        NotApplicable: If nothing in the scene has such a variable.
    """
    return _CHANGES[amount.variable](part, amount)


def _mass(part: Part, amount: Amount) -> World:
    body = _picked_body(part, amount, _can_move, "nothing that takes part can move")
    mass = body.mass
    return _world(part, amount, body.name, mass, mass * amount.value, "kg", mass_scale=amount.value)


def _friction(part: Part, amount: Amount) -> World:
    program = _with_grip(part, amount.value)
    return _world(
        part, amount, "", 1.0, amount.value, "1", program=program, friction_scale=amount.value
    )


def _gravity(part: Part, amount: Amount) -> World:
    before = -part.scene.gravity[2]
    program = _with_grip(part, amount.value / before)
    scene = replace(part.scene, gravity=(*part.scene.gravity[:2], -amount.value))
    return _world(part, amount, "", before, amount.value, "m/s^2", scene=scene, program=program)


def _speed(part: Part, amount: Amount) -> World:
    starts = start_speeds(part.scene, part.program)
    body = _picked_body(part, amount, lambda b: b.name in starts, "nothing starts with a speed")
    before = float(np.linalg.norm(starts[body.name]))
    program = _mapped(part.program, body.name, lambda p: _faster(p, amount.value))
    longer = part.program.duration / min(1.0, amount.value)
    return _world(
        part, amount, body.name, before, before * amount.value, "m/s", program=program,
        duration=longer,
    )  # fmt: skip


def _direction(part: Part, amount: Amount) -> World:
    starts = {
        name: v
        for name, v in start_speeds(part.scene, part.program).items()
        if math.hypot(v[0], v[1]) >= _LEAST_SPEED_MPS
    }
    held = {name for j in part.scene.joints for name in (j.parent, j.child)}

    def free(body: Body) -> bool:
        return body.name in starts and body.name not in held

    body = _picked_body(part, amount, free, "nothing that is free starts in a direction")
    v = starts[body.name]
    before = math.degrees(math.atan2(v[1], v[0]))
    turn = quat_from_euler_deg(amount.value)
    turned = replace(body, quaternion=_four(quat_multiply(turn, np.array(body.quaternion, float))))
    scene = part.scene.with_bodies(
        tuple(turned if b.name == body.name else b for b in part.scene.bodies)
    )
    program = _mapped(part.program, body.name, lambda p: _turned(p, amount.value, body.position))
    return _world(
        part, amount, body.name, before, _heading(before + amount.value), "deg", scene=scene,
        program=program,
    )  # fmt: skip


def _remove(part: Part, amount: Amount) -> World:
    driven = {p.body for p in part.program.primitives}
    body = _picked_body(
        part,
        amount,
        lambda b: b.collides and b.name not in driven,
        "nothing takes part but what moves by itself",
    )
    gone = {body.name, *body.fragments}
    scene = replace(
        part.scene,
        bodies=tuple(_taken_away(b) if b.name in gone else b for b in part.scene.bodies),
        regions=tuple(r for r in part.scene.regions if r.parent not in gone),
        joints=tuple(j for j in part.scene.joints if not gone & {j.parent, j.child}),
    )
    joints = {j.name for j in scene.joints}
    left = tuple(
        p
        for p in part.program.primitives
        if (p.joint in joints if isinstance(p, DriveJoint) else p.body not in gone)
    )
    program = Program(left, part.program.duration)
    return _world(part, amount, body.name, 1.0, 0.0, "1", scene=scene, program=program)


_CHANGES: dict[Variable, Callable[[Part, Amount], World]] = {
    "mass": _mass,
    "friction": _friction,
    "speed": _speed,
    "gravity": _gravity,
    "remove": _remove,
    "direction": _direction,
}
assert tuple(_CHANGES) == VARIABLES


def _world(
    part: Part,
    amount: Amount,
    body: str,
    before: float,
    after: float,
    unit: str,
    *,
    scene: SimScene | None = None,
    program: Program | None = None,
    mass_scale: float = 1.0,
    friction_scale: float = 1.0,
    duration: float | None = None,
) -> World:
    return World(
        amount.variable, amount.amount, body, before, after, unit,
        part.scene if scene is None else scene,
        part.program if program is None else program,
        mass_scale, friction_scale,
        part.program.duration if duration is None else duration,
    )  # fmt: skip


def _picked_body(part: Part, amount: Amount, fits: Callable[[Body], bool], otherwise: str) -> Body:
    bodies = {b.name: b for b in part.scene.bodies}
    choices = [bodies[n] for n in part.part if n in bodies and fits(bodies[n])]
    if not choices:
        raise NotApplicable(otherwise)
    return picked(choices, part.seed, amount.variable, "body")


def _can_move(body: Body) -> bool:
    return body.collides and not body.static and body.category != FRAGMENT


def _taken_away(body: Body) -> Body:
    """A body that is no longer there: its number stays, nothing touches it, nothing moves it."""
    return replace(body, static=True, shapes=(), break_impulse=None, fragments=())


def start_speeds(scene: SimScene, program: Program) -> dict[str, Vec]:
    """Velocity [m/s] that the program first gives to every body that it sends off."""
    out: dict[str, Vec] = {}
    mass = {b.name: b.mass for b in scene.bodies}
    for p in program.primitives:
        v = _sent_off(p, mass)
        if v is not None and math.hypot(*v) >= _LEAST_SPEED_MPS:
            out.setdefault(p.body, v)
    return out


def _sent_off(p: Primitive, mass: dict[str, float]) -> Vec | None:
    if isinstance(p, SetVelocity):
        return p.linear
    if isinstance(p, ApplyImpulse):
        x, y, z = p.impulse
        m = mass[p.body]
        return x / m, y / m, z / m
    if isinstance(p, HoldVelocity):
        speed = max(p.speed, p.max_speed if p.acceleration > 0.0 and p.speed <= 0.0 else p.speed)
        return speed * math.cos(p.heading), speed * math.sin(p.heading), p.climb or 0.0
    if isinstance(p, GuideAlong):
        return max(p.velocities, key=lambda v: math.hypot(*v))
    return None


def _mapped(program: Program, body: str, change: Callable[[Primitive], Primitive]) -> Program:
    return Program(
        tuple(change(p) if p.body == body else p for p in program.primitives), program.duration
    )


def _faster(p: Primitive, f: float) -> Primitive:
    if isinstance(p, SetVelocity):
        spin = None if p.angular is None else _times(p.angular, f)
        return replace(p, linear=_times(p.linear, f), angular=spin)
    if isinstance(p, ApplyImpulse):
        return replace(p, impulse=_times(p.impulse, f))
    if isinstance(p, HoldVelocity):
        climb = None if p.climb is None else p.climb * f
        return replace(p, speed=p.speed * f, max_speed=p.max_speed * f, climb=climb)
    if isinstance(p, GuideAlong):
        return replace(
            p,
            times=tuple(t / f for t in p.times),
            velocities=tuple(_times(v, f) for v in p.velocities),
            turn_rate=p.turn_rate * f,
        )
    return p


def _turned(p: Primitive, degrees: float, about: Vec) -> Primitive:
    def turn(v: Sequence[float]) -> Vec:
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        return c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]

    def place(x: Vec) -> Vec:
        moved = turn((x[0] - about[0], x[1] - about[1], x[2]))
        return about[0] + moved[0], about[1] + moved[1], moved[2]

    if isinstance(p, SetVelocity):
        spin = None if p.angular is None else turn(p.angular)
        return replace(p, linear=turn(p.linear), angular=spin)
    if isinstance(p, ApplyImpulse):
        return replace(p, impulse=turn(p.impulse))
    if isinstance(p, HoldVelocity):
        return replace(p, heading=p.heading + math.radians(degrees))
    if isinstance(p, GuideAlong):
        return replace(
            p,
            points=tuple(place(x) for x in p.points),
            velocities=tuple(turn(v) for v in p.velocities),
        )
    if isinstance(p, HoldSpin):
        return replace(p, axis=turn(p.axis))
    if isinstance(p, BuoyUp):
        return replace(p, center=place(p.center), heading=p.heading + math.radians(degrees))
    return p


def _with_grip(part: Part, factor: float) -> Program:
    """The program where everything grips by another factor: brakes slow down by so much more or
    less, since what they push against is friction times weight.

    Raises:
        NotApplicable: If something accelerates or turns by friction: the program prescribes that
            motion, so a replay would show it on ice, too.
    """
    out: list[Primitive] = []
    for p in part.program.primitives:
        if isinstance(p, AdjustProperties) and p.braking is not None:
            p = replace(p, braking=p.braking * factor)
        elif isinstance(p, HoldVelocity) and p.climb is None:
            if factor < 1.0 and (p.turn_rate != 0.0 or p.acceleration != 0.0):
                raise NotApplicable(f"{p.body} turns or speeds up by itself, which needs its grip")
            if p.gains is not None and p.loses is not None:
                p = replace(p, gains=p.gains * factor, loses=p.loses * factor)
        out.append(p)
    return Program(tuple(out), part.program.duration)


def _heading(degrees: float) -> float:
    """The same direction between -180 and 180 degrees."""
    return (degrees + 180.0) % 360.0 - 180.0


def _times(v: Vec, f: float) -> Vec:
    return v[0] * f, v[1] * f, v[2] * f


def _four(q: np.ndarray) -> tuple[float, float, float, float]:
    x, y, z, w = (float(v) for v in q)
    return x, y, z, w


def taken_away(world: World) -> frozenset[str]:
    """Names of the bodies that are no longer there."""
    return frozenset((world.body,) if world.variable == "remove" else ())
