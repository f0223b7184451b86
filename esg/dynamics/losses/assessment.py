"""Event losses: how far each world of a rollout is from the timeline, and in what respect.

The task term of an event vanishes when it happens, its window term when it happens on time
(paper, equations for Collision, PositionAt, UniformMotion, Brake and windows). Every term is
divided by a reference scale of its type, so that all are of order one. An event that depends on
an earlier one is only looked for after it.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from esg.dynamics.losses.kinds import EventKind, Measure, kind_of
from esg.dynamics.losses.quantities import QUANTITIES, TIME_SCALE_S, quantity_of
from esg.dynamics.losses.recording import Bools, Floats, Recording
from esg.dynamics.losses.shapes import MISSED, UNBRAKED, UNMET, bowl, distance_loss, unbraked
from esg.dynamics.story.story import Story, bounds
from esg.engines.scene import Rollout, SimScene
from esg.graph.models import EdgeEvent, EventConstraint, TimelineNode
from esg.thresholds import SAFE_BRAKED_TO


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
        guessed: The terms that only prefer a time that nobody asked for.
    """

    total: Floats
    completed: dict[str, Bools] = field(default_factory=dict)
    time: dict[str, Floats] = field(default_factory=dict)
    measured: dict[str, Floats] = field(default_factory=dict)
    error: dict[str, Floats] = field(default_factory=dict)
    terms: dict[str, Floats] = field(default_factory=dict)
    guessed: set[str] = field(default_factory=set)

    def worlds(self, span: slice) -> Assessment:
        """The assessment of some of the worlds."""
        return Assessment(
            self.total[span],
            {k: v[span] for k, v in self.completed.items()},
            {k: v[span] for k, v in self.time.items()},
            {k: v[span] for k, v in self.measured.items()},
            {k: v[span] for k, v in self.error.items()},
            {k: v[span] for k, v in self.terms.items()},
            self.guessed,
        )

    def asked(self) -> Floats:
        """The total without what only prefers a time that nobody asked for, shape [W]."""
        return self.total - sum((self.terms[k] for k in sorted(self.guessed)), np.zeros(1))

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
            quantity = quantity_of(name)
            allowed = np.full(len(self.total), quantity.tolerance)
            if perturbed:
                allowed += quantity.drift * np.abs(np.nan_to_num(self.measured[name]))
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
            kind = kind_of(node)
            if kind.measure is not None:
                self._event(node, kind, kind.measure)
            elif kind.by_program:
                self.result.time[node.id] = self.rec.program_time(node)
                self._order(node)
            else:
                self.result.time[node.id] = np.zeros(self.rec.n)
        self._braking()
        self.result.total[~self.rec.r.valid] = 1e6
        self.result.total = np.nan_to_num(self.result.total, nan=1e6, posinf=1e6)
        return self.result

    def _event(self, node: TimelineNode, kind: EventKind, measure: Measure) -> None:
        """Measures an event and adds order, window and constraints."""
        previous = self.rec.story.previous_outcome(node.id)
        earliest = np.zeros(self.rec.n)
        ready = np.ones(self.rec.n, bool)
        for before in self.rec.story.previous_outcomes(node.id):
            ready &= self.result.completed[before]
            earliest = np.maximum(earliest, np.nan_to_num(self.result.time[before]))
        if previous is not None:
            earliest = np.where(ready, earliest, 0.0) + kind.gap_s
        time, far = measure(self.rec, node, np.where(ready, earliest, np.inf), self._term)
        done = ready & np.isfinite(time) & self.rec.r.valid
        loss = np.where(done, 0.0, MISSED + distance_loss(far))
        loss = np.where(ready, loss, MISSED + 30.0)
        self.result.completed[node.id] = done
        self.result.time[node.id] = np.where(done, time, np.nan)
        self._term(f"{node.id}/task", loss)
        spacing = None
        if previous is not None:
            spacing = kind.spacings.get(kind_of(self.rec.story.nodes[previous]).event)
        if spacing is not None:
            cost = spacing.cost(time - earliest)
            self._term(f"{node.id}/{spacing.term}", np.where(done, cost, 0.0))
        self._window(node, time, done)
        for constraint in node.constraints:
            self._constraint(node, kind, constraint, done)

    def _order(self, node: TimelineNode) -> None:
        """The program triggers nothing before a turn or trigger that it shall follow is over."""
        late = np.zeros(self.rec.n)
        for before in self.rec.story.before.get(node.id, ()):
            earlier = self.rec.story.nodes[before]
            if kind_of(earlier).by_program:
                end = np.nan_to_num(self.rec.program_time(earlier))
                late = np.maximum(late, end - self.result.time[node.id])
        self._term(f"{node.id}/order", unbraked(late / TIME_SCALE_S))

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
            name = f"{node.id}/window"
            self._term(name, np.where(done, 0.02 * (miss / (beta * width)) ** 2, 0.0))
            self.result.guessed.add(name)
            return
        name = f"{node.id}/time/{node.id}"
        low, high = low + self.bias.get(name, 0.0), high + self.bias.get(name, 0.0)
        error = np.maximum(time - high, 0.0) - np.maximum(low - time, 0.0)
        self.result.measured[name] = np.where(done, time, np.nan)
        self.result.error[name] = np.where(done, error, np.inf)
        self._term(f"{node.id}/window", np.where(done, bowl(error / TIME_SCALE_S), UNMET))

    def _constraint(
        self, node: TimelineNode, kind: EventKind, c: EventConstraint, done: Bools
    ) -> None:
        quantity = QUANTITIES[c.quantity]
        value = quantity.measure(self.rec, self.result.time, node, c, kind.distance)
        low, high, _ = bounds(c.value, (0.0, 0.0))
        low, high = low * quantity.si, high * quantity.si
        name = f"{node.id}/{c.quantity}/{c.object}"
        low, high = low + self.bias.get(name, 0.0), high + self.bias.get(name, 0.0)
        inner = 0.15 * (high - low)
        error = np.maximum(value - high, 0.0) - np.maximum(low - value, 0.0)
        # Aim at the inside of an interval: a value on its edge does not survive another engine.
        push = np.maximum(value - (high - inner), 0.0) + np.maximum(low + inner - value, 0.0)
        known = done & np.isfinite(value)
        self.result.measured[name] = np.where(known, value, np.nan)
        self.result.error[name] = np.where(known, error, np.inf)
        self._term(name, np.where(known, bowl(push / quantity.scale), UNMET))

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
