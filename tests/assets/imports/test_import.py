"""Importers: orientation, scale, licence, resumption, broken input."""

from __future__ import annotations

import json
from pathlib import Path
import zipfile

import numpy as np
import pytest
import trimesh

from esg.assets import build_mesh, search
from esg.assets.commands import import_assets, list_assets, show
from esg.assets.imports.importer import frame, import_folder
from esg.assets.imports.sources import parse_properties
from esg.assets.library.retrieve import decide
from esg.assets.stage import configure
from esg.graph.models import AssetRequirement
from esg.outcomes import UserError
from tests.disks import small_files


@pytest.fixture(autouse=True)
def library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ESG_ASSET_LIBRARY", str(tmp_path / "library"))
    return tmp_path / "library"


def wedge() -> trimesh.Trimesh:
    """Y-up, front +Z: 2 wide (X), 1 high (Y), 3 deep (Z), high at the back."""
    points = [(x, y, z) for x in (-1, 1) for y, z in ((0, -1.5), (0, 1.5), (1, -1.5))]
    return trimesh.convex.convex_hull(np.array(points, float))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    source = tmp_path / "models"
    source.mkdir()
    wedge().export(source / "wedge.obj")
    trimesh.creation.icosphere(radius=0.2).export(source / "orb.glb")
    (source / "broken.obj").write_text("this is not a mesh\n")
    (source / "catalogue.csv").write_text(
        "file,name,tags,length_cm,width_cm,height_cm,mass_kg,license,creator,source\n"
        "wedge.obj,cheese wedge sculpture,art;display,300,200,100,12,CC-BY-4.0,A. Maker,example\n"
    )
    return source


def test_model_is_turned_scaled_and_grounded(folder: Path) -> None:
    report = import_folder(folder, library="mine")
    assert sorted(report.imported) == ["orb", "wedge"]
    assert [k for k, p in report.problems if not p.startswith("warning")] == ["broken"]
    config = configure("a", show_requirement("cheese wedge sculpture", (300, 200, 100), 12))
    assert config.source == "library" and config.asset_name == "mine/wedge"
    assert config.mass_kg == 12
    assert config.license == "CC-BY-4.0" and "A. Maker" in config.attribution
    scene = build_mesh(config)
    np.testing.assert_allclose(scene.bounds, [[-150, -100, 0], [150, 100, 100]], atol=1e-2)
    points = np.concatenate([g.vertices for g in scene.geometry.values()])
    high = points[points[:, 2] > 99]
    assert (high[:, 0] < -149).all(), "the front of a model that faces +Z must be +X"
    lowest = min(
        p.position_cm[2] + min(v[2] for v in p.vertices_cm or ((0, 0, -p.size_cm[2]),))
        for p in config.proxies
    )
    assert lowest == pytest.approx(0, abs=1e-3)


def test_a_model_without_normals_gets_them(folder: Path) -> None:
    """A wedge has sharp edges: every corner of a face has the face's own normal."""
    import_folder(folder, library="mine")
    config = configure("a", show_requirement("cheese wedge sculpture", (300, 200, 100), 12))
    (mesh,) = build_mesh(config).geometry.values()
    np.testing.assert_allclose(
        mesh.vertex_normals[mesh.faces],
        np.repeat(mesh.face_normals[:, None], 3, axis=1),
        atol=1e-6,
    )


def show_requirement(name: str, size: tuple[float, float, float], mass: float) -> AssetRequirement:
    return AssetRequirement(
        asset_category=name,
        asset_description=name,
        expected_dimensions_cm=size,
        expected_mass_kg=mass,
    )


def test_second_import_changes_nothing_and_a_changed_file_is_redone(folder: Path) -> None:
    import_folder(folder, library="mine")
    again = import_folder(folder, library="mine")
    assert again.imported == [] and sorted(again.unchanged) == ["orb", "wedge"]
    trimesh.creation.icosphere(radius=0.3).export(folder / "orb.glb")
    assert import_folder(folder, library="mine").imported == ["orb"]


def test_imported_assets_are_listed_found_and_shown(folder: Path) -> None:
    import_assets(folder, library="mine")
    assert {"mine/wedge", "mine/orb"} <= {r["name"] for r in list_assets()}
    assert search("cheese wedge sculpture")[0].asset_name == "mine/wedge"
    assert show("mine/wedge")["configuration"]["source"] == "library"
    with pytest.raises(UserError, match="nearest are"):
        show("no such thing at all")


def test_embedded_names_keep_deciding(folder: Path) -> None:
    import_folder(folder, library="mine")
    assert decide(show_requirement("car", (455, 182, 146), 1450)).entry.library == "parametric"


def test_sweet_home_library(tmp_path: Path) -> None:
    obj = trimesh.exchange.obj.export_obj(wedge(), include_normals=False)
    archive = tmp_path / "Tiny.sh3f"
    with zipfile.ZipFile(archive, "w") as bundle:
        bundle.writestr(
            "PluginFurnitureCatalog.properties",
            "name=Tiny\nlicense=CC0\nid#1=Tiny#wedge\nname#1=Door \\\n  wedge\ncategory#1=Misc\n"
            "model#1=/tiny/wedge.obj\nwidth#1=20\ndepth#1=30\nheight#1=10\ncreator#1=Me\n"
            "id#2=Tiny#lost\nname#2=Lost\nmodel#2=/tiny/lost.obj\nwidth#2=1\ndepth#2=1\nheight#2=1\n",
        )
        bundle.writestr("tiny/wedge.obj", obj)
    report = import_assets(archive)
    assert report["imported"] == 1
    assert report["problems"] == [
        {"asset": "tiny_lost", "problem": "model file lost.obj is missing"}
    ]
    shown = show("tiny/tiny_wedge")
    assert shown["configuration"]["dimensions_cm"] == pytest.approx([30, 20, 10])
    assert shown["license"] == "CC0"


def test_bad_input_is_one_message(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="does not exist"):
        import_folder(tmp_path / "nowhere")
    empty = tmp_path / "empty"
    empty.mkdir()
    with pytest.raises(UserError, match=r"found no \.sh3f"):
        import_folder(empty)
    fake = tmp_path / "fake.sh3f"
    fake.write_text("no zip")
    with pytest.raises(UserError, match="cannot be read"):
        import_folder(fake)
    (empty / "catalogue.json").write_text(
        json.dumps([{"file": "a.obj", "mass_kg": -1}, {"name": "x", "colour": "red"}])
    )
    with pytest.raises(UserError) as caught:
        import_folder(empty)
    assert all(t in str(caught.value) for t in ("row 1", "mass_kg", "row 2", "colour"))


def test_absurd_size_is_reported(tmp_path: Path) -> None:
    source = tmp_path / "huge"
    source.mkdir()
    trimesh.creation.box(extents=(500, 500, 500)).export(source / "thing.glb")
    report = import_folder(source)
    assert report.imported == [] and "absurd size" in report.problems[0][1]


def test_frames_are_rotations() -> None:
    for up in "yz":
        for front in ("+x", "-x", "+y", "-y", "+z", "-z"):
            if front[1] == up:
                with pytest.raises(ValueError, match="same axis"):
                    frame(up, front)
            else:
                assert np.linalg.det(frame(up, front)) == pytest.approx(1)


def test_properties_with_escapes() -> None:
    text = "# comment\na\\ b=1\nname#1=caf\\u00e9 \\\n   noir\n"
    assert parse_properties(text) == {"a\\ b": "1", "name#1": "café noir"}


def test_missing_textures_are_reported_and_the_model_goes_in(tmp_path: Path) -> None:
    source = tmp_path / "painted"
    source.mkdir()
    box = trimesh.exchange.obj.export_obj(trimesh.creation.box(extents=(1, 1, 1)))
    (source / "cube.obj").write_text("mtllib cube.mtl\n" + box)
    (source / "cube.mtl").write_text("newmtl a\nKd 1 0 0\nmap_Kd -s 2 2 1 lost.jpg\n")
    (source / "bare.obj").write_text("mtllib gone.mtl\n" + box)
    report = import_folder(source)
    assert sorted(report.imported) == ["bare", "cube"]
    problems = dict(p for p in report.problems if "missing" in p[1])
    assert problems == {
        "cube": "warning: texture lost.jpg is missing",
        "bare": "warning: texture gone.mtl is missing",
    }


def test_a_full_disk_stops_the_import_and_blames_no_model(folder: Path, library: Path) -> None:
    with pytest.raises(UserError, match=r"cannot write .*raise the limit"), small_files(300):
        import_folder(folder, library="mine")
    assert not [p for p in library.rglob("*") if p.is_file() and p.stat().st_size]
    assert sorted(import_folder(folder, library="mine").imported) == ["orb", "wedge"]
