"""Where a street lies under what happens on it, and what stands beside it.

Planned motion owns the poses of those who act; the street is laid under them afterwards: vehicles
start in their lane and head along it as well as they can, what belongs to the roadside stands
beyond the kerb. A vehicle that hits something at the roadside therefore leaves its lane towards it,
and two that meet head-on start each in a lane of its own.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
import math

import numpy as np

from esg.graph.models import EsgDocument, NodeEvent, Predicate, RelationType
from esg.layout.problem.poses import Pose2, compose, inverse
from esg.layout.problem.supports import Shape, SupportMap
from esg.layout.problem.units import Unit

NO_STREETS = frozenset({"runway", "airstrip", "tarmac", "track", "racetrack"})
"""Words for roads without traffic in two lanes."""
PAVEMENTS = frozenset({"pavement", "sidewalk"})
"""Categories of the strips beside a street."""
CROSSINGS = frozenset({"crosswalk"})
"""Categories of what leads across it."""
RIDERS = frozenset({
    "bicyclist", "biker", "cyclist", "moped", "motorcyclist", "rider", "rollerblader",
    "skateboarder", "skater",
})  # fmt: skip
"""Words for who rides without what is ridden being drawn."""
FACE_TRAFFIC = frozenset({"sign", "traffic_light", "billboard", "meter"})
"""Words of categories that are read by who drives, not by who walks."""
KERBSIDE = frozenset({
    "bench", "billboard", "bin", "bollard", "booth", "dumpster", "fountain", "hydrant", "kiosk",
    "lamp", "lamppost", "mailbox", "meter", "sign", "stall", "stop", "streetlamp", "trash",
    "traffic_light", "utility_pole",
})  # fmt: skip
"""Words of categories that stand at a kerb unless they are said to be on the road."""
BESIDE = (
    RelationType.NEAR,
    RelationType.ADJACENT,
    RelationType.LEFT_OF,
    RelationType.RIGHT_OF,
    RelationType.IN_FRONT_OF,
    RelationType.BEHIND,
)
KERB_GAP_CM = 40.0
"""From the kerb to what stands beside it: posts keep 45 cm (MUTCD 2A.19: at least 2 ft of lateral
offset from the face of a kerb, 1 ft where there is no room)."""
PARKED_GAP_CM = 15.0
"""From the edge of the carriageway to a vehicle parked along it."""
CROSSWALK_CM = 120.0
"""From a vehicle that stops for a crosswalk to the crosswalk (MUTCD 3B.16: 4 ft)."""
ALONG_DEG = 25.0
"""A waiting vehicle that stands within this of the street's direction is turned into it."""
TURNED_DEG = 45
"""Largest angle searched between a driver's heading and the street [deg]."""
TILT_DEG = 15.0
"""A heading so far off the street costs as much as touching the lane's edge."""
OFF_ROAD = 30.0
"""Cost of a metre by which something is on the wrong side of a kerb."""


@dataclass(frozen=True)
class Street:
    """Cross section of a street; lengths in cm, y to the left of its +X.

    Args:
        half_width: From its axis to a kerb.
        lane: From its axis to the middle of a lane.
        half_lane: From the middle of a lane to its edge.
        keeps: -1 where traffic keeps to the right, +1 where it keeps to the left.
    """

    half_width: float
    lane: float
    half_lane: float
    keeps: float


@dataclass(frozen=True)
class Body:
    """Something on or beside a street, in the frame of the unit that it belongs to.

    Args:
        pose: Where it stands.
        half: Half its length and width [cm].
    """

    pose: Pose2
    half: tuple[float, float]

    def across(self, yaw: float) -> float:
        """Half its extent across a street of a direction [cm]."""
        turned = self.pose[2] - yaw
        return self.half[0] * abs(math.sin(turned)) + self.half[1] * abs(math.cos(turned))

    def at(self, street: Pose2) -> tuple[float, float]:
        """Its place along and across a street [cm]."""
        return compose(inverse(street), self.pose)[:2]


@dataclass(frozen=True)
class Users:
    """Who is where: node -> body.

    Args:
        drivers: Vehicles that drive.
        waiting: Vehicles in the carriageway that do not.
        beside: What belongs beyond the kerb.
        on_it: What is said to be on the street.
        stops: Drivers where straight ways end on which they run into nothing beside the street.
    """

    drivers: dict[str, Body]
    waiting: dict[str, Body]
    beside: dict[str, Body]
    on_it: dict[str, Body]
    stops: dict[str, Body] = field(default_factory=dict[str, Body])


def words_of(doc: EsgDocument, name: str) -> frozenset[str]:
    """Words of a node's category and of what it is called."""
    node = doc.spatial_relation_graph.nodes[name]
    config = doc.asset_configurations[node.asset_id]
    text = f"{config.category} {node.label} {name}".lower()
    parts = text.replace("_", " ").replace("-", " ").split()
    return frozenset([*parts, config.category.lower()])


def street_of(doc: EsgDocument, name: str) -> Street | None:
    """The cross section of a road with traffic in two lanes; None for anything else."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    lanes = [r for r in config.regions if r.kind == "lane"]
    if config.proxies or len(lanes) != 2 or words_of(doc, name) & NO_STREETS:
        return None
    lane, half = abs(lanes[0].center_cm[1]), lanes[0].half_extents_cm[1]
    return Street(0.5 * config.dimensions_cm[1], lane, half, kept_side(doc))


def kept_side(doc: EsgDocument) -> float:
    """-1 where traffic keeps to the right, +1 where it keeps to the left."""
    return 1.0 if doc.scene_definition.traffic == "left" else -1.0


def streets_in(doc: EsgDocument) -> list[str]:
    """The streets of a scene, first those of which a motion is told, else in order."""
    streets = [n for n in doc.spatial_relation_graph.nodes if street_of(doc, n) is not None]
    told = {n for s in doc.statements or () for n in s.target}
    return sorted(streets, key=lambda n: n not in told)


def street_in(doc: EsgDocument) -> str | None:
    """The first street of a scene."""
    return next(iter(streets_in(doc)), None)


def is_parked(doc: EsgDocument, name: str) -> bool:
    """Whether a vehicle is said to be parked; of a plural its description tells."""
    required = doc.asset_requirement.get(doc.spatial_relation_graph.nodes[name].asset_id)
    told = required.asset_description.partition(":")[0] if required is not None else ""
    return "parked" in words_of(doc, name) or "parked" in told.lower().split()


def belongs_beside(
    doc: EsgDocument, name: str, road: str, supports: SupportMap, shape: dict[str, Shape]
) -> bool:
    """Whether a thing stands beyond the kerb: it is said to, or its kind does."""
    if shape[name].is_decal or supports.of[name].parent not in (None, *_decals(shape)):
        return False
    parent = supports.of[name].parent
    if parent is not None and parent != road:
        return bool(words_of(doc, parent) & PAVEMENTS)
    if parent == road:
        return False
    for e in doc.spatial_relation_graph.edges.binary_relations:
        if e.from_ == name and e.to == road and e.relation_type in BESIDE:
            return True
    return is_kerbside(doc, name)


def is_kerbside(doc: EsgDocument, name: str) -> bool:
    """Whether a thing usually stands beyond the kerb, or along it: furniture, what is founded."""
    node = doc.spatial_relation_graph.nodes[name]
    if doc.asset_configurations[node.asset_id].is_wheeled:
        return is_parked(doc, name)
    return bool(words_of(doc, name) & KERBSIDE) or node.is_static


def _decals(shape: dict[str, Shape]) -> Iterable[str]:
    return (n for n, s in shape.items() if s.is_decal)


def users(
    doc: EsgDocument, unit: Unit, road: str, supports: SupportMap, shape: dict[str, Shape]
) -> Users:
    """Sorts the members of a planned unit by what they have to do with a street."""
    out = Users({}, {}, {}, {})
    active = drivers(doc, unit, shape) or drivers(doc, unit, shape, afoot=True)
    active = {n: heading for n, heading in active.items() if not goes_across(doc, n, road)}
    along = _one_way_or_the_other(doc, {n: active[n] for n in unit.members if n in active})
    members = sorted(unit.members.items(), key=lambda m: m[0] not in list(along)[:1])
    for name, pose in members:
        body = Body(pose, (shape[name].hx, shape[name].hy))
        if name in active and name not in along:
            continue  # it comes across
        if name in active:
            heading = active[name]
            out.drivers[name] = Body((pose[0], pose[1], heading), body.half)
        elif belongs_beside(doc, name, road, supports, shape):
            out.beside[name] = body
        elif shape[name].config.is_wheeled and supports.of[name].parent in (None, road):
            out.waiting[name] = body
        elif supports.of[name].parent == road:
            out.on_it[name] = body
    out.stops.update(_stops(doc, unit, out))
    return out


def _one_way_or_the_other(doc: EsgDocument, active: dict[str, float]) -> dict[str, float]:
    """Those of the drivers who go along a street: who is said to, and who goes that way, or back.

    Whoever comes across has no part in where the street lies.
    """
    order = sorted(active, key=lambda name: not goes_along(doc, name))
    first = active[order[0]] if order else 0.0
    off = {n: abs(math.remainder(active[n] - first, math.pi)) for n in order}
    return {n: active[n] for n in order if off[n] <= math.radians(TURNED_DEG)}


def _stops(doc: EsgDocument, unit: Unit, who: Users) -> dict[str, Body]:
    """Where drivers come to on straight ways, but for those who meet what stands at the kerb."""
    timeline = doc.timeline_system
    nodes = () if timeline is None else timeline.sequence_graph.nodes
    met = [set(n.participants) for n in nodes if n.event is NodeEvent.COLLISION]
    out: dict[str, Body] = {}
    for name, body in who.drivers.items():
        if any(name in pair and pair & set(who.beside) for pair in met):
            continue
        x, y, yaw = body.pose
        own = [c.points_cm for c in unit.corridors if math.dist(c.points_cm[0], (x, y)) < 1.0]
        for points in own[:1]:
            *_, (u, v), _ = points
            if all(abs(compose(inverse(body.pose), (*p, 0.0))[1]) < 1.0 for p in points):
                out[name] = Body((u, v, yaw), body.half)
    return out


def drivers(
    doc: EsgDocument, unit: Unit, shape: dict[str, Shape], *, afoot: bool = False
) -> dict[str, float]:
    """Vehicles that drive by themselves and the headings in which they set off [rad].

    Args:
        doc: The document.
        unit: Who is planned.
        shape: Geometry of every node.
        afoot: Whatever is told to go along a street without wheels, instead.
    """
    timeline = doc.timeline_system
    acting = {} if timeline is None else {e.actor for e in timeline.sequence_graph.edges
                                          if e.event.value != "InertialConnector"}  # fmt: skip
    out: dict[str, float] = {}
    for corridor in unit.corridors:
        start, *rest = corridor.points_cm
        onward = next((p for p in rest if math.dist(p, start) > 1.0), None)
        for name, (x, y, _) in unit.members.items():
            rides = shape[name].config.is_wheeled or words_of(doc, name) & RIDERS
            if afoot:
                rides = goes_along(doc, name)
            if (
                onward
                and rides
                and name in acting
                and math.dist((x, y), start) < 1.0
                and name not in out
            ):
                out[name] = math.atan2(onward[1] - start[1], onward[0] - start[0])
    return out


def goes_across(doc: EsgDocument, name: str, road: str) -> bool:
    """Whether something is told to cross a street, and not to drive along it."""
    told = (s for s in doc.statements or () if s.predicate is Predicate.MOVES)
    return any(s.direction == "across" and name in s.object and road in s.target for s in told)


def goes_along(doc: EsgDocument, name: str) -> bool:
    """Whether a thing is said to move along a street."""
    streets = streets_in(doc)
    return any(
        s.predicate is Predicate.MOVES and s.direction == "along" and name in s.object
        and any(t in streets for t in s.target)
        for s in doc.statements or ()
    )  # fmt: skip


def lay_beside_parked(street: Street, who: Users, unit: Unit) -> Pose2 | None:
    """The pose at which the first parked vehicle is at the kerb, with fewest others on the street.

    For scenes in which nobody drives; None where nothing is parked.
    """
    parked = next((b for b in who.beside.values() if b.half[0] > 1.2 * b.half[1]), None)
    if parked is None:
        return None
    lateral = street.keeps * (street.half_width + PARKED_GAP_CM + parked.half[1])
    poses = [
        compose((*parked.pose[:2], parked.pose[2] + turn), (0.0, -lateral, 0.0))
        for turn in (0.0, math.pi)
    ]

    def hit(pose: Pose2) -> int:
        places = (compose(inverse(pose), p)[1] for p in unit.members.values())
        return sum(abs(y) < street.half_width for y in places)

    return min(poses, key=hit)


def turned_into(unit: Unit, who: Users) -> Users | None:
    """The first driver as it goes on where its way has turned off; None where it does not turn."""
    name, first = next(iter(who.drivers.items()))
    for corridor in unit.corridors:
        before, end = corridor.points_cm[-2:]
        heading = math.atan2(end[1] - before[1], end[0] - before[0])
        off = math.degrees(abs(math.remainder(heading - first.pose[2], 2.0 * math.pi)))
        if math.dist(corridor.points_cm[0], first.pose[:2]) < 1.0 and off > TURNED_DEG:
            return Users({name: Body((*before, heading), first.half)}, {}, {}, {})
    return None


def lay_street(street: Street, who: Users, ways: Iterable[tuple[float, float]]) -> Pose2:
    """The pose at which most keep their places, its middle beside the middle of all ways.

    All angles up to `TURNED_DEG` off the first driver's heading are tried, each with all offsets of
    that driver within its lane; the cheapest is taken (the first of equals, least turned first).
    """
    first = next(iter(who.drivers.values()))
    slack = max(street.half_lane - first.half[1], 0.0)
    best = (math.inf, (0.0, 0.0, 0.0))
    for turn in sorted(range(-TURNED_DEG, TURNED_DEG + 1), key=abs):
        yaw = first.pose[2] - math.radians(turn)
        for offset in np.linspace(-slack, slack, 13):
            lateral = street.keeps * street.lane + float(offset)
            pose = compose((*first.pose[:2], yaw), (0.0, -lateral, 0.0))
            cost = _cost(street, who, pose)
            if cost < best[0] - 1e-9:
                best = (cost, pose)
    pose = best[1]
    along = [compose(inverse(pose), (*p, 0.0))[0] for p in ways]
    return compose(pose, (0.5 * (min(along) + max(along)), 0.0, 0.0))


def _cost(street: Street, who: Users, pose: Pose2) -> float:
    total = 0.0
    for body in who.drivers.values():
        off = math.remainder(body.pose[2] - pose[2], 2.0 * math.pi)
        way = 1.0 if abs(off) <= 0.5 * math.pi else -1.0  # oncoming traffic has the other lane
        tilt = math.degrees(abs(off) if way > 0.0 else math.pi - abs(off))
        side = way * body.at(pose)[1] - street.keeps * street.lane
        total += (side / max(street.half_lane - body.half[1], 20.0)) ** 2 + (tilt / TILT_DEG) ** 2
    for name, body in who.beside.items():
        aside = abs(body.at(pose)[1])
        missing = street.half_width + body.across(pose[2]) + 0.5 * KERB_GAP_CM - aside
        far = aside - body.across(pose[2]) - street.half_width - 3.0 * KERB_GAP_CM
        total += OFF_ROAD * max(missing, 0.0) / 100.0 + 0.1 * max(far, 0.0) / 100.0
        if name not in who.drivers and body.at(pose)[1] * street.keeps < 0.0:
            total += 0.5  # the near side of the first driver rather than the far one
    for body in who.stops.values():
        over = abs(body.at(pose)[1]) + 0.5 * KERB_GAP_CM - street.half_width
        total += OFF_ROAD * max(over, 0.0) / 100.0
    for body in (*who.on_it.values(), *who.waiting.values()):
        over = abs(body.at(pose)[1]) + min(body.half) - street.half_width
        total += OFF_ROAD * max(over, 0.0) / 100.0
    return total
