"""Hits of two bodies in W worlds, told apart as the judge tells them.

A touch that goes on is one hit, however long it lasts; a pause or a blow on what rests against
something starts another (`metrics.replay.hit_starts`). What touched before an event that a hit
shall follow, and merely goes on touching, is no hit after it. The first sound one counts.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses.recording import Bools, Floats, Recording
from esg.metrics.replay import hit_starts
from esg.thresholds import (
    HIT_GAP_S,
    IMPULSE_FRAMES,
    IMPULSE_WINDOW_S,
    MAX_CONTACT_DEPTH_M,
    MAX_RECHECK_DEPTH_M,
    MIN_IMPULSE_NS,
    RECHECK_AFTER_S,
    T_MAX_S,
)

Ints = NDArray[np.int64]

MOST_HITS = 6
"""So many hits of a pair are looked at until one is sound."""


@dataclass(frozen=True)
class Hits:
    """One hit of each of W worlds, all of shape [W].

    Args:
        time: Of its first contact [s], inf where there is none.
        impulse: Over the first moments [N s].
        depth: Over the first frames [m].
        recheck: Depth 0.2 s later [m].
        glance: 0 for a central hit, 1 for a graze.
        early: How long before the earliest time the last hit began [s]; inf if none did, or if
            one came in time.
    """

    time: Floats
    impulse: Floats
    depth: Floats
    recheck: Floats
    glance: Floats
    early: Floats

    def sound(self, end: float) -> Bools:
        """Whether it counts as a collision in a recording that ends at `end` [s]."""
        good = np.isfinite(self.time) & (self.time <= T_MAX_S)
        good &= (self.impulse > MIN_IMPULSE_NS) & (self.depth < MAX_CONTACT_DEPTH_M)
        return good & (self.recheck <= MAX_RECHECK_DEPTH_M) & (self.short(end) <= 0.0)

    def short(self, end: float) -> Floats:
        """By how much the recording is too short for the second look [s]."""
        return np.where(np.isfinite(self.time), self.time, 0.0) + RECHECK_AFTER_S - end


def first_hit(rec: Recording, a: list[int], b: list[int], earliest: Floats) -> Hits:
    """The first sound hit of two sets of bodies, or the first one where none is sound.

    Args:
        rec: W worlds.
        a, b: Body indices; any pair of them counts.
        earliest: A hit begins at this time or later [s], shape [W].
    """
    log = rec.r.contacts
    pair = (np.isin(log.a, a) & np.isin(log.b, b)) | (np.isin(log.a, b) & np.isin(log.b, a))
    rows = np.flatnonzero(pair)
    touches = _Touches(rec, rows)
    time, which = touches.first()
    early = np.full(rec.n, np.inf)
    for world in np.flatnonzero(np.isfinite(earliest) & (time < earliest - 1e-9)):
        starts = touches.starts(int(world))
        late = [s for s in starts if s[0] >= earliest[world] - 1e-9]
        if late:
            time[world], which[world] = late[0]
        else:
            early[world] = earliest[world] - starts[-1][0]
            time[world] = np.inf
    time = np.where(np.isfinite(earliest), time, np.inf)
    found = touches.measure(time, which, early)
    end = float(rec.t[-1])
    for _ in range(MOST_HITS - 1):
        weak = np.flatnonzero(np.isfinite(time) & ~found.sound(end))
        later_time, later_pair = np.full(rec.n, np.inf), which.copy()
        for world in weak:
            later = next((s for s in touches.starts(int(world)) if s[0] > time[world] + 1e-9), None)
            if later is not None:
                later_time[world], later_pair[world] = later
        time, which = later_time, later_pair
        if not np.isfinite(time).any():
            break
        again = touches.measure(time, which, early)
        better = again.sound(end)
        fields = ("time", "impulse", "depth", "recheck", "glance", "early")
        found = Hits(*(np.where(better, getattr(again, f), getattr(found, f)) for f in fields))
        time = np.where(better, np.inf, time)
    return found


class _Touches:
    """Rows of the contact log that belong to some pairs, in order of world, pair and time."""

    def __init__(self, rec: Recording, rows: Ints) -> None:
        log = rec.r.contacts
        self.rec = rec
        pair = np.minimum(log.a[rows], log.b[rows]).astype(np.int64) * len(rec.scene.bodies)
        pair += np.maximum(log.a[rows], log.b[rows])
        order = np.lexsort((log.time[rows], pair, log.world[rows]))
        self.rows, self.pair = rows[order], pair[order]
        self.world, self.time = log.world[self.rows], log.time[self.rows]
        self._starts: dict[int, list[tuple[float, int]]] = {}

    def first(self) -> tuple[Floats, Ints]:
        """Time [s] and pair of each world's first touch, shape [W]."""
        time, which = np.full(self.rec.n, np.inf), np.full(self.rec.n, -1)
        np.minimum.at(time, self.world, self.time)
        at = np.flatnonzero(self.time <= time[self.world])[::-1]
        which[self.world[at]] = self.pair[at]
        return time, which

    def starts(self, world: int) -> list[tuple[float, int]]:
        """Time [s] and pair of every hit of a world, in order of time."""
        if world not in self._starts:
            low, high = np.searchsorted(self.world, [world, world + 1])
            out: list[tuple[float, int]] = []
            gap = max(HIT_GAP_S, 1.5 / self.rec.fps)
            impulse = self.rec.r.contacts.impulse[self.rows[low:high]]
            for pair in np.unique(self.pair[low:high]):
                mine = np.flatnonzero(self.pair[low:high] == pair)
                time = self.time[low:high][mine]
                begins = hit_starts(time, impulse[mine], gap)
                out += [(float(t), int(pair)) for t in time[begins]]
            self._starts[world] = sorted(out)
        return self._starts[world]

    def measure(self, time: Floats, which: Ints, early: Floats) -> Hits:
        """The hits that begin at a time of a pair, per world."""
        rec, log = self.rec, self.rec.r.contacts
        impulse, depth = np.zeros(rec.n), np.zeros(rec.n)
        recheck, glance = np.zeros(rec.n), np.zeros(rec.n)
        same = self.pair == which[self.world]
        after = np.where(same, self.time - time[self.world], -np.inf)
        window = max(IMPULSE_WINDOW_S, IMPULSE_FRAMES / rec.fps) - 0.25 / rec.fps
        burst = (after >= -1e-9) & (after < window)
        np.add.at(impulse, self.world[burst], log.impulse[self.rows[burst]])
        begun = self.rows[(after >= -1e-9) & (after < 1.5 / rec.fps)]
        np.maximum.at(depth, log.world[begun], log.depth[begun])
        later = self.rows[np.abs(after - RECHECK_AFTER_S) < 0.75 / rec.fps]
        np.maximum.at(recheck, log.world[later], log.depth[later])
        for row in begun[::-1]:
            w = log.world[row]
            frame = max(int(log.frame[row]) - 1, 0)
            va = rec.r.linear_velocity[w, frame, log.a[row]].astype(float)
            vb = rec.r.linear_velocity[w, frame, log.b[row]].astype(float)
            relative = va - vb
            size = float(np.linalg.norm(relative))
            if size > 1e-6:
                glance[w] = 1.0 - abs(float(relative @ log.normal[row])) / size
        return Hits(time.copy(), impulse, depth, recheck, glance, early)
