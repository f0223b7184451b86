// The runtime that every library of compiled classes links: the shim's state and the C entry points
// the host calls. Functions that can fail return 0, or set the error text and return 1.
#define SHIM_RUNTIME
#include "UEShim.h"

#include <cstdarg>
#include <cstring>
#include <memory>
#include <string>

namespace Shim
{
	FText::FText(const char* In) : Data(strdup(In)) {}

	FText::FText(const FText& Other) : Data(strdup(Other.Data)) {}

	FText& FText::operator=(const FText& Other)
	{
		char* Old = Data;
		Data = strdup(Other.Data);
		free(Old);
		return *this;
	}

	FText::~FText()
	{
		free(Data);
	}

	FText operator+(const FText& A, const FText& B)
	{
		return FText((std::string(A.Data) + B.Data).c_str());
	}

	void Fatal(const FText& Message)
	{
		throw FFatal{Message};
	}

	FState& State()
	{
		static FState S;
		return S;
	}

	void Reset()
	{
		for (UObject* Object : State().Pool)
		{
			delete Object;
		}
		State() = FState();
	}

	void OutOfBounds(int32 Index, int32 Count)
	{
		const std::string Numbers = std::to_string(Index) + " of " + std::to_string(Count);
		Fatal(("array index out of bounds: " + Numbers).c_str());
	}

	void Log(const char* Category, const char* Verbosity, const char* Format, ...)
	{
		char Buffer[4096];
		va_list Arguments;
		va_start(Arguments, Format);
		vsnprintf(Buffer, sizeof Buffer, Format, Arguments);
		va_end(Arguments);
		State().Host->Log(Category, Verbosity, Buffer);
	}
}

void UPrimitiveComponent::SetCollisionProfileName(FName Profile)
{
	static const struct
	{
		const char* Name;
		ECollisionChannel Type;
		bool bCollides;
	} Known[] = {
		{"NoCollision", ECC_WorldStatic, false}, {"BlockAll", ECC_WorldStatic, true},
		{"BlockAllDynamic", ECC_WorldDynamic, true}, {"PhysicsActor", ECC_PhysicsBody, true}};
	for (const auto& Row : Known)
	{
		if (strcmp(Row.Name, Profile.Text.c_str()) == 0)
		{
			ShimObjectType = Row.Type;
			ShimCollides = Row.bCollides;
			ShimBlocks = Row.bCollides ? ~0u : 0u;
			ShimProfileSet = true;
			return;
		}
	}
	Shim::Fatal("unknown collision profile " + Profile.Text + " on " + ShimName);
}

namespace ShimGlue
{
	static std::unique_ptr<AActor> Actor;
	static std::string Error;

	template <class F> static int Guard(F&& Function)
	{
		try
		{
			Function();
			return 0;
		}
		catch (const Shim::FFatal& Caught)
		{
			Error = Caught.Message.c_str();
		}
		return 1;
	}

	static void Copy(double* Out, const FVector& V)
	{
		Out[0] = V.X;
		Out[1] = V.Y;
		Out[2] = V.Z;
	}

	static void Copy(double* Out, const FQuat& Q)
	{
		Out[0] = Q.X;
		Out[1] = Q.Y;
		Out[2] = Q.Z;
		Out[3] = Q.W;
	}

	/** What Unreal would leave at a default that nobody stated. */
	static void RequireExplicit(const UPrimitiveComponent& C)
	{
		std::string Missing;
		Missing += C.ShimProfileSet ? "" : " collision profile;";
		Missing += C.ShimPlaced ? "" : " location and rotation;";
		Missing += C.ShimSimulateSet ? "" : " SetSimulatePhysics;";
		if (C.ShimCollides)
		{
			Missing += C.ShimMaterial ? "" : " physical material;";
		}
		if (C.ShimSimulates)
		{
			Missing += C.ShimMass > 0.0f ? "" : " mass;";
			Missing += C.ShimLinearDamping >= 0.0f ? "" : " linear damping;";
			Missing += C.ShimAngularDamping >= 0.0f ? "" : " angular damping;";
			Missing += C.ShimInstance.ShimHasFrame && C.ShimInstance.ShimHasInertia ? "" : " centre of mass and inertia;";
			Missing += C.ShimGravity ? "" : " gravity;";
			Missing += C.ShimInstance.ShimConditioning ? " inertia conditioning off;" : "";
		}
		if (!Missing.empty())
		{
			Shim::Fatal(C.ShimName + " relies on defaults for:" + Missing.c_str());
		}
	}

	static Shim::FBody Describe(const UPrimitiveComponent& C)
	{
		const auto* Mesh = dynamic_cast<const UStaticMeshComponent*>(&C);
		Shim::FBody Out{};
		Out.Name = C.ShimName.c_str();
		Out.Asset = Mesh && Mesh->ShimMesh ? Mesh->ShimMesh->ShimName.c_str() : "";
		Copy(Out.Location, C.ShimLocation);
		Copy(Out.Rotation, C.ShimRotation);
		Copy(Out.Scale, C.ShimScale);
		Copy(Out.CenterOfMass, C.ShimInstance.ShimFrame.Translation);
		Copy(Out.MassRotation, C.ShimInstance.ShimFrame.Rotation);
		Copy(Out.Inertia, C.ShimInstance.ShimInertia);
		Out.Mass = C.ShimMass;
		Out.LinearDamping = C.ShimLinearDamping;
		Out.AngularDamping = C.ShimAngularDamping;
		Out.Friction = C.ShimMaterial ? C.ShimMaterial->Friction : 0.0;
		Out.Restitution = C.ShimMaterial ? C.ShimMaterial->Restitution : 0.0;
		Out.MaxSpin = C.ShimMaxSpin;
		Out.Collides = C.ShimCollides;
		Out.Simulates = C.ShimSimulates;
		Out.ObjectType = C.ShimObjectType;
		Out.Blocks = C.ShimBlocks;
		Out.Notifies = C.ShimNotifies;
		Out.CCD = C.ShimCCD;
		Out.HasMassFrame = C.ShimInstance.ShimHasFrame;
		Out.HasMaterial = C.ShimMaterial != nullptr;
		Out.Dormant = C.ShimIsDormant();
		Out.Movable = C.ShimMobility == EComponentMobility::Movable;
		return Out;
	}
}

#pragma GCC visibility push(default)
extern "C"
{
	const char* esg_error()
	{
		return ShimGlue::Error.c_str();
	}

	int esg_construct(Shim::Backend* Host, AActor* (*Create)())
	{
		using namespace ShimGlue;
		return Guard([&]
		{
			Shim::Reset();
			Shim::State().Host = Host;
			Shim::State().Phase = Shim::EPhase::Constructing;
			Actor.reset(Create());
			if (!Actor->ShimRoot)
			{
				Shim::Fatal("the actor has no root component");
			}
			Shim::State().Phase = Shim::EPhase::Configuring;
			Actor->OnConstruction(FTransform::Identity);
			for (UObject* Object : Actor->ShimSubobjects)
			{
				if (auto* Component = dynamic_cast<UPrimitiveComponent*>(Object))
				{
					Component->ShimId = static_cast<int>(Shim::State().Bodies.size());
					Shim::State().Bodies.push_back(Component);
				}
				if (auto* Constraint = dynamic_cast<UPhysicsConstraintComponent*>(Object))
				{
					Constraint->ShimId = static_cast<int>(Shim::State().Constraints.size());
					Shim::State().Constraints.push_back(Constraint);
				}
			}
		});
	}

	int esg_body_count()
	{
		return static_cast<int>(Shim::State().Bodies.size());
	}

	/** Fills in a body; complete only after esg_begin_play. */
	int esg_describe(int Index, Shim::FBody* Out)
	{
		using namespace ShimGlue;
		return Guard([&] { *Out = Describe(*Shim::State().Bodies.at(static_cast<size_t>(Index))); });
	}

	int esg_constraint_count()
	{
		return static_cast<int>(Shim::State().Constraints.size());
	}

	/** Fills in a constraint; complete only after esg_begin_play. */
	int esg_describe_constraint(int Index, Shim::FConstraint* Out)
	{
		using namespace ShimGlue;
		return Guard([&]
		{
			const auto* Constraint = Shim::State().Constraints.at(static_cast<size_t>(Index));
			if (Constraint->ShimFrames != 3 || Constraint->ShimStated != 63)
			{
				Shim::Fatal(Constraint->ShimName + " relies on defaults for its frames or motions");
			}
			*Out = Constraint->ShimHeld;
			Out->Name = Constraint->ShimName.c_str();
		});
	}

	int esg_begin_play()
	{
		using namespace ShimGlue;
		return Guard([&]
		{
			Shim::State().Phase = Shim::EPhase::Playing;
			Actor->ShimBeginPlay();
			const AWorldSettings& Settings = *Actor->GetWorld()->GetWorldSettings();
			Shim::State().bGravitySet = Settings.bWorldGravitySet;
			Shim::State().GravityZ = Settings.WorldGravityZ;
			if (!Settings.bWorldGravitySet)
			{
				Shim::Fatal("the class leaves the world's gravity to the project");
			}
			if (!Shim::State().bFixedStep)
			{
				Shim::Fatal("the class does not pin the time step");
			}
			if (!Actor->PrimaryActorTick.bCanEverTick || Actor->PrimaryActorTick.TickGroup != TG_PrePhysics)
			{
				Shim::Fatal("the actor does not tick before physics");
			}
			for (const UPrimitiveComponent* Component : Shim::State().Bodies)
			{
				RequireExplicit(*Component);
			}
		});
	}

	double esg_gravity() { return Shim::State().GravityZ; }
	double esg_fixed_step() { return Shim::State().FixedStep; }

	/** The host has built its world; velocities may be set from now on. */
	void esg_live()
	{
		for (UPrimitiveComponent* Component : Shim::State().Bodies)
		{
			Component->ShimLive = Component->ShimCollides || Component->ShimIsDormant();
			Component->ShimThere = Component->ShimIsThere();
		}
		for (UPhysicsConstraintComponent* Constraint : Shim::State().Constraints)
		{
			Constraint->ShimLive = true;
		}
	}

	int esg_tick(double DeltaTime)
	{
		using namespace ShimGlue;
		const int Failed = Guard([&] { Actor->Tick(static_cast<float>(DeltaTime)); });
		++Shim::State().Moment;
		return Failed;
	}

	/** Impulse and normal act on the first body (Unreal's frame, kg cm/s); depth in cm. */
	int esg_hit(int A, int B, const double* Impulse, const double* Point, const double* Normal, double Depth)
	{
		using namespace ShimGlue;
		return Guard([&]
		{
			UPrimitiveComponent* First = Shim::State().Bodies.at(static_cast<size_t>(A));
			UPrimitiveComponent* Second = Shim::State().Bodies.at(static_cast<size_t>(B));
			const auto Fire = [&](UPrimitiveComponent* Self, UPrimitiveComponent* Other, double Sign)
			{
				if (!Self->ShimNotifies)
				{
					return;
				}
				FHitResult Hit;
				Hit.bBlockingHit = true;
				Hit.Location = Hit.ImpactPoint = FVector(Point[0], Point[1], Point[2]);
				Hit.Normal = Hit.ImpactNormal = FVector(Normal[0], Normal[1], Normal[2]) * Sign;
				Hit.PenetrationDepth = static_cast<float>(Depth);
				const FVector J = FVector(Impulse[0], Impulse[1], Impulse[2]) * Sign;
				for (const auto& Handler : Self->OnComponentHit.Handlers)
				{
					Handler(Self, Actor.get(), Other, J, Hit);
				}
			};
			Fire(First, Second, 1.0);
			Fire(Second, First, -1.0);
		});
	}

	void esg_destroy()
	{
		ShimGlue::Actor.reset();
		Shim::Reset();
	}
}

#pragma GCC visibility pop
