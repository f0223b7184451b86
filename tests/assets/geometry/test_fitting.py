"""Proxy fits, convex parts and distance fields against analytic bodies."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import trimesh

from esg.assets.geometry.boxes import box_parts, margin, steadied
from esg.assets.geometry.convex import available, convex_parts
from esg.assets.geometry.fitting import fit_proxies, support_surfaces
from esg.assets.geometry.massprops import proxy_moments
from esg.assets.geometry.sdf import voxel_sdf
from esg.assets.imports.describe import sample


def raised(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    mesh.apply_translation([0, 0, -mesh.bounds[0][2]])
    return mesh


def table() -> trimesh.Trimesh:
    top = trimesh.creation.box(bounds=[[-60, -40, 70], [60, 40, 75]])
    legs = [
        trimesh.creation.box(bounds=[[x - 3, y - 3, 0], [x + 3, y + 3, 70]])
        for x in (-55, 55)
        for y in (-35, 35)
    ]
    return trimesh.util.concatenate([top, *legs])


def test_primitives_are_recognized() -> None:
    box = raised(trimesh.creation.box(extents=(30, 20, 10)))
    ball = raised(trimesh.creation.icosphere(subdivisions=3, radius=7))
    can = raised(trimesh.creation.cylinder(radius=4, height=12, sections=48))
    (found,), concave = fit_proxies(box.vertices)
    assert found.kind.value == "box" and not concave
    assert found.size_cm == pytest.approx((15, 10, 5))
    (found,), _ = fit_proxies(ball.vertices, round_allowed=True)
    assert found.kind.value == "sphere" and found.size_cm[0] == pytest.approx(7, rel=0.02)
    (found,), _ = fit_proxies(can.vertices)
    assert found.kind.value == "cylinder" and found.size_cm == pytest.approx((4, 4, 6), rel=0.02)


def test_a_ball_that_must_not_roll_gets_a_standing_shape() -> None:
    ball = raised(trimesh.creation.icosphere(subdivisions=3, radius=7))
    (found,), _ = fit_proxies(ball.vertices)
    assert found.kind.value == "convex"


def test_table_is_concave_and_has_a_top() -> None:
    mesh = table()
    mesh = trimesh.Trimesh(*trimesh.remesh.subdivide(mesh.vertices, mesh.faces))
    points = sample(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    _, concave = fit_proxies(points)
    assert concave
    top = support_surfaces(np.asarray(mesh.vertices), np.asarray(mesh.faces))[0]
    assert top.center_cm == pytest.approx((0, 0, 75), abs=0.1)
    assert top.half_extents_cm == pytest.approx((57, 38), rel=0.02)


def test_boxes_follow_a_table_and_stand() -> None:
    mesh = table()
    parts = box_parts(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    assert parts is not None and 5 <= len(parts) <= 28
    solid = 120 * 80 * 5 + 4 * 6 * 6 * 70
    volume = sum(proxy_moments(p)[0] for p in parts)
    assert 0.7 * solid < volume < 2.5 * solid
    assert margin(parts) > 20
    assert steadied(parts, np.asarray(mesh.vertices)) == parts
    under = [p for p in parts if abs(p.position_cm[0]) < 20 and p.position_cm[2] < 40]
    assert not under, "the space under the table must stay free"


def test_what_would_tip_gets_a_foot() -> None:
    mesh = trimesh.creation.cone(radius=10, height=30)
    mesh.apply_transform(trimesh.transformations.rotation_matrix(np.pi, [1, 0, 0]))
    mesh = raised(mesh)
    proxies, _ = fit_proxies(np.asarray(mesh.vertices))
    assert margin(proxies) < 0.1
    assert margin(steadied(proxies, np.asarray(mesh.vertices))) > 1


@pytest.mark.slow
@pytest.mark.skipif(not available(), reason="coacd is an extra")
def test_convex_parts_follow_a_table_and_are_cached(tmp_path: Path) -> None:
    mesh = table()
    args = np.asarray(mesh.vertices, float), np.asarray(mesh.faces, np.int64)
    parts = convex_parts(*args, tmp_path)
    assert parts is not None and len(parts) >= 4
    volume = sum(proxy_moments(p)[0] for p in parts)
    solid = 120 * 80 * 5 + 4 * 6 * 6 * 70
    assert solid * 0.8 < volume < 0.35 * 120 * 80 * 75
    assert convex_parts(*args, tmp_path) == parts and len(list(tmp_path.glob("*.json"))) == 1


def test_field_of_a_sphere_is_its_distance() -> None:
    mesh = trimesh.creation.icosphere(subdivisions=4, radius=10)
    field = voxel_sdf(mesh.vertices, mesh.faces, 40)
    points = np.array([[0, 0, 0], [5, 0, 0], [0, 0, -9], [10.5, 0, 0]], float)
    expected = np.linalg.norm(points, axis=1) - 10
    np.testing.assert_allclose(field.sample(points), expected, atol=field.cell_cm)
    assert field.volume_cm3 == pytest.approx(4 / 3 * math.pi * 1000, rel=0.02)


def test_sign_survives_a_hole(tmp_path: Path) -> None:
    mesh = trimesh.creation.box(extents=(20, 20, 20))
    mesh = trimesh.Trimesh(*trimesh.remesh.subdivide(mesh.vertices, mesh.faces))
    open_faces = np.asarray(mesh.faces)[1:]
    field = voxel_sdf(mesh.vertices, open_faces, 32, tmp_path)
    assert field.sample(np.array([[0.0, 0, 0], [10.8, 10.8, 10.8]]))[0] < -8
    assert field.volume_cm3 == pytest.approx(8000, rel=0.08)
    again = voxel_sdf(mesh.vertices, open_faces, 32, tmp_path)
    assert (again.values == field.values).all()
