// A stand-in for the part of Unreal's API that an emitted scene class uses. Own code, no engine
// source. It checks what the engine would reject or silently ignore (Shim::Fatal), and hands the
// physical scene that the class describes to a backend (struct Backend, all values as the class
// states them: cm, kg, left-handed). It does no physics itself.
#ifndef ESG_UE_SHIM_H
#define ESG_UE_SHIM_H

// No <string>, <memory> or <algorithm>: reading them takes a compiler longer than a class does.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <strings.h>
#include <vector>

typedef int32_t int32;
typedef uint8_t uint8;
typedef char TCHAR;

#define TEXT(x) x
#define UCLASS(...)
#define USTRUCT(...)
#define UPROPERTY(...)
#define UFUNCTION(...)
#define ESGSCENES_API

class AActor;
class UObject;
class UPrimitiveComponent;
class USceneComponent;
class UPhysicsConstraintComponent;

namespace Shim
{
	enum class EPhase { Idle, Constructing, Configuring, Playing };

	/** A text that owns its characters. */
	class FText
	{
	public:
		FText(const char* In = "");
		FText(const FText& Other);
		FText& operator=(const FText& Other);
		~FText();
		const char* c_str() const { return Data; }
		friend FText operator+(const FText& A, const FText& B);

	private:
		char* Data;
	};

	FText operator+(const FText& A, const FText& B);

	struct FFatal
	{
		FText Message;
	};

	[[noreturn]] void Fatal(const FText& Message);

	[[noreturn]] void OutOfBounds(int32 Index, int32 Count);

	/** One body as the class leaves it; vectors and quaternions (x, y, z, w) as Unreal has them. */
	struct FBody
	{
		const char* Name;
		const char* Asset;
		double Location[3];
		double Rotation[4];
		double Scale[3];
		double CenterOfMass[3];
		double MassRotation[4];
		double Inertia[3];
		double Mass;
		double LinearDamping;
		double AngularDamping;
		double Friction;
		double Restitution;
		double MaxSpin;
		int Collides;
		int Simulates;
		int ObjectType;
		uint32_t Blocks;
		int Notifies;
		int CCD;
		int HasMassFrame;
		int HasMaterial;
		int Movable;
		int Dormant;
	};

	/** One constraint as the class leaves it: frames in the components' or the world's frame. */
	struct FConstraint
	{
		const char* Name;
		int First;
		int Second;
		double Location[2][3];
		double Rotation[2][4];
		int Linear[3];
		double LinearLimit[3];
		/** Twist, first swing, second swing. */
		int Angular[3];
		double AngularLimit[3];
		int Collides;
		double BreakForce;
		int DrawsBack;
		double Stiffness;
		double Damping;
	};

	/** Filled by the host before the class is created. */
	struct Backend
	{
		int (*Asset)(const char* Path, double* Bounds);
		void (*Log)(const char* Category, const char* Verbosity, const char* Text);
		void (*GetPose)(int Body, double* Location, double* Rotation);
		void (*GetVelocity)(int Body, double* Linear, double* Angular);
		void (*SetVelocity)(int Body, const double* Linear);
		void (*SetSpin)(int Body, const double* Angular);
		void (*Impulse)(int Body, const double* Impulse);
		void (*SetDamping)(int Body, double Linear, double Angular);
		void (*SetMaterial)(int Body, double Friction, double Restitution);
		double (*Penetration)(int Body, int Kind, const double* Size, const double* Location, const double* Rotation);
		void (*Drive)(int Constraint, int Acts, double Speed, double Limit);
		void (*Present)(int Body, int There, const double* Location, const double* Rotation);
	};

	struct FState
	{
		Backend* Host = nullptr;
		EPhase Phase = EPhase::Idle;
		double GravityZ = -980.0;
		bool bGravitySet = false;
		bool bFixedStep = false;
		double FixedStep = 0.0;
		/** Grows when the host steps: what was read of bodies before holds until then. */
		uint64_t Moment = 1;
		/** Owned. */
		std::vector<UObject*> Pool;
		std::vector<UPrimitiveComponent*> Bodies;
		std::vector<UPhysicsConstraintComponent*> Constraints;
	};

	FState& State();

	/** Destroys what was made, for the next class. */
	void Reset();

	void Log(const char* Category, const char* Verbosity, const char* Format, ...) __attribute__((format(printf, 3, 4)));
}

#define DEFINE_LOG_CATEGORY_STATIC(Category, Default, CompileTime) [[maybe_unused]] static const char* const Category = #Category

namespace ELogVerbosity { enum Type { Fatal, Error, Warning, Display, Log, Verbose, VeryVerbose }; }
#define UE_LOG(Category, Verbosity, Format, ...) \
	do { static_cast<void>(ELogVerbosity::Verbosity); Shim::Log(Category, #Verbosity, Format __VA_OPT__(,) __VA_ARGS__); } while (0)

struct FName
{
	Shim::FText Text;
	FName() = default;
	FName(const char* InText) : Text(InText) {}
};
inline const FName NAME_None{};

struct FString
{
	Shim::FText Text;
	FString() = default;
	FString(const char* InText) : Text(InText) {}
	const TCHAR* operator*() const { return Text.c_str(); }
};

struct FMath
{
	template <class T> static T Abs(T V) { return V < 0 ? -V : V; }
	template <class T> static T Max(T A, T B) { return A > B ? A : B; }
	template <class T> static T Min(T A, T B) { return A < B ? A : B; }
	template <class T> static T Clamp(T V, T Low, T High) { return Max(Low, Min(V, High)); }
	template <class T> static T Square(T V) { return V * V; }
	static double Sqrt(double V) { return std::sqrt(V); }
	static double Sin(double V) { return std::sin(V); }
	static double Cos(double V) { return std::cos(V); }
	static double Exp(double V) { return std::exp(V); }
	static double Atan2(double Y, double X) { return std::atan2(Y, X); }
	static double UnwindDegrees(double V)
	{
		while (V > 180.0)
		{
			V -= 360.0;
		}
		while (V < -180.0)
		{
			V += 360.0;
		}
		return V;
	}
	static double DegreesToRadians(double V) { return V * (M_PI / 180.0); }
	static double RadiansToDegrees(double V) { return V * (180.0 / M_PI); }
};

struct FVector
{
	double X = 0.0, Y = 0.0, Z = 0.0;
	FVector() = default;
	explicit FVector(double V) : X(V), Y(V), Z(V) {}
	FVector(double InX, double InY, double InZ) : X(InX), Y(InY), Z(InZ) {}
	FVector operator+(const FVector& O) const { return FVector(X + O.X, Y + O.Y, Z + O.Z); }
	FVector operator-(const FVector& O) const { return FVector(X - O.X, Y - O.Y, Z - O.Z); }
	FVector operator-() const { return FVector(-X, -Y, -Z); }
	FVector operator*(double S) const { return FVector(X * S, Y * S, Z * S); }
	FVector operator/(double S) const { return FVector(X / S, Y / S, Z / S); }
	FVector operator*(const FVector& O) const { return FVector(X * O.X, Y * O.Y, Z * O.Z); }
	double Size() const { return std::sqrt(X * X + Y * Y + Z * Z); }
	static double DotProduct(const FVector& A, const FVector& B) { return A.X * B.X + A.Y * B.Y + A.Z * B.Z; }
	static FVector CrossProduct(const FVector& A, const FVector& B)
	{
		return FVector(A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z, A.X * B.Y - A.Y * B.X);
	}
	static const FVector ZeroVector;
	static const FVector OneVector;
};
inline const FVector FVector::ZeroVector{};
inline const FVector FVector::OneVector{1.0};

struct FQuat
{
	double X = 0.0, Y = 0.0, Z = 0.0, W = 1.0;
	FQuat() = default;
	FQuat(double InX, double InY, double InZ, double InW) : X(InX), Y(InY), Z(InZ), W(InW) {}
	FQuat operator*(const FQuat& B) const
	{
		return FQuat(
			W * B.X + X * B.W + Y * B.Z - Z * B.Y,
			W * B.Y - X * B.Z + Y * B.W + Z * B.X,
			W * B.Z + X * B.Y - Y * B.X + Z * B.W,
			W * B.W - X * B.X - Y * B.Y - Z * B.Z);
	}
	FVector RotateVector(const FVector& V) const
	{
		const FVector U(X, Y, Z);
		const FVector T = FVector::CrossProduct(U, V) * 2.0;
		return V + T * W + FVector::CrossProduct(U, T);
	}
	FQuat Inverse() const { return FQuat(-X, -Y, -Z, W); }
	static const FQuat Identity;
};
inline const FQuat FQuat::Identity{};

/** Rotation then translation; components of emitted classes have no scale but the ground's. */
struct FTransform
{
	FQuat Rotation;
	FVector Translation;
	FTransform() = default;
	FTransform(const FQuat& InRotation, const FVector& InTranslation) : Rotation(InRotation), Translation(InTranslation) {}
	/** First this transform, then the other. */
	FTransform operator*(const FTransform& After) const
	{
		return FTransform(After.Rotation * Rotation, After.Rotation.RotateVector(Translation) + After.Translation);
	}
	FVector GetLocation() const { return Translation; }
	FQuat GetRotation() const { return Rotation; }
	bool Equals(const FTransform& O, double Tolerance = 1e-4) const
	{
		const double Turn = 1.0 - std::fabs(Rotation.X * O.Rotation.X + Rotation.Y * O.Rotation.Y + Rotation.Z * O.Rotation.Z + Rotation.W * O.Rotation.W);
		return (Translation - O.Translation).Size() <= Tolerance && Turn <= Tolerance;
	}
	static const FTransform Identity;
};
inline const FTransform FTransform::Identity{};

struct FBox
{
	FVector Min, Max;
	bool Intersect(const FBox& O) const
	{
		return Min.X <= O.Max.X && O.Min.X <= Max.X && Min.Y <= O.Max.Y && O.Min.Y <= Max.Y && Min.Z <= O.Max.Z && O.Min.Z <= Max.Z;
	}
};

template <class T> struct TObjectPtr
{
	T* Pointer = nullptr;
	TObjectPtr() = default;
	TObjectPtr(T* InPointer) : Pointer(InPointer) {}
	T* operator->() const
	{
		if (!Pointer)
		{
			Shim::Fatal("null TObjectPtr is used");
		}
		return Pointer;
	}
	operator T*() const { return Pointer; }
	T* Get() const { return Pointer; }
};

/** Written by hand because instantiating std::vector for every class's types dominates compile time. */
template <class T> class TArray
{
public:
	TArray() = default;
	TArray(std::initializer_list<T> Init)
	{
		for (const T& Item : Init)
		{
			Add(Item);
		}
	}
	TArray(const TArray& Other)
	{
		for (int32 Index = 0; Index < Other.Count; ++Index)
		{
			Add(Other.Data[Index]);
		}
	}
	TArray& operator=(TArray Other)
	{
		std::swap(Data, Other.Data);
		std::swap(Count, Other.Count);
		std::swap(Room, Other.Room);
		return *this;
	}
	~TArray() { delete[] Data; }
	int32 Add(const T& Item)
	{
		const T Kept = Item;
		Reserve(Count + 1);
		Data[Count] = Kept;
		return Count++;
	}
	void Reset() { *this = TArray(); }
	void SetNum(int32 Wanted)
	{
		Reserve(Wanted);
		for (int32 Index = Wanted; Index < Count; ++Index)
		{
			Data[Index] = T();
		}
		Count = Wanted;
	}
	int32 Num() const { return Count; }
	T& Last() { return Data[Checked(Count - 1)]; }
	T& operator[](int32 Index) { return Data[Checked(Index)]; }
	const T& operator[](int32 Index) const { return Data[Checked(Index)]; }
	template <class U> bool Contains(const U& Item) const
	{
		for (int32 Index = 0; Index < Count; ++Index)
		{
			if (Data[Index] == Item)
			{
				return true;
			}
		}
		return false;
	}
	T* begin() { return Data; }
	T* end() { return Data + Count; }
	const T* begin() const { return Data; }
	const T* end() const { return Data + Count; }

private:
	int32 Checked(int32 Index) const
	{
		if (Index < 0 || Index >= Count)
		{
			Shim::OutOfBounds(Index, Count);
		}
		return Index;
	}
	void Reserve(int32 Wanted)
	{
		if (Wanted <= Room)
		{
			return;
		}
		const int32 Larger = Wanted > 2 * Room ? Wanted : 2 * Room;
		T* Moved = new T[static_cast<size_t>(Larger)]();
		for (int32 Index = 0; Index < Count; ++Index)
		{
			Moved[Index] = Data[Index];
		}
		delete[] Data;
		Data = Moved;
		Room = Larger;
	}
	T* Data = nullptr;
	int32 Count = 0;
	int32 Room = 0;
};

namespace EComponentMobility { enum Type { Static, Stationary, Movable }; }
namespace ECollisionEnabled { enum Type { NoCollision, QueryOnly, PhysicsOnly, QueryAndPhysics }; }
namespace EFrictionCombineMode { enum Type { Average, Min, Multiply, Max }; }
enum { INDEX_NONE = -1 };
enum ECollisionChannel { ECC_WorldStatic, ECC_WorldDynamic, ECC_Pawn, ECC_Visibility, ECC_Camera, ECC_PhysicsBody, ECC_Vehicle, ECC_Destructible };
enum ECollisionResponse { ECR_Ignore, ECR_Overlap, ECR_Block };
enum ETickingGroup { TG_PrePhysics, TG_StartPhysics, TG_DuringPhysics, TG_EndPhysics, TG_PostPhysics };

class UObject
{
public:
	virtual ~UObject() = default;
	FString GetName() const { return FString(ShimName.c_str()); }
	Shim::FText ShimName;
};

class UStaticMesh : public UObject
{
public:
	/** Half extents and centre of the mesh's box in its own frame [cm]. */
	double ShimBounds[6] = {};
};

class UPhysicalMaterial : public UObject
{
public:
	float Friction = 0.7f;
	float StaticFriction = 0.0f;
	float Restitution = 0.3f;
	bool bOverrideFrictionCombineMode = false;
	EFrictionCombineMode::Type FrictionCombineMode = EFrictionCombineMode::Average;
	bool bOverrideRestitutionCombineMode = false;
	EFrictionCombineMode::Type RestitutionCombineMode = EFrictionCombineMode::Average;
};

template <class T> T* NewObject(UObject* Outer)
{
	if (!Outer)
	{
		Shim::Fatal("NewObject without an outer");
	}
	if (Shim::State().Phase == Shim::EPhase::Constructing)
	{
		Shim::Fatal("NewObject in a constructor; use CreateDefaultSubobject");
	}
	T* Result = new T();
	Shim::State().Pool.push_back(Result);
	return Result;
}

namespace ConstructorHelpers
{
	template <class T> struct FObjectFinder
	{
		T* Object = nullptr;
		explicit FObjectFinder(const TCHAR* Path)
		{
			if (Shim::State().Phase != Shim::EPhase::Constructing)
			{
				Shim::Fatal("FObjectFinder outside a constructor");
			}
			T* Found = new T();
			Shim::State().Pool.push_back(Found);
			if (Shim::State().Host->Asset(Path, Found->ShimBounds))
			{
				Found->ShimName = Path;
				Object = Found;
			}
		}
		bool Succeeded() const { return Object != nullptr; }
	};
}

struct FMTDResult
{
	FVector Direction;
	float Distance = 0.0f;
};

struct FCollisionShape
{
	int Kind = 0;
	double Size[3] = {};
	static FCollisionShape MakeBox(const FVector& Half) { return Make(0, Half.X, Half.Y, Half.Z); }
	static FCollisionShape MakeSphere(float Radius) { return Make(1, Radius, Radius, Radius); }
	/** Unreal's half height includes the cap. */
	static FCollisionShape MakeCapsule(float Radius, float HalfHeight)
	{
		return Make(2, Radius, Radius, FMath::Max(0.0, static_cast<double>(HalfHeight) - static_cast<double>(Radius)));
	}

private:
	static FCollisionShape Make(int InKind, double X, double Y, double Z)
	{
		FCollisionShape Shape;
		Shape.Kind = InKind;
		Shape.Size[0] = X;
		Shape.Size[1] = Y;
		Shape.Size[2] = Z;
		return Shape;
	}
};

enum class ETeleportType : uint8 { None, TeleportPhysics, ResetPhysics };

struct FHitResult
{
	bool bBlockingHit = false;
	FVector Location, ImpactPoint, Normal, ImpactNormal;
	float PenetrationDepth = 0.0f;
};

class FComponentHitSignature
{
public:
	/** Of the object's own class; a plain struct compiles in a fraction of std::function's time. */
	using FFunction = void (UObject::*)(UPrimitiveComponent*, AActor*, UPrimitiveComponent*, FVector, const FHitResult&);
	struct FHandler
	{
		UObject* Object;
		FFunction Function;
		void operator()(UPrimitiveComponent* Self, AActor* Actor, UPrimitiveComponent* Other, FVector Impulse, const FHitResult& Hit) const
		{
			(Object->*Function)(Self, Actor, Other, Impulse, Hit);
		}
	};
	template <class C>
	void ShimAdd(C* Object, void (C::*Function)(UPrimitiveComponent*, AActor*, UPrimitiveComponent*, FVector, const FHitResult&))
	{
		ShimBind({Object, static_cast<FFunction>(Function)});
	}
	void ShimBind(FHandler Handler)
	{
		if (!Handlers.empty())
		{
			Shim::Fatal("AddDynamic twice on the same event");
		}
		Handlers.push_back(Handler);
	}
	std::vector<FHandler> Handlers;
};
#define AddDynamic(Object, Function) ShimAdd(Object, Function)

class USceneComponent : public UObject
{
public:
	void SetupAttachment(USceneComponent* Parent)
	{
		if (Shim::State().Phase != Shim::EPhase::Constructing)
		{
			Shim::Fatal("SetupAttachment outside the constructor of " + ShimName);
		}
		if (!Parent)
		{
			Shim::Fatal("SetupAttachment of " + ShimName + " to nothing");
		}
		ShimParent = Parent;
	}
	virtual void SetMobility(EComponentMobility::Type Mobility)
	{
		if (Mobility == EComponentMobility::Static && ShimParent && ShimParent->ShimMobility != EComponentMobility::Static)
		{
			Shim::Fatal("static " + ShimName + " under a parent that is not static: Unreal refuses the attachment");
		}
		ShimMobility = Mobility;
	}
	void SetRelativeLocationAndRotation(const FVector& Location, const FQuat& Rotation)
	{
		if (Shim::State().Phase == Shim::EPhase::Playing && ShimMobility != EComponentMobility::Movable)
		{
			Shim::Fatal("moving " + ShimName + ", which is not Movable, in play");
		}
		const double Norm = Rotation.X * Rotation.X + Rotation.Y * Rotation.Y + Rotation.Z * Rotation.Z + Rotation.W * Rotation.W;
		if (!(std::fabs(Norm - 1.0) < 1e-6))
		{
			Shim::Fatal("rotation of " + ShimName + " is no unit quaternion");
		}
		ShimPlaced = true;
		ShimLocation = Location;
		ShimRotation = Rotation;
	}
	void SetRelativeScale3D(const FVector& Scale) { ShimScale = Scale; }
	void SetHiddenInGame(bool bHidden) { ShimHidden = bHidden; }
	void SetVisibility(bool bVisible, bool = false) { ShimHidden = !bVisible; }
	virtual FTransform GetComponentTransform() const { return FTransform(ShimRotation, ShimLocation); }

	FVector ShimLocation, ShimScale{1.0};
	FQuat ShimRotation;
	USceneComponent* ShimParent = nullptr;
	EComponentMobility::Type ShimMobility = EComponentMobility::Movable;
	bool ShimPlaced = false, ShimHidden = false;
};

struct FPhysicsActorHandle
{
	class FBodyInstance* Body = nullptr;
};

class FBodyInstance
{
public:
	FPhysicsActorHandle& GetPhysicsActorHandle() { return Handle; }
	const FPhysicsActorHandle& GetPhysicsActorHandle() const { return Handle; }
	void SetInertiaConditioningEnabled(bool bEnabled) { ShimConditioning = bEnabled; }

	FPhysicsActorHandle Handle{this};
	bool ShimConditioning = true, ShimHasFrame = false, ShimHasInertia = false, ShimWriting = false;
	FTransform ShimFrame;
	FVector ShimInertia;
};

struct FPhysicsCommand
{
	template <class F> static bool ExecuteWrite(FPhysicsActorHandle& Handle, F&& Function)
	{
		Handle.Body->ShimWriting = true;
		Function(Handle);
		Handle.Body->ShimWriting = false;
		return true;
	}
};

struct FPhysicsInterface
{
	static void SetComLocalPose_AssumesLocked(const FPhysicsActorHandle& Handle, const FTransform& Pose)
	{
		Locked(Handle);
		Handle.Body->ShimFrame = Pose;
		Handle.Body->ShimHasFrame = true;
	}
	// Not const, as in Unreal 5: a lambda that takes the handle by const reference does not compile.
	static void SetMassSpaceInertiaTensor_AssumesLocked(FPhysicsActorHandle& Handle, const FVector& Inertia)
	{
		Locked(Handle);
		if (!(Inertia.X > 0.0 && Inertia.Y > 0.0 && Inertia.Z > 0.0))
		{
			Shim::Fatal("inertia must be positive");
		}
		Handle.Body->ShimInertia = Inertia;
		Handle.Body->ShimHasInertia = true;
	}

private:
	static void Locked(const FPhysicsActorHandle& Handle)
	{
		if (!Handle.Body->ShimWriting)
		{
			Shim::Fatal("physics body is changed outside FPhysicsCommand::ExecuteWrite");
		}
	}
};

class UPrimitiveComponent : public USceneComponent
{
public:
	FComponentHitSignature OnComponentHit;

	void SetSimulatePhysics(bool bSimulate)
	{
		if (bSimulate && ShimMobility != EComponentMobility::Movable)
		{
			Shim::Fatal("SetSimulatePhysics on " + ShimName + ", which is not Movable");
		}
		ShimSimulates = bSimulate;
		ShimSimulateSet = true;
		ShimComeOrGo();
	}
	bool IsSimulatingPhysics(FName = NAME_None) const { return ShimSimulates; }
	bool IsCollisionEnabled() const { return ShimCollides; }
	/** Moves what is not there, so that it comes in elsewhere. */
	void SetWorldLocationAndRotation(
		FVector Location, const FQuat& Rotation, bool bSweep, FHitResult*, ETeleportType Teleport)
	{
		if (bSweep || Teleport != ETeleportType::TeleportPhysics || (ShimLive && ShimIsThere()))
		{
			Shim::Fatal("SetWorldLocationAndRotation on " + ShimName + " in play is not replayed");
		}
		SetRelativeLocationAndRotation(Location, Rotation);
	}
	/** Whether the physics has it: what moves only while it collides and simulates. */
	bool ShimIsThere() const
	{
		return ShimCollides && (ShimSimulates || ShimMobility != EComponentMobility::Movable);
	}
	/** What simulated at first and was put away before the first tick. */
	bool ShimIsDormant() const
	{
		return !ShimSimulates && ShimMobility == EComponentMobility::Movable && ShimInstance.ShimHasInertia;
	}
	void ShimComeOrGo()
	{
		if (!ShimLive || ShimIsThere() == ShimThere)
		{
			return;
		}
		ShimThere = !ShimThere;
		const double L[3] = {ShimLocation.X, ShimLocation.Y, ShimLocation.Z};
		const double R[4] = {ShimRotation.X, ShimRotation.Y, ShimRotation.Z, ShimRotation.W};
		Shim::State().Host->Present(ShimId, ShimThere ? 1 : 0, L, R);
		ShimPose.Moment = ShimVelocity.Moment = 0;
	}
	void SetEnableGravity(bool bEnable) { ShimGravity = bEnable; }
	void SetMassOverrideInKg(FName, float Mass, bool bOverride)
	{
		if (!(Mass > 0.0f))
		{
			Shim::Fatal("mass of " + ShimName + " must be positive");
		}
		ShimMass = bOverride ? Mass : -1.0f;
		// Unreal recomputes centre of mass and inertia from the collision shapes.
		ShimInstance.ShimHasFrame = ShimInstance.ShimHasInertia = false;
	}
	void SetLinearDamping(float Damping) { ShimLinearDamping = Damping; ShimUpdateDamping(); }
	void SetAngularDamping(float Damping) { ShimAngularDamping = Damping; ShimUpdateDamping(); }
	void SetPhysicsMaxAngularVelocityInDegrees(float MaxSpin) { ShimMaxSpin = MaxSpin; }
	void SetUseCCD(bool bUse) { ShimCCD = bUse; }
	void SetNotifyRigidBodyCollision(bool bNotify) { ShimNotifies = bNotify; }
	void SetCollisionProfileName(FName Profile);
	void SetCollisionEnabled(ECollisionEnabled::Type Enabled)
	{
		ShimCollides = Enabled == ECollisionEnabled::PhysicsOnly || Enabled == ECollisionEnabled::QueryAndPhysics;
		ShimProfileSet = true;
		ShimComeOrGo();
	}
	void SetCollisionObjectType(ECollisionChannel Channel) { ShimObjectType = Channel; }
	void SetCollisionResponseToAllChannels(ECollisionResponse Response) { ShimBlocks = Response == ECR_Block ? ~0u : 0u; }
	void SetCollisionResponseToChannel(ECollisionChannel Channel, ECollisionResponse Response)
	{
		ShimBlocks = Response == ECR_Block ? ShimBlocks | (1u << Channel) : ShimBlocks & ~(1u << Channel);
	}
	void SetPhysMaterialOverride(UPhysicalMaterial* Material)
	{
		if (!Material)
		{
			Shim::Fatal("no physical material for " + ShimName);
		}
		if (!Material->bOverrideFrictionCombineMode || Material->FrictionCombineMode != EFrictionCombineMode::Average ||
			!Material->bOverrideRestitutionCombineMode || Material->RestitutionCombineMode != EFrictionCombineMode::Average)
		{
			Shim::Fatal("material of " + ShimName + " does not combine by average, which is all that the replay knows");
		}
		if (Material->StaticFriction != Material->Friction)
		{
			Shim::Fatal("static and dynamic friction of " + ShimName + " differ, which the replay does not know");
		}
		ShimMaterial = Material;
		if (ShimLive)
		{
			Shim::State().Host->SetMaterial(ShimId, Material->Friction, Material->Restitution);
		}
	}
	FBodyInstance* GetBodyInstance() { return ShimId >= 0 && ShimCollides ? &ShimInstance : nullptr; }

	void SetPhysicsLinearVelocity(FVector Velocity, bool bAddToCurrent = false, FName = NAME_None)
	{
		ShimRequireLive("SetPhysicsLinearVelocity");
		if (bAddToCurrent)
		{
			Velocity = Velocity + GetPhysicsLinearVelocity();
		}
		const double Values[3] = {Velocity.X, Velocity.Y, Velocity.Z};
		Shim::State().Host->SetVelocity(ShimId, Values);
		ShimVelocity.Moment = 0;
	}
	void SetPhysicsAngularVelocityInDegrees(FVector Spin, bool bAddToCurrent = false, FName = NAME_None)
	{
		ShimRequireLive("SetPhysicsAngularVelocityInDegrees");
		if (bAddToCurrent)
		{
			Spin = Spin + ShimReadVelocity().Spin;
		}
		const double Values[3] = {Spin.X, Spin.Y, Spin.Z};
		Shim::State().Host->SetSpin(ShimId, Values);
		ShimVelocity.Moment = 0;
	}
	FVector GetPhysicsLinearVelocity(FName = NAME_None) const
	{
		ShimRequireLive("GetPhysicsLinearVelocity");
		return ShimReadVelocity().Linear;
	}
	FVector GetPhysicsAngularVelocityInDegrees(FName = NAME_None) const
	{
		ShimRequireLive("GetPhysicsAngularVelocityInDegrees");
		return ShimReadVelocity().Spin;
	}
	FVector GetCenterOfMass(FName = NAME_None) const
	{
		ShimRequireLive("GetCenterOfMass");
		const FShimPose& Pose = ShimReadPose();
		return Pose.Location + Pose.Rotation.RotateVector(ShimInstance.ShimFrame.Translation);
	}
	void AddImpulse(FVector Impulse, FName, bool bVelChange)
	{
		ShimRequireLive("AddImpulse");
		if (bVelChange)
		{
			SetPhysicsLinearVelocity(Impulse, true);
			return;
		}
		const double Values[3] = {Impulse.X, Impulse.Y, Impulse.Z};
		Shim::State().Host->Impulse(ShimId, Values);
		ShimVelocity.Moment = 0;
	}
	bool ComputePenetration(FMTDResult& Out, const FCollisionShape& Shape, const FVector& Location, const FQuat& Rotation) const
	{
		if (ShimId < 0 || !ShimCollides)
		{
			return false;
		}
		const double L[3] = {Location.X, Location.Y, Location.Z};
		const double R[4] = {Rotation.X, Rotation.Y, Rotation.Z, Rotation.W};
		const double Depth = Shim::State().Host->Penetration(ShimId, Shape.Kind, Shape.Size, L, R);
		Out.Distance = static_cast<float>(Depth);
		return Depth > 0.0;
	}
	FTransform GetComponentTransform() const override
	{
		if (!ShimLive || !ShimSimulates)
		{
			return FTransform(ShimRotation, ShimLocation);
		}
		const FShimPose& Pose = ShimReadPose();
		return FTransform(Pose.Rotation, Pose.Location);
	}

	/** What the host has said of a body, and at which moment; 0: nothing that holds. */
	struct FShimPose
	{
		uint64_t Moment = 0;
		FVector Location;
		FQuat Rotation;
	};
	struct FShimVelocity
	{
		uint64_t Moment = 0;
		FVector Linear, Spin;
	};
	const FShimPose& ShimReadPose() const
	{
		if (ShimPose.Moment != Shim::State().Moment)
		{
			double L[3], R[4];
			Shim::State().Host->GetPose(ShimId, L, R);
			ShimPose = {Shim::State().Moment, FVector(L[0], L[1], L[2]), FQuat(R[0], R[1], R[2], R[3])};
		}
		return ShimPose;
	}
	const FShimVelocity& ShimReadVelocity() const
	{
		if (ShimVelocity.Moment != Shim::State().Moment)
		{
			double L[3], A[3];
			Shim::State().Host->GetVelocity(ShimId, L, A);
			ShimVelocity = {Shim::State().Moment, FVector(L[0], L[1], L[2]), FVector(A[0], A[1], A[2])};
		}
		return ShimVelocity;
	}

	void ShimRequireLive(const char* Function) const
	{
		if (!ShimLive)
		{
			Shim::Fatal(Shim::FText(Function) + " on " + ShimName + " before there is a physics body: use the first Tick or later");
		}
		if (!ShimSimulates)
		{
			Shim::Fatal(Shim::FText(Function) + " on " + ShimName + ", which does not simulate physics");
		}
	}
	void ShimUpdateDamping()
	{
		if (ShimLive)
		{
			Shim::State().Host->SetDamping(ShimId, ShimLinearDamping, ShimAngularDamping);
		}
	}

	int ShimId = -1;
	bool ShimLive = false, ShimThere = false, ShimSimulates = false, ShimSimulateSet = false, ShimGravity = false, ShimCCD = false;
	bool ShimNotifies = false, ShimCollides = true, ShimProfileSet = false;
	float ShimMass = -1.0f, ShimLinearDamping = -1.0f, ShimAngularDamping = -1.0f, ShimMaxSpin = 3600.0f;
	ECollisionChannel ShimObjectType = ECC_WorldDynamic;
	uint32_t ShimBlocks = ~0u;
	UPhysicalMaterial* ShimMaterial = nullptr;
	FBodyInstance ShimInstance;
	mutable FShimPose ShimPose;
	mutable FShimVelocity ShimVelocity;
};

class UStaticMeshComponent : public UPrimitiveComponent
{
public:
	struct FBoundsView
	{
		const UStaticMeshComponent* Component = nullptr;
		/** Axis-aligned box around the rotated box of the mesh. */
		FBox GetBox() const
		{
			const FTransform Pose = Component->GetComponentTransform();
			const double* B = Component->ShimMesh ? Component->ShimMesh->ShimBounds : nullptr;
			if (!B)
			{
				return FBox{Pose.Translation, Pose.Translation};
			}
			const FVector Center = Pose.Translation + Pose.Rotation.RotateVector(FVector(B[3], B[4], B[5]) * Component->ShimScale);
			const FVector X = Pose.Rotation.RotateVector(FVector(B[0] * Component->ShimScale.X, 0.0, 0.0));
			const FVector Y = Pose.Rotation.RotateVector(FVector(0.0, B[1] * Component->ShimScale.Y, 0.0));
			const FVector Z = Pose.Rotation.RotateVector(FVector(0.0, 0.0, B[2] * Component->ShimScale.Z));
			const FVector Half(
				std::fabs(X.X) + std::fabs(Y.X) + std::fabs(Z.X),
				std::fabs(X.Y) + std::fabs(Y.Y) + std::fabs(Z.Y),
				std::fabs(X.Z) + std::fabs(Y.Z) + std::fabs(Z.Z));
			return FBox{Center - Half, Center + Half};
		}
	};

	UStaticMeshComponent() { Bounds.Component = this; }
	UStaticMeshComponent(const UStaticMeshComponent&) = delete;
	bool SetStaticMesh(UStaticMesh* Mesh)
	{
		ShimMesh = Mesh;
		return Mesh != nullptr;
	}
	FBoundsView Bounds;
	UStaticMesh* ShimMesh = nullptr;
};

enum ELinearConstraintMotion { LCM_Free, LCM_Limited, LCM_Locked };
enum EAngularConstraintMotion { ACM_Free, ACM_Limited, ACM_Locked };
namespace EConstraintFrame { enum Type { Frame1, Frame2 }; }
namespace EAngularDriveMode { enum Type { SLERP, TwistAndSwing }; }

/** Speeds of angular drives are turns per second, as Unreal's are. */
class UPhysicsConstraintComponent : public USceneComponent
{
public:
	void SetLinearXLimit(ELinearConstraintMotion Motion, float Limit) { ShimLinear(0, Motion, Limit); }
	void SetLinearYLimit(ELinearConstraintMotion Motion, float Limit) { ShimLinear(1, Motion, Limit); }
	void SetLinearZLimit(ELinearConstraintMotion Motion, float Limit) { ShimLinear(2, Motion, Limit); }
	void SetAngularTwistLimit(EAngularConstraintMotion Motion, float Limit) { ShimAngular(0, Motion, Limit); }
	void SetAngularSwing1Limit(EAngularConstraintMotion Motion, float Limit) { ShimAngular(1, Motion, Limit); }
	void SetAngularSwing2Limit(EAngularConstraintMotion Motion, float Limit) { ShimAngular(2, Motion, Limit); }
	void SetDisableCollision(bool bDisable) { ShimHeld.Collides = !bDisable; }
	void SetLinearBreakable(bool bBreaks, float Force) { ShimHeld.BreakForce = bBreaks ? Force : -1.0; }
	void SetConstrainedComponents(UPrimitiveComponent* First, FName, UPrimitiveComponent* Second, FName)
	{
		if (Shim::State().Phase != Shim::EPhase::Playing || ShimLive)
		{
			Shim::Fatal("SetConstrainedComponents of " + ShimName + " outside BeginPlay");
		}
		if (!First || !First->ShimSimulates)
		{
			Shim::Fatal("the first component of " + ShimName + " does not simulate physics");
		}
		ShimHeld.First = First->ShimId;
		ShimHeld.Second = Second ? Second->ShimId : -1;
		ShimFrames = 0;
	}
	/** Unreal finds frames of its own when components are joined; these are set after. */
	void SetConstraintReferenceFrame(EConstraintFrame::Type Frame, const FTransform& Pose)
	{
		const FVector& At = Pose.Translation;
		const FQuat& Turn = Pose.Rotation;
		const double Location[3] = {At.X, At.Y, At.Z}, Rotation[4] = {Turn.X, Turn.Y, Turn.Z, Turn.W};
		for (int Index = 0; Index < 3; ++Index)
		{
			ShimHeld.Location[Frame][Index] = Location[Index];
		}
		for (int Index = 0; Index < 4; ++Index)
		{
			ShimHeld.Rotation[Frame][Index] = Rotation[Index];
		}
		ShimFrames |= 1 << Frame;
	}
	void SetAngularDriveMode(EAngularDriveMode::Type Mode) { bShimSlerp = Mode == EAngularDriveMode::SLERP; }
	void SetLinearDriveAccelerationMode(bool bUse) { ShimForceBased |= bUse ? 0 : 1; }
	void SetAngularDriveAccelerationMode(bool bUse) { ShimForceBased |= bUse ? 0 : 2; }
	void SetLinearPositionDrive(bool bX, bool bY, bool bZ) { ShimDraws(bX, bY || bZ); }
	void SetLinearVelocityDrive(bool bX, bool bY, bool bZ) { ShimActs(bShimLinear, bX, bY || bZ); }
	void SetOrientationDriveTwistAndSwing(bool bTwist, bool bSwing) { ShimDraws(bTwist, bSwing); }
	void SetAngularVelocityDriveTwistAndSwing(bool bTwist, bool bSwing) { ShimActs(bShimTwist, bTwist, bSwing); }
	void SetAngularVelocityDriveSLERP(bool bUse) { ShimActs(bShimBall, bUse, false); }
	void SetLinearVelocityTarget(const FVector& Speed) { ShimSpeed = Speed.X; }
	void SetAngularVelocityTarget(const FVector& Speed) { ShimSpeed = Speed.X; }
	void SetLinearDriveParams(float Spring, float Damping, float Limit) { ShimDrive(Spring, Damping, Limit); }
	void SetAngularDriveParams(float Spring, float Damping, float Limit) { ShimDrive(Spring, Damping, Limit); }

	Shim::FConstraint ShimHeld{};
	int ShimId = -1, ShimFrames = 0, ShimForceBased = 0, ShimStated = 0;
	bool ShimLive = false, bShimSlerp = false, bShimDraws = false, bShimLinear = false, bShimTwist = false, bShimBall = false;
	double ShimSpeed = 0.0;

private:
	void ShimLinear(int Axis, int Motion, double Limit)
	{
		ShimHeld.Linear[Axis] = Motion;
		ShimHeld.LinearLimit[Axis] = Limit;
		ShimStated |= 1 << Axis;
	}
	void ShimAngular(int Axis, int Motion, double Limit)
	{
		ShimHeld.Angular[Axis] = Motion;
		ShimHeld.AngularLimit[Axis] = Limit;
		ShimStated |= 8 << Axis;
	}
	void ShimDraws(bool bUse, bool bOther)
	{
		if (bOther || ShimLive)
		{
			Shim::Fatal("a drive of " + ShimName + " that the replay does not know");
		}
		bShimDraws = bUse;
	}
	void ShimActs(bool& bHere, bool bUse, bool bOther)
	{
		if (bOther)
		{
			Shim::Fatal("a drive of " + ShimName + " that the replay does not know");
		}
		bHere = bUse;
	}
	void ShimDrive(double Spring, double Damping, double Limit)
	{
		if (ShimForceBased != 3)
		{
			Shim::Fatal("the drives of " + ShimName + " are not told to be forces");
		}
		if (ShimLive)
		{
			Shim::State().Host->Drive(ShimId, bShimLinear || bShimTwist || bShimBall, ShimSpeed, Limit);
			return;
		}
		ShimHeld.DrawsBack = 1;
		ShimHeld.Stiffness = bShimDraws ? Spring : 0.0;
		ShimHeld.Damping = Damping;
	}
};

struct FActorTickFunction
{
	bool bCanEverTick = false;
	ETickingGroup TickGroup = TG_PrePhysics;
};

class AWorldSettings : public UObject
{
public:
	bool bWorldGravitySet = false;
	float WorldGravityZ = 0.0f;
};

class UWorld : public UObject
{
public:
	AWorldSettings* GetWorldSettings() { return &ShimSettings; }
	AWorldSettings ShimSettings;
};

struct FApp
{
	static void SetUseFixedTimeStep(bool bUse) { Shim::State().bFixedStep = bUse; }
	static void SetFixedDeltaTime(double Seconds) { Shim::State().FixedStep = Seconds; }
};

class AActor : public UObject
{
public:
	FActorTickFunction PrimaryActorTick;
	virtual void OnConstruction(const FTransform&) {}
	virtual void Tick(float) {}
	void SetRootComponent(USceneComponent* Component) { ShimRoot = Component; }
	FTransform GetActorTransform() const { return FTransform(); }
	UWorld* GetWorld() const { return const_cast<UWorld*>(&ShimWorldObject); }
	template <class T> T* CreateDefaultSubobject(FName Name)
	{
		if (Shim::State().Phase != Shim::EPhase::Constructing)
		{
			Shim::Fatal("CreateDefaultSubobject outside the constructor: " + Name.Text);
		}
		for (const UObject* Other : ShimSubobjects)
		{
			if (strcasecmp(Other->ShimName.c_str(), Name.Text.c_str()) == 0)
			{
				Shim::Fatal("two subobjects are called " + Name.Text);
			}
		}
		T* Result = new T();
		Shim::State().Pool.push_back(Result);
		Result->ShimName = Name.Text;
		ShimSubobjects.push_back(Result);
		return Result;
	}
	void ShimBeginPlay() { BeginPlay(); }

	USceneComponent* ShimRoot = nullptr;
	std::vector<UObject*> ShimSubobjects;
	UWorld ShimWorldObject;

protected:
	virtual void BeginPlay() {}
};

// What every class uses is compiled once, into the runtime, and not again in every unit of classes.
#ifdef SHIM_RUNTIME
#define SHIM_TEMPLATE template
#else
#define SHIM_TEMPLATE extern template
#endif
SHIM_TEMPLATE class std::vector<UObject*>;
SHIM_TEMPLATE class std::vector<UPrimitiveComponent*>;
SHIM_TEMPLATE UPhysicalMaterial* NewObject<UPhysicalMaterial>(UObject*);
SHIM_TEMPLATE struct ConstructorHelpers::FObjectFinder<UStaticMesh>;
SHIM_TEMPLATE USceneComponent* AActor::CreateDefaultSubobject<USceneComponent>(FName);
SHIM_TEMPLATE UStaticMeshComponent* AActor::CreateDefaultSubobject<UStaticMeshComponent>(FName);
SHIM_TEMPLATE UPhysicsConstraintComponent* AActor::CreateDefaultSubobject<UPhysicsConstraintComponent>(FName);
SHIM_TEMPLATE class TArray<UPrimitiveComponent*>;
SHIM_TEMPLATE class TArray<int32>;
SHIM_TEMPLATE class TArray<TObjectPtr<UPhysicalMaterial>>;
#undef SHIM_TEMPLATE

#endif
