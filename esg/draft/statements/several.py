"""What is one of several by its words ("the middle bowl"), of which the others are not there."""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, structural
from esg.draft.discourse.referents.entities import Entity
from esg.draft.statements.account import NOTHING, Account, Gap, nodes_of
from esg.draft.text.elements import Mention

ALONE = "it is the only one of its kind in the scene"
ONE_OF_THEM = "there is one of them"
_ARRANGED = frozenset({"column", "heap", "line", "pile", "row", "stack", "tower"})
_AMONG = lex.word_set("one of several (unclaimed)")
_BETWEEN = frozenset({"middle", "center", "centre", "central"})
"""Words of what has another one on both sides."""
_MIDDLE = re.compile(
    r"\b(?:in|at) the (?:very )?(?:middle|cent(?:er|re))(?= of\s*$)", re.IGNORECASE
)
_THOSE = frozenset({"the", "these", "those"})
_REST = frozenset({"other", "remaining"})
"""Words of what is left, be it of another kind: "the remaining cylinder", of three solids."""
_PARTS = lex.BODY_PARTS | lex.OWN_PARTS | lex.word_set("sides of a thing (audit)")
_WIDE = frozenset({"vehicle", "person", "animal"})
"""Kinds of which one is told from the others by its rank, whatever they are called."""


def one_of_several(a: Account) -> Iterator[Gap]:
    """ "Put the middle bowl on the plate", "the second car brakes": there are others of it."""
    told: set[str] = set()
    for m in a.d.mentions:
        ids = nodes_of(a.d, m)
        if len(ids) != 1 or ids[0] in told or not _singular(m):
            continue
        told.add(ids[0])
        words = [t for t in a.tokens if m.start <= t.start < m.end and t.low in _AMONG]
        word = next((t for t in words if t.low in m.adjectives and t.end < m.end), None)
        if word is None or structural(a.d, ids[0]):
            continue
        e = entity_of(a.d, ids[0])
        fellows = [x for x in a.d.world.entities.values() if _alike(e, x, word.low in _REST)]
        if not e.part and len(fellows) < _others(word.low):
            yield Gap(word.start, m.end, ALONE, (e.id,))


def the_ones(a: Account) -> Iterator[Gap]:
    """ "A book is pulled out, and the ones beside it lean over": it is the only one there."""
    for m in a.d.mentions:
        ones = a.d.text[m.start : m.end].lower().endswith("ones") and m.determiner in _THOSE
        ids = nodes_of(a.d, m) if ones and m.pronoun == "ones" else []
        if ids and len({entity_of(a.d, i).noun.name for i in ids}) == len(ids):
            yield Gap(m.start, m.end, ALONE, tuple(ids))


def several_groups(a: Account) -> Iterator[Gap]:
    """ "Between two rows of cones": there is one row."""
    for m in a.d.mentions:
        words = [t for t in a.tokens if m.start <= t.start < m.end]
        row = next((k for k, t in enumerate(words) if t.low == "of"), 0)
        told = words[row - 1].low if row else ""
        single, several = lex.singular(told)
        named = several and single == m.group_word and single in _ARRANGED
        if named and nodes_of(a.d, m):
            yield Gap(words[0].start, words[row].end, ONE_OF_THEM, tuple(nodes_of(a.d, m)))


def in_the_middle(a: Account) -> Iterator[Gap]:
    """ "Collide in the middle of a table": on it is shown, where on it is not."""
    for p in (p for f in a.frames for p in f.phrases if p.prep == "on" and p.mention is not None):
        found = _MIDDLE.search(a.d.text, 0, p.mention.start) if p.mention is not None else None
        if found is not None:
            yield Gap(found.start(), found.end(), NOTHING)


def _singular(m: Mention) -> bool:
    """Whether it names one thing by "the", "its" or no article at all, and no part of a thing."""
    definite = m.determiner not in ("a", "an", "another", "one") and not m.possessor
    return definite and not m.plural and (m.count or 1) == 1 and m.head not in _PARTS


def _others(word: str) -> int:
    """How many more a word presupposes at least."""
    return 2 if word in _BETWEEN else max(lex.ORDINALS.get(word, 1), 1)


def _alike(e: Entity, x: Entity, rest: bool) -> bool:
    """Whether one is another thing of the kind of the other."""
    if e is x or x.part or not x.mentioned:
        return False
    if rest:
        return x.movable and not {"support", "container"} & x.noun.traits
    wide = e.noun.kind in _WIDE and e.noun.kind == x.noun.kind
    return wide or e.noun.name == x.noun.name or e.head == x.head
