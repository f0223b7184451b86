"""Ways around, over, under, along and between things, and those who walk them upright."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.dynamics import build_scene, start_hints
from esg.dynamics.choreography.courses.rounds import middle_of
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.story.stagecraft import prop
from esg.engines import get_engine
from esg.engines.program import batch_programs
from esg.layout import solve
from tests.dynamics.stories import cast

Place = tuple[float, float]


def starts(prompt: str) -> dict[str, Place]:
    (only,) = start_hints(cast(prompt), seed=0).constellations
    return {p.node: (p.x_cm / 100.0, p.y_cm / 100.0) for p in only.placements}


def test_the_middle_of_a_bend_is_its_centre() -> None:
    """Find the centre of an arc behind a straight run; a straight path has none."""
    angles = np.linspace(-math.pi / 2, math.pi, 20)
    arc = [(5.0 + 2.0 * math.cos(a), 2.0 + 2.0 * math.sin(a)) for a in angles]
    found = middle_of([(0.0, 0.0), *arc])
    assert found == pytest.approx((5.0, 2.0), abs=0.05)
    assert middle_of([(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0)]) is None


@pytest.mark.parametrize(
    ("prompt", "mover", "other"),
    [
        ("A dog runs around a tree.", "dog_1", "tree_1"),
        ("A man walks around a car.", "man_1", "car_1"),
        ("A cyclist rides around a fountain.", "cyclist_1", "fountain_1"),
    ],
)
def test_a_bend_leads_clear_of_what_it_goes_around(prompt: str, mover: str, other: str) -> None:
    """Turn so slowly that the radius is more than half of the thing's diagonal."""
    doc = cast(prompt)
    told = choreograph(doc, seed=0).nominal
    radius = told[f"{mover}_turn/speed"] / told[f"{mover}_turn/turn_rate"]
    thing, body = prop(doc, other), prop(doc, mover)
    assert radius > 0.5 * math.hypot(thing.length, thing.width) + body.half_width


@pytest.mark.parametrize(
    ("prompt", "mover", "pair"),
    [
        ("A boy walks between two trees.", "boy_1", ("tree_1", "tree_2")),
        ("A car drives between two cones.", "car_1", ("cone_1", "cone_2")),
        ("A dog runs between two benches and hits a bin.", "dog_1", ("bench_1", "bench_2")),
    ],
)
def test_two_of_a_kind_stand_on_either_side_of_the_way(
    prompt: str, mover: str, pair: tuple[str, str]
) -> None:
    """Place both members of a plural, the way in the middle between them."""
    at = starts(prompt)
    (x0, y0), (x1, y1) = at[pair[0]], at[pair[1]]
    assert y0 * y1 < 0.0
    assert x0 == pytest.approx(x1, abs=1e-6)
    assert x0 > at[mover][0]


def test_what_flies_over_something_clears_it_and_gets_past() -> None:
    """Fly above the ridge of a house, on a way that is longer than the house."""
    doc = cast("A bird flies over a house.")
    (only,) = start_hints(doc, seed=0).constellations
    bird = next(p for p in only.placements if p.node == "bird_1")
    house = prop(doc, "house_1")
    assert bird.z_cm is not None and bird.z_cm / 100.0 > house.height
    (way,) = (c for c in only.corridors if c.participants)
    assert math.dist(way.points_cm[0], way.points_cm[-2]) / 100.0 > house.length


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [("A boy runs along a wall.", "wall_1"), ("A cyclist rides along a fence.", "fence_1")],
)
def test_a_wall_is_as_long_as_the_way_along_it(prompt: str, thing: str) -> None:
    """Lengthen what has no stated length; leave one that has."""
    doc = cast(prompt)
    way = next(c for c in start_hints(doc, seed=0).constellations[0].corridors)
    length = max(prop(doc, thing).length, prop(doc, thing).width)
    assert length > math.dist(way.points_cm[0], way.points_cm[1]) / 100.0
    told = cast(prompt.replace("a wall", "a 2 m long wall").replace("a fence", "a 2 m long fence"))
    assert max(prop(told, thing).length, prop(told, thing).width) == pytest.approx(2.0, abs=0.3)


def test_who_walks_about_on_a_table_starts_at_one_end() -> None:
    """Leave the whole table before it, and come to rest on it."""
    doc = cast("A cat walks across a table.")
    (only,) = start_hints(doc, seed=0).constellations
    (cat,) = (p for p in only.placements if p.node == "cat_1")
    half = 50.0 * max(prop(doc, "table_1").length, prop(doc, "table_1").width)
    assert 0.2 * half < math.hypot(cat.x_cm, cat.y_cm) < half


def test_who_walks_stays_upright_and_faces_its_way() -> None:
    """Walk around a car for some ten seconds: no lean, and its front turns as its way does."""
    doc = cast("A man walks around a car.")
    doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
    plan = make_plan(doc, build_scene(doc), seed=0)
    program = plan.compile(plan.initial())
    played = get_engine("physx").rollout(
        plan.scene, batch_programs([program], plan.scene.names), record_every=24
    )
    x, y, z, w = played.quaternion[0, :, plan.scene.index("man_1")].T
    assert (1.0 - 2.0 * (x * x + y * y)).min() > math.cos(math.radians(3.0))
    yaw = np.unwrap(np.arctan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)))
    assert math.degrees(abs(yaw[-1] - yaw[0])) == pytest.approx(300.0, abs=15.0)


def test_who_is_run_into_keeps_its_weight() -> None:
    """Balance is for those whom nothing touches."""
    quiet = cast("A man walks past a bench.").asset_configurations["person_01"]
    struck = cast("A man walks into a table.").asset_configurations["person_01"]
    assert quiet.center_of_mass_cm[2] < 0.3 * struck.center_of_mass_cm[2]
    assert quiet.inertia_kg_cm2[2] == pytest.approx(10.0 * struck.inertia_kg_cm2[2])
