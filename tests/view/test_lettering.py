"""Captions: accents are drawn, and what the font lacks becomes words instead of boxes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image
import pytest

from esg.view.lettering import fitted, font, lettered, wrapped
from esg.view.sheet import Panel, write_sheet


@pytest.mark.parametrize(
    "text", ["Café, piñata, Übergröße, Łódź, смола", "3 × 4 m — “fast” → 5°", "plain"]
)
def test_accents_and_signs_are_drawn_as_they_are(text: str) -> None:
    assert lettered(text) == text


def test_every_accent_has_a_picture_of_its_own() -> None:
    drawn = {bytes(font(20).getmask(c)) for c in "eéèêëē"}
    assert len(drawn) == 6


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("🚗 hits 🗑️", "[automobile] hits [wastebasket]"),
        ("👩🏽‍🚀 jumps", "[woman][rocket] jumps"),
        ("e\u0301", "é"),
        ("ﬁsh", "fish"),
        ("中", "?"),
        ("a\u200b\u202eb\n\tc", "ab  c"),
        ("", ""),
    ],
)
def test_what_the_font_lacks_becomes_words(text: str, written: str) -> None:
    assert lettered(text) == written


@pytest.mark.parametrize("text", ["word " * 60, "x" * 400, "é" * 90 + " end", ""])
def test_lines_fit_and_lose_nothing(text: str) -> None:
    lines = wrapped(text, 14, 200)
    assert all(font(14).getlength(line) <= 200 for line in lines)
    assert "".join(lines).replace(" ", "") == text.replace(" ", "")
    assert font(14).getlength(fitted(text, 14, 200)) <= 200


def test_a_title_that_is_cut_says_so(tmp_path: Path) -> None:
    panel = Panel(np.zeros((40, 400, 3), np.uint8), "start", "t")
    heights = [
        Image.open(write_sheet(tmp_path / f"{n}.png", [panel], title="word " * n)).size[1]
        for n in (1, 300, 600)
    ]
    assert heights[0] < heights[1] == heights[2]
