"""Clauses that begin with a place or a direction: "into the net flies the ball"."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import (
    STOPS,
    breaks,
    finite,
    is_prep,
    is_word,
    mention_at,
    starts_clause,
    verb_at,
    word_at,
)
from esg.draft.text.elements import Element, Mention, Verb, Word, element_at
from esg.draft.verbphrases import particle_sense

_MOVING = lex.word_set("moving (reorder)")
_INTRANSITIVE = lex.word_set("intransitive")
_PARTICLES = lex.word_set("particles (reorder)")
_DIRECTIONS = _PARTICLES | lex.word_set("directions")
_PLACES = lex.word_set("places (reorder)")
_REFLEXIVE = lex.word_set("reflexive")
_THERE = frozenset({"there"})
_NEW = frozenset({"a", "an", "one", "another", "some", ""})
_DOING = frozenset({"do", "does", "did"})


def straighten(elements: list[Element]) -> list[Element]:
    """Makes subjects precede their verbs.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        used = _inverted(elements, i, out) if starts_clause(elements, i, out) else 0
        if not used:
            out.append(elements[i])
        i += used or 1
    return out


def _inverted(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Down comes the lamp", "into the net flies the ball", "on the shelf stands a mug"."""
    j = _lead(elements, i)
    readers = (_is_there, _place_alone, _place_first)
    if used := next((n for read in readers if (n := read(elements, i, j, out))), 0):
        return used
    verb = finite(elements[j]) if i < j < len(elements) else None
    k = j + 1
    while (small := word_at(elements, k)) is not None and small.kind == "adv":
        k += 1
    subject = mention_at(elements, k)
    if verb is None or subject is None or subject.attribute or subject.pronoun in _REFLEXIVE:
        return 0
    joined = bool(out) and isinstance(out[-1], Word) and out[-1].kind == "conj"
    one = not (subject.plural or subject.coordinated or subject.count)
    lead = elements[i:j]
    if (verb.form == "base" and (one or joined)) or not _goes_or_stands(verb, lead):
        return 0
    if verb.lemma in _INTRANSITIVE:
        verb = replace(verb, sense="own")
    bare = not any(isinstance(e, Mention) for e in lead)
    if bare:
        verb, lead = _with_particle(verb, lead)
    after = [*elements[j + 1 : k]]
    out += [subject, verb, *after, *lead] if joined or bare else [*lead, subject, verb, *after]
    return k + 1 - i


def _is_there(elements: list[Element], i: int, j: int, out: list[Element]) -> int:
    """ ", and on the table there is a hat": the hat is on the table, and nothing told before."""
    verb, what = verb_at(elements, j), mention_at(elements, j + 1)
    place = [e for e in elements[i:j] if not is_word(e, *_THERE)]
    there = len(place) < j - i
    joined = bool(out) and not is_word(out[-1], *STOPS[:2], "heading")
    told = (
        joined and len(place) > 1 and is_word(place[0], *_PLACES, "on top of", "in the middle of")
    )
    if not told or verb is None or what is None or verb.sense != "be" or verb.negated:
        return 0
    new = what.determiner in _NEW and not (what.pronoun or what.attribute)
    if not new or verb.auxiliary in _DOING or not (there or breaks(elements, j + 2, out)):
        return 0
    k = next(k for k in range(j + 2, len(elements) + 1) if breaks(elements, k, out))
    small = word_at(elements, k)
    relative = small is not None and small.kind == "rel"
    if relative and verb_at(elements, k + 1) is None:
        return 0
    out += [what, *elements[j + 2 : k], verb, *place]
    if small is None or not relative:
        return k - i
    out.append(replace(small, kind="conj", low="and"))  # "there is a ball that spins"
    return k + 1 - i


def _place_alone(elements: list[Element], i: int, j: int, out: list[Element]) -> int:
    """ "There is a red box, and next to it a ball": the ball is there, too."""
    what = mention_at(elements, j)
    if not i + 1 < j or what is None or not is_word(elements[i], *_PLACES, "on top of"):
        return 0
    told = next((e for e in reversed(out) if isinstance(e, Verb) or is_word(e, *STOPS[:1])), None)
    rests = isinstance(told, Verb) and told.sense in ("be", "posture") and not told.negated
    place = mention_at(elements, i + 1)
    new = what.determiner in ("a", "an", "one", "another") or (what.count or 0) > 1
    if not rests or not new or what.attribute or what.pronoun or not breaks(elements, j + 1, out):
        return 0
    if place is None or (place.attribute and not place.part):
        return 0
    is_ = Verb(what.end, what.end, "be", "be", "s", auxiliary="is")
    out += [what, is_, *elements[i:j]]
    return j + 1 - i


def _place_first(elements: list[Element], i: int, j: int, out: list[Element]) -> int:
    """ "A ball lies before a box, and behind the box a cone rolls": the cone is behind it."""
    who, verb = mention_at(elements, j), finite(element_at(elements, j + 1))
    last = out[-1] if out else None
    joined = isinstance(last, Word) and last.kind == "conj"
    if not joined or who is None or verb is None or not is_word(elements[i], *_PLACES):
        return 0
    place = mention_at(elements, i + 1)
    if place is None or place.attribute or not i + 1 < j or who.attribute:
        return 0
    k = next(k for k in range(j + 2, len(elements) + 1) if breaks(elements, k, out))
    out += [*elements[j:k], *elements[i:j]]
    return k - i


def _goes_or_stands(verb: Verb, lead: list[Element]) -> bool:
    """Whether what opens the clause says where the verb leads, or where something stands."""
    lows = {e.low for e in lead if isinstance(e, Word)}
    if verb.sense == "posture" and lows & _PLACES:
        return True
    return (verb.sense in _MOVING or verb.lemma in _INTRANSITIVE) and bool(lows & _DIRECTIONS)


def _lead(elements: list[Element], i: int) -> int:
    """End of the adverbs and prepositional phrases that open a clause at i."""
    j = i
    while j < len(elements):
        e = elements[j]
        small = isinstance(e, Word) and (e.kind in ("adv", "prep", "to", "qty") or e.low == "-")
        if not small and not (isinstance(e, Mention) and j > i and is_prep(elements[j - 1])):
            break
        j += 1
    return j


def _with_particle(verb: Verb, lead: list[Element]) -> tuple[Verb, list[Element]]:
    """The verb as its particle makes it ("over goes": topples), and what is left of the lead."""
    particle = next((e for e in lead if isinstance(e, Word) and e.low in _PARTICLES), None)
    found = particle_sense(verb.lemma, particle.low) if particle is not None else None
    if found is None and verb.lemma == "come" and particle is not None and particle.low == "down":
        found = "fall", {"particle": "down"}
    if found is None:
        return verb, lead
    sense, extra = found
    changed = replace(verb, sense=sense, extra={**verb.extra, **extra})
    return changed, [e for e in lead if e is not particle]
