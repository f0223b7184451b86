"""Particle verbs and set phrases by what happens: "fetches up against", "comes to a dead stop".

Each row of `data/particles.csv` has lemmas, a pattern of what follows them, the sense that they
then have, and notes for the readings. The first pattern of a lemma that matches decides, and these
come before those of `verbphrases`.
"""

from __future__ import annotations

import csv
from typing import NamedTuple

from esg.draft.lexicon import DATA


class Particle(NamedTuple):
    """One phrase: lemma, pattern of what follows it, its sense, notes."""

    lemma: str
    follows: str
    sense: str
    notes: dict[str, str]


_DET = r"(?:an?|the|its|his|her|their|some|another|one|two|three)"
_SHORT = {
    "DET": _DET,
    "OWN": r"(?:its|his|her|their|the)",
    "END": r"\s*(?:[.,;!]|$)",
    "SOLID": rf"(?=\s+(?:{_DET}\b|it\b|him\b|them\b|each\b|\w+\s*(?:[.,;!]|$)))",
    "FLAT": (
        r"(?:flat\s+)?(?:on|onto)\s+(?:its|his|her|their|the)\s+"
        r"(?:side|back|face|nose|bottom|backside|front|beam\s+ends)s?\b"
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


def particles() -> list[Particle]:
    """All rows of the table, one for each lemma."""
    out: list[Particle] = []
    with open(DATA / "particles.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE):
            pattern = row["follows"]
            for name, text in _SHORT.items():
                pattern = pattern.replace("{" + name + "}", text)
            notes = dict(n.split("=") for n in row["notes"].split())
            out += [Particle(v, pattern, row["sense"], notes) for v in row["lemmas"].split()]
    return out


LEMMAS = {
    "fetch": ("fetches", "fetched", "fetched", "fetching"),
    "finish": ("finishes", "finished", "finished", "finishing"),
    "leave": ("leaves", "left", "left", "leaving"),
    "gather": ("gathers", "gathered", "gathered", "gathering"),
    "lock": ("locks", "locked", "locked", "locking"),
    "part": ("parts", "parted", "parted", "parting"),
    "ease": ("eases", "eased", "eased", "easing"),
    "shed": ("sheds", "shed", "shed", "shedding"),
    "suffer": ("suffers", "suffered", "suffered", "suffering"),
    "gun": ("guns", "gunned", "gunned", "gunning"),
    "whip": ("whips", "whipped", "whipped", "whipping"),
    "wheel": ("wheels", "wheeled", "wheeled", "wheeling"),
    "throttle": ("throttles", "throttled", "throttled", "throttling"),
    "squeak": ("squeaks", "squeaked", "squeaked", "squeaking"),
    "ghost": ("ghosts", "ghosted", "ghosted", "ghosting"),
    "fork": ("forks", "forked", "forked", "forking"),
    "double": ("doubles", "doubled", "doubled", "doubling"),
    "halve": ("halves", "halved", "halved", "halving"),
    "scramble": ("scrambles", "scrambled", "scrambled", "scrambling"),
}
"""Forms of verbs that mean something for the drafter only in such a phrase."""
