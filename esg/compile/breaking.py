"""Bodies that break, in the words of the emitted class: hidden fragments that take their place."""

from __future__ import annotations

from typing import TYPE_CHECKING

from esg.compile import frames
from esg.engines.joint_rules import BREAK_WINDOW_S

if TYPE_CHECKING:
    from esg.compile.model import ScenePlan, UnrealBody

DECLARATIONS = """\
	/** A body that breaks, and its fragments with where they lie in it. */
	struct FBrittle
	{
		FBodyRef* Whole = nullptr;
		TArray<FBodyRef*> Pieces;
		TArray<FVector> Centers;
		TArray<FQuat> Turns;
		TArray<UPrimitiveComponent*> Touched;
		TArray<double> Taken;
		double Step = 0.0;
		bool bBroken = false;
	};

	void CollectFragments();
	void AddBrittle(int32 Whole, const TArray<int32>& Pieces);
	void TakeBlow(const UPrimitiveComponent* Body, UPrimitiveComponent* Other, double Impulse);
	void BreakBodies(double Step);
	void Shatter(FBrittle& Brittle, double Share, double Step);
	void TakeBack(FBodyRef& Body, double Share, double Step) const;
	void RememberSpeeds();
	static void PutAway(UStaticMeshComponent* Body, bool bSimulated);
	TArray<FBrittle> Brittles;

"""

REMEMBERED = """\
		/** Velocities at the beginning of the last step. */
		FVector LastVelocity = FVector::ZeroVector;
		FVector LastSpin = FVector::ZeroVector;
"""
"""Of bodies, in classes with what breaks."""

GONE = """\
	if (!First.Component->IsCollisionEnabled() || !Second.Component->IsCollisionEnabled())
	{
		return 0.0;
	}
"""

MOVES = "if (!Body.Settings->bSimulated || !Body.Component->IsSimulatingPhysics())"
"""Of what is there, in place of the same without what breaks."""

CONSTANTS = f"""\
	/** Over which what a body takes adds up [s]. */
	constexpr double BreakWindow = {frames.literal(BREAK_WINDOW_S)};

"""


def collect(plan: ScenePlan) -> str:
    """What gathers the fragments of a class and puts them away."""
    number = {b.source.name: k for k, b in enumerate(plan.bodies)}
    lines = "\n".join(
        f"\tAddBrittle({k}, {{ {', '.join(str(number[n]) for n in b.source.fragments)} }});"
        for k, b in enumerate(plan.bodies)
        if b.source.fragments
    )
    return f"""
void A@CLASS@::CollectFragments()
{{
	Brittles.Reset();
{lines}
}}
"""


def settings_of(body: UnrealBody) -> list[tuple[str, str]]:
    """What the settings of a body say of its breaking."""
    impulse = body.source.break_impulse
    if impulse is None:
        return []
    return [("BreakImpulse", frames.literal(impulse * frames.CM_PER_M))]
