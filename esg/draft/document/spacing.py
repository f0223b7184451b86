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

_OTHER = r"(?:each\s+other|one\s+another)"
_APART = re.compile(
    rf"[\s,]*(?:from\s+{_OTHER}\s*)?apart\b"
    rf"|\s*(?:(?:away|ahead|apart|further)\s+)?(?:directly\s+|right\s+|just\s+|straight\s+)?"
    r"(?:from|off|of|in\s+front\s+of|behind|ahead\s+of|beside|before|beyond|past|short\s+of"
    rf"|to\s+the\s+(?:left|right)\s+of|left\s+of|right\s+of|clear\s+of)\s+{_OTHER}\b",
    re.IGNORECASE,
)
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
    r"\b(?:gap|spacing|space|interval|distance|separation)s?\s*"
    r"(?:(?:between\s+(?:[\w'-]+\s+){1,8}|from\s+(?:[\w'-]+\s+){1,4}to\s+(?:[\w'-]+\s+){1,4})?"
    r"(?:is|of|measures|are|:|=))?\s*$",
    re.IGNORECASE,
)
""" "a gap of", "the gap between the two jeeps is"."""
_GAPS = lex.word_set("gaps (spacing)")
_TRAVELS = re.compile(
    r"\b(?:fall|drop|fell|jump|leap|mov|roll|slid|driv|travel|run|walk|go|fl[iey]|climb|brak|stop"
    r"|reverse|push|shov|skid)\w*\s+(?:(?:down|up|forward|back|for|about|over|another)\s+)*$",
    re.IGNORECASE,
)
"""Verbs whose length is a way, not a gap."""


def space(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Adds the distances at the start that nothing else has read.

    Args:
        text: The prompt.
        mentions: Its noun phrases.
        scene: The interpreted scene; its relations grow.
    """
    things = [m for m in mentions if not (m.attribute and m.head in _GAPS)]
    owned = [a for m in things for a in parts(m.amounts)]
    named = [(m, ids) for m in mentions if (ids := _things(m, scene))]
    for a in find_amounts(text):
        span = (a.start, a.end)
        if a.dimension != "length" or span in scene.used or a in owned:
            continue
        pair = _pair(text, a, named, scene)
        for one, other in pairwise(pair):
            scene.relations.append(Relation(one, other, "near", _span(a)))
        if pair:
            scene.used[span] = "distance at the start"


def _span(a: Amount) -> Quantity:
    """The distance, open sides closed."""
    if a.bound == "max":
        return (0.2 * a.high, a.high)
    return (a.low, 1.5 * a.low) if a.bound == "min" else a.value


def _pair(text: str, a: Amount, named: list[tuple[Mention, list[str]]], scene: Scene) -> list[str]:
    """The things that are this far from each other: two, or all of a plural."""
    before = [ids for m, ids in named if m.end <= a.start]
    after = [ids for m, ids in named if m.start >= a.end]
    rows = (_row(m, ids, scene) for m, ids in reversed(named) if m.end <= a.start)
    plural = next((row for row in rows if len(row) > 1), list[str]())
    lead = text[max(0, a.start - 90) : a.start]
    if _GAP_OF.search(lead):
        return plural or _two(before[-2:] if len(before) > 1 else after)
    if _APART.match(text, a.end):
        return plural or _two([ids[:1] for ids in before[-2:]]) or _two(after)
    if _BETWEEN.match(text, a.end) and after:
        return _two(after)
    if _AHEAD.match(text, a.end) and before and not _TRAVELS.search(lead):
        return _two([ids[:1] for ids in reversed(before)])[::-1]
    return []


def _row(m: Mention, ids: list[str], scene: Scene) -> list[str]:
    """All of what one is picked of: "the second of four bottles"."""
    groups = scene.world.groups.values() if m.pick or m.single else ()
    return next((list(g) for g in groups if ids[0] in g), ids)


def _two(found: list[list[str]]) -> list[str]:
    """All of the first plural, or the first two different things."""
    many = next((ids for ids in found if len(ids) > 1), list[str]())
    ids = list(dict.fromkeys(x[0] for x in found))
    return many or (ids[:2] if len(ids) > 1 else [])


def _things(m: Mention, scene: Scene) -> list[str]:
    world = scene.world
    ids = [current_id(world, i) for i in world.resolved.get(id(m), m.entities)]
    fit = [] if m.attribute else [i for i in ids if i in world.entities]
    return [i for i in fit if "structural" not in world.entities[i].noun.traits]
