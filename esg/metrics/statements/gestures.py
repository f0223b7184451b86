"""What somebody does with arms, head or tail, by what is drawn; and whom or what he faces."""

from __future__ import annotations

import numpy as np

from esg.engines.wheels import gesturing
from esg.lexicon.gestures import EASES
from esg.metrics.replay import Replay
from esg.metrics.statements.place import mostly
from esg.metrics.statements.query import Kept, StatementQuery
from esg.thresholds import FACES_DEG, GESTURE_S, GESTURE_SHARE
from esg.units import quat_rotate


def gestures(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Hand, head or tail go as far as is seen, within the stated time and not before it."""
    own = replay.scene.bodies[body]
    made = [g for g in own.gestures if g.name == (q.statement.noun or "")]
    if not made:
        return Kept(False, reason="nothing of its model makes such a gesture")
    aside = _elsewhere(replay, q, body)
    if aside:
        return Kept(False, reason=aside)
    tall = 2.0 * max(own.half_extents)
    best = Kept(False, reason="it is not made in that time")
    for g in made:
        fine = np.arange(0.0, replay.end, 1.0 / 60.0)
        states = gesturing(g, fine, q.times)
        inside = (fine >= q.window.begin) & (fine <= q.window.end)
        lasts = float((states[inside, 0] == EASES).sum()) / 60.0
        early = float((states[~inside, 0] > 0).sum()) / 60.0
        ways = np.sign(np.diff(states[inside, 1]))
        turns = int(np.count_nonzero(np.diff(ways[ways != 0])))
        far = g.sweep_m if g.period_s else g.rise_m
        share = far / tall
        measured = {"tip_share": share, "lasts_s": lasts, "turns": float(turns)}
        reason = (
            f"its tip goes {100 * share:.0f}% of its height for {lasts:.1f} s, {turns} times back; "
            f"asked: {100 * GESTURE_SHARE:g}% for {GESTURE_S:g} s"
        )
        seen = share >= GESTURE_SHARE and lasts >= GESTURE_S
        seen = seen and (turns >= 1 or not g.period_s) and early <= GESTURE_S
        found = Kept.when(seen, reason, **measured)
        if found.kept:
            return found
        best = found
    return best


def _elsewhere(replay: Replay, q: StatementQuery, body: int) -> str:
    """Why nobody looks up or down at something: it is not there; empty if it is."""
    said = q.statement.noun or ""
    if not q.target.bodies or said not in ("looks up", "looks down"):
        return ""
    k = int(q.window.samples(replay)[0])
    eyes = float(replay.position[k, body, 2]) + 0.8 * replay.scene.bodies[body].half_extents[2]
    ups = [float(replay.position[k, other, 2]) > eyes for other in q.target.bodies]
    holds = any(ups) if said == "looks up" else not all(ups)
    return "" if holds else f"{q.goal} is not {'above' if said == 'looks up' else 'below'} its eyes"


def faces(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its front is turned towards the target."""
    samples = q.window.samples(replay)
    front = quat_rotate(replay.quaternion[samples, body], np.array([1.0, 0.0, 0.0]))[:, :2]
    off = np.full(len(samples), 180.0)
    for other in (j for j in q.target.bodies if j != body):
        way = replay.position[samples, other, :2] - replay.position[samples, body, :2]
        lengths = np.linalg.norm(way, axis=1) * np.linalg.norm(front, axis=1)
        cosine = np.einsum("ti,ti->t", way, front) / np.maximum(lengths, 1e-9)
        off = np.minimum(off, np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))
    reason = f"face {q.goal}"
    return mostly(off <= FACES_DEG, reason, off_deg=float(off.max()))
