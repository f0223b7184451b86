#include "EsgScene_S6.h"

#include "Components/StaticMeshComponent.h"

AEsgScene_S6::AEsgScene_S6()
{
	FixedTimeStep = 0.00416666666666667;
	WorldGravityZ = -981.0f;
	GroundFriction = 0.7f;
	GroundRestitution = 0.3f;
	VehicleGroundFriction = 0.0f;
	SceneDuration = 3.0;

	Car1Mesh = CreateMesh(TEXT("Car1"), TEXT("/Game/ESG/S6/SM_Car1.SM_Car1"));
	Car1Settings.Location = FVector(-600.0, 100.0, 0.0);
	Car1Settings.Rotation = FQuat(0.0, 0.0, -0.0998334166468282, 0.995004165278026);
	Car1Settings.bSimulated = true;
	Car1Settings.bCollides = true;
	Car1Settings.bOnWheels = true;
	Car1Settings.bReportsHits = true;
	Car1Settings.Friction = 0.1f;
	Car1Settings.Restitution = 0.2f;
	Car1Settings.Mass = 1200.0f;
	Car1Settings.CenterOfMass = FVector(0.0, 0.0, 75.0);
	Car1Settings.PrincipalAxes = FQuat(0.0, 0.0, 0.0, 1.0);
	Car1Settings.Inertia = FVector(5490000.0, 22500000.0, 23490000.0);
	Car1Settings.LinearDamping = 0.0f;
	Car1Settings.AngularDamping = 0.0f;

	TrashBin1Mesh = CreateMesh(TEXT("TrashBin1"), TEXT("/Game/ESG/S6/SM_TrashBin1.SM_TrashBin1"));
	TrashBin1Settings.Location = FVector(100.0, -40.0, 0.0);
	TrashBin1Settings.Rotation = FQuat(0.0, 0.0, 0.0, 1.0);
	TrashBin1Settings.bSimulated = true;
	TrashBin1Settings.bCollides = true;
	TrashBin1Settings.bOnWheels = false;
	TrashBin1Settings.bReportsHits = false;
	TrashBin1Settings.Friction = 0.6f;
	TrashBin1Settings.Restitution = 0.2f;
	TrashBin1Settings.Mass = 15.0f;
	TrashBin1Settings.CenterOfMass = FVector(0.0, 0.0, 45.0);
	TrashBin1Settings.PrincipalAxes = FQuat(0.0, 0.0, 0.0, 1.0);
	TrashBin1Settings.Inertia = FVector(13500.0, 13500.0, 6750.0);
	TrashBin1Settings.LinearDamping = 0.05f;
	TrashBin1Settings.AngularDamping = 0.0f;

	Table1Mesh = CreateMesh(TEXT("Table1"), TEXT("/Game/ESG/S6/SM_Table1.SM_Table1"));
	Table1Settings.Location = FVector(400.0, -150.0, 0.0);
	Table1Settings.Rotation = FQuat(0.0, 0.0, 0.342897807455451, 0.939372712847379);
	Table1Settings.bSimulated = true;
	Table1Settings.bCollides = true;
	Table1Settings.bOnWheels = false;
	Table1Settings.bReportsHits = false;
	Table1Settings.Friction = 0.6f;
	Table1Settings.Restitution = 0.2f;
	Table1Settings.Mass = 20.0f;
	Table1Settings.CenterOfMass = FVector(0.0, 0.0, 37.5);
	Table1Settings.PrincipalAxes = FQuat(0.0, 0.0, 0.0, 1.0);
	Table1Settings.Inertia = FVector(20041.6666666667, 33375.0, 34666.6666666667);
	Table1Settings.LinearDamping = 0.0f;
	Table1Settings.AngularDamping = 0.0f;

	Wall1Mesh = CreateMesh(TEXT("Wall1"), TEXT("/Game/ESG/S6/SM_Wall1.SM_Wall1"));
	Wall1Settings.Location = FVector(900.0, 0.0, 0.0);
	Wall1Settings.Rotation = FQuat(0.0, 0.0, -0.149438132473599, 0.988771077936042);
	Wall1Settings.bSimulated = false;
	Wall1Settings.bCollides = true;
	Wall1Settings.bOnWheels = false;
	Wall1Settings.bReportsHits = false;
	Wall1Settings.Friction = 0.5f;
	Wall1Settings.Restitution = 0.2f;

	Lane1Mesh = CreateMesh(TEXT("Lane1"), TEXT("/Game/ESG/S6/SM_Lane1.SM_Lane1"));
	Lane1Settings.Location = FVector(0.0, 0.0, 0.0);
	Lane1Settings.Rotation = FQuat(0.0, 0.0, 0.0, 1.0);
	Lane1Settings.bSimulated = false;
	Lane1Settings.bCollides = false;
	Lane1Settings.bOnWheels = false;
	Lane1Settings.bReportsHits = false;
	Lane1Settings.Friction = 0.5f;
	Lane1Settings.Restitution = 0.2f;

	Car1Drive1.Start = 0.25;
	Car1Drive1.End = 1000000000.0;
	Car1Drive1.Speed = 600.0;
	Car1Drive1.Heading = -11.4591559026165;
	Car1Drive1.Acceleration = 150.0;
	Car1Drive1.MaxSpeed = 900.0;
	Car1Drive1.TurnRate = 2.86478897565412;
	Car1Drive1.RollRadius = 0.0;

	Table1Impulse1.Time = 0.5;
	Table1Impulse1.Impulse = FVector(-500.0, -1200.0, 3000.0);

	Table1Launch1.Time = 1.2;
	Table1Launch1.Velocity = FVector(50.0, 100.0, 200.0);
	Table1Launch1.bSetSpin = true;
	Table1Launch1.Spin = FVector(-5.72957795130823, 22.9183118052329, 114.591559026165);

	Car1Change1.Time = 1.5;
	Car1Change1.bSetLinearDamping = true;
	Car1Change1.LinearDamping = 1.8f;
	Car1Change1.bSetAngularDamping = true;
	Car1Change1.AngularDamping = 0.3f;
	Car1Change1.bSetFriction = true;
	Car1Change1.Friction = 0.35f;
}

void AEsgScene_S6::CollectBodies()
{
	AddBody(Car1Mesh, Car1Settings);
	AddProbe(FCollisionShape::MakeBox(FVector(225.0, 90.0, 75.0)), FVector(0.0, 0.0, 75.0), FQuat(0.0, 0.0, 0.0, 1.0));
	AddBody(TrashBin1Mesh, TrashBin1Settings);
	AddProbe(FCollisionShape::MakeCapsule(30.0f, 45.0f), FVector(0.0, 0.0, 45.0), FQuat(0.0, 0.0, 0.0, 1.0));
	AddBody(Table1Mesh, Table1Settings);
	AddProbe(FCollisionShape::MakeBox(FVector(60.0, 40.0, 37.5)), FVector(0.0, 0.0, 37.5), FQuat(0.0, 0.0, 0.0, 1.0));
	AddBody(Wall1Mesh, Wall1Settings);
	AddProbe(FCollisionShape::MakeBox(FVector(20.0, 400.0, 100.0)), FVector(0.0, 0.0, 100.0), FQuat(0.0, 0.0, 0.0, 1.0));
	AddBody(Lane1Mesh, Lane1Settings);
}

void AEsgScene_S6::CollectProgram()
{
	AddCommand(Car1Mesh, { TrashBin1Mesh });
	AddCommand(Table1Mesh);
	AddCommand(Table1Mesh);
	AddCommand(Car1Mesh);
	AddEvent(TEXT("hit"), { Car1Mesh }, { TrashBin1Mesh });
}

void AEsgScene_S6::DispatchProgram(double Due)
{
	RunHoldVelocity(Car1Mesh, Car1Drive1, Commands[0], Due);
	RunApplyImpulse(Table1Mesh, Table1Impulse1, Commands[1], Due);
	RunSetVelocity(Table1Mesh, Table1Launch1, Commands[2], Due);
	RunAdjustProperties(Car1Mesh, Car1Change1, Commands[3], Due);
}
