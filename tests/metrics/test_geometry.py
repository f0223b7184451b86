"""Signed distances of analytic pairs, and invariants."""

from __future__ import annotations

import math

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
import pytest

from esg.engines.scene import Shape
from esg.metrics.geometry import core_depth, gjk_distance, place, shape_core, signed_distance
from esg.units import quat_from_euler_deg


def shape(kind, size, at=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0), vertices=()):
    return shape_core(Shape(kind, size, at, tuple(quat_from_euler_deg(*turn).tolist()), vertices))


UNIT_BOX = ("box", (1.0, 1.0, 1.0))
CUBE = tuple((float(x), float(y), float(z)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))


@pytest.mark.parametrize(
    ("a", "b", "distance"),
    [
        (shape("sphere", (1, 1, 1)), shape("sphere", (1, 1, 1), (2.5, 0, 0)), 0.5),
        (shape("sphere", (1, 1, 1)), shape("sphere", (1, 1, 1), (1.9, 0, 0)), -0.1),
        (shape("sphere", (1, 1, 1)), shape("sphere", (1, 1, 1)), -2.0),
        (shape(*UNIT_BOX), shape(*UNIT_BOX, at=(1.9, 0.3, 0.2)), -0.1),
        (shape(*UNIT_BOX), shape(*UNIT_BOX, at=(3.0, 3.0, 0)), math.sqrt(2)),
        (shape(*UNIT_BOX), shape(*UNIT_BOX, at=(3.0, 3.0, 3.0)), math.sqrt(3)),
        (shape(*UNIT_BOX), shape(*UNIT_BOX), -2.0),
        # A box turned by 45 degrees reaches sqrt(2) along x.
        (shape(*UNIT_BOX), shape(*UNIT_BOX, at=(3, 0, 0), turn=(45, 0, 0)), 2 - math.sqrt(2)),
        (shape(*UNIT_BOX), shape(*UNIT_BOX, at=(2.4, 0, 0), turn=(45, 0, 0)), 1.4 - math.sqrt(2)),
        (shape(*UNIT_BOX), shape("sphere", (0.5,) * 3, (1.3, 0, 0)), -0.2),
        (shape(*UNIT_BOX), shape("sphere", (0.5,) * 3, (2, 2, 0)), math.sqrt(2) - 0.5),
        # Inside: the centre is 0.6 from the nearest face.
        (shape(*UNIT_BOX), shape("sphere", (0.1,) * 3, (0.4, 0, 0)), -0.7),
        (shape("capsule", (0.2, 0.2, 1)), shape("capsule", (0.2, 0.2, 1), (0.5, 0, 1)), 0.1),
        (shape("capsule", (0.2, 0.2, 1)), shape("sphere", (0.1,) * 3, (0, 0, 1.5)), 0.2),
        (
            shape("capsule", (0.2, 0.2, 1)),
            shape("capsule", (0.2, 0.2, 1), (0.3, 0, 0), (0, 90, 0)),
            -0.4,
        ),
        (shape("convex", (1, 1, 1), vertices=CUBE), shape(*UNIT_BOX, at=(0, 2.5, 0)), 0.5),
        (shape("convex", (1, 1, 1), vertices=CUBE), shape(*UNIT_BOX, at=(0, 1.8, 0)), -0.2),
    ],
)
def test_analytic_pairs(a, b, distance):
    assert signed_distance(a, b) == pytest.approx(distance, abs=1e-6)
    assert signed_distance(b, a) == pytest.approx(distance, abs=1e-6)


@pytest.mark.parametrize("turn", [0.0, 3.0, 10.0, 45.0])
def test_cylinders_are_round_to_a_few_thousandths_of_their_radius(turn):
    a = shape("cylinder", (1, 1, 1), turn=(turn, 0, 0))
    for gap in (-0.05, 0.2):
        b = shape("cylinder", (1, 1, 1), (2 + gap, 0, 0))
        assert signed_distance(a, b) == pytest.approx(gap, abs=0.004)
    lid = shape(*UNIT_BOX, at=(0, 0, 1.97))
    assert signed_distance(a, lid) == pytest.approx(-0.03, abs=1e-6)


coordinate = st.floats(-1.5, 1.5)
angle = st.floats(-180, 180)
solid = st.sampled_from(
    [("box", (0.5, 0.3, 0.2)), ("cylinder", (0.4, 0.4, 0.3)), ("sphere", (0.4,) * 3),
     ("capsule", (0.2, 0.2, 0.4))]
)  # fmt: skip


@settings(max_examples=60, deadline=None)
@given(solid, solid, st.tuples(coordinate, coordinate, coordinate), st.tuples(angle, angle, angle))
def test_moving_both_changes_nothing_and_separating_by_the_depth_separates(a, b, offset, turn):
    first, second = shape(*a), shape(*b, at=offset, turn=turn)
    distance = signed_distance(first, second)
    assert signed_distance(second, first) == pytest.approx(distance, abs=1e-6)
    q = quat_from_euler_deg(40, 20, 70)
    move = np.array([3.0, -2.0, 1.0])
    both = signed_distance(place(first, move, q), place(second, move, q))
    assert both == pytest.approx(distance, abs=1e-6)
    # No direction separates an overlapping pair with less than the depth.
    if distance < -1e-3:
        for direction in np.vstack([np.eye(3), -np.eye(3)]):
            moved = place(second, direction * (-distance * 0.95), np.array([0.0, 0, 0, 1]))
            assert signed_distance(first, moved) < 0


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(coordinate, coordinate, coordinate), min_size=4, max_size=12))
def test_distance_of_hulls_agrees_with_a_quadratic_program(points):
    from scipy.optimize import nnls

    a = np.array(points)
    b = np.array([[4.0, 0, 0], [4.5, 1, 0], [5.0, -1, 1], [4.2, 0.3, -1]])
    distance = gjk_distance(a, b)
    # min |A x - B y| with convex weights, as least squares with a heavy sum-to-one row each.
    heavy = 1e4
    matrix = np.hstack([a.T, -b.T])
    rows = np.zeros((2, matrix.shape[1]))
    rows[0, : len(a)] = rows[1, len(a) :] = heavy
    x, _ = nnls(np.vstack([matrix, rows]), np.array([0, 0, 0, heavy, heavy]), maxiter=5000)
    assert distance == pytest.approx(float(np.linalg.norm(matrix @ x)), abs=2e-3)


def test_flat_point_sets_have_no_depth():
    square = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], float)
    assert core_depth(square, square) == 0.0
