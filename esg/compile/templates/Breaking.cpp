void A@CLASS@::AddBrittle(int32 Whole, const TArray<int32>& Pieces)
{
	FBrittle Brittle;
	Brittle.Whole = &Bodies[Whole];
	const FQuat Back = Brittle.Whole->Settings->Rotation.Inverse();
	for (const int32 Index : Pieces)
	{
		FBodyRef& Piece = Bodies[Index];
		Brittle.Pieces.Add(&Piece);
		Brittle.Centers.Add(Back.RotateVector(Piece.Settings->Location - Brittle.Whole->Settings->Location));
		Brittle.Turns.Add(Back * Piece.Settings->Rotation);
		PutAway(Piece.Component, true);
	}
	const int32 Steps = FMath::Max(1, static_cast<int32>(@CLASS@Detail::BreakWindow / FixedTimeStep + 0.5));
	Brittle.Taken.SetNum(Steps);
	Brittles.Add(Brittle);
}

void A@CLASS@::PutAway(UStaticMeshComponent* Body, bool bSimulated)
{
	Body->SetVisibility(false);
	if (bSimulated)
	{
		Body->SetSimulatePhysics(false);
	}
	Body->SetCollisionEnabled(ECollisionEnabled::NoCollision);
}

void A@CLASS@::TakeBlow(const UPrimitiveComponent* Body, UPrimitiveComponent* Other, double Impulse)
{
	for (FBrittle& Brittle : Brittles)
	{
		if (Brittle.Whole->Component == Body)
		{
			Brittle.Step += Impulse;
			Brittle.Touched.Add(Other);
		}
	}
}

void A@CLASS@::BreakBodies(double Step)
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
		const double Most = Brittle.Whole->Settings->BreakImpulse;
		if (Sum > Most)
		{
			Shatter(Brittle, FMath::Min(1.0, (Sum - Most) / Brittle.Step), Step);
		}
		Brittle.Step = 0.0;
		Brittle.Touched.Reset();
	}
}

void A@CLASS@::Shatter(FBrittle& Brittle, double Share, double Step)
{
	FBodyRef& Whole = *Brittle.Whole;
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
		FBodyRef& Piece = *Brittle.Pieces[Index];
		const FVector Place = Pose.GetRotation().RotateVector(Brittle.Centers[Index]);
		Piece.Component->SetWorldLocationAndRotation(
			Pose.GetLocation() + Place, Pose.GetRotation() * Brittle.Turns[Index], false, nullptr,
			ETeleportType::TeleportPhysics);
		Piece.Component->SetCollisionEnabled(ECollisionEnabled::QueryAndPhysics);
		Piece.Component->SetSimulatePhysics(true);
		// Unreal makes the mass properties anew with the physics body.
		ApplyMassProperties(Piece.Component, *Piece.Settings);
		Piece.Component->SetVisibility(true);
		Piece.Component->SetPhysicsLinearVelocity(Velocity + FVector::CrossProduct(Turning, Place - Center));
		Piece.Component->SetPhysicsAngularVelocityInDegrees(Spin);
	}
	Brittle.bBroken = true;
	UE_LOG(
		Log@CLASS@, Display, TEXT("BREAK body=%s t=%.4f pieces=%d"), *Whole.Component->GetName(), SceneTime,
		Brittle.Pieces.Num());
}

void A@CLASS@::TakeBack(FBodyRef& Body, double Share, double Step) const
{
	const FVector Velocity = Body.Component->GetPhysicsLinearVelocity();
	const FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
	const FVector Pull(0.0, 0.0, WorldGravityZ * Step);
	Body.Component->SetPhysicsLinearVelocity(Velocity - (Velocity - Body.LastVelocity - Pull) * Share);
	Body.Component->SetPhysicsAngularVelocityInDegrees(Spin - (Spin - Body.LastSpin) * Share);
}

void A@CLASS@::RememberSpeeds()
{
	for (FBodyRef& Body : Bodies)
	{
		if (Body.Settings->bCollides && Body.Component->IsSimulatingPhysics())
		{
			Body.LastVelocity = Body.Component->GetPhysicsLinearVelocity();
			Body.LastSpin = Body.Component->GetPhysicsAngularVelocityInDegrees();
		}
	}
}
