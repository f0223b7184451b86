"""Noun phrases and what they bind to, scene by scene."""

from __future__ import annotations

from dataclasses import replace
import math

from hypothesis import given, settings
from hypothesis import strategies as st
import pytest

from esg.engines.scene import Body, Region, SimScene
from esg.metrics import bind
from esg.metrics.phrases import parse
from esg.units import quat_from_euler_deg
from tests.metrics.worlds import ball, body


def thing(name: str, label: str = "", category: str = "", **more: object) -> Body:
    made = body(name, label=label, **more)
    return replace(made, category=category or made.category)


def at(item: Body, x: float, y: float = 0.0, yaw_deg: float = 0.0) -> Body:
    turn = tuple(quat_from_euler_deg(yaw_deg).tolist())
    return replace(item, position=(x, y, item.position[2]), quaternion=turn)


def scene(*bodies: Body, regions: tuple[Region, ...] = ()) -> SimScene:
    return SimScene("test", bodies, regions)


def pocket(name: str, x: float, y: float) -> Region:
    return Region(f"billiard_table_1/{name}", "billiard_table_1", (x, y, 0.4), (0.1,) * 3, "pocket")


POOL = scene(
    thing("billiard_table_1", "billiard table", static=True),
    ball("cue_ball_1", 0.03, label="cue ball", category="cue ball", color=(0.95, 0.95, 0.95)),
    ball("black_ball_1", 0.03, label="black ball", category="billiard ball", color=(0.05,) * 3),
    ball(
        "billiard_ball_1", 0.03, category="billiard ball", color=(0.8, 0.1, 0.1), group="billiards"
    ),
    ball(
        "billiard_ball_2", 0.03, category="billiard ball", color=(0.1, 0.2, 0.8), group="billiards"
    ),
    regions=(
        pocket("bottom pocket", 0.0, 0.6),
        pocket("bottom left pocket", 1.2, 0.6),
        pocket("top pocket", 0.0, -0.6),
        pocket("top right pocket", -1.2, -0.6),
    ),
)
STREET = scene(
    thing("road_1", "road", static=True, shapes=()),
    thing("car_1", "front car", "car", color=(0.7, 0.1, 0.1)),
    thing("car_2", "rear car", "car", color=(0.1, 0.1, 0.7)),
    thing("jeep_1", "jeep", "car"),
    thing("trash_bin_1", "trashbin", "trash bin"),
    thing("bicycle_1", "bicycle"),
    thing("picnic_table_1", "picnic table"),
    thing("bench_1", "", "bench", mentioned=False),
)
PLAIN_CARS = scene(
    at(thing("car_1", "", "car"), 0.0, yaw_deg=90.0), at(thing("car_2", "", "car"), 0.0, 6.0, 90.0)
)
BALLS = scene(
    ball("ball_1", label="ball A"), ball("ball_2", label="ball B"), ball("ball_3", label="ball C")
)
WAGONS = scene(
    thing("second_wagon_1", "second wagon", "cart"),
    thing("wagon_1", "freight wagon", "cart"),
    thing("wagon_2", "freight wagon", "cart"),
)
TRAINS = scene(
    thing("wagon_1", "first wagon", "cart"),
    thing("wagon_2", "first wagon", "cart"),
    thing("wagon_3", "freight wagon", "cart"),
    thing("wagon_4", "freight wagon", "cart"),
)
KINDS = scene(
    thing("hatchback_1", "900 kg hatchback", "car"),
    thing("sedan_1", "1500 kg sedan", "car"),
    thing("mug_1", "", "cup"),
    thing("cup_1", "", "cup"),
)
PLAIN_BALLS = scene(*(ball(f"ball_{k}") for k in (1, 2, 3)))
ALLEY = scene(
    ball("bowling_ball_1", label="bowling ball", category="bowling ball"),
    *(thing(f"bowling_pin_{k}", "", "bowling pin", group="bowling pins") for k in range(1, 11)),
    thing("lane_1", "", "bowling lane", static=True, shapes=(), mentioned=False),
)
OFFICE = scene(
    ball("soccer_ball_1", label="soccer ball", category="soccer ball"),
    thing("office_desk_1", "tidy office desk", "desk", static=True),
    thing("laptop_1", "", "laptop", mentioned=False),
    thing("crate_1", "", "wooden crate"),
    thing("crate_2", "", "wooden crate"),
    thing("crate_3", "", "wooden crate"),
)
GOAL = scene(
    ball("football_1", label="football", category="soccer ball"),
    thing("goal_1", "goal", "soccer goal", static=True),
    thing("cardboard_box_1", "cardboard box", "box"),
    thing("wall_1", "brick wall", "wall", static=True),
    regions=(
        Region("goal_1/goal mouth", "goal_1", (0, 0, 1), (0.5, 1.5, 1), "goal"),
        Region("cardboard_box_1/inside", "cardboard_box_1", (0, 0, 0), (0.2, 0.2, 0.2), "inside"),
    ),
)

TABLE = [
    # Head noun, articles, case, spelling.
    (STREET, "jeep", ["jeep_1"]),
    (STREET, "the Jeep", ["jeep_1"]),
    (STREET, "SUV", ["jeep_1"]),
    (STREET, "trashbin", ["trash_bin_1"]),
    (STREET, "trash can", ["trash_bin_1"]),
    (STREET, "trash-can", ["trash_bin_1"]),
    (STREET, "garbage bin", ["trash_bin_1"]),
    (STREET, "dustbin", ["trash_bin_1"]),
    (STREET, "rubbish bin", ["trash_bin_1"]),
    (STREET, "bin", ["trash_bin_1"]),
    (STREET, "bike", ["bicycle_1"]),
    (STREET, "a bicycle stopped in the middle of the road", ["bicycle_1"]),
    (STREET, "picnic table", ["picnic_table_1"]),
    (STREET, "picnic_table", ["picnic_table_1"]),
    (STREET, "table", ["picnic_table_1"]),
    (STREET, "bench", ["bench_1"]),
    (STREET, "road", ["road_1", "ground"]),
    (STREET, "ground", ["ground"]),
    # Positions from labels; a jeep is no car while there are cars.
    (STREET, "front car", ["car_1"]),
    (STREET, "leading car", ["car_1"]),
    (STREET, "rear car", ["car_2"]),
    (STREET, "the car behind", ["car_2"]),
    (STREET, "the car in front", ["car_1"]),
    (STREET, "car in front of the bench", ["car_1", "car_2"]),
    (STREET, "cars", ["car_1", "car_2"]),
    (STREET, "two cars", ["car_1", "car_2"]),
    (STREET, "both cars", ["car_1", "car_2"]),
    (STREET, "vehicles", ["car_1", "car_2", "jeep_1", "bicycle_1"]),
    (STREET, "motorcycle", []),
    (STREET, "truck", []),
    (STREET, "fire hydrant", []),
    (STREET, "coffee table", []),
    # Positions from geometry: heading +Y, so the larger y is in front.
    (PLAIN_CARS, "front car", ["car_2"]),
    (PLAIN_CARS, "rear car", ["car_1"]),
    (PLAIN_CARS, "first car", ["car_1"]),
    (PLAIN_CARS, "second car", ["car_2"]),
    (PLAIN_CARS, "automobile", ["car_1", "car_2"]),
    # Letters, numbers, ordinals.
    (BALLS, "ball A", ["ball_1"]),
    (BALLS, "Ball b", ["ball_2"]),
    (BALLS, "ball-C", ["ball_3"]),
    (BALLS, "ball D", []),
    (BALLS, "three balls", ["ball_1", "ball_2", "ball_3"]),
    (BALLS, "sphere A", ["ball_1"]),
    (PLAIN_BALLS, "ball A", ["ball_1"]),
    (PLAIN_BALLS, "ball C", ["ball_3"]),
    (PLAIN_BALLS, "ball D", []),
    (PLAIN_BALLS, "ball 2", ["ball_2"]),
    (PLAIN_BALLS, "Ball #3", ["ball_3"]),
    (PLAIN_BALLS, "last ball", ["ball_3"]),
    (PLAIN_BALLS, "fourth ball", []),
    (WAGONS, "first wagon", ["wagon_1"]),
    (WAGONS, "second wagon", ["second_wagon_1"]),
    (WAGONS, "third wagon", ["wagon_2"]),
    (WAGONS, "fourth wagon", []),
    (TRAINS, "second wagon", ["wagon_3"]),
    (TRAINS, "third wagon", ["wagon_4"]),
    # Two kinds with one head: each is what it is called, "automobile" is either.
    (KINDS, "sedan", ["sedan_1"]),
    (KINDS, "the hatchback", ["hatchback_1"]),
    (KINDS, "mug", ["mug_1"]),
    (KINDS, "cars", ["hatchback_1", "sedan_1"]),
    (KINDS, "automobile", ["hatchback_1", "sedan_1"]),
    (OFFICE, "second crate", ["crate_2"]),
    (OFFICE, "3rd crate", ["crate_3"]),
    (OFFICE, "wooden crates", ["crate_1", "crate_2", "crate_3"]),
    (OFFICE, "crate number two", ["crate_2"]),
    # Class modifiers: another kind of ball is another thing.
    (OFFICE, "soccer ball", ["soccer_ball_1"]),
    (OFFICE, "football", ["soccer_ball_1"]),
    (OFFICE, "ball", ["soccer_ball_1"]),
    (OFFICE, "bowling ball", []),
    (OFFICE, "basketball", []),
    (OFFICE, "desk", ["office_desk_1"]),
    (OFFICE, "tidy office desk", ["office_desk_1"]),
    (OFFICE, "work desk", ["office_desk_1"]),
    (OFFICE, "table", ["office_desk_1"]),
    (OFFICE, "laptop", ["laptop_1"]),
    (ALLEY, "bowling ball", ["bowling_ball_1"]),
    (ALLEY, "bowling pins", [f"bowling_pin_{k}" for k in range(1, 11)]),
    (ALLEY, "a set of bowling pins", [f"bowling_pin_{k}" for k in range(1, 11)]),
    (ALLEY, "pins", [f"bowling_pin_{k}" for k in range(1, 11)]),
    (ALLEY, "one of the pins", [f"bowling_pin_{k}" for k in range(1, 11)]),
    (ALLEY, "skittles", [f"bowling_pin_{k}" for k in range(1, 11)]),
    (ALLEY, "first pin", ["bowling_pin_1"]),
    # Colours and billiard names.
    (POOL, "cue ball", ["cue_ball_1"]),
    (POOL, "white ball", ["cue_ball_1"]),
    (POOL, "black ball", ["black_ball_1"]),
    (POOL, "eight ball", ["black_ball_1"]),
    (POOL, "8-ball", ["black_ball_1"]),
    (POOL, "red ball", ["billiard_ball_1"]),
    (POOL, "blue billiard ball", ["billiard_ball_2"]),
    (POOL, "green ball", []),
    (POOL, "pool table", ["billiard_table_1"]),
    (POOL, "billiard table", ["billiard_table_1"]),
    (GOAL, "football", ["football_1"]),
    (GOAL, "soccer ball", ["football_1"]),
    (GOAL, "brick wall", ["wall_1"]),
    # Exact references.
    (BALLS, "=ball_2", ["ball_2"]),
    (BALLS, "=ball_1,ball_3", ["ball_1", "ball_3"]),
    (BALLS, "=ball_9", []),
    # Nothing to bind.
    (BALLS, "", []),
    (BALLS, "!!!", []),
]


@pytest.mark.parametrize(
    ("where", "phrase", "expected"), TABLE, ids=[f"{i}-{row[1]}" for i, row in enumerate(TABLE)]
)
def test_phrase(where, phrase, expected):
    found = bind(phrase, where)
    assert list(found.names(where)) == expected
    assert bool(found.problem) == (not expected)


TARGETS = [
    (POOL, "bottom pocket", ["billiard_table_1/bottom pocket"]),
    (POOL, "the bottom left pocket", ["billiard_table_1/bottom left pocket"]),
    (POOL, "top pocket", ["billiard_table_1/top pocket"]),
    (POOL, "lower pocket", [f"billiard_table_1/bottom {n}" for n in ("pocket", "left pocket")]),
    (
        POOL,
        "pocket",
        [f"billiard_table_1/{n}" for n in
         ("bottom pocket", "bottom left pocket", "top pocket", "top right pocket")],
    ),
    (POOL, "=billiard_table_1/top pocket", ["billiard_table_1/top pocket"]),
    (GOAL, "goal", ["goal_1/goal mouth"]),
    (GOAL, "box", ["cardboard_box_1"]),
    (GOAL, "cardboard box", ["cardboard_box_1"]),
    (GOAL, "hole", []),
    (GOAL, "@1,2,0.5", ["@1,2,0.5"]),
    (GOAL, "@1,2", []),
]  # fmt: skip


def test_plurals_that_end_in_is():
    taxis = scene(thing("front_taxi_1", "front taxi"), at(thing("rear_taxi_1", "rear taxi"), 9.0))
    assert list(bind("taxis", taxis).names(taxis)) == ["front_taxi_1", "rear_taxi_1"]


@pytest.mark.parametrize(("where", "phrase", "expected"), TARGETS, ids=[r[1] for r in TARGETS])
def test_target(where, phrase, expected):
    assert list(bind(phrase, where, target=True).names(where)) == expected


def test_pockets_without_words_are_chosen_by_place():
    numbered = replace(
        POOL,
        regions=(
            pocket("pocket 1", 1.0, 0.6),
            pocket("pocket 2", -1.0, 0.6),
            pocket("pocket 3", 1.0, -0.6),
        ),
    )
    found = bind("bottom pocket", numbered, target=True)
    assert found.names(numbered) == ("billiard_table_1/pocket 1", "billiard_table_1/pocket 2")
    left = bind("left pocket", numbered, target=True)
    assert left.names(numbered) == ("billiard_table_1/pocket 1", "billiard_table_1/pocket 3")


def test_a_stated_number_must_be_there():
    found = bind("four balls", BALLS)
    assert len(found.bodies) == 3
    assert "asks for 4" in found.problem
    alone = scene(thing("car_1", "car"))
    assert "asks for 2" in bind("cars", alone).problem
    assert not bind("stairs", scene(thing("stairs_1", "staircase"))).problem


def test_objects_of_the_prompt_win_over_added_ones():
    where = scene(thing("car_1", "", "car", mentioned=False), thing("car_2", "", "car"))
    assert bind("car", where).names(where) == ("car_2",)


def test_plain_phrase_prefers_the_plain_object():
    where = scene(thing("car_1", "car"), thing("car_2", "parked red car", "car"))
    assert bind("car", where).names(where) == ("car_1",)


def test_cars_that_face_each_other_take_the_viewers_front():
    where = scene(
        at(thing("car_1", "", "car"), 0.0, -5.0, 90.0),
        at(thing("car_2", "", "car"), 0.0, 5.0, -90.0),
    )
    assert bind("front car", where).names(where) == ("car_2",)


def test_colour_of_a_single_object_may_be_untold():
    where = scene(thing("car_1", "car"))
    assert bind("black car", where).names(where) == ("car_1",)
    red = scene(thing("car_1", "red car"))
    assert not bind("black car", red).bound


@settings(max_examples=200, deadline=None)
@given(st.text(max_size=40))
def test_no_text_raises(text):
    for where in (POOL, STREET, SimScene("empty", ())):
        found = bind(text, where, target=True)
        assert found.bound or found.problem
    assert math.isfinite(len(parse(text).head))


@pytest.mark.parametrize(
    ("phrase", "names"),
    [
        ("tire stack", ["tire_1", "tire_2"]),
        ("the old brick pile", ["brick_1", "brick_2"]),
        ("water tower", ["water_tower_1"]),
        ("red stack", []),
        ("bottle rack", []),
    ],
)
def test_a_collective_behind_what_it_is_made_of_means_its_members(
    phrase: str, names: list[str]
) -> None:
    yard = scene(
        *(thing(f"{n}_{k}", n, n) for n in ("tire", "brick", "bottle") for k in (1, 2)),
        thing("water_tower_1", "water tower"),
    )
    found = bind(phrase, yard)
    assert sorted(found.names(yard)) == names
    assert bool(found.problem) == (not names)


@pytest.mark.parametrize(
    ("phrase", "names"),
    [
        ("ice", ("slab_1",)),
        ("bread", ("loaf_1",)),
        ("pile", ("box_1", "box_2")),
        ("pile of boxes", ("box_1", "box_2")),
        ("lawn", ("ground",)),
    ],
)
def test_stuff_and_piles_go_by_their_own_name(phrase: str, names: tuple[str, ...]) -> None:
    piled = [thing(f"box_{k}", "pile of boxes", "box", group="boxes") for k in (1, 2)]
    told = scene(thing("slab_1", "sheet of ice"), thing("loaf_1", "loaf of bread"), *piled)
    assert bind(phrase, told).names(told) == names


def test_named_ground_is_that_and_no_piece_of_it() -> None:
    told = scene(thing("rink_1", "ice", "ice rink"), thing("slab_1", "sheet of ice"))
    assert bind("ice", told).names(told) == ("rink_1",)


def test_a_stack_of_one_is_no_stack() -> None:
    assert bind("tire stack", scene(thing("tire_1", "tire", "tire"))).problem


def bottles() -> SimScene:
    """Three bottles of rising height and mass from left to right, and a car that drives."""
    sizes = [(0.05, 0.05, h) for h in (0.1, 0.2, 0.3)]
    made = [
        at(thing(f"bottle_{k + 1}", mass=0.5 * (k + 1), half_extents=size), x=-1.0 * k, y=0.3 * k)
        for k, size in enumerate(sizes)
    ]
    return scene(*made, at(thing("car_1", active=True), x=-4.0))


@pytest.mark.parametrize(
    ("phrase", "names"),
    [
        ("the tallest bottle", ("bottle_3",)),
        ("the shortest bottle", ("bottle_1",)),
        ("the lighter bottle", ("bottle_1",)),
        ("the heaviest bottle", ("bottle_3",)),
        ("the two heavier bottles", ("bottle_2", "bottle_3")),
        ("the left bottle", ("bottle_1",)),
        ("the nearest bottle", ("bottle_3",)),
        ("the farthest bottle", ("bottle_1",)),
        ("the smallest bottle", ("bottle_1",)),
        ("the narrowest bottle", ()),
    ],
)
def test_comparisons_go_by_what_is_simulated(phrase, names):
    found = bind(phrase, bottles())
    assert found.names(bottles()) == names
    assert bool(found.problem) is not bool(names)


def test_without_a_mover_the_nearest_is_the_one_before_the_viewer():
    lone = SimScene("test", bottles().bodies[:3])
    assert bind("the nearest bottle", lone).names(lone) == ("bottle_3",)
    assert bind("the farthest bottle", lone).names(lone) == ("bottle_1",)


def test_a_name_does_not_make_a_thing_the_heavier_one():
    pair = scene(
        thing("ball_1", label="heavier ball", mass=1.0), thing("ball_2", label="ball", mass=3.0)
    )
    assert bind("the heavier ball", pair).names(pair) == ("ball_2",)
    alone = scene(thing("ball_1", label="ball"))
    assert bind("the heavier ball", alone).names(alone) == ("ball_1",)
