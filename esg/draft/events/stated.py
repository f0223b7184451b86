"""What the words around a verb state of its motion: which way, how fast, in what manner.

`data/statements.csv` says which adverbs, phrases and verbs state what, with a sentence for each.
"""

from __future__ import annotations

import csv
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.proposition import Row, Said
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.draft.text.multiwords import spellings
from esg.draft.verbphrases import verb_readings
from esg.graph.models import Predicate

_INTENSE = re.compile(
    r"\s+(?:in|at|on|into|onto|next|behind|beside|before|after|through|off|over|past|against)\b",
    re.IGNORECASE,
)
"""What follows a "right" that says how exactly, and not which way ("right in front of")."""
_UPWARD = lex.word_set("goes up")
NAMED_BY = lex.word_set("sports that name things")
_WAYS = ("backward", "up", "down")
"""Directions that a participle before a noun can state: "approaching" has an aim to find."""
_LEAPS = lex.word_set("leaps up and down")
_THEN = re.compile(r"\b(?:then|finally|afterwards|later)\s+$", re.IGNORECASE)
_AND_DOWN = re.compile(r"\s+and\s+down\b", re.IGNORECASE)
"""After "up": to and fro, and no course."""
_SIDES = ("leftwards", "rightwards")
_OTHER_WAY = re.compile(
    r"(?:in )?the (?:other|opposite|reverse) (?:way|direction)\b", re.IGNORECASE
)
"""Words that a side may stand for (`rewrites.opposites`)."""
_REACH = 160
"""How far from its verb an adverb may stand, in characters."""


@cache
def rows() -> tuple[Row, ...]:
    """The table."""
    with open(lex.DATA / "statements.csv", encoding="utf-8", newline="") as file:
        return tuple(
            Row(
                r["part"],
                frozenset(r["words"].split("|")),
                Predicate(r["states"]),
                r["direction"] or None,  # type: ignore[arg-type]  # a test reads the whole table
                r["pace"],
                r["example"],
            )
            for r in csv.DictReader(file, delimiter=";")
        )


@cache
def _by_word() -> dict[tuple[str, str], tuple[Row, ...]]:
    out: dict[tuple[str, str], tuple[Row, ...]] = {}
    for row in rows():
        for word in row.words:
            out[row.part, word] = (*out.get((row.part, word), ()), row)
    return out


def said_before(text: str, f: Frame) -> list[Said]:
    """What a participle before the subject states of its motion: "a reversing van hits a sign"."""
    m, out = f.subject, list[Said]()
    if m is None or m.coordinated or f.verb.passive:
        return out
    for word in {*m.adjectives} - NAMED_BY:
        at = re.compile(rf"\b{re.escape(word)}\b").search(text, m.start, m.end)
        if at is None:
            continue
        lemmas = {r.lemma for r in verb_readings(word) if r.form == "ing"}
        found = [row for lemma in sorted(lemmas) for row in _by_word().get(("verb", lemma), ())]
        out += [Said(row, *at.span()) for row in found if row.pace or row.direction in _WAYS]
    return out


def said(text: str, f: Frame) -> list[Said]:
    """What the adverbs, phrases and the verb of a clause state of its motion."""
    verb = (f.verb.start, f.verb.end)
    # "runs after it", "catches up with it"
    lemma = f.verb.sense if f.verb.sense in ("follow", "approach") else f.verb.lemma
    out = [Said(row, *verb) for row in _by_word().get(("verb", lemma), ())]
    part = "braking" if f.verb.sense == "brake" else "adverb"
    for word in adverbs_of(text, f):
        found = _by_word().get((part, word), ())
        at = place_of(word, text, f) or verb
        if found and _tells_a_way(text, f, word, at[1]):
            out += [Said(row, *at) for row in found]
    for p in f.phrases:
        if p.mention is not None:
            start = start_of(p, text)
            out += [Said(row, start, p.mention.end, p) for row in _by_phrase(text, f, p, p.mention)]
    return out


def _tells_a_way(text: str, f: Frame, word: str, end: int) -> bool:
    """Whether an adverb that ends there is of a way, and not "right behind it", "leaps up"."""
    if word == "right" and exactly(text, end):
        return False
    if word != "up":
        return True
    leaps = f.verb.lemma in _LEAPS and _AND_DOWN.match(text, end) is not None
    return not leaps and _goes_up(f)


def _by_phrase(text: str, f: Frame, p: Phrase, m: Mention) -> tuple[Row, ...]:
    """The rows of a phrase: of a side, of where it comes from, of a thing, of a goal."""
    if m.attribute and p.prep in ("to", "toward", "towards"):
        return _by_word().get(("side", m.head), ())
    if p.prep == "in" and (found := course_of(p)):
        return found
    if m.attribute and p.prep == "from":
        return _by_word().get(("from", m.head), ())
    agent = p.prep == "by" and (f.verb.passive or f.reduced)
    if m.attribute or agent:
        return ()
    away = p.prep == "from" and text[: start_of(p, text)].rstrip().endswith("away")
    found = _by_word().get(("phrase", "away from" if away else p.prep), ())
    return found + _by_word().get(("goal", p.prep), ())


def course_of(p: Phrase) -> tuple[Row, ...]:
    """The rows of the shape that a phrase gives a way: "in circles"."""
    named = p.mention is not None and p.prep == "in"
    return _by_word().get(("course", p.mention.head), ()) if named and p.mention else ()


def exactly(text: str, end: int) -> bool:
    """Whether a "right" that ends somewhere is followed by the place that it makes exact."""
    return _INTENSE.match(text, end) is not None


def adverbs_of(text: str, f: Frame) -> list[str]:
    """The adverbs of a clause, those in its verb group included ("is gently placed")."""
    group = text[f.verb.start : f.verb.end].lower().split()[1:]
    if group and any(form.lemma == f.verb.lemma for form in lex.verb_forms().get(group[-1], ())):
        group = group[:-1]
    return [*f.adverbs, *[w for w in group if w not in f.adverbs]]


def _goes_up(f: Frame) -> bool:
    """Whether "up" is a way, not "drives up", "picks up", "slows up"."""
    return f.verb.sense == "fly" or f.verb.lemma in _UPWARD


def place_of(word: str, text: str, f: Frame) -> tuple[int, int] | None:
    """Where an adverb of a clause stands: the place nearest to its verb."""
    low = max(0, f.verb.start - _REACH)
    found = re.finditer(rf"\b{re.escape(word)}\b", text[low : f.verb.end + _REACH], re.IGNORECASE)
    places = [(low + m.start(), low + m.end()) for m in found]
    if not places:
        found = spellings(word).finditer(text, f.verb.end, f.verb.end + _REACH)
        places = [m.span() for m in found]
    if not places and word in _SIDES:
        found = _OTHER_WAY.finditer(text, f.verb.start, f.verb.end + _REACH)
        places = [m.span() for m in found]
    if not places and word in _TO_A_SIDE:
        found = _TO_A_SIDE[word].finditer(text, f.verb.end, f.verb.end + _REACH)
        places = [m.span() for m in found]
    return min(places, key=lambda at: abs(at[0] - f.verb.end), default=None)


_TO_A_SIDE = {
    f"{side}wards": re.compile(rf"\bto(?:wards?)? the {side}(?:.hand)? side\b", re.IGNORECASE)
    for side in ("left", "right")
}
"""How a way to one side is told besides, of nothing in particular ("to the left side")."""
CENTRE = "in the middle of"


def comes_later(p: Phrase, f: Frame, text: str) -> bool:
    """ "Drives on a road and then on a highway": the second of two places of one clause."""
    if p.mention is None or p.prep == "by":
        return False
    start = start_of(p, text)
    earlier = any(q is not p and 0 <= start_of(q, text) < start for q in f.phrases if q.mention)
    said = text[f.verb.end : max(start, 0)]
    return earlier and _THEN.search(said) is not None


def start_of(p: Phrase, text: str) -> int:
    """Where a phrase starts: at its preposition, if that stands just before what it names."""
    assert p.mention is not None
    before = text[max(0, p.mention.start - 30) : p.mention.start].lower()
    at = before.rfind(p.prep.split()[0])
    return p.mention.start - (len(before) - at) if at >= 0 else p.mention.start
