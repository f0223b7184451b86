"""Casting of what shall be knocked over: lighter, smaller, hit by something larger, or thrown at.

A traffic cone of full height is met by a rolling ball at the rim of its base, below its centre of
mass, and cannot be tipped; a cone of half the height can, and so can one that the ball is thrown
at. What the prompt states is never touched, and what rolls is not thrown.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
import math

from esg.dynamics.casting.changes import resized, scaled, thrown, with_assets
from esg.dynamics.casting.hits import carried, fastest, launched
from esg.dynamics.choreography.slopes import fastest_down, rides
from esg.dynamics.story.stagecraft import Prop, fall_speed, prop
from esg.dynamics.story.story import Story, hits
from esg.dynamics.story.tipping import Stand, first_touch, stand_of, topple_speed
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, TimelineNode
from esg.thresholds import SAFE_IMPULSE_NS

LIGHTEST = 0.3
"""Least share of the usual mass: an empty crate against a loaded one."""
SIZES = (1.0, 0.9, 0.8, 0.7, 0.6, 0.5)
"""Shares of the usual size that such a thing may have."""
SMALL = (*SIZES, 0.4, 0.35, 0.3)
"""The same of what one can carry in a hand: a training cone of 21 cm against one of 71 cm."""
HANDY_KG = 5.0
"""Up to this mass something comes in small."""
SPARE, HARDLY_SMALLER = 0.7, 0.7
"""Share of the highest speed that is to suffice, and the least size that is given for it."""
HARD_MPS = 12.0
"""Speed from which on a hit is a hard one."""
LOW_KICK = 0.25
"""Height of a touch, over that of the centre of mass, below which it kicks the foot away."""
SLOW_MPS, SLOPES, LOADED = 4.0, 0.1, 2.5
"""Highest speed of a slow hit, how far down it points at least on a slope, and the largest share
of its mass that what is hit so is given."""
LARGER = (1.25, 1.5, 2.0)
"""Factors on the size of a mover that comes in all sizes."""


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


@dataclass(frozen=True)
class _Target:
    """What shall be knocked over, and what the prompt leaves open of it.

    Args:
        body, stand: Its planar view and how it stands.
        topples: Whether it tips over; else it only falls off what it stands on.
        pushed: As of `Knock`.
        free_mass: Whether its mass is open.
        sizes: Shares of its size that it may have, the usual one first.
    """

    body: Prop
    stand: Stand
    topples: bool
    pushed: bool
    free_mass: bool
    sizes: tuple[float, ...]


def _target(doc: EsgDocument, story: Story, knock: Knock) -> _Target:
    node = doc.spatial_relation_graph.nodes[knock.target]
    wanted, body = doc.asset_requirement[node.asset_id], prop(doc, knock.target)
    topples, free_mass = story.topples(knock.target), not wanted.mass_is_prescribed
    sizes = (1.0,)
    if topples and free_mass and not (wanted.dimensions_are_prescribed or node.size_is_stated):
        sizes = SMALL if body.mass <= HANDY_KG else SIZES
    return _Target(body, stand_of(body), topples, knock.pushed, free_mass, sizes)


def _fitted(doc: EsgDocument, story: Story, knock: Knock) -> EsgDocument:
    """The document with the least change at which a hit tips its target over."""
    nodes = doc.spatial_relation_graph.nodes
    key = nodes[knock.target].asset_id
    mover, target = prop(doc, knock.mover), _target(doc, story, knock)
    flies = story.is_active(knock.mover) and story.flies(knock.mover)
    throwable = target.topples and _may_be_thrown(doc, story, knock, mover)
    if throwable and _falls_on(story, knock):
        touch = first_touch(mover, target.body, target.stand, flies=False)
        if touch is not None and touch.height < LOW_KICK * target.stand.height:
            # Kicked at its foot it would fall back onto what hit it.
            doc, flies = thrown(doc, knock.mover), True
    # With something to spare at first: engines differ in what a hit just about tips over.
    spare = SPARE * min(knock.limit, HARD_MPS)
    found = _chosen(target, mover, flies, spare, knock.limit) if target.topples else None
    if found is None or found[0] < HARDLY_SMALLER:
        found = _chosen(target, mover, flies, knock.limit, knock.limit)
    if found is not None:
        return _changed(doc, key, *found)
    larger = _by_larger(doc, story, knock, target, flies) if target.topples else None
    if larger is not None:
        return larger
    found = _chosen(target, mover, True, knock.limit, knock.limit) if throwable else None
    if found is not None:
        return _changed(thrown(doc, knock.mover), key, *found)
    return _changed(doc, key, 1.0, LIGHTEST if target.free_mass else 1.0)


def _chosen(
    target: _Target, mover: Prop, flies: bool, limit: float, fast: float
) -> tuple[float, float] | None:
    """Size and mass of a target, over the usual ones, at which a hit suffices; None if none do.

    Args:
        target: What shall be knocked over.
        mover: What hits it.
        flies: Whether that is thrown.
        limit: Highest speed [m/s] of the hit.
        fast: Highest speed [m/s] at which the mover arrives anyhow.
    """
    for size in target.sizes:
        least = 1.0
        if target.free_mass:
            # Not so light that the hit would hardly count.
            felt = _felt_mass(mover, target.body, fast) / (target.body.mass * size**3)
            least = max(LIGHTEST, felt)
        if least > 1.0 and size < 1.0:
            continue
        suffices = partial(_suffices, target, mover, flies, limit, size)
        least = min(least, 1.0)
        if suffices(least):
            return size, _largest(suffices, least)
    return None


def _suffices(
    target: _Target, mover: Prop, flies: bool, limit: float, size: float, mass: float
) -> bool:
    """Whether a hit of at most `limit` knocks a target over that has shares of size and mass."""
    body = replace(target.body, mass=target.body.mass * mass * size**3)
    at = target.stand.scaled(size)
    speed = topple_speed(mover, body, flies=flies, stand=at) if target.topples else 0.0
    if target.pushed:
        speed = max(speed, fall_speed(mover, body))
    return not speed > limit


def _by_larger(
    doc: EsgDocument, story: Story, knock: Knock, target: _Target, flies: bool
) -> EsgDocument | None:
    """The document with a larger mover, if that comes in all sizes and one suffices."""
    nodes = doc.spatial_relation_graph.nodes
    key, active = nodes[knock.mover].asset_id, story.is_active(knock.mover)
    if not comes_in_all_sizes(doc, key):
        return None
    for factor in LARGER:
        made = resized(doc, key, doc.asset_configurations[key], factor)
        if not active:
            # Hollow: what is struck itself is the slower the heavier it is.
            made = scaled(made, 1.0 / factor)
        with_larger = with_assets(doc, {key: made})
        limit = knock.limit if active else carried(with_larger, story, knock.mover, knock.node)
        found = _chosen(target, prop(with_larger, knock.mover), flies, limit, limit)
        if found is not None:
            return _changed(with_larger, nodes[knock.target].asset_id, *found)
    return None


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


def comes_in_all_sizes(doc: EsgDocument, key: str) -> bool:
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
    wording = doc.scene_definition.wording
    return wording is None or not wording.keeps_to_ground


def _changed(doc: EsgDocument, key: str, size: float, mass: float) -> EsgDocument:
    config = doc.asset_configurations[key]
    if size != 1.0:
        config = resized(doc, key, config, size)
    if mass != 1.0:
        config = scaled(config, mass)
    return with_assets(doc, {} if config is doc.asset_configurations[key] else {key: config})
