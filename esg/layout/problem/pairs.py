"""Which objects can collide, how much air they keep, and which should not hide one another."""

from __future__ import annotations

import numpy as np

from esg.graph.models import EsgDocument, RelationType
from esg.layout.problem.edges import characteristic
from esg.layout.problem.obstacles import Obstacle, Prism
from esg.layout.problem.supports import Shape, SupportMap

TOUCH_CM = 0.2
CORRIDOR_MARGIN_CM = 0.5
LEAST_MARGIN_CM, MOST_MARGIN_CM = 0.7, 4.0
COVERING = (
    RelationType.UNDER,
    RelationType.ABOVE,
    RelationType.INSIDE_OF,
    RelationType.ON,
    RelationType.NEAR,
    RelationType.ADJACENT,
)


def collision_pairs(
    doc: EsgDocument,
    names: list[str],
    node_unit: list[int],
    node_z: list[float],
    prims: list[list[Prism]],
    blocked: list[Obstacle],
    supports: SupportMap,
    shape: dict[str, Shape],
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pairs of nodes in different units whose shapes share a height interval.

    Args:
        doc: The document.
        names: Real nodes; nodes beyond them are obstacles, in the order of `blocked`.
        node_unit: Unit of every node.
        node_z: Height of every origin [cm].
        prims: Shapes of every node.
        blocked: Obstacles.
        supports: Supports.
        shape: Geometry.

    Returns:
        Node pairs [n, 2] (an obstacle comes second), the air they keep [cm], and 1 where neither
        should stand under or over the other unless told to.
    """
    spans = [
        (
            min((p[6] for p in ps), default=0.0) + z,
            max((p[7] for p in ps), default=0.0) + z,
        )
        for ps, z in zip(prims, node_z, strict=True)
    ]
    chains = [set(supports.chain(n)) for n in names]
    told = {
        frozenset((e.from_, e.to))
        for e in doc.spatial_relation_graph.edges.binary_relations
        if e.relation_type in COVERING
    }
    for m in doc.spatial_relation_graph.edges.multi_relations:
        told |= {frozenset((s, t)) for s in m.subjects for t in m.targets}
    exempt = [o.exempt for o in blocked]
    pair: list[tuple[int, int]] = []
    margin: list[float] = []
    avoid: list[float] = []
    solid = [i for i, ps in enumerate(prims) if ps]
    count = len(names)
    for at, i in enumerate(solid):
        for j in solid[:at]:
            if node_unit[i] == node_unit[j]:
                continue
            if min(spans[i][1], spans[j][1]) - max(spans[i][0], spans[j][0]) <= TOUCH_CM:
                continue
            if i >= count:
                if j < count and names[j] not in exempt[i - count]:
                    pair.append((j, i))
                    margin.append(CORRIDOR_MARGIN_CM)
                    avoid.append(0.0)
                continue
            a, b = names[j], names[i]
            room = 0.04 * min(characteristic(shape[a]), characteristic(shape[b]))
            room = min(max(room, LEAST_MARGIN_CM), MOST_MARGIN_CM)
            carried = b in chains[j] or a in chains[i]
            pair.append((j, i))
            margin.append(min(room, LEAST_MARGIN_CM) if carried else room)
            apart = not carried and supports.of[a].parent == supports.of[b].parent
            avoid.append(float(apart and frozenset((a, b)) not in told))
    return (
        np.asarray(pair, np.int32).reshape(-1, 2),
        np.asarray(margin, np.float32),
        np.asarray(avoid, np.float32),
    )
