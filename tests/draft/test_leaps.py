"""Leaps that end somewhere else than where they began."""

from __future__ import annotations

import pytest

from esg.draft import draft


def told(prompt: str) -> list[str]:
    doc = draft(prompt)
    assert doc.timeline_system is not None
    skip = ("SceneStart", "Trigger")
    nodes = doc.timeline_system.sequence_graph.nodes
    return [
        f"{n.event.value} {' '.join(n.participants)}" for n in nodes if n.event.value not in skip
    ]


def stands_on(prompt: str, thing: str) -> str:
    doc = draft(prompt)
    region = doc.spatial_relation_graph.nodes[thing].semantic_region or ""
    return doc.spatial_relation_graph.semantic_regions[region].parent_object or ""


@pytest.mark.parametrize(
    ("prompt", "events"),
    [
        ("A cat jumps onto a table.", ["Jump cat_1", "Collision cat_1 table_1"]),
        (
            "A sheepdog hops on top of a hay bale.",
            ["Jump sheepdog_1", "Collision sheepdog_1 hay_bale_1"],
        ),
        ("A man jumps off a platform and lands on a mat.", ["Jump man_1", "Collision man_1 mat_1"]),
        ("A child jumps down from a wall.", ["Jump child_1", "Fall child_1"]),
        (
            "A monkey leaps from a crate onto a barrel.",
            ["Jump monkey_1", "Collision monkey_1 barrel_1"],
        ),
        (
            "A frog hops from one stone to another.",
            ["Jump frog_1", "Collision frog_1 second_stone_1"],
        ),
        (
            "A boy jumps off a high wall into a pit.",
            ["Jump boy_1", "Fall boy_1", "EnterRegion boy_1"],
        ),
        ("A dog is standing on a bench, then it jumps down.", ["Jump dog_1", "Fall dog_1"]),
        ("A cat on a shelf leaps down onto the floor.", ["Jump cat_1", "Fall cat_1"]),
        ("A man jumps out of a dumpster.", ["Jump man_1"]),
        ("A kid hops out of a box.", ["Jump kid_1"]),
        ("A kid jumps on a bed three times.", ["Jump kid_1"]),
        ("A boy jumps on a trampoline.", ["Jump boy_1"]),
    ],
)
def test_a_leap_has_an_end(prompt, events):
    assert told(prompt) == events
    lost = [
        s.text for s in draft(prompt).statements or () if s.predicate.value == "not_represented"
    ]
    assert lost == []


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A cat jumps onto a table.", "onto a table"),
        ("A dog runs and jumps onto a bench.", "onto a bench"),
        ("A goat leaps onto a rock.", "onto a rock"),
    ],
)
def test_where_it_ends_is_stated(prompt, words):
    stated = [s.text for s in draft(prompt).statements or () if s.predicate.value == "ends_on"]
    assert stated == [words]


@pytest.mark.parametrize(
    ("prompt", "thing", "on"),
    [
        ("A cat jumps onto a table and pushes a glass off the edge.", "glass_1", "table_1"),
        ("A cat jumps onto a table and pushes a glass off the edge.", "cat_1", "ground_1"),
        ("A squirrel jumps onto a bench and knocks over a bottle.", "bottle_1", "bench_1"),
        ("A kid jumps on a bed three times.", "kid_1", "bed_1"),
        ("A man jumps off a platform and lands on a mat.", "man_1", "platform_1"),
        ("A man jumps out of a dumpster.", "man_1", "dumpster_1"),
    ],
)
def test_what_is_met_up_there_stands_there(prompt, thing, on):
    assert stands_on(prompt, thing) == on


@pytest.mark.parametrize(
    "prompt",
    [
        "A dog jumps onto a sofa and then jumps off it.",
        "A rabbit hops onto a stump and then hops off.",
        "A dolphin leaps out of the water.",
        "A raccoon jumps out of a trash can.",
    ],
)
def test_other_leaps_are_owned_up_to(prompt):
    lost = [
        s.text for s in draft(prompt).statements or () if s.predicate.value == "not_represented"
    ]
    assert lost
