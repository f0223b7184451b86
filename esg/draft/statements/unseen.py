"""Words for what no scene of solid bodies shows: fluids, light and weather, the camera."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.record import Discourse
from esg.draft.document.requirements import environment
from esg.draft.events.senses.gestures import USED as GESTURE
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Element, Mention
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
_LOADED = lex.word_set("loaded (unseen)")
_LOAD = re.compile(r"\b(?P<what>\w+)\s+(?:full\s+)?of\s+(?:\w+\s+)?\w+$", re.IGNORECASE)
LOADS = "what is on it or in it is not shown"
_EDGES = frozenset({"out of view", "into view", "frontwards", "rearwards"})
"""Adverbs of motions: no camera is meant."""
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


def unseen(
    d: Discourse, frames: list[Frame], elements: list[Element]
) -> Iterator[tuple[int, int, str]]:
    """Words for what became no object: where they stand, and what the scene lacks of it."""
    drawn = [(m.start, m.end) for m in d.mentions if m.entities or d.world.resolved.get(id(m))]
    setting: Setting = "indoor" if environment(d.scene)[0] == "indoor" else "outdoor"
    lies = [(start, end) for _, start, end in ground_said(d.text)]
    taken = [*drawn, *((f.verb.start, f.verb.end) for f in frames)]
    taken += [(e.start, e.end) for e in elements if getattr(e, "low", "") in _EDGES]
    told = [*_unseen_of_tables(d, setting, taken, lies)]
    yield from told
    named = {word for e in d.world.entities.values() for word in e.head.split()}
    for found in _CONTENTS.finditer(d.text):
        if found.group().split()[-1].lower() in named:
            continue  # "a stack of oil drums"
        if any(start < found.start() < end for start, end in drawn):
            yield found.start(), found.end(), FLUIDS  # "a bowl of water"
    yield from _unseen_loads(d, lies)
    for m in d.mentions:
        if m.head == "camera" and m.attribute and m.text.lower() == "it":
            yield m.start, m.end, _KINDS[1][1]  # "toward the camera ... away from it"
    known = [*(start for start, _, _ in told), *(end - 1 for _, end in lies)]
    yield from _unseen_of_nouns(d, setting, drawn, known)


def _unseen_loads(d: Discourse, lies: list[tuple[int, int]]) -> Iterator[tuple[int, int, str]]:
    """ "A truck of hay", "a cart of coal": what only the name of a thing says is on or in it."""
    filled = [at.vessel for at in d.scene.fillings.fillings]
    for m in d.mentions:
        told = m.noun is not None and m.noun.kind in _LOADED and bool(m.entities)
        if not told or any(m.start <= at < m.end for at in filled):
            continue
        found = _LOAD.search(d.text, m.start, m.end)
        if (
            found is None
            or found["what"].lower() != m.head.split()[-1]
            or m.text.lower().removeprefix("a ") in lex.nouns()
        ):
            continue  # "a pan of scales" is a kind of its own
        if not any(a <= found.start() < b for a, b in lies):
            yield found.end("what") + 1, m.end, LOADS


def _unseen_of_tables(
    d: Discourse, setting: Setting, taken: list[tuple[int, int]], lies: list[tuple[int, int]]
) -> Iterator[tuple[int, int, str]]:
    """Words of the tables that neither a thing, a verb nor the ground has taken."""
    qualities = {a for m in d.mentions for a in m.adjectives}
    for start, end, why in unseen_words(d.text, setting):
        free = not any(low <= start < high for low, high in taken)
        word = d.text[start:end].lower()
        weighs = not free and word in lex.WEIGHTS  # "a light ball"
        if weighs or any(low <= start < high for low, high in lies):
            continue
        if free or (why in (_LIGHT, _GROUNDS) and word in qualities):  # "a rainy street"
            yield start, end, why


def _unseen_of_nouns(
    d: Discourse, setting: Setting, drawn: list[tuple[int, int]], known: list[int]
) -> Iterator[tuple[int, int, str]]:
    """Nouns that no object stands for, with words at `known` left out."""
    lit = _any_of(sky_words(setting)[0])
    for m in d.mentions:
        if (m.start, m.end) in drawn or m.amounts or m.pronoun or m.noun is not None or m.part:
            continue
        if d.scene.used.get((m.start, m.end)) == GESTURE:
            continue  # "wags its tail"
        why = _lacks(m)
        if why and lit.search(d.text, m.start, m.end):
            d.scene.used.setdefault((m.start, m.end), "light of the scene")
            continue  # "in the evening", "on a sunny day"
        said = any(m.start <= at < m.end for at in known)
        if why and not said and m.head not in _UNDERSTOOD:
            yield m.start, m.end, why


def _lacks(m: Mention) -> str:
    """Why a noun is no thing of a scene; nothing where it may be one."""
    head = lex.singular(m.head)[0]
    why = _CLASSES.get("nothing" if head in _MOODS else no_things().get(head, ""), "")
    done = m.attribute and not m.after_prep and m.head not in lex.ATTRIBUTES
    return why or (_CLASSES["nothing"] if done and head not in no_things() else "")
