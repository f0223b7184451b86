"""How a prompt says that the scene is filmed: each row of the table, and what is no camera."""

import csv

import pytest

from esg.draft import draft
from esg.draft import lexicon as lex
from esg.graph.filming import rows
from esg.graph.models import Predicate

with open(lex.DATA / "filming.csv", encoding="utf-8", newline="") as table:
    ROWS = list(csv.DictReader(table, delimiter=";", quoting=csv.QUOTE_NONE))


def filmed(prompt: str) -> list[tuple[str, str, tuple[str, ...]]]:
    """What is held of the camera: the way, the words, the objects."""
    return [
        (s.filming or "", s.text, s.object)
        for s in draft(prompt).statements or ()
        if s.predicate is Predicate.FILMED
    ]


def lost(prompt: str) -> list[tuple[str, str]]:
    """What is owned up to: the words and why."""
    return [
        (s.text, s.note)
        for s in draft(prompt).statements or ()
        if s.predicate is Predicate.NOT_REPRESENTED
    ]


@pytest.mark.parametrize("row", ROWS, ids=lambda r: f"{r['part']}-{r['filming']}-{r['words'][:20]}")
def test_each_row_reads_its_example(row):
    """Hold what every row says, and own up to no word of its example."""
    assert row["filming"] in {way for way, _, _ in filmed(row["example"])}
    assert not [text for text, note in lost(row["example"]) if "camera" in note or "camera" in text]


def test_every_way_is_read_and_planned():
    """Have words for every way to film, and a row that plans it."""
    assert {row["filming"] for row in ROWS} == set(rows())


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A low angle shot of a horse that gallops past a barn.",
         [("low_angle", "low angle shot", ("horse_1",))]),
        ("A wide aerial shot of a red car that drives along a road.",
         [("wide", "wide", ("red_car_1",)), ("aerial", "aerial shot", ("red_car_1",))]),
        ("The camera pans left and zooms in on a red ball as it rolls toward a box.",
         [("pans_left", "camera pans left", ("red_ball_1",)),
          ("zooms_in", "zooms in on", ("red_ball_1",))]),
        ("A ball rolls past a box. The camera slowly orbits around the box.",
         [("orbits", "camera slowly orbits around", ("box_1",))]),
        ("The camera follows it as a dog runs across a lawn.",
         [("follows", "camera follows", ("dog_1",))]),
        ("A ball rolls across a table. The camera does not move.",
         [("static", "camera does not move", ("ball_1",))]),
        ("A drone shot following a truck that drives along a road.",
         [("aerial", "drone shot", ("truck_1",)), ("follows", "following", ("truck_1",))]),
        ("The camera follows a man from behind as he walks along a street.",
         [("follows", "camera follows", ("man_1",)), ("from_behind", "from behind", ("man_1",))]),
        ("A wide shot of a street where a bus drives past a tree.",
         [("wide", "wide shot", ("bus_1",))]),
    ],
)  # fmt: skip
def test_words_and_what_they_are_about(prompt, told):
    """Keep the words, and whom the camera is about."""
    assert filmed(prompt) == told


@pytest.mark.parametrize(
    "prompt",
    [
        "A camera falls off a table.",
        "A drone follows a car along a road.",
        "A book falls from above.",
        "A player takes a long shot at the goal.",
        "A delivery drone clips a fence and falls.",
        "A drone moves up while a ball rolls across a floor.",
        "A ball rolls across a floor. There is no slow motion.",
        "A ball rolls off the top of a box.",
        "A rear camera view of a ball that rolls across a floor.",
    ],
)
def test_what_is_no_word_of_the_camera(prompt):
    """Hold nothing of what only sounds like it."""
    assert filmed(prompt) == []


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A drone shot following a red car along a road.", "following"),
        ("A wide shot of a dog that runs. Then a close-up of the dog.", "close-up"),
        ("The camera pans left, then zooms out while a dog walks.", "zooms out"),
        ("The camera quickly zooms in on a car that drives along a road.", "camera"),
        ("A dog runs. The camera pans left across the rooftops.", "across the rooftops"),
        ("A cinematic shot of a ball that rolls across a floor.", "cinematic"),
        ("A dashcam video of a car that drives along a road.", "dashcam"),
    ],
)
def test_what_is_not_held_is_owned_up_to(prompt, words):
    """Own up to a second shot, a later move, a fast one, a style, and what is not in the scene."""
    assert any(words in text for text, _ in lost(prompt))
    assert not any(words in text for _, text, _ in filmed(prompt))


def test_no_thing_is_made_of_the_camera():
    """Draw no drone for a drone shot, and no camera for the one that films."""
    for prompt in (
        "A cinematic aerial drone shot over a road, a truck drives along it.",
        "The camera is static. A ball rolls across a floor.",
        "POV of a man who walks along a street.",
    ):
        nodes = draft(prompt).spatial_relation_graph.nodes
        assert not [n for n in nodes if n.startswith(("drone", "camera", "pov"))]


@pytest.mark.parametrize(
    ("prompt", "other"),
    [
        ("A boat seen from above crosses a lake.", "lake"),
        ("A man seen from behind crosses the street.", "street"),
        ("A train seen from afar crosses a bridge.", "bridge"),
        ("A boat viewed from the side crosses a lake.", "lake"),
    ],
)
def test_who_is_seen_from_somewhere_acts(prompt, other):
    """Read the verb behind a side as what happens, and draw no crossroads for it."""
    doc = draft(prompt)
    ways = [s for s in doc.statements or () if s.predicate is Predicate.MOVES]
    assert ("across", (f"{other}_1",)) in [(s.direction, s.target) for s in ways]
    assert not [n for n in doc.spatial_relation_graph.nodes if n.startswith("cross")]


@pytest.mark.parametrize(
    ("prompt", "ways"),
    [
        ("From above, two cars race along a road.", ["aerial"]),
        ("From a distance, a dog runs across a lawn.", ["wide"]),
        ("From a low angle, a horse gallops past a barn.", ["low_angle"]),
        ("From above, a rock falls onto a car.", []),
        ("From behind, a van hits a car.", []),
        ("From a distance of 3 m, a ball rolls toward a box.", []),
    ],
)
def test_what_opens_a_sentence(prompt, ways):
    """Read where one sees it from, but not where something comes from."""
    assert [way for way, _, _ in filmed(prompt)] == ways
