"""Sixty everyday objects, asked for by a plain noun, against sourced sizes and masses."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft

TABLE = Path(__file__).parents[3] / "data" / "asset_reference.csv"
ROWS = list(csv.DictReader(TABLE.read_text(encoding="utf-8").splitlines()))
KINDS = {"standard", "manufacturer", "encyclopedic", "estimate"}


def test_sixty_objects_have_a_source() -> None:
    assert len({r["name"] for r in ROWS}) == len(ROWS) >= 60
    for row in ROWS:
        assert row["source_kind"] in KINDS and row["source"], row["name"]


@pytest.mark.parametrize("row", ROWS, ids=[r["name"] for r in ROWS])
def test_size_and_mass_of_a_plain_noun(row: dict[str, str]) -> None:
    noun = row["prompt"]
    article = "an" if noun[0] in "aeiou" else "a"
    doc = resolve(draft(f"There is {article} {noun} on the ground."))
    made = [c for c in doc.asset_configurations.values() if c.asset_name == row["name"]]
    assert len(made) == 1, {k: c.asset_name for k, c in doc.asset_configurations.items()}
    size = sorted(float(row[f"{k}_cm"]) for k in ("length", "width", "height"))
    np.testing.assert_allclose(sorted(made[0].dimensions_cm), size, rtol=0.3)
    assert 0.5 <= made[0].mass_kg / float(row["mass_kg"]) <= 2.0
