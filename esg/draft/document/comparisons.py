"""Comparisons of mass, size and speed: "twice as heavy as the other", "faster than B"."""

from __future__ import annotations

from collections.abc import Container
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import Scene
from esg.draft.document.requirements import requirement
from esg.draft.text.elements import Mention
from esg.draft.text.numerals import parse_number

_RATIO = r"\b(?:(?P<word>twice|half|double|(?:\w+|\d+(?:\.\d+)?)\s+times)\s+)?"
_BODIES = re.compile(
    _RATIO + r"(?:as\s+(?P<same>heavy|big|large)\s+as|the\s+(?P<noun>mass|weight|size)\s+of"
    r"|(?P<more>heavier|bigger|larger)\s+than)\b",
    re.IGNORECASE,
)
_SPEEDS = re.compile(
    _RATIO + r"(?:(?P<as>as)\s+(?:fast|quickly|quick)\s+as|(?P<more>faster|quicker)\s+than"
    r"|(?P<less>slower)\s+than|(?:at\s+)?the\s+(?P<same>same\s+)?speed\s+(?:of|as))\b",
    re.IGNORECASE,
)
_MASS = lex.word_set("mass")


def compare(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Applies every comparison between the masses or the sizes of two objects of the scene.

    The mass or size compared with is the one stated, else the commonsense one; the result counts
    as prescribed if the other is. "Heavier than" alone means twice as heavy.
    """
    for match in _BODIES.finditer(text):
        left, right = _compared(match, mentions, scene)
        if left is None or right is None or (match["noun"] and not match["word"]):
            continue
        factor = _ratio(match["word"]) if match["word"] else 2.0 if match["more"] else 1.0
        required = requirement(right)
        if (match["same"] or match["noun"] or match["more"]).lower() in _MASS:
            if not left.mass_prescribed:
                left.mass_kg = factor * required.expected_mass_kg
                left.mass_prescribed = right.mass_prescribed
        elif not left.dimensions_prescribed:
            left.dimensions_cm = [factor * x for x in required.expected_dimensions_cm]
            left.dimensions_prescribed = right.dimensions_prescribed


def compare_speeds(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Applies "twice as fast as", "three times faster than", "at the same speed as".

    A ratio of a prescribed speed is prescribed too; "faster than" without a ratio leaves an
    interval above the other speed.
    """
    movers = {edge.actor for edge in scene.timeline.edges}
    for match in _SPEEDS.finditer(text):
        left, right = _compared(match, mentions, scene, movers)
        bare = not any(match.groupdict().values())
        if left is None or right is None or bare:
            continue
        known = scene.timeline.stated_speed(right.id)
        if known is None or scene.timeline.stated_speed(left.id) is not None:
            continue
        low, high = known if isinstance(known, tuple) else (known, known)
        exact = bool(match["word"]) or not (match["more"] or match["less"])
        if exact:
            ratio = _ratio(match["word"]) if match["word"] else 1.0
            low, high = ratio * low, ratio * high
        elif match["more"]:
            low, high = 1.05 * high, 2.0 * high
        else:
            low, high = 0.4 * low, 0.95 * low
        scene.timeline.set_speed(left.id, low if low == high else (low, high), prescribed=exact)


def _ratio(word: str) -> float:
    """The ratio that "twice" or "three times" states."""
    named = {"twice": 2.0, "double": 2.0, "half": 0.5}.get(word.lower())
    value = named or parse_number(word.lower().removesuffix("times").strip())
    return value if isinstance(value, float) and value > 0.0 else 1.0


def _compared(
    match: re.Match[str], mentions: list[Mention], scene: Scene, movers: Container[str] = ()
) -> tuple[Entity | None, Entity | None]:
    """The things named just before (what moves first of all) and just after a comparison."""
    named: list[tuple[Mention, Entity]] = []
    for m in sorted(mentions, key=lambda m: m.start):
        ids = [i for i in scene.world.resolved.get(id(m), []) if i in scene.world.entities]
        if ids:
            named.append((m, scene.world.entities[ids[0]]))
    right = next((e for m, e in named if m.start >= match.end() - 1), None)
    before = [e for m, e in reversed(named) if m.end <= match.start() + 1 and e is not right]
    before.sort(key=lambda e: e.id not in movers)
    return (before[0] if before else None), right
