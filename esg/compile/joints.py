"""Joints in an emitted class: a constraint component each, with settings of its own.

Positions and motors are said as Unreal has them: centimetres, and degrees of the child's turn about
the frame's X axis in Unreal's left-handed sense, which is the negative of ours.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import math

import numpy as np

from esg.compile import frames, names
from esg.engines.joints import Joint, JointKind, Motor
from esg.engines.scene import SimScene

UNLIMITED = 1.0e9
"""Stands for a force or torque without limit [kg cm/s^2, kg cm^2/s^2]."""
FAR_TURN_DEG, FAR_SLIDE_M = 179.0, 100.0
"""Where a hinge or slider with a limit on one side stops on the other."""
RIGID_DRIVE = 1.0e12
"""Strength of a drive that its limit alone holds back."""
SETTINGS = "Settings"
CONSTRAINT = "Constraint"
RETURN = "Return"
"""Suffixes of members: of the settings, of the component, of the one that draws a joint back."""


@dataclass(frozen=True)
class UnrealJoint:
    """One joint and its settings.

    Args:
        name: Identifier of the component.
        kind: What it leaves free.
        child, parent: Members of the bodies' components; no parent is the world.
        values: Its settings as (field, literal).
        returns: Whether a second component draws it back or damps it.
    """

    name: str
    kind: JointKind
    child: str
    parent: str
    values: tuple[tuple[str, str], ...]
    returns: bool

    @property
    def member(self) -> str:
        """The class member that points to the component."""
        return self.name + CONSTRAINT

    @property
    def settings(self) -> str:
        """The class member that holds its settings."""
        return self.name + SETTINGS


def joint_key(joint: Joint) -> str:
    """Stands for a joint among the names of a scene's components; no body is called so."""
    return f"{joint.name}\0joint"


def plan_joints(
    scene: SimScene, idents: dict[str, str], members: dict[str, str]
) -> tuple[UnrealJoint, ...]:
    """The joints of a scene in Unreal's values.

    Args:
        scene: Bodies and joints.
        idents: Identifiers by body's name and by `joint_key`.
        members: Members of components by body's name.
    """
    offsets = {b.name: np.asarray(b.origin_offset, float) for b in scene.bodies}
    zero = np.zeros(3)
    out: list[UnrealJoint] = []
    for joint in scene.joints:
        elastic = joint.stiffness > 0.0 or joint.damping > 0.0
        out.append(
            UnrealJoint(
                name=idents[joint_key(joint)],
                kind=joint.kind,
                child=members[joint.child],
                parent=members.get(joint.parent, ""),
                values=_values(joint, offsets[joint.child], offsets.get(joint.parent, zero)),
                returns=elastic and joint.kind != "spring",
            )
        )
    return tuple(out)


def _values(joint: Joint, child: np.ndarray, parent: np.ndarray) -> tuple[tuple[str, str], ...]:
    f = frames.literal
    lower, upper = joint.lower, joint.upper
    if joint.kind == "hinge":
        lower, upper = (None if v is None else -v for v in (upper, lower))
    way, push = scales(joint.kind)
    spring = push if joint.kind in ("hinge", "ball") else 1.0
    strength = joint.break_impulse
    return (
        ("ChildAnchor", frames.vector_literal(_anchor(joint.child_anchor, child))),
        ("ChildFrame", _quat(joint.child_rotation)),
        ("ParentAnchor", frames.vector_literal(_anchor(joint.parent_anchor, parent))),
        ("ParentFrame", _quat(joint.parent_rotation)),
        ("bCollides", _bool(joint.collide)),
        ("bLower", _bool(lower is not None)),
        ("Lower", f((lower or 0.0) * way)),
        ("bUpper", _bool(upper is not None)),
        ("Upper", f((upper or 0.0) * way)),
        ("Stiffness", f(joint.stiffness * spring)),
        ("Damping", f(joint.damping * spring)),
        ("Friction", f(joint.friction * push)),
        *motor_values(joint.kind, joint.motor, "bMotor", "Motor"),
        ("bBreaks", _bool(strength is not None)),
        ("BreakImpulse", f((strength or 0.0) * frames.CM_PER_M)),
    )


def motor_values(
    kind: JointKind, motor: Motor | None, flag: str, prefix: str = ""
) -> tuple[tuple[str, str], ...]:
    """A motor as (field, literal): of a joint's settings, or of a command.

    Args:
        kind: Of the joint.
        motor: None where there is none.
        flag: Field that says whether there is one.
        prefix: Of the other fields.
    """
    way, push = scales(kind)
    sign = -1.0 if kind == "hinge" else 1.0
    told = motor or Motor()
    place = 0.0 if told.position is None else told.position
    limit = UNLIMITED if motor and math.isinf(told.limit) else told.limit * push
    return (
        (flag, _bool(motor is not None)),
        (f"{prefix}Speed", frames.literal(sign * told.speed * way + 0.0)),
        (f"b{prefix}ToPlace", _bool(told.position is not None)),
        (f"{prefix}Place", frames.literal(sign * place * way + 0.0)),
        (f"{prefix}Limit", frames.literal(limit if motor else 0.0)),
    )


def scales(kind: JointKind) -> tuple[float, float]:
    """Unreal's position by ours, and its force or torque by ours."""
    if kind in ("hinge", "ball"):
        return math.degrees(1.0), frames.CM2_PER_M2
    return frames.CM_PER_M, frames.CM_PER_M


def _anchor(anchor: tuple[float, float, float], offset: np.ndarray) -> np.ndarray:
    return frames.vector_to_unreal(np.asarray(anchor, float) - offset)


def _quat(rotation: tuple[float, float, float, float]) -> str:
    return frames.quaternion_literal(frames.quaternion_to_unreal(rotation))


def _bool(value: bool) -> str:
    return "true" if value else "false"


INCLUDES = ("PhysicsEngine/ConstraintInstance.h", "PhysicsEngine/PhysicsConstraintComponent.h")


def members_of(joints: Sequence[UnrealJoint]) -> str:
    """Declarations of the joints' components and settings in a class."""
    out: list[str] = []
    for joint in joints:
        parts = [joint.member, joint.name + RETURN] if joint.returns else [joint.member]
        out += [
            '\tUPROPERTY(VisibleAnywhere, Category = "ESG|Joints")\n'
            f"\tTObjectPtr<UPhysicsConstraintComponent> {part};\n"
            for part in parts
        ]
        out.append(
            f'\tUPROPERTY(EditAnywhere, Category = "ESG|Joints")\n\tFEsgJoint {joint.settings};\n'
        )
    return "\n".join(out)


def defaults_of(joint: UnrealJoint) -> list[str]:
    """Lines of the constructor that make a joint's components and set its values."""
    lines = [f"\t{joint.member} = CreateConstraint({names.string_literal(joint.name)});"]
    if joint.returns:
        own = names.string_literal(joint.name + RETURN)
        lines.append(f"\t{joint.name}{RETURN} = CreateConstraint({own});")
    return lines + [f"\t{joint.settings}.{field} = {value};" for field, value in joint.values]


def added(joint: UnrealJoint) -> str:
    """The line that adds a joint to what a class consists of."""
    back = joint.name + RETURN if joint.returns else "nullptr"
    kind = f"EJointKind::{joint.kind.capitalize()}"
    held = f"{joint.settings}, {joint.member}, {back}"
    return f"\tAddJoint({kind}, {held}, {joint.child}, {joint.parent or 'nullptr'});"
