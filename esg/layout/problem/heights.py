"""Heights: constants of the planar problem, because everything rests on something level."""

from __future__ import annotations

from esg.graph.models import EsgDocument, RelationType
from esg.layout.problem.grouping import UnitBuilder
from esg.layout.problem.supports import Shape, SupportMap

MARGIN_CM = 1.0
LEVEL = (RelationType.HIGHER_THAN, RelationType.LOWER_THAN, RelationType.SAME_LEVEL_AS)
PASSES = 4


def middle(name: str, z: dict[str, float], shape: dict[str, Shape]) -> float:
    """Height of an object's middle [cm], which height relations compare."""
    return z[name] + 0.5 * shape[name].height


def heights(
    doc: EsgDocument, builder: UnitBuilder, supports: SupportMap, shape: dict[str, Shape]
) -> dict[str, float]:
    """World height of every origin [cm].

    Objects follow their supports; what hangs on a wall may slide up and down to satisfy
    higher_than, lower_than, same_level_as and above, in a few passes over those edges.
    """
    airborne = {n: z for u in builder.units for n, z in u.z_cm.items()}
    lift: dict[str, float] = {}
    names = list(doc.spatial_relation_graph.nodes)
    z = _resting(names, supports, airborne, lift)
    edges = [
        e
        for e in doc.spatial_relation_graph.edges.binary_relations
        if e.from_ in z and e.to in z and e.relation_type in (*LEVEL, RelationType.ABOVE)
    ]
    for _ in range(PASSES if edges else 0):
        for e in edges:
            for mine, other, first in ((e.from_, e.to, True), (e.to, e.from_, False)):
                s = supports.of[mine]
                if s.kind not in ("vertical", "above") or s.parent is None:
                    continue
                here, there = middle(mine, z, shape), middle(other, z, shape)
                clear = 0.5 * (shape[mine].height + shape[other].height) + MARGIN_CM
                want = _wanted(e.relation_type, first, here, there, clear)
                at = z[mine] - z[s.parent] + want - here
                if s.kind == "vertical":
                    room = max(0.0, shape[s.parent].height - shape[mine].height)
                    at = min(max(at, 0.0), room)
                lift[mine] = at - s.z_cm
                z = _resting(names, supports, airborne, lift)
    return z


def _resting(
    names: list[str], supports: SupportMap, airborne: dict[str, float], lift: dict[str, float]
) -> dict[str, float]:
    """Heights [cm] on the supports, those that may slide lifted by `lift` [cm]."""
    out: dict[str, float] = {}

    def height(name: str, depth: int) -> float:
        if name not in out:
            s = supports.of[name]
            if name in airborne:
                out[name] = airborne[name]
            elif s.parent is None or depth > len(names):
                out[name] = s.z_cm
            else:
                out[name] = height(s.parent, depth + 1) + s.z_cm + lift.get(name, 0.0)
        return out[name]

    for n in names:
        height(n, 0)
    return out


def _wanted(relation: RelationType, first: bool, here: float, there: float, clear: float) -> float:
    """Height [cm] nearest to `here` at which a relation to something `there` holds.

    Args:
        relation: One of `LEVEL`, or above.
        first: Whether what moves is the first of the two that the relation names.
        here, there: Heights of both middles [cm].
        clear: How far apart these are when one is above the other [cm].
    """
    if relation is RelationType.SAME_LEVEL_AS:
        return there
    if relation is RelationType.ABOVE:
        return max(here, there + clear) if first else here
    if (relation is RelationType.HIGHER_THAN) == first:
        return max(here, there + MARGIN_CM)
    return min(here, there - MARGIN_CM)
