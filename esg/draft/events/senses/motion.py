"""Verbs of motion: drive, roll, slide, fly, bounce, reach."""

from __future__ import annotations

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
from esg.draft.discourse.places import holds, place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import SELF_POWERED, STRUCK, Relation
from esg.draft.events.acts import add_event, add_hit, ensure_mover, go_into, kinematics
from esg.draft.events.arrivals import bounces_over
from esg.draft.events.motions import flies_itself, motion, start_motion, target_of
from esg.draft.events.senses.contact import hit_targets
from esg.draft.events.senses.launch import aim_at, launch_by, motion_of_things
from esg.draft.events.senses.steer import turn
from esg.draft.events.senses.topple import read_knock
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import (
    enter,
    enterable,
    is_airborne,
    moved_by_others,
    representatives,
    time_of,
)
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent

_ON_FOOT = lex.word_set("on foot")


@sense("own")
def read_own(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if s and o and kind_of(d, s[0]) == "person" and kind_of(d, o[0]) in STRUCK:
        launch_by(d, f, s, o)  # "the batsman drives the ball past the bowler"
        return
    actors = list(s)
    if o and s and kind_of(d, s[0]) == "person" and f.object is not None and not f.object.attribute:
        if kind_of(d, o[0]) in SELF_POWERED:
            actors = o[:1]
            if f.subject is not None:
                d.refs.mounts[id(f.subject)] = actors
            place(d, s, o, "near")
    elif not s and o:
        actors = o
    actors = [a for a in actors if movable(d, a)]
    sides = [x for x in f.adverbs if x in ("left", "right")]
    if (
        sides
        and actors
        and kind_of(d, actors[0]) in SELF_POWERED
        and f.verb.lemma in ("go", "move", "drive", "head", "run", "walk", "ride")
    ):
        for side in sides:
            turn(d, f, actors, side, 90.0, NodeEvent.HEADING_REACHED)
        return
    mode = None
    if actors and kind_of(d, actors[0]) in SELF_POWERED:
        mode = "own"
    if actors and f.verb.lemma in _ON_FOOT and kind_of(d, actors[0]) in ("person", "animal"):
        mode = "own"  # also what was hit: "is hit by a ball and runs into a fence"
    motion(d, f, actors, mode)
    if f.verb.lemma in ("charge", "lunge", "leap", "pounce", "spring", "fly", "dive"):
        aim_at(d, f, actors, next(iter(target_of(d, f, actors)), None))


@sense("approach")
def read_approach(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    motion(d, f, s, None)
    for actor in s:
        if o:
            d.moves.aim[actor] = o[0]
            track = d.timeline.tracks.get(actor)
            if track is not None and track.motion is not None:
                track.motion.target = o[0]


@sense("follow")
def read_follow(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.passive:
        by = f.phrase("by")
        s, o = (list(by.mention.entities) if by and by.mention else []), s
    if "in" in f.adverbs and o and _follows_in(d, f, s, o[0]):
        return
    motion(d, f, s, None)
    for actor in s:
        if o:
            d.moves.aim.setdefault(actor, o[0])
            gap = quantity_of(d, f, "length")
            if gap is not None and gap[0] == "at" and actor not in d.scene.travel:
                relation = Relation(actor, o[0], "behind", gap[1].value)
                d.scene.relations.append(relation)  # "follows it at a distance of 15 m"
                mark_used(d, gap[1], "distance")
            else:
                place(d, [actor], o, "behind")
            track = d.timeline.tracks.get(o[0])
            if (track is None and movable(d, o[0])) or (
                track is not None
                and track.motion is not None
                and (p := f.phrase("at")) is not None
                and p.mention is not None
                and "same" in p.mention.adjectives
            ):
                start_motion(d, f, o[:1])


def _follows_in(d: Discourse, f: Frame, s: list[str], other: str) -> bool:
    """ "The cue ball follows it in": where the other one went."""
    return False


@sense("coast")
def read_coast(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    motion(d, f, s, None)


@sense("continue")
def read_continue(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    motion(d, f, s, None)


@sense("cross")
def read_cross(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    motion(d, f, s, None)


@sense("leave")
def read_leave(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    flung = (
        bool(s)
        and kind_of(d, s[0]) in STRUCK | {"sliding", "rock"}
        and not moved_by_others(d, s[0])
    )
    if flung and quantity_of(d, f, "angle") is not None:
        motion_of_things(d, f, s, "throw")  # "leaves the boot at an angle of 30 degrees"
        return
    motion(d, f, s, None)


def _pushes(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    """ "hits a bale, rolling it into a fence": the object is moved by the hit."""
    rolls = kind_of(d, s[0]) == "animal" and not f.reduced if s else False
    other = bool(s and o) and kind_of(d, s[0]) != "person" and s[0] != o[0]
    if other and not rolls and movable(d, o[0]):
        read_knock(d, f, s, o)
        mark_used(d, f, "consequence of the collision")
        return True
    return False


@sense("roll")
def read_roll(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.object is not None and f.object.pronoun in ("itself", "himself", "herself"):
        mark_used(d, f, "no motion of the whole")  # "rolls itself into a ball"
        return
    if _pushes(d, f, s, o):
        return
    actors = o if o and (not s or kind_of(d, s[0]) in ("person", "animal")) else s
    d.moves.rolling.update(actors)
    if f.subject is not None and actors == o:
        d.refs.thrown[id(f.subject)] = list(o)
    driven = actors and kind_of(d, actors[0]) in SELF_POWERED and not _sent_off(d, f, actors)
    if driven and not o:
        motion(d, f, actors, "own")
        return
    motion(
        d,
        f,
        actors,
        "roll"
        if actors and "round" in entity_of(d, actors[0]).noun.traits
        else "slide"
        if f.verb.sense == "slide"
        else "roll",
    )
    if f.verb.passive or actors == o:
        aim = next((t for t in target_of(d, f, actors) if aimable(d, t)), None)
        aim_at(d, f, representatives(d, actors, []), aim)


@sense("slide")
def read_slide(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if _pushes(d, f, s, o):
        return
    actors = o if o and (not s or kind_of(d, s[0]) == "person") else s
    d.moves.rolling.update(actors)
    gliding = f.verb.lemma == "glide" and bool(actors) and kind_of(d, actors[0]) == "person"
    driven = bool(actors) and kind_of(d, actors[0]) in SELF_POWERED - {"person", "cart"}
    driven = gliding or (driven and not _sent_off(d, f, actors))  # a skater glides along
    if driven and not o:
        motion(d, f, actors, "own")
        return
    motion(d, f, actors, "slide")


def _sent_off(d: Discourse, f: Frame, actors: list[str]) -> bool:
    """Whether a hit makes it roll or slide: what only drives or walks by itself."""
    if {"away", "off", "on"} & set(f.adverbs) and not f.phrases:
        return False
    return all(moved_by_others(d, a) and kind_of(d, a) != "robot" for a in actors)


@sense("fly")
def read_fly(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if s and flies_itself(d, s[0]):
        motion(d, f, s, "own")
    elif quantity_of(d, f, "angle") is not None and s and not moved_by_others(d, s[0]):
        motion_of_things(d, f, s, "throw")  # "flies off at an angle of 40 degrees"
    else:
        motion(d, f, s, "throw")


@sense("spin")
def read_spin(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    under = f.phrase("on", "upon")
    about = "around" in f.adverbs or "round" in f.adverbs or quantity_of(d, f, "angle")
    met = any(n.event is NodeEvent.COLLISION and {*s} & {*n.participants} for n in d.timeline.nodes)
    own = bool(s) and not met and kind_of(d, s[0]) in SELF_POWERED
    if own and about and f.phrase("to", "into") is None:
        read_as(d, "turn", f, s, o)  # "the robot spins around", which no hit makes it do
        return
    if s and under is not None and under.mention is not None and under.mention.entities:
        place(d, s, under.mention.entities, "on")
    elif s and not moved_by_others(d, s[0]):
        motion(d, f, s, None)
    elif s and f.phrase("into", "against", "off") is not None:
        read_as(d, "slide", f, s, o)  # hit by a car, it spins into a wall
    d.scene.ignored[(f.verb.start, f.verb.end)] = "spin is not prescribed"


@sense("bounce")
def read_bounce(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    p = f.phrase("off", "against", "on", "from", "into", "onto")
    kinematics(d, f, s, [])
    for actor in s:
        if p is not None and p.mention is not None and p.mention.attribute:
            ensure_mover(d, f, actor, None)
            if p.mention.head in ("cushion", "rail"):
                d.scene.needs.append(("billiard_table", actor))
            mark_used(d, f, "rebound")
            continue
        if p is not None and p.mention is not None and p.mention.entities:
            other = p.mention.entities[0]
            if structural(d, other):
                _ensure_drop(d, f, actor)
                mark_used(d, f, "bounce on the ground")
            elif {*(d.moves.last_hit or ())} == {actor, other} and p.prep in ("off", "from"):
                mark_used(d, f, "rebound of the collision")
            elif p.prep == "into" and _takes_up(d, actor, other):
                _met_first(d, f, actor, other)
                go_into(d, f, actor, p.mention.entities, p, time_of(d, f))
            else:
                nodes = add_hit(d, f, [actor], [other], time_of(d, f))
        else:
            aimed = d.moves.aim.get(actor)
            track = d.timeline.tracks.get(actor)
            if aimed is not None and track is not None and not track.closed:
                add_hit(d, f, [actor], [aimed], time_of(d, f))
            elif track is None:
                _ensure_drop(d, f, actor)
            mark_used(d, f, "rebound")
    for q in f.phrases:
        if q is not p and q.prep in ("off", "against") and q.mention is not None:
            others = [i for i in q.mention.entities if i not in s and not structural(d, i)]
            add_hit(d, f, s, others[:1])
    into = f.phrase("into")
    if into is not None and p is not into:
        for actor in s:
            go_into(d, f, actor, into.mention.entities if into.mention else [], into, None)


def _met_first(d: Discourse, f: Frame, actor: str, host: str) -> None:
    """ "is thrown at a wall and bounces into a bucket": off what it was aimed at."""
    aimed, track = d.moves.aim.get(actor), d.timeline.tracks.get(actor)
    if aimed is not None and aimed != host and track is not None and not track.closed:
        add_hit(d, f, [actor], [aimed])


def _takes_up(d: Discourse, actor: str, host: str) -> bool:
    """Whether a bounce leads into something: a goal always, over a rim out of the air."""
    over = is_airborne(d, actor) or bounces_over(d, actor, host)
    return enterable(d, host) or (over and holds(d, host))


def _ensure_drop(d: Discourse, f: Frame, actor: str) -> None:
    if actor not in d.timeline.tracks:
        start_motion(d, f, [actor], "drop")


@sense("reach")
def read_reach(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    targets = o or hit_targets(d, f, s, [])
    for actor in s:
        lines = [t for t in targets if entity_of(d, t).noun.name == "finish line"]
        told = [t for t in targets if t != actor and not structural(d, t)]
        target = next(iter(told or lines), None)
        if target is None and f.verb.lemma in ("get", "arrive"):
            target = d.moves.aim.get(actor)  # "runs to the swing and gets there first"
        if target is None or target == actor:
            motion(d, f, [actor], None)
            continue
        ensure_mover(d, f, actor, target)
        add_event(d, NodeEvent.REACH, (actor, target), f, time_of(d, f))


@sense("end")
def read_end(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "ends in the pond", "ends up on the floor": where it comes to be."""
    p = f.phrase("in", "into", "inside", "on", "onto", "against")
    if p is None or p.mention is None or not p.mention.entities or not s:
        return
    place = p.mention.entities[0]
    for actor in [a for a in s if a != place and movable(d, a)]:
        inner = p.prep in ("in", "into", "inside")
        if structural(d, place):
            if p.prep in ("on", "onto") and actor in d.scene.supported_by:
                add_event(d, NodeEvent.FALL, (actor,), f, time_of(d, f))
            mark_used(d, f, "end of the motion")
        elif inner and (holds(d, place) or enterable(d, place)):
            enter(d, f, actor, place, p.mention, time_of(d, f))
        else:
            add_hit(d, f, [actor], [place], time_of(d, f))


@sense("swing")
def read_swing(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    into = f.phrase("into", "against", "onto")
    if o and into is not None and into.mention is not None and into.mention.entities:
        add_hit(d, f, o[:1], into.mention.entities[:1], time_of(d, f))
        return  # "a crane swings a beam into a scaffold"
    target = hit_targets(d, f, s, o)
    if f.phrase("at", "into", "against") is not None and target and s:
        add_hit(d, f, s[:1], target, time_of(d, f))
    else:
        motion(d, f, s, None)
