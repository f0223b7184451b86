"""What the phrases of a clause are to its verb: who does it, from where, into what, at what.

`data/roles.csv` says which prepositions mark a role, with a sentence for each; a row for a sense
goes before the row for all senses ("*").
"""

from __future__ import annotations

import csv
from functools import cache

from esg.draft import lexicon as lex
from esg.draft.events.told import things
from esg.draft.grammar.clauses.frames import Frame, Phrase


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
