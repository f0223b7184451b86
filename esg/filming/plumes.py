"""Puffs of smoke, steam, dust and sparks of a recording: where each leaves its source, and when."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, GivesOff
from esg.lexicon.plumes import Plume, plumes
from esg.units import quat_rotate

Floats = NDArray[np.float64]

MOST = 80
"""Puffs of one source: a longer scene has them less often."""
LARGEST = 4.0
"""Puffs of large sources are at most so many times as large as those of small ones."""
MOVES_MPS = 0.3
"""What gives something off as it moves is faster than this."""
SEED = 31


@dataclass(frozen=True)
class Puff:
    """One puff.

    Args:
        begins, ends: When it is there [s].
        at: Where it leaves its source [m], shape [3].
        velocity: Its own, all the time [m/s], shape [3].
        first, last: Its radius then and then [m].
    """

    begins: float
    ends: float
    at: tuple[float, float, float]
    velocity: tuple[float, float, float]
    first: float
    last: float


def row_of(gives: GivesOff) -> Plume:
    """The row of the table."""
    return plumes()[gives.name]


def puffs(
    gives: GivesOff,
    body: Body,
    time: Floats,
    position: Floats,
    quaternion: Floats,
    events: Mapping[str, float | None],
) -> list[Puff]:
    """The puffs that a body gives off, the earliest first.

    Args:
        gives: What.
        body: The source.
        time: Of the frames [s], shape [T].
        position: Of its centre of mass [m], shape [T, 3].
        quaternion: (x, y, z, w), shape [T, 4].
        events: Times of the events [s], None for those that did not happen.
    """
    row = row_of(gives)
    begins = 0.0 if not gives.begins else events.get(gives.begins)
    time = np.asarray(time, float)
    if begins is None or begins >= time[-1]:
        return []
    rng = np.random.default_rng([SEED, *body.name.encode()])
    # A plume that is there from the start is there before it.
    early = 0.0 if gives.begins or row.moving else row.lasts_s
    step = max(1.0 / row.per_s, (float(time[-1]) - begins + early) / MOST)
    out: list[Puff] = []
    for t in np.arange(begins - early, float(time[-1]), step):
        k = int(np.clip(np.searchsorted(time, t), 0, len(time) - 1))
        before = max(0, k - 1)
        span = float(time[k] - time[before]) or math.inf
        speed = float(np.linalg.norm(position[k] - position[before])) / span
        around = rng.uniform(-1.0, 1.0, 3)
        jitter = rng.uniform(0.8, 1.2)
        if row.moving and speed < MOVES_MPS:
            continue
        local, wide = _outlet(row, body, around)
        at = np.asarray(position[k], float) + quat_rotate(np.asarray(quaternion[k], float), local)
        side = row.spreads_mps * around[:2]
        first = float(np.clip(row.share * wide, row.first_m, LARGEST * row.first_m) * jitter)
        last = first * row.last_m / row.first_m
        ends = float(t + row.lasts_s)
        velocity = np.array([*side, row.rises_mps])
        if t < 0.0:  # it has come some way by then
            at, first = at - t * velocity, first - (last - first) * t / row.lasts_s
        out.append(Puff(max(0.0, float(t)), ends, _vec(at), _vec(velocity), first, last))
    return [p for p in out if p.ends > p.begins]


def rises_m(body: Body) -> float:
    """How far above a body what leaves its top is seen [m]."""
    tops = [row_of(g) for g in body.gives_off if row_of(g).place == "top"]
    rise = max((row.rises_mps * row.lasts_s for row in tops), default=0.0)
    return min(rise, 2.0 * float(body.half_extents[2]))


def trails_m(body: Body) -> float:
    """How far behind a body what leaves it there is looked at [m]."""
    behind = any(row_of(g).place in ("back", "wheels") for g in body.gives_off)
    return 1.2 * float(body.half_extents[0]) * behind


def _outlet(row: Plume, body: Body, around: Floats) -> tuple[Floats, float]:
    """Where a puff leaves a body, in its frame [m], and how wide that is on its smaller side."""
    half = np.asarray(body.half_extents, float)
    foot = np.asarray(body.origin_offset, float)
    high = {"top": 2.0, "back": 0.35, "wheels": 0.04, "foot": 0.06}[row.place] * half[2]
    if row.place in ("back", "wheels"):
        at = np.array([-half[0], 0.7 * half[1] * around[1], high])
    elif row.place == "foot":
        side = math.copysign(1.05, around[1])  # beside it: nothing hides them
        at = np.array([0.8 * half[0] * around[0], side * half[1], high])
    else:
        spread = 0.25 * min(half[0], half[1])
        at = np.array([spread * around[0], spread * around[1], high])
    return at + foot, float(2.0 * min(half[0], half[1]))


def _vec(values: Sequence[float] | Floats) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in values)
    return x, y, z
