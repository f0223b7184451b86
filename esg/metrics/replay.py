"""One world of a rollout, prepared for judging: trajectories, hits, control, geometry."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking import hidden
from esg.engines.program import (
    AdjustProperties,
    BuoyUp,
    DriveJoint,
    HoldVelocity,
    Primitive,
    Program,
)
from esg.engines.scene import ContactLog, Rollout, SimScene
from esg.metrics.geometry import (
    Core,
    body_cores,
    box_core,
    compound_distance,
    lowest_point,
    place,
    region_core,
)
from esg.thresholds import (
    BLOW_FACTOR,
    BLOW_IMPULSE_NS,
    BLOW_WINDOW_S,
    HIT_GAP_S,
    IMPULSE_FRAMES,
    IMPULSE_WINDOW_S,
)
from esg.units import quat_rotate, yaw_from_quat

Floats = NDArray[np.float64]
GROUND_INDEX = -1


@dataclass(frozen=True)
class Hit:
    """One uninterrupted touch of a pair.

    Args:
        a, b: Body indices; b may be GROUND_INDEX.
        time: Of the first contact [s].
        end: Of the last contact [s].
        depth: Penetration at the first contact [m].
        impulse: Normal impulse accumulated at the start of the hit [N s].
    """

    a: int
    b: int
    time: float
    end: float
    depth: float
    impulse: float


@dataclass(frozen=True)
class Control:
    """One thing the program does to one body.

    Args:
        time: When it starts [s].
        primitive: The primitive.
    """

    time: float
    primitive: Primitive


class Replay:
    """Read-only view of one world.

    Args:
        scene: The scene that was simulated.
        program: The control program that was executed.
        rollout: The rollout.
        world: Which world of it.

    Attributes:
        absent: Frames at which a body is not there: fragments before, what has broken after, shape
            [T, B].
    """

    def __init__(self, scene: SimScene, program: Program, rollout: Rollout, world: int = 0) -> None:
        self.scene = scene
        self.program = program
        self.time = np.asarray(rollout.time, float)
        self.position = np.asarray(rollout.position[world], float)
        self.quaternion = np.asarray(rollout.quaternion[world], float)
        self.velocity = np.asarray(rollout.linear_velocity[world], float)
        self.spin = np.asarray(rollout.angular_velocity[world], float)
        self.contacts: ContactLog = rollout.contacts.select(world)
        self.valid = bool(rollout.valid[world])
        self.speed = np.linalg.norm(self.velocity, axis=-1)
        self.absent = hidden(scene, self.position, self.quaternion)
        self.cores: tuple[tuple[Core, ...], ...] = tuple(body_cores(b) for b in scene.bodies)
        steps = np.diff(self.time)
        self.frame_s = float(np.median(steps)) if len(steps) else rollout.dt

    @property
    def end(self) -> float:
        """Time of the last frame [s]."""
        return float(self.time[-1])

    def frame_at(self, time: float) -> int:
        """Index of the last frame at or before `time` (tolerating rounding)."""
        k = int(np.searchsorted(self.time, time + 0.25 * self.frame_s, side="right")) - 1
        return min(max(k, 0), len(self.time) - 1)

    def frame_before(self, time: float) -> int:
        """Index of the last frame that lies clearly before `time`."""
        k = int(np.searchsorted(self.time, time - 0.25 * self.frame_s, side="left")) - 1
        return max(k, 0)

    def after(self, time: float | None) -> int:
        """Index of the first frame later than `time`; 0 for None."""
        if time is None:
            return 0
        return int(np.searchsorted(self.time, time + 0.25 * self.frame_s, side="right"))

    def placed(self, body: int, frame: int) -> tuple[Core, ...]:
        """Cores of a body's shapes in the world at a frame."""
        p, q = self.position[frame, body], self.quaternion[frame, body]
        return tuple(place(c, p, q) for c in self.cores[body])

    def placed_solid(self, body: int, frame: int) -> tuple[Core, ...]:
        """Like placed, with the bounding box for bodies that have no collision shapes."""
        if self.cores[body]:
            return self.placed(body, frame)
        p, q = self.position[frame, body], self.quaternion[frame, body]
        return (place(box_core(self.scene.bodies[body]), p, q),)

    def placed_region(self, region: int, frame: int) -> tuple[Core, ...]:
        """The box of a region in the world at a frame."""
        r = self.scene.regions[region]
        parent = self.scene.index(r.parent)
        p, q = self.position[frame, parent], self.quaternion[frame, parent]
        return (place(region_core(r), p, q),)

    def penetration(self, a: int, b: int, frame: int) -> float:
        """Penetration depth of two bodies at a frame [m], 0 if apart; b may be the ground."""
        if self.absent[frame, [a, b] if b != GROUND_INDEX else [a]].any():
            return 0.0
        if b == GROUND_INDEX:
            return max(0.0, -self.lowest(a, frame))
        cores_a, cores_b = self.placed(a, frame), self.placed(b, frame)
        if not cores_a or not cores_b:
            return 0.0
        return max(0.0, -compound_distance(cores_a, cores_b, cutoff=0.0))

    def lowest(self, body: int, frame: int) -> float:
        """Height of a body's lowest point at a frame [m]."""
        p, q = self.position[frame, body], self.quaternion[frame, body]
        return lowest_point(self.cores[body] or (box_core(self.scene.bodies[body]),), p, q)

    @cached_property
    def radii(self) -> Floats:
        """Radius of every body's bounding sphere about its frame origin [m], shape [B]."""
        out: list[float] = []
        for body, cores in zip(self.scene.bodies, self.cores, strict=True):
            parts = cores or (box_core(body),)
            out.append(max(float(np.linalg.norm(c.points, axis=1).max()) + c.radius for c in parts))
        return np.array(out)

    def up(self, body: int) -> Floats:
        """World direction of the body's up axis over time, shape [T, 3]."""
        return quat_rotate(self.quaternion[:, body], np.array([0.0, 0.0, 1.0]))

    def heading(self, body: int) -> Floats:
        """Unwrapped heading [rad] over time, shape [T]: yaw, or course for a round body."""
        if self.scene.bodies[body].roll_radius > 0:
            v = self.velocity[:, body]
            course = np.arctan2(v[:, 1], v[:, 0])
            moving = np.hypot(v[:, 0], v[:, 1]) > 0.2
            if not moving.any():
                return np.zeros(len(self.time))
            # A body at rest has no course: it keeps its last (before the first, the first) one.
            index = np.where(moving, np.arange(len(course)), -1)
            index = np.maximum.accumulate(index)
            course = course[np.where(index < 0, int(np.argmax(moving)), index)]
            return np.unwrap(course)
        return np.unwrap(yaw_from_quat(self.quaternion[:, body]))

    def hits(self, a: int, b: int) -> tuple[Hit, ...]:
        """All hits of a pair in order of time."""
        c = self.contacts
        lo, hi = (a, b) if b == GROUND_INDEX else (min(a, b), max(a, b))
        rows = np.flatnonzero(
            ((c.a == lo) & (c.b == hi) | (c.a == hi) & (c.b == lo)) & (c.impulse > 0)
        )
        if b == GROUND_INDEX and not np.any(c.b == GROUND_INDEX):
            return self._inferred_ground_hits(a)
        if not len(rows):
            return ()
        rows = rows[np.argsort(c.time[rows], kind="stable")]
        gap = max(HIT_GAP_S, 1.5 * self.frame_s)
        starts = hit_starts(c.time[rows], c.impulse[rows], gap)
        window = max(IMPULSE_WINDOW_S, IMPULSE_FRAMES * self.frame_s) - 0.25 * self.frame_s
        out: list[Hit] = []
        for k, start in enumerate(starts):
            stop = starts[k + 1] if k + 1 < len(starts) else len(rows)
            part = rows[start:stop]
            t = c.time[part]
            out.append(
                Hit(
                    a,
                    b,
                    time=float(t[0]),
                    end=float(t[-1]),
                    depth=float(c.depth[part[t <= t[0] + 0.25 * self.frame_s]].max()),
                    impulse=float(c.impulse[part[t < t[0] + window]].sum()),
                )
            )
        return tuple(out)

    def _inferred_ground_hits(self, body: int) -> tuple[Hit, ...]:
        """Ground hits from the trajectory, for logs without ground contacts: the vertical velocity
        jumps upwards by more than free fall explains while the lowest point touches the ground.
        """
        if self.scene.bodies[body].static or len(self.time) < 2:
            return ()
        mass = self.scene.bodies[body].mass
        vz = self.velocity[:, body, 2]
        gained = np.diff(vz) - self.scene.gravity[2] * np.diff(self.time)
        falling = vz[:-1] < -0.05
        out: list[Hit] = []
        for k in np.flatnonzero(falling & (mass * gained > 0.1)):
            t = float(self.time[k + 1])
            low = self.lowest(body, int(k) + 1)
            reach = 0.02 + abs(float(vz[k])) * self.frame_s
            if low < reach and (not out or t > out[-1].time + HIT_GAP_S):
                depth = max(0.0, -low)
                out.append(Hit(body, GROUND_INDEX, t, t, depth, float(mass * gained[k])))
        return tuple(out)

    def controls(self, body: int) -> tuple[Control, ...]:
        """What the program does to one body, and to the joint that carries it, in order of time."""
        name = self.scene.bodies[body].name
        axles = {j.name for j in self.scene.joints if j.child == name}
        return tuple(
            Control(p.time, p)
            for p in self.program.primitives
            if (p.joint in axles if isinstance(p, DriveJoint) else p.body == name)
        )

    def motions(self, body: int) -> tuple[Control, ...]:
        """The controls of a body that set it in motion (launches, impulses, holds, motors)."""
        return tuple(c for c in self.controls(body) if _moves(c.primitive))

    def brakings(self, body: int) -> tuple[float, ...]:
        """Times at which the program brakes a body: brakes, raised damping or friction, a hold that
        slows down, or a hold below the speed the body has.
        """
        b = self.scene.bodies[body]
        linear, friction, braking = b.linear_damping, b.friction, 0.0
        out: list[float] = []
        for c in self.controls(body):
            p = c.primitive
            if isinstance(p, AdjustProperties):
                more = p.linear_damping is not None and p.linear_damping > linear + 1e-9
                rough = p.friction is not None and p.friction > friction + 1e-9
                linear = linear if p.linear_damping is None else p.linear_damping
                friction = friction if p.friction is None else p.friction
                hard = p.braking is not None and p.braking > braking + 1e-9
                braking = braking if p.braking is None else p.braking
                if more or rough or hard:
                    out.append(c.time)
            elif isinstance(p, HoldVelocity):
                now = float(self.speed[self.frame_before(c.time), body])
                if p.acceleration < 0 or (c.time > 0 and p.speed < now - 0.1):
                    out.append(c.time)
        return tuple(out)


def _moves(p: Primitive) -> bool:
    if isinstance(p, DriveJoint):
        return not p.lets_go
    return not isinstance(p, AdjustProperties | BuoyUp)


def hit_starts(time: Floats, impulse: Floats, gap: float) -> NDArray[np.int64]:
    """Indices of the rows (sorted by time) at which a hit of the pair starts."""
    new = np.diff(time, prepend=-math.inf) > gap
    begin = 0
    for k in np.flatnonzero((impulse > BLOW_IMPULSE_NS) | new):
        if new[k]:
            begin = int(k)
        elif time[k] - time[begin] >= BLOW_WINDOW_S:
            # Rows of one hit are no farther apart than the gap: the window is never empty.
            before = impulse[begin:k][time[begin:k] >= time[k] - BLOW_WINDOW_S]
            if impulse[k] > BLOW_FACTOR * before.max():
                new[k] = True
                begin = int(k)
    return np.flatnonzero(new)
