"""What lands on a thing stays there; what is hit goes on; what lies along a table stays on it."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import Predicate
from tests.draft.told import stated


def _missing(prompt: str) -> list[str]:
    return [s.text for s in stated(draft(prompt), Predicate.NOT_REPRESENTED)]


@pytest.mark.parametrize(
    ("prompt", "who", "host"),
    [
        ("A coconut falls from a palm tree and lands on top of a parked jeep.", "coconut", "jeep"),
        ("A stone thrown by a boy lands on a crate.", "stone", "crate"),
        ("A box is dropped and lands on a table.", "box", "table"),
        ("A ball falls off a shelf and lands on a crate.", "ball", "crate"),
    ],
)
def test_what_lands_on_a_thing_stays_there(prompt: str, who: str, host: str) -> None:
    (end,) = stated(draft(prompt), Predicate.ENDS_ON)
    assert (end.object, end.target, end.when) == ((f"{who}_1",), (f"{host}_1",), "end")


@pytest.mark.parametrize(
    "prompt",
    [
        "A book drops from a shelf and lands on a cat.",
        "A ball falls off a shelf, lands on a crate and rolls off it.",
        "A ball drops and lands on a seesaw.",
        "A ball falls from a table and lands on a ramp.",
    ],
)
def test_what_is_shaken_off_or_goes_on_does_not_end_there(prompt: str) -> None:
    assert not stated(draft(prompt), Predicate.ENDS_ON)


@pytest.mark.parametrize(
    ("prompt", "who", "over"),
    [
        ("A tennis racket hits a tennis ball over the net.", "tennis_ball_1", "net_1"),
        ("A bat hits a baseball over the fence.", "baseball_1", "fence_1"),
        ("A truck hits a car through a fence.", "car_1", "fence_1"),
    ],
)
def test_what_is_hit_goes_the_way_that_follows(prompt: str, who: str, over: str) -> None:
    (way,) = stated(draft(prompt), Predicate.MOVES)
    assert (way.object, way.target) == ((who,), (over,))
    assert way.when.endswith("_collision..end")


def test_the_way_of_what_comes_is_its_own() -> None:
    (way,) = stated(draft("Across the road, a car hits a cone."), Predicate.MOVES)
    assert way.object == ("car_1",)


@pytest.mark.parametrize(
    "prompt",
    [
        "A book is pushed along a desk.",
        "A boy pushes a book along a desk until it hits a mug.",
        "A box is shoved across a table.",
    ],
)
def test_what_is_pushed_along_a_table_stays_on_it(prompt: str) -> None:
    on = stated(draft(prompt), Predicate.SUPPORTED_BY)[0]
    assert on.when != "start"
    assert not _missing(prompt)


def test_what_is_thrown_across_a_table_does_not_lie_on_it() -> None:
    assert not stated(draft("A girl throws a ball across a table."), Predicate.SUPPORTED_BY)


def test_a_drum_is_no_fluid_of_its_name() -> None:
    assert not _missing("A wrecking ball swings into a stack of oil drums.")
    assert "water" in " ".join(_missing("A bowl of water falls."))


def test_machines_that_stand_still_lift_nothing() -> None:
    assert "lifts" in _missing("A forklift lifts a pallet and puts it down beside a fence.")
    assert "lifts" not in _missing("A man lifts a pallet and puts it down beside a fence.")


def test_the_crossbar_is_not_the_whole_goal() -> None:
    assert _missing("A ball hits the crossbar.") == ["the crossbar"]


def test_clatter_is_a_fall() -> None:
    assert not _missing("A frying pan slides off the stove and clatters to the floor.")


def test_balloons_rise_no_faster_than_their_lift_carries_them() -> None:
    system = draft("A balloon rises into the sky.").timeline_system
    assert system is not None
    (edge,) = system.sequence_graph.edges
    assert edge.params.speed == (50.0, 190.0)


def test_what_flies_from_a_thing_sits_on_it_at_first() -> None:
    (on,) = stated(
        draft("A butterfly flies from a flower to a fence post."), Predicate.SUPPORTED_BY
    )
    assert (on.object, on.target, on.when) == (("butterfly_1",), ("flower_1",), "start")


@pytest.mark.parametrize(
    ("prompt", "drawn"),
    [
        ("A milk carton falls out of the fridge as the door opens.", "fridge_door"),
        ("A cat sits beside the fridge when the door swings open and hits it.", "fridge_door"),
        ("A door opens and hits the fridge. The door falls.", "door_leaf"),
        ("A man walks through the door and hits the fridge.", "door_leaf"),
    ],
)
def test_the_door_is_that_of_the_fridge_told_of_before(prompt: str, drawn: str) -> None:
    node = draft(prompt).spatial_relation_graph.nodes["door_1"]
    assert node.asset_id.startswith(drawn)
