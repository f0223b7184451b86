#include "EsgScene.h"

#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/EngineTypes.h"
#include "Engine/StaticMesh.h"
#include "Engine/World.h"
#include "GameFramework/WorldSettings.h"
#include "Misc/App.h"
#include "PhysicalMaterials/PhysicalMaterial.h"
#include "Physics/PhysicsInterfaceCore.h"
#include "PhysicsEngine/BodyInstance.h"
#include "PhysicsEngine/ConstraintInstance.h"
#include "PhysicsEngine/PhysicsConstraintComponent.h"
#include "UObject/ConstructorHelpers.h"

DEFINE_LOG_CATEGORY_STATIC(LogEsgScene, Log, All);

namespace EsgSceneDetail
{
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

	/** How fast a guided body that is off its path returns to it [1/s]. */
	constexpr double GuideRate = 10.0;

	/** Of the cubic that leads from one point of a path to the next. */
	constexpr double CubicSlope = 3.0;

	/** What loses more than this share of a step's gravity within it, nothing carries. */
	constexpr double FallingShare = 0.5;

	/** Of the tilt up to which a body stands on its wheels. */
	constexpr double UprightCosine = 0.707106781186548;

	/** Change of velocity [cm/s] that costs a two-wheeler its balance; it leans on [deg/s]. */
	constexpr double Blow = 100.0;
	constexpr double LeastTilt = 0.001;
	constexpr double LeastLean = 2.86478897565412;

	/** A body whose up axis rises less than this does not stand on its wheels. */
	constexpr double Upright = 0.5;

	/** What gains this share of gravity's speed downwards is carried by nothing. */
	constexpr double Falls = 0.5;

	/** In which a wheel that touches nothing runs down [s]. */
	constexpr double RunsDown = 2.0;

	/** Where a joint with a limit on one side stops on the other [deg, cm]. */
	constexpr double FarTurn = 179.0;
	constexpr double FarSlide = 10000.0;

	/** Unreal tells spins in full turns [deg]. */
	constexpr double FullTurn = 360.0;

	/** A drive that its limit alone holds back, and a limit that holds nothing back. */
	constexpr float RigidDrive = 1000000000000.0f;
	constexpr float Unlimited = 1000000000.0f;

	/** A motor nears a place at no more than this times the way that is left [1/s]. */
	constexpr double ApproachRate = 10.0;

	/** What a joint takes within this adds up [s]. */
	constexpr double BreakWindow = 0.0166666666666667;

	/** A spring that is shorter has no direction [cm]. */
	constexpr double LeastLength = 1.0e-7;
}

AEsgScene::AEsgScene()
{
	PrimaryActorTick.bCanEverTick = true;
	PrimaryActorTick.TickGroup = TG_PrePhysics;

	SceneOrigin = CreateDefaultSubobject<USceneComponent>(TEXT("SceneRoot"));
	SceneOrigin->SetMobility(EComponentMobility::Static);
	SetRootComponent(SceneOrigin);
	GroundPlane = CreateMesh(TEXT("Ground"), TEXT("/Engine/BasicShapes/Cube.Cube"));
	VehicleGroundPlane = CreateMesh(TEXT("VehicleGround"), TEXT("/Engine/BasicShapes/Cube.Cube"));
}

AEsgScene::~AEsgScene() = default;

void AEsgScene::CollectBodies() {}

void AEsgScene::CollectProgram() {}

void AEsgScene::DispatchProgram(double) {}

void AEsgScene::OnConstruction(const FTransform& Transform)
{
	Super::OnConstruction(Transform);
	ConfigureGround(GroundPlane, false);
	ConfigureGround(VehicleGroundPlane, true);
	Collect();
	for (const FBodyRef& Body : Bodies)
	{
		ConfigureBody(Body.Component, *Body.Settings);
	}
	for (const FTurningWheel& Wheel : Wheels)
	{
		ConfigureWheel(Wheel.Component, *Wheel.Settings);
	}
}

void AEsgScene::Collect()
{
	Bodies.Reset();
	Wheels.Reset();
	Joints.Reset();
	Brittles.Reset();
	Stances.Reset();
	Commands.Reset();
	Events.Reset();
	CollectBodies();
	CollectProgram();
}

void AEsgScene::AddBody(UStaticMeshComponent* Component, const FEsgBody& Settings, int32 Like)
{
	Bodies.Add(FBodyRef{ Component, &Settings, Like == INDEX_NONE ? Bodies.Num() : Like });
}

void AEsgScene::AddProbe(const FCollisionShape& Shape, const FVector& Center, const FQuat& Rotation)
{
	Bodies.Last().Probes.Add(FProbe{ Shape, Center, Rotation });
}

void AEsgScene::AddWheel(
	UStaticMeshComponent* Component, UStaticMeshComponent* Body, const FEsgWheel& Settings)
{
	Wheels.Add(FTurningWheel{ Component, Body, &Settings });
}

void AEsgScene::AddJoint(
	EJointKind Kind, const FEsgJoint& Settings, UPhysicsConstraintComponent* Constraint,
	UPhysicsConstraintComponent* Return, UPrimitiveComponent* Child, UPrimitiveComponent* Parent)
{
	Joints.Add(FJointRef{ Constraint, Return, Child, Parent, &Settings, Kind });
}

void AEsgScene::AddBrittle(int32 Whole, const TArray<int32>& Pieces)
{
	Brittles.Add(FBrittle{ Whole, Pieces });
}

void AEsgScene::AddStance(int32 Body, const TArray<int32>& Postures)
{
	FStance Stance;
	Stance.Bodies.Add(Body);
	for (const int32 Index : Postures)
	{
		Stance.Bodies.Add(Index);
	}
	Stances.Add(Stance);
}

void AEsgScene::AddCommand(UPrimitiveComponent* Body, const TArray<UPrimitiveComponent*>& EndsAtTouchOf)
{
	Commands.Add(FCommandState{ Body, EndsAtTouchOf });
}

void AEsgScene::AddEvent(
	const TCHAR* Id, const TArray<UPrimitiveComponent*>& First, const TArray<UPrimitiveComponent*>& Second,
	const TArray<int32>& After)
{
	Events.Add(FWatchedEvent{ Id, First, Second, After });
}

void AEsgScene::RunSetVelocity(
	UPrimitiveComponent* Body, const FEsgSetVelocity& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	Body->SetPhysicsLinearVelocity(Command.Velocity);
	if (Command.bSetSpin)
	{
		Body->SetPhysicsAngularVelocityInDegrees(Command.Spin);
	}
	UE_LOG(LogEsgScene, Display, TEXT("COMMAND SetVelocity body=%s t=%.4f"), *Body->GetName(), SceneTime);
}

void AEsgScene::RunApplyImpulse(
	UPrimitiveComponent* Body, const FEsgApplyImpulse& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	Body->AddImpulse(Command.Impulse, NAME_None, false);
	UE_LOG(LogEsgScene, Display, TEXT("COMMAND ApplyImpulse body=%s t=%.4f"), *Body->GetName(), SceneTime);
}

void AEsgScene::RunAdjustProperties(
	UPrimitiveComponent* Body, const FEsgAdjustProperties& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	if (Command.bSetLinearDamping)
	{
		Body->SetLinearDamping(Command.LinearDamping);
	}
	if (Command.bSetAngularDamping)
	{
		Body->SetAngularDamping(Command.AngularDamping);
	}
	const FBodyRef* Known = FindBody(Body);
	if (Command.bSetFriction && Known)
	{
		Body->SetPhysMaterialOverride(CreateMaterial(Command.Friction, Known->Settings->Restitution));
	}
	if (Command.bSetBraking)
	{
		for (FBodyRef& Braked : Bodies)
		{
			Braked.Braking = Braked.Component == Body ? Command.Braking : Braked.Braking;
		}
	}
	UE_LOG(
		LogEsgScene, Display, TEXT("COMMAND AdjustProperties body=%s t=%.4f"), *Body->GetName(), SceneTime);
}

void AEsgScene::RunChangeBody(
	UPrimitiveComponent* Body, const FEsgChangeBody& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	for (FStance& Stance : Stances)
	{
		int32 Next = Stance.Bodies.Num() - 1;
		while (Next >= 0 && Stance.Bodies[Next] != Command.Into)
		{
			--Next;
		}
		if (Bodies[Stance.Bodies[0]].Component != Body || Next < 0 || Next == Stance.Now)
		{
			continue;
		}
		FBodyRef& Before = Bodies[Stance.Bodies[Stance.Now]];
		const FTransform Pose = Before.Component->GetComponentTransform();
		FQuat Turn = Pose.GetRotation() * Stance.Turns[Stance.Now].Inverse();
		FVector Place = Pose.GetLocation() - Turn.RotateVector(Stance.Places[Stance.Now]);
		FVector Velocity = Before.Component->GetPhysicsLinearVelocity();
		FVector Spin = Before.Component->GetPhysicsAngularVelocityInDegrees();
		if (Command.bPlaced)
		{
			Place = Command.Place;
			Turn = Command.Facing;
			Velocity = FVector::ZeroVector;
			Spin = FVector::ZeroVector;
		}
		PutAway(Before.Component, true);
		FBodyRef& After = Bodies[Command.Into];
		PutIn(After, Place + Turn.RotateVector(Stance.Places[Next]), Turn * Stance.Turns[Next]);
		After.Component->SetPhysicsLinearVelocity(Velocity);
		After.Component->SetPhysicsAngularVelocityInDegrees(Spin);
		Stance.Now = Next;
		UE_LOG(
			LogEsgScene, Display, TEXT("COMMAND ChangeBody body=%s into=%s t=%.4f"), *Body->GetName(),
			*After.Component->GetName(), SceneTime);
	}
}

void AEsgScene::RunDriveJoint(
	FJointRef& Joint, const FEsgDriveJoint& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	Joint.bMotor = Command.bDrives;
	Joint.bToPlace = Command.bToPlace;
	Joint.Speed = Command.Speed;
	Joint.Place = Command.Place;
	Joint.Limit = Command.Limit;
	UE_LOG(
		LogEsgScene, Display, TEXT("COMMAND DriveJoint joint=%s t=%.4f"), *Joint.Constraint->GetName(),
		SceneTime);
}

void AEsgScene::RunHoldVelocity(
	UPrimitiveComponent* Body, const FEsgHoldVelocity& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		UE_LOG(
			LogEsgScene, Display, TEXT("COMMAND HoldVelocity ends body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
		return;
	}
	if (!State.bActive)
	{
		State.bActive = true;
		State.bDrives = true;
		State.Kind = TEXT("HoldVelocity");
		UE_LOG(
			LogEsgScene, Display, TEXT("COMMAND HoldVelocity starts body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
	}
	const double Elapsed = SceneTime - Command.Start;
	double Speed = FMath::Max(0.0, Command.Speed + Command.Acceleration * Elapsed);
	if (Command.Acceleration > 0.0)
	{
		Speed = FMath::Min(Speed, Command.MaxSpeed);
	}
	const double Heading = FMath::DegreesToRadians(Command.Heading + Command.TurnRate * Elapsed);
	FVector Velocity(Speed * FMath::Cos(Heading), Speed * FMath::Sin(Heading), 0.0);
	if (Command.bTakesTime)
	{
		const double Step = (Due - SceneTime) / EsgSceneDetail::HalfStep;
		const double Gains = Command.Gains * Step;
		const double Loses = Command.Loses * Step;
		const FVector Ahead(FMath::Cos(Heading), FMath::Sin(Heading), 0.0);
		const FVector Aside(-Ahead.Y, Ahead.X, 0.0);
		const double Turned = Heading - FMath::DegreesToRadians(Command.TurnRate) * Step;
		const FVector Had = Body->GetPhysicsLinearVelocity();
		double Along = FMath::Cos(Turned) * Had.X + FMath::Sin(Turned) * Had.Y;
		double Across = FMath::Cos(Turned) * Had.Y - FMath::Sin(Turned) * Had.X;
		Along += FMath::Clamp(Speed - Along, -Loses, Gains);
		Across -= FMath::Clamp(Across, -Loses, Loses);
		Velocity = Ahead * Along + Aside * Across;
	}
	// Rolling without slipping, or turning on the spot about the vertical.
	const FVector Spin = Command.RollRadius > 0.0 && !Command.bFlies
		? FVector(-Velocity.Y, Velocity.X, 0.0) * FMath::RadiansToDegrees(1.0 / Command.RollRadius)
		: FVector(0.0, 0.0, Command.TurnRate);
	if (Command.bFlies)
	{
		// The gravity of this step is still to act on it.
		const double Step = (Due - SceneTime) / EsgSceneDetail::HalfStep;
		Velocity.Z = Command.Climb - WorldGravityZ * Step;
	}
	else
	{
		Velocity.Z = Body->GetPhysicsLinearVelocity().Z;
	}
	Body->SetPhysicsLinearVelocity(Velocity);
	Body->SetPhysicsAngularVelocityInDegrees(Spin);
}

void AEsgScene::RunGuideAlong(
	UPrimitiveComponent* Body, const FEsgGuideAlong& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		UE_LOG(
			LogEsgScene, Display, TEXT("COMMAND GuideAlong ends body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
		return;
	}
	if (!State.bActive)
	{
		State.bActive = true;
		State.bDrives = true;
		State.Kind = TEXT("GuideAlong");
		UE_LOG(
			LogEsgScene, Display, TEXT("COMMAND GuideAlong starts body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
	}
	using namespace EsgSceneDetail;
	const double Step = (Due - SceneTime) / HalfStep;
	const double Elapsed = SceneTime - Command.Start;
	const FVector Here = PathPoint(Command, Elapsed);
	FVector Velocity = (PathPoint(Command, Elapsed + Step) - Here) * (1.0 / Step);
	Velocity = Velocity + (Here - Body->GetCenterOfMass()) * GuideRate;
	// The gravity of this step is still to act on it.
	Velocity.Z -= WorldGravityZ * Step;
	Body->SetPhysicsLinearVelocity(Velocity);
	Body->SetPhysicsAngularVelocityInDegrees(FVector(0.0, 0.0, Command.TurnRate));
}

FVector AEsgScene::PathPoint(const FEsgGuideAlong& Command, double Elapsed)
{
	using namespace EsgSceneDetail;
	int32 Index = 0;
	while (Index + 1 < Command.Times.Num() && Command.Times[Index + 1] < Elapsed)
	{
		++Index;
	}
	const FVector Point = Command.Points[Index];
	const FVector Velocity = Command.Velocities[Index];
	const double Late = Elapsed - Command.Times[Index];
	if (Late < 0.0 || Index + 1 == Command.Times.Num())
	{
		return Point + Velocity * Late;
	}
	const double Span = Command.Times[Index + 1] - Command.Times[Index];
	const double Share = Late / Span;
	const double Gone = Share * Share * (CubicSlope - 2.0 * Share);
	const double Bulge = Span * Share * (1.0 - Share);
	const FVector Bend = Velocity * (1.0 - Share) - Command.Velocities[Index + 1] * Share;
	return Point + (Command.Points[Index + 1] - Point) * Gone + Bend * Bulge;
}

void AEsgScene::RunHoldSpin(
	UPrimitiveComponent* Body, const FEsgHoldSpin& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		UE_LOG(
			LogEsgScene, Display, TEXT("COMMAND HoldSpin ends body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
		return;
	}
	if (!State.bActive)
	{
		State.bActive = true;
		State.Kind = TEXT("HoldSpin");
		UE_LOG(
			LogEsgScene, Display, TEXT("COMMAND HoldSpin starts body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
	}
	Body->SetPhysicsAngularVelocityInDegrees(Command.Spin);
}

void AEsgScene::RunBuoyUp(
	UPrimitiveComponent* Body, const FEsgBuoyUp& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		return;
	}
	using namespace EsgSceneDetail;
	const double Step = (Due - SceneTime) / HalfStep;
	const double Heading = FMath::DegreesToRadians(Command.Heading);
	const FVector Off = Body->GetCenterOfMass() - Command.Center;
	const double Along = FMath::Cos(Heading) * Off.X + FMath::Sin(Heading) * Off.Y;
	const double Across = FMath::Cos(Heading) * Off.Y - FMath::Sin(Heading) * Off.X;
	const FQuat Turn = Body->GetComponentTransform().GetRotation();
	const FVector Up = Turn.Inverse().RotateVector(FVector(0.0, 0.0, 1.0));
	const double Half = FMath::Abs(Up.X) * Command.Extents.X + FMath::Abs(Up.Y) * Command.Extents.Y
		+ FMath::Abs(Up.Z) * Command.Extents.Z;
	double Share = FMath::Min(1.0, HalfStep * (Half - Off.Z) / Half);
	const bool bBeside = FMath::Abs(Along) > Command.Basin.X || FMath::Abs(Across) > Command.Basin.Y;
	if (bBeside || Share <= 0.0 || Off.Z < -2.0 * Command.Basin.Z)
	{
		return;
	}
	if (Command.bRound)
	{
		Share = Share * Share * (CubicSlope - 2.0 * Share);
	}
	const double Wet = Share * Step;
	FVector Velocity = Body->GetPhysicsLinearVelocity();
	const double Drag = Command.LinearDrag + Command.QuadraticDrag * Velocity.Size();
	Velocity = Velocity * (1.0 / (1.0 + Wet * Drag));
	Velocity.Z += Wet * Command.Lift;
	const FVector Spin = Body->GetPhysicsAngularVelocityInDegrees();
	Body->SetPhysicsLinearVelocity(Velocity);
	Body->SetPhysicsAngularVelocityInDegrees(Spin * (1.0 / (1.0 + Wet * Command.TurningDrag)));
}

void AEsgScene::FindFalling(double Due)
{
	using namespace EsgSceneDetail;
	const double Step = (Due - SceneTime) / HalfStep;
	for (FBodyRef& Body : Bodies)
	{
		if (!Body.Settings->bSimulated || !Body.Component->IsSimulatingPhysics())
		{
			continue;
		}
		FVector Lost = Body.Before - Body.Component->GetPhysicsLinearVelocity();
		Body.bFalls = Lost.Z > -FallingShare * WorldGravityZ * Step;
		Lost.Z = 0.0;
		Body.bTips |= Body.Settings->TyreDrop > 0.0 && Lost.Size() > Blow;
	}
}

void AEsgScene::ApplyTraction(double Due)
{
	const double Step = (Due - SceneTime) / EsgSceneDetail::HalfStep;
	for (FBodyRef& Body : Bodies)
	{
		if (!Body.Settings->bSimulated || !Body.Component->IsSimulatingPhysics())
		{
			continue;
		}
		Body.Before = Body.Component->GetPhysicsLinearVelocity();
		if (IsDriven(Body.Component))
		{
			Body.bTips = false;
			continue;
		}
		if (Body.bFalls)
		{
			continue;
		}
		const double Taken = ApplyBrakes(Body, Body.Braking * Step);
		ApplyTyres(Body, -WorldGravityZ * Step, Taken);
		TipOver(Body);
		Body.Before = Body.Component->GetPhysicsLinearVelocity();
	}
}

double AEsgScene::ApplyBrakes(const FBodyRef& Body, double Loss)
{
	const FVector Velocity = Body.Component->GetPhysicsLinearVelocity();
	FVector Level(Velocity.X, Velocity.Y, 0.0);
	const FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
	const double Up = Turn.RotateVector(FVector(0.0, 0.0, 1.0)).Z;
	if (Body.Settings->TyreDrop > 0.0 && Up > EsgSceneDetail::UprightCosine)
	{
		// Its brakes leave to its tyres what it leans to the side with.
		FVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
		Ahead.Z = 0.0;
		Ahead = Ahead * (1.0 / Ahead.Size());
		Level = Ahead * FVector::DotProduct(Ahead, Level);
	}
	const double Speed = Level.Size();
	const double Taken = FMath::Min(Loss, Speed);
	if (Taken <= 0.0)
	{
		return 0.0;
	}
	const double Lost = Taken / Speed;
	Body.Component->SetPhysicsLinearVelocity(Velocity - Level * Lost);
	if (Body.Settings->bRolls)
	{
		FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
		Spin.X *= 1.0 - Lost;
		Spin.Y *= 1.0 - Lost;
		Body.Component->SetPhysicsAngularVelocityInDegrees(Spin);
	}
	return Taken;
}

bool AEsgScene::IsDriven(const UPrimitiveComponent* Body) const
{
	for (const FCommandState& State : Commands)
	{
		if (State.bDrives && State.bActive && !State.bDone && State.Body == Body)
		{
			return true;
		}
	}
	return false;
}

void AEsgScene::ApplyTyres(const FBodyRef& Body, double Weight, double Taken)
{
	const FEsgBody& Settings = *Body.Settings;
	const FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
	const double Grip = Settings.TyreFriction * Weight;
	const FVector Up = Turn.RotateVector(FVector(0.0, 0.0, 1.0));
	if (Grip <= Taken || Up.Z <= EsgSceneDetail::UprightCosine)
	{
		return;
	}
	// What the brakes have taken, the tyres cannot give to the side.
	const double Limit = FMath::Sqrt(Grip * Grip - Taken * Taken);
	FVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
	Ahead.Z = 0.0;
	Ahead = Ahead * (1.0 / Ahead.Size());
	const FVector Side(-Ahead.Y, Ahead.X, 0.0);
	const FVector Velocity = Body.Component->GetPhysicsLinearVelocity();
	const double Radian = FMath::RadiansToDegrees(1.0);
	const FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees() * (1.0 / Radian);
	// Of the centre of mass over the edge that what leans stands on.
	const double Tilt = FMath::Abs(FVector::DotProduct(Side, Up));
	const double Height = Settings.TyreDrop * Up.Z + Settings.TyreFoot * Tilt;
	const double Given = 1.0 + Height * Height * Settings.Lean;
	const double Rolling = Height * FVector::DotProduct(Ahead, Spin);
	const double Slip = (FVector::DotProduct(Side, Velocity) + Rolling) / Given;
	const double Yaw = Settings.Axle * Spin.Z;
	const double Front = FMath::Clamp(Slip + Yaw, -Limit, Limit);
	const double Rear = FMath::Clamp(Slip - Yaw, -Limit, Limit);
	const double Mean = (Front + Rear) * EsgSceneDetail::HalfStep;
	const double Back = (Front - Rear) * EsgSceneDetail::HalfStep / Settings.Axle;
	const FVector Left = Ahead * (Height * Settings.Lean * Mean) + FVector(0.0, 0.0, Back);
	Body.Component->SetPhysicsLinearVelocity(Velocity - Side * Mean);
	Body.Component->SetPhysicsAngularVelocityInDegrees((Spin - Left) * Radian);
}

void AEsgScene::TipOver(FBodyRef& Body)
{
	using namespace EsgSceneDetail;
	if (!Body.bTips)
	{
		return;
	}
	Body.bTips = false;
	const FEsgBody& Settings = *Body.Settings;
	const FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
	const FVector Up = Turn.RotateVector(FVector(0.0, 0.0, 1.0));
	FVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
	Ahead.Z = 0.0;
	Ahead = Ahead * (1.0 / Ahead.Size());
	const FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
	// Seen from above Unreal's axes are mirrored: positive leans to the left.
	const double Lean = FVector::DotProduct(Ahead, Spin);
	if (Up.Z <= UprightCosine || FMath::Abs(Lean) >= Settings.TipRate)
	{
		return;
	}
	const double Left = Ahead.Y * Up.X - Ahead.X * Up.Y;
	const bool bLeft = FMath::Abs(Lean) > LeastLean ? Lean > 0.0 : Left > LeastTilt;
	const double More = (bLeft ? Settings.TipRate : -Settings.TipRate) - Lean;
	// It turns about the edge of its foot.
	const double Foot = bLeft ? Settings.TyreFoot : -Settings.TyreFoot;
	const FVector Arm = Turn.RotateVector(FVector(0.0, Foot, Settings.TyreDrop));
	const FVector Moved = FVector::CrossProduct(Ahead, Arm) * FMath::DegreesToRadians(More);
	Body.Component->SetPhysicsLinearVelocity(Body.Component->GetPhysicsLinearVelocity() + Moved);
	Body.Component->SetPhysicsAngularVelocityInDegrees(Spin + Ahead * More);
}

UStaticMeshComponent* AEsgScene::CreateMesh(const TCHAR* Name, const TCHAR* AssetPath)
{
	UStaticMeshComponent* Component = CreateDefaultSubobject<UStaticMeshComponent>(Name);
	Component->SetupAttachment(SceneOrigin);
	const ConstructorHelpers::FObjectFinder<UStaticMesh> Asset(AssetPath);
	if (Asset.Succeeded())
	{
		Component->SetStaticMesh(Asset.Object);
	}
	else
	{
		UE_LOG(LogEsgScene, Error, TEXT("MISSING_ASSET body=%s path=%s"), Name, AssetPath);
	}
	return Component;
}

void AEsgScene::ConfigureGround(UStaticMeshComponent* Plane, bool bForWheels)
{
	using namespace EsgSceneDetail;
	const double Side = GroundSide / BasicCubeSide;
	const double Thickness = GroundThickness / BasicCubeSide;
	Plane->SetMobility(EComponentMobility::Static);
	Plane->SetRelativeLocationAndRotation(FVector(0.0, 0.0, -HalfStep * GroundThickness), FQuat::Identity);
	Plane->SetRelativeScale3D(FVector(Side, Side, Thickness));
	Plane->SetCollisionProfileName(TEXT("BlockAll"));
	Plane->SetCollisionEnabled(ECollisionEnabled::QueryAndPhysics);
	Plane->SetCollisionObjectType(ECC_WorldStatic);
	Plane->SetCollisionResponseToAllChannels(bForWheels ? ECR_Ignore : ECR_Block);
	Plane->SetCollisionResponseToChannel(ECC_Vehicle, bForWheels ? ECR_Block : ECR_Ignore);
	Plane->SetNotifyRigidBodyCollision(false);
	Plane->SetHiddenInGame(bForWheels);
	Plane->SetSimulatePhysics(false);
}

void AEsgScene::ConfigureBody(UStaticMeshComponent* Body, const FEsgBody& Settings)
{
	Body->SetMobility(Settings.bSimulated ? EComponentMobility::Movable : EComponentMobility::Static);
	Body->SetRelativeLocationAndRotation(Settings.Location, Settings.Rotation);
	Body->SetNotifyRigidBodyCollision(Settings.bReportsHits);
	if (!Settings.bCollides)
	{
		Body->SetCollisionProfileName(TEXT("NoCollision"));
		Body->SetSimulatePhysics(false);
		return;
	}
	const ECollisionChannel MovingType = Settings.bOnWheels ? ECC_Vehicle : ECC_PhysicsBody;
	Body->SetCollisionProfileName(Settings.bSimulated ? TEXT("PhysicsActor") : TEXT("BlockAll"));
	Body->SetCollisionEnabled(ECollisionEnabled::QueryAndPhysics);
	Body->SetCollisionObjectType(Settings.bSimulated ? MovingType : ECC_WorldStatic);
	Body->SetCollisionResponseToAllChannels(ECR_Block);
	Body->SetSimulatePhysics(Settings.bSimulated);
	if (!Settings.bSimulated)
	{
		return;
	}
	Body->SetEnableGravity(true);
	Body->SetMassOverrideInKg(NAME_None, Settings.Mass, true);
	Body->SetLinearDamping(Settings.LinearDamping);
	Body->SetAngularDamping(Settings.AngularDamping);
	Body->SetPhysicsMaxAngularVelocityInDegrees(EsgSceneDetail::MaxSpin);
	Body->SetUseCCD(true);
}

void AEsgScene::BeginPlay()
{
	Super::BeginPlay();
	Collect();
	PinSimulation();
	GroundPlane->SetPhysMaterialOverride(CreateMaterial(GroundFriction, GroundRestitution));
	VehicleGroundPlane->SetPhysMaterialOverride(CreateMaterial(VehicleGroundFriction, GroundRestitution));
	for (const FBodyRef& Body : Bodies)
	{
		Body.Component->SetPhysMaterialOverride(CreateMaterial(Body.Settings->Friction, Body.Settings->Restitution));
		if (Body.Settings->bSimulated)
		{
			ApplyMassProperties(Body.Component, *Body.Settings);
		}
		if (Body.Settings->bReportsHits)
		{
			Body.Component->OnComponentHit.AddDynamic(this, &AEsgScene::OnBodyHit);
		}
	}
	for (FJointRef& Joint : Joints)
	{
		ConfigureJoint(Joint);
	}
	for (FBrittle& Brittle : Brittles)
	{
		ConfigureBrittle(Brittle);
	}
	for (FStance& Stance : Stances)
	{
		ConfigureStance(Stance);
	}
	UE_LOG(
		LogEsgScene, Display, TEXT("SCENE_START bodies=%d commands=%d events=%d step=%.6f"), Bodies.Num(),
		Commands.Num(), Events.Num(), FixedTimeStep);
	CheckLayout();
}

void AEsgScene::PinSimulation()
{
	if (bPinTimeStep)
	{
		FApp::SetUseFixedTimeStep(true);
		FApp::SetFixedDeltaTime(FixedTimeStep);
	}
	if (AWorldSettings* WorldSettings = GetWorld()->GetWorldSettings())
	{
		WorldSettings->bWorldGravitySet = true;
		WorldSettings->WorldGravityZ = WorldGravityZ;
	}
	if (!GetActorTransform().Equals(FTransform::Identity))
	{
		UE_LOG(
			LogEsgScene, Warning,
			TEXT("NOT_AT_ORIGIN velocities and poses are meant for an actor at the origin"));
	}
}

void AEsgScene::ApplyMassProperties(UStaticMeshComponent* Body, const FEsgBody& Settings)
{
	FBodyInstance* Instance = Body->GetBodyInstance();
	if (!Instance)
	{
		UE_LOG(LogEsgScene, Error, TEXT("NO_PHYSICS body=%s"), *Body->GetName());
		return;
	}
	const FTransform MassFrame(Settings.PrincipalAxes, Settings.CenterOfMass);
	Instance->SetInertiaConditioningEnabled(false);
	FPhysicsCommand::ExecuteWrite(Instance->GetPhysicsActorHandle(), [&](FPhysicsActorHandle& Actor)
	{
		FPhysicsInterface::SetComLocalPose_AssumesLocked(Actor, MassFrame);
		FPhysicsInterface::SetMassSpaceInertiaTensor_AssumesLocked(Actor, Settings.Inertia);
	});
}

UPhysicalMaterial* AEsgScene::CreateMaterial(float Friction, float Restitution)
{
	UPhysicalMaterial* Material = NewObject<UPhysicalMaterial>(this);
	Material->Friction = Friction;
	Material->StaticFriction = Friction;
	Material->Restitution = Restitution;
	Material->bOverrideFrictionCombineMode = true;
	Material->FrictionCombineMode = EFrictionCombineMode::Average;
	Material->bOverrideRestitutionCombineMode = true;
	Material->RestitutionCombineMode = EFrictionCombineMode::Average;
	Materials.Add(Material);
	return Material;
}

void AEsgScene::Tick(float DeltaTime)
{
	Super::Tick(DeltaTime);
	// Unreal passes the step as a float; the pinned step is the same one without that rounding.
	const double Given = DeltaTime;
	const bool bPinned = FMath::Abs(Given - FixedTimeStep) < EsgSceneDetail::StepRounding;
	const double Step = bPinned ? FixedTimeStep : Given;
	BreakBodies(Step);
	RecheckEvents();
	DispatchProgram(SceneTime + EsgSceneDetail::HalfStep * Step);
	DriveJoints(Step);
	TurnWheels(Step);
	RememberSpeeds();
	SceneTime += Step;
	if (!bFinished && SceneTime >= SceneDuration)
	{
		bFinished = true;
		int32 Complete = 0;
		for (const FWatchedEvent& Event : Events)
		{
			Complete += Event.bComplete ? 1 : 0;
		}
		UE_LOG(
			LogEsgScene, Display, TEXT("SCENE_END t=%.4f complete=%d of=%d"), SceneTime, Complete,
			Events.Num());
	}
}

void AEsgScene::OnBodyHit(
	UPrimitiveComponent* HitComponent, AActor* OtherActor, UPrimitiveComponent* OtherComp, FVector NormalImpulse,
	const FHitResult& Hit)
{
	FTouch Touch;
	Touch.First = HitComponent;
	Touch.Second = OtherComp;
	Touch.Time = SceneTime;
	Touch.Impulse = NormalImpulse.Size();
	Touch.Penetration = FMath::Abs(Hit.PenetrationDepth);
	if (OtherActor != this || Touch.Impulse <= 0.0)
	{
		return;
	}
	TakeBlow(HitComponent, OtherComp, Touch.Impulse);
	EndDrivesAtTouch(HitComponent, OtherComp);
	for (FWatchedEvent& Event : Events)
	{
		if (Event.First.Contains(HitComponent) && Event.Second.Contains(OtherComp))
		{
			WatchTouch(Event, Touch);
		}
	}
}

void AEsgScene::EndDrivesAtTouch(const UPrimitiveComponent* First, const UPrimitiveComponent* Second)
{
	for (FCommandState& State : Commands)
	{
		if (State.bActive && !State.bDone && State.Body == First && State.EndsAtTouchOf.Contains(Second))
		{
			State.bDone = true;
			UE_LOG(
				LogEsgScene, Display, TEXT("COMMAND %s ends body=%s at=%s t=%.4f"), State.Kind,
				*First->GetName(), *Second->GetName(), SceneTime);
		}
	}
}

void AEsgScene::WatchTouch(FWatchedEvent& Event, const FTouch& Touch)
{
	if (Event.bHit || Touch.Time > MaxHitTime)
	{
		return;
	}
	for (const int32 Index : Event.After)
	{
		const FWatchedEvent& Before = Events[Index];
		const bool bFailed = Before.bChecked && !Before.bComplete;
		if (!Before.bHit || bFailed || Touch.Time < Before.Hit.Time + MinEventGap)
		{
			return;
		}
	}
	FTouch* Open = nullptr;
	for (FTouch& Candidate : Event.Touches)
	{
		if (Candidate.First == Touch.First && Candidate.Second == Touch.Second)
		{
			Open = &Candidate;
		}
	}
	if (!Open)
	{
		Event.Touches.Add(Touch);
		Open = &Event.Touches.Last();
	}
	else if (Touch.Time > Open->Time + ImpulseWindow)
	{
		*Open = Touch;
	}
	else
	{
		Open->Impulse += Touch.Impulse;
		Open->Penetration = FMath::Max(Open->Penetration, Touch.Penetration);
	}
	if (Open->Impulse <= MinHitImpulse)
	{
		return;
	}
	Event.bHit = true;
	Event.Hit = *Open;
	const bool bShallow = Open->Penetration < MaxHitPenetration;
	Event.bChecked = !bShallow;
	const double ImpulseNs = Open->Impulse / EsgSceneDetail::ImpulsePerNewtonSecond;
	UE_LOG(
		LogEsgScene, Display,
		TEXT("EVENT_HIT id=%s a=%s b=%s t=%.4f penetration_cm=%.3f impulse_Ns=%.3f pass=%d"), *Event.Id,
		*Open->First->GetName(), *Open->Second->GetName(), Open->Time, Open->Penetration, ImpulseNs,
		bShallow ? 1 : 0);
}

void AEsgScene::RecheckEvents()
{
	for (FWatchedEvent& Event : Events)
	{
		if (!Event.bHit || Event.bChecked || SceneTime < Event.Hit.Time + RecheckDelay)
		{
			continue;
		}
		const FBodyRef* First = FindBody(Event.Hit.First);
		const FBodyRef* Second = FindBody(Event.Hit.Second);
		// The ground is no body of the scene: resting on it is no overlap.
		const double Depth = First && Second ? PenetrationOf(*First, *Second) : 0.0;
		Event.bChecked = true;
		Event.bComplete = Depth <= MaxRestPenetration;
		UE_LOG(
			LogEsgScene, Display, TEXT("EVENT_CHECK id=%s t=%.4f penetration_cm=%.3f pass=%d"), *Event.Id,
			SceneTime, Depth, Event.bComplete ? 1 : 0);
	}
}

void AEsgScene::CheckLayout()
{
	int32 Overlaps = 0;
	double Deepest = 0.0;
	for (int32 First = 0; First < Bodies.Num(); ++First)
	{
		for (int32 Second = First + 1; Second < Bodies.Num(); ++Second)
		{
			const FBodyRef& A = Bodies[First];
			const FBodyRef& B = Bodies[Second];
			if (!A.Settings->bCollides || !B.Settings->bCollides)
			{
				continue;
			}
			if (AreJoined(A.Component, B.Component))
			{
				continue;
			}
			if (!A.Component->Bounds.GetBox().Intersect(B.Component->Bounds.GetBox()))
			{
				continue;
			}
			const double Depth = PenetrationOf(A, B);
			Deepest = FMath::Max(Deepest, Depth);
			if (Depth > MaxRestPenetration)
			{
				++Overlaps;
				UE_LOG(
					LogEsgScene, Warning, TEXT("LAYOUT_OVERLAP a=%s b=%s penetration_cm=%.3f"),
					*A.Component->GetName(), *B.Component->GetName(), Depth);
			}
		}
	}
	UE_LOG(
		LogEsgScene, Display, TEXT("LAYOUT overlaps=%d deepest_cm=%.3f pass=%d"), Overlaps, Deepest,
		Overlaps == 0 ? 1 : 0);
}

double AEsgScene::PenetrationOf(const FBodyRef& First, const FBodyRef& Second) const
{
	if (!First.Component->IsCollisionEnabled() || !Second.Component->IsCollisionEnabled())
	{
		return 0.0;
	}
	double Depth = 0.0;
	const FBodyRef* Pair[] = { &First, &Second };
	for (int32 Side = 0; Side < 2; ++Side)
	{
		const FBodyRef& Exact = *Pair[Side];
		const FBodyRef& Probed = *Pair[1 - Side];
		for (const FProbe& Probe : Bodies[Probed.Like].Probes)
		{
			const FTransform Pose = FTransform(
				Probe.Rotation, Probe.Center) * Probed.Component->GetComponentTransform();
			FMTDResult Separation;
			if (Exact.Component->ComputePenetration(Separation, Probe.Shape, Pose.GetLocation(), Pose.GetRotation()))
			{
				Depth = FMath::Max(Depth, static_cast<double>(Separation.Distance));
			}
		}
	}
	return Depth;
}

const AEsgScene::FBodyRef* AEsgScene::FindBody(const UPrimitiveComponent* Component) const
{
	for (const FBodyRef& Body : Bodies)
	{
		if (Body.Component == Component)
		{
			return &Body;
		}
	}
	return nullptr;
}

UStaticMeshComponent* AEsgScene::CreateWheel(
	UStaticMeshComponent* Body, const TCHAR* Name, const TCHAR* AssetPath)
{
	UStaticMeshComponent* Wheel = CreateMesh(Name, AssetPath);
	Wheel->SetupAttachment(Body);
	return Wheel;
}

void AEsgScene::ConfigureWheel(UStaticMeshComponent* Wheel, const FEsgWheel& Settings)
{
	Wheel->SetMobility(EComponentMobility::Movable);
	Wheel->SetRelativeLocationAndRotation(Settings.Axle, FQuat::Identity);
	Wheel->SetCollisionProfileName(TEXT("NoCollision"));
	Wheel->SetSimulatePhysics(false);
}

void AEsgScene::TurnWheels(double Step)
{
	using namespace EsgSceneDetail;
	for (FTurningWheel& Wheel : Wheels)
	{
		if (!Wheel.Body->IsSimulatingPhysics())
		{
			continue;
		}
		const FTransform Pose = Wheel.Body->GetComponentTransform();
		const FQuat Turn = Pose.GetRotation();
		const FVector Axle = Pose.GetLocation() + Turn.RotateVector(Wheel.Settings->Axle);
		const FVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
		const double Rise = Wheel.Body->GetPhysicsLinearVelocity().Z;
		if (Wheel.bStarted && Step > 0.0)
		{
			const bool bStands = Turn.RotateVector(FVector(0.0, 0.0, 1.0)).Z >= Upright;
			const bool bFalls = Rise - Wheel.Rise < Falls * WorldGravityZ * Step;
			const FVector Heading = (Wheel.Ahead + Ahead) * HalfStep;
			const double Gone = FVector::DotProduct(Axle - Wheel.Axle, Heading);
			// What nothing carries goes on turning, and runs down.
			Wheel.Rate = bStands && !bFalls
				? Gone / (Step * Wheel.Settings->Radius)
				: Wheel.Rate * FMath::Max(0.0, 1.0 - Step / RunsDown);
			Wheel.Angle += Wheel.Rate * Step;
		}
		Wheel.bStarted = true;
		Wheel.Axle = Axle;
		Wheel.Ahead = Ahead;
		Wheel.Rise = Rise;
		const double Half = HalfStep * Wheel.Angle;
		Wheel.Component->SetRelativeLocationAndRotation(
			Wheel.Settings->Axle, FQuat(0.0, FMath::Sin(Half), 0.0, FMath::Cos(Half)));
		if (!bFinished && SceneTime + Step >= SceneDuration)
		{
			UE_LOG(
				LogEsgScene, Display, TEXT("WHEEL_TURNED wheel=%s degrees=%.3f"), *Wheel.Component->GetName(),
				FMath::RadiansToDegrees(Wheel.Angle));
		}
	}
}

UPhysicsConstraintComponent* AEsgScene::CreateConstraint(const TCHAR* Name)
{
	UPhysicsConstraintComponent* Constraint = CreateDefaultSubobject<UPhysicsConstraintComponent>(Name);
	Constraint->SetupAttachment(SceneOrigin);
	return Constraint;
}

void AEsgScene::ConfigureJoint(FJointRef& Joint)
{
	using namespace EsgSceneDetail;
	const FEsgJoint& Settings = *Joint.Settings;
	UPhysicsConstraintComponent* Held = Joint.Constraint;
	const bool bSlides = Joint.Kind == EJointKind::Slider;
	const bool bTurns = Joint.Kind == EJointKind::Hinge;
	const bool bFree = Joint.Kind == EJointKind::Spring;
	const bool bRope = Joint.Kind == EJointKind::Rope;
	const bool bCone = Joint.Kind == EJointKind::Ball && Settings.bUpper;
	// Unreal's limits lie evenly about its frames, so that the second frame stands in their middle.
	const bool bLimited = (bSlides || bTurns) && (Settings.bLower || Settings.bUpper);
	const double Far = bSlides ? FarSlide : FarTurn;
	const double Low = Settings.bLower ? Settings.Lower : -Far;
	const double High = Settings.bUpper ? Settings.Upper : Far;
	const double Middle = bLimited ? (Low + High) / 2.0 : 0.0;
	const double Half = bLimited ? (High - Low) / 2.0 : 0.0;
	const double HalfTurn = bTurns ? FMath::DegreesToRadians(Middle) / 2.0 : 0.0;
	const FQuat Turned = Settings.ParentFrame * FQuat(FMath::Sin(HalfTurn), 0.0, 0.0, FMath::Cos(HalfTurn));
	const FVector Shift = Settings.ParentFrame.RotateVector(FVector(bSlides ? Middle : 0.0, 0.0, 0.0));

	const ELinearConstraintMotion Across = bFree ? LCM_Free : (bRope ? LCM_Limited : LCM_Locked);
	const float Reach = static_cast<float>(bRope ? Settings.Upper : 0.0);
	const ELinearConstraintMotion Along = bSlides ? (bLimited ? LCM_Limited : LCM_Free) : Across;
	Held->SetLinearXLimit(Along, bSlides ? static_cast<float>(Half) : Reach);
	Held->SetLinearYLimit(Across, Reach);
	Held->SetLinearZLimit(Across, Reach);
	const bool bHeld = bTurns || bSlides || Joint.Kind == EJointKind::Fixed;
	const EAngularConstraintMotion Swing = bHeld ? ACM_Locked : (bCone ? ACM_Limited : ACM_Free);
	const EAngularConstraintMotion Twist =
		bTurns ? (bLimited ? ACM_Limited : ACM_Free) : (bHeld ? ACM_Locked : ACM_Free);
	const float Cone = static_cast<float>(bCone ? Settings.Upper : 0.0);
	Held->SetAngularSwing1Limit(Swing, Cone);
	Held->SetAngularSwing2Limit(Swing, Cone);
	Held->SetAngularTwistLimit(Twist, static_cast<float>(bTurns ? Half : 0.0));
	Held->SetDisableCollision(!Settings.bCollides);
	const bool bBreaks = Settings.bBreaks && !bFree;
	Held->SetLinearBreakable(bBreaks, static_cast<float>(bBreaks ? Settings.BreakImpulse / BreakWindow : 0.0));
	Held->SetLinearDriveAccelerationMode(false);
	Held->SetAngularDriveAccelerationMode(false);
	Held->SetAngularDriveMode(
		Joint.Kind == EJointKind::Ball ? EAngularDriveMode::SLERP : EAngularDriveMode::TwistAndSwing);
	Held->SetConstrainedComponents(Joint.Child, NAME_None, Joint.Parent, NAME_None);
	Held->SetConstraintReferenceFrame(
		EConstraintFrame::Frame1, FTransform(Settings.ChildFrame, Settings.ChildAnchor));
	Held->SetConstraintReferenceFrame(EConstraintFrame::Frame2, FTransform(Turned, Settings.ParentAnchor + Shift));

	Joint.bMotor = Settings.bMotor;
	Joint.bToPlace = Settings.bMotorToPlace;
	Joint.Speed = Settings.MotorSpeed;
	Joint.Place = Settings.MotorPlace;
	Joint.Limit = Settings.MotorLimit;
	if (Joint.Return)
	{
		ConfigureReturn(Joint);
	}
}

void AEsgScene::ConfigureReturn(FJointRef& Joint)
{
	using namespace EsgSceneDetail;
	const FEsgJoint& Settings = *Joint.Settings;
	UPhysicsConstraintComponent* Drawn = Joint.Return;
	Drawn->SetLinearXLimit(LCM_Free, 0.0f);
	Drawn->SetLinearYLimit(LCM_Free, 0.0f);
	Drawn->SetLinearZLimit(LCM_Free, 0.0f);
	Drawn->SetAngularSwing1Limit(ACM_Free, 0.0f);
	Drawn->SetAngularSwing2Limit(ACM_Free, 0.0f);
	Drawn->SetAngularTwistLimit(ACM_Free, 0.0f);
	Drawn->SetDisableCollision(!Settings.bCollides);
	Drawn->SetLinearDriveAccelerationMode(false);
	Drawn->SetAngularDriveAccelerationMode(false);
	const float Spring = static_cast<float>(Settings.Stiffness);
	const float Damping = static_cast<float>(Settings.Damping);
	if (Joint.Kind == EJointKind::Slider)
	{
		Drawn->SetLinearPositionDrive(true, false, false);
		Drawn->SetLinearVelocityDrive(true, false, false);
		Drawn->SetLinearDriveParams(Spring, Damping, Unlimited);
	}
	else
	{
		const bool bBall = Joint.Kind == EJointKind::Ball;
		Drawn->SetAngularDriveMode(bBall ? EAngularDriveMode::SLERP : EAngularDriveMode::TwistAndSwing);
		Drawn->SetOrientationDriveTwistAndSwing(!bBall, false);
		Drawn->SetAngularVelocityDriveTwistAndSwing(!bBall, false);
		Drawn->SetAngularVelocityDriveSLERP(bBall);
		Drawn->SetAngularDriveParams(Spring, Damping, Unlimited);
	}
	Drawn->SetConstrainedComponents(Joint.Child, NAME_None, Joint.Parent, NAME_None);
	Drawn->SetConstraintReferenceFrame(
		EConstraintFrame::Frame1, FTransform(Settings.ChildFrame, Settings.ChildAnchor));
	Drawn->SetConstraintReferenceFrame(
		EConstraintFrame::Frame2, FTransform(Settings.ParentFrame, Settings.ParentAnchor));
}

double AEsgScene::PositionOf(const FJointRef& Joint) const
{
	const FEsgJoint& Settings = *Joint.Settings;
	const FTransform World = Joint.Parent ? Joint.Parent->GetComponentTransform() : FTransform::Identity;
	const FTransform Base = FTransform(Settings.ParentFrame, Settings.ParentAnchor) * World;
	const FTransform Moved =
		FTransform(Settings.ChildFrame, Settings.ChildAnchor) * Joint.Child->GetComponentTransform();
	const FQuat Back = Base.GetRotation().Inverse();
	if (Joint.Kind == EJointKind::Slider)
	{
		return Back.RotateVector(Moved.GetLocation() - Base.GetLocation()).X;
	}
	const FQuat Turn = Back * Moved.GetRotation();
	return FMath::UnwindDegrees(FMath::RadiansToDegrees(2.0 * FMath::Atan2(Turn.X, Turn.W)));
}

void AEsgScene::DriveJoints(double Step)
{
	using namespace EsgSceneDetail;
	for (FJointRef& Joint : Joints)
	{
		if (Joint.Kind == EJointKind::Spring)
		{
			ApplySpring(Joint, Step);
			continue;
		}
		if (Joint.Kind == EJointKind::Fixed || Joint.Kind == EJointKind::Rope)
		{
			continue;
		}
		double Speed = Joint.bMotor ? Joint.Speed : 0.0;
		const double Limit = Joint.bMotor ? Joint.Limit : Joint.Settings->Friction;
		if (Joint.bMotor && Joint.bToPlace)
		{
			const double Wanted = FMath::Min(ApproachRate, 1.0 / Step) * (Joint.Place - PositionOf(Joint));
			const double Most = FMath::Abs(Joint.Speed);
			Speed = Most > 0.0 ? FMath::Clamp(Wanted, -Most, Most) : Wanted;
		}
		const bool bActs = Limit > 0.0;
		UPhysicsConstraintComponent* Held = Joint.Constraint;
		if (Joint.Kind == EJointKind::Slider)
		{
			Held->SetLinearVelocityDrive(bActs, false, false);
			Held->SetLinearVelocityTarget(FVector(Speed, 0.0, 0.0));
			Held->SetLinearDriveParams(0.0f, RigidDrive, static_cast<float>(Limit));
			continue;
		}
		Held->SetAngularVelocityDriveTwistAndSwing(bActs && Joint.Kind == EJointKind::Hinge, false);
		Held->SetAngularVelocityDriveSLERP(bActs && Joint.Kind == EJointKind::Ball);
		Held->SetAngularVelocityTarget(FVector(Speed / FullTurn, 0.0, 0.0));
		Held->SetAngularDriveParams(0.0f, RigidDrive, static_cast<float>(Limit));
	}
}

double AEsgScene::EaseOf(UPrimitiveComponent* Body, const FVector& At, const FVector& Line) const
{
	const FBodyRef* Known = Body ? FindBody(Body) : nullptr;
	if (!Known || !Known->Settings->bSimulated)
	{
		return 0.0;
	}
	const FQuat Axes = Body->GetComponentTransform().GetRotation() * Known->Settings->PrincipalAxes;
	const FVector Turn =
		Axes.Inverse().RotateVector(FVector::CrossProduct(At - Body->GetCenterOfMass(), Line));
	const FVector& Inertia = Known->Settings->Inertia;
	return 1.0 / Known->Settings->Mass + Turn.X * Turn.X / Inertia.X + Turn.Y * Turn.Y / Inertia.Y +
		Turn.Z * Turn.Z / Inertia.Z;
}

FVector AEsgScene::SpeedAt(UPrimitiveComponent* Body, const FVector& At) const
{
	const FBodyRef* Known = Body ? FindBody(Body) : nullptr;
	if (!Known || !Known->Settings->bSimulated)
	{
		return FVector::ZeroVector;
	}
	const FVector Spin = Body->GetPhysicsAngularVelocityInDegrees() * FMath::DegreesToRadians(1.0);
	return Body->GetPhysicsLinearVelocity() + FVector::CrossProduct(Spin, At - Body->GetCenterOfMass());
}

void AEsgScene::PushAt(UPrimitiveComponent* Body, const FVector& At, const FVector& Impulse)
{
	const FBodyRef* Known = Body ? FindBody(Body) : nullptr;
	if (!Known || !Known->Settings->bSimulated)
	{
		return;
	}
	const FQuat Axes = Body->GetComponentTransform().GetRotation() * Known->Settings->PrincipalAxes;
	const FVector Turn =
		Axes.Inverse().RotateVector(FVector::CrossProduct(At - Body->GetCenterOfMass(), Impulse));
	const FVector& Inertia = Known->Settings->Inertia;
	const FVector Spin(Turn.X / Inertia.X, Turn.Y / Inertia.Y, Turn.Z / Inertia.Z);
	Body->AddImpulse(Impulse, NAME_None, false);
	Body->SetPhysicsAngularVelocityInDegrees(Axes.RotateVector(Spin) * FMath::RadiansToDegrees(1.0), true);
}

void AEsgScene::ApplySpring(FJointRef& Joint, double Step)
{
	using namespace EsgSceneDetail;
	const FEsgJoint& Settings = *Joint.Settings;
	const FTransform World = Joint.Parent ? Joint.Parent->GetComponentTransform() : FTransform::Identity;
	const FVector From = (FTransform(FQuat::Identity, Settings.ParentAnchor) * World).GetLocation();
	const FVector To = (FTransform(FQuat::Identity, Settings.ChildAnchor)
		* Joint.Child->GetComponentTransform()).GetLocation();
	const double Length = (To - From).Size();
	if (Joint.bGone || Length < LeastLength)
	{
		return;
	}
	const FVector Line = (To - From) / Length;
	const double Mass = 1.0 / (EaseOf(Joint.Child, To, Line) + EaseOf(Joint.Parent, From, Line));
	const double Speed = FVector::DotProduct(SpeedAt(Joint.Child, To) - SpeedAt(Joint.Parent, From), Line);
	// After these impulses the steps of the engine are those of the damped oscillator.
	const double Kept = FMath::Exp(-Settings.Damping * Step / Mass);
	const double Fade = Settings.Damping / 2.0 / Mass;
	const double Square = FMath::Min(Settings.Stiffness / Mass, 1.0 / (Step * Step)) - Fade * Fade;
	const double Phase = Step * FMath::Sqrt(FMath::Abs(Square));
	const double Turn = Square < 0.0 ? (FMath::Exp(Phase) + FMath::Exp(-Phase)) / 2.0 : FMath::Cos(Phase);
	const double Drawn = (1.0 + Kept - 2.0 * FMath::Sqrt(Kept) * Turn) / Step * (Length - Settings.Upper);
	const double Impulse = -Mass * (Drawn + (1.0 - Kept) * Speed);
	PushAt(Joint.Child, To, Line * Impulse);
	PushAt(Joint.Parent, From, Line * -Impulse);
	Joint.Given.Add(Impulse);
	double Taken = 0.0;
	const double Before = BreakWindow - HalfStep * Step;
	for (int32 Index = Joint.Given.Num() - 1; (Joint.Given.Num() - 1 - Index) * Step < Before && Index >= 0; --Index)
	{
		Taken += Joint.Given[Index];
	}
	Joint.bGone = Settings.bBreaks && FMath::Abs(Taken) > Settings.BreakImpulse;
}

bool AEsgScene::AreJoined(const UPrimitiveComponent* First, const UPrimitiveComponent* Second) const
{
	for (const FJointRef& Joint : Joints)
	{
		const bool bPair = (Joint.Child == First && Joint.Parent == Second) ||
			(Joint.Child == Second && Joint.Parent == First);
		if (bPair && !Joint.Settings->bCollides)
		{
			return true;
		}
	}
	return false;
}

void AEsgScene::ConfigureBrittle(FBrittle& Brittle)
{
	const FEsgBody& Whole = *Bodies[Brittle.Whole].Settings;
	const FQuat Back = Whole.Rotation.Inverse();
	for (const int32 Index : Brittle.Pieces)
	{
		const FBodyRef& Piece = Bodies[Index];
		Brittle.Centers.Add(Back.RotateVector(Piece.Settings->Location - Whole.Location));
		Brittle.Turns.Add(Back * Piece.Settings->Rotation);
		PutAway(Piece.Component, true);
	}
	const double Window = EsgSceneDetail::BreakWindow / FixedTimeStep;
	const int32 Steps = FMath::Max(1, static_cast<int32>(Window + EsgSceneDetail::HalfStep));
	Brittle.Taken.SetNum(Steps);
}

void AEsgScene::PutAway(UStaticMeshComponent* Body, bool bSimulated)
{
	Body->SetVisibility(false);
	if (bSimulated)
	{
		Body->SetSimulatePhysics(false);
	}
	Body->SetCollisionEnabled(ECollisionEnabled::NoCollision);
}

void AEsgScene::PutIn(const FBodyRef& Body, const FVector& Place, const FQuat& Turn)
{
	Body.Component->SetWorldLocationAndRotation(Place, Turn, false, nullptr, ETeleportType::TeleportPhysics);
	Body.Component->SetCollisionEnabled(ECollisionEnabled::QueryAndPhysics);
	Body.Component->SetSimulatePhysics(true);
	// Unreal makes the mass properties anew with the physics body.
	ApplyMassProperties(Body.Component, *Body.Settings);
	Body.Component->SetVisibility(true);
}

void AEsgScene::ConfigureStance(FStance& Stance)
{
	const FEsgBody& First = *Bodies[Stance.Bodies[0]].Settings;
	const FQuat Back = First.Rotation.Inverse();
	for (const int32 Index : Stance.Bodies)
	{
		const FBodyRef& Body = Bodies[Index];
		Stance.Places.Add(Back.RotateVector(Body.Settings->Location - First.Location));
		Stance.Turns.Add(Back * Body.Settings->Rotation);
		if (Index != Stance.Bodies[0])
		{
			PutAway(Body.Component, true);
		}
	}
}

void AEsgScene::TakeBlow(const UPrimitiveComponent* Body, UPrimitiveComponent* Other, double Impulse)
{
	for (FBrittle& Brittle : Brittles)
	{
		if (Bodies[Brittle.Whole].Component == Body)
		{
			Brittle.Step += Impulse;
			Brittle.Touched.Add(Other);
		}
	}
}

void AEsgScene::BreakBodies(double Step)
{
	for (FBrittle& Brittle : Brittles)
	{
		if (Brittle.bBroken)
		{
			continue;
		}
		double Sum = Brittle.Step;
		for (int32 Index = Brittle.Taken.Num() - 1; Index > 0; --Index)
		{
			Brittle.Taken[Index] = Brittle.Taken[Index - 1];
			Sum += Brittle.Taken[Index];
		}
		Brittle.Taken[0] = Brittle.Step;
		const double Most = Bodies[Brittle.Whole].Settings->BreakImpulse;
		if (Sum > Most)
		{
			Shatter(Brittle, FMath::Min(1.0, (Sum - Most) / Brittle.Step), Step);
		}
		Brittle.Step = 0.0;
		Brittle.Touched.Reset();
	}
}

void AEsgScene::Shatter(FBrittle& Brittle, double Share, double Step)
{
	FBodyRef& Whole = Bodies[Brittle.Whole];
	const bool bMoves = Whole.Settings->bSimulated;
	if (bMoves)
	{
		TakeBack(Whole, Share, Step);
	}
	for (FBodyRef& Body : Bodies)
	{
		if (Brittle.Touched.Contains(Body.Component) && Body.Component->IsSimulatingPhysics())
		{
			TakeBack(Body, Share, Step);
		}
	}
	const FTransform Pose = Whole.Component->GetComponentTransform();
	const FVector Center = Pose.GetRotation().RotateVector(Whole.Settings->CenterOfMass);
	const FVector Velocity = bMoves ? Whole.Component->GetPhysicsLinearVelocity() : FVector::ZeroVector;
	const FVector Spin = bMoves ? Whole.Component->GetPhysicsAngularVelocityInDegrees() : FVector::ZeroVector;
	const FVector Turning = Spin * FMath::DegreesToRadians(1.0);
	PutAway(Whole.Component, bMoves);
	for (FCommandState& State : Commands)
	{
		State.bDone = State.bDone || State.Body == Whole.Component;
	}
	for (int32 Index = 0; Index < Brittle.Pieces.Num(); ++Index)
	{
		FBodyRef& Piece = Bodies[Brittle.Pieces[Index]];
		const FVector Place = Pose.GetRotation().RotateVector(Brittle.Centers[Index]);
		PutIn(Piece, Pose.GetLocation() + Place, Pose.GetRotation() * Brittle.Turns[Index]);
		Piece.Component->SetPhysicsLinearVelocity(Velocity + FVector::CrossProduct(Turning, Place - Center));
		Piece.Component->SetPhysicsAngularVelocityInDegrees(Spin);
	}
	Brittle.bBroken = true;
	UE_LOG(
		LogEsgScene, Display, TEXT("BREAK body=%s t=%.4f pieces=%d"), *Whole.Component->GetName(), SceneTime,
		Brittle.Pieces.Num());
}

void AEsgScene::TakeBack(FBodyRef& Body, double Share, double Step) const
{
	const FVector Velocity = Body.Component->GetPhysicsLinearVelocity();
	const FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
	const FVector Pull(0.0, 0.0, WorldGravityZ * Step);
	Body.Component->SetPhysicsLinearVelocity(Velocity - (Velocity - Body.LastVelocity - Pull) * Share);
	Body.Component->SetPhysicsAngularVelocityInDegrees(Spin - (Spin - Body.LastSpin) * Share);
}

void AEsgScene::RememberSpeeds()
{
	if (Brittles.Num() == 0)
	{
		return;
	}
	for (FBodyRef& Body : Bodies)
	{
		if (Body.Settings->bCollides && Body.Component->IsSimulatingPhysics())
		{
			Body.LastVelocity = Body.Component->GetPhysicsLinearVelocity();
			Body.LastSpin = Body.Component->GetPhysicsAngularVelocityInDegrees();
		}
	}
}
