"""What breaks, in the emitted class and in the exports."""

from __future__ import annotations

from dataclasses import replace
import json
from pathlib import Path
import struct

from helpers import both
import numpy as np
import pytest
import scenes
from usd import usd_of

from esg.assets import resolve, write_meshes
from esg.assets.gltf.fragments import largest, tile_of
from esg.assets.gltf.parts import parts_of
from esg.compile import emit_class
from esg.compile.glb import mesh_of, scene_glb
from esg.compile.mjcf import scene_mjcf
from esg.compile.usd import write_usd
from esg.draft import draft
from esg.engines import get_engine
from esg.engines.breaking import hidden
from esg.engines.breaking.pieces import broken
from esg.engines.joints import joint_between
from esg.engines.manifest import manifest_from_json, manifest_to_json
from esg.engines.program import HoldVelocity, Primitive, Program, SetVelocity, batch_programs
from esg.engines.scene import SimScene

Case = tuple[SimScene, tuple[Primitive, ...]]


def dropped() -> Case:
    """A box that falls askew on the ground, without bouncing."""
    crate = scenes.box("crate", (0.0, 0.0, 0.8), (0.2, 0.15, 0.1), 3.0, yaw=0.4)
    whole, pieces = broken(replace(crate, break_impulse=6.0, restitution=0.0), 6)
    return SimScene("dropped", (whole, *pieces)), (SetVelocity("crate", 0.0, (0, 0, 0), (1, 2, 0)),)


def pane() -> Case:
    """A ball flies through a fixed pane; a command of the pane's own would come too late."""
    glass = scenes.box("pane", (0.0, 0.0, 0.5), (0.01, 0.5, 0.5), 10.0, static=True)
    whole, pieces = broken(replace(glass, break_impulse=2.0), 8)
    ball = scenes.ball("ball", (-1.0, 0.1, 0.6), 0.08, 1.0)
    throw = SetVelocity("ball", 0.0, (8.0, 0.0, 0.5))
    return SimScene("pane", (whole, *pieces, ball)), (throw,)


def driven() -> Case:
    """What is driven breaks, and is driven no more."""
    cart = scenes.box("cart", (0.0, 0.0, 0.1), (0.2, 0.15, 0.1), 3.0)
    whole, pieces = broken(replace(cart, break_impulse=4.0), 5)
    wall = scenes.box("wall", (1.5, 0.0, 0.5), (0.1, 1.0, 0.5), 1.0, static=True)
    drive = HoldVelocity("cart", 0.0, 2.0, 3.0, 0.0)
    return SimScene("driven", (whole, *pieces, wall)), (drive,)


def hung() -> Case:
    """A ball that swings on a rope breaks a fixed pane: joints and fragments in one class."""
    scene, _ = pane()
    ball = scenes.ball("bob", (-1.2, 0.1, 1.3), 0.08, 2.0)
    rope = joint_between("rope", "rope", ball, None, at=ball.position, parent_at=(0.0, 0.1, 1.8))
    bodies = (*scene.bodies[:-1], ball)
    return SimScene("hung", bodies, joints=(replace(rope, upper=1.3),)), ()


CASES = {"dropped": dropped, "pane": pane, "driven": driven, "hung": hung}


@pytest.mark.parametrize("engine", ["physx", "rapier"])
@pytest.mark.parametrize("name", CASES)
def test_class_and_program_break_alike(tmp_path: Path, name: str, engine: str) -> None:
    scene, commands = CASES[name]()
    replayed, rollout = both(tmp_path, scene, Program(commands, 0.8), engine=engine)
    played = replayed.rollout
    gone = [hidden(scene, r.position[0], r.quaternion[0]) for r in (played, rollout)]
    assert gone[0][-1, 0]
    assert not gone[0][-1, 1]
    first = [int(g[:, 0].argmax()) for g in gone]
    assert abs(first[0] - first[1]) <= 1
    # Up to the break and shortly after; then fragments jostle, and no rounding is small enough.
    until = min(first) + 4
    assert np.abs(played.position[0, :until] - rollout.position[0, :until]).max() < 2e-3
    assert any("BREAK body=" in line for line in replayed.log)
    assert np.isfinite(played.position).all()


def test_every_value_is_a_property_and_other_classes_say_nothing_of_it() -> None:
    scene, commands = dropped()
    made = emit_class(scene, Program(commands, 1.0))
    assert "CrateSettings.BreakImpulse = 600.0;" in made.source
    assert "AddBrittle(0, { 1, 2, 3, 4, 5, 6 });" in made.source
    assert "FEsgBody CrateSettings;" in made.header
    plain = SimScene("plain", (scenes.box("crate", (0, 0, 0.1), (0.1, 0.1, 0.1), 1.0),))
    other = emit_class(plain, Program((), 1.0))
    for word in ("Brittle", "BreakImpulse", "RememberSpeeds", "IsCollisionEnabled"):
        assert word not in other.source + other.header


def test_exports_show_fragments_from_the_break_on(tmp_path: Path) -> None:
    scene, commands = dropped()
    program = Program(commands, 0.8)
    rollout = get_engine("rapier").rollout(
        scene, batch_programs([program], scene.names), dt=1 / 240, record_every=4
    )
    data = scene_glb(scene, rollout, tmp_path)
    (length,) = struct.unpack_from("<I", data, 12)
    gltf = json.loads(data[20 : 20 + length])
    nodes = {n["name"]: n for n in gltf["nodes"] if "extras" in n}
    assert nodes["crate"]["scale"] == [1.0, 1.0, 1.0]
    assert nodes["crate_piece_1"]["scale"] == [0.0, 0.0, 0.0]
    (animation,) = gltf["animations"]
    sized = [c for c in animation["channels"] if c["target"]["path"] == "scale"]
    assert len(sized) == 1 + len(scene.bodies[0].fragments)
    assert {animation["samplers"][c["sampler"]]["interpolation"] for c in sized} == {"STEP"}
    manifest = manifest_from_json(manifest_to_json(scene, program, dt=1 / 240))
    mjcf = scene_mjcf(manifest)
    assert "What breaks stays whole" in mjcf
    assert "piece" not in mjcf.replace("pieces", "")
    text = usd_of(tmp_path, scene, program).read_text("utf-8")
    assert text.count('visibility = "invisible"') == len(scene.bodies[0].fragments)
    assert "double break_impulse = 6" in text
    paths = write_usd(manifest, rollout, tmp_path, tmp_path)
    baked = next(p for p in paths if "animation" in p.name).read_text("utf-8")
    assert baked.count("token visibility.timeSamples") == 1 + len(scene.bodies[0].fragments)


def test_fragments_show_the_surface_of_what_broke(tmp_path: Path) -> None:
    """Textured where it is, in the GLB and in USD; the plain colour only where it has no mesh."""
    scene, commands = dropped()
    doc = resolve(draft("A wooden crate falls."))
    write_meshes(doc, tmp_path)
    (crate,) = (c for c in doc.asset_configurations.values() if c.category == "crate")
    whole = replace(scene.bodies[0], mesh=crate.mesh_path)
    seen = parts_of(mesh_of(whole, tmp_path)[1] or b"")
    most = seen[largest(seen)].surface
    piece = scene.bodies[1]
    shown = parts_of(mesh_of(piece, tmp_path, whole)[1] or b"")
    assert {p.surface.name for p in shown} == {most.name}
    assert all(p.uvs is not None and p.normals is not None for p in shown)
    tiles = np.median([tile_of(p) for p in shown])
    assert tiles == pytest.approx(tile_of(seen[largest(seen)]), rel=0.3)
    assert {p.surface.name for p in parts_of(mesh_of(piece, tmp_path)[1] or b"")} == {"collision"}
    stage = usd_of(tmp_path, SimScene("s", (whole, *scene.bodies[1:])), Program(commands, 0.1))
    assert stage.exists()
