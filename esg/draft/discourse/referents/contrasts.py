"""What "the light one" means beside "the heavy book": a thing alike, told apart by an adjective."""

from __future__ import annotations

from collections.abc import Iterable

from esg.draft.discourse.referents.entities import Entity
from esg.draft.text.elements import Mention

_CONTRASTS = (
    frozenset({"heavy", "light"}),
    frozenset({"big", "large", "huge", "small", "little", "tiny"}),
    frozenset({"tall", "short", "long"}),
    frozenset({"thick", "thin"}),
    frozenset({"wide", "narrow"}),
    frozenset({"full", "empty", "loaded", "half-empty"}),
    frozenset({"old", "new"}),
    frozenset({"fast", "slow"}),
    frozenset({"wooden", "metal", "steel", "iron", "plastic", "rubber", "glass", "stone", "paper"}),
    frozenset({"striped", "solid", "plain", "spotted"}),
    frozenset({"round", "square", "flat"}),
    frozenset({"moving", "parked", "stationary", "standing", "resting", "stopped"}),
)
"""Adjectives of which a thing has one, so that another one tells of another thing."""


def contrasting(m: Mention, things: Iterable[Entity]) -> tuple[str, Entity | None]:
    """The thing that "the ADJ one" means, or the one that it is told apart from.

    Args:
        m: The phrase; its adjectives decide.
        things: Objects of the scene, in the order of the text.

    Returns:
        The id of what has the adjective, else ""; and what has another one of its kind, if any.
    """
    if m.determiner not in ("the", "a", "an", "another"):
        return "", None
    solid = [e for e in things if "structural" not in e.noun.traits]
    for word in m.adjectives:
        rivals = next((c for c in _CONTRASTS if word in c), None)
        if rivals is None:
            continue
        same = [e for e in solid if word in e.adjectives]
        if same:
            return same[-1].id, None
        other = [e for e in solid if rivals & {*e.adjectives} and e.group is None]
        if other:
            return "", other[-1]
    return "", None
