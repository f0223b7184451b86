"""Text of the emitted source file."""

from __future__ import annotations

from functools import cache
import math
from pathlib import Path

from esg.compile import frames, joints, names
from esg.compile.assets import MeshAsset, Probe, probes
from esg.compile.header import PRIMITIVE_FIELDS
from esg.compile.model import ScenePlan, UnrealBody, UnrealWheel
from esg.engines.joint_rules import BREAK_WINDOW_S
from esg.engines.program import GUIDE_RATE
from esg.engines.scene import Body, SimScene
from esg.engines.traction import (
    BLOW_MPS,
    FALLING,
    LEAST_LEAN_RAD_S,
    LEAST_TILT,
    ON_WHEELS,
    Feature,
    features,
)
from esg.engines.wheels import FALLS, RUNS_DOWN_S, UPRIGHT

INCLUDES = (
    "Components/PrimitiveComponent.h",
    "Components/SceneComponent.h",
    "Components/StaticMeshComponent.h",
    "Engine/EngineTypes.h",
    "Engine/StaticMesh.h",
    "Engine/World.h",
    "GameFramework/WorldSettings.h",
    "Misc/App.h",
    "Physics/PhysicsInterfaceCore.h",
    "PhysicalMaterials/PhysicalMaterial.h",
    "PhysicsEngine/BodyInstance.h",
    "UObject/ConstructorHelpers.h",
)


IN_FLIGHT = " && !Command.bFlies"
KEPT_RISE = "\tVelocity.Z = Body->GetPhysicsLinearVelocity().Z;"
FLIGHT = """\
\tif (Command.bFlies)
\t{
\t\t// The gravity of this step is still to act on it.
\t\tconst double Step = (Due - SceneTime) / @CLASS@Detail::HalfStep;
\t\tVelocity.Z = Command.Climb - WorldGravityZ * Step;
\t}
\telse
\t{
\t\tVelocity.Z = Body->GetPhysicsLinearVelocity().Z;
\t}"""
"""Vertical velocity of a hold, in classes with powered flight."""

APPROACH = """\
\tif (Command.bTakesTime)
\t{
\t\tconst double Step = (Due - SceneTime) / @CLASS@Detail::HalfStep;
\t\tconst double Gains = Command.Gains * Step;
\t\tconst double Loses = Command.Loses * Step;
\t\tconst FVector Ahead(FMath::Cos(Heading), FMath::Sin(Heading), 0.0);
\t\tconst FVector Aside(-Ahead.Y, Ahead.X, 0.0);
\t\tconst double Turned = Heading - FMath::DegreesToRadians(Command.TurnRate) * Step;
\t\tconst FVector Had = Body->GetPhysicsLinearVelocity();
\t\tdouble Along = FMath::Cos(Turned) * Had.X + FMath::Sin(Turned) * Had.Y;
\t\tdouble Across = FMath::Cos(Turned) * Had.Y - FMath::Sin(Turned) * Had.X;
\t\tAlong += FMath::Clamp(Speed - Along, -Loses, Gains);
\t\tAcross -= FMath::Clamp(Across, -Loses, Loses);
\t\tVelocity = Ahead * Along + Aside * Across;
\t}
"""
"""How a hold comes to its velocity, in classes in which one takes its time."""

SET_BRAKING = """\
	if (Command.bSetBraking)
	{
		for (FBodyRef& Braked : Bodies)
		{
			Braked.Braking = Braked.Component == Body ? Command.Braking : Braked.Braking;
		}
	}
"""
"""What sets the brakes of a body, in classes with brakes."""

FALLING_SHARE = f"""\
	/** What loses more than this share of a step's gravity within it, nothing carries. */
	constexpr double FallingShare = {frames.literal(FALLING)};

"""
"""Constant of classes with brakes or tyres."""

UPRIGHT_COSINE = f"""\
\t/** Of the tilt up to which a body stands on its wheels. */
\tconstexpr double UprightCosine = {frames.literal(ON_WHEELS)};

\t/** Change of velocity [cm/s] that costs a two-wheeler its balance; it leans on [deg/s]. */
\tconstexpr double Blow = {frames.literal(BLOW_MPS * frames.CM_PER_M)};
\tconstexpr double LeastTilt = {frames.literal(LEAST_TILT)};
\tconstexpr double LeastLean = {frames.literal(math.degrees(LEAST_LEAN_RAD_S))};

"""
"""Constants of classes with tyres."""

ROLL = """\
\tif (Body.Settings->bRolls)
\t{
\t\tFVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
\t\tSpin.X *= 1.0 - Lost;
\t\tSpin.Y *= 1.0 - Lost;
\t\tBody.Component->SetPhysicsAngularVelocityInDegrees(Spin);
\t}
"""
"""What brakes do to a round body, in classes with brakes."""

ALONG = """\
\tconst FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
\tconst double Up = Turn.RotateVector(FVector(0.0, 0.0, 1.0)).Z;
\tif (Body.Settings->TyreDrop > 0.0 && Up > @CLASS@Detail::UprightCosine)
\t{
\t\t// Its brakes leave to its tyres what it leans to the side with.
\t\tFVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
\t\tAhead.Z = 0.0;
\t\tAhead = Ahead * (1.0 / Ahead.Size());
\t\tLevel = Ahead * FVector::DotProduct(Ahead, Level);
\t}
"""
"""What brakes do to a two-wheeler, in classes with tyres."""

BRAKES = "\t\tApplyBrakes(Body, Body.Braking * Step);\n"
TYRES = """\
\t\tconst double Taken = ApplyBrakes(Body, Body.Braking * Step);
\t\tApplyTyres(Body, -WorldGravityZ * Step, Taken);
\t\tTipOver(Body);
"""
BLOW = """\
\t\tLost.Z = 0.0;
\t\tBody.bTips |= Body.Settings->TyreDrop > 0.0 && Lost.Size() > Blow;
"""
"""What acts on a body, in classes without and with tyres, and what tips a two-wheeler."""

GUIDING = f"""\
\t/** How fast a guided body that is off its path returns to it [1/s]. */
\tconstexpr double GuideRate = {frames.literal(GUIDE_RATE)};

\t/** Of the cubic that leads from one point of a path to the next. */
\tconstexpr double CubicSlope = 3.0;

"""
"""Constants of classes that guide a body."""

WHEELS = f"""\
\t/** A body whose up axis rises less than this does not stand on its wheels. */
\tconstexpr double Upright = {frames.literal(UPRIGHT)};

\t/** What gains this share of gravity's speed downwards is carried by nothing. */
\tconstexpr double Falls = {frames.literal(FALLS)};

\t/** In which a wheel that touches nothing runs down [s]. */
\tconstexpr double RunsDown = {frames.literal(RUNS_DOWN_S)};

"""
"""Constants of classes with wheels."""

BREAKING = f"""\
	/** Over which what a body takes adds up [s]. */
	constexpr double BreakWindow = {frames.literal(BREAK_WINDOW_S)};

"""
"""Constants of classes with what breaks."""
GONE = """\
	if (!First.Component->IsCollisionEnabled() || !Second.Component->IsCollisionEnabled())
	{
		return 0.0;
	}
"""
"""What is away overlaps with nothing."""
MOVES_HERE = "if (!Body.Settings->bSimulated || !Body.Component->IsSimulatingPhysics())"
"""Of what is there, in place of the same without what breaks."""


@cache
def _template(name: str) -> str:
    path = Path(__file__).parent / "templates" / f"{name}.cpp"
    return path.read_text("utf-8")


def emit_source(plan: ScenePlan) -> str:
    """The .cpp file."""
    shapes = {asset.path: i for i, asset in enumerate(plan.assets)}
    parts = [
        _preamble(plan),
        _constructor(plan),
        _construction(plan),
        _collect(plan, shapes),
        _dispatch(plan),
        *(_run(plan, kind) for kind in PRIMITIVE_FIELDS if kind in plan.kinds),
        *_traction(plan),
        _fixed(plan),
        *([_template("Wheels"), _collect_wheels(plan)] if plan.wheels else []),
        *([_template("Joints"), joints.collect(plan.joints)] if plan.joints else []),
        *([_template("Breaking"), _collect_fragments(plan)] if plan.breaks else []),
    ]
    text = "\n".join(part.strip("\n") + "\n" for part in parts)
    return text.replace("@CLASS@", plan.name)


def _fixed(plan: ScenePlan) -> str:
    """What is the same in every class, but for the words of its log and the call of its wheels."""
    text = _template("Fixed").replace("@LASTING@", "Hold" if plan.guides else "HoldVelocity")
    for mark, call in (
        ("@COLLECT_WHEELS@", "CollectWheels();"),
        ("@TURN_WHEELS@", "TurnWheels(Step);"),
    ):
        text = text.replace(f"\t{mark}\n", f"\t{call}\n" if plan.wheels else "")
    for mark, call in (
        ("\t@COLLECT_JOINTS@\n", "\tCollectJoints();\n"),
        ("\t@DRIVE_JOINTS@\n", "\tDriveJoints(Step);\n"),
        ("\t\t\t@JOINED@\n", joints.JOINED),
    ):
        text = text.replace(mark, call if plan.joints else "")
    for mark, call in (
        ("\t@COLLECT_FRAGMENTS@\n", "\tCollectFragments();\n"),
        ("\t@BREAK_BODIES@\n", "\tBreakBodies(Step);\n"),
        ("\t@REMEMBER_SPEEDS@\n", "\tRememberSpeeds();\n"),
        ("\t@TAKE_BLOW@\n", "\tTakeBlow(HitComponent, OtherComp, Touch.Impulse);\n"),
        ("\t@GONE@\n", GONE),
    ):
        text = text.replace(mark, call if plan.breaks else "")
    return text


def _collect_fragments(plan: ScenePlan) -> str:
    """What gathers the fragments of a class and puts them away."""
    number = {b.source.name: k for k, b in enumerate(plan.bodies)}
    lines = "\n".join(
        f"\tAddBrittle({k}, {{ {', '.join(str(number[n]) for n in b.source.fragments)} }});"
        for k, b in enumerate(plan.bodies)
        if b.source.fragments
    )
    return f"""
void A@CLASS@::CollectFragments()
{{
	Brittles.Reset();
{lines}
}}
"""


def _collect_wheels(plan: ScenePlan) -> str:
    lines = "\n".join(
        f"\tWheels.Add(FTurningWheel{{ {wheel.member}, {body.member}, &{wheel.settings} }});"
        for body, wheel in plan.wheels
        if body.simulated
    )
    return f"""
void A@CLASS@::CollectWheels()
{{
	Wheels.Reset();
{lines}
}}
"""


def _run(plan: ScenePlan, kind: str) -> str:
    """What executes primitives of a kind."""
    text = _template(f"Run{kind}")
    text = text.replace("@APPROACH@\n", APPROACH if plan.takes_time else "")
    text = text.replace("@SET_BRAKING@\n", SET_BRAKING if plan.brakes else "")
    return text.replace("@ON_GROUND@", IN_FLIGHT if plan.flies else "").replace(
        "@RISE@", FLIGHT if plan.flies else KEPT_RISE
    )


MOVES = "if (!Body.Settings->bSimulated || !Body.Settings->bCollides)"


def _traction(plan: ScenePlan) -> list[str]:
    """What plays brakes and tyres, in classes with them."""
    if not (plan.brakes or plan.tyres):
        return []
    text = _template("ApplyTraction").replace("@ROLL@\n", ROLL if plan.brakes else "")
    text = text.replace("@ALONG@\n", ALONG if plan.tyres else "")
    text = text.replace("@BLOW@\n", BLOW if plan.tyres else "")
    text = text.replace(MOVES, MOVES_HERE) if plan.breaks else text
    tyres = [_template("ApplyTyres")] if plan.tyres else []
    return [text.replace("@ACTS@\n", TYRES if plan.tyres else BRAKES), *tyres]


def _preamble(plan: ScenePlan) -> str:
    paths = sorted((*INCLUDES, *joints.INCLUDES)) if plan.joints else INCLUDES
    includes = "\n".join(f'#include "{path}"' for path in paths)
    tables = "\n".join(_probe_table(a) for a in plan.assets)
    constants = GUIDING if "GuideAlong" in plan.kinds else ""
    constants += FALLING_SHARE if plan.brakes or plan.tyres else ""
    constants += UPRIGHT_COSINE if plan.tyres else ""
    constants += WHEELS if plan.wheels else ""
    constants += joints.CONSTANTS if plan.joints else ""
    # Joints break within the same window.
    constants += BREAKING if plan.breaks and not plan.joints else ""
    return f"""#include "@CLASS@.h"

{includes}

DEFINE_LOG_CATEGORY_STATIC(Log@CLASS@, Log, All);

namespace @CLASS@Detail
{{
	/** Side of the engine's basic cube [cm]. */
	constexpr double BasicCubeSide = 100.0;

	/** The ground is a block this wide and thick [cm] whose top is at height 0. */
	constexpr double GroundSide = 400000.0;
	constexpr double GroundThickness = 200.0;

	/** Commands are due when their time is nearer to this step than to the next. */
	constexpr double HalfStep = 0.5;

	/** Largest rounding of a step to float [s]. */
	constexpr double StepRounding = 1.0e-7;

	/** High enough never to clamp a fast rolling ball [deg/s]. */
	constexpr float MaxSpin = 57295780.0f;

	/** Unreal's impulse unit is kg cm/s. */
	constexpr double ImpulsePerNewtonSecond = 100.0;

{constants}	/** A shape that penetration queries accept, in its mesh's frame. */
	struct FProbe
	{{
		FCollisionShape Shape;
		FVector Center;
		FQuat Rotation;
	}};

	/** Query shapes of every mesh of the scene. */
	const TArray<TArray<FProbe>>& Probes()
	{{
		static const TArray<TArray<FProbe>> Table = {{
{tables}
		}};
		return Table;
	}}
}}
"""


def _probe_table(asset: MeshAsset) -> str:
    rows = "\n".join(
        f"\t\t\t\t{{ {_shape(p)}, {frames.vector_literal(p.position)}, "
        f"{frames.quaternion_literal(p.quaternion)} }},"
        for p in probes(asset)
    )
    inner = f"\n{rows}\n\t\t\t" if rows else ""
    return f"\t\t\t// {asset.identifier}\n\t\t\t{{{inner}}},"


def _shape(p: Probe) -> str:
    x, _, z = p.size
    if p.kind == "sphere":
        return f"FCollisionShape::MakeSphere({frames.float_literal(x)})"
    if p.kind == "capsule":
        half = frames.float_literal(z + x)
        return f"FCollisionShape::MakeCapsule({frames.float_literal(x)}, {half})"
    return f"FCollisionShape::MakeBox({frames.vector_literal(p.size)})"


def _constructor(plan: ScenePlan) -> str:
    cube = 'TEXT("/Engine/BasicShapes/Cube.Cube")'
    lines = [
        f"A{plan.name}::A{plan.name}()",
        "{",
        "\tPrimaryActorTick.bCanEverTick = true;",
        "\tPrimaryActorTick.TickGroup = TG_PrePhysics;",
        "",
        '\tSceneOrigin = CreateDefaultSubobject<USceneComponent>(TEXT("SceneRoot"));',
        "\tSceneOrigin->SetMobility(EComponentMobility::Static);",
        "\tSetRootComponent(SceneOrigin);",
        f'\tGroundPlane = CreateMesh(TEXT("Ground"), {cube});',
        f'\tVehicleGroundPlane = CreateMesh(TEXT("VehicleGround"), {cube});',
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


def _construction(plan: ScenePlan) -> str:
    lines = [f"\tConfigureBody({b.member}, {b.settings});" for b in plan.bodies]
    lines += [f"\tConfigureWheel({w.member}, {w.settings});" for _, w in plan.wheels]
    calls = "\n".join(lines)
    return f"""
void A@CLASS@::OnConstruction(const FTransform& Transform)
{{
	Super::OnConstruction(Transform);
	ConfigureGround(GroundPlane, false);
	ConfigureGround(VehicleGroundPlane, true);
{calls}
}}
"""


def _collect(plan: ScenePlan, shapes: dict[str, int]) -> str:
    bodies = "\n".join(
        f"\tBodies.Add(FBodyRef{{ {b.member}, &{b.settings}, {shapes[b.asset.path]} }});"
        for b in plan.bodies
    )
    lines: list[str] = []
    for i, p in enumerate(plan.primitives):
        if p.kind == "DriveJoint":
            continue
        lines.append(f"\tCommands[{i}].Body = {p.body};")
        if (plan.brakes or plan.tyres) and p.kind in ("HoldVelocity", "GuideAlong"):
            lines.append(f"\tCommands[{i}].bDrives = true;")
        if p.until:
            lines.append(f"\tCommands[{i}].EndsAtTouchOf = {{ {', '.join(p.until)} }};")
    for i, e in enumerate(plan.events):
        lines.append(f"\tEvents[{i}].Id = {names.string_literal(e.id)};")
        lines.append(f"\tEvents[{i}].First = {{ {', '.join(e.first)} }};")
        lines.append(f"\tEvents[{i}].Second = {{ {', '.join(e.second)} }};")
        if e.after:
            lines.append(f"\tEvents[{i}].After = {{ {', '.join(str(a) for a in e.after)} }};")
    body = "\n".join(lines)
    return f"""
void A@CLASS@::CollectBodies()
{{
	Bodies.Reset();
{bodies}
}}

void A@CLASS@::CollectEvents()
{{
	Commands.Reset();
	Commands.SetNum({len(plan.primitives)});
	Events.Reset();
	Events.SetNum({len(plan.events)});
{body}
}}
"""


def _dispatch(plan: ScenePlan) -> str:
    calls = "\n".join(
        f"\tRun{p.kind}({p.body}, {p.member}, Commands[{i}], Due);"
        for i, p in enumerate(plan.primitives)
    )
    if plan.brakes or plan.tyres:
        calls = f"\tFindFalling(Due);\n{calls}\n\tApplyTraction(Due);".replace("\n\n", "\n")
    due = (
        "" if calls else "\t// The program is empty: nothing is driven.\n\tstatic_cast<void>(Due);"
    )
    return f"""
void A@CLASS@::DispatchProgram(double Due)
{{
{calls or due}
}}
"""
