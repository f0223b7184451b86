"""Lays roads, lanes and crossings under planned motion.

A decal has no proxies: where it lies is a matter of meaning, not of physics. Decals that planned
motion refers to, and carriageways that nothing else refers to, join the planned unit.
"""

from __future__ import annotations

import math

from esg.graph.models import BinaryRelation, EsgDocument, Predicate, RelationType
from esg.layout.problem.edges import AXES, adjacent_band, near_band
from esg.layout.problem.hints import Corridor
from esg.layout.problem.obstacles import is_road
from esg.layout.problem.poses import Pose2, compose
from esg.layout.problem.streets import CROSSINGS, drivers, kept_side, street_in, street_of
from esg.layout.problem.supports import Shape, SupportMap
from esg.layout.problem.units import Unit

CROSSING_WORDS = (
    "cross",
    "crossing",
    "crossroad",
    "crossroads",
    "intersection",
    "junction",
    "corner",
)
UNDERFOOT = (
    RelationType.ON,
    RelationType.INSIDE_OF,
    RelationType.CENTER_OF,
    RelationType.UNDER,
    RelationType.ABOVE,
)
Segment = tuple[float, float, float, float]


def _segments(corridors: list[Corridor]) -> list[Segment]:
    out = []
    for c in corridors:
        for (x0, y0), (x1, y1) in zip(c.points_cm, c.points_cm[1:], strict=False):
            if math.hypot(x1 - x0, y1 - y0) > 1e-6:
                out.append((x0, y0, x1, y1))
    return out


def _direction(s: Segment) -> float:
    return math.atan2(s[3] - s[1], s[2] - s[0])


def _distance(s: Segment, x: float, y: float) -> float:
    dx, dy = s[2] - s[0], s[3] - s[1]
    t = ((x - s[0]) * dx + (y - s[1]) * dy) / (dx * dx + dy * dy)
    t = min(max(t, 0.0), 1.0)
    return math.hypot(x - s[0] - t * dx, y - s[1] - t * dy)


def turn_centre(corridors: list[Corridor], aside: float) -> tuple[float, float] | None:
    """Where the axes cross of roads whose lanes a turning path comes from and goes on in.

    Args:
        corridors: Paths; the first that turns counts.
        aside: How far to the left of each axis the path runs [cm].
    """
    for c in corridors:
        legs = _segments([c])
        if len(legs) < 3:
            continue
        a, b = legs[0], legs[-1]
        ux, uy = math.cos(_direction(a)), math.sin(_direction(a))
        vx, vy = math.cos(_direction(b)), math.sin(_direction(b))
        det = ux * vy - uy * vx
        if abs(det) < 0.3:
            continue
        # both axes, moved from the path to its right
        ax, ay = a[0] + aside * uy, a[1] - aside * ux
        bx, by = b[2] + aside * vy, b[3] - aside * vx
        t = ((bx - ax) * vy - (by - ay) * vx) / det
        return ax + t * ux, ay + t * uy
    return None


def lay_decals(
    doc: EsgDocument,
    unit: Unit,
    free: list[str],
    supports: SupportMap,
    shape: dict[str, Shape],
) -> dict[str, Pose2]:
    """Chooses poses of decals in a planned unit's frame.

    Args:
        doc: The document.
        unit: A planned unit.
        free: Decals that belong to no unit yet.
        supports: Supports of all nodes.
        shape: Geometry of all nodes.

    Returns:
        Pose per decal that belongs to this motion.
    """
    edges = doc.spatial_relation_graph.edges.binary_relations
    legs = _segments(unit.corridors)
    longest = max(legs, key=lambda s: math.hypot(s[2] - s[0], s[3] - s[1]), default=None)
    main = _direction(longest) if longest is not None else 0.0
    out: dict[str, Pose2] = {}
    for name in free:
        # an edge to a member says where the decal lies; riders say it less precisely
        links = [
            (e, e.from_ if e.to == name else e.to)
            for e in edges
            if name in (e.from_, e.to) and (e.from_ if e.to == name else e.to) in unit.members
        ]
        under = [m for e, m in links if e.relation_type in UNDERFOOT]
        beside = [(e, m) for e, m in links if e.relation_type not in UNDERFOOT]
        riders = [n for n in unit.members if supports.of[n].parent == name or n in _told(doc, name)]
        taken_elsewhere = any(
            supports.of[n].parent == name and n not in unit.members for n in supports.of
        )
        crossed = _crossed(doc, name, unit)
        if crossed is not None:
            out[name] = (*crossed[:2], _lengthwise(shape[name], crossed[2] + 0.5 * math.pi))
        elif under:
            out[name] = _under(shape[name], unit.members[under[0]], legs, main)
        elif riders or (not beside and is_road(doc, name) and not taken_elsewhere):
            if is_crossing(doc, name):
                centre = turn_centre(unit.corridors, _lane(doc, name, unit, shape))
                if centre is not None and longest is not None:
                    out[name] = (*centre, _direction(legs[0]))
                    continue
            out[name] = _along(shape[name], unit, riders, legs, longest, main)
        elif beside:
            out[name] = _beside(shape, name, *beside[0], unit, main)
    return out


def _told(doc: EsgDocument, name: str) -> set[str]:
    """Who is said to move about on a decal that is no road: a stage, a pier."""
    told = (s for s in doc.statements or () if s.predicate is Predicate.SUPPORTED_BY)
    return {who for s in told if name in s.target for who in s.object if not is_road(doc, name)}


def _crossed(doc: EsgDocument, name: str, unit: Unit) -> Pose2 | None:
    """The middle and the direction of the way on which somebody goes across or along a decal.

    What is gone across from end to end, as a bridge is, or along, as a pier, lies the other way.
    """
    told = doc.statements or ()
    lengthwise = {(s.object, s.target) for s in told if s.direction == "along"}
    for s in told:
        ways = s.predicate is Predicate.MOVES and s.direction in ("across", "along")
        if not ways or name not in s.target:
            continue
        for who in s.object:
            for c in unit.corridors if who in unit.members else ():
                (x, y), (u, v) = c.points_cm[0], c.points_cm[-1]
                if who in c.participants and math.dist((x, y), (u, v)) > 1.0:
                    turned = 0.5 * math.pi if (s.object, s.target) in lengthwise else 0.0
                    return (0.5 * (x + u), 0.5 * (y + v), math.atan2(v - y, u - x) + turned)
    return None


def _lane(doc: EsgDocument, name: str, unit: Unit, shape: dict[str, Shape]) -> float:
    """How far to the left of a crossing's axes vehicles drive, 0 for anything else [cm]."""
    if not drivers(doc, unit, shape):
        return 0.0
    road = street_in(doc)
    street = street_of(doc, road) if road is not None else None
    if street is not None:
        return street.keeps * street.lane
    inner = [r.half_extents_cm[1] for r in shape[name].config.regions]
    return kept_side(doc) * 0.5 * max(inner, default=0.0)


def is_crossing(doc: EsgDocument, name: str) -> bool:
    """Whether a decal is where roads cross."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    words = f"{config.category} {name}".lower().replace("_", " ").replace("-", " ").split()
    return bool(set(words) & set(CROSSING_WORDS)) and config.category not in CROSSINGS


def _lengthwise(decal: Shape, yaw: float) -> float:
    return yaw if decal.hx >= decal.hy else yaw + 0.5 * math.pi


def _under(decal: Shape, rider: Pose2, legs: list[Segment], main: float) -> Pose2:
    yaw = main
    if legs:
        yaw = _direction(min(legs, key=lambda s: _distance(s, rider[0], rider[1])))
    return (rider[0], rider[1], _lengthwise(decal, yaw))


def _along(
    decal: Shape,
    unit: Unit,
    riders: list[str],
    legs: list[Segment],
    longest: Segment | None,
    yaw: float,
) -> Pose2:
    c, s = math.cos(-yaw), math.sin(-yaw)
    points = [p[:2] for p in unit.members.values()] + [p for q in legs for p in (q[:2], q[2:])]
    along = [c * x - s * y for x, y in points]
    if riders:
        lateral = [s * unit.members[n][0] + c * unit.members[n][1] for n in riders]
    elif longest is not None:
        lateral = [s * longest[0] + c * longest[1]]
    else:
        lateral = [s * x + c * y for x, y in points]
    middle = 0.5 * (min(along) + max(along))
    x, y, _ = compose((0.0, 0.0, yaw), (middle, sum(lateral) / len(lateral), 0.0))
    return (x, y, _lengthwise(decal, yaw))


def _beside(
    shape: dict[str, Shape], name: str, edge: BinaryRelation, member: str, unit: Unit, yaw: float
) -> Pose2:
    """Parallel to the motion, on the side where the path does not run."""
    a, b = shape[name], shape[member]
    if edge.relation_type is RelationType.ADJACENT:
        low, high = adjacent_band(a, b)
    elif edge.relation_type is RelationType.NEAR:
        low, high = near_band(a, b, math.inf)
    else:
        low, high = 5.0, 50.0
    gap = 0.5 * (low + high)
    x, y, turn = unit.members[member]
    rel = turn - yaw
    reach = b.hx * abs(math.sin(rel)) + b.hy * abs(math.cos(rel))
    wide = min(a.hx, a.hy)
    side = 1.0
    if edge.relation_type in AXES:
        # a world direction cannot be kept while the unit may still turn; take it for yaw 0
        axis, sign = AXES[edge.relation_type]
        sign = -sign if edge.to == name else sign
        side = sign * (math.cos(yaw) if axis == 1 else -math.sin(yaw)) or 1.0
        side = math.copysign(1.0, side)
    offset = side * (wide + reach + gap)
    dx, dy, _ = compose((0.0, 0.0, yaw), (0.0, offset, 0.0))
    return (x + dx, y + dy, _lengthwise(a, yaw))
