"""What the emitter writes, already in Unreal's frame and units: cm, kg, s, degrees, left-handed.

`plan` is the only place where SI values of a SimScene and its Program become Unreal values; the
text modules (header, source) format what they find here and compute nothing.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.compile import frames, names
from esg.compile.assets import MeshAsset, mesh_assets
from esg.compile.joints import UnrealJoint, joint_key, motor_values, plan_joints
from esg.engines.joints import Joint, Motor
from esg.engines.program import (
    AdjustProperties,
    ApplyImpulse,
    BuoyUp,
    ChangeBody,
    DriveJoint,
    GuideAlong,
    HoldSpin,
    Lasting,
    Program,
    SetVelocity,
    Vec,
    redirected,
)
from esg.engines.scene import GROUND, Body, SimScene, Wheel
from esg.engines.worlds import principal_axes
from esg.units import quat_from_euler_deg, quat_rotate

Floats = NDArray[np.float64]
OfBody = SetVelocity | ApplyImpulse | AdjustProperties | ChangeBody | Lasting
"""Primitives that act on a body."""

UNLIMITED = 1.0e9
"""Unreal properties have no infinity: the end [s] of a hold that only a touch ends, the limit
[cm/s] of a ramp without one."""

GROUNDS = ("GroundPlane", "VehicleGroundPlane")
"""Members of the two ground components: of ordinary bodies, of bodies on wheels."""

CLASS_PREFIX = "EsgScene"
MESH = "Mesh"
"""Suffix of the members that point to components."""


@dataclass(frozen=True)
class WatchedEvent:
    """A contact the class reports: any of `a` hits any of `b`.

    Args:
        id: Identifier of the event.
        a, b: Body names; `ground` is allowed.
        after: Ids of watched events that must be complete first.
    """

    id: str
    a: tuple[str, ...]
    b: tuple[str, ...]
    after: tuple[str, ...] = ()


@dataclass(frozen=True)
class UnrealWheel:
    """A component that turns on a body's: a picture without collision.

    Args:
        name: Identifier of the component.
        node: Of the mesh that it is a part of.
        path: Unreal object path of its own mesh.
        axle: In the body component's frame [cm], shape [3].
        radius: [cm].
    """

    name: str
    node: str
    path: str
    axle: Floats
    radius: float

    @property
    def member(self) -> str:
        """The class member that points to the component."""
        return self.name + MESH

    @property
    def settings(self) -> str:
        """The class member that holds its settings."""
        return self.name + "Settings"


@dataclass(frozen=True)
class UnrealBody:
    """One component and its settings.

    Args:
        name: Identifier of the component.
        source: The body it comes from.
        asset: Its mesh.
        location: Of the asset's local origin [cm], shape [3].
        rotation: (x, y, z, w).
        center_of_mass: In the component's frame [cm], shape [3].
        principal_axes: Rotation of the principal axes of inertia in the component's frame.
        inertia: Principal moments [kg cm^2], shape [3].
        index: Position in the scene.
        wheels: What turns on it.
    """

    name: str
    source: Body
    asset: MeshAsset
    location: Floats
    rotation: Floats
    center_of_mass: Floats
    principal_axes: Floats
    inertia: Floats
    index: int
    wheels: tuple[UnrealWheel, ...] = ()

    @property
    def member(self) -> str:
        """The class member that points to the component."""
        return self.name + MESH

    @property
    def settings(self) -> str:
        """The class member that holds its settings."""
        return self.name + "Settings"

    @property
    def simulated(self) -> bool:
        """Whether the engine moves it."""
        return not self.source.static and self.source.collides


@dataclass(frozen=True)
class UnrealPrimitive:
    """One primitive: the member that holds its numbers, and those numbers as (field, literal).

    `body` is what it acts on: the member of a component, or the joint in the class's list.
    """

    member: str
    kind: str
    body: str
    values: tuple[tuple[str, str], ...]
    until: tuple[str, ...] = ()


@dataclass(frozen=True)
class UnrealEvent:
    """One watched contact.

    Args:
        name: Identifier, unique.
        id: The event's own id, for the log.
        first, second: Component members; any of `first` hitting any of `second` counts.
        after: Indices of events that must be complete at least the gap before.
    """

    name: str
    id: str
    first: tuple[str, ...]
    second: tuple[str, ...]
    after: tuple[int, ...]


@dataclass(frozen=True)
class ScenePlan:
    """Everything the two files of a class say."""

    name: str
    title: str
    bodies: tuple[UnrealBody, ...]
    assets: tuple[MeshAsset, ...]
    primitives: tuple[UnrealPrimitive, ...]
    events: tuple[UnrealEvent, ...]
    notified: frozenset[str]
    gravity_z: float
    ground_friction: float
    ground_restitution: float
    vehicle_ground_friction: float
    time_step: float
    duration: float
    joints: tuple[UnrealJoint, ...] = ()

    @property
    def wheels(self) -> tuple[tuple[UnrealBody, UnrealWheel], ...]:
        """All wheels with their bodies; classes without any say nothing of them."""
        return tuple((b, w) for b in self.bodies for w in b.wheels)

    @property
    def brakes(self) -> bool:
        """Whether the program uses brakes; classes without them say nothing of it."""
        return any(field == "bSetBraking" for p in self.primitives for field, _ in p.values)

    @property
    def tyres(self) -> bool:
        """Whether bodies stand on tyres; classes without them say nothing of it."""
        return any(b.simulated and b.source.tyre_friction > 0.0 for b in self.bodies)


def class_name(scene_id: str) -> str:
    """Name of the class and its files, without Unreal's leading A."""
    return CLASS_PREFIX + "_" + names.identifier(scene_id, "Scene")


def plan(
    scene: SimScene, program: Program, watch: tuple[WatchedEvent, ...], dt: float
) -> ScenePlan:
    """Turns a scene, its program and its watch list into Unreal values.

    Args:
        scene: Bodies and materials (SI).
        program: What drives them.
        watch: Contacts to report.
        dt: Step the scene is verified with [s].

    Raises:
        ValueError: For names the scene lacks, a gravity that is not vertical, or non-finite values.
    """
    if scene.gravity[0] or scene.gravity[1]:
        raise ValueError(f"gravity {scene.gravity}: Unreal's world gravity has a Z component only")
    name = class_name(scene.scene_id)
    wheels = [_wheel_key(b, w) for b in scene.bodies for w in b.wheels]
    joints = map(joint_key, scene.joints)
    idents = names.unique_identifiers((*scene.names, *wheels, *joints))
    assets = mesh_assets(scene, f"/Game/ESG/{name.removeprefix(CLASS_PREFIX + '_')}")
    bodies = tuple(_body(i, body, idents, assets[i]) for i, body in enumerate(scene.bodies))
    primitives = _primitives(program, idents, scene)
    own = {b.name: (b.name, *b.postures) for b in scene.bodies}
    events = _events(tuple(_of_all_postures(e, own) for e in watch), idents)
    notified = {n for e in events for n in e.first}
    notified |= {p.body for p in primitives if p.until}
    notified |= {b.member for b in bodies if b.source.fragments}
    unique_assets = tuple(dict.fromkeys(assets))
    return ScenePlan(
        name=name,
        title=names.comment(scene.scene_id),
        bodies=bodies,
        assets=unique_assets,
        primitives=primitives,
        events=events,
        notified=frozenset(notified),
        gravity_z=scene.gravity[2] * frames.CM_PER_M,
        ground_friction=scene.ground_friction,
        ground_restitution=scene.ground_restitution,
        vehicle_ground_friction=scene.vehicle_ground_friction,
        time_step=dt,
        duration=program.duration,
        joints=plan_joints(scene, idents, {b.source.name: b.member for b in bodies}),
    )


def _wheel_key(body: Body, wheel: Wheel) -> str:
    """Stands for a wheel among the names of a scene's components; no body is called so."""
    return f"{body.name}\0{wheel.name}"


def _wheels(body: Body, idents: dict[str, str], asset: MeshAsset) -> tuple[UnrealWheel, ...]:
    offset = np.asarray(body.origin_offset, float)
    parts = names.unique_identifiers((w.name for w in body.wheels), "Wheel")
    stem = asset.path.rpartition(".")[2]
    return tuple(
        UnrealWheel(
            name=idents[_wheel_key(body, w)],
            node=w.name,
            path=f"{asset.path.rpartition('.')[0]}_{parts[w.name]}.{stem}_{parts[w.name]}",
            axle=frames.vector_to_unreal(np.asarray(w.axle, float) - offset),
            radius=w.radius * frames.CM_PER_M,
        )
        for w in body.wheels
    )


def _body(index: int, body: Body, idents: dict[str, str], asset: MeshAsset) -> UnrealBody:
    offset = np.asarray(body.origin_offset, float)
    origin = np.asarray(body.position, float) + quat_rotate(body.quaternion, offset)
    moments, axes = principal_axes(np.asarray(body.inertia, float))
    return UnrealBody(
        name=idents[body.name],
        source=body,
        asset=asset,
        location=frames.vector_to_unreal(origin),
        rotation=frames.quaternion_to_unreal(body.quaternion),
        center_of_mass=frames.vector_to_unreal(-offset),
        principal_axes=frames.quaternion_to_unreal(axes),
        inertia=moments * frames.CM2_PER_M2,
        index=index,
        wheels=_wheels(body, idents, asset),
    )


def _known(idents: dict[str, str], name: str, what: str) -> str:
    if name not in idents:
        raise ValueError(f"{what} names unknown body {name!r}; bodies are {list(idents)}")
    return idents[name] + MESH


def _primitives(
    program: Program, idents: dict[str, str], scene: SimScene
) -> tuple[UnrealPrimitive, ...]:
    joints, order = scene.joints, {name: k for k, name in enumerate(scene.names)}
    numbers = {j.name: k for k, j in enumerate(joints)}
    counts: dict[tuple[str, str], int] = {}
    members: set[str] = {i.lower() for i in idents.values()}
    out: list[UnrealPrimitive] = []
    for p in redirected(program, order):
        if isinstance(p, DriveJoint):
            if p.joint not in numbers:
                raise ValueError(f"{p.kind} names unknown joint {p.joint!r}")
            joint = joints[numbers[p.joint]]
            name, target = idents[joint_key(joint)], f"Joints[{numbers[p.joint]}]"
            values = _drive(p, joint)
        else:
            target = _known(idents, p.body, p.kind)
            name, values = target.removesuffix(MESH), _values(p)
            if isinstance(p, ChangeBody):
                values += (("Into", str(order[p.into])), *_place(p, scene))
        stem = {
            "SetVelocity": "Launch",
            "ApplyImpulse": "Impulse",
            "AdjustProperties": "Change",
            "DriveJoint": "Motor",
            "ChangeBody": "Posture",
            "HoldVelocity": "Drive",
            "GuideAlong": "Guide",
            "HoldSpin": "Spin",
            "BuoyUp": "Liquid",
        }[p.kind]
        while True:
            number = counts[name, stem] = counts.get((name, stem), 0) + 1
            member = f"{name}{stem}{number}"
            if member.lower() not in members:
                break
        members.add(member.lower())
        until: tuple[str, ...] = ()
        if isinstance(p, Lasting):
            until = tuple(_known(idents, n, f"hold of {p.body!r}") for n in p.until_contact)
        out.append(UnrealPrimitive(member, p.kind, target, values, until))
    return tuple(out)


def _of_all_postures(event: WatchedEvent, own: dict[str, tuple[str, ...]]) -> WatchedEvent:
    """A contact of bodies whatever their posture."""
    a, b = (tuple(n for name in of for n in own.get(name, (name,))) for of in (event.a, event.b))
    return replace(event, a=a, b=b)


def _place(p: ChangeBody, scene: SimScene) -> tuple[tuple[str, str], ...]:
    """Where the component of a body is that comes to a place; nothing where it stays."""
    if p.position is None:
        return ()
    turn = quat_from_euler_deg(math.degrees(p.heading))
    at = np.array(p.position) + quat_rotate(turn, np.array(scene.body(p.body).origin_offset))
    return (
        ("bPlaced", "true"),
        ("Place", frames.vector_literal(frames.vector_to_unreal(at))),
        ("Facing", frames.quaternion_literal(frames.quaternion_to_unreal(tuple(turn)))),
    )


def _drive(p: DriveJoint, joint: Joint) -> tuple[tuple[str, str], ...]:
    motor = None
    if p.speed is not None or p.position is not None:
        motor = Motor(p.speed or 0.0, p.position, p.limit)
    return ("Time", frames.literal(p.time)), *motor_values(joint.kind, motor, "bDrives")


def _values(p: OfBody) -> tuple[tuple[str, str], ...]:
    if isinstance(p, SetVelocity):
        values = [
            ("Time", frames.literal(p.time)),
            ("Velocity", _vector(p.linear)),
        ]
        if p.angular is not None:
            spin = frames.vector_literal(frames.angular_to_unreal(p.angular))
            values += [("bSetSpin", "true"), ("Spin", spin)]
        return tuple(values)
    if isinstance(p, ApplyImpulse):
        return (
            ("Time", frames.literal(p.time)),
            ("Impulse", _vector(p.impulse)),
        )
    if isinstance(p, ChangeBody):
        return (("Time", frames.literal(p.time)),)
    if isinstance(p, AdjustProperties):
        values = [("Time", frames.literal(p.time))]
        for flag, field, value in (
            ("bSetLinearDamping", "LinearDamping", p.linear_damping),
            ("bSetAngularDamping", "AngularDamping", p.angular_damping),
            ("bSetFriction", "Friction", p.friction),
        ):
            if value is not None:
                values += [(flag, "true"), (field, frames.float_literal(value))]
        if p.braking is not None:
            braking = frames.literal(p.braking * frames.CM_PER_M)
            values += [("bSetBraking", "true"), ("Braking", braking)]
        return tuple(values)
    span = (
        ("Start", frames.literal(p.start)),
        ("End", frames.literal(min(p.end, UNLIMITED))),
    )
    if isinstance(p, GuideAlong):
        return (
            *span,
            ("TurnRate", frames.literal(frames.heading_to_unreal(p.turn_rate))),
            ("Times", _list(frames.literal(t) for t in p.times)),
            ("Points", _list(_vector(x) for x in p.points)),
            ("Velocities", _list(_vector(v) for v in p.velocities)),
        )
    if isinstance(p, HoldSpin):
        return (*span, ("Spin", frames.vector_literal(frames.angular_to_unreal(p.spin))))
    if isinstance(p, BuoyUp):
        return *span, *_liquid(p)
    limit = min(p.max_speed * frames.CM_PER_M, UNLIMITED)
    more: list[tuple[str, str]] = []
    if p.climb is not None:
        more = [("bFlies", "true"), ("Climb", frames.literal(p.climb * frames.CM_PER_M))]
    if p.gains is not None and p.loses is not None:
        more += [
            ("bTakesTime", "true"),
            ("Gains", frames.literal(p.gains * frames.CM_PER_M)),
            ("Loses", frames.literal(p.loses * frames.CM_PER_M)),
        ]
    return (
        *span,
        ("Speed", frames.literal(p.speed * frames.CM_PER_M)),
        ("Heading", frames.literal(frames.heading_to_unreal(p.heading))),
        ("Acceleration", frames.literal(p.acceleration * frames.CM_PER_M)),
        ("MaxSpeed", frames.literal(limit)),
        ("TurnRate", frames.literal(frames.heading_to_unreal(p.turn_rate))),
        ("RollRadius", frames.literal(p.roll_radius * frames.CM_PER_M)),
        *more,
    )


def _liquid(p: BuoyUp) -> tuple[tuple[str, str], ...]:
    basin, extents = (tuple(frames.CM_PER_M * a for a in v) for v in (p.basin, p.extents))
    return (
        ("Center", _vector(p.center)),
        ("Basin", frames.vector_literal(basin)),
        ("Extents", frames.vector_literal(extents)),
        ("Heading", frames.literal(frames.heading_to_unreal(p.heading))),
        ("Lift", frames.literal(p.lift * frames.CM_PER_M)),
        ("LinearDrag", frames.literal(p.linear_drag)),
        ("QuadraticDrag", frames.literal(p.quadratic_drag / frames.CM_PER_M)),
        ("TurningDrag", frames.literal(p.turning_drag)),
        ("bRound", "true" if p.round else "false"),
    )


def _vector(v: Vec) -> str:
    return frames.vector_literal(frames.vector_to_unreal(v))


def _list(values: Iterable[str]) -> str:
    return f"{{ {', '.join(values)} }}"


def _events(watch: tuple[WatchedEvent, ...], idents: dict[str, str]) -> tuple[UnrealEvent, ...]:
    ids = [w.id for w in watch]
    event_names = names.unique_identifiers(ids, "Event")
    out: list[UnrealEvent] = []
    for w in watch:
        what = f"event {w.id!r}"
        unknown = [a for a in w.after if a not in ids]
        if unknown:
            raise ValueError(f"{what} comes after unknown events {unknown}; events are {ids}")
        first, second = _side(w.a, idents, what), _side(w.b, idents, what)
        if first == GROUNDS:
            first, second = second, first
        after = tuple(ids.index(a) for a in w.after)
        out.append(UnrealEvent(event_names[w.id], w.id, first, second, after))
    return tuple(out)


def _side(bodies: tuple[str, ...], idents: dict[str, str], what: str) -> tuple[str, ...]:
    if bodies == (GROUND,):
        return GROUNDS
    return tuple(_known(idents, n, what) for n in bodies)
