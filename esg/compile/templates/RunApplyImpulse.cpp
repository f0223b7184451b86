void A@CLASS@::RunApplyImpulse(
	UPrimitiveComponent* Body, const F@CLASS@ApplyImpulse& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	Body->AddImpulse(Command.Impulse, NAME_None, false);
	UE_LOG(Log@CLASS@, Display, TEXT("COMMAND ApplyImpulse body=%s t=%.4f"), *Body->GetName(), SceneTime);
}
