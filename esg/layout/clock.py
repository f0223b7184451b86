"""Processor seconds of the stages of a batch."""

from __future__ import annotations

from dataclasses import dataclass, field
import time


@dataclass
class Clock:
    """Sums processor seconds (of all threads of this process) by stage.

    Args:
        seconds: Stage to seconds; `search` is the search's own process, the other stages are sums
            over all processes.
    """

    seconds: dict[str, float] = field(default_factory=dict)
    _since: float = 0.0

    def start(self) -> None:
        """Begins a lap; what passed since the last one is nobody's."""
        self._since = time.process_time()

    def lap(self, stage: str) -> None:
        """Ends a lap and begins the next."""
        now = time.process_time()
        self.add(stage, now - self._since)
        self._since = now

    def add(self, stage: str, seconds: float) -> None:
        """Adds what was measured elsewhere."""
        self.seconds[stage] = self.seconds.get(stage, 0.0) + seconds
