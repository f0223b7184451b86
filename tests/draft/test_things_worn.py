"""Clothes are no bodies; nouns that are also verbs; times told by the clock."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.outcomes import UserError
from tests.draft.told import events


@pytest.mark.parametrize(
    ("prompt", "nodes"),
    [
        ("A woman in a red dress is hit by a bicycle.", {"woman_1", "bicycle_1"}),
        ("A man wearing a helmet and gloves walks into a post.", {"man_1", "post_1"}),
        ("A man in a coat and a scarf walks into a post.", {"man_1", "post_1"}),
        ("A woman with glasses walks into a post.", {"woman_1", "post_1"}),
        ("A woman wears a hat and walks into a post.", {"woman_1", "post_1"}),
        # named again, thrown, or no clothes
        ("A dog bumps a man with a hat, and the hat falls off.", {"dog_1", "man_1", "hat_1"}),
        ("A boy throws his cap at a cat.", {"boy_1", "cap_1", "cat_1"}),
        ("A man with a suitcase walks into a post.", {"man_1", "suitcase_1", "post_1"}),
    ],
)
def test_clothes(prompt: str, nodes: set[str]) -> None:
    doc = draft(prompt)
    assert verify(doc) == ()
    drawn = set(doc.spatial_relation_graph.nodes) - {"ground_1", "road_1"}
    assert drawn == nodes
    assert not [w for w in doc.coverage.warnings if "not understood" in w]


@pytest.mark.parametrize(
    ("prompt", "pair"),
    [
        ("A seal hits another seal.", ("seal_1", "second_seal_1")),
        ("A steel hook hits a box.", ("hook_1", "box_1")),
        ("The saw is hit by a ball.", ("ball_1", "saw_1")),
        ("Another horn rolls into a crate.", ("horn_1", "crate_1")),
        ("A ball rolls into the tap.", ("ball_1", "tap_1")),
        ("A steel ball bearing hits a marble.", ("steel_ball_bearing_1", "marble_1")),
    ],
)
def test_things_named_like_verbs(prompt: str, pair: tuple[str, str]) -> None:
    hits = [e for e in events(prompt) if e[0] == "Collision"]
    assert len(hits) == 1
    assert {n.split("_")[-2] for n in hits[0][1:]} == {n.split("_")[-2] for n in pair}


def test_two_heights_contradict() -> None:
    with pytest.raises(UserError, match="100 cm and 200 cm"):
        draft("A ball is dropped from 1 m. The ball is dropped from 2 m onto a box.")
