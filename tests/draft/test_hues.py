"""Colours that nouns of other things name, and the lead vehicle."""

from __future__ import annotations

import pytest

from esg.assets.colors import find_color
from esg.draft import draft
from esg.draft import lexicon as lex


def _asset(prompt: str, node: str) -> tuple[str | None, str | None]:
    doc = draft(prompt)
    asset = doc.asset_requirement[doc.spatial_relation_graph.nodes[node].asset_id]
    return asset.color, asset.material


@pytest.mark.parametrize("hue", sorted(lex.word_set("hues")))
def test_a_hue_is_a_colour_before_a_thing_of_any_colour(hue: str) -> None:
    """Draw it in its colour, which the pictures know."""
    article = "an" if hue[0] in "aeiou" else "a"
    assert _asset(f"A ball hits {article} {hue} cube.", "cube_1")[0] == hue
    assert find_color(hue) is not None


@pytest.mark.parametrize(
    ("prompt", "node"),
    [("An olive rolls off a plate.", "olive_1"), ("A salmon leaps over a rock.", "salmon_1")],
)
def test_a_hue_alone_is_the_thing(prompt: str, node: str) -> None:
    """Keep olives and salmons what they are."""
    assert _asset(prompt, node)[0] is None


def test_the_other_of_two_hues() -> None:
    """Tell the olive cylinder from the teal one."""
    doc = draft("The olive cylinder hits the teal cylinder, and the teal cylinder topples.")
    assert len([n for n in doc.spatial_relation_graph.nodes if "cylinder" in n]) == 2


@pytest.mark.parametrize(
    ("prompt", "node", "material"),
    [
        ("The lead vehicle brakes.", "lead_vehicle_1", "steel"),
        ("A lead car stops at a junction.", "lead_car_1", "steel"),
        ("The lead cyclist falls off his bike.", "lead_cyclist_1", "cloth"),
        ("A lead ball falls on a plate.", "lead_ball_1", "lead"),
        ("A silver coupe brakes.", "silver_coupe_1", "steel"),
        ("A golden dog runs.", "golden_dog_1", "fur"),
        ("A silver ball rolls.", "silver_ball_1", "silver"),
    ],
)
def test_who_leads_is_of_no_lead(prompt: str, node: str, material: str) -> None:
    """A lead car is one that others follow; a lead ball is heavy."""
    assert _asset(prompt, node)[1] == material
