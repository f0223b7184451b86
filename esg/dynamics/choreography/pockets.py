"""Billiards and other pockets: a shot is planned backwards from where it shall end."""

from __future__ import annotations

import math

from esg.dynamics.choreography.stage import Stage, bounds, speed_is_fixed
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.stagecraft import min_hit_speed, pocket_shot
from esg.graph.models import NodeEvent, TimelineNode

SPREAD_M = 0.35
"""By how much distances of a shot vary."""
BETWEEN_M = (0.12, 0.3)
"""How far a ball of a shot that was hit rolls to the next ball."""
CLOSE_M = (0.06, 0.09)
"""The same in a shot so slow that the ball's next hit would hardly count."""
SLOW = 160.0
"""Such a shot's speed [cm/s] over the least [m/s]."""
COUNTS = 0.25
"""Share of the usual impulse that a ball that starts a shot has at least."""


def pocket_event(stage: Stage) -> TimelineNode | None:
    """The event that something enters a pocket of the table it all takes place on, or None."""
    for node in stage.story.nodes.values():
        owner = (node.region or "").split("/")[0]
        inside = node.event is NodeEvent.ENTER_REGION and owner == stage.anchor
        if inside and owner and stage.concerns(node):
            return node
    return None


def play_pocket(stage: Stage, event: TimelineNode) -> None:
    """A shot planned backwards from the pocket: ball, ghost ball, cue ball."""
    assert stage.anchor is not None and event.region is not None
    chain = _chain_to(stage, event)
    # Passed on over a short way: a ball that was hit slows down until it rolls, and errors grow.
    first = stage.story.phases.get(chain[-1], ())[:1]
    fastest = bounds(first[0].edge.params.speed, (50.0, 600.0))[1] if first else math.inf
    slow = len(chain) > 2 and fastest < SLOW * _least(stage, chain)
    runs: dict[str, tuple[float, float] | None] = {
        name: CLOSE_M if slow else BETWEEN_M for name in chain[1:-1]
    }
    runs[chain[-1]] = _cue_run(stage, chain)
    spots = pocket_shot(stage.doc, stage.anchor, event.region, chain, stage.rng, runs)
    time = 0.0
    for name, (x, y, yaw) in spots.items():
        stage.places[name] = (x, y, yaw)
        if name in stage.tracks:
            stage.frames[name] = Frame(x, y, yaw)
    for node in stage.story.nodes.values():
        asked = stage.prescribed_time(node)
        for actor, phase in stage.incoming(node):
            speed = min(stage.speed(actor, phase), 2.5)
            if speed_is_fixed(phase):
                speed = stage.speed(actor, phase)
            elif asked is not None and asked > time and actor == chain[-1] and len(chain) > 1:
                meant = _gap(stage, spots, actor, chain[-2]) / (asked - time)
                speed = max(meant, _least(stage, chain))
            stage.nominal[f"{phase.edge.id}/speed"] = speed
        if node.event is not NodeEvent.SCENE_START and set(node.participants) & stage.names:
            time = asked if asked is not None else time + 0.5
        stage.time[node.id] = time


def _cue_run(stage: Stage, chain: list[str]) -> tuple[float, float] | None:
    """How far [m] the first ball may roll until the hit whose time the prompt gives, or None."""
    for phase in stage.story.phases.get(chain[-1], ())[:1]:
        asked = stage.prescribed_time(phase.end)
        if asked is None or not set(chain[-2:]) <= set(phase.end.participants):
            return None
        low, high, fixed = bounds(phase.edge.params.speed, (50.0, 600.0))
        if fixed:
            return (0.01 * low * asked, 0.01 * low * asked)
        near = max(0.0105 * low, _least(stage, chain)) * asked
        return (near, max(near, min(0.0095 * high * asked, near + SPREAD_M)))
    return None


def _least(stage: Stage, chain: list[str]) -> float:
    """Speed [m/s] below which the first hit of a shot would not count; 0 where it hits none."""
    if len(chain) < 2:
        return 0.0
    return COUNTS * min_hit_speed(stage.prop(chain[-1]), stage.prop(chain[-2]))


def _gap(stage: Stage, spots: dict[str, tuple[float, float, float]], a: str, b: str) -> float:
    """Free distance [m] between two balls at the start."""
    between = math.hypot(spots[a][0] - spots[b][0], spots[a][1] - spots[b][1])
    return between - 0.5 * (stage.prop(a).width + stage.prop(b).width)


def _chain_to(stage: Stage, event: TimelineNode) -> list[str]:
    """Bodies from the one that enters back to the active one that starts it."""
    chain = [event.participants[0]]
    hits = [n for n in stage.story.nodes.values() if n.event is NodeEvent.COLLISION]
    while not stage.story.is_active(chain[-1]):
        source = next(
            (
                p
                for n in hits
                if chain[-1] in n.participants
                for p in n.participants
                if p not in chain
            ),
            None,
        )
        if source is None:
            break
        chain.append(source)
    return chain
