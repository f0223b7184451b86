// Dynamic scene S6: bodies, control program and contact events.
// Units: cm, kg, s, degrees. Frame: Unreal's, left-handed, Z up. Place the actor at the origin.
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "EsgScene_S6.generated.h"

class UPhysicalMaterial;
class UPrimitiveComponent;
class USceneComponent;
class UStaticMeshComponent;
struct FHitResult;

/** Physical values of one body. */
USTRUCT(BlueprintType)
struct FEsgScene_S6Body
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
};

/** Sets a velocity once. */
USTRUCT(BlueprintType)
struct FEsgScene_S6SetVelocity
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
struct FEsgScene_S6ApplyImpulse
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
struct FEsgScene_S6AdjustProperties
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
};

/** Drives a body until an end time or a touch. */
USTRUCT(BlueprintType)
struct FEsgScene_S6HoldVelocity
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
};

UCLASS()
class ESGSCENES_API AEsgScene_S6 : public AActor
{
	GENERATED_BODY()

public:
	AEsgScene_S6();
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
	double SceneDuration = 3.0;

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

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Car1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgScene_S6Body Car1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> TrashBin1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgScene_S6Body TrashBin1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Table1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgScene_S6Body Table1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Wall1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgScene_S6Body Wall1Settings;

	UPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")
	TObjectPtr<UStaticMeshComponent> Lane1Mesh;

	UPROPERTY(EditAnywhere, Category = "ESG|Bodies")
	FEsgScene_S6Body Lane1Settings;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgScene_S6HoldVelocity Car1Drive1;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgScene_S6ApplyImpulse Table1Impulse1;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgScene_S6SetVelocity Table1Launch1;

	UPROPERTY(EditAnywhere, Category = "ESG|Program")
	FEsgScene_S6AdjustProperties Car1Change1;

protected:
	virtual void BeginPlay() override;

private:
	/** A component together with its settings. */
	struct FBodyRef
	{
		UStaticMeshComponent* Component = nullptr;
		const FEsgScene_S6Body* Settings = nullptr;
		int32 Shape = 0;
	};

	/** Progress of one command of the program. */
	struct FCommandState
	{
		bool bActive = false;
		bool bDone = false;
		UPrimitiveComponent* Body = nullptr;
		TArray<UPrimitiveComponent*> EndsAtTouchOf;
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
		TArray<UPrimitiveComponent*> First;
		TArray<UPrimitiveComponent*> Second;
		TArray<int32> After;
		TArray<FTouch> Touches;
		FTouch Hit;
		bool bHit = false;
		bool bChecked = false;
		bool bComplete = false;
	};

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<USceneComponent> SceneOrigin;

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<UStaticMeshComponent> GroundPlane;

	UPROPERTY(VisibleAnywhere, Category = "ESG")
	TObjectPtr<UStaticMeshComponent> VehicleGroundPlane;

	UPROPERTY(Transient)
	TArray<TObjectPtr<UPhysicalMaterial>> Materials;

	UFUNCTION()
	void OnBodyHit(
		UPrimitiveComponent* HitComponent, AActor* OtherActor, UPrimitiveComponent* OtherComp,
		FVector NormalImpulse, const FHitResult& Hit);

	UStaticMeshComponent* CreateMesh(const TCHAR* Name, const TCHAR* AssetPath);
	void ConfigureGround(UStaticMeshComponent* Plane, bool bForWheels);
	void ConfigureBody(UStaticMeshComponent* Body, const FEsgScene_S6Body& Settings);
	void ApplyMassProperties(UStaticMeshComponent* Body, const FEsgScene_S6Body& Settings);
	UPhysicalMaterial* CreateMaterial(float Friction, float Restitution);
	void CollectBodies();
	void CollectEvents();
	void PinSimulation();
	void DispatchProgram(double Due);
	void RunSetVelocity(UPrimitiveComponent* Body, const FEsgScene_S6SetVelocity& Command, FCommandState& State, double Due);
	void RunApplyImpulse(UPrimitiveComponent* Body, const FEsgScene_S6ApplyImpulse& Command, FCommandState& State, double Due);
	void RunAdjustProperties(UPrimitiveComponent* Body, const FEsgScene_S6AdjustProperties& Command, FCommandState& State, double Due);
	void RunHoldVelocity(UPrimitiveComponent* Body, const FEsgScene_S6HoldVelocity& Command, FCommandState& State, double Due);
	void EndDrivesAtTouch(const UPrimitiveComponent* First, const UPrimitiveComponent* Second);
	void WatchTouch(FWatchedEvent& Event, const FTouch& Touch);
	void RecheckEvents();
	void CheckLayout();
	double PenetrationOf(const FBodyRef& First, const FBodyRef& Second) const;
	const FBodyRef* FindBody(const UPrimitiveComponent* Component) const;

	TArray<FBodyRef> Bodies;
	TArray<FCommandState> Commands;
	TArray<FWatchedEvent> Events;
	double SceneTime = 0.0;
	bool bFinished = false;
};
