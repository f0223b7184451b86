"""Fragments of a body: Voronoi cells of its collision shapes, seeded, closed and convex.

The same body and seed give the same fragments. A fragment is what of the shapes lies in one cell
and hangs together; the shares of mass are those of volume, changed as little as puts the common
centre of mass where the body's is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
import hashlib

import numpy as np

from esg.engines.breaking.corners import corners
from esg.engines.breaking.problems import inertia_of
from esg.engines.joints import Floats
from esg.engines.scene import Body, Shape, stand_in
from esg.units import quat_rotate

SAMPLES = 4000
"""Points by which seeds are spread over the volume."""
SMALLEST = 0.02
"""What is smaller than this share of a cell's volume is left out: a sliver has no proper hull."""
AIRIEST = 0.01
"""Least density of a fragment over the mean one, where the body's is not even."""
THINNEST_M = 2e-4
GAP_M = 1e-4
"""Collision shapes of fragments stay so far behind their own faces: what starts in touch along a
whole face has no side to part to in an engine."""
MOST_PARTS = 4
"""Fragments of a body of more parts collide as the hulls of what they are of: cells are convex, so
that hulls do not meet, and every shape more has to be asked whether it touches every other."""


def broken(body: Body, count: int) -> tuple[Body, tuple[Body, ...]]:
    """A body that breaks and its fragments.

    Args:
        body: With collision shapes and a `break_impulse`.
        count: Number of cells; shapes that do not hang together give more fragments.

    Returns:
        The body with the names of its fragments and the inertia that they have together, and the
        fragments where they lie in it.

    Raises:
        ValueError: If the shapes give fewer than two fragments.
    """
    parts = [corners(s) for s in body.shapes]
    cells = _cells(parts, _seeds(parts, count, _generator(body.name)))
    if len(cells) < 2:
        raise ValueError(f"{body.name!r} is too small or too thin to break into {count} fragments")
    measured = [[_solid(hull) for hull in cell] for cell in cells]
    volume = np.array([sum(v for v, _, _ in cell) for cell in measured])
    centre = np.array(
        [sum(v * c for v, c, _ in cell) / t for cell, t in zip(measured, volume, strict=True)]
    )
    mass = _shared(body.mass, volume, centre)
    pieces = [
        _piece(body, k, cell, solids, float(m), c)
        for k, (cell, solids, m, c) in enumerate(zip(cells, measured, mass, centre, strict=True))
    ]
    turns = np.broadcast_to([0.0, 0.0, 0.0, 1.0], (len(pieces), 4))
    inertia = inertia_of(pieces, mass, centre, turns)
    whole = replace(
        body,
        fragments=tuple(p.name for p in pieces),
        inertia=_tensor(inertia),
    )
    return whole, tuple(pieces)


def _generator(name: str) -> np.random.Generator:
    digest = hashlib.sha256(name.encode()).digest()
    return np.random.default_rng(int.from_bytes(digest[:8], "little"))


def _seeds(parts: Sequence[Floats], count: int, draw: np.random.Generator) -> Floats:
    """Points spread over the volume of convex parts, shape [count, 3]."""
    from scipy.spatial import ConvexHull

    hulls = [ConvexHull(p) for p in parts]
    share = np.array([h.volume for h in hulls])
    numbers = draw.multinomial(SAMPLES, share / share.sum())
    points: list[Floats] = []
    for part, hull, n in zip(parts, hulls, numbers.tolist(), strict=True):
        low, high = part.min(axis=0), part.max(axis=0)
        box = draw.uniform(low, high, (max(8 * n, 64), 3))
        inside = (box @ hull.equations[:, :3].T + hull.equations[:, 3] <= 0.0).all(axis=1)
        points.append(box[inside][:n])
    cloud = np.concatenate(points)
    seeds = cloud[draw.choice(len(cloud), min(count, len(cloud)), replace=False)]
    # Once to the middle of what is nearest to them: cells of like size, and still irregular.
    near = ((cloud[:, None] - seeds) ** 2).sum(axis=-1).argmin(axis=1)
    return np.array([cloud[near == k].mean(axis=0) for k in range(len(seeds))])


def _cells(parts: Sequence[Floats], seeds: Floats) -> list[list[Floats]]:
    """What of the parts lies in each Voronoi cell, in groups that hang together: hulls' corners."""
    from scipy.spatial import ConvexHull

    total = sum(ConvexHull(p).volume for p in parts)
    least = SMALLEST * total / len(seeds)
    out: list[list[Floats]] = []
    for k, seed in enumerate(seeds):
        found: list[Floats] = []
        for part in parts:
            points: Floats | None = part
            for j, other in enumerate(seeds):
                if j != k and points is not None:
                    normal = other - seed
                    points = _cut(points, normal, float(normal @ (seed + other)) / 2.0)
            if points is not None and ConvexHull(points).volume > least:
                found.append(points[ConvexHull(points).vertices])
        out += _together(found)
    return out


def _cut(points: Floats, normal: Floats, reach: float) -> Floats | None:
    """Corners of what of a convex body lies behind a plane; None if that has no volume."""
    from scipy.spatial import ConvexHull

    off = points @ normal - reach
    inside, outside = off <= 0.0, off > 0.0
    if inside.all():
        return points
    if not inside.any():
        return None
    a, b = points[inside], points[outside]
    at = (off[inside] / (off[inside][None] - off[outside][:, None]))[..., None]
    crossing = a[None] + at * (b[:, None] - a[None])
    kept = np.concatenate([a, crossing.reshape(-1, 3)])
    spread = np.linalg.svd(kept - kept.mean(axis=0), compute_uv=False)
    if spread[2] < THINNEST_M:
        return None
    return np.asarray(kept[ConvexHull(kept).vertices], np.float64)


def _together(hulls: list[Floats]) -> list[list[Floats]]:
    """Groups of hulls that touch, by the boxes around them."""
    groups: list[list[Floats]] = []
    for hull in hulls:
        touched = [g for g in groups if any(_beside(hull, other) for other in g)]
        groups = [g for g in groups if not any(g is t for t in touched)]
        groups.append([hull, *(h for g in touched for h in g)])
    return groups


def _beside(a: Floats, b: Floats) -> bool:
    gap = np.maximum(a.min(axis=0) - b.max(axis=0), b.min(axis=0) - a.max(axis=0))
    return bool(gap.max() < 5.0 * THINNEST_M)


def _solid(points: Floats) -> tuple[float, Floats, Floats]:
    """Volume [m^3], centre [m] and second moment about it [m^5] of a convex body."""
    from esg.engines.shapes import hull

    vertices, faces = hull(points)
    a, b, c = (vertices[faces[:, k]] - vertices.mean(axis=0) for k in range(3))
    det = np.einsum("ij,ij->i", a, np.cross(b, c))
    volume = float(det.sum() / 6.0)
    centre = (det[:, None] * (a + b + c)).sum(axis=0) / (24.0 * volume)
    total = a + b + c
    outer = sum(np.einsum("ni,nj,n->ij", p, p, det) for p in (a, b, c, total))
    second = outer / 120.0 - volume * np.outer(centre, centre)
    return volume, centre + vertices.mean(axis=0), second


def _shared(mass: float, volume: Floats, centre: Floats) -> Floats:
    """Masses by volume, changed the least so that their centre is the origin [kg], shape [n].

    Raises:
        ValueError: If the origin lies outside of what the centres enclose.
    """
    from scipy.optimize import lsq_linear

    plain = volume / volume.sum()
    scale = float(np.abs(centre).max())
    rows = np.concatenate([np.ones((1, len(plain))), centre.T / scale]) * plain
    goal = np.array([1.0, 0.0, 0.0, 0.0]) - rows.sum(axis=1)
    factor = 1.0 + np.linalg.pinv(rows) @ goal
    if factor.min() < 0.1:
        found = lsq_linear(rows, goal, (-0.9, 9.0))
        factor = 1.0 + found.x
    if _astray(rows, factor) > 1e-9:
        # Leaves and stalks are mostly air.
        found = lsq_linear(rows, goal, (AIRIEST - 1.0, 9.0), method="bvls")
        factor = 1.0 + found.x
    if _astray(rows, factor) > 1e-9:
        raise ValueError("the centre of mass lies outside of the fragments")
    return np.asarray(mass * plain * factor, np.float64)


def _astray(rows: Floats, factor: Floats) -> float:
    """How far shares of mass are from one mass about the origin, shares of the largest way."""
    return float(np.abs(rows @ factor - [1.0, 0.0, 0.0, 0.0]).max())


def _piece(
    body: Body,
    number: int,
    cell: Sequence[Floats],
    solids: Sequence[tuple[float, Floats, Floats]],
    mass: float,
    centre: Floats,
) -> Body:
    """A fragment where it lies in its body, its frame along the body's."""
    volume = sum(v for v, _, _ in solids)
    second = np.zeros((3, 3))
    for v, c, own in solids:
        second += own + v * np.outer(c - centre, c - centre)
    second *= mass / volume
    points = np.concatenate(list(cell)) - centre
    half = np.abs(points).max(axis=0)
    turned = quat_rotate(np.asarray(body.quaternion, float), centre)
    x, y, z = (np.asarray(body.position) + turned).tolist()
    return stand_in(
        body,
        name=f"{body.name}_piece_{number + 1}",
        static=False,
        mass=mass,
        inertia=_tensor(np.trace(second) * np.eye(3) - second),
        shapes=tuple(_convex(hull - centre) for hull in _collision(cell, len(body.shapes))),
        position=(x, y, z),
        wheeled=False,
        tyre_friction=0.0,
        tyre_drop=0.0,
        tyre_foot=0.0,
        roll_radius=0.0,
        origin_offset=(0.0, 0.0, 0.0),
        half_extents=(float(half[0]), float(half[1]), float(half[2])),
        mesh="",
        wheels=(),
        break_impulse=None,
        fragments=(),
    )


def _collision(cell: Sequence[Floats], parts: int) -> list[Floats]:
    """Corners of the convex shapes that a fragment collides as."""
    from scipy.spatial import ConvexHull

    if parts <= MOST_PARTS or len(cell) == 1:
        return list(cell)
    points = np.concatenate(list(cell))
    return [points[ConvexHull(points).vertices]]


def _convex(points: Floats) -> Shape:
    points = _behind(points)
    half = np.abs(points).max(axis=0)
    return Shape(
        "convex",
        (float(half[0]), float(half[1]), float(half[2])),
        vertices=tuple((float(x), float(y), float(z)) for x, y, z in points),
    )


def _behind(points: Floats) -> Floats:
    """Corners of a convex body whose faces are `GAP_M` further in."""
    from scipy.spatial import ConvexHull, HalfspaceIntersection

    faces = np.unique(ConvexHull(points).equations.round(12), axis=0)
    middle = points.mean(axis=0)
    room = float(-(faces[:, :3] @ middle + faces[:, 3]).max())
    faces[:, 3] += min(GAP_M, 0.2 * room)
    found = HalfspaceIntersection(faces, middle).intersections
    return np.asarray(found[ConvexHull(found).vertices], np.float64)


def _tensor(m: Floats) -> tuple[tuple[float, float, float], ...]:
    m = 0.5 * (m + m.T)
    return tuple((float(a), float(b), float(c)) for a, b, c in m)
