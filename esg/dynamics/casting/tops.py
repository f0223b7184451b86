"""Tables and shelves with room for what goes about on them: past a thing, round it, between two.

Where the prompt leaves its size open, a top on which a way does not fit grows. What turns on it
finds it smooth: soles and tyres of a toy would be held back by friction in every step of its turn.
"""

from __future__ import annotations

from esg.dynamics.casting.changes import Configs, resized
from esg.dynamics.story.stagecraft import broadest_surface, prop, stays_on
from esg.dynamics.story.story import Story
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, Predicate

LARGER = 2.0
"""Most that a top grows."""
BESIDE_M, EDGE_M = 0.12, 0.05
"""Gap to what is passed or gone round, and to the edge."""
BEND_M = 0.35
"""Radius of a way round and round about nothing."""
RUN_M = 0.6
"""Way before and behind what is passed."""
SMOOTH = 0.1
"""Friction of a top on which something turns."""
Room = tuple[float, float]
"""Along and across a way [m]."""


def fit_tops(doc: EsgDocument, story: Story) -> Configs:
    """Larger, and smoother, tops."""
    nodes, needed, turned = doc.spatial_relation_graph.nodes, dict[str, Room](), set[str]()
    for actor in story.phases:
        host = stays_on(doc, actor)
        if host is None or story.flies(actor):
            continue
        along, across = needed.get(host, (0.0, 0.0))
        for room in _rooms(doc, story, actor, host):
            along, across = max(along, room[0]), max(across, room[1])
        needed[host] = (along, across)
        if any(p.edge.event is EdgeEvent.TURN for p in story.phases[actor]):
            turned.add(host)
    out: Configs = {}
    for host, (along, across) in sorted(needed.items()):
        key = nodes[host].asset_id
        config = doc.asset_configurations[key]
        if not doc.asset_requirement[key].dimensions_are_prescribed and not config.is_wheeled:
            half = broadest_surface(doc, host).half_extents_cm
            long, short = (0, 1) if half[0] >= half[1] else (1, 0)
            size = [*config.dimensions_cm]
            for axis, need in ((long, along), (short, across)):
                size[axis] *= min(max(50.0 * need / half[axis], 1.0), LARGER)
            if tuple(size) != config.dimensions_cm:
                made = resized(doc, key, config, 1.0, dimensions=(size[0], size[1], size[2]))
                config = made.model_copy(update={"is_movable": config.is_movable})
                out[key] = config
        if host in turned and config.friction > SMOOTH:
            out[key] = config.model_copy(update={"friction": SMOOTH})
    return out


def _rooms(doc: EsgDocument, story: Story, actor: str, host: str) -> list[Room]:
    """What each of the ways of an actor on its host asks for."""
    body, edge = prop(doc, actor), 2.0 * EDGE_M
    out: list[Room] = []
    for node in story.nodes.values():
        others = [i for i in node.participants if i not in (actor, host)]
        if node.event is not NodeEvent.MISS or node.participants[0] != actor or not others:
            continue
        its = prop(doc, others[0])
        wide = max(its.length, its.width)
        out.append((RUN_M + 2.0 * body.length, body.width + wide + BESIDE_M + edge))
    for s in doc.statements or ():
        if s.predicate is not Predicate.MOVES or actor not in s.object:
            continue
        others = [
            prop(doc, i) for i in s.target if not doc.spatial_relation_graph.nodes[i].is_structural
        ]
        if s.direction == "between" and len(others) > 1:
            wide = sum(min(o.length, o.width) for o in others[:2])
            out.append((RUN_M, body.width + wide + 2.0 * BESIDE_M + edge))
        elif s.direction == "around":
            reach = BEND_M
            if others:
                reach = 0.5 * (others[0].length ** 2 + others[0].width ** 2) ** 0.5
                reach += body.half_width + BESIDE_M
            across = 2.0 * (reach + body.half_width) + 2.0 * edge
            out.append((across + body.length + 2.0 * edge, across))
        elif s.direction == "toward" and others:
            out.append((RUN_M + body.length + others[0].length, 0.0))
    return out
