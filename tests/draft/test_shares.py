"""Lists of quantities, things told apart by quantities, and speeds of what is hit."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument
from esg.outcomes import UserError


def _masses(doc: EsgDocument) -> list[float]:
    return [r.expected_mass_kg for r in doc.asset_requirement.values() if r.mass_is_prescribed]


def _events(prompt: str) -> list[tuple[str, ...]]:
    timeline = draft(prompt).timeline_system
    assert timeline is not None
    return [
        (n.event.value, *n.participants)
        for n in timeline.sequence_graph.nodes
        if n.event.value in ("Collision", "Fall", "Topple", "EnterRegion")
    ]


def _speeds(prompt: str) -> dict[str, object]:
    timeline = draft(prompt).timeline_system
    assert timeline is not None
    return {
        e.actor: e.params.speed
        for e in timeline.sequence_graph.edges
        if e.speed_is_prescribed and e.params is not None
    }


@pytest.mark.parametrize(
    "prompt",
    [
        "Three balls of 1 kg, 2 kg and 3 kg roll into a wall.",
        "Three balls with masses of 1 kg, 2 kg and 3 kg roll into a wall.",
        "Three balls with masses 1, 2 and 3 kg roll into a wall.",
        "Three balls of different masses (1 kg, 2 kg and 3 kg) are lined up; a cart hits the first.",
        "Three balls weighing 1 kg, 2 kg and 3 kg stand on a shelf. The heaviest falls.",
        "Balls of 1 kg, 2 kg and 3 kg stand in a row; a cart hits the first.",
        "Balls A, B and C weigh 1 kg, 2 kg and 3 kg. Ball A rolls into ball B.",
        "A red, a blue and a green ball weigh 1 kg, 2 kg and 3 kg. The red one hits the blue one.",
    ],
)
def test_a_list_of_masses_is_dealt_out(prompt: str) -> None:
    assert _masses(draft(prompt)) == [1.0, 2.0, 3.0]


def test_a_list_for_one_thing_is_a_contradiction() -> None:
    with pytest.raises(UserError, match="contradicts itself"):
        draft("A ball weighs 10 kg and 5 kg and rolls into a wall.")


def test_another_ball_of_its_own_mass_is_no_member_of_the_row() -> None:
    doc = draft("Three balls of 1 kg, 2 kg and 3 kg are lined up; a 4 kg ball hits the first.")
    assert _masses(doc) == [1.0, 2.0, 3.0, 4.0]


@pytest.mark.parametrize(
    ("prompt", "speeds"),
    [
        ("Three balls roll at 1, 2 and 3 m/s toward a wall.", [100.0, 200.0, 300.0]),
        ("Two cars drive toward each other at 5 m/s and 10 m/s and collide.", [500.0, 1000.0]),
        ("A 2 kg ball at 3 m/s and a 1 kg ball at 5 m/s collide.", [300.0, 500.0]),
        ("A car at 10 m/s collides head-on with a truck at 15 m/s.", [1000.0, 1500.0]),
        ("A car at 20 m/s rear-ends a truck at 10 m/s.", [2000.0, 1000.0]),
        ("A ball with a speed of 3 m/s hits a ball with a speed of 1 m/s.", [300.0, 100.0]),
        ("Two cars of 1 t and 2 t crash head-on at 10 m/s each.", [1000.0, 1000.0]),
        ("Two spheres collide; the first at 2 m/s, the second at rest.", [200.0]),
        ("A ball hits a cart at 5 m/s.", [500.0]),
    ],
)
def test_everything_has_its_own_speed(prompt: str, speeds: list[float]) -> None:
    assert list(_speeds(prompt).values()) == speeds


@pytest.mark.parametrize(
    ("prompt", "event"),
    [
        (
            "Three crates of 5 kg, 10 kg and 15 kg stand on a shelf. The heaviest falls.",
            ("Fall", "crate_3"),
        ),
        (
            "Three bottles, 20 cm, 25 cm and 30 cm tall, stand on a table; a ball hits the tallest.",
            ("Collision", "ball_1", "bottle_3"),
        ),
        (
            "Two balls roll toward a wall at 2 m/s and 4 m/s. The faster one hits it.",
            ("Collision", "ball_2", "wall_1"),
        ),
        (
            "A 5 kg ball and a 2 kg ball lie on a table. The 2 kg ball hits the 5 kg one.",
            ("Collision", "ball_2", "ball_1"),
        ),
        (
            "Two balls of 5 kg and 2 kg lie on a table. The lighter hits the heavier.",
            ("Collision", "ball_2", "ball_1"),
        ),
        (
            "The heavier of two crates (5 kg and 20 kg) slides into a wall.",
            ("Collision", "crate_2", "wall_1"),
        ),
        (
            "A big crate and a small crate stand in a row. A ball hits the bigger one.",
            ("Collision", "ball_1", "crate_1"),
        ),
        (
            "A tall bottle and a short bottle stand on a table. A ball hits the shorter one.",
            ("Collision", "ball_1", "bottle_2"),
        ),
    ],
)
def test_things_are_told_apart_by_what_they_measure(prompt: str, event: tuple[str, ...]) -> None:
    assert _events(prompt) == [event]


@pytest.mark.parametrize(
    "apposition", [", red and blue,", ", one red and one blue,", " (one red, one blue)"]
)
def test_colours_beside_a_plural_name_its_members(apposition: str) -> None:
    assert _events(f"Two balls{apposition} collide.") == [
        ("Collision", "red_ball_1", "blue_ball_1")
    ]


def test_a_block_with_a_letter_is_no_verb() -> None:
    prompt = "Block A of mass 2 kg slides at 3 m/s into block B of mass 5 kg."
    assert _events(prompt) == [("Collision", "block_a", "block_b")]
    assert _masses(draft(prompt)) == [2.0, 5.0]


@pytest.mark.parametrize(
    ("prompt", "sizes"),
    [
        ("A glass 15 cm tall and 7 cm wide stands on a table.", {"glass_1": (None, 7.0, 15.0)}),
        (
            "Ball A (mass 2 kg, radius 10 cm) hits ball B (mass 1 kg, radius 8 cm).",
            {"ball_a": (20.0, 20.0, 20.0), "ball_b": (16.0, 16.0, 16.0)},
        ),
        (
            "The first domino, 10 cm tall, hits the second, 12 cm tall.",
            {"domino_1": (None, None, 10.0), "domino_2": (None, None, 12.0)},
        ),
        ("A sphere (r = 0.1 m) rolls into a wall.", {"sphere_1": (20.0, 20.0, 20.0)}),
    ],
)
def test_sizes_reach_their_things(prompt: str, sizes: dict[str, tuple[float | None, ...]]) -> None:
    doc = draft(prompt)
    nodes = doc.spatial_relation_graph.nodes
    for name, size in sizes.items():
        node = next(n for i, n in nodes.items() if i.startswith(name))
        got = doc.asset_requirement[node.asset_id].expected_dimensions_cm
        assert all(x is None or x == y for x, y in zip(size, got, strict=True))


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball with m = 2 kg and v = 3 m/s hits a box with m = 5 kg.",
        "A ball (m=2 kg, v_0=3 m/s) hits a box (m = 5 kg, v = 0).",
    ],
)
def test_symbols_are_quantities(prompt: str) -> None:
    assert _masses(draft(prompt)) == [2.0, 5.0]
    assert _speeds(prompt) == {"ball_1": 300.0}


@pytest.mark.parametrize(
    "slope", ["a slope of 20 degrees", "a ramp inclined at 20°", "a 20 degree ramp"]
)
def test_ramps_are_as_steep_as_stated(slope: str) -> None:
    doc = draft(f"A barrel rolls down {slope} and hits a tree.")
    ramp = next(r for r in doc.asset_requirement.values() if r.asset_category == "ramp")
    length, _, height = ramp.expected_dimensions_cm
    assert height / length == pytest.approx(0.364, abs=1e-3)


def test_a_turn_lasts_as_long_as_stated() -> None:
    timeline = draft(
        "A robot drives forward for 2 s, turns right by 90 degrees in 1 s and drives into a box."
    ).timeline_system
    assert timeline is not None
    nodes = {n.event.value: n for n in timeline.sequence_graph.nodes}
    assert nodes["Trigger"].timestamp == 2.0
    since = nodes["HeadingReached"].constraints
    assert [(c.quantity, c.value) for c in since if c.quantity == "time_since"] == [
        ("time_since", 1.0)
    ]


def test_another_two_seconds_are_no_other_car() -> None:
    prompt = (
        "The van waits for 3 seconds, then it accelerates and after another 2 s it hits a fence."
    )
    assert _events(prompt) == [("Collision", "van_1", "fence_1")]


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball hits the second of four bottles, which are 25 cm apart.",
        "A ball hits one of four bottles spaced 25 cm apart.",
        "Four bottles spaced 25 cm apart stand on a table; a ball hits the first.",
    ],
)
def test_a_spacing_is_that_of_the_whole_row(prompt: str) -> None:
    relations = draft(prompt).spatial_relation_graph.edges.binary_relations
    near = [r for r in relations if r.distance_cm == 25.0]
    assert len(near) == 3
    assert all("bottle" in r.from_ and "bottle" in r.to for r in near)


def test_who_starts_late_drives_at_a_speed_afterwards() -> None:
    prompt = "The first car starts at 0 s, the second at 1 s; they both hit the same wall."
    timeline = draft(prompt).timeline_system
    assert timeline is not None
    last = {e.actor: e.params.speed for e in timeline.sequence_graph.edges if e.params}
    assert last["second_car_1"] == last["first_car_1"] != 0.0


def test_a_clause_goes_on_after_its_participle() -> None:
    prompt = "A crate slides off a truck when the truck, going 10 m/s, brakes within 2 s."
    timeline = draft(prompt).timeline_system
    assert timeline is not None
    brakes = [e.actor for e in timeline.sequence_graph.edges if e.params and e.params.damping]
    assert brakes == ["truck_1"]


def test_another_one_is_a_thing_and_what_follows_a_verb() -> None:
    prompt = "A domino 5 cm in front of another one tips over and hits it."
    assert _events(prompt) == [("Topple", "domino_1"), ("Collision", "domino_1", "domino_2")]


def test_what_is_launched_late_rests_until_then() -> None:
    timeline = draft("At t = 1 s a ball starts rolling; at t = 3 s it hits a cube.").timeline_system
    assert timeline is not None
    times = [(n.event.value, n.timestamp) for n in timeline.sequence_graph.nodes[1:]]
    assert times == [("Trigger", 1.0), ("Collision", 3.0)]
    speeds = [e.params.speed for e in timeline.sequence_graph.edges if e.params]
    assert speeds[0] == 0.0
    assert speeds[1] != 0.0


@pytest.mark.parametrize(
    ("prompt", "events"),
    [
        (
            "A skier passes three gates and hits the fourth.",
            [("Collision", "skier_1", "fourth_gate_1")],
        ),
        ("A wagon bumps the next wagon.", [("Collision", "wagon_1", "wagon_2")]),
        (
            "The first of three boxes hits the next box.",
            [("Collision", "first_box_1", "box_2")],
        ),
    ],
)
def test_one_more_of_a_row(prompt: str, events: list[tuple[str, ...]]) -> None:
    assert _events(prompt) == events


@pytest.mark.parametrize(
    ("prompt", "event"),
    [
        ("The ball goes into the right side of the goal.", ("EnterRegion", "ball_1")),
        ("A car crashes into the left side of a van.", ("Collision", "car_1", "van_1")),
    ],
)
def test_a_side_is_part_of_what_it_is_the_side_of(prompt: str, event: tuple[str, ...]) -> None:
    assert _events(prompt) == [event]
