"""The way of who climbs: along the side of a thing, at its surface all the way.

All of it is planar: u leads to the thing, z up, and the tilt is how far the nose is turned up.
Who is taller than long goes up upright, its front at the thing; who is longer than tall turns its
belly to it. Both follow what `outlines` measures of the thing's collision shapes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
import math
from typing import Literal

import numpy as np

from esg.dynamics.story.outlines import SLAB_M, Floats, Outline, outline

Course = Literal["up", "down", "onto", "over"]
GAP_M = 0.012
"""Left between a climber and what it climbs."""
BEFORE_M = 0.35
"""Gap between who is about to climb and the thing."""
OVERHANG_M, BULGE = 0.03, 0.35
"""What juts out so far is not climbed past: the crown of a tree. What is got onto may bulge by so
much of its height: a boulder."""
HANDS = 0.7
"""Share of a climber's height that its hands reach up: so far below the top its feet stop."""
LEAST_SHARE = 0.62
"""Share of a thing's height that who climbs it gets up at least, where nothing juts out."""
HIGHEST_M = 3.0
"""Nobody climbs higher, unless it is told how high, or to the top."""
LONGEST_S = 7.0
"""How long somebody climbs where nothing says how far."""
TURNS_RAD_S = math.radians(110.0)
"""How fast who goes on all fours turns up and down."""
LONG = 1.15
"""Over its height: the length of who goes on all fours."""
TOP_M = 0.06
"""How far from the edge who has climbed onto something stands, its back to it."""
ROOM = 0.9
"""Least depth of a top over the length of who stands on it and is let go."""
WALKED_DEG = 55.0
"""Slopes that are gone down face forward: stairs, hills."""
_REACHED = 0.5
"""Share of its length up to which who goes on all fours reaches over an edge."""
_FINE_M = 0.008
"""How far a way may leave the surface where it is made straight."""
_CURVED = math.radians(50.0)
"""Corners of a way that are sharper are passed at rest."""


@dataclass(frozen=True)
class Pose:
    """One pose of a climber: of its centre of mass [m], tilt of its nose [rad]."""

    u: float
    z: float
    tilt: float


@dataclass(frozen=True)
class Climber:
    """Who climbs.

    Args:
        clouds: Its collision shapes around its centre of mass [m]: along, across, up.
        speed: Along the surface [m/s].
    """

    clouds: tuple[Floats, ...]
    speed: float

    @property
    def points(self) -> Floats:
        return np.concatenate(self.clouds)

    @property
    def foot(self) -> float:
        """How far its lowest point is below its centre of mass [m]."""
        return -float(self.points[:, 2].min())

    @property
    def height(self) -> float:
        return float(np.ptp(self.points[:, 2]))

    @property
    def length(self) -> float:
        return float(np.ptp(self.points[:, 0]))

    @property
    def front(self) -> float:
        return float(self.points[:, 0].max())

    @property
    def back(self) -> float:
        return -float(self.points[:, 0].min())

    @property
    def flat(self) -> bool:
        """Whether it goes on all fours, its belly to the surface."""
        return self.length > LONG * self.height

    def turned_round(self) -> Climber:
        """The same, its back in front."""
        return replace(self, clouds=tuple(c * np.array([-1.0, 1.0, 1.0]) for c in self.clouds))

    def lowest(self, tilt: float, normal: tuple[float, float]) -> float:
        """Least coordinate of its shapes along a direction of the plane when it is tilted [m]."""
        u, z = self.points[:, 0], self.points[:, 2]
        cos, sin = math.cos(tilt), math.sin(tilt)
        return float((normal[0] * (cos * u - sin * z) + normal[1] * (sin * u + cos * z)).min())


def climb(
    who: Climber, thing: Sequence[Floats], course: Course, rise: float | None = None
) -> list[Pose] | None:
    """The poses of a climb; None where there is nothing to climb.

    Args:
        who: Who climbs.
        thing: The collision shapes of the thing, as points [m] in the axes along the way, across
            and up, the ground at 0.
        course: Up and held there, down, up and onto its top, over it.
        rise: How high the feet get [m] on a way up or down; None where that is open.
    """
    half = max(float(np.abs(c[:, 1]).max()) for c in who.clouds)
    sides = outline(thing, 0.0, half)
    seen = np.flatnonzero(np.isfinite(sides.near))
    if not len(seen):
        return None
    if seen[0]:  # what ends above the ground goes on down to it: a rope
        sides.near[: seen[0]], sides.far[: seen[0]] = sides.near[seen[0]], sides.far[seen[0]]
    if course in ("up", "down"):
        found = _up(who, sides, rise)
        return found if course == "up" or found is None else found[::-1]
    up = _onto(who, sides)
    if up is None or course == "onto":
        return up
    mirrored = replace(sides, near=-sides.far, far=-sides.near)
    down = _onto(who.turned_round(), mirrored, crosses=True)
    first = _onto(who, sides, crosses=True)
    if down is None or first is None:
        return None
    return first + [Pose(-p.u, p.z, -p.tilt) for p in reversed(down)]


def walk_down(who: Climber, thing: Sequence[Floats]) -> list[Pose] | None:
    """From the top of a thing down its slope, face forward: u leads away from it."""
    half = max(float(np.abs(c[:, 1]).max()) for c in who.clouds)
    sides = outline(thing, 0.0, half)
    up = _onto(who.turned_round(), replace(sides, near=-sides.far, far=-sides.near))
    return None if up is None else [Pose(-p.u, p.z, -p.tilt) for p in reversed(up)]


def stands_on_top(who: Climber, thing: Sequence[Floats]) -> bool:
    """Whether the top of a thing has room for most of who has climbed onto it."""
    sides = outline(thing, 0.0)
    room = float(sides.far[-1] - sides.near[-1])
    return room >= ROOM * (who.front + who.back)


def slope_deg(thing: Sequence[Floats]) -> float:
    """How steep the side of a thing is from its foot to its top [degrees]; 90 for a wall."""
    sides = outline(thing, 0.0)
    seen = np.flatnonzero(np.isfinite(sides.near))
    if not len(seen):
        return 90.0
    run = float(sides.near[seen[-1]] - sides.near[: seen[-1] + 1].min())
    return math.degrees(math.atan2(sides.top, max(run, 0.0)))


def _up(who: Climber, sides: Outline, rise: float | None) -> list[Pose] | None:
    return _up_flat(who, sides, rise) if who.flat else _up_upright(who, sides, rise)


def _onto(who: Climber, sides: Outline, crosses: bool = False) -> list[Pose] | None:
    if who.flat:
        return _onto_flat(who, sides, crosses)
    return _onto_upright(who, sides, crosses)


def _wanted(who: Climber, sides: Outline, rise: float | None) -> float:
    """How high feet get [m]."""
    if rise is not None:
        return min(rise, sides.top)
    height = who.length if who.flat else who.height
    high = min(max(sides.top - HANDS * height, LEAST_SHARE * sides.top), HIGHEST_M)
    return min(high, max(0.8 * LONGEST_S * who.speed, 1.2 * max(who.length, who.height)))


# -- upright ---------------------------------------------------------------------------------


def _reach(who: Climber, sides: Outline) -> Floats:
    """How far its centre gets with its feet at every slab's floor [m], shape [k]."""
    body = outline(who.clouds, -who.foot)
    out = np.full(len(sides.near), np.inf)
    for j, front in enumerate(body.far):
        if np.isfinite(front) and j < len(out):
            out[: len(out) - j] = np.minimum(out[: len(out) - j], sides.near[j:] - front)
    return out - GAP_M


def _start(reach: Floats, who: Climber) -> Pose:
    return Pose(float(reach[0]) - BEFORE_M, who.foot + 0.002, 0.0)


def _follow(who: Climber, reach: Floats) -> list[Pose]:
    """The way along a reach that never goes back."""
    held = np.minimum.accumulate(reach[::-1])[::-1]
    points = [(float(held[0]), 0.0)]
    for k in range(1, len(held)):
        if held[k] > held[k - 1] + 0.02:  # over an edge: first up, then on
            points.append((float(held[k - 1]), SLAB_M * k))
        points.append((float(held[k]), SLAB_M * k))
    kept = _straightened(points)
    return [Pose(u - _FINE_M, z + who.foot + 0.002, 0.0) for u, z in kept]


def _up_upright(who: Climber, sides: Outline, rise: float | None) -> list[Pose] | None:
    reach = _reach(who, sides)
    low = np.flatnonzero(reach < reach[0] - OVERHANG_M)
    last = min(round(_wanted(who, sides, rise) / SLAB_M), len(reach) - 1)
    last = min(last, int(low[0]) - 1) if len(low) else last
    if last < 2:
        return None
    way = _follow(who, reach[: last + 1])
    return [_start(reach[:1], who), *way]


def _onto_upright(who: Climber, sides: Outline, crosses: bool) -> list[Pose] | None:
    reach = _reach(who, sides)
    if (reach < reach[0] - BULGE * sides.top).any():
        return None
    way = _follow(who, reach)
    last = way[-1]
    high = max(sides.top + SLAB_M + who.foot, way[-1].z)
    edge = float(sides.near[-1])
    stands = edge + who.back + TOP_M
    middle = 0.5 * (edge + float(sides.far[-1]))
    if crosses or stands > float(sides.far[-1]):
        stands = middle
    stands = max(stands, last.u)
    over = [Pose(last.u, high, 0.0), Pose(stands, high, 0.0)]
    if not crosses:
        over.append(Pose(stands, sides.top + who.foot + 0.003, 0.0))
    return [_start(reach[:1], who), *way, *over]


# -- on all fours ----------------------------------------------------------------------------


def _side(sides: Outline, jut: float) -> list[tuple[float, float]]:
    """The side of a thing as a belly passes along it: convex, from its foot up, (u, z) [m]."""
    near = sides.near.copy()
    juts = np.flatnonzero(near < near[np.isfinite(near)][0] - jut)
    if len(juts):
        near = near[: int(juts[0])]
    seen = np.flatnonzero(np.isfinite(near))
    if len(seen) < 3:
        return []
    foot = float(near[seen].min())
    points = [(foot, 0.0)]
    points += [(float(near[k]), SLAB_M * (k + 1)) for k in seen]
    hull: list[tuple[float, float]] = []
    for p in points:  # heights rise; what lies behind the line between its neighbours goes
        while len(hull) > 1 and _behind(hull[-2], hull[-1], p):
            hull.pop()
        hull.append(p)
    return _straightened(hull)


def _passable(who: Climber, side: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """A side without a first edge that a body reaches over: the lowest step of stairs."""
    while len(side) > 2 and side[1][1] < _REACHED * who.length:
        (u1, z1), (u2, z2) = side[1:3]
        if z2 - z1 < 1e-6:
            break
        side = [(u1 - z1 * (u2 - u1) / (z2 - z1), 0.0), *side[2:]]
    return side


def _behind(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> bool:
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]) >= -1e-9


def _leaves_ground(who: Climber, side: list[tuple[float, float]]) -> list[Pose]:
    """From level ground to its belly along the lowest part of a side."""
    tilt = _angle(side[0], side[1])
    normal = (-math.sin(tilt), math.cos(tilt))
    poses: list[Pose] = []
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        now = share * tilt
        z = GAP_M - who.lowest(now, (0.0, 1.0))
        out = GAP_M - who.lowest(now, normal)
        u = side[0][0] - (out - normal[1] * (z - side[0][1])) / max(math.sin(tilt), 1e-6)
        poses.append(Pose(u, z, now))
    first = replace(poses[0], u=poses[0].u - 0.5 * BEFORE_M, z=poses[0].z - GAP_M + 0.002)
    return [first, *poses]


def _angle(a: tuple[float, float], b: tuple[float, float]) -> float:
    return math.atan2(b[1] - a[1], b[0] - a[0])


def _along(who: Climber, side: list[tuple[float, float]], until: float) -> list[Pose]:
    """Along a convex side until its centre is level with a height [m]."""
    out = _leaves_ground(who, side)
    depth = who.foot + GAP_M
    for k, (a, b) in enumerate(pairwise(side)):
        tilt = _angle(a, b)
        if k:
            before = _angle(side[k - 1], a)
            out += [
                Pose(a[0] - depth * math.sin(t), a[1] + depth * math.cos(t), t)
                for t in np.linspace(before, tilt, 3)
            ]
        end = Pose(b[0] - depth * math.sin(tilt), b[1] + depth * math.cos(tilt), tilt)
        if (end.z > until and k == len(side) - 2) or b[1] > until:
            share = max((until - out[-1].z) / max(end.z - out[-1].z, 1e-9), 0.0)
            if share < 1.0:
                end = replace(end, u=out[-1].u + share * (end.u - out[-1].u),
                              z=out[-1].z + share * (end.z - out[-1].z))  # fmt: skip
        if end.z > out[-1].z + 1e-4:
            out.append(end)
        if b[1] > until:
            break
    return out


def _up_flat(who: Climber, sides: Outline, rise: float | None) -> list[Pose] | None:
    side = _passable(who, _side(sides, OVERHANG_M))
    if len(side) < 2:
        return None
    top = side[-1][1]
    wanted = _wanted(who, sides, rise) + 0.5 * who.length
    until = min(wanted, top - 0.55 * who.length)
    found = _along(who, side, until)
    return found if found[-1].z - found[0].z > 0.25 * who.length else None


def _onto_flat(who: Climber, sides: Outline, crosses: bool) -> list[Pose] | None:
    side = _passable(who, _side(sides, BULGE * sides.top))
    if len(side) < 2 or side[-1][1] < sides.top - 2.0 * SLAB_M:
        return None
    depth = who.foot + GAP_M
    out, edge = _along(who, side, math.inf), side[-1]
    out += [
        Pose(edge[0] - depth * math.sin(t), edge[1] + depth * math.cos(t), float(t))
        for t in np.linspace(out[-1].tilt, 0.0, 4)[1:]
    ]
    stands, far = edge[0] + who.back + TOP_M, float(sides.far[-1])
    middle = 0.5 * (edge[0] + far)
    if crosses or stands > far:
        stands = middle
    low = out[-1].z - (0.0 if crosses else GAP_M - 0.002)
    return [*out, Pose(max(stands, out[-1].u), low, 0.0)]


# -- times -----------------------------------------------------------------------------------


def _straightened(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The same way with fewer corners: none is farther from it than `_FINE_M`."""
    if len(points) < 3:
        return points
    keep, todo = {0, len(points) - 1}, [(0, len(points) - 1)]
    p = np.array(points)
    while todo:
        a, b = todo.pop()
        if b - a < 2:
            continue
        line = p[b] - p[a]
        size = max(float(np.hypot(*line)), 1e-9)
        off = np.abs((p[a + 1 : b] - p[a]) @ np.array([-line[1], line[0]])) / size
        if float(off.max()) > _FINE_M:
            k = a + 1 + int(off.argmax())
            keep.add(k)
            todo += [(a, k), (k, b)]
    return [points[k] for k in sorted(keep)]


def times(poses: Sequence[Pose], speed: float) -> list[float]:
    """When a climber is in each of its poses [s], from 0: whole sixtieths of a second.

    Args:
        poses: Of a climb.
        speed: Along the way [m/s].
    """
    out = [0.0]
    for a, b in pairwise(poses):
        lasts = max(math.hypot(b.u - a.u, b.z - a.z) / speed, abs(b.tilt - a.tilt) / TURNS_RAD_S)
        out.append(out[-1] + max(math.ceil(60.0 * lasts), 2) / 60.0)
    if out[-1] > 1.4 * LONGEST_S:  # farther away than that it goes faster
        return times(poses, speed * out[-1] / LONGEST_S)
    return out


def velocities(poses: Sequence[Pose], at: Sequence[float]) -> list[tuple[float, float]]:
    """How fast it moves in each pose [m/s], along u and z: at rest at ends and sharp corners."""
    out = [(0.0, 0.0)]
    for k in range(1, len(poses) - 1):
        a, b, c = poses[k - 1 : k + 2]
        first, second = (b.u - a.u, b.z - a.z), (c.u - b.u, c.z - b.z)
        one, two = math.hypot(*first), math.hypot(*second)
        bend = math.acos(
            min(1.0, max(-1.0, (first[0] * second[0] + first[1] * second[1])
                         / max(one * two, 1e-12)))
        )  # fmt: skip
        if one < 1e-6 or two < 1e-6 or bend > _CURVED:
            out.append((0.0, 0.0))
            continue
        slow = min(one / (at[k] - at[k - 1]), two / (at[k + 1] - at[k]))
        way = (first[0] / one + second[0] / two, first[1] / one + second[1] / two)
        size = math.hypot(*way)
        out.append((slow * way[0] / size, slow * way[1] / size))
    return [*out, (0.0, 0.0)]
