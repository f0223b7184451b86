"""Rules on what breaks: how hard a blow, into how many pieces, and that nothing holds it."""

from __future__ import annotations

from esg.graph.context import Context
from esg.graph.violations import pointer

PIECES = (2, 64)
"""Few enough to be simulated beside everything else."""
MOST_CM_S = 5000.0
"""Nothing that breaks bears the blow of a bullet train."""


def check(ctx: Context) -> None:
    """Adds violations of what breaks."""
    joined = {n for j in ctx.graph.joints or () for n in (j.child, j.parent)}
    for name, node in ctx.nodes.items():
        told = node.breaking
        if told is None:
            continue
        here = pointer("spatial_relation_graph", "nodes", name, "breaking")
        if not 0.0 < told.speed <= MOST_CM_S:
            ctx.add(
                "BREAK_SPEED",
                here + "/speed",
                told.speed,
                f"{name!r} breaks at {told.speed:g} cm/s.",
                f"Use more than 0 and at most {MOST_CM_S:g} cm/s.",
            )
        if not PIECES[0] <= told.pieces <= PIECES[1]:
            ctx.add(
                "BREAK_PIECES",
                here + "/pieces",
                told.pieces,
                f"{name!r} breaks into {told.pieces} pieces.",
                f"Use {PIECES[0]} to {PIECES[1]}.",
            )
        if name in joined or node.is_structural:
            ctx.add(
                "BREAK_HELD",
                here,
                name,
                f"{name!r} is {'joined' if name in joined else 'structure'} and cannot break.",
                "Leave out `breaking`, or what holds it.",
            )
