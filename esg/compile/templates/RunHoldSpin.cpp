void A@CLASS@::RunHoldSpin(
	UPrimitiveComponent* Body, const F@CLASS@HoldSpin& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Start > Due)
	{
		return;
	}
	if (Due > Command.End)
	{
		State.bDone = true;
		UE_LOG(
			Log@CLASS@, Display, TEXT("COMMAND HoldSpin ends body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
		return;
	}
	if (!State.bActive)
	{
		State.bActive = true;
		UE_LOG(
			Log@CLASS@, Display, TEXT("COMMAND HoldSpin starts body=%s t=%.4f"), *Body->GetName(),
			SceneTime);
	}
	Body->SetPhysicsAngularVelocityInDegrees(Command.Spin);
}
