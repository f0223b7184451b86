"""What stands along the kerbs of a street: pavements, furniture, parked vehicles, crosswalks."""

from __future__ import annotations

from collections.abc import Iterator
import math

from esg.graph.models import EsgDocument, RelationType
from esg.layout.problem.decals import is_crossing, turn_centre
from esg.layout.problem.edges import near_band
from esg.layout.problem.hints import in_the_way
from esg.layout.problem.poses import Pose2, compose, inverse
from esg.layout.problem.streets import (
    ALONG_DEG,
    CROSSINGS,
    CROSSWALK_CM,
    FACE_TRAFFIC,
    KERB_GAP_CM,
    KERBSIDE,
    PARKED_GAP_CM,
    PAVEMENTS,
    Street,
    Users,
    belongs_beside,
    is_parked,
    words_of,
)
from esg.layout.problem.supports import Shape, SupportMap
from esg.layout.problem.units import Unit

STEP_CM = 50.0
"""Distance of the places tried along a kerb."""
ROOM_CM = 60.0
"""Free room around what is put at a kerb."""


def line_up(street: Street, pose: Pose2, who: Users, unit: Unit) -> None:
    """Turns waiting and parked vehicles that stand nearly along a street into its direction.

    What is to be pushed on from where it waits keeps its heading: its way is planned with it.
    """
    for name, body in {**who.waiting, **who.beside}.items():
        if any(math.dist(c.points_cm[0], body.pose[:2]) < 1.0 for c in unit.corridors):
            continue
        if name not in who.waiting and body.half[0] < 1.2 * body.half[1]:
            continue
        off = math.remainder(body.pose[2] - pose[2], math.pi)
        if abs(math.degrees(off)) < ALONG_DEG:
            unit.members[name] = (*body.pose[:2], body.pose[2] - off)


def lay_along(
    doc: EsgDocument,
    road: str,
    street: Street,
    unit: Unit,
    free: list[str],
    supports: SupportMap,
    shape: dict[str, Shape],
) -> dict[str, Pose2]:
    """Poses, in the unit's frame, of what belongs to a street that is a member of the unit.

    Args:
        doc: The document.
        road: The street.
        street: Its cross section.
        unit: Where it lies and who acts on it.
        free: Nodes of no unit, in order.
        supports: Supports of all nodes.
        shape: Geometry of all nodes.

    Returns:
        Pavements beyond the kerb where their users stand, crosswalks across the street, then
        furniture and parked vehicles along it.
    """
    at = unit.members[road]
    out: dict[str, Pose2] = {}
    for name in free:
        said = words_of(doc, name)
        if not shape[name].is_decal or name == road:
            continue
        if said & PAVEMENTS:
            out[name] = _pavement(name, street, at, unit, supports, shape)
        elif is_crossing(doc, name) and not _turns(unit):
            out[name] = _crossing(at, street, unit, shape)
        elif said & CROSSINGS:
            out[name] = _crosswalk(name, at, unit, supports, shape)
    taken = [(unit.members[n], shape[n]) for n in unit.members if not shape[n].is_decal]
    for name in free:
        if not _joins(doc, name, road, supports, shape):
            continue
        for pose in _places(doc, name, road, street, at, unit, shape):
            radius = math.hypot(shape[name].hx, shape[name].hy)
            clear = all(
                math.dist(pose[:2], p[:2]) > radius + math.hypot(s.hx, s.hy) + ROOM_CM
                for p, s in taken
            )
            half = min(shape[name].hx, shape[name].hy)
            if clear and not any(in_the_way(c, *pose[:2], half) for c in unit.corridors):
                out[name] = pose
                taken.append((pose, shape[name]))
                break
    return out


def _joins(
    doc: EsgDocument, name: str, road: str, supports: SupportMap, shape: dict[str, Shape]
) -> bool:
    """Whether a thing is put at the kerb: it belongs there, and nothing else says where it is."""
    node = doc.spatial_relation_graph.nodes[name]
    parked = is_parked(doc, name)
    if (node.group is not None and not parked) or not belongs_beside(
        doc, name, road, supports, shape
    ):
        return False
    graph = doc.spatial_relation_graph
    edges = [e for e in graph.edges.binary_relations if name in (e.from_, e.to)]
    others = [e for e in edges if e.relation_type is not RelationType.FACE]
    said = [e for e in others if road in (e.from_, e.to)]
    multi = any(name in (*e.subjects, *e.targets) for e in graph.edges.multi_relations)
    if multi or len(said) < len(others):
        return False
    on_pavement = supports.of[name].parent is not None
    return bool(said) or on_pavement or parked or bool(words_of(doc, name) & KERBSIDE)


def _places(
    doc: EsgDocument,
    name: str,
    road: str,
    street: Street,
    at: Pose2,
    unit: Unit,
    shape: dict[str, Shape],
) -> Iterator[Pose2]:
    """Places at the kerb of the near side, then of the other, from the middle outwards."""
    mine = shape[name]
    users = [p for n, p in unit.members.items() if not shape[n].is_decal]
    along = [compose(inverse(at), p)[0] for p in users] or [0.0]
    middle = 0.5 * (min(along) + max(along))
    parked = mine.config.is_wheeled and is_parked(doc, name)
    gap = PARKED_GAP_CM if parked else KERB_GAP_CM
    if any(
        {e.from_, e.to} == {name, road} and e.relation_type is RelationType.NEAR
        for e in doc.spatial_relation_graph.edges.binary_relations
    ):
        gap = min(gap, 0.5 * sum(near_band(mine, shape[road], math.inf)))
    for step in range(int(shape[road].hx / STEP_CM)):
        for side in (street.keeps, -street.keeps):
            for ahead in (1.0, -1.0) if step else (1.0,):
                # a lane's traffic runs along +X on the side that it keeps to
                heading = 0.0 if side == street.keeps else math.pi
                lengthwise = mine.config.is_wheeled and mine.hx >= mine.hy
                if lengthwise:
                    yaw, half = heading, mine.hy
                elif words_of(doc, name) & FACE_TRAFFIC:
                    yaw, half = heading + math.pi, mine.hy
                else:
                    yaw, half = -side * 0.5 * math.pi, mine.hx
                lateral = side * (street.half_width + gap + half)
                yield compose(at, (middle + ahead * step * STEP_CM, lateral, yaw))


def _pavement(
    name: str,
    street: Street,
    at: Pose2,
    unit: Unit,
    supports: SupportMap,
    shape: dict[str, Shape],
) -> Pose2:
    """Along the kerb on whose side its users stand; by default where the traffic keeps."""
    on_it = [compose(inverse(at), p) for n, p in unit.members.items()
             if supports.of[n].parent == name]  # fmt: skip
    lateral = sum(y for _, y, _ in on_it) or street.keeps
    side = math.copysign(1.0, lateral)
    x = sum(p[0] for p in on_it) / len(on_it) if on_it else 0.0
    half = min(shape[name].hx, shape[name].hy)
    turned = 0.0 if shape[name].hx >= shape[name].hy else 0.5 * math.pi
    return compose(at, (x, side * (street.half_width + half), turned))


def _turns(unit: Unit) -> bool:
    """Whether a planned way turns off: then a crossing lies under it."""
    return any(turn_centre(unit.corridors[k : k + 1], 0.0) for k in range(len(unit.corridors)))


def _crossing(at: Pose2, street: Street, unit: Unit, shape: dict[str, Shape]) -> Pose2:
    """Behind what stands at the kerb, so that it is at the corner; else behind all ways."""
    places = [(compose(inverse(at), p), shape[n]) for n, p in unit.members.items()
              if not shape[n].is_decal]  # fmt: skip
    ends = [compose(inverse(at), (*p, 0.0))[0] for c in unit.corridors for p in c.points_cm]
    ahead = [x + math.hypot(s.hx, s.hy) for (x, y, _), s in places if abs(y) > street.half_width]
    x = max(ahead or [*ends, 0.0]) + KERB_GAP_CM + street.half_width
    return compose(at, (x, 0.0, 0.0))


def _crosswalk(
    name: str, at: Pose2, unit: Unit, supports: SupportMap, shape: dict[str, Shape]
) -> Pose2:
    """Across the street, under its users, else in front of where the first way ends."""
    on_it = [compose(inverse(at), p)[0] for n, p in unit.members.items()
             if supports.of[n].parent == name]  # fmt: skip
    if on_it:
        return compose(at, (sum(on_it) / len(on_it), 0.0, 0.5 * math.pi))
    x = 0.0
    for corridor in unit.corridors[:1]:
        first, last = corridor.points_cm[0], corridor.points_cm[-1]
        start, end = (compose(inverse(at), (*p, 0.0))[0] for p in (first, last))
        movers = [n for n, p in unit.members.items() if math.dist(p[:2], first) < 1.0]
        reach = max((shape[n].hx for n in movers), default=0.0)
        x = end + math.copysign(reach + CROSSWALK_CM + shape[name].hy, end - start)
    return compose(at, (x, 0.0, 0.5 * math.pi))
