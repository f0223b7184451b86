"""Times between events, waits, ratios of speed, parts of things, and names without nouns."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, TimelineNode


def clean(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert verify(doc) == ()
    return doc


def points(doc: EsgDocument) -> list[TimelineNode]:
    assert doc.timeline_system is not None
    return list(doc.timeline_system.sequence_graph.nodes)


def story(doc: EsgDocument) -> list[str]:
    skip = ("SceneStart", "Trigger")
    return [
        f"{n.event.value} {' '.join(n.participants)}" for n in points(doc) if n.event not in skip
    ]


def constraint(doc: EsgDocument, quantity: str) -> Any:
    return next(c.value for n in points(doc) for c in n.constraints if c.quantity == quantity)


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A dog's tail knocks a cup off a desk.", ["Collision dog_1 cup_1", "Fall cup_1"]),
        ("A scooter hits the open door of a parked van.", ["Collision scooter_1 van_1"]),
        ("A robot hits two jars and both fall over.", None),
        ("The white ball hits the black, and the black drops into the side pocket.", None),
        ("Ball A hits ball B; B hits C.", ["Collision ball_a ball_b", "Collision ball_b ball_c"]),
        ("A barrel rolls off the end of a table.", ["Fall barrel_1"]),
        ("A jar slides along a shelf and falls off the end.", ["Fall jar_1"]),
        ("A stone thrown by a boy hits a sign.", ["Collision stone_1 sign_1"]),
        ("A truck doesn't stop and hits a gate.", ["Collision truck_1 gate_1"]),
        ("A basketball bounces off the hoop and goes in.", None),
        ("A wall is hit by a truck and falls on a car.", None),
        ("A goose lands on a fence.", ["Collision goose_1 fence_1"]),
        ("A player shoots a puck toward the goalie, who stops it.", None),
        ("A child jumps over a log.", ["Jump child_1 log_1"]),
        ("A stone thrown over a fence lands on a bench.", ["Collision stone_1 bench_1"]),
        ("A car skids through a fence and hits a tree.", None),
        ("A pallet tips off a forklift.", ["Fall pallet_1"]),
        ("A van drives over the edge of a pier.", ["Fall van_1"]),
        ("The impact of the hammer on the jar knocks it over.", None),
    ],
)
def test_events(prompt: str, expected: list[str] | None) -> None:
    """The events of a sentence, in order of time."""
    found = story(clean(prompt))
    if expected is None:
        expected = _LONG[prompt]
    assert found == expected


_LONG = {
    "A robot hits two jars and both fall over.": [
        "Collision robot_1 jar_1",
        "Topple jar_1",
        "Collision robot_1 jar_2",
        "Topple jar_2",
    ],
    "The white ball hits the black, and the black drops into the side pocket.": [
        "Collision white_ball_1 black_ball_1",
        "EnterRegion black_ball_1",
    ],
    "A basketball bounces off the hoop and goes in.": [
        "Collision basketball_1 hoop_1",
        "EnterRegion basketball_1",
    ],
    "A wall is hit by a truck and falls on a car.": [
        "Collision truck_1 wall_1",
        "Topple wall_1",
        "Collision wall_1 car_1",
    ],
    "A player shoots a puck toward the goalie, who stops it.": ["Collision puck_1 goalie_1"],
    "A car skids through a fence and hits a tree.": [
        "Collision car_1 fence_1",
        "Break fence_1",
        "Collision car_1 tree_1",
    ],
    "The impact of the hammer on the jar knocks it over.": [
        "Collision hammer_1 jar_1",
        "Topple jar_1",
    ],
}


def test_time_to_stop_with_it_takes() -> None:
    """Read "it takes the bus 6 s to come to a halt" of the bus."""
    doc = clean("It takes the bus 6 s to come to a halt after the driver hits the brakes.")
    assert story(doc) == ["Stop bus_1"]
    assert constraint(doc, "time_to_stop") == 6.0


def test_time_before_a_nominal_collision() -> None:
    """Read "1 s before the collision with a cow" as the time from braking to the hit."""
    doc = clean("A car brakes 1 s before the collision with a cow.")
    assert story(doc) == ["Collision car_1 cow_1"]
    assert constraint(doc, "time_since") == 1.0


def test_late_time_before_a_parenthesis() -> None:
    """Give "two seconds later" to the main verb, not to the participle between commas."""
    doc = clean("Two seconds later the puck, sliding at 5 m/s, hits the goal post.")
    hit = points(doc)[-1]
    assert hit.event.value == "Collision" and hit.timestamp == 2.0 and hit.time_is_prescribed


def test_waiting_is_standing_still() -> None:
    """Start a drive after the stated wait, at the start and after a stop."""
    doc = clean("A van waits for 2 s, then drives off at 6 m/s and hits a cone.")
    start = next(n for n in points(doc) if n.event.value == "Trigger")
    assert start.timestamp == 2.0 and start.time_is_prescribed
    assert doc.timeline_system is not None
    speeds = [e.params.speed for e in doc.timeline_system.sequence_graph.edges]
    assert speeds == [0.0, 600.0]
    later = clean("A bus drives at 8 m/s, stops for 3 s, then drives on and hits a cone.")
    assert constraint(later, "time_since") == 3.0


@pytest.mark.parametrize(
    ("words", "speed", "stated"),
    [
        ("twice as fast as", 2000.0, True),
        ("half as fast as", 500.0, True),
        ("as fast as", 1000.0, True),
        ("three times faster than", 3000.0, True),
        ("faster than", (1050.0, 2000.0), False),
        ("slower than", (400.0, 950.0), False),
    ],
)
def test_speed_compared(words: str, speed: Any, stated: bool) -> None:
    """Prescribe stated ratios; leave an interval for "faster" alone."""
    doc = clean(f"A red car drives {words} a blue car, which drives at 10 m/s.")
    assert doc.timeline_system is not None
    edge = next(e for e in doc.timeline_system.sequence_graph.edges if e.actor == "red_car_1")
    assert edge.params.speed == pytest.approx(speed)
    assert edge.speed_is_prescribed is stated


def test_speed_left_after_braking() -> None:
    """Read the speed of a hit after braking as the speed before that hit."""
    doc = clean("A car at 20 m/s brakes and hits a wall at 6 m/s.")
    assert constraint(doc, "speed_before") == 600.0


def test_start_heights_without_the_word() -> None:
    """Take "falls 2 m" and "hovers 3 m above the ground" as heights at the start."""
    assert constraint(clean("A brick falls 2 m onto a bucket."), "height") == 200.0
    doc = clean("A drone hovering 3 m above the ground drops a parcel on a car.")
    assert constraint(doc, "height") == 300.0


def test_sizes_in_a_list() -> None:
    """Give every size of a list to its noun."""
    doc = clean("A crate of 40 kg, 1 m wide, hits a marble, 2 cm in diameter.")
    assets = doc.asset_requirement
    nodes = doc.spatial_relation_graph.nodes
    assert assets[nodes["crate_1"].asset_id].expected_dimensions_cm[1] == 100.0
    assert assets[nodes["marble_1"].asset_id].expected_dimensions_cm == (2.0, 2.0, 2.0)


def test_ordinals_make_their_kind() -> None:
    """Let "the second" be another one of what "the first runner" named."""
    doc = clean("The first runner falls, the second runs into the hurdle.")
    assert {"first_runner_1", "second_runner_1"} <= doc.spatial_relation_graph.nodes.keys()


def test_it_is_what_the_sentence_before_was_about() -> None:
    """Prefer the lone subject of the sentence before to a noun in its phrases."""
    found = story(clean("A log rolls off a truck. A car hits it."))
    assert found == ["Fall log_1", "Collision car_1 log_1"]


@pytest.mark.parametrize(
    ("prompt", "times"),
    [
        ("A ball hits a box after 1 s and a puck hits a barrel after 2 seconds.", [1.0, 2.0]),
        ("A ball hits a box after 2 s and a puck hits a barrel after 1 second.", [2.0, 1.0]),
        ("A car hits a wall after 2 seconds. A truck hits a bus after 3 seconds.", [2.0, 3.0]),
        ("A ball hits a box after 1 s and then a puck hits a barrel after 2 s.", [1.0, None]),
        ("A ball hits a box after 1 s, and after 2 s a puck hits a barrel.", [1.0, None]),
        ("A ball hits a box after 1 s and a puck hits a barrel 2 s later.", [1.0, None]),
        ("A ball hits a box after 1 s and the box hits a barrel after 2 s.", [1.0, None]),
    ],
)
def test_what_happens_on_its_own_is_timed_from_the_start(
    prompt: str, times: list[float | None]
) -> None:
    """Two stories side by side share the start; what goes on counts from the event before."""
    hits = [n for n in points(clean(prompt)) if n.event == "Collision"]
    assert [n.timestamp if n.time_is_prescribed else None for n in hits] == times
    since = [c.value for n in hits for c in n.constraints if c.quantity == "time_since"]
    assert since == ([2.0] if None in times else [])


@pytest.mark.parametrize(
    "prompt",
    [
        "A car turns left, brakes and hits a cone after 3 s.",
        "A truck follows a car. The car brakes and the truck hits the car after 1 s.",
    ],
)
def test_a_time_of_the_hit_is_none_of_the_brake(prompt: str) -> None:
    brake = next(n for n in points(clean(prompt)) if n.id.endswith("_brake"))
    assert not brake.time_is_prescribed
