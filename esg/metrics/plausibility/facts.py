"""What every check of plausibility asks of a replay: who is powered, free, supported, and when."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.program import (
    ApplyImpulse,
    DriveJoint,
    GuideAlong,
    HoldVelocity,
    Moving,
    SetVelocity,
)
from esg.metrics.joined import held, joined
from esg.metrics.plausibility.limits import Motion, limit, motion_of, surface_grip
from esg.metrics.plausibility.told import Told
from esg.metrics.replay import Floats, Replay
from esg.metrics.support import lowest_curve, touching
from esg.thresholds import BRAKING_ICY_G, CARRIED_M, HIT_GAP_S

Bools = NDArray[np.bool_]

_LEVEL = math.cos(math.radians(20.0))
"""Contacts whose normal is this close to the vertical carry; others push."""


class Facts:
    """One replay with what is known beside its physics; series have shape [T].

    Attributes:
        replay: What happened.
        told: What the document says.
        dynamic: Indices of the bodies that can move.
        g: Gravity [m/s^2].
        joints: What holds bodies together.
    """

    def __init__(self, replay: Replay, told: Told) -> None:
        self.replay, self.told = replay, told
        bodies = replay.scene.bodies
        self.dynamic = [i for i, b in enumerate(bodies) if not b.static and b.collides]
        self.g = abs(replay.scene.gravity[2])
        n, b = len(replay.time), len(bodies)
        self._struck, self._carried = np.zeros((n, b), bool), np.zeros((n, b), bool)
        self.joints = joined(replay)
        self._read_contacts()
        self._read_joints()
        self._read_breaks()
        self._lowest: dict[int, Floats] = {}
        self._touching: dict[int, Bools] = {}

    @cached_property
    def window(self) -> int:
        """Frames of the window over which accelerations are measured."""
        return max(1, round(limit("window") / self.replay.frame_s))

    def motion(self, body: int) -> Motion:
        """The row of a body's kind."""
        b = self.replay.scene.bodies[body]
        return motion_of(b.label, b.category)

    def name(self, body: int) -> str:
        """A body's name."""
        return self.replay.scene.bodies[body].name

    def _read_contacts(self) -> None:
        """Frames near a contact that pushes, and frames with one of level, fixed ground."""
        c, replay = self.replay.contacts, self.replay
        static = np.array([b.static for b in replay.scene.bodies])
        gap = max(1, round(HIT_GAP_S / replay.frame_s))
        rows = np.flatnonzero((c.impulse > 0) & (c.a >= 0) & (c.b >= 0))
        frames = np.searchsorted(replay.time, c.time[rows] - 0.5 * replay.frame_s)
        steep = np.abs(c.normal[rows, 2]) < _LEVEL
        for mine, other in ((c.a[rows], c.b[rows]), (c.b[rows], c.a[rows])):
            pushes = steep | ~static[other]
            for k, i, hit in zip(frames, mine, pushes, strict=True):
                (self._struck if hit else self._carried)[max(k - gap, 0) : k + gap + 1, i] = True

    def _read_joints(self) -> None:
        """What a joint holds it may push; what moves by itself it only loads."""
        for i in self.dynamic:
            if not self.motion(i).own_power:
                self._struck[:, i] |= self.held(i)

    def _read_breaks(self) -> None:
        """What is not there is no body to be judged; what comes in or goes does so by a blow."""
        gap = max(1, round(HIT_GAP_S / self.replay.frame_s))
        for i in np.flatnonzero(self.replay.absent.any(axis=0)):
            near = np.flatnonzero(self.replay.absent[:, i])
            for k in (near[0], near[-1]):
                self._struck[max(k - gap, 0) : k + gap + 1, i] = True
            self._struck[near, i] = True

    def absent(self, body: int) -> Bools:
        """Frames at which a body is not there: a fragment before, what has broken after."""
        return self.replay.absent[:, body]

    def held(self, body: int) -> Bools:
        """Frames at which a joint holds a body."""
        return held(self.joints, body, len(self.replay.time))

    def struck(self, body: int) -> Bools:
        """Frames near a contact with anything but level, fixed ground."""
        return self._struck[:, body]

    def lowest(self, body: int) -> Floats:
        """Height of a body's lowest point [m]."""
        if body not in self._lowest:
            self._lowest[body] = lowest_curve(self.replay, body)
        return self._lowest[body]

    def level(self, body: int) -> Bools:
        """Frames at which the ground, or a fixed level top, carries a body."""
        return (self.lowest(body) <= CARRIED_M) | self._carried[:, body]

    def touching(self, body: int) -> Bools:
        """Frames at which anything touches a body."""
        if body not in self._touching:
            self._touching[body] = touching(self.replay, body)
        return self._touching[body]

    def upto_struck(self, body: int) -> Bools:
        """Frames before anything has pushed a body."""
        return ~np.logical_or.accumulate(self.struck(body))

    def _active(self, body: int, counts: Callable[[Moving], bool]) -> Bools:
        out = np.zeros(len(self.replay.time), bool)
        for control in self.replay.controls(body):
            p = control.primitive
            if isinstance(p, Moving) and counts(p):
                end = min(p.end, self._let_go(body, p))
                half = 0.5 * self.replay.frame_s
                out |= (self.replay.time > p.start + half) & (self.replay.time <= end + half)
        return out

    def _let_go(self, body: int, p: Moving) -> float:
        """When the first touch of what ends a hold happens [s]."""
        scene = self.replay.scene
        others = [scene.index(n) for n in p.until_contact if n in scene.names]
        c = self.replay.contacts
        other = np.where(c.a == body, c.b, np.where(c.b == body, c.a, body))
        times = c.time[np.isin(other, others) & (c.impulse > 0) & (c.time >= p.start)]
        return float(times.min(initial=math.inf))

    def powered(self, body: int) -> Bools:
        """Frames whose step the program drives, guides or spins a body in, or its joint's motor."""
        return self._active(body, lambda _: True) | self._motored(body)

    def _motored(self, body: int) -> Bools:
        """Frames whose step a motor moves a body in that the program gives its joint."""
        out = np.zeros(len(self.replay.time), bool)
        for control in self.replay.controls(body):
            if isinstance(control.primitive, DriveJoint):
                out[self.replay.time > control.time] = not control.primitive.lets_go
        return out

    def driven(self, body: int) -> Bools:
        """Frames whose step the program drives a body in."""
        return self._active(body, lambda p: isinstance(p, HoldVelocity))

    def guided(self, body: int) -> Bools:
        """Frames at which something outside of the scene holds a body."""
        return self._active(body, lambda p: isinstance(p, GuideAlong))

    def flown(self, body: int) -> Bools:
        """Frames at which a body flies under its own power."""
        return self._active(body, lambda p: isinstance(p, HoldVelocity) and p.climb is not None)

    def launched(self, body: int) -> Bools:
        """Frames whose step sets a body's velocity at once, and their neighbours."""
        out = np.zeros(len(self.replay.time), bool)
        for control in self.replay.controls(body):
            if isinstance(control.primitive, SetVelocity | ApplyImpulse):
                k = int(np.searchsorted(self.replay.time, control.time + 1e-9))
                out[max(k - 1, 0) : k + 3] = True
        return out

    def friction(self, body: int) -> float:
        """Friction of a body on what carries it: its kind's grip, else the mean of materials.

        Of ground that is slick by its material, though nobody called it wet, it finds what the
        scene gives the pair, if that is more.
        """
        motion, scene = self.motion(body), self.replay.scene
        grip = motion.grip
        if motion.flies:
            return grip
        if not math.isnan(grip):
            most = surface_grip(self.told.surface, scene.ground_friction)
            if self.told.surface == "dry" and most > BRAKING_ICY_G:
                most = max(most, self.pair(body))
            return min(grip, most)
        c = self.replay.contacts
        mine = (c.a == body) | (c.b == body)
        other = np.unique(np.where(c.a[mine] == body, c.b[mine], c.a[mine]))
        tops = [scene.bodies[int(k)] for k in other if k >= 0]
        rough = [t.friction for t in tops if t.static]
        return 0.5 * (scene.bodies[body].friction + max([scene.ground_friction, *rough]))

    def pair(self, body: int) -> float:
        """Friction that a scene gives a body on its ground: of its tyres, else of its material."""
        b, scene = self.replay.scene.bodies[body], self.replay.scene
        ground = scene.vehicle_ground_friction if b.wheeled else scene.ground_friction
        return b.tyre_friction + 0.5 * (b.friction + ground)

    def clear(self, *barred: Bools) -> Bools:
        """Windows without any of the barred frames, by their first frame, shape [T - window]."""
        n = self.window
        bad = np.logical_or.reduce(barred)
        count = np.concatenate([[0], np.cumsum(bad)])
        return count[n + 1 :] == count[: -n - 1]

    def gains(self, series: Floats) -> Floats:
        """Change of a series over each window, per second, shape [T - window, ...]."""
        n = self.window
        return (series[n:] - series[:-n]) / (n * self.replay.frame_s)
