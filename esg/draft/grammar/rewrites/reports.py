"""Who tells it is no part of the scene: "The witness states that a van hit a dog." """

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import finite_ahead
from esg.draft.text.elements import Element, Mention, Verb, Word

_TELLING = lex.word_set("telling (reports)")
_BREAKS = frozenset(".;!?:\n")


def drop_reports(elements: list[Element]) -> list[Element]:
    """Takes "the driver claims that" off the front of a sentence.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.

    Returns:
        The elements; what is told is kept, with a heading in place of who tells it. A report about
        its own teller ("he says that he fell") is kept whole.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        used = _report(elements, i) if not out or _ends(out[-1]) else 0
        if used:
            last = elements[i + used - 1]
            out.append(Word(elements[i].start, last.end, "adv", "heading"))
            i += used
            continue
        out.append(elements[i])
        i += 1
    return out


def _ends(e: Element) -> bool:
    return isinstance(e, Word) and (e.low in _BREAKS or e.low == "heading")


def _tells(text: str) -> bool:
    """Whether a word is a form of a verb of telling."""
    low = text.lower()
    stems = {low, low.removesuffix("s"), low.removesuffix("d"), low.removesuffix("ed")}
    return bool(stems & _TELLING) or low in ("said", "told", "wrote", "testifies", "testified")


def _report(elements: list[Element], i: int) -> int:
    """How many elements from i are a report's "who says that"; 0 if none."""
    who = elements[i]
    if not isinstance(who, Mention) or who.pronoun:
        return 0
    k = i + 1
    verb = elements[k] if k < len(elements) else None
    fused = who.text.lower().split()[-1:]  # "Claimant states that": taken for one noun
    if isinstance(verb, Verb) and not verb.passive and _tells(verb.lemma):
        k += 1
    elif not (fused and _tells(fused[0]) and len(who.text.split()) > 1):
        return 0
    that = k < len(elements) and getattr(elements[k], "low", "") == "that"
    if k == i + 1 and not that:
        return 0
    k += that
    thing = elements[k] if k < len(elements) else None
    if not isinstance(thing, Mention) or thing.pronoun or thing.attribute:
        return 0
    return k - i if finite_ahead(elements, k + 1) else 0
