"""Text of the emitted header."""

from __future__ import annotations

from dataclasses import dataclass

from esg.compile import frames, joints
from esg.compile.model import ScenePlan, UnrealBody


@dataclass(frozen=True)
class Field:
    """One editable property.

    Args:
        type, name, default: As written in C++.
        text: Tooltip, one line.
        units: One of Unreal's own unit names ("" where it has none for the quantity).
        low, high: Range ("" for open).
    """

    type: str
    name: str
    default: str
    text: str
    units: str = ""
    low: str = ""
    high: str = ""

    def emit(self, category: str) -> str:
        """The property with its UPROPERTY line, indented one tab."""
        meta = [f'Units = "{self.units}"'] if self.units else []
        meta += [f'ClampMin = "{self.low}"'] if self.low else []
        meta += [f'ClampMax = "{self.high}"'] if self.high else []
        extra = f", meta = ({', '.join(meta)})" if meta else ""
        return (
            f"\t/** {self.text} */\n"
            f'\tUPROPERTY(EditAnywhere, Category = "{category}"{extra})\n'
            f"\t{self.type} {self.name} = {self.default};\n"
        )


_ZERO, _IDENTITY = "FVector::ZeroVector", "FQuat::Identity"

BODY_FIELDS = (
    Field("FVector", "Location", _ZERO, "Of the mesh's origin, its bottom centre [cm]."),
    Field("FQuat", "Rotation", _IDENTITY, "Of the mesh."),
    Field("bool", "bSimulated", "true", "Moves; otherwise fixed in the world."),
    Field("bool", "bCollides", "true", "Has collision; otherwise a decal."),
    Field("bool", "bOnWheels", "false", "Coasts on the vehicle ground instead of the ground."),
    Field("bool", "bReportsHits", "false", "Some watched contact or drive asks for its hits."),
    Field("float", "Mass", "1.0f", "Mass.", "kg", "0.000001", "10000000"),
    Field("FVector", "CenterOfMass", _ZERO, "In the mesh's frame [cm]."),
    Field("FQuat", "PrincipalAxes", _IDENTITY, "Axes of inertia in the mesh's frame."),
    Field("FVector", "Inertia", "FVector::OneVector", "Principal moments [kg cm^2]."),
    Field("float", "Friction", "0.5f", "Friction coefficient, static and dynamic.", "", "0", "4"),
    Field("float", "Restitution", "0.2f", "Coefficient of restitution.", "", "0", "1"),
    Field("float", "LinearDamping", "0.0f", "Per second.", "", "0", "1000"),
    Field("float", "AngularDamping", "0.0f", "Per second.", "", "0", "1000"),
)

WHEEL_FIELDS = (
    Field("FVector", "Axle", _ZERO, "In the frame of the body's mesh [cm]."),
    Field(
        "double", "Radius", "1.0", "A wheel turns by what its axle goes over this.", "cm", "0.01"
    ),
)

_TIME = Field("double", "Time", "0.0", "Since the scene started.", "s", "0", "3600")
_START = Field("double", "Start", "0.0", "Since the scene started.", "s", "0", "3600")
_END = Field("double", "End", "0.0", "Since the scene started.", "s", "0")

JOINT_FIELDS = (
    Field("FVector", "ChildAnchor", _ZERO, "In the frame of the child's mesh [cm]."),
    Field("FQuat", "ChildFrame", _IDENTITY, "There; X is the joint's axis."),
    Field("FVector", "ParentAnchor", _ZERO, "In that of the parent's mesh, or the world [cm]."),
    Field("FQuat", "ParentFrame", _IDENTITY, "There; the joint is at 0 where both coincide."),
    Field("bool", "bCollides", "false", "Whether the two bodies touch each other."),
    Field("bool", "bLower", "false", "Whether Lower holds."),
    Field("double", "Lower", "0.0", "Least position [deg or cm]."),
    Field("bool", "bUpper", "false", "Whether Upper holds."),
    Field("double", "Upper", "0.0", "Greatest; of a rope or spring its length [deg or cm]."),
    Field("double", "Stiffness", "0.0", "Towards 0 [kg/s^2 or kg cm^2/s^2].", "", "0"),
    Field("double", "Damping", "0.0", "Against its speed [kg/s or kg cm^2/s].", "", "0"),
    Field("double", "Friction", "0.0", "Holds and brakes [kg cm/s^2 or times cm].", "", "0"),
    Field("bool", "bMotor", "false", "Whether a motor drives it from the start on."),
    Field("double", "MotorSpeed", "0.0", "[deg/s or cm/s]; to a place, the greatest, 0: any."),
    Field("bool", "bMotorToPlace", "false", "Whether it drives to MotorPlace."),
    Field("double", "MotorPlace", "0.0", "Position that it drives to [deg or cm]."),
    Field("double", "MotorLimit", "0.0", "Greatest [kg cm/s^2 or times cm].", "", "0"),
    Field("bool", "bBreaks", "false", "Whether it breaks."),
    Field("double", "BreakImpulse", "0.0", "What it takes at most [kg cm/s].", "", "0"),
)
"""Of joints, in classes with them; positions are left-handed turns or ways along X."""

PRIMITIVE_FIELDS = {
    "SetVelocity": (
        _TIME,
        Field("FVector", "Velocity", _ZERO, "Of the centre of mass [cm/s]."),
        Field("bool", "bSetSpin", "false", "Whether Spin is set too."),
        Field("FVector", "Spin", _ZERO, "Angular velocity [deg/s]."),
    ),
    "ApplyImpulse": (
        _TIME,
        Field("FVector", "Impulse", _ZERO, "At the centre of mass [kg cm/s]."),
    ),
    "AdjustProperties": (
        _TIME,
        Field("bool", "bSetLinearDamping", "false", "Whether LinearDamping is set."),
        Field("float", "LinearDamping", "0.0f", "Per second.", "", "0", "1000"),
        Field("bool", "bSetAngularDamping", "false", "Whether AngularDamping is set."),
        Field("float", "AngularDamping", "0.0f", "Per second.", "", "0", "1000"),
        Field("bool", "bSetFriction", "false", "Whether Friction is set."),
        Field("float", "Friction", "0.0f", "Friction coefficient.", "", "0", "4"),
    ),
    "DriveJoint": (
        _TIME,
        Field("bool", "bDrives", "false", "Whether a motor drives it from then on."),
        Field("double", "Speed", "0.0", "[deg/s or cm/s]; to a place, the greatest, 0: any."),
        Field("bool", "bToPlace", "false", "Whether it drives to Place."),
        Field("double", "Place", "0.0", "Position that it drives to [deg or cm]."),
        Field("double", "Limit", "0.0", "Greatest [kg cm/s^2 or times cm].", "", "0"),
    ),
    "HoldVelocity": (
        _START,
        _END,
        Field("double", "Speed", "0.0", "At the start.", "cm/s", "-100000", "100000"),
        Field("double", "Heading", "0.0", "Yaw of the motion at the start.", "deg"),
        Field("double", "Acceleration", "0.0", "[cm/s^2], negative slows down."),
        Field("double", "MaxSpeed", "0.0", "Limit while speeding up.", "cm/s", "0"),
        Field("double", "TurnRate", "0.0", "Change of yaw [deg/s]."),
        Field("double", "RollRadius", "0.0", "Of a body that rolls, else 0.", "cm", "0", "10000"),
    ),
    "GuideAlong": (
        _START,
        _END,
        Field("double", "TurnRate", "0.0", "Change of yaw [deg/s]."),
        Field("TArray<double>", "Times", "{}", "Of the path's points since Start [s]."),
        Field("TArray<FVector>", "Points", "{}", "Of the centre of mass [cm]."),
        Field("TArray<FVector>", "Velocities", "{}", "Of the centre of mass there [cm/s]."),
    ),
    "HoldSpin": (
        _START,
        _END,
        Field("FVector", "Spin", _ZERO, "Angular velocity [deg/s]."),
    ),
}

FLIGHT_FIELDS = (
    Field("bool", "bFlies", "false", "Whether Climb is held against gravity."),
    Field("double", "Climb", "0.0", "Vertical velocity in the air.", "cm/s"),
)
"""Of holds, in classes with powered flight."""

TIME_FIELDS = (
    Field("bool", "bTakesTime", "false", "Whether it comes to its speed by and by."),
    Field("double", "Gains", "0.0", "How fast to a greater one [cm/s^2].", "", "0"),
    Field("double", "Loses", "0.0", "How fast to a lesser one [cm/s^2].", "", "0"),
)
"""Of holds, in classes in which one takes its time."""

BRAKE_FIELDS = (
    Field("bool", "bSetBraking", "false", "Whether Braking is set."),
    Field("double", "Braking", "0.0", "Deceleration by the brakes [cm/s^2].", "", "0", "100000"),
)
"""Of changes of properties, in classes with brakes."""

ROUND_FIELD = Field("bool", "bRolls", "false", "Round: braking slows its roll as well.")
"""Of bodies, in classes with brakes."""

TYRE_FIELDS = (
    Field("double", "TyreFriction", "0.0", "Against sliding sideways.", "", "0", "4"),
    Field("double", "TyreDrop", "0.0", "Of the tyres' push below the centre of mass.", "cm", "0"),
    Field("double", "Axle", "0.0", "From the centre of mass to each axle.", "cm", "0"),
    Field("double", "Lean", "0.0", "Mass over inertia [1/cm^2]: how it leans.", "", "0"),
    Field("double", "TyreFoot", "0.0", "Of the edge it falls over from its middle.", "cm", "0"),
    Field("double", "TipRate", "0.0", "How fast it then turns over it [deg/s].", "", "0"),
)
"""Of bodies, in classes with tyres."""

BREAK_FIELD = Field(
    "double", "BreakImpulse", "0.0", "It breaks at more [kg cm/s]; 0: never.", "", "0"
)
"""Of bodies, in classes with what breaks."""

PRIMITIVE_TEXT = {
    "SetVelocity": "Sets a velocity once.",
    "ApplyImpulse": "Applies an impulse once.",
    "AdjustProperties": "Changes damping or friction once.",
    "DriveJoint": "Drives a joint, or lets it go.",
    "HoldVelocity": "Drives a body until an end time or a touch.",
    "GuideAlong": "Moves a body along a path until it is let go, or touches.",
    "HoldSpin": "Keeps a body spinning until an end time or a touch.",
}


def simulation_fields(plan: ScenePlan) -> tuple[Field, ...]:
    """Scene-wide values and the acceptance limits of the paper's evaluation protocol."""
    f = frames.literal
    return (
        Field("bool", "bPinTimeStep", "true", "Run the game at FixedTimeStep."),
        Field("double", "FixedTimeStep", f(plan.time_step), "Step the scene was verified with.",
              "s", "0.0005", "0.05"),
        Field("float", "WorldGravityZ", frames.float_literal(plan.gravity_z),
              "[cm/s^2], negative is down.", "", "-100000", "0"),
        Field("float", "GroundFriction", frames.float_literal(plan.ground_friction),
              "Friction coefficient of the ground.", "", "0", "4"),
        Field("float", "GroundRestitution", frames.float_literal(plan.ground_restitution),
              "Restitution of both grounds.", "", "0", "1"),
        Field("float", "VehicleGroundFriction", frames.float_literal(plan.vehicle_ground_friction),
              "Friction coefficient of the ground that bodies on wheels touch.", "", "0", "4"),
        Field("double", "SceneDuration", f(plan.duration), "The scene is over after this.",
              "s", "0", "3600"),
    )  # fmt: skip


ACCEPTANCE_FIELDS = (
    Field("double", "MaxHitTime", "15.0", "A watched contact must begin by then.", "s", "0"),
    Field("double", "MaxHitPenetration", "5.0", "Deepest overlap at a hit.", "cm", "0"),
    Field("double", "MinHitImpulse", "10.0", "Accumulated normal impulse [kg cm/s].", "", "0"),
    Field("double", "ImpulseWindow", "0.05", "Over which a hit's impulse adds up.", "s", "0"),
    Field("double", "RecheckDelay", "0.2", "From a hit to its overlap check.", "s", "0"),
    Field("double", "MaxRestPenetration", "2.0", "Overlap allowed at the start and at the check.",
          "cm", "0"),
    Field("double", "MinEventGap", "0.1", "Between an event and the one before it.", "s", "0"),
)  # fmt: skip


def emit_header(plan: ScenePlan) -> str:
    """The .h file."""
    name = plan.name
    body = (*BODY_FIELDS, ROUND_FIELD) if plan.brakes else BODY_FIELDS
    body = (*body, *TYRE_FIELDS) if plan.tyres else body
    body = (*body, BREAK_FIELD) if plan.breaks else body
    parts = [_preamble(plan), _struct(f"F{name}Body", "Physical values of one body.", body)]
    if plan.wheels:
        parts.append(_struct(f"F{name}Wheel", "A wheel: a picture that turns.", WHEEL_FIELDS))
    if plan.joints:
        parts.append(_struct(f"F{name}Joint", "What joins two bodies.", JOINT_FIELDS))
    for kind in PRIMITIVE_FIELDS:
        if kind in plan.kinds:
            fields = PRIMITIVE_FIELDS[kind]
            if kind == "HoldVelocity" and plan.flies:
                fields = (*fields, *FLIGHT_FIELDS)
            if kind == "HoldVelocity" and plan.takes_time:
                fields = (*fields, *TIME_FIELDS)
            if kind == "AdjustProperties" and plan.brakes:
                fields = (*fields, *BRAKE_FIELDS)
            parts.append(_struct(f"F{name}{kind}", PRIMITIVE_TEXT[kind], fields))
    parts.append(_class(plan))
    return "\n".join(parts)


def _preamble(plan: ScenePlan) -> str:
    title = f" {plan.title}" if plan.title else ""
    return f"""// Dynamic scene{title}: bodies, control program and contact events.
// Units: cm, kg, s, degrees. Frame: Unreal's, left-handed, Z up. Place the actor at the origin.
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "{plan.name}.generated.h"

class UPhysicalMaterial;
{"class UPhysicsConstraintComponent;" + chr(10) if plan.joints else ""}class UPrimitiveComponent;
class USceneComponent;
class UStaticMeshComponent;
struct FHitResult;
"""


def _struct(name: str, text: str, fields: tuple[Field, ...]) -> str:
    body = "\n".join(f.emit("ESG") for f in fields)
    head = f"/** {text} */\nUSTRUCT(BlueprintType)\nstruct {name}"
    return f"{head}\n{{\n\tGENERATED_BODY()\n\n{body}}};\n"


_RECORDS_AND_PARTS = """\
	/** Progress of one command of the program. */
	struct FCommandState
	{
		bool bActive = false;
		bool bDone = false;
@DRIVES@		UPrimitiveComponent* Body = nullptr;
		TArray<UPrimitiveComponent*> EndsAtTouchOf;
	};

	/** Two bodies in contact, on probation until their impulse is large enough. */
	struct FTouch
	{
		UPrimitiveComponent* First = nullptr;
		UPrimitiveComponent* Second = nullptr;
		double Time = 0.0;
		double Impulse = 0.0;
		double Penetration = 0.0;
	};

	/** A watched contact and how far it has come. */
	struct FWatchedEvent
	{
		FString Id;
		TArray<UPrimitiveComponent*> First;
		TArray<UPrimitiveComponent*> Second;
		TArray<int32> After;
		TArray<FTouch> Touches;
		FTouch Hit;
		bool bHit = false;
		bool bChecked = false;
		bool bComplete = false;
	};

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<USceneComponent> SceneOrigin;

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<UStaticMeshComponent> GroundPlane;

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<UStaticMeshComponent> VehicleGroundPlane;

	UPROPERTY(Transient)
	TArray<TObjectPtr<UPhysicalMaterial>> Materials;

	UFUNCTION()
	void OnBodyHit(
		UPrimitiveComponent* HitComponent, AActor* OtherActor, UPrimitiveComponent* OtherComp,
		FVector NormalImpulse, const FHitResult& Hit);

"""
"""What is the same in every class: records of the run, parts of the scene, the hit callback."""

_WHEELS = """\
	/** A wheel, how far it has turned and how fast it turns. */
	struct FTurningWheel
	{
		UStaticMeshComponent* Component = nullptr;
		UStaticMeshComponent* Body = nullptr;
		const F@CLASS@Wheel* Settings = nullptr;
		bool bStarted = false;
		FVector Axle = FVector::ZeroVector;
		FVector Ahead = FVector::ZeroVector;
		double Rise = 0.0;
		double Rate = 0.0;
		double Angle = 0.0;
	};

	UStaticMeshComponent* CreateWheel(
		UStaticMeshComponent* Body, const TCHAR* Name, const TCHAR* AssetPath);
	void ConfigureWheel(UStaticMeshComponent* Wheel, const F@CLASS@Wheel& Settings);
	void CollectWheels();
	void TurnWheels(double Step);
	TArray<FTurningWheel> Wheels;

"""
"""What classes with wheels declare besides."""

_WATCHING = """\
	void EndDrivesAtTouch(const UPrimitiveComponent* First, const UPrimitiveComponent* Second);
	void WatchTouch(FWatchedEvent& Event, const FTouch& Touch);
	void RecheckEvents();
	void CheckLayout();
	double PenetrationOf(const FBodyRef& First, const FBodyRef& Second) const;
	const FBodyRef* FindBody(const UPrimitiveComponent* Component) const;

	TArray<FBodyRef> Bodies;
	TArray<FCommandState> Commands;
	TArray<FWatchedEvent> Events;
	double SceneTime = 0.0;
	bool bFinished = false;
};
"""
"""The class from its watching of contacts to its end, the same for every scene."""


DRIVES = "\t\tbool bDrives = false;\n"
GROUNDED = """\
		double Braking = 0.0;
		/** Velocity at the beginning of the last step; so low before the first one. */
		FVector Before = FVector(0.0, 0.0, -1.0e9);
		bool bFalls = false;
		bool bTips = false;
"""
"""Of commands and bodies, in classes with brakes or tyres."""


_BREAKING = """\
	/** A body that breaks, and its fragments with where they lie in it. */
	struct FBrittle
	{
		FBodyRef* Whole = nullptr;
		TArray<FBodyRef*> Pieces;
		TArray<FVector> Centers;
		TArray<FQuat> Turns;
		TArray<UPrimitiveComponent*> Touched;
		TArray<double> Taken;
		double Step = 0.0;
		bool bBroken = false;
	};

	void CollectFragments();
	void AddBrittle(int32 Whole, const TArray<int32>& Pieces);
	void TakeBlow(const UPrimitiveComponent* Body, UPrimitiveComponent* Other, double Impulse);
	void BreakBodies(double Step);
	void Shatter(FBrittle& Brittle, double Share, double Step);
	void TakeBack(FBodyRef& Body, double Share, double Step) const;
	void RememberSpeeds();
	static void PutAway(UStaticMeshComponent* Body, bool bSimulated);
	TArray<FBrittle> Brittles;

"""
"""What classes with what breaks declare besides."""
_REMEMBERED = """\
		/** Velocities at the beginning of the last step. */
		FVector LastVelocity = FVector::ZeroVector;
		FVector LastSpin = FVector::ZeroVector;
"""
"""Of bodies, in classes with what breaks."""


def _class(plan: ScenePlan) -> str:
    name = plan.name
    simulation = "\n".join(f.emit("ESG|Simulation") for f in simulation_fields(plan))
    acceptance = "\n".join(f.emit("ESG|Acceptance") for f in ACCEPTANCE_FIELDS)
    bodies = "\n".join(_body_members(plan, b) for b in plan.bodies)
    bodies += "\n" + joints.members_of(plan.joints, name) if plan.joints else ""
    program = "\n".join(
        f'\tUPROPERTY(EditAnywhere, Category = "ESG|Program")\n\tF{name}{p.kind} {p.member};\n'
        for p in plan.primitives
    )
    grounded = plan.brakes or plan.tyres
    records = _RECORDS_AND_PARTS.replace("@DRIVES@", DRIVES if grounded else "")
    return f"""UCLASS()
class ESGSCENES_API A{name} : public AActor
{{
	GENERATED_BODY()

public:
	A{name}();
	virtual void OnConstruction(const FTransform& Transform) override;
	virtual void Tick(float DeltaTime) override;

{simulation}
{acceptance}
{bodies}
{program}
protected:
	virtual void BeginPlay() override;

private:
	/** A component together with its settings. */
	struct FBodyRef
	{{
		UStaticMeshComponent* Component = nullptr;
		const F{name}Body* Settings = nullptr;
		int32 Shape = 0;
{GROUNDED if grounded else ""}{_REMEMBERED if plan.breaks else ""}	}};

{records}	UStaticMeshComponent* CreateMesh(const TCHAR* Name, const TCHAR* AssetPath);
	void ConfigureGround(UStaticMeshComponent* Plane, bool bForWheels);
	void ConfigureBody(UStaticMeshComponent* Body, const F{name}Body& Settings);
	void ApplyMassProperties(UStaticMeshComponent* Body, const F{name}Body& Settings);
	UPhysicalMaterial* CreateMaterial(float Friction, float Restitution);
	void CollectBodies();
	void CollectEvents();
	void PinSimulation();
	void DispatchProgram(double Due);
{_joining(plan)}{_breaking(plan)}{_runners(plan)}{_turning(plan)}{_WATCHING}"""


def _joining(plan: ScenePlan) -> str:
    return joints.DECLARATIONS.replace("@CLASS@", plan.name) if plan.joints else ""


def _breaking(plan: ScenePlan) -> str:
    return _BREAKING if plan.breaks else ""


def _turning(plan: ScenePlan) -> str:
    return _WHEELS.replace("@CLASS@", plan.name) if plan.wheels else ""


_GROUND = """\
	void FindFalling(double Due);
	void ApplyTraction(double Due);
	double ApplyBrakes(const FBodyRef& Body, double Loss);
	bool IsDriven(const UPrimitiveComponent* Body) const;
"""
_TYRES = """\
	void ApplyTyres(const FBodyRef& Body, double Weight, double Taken);
	void TipOver(FBodyRef& Body);
"""


def _runners(plan: ScenePlan) -> str:
    """Declarations of what plays the program's kinds of primitives."""
    path = f"\tstatic FVector PathPoint(const F{plan.name}GuideAlong& Command, double Elapsed);\n"
    return (
        "".join(
            f"\tvoid Run{kind}({_target(kind)}, const F{plan.name}{kind}& Command,"
            f" FCommandState& State, double Due);\n"
            for kind in PRIMITIVE_FIELDS
            if kind in plan.kinds
        )
        + (path if "GuideAlong" in plan.kinds else "")
        + (_GROUND if plan.brakes or plan.tyres else "")
        + (_TYRES if plan.tyres else "")
    )


def _target(kind: str) -> str:
    return "FJointRef& Joint" if kind == "DriveJoint" else "UPrimitiveComponent* Body"


def _body_members(plan: ScenePlan, body: UnrealBody) -> str:
    return (
        f'\tUPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")\n'
        f"\tTObjectPtr<UStaticMeshComponent> {body.member};\n\n"
        f'\tUPROPERTY(EditAnywhere, Category = "ESG|Bodies")\n'
        f"\tF{plan.name}Body {body.settings};\n"
    ) + "".join(
        f'\n\tUPROPERTY(VisibleAnywhere, Category = "ESG|Wheels")\n'
        f"\tTObjectPtr<UStaticMeshComponent> {wheel.member};\n\n"
        f'\tUPROPERTY(EditAnywhere, Category = "ESG|Wheels")\n'
        f"\tF{plan.name}Wheel {wheel.settings};\n"
        for wheel in body.wheels
    )
