"""Rigid units of a layout: what moves together, and the groups that a document names."""

from __future__ import annotations

from dataclasses import dataclass, field

from esg.graph.models import EsgDocument
from esg.layout.problem.hints import Corridor
from esg.layout.problem.poses import Pose2


@dataclass
class Unit:
    """Nodes that move together.

    Args:
        members: Pose of each node in the unit's frame (x, y [cm], yaw [rad]).
        parent: Node that carries the unit; None is the world.
        pose: Fixed or preferred pose in the parent's frame.
        free: Whether x, y and yaw may change.
        corridors: Swept paths in the unit's frame.
        z_cm: World heights of members that start in the air.
        is_planned: Comes from the planner.
    """

    members: dict[str, Pose2]
    parent: str | None = None
    pose: Pose2 = (0.0, 0.0, 0.0)
    free: tuple[bool, bool, bool] = (True, True, True)
    corridors: list[Corridor] = field(default_factory=list)
    z_cm: dict[str, float] = field(default_factory=dict)
    is_planned: bool = False
    anchor: str | None = None


def group_members(doc: EsgDocument) -> dict[str, list[str]]:
    """Returns the members of every group in document order."""
    out: dict[str, list[str]] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        if node.group is not None:
            out.setdefault(node.group, []).append(name)
    return out
