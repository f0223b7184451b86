"""What a contact sheet shows: its moments, who is in them, and what to say about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
import math
from typing import TYPE_CHECKING

import numpy as np

from esg.assets.appearance import RIDDEN
from esg.assets.appearances import appearances
from esg.assets.builders.living.poses import POSES
from esg.engines.scene import Body, Rollout, SimScene
from esg.graph.models import EsgDocument, RelationType
from esg.units import GRAVITY_MPS2

if TYPE_CHECKING:
    from esg.metrics.models import EventVerdict, SceneVerdict

INTO = frozenset(["enters", "placed", "reaches"])
"""Events of which one sees where they lead."""
LASTING = frozenset(["moves"])
"""Events that go on after the time at which they are told to begin."""
SHOWN_S = 2.0
"""Of these, at most so much is waited for."""
MAX_EVENTS = 7
HEAD_M = 1.85
"""Height of the head of who rides a two-wheeler: those that are drawn reach 1.79 to 1.86 m."""
SITTING = 0.54
"""Height of somebody above his seat, over that of him standing: 91 of 172 cm (`poses.SEAT`)."""
REACH, FAR_REACH = 4.5, 14.0
"""Company joins the picture of an event, or the first and the last one, if the picture is then at
most so many times as wide as what must be seen."""
AT_HAND_M = 3.0
HAND_REACH = 8.0
"""Room around a small thing to which an event happens: who threw the ball is seen, too, while it
is not much smaller than the picture."""
SETS_OFF_MPS = 0.05
_UNITS = {"mps": "m/s", "m": "m", "s": "s", "deg": "deg", "ns": "N s", "kg": "kg"}


@dataclass(frozen=True)
class Moment:
    """One panel to draw: when, whom to frame, what to say."""

    time: float
    focus: tuple[int, ...]
    """Bodies that must be seen."""
    company: tuple[int, ...]
    """Bodies that are seen if they do not widen the picture too much."""
    title: str
    caption: str
    reach: float = REACH
    at_hand: float = 0.0
    """Company joins a small focus up to a picture so wide [m], and `HAND_REACH` times its size."""


def moments_of(
    scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None, doc: EsgDocument
) -> list[Moment]:
    """The start, every completed event in order of time, and the moment after the last."""
    events = [e for e in verdict.events if e.completed and e.time_s is not None] if verdict else []
    events = sorted(events, key=lambda e: e.time_s or 0.0)[:MAX_EVENTS]
    cast = _with_openings(scene, doc, cast_of(scene, rollout, verdict))
    company = _company(scene, doc, cast)
    end = float(rollout.time[-1])
    if events:
        # A moment after the last event, not the end of a long tail in which everything is still.
        end = min(end, (events[-1].time_s or 0.0) + max(1.0, _goes_on(events[-1])))
    moments = [Moment(0.0, cast, company, "start", "before anything moves", FAR_REACH)]
    for number, event in enumerate(events, 1):
        bodies = tuple(scene.index(b) for b in event.bodies if b in scene.names) or cast
        bodies = tuple(dict.fromkeys([*bodies, *fixed_to(scene, bodies)]))
        if event.type in INTO:
            bodies = tuple(dict.fromkeys([*bodies, *openings_of(scene, doc, bodies)]))
        mates = tuple(i for i in company if i not in bodies)
        if len(bodies) > 1:
            mates = tuple(i for i in mates if _same_group(scene, i, bodies))
        moments.append(
            Moment(
                min((event.time_s or 0.0) + 0.5 * _goes_on(event) + _rises_for(event), end),
                bodies,
                mates,
                f"{number}  {_title(scene, event)}",
                _measurements(event),
                at_hand=AT_HAND_M,
            )
        )
    moments.append(Moment(end, cast, company, "after", f"t = {end:.2f} s", FAR_REACH))
    return moments


def _goes_on(event: EventVerdict) -> float:
    """How long what an event began goes on [s], as far as it is waited for."""
    return min(event.measured.get("for_s", 0.0), SHOWN_S) if event.type in LASTING else 0.0


def _rises_for(event: EventVerdict) -> float:
    """How long after it has begun a jump is at its highest [s]."""
    rise = event.measured.get("rise_m", 0.0) if event.type == "jumps" else 0.0
    return math.sqrt(2.0 * max(rise, 0.0) / GRAVITY_MPS2)


def as_seen(scene: SimScene, doc: EsgDocument) -> SimScene:
    """A scene for cameras, with boxes around what is drawn.

    Those of vehicles on which somebody is drawn reach up to his head; those of people who sit end
    there, whose bodies are those of people who stand.

    Args:
        scene: The bodies, as they collide.
        doc: What they look like.
    """
    looks = appearances(doc)

    def drawn(body: Body) -> Body:
        pose = looks[body.name].pose if body.name in looks else ""
        x, y, z = body.half_extents
        if pose == RIDDEN:
            z = max(z, 0.5 * HEAD_M)
        elif pose in POSES and POSES[pose].seated:
            z *= SITTING
        return body if z == body.half_extents[2] else replace(body, half_extents=(x, y, z))

    return scene.with_bodies(tuple(drawn(b) for b in scene.bodies))


def fixed_to(scene: SimScene, bodies: Sequence[int]) -> list[int]:
    """Who is fixed to some bodies, or they to him: a rider and what he rides are one sight."""
    names = {scene.bodies[i].name for i in bodies}
    pairs = [(j.child, j.parent) for j in scene.joints if j.kind == "fixed"]
    found = [b for a, b in (*pairs, *((b, a) for a, b in pairs)) if a in names and b not in names]
    return sorted({scene.index(n) for n in found if n in scene.names})


def _same_group(scene: SimScene, body: int, others: Sequence[int]) -> bool:
    group = scene.bodies[body].group
    return bool(group) and any(scene.bodies[i].group == group for i in others)


def _company(scene: SimScene, doc: EsgDocument, cast: tuple[int, ...]) -> tuple[int, ...]:
    """Who belongs to the cast: its groups, what it stands on, what else the prompt names.

    What is flat belongs to nobody.
    """
    names = {scene.bodies[i].name for i in cast}
    nodes = doc.spatial_relation_graph.nodes
    regions = doc.spatial_relation_graph.semantic_regions
    supports = {
        edge.to
        for edge in doc.spatial_relation_graph.edges.binary_relations
        if edge.relation_type in (RelationType.ON, RelationType.INSIDE_OF) and edge.from_ in names
    }
    for name in names & set(nodes):
        region = regions.get(nodes[name].semantic_region or "")
        supports |= {region.parent_object} if region else set()
    return tuple(
        i
        for i, b in enumerate(scene.bodies)
        if i not in cast
        and b.collides
        and (b.mentioned or _same_group(scene, i, cast) or b.name in supports)
    )


def cast_of(scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None) -> tuple[int, ...]:
    """Bodies the picture is about: event participants, else movers, else what the prompt names."""
    names = [b for e in verdict.events for b in e.bodies] if verdict else []
    cast = {scene.index(n) for n in names if n in scene.names}
    if not cast and verdict is not None:
        cast = {scene.index(b) for v in verdict.bindings.values() for b in v if b in scene.names}
    if not cast:
        travelled = np.linalg.norm(rollout.position[0, -1] - rollout.position[0, 0], axis=-1)
        cast = {i for i, b in enumerate(scene.bodies) if not b.static and travelled[i] > 0.3}
    if not cast:
        cast = {i for i, b in enumerate(scene.bodies) if b.mentioned and b.collides}
    return tuple(sorted(cast)) or tuple(range(len(scene.bodies)))


def _with_openings(scene: SimScene, doc: EsgDocument, cast: tuple[int, ...]) -> tuple[int, ...]:
    """The cast and the goal, hole or basket it enters."""
    return tuple(sorted({*cast, *openings_of(scene, doc, cast)}))


def openings_of(scene: SimScene, doc: EsgDocument, cast: Sequence[int]) -> tuple[int, ...]:
    """The goal, hole or basket that bodies enter; none that is flat and fills the picture."""
    timeline = doc.timeline_system
    if timeline is None:
        return ()
    names = {scene.bodies[i].name for i in cast}
    owners = {
        (n.region or "").partition("/")[0]
        for n in timeline.sequence_graph.nodes
        if names & set(n.participants)
    }
    return tuple(
        sorted(scene.index(n) for n in owners if n in scene.names and scene.body(n).collides)
    )


def set_off(
    scene: SimScene, rollout: Rollout, doc: EsgDocument
) -> list[tuple[float, int, tuple[int, ...]]]:
    """Who throws, kicks or shoots something: when it sets off [s], what that is, and who it is.

    He stands beside it and faces it, and has no motion of his own.

    Args:
        scene: The bodies.
        rollout: Their motion; its first world.
        doc: Relations and the timeline.
    """
    timeline, graph = doc.timeline_system, doc.spatial_relation_graph
    if timeline is None:
        return []
    acts, names = {e.actor for e in timeline.sequence_graph.edges}, frozenset(scene.names)
    doers: dict[str, list[int]] = {}
    for edge in graph.edges.binary_relations:
        faces = edge.relation_type is RelationType.FACE and {edge.from_, edge.to} <= names
        by = faces and edge.to in acts and edge.from_ not in acts
        if by and not scene.body(edge.from_).static:
            doers.setdefault(edge.to, []).append(scene.index(edge.from_))
    out: list[tuple[float, int, tuple[int, ...]]] = []
    for name, by in doers.items():
        body = scene.index(name)
        speed = np.linalg.norm(np.nan_to_num(rollout.linear_velocity[0, :, body]), axis=-1)
        k = int((speed > SETS_OFF_MPS).argmax())
        at = np.nan_to_num(rollout.position[0, k, :, :2]).astype(float)
        near = tuple(i for i in by if math.dist(at[i], at[body]) <= AT_HAND_M)
        if near and speed[k] > SETS_OFF_MPS:
            out.append((float(rollout.time[k]), body, near))
    return sorted(out)


def _name(scene: SimScene, name: str) -> str:
    if name not in scene.names:
        return name
    return scene.body(name).label or name.replace("_", " ")


def _title(scene: SimScene, event: EventVerdict) -> str:
    who = [_name(scene, b) for b in event.bodies]
    joiner = " x " if event.type == "collision" else ", "
    shown = joiner.join(who[:2]) + (f" +{len(who) - 2}" if len(who) > 2 else "")
    return f"{event.type}: {shown}" if shown else f"{event.type} ({event.id})"


def _measurements(event: EventVerdict) -> str:
    """Time and what was measured, in the units of the measurement's name; zeros say nothing."""
    parts = [f"t = {event.time_s:.2f} s"]
    for key, value in event.measured.items():
        name, _, unit = key.rpartition("_")
        if name in ("", "time") or unit not in _UNITS or round(abs(value), 2) == 0.0:
            continue
        parts.append(f"{name.replace('_', ' ')} {_number(value)} {_UNITS[unit]}")
    return "   ".join(parts[:4])


def _number(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def failures(scene: SimScene, verdict: SceneVerdict | None) -> list[str]:
    """Lines about what did not happen and what is wrong with the layout.

    Args:
        scene: The bodies.
        verdict: What the judge found; None gives no lines.
    """
    if verdict is None:
        return []
    lines = [
        f"{_title(scene, e)}: not completed ({e.reason or 'no reason given'})"
        for e in verdict.events
        if not e.completed
    ]
    return [*lines, *verdict.layout.faults]
