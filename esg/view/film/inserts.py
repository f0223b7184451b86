"""Cuts to what the sentence is about where the takes of the events leave it too small to see."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from esg.view.director.acting import Action, Beat
from esg.view.director.review import Viewfinder
from esg.view.director.staging import direct
from esg.view.director.takes import Take
from esg.view.director.told import LEGIBLE_S, Told, legible_in
from esg.view.film.cutting import FPS, Cut
from esg.view.framing import seen_ahead
from esg.view.moments import LASTING

CLEAR, CLEAR_GESTURE = 0.3, 0.75
"""Share of a body that nothing hides where it can be told; of who makes a gesture."""
LASTS_S, SHORTER_S = 1.1, (0.9, 0.7)
"""Of an insert; where there is only so much time between events, a shorter one."""
MOST = 4
"""Inserts of a film."""
BEFORE_S, AFTER_S, GOES_ON_S = 0.3, 0.4, 0.9
"""No insert cuts into an event: what is around it is kept, longer of what lasts."""
GRAZES_S = 0.1
"""An insert that cuts in by no more takes the place of what it shows; else it is shown besides."""
SHORTEST_S = 0.4
"""What an insert leaves of a stretch is dropped where it is shorter."""


@dataclass(frozen=True)
class Shot:
    """One stretch of a film and the camera that takes it; both of F frames.

    Args:
        cut: Instants.
        take: The camera.
        action: What it is about: that of the scene, or what is told of one body.
    """

    cut: Cut
    take: Take
    action: Action


def with_inserts(
    finder: Viewfinder, shots: Sequence[Shot], told: Sequence[Told], seed: int
) -> tuple[list[Shot], list[Told]]:
    """The same film with cuts to what else must be seen, as far as they show it.

    Args:
        finder: Of the scene; it is left looking at the scene's own action.
        shots: The film as its events ask for it.
        told: What must be seen.
        seed: Of lenses, sides and angles.

    Returns:
        The shots in order of time, and what no frame shows large enough.
    """
    action, out, lacking, left = finder.action, list(shots), list[Told](), MOST
    for one in told:
        if _seen(finder, out, one):
            continue
        insert = _insert(finder, action, one, seed) if left else None
        if insert is None:
            lacking.append(one)
        else:
            out, left = _spliced(action, out, insert), left - 1
    finder.turn_to(action)
    return out, lacking


def _seen(finder: Viewfinder, shots: Sequence[Shot], told: Told) -> bool:
    need = min(LEGIBLE_S, 0.8 * (told.span[1] - told.span[0]))
    lasts, clear = 0.0, CLEAR_GESTURE if told.facing else CLEAR
    for shot in shots:
        frames, while_s = legible_in(shot.action, shot.take, told, finder.aspect)
        if frames and _clear(finder, shot, frames[len(frames) // 2], told) >= clear:
            lasts += while_s
    return lasts >= need


def _clear(finder: Viewfinder, shot: Shot, frame: int, told: Told) -> float:
    """Share of a body that nothing hides in a frame; all of what is not drawn."""
    finder.turn_to(shot.action)
    return finder.unhidden(shot.take, frame, told.body)


def _insert(finder: Viewfinder, action: Action, told: Told, seed: int) -> Shot | None:
    """A shot of what is told, with who goes to it if both can be told; None if neither helps."""
    start, end = _when(action, told)
    times = np.arange(start, end + 1e-9, 1.0 / FPS)
    cut = Cut(times, np.ones(len(times)))
    own = (told.body,)
    casts = [(own, True)] if told.facing else [(own, False), (own, True)]
    casts = casts if told.mover is None else [((told.mover, told.body), False), *casts]
    for cast, alone in casts:
        about = action.about(Beat("", "", 0.5 * (start + end), cast), alone=alone)
        if told.facing:
            about.side = seen_ahead(action.rollout, cast, action.frame(start)) or about.side
        finder.turn_to(about)
        shot = Shot(cut, direct(finder, start, end, seed=seed).at(times), about)
        asked = [told if i == told.body else replace(told, body=i, inside=0.0) for i in cast]
        shows = all(_seen(finder, [shot], replace(one, span=(start, end))) for one in asked)
        if shows and not _inside(action, shot, cast):
            return shot
    return None


def _inside(action: Action, shot: Shot, cast: Sequence[int]) -> bool:
    """Whether a camera stands within the box of something that it is not about."""
    k = len(shot.take) // 2
    others = [i for i in range(len(action.scene.bodies)) if i not in cast]
    boxes = action.corners(action.frame(float(shot.cut.time_s[k])), others) if others else ()
    eye = shot.take.eye[k]
    return any(bool(np.all((b.min(axis=0) < eye) & (eye < b.max(axis=0)))) for b in boxes)


def _when(action: Action, told: Told) -> tuple[float, float]:
    """The first stretch within what is told that cuts least into the events [s]."""
    begin, end = told.span
    kept = _kept(action)
    options = [
        (round(_over(kept, float(start), float(start) + lasts), 3), start + LASTS_S - lasts, lasts)
        for lasts in (LASTS_S, *SHORTER_S)
        for start in np.arange(begin, end - lasts + 1e-6, 0.1)
    ]
    if not options:
        return begin, end
    _, late, lasts = min(options)
    start = float(late - LASTS_S + lasts)
    return start, start + lasts


def _kept(action: Action) -> list[tuple[float, float]]:
    """What no insert cuts into: the time around the events [s]."""
    return [
        (b.time_s - BEFORE_S, b.time_s + (GOES_ON_S if b.type in LASTING else AFTER_S))
        for b in action.beats
        if b.event
    ]


def _over(kept: Sequence[tuple[float, float]], start: float, end: float) -> float:
    """By how much a stretch cuts into others [s]."""
    return sum(max(0.0, min(b, end) - max(a, start)) for a, b in kept)


def _spliced(action: Action, shots: Sequence[Shot], insert: Shot) -> list[Shot]:
    """Shots in order of time; what the insert shows is shown once, unless it cuts into an event."""
    a, b = float(insert.cut.time_s[0]), float(insert.cut.time_s[-1])
    out = list(shots)
    if _over(_kept(action), a, b) <= GRAZES_S:
        out = [
            _part(shot, keep)
            for shot in shots
            for keep in (shot.cut.time_s < a, shot.cut.time_s > b)
            if keep.all() or _lasts(shot.cut.time_s[keep]) >= SHORTEST_S
        ]
    # What begins with an event is shown before it.
    return sorted((insert, *out), key=lambda s: float(s.cut.time_s[0]))


def _lasts(times: np.ndarray) -> float:
    return float(times[-1] - times[0]) if len(times) else 0.0


def _part(shot: Shot, keep: np.ndarray) -> Shot:
    take = shot.take
    cut = Cut(shot.cut.time_s[keep], shot.cut.speed[keep])
    part = replace(take, time_s=take.time_s[keep], eye=take.eye[keep], target=take.target[keep])
    return replace(shot, cut=cut, take=part)
