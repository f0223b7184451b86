"""Robot descriptions as assets with joints: what is taken over, what is refused, how it moves."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
import trimesh

from esg.assets import build_mesh, resolve, search
from esg.assets.commands import import_assets
from esg.assets.imports.models.importer import import_model
from esg.draft import draft
from esg.dynamics import build_scene
from esg.engines import get_engine
from esg.engines.program import Program, batch_programs
from esg.engines.scene import Rollout, SimScene
from esg.graph import verify
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.outcomes import UserError
from tests.disks import small_files

CABINET = """<?xml version="1.0"?>
<robot name="quorl cabinet">
  <link name="body">
    <inertial><origin xyz="0 0 0.5"/><mass value="30"/>
      <inertia ixx="3" iyy="3" izz="2" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><origin xyz="-0.2 0 0.5"/><geometry><box size="0.02 0.6 1"/></geometry>
      <material name="oak"><color rgba="0.6 0.4 0.2 1"/></material></visual>
    <visual><origin xyz="0 0 0.01"/><geometry><box size="0.4 0.6 0.02"/></geometry></visual>
    <collision><origin xyz="-0.2 0 0.5"/><geometry><box size="0.02 0.6 1"/></geometry></collision>
    <collision><origin xyz="0 0 0.01"/><geometry><box size="0.4 0.6 0.02"/></geometry></collision>
  </link>
  <link name="handle">
    <inertial><mass value="0.5"/>
      <inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><cylinder radius="0.01" length="0.1"/></geometry></collision>
  </link>
  <link name="door">
    <inertial><origin xyz="0 0 0.2"/><mass value="4"/>
      <inertia ixx="0.1" iyy="0.06" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><origin xyz="0 0 0.2"/><geometry><mesh filename="package://quorl/meshes/leaf.stl"
      scale="0.001 0.001 0.001"/></geometry></visual>
    <collision><origin xyz="0 0 0.2"/><geometry><box size="0.02 0.56 0.4"/></geometry></collision>
  </link>
  <link name="drawer">
    <inertial><mass value="3"/>
      <inertia ixx="0.1" iyy="0.06" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><geometry><box size="0.3 0.5 0.2"/></geometry></collision>
  </link>
  <joint name="grip" type="fixed"><parent link="door"/><child link="handle"/>
    <origin xyz="0.03 0 0.35"/></joint>
  <joint name="hinge" type="revolute"><parent link="body"/><child link="door"/>
    <origin xyz="0.22 0 0.05" rpy="0 0.1 0"/><axis xyz="0 1 0"/>
    <limit lower="-0.1" upper="1.4" effort="5" velocity="3"/>
    <dynamics damping="0.3" friction="0.05"/></joint>
  <joint name="runner" type="prismatic"><parent link="body"/><child link="drawer"/>
    <origin xyz="0.02 0 0.8"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="0.25" effort="5" velocity="3"/>
    <dynamics damping="8" friction="4"/></joint>
</robot>
"""
PENDULUM = """<mujoco model="snark wobbler">
  <compiler angle="degree"/>
  <asset><material name="red" rgba="0.8 0.1 0.1 1"/></asset>
  <worldbody>
    <light pos="0 0 3"/>
    <geom type="plane" size="5 5 0.1"/>
    <geom name="foot" type="box" size="0.2 0.5 0.02" pos="0 0 0.02" density="7800"/>
    <geom name="post" type="box" size="0.02 0.02 0.6" pos="0 -0.4 0.6" density="7800"/>
    <body name="arm" pos="0 0 1.1" euler="0 40 0">
      <joint name="pivot" type="hinge" axis="0 1 0" range="-130 50" damping="0.001"/>
      <geom type="capsule" fromto="0 0 0 0 0 -0.7" size="0.01" mass="0.1"/>
      <geom type="sphere" pos="0 0 -0.7" size="0.08" mass="2" material="red"/>
      <body pos="0 0 -0.78">
        <joint type="ball" range="0 60" damping="0.01"/>
        <geom type="ellipsoid" size="0.04 0.04 0.05" pos="0 0 -0.06" mass="0.2"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


@pytest.fixture(autouse=True)
def library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ESG_ASSET_LIBRARY", str(tmp_path / "library"))
    return tmp_path / "library"


@pytest.fixture
def cabinet(tmp_path: Path) -> Path:
    (tmp_path / "models" / "meshes").mkdir(parents=True)
    leaf = trimesh.creation.box(extents=(20, 560, 400))
    leaf.export(tmp_path / "models" / "meshes" / "leaf.stl")
    path = tmp_path / "models" / "cabinet.urdf"
    path.write_text(CABINET)
    return path


@pytest.fixture
def pendulum(tmp_path: Path) -> Path:
    path = tmp_path / "pendulum.xml"
    path.write_text(PENDULUM)
    return path


def resolved(prompt: str) -> EsgDocument:
    doc = resolve(draft(prompt, seed=0), seed=0)
    assert [v.code for v in verify(doc) if v.severity == "error"] == []
    return doc


def test_a_prompt_that_names_a_model_draws_its_parts(cabinet: Path) -> None:
    assert import_model(cabinet).imported == ["quorl_cabinet"]
    assert import_model(cabinet).unchanged == ["quorl_cabinet"]
    doc = resolved("A ball rolls past a quorl cabinet.")
    graph, assets = doc.spatial_relation_graph, doc.asset_configurations
    hinge, runner = sorted(graph.joints or (), key=lambda j: j.kind)
    assert (hinge.kind, runner.kind) == ("hinge", "slider")
    assert hinge.parent == runner.parent and graph.nodes[hinge.parent or ""].mentioned
    assert [hinge.lower, hinge.upper] == pytest.approx([-math.degrees(0.1), math.degrees(1.4)])
    assert [runner.lower, runner.upper] == pytest.approx([0, 25])
    assert (hinge.damping, hinge.friction) == (0.3, 0.05)
    body, door = (assets[graph.nodes[n].asset_id] for n in (hinge.parent or "", hinge.child))
    assert (body.mass_kg, door.mass_kg) == (30, 4.5)  # the handle is fixed to the door
    assert body.dimensions_cm == pytest.approx((41, 60, 100))
    assert body.inertia_kg_cm2[:3] == pytest.approx((3e4, 3e4, 2e4))
    # Its axis is where the description has it: 22 cm before the middle, 5 cm above the ground;
    # the back stands 1 cm behind the bottom, which shifts the middle of the box.
    mount = next(m for m in body.mounts or () if m.name == hinge.parent_mount)
    assert mount.position_cm == pytest.approx((22.5, 0, 5))
    assert mount.axis == pytest.approx((0, 1, 0))
    assert len(build_mesh(door).geometry) == 2  # a link without visuals shows what touches
    points = build_mesh(door).bounds
    assert np.ptp(points, axis=0)[1] == pytest.approx(56, abs=0.1)  # its mesh is in millimetres


def test_every_one_of_several_has_its_parts_and_a_prescribed_mass_is_the_roots(
    cabinet: Path,
) -> None:
    import_model(cabinet)
    joints = resolved("Two quorl cabinets stand side by side.").spatial_relation_graph.joints or ()
    assert len(joints) == 4 and len({j.parent for j in joints}) == 2
    doc = resolved("A ball rolls past a 60 kg quorl cabinet.")
    hinge = next(j for j in doc.spatial_relation_graph.joints or () if j.kind == "hinge")
    nodes, assets = doc.spatial_relation_graph.nodes, doc.asset_configurations
    body, door = (assets[nodes[n].asset_id] for n in (hinge.parent or "", hinge.child))
    assert (body.mass_kg, door.mass_kg) == (60, 4.5)
    assert body.inertia_kg_cm2[0] == pytest.approx(6e4)


def test_an_obj_is_read_alone_and_colours_are_kept(cabinet: Path) -> None:
    """What an .obj names (here a file outside) is not read."""
    leaf = trimesh.creation.box(extents=(20, 560, 400)).export(file_type="obj")
    (cabinet.parent / "meshes" / "leaf.obj").write_text(f"mtllib ../../secret.mtl\n{leaf}")
    cabinet.write_text(CABINET.replace("leaf.stl", "leaf.obj"))
    import_model(cabinet)
    doc = resolved("A ball rolls past a quorl cabinet.")
    hinge = next(j for j in doc.spatial_relation_graph.joints or () if j.kind == "hinge")
    nodes, assets = doc.spatial_relation_graph.nodes, doc.asset_configurations
    body, door = (assets[nodes[n].asset_id] for n in (hinge.parent or "", hinge.child))
    assert np.ptp(build_mesh(door).bounds, axis=0)[1] == pytest.approx(56, abs=0.1)
    assert body.color_rgb == pytest.approx((0.6, 0.4, 0.2))


def test_parts_are_not_found_by_their_names(cabinet: Path) -> None:
    import_model(cabinet)
    assert "cabinet/quorl_cabinet" in [c.asset_name for c in search("quorl cabinet", 5)]
    assert not [c for c in search("quorl cabinet drawer", 50) if "cabinet." in c.asset_name]


def test_a_document_that_is_resolved_again_stays_the_same(cabinet: Path) -> None:
    import_model(cabinet)
    doc = resolved("A ball rolls past a quorl cabinet.")
    again = resolve(doc, seed=0)
    assert again.spatial_relation_graph == doc.spatial_relation_graph
    assert again.asset_configurations == doc.asset_configurations


def test_a_pendulum_of_mjcf(pendulum: Path) -> None:
    import_model(pendulum)
    doc = resolved("A ball rolls past a snark wobbler.")
    graph, assets = doc.spatial_relation_graph, doc.asset_configurations
    pivot, ball = graph.joints or ()
    assert (pivot.kind, ball.kind) == ("hinge", "ball")
    assert (ball.parent, ball.lower, ball.upper) == (pivot.child, None, pytest.approx(60))
    assert [pivot.lower, pivot.upper] == pytest.approx([-130, 50])
    stand = assets[graph.nodes[pivot.parent or ""].asset_id]
    assert not stand.is_movable
    assert stand.mass_kg == pytest.approx(7800 * (0.4 * 1 * 0.04 + 0.04 * 0.04 * 1.2))
    arm = assets[graph.nodes[pivot.child].asset_id]
    assert arm.mass_kg == pytest.approx(2.1)
    assert {p.kind.value for p in arm.proxies} == {"sphere", "capsule"}


CART = """<mujoco model="snark cart">
  <default><default class="wheel">
    <geom type="cylinder" size="0.1 0.02" euler="90 0 0" mass="0.5"/>
    <joint axis="0 1 0" damping="0.01"/></default></default>
  <worldbody><body name="cart" pos="0 0 0.1"><freejoint/>
    <geom type="box" size="0.3 0.2 0.05" mass="4"/>
    <body name="left" pos="0.2 0.25 0"><joint class="wheel"/><geom class="wheel"/></body>
    <body name="right" pos="0.2 -0.25 0"><joint class="wheel"/><geom class="wheel"/></body>
  </body></worldbody></mujoco>
"""


def test_what_moves_freely_is_a_root_that_moves(tmp_path: Path) -> None:
    path = tmp_path / "cart.xml"
    path.write_text(CART)
    import_model(path)
    doc = resolved("A ball rolls past a snark cart.")
    joints = doc.spatial_relation_graph.joints or ()
    assert [(j.kind, j.lower, j.upper, j.damping) for j in joints] == [
        ("hinge", None, None, 0.01)
    ] * 2
    root = doc.asset_configurations[
        doc.spatial_relation_graph.nodes[joints[0].parent or ""].asset_id
    ]
    assert root.is_movable and root.mass_kg == 4


def test_a_link_called_world_fixes_the_root(cabinet: Path) -> None:
    fixed = '<link name="world"/><joint name="w" type="fixed"><parent link="world"/><child link="body"/></joint>'
    for text, movable in (
        (CABINET, True),
        (CABINET.replace("</robot>", fixed + "</robot>"), False),
    ):
        cabinet.write_text(text)
        import_model(cabinet)
        doc = resolved("A ball rolls past a quorl cabinet.")
        parent = (doc.spatial_relation_graph.joints or ())[0].parent or ""
        asset = doc.asset_configurations[doc.spatial_relation_graph.nodes[parent].asset_id]
        assert (asset.is_movable, asset.mass_kg) == (movable, 30)


REFUSED = {
    "floating": ('type="prismatic"', 'type="floating"', "'floating', which is not imported"),
    "mimic": ('<limit lower="0"', '<mimic joint="hinge"/><limit lower="0"', "delete <mimic>"),
    "loop": (
        "</robot>",
        '<joint name="again" type="fixed"><parent link="drawer"/><child link="door"/></joint></robot>',
        "a closed loop",
    ),
    "missing mesh": ("meshes/leaf.stl", "meshes/gone.stl", "it is no file in"),
    "path out": ("package://quorl/meshes/leaf.stl", "../../etc/leaf.stl", "it is no file in"),
    "absolute path": ("package://quorl/meshes/leaf.stl", "/etc/leaf.stl", "it is no file in"),
    "form": ("leaf.stl", "leaf.dae", ".dae is not read"),
    "not a number": ('mass value="4"', 'mass value="nan"', "give finite numbers"),
    "limits": ('lower="0" upper="0.25"', 'lower="1" upper="0.25"', "limits are 1 and 0.25"),
    "axis": ('axis xyz="1 0 0"', 'axis xyz="0 0 0"', "give a direction"),
    "link": ('child link="drawer"', 'child link="shelf"', "its child is 'shelf'"),
    "entities": (
        '<robot name="quorl cabinet">',
        '<!DOCTYPE r [<!ENTITY a "aaaa">]><robot name="quorl cabinet">',
        "delete the declaration",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_held_is_refused(case: str, cabinet: Path, library: Path) -> None:
    old, new, told = REFUSED[case]
    assert old in CABINET
    cabinet.write_text(CABINET.replace(old, new, 1))
    with pytest.raises(UserError) as caught:
        import_model(cabinet)
    assert told in str(caught.value) and caught.value.exit_code == 2
    assert not library.exists()


def test_all_faults_are_told_at_once(cabinet: Path) -> None:
    text = CABINET
    for case in ("floating", "missing mesh", "not a number"):
        text = text.replace(*REFUSED[case][:2], 1)
    cabinet.write_text(text)
    with pytest.raises(UserError) as caught:
        import_model(cabinet)
    assert len(str(caught.value).splitlines()) == 4


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("</worldbody>", '</worldbody><equality><weld body1="arm"/></equality>', "<equality>"),
        ("<worldbody>", '<include file="/etc/passwd"/><worldbody>', "put its contents"),
        ('<joint name="pivot"', '<joint axis="1 0 0"/><joint name="pivot"', "has 2 joints"),
        ("</worldbody>", '<body><freejoint/><geom size="1"/></body></worldbody>', "one root"),
        ('damping="0.001"', 'stiffness="5" springref="30"', "springref"),
        ("<asset>", '<asset><mesh builtin="sphere" params="9"/>', "names no file"),
        ('size="0.08"', 'size="1e-9"', "at least 1e-05 m"),
        ('type="ellipsoid"', 'type="nonsense"', "MuJoCo does not read it"),
    ],
)
def test_what_cannot_be_held_of_mjcf(old: str, new: str, told: str, pendulum: Path) -> None:
    assert old in PENDULUM
    pendulum.write_text(PENDULUM.replace(old, new, 1))
    with pytest.raises(UserError, match=told):
        import_model(pendulum)


def test_what_hangs_in_the_empty_world_is_refused(pendulum: Path) -> None:
    lines = [x for x in PENDULUM.splitlines() if '"foot"' not in x and '"post"' not in x]
    pendulum.write_text("\n".join(lines))
    with pytest.raises(UserError, match="hangs in the empty world"):
        import_model(pendulum)


def test_a_link_out_of_the_folder_is_not_followed(cabinet: Path, tmp_path: Path) -> None:
    leaf = cabinet.parent / "meshes" / "leaf.stl"
    leaf.rename(tmp_path / "leaf.stl")
    leaf.symlink_to(tmp_path / "leaf.stl")
    with pytest.raises(UserError, match="it is no file in"):
        import_model(cabinet)


def test_a_name_of_the_library_stays_its_own(cabinet: Path) -> None:
    for name, why in (("quorl pendulum", "parts of its own"), ("cabinet", "parametric library")):
        cabinet.write_text(CABINET.replace("quorl cabinet", name))
        (problem,) = import_assets(cabinet)["problems"]
        assert problem["problem"].startswith("warning") and why in problem["problem"]
    assert not resolved("A ball rolls past a cabinet.").spatial_relation_graph.joints


def test_a_full_disk_leaves_nothing_that_is_named(cabinet: Path) -> None:
    with small_files(1500), pytest.raises(UserError, match="cannot write"):
        import_model(cabinet)
    assert not resolved("A ball rolls past a quorl cabinet.").spatial_relation_graph.joints


def test_a_damaged_record_is_told(cabinet: Path, library: Path) -> None:
    import_model(cabinet)
    path = library / "cabinet" / "assets" / "quorl_cabinet.json"
    record = json.loads(path.read_text())
    record["joints"][0]["kind"] = "screw"
    path.write_text(json.dumps(record))
    with pytest.raises(UserError, match="is damaged"):
        resolved("A ball rolls past a quorl cabinet.")


def played(prompt: str, seconds: float) -> tuple[EsgDocument, SimScene, Rollout]:
    """A prompt's scene laid out and played in PhysX with nothing commanded."""
    doc = solve(resolved(prompt), seed=0)
    scene = build_scene(doc)
    batch = batch_programs([Program((), seconds)], scene.names)
    return doc, scene, get_engine("physx").rollout(scene, batch, dt=1 / 120)


def test_the_door_falls_open_and_the_drawer_stays(cabinet: Path) -> None:
    """Its hinge is at its lower edge, and it starts 0.1 rad out of the upright."""
    import_model(cabinet)
    doc, scene, rollout = played("A ball rolls past a quorl cabinet.", 3.0)
    opened = angles(doc, scene, rollout, "hinge")
    assert opened[0] == pytest.approx(0, abs=0.5)
    assert opened[-1] == pytest.approx(math.degrees(1.4), abs=2)
    drawer = next(j.child for j in doc.spatial_relation_graph.joints or () if j.kind == "slider")
    k = scene.names.index(drawer)
    assert np.abs(np.ptp(rollout.position[0, :, k], axis=0)).max() < 0.01


def test_the_pendulum_swings(pendulum: Path) -> None:
    import_model(pendulum)
    doc, scene, rollout = played("A ball rolls past a snark wobbler.", 2.0)
    swung = angles(doc, scene, rollout, "hinge")
    # From 40 degrees on one side of the lowest point to nearly as far on the other.
    assert 70 < np.abs(swung).max() < 85
    assert np.abs(swung[-1]) < np.abs(swung).max()


def angles(doc: EsgDocument, scene: SimScene, rollout: Rollout, kind: str) -> np.ndarray:
    """How far a joint's child has turned from where it started [deg], over time."""
    child = next(j.child for j in doc.spatial_relation_graph.joints or () if j.kind == kind)
    turns = rollout.quaternion[0, :, scene.names.index(child)]
    return np.degrees(2 * np.arccos(np.clip(np.abs(turns @ turns[0]), 0, 1)))
