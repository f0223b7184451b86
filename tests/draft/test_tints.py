"""Alike things that act are told apart by colour."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft


def colors(prompt: str) -> dict[str, str | None]:
    doc = draft(prompt)
    nodes = doc.spatial_relation_graph.nodes
    return {n: doc.asset_requirement[v.asset_id].color for n, v in nodes.items()}


@pytest.mark.parametrize(
    ("prompt", "alike"),
    [
        ("Two cars collide head-on.", ["car_1", "car_2"]),
        ("Ball A hits ball B, then ball B hits ball C.", ["ball_a", "ball_b", "ball_c"]),
        ("A van hits another van.", ["van_1", "van_2"]),
        ("A red ball hits a ball.", ["red_ball_1", "ball_1"]),
    ],
)
def test_alike_things_are_drawn_in_different_colours(prompt: str, alike: list[str]) -> None:
    doc = resolve(draft(prompt))
    drawn = [
        doc.asset_configurations[doc.spatial_relation_graph.nodes[n].asset_id].color_rgb
        for n in alike
    ]
    for k, mine in enumerate(drawn):
        for other in drawn[:k]:
            assert sum((a - b) ** 2 for a, b in zip(mine, other, strict=True)) > 0.1


def test_the_first_keeps_its_own_colour_and_the_sizes_are_equal() -> None:
    doc = draft("Two cars collide head-on.")
    nodes = doc.spatial_relation_graph.nodes
    first, second = (doc.asset_requirement[nodes[n].asset_id] for n in ("car_1", "car_2"))
    assert first.color is None
    assert second == first.model_copy(update={"color": second.color})


@pytest.mark.parametrize(
    "prompt",
    [
        "A blue car hits a green car.",
        "A bowling ball hits ten pins.",
        "A car hits a wall beside a car.",
        "Two dogs run into each other.",
    ],
)
def test_colours_are_left_alone(prompt: str) -> None:
    stated = {"blue_car_1": "blue", "green_car_1": "green"}
    assert {n: c for n, c in colors(prompt).items() if c is not None} == (
        stated if "blue" in prompt else {}
    )
