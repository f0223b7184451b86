"""What the phrases of a clause are to its verb: who does it, from where, into what, at what.

`data/roles.csv` says which prepositions mark a role, with a sentence for each; a row for a sense
goes before the row for all senses ("*").
"""

from __future__ import annotations

import csv
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import kind_of, movable
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import LIMBED
from esg.draft.events.told import things
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention

_WITH_TOOLS = lex.word_set("acts with tools")
_PLACED = re.compile(
    r"\s+(?:on|in|inside|under|beside|behind|next|to|above|at|standing|hanging|lying)\b",
    re.IGNORECASE,
)
"""Where a thing is ("hits a table with a vase on it"): it is no tool."""


@cache
def _rows() -> list[dict[str, str]]:
    with open(lex.DATA / "roles.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter=";"))


@cache
def roles() -> dict[tuple[str, str], tuple[str, ...]]:
    """Prepositions by role and sense."""
    return {(r["role"], r["sense"]): tuple(r["prepositions"].split("|")) for r in _rows()}


def examples() -> list[tuple[str, str, str]]:
    """Role, sentence and what fills the role in it, by row of the table."""
    return [(r["role"], r["example"], r["filled by"]) for r in _rows()]


def role(f: Frame, name: str) -> Phrase | None:
    """The first phrase of a clause that has a role.

    Raises:
        KeyError: If no verb has such a role.
    """
    table = roles()
    return f.phrase(*table.get((name, f.verb.sense), table[name, "*"]))


def filling(f: Frame, name: str) -> list[str]:
    """What has a role in a clause (node ids)."""
    return things(role(f, name))


def doer_and_done(f: Frame, s: list[str], o: list[str]) -> tuple[list[str], list[str]]:
    """Who acts, and on what: of "a crate is hit by a van" the van, and the crate."""
    return (filling(f, "agent"), s) if f.verb.passive else (s, o)


def is_tool(d: Discourse, m: Mention, p: Phrase) -> bool:
    """ "Wipes the table with a sponge": what somebody acts with, and no part of what he acts on.

    Args:
        d: The discourse.
        m: A noun phrase.
        p: A phrase behind it.
    """
    f = next((f for f in d.told if f.object is m and f.verb.lemma in _WITH_TOOLS), None)
    if f is None or p.prep != "with" or p.mention is None or _PLACED.match(d.text, p.mention.end):
        return False
    doers = [] if f.subject is None else f.subject.entities
    tools = [i for i in things(p) if movable(d, i) and kind_of(d, i) not in LIMBED]
    return bool(tools) and all(kind_of(d, i) in LIMBED for i in doers if i in d.world.entities)
