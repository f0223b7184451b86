UStaticMeshComponent* A@CLASS@::CreateWheel(
	UStaticMeshComponent* Body, const TCHAR* Name, const TCHAR* AssetPath)
{
	UStaticMeshComponent* Wheel = CreateMesh(Name, AssetPath);
	Wheel->SetupAttachment(Body);
	return Wheel;
}

void A@CLASS@::ConfigureWheel(UStaticMeshComponent* Wheel, const F@CLASS@Wheel& Settings)
{
	Wheel->SetMobility(EComponentMobility::Movable);
	Wheel->SetRelativeLocationAndRotation(Settings.Axle, FQuat::Identity);
	Wheel->SetCollisionProfileName(TEXT("NoCollision"));
	Wheel->SetSimulatePhysics(false);
}

void A@CLASS@::TurnWheels(double Step)
{
	using namespace @CLASS@Detail;
	for (FTurningWheel& Wheel : Wheels)
	{
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
				Log@CLASS@, Display, TEXT("WHEEL_TURNED wheel=%s degrees=%.3f"), *Wheel.Component->GetName(),
				FMath::RadiansToDegrees(Wheel.Angle));
		}
	}
}
