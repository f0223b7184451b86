"""How several things stand and move to each other: in a line, abreast, against each other."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from esg.draft.discourse.core import entity_of
from esg.draft.discourse.record import Discourse
from esg.draft.events.courses import measurable
from esg.draft.statements.account import CHAINS
from esg.graph.models import NodeEvent

FILES = frozenset({"row", "line", "column", "file", "queue", "convoy"})
"""Arrangements one behind the other, or side by side."""


def in_line(d: Discourse, about: set[str]) -> bool:
    """Whether they are laid out in a row, or follow each other into a hit."""
    members = [entity_of(d, i) for i in about if entity_of(d, i).group is not None]
    rows = bool(members) and all(e.pattern in ("row", "queue") and e.in_group for e in members)
    wholes = {entity_of(d, i).whole for i in about}
    if len(wholes) == 1 and all(wholes):
        return True  # the balls of a cradle
    after = {
        e.actor for e in d.timeline.edges if e.actor in about and e.target in about - {e.actor}
    }
    return rows or len(after) >= max(len(about) - 1, 1)


def _mutual(d: Discourse, about: set[str]) -> bool:
    """Whether two of them meet, or one of them goes for the other, or they fell each other."""
    met = (
        n for n in d.timeline.nodes if measurable(n.event) and len(about & {*n.participants}) > 1
    )
    chain = any(entity_of(d, i).pattern in CHAINS for i in about)
    aims = (e for e in d.timeline.edges if e.actor in about and e.target in about)
    faces = (i for i in about if d.scene.facing.get(i) in about)
    relations = (r for r in d.scene.relations if {r.source, r.target} <= about)
    return chain or any(any(found) for found in (met, aims, faces, relations))


def _stacked(d: Discourse, about: set[str]) -> bool:
    return any(entity_of(d, i).pattern == "stack" for i in about)


def _singly(d: Discourse, about: set[str]) -> bool:
    """Whether each of several of one plural has an event of its own, after the one before."""
    members = {i for i in about if entity_of(d, i).group is not None}
    told = [n for n in d.timeline.nodes if measurable(n.event) and n.event is not NodeEvent.MISS]
    told = [n for n in told if n.participants[0] in members]
    first: dict[str, str] = {}
    for n in told:
        first.setdefault(n.participants[0], n.id)
    after = {(a, n.id) for n in told for a in n.after} | {*d.moves.outrun}
    after |= {(c.since or "", n.id) for n in told for c in n.constraints}
    ids = [*first.values()]
    ordered = all(pair in after for pair in pairwise(ids))
    return bool(members) and members <= {*first} and ordered


def _abreast(d: Discourse, about: set[str]) -> bool:
    relations = (r for r in d.scene.relations if {r.source, r.target} <= about)
    return any(entity_of(d, i).pattern == "row" for i in about) or any(relations)


SHOWN_BY: dict[str, Callable[[Discourse, set[str]], bool]] = {
    "each other": _mutual,
    "one another": _mutual,
    "on top of each other": _stacked,
    "in a row": in_line,
    "in a line": in_line,
    "in rows": in_line,
    "from left to right": in_line,
    "from right to left": in_line,
    "side by side": _abreast,
    "one by one": _singly,
}
"""What adverbs of several things ask of the scene."""
