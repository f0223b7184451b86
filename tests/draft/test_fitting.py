"""Sizes of things that are to fit each other."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument


def length(doc: EsgDocument, name: str) -> float:
    node = doc.spatial_relation_graph.nodes[name]
    return doc.asset_requirement[node.asset_id].expected_dimensions_cm[0]


@pytest.mark.parametrize(
    ("prompt", "name"),
    [
        ("A dog jumps onto a rock.", "rock_1"),
        ("A cat sits on a rock.", "rock_1"),
        ("A goat stands on a stone.", "stone_1"),
    ],
)
def test_a_rock_is_large_enough_for_who_stands_or_leaps_on_it(prompt: str, name: str) -> None:
    alone = draft("A ball rolls past a rock.")
    assert length(draft(prompt), name) > 1.5 * length(alone, "rock_1")


def test_a_rock_keeps_a_stated_size_and_its_own_under_what_is_small() -> None:
    assert length(draft("A dog jumps onto a rock of 50 cm."), "rock_1") == pytest.approx(50.0)
    alone = length(draft("A ball rolls past a rock."), "rock_1")
    assert length(draft("A coin lies on a rock."), "rock_1") == alone


def test_a_box_is_as_wide_as_whom_it_holds_asks_for() -> None:
    alone = length(draft("A ball rolls past a box."), "box_1")
    assert length(draft("A kid hops out of a box."), "box_1") > alone
    assert length(draft("A mouse sits in a box."), "box_1") == alone
    told = draft("A kid sits in a box of 60 cm.")
    assert length(told, "box_1") == pytest.approx(60.0)
