"""Variety: places, lights, looks, bystanders and cameras, drawn by declared shares and said."""

from __future__ import annotations

from collections import Counter
import json
import re

import pytest

from esg.dataset.distribution import MOST_OBJECTS, Distribution, load_distribution
from esg.dataset.grammar import sample_scenes
from esg.dataset.plan import DatasetSpec, plan_scenes
from esg.dataset.variety import tables
from esg.dataset.vocabulary import VEHICLES
from esg.lexicon.places import places, skies
from esg.outcomes import UserError

ALL = Distribution(
    places={"unsaid": 2.0, **dict.fromkeys(tables.settings(), 1.0)},
    lights={"unsaid": 2.0, **dict.fromkeys(tables.lights(), 1.0)},
    colors={"unsaid": 1.0, **dict.fromkeys(tables.COLORS, 0.2)},
    materials={"unsaid": 1.0, **dict.fromkeys(tables.materials(), 0.5)},
    sizes={"unsaid": 2.0, "small": 1.0, "large": 1.0},
    variants=0.3,
    bystanders={"0": 2.0, "1-5": 2.0, "6-12": 1.0, "13-28": 1.0},
    cameras={"around": 1.0, "tracking": 2.0, "dash": 1.0},
)


def test_the_tables_name_places_and_lights_that_can_be_dressed() -> None:
    assert set(tables.settings()) <= set(places())
    assert set(tables.lights()) <= set(skies())
    for name, row in tables.settings().items():
        assert row.under == places()[name].setting


def test_a_distribution_without_variety_says_what_it_always_said() -> None:
    """Names of datasets are hashes of their plans: they stay, too."""
    spec = DatasetSpec(source="sample", n=40, seed=3, distribution=Distribution())
    assert spec.name() == "dataset-507d0bf5f180"
    text = "\n".join(s.prompt for s in sample_scenes(40, 3))
    assert "around" not in text
    assert not any("place" in s.values and " a " in s.values["place"]
                   for s in sample_scenes(40, 3))  # fmt: skip


def test_variety_leaves_the_action_as_it_is() -> None:
    plain = list(sample_scenes(60, 4))
    for before, after in zip(plain, sample_scenes(60, 4, ALL), strict=True):
        assert (before.rule, before.seed, before.family) == (after.rule, after.seed, after.family)
        kept = {k: v for k, v in before.values.items() if k not in ("color", "place")}
        assert kept.items() <= after.values.items()


def test_shares_hold_within_what_a_rule_allows() -> None:
    mix = Distribution(
        rules={"bowl": 0, "pocket": 0}, levels={"single": 1.0},
        bystanders={"0": 1.0, "4": 3.0}, cameras={"around": 1.0, "orbit": 1.0},
        places={"unsaid": 1.0, "park": 1.0},
    )  # fmt: skip
    found = list(sample_scenes(400, 2, mix))
    crowded = sum("n_bystanders" in s.values for s in found)
    assert crowded == pytest.approx(300, abs=4)
    assert sum(s.camera == "orbit" for s in found) == pytest.approx(200, abs=4)
    balls = [s for s in found if s.rule == "roll_into"]
    parks = sum(s.values.get("place") == "park" for s in balls)
    assert parks == pytest.approx(len(balls) / 2, abs=5)


def test_what_is_drawn_is_said_and_what_is_said_is_drawn() -> None:
    for scene in sample_scenes(300, 5, ALL):
        text = f" {scene.prompt.lower()}"
        values = scene.values
        for key in ("mover", "target", "middle", "item"):
            for what in ("color", "size", "material", "variant"):
                assert values.get(f"{key}_{what}", "").lower() in text
        for row in tables.lights().values():
            assert (values.get("light") == row.light) == text.startswith(f" {row.phrase}")
        if scene.values.get("place") in tables.settings():
            assert tables.settings()[scene.values["place"]].phrase in text
        assert ("around." in text) == ("n_bystanders" in values)


def test_bystanders_are_counted_and_never_of_the_kind_of_what_acts() -> None:
    for scene in sample_scenes(300, 6, ALL):
        counts = {s.noun: s.value for s in scene.expectation.statements}
        total = scene.values.get("n_bystanders", 0)
        assert sum(v for v in counts.values() if v) == total < MOST_OBJECTS
        acting = scene.prompt.split(". ")[0].lower()
        for kind in counts:
            assert not re.search(rf"\b{str(kind).split()[-1]}s?\b", acting), scene.prompt


def test_nobody_rides_on_what_is_no_vehicle() -> None:
    for scene in sample_scenes(300, 7, ALL):
        vehicles = {noun.name for noun in VEHICLES}
        assert scene.camera != "dash" or scene.values["mover"] in vehicles, scene.prompt


def test_both_scenes_of_a_pair_are_set_alike() -> None:
    found = list(sample_scenes(200, 8, ALL, counterfactual=True))
    for base, twin in zip(found[::2], found[1::2], strict=True):
        assert base.camera == twin.camera
        differing = {
            k for k in {*base.values, *twin.values} if base.values.get(k) != twin.values.get(k)
        }
        assert all(k.startswith(twin.changed) for k in differing), differing


def test_the_plan_carries_what_was_drawn() -> None:
    spec = DatasetSpec(source="sample", n=30, distribution=ALL)
    planned = plan_scenes(spec)
    assert {p.camera for p in planned} <= {"around", "tracking", "dash"}
    drawn = [json.loads(p.parameters) for p in planned]
    assert any("light" in d for d in drawn) and any("bystanders" in d for d in drawn)
    assert DatasetSpec.model_validate_json(spec.model_dump_json()) == spec


def test_the_reader_understands_all_that_is_said() -> None:
    """What it does not would make scenes `partial`, whatever they show."""
    from esg.draft import draft

    lacking = {
        scene.prompt: [s.text for s in doc.statements or () if s.predicate == "not_represented"]
        for scene in sample_scenes(40, 9, ALL)
        if (doc := draft(scene.prompt, seed=scene.seed))
    }
    assert {k: v for k, v in lacking.items() if v} == {}


def test_a_crowd_is_drafted_thing_by_thing() -> None:
    from esg.draft import draft

    nodes = draft(
        "In a gym, a ball rolls into a bench. Three chairs, a lamp and twenty-four people stand "
        "around."
    ).spatial_relation_graph.nodes
    counts = Counter(re.sub(r"_\d+$", "", name) for name in nodes)
    assert (counts["chair"], counts["lamp"], counts["person"]) == (3, 1, 24)


def test_all_mistakes_are_told_at_once() -> None:
    text = (
        "places: {moon: 1, park: -1}\nlights: {dusk: 0}\nbystanders: {29: 1, few: 1}\n"
        "cameras: {drone: 1}\nvariants: 2\nmovers: [unicorn]\nspeed: 1\ncolors: [red]\n"
    )
    with pytest.raises(UserError) as told:
        load_distribution(text, "mix.yaml")
    lines = str(told.value).splitlines()
    assert lines[0] == "mix.yaml: 8 problems"
    for word in ("moon", "must not be negative", "one share must be positive", "'29', 'few'",
                 "drone", "variants", "unicorn", "speed", "colors"):  # fmt: skip
        assert word in str(told.value), word
