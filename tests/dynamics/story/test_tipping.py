"""Which hits tip a standing body over: centre of mass, base, height of the touch, size and mass."""

from __future__ import annotations

from dataclasses import replace
import math

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.feasibility import impossible
from esg.dynamics.story.stagecraft import Prop, prop
from esg.dynamics.story.story import read_story
from esg.dynamics.story.tipping import (
    first_touch,
    least_topple_speed,
    stand_of,
    tip_speed,
    topple_speed,
)
from esg.graph.models import ForceDirection
from tests.dynamics.stories import cast


def _pair(mover: str, target: str) -> tuple[Prop, Prop]:
    """Props at their usual sizes and masses."""
    doc = resolve(draft(f"A {mover} rolls into a {target} and knocks it over."))
    names = list(doc.spatial_relation_graph.nodes)
    first, second = (next(n for n in names if w.replace(" ", "_") in n) for w in (mover, target))
    return prop(doc, first), replace(prop(doc, second), fixed=False)


@pytest.mark.parametrize(
    ("mover", "target", "low", "high"),
    [
        # Least speeds at which Newton and PhysX at 240 Hz both tip it over.
        ("bowling ball", "chair", 5.0, 7.0),
        ("basketball", "chair", 15.0, 20.0),
        ("bowling ball", "trash can", 5.0, 6.0),
        ("bowling ball", "barrel", 8.0, 10.0),
        ("tennis ball", "vase", 12.0, 15.0),
        ("basketball", "vase", 2.0, 2.5),
        ("soccer ball", "bottle", 1.0, 1.5),
    ],
)
def test_the_closed_form_agrees_with_the_engines(
    mover: str, target: str, low: float, high: float
) -> None:
    a, b = _pair(mover, target)
    stand = stand_of(b)
    touch = first_touch(a, b, stand, flies=False)
    assert touch is not None
    assert 0.75 * low < tip_speed(a, b, stand, touch) < 1.5 * high


def test_a_rolling_ball_meets_a_cone_at_the_rim_of_its_base() -> None:
    ball, cone = _pair("soccer ball", "traffic cone")
    stand = stand_of(cone)
    touch = first_touch(ball, cone, stand, flies=False)
    assert touch is not None
    assert touch.height < stand.height
    assert touch.normal[1] < -0.5
    assert topple_speed(ball, cone, flies=False) > 50.0
    assert topple_speed(ball, cone, flies=True) < 12.0


def test_what_rolls_presses_down_on_what_it_hits() -> None:
    ball, bucket = _pair("soccer ball", "bucket")
    stand = stand_of(bucket)
    touch = first_touch(ball, bucket, stand, flies=False)
    assert touch is not None
    assert touch.impulse[1] < touch.normal[1]
    free = replace(touch, push=None)
    small, light = stand.scaled(0.5), replace(bucket, mass=0.1 * bucket.mass)
    assert tip_speed(ball, light, small, touch) > tip_speed(ball, light, small, free)


def test_what_a_rolling_ball_cannot_tip_is_said_at_once() -> None:
    doc = cast("A soccer ball rolls at 5 m/s into a 71 cm tall traffic cone and knocks it over.")
    [why] = impossible(doc, read_story(doc)).values()
    assert "below its centre of mass" in why
    assert doc.asset_configurations["cone_01"].dimensions_cm[2] == pytest.approx(71.0)


def test_the_closed_forms_bound_never_exceeds_what_is_sure() -> None:
    for mover, target in (("basketball", "vase"), ("bowling ball", "chair")):
        a, b = _pair(mover, target)
        assert least_topple_speed(a, b, flies=False) < topple_speed(a, b, flies=False)


def test_what_hits_is_thrown_and_what_rolls_stays_on_the_ground() -> None:
    hit = cast("A soccer ball hits a traffic cone at 4.5 m/s and the traffic cone topples.")
    roll = cast("A soccer ball rolls into a traffic cone and knocks it over.")
    force = [
        d.timeline_system.actors["soccer_ball_1"].force_direction
        for d in (hit, roll)
        if d.timeline_system is not None
    ]
    assert force == [ForceDirection.ANY_3D, ForceDirection.HORIZONTAL_PLANE]


def test_what_is_knocked_over_is_not_fixed_to_the_ground() -> None:
    doc = cast("A skateboard rolls into a bollard and knocks it over.")
    assert not prop(doc, "bollard_1").fixed


def test_what_falls_comes_down_on_what_it_shall_hit() -> None:
    doc = cast("An apple falls from a tree branch into a wheelbarrow.")
    places = {p.node: p for c in choreograph(doc).hints.constellations for p in c.placements}
    apple, barrow = places["apple_1"], places["wheelbarrow_1"]
    # Above the middle of its tray, which is in front of the middle of the whole.
    inside = next(
        r for r in doc.asset_configurations["wheelbarrow_01"].regions if r.name == "inside"
    )
    yaw = math.radians(barrow.yaw_deg or 0.0)
    x, y = inside.center_cm[:2]
    above = (
        barrow.x_cm + x * math.cos(yaw) - y * math.sin(yaw),
        barrow.y_cm + x * math.sin(yaw) + y * math.cos(yaw),
    )
    assert (apple.x_cm, apple.y_cm) == pytest.approx(above)
