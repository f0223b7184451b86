"""Groups beside one of their kind, what some of them do, and where all of them are."""

from __future__ import annotations

import pytest

from esg.draft import draft
from tests.draft.told import drawn, events, owned


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("The red cube hits the stack of four cubes.", 5),
        ("The white ball strikes the cluster of six balls.", 7),
        ("The small box slides into the pile of five boxes.", 6),
        ("A box falls on a second box. The two boxes slide.", 2),
    ],
)
def test_more_than_the_one_that_acts(prompt: str, things: int) -> None:
    """Draw a group that is more than what is there."""
    assert len(drawn(draft(prompt))) == things
    assert events(prompt)[0][0] == "Collision"


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball hits a row of five cans, three of which topple.",
        "A ball hits five cans, of which three topple.",
    ],
)
def test_some_of_which(prompt: str) -> None:
    """The cans topple, and the ball does not."""
    assert ("Topple", "ball_1") not in events(prompt)
    assert ("Topple", "can_1") in events(prompt)


def test_three_of_which_are_three() -> None:
    """Let as many fall as are told to."""
    told = events("A truck carries six barrels, three of which roll off.")
    assert [e[0] for e in told] == ["Fall"] * 3


@pytest.mark.parametrize(
    ("prompt", "verb"),
    [
        ("A cat knocks the cups off the shelf.", "knocks"),
        ("He sweeps the cups off the shelf.", "sweeps"),
    ],
)
def test_all_of_them_are_there(prompt: str, verb: str) -> None:
    """All stand where they come down from, and what only one does is owned up to."""
    doc = draft(prompt)
    nodes = doc.spatial_relation_graph.nodes
    assert {nodes[f"cup_{k}"].semantic_region for k in (1, 2, 3)} == {
        nodes["cup_1"].semantic_region
    }
    assert nodes["cup_3"].semantic_region is not None
    assert verb in owned(doc)


@pytest.mark.parametrize(
    ("prompt", "load", "owner"),
    [
        ("A truck's load of logs slides off.", "log_1", "truck_1"),
        ("A lorry's load of pipes rolls onto the road.", "pipe_1", "lorry_1"),
        ("A cart's load of hay bales falls off.", "hay_bale_1", "cart_1"),
    ],
)
def test_a_load_is_on_its_owner(prompt: str, load: str, owner: str) -> None:
    """What a lorry is loaded with is on it."""
    graph = draft(prompt).spatial_relation_graph
    assert graph.semantic_regions[graph.nodes[load].semantic_region or ""].parent_object == owner


@pytest.mark.parametrize(
    "prompt",
    [
        "A book is pulled from the shelf, and the ones beside it lean over.",
        "A can is taken from the stack, and the ones above it fall.",
        "A brick is pulled out and the ones above it fall.",
    ],
)
def test_the_ones_beside_it(prompt: str) -> None:
    """Own up to others that are not there."""
    assert "the ones" in owned(draft(prompt))


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A truck and a bus stop.", {"truck_1", "bus_1"}),
        ("A taxi and a bus stop at the crossing.", {"taxi_1", "bus_1", "crossing_1"}),
        ("A car passes a bench and a bus stop.", {"car_1", "bench_1", "bus_stop_1"}),
        ("There is a car and a bus stop.", {"car_1", "bus_stop_1"}),
    ],
)
def test_what_two_do_is_no_noun(prompt: str, things: set[str]) -> None:
    """Two vehicles stop, and where a sentence has a verb there is a bus stop."""
    assert drawn(draft(prompt)) == things


@pytest.mark.parametrize(
    "prompt",
    [
        "Six cups stand on a table, two of them are red.",
        "Six cups stand on a table, two of which are red.",
        "Three buckets stand in a row and two of them tip over.",
        "Four open boxes stand on the floor. Two of the boxes slide.",
    ],
)
def test_two_of_them_hold_no_others(prompt: str) -> None:
    """Put no cups in the cups that are told apart from them."""
    regions = draft(prompt).spatial_relation_graph.semantic_regions.values()
    assert not [r for r in regions if r.region_type.value.startswith("STORAGE")]
