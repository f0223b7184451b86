"""What exports show: surfaces, ground, dressing, light, cameras and ropes, in GLB and USD."""

from __future__ import annotations

from dataclasses import replace
import importlib.util
import io
import json
import math
import os
from pathlib import Path
import subprocess
import sys
from typing import Any
import zipfile

import numpy as np
import pytest
import scenes
from test_export import accessor, folder_of, replayed
from test_gltf import needs_validator, textured_scene, validated
from test_joints import built

from esg.assets.gltf.document import Document
from esg.assets.gltf.parts import MeshPart, parts_of
from esg.assets.gltf.surfaces import Surface, picture, surface_of, tinted
from esg.assets.looks import Look
from esg.assets.textures import linear, srgb
from esg.compile.export import export
from esg.compile.plugin import write_plugin
from esg.compile.visuals.decals import drawn_lifts
from esg.compile.visuals.ropes import rope_mesh, ropes_of
from esg.compile.visuals.setting import (
    Setting,
    View,
    by_thing,
    facing,
    ground_mesh,
    in_cells,
    seen_at,
    spread,
)
from esg.engines.joints import joint_ends, joint_poses
from esg.engines.manifest import load_manifest
from esg.engines.scene import SimScene
from esg.strangers.gltf import read_glb
from esg.units import quat_multiply, quat_rotate
from esg.view.pieces import Part
from esg.view.surroundings import Sky

ARKIT = {"", "Scope", "Xform", "Camera", "Shader", "Material", "Mesh", "GeomSubset"}
"""Of the types of prims that ARKit takes, those that a scene may need."""
BRICK = Look("brick", (0.8, 0.4, 0.3), roughness=0.7, texture="brick", tile_m=2.0)
BRICK_NAME, STEEL_NAME = "brick_cc664c", "steel_99999e"
STEEL = Look("steel", (0.6, 0.6, 0.62), roughness=0.3, metalness=1.0)


def wall(name: str, look: Look) -> Part:
    """A square of two metres that faces +Y, texture coordinates in tiles of its look."""
    points = np.array([[1.0, 5, 0], [-1.0, 5, 0], [-1.0, 5, 2], [1.0, 5, 2]])
    normals = np.tile([0.0, 1.0, 0.0], (4, 1))
    uvs = points[:, [0, 2]] * (-1, 1) / look.tile_m
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    return Part(-1, points, faces, (0.5, 0.25, 0.125), None, look, normals, uvs, name)


def setting(*, moving: bool = False, covered: frozenset[str] = frozenset()) -> Setting:
    """A brick ground, two things and a camera that stands or goes along X."""
    turn = quat_multiply(
        (0.0, 0.0, math.sin(0.3), math.cos(0.3)), (math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))
    )
    time = np.array([0.0, 1.0]) if moving else np.zeros(1)
    at = np.array([[1.0, -6.0, 2.0], [3.0, -6.0, 2.0]])[: len(time)]
    view = View("Camera", time, at, np.tile(turn, (len(time), 1)), 0.6, 1.5, 0.1)
    parts = (wall("house/front", BRICK), wall("house/door", STEEL), wall("lamp/pole", STEEL))
    sky = Sky("clear", (0.6, 0.0, 0.8), (2.0, 1.5, 1.0), (0.25, 0.5, 0.5))
    return Setting(sky, BRICK, (1.0, 2.0), 60.0, covered, parts, (view,))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return folder_of(tmp_path_factory.mktemp("visuals"), *scenes.street())


def written(folder: Path, out: Path, to: str, **more: Any) -> list[Path]:
    return export(folder, to, out, rollout=replayed(folder), setting=setting(), **more)  # type: ignore[arg-type]


def test_a_surface_comes_back_from_a_file(tmp_path: Path) -> None:
    surface = surface_of(replace(BRICK, normal_strength=0.5), (0.5, 0.25, 0.125))
    assert surface.base is not None and surface.normal is not None
    assert surface.color == pytest.approx(tuple(linear(BRICK.color)))
    document = Document({"asset": {"version": "2.0"}, "scene": 0})
    part = wall("front", BRICK)
    turned = part.vertices[:, [0, 2, 1]] * (1, 1, -1)
    normals = np.tile([0.0, 0.0, -1.0], (4, 1))
    mesh = document.mesh(
        "front", [((turned, part.faces, normals, part.uvs), document.material(surface))]
    )
    document.append("nodes", {"name": "front", "mesh": mesh})
    document.data["scenes"] = [{"nodes": [0]}]
    [back] = parts_of(document.glb())
    assert isinstance(back, MeshPart) and back.name == "front"
    np.testing.assert_allclose(back.vertices, part.vertices, atol=1e-6)
    np.testing.assert_allclose(back.normals, part.normals, atol=1e-6)
    np.testing.assert_allclose(back.uvs, part.uvs, atol=1e-6)
    assert back.surface == replace(surface, color=tuple(round(c, 6) for c in surface.color))
    assert back.surface.normal_scale == 0.5 and back.surface.shown == (0.5, 0.25, 0.125)


@pytest.mark.parametrize("mirrored", [False, True])
def test_tangents_follow_the_texture(mirrored: bool) -> None:
    """Along +u in the surface; the side tells where +v is, which is up in a picture."""
    part = wall("front", BRICK)
    uvs = part.uvs * (-1, 1) if mirrored else part.uvs
    document = Document({"asset": {"version": "2.0"}, "scene": 0})
    corners = part.vertices, part.faces, part.normals, uvs
    mesh = document.mesh("front", [(corners, document.material(surface_of(BRICK)))])
    index = document.data["meshes"][mesh]["primitives"][0]["attributes"]["TANGENT"]
    tangents = accessor(document.data, bytes(document.binary), index)
    wanted = (1.0, 0.0, 0.0, -1.0) if mirrored else (-1.0, 0.0, 0.0, 1.0)
    np.testing.assert_allclose(tangents, np.tile(wanted, (4, 1)), atol=1e-6)
    up = np.cross(part.normals[0], tangents[0, :3]) * tangents[0, 3]
    np.testing.assert_allclose(up, (0.0, 0.0, 1.0), atol=1e-6)


def test_the_ground_lies_below_its_markings_and_has_tiles_of_its_size() -> None:
    flat = wall("ground/line", STEEL)
    low, high = (replace(flat, vertices=np.tile([0.0, 0.0, z], (4, 1))) for z in (0.001, 0.002))
    parts = spread([low, high, wall("house/front", BRICK)])
    assert [float(p.vertices[0, 2]) for p in parts] == pytest.approx([-0.002, 0.002, 0.0])
    assert set(by_thing(parts)) == {"markings", "house"}
    road = replace(flat, vertices=flat.vertices * (20.0, 1.0, 2.0))
    cells = in_cells(road)
    assert len(cells.faces) == 2 * 4 and len(cells.vertices) == 9
    a, b, c = (cells.vertices[cells.faces[:, k]] for k in range(3))
    facing_y = np.cross(b - a, c - a)[:, 1]
    assert (facing_y > 0.0).all() and 0.5 * facing_y.sum() == pytest.approx(40.0 * 4.0)
    np.testing.assert_allclose(cells.uvs[:, 0], -cells.vertices[:, 0] / 20.0 / STEEL.tile_m)
    cellar = replace(parts[2], vertices=parts[2].vertices - (0.0, 0.0, 9.0))
    vertices, faces, normals, uvs = ground_mesh(replace(setting(), parts=(*parts, cellar)))
    assert np.ptp(vertices[:, :2], axis=0) == pytest.approx((60.0, 60.0))
    np.testing.assert_allclose(vertices[:, :2].mean(axis=0), (1.0, 2.0), atol=1e-9)
    assert vertices[:, 2] == pytest.approx(-0.002 - 60.0 * 2e-5)
    np.testing.assert_allclose(uvs, vertices[:, :2] / 2.0)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    assert (np.cross(b - a, c - a)[:, 2] > 0.0).all() and (normals == (0, 0, 1)).all()
    area = 0.5 * np.cross(b - a, c - a)[:, 2].sum()
    assert area == pytest.approx(60.0 * 60.0)


def test_a_colour_goes_into_the_picture_of_readers_without_factors() -> None:
    from PIL import Image

    grey = np.full((16, 16, 3), 200, np.uint8)
    surface = Surface("s", (0.5, 0.25, 1.0), base=picture(grey))
    shown = tinted(surface)
    assert shown.color == (1.0, 1.0, 1.0) and shown.base is not None
    pixels = np.asarray(Image.open(io.BytesIO(shown.base.data)))[8, 8] / 255.0
    wanted = srgb(linear((200 / 255,) * 3) * np.array(surface.color))
    np.testing.assert_allclose(pixels, wanted, atol=0.02)
    assert tinted(replace(surface, color=(1.0, 1.0, 1.0))).base is surface.base


def test_glb_shows_the_setting(folder: Path, tmp_path: Path) -> None:
    document, _ = read_glb(written(folder, tmp_path, "glb")[0].read_bytes())
    nodes = {n["name"]: n for n in document["nodes"]}
    assert {"ground", "house", "lamp", "dressing", "sun", "Camera"} <= nodes.keys()
    # One mesh a thing, one primitive a surface; what two things are made of is there once.
    house, lamp = (document["meshes"][nodes[n]["mesh"]]["primitives"] for n in ("house", "lamp"))
    names = [m["name"] for m in document["materials"]]
    assert [names[p["material"]] for p in house] == [BRICK_NAME, STEEL_NAME]
    assert names.count(STEEL_NAME) == 1 and lamp[0]["material"] == house[1]["material"]
    # Ground and wall share three pictures.
    assert len(document["images"]) == 3
    [light] = document["extensions"]["KHR_lights_punctual"]["lights"]
    assert light["intensity"] == pytest.approx(2.0 * math.pi)
    assert light["color"] == pytest.approx([1.0, 0.75, 0.5])
    # It shines along its -Z, which leads from the sun (0.6, 0, 0.8) of ours.
    ahead = quat_rotate(nodes["sun"]["rotation"], (0.0, 0.0, -1.0))
    np.testing.assert_allclose(ahead, (-0.6, -0.8, 0.0), atol=1e-6)
    [camera] = document["cameras"]
    assert camera["perspective"] == {"yfov": 0.6, "aspectRatio": 1.5, "znear": 0.1}
    view = setting().views[0]
    ahead = quat_rotate(view.quaternion[0], (0.0, 0.0, -1.0))
    seen = quat_rotate(nodes["Camera"]["rotation"], (0.0, 0.0, -1.0))
    np.testing.assert_allclose(seen, (ahead[0], ahead[2], -ahead[1]), atol=1e-6)
    np.testing.assert_allclose(nodes["Camera"]["translation"], (1.0, 2.0, 6.0))


def test_a_camera_moves_as_its_view_does(folder: Path, tmp_path: Path) -> None:
    rollout = replayed(folder)
    files = export(folder, "glb", tmp_path, rollout=rollout, setting=setting(moving=True))
    document, binary = read_glb(files[0].read_bytes())
    node = next(i for i, n in enumerate(document["nodes"]) if n["name"] == "Camera")
    [animation] = document["animations"]
    [channel] = [c for c in animation["channels"] if c["target"]["node"] == node]
    values = accessor(document, binary, animation["samplers"][channel["sampler"]]["output"])
    np.testing.assert_allclose(values[:, 0], 1.0 + 2.0 * np.minimum(rollout.time, 1.0), atol=1e-5)
    at, turn = seen_at(setting(moving=True).views[0], np.array([0.5, 9.0]))
    np.testing.assert_allclose(at, [[2.0, -6.0, 2.0], [3.0, -6.0, 2.0]])
    np.testing.assert_allclose(np.linalg.norm(turn, axis=1), 1.0)


def test_a_body_in_whose_place_the_ground_is_seen_is_not_drawn(tmp_path: Path) -> None:
    scene, program = scenes.marbles()
    folder = folder_of(tmp_path, scene, program)
    hidden = setting(covered=frozenset({"pill_1"}))
    [path] = export(folder, "glb", tmp_path / "out", rollout=replayed(folder), setting=hidden)
    names = {n["name"] for n in read_glb(path.read_bytes())[0]["nodes"]}
    assert "wedge_1" in names and "pill_1" not in names


def test_what_lies_on_the_ground_is_drawn_the_smaller_the_higher() -> None:
    def flat(name: str, half: tuple[float, float, float]) -> Any:
        return replace(scenes.box(name, (0.0, 0.0, 0.0), half, 0.0, static=True), shapes=())

    bodies = (
        flat("line", (1, 0.1, 0.002)),
        flat("road", (9, 3, 0.005)),
        flat("field", (20, 20, 0.01)),
    )
    scene = SimScene("flat", (*bodies, scenes.ball("b", (0, 0, 1), 0.1, 1.0)))
    lifts = drawn_lifts(scene, {"field"})
    # Their tops stand 4 and 8 mm above the ground.
    assert lifts == pytest.approx({1: 0.004 - 0.01, 0: 0.008 - 0.004})


def test_a_junction_lies_over_the_roads_that_lead_to_it_and_under_their_markings() -> None:
    def flat(name: str, category: str, *half: float) -> Any:
        box = scenes.box(name, (0.0, 0.0, 0.0), (*half, 0.005), 0.0, static=True)
        return replace(box, shapes=(), category=category)

    bodies = (
        flat("junction", "crossroad", 40, 40),
        flat("zebra", "crosswalk", 2, 4),
        flat("road", "road", 40, 4),
    )
    scene = SimScene("flat", (*bodies, scenes.ball("b", (0, 0, 1), 0.1, 1.0)))
    lifts = drawn_lifts(scene)
    assert lifts[2] < lifts[0] < lifts[1]


def test_ropes_and_springs_end_where_their_joints_do(tmp_path: Path) -> None:
    scene, program = built("hung")
    folder = folder_of(tmp_path, scene, program)
    rollout = replayed(folder)
    ropes = ropes_of(scene, rollout.position[0], rollout.quaternion[0])
    joints = [j for j in scene.joints if j.flexible]
    assert [r.kind for r in ropes] == [j.kind for j in joints] == ["rope", "spring"]
    document, binary = read_glb(export(folder, "glb", rollout=rollout)[0].read_bytes())
    [animation] = document["animations"]
    for joint in joints:
        node = next(i for i, n in enumerate(document["nodes"]) if n["name"] == joint.name)
        state = {
            k: np.array(document["nodes"][node][k]) for k in ("translation", "rotation", "scale")
        }
        ends = joint_ends(
            joint, *joint_poses(scene, joint, rollout.position[0], rollout.quaternion[0])
        )
        for frame in (0, len(rollout.time) // 2, len(rollout.time) - 1):
            now = dict(state)
            for channel in animation["channels"]:
                if channel["target"]["node"] == node:
                    sampler = animation["samplers"][channel["sampler"]]
                    now[channel["target"]["path"]] = accessor(document, binary, sampler["output"])[
                        frame
                    ]
            # Its mesh goes from 0 to -1 along our Z, which is glTF's Y.
            tips = [quat_rotate(now["rotation"], now["scale"] * (0.0, y, 0.0)) for y in (0.0, -1.0)]
            for tip, end in zip(tips, ends, strict=True):
                x, y, z = tip + now["translation"]
                np.testing.assert_allclose((x, -z, y), end[frame], atol=1e-5)


def test_a_rope_that_broke_is_gone_for_good() -> None:
    scene, _ = built("hung")
    at = np.repeat(np.array([[b.position for b in scene.bodies]], float), 4, axis=0)
    turn = np.repeat(np.array([[b.quaternion for b in scene.bodies]], float), 4, axis=0)
    lamp = scene.index("lamp")
    at[1, lamp, 2] -= 0.5
    cord = next(r for r in ropes_of(scene, at, turn) if r.kind == "rope")
    assert cord.length[0] > 0.0 and not cord.length[1:].any()


@pytest.mark.parametrize("kind", ["rope", "spring"])
def test_the_mesh_of_a_rope_looks_outward(kind: str) -> None:
    vertices, faces, normals = rope_mesh(kind)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), normals[faces].mean(1)) > 0.0).all()
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0)


@pytest.mark.parametrize("toward", [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.6, 0.0, -0.8)])
def test_facing_turns_the_axis(toward: tuple[float, float, float]) -> None:
    np.testing.assert_allclose(quat_rotate(facing(toward), (0.0, 0.0, 1.0)), toward, atol=1e-12)


@pytest.mark.parametrize("form", ["usda", "usdc"])
def test_usd_shows_the_setting(folder: Path, tmp_path: Path, form: str) -> None:
    from pxr import Usd, UsdGeom, UsdLux, UsdPhysics, UsdShade

    files = written(folder, tmp_path, "usd", form=form)
    stage = Usd.Stage.Open(str(next(p for p in files if "animation" in p.name)))
    around = "/World/Surroundings"
    front = stage.GetPrimAtPath(f"{around}/house/{BRICK_NAME}")
    material, _ = UsdShade.MaterialBindingAPI(front).ComputeBoundMaterial()
    surface = material.ComputeSurfaceSource()[0]
    assert surface.GetIdAttr().Get() == "UsdPreviewSurface"
    for name in ("diffuseColor", "normal", "roughness"):
        source = surface.GetInput(name).GetConnectedSource()[0]
        file = UsdShade.Shader(source.GetPrim()).GetInput("file").Get()
        assert Path(file.resolvedPath).parent == tmp_path / "textures"
    coordinates = UsdGeom.PrimvarsAPI(front).GetPrimvar("st")
    np.testing.assert_allclose(coordinates.Get(), wall("", BRICK).uvs, atol=1e-6)
    assert coordinates.GetInterpolation() == UsdGeom.Tokens.vertex
    np.testing.assert_allclose(UsdGeom.Mesh(front).GetNormalsAttr().Get(), [(0, 1, 0)] * 4)
    sun = UsdLux.DistantLight(stage.GetPrimAtPath(f"{around}/Sun"))
    assert sun.GetIntensityAttr().Get() == pytest.approx(2.0 * math.pi / 4)
    toward = UsdGeom.Xformable(sun).GetLocalTransformation().TransformDir((0.0, 0.0, 1.0))
    np.testing.assert_allclose(toward, (0.6, 0.0, 0.8), atol=1e-6)
    sky = UsdLux.DomeLight(stage.GetPrimAtPath(f"{around}/Sky"))
    assert sky.GetIntensityAttr().Get() == 0.5
    camera = UsdGeom.Camera(stage.GetPrimAtPath("/World/Cameras/Camera"))
    lens = camera.GetCamera(0.0)
    assert math.radians(lens.GetFieldOfView(lens.FOVVertical)) == pytest.approx(0.6, abs=1e-4)
    np.testing.assert_allclose(lens.transform.ExtractTranslation(), (1.0, -6.0, 2.0))
    # What is seen has no physics, and the plane that has is not seen.
    shown = list(Usd.PrimRange(stage.GetPrimAtPath(around)))
    assert not any(p.HasAPI(UsdPhysics.CollisionAPI) for p in shown)
    plane = stage.GetPrimAtPath("/World/Ground")
    assert plane.HasAPI(UsdPhysics.CollisionAPI)
    assert UsdGeom.Imageable(plane).GetPurposeAttr().Get() == "guide"


def test_every_seen_mesh_of_usd_has_a_material_and_normals(folder: Path, tmp_path: Path) -> None:
    from pxr import Usd, UsdGeom, UsdShade

    files = written(folder, tmp_path, "usd")
    stage = Usd.Stage.Open(str(files[1]))
    meshes = [UsdGeom.Mesh(p) for p in stage.Traverse() if p.IsA(UsdGeom.Mesh)]
    meshes = [m for m in meshes if m.ComputePurpose() != "guide"]
    assert len(meshes) > 6
    for mesh in meshes:
        assert UsdShade.MaterialBindingAPI(mesh.GetPrim()).ComputeBoundMaterial()[0]
        per = {"vertex": len(mesh.GetPointsAttr().Get())}
        per["faceVarying"] = len(mesh.GetFaceVertexIndicesAttr().Get())
        assert len(mesh.GetNormalsAttr().Get()) == per[mesh.GetNormalsInterpolation()]


def test_physics_is_the_same_with_and_without_a_setting(folder: Path, tmp_path: Path) -> None:
    from pxr import Usd, UsdPhysics

    def physics(path: Path) -> dict[str, Any]:
        stage = Usd.Stage.Open(str(path))
        told = {}
        for prim in stage.Traverse():
            if prim.GetAppliedSchemas() or prim.IsA(UsdPhysics.Scene):
                told |= {
                    str(a.GetPath()): str(a.Get())
                    for a in prim.GetAttributes()
                    if a.GetName().startswith(("physics:", "physx", "xformOp", "esg:"))
                }
        return told

    plain = physics(export(folder, "usd", tmp_path / "a", rollout=replayed(folder))[0])
    placed = physics(written(folder, tmp_path / "b", "usd")[0])
    assert plain == {k: v for k, v in placed.items() if "/Surroundings/" not in k}


def test_ropes_of_usd_end_where_their_joints_do(tmp_path: Path) -> None:
    from pxr import Usd, UsdGeom

    scene, program = built("hung")
    folder = folder_of(tmp_path, scene, program)
    rollout = replayed(folder)
    stage = Usd.Stage.Open(str(export(folder, "usd", rollout=rollout)[1]))
    joint = next(j for j in scene.joints if j.kind == "rope")
    ends = joint_ends(joint, *joint_poses(scene, joint, rollout.position[0], rollout.quaternion[0]))
    prim = stage.GetPrimAtPath("/World/Ropes/Cord")
    assert prim.GetChild("Mesh").IsA(UsdGeom.Mesh)
    for frame in (0, len(rollout.time) // 2):
        matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(float(frame))
        for z, end in zip((0.0, -1.0), ends, strict=True):
            np.testing.assert_allclose(matrix.Transform((0.0, 0.0, z)), end[frame], atol=1e-5)


def test_a_package_is_for_phones(tmp_path: Path) -> None:
    """Y up, no types of prims that ARKit refuses, its pictures inside; and it moves."""
    from pxr import Usd, UsdGeom, UsdShade

    folder = textured_scene(tmp_path)
    rollout = replayed(folder)
    [path] = export(folder, "usd", tmp_path, rollout=rollout, setting=setting(), form="usdz")
    names = zipfile.ZipFile(path).namelist()
    assert names[0] == "scene.usdc"
    assert {Path(n).suffix for n in names[1:]} == {".jpg", ".png"} and len(names) == 6
    stage = Usd.Stage.Open(str(path))
    assert UsdGeom.GetStageUpAxis(stage) == "Y" and stage.GetDefaultPrim().GetName() == "World"
    prims = list(stage.TraverseAll())
    assert {p.GetTypeName() for p in prims} <= ARKIT
    assert not any("hysics" in s for p in prims for s in p.GetAppliedSchemas())
    textures = [UsdShade.Shader(p) for p in prims if p.IsA(UsdShade.Shader)]
    files = [t.GetInput("file").Get() for t in textures if t.GetInput("file")]
    assert files and all(f.resolvedPath.startswith(str(path)) for f in files)
    ball = load_manifest(folder / "manifest.json").scene.bodies[0]
    for frame in (0, len(rollout.time) - 1):
        matrix = UsdGeom.Xformable(
            stage.GetPrimAtPath("/World/BallA")
        ).ComputeLocalToWorldTransform(frame)
        x, y, z = matrix.Transform(tuple(-float(v) for v in ball.origin_offset))
        np.testing.assert_allclose((x, -z, y), rollout.position[0, frame, 0], atol=1e-5)


@pytest.mark.parametrize("form", ["usda", "usdc", "usdz"])
def test_usd_is_deterministic_and_valid_in_every_form(tmp_path: Path, form: str) -> None:
    from pxr import Usd, UsdValidation

    folder = textured_scene(tmp_path)
    one, two = (written(folder, tmp_path / n, "usd", form=form) for n in "12")
    assert [p.name for p in one] == [p.name for p in two]
    assert [p.read_bytes() for p in one] == [p.read_bytes() for p in two]
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    for path in one:
        if path.suffix.startswith(".usd"):
            stage = Usd.Stage.Open(str(path))
            assert [e.GetMessage() for e in context.Validate(stage)] == []


@needs_validator
def test_glb_in_its_setting_is_valid(tmp_path: Path) -> None:
    folders = [textured_scene(tmp_path / "a"), folder_of(tmp_path / "b", *built("hung"))]
    files = [written(f, f / "out", "glb")[0] for f in folders]
    for report in validated(*files):
        assert report["numErrors"] + report["numWarnings"] == 0, report["messages"]


def test_the_plugin_lists_materials_and_pictures(tmp_path: Path) -> None:
    files = write_plugin(textured_scene(tmp_path), tmp_path / "out")
    imports = json.loads(next(p for p in files if p.name == "imports.json").read_text())
    by_source = {a["source"]: a.get("materials") for a in imports["assets"]}
    [ball] = by_source["meshes/ball.glb"]
    assert set(ball) == {"name", "base_color", "roughness", "metallic", "textures"}
    assert ball["metallic"] == 0.0 and set(ball["textures"]) == {"base_color"}


NVIDIA = importlib.util.find_spec("omni") and importlib.util.find_spec("omni.asset_validator")
EXPECTED = ("MassChecker", "UsdAsciiPerformanceChecker", "IndexedPrimvarChecker")
"""What NVIDIA's validator says of our layers and we mean: static bodies tell their centre of mass,
text holds the samples of an animation, texture coordinates are not indexed."""


def complaints(path: Path, python: str = sys.executable) -> list[str]:
    """What NVIDIA's validator says of a file."""
    script = (
        "import sys, omni.asset_validator as v\n"
        "for i in v.ValidationEngine().validate(sys.argv[1]).issues():\n"
        "    print('ISSUE', i.rule.__name__ if i.rule else '', i.message, i.at)\n"
    )
    done = subprocess.run(
        [python, "-c", script, str(path)], capture_output=True, text=True, check=True
    )
    return [line for line in done.stdout.splitlines() if line.startswith("ISSUE")]


@pytest.mark.skipif(not NVIDIA, reason="needs omniverse-asset-validator (Python below 3.13)")
def test_nvidias_validator_has_no_complaint(folder: Path, tmp_path: Path) -> None:
    layers = written(folder, tmp_path, "usd")
    [package] = written(folder, tmp_path, "usd", form="usdz")
    told = [line for path in (*layers[:3], package) for line in complaints(path)]
    assert [line for line in told if not any(e in line for e in EXPECTED)] == []


@pytest.mark.slow
@pytest.mark.skipif(
    not os.environ.get("ESG_USDCHECK_PYTHON"),
    reason="no usdchecker: ESG_USDCHECK_PYTHON names an interpreter with usd-core 26.3",
)
def test_usdchecker_passes_layers_and_its_arkit_profile_the_package(tmp_path: Path) -> None:
    folder = textured_scene(tmp_path)
    files = [*written(folder, tmp_path, "usd"), *written(folder, tmp_path, "usd", form="usdz")]
    script = (
        "import sys\nfrom pxr import UsdUtils\n"
        "for path in sys.argv[1:]:\n"
        "    checker = UsdUtils.ComplianceChecker(arkit=path.endswith('z'))\n"
        "    checker.CheckCompliance(path)\n"
        "    for told in (checker.GetErrors(), checker.GetFailedChecks(), checker.GetWarnings()):\n"
        "        for line in told:\n            print(path, line)\n"
    )
    python = os.environ["ESG_USDCHECK_PYTHON"]
    paths = [str(p) for p in files if p.suffix.startswith(".usd")]
    done = subprocess.run(
        [python, "-c", script, *paths], capture_output=True, text=True, check=True
    )
    assert done.stdout == ""
