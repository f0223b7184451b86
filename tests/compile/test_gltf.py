"""Exported GLB files in Khronos' validator (`npm ci --prefix tests/compile/gltf`)."""

from __future__ import annotations

from dataclasses import replace
import json
from pathlib import Path
import shutil
import subprocess

import numpy as np
import pytest
import scenes
from test_emit import HOSTILE
from test_export import folder_of

from esg.compile.export import export
from esg.compile.glb import read_glb
from esg.engines.program import Program, SetVelocity
from esg.engines.scene import SimScene

GLTF = Path(__file__).parent / "gltf"
needs_validator = pytest.mark.skipif(
    not shutil.which("node") or not (GLTF / "node_modules" / "gltf-validator").is_dir(),
    reason="needs node and `npm ci --prefix tests/compile/gltf`",
)


def validated(*files: Path) -> list[dict]:
    """The validator's report of every file."""
    command = ["node", str(GLTF / "validate.mjs"), *map(str, files)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def textured(path: Path, seed: int = 0) -> None:
    """A ball with an image as its colour, as imported assets have."""
    from PIL import Image
    import trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    ball = trimesh.creation.icosphere(subdivisions=2, radius=0.11)
    pixels = np.random.default_rng(seed).integers(0, 255, (16, 16, 3), np.uint8)
    material = PBRMaterial(baseColorTexture=Image.fromarray(pixels), metallicFactor=0.0)
    uv = ball.vertices[:, :2] / 0.22 + 0.5
    ball.visual = TextureVisuals(uv=uv, material=material)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(trimesh.Scene(ball).export(file_type="glb"))


def textured_scene(root: Path, seed: int = 1) -> Path:
    """Three balls of two files, the second with a picture of its own unless `seed` is 0."""
    scene, program = scenes.marbles()
    textured(root / "meshes" / "ball.glb")
    textured(root / "meshes" / "other.glb", seed)
    bodies = tuple(
        replace(b, mesh=f"meshes/{'other' if b.name == 'ball_c' else 'ball'}.glb")
        if b.name.startswith("ball")
        else b
        for b in scene.bodies
    )
    return folder_of(root, replace(scene, bodies=bodies), program)


def test_textures_of_several_files_survive(tmp_path: Path) -> None:
    document, binary = read_glb(export(textured_scene(tmp_path), "glb")[0].read_bytes())
    images, used = document["images"], set()
    assert len(images) == 2 and len(document["textures"]) == 2
    for material in document["materials"]:
        pbr = material["pbrMetallicRoughness"]
        if "baseColorTexture" in pbr:
            used.add(document["textures"][pbr["baseColorTexture"]["index"]]["source"])
    assert used == {0, 1}
    for image in images:
        view = document["bufferViews"][image["bufferView"]]
        start = view.get("byteOffset", 0)
        assert binary[start : start + 8] == b"\x89PNG\r\n\x1a\n"


def test_a_picture_of_several_files_is_there_once(tmp_path: Path) -> None:
    folder = textured_scene(tmp_path, seed=0)
    data = export(folder, "glb")[0].read_bytes()
    document, _ = read_glb(data)
    assert len(document["images"]) == len(document["textures"]) == 1
    # The two files' materials are one, the capsule's and the wedge's another.
    assert len(document["materials"]) == 2
    balls = [m for m in document["meshes"] if m["primitives"][0]["attributes"].get("TEXCOORD_0")]
    assert len(balls) == 2 and data.count(b"\x89PNG") == 1


@needs_validator
def test_exports_are_valid_gltf(tmp_path: Path) -> None:
    names = tuple(
        scenes.ball(n, (0.5 * i, 0.0, 0.1), 0.1, 1.0, label=n) for i, n in enumerate(HOSTILE)
    )
    push = Program((SetVelocity(HOSTILE[0], 0.0, (0.0, 1.0, 0.0)),), 0.2)
    folders = [
        folder_of(tmp_path / "street", *scenes.street()),
        folder_of(tmp_path / "hostile", SimScene('h"*/\x01', names), push),
        folder_of(tmp_path / "still", SimScene("still", ()), Program((), 0.1)),
        textured_scene(tmp_path / "textured"),
    ]
    reports = validated(*(export(folder, "glb")[0] for folder in folders))
    assert [r["numErrors"] + r["numWarnings"] for r in reports] == [0, 0, 0, 0], reports
    assert [r["animationCount"] for r in reports] == [1, 1, 0, 1]
    assert reports[3]["hasTextures"]


@needs_validator
def test_the_validator_sees_faults(tmp_path: Path) -> None:
    [path] = export(folder_of(tmp_path, *scenes.marbles()), "glb")
    path.write_bytes(path.read_bytes().replace(b'"VEC4"', b'"VEC3"'))
    assert validated(path)[0]["numErrors"] > 0
