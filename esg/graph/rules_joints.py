"""Rules on joints: what they connect exists, and says what its kind needs."""

from __future__ import annotations

from esg.graph.context import Context, components
from esg.graph.joints import mount_of
from esg.graph.models import Joint
from esg.graph.rules_scene import interval
from esg.graph.violations import listing, pointer

_LENGTH = ("rope", "spring")
_KNOWS = {
    "hinge": {"lower", "upper", "position", "stiffness", "damping", "friction", "motor"},
    "slider": {"lower", "upper", "position", "stiffness", "damping", "friction", "motor"},
    "ball": {"upper", "position", "damping", "friction"},
    "fixed": set[str](),
    "rope": {"upper", "position", "damping"},
    "spring": {"upper", "position", "stiffness", "damping"},
}
"""Fields by kind; what every kind has is not listed."""
_NOT_NEGATIVE = ("stiffness", "damping", "friction", "break_impulse")


def check(ctx: Context) -> None:
    """Adds violations of joints."""
    seen: set[str] = set()
    placed: list[tuple[str, str]] = []
    for i, joint in enumerate(ctx.graph.joints or ()):
        here = pointer("spatial_relation_graph", "joints", i)
        if joint.id in seen:
            ctx.add(
                "JOINT_TWICE",
                here + "/id",
                joint.id,
                f"{joint.id!r} is the id of an earlier joint.",
                "Give every joint its own id.",
            )
        seen.add(joint.id)
        _ends(ctx, here, joint)
        _fields(ctx, here, joint)
        _values(ctx, here, joint)
        if joint.parent is not None and joint.parent != joint.child:
            placed.append((joint.child, joint.parent))
    for circle in components(list(ctx.nodes), placed):
        ctx.add(
            "JOINT_CIRCLE",
            pointer("spatial_relation_graph", "joints"),
            circle,
            f"Joints carry each other in a circle: {listing(circle)}.",
            "Let one of them be the parent of none that carries it.",
        )


def _ends(ctx: Context, here: str, joint: Joint) -> None:
    for end, name in (("child", joint.child), ("parent", joint.parent)):
        if name is not None and name not in ctx.node_names:
            ctx.add(
                "JOINT_UNKNOWN",
                f"{here}/{end}",
                name,
                f"{name!r} is no node of the document.",
                f"Use one of {listing(ctx.node_names)}.",
            )
    child = ctx.nodes.get(joint.child)
    if joint.child == joint.parent or (child and (child.is_structural or child.is_static)):
        ctx.add(
            "JOINT_CHILD",
            here + "/child",
            joint.child,
            f"{joint.child!r} cannot be moved by {joint.id!r}.",
            "Name what moves as the child, and what carries it as the parent.",
        )
    mounts = (
        ("child", joint.child, joint.child_mount),
        ("parent", joint.parent, joint.parent_mount),
    )
    for end, name, mount in mounts:
        node = ctx.nodes.get(name or "")
        asset = ctx.configurations.get(node.asset_id) if node is not None else None
        if mount is not None and asset is not None and mount_of(asset, mount) is None:
            ctx.add(
                "JOINT_MOUNT",
                f"{here}/{end}_mount",
                mount,
                f"{asset.asset_name!r} of {name!r} has no mount {mount!r}.",
                f"Use one of {listing(m.name for m in asset.mounts or ())}.",
            )


def _fields(ctx: Context, here: str, joint: Joint) -> None:
    """What a joint's kind does not know, and what it lacks."""
    given = {
        "lower": joint.lower,
        "upper": joint.upper,
        "position": joint.position or None,
        "stiffness": joint.stiffness,
        "damping": joint.damping,
        "friction": joint.friction,
        "motor": joint.motor,
    }
    for name in (n for n, v in given.items() if v is not None and n not in _KNOWS[joint.kind]):
        ctx.add(
            "JOINT_FIELD",
            f"{here}/{name}",
            name,
            f"A {joint.kind} has no {name}.",
            f"Leave it out; a {joint.kind} knows {listing(_KNOWS[joint.kind])}.",
        )
    needed = {
        "upper": joint.kind in _LENGTH and joint.upper is None,
        "stiffness": joint.kind == "spring" and joint.stiffness is None,
        "parent_mount": joint.kind in _LENGTH and joint.parent_mount is None,
        "parent": joint.parent is None and joint.parent_mount is not None,
    }
    for name in (n for n, missing in needed.items() if missing):
        ctx.add(
            "JOINT_FIELD",
            f"{here}/{name}",
            None,
            f"The {joint.kind} {joint.id!r} needs a {name}.",
            "Give it.",
        )


def _values(ctx: Context, here: str, joint: Joint) -> None:
    values = {name: getattr(joint, name) for name in _NOT_NEGATIVE}
    values |= {"motor/limit": joint.motor.limit} if joint.motor else {}
    values |= {"upper": joint.upper} if joint.kind in (*_LENGTH, "ball") else {}
    for name, value in values.items():
        if value is not None and value < 0.0:
            ctx.add(
                "JOINT_VALUE",
                f"{here}/{name}",
                value,
                f"{name} {value:g} of {joint.id!r} is negative.",
                "Use 0 or more.",
            )
    if joint.kind not in ("hinge", "slider"):
        return
    low = float("-inf") if joint.lower is None else joint.lower
    high = float("inf") if joint.upper is None else joint.upper
    if interval(ctx, here + "/lower", (low, high)) and not low <= joint.position <= high:
        ctx.add(
            "JOINT_POSITION",
            here + "/position",
            joint.position,
            f"{joint.id!r} starts at {joint.position:g}, outside of {low:g} to {high:g}.",
            "Start it within its limits, or widen them.",
        )
