"""How things lie and stand: statements at the start and at the end, and what is owned up to."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, Predicate
from esg.graph.verifier import verify


def _told(doc: EsgDocument) -> list[tuple[str, str | None, str]]:
    told = (s for s in doc.statements or () if s.predicate is Predicate.LIES)
    return [(",".join(s.object), s.noun, s.when) for s in told]


def _owned(doc: EsgDocument) -> str:
    told = (s for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED)
    return "|".join(s.text for s in told)


def _lain(doc: EsgDocument) -> dict[str, str]:
    nodes = doc.spatial_relation_graph.nodes.items()
    poses = {n: doc.asset_requirement[node.asset_id].lies for n, node in nodes}
    return {n: pose for n, pose in poses.items() if pose is not None}


@pytest.mark.parametrize(
    ("prompt", "who", "pose", "when"),
    [
        (
            "A wine bottle lies on its side on a table.",
            "wine_bottle_1",
            "on its side",
            "throughout",
        ),
        ("The chair is upside down on the floor.", "chair_1", "upside down", "throughout"),
        ("A coin stands on its edge on a desk.", "coin_1", "on its edge", "throughout"),
        ("An overturned car lies on the road.", "car_1", "overturned", "throughout"),
        ("A car rests on its roof on a road.", "car_1", "on its roof", "throughout"),
        ("A truck hits a barrel that is lying on its side.", "barrel_1", "on its side", "start"),
        ("A man walks past a fallen bicycle.", "bicycle_1", "tipped over", "start"),
        ("A bicycle is lying on the sidewalk.", "bicycle_1", "flat", "throughout"),
        ("A street lamp lies beside the road.", "street_lamp_1", "flat", "throughout"),
        ("A tree lies across a path.", "tree_1", "flat", "throughout"),
        ("Two books stand upright on a shelf.", "book_1,book_2", "upright", "throughout"),
        ("A phone lies face down on a table.", "phone_1", "face down", "throughout"),
        ("A bottle is placed on its side on a table.", "bottle_1", "on its side", "throughout"),
        (
            "A cone has been tipped over and a car drives past it.",
            "cone_1",
            "tipped over",
            "start",
        ),
    ],
)
def test_it_lies_so_at_first(prompt: str, who: str, pose: str, when: str) -> None:
    doc = draft(prompt)
    assert (who, pose, when) in _told(doc)
    assert _lain(doc) == dict.fromkeys(who.split(","), pose)
    assert not _owned(doc)
    assert not verify(doc)


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        (
            "A ball knocks over a vase, and the vase ends up lying on its side.",
            ("vase_1", "on its side", "end"),
        ),
        ("A toy car flips over and lands upside down.", ("toy_car_1", "upside down", "end")),
        ("A car rolls over onto its roof.", ("car_1", "on its roof", "end")),
        ("A ball hits a bottle and the bottle lies on the floor.", ("bottle_1", "flat", "end")),
        ("A robot places a mug upside down on a table.", ("mug_1", "upside down", "end")),
    ],
)
def test_it_ends_so(prompt: str, told: tuple[str, str, str]) -> None:
    doc = draft(prompt)
    assert _told(doc) == [told]
    assert not _lain(doc)


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A cat lies on its side on a sofa.", "on its side"),
        ("A plane flies upside down.", "upside down"),
        ("A box tilted at 30 degrees leans against a wall.", "tilted"),
    ],
)
def test_what_does_not_lie_so_is_owned_up_to(prompt: str, words: str) -> None:
    doc = draft(prompt)
    assert words in _owned(doc)
    assert not _told(doc)


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball hits a car on its side.",
        "A truck with a logo on its side drives down a street.",
        "A cat sits on its roof.",
        "A vase stands upright on a table.",
        "A hammer lies next to a nail.",
        "A ball lies on a box.",
        "A mountain lies behind a house.",
        "A tower lies ahead of a car.",
        "Five bottles in a row, one of them lying down.",
    ],
)
def test_other_sides_and_what_is_drawn_so_anyway(prompt: str) -> None:
    assert not _told(draft(prompt))


def test_nothing_gets_into_a_bucket_from_the_side() -> None:
    doc = draft("A bucket lies on its side in the grass and a ball rolls into it.")
    assert _told(doc) == [("bucket_1", "on its side", "start")]
    assert _owned(doc) == "into it"


def test_what_lies_across_a_street_is_set_beside_it() -> None:
    doc = draft("A tree lies across the road.")
    assert _told(doc) == [("tree_1", "flat", "throughout")]
    assert _owned(doc) == "across the road"


def test_one_of_two_alike_lies() -> None:
    doc = draft("Two bottles stand on a table and a third one lies next to them.")
    assert list(_lain(doc)) == ["third_bottle_1"]


def test_the_words_keep_their_place() -> None:
    prompt = "An overturned car rests on its roof."
    doc = draft(prompt)
    for s in doc.statements or ():
        assert prompt[s.start : s.end] == s.text
    assert "roof_1" not in doc.spatial_relation_graph.nodes


def _wobbles(doc: EsgDocument) -> list[tuple[str, str]]:
    told = (s for s in doc.statements or () if s.predicate is Predicate.WOBBLES)
    return [(",".join(s.object), s.when) for s in told]


@pytest.mark.parametrize(
    ("prompt", "told", "lain"),
    [
        (
            "A vase wobbles on the table and then settles.",
            [("vase_1", "throughout")],
            {"vase_1": "tipped up"},
        ),
        (
            "A ball hits a tall bottle; the bottle teeters and stays upright.",
            [("bottle_1", "ball_1_bottle_1_collision..end")],
            {},
        ),
        (
            "The refrigerator wobbles as a forklift bumps into it.",
            [("refrigerator_1", "forklift_1_refrigerator_1_collision..end")],
            {},
        ),
        ("The plate wobbles on the table.", [], {}),
        ("A domino teeters on its edge and falls.", [], {}),
        ("A tennis ball lands on a net, wobbles and falls back.", [], {}),
        ("The vase wobbles when the dog bumps into the cabinet, then it falls onto a rug.", [], {}),
    ],
)
def test_what_wobbles(prompt: str, told: list[tuple[str, str]], lain: dict[str, str]) -> None:
    doc = draft(prompt)
    assert _wobbles(doc) == told
    assert _lain(doc) == lain
    assert bool(told) is not any(w in _owned(doc) for w in ("wobbles", "teeters"))
