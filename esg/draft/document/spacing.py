"""Distances between things that no verb of the scene carries: "1 m apart", "12 m ahead"."""

from __future__ import annotations

from itertools import pairwise
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.registry import current_id
from esg.draft.discourse.scene import Relation, Scene
from esg.draft.grammar.rewrites.shares import parts
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount, find_amounts
from esg.graph.models import Quantity

_APART = re.compile(r"[\s,]*(?:from\s+(?:each\s+other|one\s+another)\s*)?apart\b", re.IGNORECASE)
_AHEAD = re.compile(
    r"\s*(?:straight\s+)?(?:ahead|away|further\s+(?:on|down|along)|off"
    r"|(?:down|up|along)\s+the\s+\w+)\b",
    re.IGNORECASE,
)
_BETWEEN = re.compile(
    r"\s*(?:(?:of\s+\w+\s+)?(?:lie|lies|are|is|separates?|divides?|part|parts)\b(?:\s+between)?"
    r"|(?:of\s+\w+\s+)?between)\s",
    re.IGNORECASE,
)
_GAP_OF = re.compile(
    r"\b(?:gaps?|spacing|spaces?|intervals?|distances?|separation)\s*(?:of|[:=]|is)?\s*$", re.I
)
_GAP_BETWEEN = re.compile(
    r"\b(?:gap|spacing|space|interval|distance|separation)\s+(?:between\s+(?:[\w'-]+\s+){1,8}"
    r"|from\s+(?:[\w'-]+\s+){1,4}to\s+(?:[\w'-]+\s+){1,4})"
    r"(?:is|of|measures|are|:|=)\s*$",
    re.IGNORECASE,
)
""" "the gap between the two jeeps is"."""
_FROM = re.compile(
    r"\s*(?:(?:away|ahead|apart|further)\s+)?(?:directly\s+|right\s+|just\s+|straight\s+)?"
    r"(?:from|off|of|in\s+front\s+of|behind|ahead\s+of|beside|before|beyond|past|short\s+of"
    r"|to\s+the\s+(?:left|right)\s+of|left\s+of|right\s+of|clear\s+of)\s+",
    re.IGNORECASE,
)
_GAPS = lex.word_set("gaps (spacing)")
_EACH_OTHER = re.compile(r"(?:each\s+other|one\s+another)\b", re.IGNORECASE)
_TRAVELS = re.compile(
    r"\b(?:fall|drop|fell|jump|leap|mov|roll|slid|driv|travel|run|walk|go|fl[iey]|climb|brak|stop"
    r"|reverse|push|shov|skid)\w*\s+(?:(?:down|up|forward|back|for|about|over|another)\s+)*$",
    re.IGNORECASE,
)
"""Verbs whose length is a way, not a gap."""
_INTERVALS = re.compile(r"[\s-]+(?:intervals?|spacing|gaps?)\b", re.IGNORECASE)


def space(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Adds the distances at the start that nothing else has read.

    Args:
        text: The prompt.
        mentions: Its noun phrases.
        scene: The interpreted scene; its relations grow.
    """
    for a in find_amounts(text):
        span = (a.start, a.end)
        things = [m for m in mentions if not (m.attribute and m.head in _GAPS)]
        inside = any(a in parts(m.amounts) for m in things)
        if a.dimension != "length" or span in scene.used or inside:
            continue
        pair = _pair(text, a, mentions, scene)
        if not pair:
            continue
        for one, other in pairwise(pair):
            scene.relations.append(Relation(one, other, "near", _span(a)))
        scene.used[span] = "distance at the start"


def _span(a: Amount) -> Quantity:
    """The distance, open sides closed."""
    if a.bound == "max":
        return (0.2 * a.high, a.high)
    return (a.low, 1.5 * a.low) if a.bound == "min" else a.value


def _pair(text: str, a: Amount, mentions: list[Mention], scene: Scene) -> list[str]:
    """The things that are this far from each other: two, or all of a plural."""
    named = [(m, ids) for m in mentions if (ids := _things(m, scene))]
    before = [(m, ids) for m, ids in named if m.end <= a.start]
    after = [(m, ids) for m, ids in named if m.start >= a.end]
    plural = next((w for m, ids in reversed(before) if (w := _all(m, ids, scene))), [])
    lead = text[max(0, a.start - 90) : a.start]
    if (stated := _GAP_BETWEEN.search(lead)) is not None:
        inside = [ids for m, ids in before if m.start >= a.start - len(lead) + stated.start()]
        return _two(inside)
    if _GAP_OF.search(lead) or _INTERVALS.match(text, a.end):
        return plural or _two([ids for _, ids in (before[-2:] if len(before) > 1 else after)])
    if re.search(r"\bevery\s+$", lead, re.IGNORECASE):
        return plural
    each = _FROM.match(text, a.end)
    mutual = each is not None and _EACH_OTHER.match(text, each.end()) is not None
    if _APART.match(text, a.end) or mutual:
        one = [ids[:1] for _, ids in before[-2:]]
        group = scene.world.entities[one[-1][0]].group if one else None
        if not plural and mutual and group in scene.world.groups:
            return list(scene.world.groups[group])  # "the first of three pins, which stand ..."
        return plural or _two(one) or _two([ids for _, ids in after])
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
    if each is not None and after and not _TRAVELS.search(lead):
        first = after[0]
        if text[each.end() : first[0].start].strip().lower() in ("", "the", "a", "an", "its"):
            near = [ids for m, ids in before if "." not in text[m.end : a.start]]
            one = near[-1] if near else next((ids for _, ids in after[1:]), [])
            return _two([one, first[1]]) if one else []
    if _AHEAD.match(text, a.end) and before and not _TRAVELS.search(lead):
        other = before[-1][1][0]
        mover = _comes_to(other, scene) or next(
            (ids[0] for _, ids in reversed(before) if ids[0] != other), ""
        )
        return [mover, other] if mover else []
    return []


def _two(found: list[list[str]]) -> list[str]:
    """All of the first plural, or the first two different things."""
    many = next((ids for ids in found if len(ids) > 1), [])
    if many:
        return many
    ids = list(dict.fromkeys(x[0] for x in found if x))
    return ids[:2] if len(ids) > 1 else []


def _things(m: Mention, scene: Scene) -> list[str]:
    if m.attribute:
        return []
    world = scene.world
    ids = [current_id(world, i) for i in world.resolved.get(id(m), m.entities)]
    fit = [i for i in ids if i in world.entities]
    return [i for i in fit if "structural" not in world.entities[i].noun.traits]


def _all(m: Mention, ids: list[str], scene: Scene) -> list[str]:
    """What a plural names, also where one of it is picked ("the second of four bottles")."""
    if len(ids) > 1 or not (m.pick or m.single):
        return ids if len(ids) > 1 else []
    return next((list(g) for g in scene.world.groups.values() if ids[0] in g), [])


def _comes_to(other: str, scene: Scene) -> str:
    """Who meets it first."""
    for node in scene.timeline.nodes:
        if other in node.participants and len(node.participants) == 2:
            return next(p for p in node.participants if p != other)
    return ""
