"""Active, passive, participle and relative clause of one clause are read alike."""

from __future__ import annotations

import pytest

from benchmarks.voices import OUTCOMES, compared, read, run
from esg.draft import draft
from esg.graph.models import Predicate
from tests.draft.told import owned, stated


@pytest.mark.parametrize(
    ("caption", "active"),
    [
        ("A ball pushed across a table by a dog.", "A dog pushes a ball across a table."),
        ("A vase hit by a ball.", "A ball hits a vase."),
        ("A can whacked off a ledge by a dog.", "A dog whacks a can off a ledge."),
        ("A bus rammed by a truck.", "A truck rams a bus."),
        ("A bucket driven over by a motorcycle.", "A motorcycle drives over a bucket."),
        ("A ball bowled at a target by a girl.", "A girl bowls a ball at a target."),
    ],
)
def test_a_caption_without_is_tells_who_does_it(caption: str, active: str) -> None:
    assert compared(read(caption), read(active)) == "agrees"
    assert not read(caption).owns_up


@pytest.mark.parametrize(
    "text", ["A boy walked by a tree.", "A ball rolled by a tree.", "A bus drove by a house."]
)
def test_a_past_tense_before_by_is_a_way(text: str) -> None:
    doc = draft(text)
    assert doc.timeline_system is not None
    passed = {n.event.value for n in doc.timeline_system.sequence_graph.nodes}
    assert "Miss" in passed or "past" in {s.direction for s in stated(doc, Predicate.MOVES)}


@pytest.mark.parametrize(
    ("passive", "active"),
    [
        ("A toy car is ridden into a fence by a boy.", "A boy rides a toy car into a fence."),
        ("An orange is rolled toward a gate by a girl.", "A girl rolls an orange toward a gate."),
        ("A marble was rolled off a table by a cat.", "A cat rolls a marble off a table."),
        ("A dog is chased by a woman.", "A woman chases a dog."),
        ("A mug is knocked into a wall by a dog.", "A dog knocks a mug into a wall."),
        ("A vase is placed on a mat by a woman.", "A woman places a vase on a mat."),
        ("A bus is parked behind a wall by a man.", "A man parks a bus behind a wall."),
    ],
)
def test_a_passive_with_its_agent_is_its_active(passive: str, active: str) -> None:
    assert compared(read(passive), read(active)) == "agrees"
    assert not read(passive).owns_up


@pytest.mark.parametrize(
    "text",
    [
        "A bucket was leaned against a fence by a boy.",
        "A mug placed by a woman.",
        "There is a man that leans a bucket.",
        "There is a brick that is hung on a table by a girl.",
        "A woman covers a pot.",
        "A girl shields a dog.",
    ],
)
def test_what_somebody_puts_is_not_there_from_the_start(text: str) -> None:
    assert owned(draft(text))


@pytest.mark.parametrize(
    "text",
    ["A vase is placed on a mat.", "A carpet covers the floor.", "A car is pulled by a horse."],
)
def test_states_and_what_is_tied_own_up_to_nothing(text: str) -> None:
    assert not owned(draft(text))


@pytest.mark.parametrize(
    "text",
    [
        "A dog pushes a box behind a couch.",
        "A boy rolls a ball under a bed.",
        "A girl slides a book under a table.",
        "A man throws a ball between two trees.",
        "A car tows a van behind a wall.",
    ],
)
def test_where_a_thing_is_moved_to_is_not_where_it_starts(text: str) -> None:
    graph = draft(text).spatial_relation_graph
    kinds = {r.relation_type.value for r in graph.edges.binary_relations}
    kinds |= {m.relation_type.value for m in graph.edges.multi_relations}
    assert not kinds & {"behind", "under", "between"}


def test_what_is_hit_under_a_thing_is_there() -> None:
    graph = draft("A dog hits a box behind a couch.").spatial_relation_graph
    assert "behind" in {r.relation_type.value for r in graph.edges.binary_relations}


def test_who_parks_a_vehicle_is_in_it() -> None:
    doc = draft("A man parks a car.")
    assert any("inside the car" in w for w in doc.coverage.warnings)


@pytest.mark.parametrize("verb", ["stops", "halts", "parks"])
def test_what_there_is_that_stops_does_so(verb: str) -> None:
    doc = draft(f"There is a truck that {verb} near a tree.")
    assert doc.timeline_system is not None
    assert "Stop" in {n.event.value for n in doc.timeline_system.sequence_graph.nodes}


def test_what_is_driven_over_a_thing_is_not_run_over() -> None:
    assert "over a log" in owned(draft("A truck is driven over a log by a boy."))
    assert not owned(draft("A bucket is driven over by a motorcycle."))


def test_forms_agree_over_many_verbs() -> None:
    found = [outcome for _, _, outcome in run(every=25)]
    counts = {o: found.count(o) for o in OUTCOMES}
    assert len(found) > 250
    assert counts["silent"] <= 2, counts
    assert counts["told otherwise"] <= 20, counts


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Wheels spinning, a car stuck in the mud is pushed out by two men.", "is pushed"),
        (
            "An elderly man in a wheelchair being pushed along a pier by a nurse, seagulls overhead.",
            "being pushed",
        ),
        ("The lowest of three stacked boxes is pulled out by a robot.", "is pulled"),
    ],
)
def test_passives_own_up_to_their_verb(text: str, words: str) -> None:
    assert words in owned(draft(text))
