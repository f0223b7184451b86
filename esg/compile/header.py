"""Text of the emitted header: what a scene consists of, as editable properties."""

from __future__ import annotations

from esg.compile import joints
from esg.compile.model import ScenePlan, UnrealBody

_PROGRAM = '\tUPROPERTY(EditAnywhere, Category = "ESG|Program")\n'


def emit_header(plan: ScenePlan) -> str:
    """The .h file."""
    bodies = "\n".join(_body_members(b) for b in plan.bodies)
    bodies += "\n" + joints.members_of(plan.joints) if plan.joints else ""
    program = "\n".join(f"{_PROGRAM}\tFEsg{p.kind} {p.member};\n" for p in plan.primitives)
    title = f" {plan.title}" if plan.title else ""
    return f"""// Dynamic scene{title}: bodies, control program and contact events.
// What plays them is AEsgScene.
// Units: cm, kg, s, degrees. Frame: Unreal's, left-handed, Z up. Place the actor at the origin.
#pragma once

#include "EsgScene.h"
#include "{plan.name}.generated.h"

UCLASS()
class ESGSCENES_API A{plan.name} : public AEsgScene
{{
	GENERATED_BODY()

public:
	A{plan.name}();

{bodies}
{program}
protected:
	virtual void CollectBodies() override;
	virtual void CollectProgram() override;
	virtual void DispatchProgram(double Due) override;
}};
"""


def _body_members(body: UnrealBody) -> str:
    return (
        f'\tUPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")\n'
        f"\tTObjectPtr<UStaticMeshComponent> {body.member};\n\n"
        f'\tUPROPERTY(EditAnywhere, Category = "ESG|Bodies")\n'
        f"\tFEsgBody {body.settings};\n"
    ) + "".join(
        f'\n\tUPROPERTY(VisibleAnywhere, Category = "ESG|Wheels")\n'
        f"\tTObjectPtr<UStaticMeshComponent> {wheel.member};\n\n"
        f'\tUPROPERTY(EditAnywhere, Category = "ESG|Wheels")\n'
        f"\tFEsgWheel {wheel.settings};\n"
        for wheel in body.wheels
    )
