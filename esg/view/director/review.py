"""What a take shows: of every event whether it is in view, how much of it is hidden, how large."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking import shown
from esg.view.camera import Camera
from esg.view.director.acting import Action, Beat
from esg.view.director.lens import FILL_LEAST, FILL_MOST, extent
from esg.view.director.takes import Take
from esg.view.pieces import Part, clocked
from esg.view.scan.drawer import Scan
from esg.view.surroundings import before_the_picture, in_the_way

Floats = NDArray[np.float64]

PROBE_PX = (112, 63)
"""Pictures in which visible pixels are counted while candidates are compared."""
GLANCE_PX = (64, 36)
CLEAR_SHARE, CLEAR_M = 0.12, 0.25
"""Nothing is closer to an eye than this share of its distance to the target, at most so far."""
UNOBSCURED = 0.6
"""Share of its pixels that must be seen of an event."""
BEFORE, NEARER = 0.25, 1.15
"""At most so much of a picture do bodies cover that are nearer than who acts, so many times."""
IN_VIEW = 0.95
"""Share of the rectangle around who acts that must be inside the picture."""


@dataclass(frozen=True)
class Seen:
    """What a camera shows of one event at its time.

    Args:
        beat: The event.
        inside: Share of the rectangle around who acts that is in the picture.
        unobscured: Of the pixels that its participants have where nothing else is, those that show
            a participant: they may hide each other.
        least: The same of the participant of which least is seen, also by other participants.
        fill: See `Extent.fill`.
        before: Share of the picture that other bodies cover which are nearer than who acts.
    """

    beat: Beat
    inside: float
    unobscured: float
    least: float
    fill: float
    before: float = 0.0

    @property
    def good(self) -> bool:
        """Whether it is in view, unobscured and neither too small nor too large."""
        shown = self.inside >= IN_VIEW and self.unobscured >= UNOBSCURED and self.before <= BEFORE
        return shown and FILL_LEAST <= self.fill <= FILL_MOST


class Viewfinder:
    """Answers what cameras see of an action.

    Args:
        action: What happens.
        scan: Draws its scene.
        size: Of the pictures in which pixels are counted [px].
        around: What stands around it, of which is left out what is in a camera's way.
    """

    def __init__(
        self,
        action: Action,
        scan: Scan,
        size: tuple[int, int] = PROBE_PX,
        around: Sequence[Part] = (),
    ) -> None:
        self.action, self.scan, self.size, self.around = action, scan, size, around
        self.aspect = size[0] / size[1]
        self._angles = clocked(action.scene, action.rollout)
        self._drawn = shown(action.scene, action.rollout)
        self._dressed: tuple[Take, frozenset[str]] | None = None
        self._poses: dict[int, NDArray[np.float32]] = {}
        self.frame = -1

    def turn_to(self, action: Action) -> None:
        """Looks for another action of the same motion from now on."""
        if action is not self.action:
            self.action, self._dressed = action, None

    def unhidden(self, take: Take, frame: int, body: int) -> float:
        """Share of the pixels of a body that nothing hides in a frame; 1 if it is not drawn."""
        self.dress(take)
        self.pose(float(take.time_s[frame]))
        camera = take.camera(frame)
        own = np.count_nonzero(self.scan.look(camera, self.size, (body,))[0] == body)
        seen = np.count_nonzero(self.scan.look(camera, self.size)[0] == body)
        return seen / own if own else 1.0

    def pose(self, time: float) -> None:
        """Puts all bodies where they are at a time [s]."""
        frame = self.action.frame(time)
        if frame != self.frame:
            if frame not in self._poses:
                self.expect([time])
            self.scan.place(self._poses[frame])
            self.frame = frame

    def expect(self, times: Sequence[float]) -> None:
        """Works out poses at many times [s] at once, which is quicker than one by one."""
        frames = sorted({self.action.frame(t) for t in times} - self._poses.keys())
        if not frames:
            return
        rollout = self._drawn
        p = np.nan_to_num(rollout.position[0, frames])
        found = self.scan.poses(p, rollout.quaternion[0, frames], self._angles[frames])
        self._poses.update(zip(frames, found, strict=True))

    def dress(self, take: Take) -> int:
        """Leaves out what stands between a take's cameras and who acts, as in a dollhouse.

        Returns:
            The number of things that are left out.
        """
        if self._dressed is not None and self._dressed[0] is take:
            self.scan.hide(self._dressed[1])
            return len(self._dressed[1])
        picked = sorted({round(v) for v in np.linspace(0, len(take) - 1, 5)})
        points = [self.action.acting(float(take.time_s[k])) for k in picked]
        shown = np.concatenate([p.mean(axis=0, keepdims=True) for p in points] + points[2:3])
        hidden = in_the_way(self.around, take.eye[picked], shown)
        hidden |= before_the_picture(self.around, [take.camera(k) for k in picked])
        self.scan.hide(hidden)
        self._dressed = take, hidden
        return len(hidden)

    def seen(self, beat: Beat, camera: Camera) -> Seen:
        """What a camera shows of an event."""
        self.pose(beat.time_s)
        shown, near = self.scan.look(camera, self.size)
        who = beat.participants[:6]
        alone, _ = self.scan.look(camera, self.size, who)
        shares = []
        for body in who:
            own = alone if len(who) == 1 else self.scan.look(camera, self.size, (body,))[0]
            shares.append(_share(np.count_nonzero(shown == body), np.count_nonzero(own == body)))
        points = self.action.acting(beat.time_s, beat)
        found = extent(camera, points, self.aspect)
        union = _share(np.count_nonzero(np.isin(shown, who)), np.count_nonzero(alone >= 0))
        away = float(np.linalg.norm(points.mean(axis=0) - np.asarray(camera.eye)))
        others = (shown >= 0) & ~np.isin(shown, (*who, *beat.company)) & (near * away > NEARER)
        before = float(np.count_nonzero(others)) / others.size
        return Seen(beat, found.inside, union, min(shares, default=0.0), found.fill, before)

    def sight(self, take: Take, time: float) -> float:
        """Share of the pixels of who acts at a time [s] that nothing else hides."""
        self.pose(time)
        beat, camera = self.action.beat_at(time), take.at([time]).camera(0)
        shown, _ = self.scan.look(camera, GLANCE_PX)
        alone, _ = self.scan.look(camera, GLANCE_PX, beat.participants)
        return _share(
            np.count_nonzero(np.isin(shown, beat.participants)), np.count_nonzero(alone >= 0)
        )

    def review(self, take: Take) -> list[Seen]:
        """What a take shows of every event that happens during it."""
        self.dress(take)
        times = take.time_s
        beats = [b for b in self.action.beats if times[0] - 1e-6 <= b.time_s <= times[-1] + 1e-6]
        shot = take.at([b.time_s for b in beats])
        return [self.seen(beat, shot.camera(k)) for k, beat in enumerate(beats)]

    def clear(self, take: Take, looks: int = 4) -> bool:
        """Whether the eye is never in or too close to a thing, nor passes through one."""
        eye, target = take.eye, take.target
        self.dress(take)
        self.pose(float(take.time_s[0]))
        if _crosses(eye, self.scan.still_triangles):
            return False
        for k in sorted({round(v) for v in np.linspace(0, len(take) - 1, looks)}):
            self.pose(float(take.time_s[k]))
            _, nearness = self.scan.look(take.camera(k), GLANCE_PX)
            away = float(np.linalg.norm(target[k] - eye[k]))
            if float(nearness.max()) > 1.0 / min(CLEAR_M, CLEAR_SHARE * away):
                return False
        return True


def _share(seen: float | np.intp, whole: float | np.intp) -> float:
    """Of a thing without a pixel nothing can be said to be seen."""
    return min(1.0, float(seen) / float(whole)) if whole > 0 else 0.0


def _crosses(eye: Floats, triangles: NDArray[np.float32]) -> bool:
    """Whether a path goes through one of some triangles, shape [n, 3, 3] (Möller, Trumbore)."""
    low, high = eye.min(axis=0) - 1e-3, eye.max(axis=0) + 1e-3
    if not len(triangles) or float((high - low).max()) < 0.01:
        return False
    near = np.all((triangles.max(axis=1) >= low) & (triangles.min(axis=1) <= high), axis=1)
    a, b, c = np.moveaxis(triangles[near].astype(float), 1, 0)
    starts, ways = eye[:-1, None], np.diff(eye, axis=0)[:, None]
    p = np.cross(ways, (c - a)[None])
    det = np.einsum("nj,knj->kn", b - a, p)
    det = np.where(np.abs(det) < 1e-12, np.inf, det)
    s = starts - a[None]
    u = np.einsum("knj,knj->kn", s, p) / det
    q = np.cross(s, (b - a)[None])
    v = np.einsum("knj,knj->kn", np.broadcast_to(ways, q.shape), q) / det
    t = np.einsum("nj,knj->kn", c - a, q) / det
    return bool(np.any((u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0) & (t <= 1)))
