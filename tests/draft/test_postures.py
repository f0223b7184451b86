"""Who sits, lies, kneels, crouches, bends or gets up: changes, statements, and what is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.events.senses.postures import rows
from esg.graph.models import EsgDocument, Predicate


def _told(doc: EsgDocument) -> list[tuple[str | None, str]]:
    return [(s.noun, s.when) for s in doc.statements or () if s.predicate is Predicate.POSTURE]


def _changes(doc: EsgDocument) -> list[tuple[str, str | None]]:
    edges = doc.timeline_system.sequence_graph.edges if doc.timeline_system else ()
    return [(e.params.posture, e.target) for e in edges if e.params.posture is not None]


def _owned(doc: EsgDocument) -> str:
    told = (s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED)
    return "|".join(s.text for s in told)


@pytest.mark.parametrize(
    ("prompt", "told", "changes"),
    [
        ("A dog sits quietly.", [("sits", "throughout")], []),
        ("A ball rolls into a dog that lies on the grass.", [("lies", "throughout")], []),
        ("A man kneels beside a car.", [("kneels", "throughout")], []),
        ("The horse lies down.", [("lies", "end")], [("lies", None)]),
        (
            "A person is sitting in a chair, then they suddenly stand up.",
            [("sits", "start"), ("stands", "end")],
            [("stands", None)],
        ),
        (
            "A woman walks to a bench and sits down.",
            [("sits", "end")],
            [("sits", "bench_1")],
        ),
        (
            "A dog is running around the yard, then it suddenly stops and lies down.",
            [("lies", "end")],
            [("lies", None)],
        ),
        ("A boy crouches, then jumps.", [("crouches", "start")], [("stands", None)]),
        (
            "A child gets up from the floor and walks away.",
            [("sits", "start"), ("stands", "start..end")],
            [("stands", None)],
        ),
        (
            "A man stands up and kneels down again.",
            [("sits", "start"), ("stands", "start..end"), ("kneels", "end")],
            [("stands", None), ("kneels", None)],
        ),
        ("A boy sits up.", [("lies", "start"), ("sits", "end")], [("sits", None)]),
        ("A woman walks to a box and bends down.", [("bends", "end")], [("bends", None)]),
    ],
)
def test_postures_are_stated_and_changes_are_segments(
    prompt: str, told: list[tuple[str, str]], changes: list[tuple[str, str | None]]
) -> None:
    doc = draft(prompt)
    assert _told(doc) == told
    assert _changes(doc) == changes


@pytest.mark.parametrize(
    "prompt",
    [
        "A man gets up from a chair.",
        "A boy gets up from the chair and runs away.",
        "An old woman rises to her feet from a chair.",
    ],
)
def test_who_gets_up_from_a_seat_was_on_it(prompt: str) -> None:
    doc = draft(prompt)
    graph = doc.spatial_relation_graph
    regions = (graph.semantic_regions.get(n.semantic_region or "") for n in graph.nodes.values())
    assert "chair_1" in {r.parent_object for r in regions if r is not None}
    assert _told(doc)[0] == ("sits", "start")
    assert not _owned(doc)
    assert "up" not in {s.direction for s in doc.statements or ()}


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("The cat curls up on the sofa.", "curls"),
        ("A man leans forward.", "forward"),
        ("A man falls asleep on a bench.", "falls asleep"),
        ("A cat walks to a rug and lies down on it.", "lies"),
        ("A man trips over a log, falls and gets up.", "gets up"),
        ("A man walks into a lamp post, sits down and gets up.", "sits"),
        ("A girl rides a horse and then lies down.", "lies"),
    ],
)
def test_what_is_not_held_is_owned_up_to(prompt: str, words: str) -> None:
    doc = draft(prompt)
    assert words in _owned(doc)
    assert not _changes(doc)


@pytest.mark.parametrize(
    "prompt",
    [
        "A woman sits on a horse.",
        "A bird sits on a branch.",
        "A man does not sit down.",
        "A cup sits on a table.",
        "The house stands on a hill.",
    ],
)
def test_others_have_no_postures(prompt: str) -> None:
    doc = draft(prompt)
    assert not _told(doc)
    assert not _changes(doc)


@pytest.mark.parametrize("row", [r for r in rows() if r.posture], ids=lambda r: r.example)
def test_every_row_has_an_example_that_it_reads(row: object) -> None:
    assert row.posture in {noun for noun, _ in _told(draft(row.example))}  # type: ignore[attr-defined]
