"""Streets lie under their traffic, and what belongs to the roadside stands beyond the kerb."""

from __future__ import annotations

import math

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import cast
from esg.graph import effective
from esg.graph.models import BinaryRelation, EsgDocument
from esg.layout import solve, stored_hints
from esg.layout.judge.check import distance_range
from esg.layout.problem import terms
from esg.layout.problem.edges import Term
from esg.layout.problem.supports import shape_of
from tests.layout import builders as b

SIGHT_CM = 1000.0


def laid(prompt: str, *, traffic: str | None = None) -> EsgDocument:
    doc = resolve(draft(prompt))
    scene = doc.scene_definition.model_copy(update={"traffic": traffic})
    doc = cast(doc.model_copy(update={"scene_definition": scene}))
    hints = stored_hints(doc.choreography) if doc.choreography is not None else None
    return effective(solve(doc, hints=hints))


def on_street(doc: EsgDocument, road: str, name: str) -> tuple[float, float, float, float]:
    """Along and across a street [cm], heading off it [deg], half the extent across it [cm]."""
    assert doc.layout_result is not None
    r, p = doc.layout_result.poses[road], doc.layout_result.poses[name]
    yaw = math.radians(r.yaw_deg)
    dx, dy = (p.position_cm[k] - r.position_cm[k] for k in (0, 1))
    off = math.remainder(math.radians(p.yaw_deg) - yaw, 2 * math.pi)
    length, width, _ = doc.asset_configurations[
        doc.spatial_relation_graph.nodes[name].asset_id
    ].dimensions_cm
    reach = 0.5 * (length * abs(math.sin(off)) + width * abs(math.cos(off)))
    along = math.cos(yaw) * dx + math.sin(yaw) * dy
    return along, math.cos(yaw) * dy - math.sin(yaw) * dx, math.degrees(off), reach


def half_width(doc: EsgDocument, road: str) -> float:
    key = doc.spatial_relation_graph.nodes[road].asset_id
    return 0.5 * doc.asset_configurations[key].dimensions_cm[1]


def in_its_lane(doc: EsgDocument, road: str, name: str, keeps: float = -1.0) -> bool:
    _, across, off, _ = on_street(doc, road, name)
    way = 1.0 if abs(off) < 90.0 else -1.0
    # its middle is, and its body does not cross the axis by more than a turned corner
    return 60.0 < keeps * way * across < half_width(doc, road) - 60.0


@pytest.mark.parametrize(
    ("prompt", "road", "driver", "thing"),
    [
        ("A truck drives down the street and hits a table at the side of the road.",
         "street_1", "truck_1", "table_1"),
        ("A car hits a mailbox on the sidewalk.", "road_1", "car_1", "mailbox_1"),
        ("A van crashes into a lamp post.", "road_1", "van_1", "lamp_post_1"),
        ("A car hits a trash can on the street side, and the trash can knocks over a table.",
         "road_1", "car_1", "trash_can_1"),
    ],
)  # fmt: skip
def test_what_is_hit_at_the_roadside_stands_beyond_the_kerb(
    prompt: str, road: str, driver: str, thing: str
) -> None:
    """The driver starts in its lane, and the thing is off the carriageway."""
    doc = laid(prompt)
    _, across, _, reach = on_street(doc, road, thing)
    assert in_its_lane(doc, road, driver)
    assert abs(across) - reach > half_width(doc, road)
    assert (
        abs(on_street(doc, road, driver)[2]) < 30.0 or abs(on_street(doc, road, driver)[2]) > 150.0
    )


def test_what_is_on_the_road_is_hit_in_the_carriageway() -> None:
    doc = laid("A car hits a bench on the road.")
    _, across, _, _ = on_street(doc, "road_1", "bench_1")
    assert abs(across) < half_width(doc, "road_1")
    assert abs(on_street(doc, "road_1", "car_1")[2]) < 5.0


@pytest.mark.parametrize(("traffic", "keeps"), [(None, -1.0), ("right", -1.0), ("left", 1.0)])
def test_traffic_keeps_its_side(traffic: str | None, keeps: float) -> None:
    doc = laid("A car drives along the road.", traffic=traffic)
    assert in_its_lane(doc, "road_1", "car_1", keeps)
    assert abs(on_street(doc, "road_1", "car_1")[2]) < 1.0


def test_oncoming_cars_start_in_a_lane_each() -> None:
    doc = laid("Two cars drive towards each other on a road and collide.")
    assert in_its_lane(doc, "road_1", "car_1")
    assert in_its_lane(doc, "road_1", "car_2")


def test_parked_vehicles_stand_along_the_kerb() -> None:
    doc = laid("A red car drives down the road past a parked van.")
    _, across, off, reach = on_street(doc, "road_1", "van_1")
    assert across < 0.0  # right-hand traffic parks at the right
    assert 0.0 < abs(across) - reach - half_width(doc, "road_1") < 100.0
    assert abs(math.remainder(off, 180.0)) < 1.0


def test_what_is_passed_at_the_kerb_is_beside_the_lane() -> None:
    doc = laid("A car drives past a bus stop.")
    _, across, _, reach = on_street(doc, "road_1", "bus_stop_1")
    assert across < 0.0
    assert abs(across) - reach > half_width(doc, "road_1")
    assert in_its_lane(doc, "road_1", "car_1")


def test_furniture_that_nothing_happens_to_lines_the_street() -> None:
    doc = laid("A car brakes on a road beside a lamp post and a mailbox.")
    for thing in ("lamp_post_1", "mailbox_1"):
        _, across, _, reach = on_street(doc, "road_1", thing)
        assert 0.0 < abs(across) - reach - half_width(doc, "road_1") < 150.0


def test_a_street_without_motion_is_lined_too() -> None:
    doc = laid("A parked car and a fire hydrant stand by the road.")
    for thing in ("parked_car_1" if "parked_car_1" in doc.spatial_relation_graph.nodes
                  else "car_1", "fire_hydrant_1"):  # fmt: skip
        _, across, _, reach = on_street(doc, "road_1", thing)
        assert 0.0 < abs(across) - reach - half_width(doc, "road_1") < 150.0


def test_a_street_is_longer_than_the_way() -> None:
    doc = laid("A truck drives down the road at 20 m/s and brakes after 4 seconds.")
    along, *_ = on_street(doc, "road_1", "truck_1")
    key = doc.spatial_relation_graph.nodes["road_1"].asset_id
    length = doc.asset_configurations[key].dimensions_cm[0]
    assert length >= 8000.0 + 2 * SIGHT_CM
    assert abs(along) < 0.5 * length - SIGHT_CM


def test_a_pavement_lies_beside_the_street() -> None:
    doc = laid("A truck hits a bench on the pavement.")
    _, across, off, _ = on_street(doc, "road_1", "pavement_1")
    beyond = abs(across) - half_width(doc, "pavement_1")
    assert beyond == pytest.approx(half_width(doc, "road_1"), abs=1.0)
    assert abs(math.remainder(off, 180.0)) < 1.0
    _, bench, _, _ = on_street(doc, "pavement_1", "bench_1")
    assert abs(bench) < half_width(doc, "pavement_1")


def test_a_second_street_lies_where_a_way_turns_off() -> None:
    """A car that turns left starts on the right of one street and ends on the right of another."""
    doc = laid("A car moves along the street and turns left at a cross. It brakes after entering "
               "the new lane, but still hits a bicycle stopped in the middle of the road.")  # fmt: skip
    assert in_its_lane(doc, "street_1", "car_1")
    _, across, off, _ = on_street(doc, "lane_1", "bicycle_1")
    assert -half_width(doc, "lane_1") < across < 0.0 and abs(math.sin(math.radians(off))) < 0.1
    first, second = (on_street(doc, "cross_1", n)[1:3] for n in ("street_1", "lane_1"))
    assert abs(first[0]) < 1.0 and abs(math.remainder(first[1] - second[1], 180.0)) > 89.0


def test_parked_vehicles_of_a_plural_stand_along_the_kerb() -> None:
    doc = laid("A car drives down the street past three parked cars.")
    for name in ("car_2", "car_3", "car_4"):
        _, across, off, reach = on_street(doc, "street_1", name)
        assert across < 0.0 and abs(across) - reach > half_width(doc, "street_1")
        assert abs(math.remainder(off, 180.0)) < 1.0


def test_a_street_without_drivers_lies_beside_what_is_parked() -> None:
    doc = laid("A child throws a snowball at a parked car.")
    _, across, _, reach = on_street(doc, "road_1", "car_1")
    assert 0.0 < abs(across) - reach - half_width(doc, "road_1") < 50.0
    assert abs(on_street(doc, "road_1", "child_1")[1]) > half_width(doc, "road_1")


@pytest.mark.parametrize(
    ("prompt", "who", "what"),
    [
        ("A boy throws a basketball into a hoop.", "boy_1", "basketball_1"),
        ("A child throws a snowball at a parked car.", "child_1", "snowball_1"),
        ("A girl throws a stone at a can.", "girl_1", "stone_1"),
        ("A man throws a frisbee to a dog.", "man_1", "frisbee_1"),
    ],
)
def test_a_throw_starts_at_a_hand(prompt: str, who: str, what: str) -> None:
    doc = laid(prompt)
    assert doc.layout_result is not None
    nodes, poses = doc.spatial_relation_graph.nodes, doc.layout_result.poses
    size = doc.asset_configurations[nodes[who].asset_id].dimensions_cm
    thing = doc.asset_configurations[nodes[what].asset_id].dimensions_cm
    (x, y, _), (u, v, z) = poses[who].position_cm, poses[what].position_cm
    assert math.dist((x, y), (u, v)) < 0.5 * (size[0] + max(thing)) + 30.0
    assert 0.4 * size[2] < z + 0.5 * thing[2] <= 1.26 * size[2]


def test_who_rides_keeps_the_lane_too() -> None:
    doc = laid("A cyclist rides along the street and hits a traffic cone lying on the road.")
    assert in_its_lane(doc, "street_1", "cyclist_1")


@pytest.mark.parametrize(
    ("prompt", "driver"),
    [
        ("A car drives up to a traffic light and stops right before it.", "car_1"),
        ("A truck approaches a playground and stops in front of the swing.", "truck_1"),
    ],
)
def test_who_stops_before_what_stands_at_the_kerb_stops_on_the_road(
    prompt: str, driver: str
) -> None:
    doc = laid(prompt)
    assert doc.choreography is not None and doc.layout_result is not None
    corridor = doc.choreography.constellations[0].corridors[0].points_cm
    way = math.dist(corridor[0], corridor[-2])
    pose = doc.layout_result.poses[driver]
    yaw = math.radians(pose.yaw_deg)
    x, y, z = pose.position_cm
    end = pose.model_copy(
        update={"position_cm": (x + way * math.cos(yaw), y + way * math.sin(yaw), z)}
    )
    poses = {**doc.layout_result.poses, driver: end}
    result = doc.layout_result.model_copy(update={"poses": poses})
    _, across, _, _ = on_street(doc.model_copy(update={"layout_result": result}), "road_1", driver)
    assert abs(across) < half_width(doc, "road_1")


def test_a_parked_vehicle_that_is_pushed_on_keeps_its_planned_heading() -> None:
    """Turned along the street it would stand in what it is pushed into."""
    doc = laid("A runaway trailer hits a parked truck, and the truck is pushed into a gate.")
    assert doc.layout_result is not None
    assert doc.layout_result.feasible and doc.layout_result.max_penetration_cm < 2.0
    poses = doc.layout_result.poses
    off = math.remainder(poses["truck_1"].yaw_deg - poses["trailer_1"].yaw_deg, 360.0)
    assert abs(off) < 1.0


@pytest.mark.parametrize(
    "prompt",
    [
        "A station wagon backs out of a parking space in front of the supermarket and hits a "
        "shopping cart.",
        "A hospital bed rolls along the corridor and bumps into a wheelchair after 2 seconds.",
    ],
)
def test_the_ground_reaches_beyond_the_ways_as_far_as_things_roll_on(prompt: str) -> None:
    doc = laid(prompt)
    assert doc.choreography is not None
    told = doc.choreography
    key = doc.spatial_relation_graph.nodes["ground_1"].asset_id
    side = min(doc.asset_configurations[key].dimensions_cm[:2])
    points = [p for c in told.constellations for k in c.corridors for p in k.points_cm]
    fastest = max(v for k, v in told.nominal.items() if k.endswith("/speed"))
    assert side >= max(math.dist(points[0], p) for p in points) + 2.0 * 200.0 * fastest - 100.0


def test_who_stops_at_a_bus_stop_stops_beside_it() -> None:
    """It does not stand in the way on which the bus drives on."""
    doc = laid("A bus stops at a bus stop for 2 seconds, then drives on.")
    _, across, _, reach = on_street(doc, "road_1", "bus_stop_1")
    assert abs(across) - reach > half_width(doc, "road_1")
    assert in_its_lane(doc, "road_1", "bus_1")


@pytest.mark.parametrize("who", ["skateboarder", "dog"])
def test_the_kerb_is_where_those_without_wheels_meet_what_stands_at_it(who: str) -> None:
    doc = laid(f"A {who} moves along the street and hits a mailbox.")
    _, across, _, reach = on_street(doc, "street_1", "mailbox_1")
    assert abs(across) - reach > half_width(doc, "street_1")
    assert abs(on_street(doc, "street_1", f"{who}_1")[1]) < half_width(doc, "street_1")


def test_a_street_lies_under_who_goes_along_it_not_under_who_comes_across() -> None:
    doc = laid("A car drives along a street, and a truck crashes into the side of it.")
    _, _, car, _ = on_street(doc, "street_1", "car_1")
    _, _, truck, _ = on_street(doc, "street_1", "truck_1")
    assert abs(math.remainder(car, 180.0)) < 15.0
    assert abs(abs(truck) - 90.0) < 15.0
    assert in_its_lane(doc, "street_1", "car_1")


def test_a_crosswalk_that_is_passed_lies_across_the_street() -> None:
    """Its middle is the street's, and its bars lie along the traffic."""
    doc = laid("A bus passes a crosswalk.")
    along, across, off, _ = on_street(doc, "road_1", "crosswalk_1")
    assert abs(across) < 60.0 and abs(abs(off) - 90.0) < 15.0
    start = on_street(doc, "road_1", "bus_1")[0]
    assert abs(along - start) > 300.0


def test_a_street_that_somebody_crosses_lies_across_his_way() -> None:
    doc = laid("A dog runs across the street.")
    _, across, off, _ = on_street(doc, "street_1", "dog_1")
    assert abs(abs(off) - 90.0) < 1.0 and abs(across) > 150.0


@pytest.mark.parametrize(
    ("ground", "by_it"), [("pavement", True), ("road", False), ("flower bed", False)]
)
def test_what_stands_on_the_pavement_stands_by_the_street_side(ground: str, by_it: bool) -> None:
    """On a road or in a flower bed, nothing is near it: it is on it."""
    edge = BinaryRelation.model_validate(
        {"from": "table", "to": "strip", "relation_type": "near", "confidence": 0.7}
    )
    strip = shape_of(b.decal(ground, 2000.0, 300.0))
    band = Term(terms.BAND, ("table", "strip", None), 0.7, (40.0, 60.0))
    low, _, slack = distance_range(edge, band, strip)
    assert (low - slack <= -150.0) is by_it


def test_a_table_by_the_street_side_may_stand_on_it() -> None:
    doc = laid("A car collides with a trashbin, knocking it into a picnic table by the street side")
    assert doc.layout_result is not None
    assert [r.edge for r in doc.layout_result.relations if not r.satisfied] == []
