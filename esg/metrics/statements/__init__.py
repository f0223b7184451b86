"""What a prompt states beyond its events, measured on a replay (docs/metrics/statements.md)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from esg.filming.ways import Way
from esg.graph.models import Predicate
from esg.metrics.binding import Binding, bind
from esg.metrics.models import OF_EVENTS, StatementVerdict, SuiteScene, SuiteStatement
from esg.metrics.replay import Replay
from esg.metrics.statements import (
    climbs,
    directions,
    facts,
    filmed,
    gestures,
    liquids,
    lying,
    manner,
    parts,
    place,
    plumes,
    postures,
    shown,
    sides,
    wobbling,
    worn,
)
from esg.metrics.statements.query import Kept, StatementQuery, window_of

OfBody = place.OfBody
OfScene = Callable[[Replay, StatementQuery], Kept]

OF_BODIES: dict[Predicate, OfBody] = {
    Predicate.SUPPORTED_BY: place.supported_by,
    Predicate.INSIDE: place.inside,
    Predicate.ABOVE: place.above,
    Predicate.UNDER: place.under,
    Predicate.LEFT_OF: place.on_side("left"),
    Predicate.RIGHT_OF: place.on_side("right"),
    Predicate.IN_FRONT_OF: place.on_side("front"),
    Predicate.BEHIND: place.on_side("behind"),
    Predicate.HANGS_FROM: place.hangs_from,
    Predicate.ATTACHED_TO: place.attached_to,
    Predicate.LEANS_ON: place.leans_on,
    Predicate.MOVES: directions.moves,
    Predicate.CLIMBS: climbs.climbs,
    Predicate.ROLLS: manner.rolls,
    Predicate.SLIDES: manner.slides,
    Predicate.SPINS: manner.spins,
    Predicate.TUMBLES: manner.tumbles,
    Predicate.AIRBORNE: manner.airborne,
    Predicate.CARRIED_BY: place.carried_along,
    Predicate.STAYS_UPRIGHT: manner.stays_upright,
    Predicate.STAYS_STILL: manner.stays_still,
    Predicate.TOUCHES: manner.touches,
    Predicate.NEVER_TOUCHES: manner.never_touches,
    Predicate.STRUCK_ON: sides.struck_on,
    Predicate.ENDS_ON: place.ends_on,
    Predicate.ENDS_IN: place.ends_in,
    Predicate.ENDS_NEAR: place.ends_near,
    Predicate.AT_PART: parts.at_part,
    Predicate.AT_REST: manner.at_rest,
    Predicate.SLOWER_THAN: manner.slower_than,
    Predicate.FASTER_THAN: manner.faster_than,
    Predicate.FILLED_WITH: liquids.filled_with,
    Predicate.FLOATS: liquids.floats,
    Predicate.SINKS: liquids.sinks,
    Predicate.SIZE: facts.size,
    Predicate.LIES: lying.lies,
    Predicate.WOBBLES: wobbling.wobbles,
    Predicate.POSTURE: postures.posture,
    Predicate.WEARS: worn.wears,
    Predicate.LOOKS: worn.wears,
    Predicate.LIT: shown.lit,
    Predicate.SWAYS: shown.sways,
    Predicate.GESTURES: gestures.gestures,
    Predicate.FACES: gestures.faces,
    Predicate.GIVES_OFF: plumes.gives_off,
}
"""Measures of one body; of a set, every member is measured."""

OF_SCENES: dict[Predicate, OfScene] = {
    Predicate.SAME_TIME: facts.same_time,
    Predicate.BEFORE: facts.before,
    Predicate.COUNT: facts.count,
    Predicate.ABSENT: facts.absent,
    Predicate.WEATHER: shown.weather,
}

_NOTHING = Binding("")


def bind_statements(suite_scene: SuiteScene, replay: Replay) -> dict[str, Binding]:
    """Binds the phrases of all statements; those that name a target may mean a region."""
    statements = [s for s in suite_scene.statements if s.says not in OF_EVENTS]
    targets = {p for s in statements for p in (s.target, s.b) if p is not None}
    phrases = [p for s in statements for p in s.participants]
    return {p: bind(p, replay.scene, target=p in targets) for p in dict.fromkeys(phrases)}


def judge_statements(
    replay: Replay,
    suite_scene: SuiteScene,
    bindings: Mapping[str, Binding],
    times: Mapping[str, float | None],
) -> tuple[StatementVerdict, ...]:
    """Whether every statement of a scene is kept.

    Args:
        replay: What happened.
        suite_scene: What is stated.
        bindings: Of the statements' phrases.
        times: Of the scene's events [s], None for those that did not happen.
    """
    way = filmed.planned(suite_scene.statements, bindings, replay)
    return tuple(
        verdict(s, _measure(replay, s, bindings, times, way)) for s in suite_scene.statements
    )


def verdict(statement: SuiteStatement, found: Kept) -> StatementVerdict:
    """A measurement as a verdict."""
    return StatementVerdict(
        id=statement.id,
        says=statement.says.value,
        words=statement.words,
        kept=found.kept,
        measured={k: round(float(v), 6) for k, v in found.measured.items() if np.isfinite(v)},
        reason=found.reason,
    )


def failed_statement(statement: SuiteStatement, reason: str) -> StatementVerdict:
    """The verdict without a replay: nothing is kept; what is not represented stays so."""
    if statement.says is Predicate.NOT_REPRESENTED:
        return verdict(statement, Kept(None, reason=statement.note))
    return verdict(statement, Kept(False, reason=reason))


def _measure(
    replay: Replay,
    s: SuiteStatement,
    bindings: Mapping[str, Binding],
    times: Mapping[str, float | None],
    way: Way | None,
) -> Kept:
    if s.says is Predicate.NOT_REPRESENTED:
        return Kept(None, reason=s.note)
    if not replay.valid:
        return Kept(False, reason="the simulation diverged")
    lacking = [bindings[p].problem or f"{p!r} is not in the scene" for p in s.participants
               if bindings[p].problem or not bindings[p].bound]  # fmt: skip
    if lacking:
        return Kept(False, reason=lacking[0])
    if s.says is Predicate.FILMED:
        return filmed.measure(replay, way, s, bindings.get(s.object or "", _NOTHING).bodies)
    window = window_of(s, replay, times)
    if isinstance(window, str):
        return Kept(False, reason=window)
    bound = {k: bindings.get(p or "", _NOTHING) for k, p in _fields(s).items()}
    query = StatementQuery(s, bound["object"], bound["target"], bound["alike"], window, times)
    if s.says in OF_SCENES:
        return OF_SCENES[s.says](replay, query)
    return _of_all(replay, query, OF_BODIES[s.says])


def _fields(s: SuiteStatement) -> dict[str, str | None]:
    return {"object": s.object or s.a, "target": s.target or s.b, "alike": s.alike}


def _of_all(replay: Replay, q: StatementQuery, measure: OfBody) -> Kept:
    """Of a set every member keeps it; of several that a singular may mean, one does."""
    bodies = q.object.bodies
    if not bodies:
        return Kept(False, reason=f"{q.object.phrase!r} is no body that could be measured")
    found = [(i, measure(replay, q, i)) for i in bodies]
    wanted = not q.object.plural
    body, first = next(((i, k) for i, k in found if k.kept is wanted), found[0])
    if len(bodies) > 1 and first.reason:
        first = replace(first, reason=f"{replay.scene.bodies[body].name} {first.reason}")
    return first
