"""What a verb leaves open or shut: "pushes the door open", "slams shut" is one verb."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.text.elements import Element, Mention, Verb, Word

_RESULTS = lex.word_set("left open or shut")


def join_results(elements: list[Element], text: str) -> list[Element]:
    """Notes with a verb what it leaves its object in, which then stands there as an adverb.

    Args:
        elements: Of a prompt.
        text: The prompt.
    """
    out: list[Element] = []
    for e in elements:
        led = _leading(out) if isinstance(e, Verb) else None
        if led is not None and text[e.start : e.end].lower() in _RESULTS:
            result = text[e.start : e.end].lower()
            led.extra = {**led.extra, "result": result}
            out.append(Word(e.start, e.end, "adv", result))
        else:
            out.append(e)
    return out


def _leading(before: list[Element]) -> Verb | None:
    """The verb of the same clause, with nothing but its object and adverbs after it."""
    for e in reversed(before):
        if isinstance(e, Verb):
            return None if e.sense in ("be", "have") else e
        if not isinstance(e, Mention) and e.kind != "adv":
            return None
    return None
