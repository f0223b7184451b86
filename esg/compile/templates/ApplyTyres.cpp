void A@CLASS@::ApplyTyres(const FBodyRef& Body, double Weight, double Taken)
{
	const F@CLASS@Body& Settings = *Body.Settings;
	const FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
	const double Grip = Settings.TyreFriction * Weight;
	if (Grip <= Taken || Turn.RotateVector(FVector(0.0, 0.0, 1.0)).Z <= @CLASS@Detail::UprightCosine)
	{
		return;
	}
	// What the brakes have taken, the tyres cannot give to the side.
	const double Limit = FMath::Sqrt(Grip * Grip - Taken * Taken);
	FVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
	Ahead.Z = 0.0;
	Ahead = Ahead * (1.0 / Ahead.Size());
	const FVector Side(-Ahead.Y, Ahead.X, 0.0);
	const FVector Velocity = Body.Component->GetPhysicsLinearVelocity();
	const double Radian = FMath::RadiansToDegrees(1.0);
	const FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees() * (1.0 / Radian);
	const double Given = 1.0 + Settings.TyreDrop * Settings.Lean;
	const double Rolling = Settings.TyreDrop * FVector::DotProduct(Ahead, Spin);
	const double Slip = (FVector::DotProduct(Side, Velocity) + Rolling) / Given;
	const double Yaw = Settings.Axle * Spin.Z;
	const double Front = FMath::Clamp(Slip + Yaw, -Limit, Limit);
	const double Rear = FMath::Clamp(Slip - Yaw, -Limit, Limit);
	const double Mean = (Front + Rear) * @CLASS@Detail::HalfStep;
	const double Back = (Front - Rear) * @CLASS@Detail::HalfStep / Settings.Axle;
	const FVector Left = Ahead * (Settings.Lean * Mean) + FVector(0.0, 0.0, Back);
	Body.Component->SetPhysicsLinearVelocity(Velocity - Side * Mean);
	Body.Component->SetPhysicsAngularVelocityInDegrees((Spin - Left) * Radian);
}

void A@CLASS@::TipOver(FBodyRef& Body, double Step)
{
	using namespace @CLASS@Detail;
	if (Body.Tips <= 0.0)
	{
		return;
	}
	Body.Tips -= Step;
	const FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
	const FVector Up = Turn.RotateVector(FVector(0.0, 0.0, 1.0));
	FVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
	Ahead.Z = 0.0;
	Ahead = Ahead * (1.0 / Ahead.Size());
	const FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
	// Seen from above Unreal's axes are mirrored: positive leans to the left.
	const double Lean = FVector::DotProduct(Ahead, Spin);
	if (Up.Z <= UprightCosine || FMath::Abs(Lean) >= TippingRate)
	{
		return;
	}
	const double Left = Ahead.Y * Up.X - Ahead.X * Up.Y;
	const bool bLeft = FMath::Abs(Lean) > LeastLean ? Lean > 0.0 : Left > LeastTilt;
	const double More = (bLeft ? TippingRate : -TippingRate) - Lean;
	Body.Component->SetPhysicsAngularVelocityInDegrees(Spin + Ahead * More);
}
