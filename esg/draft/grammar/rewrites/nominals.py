"""Nouns that name an event become verbs: "before the collision with a cow" is "before hitting"."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.impacts import name_impacts
from esg.draft.grammar.rewrites.light_verbs import as_verb, blow_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_HITS = lex.word_set("hits (nominals)")
_BEFORE = lex.word_set("before")
RETOLD_NOUNS = lex.word_set("retold nouns")
_GOES_ON = lex.word_set("goes on")
_BACK = lex.word_set("back")
_FROM = lex.word_set("from")
_NO_BLOWS = lex.word_set("no blows")
_HAPPEN = lex.word_set("happen")
_SUBORDINATE = {"before": "before", "until": "until"}


def verbalize(elements: list[Element]) -> list[Element]:
    """Rewrites nominal collisions that name what is hit; all others stay nouns.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.

    Returns:
        The elements; "before|after|upon the collision with X" becomes a gerund, and "the impact of
        A on B" a clause of its own in front of what it does.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        used = _referred_back(elements, i, out) or _between(elements, i, out)
        used = used or _avoided(elements, i, out) or _takes_place(elements, i, out)
        used = used or _compared(elements, i, out) or _after_a_blow(elements, i, out)
        used = used or _there_is(elements, i, out) or name_impacts(elements, i, out)
        if used:
            i += used
            continue
        if isinstance(e, Mention) and e.attribute and e.head in _HITS and e.part == "":
            link = _word(elements, i + 1)
            previous = out[-1] if out else None
            met = elements[i + 2] if i + 2 < len(elements) else None
            if (
                link is not None
                and link.low in ("with", "against", "into")
                and isinstance(met, Mention)
                and isinstance(previous, Word)
                and previous.low in _BEFORE
            ):
                sub = _SUBORDINATE.get(previous.low, "after")
                out[-1] = Word(previous.start, previous.end, "sub", sub)
                out.append(_hit(e, "ing"))
                i += 1
                continue
            if (
                link is not None
                and link.low == "of"
                and isinstance(met, Mention)
                and (on := _word(elements, i + 3)) is not None
                and on.low in ("on", "with", "against")
                and i + 4 < len(elements)
                and isinstance(elements[i + 4], Mention)
                and (previous is None or (isinstance(previous, Word) and previous.low in ".;,"))
            ):
                out += [met, _hit(e, "s"), on, elements[i + 4]]
                i += 5
                if i < len(elements) and isinstance(elements[i], Verb):
                    start = elements[i].start
                    out.append(Word(start, start, "conj", "and"))
                continue
        out.append(e)
        i += 1
    return out


def _referred_back(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "because of that bump", "3 seconds after this collision", "in falling": told before."""
    e = elements[i]
    if not isinstance(e, Word) or e.low not in _BACK or e.kind not in ("prep", "sub"):
        return 0
    noun = elements[i + 1] if i + 1 < len(elements) else None
    after = elements[i + 2] if i + 2 < len(elements) else None
    if isinstance(noun, Verb) and noun.form == "ing" and e.low in ("in", "on", "by"):
        starts = not out or (isinstance(out[-1], Word) and out[-1].low in ".;!?,")
        comma = isinstance(after, Word) and after.low == ","
        if starts and comma and noun.sense in ("fall", "topple", "land", "bounce"):
            out.append(Word(e.start, noun.end, "adv", "thereby"))
            return 3
        return 0
    if not isinstance(noun, Mention) or noun.head not in RETOLD_NOUNS or noun.noun is not None:
        return 0
    if noun.determiner not in ("the", "this", "that", "its") and e.low not in ("upon", "after"):
        return 0
    if isinstance(after, Word) and after.kind == "prep" and after.low in _GOES_ON:
        return 0  # "after the collision with a cow" says whom
    previous = out[-1] if out else None
    timed = isinstance(previous, Word) and previous.amount is not None and e.low == "after"
    if not timed and e.low in ("on", "with", "by", "from", "in") and noun.determiner == "its":
        return 0
    if _is_the_first(noun, out) and not timed:
        they = Mention(e.start, e.start, pronoun="they", text="they")
        conj = Word(e.start, e.start, "conj", "and")
        out += [they, _hit(replace(noun, start=e.start, end=e.start), "s"), conj]
    out.append(Word(e.start, noun.end, "adv", "later" if timed else "then"))
    comma = isinstance(after, Word) and after.low == ","
    return 3 if comma and not timed else 2


def _is_the_first(noun: Mention, out: list[Element]) -> bool:
    """ "Two cars drive toward each other. After the crash ...": which is told only by its noun."""
    meet = any(isinstance(x, Word) and x.low == "each other" for x in out)
    told = any(isinstance(x, Verb) and x.sense in ("hit", "knock", "miss", "stop") for x in out)
    return noun.head in _HITS and meet and not told


def _named_hit(parts: list[Element]) -> list[Element]:
    """The two things and their "and" of "collision between A and B", or nothing."""
    if len(parts) < 5:
        return []
    noun, link, one, conj, other = parts
    if not (isinstance(noun, Mention) and noun.attribute and noun.head in _HITS):
        return []
    if not (isinstance(link, Word) and link.low == "between" and isinstance(one, Mention)):
        return []
    if not (isinstance(conj, Word) and conj.low == "and" and isinstance(other, Mention)):
        return []
    return [one, conj, other]


def _between(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "The collision between A and B happens at 3 s": A and B collide at 3 s."""
    named = _named_hit(elements[i : i + 5])
    verb = elements[i + 5] if i + 5 < len(elements) else None
    if not (named and isinstance(verb, Verb) and verb.lemma in _HAPPEN):
        return 0
    place = elements[i + 6] if i + 6 < len(elements) else None
    taking = isinstance(place, Mention) and place.head == "place"
    out += [*named, Verb(elements[i].start, elements[i].end, "collide", "hit", "s")]
    end = place.end if isinstance(place, Mention) and taking else verb.end
    out.append(Word(verb.start, end, "adv", "indeed"))
    return 7 if taking else 6


def _after_a_blow(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "falls because of a collision with a cart", "after a bump from a dog": (being) hit by it."""
    prep = elements[i]
    if not isinstance(prep, Word) or prep.low not in _FROM or prep.kind not in ("prep", "sub"):
        return 0
    noun = elements[i + 1] if i + 1 < len(elements) else None
    head, used = getattr(noun, "head", ""), 1
    if not (isinstance(noun, Mention) and head in RETOLD_NOUNS and noun.noun is None):
        head, used = blow_at(elements, i + 1)
    link = _word(elements, i + 1 + used)
    met = elements[i + 2 + used] if i + 2 + used < len(elements) else None
    if not head or head in _NO_BLOWS or link is None or not isinstance(met, Mention):
        return 0
    if met.attribute or getattr(noun, "determiner", "") in ("this", "that"):
        return 0
    passive = link.low in ("by", "from", "of")
    if not passive and (link.low not in ("with", "against", "into") or head not in _HITS):
        return 0
    out.append(Word(prep.start, prep.end, "sub", "after"))
    end = elements[i + used].end
    verb = Verb(elements[i + 1].start, end, "hit", "hit", "pp" if passive else "ing")
    verb = as_verb(verb, head) if passive and head not in _HITS else verb
    verb.passive = passive
    out += [verb, Word(link.start, link.end, "prep", "by"), met] if passive else [verb, met]
    return 3 + used


def _there_is(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "There is a collision between a ball and a vase": they collide."""
    there, be = _word(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    named = _named_hit(elements[i + 2 : i + 7])
    if there is None or there.low != "there" or not named:
        return 0
    if not isinstance(be, Verb) or be.sense != "be" or be.negated or be.modal:
        return 0
    out += [*named, Verb(there.start, elements[i + 2].end, "collide", "hit", "s")]
    return 7


def _takes_place(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "The second collision takes place 2 s after the first one": something told, and when."""
    verb, place = elements[i], elements[i + 1] if i + 1 < len(elements) else None
    noun = out[-1] if out else None
    if not (isinstance(verb, Verb) and verb.lemma in _HAPPEN and isinstance(noun, Mention)):
        return 0
    if not noun.attribute or noun.head not in RETOLD_NOUNS or noun.noun is not None:
        return 0
    used = 1
    if verb.lemma == "take":
        if place is None or "place" not in (getattr(place, "head", ""), getattr(place, "low", "")):
            return 0
        verb.end, verb.lemma, verb.sense, used = place.end, "happen", "noop", 2
    out.append(verb)
    rest: list[Element] = []
    for e in elements[i + used : i + used + 4]:
        rest.append(e)
        if isinstance(e, Word) and e.low in ("and", "but", ".", ";"):
            break
        one = isinstance(e, Mention) and e.pronoun in ("one", "other") and bool(e.adjectives)
        if isinstance(e, Mention) and (one or e.head in RETOLD_NOUNS):
            e.pronoun, e.head, e.attribute = "", e.head or noun.head, True  # "after the first one"
            out += rest
            return used + len(rest)
    return used


def _compared(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "twice as heavy as a barrel": what it is compared with is no subject of the next verb."""
    parts = elements[i : i + 4]
    if len(parts) < 4 or not all(isinstance(e, Word) for e in parts[:3]):
        return 0
    if [getattr(parts[k], "low", "") for k in (0, 2)] != ["as", "as"]:
        return 0
    if not isinstance(parts[3], Mention) or parts[3].attribute:
        return 0
    out.append(Word(parts[0].start, parts[2].end, "prep", "than"))
    return 3


def _avoided(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "avoids a collision with the bus": avoids the bus."""
    parts = elements[i : i + 4]
    if len(parts) < 4:
        return 0
    verb, noun, link, met = parts
    if not (isinstance(verb, Verb) and verb.sense == "avoid" and isinstance(noun, Mention)):
        return 0
    if noun.head not in _HITS or not (isinstance(link, Word) and link.low == "with"):
        return 0
    if not isinstance(met, Mention):
        return 0
    verb.end = noun.end
    out += [verb, met]
    return 4


def _word(elements: list[Element], i: int) -> Word | None:
    e = elements[i] if i < len(elements) else None
    return e if isinstance(e, Word) and e.kind in ("prep", "adv") else None


def _hit(m: Mention, form: str) -> Verb:
    return Verb(m.start, m.end, "hit", "hit", form)
