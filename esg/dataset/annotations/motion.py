"""What a recorded trajectory shows, measured: hits, who began to move and why, speeds, ends.

Everything is measured on a row of table `trajectories`, as anybody can who has the dataset; nothing
here looks at the prompt, the plan or the verdict. Definitions: docs/dataset/annotations.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking import hidden
from esg.engines.scene import FRAGMENT, SimScene
from esg.thresholds import HIT_GAP_S, MIN_IMPULSE_NS, MOVING_MPS, STOPPED_FOR_S, STOPPED_MPS

Floats = NDArray[np.float64]

SUPPORT_S = 0.05
"""What touches within the first moments lies or stands on the other: never a hit of the two."""
IMPULSE_S = 0.05
"""The impulse of a hit is what is passed on within this time (the judge's `IMPULSE_WINDOW_S`)."""
DOUBT = 2.0
"""A value that is no farther from its threshold than by this factor is in doubt: nothing is asked
that hangs on it."""
REST_MPS = 0.05
"""What is slower than this at the start is at rest."""
MOVED_M, UNMOVED_M = 0.05, 0.02
"""What is ever farther from its start than the first has moved; what never is than the second has
not; what is between is in doubt."""
CAUSE_S = 0.15
"""A touch this short before a body begins to move has set it in motion."""
FELL_DEG, STOOD_DEG = 60.0, 30.0
"""What tilts by more than the first has fallen over, by less than the second has not."""
TALL = 1.2
"""What is higher than wide by this can fall over."""
TURNING_MPS = 0.3
"""Slower motion has no direction that one could see."""
AFTER_S = 0.2
"""The direction after a hit is that of so long after."""


@dataclass(frozen=True)
class Hit:
    """The first hit of two bodies.

    Args:
        a, b: Indices of the bodies, who strikes first if one does.
        time: Of the first touch [s].
        impulse: Passed on within `IMPULSE_S` [N s].
        mutual: Whether both were on their way to each other, or neither was.
    """

    a: int
    b: int
    time: float
    impulse: float
    mutual: bool

    @property
    def pair(self) -> frozenset[int]:
        return frozenset((self.a, self.b))


class Motion:
    """One recorded trajectory.

    Args:
        row: Of table `trajectories`.
        scene: Sizes and kinds of its bodies, in the same order.
    """

    def __init__(self, row: Mapping[str, Any], scene: SimScene) -> None:
        n, bodies = int(row["n_frames"]), len(row["bodies"])
        self.scene = scene
        self.names: tuple[str, ...] = tuple(row["bodies"])
        self.time = np.asarray(row["time_s"], float)

        def array(name: str, width: int) -> Floats:
            return np.asarray(row[name], float).reshape(n, bodies, width)

        self.position = array("position_m", 3)
        self.quaternion = array("quaternion_xyzw", 4)
        self.velocity = array("linear_velocity_mps", 3)
        self.spin = array("angular_velocity_radps", 3)
        self.speed = np.linalg.norm(self.velocity, axis=-1)
        self.contact_time = np.asarray(row["contact_time_s"], float)
        self.contact_a = np.asarray(row["contact_a"], int)
        self.contact_b = np.asarray(row["contact_b"], int)
        self.contact_impulse = np.asarray(row["contact_impulse_ns"], float)
        absent = hidden(scene, self.position, self.quaternion)
        self.whole = [
            b.category != FRAGMENT and not bool(absent[:, i].any())
            for i, b in enumerate(scene.bodies)
        ]

    @property
    def end(self) -> float:
        """Time of the last frame [s]."""
        return float(self.time[-1])

    @cached_property
    def touches(self) -> dict[tuple[int, int], tuple[Floats, Floats]]:
        """Times [s] and impulses [N s] of every pair's contacts, in order of time."""
        out: dict[tuple[int, int], tuple[Floats, Floats]] = {}
        low = np.minimum(self.contact_a, self.contact_b)
        high = np.maximum(self.contact_a, self.contact_b)
        for pair in sorted({(int(a), int(b)) for a, b in zip(low, high, strict=True) if a >= 0}):
            rows = np.flatnonzero((low == pair[0]) & (high == pair[1]))
            rows = rows[np.argsort(self.contact_time[rows], kind="stable")]
            out[pair] = self.contact_time[rows], self.contact_impulse[rows]
        return out

    @cached_property
    def supports(self) -> frozenset[frozenset[int]]:
        """Pairs that touch from the start: one lies or stands on the other."""
        return frozenset(
            frozenset(pair) for pair, (time, _) in self.touches.items() if time[0] <= SUPPORT_S
        )

    @cached_property
    def _strengths(self) -> dict[tuple[int, int], list[tuple[float, float]]]:
        """Time and impulse of every touch of a pair that does not touch from the start."""
        out: dict[tuple[int, int], list[tuple[float, float]]] = {}
        for pair, (time, impulse) in self.touches.items():
            if frozenset(pair) in self.supports or not self._named(pair):
                continue
            starts = np.flatnonzero(np.diff(time, prepend=-math.inf) > HIT_GAP_S)
            out[pair] = [
                (float(time[k]), float(impulse[k:][time[k:] <= time[k] + IMPULSE_S].sum()))
                for k in starts
            ]
        return out

    def _named(self, pair: tuple[int, int]) -> bool:
        return all(self.scene.bodies[i].category != FRAGMENT for i in pair)

    @cached_property
    def hits(self) -> tuple[Hit, ...]:
        """First hits of all pairs, in order of time, those in doubt left out."""
        out: list[Hit] = []
        for pair, found in self._strengths.items():
            if pair in self.doubtful:
                continue
            first = next((f for f in found if f[1] > MIN_IMPULSE_NS), None)
            if first is not None:
                out.append(self.hit_at(*pair, *first))
        return tuple(sorted(out, key=lambda h: (h.time, h.a, h.b)))

    @cached_property
    def doubtful(self) -> frozenset[tuple[int, int]]:
        """Pairs of which one may doubt whether, or when, they first hit each other."""
        low, high = MIN_IMPULSE_NS / DOUBT, MIN_IMPULSE_NS * DOUBT
        out: set[tuple[int, int]] = set()
        for pair, found in self._strengths.items():
            clear = next((k for k, (_, p) in enumerate(found) if p >= high), len(found))
            if any(low <= p < high for _, p in found[:clear]):
                out.add(pair)
        return frozenset(out)

    def hit_at(self, a: int, b: int, time: float, impulse: float) -> Hit:
        """A hit of two bodies at a time, with who strikes whom: the one that moves, of two that
        move the one that moves towards the other, while that one does not."""
        k = self.before(time)
        way = self.position[k, b] - self.position[k, a]
        length = float(np.linalg.norm(way))
        way = way / length if length > 0.0 else way
        fast = [float(self.speed[k, i]) > MOVING_MPS for i in (a, b)]
        towards = float(self.velocity[k, a] @ way), float(-self.velocity[k, b] @ way)
        if fast[0] != fast[1]:
            strikes = fast
        else:
            strikes = [t > MOVING_MPS for t in towards] if fast[0] else [True, True]
        if strikes[0] == strikes[1]:
            return Hit(a, b, time, impulse, True)
        return Hit(a, b, time, impulse, False) if strikes[0] else Hit(b, a, time, impulse, False)

    def hit_of(self, a: int, b: int) -> Hit | None:
        """The first hit of two bodies, None if there is none or one may doubt it."""
        return next((h for h in self.hits if h.pair == frozenset((a, b))), None)

    def before(self, time: float) -> int:
        """Number of the last frame that shows nothing of what happens at a time yet."""
        return max(0, int(np.searchsorted(self.time, time - 1e-4, side="left")) - 1)

    def at(self, time: float) -> int:
        """Number of the frame nearest to a time."""
        return int(np.argmin(np.abs(self.time - time)))

    def distance(self, body: int) -> float:
        """How far a body ever is from where it started [m]."""
        return float(np.linalg.norm(self.position[:, body] - self.position[0, body], axis=1).max())

    def displacement(self, body: int) -> float:
        """How far from its start a body ends [m]."""
        return float(np.linalg.norm(self.position[-1, body] - self.position[0, body]))

    def moved(self, body: int) -> bool | None:
        """Whether a body has moved; None in doubt."""
        far = self.distance(body)
        return None if UNMOVED_M <= far <= MOVED_M else far > MOVED_M

    def moves_at_first(self, body: int) -> bool | None:
        """Whether a body is moving when the recording begins; None in doubt."""
        speed = float(self.speed[0, body])
        return None if REST_MPS <= speed <= MOVING_MPS else speed > MOVING_MPS

    def set_off(self, body: int) -> float | None:
        """When a body that is at rest at first begins to move [s]; None if it does not."""
        if self.speed[0, body] >= REST_MPS:
            return None
        faster = np.flatnonzero(self.speed[:, body] > MOVING_MPS)
        return float(self.time[faster[0]]) if len(faster) else None

    def cause(self, body: int) -> int | None:
        """Who set a body in motion: the one moving body that touched it as it began to move."""
        start = self.set_off(body)
        if start is None or not self.moved(body):
            return None
        found: set[int] = set()
        for pair, (time, _) in self.touches.items():
            if body not in pair or frozenset(pair) in self.supports:
                continue
            near = time[(time >= start - CAUSE_S) & (time <= start + 1e-6)]
            other = pair[0] if pair[1] == body else pair[1]
            if len(near) and self.speed[self.before(float(near[0])), other] > MOVING_MPS:
                found.add(other)
        if len(found) != 1 or not all(self._named((body, o)) for o in found):
            return None
        return found.pop()

    def first_cause(self, body: int) -> list[int]:
        """Who set it in motion, who set that in motion, and so on to one that nobody did."""
        out: list[int] = []
        at: int | None = self.cause(body)
        while at is not None and at not in out and at != body:
            out.append(at)
            at = self.cause(at)
        return out

    def rest_time(self, body: int) -> float | None:
        """When a body that has moved comes to rest for good [s]; None if it does not."""
        slow = self.speed[:, body] < STOPPED_MPS
        moving = np.flatnonzero(~slow)
        if not len(moving) or moving[-1] + 1 >= len(slow):
            return None
        time = float(self.time[moving[-1] + 1])
        return time if self.end - time >= STOPPED_FOR_S else None

    def at_rest(self, body: int) -> bool:
        """Whether it lies still in the end."""
        last = self.time >= self.end - STOPPED_FOR_S
        return bool((self.speed[last, body] < STOPPED_MPS).all())

    def top_speed(self, body: int) -> float:
        """[m/s]."""
        return float(self.speed[:, body].max())

    def up(self, body: int) -> Floats:
        """The axis of a body that points up at first, in the world, shape [T, 3]."""
        x, y, z, w = np.moveaxis(self.quaternion[:, body], -1, 0)
        axes = np.stack(
            [
                np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], -1),
                np.stack([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)], -1),
                np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], -1),
            ]
        )
        k = int(np.argmax(np.abs(axes[:, 0, 2])))
        return axes[k] * (1.0 if axes[k, 0, 2] >= 0.0 else -1.0)

    def fell_over(self, body: int) -> bool | None:
        """Whether something that stood has fallen over; None in doubt, or if it cannot."""
        if not self.stands(body):
            return None
        tilt = np.degrees(np.arccos(np.clip(self.up(body)[:, 2], -1.0, 1.0)))
        worst, last = float(tilt.max()), float(tilt[-1])
        if worst < STOOD_DEG:
            return False
        return True if worst > FELL_DEG and last > FELL_DEG else None

    def stands(self, body: int) -> bool:
        """Whether a body is taller than wide, and upright at first."""
        b = self.scene.bodies[body]
        x, y, z = b.half_extents
        upright = float(self.up(body)[0, 2]) > 0.95
        return z > TALL * max(x, y) and b.roll_radius == 0.0 and upright and not b.static

    def heading(self, body: int, frame: int) -> float | None:
        """Direction of its horizontal motion [deg], counter-clockwise; None if it hardly moves."""
        x, y = self.velocity[frame, body, :2]
        return math.degrees(math.atan2(y, x)) if math.hypot(x, y) > TURNING_MPS else None

    def turn(self, body: int, first: int, last: int) -> float | None:
        """How far its direction of motion turns to the left between two frames [deg].

        None if it hardly moves at a frame between.
        """
        flat = self.velocity[first : last + 1, body, :2]
        if not len(flat) or np.linalg.norm(flat, axis=1).min() <= TURNING_MPS:
            return None
        heading = np.unwrap(np.arctan2(flat[:, 1], flat[:, 0]))
        return float(np.degrees(heading[-1] - heading[0]))


def side(degrees: float) -> str | None:
    """Where a turn to the left by some degrees leads: straight on, left, right, back.

    None near the borders of two of them.
    """
    angle = (degrees + 180.0) % 360.0 - 180.0
    for low, high, name in SIDES:
        if low <= abs(angle) <= high:
            if name != "side":
                return name
            return "left" if angle > 0.0 else "right"
    return None


SIDES = ((0.0, 20.0, "straight on"), (30.0, 150.0, "side"), (160.0, 180.0, "back"))
"""Least and largest angle [deg] of every direction; between them one may doubt."""
