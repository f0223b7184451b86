"""Nouns that name an event become verbs: "before the collision with a cow" is "before hitting"."""

from __future__ import annotations

from esg.draft.elements import Element, Mention, Verb, Word

_HITS = frozenset({"collision", "impact", "crash", "hit", "strike", "contact", "smash"})
_BEFORE = frozenset({"before", "after", "until", "upon", "on", "following"})
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


def _word(elements: list[Element], i: int) -> Word | None:
    e = elements[i] if i < len(elements) else None
    return e if isinstance(e, Word) and e.kind in ("prep", "adv") else None


def _hit(m: Mention, form: str) -> Verb:
    return Verb(m.start, m.end, "hit", "hit", form)
