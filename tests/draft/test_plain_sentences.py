"""Plain sentences whose verb, outcome or small word was lost: leaving again, attempts, through."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.dynamics.story.story import POWERED
from esg.graph.models import EsgDocument, NodeEvent, Predicate


def events(doc: EsgDocument) -> list[NodeEvent]:
    """The point events of a draft, in order, without triggers."""
    timeline = doc.timeline_system
    nodes = timeline.sequence_graph.nodes if timeline is not None else ()
    unmeasured = (NodeEvent.TRIGGER, NodeEvent.SCENE_START)
    return [n.event for n in nodes if n.event not in unmeasured]


def owned(doc: EsgDocument) -> list[str]:
    """The words that a draft owns up to."""
    lost = Predicate.NOT_REPRESENTED
    return [s.text for s in doc.statements or () if s.predicate is lost]


def held(doc: EsgDocument) -> set[tuple[str, str]]:
    """Who is on what that is no ground."""
    graph = doc.spatial_relation_graph
    regions = (
        (n, graph.semantic_regions.get(x.semantic_region or "")) for n, x in graph.nodes.items()
    )
    return {
        (n, r.parent_object)
        for n, r in regions
        if r is not None and not graph.nodes[r.parent_object].is_structural
    }


@pytest.mark.parametrize(
    "prompt",
    [
        "The dog tried to sit on the cat.",
        "A dog tries to stand on a box.",
        "The cat did not sit on the chair.",
        "A boy wants to sit on a chair.",
        "A man almost sits on a cat.",
    ],
)
def test_nobody_is_put_where_he_only_tries_to_be(prompt: str) -> None:
    """A place that is tried, wished, denied or nearly taken is no place at the start."""
    assert not held(draft(prompt))


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A dog walks to a cat and walks away.", [NodeEvent.REACH, NodeEvent.HEADING_REACHED]),
        ("A boy runs to his mother and runs back.", [NodeEvent.REACH, NodeEvent.HEADING_REACHED]),
        ("A dog walks up to a cat and backs away slowly.", [NodeEvent.REACH]),
        ("A car drives to a gate and drives off.", [NodeEvent.REACH]),
    ],
)
def test_who_reached_something_leaves_it_again(prompt: str, told: list[NodeEvent]) -> None:
    """What comes after an arrival is a motion of its own, which begins there."""
    doc = draft(prompt)
    assert doc.timeline_system is not None and events(doc) == told
    reach = next(n for n in doc.timeline_system.sequence_graph.nodes if n.event is NodeEvent.REACH)
    assert any(e.from_ == reach.id for e in doc.timeline_system.sequence_graph.edges)


@pytest.mark.parametrize(
    "prompt",
    [
        "A car drives up to a gate, stops and reverses.",
        "A truck hits a wall and reverses.",
        "A forklift drives to a rack, stops and backs up.",
    ],
)
def test_what_came_forward_backs_away(prompt: str) -> None:
    """The last of its motions goes tail first, and none before it."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    ways = [e for e in doc.timeline_system.sequence_graph.edges if e.event in POWERED]
    assert [bool(e.params.backward) for e in ways] == [False] * (len(ways) - 1) + [True]


def test_before_another_event_nothing_backs_away() -> None:
    """What follows would be planned ahead of it."""
    doc = draft("A forklift approaches a pallet, stops in front of it, reverses and hits a pillar.")
    assert doc.timeline_system is not None
    assert not any(e.params.backward for e in doc.timeline_system.sequence_graph.edges)


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("The baby keeps dropping her spoon.", "keeps"),
        ("A man keeps falling off a chair.", "keeps"),
        ("Three ice cubes slide along a counter and stop.", "stop"),
        ("Five marbles roll down a ramp and drop into a cup.", "drop"),
        ("A chandelier falls through the dining table.", "through the dining table"),
        ("A truck drives through a wall.", "through a wall"),
        ("A piano falls through the floor.", "through the floor"),
        ("A bus stops and its doors open.", "its doors"),
        ("The van's door flies open.", "The van's door"),
        ("A train stops, the doors open and a dog gets out.", "the doors"),
        ("The pipes rolled off both sides of the trailer.", "off both sides of the trailer"),
        ("The logs fall off either side of the truck.", "off either side of the truck"),
        ("The boy drove his toy truck into a sofa.", "drove"),
        ("A cook leaves a tap running and walks out.", "leaves a tap running"),
        ("A batter swings at a ball and misses.", "swings at"),
        ("A worker took the sign down.", "took"),
    ],
)
def test_what_is_lost_is_owned_up_to(prompt: str, words: str) -> None:
    """No verb and no small word goes without a word."""
    assert words in owned(draft(prompt))


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A bottle stands upright on a table.", "upright"),
        ("A car drives through a fence.", "through a fence"),
        ("A ball rolls through a tunnel.", "through a tunnel"),
        ("A ball keeps bouncing.", "keeps"),
        ("A door of a house opens.", "A door"),
        ("The driver honked, but the man walked out in front of him anyway.", "anyway"),
    ],
)
def test_what_is_shown_is_not_owned_up_to(prompt: str, words: str) -> None:
    """A false alarm is a fault, too."""
    assert words not in owned(draft(prompt))


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A batter swings at a ball and misses.", [NodeEvent.MISS]),
        ("A cat swipes at a vase but misses it.", [NodeEvent.MISS]),
        ("A man drives past a gate instead of waiting for it to open.", [NodeEvent.MISS]),
        (
            "A wrecking ball hits a tower and brings it down.",
            [NodeEvent.COLLISION, NodeEvent.TOPPLE],
        ),
        ("The wind brought the fence down.", [NodeEvent.TOPPLE]),
        ("A worker took the sign down.", []),
    ],
)
def test_outcomes(prompt: str, told: list[NodeEvent]) -> None:
    """What is missed, waited for by nobody, or brought down."""
    assert events(draft(prompt)) == told


@pytest.mark.parametrize(
    "prompt",
    ["A man slides down the wall.", "A boy slides down a pole.", "The bricks come tumbling down."],
)
def test_no_slope_is_laid_for_what_stands(prompt: str) -> None:
    """A wall and a pole are no slopes, nor does what comes down need one."""
    nodes = draft(prompt).spatial_relation_graph.nodes
    assert not any(name.startswith("ramp") for name in nodes)


@pytest.mark.parametrize(
    "prompt",
    ["A parcel lands on the far side of a gate.", "A cow stands on the other side of the fence."],
)
def test_the_far_side_is_behind(prompt: str) -> None:
    """What is on the other side of a fence is not on it."""
    doc = draft(prompt)
    assert NodeEvent.COLLISION not in events(doc) and not held(doc)
    stated = {s.predicate for s in doc.statements or ()}
    beside = {r.relation_type.value for r in doc.spatial_relation_graph.edges.binary_relations}
    assert Predicate.BEHIND in stated or "behind" in beside


def test_the_drivers_side_is_a_side() -> None:
    """Left or right, as countries differ."""
    doc = draft("A white van pulls out without stopping and is hit on the driver's side by a bus.")
    struck = [s for s in doc.statements or () if s.predicate is Predicate.STRUCK_ON]
    assert [(s.side, s.text) for s in struck] == [("side", "on the driver's side")]
    assert events(doc) == [NodeEvent.COLLISION]
