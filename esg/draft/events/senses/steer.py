"""Verbs of steering: turn, swerve, overtake, change lanes, reverse."""

from __future__ import annotations

from esg.draft.discourse.core import amounts_of, kind_of, mark_used, movable, structural
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.record import all_rest
from esg.draft.discourse.scene import SELF_POWERED, SPEEDS
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event, outcomes
from esg.draft.events.motions import direction_of, each_passed, motion, own, reverse, start_motion
from esg.draft.events.roles import doer_and_done
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import settle, time_of
from esg.draft.events.told import amount, at_rest, constrain, ignore, things
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount
from esg.graph.models import ForceDirection, NodeEvent

_LEAST_TURN_S = 0.01
"""A turn told to last less has no rate of its own."""
ROUND_DEG_S = 18.0
"""How fast a course bends that leads around something large [degrees/s]."""
_IN_PLACE = frozenset({"on", "atop", "on top of", "under", "above", "over", "behind", "in front of"}
                     | {"beside", "next to", "near", "with", "above", "against"})  # fmt: skip
"""Prepositions of where something turns that goes nowhere."""
_COURSES = frozenset({"left", "right", "around", "round", "back", "away", "over", "over again"})
"""Adverbs of a turn to a side, or out of the way."""
_SIDES = {
    **dict.fromkeys(("left", "anticlockwise", "counterclockwise"), "left"),
    **dict.fromkeys(("right", "clockwise"), "right"),
}


def _rates(degrees: float, lasting: Amount | None) -> tuple[float, float]:
    """The rates of a turn [deg/s]: as long as it lasts, or what vehicles and walkers do."""
    if lasting is None or lasting.low < _LEAST_TURN_S:
        return (20.0, 120.0)
    return (0.9 * degrees / lasting.high, 1.1 * degrees / lasting.low)


def _side(d: Discourse, f: Frame) -> str:
    span = d.text[f.verb.start : f.verb.end + 40].lower()
    side = "right" if " right" in span.split(".")[0] else "left"
    return next((_SIDES[w] for w in (*f.adverbs, f.verb.extra.get("dir")) if w in _SIDES), side)


def _degrees(d: Discourse, a: Amount) -> float:
    mark_used(d, a, "turn angle")
    return max(1.0, min(720.0, abs(a.middle)))


@sense("turn")
def read_turn(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "turns right by 60 degrees, then left": each turn with its side and angle."""
    if s and not any(movable(d, a) for a in s):
        ignore(d, f, "a fixed object does not turn")
        return
    own = f.object is not None and f.object.determiner in ("its", "his", "her")
    driven = bool(o) and kind_of(d, o[0]) == "vehicle"
    if driven and s and kind_of(d, s[0]) == "person" and f.subject is not None:
        d.refs.mounts[id(f.subject)] = o[:1]  # "The driver turns his car left and hits a tree"
        s, o = o[:1], []
    if own and not driven and (not o or o[:1] != s[:1]):
        ignore(d, f, "a part turns, not the whole")
        return
    side = _side(d, f)
    if s and not o and _turns_where_it_is(d, f, s):
        read_as(d, "spin", f, s, o)  # "a fan turns", "a disc turns on a table"
        return
    angles = [a for _, a in amounts_of(d, f) if a.dimension == "angle"]
    degrees = _first_turn(d, f, angles)
    actors = s or o or [a for a, t in d.timeline.tracks.items() if t.motion is not None][-1:]
    turn(d, f, actors, side, degrees)
    sides = [*f.adverbs, *(p.mention.head for p in f.phrases if p.mention is not None)]
    for k, side in enumerate([x for x in sides if x in ("left", "right")][1:], 1):
        degrees = _degrees(d, angles[k]) if k < len(angles) else degrees
        turn(d, f, actors, side, degrees)


def _turns_where_it_is(d: Discourse, f: Frame, bodies: list[str]) -> bool:
    """Whether what goes nowhere by itself is only told to turn, and to no side."""
    wheels = not any(kind_of(d, a) in SELF_POWERED for a in bodies)
    placed = all(p.prep in _IN_PLACE for p in f.phrases) and not {*f.adverbs} & _COURSES
    return wheels and all(at_rest(d, a) for a in bodies) and placed and not f.verb.extra


def _first_turn(d: Discourse, f: Frame, angles: list[Amount]) -> float:
    """How far the first of the turns of a clause goes [degrees]: as stated, else as usual."""
    degrees = 180.0 if f.verb.extra.get("dir") in ("u", "around", "back") else 90.0
    if angles:
        degrees = _degrees(d, angles[0])
    return degrees


def turn(
    d: Discourse,
    f: Frame,
    actors: list[str],
    direction: str,
    degrees: float,
    rates: tuple[float, float] | None = None,
    *,
    lasts: float | None = None,
) -> None:
    """Each actor turns from when the clause says on, or until then; rates in degrees/s.

    With `lasts` [s] it goes round so long, and no heading is told of that it reaches.
    """
    for actor in [a for a in actors if movable(d, a)]:
        track = d.timeline.track(actor)
        done_to = f.object is not None and actor in f.object.entities
        idle = track.motion is None and not track.hit and kind_of(d, actor) not in SELF_POWERED
        if done_to and idle:
            _turn_in_place(d, f, actor, direction, degrees)
            continue
        if track.motion is None:
            start_motion(d, f, [actor], "own")
        lasting, ends = _lasting(d, f), None
        time = time_of(d, f) if lasting is None else None
        if time is not None and (isinstance(time[0], tuple) or f.phrase("by") is not None):
            time, ends = None, time  # "turns right within 6 s": when the turn is done
        now = track.motion or Motion("own")
        begin = add_event(d, NodeEvent.TRIGGER, (actor,), f, time, stem="turn_start")
        track.closed = True
        told: dict[str, object] = {"turn_direction": direction, "turn_degrees": degrees}
        params = {**told, "turn_rate_deg_s": rates or _rates(degrees, lasting)}
        swing = Motion("turn", now.speed, now.prescribed, None, params)
        d.timeline.move(actor, swing, direction_of(d, actor, "own"))
        if lasts is not None:
            end = d.timeline.trigger(actor, f"{actor} has gone round")
            constrain(d.timeline.node(end), "time_since", lasts, actor, since=begin)
            continue
        end = add_event(d, NodeEvent.HEADING_REACHED, (actor,), f, ends, **told)
        ended = d.timeline.node(end)
        if rates is not None and ended is not None:
            ended.usual = degrees / ROUND_DEG_S
        if lasting is not None:
            constrain(d.timeline.node(end), "time_since", lasting.value, actor, since=begin)
            mark_used(d, lasting, f"duration of the turn up to {end}")


def _turn_in_place(d: Discourse, f: Frame, body: str, direction: str, degrees: float) -> None:
    """ "Turn the block to the left": what goes nowhere by itself is turned where it is."""
    spin = Motion("spin", params={"turn_direction": direction})
    d.timeline.move(body, spin, ForceDirection.HORIZONTAL_PLANE)
    add_event(d, NodeEvent.SPIN, (body,), f, time_of(d, f), turn_degrees=degrees)
    mark_used(d, f, "turn in place")


def _lasting(d: Discourse, f: Frame) -> Amount | None:
    """ "turns right by 90 degrees in 1 s": how long it takes, if the angle is stated too."""
    if amount(d, f, "angle") is None:
        return None
    times = [p.amount for p in f.phrases if p.amount and p.prep in ("in", "over", "during")]
    return next((a for a in times if a.dimension == "time" and a.measure != "start"), None)


@sense("swerve")
def read_swerve(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    sides = {p.mention.head for p in f.phrases if p.mention is not None} | {*f.adverbs}
    if f.verb.lemma == "dodge" and not sides & {"left", "right"}:
        read_as(d, "avoid", f, s, o)  # it says that it is not hit, not where it goes
        return
    angle, around = amount(d, f, "angle"), f.phrase("around", "past")
    mark_used(d, angle, "turn angle")
    degrees = angle.middle if angle is not None else 30.0
    turn(d, f, s, "right" if "right" in sides else "left", degrees)
    avoided = o if around is None else things(around)
    for actor in s:
        for other in avoided[:1]:
            if other != actor and not structural(d, other):
                add_event(d, NodeEvent.MISS, (actor, other), f, None)
    if f.phrase("into") is not None:
        outcomes(d, f, s)


_SPEEDS_PAST = frozenset({"overtake", "outrun", "outpace", "outdistance"})
"""Verbs of which what is passed goes the same way, more slowly."""


def _rides_along(d: Discourse, other: str) -> bool:
    """ "Overtakes a cyclist": it goes by itself, and is not said to be parked."""
    self_powered = kind_of(d, other) in SELF_POWERED and movable(d, other)
    return self_powered and at_rest(d, other) and not all_rest(d.world, [other])


@sense("overtake")
def read_overtake(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    s, o = doer_and_done(f, s, o)
    for actor in s:
        if at_rest(d, actor):
            start_motion(d, f, [actor])
        for other in each_passed(f, o):
            if other != actor and not structural(d, other):
                if other == o[0]:
                    place(d, [actor], [other], "behind")
                if f.verb.lemma in _SPEEDS_PAST and _rides_along(d, other):
                    own(d, other, SPEEDS.get(kind_of(d, other)), False)
                add_event(d, NodeEvent.MISS, (actor, other), f, time_of(d, f), stem="overtakes")
    mark_used(d, f, "overtaking")


@sense("merge")
def read_merge(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A change of lane keeps the heading: it is motion."""
    motion(d, f, s, None)
    mark_used(d, f, "change of lane")


@sense("reverse")
def read_reverse(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    leave_again(d, f, s or o)
    motion(d, f, s or o, "own")
    reverse(d, s or o)


def leave_again(d: Discourse, f: Frame, actors: list[str]) -> list[str]:
    """ "Walks up to a cat and backs away", "drives to a gate and on": it has been there by then."""
    there = [a for a in actors if _heads_somewhere(d, f, a)]
    for actor in there:
        settle(d, actor, None)
    return there


def _heads_somewhere(d: Discourse, f: Frame, actor: str) -> bool:
    """Whether a clause before this one tells of an arrival of which nothing came yet."""
    event, told, _, _ = d.times.pending.get(actor, (None, f, None, None))
    later = told.verb.start < f.verb.start and not (f.reduced or f.subordinate or f.relative)
    return event is NodeEvent.REACH and told is not f and later
