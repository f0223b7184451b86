"""Casting: which of several plausible bodies an action needs.

A prompt that has a football knock over a crate means a crate that a football can knock over. Where
the prompt leaves a mass open, the lightest plausible body is still that kind of thing (an empty
crate); where an event sets a thing in motion, it is not screwed to the floor.
"""

from __future__ import annotations

import itertools
import math

from esg.dynamics.casting.containers import fit_containers, resized, with_assets
from esg.dynamics.casting.dominoes import fit_falling
from esg.dynamics.casting.fitting import fit_motion
from esg.dynamics.casting.loads import fit_loads
from esg.dynamics.casting.openings import fit_openings
from esg.dynamics.casting.toppling import LIGHTEST, fastest, fit_toppled, hits, launched, scaled
from esg.dynamics.casting.upright import fit_upright
from esg.dynamics.choreography.bounces import let_go_sideways, lively_tops
from esg.dynamics.choreography.demands import passed_on, run_on_speed
from esg.dynamics.choreography.slopes import fastest_down, rides
from esg.dynamics.story.stagecraft import climb_height, prop, support_of, top_surface
from esg.dynamics.story.story import Phase, Story, bounds, read_story
from esg.graph.models import (
    AssetConfiguration,
    EdgeEvent,
    EsgDocument,
    ForceDirection,
    NodeEvent,
    Proxy,
    ProxyKind,
    TimelineNode,
)
from esg.units import GRAVITY_MPS2

TIPPING_IMPULSE_NS = 0.4
"""Impulse a tipping body shall pass on: well over the 0.1 N s that counts as a hit."""
SPRINGY = 0.95
"""Restitution of a wall that something bounces off to hit something else."""
HEAVIEST = 2.5
"""Largest share of the usual mass: a loaded van against an empty one."""
ARRIVES = 0.9
"""Share of its speed with which a ball that was set rolling arrives and is passed on."""
THINNEST_CM = 1.0
"""Least thickness of a mat on which something lands."""
LARGEST = 5.0
"""Most that anything is enlarged."""
MOVES = (NodeEvent.TOPPLE, NodeEvent.FALL, NodeEvent.STOP)


def fit_assets(doc: EsgDocument) -> EsgDocument:
    """Adapts what the prompt leaves open of the assets to what the timeline needs.

    Args:
        doc: A document with assets resolved.

    Returns:
        The document; only `asset_configurations` may differ, who is thrown, and whether what is
        knocked over is fixed to the ground.
    """
    doc = with_assets(doc, fit_loads(doc))
    if doc.timeline_system is None:
        return doc
    doc = let_go_sideways(_thrown(doc))
    story = read_story(doc)
    doc = _freed(doc, story)
    upright = fit_upright(doc, story)
    doc = with_assets(doc, upright)
    if upright:
        doc = with_assets(doc, fit_loads(doc))  # a row of them needs more room than they took flat
    changed: dict[str, AssetConfiguration] = {}
    nodes = doc.spatial_relation_graph.nodes
    for name in _set_in_motion(doc, story):
        config = doc.asset_configurations[nodes[name].asset_id]
        if not config.is_movable:
            changed[nodes[name].asset_id] = config.model_copy(update={"is_movable": True})
    doc = with_assets(doc, {**changed, **_solid(doc, story), **_grown(doc, story)})
    doc = with_assets(doc, fit_falling(doc, story))
    doc = with_assets(doc, fit_openings(doc, story))
    doc = fit_motion(with_assets(doc, fit_containers(doc, story)), story)
    doc = with_assets(doc, _springy(doc, story))
    doc = with_assets(doc, lively_tops(doc, story))
    doc = with_assets(doc, _for_transfer(doc, story))
    doc = with_assets(doc, _for_pushes(doc, story))
    return fit_toppled(doc, story)


def _freed(doc: EsgDocument, story: Story) -> EsgDocument:
    """The document in which what is knocked over is not fixed: a bollard, a lamp."""
    graph = doc.spatial_relation_graph
    moved = {
        p
        for node in story.nodes.values()
        if node.event in (NodeEvent.TOPPLE, NodeEvent.FALL)
        for p in node.participants
    }
    freed = {
        n: v.model_copy(update={"is_static": False})
        for n, v in graph.nodes.items()
        if n in moved and v.is_static and not v.is_structural
    }
    if not freed:
        return doc
    graph = graph.model_copy(update={"nodes": {**graph.nodes, **freed}})
    return doc.model_copy(update={"spatial_relation_graph": graph})


def _solid(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Thin bodies for what something lands on and is usually drawn flat: a mat, a rug."""
    nodes = doc.spatial_relation_graph.nodes
    out: dict[str, AssetConfiguration] = {}
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


def _thrown(doc: EsgDocument) -> EsgDocument:
    """Has thrown what would have to roll to a target that is out of its reach.

    How high a hat sits is known only once the snowman is: a snowball on the ground passes under it.
    """
    assert doc.timeline_system is not None
    story = read_story(doc)
    actors = dict(doc.timeline_system.actors)
    for actor, phases in story.phases.items():
        first, body = phases[0], prop(doc, actor)
        targets = [p for p in first.end.participants if p != actor]
        if first.edge.event is not EdgeEvent.TOWARD or not body.rolls or not targets:
            continue
        if first.end.event is not NodeEvent.COLLISION or story.flies(actor):
            continue
        if _enters_out_of_reach(doc, phases, body.height):
            actors[actor] = actors[actor].model_copy(
                update={"force_direction": ForceDirection.ANY_3D}
            )
            continue
        support = support_of(doc, targets[0])
        if support is None or support in (actor, support_of(doc, actor)):
            continue
        height = top_surface(doc, support).center_cm[2] / 100.0
        if height > body.height and climb_height(doc, body, support) is None:
            actors[actor] = actors[actor].model_copy(
                update={"force_direction": ForceDirection.ANY_3D}
            )
    timeline = doc.timeline_system.model_copy(update={"actors": actors})
    return doc.model_copy(update={"timeline_system": timeline})


def _enters_out_of_reach(doc: EsgDocument, phases: tuple[Phase, ...], height: float) -> bool:
    """Whether something shall enter a region that begins above its own height: a hoop."""
    nodes = doc.spatial_relation_graph.nodes
    for phase in phases:
        owner, _, name = (phase.end.region or "").partition("/")
        if phase.end.event is not NodeEvent.ENTER_REGION or owner not in nodes:
            continue
        for region in doc.asset_configurations[nodes[owner].asset_id].regions:
            lowest = (region.center_cm[2] - region.half_extents_cm[2]) / 100.0
            if region.name == name and lowest > 2.0 * height:
                return True
    return False


def _grown(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Dominoes and the like large enough that their hits are hits.

    A body that tips onto its equal passes on about 0.35 m sqrt(g h). Of toy dominoes that is a
    hundredth of what counts as a collision, so that the chain is built of garden dominoes where
    the prompt leaves the size open.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: dict[str, AssetConfiguration] = {}
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


def _for_transfer(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Masses at which a hit of prescribed speed gives its target the prescribed speed.

    Of a central impact v_b = (1 + e) m_a / (m_a + m_b) v_a. Both masses give way, as far as they
    are open and such a thing may weigh.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: dict[str, AssetConfiguration] = {}
    for node, a, b, asked in _transfers(story):
        speed = _prescribed_speed(story, a, node.id)
        if a not in nodes or b not in nodes or speed is None or asked <= 0.0:
            continue
        keys = nodes[a].asset_id, nodes[b].asset_id
        first, second = prop(doc, a), prop(doc, b)
        if first.rolls and launched(story, a, node.id):
            speed *= ARRIVES
        gain = (1.0 + 0.5 * (first.restitution + second.restitution)) * speed / asked
        if gain <= 1.0 or keys[0] == keys[1] or second.fixed:
            continue
        factor = (gain - 1.0) * first.mass / second.mass
        if abs(math.log(factor)) < math.log(1.05):
            continue
        target = mover = 1.0
        if not doc.asset_requirement[keys[1]].mass_is_prescribed:
            target = min(max(factor, LIGHTEST), HEAVIEST)
        if not doc.asset_requirement[keys[0]].mass_is_prescribed:
            mover = min(max(target / factor, LIGHTEST), HEAVIEST)
        for key, share in zip(keys, (mover, target), strict=True):
            if share != 1.0:
                out[key] = scaled(doc.asset_configurations[key], share)
    return out


def _for_pushes(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Masses at which what is run into slides or rolls on to what it shall hit: a parked truck.

    Of v_b = (1 + e) m_a / (m_a + m_b) v_a at the highest speed that the mover may have.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: dict[str, AssetConfiguration] = {}
    riders = {(end.id, actor) for end, actor, _, _ in rides(doc, story)}
    for node, a, b in hits(doc, story):
        keys = nodes[a].asset_id, nodes[b].asset_id
        first, second = prop(doc, a), prop(doc, b)
        if story.is_active(b) or not story.is_active(a) or second.fixed or keys[0] == keys[1]:
            continue
        if story.topples(b) or not _pushed_into(story, node, b):
            continue
        speed = fastest(story, a, node.id)
        if (node.id, a) in riders:
            speed = min(speed, fastest_down(doc, a) or speed)
        speed *= ARRIVES
        more = run_on_speed(second) / max(passed_on(first, second) * speed, 1e-9)
        if more <= 1.0:
            continue
        share = min(more * first.mass / (first.mass + second.mass), ARRIVES)
        factor = (1.0 / share - 1.0) * first.mass / second.mass
        target = mover = 1.0
        if not doc.asset_requirement[keys[1]].mass_is_prescribed:
            target = max(math.sqrt(factor), LIGHTEST)
        if not doc.asset_requirement[keys[0]].mass_is_prescribed:
            mover = min(target / factor, HEAVIEST)
        if not doc.asset_requirement[keys[1]].mass_is_prescribed:
            target = max(min(mover * factor, 1.0), LIGHTEST)
        for key, times in zip(keys, (mover, target), strict=True):
            if times != 1.0:
                out[key] = scaled(doc.asset_configurations[key], times)
    return out


def _pushed_into(story: Story, node: TimelineNode, b: str) -> bool:
    """Whether what is hit goes on to hit something that does not move by itself."""
    return any(
        n.event is NodeEvent.COLLISION
        and b in n.participants
        and not any(story.is_active(p) for p in n.participants)
        for n in story.after(node.id)
    )


def _transfers(story: Story) -> list[tuple[TimelineNode, str, str, float]]:
    """Hits by an actor after which a resting target shall have a speed: hit, both, speed [m/s]."""
    out: list[tuple[TimelineNode, str, str, float]] = []
    for node in story.nodes.values():
        if node.event is not NodeEvent.COLLISION or len(node.participants) < 2:
            continue
        for c in node.constraints:
            others = [p for p in node.participants if p != c.object]
            if c.quantity == "speed_after" and c.object in node.participants and others:
                low, high, _ = bounds(c.value, (0.0, 0.0))
                if story.is_active(others[0]) and not story.is_active(c.object):
                    out.append((node, others[0], c.object, 0.005 * (low + high)))
    return out


def _prescribed_speed(story: Story, actor: str, node_id: str) -> float | None:
    """Speed [m/s] at which the prompt has an actor arrive at a hit, None where it is open."""
    for phase in story.phases.get(actor, ()):
        speed = phase.edge.params.speed
        if phase.end.id == node_id and phase.edge.speed_is_prescribed and speed is not None:
            low, high, _ = bounds(speed, (0.0, 0.0))
            return 0.005 * (low + high)
    return None


def _springy(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Walls that throw a ball back which shall go on to something else.

    A rolling ball's spin costs it two sevenths of its speed after the bounce, so that off a dull
    wall it hardly comes back.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: dict[str, AssetConfiguration] = {}
    for node in story.nodes.values():
        if node.event is not NodeEvent.COLLISION or len(node.participants) < 2:
            continue
        for a, b in itertools.permutations(node.participants[:2]):
            if a not in nodes or b not in nodes or not story.is_active(a):
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


def _set_in_motion(doc: EsgDocument, story: Story) -> list[str]:
    """Objects that the timeline moves, in the graph's order."""
    assert doc.timeline_system is not None
    names = {e.actor for e in doc.timeline_system.sequence_graph.edges}
    for node in story.nodes.values():
        if node.event in MOVES and node.participants:
            names.update(story.expand(node.participants[0]))
    return [
        n
        for n, v in doc.spatial_relation_graph.nodes.items()
        if n in names and not (v.is_structural or v.is_static)
    ]
