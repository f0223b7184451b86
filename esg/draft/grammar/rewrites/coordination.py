"""Words that a conjunction leaves out: "the blue and the red ball", "but the white one does"."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import word_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_JOINS = lex.word_set("joins")
_MEASURES = lex.word_set("measures (coordination)")
_TURNING = lex.word_set("turning")
_ENDS = frozenset({".", ",", ";", "!", "?", ":"})
_CLOSING = lex.word_set("closing (coordination)")
_MOUNTS = lex.word_set("mounts")
_TELLING_APART = lex.COLORS.keys() | {"left", "right", "first", "second", "front", "rear"}


def coordinate(elements: list[Element]) -> list[Element]:
    """Supplies nouns, prepositions and verbs that a conjunction leaves out.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.

    Returns:
        The elements with what is understood between them.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        if isinstance(e, Mention):
            _takes_noun(elements, i)
            if _rides(elements, i):
                i += 2  # "the one on the blue bike": the bike
                continue
            if _second_measure(elements, i):
                out.append(Word(e.start, e.start, "prep", "at"))
            if _each_has(elements, i, out):
                out.pop()  # "two plates, each 25 cm in diameter": "two plates 25 cm in diameter"
                i += 1
                continue
        elif isinstance(e, Verb):
            said = _does_too(elements, i, out)
            if said:
                out += said
                i += 1
                continue
            if _makes_turn(e, word_at(elements, i + 1)):
                e = replace(e, lemma="turn", sense="turn")
        out.append(e)
        i += 1
    return out


def _rides(elements: list[Element], i: int) -> bool:
    """Whether "the one on ..." names who rides or drives something that then acts."""
    m, prep = elements[i], word_at(elements, i + 1)
    mount, verb = (*elements[i + 2 : i + 4], None, None)[:2]
    assert isinstance(m, Mention)
    one = m.pronoun == "one" and m.determiner == "the" and not m.adjectives
    if not one or prep is None or prep.low not in ("on", "in") or not isinstance(mount, Mention):
        return False
    kind = mount.noun.kind if mount.noun is not None else ""
    return kind in _MOUNTS and isinstance(verb, Verb)


def _makes_turn(v: Verb, what: Word | None) -> bool:
    """ "does a quarter turn", "makes a half turn": turns by it."""
    if what is None or what.amount is None or what.amount.dimension != "angle" or v.passive:
        return False
    does = v.sense != "be" or v.auxiliary in ("does", "do", "did")
    return does and v.lemma in _TURNING | {"be"} and "turn" in what.low


def _takes_noun(elements: list[Element], i: int) -> None:
    """ "neither the blue nor the red marble": both are marbles."""
    m, link = elements[i], word_at(elements, i + 1)
    other = elements[i + 2] if i + 2 < len(elements) else None
    assert isinstance(m, Mention)
    if link is None or link.low not in _JOINS or not isinstance(other, Mention):
        return
    side = m.head if m.attribute and m.head in ("left", "right") else ""
    if side and {"left", "right"} & {*other.adjectives} - {side}:
        m.pronoun, m.attribute, m.part, m.adjectives = "one", False, "", [side]
    if m.pronoun != "one" or m.determiner != "the" or "one" in m.text.lower().split():
        return
    if not other.head or other.pronoun or other.plural or other.determiner not in ("the", ""):
        return
    mine, its = {*m.adjectives} & _TELLING_APART, {*other.adjectives} & _TELLING_APART
    if mine and its and mine != its and not other.attribute:
        m.pronoun, m.head, m.noun, m.known = "", other.head, other.noun, other.known
        m.text = f"{m.text} {other.head}"


def _second_measure(elements: list[Element], i: int) -> bool:
    """ "at 20 m/s and an angle of 30 degrees": "and at an angle"."""
    m, link = elements[i], word_at(elements, i - 1)
    amount, prep = word_at(elements, i - 2), word_at(elements, i - 3)
    assert isinstance(m, Mention)
    if i < 3 or not m.attribute or m.head not in _MEASURES or link is None or link.low != "and":
        return False
    return (
        amount is not None
        and amount.amount is not None
        and prep is not None
        and prep.low in ("at", "with")
    )


def _each_has(elements: list[Element], i: int, out: list[Element]) -> bool:
    """ "two plates, each 25 cm in diameter": what each of them measures."""
    m, amount = elements[i], word_at(elements, i + 1)
    comma, things = (out[-1], out[-2]) if len(out) > 1 else (None, None)
    assert isinstance(m, Mention)
    if m.pronoun != "each" or amount is None or amount.amount is None:
        return False
    plural = isinstance(things, Mention) and (things.plural or (things.count or 1) > 1)
    return plural and isinstance(comma, Word) and comma.low == ","


def _does_too(elements: list[Element], i: int, out: list[Element]) -> list[Element]:
    """ "The red ball does not hit the wall, but the blue one does": hits the wall."""
    does = elements[i]
    assert isinstance(does, Verb)
    nxt = word_at(elements, i + 1)
    closes = i + 1 >= len(elements) or (nxt is not None and nxt.low in _ENDS | {"and", "but"})
    if does.sense != "be" or does.auxiliary not in ("does", "do", "did") or not closes:
        return []
    subject = out[-1] if out else None
    if does.negated or not isinstance(subject, Mention):
        return []
    at = next((k for k in range(len(out) - 2, -1, -1) if isinstance(out[k], Verb)), -1)
    verb = out[at] if at >= 0 else None
    if not isinstance(verb, Verb) or verb.passive or verb.sense == "be":
        return []
    neither = any(isinstance(e, Word) and e.low == "neither" for e in out[max(0, at - 6) : at])
    if not (verb.negated or neither):
        return []
    here = does.end
    said: list[Element] = [
        replace(verb, start=does.start, end=here, form="s", negated=False, auxiliary="", modal="")
    ]
    for e in out[at + 1 : -1]:
        if isinstance(e, Verb) or (isinstance(e, Word) and e.kind in _CLOSING):
            break
        if isinstance(e, Mention):
            definite = "the" if e.determiner in ("a", "an") else e.determiner
            said.append(replace(e, start=here, end=here, determiner=definite, entities=[]))
        elif e.kind in ("prep", "to"):
            said.append(replace(e, start=here, end=here))
    return said
