"""What starts from rest speeds up: how an actor comes to the speed of a segment.

What is under way when the scene begins has its speed from the start. What waits until something
happens, or moves again after it has stopped or hit something, gains speed at a rate of its kind.
What goes on more slowly, or waits, after nothing but a time or a turn brakes as its kind does.
What is thrown, kicked or rolled by a hand has its speed from that hand.
"""

from __future__ import annotations

from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import Ride
from esg.dynamics.story.paces import pace
from esg.dynamics.story.stagecraft import support_of
from esg.dynamics.story.story import CRUISES, UNDISTURBED, Phase, bounds
from esg.graph.models import NodeEvent

SAME_MPS = 0.25
"""Speeds that differ by less are the same."""


def ride_of(stage: Stage, actor: str, phase: Phase, speed: float) -> Ride:
    """How an actor moves in a segment; the plan is told of what it gains (`gains`).

    Args:
        stage: What is told so far; the actor is where the segment begins.
        actor: Who moves.
        phase: The segment.
        speed: That it gets to [m/s].
    """
    begins = _begins(stage, actor, phase)
    name = phase.edge.id
    usual = pace(stage.doc, stage.member(actor))
    slows = begins is not None and begins > speed + SAME_MPS and _undisturbed(stage, actor, phase)
    if begins is None or (begins > speed - SAME_MPS and not slows):
        stage.nominal.pop(f"{name}/gains", None)
        return Ride.under_way(speed)
    ride = Ride(begins, -usual.brakes if slows else usual.gains, speed)
    stage.nominal[f"{name}/begins"] = ride.first
    stage.nominal[f"{name}/gains"] = ride.rate
    stage.nominal[f"{name}/reaches"] = ride.speed
    return ride


def _undisturbed(stage: Stage, actor: str, phase: Phase) -> bool:
    """Whether nothing has changed a speed since the segment before."""
    phases = stage.story.phases[actor]
    k = phases.index(phase)
    return k > 0 and phases[k - 1].end.event in UNDISTURBED


def gain_of(stage: Stage, actor: str, phase: Phase) -> float:
    """Rate [m/s^2] of a segment of which the prompt says that it gains speed."""
    usual = 100.0 * pace(stage.doc, stage.member(actor)).gains
    low, high, _ = bounds(phase.edge.params.acceleration, (usual, usual))
    return max(0.01 * min(max(usual, low), high), 0.1)


def _begins(stage: Stage, actor: str, phase: Phase) -> float | None:
    """Speed [m/s] with which a segment begins; None for what is at its speed at once."""
    body, phases, start = stage.prop(actor), stage.story.phases[actor], phase.start
    if phase.edge.event not in CRUISES or stage.story.flies(actor):
        return None
    by_hand = body.rolls and not body.wheeled
    if by_hand or stage.anchor is not None or support_of(stage.doc, stage.member(actor)):
        return None
    if phase is phases[0]:
        if start.event is NodeEvent.SCENE_START or stage.time.get(start.id, 0.0) <= 0.0:
            return None
        return stage.struck.get(actor, 0.0)
    before = phases[phases.index(phase) - 1]
    others = [p for p in start.participants if p != stage.member(actor)]
    if start.event is NodeEvent.COLLISION and any(stage.prop(stage.key(p)).fixed for p in others):
        return 0.0
    turns_round = before.edge.params.backward is not phase.edge.params.backward
    return 0.0 if turns_round else stage.tracks[actor].speed
