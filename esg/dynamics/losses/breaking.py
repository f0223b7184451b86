"""When something has broken (`measures`)."""

from __future__ import annotations

import numpy as np

from esg.dynamics.losses.measures import AddTerm, Detected
from esg.dynamics.losses.recording import Floats, Recording
from esg.engines.breaking.swap import brittle, broken_frames
from esg.engines.joint_rules import BREAK_WINDOW_S
from esg.graph.models import TimelineNode

SAFE_BLOW = 1.25
"""A blow of so many times what something bears breaks it in every engine."""
MOST_FAR = 4.0


def broke(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    """The blow has to be harder than what it bears; what is missing of that is how far it was.

    Of a blow that broke it too early, a push off a table, it is by how much that was too hard.
    """
    whole = rec.scene.index(node.participants[0])
    bears = rec.scene.bodies[whole].break_impulse
    if bears is None:
        return Detected(np.full(rec.n, np.inf), np.full(rec.n, MOST_FAR))
    blows = _blows(rec, whole)
    own = next((b for b in brittle(rec.scene) if b.whole == whole), None)
    # What knows no fragments only tells how hard it was hit.
    gone = blows > bears if own is None else broken_frames(own, rec.r.position, rec.r.quaternion)
    first = rec.first(gone)
    # It breaks in the step of the hit that it follows, which counts at the end of that step.
    early = first < earliest - 1.5 / rec.fps
    time = np.where(early, np.inf, np.maximum(first, earliest))
    last = np.where(np.isfinite(first), first, rec.t[-1])
    hardest = np.where(rec.t <= last[:, None] + 1.5 / rec.fps, blows, 0.0).max(axis=1) / bears
    short = np.clip(SAFE_BLOW - hardest, 0.0, 1.0)
    add(f"{node.id}/weak", np.where(np.isfinite(time), short, 0.0))
    missing = np.where(early, np.minimum(hardest, MOST_FAR), np.clip(2.0 - hardest, 0.5, MOST_FAR))
    return Detected(time, missing**2)


def _blows(rec: Recording, body: int) -> Floats:
    """What a body takes within `BREAK_WINDOW_S` [N s], shape [W, T]: by the log, which may lack the
    ground, or by how its velocity changes."""
    log = rec.r.contacts
    rows = (log.a == body) | (log.b == body)
    sums = np.zeros((rec.n, len(rec.t)))
    np.add.at(sums, (log.world[rows], log.frame[rows]), log.impulse[rows])
    width = max(1, round(BREAK_WINDOW_S * rec.fps))
    padded = np.pad(sums, ((0, 0), (width - 1, 0)))
    out = np.lib.stride_tricks.sliding_window_view(padded, width, axis=1).sum(axis=-1)
    if not rec.scene.bodies[body].static:
        v = rec.r.linear_velocity[:, :, body].astype(float)
        lost = np.linalg.norm(v[:, width:] - v[:, :-width], axis=-1)
        out[:, width:] = np.maximum(out[:, width:], rec.scene.bodies[body].mass * lost)
    return out
