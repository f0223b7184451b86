"""Drawings of postures: on the ground, as high as the table says, and closed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.assets.appearance import USUAL
from esg.assets.library.catalogue import build_sketch, entries_by_name
from esg.lexicon.postures import PLANS, Posture, plan_of, posture_of, postures

_CASES = [
    (name, row)
    for name in ("person", "child", "dog", "horse", "camel")
    for row in postures()
    if row.plan == PLANS[entries_by_name()[name].builder] and row.pose
]


@pytest.mark.parametrize(("name", "row"), _CASES, ids=lambda v: getattr(v, "posture", v))
def test_who_is_drawn_rests_on_the_ground_as_high_as_the_table_says(
    name: str, row: Posture
) -> None:
    entry = entries_by_name()[name]
    look = replace(USUAL, pose=row.pose)
    parts = build_sketch(entry, entry.dimensions_cm, entry.color_rgb, look).parts
    points = np.concatenate([np.asarray(p.mesh().vertices) for p in parts])
    tall = entry.dimensions_cm[2]
    if row.on == "ground":
        assert abs(points[:, 2].min()) < 0.03 * tall
    high = points[:, 2].max() / tall
    assert row.least - 0.05 <= high <= row.most + 0.05
    assert row.least <= row.height <= row.most


def test_drawings_are_not_inside_out() -> None:
    entry = entries_by_name()["person"]
    for pose in ("lie", "kneel", "crouch"):
        sketch = build_sketch(
            entry, entry.dimensions_cm, entry.color_rgb, replace(USUAL, pose=pose)
        )
        assert sum(p.mesh().volume for p in sketch.parts) > 0.0


def test_who_has_a_plan() -> None:
    assert plan_of("dog", person=False) == "beasts"
    assert plan_of("plumber", person=True) == "people"
    assert plan_of("bird", person=False) is None
    assert posture_of("beasts", "bends") is None
    seat = posture_of("people", "sits", "seat")
    assert seat is not None and seat.pose == "sit"


@pytest.mark.parametrize("name", ["king", "monk", "woman"])
@pytest.mark.parametrize("pose", ["kneel", "crouch", "floor"])
def test_what_is_worn_lies_on_the_ground(name: str, pose: str) -> None:
    """No robe, cloak or skirt of who is down is in the ground."""
    entry = entries_by_name()[name]
    look = replace(USUAL, pose=pose)
    parts = build_sketch(entry, entry.dimensions_cm, entry.color_rgb, look).parts
    worn = [p for p in parts if p.limb == "trunk"]
    assert min(float(p.mesh().bounds[0, 2]) for p in worn) >= -1e-6
