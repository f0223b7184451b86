"""Places that must stay clear: corridors of planned motion and carriageways."""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.graph.models import EsgDocument, RelationType
from esg.layout.problem.hints import Corridor
from esg.layout.problem.joined import Joined, joined, swept
from esg.layout.problem.poses import Pose2
from esg.layout.problem.shapes import RECTANGLE
from esg.layout.problem.supports import Shape, SupportMap, is_pavement
from esg.layout.problem.units import Unit

ROAD_WORDS = (
    "road",
    "street",
    "lane",
    "track",
    "runway",
    "crossroad",
    "crossroads",
    "intersection",
    "highway",
    "alley",
    "cross",
    "crossing",
    "junction",
)
CLEAR_HEIGHT_CM = 300.0
ON_IT = (
    RelationType.ON,
    RelationType.INSIDE_OF,
    RelationType.CENTER_OF,
    RelationType.UNDER,
    RelationType.ABOVE,
)

Prism = tuple[float, float, float, float, float, float, float, float]
"""kind, x, y, yaw, hx, hy, z0, z1 as in `esg.layout.problem.shapes.Footprint`."""


@dataclass(frozen=True)
class Obstacle:
    """A volume without matter that moves with a unit.

    Args:
        unit: Index of the unit that carries it.
        rel: Pose in the unit's frame.
        base_z_cm: Height of its lower end.
        prisms: Shapes.
        exempt: Nodes that may be inside.
        is_hard: A layout that violates it is not feasible.
        label: For reports.
    """

    unit: int
    rel: Pose2
    base_z_cm: float
    prisms: tuple[Prism, ...]
    exempt: frozenset[str]
    is_hard: bool
    label: str


def obstacles(
    doc: EsgDocument,
    units: list[Unit],
    supports: SupportMap,
    shape: dict[str, Shape],
    z: dict[str, float],
) -> list[Obstacle]:
    """Returns the corridors of planned units, the carriageways, and where joints move things."""
    held = joined(doc)
    nodes = doc.spatial_relation_graph.nodes
    out: list[Obstacle] = []
    planned = any(unit.is_planned for unit in units)
    for u, unit in enumerate(units):
        for c in unit.corridors:
            allowed: set[str] = set()
            for p in c.participants:
                if p.startswith("group:"):
                    allowed |= {n for n in nodes if nodes[n].group == p.removeprefix("group:")}
                elif p in nodes:
                    allowed.add(p)
            movers = sorted(allowed & set(unit.members)) or sorted(allowed)
            base = min((z[n] for n in movers), default=0.0)
            # what carries a participant belongs on its path, and so does what a participant carries
            carried = {n for n in nodes if set(supports.chain(n)) & allowed}
            allowed |= {a for n in allowed for a in supports.chain(n)} | carried
            allowed |= {mate for n in allowed for mate in held.mates(n)}
            boxes = []
            for k, ((x0, y0), (x1, y1)) in enumerate(
                zip(c.points_cm, c.points_cm[1:], strict=False)
            ):
                length, yaw = math.hypot(x1 - x0, y1 - y0), math.atan2(y1 - y0, x1 - x0)
                # nothing moves behind the start: only the mover itself stands there
                back = c.half_width_cm if k else _start_reach(c, unit, shape)
                mid = 0.5 * (length + c.half_width_cm - back)
                boxes.append(
                    (
                        float(RECTANGLE),
                        x0 + mid * math.cos(yaw),
                        y0 + mid * math.sin(yaw),
                        yaw,
                        0.5 * (length + c.half_width_cm + back),
                        c.half_width_cm,
                        0.5,
                        CLEAR_HEIGHT_CM,
                    )
                )
            out.append(
                Obstacle(
                    u,
                    (0.0, 0.0, 0.0),
                    base,
                    tuple(boxes),
                    frozenset(allowed),
                    True,
                    f"the path of {', '.join(c.participants)}",
                )
            )
        for n, pose in unit.members.items():
            if planned and shape[n].is_decal and is_road(doc, n):
                out.append(_road(doc, u, n, pose, units, supports, shape))
    return out + _swings(doc, units, supports, held, z)


def _swings(
    doc: EsgDocument, units: list[Unit], supports: SupportMap, held: Joined, z: dict[str, float]
) -> list[Obstacle]:
    """Where jointed things swing: no place for others but those that they meet in the story."""
    out: list[Obstacle] = []
    sequence = doc.timeline_system.sequence_graph if doc.timeline_system else None
    for root, prisms in swept(doc).items():
        mates = {root, *held.mates(root)}
        u = next(i for i, unit in enumerate(units) if root in unit.members)
        met = {
            n
            for e in (sequence.nodes if sequence else ())
            if mates & set(e.participants)
            for n in e.participants
        }
        allowed = mates | met | set(supports.chain(root))
        allowed |= {n for n in supports.of if set(supports.chain(n)) & allowed}
        label = f"the way of what swings on {root}"
        pose = units[u].members[root]
        boxes: list[Prism] = [(*p[:6], max(p[6], 0.5), p[7]) for p in prisms]  # type: ignore[misc]  # eight numbers
        out.append(Obstacle(u, pose, z[root], tuple(boxes), frozenset(allowed), False, label))
    return out


def _start_reach(c: Corridor, unit: Unit, shape: dict[str, Shape]) -> float:
    """How far the corridor reaches back from its first point: the mover that stands there."""
    x, y = c.points_cm[0]
    reach = [
        math.hypot(shape[n].hx, shape[n].hy)
        for n, p in unit.members.items()
        if math.hypot(p[0] - x, p[1] - y) < 1.0 and not shape[n].is_decal
    ]
    return min([c.half_width_cm, *(r + 1.0 for r in reach)])


def is_road(doc: EsgDocument, name: str) -> bool:
    """Whether a decal is something that vehicles or balls run along, not a pavement beside it."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    if is_pavement(config):
        return False
    words = f"{config.category} {config.asset_name} {name}".lower().replace("_", " ")
    return bool(set(words.replace("-", " ").split()) & set(ROAD_WORDS))


def _road(
    doc: EsgDocument,
    u: int,
    name: str,
    pose: Pose2,
    units: list[Unit],
    supports: SupportMap,
    shape: dict[str, Shape],
) -> Obstacle:
    graph = doc.spatial_relation_graph
    allowed = {n for unit in units if unit.is_planned for n in unit.members}
    for e in graph.edges.binary_relations:
        if e.relation_type in ON_IT and name in (e.from_, e.to):
            allowed |= {e.from_, e.to}
    allowed |= {n for n in graph.nodes if name in supports.chain(n)}
    allowed |= {n for n in graph.nodes if set(supports.chain(n)) & allowed}
    s = shape[name]
    prism = (float(RECTANGLE), 0.0, 0.0, 0.0, s.hx, s.hy, 0.5, CLEAR_HEIGHT_CM)
    return Obstacle(u, pose, 0.0, (prism,), frozenset(allowed), False, name)
