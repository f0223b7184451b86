"""Captions of strangers: what is there, what goes on from a clause, who is meant, what goes down."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, NodeEvent, Predicate
from tests.draft.told import drawn, events, owned, stated


def held(doc: EsgDocument) -> dict[str, str]:
    """What carries or holds a thing."""
    graph = doc.spatial_relation_graph
    regions = {
        n: graph.semantic_regions.get(x.semantic_region or "") for n, x in graph.nodes.items()
    }
    hosts = {n: r.parent_object for n, r in regions.items() if r is not None}
    return {n: h for n, h in hosts.items() if not graph.nodes[h].is_structural}


def related(doc: EsgDocument) -> set[tuple[str, str, str]]:
    """The relations of two things, but for which way they face."""
    told = doc.spatial_relation_graph.edges.binary_relations
    return {(r.from_, r.relation_type.value, r.to) for r in told if r.relation_type.value != "face"}


def motions(doc: EsgDocument) -> set[tuple[str, str | None]]:
    """Who moves, and what for."""
    assert doc.timeline_system is not None
    return {(e.actor, e.target) for e in doc.timeline_system.sequence_graph.edges}


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        (
            "In the middle of a table a tall candle burns between two brass candlesticks that are"
            " empty.",
            {"table_1", "candle_1", "candlestick_1", "candlestick_2"},
        ),
        ("A cup stands between two mugs.", {"cup_1", "mug_1", "mug_2"}),
        ("Two sofas face a wall. A couch stands behind them.", {"sofa_1", "sofa_2", "couch_1",
                                                               "wall_1"}),
        ("Two dogs run past sleeping dogs.", {f"dog_{k}" for k in range(1, 6)}),
        ("Two boxes stand on a table. Small boxes lie in front of them.",
         {"table_1", *(f"box_{k}" for k in range(1, 6))}),
        ("Two cars meet in a street with parked cars on both sides.",
         {"street_1", *(f"car_{k}" for k in range(1, 6))}),
        ("A bicycle falls over, knocking down the one next to it.", {"bicycle_1", "bicycle_2"}),
        ("A tree falls on the one next to it.", {"tree_1", "tree_2"}),
        ("A red car hits the one beside it.", {"red_car_1", "car_1"}),
        ("A ball is thrown as another is dropped; neither hits the other.",
         {"ball_1", "second_ball_1"}),
        ("A van stops in a gap between two trucks.", {"van_1", "truck_1", "truck_2"}),
        ("A woman fills the glass to the rim.", {"woman_1", "glass_1"}),
        ("Two cubes of different weight stand on a table.", {"cube_1", "cube_2", "table_1"}),
        ("A robot lifts a crate, one gripper at each end, and turns.", {"robot_1", "crate_1"}),
    ],
)  # fmt: skip
def test_a_phrase_names_what_is_new_and_only_that(prompt: str, things: set[str]) -> None:
    assert drawn(draft(prompt)) == things


@pytest.mark.parametrize(
    ("prompt", "places"),
    [
        ("A suitcase lies under a table, and on top of the table there is a hat.",
         {"hat_1": "table_1"}),
        ("A bowl stands on a table, and in the bowl are three apples.",
         {"bowl_1": "table_1", **{f"apple_{k}": "bowl_1" for k in (1, 2, 3)}}),
        ("A cat sleeps under a chair, while on the chair there is a dog.", {"dog_1": "chair_1"}),
        ("A dog lies on a rug, and next to the dog there is a bowl with a bone in it.",
         {"dog_1": "rug_1", "bone_1": "bowl_1"}),
        ("There is a table, and on it there is a lamp.", {"lamp_1": "table_1"}),
    ],
)  # fmt: skip
def test_a_place_told_first_is_of_what_follows(prompt: str, places: dict[str, str]) -> None:
    doc = draft(prompt)
    assert held(doc) == places
    assert not [w for w in owned(doc) if "table" in w or "chair" in w]


def test_a_relation_told_first_is_of_what_follows() -> None:
    doc = draft("A chair stands left of a table, and under the table is a ball.")
    assert related(doc) == {("chair_1", "left_of", "table_1"), ("ball_1", "under", "table_1")}


@pytest.mark.parametrize(
    ("prompt", "happens"),
    [
        ("A ball falls into a basket, followed by a cube.",
         [("EnterRegion", "ball_1"), ("EnterRegion", "cube_1")]),
        ("A man throws a ball into a basket, followed by a cube.",
         [("EnterRegion", "ball_1"), ("EnterRegion", "cube_1")]),
        ("The red marble reaches a cup first, and then the green one.",
         [("Reach", "red_marble_1", "cup_1"), ("Reach", "green_marble_1", "cup_1")]),
        ("Put the blue cube in the bin, then the red cube.",
         [("EnterRegion", "blue_cube_1"), ("EnterRegion", "red_cube_1")]),
        ("Pick up the red block and put it in the box, then the blue one.",
         [("EnterRegion", "red_block_1"), ("EnterRegion", "blue_block_1")]),
        ("A white ball hits a red ball, then a blue ball.",
         [("Collision", "white_ball_1", "red_ball_1"),
          ("Collision", "white_ball_1", "blue_ball_1")]),
        ("A cup is hit by a ball and goes flying off a table.",
         [("Collision", "ball_1", "cup_1"), ("Fall", "cup_1")]),
        ("Three balls lie in a row. A fourth hits the first.",
         [("Collision", "fourth_ball_1", "first_ball_1")]),
        ("Two balls hang on strings. The left one is pulled aside and released and hits the right"
         " one.", [("Collision", "left_ball_1", "right_ball_1")]),
        ("Three jars fall off a shelf one by one.",
         [("Fall", "jar_1"), ("Fall", "jar_2"), ("Fall", "jar_3")]),
        ("Only when a ball hits a post does the lamp fall.",
         [("Collision", "ball_1", "post_1"), ("Topple", "lamp_1")]),
        ("Drop two balls onto a table.",
         [("Collision", "ball_1", "table_1"), ("Collision", "ball_2", "table_1")]),
        ("A waiter trips and gets up.", [("Topple", "waiter_1")]),
        ("Two vans meet in a lane.", []),
        ("Two vans meet in a lane with a crash.", [("Collision", "van_1", "van_2")]),
        ("A van reverses to let a truck through.", [("Miss", "truck_1", "van_1")]),
        ("Three cars go by, nobody stopping for a man.", []),
        ("A runner falls behind.", []),
    ],
)  # fmt: skip
def test_what_happens(prompt: str, happens: list[tuple[str, ...]]) -> None:
    assert events(prompt) == happens


def test_what_is_done_to_things_without_an_article() -> None:
    doc = draft("Drawer pulled out, spoon dropped in, drawer pushed shut again.")
    assert doc.timeline_system is not None
    told = [n.event for n in doc.timeline_system.sequence_graph.nodes[1:]]
    assert told == [NodeEvent.OPEN, NodeEvent.ENTER_REGION, NodeEvent.CLOSE]


@pytest.mark.parametrize(
    ("prompt", "follows"),
    [
        ("A truck drives along a road, followed by a car.", ("car_1", "truck_1")),
        ("A cat runs across a yard, chased by a dog.", ("dog_1", "cat_1")),
        ("A horse trots around a field, led by a girl.", ("horse_1", "girl_1")),
        ("A boy walks after a dog through a park.", ("boy_1", "dog_1")),
    ],
)
def test_who_follows_is_behind_and_goes_along(prompt: str, follows: tuple[str, str]) -> None:
    doc = draft(prompt)
    who, ahead = follows
    assert (who, "behind", ahead) in related(doc)
    assert {who, ahead} <= {actor for actor, _ in motions(doc)}


@pytest.mark.parametrize(
    ("prompt", "stays"),
    [
        ("Put the red cube in a bin. Leave the green cube where it is.", "green_cube_1"),
        ("A robot lifts a cup and leaves the plate alone.", "plate_1"),
        ("The arm picks up a cup, leaving the plate untouched.", "plate_1"),
        ("Take the red cube, but leave the blue cube in place.", "blue_cube_1"),
        ("A ball and a cube are released at the top of a ramp. The cube does not move at all.",
         "cube_1"),
    ],
)  # fmt: skip
def test_what_is_left_alone_stays_still(prompt: str, stays: str) -> None:
    doc = draft(prompt)
    assert [s.object for s in stated(doc, Predicate.STAYS_STILL)] == [(stays,)]
    assert stays not in {actor for actor, _ in motions(doc)}


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball is placed at the top of a ramp and released.",
        "A ball is at the top of a slope. It is let go.",
        "A ball is released from rest atop a ramp.",
        "A ball is held at the top of a ramp and let go.",
        "A man releases a ball at the top of a hill.",
    ],
)
def test_what_is_let_go_on_a_slope_runs_down_it(prompt: str) -> None:
    doc = draft(prompt)
    down = [s for s in stated(doc, Predicate.MOVES) if s.direction == "down"]
    assert [s.object for s in down] == [("ball_1",)]
    assert held(doc)["ball_1"] == down[0].target[0]
    assert events(prompt) == []


def test_who_comes_first_is_owned_up_to_where_nothing_times_the_others() -> None:
    race = "Two balls are released atop a ramp; the red ball arrives first."
    assert "first" in owned(draft(race))
    assert "first" not in owned(draft("A red ball reaches a cup first, and then a green one."))


def test_a_place_beside_something_is_of_the_goal() -> None:
    doc = draft("Pick up the sponge and place it in the bowl to the left of the mug.")
    assert ("bowl_1", "left_of", "mug_1") in related(doc)
    assert stated(doc, Predicate.LEFT_OF) == []


def test_where_a_thing_is_sent_is_not_where_it_sits() -> None:
    doc = draft(
        "A ball drops onto a seesaw, launching the bear sitting at the other end into the air and"
        " over a hedge."
    )
    assert not any(kind == "above" for _, kind, _ in related(doc))
    assert "over a hedge" in owned(doc)


def test_a_bare_verb_before_it_is_an_act() -> None:
    doc = draft("The garbage truck lifts the bin, empties it, and sets it down on the curb.")
    assert drawn(doc) == {"garbage_truck_1", "bin_1", "curb_1"}
    assert any("empties" in w for w in doc.coverage.warnings)


def test_what_hangs_from_the_ceiling_swings_when_it_is_let_go() -> None:
    doc = draft("A ball hangs on a string from the ceiling. It is pulled aside and let go.")
    assert doc.timeline_system is not None
    assert [e.event.value for e in doc.timeline_system.sequence_graph.edges] == ["Release"]
    assert events("A ball hangs on a string from the ceiling. It is pulled aside.") == []


def test_neither_after_a_verb_denies_both() -> None:
    assert events("A cart hits a wall and splits neither the crate nor the drum.") == [
        ("Collision", "cart_1", "wall_1")
    ]


@pytest.mark.parametrize(
    ("prompt", "happens"),
    [
        ("A glass slides off the tray, then a plate.", [("Fall", "glass_1"), ("Fall", "plate_1")]),
        ("A dog runs past a cat, then a cow.",
         [("Miss", "dog_1", "cat_1"), ("Miss", "dog_1", "cow_1")]),
        ("A ball rolls past a box, then a cone.",
         [("Miss", "ball_1", "box_1"), ("Miss", "ball_1", "cone_1")]),
    ],
)  # fmt: skip
def test_whose_part_a_bare_noun_takes(prompt: str, happens: list[tuple[str, ...]]) -> None:
    assert events(prompt) == happens


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("There is a table, and next to it a chair.", ("chair_1", "adjacent", "table_1")),
        ("A cup stands on a table, under the table a box.", ("box_1", "under", "table_1")),
        ("A boy stands on a wall and under the wall a cat sleeps.", ("cat_1", "under", "wall_1")),
        ("A ball lies in front of a box and behind the box a cone lies.",
         ("cone_1", "behind", "box_1")),
    ],
)  # fmt: skip
def test_a_place_goes_with_the_noun_after_it(prompt: str, relation: tuple[str, str, str]) -> None:
    doc = draft(prompt)
    assert relation in related(doc)
    assert not owned(doc)


def test_it_is_what_can_be_closed() -> None:
    doc = draft("Open the drawer, take out the scissors and close it again.")
    assert doc.timeline_system is not None
    told = [(n.event, n.participants) for n in doc.timeline_system.sequence_graph.nodes]
    assert (NodeEvent.CLOSE, ("drawer_1",)) in told


def test_what_stands_beside_a_thing_on_a_table_is_on_it() -> None:
    doc = draft("A cup stands on a table. A plate lies next to the cup.")
    assert held(doc) == {"cup_1": "table_1", "plate_1": "table_1"}
    rug = draft("A dog lies on a rug. A bowl stands next to the dog.")
    assert held(rug) == {"dog_1": "rug_1"}
    floor = draft("A cup stands on a table. A man stands next to the table.")
    assert held(floor) == {"cup_1": "table_1"}


def test_who_carries_acts() -> None:
    doc = draft("Two glasses stand on a tray that is carried by a waiter.")
    assert held(doc)["tray_1"] == "waiter_1"
    assert ("waiter_1", None) in motions(doc)


@pytest.mark.parametrize(
    "prompt",
    [
        "Put the box on the table beside the lamp; don't let the lamp fall.",
        "A robot pushes a crate past a lamp without letting the lamp topple.",
        "Roll the ball past the lamp. Never allow the lamp to tip over.",
    ],
)
def test_what_is_not_to_be_let_happen_does_not_happen(prompt: str) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    events = {n.event.value for n in doc.timeline_system.sequence_graph.nodes}
    assert not events & {"Fall", "Topple"}
    assert any(
        s.predicate is Predicate.STAYS_UPRIGHT and s.object == ("lamp_1",)
        for s in doc.statements or ()
    )
