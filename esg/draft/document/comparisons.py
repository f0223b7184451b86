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

_COMPARISON = re.compile(
    r"\b(?:(?P<ratio>twice|half|double|(?:\w+|\d+(?:\.\d+)?)\s+times)\s+)?"
    r"(?:as\s+(?P<as>heavy|big|large|fast|quickly|quick)\s+as"
    r"|(?P<more>heavier|bigger|larger|faster|quicker)\s+than|(?P<less>slower)\s+than"
    r"|the\s+(?P<same>same\s+)?(?P<noun>mass|weight|size|speed)\s+(?:of|as))\b",
    re.IGNORECASE,
)
_MASS = lex.word_set("mass")
_SPEED = frozenset({"fast", "quickly", "quick", "faster", "quicker", "slower", "speed"})


def compare(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Applies every comparison between two objects of the scene.

    What is compared with is the value stated, else the commonsense one; the result counts as
    prescribed if the other is. "Heavier than" alone means twice as heavy; "faster than" leaves an
    interval above the other speed, and applies only where that is stated.
    """
    movers = {edge.actor for edge in scene.timeline.edges}
    for match in _COMPARISON.finditer(text):
        word = (match["as"] or match["more"] or match["less"] or match["noun"]).lower()
        left, right = _compared(match, mentions, scene, movers if word in _SPEED else ())
        if (
            left is None
            or right is None
            or (match["noun"] and not (match["ratio"] or match["same"]))
        ):
            continue
        ratio = _ratio(match["ratio"]) if match["ratio"] else None
        if word in _SPEED:
            _set_speed(left, right, ratio, match, scene)
            continue
        factor = ratio or (2.0 if match["more"] else 1.0)
        required = requirement(right)
        if word in _MASS and not left.mass_prescribed:
            left.mass_kg = factor * required.expected_mass_kg
            left.mass_prescribed = right.mass_prescribed
        elif word not in _MASS and not left.dimensions_prescribed:
            left.dimensions_cm = [factor * x for x in required.expected_dimensions_cm]
            left.dimensions_prescribed = right.dimensions_prescribed


def _set_speed(
    left: Entity, right: Entity, ratio: float | None, match: re.Match[str], scene: Scene
) -> None:
    known = scene.timeline.stated_speed(right.id)
    if known is None or scene.timeline.stated_speed(left.id) is not None:
        return
    low, high = known if isinstance(known, tuple) else (known, known)
    exact = ratio is not None or not (match["more"] or match["less"])
    if exact:
        low, high = (ratio or 1.0) * low, (ratio or 1.0) * high
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
    match: re.Match[str], mentions: list[Mention], scene: Scene, movers: Container[str]
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
