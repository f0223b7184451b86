"""How something hangs: its way from where it is drawn back to down to its lowest point.

A pendulum let go at an angle a takes K(sin(a / 2)) sqrt(I / (m g d)) to its lowest point and
passes it at sqrt(2 m g d (1 - cos a) / I) rad/s: I its inertia about what it turns on, d the
distance of its centre of mass from there, K the complete elliptic integral of the first kind
(Abramowitz and Stegun 17.6, by the arithmetic-geometric mean).
"""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.graph.joints import (
    KINDS_OF_JOINT,
    child_frame,
    drawn_back_about,
    mount_of,
    placing_joints,
    start_frames,
)
from esg.graph.models import EdgeEvent, EsgDocument, Joint
from esg.units import GRAVITY_MPS2, quat_rotate, yaw_from_quat

AT_END = 0.85
"""Where on its half length a seesaw is landed on."""
NEAR_HINGE = 0.3
"""Where on its half length, from its middle to its hinge, a lid that stands open is landed on: what
is round meets its outer face then and not its rim."""


@dataclass(frozen=True)
class Suspension:
    """What swings down when it is let go.

    Args:
        way: Horizontal way of its origin to its lowest point [m].
        along: Direction of that way, from its own heading at the start [rad].
        time: To its lowest point [s].
        speed: Of its centre of mass there [m/s].
        length: From what it turns on to its centre of mass [m].
    """

    way: float
    along: float
    time: float
    speed: float
    length: float


def joint_of(doc: EsgDocument, name: str) -> Joint | None:
    """The first joint of which a node is the child."""
    return next((j for j in doc.spatial_relation_graph.joints or () if j.child == name), None)


def suspension(doc: EsgDocument, name: str) -> Suspension | None:
    """How a node that is drawn back swings down; None for what does not hang, or hangs straight.

    Args:
        doc: With asset configurations.
        name: The child of a joint.
    """
    joint = joint_of(doc, name)
    if (
        joint is None
        or joint.kind not in KINDS_OF_JOINT[EdgeEvent.RELEASE]
        or joint.parent is None
        or not joint.position
    ):
        return None
    graph, assets = doc.spatial_relation_graph, doc.asset_configurations
    child, parent = (assets[graph.nodes[n].asset_id] for n in (name, joint.parent))
    mount, theirs = mount_of(child, joint.child_mount), mount_of(parent, joint.parent_mount)
    if mount is None or theirs is None:
        return None
    drawn = child_frame(joint, parent, child)
    lowest = child_frame(joint.model_copy(update={"position": 0.0}), parent, child)
    hinged = joint.kind == "hinge"
    axis = np.asarray(mount.axis if hinged else theirs.axis, float)
    about = axis if hinged else drawn_back_about(joint, axis)
    about = about / np.linalg.norm(about)
    com = np.asarray(child.center_of_mass_cm, float)
    arm = com - np.asarray(mount.position_cm, float)
    if joint.kind == "rope":
        arm = arm - np.array([0.0, 0.0, joint.upper or 0.0])
    off = float(np.linalg.norm(arm - (arm @ about) * about)) / 100.0
    ixx, iyy, izz, ixy, ixz, iyz = (v * 1e-4 for v in child.inertia_kg_cm2)
    inertia = np.array([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])
    turning = float(about @ inertia @ about) + child.mass_kg * off * off
    torque = child.mass_kg * GRAVITY_MPS2 * off
    angle = math.radians(abs(joint.position))
    ends = [f.position + quat_rotate(f.quaternion, com) for f in (drawn, lowest)]
    if torque <= 0.0 or turning <= 0.0 or ends[0][2] - ends[1][2] < 0.1:
        return None
    step = (lowest.position - drawn.position)[:2] / 100.0
    rate = math.sqrt(2.0 * torque * (1.0 - math.cos(angle)) / turning)
    return Suspension(
        way=float(np.hypot(*step)),
        along=math.atan2(step[1], step[0]) - float(yaw_from_quat(drawn.quaternion)),
        time=quarter_period(turning, torque, angle),
        speed=rate * off,
        length=off,
    )


def landing_place(doc: EsgDocument, name: str) -> tuple[float, float] | None:
    """Where something comes down on what a joint holds; None on what none does.

    Of what starts tipped about a level axis (a seesaw) that is its raised end; of a lid that stands
    open, but not as far as upright, its outer face, a push at which shuts it.

    Args:
        doc: With asset configurations.
        name: Of the node.

    Returns:
        Way from its origin along its heading, and height there above its root's foot [m].
    """
    found = start_frames(doc).get(name)
    if found is None:
        return None
    frame, joint = found[1], placing_joints(doc)[name]
    asset = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    length, _, height = asset.dimensions_cm
    mount = mount_of(asset, joint.child_mount)
    level = joint.kind == "hinge" and mount is not None and abs(mount.axis[1]) > 0.9
    tips = level and (joint.lower or 0.0) < 0.0 < (joint.upper or 0.0)
    leans = level and joint.lower == 0.0 and 0.0 < joint.position < 90.0
    if not leans and (not tips or suspension(doc, name) is not None):
        return 0.0, float(frame.position[2] + height) / 100.0
    if leans and mount is not None:
        out = math.copysign(NEAR_HINGE * 0.5 * length, mount.position_cm[0])
    else:
        out = -math.copysign(AT_END * 0.5 * length, joint.position) if joint.position else 0.0
    end = frame.position + quat_rotate(frame.quaternion, np.array([out, 0.0, height]))
    return float(end[0] - frame.position[0]) / 100.0, float(end[2]) / 100.0


def quarter_period(inertia: float, torque: float, angle: float) -> float:
    """Time of a pendulum from rest to its lowest point [s].

    Args:
        inertia: About its axis [kg m^2].
        torque: Of its weight when it is level [N m].
        angle: At which it is let go [rad].
    """
    a, b = 1.0, math.cos(0.5 * angle)
    while abs(a - b) > 1e-12:
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return 0.5 * math.pi / a * math.sqrt(inertia / torque)
