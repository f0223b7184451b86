"""What people and animals wear, and how their hair is: tables of kinds, and phrases that name them.

A phrase ("dark blue leather jacket", "long red hair") names a kind of `garments.csv`, and may say
its colour, what it is made of and its pattern by words of `wear_words.csv`. Drafter, builders and
judge read the same phrases with `read`.
"""

from __future__ import annotations

from collections.abc import Collection
import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
import re

from esg.lexicon.cells import words
from esg.lexicon.kinds import kinds
from esg.lexicon.morphology import plural, singular

_FOLDER = Path(__file__).parent
LOOKS = frozenset({"hair", "beard", "skin"})
"""Places that are told of a body itself, not of what it wears."""
_STRIPED = frozenset({"torso", "whole"})
"""Places whose pattern is drawn."""


@dataclass(frozen=True)
class Garment:
    """One kind of clothes, or of hair.

    Args:
        kind: Its name, which the drawn part has too.
        place: head, face, neck, torso, over, whole, legs, feet, hands, back, waist; or hair, beard,
            skin.
        color: Usual "#rrggbb"; "" if it has none of its own.
        surface: Row of the table of materials.
        on: Who can be drawn with it.
    """

    kind: str
    place: str
    color: str
    surface: str
    on: frozenset[str]

    @property
    def looks(self) -> bool:
        """Whether it is told of a body itself."""
        return self.place in LOOKS


@dataclass(frozen=True)
class Worn:
    """A garment as a phrase names it.

    Args:
        garment: Its kind.
        color: The words that tell its colour, or "#rrggbb"; "" if none do.
        surface: Row of the table of materials that the phrase states; "" if it states none.
        pattern: "striped", or "".
        unread: Words of the phrase that none of this holds.
    """

    garment: Garment
    color: str = ""
    surface: str = ""
    pattern: str = ""
    unread: tuple[str, ...] = ()


@cache
def garments() -> dict[str, Garment]:
    """Every kind by the words that name it, hyphens as blanks."""
    out: dict[str, Garment] = {}
    with (_FOLDER / "garments.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            on = frozenset(words(row["on"]))
            one = Garment(row["kind"], row["place"], row["color"], row["surface"], on)
            out |= dict.fromkeys((_plain(w) for w in words(row["words"])), one)
    return out


@cache
def _told() -> dict[tuple[str, str], dict[str, str]]:
    """What words before a garment say, by what they tell and of what."""
    out: dict[tuple[str, str], dict[str, str]] = {}
    with (_FOLDER / "wear_words.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            told = out.setdefault((row["says"], row["of"]), {})
            told |= dict.fromkeys(words(row["words"]), row["value"])
    return out


def _plain(text: str) -> str:
    """Lower case, with blanks for hyphens, and no apostrophes."""
    return " ".join(re.findall(r"[a-z0-9]+", re.sub(r"['’]", "", text.lower())))


def read(phrase: str, colors: Collection[str]) -> Worn | None:
    """What a phrase without its article names; None if that is nothing that can be worn.

    Args:
        phrase: "black t-shirt", "long blond hair".
        colors: Words that tell colours.
    """
    if re.split(r"[\s-]", phrase.lower())[-1] not in _last_words():
        return None
    tokens = _plain(phrase).split()
    plain = [k for k, w in enumerate(tokens) if not _is_modifier(w, colors) or w == tokens[-1]]
    whole, bare = _longest(tokens), _longest([tokens[k] for k in plain])
    if whole is None or bare is None:
        return None
    if bare[0] > whole[0]:  # "a long red dress" is a long dress
        named = {*plain[len(plain) - bare[0] :]}
        return _modified(bare[1], [w for k, w in enumerate(tokens) if k not in named], colors)
    return _modified(whole[1], tokens[: len(tokens) - whole[0]], colors)


@cache
def _last_words() -> frozenset[str]:
    """With which words phrases that name garments can end."""
    ends = {name.split()[-1] for name in garments()}
    return frozenset(ends | {plural(w) for w in ends})


def _is_modifier(word: str, colors: Collection[str]) -> bool:
    """Whether a word tells a colour, a material or a pattern of what comes after it."""
    return word in colors or any(word in told for told in _told().values())


def _longest(tokens: list[str]) -> tuple[int, Garment] | None:
    """How many of the last words name a kind, the most that do, and which."""
    table = garments()
    for first in range(len(tokens)):
        rest = tokens[first:]
        forms = (rest, [*rest[:-1], singular(rest[-1])])
        garment = next((table[w] for f in forms if (w := " ".join(f)) in table), None)
        if garment is not None:
            return len(rest), garment
    return None


def _modified(garment: Garment, before: list[str], colors: Collection[str]) -> Worn:
    told = _told()
    hues = told["color", "hair"] if garment.place in ("hair", "beard") else {}
    shades, surfaces = told["shade", "worn"], told["surface", "worn"]
    colored = [w for k, w in enumerate(before) if (w in hues or w in colors)
               and not (w in shades and {*before[k + 1 : k + 2]} & {*hues, *colors})]  # fmt: skip
    color, surface, pattern, unread = "", "", "", list[str]()
    for k, word in enumerate(before):
        later = before[k + 1] if k + 1 < len(before) else ""
        if word in colored and len(colored) == 1:
            shade = before[k - 1] if k and before[k - 1] in shades else ""
            color = hues.get(word) or f"{shade} {word}".strip()
        elif word in shades and later in colored and len(colored) == 1:
            if later in hues and word != "dark":
                unread.append(word)
        elif word in surfaces and not garment.looks and not surface:
            surface = surfaces[word]
        elif word in told["pattern", "worn"] and garment.place in _STRIPED:
            pattern = told["pattern", "worn"][word]
        elif word != "and":
            unread.append(word)
    return Worn(garment, color, surface, pattern, tuple(unread))


_WEARERS: dict[str, frozenset[str]] = {
    **dict.fromkeys(("figure", "child_figure", "mounted"), frozenset({"people"})),
    "quadruped": frozenset({"beasts", "quadrupeds"}),
    **dict.fromkeys(
        ("bird", "plumed", "monkey", "kangaroo", "koala", "gorilla"), frozenset({"beasts"})
    ),
}
"""Who can be drawn with what, by the builder of his kind."""


@cache
def wearers() -> dict[str, frozenset[str]]:
    """As whom each kind can be dressed, by its name: people, beasts, quadrupeds."""
    return {k.name: _WEARERS[k.builder] for k in kinds() if k.builder in _WEARERS}
