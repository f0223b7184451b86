"""Choosing a take: from many places to stand, the first that shows everything well."""

from __future__ import annotations

from collections.abc import Sequence
import itertools
import math

import numpy as np
from numpy.typing import NDArray

from esg.view.director.acting import Action, Beat
from esg.view.director.lens import FILL_LEAST, FILL_MOST, View, extent, framed
from esg.view.director.paths import KINDS, beats_in, is_smooth, knots
from esg.view.director.review import BEFORE, IN_VIEW, UNOBSCURED, Seen, Viewfinder
from esg.view.director.takes import Take
from esg.view.surroundings import in_the_way

Floats = NDArray[np.float64]

LENSES_MM = (35.0, 28.0, 42.0, 50.0)
"""Focal lengths that seeds choose among, on film of 36 x 24 mm; seed 0 has the first."""
TURNS_DEG = (0, 28, -28, 55, -55, 90, -90, 125, -125, 180)
"""Where cameras are tried, from beside the motion on the viewer's side."""
RISES_DEG: dict[bool, tuple[float | None, ...]] = {
    True: (None, 13.0, 26.0, 45.0),
    False: (22.0, 36.0, 55.0),
}
"""Heights that are tried, by whether people stand beside the action; None is eye height."""
APART_RAD = math.radians(40)
"""Several cameras stand at least so far from each other, seen from the action, if they can."""
TRIED = 5
"""So many of the best places are looked at in full."""
LEFT_OUT = 0.07
"""Worth that a thing costs which a camera can only look past if it is left out, up to three."""
FAR_SIDE = 0.06
"""Worth that it costs to stand on the other side of a way."""
LARGER = 0.06
"""Share of the worth of an instant that goes with the size of who acts, up to a fill of 30%."""
AHEAD, AHEAD_COS = 0.5, 0.6
"""Worth that it costs to stand nearer to straight ahead than so of what leaves a cloud behind."""
CONTENT = 0.6
"""Worth beyond that of keeping all rules at the events with which the search ends."""
FULL = 1.3
"""Worth of a place from which everything is seen."""
AUTO = ("static", "tracking")


def direct(
    finder: Viewfinder,
    start: float,
    end: float,
    *,
    seed: int = 0,
    kinds: Sequence[str] = AUTO,
    apart: Sequence[float] = (),
) -> Take:
    """The best take of a stretch of a scene.

    Args:
        finder: Of the scene.
        start, end: Of the stretch [s].
        seed: Chooses lens, side and angle among what is about as good.
        kinds: Kinds of camera to choose from.
        apart: Azimuths [rad] of other cameras, to stand apart from.

    Returns:
        The first take, from the best place on, that is smooth and clear and shows every event in
        view, unobscured and large enough; where there is none, the one that comes closest.
    """
    action, times = finder.action, knots(start, max(end, start + 0.1))
    beats = beats_in(action, times)
    best, most = None, -math.inf
    places = _places(finder, beats, seed, apart)[: 2 if apart else TRIED]
    for view in places:
        for kind in kinds:
            take = KINDS[kind](action, times, view)
            if take is None:
                continue
            worth = _worth(finder, take, view.aspect)
            if worth > most + 1e-9:
                best, most = take, worth
        if most >= 2.0 + CONTENT:
            break
    if best is None:  # a kind that this scene has no use for: a dash without a vehicle
        return direct(finder, start, end, seed=seed, apart=apart)
    return best


def azimuth_of(take: Take) -> float:
    """Direction from the action to the camera in the middle of a take [rad]."""
    arm = (take.eye - take.target)[len(take) // 2]
    return math.atan2(arm[1], arm[0])


def _places(
    finder: Viewfinder, beats: Sequence[Beat], seed: int, apart: Sequence[float]
) -> list[View]:
    """Views by how well single pictures of the beats from there show them."""
    action = finder.action
    rng = np.random.default_rng(seed)
    mm = LENSES_MM[seed % len(LENSES_MM)]
    fov = 2 * math.atan(12.0 / mm)
    jitter = math.radians(float(rng.uniform(-9, 9))) if seed else 0.0
    mirror = -1.0 if seed % 2 else 1.0
    way = action.heading()
    told = action.side if not apart else None
    side = _beside(way) if told is None else told
    turns = TURNS_DEG if told is None else TURNS_DEG[:3]
    travels = float(np.linalg.norm(way)) >= 0.2 and told is None
    first = RISES_DEG[action.human][0] or 6.0
    options: list[tuple[float, View]] = []
    for turn, rise in itertools.product(turns, RISES_DEG[action.human]):
        azimuth = side + mirror * math.radians(turn) + jitter
        view = View(
            azimuth,
            None if rise is None else math.radians(rise),
            fov,
            finder.aspect,
            _lead(way, azimuth),
        )
        # Who goes somewhere is seen from one side or the other rather than along his way.
        off = min(abs(turn), 180 - abs(turn)) if travels else abs(turn)
        cost = 0.0016 * off + FAR_SIDE * (travels and abs(turn) > 90)
        cost += 0.004 * ((rise or 6.0) - first)
        cost += AHEAD * (action.trails and _ahead(way, azimuth) > AHEAD_COS)
        if any(math.cos(azimuth - other) > math.cos(APART_RAD) for other in apart):
            cost += 1.0
        options.append((cost, view))
    options.sort(key=lambda option: option[0])
    picked = [beats[k] for k in sorted({0, len(beats) // 2, len(beats) - 1})]
    rated: list[tuple[float, View]] = []
    for cost, view in options:
        # The best that a later one can reach is full sight of everything.
        if len(rated) >= TRIED and sorted(r for r, _ in rated)[-2] >= FULL - cost - 0.02:
            break
        shown = [_shown(finder, beat, view) for beat in picked]
        cost += LEFT_OUT * min(3, _left_out(finder, picked[-1], view))
        rated.append((min(shown) + (FULL - 1.0) * sum(shown) / len(shown) - cost, view))
    rated.sort(key=lambda one: -one[0])
    return [view for _, view in rated]


def _left_out(finder: Viewfinder, beat: Beat, view: View) -> int:
    """How many things would have to be left out of the surroundings to see a beat."""
    if not finder.around:
        return 0
    points = finder.action.acting(beat.time_s, beat)
    eye = np.array([framed(points, view).eye])
    return len(in_the_way(finder.around, eye, points.mean(axis=0, keepdims=True)))


def _shown(finder: Viewfinder, beat: Beat, view: View) -> float:
    """How well a picture of a beat shows it: 1 if nothing of it is hidden."""
    seen = finder.seen(beat, framed(finder.action.acting(beat.time_s, beat), view))
    clear = 1.0 - max(0.0, seen.before - BEFORE)
    return clear * min(seen.unobscured, 0.55 + 0.45 * seen.least) * (seen.inside >= 0.9)


def _lead(way: Floats, azimuth: float) -> float:
    """Where a way points in the picture of a camera in a direction: -1 left to 1 right."""
    length = float(np.linalg.norm(way))
    # Right of the picture is a quarter turn on from the camera's arm.
    right = np.array([-math.sin(azimuth), math.cos(azimuth)])
    return 0.0 if length < 0.2 else float(np.clip(way @ right / length, -1.0, 1.0))


def _ahead(way: Floats, azimuth: float) -> float:
    """Cosine of the angle between a way and the direction of a camera; 0 where nobody goes."""
    length = float(np.linalg.norm(way))
    return 0.0 if length < 0.2 else float(way @ (math.cos(azimuth), math.sin(azimuth)) / length)


def _worth(finder: Viewfinder, take: Take, aspect: float) -> float:
    """At least 2 for a take that keeps all rules at the events, up to 0.8 more for its rest."""
    worth = 2.0 - LEFT_OUT * min(3, finder.dress(take))
    seen = finder.review(take)
    for one in seen:
        worth -= 2.0 * _lacks(one) / max(1, len(seen))
    worth -= 0.6 * (not is_smooth(take))
    if worth > 1.0:  # else it will not be chosen anyway
        worth += 0.5 * _steady(finder.action, take, aspect)
        start, end = take.time_s[0], take.time_s[-1]
        glances = [finder.sight(take, start + k * (end - start)) for k in (0.15, 0.5, 0.98)]
        worth += 0.1 * sum(share >= UNOBSCURED for share in glances)
    return worth if finder.clear(take) else worth - 1.0


def _lacks(seen: Seen) -> float:
    """What an event lacks: 0 for one that is in view, unobscured and large enough."""
    lack = 0.0
    if seen.inside < IN_VIEW:
        lack += 0.6 + (1.0 - seen.inside)
    if seen.unobscured < UNOBSCURED:
        lack += 0.4 + (1.0 - seen.unobscured)
    if not FILL_LEAST <= seen.fill <= FILL_MOST:
        lack += 0.3 + abs(seen.fill - np.clip(seen.fill, FILL_LEAST, FILL_MOST))
    if seen.before > BEFORE:
        lack += 0.3 + (seen.before - BEFORE)
    return lack + 0.1 * max(0.0, 0.3 - seen.least)


def _steady(action: Action, take: Take, aspect: float) -> float:
    """Share of the instants at which who acts is in view and large enough; larger is a bit more."""
    good = 0.0
    steps = range(0, len(take), 4)
    for k in steps:
        found = extent(take.camera(k), action.acting(float(take.time_s[k])), aspect)
        large = 1.0 - LARGER + LARGER * min(1.0, found.fill / 0.3)
        good += large * (found.inside >= 0.8 and 0.8 * FILL_LEAST <= found.fill <= FILL_MOST)
    return good / len(steps)


def _beside(way: Floats) -> float:
    """Azimuth beside a way, on the viewer's (+Y) side [rad]."""
    if float(np.linalg.norm(way)) < 0.2:
        return math.pi / 2
    side = math.atan2(way[1], way[0]) + math.pi / 2
    return side + math.pi if math.sin(side) < -1e-6 else side
