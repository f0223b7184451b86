"""Appositions and words that stand for a noun told before: "a ball, a red one,", "a second one".

The elements come out with one noun phrase for one thing: what an apposition adds goes to the noun
it explains, and "one" becomes the noun it stands for, so that all later readings see plain phrases.
"""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import finite, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.verbphrases import verb_readings

_THINGS = lex.word_set("things")
_ANYTHING = lex.word_set("anything (appositions)")
_OF_SEVERAL = (" of the two", " of the three", " of the pair", " of the lot", " of them", " of all")
_OPENS = ".;:!?\n—–-("
_TOO = lex.word_set("too")


def appose(elements: list[Element]) -> list[Element]:
    """Joins appositions to their nouns and gives "one" its noun.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.

    Returns:
        The elements without what was joined.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        used = (
            _named_one_by_one(elements, i, out)
            or _joined(elements, i, out)
            or _likewise(elements, i, out)
        )
        used = used or _neither(elements, i, out)
        if used:
            i += used
            continue
        if isinstance(e, Mention):
            of = word_at(elements, i + 1)
            if of is None or of.low != "of":
                _stands_for(e, out)
        out.append(e)
        i += 1
    return out


def _named_one_by_one(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "two objects: a car and a fence", "two balls, a red one and a blue one": what they are."""
    all_, mark = elements[i], word_at(elements, i + 1)
    if not isinstance(all_, Mention) or all_.head not in _ANYTHING or not all_.plural:
        return 0
    if mark is not None and mark.low == "here":  # "Two things are here, a car and a fence"
        return 0
    if mark is None or mark.low not in (":", ",", "—", "–", "-") or all_.pronoun:
        return 0
    named, k = 0, i + 2
    while k < len(elements):
        e = elements[k]
        if isinstance(e, Mention) and e.determiner in ("a", "an", "one") and not e.pronoun:
            named += 1
        elif not (isinstance(e, Word) and (e.low == "," or e.kind == "conj")):
            break
        k += 1
    if named < 2 or (all_.count is not None and all_.count != named):
        return 0
    out.append(Word(all_.start, mark.end, "adv", "indeed"))
    return 2


def _joined(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "a ball, a red one, rolls", "Rex, a dog, runs": the noun alone, with what is added."""
    noun, comma = elements[i], word_at(elements, i + 1)
    added, after = elements[i + 2] if i + 2 < len(elements) else None, word_at(elements, i + 3)
    if not isinstance(noun, Mention) or not isinstance(added, Mention):
        return 0
    if comma is None or comma.low not in ",(–—" or noun.attribute or noun.pronoun:
        return 0
    if after is not None and after.low == "of" and not added.known:
        whole = elements[i + 4] if i + 4 < len(elements) else None
        close = word_at(elements, i + 5)
        of_two = (
            isinstance(whole, Mention) and whole.pronoun == "ones" and whole.determiner == "the"
        )
        if (
            of_two
            and close is not None
            and close.low in ",)"
            and added.head.endswith(("er", "est"))
        ):
            out += [noun, Word(added.start, added.end, "adv", "indeed")]
            return 6  # "a tram, the older of the two,"
    if after is None or after.low not in ",.;)–—" or noun.coordinated or added.possessor:
        return 0
    following = elements[i + 4] if i + 4 < len(elements) else None
    several = any(added.text.lower().endswith(x) for x in _OF_SEVERAL)
    several = several and (added.determiner == "the" or added.pronoun != "")
    one = added.pronoun == "one" and added.determiner in ("a", "an") and bool(added.adjectives)
    one = one and not set(added.adjectives) & (lex.ORDINALS.keys() | {"other", "next"})
    vague = added.head in _THINGS and added.determiner in ("a", "an") and bool(added.adjectives)
    same = added.head == noun.head and added.determiner in ("a", "an") and bool(added.adjectives)
    vague = (vague and _may_be(noun, added)) or (same and after.low == ",")
    plain = (one or vague) and not noun.plural
    if several:
        out += [noun, Word(added.start, added.end, "adv", "indeed")]
    elif plain or _explains(noun, added, out, after, following):
        _take_over(noun, added)
        out.append(noun)
    else:
        return 0
    closes = after.low in ",)–—"
    goes_on = isinstance(following, Verb) or _small(following)
    return 4 if closes and goes_on else 3


def _may_be(noun: Mention, added: Mention) -> bool:
    """Whether "a heavy machine" can be said of the noun: a kind of its own is another thing."""
    return added.noun is None or noun.noun is None or added.noun.kind == noun.noun.kind


def _small(e: Element | None) -> bool:
    return isinstance(e, Word) and e.kind in ("prep", "to", "adv")


def _explains(
    noun: Mention, added: Mention, out: list[Element], after: Word, following: Element | None
) -> bool:
    """ "The car, a Fiat, hits": a second phrase between commas, and a verb for one of them."""
    verb = finite(following)
    if after.low != "," or verb is None or verb.form == "base" or added.pronoun:
        return False
    if noun.plural or added.plural or added.attribute or (noun.count or 1) > 1:
        return False
    before = out[-1] if out else None
    if before is not None and not (isinstance(before, Word) and before.low in _OPENS):
        return False
    named = not noun.determiner and noun.head not in lex.nouns()
    alike = noun.noun is not None and added.noun is not None and added.noun.kind == noun.noun.kind
    return added.determiner in ("a", "an") and (named or not added.known or alike)


def _take_over(noun: Mention, added: Mention) -> None:
    noun.end = added.end
    noun.adjectives += [a for a in added.adjectives if a not in noun.adjectives]
    noun.amounts += added.amounts
    unknown = noun.noun is None or noun.head not in lex.nouns()
    if unknown and added.noun is not None:
        noun.noun, noun.known = added.noun, True


def _stands_for(m: Mention, out: list[Element]) -> None:
    """ "a standing one", "a third": one more of what was named before."""
    if m.pronoun != "one" or m.determiner not in ("a", "an") or not m.adjectives:
        return
    if "other" in m.adjectives or "next" in m.adjectives or m.coordinated:
        return
    named = [
        e
        for e in out
        if isinstance(e, Mention) and not (e.attribute or e.pronoun or not e.head or e.letters)
    ]
    if not named:
        return
    like = named[-1]
    ordinal = next((lex.ORDINALS[a] for a in m.adjectives if a in lex.ORDINALS), None)
    if ordinal is not None:
        if like.noun is not None and "structural" in like.noun.traits and len(named) > 1:
            like = named[-2]
        if any((e.count or 1) > ordinal and e.head == like.head for e in named):
            return  # one of those told before
        same = [e for e in named if e.head == like.head]
        if not like.plural and ordinal > 1 and len(same) < 2:
            return
    elif any(e.plural or (e.count or 1) > 1 for e in named):
        return
    if like.noun is not None and like.noun.kind in ("region", "ground"):
        return
    m.pronoun, m.head, m.noun, m.known = "", like.head, like.noun, like.known
    m.text = f"{' '.join(a for a in m.adjectives if a[0] != '@')} {like.head}"


def _likewise(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "and so does a second one", "and a cup does too": the same again, of another thing."""
    so, does = word_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    thing = elements[i + 2] if i + 2 < len(elements) else None
    if (
        so is not None
        and so.low in ("so", "likewise")
        and _does(does)
        and isinstance(thing, Mention)
    ):
        end = word_at(elements, i + 3)
        if end is None or end.kind in ("punct", "conj", "sub"):
            _stands_for(thing, out)
            assert isinstance(does, Verb)
            out += [thing, _be(does), _same(so)]
            return 3
    thing, does, too = elements[i], does, word_at(elements, i + 2)
    if isinstance(thing, Mention) and _does(does) and too is not None and too.low in _TOO:
        end = word_at(elements, i + 3)
        if end is None or end.kind in ("punct", "conj", "sub"):
            _stands_for(thing, out)
            assert isinstance(does, Verb)
            out += [thing, _be(does), _same(too)]
            return 3
    return 0


def _does(e: Element | None) -> bool:
    return isinstance(e, Verb) and e.sense == "be" and e.auxiliary in ("does", "do", "did")


def _be(v: Verb) -> Verb:
    return Verb(v.start, v.end, "be", "be", "s", auxiliary=v.auxiliary)


def _same(w: Word) -> Mention:
    return Mention(w.start, w.end, adjectives=["same"], attribute=True, text="the same")


def _neither(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Neither car stops", "neither of the balls hits it": both, denied."""
    e = elements[i]
    opens = not out or (isinstance(out[-1], Word) and out[-1].kind in ("punct", "conj", "sub"))
    if isinstance(e, Mention) and e.determiner == "neither" and not e.pronoun:
        verb = elements[i + 1] if i + 1 < len(elements) else None
        if isinstance(verb, Verb) and not verb.infinitive:
            verb.negated = not verb.negated
            e.determiner, e.plural, e.count = "both", True, 2
            out.append(e)
            return 1
        return 0
    if not isinstance(e, Word) or e.low != "neither" or not opens:
        return 0
    of, things = word_at(elements, i + 1), elements[i + 2] if i + 2 < len(elements) else None
    verb = elements[i + 3] if i + 3 < len(elements) else None
    if of is not None and of.low == "of" and isinstance(things, Mention) and isinstance(verb, Verb):
        verb.negated = not verb.negated
        things.start = e.start
        out.append(things)
        return 3
    if of is not None and of.kind == "unknown" and (forms := verb_readings(of.low)):
        reading = next((r for r in forms if r.form == "s"), forms[0])
        both = Mention(e.start, e.end, pronoun="both", determiner="both", text=e.low)
        out += [both, Verb(of.start, of.end, reading.lemma, reading.sense, "s", negated=True)]
        return 2
    return 0
