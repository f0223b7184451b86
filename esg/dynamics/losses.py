"""Event losses: how far each world of a rollout is from the timeline, and in what respect.

The task term of an event vanishes when it happens, its window term when it happens on time
(paper, equations for Collision, PositionAt, UniformMotion, Brake and windows). Every term is
divided by a reference scale of its type, so that all are of order one. An event that depends on
an earlier one is only looked for after it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.gap import surface_gap
from esg.dynamics.story import Story, bounds
from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EdgeEvent, EventConstraint, NodeEvent, TimelineNode
from esg.units import quat_rotate, yaw_from_quat

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

MISSED = 10.0
"""Loss of an event that did not happen, before its distance is added."""
UNMET = 60.0
"""Loss of a quantity whose event did not happen: more than any error of one that did."""
CHAIN_GAP_S = 0.1
HIT_LIMIT_S = 15.0
MIN_IMPULSE_NS = 0.1
SAFE_IMPULSE_NS = 0.25
MAX_DEPTH_M = 0.05
SAFE_DEPTH_M = 0.035
MAX_RECHECK_M = 0.02
RECHECK_S = 0.2
STOP_SPEED_MPS = 0.1
TIME_SCALE_S = 0.1
SPEED_SCALE_MPS = 0.25
DISTANCE_SCALE_M = 0.3
HALVED = 0.45
"""Braking leaves at most this fraction of the speed, a little less than the half that is asked."""

TOLERANCE = {
    "time": 0.15,
    "time_since": 0.15,
    "time_to_stop": 0.15,
    "speed_after": 0.4,
    "speed_before": 0.4,
    "distance": 0.1,
    "height": 0.1,
    "angle": 5.0,
}
"""Largest error that still counts as met, in s, m/s, m, degrees."""


@dataclass
class Assessment:
    """Losses of W worlds.

    Attributes:
        total: Sum of all terms, shape [W].
        completed: Per event id, shape [W].
        time: Per event id, time of the event [s], NaN where it did not happen, shape [W].
        measured: Per "event id/quantity/object", SI value, shape [W].
        error: Per constraint, signed distance outside the prescribed value or interval, shape [W].
        terms: Per "event id/term", shape [W].
    """

    total: Floats
    completed: dict[str, Bools] = field(default_factory=dict)
    time: dict[str, Floats] = field(default_factory=dict)
    measured: dict[str, Floats] = field(default_factory=dict)
    error: dict[str, Floats] = field(default_factory=dict)
    terms: dict[str, Floats] = field(default_factory=dict)

    def all_completed(self) -> Bools:
        """Worlds in which every event happened, shape [W]."""
        out = np.ones(len(self.total), bool)
        for done in self.completed.values():
            out &= done
        return out

    def within_tolerance(self) -> Bools:
        """Worlds in which every prescribed quantity is met, shape [W]."""
        out = np.ones(len(self.total), bool)
        for name, error in self.error.items():
            out &= np.abs(error) <= TOLERANCE[name.split("/")[1]]
        return out


def assess(
    scene: SimScene, story: Story, rollout: Rollout, times: list[dict[str, float]]
) -> Assessment:
    """Measures a rollout against the timeline.

    Args:
        scene: The scene that was simulated.
        story: The timeline.
        rollout: W worlds.
        times: Per world, the program's own times of triggers and heading changes by node id [s].
    """
    return _Assessor(scene, story, rollout, times).run()


class _Assessor:
    def __init__(
        self, scene: SimScene, story: Story, rollout: Rollout, times: list[dict[str, float]]
    ) -> None:
        self.scene, self.story, self.r = scene, story, rollout
        self.n = rollout.position.shape[0]
        self.t = rollout.time
        self.fps = 1.0 / float(self.t[1] - self.t[0])
        self.times = times
        self.speed = np.linalg.norm(rollout.linear_velocity.astype(float), axis=-1)
        self.result = Assessment(np.zeros(self.n))

    def run(self) -> Assessment:
        handlers = {
            NodeEvent.COLLISION: self._collision,
            NodeEvent.REACH: self._reach,
            NodeEvent.MISS: self._miss,
            NodeEvent.ENTER_REGION: self._enter,
            NodeEvent.STOP: self._stop,
            NodeEvent.TOPPLE: self._topple,
            NodeEvent.FALL: self._fall,
            NodeEvent.HEADING_REACHED: self._heading,
            NodeEvent.POSITION_AT: self._position,
        }
        for node in self.story.nodes.values():
            if node.event is NodeEvent.SCENE_START:
                self.result.time[node.id] = np.zeros(self.n)
            elif node.event is NodeEvent.TRIGGER:
                self.result.time[node.id] = self._program_time(node)
            else:
                self._event(node, handlers[node.event])
        self._braking()
        self.result.total[~self.r.valid] = 1e6
        self.result.total = np.nan_to_num(self.result.total, nan=1e6, posinf=1e6)
        return self.result

    # -- one event ---------------------------------------------------------------------------

    def _event(self, node: TimelineNode, handler) -> None:
        """Runs a handler -> (time, distance-like loss) and adds order, window and constraints."""
        previous = self.story.previous_outcome(node.id)
        earliest = np.zeros(self.n)
        ready = np.ones(self.n, bool)
        if previous is not None:
            ready = self.result.completed[previous].copy()
            earliest = np.where(ready, self.result.time[previous], 0.0)
            if node.event in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION):
                earliest = earliest + CHAIN_GAP_S
        time, far = handler(node, np.where(ready, earliest, np.inf))
        done = ready & np.isfinite(time) & self.r.valid
        loss = np.where(done, 0.0, MISSED + np.minimum(far, 25.0))
        loss = np.where(ready, loss, MISSED + 30.0)
        self.result.completed[node.id] = done
        self.result.time[node.id] = np.where(done, time, np.nan)
        self._term(f"{node.id}/task", loss)
        self._window(node, time, done)
        for constraint in node.constraints:
            self._constraint(node, constraint, done)

    def _term(self, name: str, value: Floats) -> None:
        self.result.terms[name] = value
        self.result.total = self.result.total + value

    def _window(self, node: TimelineNode, time: Floats, done: Bools) -> None:
        if node.timestamp is None and node.window is None:
            return
        low, high = node.window or (node.timestamp or 0.0, node.timestamp or 0.0)
        if not node.time_is_prescribed:
            # A guessed window is a preference: the paper's smooth barrier at a small weight.
            width, beta = max(high - low, 0.5), 4.0
            miss = np.logaddexp(0.0, beta * (low - time)) + np.logaddexp(0.0, beta * (time - high))
            self._term(
                f"{node.id}/window", np.where(done, 0.02 * (miss / (beta * width)) ** 2, 0.0)
            )
            return
        error = np.maximum(time - high, 0.0) - np.maximum(low - time, 0.0)
        name = f"{node.id}/time/{node.id}"
        self.result.measured[name] = np.where(done, time, np.nan)
        self.result.error[name] = np.where(done, error, np.inf)
        self._term(f"{node.id}/window", np.where(done, _bowl(error / TIME_SCALE_S), UNMET))

    def _constraint(self, node: TimelineNode, c: EventConstraint, done: Bools) -> None:
        value, scale = self._measure(node, c)
        low, high, _ = bounds(c.value, (0.0, 0.0))
        factor = 1.0 if c.quantity in ("time_since", "time_to_stop", "angle") else 0.01
        low, high = low * factor, high * factor
        inner = 0.15 * (high - low)
        error = np.maximum(value - high, 0.0) - np.maximum(low - value, 0.0)
        # Aim at the inside of an interval: a value on its edge does not survive another engine.
        push = np.maximum(value - (high - inner), 0.0) + np.maximum(low + inner - value, 0.0)
        name = f"{node.id}/{c.quantity}/{c.object}"
        known = done & np.isfinite(value)
        self.result.measured[name] = np.where(known, value, np.nan)
        self.result.error[name] = np.where(known, error, np.inf)
        self._term(name, np.where(known, _bowl(push / scale), UNMET))

    def _measure(self, node: TimelineNode, c: EventConstraint) -> tuple[Floats, float]:
        time = self.result.time[node.id]
        body = self.scene.index(c.object) if c.object in self.scene.names else 0
        if c.quantity == "time_since":
            since = self.result.time.get(c.since or "", np.zeros(self.n))
            return time - since, TIME_SCALE_S
        if c.quantity == "time_to_stop":
            return time - self._brake_start(c.object), TIME_SCALE_S
        if c.quantity == "speed_after":
            return self._extreme(self.speed[:, :, body], time, 0.0, 0.12), SPEED_SCALE_MPS
        if c.quantity == "speed_before":
            return self._at(self.speed[:, :, body], time - 1.5 / self.fps), SPEED_SCALE_MPS
        if c.quantity == "height":
            return self._at(self.r.position[:, :, body, 2].astype(float), time), DISTANCE_SCALE_M
        if c.quantity == "angle":
            yaw = np.unwrap(yaw_from_quat(self.r.quaternion[:, :, body]), axis=1)
            return np.degrees(np.abs(self._at(yaw, time) - yaw[:, 0])), 5.0
        start = self.r.position[:, :1, body].astype(float)
        moved = np.linalg.norm(self.r.position[:, :, body].astype(float) - start, axis=-1)
        return self._at(moved, time), DISTANCE_SCALE_M

    # -- event types: time of the event (inf if none) and how far from it ---------------------

    def _collision(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        a, b = self._members(node.participants[0]), self._members(node.participants[-1])
        time, impulse, depth, recheck, struck = self._first_hit(a, b, earliest)
        hit = np.isfinite(time) & (time <= HIT_LIMIT_S)
        good = hit & (impulse > MIN_IMPULSE_NS) & (depth < MAX_DEPTH_M) & (recheck <= MAX_RECHECK_M)
        unsound = 0.5 + np.maximum(depth - MAX_DEPTH_M, 0.0) / 0.02
        unsound += np.maximum(recheck - MAX_RECHECK_M, 0.0) / 0.02
        unsound += np.maximum(MIN_IMPULSE_NS - impulse, 0.0) / MIN_IMPULSE_NS
        missed = (self._miss_distance(a, b, hit, earliest) / DISTANCE_SCALE_M) ** 2
        far = np.where(hit, np.minimum(unsound, 8.0), missed)
        soft = np.maximum(SAFE_IMPULSE_NS - impulse, 0.0) / SAFE_IMPULSE_NS
        soft = soft + np.maximum(depth - SAFE_DEPTH_M, 0.0) / 0.02
        self._term(f"{node.id}/weak", np.where(good, soft, 0.0))
        self._term(f"{node.id}/glance", np.where(good, 0.3 * struck, 0.0))
        return np.where(good, time, np.inf), far

    def _first_hit(
        self, a: list[int], b: list[int], earliest: Floats
    ) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """Time, impulse, depth, depth 0.2 s later and glancing measure of the first hit."""
        log = self.r.contacts
        pair = (np.isin(log.a, a) & np.isin(log.b, b)) | (np.isin(log.a, b) & np.isin(log.b, a))
        rows = np.flatnonzero(pair)
        time = np.full(self.n, np.inf)
        late = rows[log.time[rows] >= earliest[log.world[rows]] - 1e-9]
        np.minimum.at(time, log.world[late], log.time[late])
        # A touch that began before the earliest time and goes on is not a new hit; one that began
        # in time but is re-examined 0.2 s later must have separated or rest lightly.
        impulse, depth = np.zeros(self.n), np.zeros(self.n)
        recheck, glance = np.zeros(self.n), np.zeros(self.n)
        start = time[log.world[rows]]
        after = log.time[rows] - start
        burst = rows[(after >= -1e-9) & (after < 0.05)]
        np.add.at(impulse, log.world[burst], log.impulse[burst])
        first = rows[(after >= -1e-9) & (after < 1.5 / self.fps)]
        np.maximum.at(depth, log.world[first], log.depth[first])
        later = rows[np.abs(after - RECHECK_S) < 0.75 / self.fps]
        np.maximum.at(recheck, log.world[later], log.depth[later])
        for row in first[::-1]:
            w = log.world[row]
            frame = max(int(log.frame[row]) - 1, 0)
            va = self.r.linear_velocity[w, frame, log.a[row]].astype(float)
            vb = self.r.linear_velocity[w, frame, log.b[row]].astype(float)
            relative = va - vb
            size = float(np.linalg.norm(relative))
            if size > 1e-6:
                glance[w] = 1.0 - abs(float(relative @ log.normal[row])) / size
        return time, impulse, depth, recheck, glance

    def _miss_distance(self, a: list[int], b: list[int], hit: Bools, earliest: Floats) -> Floats:
        """Smallest surface distance of worlds without a hit [m], shape [W]."""
        out = np.zeros(self.n)
        worlds = np.flatnonzero(~hit & np.isfinite(earliest))
        if not len(worlds):
            return out
        best = np.full(len(worlds), np.inf)
        for i in a:
            for j in b:
                best = np.minimum(best, self._closest(i, j, worlds, earliest[worlds]))
        out[worlds] = np.maximum(best, 0.0)
        return out

    def _closest(self, i: int, j: int, worlds: NDArray[np.int64], earliest: Floats) -> Floats:
        """Surface distance around the closest approach of the centres [m], shape [len(worlds)]."""
        p, q = self.r.position.astype(float), self.r.quaternion.astype(float)
        centres = np.linalg.norm(p[worlds, :, i] - p[worlds, :, j], axis=-1)
        centres = np.where(self.t[None, :] >= earliest[:, None], centres, np.inf)
        nearest = np.argmin(centres, axis=1)
        frames = np.clip(nearest[:, None] + np.arange(-6, 7), 0, len(self.t) - 1)
        w = worlds[:, None]
        bodies = self.scene.bodies
        if not bodies[i].shapes or not bodies[j].shapes:
            return centres[np.arange(len(worlds)), nearest]
        gap = surface_gap(
            bodies[i], bodies[j], p[w, frames, i], q[w, frames, i], p[w, frames, j], q[w, frames, j]
        )
        return np.nan_to_num(gap, nan=100.0).min(axis=1)

    def _reach(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        a, b = self._members(node.participants[0]), self._members(node.participants[-1])
        near = self._gap_over_time(a, b) <= 0.25
        near &= self.t[None, :] >= earliest[:, None]
        time = self._first(near)
        none = ~np.isfinite(time)
        far = (self._miss_distance(a, b, ~none, earliest) / DISTANCE_SCALE_M) ** 2
        hit = np.isfinite(self._first_hit(a, b, earliest)[0])
        self._term(f"{node.id}/touch", np.where(hit, 0.5, 0.0))
        return time, far

    def _miss(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        a, b = self._members(node.participants[0]), self._members(node.participants[-1])
        hit = np.isfinite(self._first_hit(a, b, np.zeros(self.n))[0])
        gap = self._gap_over_time(a, b)
        time = self.t[np.argmin(gap, axis=1)]
        self._term(
            f"{node.id}/near", np.minimum((np.maximum(gap.min(axis=1) - 0.5, 0) / 1.0) ** 2, 4)
        )
        ok = ~hit & np.isfinite(earliest)
        return np.where(ok, time, np.inf), np.full(self.n, 1.0)

    def _gap_over_time(self, a: list[int], b: list[int]) -> Floats:
        """Surface distance [m], shape [W, T]."""
        p, q = self.r.position.astype(float), self.r.quaternion.astype(float)
        out = np.full(p.shape[:2], np.inf)
        for i in a:
            for j in b:
                x, y = self.scene.bodies[i], self.scene.bodies[j]
                if x.shapes and y.shapes:
                    gap = surface_gap(x, y, p[:, :, i], q[:, :, i], p[:, :, j], q[:, :, j])
                    out = np.minimum(out, gap)
        return out

    def _enter(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        region = next((r for r in self.scene.regions if r.name == node.region), None)
        if region is None:
            return np.full(self.n, np.inf), np.full(self.n, 25.0)
        body, parent = self.scene.index(node.participants[0]), self.scene.index(region.parent)
        p, q = self.r.position.astype(float), self.r.quaternion.astype(float)
        inverse = q[:, :, parent] * np.array([-1.0, -1.0, -1.0, 1.0])
        local = quat_rotate(inverse, p[:, :, body] - p[:, :, parent]) - np.array(region.center)
        half = np.array(region.half_extents)
        outside = np.linalg.norm(np.maximum(np.abs(local) - half, 0.0), axis=-1)
        late = self.t[None, :] >= earliest[:, None]
        inside = (outside <= 0.0) & late
        hold = max(1, round(0.2 * self.fps))
        stays = inside.copy()
        for k in range(1, hold + 1):
            stays[:, :-k] &= inside[:, k:]
            stays[:, -k:] &= inside[:, -1:]
        below = (local[..., 2] < -half[2]) & (np.abs(local[..., :2]) < 1.5 * half[:2]).all(-1)
        time = self._first(
            stays | (inside & np.flip(np.maximum.accumulate(np.flip(below & late, 1), 1), 1))
        )
        planar = np.linalg.norm(local[..., :2], axis=-1)
        planar = np.where(late, planar, np.inf).min(axis=1)
        scale = max(DISTANCE_SCALE_M * 0.3, float(half[:2].max()))
        self._term(
            f"{node.id}/centre",
            np.where(
                np.isfinite(time), 0.5 * np.minimum(planar / float(half[:2].min()), 2.0) ** 2, 0.0
            ),
        )
        nearest = np.where(late, outside, np.inf).min(axis=1)
        return time, (
            np.nan_to_num(np.minimum(nearest + planar, 50.0), posinf=50.0) / scale
        ) ** 2 * 0.25

    def _stop(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        body = self.scene.index(node.participants[0])
        speed = self.speed[:, :, body]
        moved = np.maximum.accumulate(speed > 2.0 * STOP_SPEED_MPS, axis=1)
        slow = (speed < STOP_SPEED_MPS) & moved & (self.t[None, :] >= earliest[:, None])
        still = slow.copy()
        for k in range(1, max(1, round(0.2 * self.fps)) + 1):
            still[:, :-k] &= slow[:, k:]
            still[:, -k:] = False
        return self._first(still), np.minimum(speed[:, -1], 5.0)

    def _topple(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        body = self.scene.index(node.participants[0])
        q = self.r.quaternion[:, :, body].astype(float)
        start = quat_rotate(q[:, :1] * np.array([-1.0, -1.0, -1.0, 1.0]), np.array([0.0, 0.0, 1.0]))
        up = quat_rotate(q, np.broadcast_to(start, (*q.shape[:2], 3)))[..., 2]
        tilt = np.degrees(np.arccos(np.clip(up, -1.0, 1.0)))
        late = self.t[None, :] >= earliest[:, None]
        most = np.where(late, tilt, 0.0).max(axis=1)
        self._term(f"{node.id}/weak", np.maximum(70.0 - most, 0.0) / 70.0 * 0.3)
        return self._first((tilt > 47.0) & late), ((47.0 - np.minimum(most, 47.0)) / 15.0) ** 2

    def _fall(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        body = self.scene.index(node.participants[0])
        z = self.r.position[:, :, body, 2].astype(float)
        need = 1.05 * self.scene.bodies[body].half_extents[2]
        drop = z[:, :1] - z
        late = self.t[None, :] >= earliest[:, None]
        most = np.where(late, drop, 0.0).max(axis=1)
        # Without a drop the way to the edge of the support still tells good from bad.
        moved = np.linalg.norm(
            self.r.position[:, -1, body, :2] - self.r.position[:, 0, body, :2], axis=-1
        )
        return self._first((drop > need) & late), 4.0 * np.maximum(need - most, 0) / need + 1 / (
            1 + moved
        )

    def _heading(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        name = node.participants[0]
        body = self.scene.index(name)
        planned = self._program_time(node)
        v = self.r.linear_velocity[:, :, body].astype(float)
        yaw = np.unwrap(yaw_from_quat(self.r.quaternion[:, :, body]), axis=1)
        if self.scene.bodies[body].roll_radius > 0.0:
            yaw = np.unwrap(np.arctan2(v[..., 1], v[..., 0]), axis=1)
        begin = np.array([t.get(f"{node.id}/begin", 0.0) for t in self.times])
        sign = 1.0 if (node.turn_direction or "left") == "left" else -1.0
        asked = math.radians(node.turn_degrees or 90.0)
        turned = sign * (self._at(yaw, planned + 0.05) - self._at(yaw, begin))
        error = np.abs(turned - asked)
        ok = (error < math.radians(15.0)) & np.isfinite(earliest)
        self._term(f"{node.id}/heading", np.minimum((error / math.radians(10.0)) ** 2, 9.0) * 0.1)
        return np.where(ok, planned, np.inf), np.minimum((error / 0.3) ** 2, 20.0)

    def _position(self, node: TimelineNode, earliest: Floats) -> tuple[Floats, Floats]:
        body = self.scene.index(node.participants[0])
        if node.position_cm is None:
            return np.where(np.isfinite(earliest), earliest, np.inf), np.zeros(self.n)
        goal = np.array(node.position_cm) / 100.0
        away = np.linalg.norm(self.r.position[:, :, body].astype(float) - goal, axis=-1)
        time = node.timestamp if node.timestamp is not None else None
        if time is not None:
            d = self._at(away, np.full(self.n, time))
            return np.where(d < DISTANCE_SCALE_M, time, np.inf), (d / DISTANCE_SCALE_M) ** 2
        near = (away < DISTANCE_SCALE_M) & (self.t[None, :] >= earliest[:, None])
        return self._first(near), (away.min(axis=1) / DISTANCE_SCALE_M) ** 2

    # -- braking -----------------------------------------------------------------------------

    def _braking(self) -> None:
        """A braked phase that ends in an event has taken at least half of the speed by then."""
        for actor, phases in self.story.phases.items():
            body = self.scene.index(actor)
            for phase in phases:
                if phase.edge.event is not EdgeEvent.BRAKE:
                    continue
                begin = self.result.time[phase.start.id]
                end = self.result.time.get(phase.end.id, np.full(self.n, np.nan))
                before = self._at(self.speed[:, :, body], begin - 0.5 / self.fps)
                after = self._at(self.speed[:, :, body], end - 1.5 / self.fps)
                ratio = after / np.maximum(before, 0.1)
                late = np.isfinite(end)
                excess = np.maximum(ratio - HALVED, 0.0)
                name = f"{phase.edge.id}/brake"
                self._term(name, np.where(late, np.minimum((excess / 0.05) ** 2, 9.0), 0.0))

    def _brake_start(self, actor: str) -> Floats:
        for phase in self.story.phases.get(actor, ()):
            if phase.edge.event is EdgeEvent.BRAKE:
                return self.result.time[phase.start.id]
        return np.zeros(self.n)

    # -- helpers -----------------------------------------------------------------------------

    def _program_time(self, node: TimelineNode) -> Floats:
        return np.array([t.get(node.id, np.nan) for t in self.times])

    def _members(self, name: str) -> list[int]:
        return [self.scene.index(n) for n in self.story.expand(name) if n in self.scene.names]

    def _first(self, mask: Bools) -> Floats:
        """Time of the first true frame, inf if none, shape [W]."""
        return np.where(mask.any(axis=1), self.t[np.argmax(mask, axis=1)], np.inf)

    def _at(self, series: Floats, time: Floats) -> Floats:
        """Value of [W, T] at a time per world, NaN for NaN times."""
        frame = np.clip(np.nan_to_num(time, nan=0.0, posinf=0.0) * self.fps, 0, len(self.t) - 1)
        value = series[np.arange(self.n), np.rint(frame).astype(int)]
        return np.where(np.isfinite(time), value, np.nan)

    def _extreme(self, series: Floats, time: Floats, begin: float, end: float) -> Floats:
        """Largest value of [W, T] in a window after a time per world."""
        offsets = np.arange(math.floor(begin * self.fps), math.ceil(end * self.fps) + 1)
        stack = np.stack([self._at(series, time + k / self.fps) for k in offsets])
        return stack.max(axis=0)


def _bowl(x: Floats) -> Floats:
    """Quadratic near zero, linear further out, at most UNMET."""
    x = np.abs(x)
    return np.minimum(np.where(x < 3.0, x * x, 6.0 * x - 9.0), UNMET)
