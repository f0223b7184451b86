void A@CLASS@::RunAdjustProperties(
	UPrimitiveComponent* Body, const F@CLASS@AdjustProperties& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	if (Command.bSetLinearDamping)
	{
		Body->SetLinearDamping(Command.LinearDamping);
	}
	if (Command.bSetAngularDamping)
	{
		Body->SetAngularDamping(Command.AngularDamping);
	}
	const FBodyRef* Known = FindBody(Body);
	if (Command.bSetFriction && Known)
	{
		Body->SetPhysMaterialOverride(CreateMaterial(Command.Friction, Known->Settings->Restitution));
	}
@SET_BRAKING@
	UE_LOG(
		Log@CLASS@, Display, TEXT("COMMAND AdjustProperties body=%s t=%.4f"), *Body->GetName(), SceneTime);
}
