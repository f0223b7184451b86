#include "EsgScene_S6.h"

#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/EngineTypes.h"
#include "Engine/StaticMesh.h"
#include "Engine/World.h"
#include "GameFramework/WorldSettings.h"
#include "Misc/App.h"
#include "Physics/PhysicsInterfaceCore.h"
#include "PhysicalMaterials/PhysicalMaterial.h"
#include "PhysicsEngine/BodyInstance.h"
#include "UObject/ConstructorHelpers.h"

DEFINE_LOG_CATEGORY_STATIC(LogEsgScene_S6, Log, All);

namespace EsgScene_S6Detail
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

	/** A shape that penetration queries accept, in its mesh's frame. */
	struct FProbe
	{
		FCollisionShape Shape;
		FVector Center;
		FQuat Rotation;
	};

	/** Query shapes of every mesh of the scene. */
	const TArray<TArray<FProbe>>& Probes()
	{
		static const TArray<TArray<FProbe>> Table = {
			// Car1
			{
				{ FCollisionShape::MakeBox(FVector(225.0, 90.0, 75.0)), FVector(0.0, 0.0, 75.0), FQuat(0.0, 0.0, 0.0, 1.0) },
			},
			// TrashBin1
			{
				{ FCollisionShape::MakeCapsule(30.0f, 45.0f), FVector(0.0, 0.0, 45.0), FQuat(0.0, 0.0, 0.0, 1.0) },
			},
			// Table1
			{
				{ FCollisionShape::MakeBox(FVector(60.0, 40.0, 37.5)), FVector(0.0, 0.0, 37.5), FQuat(0.0, 0.0, 0.0, 1.0) },
			},
			// Wall1
			{
				{ FCollisionShape::MakeBox(FVector(20.0, 400.0, 100.0)), FVector(0.0, 0.0, 100.0), FQuat(0.0, 0.0, 0.0, 1.0) },
			},
			// Lane1
			{},
		};
		return Table;
	}
}

AEsgScene_S6::AEsgScene_S6()
{
	PrimaryActorTick.bCanEverTick = true;
	PrimaryActorTick.TickGroup = TG_PrePhysics;

	SceneOrigin = CreateDefaultSubobject<USceneComponent>(TEXT("SceneRoot"));
	SceneOrigin->SetMobility(EComponentMobility::Static);
	SetRootComponent(SceneOrigin);
	GroundPlane = CreateMesh(TEXT("Ground"), TEXT("/Engine/BasicShapes/Cube.Cube"));
	VehicleGroundPlane = CreateMesh(TEXT("VehicleGround"), TEXT("/Engine/BasicShapes/Cube.Cube"));

	Car1Mesh = CreateMesh(TEXT("Car1"), TEXT("/Game/ESG/S6/SM_Car1.SM_Car1"));
	Car1Settings.Location = FVector(-600.0, 100.0, 0.0);
	Car1Settings.Rotation = FQuat(0.0, 0.0, -0.0998334166468282, 0.995004165278026);
	Car1Settings.bSimulated = true;
	Car1Settings.bCollides = true;
	Car1Settings.bOnWheels = true;
	Car1Settings.bReportsHits = true;
	Car1Settings.Friction = 0.1f;
	Car1Settings.Restitution = 0.2f;
	Car1Settings.Mass = 1200.0f;
	Car1Settings.CenterOfMass = FVector(0.0, 0.0, 75.0);
	Car1Settings.PrincipalAxes = FQuat(0.0, 0.0, 0.0, 1.0);
	Car1Settings.Inertia = FVector(5490000.0, 22500000.0, 23490000.0);
	Car1Settings.LinearDamping = 0.0f;
	Car1Settings.AngularDamping = 0.0f;

	TrashBin1Mesh = CreateMesh(TEXT("TrashBin1"), TEXT("/Game/ESG/S6/SM_TrashBin1.SM_TrashBin1"));
	TrashBin1Settings.Location = FVector(100.0, -40.0, 0.0);
	TrashBin1Settings.Rotation = FQuat(0.0, 0.0, 0.0, 1.0);
	TrashBin1Settings.bSimulated = true;
	TrashBin1Settings.bCollides = true;
	TrashBin1Settings.bOnWheels = false;
	TrashBin1Settings.bReportsHits = false;
	TrashBin1Settings.Friction = 0.6f;
	TrashBin1Settings.Restitution = 0.2f;
	TrashBin1Settings.Mass = 15.0f;
	TrashBin1Settings.CenterOfMass = FVector(0.0, 0.0, 45.0);
	TrashBin1Settings.PrincipalAxes = FQuat(0.0, 0.0, 0.0, 1.0);
	TrashBin1Settings.Inertia = FVector(13500.0, 13500.0, 6750.0);
	TrashBin1Settings.LinearDamping = 0.05f;
	TrashBin1Settings.AngularDamping = 0.0f;

	Table1Mesh = CreateMesh(TEXT("Table1"), TEXT("/Game/ESG/S6/SM_Table1.SM_Table1"));
	Table1Settings.Location = FVector(400.0, -150.0, 0.0);
	Table1Settings.Rotation = FQuat(0.0, 0.0, 0.342897807455451, 0.939372712847379);
	Table1Settings.bSimulated = true;
	Table1Settings.bCollides = true;
	Table1Settings.bOnWheels = false;
	Table1Settings.bReportsHits = false;
	Table1Settings.Friction = 0.6f;
	Table1Settings.Restitution = 0.2f;
	Table1Settings.Mass = 20.0f;
	Table1Settings.CenterOfMass = FVector(0.0, 0.0, 37.5);
	Table1Settings.PrincipalAxes = FQuat(0.0, 0.0, 0.0, 1.0);
	Table1Settings.Inertia = FVector(20041.6666666667, 33375.0, 34666.6666666667);
	Table1Settings.LinearDamping = 0.0f;
	Table1Settings.AngularDamping = 0.0f;

	Wall1Mesh = CreateMesh(TEXT("Wall1"), TEXT("/Game/ESG/S6/SM_Wall1.SM_Wall1"));
	Wall1Settings.Location = FVector(900.0, 0.0, 0.0);
	Wall1Settings.Rotation = FQuat(0.0, 0.0, -0.149438132473599, 0.988771077936042);
	Wall1Settings.bSimulated = false;
	Wall1Settings.bCollides = true;
	Wall1Settings.bOnWheels = false;
	Wall1Settings.bReportsHits = false;
	Wall1Settings.Friction = 0.5f;
	Wall1Settings.Restitution = 0.2f;

	Lane1Mesh = CreateMesh(TEXT("Lane1"), TEXT("/Game/ESG/S6/SM_Lane1.SM_Lane1"));
	Lane1Settings.Location = FVector(0.0, 0.0, 0.0);
	Lane1Settings.Rotation = FQuat(0.0, 0.0, 0.0, 1.0);
	Lane1Settings.bSimulated = false;
	Lane1Settings.bCollides = false;
	Lane1Settings.bOnWheels = false;
	Lane1Settings.bReportsHits = false;
	Lane1Settings.Friction = 0.5f;
	Lane1Settings.Restitution = 0.2f;

	Car1Drive1.Start = 0.25;
	Car1Drive1.End = 1000000000.0;
	Car1Drive1.Speed = 600.0;
	Car1Drive1.Heading = -11.4591559026165;
	Car1Drive1.Acceleration = 150.0;
	Car1Drive1.MaxSpeed = 900.0;
	Car1Drive1.TurnRate = 2.86478897565412;
	Car1Drive1.RollRadius = 0.0;

	Table1Impulse1.Time = 0.5;
	Table1Impulse1.Impulse = FVector(-500.0, -1200.0, 3000.0);

	Table1Launch1.Time = 1.2;
	Table1Launch1.Velocity = FVector(50.0, 100.0, 200.0);
	Table1Launch1.bSetSpin = true;
	Table1Launch1.Spin = FVector(-5.72957795130823, 22.9183118052329, 114.591559026165);

	Car1Change1.Time = 1.5;
	Car1Change1.bSetLinearDamping = true;
	Car1Change1.LinearDamping = 1.8f;
	Car1Change1.bSetAngularDamping = true;
	Car1Change1.AngularDamping = 0.3f;
	Car1Change1.bSetFriction = true;
	Car1Change1.Friction = 0.35f;
}

void AEsgScene_S6::OnConstruction(const FTransform& Transform)
{
	Super::OnConstruction(Transform);
	ConfigureGround(GroundPlane, false);
	ConfigureGround(VehicleGroundPlane, true);
	ConfigureBody(Car1Mesh, Car1Settings);
	ConfigureBody(TrashBin1Mesh, TrashBin1Settings);
	ConfigureBody(Table1Mesh, Table1Settings);
	ConfigureBody(Wall1Mesh, Wall1Settings);
	ConfigureBody(Lane1Mesh, Lane1Settings);
}

void AEsgScene_S6::CollectBodies()
{
	Bodies.Reset();
	Bodies.Add(FBodyRef{ Car1Mesh, &Car1Settings, 0 });
	Bodies.Add(FBodyRef{ TrashBin1Mesh, &TrashBin1Settings, 1 });
	Bodies.Add(FBodyRef{ Table1Mesh, &Table1Settings, 2 });
	Bodies.Add(FBodyRef{ Wall1Mesh, &Wall1Settings, 3 });
	Bodies.Add(FBodyRef{ Lane1Mesh, &Lane1Settings, 4 });
}

void AEsgScene_S6::CollectEvents()
{
	Commands.Reset();
	Commands.SetNum(4);
	Events.Reset();
	Events.SetNum(1);
	Commands[0].Body = Car1Mesh;
	Commands[0].EndsAtTouchOf = { TrashBin1Mesh };
	Commands[1].Body = Table1Mesh;
	Commands[2].Body = Table1Mesh;
	Commands[3].Body = Car1Mesh;
	Events[0].Id = TEXT("hit");
	Events[0].First = { Car1Mesh };
	Events[0].Second = { TrashBin1Mesh };
}

void AEsgScene_S6::DispatchProgram(double Due)
{
	RunHoldVelocity(Car1Mesh, Car1Drive1, Commands[0], Due);
	RunApplyImpulse(Table1Mesh, Table1Impulse1, Commands[1], Due);
	RunSetVelocity(Table1Mesh, Table1Launch1, Commands[2], Due);
	RunAdjustProperties(Car1Mesh, Car1Change1, Commands[3], Due);
}

void AEsgScene_S6::RunSetVelocity(
	UPrimitiveComponent* Body, const FEsgScene_S6SetVelocity& Command, FCommandState& State, double Due)
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
	UE_LOG(LogEsgScene_S6, Display, TEXT("COMMAND SetVelocity body=%s t=%.4f"), *Body->GetName(), SceneTime);
}

void AEsgScene_S6::RunApplyImpulse(
	UPrimitiveComponent* Body, const FEsgScene_S6ApplyImpulse& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	Body->AddImpulse(Command.Impulse, NAME_None, false);
	UE_LOG(LogEsgScene_S6, Display, TEXT("COMMAND ApplyImpulse body=%s t=%.4f"), *Body->GetName(), SceneTime);
}

void AEsgScene_S6::RunAdjustProperties(
	UPrimitiveComponent* Body, const FEsgScene_S6AdjustProperties& Command, FCommandState& State, double Due)
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
	UE_LOG(
		LogEsgScene_S6, Display, TEXT("COMMAND AdjustProperties body=%s t=%.4f"), *Body->GetName(), SceneTime);
}

void AEsgScene_S6::RunHoldVelocity(
	UPrimitiveComponent* Body, const FEsgScene_S6HoldVelocity& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		UE_LOG(
			LogEsgScene_S6, Display, TEXT("COMMAND HoldVelocity ends body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
		return;
	}
	if (!State.bActive)
	{
		State.bActive = true;
		UE_LOG(
			LogEsgScene_S6, Display, TEXT("COMMAND HoldVelocity starts body=%s t=%.4f"), *Body->GetName(),
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
	// Rolling without slipping, or turning on the spot about the vertical.
	const FVector Spin = Command.RollRadius > 0.0
		? FVector(-Velocity.Y, Velocity.X, 0.0) * FMath::RadiansToDegrees(1.0 / Command.RollRadius)
		: FVector(0.0, 0.0, Command.TurnRate);
	Velocity.Z = Body->GetPhysicsLinearVelocity().Z;
	Body->SetPhysicsLinearVelocity(Velocity);
	Body->SetPhysicsAngularVelocityInDegrees(Spin);
}

UStaticMeshComponent* AEsgScene_S6::CreateMesh(const TCHAR* Name, const TCHAR* AssetPath)
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
		UE_LOG(LogEsgScene_S6, Error, TEXT("MISSING_ASSET body=%s path=%s"), Name, AssetPath);
	}
	return Component;
}

void AEsgScene_S6::ConfigureGround(UStaticMeshComponent* Plane, bool bForWheels)
{
	using namespace EsgScene_S6Detail;
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

void AEsgScene_S6::ConfigureBody(UStaticMeshComponent* Body, const FEsgScene_S6Body& Settings)
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
	Body->SetPhysicsMaxAngularVelocityInDegrees(EsgScene_S6Detail::MaxSpin);
	Body->SetUseCCD(true);
}

void AEsgScene_S6::BeginPlay()
{
	Super::BeginPlay();
	CollectBodies();
	CollectEvents();
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
			Body.Component->OnComponentHit.AddDynamic(this, &AEsgScene_S6::OnBodyHit);
		}
	}
	UE_LOG(
		LogEsgScene_S6, Display, TEXT("SCENE_START bodies=%d commands=%d events=%d step=%.6f"), Bodies.Num(),
		Commands.Num(), Events.Num(), FixedTimeStep);
	CheckLayout();
}

void AEsgScene_S6::PinSimulation()
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
			LogEsgScene_S6, Warning,
			TEXT("NOT_AT_ORIGIN velocities and poses are meant for an actor at the origin"));
	}
}

void AEsgScene_S6::ApplyMassProperties(UStaticMeshComponent* Body, const FEsgScene_S6Body& Settings)
{
	FBodyInstance* Instance = Body->GetBodyInstance();
	if (!Instance)
	{
		UE_LOG(LogEsgScene_S6, Error, TEXT("NO_PHYSICS body=%s"), *Body->GetName());
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

UPhysicalMaterial* AEsgScene_S6::CreateMaterial(float Friction, float Restitution)
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

void AEsgScene_S6::Tick(float DeltaTime)
{
	Super::Tick(DeltaTime);
	// Unreal passes the step as a float; the pinned step is the same one without that rounding.
	const double Given = DeltaTime;
	const bool bPinned = FMath::Abs(Given - FixedTimeStep) < EsgScene_S6Detail::StepRounding;
	const double Step = bPinned ? FixedTimeStep : Given;
	RecheckEvents();
	DispatchProgram(SceneTime + EsgScene_S6Detail::HalfStep * Step);
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
			LogEsgScene_S6, Display, TEXT("SCENE_END t=%.4f complete=%d of=%d"), SceneTime, Complete,
			Events.Num());
	}
}

void AEsgScene_S6::OnBodyHit(
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
	EndDrivesAtTouch(HitComponent, OtherComp);
	for (FWatchedEvent& Event : Events)
	{
		if (Event.First.Contains(HitComponent) && Event.Second.Contains(OtherComp))
		{
			WatchTouch(Event, Touch);
		}
	}
}

void AEsgScene_S6::EndDrivesAtTouch(const UPrimitiveComponent* First, const UPrimitiveComponent* Second)
{
	for (FCommandState& State : Commands)
	{
		if (State.bActive && !State.bDone && State.Body == First && State.EndsAtTouchOf.Contains(Second))
		{
			State.bDone = true;
			UE_LOG(
				LogEsgScene_S6, Display, TEXT("COMMAND HoldVelocity ends body=%s at=%s t=%.4f"),
				*First->GetName(), *Second->GetName(), SceneTime);
		}
	}
}

void AEsgScene_S6::WatchTouch(FWatchedEvent& Event, const FTouch& Touch)
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
	const double ImpulseNs = Open->Impulse / EsgScene_S6Detail::ImpulsePerNewtonSecond;
	UE_LOG(
		LogEsgScene_S6, Display,
		TEXT("EVENT_HIT id=%s a=%s b=%s t=%.4f penetration_cm=%.3f impulse_Ns=%.3f pass=%d"), *Event.Id,
		*Open->First->GetName(), *Open->Second->GetName(), Open->Time, Open->Penetration, ImpulseNs,
		bShallow ? 1 : 0);
}

void AEsgScene_S6::RecheckEvents()
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
			LogEsgScene_S6, Display, TEXT("EVENT_CHECK id=%s t=%.4f penetration_cm=%.3f pass=%d"), *Event.Id,
			SceneTime, Depth, Event.bComplete ? 1 : 0);
	}
}

void AEsgScene_S6::CheckLayout()
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
					LogEsgScene_S6, Warning, TEXT("LAYOUT_OVERLAP a=%s b=%s penetration_cm=%.3f"),
					*A.Component->GetName(), *B.Component->GetName(), Depth);
			}
		}
	}
	UE_LOG(
		LogEsgScene_S6, Display, TEXT("LAYOUT overlaps=%d deepest_cm=%.3f pass=%d"), Overlaps, Deepest,
		Overlaps == 0 ? 1 : 0);
}

double AEsgScene_S6::PenetrationOf(const FBodyRef& First, const FBodyRef& Second) const
{
	double Depth = 0.0;
	const FBodyRef* Pair[] = { &First, &Second };
	for (int32 Side = 0; Side < 2; ++Side)
	{
		const FBodyRef& Exact = *Pair[Side];
		const FBodyRef& Probed = *Pair[1 - Side];
		for (const EsgScene_S6Detail::FProbe& Probe : EsgScene_S6Detail::Probes()[Probed.Shape])
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

const AEsgScene_S6::FBodyRef* AEsgScene_S6::FindBody(const UPrimitiveComponent* Component) const
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
