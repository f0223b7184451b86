"""Wheels in what is written: nodes, prims and components that turn, and no other physics."""

from __future__ import annotations

from dataclasses import replace
import json
from pathlib import Path
import re

import numpy as np
import pytest
import scenes
from test_export import accessor, folder_of, replayed

from esg.compile import replay_class
from esg.compile.export import export
from esg.compile.glb import part_of, read_glb
from esg.engines.manifest import load_manifest, manifest_from_json, manifest_to_json
from esg.engines.scene import Rollout, SimScene, Wheel
from esg.engines.wheels import wheel_angles
from esg.outcomes import UserError

WHEELS = tuple(
    Wheel(f"wheel_{row}_{side}", (x, y, -0.42), 0.33)
    for row, x in (("front", 1.4), ("rear", -1.4))
    for side, y in (("left", 0.77), ("right", -0.77))
)


def car_mesh() -> bytes:
    """A box, and four wheels in nodes of their own, as the library writes them."""
    import trimesh

    scene = trimesh.Scene()
    body = trimesh.creation.box((4.5, 1.2, 1.8))
    body.apply_translation((0.0, 0.75, 0.0))
    scene.add_geometry(body, node_name="part_000", geom_name="part_000")
    for k, wheel in enumerate(WHEELS, 1):
        x, y, z = wheel.axle
        place = trimesh.transformations.translation_matrix((x, z + 0.75, -y))
        scene.graph.update(frame_to=wheel.name, matrix=place)
        tyre = trimesh.creation.cylinder(wheel.radius, 0.2)
        name = f"part_{k:03d}"
        scene.add_geometry(tyre, node_name=name, geom_name=name, parent_node_name=wheel.name)
    data = scene.export(file_type="glb")
    assert isinstance(data, bytes)
    return data


def street(wheels: tuple[Wheel, ...] = WHEELS) -> SimScene:
    scene, _ = scenes.street()
    bodies = (replace(scene.bodies[0], wheels=wheels, mesh="meshes/car.glb"), *scene.bodies[1:])
    return replace(scene, bodies=bodies)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("wheels")
    (root / "meshes").mkdir()
    (root / "meshes" / "car.glb").write_bytes(car_mesh())
    return folder_of(root, street(), scenes.street()[1])


def angles_of(rollout: Rollout) -> np.ndarray:
    scene = street()
    at, turn = rollout.position[0, :, 0], rollout.quaternion[0, :, 0]
    return wheel_angles(scene.bodies[0], rollout.time, at, turn, scene.gravity)


def test_glb_turns_the_nodes_of_the_wheels(folder: Path, tmp_path: Path) -> None:
    document, binary = read_glb(export(folder, "glb", tmp_path)[0].read_bytes())
    nodes = document["nodes"]
    wanted = angles_of(replayed(folder))
    assert wanted[-1].min() > 10.0
    [animation] = document["animations"]
    seen = {}
    for channel in animation["channels"]:
        name = nodes[channel["target"]["node"]]["name"]
        if not name.startswith("wheel"):
            continue
        assert channel["target"]["path"] == "rotation"
        sampler = animation["samplers"][channel["sampler"]]
        q = accessor(document, binary, sampler["output"])
        # About -Z of glTF, which is the body's Y.
        seen[name] = 2 * np.unwrap(np.arctan2(-q[:, 2], q[:, 3]))
        assert np.abs(q[:, :2]).max() == 0.0
    assert set(seen) == {w.name for w in WHEELS}
    for k, wheel in enumerate(WHEELS):
        assert seen[wheel.name] == pytest.approx(wanted[:, k], abs=1e-3)
        node = next(n for n in nodes if n.get("name") == wheel.name)
        assert "matrix" not in node
        x, y, z = wheel.axle
        assert node["translation"] == pytest.approx([x, z + 0.75, -y])


def test_usd_turns_the_prims_of_the_wheels(folder: Path, tmp_path: Path) -> None:
    from pxr import Usd, UsdGeom

    paths = export(folder, "usd", tmp_path)
    stage = Usd.Stage.Open(str(next(p for p in paths if p.name == "scene_animation.usda")))
    wanted = np.degrees(angles_of(replayed(folder)))
    for k, ident in enumerate(
        ("WheelFrontLeft", "WheelFrontRight", "WheelRearLeft", "WheelRearRight")
    ):
        prim = stage.GetPrimAtPath(f"/World/Car1/Visual/{ident}")
        assert [str(v) for v in prim.GetAttribute("xformOpOrder").Get()] == [
            "xformOp:translate",
            "xformOp:rotateY",
        ]
        turned = prim.GetAttribute("xformOp:rotateY")
        got = [turned.Get(float(f)) for f in (0, len(wanted) // 2, len(wanted) - 1)]
        assert got == pytest.approx(wanted[[0, len(wanted) // 2, -1], k])
        (part,) = prim.GetChildren()
        points = np.array(UsdGeom.Mesh(part).GetPointsAttr().Get())
        assert np.hypot(points[:, 0], points[:, 2]).max() == pytest.approx(0.33, rel=1e-3)


def test_the_class_turns_its_wheels_as_the_recording_tells(folder: Path) -> None:
    replay = replay_class(folder)
    said = dict(
        re.findall(
            r"WHEEL_TURNED wheel=(\w+) degrees=([-\d.]+)", "\n".join(replay.rollout.extra["log"])
        )  # type: ignore[arg-type]
    )
    wanted = np.degrees(angles_of(replay.rollout))[-2]
    assert len(said) == len(WHEELS)
    for ident, angle in zip(
        ("FrontLeft", "FrontRight", "RearLeft", "RearRight"), wanted, strict=True
    ):
        assert float(said[f"Car1Wheel{ident}"]) == pytest.approx(angle, rel=2e-3)


def test_wheels_change_no_physics(folder: Path, tmp_path: Path) -> None:
    plain = folder_of(tmp_path, street(()), scenes.street()[1])
    source = next((plain / "unreal").glob("*.cpp")).read_text("utf-8")
    assert "Wheel.Rate" not in source and "TurnWheels" not in source
    one, two = replay_class(folder).rollout, replay_class(plain).rollout
    assert np.array_equal(one.position, two.position)
    assert np.array_equal(one.quaternion, two.quaternion)


def test_the_plugin_has_a_file_for_every_mesh(folder: Path, tmp_path: Path) -> None:
    """Unreal imports a file as one mesh: the wheels must not stand in the body's, too."""
    import trimesh

    paths = export(folder, "unreal", tmp_path)
    [imports] = [p for p in paths if p.name == "imports.json"]
    assets = json.loads(imports.read_text("utf-8"))["assets"]
    files = {
        a["path"].rpartition(".")[2]: imports.parent / a["source"] for a in assets if a["source"]
    }
    assert set(files) == {
        "SM_Car", "SM_Car_WheelFrontLeft", "SM_Car_WheelFrontRight", "SM_Car_WheelRearLeft",
        "SM_Car_WheelRearRight",
    }  # fmt: skip
    assert not any("node" in a or "without_nodes" in a for a in assets)
    body = trimesh.load(files["SM_Car"], force="scene")
    assert len(body.geometry) == 1
    assert body.extents == pytest.approx((4.5, 1.2, 1.8))
    wheel = trimesh.load(files["SM_Car_WheelRearLeft"], force="scene")
    assert wheel.bounds.mean(axis=0) == pytest.approx([0.0, 0.0, 0.0], abs=1e-6)
    assert wheel.extents.max() == pytest.approx(0.66, rel=1e-3)


def test_part_of_takes_a_file_apart() -> None:
    whole = car_mesh()
    rest = read_glb(part_of(whole, without=[w.name for w in WHEELS]))[0]
    one = read_glb(part_of(whole, holders=["wheel_rear_left"]))[0]
    assert len(rest["meshes"]) == len(one["meshes"]) == 1


def test_manifest_carries_wheels_only_where_there_are_some(folder: Path) -> None:
    data = json.loads((folder / "manifest.json").read_text("utf-8"))
    assert [("wheels" in b) for b in data["bodies"]] == [True, False, False, False, False]
    assert "wheels" in data["conventions"]
    assert load_manifest(folder / "manifest.json").scene.bodies[0].wheels == WHEELS
    plain = manifest_to_json(street(()), scenes.street()[1], dt=1 / 240)
    assert "wheels" not in json.dumps(plain)


def test_two_wheels_of_one_name_are_refused(folder: Path) -> None:
    data = json.loads((folder / "manifest.json").read_text("utf-8"))
    data["bodies"][0]["wheels"][1]["name"] = "wheel_front_left"
    with pytest.raises(UserError, match="/bodies/0/wheels/1/name"):
        manifest_from_json(data)


def test_a_wheel_goes_round_as_often_as_its_way_says(folder: Path) -> None:
    """Distance over the circumference, for a car that drives a nearly straight way."""
    rollout = replayed(folder)
    way = np.linalg.norm(np.diff(rollout.position[0, :, 0], axis=0), axis=1).sum()
    assert angles_of(rollout)[-1].mean() == pytest.approx(way / 0.33, rel=0.02)
