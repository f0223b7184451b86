"""Text of the emitted source file: a scene's values, its program and what is watched."""

from __future__ import annotations

from collections.abc import Iterable
import math

from esg.compile import frames, joints, names
from esg.compile.assets import Probe, probes
from esg.compile.model import ScenePlan, UnrealBody, UnrealWheel
from esg.engines.scene import Body, SimScene
from esg.engines.traction import Feature, features

INCLUDES = ("Components/StaticMeshComponent.h",)


def emit_source(plan: ScenePlan) -> str:
    """The .cpp file."""
    parts = (_preamble(plan), _constructor(plan), _bodies(plan), _program(plan), _dispatch(plan))
    text = "\n".join(part.strip("\n") + "\n" for part in parts)
    return text.replace("@CLASS@", plan.name)


def _preamble(plan: ScenePlan) -> str:
    paths = sorted((*INCLUDES, *joints.INCLUDES)) if plan.joints else INCLUDES
    return "\n".join(('#include "@CLASS@.h"', "", *(f'#include "{path}"' for path in paths)))


def _constructor(plan: ScenePlan) -> str:
    f = frames.float_literal
    lines = [
        "A@CLASS@::A@CLASS@()",
        "{",
        f"\tFixedTimeStep = {frames.literal(plan.time_step)};",
        f"\tWorldGravityZ = {f(plan.gravity_z)};",
        f"\tGroundFriction = {f(plan.ground_friction)};",
        f"\tGroundRestitution = {f(plan.ground_restitution)};",
        f"\tVehicleGroundFriction = {f(plan.vehicle_ground_friction)};",
        f"\tSceneDuration = {frames.literal(plan.duration)};",
    ]
    for body in plan.bodies:
        lines += ["", *_body_defaults(plan, body)]
    for joint in plan.joints:
        lines += ["", *joints.defaults_of(joint)]
    for p in plan.primitives:
        lines += ["", *(f"\t{p.member}.{field} = {value};" for field, value in p.values)]
    lines.append("}")
    return "\n".join(lines)


def _body_defaults(plan: ScenePlan, body: UnrealBody) -> list[str]:
    src, f = body.source, frames.float_literal
    rolls = [("bRolls", "true")] if plan.brakes and src.roll_radius > 0.0 else []
    values = [
        ("Location", frames.vector_literal(body.location)),
        ("Rotation", frames.quaternion_literal(body.rotation)),
        ("bSimulated", "true" if body.simulated else "false"),
        ("bCollides", "true" if src.collides else "false"),
        ("bOnWheels", "true" if src.wheeled else "false"),
        ("bReportsHits", "true" if body.member in plan.notified else "false"),
        ("Friction", f(src.friction)),
        ("Restitution", f(src.restitution)),
        *_bears(body),
    ]
    if body.simulated:
        values += [
            ("Mass", f(src.mass)),
            ("CenterOfMass", frames.vector_literal(body.center_of_mass)),
            ("PrincipalAxes", frames.quaternion_literal(body.principal_axes)),
            ("Inertia", frames.vector_literal(body.inertia)),
            ("LinearDamping", f(src.linear_damping)),
            ("AngularDamping", f(src.angular_damping)),
            *rolls,
            *_tyres(plan, src),
        ]
    path, name = names.string_literal(body.asset.path), names.string_literal(body.name)
    return [
        f"\t{body.member} = CreateMesh({name}, {path});",
        *(f"\t{body.settings}.{field} = {value};" for field, value in values),
        *(line for wheel in body.wheels for line in _wheel_defaults(body, wheel)),
    ]


def _bears(body: UnrealBody) -> list[tuple[str, str]]:
    """What the settings of a body say of its breaking."""
    impulse = body.source.break_impulse
    if impulse is None:
        return []
    return [("BreakImpulse", frames.literal(impulse * frames.CM_PER_M))]


def _wheel_defaults(body: UnrealBody, wheel: UnrealWheel) -> list[str]:
    path, name = names.string_literal(wheel.path), names.string_literal(wheel.name)
    return [
        f"\t{wheel.member} = CreateWheel({body.member}, {name}, {path});",
        f"\t{wheel.settings}.Axle = {frames.vector_literal(wheel.axle)};",
        f"\t{wheel.settings}.Radius = {frames.literal(wheel.radius)};",
    ]


def _tyres(plan: ScenePlan, body: Body) -> list[tuple[str, str]]:
    if not plan.tyres or body.tyre_friction == 0.0:
        return []
    row = features(SimScene("", (body,)))[0].tolist()
    values = (
        ("TyreFriction", row[Feature.GRIP]),
        ("TyreDrop", row[Feature.DROP] * frames.CM_PER_M),
        ("Axle", row[Feature.AXLE] * frames.CM_PER_M),
        ("Lean", row[Feature.LEAN] / frames.CM_PER_M**2),
        ("TyreFoot", row[Feature.FOOT] * frames.CM_PER_M),
        ("TipRate", math.degrees(row[Feature.TIP])),
    )
    return [(name, frames.literal(value)) for name, value in values]


def _bodies(plan: ScenePlan) -> str:
    """What there is; bodies with one mesh share the probes of the first of them."""
    first: dict[str, int] = {}
    number = {b.source.name: k for k, b in enumerate(plan.bodies)}
    lines: list[str] = []
    for k, b in enumerate(plan.bodies):
        like = first.setdefault(b.asset.path, k)
        lines.append(f"\tAddBody({b.member}, {b.settings}{f', {like}' if like < k else ''});")
        if like == k:
            lines += [_probe(p) for p in probes(b.asset)]
    lines += [f"\tAddWheel({w.member}, {b.member}, {w.settings});" for b, w in plan.wheels]
    lines += [joints.added(j) for j in plan.joints]
    lines += [
        f"\tAddBrittle({k}, {{ {', '.join(str(number[n]) for n in b.source.fragments)} }});"
        for k, b in enumerate(plan.bodies)
        if b.source.fragments
    ]
    lines += [
        f"\tAddStance({k}, {{ {', '.join(str(number[n]) for n in b.source.postures)} }});"
        for k, b in enumerate(plan.bodies)
        if b.source.postures
    ]
    return _function("CollectBodies()", lines)


def _probe(p: Probe) -> str:
    return (
        f"\tAddProbe({_shape(p)}, {frames.vector_literal(p.position)}, "
        f"{frames.quaternion_literal(p.quaternion)});"
    )


def _shape(p: Probe) -> str:
    x, _, z = p.size
    if p.kind == "sphere":
        return f"FCollisionShape::MakeSphere({frames.float_literal(x)})"
    if p.kind == "capsule":
        half = frames.float_literal(z + x)
        return f"FCollisionShape::MakeCapsule({frames.float_literal(x)}, {half})"
    return f"FCollisionShape::MakeBox({frames.vector_literal(p.size)})"


def _program(plan: ScenePlan) -> str:
    lines: list[str] = []
    for p in plan.primitives:
        until = f", {_list(p.until)}" if p.until else ""
        lines.append(f"\tAddCommand({'' if p.kind == 'DriveJoint' else p.body}{until});")
    for e in plan.events:
        after = f", {_list(map(str, e.after))}" if e.after else ""
        watched = f"{names.string_literal(e.id)}, {_list(e.first)}, {_list(e.second)}{after}"
        lines.append(f"\tAddEvent({watched});")
    return _function("CollectProgram()", lines)


def _list(items: Iterable[str]) -> str:
    return f"{{ {', '.join(items)} }}"


def _dispatch(plan: ScenePlan) -> str:
    lines = [
        f"\tRun{p.kind}({p.body}, {p.member}, Commands[{i}], Due);"
        for i, p in enumerate(plan.primitives)
    ]
    if plan.brakes or plan.tyres:
        lines = ["\tFindFalling(Due);", *lines, "\tApplyTraction(Due);"]
    nothing = ["\t// The program is empty: nothing is driven.", "\tstatic_cast<void>(Due);"]
    return _function("DispatchProgram(double Due)", lines or nothing)


def _function(head: str, lines: list[str]) -> str:
    return "\n".join((f"void A@CLASS@::{head}", "{", *lines, "}"))
