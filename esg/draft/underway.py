"""What is on its way when it is hit: "a ball hits a car, which then brakes", "... drives on"."""

from __future__ import annotations

from esg.draft.elements import Verb
from esg.draft.frames import Frame

_CONTROL = frozenset({"brake", "slow", "swerve", "turn", "overtake", "merge", "accelerate"})
"""Senses of what only does them that moves by itself."""
_ON = frozenset({"on", "onward", "onwards"})
_DRIVING = frozenset({"own", "cross", "leave", "fly", "continue", "roll"})
_AT_REST = frozenset({"posture", "park", "stop"})
_RESTING = frozenset(
    {"parked", "stationary", "waiting", "standing", "resting", "stopped", "sleeping", "idle",
     "motionless", "sitting", "still", "stalled", "abandoned", "immobile", "broken-down"}
)  # fmt: skip


def goes_on(told: list[Frame], verb: Verb, actor: str, words: list[str], text: str) -> bool:
    """Whether what is hit was moving: the first thing told of it afterwards presupposes that.

    Args:
        told: The clauses in order of time, with their noun phrases resolved.
        verb: The verb of the hit.
        actor: What is hit, that can move by itself and of which no motion has been told.
        words: Adjectives of `actor`.
        text: The prompt.
    """
    at = next((k for k, f in enumerate(told) if f.verb is verb), -1)
    if at < 0 or _RESTING & set(words):
        return False
    for k, f in enumerate(told):
        if f.subject is None or actor not in f.subject.entities or f.verb is verb:
            continue
        if f.verb.sense in _AT_REST and (k < at or f.reduced):
            return False
        if k < at:
            continue
        if f.unreal or f.verb.negated or f.verb.passive or f.verb.infinitive:
            return False
        particles = {*f.adverbs, *text[f.verb.start : f.verb.end].lower().split()}
        on = bool(_ON & particles) or "continue" in f.verb.extra
        on = on or f.verb.sense == "continue"
        return f.verb.sense in _CONTROL or (on and f.verb.sense in _DRIVING)
    return False
