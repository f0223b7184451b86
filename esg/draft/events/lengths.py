"""Stated lengths of a scene in motion: ways travelled, gaps at the start, gaps left at the end."""

from __future__ import annotations

import re

from esg.draft.discourse.core import amounts_of, entity_of, kind_of, mark_used, structural
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.registry import current_id
from esg.draft.discourse.scene import SELF_POWERED, Relation
from esg.draft.events.told import at_rest, constrain, unread
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount

_APART = re.compile(
    r"\s*(?:(?:away|ahead|clear)\s+)?(?:directly\s+|right\s+|just\s+)?"
    r"(?:in front of|before|short of|from|of|off|behind|ahead of|next to|beside)\s+"
    r"(?:the\s+|an?\s+|its\s+|his\s+|her\s+|their\s+)?(?:[a-z-]+\s+){0,2}",
    re.IGNORECASE,
)
"""What stands between a length and the thing it is measured from."""

_FROM_AFAR = re.compile(r"from\s+a\s+distance\s+of\s+(?:about\s+)?$", re.IGNORECASE)
_AHEAD = re.compile(
    r"\s*(?:directly\s+|right\s+|just\s+)?(?P<prep>in front of|ahead of|behind)\b", re.IGNORECASE
)
_PREPS = {"in front of": "in front of", "ahead of": "in front of", "behind": "behind"}
_TRAVELLING = ("own", "roll", "slide", "fly", "launch", "reverse")
_PAINTED = frozenset({"crosswalk", "finish line"})
"""What lies on a road and ends: a road itself, or a crossing of two, is under who stops."""


def _apart_from(d: Discourse, a: Amount) -> str | None:
    """The thing that a length is measured from ("1 m in front of a barrier", "a crosswalk")."""
    for m in sorted(d.mentions, key=lambda m: m.start):
        if m.start < a.end:
            continue
        between = d.text[a.end : m.start]
        if not _APART.fullmatch(between + " ") and not _APART.fullmatch(between):
            return None
        if not m.entities or m.attribute or m.part in ("edge", "end", "start", "corner"):
            return None
        found = current_id(d.world, m.entities[0])
        way = structural(d, found) and entity_of(d, found).noun.name not in _PAINTED
        return None if way else found
    return None


def _lengths(d: Discourse, f: Frame) -> list[Amount]:
    """Lengths of a clause that nothing has read yet."""
    return [a for _, a in amounts_of(d, f) if a.dimension == "length" and unread(d, a)]


def stops_short(d: Discourse, f: Frame, actor: str, node_id: str) -> None:
    """ "stops 1 m in front of a barrier": the gap that is left when the event happens."""
    for a in _lengths(d, f):
        other = _apart_from(d, a)
        if other is not None and other != actor:
            constrain(d.timeline.node(node_id), "distance", a.value, actor, to=other)
            mark_used(d, a, f"gap at {node_id}")


def starts_apart(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "starts 5 m from a door": how far things are from each other at the start."""
    for a in _lengths(d, f):
        other = _apart_from(d, a)
        others = [x for x in actors if x != other]
        if other is not None and others:
            d.scene.relations.append(Relation(others[0], other, "near", a.value))
            mark_used(d, a, "distance at the start")


def _keeps_apart(d: Discourse, f: Frame, actors: list[str], a: Amount) -> bool:
    """ "Drives 25 m ahead of a truck": how far it is ahead, and no way that it travels.

    Of what stands there the length is a way: "rolls 2 m behind the sofa".
    """
    at = _AHEAD.match(d.text, a.end)
    other = _apart_from(d, a) if at is not None and f.verb.sense == "own" else None
    bodies = [*actors[:1], *filter(None, [other])]
    goes = len({*bodies}) == len(bodies) > 1 and all(kind_of(d, i) in SELF_POWERED for i in bodies)
    if at is None or other is None or not goes:
        return False
    place(d, actors[:1], [other], _PREPS[at["prep"].lower()], distance=a.value)
    f.phrases[:] = [p for p in f.phrases if p.mention is None or other not in p.mention.entities]
    mark_used(d, a, "distance at the start")
    return True


def distance(d: Discourse, f: Frame, actors: list[str], aim: str | None) -> None:
    """ "toward a bench 6 m away": how far the target is at the start."""
    for a in _lengths(d, f):
        after = d.text[a.end : a.end + 8].strip().lower()
        if after.startswith(("away", "apart", "ahead")) and aim is not None:
            for actor in actors:
                d.scene.relations.append(Relation(actor, aim, "near", a.value))
            mark_used(d, a, "distance at the start")
        elif _keeps_apart(d, f, actors, a):
            continue
        elif after.startswith("apart") or _FROM_AFAR.search(d.text[: a.start]):
            continue  # "two balls 4 m apart roll": the gap at the start (`spacing`)
        elif f.verb.sense in _TRAVELLING and actors and not at_rest(d, actors[0]):
            d.scene.travel[actors[0]] = a
            mark_used(d, a, "distance travelled")
