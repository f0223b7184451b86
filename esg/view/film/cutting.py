"""Which instants of a scene a film shows, and how fast."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.view.director.acting import PASSED, Beat
from esg.view.moments import LASTING

Floats = NDArray[np.float64]

FPS = 24
MAX_FRAMES = 64
"""Of a film: under three seconds; more are dear and show no more."""
SLOW = 0.25
"""Speed around short events."""
SLOW_BEFORE_S, SLOW_AFTER_S = 0.08, 0.12
EASES = ((0.7, 0.6, 3), (0.6, 0.5, 3), (0.5, 0.5, 2), (0.35, 0.4, 1), (0.25, 0.3, 0))
"""What is shown before and after every event [s], and how many are slowed down: the first that
fits."""
JOIN_S = 0.4
"""Two stretches with less between them are one."""
MAX_SAID_FRAMES = 192
"""Of a film whose camera the prompt tells, which has no cuts: eight seconds."""
GOES_ON = 4.0
"""What lasts is followed so many times as long as what happens in an instant."""
PASSING, PASSES = "misses", 1.8
"""Who passes something is seen to come and to go: so many times as long."""
STILL_S = 2.0
"""Of a scene without events."""


@dataclass(frozen=True)
class Cut:
    """One stretch without a cut.

    Args:
        time_s: Instant of the scene of every frame [s], shape [F].
        speed: Of the scene at every frame, 1 is real time, shape [F].
    """

    time_s: Floats
    speed: Floats


def cuts_of(beats: Sequence[Beat], end: float) -> list[Cut]:
    """The stretches of a film.

    At normal speed, slower around short events; where even the shortest stretches around all events
    are longer than a film may be, faster.

    Args:
        beats: In order of time.
        end: Of the recording [s].
    """
    cuts: list[Cut] = []
    for before, after, slowed in EASES:
        spans = _spans(beats, end, before, after)
        slow = _slow([b for b in beats if b.brief][:slowed])
        cuts = [_timed(a, b, slow, 1.0) for a, b in spans]
        if sum(len(c.time_s) for c in cuts) <= MAX_FRAMES:
            return cuts
    most = sum(len(c.time_s) for c in cuts) / (MAX_FRAMES - len(cuts))
    return [_timed(a, b, [], most) for a, b in _spans(beats, end, *EASES[-1][:2])]


def whole_cut(beats: Sequence[Beat], end: float, rate: float) -> Cut:
    """One stretch without cuts, as fast as the prompt says: all of the recording that fits.

    Where it is longer than such a film may be, it shows what is around the first event in slow
    motion, and else runs faster.

    Args:
        beats: In order of time.
        end: Of the recording [s].
        rate: Seconds of the scene in a second of film.
    """
    lasts = rate * (MAX_SAID_FRAMES - 1) / FPS
    if end <= lasts:
        return _timed(0.0, end, [], rate)
    if rate >= 1.0:
        return _timed(0.0, end, [], end * FPS / (MAX_SAID_FRAMES - 1))
    start = float(np.clip(beats[0].time_s - 0.5 * lasts, 0.0, end - lasts))
    return _timed(start, start + lasts, [], rate)


def _spans(
    beats: Sequence[Beat], end: float, before: float, after: float
) -> list[tuple[float, float]]:
    out: list[tuple[float, float]] = []
    for beat in beats:
        lasting = after if beat.event else STILL_S
        lasting *= GOES_ON if beat.type in LASTING else 1.0
        ahead = before
        if beat.type == PASSING:
            ahead, lasting = PASSES * before, PASSES * lasting
        if beat.type == PASSED:
            ahead, lasting = 0.1, 0.3
        a, b = max(0.0, beat.time_s - ahead), min(end, beat.time_s + lasting)
        if out and a - out[-1][1] <= JOIN_S:
            out[-1] = (out[-1][0], max(b, out[-1][1]))
        else:
            out.append((a, b))
    return out


def _slow(beats: Sequence[Beat]) -> list[tuple[float, float]]:
    brief = (b for b in beats if b.type != PASSING)
    return [(b.time_s - SLOW_BEFORE_S, b.time_s + SLOW_AFTER_S) for b in brief]


def _timed(start: float, end: float, slow: Sequence[tuple[float, float]], fast: float) -> Cut:
    times, speeds = [start], []
    while True:
        now = times[-1]
        speed = SLOW if any(a <= now < b for a, b in slow) else fast
        speeds.append(speed)
        if now + speed / FPS > end + 1e-9:
            return Cut(np.array(times), np.array(speeds))
        # Slow motion begins on time, not up to a frame late.
        ahead = [a for a, _ in slow if now < a - 1e-9 < now + speed / FPS]
        times.append(min([now + speed / FPS, *ahead]))


def told(time: float, speed: float) -> str:
    """What the corner of a frame says."""
    text = f"{time:.2f} s"
    if speed < 0.99:
        return f"{text}   1/{round(1 / speed)} speed"
    return text if speed < 1.01 else f"{text}   {math.ceil(10 * speed) / 10:g} x speed"
