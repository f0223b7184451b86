"""What a draft tells, for tests."""

from __future__ import annotations

from typing import Any

from esg.draft import draft
from esg.graph import verify

_TOLD = {"Collision", "EnterRegion", "Fall", "Topple", "Stop", "HeadingReached", "Reach", "Miss"}


def events(prompt: str) -> list[tuple[Any, ...]]:
    """Point events of a verifier-clean draft: type and participants."""
    doc = draft(prompt)
    assert verify(doc) == ()
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    return [(n.event.value, *n.participants) for n in nodes if n.event.value in _TOLD]
