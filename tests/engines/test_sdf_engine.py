"""Contacts from signed distance fields: the engines' contract, and the geometry they must return."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics.search.fields import field_of, parts_mesh, spread_out
from esg.engines import get_engine
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.scene import Shape, SimScene
from esg.engines.surrogate import SdfSurrogateEngine
from tests.engines import test_contract
from tests.engines.lab import ball, box, solid
from tests.engines.test_contract import (  # noqa: F401  # the same tests, run with `engine` below
    test_a_world_does_not_depend_on_its_batch,
    test_diverging_worlds_are_flagged_and_leave_the_others_alone,
    test_frames_accumulate_contacts,
    test_repeats_are_bit_identical_whatever_ran_in_between,
)

DT = 1.0 / 240.0


def fields(scene, names=None, resolution=48):
    wanted = names or [b.name for b in scene.bodies if b.shapes[0].kind != "sphere"]
    return {
        b.name: field_of(parts_mesh(b), resolution=resolution)
        for b in scene.bodies
        if b.name in wanted
    }


def shove(engine, scene, speed, duration=0.5):
    program = Program((SetVelocity("a", 0.0, (speed, 0.0, 0.0)),), duration)
    return engine.rollout(scene, batch_programs([program], scene.names), dt=DT)


@pytest.fixture(scope="module")
def engine():
    return SdfSurrogateEngine(fields(test_contract.SCENE))


def pair(one, two, offset=0.0):
    return SimScene(
        "pair",
        (replace(one, name="a"), replace(two, name="b", position=(1.0, offset, two.position[2]))),
        ground_friction=0.0,
    )


BOX = box("box", (0.3, 0.25, 0.2), 3.0, (0.0, 0.0, 0.2), friction=0.0, restitution=0.3)
ROUND = solid(
    "round", Shape("cylinder", (0.2, 0.2, 0.2)), 1.0, (0.0, 0.0, 0.2), friction=0.0, restitution=0.3
)
BALL = ball("ball", 0.15, 1.0, (0.0, 0.0, 0.15), friction=0.0, restitution=0.3)


@pytest.mark.parametrize(
    ("one", "two"), [(BOX, BOX), (BOX, ROUND), (ROUND, BOX), (BALL, BOX), (BOX, BALL)]
)
def test_a_central_hit_happens_when_and_as_hard_as_with_the_exact_shapes(one, two):
    scene = pair(one, two)
    exact = shove(get_engine("surrogate"), scene, 3.0)
    found = shove(SdfSurrogateEngine(fields(scene)), scene, 3.0)
    assert found.contacts.time[0] == pytest.approx(exact.contacts.time[0], abs=1.01 * DT)
    assert found.contacts.impulse.sum() == pytest.approx(exact.contacts.impulse.sum(), rel=0.02)
    assert found.linear_velocity[0, -1] == pytest.approx(exact.linear_velocity[0, -1], abs=0.1)
    # The nearest samples of a face lie a centimetre beside the line of centres.
    assert found.contacts.normal[0] == pytest.approx([-1.0, 0.0, 0.0], abs=0.05)


def test_off_centre_the_field_sends_a_round_body_where_its_true_shape_goes():
    """The corner of a box meets a cylinder's side: the direction that boxes and spheres get wrong."""
    scene = pair(BOX, ROUND, 0.32)
    headings = {}
    for name, engine, played in (
        ("exact", get_engine("surrogate"), scene),
        ("field", SdfSurrogateEngine(fields(scene)), scene),
        (
            "box",
            get_engine("surrogate"),
            pair(BOX, replace(ROUND, shapes=(Shape("box", (0.2, 0.2, 0.2)),)), 0.32),
        ),
    ):
        v = shove(engine, played, 3.0).linear_velocity[0, -1, 1]
        headings[name] = np.degrees(np.arctan2(v[1], v[0]))
    assert 15.0 < headings["exact"] < 45.0
    assert headings["field"] == pytest.approx(headings["exact"], abs=3.0)
    assert abs(headings["box"] - headings["exact"]) > 6.0


def test_bodies_rest_on_the_ground_by_their_samples():
    scene = SimScene("rest", (replace(BOX, name="a", position=(0.0, 0.0, 0.25)),))
    found = shove(SdfSurrogateEngine(fields(scene)), scene, 0.0, 1.0)
    assert found.position[0, -1, 0, 2] == pytest.approx(0.2, abs=0.003)
    assert np.abs(found.quaternion[0, -1, 0, :3]).max() < 0.01


def test_a_wall_thinner_than_a_cell_stops_a_fast_body():
    """Its field alone would have no negative value; half a cell is added."""
    wall = box("wall", (0.002, 1.0, 1.0), 500.0, (0.0, 0.0, 1.0), friction=0.0)
    scene = pair(BOX, wall)
    made = fields(scene)
    assert made["b"].values.min() < 0.0 and made["b"].cell > 0.01
    found = shove(SdfSurrogateEngine(made), scene, 12.0)
    assert len(found.contacts.time)
    assert found.position[0, :, 0, 0].max() < 1.0 - 0.3 + 0.01


def test_bodies_without_a_field_collide_by_their_shapes():
    scene = pair(BOX, ROUND)
    exact = shove(get_engine("surrogate"), scene, 3.0)
    found = shove(SdfSurrogateEngine(fields(scene, ["b"])), scene, 3.0)
    assert found.contacts.time[0] == exact.contacts.time[0]
    none = shove(SdfSurrogateEngine({}), scene, 3.0)
    np.testing.assert_array_equal(none.position, exact.position)


def test_fields_of_different_resolution_are_refused():
    scene = pair(BOX, ROUND)
    mixed = {**fields(scene, ["a"], 16), **fields(scene, ["b"], 24)}
    with pytest.raises(ValueError, match="number of cells"):
        SdfSurrogateEngine(mixed)


def test_samples_keep_the_corners_and_lie_apart():
    body = replace(BOX, shapes=(Shape("box", (0.5, 0.5, 0.5)),))
    found = field_of(parts_mesh(body), resolution=16).samples
    corners = {(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)}
    assert corners <= {tuple(p) for p in np.round(found, 9)}
    assert len(found) == 320 and np.abs(np.abs(found).max(axis=1) - 0.5).max() < 1e-9
    away = np.linalg.norm(found[:, None] - found[None], axis=-1) + np.eye(320)
    assert away.min() > 0.02
    assert spread_out(np.zeros((5, 3)), 3).shape == (1, 3)
