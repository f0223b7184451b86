"""Simple solids that enter a picture, traffic, parts of wholes, levers, what is drawn along."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def _drafted(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert verify(doc) == ()
    return doc


def _nodes(doc: EsgDocument) -> set[str]:
    """Node ids of what the prompt names."""
    return {i for i, node in doc.spatial_relation_graph.nodes.items() if node.mentioned}


def _categories(doc: EsgDocument) -> set[str]:
    return {a.asset_category for a in doc.asset_requirement.values()}


def _events(doc: EsgDocument) -> list[tuple[str, ...]]:
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    told = (n for n in nodes if n.event.value not in ("SceneStart", "Trigger"))
    return [(n.event.value, *n.participants) for n in told]


def _says(doc: EsgDocument) -> set[tuple[str, ...]]:
    """Statements by predicate and direction, object, target."""
    return {
        (s.predicate.value, *([s.direction] if s.direction else []), *s.object, *s.target)
        for s in doc.statements or ()
    }


def _lost(doc: EsgDocument) -> str:
    """All the words that the draft owns up to."""
    lost = (s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED)
    return " | ".join(s.text for s in lost)


@pytest.mark.parametrize(
    ("prompt", "way"),
    [
        ("A red sphere enters from the left and hits a cube.", "right"),
        ("A red sphere enters the scene from the right and hits a cube.", "left"),
        ("From the left edge of the screen a red sphere rolls in and hits a box.", "right"),
    ],
)
def test_what_enters_from_a_side_moves_to_the_other(prompt: str, way: str) -> None:
    doc = _drafted(prompt)
    assert ("moves", way, "red_sphere_1") in _says(doc)
    assert not _lost(doc)


@pytest.mark.parametrize(
    ("prompt", "says", "words"),
    [
        (
            "A metal sphere hits a blue cube and exits on the right.",
            ("moves", "right", "sphere_1"),
            "exits",
        ),
        (
            "A metal sphere hits a blue cube, which then exits the scene.",
            ("moves", "away_from", "blue_cube_1", "sphere_1"),
            "exits the scene",
        ),
        (
            "A metal sphere rolls out of the frame to the right.",
            ("moves", "right", "sphere_1"),
            "out of the frame",
        ),
    ],
)
def test_what_leaves_the_picture_has_its_way_and_stays_in_it(
    prompt: str, says: tuple[str, ...], words: str
) -> None:
    doc = _drafted(prompt)
    assert says in _says(doc)
    assert words in _lost(doc)
    assert "easel" not in _categories(doc)


def test_a_list_of_ones_is_no_more_things_than_it_counts() -> None:
    doc = _drafted(
        "There are three cubes: a red one, a blue one and a metal one. They stand there."
    )
    assert _nodes(doc) == {"red_cube_1", "blue_cube_1", "cube_1"}


def test_an_object_that_is_named_after_a_colon_is_one_thing() -> None:
    doc = _drafted("An object enters the scene: a green cylinder. It hits a red cube.")
    assert _nodes(doc) == {"green_cylinder_1", "red_cube_1"}
    assert _events(doc) == [("Collision", "green_cylinder_1", "red_cube_1")]


def test_what_slides_off_to_a_side_does_not_fall() -> None:
    doc = _drafted("A blue cube slides off to the right after being struck by a red cube.")
    assert [e[0] for e in _events(doc)] == ["Collision"]


@pytest.mark.parametrize(
    "prompt",
    [
        "The lead car stops, and the ego car rear-ends it.",
        "A van ahead slows down; the ego vehicle follows it and crashes into it.",
        "A truck is parked on the right shoulder; the ego vehicle swerves left to avoid it.",
        "The ego vehicle follows the lead vehicle at a distance of 20 m.",
    ],
)
def test_the_ego_vehicle_is_a_vehicle_of_its_own(prompt: str) -> None:
    doc = _drafted(prompt)
    egos = [i for i in _nodes(doc) if i.startswith("ego_")]
    moving = {e.actor for e in doc.timeline_system.sequence_graph.edges}  # type: ignore[union-attr]
    assert len(egos) == 1
    assert len(_nodes(doc)) == 2
    assert egos[0] in moving


@pytest.mark.parametrize(
    "prompt",
    [
        "A car drives in the right lane.",
        "A car changes to the left lane and brakes.",
        "A car in the left lane changes to the right lane in front of a truck.",
    ],
)
def test_a_lane_of_a_road_is_no_second_road(prompt: str) -> None:
    doc = _drafted(prompt)
    assert not any("lane" in i for i in doc.spatial_relation_graph.nodes)
    assert "lane" in _lost(doc) or "changes" in _lost(doc)


def test_a_bowling_ball_rolls_down_a_bowling_lane() -> None:
    assert "bowling_lane" in _categories(_drafted("A bowling ball rolls down the lane."))


def test_who_is_oncoming_drives_and_from_where_is_owned_up_to() -> None:
    doc = _drafted("A truck overtakes a tractor and collides with an oncoming motorcycle.")
    assert "oncoming" in _lost(doc)
    assert "motorcycle_1" in {e.actor for e in doc.timeline_system.sequence_graph.edges}  # type: ignore[union-attr]


@pytest.mark.parametrize("who", ["A child runs", "A boy comes", "A pedestrian steps"])
def test_who_comes_out_from_behind_a_thing_is_behind_it_first(who: str) -> None:
    doc = _drafted(f"{who} out from behind a van.")
    edges = doc.spatial_relation_graph.edges.binary_relations
    behind = [e for e in edges if e.relation_type.value == "behind" and e.to == "van_1"]
    assert len(behind) == 1
    assert ("moves", "away_from", behind[0].from_, "van_1") in _says(doc)


def test_who_stops_just_before_hitting_somebody_does_not_stop_him() -> None:
    doc = _drafted("A car stops just before hitting a child.")
    assert _events(doc) == [("Stop", "car_1")]
    assert ("never_touches", "car_1", "child_1") in _says(doc)


def test_behind_it_is_behind_the_vehicle_that_was_told_of() -> None:
    doc = _drafted("A bus pulls out from the kerb and a car behind it brakes.")
    edges = doc.spatial_relation_graph.edges.binary_relations
    assert ("car_1", "bus_1") in {(e.from_, e.to) for e in edges if e.relation_type == "behind"}


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A cat sits on the seat of a chair.", {"cat_1", "chair_1"}),
        ("A man stands on the deck of a ship.", {"man_1", "ship_1"}),
        ("A boy sits on the saddle of a bicycle.", {"boy_1", "bicycle_1"}),
        ("A toy car is parked on the roof of a dollhouse.", {"toy_car_1", "dollhouse_1"}),
        ("The chair's seat is hit by a ball.", {"chair_1", "ball_1"}),
    ],
)
def test_a_part_means_its_whole(prompt: str, things: set[str]) -> None:
    assert _nodes(_drafted(prompt)) == things


@pytest.mark.parametrize(
    "prompt",
    [
        "A grandfather clock's pendulum swings.",
        "The pendulum of a grandfather clock swings.",
        "A grandfather clock stands in a hall. Its pendulum swings.",
    ],
)
def test_the_pendulum_of_a_clock_is_the_clocks(prompt: str) -> None:
    doc = _drafted(prompt)
    assert {"clock_pendulum", "clock_case"} <= _categories(doc)
    assert _events(doc) == [("Swing", "pendulum_1")]


def test_a_swinging_pendulum_that_stands_still_is_owned_up_to() -> None:
    assert "swinging" in _lost(_drafted("A clock with a swinging pendulum."))


def test_who_lands_on_the_back_of_a_chair_does_not_topple() -> None:
    doc = _drafted("A bird lands on the back of a chair.")
    assert _events(doc) == [("Collision", "bird_1", "chair_1")]


def test_what_rolls_along_the_top_of_a_wall_is_on_it() -> None:
    doc = _drafted("A ball rolls along the top of a wall.")
    assert ("supported_by", "ball_1", "wall_1") in _says(doc)


def test_one_end_of_what_nothing_tips_is_owned_up_to() -> None:
    assert "one end" in _lost(_drafted("A boy sits on one end of a rope."))
    assert not _lost(_drafted("A mug stands on the edge of the table and falls off."))


@pytest.mark.parametrize(
    ("prompt", "hits", "flung"),
    [
        (
            "A plank lies across a log; a stone is dropped on one end and the other end flings a"
            " ball up.",
            ("Collision", "stone_1", "plank_1"),
            "ball_1",
        ),
        (
            "A board rests on a barrel. A brick falls onto one end and a ball on the other end"
            " flies into the air.",
            ("Collision", "brick_1", "board_1"),
            "ball_1",
        ),
        (
            "A stone falls on one end of a plank resting on a stump and flings a frog off the"
            " other end.",
            ("Collision", "stone_1", "plank_1"),
            "frog_1",
        ),
    ],
)
def test_a_plank_across_a_log_is_a_lever(prompt: str, hits: tuple[str, ...], flung: str) -> None:
    doc = _drafted(prompt)
    assert {"seesaw_board", "seesaw_stand"} <= _categories(doc)
    assert _events(doc) == [hits]
    assert ("moves", "up", flung) in _says(doc)
    assert {"log", "barrel", "stump"} & {*_lost(doc).split()}


def test_a_plank_on_a_log_of_which_no_end_is_told_stays_one() -> None:
    assert "seesaw_board" not in _categories(_drafted("A plank lies across a log."))


@pytest.mark.parametrize(
    ("prompt", "drawn", "by"),
    [
        ("A boy pulls a wagon with a teddy bear in it along a road.", "wagon_1", "boy_1"),
        ("A father pulls a child in a wagon through a park.", "wagon_1", "father_1"),
        ("A horse pulls a cart along a road.", "cart_1", "horse_1"),
    ],
)
def test_who_pulls_goes_ahead_and_the_wagon_follows(prompt: str, drawn: str, by: str) -> None:
    doc = _drafted(prompt)
    assert ("attached_to", drawn, by) in _says(doc)
    assert [e.actor for e in doc.timeline_system.sequence_graph.edges] == [by]  # type: ignore[union-attr]
    assert any(s[:3] == ("moves", "along", by) or s[:3] == ("moves", "across", by)
               for s in _says(doc))  # fmt: skip


def test_who_draws_a_carriage_goes_ahead_of_it() -> None:
    doc = _drafted("A pony draws a carriage.")
    assert ("attached_to", "carriage_1", "pony_1") in _says(doc)


def test_a_sled_that_is_let_go_is_on_no_line() -> None:
    doc = _drafted("A man pulls a sled up a hill, lets it go, and it hits a snowman.")
    assert ("attached_to", "sled_1", "man_1") not in _says(doc)


def test_of_two_that_pull_one_is_owned_up_to() -> None:
    assert "pull" in _lost(_drafted("Two oxen pull a wagon along a road."))


def test_what_is_removed_is_picked_up() -> None:
    doc = _drafted("Three blocks are stacked; the gripper removes the top one.")
    assert _events(doc) == [("PickedUp", "top_block_1")]


def test_a_drawer_that_is_opened_has_its_chest_though_something_is_put_in() -> None:
    doc = _drafted("The robot opens the drawer and puts the spoon in it.")
    assert [e[0] for e in _events(doc)] == ["Collision", "Open", "EnterRegion"]
    assert "drawer_chest" in _categories(doc)


def test_where_a_thing_is_moved_to_is_not_where_it_starts() -> None:
    doc = _drafted("Move the red block to the right of the green block.")
    assert not [
        e
        for e in doc.spatial_relation_graph.edges.binary_relations
        if e.relation_type == "right_of"
    ]
    assert ("right_of", "red_block_1", "green_block_1") in _says(doc)


def test_what_is_not_touched_on_the_way_is_missed_by_no_launch() -> None:
    doc = _drafted("Pick up the orange and place it on the plate without touching the banana.")
    assert [e[0] for e in _events(doc)] == ["PickedUp", "Placed"]
    assert ("never_touches", "orange_1", "banana_1") in _says(doc)


@pytest.mark.parametrize(
    "words", ["with nobody in it", "without anyone on it", "with no one aboard"]
)
def test_nobody_is_absent(words: str) -> None:
    doc = _drafted(f"A cart {words} rolls down a ramp.")
    nobody = [s for s in doc.statements or () if s.predicate is Predicate.ABSENT]
    assert [(s.noun, s.text) for s in nobody] == [("person", words)]
    assert not doc.coverage.warnings


def test_nobody_on_a_thing_denies_nobody_else() -> None:
    doc = _drafted("A man pushes a cart with nobody in it.")
    assert not [s for s in doc.statements or () if s.predicate is Predicate.ABSENT]


def test_no_others_are_drawn_nor_missed() -> None:
    assert not _lost(_drafted("A car drives along a road with no other cars."))


def test_what_is_turned_upside_down_does_not_turn() -> None:
    doc = _drafted("A cup turned upside down is hit by a marble.")
    assert _events(doc) == [("Collision", "marble_1", "cup_1")]
    assert "upside down" in _lost(doc)


def test_a_sloped_ground_is_owned_up_to() -> None:
    assert "sloped" in _lost(_drafted("A car rolls down a sloped parking lot and hits a van."))


def test_the_bigger_of_two_is_larger() -> None:
    doc = _drafted("Two balls roll. The bigger one hits the smaller one.")
    sizes = {
        i: doc.asset_requirement[n.asset_id].expected_dimensions_cm[0]
        for i, n in doc.spatial_relation_graph.nodes.items()
        if n.mentioned
    }
    (_, big, small) = _events(doc)[0]
    assert sizes[big] > sizes[small]
