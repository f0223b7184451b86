void A@CLASS@::RunHoldVelocity(
	UPrimitiveComponent* Body, const F@CLASS@HoldVelocity& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		UE_LOG(
			Log@CLASS@, Display, TEXT("COMMAND HoldVelocity ends body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
		return;
	}
	if (!State.bActive)
	{
		State.bActive = true;
		UE_LOG(
			Log@CLASS@, Display, TEXT("COMMAND HoldVelocity starts body=%s t=%.4f"), *Body->GetName(),
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
@APPROACH@
	// Rolling without slipping, or turning on the spot about the vertical.
	const FVector Spin = Command.RollRadius > 0.0@ON_GROUND@
		? FVector(-Velocity.Y, Velocity.X, 0.0) * FMath::RadiansToDegrees(1.0 / Command.RollRadius)
		: FVector(0.0, 0.0, Command.TurnRate);
@RISE@
	Body->SetPhysicsLinearVelocity(Velocity);
	Body->SetPhysicsAngularVelocityInDegrees(Spin);
}
