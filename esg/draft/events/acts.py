"""Acts that the readings of verbs are made of: motions with their outcomes, hits, entries."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.core import (
    aimable,
    entity_of,
    kind_of,
    mark_used,
    movable,
    quantity_of,
    structural,
)
from esg.draft.discourse.event_coreference import goes_on, time_of_told, told_before
from esg.draft.discourse.places import carries, elevated, fits_on, holds, place, set_free
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.scene import SELF_POWERED, SPEEDS
from esg.draft.discourse.tracks import Motion
from esg.draft.events.ends import (
    EDGES,
    bounces_over,
    comes_down,
    heads_for,
    implied_goal,
    off_the_edge,
    takes_up_from_above,
    touches_later,
)
from esg.draft.events.hanging import openable, turning
from esg.draft.events.motions import natural, own, speed_of, start_motion
from esg.draft.events.roles import role
from esg.draft.events.timing import (
    PUSHING,
    enter,
    enterable,
    is_airborne,
    moved_by_others,
    record_event,
    representatives,
    settle,
    time_of,
)
from esg.draft.events.told import (
    at_rest,
    happened,
    last_event,
    mates_of,
    moves,
    recent,
    size_of,
    traits_of,
)
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.graph.models import ForceDirection, NodeEvent

_GOALMOUTH = lex.word_set("goalmouth")
_GOING = lex.word_set("going (acts)")
WAYS = lex.word_set("ways (acts)")
_HOLDING = lex.word_set("holding (acts)")
_MOVED = frozenset({"moving", "sliding"})
_OPENINGS = frozenset({"hole", "water"})
_FITS_IN = 0.8
"""Longest side of what ends up in a vessel over the longer side of the vessel's outline."""
_ENDING_IN = ("cause", "fall", "land", "pocket", "launch", "drop", "reach")
_STANDING = ("noop", "be", "posture")


@dataclass
class Way:
    """A phrase that says where a motion leads.

    Args:
        f: Its clause.
        p: The phrase.
        m: What it names.
        others: Ids of that, those that move left out.
        time: The time that the clause states.
        fallen: Who has been told to fall by a phrase before.
    """

    f: Frame
    p: Phrase
    m: Mention
    others: list[str]
    time: Time | None
    fallen: set[str]


def outcomes(d: Discourse, f: Frame, actors: list[str]) -> None:
    """Events that a motion's prepositional phrases state: into, off, onto, against, past."""
    time = time_of(d, f)
    fallen: set[str] = set()
    if "in" in f.adverbs and f.verb.lemma in _GOING and role(f, "inside") is None:
        _goes_in_off(d, f, actors, time)
    for p in f.phrases:
        m = p.mention
        if m is None or m.part in WAYS:
            continue  # "walks into the path of a tram"
        if off_the_edge(d, f, p, actors, time):
            fallen.update(actors)
            continue
        if p.prep in ("out of", "from") and m.head in _HOLDING:
            for actor in actors if f.verb.sense in ("slide", "drop", "fall") else []:
                add_event(d, NodeEvent.FALL, (actor,), f, time)  # "slips out of his hand"
            continue
        others = [i for i in m.entities if i not in actors]
        reader = OUTCOMES.get(p.prep)
        if not others or reader is None:
            continue
        for actor in actors:
            reader(d, actor, Way(f, p, m, others, time, fallen))


def _goes_in_off(d: Discourse, f: Frame, actors: list[str], time: Time | None) -> None:
    """ "goes in off the post": hits the post on its way."""
    off = f.phrase("off")
    if off is not None and off.mention is not None and not off.mention.attribute:
        solid = [i for i in off.mention.entities if aimable(d, i) and i not in actors]
        add_hit(d, f, actors, solid[:1])
    goes_in(d, f, actors, time)


def _into(d: Discourse, actor: str, way: Way) -> None:
    if actor in way.fallen and holds(d, way.others[0]):
        enter(d, way.f, actor, way.others[0], way.time)
    else:
        go_into(d, way.f, actor, way.others, way.p, way.time)


def _against(d: Discourse, actor: str, way: Way) -> None:
    if way.p.prep == "against" or not structural(d, way.others[0]):
        add_hit(d, way.f, [actor], way.others[:1], way.time)


def _off(d: Discourse, actor: str, way: Way) -> None:
    """ "rolls off the table", "falls from a shelf", "slides over the edge"."""
    f, p, other = way.f, way.p, way.others[0]
    if p.prep in ("from", "out of") and f.verb.sense not in ("fall", "slide", "drop"):
        return
    slips = p.prep == "off" and f.verb.sense in ("roll", "slide", "fall", "drop")
    high = elevated(d, other) or (slips and carries(d, other, actor))
    high = high or (p.prep == "off" and f.verb.lemma in ("jump", "leap", "hop"))
    high = high or (p.prep == "off" and _on_the_back_of(d, f, other, way.m))
    if high and movable(d, actor) and (p.prep != "over" or way.m.part):
        place(d, [actor, *those_with(d, f, actor)], [other], "on")
        _struck_up_there(d, actor, other)
        _leaves_from(d, actor, f)
        add_event(d, NodeEvent.FALL, (actor,), f, way.time)
        way.fallen.add(actor)
        return
    slides = f.verb.sense in ("slide", "roll") and not f.verb.passive and p.prep == "over"
    if slides and kind_of(d, other) == "table" and fits_on(d, actor, other):
        place(d, [actor], [other], "on")  # "a cup slides over the table"


def _struck_up_there(d: Discourse, struck: str, host: str) -> None:
    """ "A marble hits a cup, which falls off the table": the marble rolls on the table, too."""
    hitter = d.moves.last_hit[0] if d.moves.last_hit and d.moves.last_hit[1] == struck else ""
    if not hitter or kind_of(d, hitter) in SELF_POWERED or is_airborne(d, hitter):
        return
    told = d.scene.supported_by.keys() | d.scene.inside_of.keys() | d.scene.heights.keys()
    thrown = any(hitter in sent for sent in d.refs.launched_by.values())
    if hitter not in told and not thrown and fits_on(d, hitter, host):
        place(d, [hitter], [host], "on")


def those_with(d: Discourse, f: Frame, actor: str) -> list[str]:
    """ "Knocks the cups off the shelf": the others of them are there, too."""
    named = {i for m in (f.subject, f.object) if m is not None and m.plural for i in m.entities}
    mates = [i for i in mates_of(d, actor) if i != actor and i in named] if actor in named else []
    elsewhere = d.scene.supported_by.keys() | d.scene.inside_of.keys()
    return [i for i in mates if i not in elsewhere and at_rest(d, i)]


def _on_the_back_of(d: Discourse, f: Frame, other: str, m: Mention) -> bool:
    """ "Blows the hat off his head", "is thrown off her horse": it was on that."""
    off = f.verb.sense in ("launch", "roll", "slide", "fall", "drop")
    body = bool(m.part) or m.head in lex.BODY_PARTS
    return off and kind_of(d, other) in (("person", "animal") if body else ("animal",))


def _leaves_from(d: Discourse, actor: str, f: Frame) -> None:
    """ "Throws a bear off the bed": on which it is, and not in a hand over the floor."""
    track = d.timeline.track(actor)
    if track.motion is None or track.closed or track.motion.mode != "throw":
        return
    speed = track.motion.speed if track.motion.prescribed else None
    track.motion, track.direction = None, None
    start_motion(d, f, [actor], "roll" if "round" in traits_of(d, actor) else "slide")
    if speed is not None and track.motion is not None:
        track.motion.speed, track.motion.prescribed = speed, True


def _on_a_slope(d: Discourse, actor: str, way: Way) -> None:
    if "incline" in traits_of(d, way.others[0]):
        place(d, [actor], way.others[:1], "on" if way.p.prep == "down" else "near")


def _along(d: Discourse, actor: str, way: Way) -> None:
    if "support" in traits_of(d, way.others[0]):
        place(d, [actor], way.others[:1], "on")
        d.moves.on_top[actor] = way.others[0]


def _to_the_edge(d: Discourse, actor: str, way: Way) -> None:
    """ "rolls toward the edge of the desk": it is on the desk."""
    other = way.others[0]
    if way.m.part in EDGES and elevated(d, other) and fits_on(d, actor, other):
        place(d, [actor], [other], "on")


def _past(d: Discourse, actor: str, way: Way) -> None:
    if touches_later(d, way.f, way.others[0]):
        mark_used(d, way.f, "on the way to the contact")
    elif not structural(d, way.others[0]):
        add_event(d, NodeEvent.MISS, (actor, way.others[0]), way.f, way.time)


def _to(d: Discourse, actor: str, way: Way) -> None:
    other = way.others[0]
    if way.m.part in EDGES and d.scene.supported_by.get(actor) == other:
        return  # "rolls to the edge of a desk": it is on it
    if not structural(d, other):
        if not way.m.attribute:
            heads_for(d, way.f, actor, other, way.time)
    elif comes_down(d, way.f, actor, way.p):
        add_event(d, NodeEvent.FALL, (actor,), way.f, way.time)


OUTCOMES: dict[str, Callable[[Discourse, str, Way], None]] = {
    **dict.fromkeys(("into", "in", "inside", "through"), _into),
    **dict.fromkeys(("against", "onto"), _against),
    **dict.fromkeys(("off", "over", "from", "out of"), _off),
    **dict.fromkeys(("down", "up"), _on_a_slope),
    **dict.fromkeys(("along", "across"), _along),
    **dict.fromkeys(("toward", "towards"), _to_the_edge),
    "past": _past,
    "to": _to,
}
"""What a motion leads to, by the preposition that says so."""


def goes_in(d: Discourse, f: Frame, actors: list[str], time: Time | None) -> None:
    """ "bounces off the rim and goes in": into the goal, hoop or hole named before."""
    named = recent(d)
    for actor in actors:
        goals = [i for i in named if enterable(d, i)]
        last = last_event(d)
        passed = str(last.extra.get("region", "")).split("/")[0] if last is not None else ""
        goals = [i for i in goals if i != passed] or goals  # "through the hoop and back in"
        goal = next(iter(goals), d.moves.aim.get(actor, ""))
        if not goal and kind_of(d, actor) in ("ball", "sliding"):
            posts = any(entity_of(d, i).head.split()[-1] in _GOALMOUTH for i in named)
            goal = implied_goal(d, actor) if posts else ""
        if goal and (enterable(d, goal) or holds(d, goal)):
            enter(d, f, actor, goal, time)


def go_into(
    d: Discourse, f: Frame, actor: str, others: list[str], p: Phrase, time: Time | None
) -> None:
    """Something moves into others: it enters them, arrives there, or hits them."""
    other, sense = others[0], f.verb.sense
    if structural(d, other):
        return
    if p.prep == "through" and _breaks(d, f, other) and not p.mention_plural:
        add_hit(d, f, [actor], others, time)
    elif p.prep != "into" and sense not in _ENDING_IN and not _goal(d, other):
        return
    elif enterable(d, other) or (
        (_from_above(d, f, actor, other) or _down_a_chute(d, actor, other))
        and takes_up_from_above(d, other, p.prep)
    ):
        enter(d, f, actor, other, time)
    else:
        add_hit(d, f, [actor], others, time)


def _breaks(d: Discourse, f: Frame, other: str) -> bool:
    """ "drives through a hedge": what stops what goes through it."""
    noun = entity_of(d, other).noun
    barrier = noun.kind in ("wall", "street") or noun.name in ("hedge", "bush")
    barrier = barrier or bool(turning(d, [other]))  # "walks through a turnstile"
    return barrier and noun.name not in ("door", "window") and f.verb.sense not in _STANDING


def _goal(d: Discourse, other: str) -> bool:
    return "goal" in traits_of(d, other) or kind_of(d, other) == "region"


def _from_above(d: Discourse, f: Frame, actor: str, other: str) -> bool:
    """Whether it comes out of the air, so that it can get over a rim."""
    sense = f.verb.sense
    if is_airborne(d, actor) and sense not in ("roll", "slide"):
        return True
    if sense == "bounce" and bounces_over(d, actor, other):
        return True
    return "there" in f.adverbs and actor in d.moves.came_down


def _down_a_chute(d: Discourse, actor: str, other: str) -> bool:
    """Whether a slope leads something into what it has room in: a marble, not a car, into a box."""
    if not comes_down_a_slope(d, actor) or other in d.scene.supported_by:
        return False
    return max(size_of(d, actor)) < _FITS_IN * max(size_of(d, other)[:2])


def add_event(
    d: Discourse,
    kind: NodeEvent,
    participants: tuple[str, ...],
    f: Frame,
    time: Time | None,
    **extra: Any,
) -> str:
    """Adds a point event; its first participant is set in motion if nothing moves it yet."""
    told = told_before(d, kind, participants, f, extra.get("region", ""))
    if told:
        time_of_told(d, told, time)
        mark_used(d, f, told)
        return told
    track = d.timeline.tracks.get(participants[0])
    if (track is None or not track.under_way) and not movable(d, participants[0]):
        set_free(d, [participants[0]])
    ensure_mover(d, f, participants[0], None)
    return record_event(d, kind, participants, f, time, **extra)


def ensure_mover(d: Discourse, f: Frame, mover: str, target: str | None) -> None:
    """Sets in motion what nothing moves yet."""
    track = d.timeline.tracks.get(mover)
    if openable(d, [mover]) and (track is None or not (track.hit or track.motion)):
        d.timeline.move(mover, Motion("drive"), ForceDirection.ANY_3D)  # "a drawer hits a cup"
        return
    if track is None or not track.under_way or track.waiting:
        start_motion(d, f, [mover], None, target)


def add_hit(
    d: Discourse, f: Frame, movers: list[str], targets: list[str], time: Time | None = None
) -> list[str]:
    """Collision events of movers with targets (one for a plural of things in a group)."""
    out: list[str] = []
    targets = representatives(d, targets, movers)
    if len(movers) > 3 or any(entity_of(d, m).group in d.world.vague for m in movers):
        movers = representatives(d, movers, [])  # "darts hit the board"
    for mover in movers:
        for target in targets:
            pair = _who_hits(d, f, mover, target) if mover != target else None
            if pair is None:
                continue
            if f.verb.lemma in ("run", "drive", "slam") and kind_of(d, target) in _OPENINGS:
                enter(d, f, mover, target, time)  # "runs into the gutter"
                continue
            _up_there(d, *pair)
            out.append(_hit(d, f, *pair, time))
            time = None
    return out


def _up_there(d: Discourse, mover: str, target: str) -> None:
    """ "Jumps onto a table and pushes a glass": that is on it, too, if nothing else is said."""
    host = d.moves.upon.get(mover, target)
    if host != target and target not in d.scene.supported_by and fits_on(d, target, host):
        place(d, [target], [host], "on")


def _who_hits(d: Discourse, f: Frame, mover: str, target: str) -> tuple[str, str] | None:
    """Mover and target, the other way round if the mover cannot move; None if neither can."""
    if mover not in d.world.entities or structural(d, target):
        return None
    if "region" in (kind_of(d, mover), kind_of(d, target)):
        return None  # a pocket is a part of its table
    if _is_made_to_move(d, f, mover):
        set_free(d, [mover])
    if not movable(d, mover) and not openable(d, [mover]):
        mover, target = target, mover
        if not movable(d, mover) or not aimable(d, target):
            return None  # "is bumped by a sidewalk"
    return mover, target


def _is_made_to_move(d: Discourse, f: Frame, mover: str) -> bool:
    """ "A moving wall pushes a box", "a wall slides into it": the wall moves, and not the box."""
    if structural(d, mover) or movable(d, mover):
        return False
    m = f.subject
    slides = m is not None and mover in m.entities and not f.verb.passive
    return bool(_MOVED & {*entity_of(d, mover).adjectives}) or (slides and f.verb.sense == "slide")


def _hit(d: Discourse, f: Frame, mover: str, target: str, time: Time | None) -> str:
    """One collision, with what it settles of the arrivals told before."""
    aimed = d.times.pending.get(target)
    if aimed is not None and aimed[0] in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION):
        mover, target = target, mover  # "a keeper blocks the shot": the ball arrives
    _settle_others(d, mover, target)
    share_support(d, f, mover, target)
    _was_under_way(d, f, target)
    # "swings shut and hits a bucket": on its way, not once it is shut
    closes = d.timeline.undone(mover, NodeEvent.CLOSE) if openable(d, [mover]) else None
    if closes is not None:
        d.timeline.move(mover, Motion("drive"), ForceDirection.ANY_3D)
    event = add_event(d, NodeEvent.COLLISION, (mover, target), f, time)
    if closes is not None:
        d.timeline.move(mover, Motion("drive"), ForceDirection.ANY_3D)
        d.timeline.told_again(closes)
        d.timeline.track(mover).motion = None
    d.moves.last_hit = (mover, target)
    return event


def _was_under_way(d: Discourse, f: Frame, target: str) -> None:
    """Sets what is hit in motion, where the prompt goes on as if it were: "then brakes"."""
    e = entity_of(d, target)
    if target in d.timeline.tracks or e.noun.kind not in SELF_POWERED or target in d.moves.still:
        return
    if goes_on(d, f, target):
        own(d, target, SPEEDS.get(e.noun.kind, (50.0, 600.0)), False)


def _settle_others(d: Discourse, mover: str, target: str) -> None:
    """What was sent at a thing before arrives before the next one does."""
    mates = d.world.groups.get(entity_of(d, target).group or "", [target])
    for name, (kind, _, other, _) in list(d.times.pending.items()):
        aimed = kind is NodeEvent.COLLISION and other in mates
        own = entity_of(d, mover).group
        aimed = aimed and not (own and own == entity_of(d, name).group)
        if aimed and name not in (mover, target) and mover in d.world.entities:
            settle(d, name, None)


def share_support(d: Discourse, f: Frame, mover: str, target: str) -> None:
    """What rolls across a table and hits a cup there, or pushes it, shares its table."""
    hosts = d.scene.supported_by
    for one, other in ((mover, target), (target, mover)):
        host = hosts.get(one)
        if host is None or other in hosts or other in d.scene.inside_of or other == host:
            continue
        if d.moves.upon.get(other) == host:
            continue  # it has got there by itself
        if not fits_on(d, other, host) or is_airborne(d, mover) or d.moves.aim.get(mover) == host:
            continue
        # a domino that tips over onto those on a table
        pushed = f.verb.lemma in PUSHING or mover in d.moves.rolling
        pushed = pushed or happened(d, NodeEvent.TOPPLE, mover)
        if not happened(d, NodeEvent.FALL, one) and (one == mover or pushed):
            mates = [i for i in mates_of(d, other) if i != other and i not in hosts]
            place(d, [other, *(i for i in mates if i not in d.scene.inside_of)], [host], "on")


def comes_down_a_slope(d: Discourse, mover: str) -> bool:
    """Whether something is on its way down a ramp: it arrives faster than it set off."""
    host = d.scene.supported_by.get(mover)
    return host is not None and moves(d, mover) and "incline" in traits_of(d, host)


def braking(d: Discourse, mover: str) -> bool:
    """Whether what moves it is that it brakes."""
    track = d.timeline.tracks.get(mover)
    return track is not None and track.motion is not None and track.motion.mode == "brake"


def kinematics(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> None:
    """A stated speed belongs to the mover ("hits the wall at 5 m/s": just before it)."""
    if not movers or quantity_of(d, f, "speed") is None:
        return
    speed, prescribed = speed_of(d, f, movers, natural(d, movers[0]))
    for mover in movers:
        track = d.timeline.tracks.get(mover)
        if braking(d, mover) or comes_down_a_slope(d, mover):
            continue
        if moves(d, mover) and track is not None and track.motion is not None:
            track.motion.speed, track.motion.prescribed = speed, prescribed
        elif not moved_by_others(d, mover):
            start_motion(d, f, [mover], None, targets[0] if targets else None)
