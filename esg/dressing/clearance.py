"""Where the action is: what every body sweeps, what lies on the ground, and how near one may come.

Everything is told in the plane of a `Frame`, turned so that streets, lanes and walls run along its
axes; boxes in it are axis-aligned and, where a body is turned, larger than it.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, Rollout, SimScene
from esg.units import quat_rotate

Floats = NDArray[np.float64]
KEEP_M = 2.0
"""Nothing of the dressing comes nearer to any body at any time."""
STEP_M = 0.2
"""A path is sampled about so often; its boxes are grown by half of it."""
MOST_SAMPLES = 700
DECAL_M = 0.05
"""Things stand so far from roads and lanes."""
GROUND_HALF_M = 45.0
"""A surface without collision at least this wide is the ground itself (esg.view.parts)."""
WATER = "water"
WATERS = frozenset({"pool", "pond"})
"""Categories of what lies flat and is water: lakes and rivers are pools."""
GROUNDS = frozenset({"ground", "floor", "terrain", "land"})
"""Categories of what carries everything (esg.graph.rules_scene)."""
CROSSING = "crossing"
"""Region of roads that cross: where they do."""
_SIGNS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (0, 2)], float)


@dataclass(frozen=True)
class Frame:
    """Axes of a place, counter-clockwise from the world's by `yaw` [rad]."""

    yaw: float

    def into(self, points: Floats) -> Floats:
        """World points [m], shape [..., 2 or more], in the frame's plane, shape [..., 2]."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        x, y = points[..., 0], points[..., 1]
        return np.stack([c * x + s * y, c * y - s * x], axis=-1)

    def out(self, point: tuple[float, float]) -> tuple[float, float]:
        """A point of the frame in the world [m]."""
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        return c * point[0] - s * point[1], s * point[0] + c * point[1]


@dataclass(frozen=True)
class Box:
    """A rectangle along the frame's axes [m]."""

    x0: float
    y0: float
    x1: float
    y1: float

    @classmethod
    def around(cls, middle: tuple[float, float], size: tuple[float, float]) -> Box:
        """Of a size about a point."""
        (x, y), (a, b) = middle, size
        return cls(x - 0.5 * a, y - 0.5 * b, x + 0.5 * a, y + 0.5 * b)

    @property
    def middle(self) -> tuple[float, float]:
        """Its centre."""
        return 0.5 * (self.x0 + self.x1), 0.5 * (self.y0 + self.y1)

    @property
    def size(self) -> tuple[float, float]:
        """Its extents."""
        return self.x1 - self.x0, self.y1 - self.y0

    def grown(self, by: float) -> Box:
        """Larger by `by` on every side."""
        return Box(self.x0 - by, self.y0 - by, self.x1 + by, self.y1 + by)

    def union(self, other: Box) -> Box:
        """The least box around both."""
        return Box(
            min(self.x0, other.x0),
            min(self.y0, other.y0),
            max(self.x1, other.x1),
            max(self.y1, other.y1),
        )

    def at_least(self, size: tuple[float, float]) -> Box:
        """About the same middle, no smaller than `size`."""
        (a, b), (x, y) = self.size, size
        return Box.around(self.middle, (max(a, x), max(b, y)))

    def gap(self, others: Floats) -> Floats:
        """Distances to boxes, shape [n]; below 0 where they overlap, by how much at least.

        Args:
            others: Rows x0, y0, x1, y1 [m], shape [n, 4].
        """
        dx = np.maximum(others[:, 0] - self.x1, self.x0 - others[:, 2])
        dy = np.maximum(others[:, 1] - self.y1, self.y0 - others[:, 3])
        apart = np.hypot(np.maximum(dx, 0.0), np.maximum(dy, 0.0))
        return np.where(apart > 0.0, apart, np.maximum(dx, dy))

    def to(self, other: Box) -> float:
        """Distance to one box, as of `gap`."""
        return float(self.gap(np.array([other.row()]))[0])

    def row(self) -> list[float]:
        """x0, y0, x1, y1."""
        return [self.x0, self.y0, self.x1, self.y1]


@dataclass
class Clearance:
    """What the dressing keeps away from.

    Args:
        frame: Axes of all boxes.
        swept: Boxes of all solid bodies along their ways, shape [n, 4] (x0, y0, x1, y1) [m].
        of_body: Which body each is of, shape [n].
        decals: Boxes of what lies flat on the ground, by category.
        core: Where the action happens most of the time.
        top: Greatest height that anything reaches [m].
        placed: Boxes of what stands already, with the room it asks for.
    """

    frame: Frame
    swept: Floats
    of_body: NDArray[np.int64]
    decals: list[tuple[str, Box]]
    core: Box
    top: float
    placed: list[tuple[Box, float]] = field(default_factory=list[tuple[Box, float]])

    @property
    def reach(self) -> Box:
        """The least box around everything that is swept."""
        if not len(self.swept):
            return self.core
        low, high = self.swept[:, :2].min(axis=0), self.swept[:, 2:].max(axis=0)
        return Box(float(low[0]), float(low[1]), float(high[0]), float(high[1]))

    def free(self, box: Box, keep: float = KEEP_M) -> bool:
        """Whether a box is at least `keep` [m] from every path."""
        return not len(self.swept) or float(box.gap(self.swept).min()) >= keep

    def near(self, box: Box, bodies: frozenset[int], keep: float) -> bool:
        """Whether a box is nearer than `keep` [m] to the way of one of some bodies."""
        mine = np.isin(self.of_body, list(bodies))
        return bool(mine.any()) and float(box.gap(self.swept[mine]).min()) < keep

    def open(self, box: Box, gap: float) -> bool:
        """Whether a box overlaps nothing that lies or stands there, with `gap` [m] between."""
        if any(box.to(decal) < DECAL_M for _, decal in self.decals):
            return False
        if not self.placed:
            return True
        rows = np.array([b.row() for b, _ in self.placed])
        room = np.array([max(gap, g) for _, g in self.placed])
        return bool((box.gap(rows) > room - 1e-6).all())


def covered(body: Body, *, indoor: bool, ground: str = "") -> bool:
    """Whether the ground of a place takes the place of a flat body.

    So it is with the ground itself, in a room with a road that nobody speaks of (drafts lay one
    under whatever drives), and with a lake where the place is one: its edge would be seen in it.

    Args:
        body: Any body.
        indoor: Whether the place is a room.
        ground: Row of the table of surfaces that its ground has.
    """
    if body.collides:
        return False
    if ground == WATER and body.category in WATERS:
        return True
    if body.category in GROUNDS or max(body.half_extents[:2]) > GROUND_HALF_M:
        return True
    return indoor and body.category == "road" and not body.mentioned


def clearance(scene: SimScene, rollout: Rollout, frame: Frame, *, indoor: bool) -> Clearance:
    """What the bodies of a replay sweep, in a frame's plane.

    Args:
        scene: The bodies.
        rollout: Their motion; of its first world.
        frame: Axes of the place.
        indoor: Whether the place is a room.
    """
    rows: list[Floats] = []
    owners: list[Floats] = []
    decals: list[tuple[str, Box]] = []
    cores: list[Box] = []
    top = 0.0
    for index, body in enumerate(scene.bodies):
        p = np.asarray(rollout.position[0, :, index], float)
        q = np.asarray(rollout.quaternion[0, :, index], float)
        seen = np.isfinite(p).all(axis=1) & np.isfinite(q).all(axis=1)
        p, q = p[seen], q[seen]
        if not len(p):
            continue
        if not body.collides:
            if not covered(body, indoor=indoor):
                for patch in _patches(scene, body):
                    box = _boxes(patch, p[:1], q[:1], frame)[0][0]
                    decals.append((body.category, Box(*(float(v) for v in box))))
            continue
        frames, step = _sampled(body, p, q)
        boxes, heights = _boxes(body, p[frames], q[frames], frame)
        slack = 0.5 * step if len(frames) > 1 else 0.0
        boxes = boxes + np.array([-slack, -slack, slack, slack])
        rows.append(boxes)
        owners.append(np.full(len(boxes), index))
        top = max(top, float(heights.max()))
        cores.append(_core(body, p, q, frame))
    swept = np.concatenate(rows) if rows else np.zeros((0, 4))
    of_body = np.concatenate(owners) if owners else np.zeros(0)
    core = cores[0] if cores else Box(-1.0, -1.0, 1.0, 1.0)
    for other in cores[1:]:
        core = core.union(other)
    return Clearance(frame, swept, of_body.astype(np.int64), decals, core, top)


def _patches(scene: SimScene, body: Body) -> list[Body]:
    """What a flat body covers: of roads that cross each its strip, not the blocks between them."""
    crossing = next((r for r in scene.regions if r.name == f"{body.name}/{CROSSING}"), None)
    if crossing is None:
        return [body]
    (x, y, z), (wide, deep, _) = body.half_extents, crossing.half_extents
    return [replace(body, half_extents=(x, deep, z)), replace(body, half_extents=(wide, y, z))]


def _sampled(body: Body, p: Floats, q: Floats) -> tuple[NDArray[np.int64], float]:
    """Frames between which a body moves no farther than a step [m], and that step."""
    size = float(np.linalg.norm(body.half_extents))
    moved = np.linalg.norm(np.diff(p, axis=0), axis=1)
    turned = 2.0 * np.arccos(np.clip(np.abs((q[1:] * q[:-1]).sum(axis=1)), 0.0, 1.0))
    way = np.concatenate([[0.0], np.cumsum(moved + size * turned)])
    step = max(STEP_M, float(way[-1]) / MOST_SAMPLES)
    _, first = np.unique(np.floor(way / step), return_index=True)
    frames = np.unique(np.append(first, len(p) - 1))
    jump = float(np.max(np.diff(way[frames]), initial=0.0))
    return frames, max(step, jump)


def _boxes(body: Body, p: Floats, q: Floats, frame: Frame) -> tuple[Floats, Floats]:
    """Boxes in the frame's plane, shape [n, 4], and the tops [m], shape [n], of a body's box."""
    local = _SIGNS * np.asarray(body.half_extents) + np.asarray(body.origin_offset)
    corners = p[:, None, :] + quat_rotate(q[:, None, :], local[None])
    flat = frame.into(corners)
    return np.concatenate([flat.min(axis=1), flat.max(axis=1)], axis=1), corners[..., 2].max(axis=1)


def _core(body: Body, p: Floats, q: Floats, frame: Frame) -> Box:
    """Where a body is for the middle 90% of the time, and at its start."""
    times = np.unique(np.linspace(0, len(p) - 1, 40).astype(int))
    boxes, _ = _boxes(body, p[times], q[times], frame)
    low, high = np.quantile(boxes[:, :2], 0.05, axis=0), np.quantile(boxes[:, 2:], 0.95, axis=0)
    low, high = np.minimum(low, boxes[0, :2]), np.maximum(high, boxes[0, 2:])
    return Box(float(low[0]), float(low[1]), float(high[0]), float(high[1]))
