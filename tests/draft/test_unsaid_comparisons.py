"""Comparisons, cameras and roads: what is owned up to, what goes on, and what is not drawn."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, Predicate


def lost(prompt: str) -> list[str]:
    """What a draft owns up to."""
    doc = draft(prompt)
    return [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]


def nodes(doc: EsgDocument) -> set[str]:
    """The things of a draft."""
    return {*doc.spatial_relation_graph.nodes}


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A red kite flies higher than a blue kite.", "higher"),
        ("A bob strikes a stationary ball of equal mass.", "of equal mass"),
        ("A steel ball and a rubber ball of the same size fall to the floor.", "of the same size"),
        ("The blue toy car is faster than the red one and hits it.", "faster than"),
        ("Two cars crash. The yellow one was faster.", "faster"),
        ("The cows run away as fast as they can.", "as fast as"),
    ],
)
def test_owns_up_to_comparisons_that_nothing_sees_to(prompt: str, words: str) -> None:
    """Name what is compared and not set."""
    assert words in lost(prompt)


@pytest.mark.parametrize(
    "prompt",
    [
        "A crate twice as heavy as a 5 kg barrel is pushed into the barrel by a forklift.",
        "The red car drives twice as fast as the blue car, which goes 10 m/s; the red car rams it.",
        "Two balls of the same size collide.",
        "The larger box falls off the table.",
        "A bus going no faster than 10 m/s hits a signpost.",
        "A hockey puck shoots across the rink, faster than 60 km/h, and hits a wall.",
    ],
)
def test_says_nothing_of_comparisons_that_hold(prompt: str) -> None:
    """Leave alone what is set, alike, or a name."""
    assert lost(prompt) == []


@pytest.mark.parametrize(
    ("prompt", "drawn"),
    [
        ("A ball flies into a bottle and the bottle falls over, static camera.", False),
        ("A bowling ball hits ten pins. Camera from the side.", False),
        ("A car drives along a road, fixed camera, wide angle.", False),
        ("A photographer drops his camera.", True),
        ("A gymnast knocks over a camera.", True),
        ("The camera falls off the table.", True),
    ],
)
def test_draws_a_camera_only_where_it_is_a_thing(prompt: str, drawn: bool) -> None:
    """Tell who films from what falls."""
    assert ("camera_1" in nodes(draft(prompt))) is drawn


@pytest.mark.parametrize(
    ("prompt", "road"),
    [
        ("A train brakes and hits a buffer.", False),
        ("A locomotive rolls into a wagon.", False),
        ("Two bumper cars meet in the middle of the hall.", False),
        ("In a dimly lit warehouse, a forklift reverses into a shelf.", False),
        ("An ice resurfacer drives across the rink and stops.", False),
        ("A go-kart drives through the factory hall and hits a box.", False),
        ("A train hits a bus.", True),
        ("A forklift pushes a pallet.", True),
        ("A truck drives past a hall and hits a box.", True),
    ],
)
def test_lays_a_road_only_where_one_leads(prompt: str, road: bool) -> None:
    """Lay none indoors, on ice and under trains."""
    assert ("road_1" in nodes(draft(prompt))) is road


@pytest.mark.parametrize(
    ("prompt", "segments"),
    [
        ("A truck hits a traffic cone and keeps going.", 2),
        ("A bus rams a barrier and continues driving.", 2),
        ("A dog bumps a chair and keeps running.", 2),
        ("A car drives, keeps going and crashes through the barrier.", 1),
    ],
)
def test_keeps_going_after_what_it_hits(prompt: str, segments: int) -> None:
    """Give what drives or runs a motion after its hit."""
    timeline = draft(prompt).timeline_system
    assert timeline is not None
    assert len(timeline.sequence_graph.edges) == segments
