"""Bodies that the timeline moves are movable, those that it meets are solid, large and lively."""

from __future__ import annotations

import itertools
import math

from esg.dynamics.casting.changes import Configs, resized
from esg.dynamics.story.stagecraft import lies_on, prop
from esg.dynamics.story.story import Story
from esg.graph.models import EsgDocument, NodeEvent, Proxy, ProxyKind
from esg.units import GRAVITY_MPS2

TIPPING_IMPULSE_NS = 0.4
"""Impulse a tipping body shall pass on: well over the 0.1 N s that counts as a hit."""
SPRINGY = 0.95
"""Restitution of a wall that something bounces off to hit something else."""
THINNEST_CM = 1.0
"""Least thickness of a mat on which something lands."""
LARGEST = 5.0
"""Most that anything is enlarged."""
UNFOUNDED = frozenset({
    "counter", "goal", "hoop", "kennel", "net", "pallet", "parasol", "sandbox", "scaffold", "stand",
    "swing", "table", "wreck",
})  # fmt: skip
"""Words of categories of what is too heavy for a ball and yet only stands on the ground."""
MANY_TIMES = 5.0
"""So many times as heavy is a vehicle that shoves such things aside."""
DULL = 0.1
"""Most restitution of what is to lie where it lands."""
MOVES = (NodeEvent.TOPPLE, NodeEvent.FALL, NodeEvent.STOP)


def fit_freed(doc: EsgDocument, story: Story) -> EsgDocument:
    """The document in which what is knocked over is not fixed: a bollard, a lamp.

    Nor is what only stands on the ground (a goal, a counter) when a vehicle many times as heavy
    runs into it.
    """
    graph = doc.spatial_relation_graph
    moved = {
        p
        for node in story.nodes.values()
        if node.event in (NodeEvent.TOPPLE, NodeEvent.FALL)
        for p in node.participants
    } | _run_down(doc, story)
    freed = {
        n: v.model_copy(update={"is_static": False})
        for n, v in graph.nodes.items()
        if n in moved and v.is_static and not v.is_structural
    }
    if not freed:
        return doc
    graph = graph.model_copy(update={"nodes": {**graph.nodes, **freed}})
    return doc.model_copy(update={"spatial_relation_graph": graph})


def _run_down(doc: EsgDocument, story: Story) -> set[str]:
    """What has no foundation and is run into by a vehicle that is much heavier."""
    nodes = doc.spatial_relation_graph.nodes
    out: set[str] = set()
    for event in story.nodes.values():
        if event.event is not NodeEvent.COLLISION:
            continue
        a, b = (p.removeprefix("group:") for p in event.participants[:2])
        for mover, met in ((a, b), (b, a)):
            if mover not in nodes or met not in nodes or not prop(doc, met).fixed:
                continue
            category = doc.asset_configurations[nodes[met].asset_id].category
            runs = prop(doc, mover).wheeled and mover in story.phases
            heavy = prop(doc, mover).mass > MANY_TIMES * prop(doc, met).mass
            if runs and heavy and set(category.split("_")) & UNFOUNDED:
                out.add(met)
    return out


def fit_movable(doc: EsgDocument, story: Story) -> Configs:
    """What the timeline moves and what a joint holds, movable: a deck of asphalt turns, too."""
    assert doc.timeline_system is not None
    names = {e.actor for e in doc.timeline_system.sequence_graph.edges}
    for node in story.nodes.values():
        if node.event in MOVES and node.participants:
            names.update(story.expand(node.participants[0]))
    names |= _run_down(doc, story)
    names |= {j.child for j in doc.spatial_relation_graph.joints or ()}
    out: Configs = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        config = doc.asset_configurations.get(node.asset_id)
        if name not in names or node.is_structural or node.is_static or config is None:
            continue
        if not config.is_movable:
            out[node.asset_id] = config.model_copy(update={"is_movable": True})
    return out


def fit_solid(doc: EsgDocument, story: Story) -> Configs:
    """Thin bodies for what something lands on and is usually drawn flat: a mat, a rug."""
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
    for node in story.nodes.values():
        for name in node.participants if node.event is NodeEvent.COLLISION else ():
            if name not in nodes or nodes[name].is_structural:
                continue
            config = doc.asset_configurations[nodes[name].asset_id]
            if config.proxies:
                continue
            length, width, height = config.dimensions_cm
            half = 0.5 * max(height, THINNEST_CM)
            slab = Proxy(
                kind=ProxyKind.BOX,
                size_cm=(0.5 * length, 0.5 * width, half),
                position_cm=(0.0, 0.0, half),
            )
            out[nodes[name].asset_id] = config.model_copy(
                update={
                    "proxies": (slab,),
                    "center_of_mass_cm": (0.0, 0.0, half),
                    "is_movable": False,
                }
            )
    return out


def fit_grown(doc: EsgDocument, story: Story) -> Configs:
    """Dominoes and the like large enough that their hits are hits.

    A body that tips onto its equal passes on about 0.35 m sqrt(g h). Of toy dominoes that is a
    hundredth of what counts as a collision, so that the chain is built of garden dominoes where
    the prompt leaves the size open.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
    for node in story.nodes.values():
        if node.event is not NodeEvent.COLLISION or len(node.participants) < 2:
            continue
        a, b = node.participants[:2]
        if a not in nodes or b not in nodes or not story.topples(a):
            continue
        keys = {nodes[a].asset_id, nodes[b].asset_id}
        first, second = (doc.asset_configurations[nodes[n].asset_id] for n in (a, b))
        wanted = [doc.asset_requirement[k] for k in sorted(keys)]
        if first.category != second.category or any(
            r.mass_is_prescribed or r.dimensions_are_prescribed for r in wanted
        ):
            continue
        passed = 0.35 * first.mass_kg * math.sqrt(GRAVITY_MPS2 * first.dimensions_cm[2] / 100.0)
        factor = (TIPPING_IMPULSE_NS / max(passed, 1e-9)) ** (1.0 / 3.5)
        if not 1.0 < factor <= LARGEST:
            continue
        for key in sorted(keys):
            out[key] = resized(doc, key, doc.asset_configurations[key], factor)
    return out


def fit_springy(doc: EsgDocument, story: Story) -> Configs:
    """Walls that throw a ball back which shall go on to something else.

    A rolling ball's spin costs it two sevenths of its speed after the bounce, so that off a dull
    wall it hardly comes back.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
    for node in story.nodes.values():
        if node.event is not NodeEvent.COLLISION or len(node.participants) < 2:
            continue
        for a, b in itertools.permutations(node.participants[:2]):
            if a not in nodes or b not in nodes or prop(doc, a).fixed:
                continue
            goes_on = any(
                n.event is NodeEvent.COLLISION and a in n.participants for n in story.after(node.id)
            )
            if not goes_on or not prop(doc, b).fixed or prop(doc, a).wheeled:
                continue
            config = doc.asset_configurations[nodes[b].asset_id]
            if config.proxies and config.restitution < SPRINGY:
                out[nodes[b].asset_id] = config.model_copy(update={"restitution": SPRINGY})
    return out


def fit_landed(doc: EsgDocument, story: Story) -> Configs:
    """What comes down on something and is to stay there hardly bounces."""
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
    for thing in nodes:
        hosts = [n for n in nodes if lies_on(doc, thing, n)]
        if not hosts or (thing in story.phases and story.soars(thing)):
            continue
        for name, most in ((thing, DULL), *((host, 0.0) for host in hosts)):
            config = doc.asset_configurations[nodes[name].asset_id]
            if config.restitution > most:
                out[nodes[name].asset_id] = config.model_copy(update={"restitution": most})
    return out
