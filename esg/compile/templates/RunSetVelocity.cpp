void A@CLASS@::RunSetVelocity(
	UPrimitiveComponent* Body, const F@CLASS@SetVelocity& Command, FCommandState& State, double Due)
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
	UE_LOG(Log@CLASS@, Display, TEXT("COMMAND SetVelocity body=%s t=%.4f"), *Body->GetName(), SceneTime);
}
