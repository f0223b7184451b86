"""Text of the emitted header: what a scene consists of, as editable properties."""

from __future__ import annotations

import numpy as np

from esg.compile import frames, joints, names
from esg.compile.model import ScenePlan, UnrealBody
from esg.engines.scene import Shine
from esg.engines.wheels import TURN_S

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
        (
            f'\tUPROPERTY(VisibleAnywhere, Category = "ESG|Bodies")\n'
            f"\tTObjectPtr<UStaticMeshComponent> {body.member};\n\n"
            f'\tUPROPERTY(EditAnywhere, Category = "ESG|Bodies")\n'
            f"\tFEsgBody {body.settings};\n"
        )
        + "".join(
            f'\n\tUPROPERTY(VisibleAnywhere, Category = "ESG|Wheels")\n'
            f"\tTObjectPtr<UStaticMeshComponent> {wheel.member};\n\n"
            f'\tUPROPERTY(EditAnywhere, Category = "ESG|Wheels")\n'
            f"\tFEsgWheel {wheel.settings};\n"
            for wheel in body.wheels
        )
        + "".join(_light_members(body, k, s) for k, s in enumerate(body.source.shines))
    )


def _light_members(body: UnrealBody, number: int, shine: Shine) -> str:
    """A light or flame and when it shines, for whoever draws it: the class itself moves bodies."""
    name = f"{body.member}Light{number}"
    turns = frames.literal(-1.0 if shine.event else TURN_S)
    values = [
        ("FString", f"{name}Part", names.string_literal(shine.part)),
        ("FVector", f"{name}Color", frames.vector_literal(np.array(shine.color))),
        ("bool", f"b{name}Before", "true" if shine.before else "false"),
        ("bool", f"b{name}After", "true" if shine.after else "false"),
        ("double", f"{name}TurnsAt", turns),
        ("FString", f"{name}TurnsAtEvent", names.string_literal(shine.event)),
        ("double", f"{name}Period", frames.literal(shine.period_s)),
    ]
    return "".join(
        f'\n\tUPROPERTY(EditAnywhere, Category = "ESG|Lights")\n\t{kind} {member} = {value};\n'
        for kind, member, value in values
    )
