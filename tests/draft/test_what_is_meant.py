"""Which thing a clause is about: relative clauses, titles, participles; and acts without a hand."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, Predicate
from tests.draft.told import owned


def _who(doc: EsgDocument, event: str) -> list[str]:
    """The first participants of the events of a kind."""
    assert doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    return [n.participants[0] for n in nodes if n.event.value == event]


@pytest.mark.parametrize(
    ("prompt", "event", "who"),
    [
        ("A taxi taps the barrel standing at the kerb, which tips over.", "Topple", "barrel_1"),
        ("A goat bumps the jug standing on the table, which falls off.", "Fall", "jug_1"),
        ("A cart hits a broom leaning against a wall, which falls over.", "Topple", "broom_1"),
        ("A van skids into a hydrant next to a bus stop, which tips over.", "Topple", "hydrant_1"),
        ("A goat butts a boy near a ladder, who falls over.", "Topple", "boy_1"),
        ("A pig bumps into a table with a vase, which falls off.", "Fall", "vase_1"),
        ("A cat pushes a pen across the desk and against a glass, which falls over.",
         "Topple", "glass_1"),
    ],
)  # fmt: skip
def test_a_relative_clause_of_falling_is_about_what_stands_there(
    prompt: str, event: str, who: str
) -> None:
    """Let that fall which is somewhere, and not where it is."""
    assert _who(draft(prompt), event) == [who]


@pytest.mark.parametrize(
    ("prompt", "event", "who"),
    [
        ("A jar on a shelf. It falls off and breaks.", "Fall", "jar_1"),
        ("Close-up of a candle on a piano. It tips over.", "Topple", "candle_1"),
        ("A robot next to a conveyor belt. It turns around.", "HeadingReached", "robot_1"),
        ("Putting a box upright on the shelf and then it falls over.", "Topple", "box_1"),
    ],
)
def test_it_means_the_first_thing_of_a_title(prompt: str, event: str, who: str) -> None:
    """Take "it" for the head of a sentence without a verb, or for what is put somewhere."""
    assert _who(draft(prompt), event) == [who]


@pytest.mark.parametrize(
    "prompt",
    [
        "A donkey kicks a bucket into a pond.",
        "A striker volleys the ball against a post.",
        "The tin is kicked down the road by a girl.",
    ],
)
def test_a_kick_touches_nothing_and_is_owned_up_to(prompt: str) -> None:
    """Say that what is kicked sets off by itself."""
    notes = [s.note for s in draft(prompt).statements or ()]
    assert notes.count("nothing touches it: it sets off by itself") == 1


def test_an_unseen_kick_is_none() -> None:
    """Own up to no kick where nobody is there who kicks."""
    assert owned(draft("The ball is kicked into the goal.")) == []


def test_the_way_of_what_is_kicked_is_still_asked_for() -> None:
    """State the way over the wall, which is measured."""
    doc = draft("A child kicks a ball over the garden wall.")
    assert owned(doc) == ["kicks"]
    over = [s for s in doc.statements or () if s.direction == "across"]
    assert [(s.object, s.target) for s in over] == [(("ball_1",), ("wall_1",))]


def test_a_second_leap_is_asked_for_its_own() -> None:
    """Own up to a leap that is none, whatever leap was told before."""
    doc = draft("A kangaroo jumps over a log and hops away.")
    assert owned(doc) == ["hops"]


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball rolls under a van, comes out on the other side and ends up in a trench.",
        "A cat runs under the table and jumps onto a chair.",
    ],
)
def test_who_goes_on_does_not_end_under_a_thing(prompt: str) -> None:
    """Own up to the way under it instead."""
    doc = draft(prompt)
    assert not [s for s in doc.statements or () if s.predicate is Predicate.UNDER]
    assert any(text.startswith("under") for text in owned(doc))


def test_who_stays_there_ends_under_it() -> None:
    """Ask for the end that is told."""
    says = draft("A ball rolls under a van and stays there.").statements or ()
    assert [(s.when, s.target) for s in says if s.predicate is Predicate.UNDER] == [
        ("end", ("van_1",))
    ]


def test_the_load_of_a_lorry_is_no_load_of_lorries() -> None:
    """Draw one lorry, and own up to its load."""
    doc = draft("The load of the lorry slides against a fence.")
    nodes = doc.spatial_relation_graph.nodes
    assert [n for n in nodes if n.startswith("lorry")] == ["lorry_1"]
    assert any("load" in warning for warning in doc.coverage.warnings)


def test_the_light_that_changes_is_a_traffic_light() -> None:
    """Draw no second robot for it."""
    nodes = draft("A robot waits for the light to change.").spatial_relation_graph.nodes
    assert {n for n, x in nodes.items() if x.mentioned} == {"robot_1", "traffic_light_1"}


def test_the_ship_that_has_a_deck_is_not_on_it() -> None:
    """Put no ship onto its own deck: what rolls off the deck stands on the ship."""
    doc = draft("A barrel rolls off the deck of a boat.")
    graph = doc.spatial_relation_graph
    region = graph.nodes["boat_1"].semantic_region or ""
    assert graph.semantic_regions[region].parent_object == "ground_1"
    on = graph.semantic_regions[graph.nodes["barrel_1"].semantic_region or ""]
    assert on.parent_object == "boat_1" and owned(doc) == []


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A clerk loses his balance and falls over.", "loses his balance"),
        ("A paper boat floats along a trench until it gets stuck on a stone.", "gets stuck"),
        ("A man looks angry and walks to a table.", "looks angry"),
        ("A horse refuses the first fence and stops.", "refuses"),
    ],
)
def test_what_passes_without_a_trace_is_owned_up_to(prompt: str, words: str) -> None:
    """Say that nothing stands for it."""
    assert words in owned(draft(prompt))


@pytest.mark.parametrize(
    ("prompt", "who"),
    [
        ("A nurse lets go of a curling stone. It glides past a bench.", "curling_stone_1"),
        ("A child lets go of a balloon and it rises to the ceiling.", "balloon_1"),
        ("Two carts are released and roll toward each other.", "cart_1"),
    ],
)
def test_what_is_let_go_and_goes_its_way_does_not_fall(prompt: str, who: str) -> None:
    """Tell no fall of what glides, rises or rolls once it is free."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    assert who in {p for n in nodes for p in n.participants}
    assert "Fall" not in {n.event.value for n in nodes}


def test_what_has_a_lid_on_a_hinge_stays_what_it_is_when_something_drops_into_it() -> None:
    """Draw the body of the chest, which is open, and no box without a hinge."""
    doc = draft("The lid of a wooden chest swings up. A ball drops into the chest.")
    key = doc.spatial_relation_graph.nodes["chest_1"].asset_id
    assert doc.asset_requirement[key].asset_category == "chest_body"
