"""What is wrong with a scene's breakable bodies."""

from __future__ import annotations

from collections.abc import Sequence
import math

import numpy as np

from esg.engines.breaking.corners import corners
from esg.engines.joints import Floats
from esg.engines.scene import Body, Shape, SimScene
from esg.units import quat_inverse, quat_multiply, quat_rotate

EXACT = 1e-6
"""Mass, centre of mass and inertia of the fragments are those of the whole, so far."""
OVERLAP_M = 1e-3
"""Fragments may reach into each other by so much."""


def breaking_problems(scene: SimScene) -> list[str]:
    """Everything that is wrong with what breaks, each with its place, value and remedy."""
    bodies = {b.name: b for b in scene.bodies}
    joined = {n for j in scene.joints for n in (j.child, j.parent)}
    out: list[str] = []
    owner: dict[str, str] = {}
    for i, body in enumerate(scene.bodies):
        here = f"/bodies/{i}"
        if body.break_impulse is None:
            if body.fragments:
                out.append(f"{here}/break_impulse: {body.name!r} has fragments and none; give it")
            continue
        if not (math.isfinite(body.break_impulse) and body.break_impulse > 0.0):
            out.append(
                f"{here}/break_impulse: {body.break_impulse!r} N s; use a positive, finite number"
            )
        if not body.fragments:
            continue
        missing = [n for n in body.fragments if n not in bodies]
        taken = [n for n in body.fragments if n in owner or n == body.name]
        if missing or taken or len(body.fragments) < 2:
            out.append(
                f"{here}/fragments: {[*missing, *taken] or list(body.fragments)} cannot be; name "
                "two bodies or more that are fragments of nothing else"
            )
            continue
        owner |= dict.fromkeys(body.fragments, body.name)
        if body.name in joined or joined & {*body.fragments}:
            out.append(f"{here}: {body.name!r} is joined and cannot break; leave out one of both")
        pieces = [bodies[n] for n in body.fragments]
        still = [b.name for b in pieces if b.static or not b.collides or b.fragments]
        if still:
            out.append(f"{here}/fragments: {still} must move, collide and break no further")
            continue
        out += _sums(here, body, pieces)
        out += _overlaps(here, body, pieces)
    return out


def _sums(here: str, body: Body, pieces: Sequence[Body]) -> list[str]:
    """Mass, centre of mass and inertia."""
    mass = np.array([b.mass for b in pieces])
    total = float(mass.sum())
    if abs(total - body.mass) > EXACT * body.mass:
        return [
            f"{here}/fragments: together {total:.9g} kg, the body {body.mass:.9g} kg; scale their "
            "masses to the same sum"
        ]
    back = quat_inverse(np.asarray(body.quaternion, float))
    arms = quat_rotate(back, np.array([b.position for b in pieces]) - np.asarray(body.position))
    size = max(body.half_extents)
    off = float(np.linalg.norm(mass @ arms / total))
    if off > EXACT * size:
        return [
            f"{here}/fragments: their centre of mass is {off:.3g} m off the body's; move them, or "
            "share out the mass in another way"
        ]
    turns = quat_multiply(back, np.array([b.quaternion for b in pieces]))
    inertia = inertia_of(pieces, mass, arms, turns)
    told = np.array(body.inertia, float)
    if not body.static and np.abs(inertia - told).max() > EXACT * np.abs(told).max():
        return [
            f"{here}/inertia: {np.diag(told).tolist()} kg m^2, that of the fragments together "
            f"{np.diag(inertia).tolist()}; state theirs"
        ]
    return []


def inertia_of(pieces: Sequence[Body], mass: Floats, arms: Floats, turns: Floats) -> Floats:
    """Inertia of bodies together about the origin of their frame [kg m^2], shape [3, 3].

    Args:
        pieces: The bodies.
        mass: Their masses [kg], shape [n].
        arms, turns: Their places in that frame, shape [n, 3] and [n, 4].
    """
    out = np.zeros((3, 3))
    for body, m, arm, turn in zip(pieces, mass, arms, turns, strict=True):
        axes = quat_rotate(turn, np.eye(3)).T
        out += axes @ np.array(body.inertia, float) @ axes.T
        out += m * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    return out


def _overlaps(here: str, body: Body, pieces: Sequence[Body]) -> list[str]:
    """The deepest overlap of two fragments, if it is too deep."""
    placed = [[_faces(s, b) for s in b.shapes] for b in pieces]
    worst, pair = 0.0, ("", "")
    for i, a in enumerate(placed):
        for j in range(i):
            for one in a:
                for other in placed[j]:
                    depth = _depth(one, other, worst)
                    if depth > worst:
                        worst, pair = depth, (pieces[j].name, pieces[i].name)
    if worst <= OVERLAP_M:
        return []
    return [
        f"{here}/fragments: {pair[0]!r} and {pair[1]!r} overlap by {1000.0 * worst:.1f} mm; shrink "
        f"one of them to at most {1000.0 * OVERLAP_M:g} mm"
    ]


def _faces(shape: Shape, body: Body) -> tuple[Floats, Floats, Floats]:
    """Corners [n, 3], unit outer normals [m, 3] and reaches [m] of a convex shape in the world."""
    from scipy.spatial import ConvexHull

    points = corners(shape)
    q = np.asarray(body.quaternion, float)
    points = quat_rotate(np.broadcast_to(q, (len(points), 4)), points) + np.asarray(body.position)
    faces = np.unique(ConvexHull(points).equations.round(9), axis=0)
    return points, faces[:, :3], -faces[:, 3]


def _depth(
    a: tuple[Floats, Floats, Floats], b: tuple[Floats, Floats, Floats], least: float
) -> float:
    """Width of what two convex shapes have in common: of the largest ball in it [m]."""
    from scipy.optimize import linprog

    for (points, normals, _), (others, _, _) in ((a, b), (b, a)):
        reach = (points @ normals.T).max(axis=0) - (others @ normals.T).min(axis=0)
        if float(reach.min()) <= max(least, OVERLAP_M):
            return 0.0
    normals, reach = np.concatenate([a[1], b[1]]), np.concatenate([a[2], b[2]])
    rows = np.concatenate([normals, np.ones((len(normals), 1))], axis=1)
    free = [(None, None)] * 3 + [(0.0, None)]
    found = linprog([0.0, 0.0, 0.0, -1.0], rows, reach, bounds=free)
    return 2.0 * float(found.x[3]) if found.success else 0.0
