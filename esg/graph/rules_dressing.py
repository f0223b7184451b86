"""Rules on what the stage dress writes: a place that exists and keeps out of everybody's way."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container
import math

from esg.graph.context import Context
from esg.graph.models import Dressing, DressingItem, Pose
from esg.graph.violations import pointer
from esg.lexicon import kinds
from esg.lexicon.places import places, skies, surfaces, things

KEEP_CM = 200.0
"""Nothing that stands comes nearer to a body."""
SIZE_CM = (0.1, 1e5)
REACH_CM = 2e5
MOST = 500
"""Things, and markings, of a dressing."""


def check(ctx: Context) -> None:
    """Adds violations of the dressing."""
    dressing = ctx.doc.dressing
    if dressing is None:
        return
    if ctx.doc.layout_result is None and ctx.parsed.intact("layout_result"):
        ctx.add(
            "STAGE_ORDER",
            "/dressing",
            None,
            "The document has dressing but no layout_result.",
            "Run the stage that writes layout_result first, or remove dressing.",
        )
    if not ctx.doc.scene_definition.scene_parameters.allow_supplementary:
        ctx.add(
            "DRESSING_UNASKED",
            "/dressing",
            dressing.place,
            "The prompt allows no other objects, and yet there is a place around them.",
            "Remove dressing.",
        )
    _names(ctx, dressing)
    _sizes(ctx, dressing)
    _clear(ctx, dressing)


def unknown_names(dressing: Dressing) -> list[tuple[str, str]]:
    """Names in a dressing that are in no table, each with its place below `/dressing`."""
    known = things() | {kind.slug for kind in kinds() if kind.builder}
    told: list[tuple[str, str, Container[str]]] = [
        ("place", dressing.place, places().keys()),
        ("sky", dressing.sky, skies().keys()),
        ("ground", dressing.ground, surfaces().keys()),
    ]
    for i, marking in enumerate(dressing.markings):
        told.append((f"markings/{i}/surface", marking.surface, surfaces().keys()))
    for i, item in enumerate(dressing.items):
        told.append((f"items/{i}/kind", item.kind, known))
        if item.surface is not None:
            told.append((f"items/{i}/surface", item.surface, surfaces().keys()))
    return [(where, name) for where, name, rows in told if name not in rows]


def _names(ctx: Context, dressing: Dressing) -> None:
    for where, name in unknown_names(dressing):
        ctx.add(
            "DRESSING_UNKNOWN",
            f"/dressing/{where}",
            name,
            f"{name[:80]!r} is in no table of what places are made of.",
            "Use a row of the tables in esg/lexicon, or run the stage dress again.",
        )
    for name, count in Counter(item.id for item in dressing.items).items():
        if count > 1:
            ctx.add(
                "DRESSING_TWICE",
                "/dressing/items",
                name,
                f"{count} things of the dressing are called {name[:80]!r}.",
                "Give each its own id.",
            )


def _sizes(ctx: Context, dressing: Dressing) -> None:
    rows = [
        (pointer("dressing", "items", i), i, item.size_cm, item.position_cm)
        for i, item in enumerate(dressing.items)
    ]
    rows += [
        (pointer("dressing", "markings", i), i, (*m.half_cm, m.line_cm or 1.0), (*m.center_cm, 0.0))
        for i, m in enumerate(dressing.markings)
    ]
    for where, number, size, position in rows:
        sound = all(SIZE_CM[0] <= s <= SIZE_CM[1] for s in size)
        if not sound or max(map(abs, position)) > REACH_CM or number >= MOST:
            ctx.add(
                "DRESSING_RANGE",
                where,
                [*size, *position],
                "A thing of the dressing is too small, too large or too far away, or one too many.",
                f"Use at most {MOST} of 1 mm to 1 km, within 2 km.",
            )


def _clear(ctx: Context, dressing: Dressing) -> None:
    for name, pose in _starts(ctx).items():
        x, y, _ = pose.position_cm
        for i, item in enumerate(dressing.items):
            if _distance_cm(item, x, y) < KEEP_CM:
                ctx.add(
                    "DRESSING_NEAR",
                    pointer("dressing", "items", i),
                    item.id,
                    f"{item.id[:80]!r} of the dressing stands within 2 m of {name!r}.",
                    "Run the stage dress again, or move it away.",
                )


def _starts(ctx: Context) -> dict[str, Pose]:
    """Where the solid bodies start."""
    laid = ctx.doc.layout_result
    played = ctx.doc.dynamics_result
    poses = dict(laid.poses) if laid is not None else {}
    poses |= played.start_poses if played is not None else {}
    return {
        name: pose
        for name, pose in poses.items()
        if (node := ctx.nodes.get(name)) is not None
        and (config := ctx.configurations.get(node.asset_id)) is not None
        and config.proxies
    }


def _distance_cm(item: DressingItem, x: float, y: float) -> float:
    """From a point of the ground to a thing's rectangle."""
    yaw = math.radians(item.yaw_deg)
    dx, dy = x - item.position_cm[0], y - item.position_cm[1]
    along = abs(math.cos(yaw) * dx + math.sin(yaw) * dy) - 0.5 * item.size_cm[0]
    across = abs(math.cos(yaw) * dy - math.sin(yaw) * dx) - 0.5 * item.size_cm[1]
    return math.hypot(max(along, 0.0), max(across, 0.0))
