"""Slowing down: at a constant rate, and never harder than the ground allows."""

from __future__ import annotations

from esg.dynamics.choreography.placing import asked_distance
from esg.dynamics.choreography.stage import Stage, speed_is_fixed
from esg.dynamics.story.kinematics import braked, slowing
from esg.dynamics.story.paces import grip, hardest_brake, slows_by, stated_rate
from esg.dynamics.story.stagecraft import coasting_drag
from esg.dynamics.story.story import CRUISES, UNDISTURBED, Phase, bounds
from esg.graph.models import NodeEvent

INTO_HIT = 0.38
"""Share of its speed that is left to what brakes and still runs into something."""
GOES_ON = 0.4
"""The same of what brakes and goes on, where nothing says how fast."""
LONGEST_STOP_S = 14.0
LEAST_S = 0.2


def brake(stage: Stage, actor: str, phase: Phase, duration: float | None) -> None:
    """Slows an actor down, to rest or to what it goes on with.

    Args:
        stage: What is told so far.
        actor: Who brakes.
        phase: The braking.
        duration: That the prompt gives it [s], None where that is open.
    """
    track = stage.tracks[actor]
    speed = track.speed or stage.speed(actor, phase)
    stops = phase.end.event is NodeEvent.STOP
    left = 0.0 if stops else _goes_on_at(stage, actor, phase, speed)
    if _drives_on(stage, actor, phase):
        usual = stage.halt(actor, speed)
        lasts = (speed - left) / usual if duration is None else duration
        lasts = max(lasts, (speed - left) / grip(stage.doc, stage.member(actor)))
        stage.nominal[f"{phase.edge.id}/leaves"] = left / max(speed, 1e-6)
        track.straight(0.5 * (speed + left) * lasts, lasts, left)
        return
    way = asked_distance(stage, phase.end, actor) if stops else None
    if way is not None and speed > 0.0:
        duration = 2.0 * way / speed
    way, lasts, left = slow_down(stage, phase, speed, left, duration)
    track.straight(way, lasts, left)


def brake_into(
    stage: Stage, phase: Phase, speed: float, prescribed: float | None, now: float
) -> tuple[float, float, float]:
    """Braking that still ends in a hit: way [m], time [s] and speed left [m/s]."""
    duration = None if prescribed is None else max(LEAST_S, prescribed - now)
    body, actor = stage.prop(phase.edge.actor), phase.edge.actor
    if duration is None and not stage.held(actor):
        duration = max(float(stage.rng.uniform(0.7, 1.0)), shortest(stage, actor, speed))
        drag = coasting_drag(body)
        if drag > 0.0:
            duration = min(duration, 0.7 * (1.0 - INTO_HIT) * speed / drag)
    return slow_down(stage, phase, speed, INTO_HIT * speed, duration)


def shortest(stage: Stage, actor: str, speed: float) -> float:
    """Time [s] in which usual brakes take so much of a speed [m/s] that it counts as braking."""
    return (1.0 - INTO_HIT) * speed / stage.halt(actor, speed)


def slow_down(
    stage: Stage, phase: Phase, speed: float, left: float, duration: float | None
) -> tuple[float, float, float]:
    """Braking from one speed to another [m/s]: the plan is told how.

    Returns:
        Way [m], time [s], and the speed that is left [m/s] where the ground does not allow more.
    """
    actor, name = phase.edge.actor, stage.member(phase.edge.actor)
    edge = phase.edge
    usual = stage.halt(actor, speed)
    lasts = min((speed - left) / usual if duration is None else duration, LONGEST_STOP_S)
    lasts = max(lasts, 0.05)
    low, _, stated = bounds(edge.params.damping, (0.0, 0.0))
    if stated:
        drag = coasting_drag(stage.prop(actor))
        stage.nominal[f"{edge.id}/damping"] = low
        way, left = slowing(speed, low, drag, lasts)
        return way, lasts, left
    told = stated_rate(edge)
    needed = 0.5 * sum(told) if told else (speed - left) / lasts
    if stage.held(actor):
        # Its soles would stop it in their own time: it slows down step by step instead.
        rate = max(min(needed, grip(stage.doc, name)), 0.05)
        stage.nominal[f"{edge.id}/stopping"] = speed / rate
        way, left = braked(speed, rate, lasts)
        return way, lasts, left
    by_itself = slows_by(stage.doc, name, speed)
    rate = max(needed - by_itself, 0.05)
    if told is None or told[0] < told[1]:
        rate = min(rate, hardest_brake(stage.doc, name, speed))
    stage.nominal[f"{edge.id}/braking"] = rate
    stage.nominal[f"{edge.id}/brakes_from"] = speed
    if left <= 0.0 or told:
        lasts = (speed - left) / (rate + by_itself)
    way, left = braked(speed, rate + by_itself, lasts)
    return way, lasts, left


def _drives_on(stage: Stage, actor: str, phase: Phase) -> bool:
    """Whether its own power takes it from one speed to another, with which it goes on."""
    phases = stage.story.phases[actor]
    k = phases.index(phase)
    if not 0 < k < len(phases) - 1 or phase.end.event not in UNDISTURBED:
        return False
    if bounds(phase.edge.params.damping, (0.0, 0.0))[2]:
        return False
    return all(p.edge.event in CRUISES for p in (phases[k - 1], phases[k + 1]))


def _goes_on_at(stage: Stage, actor: str, phase: Phase, speed: float) -> float:
    """Speed [m/s] to which it brakes: that with which the prompt has it go on."""
    phases = stage.story.phases[actor]
    after = phases[phases.index(phase) + 1 :]
    if after and after[0].edge.speed_is_prescribed and speed_is_fixed(after[0]):
        return min(0.01 * bounds(after[0].edge.params.speed, (0.0, 0.0))[0], speed)
    return GOES_ON * speed
