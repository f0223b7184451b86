# pyright: reportAttributeAccessIssue=false
"""The control program as prims: `/World/Program` with a child for every command (docs/usd.md)."""

from __future__ import annotations

from typing import Any

from esg.engines.program import Program, program_to_json

PROGRAM_PATH = "/World/Program"
BODIES = {"body", "into", "until_contact"}
"""Fields that name bodies; relationships in USD."""
JOINT = "joint"
"""The field that names a joint; a relationship, too."""
_SERIES = "times"
"""The field that is a series of numbers; all other lists of numbers are vectors."""


def write_program(
    stage: Any, program: Program, dt: float, paths: dict[str, str], joints: dict[str, str]
) -> None:
    """Writes the fields of every command as typed attributes of the same name, in order.

    Args:
        stage: To write to.
        program: Control program.
        dt: Physics step [s].
        paths: Prim paths by name of body.
        joints: Prim paths by name of joint.
    """
    from pxr import Sdf, UsdGeom

    data = program_to_json(program)
    root = UsdGeom.Scope.Define(stage, PROGRAM_PATH).GetPrim()
    types = Sdf.ValueTypeNames
    root.CreateAttribute("esg:version", types.Int).Set(data["version"])
    root.CreateAttribute("esg:duration", types.Double).Set(float(data["duration"]))
    root.CreateAttribute("esg:step", types.Double).Set(float(dt))
    for number, command in enumerate(data["primitives"]):
        prim = UsdGeom.Scope.Define(stage, f"{PROGRAM_PATH}/Command{number}").GetPrim()
        for field, value in command.items():
            if field in BODIES or field == JOINT:
                named = [value] if isinstance(value, str) else value
                relation = prim.CreateRelationship(f"esg:{field}")
                known = joints if field == JOINT else paths
                relation.SetTargets([Sdf.Path(known[name]) for name in named])
            elif value is not None:
                kind, value = _typed(field, value)
                prim.CreateAttribute(f"esg:{field}", kind).Set(value)


def _typed(field: str, value: Any) -> tuple[Any, Any]:
    """A field's USD type and its value as USD takes it."""
    from pxr import Sdf

    types = Sdf.ValueTypeNames
    if field == "kind":
        return types.Token, value
    if not isinstance(value, (list, tuple)):
        return types.Double, float(value)
    if field == _SERIES:
        return types.DoubleArray, list(map(float, value))
    if value and isinstance(value[0], (list, tuple)):
        return types.Double3Array, [tuple(map(float, v)) for v in value]
    return types.Double3, tuple(map(float, value))
