"""Prompts as people paste them: markup, data, other languages, contradictions, endless text."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument
from esg.outcomes import UserError


def mentioned(doc: EsgDocument) -> set[str]:
    return {n for n, v in doc.spatial_relation_graph.nodes.items() if v.mentioned}


@pytest.mark.parametrize(
    "prompt",
    [
        "<p>A <b>red ball</b> hits a <i>blue box</i>.</p><script>alert(1)</script>",
        "# Scene\n\n- A red ball\n- A blue box\n\n**Action:** the red ball hits the blue box.",
        '{"id": 7, "prompt": "A red ball hits a blue box."}',
        "A RED BALL HITS A BLUE BOX.",
        "A red ball 🔴 hits a blue box 📦!!!",
        "A\tred\tball\nhits a blue box.",
        "See https://example.com/a?b=c: a red ball hits a blue box.",
        "1. A red ball rolls.\n2. It hits a blue box.",
        "A red ball hits a blue box at $v = 5\\,\\mathrm{m/s}$.",
        "Can a red ball hit a blue box?",
        "Yesterday a red ball hit a blue box.",
    ],
)
def test_markup_is_no_object(prompt: str) -> None:
    doc = draft(prompt)
    assert mentioned(doc) - {"ground_1"} == {"red_ball_1", "blue_box_1"}
    assert doc.timeline_system is not None
    assert any(n.event.value == "Collision" for n in doc.timeline_system.sequence_graph.nodes)
    assert not verify(doc)


@pytest.mark.parametrize(
    ("prompt", "says"),
    [
        ('{"objects": ["ball", "box"], "events": []}', "JSON"),
        ("x" * 5000, "without a space"),
        ("A ball hits a box. " * 600, "objects"),
        ("Das Auto hits the wall und dann stops.", "another language"),
        ("The box is 2 m tall. The box, which is 1 m tall, is hit by a ball.", "contradicts"),
        ("A ball weighs 10 kg. The 5 kg ball hits a box.", "contradicts"),
        ("A ball of -3 kg hits a box.", "negative"),
        ("A car drives at 400000 km/s into a wall.", "light"),
    ],
)
def test_what_cannot_be_drafted_is_refused_in_one_sentence(prompt: str, says: str) -> None:
    with pytest.raises(UserError, match=says):
        draft(prompt)


def test_a_story_longer_than_the_longest_scene_is_refused() -> None:
    hits = " ".join("Then the ball hits the box again." for _ in range(400))
    with pytest.raises(UserError, match="Split it"):
        draft(f"A ball hits a box. {hits}")


def test_a_decimal_comma_is_read() -> None:
    timeline = draft("A ball hits a wall at 1,5 m/s.").timeline_system
    assert timeline is not None
    assert timeline.sequence_graph.edges[0].params.speed == pytest.approx(150.0)


def test_an_object_larger_than_any_is_reported() -> None:
    doc = draft("A box 10 km tall is hit by a ball.")
    assert any("largest object" in w for w in doc.coverage.warnings)


def test_a_tilde_between_numbers_is_a_range() -> None:
    timeline = draft("A car hits a wall at 2~3 m/s.").timeline_system
    assert timeline is not None
    assert timeline.sequence_graph.edges[0].params.speed == pytest.approx((200.0, 300.0))


def test_a_mass_below_the_lightest_is_raised_and_reported() -> None:
    doc = draft("A feather of 0.2 g falls onto a plate.")
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes["feather_1"].asset_id]
    assert asset.expected_mass_kg == pytest.approx(1e-3)
    assert any("lightest object" in w for w in doc.coverage.warnings)
    assert not verify(doc)


@pytest.mark.parametrize(
    ("prompt", "events"),
    [
        ("A cat hits a box. A boy slides down a slide on his back.", ["Collision", "Trigger"]),
        ("A ball hits a lamp that hangs from the ceiling; the lamp stops.", ["Collision", "Stop"]),
        ("A slide leaves after 2 s.", []),
    ],
)
def test_nothing_is_carried_or_set_going_that_cannot_be(prompt: str, events: list[str]) -> None:
    doc = draft(prompt)
    assert verify(doc) == ()
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    assert [n.event.value for n in nodes if n.participants] == events
