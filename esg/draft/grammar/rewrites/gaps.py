"""Clauses without a verb: "ball A into ball B", "egg off spoon", "..., the second the third"."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.text.elements import Element, Mention, Verb, Word

_STOPS = ".;:!?\n"
_VERBLESS = lex.word_set("verbless")
_VESSELS = lex.word_set("vessels (gaps)")
_DRIVEN = lex.word_set("driven (gaps)")


def word_at(elements: list[Element], i: int) -> Word | None:
    """The small word at a place, if one stands there."""
    e = elements[i] if 0 <= i < len(elements) else None
    return e if isinstance(e, Word) else None


def mention_at(elements: list[Element], i: int) -> Mention | None:
    """The noun phrase at a place, if one stands there."""
    e = elements[i] if 0 <= i < len(elements) else None
    return e if isinstance(e, Mention) else None


def is_word(e: Element, *words: str) -> bool:
    """Whether an element is one of some small words."""
    return isinstance(e, Word) and e.low in words


def is_prep(e: Element) -> bool:
    """Whether an element is a preposition."""
    return isinstance(e, Word) and e.kind in ("prep", "to")


def finite(e: Element | None) -> Verb | None:
    """A main verb with a tense of its own."""
    if not isinstance(e, Verb) or e.infinitive or e.auxiliary or e.passive:
        return None
    return e if e.form in ("s", "past", "base") else None


def _segments(elements: list[Element]) -> list[tuple[int, int]]:
    """Half-open ranges between punctuation and conjunctions."""
    out: list[tuple[int, int]] = []
    start = 0
    for k, e in enumerate(elements):
        cut = isinstance(e, Word) and (
            e.kind in ("conj", "sub", "rel") or (e.kind == "punct" and e.low in ".;:,!?\n—–")
        )
        if cut:
            out.append((start, k))
            start = k + 1
    out.append((start, len(elements)))
    return out


def fill_gaps(elements: list[Element]) -> list[Element]:
    """Inserts the verb that is understood in "ball A into ball B" and "the second the third".

    Args:
        elements: Noun phrases, verbs and small words, subjects before their verbs.
    """
    insert: dict[int, Verb] = {}
    drop: set[int] = set()
    model: Verb | None = None
    parallel = told = False
    bare: int | None = None
    for start, end in _segments(elements):
        before = word_at(elements, start - 1)
        mark = before.low if before is not None else "."
        if mark in _STOPS:
            told, bare, parallel = False, None, False
            model = model if mark in ";:" else None
        part = elements[start:end]
        verbs = [e for e in part if isinstance(e, Verb)]
        if verbs:
            model = next((v for v in reversed(verbs) if finite(v)), None)
            told = True
            parallel = _moves_somewhere(part)
            bare = None
            continue
        k = _gap(part)
        joins = before is not None and before.kind in ("conj", "rel", "sub")
        if k and k[1] == "with" and model is not None and model.sense in ("hit", "knock", "topple"):
            if not joins or parallel:
                insert[start + k[0]] = replace(model, start=part[k[0]].start, end=part[k[0]].start)
            continue
        free = (not told or parallel) and not (joins and before and before.kind != "conj")
        if k and k[1] != "with" and free and (not joins or parallel or bare is not None):
            verb = _understood(part, k[0])
            if verb is not None:
                insert[start + k[0]] = verb
                parallel = True
            continue
        if bare is not None and mark == "," and not told and _leads_on(part):
            verb = _understood([elements[bare], *part], 1 + _prep_at(part))
            if verb is not None:
                insert[start] = verb
                drop.add(start - 1)
                told = True
            bare = None
            continue
        alone = [e for e in part if isinstance(e, Mention)]
        bare = start + part.index(alone[0]) if len(alone) == 1 and not alone[0].attribute else None
    out: list[Element] = []
    for k, e in enumerate(elements):
        if k in insert:
            out.append(insert[k])
        if k not in drop:
            out.append(e)
    return out


def _moves_somewhere(part: list[Element]) -> bool:
    """Whether a clause ends with a direction, so that one without a verb may go on like it."""
    preps = [e for e in part if is_prep(e) and getattr(e, "low", "") in _VERBLESS]
    return bool(preps)


def _prep_at(part: list[Element]) -> int:
    return next(k for k, e in enumerate(part) if is_prep(e))


def _leads_on(part: list[Element]) -> bool:
    """ "straight down into the basket": only where to."""
    preps = [k for k, e in enumerate(part) if is_prep(e)]
    if not preps or any(isinstance(e, Mention) for e in part[: preps[0]]):
        return False
    lows = {getattr(part[k], "low", "") for k in preps}
    return bool(lows & _VERBLESS - {"to"}) and any(isinstance(e, Mention) for e in part)


def _gap(part: list[Element]) -> tuple[int, str] | None:
    """Where the verb of a clause without one belongs, and the preposition or "with" an object."""
    first = next((k for k, e in enumerate(part) if isinstance(e, Mention)), None)
    if first is None or any(is_prep(e) for e in part[:first]):
        return None
    subject = part[first]
    assert isinstance(subject, Mention)
    if subject.attribute or subject.pronoun in ("it", "they", "he", "she", "each", "all"):
        return None
    rest = part[first + 1 :]
    if len(rest) == 1 and isinstance(rest[0], Mention) and not rest[0].attribute:
        return first + 1, "with"
    for k, e in enumerate(rest):
        if isinstance(e, Mention) and not is_prep(rest[k - 1] if k else subject):
            return None
        thing = rest[k + 1] if k + 1 < len(rest) else None
        low = getattr(e, "low", "")
        if is_prep(e) and low in _VERBLESS - {"to"} and isinstance(thing, Mention):
            return (first + 1 + k, low) if not thing.attribute or thing.part else None
    return None


def _understood(part: list[Element], k: int) -> Verb | None:
    """ "goes", "falls" or "hits": what a thing does that is said to be "into" or "off" another."""
    prep = part[k]
    mover = next(e for e in part if isinstance(e, Mention))
    where = next((e for e in part[k:] if isinstance(e, Mention)), None)
    at = mover.end
    low = getattr(prep, "low", "")
    noun = where.noun if where is not None else None
    vessel = noun is not None and noun.kind in _VESSELS and "container" in noun.traits
    powered = mover.noun is not None and mover.noun.kind in _DRIVEN
    if low in ("into", "onto") and not powered and (vessel or low == "onto"):
        return Verb(at, at, "drop", "fall", "s")
    if low == "off" and not powered:
        return Verb(at, at, "fall", "fall", "s")
    return Verb(at, at, "go", "own", "s")
