"""Comparisons of mass, size and speed: "twice as heavy as the other", "faster than B"."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
import itertools
import math
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.scene import Scene
from esg.draft.document.requirements import requirement
from esg.draft.text.elements import Mention
from esg.draft.text.numerals import parse_number

_COMPARISON = re.compile(
    r"\b(?:(?P<ratio>twice|half|double|(?:\w+|\d+(?:\.\d+)?)\s+times)\s+)?"
    r"(?:as\s+(?P<as>heavy|big|large|fast|quickly|quick|tall|high|long|wide|broad|thick|deep)\s+as"
    r"|(?P<more>heavier|bigger|larger|faster|quicker)\s+than|(?P<less>slower)\s+than"
    r"|the\s+(?P<same>same\s+)?(?P<noun>mass|weight|size|speed|height|length|width)\s+(?:of|as))\b",
    re.IGNORECASE,
)
_MASS = lex.word_set("mass")
_SIDES = {
    "tall": "height", "high": "height", "long": "length", "wide": "width", "broad": "width",
    "thick": "width", "deep": "width",
}  # fmt: skip
"""Sides by the adjectives that compare them."""
_SPEED = lex.word_set("compares speeds")


_EQUAL = re.compile(
    r"\b(?:of|with|at)\s+(?:the\s+)?(?:same|equal)\s+"
    r"(?:size|mass|weight|diameter|height|length|width|speed)\b(?!\s+of\s+\S*\d)",
    re.IGNORECASE,
)
_MORE = re.compile(
    rf"\b(?:{'|'.join(sorted(lex.word_set('size comparisons (unclaimed)')))})\b"
    r"(?!\s+than\s+(?:about\s+)?\S*\d)",
    re.IGNORECASE,
)
CONTRAST = 0.8
"""Share of the ratio of their adjectives that a big and a little one differ by at least."""
_NUMBER = re.compile(r"\s+(?:about\s+|roughly\s+)?\S*\d")
_NO_MORE = re.compile(r"\b(?:no|not|any|a|an|the|one|its|his|her)\s+$", re.IGNORECASE)


def not_compared(text: str, mentions: list[Mention], scene: Scene) -> Iterator[tuple[int, int]]:
    """Where a text compares or equals what nothing in the scene does ("bounces much higher").

    What stands in a noun phrase tells things apart ("the larger box"); what is one of several that
    are alike has their size and mass ("two balls of the same size").
    """
    drawn = [(m.start, m.end) for m in mentions if scene.world.resolved.get(id(m))]
    alike = [m.end for m in mentions if len(scene.world.resolved.get(id(m), [])) > 1]
    for words in (_COMPARISON, _EQUAL, _MORE):
        for m in words.finditer(text):
            noun = words is _COMPARISON and m["noun"] is not None
            if noun or _NO_MORE.search(text, 0, m.start()) or _NUMBER.match(text, m.end()):
                continue
            told = any(a < m.end() and m.start() < b for a, b in (*drawn, *scene.compared))
            same = words is _EQUAL and any(0 <= m.start() - end <= 1 for end in alike)
            if not told and not same:
                yield m.span()


def compare(text: str, mentions: list[Mention], scene: Scene) -> None:
    """Applies every comparison between two objects of the scene.

    What is compared with is the value stated, else the commonsense one; the result counts as
    prescribed if the other is. "Heavier than" alone means twice as heavy; "faster than" leaves an
    interval above the other speed, and applies only where that is stated. A size keeps the shape of
    what has it: as tall as the other, or of its volume. What is only there to be compared with ("as
    tall as a chair") is no thing of the scene, and the size is stated.
    """
    movers = {edge.actor for edge in scene.timeline.edges}
    for match in _COMPARISON.finditer(text):
        word = (match["as"] or match["more"] or match["less"] or match["noun"]).lower()
        left, right, told = _compared(match, mentions, scene, movers if word in _SPEED else ())
        if left is None or right is None or told is None:
            continue
        only = word not in _SPEED and _only_compared(told, right, scene)
        if match["noun"] and not (match["ratio"] or match["same"] or only):
            continue
        ratio = _ratio(match["ratio"]) if match["ratio"] else None
        if word in _SPEED:
            if _set_speed(left, right, ratio, match, scene):
                scene.compared.append(match.span())
            continue
        free = not (left.mass_prescribed if word in _MASS else left.dimensions_prescribed)
        if free or only:
            scene.compared.append(match.span())
        if free:
            factor = ratio or (2.0 if match["more"] else 1.0)
            _measure_by(left, right, word, factor, only)
        if only:
            told.attribute = True
            del scene.world.entities[right.id]


def _measure_by(left: Entity, right: Entity, word: str, factor: float, only: bool) -> None:
    """Gives a thing so many times the mass or the size of another, as prescribed as that is."""
    required = requirement(right)
    if word in _MASS:
        left.mass_kg = factor * required.expected_mass_kg
        left.mass_prescribed = right.mass_prescribed
        return
    mine = requirement(left).expected_dimensions_cm
    scale = factor * _measure(word, required.expected_dimensions_cm) / _measure(word, mine)
    left.dimensions_cm = [scale * x for x in mine]
    left.dimensions_prescribed = right.dimensions_prescribed or only


def contrast(scene: Scene) -> None:
    """Draws the big one of a kind larger than the little one, whatever each is made of.

    "A big steel ball pushes a little wooden ball": steel balls are small, balls to play with are
    not. The little one gives way where its size is not stated, else the big one.
    """
    things = [e for e in scene.world.entities.values() if "structural" not in e.noun.traits]
    for big, little in itertools.permutations(things, 2):
        if big.head.split()[-1:] != little.head.split()[-1:]:
            continue
        scales = [lex.SIZES[a] for a in big.adjectives if a in lex.SIZES]
        others = [lex.SIZES[a] for a in little.adjectives if a in lex.SIZES]
        if not scales or not others or min(scales) <= 1.0 or max(others) >= 1.0:
            continue
        own, other = (requirement(e).expected_dimensions_cm for e in (big, little))
        least = min(scales) / max(others)
        now = _measure("", own) / _measure("", other)
        if now >= CONTRAST * least:
            continue
        if not little.dimensions_prescribed:
            little.dimensions_cm = [x * now / least for x in other]
        elif not big.dimensions_prescribed:
            big.dimensions_cm = [x * least / now for x in own]


def _measure(word: str, size: Sequence[float]) -> float:
    """What a word compares of a size: one side, else the side of a cube of its volume [cm]."""
    length, width, height = size
    sides = {"height": height, "length": max(length, width), "width": min(length, width)}
    cube = math.cbrt(length * width * height)
    return sides.get(_SIDES.get(word, word), cube)


def _only_compared(told: Mention, e: Entity, scene: Scene) -> bool:
    """Whether a thing is named only to say how large another one is."""
    if told.determiner not in ("a", "an") or told.plural or e.group is not None:
        return False
    named = [ids for ids in scene.world.resolved.values() if e.id in ids]
    timeline = scene.timeline
    acts = any(e.id in n.participants for n in timeline.nodes)
    acts = acts or any(e.id in (edge.actor, edge.target) for edge in timeline.edges)
    places = (scene.supported_by, scene.inside_of, scene.attached, scene.marked, scene.facing)
    placed = any(e.id in place or e.id in place.values() for place in places)
    related = any(e.id in (r.source, r.target) for r in scene.relations)
    return len(named) == 1 and not (acts or placed or related)


def _set_speed(
    left: Entity, right: Entity, ratio: float | None, match: re.Match[str], scene: Scene
) -> bool:
    known = scene.timeline.stated_speed(right.id)
    if known is None or scene.timeline.stated_speed(left.id) is not None:
        return False
    low, high = known if isinstance(known, tuple) else (known, known)
    exact = ratio is not None or not (match["more"] or match["less"])
    if exact:
        low, high = (ratio or 1.0) * low, (ratio or 1.0) * high
    elif match["more"]:
        low, high = 1.05 * high, 2.0 * high
    else:
        low, high = 0.4 * low, 0.95 * low
    scene.timeline.set_speed(left.id, low if low == high else (low, high), prescribed=exact)
    return True


def _ratio(word: str) -> float:
    """The ratio that "twice" or "three times" states."""
    named = {"twice": 2.0, "double": 2.0, "half": 0.5}.get(word.lower())
    value = named or parse_number(word.lower().removesuffix("times").strip())
    return value if isinstance(value, float) and value > 0.0 else 1.0


def _compared(
    match: re.Match[str], mentions: list[Mention], scene: Scene, movers: Container[str]
) -> tuple[Entity | None, Entity | None, Mention | None]:
    """The things named just before (what moves first of all) and just after a comparison."""
    named: list[tuple[Mention, Entity]] = []
    for m in sorted(mentions, key=lambda m: m.start):
        ids = [i for i in scene.world.resolved.get(id(m), []) if i in scene.world.entities]
        if ids:
            named.append((m, scene.world.entities[ids[0]]))
    told, right = next(((m, e) for m, e in named if m.start >= match.end() - 1), (None, None))
    before = [e for m, e in reversed(named) if m.end <= match.start() + 1 and e is not right]
    before.sort(key=lambda e: e.id not in movers)
    return (before[0] if before else None), right, told
