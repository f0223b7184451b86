void A@CLASS@::ApplyTyres(const FBodyRef& Body, double Weight, double Taken)
{
	const F@CLASS@Body& Settings = *Body.Settings;
	const FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
	const double Grip = Settings.TyreFriction * Weight;
	const FVector Up = Turn.RotateVector(FVector(0.0, 0.0, 1.0));
	if (Grip <= Taken || Up.Z <= @CLASS@Detail::UprightCosine)
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
	// Of the centre of mass over the edge that what leans stands on.
	const double Tilt = FMath::Abs(FVector::DotProduct(Side, Up));
	const double Height = Settings.TyreDrop * Up.Z + Settings.TyreFoot * Tilt;
	const double Given = 1.0 + Height * Height * Settings.Lean;
	const double Rolling = Height * FVector::DotProduct(Ahead, Spin);
	const double Slip = (FVector::DotProduct(Side, Velocity) + Rolling) / Given;
	const double Yaw = Settings.Axle * Spin.Z;
	const double Front = FMath::Clamp(Slip + Yaw, -Limit, Limit);
	const double Rear = FMath::Clamp(Slip - Yaw, -Limit, Limit);
	const double Mean = (Front + Rear) * @CLASS@Detail::HalfStep;
	const double Back = (Front - Rear) * @CLASS@Detail::HalfStep / Settings.Axle;
	const FVector Left = Ahead * (Height * Settings.Lean * Mean) + FVector(0.0, 0.0, Back);
	Body.Component->SetPhysicsLinearVelocity(Velocity - Side * Mean);
	Body.Component->SetPhysicsAngularVelocityInDegrees((Spin - Left) * Radian);
}

void A@CLASS@::TipOver(FBodyRef& Body)
{
	using namespace @CLASS@Detail;
	if (!Body.bTips)
	{
		return;
	}
	Body.bTips = false;
	const F@CLASS@Body& Settings = *Body.Settings;
	const FQuat Turn = Body.Component->GetComponentTransform().GetRotation();
	const FVector Up = Turn.RotateVector(FVector(0.0, 0.0, 1.0));
	FVector Ahead = Turn.RotateVector(FVector(1.0, 0.0, 0.0));
	Ahead.Z = 0.0;
	Ahead = Ahead * (1.0 / Ahead.Size());
	const FVector Spin = Body.Component->GetPhysicsAngularVelocityInDegrees();
	// Seen from above Unreal's axes are mirrored: positive leans to the left.
	const double Lean = FVector::DotProduct(Ahead, Spin);
	if (Up.Z <= UprightCosine || FMath::Abs(Lean) >= Settings.TipRate)
	{
		return;
	}
	const double Left = Ahead.Y * Up.X - Ahead.X * Up.Y;
	const bool bLeft = FMath::Abs(Lean) > LeastLean ? Lean > 0.0 : Left > LeastTilt;
	const double More = (bLeft ? Settings.TipRate : -Settings.TipRate) - Lean;
	// It turns about the edge of its foot.
	const double Foot = bLeft ? Settings.TyreFoot : -Settings.TyreFoot;
	const FVector Arm = Turn.RotateVector(FVector(0.0, Foot, Settings.TyreDrop));
	const FVector Moved = FVector::CrossProduct(Ahead, Arm) * FMath::DegreesToRadians(More);
	Body.Component->SetPhysicsLinearVelocity(Body.Component->GetPhysicsLinearVelocity() + Moved);
	Body.Component->SetPhysicsAngularVelocityInDegrees(Spin + Ahead * More);
}
