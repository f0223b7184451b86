"""The table of verb senses: what is read from a clause whose verb has a sense."""

from __future__ import annotations

from collections.abc import Callable

from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame

SenseReader = Callable[[Discourse, Frame, list[str], list[str]], None]
"""Reads a clause: the discourse, the clause's frame, its subjects and its objects (node ids)."""
SENSES: dict[str, SenseReader] = {}
"""Reader of every sense that `verbs.csv` and the idioms name."""


def sense(name: str) -> Callable[[SenseReader], SenseReader]:
    """Registers the reader of a sense; a second reader of the same sense is a mistake.

    Raises:
        ValueError: If the sense has a reader already.
    """

    def register(reader: SenseReader) -> SenseReader:
        if name in SENSES:
            raise ValueError(f"the verb sense {name!r} has two readers")
        SENSES[name] = reader
        return reader

    return register


def read_as(d: Discourse, name: str, f: Frame, s: list[str], o: list[str]) -> None:
    """Reads the frame as if its verb had another sense; never twice as the same one."""
    if (id(f), name) in d.now.rereading:
        d.scene.used[(f.verb.start, f.verb.end)] = "no event of its own"
        return
    d.now.rereading.add((id(f), name))
    SENSES[name](d, f, s, o)
