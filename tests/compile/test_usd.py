"""What the exported USD says to NVIDIA's PhysX, and its control program."""

from __future__ import annotations

from dataclasses import fields, replace
import json
import math
from pathlib import Path

import numpy as np
import pytest
from random_scenes import random_scene
import scenes
from usd import DOCS, PLAYER, player, usd_of

from esg.compile.usd import GROUNDED
from esg.engines.manifest import manifest_to_json
from esg.engines.program import (
    KINDS,
    AdjustProperties,
    ApplyImpulse,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Program,
    SetVelocity,
    program_from_json,
)
from esg.engines.scene import SimScene
from esg.units import quat_rotate

LYING = (0.5, 0.5, 0.5, 0.5)
EVERY_KIND = Program(
    (
        SetVelocity("crate", 0.0, (3.0, -1.0, 2.0), (0.5, 1.0, -2.0)),
        SetVelocity("ball", 0.1, (1.0, 0.0, 0.0)),
        ApplyImpulse("crate", 0.2, (4.0, 8.0, -2.0)),
        AdjustProperties("crate", 0.3, linear_damping=2.0, friction=0.2),
        AdjustProperties("ball", 0.3, angular_damping=0.0),
        AdjustProperties("ball", 0.4, braking=3.5),
        HoldVelocity("ball", 0.5, math.inf, 2.0, 0.3, 1.0, 5.0, 0.1, 0.1, ("crate", "post")),
        HoldVelocity("crate", 0.6, 0.8, 2.0, 0.3, climb=0.0),
        GuideAlong("crate", 0.9, (0.0, 1.0, 1.5), ((0.0, 0.0, 2.0),) * 3, ((0.5, 0.0, 0.2),) * 3),
        HoldSpin("ball", 1.0, 1.5, 5.0, (0.0, 0.6, -2.0), ("post",)),
    ),
    2.5,
)


def every_kind() -> SimScene:
    crate = replace(
        scenes.box("crate", (0.0, 0.0, 2.0), (0.3, 0.2, 0.1), 4.0),
        quaternion=LYING, linear_damping=0.25, angular_damping=1.5,
    )  # fmt: skip
    post = scenes.box("post", (5.0, 0.0, 1.0), (0.1, 0.1, 1.0), 1.0, static=True)
    return SimScene("kinds", (crate, scenes.ball("ball", (0.0, 3.0, 0.1), 0.1, 1.0), post))


def test_every_command_comes_back_from_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The player's reader gives the program and the bodies that the manifest has."""
    from pxr import Usd

    read = player(monkeypatch).read_scene
    cases = [(every_kind(), EVERY_KIND), *(random_scene(seed)[:2] for seed in range(12))]
    for scene, program in cases:
        found = read(Usd.Stage.Open(str(usd_of(tmp_path, scene, program))))
        data = {"version": 1, **found["program"]}
        for command in data["primitives"]:
            known = {f.name for f in fields(next(k for k in KINDS if k.kind == command["kind"]))}
            for name in set(command) - known - {"kind"}:
                assert not command.pop(name), name
        assert program_from_json(data) == program
        assert found["dt"] == 1 / 240
        np.testing.assert_allclose(found["gravity"], scene.gravity, rtol=1e-6, atol=1e-9)
        expected = manifest_to_json(scene, program, dt=1 / 240)["bodies"]
        for mine, theirs in zip(found["bodies"], expected, strict=True):
            assert mine["name"] == theirs["name"]
            for field in GROUNDED:
                assert mine.get(field, 0.0) == theirs.get(field, 0.0)
            if not mine["static"]:
                np.testing.assert_allclose(mine["inertia"], theirs["inertia"], rtol=1e-5, atol=1e-7)
            assert bool(mine["shapes"]) == bool(theirs["shapes"])


def test_a_reader_without_the_player_finds_typed_attributes(tmp_path: Path) -> None:
    from pxr import Usd

    stage = Usd.Stage.Open(str(usd_of(tmp_path, every_kind(), EVERY_KIND)))
    root = stage.GetPrimAtPath("/World/Program")
    assert root.GetAttribute("esg:duration").Get() == 2.5
    hold = stage.GetPrimAtPath("/World/Program/Command6")
    assert hold.GetAttribute("esg:kind").Get() == "HoldVelocity"
    assert not hold.GetAttribute("esg:end").IsValid()
    targets = {n: [str(t) for t in hold.GetRelationship(f"esg:{n}").GetTargets()]
               for n in ("body", "until_contact")}  # fmt: skip
    assert targets == {"body": ["/World/Ball"], "until_contact": ["/World/Crate", "/World/Post"]}
    guide = stage.GetPrimAtPath("/World/Program/Command8")
    types = {n: str(guide.GetAttribute(f"esg:{n}").GetTypeName()) for n in ("times", "points")}
    assert types == {"times": "double[]", "points": "double3[]"}


def test_velocities_are_local_degrees_and_say_so(tmp_path: Path) -> None:
    """NVIDIA's PhysX takes velocities of bodies without the flag as the world's."""
    from pxr import Usd, UsdPhysics

    stage = Usd.Stage.Open(str(usd_of(tmp_path, every_kind(), EVERY_KIND)))
    prim = stage.GetPrimAtPath("/World/Crate")
    assert prim.GetMetadata("customData")["physics"] == {"localSpaceVelocities": True}
    rigid = UsdPhysics.RigidBodyAPI(prim)
    linear, angular = rigid.GetVelocityAttr().Get(), rigid.GetAngularVelocityAttr().Get()
    np.testing.assert_allclose(quat_rotate(LYING, linear), (3.0, -1.0, 2.0), atol=1e-6)
    np.testing.assert_allclose(quat_rotate(LYING, angular), np.degrees((0.5, 1.0, -2.0)), atol=1e-4)
    post = stage.GetPrimAtPath("/World/Post")
    assert not post.HasAPI(UsdPhysics.RigidBodyAPI)
    assert "physics" not in post.GetMetadata("customData")


def test_physx_finds_damping_solver_and_materials(tmp_path: Path) -> None:
    from pxr import Usd

    stage = Usd.Stage.Open(str(usd_of(tmp_path, every_kind(), EVERY_KIND)))

    def of(path: str, schema: str, *names: str) -> list[object]:
        prim = stage.GetPrimAtPath(path)
        assert schema in prim.GetMetadata("apiSchemas").GetAppliedItems()
        return [prim.GetAttribute(name).Get() for name in names]

    body = of(
        "/World/Crate", "PhysxRigidBodyAPI", "physxRigidBody:linearDamping",
        "physxRigidBody:angularDamping", "physxRigidBody:maxAngularVelocity",
    )  # fmt: skip
    assert body == [0.25, 1.5, pytest.approx(math.degrees(1e6))]
    assert of("/World/Crate", "PhysxContactReportAPI", "physxContactReport:threshold") == [0.0]
    assert of(
        "/World/PhysicsScene", "PhysxSceneAPI", "physxScene:timeStepsPerSecond",
        "physxScene:solverType", "physxScene:enableExternalForcesEveryIteration",
    ) == [240, "PGS", False]  # fmt: skip
    modes = ("physxMaterial:frictionCombineMode", "physxMaterial:restitutionCombineMode")
    for material in ("Crate", "Ground"):
        assert of(f"/World/Looks/{material}", "PhysxMaterialAPI", *modes) == ["average"] * 2
    for collider in ("Crate/Collider0", "Ground"):
        path = f"/World/{collider}"
        assert of(path, "PhysxCollisionAPI", "physxCollision:restOffset") == [0.0]


def test_each_ground_is_deaf_to_the_others_bodies(tmp_path: Path) -> None:
    from pxr import Usd, UsdPhysics

    ball = scenes.ball("ball", (0.0, 0.0, 0.1), 0.1, 1.0)
    car = replace(scenes.box("car", (3.0, 0.0, 0.5), (2.0, 0.8, 0.5), 900.0), wheeled=True)
    path = usd_of(tmp_path, SimScene("two", (ball, car)), Program((), 1.0))
    stage = Usd.Stage.Open(str(path))
    deaf = {}
    for ground in ("Ground", "VehicleGround"):
        api = UsdPhysics.FilteredPairsAPI(stage.GetPrimAtPath(f"/World/{ground}"))
        deaf[ground] = [str(t) for t in api.GetFilteredPairsRel().GetTargets()]
    assert deaf == {"Ground": ["/World/Car"], "VehicleGround": ["/World/Ball"]}


def test_a_body_may_have_the_name_of_what_the_file_needs(tmp_path: Path) -> None:
    from pxr import Usd, UsdPhysics

    names = ("Program", "Looks", "Ground", "PhysicsScene")
    bodies = tuple(scenes.ball(n, (i, 0.0, 0.1), 0.1, 1.0) for i, n in enumerate(names))
    program = Program((SetVelocity("Program", 0.0, (0.0, 1.0, 0.0)),), 0.2)
    stage = Usd.Stage.Open(str(usd_of(tmp_path, SimScene("names", bodies), program)))
    found = [
        json.loads(p.GetCustomDataByKey("esg:name"))
        for p in stage.Traverse()
        if p.HasAPI(UsdPhysics.RigidBodyAPI)
    ]
    assert found == list(names)
    assert stage.GetPrimAtPath("/World/Program/Command0").IsValid()
    assert stage.GetPrimAtPath("/World/PhysicsScene").GetTypeName() == "PhysicsScene"


def test_the_player_needs_nothing_of_ours() -> None:
    for path in (PLAYER, DOCS / "read_manifest.py"):
        imports = [
            s for s in path.read_text().splitlines() if s.lstrip().startswith(("import", "from"))
        ]
        assert imports and not any("esg" in s for s in imports)
