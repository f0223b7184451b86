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
    names = list(doc.spatial_relation_graph.nodes)
    airborne = {n: z for u in builder.units for n, z in u.z_cm.items()}
    lift: dict[str, float] = {}

    def solve() -> dict[str, float]:
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

    z = solve()
    edges = [
        e
        for e in doc.spatial_relation_graph.edges.binary_relations
        if e.from_ in z
        and e.to in z
        and (e.relation_type in LEVEL or e.relation_type is RelationType.ABOVE)
    ]  # fmt: skip
    for _ in range(PASSES if edges else 0):
        for e in edges:
            for mine, other, sign in ((e.from_, e.to, 1.0), (e.to, e.from_, -1.0)):
                s = supports.of[mine]
                if s.kind not in ("vertical", "above") or s.parent is None:
                    continue
                here, there = middle(mine, z, shape), middle(other, z, shape)
                want = here
                if e.relation_type is RelationType.SAME_LEVEL_AS:
                    want = there
                elif e.relation_type is RelationType.LOWER_THAN:
                    want = (
                        min(here, there - MARGIN_CM) if sign > 0 else max(here, there + MARGIN_CM)
                    )
                elif e.relation_type is RelationType.HIGHER_THAN:
                    want = (
                        max(here, there + MARGIN_CM) if sign > 0 else min(here, there - MARGIN_CM)
                    )
                elif sign > 0:
                    clear = 0.5 * (shape[mine].height + shape[other].height) + MARGIN_CM
                    want = max(here, there + clear)
                room = max(0.0, shape[s.parent].height - shape[mine].height)
                at = z[mine] - z[s.parent] + want - here
                if s.kind == "vertical":
                    at = min(max(at, 0.0), room)
                lift[mine] = at - s.z_cm
                z = solve()
    return z
