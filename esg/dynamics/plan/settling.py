"""What rolls and shall come to rest: an engine's ball has no rolling resistance of its own."""

from __future__ import annotations

from collections.abc import Sequence
import math

from esg.dynamics.plan.cast import Cast
from esg.dynamics.story.paces import grip
from esg.dynamics.story.stagecraft import ON_TABLE, TABLE_S, lies_on, stays_on
from esg.dynamics.story.story import Phase
from esg.engines.program import AdjustProperties, Lasting, Primitive
from esg.engines.scene import Body
from esg.graph.models import EdgeEvent, NodeEvent, Predicate
from esg.units import GRAVITY_MPS2

STILL_MPS = 0.07
"""Speed of what has come to rest [m/s]."""
AT_REST_DAMPING = 9.0
"""Linear and angular damping [1/s] of a ball that has rolled out."""
ROLLING_OUT = 1.0
"""Damping [1/s] of what shall come to lie somewhere: at 0.5 m/s a twentieth of g, as of an apple on
a floor, or a ball on short grass."""
LANDED_S = 0.5
"""It sets in so long after the last event, and after a fall from where it starts."""
CAUGHT, CAUGHT_S = 8.0, 0.05
"""Damping [1/s] of what shall lie on the thing that it lands on, as of a fruit on a sack, and when
it sets in after the touch: at 1 m/s it rolls 12 cm."""
_LIES = frozenset({Predicate.ENDS_ON, Predicate.ENDS_IN, Predicate.ENDS_NEAR, Predicate.AT_REST})


def rolls_out(
    cast: Cast, body: Body, phase: Phase, speed: float, start: float, end: float
) -> list[Primitive]:
    """What rolls and stops is slowed as grass or a carpet does it, its spin in step.

    Args:
        cast: Who takes part.
        body: What rolls.
        phase: Its last one.
        speed: With which that begins [m/s].
        start, end: Of the phase [s].
    """
    actor = body.name
    stops = phase.end.event is NodeEvent.STOP and phase.edge.params.spin == "roll"
    if f"{phase.edge.id}/most" in cast.nominal:
        return []  # as `comes_to_lie` has it
    if not stops or body.roll_radius <= 0.0 or cast.story.flies(actor) or end <= start:
        return []
    needed = math.log(max(speed, STILL_MPS) / STILL_MPS) / (end - start)
    # Damping takes the most at the start: no more than what friction on its ground gives.
    holds = grip(cast.doc, actor)
    damping = max(min(needed, holds / max(speed, STILL_MPS)), 0.1)
    slow = holds / AT_REST_DAMPING
    end = max(end, start + math.log(max(speed / slow, 1.0)) / damping)
    return [_damped(actor, start, damping), _damped(actor, end, AT_REST_DAMPING)]


def comes_to_lie(cast: Cast, body: Body, done: Sequence[Primitive]) -> list[Primitive]:
    """What the prompt has at rest somewhere in the end stops rolling there.

    Args:
        cast: Who takes part.
        body: Whose program it is.
        done: The primitives so far.
    """
    most = f"{cast.story.phases[body.name][-1].edge.id}/most"
    kept = _kept_on_top(cast, body.name)
    told = (
        most in cast.nominal
        or kept
        or _stops_by_itself(cast, body.name)
        or any(
            s.predicate in _LIES and s.when == "end" and body.name in s.object
            for s in cast.doc.statements or ()
        )
    )
    caught = any(lies_on(cast.doc, body.name, host) for host in cast.scene.names)
    if not told or (body.roll_radius <= 0.0 and not caught) or cast.story.soars(body.name):
        return []
    if any(isinstance(p, Lasting | AdjustProperties) for p in done):
        return []  # it is held, or rolls out as it is
    times = [
        cast.nominal.get(f"{node.id}/event_time", 0.0)
        for node in cast.story.nodes.values()
        if body.name in node.participants and node.event is not NodeEvent.STOP
    ]
    if most in cast.nominal:
        return [_damped(body.name, TABLE_S, ON_TABLE)]
    if kept:
        hits = cast.story.phases[body.name][-1].end.event is NodeEvent.COLLISION
        begins = max(times, default=0.0) + (CAUGHT_S if hits else TABLE_S)
        return [_damped(body.name, begins, CAUGHT if hits else ON_TABLE)]
    if caught:
        return [_damped(body.name, max(times, default=0.0) + CAUGHT_S, CAUGHT)]
    high = max(body.position[2] - body.half_extents[2], 0.0)
    begins = max(times, default=0.0) + math.sqrt(2.0 * high / GRAVITY_MPS2) + LANDED_S
    return [_damped(body.name, begins, ROLLING_OUT)]


def _kept_on_top(cast: Cast, actor: str) -> bool:
    """Whether it rolls on after what is told of it, on a table that it does not leave."""
    last = cast.story.phases[actor][-1]
    ended = last.end.event in (NodeEvent.MISS, NodeEvent.COLLISION, NodeEvent.REACH)
    rolls = last.edge.event is EdgeEvent.TOWARD and not cast.story.flies(actor)
    return ended and rolls and stays_on(cast.doc, actor) is not None


def _stops_by_itself(cast: Cast, actor: str) -> bool:
    """Whether it rolls on after an event, or out of the air, until it stops, whenever that is."""
    last = cast.story.phases[actor][-1]
    end = last.end
    open_ = not (end.time_is_prescribed or end.constraints)
    return end.event is NodeEvent.STOP and last.edge.event is EdgeEvent.TOWARD and open_


def _damped(actor: str, time: float, damping: float) -> AdjustProperties:
    return AdjustProperties(actor, time, linear_damping=damping, angular_damping=damping)
