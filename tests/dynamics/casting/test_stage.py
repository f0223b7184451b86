"""The stage cast: choices beside what draft and resolve wrote, and a choreography told once."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

import pytest
import yaml

from esg.assets import resolve
from esg.draft import draft, said
from esg.dynamics import cast, start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.casting.changes import with_assets
from esg.dynamics.casting.roads import fit_roads
from esg.dynamics.choreography.telling import choreograph, choreography_of
from esg.graph import EsgDocument, canonical_json, effective, verify
from esg.graph.models import ForceDirection
from esg.layout import solve

ROOT = Path(__file__).parents[3]
GIVEN = {"casting", "choreography", "provenance"}
"""Fields of a document that the stage writes."""
OPEN = (
    "A soccer ball is kicked at a wooden crate and knocks it over.",
    "A ball hits a bollard, and the bollard falls over.",
    "A basketball is thrown into a bucket.",
    "A beach ball hits an umbrella, and the umbrella falls onto a cooler.",
    "A ball is dropped from 3 m onto a table, bounces off and lands in a basket next to the table.",
    "A crate slides over the frozen lake and hits a sledge.",
    "The first of three dominoes falls over and hits the second, the second falls over and hits "
    "the third.",
    "Ten books stand in a row on a shelf. The first book topples.",
)
"""Prompts that leave open what their events need."""


def suite(name: str) -> tuple[str, ...]:
    scenes = yaml.safe_load((ROOT / "data" / "suites" / f"{name}.yaml").read_text())["scenes"]
    return tuple(scene["prompt"] for scene in scenes)


PROMPTS = (*OPEN, *suite("paper"), *suite("breadth")[::3])


@cache
def resolved(prompt: str) -> EsgDocument:
    return resolve(draft(prompt))


@pytest.mark.parametrize("prompt", PROMPTS)
def test_what_other_stages_wrote_stays_as_it_is(prompt: str) -> None:
    given = resolved(prompt)
    before = canonical_json(given)
    doc = cast(given, seed=3)
    for field in EsgDocument.model_fields.keys() - GIVEN:
        assert getattr(doc, field) == getattr(given, field), field
    assert canonical_json(given) == before
    assert doc.provenance[:-1] == given.provenance and doc.provenance[-1].stage == "cast"


@pytest.mark.parametrize("prompt", PROMPTS)
def test_it_survives_json_and_gives_the_fitted_document(prompt: str) -> None:
    doc = cast(resolved(prompt))
    again = EsgDocument.model_validate_json(canonical_json(doc))
    assert again == doc and verify(again) == ()
    played, wanted = effective(again), fitted(resolved(prompt))
    if doc.choreography is not None:  # streets follow what was told
        wanted = with_assets(wanted, fit_roads(wanted, doc.choreography))
    for field in EsgDocument.model_fields.keys() - GIVEN:
        assert getattr(played, field) == getattr(wanted, field), field


@pytest.mark.parametrize("prompt", OPEN)
def test_every_choice_differs_from_what_was_given_and_says_why(prompt: str) -> None:
    doc = cast(resolved(prompt))
    assert doc.casting is not None
    assets, actors = doc.casting.assets, doc.casting.actors
    assert all(c.configuration != doc.asset_configurations[k] for k, c in assets.items())
    if actors:
        assert doc.timeline_system is not None
        given = doc.timeline_system.actors
        assert all(c.force_direction != given[k].force_direction for k, c in actors.items())
    parts = (assets, doc.casting.nodes, actors, doc.casting.segments)
    choices = [choice for part in parts for choice in part.values()]
    assert choices and all(choice.reasons for choice in choices)


def test_reasons_tell_what_changed() -> None:
    casting = cast(resolved(OPEN[0])).casting
    assert casting is not None
    (crate,) = (c for k, c in casting.assets.items() if "crate" in k)
    assert any("mass_kg" in text and "knocks over" in text for text in crate.reasons)
    casting = cast(resolved(OPEN[3])).casting
    assert casting is not None
    assert casting.actors["beach_ball_1"].force_direction is ForceDirection.ANY_3D


def test_casting_again_gives_the_same() -> None:
    doc = cast(resolved(OPEN[0]), seed=2)
    assert cast(doc, seed=2) == doc


def test_a_scene_that_needs_nothing_stays_itself() -> None:
    still = resolved("A vase stands on a table.")
    assert cast(still) == still
    crowded = cast(resolved("Ten boxes stand on a small table."))
    assert crowded.choreography is None


@pytest.mark.parametrize("prompt", PROMPTS)
def test_the_stored_choreography_is_the_told_one(prompt: str) -> None:
    doc = EsgDocument.model_validate_json(canonical_json(cast(resolved(prompt), seed=5)))
    told = choreograph(effective(doc), seed=5)
    assert choreography_of(doc) == told
    # What is stored is read, whatever the seed.
    assert start_hints(doc, seed=1) == told.hints


def test_the_choreography_does_not_depend_on_the_layout() -> None:
    doc = fitted(resolved(OPEN[0]))
    laid = solve(doc, hints=start_hints(doc))
    assert laid.layout_result is not None
    assert choreograph(laid) == choreograph(doc)


@pytest.mark.parametrize(
    ("prompt", "surface", "ground"),
    [
        ("A box slides across the ice and bumps into a barrel.", "ice", True),
        ("A skater stands on the frozen lake.", "ice", None),
        ("A ball is pushed into a wall.", None, True),
    ],
)
def test_the_drafter_records_what_the_words_say(
    prompt: str, surface: str | None, ground: bool | None
) -> None:
    wording = said.wording(prompt)
    assert wording is not None
    assert (wording.surface, wording.keeps_to_ground) == (surface, ground)
    assert draft(prompt).scene_definition.wording == wording


def test_words_that_say_nothing_leave_no_bytes() -> None:
    assert said.wording("A car hits a tree.") is None
    assert b"wording" not in canonical_json(draft("A car hits a tree."))
    nodes = draft("A car hits a tall lamp.").spatial_relation_graph.nodes
    assert {n.size_is_stated for k, n in nodes.items() if "lamp" in k} == {True}
    assert {n.size_is_stated for k, n in nodes.items() if "car" in k} == {None}


def modules(room: str) -> list[Path]:
    return sorted((ROOT / "esg" / "dynamics" / room).rglob("*.py"))


def test_no_module_of_dynamics_reads_the_prompt() -> None:
    words = ("original_description", "expanded_description", "import re\n")
    read = [(p.name, w) for p in modules(".") for w in words if w in p.read_text()]
    assert len(modules(".")) > 60 and read == []


@pytest.mark.parametrize(
    ("room", "below"),
    [
        ("story", {"story"}),
        ("choreography", {"story", "choreography"}),
        ("casting", {"story", "choreography", "casting"}),
    ],
)
def test_imports_between_rooms_go_one_way(room: str, below: set[str]) -> None:
    found = {
        node.module.split(".")[2]
        for path in modules(room)
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.ImportFrom)
        and (node.module or "").startswith("esg.dynamics.")
        and node.module is not None
    }
    assert found and found <= below
