"""Event losses with derivatives: smooth residuals of a surrogate rollout and what they pull on.

The terms are those of `esg.dynamics.losses.assess` where a derivative exists: miss distances, event
times interpolated within a step, speeds and distances. Each residual depends on the states of one
or two steps; its derivatives there are local central differences, and `wp.Tape` carries them back
to the start. Terms that judge an event (weak, glancing, deep) have none and are left to the search.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses.assess import SPEED_SCALE_MPS, TIME_SCALE_S
from esg.dynamics.losses.gap import surface_gap
from esg.dynamics.losses.measures import DISTANCE_SCALE_M
from esg.dynamics.losses.shapes import MISSED, Shape, barrier, inside, outside, squared
from esg.dynamics.plan.planner import Plan
from esg.dynamics.story.story import bounds
from esg.engines.surrogate.tape import Seeds, TapedRollout, Touch
from esg.graph.models import EventConstraint, NodeEvent, TimelineNode
from esg.thresholds import MIN_EVENT_GAP_S, MOVING_MPS, NEAR_M, STOPPED_MPS
from esg.units import quat_rotate

Floats = NDArray[np.float64]
States = tuple[Floats, Floats, Floats]
"""Positions, orientations and velocities of all bodies, each of shape [K, B, 3 or 4]."""

SMOOTH = (
    NodeEvent.COLLISION,
    NodeEvent.REACH,
    NodeEvent.POSITION_AT,
    NodeEvent.ENTER_REGION,
    NodeEvent.STOP,
    NodeEvent.MISS,
)
"""Events with residuals here; the others (topple, fall, heading) have none."""
_STEP = 1e-4
_COARSE = 4


@dataclass(frozen=True)
class Signal:
    """A number that depends on the state of some bodies at one moment.

    Args:
        bodies: Their indices.
        value: States [K] -> [K].
        moving: Whether it depends on velocities too.
    """

    bodies: tuple[int, ...]
    value: Callable[[States], Floats]
    moving: bool = False


class EventLosses:
    """Losses of the W worlds of a taped rollout, and their derivatives at its states.

    Args:
        plan: The scene and its timeline.
        taped: The rollout.
        times: Per world, the program's own times by node id [s].

    Attributes:
        loss: Sum of all terms, shape [W].
        residual: Per "event/quantity", SI value, NaN where it has none, shape [W].
        done: Per event, whether it happened, shape [W].
        seeds: Derivatives of `loss`.
        horizon: Last step any of them refers to, shape [W].
        clock: Derivatives of `loss` by the program's own times, per (world, node id).
    """

    def __init__(self, plan: Plan, taped: TapedRollout, times: list[dict[str, float]]) -> None:
        self.plan, self.taped, self.times = plan, taped, times
        self.states: States = (
            taped.position.astype(float),
            taped.quaternion.astype(float),
            taped.velocity.astype(float),
        )
        w, n = self.states[0].shape[:2]
        self.n_worlds, self.n_steps, self.dt = w, n - 1, taped.frames.dt
        self.loss = np.where(taped.valid, 0.0, 1e6)
        self.residual: dict[str, Floats] = {}
        self.done: dict[str, NDArray[np.bool_]] = {}
        self._time: dict[str, Floats] = {}
        self._seeds = [np.zeros_like(s) for s in self.states]
        self._delay: dict[int, float] = {}
        self.horizon = np.zeros(w, int)
        self.clock: dict[tuple[int, str], float] = {}
        self._movers: dict[tuple[int, str], Callable[[float], None]] = {}
        for node in plan.story.nodes.values():
            if node.event in (NodeEvent.SCENE_START, NodeEvent.TRIGGER, NodeEvent.HEADING_REACHED):
                self._time[node.id] = np.array([t.get(node.id, 0.0) for t in times])
                self.done[node.id] = np.ones(w, bool)
            else:
                self._event(node)

    @property
    def seeds(self) -> Seeds:
        """Derivatives of the losses at the states of the rollout."""
        delay = np.zeros(max(1, self.taped.n_contacts))
        for contact, value in self._delay.items():
            delay[contact] = value
        position, quaternion, velocity = self._seeds
        return Seeds(position, quaternion, velocity, delay)

    # -- events ------------------------------------------------------------------------------

    def _event(self, node: TimelineNode) -> None:
        w = self.n_worlds
        self.done[node.id] = np.zeros(w, bool)
        self._time[node.id] = np.full(w, np.nan)
        previous = self.plan.story.previous_outcome(node.id)
        ready, earliest = np.ones(w, bool), np.zeros(w)
        if previous is not None:
            ready = self.done[previous].copy()
            earliest = np.where(ready, np.nan_to_num(self._time[previous]), 0.0)
            if node.event in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION):
                earliest = earliest + MIN_EVENT_GAP_S
        touches: list[Touch | None] = [None] * w
        if node.event in (NodeEvent.COLLISION, NodeEvent.MISS):
            touches = self.taped.touches(*self.members(node), earliest)
        for k in range(w):
            if not self.taped.valid[k]:
                continue
            if not ready[k]:
                self.loss[k] += MISSED + 30.0
            elif node.event is NodeEvent.COLLISION:
                self._collision(node, k, float(earliest[k]), touches[k])
            elif node.event is NodeEvent.MISS:
                self._miss(node, k, touches[k])
            elif node.event in SMOOTH:
                self._reach(node, k, float(earliest[k]))
            else:
                self.done[node.id][k] = True
                self._time[node.id][k] = earliest[k]

    def _collision(self, node: TimelineNode, w: int, earliest: float, touch: Touch | None) -> None:
        if touch is None:
            signal = self._gap(node)
            step, gap = self._lowest(w, signal, earliest)
            slope = self._term(f"{node.id}/miss", w, max(gap, 0.0), squared(DISTANCE_SCALE_M))
            self.loss[w] += MISSED
            self._pull(w, step, signal, slope)
            return

        def move_time(slope: float) -> None:
            if touch.contact >= 0:
                self._delay[touch.contact] = self._delay.get(touch.contact, 0.0) + slope
                self.horizon[w] = max(self.horizon[w], touch.step + 1)
            else:
                self._crossing(w, touch.step, self._gap(node), slope)

        self._happened(node, w, touch.time, touch.step, move_time)

    def _miss(self, node: TimelineNode, w: int, touch: Touch | None) -> None:
        signal = self._gap(node)
        step, gap = self._lowest(w, signal, 0.0)
        if touch is not None and not self.plan.story.meet_again(node):
            self.loss[w] += MISSED
            return
        self.done[node.id][w] = True
        self._time[node.id][w] = step * self.dt
        slope = self._term(f"{node.id}/near", w, max(gap - 0.5, 0.0), squared(1.0))
        self._pull(w, step, signal, slope)

    def _reach(self, node: TimelineNode, w: int, earliest: float) -> None:
        """Events that happen when a signal falls below a threshold."""
        signal, limit, scale = self._signal(node)
        if node.event is NodeEvent.POSITION_AT and node.timestamp is not None:
            step = min(round(node.timestamp / self.dt), self.n_steps)
            value = float(signal.value(self._at(w, slice(step, step + 1)))[0])
            self.done[node.id][w] = value < limit
            self._time[node.id][w] = step * self.dt
            slope = self._term(f"{node.id}/distance", w, value, squared(scale))
            self._pull(w, step, signal, slope)
            return
        series = signal.value(self._at(w, slice(None)))
        late = np.arange(self.n_steps + 1) * self.dt >= earliest - 1e-9
        if node.event is NodeEvent.STOP:
            late &= np.maximum.accumulate(series > MOVING_MPS)
        below = np.flatnonzero((series <= limit) & late)
        if not len(below):
            step = int(np.argmin(np.where(late, series, np.inf)))
            slope = self._term(f"{node.id}/miss", w, float(series[step]) - limit, squared(scale))
            self.loss[w] += MISSED
            self._pull(w, step, signal, slope)
            return
        step = max(int(below[0]), 1)
        before, after = float(series[step - 1]), float(series[step])
        share = np.clip((before - limit) / (before - after), 0.0, 1.0) if before > after else 1.0
        time = (step - 1 + share) * self.dt
        self._happened(node, w, time, step, lambda slope: self._crossing(w, step, signal, slope))

    def _happened(
        self,
        node: TimelineNode,
        w: int,
        time: float,
        step: int,
        move_time: Callable[[float], None],
    ) -> None:
        """Window and constraints of an event; `move_time` takes a derivative by its time."""
        self.done[node.id][w] = True
        self._time[node.id][w] = time
        self._movers[w, node.id] = move_time
        if node.timestamp is not None or node.window is not None:
            low, high = node.window or (node.timestamp or 0.0, node.timestamp or 0.0)
            shape = outside(low, high, TIME_SCALE_S)
            if not node.time_is_prescribed:
                shape = barrier(low, high)
            move_time(self._term(f"{node.id}/time", w, time, shape))
        for c in node.constraints:
            self._constraint(node, c, w, time, step, move_time)

    def _constraint(
        self,
        node: TimelineNode,
        c: EventConstraint,
        w: int,
        time: float,
        step: int,
        move_time: Callable[[float], None],
    ) -> None:
        low, high, _ = bounds(c.value, (0.0, 0.0))
        name = f"{node.id}/{c.quantity}/{c.object}"
        if c.quantity == "time_since":
            since = float(np.nan_to_num(self._time[c.since or ""][w])) if c.since else 0.0
            slope = self._term(name, w, time - since, inside(low, high, TIME_SCALE_S))
            move_time(slope)
            self._move(w, c.since, -slope)
            return
        if c.object not in self.plan.scene.names:
            return
        body, low, high = self.plan.scene.index(c.object), 0.01 * low, 0.01 * high
        if c.quantity in ("speed_after", "speed_before"):
            signal = Signal((body,), lambda s: np.linalg.norm(s[2][:, body], axis=-1), moving=True)
            first, last = step + 1, step + round(0.12 / self.dt)
            if c.quantity == "speed_before":
                first = last = max(step - round(0.025 / self.dt), 0)
            last = min(last, self.n_steps)
            series = signal.value(self._at(w, slice(first, last + 1)))
            if not len(series):
                return
            pick = first + int(np.argmax(series))
            value, scale = float(series.max()), SPEED_SCALE_MPS
        elif c.quantity in ("distance", "height"):
            start = self.states[0][w, 0, body]
            pick, scale = step, DISTANCE_SCALE_M
            if c.to is not None:
                names = self.plan.scene.names
                others = [names.index(m) for m in self.plan.story.expand(c.to) if m in names]
                signal = self._gap_of([body], others)
            elif c.quantity == "height":
                signal = Signal((body,), lambda s: s[0][:, body, 2])
            else:
                signal = Signal((body,), lambda s: np.linalg.norm(s[0][:, body] - start, axis=-1))
            value = float(signal.value(self._at(w, slice(step, step + 1)))[0])
        else:
            return
        slope = self._term(name, w, value, inside(low, high, scale))
        self._pull(w, pick, signal, slope)

    # -- signals -----------------------------------------------------------------------------

    def members(self, node: TimelineNode) -> tuple[list[int], list[int]]:
        """Body indices of an event's first and last participant, plurals expanded."""
        names, expand = self.plan.scene.names, self.plan.story.expand
        one, two = (
            [names.index(m) for m in expand(p) if m in names]
            for p in (node.participants[0], node.participants[-1])
        )
        return one, two

    def _gap(self, node: TimelineNode) -> Signal:
        """Surface distance of the nearest members of an event's two participants [m]."""
        return self._gap_of(*self.members(node))

    def _gap_of(self, one: list[int], two: list[int]) -> Signal:
        bodies = self.plan.scene.bodies
        pairs = [(i, j) for i in one for j in two if bodies[i].shapes and bodies[j].shapes]

        def value(s: States) -> Floats:
            gaps = [
                surface_gap(bodies[i], bodies[j], s[0][:, i], s[1][:, i], s[0][:, j], s[1][:, j])
                for i, j in pairs
            ]
            return np.min(gaps, axis=0) if gaps else np.full(len(s[0]), 100.0)

        return Signal(tuple(sorted({*one, *two})), value)

    def _signal(self, node: TimelineNode) -> tuple[Signal, float, float]:
        """Signal, threshold and scale of an event that begins when the signal falls below."""
        scene = self.plan.scene
        if node.event is NodeEvent.REACH:
            return self._gap(node), NEAR_M, DISTANCE_SCALE_M
        body = scene.index(node.participants[0])
        if node.event is NodeEvent.STOP:
            speed = Signal((body,), lambda s: np.linalg.norm(s[2][:, body], axis=-1), moving=True)
            return speed, STOPPED_MPS, 1.0
        if node.event is NodeEvent.POSITION_AT and node.position_cm is not None:
            goal = np.array(node.position_cm) / 100.0
            away = Signal((body,), lambda s: np.linalg.norm(s[0][:, body] - goal, axis=-1))
            return away, DISTANCE_SCALE_M, DISTANCE_SCALE_M
        region = next((r for r in scene.regions if r.name == node.region), None)
        if region is None:
            return Signal((body,), lambda s: np.zeros(len(s[0]))), 1.0, 1.0
        parent = scene.index(region.parent)
        center, half = np.array(region.center), np.array(region.half_extents)

        def beyond(s: States) -> Floats:
            inverse = s[1][:, parent] * np.array([-1.0, -1.0, -1.0, 1.0])
            local = quat_rotate(inverse, s[0][:, body] - s[0][:, parent]) - center
            return np.linalg.norm(np.maximum(np.abs(local) - 0.9 * half, 0.0), axis=-1)

        return Signal((body, parent), beyond), 1e-3, max(0.3 * DISTANCE_SCALE_M, float(half.max()))

    def _at(self, w: int, steps: slice) -> States:
        p, q, v = self.states
        return p[w, steps], q[w, steps], v[w, steps]

    def _lowest(self, w: int, signal: Signal, earliest: float) -> tuple[int, float]:
        """Step and value of a signal's minimum from a time on."""
        first = min(math.ceil(earliest / self.dt - 1e-9), self.n_steps)
        coarse = signal.value(self._at(w, slice(first, None, _COARSE)))
        near = first + _COARSE * int(np.argmin(coarse))
        low, high = max(near - _COARSE, first), min(near + _COARSE, self.n_steps)
        fine = signal.value(self._at(w, slice(low, high + 1)))
        return low + int(np.argmin(fine)), float(fine.min())

    def _move(self, w: int, node_id: str | None, slope: float) -> None:
        """Takes a derivative by the time of an earlier event, whoever sets it."""
        if node_id is None:
            return
        mover = self._movers.get((w, node_id))
        if mover is not None:
            mover(slope)
        elif node_id in self.times[w]:
            self.clock[w, node_id] = self.clock.get((w, node_id), 0.0) + slope

    # -- derivatives -------------------------------------------------------------------------

    def _term(self, name: str, w: int, value: float, shape: Shape) -> float:
        """Adds a term and returns its derivative by the residual."""
        self.residual.setdefault(name, np.full(self.n_worlds, np.nan))[w] = value
        self.loss[w] += shape(value)
        return (shape(value + _STEP) - shape(value - _STEP)) / (2.0 * _STEP)

    def _slopes(self, w: int, step: int, signal: Signal) -> list[tuple[int, int, Floats]]:
        """Derivatives of a signal by the state at a step: (which state, body, [3 or 4])."""
        out = []
        for which in range(3 if signal.moving else 2):
            width = self.states[which].shape[-1]
            for body in signal.bodies:
                p, q, v = self._at(w, slice(step, step + 1))
                copies = tuple(np.repeat(s, 2 * width, axis=0) for s in (p, q, v))
                for k in range(width):
                    copies[which][2 * k, body, k] += _STEP
                    copies[which][2 * k + 1, body, k] -= _STEP
                value = signal.value((copies[0], copies[1], copies[2]))
                out.append((which, body, (value[0::2] - value[1::2]) / (2.0 * _STEP)))
        return out

    def _pull(self, w: int, step: int, signal: Signal, slope: float) -> None:
        if slope == 0.0:
            return
        for which, body, d in self._slopes(w, step, signal):
            self._seeds[which][w, step, body] += slope * d
        self.horizon[w] = max(self.horizon[w], step)

    def _crossing(self, w: int, step: int, signal: Signal, slope: float) -> None:
        """Derivative by the time at which a falling signal crosses a fixed value."""
        first, last = max(step - 2, 0), max(step, 1)
        series = signal.value(self._at(w, slice(first, last + 1)))
        rate = float(series[-1] - series[0]) / ((len(series) - 1) * self.dt)
        if abs(rate) > 0.02:
            self._pull(w, last, signal, -slope / rate)
