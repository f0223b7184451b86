"""What a page carries beside the motion: films, surfaces with pictures, places and ropes."""

from __future__ import annotations

import base64
from dataclasses import replace
import io
from pathlib import Path

import numpy as np
from PIL import Image
import pytest

from esg.assets.gltf.surfaces import Picture, Surface
from esg.dressing import dress
from esg.engines.joints import joint_between
from esg.outcomes import UserError
from esg.report.meshes import MeshLibrary, Piece, pieces_chunk
from esg.report.payload import around_of, film_of, ropes_of
from esg.report.replays import Replayed
from tests.report.test_payload import decode
from tests.view.plays import PLAYS, document_of, rollout_of, scene_of

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
FACES = np.array([[0, 1, 2], [0, 2, 3]])
PLAY = PLAYS[0]


def picture(color: tuple[int, int, int]) -> Picture:
    """A PNG of one colour."""
    out = io.BytesIO()
    Image.new("RGB", (8, 8), color).save(out, "PNG")
    return Picture(out.getvalue())


def test_surfaces_keep_roughness_metalness_and_their_picture() -> None:
    """Meshes of one surface become one; pictures travel once, as WebP."""
    steel = Surface("steel", roughness=0.3, metalness=1.0)
    wood = Surface("oak", roughness=0.7, base=picture((200, 120, 40)))
    pictures: dict[str, str] = {}
    pieces = [Piece("", SQUARE + k, FACES, SQUARE[:, :2] * 3, s) for k, s in
              enumerate((steel, wood, wood))]  # fmt: skip
    mesh = decode(pieces_chunk(pieces, pictures))
    assert mesh["counts"] == [6, 12]
    (key,) = pictures
    assert mesh["surfaces"] == [[0.3, 1.0, ""], [0.7, 0.0, key]]
    uvs = mesh["data"]["uvs"]
    assert np.allclose([uvs.min(), uvs.max()], [0, 3], atol=1e-3)
    with Image.open(io.BytesIO(base64.b64decode(pictures[key]))) as image:
        assert image.format == "WEBP"
        assert np.abs(np.subtract(image.convert("RGB").getpixel((9, 9)), (200, 120, 40))).max() < 9


@pytest.mark.parametrize("data", [b"", b"no picture at all", b"\x89PNG\r\n\x1a\nshort"])
def test_a_broken_picture_leaves_the_surface_plain(data: bytes) -> None:
    """What a stranger calls a picture is decoded with care."""
    pictures: dict[str, str] = {}
    piece = Piece("", SQUARE, FACES, SQUARE[:, :2], Surface("oak", base=Picture(data)))
    mesh = decode(pieces_chunk([piece], pictures))
    assert mesh["surfaces"][0][2] == "" and "uvs" not in mesh["data"]


def test_a_film_is_inside_the_page(tmp_path: Path) -> None:
    """As it is; what is none, or too large, is told."""
    film = tmp_path / "preview.mp4"
    film.write_bytes(b"\0\0\0\x20ftypisom" + bytes(range(200)))
    assert base64.b64decode(film_of(film)) == film.read_bytes()
    assert film_of(tmp_path / "none.mp4") == ""
    film.write_bytes(b"<html>")
    with pytest.raises(UserError, match="no film"):
        film_of(film)


def test_a_dressed_scene_brings_its_place() -> None:
    """Sky, ground and things, each thing apart so that the player can leave it out."""
    scene, rollout = scene_of(PLAY), rollout_of(PLAY)
    replay = Replayed(scene, rollout, "class")
    meshes = MeshLibrary()
    plain = document_of(PLAY)
    assert around_of(plain.model_dump(mode="json", by_alias=True), replay, meshes) is None
    dressed = dress(plain, scene, rollout, seed=0)
    assert dressed.dressing is not None
    around = around_of(dressed.model_dump(mode="json", by_alias=True), replay, meshes)
    assert around is not None and around["kind"] != "plain"
    mesh = decode(meshes.chunks[around["mesh"]])
    assert "plane" in mesh["holders"] and len(set(mesh["holders"])) > 1
    assert around_of({"dressing": {"place": 3}}, replay, meshes) is None


def test_ropes_say_what_they_hold() -> None:
    """A rope from the world to the ball, as long as it may be."""
    scene = scene_of(PLAY)
    ball = scene.body("ball")
    rope = joint_between("rope", "rope", ball, None, at=ball.position, parent_at=(0.0, 0.0, 2.0))
    (told,) = ropes_of(replace(scene, joints=(replace(rope, upper=2.0),)))
    assert (told["a"], told["b"]) == (-1, scene.index("ball"))
    assert told["length"] == pytest.approx(2.0, abs=0.1)
    assert ropes_of(scene) == []
