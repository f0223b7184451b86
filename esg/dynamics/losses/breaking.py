"""When something has broken (`measures`)."""

from __future__ import annotations

import numpy as np

from esg.dynamics.losses.measures import AddTerm, Detected
from esg.dynamics.losses.recording import Floats, Recording
from esg.engines.breaking.swap import Brittle, broken_frames, brittle
from esg.engines.joint_rules import BREAK_WINDOW_S
from esg.graph.models import TimelineNode

SAFE_BLOW = 1.25
"""A blow of so many times what something bears breaks it in every engine."""
MOST_FAR = 4.0


def broke(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    """The blow has to be harder than what it bears; what is missing of that is how far it was."""
    whole = rec.scene.index(node.participants[0])
    own = next((b for b in brittle(rec.scene) if b.whole == whole), None)
    if own is None:
        return Detected(np.full(rec.n, np.inf), np.full(rec.n, MOST_FAR))
    gone = broken_frames(own, rec.r.position, rec.r.quaternion)
    first = rec.first(gone)
    # It breaks in the step of the hit that it follows, which counts at the end of that step.
    time = np.where(first >= earliest - 1.5 / rec.fps, np.maximum(first, earliest), np.inf)
    blow = _hardest(rec, own, first) / own.impulse
    add(f"{node.id}/weak", np.where(np.isfinite(time), np.clip(SAFE_BLOW - blow, 0.0, 1.0), 0.0))
    return Detected(time, np.clip(2.0 - blow, 0.5, MOST_FAR) ** 2)


def _hardest(rec: Recording, b: Brittle, broke_at: Floats) -> Floats:
    """The hardest blow on a body until it broke [N s], shape [W]: by the log, which may lack the
    ground, or by how fast it was before it lost that speed."""
    log = rec.r.contacts
    frame = np.where(np.isfinite(broke_at), broke_at * rec.fps + 1.5, len(rec.t)).astype(int)
    out = np.zeros(rec.n)
    rows = (log.a == b.whole) | (log.b == b.whole)
    sums = np.zeros((rec.n, len(rec.t)))
    np.add.at(sums, (log.world[rows], log.frame[rows]), log.impulse[rows])
    width = max(1, round(BREAK_WINDOW_S * rec.fps))
    window = np.lib.stride_tricks.sliding_window_view(np.pad(sums, ((0, 0), (width - 1, 0))), width, 1)
    blows = window.sum(axis=-1)
    if not rec.scene.bodies[b.whole].static:
        v = rec.r.linear_velocity[:, :, b.whole].astype(float)
        lost = np.zeros(v.shape[:2])
        lost[:, width:] = np.linalg.norm(v[:, width:] - v[:, :-width], axis=-1)
        blows = np.maximum(blows, rec.scene.bodies[b.whole].mass * lost)
    for w in range(rec.n):
        out[w] = blows[w, : max(frame[w], 1)].max(initial=0.0)
    return out
