"""Verbs that mean something else in a phrase: "slams on the brakes", "fetches up against".

Each row of `data/verb_phrases.csv` has lemmas, a pattern of what follows them, the sense that they
then have, and notes for the readings. The first pattern of a lemma that matches decides.
"""

from __future__ import annotations

import csv
from functools import lru_cache
import re

from esg.draft import lexicon as lex

DECKS = lex.word_set("decks")
DECK_PHRASE = r"(?:(?!(?:on|at|near|by|and|in|from|of|into|onto|off|with)\b)[\w.'-]+\s+){1,6}?"
"""What stands before such a word in its phrase, the article included."""
_DECK = rf"{DECK_PHRASE}(?:{'|'.join(sorted(DECKS))})\b"
_DET = r"(?:an?|the|its|his|her|their|some|another|one|two|three)"
_SHORT = {
    "NO_OBJECT": r"(?!\s+(?:an?|the|its|his|her|their|some|it|him|them|one|two|three|another)\b)",
    "DECK": _DECK,
    "NO_DECK": rf"(?!\s+{_DECK})",
    "NO_EDGE": r"(?!\s+(?:an?|the|its|their)\s+(?:\w+\s+)?(?:edge|side|end|rim|lip|brink|cliff)\b)",
    "ADJ": r"(?:(?:[a-z-]+)\s+)?",
    "PUNCT": "[.,;!]",
    "DET": _DET,
    "DEVICE": rf"(?:{'|'.join(sorted(lex.word_set('devices')))})",
    "OWN": r"(?:its|his|her|their|the)",
    "END": r"\s*(?:[.,;!]|$)",
    "SOLID": rf"(?=\s+(?:{_DET}\b|it\b|him\b|them\b|each\b|\w+\s*(?:[.,;!]|$)))",
    "FLAT": (
        r"(?:flat\s+)?(?:on|onto)\s+(?:its|his|her|their|the)\s+"
        r"(?:side|back|face|nose|bottom|backside|front|beam\s+ends)s?\b(?!\s+of\b)"
    ),
    "ROOF": (
        r"(?:up\s+|over\s+)?(?:lying\s+)?(?:on|onto)\s+(?:its|the|their)\s+(?:roof|head|lid)s?\b"
    ),
    "STOP": r"(?:an?\s+|the\s+)?(?:[a-z-]+\s+){0,2}(?:stop|halt|rest|standstill)",
    "SIDE": (
        r"(?:(?:sharply|hard|sharp|suddenly|slightly|gently|off|round|around|away|out)\s+){0,2}"
        r"(?:to\s+(?:the|its|his|her)\s+)?(?P<dir>left|right)(?![\w-]*\s+(?:of|side|hand\s+side"
        r"|wall|bank|lane|edge|post|end|bumper|pocket|corner|goal|foot|front|rear)\b)"
    ),
    "PAST": r"(?=(?:just\s+|narrowly\s+|right\s+|straight\s+|clean\s+)?past\b)",
}
"""What the table's patterns write as {NAME}."""
VerbPhrase = tuple[re.Pattern[str], str, dict[str, str]]
"""What follows the verb, the sense it then has, and notes."""


def _follows(pattern: str) -> re.Pattern[str]:
    """A pattern belongs to its verb, or is only looked at: "(?=...)"."""
    for name, text in _SHORT.items():
        pattern = pattern.replace("{" + name + "}", text)
    seen = rf"(?=\s+{pattern[3:]}" if pattern.startswith("(?=") else rf"\s+{pattern}(?![\w-])"
    return re.compile(seen, re.IGNORECASE)


def _verb_phrases() -> dict[str, list[VerbPhrase]]:
    """The table by lemma; "@" in a note is the lemma itself."""
    out: dict[str, list[VerbPhrase]] = {}
    with open(lex.DATA / "verb_phrases.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE):
            pattern = _follows(row["follows"])
            notes = dict(n.split("=") for n in row["notes"].split())
            for lemma in row["lemmas"].split():
                own = {k: lemma if v == "@" else v for k, v in notes.items()}
                out.setdefault(lemma, []).append((pattern, row["sense"], own))
    return out


PHRASES = _verb_phrases()


@lru_cache(maxsize=16384)
def verb_readings(word: str) -> tuple[lex.VerbForm, ...]:
    """Readings of a word as a verb, phrase heads included."""
    low = word.lower()
    return lex.verb_forms().get(low) or lex.phrase_verb_forms().get(low, ())


def particle_sense(lemma: str, words: str) -> tuple[str, dict[str, str]] | None:
    """Sense of a verb whose particle stands elsewhere ("over it goes").

    Args:
        lemma: The verb.
        words: Its particle, and the word after it if there is one.
    """
    for pattern, sense, extra in PHRASES.get(lemma, []):
        if sense and "only_passive" not in extra and pattern.match(" " + words):
            return sense, {k: v for k, v in extra.items() if k != "dir"}
    return None
