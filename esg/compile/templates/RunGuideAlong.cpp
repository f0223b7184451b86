void A@CLASS@::RunGuideAlong(
	UPrimitiveComponent* Body, const F@CLASS@GuideAlong& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		UE_LOG(
			Log@CLASS@, Display, TEXT("COMMAND GuideAlong ends body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
		return;
	}
	if (!State.bActive)
	{
		State.bActive = true;
		UE_LOG(
			Log@CLASS@, Display, TEXT("COMMAND GuideAlong starts body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
	}
	using namespace @CLASS@Detail;
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

FVector A@CLASS@::PathPoint(const F@CLASS@GuideAlong& Command, double Elapsed)
{
	using namespace @CLASS@Detail;
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
