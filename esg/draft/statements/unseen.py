"""Words for what no scene of solid bodies shows: fluids, light and weather, the camera."""

from __future__ import annotations

from collections.abc import Iterator

from esg.draft import lexicon as lex
from esg.draft.discourse.record import Discourse
from esg.draft.text.elements import Mention
from esg.lexicon.senses import no_things

_KINDS = (
    (lex.word_set("unseen fluids"), "fluids are not simulated"),
    (lex.word_set("unseen light and weather"), "light and weather are not simulated"),
    (lex.word_set("unseen views"), "the camera and the style of the picture are not part of it"),
)


_PLAIN = lex.word_set("adverbs of no picture")
NO_MANNER = "manner is not simulated"


def manner(word: str) -> bool:
    """Whether an adverb says how something looks or goes, and not when, whether or how much."""
    return (word.endswith("ly") and word not in _PLAIN) or word in ("sideways", "aside", "askew")


_CLASSES = {
    "nothing": "no solid thing or motion stands for it",
    "substance": "substances are not simulated",
    "body": "parts of bodies do not move by themselves",
}
_UNDERSTOOD = lex.ATTRIBUTES | lex.word_set("understood without a thing")


def unseen(d: Discourse) -> Iterator[tuple[Mention, str]]:
    """Noun phrases that became no object, with what the scene lacks of them."""
    for m in d.mentions:
        if m.entities or d.world.resolved.get(id(m)) or m.amounts or m.pronoun:
            continue
        found = next(
            (why for words, why in _KINDS if {m.head, lex.singular(m.head)[0]} & words), ""
        )
        if not found and m.noun is None and not m.part and m.head not in _UNDERSTOOD:
            found = _CLASSES.get(no_things().get(lex.singular(m.head)[0], ""), "")
        if found:
            yield m, found
