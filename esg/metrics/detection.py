"""What event detectors share: thresholds of the suite format, query and result."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from esg.metrics.binding import Binding
from esg.metrics.models import SuiteEvent
from esg.metrics.replay import Hit, Replay

T_MAX_S = 15.0
MAX_CONTACT_DEPTH_M = 0.05
MIN_IMPULSE_NS = 0.1
RECHECK_AFTER_S = 0.2
MAX_RECHECK_DEPTH_M = 0.02
MIN_EVENT_GAP_S = 0.1
MOVING_MPS = 0.2
MOVING_FOR_S = 0.5
STOPPED_MPS = 0.1
STOPPED_FOR_S = 0.2
TURN_TOLERANCE_DEG = 20.0
ENTERED_FOR_S = 0.2
TOPPLED_DEG = 45.0
REACH_M = 0.3


@dataclass(frozen=True)
class Found:
    """Result of a detector.

    Args:
        time: Of the event [s]; None if it was not completed.
        bodies: Indices of the bodies that decided, GROUND_INDEX for the ground.
        reason: Why not completed.
        measured: Numbers worth recording, names carry the unit.
        hit: The hit of a collision.
    """

    time: float | None
    bodies: tuple[int, ...] = ()
    reason: str = ""
    measured: dict[str, float] = field(default_factory=dict[str, float])
    hit: Hit | None = None

    @property
    def completed(self) -> bool:
        """Whether the event happened."""
        return self.time is not None


@dataclass(frozen=True)
class Query:
    """One event to detect.

    Args:
        event: The suite's event.
        bound: Bindings of its participants by field name.
        since: Only completions later than this count [s]; None: from scene start.
        until: Gives the time of the earliest later event of a body after a time (for brakes).
        meet_again: Whether a later event is a collision of the same two (for misses).
    """

    event: SuiteEvent
    bound: dict[str, Binding]
    since: float | None = None
    until: Callable[[int, float], float] | None = None
    meet_again: bool = False


def runs(mask: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """Start and end (exclusive) of every run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)


def duration_of(replay: Replay, start: int, stop: int) -> float:
    """Time from frame `start` to the last frame before `stop` [s]."""
    return float(replay.time[stop - 1] - replay.time[start])
