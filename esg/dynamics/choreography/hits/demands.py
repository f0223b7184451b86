"""How hard a first hit must be for what it leads to: a ball that sends a ball into a vase."""

from __future__ import annotations

import math

from esg.dynamics.choreography.hits.rows import asked_of_first, row_after
from esg.dynamics.choreography.placing import hits_on
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import off_a_wall
from esg.dynamics.story.stagecraft import (
    Prop,
    coasting_drag,
    fall_speed,
    passed_on,
    support_of,
    thrown_back,
)
from esg.dynamics.story.story import bounds
from esg.dynamics.story.tipping import topple_speed
from esg.graph.models import NodeEvent, TimelineNode
from esg.thresholds import SAFE_IMPULSE_NS
from esg.units import GRAVITY_MPS2

KEPT = 0.77
"""Share of its speed that something struck has when it meets the next thing."""
FELT_MPS = 2.5
"""Highest speed that is asked for alone so that a hit surely counts."""
FELT_SPARE = 1.2
"""Over the speed of such a hit: a light thing loses some on its way there."""
FELT_SURELY = 2.0
"""At so much less than that speed a hit still counts (`SAFE_IMPULSE_NS`, `MIN_IMPULSE_NS`): what is
said to creep is not made to run for it."""
RUN_ON_M, RUN_ON_S = 0.2, 0.28
"""Way on which something struck surely gets to what stands ahead of it, and time it slides at
least: two hits closer than a tenth of a second are one."""
SLIPS_M, THROWN_OFF = 0.1, 1.4
"""What lies on something that is stopped slides so far beyond its middle, and at so many times the
speed that takes it there."""
BACK_KEPT, LEAST_BACK = 0.9, 0.2
"""The same of what bounced off something, and the least share that counts as coming back."""


def felt(mover: Prop, target: Prop) -> float:
    """Impulse of a hit of two free bodies over its speed [kg]."""
    return passed_on(mover, target) * target.mass


def felt_speed(mover: Prop, target: Prop) -> float:
    """Speed [m/s] with which something light sets out so that its hit surely counts: a marble."""
    whole = thrown_back(mover, target) * mover.mass
    return FELT_SPARE * SAFE_IMPULSE_NS / max(whole if target.fixed else felt(mover, target), 1e-9)


def run_on_speed(body: Prop) -> float:
    """Least speed [m/s] after a hit of what shall get to the next thing; 0 for what rolls."""
    if body.rolls:
        return 0.0
    drag = coasting_drag(body)
    return max(math.sqrt(2.0 * drag * RUN_ON_M), RUN_ON_S * drag)


def demanded(stage: Stage, node: TimelineNode, a: str, b: str) -> float:
    """Least speed [m/s] of a at its hit of b for what is to fall or topple later by that hit.

    Args:
        stage: The stage.
        node: The hit.
        a: Who arrives.
        b: What it hits.
    """
    pa, pb = stage.prop(a), stage.prop(b)
    if node.event is not NodeEvent.COLLISION:
        return 0.0
    if pb.fixed:
        rolling = pa.rolls and not stage.story.flies(a)
        restitution = 0.5 * (pa.restitution + pb.restitution)
        back, _ = off_a_wall(restitution, 0.5 * (pa.friction + pb.friction), rolling=rolling)
        return _after(stage, node, a, BACK_KEPT) / max(back, LEAST_BACK)
    if b in stage.tracks:
        return 0.0
    row = row_after(stage, a, b)
    if row:
        return asked_of_first([stage.prop(k) for k in row], _falling(stage, *row[-2:]))
    return _after(stage, node, b, KEPT) / passed_on(pa, pb)


def thrown_off_speed(stage: Stage, node: TimelineNode, a: str) -> float:
    """Least speed [m/s] of a at a hit that stops it for what lies on it to slide off, by mu g s."""
    needed = 0.0
    for later in stage.story.after(node.id):
        for load in later.participants if later.event is NodeEvent.FALL else ():
            if support_of(stage.doc, load) != stage.member(a) or load in stage.tracks:
                continue
            body, host = stage.prop(load), stage.prop(a)
            friction = 0.5 * (body.friction + host.friction)
            way = host.half_length + SLIPS_M
            needed = max(needed, THROWN_OFF * math.sqrt(2.0 * friction * GRAVITY_MPS2 * way))
    return needed


def _felt(mover: Prop, target: Prop) -> float:
    """Speed [m/s] at which a hit in the middle of a chain surely counts; balls lie closer."""
    if mover.rolls and target.rolls:
        return 0.0
    return min(SAFE_IMPULSE_NS / felt(mover, target), FELT_MPS)


def _after(stage: Stage, node: TimelineNode, b: str, kept: float) -> float:
    """Least speed [m/s] of b right after an event, for the next thing that it hits."""
    if stage.story.topples(stage.member(b)):
        return 0.0
    for later in stage.story.after(node.id):
        keys = [stage.key(p) for p in later.participants]
        others = [k for k in keys if k != b]
        if later.event is not NodeEvent.COLLISION or b not in keys or not others:
            continue
        c = others[0]
        body, target = stage.prop(b), stage.prop(c)
        if c in stage.tracks:
            return 0.0
        runs = 0.0 if b in stage.tracks else run_on_speed(body)
        if target.fixed:
            return runs
        needed = max(demanded(stage, later, b, c), _felt(body, target), _falling(stage, b, c))
        return max(needed / kept, runs)
    return 0.0


def _falling(stage: Stage, b: str, c: str) -> float:
    """Least speed [m/s] at which b, which was struck, knocks c over or off, where it shall."""
    body, target, name = stage.prop(b), stage.prop(c), stage.member(c)
    needed = topple_speed(body, target, flies=False) if stage.story.topples(name) else 0.0
    return max(needed, fall_speed(body, target)) if stage.story.falls(name) else needed


def sends_sliding(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether something without wheels that is hit here shall slide into what goes on, too."""
    body = stage.prop(b)
    if body.rolls or body.wheeled or body.fixed:
        return False
    if stage.story.topples(stage.member(b)) or stage.story.falls(stage.member(b)):
        return False
    for later in stage.story.after(node.id):
        keys = list(map(stage.key, later.participants))
        others = [k for k in keys if k != b]
        if later.event is NodeEvent.COLLISION and b in keys and others:
            return others[0] not in stage.tracks and hits_on(stage, later, others[0])
    return False


def timed_push(stage: Stage, node: TimelineNode, mover: Prop, b: str) -> float:
    """Speed [m/s] of a hit after which b is still on its way when it is to meet the next one.

    0 where the prompt gives no time for that. It is to keep a third of its speed until then.
    """
    target = stage.prop(b)
    if target.rolls or target.fixed:
        return 0.0
    for later in stage.story.after(node.id):
        keys = [stage.key(p) for p in later.participants]
        if later.event is not NodeEvent.COLLISION or b not in keys:
            continue
        if any(k in stage.tracks for k in keys):
            continue
        since = [c for c in later.constraints if c.quantity == "time_since" and c.since == node.id]
        waits = [c.value for c in since]
        now = stage.prescribed_time(node)
        if not waits and now is not None and later.time_is_prescribed and later.timestamp:
            waits = [later.timestamp - now]
        if waits:
            low, high, _ = bounds(waits[0], (0.0, 0.0))
            needed = 1.5 * coasting_drag(target) * 0.5 * (low + high)
            gain = thrown_back(mover, target) * mover.mass
            return max(0.0, needed * (mover.mass + target.mass) / gain)
        break
    return 0.0
