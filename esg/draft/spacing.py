"""Distances between things that no verb of the scene carries: "1 m apart", "12 m ahead"."""

from __future__ import annotations

from itertools import pairwise
import re

from esg.draft.elements import Mention
from esg.draft.quantities import Amount, find_amounts
from esg.draft.scene import Relation, Scene

_APART = re.compile(r"[\s,]*(?:from\s+(?:each\s+other|one\s+another)\s*)?apart\b", re.IGNORECASE)
_AHEAD = re.compile(r"\s*(?:straight\s+)?(?:ahead|away|further\s+(?:on|down|along)|off)\b", re.I)
_BETWEEN = re.compile(
    r"\s*(?:(?:of\s+\w+\s+)?(?:lie|lies|are|is|separates?|divides?|part|parts)\b(?:\s+between)?"
    r"|(?:of\s+\w+\s+)?between)\s",
    re.IGNORECASE,
)
_GAP_OF = re.compile(
    r"\b(?:gaps?|spacing|spaces?|intervals?|distances?)\s+(?:of|between\s+\w+(?:\s+\w+)?\s+is)\s*$",
    re.I,
)


def space(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Adds the distances at the start that nothing else has read.

    Args:
        text: The prompt.
        mentions: Its noun phrases.
        scene: The interpreted scene; its relations grow.
    """
    for a in find_amounts(text):
        span = (a.start, a.end)
        inside = any(a in m.amounts for m in mentions)
        if a.dimension != "length" or span in scene.used or inside:
            continue
        pair = _pair(text, a, mentions, scene)
        if not pair:
            continue
        for one, other in pairwise(pair):
            scene.relations.append(Relation(one, other, "near", a.value))
        scene.used[span] = "distance at the start"


def _pair(text: str, a: Amount, mentions: list[Mention], scene: Scene) -> list[str]:
    """The things that are this far from each other: two, or all of a plural."""
    named = [(m, ids) for m in mentions if (ids := _things(m, scene))]
    before = [(m, ids) for m, ids in named if m.end <= a.start]
    after = [(m, ids) for m, ids in named if m.start >= a.end]
    plural = next((ids for m, ids in reversed(before) if len(ids) > 1), [])
    if _APART.match(text, a.end) or _GAP_OF.search(text, max(0, a.start - 40), a.start):
        both = [ids[0] for _, ids in before[-2:]]
        return plural or (both if len(both) == 2 and both[0] != both[1] else [])
    if re.match(r"\s+from\b", text[a.end :]) and len(after) > 1:
        one, other = after[0], after[1]
        if re.fullmatch(r"\s+to\s+", text[one[0].end : other[0].start]):
            return [one[1][0], other[1][0]]  # "it is 3 m from the ball to the cone"
    link = _BETWEEN.match(text, a.end)
    if link is not None and after:
        first = after[0][1]
        if len(first) > 1:
            return first
        second = next((ids for _, ids in after[1:] if ids[0] != first[0]), [])
        return [first[0], second[0]] if second else []
    if _AHEAD.match(text, a.end) and before:
        other = before[-1][1][0]
        mover = _comes_to(other, scene) or next(
            (ids[0] for _, ids in reversed(before) if ids[0] != other), ""
        )
        return [mover, other] if mover else []
    return []


def _things(m: Mention, scene: Scene) -> list[str]:
    if m.attribute:
        return []
    world = scene.world
    ids = [world.current(i) for i in world.resolved.get(id(m), m.entities)]
    fit = [i for i in ids if i in world.entities]
    return [i for i in fit if "structural" not in world.entities[i].noun.traits]


def _comes_to(other: str, scene: Scene) -> str:
    """Who meets it first."""
    for node in scene.timeline.nodes:
        if other in node.participants and len(node.participants) == 2:
            return next(p for p in node.participants if p != other)
    return ""
