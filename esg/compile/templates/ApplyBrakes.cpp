void A@CLASS@::ApplyBrakes(double Due)
{
	using namespace @CLASS@Detail;
	const double Step = (Due - SceneTime) / HalfStep;
	for (FBodyRef& Body : Bodies)
	{
		if (!Body.Settings->bSimulated || !Body.Settings->bCollides)
		{
			continue;
		}
		FVector Velocity = Body.Component->GetPhysicsLinearVelocity();
		const bool bFalls = Body.Rise - Velocity.Z > -FallingShare * WorldGravityZ * Step;
		Body.Rise = Velocity.Z;
		const double Speed = FVector(Velocity.X, Velocity.Y, 0.0).Size();
		if (bFalls || Body.Braking <= 0.0 || Speed <= 0.0 || IsDriven(Body.Component))
		{
			continue;
		}
		const double Kept = FMath::Max(0.0, 1.0 - Body.Braking * Step / Speed);
		Velocity.X *= Kept;
		Velocity.Y *= Kept;
		Body.Component->SetPhysicsLinearVelocity(Velocity);
		if (Body.Settings->bRolls)
		{
			FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
			Spin.X *= Kept;
			Spin.Y *= Kept;
			Body.Component->SetPhysicsAngularVelocityInDegrees(Spin);
		}
	}
}

bool A@CLASS@::IsDriven(const UPrimitiveComponent* Body) const
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
