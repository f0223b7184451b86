"""Casting of what shall be knocked over: lighter, smaller, hit by something larger, or thrown at.

A traffic cone of full height is met by a rolling ball at the rim of its base, below its centre of
mass, and cannot be tipped; a cone of half the height can, and so can one that the ball is thrown
at. What the prompt states is never touched, and what rolls is not thrown.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
import math
import re

from esg.dynamics.casting.containers import resized, with_assets
from esg.dynamics.choreography.demands import KEPT, passed_on
from esg.dynamics.choreography.slopes import fastest_down, rides
from esg.dynamics.choreography.stage import FASTEST_MPS
from esg.dynamics.story.stagecraft import Prop, fall_speed, prop
from esg.dynamics.story.story import Story, bounds
from esg.dynamics.story.tipping import first_touch, stand_of, topple_speed
from esg.graph.models import (
    AssetConfiguration,
    EdgeEvent,
    EsgDocument,
    ForceDirection,
    NodeEvent,
    TimelineNode,
)
from esg.thresholds import SAFE_IMPULSE_NS

LIGHTEST = 0.3
"""Least share of the usual mass: an empty crate against a loaded one."""
SIZES = (1.0, 0.9, 0.8, 0.7, 0.6, 0.5)
"""Shares of the usual size that such a thing may have."""
SMALL = (*SIZES, 0.4, 0.35, 0.3)
"""The same of what one can carry in a hand: a training cone of 21 cm against one of 71 cm."""
FALLS_TOO = 0.5
"""Share of a stated speed that counts where something thrown falls as well."""
HANDY_KG = 5.0
"""Up to this mass something comes in small."""
SPARE, HARDLY_SMALLER = 0.7, 0.7
"""Share of the highest speed that is to suffice, and the least size that is given for it."""
HARD_MPS = 12.0
"""Speed from which on a hit is a hard one."""
USUAL_CARRIED_MPS = 3.0
"""Speed with which something that was struck arrives at the next thing, where it is open."""
LOW_KICK = 0.25
"""Height of a touch, over that of the centre of mass, below which it kicks the foot away."""
SLOW_MPS, SLOPES, LOADED = 4.0, 0.1, 2.5
"""Highest speed of a slow hit, how far down it points at least on a slope, and the largest share
of its mass that what is hit so is given."""
LARGER = (1.25, 1.5, 2.0)
"""Factors on the size of a mover that comes in all sizes."""
STATED_SIZE = re.compile(r"\b(tall|large|big|huge|giant|enormous|massive|full[- ]size[d]?)\b")
"""What a description says of a thing that is then not made smaller."""
ON_THE_GROUND = re.compile(r"\b(roll|slid|slide|push|shov|bowl(s|ed)\b|putt|dribbl|skid)", re.I)
"""Words of a prompt that keep its movers on the ground."""


@dataclass(frozen=True)
class Knock:
    """A hit that shall tip a resting body over.

    Args:
        node: The hit.
        mover, target: Who hits whom.
        limit: Highest speed [m/s] at which the mover may arrive.
        pushed: Whether it is knocked off what it stands on by what a launch gave the mover.
    """

    node: TimelineNode
    mover: str
    target: str
    limit: float
    pushed: bool


def fit_toppled(doc: EsgDocument, story: Story) -> EsgDocument:
    """What is knocked over, and what does it, as far as the prompt leaves them open.

    Args:
        doc: A document with assets resolved.
        story: Its timeline.
    """
    for knock in _knocks(doc, story):
        doc = _not_overrun(_fitted(doc, story, knock), story, knock)
    return doc


def _knocks(doc: EsgDocument, story: Story) -> list[Knock]:
    nodes = doc.spatial_relation_graph.nodes
    out: list[Knock] = []
    for node, a, b in hits(doc, story):
        if story.is_active(b) or nodes[a].asset_id == nodes[b].asset_id:
            continue
        if story.topples(b) or story.falls(b):
            pushed = story.falls(b) and launched(story, a, node.id)
            limit = fastest(story, a, node.id)
            if not story.is_active(a):
                limit = carried(doc, story, a, node)
            if any(end.id == node.id and actor == a for end, actor, _, _ in rides(doc, story)):
                limit = min(limit, fastest_down(doc, a) or limit)
            out.append(Knock(node, a, b, limit, pushed))
    return out


def hits(doc: EsgDocument, story: Story) -> list[tuple[TimelineNode, str, str]]:
    """Hits of two objects as (hit, mover, target)."""
    nodes = doc.spatial_relation_graph.nodes
    out: list[tuple[TimelineNode, str, str]] = []
    for node in story.nodes.values():
        if node.event is not NodeEvent.COLLISION or len(node.participants) < 2:
            continue
        a, b = node.participants[:2]
        if story.is_active(b) and not story.is_active(a):
            a, b = b, a
        if a in nodes and b in nodes:
            out.append((node, a, b))
    return out


def _fitted(doc: EsgDocument, story: Story, knock: Knock) -> EsgDocument:
    """The document with the least change at which a hit tips its target over."""
    nodes = doc.spatial_relation_graph.nodes
    keys = nodes[knock.mover].asset_id, nodes[knock.target].asset_id
    mover, target = prop(doc, knock.mover), prop(doc, knock.target)
    wanted = doc.asset_requirement[keys[1]]
    topples = story.topples(knock.target)
    flies = story.is_active(knock.mover) and story.flies(knock.mover)
    stand = stand_of(target)
    if topples and _falls_on(story, knock) and _may_be_thrown(doc, story, knock, mover):
        touch = first_touch(mover, target, stand, flies=False)
        if touch is not None and touch.height < LOW_KICK * stand.height:
            # Kicked at its foot it would fall back onto what hit it.
            doc, flies = _thrown(doc, knock.mover), True

    def missing(body: Prop, mass: float, size: float, flies: bool, limit: float) -> bool:
        other = replace(target, mass=target.mass * mass * size**3)
        at = stand.scaled(size)
        speed = topple_speed(body, other, flies=flies, stand=at) if topples else 0.0
        if knock.pushed:
            speed = max(speed, fall_speed(body, other))
        return speed > limit

    free_mass = not wanted.mass_is_prescribed
    open_size = free_mass and not wanted.dimensions_are_prescribed and topples
    said = f"{wanted.asset_description} {nodes[knock.target].label}".lower()
    sizes = SMALL if target.mass <= HANDY_KG else SIZES
    sizes = sizes if open_size and not STATED_SIZE.search(said) else (1.0,)

    def chosen(body: Prop, flies: bool, limit: float, fast: float) -> tuple[float, float] | None:
        """Size and mass, over the usual ones, at which a hit of at most `limit` suffices."""
        for size in sizes:
            if not free_mass:
                least = 1.0
            else:
                # Not so light that the hit would hardly count.
                least = max(LIGHTEST, _felt_mass(body, target, fast) / (target.mass * size**3))
            if least > 1.0 and size < 1.0:
                continue
            least = min(least, 1.0)
            if not missing(body, least, size, flies, limit):
                mass = _largest(
                    lambda m, size=size: not missing(body, m, size, flies, limit), least
                )
                return size, mass
        return None

    # With something to spare at first: engines differ in what a hit just about tips over.
    spare = SPARE * min(knock.limit, HARD_MPS)
    found = chosen(mover, flies, spare, knock.limit) if topples else None
    if found is None or found[0] < HARDLY_SMALLER:
        found = chosen(mover, flies, knock.limit, knock.limit)
    if found is not None:
        return _changed(doc, keys[1], *found)
    if topples and _comes_in_all_sizes(doc, keys[0]):
        for factor in LARGER:
            made = resized(doc, keys[0], doc.asset_configurations[keys[0]], factor)
            limit = knock.limit
            if not story.is_active(knock.mover):
                # Hollow: what is struck itself is the slower the heavier it is.
                made = scaled(made, 1.0 / factor)
            with_larger = with_assets(doc, {keys[0]: made})
            if not story.is_active(knock.mover):
                limit = carried(with_larger, story, knock.mover, knock.node)
            found = chosen(prop(with_larger, knock.mover), flies, limit, limit)
            if found is not None:
                return _changed(with_larger, keys[1], *found)
    if topples and _may_be_thrown(doc, story, knock, mover):
        found = chosen(mover, True, knock.limit, knock.limit)
        if found is not None:
            return _changed(_thrown(doc, knock.mover), keys[1], *found)
    return _changed(doc, keys[1], 1.0, LIGHTEST if free_mass else 1.0)


def _falls_on(story: Story, knock: Knock) -> bool:
    """Whether what is knocked over shall hit something else as it falls."""
    return any(
        n.event is NodeEvent.COLLISION and knock.target in n.participants
        for n in story.after(knock.node.id)
    )


def _not_overrun(doc: EsgDocument, story: Story, knock: Knock) -> EsgDocument:
    """A struck ball no heavier than the slope (a cone) that it knocks over, where masses allow.

    A slow heavier ball presses a slope down and drives it ahead, which sets it upright again. One
    of its mass stays behind.
    """
    mover, target = prop(doc, knock.mover), prop(doc, knock.target)
    nodes = doc.spatial_relation_graph.nodes
    keys = nodes[knock.mover].asset_id, nodes[knock.target].asset_id
    wanted = [doc.asset_requirement[k] for k in keys]
    if not story.topples(knock.target) or story.is_active(knock.mover) or not mover.rolls:
        return doc
    if target.fixed or knock.limit > SLOW_MPS or any(r.mass_is_prescribed for r in wanted):
        return doc
    stand = stand_of(target)
    touch = first_touch(mover, target, stand, flies=False)
    if touch is None or touch.height < stand.height or touch.normal[1] > -SLOPES:
        return doc
    lighter = min(max(target.mass / mover.mass, LIGHTEST), 1.0)
    heavier = min(max(lighter * mover.mass / target.mass, 1.0), LOADED)
    doc = _changed(doc, keys[0], 1.0, lighter)
    return _changed(doc, keys[1], 1.0, heavier)


def _felt_mass(mover: Prop, target: Prop, speed: float) -> float:
    """Least mass [kg] of a target that feels a hit of a speed; infinity where none does."""
    gain = 1.0 + 0.5 * (mover.restitution + target.restitution)
    reduced = SAFE_IMPULSE_NS / max(gain * speed, 1e-9)
    return math.inf if reduced >= mover.mass else reduced * mover.mass / (mover.mass - reduced)


def _largest(holds: Callable[[float], bool], lightest: float) -> float:
    """The largest share of the mass at which a condition holds that a lighter body fulfils."""
    if holds(1.0):
        return 1.0
    low, high = lightest, 1.0
    for _ in range(12):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low


def _comes_in_all_sizes(doc: EsgDocument, key: str) -> bool:
    """Whether a round mover's size is open: a ball, but not a soccer ball."""
    from esg.assets.library.catalogue import entries_by_name

    wanted, config = doc.asset_requirement[key], doc.asset_configurations[key]
    if wanted.dimensions_are_prescribed or wanted.mass_is_prescribed or not config.rolls:
        return False
    entry = entries_by_name().get(config.category)
    return entry is not None and "any_size" in entry.flags and config.source == "parametric"


def _may_be_thrown(doc: EsgDocument, story: Story, knock: Knock, mover: Prop) -> bool:
    """Whether nothing keeps a mover on the ground but the wording's silence."""
    if not mover.rolls or not story.is_active(knock.mover) or story.flies(knock.mover):
        return False
    first = story.phases[knock.mover][0]
    if first.edge.event is not EdgeEvent.TOWARD or first.end.id != knock.node.id:
        return False
    return not ON_THE_GROUND.search(doc.scene_definition.original_description)


def _thrown(doc: EsgDocument, actor: str) -> EsgDocument:
    assert doc.timeline_system is not None
    actors = dict(doc.timeline_system.actors)
    actors[actor] = actors[actor].model_copy(update={"force_direction": ForceDirection.ANY_3D})
    timeline = doc.timeline_system.model_copy(update={"actors": actors})
    return doc.model_copy(update={"timeline_system": timeline})


def _changed(doc: EsgDocument, key: str, size: float, mass: float) -> EsgDocument:
    config = doc.asset_configurations[key]
    if size != 1.0:
        config = resized(doc, key, config, size)
    if mass != 1.0:
        config = scaled(config, mass)
    return with_assets(doc, {} if config is doc.asset_configurations[key] else {key: config})


def scaled(config: AssetConfiguration, factor: float) -> AssetConfiguration:
    """The same thing lighter or heavier."""
    return config.model_copy(
        update={
            "mass_kg": config.mass_kg * factor,
            "inertia_kg_cm2": tuple(v * factor for v in config.inertia_kg_cm2),
        }
    )


def carried(doc: EsgDocument, story: Story, name: str, node: TimelineNode) -> float:
    """Speed [m/s] at which what was set in motion by an earlier hit may arrive at an event."""
    before = story.ancestors(node.id)
    for hit, mover, target in hits(doc, story):
        if hit.id not in before or target != name or mover == name:
            continue
        active = story.is_active(mover)
        came = fastest(story, mover, hit.id) if active else carried(doc, story, mover, hit)
        stated = active and any(
            p.end.id == hit.id and p.edge.speed_is_prescribed for p in story.phases[mover]
        )
        speed = KEPT * passed_on(prop(doc, mover), prop(doc, name)) * came
        return speed if stated else min(speed, USUAL_CARRIED_MPS)
    return USUAL_CARRIED_MPS


def launched(story: Story, actor: str, node_id: str) -> bool:
    """Whether an actor meets an event by what a launch gave it, not under its own power."""
    return any(
        p.end.id == node_id and p.edge.event is EdgeEvent.TOWARD
        for p in story.phases.get(actor, ())
    )


def fastest(story: Story, actor: str, node_id: str) -> float:
    """Speed [m/s] at which an actor may arrive."""
    for phase in story.phases.get(actor, ()):
        if phase.end.id != node_id or phase.edge.params.speed is None:
            continue
        low, high, _ = bounds(phase.edge.params.speed, (0.0, 100.0 * FASTEST_MPS))
        if phase.edge.speed_is_prescribed:
            share = FALLS_TOO if story.flies(actor) else 0.9
            return share * max(low, high) / 100.0
        thrown = phase.edge.event is EdgeEvent.TOWARD
        return 0.6 * FASTEST_MPS if thrown else max(high / 100.0, 8.0)
    return 3.0
