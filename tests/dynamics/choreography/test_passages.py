"""Ways that lead somewhere: down a chute into a vessel, through a tunnel, up a ramp, past a thing."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.dynamics import start_hints
from esg.dynamics.casting.passages import HIGH, WIDE
from esg.dynamics.choreography.courses.chutes import drop_needed, leap
from esg.dynamics.choreography.courses.passages import passage_of
from esg.dynamics.choreography.slopes import chute_of, slope_of
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.story.stagecraft import prop
from esg.graph.models import EsgDocument
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast

Place = tuple[float, float, float]


def places(doc: EsgDocument) -> dict[str, Place]:
    """Start places by node: x, y [m], yaw [rad], in the frame of the only constellation."""
    (only,) = start_hints(doc, seed=0).constellations
    return {
        p.node: (p.x_cm / 100.0, p.y_cm / 100.0, math.radians(p.yaw_deg or 0.0))
        for p in only.placements
    }


def test_a_leap_falls_freely_and_needs_the_drop_that_it_takes() -> None:
    """Come down along a parabola that begins along the chute; both closed forms agree."""
    flight = leap(2.0, 0.5, 0.3)
    along = 2.0 / math.hypot(1.0, 0.5)
    assert flight.left == pytest.approx(along)
    fallen = 0.5 * along * flight.lasts + 0.5 * GRAVITY_MPS2 * flight.lasts**2
    assert fallen == pytest.approx(0.3)
    assert drop_needed(2.0, 0.5, flight.way) == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("prompt", "ramp", "thing", "vessel"),
    [
        ("A marble rolls down a chute into a tin cup.", "chute_1", "marble_1", "cup_1"),
        ("An orange rolls down a plank into a basket.", "plank_1", "orange_1", "basket_1"),
        ("A book slides down a tilted shelf into a crate.", "shelf_1", "book_1", "crate_1"),
        ("A ball rolls down a ramp and drops into a bucket.", "ramp_1", "ball_1", "bucket_1"),
    ],
)
def test_a_chute_ends_over_the_rim_that_waits_below(
    prompt: str, ramp: str, thing: str, vessel: str
) -> None:
    """Raise the lip over the rim, clear of it, and put the opening where the thing comes down."""
    doc = cast(prompt)
    chute, rim, at = chute_of(doc, ramp), prop(doc, vessel), places(doc)
    assert chute is not None
    assert slope_of(doc, ramp) is None
    assert chute.lip > rim.height
    gap = math.dist(at[vessel][:2], at[thing][:2]) - (chute.foot - at[thing][0])
    assert rim.half_length - 0.05 < gap < 2.5 * rim.half_length + 0.1
    assert prop(doc, thing).width < prop(doc, ramp).width


@pytest.mark.parametrize(
    "prompt",
    [
        "A car rolls down a hill into a garage.",
        "A wooden block slides down a ramp and hits a box.",
        "A barrel rolls down a ramp into a crate.",
    ],
)
def test_what_is_run_into_is_no_vessel(prompt: str) -> None:
    """Leave the foot of a ramp on the ground where nothing has room below its end."""
    doc = cast(prompt)
    ramps = [n for n, v in doc.spatial_relation_graph.nodes.items() if "ramp" in v.asset_id]
    assert [slope_of(doc, n) is not None for n in ramps] == [True]


@pytest.mark.parametrize(
    ("prompt", "mover", "named"),
    [
        ("A car drives through a tunnel.", "car_1", "tunnel_1"),
        ("The sheep walk through a gate.", "sheep_1", "gate_1"),
        ("A boy walks through an open door.", "boy_1", "door_1"),
        ("A truck drives through a gateway.", "truck_1", "gateway_1"),
    ],
)
def test_a_way_through_something_leads_into_it_and_out_again(
    prompt: str, mover: str, named: str
) -> None:
    """Put it around the way, along it, wide enough, with the way's end behind it."""
    doc = cast(prompt)
    passage, at = passage_of(doc, named), places(doc)
    assert passage is not None
    told = choreograph(doc)
    (only,) = told.hints.constellations
    body, (x, y, yaw) = prop(doc, mover), at[passage.owner]
    (corridor,) = only.corridors
    start, *_, end, _ = (np.array(p) / 100.0 for p in corridor.points_cm)
    ahead = (end - start) / np.linalg.norm(end - start)
    middle = np.array([x, y]) - start
    assert abs(middle[0] * ahead[1] - middle[1] * ahead[0]) < 1e-6
    assert middle @ ahead > 0.5 * passage.long + body.half_length
    assert np.linalg.norm(end - start) > middle @ ahead + 0.5 * passage.long + body.half_length
    assert abs(math.cos(yaw - math.atan2(ahead[1], ahead[0]))) == pytest.approx(1.0)
    assert passage.wide > body.width


def test_a_gateway_grows_for_what_goes_through_it() -> None:
    """Give a truck the room that it asks for, and leave a man's gateway as it is."""
    wide = passage_of(cast("A truck drives through a gateway."), "gateway_1")
    usual = passage_of(cast("A man walks through a gateway."), "gateway_1")
    truck = prop(cast("A truck drives through a gateway."), "truck_1")
    assert wide is not None
    assert usual is not None
    assert wide.wide == pytest.approx(WIDE * truck.width, rel=0.02)
    assert wide.high >= HIGH * truck.height * 0.98
    assert usual.wide < wide.wide


def test_those_who_go_through_one_tunnel_go_in_file() -> None:
    """Keep three cyclists on one line, none in another one's place."""
    doc = cast("Three cyclists ride through a tunnel.")
    at = places(doc)
    riders = sorted(n for n in at if n.startswith("cyclist"))
    assert len(riders) == 3
    heading = at[riders[0]][2]
    ways = [x * math.cos(heading) + y * math.sin(heading) for x, y, _ in (at[r] for r in riders)]
    aside = [-x * math.sin(heading) + y * math.cos(heading) for x, y, _ in (at[r] for r in riders)]
    assert np.ptp(aside) < 1e-6
    assert np.diff(sorted(ways)).min() > prop(doc, riders[0]).length


@pytest.mark.parametrize("mover", ["man", "dog", "toy truck"])
def test_a_way_up_leads_to_the_foot_of_a_ramp(mover: str) -> None:
    """Let the ramp's foot face who goes up it, and the way go on over most of its slope."""
    doc = cast(f"A {mover} goes up a ramp.")
    at, slope = places(doc), slope_of(doc, "ramp_1")
    assert slope is not None
    name = next(n for n in at if n != "ramp_1")
    (x, y, yaw), (rx, ry, turned) = at[name], at["ramp_1"]
    assert math.cos(yaw - turned) == pytest.approx(-1.0)
    assert math.dist((x, y), (rx, ry)) > slope.foot + prop(doc, name).half_length


@pytest.mark.parametrize(
    ("begins", "ends", "says"),
    [
        ((1.0, 0.0), (0.0, -1.0), "is on the left of a chair, then the {} walks to the back of"),
        ((-1.0, 0.0), (1.0, 0.0), "is on the right of a chair, then the {} walks to the left of"),
        ((0.0, 1.0), (0.0, -1.0), "is in front of a chair, then the {} walks to the back of"),
    ],
)
@pytest.mark.parametrize("who", ["cat", "dog", "robot"])
def test_a_way_leads_from_one_side_to_another(
    who: str, begins: tuple[float, float], ends: tuple[float, float], says: str
) -> None:
    """Start on the one side and end on the other as the viewer sees them, past the thing."""
    doc = cast(f"A {who} {says.format(who)} the chair.")
    (only,) = start_hints(doc, seed=0).constellations
    assert only.yaw_deg is not None
    turn = math.radians(only.yaw_deg)
    world = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    at = places(doc)
    chair = np.array(at["chair_1"][:2])
    corridor = next(c for c in only.corridors if math.dist(c.points_cm[0], (0.0, 0.0)) < 1e-6)
    start, end = (world @ (np.array(corridor.points_cm[k]) / 100.0 - chair) for k in (0, -2))
    for offset, side in ((start, np.array(begins)), (end, np.array(ends))):
        assert offset @ side > abs(offset @ side[::-1])
    way = (end - start) / np.linalg.norm(end - start)
    clear = abs(start[0] * way[1] - start[1] * way[0])
    assert clear > 0.5 * prop(doc, "chair_1").length
