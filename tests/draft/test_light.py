"""Words for light and weather: what the skies show is represented, the rest is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import Predicate
from esg.lexicon.places import skies, sky_words


def owned(prompt: str) -> list[str]:
    """Words that a draft says it does not represent."""
    doc = draft(prompt)
    return [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]


@pytest.mark.parametrize(
    "prompt",
    [
        "In the evening a car drives along the street and hits a barrel.",
        "A car drives at night and hits a barrel.",
        "At sunset a boy throws a ball.",
        "On a sunny day a dog runs across a lawn.",
        "A dog runs across the street in the golden hour.",
        "A ball rolls through a shop at noon.",
        "A dog runs through the snow.",
        "A boy throws a ball in a park.",
        "On a rainy street, a car brakes and hits a pole.",
        "A car drives in heavy rain and hits a tree.",
        "It is snowing and a car hits a tree.",
        "A foggy road. A truck drives along it.",
        "During a storm a tree falls on a car.",
    ],
)
def test_what_the_place_and_its_sky_show_is_represented(prompt: str) -> None:
    assert owned(prompt) == []


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A car drives past a rainbow and hits a tree.", ["a rainbow"]),
        ("Lightning flashes and a car hits a tree.", ["Lightning", "flashes"]),
        ("A ball rolls across the office floor in the moonlight.", ["moonlight"]),
    ],
)
def test_what_no_picture_shows_is_owned_up_to(prompt: str, words: list[str]) -> None:
    assert owned(prompt) == words


def test_one_table_decides_and_no_word_is_both() -> None:
    for setting in ("indoor", "outdoor"):
        shown, not_shown = sky_words(setting)
        assert not shown & not_shown
        for row in skies().values():
            if row.setting == setting:
                assert {*row.said_as} <= shown
    assert "evening" in sky_words("outdoor")[0] and "moonlight" in sky_words("indoor")[1]
