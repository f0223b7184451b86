"""What is drawn as something else is owned up to, and what hands take is drawn as it is packed."""

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def stand_ins(doc: EsgDocument) -> dict[str, str]:
    lost = [s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    head = "a stand-in is drawn: "
    return {s.text: s.note.removeprefix(head) for s in lost if s.note.startswith(head)}


@pytest.mark.parametrize(
    ("prompt", "shown"),
    [
        ("A ball hits a pulley.", {"a pulley": "tire"}),
        ("A sloth rolls down a hill.", {"A sloth": "monkey"}),
        ("The blorft slides into a wall.", {"The blorft": "plain box"}),
        ("A bigfoot walks past a tree.", {"A bigfoot": "plain box"}),
        ("A checker slides off the board.", {"A checker": "worker"}),
        ("An elbow tips the first domino.", {"An elbow": "arm"}),
        ("A piece of styrofoam lies on a table.", {"A piece of styrofoam": "plain box"}),
        ("A man rides up an escalator.", {"an escalator": "ramp"}),
        ("Two eels lie on a plate.", {"Two eels": "snake"}),
    ],
)
def test_what_is_no_such_thing_is_owned_up_to(prompt: str, shown: dict[str, str]) -> None:
    doc = draft(prompt)
    assert verify(doc) == ()
    assert stand_ins(doc) == shown


@pytest.mark.parametrize(
    "prompt",
    [
        "A beagle runs past a poplar.",
        "A kingfisher flies to a freighter.",
        "A mastiff knocks over a carafe.",
        "A red top and a blue top are spinning.",
        "A child runs on the wet tiles.",
        "A finger tips the first domino.",
        "A fire engine drives past a church.",
    ],
)
def test_what_is_such_a_thing_is_not(prompt: str) -> None:
    assert stand_ins(draft(prompt)) == {}


def test_what_is_owned_up_to_in_other_words_is_told_once() -> None:
    doc = draft("A jogger with a dog on a leash runs past a bench.")
    told = [s for s in doc.statements or () if s.text == "a leash"]
    assert [s.note for s in told] == [] or len(told) == 1


@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("pick up the alphabet soup and put it in the basket", "food_tin"),
        ("pick up the tomato sauce and place it in the basket", "food_tin"),
        ("pick up the salad dressing and place it in the basket", "sauce_bottle"),
        ("Pick up the ketchup.", "sauce_bottle"),
        ("pick up the orange juice and place it in the basket", "carton_of_milk"),
        ("put the butter on the plate", "food_packet"),
        ("put the cream cheese box in the basket", "food_packet"),
        ("Pick up the lemonade.", "plastic_bottle"),
    ],
)
def test_what_hands_take_is_packed_as_it_is_sold(prompt: str, category: str) -> None:
    doc = draft(prompt)
    assert category in {a.asset_category for a in doc.asset_requirement.values()}
    assert not stand_ins(doc)


@pytest.mark.parametrize(
    "prompt",
    [
        "A Mars rover moving on Mars",
        "A rover drives across Mars.",
        "A rover hits a boulder on the red planet.",
    ],
)
def test_a_planet_is_the_ground_and_nobody(prompt: str) -> None:
    categories = {a.asset_category for a in draft(prompt).asset_requirement.values()}
    assert "rover" in categories and not categories & {"person", "robot"}


@pytest.mark.parametrize(
    ("prompt", "big", "little"),
    [
        ("A big steel ball pushes a little wooden ball off a shelf.", "steel_ball", "ball"),
        ("A large marble ball hits a tiny rubber ball.", "ball", "rubber_ball"),
        ("A huge wooden ball rolls past a small steel ball.", "ball", "steel_ball"),
    ],
)
def test_the_big_one_of_a_kind_is_the_larger(prompt: str, big: str, little: str) -> None:
    sizes = {
        a.asset_category: a.expected_dimensions_cm[0]
        for a in draft(prompt).asset_requirement.values()
    }
    assert sizes[big] > 1.4 * sizes[little]


@pytest.mark.parametrize(
    ("prompt", "label"),
    [
        ("A car hits a little wooden ball.", "little wooden ball"),
        ("A car pushes a little dog.", "little dog"),
        ("A girl sees a little red ball roll.", "little red ball"),
    ],
)
def test_a_little_thing_is_little(prompt: str, label: str) -> None:
    assert label in {n.label for n in draft(prompt).spatial_relation_graph.nodes.values()}


def test_a_little_is_still_an_adverb() -> None:
    nodes = draft("The box slides a little and hits a ball.").spatial_relation_graph.nodes
    assert {n.label for n in nodes.values()} >= {"box", "ball"}


@pytest.mark.parametrize(
    ("prompt", "category"),
    [
        ("A red ball hits an orange one.", "ball"),
        ("A green car and an orange one collide.", "car"),
        ("A red cube slides into two orange ones.", "block"),
    ],
)
def test_an_orange_one_is_no_fruit(prompt: str, category: str) -> None:
    found = draft(prompt).asset_requirement.values()
    assert "orange" not in {a.asset_category for a in found}
    assert category in {a.asset_category for a in found}
