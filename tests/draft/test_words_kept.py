"""What a sentence presupposes, denies or leaves out: one of several, "neither of", "a ball he threw"."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.statements.several import ALONE
from esg.graph.models import EsgDocument, NodeEvent


def _owned(doc: EsgDocument) -> dict[str, str]:
    """What a draft owns up to: its words, and what is missing."""
    told = doc.statements or ()
    return {s.text: s.note or "" for s in told if s.predicate.value == "not_represented"}


def _events(doc: EsgDocument) -> list[tuple[str, ...]]:
    timeline = doc.timeline_system
    nodes = timeline.sequence_graph.nodes if timeline is not None else ()
    return [(n.event.value, *n.participants) for n in nodes]


def _movers(doc: EsgDocument) -> set[str]:
    timeline = doc.timeline_system
    return {e.actor for e in timeline.sequence_graph.edges} if timeline is not None else set()


def _kinds(doc: EsgDocument) -> list[str]:
    nodes = doc.spatial_relation_graph.nodes.values()
    return [doc.asset_requirement[n.asset_id].asset_category for n in nodes if not n.is_structural]


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("put the middle black bowl on the plate", "middle black bowl"),
        ("Pick up the left cup and put it in the sink.", "left cup"),
        ("A crow steals the biggest sausage.", "biggest sausage"),
        ("push the nearest box off the table", "nearest box"),
        ("The second car brakes.", "second car"),
        ("The remaining ball rolls into the hole.", "remaining ball"),
    ],
)
def test_one_of_several_without_the_others_is_owned_up_to(prompt: str, words: str) -> None:
    assert _owned(draft(prompt))[words] == ALONE


@pytest.mark.parametrize(
    "prompt",
    [
        "A car passes a truck. The second car brakes.",
        "The last domino falls.",
        "Three cups stand in a row. A ball hits the middle cup.",
        "A cube hits a sphere; the sphere then hits the remaining cylinder.",
        "A car hits a wall with its left wheel.",
        "A dog runs to the left.",
    ],
)
def test_one_of_several_with_the_others_is_not(prompt: str) -> None:
    assert ALONE not in _owned(draft(prompt)).values()


def test_neither_of_which_stays() -> None:
    doc = draft("A car passes two cones, neither of which moves.")
    assert _movers(doc) == {"car_1"}


@pytest.mark.parametrize("word", ["neither", "none"])
def test_hit_by_none_of_them(word: str) -> None:
    told = _events(draft(f"A cyclist falls and is hit by {word} of the two cars."))
    assert [t[0] for t in told if "cyclist_1" in t] == ["Topple", "Miss", "Miss"]


@pytest.mark.parametrize(
    ("prompt", "event"),
    [
        ("A van is hit broadside by a sedan.", ("Collision", "sedan_1", "van_1")),
        ("A car is struck broadside by a bus.", ("Collision", "bus_1", "car_1")),
        ("A truck broadsides a van.", ("Collision", "truck_1", "van_1")),
        ("A red ball someone threw hits a lamp.", ("Collision", "red_ball_1", "lamp_1")),
        ("A crate a man pushed slides into a wall.", ("Collision", "crate_1", "wall_1")),
        ("The box the robot pushed falls off the table.", ("Collision", "robot_1", "box_1")),
    ],
)
def test_who_hits_whom(prompt: str, event: tuple[str, ...]) -> None:
    assert event in _events(draft(prompt))


@pytest.mark.parametrize(
    "prompt", ["When the ball hit the wall the boy kicked.", "A boy gave the dog the ball."]
)
def test_two_nouns_without_a_relative_clause(prompt: str) -> None:
    assert "person" not in {*_kinds(draft(prompt))} - {"child"}


@pytest.mark.parametrize(
    ("prompt", "stops"),
    [
        ("A boy slides a mug across the table, stopping short of the edge.", "mug_1"),
        ("A girl rolls a marble across the floor, stopping at the wall.", "marble_1"),
        ("Someone throws a ball across the yard, stopping at a fence.", "ball_1"),
        ("A car passes a bus, stopping at a wall.", "car_1"),
    ],
)
def test_what_is_sent_off_stops(prompt: str, stops: str) -> None:
    assert ("Stop", stops) in _events(draft(prompt))


def test_what_nobody_wants_is_not_done() -> None:
    doc = draft("A boy throws a bag because he didn't want to carry it.")
    assert _movers(doc) == {"bag_1"}


@pytest.mark.parametrize("where", ["from a bridge", "from above", "on a drone"])
def test_what_is_filmed_is_not_launched(where: str) -> None:
    doc = draft(f"A train passes a house, shot {where}.")
    held = any(s.filming == "aerial" for s in doc.statements or ())
    assert "shot" in _owned(doc) or (held and where == "from above")
    assert [e for e, *_ in _events(doc) if e != "SceneStart"] == ["Miss"]


def test_what_is_shot_from_a_bow_is() -> None:
    assert "shot" not in _owned(draft("An arrow, shot from a bow, hits a target."))


@pytest.mark.parametrize(
    ("prompt", "verb"),
    [
        ("An archer shoots a goblin.", "shoots"),
        ("A soldier shoots at a tank.", "shoots"),
        ("She serves wide.", "serves"),
        ("A girl throws at a can.", "throws"),
    ],
)
def test_shots_of_which_nothing_flies_are_owned_up_to(prompt: str, verb: str) -> None:
    assert verb in _owned(draft(prompt))


@pytest.mark.parametrize(
    "prompt",
    ["A hunter shoots an arrow at a deer.", "A player shoots, and the puck hits the post."],
)
def test_shots_that_fly_are_not(prompt: str) -> None:
    assert "shoots" not in _owned(draft(prompt))


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("Of the four cubes only the two red ones move.", {"red_cube_1", "red_cube_2"}),
        ("Five cars wait at a gate. The two blue ones drive off.", {"blue_car_1", "blue_car_2"}),
    ],
)
def test_so_many_of_a_plural_get_their_colour(prompt: str, who: set[str]) -> None:
    assert _movers(draft(prompt)) == who


@pytest.mark.parametrize(
    "prompt",
    [
        "Stack the two smaller cubes on the larger one.",
        "The two small cubes hit the large one.",
        "Put the two lighter cubes on the heavier one.",
    ],
)
def test_the_larger_one_is_none_of_the_two_smaller(prompt: str) -> None:
    doc = draft(prompt)
    assert _kinds(doc).count("block") == 3
    assert "it is drawn beside those that it is one of" not in _owned(doc).values()


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("Two adders lie on a plate.", "snake"),
        ("A warbler sits on a fence.", "bird"),
        ("An irish setter runs across a lawn.", "dog"),
        ("Three cars wait at a light.", "traffic_light"),
        ("A van stops at the lights and drives on.", "traffic_light"),
    ],
)
def test_words_of_two_senses(prompt: str, kind: str) -> None:
    doc = draft(prompt)
    assert kind in _kinds(doc)
    assert "person" not in _kinds(doc)


def test_next_to_tells_no_order() -> None:
    doc = draft("A man puts a box next to a door and leaves.")
    assert [s.text for s in doc.statements or () if s.predicate.value == "stays_still"] == [
        "leaves"
    ]


@pytest.mark.parametrize(
    ("prompt", "actor"),
    [
        ("A robot drives off a table and lands in a bin.", "robot_1"),
        ("A toy car drives off the desk into a bucket.", "toy_car_1"),
        ("A truck drives off its ramp.", "truck_1"),
    ],
)
def test_what_drives_off_something_was_on_it_and_falls(prompt: str, actor: str) -> None:
    doc = draft(prompt)
    nodes = doc.timeline_system.sequence_graph.nodes
    assert any(n.event is NodeEvent.FALL and n.participants == (actor,) for n in nodes)
    assert doc.spatial_relation_graph.nodes[actor].semantic_region is not None


def test_off_the_road_is_owned_up_to() -> None:
    assert "off the road" in _owned(draft("A car drives off the road and hits a tree."))
    assert not _owned(draft("A car drives off."))
