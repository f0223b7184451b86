"""Joints in the emitted class: it does what the program does, and says everything it does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from helpers import assert_same, both, written
import numpy as np
import pytest
import scenes
from test_export import folder_of
from usd import player, usd_of

from benchmarks.joints import Case as Swing
from benchmarks.joints import kept, pendulums, period
from esg.compile import ReplayError, emit_class, replay_class
from esg.compile.build import read_classes
from esg.compile.export import export
from esg.compile.mjcf import scene_mjcf
from esg.compile.names import unique_identifiers
from esg.compile.unreal.selfcontained import self_contained
from esg.engines import get_engine
from esg.engines.joints import Joint, Motor, joint_between
from esg.engines.manifest import manifest_from_json, manifest_to_json
from esg.engines.program import DriveJoint, Primitive, Program, SetVelocity, batch_programs
from esg.engines.scene import Body, SimScene

_Y, _Z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
Case = tuple[tuple[Body, ...], tuple[Joint, ...], tuple[Primitive, ...]]


def door() -> Case:
    """A door with limits, friction and a closer; a ball hits it."""
    frame = scenes.box("frame", (0.0, 0.0, 1.0), (0.05, 0.05, 1.0), 1.0, static=True, yaw=0.3)
    leaf = scenes.box("leaf", (0.5, 0.0, 1.05), (0.45, 0.02, 1.0), 20.0)
    ball = scenes.ball("ball", (0.8, -0.5, 1.0), 0.1, 2.0)
    hinge = joint_between("hinge", "hinge", leaf, frame, at=(0.05, 0.0, 1.05), axis=_Z)
    hinge = replace(hinge, lower=-0.2, upper=1.5, friction=0.8, stiffness=6.0, damping=2.0)
    return (frame, leaf, ball), (hinge,), (SetVelocity("ball", 0.0, (0.0, 5.0, 0.0)),)


def swing() -> Case:
    """A rod that swings on a post and is driven, to a speed, to a place, and let go."""
    post = scenes.box("post", (0.0, 0.4, 1.5), (0.1, 0.1, 1.5), 1.0, static=True)
    rod = scenes.box("rod", (0.0, 0.0, 2.5), (0.05, 0.05, 0.5), 2.0)
    hinge = joint_between("pivot", "hinge", rod, post, at=(0.0, 0.0, 2.95), axis=_Y, position=0.1)
    commands = (
        DriveJoint("pivot", 0.3, speed=2.0, limit=12.0),
        DriveJoint("pivot", 0.8, speed=1.5, position=-0.4),
        DriveJoint("pivot", 2.0),
    )
    return (post, rod), (hinge,), commands


def slide() -> Case:
    """A drawer with a limit on one side and a motor, and one that is drawn back."""
    drawers = [scenes.box(n, (0.0, y, 1.0), (0.2, 0.2, 0.1), 3.0) for n, y in (("a", 0), ("b", 1))]
    one, two = (
        joint_between(f"rail {b.name}", "slider", b, None, at=b.position, position=p)
        for b, p in zip(drawers, (0.0, 0.2), strict=True)
    )
    joints = (
        replace(one, lower=-0.1, upper=0.35, motor=Motor(0.3, limit=40.0)),
        replace(two, stiffness=80.0, damping=1.0),
    )
    return tuple(drawers), joints, ()


def hung() -> Case:
    """A lamp on a rope, a basket on a spring between two bodies, a cone, a weld that breaks."""
    beam = scenes.box("beam", (0.0, 0.0, 4.0), (2.0, 0.1, 0.1), 1.0, static=True)
    lamp = scenes.ball("lamp", (-1.0, 0.6, 3.0), 0.1, 1.0)
    cart = scenes.box("cart", (1.2, 0.0, 3.3), (0.1, 0.1, 0.1), 2.0)
    basket = scenes.box("basket", (1.3, 0.2, 2.6), (0.1, 0.1, 0.1), 1.0)
    arm = scenes.box("arm", (0.3, 0.0, 3.8), (0.3, 0.03, 0.03), 1.0)
    sign = scenes.box("sign", (-0.3, 0.0, 3.6), (0.1, 0.02, 0.2), 1.5)
    hook = joint_between("hook", "ball", arm, beam, at=(0.0, 0.0, 3.8))
    joints = (
        replace(
            joint_between("cord", "rope", lamp, beam, at=lamp.position, parent_at=(-1, 0, 3.9)),
            upper=1.2,
        ),
        replace(
            joint_between("coil", "spring", basket, cart, at=(1.3, 0.2, 2.7), parent_at=(1.2, 0, 3.2)),
            upper=0.4, stiffness=60.0, damping=0.5,
        ),
        replace(joint_between("rail", "slider", cart, beam, at=cart.position), friction=2.0),
        replace(hook, upper=0.7, damping=0.05),
        replace(joint_between("weld", "fixed", sign, beam, at=(-0.3, 0, 3.8)), break_impulse=2.5),
    )  # fmt: skip
    blow = SetVelocity("sign", 0.5, (0.0, 3.0, 0.0))
    return (beam, lamp, cart, basket, arm, sign), joints, (blow,)


CASES = {"door": door, "swing": swing, "slide": slide, "hung": hung}


def built(name: str) -> tuple[SimScene, Program]:
    bodies, joints, commands = CASES[name]()
    return SimScene(name, bodies, joints=joints), Program(commands, 3.0)


@pytest.mark.parametrize("engine", ["physx", "rapier"])
@pytest.mark.parametrize("name", CASES)
def test_class_and_program_do_the_same(tmp_path: Path, name: str, engine: str) -> None:
    scene, program = built(name)
    replayed, rollout = both(tmp_path, scene, program, engine=engine)
    assert replayed.rollout.valid.all()
    moved = np.abs(rollout.position[0, -1] - rollout.position[0, 0]).max()
    assert moved > 0.1
    assert_same(replayed.rollout, rollout, tolerance_m=2e-5)


def test_the_class_describes_the_joints(tmp_path: Path) -> None:
    for name in CASES:
        scene, program = built(name)
        written(tmp_path / name, scene, program)
        told = replay_class(tmp_path / name, duration=0.1).scene.joints
        assert [j.kind for j in told] == [j.kind for j in scene.joints]
        for one, two in zip(told, scene.joints, strict=True):
            assert (one.child, one.parent, one.collide) == (two.child, two.parent, two.collide)
            np.testing.assert_allclose(one.child_anchor, two.child_anchor, atol=1e-9)
            if two.kind != "spring":
                np.testing.assert_allclose(one.stiffness, two.stiffness, rtol=1e-6)
                np.testing.assert_allclose(one.damping, two.damping, rtol=1e-6)
            if two.stiffness > 0.0 and two.kind == "hinge":
                np.testing.assert_allclose(
                    (one.lower, one.upper), (two.lower, two.upper), rtol=1e-6
                )
                np.testing.assert_allclose(one.parent_rotation, two.parent_rotation, atol=1e-9)
            assert (one.break_impulse is None) == (two.break_impulse is None)


def test_every_value_of_a_joint_is_a_property_that_the_constructor_sets() -> None:
    scene, program = built("door")
    made = emit_class(scene, program)
    for line in (
        "HingeJointSettings.Lower = -85.9436692696235;",
        "HingeJointSettings.Upper = 11.4591559026165;",
        "HingeJointSettings.Friction = 8000.0;",
        "HingeJointSettings.Stiffness = 60000.0;",
        "HingeJointSettings.bMotor = false;",
        "HingeJointSettings.bBreaks = false;",
        'HingeJointConstraint = CreateConstraint(TEXT("HingeJoint"));',
    ):
        assert line in made.source
    assert "TObjectPtr<UPhysicsConstraintComponent> HingeJointConstraint;" in made.header
    assert "FEsgJoint HingeJointSettings;" in made.header


def test_a_command_to_a_joint_is_logged_and_unknown_joints_are_refused(tmp_path: Path) -> None:
    scene, program = built("swing")
    written(tmp_path, scene, program)
    log = replay_class(tmp_path, duration=1.0).log
    assert sum("COMMAND DriveJoint joint=PivotJoint" in line for line in log) == 2
    with pytest.raises(ValueError, match="DriveJoint names unknown joint 'lid'"):
        emit_class(scene, Program((DriveJoint("lid", 0.0),), 1.0))


def test_joined_bodies_do_not_count_as_overlapping(tmp_path: Path) -> None:
    scene, program = built("door")
    (hinge,) = scene.joints
    leaf = replace(scene.bodies[1], position=(0.4, 0.0, 1.05))
    bodies = (scene.bodies[0], leaf, scene.bodies[2])
    for joints, overlaps in (((hinge,), 0), ((), 1)):
        folder = tmp_path / str(overlaps)
        moved = tuple(
            replace(j, child_anchor=tuple(np.add(j.child_anchor, (0.1, 0.0, 0.0)).tolist()))
            for j in joints
        )
        written(folder, replace(scene, bodies=bodies, joints=moved), program)
        log = replay_class(folder, duration=0.05).log
        assert any(f"LAYOUT overlaps={overlaps}" in line for line in log)


def test_classes_without_joints_say_nothing_of_them() -> None:
    bodies, _, _ = door()
    made = emit_class(SimScene("door", bodies), Program((), 1.0))
    assert "Joint" not in made.source + made.header and "Constraint" not in made.source


def test_a_constraint_that_is_no_joint_is_refused(tmp_path: Path) -> None:
    scene, program = built("swing")
    written(tmp_path, scene, program)
    (files,) = read_classes([tmp_path])
    whole = self_contained(files)
    (tmp_path / "unreal" / f"{files.name}.h").write_text(whole.header)
    source, text = tmp_path / "unreal" / f"{files.name}.cpp", whole.source
    assert "Held->SetLinearYLimit(Across, Reach);" in text
    source.write_text(text.replace("SetLinearYLimit(Across,", "SetLinearYLimit(LCM_Free,"))
    with pytest.raises(ReplayError, match="PivotJoint leaves free what no joint does"):
        replay_class(tmp_path, duration=0.1, trust=True)


def mujoco_plays(scene: SimScene, program: Program, seconds: float) -> np.ndarray:
    """Centres of mass in MuJoCo [m], shape [T, B, 3]."""
    import mujoco

    manifest = manifest_from_json(manifest_to_json(scene, program, dt=1 / 240))
    model = mujoco.MjModel.from_xml_string(scene_mjcf(manifest))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    idents = unique_identifiers(scene.names)
    rows = [model.body(idents[b.name]).id for b in scene.bodies]
    out = [data.xpos[rows].copy()]
    for _ in range(round(seconds * 240)):
        mujoco.mj_step(model, data)
        mujoco.mj_kinematics(model, data)
        out.append(data.xpos[rows].copy())
    return np.array(out)


@pytest.mark.parametrize("case", pendulums(), ids=lambda case: case.name)
def test_pendulums_keep_their_period_in_mujoco(case: Swing) -> None:
    path = mujoco_plays(case.scene, Program((), 10.0), 10.0)[:, 0]
    x, _, z = (path - (0.0, 0.0, 3.0)).T
    angles = np.unwrap(np.arctan2(-x, -z))
    assert period(angles) == pytest.approx(case.exact[0], rel=1e-3)
    assert kept(angles, case.exact[0]) == pytest.approx(1.0, abs=1e-2)


def chest(ring: bool = False) -> tuple[SimScene, Program]:
    """A lid on a chest that moves as well; with a ring two joints hold it."""
    body = scenes.box("body", (0.0, 0.0, 0.2), (0.3, 0.2, 0.2), 10.0)
    lid = scenes.box("lid", (0.0, 0.0, 0.45), (0.3, 0.2, 0.05), 2.0)
    hinges = [
        joint_between(f"hinge {x}", "hinge", lid, body, at=(x, -0.2, 0.4), axis=(1.0, 0.0, 0.0))
        for x in ((-0.2, 0.2) if ring else (0.0,))
    ]
    return SimScene("chest", (body, lid), joints=tuple(hinges)), Program((), 1.0)


@pytest.mark.parametrize("ring", [False, True])
def test_usd_puts_joints_of_moving_bodies_into_an_articulation_of_newtons(
    tmp_path: Path, ring: bool
) -> None:
    """Newton's importer refuses them elsewhere; PhysX makes none of it."""
    from pxr import Usd, UsdPhysics

    usd = usd_of(tmp_path, *chest(ring))
    stage = Usd.Stage.Open(str(usd))
    roots = [p for p in stage.Traverse() if p.HasAPI(UsdPhysics.ArticulationRootAPI)]
    assert [str(p.GetPath()) for p in roots] == ["/World/Body"]
    assert roots[0].GetAttribute("physxArticulation:articulationEnabled").Get() is False
    held = [UsdPhysics.Joint(p) for p in stage.Traverse() if p.IsA(UsdPhysics.Joint)]
    out = [bool(j.GetExcludeFromArticulationAttr().Get()) for j in held]
    assert out == ([False, True] if ring else [False])
    newton = pytest.importorskip("newton")
    builder = newton.ModelBuilder()
    builder.add_usd(str(usd))
    assert builder.finalize(device="cpu").articulation_count == 1


def test_usd_starts_the_articulation_at_what_stands(tmp_path: Path) -> None:
    from pxr import Usd, UsdPhysics

    scene, program = chest()
    post = scenes.box("post", (0.0, 1.0, 1.0), (0.1, 0.1, 1.0), 1.0, static=True)
    hung = joint_between("arm", "hinge", scene.bodies[0], post, at=(0.0, 0.9, 0.2), axis=_Z)
    scene = replace(scene, bodies=(post, *scene.bodies), joints=(*scene.joints, hung))
    stage = Usd.Stage.Open(str(usd_of(tmp_path, scene, program)))
    roots = [p for p in stage.Traverse() if p.HasAPI(UsdPhysics.ArticulationRootAPI)]
    assert [str(p.GetPath()) for p in roots] == ["/World/Joints/Arm"]
    (tmp_path / "alone").mkdir()
    alone = Usd.Stage.Open(str(usd_of(tmp_path / "alone", *built("door"))))
    assert not [p for p in alone.Traverse() if p.HasAPI(UsdPhysics.ArticulationRootAPI)]


def test_usd_keeps_a_leaf_from_touching_the_frame_that_stands(tmp_path: Path) -> None:
    """Colliders of what stands are no body, so that the joint does not tell whom it means."""
    from pxr import Usd

    stage = Usd.Stage.Open(str(usd_of(tmp_path, *built("door"))))
    deaf = stage.GetPrimAtPath("/World/Leaf").GetRelationship("physics:filteredPairs")
    assert [str(p) for p in deaf.GetTargets()] == ["/World/Frame/Collider0"]


def test_usd_names_the_solver_with_which_the_scene_was_proven(tmp_path: Path) -> None:
    from pxr import Usd

    for scene, program, said in (
        (*chest(), "TGS"),
        (SimScene("bare", door()[0]), Program((), 1.0), "PGS"),
    ):
        (tmp_path / said).mkdir()
        stage = Usd.Stage.Open(str(usd_of(tmp_path / said, scene, program)))
        prim = stage.GetPrimAtPath("/World/PhysicsScene")
        assert prim.GetAttribute("physxScene:solverType").Get() == said


def test_the_documented_player_reads_a_jointed_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from pxr import Usd

    stage = Usd.Stage.Open(str(usd_of(tmp_path, *built("door"))))
    read = player(monkeypatch).read_scene(stage)
    assert [b["name"] for b in read["bodies"]] == ["frame", "leaf", "ball"]


@pytest.mark.parametrize("name", ["slide", "hung"])
def test_mujoco_starts_as_the_scene_and_moves_by_its_joints(name: str) -> None:
    scene, program = built(name)
    path = mujoco_plays(scene, program, 0.4)
    np.testing.assert_allclose(path[0], [b.position for b in scene.bodies], atol=1e-9)
    batch = batch_programs([program], scene.names)
    ours = get_engine("physx").rollout(scene, batch, duration=0.4).position[0]
    joined = [i for i, b in enumerate(scene.bodies) if b.name in {j.child for j in scene.joints}]
    # Later they meet limits, which are softer in MuJoCo.
    assert np.abs(path[45] - path[0]).max() > 0.02
    np.testing.assert_allclose(path[45, joined], ours[45, joined], atol=3e-3)


def test_mjcf_has_every_joint() -> None:
    found: dict[str, str] = {}
    for name in CASES:
        scene, program = built(name)
        manifest = manifest_from_json(manifest_to_json(scene, program, dt=1 / 240))
        found[name] = scene_mjcf(manifest)
    assert 'type="hinge"' in found["door"] and 'range="-0.2 1.5"' in found["door"]
    assert 'stiffness="6" damping="2" frictionloss="0.8"' in found["door"]
    assert '<exclude body1="Leaf" body2="Frame" />' in found["door"]
    assert (
        '<velocity name="RailA" joint="A_joint" forcerange="-40 40" kv="10000" />' in found["slide"]
    )
    for text in (
        'type="slide"',
        'type="ball"',
        'range="0 1.2"',
        'springlength="0.4"',
        "break_Weld",
    ):
        assert text in found["hung"]
    scene = SimScene("door", door()[0])
    manifest = manifest_from_json(manifest_to_json(scene, Program((), 1.0), dt=1 / 240))
    assert "oint" not in scene_mjcf(manifest).replace("freejoint", "").replace("free joint", "")


@pytest.mark.parametrize("name", CASES)
def test_usd_with_joints_is_valid(tmp_path: Path, name: str) -> None:
    from pxr import Usd, UsdValidation

    stage = Usd.Stage.Open(str(usd_of(tmp_path, *built(name))))
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    serious = UsdValidation.ValidationErrorType.Error
    assert [e.GetMessage() for e in errors if e.GetType() == serious] == []


@pytest.mark.parametrize("name", ["door", "hung", "chest"])
def test_usd_that_is_played_has_no_joints(tmp_path: Path, name: str) -> None:
    """Its bodies are no simulator's, and OpenUSD objects to joints and articulations of none."""
    from pxr import Usd, UsdPhysics, UsdValidation

    scene, program = chest() if name == "chest" else built(name)
    folder = folder_of(tmp_path, scene, program)
    played = next(p for p in export(folder, "usd", tmp_path / "out") if "animation" in p.name)
    stage = Usd.Stage.Open(str(played))
    prims = list(stage.Traverse())
    assert not any(
        p.IsA(UsdPhysics.Joint) or p.HasAPI(UsdPhysics.ArticulationRootAPI) for p in prims
    )
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    errors = UsdValidation.ValidationContext(validators).Validate(stage)
    serious = UsdValidation.ValidationErrorType.Error
    assert [e.GetMessage() for e in errors if e.GetType() == serious] == []


def test_usd_frames_of_a_joint_meet_in_the_world(tmp_path: Path) -> None:
    """The two frames are in the prims' own spaces and have one place and axis at position 0."""
    from pxr import Gf, Usd, UsdGeom, UsdPhysics

    for name in CASES:
        scene, program = built(name)
        folder = tmp_path / name
        folder.mkdir()
        stage = Usd.Stage.Open(str(usd_of(folder, scene, program)))
        found = [p for p in stage.Traverse() if p.IsA(UsdPhysics.Joint)]
        assert len(found) == len(scene.joints)
        cache = UsdGeom.XformCache()
        for prim, joint in zip(found, scene.joints, strict=True):
            made = UsdPhysics.Joint(prim)
            ends = []
            for rel, at, turn in (
                (made.GetBody0Rel(), made.GetLocalPos0Attr(), made.GetLocalRot0Attr()),
                (made.GetBody1Rel(), made.GetLocalPos1Attr(), made.GetLocalRot1Attr()),
            ):
                own = Gf.Matrix4d().SetTransform(Gf.Rotation(turn.Get()), Gf.Vec3d(at.Get()))
                targets = rel.GetTargets()
                base = (
                    cache.GetLocalToWorldTransform(stage.GetPrimAtPath(targets[0]))
                    if targets
                    else 1
                )
                ends.append(own * base)
            apart = (ends[0].ExtractTranslation() - ends[1].ExtractTranslation()).GetLength()
            if joint.kind in ("hinge", "ball", "fixed"):
                assert apart < 1e-6
            if joint.kind in ("hinge", "slider"):
                x = Gf.Vec3d(1, 0, 0)
                assert ends[0].TransformDir(x) * ends[1].TransformDir(x) == pytest.approx(1.0)


def test_usd_says_limits_drives_and_strength(tmp_path: Path) -> None:
    from pxr import Usd

    def prim_of(name: str, path: str) -> Usd.Prim:
        folder = tmp_path / name
        folder.mkdir(exist_ok=True)
        stages.append(Usd.Stage.Open(str(usd_of(folder, *built(name)))))
        return stages[-1].GetPrimAtPath(f"/World/Joints/{path}")

    stages: list[Usd.Stage] = []
    hinge = prim_of("door", "Hinge")
    assert hinge.GetTypeName() == "PhysicsRevoluteJoint"
    values = {a.GetName(): a.Get() for a in hinge.GetAttributes()}
    assert values["physics:axis"] == "X" and values["physics:collisionEnabled"] is False
    assert values["physics:upperLimit"] == pytest.approx(np.degrees(1.5))
    assert values["drive:angular:physics:stiffness"] == pytest.approx(6.0 * np.pi / 180.0)
    assert values["physxJoint:jointFriction"] == pytest.approx(0.8)
    rail = {a.GetName(): a.Get() for a in prim_of("slide", "RailA").GetAttributes()}
    assert rail["drive:linear:physics:targetVelocity"] == pytest.approx(0.3)
    assert rail["drive:linear:physics:maxForce"] == pytest.approx(40.0)
    kinds = [prim_of("hung", n).GetTypeName() for n in ("Cord", "Coil", "Hook", "Weld")]
    assert kinds == [f"Physics{k}Joint" for k in ("Distance", "Distance", "Spherical", "Fixed")]
    weld = prim_of("hung", "Weld").GetAttribute("physics:breakForce").Get()
    assert weld == pytest.approx(2.5 * 60.0)
    command = prim_of("swing", "Pivot").GetStage().GetPrimAtPath("/World/Program/Command0")
    assert [str(t) for t in command.GetRelationship("esg:joint").GetTargets()] == [
        "/World/Joints/Pivot"
    ]
