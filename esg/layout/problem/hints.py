"""Where planned motion needs things to start: the planner's request to the layout stage.

A constellation fixes the relative start of the bodies that take part in a motion (car, bin, table
of a chain) in one frame; the layout chooses where the whole constellation stands, places everything
else, and keeps bystanders out of the corridors that the motion sweeps.
"""

from __future__ import annotations

from dataclasses import dataclass
import itertools
import math

from esg.graph.models import Choreography


@dataclass(frozen=True)
class Placement:
    """Start of one node in the constellation's frame.

    Args:
        node: Node id, or "group:NAME" for a whole group. A group pattern's own frame has its first
            member (head pin, front of a row) at the origin and the others towards local +X.
        x_cm, y_cm: Position of the asset origin (bottom centre).
        yaw_deg: Heading in the constellation's frame; None leaves it to the layout.
        z_cm: Height of the asset origin above the ground for bodies that start in the air (a throw,
            a drop); None rests the body on its support.
    """

    node: str
    x_cm: float
    y_cm: float
    yaw_deg: float | None = 0.0
    z_cm: float | None = None


@dataclass(frozen=True)
class Corridor:
    """A swept path that only its participants may touch at the start.

    Args:
        points_cm: Polyline in the constellation's frame, shape [n, 2].
        half_width_cm: Including a safety margin.
        participants: Node ids (or "group:NAME") that belong on the path.
    """

    points_cm: tuple[tuple[float, float], ...]
    half_width_cm: float
    participants: tuple[str, ...]


@dataclass(frozen=True)
class Constellation:
    """Bodies whose relative start is planned.

    Args:
        placements: At least one.
        corridors: Swept paths.
        anchor: Node whose asset frame is the constellation's frame (a billiard table, a lane); None
            lets the layout choose position and yaw of the frame.
        yaw_deg: World yaw of the frame if it is prescribed (anchor None), else free.
    """

    placements: tuple[Placement, ...]
    corridors: tuple[Corridor, ...] = ()
    anchor: str | None = None
    yaw_deg: float | None = None


@dataclass(frozen=True)
class StartHints:
    constellations: tuple[Constellation, ...] = ()


def stored_hints(told: Choreography) -> StartHints:
    """The starts that a document's choreography asks for."""
    return StartHints(
        tuple(
            Constellation(
                tuple(Placement(p.node, p.x_cm, p.y_cm, p.yaw_deg, p.z_cm) for p in c.placements),
                tuple(Corridor(k.points_cm, k.half_width_cm, k.participants) for k in c.corridors),
                c.anchor,
                c.yaw_deg,
            )
            for c in told.constellations
        )
    )


def in_the_way(corridor: Corridor, x: float, y: float, radius: float) -> bool:
    """Whether a disc touches a swept path."""
    least = math.inf
    for (x0, y0), (x1, y1) in itertools.pairwise(corridor.points_cm):
        dx, dy = x1 - x0, y1 - y0
        square = dx * dx + dy * dy
        t = ((x - x0) * dx + (y - y0) * dy) / square if square > 0 else 0.0
        t = min(max(t, 0.0), 1.0)
        least = min(least, math.hypot(x - x0 - t * dx, y - y0 - t * dy))
    return least < corridor.half_width_cm + radius
