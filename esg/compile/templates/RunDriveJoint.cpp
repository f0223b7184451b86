void A@CLASS@::RunDriveJoint(
	FJointRef& Joint, const F@CLASS@DriveJoint& Command, FCommandState& State, double Due)
{
	if (State.bDone || Command.Time > Due)
	{
		return;
	}
	State.bDone = true;
	Joint.bMotor = Command.bDrives;
	Joint.bToPlace = Command.bToPlace;
	Joint.Speed = Command.Speed;
	Joint.Place = Command.Place;
	Joint.Limit = Command.Limit;
	UE_LOG(
		Log@CLASS@, Display, TEXT("COMMAND DriveJoint joint=%s t=%.4f"), *Joint.Constraint->GetName(),
		SceneTime);
}
