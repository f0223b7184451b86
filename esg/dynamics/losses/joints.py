"""When a jointed thing opens, closes or swings (`measures`); the judge's own rules are the same."""

from __future__ import annotations

import numpy as np

from esg.dynamics.losses.measures import AddTerm, Detected
from esg.dynamics.losses.recording import Floats, Recording
from esg.engines.joints import Joint, opening_asked
from esg.graph.models import TimelineNode
from esg.metrics.models import EVENT_DEGREES
from esg.thresholds import AT_REST_MPS, SHUT_SHARE

SAFE_OPENING = 1.25
"""What opens by so many times what counts opens in every engine."""
DIP_M = 0.008
"""A swing that passes its lowest point by so much on either side does so in every engine."""


def _joints(rec: Recording, name: str) -> list[Joint]:
    """Hinges and sliders by which a thing moves, or else those of its parts."""
    able = [j for j in rec.scene.joints if j.kind in ("hinge", "slider")]
    return [j for j in able if j.child == name] or [j for j in able if j.parent == name]


def _asked(rec: Recording, joint: Joint, node: TimelineNode) -> float:
    degrees = node.turn_degrees or EVENT_DEGREES["opens"]
    return opening_asked(joint, rec.scene.body(joint.child).half_extents, degrees)


def opened(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    time, far = np.full(rec.n, np.inf), np.full(rec.n, 8.0)
    for joint in _joints(rec, node.participants[0]):
        asked, late = _asked(rec, joint, node), rec.late(earliest)
        by = np.abs(rec.opening(joint))
        start = np.where(late, by, np.inf)[np.arange(rec.n), np.argmax(late, axis=1)]
        needed = np.where(start < asked, asked, start + asked)
        time = np.minimum(time, rec.first(late & (by >= needed[:, None])))
        most = np.where(late, by, 0.0).max(axis=1)
        short = np.clip(needed - most, 0.0, None) / asked
        far = np.minimum(far, 0.5 + np.nan_to_num(short, posinf=8.0) ** 2)
        safe = np.where(start < asked, SAFE_OPENING * asked, start + SAFE_OPENING * asked)
        weak = np.clip(safe - most, 0.0, None) / asked
        add(f"{node.id}/weak", np.where(np.isfinite(time), np.nan_to_num(weak), 0.0))
    return Detected(time, far)


def closed(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    time, far = np.full(rec.n, np.inf), np.full(rec.n, 8.0)
    for joint in _joints(rec, node.participants[0]):
        asked, late = _asked(rec, joint, node), rec.late(earliest)
        by = np.abs(rec.opening(joint))
        most = np.maximum.accumulate(np.where(late, by, 0.0), axis=1)
        slow = rec.speed[:, :, rec.scene.index(joint.child)] < AT_REST_MPS
        shut = late & (by <= SHUT_SHARE * asked) & slow & (most - by >= (1 - SHUT_SHARE) * asked)
        time = np.minimum(time, rec.first(shut))
        left = np.clip(by[:, -1] - SHUT_SHARE * asked, 0.0, None) / asked
        far = np.minimum(far, 0.5 + left**2)
    return Detected(time, far)


def swung(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    """Every pass of a lowest point counts."""
    body, count = rec.scene.index(node.participants[0]), node.times or 1
    z = rec.r.position[:, :, body, 2].astype(float)
    late = rec.late(earliest)
    passes, armed, lowest = np.zeros(rec.n, int), np.zeros(rec.n, bool), z[:, 0].copy()
    top, time = z[:, 0].copy(), np.full(rec.n, np.inf)
    for k in range(1, z.shape[1]):
        height = z[:, k]
        lowest = np.where(armed, np.minimum(lowest, height), height)
        rises = armed & (height >= lowest + DIP_M)
        passes += rises & late[:, k]
        time = np.where((passes >= count) & ~np.isfinite(time), rec.t[k], time)
        top = np.where(rises, height, np.maximum(top, height))
        fresh = ~armed & (height <= top - DIP_M)
        armed = (armed & ~rises) | fresh
        lowest = np.where(fresh, height, lowest)
    return Detected(time, 0.5 + np.minimum(count - np.minimum(passes, count), 8.0))
