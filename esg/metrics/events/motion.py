"""Events of motion under control: moves, brakes, stops, turns."""

from __future__ import annotations

from collections.abc import Iterator
import math

import numpy as np
from numpy.typing import NDArray

from esg.metrics.detection import (
    Found,
    Query,
    duration_of,
    runs,
)
from esg.metrics.replay import Replay
from esg.thresholds import (
    BRAKED_TO,
    MOVING_FOR_S,
    MOVING_MPS,
    STOPPED_FOR_S,
    STOPPED_MPS,
    TURN_TOLERANCE_DEG,
)


def moves(replay: Replay, q: Query) -> Iterator[Found]:
    """Motion under own power that lasts for `MOVING_FOR_S`."""
    for i in q.bound["object"].bodies:
        controls = replay.motions(i)
        if not controls:
            yield Found(None, (i,), f"nothing drives {replay.scene.bodies[i].name}")
            continue
        begin = max(replay.after(q.since), replay.frame_at(controls[0].time))
        mask = replay.speed[:, i] > MOVING_MPS
        mask[:begin] = False
        longest = 0.0
        for start, stop in runs(mask):
            span = duration_of(replay, start, stop)
            longest = max(longest, span)
            if span >= MOVING_FOR_S - 0.5 * replay.frame_s:
                top = float(replay.speed[start:stop, i].max())
                yield Found(
                    float(replay.time[start]), (i,), measured={"for_s": span, "speed_mps": top}
                )
                break
        else:
            yield Found(None, (i,), f"moves for {longest:.2f} s at most (needs 0.5 s)")


def brakes(replay: Replay, q: Query) -> Iterator[Found]:
    """Slowing down to half of the speed or less after the program brakes."""
    for i in q.bound["object"].bodies:
        name = replay.scene.bodies[i].name
        reason = f"the program never brakes {name}"
        for t in replay.brakings(i):
            if q.since is not None and t <= q.since:
                reason = f"{name} brakes at {t:.2f} s, not after the event before"
                continue
            begin = replay.frame_before(t) if t > 0 else 0
            before = float(replay.speed[begin, i])
            if before < MOVING_MPS:
                reason = f"{name} is at rest when its braking starts"
                continue
            limit = q.until(i, t) if q.until else math.inf
            stop = max(replay.frame_before(limit) + 1, begin + 1) if limit < math.inf else None
            later = replay.speed[begin:stop, i]
            slowest = float(later.min())
            measured = {"speed_before_mps": before, "speed_min_mps": slowest}
            if slowest <= BRAKED_TO * before:
                halved = begin + int(np.argmax(later <= BRAKED_TO * before))
                measured["halved_at_s"] = float(replay.time[halved])
                yield Found(t, (i,), measured=measured)
                break
            reason = f"{name} slows from {before:.2f} to {slowest:.2f} m/s only"
        else:
            yield Found(None, (i,), reason)


def stops(replay: Replay, q: Query) -> Iterator[Found]:
    """Coming to rest after having moved, for each body that may be meant."""
    for i in q.bound["object"].bodies:
        speed = replay.speed[:, i]
        moved = np.maximum.accumulate(speed) > MOVING_MPS
        mask = (speed < STOPPED_MPS) & moved
        mask[: replay.after(q.since)] = False
        for start, stop in runs(mask):
            if duration_of(replay, start, stop) >= STOPPED_FOR_S - 0.5 * replay.frame_s:
                yield Found(float(replay.time[start]), (i,))
                break
        else:
            name = replay.scene.bodies[i].name
            if not moved.any():
                yield Found(None, (i,), f"{name} never moves")
            else:
                yield Found(None, (i,), f"{name} still moves at {speed[-1]:.2f} m/s at the end")


def turns(replay: Replay, q: Query) -> Iterator[Found]:
    """Turning by the asked angle to the asked side, measured from the last turning back."""
    wanted = q.event.degrees
    sign = 1.0 if q.event.direction == "left" else -1.0
    for i in q.bound["object"].bodies:
        begin = max(replay.after(q.since) - 1, 0)
        heading = sign * np.degrees(replay.heading(i))[begin:]
        # Measured from the last turning back: the angle since the running opposite extreme.
        turned = heading - np.minimum.accumulate(heading)
        enough = np.flatnonzero(turned >= wanted - TURN_TOLERANCE_DEG)
        if not len(enough):
            yield Found(None, (i,), f"turns {q.event.direction} by {turned.max():.0f} degrees only")
            continue
        first = int(enough[0])
        total = _settled(turned, first, replay.frame_s)
        if total > wanted + TURN_TOLERANCE_DEG:
            yield Found(None, (i,), f"turns by {total:.0f} degrees, {wanted:.0f} asked")
            continue
        yield Found(float(replay.time[begin + first]), (i,), measured={"turned_deg": total})


def _settled(turned: NDArray[np.float64], first: int, frame_s: float) -> float:
    """Angle when the turning ends after `first`: the rate falls under 5 degrees/s for 0.1 s."""
    quiet = max(1, round(0.1 / frame_s))
    k = first
    while k + quiet < len(turned) and turned[k + quiet] - turned[k] > 5.0 * quiet * frame_s:
        k += 1
    return float(turned[k])
