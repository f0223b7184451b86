"""What is looked at: bevels, normals, texture coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import trimesh
from trimesh.visual import TextureVisuals
from trimesh.visual.material import PBRMaterial

from esg.assets import build_mesh
from esg.assets.geometry import finishing, shapes
from esg.assets.geometry.bevels import bevelled
from esg.assets.geometry.finishing import Drawing, Surface, completed, split_normals
from esg.assets.geometry.mesh import closed_mesh
from esg.assets.library.catalogue import entries_by_name
from esg.assets.stage import configure
from esg.machine.recent import Recent
from tests.assets.worlds import requirement


def finished(mesh: Any, *tile: float, **how: Any) -> Surface:
    """The surface of a part that draws this mesh."""
    return finishing.finished(Drawing(lambda: mesh), *tile, **how)


def unit_lengths(vectors: np.ndarray) -> np.ndarray:
    return np.linalg.norm(vectors, axis=1)


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("make", ["box", "rod", "hexagon"])
def test_a_bevelled_shape_is_closed_and_a_little_less(make: str, turned: bool) -> None:
    """Same extents, outward faces, and only edges and corners are gone."""
    mesh = {
        "box": lambda: shapes.box((60, 30, 10), (0, 0, 0)),
        "rod": lambda: shapes.rod(8, (0, 0, 0), (0, 0, 30)),
        "hexagon": lambda: shapes.rod(8, (0, 0, 0), (30, 0, 0), 6),
    }[make]()
    if turned:
        mesh.apply_transform(trimesh.transformations.rotation_matrix(0.7, [1, 2, 3]))
        mesh.vertices = mesh.vertices * (1.0, 1.3, 0.7)
    vertices, faces, soft = bevelled(mesh, 1.0)
    out = trimesh.Trimesh(vertices, faces, process=False)
    assert soft and out.is_watertight and out.is_winding_consistent
    assert 0.95 * mesh.volume < out.volume < mesh.volume
    if not turned:
        np.testing.assert_allclose(out.bounds, mesh.bounds, atol=1e-9)


def test_sheets_and_small_parts_stay_sharp() -> None:
    assert not bevelled(shapes.box((60, 30, 0.1), (0, 0, 0)), 1.0)[2]
    assert not bevelled(shapes.box((2, 2, 2), (0, 0, 0)), 5.0)[2]


def test_a_ball_is_smooth_and_a_box_is_not() -> None:
    ball = trimesh.creation.icosphere(3)
    normals = split_normals(np.asarray(ball.vertices), np.asarray(ball.faces), 40.0)
    np.testing.assert_allclose(normals, ball.vertices[ball.faces].reshape(-1, 3), atol=0.02)
    box = trimesh.creation.box((1, 2, 3))
    normals = split_normals(np.asarray(box.vertices), np.asarray(box.faces), 40.0)
    np.testing.assert_allclose(normals, np.repeat(box.face_normals, 3, axis=0), atol=1e-12)


def test_a_rod_is_smooth_around_and_has_flat_ends() -> None:
    surface = finished(shapes.rod(5, (0, 0, 0), (0, 0, 20)), 10.0)
    upright = np.abs(surface.normals[:, 2])
    assert ((upright < 1e-6) | (upright > 1 - 1e-6)).all()
    side = upright < 1e-6
    radial = surface.vertices[side, :2] / 5.0
    assert (radial * surface.normals[side, :2]).sum(1).min() > 0.999


def test_bevels_are_shaded_into_their_faces() -> None:
    """At every corner the normal is nearly that of a big face: no facet of the bevel shows."""
    surface = finished(shapes.box((60, 30, 10), (0, 0, 0)), 10.0, smallest_cm=1.0)
    assert np.abs(surface.normals).max(axis=1).min() > 0.99


@pytest.mark.parametrize("grain", [False, True])
@pytest.mark.parametrize(
    "mesh",
    [
        shapes.box((60, 30, 10), (5, 5, 5), (0, 0, 0.3826834, 0.9238795)),
        shapes.rod(40, (0, 0, 0), (100, 20, 0), 48),
        shapes.extrude([(0, 0), (80, 0), (60, 40), (0, 50)], (0, 20)),
    ],
    ids=["box", "rod", "prism"],
)
def test_texels_are_as_large_as_the_material_says_and_never_mirrored(
    mesh: trimesh.Trimesh, grain: bool
) -> None:
    """Area in tiles is area on the surface over that of a tile; slanted faces are foreshortened."""
    tile = 20.0
    surface = finished(mesh, tile, grain=grain)
    flat, solid = surface.uvs[surface.faces], surface.vertices[surface.faces]
    a, b = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    signed = 0.5 * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) * tile**2
    cross = np.cross(solid[:, 1] - solid[:, 0], solid[:, 2] - solid[:, 0])
    area = 0.5 * np.linalg.norm(cross, axis=1)
    assert (signed > 0.55 * area).all() and (signed < 1.1 * area).all()


def test_grain_runs_along_the_length() -> None:
    """u grows along the length of a leg, and along that of a rod that lies at a slant."""
    leg = finished(shapes.box((4, 4, 70), (0, 0, 35)), 50.0, grain=True)
    side = np.abs(leg.normals[:, 2]) < 0.5
    slope = np.polyfit(leg.vertices[side, 2], leg.uvs[side, 0], 1)[0]
    assert abs(slope) == pytest.approx(1 / 50.0, rel=1e-6)
    rod = finished(shapes.rod(2, (0, 0, 0), (60, 0, 80)), 50.0, grain=True)
    along = rod.vertices @ (0.6, 0.0, 0.8)
    side = np.abs(rod.normals @ (0.6, 0.0, 0.8)) < 0.5
    assert abs(np.polyfit(along[side], rod.uvs[side, 0], 1)[0]) == pytest.approx(1 / 50.0, rel=1e-6)


def test_the_seam_of_a_rod_is_not_smeared() -> None:
    """No face is drawn across the whole texture where the angle jumps."""
    surface = finished(shapes.rod(40, (0, 0, 0), (0, 0, 30), 36), 20.0)
    assert np.ptp(surface.uvs[surface.faces][:, :, 0], axis=1).max() < 4.5


def test_what_a_foreign_mesh_lacks_is_added_and_the_rest_kept() -> None:
    material = PBRMaterial(baseColorFactor=[200, 10, 10, 255])
    bare = trimesh.creation.box((300, 200, 100))
    bare.visual = TextureVisuals(material=material)
    done = completed(bare, 100.0)
    assert np.ptp(done.visual.uv, axis=0).max() == pytest.approx(3.0)
    assert done.visual.material is material
    np.testing.assert_allclose(np.abs(done.vertex_normals).max(axis=1), 1.0)
    assert completed(done, 100.0) is done


@pytest.mark.parametrize("name", ["car", "table", "bicycle", "bottle"])
def test_an_asset_is_one_mesh_a_look_with_unit_normals(name: str) -> None:
    config = configure(name, requirement(entries_by_name()[name]))
    scene = build_mesh(config)
    parents = scene.graph.transforms.parents
    seen = set()
    for node in scene.graph.nodes_geometry:
        mesh = scene.geometry[scene.graph[node][1]]
        key = parents[node], mesh.metadata["look"], mesh.metadata["color"]
        assert key not in seen
        seen.add(key)
        assert mesh.visual.uv.shape == (len(mesh.vertices), 2)
        np.testing.assert_allclose(unit_lengths(mesh.vertex_normals), 1.0, atol=1e-6)
        facing = (mesh.vertex_normals[mesh.faces] * mesh.face_normals[:, None]).sum(2)
        assert np.quantile(facing, 0.02) > 0.0
        assert not node.startswith("part_")
    sharp = closed_mesh(config)
    np.testing.assert_allclose(scene.bounds, sharp.bounds, atol=0.1)


def test_an_asset_drawn_twice_is_the_same_and_its_arrays_are_nobody_s_to_change() -> None:
    config = configure("chair", requirement(entries_by_name()["chair"]))
    first, again = build_mesh(config), build_mesh(config)
    assert first is not again
    for name, mesh in first.geometry.items():
        np.testing.assert_array_equal(mesh.vertices, again.geometry[name].vertices)
        with pytest.raises(ValueError, match="read-only"):
            mesh.vertices[0, 0] = 7.0
    moved = build_mesh(config)
    moved.apply_transform(np.diag([2.0, 2.0, 2.0, 1.0]))
    moved.dump()
    for name, mesh in build_mesh(config).geometry.items():
        np.testing.assert_array_equal(mesh.vertices, again.geometry[name].vertices)


def test_the_same_part_is_finished_once_and_a_process_keeps_so_much(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its surface depends on all that is asked of it, and nobody may write to it."""
    monkeypatch.setattr(finishing, "_surfaces", Recent(10**6, finishing._bytes))
    first = finished(shapes.box((60, 30, 10), (0, 0, 0)), 100.0)
    assert finished(shapes.box((60, 30, 10), (0, 0, 0)), 100.0) is first
    with pytest.raises(ValueError, match="read-only"):
        first.vertices[0] = 0.0
    others = [
        finished(shapes.box((60, 30, 10), (0, 0, 1)), 100.0),
        finished(shapes.box((60, 30, 10), (0, 0, 0)), 50.0),
        finished(shapes.box((60, 30, 10), (0, 0, 0)), 100.0, smallest_cm=1.0),
    ]
    assert all(len({id(a), id(first)}) == 2 for a in others)
    assert len(finishing._surfaces) == 4
    monkeypatch.setattr(finishing, "_surfaces", Recent(10, finishing._bytes))
    again = finished(shapes.box((60, 30, 10), (0, 0, 0)), 100.0)
    assert again is not first and np.array_equal(again.normals, first.normals)
