"""Verbs of launching: throw, kick, push, pass, tow, lose."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.discourse.core import (
    aimable,
    amounts_of,
    entity_of,
    kind_of,
    mark_used,
    movable,
    quantity_of,
)
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.events.acts import add_event, add_hit, go_into, kinematics, outcomes
from esg.draft.events.consequences import already_hit, consequence, knock_on
from esg.draft.events.lengths import distance
from esg.draft.events.motions import each_passed, motion, start_motion, target_of
from esg.draft.events.table import sense
from esg.draft.events.timing import (
    enterable,
    moved_by_others,
    representatives,
    start_height,
    time_of,
)
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent

_BY_HAND = lex.word_set("by hand")
_THROWN = lex.word_set("thrown")
_GUNS = lex.word_set("guns")
_SHOTS = lex.word_set("shots")


@sense("launch")
def read_launch(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if f.verb.passive:
        by = f.phrase("by")
        agents = by.mention.entities if by is not None and by.mention is not None else []
        things = s
    else:
        agents, things = (s, o) if o else ([], s)
        if not o and f.verb.lemma in ("fire", "shoot") and (shot := _shot_by(d, s)):
            agents, things = s, shot
        if not o and s and all(kind_of(d, x) == "person" for x in s):
            ball = _at_hand(d, s)
            if ball and f.verb.lemma not in ("push", "shove"):
                agents, things = s, [ball]  # "he shoots again"
    off, thrown = f.phrase("off", "out"), things
    if not o and off is not None and off.mention is not None:
        thrown = off.mention.entities  # "throws off the rider"
    elsewhere = any(p is not off for p in f.phrases)
    out = off is not None and off.prep == "out" and not o and len(s) == 1
    out = out and bool(thrown) and kind_of(d, s[0]) != "person"  # "tips over, throwing out ..."
    if not f.verb.passive and not elsewhere and (out or _throws_off(d, s, thrown)):
        for thing in thrown:
            add_event(d, NodeEvent.FALL, (thing,), f, time_of(d, f))
        return
    launch_by(d, f, agents, things)


def _throws_off(d: Discourse, agents: list[str], things: list[str]) -> bool:
    """ "The horse throws its rider": who rides comes down."""
    ridden = len(agents) == 1 and kind_of(d, agents[0]) in SELF_POWERED - {"person", "robot"}
    return ridden and bool(things) and all(kind_of(d, i) == "person" for i in things)


def _shot_by(d: Discourse, agents: list[str]) -> list[str]:
    """ "A cannon fires at the gate": a ball, which the prompt may name afterwards."""
    if len(agents) != 1 or entity_of(d, agents[0]).noun.name not in _GUNS:
        return []
    shots = [i for i, e in d.world.entities.items() if e.noun.kind in _SHOTS]
    if shots:
        return shots[:1]
    noun = lex.nouns()["cannonball"]
    return [add_entity(d.world, noun, noun.name, label=noun.name, mentioned=False).id]


def _at_hand(d: Discourse, agents: list[str]) -> str:
    """The ball or stone that was spoken of last."""
    for ids in reversed(d.world.salience):
        for i in ids:
            if i in d.world.entities and i not in agents and kind_of(d, i) in _THROWN:
                return i
    return ""


@sense("pass")
def read_pass(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A person passes a ball on; a vehicle passes another one, or just passes."""
    thing = bool(o) and kind_of(d, o[0]) in ("ball", "billiard", "sliding", "projectile")
    handed = bool(s) and kind_of(d, s[0]) == "person" and (thing or not o)
    by = bool(s) and (kind_of(d, s[0]) in SELF_POWERED or (bool(o) and not f.verb.passive))
    if len(s) > 1 and (not o or set(o) <= set(s)) and kind_of(d, s[0]) in SELF_POWERED:
        start_motion(d, f, [x for x in s[:2] if movable(d, x)])
        add_event(d, NodeEvent.MISS, (s[0], s[1]), f, time_of(d, f), stem="passes")
        return
    if s and by and not handed:
        start_motion(d, f, [x for x in s if movable(d, x)])
        o = o or _passed_by(d, f, s)
        o = [x for x in o if x != s[0]]
        for other in each_passed(f, o):
            if other == o[0]:
                place(d, s, [other], "behind")
            add_event(d, NodeEvent.MISS, (s[0], other), f, time_of(d, f), stem="passes")
        mark_used(d, f, "passing")
        return
    read_launch(d, f, s, o)


def _passed_by(d: Discourse, f: Frame, s: list[str]) -> list[str]:
    """ "A shelf shakes as a truck passes": what the clause around it is about."""
    around = f.main.subject if f.main is not None else None
    if around is None or f.subordinate not in ("as", "when", "while", "until"):
        return []
    return [i for i in around.entities if i not in s and aimable(d, i)][:1]


@sense("tow")
def read_tow(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Pulling: a person moves the thing; a vehicle drives with the thing behind it."""
    if f.verb.passive:
        by = f.phrase("by")
        s, o = (list(by.mention.entities) if by and by.mention else []), s
    if s and o and kind_of(d, s[0]) != "person":
        place(d, o, s, "behind")
        into = f.phrase("into", "against", "over")
        ways = [p for p in f.phrases if p.prep not in ("into", "against", "off", "from")]
        motion(d, replace(f, phrases=ways), s, None)
        if into is not None and into.mention is not None and into.prep != "over":
            for other in [i for i in into.mention.entities if i not in s + o][:1]:
                go_into(d, f, o[0], [other], into, time_of(d, f))
    elif not o:
        motion(d, f, s, None)  # "pulls out of a driveway"
    else:
        launch_by(d, f, s, o)


def launch_by(d: Discourse, f: Frame, agents: list[str], things: list[str]) -> None:
    if not things:
        motion(d, f, agents, None)
        return
    mode = f.verb.note or "roll"
    if f.verb.lemma == "blow":
        agents = []  # the air that a fan moves touches it, not the fan
    bodily = [a for a in agents if kind_of(d, a) != "person"]
    flung = f.verb.lemma == "kick" and "up" in f.adverbs  # "a pebble kicked up by a lorry"
    if bodily and not flung and f.verb.sense == "launch" and mode in ("slide", "roll"):
        # a robot, car or ball that pushes something hits it
        kinematics(d, f, bodily, things)
        if not already_hit(d, f, bodily, things):
            add_hit(d, f, bodily[:1], things, time_of(d, f))
        knock_on(d, f, things)
        consequence(d, f, things)
        return
    pushed = f.verb.lemma in _BY_HAND and _stands_low(d, things[0])
    if agents and (pushed or (kind_of(d, things[0]) == "person" and mode in ("slide", "roll"))):
        # one person pushes another: contact, not a throw
        add_hit(d, f, agents[:1], things[:1], time_of(d, f))
        knock_on(d, f, things)
        consequence(d, f, things)
        return
    if agents:
        place(d, agents, things, "near")
    for agent in agents:
        if agent != things[0]:
            d.scene.facing.setdefault(agent, things[0])
    motion_of_things(d, f, things, mode)


def _stands_low(d: Discourse, thing: str) -> bool:
    """Whether a person can walk into it: it rests on the ground and is no plaything."""
    supported = thing in d.scene.supported_by or thing in d.scene.inside_of
    small = max(entity_of(d, thing).dimensions_cm or entity_of(d, thing).noun.dimensions_cm) < 30.0
    return movable(d, thing) and not supported and not small


def motion_of_things(d: Discourse, f: Frame, things: list[str], mode: str) -> None:
    target = target_of(d, f, things)
    if quantity_of(d, f, "angle") is not None and mode in ("roll", "slide"):
        mode = "throw"
    over = f.phrase("over")
    if over is not None and over.mention is not None and not over.mention.part:
        mode = "throw" if mode in ("roll", "slide") else mode
    aim = next((t for t in target if aimable(d, t)), None)
    if mode == "slide" and things and "round" in entity_of(d, things[0]).noun.traits:
        mode = "roll"
    moved = [t for t in representatives(d, things, []) if movable(d, t)]
    for t in moved:
        if moved_by_others(d, t):
            continue
        start_motion(d, f, [t], mode, aim)
        if aim is not None:
            d.moves.aim[t] = aim
        angle = quantity_of(d, f, "angle")
        track = d.timeline.tracks.get(t)
        if (
            angle is not None
            and track is not None
            and track.motion is not None
            and mode in ("throw", "fly")
        ):
            track.motion.params["elevation_deg"] = angle[1].value
            mark_used(d, angle[1], "launch angle")
    mark_used(d, f, "launch")
    heights(d, f, moved)
    distance(d, f, moved, aim)
    for m in [f.subject] if f.subject is not None else []:
        d.refs.thrown[id(m)] = moved
        d.refs.launched_by.update((i, moved) for i in m.entities if kind_of(d, i) == "person")
    outcomes(d, f, moved)
    consequence(d, f, moved)
    aim_at(d, f, moved, aim)


def aim_at(d: Discourse, f: Frame, moved: list[str], aim: str | None) -> None:
    """ "throws a ball at a wall" ends at the wall, unless the prompt says otherwise later."""
    p = f.phrase("at")
    if p is None or aim is None or p.mention is None or aim not in p.mention.entities:
        return
    for t in moved:
        track = d.timeline.tracks.get(t)
        if track is not None and track.motion is not None and not track.closed:
            goal = enterable(d, aim)
            event = NodeEvent.ENTER_REGION if goal else NodeEvent.COLLISION
            d.times.pending[t] = (event, f, aim, time_of(d, f))


def heights(d: Discourse, f: Frame, things: list[str]) -> None:
    for p, a in amounts_of(d, f):
        if d.text[a.end : a.end + 6].strip().startswith(("away", "apart")):
            continue
        if d.text[max(0, a.start - 14) : a.start].rstrip().endswith("distance of"):
            continue  # "thrown from a distance of 3 m"
        drop = f.verb.sense in ("fall", "drop") and p == ""
        if a.dimension == "length" and drop:
            start_height(d, things, a)  # "falls 2 m onto a bucket"
            continue
        if a.dimension == "length" and (
            p in ("from", "at", "of", "above", "")
            and (
                "height" in d.text[max(0, a.start - 25) : a.end + 12]
                or p in ("from", "above")
                or (p == "at" and f.verb.lemma in ("release", "drop"))
                or d.text[a.end : a.end + 7].strip().startswith(("above", "high", "up"))
            )
        ):
            start_height(d, things, a)


@sense("lose")
def read_lose(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "The truck loses a tyre": it falls off."""
    things = [x for x in o if movable(d, x) and x not in s and entity_of(d, x).known]
    if not things or not s:
        d.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"
        return
    place(d, things, s[:1], "on")
    for t in representatives(d, things, s):
        add_event(d, NodeEvent.FALL, (t,), f, time_of(d, f))
