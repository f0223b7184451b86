"""What measures of statements share: the question, its time, and the answer."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from esg.graph.models import Predicate
from esg.metrics.binding import Binding
from esg.metrics.models import SuiteStatement
from esg.metrics.replay import Replay
from esg.thresholds import HIT_GAP_S, MOMENT_S, OPENING_S, SAMPLE_S

OF_MOTION = frozenset(
    {
        Predicate.MOVES,
        Predicate.CLIMBS,
        Predicate.ROLLS,
        Predicate.SLIDES,
        Predicate.SPINS,
        Predicate.TUMBLES,
        Predicate.CARRIED_BY,
        Predicate.SLOWER_THAN,
        Predicate.FASTER_THAN,
    }
)
"""Nothing moves at one instant: at the start or the end these are about some time."""


@dataclass(frozen=True)
class Kept:
    """The answer of a measure.

    Args:
        kept: None if there is nothing to measure.
        measured: Numbers worth recording, names carry the unit.
        reason: Why it is broken, or not measured.
    """

    kept: bool | None
    measured: dict[str, float] = field(default_factory=dict[str, float])
    reason: str = ""

    @staticmethod
    def when(holds: bool, reason: str, **measured: float) -> Kept:
        """Kept if it holds, else broken for a reason."""
        return Kept(bool(holds), measured, "" if holds else reason)


@dataclass(frozen=True)
class Window:
    """The time that a statement is about.

    Args:
        begin, end: [s]; equal for one instant.
        first, last: Frames, inclusive.
    """

    begin: float
    end: float
    first: int
    last: int

    @property
    def frames(self) -> slice:
        """All its frames."""
        return slice(self.first, self.last + 1)

    def samples(self, replay: Replay) -> NDArray[np.int64]:
        """Its frames about every `SAMPLE_S`, the first and the last included."""
        step = max(1, round(SAMPLE_S / replay.frame_s))
        return np.unique(np.append(np.arange(self.first, self.last + 1, step), self.last))

    def contains(self, time: float, replay: Replay) -> bool:
        """Whether a time lies in it, give or take half a frame; by an instant, the same touch."""
        slack = HIT_GAP_S if self.begin == self.end else 0.5 * replay.frame_s
        return self.begin - slack <= time <= self.end + slack


@dataclass(frozen=True)
class StatementQuery:
    """One statement to measure.

    Args:
        statement: The suite's, or the document's.
        object, target, alike: Bindings of its participants ("a" and "b" are object and target).
        window: The time it is about.
        times: Of the events of the scene [s], None for those that did not happen.
    """

    statement: SuiteStatement
    object: Binding
    target: Binding
    alike: Binding
    window: Window
    times: Mapping[str, float | None]

    @property
    def goal(self) -> str:
        """How messages call the target."""
        return self.target.phrase.lstrip("=") or "anything"

    @property
    def at_start(self) -> bool:
        """Whether it is about the first instant."""
        return self.statement.when == "start"

    def limits(self) -> tuple[float | None, float | None]:
        """Lower and upper bound of what it states, the same number for a value."""
        if self.statement.range is not None:
            return self.statement.range
        return self.statement.value, self.statement.value


def window_of(
    statement: SuiteStatement, replay: Replay, times: Mapping[str, float | None]
) -> Window | str:
    """The time that a statement is about, or why there is none."""
    when = statement.when
    if when == "throughout":
        return _window(replay, float(replay.time[0]), replay.end)
    first, dots, last = when.partition("..")
    known: dict[str, float | None] = {**times, "start": float(replay.time[0]), "end": replay.end}
    for name in (first, last) if dots else (first,):
        if name not in known:
            return f"no event {name!r} is measured"
        if known[name] is None:
            return f"event {name} did not happen"
    begin, end = known[first], known[last if dots else first]
    assert begin is not None
    assert end is not None
    if begin > end:
        return f"{first} comes after {last} ({begin:.2f} s, {end:.2f} s)"
    if dots:
        if statement.says is not Predicate.TOUCHES:
            # Between two events it is after the moment of the one and before that of the other.
            middle = 0.5 * (begin + end)
            begin = min(begin + MOMENT_S, middle) if first in times else begin
            end = max(end - MOMENT_S, middle) if last in times else end
        return _window(replay, begin, end)
    if first in times:
        return _window(replay, begin - MOMENT_S, end + MOMENT_S)
    if statement.says in OF_MOTION:
        span = OPENING_S if first == "start" else -OPENING_S
        begin, end = sorted((begin, begin + span))
    return _window(replay, begin, end)


def _window(replay: Replay, begin: float, end: float) -> Window:
    begin, end = max(begin, float(replay.time[0])), min(end, replay.end)
    return Window(begin, end, replay.frame_at(begin), replay.frame_at(end))
