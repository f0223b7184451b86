"""Comparisons of mass, size and speed: "twice as heavy as the other", "faster than B"."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import Scene
from esg.draft.document.requirements import requirement
from esg.draft.text.elements import Mention
from esg.draft.text.numerals import parse_number

_PATTERN = re.compile(
    r"\b(?:(?P<word>twice|half|double|(?:\w+|\d+(?:\.\d+)?)\s+times)\s+)?"
    r"(?:as\s+(?P<same>heavy|big|large|tall|wide|long|high)\s+as"
    r"|(?:the\s+(?P<noun>mass|weight|size|height)\s+of)"
    r"|(?P<more>heavier|bigger|larger|taller)\s+than)\b",
    re.IGNORECASE,
)
_MASS = lex.word_set("mass")


def factor_of(match: re.Match[str]) -> float:
    """The ratio that a comparison states; "heavier than" alone means twice."""
    word = (match["word"] or "").lower()
    if word.endswith("times"):
        value = parse_number(word.removesuffix("times").strip())
        return value if isinstance(value, float) and value > 0.0 else 1.0
    if word.endswith(" of"):
        percent = re.match(r"\d+(?=\s*(?:%|per))", word)
        if percent is not None:
            return 0.01 * float(percent.group())
        share = parse_number(f"{word} a")
        return share if isinstance(share, float) and share > 0.0 else 1.0
    if word:
        return {"twice": 2.0, "double": 2.0, "half": 0.5}[word]
    return 2.0 if match.groupdict().get("more") else 1.0


def compare(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Applies every comparison between two objects of the scene.

    The mass compared with is the one stated, else the commonsense one; the result counts as
    prescribed if the other is.
    """
    for match in _PATTERN.finditer(text):
        if match["noun"] and not match["word"]:
            continue
        left = _nearest(mentions, scene, match.start(), before=True)
        right = _nearest(mentions, scene, match.end(), before=False)
        if left is None or right is None or left is right:
            continue
        factor = factor_of(match)
        kind = (match["same"] or match["noun"] or match["more"]).lower()
        required = requirement(right)
        if kind in _MASS:
            if not left.mass_prescribed:
                left.mass_kg = factor * required.expected_mass_kg
                left.mass_prescribed = right.mass_prescribed
            continue
        size = [factor * x for x in required.expected_dimensions_cm]
        if kind in ("tall", "high", "height", "taller"):
            size = [*requirement(left).expected_dimensions_cm[:2], size[2]]
        if not left.dimensions_prescribed:
            left.dimensions_cm = size
            left.dimensions_prescribed = right.dimensions_prescribed


def _nearest(mentions: list[Mention], scene: Scene, at: int, *, before: bool) -> Entity | None:
    """The single object named just before or after a position."""
    found: Entity | None = None
    for m in sorted(mentions, key=lambda m: m.start):
        ids = [i for i in scene.world.resolved.get(id(m), []) if i in scene.world.entities]
        if not ids:
            continue
        if before and m.end <= at + 1:
            found = scene.world.entities[ids[0]]
        elif not before and m.start >= at - 1:
            return scene.world.entities[ids[0]]
    return found if before else None


_OWN = re.compile(
    r"\b(?:at|with|doing|does)\s+(?:only\s+|about\s+|just\s+)?"
    r"(?P<word>half|twice|double|(?:\w+|\d+(?:\.\d+)?)\s+times|\d+\s*(?:%|per\s*cent)\s+of"
    r"|(?:an?|one|two|three|four)\s+(?:third|quarter|fifth|tenth)s?\s+of)\s+(?:its|their|his|her|this|that|the)\s+"
    r"(?:\w+'s\s+)?(?:speed|velocity|pace)\b(?P<of>\s+of\b)?",
    re.IGNORECASE,
)
""" "at half its speed": of what was told to move before."""
_SPEED = re.compile(
    r"\b(?:(?P<word>twice|half|double|(?:\w+|\d+(?:\.\d+)?)\s+times)\s+)?"
    r"(?:as\s+(?:fast|quickly|quick)\s+as|(?P<more>faster|quicker)\s+than|(?P<less>slower)\s+than"
    r"|(?:at\s+)?the\s+(?P<same>same\s+)?speed\s+(?:of|as))\b",
    re.IGNORECASE,
)


def compare_speeds(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Applies "twice as fast as", "three times faster than", "at the same speed as".

    A ratio of a prescribed speed is prescribed too; "faster than" without a ratio leaves an
    interval above the other speed.
    """
    _shares_of_speed(text, mentions, scene)
    for match in _SPEED.finditer(text):
        bare = not (match["word"] or match["more"] or match["less"] or match["same"])
        if bare and not match.group().lower().startswith("as"):
            continue
        right = _nearest(mentions, scene, match.end(), before=False)
        left = _nearest(mentions, scene, match.start(), before=True)
        if left is not None and scene.timeline.stated_speed(left.id) is None and right is not None:
            left = _mover(mentions, scene, match.start(), {right.id}) or left
        if left is None or right is None or left is right:
            continue
        known = scene.timeline.stated_speed(right.id)
        if known is None or scene.timeline.stated_speed(left.id) is not None:
            continue
        low, high = known if isinstance(known, tuple) else (known, known)
        ratio = factor_of(match) if match["word"] else 1.0
        if match["word"] or not (match["more"] or match["less"]):
            a, b = ratio * low, ratio * high
        else:
            a, b = (1.05 * high, 2.0 * high) if match["more"] else (0.4 * low, 0.95 * low)
        exact = bool(match["word"]) or not (match["more"] or match["less"])
        scene.timeline.set_speed(left.id, a if a == b else (a, b), prescribed=exact)


def _mover(mentions: list[Mention], scene: Scene, at: int, without: set[str]) -> Entity | None:
    """What moves of all that is named in the sentence up to a position, the last one named."""
    moving = {e.actor for e in scene.timeline.edges}
    start = max(scene.text.rfind(c, 0, at) for c in ".;!?")
    found: Entity | None = None
    for m in sorted(mentions, key=lambda m: m.start):
        ids = [i for i in scene.world.resolved.get(id(m), []) if i in scene.world.entities]
        if ids and start < m.start and m.end <= at + 1 and ids[0] in moving - without:
            found = scene.world.entities[ids[0]]
    return found


def _shares_of_speed(text: str, mentions: list[Mention], scene: Scene) -> None:
    """ "the blue one at half its speed": a share of the speed of what was told before."""
    for match in _OWN.finditer(text):
        left = _nearest(mentions, scene, match.start(), before=True)
        if left is not None and match["of"] and scene.timeline.stated_speed(left.id) is not None:
            of = _nearest(mentions, scene, match.end(), before=False)
            left = _mover(mentions, scene, match.start(), {of.id}) if of is not None else None
        if left is None:
            continue
        own = scene.timeline.stated_speed(left.id)
        if match["of"]:
            right = _nearest(mentions, scene, match.end(), before=False)
        else:
            before = [m for m in mentions if m.end < match.start()]
            others = [
                i
                for m in sorted(before, key=lambda m: -m.start)
                for i in scene.world.resolved.get(id(m), [])
                if i != left.id and scene.timeline.stated_speed(i) is not None
            ]
            right = scene.world.entities.get(others[0]) if others else None
        known = scene.timeline.stated_speed(right.id) if right is not None else None
        if known is None or own not in (None, known):  # the same: taken over with the verb
            continue
        low, high = known if isinstance(known, tuple) else (known, known)
        ratio = factor_of(match)
        a, b = ratio * low, ratio * high
        value = a if a == b else (a, b)
        if not scene.timeline.leaves_hit_at(left.id, value):
            scene.timeline.set_speed(left.id, value, prescribed=True)
