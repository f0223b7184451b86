"""What a file says that it holds is looked at before anything is made for it."""

from __future__ import annotations

from collections.abc import Callable
import json
from pathlib import Path
import struct
from typing import Any
import zipfile
import zlib

import numpy as np
import pytest
import trimesh

from benchmarks.faults.tampering import LIES, array_of, box, glb
from esg.assets.imports.importer import import_folder
from esg.assets.imports.sources import read_sh3f
from esg.commands.report import report
from esg.engines.rollout_file import load_rollout
from esg.outcomes import UserError
from esg.scenereading import read_rollout
from esg.store import tables
from esg.strangers import arrays, gltf
from esg.view import png16
from tests.report.folders import write_scene


@pytest.mark.parametrize(
    "lie",
    LIES,
)
def test_a_model_that_lies_is_shown_by_its_collision_shapes(
    lie: Callable[[dict[str, Any]], None], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It is told; the page is there."""
    document, binary = box()
    lie(document)
    data = glb(document, binary)
    with pytest.raises(ValueError, match=r"/|nested"):
        gltf.read_glb(data)
    scene = write_scene(tmp_path / "scene")
    manifest = json.loads((scene / "manifest.json").read_text())
    manifest["bodies"][0]["mesh"] = "meshes/ball.glb"
    (scene / "manifest.json").write_text(json.dumps(manifest))
    (scene / "meshes").mkdir()
    (scene / "meshes" / "ball.glb").write_bytes(data)
    assert report(scene) == 3
    assert "its collision shapes are shown" in capsys.readouterr().err


def test_a_texture_of_gigapixels_is_not_decoded() -> None:
    """A picture of 100,000 x 100,000 pixels is 45 bytes of header."""
    head = struct.pack(">IIBBBBB", 100_000, 100_000, 8, 2, 0, 0, 0)
    chunk = struct.pack(">I", 13) + b"IHDR" + head + struct.pack(">I", zlib.crc32(b"IHDR" + head))
    bomb = b"\x89PNG\r\n\x1a\n" + chunk + struct.pack(">I", 0) + b"IDAT" + bytes(4)
    document, binary = box()
    document["images"] = [{"bufferView": len(document["bufferViews"]), "mimeType": "image/png"}]
    document["bufferViews"].append(
        {"buffer": 0, "byteOffset": len(binary), "byteLength": len(bomb)}
    )
    document["buffers"][0]["byteLength"] = len(binary) + len(bomb)
    with pytest.raises(ValueError, match="/images/0"):
        gltf.read_glb(glb(document, binary + bomb))


def test_our_own_models_pass(made: Path) -> None:
    """All of a scene, and the scene itself."""
    models = [made / "scene.glb", *(made / "meshes").glob("*.glb")]
    assert len(models) > 1
    for path in models:
        gltf.read_glb(path.read_bytes())


@pytest.mark.parametrize(
    "entry",
    [
        array_of((10**12,), b"\0" * 80),
        array_of((10**6, 10**6, 10**6), b""),
        array_of((2,), b"\0" * 80),
        array_of((1,), b"\0" * 8, "|O"),
        b"not an array",
    ],
)
def test_a_recording_that_lies_is_damaged(entry: bytes, tmp_path: Path) -> None:
    """One message; nothing of the declared size is allocated."""
    path = tmp_path / "rollout.npz"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("time.npy", entry)
    with pytest.raises(ValueError, match=r".*"):
        load_rollout(path)
    with pytest.raises(UserError, match="not a recording"):
        read_rollout(path, 2)


def test_a_recording_that_unpacks_to_gigabytes_is_damaged(tmp_path: Path) -> None:
    """4 GiB of zeros are 4 MB packed, and a header says so before they are unpacked."""
    path = tmp_path / "bomb.npz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        archive.writestr("time.npy", array_of((2**20,), bytes(2**23)))
    with pytest.raises(ValueError, match="unpacks to"):
        arrays.check_npz(path, 2**22)
    arrays.check_npz(path, 2**24)


def test_an_archive_is_unpacked_only_if_it_is_bearable(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A library of furniture that says how much is in it."""
    path = tmp_path / "lamps.sh3f"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("PluginFurnitureCatalog.properties", "name#1=Lamp\nmodel#1=/lamp.obj\n")
        archive.writestr("lamp.obj", bytes(2**20))
    monkeypatch.setattr("esg.assets.imports.sources.MOST_UNPACKED_BYTES", 2**16)
    with pytest.raises(UserError, match="unpacks to"):
        list(read_sh3f(path, tmp_path / "out"))


@pytest.mark.parametrize("model", ["/../../secret.obj", "../secret.obj", "/a%00b", "a\\u0000b"])
def test_a_catalogue_cannot_name_what_lies_outside(
    model: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The model is left out and told; the others are imported."""
    monkeypatch.setenv("ESG_ASSET_LIBRARY", str(tmp_path / "data"))
    trimesh.creation.box().export(tmp_path / "secret.obj")
    inside = trimesh.creation.box().export(file_type="obj")
    assert isinstance(inside, str)
    path = tmp_path / "lamps.sh3f"
    listing = (
        f"name#1=Lamp\nid#1=evil\nmodel#1={model}\n"
        "name#2=Stool\nid#2=stool\nmodel#2=/stool.obj\nwidth#2=40\ndepth#2=40\nheight#2=50\n"
    )
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("PluginFurnitureCatalog.properties", listing)
        archive.writestr("stool.obj", inside)
    done = import_folder(path, library="lamps")
    assert done.imported == ["lamps_stool"]
    assert [key for key, _ in done.problems if "evil" in key] == ["lamps_evil"]


def test_a_model_cannot_read_files_outside_its_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A glTF file whose buffer is somebody's key, a folder with a link to one."""
    monkeypatch.setenv("ESG_ASSET_LIBRARY", str(tmp_path / "data"))
    secret = tmp_path / "key.bin"
    secret.write_bytes(b"K" * 4096)
    library = tmp_path / "library"
    library.mkdir()
    document, binary = box()
    (library / "good.bin").write_bytes(binary)
    for name, uri in (("good", "good.bin"), ("evil", "../key.bin")):
        document["buffers"] = [{"uri": uri, "byteLength": len(binary)}]
        (library / f"{name}.gltf").write_text(json.dumps(document))
    trimesh.creation.box().export(tmp_path / "private.stl")
    (library / "linked.stl").symlink_to(tmp_path / "private.stl")
    done = import_folder(library)
    assert done.imported == ["good"]
    told = dict(done.problems)
    assert "outside" in told["evil"] and "outside" in told["linked"]


def test_a_table_that_declares_too_much_is_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A billion equal values are a few kilobytes of Parquet."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    data = pa.table({"x": pa.array(np.zeros(10**6))})
    facts = {b"esg.table": b"scenes", b"esg.format": tables.FORMAT_VERSION.encode()}
    path = tmp_path / "scenes.parquet"
    pq.write_table(data.replace_schema_metadata(facts), path)
    assert path.stat().st_size < 10_000
    assert tables.table_of(path) == "scenes"
    monkeypatch.setattr(tables, "MOST_VALUES", 10**5)
    with pytest.raises(UserError, match="1000000 values, at most 100000"):
        tables.read_table(path)


def test_a_picture_of_a_capture_holds_what_it_says() -> None:
    """Neither more pixels than it has bytes, nor more bytes than pixels."""
    image = np.arange(12, dtype=np.uint16).reshape(3, 4)
    data = png16.encode(image)
    assert np.array_equal(png16.decode(data), image)
    for size in ((2**20, 2**20), (4, 2), (4, 4)):
        with pytest.raises(ValueError, match=r"not read|does not hold"):
            png16.decode(data[:16] + struct.pack(">II", *size) + data[24:])
