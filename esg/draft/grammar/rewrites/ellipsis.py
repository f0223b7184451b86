"""Verbs that are understood: "goes straight for 2 s, then left", "does 36 km/h"."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import finite, is_prep, is_word, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_SIDES = frozenset({"left", "right"})
_STEERED = lex.word_set("steered (ellipsis)")
_GOING = lex.word_set("going (ellipsis)")


def elide(elements: list[Element]) -> list[Element]:
    """Inserts verbs that are understood, and reads "does 36 km/h" as a motion.

    Args:
        elements: Noun phrases, verbs and small words, subjects before their verbs.
    """
    out: list[Element] = []
    verb: Verb | None = None
    for i, e in enumerate(elements):
        if isinstance(e, Word) and e.low in _ENDING:
            verb = None
        if isinstance(e, Verb) and _goes_at(elements, i):
            e = replace(e, lemma="go", sense="own", form="s" if e.sense == "be" else e.form)
        if isinstance(e, Mention) and verb is not None and _at_speed(elements, i):
            if verb.sense in _TRAVELLING and not verb.passive:
                out += [e, replace(verb, start=e.end, end=e.end, form="s", extra=dict(verb.extra))]
                continue
            if verb.sense == "hit" and e.pronoun == "one":
                continue  # "two cars collide, one at 2 m/s and the other at 3 m/s"
        if isinstance(e, Mention) and verb is not None and _in_turn(elements, i, verb):
            out += [e, replace(verb, start=e.end, end=e.end, form="s", extra=dict(verb.extra))]
            continue
        if isinstance(e, Mention) and verb is not None and _each_the_next(elements, i, verb):
            out += [e, replace(verb, start=e.end, end=e.end, form="s", extra=dict(verb.extra))]
            continue
        again = _hit_too(elements, i)
        if again is not None:
            if isinstance(out[-1], Word) and out[-1].low == "then":
                out.pop()
            out += [replace(again, start=e.start, end=e.start, extra=dict(again.extra)), e]
            continue
        if isinstance(e, Verb):
            verb = e
        elif verb is not None and _second_turn(elements, i, verb):
            form = "s" if verb.form in ("s", "past") else verb.form
            out.append(Verb(e.start, e.start, "turn", "turn", form))
        out.append(e)
    return out


_TRAVELLING = lex.word_set("travelling (ellipsis)")


def _hit_too(elements: list[Element], i: int) -> Verb | None:
    """ "hits a tent, which collapses, and then a stove": the verb of what else is hit."""
    again = word_at(elements, i)
    if isinstance(elements[i], Verb) or i < 6:
        return None
    if again is not None and (again.kind != "prep" or again.low not in ("into", "against")):
        return None
    end = word_at(elements, i + 1 + (again is not None))
    thing = elements[i] if again is None else elements[min(i + 1, len(elements) - 1)]
    ends = end is not None and end.low in (".", ";", ",", "!", "and", "but")
    if not isinstance(thing, Mention) or not (ends or thing is elements[-1]):
        return None
    before = [x for x in elements[max(0, i - 10) : i] if not _adverb(x)]
    if len(before) < 6 or not is_word(before[-1], "and", "then") or not is_word(before[-2], ","):
        return None
    state, rel = before[-3], before[-4]
    heads = before[:-4]
    if not isinstance(state, Verb) or not isinstance(rel, Word) or rel.kind != "rel":
        return None
    while heads and (
        isinstance(heads[-1], Mention) or is_prep(heads[-1]) or is_word(heads[-1], ",")
    ):
        heads.pop()
    main = finite(heads[-1]) if heads else None
    return main if main is not None and main.sense in ("hit", "knock") else None


def _adverb(e: Element) -> bool:
    return isinstance(e, Word) and e.kind == "adv"


def _in_turn(elements: list[Element], i: int, verb: Verb) -> bool:
    """ "The first falls at 1 s, the second at 2 s": the same, of another one, at its own time."""
    before, at, time = word_at(elements, i - 1), word_at(elements, i + 1), word_at(elements, i + 2)
    e = elements[i]
    if before is None or not (before.kind == "conj" or before.low in (",", ";")):
        return False
    if at is None or time is None or at.low not in ("at", "after") or time.amount is None:
        return False
    if time.amount.dimension != "time" or not isinstance(e, Mention) or verb.passive:
        return False
    one = e.pronoun == "one" and e.determiner == "the"
    if verb.sense not in _ALONE or not (one or e.letters):
        return False
    k = next((n for n in range(i) if elements[n].end >= verb.end), i)
    if k + 1 < i and isinstance(elements[k + 1], Mention):
        return False  # "hits ball B at 2 s, ball C at 3 s": another object
    after = word_at(elements, i + 3)
    return i + 3 >= len(elements) or (after is not None and after.kind in _CLOSES)


def _each_the_next(elements: list[Element], i: int, verb: Verb) -> bool:
    """ "The first bumps the second, and the second the third": two things, no verb between."""
    before, whom = word_at(elements, i - 1), elements[i + 1] if i + 1 < len(elements) else None
    who, after = elements[i], word_at(elements, i + 2)
    if verb.sense not in _ON_THINGS or verb.passive or not isinstance(whom, Mention):
        return False
    joined = before is not None and (before.kind == "conj" or before.low in (",", ";"))
    both = isinstance(who, Mention) and not who.attribute and not whom.attribute
    told = both and all(
        m.letters or (m.determiner and (m.pronoun or m.noun is not None))
        for m in (who, whom)
        if isinstance(m, Mention)
    )
    ends = i + 2 >= len(elements) or (after is not None and after.kind in _CLOSES)
    k = next((n for n in range(i) if elements[n].end >= verb.end), i)
    object_ = k + 1 < i and isinstance(elements[k + 1], Mention)
    return joined and told and ends and object_


_ON_THINGS = lex.word_set("on things")
_ALONE = lex.word_set("alone")


def _named_speed(e: Element) -> bool:
    return isinstance(e, Mention) and e.head in ("speed", "velocity", "pace")


_SHARES = lex.word_set("shares")
_CLOSES = lex.word_set("closes")


def _at_speed(elements: list[Element], i: int) -> bool:
    """ "..., the front one at 8 m/s": a subject and its speed, the verb being the one before."""
    before, at, speed = word_at(elements, i - 1), word_at(elements, i + 1), word_at(elements, i + 2)
    if before is None or not (before.kind == "conj" or before.low in (",", "—", "–")):
        return False
    e = elements[i]
    if at is None or at.low not in ("at", "with") or not isinstance(e, Mention) or e.attribute:
        return False
    if i + 2 < len(elements) and _named_speed(elements[i + 2]):
        return True  # "the green one at a third of its speed"
    if speed is None:
        return False
    end = i + 3
    if speed.amount is None:  # "the blue one at half its speed"
        named = elements[i + 3] if i + 3 < len(elements) else None
        if speed.low not in _SHARES or not isinstance(named, Mention) or not _named_speed(named):
            return False
        speed.kind = "adv"
        end = i + 4
    elif speed.amount.dimension != "speed":
        return False
    after = word_at(elements, end)
    return end >= len(elements) or (after is not None and after.kind in _CLOSES)


_ENDING = frozenset(".!?\n")


def _second_turn(elements: list[Element], i: int, verb: Verb) -> bool:
    """Whether "left" or "right" stands alone after "then", "and" or a comma."""
    if getattr(elements[i], "low", "") not in _SIDES:
        return False
    if verb.sense not in _STEERED or verb.passive:
        return False
    before, after = word_at(elements, i - 1) if i else None, word_at(elements, i + 1)
    if getattr(elements[i], "kind", "") != "adv" or before is None:
        return False
    if not (before.kind == "conj" or before.low in (",", "then", "finally", "again")):
        return False
    if i + 1 < len(elements) and after is None:
        return False
    if after is None or after.kind in ("punct", "conj") or after.low in ("then", "again"):
        return True
    return after.low in ("at", "into", "onto", "after", "by") or after.amount is not None


def _goes_at(elements: list[Element], i: int) -> bool:
    """ "The van does 36 km/h", "the yacht makes six knots": a speed is the object."""
    verb, speed = elements[i], word_at(elements, i + 1)
    assert isinstance(verb, Verb)
    if speed is None or speed.amount is None or speed.amount.dimension != "speed" or verb.passive:
        return False
    subject = elements[i - 1] if i else None
    if verb.sense == "be":
        return verb.auxiliary in ("does", "do", "did") and isinstance(subject, Mention)
    return verb.lemma in _GOING and verb.sense in ("noop", "cause", "be")
