"""Verbs of motion: drive, roll, slide, fly, bounce, reach."""

from __future__ import annotations

import re

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
from esg.draft.discourse.places import at_the_wheel, holds, place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND, LIMBED, LIVING, SELF_POWERED, STRUCK, Relation
from esg.draft.events.acts import add_event, add_hit, ensure_mover, go_into, kinematics
from esg.draft.events.courses import climbs, goes_steeply
from esg.draft.events.ends import bounces_over
from esg.draft.events.hanging import thrown_up
from esg.draft.events.motions import flies_itself, hover, motion, start_motion, target_of
from esg.draft.events.roles import doer_and_done, filling
from esg.draft.events.senses.climbing import climbs_something
from esg.draft.events.senses.contact import hit_targets
from esg.draft.events.senses.handling import bounces_on_ground
from esg.draft.events.senses.launch import aim_at, launch_by, motion_of_things, stand_by
from esg.draft.events.senses.steer import leave_again, turn
from esg.draft.events.senses.topple import read_knock
from esg.draft.events.stated import course_of
from esg.draft.events.table import sense
from esg.draft.events.timing import (
    enter,
    enterable,
    is_airborne,
    moved_by_others,
    representatives,
    time_of,
)
from esg.draft.events.told import at_rest, ignore, moves, things, traits_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

_HOVERING = lex.word_set("hovers")
_RIDES = lex.word_set("rides")
_ON_FOOT = lex.word_set("on foot")
_TURNING = lex.word_set("turns to a side")
_LEFT_THEN_RIGHT = re.compile(
    r"\s+(?:left|right)\b,?\s+(?:and\s+|then\s+)+(?:left|right)\b", re.IGNORECASE
)
_ROUND_DEG, _ROUND_RATES = 300.0, (10.0, 90.0)
"""How far somebody goes around something [degrees] and how fast that turns [degrees/s]."""
_ABOUT_S, _ABOUT_RATES = 8.0, (46.0, 50.0)
"""How long somebody goes round a yard, and how fast that turns [degrees/s]: one round or so."""
_DRIVES = lex.word_set("vehicle verbs")
_HALF_DEG = 180.0
_BACK = frozenset({"away", "back", "off"})
"""Adverbs of a way from what was reached."""
_AWAY = _BACK | {"on", "out", "past"}
"""Adverbs of a way that begins there."""
_STAYS_AT = frozenset({"in", "at", "above", "on", "near", "beside", "next to", "within"})
"""Prepositions of where something hovers that goes nowhere: "floats in the air", "above a pond"."""
_BRANCHES = ("at", "into", "onto")
"""Prepositions of where a way turns off: "goes left at the lights"; else it is the way it comes."""
_AT_A_TARGET = lex.word_set("goes at a target")

_RUNS = lex.word_set("gaits, fast")
_FOLLOWS = frozenset({"follow", "trail"})
_ANYHOW = lex.word_set("goes anyhow")
_ABOUT = lex.word_set("moves about in")


@sense("own")
def read_own(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Drives, walks, runs: by itself, or what a person drives."""
    if climbs_something(d, f, s):
        return
    if _sets_going(d, f, s, o):
        launch_by(d, f, s, o)
        return
    actors = [a for a in _driven(d, f, s, o) if movable(d, a)]
    if f.verb.lemma == "take" and _all_fly(d, actors):
        f.verb.lemma = "ascend"  # "a bird takes off"
        d.moves.flying.update(actors)
    kind = kind_of(d, actors[0]) if actors else ""
    sides = [x for x in f.adverbs if x in ("left", "right")]
    steered = kind in SELF_POWERED and f.verb.lemma in _TURNING
    if sides and steered and _changes_course(d, f, actors):
        for side in sides:
            turn(d, f, actors, side, 90.0)
        return
    # also what was hit: "is hit by a ball and runs into a fence"
    afoot = f.verb.lemma in _ON_FOOT and kind in LIVING
    if actors and goes_steeply(d, f) and all(climbs(d, a) for a in actors):
        d.moves.flying.update(actors)
        motion(d, f, actors, "own")
        return
    lies = f.verb.lemma == "float" and things(f.phrase("on", "upon"))  # "a duck floats on a pond"
    if f.verb.lemma in _HOVERING and not lies and _all_fly(d, actors):
        _hovers(d, f, actors)
        return
    if inner := _about_in(d, f, actors):
        place(d, actors, [inner], "in")
        ignore(d, f, "nothing shows how it moves about in there")
        return
    by_itself = kind in SELF_POWERED and f.verb.lemma not in _ANYHOW
    _goes_away_again(d, f, actors)
    motion(d, f, actors, "own" if by_itself or afoot else None)
    if f.verb.lemma in _AT_A_TARGET:
        aim_at(d, f, actors, next(iter(target_of(d, f, actors)), None))
    if kind in SELF_POWERED and _gone_around(d, f, actors, o):
        mounts = [d.scene.supported_by.get(a, a) for a in actors]  # "rides around on a bike"
        actors = mounts if all(i in d.timeline.tracks for i in mounts) else actors
        if _about_nothing(f):
            turn(d, f, actors, "left", 360.0, _ABOUT_RATES, lasts=_ABOUT_S)
            return
        turn(d, f, actors, "left", _ROUND_DEG, _ROUND_RATES)


def _about_in(d: Discourse, f: Frame, actors: list[str]) -> str:
    """ "A goldfish swims in a bowl": what somebody moves about in; "" if nothing holds him."""
    within = f.phrase("in", "inside", "within")
    if within is None or f.verb.lemma not in _ABOUT or f.verb.passive or f.verb.negated:
        return ""
    ways = (p for p in f.phrases if p is not within and course_of(p))
    fresh = bool(actors) and not any(a in d.timeline.tracks for a in actors)
    if not fresh or any(ways):
        return ""
    hosts = (i for i in things(within) if holds(d, i) and i not in actors)
    return next((i for i in hosts if all(_has_room(d, i, a) for a in actors)), "")


def _has_room(d: Discourse, host: str, node: str) -> bool:
    """Whether something is shorter and narrower than what it moves about in."""
    inner, outer = (sorted(entity_of(d, i).noun.dimensions_cm[:2]) for i in (node, host))
    return all(a < b for a, b in zip(inner, outer, strict=True))


def _goes_away_again(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "Walks to a door and walks away": somebody turns round there; a car drives on or off."""
    said = {*f.adverbs, *d.text[f.verb.start : f.verb.end].lower().split()}
    if not _AWAY & said or f.verb.form == "ing" or target_of(d, f, actors):
        return
    there = leave_again(d, f, actors)
    afoot = [a for a in there if kind_of(d, a) in LIMBED and f.verb.lemma not in _DRIVES]
    back = afoot if _BACK & said else []
    if back:
        turn(d, f, back, "left", _HALF_DEG)


def _gone_around(d: Discourse, f: Frame, actors: list[str], o: list[str]) -> bool:
    """ "Runs around a tree", "circles a tower", "around the yard", "in circles": on a round way."""
    if _about_nothing(f) and not f.unreal and not f.verb.negated and not f.verb.passive:
        return True
    middle = o if f.verb.lemma == "orbit" else things(f.phrase("around", "round"))
    middle = [i for i in middle if i not in actors and not structural(d, i)]
    moving = any(moves(d, i) for i in middle) or f.phrase("corner") is not None
    return bool(middle) and not moving and not f.unreal and not f.verb.negated


def _about_nothing(f: Frame) -> bool:
    """Whether a round way is about no thing: "around the yard", "in circles"."""
    about = things(f.phrase("around", "round"))
    if about == [GROUND]:
        return f.verb.lemma in _RUNS  # who walks around the park strolls about in it
    return in_circles(f) and not about


def in_circles(f: Frame) -> bool:
    """ "Runs in circles": round no thing."""
    return any(course_of(p) for p in f.phrases)


def _all_fly(d: Discourse, actors: list[str]) -> bool:
    """Whether there are some that go, and all fly by themselves."""
    return bool(actors) and all(flies_itself(d, a) for a in actors)


def _changes_course(d: Discourse, f: Frame, actors: list[str]) -> bool:
    """ "Goes left at the lights", "drives left then right", and what is under way already.

    But not "follows a cat, walking left": that is the way it comes.
    """
    beside = f.verb.form == "ing" or "absolute" in f.verb.extra
    under_way = not all(at_rest(d, a) for a in actors) and not beside
    branches = under_way or f.phrase(*_BRANCHES) is not None
    return branches or _LEFT_THEN_RIGHT.match(d.text, f.verb.end) is not None


def _sets_going(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    """ "The batsman drives the ball past the bowler", "a dog moves a pillow"."""
    if not s or not o:
        return False
    struck = kind_of(d, s[0]) in LIMBED and kind_of(d, o[0]) in STRUCK
    return struck or (f.verb.lemma == "move" and s[0] != o[0] and _by_hand(d, s[0], o[0]))


def _driven(d: Discourse, f: Frame, s: list[str], o: list[str]) -> list[str]:
    """Who moves: what a person drives, else who the clause is about."""
    thing = f.object is not None and not f.object.attribute
    if ridden := _ridden(d, f, s, o):
        return ridden
    rides = bool(s) and (kind_of(d, s[0]) in LIMBED or _toy_rides(d, f, s))
    if not (s and o and thing and rides):
        return s or o
    glides = kind_of(d, o[0]) == "sliding" and f.verb.lemma in _RIDES  # "rides a sled down"
    if kind_of(d, o[0]) not in SELF_POWERED and not glides:
        return s
    if f.subject is not None:
        d.refs.mounts[id(f.subject)] = o if len(s) == len(o) else o[:1]
    if f.verb.lemma in _RIDES and len(s) == len(o):  # "two people ride bicycles": one each
        for rider, mount in zip(s, o, strict=True):
            place(d, [rider], [mount], "on")
        return o
    at_the_wheel(d, s, o[0])
    return o[:1]


def _ridden(d: Discourse, f: Frame, s: list[str], o: list[str]) -> list[str]:
    """ "A frog riding on the back of a turtle", "in a boat": what goes, with who is on it."""
    on = f.phrase("on", "upon", "in") if f.verb.lemma == "ride" and s and not o else None
    mounts = [i for i in things(on) if kind_of(d, i) in SELF_POWERED - {"person"}]
    if not mounts or mounts[0] in s or not (kind_of(d, s[0]) in LIMBED or _toy_rides(d, f, s)):
        return []
    place(d, s, mounts[:1], "on")
    if f.subject is not None:
        d.refs.mounts[id(f.subject)] = mounts[:1]
    return mounts[:1]


def _toy_rides(d: Discourse, f: Frame, s: list[str]) -> bool:
    """ "A teddy bear riding a skateboard": as somebody would."""
    return f.verb.lemma in _RIDES and kind_of(d, s[0]) == "toy"


def _hovers(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "A drone floats in the air": it holds its height, and goes nowhere unless it is said."""
    ways = [p for p in f.phrases if p.prep not in _STAYS_AT and things(p)]
    for actor in actors:
        d.moves.flying.add(actor)
        if ways or quantity_of(d, f, "speed") is not None:
            motion(d, f, [actor], None)
        else:
            hover(d, actor)
    mark_used(d, f, "hovering")


def _by_hand(d: Discourse, doer: str, thing: str) -> bool:
    """Whether somebody moves a thing that does not move by itself."""
    acts = kind_of(d, doer) in LIMBED or entity_of(d, doer).noun.name == "arm"
    return acts and movable(d, thing) and kind_of(d, thing) not in SELF_POWERED


@sense("approach")
def read_approach(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    motion(d, f, s, None)
    meet = len(s) == 2 and not o  # "two cars approach each other", "meet in a street"
    for actor, other in zip(s, reversed(s) if meet else [*o[:1]] * len(s), strict=False):
        d.moves.aim[actor] = other
        track = d.timeline.tracks.get(actor)
        if track is not None and track.motion is not None:
            track.motion.target = other


@sense("follow")
def read_follow(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "follows it at a distance of 15 m": behind it, which moves, too."""
    s, o = doer_and_done(f, s, o)
    motion(d, f, s, None)
    o = o or _ahead(d, f, s)
    gap, at = quantity_of(d, f, "length"), f.phrase("at")
    same = at is not None and at.mention is not None and "same" in at.mention.adjectives
    for actor in s if o else []:
        d.moves.aim.setdefault(actor, o[0])
        if gap is not None and gap[0] == "at" and actor not in d.scene.travel:
            d.scene.relations.append(Relation(actor, o[0], "behind", gap[1].value))
            mark_used(d, gap[1], "distance")
        else:
            place(d, [actor], o, "behind")
        for other in [i for i in o if i == o[0] or movable(d, i)]:
            track = d.timeline.tracks.get(other)  # "chases two cats": both run
            if track is None or (track.motion is not None and same):
                start_motion(d, f, [other])
            _keep_pace(d, actor, other)


def _ahead(d: Discourse, f: Frame, s: list[str]) -> list[str]:
    """ "A hen crosses a road, chicks following": whom the clause before is about."""
    alive = all(kind_of(d, i) in SELF_POWERED for i in s)
    if f.verb.passive or f.verb.lemma not in _FOLLOWS or not alive:
        return []
    if f.phrases:
        return things(f.phrase("behind"))[:1]
    earlier = [c for c in d.scene.clauses if c.frame.verb.start < f.verb.start]
    movers = [i for c in earlier[-1:] for i in c.movers if movable(d, i)]
    return movers[:1] if not {*movers} & {*s} else []


def _keep_pace(d: Discourse, actor: str, other: str) -> None:
    """Who follows goes as fast as who is followed: at speeds that both may have."""
    tracks = [d.timeline.tracks.get(i) for i in (actor, other)]
    moving = [t.motion for t in tracks if t is not None and t.motion is not None]
    speeds = [m.speed for m in moving if isinstance(m.speed, tuple) and not m.prescribed]
    if len(speeds) == 2:
        low, high = max(low for low, _ in speeds), min(high for _, high in speeds)
        for m in moving if low < high else ():
            m.speed = (low, high)


@sense("coast")
@sense("continue")
@sense("cross")
def read_goes_on(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    motion(d, f, s, None)


@sense("leave")
def read_leave(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    flung = bool(s) and kind_of(d, s[0]) in STRUCK | {"sliding", "rock"}
    if flung and not moved_by_others(d, s[0]) and quantity_of(d, f, "angle") is not None:
        motion_of_things(d, f, s, "throw")  # "leaves the boot at an angle of 30 degrees"
    else:
        motion(d, f, s, None)


def _pushes(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    """ "hits a bale, rolling it into a fence": the object is moved by the hit."""
    if not s or not o or kind_of(d, s[0]) == "person" or s[0] == o[0] or not movable(d, o[0]):
        return False
    if kind_of(d, s[0]) == "animal" and not f.reduced:
        return False
    read_knock(d, f, s, o)
    mark_used(d, f, "consequence of the collision")
    return True


@sense("roll")
def read_roll(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.object is not None and f.object.pronoun in ("itself", "himself", "herself"):
        mark_used(d, f, "no motion of the whole")  # "rolls itself into a ball"
        return
    if _pushes(d, f, s, o):
        return
    actors = o if o and (not s or kind_of(d, s[0]) in LIVING) else s
    d.moves.rolling.update(actors)
    if s and actors == o:
        stand_by(d, s, o)
    if f.subject is not None and actors == o:
        d.refs.thrown[id(f.subject)] = list(o)
    if actors and not o and kind_of(d, actors[0]) in SELF_POWERED and not _sent_off(d, f, actors):
        motion(d, f, actors, "own")
        return
    slides = f.verb.sense == "slide" and actors and "round" not in traits_of(d, actors[0])
    motion(d, f, actors, "slide" if slides else "roll")
    if f.verb.passive or actors == o:
        aim = next((t for t in target_of(d, f, actors) if aimable(d, t)), None)
        aim_at(d, f, representatives(d, actors, []), aim)


@sense("slide")
def read_slide(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    soars = s and (kind_of(d, s[0]) == "projectile" or _all_fly(d, s))
    if f.verb.lemma == "glide" and soars:
        f.verb.sense = "fly"  # "a paper plane glides", "a gull glides over a lake"
        read_fly(d, f, s, o)
        return
    if _pushes(d, f, s, o):
        return
    actors = o if o and (not s or kind_of(d, s[0]) == "person") else s
    if s and actors == o:
        stand_by(d, s, o)
    d.moves.rolling.update(actors)
    kind = kind_of(d, actors[0]) if actors else ""
    glides = f.verb.lemma == "glide" and kind == "person"  # a skater glides along
    driven = kind in SELF_POWERED - {"person", "cart"} and not _sent_off(d, f, actors)
    motion(d, f, actors, "own" if not o and (glides or driven) else "slide")


def _sent_off(d: Discourse, f: Frame, actors: list[str]) -> bool:
    """Whether a hit makes it roll or slide: what only drives or walks by itself."""
    if {"away", "off", "on"} & set(f.adverbs) and not f.phrases:
        return False
    return all(moved_by_others(d, a) and kind_of(d, a) != "robot" for a in actors)


@sense("fly")
def read_fly(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if not o and thrown_up(d, f, s):
        return
    if s and o and not f.verb.passive and kind_of(d, s[0]) in LIMBED:
        place(d, s, o, "near")  # "a boy flies a kite": the kite does
        _hovers(d, f, o)
    elif s and flies_itself(d, s[0]):
        motion(d, f, s, "own")
    elif quantity_of(d, f, "angle") is not None and s and not moved_by_others(d, s[0]):
        motion_of_things(d, f, s, "throw")  # "flies off at an angle of 40 degrees"
    else:
        motion(d, f, s, "throw")


@sense("bounce")
def read_bounce(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "bounces off a wall into a bucket": off the first thing, then what the rest names.

    Who bounces a ball off it does not.
    """
    sent = [i for i in o if movable(d, i) and kind_of(d, i) not in LIMBED]
    if sent and not f.verb.passive and all(kind_of(d, i) in LIMBED for i in s):
        place(d, s, sent[:1], "near")
        s = sent
    p = f.phrase("off", "against", "on", "from", "into", "onto")
    named = p is None or (p.mention is not None and not p.mention.attribute)
    if named and d.moves.last_hit is None and bounces_on_ground(d, f, s, things(p)):
        return
    kinematics(d, f, s, [])
    for actor in s:
        _rebound(d, f, actor, p)
    for q in f.phrases:
        if q is not p and q.prep in ("off", "against"):
            others = [i for i in things(q) if i not in s and not structural(d, i)]
            add_hit(d, f, s, others[:1])
    into = f.phrase("into")
    if into is not None and into is not p and things(into):
        for actor in s:
            go_into(d, f, actor, things(into), into, None)


def _rebound(d: Discourse, f: Frame, actor: str, p: Phrase | None) -> None:
    """What it bounces off: what the phrase names, else what it was aimed at, else the ground."""
    met = things(p)
    aimed = d.moves.aim.get(actor)
    if p is not None and p.mention is not None and p.mention.attribute:
        ensure_mover(d, f, actor, None)
        if p.mention.head in ("cushion", "rail"):
            d.scene.needs.append(("billiard_table", actor))
    elif met and p is not None and not structural(d, met[0]):
        if {*(d.moves.last_hit or ())} == {actor, met[0]} and p.prep in ("off", "from"):
            mark_used(d, f, "rebound of the collision")
        elif p.prep == "into" and _takes_up(d, actor, met[0]):
            if aimed is not None and aimed != met[0] and moves(d, actor):
                add_hit(d, f, [actor], [aimed])  # "is thrown at a wall and bounces into a bucket"
            go_into(d, f, actor, met, p, time_of(d, f))
        else:
            add_hit(d, f, [actor], met[:1], time_of(d, f))
        return
    elif not met and aimed is not None and moves(d, actor):
        add_hit(d, f, [actor], [aimed], time_of(d, f))
    elif actor not in d.timeline.tracks:
        start_motion(d, f, [actor], "drop")
    mark_used(d, f, "rebound")


def _takes_up(d: Discourse, actor: str, host: str) -> bool:
    """Whether a bounce leads into something: a goal always, over a rim out of the air."""
    over = is_airborne(d, actor) or bounces_over(d, actor, host)
    return enterable(d, host) or (over and holds(d, host))


@sense("reach")
def read_reach(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    targets = o or hit_targets(f, s, [])
    for actor in s:
        lines = [t for t in targets if entity_of(d, t).noun.name == "finish line"]
        told = [t for t in targets if t != actor and not structural(d, t)]
        target = next(iter(told or lines), None)
        if target is None and f.verb.lemma in ("get", "arrive"):
            target = d.moves.aim.get(actor)  # "runs to the swing and gets there first"
        if target is None or target == actor:
            motion(d, f, [actor], None)
        else:
            ensure_mover(d, f, actor, target)
            add_event(d, NodeEvent.REACH, (actor, target), f, time_of(d, f))


@sense("end")
def read_end(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "ends in the pond", "ends up on the floor": where it comes to be."""
    p = f.phrase("in", "into", "inside", "on", "onto", "against")
    if p is None or not things(p):
        return
    end = things(p)[0]
    for actor in [a for a in s if a != end and movable(d, a)]:
        inner = p.prep in ("in", "into", "inside")
        if structural(d, end):
            if p.prep in ("on", "onto") and actor in d.scene.supported_by:
                add_event(d, NodeEvent.FALL, (actor,), f, time_of(d, f))
            mark_used(d, f, "end of the motion")
        elif inner and (holds(d, end) or enterable(d, end)):
            enter(d, f, actor, end, time_of(d, f))
        else:
            add_hit(d, f, [actor], [end], time_of(d, f))


@sense("swing_round")
def read_swing_round(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    into = filling(f, "obstacle")
    target = hit_targets(f, s, o)
    if o and into:
        add_hit(d, f, o[:1], into[:1], time_of(d, f))  # "a crane swings a beam into a scaffold"
    elif f.phrase("at", "into", "against") is not None and target and s:
        add_hit(d, f, s[:1], target, time_of(d, f))
    else:
        motion(d, f, s, None)
