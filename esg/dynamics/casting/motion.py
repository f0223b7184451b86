"""Casting for motion on the ground: what has to slide, stand on a ramp, topple or be felt.

Complements `casting`: only what the prompt leaves open of sizes, masses and surfaces is chosen.
"""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np

from esg.dynamics.casting.changes import Configs, resized, weighing
from esg.dynamics.casting.fragile import SURELY_BREAKS
from esg.dynamics.choreography.slopes import (
    AT_FOOT_M,
    STARTS_MPS,
    Ride,
    Slope,
    arrival_speed,
    come_down,
    ride_of,
    rides,
    runs_down,
    slows_enough,
)
from esg.dynamics.story.stagecraft import (
    Prop,
    coasting_drag,
    default_speed,
    ground_friction,
    prop,
    support_of,
    thrown_back,
    top_surface,
)
from esg.dynamics.story.story import Phase, Story, bounds, hits
from esg.dynamics.story.tipping import stand_of
from esg.graph.models import AssetConfiguration, EdgeEvent, EsgDocument, NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

LIGHTEST, HEAVIEST = 0.3, 1.5
"""Shares of the usual mass of what is pushed on and of what pushes it."""
SMOOTH = 0.15
"""Friction of a smooth underside; `SLICK` is that of a body on ice."""
SLICK = 0.02
GRIPPY = 1.0
"""Friction of rubber feet."""
NOT_YET = 0.7
"""Share of what something bears with which it surely does not break."""
SLIDE_S = 0.14
"""How long what was pushed on has to slide before it meets the next thing."""
KEEPS, PASSES_ON = 0.7, 0.9
"""Share of its speed with which something slid arrives in time, and if it is to pass some on."""
LIVELIEST = 0.95
"""Restitution of glass or polished stone."""
FELT_NS = 0.2
"""Impulse of a hit that surely counts (over 0.1 N s)."""
LARGEST, LARGER = 4.0, 2.5
"""Most that a ramp and that a small body is enlarged."""
TRIPS_AT = 1.25
"""Friction over which a sliding body falls over its far edge, over that edge's way from its centre
of mass per height of that: what a leaf or a drawer has sent off."""
BOTTOM_HEAVY = 0.35
"""Share of its height below which a body's centre of mass is low."""
LOW_HIT = 0.62
"""A hit below this share of the height tips only what does not slip."""

LETS_GO = 0.25
"""Friction of what slides down a ramp and of the ramp, over its fall per way."""
ROLLING = 0.02
"""Friction of a ramp that something with wheels rolls down."""
SMALLEST = 0.4
"""Least size of a ramp, over its usual one."""
LONGEST_ON_RAMP = 0.4
"""Longest half of a body over the way down a ramp."""


def _asset(doc: EsgDocument, name: str) -> str:
    return doc.spatial_relation_graph.nodes[name].asset_id


def _open(doc: EsgDocument, name: str, *, size: bool = False) -> bool:
    """Whether the prompt leaves the mass (and with `size` the dimensions) of a node open."""
    requirement = doc.asset_requirement.get(_asset(doc, name))
    if requirement is None or requirement.mass_is_prescribed:
        return False
    return not (size and requirement.dimensions_are_prescribed)


def _scaled(doc: EsgDocument, name: str, factor: float) -> AssetConfiguration:
    """The same thing, larger or smaller in all directions."""
    key = _asset(doc, name)
    return resized(doc, key, doc.asset_configurations[key], factor)


def _arrival(story: Story, actor: str, node: TimelineNode) -> Phase | None:
    return next((p for p in story.phases.get(actor, ()) if p.end.id == node.id), None)


def fit_roomy(doc: EsgDocument, story: Story) -> Configs:
    """A ramp on whose top there is room for what goes down it."""
    out: Configs = {}
    for actor in story.phases:
        support = support_of(doc, actor)
        body = prop(doc, actor)
        if support is None or body.rolls or story.flies(actor):
            continue
        if not _open(doc, support, size=True):
            continue
        config = doc.asset_configurations[_asset(doc, support)]
        room = 0.02 * top_surface(doc, support).half_extents_cm[0]
        sloped = any(p.kind.value == "convex" for p in config.proxies)
        factor = body.length / max(room, 1e-3)
        if sloped and 1.0 < factor <= LARGEST:
            out[_asset(doc, support)] = _scaled(doc, support, factor)
    return out


def fit_sloped(doc: EsgDocument, story: Story) -> Configs:
    """A ramp that lets go what is on it, as high as a stated speed at its foot asks for.

    What slides down has half of the slope's pull left by friction; wheels roll.
    """
    out: Configs = {}
    for actor, ramp, slope in runs_down(doc, story):
        _slick_enough(doc, actor, ramp, slope, out)
    for node, actor, ramp, slope in rides(doc, story):
        body = prop(doc, actor)
        keys = _asset(doc, actor), _asset(doc, ramp)
        configs = {k: out.get(k, doc.asset_configurations[k]) for k in keys}
        configs |= _slick_enough(doc, actor, ramp, slope, out)
        friction = 0.5 * sum(configs[k].friction for k in keys)
        ride = replace(ride_of(body, prop(doc, ramp)), on_slope=0.0 if body.rolls else friction)
        if not (body.rolls or body.wheeled) and node.time_is_prescribed and node.timestamp:
            start = slope.crest - 0.6 * body.half_length - 0.05
            allowed = slows_enough(slope, ride, start, node.timestamp)
            rest = None if allowed is None else 2.0 * allowed - configs[keys[0]].friction
            for key in _grounds(doc) if rest is not None else ():
                if max(SLICK, rest or 0.0) < doc.asset_configurations[key].friction:
                    out[key] = doc.asset_configurations[key].model_copy(
                        update={"friction": max(SLICK, rest or 0.0)}
                    )
        meant = arrival_speed(node, actor) or _breaks_at(doc, story, node, actor, slope)
        if meant is None or not _open(doc, ramp, size=True):
            continue
        factor = _size_for(slope, ride, body, meant)
        if abs(factor - 1.0) > 0.05:
            made = resized(doc, keys[1], doc.asset_configurations[keys[1]], factor)
            out[keys[1]] = made.model_copy(update={"friction": configs[keys[1]].friction})
    return out


def _slick_enough(doc: EsgDocument, actor: str, ramp: str, slope: Slope, out: Configs) -> Configs:
    """Gives a ramp and what does not roll down it the friction with which it lets that go.

    Args:
        doc: With assets resolved.
        actor, ramp: What goes down what.
        slope: Of the ramp.
        out: What is chosen so far; what is chosen here is put there, too.
    """
    body, chosen = prop(doc, actor), Configs()
    if body.rolls:
        return chosen
    keys = _asset(doc, actor), _asset(doc, ramp)
    allowed = ROLLING if body.wheeled else LETS_GO * slope.steepness
    for key in keys if not body.wheeled else keys[1:]:
        config = out.get(key, doc.asset_configurations[key])
        if config.friction > allowed:
            chosen[key] = config.model_copy(update={"friction": allowed})
    out.update(chosen)
    return chosen


def _breaks_at(
    doc: EsgDocument, story: Story, node: TimelineNode, actor: str, slope: Slope
) -> float | None:
    """Speed [m/s] at which a wall breaks what the slope's foot does not; None for what stays whole.

    At the foot the ground stops v sin a of it, at the wall all of v; both throw it back.
    """
    breaking = doc.spatial_relation_graph.nodes[actor].breaking
    walls = [p for p in node.participants if p != actor]
    breaks = story.breaks_after(node.id, actor)
    if breaking is None or not walls or not breaks or node.event is not NodeEvent.COLLISION:
        return None
    gain = thrown_back(prop(doc, actor), prop(doc, walls[0]))
    least = SURELY_BREAKS * breaking.speed / 100.0 / gain
    most = NOT_YET * breaking.speed / 100.0 / gain / math.sin(math.atan(slope.steepness))
    return min(1.15 * least, math.sqrt(least * most))


def _size_for(slope: Slope, ride: Ride, body: Prop, meant: float) -> float:
    """Size of a ramp, over its own, from which something arrives with a speed [m/s]."""
    room = slope.crest - 0.6 * body.half_length - 0.05
    best, found = math.inf, 1.0
    for factor in np.geomspace(SMALLEST, LARGEST, 25):
        ramp = slope.scaled(float(factor))
        start = ramp.crest - (slope.crest - room)
        came = come_down(ramp, ride, start, STARTS_MPS)
        left = came.at(ramp.foot + body.half_length + AT_FOOT_M)[1]
        fits = body.length < 2.0 * LONGEST_ON_RAMP * factor * (slope.foot - slope.crest)
        cost = abs(left - meant) + 0.1 * abs(math.log(factor)) + (0.0 if fits else 10.0)
        if cost < best:
            best, found = cost, float(factor)
    return found


def fit_felt(doc: EsgDocument, story: Story) -> Configs:
    """Marbles and dominoes so large that their hits are hits at a speed they may have.

    The lighter one of the two grows, both where they are alike.
    """
    out: Configs = {}
    for node, a, b in hits(doc, story):
        phase = _arrival(story, a, node)
        pa, pb = prop(doc, a), prop(doc, b)
        if phase is None or not pa.rolls or any(_enters(story, n) for n in (a, b)):
            continue
        target = not pb.fixed and pb.mass < 0.7 * pa.mass
        alike = not pb.fixed and not target and pb.rolls and pb.mass < 1.5 * pa.mass
        usual = target or node.time_is_prescribed
        speed = _asked_speed(phase) or (1.0 if usual else 2.0) * default_speed(pa)
        support = support_of(doc, a)
        if support is not None and node.time_is_prescribed and node.timestamp:
            room = max(top_surface(doc, support).half_extents_cm) / 100.0
            speed = min(speed, max(room / node.timestamp, 0.2 * speed))
        if story.is_active(b):
            speed *= 2.0
        mass = 1.0 / (1.0 / pa.mass + (0.0 if pb.fixed else 1.0 / pb.mass))
        gain = 1.0 + 0.5 * (pa.restitution + pb.restitution)
        factor = min((FELT_NS / max(mass * gain * speed, 1e-9)) ** (1.0 / 3.0), LARGER)
        for name in (b,) if target else (a, b) if alike else (a,):
            if factor > 1.0 and _open(doc, name, size=True):
                out[_asset(doc, name)] = _scaled(doc, name, factor)
    return out


def _enters(story: Story, name: str) -> bool:
    """Whether an opening sets the size of something."""
    nodes = story.nodes.values()
    return any(n.event is NodeEvent.ENTER_REGION and name in n.participants for n in nodes)


def fit_slippery(doc: EsgDocument, story: Story) -> Configs:
    """Body and ground on which something slid at a prescribed speed is still on its way in time."""
    out: Configs = {}
    for node, a, _ in hits(doc, story):
        phase, body = _arrival(story, a, node), prop(doc, a)
        if phase is None or phase.edge.event is not EdgeEvent.TOWARD or story.flies(a):
            continue
        if body.rolls or body.wheeled or support_of(doc, a) is not None:
            continue
        speed, time = _asked_speed(phase), node.timestamp
        if speed is None or time is None or not node.time_is_prescribed:
            continue
        passes_on = any(c.quantity == "speed_after" for c in node.constraints)
        keeps = PASSES_ON if passes_on else KEEPS
        allowed = (1.0 - keeps) * speed / (time * GRAVITY_MPS2)
        ground = ground_friction(doc)
        if 0.5 * (body.friction + ground) <= allowed:
            continue
        friction = max(SLICK, min(body.friction, 2.0 * allowed - ground))
        config = doc.asset_configurations[_asset(doc, a)]
        out[_asset(doc, a)] = config.model_copy(update={"friction": friction})
        rest = max(SLICK, 2.0 * allowed - friction)
        if rest < ground:
            for key in _grounds(doc):
                config = doc.asset_configurations[key]
                out[key] = config.model_copy(update={"friction": rest})
    return out


def _grounds(doc: EsgDocument) -> list[str]:
    nodes = doc.spatial_relation_graph.nodes.values()
    keys = (n.asset_id for n in nodes if n.is_structural)
    return [k for k in dict.fromkeys(keys) if not doc.asset_configurations[k].proxies]


def _asked_speed(phase: Phase) -> float | None:
    """The prescribed speed [m/s] of a phase, None where it is open."""
    if not phase.edge.speed_is_prescribed or phase.edge.params.speed is None:
        return None
    low, high, _ = bounds(phase.edge.params.speed, (0.0, 0.0))
    return 0.005 * (low + high)


def fit_bouncy(doc: EsgDocument, story: Story) -> Configs:
    """Equals of such a material that a hit at one prescribed speed gives the other one.

    Where masses are open they are chosen instead (`casting`).
    """
    out: Configs = {}
    for node, a, b in hits(doc, story):
        phase = _arrival(story, a, node)
        speed = _asked_speed(phase) if phase else None
        asked = [c.value for c in node.constraints if (c.quantity, c.object) == ("speed_after", b)]
        if speed is None or not asked or story.is_active(b):
            continue
        free = _asset(doc, a) != _asset(doc, b) and (_open(doc, a) or _open(doc, b))
        mover, target = prop(doc, a), prop(doc, b)
        if free or target.fixed:
            continue
        low, high, _ = bounds(asked[0], (0.0, 0.0))
        arrives = speed * (PASSES_ON if phase and phase.edge.event is EdgeEvent.TOWARD else 1.0)
        gain = 0.005 * (low + high) / arrives * (mover.mass + target.mass) / mover.mass
        restitution = min(max(gain - 1.0, 0.0), LIVELIEST)
        if abs(restitution - 0.5 * (mover.restitution + target.restitution)) < 0.05:
            continue
        for name in (a, b):
            config = doc.asset_configurations[_asset(doc, name)]
            out[_asset(doc, name)] = config.model_copy(update={"restitution": restitution})
    return out


def fit_pushed_on(doc: EsgDocument, story: Story) -> Configs:
    """What a hit of prescribed speed is to send into something else is light and smooth enough."""
    out: Configs = {}
    for node, a, b in hits(doc, story):
        phase = _arrival(story, a, node)
        speed = _asked_speed(phase) if phase else None
        mover, target = prop(doc, a), prop(doc, b)
        goes_on = any(
            n.event is NodeEvent.COLLISION and b in n.participants for n in story.after(node.id)
        )
        if speed is None or not goes_on or target.rolls or target.fixed or story.is_active(b):
            continue
        if a == b or _asset(doc, a) == _asset(doc, b) or support_of(doc, b) is not None:
            continue
        key, config = _asset(doc, b), doc.asset_configurations[_asset(doc, b)]
        if mover.rolls or story.flies(a):
            speed *= 0.9
        needed = _sliding_speed(coasting_drag(target))
        if _passed(mover, target, mover.mass, target.mass, speed) >= needed:
            continue
        mass, friction, weight = target.mass, config.friction, mover.mass
        if _open(doc, b):
            gain = (1.0 + 0.5 * (mover.restitution + target.restitution)) * speed / needed
            mass = max(LIGHTEST * mass, min(mass, (gain - 1.0) * mover.mass))
        if _passed(mover, target, weight, mass, speed) < needed and not target.wheeled:
            friction = min(friction, SMOOTH)
            needed = _sliding_speed(0.5 * (friction + target.rough) * GRAVITY_MPS2)
        if _passed(mover, target, weight, mass, speed) < needed and _open(doc, a):
            gain = (1.0 + 0.5 * (mover.restitution + target.restitution)) * speed / needed
            if gain > 1.0:
                weight = min(HEAVIEST * weight, max(weight, mass / (gain - 1.0)))
        out[key] = weighing(config, mass).model_copy(update={"friction": friction})
        if weight > mover.mass:
            out[_asset(doc, a)] = weighing(doc.asset_configurations[_asset(doc, a)], weight)
    return out


def _sliding_speed(drag: float) -> float:
    """Speed [m/s] at which something slides for `SLIDE_S` and still has a third of it left."""
    return 1.5 * drag * SLIDE_S


def _passed(mover: Prop, target: Prop, a: float, b: float, speed: float) -> float:
    """Speed [m/s] of a target of mass b after a hit by a mover of mass a."""
    return (1.0 + 0.5 * (mover.restitution + target.restitution)) * a / (a + b) * speed


def fit_steady(doc: EsgDocument, story: Story) -> Configs:
    """Feet that do not slip under what a low or flat hit shall tip over.

    A flat front presses a body along its whole height, in the middle of which no hit tips it: its
    base has to be held back. With friction mu it tips while it slides if mu h / 2 exceeds half
    of its base.
    """
    out: Configs = {}
    for node, a, b in hits(doc, story):
        target, mover = prop(doc, b), prop(doc, a)
        if not story.topples(b) or story.is_active(b) or target.rolls or target.fixed:
            continue
        if (story.is_active(a) and story.flies(a)) or support_of(doc, b) is not None:
            continue
        if any(n.event is NodeEvent.COLLISION for n in story.after(node.id) if b in n.participants):
            continue
        touched = min(mover.height, target.height if not mover.rolls else mover.height)
        if 0.5 * touched > LOW_HIT * target.height or target.wheeled:
            continue
        base, height = min(target.length, target.width), target.height
        needed = 1.2 * base / max(height, 1e-3)
        stand = stand_of(target)
        if mover.lift > 0.0:
            needed = max(needed, TRIPS_AT * stand.far / stand.height)
        if stand.height < BOTTOM_HEAVY * height and stand.far > GRIPPY * stand.height:
            # Nothing trips a traffic cone, and grip would press it down under what rolls into it.
            continue
        friction = min(2.0 * needed - ground_friction(doc), GRIPPY)
        config = doc.asset_configurations[_asset(doc, b)]
        if friction > config.friction:
            out[_asset(doc, b)] = config.model_copy(update={"friction": friction})
    return out
