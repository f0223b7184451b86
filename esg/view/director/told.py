"""What the sentence is about, body by body: when it must be seen, and how large."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import FRAGMENT, Rollout, SimScene
from esg.engines.wheels import gesturing
from esg.graph.models import Predicate
from esg.lexicon.gestures import EASES
from esg.units import quat_rotate
from esg.view.director.lens import extent

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument, Statement
    from esg.metrics.models import SceneVerdict
    from esg.view.director.acting import Action
    from esg.view.director.takes import Take

LEGIBLE = 0.08
"""Share of the picture's height that the longer side of a thing takes where it can be told."""
LEGIBLE_GESTURE = 0.25
"""The same of who makes a gesture: of an arm that goes a fifth of that a twentieth is seen."""
GOAL_INSIDE, PLUME_INSIDE = 0.4, 0.7
"""So much of a goal is in the picture: of a tree to which somebody goes not only a twig; and of
what smokes, with its smoke."""
LEGIBLE_S = 0.35
"""It is so large for so long."""
_OTHERWISE = frozenset(
    {
        Predicate.NOT_REPRESENTED,
        Predicate.FILMED,
        Predicate.WEATHER,
        Predicate.ABSENT,
        Predicate.COUNT,
    }
)
"""Predicates that are about no body, or whose films are the prompt's own."""

Span = tuple[float, float]


@dataclass(frozen=True)
class Told:
    """A body of which something is told that a film must show.

    Args:
        body: Which one.
        span: When it is so [s].
        least: Share of the picture's height that its longer side must take.
        mover: Who goes to it; None if nobody does.
        facing: Whether it is seen from ahead, as a gesture is.
        inside: So much of it is in the picture, with what rises from it.
    """

    body: int
    span: Span
    least: float
    mover: int | None = None
    facing: bool = False
    inside: float = 0.0


def told_of(
    scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None, doc: EsgDocument
) -> tuple[Told, ...]:
    """What a scene's statements and its timeline are about: gestures, then things, then goals.

    Of several of a group one stands for all; what is flat or was not named is left out.

    Args:
        scene: The bodies.
        rollout: Their motion.
        verdict: Events with their times; None if there are none.
        doc: Statements and timeline.
    """
    end = float(rollout.time[-1])
    times = {e.id: e.time_s for e in verdict.events} if verdict else {}
    found: dict[object, Told] = {}
    for one in (*_gestures(scene, doc, times, end), *_things(scene, doc, times, end)):
        body = scene.bodies[one.body]
        if body.mentioned and body.collides and body.category != FRAGMENT:
            found.setdefault(body.group or one.body, one)
    return tuple(found.values())


def _gestures(
    scene: SimScene, doc: EsgDocument, times: Mapping[str, float | None], end: float
) -> Iterator[Told]:
    fine = np.arange(0.0, end, 0.05)
    for s in doc.statements or ():
        for name in s.object if s.predicate is Predicate.GESTURES else ():
            if name not in scene.names:
                continue
            for gesture in scene.body(name).gestures:
                made = fine[gesturing(gesture, fine, times)[:, 0] == EASES]
                if gesture.name == s.noun and len(made):
                    span = (float(made[0]), float(made[-1]))
                    yield Told(scene.index(name), span, LEGIBLE_GESTURE, facing=True)


def _things(
    scene: SimScene, doc: EsgDocument, times: Mapping[str, float | None], end: float
) -> Iterator[Told]:
    ways: list[tuple[str, str]] = []
    timeline = doc.timeline_system
    for edge in timeline.sequence_graph.edges if timeline else ():
        ways.append((edge.actor, edge.target or ""))
    for s in doc.statements or ():
        if s.predicate in _OTHERWISE:
            continue
        span = _span_of(s, times, end)
        inside = PLUME_INSIDE if s.predicate is Predicate.GIVES_OFF else 0.0
        for name in s.object:
            if name in scene.names:
                yield Told(scene.index(name), span, LEGIBLE, inside=inside)
        if s.predicate is Predicate.MOVES:
            ways += [(one, other) for one in s.object for other in s.target]
            continue
        for name in s.target:
            if name in scene.names:
                yield Told(scene.index(name), span, LEGIBLE)
    for actor, target in ways:
        if actor in scene.names:
            yield Told(scene.index(actor), (0.0, end), LEGIBLE)
            if target in scene.names:
                ends = (scene.index(target), scene.index(actor))
                yield Told(ends[0], (0.0, end), LEGIBLE, ends[1], inside=GOAL_INSIDE)


def _span_of(s: Statement, times: Mapping[str, float | None], end: float) -> Span:
    """When a statement holds [s]; an instant has a second around it."""
    known: dict[str, float | None] = {**times, "start": 0.0, "end": end}
    first, dots, last = s.when.partition("..")
    a, b = known.get(first), known.get(last if dots else first)
    if a is None or b is None or a > b:
        return 0.0, end
    return (a, b) if b - a >= 1.0 else (max(0.0, a - 0.5), min(end, b + 0.5))


def legible_in(action: Action, take: Take, told: Told, aspect: float) -> tuple[list[int], float]:
    """Where a take shows what is told as large as it must be, within its time.

    Args:
        action: The motion.
        take: Of frames.
        told: Which body, when, how large.
        aspect: Width over height of the pictures.

    Returns:
        Some of those frames, and for how long it is so [s].
    """
    step = (float(take.time_s[-1]) - float(take.time_s[0])) / max(1, len(take) - 1)
    a, b = told.span[0] - 1e-6, told.span[1] + 1e-6
    frames = [
        k
        for k in range(0, len(take), _EVERY)
        if a <= take.time_s[k] <= b and _large(action, take, k, told, aspect)
    ]
    return frames, _EVERY * step * len(frames)


_EVERY = 3
AHEAD = 0.35
"""A gesture is told from within 70 degrees of straight ahead: from the side a hand that waves is
before the face, and seen from behind a nod is none."""


def _faced(action: Action, frame: int, body: int, arm: NDArray[np.float64]) -> float:
    """Cosine of the angle between where a body faces and a direction, over the ground."""
    ahead = quat_rotate(action.rollout.quaternion[0, frame, body], np.array([1.0, 0.0, 0.0]))
    size = float(np.hypot(*ahead[:2]) * np.hypot(*arm[:2]))
    return float(ahead[:2] @ arm[:2]) / size if size > 1e-6 else 1.0


def _large(action: Action, take: Take, k: int, told: Told, aspect: float) -> bool:
    """Whether the longer side of a body is large enough inside of a frame."""
    frame = action.frame(float(take.time_s[k]))
    corners = action.corners(frame, (told.body,))[0]
    if told.facing and _faced(action, frame, told.body, take.eye[k] - corners.mean(axis=0)) < AHEAD:
        return False
    found = extent(take.camera(k), corners, aspect)
    if not found.ahead or found.inside < told.inside:
        return False
    wide, high = (
        max(0.0, min(1.0, b) - max(-1.0, a)) / 2 for a, b in zip(found.low, found.high, strict=True)
    )
    return min(wide, high) > 0.0 and max(wide * aspect, high) >= told.least
