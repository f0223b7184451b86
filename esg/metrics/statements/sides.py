"""On which side something is struck: where, in its own frame, another one first touches it."""

from __future__ import annotations

import math

import numpy as np

from esg.graph.models import Side
from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.thresholds import HIT_GAP_S, SIDE_DEG, SIDE_SHARE
from esg.units import quat_rotate

_FACES = {
    "front": (1.0, 0.0, 0.0),
    "rear": (-1.0, 0.0, 0.0),
    "left": (0.0, 1.0, 0.0),
    "right": (0.0, -1.0, 0.0),
    "top": (0.0, 0.0, 1.0),
    "bottom": (0.0, 0.0, -1.0),
}
"""The way each side of a body looks, in its own axes."""
_MEANT: dict[Side, tuple[str, ...]] = {
    "front": ("front",),
    "rear": ("rear",),
    "left": ("left",),
    "right": ("right",),
    "side": ("left", "right"),
    "any_side": ("front", "rear", "left", "right"),
}


def struck_on(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its first touch by the target is on the stated side.

    Measured in halves of its bounding box, the contact point is nearest to that side, give or take
    `SIDE_SHARE`, and the surface there looks that way, within `SIDE_DEG`.
    """
    touch = first_touch(replay, q, body)
    side = q.statement.side
    if touch is None or side is None:
        return Kept(False, reason=f"is not touched by {q.goal}")
    point, normal = touch
    share = point / np.array(replay.scene.bodies[body].half_extents)
    apart = {name: 1.0 - float(face @ share) for name, face in _faces().items()}
    slack = min(apart.values()) + SIDE_SHARE
    looks = {name: _angle_deg(normal, face) for name, face in _faces().items()}
    best = min(_MEANT[side], key=lambda name: (apart[name] > slack, looks[name]))
    found = min(apart, key=lambda name: (apart[name] > slack, looks[name]))
    return Kept.when(
        apart[best] <= slack and looks[best] <= SIDE_DEG,
        f"is struck on its {found}, {looks[best]:.0f} degrees off its {side.replace('_', ' ')}",
        off_deg=looks[best],
        point_x_m=float(point[0]),
        point_y_m=float(point[1]),
        point_z_m=float(point[2]),
    )


def first_touch(replay: Replay, q: StatementQuery, body: int) -> tuple[Floats, Floats] | None:
    """Where any of the target first touches a body in the time, in the body's own axes.

    Returns:
        Contact point from the middle of its bounding box [m] and the unit outward normal of its
        surface there, each of shape [3] and weighted by impulse over `HIT_GAP_S`; None without a
        touch.
    """
    c = replay.contacts
    mine = (c.a == body) | (c.b == body)
    other = np.where(c.a == body, c.b, c.a)
    inside = np.array([q.window.contains(float(t), replay) for t in c.time], dtype=bool)
    rows = mine & np.isin(other, q.target.bodies) & (c.impulse > 0) & inside
    if not rows.any():
        return None
    first = float(c.time[rows].min())
    rows &= c.time <= first + HIT_GAP_S
    frame = replay.frame_before(first + replay.frame_s)
    back = replay.quaternion[frame, body] * np.array([-1.0, -1.0, -1.0, 1.0])
    outward = np.where(c.a[rows] == body, -1.0, 1.0)[:, None] * c.normal[rows]
    point = np.average(c.point[rows], axis=0, weights=c.impulse[rows])
    normal = np.average(outward, axis=0, weights=c.impulse[rows])
    b = replay.scene.bodies[body]
    middle = np.array(b.origin_offset) + np.array([0.0, 0.0, b.half_extents[2]])
    local = quat_rotate(back, point - replay.position[frame, body]) - middle
    return local, quat_rotate(back, normal / max(float(np.linalg.norm(normal)), 1e-9))


def _faces() -> dict[str, Floats]:
    return {name: np.array(face) for name, face in _FACES.items()}


def _angle_deg(normal: Floats, face: Floats) -> float:
    """How far a surface looks off a side, over the ground for the upright ones [degrees]."""
    if face[2] == 0.0:
        level = normal * np.array([1.0, 1.0, 0.0])
        flat = float(np.linalg.norm(level))
        if flat < math.sin(math.radians(90.0 - SIDE_DEG)):
            return 90.0  # it looks up or down
        normal = level / flat
    return math.degrees(math.acos(min(1.0, max(-1.0, float(normal @ face)))))
