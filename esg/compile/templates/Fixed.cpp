UStaticMeshComponent* A@CLASS@::CreateMesh(const TCHAR* Name, const TCHAR* AssetPath)
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
		UE_LOG(Log@CLASS@, Error, TEXT("MISSING_ASSET body=%s path=%s"), Name, AssetPath);
	}
	return Component;
}

void A@CLASS@::ConfigureGround(UStaticMeshComponent* Plane, bool bForWheels)
{
	using namespace @CLASS@Detail;
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

void A@CLASS@::ConfigureBody(UStaticMeshComponent* Body, const F@CLASS@Body& Settings)
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
	Body->SetPhysicsMaxAngularVelocityInDegrees(@CLASS@Detail::MaxSpin);
	Body->SetUseCCD(true);
}

void A@CLASS@::BeginPlay()
{
	Super::BeginPlay();
	CollectBodies();
	CollectEvents();
	@COLLECT_WHEELS@
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
			Body.Component->OnComponentHit.AddDynamic(this, &A@CLASS@::OnBodyHit);
		}
	}
	@COLLECT_JOINTS@
	@COLLECT_FRAGMENTS@
	UE_LOG(
		Log@CLASS@, Display, TEXT("SCENE_START bodies=%d commands=%d events=%d step=%.6f"), Bodies.Num(),
		Commands.Num(), Events.Num(), FixedTimeStep);
	CheckLayout();
}

void A@CLASS@::PinSimulation()
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
			Log@CLASS@, Warning,
			TEXT("NOT_AT_ORIGIN velocities and poses are meant for an actor at the origin"));
	}
}

void A@CLASS@::ApplyMassProperties(UStaticMeshComponent* Body, const F@CLASS@Body& Settings)
{
	FBodyInstance* Instance = Body->GetBodyInstance();
	if (!Instance)
	{
		UE_LOG(Log@CLASS@, Error, TEXT("NO_PHYSICS body=%s"), *Body->GetName());
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

UPhysicalMaterial* A@CLASS@::CreateMaterial(float Friction, float Restitution)
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

void A@CLASS@::Tick(float DeltaTime)
{
	Super::Tick(DeltaTime);
	// Unreal passes the step as a float; the pinned step is the same one without that rounding.
	const double Given = DeltaTime;
	const bool bPinned = FMath::Abs(Given - FixedTimeStep) < @CLASS@Detail::StepRounding;
	const double Step = bPinned ? FixedTimeStep : Given;
	@BREAK_BODIES@
	RecheckEvents();
	DispatchProgram(SceneTime + @CLASS@Detail::HalfStep * Step);
	@DRIVE_JOINTS@
	@TURN_WHEELS@
	@REMEMBER_SPEEDS@
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
			Log@CLASS@, Display, TEXT("SCENE_END t=%.4f complete=%d of=%d"), SceneTime, Complete,
			Events.Num());
	}
}

void A@CLASS@::OnBodyHit(
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
	@TAKE_BLOW@
	EndDrivesAtTouch(HitComponent, OtherComp);
	for (FWatchedEvent& Event : Events)
	{
		if (Event.First.Contains(HitComponent) && Event.Second.Contains(OtherComp))
		{
			WatchTouch(Event, Touch);
		}
	}
}

void A@CLASS@::EndDrivesAtTouch(const UPrimitiveComponent* First, const UPrimitiveComponent* Second)
{
	for (FCommandState& State : Commands)
	{
		if (State.bActive && !State.bDone && State.Body == First && State.EndsAtTouchOf.Contains(Second))
		{
			State.bDone = true;
			UE_LOG(
				Log@CLASS@, Display, TEXT("COMMAND @LASTING@ ends body=%s at=%s t=%.4f"),
				*First->GetName(), *Second->GetName(), SceneTime);
		}
	}
}

void A@CLASS@::WatchTouch(FWatchedEvent& Event, const FTouch& Touch)
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
	const double ImpulseNs = Open->Impulse / @CLASS@Detail::ImpulsePerNewtonSecond;
	UE_LOG(
		Log@CLASS@, Display,
		TEXT("EVENT_HIT id=%s a=%s b=%s t=%.4f penetration_cm=%.3f impulse_Ns=%.3f pass=%d"), *Event.Id,
		*Open->First->GetName(), *Open->Second->GetName(), Open->Time, Open->Penetration, ImpulseNs,
		bShallow ? 1 : 0);
}

void A@CLASS@::RecheckEvents()
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
			Log@CLASS@, Display, TEXT("EVENT_CHECK id=%s t=%.4f penetration_cm=%.3f pass=%d"), *Event.Id,
			SceneTime, Depth, Event.bComplete ? 1 : 0);
	}
}

void A@CLASS@::CheckLayout()
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
			@JOINED@
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
					Log@CLASS@, Warning, TEXT("LAYOUT_OVERLAP a=%s b=%s penetration_cm=%.3f"),
					*A.Component->GetName(), *B.Component->GetName(), Depth);
			}
		}
	}
	UE_LOG(
		Log@CLASS@, Display, TEXT("LAYOUT overlaps=%d deepest_cm=%.3f pass=%d"), Overlaps, Deepest,
		Overlaps == 0 ? 1 : 0);
}

double A@CLASS@::PenetrationOf(const FBodyRef& First, const FBodyRef& Second) const
{
	@GONE@
	double Depth = 0.0;
	const FBodyRef* Pair[] = { &First, &Second };
	for (int32 Side = 0; Side < 2; ++Side)
	{
		const FBodyRef& Exact = *Pair[Side];
		const FBodyRef& Probed = *Pair[1 - Side];
		for (const @CLASS@Detail::FProbe& Probe : @CLASS@Detail::Probes()[Probed.Shape])
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

const A@CLASS@::FBodyRef* A@CLASS@::FindBody(const UPrimitiveComponent* Component) const
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
