"""Sides of a thing as who climbs it meets them: how far it reaches at every height."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import itertools
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body
from esg.graph.models import AssetConfiguration
from esg.units import quat_rotate

Floats = NDArray[np.float64]
SLAB_M = 0.01
"""Height of the slabs in which a thing is measured."""
_SIDES = 8
"""Corners of what is round; its flat sides face the axes."""


def corners(
    kind: str, size: Sequence[float], vertices: Sequence[Sequence[float]]
) -> Floats:  # shape [n, 3]
    """Points whose hull is a collision shape, in its own frame and unit, shape [n, 3].

    Args:
        kind: box, cylinder, sphere, capsule or convex.
        size: As `Proxy.size_cm`.
        vertices: Of what is convex.
    """
    if vertices:
        return np.array(vertices, float).reshape(-1, 3)
    if kind == "box":
        return np.array(list(itertools.product((-1.0, 1.0), repeat=3))) * np.array(size)
    angle = (np.arange(_SIDES) + 0.5) * 2.0 * math.pi / _SIDES
    # The outline that holds the circle.
    r = size[0] / math.cos(math.pi / _SIDES)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    if kind == "cylinder":
        rings = [(r, -size[2]), (r, size[2])]
    else:
        half = size[2] if kind == "capsule" else 0.0
        tilts = np.linspace(0.0, 0.5 * math.pi, 4)
        wide = 1.0 / math.cos(0.25 * math.pi / (len(tilts) - 1))
        rings = [(wide * r * math.cos(t), s * (half + wide * size[0] * math.sin(t)))
                 for s in (-1, 1) for t in tilts]  # fmt: skip
    return np.concatenate(
        [np.column_stack([ring * circle, np.full(_SIDES, z)]) for ring, z in rings]
    )


def clouds_of_asset(config: AssetConfiguration) -> list[Floats]:
    """The collision shapes of an asset as points around its origin [m], each of shape [n, 3]."""
    return [
        (quat_rotate(np.array(p.orientation_xyzw), corners(p.kind.value, p.size_cm, p.vertices_cm))
         + np.array(p.position_cm)) / 100.0
        for p in config.proxies
    ]  # fmt: skip


def clouds_of_body(body: Body) -> list[Floats]:
    """The collision shapes of a body as points around its centre of mass [m], in its axes."""
    return [
        quat_rotate(np.array(s.quaternion), corners(s.kind, s.size, s.vertices))
        + np.array(s.position)
        for s in body.shapes
    ]


@dataclass(frozen=True)
class Outline:
    """How far a thing reaches along a direction, in slabs of `SLAB_M`.

    Args:
        base: Height of the lowest slab's floor [m].
        near, far: Least and largest coordinate in every slab [m], infinite where there is nothing.
        top: Height of its top [m].
    """

    base: float
    near: Floats
    far: Floats
    top: float


def outline(clouds: Sequence[Floats], base: float, half_width: float = math.inf) -> Outline:
    """The outline of convex shapes along the first axis.

    Args:
        clouds: Their points [m], each of shape [n, 3]; the axes are along, across and up.
        base: Height of the lowest slab's floor [m].
        half_width: What lies farther aside than that [m] is left out.
    """
    met = [c for c in clouds if c[:, 1].max() > -half_width and c[:, 1].min() < half_width]
    top = max((float(c[:, 2].max()) for c in met), default=base)
    count = max(1, math.ceil((top - base) / SLAB_M - 1e-6))
    near, far = np.full(count + 1, np.inf), np.full(count + 1, -np.inf)
    spans_near, spans_far = near.copy(), far.copy()
    for cloud in met:
        low = (float(cloud[:, 2].min()) - base) / SLAB_M
        high = (float(cloud[:, 2].max()) - base) / SLAB_M
        levels = np.arange(max(0, math.ceil(low)), min(count, math.floor(high)) + 1)
        if len(levels):
            least, most = _cut(cloud, np.asarray(base + SLAB_M * levels, float))
            near[levels] = np.minimum(near[levels], least)
            far[levels] = np.maximum(far[levels], most)
        slab = np.clip(np.floor((cloud[:, 2] - base) / SLAB_M).astype(int), 0, count)
        np.minimum.at(spans_near, slab, cloud[:, 0])
        np.maximum.at(spans_far, slab, cloud[:, 0])
    near = np.minimum(np.minimum(near[:-1], near[1:]), spans_near[:-1])
    far = np.maximum(np.maximum(far[:-1], far[1:]), spans_far[:-1])
    return Outline(base, near, far, top)


def _cut(cloud: Floats, levels: Floats) -> tuple[Floats, Floats]:
    """Least and largest first coordinate of a hull at heights within it, each of shape [k]."""
    i, j = np.triu_indices(len(cloud), 1)
    z0, z1 = cloud[i, 2], cloud[j, 2]
    swap = z0 > z1
    i, j = np.where(swap, j, i), np.where(swap, i, j)
    z0, z1, u0, u1 = cloud[i, 2], cloud[j, 2], cloud[i, 0], cloud[j, 0]
    rise = np.maximum(z1 - z0, 1e-9)
    share = (levels[:, None] - z0) / rise
    u = u0 + np.clip(share, 0.0, 1.0) * (u1 - u0)
    crosses = (share >= -1e-6) & (levels[:, None] <= z1 + 1e-6)
    return (
        np.where(crosses, u, np.inf).min(axis=1),
        np.where(crosses, u, -np.inf).max(axis=1),
    )
