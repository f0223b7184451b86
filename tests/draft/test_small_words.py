"""Small words and outcomes: almost, again, settles, lets go, only just, off the back."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, NodeEvent, Predicate

_LOST = (
    ("A plate almost falls off the table.", "falls"),
    ("A toddler almost knocks over a lamp.", "knocks over"),
    ("A cart nearly tips over.", "tips over"),
    ("A man tries to lift a box and fails.", "tries to lift"),
    ("A girl tries to open a door, but it does not move.", "tries to open"),
    ("He tries in vain to push the car.", "to push"),
    ("A book falls onto the floor again.", "again"),
    ("A hammer hits a nail repeatedly.", "repeatedly"),
    ("A goat butts the gate again and again.", "again and again"),
    ("Every time the ball hits the wall, the lamp falls.", "Every time"),
    ("Each time the swing comes back, it hits the cup.", "Each time"),
    ("A ball only just misses a vase.", "only just"),
    ("A boy falls headfirst into a sandbox.", "headfirst"),
    ("A press crushes a can flat.", "crushes"),
    ("A boy lets go of the rope.", "lets go"),
    ("A van clips a barrier and spins out.", "spins"),
    ("A bottle is kicked and spins across the floor.", "spins"),
    ("A bird settles on a branch.", "settles"),
    ("A ship sinks.", "sinks"),
    ("A hand catches a ball.", "catches"),
    ("A car hits a tree because its brakes fail.", "fail"),
    ("A drone loses height.", "loses"),
    ("A crate rolls off the back of a truck.", "off the back of a truck"),
    ("A ball rolls off the left side of a table.", "off the left side of a table"),
    ("The dominoes fall behind them.", "behind them"),
    ("The kick sends the can flying.", "The kick"),
    ("A ball stops just before crossing the line.", "crossing the line"),
    ("A lorry stops before it enters the tunnel.", "enters the tunnel"),
    ("Unit one drives to the gate.", "Unit one"),
    ("A man pushes a crate with 50 N.", "50 N"),
)
_THINGS = (
    ("A man pushes a crate with 50 N.", {"man_1", "crate_1"}),
    ("A door comes down and knocks a bicycle flat.", {"door_1", "bicycle_1", "door_frame_1"}),
    ("Two officers watch as a van hits a post.", {"officer_1", "officer_2", "van_1", "post_1"}),
    ("A wheel rolls down a slope, then up another one.", {"wheel_1", "slope_1", "slope_2"}),
    ("A ball falls off a shelf onto the one below.", {"ball_1", "shelf_1", "shelf_2"}),
    ("A mouse pulls a string and runs, and a shelf falls behind her.",
     {"mouse_1", "string_1", "shelf_1"}),
)  # fmt: skip
_EVENTS = (
    ("The officers observed a sedan strike a post.", "Collision(sedan_1, post_1)"),
    ("A boy knocks over a tower his sister just finished.",
     "Collision(boy_1, tower_1) Topple(tower_1)"),
    ("A ball hits the vase his mother bought.", "Collision(ball_1, vase_1)"),
    ("A ball hits a pin and knocks it flat.", "Collision(ball_1, pin_1) Topple(pin_1)"),
    ("The ball rolls back and settles in the corner.", "Stop(ball_1)"),
    ("The car turns left instead of right.", "HeadingReached(car_1)"),
    ("The bus no longer stops here.", ""),
    ("The ball doesn't hit the vase but the lamp.", "Miss(ball_1, vase_1) Collision(ball_1, lamp_1)"),
    ("A drone carries a parcel over the roof and lets it go.", "Fall(parcel_1)"),
    ("A helium balloon released from the floor rises.", ""),
    ("The pendulum stops at the top of its swing.", "Stop(pendulum_1)"),
    ("A wheel keeps turning.", "Spin(wheel_1)"),
    ("A girl gives a coin another twirl.", "Spin(coin_1)"),
)  # fmt: skip
_NO_SLIDE = ("A man slides a drawer shut.", "A girl slides a plate across the table.")


def _owned(doc: EsgDocument) -> list[str]:
    lost = [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    return lost + [i.text for i in doc.coverage.items if i.status == "not_understood"]


def _events(doc: EsgDocument) -> str:
    if doc.timeline_system is None:
        return ""
    nodes = doc.timeline_system.sequence_graph.nodes
    told = [n for n in nodes if n.event not in (NodeEvent.SCENE_START, NodeEvent.TRIGGER)]
    return " ".join(f"{n.event.value}({', '.join(n.participants)})" for n in told)


@pytest.mark.parametrize(("prompt", "words"), _LOST)
def test_what_no_scene_shows_is_owned_up_to(prompt: str, words: str) -> None:
    assert words in _owned(draft(prompt))


@pytest.mark.parametrize(("prompt", "things"), _THINGS)
def test_nothing_else_is_drawn(prompt: str, things: set[str]) -> None:
    assert {*draft(prompt).spatial_relation_graph.nodes} - {"ground_1", "road_1"} == things


@pytest.mark.parametrize(("prompt", "events"), _EVENTS)
def test_these_events_and_no_others(prompt: str, events: str) -> None:
    assert _events(draft(prompt)) == events


@pytest.mark.parametrize("prompt", _NO_SLIDE)
def test_who_slides_a_thing_does_not_slide(prompt: str) -> None:
    slides = [s.object for s in draft(prompt).statements or () if s.predicate is Predicate.SLIDES]
    assert len(slides) == 1 and not {"man_1", "girl_1"} & {*slides[0]}


@pytest.mark.parametrize(
    "prompt",
    ["A gate opens and closes again.", "A ball bounces and falls again.", "A top spins on a table.",
     "The crane lets go of a crate.", "A box lands on its side.", "A card lies flat on a table.",
     "A ball rolls down a ramp and settles against a box."],
)  # fmt: skip
def test_what_is_shown_is_not_owned_up_to(prompt: str) -> None:
    assert not {*_owned(draft(prompt))} & {"again", "spins", "lets go", "lands", "flat", "settles"}


@pytest.mark.parametrize(
    "prompt",
    ["A balloon drifts up.", "A rocket rises into the sky.", "A balloon slips away and rises."],
)
def test_what_floats_goes_up(prompt: str) -> None:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    climbs = [e.params.elevation_deg for e in doc.timeline_system.sequence_graph.edges]
    assert climbs[-1] is not None and _owned(doc) == []


def test_who_falls_on_its_back_moves_away_from_nothing() -> None:
    doc = draft("A robot kicks a ball and falls on its back.")
    assert not [s for s in doc.statements or () if s.text == "back"]


def test_who_lands_on_a_cart_and_rides_it_ends_on_it() -> None:
    doc = draft("A cat jumps off a fridge, lands on a cart and rides it across the room.")
    ends = [(s.object, s.target) for s in doc.statements or () if s.predicate is Predicate.ENDS_ON]
    assert ends == [(("cat_1",), ("cart_1",))]


def test_the_arm_of_a_machine_is_no_human_one() -> None:
    doc = draft("The arm pushes a can off a table.")
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes["arm_1"].asset_id]
    assert asset.asset_category == "robot_arm"
