"""How actors move while the timeline is built."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from esg.draft.discourse.windows import START
from esg.graph.models import ForceDirection, Quantity, Role


@dataclass
class Motion:
    """How an actor moves since its last event."""

    mode: str
    speed: Quantity | None = None
    prescribed: bool = False
    target: str | None = None
    params: dict[str, Any] = field(default_factory=dict[str, Any])
    duration: Quantity | None = None


@dataclass
class Track:
    """State of one actor while the timeline is built."""

    at: str = START
    role: Role = Role.PASSIVE
    motion: Motion | None = None
    hit: bool = False
    launched: bool = False
    direction: ForceDirection | None = None
    closed: bool = True
    """Whether the current motion already led to an event."""
    after: str | None = None
    """Somebody else's event that it waits for before its first motion."""

    @property
    def under_way(self) -> bool:
        """Whether it moves: by itself, or carried on by what hit it."""
        return self.motion is not None or (self.hit and self.role is Role.PASSIVE)

    @property
    def waiting(self) -> bool:
        """Whether it stands still until an event that has been told."""
        standing = (
            self.motion is not None and self.motion.mode == "own" and self.motion.speed == 0.0
        )
        return standing and self.closed
