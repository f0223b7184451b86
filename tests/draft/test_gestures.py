"""Who waves, nods, looks or wags his tail, and what smokes: statements, and what is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.events.senses.gestures import rows
from esg.graph.models import EsgDocument, Predicate
from esg.lexicon.gestures import gestures


def _of(doc: EsgDocument, says: Predicate) -> list[tuple[str | None, str]]:
    return [(s.noun, s.when) for s in doc.statements or () if s.predicate is says]


def _owned(doc: EsgDocument) -> str:
    told = (s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED)
    return "|".join(s.text for s in told)


@pytest.mark.parametrize("row", rows(), ids=lambda r: r.example)
def test_every_row_is_held(row) -> None:
    doc = draft(row.example)
    says = Predicate.GESTURES if row.gesture else Predicate.FACES
    held = [noun for noun, _ in _of(doc, says)]
    assert held == [row.gesture or None]
    assert not row.gesture or row.gesture in {name for name, _ in gestures()}


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A man walks to a bench and waves.", [("waves", "man_1_bench_1_reach..end")]),
        ("A woman waves and walks to a bench.", [("waves", "throughout")]),
        (
            "A man waves, walks to a bench and claps.",
            [("waves", "start..man_1_bench_1_reach"), ("claps", "man_1_bench_1_reach..end")],
        ),
        ("A boy runs to a tree while a girl claps.", [("claps", "throughout")]),
        (
            "A horse is running along the beach, then it suddenly stops and starts grazing.",
            [("grazes", "horse_1_stop..end")],
        ),
        ("A boy raises his hands.", [("raises both arms", "throughout")]),
    ],
)
def test_a_gesture_begins_after_what_is_told_before(
    prompt: str, told: list[tuple[str, str]]
) -> None:
    assert _of(draft(prompt), Predicate.GESTURES) == told


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A crowd cheers and claps.", "claps"),
        ("A robot waves its arm.", "waves"),
        ("A man waves a flag.", "waves"),
        ("A man raises his hand and then walks away.", "then"),
        ("A soldier salutes a general.", "salutes"),
        ("A boy kicks a ball into a goal and the crowd claps.", "claps"),
        ("Two men shake hands.", "shake"),
    ],
)
def test_what_is_not_drawn_is_owned_up_to(prompt: str, words: str) -> None:
    doc = draft(prompt)
    assert words in _owned(doc)
    assert words not in [s.text for s in doc.statements or () if s.predicate is Predicate.GESTURES]


def test_who_looks_at_something_faces_it() -> None:
    doc = draft("A teacher points at a car.")
    (faces,) = (s for s in doc.statements or () if s.predicate is Predicate.FACES)
    assert (faces.object, faces.target, faces.when) == (("teacher_1",), ("car_1",), "throughout")
    edges = doc.spatial_relation_graph.edges.binary_relations
    assert ("teacher_1", "car_1") in [(e.from_, e.to) for e in edges if e.relation_type == "face"]
    assert not _owned(doc)


@pytest.mark.parametrize(
    "prompt",
    ["Two men face each other.", "Two men look at each other.", "Two men wave at each other."],
)
def test_two_who_face_each_other(prompt: str) -> None:
    doc = draft(prompt)
    told = [s for s in doc.statements or () if s.predicate is Predicate.FACES]
    assert [(s.object, s.target) for s in told] == [
        (("man_1",), ("man_2",)),
        (("man_2",), ("man_1",)),
    ]
    assert not _owned(doc)


@pytest.mark.parametrize(
    ("prompt", "who", "noun", "when"),
    [
        ("Smoke rises from a chimney.", "chimney_1", "smoke", "throughout"),
        ("A kettle on a stove gives off steam.", "kettle_1", "steam", "throughout"),
        ("A steaming bowl of soup stands on a table.", "bowl_1", "steam", "throughout"),
        ("A smoking car stands on a road.", "car_1", "smoke", "throughout"),
        ("A firefighter runs to a smoking house.", "house_1", "smoke", "throughout"),
        ("A car hits a smoldering house.", "house_1", "smoke", "throughout"),
        ("A ball rolls past a steaming cup.", "cup_1", "steam", "throughout"),
        ("Sparks fly from the wheels of a train.", "train_1", "sparks", "throughout"),
        ("A horse gallops across a field and kicks up dust.", "horse_1", "dust", "throughout"),
        (
            "A car drives across the desert, leaving a cloud of dust behind it.",
            "car_1", "dust", "throughout",
        ),
        (
            "A house with smoke coming out of its chimney stands beside a tree.",
            "house_1", "smoke", "throughout",
        ),
        (
            "A truck hits a pole, and smoke rises from its engine.",
            "truck_1", "smoke", "truck_1_pole_1_collision..end",
        ),
    ],
)  # fmt: skip
def test_what_gives_off_smoke_and_dust(prompt: str, who: str, noun: str, when: str) -> None:
    doc = draft(prompt)
    (told,) = (s for s in doc.statements or () if s.predicate is Predicate.GIVES_OFF)
    assert (told.object, told.noun, told.when) == ((who,), noun, when)
    assert not _owned(doc)


@pytest.mark.parametrize("prompt", ["A car crashes into a wall, sparks fly.", "A man is smoking."])
def test_smoke_of_nothing_is_owned_up_to(prompt: str) -> None:
    doc = draft(prompt)
    assert not _of(doc, Predicate.GIVES_OFF)
    assert _owned(doc)


@pytest.mark.parametrize(
    ("prompt", "noun", "words"),
    [
        ("Thick black smoke pours from the roof of a house.", "smoke", "black"),
        ("A steam train passes, trailing white smoke.", "smoke", "white"),
        ("White steam rises from a kettle.", "steam", ""),
    ],
)
def test_colours_of_smoke_are_owned_up_to(prompt: str, noun: str, words: str) -> None:
    doc = draft(prompt)
    assert [n for n, _ in _of(doc, Predicate.GIVES_OFF)] == [noun]
    assert words in _owned(doc)


def test_exhaust_leaves_the_back_and_the_motion_stays() -> None:
    doc = draft("A motorcycle with smoke coming out of its exhaust drives along a road.")
    assert [n for n, _ in _of(doc, Predicate.GIVES_OFF)] == ["exhaust"]
    assert [n for n, _ in _of(doc, Predicate.MOVES)]


def test_both_arms_are_nobodys_but_his() -> None:
    doc = draft("A woman raises both arms.")
    assert "arm_1" not in doc.spatial_relation_graph.nodes
    assert _of(doc, Predicate.GESTURES) == [("raises both arms", "throughout")]
