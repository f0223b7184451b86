"""Singular and plural: rules, the table of the irregular ones, and that they agree."""

from __future__ import annotations

import csv

import pytest

from esg.lexicon import plural, singular
from esg.lexicon.morphology import TABLE

ROWS = list(csv.DictReader(TABLE.read_text(encoding="utf-8").splitlines()))


@pytest.mark.parametrize("row", ROWS, ids=[r["plural"] for r in ROWS])
def test_irregular_words_are_read_and_kept(row: dict[str, str]) -> None:
    assert row["why"]
    assert singular(row["plural"]) == row["singular"]
    assert singular(row["singular"]) == row["singular"]
    assert singular(plural(row["singular"])) == row["singular"]


@pytest.mark.parametrize(
    ("many", "one"),
    [
        ("cars", "car"), ("dishes", "dish"), ("boxes", "box"), ("vases", "vase"), ("cherries", "cherry"),
        ("pies", "pie"), ("firemen", "fireman"), ("trolleys", "trolley"), ("mattresses", "mattress"),
        ("jet skis", "jet ski"), ("shopping carts", "shopping cart"), ("prizes", "prize"),
    ],
)  # fmt: skip
def test_rules_go_both_ways(many: str, one: str) -> None:
    assert (singular(many), plural(one)) == (one, many)
    assert plural(many) == many


@pytest.mark.parametrize("word", ["grass", "walrus", "tennis", "bus", "stairs", "gas", "scissors"])
def test_words_in_s_that_are_no_plurals(word: str) -> None:
    assert singular(word) == word
