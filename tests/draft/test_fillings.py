"""What vessels are filled with, what floats and sinks in it, and what of it is owned up to."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.draft.lexicon import word_set
from esg.draft.statements.looks.contents import AS_IT_IS, NO_SPLASH, SPILLS
from esg.graph.models import EsgDocument, NodeEvent, Predicate
from esg.lexicon.contents import CONTENT, contents, contents_said, densities


def told(doc: EsgDocument) -> set[str]:
    """Statements in short: predicate, what of, what with."""
    return {
        f"{s.predicate.value} {s.noun or ' '.join(s.target)} {s.text!r}"
        for s in doc.statements or ()
        if s.predicate is not Predicate.NOT_REPRESENTED
    }


def owned(doc: EsgDocument) -> set[tuple[str, str]]:
    found = (s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED)
    return {(s.text, s.note) for s in found}


@pytest.mark.parametrize(
    ("prompt", "says"),
    [
        ("A ball falls into a bucket filled with water.", "filled_with water 'filled with water'"),
        ("A glass of milk stands on a tray.", "filled_with milk 'of milk'"),
        ("A bucket is half full of sand.", "filled_with sand 'is half full of sand'"),
        ("A water-filled bucket stands on a table.", "filled_with water 'water-filled'"),
        ("A bowl contains soup.", "filled_with soup 'contains soup'"),
        ("A stone falls into the water in a bowl.", "filled_with water 'the water in'"),
        ("A tennis ball floats in a bathtub.", "floats bathtub_1 'floats'"),
        (
            "A cork is placed on the surface of a bowl of water.",
            "inside bowl_1 'on the surface of'",
        ),
        ("An egg sinks in a glass of water.", "sinks glass_1 'sinks'"),
        (
            "A stone is dropped into a bowl of water and sinks to the bottom.",
            "sinks bowl_1 'sinks to the bottom'",
        ),
        ("A bucket is filled with water. A cork floats on the water.", "floats bucket_1 'floats'"),
    ],
)
def test_what_is_in_a_vessel_is_stated_and_nothing_of_it_owned_up_to(prompt, says):
    doc = draft(prompt)
    assert says in told(doc)
    assert not owned(doc)
    for s in doc.statements or ():
        assert prompt[s.start : s.end] == s.text
    for item in doc.coverage.items:
        assert prompt[item.start : item.end] == item.text


@pytest.mark.parametrize(
    ("prompt", "words", "why"),
    [
        ("A glass of water falls off a table.", "of water", SPILLS),
        ("A man throws a bucket of water at a wall.", "of water", SPILLS),
        ("A cat knocks over a glass of milk.", "of milk", SPILLS),
        ("A spoon stands in a cup of hot coffee.", "hot", AS_IT_IS),
        ("A ball splashes into a bucket of water.", "splashes", NO_SPLASH),
        ("A ball splashes into a pool.", "splashes", NO_SPLASH),
    ],
)
def test_what_no_level_shows_is_owned_up_to(prompt, words, why):
    assert (words, why) in owned(draft(prompt))


@pytest.mark.parametrize(
    "prompt",
    [
        "A man fills a glass with water.",
        "A cup of coffee beans falls off a table.",
        "A glass is filled with water by a man.",
        "A jar filled with marbles stands on a table.",
        "Water is poured into a glass.",
    ],
)
def test_what_is_poured_or_no_content_fills_nothing(prompt):
    assert not any(says.startswith("filled_with") for says in told(draft(prompt)))


def test_each_vessel_of_several_has_its_own():
    doc = draft("Two glasses of red wine and a jug of orange juice stand on a table.")
    filled = {s.noun: s.object for s in doc.statements or ()}
    assert filled == {"wine": ("glass_1", "glass_2"), "juice": ("jug_1",)}


def test_the_water_of_a_bucket_is_the_bucket():
    doc = draft("A bucket is filled with water. A ball falls into the water.")
    assert set(doc.spatial_relation_graph.nodes) == {"ground_1", "bucket_1", "ball_1"}
    timeline = doc.timeline_system.sequence_graph
    assert next(n.region for n in timeline.nodes if n.event is NodeEvent.ENTER_REGION) == (
        "bucket_1/inside"
    )


def test_drops_of_water_are_small_beads():
    doc = draft("Three drops of water fall onto a leaf.")
    drops = [n for n in doc.spatial_relation_graph.nodes if n.startswith("droplet")]
    assert len(drops) == 3
    config = resolve(doc).asset_configurations
    asset = config[doc.spatial_relation_graph.nodes[drops[0]].asset_id]
    assert max(asset.dimensions_cm) < 1.0


@pytest.mark.parametrize("vessel", sorted(word_set("filled vessels")))
def test_every_vessel_that_may_be_filled_holds_something(vessel):
    """Its level is drawn in it, its weight counted; what is loose carries."""
    doc = resolve(draft(f"A {vessel} of sand stands on the ground."))
    filled = [c for c in doc.asset_configurations.values() if c.contents is not None]
    assert len(filled) == 1
    (region,) = (r for r in filled[0].regions if r.kind == CONTENT)
    (mouth,) = (r for r in filled[0].regions if r.kind == "inside")
    empty = resolve(draft(f"A {vessel} stands on the ground.")).asset_configurations
    key = next(k for k, c in doc.asset_configurations.items() if c.contents is not None)
    level = region.center_cm[2] + region.half_extents_cm[2]
    assert mouth.center_cm[2] - mouth.half_extents_cm[2] == pytest.approx(level)
    if key in empty and any(r.kind == "inside" for r in empty[key].regions):
        assert filled[0].mass_kg > empty[key].mass_kg
        assert len(filled[0].proxies) == len(empty[key].proxies) + 1


def test_the_tables_are_sound():
    for row in contents().values():
        assert row.source
        assert 0.0 < row.alpha <= 1.0
        assert 10.0 < row.density < 15000.0
        assert (row.viscosity > 0.0) is row.liquid
    said = [w for row in contents().values() for w in (row.name, *row.said_as)]
    assert len(said) == len(set(said)) == len(contents_said())
    assert min(densities().values()) > 1000.0


@pytest.mark.parametrize(
    "prompt",
    [
        "Slow motion close-up of an apple falling into a bucket of water.",
        "Aerial view of a drop of water falling into a bowl.",
        "A stone falls into a bowl of water.",
    ],
)
def test_what_is_taken_out_to_be_read_is_told_as_it_was(prompt: str) -> None:
    """Leave no holes where a heading, a content or a drop stood."""
    doc = draft(prompt)
    assert doc.scene_definition.expanded_description.startswith(prompt)
    told = (*doc.coverage.items, *(doc.statements or ()))
    assert [prompt[t.start : t.end] for t in told] == [t.text for t in told]
