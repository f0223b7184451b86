"""Streets as long as what drives on them needs, with pavements, and ground that reaches as far."""

from __future__ import annotations

import math

from esg.dynamics.casting.changes import Configs, resized
from esg.graph.models import Choreography, EsgDocument, Predicate
from esg.layout.problem.streets import PAVEMENTS, streets_in, words_of

CROSSROADS = "crossroads"
"""Asset of two roads that cross."""
SIGHT_CM = 2000.0
"""Street that is seen before the first start and behind the last end."""
APART_CM = 1000.0
"""Between ways on one street that nothing joins."""
STEP_CM = 1000.0
"""Streets grow in steps, so that scenes alike share one."""
LONGEST_CM = 40000.0
"""Longest street that is drawn."""
BESIDE_CM = 150.0
"""Deck that is left around the ways on it."""
RUN_OUT_S = 2.0
"""Ground reaches so far beyond all ways as the fastest goes on in this time [s]."""


def fit_roads(doc: EsgDocument, told: Choreography) -> Configs:
    """Streets and ground large enough for what was told.

    The street of a scene covers all planned ways, with pavements as long; the ground covers what
    rolls on after them, too.

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
    if not any(len(points) > 1 for points in ways):
        return {}
    lengths = [max((math.dist(p, q) for p in w for q in w), default=0.0) for w in ways]
    way = max(lengths)
    # Ways that nothing joins lie one behind another, in an order that the layout finds.
    apart = [w for w, c in zip(lengths, told.constellations, strict=True) if c.corridors]
    along = max(way, sum(apart) + APART_CM * (len(apart) - 1))
    length = min(STEP_CM * math.ceil((along + 2.0 * SIGHT_CM) / STEP_CM), LONGEST_CM)
    out = _wider_ground(doc, way, max(_speeds(told), default=0.0)) | _wider_decks(doc, told)
    for name in lengthened:
        key = nodes[name].asset_id
        config, wanted = doc.asset_configurations[key], doc.asset_requirement[key]
        if not wanted.dimensions_are_prescribed and config.dimensions_cm[0] < length:
            _, width, height = config.dimensions_cm
            crosses = config.asset_name == CROSSROADS
            size = (length, length if crosses else width, height)
            out[key] = resized(doc, key, config, 1.0, dimensions=size)
    return out


def _wider_decks(doc: EsgDocument, told: Choreography) -> Configs:
    """Stages and piers so large that those who are said to be on them stay over them."""
    nodes, out = doc.spatial_relation_graph.nodes, Configs()
    for s in doc.statements or ():
        decks = [n for n in s.target if n in nodes and nodes[n].is_structural]
        if s.predicate is not Predicate.SUPPORTED_BY or len(decks) != 1:
            continue
        key = nodes[decks[0]].asset_id
        config, wanted = doc.asset_configurations[key], doc.asset_requirement[key]
        if wanted.dimensions_are_prescribed or config.proxies or decks[0] in streets_in(doc):
            continue
        length, width, height = config.dimensions_cm
        for who in s.object:
            long, aside = _extent(told, who)
            length, width = max(length, long + BESIDE_CM), max(width, 2.0 * aside + BESIDE_CM)
        if (length, width) != config.dimensions_cm[:2] and length <= LONGEST_CM:
            out[key] = resized(doc, key, config, 1.0, dimensions=(length, width, height))
    return out


def _extent(told: Choreography, who: str) -> tuple[float, float]:
    """How long somebody's way is and how far it leads aside of how it begins [cm]."""
    for c in told.constellations:
        start = next((p for p in c.placements if p.node == who), None)
        points = [p for k in c.corridors if who in k.participants for p in k.points_cm]
        if start is not None and points:
            yaw = math.radians(start.yaw_deg or 0.0)
            turned = [
                ((x - start.x_cm) * math.cos(yaw) + (y - start.y_cm) * math.sin(yaw),
                 (y - start.y_cm) * math.cos(yaw) - (x - start.x_cm) * math.sin(yaw))
                for x, y in points
            ]  # fmt: skip
            along = [x for x, _ in turned]
            return max(along) - min(along), max(abs(y) for _, y in turned)
    return 0.0, 0.0


def _speeds(told: Choreography) -> list[float]:
    """All speeds of a choreography [m/s]."""
    return [value for name, value in told.nominal.items() if name.endswith("/speed")]


def _wider_ground(doc: EsgDocument, way: float, speed: float) -> Configs:
    """The ground of a scene so large that a way [cm] and a run-out at a speed [m/s] fit on it."""
    nodes = doc.spatial_relation_graph.nodes
    keys = {v.asset_id for v in nodes.values() if v.is_structural}
    flat = [k for k in sorted(keys) if not doc.asset_configurations[k].proxies]
    key = max(flat, key=lambda k: math.prod(_sides(doc, k)), default=None)
    if key is None or doc.asset_requirement[key].dimensions_are_prescribed:
        return {}
    needed = STEP_CM * math.ceil((way + 200.0 * RUN_OUT_S * speed) / STEP_CM)
    if min(_sides(doc, key)) >= needed:
        return {}
    config = doc.asset_configurations[key]
    length, width, height = config.dimensions_cm
    least = min(needed, LONGEST_CM)
    size = (max(length, least), max(width, least), height)
    return {key: resized(doc, key, config, 1.0, dimensions=size)}


def _sides(doc: EsgDocument, key: str) -> tuple[float, float]:
    return doc.asset_configurations[key].dimensions_cm[:2]


def _follows(doc: EsgDocument, name: str, streets: list[str]) -> bool:
    """Whether a decal is a street, lies along it, or is where vehicles turn off."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    beside = bool(streets and words_of(doc, name) & PAVEMENTS)
    drives = any(c.is_wheeled for c in doc.asset_configurations.values())
    return drives and (name in streets or beside or config.asset_name == CROSSROADS)
