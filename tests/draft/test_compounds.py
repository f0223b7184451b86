"""Nouns of two words, parts of figures, crowds, and what goes on in the sky."""

import csv

import pytest

from esg.draft import draft
from esg.draft import lexicon as lex
from esg.graph.models import EsgDocument, Predicate


def things(doc: EsgDocument) -> dict[str, str]:
    """What is drawn, by node: the kind that is asked of the library."""
    graph = doc.spatial_relation_graph
    return {
        name: doc.asset_requirement[node.asset_id].asset_category
        for name, node in graph.nodes.items()
        if node.mentioned and not node.is_structural
    }


def owned(doc: EsgDocument) -> str:
    lost = [s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    return "; ".join(f"{s.text}: {s.note}" for s in lost)


def compounds() -> list[dict[str, str]]:
    with open(lex.DATA / "compounds.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE))


@pytest.mark.parametrize("row", compounds(), ids=lambda row: row["words"].partition("|")[0])
def test_a_row_is_read_as_it_says(row: dict[str, str]) -> None:
    """The example has words of its row, and is drafted as with the noun that they are read as."""
    said = next(w for w in row["words"].split("|") if w in row["example"].lower())
    plain = row["example"].lower().replace(said, row["reads as"])
    first, second = (sorted(things(draft(text)).values()) for text in (row["example"], plain))
    assert first == second


@pytest.mark.parametrize(
    ("prompt", "drawn"),
    [
        ("A ball rolls into the dust pan.", {"ball", "dustpan"}),
        ("A cat sits next to the tea pot.", {"cat", "teapot"}),
        ("A ball hits the snow man.", {"ball", "snowman"}),
        ("A man stands beside the book shelf.", {"man", "bookshelf"}),
        ("A goose crosses the bike path.", {"goose"}),
        ("A ball rolls into the mouse trap.", {"ball", "trap"}),
        ("The water falls onto a rock.", {"water", "rock"}),
        ("A car hits a van broadside.", {"car", "van"}),
    ],
)
def test_two_words_are_one_thing(prompt: str, drawn: set[str]) -> None:
    assert {name.rsplit("_", 1)[0] for name in things(draft(prompt))} == drawn


@pytest.mark.parametrize(
    ("noun", "drawn"),
    [("pipe cleaner", "walking stick"), ("poker chip", "ball"), ("sleeping bag", "sack")],
)
def test_a_compound_of_another_kind_is_owned_up_to(noun: str, drawn: str) -> None:
    doc = draft(f"A ball hits the {noun}.")
    assert f"the {noun}: a stand-in is drawn: {drawn}" in owned(doc)


@pytest.mark.parametrize(
    ("prompt", "nodes"),
    [
        ("The tail of the dog hits the vase.", {"dog_1", "vase_1"}),
        ("A bird lands on the nose of the elephant.", {"bird_1", "elephant_1"}),
        ("A ball hits the teeth of the crocodile.", {"ball_1", "crocodile_1"}),
        ("The hand of the robot touches the cup.", {"robot_1", "cup_1"}),
    ],
)
def test_a_part_is_no_thing_beside_its_whole(prompt: str, nodes: set[str]) -> None:
    assert things(draft(prompt)).keys() == nodes


@pytest.mark.parametrize(
    ("prompt", "nodes"),
    [
        ("A rabbit hops through a field under a pale moon.", {"rabbit_1"}),
        ("A wolf stands on a cliff, stars twinkling above.", {"wolf_1", "cliff_1"}),
        ("A robot walks through a city, rain falling.", {"robot_1"}),
        ("A mug stands on a table, steam rising.", {"mug_1", "table_1"}),
        ("A chef tosses an egg in a wok, flames leaping.", {"chef_1", "egg_1", "wok_1"}),
        ("A fox runs across a field, film grain.", {"fox_1"}),
        ("A cat sits on a roof in Tokyo.", {"cat_1", "roof_1"}),
    ],
)
def test_sky_weather_style_and_towns_are_no_things_and_move_none(
    prompt: str, nodes: set[str]
) -> None:
    doc = draft(prompt)
    assert things(doc).keys() == nodes
    system = doc.timeline_system
    events = {n.event.value for n in system.sequence_graph.nodes} if system else set[str]()
    assert not events & {"Topple", "Fall"}


@pytest.mark.parametrize(
    "prompt",
    [
        "The crowd cheers.",
        "The football team stands by a bus.",
        "A school choir stands on a stage.",
    ],
)
def test_crowds_and_teams_are_persons(prompt: str) -> None:
    drawn = things(draft(prompt))
    assert sum(kind == "person" for kind in drawn.values()) > 1


@pytest.mark.parametrize(
    ("prompt", "absent"),
    [
        ("A man cuts a plank and saws off the end.", "saw"),
        ("She mops the floor and kicks a ball.", "mop"),
        ("She plants the pole and clears a hurdle.", "plant"),
    ],
)
def test_verbs_with_an_object_are_no_things(prompt: str, absent: str) -> None:
    assert not any(name.startswith(absent) for name in things(draft(prompt)))


def test_a_cabinet_is_not_in_its_drawer() -> None:
    doc = draft("Put the can into the bottom drawer of the cabinet.")
    nodes, regions = doc.spatial_relation_graph.nodes, doc.spatial_relation_graph.semantic_regions
    region = regions.get(nodes["cabinet_1"].semantic_region or "")
    assert region is None or region.parent_object != "drawer_1"
