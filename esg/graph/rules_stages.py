"""Rules on what later stages and the drafter's coverage record write."""

from __future__ import annotations

import math
from pathlib import PurePosixPath
from typing import Any

from esg.graph.context import Context
from esg.graph.models import AssetConfiguration, Quat
from esg.graph.rules_scene import (
    DAMPING_PER_S,
    MASS_KG,
    SIZE_CM,
    STRUCTURAL_SIZE_CM,
    interval,
    outside,
)
from esg.graph.violations import listing, pointer
from esg.outcomes import Outcome
from esg.untyped import is_array, is_object

FRICTION = (0.0, 2.0)
RESTITUTION = (0.0, 1.0)
QUATERNION_TOLERANCE = 1e-3
MASS_TOLERANCE = 0.01


def check(ctx: Context) -> None:
    """Adds violations of configurations, layout, dynamics and coverage."""
    doc = ctx.doc
    if doc.asset_configurations:
        _configurations(ctx)
    if doc.layout_result is not None:
        if not doc.asset_configurations and ctx.parsed.intact("asset_configurations"):
            _stage(ctx, "layout_result", "asset_configurations")
        _layout(ctx)
    if doc.dynamics_result is not None:
        if doc.layout_result is None and ctx.parsed.intact("layout_result"):
            _stage(ctx, "dynamics_result", "layout_result")
        _dynamics(ctx)
    _coverage(ctx)


def _stage(ctx: Context, present: str, absent: str) -> None:
    ctx.add(
        "STAGE_ORDER",
        "/" + present,
        None,
        f"The document has {present} but no {absent}.",
        f"Run the stage that writes {absent} first, or remove {present}.",
    )


def _configurations(ctx: Context) -> None:
    declared = ctx.parsed.declared("asset_configurations")
    for name in ctx.doc.asset_requirement:
        if name not in declared:
            ctx.add(
                "CONFIG_MISSING",
                pointer("asset_configurations", name),
                None,
                f"Asset {name!r} has no configuration although others have.",
                "Resolve the assets again.",
            )
    structural = {n.asset_id for n in ctx.nodes.values() if n.is_structural}
    for name, asset in ctx.doc.asset_configurations.items():
        where = pointer("asset_configurations", name)
        if name not in ctx.asset_names:
            ctx.add(
                "CONFIG_UNKNOWN",
                where,
                name,
                f"Configuration {name!r} belongs to no asset requirement.",
                f"Use one of {listing(ctx.asset_names)}, or remove it.",
            )
        check_configuration(ctx, where, name, asset, structural=name in structural)


def check_configuration(
    ctx: Context, where: str, name: str, asset: AssetConfiguration, *, structural: bool
) -> None:
    """Adds violations of one configuration, wherever it stands.

    Args:
        ctx: What rules see.
        where: Pointer of the configuration.
        name: Its asset.
        asset: The configuration.
        structural: Whether something structural is made of it.
    """
    _physics(ctx, where, name, asset, structural)
    _geometry(ctx, where, name, asset)
    path = PurePosixPath(asset.mesh_path)
    unsafe = path.is_absolute() or ".." in path.parts or "\\" in asset.mesh_path
    if unsafe or ":" in asset.mesh_path:
        ctx.add(
            "CONFIG_PATH",
            where + "/mesh_path",
            asset.mesh_path,
            f"Mesh path {asset.mesh_path[:80]!r} leaves the scene folder.",
            "Use a relative path such as meshes/sedan.glb.",
        )


def _physics(
    ctx: Context, where: str, name: str, asset: AssetConfiguration, structural: bool
) -> None:
    def report(code: str, field: str, value: Any, limits: tuple[float, float], unit: str) -> None:
        ctx.add(
            code,
            f"{where}/{field}",
            value,
            f"{field} {value} {unit} of {name!r} is not plausible.".replace("  ", " "),
            f"Use {limits[0]:g} to {limits[1]:g} {unit}.".replace(" .", "."),
        )

    if (asset.is_movable and outside(asset.mass_kg, MASS_KG)) or asset.mass_kg < 0.0:
        report("UNIT_MASS", "mass_kg", asset.mass_kg, MASS_KG, "kg")
    limits = SIZE_CM if asset.is_movable and not structural else STRUCTURAL_SIZE_CM
    # A decal (a road marking) has no collision shape and may have no height.
    low = limits[0] if asset.proxies else 0.0
    if any(outside(v, (low, limits[1])) for v in asset.dimensions_cm):
        report("UNIT_SIZE", "dimensions_cm", list(asset.dimensions_cm), (low, limits[1]), "cm")
    if outside(asset.friction, FRICTION):
        report("CONFIG_MATERIAL", "friction", asset.friction, FRICTION, "")
    if outside(asset.restitution, RESTITUTION):
        report("CONFIG_MATERIAL", "restitution", asset.restitution, RESTITUTION, "")
    for field in ("linear_damping", "angular_damping"):
        value: float = getattr(asset, field)
        if outside(value, DAMPING_PER_S):
            report("UNIT_DAMPING", field, value, DAMPING_PER_S, "1/s")
    requirement = ctx.doc.asset_requirement.get(name)
    if requirement is None or not requirement.mass_is_prescribed:
        return
    expected = requirement.expected_mass_kg
    if abs(asset.mass_kg - expected) > MASS_TOLERANCE * max(abs(expected), 1e-9):
        ctx.add(
            "CONFIG_MASS",
            where + "/mass_kg",
            asset.mass_kg,
            f"{name!r} weighs {asset.mass_kg:g} kg, but the prompt prescribes {expected:g} kg.",
            f"Set mass_kg to {expected:g}.",
        )


def _geometry(ctx: Context, where: str, name: str, asset: AssetConfiguration) -> None:
    if asset.is_movable and not asset.proxies and ctx.parsed.intact("asset_configurations"):
        ctx.add(
            "CONFIG_NO_PROXY",
            where + "/proxies",
            [],
            f"{name!r} is movable but has no collision proxy.",
            "Add a proxy, or make the asset fixed.",
        )
    sizes: list[tuple[str, tuple[float, ...]]] = [("scale", asset.scale)]
    for k, proxy in enumerate(asset.proxies):
        # A capsule without a cylindrical part is a sphere: half height zero is fine there.
        size = proxy.size_cm[:2] if proxy.kind.value == "capsule" else proxy.size_cm
        sizes.append((f"proxies/{k}/size_cm", size))
        _quaternion(ctx, f"{where}/proxies/{k}/orientation_xyzw", proxy.orientation_xyzw)
    sizes += [
        (f"regions/{k}/half_extents_cm", r.half_extents_cm) for k, r in enumerate(asset.regions)
    ]
    sizes += [
        (f"support_surfaces/{k}/half_extents_cm", s.half_extents_cm)
        for k, s in enumerate(asset.support_surfaces)
    ]
    for field, size in sizes:
        if any(v <= 0.0 for v in size):
            ctx.add(
                "CONFIG_GEOMETRY",
                f"{where}/{field}",
                list(size),
                f"{field} of {name!r} is not positive.",
                "Give sizes above 0.",
            )


def _quaternion(ctx: Context, where: str, value: Quat) -> None:
    length = math.hypot(*value)
    if abs(length - 1.0) > QUATERNION_TOLERANCE:
        ctx.add(
            "QUATERNION",
            where,
            list(value),
            f"The quaternion's length is {length:g}.",
            "Divide it by its length; the order is x, y, z, w.",
        )


def _layout(ctx: Context) -> None:
    layout = ctx.doc.layout_result
    if layout is None:
        return
    declared = ctx.parsed.declared("layout_result", "poses")
    low, high = ctx.doc.scene_definition.coordinate_system.world_bounds_cm
    for name in ctx.nodes:
        if name not in declared:
            ctx.add(
                "POSE_MISSING",
                pointer("layout_result", "poses", name),
                None,
                f"Node {name!r} has no pose.",
                "Solve the layout again.",
            )
    for name, pose in layout.poses.items():
        where = pointer("layout_result", "poses", name)
        if name not in ctx.node_names:
            ctx.add(
                "POSE_UNKNOWN",
                where,
                name,
                f"A pose is given for {name!r}, which is not a node.",
                f"Use one of {listing(ctx.node_names)}.",
            )
        if any(outside(pose.position_cm[k], (low[k], high[k])) for k in range(3)):
            ctx.add(
                "POSE_RANGE",
                where + "/position_cm",
                list(pose.position_cm),
                f"{name!r} lies outside the world.",
                f"Stay within {list(low)} to {list(high)} cm.",
            )


def _dynamics(ctx: Context) -> None:
    result = ctx.doc.dynamics_result
    if result is None:
        return
    outcomes = [o.value for o in Outcome]
    if result.outcome not in outcomes:
        ctx.add(
            "OUTCOME_UNKNOWN",
            "/dynamics_result/outcome",
            result.outcome,
            f"Outcome {result.outcome!r} is unknown.",
            f"Use one of {listing(outcomes)}.",
        )
    for i, p in enumerate(result.parameters):
        where = pointer("dynamics_result", "parameters", i)
        if not interval(ctx, where, (p.lower, p.upper)):
            continue
        slack = 1e-6 * max(1.0, abs(p.lower), abs(p.upper))
        if not p.lower - slack <= p.value <= p.upper + slack:
            ctx.add(
                "PARAMETER_RANGE",
                where + "/value",
                p.value,
                f"Parameter {p.name!r} is {p.value:g}, outside {p.lower:g} to {p.upper:g}.",
                "Optimize again, or widen the bounds.",
            )
    for name in result.start_poses:
        if name not in ctx.node_names:
            ctx.add(
                "POSE_UNKNOWN",
                pointer("dynamics_result", "start_poses", name),
                name,
                f"A start pose is given for {name!r}, which is not a node.",
                f"Use one of {listing(ctx.node_names)}.",
            )
    if result.program:
        _program(ctx, result.program)


def _program(ctx: Context, program: dict[str, Any]) -> None:
    from esg.engines.program import Lasting, program_from_json

    where = "/dynamics_result/program"
    try:
        _program_types(program)
        primitives = program_from_json(program).primitives
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        ctx.add(
            "PROGRAM_INVALID",
            where,
            None,
            f"The control program cannot be read: {error}.",
            "Optimize again; docs/engines.md describes the primitives.",
        )
        return
    for p in primitives:
        others = p.until_contact if isinstance(p, Lasting) else ()
        for name in (p.body, *others) if p.body else ():
            if name not in ctx.node_names:
                ctx.add(
                    "PROGRAM_BODY",
                    where,
                    name,
                    f"{p.kind} names body {name!r}, which is not a node.",
                    f"Use one of {listing(ctx.node_names)}.",
                )


_VECTORS = ("linear", "angular", "impulse", "axis")
_PATHS = ("points", "velocities")
_ADJUSTED = ("linear_damping", "angular_damping", "friction", "braking")
_MOTOR = ("speed", "position", "limit")
_MAY_BE_NULL = ("end", "angular", *_ADJUSTED, "climb", "gains", "loses", *_MOTOR)


def _program_types(program: dict[str, Any]) -> None:
    """Checks the types of primitives' fields, which the program's reader takes as they are.

    Raises:
        TypeError: Naming the field.
    """

    def number(value: Any) -> bool:
        return isinstance(value, (int, float)) and not isinstance(value, bool)

    def vector(value: Any) -> bool:
        return is_array(value) and list(map(number, value)) == [True] * 3

    if not isinstance(program.get("primitives"), (list, tuple)):
        raise TypeError("/primitives is not a list")
    for i, item in enumerate(program["primitives"]):
        for key, value in dict(item).items():
            if key in ("kind", "body", "joint"):
                good = isinstance(value, str)
            elif key == "until_contact":
                good = is_array(value) and all(isinstance(v, str) for v in value)
            elif value is None:
                good = key in _MAY_BE_NULL
            elif key in _VECTORS:
                good = vector(value)
            elif key in _PATHS:
                good = is_array(value) and all(map(vector, value))
            elif key == "times":
                good = is_array(value) and all(map(number, value))
            else:
                good = number(value)
            if not good:
                raise TypeError(f"/primitives/{i}/{key} is {value!r}")


def _coverage(ctx: Context) -> None:
    prompt = ctx.doc.scene_definition.original_description
    for i, item in enumerate(ctx.doc.coverage.items):
        where = pointer("coverage", "items", i)
        if not 0 <= item.start <= item.end <= len(prompt):
            ctx.add(
                "COVERAGE_SPAN",
                where,
                [item.start, item.end],
                f"{item.text[:80]!r} spans {item.start} to {item.end} of a prompt of "
                f"{len(prompt)} characters.",
                "Give the first character and the one after the last.",
            )
        if item.pointer and not _resolves(ctx.parsed.raw, item.pointer):
            ctx.add(
                "COVERAGE_POINTER",
                where + "/pointer",
                item.pointer,
                f"{item.pointer[:120]!r} names no field of the document.",
                "Give the JSON pointer of the field the words became.",
            )


def _resolves(node: Any, where: str) -> bool:
    if not where.startswith("/"):
        return False
    for text in where[1:].split("/"):
        part = text.replace("~1", "/").replace("~0", "~")
        if is_object(node) and part in node:
            node = node[part]
        elif is_array(node) and part.isdecimal() and int(part) < len(node):
            node = node[int(part)]
        else:
            return False
    return True
