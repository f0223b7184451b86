"""Contacts that nothing makes, arrivals that fail, and who has stopped and touches nothing."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import Predicate
from tests.draft.told import events, owned, stated


def _moved(prompt: str) -> set[str]:
    timeline = draft(prompt).timeline_system
    return {e.actor for e in timeline.sequence_graph.edges} if timeline is not None else set()


@pytest.mark.parametrize(
    ("prompt", "spared", "others"),
    [
        ("Nothing hits the blue box while the red ball rolls past.", "blue_box_1", "red_ball_1"),
        ("A van drives by and nothing hits the cone.", "cone_1", "van_1"),
        ("The red cube is not touched while a green cube falls.", "red_cube_1", "green_cube_1"),
        ("Two balls roll and nobody touches the vase.", "vase_1", "ball_1 ball_2"),
    ],
)
def test_nothing_touches_it(prompt: str, spared: str, others: str) -> None:
    """State that it is not touched, and do not move it."""
    told = stated(draft(prompt), Predicate.NEVER_TOUCHES)
    assert [(s.object, s.target) for s in told] == [((spared,), tuple(others.split()))]
    assert spared not in _moved(prompt)


def test_what_carries_it_touches_it() -> None:
    """Leave out what it stands on, which may be told later."""
    doc = draft("Nothing touches the cup, which stands on a shelf, as a ball rolls past.")
    assert [s.target for s in stated(doc, Predicate.NEVER_TOUCHES)] == [("ball_1",)]


def test_what_is_not_damaged_may_be_hit() -> None:
    """Take no other denial for one of a touch."""
    doc = draft("A ball hits a door. The door is not damaged.")
    assert not stated(doc, Predicate.NEVER_TOUCHES)


@pytest.mark.parametrize(
    "prompt",
    [
        "The door opens and nothing falls out.",
        "A man shakes a bottle over a plate, but nothing comes out.",
        "The ball rolls past the pins and nobody falls over.",
    ],
)
def test_nobody_is_no_one_of_before(prompt: str) -> None:
    """Let none fall, and state nothing of who acted before."""
    assert not {e[0] for e in events(prompt)} & {"Fall", "Topple"}
    assert not stated(draft(prompt), Predicate.STAYS_UPRIGHT)


def test_owns_up_to_falls_that_nothing_rules_out() -> None:
    """A hit may bring down what is told not to fall."""
    assert owned(draft("A cart loaded with boxes rolls into a door. Nothing falls off."))[-1:] == [
        "falls"
    ]


@pytest.mark.parametrize(
    ("prompt", "who", "whom"),
    [
        ("The ball rolls towards the cup but never reaches it.", "ball_1", "cup_1"),
        ("The arrow did not reach the target.", "arrow_1", "target_1"),
        ("A dog runs after a cat but cannot reach it.", "dog_1", "cat_1"),
    ],
)
def test_never_reaches_it(prompt: str, who: str, whom: str) -> None:
    """Who does not get there is on the way all the same, and does not touch it."""
    told = stated(draft(prompt), Predicate.NEVER_TOUCHES)
    assert [(s.object, s.target) for s in told] == [((who,), (whom,))]
    assert who in _moved(prompt)


@pytest.mark.parametrize(
    "prompt",
    [
        "A car parks between a jeep and a van without touching either.",
        "A bus stops between two cars without touching them.",
        "A boat moors next to the pier without hitting it.",
        "A truck stops beside three cones without hitting any of them.",
    ],
)
def test_stays_where_it_has_stopped(prompt: str) -> None:
    """Nothing goes on after its stop in order to miss something."""
    assert [e[0] for e in events(prompt)] == ["Stop"]
    assert stated(draft(prompt), Predicate.NEVER_TOUCHES)
