"""How a text names the bodies of a scene: noun phrases, articles, who is one of several."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
import re

from esg.engines.scene import FRAGMENT, GROUND, Body, SimScene
from esg.lexicon.morphology import plural, singular

NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
           "eleven", "twelve")  # fmt: skip
"""Written in words up to twelve (The Chicago Manual of Style, 9.2-9.3, writes more of them so)."""

_ARTICLE = re.compile(r"^(?:a|an|the|some|one|his|her|its|their|my|our)\s+", re.IGNORECASE)
_MEASURED = re.compile(
    r"^\d+(?:[.,]\d+)?\s*-?(?:kg|g|t|m|cm|mm|km|kilograms?|grams?|tons?|tonnes?|met(?:er|re)s?"
    r"|centimet(?:er|re)s?|inch(?:es)?|feet|foot|pounds?)\s+",
    re.IGNORECASE,
)
"""A number with its unit before a noun: nobody sees it."""
_POINTING = frozenset(("it", "him", "her", "them", "that", "this", "which", "another", "other",
                       "first", "second", "third", "next", "same", "behind", "front"))  # fmt: skip
"""Words of a label that only its prompt explains: the body's own name serves instead."""
_PROPER = re.compile(r"\b(?:[A-Z]|\d+)$")
"""What ends in a letter or a number is a name and has no article: ball A, car 2."""
_AN = re.compile(r"^(?:[aeio]|u(?!ni|se|ti|su|ro|ku)|hour|heir|honest)", re.IGNORECASE)
"""What begins with the sound of a vowel, by its letters; `one` and `euro` do not."""
_NOT_AN = re.compile(r"^(?:one|once|eu|ewe)", re.IGNORECASE)


_SUMMATION = frozenset(("headphones", "scissors", "stairs", "steps", "sunglasses", "trousers"))
"""Nouns that are one thing and yet plural (Quirk et al., 5.76): morphology gives no singular."""


def with_article(phrase: str) -> str:
    """The phrase with a or an."""
    an = _AN.match(phrase) and not _NOT_AN.match(phrase)
    return f"{'an' if an else 'a'} {phrase}"


def number(n: int) -> str:
    """A count in words, as far as `NUMBERS` go."""
    return NUMBERS[n] if 0 <= n < len(NUMBERS) else str(n)


def listed(items: Sequence[str], last: str = "and") -> str:
    """`a`, `a and b`, `a, b and c`."""
    if len(items) < 2:
        return "".join(items)
    return f"{', '.join(items[:-1])} {last} {items[-1]}"


def noun_of(body: Body) -> str:
    """A body's noun phrase without an article: what the prompt calls it, if it explains itself."""
    stem = re.sub(r"_\d+$", "", body.name).replace("_", " ")
    text = _MEASURED.sub("", _ARTICLE.sub("", " ".join(body.label.split())))
    words = set(re.findall(r"[a-z]+", text.lower()))
    if not text or words & _POINTING or (body.group and " of " in text):
        return stem
    if body.group and singular(text.lower()) != text.lower():
        return singular(text)
    return text


class Nouns:
    """Names of a scene's bodies.

    Args:
        scene: The scene.
    """

    def __init__(self, scene: SimScene) -> None:
        shown = [b for b in scene.bodies if b.category != FRAGMENT]
        self._noun = {b.name: noun_of(b) for b in shown} | {GROUND: "ground"}
        self._count = Counter(self._noun[b.name] for b in shown if b.collides)
        self._labels = set(self._count)

    def known(self, name: str) -> bool:
        """Whether a body has a name that may be told: fragments have none."""
        return name in self._noun

    def noun(self, name: str) -> str:
        """The noun phrase, without an article."""
        return self._noun[name]

    def is_plural(self, name: str) -> bool:
        """Whether verbs take the plural after it: stairs, scissors."""
        noun = self._noun[name].lower()
        many = singular(noun) != noun or noun.split()[-1] in _SUMMATION
        return self._count[self._noun[name]] < 2 and many

    def several(self, name: str) -> int:
        """How many bodies go by the same phrase."""
        return max(1, self._count[self._noun[name]])

    def clear(self, name: str) -> bool:
        """Whether `the ...` can mean nothing else in the scene: no ball beside a red ball."""
        noun = self._noun.get(name)
        if noun is None or self.several(name) > 1:
            return False
        return not any(other != noun and other.endswith(f" {noun}") for other in self._labels)

    def the(self, name: str) -> str:
        """The body as one that is known: `the red ball`, `one of the three pins`."""
        n, noun = self.several(name), self._noun[name]
        if n == 1:
            return noun if _PROPER.search(noun) else f"the {noun}"
        return f"one of the {number(n)} {plural(self._noun[name])}"

    def a(self, name: str) -> str:
        """The body as one that is new: `a red ball`, `one of three pins`."""
        n = self.several(name)
        if n > 1:
            return f"one of {number(n)} {plural(self._noun[name])}"
        if name == GROUND:
            return "the ground"
        bare = self.is_plural(name) or _PROPER.search(self._noun[name])
        return self._noun[name] if bare else with_article(self._noun[name])

    def share(self, name: str, n: int) -> str:
        """Some of those that go by a phrase: `four of the six pins`, `all six pins`."""
        many = plural(self._noun[name])
        if n >= self.several(name):
            return f"both {many}" if n == 2 else f"all {number(n)} {many}"
        return f"{number(n)} of the {number(self.several(name))} {many}"

    def inventory(self, names: Iterable[str]) -> list[str]:
        """Bodies as a list would have them: `a car`, `six bowling pins`."""
        of: dict[str, list[str]] = {}
        for name in names:
            of.setdefault(self._noun[name], []).append(name)
        return [
            self.a(found[0])
            if self.several(found[0]) == 1
            else f"{number(len(found))} {plural(noun)}"
            if len(found) > 1
            else with_article(noun)
            for noun, found in of.items()
        ]
