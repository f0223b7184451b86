"""Ways that statements name: what stands beside them, and which way the whole is turned."""

from __future__ import annotations

import math
from typing import Any

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import start_hints
from esg.dynamics.choreography.ways import arrives, ways_stated
from esg.dynamics.story.story import read_story
from esg.graph.models import (
    Actor,
    BinaryRelation,
    EsgDocument,
    Predicate,
    Statement,
    TimelineEdge,
    TimelineNode,
)
from tests.dynamics.stage import asset, document

DOG = asset("dog", (90, 30, 60), 30)
POST = asset("post", (40, 40, 300), 80)
FENCE = asset("fence", (400, 10, 100), 60)
LEFT, FRONT = (1.0, 0.0), (0.0, 1.0)
RIGHT, BACK = (-1.0, 0.0), (0.0, -1.0)


def says(predicate: str = "moves", **more: Any) -> Statement:
    told = {"object": ("dog_1",), "target": ("post_1",), **more}
    return Statement(id="s1", predicate=Predicate(predicate), text="x", start=0, end=1, **told)


def running(*statements: Statement, **params: Any) -> EsgDocument:
    """A dog runs at 2 m/s; a post and a fence stand somewhere."""
    doc = document(
        "A dog runs.",
        dict(dog_1=DOG, post_1=POST, fence_1=FENCE),
        {"dog_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY")},
        [
            TimelineNode(id="start", event="SceneStart", timestamp=0),
            TimelineNode(id="t", event="Trigger", participants=("dog_1",), window=(2, 3)),
        ],
        [
            TimelineEdge(
                **{"id": "run", "from": "start", "to": "t", "event": "UniformMotion"},
                actor="dog_1",
                params={"speed": 200.0, **params},
            )
        ],
    )
    return doc.model_copy(update={"statements": statements or None})


def placed(doc: EsgDocument) -> tuple[dict[str, tuple[float, float, float | None]], float | None]:
    """Places [m] and yaws [degrees] of the only constellation, and its own yaw."""
    (only,) = start_hints(doc, seed=0).constellations
    places = {p.node: (p.x_cm / 100.0, p.y_cm / 100.0, p.yaw_deg) for p in only.placements}
    return places, only.yaw_deg


def in_world(doc: EsgDocument, name: str) -> tuple[float, float]:
    """Where something stands from where the dog starts [m], after the constellation's turn."""
    places, yaw = placed(doc)
    assert yaw is not None
    x, y = (a - b for a, b in zip(places[name][:2], places["dog_1"][:2], strict=True))
    c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
    return c * x - s * y, s * x + c * y


def heading(doc: EsgDocument) -> float:
    """Where the dog heads in the world [degrees, 0 to 360]."""
    places, yaw = placed(doc)
    assert yaw is not None
    return ((places["dog_1"][2] or 0.0) + yaw) % 360.0


def test_nothing_is_placed_or_turned_without_a_statement() -> None:
    places, yaw = placed(running())
    assert set(places) == {"dog_1"}
    assert yaw is None


def test_what_it_moves_toward_stands_ahead_and_is_not_met() -> None:
    doc = running(says(direction="toward"))
    x, y, _ = placed(doc)[0]["post_1"]
    assert y == pytest.approx(0.0)
    (track,) = start_hints(doc, seed=0).constellations[0].corridors
    end = track.points_cm[-2][0] / 100.0
    assert end > 1.0
    assert x - end == pytest.approx(0.45 + 0.2 + 1.0), "a metre is left at the end of its way"


def test_what_it_moves_away_from_stands_behind_its_start() -> None:
    places, _ = placed(running(says(direction="away_from")))
    assert places["post_1"][:2] == pytest.approx((-(0.45 + 0.2 + 1.0), 0.0))


def test_what_it_moves_past_stands_beside_the_middle_of_the_way() -> None:
    doc = running(says(direction="past"))
    places, _ = placed(doc)
    x, y, _ = places["post_1"]
    end = placed(running(says(direction="toward")))[0]["post_1"][0] - 0.45 - 0.2 - 1.0
    assert x == pytest.approx(0.5 * end)
    assert abs(y) == pytest.approx(0.15 + 0.2 + 0.6)


def test_what_it_moves_along_lies_lengthwise_beside_the_way() -> None:
    places, _ = placed(running(says(direction="along", target=("fence_1",))))
    _, y, yaw = places["fence_1"]
    assert abs(y) == pytest.approx(0.15 + 0.05 + 0.6)
    assert yaw is not None and yaw % 180.0 == pytest.approx(0.0)


@pytest.mark.parametrize(("degrees", "way"), [(0.0, LEFT), (180.0, RIGHT), (90.0, FRONT)])
def test_a_stated_course_turns_the_constellation(degrees: float, way: tuple[float, float]) -> None:
    doc = running(heading_deg=degrees)
    a = math.radians(heading(doc))
    assert (math.cos(a), math.sin(a)) == pytest.approx(way, abs=1e-9)


@pytest.mark.parametrize(
    ("predicate", "side"),
    [("left_of", LEFT), ("right_of", RIGHT), ("in_front_of", FRONT), ("behind", BACK)],
)
def test_a_way_ends_on_the_side_that_is_stated(predicate: str, side: tuple[float, float]) -> None:
    doc = running(says(predicate, when="end"))
    a = math.radians(heading(doc))
    x, y = in_world(doc, "post_1")
    along = x * math.cos(a) + y * math.sin(a)
    off = (x - along * math.cos(a), y - along * math.sin(a))
    gap = math.hypot(*off)
    assert (-off[0] / gap, -off[1] / gap) == pytest.approx(side, abs=1e-6)
    assert gap == pytest.approx(0.15 + 0.2 + 0.6)
    (post, _) = start_hints(doc, seed=0).constellations[0].corridors[0].points_cm[-2]
    assert along > post / 100.0, "there it still has to brake"


def test_a_side_is_reached_from_where_it_starts_and_not_through_the_thing() -> None:
    doc = running(says("left_of", when="end"))
    graph = doc.spatial_relation_graph
    told = {"from": "dog_1", "to": "post_1", "relation_type": "in_front_of"}
    relation = BinaryRelation.model_validate(told)
    edges = graph.edges.model_copy(update={"binary_relations": (relation,)})
    starts = {"spatial_relation_graph": graph.model_copy(update={"edges": edges})}
    assert heading(doc) == pytest.approx(90.0)
    assert heading(doc.model_copy(update=starts)) == pytest.approx(270.0)


@pytest.mark.parametrize(
    ("told", "side"),
    [
        ("A cat to the left of a vase knocks the vase over.", LEFT),
        ("A cat to the right of a vase knocks the vase over.", RIGHT),
        ("A cat in front of a vase knocks the vase over.", FRONT),
        ("There is a vase in front of a cat. The cat knocks the vase over.", BACK),
    ],
)
def test_who_goes_to_a_thing_starts_on_the_side_of_it_that_is_told(
    told: str, side: tuple[float, float]
) -> None:
    places, yaw = placed(resolve(draft(told), seed=0))
    assert yaw is not None
    x, y = (a - b for a, b in zip(places["cat_1"][:2], places["vase_1"][:2], strict=True))
    turn = math.radians(yaw)
    east, north = (
        math.cos(turn) * x - math.sin(turn) * y,
        math.sin(turn) * x + math.cos(turn) * y,
    )
    assert side[0] * east + side[1] * north > 0.9 * math.hypot(east, north)


@pytest.mark.parametrize(
    "other",
    [
        says(direction="toward", target=("ground_1",)),
        says(direction="toward", target=("dog_1",)),
        says("left_of", when="start"),
        says("supported_by"),
    ],
)
def test_other_statements_place_nothing(other: Statement) -> None:
    doc = running(other)
    assert list(ways_stated(doc, read_story(doc))) == []
    assert set(placed(doc)[0]) == {"dog_1"}


def test_only_a_side_at_the_end_is_arrived_at() -> None:
    assert arrives(running(says("left_of", when="end")), "dog_1")
    assert not arrives(running(says("left_of", when="end")), "post_1")
    assert not arrives(running(says("left_of")), "dog_1")
    assert not arrives(running(says(direction="toward")), "dog_1")
    assert not arrives(running(), "dog_1")


def test_what_drives_backward_heads_the_other_way_from_its_front() -> None:
    doc = running(backward=True)
    actors = {"dog_1": Actor(role="active", force_direction="ALONG_FORWARD_OR_BACKWARD")}
    timeline = doc.timeline_system
    assert timeline is not None
    timeline = timeline.model_copy(update={"actors": actors})
    assert read_story(doc.model_copy(update={"timeline_system": timeline})).reverses("dog_1")
    assert not read_story(running()).reverses("dog_1")
