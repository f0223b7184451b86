"""Verbs of steering: turn, swerve, overtake, change lanes, reverse."""

from __future__ import annotations

from esg.draft.discourse.core import (
    amounts_of,
    kind_of,
    mark_used,
    movable,
    quantity_of,
    structural,
)
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event, outcomes
from esg.draft.events.motions import direction_of, each_passed, motion, reverse, start_motion
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import time_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount, find_amounts
from esg.graph.models import EventConstraint, NodeEvent

_LEAST_TURN_S = 0.01
"""A turn told to last less has no rate of its own."""


def _rates(degrees: float, lasting: Amount | None) -> tuple[float, float]:
    """The rates of a turn [deg/s]: as long as it lasts, or what vehicles and walkers do."""
    if lasting is None or lasting.low < _LEAST_TURN_S:
        return (20.0, 120.0)
    return (0.9 * degrees / lasting.high, 1.1 * degrees / lasting.low)


@sense("turn")
def read_turn(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if s and not any(movable(d, a) for a in s):
        d.scene.ignored[(f.verb.start, f.verb.end)] = "a fixed object does not turn"
        return
    driven = [i for i in o[:1] if kind_of(d, i) == "vehicle"]
    own = f.object is not None and f.object.determiner in ("its", "his", "her")
    own = own and not driven
    if own and f.object is not None and (not o or o[:1] != s[:1]):
        d.scene.ignored[(f.verb.start, f.verb.end)] = "a part turns, not the whole"
        return
    words = [*f.adverbs, f.verb.extra.get("dir", "")]
    span = d.text[f.verb.start : f.verb.end + 40].lower()
    sides = {"left": "left", "anticlockwise": "left", "counterclockwise": "left"}
    sides |= {"right": "right", "clockwise": "right"}
    direction = next((sides[w] for w in words if w in sides), "")
    if not direction:
        direction = "right" if " right" in span.split(".")[0] else "left"
    degrees = 180.0 if f.verb.extra.get("dir") in ("u", "around", "back") else 90.0
    amount = quantity_of(d, f, "angle")
    if amount is not None:
        degrees = max(1.0, min(720.0, abs(amount[1].middle)))
        mark_used(d, amount[1], "turn angle")
    for a in find_amounts(d.text[f.verb.start : f.verb.end]):
        degrees = max(1.0, min(720.0, abs(a.middle)))  # "makes a 60-degree turn"
        d.scene.used[(f.verb.start + a.start, f.verb.start + a.end)] = "turn angle"
    actors = s or o
    if not actors:
        actors = [a for a, t in d.timeline.tracks.items() if t.motion is not None][-1:]
    turn(d, f, actors, direction, degrees, NodeEvent.HEADING_REACHED)
    _further_turns(d, f, actors, degrees)


def _further_turns(d: Discourse, f: Frame, actors: list[str], degrees: float) -> None:
    """ "turns right, then left": the turns after the first, each with its own angle."""
    sides = [x for x in f.adverbs if x in ("left", "right")]
    sides += [
        p.mention.head
        for p in f.phrases
        if p.mention is not None and p.mention.head in ("left", "right")
    ]
    angles = [a for _, a in amounts_of(d, f) if a.dimension == "angle"]
    for k, side in enumerate(sides[1:], 1):
        if k < len(angles):
            degrees = max(1.0, min(720.0, abs(angles[k].middle)))
            mark_used(d, angles[k], "turn angle")
        turn(d, f, actors, side, degrees, NodeEvent.HEADING_REACHED)


def turn(
    d: Discourse, f: Frame, actors: list[str], direction: str, degrees: float, kind: NodeEvent
) -> None:
    for actor in actors:
        if not movable(d, actor):
            continue
        track = d.timeline.track(actor)
        if track.motion is None:
            start_motion(d, f, [actor], "own")
        time, ends = time_of(d, f), None
        lasting = lasting_of(d, f) if kind is NodeEvent.HEADING_REACHED else None
        time = None if lasting is not None else time
        if time is not None and (isinstance(time[0], tuple) or f.phrase("by") is not None):
            time, ends = None, time  # "turns right within 6 s": when the turn is done
        speed, prescribed = (
            (track.motion.speed, track.motion.prescribed) if track.motion else (None, False)
        )
        begin = add_event(d, NodeEvent.TRIGGER, (actor,), f, time, stem="turn_start")
        track.closed = True
        d.timeline.move(
            actor,
            Motion(
                "turn",
                speed,
                prescribed,
                None,
                {
                    "turn_direction": direction,
                    "turn_degrees": degrees,
                    "turn_rate_deg_s": _rates(degrees, lasting),
                },
            ),
            direction_of(d, actor, "own"),
        )
        end = add_event(d, kind, (actor,), f, ends, turn_direction=direction, turn_degrees=degrees)
        done = d.timeline.node(end)
        if lasting is not None and done is not None:
            done.constraints.append(
                EventConstraint(
                    quantity="time_since", object=actor, value=lasting.value, since=begin
                )
            )
            mark_used(d, lasting, f"duration of the turn up to {end}")


def lasting_of(d: Discourse, f: Frame) -> Amount | None:
    """ "turns right by 90 degrees in 1 s": how long it takes, if the angle is stated too."""
    if quantity_of(d, f, "angle") is None:
        return None
    times = [p.amount for p in f.phrases if p.amount and p.prep in ("in", "over", "during")]
    return next((a for a in times if a.dimension == "time" and a.measure != "start"), None)


@sense("swerve")
def read_swerve(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    sides = {p.mention.head for p in f.phrases if p.mention is not None} | {*f.adverbs}
    if f.verb.lemma == "dodge" and not sides & {"left", "right"}:
        read_as(d, "avoid", f, s, o)  # it says that it is not hit, not where it goes
        return
    direction = (
        "right"
        if "right" in f.adverbs or any(p.mention and p.mention.head == "right" for p in f.phrases)
        else "left"
    )
    amount = quantity_of(d, f, "angle")
    degrees = amount[1].middle if amount is not None else 30.0
    if amount is not None:
        mark_used(d, amount[1], "turn angle")
    turn(d, f, s, direction, degrees, NodeEvent.HEADING_REACHED)
    avoided = o
    around = f.phrase("around", "past")
    if around is not None and around.mention is not None:
        avoided = around.mention.entities
    for actor in s:
        for other in avoided[:1]:
            if other != actor and not structural(d, other):
                add_event(d, NodeEvent.MISS, (actor, other), f, None)
    into = f.phrase("into")
    if into is not None and into.mention is not None:
        outcomes(d, f, s)


@sense("overtake")
def read_overtake(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.passive:
        by = f.phrase("by")
        s, o = (list(by.mention.entities) if by and by.mention else []), s
    for actor in s:
        track = d.timeline.tracks.get(actor)
        if track is None or track.motion is None:
            start_motion(d, f, [actor])
        for other in each_passed(f, o):
            if other != actor and not structural(d, other):
                if other == o[0]:
                    place(d, [actor], [other], "behind")
                add_event(d, NodeEvent.MISS, (actor, other), f, time_of(d, f), stem="overtakes")
    mark_used(d, f, "overtaking")


@sense("merge")
def read_merge(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A change of lane keeps the heading: it is motion."""
    motion(d, f, s, None)
    mark_used(d, f, "change of lane")


@sense("reverse")
def read_reverse(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    actors = s or o
    motion(d, f, actors, "own")
    reverse(d, actors)
