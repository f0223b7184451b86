"""What became of a scene's events in every engine, at every step and after every change: rows.

Rows here lack only the columns that all tables share; `esg.dataset.whatifs.stage` keeps them as an
artifact of the batch, so that a batch that was killed does not replay anything twice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from esg.dataset.whatifs.amounts import ENGINES, Variable
from esg.dataset.whatifs.replaying import Played, play
from esg.dataset.whatifs.worlds import (
    UNCHANGED,
    NotApplicable,
    Part,
    changed,
    taken_away,
    unchanged,
)
from esg.engines.manifest import Manifest
from esg.metrics import judge
from esg.metrics.models import EventVerdict, SceneVerdict, SuiteEvent, SuiteScene

RATES_HZ = (240, 480)
"""Steps a second of `--engines`: the one that scenes are verified with, and half that step."""
WHAT_IF_DT_S = 1.0 / RATES_HZ[0]
SAME_EVENT_S = 0.1
"""An event that is judged for itself this close to its time in the order is the same."""


@dataclass(frozen=True)
class Asked:
    """What a dataset asks of every scene.

    Args:
        what_if: Variables to change.
        engines: Engines to replay the unchanged scene in, at every rate of `RATES_HZ`.
    """

    what_if: tuple[Variable, ...] = ()
    engines: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.what_if or self.engines)


@dataclass(frozen=True)
class Alternatives:
    """Rows of one scene.

    Args:
        engine_events: Of table `engine_events`.
        what_ifs: Of table `what_ifs`.
        seconds: Time spent [s] by stage: engines, what_ifs.
    """

    engine_events: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    what_ifs: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    seconds: dict[str, float] = field(default_factory=dict[str, float])


def alternatives(
    manifest: Manifest,
    expected: SuiteScene,
    taking_part: Sequence[str],
    asked: Asked,
    *,
    name: str,
    seed: int,
) -> Alternatives:
    """Replays a scene in other engines and with other values, and judges every replay.

    Args:
        manifest: Its physical scene and control program.
        expected: What must happen in it.
        taking_part: Names of the bodies of its completed events, in their order.
        asked: What to replay.
        name, seed: Of the scene; they pick amounts and bodies.
    """
    base = unchanged(manifest.scene, manifest.program)
    part = Part(manifest.scene, manifest.program, tuple(taking_part), f"{name}/{seed}")
    worlds, refused = [base], dict[str, str]()
    for variable in asked.what_if:
        try:
            worlds.append(changed(part, variable))
        except NotApplicable as why:
            refused[variable] = str(why)
    together = ENGINES if asked.what_if else asked.engines
    played = [
        p
        for engine in ENGINES
        if engine in together or engine in asked.engines
        for p in play(worlds if engine in together else [base], engine, WHAT_IF_DT_S)
    ]
    finer = [
        p for engine in asked.engines for rate in RATES_HZ[1:]
        for p in play([base], engine, 1.0 / rate)
    ]  # fmt: skip
    judged = {id(p): _judged(p, expected) for p in (*played, *finer)}
    freely: dict[int, list[EventVerdict]] = {}
    if asked.what_if:
        loose = _without_order([p for p in played if p.world is base], judged, expected)
        freely = {id(p): _judged_freely(p, loose) for p in played}
    of_base = [p for p in played if p.world is base]
    rows = _engine_rows([p for p in of_base if p.engine in asked.engines] + finer, judged)
    what_ifs = _what_if_rows(played, freely, expected) if asked.what_if else []
    what_ifs += [_refused_row(v, why, e) for v, why in refused.items() for e in ENGINES]
    seconds = {"engines": _spent(of_base + finer), "what_ifs": _spent(played) - _spent(of_base)}
    return Alternatives(rows, what_ifs, seconds)


def _spent(played: Sequence[Played]) -> float:
    return sum(p.seconds for p in played)


def failed_rows(asked: Asked, reason: str) -> Alternatives:
    """The rows of a scene of which nothing could be replayed: an empty event stands for all."""
    events = [
        {"engine": e, "dt_s": 1.0 / rate, "event_id": "", "event_index": 0, "reason": reason}
        for e in asked.engines
        for rate in RATES_HZ
    ]
    what_ifs = [
        {"variable": variable, "engine": engine, "outcome": "failed", "reason": reason}
        for variable in ((UNCHANGED, *asked.what_if) if asked.what_if else ())
        for engine in ENGINES
    ]
    return Alternatives(events, what_ifs)


def _judged(played: Played, expected: SuiteScene) -> list[EventVerdict]:
    """What became of every event; none of what needs a body that was taken away."""
    if played.rollout is None:
        return [_lost(e, played.reason) for e in expected.events]
    world = played.world
    verdict = judge(world.scene, world.program, played.rollout, expected, world=played.number)
    away = taken_away(world)
    return [
        _lost(event, f"{world.body} is not there") if _needs(event, away, verdict) else found
        for event, found in zip(expected.events, verdict.events, strict=True)
    ]


def _without_order(
    bases: Sequence[Played], judged: dict[int, list[EventVerdict]], expected: SuiteScene
) -> SuiteScene:
    """What is expected, each event for itself: who is too fast hits the post before braking.

    An event keeps its place in the order if the unchanged scene shows it at another time without,
    as a second hit of the same two.
    """
    events = tuple(e.model_copy(update={"after": ()}) for e in expected.events)
    loose = expected.model_copy(update={"events": events})
    kept: set[str] = set()
    for p in bases:
        for was, now in zip(judged[id(p)], _judged(p, loose), strict=True):
            if was.time_s is not None and abs((now.time_s or 0.0) - was.time_s) > SAME_EVENT_S:
                kept.add(was.id)
    return expected.model_copy(
        update={
            "events": tuple(
                e if e.id in kept else free for e, free in zip(expected.events, events, strict=True)
            )
        }
    )


def _judged_freely(played: Played, expected: SuiteScene) -> list[EventVerdict]:
    """The same, but what followed an event that does not happen any more may happen whenever it
    does.
    """
    while True:
        found = _judged(played, expected)
        gone = {e.id for e in found if not e.completed}
        if not any(gone & set(e.after) for e in expected.events):
            return found
        events = tuple(
            e.model_copy(update={"after": tuple(a for a in e.after if a not in gone)})
            for e in expected.events
        )
        expected = expected.model_copy(update={"events": events})


def _lost(event: SuiteEvent, reason: str) -> EventVerdict:
    return EventVerdict(id=event.id, type=event.type, completed=False, reason=reason)


def _needs(event: SuiteEvent, away: frozenset[str], verdict: SceneVerdict) -> bool:
    bound = (verdict.bindings.get(p, ()) for p in event.participants)
    return any(names and away.issuperset(n.split("/")[0] for n in names) for names in bound)


def _engine_rows(
    played: Sequence[Played], judged: dict[int, list[EventVerdict]]
) -> list[dict[str, Any]]:
    """Rows of table `engine_events`: one an engine, step and event."""
    alike = _alike(played, judged)
    return [
        {
            "engine": p.engine,
            "dt_s": p.dt,
            "event_id": e.id,
            "event_index": k,
            "event_type": e.type,
            "completed": e.completed if p.sound else None,
            "time_s": e.time_s,
            "agrees": alike[k],
            "reason": _reason(p, e.reason),
        }
        for p in played
        for k, e in enumerate(judged[id(p)])
    ]


def _alike(played: Sequence[Played], judged: dict[int, list[EventVerdict]]) -> list[bool | None]:
    """Of every event, whether all replays agree on it; None if one of them failed."""
    if not played:
        return []
    n = len(judged[id(played[0])])
    if not all(p.sound for p in played):
        return [None] * n
    return [len({judged[id(p)][k].completed for p in played}) == 1 for k in range(n)]


def _what_if_rows(
    played: Sequence[Played],
    judged: dict[int, list[EventVerdict]],
    expected: SuiteScene,
) -> list[dict[str, Any]]:
    """Rows of table `what_ifs`: one a change and engine; those of no change are the bases."""
    bases = {p.engine: p for p in played if p.world.variable == UNCHANGED}
    worlds = list({id(p.world): p.world for p in played}.values())
    rows: list[dict[str, Any]] = []
    for world in worlds:
        mine = [p for p in played if p.world is world]
        alike = _alike(mine, judged)
        agree = None if None in alike else all(alike)
        spread = _spread(mine)
        for p in mine:
            events = judged[id(p)]
            base = bases[p.engine]
            rows.append(
                {
                    "variable": world.variable,
                    "engine": p.engine,
                    "amount": world.amount,
                    "body": world.body,
                    "value_before": world.before,
                    "value": world.after,
                    "unit": world.unit,
                    "dt_s": p.dt,
                    "duration_s": world.duration,
                    "outcome": _outcome(p, base, events, judged[id(base)]),
                    "reason": _reason(p, ""),
                    "event_ids": [e.id for e in expected.events],
                    "completed": [e.completed for e in events] if p.sound else None,
                    "event_times_s": [e.time_s for e in events] if p.sound else None,
                    "bodies": list(world.scene.names),
                    "final_position_m": _final(p),
                    "apart_m": _apart(p, base),
                    "engines_apart_m": spread,
                    "agrees": agree,
                }
            )
    return rows


def _refused_row(variable: str, why: str, engine: str) -> dict[str, Any]:
    return {"variable": variable, "engine": engine, "outcome": "not_applicable", "reason": why}


def _outcome(
    p: Played, base: Played, events: Sequence[EventVerdict], before: Sequence[EventVerdict]
) -> str:
    """One word: which of the base's events happen."""
    if p.rollout is None:
        return "failed"
    if not p.sound:
        return "diverged"
    if p.world.variable == UNCHANGED:
        return "unchanged"
    if not base.sound:
        return "no_base"
    same = [e.completed for e in events] == [e.completed for e in before]
    return "same_events" if same else "other_events"


def _reason(p: Played, otherwise: str) -> str:
    if p.rollout is None:
        return p.reason
    return otherwise if p.sound else "the simulation diverged"


def _ends(p: Played) -> np.ndarray | None:
    """Where every body is at the end [m], shape [B, 3]; NaN for what was taken away."""
    if p.rollout is None or not p.sound:
        return None
    last = p.rollout.position[p.number, -1].astype(np.float32)
    away = [b.name in taken_away(p.world) for b in p.world.scene.bodies]
    return np.where(np.array(away, bool)[:, None], np.float32(np.nan), last)


def _final(p: Played) -> list[float | None] | None:
    ends = _ends(p)
    return None if ends is None else [None if np.isnan(v) else float(v) for v in ends.ravel()]


def _apart(a: Played, b: Played) -> float | None:
    """Largest distance [m] between the ends of one body in two replays."""
    one, two = _ends(a), _ends(b)
    if one is None or two is None or one.size == 0:
        return None
    far = np.linalg.norm(one.astype(float) - two.astype(float), axis=1)
    return float(np.nanmax(far)) if not np.isnan(far).all() else None


def _spread(played: Sequence[Played]) -> float | None:
    """Largest distance [m] between the ends of one body in any two engines."""
    found = [_apart(a, b) for i, a in enumerate(played) for b in played[:i]]
    known = [d for d in found if d is not None]
    return max(known) if known else None
