"""What vessels are filled with, and what floats or sinks in it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Region
from esg.lexicon.contents import CONTENT
from esg.metrics.liquids import content_name, is_liquid, over_basin
from esg.metrics.replay import Replay
from esg.metrics.statements.place import mostly
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import bounds
from esg.thresholds import AFLOAT_M, SUNK_SHARE, UPRIGHT_DEG
from esg.units import quat_rotate


def filled_with(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """A level of that content is in it, and it stands so upright that it stays there."""
    region = _content(replay, body, q.statement.noun)
    if region is None:
        return Kept(False, reason=f"there is no {q.statement.noun or 'content'} in it")
    samples = q.window.samples(replay)
    up = quat_rotate(replay.quaternion[samples, body], np.array([0.0, 0.0, 1.0]))
    tilt = np.degrees(np.arccos(np.clip(up[:, 2], -1.0, 1.0)))
    return mostly(
        tilt <= UPRIGHT_DEG,
        "stay upright: what is in it would spill",
        tilt_deg=float(tilt.max()),
        depth_m=2.0 * region.half_extents[2],
    )


def floats(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It is at the level of the liquid, partly above it, and touches no bottom."""
    samples = q.window.samples(replay)
    held, off = np.zeros(len(samples), bool), np.full(len(samples), np.nan)
    for vessel in q.target.bodies:
        region = _content(replay, vessel, q.statement.noun)
        if region is None or not is_liquid(region):
            continue
        over, low, high, level, bottom = _heights(replay, body, region, samples)
        held |= over & (low > bottom + AFLOAT_M) & (low < level) & (high > level)
        off = low - level
    if np.isnan(off).all():
        return Kept(False, reason=f"there is no liquid in {q.goal}")
    return mostly(held, f"float in {q.goal}", lowest_m=float(off[-1]))


def sinks(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """At the end of the time it lies at the bottom of the liquid, or all of it is below its level
    and in the lower part of it."""
    samples = q.window.samples(replay)[-1:]
    for vessel in q.target.bodies:
        region = _content(replay, vessel, q.statement.noun)
        if region is None or not is_liquid(region):
            continue
        over, low, high, level, bottom = (v[-1] for v in _heights(replay, body, region, samples))
        deep = low <= bottom + max(AFLOAT_M, SUNK_SHARE * (level - bottom))
        measured = {"over_bottom_m": float(low - bottom), "below_level_m": float(level - high)}
        reason = f"does not end at the bottom of {q.goal}"
        return Kept.when(bool(over and deep and 0.5 * (low + high) < level), reason, **measured)
    return Kept(False, reason=f"there is no liquid in {q.goal}")


def _content(replay: Replay, body: int, noun: str | None) -> Region | None:
    """The region of a vessel's content, of the one of that name if one is named."""
    name = replay.scene.bodies[body].name
    found = (r for r in replay.scene.regions if r.parent == name and r.kind == CONTENT)
    return next((r for r in found if noun is None or content_name(r) == noun), None)


Floats = NDArray[np.float64]


def _heights(
    replay: Replay, body: int, region: Region, samples: NDArray[np.int64]
) -> tuple[NDArray[np.bool_], Floats, Floats, Floats, Floats]:
    """Per sample: whether a body is within the sides of a liquid, its lowest and its highest
    point, the level and the bottom [m]."""
    over, level = over_basin(replay, body, region, samples)
    boxes = [bounds(replay, body, int(k)) for k in samples]
    low, high = (np.array([b[i][2] for b in boxes], float) for i in (0, 1))
    return over, low, high, level, level - 2.0 * region.half_extents[2]
