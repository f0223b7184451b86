"""The mesh pack: small, complete, and the same files as a scene folder's."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
import trimesh

from esg.assets import resolve, write_meshes
from esg.dataset.meshes import BUFFERS, pack_meshes, unpack_meshes
from esg.draft import draft
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

TEXTS = (
    "A red car drives at 10 m/s and hits a wooden crate.",
    "A blue car drives into a bench.",
)


@pytest.fixture(scope="module")
def docs() -> list[EsgDocument]:
    return [resolve(draft(text)) for text in TEXTS]


def files(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*.glb")}


def test_an_unpacked_mesh_is_the_scene_folders_file(docs, tmp_path):
    for number, doc in enumerate(docs):
        rows, buffers = pack_meshes(doc, tmp_path / "set")
        assert all(b.is_file() and b.is_relative_to(tmp_path / "set" / BUFFERS) for b in buffers)
        write_meshes(doc, tmp_path / f"own-{number}")
        unpack_meshes(tmp_path / "set", rows, tmp_path / f"packed-{number}")
        own = files(tmp_path / f"own-{number}")
        assert own == files(tmp_path / f"packed-{number}")
        assert {r["mesh"]: r["bytes"] for r in rows} == {n: len(b) for n, b in own.items()}


def test_scenes_share_what_their_meshes_have_in_common(docs, tmp_path):
    """Two cars of other colours are one buffer."""
    used = [
        {r["buffer"] for r in pack_meshes(doc, tmp_path)[0] if r["asset"] == "car"} for doc in docs
    ]
    assert len(used[0]) == len(used[0] | used[1]) == 1
    packed = sum(p.stat().st_size for p in tmp_path.rglob("*.bin"))
    whole = sum(r["bytes"] for doc in docs for r in pack_meshes(doc, tmp_path)[0])
    assert packed < 0.7 * whole


def test_a_row_is_gltf_that_other_readers_open(docs, tmp_path):
    rows, _ = pack_meshes(docs[0], tmp_path)
    row = next(r for r in rows if r["asset"] == "car")
    resolver = trimesh.resolvers.FilePathResolver(str(tmp_path / "meshes"))
    scene = trimesh.load(io.BytesIO(row["gltf"].encode()), file_type="gltf", resolver=resolver)
    assert 3.5 < max(scene.extents) < 5.5


def test_a_missing_buffer_is_told_and_no_path_leaves_the_folder(docs, tmp_path):
    rows, buffers = pack_meshes(docs[0], tmp_path)
    row = {**rows[0], "scene_id": "S1"}
    buffers[0].unlink()
    with pytest.raises(UserError, match="S1 needs it"):
        unpack_meshes(tmp_path, [row], tmp_path / "out")
    with pytest.raises(UserError, match="leaves the scene folder"):
        unpack_meshes(tmp_path, [{**row, "buffer": None, "mesh": "../x.glb"}], tmp_path / "out")
