void A@CLASS@::FindFalling(double Due)
{
	using namespace @CLASS@Detail;
	const double Step = (Due - SceneTime) / HalfStep;
	for (FBodyRef& Body : Bodies)
	{
		if (!Body.Settings->bSimulated || !Body.Settings->bCollides)
		{
			continue;
		}
		FVector Lost = Body.Before - Body.Component->GetPhysicsLinearVelocity();
		Body.bFalls = Lost.Z > -FallingShare * WorldGravityZ * Step;
@BLOW@
	}
}

void A@CLASS@::ApplyTraction(double Due)
{
	const double Step = (Due - SceneTime) / @CLASS@Detail::HalfStep;
	for (FBodyRef& Body : Bodies)
	{
		if (!Body.Settings->bSimulated || !Body.Settings->bCollides)
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
@ACTS@
		Body.Before = Body.Component->GetPhysicsLinearVelocity();
	}
}

double A@CLASS@::ApplyBrakes(const FBodyRef& Body, double Loss)
{
	const FVector Velocity = Body.Component->GetPhysicsLinearVelocity();
	FVector Level(Velocity.X, Velocity.Y, 0.0);
@ALONG@
	const double Speed = Level.Size();
	const double Taken = FMath::Min(Loss, Speed);
	if (Taken <= 0.0)
	{
		return 0.0;
	}
	const double Lost = Taken / Speed;
	Body.Component->SetPhysicsLinearVelocity(Velocity - Level * Lost);
@ROLL@
	return Taken;
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
