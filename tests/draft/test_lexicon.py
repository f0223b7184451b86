"""The lexicon: breadth, plausible physics, forms, and light imports."""

from __future__ import annotations

import subprocess
import sys

import pytest

from esg.draft import draft
from esg.draft import lexicon as lex
from esg.draft.discourse.referents.surroundings import Beside, rows


def test_breadth() -> None:
    """At least 250 kinds of objects with many more names."""
    assert len({n.name for n in lex.nouns().values()}) >= 250
    assert len(lex.nouns()) >= 900


def test_masses_and_sizes_are_plausible() -> None:
    """Densities over the bounding box lie between a balloon and lead."""
    for noun in {n.name: n for n in lex.nouns().values()}.values():
        if "structural" in noun.traits or "decal" in noun.traits:
            continue
        length, width, height = noun.dimensions_cm
        density = noun.mass_kg / (length * width * height * 1e-6)
        assert 0.3 <= density <= 12_000.0, noun.name


def test_every_noun_drafts_to_a_valid_scene() -> None:
    """Every entry of the lexicon can stand in a scene."""
    from esg.graph import verify

    for name in sorted({n.name for n in lex.nouns().values() if n.kind != "region"}):
        doc = draft(f"There is a {name} and a wooden box.")
        assert not verify(doc), name
        assert len(doc.spatial_relation_graph.nodes) >= 2, name


def test_irregular_and_doubled_forms() -> None:
    """Inflected forms lead to their lemma."""
    for word, lemma in (("struck", "strike"), ("thrown", "throw"), ("stopped", "stop"), ("hitting", "hit"),
                        ("fell", "fall"), ("collides", "collide"), ("pushes", "push"), ("flies", "fly")):  # fmt: skip
        assert lemma in {v.lemma for v in lex.verb_forms()[word]}


def test_import_is_light() -> None:
    """Importing the room loads neither spaCy nor pydantic models of other rooms."""
    code = (
        "import sys, esg.draft; sys.exit(any(m in sys.modules for m in ('spacy', 'yaml', 'warp')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize("row", rows(), ids=lambda r: r.example)
def test_a_word_names_what_its_row_says_beside_another_thing(row: Beside) -> None:
    """In its example, of which the other thing is gone in a second one."""
    found = {n.asset_id for n in draft(row.example).spatial_relation_graph.nodes.values()}
    assert row.names.replace(" ", "_") + "_01" in found
    alone = draft(f"A {row.word} hits a wall.").spatial_relation_graph.nodes
    assert row.names.replace(" ", "_") + "_01" not in {n.asset_id for n in alone.values()}
