"""On which side the prompt has something hit, and how it is turned towards what comes for that."""

from __future__ import annotations

import math

from esg.dynamics.choreography.stage import Stage
from esg.graph.models import Predicate, Side, TimelineNode

_TURNS: dict[Side, tuple[float, ...]] = {
    "front": (math.pi,),
    "rear": (0.0,),
    "left": (0.5 * math.pi,),
    "right": (-0.5 * math.pi,),
    "side": (0.5 * math.pi, -0.5 * math.pi),
}
"""Yaw of what is hit on a side, from the heading of what comes [rad]."""


def stated_side(stage: Stage, node: TimelineNode, struck: str, by: str) -> Side | None:
    """The side on which a statement has one thing hit by another in an event, if any does."""
    one, other = stage.member(struck), stage.member(by)
    for s in stage.doc.statements or ():
        here = s.predicate is Predicate.STRUCK_ON and s.when == node.id
        if here and one in s.object and other in s.target:
            return s.side
    return None


def stated_turn(stage: Stage, node: TimelineNode, struck: str, by: str) -> float | None:
    """Yaw of what is hit, from the heading of what comes [rad]; None where any will do."""
    side = stated_side(stage, node, struck, by)
    turns = () if side is None else _TURNS.get(side, ())
    return float(stage.rng.choice(turns)) if turns else None
