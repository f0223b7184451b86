"""Event losses: how far each world of a rollout is from the timeline, and in what respect.

The task term of an event vanishes when it happens, its window term when it happens on time
(paper, equations for Collision, PositionAt, UniformMotion, Brake and windows). Every term is
divided by a reference scale of its type, so that all are of order one. An event that depends on
an earlier one is only looked for after it.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from esg.dynamics.losses.measures import DISTANCE_SCALE_M, MEASURES, gap_over_time
from esg.dynamics.losses.recording import Bools, Floats, Recording
from esg.dynamics.losses.shapes import MISSED, UNBRAKED, UNMET, bowl, distance_loss, unbraked
from esg.dynamics.story.story import Story, bounds
from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EdgeEvent, EventConstraint, NodeEvent, TimelineNode
from esg.thresholds import MIN_EVENT_GAP_S, SAFE_BRAKED_TO
from esg.units import yaw_from_quat

CHAIN_MARGIN_S, FALLEN_MARGIN_S, CLOSE = 0.03, 0.1, 0.4
"""A hit this much later than that survives another engine; loss of one that is not later at all."""
TIME_SCALE_S = 0.1
SPEED_SCALE_MPS = 0.25

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
SENSITIVITY = {"speed_after": 0.08, "time_to_stop": 0.05}
"""Share of its value by which restitution + 0.1 or friction - 20% alone moves a quantity."""
SETTLED_S = 0.2
"""A hit this long after a fall follows it in every engine."""


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

    def worlds(self, span: slice) -> Assessment:
        """The assessment of some of the worlds."""
        return Assessment(
            self.total[span],
            {k: v[span] for k, v in self.completed.items()},
            {k: v[span] for k, v in self.time.items()},
            {k: v[span] for k, v in self.measured.items()},
            {k: v[span] for k, v in self.error.items()},
            {k: v[span] for k, v in self.terms.items()},
        )

    def all_completed(self) -> Bools:
        """Worlds in which every event happened, shape [W]."""
        out = np.ones(len(self.total), bool)
        for done in self.completed.values():
            out &= done
        return out

    def within_tolerance(self, *, perturbed: bool = False) -> Bools:
        """Worlds in which every prescribed quantity is met, shape [W].

        Args:
            perturbed: Allow for what the perturbations of an ensemble change by themselves.
        """
        out = np.ones(len(self.total), bool)
        for name, error in self.error.items():
            quantity = name.split("/")[1]
            allowed = np.full(len(self.total), TOLERANCE[quantity])
            if perturbed:
                share = SENSITIVITY.get(quantity, 0.0)
                allowed += share * np.abs(np.nan_to_num(self.measured[name]))
            out &= np.abs(error) <= allowed
        return out


def assess(
    scene: SimScene,
    story: Story,
    rollout: Rollout,
    times: list[dict[str, float]],
    bias: dict[str, float] | None = None,
) -> Assessment:
    """Measures a rollout against the timeline.

    Args:
        scene: The scene that was simulated.
        story: The timeline.
        rollout: W worlds.
        times: Per world, the program's own times of triggers and heading changes by node id [s].
        bias: By constraint, what this engine measures too much [SI]; targets move by as much.
    """
    return _Assessor(Recording(scene, story, rollout, times), bias or {}).run()


class _Assessor:
    """Adds up the terms of all events, in the story's order."""

    def __init__(self, recording: Recording, bias: dict[str, float]) -> None:
        self.rec, self.bias = recording, bias
        self.result = Assessment(np.zeros(recording.n))

    def run(self) -> Assessment:
        for node in self.rec.story.nodes.values():
            if node.event is NodeEvent.SCENE_START:
                self.result.time[node.id] = np.zeros(self.rec.n)
            elif node.event is NodeEvent.TRIGGER:
                self.result.time[node.id] = self.rec.program_time(node)
                self._order(node)
            else:
                self._event(node)
        self._braking()
        self.result.total[~self.rec.r.valid] = 1e6
        self.result.total = np.nan_to_num(self.result.total, nan=1e6, posinf=1e6)
        return self.result

    def _event(self, node: TimelineNode) -> None:
        """Measures an event and adds order, window and constraints."""
        previous = self.rec.story.previous_outcome(node.id)
        earliest = np.zeros(self.rec.n)
        ready = np.ones(self.rec.n, bool)
        for before in self.rec.story.previous_outcomes(node.id):
            ready &= self.result.completed[before]
            earliest = np.maximum(earliest, np.nan_to_num(self.result.time[before]))
        if previous is not None:
            earliest = np.where(ready, earliest, 0.0)
            if node.event is NodeEvent.COLLISION:
                earliest = earliest + MIN_EVENT_GAP_S
        measure = MEASURES[node.event]
        time, far = measure(self.rec, node, np.where(ready, earliest, np.inf), self._term)
        done = ready & np.isfinite(time) & self.rec.r.valid
        loss = np.where(done, 0.0, MISSED + distance_loss(far))
        loss = np.where(ready, loss, MISSED + 30.0)
        self.result.completed[node.id] = done
        self.result.time[node.id] = np.where(done, time, np.nan)
        self._term(f"{node.id}/task", loss)
        if node.event is NodeEvent.COLLISION and self._is(previous, NodeEvent.COLLISION):
            # What follows too closely counts as one hit in another engine.
            spare = (time - earliest) / CHAIN_MARGIN_S
            self._term(f"{node.id}/close", np.where(done, CLOSE * np.clip(1 - spare, 0, 1), 0.0))
        if node.event is NodeEvent.COLLISION and self._is(previous, NodeEvent.TOPPLE):
            # It leans against what it hits before another engine counts it as toppled.
            spare = (time - earliest) / FALLEN_MARGIN_S
            self._term(f"{node.id}/close", np.where(done, CLOSE * np.clip(1 - spare, 0, 1), 0.0))
        if node.event is NodeEvent.COLLISION and self._is(previous, NodeEvent.FALL):
            early = np.clip(SETTLED_S - (time - earliest + MIN_EVENT_GAP_S), 0.0, SETTLED_S)
            self._term(f"{node.id}/early", np.where(done, early, 0.0))
        self._window(node, time, done)
        for constraint in node.constraints:
            self._constraint(node, constraint, done)

    def _order(self, node: TimelineNode) -> None:
        """The program triggers nothing before a turn or trigger that it shall follow is over."""
        late = np.zeros(self.rec.n)
        for before in self.rec.story.before.get(node.id, ()):
            if self.rec.story.nodes[before].event in (NodeEvent.TRIGGER, NodeEvent.HEADING_REACHED):
                end = np.nan_to_num(self.rec.program_time(self.rec.story.nodes[before]))
                late = np.maximum(late, end - self.result.time[node.id])
        self._term(f"{node.id}/order", unbraked(late / TIME_SCALE_S))

    def _is(self, node_id: str | None, event: NodeEvent) -> bool:
        return node_id is not None and self.rec.story.nodes[node_id].event is event

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
        name = f"{node.id}/time/{node.id}"
        low, high = low + self.bias.get(name, 0.0), high + self.bias.get(name, 0.0)
        error = np.maximum(time - high, 0.0) - np.maximum(low - time, 0.0)
        self.result.measured[name] = np.where(done, time, np.nan)
        self.result.error[name] = np.where(done, error, np.inf)
        self._term(f"{node.id}/window", np.where(done, bowl(error / TIME_SCALE_S), UNMET))

    def _constraint(self, node: TimelineNode, c: EventConstraint, done: Bools) -> None:
        value, scale = self._measure(node, c)
        low, high, _ = bounds(c.value, (0.0, 0.0))
        factor = 1.0 if c.quantity in ("time_since", "time_to_stop", "angle") else 0.01
        low, high = low * factor, high * factor
        name = f"{node.id}/{c.quantity}/{c.object}"
        low, high = low + self.bias.get(name, 0.0), high + self.bias.get(name, 0.0)
        inner = 0.15 * (high - low)
        error = np.maximum(value - high, 0.0) - np.maximum(low - value, 0.0)
        # Aim at the inside of an interval: a value on its edge does not survive another engine.
        push = np.maximum(value - (high - inner), 0.0) + np.maximum(low + inner - value, 0.0)
        known = done & np.isfinite(value)
        self.result.measured[name] = np.where(known, value, np.nan)
        self.result.error[name] = np.where(known, error, np.inf)
        self._term(name, np.where(known, bowl(push / scale), UNMET))

    def _measure(self, node: TimelineNode, c: EventConstraint) -> tuple[Floats, float]:
        time = self.result.time[node.id]
        body = self.rec.scene.index(c.object) if c.object in self.rec.scene.names else 0
        if c.quantity == "time_since":
            since = self.result.time.get(c.since or "", np.zeros(self.rec.n))
            return time - since, TIME_SCALE_S
        if c.quantity == "time_to_stop":
            return time - self._brake_start(c.object), TIME_SCALE_S
        if c.quantity == "speed_after":
            return self.rec.extreme(self.rec.speed[:, :, body], time, 0.0, 0.12), SPEED_SCALE_MPS
        if c.quantity == "speed_before":
            return self.rec.at(
                self.rec.speed[:, :, body], time - 1.5 / self.rec.fps
            ), SPEED_SCALE_MPS
        if c.quantity == "height":
            return self.rec.at(
                self.rec.r.position[:, :, body, 2].astype(float), time
            ), DISTANCE_SCALE_M
        if c.quantity == "angle":
            yaw = np.unwrap(yaw_from_quat(self.rec.r.quaternion[:, :, body]), axis=1)
            return np.degrees(np.abs(self.rec.at(yaw, time) - yaw[:, 0])), 5.0
        if c.to is not None:
            gap = gap_over_time(self.rec, [body], self.rec.members(c.to))
            return self.rec.at(gap, time), DISTANCE_SCALE_M
        if node.event in (NodeEvent.MISS, NodeEvent.REACH):
            a, b = (self.rec.members(p) for p in (node.participants[0], node.participants[-1]))
            return gap_over_time(self.rec, a, b, near_only=True).min(axis=1), DISTANCE_SCALE_M
        position = self.rec.r.position[:, :, body].astype(float)
        start = position[:, :1]
        if node.event is NodeEvent.STOP:
            # The way in which it stops begins with its braking.
            begin = self._brake_start(c.object)
            axes = [self.rec.at(position[..., k], begin) for k in range(3)]
            start = np.stack(axes, axis=-1)[:, None]
        moved = np.linalg.norm(position - start, axis=-1)
        return self.rec.at(moved, time), DISTANCE_SCALE_M

    def _braking(self) -> None:
        """A braked phase that ends in an event has taken at least half of the speed by then."""
        for actor, phases in self.rec.story.phases.items():
            body = self.rec.scene.index(actor)
            for phase in phases:
                if phase.edge.event is not EdgeEvent.BRAKE:
                    continue
                begin = self.result.time[phase.start.id]
                end = self.result.time.get(phase.end.id, np.full(self.rec.n, np.nan))
                before = self.rec.at(self.rec.speed[:, :, body], begin - 0.5 / self.rec.fps)
                after = self.rec.at(self.rec.speed[:, :, body], end - 1.5 / self.rec.fps)
                ratio = after / np.maximum(before, 0.1)
                late = np.isfinite(end)
                excess = np.maximum(ratio - SAFE_BRAKED_TO, 0.0)
                # A brake that sets in after the event has taken nothing: the later, the worse.
                behind = np.where(late, np.maximum(begin - end, 0.0), 0.0)
                excess = np.where(behind > 0.0, 1.0 + behind, excess)
                name = f"{phase.edge.id}/brake"
                # Not to get there at all is worse than to get there unbraked.
                self._term(name, np.where(late, unbraked(excess / 0.05), UNBRAKED))

    def _brake_start(self, actor: str) -> Floats:
        for phase in self.rec.story.phases.get(actor, ()):
            if phase.edge.event is EdgeEvent.BRAKE:
                return self.result.time[phase.start.id]
        return np.zeros(self.rec.n)
