"""Who wears what: statements of garments and of hair, and what stays owned up to."""

from __future__ import annotations

import csv

import pytest

from esg.draft import draft
from esg.draft import lexicon as lex
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def told(doc: EsgDocument) -> list[tuple[str, str, tuple[str, ...]]]:
    """Predicate, noun and wearers of what is worn, in the order of the words."""
    of_wear = (Predicate.WEARS, Predicate.LOOKS)
    return [
        (s.predicate.value, s.noun or "", s.object)
        for s in doc.statements or ()
        if s.predicate in of_wear
    ]


def lost(doc: EsgDocument) -> list[str]:
    """Words that are owned up to."""
    said = doc.statements or ()
    return [s.text for s in said if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    ("prompt", "worn"),
    [
        ("A man in a black t-shirt walks.", ["black t shirt"]),
        ("A girl in a red dress runs past a bench.", ["red dress"]),
        ("A woman wearing a blue swimsuit walks.", ["blue swimsuit"]),
        ("A boy, who wears a yellow helmet, runs.", ["yellow helmet"]),
        ("A worker in an orange vest and hard hat walks.", ["orange vest", "hard hat"]),
        ("A man in a green coat, blue jeans and brown boots walks.",
         ["green coat", "blue jeans", "brown boots"]),
        ("A girl pushes a cart wearing a red hat.", ["red hat"]),
        ("A man in a suit and tie walks.", ["suit and tie"]),
        ("A man with a red backpack on his back walks.", ["red backpack"]),
        ("A man dressed in black walks.", ["black clothes"]),
        ("A woman wears a hat and walks.", ["hat"]),
        ("The girl is wearing a red dress and white shoes. She walks.",
         ["red dress", "white shoes"]),
        ("A dog wearing a birthday hat and sunglasses runs.", ["birthday hat", "sunglasses"]),
        ("A cat with a red collar runs.", ["red collar"]),
        ("A girl with red hair, wearing glasses, runs.", ["red hair", "glasses"]),
        ("A soldier in uniform walks.", ["uniform"]),
    ],
)  # fmt: skip
def test_what_is_worn_is_stated_and_is_no_thing(prompt: str, worn: list[str]) -> None:
    doc = draft(prompt)
    assert verify(doc) == ()
    assert [noun for _, noun, _ in told(doc)] == worn
    assert not [w for w in lost(doc) if {*w.split()} & {*" ".join(worn).split()}]
    held = {"man", "girl", "woman", "boy", "worker", "dog", "cat", "soldier", "cart", "bench"}
    nodes = {n.rpartition("_")[0] for n in doc.spatial_relation_graph.nodes}
    assert nodes - {"ground", "floor", "road", "grass"} <= held


def test_members_of_a_group_wear_it_each() -> None:
    assert told(draft("Two girls in pink dresses run.")) == [
        ("wears", "pink dresses", ("girl_1", "girl_2"))
    ]


@pytest.mark.parametrize(
    ("prompt", "owned"),
    [
        ("A woman in a red sari walks.", ["red", "sari"]),
        ("A man in a bear suit walks.", ["bear suit"]),
        ("A boy in a torn coat runs.", ["torn"]),
        ("A man in a hat walks. The hat falls off.", ["hat"]),
        ("A snake in a red coat crawls.", None),
    ],
)
def test_what_is_not_drawn_is_owned_up_to(prompt: str, owned: list[str] | None) -> None:
    doc = draft(prompt)
    if owned is None:
        assert told(doc) == []
    else:
        assert [w for w in lost(doc) if w in owned] == owned


@pytest.mark.parametrize(
    ("prompt", "nodes"),
    [
        ("A dog bumps a man with a hat, and the hat falls off.", {"hat_1"}),
        ("A boy throws his cap at a cat.", {"cap_1"}),
        ("A hat lies on a table.", {"hat_1"}),
    ],
)
def test_what_something_happens_to_is_a_thing(prompt: str, nodes: set[str]) -> None:
    doc = draft(prompt)
    assert nodes <= {*doc.spatial_relation_graph.nodes}
    assert told(doc) == []


def _rows() -> list[dict[str, str]]:
    with open(lex.DATA / "looks.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter=";"))


@pytest.mark.parametrize("row", _rows(), ids=lambda row: row["words"].split("|")[0])
def test_adjectives_say_how_somebody_looks(row: dict[str, str]) -> None:
    doc = draft(row["example"])
    assert [noun for _, noun, _ in told(doc)] == [row["says"]]
    assert not {*lost(doc)} & {*row["words"].split("|")}


@pytest.mark.parametrize(
    ("prompt", "worn"),
    [
        ("The man in the blue shirt throws the ball to the man in the red shirt.",
         [("blue shirt", "man_1"), ("red shirt", "man_2")]),
        ("A boy in red and a girl in blue run.",
         [("red clothes", "boy_1"), ("blue clothes", "girl_1")]),
        ("A man in a red cap walks. The man in the red cap stops.", [("red cap", "man_1")]),
    ],
)  # fmt: skip
def test_clothes_tell_people_apart(prompt: str, worn: list[tuple[str, str]]) -> None:
    assert [(noun, *who) for _, noun, who in told(draft(prompt))] == worn


def test_a_bald_old_man_has_no_grey_hair() -> None:
    doc = draft("A bald old man walks. The old man stops.")
    assert [noun for _, noun, _ in told(doc)] == ["bald head"]
    assert lost(doc) == []
