"""What clauses said of ways and speeds, carried over to the motions that they tell."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
import re
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, movable
from esg.draft.discourse.proposition import Clause, Said
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import head_of
from esg.draft.discourse.scene import SPEEDS
from esg.draft.discourse.tracks import Motion
from esg.draft.discourse.windows import START
from esg.draft.events.motions import flies_itself, own, paced
from esg.draft.events.stated import said, said_before
from esg.draft.events.told import things
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import EdgeEvent, ForceDirection, NodeEvent, Predicate, TimelineEdge
from esg.thresholds import BRAKING_DRY_G, GENTLE_BRAKING_MPS2, HARD_BRAKING_MPS2

_TRANSITIVE = frozenset(
    {"launch", "knock", "drop", "carry", "roll", "slide", "bounce", "tow", "own", "pass", "posture"}
)
"""Senses whose object, where there is one, is what moves as the clause says."""
_AT_ITS_OWN_PACE = ("brake", "stop", "slow", "fall", "drop", "topple", "turn")
"""Senses whose adverbs of pace are not about a speed that one could choose."""
TURNING = ("turn", "swerve", "face", "topple")
"""Senses whose sides are not ways of moving."""
_HEADINGS = {"left": 0.0, "right": 180.0, "front": 90.0, "back": 270.0}
"""Headings [degrees] of the viewer's directions: left is +X, front +Y."""
_STEEP = {"up": 90.0, "down": -90.0}
"""How steeply what flies by itself goes up and down [degrees]."""
_WINGS = 2.0 / 3.0
"""What of it beating wings do."""
_FIXED_WINGS = lex.word_set("fixed wings")
_ABOUT_S = 2.5
"""How long what moves about on something shall need for half of its length [s]."""
HARD_BRAKE_CM_S2, GENTLE_BRAKE_CM_S2 = 100.0 * HARD_BRAKING_MPS2, 100.0 * GENTLE_BRAKING_MPS2
HARDEST_BRAKE_CM_S2 = 100.0 * 9.81 * BRAKING_DRY_G
_ONCOMING = re.compile(r"\b(?:oncoming|on-coming)\b", re.IGNORECASE)
_ON_ROADS = frozenset({"vehicle", "toyvehicle", "cart"})
_DRIVEN = (EdgeEvent.UNIFORM_MOTION, EdgeEvent.TOWARD, EdgeEvent.ACCELERATED_MOTION)


@dataclass(frozen=True)
class Before:
    """What the timeline held before a clause was read."""

    tracks: dict[str, tuple[int, bool, str]]
    nodes: int
    edges: int
    rest: tuple[object, ...]
    """Everything else that a clause can add to, to tell whether it did."""


def snapshot(d: Discourse) -> Before:
    """Notes what the timeline holds."""
    tracks = {a: (id(t.motion), t.hit, t.at) for a, t in d.timeline.tracks.items()}
    return Before(tracks, len(d.timeline.nodes), len(d.timeline.edges), _rest(d))


def _rest(d: Discourse) -> tuple[object, ...]:
    scene, motions = d.scene, [t.motion for t in d.timeline.tracks.values()]
    return (
        *map(len, (scene.relations, scene.supported_by, scene.attached, scene.heights)),
        *map(len, (scene.travel, scene.facing, scene.marked, d.moves.stated, d.moves.waiting)),
        tuple(d.times.pending.items()),
        sum(len(n.constraints) for n in d.timeline.nodes),
        [(m.speed, m.target, m.duration, tuple(m.params)) for m in motions if m is not None],
        len(d.world.entities),
    )


def follow(d: Discourse, f: Frame, was: Before, subject: list[str], objects: list[str]) -> Clause:
    """What a clause set in motion, and its words on it carried over to the motion.

    Args:
        d: The discourse after the clause was read.
        f: The clause.
        was: What the timeline held before.
        subject, objects: What it is about (node ids).
    """
    tracks = d.timeline.tracks
    new = {a for a, t in tracks.items() if was.tracks.get(a) != (id(t.motion), t.hit, t.at)}
    moved = [i for i in objects if i in new] if f.verb.sense in _TRANSITIVE else []
    moved = moved or [i for i in (*subject, *objects) if i in new]
    moved = moved or [i for i in subject if i in tracks and tracks[i].under_way]
    if f.verb.sense == "hit":  # "reverses into a van": the van does not
        moved = [i for i in moved if tracks[i].motion is not None] or moved
    moved = [i for i in dict.fromkeys(moved) if i in d.world.entities and movable(d, i)]
    clause = Clause(
        f,
        moved,
        {a: was.tracks[a][2] if a in was.tracks else START for a in moved},
        said(d.text, f),
        told=bool(new) or snapshot(d) != was,
    )
    for mover in moved:
        _carry_over(d, clause, mover, was)
    return clause


def by_its_participle(d: Discourse, f: Frame, was: Before, subject: list[str]) -> list[Clause]:
    """What a participle says of a subject that sets off: "a reversing van knocks a sign over"."""
    new = [a for a in subject if a in d.timeline.tracks and a not in was.tracks and movable(d, a)]
    told = said_before(d.text, f) if new else []
    if not told:
        return []
    clause = Clause(f, new, dict.fromkeys(new, START), told)
    for mover in new:
        _carry_over(d, clause, mover, was, by_verb=False)
    return [clause]


def chosen_pace(f: Frame, s: Said) -> bool:
    """Whether a word of pace is about a speed that one could choose ("then gallops": gained)."""
    gained = f.verb.sense == "accelerate" and s.row.part == "verb"
    return f.verb.sense not in _AT_ITS_OWN_PACE and not gained


def _carry_over(
    d: Discourse, clause: Clause, mover: str, was: Before, by_verb: bool = True
) -> None:
    """Gives the motions of a clause the course and the pace that its words state."""
    earlier = any(e.actor == mover for e in d.timeline.edges[: was.edges])
    first = d.timeline.tracks[mover].at == START or not earlier
    told = d.timeline.nodes[was.nodes :]
    turned = any(n.event is NodeEvent.HEADING_REACHED for n in told)
    turned = turned or (by_verb and clause.frame.verb.sense in TURNING)
    for s in clause.said:
        if s.row.part == "braking":
            _brake_so(d, mover, was, s.row.pace)
            continue
        if (other := queues_behind(d, s, mover)) is not None:
            _comes_up_to(d, mover, other)
            continue
        if s.row.pace and not chosen_pace(clause.frame, s):
            continue
        if s.row.states is Predicate.MOVES and turned:
            continue
        if s.row.pace:
            _change(d, mover, was, pace=s.row.pace)
        else:
            _head_so(d, mover, was, s, first)


def _head_so(d: Discourse, mover: str, was: Before, s: Said, first: bool) -> None:
    """Where the word of a motion turns it: only its first has a heading of its own to choose."""
    way = s.row.direction or ""
    if way in _HEADINGS and first:
        _change(d, mover, was, heading_deg=_HEADINGS[way])
    elif way in _STEEP and s.phrase is None and first and climbs(d, mover):
        share = _WINGS if kind_of(d, mover) == "animal" else 1.0
        _change(d, mover, was, climb_deg=share * _STEEP[way])
        d.timeline.tracks[mover].direction = ForceDirection.ANY_3D
    elif way == "up" and kind_of(d, mover) != "flyer":
        _change(d, mover, was, thrown_up=True)
    elif way == "backward" and first:
        _change(d, mover, was, backward=True)
        track = d.timeline.tracks[mover]
        if track.direction is ForceDirection.ALONG_FORWARD_ONLY:
            track.direction = ForceDirection.ALONG_FORWARD_OR_BACKWARD


def climbs(d: Discourse, mover: str) -> bool:
    """Whether it can go straight up and down: a drone, a balloon, a bird, and no aeroplane."""
    return flies_itself(d, mover) and head_of(entity_of(d, mover)) not in _FIXED_WINGS


def goes_steeply(d: Discourse, f: Frame) -> bool:
    """ "Rises", "floats up", "flies downward", and up or down nothing."""
    return any(s.row.direction in _STEEP and s.phrase is None for s in said(d.text, f))


def queues_behind(d: Discourse, s: Said, mover: str) -> str | None:
    """ "Brakes behind a parked bus": along their way, whoever looks on; None if no vehicles do.

    Of two vehicles on a road one is behind the other by where that one is headed.
    """
    if s.row.part != "goal" or s.row.states is not Predicate.BEHIND or s.phrase is None:
        return None
    others = [i for i in things(s.phrase) if i in d.world.entities and i != mover][:1]
    both = [kind_of(d, i) in _ON_ROADS for i in (mover, *others)]
    return others[0] if others and all(both) else None


def _comes_up_to(d: Discourse, mover: str, other: str) -> None:
    motion = d.timeline.tracks[mover].motion
    if motion is not None and motion.target is None:
        motion.target = other
    for k, e in enumerate(d.timeline.edges):
        if e.actor == mover and e.target is None:
            d.timeline.edges[k] = e.model_copy(update={"target": other})


def _brake_so(d: Discourse, mover: str, was: Before, pace: str) -> None:
    """ "Brakes hard", "brakes gently": how fast it slows down, with room to what is asked."""
    rates = (1.15 * HARD_BRAKE_CM_S2, HARDEST_BRAKE_CM_S2)
    rates = rates if pace == "fast" else (0.3 * GENTLE_BRAKE_CM_S2, 0.85 * GENTLE_BRAKE_CM_S2)
    told = {"acceleration": tuple(round(r, 2) for r in rates)}
    motion = d.timeline.tracks[mover].motion
    if motion is not None and motion.mode == "brake":
        motion.params.update(told)
    for k, e in enumerate(d.timeline.edges):
        if k >= was.edges and e.actor == mover and e.event is EdgeEvent.BRAKE:
            d.timeline.edges[k] = e.model_copy(update={"params": e.params.model_copy(update=told)})


def _change(d: Discourse, mover: str, was: Before, pace: str = "", **course: Any) -> None:
    motion = d.timeline.tracks[mover].motion
    if motion is not None and motion.mode not in ("coast", "brake"):
        _change_motion(motion, pace, course)
    for k, e in enumerate(d.timeline.edges):
        if k < was.edges or e.actor != mover or e.event not in _DRIVEN:
            continue
        changed: dict[str, Any] = _fitting(e, course)
        if pace and not e.speed_is_prescribed and e.params.speed is not None:
            changed["speed"] = paced(e.params.speed, pace)
        if changed:
            params = e.params.model_copy(update=changed)
            d.timeline.edges[k] = e.model_copy(update={"params": params})


def _change_motion(motion: Motion, pace: str, course: dict[str, Any]) -> None:
    if pace and not motion.prescribed and motion.speed is not None:
        motion.speed = paced(motion.speed, pace)
    if "thrown_up" in course:
        if motion.mode in ("throw", "fly") and motion.target is None:
            motion.params["elevation_deg"] = 90.0
    elif "climb_deg" in course:
        if motion.mode == "own" and motion.target is None:
            motion.params["elevation_deg"] = course["climb_deg"]
    else:
        motion.params.update(course)


def _fitting(e: TimelineEdge, course: dict[str, Any]) -> dict[str, Any]:
    """What of a course a segment takes: straight up leads to nothing that it is aimed at."""
    if "climb_deg" in course:
        powered = e.event is EdgeEvent.UNIFORM_MOTION and e.target is None
        return {"elevation_deg": course["climb_deg"]} if powered else {}
    if "thrown_up" not in course:
        return dict(course)
    flies = e.event is EdgeEvent.TOWARD and isinstance(e.params.elevation_deg, tuple)
    return {"elevation_deg": 90.0} if flies and e.target is None else {}


def oncoming(d: Discourse) -> list[tuple[int, int, str, str]]:
    """ "Avoids an oncoming truck": it drives, and toward who drives the other way.

    Returns:
        Where each such word stands, who comes, and toward whom (node ids).
    """
    out: list[tuple[int, int, str, str]] = []
    for start, end, who in _called_oncoming(d):
        movers = [a for a, t in d.timeline.tracks.items() if a != who and t.under_way]
        movers = [a for a in movers if kind_of(d, a) in _ON_ROADS]
        if movers:
            out.append((start, end, who, movers[0]))
    return out


def _called_oncoming(d: Discourse) -> Iterator[tuple[int, int, str]]:
    """Where the word stands, and of which vehicle or rider."""
    for m in d.mentions:
        at = _ONCOMING.search(d.text, m.start, m.end)
        who = next((i for i in m.entities if i in d.world.entities), None)
        if at is not None and who is not None and kind_of(d, who) in _ON_ROADS:
            yield *at.span(), who


def come_on(d: Discourse, frames: list[Frame]) -> None:
    """Sets what is oncoming in motion, if no clause tells of its motion."""
    doers = {i for f in frames if f.subject is not None for i in f.subject.entities}
    for _, _, who in _called_oncoming(d):
        if who not in doers:
            own(d, who, SPEEDS.get(kind_of(d, who), (50.0, 400.0)), False)


def measurable(kind: NodeEvent) -> bool:
    """Whether a point event is an outcome that the judge can time."""
    return kind not in (NodeEvent.TRIGGER, NodeEvent.SCENE_START)
