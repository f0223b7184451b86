"""Which bodies of a scene rest where they start: a judgement from geometry alone.

A body rests if it touches the ground, or the level top of something that rests, under its centre of
mass and overlaps nothing. The judgement is conservative: what it does not understand (lying
cylinders, slopes, things that lean on each other) counts as not at rest.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, Floats, Shape, SimScene
from esg.units import quat_rotate

TOUCH_M = 0.003
"""Largest gap or overlap of what lies on something."""
INSIDE_M = 0.005
"""How far inside of what carries it a centre of mass lies at least."""
LEVEL = math.cos(math.radians(0.5))
_RIM = 16

Bools = NDArray[np.bool_]


@dataclass(frozen=True)
class _Face:
    """A level top of a body: where it is and what lies within it."""

    owner: int
    height: float
    centre: Floats
    axes: Floats
    half: Floats
    round: bool

    def holds(self, points: Floats) -> Bools:
        """Which points [n, 3] lie on it."""
        local = (points[:, :2] - self.centre) @ self.axes.T
        if self.round:
            inside = np.hypot(local[:, 0], local[:, 1]) <= self.half[0] + TOUCH_M
        else:
            inside = (np.abs(local) <= self.half + TOUCH_M).all(axis=1)
        return inside & (np.abs(points[:, 2] - self.height) <= TOUCH_M)


def at_rest(scene: SimScene) -> Bools:
    """Bodies that stay where they start as long as nothing touches them, shape [B].

    Static bodies and decals do not count: they cannot move at all.
    """
    return _resting(scene.bodies, scene.gravity, _joined(scene))[0]


def starts_at_rest(scene: SimScene, position: Floats, quaternion: Floats) -> Bools:
    """Bodies at rest in worlds that may start elsewhere; those that do are not, shape [W, B].

    Args:
        scene: B bodies.
        position: Starts [m], shape [W, B, 3].
        quaternion: Unit (x, y, z, w), shape [W, B, 4].
    """
    rests, carriers = _resting(scene.bodies, scene.gravity, _joined(scene))
    if not rests.any():
        return np.zeros(position.shape[:2], bool)
    home = np.array([b.position for b in scene.bodies])
    turned = np.array([b.quaternion for b in scene.bodies], float)
    turned /= np.linalg.norm(turned, axis=1, keepdims=True)
    there = np.all(np.isclose(position, home, rtol=0.0, atol=1e-9), axis=-1)
    there = there & np.all(np.isclose(quaternion, turned, rtol=0.0, atol=1e-9), axis=-1)
    return rests & there & ~(~there[:, None] & carriers).any(axis=2)


def _joined(scene: SimScene) -> frozenset[str]:
    """Names of bodies with joints, which nothing is known of."""
    return frozenset(name for j in scene.joints for name in (j.child, j.parent))


@lru_cache(maxsize=64)
def _resting(
    bodies: tuple[Body, ...], gravity: tuple[float, float, float], joined: frozenset[str]
) -> tuple[Bools, Bools]:
    """Which bodies rest, shape [B], and on which others (row on column), shape [B, B]."""
    out, carriers = np.zeros(len(bodies), bool), np.zeros((len(bodies), len(bodies)), bool)
    if gravity[0] != 0.0 or gravity[1] != 0.0 or gravity[2] >= 0.0:
        return out, carriers
    low, high, owner = _boxes(bodies)
    crowded = np.any(_close(low, high, owner, -TOUCH_M, len(bodies)), axis=1)
    candidates = [
        i
        for i, b in enumerate(bodies)
        if b.collides and not b.static and not crowded[i] and b.name not in joined
    ]
    faces = [f for i, b in enumerate(bodies) if b.static for f in _tops(i, b)]
    # What carries others lies lower: one pass from below sees every carrier before its load.
    candidates.sort(key=lambda i: (float(low[owner == i, 2].min()), i))
    for i in candidates:
        points = _bottom(bodies[i])
        lowest = points[:, 2].min()
        points = points[points[:, 2] <= lowest + TOUCH_M]
        held = np.abs(points[:, 2]) <= TOUCH_M
        for face in faces:
            here = face.holds(points)
            held |= here
            carriers[i, face.owner] |= bool(here.any())
        if lowest < -TOUCH_M or not held.any():
            continue
        if _carried(np.array(bodies[i].position[:2]), points[held][:, :2], bodies[i]):
            out[i] = True
            faces += _tops(i, bodies[i])
    return out, carriers


def close_pairs(scene: SimScene, distance: float) -> Bools:
    """Pairs of bodies with parts less than a distance [m] apart, shape [B, B].

    Parts are measured by their bounding boxes in world axes.
    """
    return _close(*_boxes(scene.bodies), distance, len(scene.bodies))


def _boxes(bodies: tuple[Body, ...]) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Bounding boxes of all parts in world axes [m], two [S, 3], and their bodies, shape [S]."""
    boxes = [bounds_of(b) for b in bodies]
    low, high = (np.concatenate([box[k] for box in boxes] or [np.zeros((0, 3))]) for k in (0, 1))
    return low, high, np.repeat(np.arange(len(bodies)), [len(b.shapes) for b in bodies])


def _close(low: Floats, high: Floats, owner: NDArray[np.int64], gap: float, n: int) -> Bools:
    apart = np.maximum(low[:, None] - high[None], low[None] - high[:, None]).max(axis=-1)
    out = np.zeros((n, n), bool)
    first, second = np.nonzero(apart < gap)
    out[owner[first], owner[second]] = True
    np.fill_diagonal(out, False)
    return out


def bounds_of(body: Body) -> tuple[Floats, Floats]:
    """Lowest and highest corner of every part's bounding box in world axes [m], two [S, 3]."""
    low, high = np.empty((len(body.shapes), 3)), np.empty((len(body.shapes), 3))
    for k, shape in enumerate(body.shapes):
        axes, centre = _placed(body, shape)
        if shape.kind == "convex":
            points = np.array(shape.vertices) @ axes + centre
            low[k], high[k] = points.min(axis=0), points.max(axis=0)
            continue
        if shape.kind == "sphere":
            half = np.full(3, shape.size[0])
        elif shape.kind == "capsule":
            half = np.abs(axes[2]) * shape.size[2] + shape.size[0]
        else:
            half = np.abs(axes.T) @ np.array(shape.size)
        low[k], high[k] = centre - half, centre + half
    return low, high


def _placed(body: Body, shape: Shape) -> tuple[Floats, Floats]:
    """A shape's axes as rows and its centre, in the world."""
    q = np.array(body.quaternion, float)
    q = q / np.linalg.norm(q)
    axes = quat_rotate(q, quat_rotate(np.array(shape.quaternion, float), np.eye(3)))
    return axes, np.array(body.position) + quat_rotate(q, np.array(shape.position, float))


def _bottom(body: Body) -> Floats:
    """Points of the surface that may carry a body [m], shape [n, 3]."""
    out: list[Floats] = []
    for shape in body.shapes:
        axes, centre = _placed(body, shape)
        x, y, z = shape.size
        if shape.kind == "sphere":
            local = np.zeros((1, 3))
        elif shape.kind == "capsule":
            local = np.array([[0.0, 0.0, -z], [0.0, 0.0, z]])
        elif shape.kind == "box":
            local = np.array([(i, j, k) for i in (-x, x) for j in (-y, y) for k in (-z, z)])
        elif shape.kind == "cylinder":
            angle = np.arange(_RIM) * (2.0 * math.pi / _RIM)
            ring = np.stack([x * np.cos(angle), x * np.sin(angle), np.full(_RIM, z)], axis=1)
            local = np.concatenate([ring, ring * np.array([1.0, 1.0, -1.0])])
        else:
            local = np.array(shape.vertices)
        points = local @ axes + centre
        if shape.kind in ("sphere", "capsule"):
            points[:, 2] -= x
        out.append(points)
    return np.concatenate(out)


def _tops(i: int, body: Body) -> list[_Face]:
    """Level faces of upright boxes and cylinders."""
    out: list[_Face] = []
    for shape in body.shapes:
        if shape.kind not in ("box", "cylinder"):
            continue
        axes, centre = _placed(body, shape)
        up = int(np.argmax(np.abs(axes[:, 2])))
        if abs(axes[up, 2]) < LEVEL or (shape.kind == "cylinder" and up != 2):
            continue
        flat = [k for k in range(3) if k != up]
        height = float(centre[2] + shape.size[up])
        out.append(
            _Face(i, height, centre[:2], axes[flat][:, :2], np.array(shape.size)[flat],
                  shape.kind == "cylinder")
        )  # fmt: skip
    return out


def _carried(centre: Floats, points: Floats, body: Body) -> bool:
    """Whether a centre of mass [2] lies well within the hull of what carries it [n, 2]."""
    if all(s.kind == "sphere" for s in body.shapes):
        return len(points) == 1 and float(np.hypot(*(points[0] - centre))) < 1e-4
    margin = min(INSIDE_M, 0.1 * min(body.half_extents))
    # The hull holds the centre iff no direction has all points behind it.
    angle = np.arange(64) * (2.0 * math.pi / 64)
    ahead = (points - centre) @ np.stack([np.cos(angle), np.sin(angle)])
    return bool((ahead.max(axis=0) > margin).all())
