"""What joints fix in a layout: where the members of a jointed thing are to each other.

The thing that carries the others is their root; it is placed, and they follow. A layout turns
things about Z only, so that what starts askew is laid out as the shape that it has then.
"""

from __future__ import annotations

from dataclasses import dataclass, field
import itertools
import math

import numpy as np

from esg.graph.joints import Frame, child_frame, own_frame, placing_joints, start_frames, trails
from esg.graph.models import AssetConfiguration, EsgDocument, Joint, Proxy, RelationType
from esg.layout.problem.poses import Pose2, compose, inverse
from esg.layout.problem.shapes import RECTANGLE, footprints
from esg.units import euler_deg_from_quat, quat_from_euler_deg, quat_multiply, quat_rotate

SWING_DEG = 60.0
"""What may turn on and on is kept clear as far to both sides."""
PLACES = 9
"""Positions of a joint between its limits at which its child is looked at."""


@dataclass(frozen=True)
class Joined:
    """Members of jointed things, but for their roots.

    Args:
        root: What carries each in the end.
        parent: What it is joined to.
        rel: Pose in the root's frame (x, y [cm], yaw [rad]).
        rise: Height of its origin above the root's [cm].
        tilt: Its frame in the planar frame that it is laid out in, where they are not the same.
    """

    root: dict[str, str] = field(default_factory=dict[str, str])
    parent: dict[str, str] = field(default_factory=dict[str, str])
    rel: dict[str, Pose2] = field(default_factory=dict[str, Pose2])
    rise: dict[str, float] = field(default_factory=dict[str, float])
    tilt: dict[str, Frame] = field(default_factory=dict[str, Frame])

    def are_joined(self, a: str, b: str) -> bool:
        """Whether one of two nodes hangs on the other."""
        return self.parent.get(a) == b or self.parent.get(b) == a

    def mates(self, name: str) -> dict[str, Pose2]:
        """The other members of what a node belongs to, by pose in that node's frame."""
        root = self.root.get(name, name)
        here = inverse(self.rel.get(name, (0.0, 0.0, 0.0)))
        poses: dict[str, Pose2] = {n: self.rel[n] for n, r in self.root.items() if r == root}
        if poses:
            poses = {root: (0.0, 0.0, 0.0), **poses}
        return {n: compose(here, p) for n, p in poses.items() if n != name}


def joined(doc: EsgDocument) -> Joined:
    """The jointed things of a resolved document."""
    out = Joined()
    if not doc.spatial_relation_graph.joints:
        return out
    placed = placing_joints(doc)
    for name, (root, frame) in start_frames(doc).items():
        yaw, pitch, roll = euler_deg_from_quat(frame.quaternion)
        x, y, z = (float(v) for v in frame.position)
        out.root[name], out.rise[name] = root, z
        out.rel[name] = (x, y, math.radians(yaw))
        out.parent[name] = placed[name].parent or ""
        if math.hypot(pitch, roll) > 1e-9:
            out.tilt[name] = Frame(np.zeros(3), quat_from_euler_deg(0.0, pitch, roll))
    for joint in doc.spatial_relation_graph.joints:
        if joint.child not in placed and joint.position != 0.0 and joint.child not in out.tilt:
            nodes, assets = doc.spatial_relation_graph.nodes, doc.asset_configurations
            out.tilt[joint.child] = own_frame(joint, assets[nodes[joint.child].asset_id])
    return out


def facing_as_one(doc: EsgDocument) -> EsgDocument:
    """The document in which an open door faces as its frame does, not as its leaf stands."""
    frames = start_frames(doc)
    if not frames:
        return doc
    graph = doc.spatial_relation_graph
    edges = tuple(
        e.model_copy(update={"from_": frames[e.from_][0]})
        if e.relation_type is RelationType.FACE and e.from_ in frames
        else e
        for e in graph.edges.binary_relations
    )
    edges_now = graph.edges.model_copy(update={"binary_relations": edges})
    graph = graph.model_copy(update={"edges": edges_now})
    return doc.model_copy(update={"spatial_relation_graph": graph})


def posed(asset: AssetConfiguration, tilt: Frame) -> AssetConfiguration:
    """An asset as it stands askew, for its collision shapes and where its mass is."""

    def moved(proxy: Proxy) -> Proxy:
        at = tilt.position + quat_rotate(tilt.quaternion, np.asarray(proxy.position_cm))
        turned = quat_multiply(tilt.quaternion, np.asarray(proxy.orientation_xyzw))
        return proxy.model_copy(
            update={"position_cm": _triple(at), "orientation_xyzw": tuple(map(float, turned))}
        )

    com = tilt.position + quat_rotate(tilt.quaternion, np.asarray(asset.center_of_mass_cm))
    out = asset.model_copy(
        update={
            "proxies": tuple(moved(p) for p in asset.proxies),
            "support_surfaces": (),
            "regions": (),
            "center_of_mass_cm": _triple(com),
        }
    )
    top = max((p.z1 for p in footprints(out)), default=asset.dimensions_cm[2])
    return out.model_copy(update={"dimensions_cm": (0.1, 0.1, top)})


def swept(doc: EsgDocument) -> dict[str, list[tuple[float, ...]]]:
    """What has to stay clear for joints to move: prisms in the frame of their root, by root.

    A prism is that of `esg.layout.problem.obstacles`.
    """
    graph, assets = doc.spatial_relation_graph, doc.asset_configurations
    frames = start_frames(doc)
    out: dict[str, list[tuple[float, ...]]] = {}
    for name, joint in placing_joints(doc).items():
        assert joint.parent is not None
        root, outer = frames.get(joint.parent, (joint.parent, None))
        parent, child = (assets[graph.nodes[n].asset_id] for n in (joint.parent, name))
        corners = _corners(child)
        points = []
        for position in _positions(joint):
            frame = child_frame(joint.model_copy(update={"position": position}), parent, child)
            frame = frame if outer is None else outer.then(frame)
            points.append(frame.position + quat_rotate(frame.quaternion, corners))
        low, high = np.concatenate(points).min(0), np.concatenate(points).max(0)
        (x, y, _), (hx, hy, _) = 0.5 * (low + high), 0.5 * (high - low)
        prism = (float(RECTANGLE), x, y, 0.0, hx, hy, low[2], high[2])
        out.setdefault(root, []).append(tuple(float(v) for v in prism))
    return out


def _positions(joint: Joint) -> list[float]:
    """Positions between the limits, or as far as it would swing [deg or cm]."""
    if joint.kind == "fixed" or trails(joint):
        return [0.0]
    if joint.kind in ("hinge", "slider"):
        far = max(SWING_DEG, abs(joint.position)) if joint.kind == "hinge" else 0.0
        low = -far if joint.lower is None else max(joint.lower, -180.0)
        high = far if joint.upper is None else joint.upper
    else:
        far = max(SWING_DEG / 2.0, abs(joint.position))
        low, high = -far, far
    return [float(v) for v in np.linspace(low, high, PLACES)]


def _corners(asset: AssetConfiguration) -> np.ndarray:
    length, width, height = asset.dimensions_cm
    spans = ((-length / 2, length / 2), (-width / 2, width / 2), (0.0, height))
    return np.array(list(itertools.product(*spans)))


def _triple(v: np.ndarray) -> tuple[float, float, float]:
    return float(v[0]), float(v[1]), float(v[2])
