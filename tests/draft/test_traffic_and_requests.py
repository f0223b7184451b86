"""Drivers, followers and crossings; commands with numbers, bounces, what is poured and set down."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import Predicate
from tests.draft.told import drawn, events, owned, stated


@pytest.mark.parametrize(
    ("prompt", "things", "event"),
    [
        ("The driver swerves and the bus hits a tree.", {"bus_1", "tree_1"}, "HeadingReached"),
        ("As the driver brakes, the car skids into a wall.", {"car_1", "wall_1"}, "Collision"),
        ("The driver turns left and the truck hits a fence.", {"truck_1", "fence_1"}, "Collision"),
    ],
)
def test_the_driver_is_the_vehicle_named_later(prompt: str, things: set[str], event: str) -> None:
    """Draw nobody who swerves beside the bus."""
    assert drawn(draft(prompt)) == things
    assert event in {e[0] for e in events(prompt)}


@pytest.mark.parametrize(
    ("prompt", "kind"),
    [
        ("The driver swerves and hits a bus.", "car"),
        ("The motorist rams a parked van.", "car"),
        ("A driver walks past a bus.", "person"),
        ("A driver runs towards his car.", "person"),
    ],
)
def test_what_a_driver_meets_is_not_his(prompt: str, kind: str) -> None:
    """Who runs into a bus drives another vehicle, and who walks drives none."""
    doc = draft(prompt)
    node = next(n for i, n in doc.spatial_relation_graph.nodes.items() if i[:6] in _DRIVERS)
    category = doc.asset_requirement[node.asset_id].asset_category
    assert (category == "person") is (kind == "person")


_DRIVERS = ("driver", "motori")


@pytest.mark.parametrize(
    "prompt",
    [
        "The ego vehicle follows a lead vehicle at 12 m/s when the lead vehicle brakes.",
        "The ego car follows a van when the van stops.",
        "A car drives behind a truck when the truck suddenly swerves.",
    ],
)
def test_who_follows_is_on_the_way(prompt: str) -> None:
    """Let no follower stand until who leads brakes."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    assert all(e.params.speed != 0.0 for e in doc.timeline_system.sequence_graph.edges)
    assert not stated(doc, Predicate.STAYS_STILL)


def test_crosses_after_what_comes_first() -> None:
    """Time a crossing from the event before it."""
    assert verify(draft("A man pushing a cart crosses the street.")) == ()


@pytest.mark.parametrize(
    ("prompt", "event"),
    [
        ("Drop 2 eggs on the floor.", ("Fall", "egg_1")),
        ("Kick 2 balls into the goal.", ("EnterRegion", "ball_1")),
        ("Push 4 boxes off a table.", ("Fall", "box_1")),
    ],
)
def test_commands_with_digits(prompt: str, event: tuple[str, str]) -> None:
    """A number in digits is a number of things."""
    assert event in events(prompt)


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A boy bounces a ball off a wall into a basket.", ("Collision", "ball_1", "wall_1")),
        ("Bounce a basketball off a wall into a bin.", ("EnterRegion", "basketball_1")),
        ("A girl bounces a ball off a door.", ("Collision", "ball_1", "door_1")),
    ],
)
def test_who_bounces_a_ball_does_not_bounce(prompt: str, told: tuple[str, ...]) -> None:
    """The ball hits the wall."""
    assert told in events(prompt)
    assert not any(e[1] in ("boy_1", "girl_1") for e in events(prompt))


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("Pour 30 beads into a bowl.", [("EnterRegion", "bead_1")]),
        ("Forty coins are poured onto a table.", [("Collision", "coin_1", "table_1")]),
        ("He pours the marbles out of a jar.", [("Fall", f"marble_{k}") for k in (1, 2, 3)]),
        ("The crowd pours out of the gate.", []),
        ("She pours milk into a glass.", []),
    ],
)
def test_solids_that_are_poured_fall(prompt: str, told: list[tuple[str, ...]]) -> None:
    """Let what is counted fall, and no crowd; milk is owned up to."""
    assert events(prompt) == told
    assert owned(draft(prompt))


@pytest.mark.parametrize(
    "prompt",
    [
        "The cone is lifted and set down to the left of the cylinder.",
        "The cone is lifted, carried over a wall and put down to the left of the cylinder.",
        "The plate is taken from the shelf and placed on the table.",
    ],
)
def test_is_lifted_and_set_down(prompt: str) -> None:
    """A participle after a passive is one, too."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    assert "Placed" in {n.event.value for n in doc.timeline_system.sequence_graph.nodes}


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A taxi cuts in ahead of the bus.", "cuts in"),
        ("A car cuts in front of a lorry.", "cuts in"),
        ("A wheel comes loose and rolls down the road.", "comes loose"),
        ("The ball and the feather fall.", "the feather"),
    ],
)
def test_owns_up(prompt: str, words: str) -> None:
    """Name the words that no scene shows, and the thing that is drawn as another."""
    assert owned(draft(prompt)) == [words]


def test_catches_up() -> None:
    """State that one nears the other."""
    told = stated(draft("A dog catches up with a cart."), Predicate.MOVES)
    assert [(s.object, s.target, s.direction) for s in told] == [
        (("dog_1",), ("cart_1",), "toward")
    ]


def test_the_hard_shoulder_is_a_road() -> None:
    """Draw no cut of meat."""
    doc = draft("A car stops on the hard shoulder.")
    assert {a.asset_category for a in doc.asset_requirement.values()} <= {"ground", "car", "road"}


def test_what_strikes_something_off_a_table_is_on_it() -> None:
    """Let the ball roll where the others are."""
    doc = draft("The white ball hits the cluster of six balls, two of which roll off the table.")
    nodes = doc.spatial_relation_graph.nodes
    assert nodes["white_ball_1"].semantic_region == nodes["ball_1"].semantic_region is not None


@pytest.mark.parametrize(
    "prompt",
    [
        "Two boxes are pushed along the floor by a moving wall.",
        "A moving wall pushes five boxes.",
        "A wall slides into a stack of boxes.",
    ],
)
def test_a_moving_wall_moves(prompt: str) -> None:
    """The wall runs into the boxes, and they do not into it."""
    assert ("Collision", "wall_1", "box_1") in events(prompt)


@pytest.mark.parametrize(
    ("prompt", "said"),
    [
        ("She pushes the cork into the bottle with her thumb.", True),
        ("A man pushes a nail into a board.", True),
        ("A cat pushes a cup off the table.", False),
    ],
)
def test_what_nobody_touches_is_pushed_by_nobody(prompt: str, said: bool) -> None:
    """Own up to a push that sets off by itself."""
    assert ("pushes" in owned(draft(prompt))) is said


@pytest.mark.parametrize(
    ("prompt", "turns", "passes"),
    [
        ("A taxi waits for two buses to pass before turning left.", "taxi_1", 2),
        ("A taxi waits for two cyclists to pass before turning left.", "taxi_1", 2),
        ("A bus waits for a dog to pass before turning right.", "bus_1", 1),
    ],
)
def test_who_waits_goes_on(prompt: str, turns: str, passes: int) -> None:
    """Who waits turns, and they pass by him and not by each other."""
    told = events(prompt)
    assert [e for e in told if e[0] == "HeadingReached"] == [("HeadingReached", turns)]
    assert [e[2] for e in told if e[0] == "Miss"] == [turns] * passes


@pytest.mark.parametrize(
    ("prompt", "moved"),
    [
        ("Let a cylinder and a sphere race down a ramp.", {"cylinder_1", "sphere_1"}),
        ("Let two balls and a can roll down a slope.", {"ball_1", "ball_2", "can_1"}),
        ("Watch a ball and a cube fall.", {"ball_1", "cube_1"}),
        ("Let a ball roll and a cube slide.", {"ball_1", "cube_1"}),
    ],
)
def test_all_that_are_let_do_so(prompt: str, moved: set[str]) -> None:
    """Leave out none of those that are let roll."""
    timeline = draft(prompt).timeline_system
    assert timeline is not None
    assert {e.actor for e in timeline.sequence_graph.edges} == moved


@pytest.mark.parametrize(
    "prompt",
    [
        "A wet shirt hangs on the line, dripping onto the grass.",
        "A tap drips onto the floor.",
        "A wet dog drips on the carpet.",
    ],
)
def test_what_drips_does_not_fall(prompt: str) -> None:
    """Drops fall, which are owned up to, and not the tap."""
    assert not events(prompt)
    assert any("drip" in words for words in owned(draft(prompt)))


@pytest.mark.parametrize(
    ("prompt", "who", "how", "whom", "gap"),
    [
        (
            "A car drives at 8 m/s, 30 m ahead of a truck.",
            "car_1",
            "in_front_of",
            "truck_1",
            3000.0,
        ),
        ("A truck drives 20 m behind a bus.", "truck_1", "behind", "bus_1", 2000.0),
        ("A cyclist rides 10 m in front of a van.", "cyclist_1", "in_front_of", "van_1", 1000.0),
    ],
)
def test_goes_so_far_ahead(prompt: str, who: str, how: str, whom: str, gap: float) -> None:
    """A length before "ahead of" is a gap to what goes there, too, and no way travelled."""
    doc = draft(prompt)
    told = doc.spatial_relation_graph.edges.binary_relations
    assert [(r.from_, r.to, r.distance_cm) for r in told if r.relation_type.value == how] == [
        (who, whom, gap)
    ]
    assert doc.timeline_system is not None
    assert not any(n.constraints for n in doc.timeline_system.sequence_graph.nodes)
