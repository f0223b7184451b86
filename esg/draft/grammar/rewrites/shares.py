"""Quantities told one after the other for several things: "three balls of 1 kg, 2 kg and 3 kg"."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import groupby

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Phrase
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.text.quantities import Amount

_SHARED = lex.word_set("shared")
_TELLING = lex.word_set("telling (shares)")


_COLORS = frozenset(lex.COLORS)
_OPENING = frozenset({",", "(", "-", "–", "—", ":"})
_SLOPED = lex.word_set("sloped")
_EACH = frozenset({"each", "apiece"})


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


def own_nouns(elements: list[Element]) -> list[Element]:
    """Gives quantities that stand for a noun their noun.

    Args:
        elements: What the chunker found.

    Returns:
        The elements; in "a 2 kg and a 4 kg cart" there are two carts, and "the 5 kg one" is one
        noun phrase.
    """
    out: list[Element] = []
    for k in range(len(elements) - 1, -1, -1):  # a noun comes after what stands for it
        if _says_nothing(elements, k, out):
            continue
        out.insert(0, elements[k])
        _lean(elements[k - 1] if k else None, out)
        _name(out)
    return _coloured(out)


def _says_nothing(elements: list[Element], k: int, after: list[Element]) -> bool:
    """ "at 10 m/s each", "another 2 s", "spaced 30 cm apart": words that add nothing."""
    e, before = elements[k], elements[k - 1] if k else None
    if isinstance(e, Verb):
        return e.lemma in ("space", "spaced") and _is_amount(*after[:1])
    if not isinstance(e, Mention):
        return False
    told = before.amount if isinstance(before, Word) else None
    if {e.head, e.pronoun} & _EACH and told is not None and told.dimension == "speed":
        return True
    more = e.pronoun == "another" and bool(after) and _is_time(after[0])
    if more and isinstance(before, Word) and before.kind == "sub":
        before.kind = "prep"  # "after another 2 s it stops" is no clause of its own
    return more


def _lean(thing: Element | None, out: list[Element]) -> None:
    """ "a ramp inclined at 20 degrees": the angle is the ramp's."""
    verb = out[0] if out else None
    angle = _inclination(out) if isinstance(verb, Verb) and verb.lemma in _SLOPED else None
    if angle and isinstance(thing, Mention) and thing.noun and "incline" in thing.noun.traits:
        thing.amounts.append(angle)
        del out[:3]


def _name(out: list[Element]) -> None:
    """Gives the quantity in front its noun: "the 5 kg one", "a 2 kg and a 4 kg cart"."""
    first, second = out[0] if out else None, out[1] if len(out) > 1 else None
    if not isinstance(first, Word):
        return
    one = isinstance(second, Mention) and second.pronoun == "one"
    if _is_amount(first) and isinstance(second, Mention):
        if one and first.amount and not second.adjectives and not second.amounts:
            out[:2] = [replace(second, start=first.start, amounts=[first.amount], determiner="the")]
    elif _article(first) and len(out) > 3 and _is_amount(second) and _and(out[2]):
        like = out[3]
        if isinstance(like, Mention) and like.amounts and like.head and not like.plural:
            assert isinstance(second, Word) and second.amount is not None
            sizes = [a for a in like.adjectives if not a.startswith("@")]
            out[:2] = [
                replace(
                    like, start=first.start, end=second.end, determiner=first.low,
                    amounts=[second.amount], adjectives=sizes, coordinated=[], entities=[],
                )
            ]  # fmt: skip
    elif first.low == "the" and isinstance(second, Mention) and one and second.amounts:
        out[:2] = [replace(second, start=first.start)]


def _coloured(elements: list[Element]) -> list[Element]:
    """ "two balls, one red and one blue,": a red ball and a blue ball."""
    out: list[Element] = []
    k = 0
    while k < len(elements):
        e = elements[k]
        end, colors = _colors(elements, k + 1) if isinstance(e, Mention) else (k, [])
        if isinstance(e, Mention) and e.plural and e.count == len(colors) > 1 and e.head:
            for n, color in enumerate(colors):
                if n:
                    out.append(Word(e.end, e.end, "conj", "and"))
                own = [*e.adjectives, color]
                out.append(
                    replace(
                        e, plural=False, count=None, determiner="a", adjectives=own,
                        text=f"{color} {e.head}", coordinated=[], entities=[],
                        amounts=dealt(e.amounts, len(colors))[n],
                    )
                )  # fmt: skip
            k = end
        else:
            out.append(e)
            k += 1
    return out


def _colors(elements: list[Element], at: int) -> tuple[int, list[str]]:
    """The colours between a comma, dash or bracket and the next one, and where they end."""
    opening = elements[at] if at < len(elements) else None
    if not (isinstance(opening, Word) and opening.low in _OPENING):
        return at, []
    found: list[str] = []
    for k in range(at + 1, len(elements)):
        e = elements[k]
        adjectives = e.adjectives if isinstance(e, Mention) else []
        if isinstance(e, Word) and e.low in lex.COLORS:
            found.append(e.low)
        elif isinstance(e, Mention) and e.pronoun == "one" and not set(adjectives) - _COLORS:
            found += adjectives
        elif isinstance(e, Word) and (e.low in ("and", "one", "the", "other") or e.low == ","):
            more = elements[k + 1] if k + 1 < len(elements) else None
            colored = getattr(more, "low", "") in (*lex.COLORS, "one", "and", "the", "other")
            if not colored and getattr(more, "pronoun", "") != "one":
                return (k + 1, found) if e.low == "," else (at, [])
        elif isinstance(e, Word) and e.kind == "punct":
            return (k + 1 if e.low not in ".;" else k), found
        else:
            return (k, found) if isinstance(e, Verb) else (at, [])
    return len(elements), found


def _is_amount(e: Element | None = None) -> bool:
    return isinstance(e, Word) and e.amount is not None and e.amount.dimension in _SHARED


def _is_time(e: Element) -> bool:
    return isinstance(e, Word) and e.amount is not None and e.amount.dimension == "time"


def _inclination(out: list[Element]) -> Amount | None:
    """The angle of "inclined at 20 degrees"."""
    prep, angle = out[1:2], out[2:3]
    told = angle[0].amount if angle and isinstance(angle[0], Word) else None
    at = bool(prep) and isinstance(prep[0], Word) and prep[0].low in ("at", "by", "to", "with")
    return told if at and told is not None and told.dimension == "angle" else None


def _article(e: Element) -> bool:
    return isinstance(e, Word) and e.low in ("a", "an", "the", "one")


def _and(e: Element) -> bool:
    return isinstance(e, Word) and e.low in ("and", ",")
