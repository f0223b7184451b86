"""Several alike things that are let go: each of them falls, and in turn where that is told."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, NodeEvent, Predicate


def _done(doc: EsgDocument, event: NodeEvent) -> list[str]:
    return [n.participants[0] for n in doc.timeline_system.sequence_graph.nodes if n.event is event]


def _lost(doc: EsgDocument) -> list[str]:
    said = doc.statements or ()
    return [s.text for s in said if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "event", "number"),
    [
        ("Drop six cubes onto a table.", NodeEvent.COLLISION, 6),
        ("Four tennis balls fall into a basket.", NodeEvent.ENTER_REGION, 4),
        ("Three coins fall onto the floor.", NodeEvent.FALL, 3),
        ("Several books fall off a shelf.", NodeEvent.FALL, 4),
        ("Two apples and three pears fall from a tree.", NodeEvent.FALL, 5),
        ("Four dominoes are dropped onto a board.", NodeEvent.COLLISION, 4),
        ("Five blocks hang above a tray. They are dropped.", NodeEvent.COLLISION, 5),
    ],
)
def test_each_of_several_falls_and_none_after_another(
    prompt: str, event: NodeEvent, number: int
) -> None:
    doc = draft(prompt)
    assert not verify(doc)
    assert len({*_done(doc, event)}) == number
    assert not {"fall", "dropped", "Drop"} & {*_lost(doc)}
    told = [n for n in doc.timeline_system.sequence_graph.nodes if n.event is event]
    assert len({n.window for n in told}) == 1


def test_what_falls_in_turn_lands_in_turn_and_to_the_ground_that_is_owned_up_to() -> None:
    doc = draft("A boy drops three stones into a bucket, one after another.")
    order = [s.object for s in doc.statements or () if s.predicate is Predicate.BEFORE]
    assert order == [("stone_1_enter", "stone_2_enter"), ("stone_2_enter", "stone_3_enter")]
    assert not _lost(doc)
    assert "one after another" in _lost(
        draft("Eight spheres fall to the ground one after another.")
    )


def test_a_stack_that_falls_and_more_than_a_dozen_stay_one() -> None:
    assert _lost(draft("Thirty balls fall into a bucket."))
    assert _lost(draft("A stack of four boxes collapses onto the floor."))
