"""Quantities told one after the other for several things: "three balls of 1 kg, 2 kg and 3 kg"."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Phrase
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount

_SHARED = lex.word_set("shared")
_TELLING = lex.word_set("telling (shares)")


def parts(amounts: Iterable[Amount]) -> list[Amount]:
    """The quantities with every list taken apart."""
    return [part for a in amounts for part in a.shares or (a,)]


def dealt(amounts: Iterable[Amount], number: int) -> list[list[Amount]]:
    """Which quantities each of several things has.

    Args:
        amounts: What is told of all of them, lists as one quantity or as several.
        number: How many things there are.

    Returns:
        One list a thing: of as many values of one kind as there are things each has its own, in
        order; of everything else each has all.
    """
    out: list[list[Amount]] = [[] for _ in range(number)]
    for dimension, same in groupby(parts(amounts), key=lambda a: a.dimension):
        values = list(same)
        own = number > 1 and len(values) == number and dimension in _SHARED
        for k in range(number):
            out[k] += [values[k]] if own else values
    return out


def count(attachments: Iterable[tuple[Mention, Phrase]]) -> None:
    """Sets the number of a plural from the list of values it has ("balls of 1 kg and 2 kg")."""
    for m, p in attachments:
        lists = [a for a in p.told if a.shares]
        if m.plural and m.count is None and m.pattern is None and p.prep in _TELLING and lists:
            m.count = len(lists[0].shares)
