"""Which way up a thing is in a pose, by its proportions."""

from __future__ import annotations

import pytest

from esg.lexicon.lying import AS_DRAWN, poses, ups

BOTTLE, CAR, COIN, LOG = (7.4, 7.4, 28.0), (455.0, 182.0, 146.0), (2.4, 2.4, 0.2), (200, 30, 30)
BOOK, TABLE, BICYCLE, BUS = (24, 16, 3), (120, 70, 75), (175, 60, 104), (1200, 255, 320)
CRATE = (60, 60, 60)


@pytest.mark.parametrize(
    ("pose", "size", "index"),
    [
        ("on its side", BOTTLE, 1),
        ("on its side", CAR, 1),
        ("on its side", TABLE, 1),
        ("on its side", BUS, 1),
        ("on its edge", COIN, 1),
        ("on end", LOG, 0),
        ("upright", BOOK, 0),
        ("flat", BICYCLE, 1),
        ("flat", BOTTLE, 1),
        ("tipped over", CAR, 1),
        ("overturned", CAR, 2),
        ("overturned", BOTTLE, 1),
    ],
)
def test_another_axis_points_up(pose: str, size: tuple[float, float, float], index: int) -> None:
    allowed = ups(pose, size)
    assert allowed[0][0] == index
    assert AS_DRAWN not in allowed


@pytest.mark.parametrize("size", [BOTTLE, CAR, COIN, BOOK])
def test_upside_down_is_one_way_up_only(size: tuple[float, float, float]) -> None:
    assert ups("upside down", size) == ((2, -1),)


@pytest.mark.parametrize(
    ("pose", "size"),
    [
        ("on its side", LOG),
        ("on its side", COIN),
        ("flat", BOOK),
        ("flat", CRATE),
        ("upright", BOTTLE),
        ("upright", CAR),
        ("face up", BOOK),
    ],
)
def test_it_is_drawn_so_anyway(pose: str, size: tuple[float, float, float]) -> None:
    assert ups(pose, size)[0] == AS_DRAWN


def test_every_row_has_a_rule_and_words() -> None:
    for name, row in poses().items():
        assert ups(name, BOTTLE) and row.words and 0 < row.within_deg < 90
