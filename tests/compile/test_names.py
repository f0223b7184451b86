from __future__ import annotations

import re

from hypothesis import given
from hypothesis import strategies as st
import pytest

from esg.compile.names import comment, identifier, string_literal, unique_identifiers

HOSTILE = [
    "class", "none", "Ground", "3 balls", "", "  ", "漢字", "é clair", "a*/b", "x // y", 'q"uote',
    "new\nline", "#include <x>", "??/", "%s%n", "a\\", "TEXT(", "int", "ball A", "ball_a", "Ball-A",
    "x" * 300, "emoji 🎳", "\u202eevil", "\0",
]  # fmt: skip


@given(st.text())
def test_any_text_becomes_a_cpp_identifier(text: str) -> None:
    assert re.fullmatch(r"[A-Za-z][A-Za-z0-9_]{0,70}", identifier(text))


@given(st.lists(st.text(), unique=True))
def test_identifiers_differ_ignoring_case(texts: list[str]) -> None:
    out = unique_identifiers(texts)
    assert list(out) == texts
    assert len({v.lower() for v in out.values()}) == len(texts)


def test_similar_names_stay_readable() -> None:
    assert unique_identifiers(["ball A", "ball_a", "trash_bin_1", "pin_1_2"]) == {
        "ball A": "BallA",
        "ball_a": "BallA_2",
        "trash_bin_1": "TrashBin1",
        "pin_1_2": "Pin1_2",
    }


def test_repeated_names_are_refused() -> None:
    with pytest.raises(ValueError, match="'a' appears twice"):
        unique_identifiers(["a", "a"])


def test_unreals_empty_name_is_avoided() -> None:
    assert identifier("none").lower() != "none"


@given(st.text())
def test_literals_hold_no_loose_quote_escape_or_trigraph(text: str) -> None:
    inner = string_literal(text)[len('TEXT("') : -len('")')]
    assert (inner.isascii() and inner.isprintable()) or inner == ""
    assert re.fullmatch(r'(?:[^"\\]|\\["\\?])*', inner)
    assert "??" not in inner


@given(st.text())
def test_comments_cannot_be_left(text: str) -> None:
    out = comment(text)
    assert not set(out) & set('*/\\"#?\n\r%<>') and out.isascii()


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_samples(text: str) -> None:
    assert re.fullmatch(r"[A-Za-z]\w*", identifier(text), re.ASCII)
