"""Mass properties against closed forms."""

from __future__ import annotations

import itertools
import math

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
import pytest

from esg.assets.geometry.massprops import mass_properties
from esg.graph.models import Proxy, ProxyKind
from esg.units import quat_from_euler_deg, quat_rotate


def box(half: tuple[float, float, float], center=(0.0, 0.0, 0.0), **kw) -> Proxy:
    return Proxy(kind=ProxyKind.BOX, size_cm=half, position_cm=center, **kw)


def hull_of_box(half: tuple[float, float, float], center=(0.0, 0.0, 0.0)) -> Proxy:
    corners = tuple(
        (x * half[0], y * half[1], z * half[2]) for x, y, z in itertools.product((-1, 1), repeat=3)
    )
    return Proxy(kind=ProxyKind.CONVEX, size_cm=half, position_cm=center, vertices_cm=corners)


def test_sphere_has_two_fifths_m_r_squared() -> None:
    ball = Proxy(kind=ProxyKind.SPHERE, size_cm=(5, 5, 5), position_cm=(1, 2, 5))
    com, inertia = mass_properties([ball], 3.0)
    assert com == pytest.approx((1, 2, 5))
    assert inertia == pytest.approx((30.0, 30.0, 30.0, 0, 0, 0))


def test_upright_cylinder() -> None:
    can = Proxy(kind=ProxyKind.CYLINDER, size_cm=(3, 3, 6), position_cm=(0, 0, 6))
    com, inertia = mass_properties([can], 2.0)
    side = 2.0 * (3 * 9 + 144) / 12
    assert com == pytest.approx((0, 0, 6))
    assert inertia == pytest.approx((side, side, 9.0, 0, 0, 0))


def test_capsule_is_a_tube_between_two_hemispheres() -> None:
    capsule = Proxy(kind=ProxyKind.CAPSULE, size_cm=(2, 2, 4))
    _, inertia = mass_properties([capsule], 1.0)
    # Numerical integration of discs along the axis.
    z = np.linspace(-6, 6, 200_001)
    r2 = np.where(np.abs(z) <= 4, 4.0, np.maximum(4.0 - (np.abs(z) - 4) ** 2, 0.0))
    area = math.pi * r2
    mass = np.trapezoid(area, z)
    axial = np.trapezoid(area * r2 / 2, z) / mass
    side = np.trapezoid(area * (r2 / 4 + z * z), z) / mass
    assert inertia[:3] == pytest.approx((side, side, axial), rel=1e-6)


@given(
    st.tuples(*[st.floats(0.5, 80)] * 3),
    st.tuples(*[st.floats(-200, 200)] * 3),
    st.floats(0.01, 5000),
)
def test_hull_of_a_box_equals_the_box(half, center, mass) -> None:
    com_a, inertia_a = mass_properties([box(half, center)], mass)
    com_b, inertia_b = mass_properties([hull_of_box(half, center)], mass)
    assert com_b == pytest.approx(com_a, abs=1e-6 * max(1, *map(abs, center)))
    assert inertia_b == pytest.approx(inertia_a, rel=1e-6, abs=1e-6 * max(inertia_a))


def test_halves_of_a_box_add_up_to_it() -> None:
    whole = mass_properties([box((4, 3, 2), (1, 1, 2))], 6.0)
    halves = [box((2, 3, 2), (-1, 1, 2)), box((2, 3, 2), (3, 1, 2))]
    com, inertia = mass_properties(halves, 6.0)
    assert com == pytest.approx(whole[0])
    assert inertia == pytest.approx(whole[1])


def test_turned_box_has_the_turned_tensor() -> None:
    q = quat_from_euler_deg(30, 20, 10)
    _, straight = mass_properties([box((5, 2, 1))], 4.0)
    _, turned = mass_properties([box((5, 2, 1), orientation_xyzw=tuple(q))], 4.0)

    def tensor(v):
        xx, yy, zz, xy, xz, yz = v
        return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])

    r = quat_rotate(q, np.eye(3)).T
    assert tensor(turned) == pytest.approx(r @ tensor(straight) @ r.T)


def test_denser_part_draws_the_centre_of_mass() -> None:
    parts = [box((1, 1, 1), (0, 0, 1)), box((1, 1, 1), (0, 0, 5))]
    com, _ = mass_properties(parts, 1.0, [3.0, 1.0])
    assert com == pytest.approx((0, 0, 2.0))
