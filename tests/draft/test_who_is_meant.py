"""Who is meant, what is denied, what is only asked, and what comes after its cause."""

from __future__ import annotations

import pytest

from esg.commands.draft import _at_the_start
from esg.draft import draft
from esg.graph.models import EdgeEvent, EsgDocument, Predicate
from tests.draft.told import drawn, events, owned, stated


def size_of(doc: EsgDocument, node: str) -> tuple[float, float, float]:
    asset = doc.spatial_relation_graph.nodes[node].asset_id
    return doc.asset_requirement[asset].expected_dimensions_cm


@pytest.mark.parametrize(
    ("prompt", "who", "number"),
    [
        ("A rubber ball and a steel cube lie on a table; the rubber one falls off.",
         "rubber_ball", 3),
        ("A glass bottle and a plastic bottle stand on a shelf. The glass one falls off.",
         "glass_bottle", 3),
        ("A bowling ball and a tennis ball lie on a table, and the heavy one falls off.",
         "bowling_ball", 3),
        ("A cube and a sphere lie on a table. The round one falls off.", "sphere", 3),
        ("A large ball and a small cube lie on a table. The big one falls off.", "ball", 3),
        ("A ball and a crate lie on a table. The larger one falls off.", "crate", 3),
    ],
)  # fmt: skip
def test_one_with_an_attribute_is_what_is_there(prompt: str, who: str, number: int) -> None:
    doc = draft(prompt)
    assert ("Fall", f"{who}_1") in events(prompt)
    assert len(drawn(doc)) == number


def test_the_other_is_the_one_of_two_not_told_of() -> None:
    doc = draft(
        "A cube and a sphere lie on a table. The round one falls off, the other stays where it is."
    )
    (still,) = stated(doc, Predicate.STAYS_STILL)
    assert still.object == ("cube_1",) and drawn(doc) == {"cube_1", "sphere_1", "table_1"}


def test_what_a_comparative_picks_among_equals_differs() -> None:
    doc = draft("Two crates stand on a shelf. The smaller one falls off.")
    assert size_of(doc, "crate_1") < size_of(doc, "crate_2")
    assert events("Two crates stand on a shelf. The smaller one falls off.") == [
        ("Fall", "crate_1")
    ]


@pytest.mark.parametrize(
    ("prompt", "hit"),
    [
        ("A robot arm sets a red block on a blue block and then pushes both of them.",
         {"red_block_1", "blue_block_1"}),
        ("A robot arm picks up a cup from the table, puts it on a tray and pushes both.",
         {"cup_1", "tray_1"}),
    ],
)  # fmt: skip
def test_both_are_what_was_acted_on(prompt: str, hit: set[str]) -> None:
    told = events(prompt)
    assert {e[2] for e in told if e[:2] == ("Collision", "robot_arm_1")} == hit


@pytest.mark.parametrize(
    ("prompt", "fallen", "never"),
    [
        ("A dog pushes a bucket off a bench, which falls and hits a cat.", "bucket_1", "bench_1"),
        ("A boy knocks a vase off a shelf, which lands on a rug.", "vase_1", "shelf_1"),
        ("A cup slides off a table, which falls on the floor.", "cup_1", "table_1"),
    ],
)
def test_which_falls_is_what_left_not_what_carried_it(prompt: str, fallen: str, never: str) -> None:
    told = events(prompt)
    assert ("Fall", fallen) in told and not any(never in e for e in told)
    assert not owned(draft(prompt))


def test_a_bridge_that_collapses_does() -> None:
    told = events("A truck drives off a bridge, which collapses.")
    assert told == [("Fall", "truck_1"), ("Topple", "bridge_1")]


@pytest.mark.parametrize(
    "prompt",
    [
        "The green cube is stationary until the orange ball, which comes in later, hits it.",
        "The green cube is at rest until an orange ball that rolls in from afar strikes it.",
    ],
)
def test_what_is_still_until_it_is_hit_is_hit(prompt: str) -> None:
    assert ("Collision", "orange_ball_1", "green_cube_1") in events(prompt)
    doc = draft(prompt)
    assert doc.timeline_system is not None
    assert not any(e.actor == "green_cube_1" for e in doc.timeline_system.sequence_graph.edges)


def test_it_is_what_was_hit_past_a_relative_clause() -> None:
    told = events("When the ball, which is red, hits the can, it falls over.")
    assert told == [("Collision", "ball_1", "can_1"), ("Topple", "can_1")]


@pytest.mark.parametrize(
    "prompt",
    [
        "A hammer falls on a plank, making a nut jump.",
        "An apple drops onto a scale, causing a pointer to move.",
        "A trolley hits a rack so that a nut rolls away.",
    ],
)
def test_what_is_caused_waits_for_its_cause(prompt: str) -> None:
    doc = draft(prompt)
    (still,) = stated(doc, Predicate.STAYS_STILL)
    who = still.object[0]
    assert who in ("nut_1", "pointer_1") and still.when.endswith("collision")
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    first = next(e for e in edges if e.actor == who)
    assert first.event is EdgeEvent.UNIFORM_MOTION and first.params.speed == 0.0


def test_what_is_caused_to_fall_falls_after_its_cause() -> None:
    prompt = "A ball hits a window, causing a vase to fall off the shelf."
    doc = draft(prompt)
    (still,) = stated(doc, Predicate.STAYS_STILL)
    assert still.object == ("vase_1",) and still.when.endswith("ball_1_window_1_collision")
    assert ("Fall", "vase_1") in events(prompt)


@pytest.mark.parametrize(
    ("prompt", "who", "others"),
    [
        ("A ball rolls between two cones and touches neither.", "ball_1", {"cone_1", "cone_2"}),
        ("A drone flies past three poles, touching none of them.", "drone_1",
         {"pole_1", "pole_2", "pole_3"}),
        ("A car drives through the two cones without touching any of them.", "car_1",
         {"cone_1", "cone_2"}),
        ("A robot moves between a chair and a table without bumping into either.", "robot_1",
         {"chair_1", "table_1"}),
        ("A cart rolls past a cup and hits nothing.", "cart_1", {"cup_1"}),
        ("A ball hits neither the cup nor the vase.", "ball_1", {"cup_1", "vase_1"}),
        ("A cart bumps into none of the two barrels.", "cart_1", {"barrel_1", "barrel_2"}),
        ("A red ball hits a blue ball, but not the green ball.", "red_ball_1",
         {"green_ball_1"}),
    ],
)  # fmt: skip
def test_a_contact_with_none_is_measured_and_never_made(
    prompt: str, who: str, others: set[str]
) -> None:
    doc = draft(prompt)
    told = events(prompt)
    assert not any(e[0] == "Collision" and {*e[2:]} & others for e in told)
    missed = {e[2] for e in told if e[:2] == ("Miss", who)}
    untouched = {
        i for s in stated(doc, Predicate.NEVER_TOUCHES) if s.object == (who,) for i in s.target
    }
    assert missed | untouched == others


def test_nothing_else_leaves_out_what_is_hit() -> None:
    doc = draft("A vase and a pin stand there. A ball hits the pin and touches nothing else.")
    (said,) = stated(doc, Predicate.NEVER_TOUCHES)
    assert said.object == ("ball_1",) and said.target == ("vase_1",)


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("A skater weaves between two cones and knocks over none.", ("cone_1", "cone_2")),
        ("None of the two pins falls.", ("pin_1", "pin_2")),
        ("A vase is bumped by a ball but stays upright.", ("vase_1",)),
    ],
)
def test_what_does_not_fall_stays_upright(prompt: str, who: tuple[str, ...]) -> None:
    (said,) = stated(draft(prompt), Predicate.STAYS_UPRIGHT)
    assert said.object == who and not any(e[0] == "Topple" for e in events(prompt))


@pytest.mark.parametrize(
    ("prompt", "told", "things"),
    [
        ("Which object is hit by the red cube? The red cube slides into a green ball.",
         [("Collision", "red_cube_1", "green_ball_1")], {"red_cube_1", "green_ball_1"}),
        ("Does the ball hit the wall? It rolls past a cone and then bounces off the wall.",
         [("Miss", "ball_1", "cone_1"), ("Collision", "ball_1", "wall_1")],
         {"ball_1", "wall_1", "cone_1"}),
        ("What does the robot push? It drives toward a crate and pushes it into a wall.",
         [("Collision", "robot_1", "crate_1"), ("Collision", "crate_1", "wall_1")],
         {"robot_1", "crate_1", "wall_1"}),
    ],
)  # fmt: skip
def test_what_is_asked_and_answered_is_not_drafted(
    prompt: str, told: list[tuple[str, ...]], things: set[str]
) -> None:
    assert events(prompt) == told
    doc = draft(prompt)
    assert drawn(doc) == things and not owned(doc)


def test_what_is_asked_and_not_answered_is_owned_up_to_in_one_line() -> None:
    doc = draft("A ball is dropped onto a trampoline. How high does it bounce?")
    assert owned(doc) == ["How high does it bounce?"]
    assert drawn(doc) == {"ball_1", "trampoline_1"}


@pytest.mark.parametrize(
    "prompt",
    ["Can a ball hit a box?", "What happens when a ball hits a box?"],
)
def test_a_question_alone_asks_for_its_scene(prompt: str) -> None:
    assert events(prompt) == [("Collision", "ball_1", "box_1")]
    assert not draft(prompt).coverage.warnings


@pytest.mark.parametrize(
    "prompt",
    [
        "Eight dominoes in a line bending to the right; the first is pushed.",
        "A row of dominoes curving around a mug falls.",
    ],
)
def test_a_line_that_bends_does_not_move(prompt: str) -> None:
    doc = draft(prompt)
    assert not any(e[0] == "HeadingReached" for e in events(prompt))
    assert any(words.startswith(("bending", "curving")) for words in owned(doc))


def test_a_part_and_its_verb_are_no_playground_slides() -> None:
    doc = draft("The ladder's top slides along the wall.")
    assert drawn(doc) == {"ladder_1", "wall_1"}
    assert stated(doc, Predicate.SLIDES)[0].object == ("ladder_1",)


def test_a_bare_name_and_its_verb_are_no_compound() -> None:
    told = events("The ego vehicle follows a van. The van brakes, and ego stops just behind it.")
    assert ("Stop", "ego_vehicle_1") in told


def test_the_ladder_of_a_worker_is_not_the_worker() -> None:
    told = events("The worker's ladder slips and hits the wall.")
    assert told == [("Collision", "ladder_1", "wall_1")]


def test_what_left_a_shelf_meets_the_ground() -> None:
    told = events("A jar falls off a shelf and shatters on the tile floor, its lid rolling away.")
    assert told[0] == ("Fall", "jar_1") and not any("shelf_1" in e for e in told)
    assert events("A plate slides off a bench and cracks on the concrete.") == [("Fall", "plate_1")]


def test_who_comes_is_none_of_those_parked() -> None:
    doc = draft("A child runs between two parked cars; an approaching car brakes.")
    assert {"car_1", "car_2", "car_3"} <= drawn(doc)
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    assert {e.actor for e in edges} == {"car_3", "child_1"}


def test_how_often_is_owned_up_to() -> None:
    assert owned(draft("A goat butts a gate four times.")) == ["four times"]
    assert not owned(draft("A ball bounces three times on the floor."))


@pytest.mark.parametrize(
    "prompt",
    [
        "Three balls lie on a table and only one falls off.",
        "A skateboard starts rolling by itself and hits a bin.",
        "Two cubes collide and move apart in opposite directions.",
        "Five bottles stand in a row, none of them broken.",
        "The first box is heavier than the second box. A ball hits the heavier one.",
        "A ball hits a piano, no people anywhere.",
    ],
)
def test_what_is_held_is_not_owned_up_to(prompt: str) -> None:
    doc = draft(prompt)
    assert not owned(doc) and not doc.coverage.warnings


def test_left_at_a_place_is_no_direction() -> None:
    doc = draft("A bike left in the road is hit by a car.")
    assert events("A bike left in the road is hit by a car.") == [("Collision", "car_1", "bike_1")]
    assert not stated(doc, Predicate.MOVES)


def test_the_listing_tells_supports_sizes_and_headings() -> None:
    lines = [*_at_the_start(draft("A cup stands on a big box. A car drives to the right."))]
    assert "support:   cup_1 on box_1" in lines and "heading:   car_1 right" in lines
    assert any(line.startswith("size:      box_1 ") for line in lines)
