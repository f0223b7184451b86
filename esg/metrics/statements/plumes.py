"""What gives off smoke, steam, dust or sparks, by the puffs that are drawn at the times stated."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.filming.plumes import MOVES_MPS, Puff, puffs, row_of
from esg.metrics.replay import Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.thresholds import MOST, PUFFS


def gives_off(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Puffs leave it and go on from there by more than their own size, in most of the time."""
    own = replay.scene.bodies[body]
    made = [g for g in own.gives_off if g.name == (q.statement.noun or "")]
    if not made:
        return Kept(False, reason="nothing of the kind is drawn of it")
    way = replay.position[:, body], replay.quaternion[:, body]
    found = [p for g in made for p in puffs(g, own, replay.time, *way, q.times)]
    inside = replay.time[q.window.frames]
    there = [p for p in found if p.begins <= inside[-1] and p.ends >= inside[0]]
    early = sum(p.begins < inside[0] - 0.1 for p in found)
    gone = max((_way(replay, body, p) / p.last for p in there), default=0.0)
    shown = np.array([any(p.begins <= t <= p.ends for p in there) for t in inside])
    if any(row_of(g).moving for g in made):
        shown = shown[_moves(replay, body)[q.window.frames]]
    share = float(shown.mean()) if len(shown) else 0.0
    measured = {"puffs": float(len(there)), "shown_share": share, "way_by_size": gone}
    reason = f"{len(there)} puffs are there for {100 * share:.0f}% of the time"
    holds = len(there) >= PUFFS and share >= MOST - 0.15 and gone >= 0.5
    return Kept.when(holds and not (early and inside[0] > 0.0), reason, **measured)


def _way(replay: Replay, body: int, puff: Puff) -> float:
    """How far a puff gets from where it left its source, as that goes on [m]."""
    ends = min(puff.ends, float(replay.time[-1]))
    first, last = (int(np.searchsorted(replay.time, t)) for t in (puff.begins, ends))
    last = min(last, len(replay.time) - 1)
    source = replay.position[last, body] - replay.position[min(first, last), body]
    return float(np.linalg.norm(np.asarray(puff.velocity) * (ends - puff.begins) - source))


def _moves(replay: Replay, body: int) -> NDArray[np.bool_]:
    step = np.linalg.norm(np.diff(replay.position[:, body], axis=0), axis=1)
    speed = step / np.maximum(np.diff(replay.time), 1e-9)
    return np.append(speed, speed[-1:]) >= MOVES_MPS
