"""What a draft tells, for tests."""

from __future__ import annotations

from typing import Any

from esg.draft import draft
from esg.graph import verify

_TOLD = {"Collision", "EnterRegion", "Fall", "Topple", "Stop", "HeadingReached", "Reach", "Miss"}


def events(prompt: str, *, regions: bool = False) -> list[tuple[Any, ...]]:
    """Point events of a verifier-clean draft: type, participants and, if asked for, the region."""
    doc = draft(prompt)
    assert verify(doc) == ()
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    return [
        (n.event.value, *n.participants, *([n.region] if regions and n.region else []))
        for n in nodes
        if n.event.value in _TOLD
    ]
