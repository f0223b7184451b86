"""Event losses with derivatives: smooth residuals of a surrogate rollout and what they pull on.

The terms are those of `esg.dynamics.losses.assessment` where a derivative exists: miss distances,
event times interpolated within a step, speeds and distances. What each event pulls on is in
`residuals`. Each residual depends on the states of one or two steps; its derivatives there are
local central differences, and `wp.Tape` carries them back to the start. Terms that judge an event
(weak, glancing, deep) have none and are left to the search.
"""

from __future__ import annotations

from collections.abc import Callable
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses.kinds import EventKind, kind_of
from esg.dynamics.losses.measures import DISTANCE_SCALE_M
from esg.dynamics.losses.quantities import SPEED_SCALE_MPS, TIME_SCALE_S
from esg.dynamics.losses.residuals import Signal, States, away, gap, members, speed
from esg.dynamics.losses.shapes import MISSED, Shape, barrier, inside, outside, squared
from esg.dynamics.plan import Plan
from esg.dynamics.story.story import bounds
from esg.engines.surrogate import Seeds, TapedRollout, Touch
from esg.graph.models import EventConstraint, TimelineNode

Floats = NDArray[np.float64]

_STEP = 1e-4
_COARSE = 4


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
            kind = kind_of(node)
            if kind.by_program or kind.measure is None:
                self._time[node.id] = np.array([t.get(node.id, 0.0) for t in times])
                self.done[node.id] = np.ones(w, bool)
            else:
                self._event(node, kind)

    @property
    def seeds(self) -> Seeds:
        """Derivatives of the losses at the states of the rollout."""
        delay = np.zeros(max(1, self.taped.n_contacts))
        for contact, value in self._delay.items():
            delay[contact] = value
        position, quaternion, velocity = self._seeds
        return Seeds(position, quaternion, velocity, delay)

    # -- events ------------------------------------------------------------------------------

    def _event(self, node: TimelineNode, kind: EventKind) -> None:
        w = self.n_worlds
        self.done[node.id] = np.zeros(w, bool)
        self._time[node.id] = np.full(w, np.nan)
        previous = self.plan.story.previous_outcome(node.id)
        ready, earliest = np.ones(w, bool), np.zeros(w)
        if previous is not None:
            ready = self.done[previous].copy()
            earliest = np.where(ready, np.nan_to_num(self._time[previous]), 0.0)
            earliest = earliest + kind.smooth_gap_s
        valid = self.taped.valid
        self.loss[valid & ~ready] += MISSED + 30.0
        worlds = [int(k) for k in np.flatnonzero(valid & ready)]
        if kind.smooth is not None:
            kind.smooth(self, node, worlds, earliest)
            return
        for k in worlds:
            self.begins(node, k, float(earliest[k]))

    def touches(self, node: TimelineNode, since: Floats) -> list[Touch | None]:
        """The first touch of an event's participants from a time on, per world."""
        return self.taped.touches(*members(self.plan, node), since)

    def begins(self, node: TimelineNode, w: int, time: float, *, happens: bool = True) -> None:
        """Notes when an event takes place, and whether it does."""
        self.done[node.id][w] = happens
        self._time[node.id][w] = time

    def missed(
        self, node: TimelineNode, w: int, step: int, signal: Signal, by: float, scale: float
    ) -> None:
        """An event that did not happen pulls on its signal where that was the nearest.

        Args:
            node: The event.
            w: World.
            step: When the signal was the nearest.
            signal: What has to come nearer.
            by: How much is missing.
            scale: So much costs 1.
        """
        slope = self.term(f"{node.id}/miss", w, by, squared(scale))
        self.loss[w] += MISSED
        self.pull(w, step, signal, slope)

    def delay(self, w: int, touch: Touch, slope: float) -> None:
        """Takes a derivative by the time of a touch."""
        self._delay[touch.contact] = self._delay.get(touch.contact, 0.0) + slope
        self.horizon[w] = max(self.horizon[w], touch.step + 1)

    def happened(
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
            move_time(self.term(f"{node.id}/time", w, time, shape))
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
            slope = self.term(name, w, time - since, inside(low, high, TIME_SCALE_S))
            move_time(slope)
            self._move(w, c.since, -slope)
            return
        if c.object not in self.plan.scene.names:
            return
        body, low, high = self.plan.scene.index(c.object), 0.01 * low, 0.01 * high
        if c.quantity in ("speed_after", "speed_before"):
            signal = speed(body)
            first, last = step + 1, step + round(0.12 / self.dt)
            if c.quantity == "speed_before":
                first = last = max(step - round(0.025 / self.dt), 0)
            last = min(last, self.n_steps)
            series = signal.value(self.at(w, slice(first, last + 1)))
            if not len(series):
                return
            pick = first + int(np.argmax(series))
            value, scale = float(series.max()), SPEED_SCALE_MPS
        elif c.quantity in ("distance", "height"):
            pick, scale = step, DISTANCE_SCALE_M
            if c.to is not None:
                names = self.plan.scene.names
                others = [names.index(m) for m in self.plan.story.expand(c.to) if m in names]
                signal = gap(self.plan, [body], others)
            elif c.quantity == "height":
                signal = Signal((body,), lambda s: s[0][:, body, 2])
            else:
                signal = away(body, self.states[0][w, 0, body])
            value = float(signal.value(self.at(w, slice(step, step + 1)))[0])
        else:
            return
        slope = self.term(name, w, value, inside(low, high, scale))
        self.pull(w, pick, signal, slope)

    # -- states and times ----------------------------------------------------------------------

    def at(self, w: int, steps: slice) -> States:
        p, q, v = self.states
        return p[w, steps], q[w, steps], v[w, steps]

    def lowest(self, w: int, signal: Signal, earliest: float) -> tuple[int, float]:
        """Step and value of a signal's minimum from a time on."""
        first = min(math.ceil(earliest / self.dt - 1e-9), self.n_steps)
        coarse = signal.value(self.at(w, slice(first, None, _COARSE)))
        near = first + _COARSE * int(np.argmin(coarse))
        low, high = max(near - _COARSE, first), min(near + _COARSE, self.n_steps)
        fine = signal.value(self.at(w, slice(low, high + 1)))
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

    def term(self, name: str, w: int, value: float, shape: Shape) -> float:
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
                p, q, v = self.at(w, slice(step, step + 1))
                copies = tuple(np.repeat(s, 2 * width, axis=0) for s in (p, q, v))
                for k in range(width):
                    copies[which][2 * k, body, k] += _STEP
                    copies[which][2 * k + 1, body, k] -= _STEP
                value = signal.value((copies[0], copies[1], copies[2]))
                out.append((which, body, (value[0::2] - value[1::2]) / (2.0 * _STEP)))
        return out

    def pull(self, w: int, step: int, signal: Signal, slope: float) -> None:
        if slope == 0.0:
            return
        for which, body, d in self._slopes(w, step, signal):
            self._seeds[which][w, step, body] += slope * d
        self.horizon[w] = max(self.horizon[w], step)

    def crossing(self, w: int, step: int, signal: Signal, slope: float) -> None:
        """Derivative by the time at which a falling signal crosses a fixed value."""
        first, last = max(step - 2, 0), max(step, 1)
        series = signal.value(self.at(w, slice(first, last + 1)))
        rate = float(series[-1] - series[0]) / ((len(series) - 1) * self.dt)
        if abs(rate) > 0.02:
            self.pull(w, last, signal, -slope / rate)
