"""What fills a vessel is drawn within its walls: a body of rings that reach as far as they do."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.assets.geometry.sketch import Part, Sketch
from esg.assets.lazy import forms
from esg.graph.models import NamedRegion
from esg.lexicon.contents import Content

if TYPE_CHECKING:
    import trimesh

RAYS, RINGS = 48, 7
"""Points of a ring, and rings from the bottom to the level."""
WITHIN = 0.99
"""How far it reaches over the way to the wall: it is not drawn into what one can see through."""

Points = NDArray[np.float64]


def pour(
    sketch: Sketch, level: NamedRegion, row: Content, color: tuple[float, float, float]
) -> None:
    """Adds to a vessel what is in it.

    Args:
        sketch: What its builder drew.
        level: Where its content is [cm].
        row: What that is.
        color: In which colour.
    """
    walls = tuple(p for p in sketch.parts if p.name != row.name)
    sketch.add(
        lambda: filling(walls, level),
        color,
        of=row.finish,
        name=row.name,
        rough=0.08 if row.liquid else 0.95,
        alpha=row.alpha,
    )


def filling(walls: tuple[Part, ...], level: NamedRegion) -> trimesh.Trimesh:
    """The body of the content, closed [cm].

    Where a ray meets no wall (above a spout) it reaches as far as its neighbours do.
    """
    (x, y, z), (hx, hy, hz) = level.center_cm, level.half_extents_cm
    faces = np.concatenate([np.asarray(p.mesh().triangles, float) for p in walls])
    angles = 2.0 * np.pi * np.arange(RAYS) / RAYS
    along = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    widest = float(np.hypot(hx, hy))
    rings: list[Points] = []
    for height in np.linspace(z - hz, z + hz, RINGS):
        reach = np.minimum(_reach(faces, np.array([x, y, height]), along), widest)
        known = np.isfinite(reach) & (reach < widest)
        usual = float(np.median(reach[known])) if known.any() else min(hx, hy)
        reach = np.where(known, reach, min(usual, widest)) * WITHIN
        if rings:  # a body within its walls, whatever stands up from the bottom
            reach = np.maximum(reach, 1e-3)
        flat = np.array([x, y]) + reach[:, None] * along
        rings.append(np.column_stack([flat, np.full(RAYS, height)]))
    return forms.loft(np.array(rings))


def _reach(faces: Points, start: Points, along: Points) -> Points:
    """How far level rays go until they meet a face, inf where they meet none, shape [n].

    Args:
        faces: Triangles [cm], shape [f, 3, 3].
        start: Where all rays start [cm].
        along: Unit vectors in the plane, shape [n, 2].
    """
    near = (faces[:, :, 2].min(axis=1) <= start[2]) & (faces[:, :, 2].max(axis=1) >= start[2])
    a, b, c = (faces[near, k] - start for k in range(3))
    out = np.full(len(along), np.inf)
    for k, (dx, dy) in enumerate(along):
        # In the plane of the ray and the vertical: signed areas of its sides seen along the ray.
        side = np.stack([dx * p[:, 1] - dy * p[:, 0] for p in (a, b, c)])
        up = np.stack([p[:, 2] for p in (a, b, c)])
        weights = np.stack(
            [
                side[(i + 1) % 3] * up[(i + 2) % 3] - side[(i + 2) % 3] * up[(i + 1) % 3]
                for i in range(3)
            ]
        )
        total = weights.sum(axis=0)
        met = (np.abs(total) > 1e-12) & (
            np.all(weights >= -1e-9, axis=0) | np.all(weights <= 1e-9, axis=0)
        )
        if met.any():
            ahead = np.stack([dx * p[:, 0] + dy * p[:, 1] for p in (a, b, c)])
            far = (weights[:, met] * ahead[:, met]).sum(axis=0) / total[met]
            far = far[far > 1e-3]
            out[k] = far.min() if len(far) else np.inf
    return out
