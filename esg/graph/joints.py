"""Where joints put nodes: poses of children in the frames of their parents (docs/joints.md)."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.graph.models import AssetConfiguration, EdgeEvent, EsgDocument, Joint, Mount, Pose, Vec3
from esg.units import (
    euler_deg_from_quat,
    quat_from_euler_deg,
    quat_inverse,
    quat_multiply,
    quat_rotate,
)

Floats = NDArray[np.float64]

FOOT, SEAT = "foot", "seat"
"""Mounts that no asset has to name: its origin, and the middle of its first surface or its top."""
PILLION, BEHIND_CM = "pillion", 38.0
"""The mount of who sits behind somebody, and how far behind the seat it is [cm]."""
FRONT, REAR = "front", "rear"
"""Mounts that no asset has to name: where it is drawn along, and where it draws something."""
TOWED = (REAR, FRONT)
"""Mounts of what draws and of what it draws."""
HITCH_CM = 40.0
"""Height of those: couplings of cars are at 35 to 42 cm (ISO 1103), or half as high as it is."""
UP: Vec3 = (0.0, 0.0, 1.0)
ACROSS: Vec3 = (0.0, 1.0, 0.0)
"""What hangs on a ball joint, a rope or a spring is drawn back about this axis of its parent."""
KINDS_OF_JOINT: dict[EdgeEvent, tuple[str, ...]] = {
    EdgeEvent.DRIVE: ("hinge", "slider"),
    EdgeEvent.RELEASE: ("hinge", "ball", "rope", "slider", "spring"),
}
"""Segments along a joint, and the kinds of joint on which they can be."""
_IDENTITY = np.array([0.0, 0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Frame:
    """A rigid pose: position [cm], shape [3], and quaternion (x, y, z, w), shape [4]."""

    position: Floats
    quaternion: Floats

    def then(self, inner: Frame) -> Frame:
        """The pose of what has the pose `inner` in this frame."""
        return Frame(
            self.position + quat_rotate(self.quaternion, inner.position),
            quat_multiply(self.quaternion, inner.quaternion),
        )

    def inverse(self) -> Frame:
        """The pose of the outer frame in this one."""
        back = quat_inverse(self.quaternion)
        return Frame(-quat_rotate(back, self.position), back)


def frame_of(pose: Pose) -> Frame:
    """A pose of the document as a frame."""
    turned = quat_from_euler_deg(pose.yaw_deg, pose.pitch_deg, pose.roll_deg)
    return Frame(np.asarray(pose.position_cm, float), turned)


def pose_of(frame: Frame) -> Pose:
    """A frame as a pose of the document, rounded to 1e-4 cm and degrees."""
    x, y, z = (round(float(v), 4) for v in frame.position)
    yaw, pitch, roll = (round(v, 4) for v in euler_deg_from_quat(frame.quaternion))
    return Pose(position_cm=(x, y, z), yaw_deg=yaw, pitch_deg=pitch, roll_deg=roll)


def mount_of(asset: AssetConfiguration, name: str | None) -> Mount | None:
    """The mount of that name; None if the asset has none.

    Every asset has `FOOT`, `SEAT`, `PILLION`, `FRONT` and `REAR`.
    """
    if name == FOOT:
        return Mount(name=FOOT, position_cm=(0.0, 0.0, 0.0), axis=UP)
    if name in (SEAT, PILLION):
        top = (0.0, 0.0, asset.dimensions_cm[2])
        x, y, z = next((s.center_cm for s in asset.support_surfaces), top)
        behind = BEHIND_CM if name == PILLION else 0.0
        return Mount(name=name, position_cm=(x - behind, y, z), axis=UP)
    if name in (FRONT, REAR):
        length, _, height = asset.dimensions_cm
        end = (0.5 * length if name == FRONT else -0.5 * length, 0.0, hitch_cm(height))
        return Mount(name=name, position_cm=end, axis=UP)
    return next((m for m in asset.mounts or () if m.name == name), None)


def hitch_cm(height: float) -> float:
    """Height above the ground at which a thing of a height is drawn along, or draws [cm]."""
    return min(HITCH_CM, 0.5 * height)


def trails(joint: Joint) -> bool:
    """Whether a rope draws its child along behind its parent, on the same level."""
    return joint.kind == "rope" and (joint.parent_mount, joint.child_mount) == TOWED


def towed_by(doc: EsgDocument, name: str) -> list[str]:
    """What a node draws along behind it, the nearest first."""
    out: list[str] = []
    ahead = [name]
    while ahead:
        parent = ahead.pop(0)
        behind = [
            j.child
            for j in doc.spatial_relation_graph.joints or ()
            if j.parent == parent and (j.parent_mount, j.child_mount) == TOWED
        ]
        ahead += behind
        out += behind
    return out


def placing_joints(doc: EsgDocument) -> dict[str, Joint]:
    """The joint that puts each node where it is, by child: the first that names both mounts.

    Joints whose mounts the assets do not have place nothing, nor do those that close a circle.
    """
    graph, assets = doc.spatial_relation_graph, doc.asset_configurations
    out: dict[str, Joint] = {}
    for joint in graph.joints or ():
        ends = ((joint.child, joint.child_mount), (joint.parent, joint.parent_mount))
        known = all(
            node in graph.nodes
            and (asset := assets.get(graph.nodes[node].asset_id)) is not None
            and mount_of(asset, mount) is not None
            for node, mount in ends
        )
        if known and joint.child not in out and root_of(out, joint.parent) != joint.child:
            out[joint.child] = joint
    return out


def root_of(placed: dict[str, Joint], name: str | None) -> str | None:
    """What a node is carried by through joints in the end: itself if no joint places it."""
    while name in placed:
        name = placed[name].parent
    return name


def start_frames(doc: EsgDocument) -> dict[str, tuple[str, Frame]]:
    """Every node that a joint places: its root and its pose there at the start, parents first."""
    graph, assets = doc.spatial_relation_graph, doc.asset_configurations
    placed = placing_joints(doc)
    out: dict[str, tuple[str, Frame]] = {}

    def resolve(name: str) -> tuple[str, Frame]:
        if name not in placed:
            return name, Frame(np.zeros(3), _IDENTITY)
        if name not in out:
            joint = placed[name]
            assert joint.parent is not None
            root, outer = resolve(joint.parent)
            parent, child = (assets[graph.nodes[n].asset_id] for n in (joint.parent, name))
            out[name] = root, outer.then(child_frame(joint, parent, child))
        return out[name]

    for name in placed:
        resolve(name)
    return out


def child_frame(joint: Joint, parent: AssetConfiguration, child: AssetConfiguration) -> Frame:
    """Pose of a child's local frame in its parent's, as the joint starts.

    Args:
        joint: Names a mount of both.
        parent, child: Their assets.
    """
    theirs, mine = mount_of(parent, joint.parent_mount), mount_of(child, joint.child_mount)
    assert theirs is not None and mine is not None
    if trails(joint):
        lift, length = mine.position_cm[2] - theirs.position_cm[2], joint.upper or 0.0
        ahead = math.sqrt(max(length * length - lift * lift, 0.0))
        at = theirs.position_cm[0] - ahead - mine.position_cm[0]
        return Frame(np.array([at, 0.0, 0.0]), _IDENTITY)
    axis = _unit(theirs.axis)
    free = joint.kind in ("rope", "spring") and joint.child_mount == SEAT
    upright = _IDENTITY if free else _least_turn(_unit(mine.axis), axis)
    turned = quat_multiply(_started(joint, axis), upright)
    end = np.asarray(theirs.position_cm, float) + _offset(joint, axis)
    return Frame(end - quat_rotate(turned, np.asarray(mine.position_cm, float)), turned)


def own_frame(joint: Joint, child: AssetConfiguration) -> Frame:
    """Pose of a child's local frame in the frame in which it was placed, as the joint starts.

    For joints that name no mount of a parent: the child is turned about its own mount.
    """
    mine = mount_of(child, joint.child_mount)
    if mine is None:
        return Frame(np.zeros(3), _IDENTITY)
    axis, at = _unit(mine.axis), np.asarray(mine.position_cm, float)
    turned = _started(joint, axis)
    along = joint.position * axis if joint.kind == "slider" else np.zeros(3)
    return Frame(at + along - quat_rotate(turned, at), turned)


def _started(joint: Joint, axis: Floats) -> Floats:
    """Turn of the child by the joint's start position, quaternion (x, y, z, w), shape [4]."""
    if joint.kind in ("slider", "fixed") or joint.position == 0.0:
        return _IDENTITY
    half = 0.5 * math.radians(joint.position)
    about = axis if joint.kind == "hinge" else drawn_back_about(joint, axis)
    return np.array([*(math.sin(half) * about), math.cos(half)])


def drawn_back_about(joint: Joint, axis: Floats) -> Floats:
    """Unit axis about which what hangs is drawn back: across, and of a cone athwart its axis."""
    across = np.asarray(ACROSS, float)
    if joint.kind != "ball":
        return across
    off = across - (across @ axis) * axis
    return _unit(tuple(off)) if np.linalg.norm(off) > 1e-6 else np.array([1.0, 0.0, 0.0])


def _offset(joint: Joint, axis: Floats) -> Floats:
    """From the parent's mount to the child's, in the parent's frame [cm], shape [3]."""
    if joint.kind == "slider":
        return joint.position * axis
    if joint.kind in ("rope", "spring"):
        return quat_rotate(_started(joint, axis), np.array([0.0, 0.0, -(joint.upper or 0.0)]))
    return np.zeros(3)


def _unit(v: Vec3 | tuple[float, ...]) -> Floats:
    out = np.asarray(v, float)
    length = float(np.linalg.norm(out))
    return out / length if length > 0.0 else np.array([0.0, 0.0, 1.0])


def _least_turn(a: Floats, b: Floats) -> Floats:
    """The smallest rotation (x, y, z, w) that takes a unit vector to another, shape [4]."""
    cosine = float(a @ b)
    if cosine > 1.0 - 1e-12:
        return _IDENTITY
    if cosine < -1.0 + 1e-12:
        side = np.cross(a, [1.0, 0.0, 0.0] if abs(a[0]) < 0.9 else [0.0, 1.0, 0.0])
        return np.array([*(side / np.linalg.norm(side)), 0.0])
    q = np.array([*np.cross(a, b), 1.0 + cosine])
    return q / np.linalg.norm(q)
