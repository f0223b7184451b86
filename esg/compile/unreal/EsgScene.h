// What every dynamic scene is played with: bodies and joints, the commands of a program, the watching
// of contacts. A scene's own class states its values, its program and its events.
// Units: cm, kg, s, degrees. Frame: Unreal's, left-handed, Z up. Place the actor at the origin.
#pragma once

#include "CoreMinimal.h"
#include "CollisionShape.h"
#include "GameFramework/Actor.h"
#include "EsgScene.generated.h"

class UPhysicalMaterial;
class UPhysicsConstraintComponent;
class UPrimitiveComponent;
class USceneComponent;
class UStaticMeshComponent;
struct FHitResult;

/** Physical values of one body. */
USTRUCT(BlueprintType)
struct FEsgBody
{
	GENERATED_BODY()

	/** Of the mesh's origin, its bottom centre [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Location = FVector::ZeroVector;

	/** Of the mesh. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FQuat Rotation = FQuat::Identity;

	/** Moves; otherwise fixed in the world. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bSimulated = true;

	/** Has collision; otherwise a decal. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bCollides = true;

	/** Coasts on the vehicle ground instead of the ground. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bOnWheels = false;

	/** Some watched contact or drive asks for its hits. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bReportsHits = false;

	/** Mass. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "kg", ClampMin = "0.000001", ClampMax = "10000000"))
	float Mass = 1.0f;

	/** In the mesh's frame [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector CenterOfMass = FVector::ZeroVector;

	/** Axes of inertia in the mesh's frame. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FQuat PrincipalAxes = FQuat::Identity;

	/** Principal moments [kg cm^2]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Inertia = FVector::OneVector;

	/** Friction coefficient, static and dynamic. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "4"))
	float Friction = 0.5f;

	/** Coefficient of restitution. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "1"))
	float Restitution = 0.2f;

	/** Per second. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "1000"))
	float LinearDamping = 0.0f;

	/** Per second. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "1000"))
	float AngularDamping = 0.0f;

	/** Round: braking slows its roll as well. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bRolls = false;

	/** Against sliding sideways. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "4"))
	double TyreFriction = 0.0;

	/** Of the tyres' push below the centre of mass. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm", ClampMin = "0"))
	double TyreDrop = 0.0;

	/** From the centre of mass to each axle. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm", ClampMin = "0"))
	double Axle = 0.0;

	/** Mass over inertia [1/cm^2]: how it leans. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double Lean = 0.0;

	/** Of the edge it falls over from its middle. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm", ClampMin = "0"))
	double TyreFoot = 0.0;

	/** How fast it then turns over it [deg/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double TipRate = 0.0;

	/** It breaks at more [kg cm/s]; 0: never. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double BreakImpulse = 0.0;
};

/** A wheel: a picture that turns. */
USTRUCT(BlueprintType)
struct FEsgWheel
{
	GENERATED_BODY()

	/** In the frame of the body's mesh [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Axle = FVector::ZeroVector;

	/** A wheel turns by what its axle goes over this. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm", ClampMin = "0.01"))
	double Radius = 1.0;
};

/** What joins two bodies. */
USTRUCT(BlueprintType)
struct FEsgJoint
{
	GENERATED_BODY()

	/** In the frame of the child's mesh [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector ChildAnchor = FVector::ZeroVector;

	/** There; X is the joint's axis. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FQuat ChildFrame = FQuat::Identity;

	/** In that of the parent's mesh, or the world [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector ParentAnchor = FVector::ZeroVector;

	/** There; the joint is at 0 where both coincide. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FQuat ParentFrame = FQuat::Identity;

	/** Whether the two bodies touch each other. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bCollides = false;

	/** Whether Lower holds. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bLower = false;

	/** Least position [deg or cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double Lower = 0.0;

	/** Whether Upper holds. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bUpper = false;

	/** Greatest; of a rope or spring its length [deg or cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double Upper = 0.0;

	/** Towards 0 [kg/s^2 or kg cm^2/s^2]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double Stiffness = 0.0;

	/** Against its speed [kg/s or kg cm^2/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double Damping = 0.0;

	/** Holds and brakes [kg cm/s^2 or times cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double Friction = 0.0;

	/** Whether a motor drives it from the start on. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bMotor = false;

	/** [deg/s or cm/s]; to a place, the greatest, 0: any. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double MotorSpeed = 0.0;

	/** Whether it drives to MotorPlace. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bMotorToPlace = false;

	/** Position that it drives to [deg or cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double MotorPlace = 0.0;

	/** Greatest [kg cm/s^2 or times cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double MotorLimit = 0.0;

	/** Whether it breaks. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bBreaks = false;

	/** What it takes at most [kg cm/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double BreakImpulse = 0.0;
};

/** Sets a velocity once. */
USTRUCT(BlueprintType)
struct FEsgSetVelocity
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Time = 0.0;

	/** Of the centre of mass [cm/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Velocity = FVector::ZeroVector;

	/** Whether Spin is set too. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bSetSpin = false;

	/** Angular velocity [deg/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Spin = FVector::ZeroVector;
};

/** Applies an impulse once. */
USTRUCT(BlueprintType)
struct FEsgApplyImpulse
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Time = 0.0;

	/** At the centre of mass [kg cm/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Impulse = FVector::ZeroVector;
};

/** Changes damping or friction once. */
USTRUCT(BlueprintType)
struct FEsgAdjustProperties
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Time = 0.0;

	/** Whether LinearDamping is set. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bSetLinearDamping = false;

	/** Per second. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "1000"))
	float LinearDamping = 0.0f;

	/** Whether AngularDamping is set. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bSetAngularDamping = false;

	/** Per second. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "1000"))
	float AngularDamping = 0.0f;

	/** Whether Friction is set. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bSetFriction = false;

	/** Friction coefficient. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "4"))
	float Friction = 0.0f;

	/** Whether Braking is set. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bSetBraking = false;

	/** Deceleration by the brakes [cm/s^2]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0", ClampMax = "100000"))
	double Braking = 0.0;
};

/** Lets another body stand in for one, in another posture. */
USTRUCT(BlueprintType)
struct FEsgChangeBody
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Time = 0.0;

	/** Number of the body that is there from then on. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	int32 Into = 0;

	/** Whether it comes to a place; else it is where the one before it was. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bPlaced = false;

	/** Where the body's own component would be then [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Place = FVector::ZeroVector;

	UPROPERTY(EditAnywhere, Category = "ESG")
	FQuat Facing = FQuat::Identity;
};

/** Drives a joint, or lets it go. */
USTRUCT(BlueprintType)
struct FEsgDriveJoint
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Time = 0.0;

	/** Whether a motor drives it from then on. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bDrives = false;

	/** [deg/s or cm/s]; to a place, the greatest, 0: any. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double Speed = 0.0;

	/** Whether it drives to Place. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bToPlace = false;

	/** Position that it drives to [deg or cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double Place = 0.0;

	/** Greatest [kg cm/s^2 or times cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double Limit = 0.0;
};

/** Drives a body until an end time or a touch. */
USTRUCT(BlueprintType)
struct FEsgHoldVelocity
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Start = 0.0;

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0"))
	double End = 0.0;

	/** At the start. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm/s", ClampMin = "-100000", ClampMax = "100000"))
	double Speed = 0.0;

	/** Yaw of the motion at the start. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "deg"))
	double Heading = 0.0;

	/** [cm/s^2], negative slows down. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double Acceleration = 0.0;

	/** Limit while speeding up. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm/s", ClampMin = "0"))
	double MaxSpeed = 0.0;

	/** Change of yaw [deg/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double TurnRate = 0.0;

	/** Of a body that rolls, else 0. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm", ClampMin = "0", ClampMax = "10000"))
	double RollRadius = 0.0;

	/** Whether Climb is held against gravity. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bFlies = false;

	/** Vertical velocity in the air. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "cm/s"))
	double Climb = 0.0;

	/** Whether it comes to its speed by and by. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bTakesTime = false;

	/** How fast to a greater one [cm/s^2]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double Gains = 0.0;

	/** How fast to a lesser one [cm/s^2]. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (ClampMin = "0"))
	double Loses = 0.0;
};

/** Moves a body along a path until it is let go, or touches. */
USTRUCT(BlueprintType)
struct FEsgGuideAlong
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Start = 0.0;

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0"))
	double End = 0.0;

	/** Change of yaw [deg/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double TurnRate = 0.0;

	/** Of the path's points since Start [s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	TArray<double> Times = {};

	/** Of the centre of mass [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	TArray<FVector> Points = {};

	/** Of the centre of mass there [cm/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	TArray<FVector> Velocities = {};
};

/** Keeps a body spinning until an end time or a touch. */
USTRUCT(BlueprintType)
struct FEsgHoldSpin
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Start = 0.0;

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0"))
	double End = 0.0;

	/** Angular velocity [deg/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Spin = FVector::ZeroVector;
};

/** A liquid that bears a body up and slows it down where it is in it. */
USTRUCT(BlueprintType)
struct FEsgBuoyUp
{
	GENERATED_BODY()

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double Start = 0.0;

	/** Since the scene started. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "s", ClampMin = "0"))
	double End = 0.0;

	/** Middle of the level of the liquid [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Center = FVector::ZeroVector;

	/** Half its length, width and depth [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Basin = FVector::ZeroVector;

	/** Half the size of the body, in its axes [cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	FVector Extents = FVector::ZeroVector;

	/** Of the length of the basin. */
	UPROPERTY(EditAnywhere, Category = "ESG", meta = (Units = "deg"))
	double Heading = 0.0;

	/** What all of the body in it adds to its vertical velocity [cm/s^2]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double Lift = 0.0;

	/** Drag that grows with the speed [1/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double LinearDrag = 0.0;

	/** Drag that grows with the square of the speed [1/cm]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double QuadraticDrag = 0.0;

	/** Of turning [1/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	double TurningDrag = 0.0;

	/** The body is a ball, whose volume is in its middle. */
	UPROPERTY(EditAnywhere, Category = "ESG")
	bool bRound = false;
};

UCLASS(Abstract)
class ESGSCENES_API AEsgScene : public AActor
{
	GENERATED_BODY()

public:
	AEsgScene();
	virtual ~AEsgScene() override;
	virtual void OnConstruction(const FTransform& Transform) override;
	virtual void Tick(float DeltaTime) override;

	/** Run the game at FixedTimeStep. */
	UPROPERTY(EditAnywhere, Category = "ESG|Simulation")
	bool bPinTimeStep = true;

	/** Step the scene was verified with. */
	UPROPERTY(EditAnywhere, Category = "ESG|Simulation", meta = (Units = "s", ClampMin = "0.0005", ClampMax = "0.05"))
	double FixedTimeStep = 0.00416666666666667;

	/** [cm/s^2], negative is down. */
	UPROPERTY(EditAnywhere, Category = "ESG|Simulation", meta = (ClampMin = "-100000", ClampMax = "0"))
	float WorldGravityZ = -981.0f;

	/** Friction coefficient of the ground. */
	UPROPERTY(EditAnywhere, Category = "ESG|Simulation", meta = (ClampMin = "0", ClampMax = "4"))
	float GroundFriction = 0.7f;

	/** Restitution of both grounds. */
	UPROPERTY(EditAnywhere, Category = "ESG|Simulation", meta = (ClampMin = "0", ClampMax = "1"))
	float GroundRestitution = 0.3f;

	/** Friction coefficient of the ground that bodies on wheels touch. */
	UPROPERTY(EditAnywhere, Category = "ESG|Simulation", meta = (ClampMin = "0", ClampMax = "4"))
	float VehicleGroundFriction = 0.0f;

	/** The scene is over after this. */
	UPROPERTY(EditAnywhere, Category = "ESG|Simulation", meta = (Units = "s", ClampMin = "0", ClampMax = "3600"))
	double SceneDuration = 0.0;

	/** A watched contact must begin by then. */
	UPROPERTY(EditAnywhere, Category = "ESG|Acceptance", meta = (Units = "s", ClampMin = "0"))
	double MaxHitTime = 15.0;

	/** Deepest overlap at a hit. */
	UPROPERTY(EditAnywhere, Category = "ESG|Acceptance", meta = (Units = "cm", ClampMin = "0"))
	double MaxHitPenetration = 5.0;

	/** Accumulated normal impulse [kg cm/s]. */
	UPROPERTY(EditAnywhere, Category = "ESG|Acceptance", meta = (ClampMin = "0"))
	double MinHitImpulse = 10.0;

	/** Over which a hit's impulse adds up. */
	UPROPERTY(EditAnywhere, Category = "ESG|Acceptance", meta = (Units = "s", ClampMin = "0"))
	double ImpulseWindow = 0.05;

	/** From a hit to its overlap check. */
	UPROPERTY(EditAnywhere, Category = "ESG|Acceptance", meta = (Units = "s", ClampMin = "0"))
	double RecheckDelay = 0.2;

	/** Overlap allowed at the start and at the check. */
	UPROPERTY(EditAnywhere, Category = "ESG|Acceptance", meta = (Units = "cm", ClampMin = "0"))
	double MaxRestPenetration = 2.0;

	/** Between an event and the one before it. */
	UPROPERTY(EditAnywhere, Category = "ESG|Acceptance", meta = (Units = "s", ClampMin = "0"))
	double MinEventGap = 0.1;

protected:
	/** What a joint leaves free. */
	enum class EJointKind : uint8 { Hinge, Slider, Ball, Fixed, Rope, Spring };

	/** A shape that penetration queries accept, in its mesh's frame. */
	struct FProbe
	{
		FCollisionShape Shape;
		FVector Center;
		FQuat Rotation;
	};

	/** A component together with its settings; Like is the body whose probes are its own. */
	struct FBodyRef
	{
		UStaticMeshComponent* Component = nullptr;
		const FEsgBody* Settings = nullptr;
		int32 Like = 0;
		TArray<FProbe> Probes{};
		double Braking = 0.0;
		/** Velocity at the beginning of the last step; so low before the first one. */
		FVector Before = FVector(0.0, 0.0, -1.0e9);
		bool bFalls = false;
		bool bTips = false;
		/** Velocities at the beginning of the last step. */
		FVector LastVelocity = FVector::ZeroVector;
		FVector LastSpin = FVector::ZeroVector;
	};

	/** A wheel, how far it has turned and how fast it turns. */
	struct FTurningWheel
	{
		UStaticMeshComponent* Component = nullptr;
		UStaticMeshComponent* Body = nullptr;
		const FEsgWheel* Settings = nullptr;
		bool bStarted = false;
		FVector Axle = FVector::ZeroVector;
		FVector Ahead = FVector::ZeroVector;
		double Rise = 0.0;
		double Rate = 0.0;
		double Angle = 0.0;
	};

	/** A joint together with its settings and the motor that is on. */
	struct FJointRef
	{
		UPhysicsConstraintComponent* Constraint = nullptr;
		UPhysicsConstraintComponent* Return = nullptr;
		UPrimitiveComponent* Child = nullptr;
		UPrimitiveComponent* Parent = nullptr;
		const FEsgJoint* Settings = nullptr;
		EJointKind Kind = EJointKind::Fixed;
		bool bMotor = false;
		bool bToPlace = false;
		bool bGone = false;
		double Speed = 0.0;
		double Place = 0.0;
		double Limit = 0.0;
		TArray<double> Given{};
	};

	/** A body that breaks, and its fragments with where they lie in it. */
	struct FBrittle
	{
		int32 Whole = 0;
		TArray<int32> Pieces{};
		TArray<FVector> Centers{};
		TArray<FQuat> Turns{};
		TArray<UPrimitiveComponent*> Touched{};
		TArray<double> Taken{};
		double Step = 0.0;
		bool bBroken = false;
	};

	/** A body and those that stand in for it, with where they lie in it. */
	struct FStance
	{
		TArray<int32> Bodies{};
		TArray<FVector> Places{};
		TArray<FQuat> Turns{};
		int32 Now = 0;
	};

	/** Progress of one command of the program. */
	struct FCommandState
	{
		UPrimitiveComponent* Body = nullptr;
		TArray<UPrimitiveComponent*> EndsAtTouchOf{};
		const TCHAR* Kind = TEXT("");
		bool bActive = false;
		bool bDone = false;
		bool bDrives = false;
	};

	/** Two bodies in contact, on probation until their impulse is large enough. */
	struct FTouch
	{
		UPrimitiveComponent* First = nullptr;
		UPrimitiveComponent* Second = nullptr;
		double Time = 0.0;
		double Impulse = 0.0;
		double Penetration = 0.0;
	};

	/** A watched contact and how far it has come. */
	struct FWatchedEvent
	{
		FString Id;
		TArray<UPrimitiveComponent*> First{};
		TArray<UPrimitiveComponent*> Second{};
		TArray<int32> After{};
		TArray<FTouch> Touches{};
		FTouch Hit{};
		bool bHit = false;
		bool bChecked = false;
		bool bComplete = false;
	};

	virtual void BeginPlay() override;

	/** Adds what there is: a scene's class states its bodies, wheels, joints and fragments. */
	virtual void CollectBodies();
	/** Adds the commands of the program, in their order, and the contacts that are watched. */
	virtual void CollectProgram();
	/** Runs the commands, those that are due by then. */
	virtual void DispatchProgram(double Due);

	UStaticMeshComponent* CreateMesh(const TCHAR* Name, const TCHAR* AssetPath);
	UStaticMeshComponent* CreateWheel(
		UStaticMeshComponent* Body, const TCHAR* Name, const TCHAR* AssetPath);
	UPhysicsConstraintComponent* CreateConstraint(const TCHAR* Name);

	/** A body with probes of its own, or with those of the body with the number Like. */
	void AddBody(UStaticMeshComponent* Component, const FEsgBody& Settings, int32 Like = INDEX_NONE);
	/** A probe of the body that was added last. */
	void AddProbe(const FCollisionShape& Shape, const FVector& Center, const FQuat& Rotation);
	void AddWheel(UStaticMeshComponent* Component, UStaticMeshComponent* Body, const FEsgWheel& Settings);
	void AddJoint(
		EJointKind Kind, const FEsgJoint& Settings, UPhysicsConstraintComponent* Constraint,
		UPhysicsConstraintComponent* Return, UPrimitiveComponent* Child, UPrimitiveComponent* Parent);
	/** The body with the number Whole breaks into those with the numbers Pieces. */
	void AddBrittle(int32 Whole, const TArray<int32>& Pieces);
	/** The body with the number Body is those with the numbers Postures in other postures. */
	void AddStance(int32 Body, const TArray<int32>& Postures);
	void AddCommand(
		UPrimitiveComponent* Body = nullptr,
		const TArray<UPrimitiveComponent*>& EndsAtTouchOf = TArray<UPrimitiveComponent*>());
	/** Any of First hits any of Second, once the events with the numbers After are complete. */
	void AddEvent(
		const TCHAR* Id, const TArray<UPrimitiveComponent*>& First, const TArray<UPrimitiveComponent*>& Second,
		const TArray<int32>& After = TArray<int32>());

	void RunSetVelocity(UPrimitiveComponent* Body, const FEsgSetVelocity& Command, FCommandState& State, double Due);
	void RunApplyImpulse(UPrimitiveComponent* Body, const FEsgApplyImpulse& Command, FCommandState& State, double Due);
	void RunAdjustProperties(
		UPrimitiveComponent* Body, const FEsgAdjustProperties& Command, FCommandState& State, double Due);
	void RunChangeBody(UPrimitiveComponent* Body, const FEsgChangeBody& Command, FCommandState& State, double Due);
	void RunDriveJoint(FJointRef& Joint, const FEsgDriveJoint& Command, FCommandState& State, double Due);
	void RunHoldVelocity(UPrimitiveComponent* Body, const FEsgHoldVelocity& Command, FCommandState& State, double Due);
	void RunGuideAlong(UPrimitiveComponent* Body, const FEsgGuideAlong& Command, FCommandState& State, double Due);
	void RunHoldSpin(UPrimitiveComponent* Body, const FEsgHoldSpin& Command, FCommandState& State, double Due);
	void RunBuoyUp(UPrimitiveComponent* Body, const FEsgBuoyUp& Command, FCommandState& State, double Due);
	/** Of scenes with brakes or tyres: before their commands, and after them. */
	void FindFalling(double Due);
	void ApplyTraction(double Due);

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<USceneComponent> SceneOrigin;

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<UStaticMeshComponent> GroundPlane;

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<UStaticMeshComponent> VehicleGroundPlane;

	TArray<FBodyRef> Bodies;
	TArray<FTurningWheel> Wheels;
	TArray<FJointRef> Joints;
	TArray<FBrittle> Brittles;
	TArray<FStance> Stances;
	TArray<FCommandState> Commands;
	TArray<FWatchedEvent> Events;
	double SceneTime = 0.0;
	bool bFinished = false;

private:
	UPROPERTY(Transient)
	TArray<TObjectPtr<UPhysicalMaterial>> Materials;

	UFUNCTION()
	void OnBodyHit(
		UPrimitiveComponent* HitComponent, AActor* OtherActor, UPrimitiveComponent* OtherComp,
		FVector NormalImpulse, const FHitResult& Hit);

	void Collect();
	void PinSimulation();
	void ConfigureGround(UStaticMeshComponent* Plane, bool bForWheels);
	void ConfigureBody(UStaticMeshComponent* Body, const FEsgBody& Settings);
	void ConfigureWheel(UStaticMeshComponent* Wheel, const FEsgWheel& Settings);
	void ConfigureJoint(FJointRef& Joint);
	void ConfigureReturn(FJointRef& Joint);
	void ConfigureBrittle(FBrittle& Brittle);
	void ConfigureStance(FStance& Stance);
	void PutIn(const FBodyRef& Body, const FVector& Place, const FQuat& Turn);
	void ApplyMassProperties(UStaticMeshComponent* Body, const FEsgBody& Settings);
	UPhysicalMaterial* CreateMaterial(float Friction, float Restitution);
	static FVector PathPoint(const FEsgGuideAlong& Command, double Elapsed);
	bool IsDriven(const UPrimitiveComponent* Body) const;
	double ApplyBrakes(const FBodyRef& Body, double Loss);
	void ApplyTyres(const FBodyRef& Body, double Weight, double Taken);
	void TipOver(FBodyRef& Body);
	void TurnWheels(double Step);
	void DriveJoints(double Step);
	void ApplySpring(FJointRef& Joint, double Step);
	double PositionOf(const FJointRef& Joint) const;
	double EaseOf(UPrimitiveComponent* Body, const FVector& At, const FVector& Line) const;
	FVector SpeedAt(UPrimitiveComponent* Body, const FVector& At) const;
	void PushAt(UPrimitiveComponent* Body, const FVector& At, const FVector& Impulse);
	bool AreJoined(const UPrimitiveComponent* First, const UPrimitiveComponent* Second) const;
	void TakeBlow(const UPrimitiveComponent* Body, UPrimitiveComponent* Other, double Impulse);
	void BreakBodies(double Step);
	void Shatter(FBrittle& Brittle, double Share, double Step);
	void TakeBack(FBodyRef& Body, double Share, double Step) const;
	void RememberSpeeds();
	static void PutAway(UStaticMeshComponent* Body, bool bSimulated);
	void EndDrivesAtTouch(const UPrimitiveComponent* First, const UPrimitiveComponent* Second);
	void WatchTouch(FWatchedEvent& Event, const FTouch& Touch);
	void RecheckEvents();
	void CheckLayout();
	double PenetrationOf(const FBodyRef& First, const FBodyRef& Second) const;
	const FBodyRef* FindBody(const UPrimitiveComponent* Component) const;
};
