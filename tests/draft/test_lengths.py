"""Final positions, starts, and times that a prompt tells late or in another sentence."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, NodeEvent, TimelineNode


def points(doc: EsgDocument, event: NodeEvent) -> list[TimelineNode]:
    assert doc.timeline_system is not None
    return [n for n in doc.timeline_system.sequence_graph.nodes if n.event is event]


def constraint(node: TimelineNode, quantity: str) -> tuple[object, str | None, str | None]:
    found = next(c for c in node.constraints if c.quantity == quantity)
    return found.value, found.since, found.to


@pytest.mark.parametrize(
    ("prompt", "gap_cm", "other"),
    [
        ("A bus at 15 m/s stops 1 m in front of a barrier.", 100.0, "barrier_1"),
        ("A cart brakes and comes to rest 2 m from a wall.", 200.0, "wall_1"),
        ("A van drives toward a gate and stops 50 cm short of it.", 50.0, "gate_1"),
        ("A taxi stops 2 metres behind a parked bus.", 200.0, "bus_1"),
        ("A robot stops one metre away from the shelf.", 100.0, "shelf_1"),
    ],
)
def test_a_stop_keeps_the_stated_gap(prompt: str, gap_cm: float, other: str) -> None:
    doc = draft(prompt)
    (stop,) = points(doc, NodeEvent.STOP)
    assert constraint(stop, "distance") == (gap_cm, None, other)
    assert not [w for w in doc.coverage.warnings if "quantity" in w]
    assert not verify(doc)


def test_a_painted_line_is_no_surface_to_measure_from() -> None:
    doc = draft("A car stops 2 m in front of the crossing.")
    assert not points(doc, NodeEvent.STOP)[0].constraints
    assert any("2 m" in w for w in doc.coverage.warnings)


def test_where_and_how_fast_a_motion_starts() -> None:
    doc = draft("A cart starts 5 m from a door at 2 m/s and hits it.")
    near = [r for r in doc.spatial_relation_graph.edges.binary_relations if r.distance_cm]
    assert [(r.from_, r.to, r.distance_cm) for r in near] == [("cart_1", "door_1", 500.0)]
    assert doc.timeline_system is not None
    (edge,) = doc.timeline_system.sequence_graph.edges
    assert (edge.params.speed, edge.speed_is_prescribed) == (200.0, True)


def test_nothing_that_happens_takes_no_time() -> None:
    doc = draft("A van hits a rack. Nothing happens, but after two seconds a box falls down.")
    assert not points(doc, NodeEvent.COLLISION)[0].time_is_prescribed
    last = [n for n in doc.timeline_system.sequence_graph.nodes if "box_1" in n.participants]  # type: ignore[union-attr]
    assert constraint(last[-1], "time_since")[0] == 2.0


def test_a_time_between_and_and_a_new_subject_belongs_to_the_new_clause() -> None:
    doc = draft("A car hits a wall and after 3 seconds a van hits the car.")
    first, second = points(doc, NodeEvent.COLLISION)
    assert not first.time_is_prescribed
    assert constraint(second, "time_since") == (3.0, first.id, None)


def test_driving_on_after_a_turn_is_timed_from_its_end() -> None:
    doc = draft("A truck turns left, drives straight on for 4 seconds and hits a gate.")
    turned, hit = points(doc, NodeEvent.HEADING_REACHED)[0], points(doc, NodeEvent.COLLISION)[0]
    assert constraint(hit, "time_since") == (4.0, turned.id, None)


def test_skidding_is_how_it_brakes() -> None:
    doc = draft("A car brakes at 12 m/s, skids for 3 seconds and hits a guardrail.")
    hit = points(doc, NodeEvent.COLLISION)[0]
    assert constraint(hit, "time_since") == (3.0, "car_1_brake", None)


def test_walking_for_six_seconds_ends_in_the_stop() -> None:
    doc = draft("A pedestrian walks at 5 km/h for 6 seconds and then stops.")
    (stop,) = points(doc, NodeEvent.STOP)
    assert (stop.timestamp, stop.time_is_prescribed) == (6.0, True)


def test_the_time_of_being_stopped_is_not_the_gap_to_what_stops_it() -> None:
    doc = draft("A can rolls and is stopped by a foot after 4 s.")
    (stop,) = points(doc, NodeEvent.STOP)
    assert stop.time_is_prescribed and stop.timestamp == 4.0


def test_braking_from_one_speed_to_another() -> None:
    doc = draft("A bus brakes from 15 m/s to 5 m/s, then turns left.")
    slowed = [n for n in points(doc, NodeEvent.TRIGGER) if n.constraints]
    assert constraint(slowed[0], "speed_after")[0] == 500.0


def test_no_faster_than_leaves_all_slower_speeds() -> None:
    doc = draft("A bus going no faster than 10 m/s hits a signpost.")
    assert doc.timeline_system is not None
    low, high = doc.timeline_system.sequence_graph.edges[0].params.speed  # type: ignore[misc]
    assert high == 1000.0 and low <= 50.0


@pytest.mark.parametrize("seed", [0, 1])
def test_what_it_stops_in_front_of_is_placed_that_far_past_its_way(seed: int) -> None:
    from esg.assets import resolve
    from esg.dynamics import start_hints

    doc = resolve(draft("A bus at 15 m/s stops 1 m in front of a barrier."), seed=seed)
    (found,) = start_hints(doc, seed=seed).constellations
    assert {p.node for p in found.placements} >= {"bus_1", "barrier_1"}


def test_the_judge_measures_the_gap_to_the_named_thing() -> None:
    from esg.metrics import expectations_from_timeline

    scene = expectations_from_timeline(draft("A bus stops 1 m in front of a barrier."))
    (gap,) = [c for c in scene.constraints if c.quantity == "distance"]
    assert (gap.value, gap.target, gap.event) == (1.0, "=barrier_1", "bus_1_stop")


@pytest.mark.parametrize(
    ("prompt", "event", "quantity"),
    [
        ("A chandelier falls from the ceiling onto a table after 2 s.", NodeEvent.COLLISION, 2.0),
        ("A cup falls off a shelf into a bucket after 1 s.", NodeEvent.ENTER_REGION, 1.0),
    ],
)
def test_a_time_after_the_landing_is_the_landings(
    prompt: str, event: NodeEvent, quantity: float
) -> None:
    doc = draft(prompt)
    (landing,) = points(doc, event)
    assert (landing.timestamp, landing.time_is_prescribed) == (quantity, True)
    assert not points(doc, NodeEvent.FALL)[0].time_is_prescribed
    assert not verify(doc)


def test_how_long_it_falls_is_the_time_of_the_hit() -> None:
    doc = draft("A stone falls for 0.6 s before hitting a bucket.")
    hit = points(doc, NodeEvent.COLLISION)[0]
    assert (hit.timestamp, hit.time_is_prescribed) == (0.6, True)
    assert not points(doc, NodeEvent.FALL), "it falls onto the bucket and leaves no support"


def test_how_long_it_falls_off_something_is_counted_from_the_fall() -> None:
    doc = draft("A vase falls off a shelf, drops for 0.6 s and hits a bucket.")
    hit, fall = points(doc, NodeEvent.COLLISION)[0], points(doc, NodeEvent.FALL)[0]
    assert constraint(hit, "time_since") == (0.6, fall.id, None)


def test_what_happens_between_two_timed_events_fits_in_between() -> None:
    doc = draft("A ball hits a cup. The cup falls off a shelf into a bucket after 1 s.")
    assert len(points(doc, NodeEvent.ENTER_REGION)[0].constraints) == 1
    assert not verify(doc)


def test_the_time_to_get_there_is_the_time_of_the_hit() -> None:
    doc = draft("A ball needs 1.5 s to get to a cone and hits it.")
    assert points(doc, NodeEvent.COLLISION)[0].timestamp == 1.5


def test_what_is_let_hit_something_is_what_was_set_in_motion() -> None:
    doc = draft("Give the car a speed of 10 m/s and let it crash into a wall.")
    assert points(doc, NodeEvent.COLLISION)[0].participants == ("car_1", "wall_1")
    assert doc.timeline_system is not None
    assert doc.timeline_system.sequence_graph.edges[0].params.speed == 1000.0
