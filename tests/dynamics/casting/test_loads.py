"""Supports with room for what stands on them, and containers below the edge they are fed from."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import build_scene, start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import SetVelocity
from esg.graph.models import AssetConfiguration, EsgDocument
from esg.layout import solve
from esg.layout.problem.patterns import DOMINO_PITCH_OVER_HEIGHT


def _cast(prompt: str) -> tuple[EsgDocument, EsgDocument]:
    doc = resolve(draft(prompt))
    return doc, fitted(doc)


def _of(doc: EsgDocument, name: str) -> AssetConfiguration:
    return doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]


def test_a_shelf_is_long_enough_for_the_boxes_on_it() -> None:
    """Three boxes of 50 cm do not stand side by side on 90 cm."""
    before, after = _cast("A pallet jack hits a storage shelf full of cardboard boxes.")
    assert _of(before, "shelf_1").dimensions_cm[1] == 90.0
    assert _of(after, "shelf_1").dimensions_cm[1] > 105.0
    assert _of(after, "cardboard_box_1") == _of(before, "cardboard_box_1")
    placed = solve(after, hints=start_hints(after)).layout_result
    assert placed is not None
    assert placed.max_penetration_cm < 2.0


def test_what_stands_on_a_table_of_stated_size_shrinks_instead() -> None:
    before, after = _cast(
        "Four suitcases stand on a 60 cm long table. A ball rolls past the table."
    )
    assert _of(after, "table_1") == _of(before, "table_1")
    ratio = _of(after, "suitcase_1").dimensions_cm[0] / _of(before, "suitcase_1").dimensions_cm[0]
    assert 0.35 < ratio < 1.0


@pytest.mark.parametrize(
    "prompt",
    ["A cup and a plate stand on a table. A ball hits the table.", "A box stands on a shelf."],
)
def test_what_has_room_is_not_touched(prompt: str) -> None:
    before, after = _cast(prompt)
    assert before.asset_configurations.keys() == after.asset_configurations.keys()
    for key, config in before.asset_configurations.items():
        assert after.asset_configurations[key].dimensions_cm == config.dimensions_cm


def test_a_bin_stands_below_the_belt_that_feeds_it() -> None:
    """What slides off at 80 cm cannot end up in 95 cm; the bin is low, wide enough and open."""
    before, after = _cast("A parcel slides off the end of a conveyor belt and drops into a bin.")
    belt, bin_ = _of(after, "conveyor_belt_1"), _of(after, "bin_1")
    assert _of(before, "bin_1").dimensions_cm[2] > belt.support_surfaces[0].center_cm[2]
    assert bin_.dimensions_cm[2] <= 0.72 * belt.support_surfaces[0].center_cm[2]
    mouth = next(r for r in bin_.regions if r.name == "inside")
    assert 2.0 * min(mouth.half_extents_cm[:2]) > max(_of(after, "parcel_1").dimensions_cm[:2])


def test_what_stands_on_a_stack_stands_on_its_top() -> None:
    _, doc = _cast("A forklift hits a stack of pallets and a bucket standing on top of it falls.")
    graph = doc.spatial_relation_graph
    stack = [n for n, v in graph.nodes.items() if v.group == graph.nodes["pallet_1"].group]
    region = graph.semantic_regions[str(graph.nodes["bucket_1"].semantic_region)]
    assert region.parent_object == stack[-1]
    placed = solve(doc, hints=start_hints(doc)).layout_result
    assert placed is not None
    assert placed.max_penetration_cm < 2.0
    height = [placed.poses[n].position_cm[2] for n in (*stack, "bucket_1")]
    assert height == sorted(height)
    assert len(set(height)) == len(height)


def test_what_falls_off_a_stack_waits_until_the_stack_is_hit() -> None:
    """Whichever member is hit, the bucket on top sets off after that."""
    _, doc = _cast("A forklift hits a stack of pallets and a bucket standing on top of it falls.")
    doc = solve(doc, hints=start_hints(doc))
    plan = make_plan(doc, build_scene(doc), seed=0)
    hit = choreograph(doc).nominal["forklift_1_pallet_1_collision/event_time"]
    pushes = [p for p in plan.compile(plan.initial()).primitives if p.body == "bucket_1"]
    assert isinstance(pushes[0], SetVelocity)
    assert pushes[0].time > hit


def test_a_row_of_slabs_has_room_to_topple() -> None:
    """Make a shelf long enough for ten books that stand on their ends at their pitch."""
    doc = fitted(resolve(draft("Ten books stand in a row on a shelf. The first book topples.")))
    nodes = doc.spatial_relation_graph.nodes
    books = [doc.asset_configurations[v.asset_id] for v in nodes.values() if v.group]
    shelf = doc.asset_configurations[nodes["shelf_1"].asset_id]
    assert len(books) == 10
    length, _, height = books[0].dimensions_cm
    assert max(shelf.dimensions_cm) >= 9 * DOMINO_PITCH_OVER_HEIGHT * height + length


@pytest.mark.parametrize(
    ("load", "smaller"), [("barrel", True), ("crate", True), ("barrel 80 cm high", False)]
)
def test_what_comes_off_a_low_deck_is_small_enough_to_fall(load: str, smaller: bool) -> None:
    """A barrel of 90 cm that comes off a deck of 24 cm has not come down by half its height."""
    before, after = _cast(f"A handcart with a {load} on it hits a post and the {load.split()[0]} "
                          "falls off.")  # fmt: skip
    name = f"{load.split()[0]}_1"
    assert (_of(after, name).dimensions_cm[2] < _of(before, name).dimensions_cm[2]) is smaller
    assert _of(after, "handcart_1") == _of(before, "handcart_1")


def test_a_cart_that_comes_down_a_slope_has_a_low_deck_all_the_same() -> None:
    before, after = _cast("A cart rolls down a slope with a barrel on it. It hits a post and the "
                          "barrel falls off.")  # fmt: skip
    assert _of(after, "barrel_1").dimensions_cm[2] < _of(before, "barrel_1").dimensions_cm[2]


def test_what_falls_off_a_table_keeps_its_size() -> None:
    before, after = _cast("A ball hits a vase on a table and the vase falls off the table.")
    assert _of(after, "vase_1") == _of(before, "vase_1")
