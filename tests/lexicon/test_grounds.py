"""The table of grounds, and the words of a prompt that name a row."""

from __future__ import annotations

from typing import get_args

import pytest

from esg.draft import draft, said
from esg.graph.models import Wording
from esg.lexicon.grounds import ground_said, grounds
from esg.lexicon.places import surfaces
from esg.thresholds import BRAKING_DRY_G, BRAKING_ICY_G, BRAKING_WET_G


def test_every_row_is_a_ground_with_a_source() -> None:
    named = Wording.model_fields["surface"].annotation
    assert {*grounds()} == {n for a in get_args(named) for n in get_args(a)}
    for row in grounds().values():
        assert 0.0 < row.friction <= BRAKING_DRY_G
        assert 0.0 < row.grip < BRAKING_DRY_G
        assert len(row.source) > 20
        assert row.name in surfaces() or f"{row.name}_asphalt" in surfaces(), "it has no look"
    assert (grounds()["wet"].grip, grounds()["ice"].grip) == (BRAKING_WET_G, BRAKING_ICY_G)


@pytest.mark.parametrize(
    ("prompt", "surface"),
    [
        ("A car brakes on the wet road.", "wet"),
        ("A taxi skids on a wet, narrow street into a pole.", "wet"),
        ("A bus brakes in the pouring rain.", "wet"),
        ("It is raining and a bus hits a pole.", "wet"),
        ("A child runs over the wet tiles.", "wet"),
        ("A car skids on the slippery road.", "wet"),
        ("A truck drives along a gravel road.", "gravel"),
        ("A car brakes on gravel.", "gravel"),
        ("A jeep drives across the desert.", "sand"),
        ("A ball rolls through the soft sand.", "sand"),
        ("A motorcycle slides on a muddy and bumpy track.", "mud"),
        ("A tractor drives through the mud.", "mud"),
        ("A van brakes on a snowy road.", "snow"),
        ("A car brakes in a snowstorm.", "snow"),
        ("A car skids on an icy road in the rain.", "ice"),
        ("A wet dog runs across the road.", None),
        ("A robot bumps into a wet floor sign.", None),
        ("A ball rolls into a rain barrel.", None),
        ("A ball hits a sand castle.", None),
        ("A truck loaded with gravel hits a wall.", None),
        ("A ball rolls on the ice cream van.", None),
        ("A boy throws a snowball at a wall.", None),
        ("A cup slides off the wet counter.", None),
    ],
)
def test_a_prompt_says_what_its_ground_is(prompt: str, surface: str | None) -> None:
    told = said.wording(prompt)
    assert (told.surface if told else None) == surface


def test_indoors_no_rain_is_felt() -> None:
    assert said.wording("A cup falls in the rain.", "indoor") is None
    told = said.wording("A cup falls on the wet floor.", "indoor")
    assert told is not None and told.surface == "wet"


def test_the_words_of_a_ground_stand_where_they_say() -> None:
    text = "A mop stands on the wet floor."
    assert [(n, text[a:b]) for n, a, b in ground_said(text)] == [("wet", "wet floor")]


def _owned_up(prompt: str) -> list[str]:
    statements = draft(prompt).statements or ()
    return [s.text for s in statements if s.predicate.value == "not_represented"]


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A child runs on the wet tiles and hits a bucket.", []),
        ("A van slides on a muddy field and hits a fence.", []),
        ("A van slides on a muddy track and hits a fence.", ["muddy"]),  # drawn of asphalt
        ("A car brakes on an oily road.", ["oily"]),
        ("A truck drives along a bumpy road and stops.", ["bumpy"]),
        ("A cart rolls over the dusty floor into a box.", ["dusty"]),
    ],
)
def test_what_no_row_tells_of_is_owned_up_to(prompt: str, words: list[str]) -> None:
    assert _owned_up(prompt) == words


def test_no_road_leads_over_sand_that_is_driven_on() -> None:
    assert "road_1" not in draft("A jeep drives across the sand.").spatial_relation_graph.nodes
    assert "road_1" in draft("A jeep drives past a barrel.").spatial_relation_graph.nodes
