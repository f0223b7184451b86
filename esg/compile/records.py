"""What a class says about its bodies, and what that means to an engine."""

from __future__ import annotations

import ctypes as C
import math
from typing import Any

import numpy as np

from esg.compile import frames
from esg.engines.scene import Body, Shape
from esg.units import quat_rotate

CUBE_ASSET = "/Engine/BasicShapes/Cube.Cube"
CUBE_HALF_CM = 50.0
GROUND_HALF_MIN_CM = 10000.0
"""A static cube at least this wide with its top at height 0 is played as the half-space z <= 0,
whose contacts do not suffer from the size of the cube in single precision."""

RECOVERED_DIGITS = 12
"""Decimals [m] kept of values that come back from Unreal's units: the text has 15 significant
digits, so anything below is rounding, which would turn an exact 0 into 1e-17."""

_ECC_WORLD_STATIC, _ECC_PHYSICS_BODY, _ECC_VEHICLE = 0, 5, 6


class ReplayError(RuntimeError):
    """The class asks for something that Unreal would refuse or that the replay cannot play."""


class BodyRecord(C.Structure):
    """One body as the shim reports it (Shim::FBody)."""

    _fields_ = [
        ("name", C.c_char_p),
        ("asset", C.c_char_p),
        ("location", C.c_double * 3),
        ("rotation", C.c_double * 4),
        ("scale", C.c_double * 3),
        ("center_of_mass", C.c_double * 3),
        ("mass_rotation", C.c_double * 4),
        ("inertia", C.c_double * 3),
        ("mass", C.c_double),
        ("linear_damping", C.c_double),
        ("angular_damping", C.c_double),
        ("friction", C.c_double),
        ("restitution", C.c_double),
        ("max_spin", C.c_double),
        ("collides", C.c_int),
        ("simulates", C.c_int),
        ("object_type", C.c_int),
        ("blocks", C.c_uint32),
        ("notifies", C.c_int),
        ("ccd", C.c_int),
        ("has_mass_frame", C.c_int),
        ("has_material", C.c_int),
        ("movable", C.c_int),
        ("dormant", C.c_int),
    ]


def moves(record: BodyRecord) -> bool:
    """Whether a body moves, or will once it comes in."""
    return bool(record.simulates or record.dormant)


def snapped(values: Any) -> tuple[float, float, float]:
    """A point [m] without the rounding of its way through centimetres, shape [3]."""
    x, y, z = np.round(values, RECOVERED_DIGITS).tolist()
    return x + 0.0, y + 0.0, z + 0.0


def of_single(value: float) -> float:
    """The shortest decimal of a single precision value: the class's 0.1f is meant as 0.1.

    An engine that computes such a value in double precision then starts from the program's own.
    """
    return float(str(np.float32(value)))


def shape_of(data: dict[str, Any]) -> Shape:
    """A collision primitive of an import manifest, in the asset's frame [m]."""
    vertices = frames.vector_from_unreal(np.reshape(data.get("vertices_cm", []), (-1, 3)))
    x, y, z = (v / frames.CM_PER_M for v in data["size_cm"])
    return Shape(
        kind=data["kind"],
        size=(x, y, z),
        position=tuple(frames.vector_from_unreal(data["position_cm"]).tolist()),  # type: ignore[arg-type]
        quaternion=tuple(frames.quaternion_to_unreal(data["quaternion"]).tolist()),  # type: ignore[arg-type]
        vertices=tuple(tuple(v) for v in vertices.tolist()),
    )


def grown(half: Any, center: Any, shape: dict[str, Any]) -> tuple[Any, Any]:
    """The box that also holds a collision shape (by its bounding sphere)."""
    x, _, z = shape["size_cm"]
    if shape["kind"] == "convex":
        points = np.array(shape["vertices_cm"])
        radius = float(np.linalg.norm(points, axis=1).max())
    elif shape["kind"] == "sphere":
        radius = x
    elif shape["kind"] == "capsule":
        radius = x + z
    elif shape["kind"] == "cylinder":
        radius = math.hypot(x, z)
    else:
        radius = float(np.linalg.norm(shape["size_cm"]))
    at = np.array(shape["position_cm"])
    low = np.minimum(np.array(center) - half, at - radius)
    high = np.maximum(np.array(center) + half, at + radius)
    return ((high - low) / 2).tolist(), ((high + low) / 2).tolist()


def record_pose(record: BodyRecord) -> tuple[np.ndarray, np.ndarray]:
    """Pose of a component as the class set it: position [m] and quaternion."""
    return (
        frames.vector_from_unreal(record.location[0:3]),
        frames.quaternion_to_unreal(record.rotation[0:4]),
    )


def inertia_of(record: BodyRecord) -> Any:
    """Inertia about the centre of mass in body axes [kg m^2]; of fixed bodies the identity."""
    if not moves(record):
        return ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    axes = frames.quaternion_to_unreal(record.mass_rotation[0:4])
    columns = quat_rotate(np.tile(axes, (3, 1)), np.eye(3)).T
    moments = np.array(record.inertia[0:3]) / frames.CM2_PER_M2
    if np.array_equal(axes, [0.0, 0.0, 0.0, 1.0]):
        tensor = np.diag(moments)
    else:
        tensor = columns @ np.diag(moments) @ columns.T
    return tuple(tuple(row) for row in tensor.tolist())


def _blocks(record: BodyRecord, channel: int) -> bool:
    return bool(record.blocks & (1 << channel))


def ground_for_wheels(record: BodyRecord) -> bool:
    """Whether a ground is the one for wheels.

    Raises:
        ReplayError: If it is not a static, level, wide block with its top at height 0 that blocks
            either ordinary bodies or vehicles.
    """
    name = record.name.decode()
    half = np.array(record.scale[0:3]) * CUBE_HALF_CM
    top = record.location[2] + half[2]
    level = list(record.rotation) == [0.0, 0.0, 0.0, 1.0]
    if record.simulates or not level or abs(top) > 1e-6 or min(half[:2]) < GROUND_HALF_MIN_CM:
        raise ReplayError(f"{name} is not a static, level, wide block with its top at height 0")
    normal, wheels = _blocks(record, _ECC_PHYSICS_BODY), _blocks(record, _ECC_VEHICLE)
    if not record.collides or normal == wheels:
        raise ReplayError(f"{name} must block either ordinary bodies or vehicles")
    return wheels


def on_wheels(record: BodyRecord, name: str) -> bool:
    """Whether a body touches the vehicle ground.

    Raises:
        ReplayError: For an object type or responses the replay cannot play.
    """
    if not (record.collides or record.dormant):
        return False
    expected = (_ECC_PHYSICS_BODY, _ECC_VEHICLE) if moves(record) else (_ECC_WORLD_STATIC,)
    if record.object_type not in expected:
        raise ReplayError(f"{name} has collision object type {record.object_type}")
    deaf = [c for c in (_ECC_WORLD_STATIC, _ECC_PHYSICS_BODY, _ECC_VEHICLE)
            if not _blocks(record, c)]  # fmt: skip
    if deaf:
        raise ReplayError(f"{name} does not block collision channels {deaf}")
    return record.object_type == _ECC_VEHICLE


def body_of(record: BodyRecord, name: str, shapes: tuple[Shape, ...], offset: Any) -> Body:
    """The body an engine builds.

    Args:
        record: What the class said.
        name: The body's name in the scene.
        shapes: Collision of its asset, in the asset's frame [m].
        offset: From the centre of mass to the asset's origin, body axes [m], shape [3].

    Raises:
        ReplayError: If it is scaled, or should collide without shapes, or with strange channels.
    """
    origin, quaternion = record_pose(record)
    if tuple(record.scale) != (1.0, 1.0, 1.0):
        raise ReplayError(f"{name} is scaled, which its mass properties do not follow")
    if record.collides and not shapes:
        raise ReplayError(f"{name} should collide, but its asset has no collision shapes")
    movable = moves(record)
    x, y, z, w = (float(v) for v in quaternion)
    return Body(
        name=name,
        static=not movable,
        mass=of_single(record.mass) if movable else 0.0,
        inertia=inertia_of(record),
        shapes=tuple(
            Shape(s.kind, s.size, snapped(np.array(s.position) + offset), s.quaternion, s.vertices)
            for s in shapes
        ),
        position=snapped(origin - quat_rotate(quaternion, offset)),
        quaternion=(x, y, z, w),
        friction=of_single(record.friction),
        restitution=of_single(record.restitution),
        linear_damping=of_single(record.linear_damping) if movable else 0.0,
        angular_damping=of_single(record.angular_damping) if movable else 0.0,
        wheeled=on_wheels(record, name),
        origin_offset=snapped(offset),
    )
