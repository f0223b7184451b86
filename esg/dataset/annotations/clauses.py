"""What happened in a scene, one clause an event or hit, in order of time.

Events are those that the verdict says were completed: what failed is not told. Hits that no event
speaks of are told, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
import math

import numpy as np

from esg.dataset.annotations.motion import Hit, Motion
from esg.dataset.annotations.nouns import Nouns
from esg.dataset.annotations.wording import agreeing, rows, verb_of
from esg.engines.program import GuideAlong, HoldVelocity, Program
from esg.engines.scene import GROUND, SimScene
from esg.metrics.models import EventVerdict, SceneVerdict, SuiteEvent, SuiteScene
from esg.units import GRAVITY_MPS2

SAME_HIT_S = 0.1
"""A collision of the verdict and a hit of the same two this close in time are one."""
FALLING_SHARE = 0.3
"""What is in free fall gains speed downwards within this share of gravity."""
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
        with_b: Whether `b` belongs to the subject: a and b collide.
    """

    what: str
    time: float
    a: str
    b: str = ""
    event: str = ""
    fills: tuple[tuple[str, str], ...] = ()
    impulse: float | None = None

    @property
    def with_b(self) -> bool:
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
    return Clause("mutual" if hit.mutual else "collision", hit.time, a, b, impulse=hit.impulse)


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
        hit = story.motion._hit((min(a, b), max(a, b)), time, impulse or 0.0)
    return replace(of_hit(story, hit), time=time, event=event.id, impulse=impulse)


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
            what = region.name.rpartition("/")[2].replace("_", " ")
            if region.parent in story.scene.names and story.nouns.known(region.parent):
                whole = story.nouns.the(region.parent)
                return f"the {_region_noun(what, region.kind)} of {whole}"
    target = _target(story, event)
    return story.nouns.the(target) if target else None


def _region_noun(name: str, kind: str) -> str:
    words = [w for w in name.split() if not w.isdecimal()]
    return " ".join(words) or kind


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
            return "fly" if flat > 0.5 else "move"
    if body.roll_radius > 0.0:
        spin = float(np.linalg.norm(motion.spin[start, i, :2])) * body.roll_radius
        if abs(spin / max(float(motion.speed[start, i]), 1e-6) - 1.0) < ROLLING_SHARE:
            return "roll"
    held = {n for j in story.scene.joints for n in (j.parent, j.child)}
    return "move" if driven or body.static or name in held else "slide"


def manner_verb(story: Story, name: str) -> str:
    """The verb, in brackets, of how a body moves at first."""
    return verb_of(manner(story, name), story.scene.body(name).category)


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
    plural = clause.with_b or story.nouns.is_plural(clause.a)
    # Verbs first: names may not hold brackets, but manners do.
    text = template.replace("{manner}", dict(clause.fills).get("manner", ""))
    return agreeing(text, plural=plural).format(**{**fills, **dict(clause.fills)})
