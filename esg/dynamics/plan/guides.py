"""The way of what a hand or a crane moves: off its support, clear of everything, onto its goal."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.choreography.falling.throws import opens_upwards
from esg.dynamics.choreography.handling import SETTLES_S
from esg.dynamics.plan.aim import body_bounds, shape_bounds
from esg.dynamics.plan.cast import Cast
from esg.dynamics.plan.liquids import waterline
from esg.dynamics.story.stagecraft import top_surface
from esg.dynamics.story.story import Phase, bounds, is_climb, is_posture
from esg.engines.program import GuideAlong, Vec
from esg.engines.scene import Body
from esg.graph.models import EdgeEvent, NodeEvent, Predicate, RegionType
from esg.units import quat_rotate

Floats = NDArray[np.float64]

LIFT_M, LIFT_SHARE = 0.15, 0.5
"""Gap under what is carried: so much, and so much of its height."""
HELD_M = 1.0
"""Gap over a target above which something is held."""
SET_DOWN_M = 0.004
"""What is set down is let go so far above its goal."""
BESIDE_M = 0.05
"""Room on every side of what is carried past or set down beside something."""
CLEARANCE_M, SLACK_M = 0.01, 0.004
"""Under what is drawn out of a side; what two boxes may overlap by and not meet."""
HAND_MPS, CRANE_MPS, HEAVY_KG = 0.7, 0.4, 50.0
"""Mean speed of what is carried: light and heavy things."""
SHORTEST_LEG_S = 0.5
LONGEST_WAY_S, TAKEN_OUT_S = 6.0, 1.0
"""What has farther to go is moved faster; so is what is taken out of a deep vessel, all of whose
way is in the scene."""
GAPS_M = (0.06, 0.1, 0.16, 0.25, 0.4, 0.6)
"""What is set down beside something is so far away from it, the first that is free."""
_SIDES = {
    Predicate.LEFT_OF: ((1.0, 0.0),),
    Predicate.RIGHT_OF: ((-1.0, 0.0),),
    Predicate.IN_FRONT_OF: ((0.0, 1.0),),
    Predicate.BEHIND: ((0.0, -1.0),),
    Predicate.ENDS_NEAR: ((0.0, 1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, -1.0)),
}
"""Where it is set down then, in the viewer's directions: left is +X, in front +Y."""
STEPS = 9
"""Places tried along each side of a support."""
AROUND_M = 3.0
"""How far away something is set down on the ground."""


@dataclass(frozen=True)
class Way:
    """Points [m] that a body's centre of mass passes at rest, and when [s since the first]."""

    points: tuple[Vec, ...]
    times: tuple[float, ...]

    def lasting(self, duration: float) -> Way:
        """The same in another time [s]."""
        scale = duration / self.times[-1]
        return Way(self.points, tuple(t * scale for t in self.times))

    def path(self, actor: str, start: float, wait: float, until: float) -> GuideAlong:
        """The primitive that leads along it.

        Args:
            actor: Whom.
            start: When it is taken hold of [s].
            wait: How long it is held before it moves [s].
            until: How long it is held at the end [s]: let go at once for what is not later.
        """
        points, times = list(self.points), [wait + t for t in self.times]
        if wait > 0.0:
            points, times = [points[0], *points], [0.0, *times]
        if until > start + times[-1]:
            points, times = [*points, points[-1]], [*times, until - start]
        rest = ((0.0, 0.0, 0.0),) * len(points)
        return GuideAlong(actor, start, tuple(times), tuple(points), rest)


def way_of(cast: Cast, phase: Phase, at: Floats) -> Way:
    """The way of a guided phase.

    Args:
        cast: Who takes part.
        phase: A Guide.
        at: Where the body's centre of mass is when it begins [m].
    """
    body = cast.scene.body(phase.edge.actor)
    low, high = body_bounds(body)
    size, lift = high - low, _lift(phase, high[2] - low[2])
    stands = cast.story.phases[phase.edge.actor][0] is phase
    if phase.end.event is NodeEvent.PICKED_UP:
        way = _timed(body, _off(cast, body, at, lift))
        return way.lasting(min(way.times[-1], TAKEN_OUT_S))
    goal = _goal(cast, phase, body)
    if goal is None or (phase.end.event is NodeEvent.TRIGGER and stands):
        return Way((_vec(at), _vec(at)), (0.0, SHORTEST_LEG_S))
    foot = float(body.position[2] - low[2])
    clear = max(float(at[2]) + (lift if stands else 0.0), float(goal[2]) + lift)
    over = _height_over(cast, body, at, goal, size, foot + SET_DOWN_M)
    height = max(clear, over if math.isfinite(over) else clear)
    corners = [at, np.array([*at[:2], height]), np.array([*goal[:2], height]), goal]
    return _timed(body, corners)


def _off(cast: Cast, body: Body, at: Floats, lift: float) -> list[Floats]:
    """From where a body is to where it is held: up, out of a vessel's mouth or open side first."""
    node = cast.doc.spatial_relation_graph.nodes[body.name]
    region = cast.doc.spatial_relation_graph.semantic_regions.get(node.semantic_region or "")
    up = np.array([0.0, 0.0, 1.0])
    if region is None or region.region_type is not RegionType.STORAGE:
        return [at, at + lift * up]
    vessel = cast.scene.body(region.parent_object)
    walls = [shape_bounds(vessel, shape) for shape in vessel.shapes]
    low, high = body_bounds(body)
    low, high = low + at - np.array(body.position), high + at - np.array(body.position)
    over = [w for w in walls if w[0][2] > high[2] - SLACK_M and _meets(w, low, high, flat=True)]
    if not over:
        rim = max((float(w[1][2]) for w in walls), default=0.0)
        return [at, at + max(lift, rim - float(low[2]) + BESIDE_M) * up]
    turn, reach = np.array(vessel.quaternion), float(np.linalg.norm(vessel.half_extents[:2]))
    for side in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (-1.0, 0.0, 0.0)):
        out = quat_rotate(turn, np.array(side)) * (reach + float(max(high[:2] - low[:2])))
        ends = np.minimum(low, low + out), np.maximum(high, high + out)
        raised = CLEARANCE_M * up
        if not any(_meets(w, ends[0] + raised, ends[1] + raised) for w in walls):
            return [at, at + raised, at + raised + out, at + out + lift * up]
    return [at, at + lift * up]


def _meets(box: tuple[Floats, Floats], low: Floats, high: Floats, *, flat: bool = False) -> bool:
    """Whether a box overlaps another one by more than a little; flat: seen from above."""
    axes = 2 if flat else 3
    gap = np.minimum(box[1], high)[:axes] - np.maximum(box[0], low)[:axes]
    return bool((gap > SLACK_M).all())


def _lift(phase: Phase, height: float) -> float:
    usual = max(LIFT_M, LIFT_SHARE * height)
    low, high, _ = bounds(phase.edge.params.lift_cm, (100.0 * usual, 100.0 * usual))
    return 0.005 * (low + high)


def _timed(body: Body, corners: list[Floats]) -> Way:
    speed = HAND_MPS if body.mass < HEAVY_KG else CRANE_MPS
    points, times = [corners[0]], [0.0]
    for corner in corners[1:]:
        way = float(np.linalg.norm(corner - points[-1]))
        if way > 1e-3:
            points.append(corner)
            times.append(times[-1] + max(way / speed, SHORTEST_LEG_S))
    if len(points) == 1:
        return Way((_vec(points[0]), _vec(points[0])), (0.0, SHORTEST_LEG_S))
    way = Way(tuple(_vec(p) for p in points), tuple(times))
    return way.lasting(min(way.times[-1], LONGEST_WAY_S))


def _goal(cast: Cast, phase: Phase, body: Body) -> Floats | None:
    """Where the centre of mass of a guided body ends, None if nobody says."""
    target = cast.target(phase)
    low, high = body_bounds(body)
    half, foot = 0.5 * (high - low)[:2], float(body.position[2] - low[2])
    aside = np.array(body.position)[:2] - 0.5 * (low + high)[:2]
    region = cast.region(phase)
    if region is not None:
        parent = cast.scene.body(region.parent)
        turn = np.array(parent.quaternion)
        center = np.array(parent.position) + quat_rotate(turn, np.array(region.center))
        room = np.array(region.half_extents)
        fits = bool((np.sort(half) <= np.sort(room[:2])).all())
        siblings = [r for r in cast.scene.regions if r.parent == region.parent]
        sinks = fits and opens_upwards(siblings, region.name)
        z = center[2] + (-room[2] if sinks else room[2]) + SET_DOWN_M
        z = max(z, waterline(cast.doc, cast.scene, region.parent, body.name))
        return np.array([*(center[:2] + aside), z + foot])
    if target is None:
        return None
    above = SET_DOWN_M
    if phase.end.event is NodeEvent.TRIGGER:
        low_cm, high_cm, _ = bounds(phase.edge.params.clearance_cm, (100 * HELD_M, 100 * HELD_M))
        above = 0.005 * (low_cm + high_cm)
    if not cast.scene.body(target).shapes:
        spots = _beside(cast, body, half)
        spots = spots if len(spots) else _around(body)
        spot = _free_spot(cast, body, spots, half, 0.0)
        return np.array([*(spot + aside), foot + above])
    surface = top_surface(cast.doc, target)
    on, turn = cast.scene.body(target), np.array(cast.scene.body(target).quaternion)
    corner = np.array(on.position) + quat_rotate(turn, np.array(on.origin_offset))
    room = np.maximum(np.array(surface.half_extents_cm) / 100.0 - half.max(), 0.0)
    steps = np.linspace(-1.0, 1.0, STEPS)
    center = np.array(surface.center_cm) / 100.0
    local = np.array([[center[0] + room[0] * i, center[1] + room[1] * j, center[2]]
                      for i in steps for j in steps])  # fmt: skip
    local = local[np.argsort(np.linalg.norm(local[:, :2] - center[:2], axis=1), kind="stable")]
    places = corner + quat_rotate(turn, local)
    spots = _beside(cast, body, half)
    if len(spots):
        flat = np.column_stack([spots, np.full(len(spots), places[0, 2])])
        inner = quat_rotate(turn * (-1.0, -1.0, -1.0, 1.0), flat - corner)
        spots = spots[(np.abs(inner[:, :2] - center[:2]) <= room + 1e-9).all(axis=1)]
    spots = spots if len(spots) else places[:, :2]
    spot = _free_spot(cast, body, spots, half, float(places[0, 2]))
    low_end = max(places[0, 2] + above, waterline(cast.doc, cast.scene, target, body.name))
    return np.array([*(spot + aside), low_end + foot])


def _beside(cast: Cast, body: Body, half: Floats) -> Floats:
    """Places beside what the prompt puts a body next to, the nearest first [m], shape [n, 2].

    Args:
        cast: Who takes part.
        body: What is put there.
        half: Of its footprint [m].
    """
    told = (s for s in cast.doc.statements or () if s.when == "end" and body.name in s.object)
    s = next((s for s in told if s.predicate in _SIDES and s.target), None)
    if s is None or s.target[0] == body.name:
        return np.zeros((0, 2))
    low, high = body_bounds(cast.scene.body(s.target[0]))
    center, room = 0.5 * (low + high)[:2], 0.5 * (high - low)[:2] + half
    ways = np.array(_SIDES[s.predicate])
    ways = ways[np.argsort(np.linalg.norm(ways * room + center - body.position[:2], axis=1))]
    out = room + np.array(GAPS_M)[:, None, None]
    return (center + ways * out).reshape(-1, 2)


def _around(body: Body) -> Floats:
    """Places on the ground around a body: the nearest first, then those towards the viewer."""
    rings = np.linspace(0.5, AROUND_M, 6)
    angles = 0.5 * math.pi + np.radians([0, 45, -45, 90, -90, 135, -135, 180])
    places = [(r * math.cos(a), r * math.sin(a)) for r in rings for a in angles]
    return np.array(body.position)[:2] + np.array(places)


def _free_spot(cast: Cast, body: Body, places: Floats, half: Floats, height: float) -> Floats:
    """The first place where nothing stands, or else where the least does.

    Args:
        cast: Who takes part.
        body: What is put there.
        places: Where, in order of preference [m], shape [n, 2].
        half: Of its footprint [m].
        height: Of the surface [m].
    """
    over = np.zeros(len(places))
    for other in cast.scene.bodies:
        for shape in other.shapes if other.name != body.name else ():
            low, high = shape_bounds(other, shape)
            if high[2] < height + 0.01 or low[2] > height + 2.0 * body.half_extents[2]:
                continue
            gap = np.minimum(high[:2], places + half) - np.maximum(low[:2], places - half)
            over += np.where((gap + BESIDE_M > 0.0).all(axis=1), gap.min(axis=1) + BESIDE_M, 0.0)
    return places[int(np.argmin(over))]


def _height_over(
    cast: Cast, body: Body, start: Floats, goal: Floats, size: Floats, foot: float
) -> float:
    """Least height of the centre of mass at which a body passes over all that is on its way [m].

    What hangs above both ends is passed below.
    """
    count = max(2, math.ceil(float(np.linalg.norm((goal - start)[:2])) / BESIDE_M))
    line = start[:2] + np.linspace(0.0, 1.0, count)[:, None] * (goal - start)[:2]
    half, height = 0.5 * size[:2] + BESIDE_M, -math.inf
    top = max(start[2], goal[2]) - foot + size[2]
    for other in cast.scene.bodies:
        for shape in other.shapes if other.name != body.name else ():
            low, high = shape_bounds(other, shape)
            on_way = ((line + half > low[:2]) & (line - half < high[:2])).all(axis=1).any()
            if on_way and low[2] < top:
                height = max(height, float(high[2]) + BESIDE_M + foot)
    return height


def _vec(v: Floats) -> Vec:
    return (float(v[0]), float(v[1]), float(v[2]))


def ways(cast: Cast) -> dict[str, Way]:
    """The way of every Guide, by the id of its segment."""
    out: dict[str, Way] = {}
    for actor, phases in cast.story.phases.items():
        at = np.array(cast.scene.body(actor).position)
        for phase in phases:
            if phase.edge.event is EdgeEvent.GUIDE and not (is_climb(phase) or is_posture(phase)):
                out[phase.edge.id] = way_of(cast, phase, at)
                at = np.array(out[phase.edge.id].points[-1])
    return out


def times_of(cast: Cast, found: dict[str, Way]) -> dict[str, float]:
    """Nominal durations of ways, and when they end: by what the layout made of them."""
    out: dict[str, float] = {}
    for actor, phases in cast.story.phases.items():
        if not cast.story.guided(actor):
            continue
        clock = 0.0
        for phase in phases:
            start, name = phase.start, f"{phase.end.id}/event_time"
            told = {**cast.nominal, **out}.get(f"{start.id}/event_time", 0.0)
            clock = max(clock, told)
            if phase.edge.event is not EdgeEvent.GUIDE or phase.end.event is NodeEvent.TRIGGER:
                clock = max(clock, cast.nominal.get(name, clock))
                continue
            usual = found[phase.edge.id].times[-1]
            low, high, _ = bounds(phase.edge.params.duration, (0.0, 1e3))
            duration = min(max(usual, low), high)
            out[f"{phase.edge.id}/duration"] = duration
            clock += duration
            out[name] = clock + (SETTLES_S if phase.end.event is NodeEvent.PLACED else 0.0)
    return out
