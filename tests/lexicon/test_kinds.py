"""The table of kinds: one size and mass a kind, one spelling a column, drawings that agree."""

from __future__ import annotations

from collections import Counter
import csv

import numpy as np
import pytest

from esg.assets.library.catalogue import catalogue, entries_by_name, parts, policy
from esg.draft import lexicon as lex
from esg.lexicon import kinds, plural, singular
from esg.lexicon.kinds import NEAR, TABLE

SHAPES = {"sphere", "box", "cylinder", "capsule", "compound", ""}


def test_every_row_is_a_noun_or_a_drawing_with_a_size_and_a_mass() -> None:
    for row in kinds():
        assert row.kind or row.builder, row.name
        assert min(*row.dimensions_cm, row.mass_kg) > 0, row.name
        assert bool(row.request) >= bool(row.kind) and row.shape in SHAPES, row.name
        assert bool(row.builder) == bool(row.parents) == bool(row.surface), row.name


def test_names_are_unique_among_nouns_and_among_drawings() -> None:
    for part in (
        [k.name for k in kinds() if k.kind],
        [k.slug for k in kinds() if k.builder],
    ):
        assert [name for name, count in Counter(part).items() if count > 1] == []


def test_homonyms_are_the_few_names_that_stand_twice() -> None:
    counts = Counter(k.name for k in kinds())
    assert {name for name, count in counts.items() if count > 1} == {
        "goal",
        "gold bar",
        "tunnel",
    }


def test_cells_hold_no_stray_blanks() -> None:
    with TABLE.open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            for column in ("name", "said_as", "traits", "parents", "params", "flags", "found_as"):
                words = row[column].split(";") if row[column] else []
                assert all(w == w.strip() and w for w in words), (row["name"], column)


def test_drafter_and_library_read_the_same_mass_and_size() -> None:
    both = [k for k in kinds() if k.kind and k.builder]
    assert len(both) > 250
    for kind in both:
        noun, entry = lex.nouns()[kind.name], entries_by_name()[kind.slug]
        ratio = np.prod(entry.dimensions_cm) / np.prod(noun.dimensions_cm)
        same = NEAR**-3 <= ratio <= NEAR**3
        assert entry.mass_kg == pytest.approx(noun.mass_kg * (1.0 if same else ratio)), kind.name
        if kind.drawn_cm is None:
            assert sorted(entry.dimensions_cm) == sorted(noun.dimensions_cm), kind.name


def test_only_drawings_that_keep_their_proportions_have_extents_of_their_own() -> None:
    for kind in kinds():
        if kind.drawn_cm:
            entry = entries_by_name()[kind.slug]
            assert policy(entry) == "uniform" or "decal" in entry.flags, kind.name
            assert kind.drawn_cm != kind.dimensions_cm, kind.name
        assert kind.front in ("", "side"), kind.name
        assert not (kind.front and kind.drawn_cm), kind.name


@pytest.mark.parametrize(
    ("name", "size", "local"),
    [("desk", (140, 70, 75), (70, 140, 75)), ("golf ball", (4.27,) * 3, (4.27,) * 3)],
)
def test_front_across_the_length_turns_the_drawing(
    name: str, size: tuple[float, ...], local: tuple[float, ...]
) -> None:
    kind = next(k for k in kinds() if k.name == name)
    assert kind.dimensions_cm == size and kind.local_cm == local


def test_every_name_survives_plural_and_singular() -> None:
    for kind in kinds():
        for name in (kind.name, *kind.said_as):
            many = plural(name)
            if name.startswith("model "):
                continue  # single letters: "model s"
            assert singular(many) in (name, singular(name), many), name


def test_catalogue_keeps_the_order_of_the_table() -> None:
    drawn = [k for k in kinds() if k.builder]
    assert [e.name for e in catalogue()] == [k.slug for k in drawn if "part" not in k.flags]
    assert list(parts()) == [k.slug for k in drawn if "part" in k.flags]
