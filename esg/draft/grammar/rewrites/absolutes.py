"""Participles with a subject of their own: ", the last one hitting a dog", "with the lid off"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.text.elements import Element, Mention, Verb, Word

_STATES = lex.word_set("states (absolutes)")
_OF_WHAT_IS_THERE = lex.word_set("of what is there")
_ENDS = frozenset(".;!?:\n")
_CLOSING = lex.word_set("closing (absolutes)")


def absolutes(elements: list[Element]) -> list[Element]:
    """Turns an absolute construction into a clause of its own.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.

    Returns:
        The elements: "the car brakes, its trailer hitting a wall" has "and its trailer hits" in
        place of the participle. A participle after a mere list ("a dog, a man carrying a box"), or
        one whose noun has a finite verb of its own, stays.
    """
    elements = _partitive(elements)
    out: list[Element] = []
    told = False
    for i, e in enumerate(elements):
        if isinstance(e, Word) and e.low in _ENDS:
            told = False
        if isinstance(e, Verb) and e.form != "ing" and not e.infinitive:
            told = told or e.sense not in _STATES
        if isinstance(e, Mention) and told and (verb := _participle_of(elements, i, out)):
            before = out[-1]
            if isinstance(before, Word) and before.kind == "prep":
                out[-1] = Word(before.start, before.end, "conj", "and")
            else:
                out.append(Word(before.end, before.end, "conj", "and"))
            verb.form = "s"
            verb.extra = {**verb.extra, "absolute": "1"}
        out.append(e)
    return out


def _participle_of(elements: list[Element], i: int, out: list[Element]) -> Verb | None:
    """The participle that follows a noun phrase after a comma or "with", as its only verb."""
    m, before = elements[i], out[-1] if out else None
    assert isinstance(m, Mention)
    if not isinstance(before, Word) or m.attribute or before.low not in (",", "with"):
        return None
    here = bool(m.pronoun in ("one", "both")) or m.determiner in _OF_WHAT_IS_THERE
    if not here and before.low != "with":
        return None
    k = i + 1
    while k < len(elements) and isinstance(elements[k], Word) and elements[k].kind == "adv":
        k += 1
    verb = elements[k] if k < len(elements) else None
    if not isinstance(verb, Verb) or verb.form != "ing" or verb.auxiliary or verb.sense in _STATES:
        return None
    for e in elements[k + 1 :]:
        if isinstance(e, Word) and (e.low in _ENDS or e.kind in _CLOSING):
            return verb
        if isinstance(e, Verb) and e.form in ("s", "past") and not e.infinitive:
            return None  # "..., the car coming from the left hits it"
    return verb


def _partitive(elements: list[Element]) -> list[Element]:
    """ ", one of which hits a dog": "and one hits a dog"; "neither ... nor ... yields": denied."""
    out: list[Element] = []
    denied = False
    for i, e in enumerate(elements):
        low = e.low if isinstance(e, Word) else ""
        of, one = (out[-1], out[-2]) if len(out) > 1 else (None, None)
        whole = low in ("which", "whom") and isinstance(of, Word) and of.low == "of"
        if whole and isinstance(one, Word) and one.low in ("one", "both", "some"):
            one = Mention(one.start, one.end, pronoun=one.low, text=one.low)
        if whole and isinstance(one, Mention) and one.pronoun:
            out[-2:] = [Word(one.start, one.start, "conj", "and"), one]
            continue
        nor = any(isinstance(x, Word) and x.low == "nor" for x in elements[i + 1 : i + 4])
        denied = (denied or (low == "neither" and nor)) and low not in _ENDS | {","}
        if denied and isinstance(e, Verb):
            e.negated, denied = True, False
        out.append(e)
    return out
