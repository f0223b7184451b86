"""The judge: one replay against one scene of a suite.

Source: the paper's evaluation protocol (Supp. Mat., "Comparison Experiment Details") with the event
types and quantities of the suite format, spelled out in docs/metrics.md.
"""

from __future__ import annotations

from dataclasses import replace
import itertools
import math

from esg.engines.program import Program
from esg.engines.scene import GROUND, Rollout, SimScene
from esg.metrics.binding import Binding, bind, own_parts
from esg.metrics.constraints import Scored, measure, unmeasured
from esg.metrics.detection import Found, Query
from esg.metrics.events import detect, names
from esg.metrics.hanging import hanging
from esg.metrics.joined import apart_by_design
from esg.metrics.models import (
    EventVerdict,
    LayoutVerdict,
    Overlap,
    SceneVerdict,
    SuiteEvent,
    SuiteScene,
)
from esg.metrics.replay import GROUND_INDEX, Replay
from esg.metrics.statements import bind_statements, failed_statement, judge_statements

MAX_INITIAL_PENETRATION_M = 0.02
_SETTLED_M = 1e-4


def judge(
    scene: SimScene,
    program: Program,
    rollout: Rollout,
    suite_scene: SuiteScene,
    *,
    world: int = 0,
) -> SceneVerdict:
    """Judges one world of a rollout.

    Args:
        scene: The scene that was simulated (bodies with names, labels, shapes).
        program: The control program that was executed (decides what moves or brakes by itself).
        rollout: Trajectories and contact log.
        suite_scene: What must happen.
        world: Which world of the rollout.

    Returns:
        The verdict; a phrase that binds to nothing or a diverged world is a verdict, not an error.
    """
    replay = Replay(scene, program, rollout, world)
    bindings = bind_all(scene, suite_scene)
    stated = bind_statements(suite_scene, replay)
    found = _judge_events(replay, suite_scene, bindings)
    world_view = Scored(replay, {e.id: e for e in suite_scene.events}, found, bindings)
    return SceneVerdict(
        scene_id=scene.scene_id,
        suite_scene=suite_scene.id,
        engine=rollout.engine,
        dt_s=rollout.dt,
        layout=judge_layout(replay, suite_scene, bindings),
        events=tuple(_event_verdict(replay, e, found[e.id]) for e in suite_scene.events),
        constraints=tuple(measure(c, world_view) for c in suite_scene.constraints),
        statements=judge_statements(
            replay, suite_scene, stated, {k: f.time for k, f in found.items()}
        ),
        bindings={p: b.names(scene) for p, b in {**stated, **bindings}.items()},
    )


def failed_verdict(
    scene_id: str, suite_scene: SuiteScene, engine: str, dt_s: float, reason: str
) -> SceneVerdict:
    """The verdict of a run without a replay (invalid draft, crash): nothing holds."""
    events = tuple(
        EventVerdict(id=e.id, type=e.type, completed=False, reason=reason)
        for e in suite_scene.events
    )
    constraints = tuple(unmeasured(c, reason) for c in suite_scene.constraints)
    return SceneVerdict(
        scene_id=scene_id,
        suite_scene=suite_scene.id,
        engine=engine,
        dt_s=dt_s,
        layout=LayoutVerdict(valid=False, missing=(reason,)),
        events=events,
        constraints=constraints,
        statements=tuple(failed_statement(s, reason) for s in suite_scene.statements),
    )


def bind_all(scene: SimScene, suite_scene: SuiteScene) -> dict[str, Binding]:
    """Binds every phrase of a suite scene once; a phrase used as a target may mean a region."""
    targets = {e.target for e in suite_scene.events if e.target}
    targets |= {c.target for c in suite_scene.constraints if c.target}
    phrases: list[str] = []
    for event in suite_scene.events:
        phrases += event.participants
    for constraint in suite_scene.constraints:
        phrases += [p for p in (constraint.object, constraint.target) if p]
    phrases += suite_scene.objects
    return {p: bind(p, scene, target=p in targets) for p in dict.fromkeys(phrases)}


def judge_layout(
    replay: Replay, suite_scene: SuiteScene, bindings: dict[str, Binding]
) -> LayoutVerdict:
    """SLR: all prescribed objects are there, no pair overlaps by over 2 cm at the start, and
    nothing hangs in the air.
    """
    missing = tuple(b.problem for b in bindings.values() if b.problem)
    overlaps, deepest = initial_overlaps(replay)
    loose = hanging(replay, suite_scene, bindings)
    return LayoutVerdict(
        valid=not missing and not overlaps and not loose,
        missing=missing,
        overlaps=overlaps,
        hanging=loose,
        max_penetration_m=deepest,
    )


def initial_overlaps(replay: Replay) -> tuple[tuple[Overlap, ...], float]:
    """Pairs that overlap by more than 2 cm at frame 0, and the deepest overlap of any pair [m].

    Dynamic bodies are also checked against the ground; what is fixed may be founded in it. What a
    joint holds together does not touch.
    """
    bodies = replay.scene.bodies
    barred = apart_by_design(replay)
    placed = [replay.placed(i, 0) for i in range(len(bodies))]
    out: list[Overlap] = []
    deepest = 0.0
    for i, j in itertools.combinations(range(len(bodies)), 2):
        if not placed[i] or not placed[j] or (i, j) in barred:
            continue
        reach = replay.radii[i] + replay.radii[j]
        if math.dist(replay.position[0, i], replay.position[0, j]) >= reach:
            continue
        depth = replay.penetration(i, j, 0)
        deepest = max(deepest, depth)
        if depth > MAX_INITIAL_PENETRATION_M:
            out.append(Overlap(a=bodies[i].name, b=bodies[j].name, depth_m=depth))
    for i, body in enumerate(bodies):
        if body.static or not placed[i]:
            continue
        depth = replay.penetration(i, GROUND_INDEX, 0)
        deepest = max(deepest, depth)
        if depth > MAX_INITIAL_PENETRATION_M:
            out.append(Overlap(a=body.name, b=GROUND, depth_m=depth))
    return tuple(out), 0.0 if deepest < _SETTLED_M else deepest


def _judge_events(
    replay: Replay, suite_scene: SuiteScene, bindings: dict[str, Binding]
) -> dict[str, Found]:
    found: dict[str, Found] = {}
    for event in suite_scene.events:
        blocked = [a for a in event.after if not (a in found and found[a].completed)]
        unbound = [p for p in event.participants if not bindings[p].bound]
        if unbound:
            found[event.id] = Found(None, reason=bindings[unbound[0]].problem or "unbound")
        elif blocked:
            found[event.id] = Found(None, reason=f"event {blocked[0]} before it is incomplete")
        else:
            times = [found[a].time for a in event.after]
            since = max((t for t in times if t is not None), default=None)
            found[event.id] = detect(replay, _query(replay, suite_scene, event, bindings, since))
    return found


def _query(
    replay: Replay,
    suite_scene: SuiteScene,
    event: SuiteEvent,
    bindings: dict[str, Binding],
    since: float | None,
) -> Query:
    bound = _bound(event, bindings, replay.scene)
    if event.type == "misses":
        both = {frozenset(bindings[q].bodies) for q in event.participants}
        later = suite_scene.events[suite_scene.events.index(event) + 1 :]
        again = any(
            e.type == "collision"
            and {frozenset(bindings[q].bodies) for q in (e.a, e.b) if q} == both
            for e in later
        )
        return Query(event, bound, since, meet_again=again)
    if event.type != "brakes":
        return Query(event, bound, since)

    def until(body: int, time: float) -> float:
        """Time of the earliest later event of the same body."""
        later = suite_scene.events[suite_scene.events.index(event) + 1 :]
        times = [math.inf]
        for other in later:
            mine = any(body in bindings[p].bodies for p in other.movers)
            if other.type in ("brakes", "misses", "moves") or not mine:
                continue
            if not all(bindings[p].bound for p in other.participants):
                continue
            result = detect(replay, Query(other, _bound(other, bindings, replay.scene), time))
            if result.time is not None:
                times.append(result.time)
        return min(times)

    return Query(event, bound, since, until)


def _bound(event: SuiteEvent, bindings: dict[str, Binding], scene: SimScene) -> dict[str, Binding]:
    """What plays which part in an event; a blow at a windmill's blade meets the windmill."""
    fields = {
        "a": event.a,
        "b": event.b,
        "object": event.object,
        "target": event.target,
        "from": event.from_,
    }
    bound = {k: bindings[p] for k, p in fields.items() if p is not None}
    if event.type != "collision":
        return bound
    told = {i for b in bound.values() for i in b.bodies}
    return {
        k: replace(b, bodies=(*b.bodies, *(i for i in own_parts(b, scene) if i not in told)))
        for k, b in bound.items()
    }


def _event_verdict(replay: Replay, event: SuiteEvent, found: Found) -> EventVerdict:
    return EventVerdict(
        id=event.id,
        type=event.type,
        completed=found.completed,
        time_s=found.time,
        bodies=names(replay, found.bodies),
        reason=found.reason,
        measured={k: float(v) for k, v in found.measured.items()},
    )
