"""Slabs that are to be down before they hit the next one."""

from __future__ import annotations

import itertools
import math

import pytest

from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.story.slabs import BY_ITSELF_S, KNOCKED_S, REACH, down_first
from esg.graph.models import EsgDocument
from tests.dynamics.stories import cast

CHAIN = (
    "The first of three dominoes falls over and hits the second, the second falls over and hits "
    "the third."
)


def gaps(doc: EsgDocument) -> list[float]:
    """Gaps of placed dominoes in a row, over their height."""
    spots = [
        (p.x_cm, p.y_cm)
        for c in choreograph(doc).hints.constellations
        for p in c.placements
        if "domino" in p.node
    ]
    length, _, height = next(
        c.dimensions_cm for k, c in doc.asset_configurations.items() if "domino" in k
    )
    return [(math.dist(a, b) - length) / height for a, b in itertools.pairwise(spots)]


def height_cm(doc: EsgDocument) -> float:
    return next(c for k, c in doc.asset_configurations.items() if "domino" in k).dimensions_cm[2]


def test_a_chain_told_fall_by_fall_is_built_of_garden_dominoes() -> None:
    doc = cast(CHAIN)
    assert KNOCKED_S * math.sqrt(height_cm(doc) / 100.0) == pytest.approx(0.13, abs=0.005)
    assert gaps(doc) == pytest.approx([REACH, REACH], abs=0.02)


def test_one_that_falls_by_itself_has_more_time() -> None:
    doc = cast("A domino falls over and hits a second domino.")
    assert BY_ITSELF_S * math.sqrt(height_cm(doc) / 100.0) == pytest.approx(0.13, abs=0.005)
    assert down_first(0.6, knocked=False)
    assert not down_first(0.6, knocked=True)


@pytest.mark.parametrize(
    "prompt",
    [
        "A 20 cm tall domino falls over and hits a second 20 cm tall domino.",
        "A marble rolls into a domino, the domino topples and hits a second domino.",
        "Twelve dominoes stand in a row on a chair. The first domino falls over and hits the second.",
    ],
)
def test_sizes_stay_where_they_are_stated_or_there_is_no_room_or_a_marble_strikes(
    prompt: str,
) -> None:
    assert height_cm(cast(prompt)) < 30.0


def test_dominoes_that_only_hit_each_other_stay_small_and_a_tenth_of_a_second_apart() -> None:
    doc = cast(
        "A ball hits the first of three dominoes, the first hits the second and the second hits "
        "the third."
    )
    assert height_cm(doc) < 30.0
    assert gaps(doc) == pytest.approx([0.7, 0.7], abs=0.02)
