"""Joints of the physical scene from those of the document: the border of the simulator (SI)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import Joint, Motor, joint_between
from esg.engines.scene import Body
from esg.graph import models
from esg.graph.joints import mount_of
from esg.graph.models import EsgDocument, Vec3
from esg.outcomes import UserError
from esg.units import m_from_cm, quat_rotate

Floats = NDArray[np.float64]


def joints_of(doc: EsgDocument, bodies: Iterable[Body]) -> tuple[Joint, ...]:
    """The joints of a laid-out document, between its bodies as they stand.

    Args:
        doc: With asset configurations.
        bodies: Of its nodes.

    Raises:
        UserError: If an asset lacks the mount that a joint names.
    """
    of = {b.name: b for b in bodies}
    return tuple(_joint(doc, j, of) for j in doc.spatial_relation_graph.joints or ())


def _joint(doc: EsgDocument, told: models.Joint, bodies: dict[str, Body]) -> Joint:
    child = bodies[told.child]
    parent = bodies[told.parent] if told.parent is not None else None
    at, mine = _mount(doc, child, told.child_mount)
    position = _si(told, told.position) or 0.0
    slid = position * mine if told.kind == "slider" else np.zeros(3)
    there, theirs = at - slid, mine
    if parent is not None and told.parent_mount is not None:
        there, theirs = _mount(doc, parent, told.parent_mount)
    joint = joint_between(
        told.id,
        told.kind,
        child,
        parent,
        at=_vec(at),
        axis=_vec(mine),
        parent_at=_vec(there + slid),
        position=position if told.kind in ("hinge", "slider") else 0.0,
    )
    if told.kind == "ball":  # its parent's axis is not turned by what hangs askew
        straight = joint_between(told.id, "ball", child, parent, at=_vec(at), axis=_vec(theirs))
        joint = replace(joint, parent_rotation=straight.parent_rotation)
    motor = told.motor
    return replace(
        joint,
        lower=_si(told, told.lower),
        upper=_si(told, told.upper),
        stiffness=told.stiffness or 0.0,
        damping=told.damping or 0.0,
        friction=told.friction or 0.0,
        motor=None
        if motor is None
        else Motor(
            _si(told, motor.speed) or 0.0,
            _si(told, motor.position),
            math.inf if motor.limit is None else motor.limit,
        ),
        break_impulse=told.break_impulse,
        collide=told.collide or False,
    )


def _si(joint: models.Joint, value: float | None) -> float | None:
    """A position of a joint or its rate in SI: an angle [rad], or a length [m]."""
    if value is None:
        return None
    return math.radians(value) if joint.kind in ("hinge", "ball") else m_from_cm(value)


def _mount(doc: EsgDocument, body: Body, name: str) -> tuple[Floats, Floats]:
    """Where a mount of a body is in the world [m], and its unit axis, each of shape [3]."""
    asset = doc.asset_configurations[doc.spatial_relation_graph.nodes[body.name].asset_id]
    mount = mount_of(asset, name)
    if mount is None:
        known = sorted(m.name for m in asset.mounts or ())
        raise UserError(
            f"{body.name}: the asset {asset.asset_name!r} has no mount {name!r}, only {known}; "
            "name one of these in the joint"
        )
    local = np.asarray(mount.position_cm) / 100.0 + np.asarray(body.origin_offset)
    turn = np.asarray(body.quaternion)
    axis = quat_rotate(turn, np.asarray(mount.axis, float))
    return np.asarray(body.position) + quat_rotate(turn, local), axis / np.linalg.norm(axis)


def _vec(v: Floats) -> Vec3:
    return float(v[0]), float(v[1]), float(v[2])
