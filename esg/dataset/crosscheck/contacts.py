"""Contacts of a replay against its shapes: who is said to touch must be where the other is.

Shapes come from the manifest, poses from table `trajectories`. Its frames are further apart than
the steps of the engine, so a pose at the time of a contact is reached from the frame before by the
velocities there, or from the frame after, whichever fits: the blow is in between.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from esg.dataset.crosscheck.checks import Residuals

Floats = NDArray[np.floating]
UNIT, LIMIT_M = "m", 0.02
CONTACTS = 60
"""Of a replay: the first of every pair, and others by chance."""
_ROUND = 32
_EPS_M = 1e-4


@dataclass(frozen=True)
class Hull:
    """A convex shape: the hull of some points, and all within a radius of it.

    Args:
        points: In the body's axes [m], shape [n, 3].
        radius: [m].
    """

    points: Floats
    radius: float


def hull_of(shape: Mapping[str, Any]) -> Hull:
    """A shape of a manifest (esg.engines.scene.Shape)."""
    turn = Rotation.from_quat(shape["quaternion"])
    size = np.array(shape["size"], float)
    kind = shape["kind"]
    radius = 0.0
    if kind == "sphere":
        points, radius = np.zeros((1, 3)), float(size[0])
    elif kind == "capsule":
        points, radius = np.array([[0, 0, -size[2]], [0, 0, size[2]]]), float(size[0])
    elif kind == "cylinder":
        angle = np.arange(_ROUND) * 2 * np.pi / _ROUND
        ring = np.stack([np.cos(angle), np.sin(angle), np.ones(_ROUND)], axis=-1)
        points = np.concatenate([ring, ring * (1, 1, -1)]) * (size[0], size[0], size[2])
    elif kind == "box":
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
        points = signs * size
    else:
        points = np.array(shape["vertices"], float)
    return Hull(turn.apply(points) + np.array(shape["position"], float), radius)


def gap(a: Floats, b: Floats, *, within: float = np.inf) -> float:
    """Distance of the hulls of two sets of points [m], 0 if they meet.

    Wolfe's algorithm for the point of least norm in the hull of all differences (Wolfe, Finding
    the nearest point in a polytope, Mathematical Programming 11, 1976).

    Args:
        a, b: Shapes [n, 3] and [m, 3].
        within: A larger distance need not be exact: it is told as it is found to be larger.
    """
    corral = np.array([a[0] - b[0]])
    weights = np.ones(1)
    nearest = corral[0]
    for _ in range(64):
        support = a[np.argmin(a @ nearest)] - b[np.argmax(b @ nearest)]
        square = float(nearest @ nearest)
        below = float(nearest @ support)
        if square - below <= 1e-9 + _EPS_M * np.sqrt(square) or square < _EPS_M**2:
            break
        if below > 0 and below / np.sqrt(square) > within:
            return below / float(np.sqrt(square))
        corral, weights = np.vstack([corral, support]), np.append(weights, 0.0)
        corral, weights = _nearest_in(corral, weights)
        nearest = weights @ corral
    return float(np.linalg.norm(nearest))


def _nearest_in(corral: Floats, weights: Floats) -> tuple[Floats, Floats]:
    """The point of least norm in the hull of few points: those that carry it, and their weights."""
    while True:
        n = len(corral)
        system = np.zeros((n + 1, n + 1))
        system[:n, :n], system[n, :n], system[:n, n] = corral @ corral.T, 1.0, 1.0
        flat = np.linalg.lstsq(system, np.append(np.zeros(n), 1.0), rcond=None)[0][:n]
        if (flat > 1e-12).all():
            return corral, flat
        falling = flat <= 1e-12
        drop = weights[falling] - flat[falling]
        share = float(np.min(np.where(drop > 0, weights[falling] / np.maximum(drop, 1e-30), 1.0)))
        weights = weights + min(1.0, share) * (flat - weights)
        kept = weights > 1e-12
        if kept.all():
            kept[np.argmin(weights)] = False
        corral, weights = corral[kept], weights[kept] / weights[kept].sum()


def contact_gaps(
    row: Mapping[str, Any], manifest: Mapping[str, Any], rng: np.random.Generator
) -> Residuals:
    """Distances of those that are said to touch, at the time they do [m].

    Args:
        row: Of table `trajectories`.
        manifest: Of the scene.
        rng: Draws contacts where there are many.
    """
    names = list(row["bodies"])
    shapes = {b["name"]: [hull_of(s) for s in b["shapes"]] for b in manifest["bodies"]}
    times = np.asarray(row["contact_time_s"], float)
    pairs = np.stack([row["contact_a"], row["contact_b"]], axis=-1).astype(np.int64)
    known = [
        i
        for i, pair in enumerate(pairs)
        if all(body < 0 or shapes.get(names[body]) for body in pair) and pair.max() >= 0
    ]
    pose = partial(_pose, _motion(row))
    values: list[float] = []
    where: list[tuple[int, int]] = []
    for i in _chosen(pairs, known, rng):
        frame, poses = pose(float(times[i]))
        best = np.inf
        for position, turn in poses:
            hulls = [
                [Hull(turn[body].apply(h.points) + position[body], h.radius)
                 for h in shapes[names[body]]]
                for body in pairs[i] if body >= 0
            ]  # fmt: skip
            best = min(best, _apart(hulls))
        values.append(best)
        where.append((frame, int(pairs[i].max())))
    return Residuals(np.array(values), np.array(where, np.int64).reshape(-1, 2))


def _chosen(pairs: NDArray[Any], known: Sequence[int], rng: np.random.Generator) -> list[int]:
    first: dict[tuple[int, int], int] = {}
    for i in known:
        low, high = sorted(int(b) for b in pairs[i])
        first.setdefault((low, high), i)
    begun = sorted(first.values())[:CONTACTS]
    rest = sorted(set(known) - set(begun))
    return sorted([*begun, *rng.permutation(rest)[: CONTACTS - len(begun)].astype(int).tolist()])


def _motion(row: Mapping[str, Any]) -> dict[str, Floats]:
    n, m = int(row["n_frames"]), len(row["bodies"])
    shapes = {
        "position_m": 3, "quaternion_xyzw": 4, "linear_velocity_mps": 3,
        "angular_velocity_radps": 3,
    }  # fmt: skip
    out = {k: np.asarray(row[k], float).reshape(n, m, w) for k, w in shapes.items()}
    return {**out, "time_s": np.asarray(row["time_s"], float)}


def _pose(motion: Mapping[str, Floats], time: float) -> tuple[int, list[tuple[Floats, Any]]]:
    """Poses of all bodies at a time, by the frames before and after it."""
    after = int(np.clip(np.searchsorted(motion["time_s"], time), 1, len(motion["time_s"]) - 1))
    out: list[tuple[Floats, Any]] = []
    for frame in (after - 1, after):
        dt = time - motion["time_s"][frame]
        turn = Rotation.from_rotvec(dt * motion["angular_velocity_radps"][frame])
        out.append(
            (
                motion["position_m"][frame] + dt * motion["linear_velocity_mps"][frame],
                turn * Rotation.from_quat(motion["quaternion_xyzw"][frame]),
            )
        )
    return after - 1, out


def _apart(hulls: Sequence[Sequence[Hull]]) -> float:
    """Least distance between the shapes of two bodies, or of one and the ground [m]."""
    if len(hulls) == 1:
        return max(0.0, min(float(h.points[:, 2].min()) - h.radius for h in hulls[0]))
    best = np.inf
    for one in hulls[0]:
        for other in hulls[1]:
            radii = one.radius + other.radius
            found = gap(one.points, other.points, within=best + radii) - radii
            best = min(best, max(0.0, found))
            if best == 0.0:
                return 0.0
    return best
