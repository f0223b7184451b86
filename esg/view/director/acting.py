"""Who must be seen, and when: the beats of a scene and the boxes of who acts in them."""

from __future__ import annotations

from collections.abc import Sequence
import copy
from dataclasses import dataclass, replace
import itertools
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Rollout, SimScene
from esg.filming.plumes import rises_m, trails_m
from esg.units import quat_rotate
from esg.view.framing import gestures_side, told_side
from esg.view.moments import INTO, LASTING, as_seen, cast_of, fixed_to, openings_of, set_off

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.metrics.models import EventVerdict, SceneVerdict

Floats = NDArray[np.float64]

BRIEF = frozenset(
    ["collision", "bounces", "breaks", "separates", "topples", "enters", "falls", "misses"]
)
"""Events that are over in an instant: films slow down around them."""
ARRIVALS = frozenset(["enters", "placed", "picked_up"])
"""Events after which the place is what is looked at."""
MOVING_MPS = 0.05
BEFORE_S, AFTER_S = 0.4, 0.3
"""Who moves so long before an event leads in it; the next event's turn comes so long after it."""
AFTERMATH = 2.5
"""What leads may be so many times as far from what it struck, and both are still seen."""
FAR_M = 30.0
"""A body that has left everybody else so far behind no longer acts."""
AT_ONCE_S = 0.15
"""Motions that begin within this are one beat."""
SMALL_M, SWEEP_S, SWEEP_M = 0.5, 0.05, 2.0
"""What is smaller is seen with where it is so long before and after, if that is not farther."""
PASSES = "misses"
"""Type of the event of who passes something: nothing of that is struck and goes away."""
PASSED = "passed"
"""Type of the beat at which who passes something has left it behind him."""
PASSED_MOST_S = 3.0
"""It is waited for so long that who passes has left something behind him."""
SET_OFF = "sets_off"
"""Type of a beat in which somebody throws, kicks or shoots something: no event of a document."""


@dataclass(frozen=True)
class Beat:
    """One event, or a stretch in which something moves.

    Args:
        event: Id of the event; empty if the scene has none.
        type: Of the event.
        time_s: When it happens [s].
        leads: Bodies that move into it; their boxes are seen as a whole.
        others: Bodies that it happens to; what of them is near the leads is seen.
        company: What belongs to the others: members of their group, what is entered.
    """

    event: str
    type: str
    time_s: float
    leads: tuple[int, ...]
    others: tuple[int, ...] = ()
    company: tuple[int, ...] = ()

    @property
    def brief(self) -> bool:
        """Whether it is over in an instant."""
        return self.type in BRIEF

    @property
    def participants(self) -> tuple[int, ...]:
        """Bodies of the event itself."""
        return (*self.leads, *self.others)


class Action:
    """What a director knows of a scene: its beats, and the boxes of all bodies at any time.

    Args:
        scene: The bodies.
        rollout: Their motion; its first world.
        verdict: Events; None or none shows what moves.
        doc: Relations and the timeline.
    """

    def __init__(
        self,
        scene: SimScene,
        rollout: Rollout,
        verdict: SceneVerdict | None,
        doc: EsgDocument,
    ) -> None:
        scene = as_seen(scene, doc)
        self.scene, self.rollout = scene, rollout
        self.time = np.asarray(rollout.time, float)
        signs = np.array(list(itertools.product((-1, 1), (-1, 1), (0, 2))), float)
        half = np.array([b.half_extents for b in scene.bodies])
        offset = np.array([b.origin_offset for b in scene.bodies])
        self._corners = signs[None] * half[:, None] + offset[:, None]
        trails = np.array([trails_m(b) for b in scene.bodies])
        self._corners[:, :4, 0] -= trails[:, None]
        self.trails = bool(trails.any())
        """Whether something leaves a cloud behind it, which it hides from who stands ahead."""
        self._corners[:, 1::2, 2] += np.array([rises_m(b) for b in scene.bodies])[:, None]
        self.still = tuple(
            i
            for i in range(len(scene.bodies))
            if float(np.ptp(rollout.position[0, :, i], axis=0).max()) < 1e-5
            and float(np.ptp(rollout.quaternion[0, :, i], axis=0).max()) < 1e-5
        )
        self.side = told_side(doc) or gestures_side(scene, rollout)
        """Azimuth [rad] from which left and right are as the prompt says; None if any will do."""
        self._acting: dict[tuple[Beat, int], Floats] = {}
        self.beats = tuple(self._met(b) for b in _beats(scene, rollout, verdict, doc))

    def about(self, beat: Beat, *, alone: bool = False) -> Action:
        """The same motion, of which a film shows one beat only.

        Args:
            beat: What it is about.
            alone: Without what is beside it.
        """
        out = copy.copy(self)
        out._acting = {}
        out.beats = (beat if alone else out._met(beat),)
        return out

    def frame(self, time: float) -> int:
        """Index of the frame nearest to a time [s]."""
        right = int(np.clip(np.searchsorted(self.time, time), 1, len(self.time) - 1))
        return right - int(time - self.time[right - 1] < self.time[right] - time)

    def corners(self, frame: int, bodies: Sequence[int]) -> Floats:
        """Corners of bodies' boxes in a frame [m], shape [n, 8, 3]; places that are none are 0."""
        rows = list(bodies)
        p = np.nan_to_num(self.rollout.position[0, frame, rows].astype(float))
        q = np.nan_to_num(self.rollout.quaternion[0, frame, rows].astype(float))
        turned = quat_rotate(np.repeat(q[:, None], 8, axis=1), self._corners[rows])
        return p[:, None] + turned

    def beat_at(self, time: float) -> Beat:
        """The beat whose turn it is at a time [s]."""
        return next((b for b in self.beats if b.time_s + AFTER_S >= time), self.beats[-1])

    def _met(self, beat: Beat) -> Beat:
        """A beat of something alone, with what is beside it then: what it falls from, stops at."""
        if beat.others or beat.company:
            return beat
        frame = self.frame(beat.time_s)
        low, high, reach = _around(self.corners(frame, beat.leads).reshape(-1, 3))
        near = [
            i
            for i, b in enumerate(self.scene.bodies)
            if b.collides and i not in beat.leads
            for box in self.corners(frame, (i,))
            if np.all((box.max(axis=0) > low - reach) & (box.min(axis=0) < high + reach))
        ]
        return replace(beat, company=tuple(near))

    def acting(self, time: float, beat: Beat | None = None) -> Floats:
        """Corners of the boxes of who acts at a time [m], shape [n, 3].

        Leads count as a whole, of all others what is near them: within three times the leads' size
        of a small thing, within a metre and half its size of a large one; farther once it happened.

        Args:
            time: Of the scene [s].
            beat: Default the one whose turn it is.
        """
        beat = beat or self.beat_at(time)
        if beat.type in ARRIVALS:  # nobody follows a ball into the pocket
            time = min(time, beat.time_s + 0.1)
        frame = self.frame(time)
        key = (beat, frame)
        if key not in self._acting:
            self._acting[key] = self._boxes(beat, frame)
        return self._acting[key]

    def _boxes(self, beat: Beat, frame: int) -> Floats:
        leads = self.corners(frame, beat.leads)
        centers = leads.mean(axis=1)
        middle = np.median(centers, axis=0)
        leads = leads[np.linalg.norm(centers - middle, axis=1) <= FAR_M]
        points = leads.reshape(-1, 3)
        low, high, reach = _around(points)
        if float((high - low).max()) < SMALL_M:
            points = self._swept(beat.leads, frame, points)
        struck = beat.others and beat.type not in (PASSES, PASSED)
        if struck and self.time[frame] >= beat.time_s:
            reach *= AFTERMATH
        out = [points]
        mates = (*beat.others, *beat.company)
        for box in self.corners(frame, mates) if mates else ():
            a = np.maximum(box.min(axis=0), low - reach)
            b = np.minimum(box.max(axis=0), high + reach)
            if np.all(a <= b):
                out.append(np.array(list(itertools.product(*zip(a, b, strict=True)))))
        whole = np.concatenate(out)
        whole[:, 2] = np.maximum(whole[:, 2], 0.0)
        return whole

    def _swept(self, leads: Sequence[int], frame: int, points: Floats) -> Floats:
        """Corners of small things a moment before and after, too: what they fly through is seen."""
        time = float(self.time[frame])
        ends = [self.frame(time - SWEEP_S), self.frame(time + SWEEP_S)]
        around = [self.corners(k, leads).reshape(-1, 3) for k in ends]
        near = [p for p in around if float(np.abs(p - points).max()) < SWEEP_M]
        return np.concatenate([points, *near])

    @property
    def human(self) -> bool:
        """Whether people stand beside this action, rather than bend over it."""
        spans = [float(np.ptp(self.acting(b.time_s, b), axis=0).max()) for b in self.beats]
        return max(spans) >= 1.0

    def heading(self) -> Floats:
        """Horizontal way of the lead that moves farthest [m], shape [2]; zero if none moves."""
        last = self.frame(self.beats[-1].time_s + AFTER_S)
        p = np.nan_to_num(self.rollout.position[0, [0, last], :, :2].astype(float))
        leads = sorted({i for b in self.beats for i in b.leads})
        ways = (p[1] - p[0])[leads]
        return ways[int(np.argmax(np.linalg.norm(ways, axis=1)))]


def _around(points: Floats) -> tuple[Floats, Floats, float]:
    """Corners of a box around points [m], and how far from it things belong to it [m]."""
    low, high = points.min(axis=0), points.max(axis=0)
    span = float((high - low).max())
    return low, high, min(3.0 * span, 0.5 * span + 1.0)


def _beats(
    scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None, doc: EsgDocument
) -> tuple[Beat, ...]:
    events = [e for e in verdict.events if e.completed and e.time_s is not None] if verdict else []
    events.sort(key=lambda e: e.time_s or 0.0)
    found = _together([beat for e in events if (beat := _beat(scene, rollout, doc, e))])
    begun = _set_off(scene, rollout, doc)
    if found:
        found = sorted([*found, *_passed(scene, rollout, events, found)], key=_time)
        first = found[0].time_s
        return tuple(sorted((*(b for b in begun if b.time_s <= first), *found), key=_time))
    cast = cast_of(scene, rollout, verdict)
    time = min(1.0, float(rollout.time[-1]))
    moving = _moving(rollout, cast, 0.0, max(time, 2.0 * BEFORE_S))
    moving = moving or tuple(i for i in cast if not scene.bodies[i].static) or cast
    rest = tuple(i for i in cast if i not in moving and not scene.bodies[i].static)
    return (*begun, Beat("", "", time, moving, rest))


def _together(beats: list[Beat]) -> list[Beat]:
    """Those who set off at once are seen together."""
    out: list[Beat] = []
    for beat in beats:
        last = out[-1] if out else None
        if (
            last is None
            or beat.type not in LASTING
            or last.type != beat.type
            or beat.time_s - last.time_s > AT_ONCE_S
        ):
            out.append(beat)
        else:
            leads = tuple(dict.fromkeys((*last.leads, *beat.leads)))
            mates = tuple(dict.fromkeys((*last.company, *beat.company)))
            others = tuple(i for i in (*last.others, *beat.others) if i not in leads)
            mates = tuple(i for i in mates if i not in leads)
            out[-1] = replace(last, leads=leads, others=others, company=mates)
    return out


def _time(beat: Beat) -> float:
    return beat.time_s


def _set_off(scene: SimScene, rollout: Rollout, doc: EsgDocument) -> list[Beat]:
    """Who throws, kicks or shoots something, when that sets off: the doer is seen with it."""
    return [Beat("", SET_OFF, time, (body, *by)) for time, body, by in set_off(scene, rollout, doc)]


def _beat(scene: SimScene, rollout: Rollout, doc: EsgDocument, event: EventVerdict) -> Beat | None:
    bodies = tuple(dict.fromkeys(scene.index(n) for n in event.bodies if n in scene.names))
    time = float(event.time_s or 0.0)
    if not bodies:
        return None
    leads = _moving(rollout, bodies, time - BEFORE_S, time - 0.01)
    leads = leads or _moving(rollout, bodies, time, time + BEFORE_S)
    leads = leads or tuple(i for i in bodies if not scene.bodies[i].static) or bodies
    others = tuple(i for i in bodies if i not in leads)
    groups = {scene.bodies[i].group for i in others} - {""}
    company = {i for i, b in enumerate(scene.bodies) if b.group in groups}
    leads = (*leads, *(i for i in fixed_to(scene, leads) if i not in bodies))
    if event.type in INTO:
        company |= set(openings_of(scene, doc, bodies))
    mates = tuple(sorted(company - {*leads, *others}))
    return Beat(event.id, event.type, time, leads, others, mates)


def _passed(
    scene: SimScene, rollout: Rollout, events: Sequence[EventVerdict], beats: Sequence[Beat]
) -> list[Beat]:
    """When those who pass something have left it behind them: both must be seen then, too."""
    pairs = {e.id: [scene.index(n) for n in e.bodies if n in scene.names] for e in events}
    out: list[Beat] = []
    for beat in beats:
        pair = pairs.get(beat.event, [])
        if beat.type == PASSES and len(pair) == 2:
            time = _left_behind(scene, rollout, pair, beat.time_s)
            out += [replace(beat, type=PASSED, time_s=time)] if time > beat.time_s else []
    return out


def _left_behind(scene: SimScene, rollout: Rollout, pair: Sequence[int], time: float) -> float:
    """When the first of two has left the second behind him [s], 0 if he does not soon."""
    a, b = pair
    now = (rollout.time >= time) & (rollout.time <= time + PASSED_MOST_S)
    apart = (rollout.position[0, now, a] - rollout.position[0, now, b])[:, :2].astype(float)
    pace = rollout.linear_velocity[0, now, a, :2].astype(float)
    ahead = (apart * pace).sum(axis=1) / np.maximum(np.linalg.norm(pace, axis=1), 1e-6)
    size = sum(max(scene.bodies[i].half_extents[:2]) for i in (a, b))
    there = np.flatnonzero(ahead >= size)
    return float(np.asarray(rollout.time)[now][there[0]]) if len(there) else 0.0


def _moving(rollout: Rollout, bodies: Sequence[int], start: float, end: float) -> tuple[int, ...]:
    """Those of the bodies that move between two times [s]."""
    now = (rollout.time >= start) & (rollout.time <= end)
    if not now.any():
        return ()
    speed = np.linalg.norm(np.nan_to_num(rollout.linear_velocity[0, now]), axis=-1).max(axis=0)
    turning = np.linalg.norm(np.nan_to_num(rollout.angular_velocity[0, now]), axis=-1).max(axis=0)
    return tuple(i for i in bodies if speed[i] > MOVING_MPS or turning[i] > 0.2)
