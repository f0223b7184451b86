UPhysicsConstraintComponent* A@CLASS@::CreateConstraint(const TCHAR* Name)
{
	UPhysicsConstraintComponent* Constraint = CreateDefaultSubobject<UPhysicsConstraintComponent>(Name);
	Constraint->SetupAttachment(SceneOrigin);
	return Constraint;
}

void A@CLASS@::ConfigureJoint(FJointRef& Joint)
{
	using namespace @CLASS@Detail;
	const F@CLASS@Joint& Settings = *Joint.Settings;
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
	const double Middle = bLimited ? 0.5 * (Low + High) : 0.0;
	const double Half = bLimited ? 0.5 * (High - Low) : 0.0;
	const double HalfTurn = bTurns ? 0.5 * FMath::DegreesToRadians(Middle) : 0.0;
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

void A@CLASS@::ConfigureReturn(FJointRef& Joint)
{
	using namespace @CLASS@Detail;
	const F@CLASS@Joint& Settings = *Joint.Settings;
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

double A@CLASS@::PositionOf(const FJointRef& Joint) const
{
	const F@CLASS@Joint& Settings = *Joint.Settings;
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

void A@CLASS@::DriveJoints(double Step)
{
	using namespace @CLASS@Detail;
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

double A@CLASS@::EaseOf(UPrimitiveComponent* Body, const FVector& At, const FVector& Line) const
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

FVector A@CLASS@::SpeedAt(UPrimitiveComponent* Body, const FVector& At) const
{
	const FBodyRef* Known = Body ? FindBody(Body) : nullptr;
	if (!Known || !Known->Settings->bSimulated)
	{
		return FVector::ZeroVector;
	}
	const FVector Spin = Body->GetPhysicsAngularVelocityInDegrees() * FMath::DegreesToRadians(1.0);
	return Body->GetPhysicsLinearVelocity() + FVector::CrossProduct(Spin, At - Body->GetCenterOfMass());
}

void A@CLASS@::PushAt(UPrimitiveComponent* Body, const FVector& At, const FVector& Impulse)
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

void A@CLASS@::ApplySpring(FJointRef& Joint, double Step)
{
	using namespace @CLASS@Detail;
	const F@CLASS@Joint& Settings = *Joint.Settings;
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
	const double Fade = 0.5 * Settings.Damping / Mass;
	const double Square = FMath::Min(Settings.Stiffness / Mass, 1.0 / (Step * Step)) - Fade * Fade;
	const double Phase = Step * FMath::Sqrt(FMath::Abs(Square));
	const double Turn = Square < 0.0 ? 0.5 * (FMath::Exp(Phase) + FMath::Exp(-Phase)) : FMath::Cos(Phase);
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

bool A@CLASS@::AreJoined(const UPrimitiveComponent* First, const UPrimitiveComponent* Second) const
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
