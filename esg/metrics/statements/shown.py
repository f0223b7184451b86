"""What is lit, falls from the sky and sways, measured on what is drawn at the times stated."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from esg.assets.colors import find_color
from esg.engines.wheels import TURN_S, bent_by, phase_of, shining
from esg.lexicon.shown import read_lit, weather_of
from esg.metrics.replay import Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.thresholds import FALLS_MPS, LIT_COLOR, LIT_MOMENT_S, SIGHT_M, SWAYS_SHARE


def lit(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its light shines at the times, in the colour and with the flashes that are said."""
    said = read_lit(q.statement.noun or "")
    if said is None:
        return Kept(None, reason=f"no light is drawn for {q.statement.noun!r}")
    light, turned, how, color = said
    own = [s for s in replay.scene.bodies[body].shines if _is_of(light.parts, s.part)]
    rgb = find_color(color)
    if turned and rgb is not None:  # of a light that turns red, the red one
        own = [s for s in own if _apart(rgb, s.color) <= LIT_COLOR]
    if not own:
        return Kept(False, reason=f"its model has no {light.name}")
    fine = np.arange(0.0, replay.end, 0.02)
    shines = np.any([shining(s, fine, q.times) for s in own], axis=0)
    if turned:
        return _turned(q, fine, shines, on=how == "on")
    inside = (fine >= q.window.begin) & (fine <= max(q.window.end, q.window.begin + 0.02))
    share = float(shines[inside].mean())
    changes = int(np.count_nonzero(np.diff(shines[inside].astype(int))))
    measured = {"lit_share": share, "changes": float(changes)}
    if rgb is not None:
        off = min(_apart(rgb, s.color) for s in own)
        if off > LIT_COLOR:
            return Kept(False, {**measured, "color_off": off}, f"it shines {off:.2f} off {color}")
    if how == "flashing":
        reason = f"its light changes {changes} times"
        return Kept(changes >= 2 and 0.1 < share < 0.9, measured, reason)
    wanted = 1.0 if how == "on" else 0.0
    reason = f"it shines for {100 * share:.0f}% of the time"
    return Kept.when(share == wanted, reason, **measured)


def _turned(
    q: StatementQuery, time: NDArray[np.float64], shines: NDArray[np.bool_], *, on: bool
) -> Kept:
    """Before its moment it is the other way than after it."""
    when = q.statement.when
    at = q.times.get(when) if when in q.times else TURN_S
    if at is None:
        return Kept(False, reason=f"event {when} did not happen")
    before = shines[time < at - LIT_MOMENT_S]
    after = shines[time > at + LIT_MOMENT_S]
    if not len(before) or not len(after):
        return Kept(False, {"turns_at_s": at}, "the scene shows only one side of the change")
    first, last = float((before == on).mean()), float((after == on).mean())
    reason = f"it is so for {100 * first:.0f}% of the time before and {100 * last:.0f}% after"
    return Kept.when(
        first == 0.0 and last == 1.0, reason, so_before=first, so_after=last, turns_at_s=at
    )


def _is_of(parts: tuple[str, ...], part: str) -> bool:
    own = tuple(p.removesuffix("+") for p in parts)
    return part.startswith(own) if own else part == "flame"


def _apart(a: tuple[float, float, float], b: tuple[float, float, float]) -> float:
    """The largest difference of two colours in a channel."""
    return max(abs(x - y) for x, y in zip(a, b, strict=True))


def sways(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """The tip of what is drawn goes to and fro by a share of its size."""
    b = replay.scene.bodies[body]
    if b.sways is None:
        return Kept(False, reason="nothing of its model sways")
    inside = replay.time[q.window.frames]
    turned = bent_by(b.sways, inside, phase_of(b))
    reach = math.sin(float(np.ptp(turned)))
    swings = int(np.count_nonzero(np.diff(np.sign(np.diff(turned))) != 0))
    reason = f"its tip goes {100 * reach:.1f}% of its size; limit {100 * SWAYS_SHARE:g}%"
    return Kept.when(
        reach >= SWAYS_SHARE and swings >= 1, reason, tip_share=reach, turns=float(swings)
    )


def weather(replay: Replay, q: StatementQuery) -> Kept:
    """What is said falls all around at its speed, or hides what is far."""
    noun = q.statement.noun or ""
    said = weather_of(noun)
    if said is None:
        return Kept(None, reason=f"no weather is drawn for {noun!r}")
    row, _ = said
    drawn = [found for w in replay.scene.weather if (found := weather_of(w)) is not None]
    found = next((d for d in drawn if d[0].name == row.name), None)
    if found is None:
        return Kept(False, reason=f"no {row.name} is drawn")
    sight = min(d.sight_m / much for d, much in drawn)
    measured = {"falls_mps": found[0].falls_mps, "sight_m": sight}
    low, high = FALLS_MPS.get(row.name, (0.0, 0.0))
    limits = f"{low:g} to {high:g} m/s" if high else f"sight of at most {SIGHT_M:g} m"
    reason = f"it falls at {found[0].falls_mps:g} m/s, with a sight of {sight:g} m; {limits} asked"
    holds = low <= found[0].falls_mps <= high if high else sight <= SIGHT_M
    return Kept.when(holds, reason, **measured)
