"""Things that lie or stand otherwise than they are drawn: on their side, upside down, on an edge.

The whole asset is turned, and then tips on until it rests on a face of its hull over which its
centre of mass is: a tapered cup on its side has its wall below, a chair upside down its back. The
turned asset is what every later stage knows, so that footprint, rest height, mass properties and
drawing agree.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.geometry.massprops import mass_properties
from esg.assets.geometry.rotations import turn
from esg.assets.geometry.sketch import Sketch
from esg.graph.models import Lying, Mount, NamedRegion, Proxy, ProxyKind, Quat, Vec3
from esg.lexicon.lying import AS_DRAWN, TIPPED_UP, Up, ups
from esg.units import quat_inverse, quat_multiply, quat_rotate

Floats = NDArray[np.float64]
_TURNS: dict[Up, Quat] = {
    (2, -1): turn("x", 180.0),
    (0, 1): turn("y", -90.0),
    (0, -1): turn("y", 90.0),
    (1, 1): turn("x", 90.0),
    (1, -1): turn("x", -90.0),
}
"""What leads an end of an own axis up."""
_SQUARE = 0.02
"""Up to this share as wide as long."""
_ROUND = 24
"""Points about a rim, for its hull."""
_FLAT_DEG = 0.5
"""Faces less far off than this are level already."""
_FOOT_CM = 0.5
"""Shapes that end so near to the lowest one are of the foot."""
_SLENDER_DEG, _LEAN, _LEANS_DEG = 26.0, 0.5, 12.0
"""What is let go wobbles if it tips over at this lean or a lesser one; at which share of it, and
at which lean at most, it is let go."""
_SAME = 1e-3
"""Normals that agree so far are of one face."""
_INSIDE = 1e-3
"""How far from the edge of a face the centre of mass has to be, over the size of the asset."""


def lain(sketch: Sketch, pose: str, dimensions_cm: Vec3) -> Lying | None:
    """How an asset is turned to lie or stand so; None if it does as it is drawn.

    Args:
        sketch: As it is drawn.
        pose: Row of the table of poses (`esg.lexicon.lying`).
        dimensions_cm: Of the sketch.
    """
    if not sketch.proxies:
        return None
    com, _ = mass_properties(sketch.weighed or sketch.proxies, 1.0, sketch.densities)
    if pose == TIPPED_UP:
        quat = _tipped_up(sketch.proxies, com)
        return None if quat is None else _lying(sketch, pose, quat, dimensions_cm)
    allowed = ups(pose, dimensions_cm)
    if AS_DRAWN in allowed[:1]:
        return None
    length, width, _ = dimensions_cm
    square = abs(length - width) <= _SQUARE * length  # it has no sides: its height lies along X
    square &= allowed[0][0] != 2
    best = next((up for up in allowed if square and up[0] == 0), allowed[0])
    first = _TURNS[best]
    points = quat_rotate(first, np.concatenate([_points(p) for p in sketch.proxies]))
    x, y, z, w = (
        float(v) for v in quat_multiply(_settling(points, quat_rotate(first, com)), first)
    )
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    return _lying(sketch, pose, (x / norm, y / norm, z / norm, w / norm), dimensions_cm)


def _tipped_up(proxies: Sequence[Proxy], com: Vec3) -> Quat | None:
    """A lean towards the nearest edge of its foot; None if it is too squat to wobble."""
    bounds = [_bounds(p) for p in proxies]
    low = min(b[0][2] for b in bounds)
    feet = [b for b in bounds if b[0][2] < low + _FOOT_CM]
    reach = [max(b[1][k] for b in feet) - com[k] for k in (0, 1)]
    nearest = 0 if reach[0] <= reach[1] else 1
    edge = math.degrees(math.atan2(reach[nearest], com[2] - low))
    if not 0.0 < edge <= _SLENDER_DEG:
        return None
    lean = min(_LEAN * edge, _LEANS_DEG)
    return turn("y", lean) if nearest == 0 else turn("x", -lean)


def _lying(sketch: Sketch, pose: str, quat: Quat, dimensions_cm: Vec3) -> Lying:
    """A turn with what sets the turned asset on the ground."""
    lows, highs = zip(*(_bounds(_placed(p, quat, (0.0, 0.0, 0.0))) for p in sketch.proxies),
                      strict=True)  # fmt: skip
    low, high = np.min(lows, axis=0), np.max(highs, axis=0)
    middle = (low + high) / 2
    return Lying(
        pose=pose,
        turned_xyzw=quat,
        moved_cm=(-float(middle[0]), -float(middle[1]), -float(low[2])),
        drawn_cm=dimensions_cm,
        dimensions_cm=tuple(float(v) for v in high - low),  # type: ignore[arg-type]  # three
    )


def turned(sketch: Sketch, lying: Lying) -> Sketch:
    """The asset as it lies: nothing of it turns by itself, nothing stands on it by name."""
    quat, by = lying.turned_xyzw, np.asarray(lying.moved_cm)

    @cache
    def level() -> float:
        """Height of the lowest point that is drawn: colliders leave mirrors and rims out."""
        lowest = (
            quat_rotate(quat, np.asarray(p.mesh().vertices))[:, 2].min() for p in sketch.parts
        )
        return float(min(lowest, default=-by[2]))

    def moved(make: Callable[[], Any]) -> Callable[[], Any]:
        def mesh() -> Any:
            out = make()
            at = np.array([by[0], by[1], -level()])
            out.vertices = quat_rotate(quat, np.asarray(out.vertices)) + at
            return out

        return mesh

    weighed = sketch.weighed
    return Sketch(
        parts=[replace(p, mesh=moved(p.mesh), axle=None, limb="") for p in sketch.parts],
        proxies=[_placed(p, quat, lying.moved_cm) for p in sketch.proxies],
        densities=list(sketch.densities),
        regions=[_region(r, quat, by) for r in sketch.regions],
        mounts=[_mount(m, quat, by) for m in sketch.mounts],
        weighed=None if weighed is None else [_placed(p, quat, lying.moved_cm) for p in weighed],
        material=sketch.material,
        appearance=sketch.appearance,
    )


def drawn_size(lying: Lying, size: Vec3) -> Vec3:
    """Extents [cm] as it is drawn of what is to have these as it lies."""
    ratios = np.asarray(size) / np.asarray(lying.dimensions_cm)
    axes = np.abs(quat_rotate(quat_inverse(lying.turned_xyzw), np.eye(3)))  # rows: lying axes
    own = np.argmax(axes, axis=0)
    return tuple(float(d * ratios[k]) for d, k in zip(lying.drawn_cm, own, strict=True))  # type: ignore[return-value]


def _vec(v: Any) -> Vec3:
    return (float(v[0]), float(v[1]), float(v[2]))


def _placed(p: Proxy, quat: Quat, by: Sequence[float]) -> Proxy:
    x, y, z, w = (float(c) for c in quat_multiply(quat, p.orientation_xyzw))
    at = quat_rotate(quat, np.asarray(p.position_cm)) + np.asarray(by)
    return p.model_copy(update={"position_cm": _vec(at), "orientation_xyzw": (x, y, z, w)})


def _mount(m: Mount, quat: Quat, by: Floats) -> Mount:
    at = quat_rotate(quat, np.asarray(m.position_cm)) + by
    axis = quat_rotate(quat, np.asarray(m.axis))
    return m.model_copy(update={"position_cm": _vec(at), "axis": _vec(axis)})


def _region(r: NamedRegion, quat: Quat, by: Floats) -> NamedRegion:
    """A box along the axes again: of what leans, the one along the nearest of them."""
    axes = np.abs(quat_rotate(quat, np.eye(3)))  # rows: where the own axes point
    half = np.zeros(3)
    for own, axis in enumerate(np.argmax(axes, axis=1)):
        half[axis] = r.half_extents_cm[own]
    at = quat_rotate(quat, np.asarray(r.center_cm)) + by
    return r.model_copy(update={"center_cm": _vec(at), "half_extents_cm": _vec(half)})


def _points(p: Proxy) -> Floats:
    """Points whose hull is that of a proxy, in the asset's frame [cm], shape [N, 3]."""
    a, b, c = p.size_cm
    if p.kind is ProxyKind.CONVEX:
        own = np.asarray(p.vertices_cm, float)
    elif p.kind is ProxyKind.BOX:
        own = np.array([[x, y, z] for x in (-a, a) for y in (-b, b) for z in (-c, c)])
    else:
        # Faces, not corners, look along the own axes.
        t = 2 * np.pi * (np.arange(_ROUND) + 0.5) / _ROUND
        ring = np.stack([a * np.cos(t), a * np.sin(t), 0 * t], axis=1)
        if p.kind is ProxyKind.CYLINDER:
            own = np.concatenate([ring + np.array([0.0, 0.0, s * c]) for s in (-1, 1)])
        else:
            height = 0.0 if p.kind is ProxyKind.SPHERE else c
            bends = np.radians([-90, -60, -30, 0, 30, 60, 90])
            own = np.concatenate([
                ring * np.cos(s) + [0, 0, a * np.sin(s) + sign * height]
                for s in bends for sign in (-1, 1)
            ])  # fmt: skip
    return quat_rotate(p.orientation_xyzw, own) + np.asarray(p.position_cm)


def _bounds(p: Proxy) -> tuple[Floats, Floats]:
    """Exact bounds of a proxy along the axes [cm]."""
    at = np.asarray(p.position_cm)
    if p.kind in (ProxyKind.BOX, ProxyKind.CONVEX):
        points = _points(p)
        return points.min(0), points.max(0)
    radius, _, half = p.size_cm
    axis = quat_rotate(p.orientation_xyzw, np.array([0.0, 0.0, 1.0]))
    if p.kind is ProxyKind.CYLINDER:
        reach = half * np.abs(axis) + radius * np.sqrt(np.clip(1.0 - axis**2, 0.0, None))
    else:
        reach = radius + (half * np.abs(axis) if p.kind is ProxyKind.CAPSULE else 0.0)
    return at - reach, at + reach


def _settling(points: Floats, com: Any) -> Quat:
    """The least turn that lays a body on a face of its hull that its centre of mass is over."""
    from scipy.spatial import ConvexHull

    hull = ConvexHull(points)
    normals = hull.equations[:, :3]
    size = float(np.ptp(points, axis=0).max())
    best: tuple[float, Floats] | None = None
    seen: list[Floats] = []
    for n in normals[np.argsort(normals[:, 2], kind="stable")]:
        if any(np.abs(n - s).max() < _SAME for s in seen):
            continue
        seen.append(n)
        face = np.abs(normals - n).max(axis=1) < _SAME
        corners = points[np.unique(hull.simplices[face])]
        if _over(corners, n, np.asarray(com, float), _INSIDE * size):
            best = (math.degrees(math.acos(float(np.clip(-n[2], -1.0, 1.0)))), n)
            break
    if best is None or best[0] < _FLAT_DEG:
        return (0.0, 0.0, 0.0, 1.0)
    down = np.array([0.0, 0.0, -1.0])
    axis = np.cross(best[1], down)
    w = 1.0 + float(best[1] @ down)
    return (float(axis[0]), float(axis[1]), float(axis[2]), w) if w > 1e-9 else turn("x", 180.0)


def _over(corners: Floats, normal: Floats, com: Floats, margin: float) -> bool:
    """Whether a point is over a convex face, by a margin, along its normal."""
    middle = corners.mean(axis=0)
    one = np.cross(normal, [0.0, 0.0, 1.0] if abs(normal[2]) < 0.9 else [1.0, 0.0, 0.0])
    one /= np.linalg.norm(one)
    plane = np.stack([one, np.cross(normal, one)], axis=1)
    flat, at = (corners - middle) @ plane, (com - middle) @ plane
    order = np.argsort(np.arctan2(flat[:, 1], flat[:, 0]), kind="stable")
    ring = flat[order]
    edge = np.roll(ring, -1, axis=0) - ring
    length = np.linalg.norm(edge, axis=1)
    keep = length > 1e-9
    side = edge[:, 0] * (at[1] - ring[:, 1]) - edge[:, 1] * (at[0] - ring[:, 0])
    return bool(np.all(side[keep] / length[keep] > min(margin, 0.05 * float(length.max()))))
