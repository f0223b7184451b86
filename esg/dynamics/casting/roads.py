"""Streets as long as what drives on them needs, and the pavements beside them."""

from __future__ import annotations

import itertools
import math

from esg.dynamics.casting.changes import Configs, resized
from esg.graph.models import Choreography, EsgDocument
from esg.layout.problem.streets import PAVEMENTS, streets_in, words_of

CROSSROADS = "crossroads"
"""Asset of two roads that cross."""
SIGHT_CM = 2000.0
"""Street that is seen before the first start and behind the last end."""
STEP_CM = 1000.0
"""Streets grow in steps, so that scenes alike share one."""
LONGEST_CM = 40000.0
"""Longest street that is drawn."""


def fit_roads(doc: EsgDocument, told: Choreography) -> Configs:
    """The street of a scene at a length that covers all planned ways, with pavements as long.

    Args:
        doc: A document with assets, its other choices made.
        told: Its choreography: starts and ways.
    """
    nodes = doc.spatial_relation_graph.nodes
    streets = streets_in(doc)
    lengthened = [n for n, v in nodes.items() if v.is_structural and _follows(doc, n, streets)]
    ways = [
        [*((p.x_cm, p.y_cm) for p in c.placements), *(p for k in c.corridors for p in k.points_cm)]
        for c in told.constellations
    ]
    if not lengthened or not any(len(points) > 1 for points in ways):
        return {}
    way = max(math.dist(p, q) for points in ways for p, q in itertools.product(points, points))
    length = min(STEP_CM * math.ceil((way + 2.0 * SIGHT_CM) / STEP_CM), LONGEST_CM)
    out: Configs = {}
    for name in lengthened:
        key = nodes[name].asset_id
        config, wanted = doc.asset_configurations[key], doc.asset_requirement[key]
        if not wanted.dimensions_are_prescribed and config.dimensions_cm[0] < length:
            _, width, height = config.dimensions_cm
            crosses = config.asset_name == CROSSROADS
            size = (length, length if crosses else width, height)
            out[key] = resized(doc, key, config, 1.0, dimensions=size)
    return out


def _follows(doc: EsgDocument, name: str, streets: list[str]) -> bool:
    """Whether a decal is a street, lies along it, or is where vehicles turn off."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    beside = bool(streets and words_of(doc, name) & PAVEMENTS)
    drives = any(c.is_wheeled for c in doc.asset_configurations.values())
    return drives and (name in streets or beside or config.asset_name == CROSSROADS)
