# pyright: reportAttributeAccessIssue=false
"""OpenUSD: a UsdPhysics scene to simulate, and a layer with the baked replay to play.

`scene.usda` (m, kg, Z up) holds bodies with mass properties, colliders, materials, start
velocities, and the control program as prims. `scene_animation.usda` sublayers it, switches its
rigid bodies off and adds time samples of the replay, so that one file simulates and the other
plays. Both show the meshes, materials, ground and lights of `scene_looks.usdc`.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.assets.gltf.parts import parts_of
from esg.compile import names
from esg.compile.glb import continuous, mesh_of
from esg.compile.mjcf import start_velocities
from esg.compile.usd_physx import (
    articulate,
    physx_body,
    physx_collider,
    physx_distance,
    physx_joint,
    physx_material,
    physx_scene,
)
from esg.compile.usd_program import write_program
from esg.compile.visuals.decals import drawn_lifts
from esg.compile.visuals.ropes import Rope, ropes_of
from esg.compile.visuals.setting import Setting, View, by_track, seen_at
from esg.compile.visuals.usd_files import (
    LOOKS_FILE,
    UsdForm,
    UsdScene,
    write_layers,
    write_package,
)
from esg.compile.visuals.usd_looks import (
    ROOT,
    SURROUNDINGS,
    UsdLooks,
    camera_prim,
    place,
    quatd,
    triangles,
)
from esg.engines.breaking import hidden, whole_of_fragments
from esg.engines.joint_rules import BREAK_WINDOW_S
from esg.engines.joints import WORLD, Joint
from esg.engines.manifest import Manifest, carried_json
from esg.engines.physx_engine import position_iterations
from esg.engines.scene import FRAGMENT, Body, Rollout, Shape, SimScene
from esg.engines.wheels import wheel_angles
from esg.engines.worlds import principal_axes
from esg.units import quat_multiply, quat_rotate

if TYPE_CHECKING:
    from esg.view.pieces import Part

GROUND_SIZE_M = 200.0
"""Side of the drawn ground; the collider is an endless plane."""

GROUNDED = ("roll_radius", "wheeled", "tyre_friction", "tyre_drop", "tyre_foot")
"""Fields of a body that a player asks for who lets brakes and tyres act (docs/read_traction.py)."""
_RESERVED = ("Ground", "VehicleGround", "Looks", "PhysicsScene", "Program")
_SURROUNDINGS = ("Surroundings", "Cameras")
LIMBS_HZ = 30.0
"""Limbs have so many poses a second; there is no physics in them."""
JOINTS_PATH, ROPES_PATH, SHOWS_PATH = "/World/Joints", "/World/Ropes", "/World/Shows"
SURROUNDINGS_PATH, CAMERAS_PATH = "/World/Surroundings", "/World/Cameras"
_GONE = 1e-6
"""Size of a rope that has broken [m]."""
DRIVE_STRENGTH = 1e4
"""Of a motor that its limit alone holds back [N s/m, N/m and by the radian]."""
_RAD_TO_DEG = 180.0 / np.pi


def reserved(scene: SimScene, setting: Setting | None) -> tuple[str, ...]:
    """Names of prims that no body gets."""
    ropes = ("Ropes",) if any(j.flexible for j in scene.joints) else ()
    joints = ("Joints",) if scene.joints else ()
    ropes += ("Shows",) if setting is not None and setting.shows else ()
    return (*_RESERVED, *joints, *ropes, *(() if setting is None else _SURROUNDINGS))


def write_usd(
    manifest: Manifest,
    rollout: Rollout,
    folder: Path,
    out: Path,
    *,
    setting: Setting | None = None,
    form: UsdForm = "usda",
) -> list[Path]:
    """Writes the scene; the same input gives the same bytes.

    Args:
        manifest: Scene and program.
        rollout: Replay for the time samples.
        folder: Scene folder with the meshes.
        out: Where to write.
        setting: Ground, dressing, light and cameras; None: the bodies alone.
        form: Layers as text, in binary, or a package of what is seen.
    """
    scene = usd_scene(manifest, rollout, folder, setting, "usda" if form == "usda" else "usdc")
    return write_package(scene, out) if form == "usdz" else write_layers(scene, out, form)


def usd_scene(
    manifest: Manifest,
    rollout: Rollout,
    folder: Path,
    setting: Setting | None = None,
    suffix: str = "usda",
) -> UsdScene:
    """The layers of a scene, in memory."""
    from pxr import Sdf

    looks = UsdLooks(Sdf.Layer.CreateAnonymous(".usdc"))
    physics = physics_layer(manifest, looks, folder, setting)
    animation = _animation_layer(manifest, rollout, setting, f"scene.{suffix}")
    if manifest.scene.joints:
        _let_go(animation, physics)
    pictures = {name: picture.data for name, picture in sorted(looks.pictures.items())}
    return UsdScene(physics, animation, looks.layer, pictures)


def physics_layer(
    manifest: Manifest, looks: UsdLooks, folder: Path, setting: Setting | None = None
) -> Any:
    """The scene to simulate, an `Sdf.Layer`.

    Args:
        manifest: Scene and program.
        looks: Receives the meshes, to which the layer refers.
        folder: Scene folder with the meshes.
        setting: What is seen beside the bodies.
    """
    from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics

    scene = manifest.scene
    layer = Sdf.Layer.CreateAnonymous(".usda")
    stage = Usd.Stage.Open(layer)
    _stage_metrics(stage)
    world = UsdGeom.Xform.Define(stage, "/World").GetPrim()
    stage.SetDefaultPrim(world)
    world.SetCustomDataByKey("esg:scene_id", json.dumps(scene.scene_id))
    # What a judge cannot see in colliders: regions, words, ground (docs/judging.md).
    world.SetCustomDataByKey("esg:manifest", json.dumps(carried_json(manifest)))
    world.SetCustomDataByKey("esg:watch", json.dumps([list(p) for p in manifest.watch]))
    physics = UsdPhysics.Scene.Define(stage, "/World/PhysicsScene")
    strength = float(np.linalg.norm(scene.gravity))
    down = np.array(scene.gravity) / strength if strength else np.array([0.0, 0.0, -1.0])
    physics.CreateGravityDirectionAttr(Gf.Vec3f(*map(float, down)))
    physics.CreateGravityMagnitudeAttr(strength)
    physx_scene(physics.GetPrim(), scene, manifest.dt)
    idents = names.unique_identifiers(scene.names, reserved=reserved(scene, setting))
    paths = {name: f"/World/{ident}" for name, ident in idents.items()}
    moving = [b for b in scene.bodies if b.collides and not b.static]
    wheeled = [idents[b.name] for b in moving if b.wheeled]
    normal = [idents[b.name] for b in moving if not b.wheeled]
    _ground(stage, manifest, normal, wheeled, drawn=setting is None)
    start, iterations = start_velocities(manifest), position_iterations(scene)
    UsdGeom.Scope.Define(stage, "/World/Looks")
    for body in scene.bodies:
        prim = _body(stage, paths[body.name], body)
        if body.collides and not body.static:
            _moving(prim, body, start, iterations)
        _breaking(prim, body)
    references = _seen(stage, manifest, paths, looks, folder, setting)
    joints = _joints(stage, manifest, paths)
    write_program(stage, manifest.program, manifest.dt, paths, joints)
    # The layer is in memory: a stage would look for what it refers to beside nothing and complain.
    del stage
    for path, target in references:
        reference = Sdf.Reference(f"./{LOOKS_FILE}", target)
        layer.GetPrimAtPath(path).referenceList.prependedItems.append(reference)
    return layer


def _moving(prim: Any, body: Body, start: dict[str, Any], iterations: int) -> None:
    """Velocities at the start, and what PhysX wants to know of a body that moves."""
    from pxr import Gf, UsdPhysics

    # UsdPhysics states velocities in the space of the body's own xform, angles in degrees.
    x, y, z, w = body.quaternion
    linear, angular = (
        quat_rotate((-x, -y, -z, w), v) for v in start.get(body.name, ((0.0,) * 3, (0.0,) * 3))
    )
    rigid = UsdPhysics.RigidBodyAPI(prim)
    rigid.CreateVelocityAttr(Gf.Vec3f(*map(float, linear)))
    rigid.CreateAngularVelocityAttr(Gf.Vec3f(*(float(v) * _RAD_TO_DEG for v in angular)))
    # NVIDIA's PhysX takes velocities as the world's unless a body says otherwise.
    prim.SetCustomDataByKey("physics:localSpaceVelocities", True)
    physx_body(prim, body, iterations)


def _seen(
    stage: Any,
    manifest: Manifest,
    paths: dict[str, str],
    looks: UsdLooks,
    folder: Path,
    setting: Setting | None,
) -> list[tuple[str, str]]:
    """Writes what is seen; returns which prims refer to which of the looks."""
    from pxr import UsdGeom

    scene = manifest.scene
    library: dict[str, str] = {}
    out: list[tuple[str, str]] = []
    lifts = {} if setting is None else drawn_lifts(scene, setting.covered)
    wholes = whole_of_fragments(scene)
    for index, body in enumerate(scene.bodies):
        if setting is not None and body.name in setting.covered:
            continue
        key, data = mesh_of(body, folder, wholes.get(body.name))
        if data is None:
            continue
        if key not in library:
            library[key] = f"{ROOT}/Asset{len(library)}"
            looks.asset(library[key], parts_of(data), body)
        visual = UsdGeom.Xform.Define(stage, f"{paths[body.name]}/Visual")
        if index in lifts:
            up = visual.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble)
            up.Set((0.0, 0.0, lifts[index]))
        if setting is not None and body.name in setting.redrawn:
            UsdGeom.Imageable(visual).MakeInvisible()
        out.append((str(visual.GetPath()), library[key]))
    positions = np.array([[b.position for b in scene.bodies]])
    quaternions = np.array([[b.quaternion for b in scene.bodies]])
    ropes = ropes_of(scene, positions, quaternions)
    if ropes:
        UsdGeom.Scope.Define(stage, ROPES_PATH)
    for rope, path in zip(ropes, _rope_paths(ropes), strict=True):
        form = UsdGeom.Xform.Define(stage, path)
        place(form, rope.position[0], rope.quaternion[0])
        form.AddScaleOp(UsdGeom.XformOp.PrecisionDouble).Set(_rope_scale(rope, 0))
        out.append((path, looks.rope(rope.kind)))
    for number, alike in enumerate(() if setting is None else by_track(setting.shows)):
        part = alike[0]
        UsdGeom.Scope.Define(stage, SHOWS_PATH)
        at, turn = _acted(part, (positions, quaternions), np.zeros(1))
        path = f"{SHOWS_PATH}/Show{number}"
        place(UsdGeom.Xform.Define(stage, path), at[0], turn[0])
        out.append((path, looks.show(number, alike)))
    if setting is not None:
        looks.surroundings(setting)
        UsdGeom.Xform.Define(stage, SURROUNDINGS_PATH)
        out.append((SURROUNDINGS_PATH, SURROUNDINGS))
        UsdGeom.Xform.Define(stage, CAMERAS_PATH)
        for path, view in _cameras(setting):
            camera_prim(stage, path, view, np.zeros(1))
    return out


def _acted(part: Part, poses: tuple[Any, Any], time: Any) -> tuple[Any, Any]:
    """Poses of what moves by the time alone in the world, for poses of all bodies, shape [T, B]."""
    assert part.act is not None
    at, turn = part.act.local(np.asarray(time, float))
    if part.body < 0:
        return at, turn
    position, quaternion = (np.asarray(v, float)[:, part.body] for v in poses)
    return position + quat_rotate(quaternion, at), quat_multiply(quaternion, turn)


def _rope_paths(ropes: list[Rope]) -> list[str]:
    idents = names.unique_identifiers(rope.name for rope in ropes)
    return [f"{ROPES_PATH}/{idents[rope.name]}" for rope in ropes]


def _rope_scale(rope: Rope, frame: int) -> Any:
    from pxr import Gf

    length = float(rope.length[frame])
    # Nothing can be turned back that has no size at all.
    across = rope.radius if length > 0.0 else _GONE
    return Gf.Vec3d(across, across, length or _GONE)


def _cameras(setting: Setting) -> list[tuple[str, View]]:
    idents = names.unique_identifiers(view.name for view in setting.views)
    return [(f"{CAMERAS_PATH}/{idents[view.name]}", view) for view in setting.views]


def _breaking(prim: Any, body: Body) -> None:
    """States what UsdPhysics has no words for; a fragment is not there until something breaks."""
    from pxr import Usd, UsdGeom, UsdPhysics

    if body.break_impulse is not None:
        prim.SetCustomDataByKey("esg:break_impulse", body.break_impulse)
        prim.SetCustomDataByKey("esg:fragments", json.dumps(list(body.fragments)))
    if body.category != FRAGMENT:
        return
    UsdGeom.Imageable(prim).MakeInvisible()
    UsdPhysics.RigidBodyAPI(prim).CreateRigidBodyEnabledAttr(False)
    for part in Usd.PrimRange(prim):
        if part.HasAPI(UsdPhysics.CollisionAPI):
            UsdPhysics.CollisionAPI(part).CreateCollisionEnabledAttr(False)


def _show(prim: Any, there: Any) -> None:
    """Shows a prim only in some frames, shape [T]: a sample wherever that changes."""
    from pxr import Sdf

    attribute = prim.CreateAttribute("visibility", Sdf.ValueTypeNames.Token)
    for frame, now in enumerate(there.tolist()):
        if frame == 0 or now != there[frame - 1]:
            attribute.Set("inherited" if now else "invisible", float(frame))


def _joints(stage: Any, manifest: Manifest, paths: dict[str, str]) -> dict[str, str]:
    """Writes the joints; returns their prims' paths by name."""
    from pxr import UsdGeom

    scene = manifest.scene
    if not scene.joints:
        return {}
    UsdGeom.Scope.Define(stage, JOINTS_PATH)
    idents = names.unique_identifiers(j.name for j in scene.joints)
    out = {name: f"{JOINTS_PATH}/{ident}" for name, ident in idents.items()}
    offsets = {b.name: np.asarray(b.origin_offset, float) for b in scene.bodies}
    fixed = {b.name for b in scene.bodies if b.static}
    for joint in scene.joints:
        _joint(stage, out[joint.name], joint, paths, offsets)
        if joint.parent in fixed and not joint.collide:
            _deaf(stage, paths[joint.child], paths[joint.parent])
    articulate(stage, scene, paths, out)
    return out


def _deaf(stage: Any, body: str, other: str) -> None:
    """Lets a body not touch what stands: its colliders are no body, which a joint could name."""
    from pxr import UsdPhysics

    pairs = UsdPhysics.FilteredPairsAPI.Apply(stage.GetPrimAtPath(body)).CreateFilteredPairsRel()
    for part in stage.GetPrimAtPath(other).GetChildren():
        if part.HasAPI(UsdPhysics.CollisionAPI):
            pairs.AddTarget(part.GetPath())


def _joint(
    stage: Any, path: str, joint: Joint, paths: dict[str, str], offsets: dict[str, Any]
) -> None:
    """One joint: body 0 is its parent, body 1 its child, X its axis."""
    from pxr import Gf, UsdPhysics

    kinds = {
        "hinge": UsdPhysics.RevoluteJoint,
        "slider": UsdPhysics.PrismaticJoint,
        "ball": UsdPhysics.SphericalJoint,
        "fixed": UsdPhysics.FixedJoint,
    }
    made = kinds.get(joint.kind, UsdPhysics.DistanceJoint).Define(stage, path)
    prim = made.GetPrim()
    prim.SetCustomDataByKey("esg:name", json.dumps(joint.name))
    if joint.parent != WORLD:
        made.CreateBody0Rel().SetTargets([paths[joint.parent]])
    made.CreateBody1Rel().SetTargets([paths[joint.child]])
    for name, anchor, turn, end in (
        (joint.parent, joint.parent_anchor, joint.parent_rotation, 0),
        (joint.child, joint.child_anchor, joint.child_rotation, 1),
    ):
        at = Gf.Vec3f(*map(float, np.asarray(anchor) - offsets.get(name, np.zeros(3))))
        place, face = (
            (made.CreateLocalPos0Attr, made.CreateLocalRot0Attr),
            (made.CreateLocalPos1Attr, made.CreateLocalRot1Attr),
        )[end]
        place(at)
        face(Gf.Quatf(quatd(turn)))
    made.CreateCollisionEnabledAttr(joint.collide)
    if joint.break_impulse is not None:
        made.CreateBreakForceAttr(joint.break_impulse / BREAK_WINDOW_S)
    if joint.flexible:
        made.CreateMinDistanceAttr(-1.0 if joint.kind == "rope" else joint.upper)
        made.CreateMaxDistanceAttr(joint.upper)
        physx_distance(prim, joint)
        return
    if joint.kind == "fixed":
        return
    made.CreateAxisAttr("X")
    if joint.kind == "ball":
        if joint.upper is not None:
            cone = float(np.degrees(joint.upper))
            made.CreateConeAngle0LimitAttr(cone)
            made.CreateConeAngle1LimitAttr(cone)
    else:
        _limits(prim, made, joint)
    physx_joint(prim, joint)


def _limits(prim: Any, made: Any, joint: Joint) -> None:
    """Limits and drive of a hinge (in degrees) or slider."""
    from pxr import UsdPhysics

    turns = joint.kind == "hinge"
    unit = _RAD_TO_DEG if turns else 1.0
    if joint.lower is not None:
        made.CreateLowerLimitAttr(joint.lower * unit)
    if joint.upper is not None:
        made.CreateUpperLimitAttr(joint.upper * unit)
    motor = joint.motor
    if not (motor or joint.stiffness or joint.damping):
        return
    drive = UsdPhysics.DriveAPI.Apply(prim, "angular" if turns else "linear")
    drive.CreateTypeAttr("force")
    stiffness, damping, place, speed = joint.stiffness, joint.damping, 0.0, 0.0
    if motor is not None and motor.position is None:
        damping, speed = DRIVE_STRENGTH, motor.speed
    elif motor is not None and motor.position is not None:
        stiffness, damping, place = DRIVE_STRENGTH, DRIVE_STRENGTH, motor.position
    # Strengths are said by the degree.
    drive.CreateStiffnessAttr(stiffness / unit)
    drive.CreateDampingAttr(damping / unit)
    drive.CreateTargetPositionAttr(place * unit)
    drive.CreateTargetVelocityAttr(speed * unit)
    if motor is not None and math.isfinite(motor.limit):
        drive.CreateMaxForceAttr(motor.limit)


def _stage_metrics(stage: Any) -> None:
    from pxr import UsdGeom, UsdPhysics

    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    UsdPhysics.SetStageKilogramsPerUnit(stage, 1.0)


def _material(stage: Any, name: str, friction: float, restitution: float) -> Any:
    from pxr import UsdPhysics, UsdShade

    material = UsdShade.Material.Define(stage, f"/World/Looks/{name}")
    physics = UsdPhysics.MaterialAPI.Apply(material.GetPrim())
    physics.CreateStaticFrictionAttr(float(friction))
    physics.CreateDynamicFrictionAttr(float(friction))
    physics.CreateRestitutionAttr(float(restitution))
    physx_material(material.GetPrim())
    return material


def _bind(prim: Any, material: Any) -> None:
    from pxr import UsdShade

    api = UsdShade.MaterialBindingAPI.Apply(prim)
    api.Bind(material, UsdShade.Tokens.weakerThanDescendants, "physics")


def _ground(
    stage: Any, manifest: Manifest, normal: list[str], wheeled: list[str], *, drawn: bool
) -> None:
    """Two planes: the ground of ordinary bodies and that of bodies on wheels."""
    from pxr import UsdGeom, UsdPhysics

    scene = manifest.scene
    for name, friction, deaf_to in (
        ("Ground", scene.ground_friction, wheeled),
        ("VehicleGround", scene.vehicle_ground_friction, normal),
    ):
        if name == "VehicleGround" and not wheeled:
            continue
        plane = UsdGeom.Plane.Define(stage, f"/World/{name}")
        plane.CreateAxisAttr("Z")
        plane.CreateWidthAttr(GROUND_SIZE_M)
        plane.CreateLengthAttr(GROUND_SIZE_M)
        half = GROUND_SIZE_M / 2
        plane.CreateExtentAttr([(-half, -half, 0.0), (half, half, 0.0)])
        plane.CreateDisplayColorAttr([(0.6, 0.6, 0.6)])
        if name == "VehicleGround":
            plane.CreateVisibilityAttr("invisible")
        if not drawn:
            plane.CreatePurposeAttr("guide")
        UsdPhysics.CollisionAPI.Apply(plane.GetPrim())
        physx_collider(plane.GetPrim())
        _bind(plane.GetPrim(), _material(stage, name, friction, scene.ground_restitution))
        if deaf_to:
            pairs = UsdPhysics.FilteredPairsAPI.Apply(plane.GetPrim()).CreateFilteredPairsRel()
            for ident in deaf_to:
                pairs.AddTarget(f"/World/{ident}")


def _body(stage: Any, path: str, body: Body) -> Any:
    """A body's Xform at the mesh's origin, with mass properties and colliders."""
    from pxr import Gf, UsdGeom, UsdPhysics

    form = UsdGeom.Xform.Define(stage, path)
    prim = form.GetPrim()
    offset = np.asarray(body.origin_offset, float)
    origin = np.asarray(body.position) + quat_rotate(body.quaternion, offset)
    form.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Vec3d(*map(float, origin)))
    form.AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(quatd(body.quaternion))
    # As JSON, because a name may hold characters that USD text cannot.
    prim.SetCustomDataByKey("esg:name", json.dumps(body.name))
    for field in GROUNDED:
        if value := getattr(body, field):
            prim.SetCustomDataByKey(f"esg:{field}", value)
    mass = UsdPhysics.MassAPI.Apply(prim)
    mass.CreateCenterOfMassAttr(Gf.Vec3f(*(float(-v) for v in offset)))
    if body.collides and not body.static:
        UsdPhysics.RigidBodyAPI.Apply(prim)
        moments, axes = principal_axes(np.asarray(body.inertia, float))
        mass.CreateMassAttr(float(body.mass))
        mass.CreateDiagonalInertiaAttr(Gf.Vec3f(*map(float, moments)))
        mass.CreatePrincipalAxesAttr(Gf.Quatf(quatd(axes)))
    if body.shapes:
        ident = path.rsplit("/", 1)[1]
        material = _material(stage, ident, body.friction, body.restitution)
        for number, shape in enumerate(body.shapes):
            _collider(stage, f"{path}/Collider{number}", shape, body, material)
    return prim


def _collider(stage: Any, path: str, shape: Shape, body: Body, material: Any) -> None:
    from pxr import Gf, UsdGeom, UsdPhysics

    x, y, z = (float(v) for v in shape.size)
    if shape.kind == "sphere":
        geom = UsdGeom.Sphere.Define(stage, path)
        geom.CreateRadiusAttr(x)
        half = (x, x, x)
    elif shape.kind == "capsule":
        geom = UsdGeom.Capsule.Define(stage, path)
        geom.CreateRadiusAttr(x)
        geom.CreateHeightAttr(2 * z)
        geom.CreateAxisAttr("Z")
        half = (x, x, z + x)
    elif shape.kind == "cylinder":
        geom = UsdGeom.Cylinder.Define(stage, path)
        geom.CreateRadiusAttr(x)
        geom.CreateHeightAttr(2 * z)
        geom.CreateAxisAttr("Z")
        half = (x, x, z)
    elif shape.kind == "box":
        geom = UsdGeom.Cube.Define(stage, path)
        geom.CreateSizeAttr(1.0)
        half = (0.5, 0.5, 0.5)
    else:
        geom = _hull(stage, path, shape)
        half = None
    if half is not None:
        geom.CreateExtentAttr([tuple(-v for v in half), half])
    at = np.asarray(shape.position) - np.asarray(body.origin_offset)
    geom.AddTranslateOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Vec3d(*map(float, at)))
    geom.AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(quatd(shape.quaternion))
    if shape.kind == "box":
        geom.AddScaleOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Vec3d(2 * x, 2 * y, 2 * z))
    geom.CreatePurposeAttr("guide")
    UsdPhysics.CollisionAPI.Apply(geom.GetPrim())
    physx_collider(geom.GetPrim(), hull=shape.kind == "convex")
    _bind(geom.GetPrim(), material)


def _hull(stage: Any, path: str, shape: Shape) -> Any:
    from pxr import UsdGeom, UsdPhysics
    import trimesh

    hull = trimesh.Trimesh(np.array(shape.vertices)).convex_hull
    mesh = UsdGeom.Mesh.Define(stage, path)
    triangles(mesh, hull.vertices, hull.faces)
    api = UsdPhysics.MeshCollisionAPI.Apply(mesh.GetPrim())
    api.CreateApproximationAttr("convexHull")
    return mesh


def _turn_wheels(stage: Any, path: str, body: Body, angles: Any) -> None:
    """Time samples of the wheels of the body at `path`, angles [rad], shape [T, wheels]."""
    from pxr import Sdf

    idents = names.unique_identifiers((w.name for w in body.wheels), "Wheel")
    for wheel, turned in zip(body.wheels, np.degrees(angles).T, strict=True):
        prim = stage.OverridePrim(f"{path}/Visual/{idents[wheel.name]}")
        attribute = prim.CreateAttribute("xformOp:rotateY", Sdf.ValueTypeNames.Double)
        for frame, angle in enumerate(turned):
            attribute.Set(float(angle), float(frame))


def _animation_layer(
    manifest: Manifest, rollout: Rollout, setting: Setting | None, physics: str
) -> Any:
    """The replay over the scene to simulate, an `Sdf.Layer`."""
    from pxr import Sdf, Usd

    scene = manifest.scene
    idents = names.unique_identifiers(scene.names, reserved=reserved(scene, setting))
    rate = 1.0 / (rollout.time[1] - rollout.time[0]) if len(rollout.time) > 1 else 1.0
    layer = Sdf.Layer.CreateAnonymous(".usda")
    stage = Usd.Stage.Open(layer)
    _stage_metrics(stage)
    stage.SetTimeCodesPerSecond(float(round(rate, 6)))
    stage.SetFramesPerSecond(float(round(rate, 6)))
    stage.SetStartTimeCode(0.0)
    stage.SetEndTimeCode(float(len(rollout.time) - 1))
    stage.SetDefaultPrim(stage.OverridePrim("/World"))
    absent = hidden(scene, rollout.position[0], rollout.quaternion[0])
    for i, body in enumerate(scene.bodies):
        if absent[:, i].any():
            _show(stage.OverridePrim(f"/World/{idents[body.name]}"), ~absent[:, i])
        if body.static or not body.collides:
            continue
        prim = stage.OverridePrim(f"/World/{idents[body.name]}")
        enabled = prim.CreateAttribute("physics:rigidBodyEnabled", Sdf.ValueTypeNames.Bool)
        enabled.Set(False)
        q = rollout.quaternion[0, :, i].astype(float)
        q = continuous(q / np.linalg.norm(q, axis=1, keepdims=True))
        offset = np.broadcast_to(np.asarray(body.origin_offset, float), (len(q), 3))
        _move(prim, rollout.position[0, :, i] + quat_rotate(q, offset), q)
        centers, turns = rollout.position[0, :, i], rollout.quaternion[0, :, i]
        angles = wheel_angles(body, rollout.time, centers, turns, scene.gravity)
        _turn_wheels(stage, str(prim.GetPath()), body, angles)
    ropes = ropes_of(scene, rollout.position[0], rollout.quaternion[0])
    for rope, path in zip(ropes, _rope_paths(ropes), strict=True):
        prim = stage.OverridePrim(path)
        _move(prim, rope.position, continuous(rope.quaternion))
        scale = prim.CreateAttribute("xformOp:scale", Sdf.ValueTypeNames.Double3)
        for frame in range(len(rope.length)):
            scale.Set(_rope_scale(rope, frame), float(frame))
    poses = rollout.position[0], rollout.quaternion[0]
    for number, (part, *_) in enumerate(() if setting is None else by_track(setting.shows)):
        prim = stage.OverridePrim(f"{SHOWS_PATH}/Show{number}")
        at, turn = _acted(part, poses, rollout.time)
        assert part.act is not None
        tracked = part.act.track is not None and len(rollout.time) > 1
        rate = 1.0 / max(float(np.median(np.diff(rollout.time))), 1e-6) if tracked else 0.0
        _move(prim, at, continuous(turn), max(1, round(rate / LIMBS_HZ)))
        there = part.act.seen(rollout.time)
        if not there.all():
            _show(prim, there)
    for path, view in _cameras(setting) if setting is not None else ():
        if len(view.time) > 1:
            at, turned = seen_at(view, rollout.time)
            _move(stage.OverridePrim(path), at, continuous(turned))
    # As above: without a stage, nothing looks for the other layer.
    del stage
    layer.subLayerPaths.append(f"./{physics}")
    return layer


def _let_go(animation: Any, physics: Any) -> None:
    """Switches off the joints of a scene that is played: what no simulator moves they hold no more.

    Args:
        animation: The layer that plays it.
        physics: The layer below, which has the joints.
    """
    from pxr import Sdf

    root = "PhysicsArticulationRootAPI"
    Sdf.CreatePrimInLayer(animation, "/World/Joints").active = False
    for spec in physics.GetPrimAtPath("/World").nameChildren:
        if root in (spec.GetInfo("apiSchemas") or Sdf.TokenListOp()).GetAppliedItems():
            gone = Sdf.TokenListOp()
            gone.deletedItems = [root]
            Sdf.CreatePrimInLayer(animation, spec.path).SetInfo("apiSchemas", gone)


def _move(prim: Any, positions: Any, quaternions: Any, every: int = 1) -> None:
    """Time samples of a prim's pose, shapes [T, 3] and [T, 4]; of every so many frames."""
    from pxr import Sdf

    translate = prim.CreateAttribute("xformOp:translate", Sdf.ValueTypeNames.Double3)
    orient = prim.CreateAttribute("xformOp:orient", Sdf.ValueTypeNames.Quatd)
    for frame, (at, turn) in enumerate(zip(positions, quaternions, strict=True)):
        if frame % every and frame != len(positions) - 1:
            continue
        translate.Set(tuple(map(float, at)), float(frame))
        orient.Set(quatd(turn), float(frame))
