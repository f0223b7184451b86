"""What a draft tells, for tests."""

from __future__ import annotations

from typing import Any

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate, Statement

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


def stated(doc: EsgDocument, predicate: Predicate) -> list[Statement]:
    """The statements of a document of one kind."""
    return [s for s in doc.statements or () if s.predicate is predicate]


def owned(doc: EsgDocument) -> list[str]:
    """The words that a draft owns up to."""
    return [s.text for s in stated(doc, Predicate.NOT_REPRESENTED)]


def drawn(doc: EsgDocument) -> set[str]:
    """The things that a text names and a draft has."""
    nodes = doc.spatial_relation_graph.nodes
    return {n for n, node in nodes.items() if node.mentioned and n != "ground_1"}
