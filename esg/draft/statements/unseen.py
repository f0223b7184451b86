"""Words for what no scene of solid bodies shows: fluids, light and weather, the camera."""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame
from esg.lexicon.senses import no_things

_KINDS = (
    (lex.word_set("unseen fluids"), "fluids are not simulated"),
    (lex.word_set("unseen light and weather"), "light and weather are not simulated"),
    (lex.word_set("unseen views"), "the camera and the style of the picture are not part of it"),
)


_PATTERNS = tuple(
    (re.compile(rf"\b(?:{'|'.join(map(re.escape, sorted(words)))})\b", re.IGNORECASE), why)
    for words, why in _KINDS
)
_CLASSES = {
    "nothing": "no solid thing or motion stands for it",
    "substance": "substances are not simulated",
    "body": "parts of bodies do not move by themselves",
}
_CONTENTS = re.compile(
    rf"\b(?:of|with)\s+(?:\w+\s+)?(?:{'|'.join(map(re.escape, sorted(_KINDS[0][0])))})\b",
    re.IGNORECASE,
)
_MOODS = lex.word_set("unseen attributes")
_UNDERSTOOD = (lex.ATTRIBUTES - _MOODS) | lex.word_set("understood without a thing")


def unseen(d: Discourse, frames: list[Frame]) -> Iterator[tuple[int, int, str]]:
    """Words for what became no object: where they stand, and what the scene lacks of it."""
    drawn = [(m.start, m.end) for m in d.mentions if m.entities or d.world.resolved.get(id(m))]
    taken = [*drawn, *((f.verb.start, f.verb.end) for f in frames)]
    told: list[int] = []
    for words, why in _PATTERNS:
        for found in words.finditer(d.text):
            if not any(start <= found.start() < end for start, end in taken):
                told.append(found.start())
                yield found.start(), found.end(), why
    for found in _CONTENTS.finditer(d.text):
        if any(start < found.start() < end for start, end in drawn):
            yield found.start(), found.end(), _KINDS[0][1]  # "a bowl of water"
    for m in d.mentions:
        if (m.start, m.end) in drawn or m.amounts or m.pronoun or m.noun is not None or m.part:
            continue
        head = lex.singular(m.head)[0]
        why = _CLASSES.get("nothing" if head in _MOODS else no_things().get(head, ""), "")
        done = m.attribute and not m.after_prep and m.head not in lex.ATTRIBUTES
        why = why or (_CLASSES["nothing"] if done and head not in no_things() else "")
        said = any(m.start <= at < m.end for at in told)
        if why and not said and m.head not in _UNDERSTOOD:
            yield m.start, m.end, why
