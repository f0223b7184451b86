"""Clothes on people: "a woman in a red dress", "a boy wearing a cap" name no body of its own."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.text.elements import Element, Mention, Verb, Word

_DRESSED = lex.word_set("dressed")
_SERVING = lex.word_set("serving")


def undress(elements: list[Element]) -> list[Element]:
    """Makes what somebody wears a part of the phrase that names them.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.

    Returns:
        The elements without the clothes; those that the prompt names again (that fall off, are
        thrown) stay things of their own.
    """
    heads = [e.head for e in elements if isinstance(e, Mention)]
    if not any(_garment(e) or (isinstance(e, Mention) and e.head == "glass") for e in elements):
        return elements
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        out.append(e)
        i += 1
        if isinstance(e, Verb) and e.lemma in _DRESSED:
            for worn in elements[i : i + 1]:
                if isinstance(worn, Mention) and _garment(worn) and heads.count(worn.head) == 1:
                    worn.attribute = True  # "A woman wears a hat and hits a pole"
        if not isinstance(e, Mention) or not _somebody(e):
            continue
        end = _worn(elements, i, e, heads)
        if end > i:
            e.end = elements[end - 1].end
            i = end
    return out


def _somebody(m: Mention) -> bool:
    """Whether a phrase names people."""
    if m.attribute or m.letters:
        return False
    return (m.noun is not None and m.noun.kind == "person") or m.pronoun in ("one", "ones")


def _garment(e: Element) -> bool:
    """Whether a phrase names clothes."""
    if not isinstance(e, Mention) or e.amounts or e.possessor is not None or not e.head:
        return False
    return "-".join(e.head.split()) in lex.GARMENTS or e.head.split()[-1] in lex.GARMENTS


def _spectacles(e: Element, owner: Mention, worn: bool) -> bool:
    """ "a woman with glasses": not what a waiter carries."""
    plain = isinstance(e, Mention) and e.head == "glass" and e.plural and not e.count
    return plain and not e.determiner and (worn or owner.head not in _SERVING)


def _worn(elements: list[Element], i: int, owner: Mention, heads: list[str]) -> int:
    """Past what `owner` wears ("in a coat and a hat", ", wearing gloves,"); `i` if nothing."""
    k = i
    comma = _low(elements, k) == ","
    k += comma
    k += getattr(elements[k] if k < len(elements) else None, "kind", "") == "rel"
    verb = elements[k] if k < len(elements) else None
    wears = isinstance(verb, Verb) and verb.lemma in _DRESSED and not verb.negated
    if wears and isinstance(verb, Verb) and verb.form in ("s", "past", "base") and k == i:
        return i  # the main verb
    k += wears
    if _low(elements, k) in ("in", "with"):
        k += 1
    elif not wears:
        return i
    end = i
    while k < len(elements):
        m = elements[k]
        named = isinstance(m, Mention) and (_garment(m) or _spectacles(m, owner, wears))
        if not named or not isinstance(m, Mention) or heads.count(m.head) > 1:
            break
        end = k = k + 1
        more = k
        while _low(elements, more) in (",", "and"):
            more += 1
        if more == k:
            break
        k = more
    if end > i and comma and _low(elements, end) == ",":
        end += 1
    return end


def _low(elements: list[Element], k: int) -> str:
    e = elements[k] if 0 <= k < len(elements) else None
    return e.low if isinstance(e, Word) else ""
