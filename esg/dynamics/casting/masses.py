"""Masses at which a hit passes on the speed that the next event asks for."""

from __future__ import annotations

import math

from esg.dynamics.casting.changes import Configs, scaled
from esg.dynamics.casting.hits import fastest, launched
from esg.dynamics.choreography.hits.demands import felt_speed, passed_on, run_on_speed
from esg.dynamics.choreography.slopes import fastest_down, rides
from esg.dynamics.choreography.stage import FASTEST_MPS
from esg.dynamics.story.stagecraft import default_speed, prop
from esg.dynamics.story.story import Story, bounds, hits
from esg.graph.models import EsgDocument, NodeEvent, TimelineNode

LIGHTEST, HEAVIEST = 0.3, 2.5
"""Least and largest share of the usual mass: an empty van against a loaded one."""
ARRIVES = 0.9
"""Share of its speed with which a ball that was set rolling arrives and is passed on."""


def fit_transfer(doc: EsgDocument, story: Story) -> Configs:
    """Masses at which a hit of prescribed speed gives its target the prescribed speed.

    Of a central impact v_b = (1 + e) m_a / (m_a + m_b) v_a. Both masses give way, as far as they
    are open and such a thing may weigh.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
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


def fit_pushes(doc: EsgDocument, story: Story) -> Configs:
    """Masses at which what is run into slides or rolls on to what it shall hit: a parked truck.

    Of v_b = (1 + e) m_a / (m_a + m_b) v_a at the highest speed that the mover may have.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
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


def fit_slow(doc: EsgDocument, story: Story) -> Configs:
    """Masses at which the hit of what creeps or goes slowly is felt: a toy that nudges a gate.

    Of those that a word, not the kind, gives their speed: both grow as far as they may weigh.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: Configs = {}
    for node, a, b in hits(doc, story):
        phase = next((p for p in story.phases.get(a, ()) if p.end.id == node.id), None)
        first, second = prop(doc, a), prop(doc, b)
        if phase is None or phase.edge.speed_is_prescribed or phase.edge.params.speed is None:
            continue
        _, high, _ = bounds(phase.edge.params.speed, (0.0, 100.0 * FASTEST_MPS))
        # What is let go has no speed of its own; a fall is felt by what it falls on.
        if high <= 0.0 or story.is_active(b) or first.rolls or high >= 100.0 * default_speed(first):
            continue
        more = felt_speed(first, second) / (0.01 * high)
        for key in {nodes[name].asset_id for name in (a, b)} if more > 1.0 else ():
            if not doc.asset_requirement[key].mass_is_prescribed:
                out[key] = scaled(doc.asset_configurations[key], min(more, HEAVIEST))
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
