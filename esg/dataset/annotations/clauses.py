"""What happened in a scene, one clause an event or hit, in order of time.

Events are those that the verdict says were completed: what failed is not told. Hits that no event
speaks of are told, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
import math

import numpy as np

from esg.dataset.annotations.motion import Hit, Motion
from esg.dataset.annotations.nouns import Nouns, with_article
from esg.dataset.annotations.wording import agreeing, rows, verb_of
from esg.engines.program import GuideAlong, HoldVelocity, Program
from esg.engines.scene import GROUND, Region, SimScene
from esg.lexicon.kinds import kinds
from esg.lexicon.morphology import plural as plural_of
from esg.metrics.models import EventVerdict, SceneVerdict, SuiteEvent, SuiteScene
from esg.units import GRAVITY_MPS2

LANDING_SHARE = 0.8
"""What comes down with this share of its speed lands on what it hits: 37 degrees off the vertical
at most."""
FLYING_SHARE = 0.1
"""What goes up or down with more of its speed is not running along: 6 degrees."""
SAME_HIT_S = 0.1
"""A collision of the verdict and a hit of the same two this close in time are one."""
SIDES_OF_REGIONS = frozenset(
    ("top", "bottom", "left", "right", "middle", "front", "back", "upper", "lower", "inside")
)
FALLING_SHARE = 0.3
"""What is in free fall gains speed downwards within this share of gravity."""
FLIGHT_MPS = 2.0
"""What is in free fall and goes along no faster than this falls; else it flies."""
ROLLING_SHARE = 0.3
"""What rolls has a spin within this share of v/r."""


@dataclass(frozen=True)
class Clause:
    """One thing that happened.

    Args:
        what: Row of `clauses.csv`.
        time: When [s].
        a: Who: its subject.
        b: To whom or what: a body, or empty.
        event: Id of the event, or empty.
        fills: Further words of its template.
        impulse: Of a hit [N s].
        several: How many bodies of the subject's name, and of the object's, it tells of.
    """

    what: str
    time: float
    a: str
    b: str = ""
    event: str = ""
    fills: tuple[tuple[str, str], ...] = ()
    impulse: float | None = None
    several: tuple[int, int] = (1, 1)

    @property
    def with_b(self) -> bool:
        """Whether `b` belongs to the subject: a and b collide."""
        return self.what in ("mutual", "separates")


@dataclass(frozen=True)
class Story:
    """A scene with what its replay shows.

    Args:
        scene, program: What was replayed.
        motion: Its recorded trajectory.
        nouns: Names of its bodies.
        verdict: What the judge says of the replay.
        expected: What the judge was asked.
    """

    scene: SimScene
    program: Program
    motion: Motion
    nouns: Nouns
    verdict: SceneVerdict
    expected: SuiteScene

    def index(self, name: str) -> int:
        return self.scene.index(name)


def event_clauses(story: Story) -> list[Clause]:
    """The completed events of a verdict, in order of time; those that no row words are left out."""
    asked = {e.id: e for e in story.expected.events}
    out: list[Clause] = []
    for found in story.verdict.events:
        if found.completed and found.time_s is not None and found.id in asked:
            clause = _of_event(story, asked[found.id], found)
            if clause is not None and _nameable(story, clause):
                out.append(clause)
    return sorted(out, key=lambda c: c.time)


def hit_clauses(story: Story, told: Sequence[Clause] = ()) -> list[Clause]:
    """Hits that no clause tells yet, in order of time."""
    known = {(frozenset((c.a, c.b)), c.time) for c in told if c.impulse is not None}
    out: list[Clause] = []
    for hit in story.motion.hits:
        clause = of_hit(story, hit)
        pair = frozenset((clause.a, clause.b))
        same = any(p == pair and abs(t - hit.time) <= SAME_HIT_S for p, t in known)
        if not same and _nameable(story, clause):
            out.append(clause)
    return out


def of_hit(story: Story, hit: Hit) -> Clause:
    """The clause of a hit."""
    a, b = (story.motion.names[i] for i in (hit.a, hit.b))
    what = "mutual" if hit.mutual else _way_of_hitting(story, hit)
    return Clause(what, hit.time, a, b, impulse=hit.impulse)


def _way_of_hitting(story: Story, hit: Hit) -> str:
    """Whether the one that strikes comes down on the other, flies at it, or comes along to it."""
    motion = story.motion
    k = motion.before(hit.time)
    down, speed = -float(motion.velocity[k, hit.a, 2]), float(motion.speed[k, hit.a])
    top = motion.position[k, hit.b, 2] + 0.5 * story.scene.bodies[hit.b].half_extents[2]
    if motion.position[k, hit.a, 2] > top and down > LANDING_SHARE * speed:
        return "lands"
    return "strikes" if abs(down) > FLYING_SHARE * speed else "collision"


def merged(story: Story, told: Sequence[Clause]) -> list[Clause]:
    """Clauses in which several of one name do or suffer the same, told as one: the first's time.

    What they do among themselves is one thing, too.
    """
    found: dict[tuple[str, ...], list[Clause]] = {}
    for c in told:
        found.setdefault(_likeness(story, c), []).append(c)
    return [_one_of(story, clauses) for clauses in found.values()]


def _likeness(story: Story, c: Clause) -> tuple[str, ...]:
    nouns = story.nouns
    many = [n for n in (c.a, c.b) if n and nouns.several(n) > 1]
    if not many:
        return c.what, c.a, c.b, c.event, f"{c.time}"
    what = "hit" if c.impulse is not None else c.what
    if len(many) == 2 and nouns.noun(c.a) == nouns.noun(c.b):
        return what, nouns.noun(c.a)
    names = [nouns.noun(n) if n in many else n for n in (c.a, c.b)]
    # Who of two strikes makes no difference where there are many of them.
    return (what, *(sorted(names) if what == "hit" else names))


def _one_of(story: Story, clauses: Sequence[Clause]) -> Clause:
    first, nouns = clauses[0], story.nouns
    if first.b and nouns.several(first.a) > 1 and nouns.noun(first.a) == nouns.noun(first.b):
        if nouns.several(first.a) == 2:
            return replace(first, what="one_other")
        return replace(first, what="each_other", impulse=None)
    if len(clauses) == 1:
        return first
    # A hit is told of the one that there is but one of.
    if first.impulse is not None and nouns.several(first.a) > 1 and nouns.several(first.b) == 1:
        first = replace(first, a=first.b, b=first.a)
    ends = [
        len({n for c in clauses for n in (c.a, c.b) if n and nouns.noun(n) == nouns.noun(end)})
        if end
        else 1
        for end in (first.a, first.b)
    ]
    what = "collision" if first.impulse is not None else first.what
    return replace(first, what=what, impulse=None, several=(ends[0], ends[1]))


def _nameable(story: Story, clause: Clause) -> bool:
    return all(story.nouns.known(n) for n in (clause.a, clause.b) if n)


def _of_event(story: Story, event: SuiteEvent, found: EventVerdict) -> Clause | None:
    time = found.time_s or 0.0
    bodies = [n for n in found.bodies if n]
    if event.type == "collision" and len(bodies) == 2:
        return _collision(story, event, found, bodies)
    if not bodies:
        return None
    clause = Clause(event.type, time, bodies[0], event=event.id)
    if event.type == "moves":
        return replace(clause, fills=(("manner", f"{manner_verb(story, bodies[0])} along"),))
    if event.type == "turns":
        turned = found.measured.get("turned_deg", event.degrees)
        side = "left" if event.direction == "left" else "right"
        return replace(clause, fills=(("side", side), ("degrees", f"{turned:.0f}")))
    if event.type == "falls":
        support = _support(story, bodies[0])
        return replace(clause, what="falls_off", b=support) if support else clause
    if event.type == "enters":
        place = _place(story, event, found)
        return None if place is None else replace(clause, fills=(("b", place),))
    if event.type in ("reaches", "misses", "bounces", "placed", "separates"):
        other = bodies[1] if len(bodies) > 1 else _target(story, event)
        return None if not other else replace(clause, b=other)
    return clause if clause.what in rows("clauses") else None


def _collision(
    story: Story, event: SuiteEvent, found: EventVerdict, bodies: Sequence[str]
) -> Clause:
    """A collision as the trajectory shows it: who struck whom."""
    time, impulse = found.time_s or 0.0, found.measured.get("impulse_ns")
    if GROUND in bodies:
        a = next((n for n in bodies if n != GROUND), bodies[0])
        return Clause("collision", time, a, GROUND, event.id, impulse=impulse)
    a, b = (story.index(n) for n in bodies)
    hit = story.motion.hit_of(a, b)
    if hit is None or abs(hit.time - time) > SAME_HIT_S:
        hit = story.motion.hit_at(a, b, time, impulse or 0.0)
    return replace(of_hit(story, hit), time=time, event=event.id)


def _support(story: Story, name: str) -> str:
    """What a body lies on at first: the lower one of a pair that touches from the start."""
    i = story.index(name)
    below = [
        j
        for pair in story.motion.supports
        if i in pair
        for j in pair - {i}
        if story.motion.position[0, j, 2] < story.motion.position[0, i, 2]
        and story.nouns.known(story.motion.names[j])
    ]
    return story.motion.names[below[0]] if len(below) == 1 else ""


def _target(story: Story, event: SuiteEvent) -> str:
    """The one body that an event's target is bound to, empty if that is none or several."""
    phrase = event.target or event.b
    bound = story.verdict.bindings.get(phrase or "", ())
    names = [n for n in bound if n in story.scene.names and story.nouns.known(n)]
    return names[0] if len(names) == 1 else ""


def _place(story: Story, event: SuiteEvent, found: EventVerdict) -> str | None:
    """What something went into: a body, or a region of one."""
    if "region" in found.measured:
        number = int(found.measured["region"])
        if 0 <= number < len(story.scene.regions):
            region = story.scene.regions[number]
            if region.parent in story.scene.names and story.nouns.known(region.parent):
                whole, noun = story.nouns.the(region.parent), _region_noun(region)
                return f"{with_article(noun)} of {whole}" if noun else whole
    target = _target(story, event)
    return story.nouns.the(target) if target else None


def _region_noun(region: Region) -> str:
    """What a region is called, without the side that only the table's maker knows; empty for the
    inside of something.
    """
    if region.kind == "inside":
        return ""
    words = region.name.rpartition("/")[2].replace("_", " ").split()
    kept = [w for w in words if w not in SIDES_OF_REGIONS and not w.isdecimal()]
    return " ".join(kept) or region.kind


def manner(story: Story, name: str) -> str:
    """How a body moves at first: drive, ride, roll, fly, slide or move."""
    i = story.index(name)
    body, motion = story.scene.bodies[i], story.motion
    driven = any(
        isinstance(p, HoldVelocity | GuideAlong) and p.body == name
        for p in story.program.primitives
    )
    if body.wheeled and driven:
        return "ride" if body.tyre_drop > 0.0 else "drive"
    if body.wheeled:
        return "roll"
    start = int(np.argmax(motion.speed[:, i] > 0.2))
    later = min(start + max(2, motion.at(motion.time[start] + 0.1) - start), len(motion.time) - 1)
    span = float(motion.time[later] - motion.time[start])
    if span > 0.0 and not driven:
        pull = (motion.velocity[start, i, 2] - motion.velocity[later, i, 2]) / span
        if abs(pull / GRAVITY_MPS2 - 1.0) < FALLING_SHARE:
            flat = math.hypot(*motion.velocity[start, i, :2])
            return "fly" if flat > FLIGHT_MPS else "fall"
    if body.roll_radius > 0.0:
        spin = float(np.linalg.norm(motion.spin[start, i, :2])) * body.roll_radius
        if abs(spin / max(float(motion.speed[start, i]), 1e-6) - 1.0) < ROLLING_SHARE:
            return "roll"
    held = {n for j in story.scene.joints for n in (j.parent, j.child)}
    return "move" if driven or body.static or name in held else "slide"


def manner_verb(story: Story, name: str) -> str:
    """The verb, in brackets, of how a body moves at first."""
    return verb_of(manner(story, name), story.scene.body(name).category)


@cache
def persons() -> frozenset[str]:
    """Categories that nobody calls `it`."""
    kinds_of = {k.name for k in kinds() if set(k.parents) & {"person", "child"}}
    return frozenset({"person", "child", *kinds_of})


def is_it(story: Story, name: str) -> bool:
    """Whether `it` can stand for a body: no person, no plural, not one of several."""
    nouns, category = story.nouns, story.scene.body(name).category
    return nouns.several(name) == 1 and not nouns.is_plural(name) and category not in persons()


def worded(
    story: Story, clause: Clause, template: str, names: Mapping[str, str] | None = None
) -> str:
    """A clause in words, without a capital or a full stop.

    Args:
        story: The scene.
        clause: What happened.
        template: One of its row's.
        names: How its bodies are called; default as known ones.
    """
    fills = {"a": story.nouns.the(clause.a), "b": story.nouns.the(clause.b) if clause.b else ""}
    fills |= dict(names or {})
    for key, name, n in zip("ab", (clause.a, clause.b), clause.several, strict=True):
        if n > 1:
            fills[key] = story.nouns.share(name, n)
    fills["group"] = plural_of(story.nouns.noun(clause.a))
    several = clause.several[0] > 1 or clause.what == "each_other"
    plural = clause.with_b or several or story.nouns.is_plural(clause.a)
    # Verbs first: names may not hold brackets, but manners do.
    text = template.replace("{manner}", dict(clause.fills).get("manner", ""))
    return agreeing(text, plural=plural).format(**{**fills, **dict(clause.fills)})
