"""Numbers that name individuals, and times of every form."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, TimelineNode


def drafted(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert not verify(doc)
    return doc


def nodes(doc: EsgDocument, kind: NodeEvent) -> list[TimelineNode]:
    assert doc.timeline_system is not None
    return [n for n in doc.timeline_system.sequence_graph.nodes if n.event is kind]


def only(prompt: str, kind: NodeEvent = NodeEvent.COLLISION) -> TimelineNode:
    (node,) = nodes(drafted(prompt), kind)
    return node


@pytest.mark.parametrize(
    ("prompt", "pair"),
    [
        ("Ball 1 rams ball 2.", ("ball_1", "ball_2")),
        ("Box1 slides into Box2.", ("box_1", "box_2")),
        ("Car no. 7 hits car no. 3.", ("car_7", "car_3")),
        ("Car number 12 rams car number 5.", ("car_12", "car_5")),
        ("The No. 4 bus hits a wall.", ("bus_4", "wall_1")),
        ("Crate #3 slides into crate #1.", ("crate_3", "crate_1")),
        ("Robot R1 drives into robot R2.", ("robot_r1", "robot_r2")),
        ("Drone D1 flies at 3 m/s and rams drone D2.", ("drone_d1", "drone_d2")),
        ("Forklift F1 starts, then rams pallet P2.", ("forklift_f1", "pallet_p2")),
    ],
)
def test_a_number_or_code_after_a_noun_is_a_name(prompt: str, pair: tuple[str, str]) -> None:
    assert only(prompt).participants == pair


def test_a_code_alone_is_one_like_those_named_before() -> None:
    doc = drafted("Robot R1 rams crate C3. R2 then brakes and stops.")
    assert {"robot_r1", "crate_c3", "robot_r2"} <= set(doc.spatial_relation_graph.nodes)
    (stop,) = nodes(doc, NodeEvent.STOP)
    assert stop.participants == ("robot_r2",)


def test_a_number_before_a_plural_still_counts() -> None:
    doc = drafted("On the table 5 cups stand, and a ball hits 2 cans.")
    names = set(doc.spatial_relation_graph.nodes)
    assert {"cup_5", "can_2"} <= names
    assert "cup_6" not in names


TOGETHER = [
    "Ball A hits a cone and, at the same time, ball B hits a bin.",
    "At the very same moment a car hits a tree and a bus hits a pole.",
    "A rock hits a window. Simultaneously, a car hits a tree.",
    "Two balls hit the wall at the same instant.",
    "A red ball hits a box at the same time as a blue ball hits a bin.",
]


@pytest.mark.parametrize("prompt", TOGETHER)
def test_simultaneous_events_share_a_window_and_are_no_time_apart(prompt: str) -> None:
    first, second = nodes(drafted(prompt), NodeEvent.COLLISION)
    (apart,) = second.constraints
    assert (apart.quantity, apart.value, apart.since) == ("time_since", 0.0, first.id)
    assert first.window == second.window


def test_the_next_story_of_a_sentence_stays_one_after_the_other() -> None:
    _, second = nodes(drafted("Ball A hits a cone and ball B hits a bin."), NodeEvent.COLLISION)
    assert second.constraints == ()


@pytest.mark.parametrize(
    ("prompt", "kind", "value"),
    [
        ("A ball hits a cone. A second ball hits a bin with a delay of 2 s.",
         NodeEvent.COLLISION, 2.0),
        ("A ball hits a cone. After a pause of 3 s it hits a bin.", NodeEvent.COLLISION, 3.0),
    ],
)  # fmt: skip
def test_events_of_a_clause_lie_a_stated_time_apart(
    prompt: str, kind: NodeEvent, value: float
) -> None:
    first, second = nodes(drafted(prompt), kind)
    (apart,) = second.constraints
    assert (apart.quantity, apart.value, apart.since) == ("time_since", value, first.id)


@pytest.mark.parametrize(
    ("when", "low", "high"),
    [
        ("not before 2 s and not after 3 s", 2.0, 3.0),
        ("after 2 s but before 4 s", 2.0, 4.0),
        ("no earlier than 2 s but no later than 3 s", 2.0, 3.0),
        ("by the 3-second mark", 0.15, 3.0),
        ("before 3 s have passed", 0.15, 3.0),
        ("2 s after it starts rolling", 2.0, 2.0),
    ],
)
def test_bounds_of_a_time(when: str, low: float, high: float) -> None:
    node = only(f"A ball hits a cone {when}.")
    assert node.time_is_prescribed
    assert node.window == (low, high) if low < high else node.timestamp == low


def test_a_stop_at_a_time_is_counted_from_the_start() -> None:
    stop = only("A car brakes at 3 s and stops at 5 s.", NodeEvent.STOP)
    assert (stop.timestamp, stop.constraints) == (5.0, ())
    late = only("A car brakes at 1 s and stops by 5 s.", NodeEvent.STOP)
    assert late.window is not None and late.window[1] == 5.0


@pytest.mark.parametrize("how_long", ["over 3 s", "over a period of 3 s", "for 3 s"])
def test_braking_lasts_as_long_as_the_prompt_says(how_long: str) -> None:
    doc = drafted(f"A truck brakes {how_long} and stops.")
    (stop,) = nodes(doc, NodeEvent.STOP)
    (lasts,) = stop.constraints
    assert (lasts.quantity, lasts.value) == ("time_since", 3.0)
    assert lasts.since == nodes(doc, NodeEvent.TRIGGER)[0].id


@pytest.mark.parametrize(
    "prompt",
    [
        "A car waits at a kerb. After 3 s it drives off and hits a bin.",
        "After 3 s a truck starts moving and hits a wall.",
        "A robot starts at 3 s, drives on and hits a box.",
        "A bus stands at a stop. After 3 s it sets off and hits a bicycle.",
    ],
)
def test_who_sets_off_late_stands_still_until_then(prompt: str) -> None:
    doc = drafted(prompt)
    trigger, hit = nodes(doc, NodeEvent.TRIGGER)[0], nodes(doc, NodeEvent.COLLISION)[0]
    assert trigger.timestamp == 3.0
    assert hit.window is not None and hit.window[0] > 3.0
    assert doc.timeline_system is not None
    stands = doc.timeline_system.sequence_graph.edges[0]
    assert (stands.event, stands.params.speed, stands.to) == (
        EdgeEvent.UNIFORM_MOTION, 0.0, trigger.id,
    )  # fmt: skip


def test_driving_into_something_after_a_time_is_the_time_of_the_hit() -> None:
    assert only("After 3 s a car drives into a wall.").timestamp == 3.0


def test_a_wait_ends_the_drive_before_it() -> None:
    doc = drafted("A car drives for 4 s, waits for 2 s and then hits a bin.")
    arrives, goes_on = nodes(doc, NodeEvent.TRIGGER)
    assert arrives.timestamp == 4.0
    assert [(c.quantity, c.value, c.since) for c in goes_on.constraints] == [
        ("time_since", 2.0, arrives.id)
    ]


def test_what_recurs_is_no_time_of_an_event() -> None:
    node = only("Every two seconds a ball is thrown at a wall.")
    assert not node.time_is_prescribed
