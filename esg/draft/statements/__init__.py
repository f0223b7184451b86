"""What the prompt states beyond objects, relations and events: one door, `state`."""

from __future__ import annotations

from esg.draft.statements.state import state

__all__ = ["state"]
