"""Words for what no scene of solid bodies shows: fluids, light and weather, the camera."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.record import Discourse
from esg.draft.document.requirements import environment
from esg.draft.grammar.clauses.frames import Frame
from esg.lexicon.grounds import ground_said
from esg.lexicon.places import Setting, sky_words
from esg.lexicon.senses import no_things

_LIGHT = "light and weather are not simulated"
FLUIDS = "fluids are not simulated"
NO_THING = "no solid thing or motion stands for it"
_KINDS = (
    (lex.word_set("unseen fluids"), FLUIDS),
    (lex.word_set("unseen views"), "the camera and the style of the picture are not part of it"),
)


@cache
def _any_of(words: frozenset[str]) -> re.Pattern[str]:
    listed = "|".join(map(re.escape, sorted(words, key=lambda w: (-len(w), w))))
    return re.compile(rf"\b(?:{listed})\b", re.IGNORECASE)


@cache
def _patterns(setting: Setting) -> tuple[tuple[re.Pattern[str], str], ...]:
    """What no picture of a setting shows, by why; of light the table of skies has the last word."""
    shown, not_shown = sky_words(setting)
    weather = (lex.word_set("unseen light and weather") | not_shown) - shown
    told = (*_KINDS, (weather, _LIGHT), (lex.word_set("unseen grounds"), _GROUNDS))
    return tuple((_any_of(words), why) for words, why in told)


_GROUNDS = "how such a ground holds is in no table"
_CLASSES = {
    "nothing": NO_THING,
    "substance": "substances are not simulated",
    "body": "parts of bodies do not move by themselves",
}
_CONTENTS = re.compile(
    rf"\b(?:of|with)\s+(?:\w+\s+)?(?:{'|'.join(map(re.escape, sorted(_KINDS[0][0])))})\b",
    re.IGNORECASE,
)
_MOODS = lex.word_set("unseen attributes")
_UNDERSTOOD = (lex.ATTRIBUTES - _MOODS) | lex.word_set("understood without a thing")


def unseen_words(text: str, setting: Setting) -> Iterator[tuple[int, int, str]]:
    """Words for what no scene shows, by the tables alone: of texts that are not read any further.

    Args:
        text: Any text.
        setting: Where it plays.

    Yields:
        Where a word stands, from start to end, and what a scene lacks of it.
    """
    for words, why in _patterns(setting):
        for found in words.finditer(text):
            yield found.start(), found.end(), why


def unseen(d: Discourse, frames: list[Frame]) -> Iterator[tuple[int, int, str]]:
    """Words for what became no object: where they stand, and what the scene lacks of it."""
    drawn = [(m.start, m.end) for m in d.mentions if m.entities or d.world.resolved.get(id(m))]
    taken = [*drawn, *((f.verb.start, f.verb.end) for f in frames)]
    setting: Setting = "indoor" if environment(d.scene)[0] == "indoor" else "outdoor"
    shown, _ = sky_words(setting)
    lit = _any_of(shown)
    lies = [(start, end) for _, start, end in ground_said(d.text)]
    told: list[int] = []
    qualities = {a for m in d.mentions for a in m.adjectives}
    for words, why in _patterns(setting):
        for found in words.finditer(d.text):
            free = not any(start <= found.start() < end for start, end in taken)
            weighs = not free and found[0].lower() in lex.WEIGHTS  # "a light ball"
            if weighs or any(start <= found.start() < end for start, end in lies):
                continue
            if free or (
                why in (_LIGHT, _GROUNDS) and found[0].lower() in qualities
            ):  # "a rainy street"
                told.append(found.start())
                yield found.start(), found.end(), why
    for found in _CONTENTS.finditer(d.text):
        if any(start < found.start() < end for start, end in drawn):
            yield found.start(), found.end(), FLUIDS  # "a bowl of water"
    for m in d.mentions:
        if (m.start, m.end) in drawn or m.amounts or m.pronoun or m.noun is not None or m.part:
            continue
        head = lex.singular(m.head)[0]
        why = _CLASSES.get("nothing" if head in _MOODS else no_things().get(head, ""), "")
        done = m.attribute and not m.after_prep and m.head not in lex.ATTRIBUTES
        why = why or (_CLASSES["nothing"] if done and head not in no_things() else "")
        if why and lit.search(d.text, m.start, m.end):
            d.scene.used.setdefault((m.start, m.end), "light of the scene")
            continue  # "in the evening", "on a sunny day"
        said = any(m.start <= at < m.end for at in (*told, *(end - 1 for _, end in lies)))
        if why and not said and m.head not in _UNDERSTOOD:
            yield m.start, m.end, why
