"""Binds the noun phrases of a suite to the bodies and regions of a scene.

By head noun first, then by identifier, ordinal, class modifier, colour and position (suite format,
"Participants"). Binding is conservative: contradicting evidence excludes a body, and a phrase that
binds to nothing yields an empty Binding with the reason, never an exception.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
import math
import re

import numpy as np

from esg.engines.scene import FRAGMENT, GROUND, Body, SimScene
from esg.metrics.normalization import normalize
from esg.metrics.phrases import (
    COLORS,
    COMPARISONS,
    COMPOUNDS,
    GROUND_WORDS,
    HYPERNYMS,
    OPPOSITE,
    ORDINALS,
    PORTIONS,
    POSITIONS,
    RELATED,
    Phrase,
    canonical_modifier,
    members_of,
    parse,
)
from esg.metrics.regions import bind_regions, loose_regions
from esg.units import quat_rotate

_COLOR_DISTANCE = 0.35
_ALIKE = 0.01
"""Who differs by no more than this share of a quantity is alike in it."""
_KIND_OF = 1.0
"""Least level of a candidate that is of the asked kind, not only a relative of it."""


@dataclass(frozen=True)
class Binding:
    """What a phrase stands for in a scene.

    Args:
        phrase: As the suite wrote it.
        bodies: Indices into `SimScene.bodies`.
        regions: Indices into `SimScene.regions` (only where a target was asked for).
        ground: The phrase also means the ground half-space.
        point: World position [m] of an exact point reference, shape [3].
        plural: The phrase names a set.
        problem: Why the prescribed objects are missing; empty when they are all there.
    """

    phrase: str
    bodies: tuple[int, ...] = ()
    regions: tuple[int, ...] = ()
    ground: bool = False
    point: tuple[float, float, float] | None = None
    plural: bool = False
    problem: str = ""

    @property
    def bound(self) -> bool:
        """Whether the phrase stands for anything."""
        return bool(self.bodies or self.regions or self.ground or self.point)

    def names(self, scene: SimScene) -> tuple[str, ...]:
        """Names of everything bound, bodies first."""
        out = [scene.bodies[i].name for i in self.bodies]
        out += [scene.regions[i].name for i in self.regions]
        if self.ground:
            out.append(GROUND)
        if self.point:
            out.append("@" + ",".join(f"{x:g}" for x in self.point))
        return tuple(out)


def own_parts(binding: Binding, scene: SimScene) -> tuple[int, ...]:
    """Bodies that move on hinges and slides of what is bound and are called parts of it.

    A "windmill blade" is a part of the windmill that carries it, a "fridge door" of the fridge. A
    wrecking ball is none of its crane: nothing calls it a crane's, and a rope is no hinge.

    Args:
        binding: Of a phrase.
        scene: Its scene.

    Returns:
        Their indices into `SimScene.bodies`.
    """
    out: list[int] = []
    for joint in scene.joints:
        whole = next((i for i in binding.bodies if scene.bodies[i].name == joint.parent), None)
        if whole is not None and joint.kind in ("hinge", "slider"):
            child = scene.body(joint.child)
            if parse(scene.bodies[whole].label).head in parse(child.label).modifiers:
                out.append(scene.index(joint.child))
    return tuple(out)


@dataclass
class _Candidate:
    index: int
    body: Body
    level: float
    fields: list[Phrase] = field(default_factory=list[Phrase])
    words: set[str] = field(default_factory=set[str])
    called: frozenset[str] = frozenset()


def bind(phrase: str, scene: SimScene, *, target: bool = False) -> Binding:
    """Binds one phrase.

    Args:
        phrase: Noun phrase, or an exact reference ("=name", "=a,b", "=node/region", "@x,y,z").
        scene: The scene.
        target: Whether regions may be meant (targets of enters and reaches).

    Returns:
        The binding; `problem` says what is missing.
    """
    text = phrase.strip()
    if text.startswith("="):
        return _bind_exact(phrase, text[1:], scene)
    if text.startswith("@"):
        return _bind_point(phrase, text[1:])
    parsed = parse(text)
    if not parsed.head:
        return Binding(phrase, problem=f"{phrase!r} has no noun")
    regions: tuple[int, ...] = ()
    if target:
        regions = bind_regions(parsed, scene)
        if regions:
            return Binding(phrase, regions=regions, plural=parsed.plural)
    bodies = _bind_bodies(parsed, scene)
    members = None if bodies else members_of(parsed)
    if members is not None and (made_of := _bind_bodies(members, scene)):
        parsed, bodies = members, made_of
    if not bodies and target:
        regions = loose_regions(parsed, scene)
        if regions:
            return Binding(phrase, regions=regions, plural=parsed.plural)
    if not bodies and (told := _bind_by_what_it_is_of(parsed, scene)):
        return Binding(phrase, told, plural=len(told) > 1)
    if not bodies and parsed.head in GROUND_WORDS:
        return Binding(phrase, ground=True)
    if not bodies:
        return Binding(phrase, plural=parsed.plural, problem=_why_not(phrase, parsed, scene))
    ground = parsed.head in GROUND_WORDS and all(not scene.bodies[i].collides for i in bodies)
    need = parsed.count or (2 if parsed.plural and not _is_distributive(text) else 1)
    problem = ""
    if len(bodies) < need and not ground:
        names = ", ".join(scene.bodies[i].name for i in bodies)
        problem = f"{phrase!r} asks for {need} objects, the scene has {len(bodies)} ({names})"
    return Binding(phrase, bodies, ground=ground, plural=parsed.plural, problem=problem)


def named(noun: str, scene: SimScene, *, every: bool = False) -> tuple[int, ...]:
    """Bodies that a noun names as a kind, not one of them that a phrase singles out.

    Args:
        noun: A noun, with or without attributes ("red ball").
        scene: The scene.
        every: Whether its attributes do not matter, and what nobody mentioned counts too.
    """
    wanted = replace(parse(noun), plural=True, count=None)
    if not every:
        return _bind_bodies(wanted, scene)
    found = [c for i, b in enumerate(scene.bodies) if (c := _candidate(i, b, wanted)) is not None]
    # A relative is another kind: where no desk is asked for, a table may stand.
    return tuple(c.index for c in found if c.level >= _KIND_OF)


def _is_distributive(text: str) -> bool:
    words = normalize(text).split()
    return bool(words) and (words[0] in ("one", "any", "each", "every", "either"))


def _bind_exact(phrase: str, text: str, scene: SimScene) -> Binding:
    bodies: list[int] = []
    regions: list[int] = []
    missing: list[str] = []
    names = {b.name: i for i, b in enumerate(scene.bodies)}
    region_names = {r.name: i for i, r in enumerate(scene.regions)}
    wanted = [part.strip() for part in text.split(",") if part.strip()]
    for name in wanted:
        if name in names:
            bodies.append(names[name])
        elif name in region_names:
            regions.append(region_names[name])
        elif name != GROUND:
            missing.append(name)
    problem = f"no body or region is called {', '.join(map(repr, missing))}" if missing else ""
    if not wanted:
        problem = f"{phrase!r} names nothing; write '=name'"
    return Binding(
        phrase,
        tuple(bodies),
        tuple(regions),
        ground=GROUND in wanted,
        plural=len(wanted) > 1,
        problem=problem,
    )


def _bind_point(phrase: str, text: str) -> Binding:
    try:
        values = tuple(float(x) for x in text.split(","))
    except ValueError:
        values = ()
    if len(values) != 3 or not all(math.isfinite(v) for v in values):
        return Binding(phrase, problem=f"{phrase!r} is not a point; write '@x,y,z' in metres")
    return Binding(phrase, point=values)  # type: ignore[arg-type]  # length checked above


def _strip_number(name: str) -> str:
    return re.sub(r"[_\-\s]+\d+$", "", name)


def _number(name: str) -> int:
    match = re.search(r"(\d+)$", name)
    return int(match[1]) if match else 0


def _candidate(index: int, body: Body, wanted: Phrase) -> _Candidate | None:
    if body.category == FRAGMENT:
        return None
    label = parse(body.label) if body.label else None
    name = parse(_strip_number(body.name))
    category = parse(body.category) if body.category else None
    group = parse(body.group) if body.group else None
    chunk = re.split(r",|;|\.| with | on | in | for | of | at ", body.description + " ")[0]
    described = parse(chunk) if chunk.strip() else None
    level = 0.0
    for source, weight in (
        (label, 4.0),
        (name, 4.0),
        (group, 3.5),
        (category, 3.0),
        (described, 2.0),
    ):
        if source is None or not source.head:
            continue
        if source.head == wanted.head:
            level = max(level, weight)
        elif source.head in HYPERNYMS.get(wanted.head, ()):
            level = max(level, 1.0 + weight / 10)
        elif source.head in RELATED.get(wanted.head, ()):
            level = max(level, 0.5 + weight / 10)
    if not level:
        return None
    fields = [p for p in (label, name, category, group) if p is not None]
    words = {w for p in fields for w in p.modifiers}
    words |= {canonical_modifier(w) for p in fields for w in p.text.split()}
    words |= {canonical_modifier(w) for w in normalize(body.description).split()}
    called = frozenset(p.word for p in (label, name) if p is not None)
    return _Candidate(index, body, level, fields, words, called)


def _by_modifiers(found: list[_Candidate], wanted: Phrase) -> list[_Candidate]:
    """Words that at least one candidate carries decide between candidates; others say nothing."""
    for word in wanted.modifiers:
        if word in COLORS or word in POSITIONS or word in COMPARISONS:
            continue
        found = [c for c in found if word in c.words] or found
    return found


def _bind_bodies(wanted: Phrase, scene: SimScene) -> tuple[int, ...]:
    found = [c for i, b in enumerate(scene.bodies) if (c := _candidate(i, b, wanted)) is not None]
    exact = [c for c in found if c.body.label and normalize(c.body.label) == wanted.text]
    if exact and not wanted.plural:
        found = exact
    found = [c for c in found if not _contradicts(c, wanted, found)]
    if not found:
        return _bind_alias(wanted, scene)
    best = max(c.level for c in found)
    found = [c for c in found if c.level == best]
    if any(c.body.mentioned for c in found):
        found = [c for c in found if c.body.mentioned]
    if not wanted.plural or wanted.word != wanted.head:
        # Of a sedan and a hatchback, both cars, "the sedan" is the one that is called so.
        found = [c for c in found if wanted.word in c.called] or found
    found = _by_modifiers(found, wanted)
    found = _by_color(found, wanted)
    found = _by_identifier(found, wanted)
    found = _by_position(found, wanted)
    found = _by_comparison(found, wanted, scene)
    found = _by_ordinal(found, wanted)
    if not found:
        return _bind_alias(wanted, scene)
    if not wanted.plural and len(found) > 1:
        found = _prefer_plain(found, wanted)
    return tuple(c.index for c in found)


def _contradicts(c: _Candidate, wanted: Phrase, found: list[_Candidate]) -> bool:
    """Whether the body's own texts rule it out."""
    if wanted.classes:
        own = frozenset[str]().union(*(p.classes for p in c.fields))
        if own and not own & wanted.classes:
            return True
        if not own and any(wanted.classes & frozenset(o.words) for o in found if o is not c):
            return True
    if wanted.colors:
        own = frozenset[str]().union(*(p.colors for p in c.fields))
        if own and not own & wanted.colors:
            return True
    positions = frozenset[str]().union(*(p.positions for p in c.fields))
    if any(OPPOSITE.get(p) in positions and p not in positions for p in wanted.positions):
        return True
    if wanted.identifier:
        label_ids = {p.identifier for p in c.fields if p.identifier}
        if label_ids and wanted.identifier not in label_ids:
            return True
    return False


def _by_color(found: list[_Candidate], wanted: Phrase) -> list[_Candidate]:
    for color in wanted.colors:
        having = [c for c in found if color in c.words]
        if having:
            found = having
            continue
        if len(found) <= 1:
            return found
        reference = np.array(COLORS[color])
        distance = [float(np.linalg.norm(np.array(c.body.color) - reference)) for c in found]
        close = [c for c, d in zip(found, distance, strict=True) if d <= _COLOR_DISTANCE]
        if close and not wanted.plural:
            nearest = min(distance)
            close = [c for c, d in zip(found, distance, strict=True) if d <= nearest + 1e-6]
        found = close
    return found


def _by_identifier(found: list[_Candidate], wanted: Phrase) -> list[_Candidate]:
    if wanted.identifier is None:
        return found
    having = [c for c in found if any(p.identifier == wanted.identifier for p in c.fields)]
    if having:
        return having
    if any(p.identifier for c in found for p in c.fields):
        return []
    if wanted.identifier.isdigit():
        return [c for c in found if _number(c.body.name) == int(wanted.identifier)]
    # Nothing carries letters: A is the first of them, in the scene's own numbering.
    place = ord(wanted.identifier) - ord("a")
    ordered = sorted(found, key=lambda c: (_number(c.body.name), c.index))
    return ordered[place : place + 1]


def _by_ordinal(found: list[_Candidate], wanted: Phrase) -> list[_Candidate]:
    if wanted.ordinal is None:
        return found
    labelled = [c for c in found if any(p.ordinal == wanted.ordinal for p in c.fields)]
    if labelled:
        return labelled
    words = {w for w, n in ORDINALS.items() if n == wanted.ordinal}
    written = [c for c in found if words & c.words]
    if written:
        return written
    # "a wagon, a second wagon": the first is the one that nobody calls the second.
    others = [{p.ordinal for p in c.fields if p.ordinal is not None} for c in found]
    before = len({n for own in others for n in own if 0 < n < wanted.ordinal})
    if wanted.ordinal == -1:
        return sorted(found, key=lambda c: (_number(c.body.name), c.index))[-1:]
    plain = [c for c, own in zip(found, others, strict=True) if not own]
    ordered = sorted(plain, key=lambda c: (_number(c.body.name), c.index))
    place = wanted.ordinal - 1 - before
    return ordered[place : place + 1]


def _by_position(found: list[_Candidate], wanted: Phrase) -> list[_Candidate]:
    for position in sorted(wanted.positions):
        labelled = [c for c in found if any(position in p.positions for p in c.fields)]
        if labelled:
            found = labelled
            continue
        if len(found) <= 1:
            continue
        key = [_position_key(c.body, position, found) for c in found]
        if position == "middle":
            order = sorted(range(len(found)), key=lambda i: key[i])
            found = [found[order[len(order) // 2]]]
            continue
        found = [c for c, k in zip(found, key, strict=True) if k >= max(key) - 1e-6]
    return found


def _by_comparison(found: list[_Candidate], wanted: Phrase, scene: SimScene) -> list[_Candidate]:
    """The most or the least of something, as simulated; nobody where all are alike in it."""
    for word in (w for w in wanted.modifiers if w in COMPARISONS):
        if len(found) <= 1:
            continue
        quantity, sign = COMPARISONS[word]
        key = [sign * k for k in _compared(found, quantity, scene)]
        order = sorted(range(len(found)), key=lambda i: -key[i])
        keep = (wanted.count or 2) if wanted.plural else 1
        if keep < len(found):
            last, next_ = key[order[keep - 1]], key[order[keep]]
            if abs(last - next_) <= _ALIKE * max(abs(last), abs(next_)):
                return []
        found = [found[i] for i in sorted(order[:keep])]
    return found


def _compared(found: list[_Candidate], quantity: str, scene: SimScene) -> list[float]:
    """What a comparison of candidates goes by [kg or m]."""
    if quantity == "distance":
        names = {c.body.name for c in found}
        movers = [b for b in scene.bodies if b.active and b.name not in names]
        if not movers:
            # Nobody is there to be near to but the viewer, who stands at +Y.
            return [-c.body.position[1] for c in found]
        return [min(math.dist(c.body.position, m.position) for m in movers) for c in found]
    return [_MEASURES[quantity](c.body) for c in found]


_MEASURES: dict[str, Callable[[Body], float]] = {
    "mass": lambda b: b.mass,
    "height": lambda b: b.half_extents[2],
    "length": lambda b: max(b.half_extents[:2]),
    "width": lambda b: min(b.half_extents[:2]),
    "size": lambda b: math.prod(b.half_extents) ** (1.0 / 3.0),
    "altitude": lambda b: b.position[2],
}


def _position_key(body: Body, position: str, found: list[_Candidate]) -> float:
    """Coordinate that is largest for the body which `position` describes."""
    place = np.array(body.position)
    if position in ("left", "right"):
        return float(place[0]) if position == "left" else -float(place[0])
    if position in ("top", "bottom"):
        return float(place[2]) if position == "top" else -float(place[2])
    if position == "middle":
        spread = np.ptp(np.array([c.body.position for c in found]), axis=0)
        return float(place[int(np.argmax(spread))])
    headings = [quat_rotate(np.array(c.body.quaternion), np.array([1.0, 0, 0])) for c in found]
    forward = np.sum(headings, axis=0)
    forward[2] = 0.0
    # Bodies that face each other have no common front: the viewer's front (+Y) decides.
    if np.linalg.norm(forward) < 0.5 * len(found):
        forward = np.array([0.0, 1.0, 0.0])
    along = float(place @ forward)
    return along if position == "front" else -along


def _prefer_plain(found: list[_Candidate], wanted: Phrase) -> list[_Candidate]:
    """Of several matches of a singular phrase, those without attributes it does not ask for."""

    def extras(c: _Candidate) -> int:
        label = parse(c.body.label) if c.body.label else parse(_strip_number(c.body.name))
        distinguishing = set(label.modifiers) - set(wanted.modifiers)
        return (
            len(distinguishing)
            + (label.identifier is not None and wanted.identifier is None)
            + (label.ordinal is not None and wanted.ordinal is None)
        )

    fewest = min(extras(c) for c in found)
    return [c for c in found if extras(c) == fewest]


def _bind_alias(wanted: Phrase, scene: SimScene) -> tuple[int, ...]:
    """Billiard players' names: the black ball is the 8, the cue ball is the white one."""
    if wanted.head != "ball":
        return ()
    texts = [normalize(f"{b.label} {b.category} {b.name}") for b in scene.bodies]
    alias = ""
    if "cue" in wanted.modifiers:
        alias = "white ball"
    elif wanted.identifier == "8" and not wanted.colors:
        alias = "black ball"
    elif "black" in wanted.colors and any("8" in t.split() for t in texts):
        alias = "8 ball"
    elif "white" in wanted.colors and any("cue ball" in t for t in texts):
        alias = "cue ball"
    if not alias or alias == wanted.text:
        return ()
    parsed = parse(alias)
    found = [c for i, b in enumerate(scene.bodies) if (c := _candidate(i, b, parsed)) is not None]
    if "cue" in wanted.modifiers:
        found = [c for c in found if "billiard" in c.words or "pool" in c.words]
    found = [c for c in found if not _contradicts(c, parsed, found)]
    found = _by_identifier(_by_color(found, parsed), parsed)
    return tuple(c.index for c in found[:1])


def _bind_by_what_it_is_of(wanted: Phrase, scene: SimScene) -> tuple[int, ...]:
    """ "The ice" of a "sheet of ice", "the pile" of a "pile of boxes": all that are called so."""
    found: list[int] = []
    for i, body in enumerate(scene.bodies):
        first, of, second = normalize(body.label).partition(" of ")
        whole = first.split()[-1:] if of and body.category != FRAGMENT else []
        stuff = bool(PORTIONS & {*whole}) and parse(second).head == wanted.head
        if stuff or (wanted.head in COMPOUNDS and whole == [wanted.head]):
            found.append(i)
    return tuple(found)


def _why_not(phrase: str, wanted: Phrase, scene: SimScene) -> str:
    same = [b.name for b in scene.bodies if _candidate(0, b, wanted) is not None]
    if same:
        return f"{phrase!r}: none of {', '.join(same[:6])} fits its attributes"
    names = ", ".join(b.name for b in scene.bodies[:12])
    return f"{phrase!r} is not in the scene (objects: {names or 'none'})"
