"""GLB files: glTF units and axes, determinism, errors."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
import trimesh

from esg.assets import build_mesh, resolve, write_meshes
from esg.assets.appearance import Appearance
from esg.assets.geometry import mesh
from esg.assets.geometry.mesh import glb_bytes
from esg.assets.gltf.asset import asset_glb
from esg.assets.library.catalogue import entries_by_name
from esg.assets.stage import configure
from esg.outcomes import UserError
from tests.assets.worlds import EMPTY, requirement


def document(*names: str):
    needs = {n: requirement(entries_by_name()[n]) for n in names}
    return resolve(EMPTY.model_copy(update={"asset_requirement": needs}))


def test_glb_is_in_metres_with_y_up_and_front_x() -> None:
    config = configure("jeep", requirement(entries_by_name()["jeep"]))
    scene = trimesh.load(io.BytesIO(glb_bytes(config)), file_type="glb")
    local = build_mesh(config)
    lo, hi = local.bounds / 100.0
    np.testing.assert_allclose(scene.bounds[0], [lo[0], lo[2], -hi[1]], atol=1e-4)
    np.testing.assert_allclose(scene.bounds[1], [hi[0], hi[2], -lo[1]], atol=1e-4)


def test_files_land_at_their_paths_and_repeat_bit_for_bit(tmp_path: Path) -> None:
    doc = document("bowling_pin", "bottle")
    one = write_meshes(doc, tmp_path / "a")
    two = write_meshes(doc, tmp_path / "b")
    assert one == two and len(one["bottle"]) == 64
    for config in doc.asset_configurations.values():
        a, b = ((tmp_path / k / config.mesh_path).read_bytes() for k in "ab")
        assert a == b and a[:4] == b"glTF"
    assert not list(tmp_path.rglob("*.part"))


def test_color_reaches_the_material() -> None:
    red = configure("car", requirement(entries_by_name()["car"], color="red"))
    blue = configure("car", requirement(entries_by_name()["car"], color="blue"))
    assert glb_bytes(red) != glb_bytes(blue)


def test_unwritable_folder_is_one_clear_message(tmp_path: Path) -> None:
    (tmp_path / "meshes").write_text("a file where a folder should be")
    with pytest.raises(UserError, match="cannot write"):
        write_meshes(document("can"), tmp_path)


@pytest.mark.parametrize("name", ["car", "crate", "bottle", "ball", "ground"])
def test_files_of_models_are_those_of_their_scene(name: str) -> None:
    """A file whose meshes are kept, drawn for another look, has the bytes of one that is drawn."""
    entry = entries_by_name()[name]
    for seed in (1, 2):
        how = entry, entry.dimensions_cm, entry.color_rgb, False, Appearance(seed=seed)
        assert mesh._drawn_glb(*how) == asset_glb(mesh._drawn(*how))
    mesh._models.cache_clear()
    mesh._drawn_glb.cache_clear()
    again = entry, entry.dimensions_cm, entry.color_rgb, False, Appearance(seed=3)
    models, _ = mesh._models(*again)
    assert mesh._drawn_glb(*again)
    assert not any("_surface" in vars(model) for model in models)
