"""On which side the prompt has something hit, and how it is turned towards what comes for that."""

from __future__ import annotations

import math

import numpy as np

from esg.graph.models import EsgDocument, Predicate, Side

_TURNS: dict[Side, tuple[float, ...]] = {
    "front": (math.pi,),
    "rear": (0.0,),
    "left": (0.5 * math.pi,),
    "right": (-0.5 * math.pi,),
    "side": (0.5 * math.pi, -0.5 * math.pi),
}
"""Yaw of what is hit on a side, from the heading of what comes [rad]."""


def stated_side(doc: EsgDocument, event: str, struck: str, by: str) -> Side | None:
    """The side on which a statement has one node hit by another in an event, if any does."""
    for s in doc.statements or ():
        here = s.predicate is Predicate.STRUCK_ON and s.when == event
        if here and struck in s.object and by in s.target:
            return s.side
    return None


def stated_turn(
    doc: EsgDocument, event: str, struck: str, by: str, rng: np.random.Generator
) -> float | None:
    """Yaw of what is hit, from the heading of what comes [rad]; None where any will do."""
    side = stated_side(doc, event, struck, by)
    turns = () if side is None else _TURNS.get(side, ())
    return float(rng.choice(turns)) if turns else None
