"""What a class says about its constraints, and what joints that means to an engine."""

from __future__ import annotations

import ctypes as C
from dataclasses import replace
import math
from typing import Any

import numpy as np

from esg.compile import frames
from esg.compile.joints import UNLIMITED
from esg.compile.records import ReplayError, of_single, snapped
from esg.engines.joint_rules import BREAK_WINDOW_S
from esg.engines.joints import WORLD, Joint, JointKind, Motor
from esg.units import quat_inverse, quat_multiply, quat_rotate

_FREE, _LIMITED, _LOCKED = 0, 1, 2
_KINDS: dict[tuple[tuple[int, ...], tuple[int, ...]], JointKind] = {
    ((_LOCKED,) * 3, (_FREE, _LOCKED, _LOCKED)): "hinge",
    ((_LOCKED,) * 3, (_LIMITED, _LOCKED, _LOCKED)): "hinge",
    ((_FREE, _LOCKED, _LOCKED), (_LOCKED,) * 3): "slider",
    ((_LIMITED, _LOCKED, _LOCKED), (_LOCKED,) * 3): "slider",
    ((_LOCKED,) * 3, (_FREE,) * 3): "ball",
    ((_LOCKED,) * 3, (_FREE, _LIMITED, _LIMITED)): "ball",
    ((_LOCKED,) * 3, (_LOCKED,) * 3): "fixed",
    ((_LIMITED,) * 3, (_FREE,) * 3): "rope",
    # It holds nothing; the class itself draws its ends together.
    ((_FREE,) * 3, (_FREE,) * 3): "spring",
}
"""Kinds of joint by the linear motions of a constraint, and its twist and swings."""


class ConstraintRecord(C.Structure):
    """One constraint as the shim reports it (Shim::FConstraint)."""

    _fields_ = [
        ("name", C.c_char_p),
        ("first", C.c_int),
        ("second", C.c_int),
        ("location", (C.c_double * 3) * 2),
        ("rotation", (C.c_double * 4) * 2),
        ("linear", C.c_int * 3),
        ("linear_limit", C.c_double * 3),
        ("angular", C.c_int * 3),
        ("angular_limit", C.c_double * 3),
        ("collides", C.c_int),
        ("break_force", C.c_double),
        ("draws_back", C.c_int),
        ("stiffness", C.c_double),
        ("damping", C.c_double),
    ]


def joints_of(
    records: list[ConstraintRecord], body: dict[int, tuple[str, Any]]
) -> tuple[tuple[Joint, ...], dict[int, int]]:
    """The joints that a class describes.

    Args:
        records: Its constraints.
        body: By component, the body's name and what leads from its centre of mass to its origin
            [m], shape [3].

    Returns:
        The joints, and which one each constraint that is a joint of its own is.

    Raises:
        ReplayError: For a constraint that no joint is.
    """
    out: list[Joint] = []
    index: dict[int, int] = {}
    for i, record in enumerate(records):
        if record.draws_back:
            continue
        index[i] = len(out)
        out.append(_joint(record, body))
    for record in (r for r in records if r.draws_back):
        back = _joint(record, body)
        k = next((k for k, joint in enumerate(out) if _same_pair(joint, back)), None)
        if k is None:
            raise ReplayError(f"{back.name} draws back what no other constraint joins")
        out[k] = _drawn_back(out[k], back, record)
    return tuple(out), index


def motor_of(kind: JointKind, acts: bool, speed: float, limit: float) -> Motor:
    """The drive that a class sets, in the engine's units.

    Args:
        kind: Of the joint.
        acts: Whether it drives at all.
        speed: [turns/s or cm/s].
        limit: [kg cm^2/s^2 or kg cm/s^2].
    """
    if not acts:
        return Motor(0.0, None, 0.0)
    most = math.inf if limit >= UNLIMITED else of_single(limit)
    if kind == "slider":
        return Motor(speed / frames.CM_PER_M, None, most / frames.CM_PER_M)
    return Motor(-2.0 * math.pi * speed, None, most / frames.CM2_PER_M2)


def _joint(record: ConstraintRecord, body: dict[int, tuple[str, Any]]) -> Joint:
    name = record.name.decode()
    kind = _KINDS.get((tuple(record.linear), tuple(record.angular)))
    if kind is None:
        raise ReplayError(f"{name} leaves free what no joint does, which is not replayed")
    child, offset = body[record.first]
    parent, base = body[record.second] if record.second >= 0 else (WORLD, np.zeros(3))
    out = Joint(
        name,
        kind,
        child,
        parent,
        parent_anchor=snapped(frames.vector_from_unreal(record.location[1][0:3]) + base),
        child_anchor=snapped(frames.vector_from_unreal(record.location[0][0:3]) + offset),
        parent_rotation=_quat(record.rotation[1][0:4]),
        child_rotation=_quat(record.rotation[0][0:4]),
        collide=bool(record.collides),
    )
    if record.break_force >= 0.0:
        strength = of_single(record.break_force) * BREAK_WINDOW_S / frames.CM_PER_M
        out = replace(out, break_impulse=strength)
    reach = of_single(record.linear_limit[0]) / frames.CM_PER_M
    turn = math.radians(of_single(record.angular_limit[0]))
    if kind == "rope":
        return replace(out, upper=reach)
    if kind == "spring":
        return replace(out, upper=0.0)
    if kind == "hinge" and record.angular[0] == _LIMITED:
        return replace(out, lower=-turn, upper=turn)
    if kind == "slider" and record.linear[0] == _LIMITED:
        return replace(out, lower=-reach, upper=reach)
    if kind == "ball" and record.angular[1] == _LIMITED:
        return replace(out, upper=math.radians(of_single(record.angular_limit[1])))
    return out


def _same_pair(joint: Joint, back: Joint) -> bool:
    if joint.kind not in ("hinge", "slider", "ball"):
        return False
    own = (joint.child, joint.parent, joint.child_anchor, joint.child_rotation)
    return own == (back.child, back.parent, back.child_anchor, back.child_rotation)


def _drawn_back(joint: Joint, back: Joint, record: ConstraintRecord) -> Joint:
    """A joint with the stiffness and the zero of the constraint that draws it back."""
    unit = 1.0 if joint.kind == "slider" else frames.CM2_PER_M2
    out = replace(
        joint,
        parent_anchor=back.parent_anchor,
        parent_rotation=back.parent_rotation,
        stiffness=of_single(record.stiffness) / unit,
        damping=of_single(record.damping) / unit,
    )
    if joint.lower is None or joint.upper is None:
        return out
    inverse = quat_inverse(np.array(back.parent_rotation))
    if joint.kind == "slider":
        shift = np.array(joint.parent_anchor) - np.array(back.parent_anchor)
        middle = float(quat_rotate(inverse, shift)[0])
    else:
        turn = quat_multiply(inverse, np.array(joint.parent_rotation))
        middle = 2.0 * math.atan2(float(turn[0]), float(turn[3]))
    return replace(out, lower=joint.lower + middle, upper=joint.upper + middle)


def _quat(rotation: Any) -> tuple[float, float, float, float]:
    x, y, z, w = frames.quaternion_to_unreal(rotation).tolist()
    return x, y, z, w
