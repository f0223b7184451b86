"""What the table of stand-ins says is what the library draws, and is owned up to."""

import csv
from typing import Any

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.draft import lexicon as lex
from esg.graph.models import Predicate


def rows() -> list[dict[str, Any]]:
    with open(lex.DATA / "stand_ins.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter=";"))


@pytest.mark.parametrize("row", rows(), ids=lambda row: row["nouns"].partition("|")[0])
def test_the_library_draws_what_the_row_says(row: dict[str, Any]) -> None:
    """A row that holds no longer, because there is a drawing now, is to be deleted."""
    drawn = row["drawn"].replace(" ", "_")
    for noun in row["nouns"].split("|"):
        doc = resolve(draft(f"A ball hits the {noun}."))
        names = {c.asset_name for c in doc.asset_configurations.values()}
        assert drawn in names or f"plain_{drawn}" in names, (noun, names)


@pytest.mark.parametrize("row", rows(), ids=lambda row: row["nouns"].partition("|")[0])
def test_the_example_owns_up(row: dict[str, Any]) -> None:
    told = draft(row["example"]).statements or ()
    lost = [s for s in told if s.predicate is Predicate.NOT_REPRESENTED]
    assert any(row["drawn"] in s.note and "stand-in" in s.note for s in lost), told
