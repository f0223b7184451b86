"""Verbs whose sense depends on their arguments: "takes it out", "breaks off the cliff".

A row of `data/verb_frames.csv` has verbs, conditions on their frame, the sense that they then have,
effects on the frame and an example. The first row that fits decides.

Conditions on a noun phrase must all hold ("thing !ball"), each has alternatives ("it|known"): a
kind of things, a trait, a head noun, a word set ("@round"), or a name of `_KINDS`; "!" denies.
Phrases are prepositions and a condition ("on|onto:thing", "by:-": none).
"""

from __future__ import annotations

from collections.abc import Callable
import csv
from dataclasses import dataclass
from functools import cache
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention


@dataclass(frozen=True)
class FrameRow:
    """One row of the table, its words parted."""

    name: str
    lemmas: frozenset[str]
    senses: frozenset[str]
    verb: list[str]
    adverbs: str
    subject: str
    object: str
    phrases: list[str]
    result: str
    effects: list[str]
    example: str


def read_idioms(frames: list[Frame]) -> None:
    """Gives verbs the sense that they have with their arguments.

    Args:
        frames: Frames of a prompt; their `verb.sense` and phrases may change.
    """
    for f in frames:
        row = row_of(f)
        if row is None:
            continue
        phrase = _phrase(f, row.phrases[0]) if row.phrases else None
        f.verb.sense = row.result or f.verb.sense
        for effect in row.effects:
            name, _, value = effect.partition("=")
            if name.startswith("+"):
                f.verb.extra = {**f.verb.extra, name[1:]: value or "1"}
            else:
                _EFFECTS[name](f, phrase, value)


def row_of(f: Frame) -> FrameRow | None:
    """The first row of the table that fits a frame."""
    return next((row for row in rows() if _fits(f, row)), None)


@cache
def rows() -> tuple[FrameRow, ...]:
    """The table."""
    with open(lex.DATA / "verb_frames.csv", encoding="utf-8", newline="") as file:
        return tuple(
            FrameRow(**{name: _CELLS.get(name, str)(cell) for name, cell in row.items()})
            for row in csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE)
        )


def _words(cell: str) -> frozenset[str]:
    return lex.word_set(cell[1:]) if cell.startswith("@") else frozenset(cell.split())


_CELLS: dict[str, Callable[[str], Any]] = {
    "lemmas": _words, "senses": _words, "verb": str.split, "effects": str.split,
    "phrases": lambda cell: cell.split(", ") if cell else [],
}  # fmt: skip
"""How the cells of a column are parted; all others are read as they are."""


def _fits(f: Frame, row: FrameRow) -> bool:
    v = f.verb
    if (row.lemmas and v.lemma not in row.lemmas) or (row.senses and v.sense not in row.senses):
        return False
    if not all(_VERBS[test](f) for test in row.verb):
        return False
    named = {*row.adverbs.removeprefix("!").split("|")} & {*f.adverbs}
    if row.adverbs and bool(named) == row.adverbs.startswith("!"):
        return False
    if not (_is(f.subject, row.subject) and _is(f.object, row.object)):
        return False
    return all(
        _phrase(f, cell.replace(":-", ":any")) is None if cell.endswith(":-") else _phrase(f, cell)
        for cell in row.phrases
    )


def _is(m: Mention | None, conditions: str) -> bool:
    """Whether a noun phrase is all that a cell says."""
    for words in conditions.split(" ") if conditions else ():
        alternatives = words.removeprefix("!").split("|")
        if any(_is_one(m, word) for word in alternatives) == words.startswith("!"):
            return False
    return True


def _is_one(m: Mention | None, word: str) -> bool:
    if word in _KINDS:
        return _KINDS[word](m)
    if m is None:
        return False
    kind, traits = (m.noun.kind, m.noun.traits) if m.noun is not None else ("", frozenset[str]())
    if word.startswith("@"):
        return bool({kind, *m.head.split()[-1:]} & lex.word_set(word[1:].replace("_", " ")))
    return word in (kind, m.head) or word in traits


def _phrase(f: Frame, cell: str) -> Phrase | None:
    """The phrase that a cell asks for: "on|onto:thing", "any:time"."""
    preps, _, condition = cell.partition(":")
    for p in f.phrases:
        here = preps == "any" or p.prep in preps.split("|")
        if here and p.amount is not None and p.amount.dimension == condition:
            return p
        if here and p.mention is not None and _is(p.mention, condition):
            return p
    return None


def _solid(m: Mention | None) -> bool:
    """Something solid, pronouns included."""
    return m is not None and not m.attribute and not _ground(m) and bool(m.head or m.pronoun)


def _ground(m: Mention | None) -> bool:
    return m is not None and m.noun is not None and "structural" in m.noun.traits


_PERSONAL = frozenset({"he", "she", "they", "i", "we", "you", "who", "somebody", "someone"})
_KINDS: dict[str, Callable[[Mention | None], bool]] = {
    "-": lambda m: m is None,
    "any": lambda m: m is not None,
    "thing": _solid,
    "whole": lambda m: _solid(m) and m is not None and not m.part,
    "ground": _ground,
    "known": lambda m: m is not None and m.noun is not None,
    "it": lambda m: m is not None and m.pronoun in ("it", "them"),
    "somebody": lambda m: m is not None and (m.pronoun in _PERSONAL or _is(m, "person")),
}
_VERBS: dict[str, Callable[[Frame], bool]] = {
    "active": lambda f: not f.verb.passive,
    "passive": lambda f: f.verb.passive,
    "finite": lambda f: not f.verb.infinitive,
    "negated": lambda f: f.verb.negated,
    "over": lambda f: "over" in f.verb.extra,
    "aimless": lambda f: not set(f.verb.extra) - {"dir"},
}
"""What the column "verb" may ask."""


def _object(f: Frame, p: Phrase | None, _: str) -> None:
    """What follows the particle is the object: "takes out the red one"."""
    f.object = p.mention if p is not None else None
    _away(f, p, "")


def _onto(f: Frame, _: Phrase | None, __: str) -> None:
    """The object is where it goes: "runs into the street"."""
    f.phrases.insert(0, Phrase("onto", f.object))
    f.object = None


def _prep(_: Frame, p: Phrase | None, prep: str) -> None:
    if p is not None:
        p.prep = prep


def _away(f: Frame, p: Phrase | None, _: str) -> None:
    if p is not None:
        f.phrases.remove(p)


def _positive(f: Frame, _: Phrase | None, __: str) -> None:
    f.verb.negated, f.verb.modal = False, ""


def _loose(f: Frame, _: Phrase | None, __: str) -> None:
    """A heap of snow, not the ground."""
    if f.subject is not None:
        f.subject.noun, f.subject.known = None, False


def _note(f: Frame, _: Phrase | None, value: str) -> None:
    f.verb.note = value


def _owner(f: Frame, _: Phrase | None, __: str) -> None:
    """What has the speed is the subject: "its speed drops"."""
    speed = f.subject
    if speed is not None:
        word = {"his": "he", "her": "she", "their": "they"}.get(speed.determiner, "it")
        it = Mention(speed.start, speed.end, pronoun=word, text=word)
        f.subject = speed.possessor or it


_EFFECTS: dict[str, Callable[[Frame, Phrase | None, str], None]] = {
    "object": _object, "onto": _onto, "prep": _prep, "away": _away, "positive": _positive,
    "note": _note, "loose": _loose, "owner": _owner,
}  # fmt: skip
"""What the column "effects" may do to a frame, given the phrase of the first cell.

"+contact" and "+via=slow" are notes of the verb for the reading of its sense.
"""
