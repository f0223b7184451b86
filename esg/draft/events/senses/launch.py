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
    structural,
)
from esg.draft.discourse.links import can_tow, is_link, tow
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.scene import LIVING, SELF_POWERED
from esg.draft.events.acts import add_event, add_hit, go_into, kinematics, outcomes
from esg.draft.events.consequences import already_hit, consequence, knock_on
from esg.draft.events.hanging import hanging, sent_up, thrown_up, turning
from esg.draft.events.lengths import distance
from esg.draft.events.motions import each_passed, motion, start_motion, target_of
from esg.draft.events.roles import doer_and_done
from esg.draft.events.table import sense
from esg.draft.events.timing import (
    enterable,
    moved_by_others,
    representatives,
    start_height,
    time_of,
)
from esg.draft.events.told import amount, ignore, moves, recent, size_of, things, traits_of
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent

_KICKING = frozenset({"kick", "punt", "boot", "sidefoot"})
_BY_HAND = lex.word_set("by hand")
_THROWN = lex.word_set("thrown")
_GUNS = lex.word_set("guns")
_SHOTS = lex.word_set("shots")
_PLAYTHING_CM = 30.0
_MOUNTED = frozenset({"rider", "jockey"})


@sense("launch")
def read_launch(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Throws, kicks, shoots, pushes: an agent sends things off."""
    agents, sent = (s, o) if o else ([], s)
    if f.verb.passive:
        agents, sent = doer_and_done(f, s, o)
    elif not o:
        told = _shot_by(d, s) if f.verb.lemma in ("fire", "shoot") else []
        told = told or _at_hand(d, f, s)
        agents, sent = (s, told) if told else (agents, sent)
    if not agents and thrown_up(d, f, sent):
        return
    if not _throws_off(d, f, s, o or sent):
        launch_by(d, f, agents, sent)


def _throws_off(d: Discourse, f: Frame, s: list[str], sent: list[str]) -> bool:
    """ "The horse throws its rider", "tips over, throwing out a crate": who is on it falls."""
    off = f.phrase("off", "out")
    if f.verb.passive or len(s) != 1 or any(p is not off for p in f.phrases):
        return False
    out = off is not None and off.prep == "out" and f.object is None
    thrown = things(off) if off is not None and f.object is None else sent
    kind, riders = kind_of(d, s[0]), all(kind_of(d, i) == "person" for i in thrown)
    ridden = kind in SELF_POWERED - {"person", "robot"} and riders
    if not thrown or not (ridden or (out and kind != "person")):
        return False
    for body in thrown:
        add_event(d, NodeEvent.FALL, (body,), f, time_of(d, f))
    return True


def _shot_by(d: Discourse, agents: list[str]) -> list[str]:
    """ "A cannon fires at the gate": a ball, which the prompt may name afterwards."""
    if len(agents) != 1 or entity_of(d, agents[0]).noun.name not in _GUNS:
        return []
    shots = [i for i, e in d.world.entities.items() if e.noun.kind in _SHOTS]
    if shots:
        return shots[:1]
    noun = lex.nouns()["cannonball"]
    return [add_entity(d.world, noun, noun.name, label=noun.name, mentioned=False).id]


def _at_hand(d: Discourse, f: Frame, agents: list[str]) -> list[str]:
    """ "He shoots again": the ball or stone that was spoken of last."""
    people = bool(agents) and all(kind_of(d, x) == "person" for x in agents)
    if not people or f.verb.lemma in ("push", "shove"):
        return []
    return [i for i in recent(d) if i not in agents and kind_of(d, i) in _THROWN][:1]


@sense("pass")
def read_pass(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """A person passes a ball on; a vehicle passes another one, or just passes."""
    kind = kind_of(d, s[0]) if s else ""
    ball = bool(o) and kind_of(d, o[0]) in ("ball", "billiard", "sliding", "projectile")
    around = _passed_by(d, f, s) if not o else []
    each_other = len(s) > 1 and set(o) <= set(s) and not around
    by = bool(s) and (kind in SELF_POWERED or (bool(o) and not f.verb.passive))
    if not by or (kind == "person" and (ball or not (o or around)) and not each_other):
        read_launch(d, f, s, o)
        return
    if each_other and kind in SELF_POWERED:
        start_motion(d, f, s[:2])
        add_event(d, NodeEvent.MISS, (s[0], s[1]), f, time_of(d, f), stem="passes")
        return
    start_motion(d, f, s)
    several = s if not o else s[:1]  # "waits until two cyclists have passed"
    o = [x for x in o or around if x != s[0] and not structural(d, x)]
    for other in each_passed(f, o):
        if other == o[0] and d.moves.aim.get(other) != s[0]:  # not who comes toward it
            place(d, s, [other], "behind")
        for one in several:
            add_event(d, NodeEvent.MISS, (one, other), f, time_of(d, f), stem="passes")
    mark_used(d, f, "passing")


def _passed_by(d: Discourse, f: Frame, s: list[str]) -> list[str]:
    """ "A shelf shakes as a truck passes": what the clause around it is about."""
    around = f.main.subject if f.main is not None else None
    if around is None or f.subordinate not in ("as", "when", "while", "until"):
        return []
    return [i for i in around.entities if i not in s and aimable(d, i)][:1]


@sense("tow")
def read_tow(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Pulling: a person moves the thing; a vehicle drives with the thing behind it."""
    s, o = doer_and_done(f, s, o)
    aboard = [d.scene.supported_by.get(i) or d.scene.inside_of.get(i, "") for i in o[:1]]
    if aboard and kind_of(d, o[0]) in LIVING and can_tow(d, f, s, [i for i in aboard if i]):
        o = aboard  # "pulls a child in a wagon": the wagon
    if not o:
        motion(d, f, s, None)  # "pulls out of a driveway"
    elif can_tow(d, f, s, o):
        tow(d, f, s, o)
        _go_with(d, f, s, o)
    elif not s or kind_of(d, s[0]) == "person":
        launch_by(d, f, s, o)
    else:
        place(d, o, s, "behind")
        _go_with(d, f, s, o)


def _go_with(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Goes where the clause says, and takes what it draws there."""
    into = f.phrase("into", "against", "over")
    ways = [p for p in f.phrases if p.prep not in ("into", "against", "off", "from")]
    ways = [p for p in ways if not any(is_link(d.scene, i) for i in things(p))]
    motion(d, replace(f, phrases=ways), s, None)
    met = [i for i in things(into) if i not in s + o][:1]
    if into is not None and into.prep != "over" and met:
        go_into(d, f, o[0], met, into, time_of(d, f))


def launch_by(d: Discourse, f: Frame, agents: list[str], sent: list[str]) -> None:
    """Sends things off: a body pushes them by a hit, a person throws or rolls them."""
    if not sent:
        motion(d, f, agents, None)
        return
    if sent_up(d, f, agents, sent):
        return
    mode = f.verb.note or "roll"
    hung = hanging(d, sent)
    held = hung or turning(d, sent)
    if held and agents and kind_of(d, agents[0]) in SELF_POWERED:
        add_hit(d, f, agents[:1], held[:1], time_of(d, f))  # "kicks a punching bag"
        event = NodeEvent.SWING if hung else NodeEvent.SPIN
        mark_used(d, f, add_event(d, event, (held[0],), f, None))
        return
    if f.verb.lemma == "blow":
        agents = []  # the air that a fan moves touches it, not the fan
    if f.verb.lemma in _KICKING:
        d.scene.kicked.update(sent)
    bodily = [a for a in agents if kind_of(d, a) != "person"]
    flung = f.verb.lemma == "kick" and "up" in f.adverbs  # "a pebble kicked up by a lorry"
    bumps = f.verb.sense == "launch" and mode in ("slide", "roll") and not flung
    pushed = f.verb.lemma in _BY_HAND and _stands_low(d, sent[0])
    if bodily and bumps:  # a robot, car or ball that pushes something hits it
        kinematics(d, f, bodily, sent)
        if not already_hit(d, f, bodily, sent):
            add_hit(d, f, bodily[:1], sent, time_of(d, f))
    elif agents and (pushed or (kind_of(d, sent[0]) == "person" and mode in ("slide", "roll"))):
        add_hit(d, f, agents[:1], sent[:1], time_of(d, f))  # one person pushes another
    else:
        stand_by(d, agents, sent)
        motion_of_things(d, f, sent, mode)
        return
    knock_on(d, f, sent)
    consequence(d, f, sent)


def stand_by(d: Discourse, agents: list[str], sent: list[str]) -> None:
    """Who sets a thing off without a hit stands beside it, and looks at it."""
    mounts = [a for a in agents if kind_of(d, a) == "animal"]
    if mounts and all(entity_of(d, i).head in _MOUNTED for i in sent):
        place(d, sent, mounts[:1], "on")  # "a horse throws its rider"
        return
    place(d, agents, sent, "near")
    look_at(d, agents, sent)


def look_at(d: Discourse, agents: list[str], sent: list[str]) -> None:
    """Who lets a thing go has it before his eyes, unless he is said to face something else."""
    for agent in [a for a in agents if a != sent[0]]:
        d.scene.facing.setdefault(agent, sent[0])


def _stands_low(d: Discourse, body: str) -> bool:
    """Whether a person can walk into it: it rests on the ground and is no plaything."""
    supported = body in d.scene.supported_by or body in d.scene.inside_of
    return movable(d, body) and not supported and max(size_of(d, body)) >= _PLAYTHING_CM


def motion_of_things(d: Discourse, f: Frame, bodies: list[str], mode: str) -> None:
    """Things set off as they are thrown, rolled or pushed."""
    aim = next((t for t in target_of(d, f, bodies) if aimable(d, t)), None)
    angle, over = amount(d, f, "angle"), f.phrase("over")
    over_it = over is not None and over.mention is not None and not over.mention.part
    if mode in ("roll", "slide") and (angle is not None or over_it):
        mode = "throw"
    if mode == "slide" and bodies and "round" in traits_of(d, bodies[0]):
        mode = "roll"
    moved = [t for t in representatives(d, bodies, []) if movable(d, t)]
    for t in [t for t in moved if not moved_by_others(d, t)]:
        start_motion(d, f, [t], mode, aim)
        if aim is not None:
            d.moves.aim[t] = aim
        flight = d.timeline.track(t).motion
        if angle is not None and flight is not None and mode in ("throw", "fly"):
            flight.params["elevation_deg"] = angle.value
            mark_used(d, angle, "launch angle")
    mark_used(d, f, "launch")
    heights(d, f, moved)
    distance(d, f, moved, aim)
    if f.subject is not None:
        d.refs.thrown[id(f.subject)] = moved
        kinds = ((i, kind_of(d, i)) for i in f.subject.entities)
        throwers = [i for i, k in kinds if k == "person" or k not in SELF_POWERED]  # a catapult
        d.refs.launched_by.update((i, moved) for i in throwers)
    if mode == "throw" and aim is None:
        _at_the_ground(d, f, moved)
    outcomes(d, f, moved)
    consequence(d, f, moved)
    aim_at(d, f, moved, aim)


def _at_the_ground(d: Discourse, f: Frame, moved: list[str]) -> None:
    """ "Is thrown towards the ground": down, and back up if it is a ball."""
    down = f.phrase("onto", "at", "against", "to", "toward", "towards", "on")
    met = [i for i in things(down) if structural(d, i)]
    for body in moved if met else []:
        track = d.timeline.track(body).motion
        if track is None or "round" not in traits_of(d, body):
            continue
        track.params["elevation_deg"] = (-80.0, -30.0)
        add_event(d, NodeEvent.BOUNCE, (body, met[0]), f, time_of(d, f))


def aim_at(d: Discourse, f: Frame, moved: list[str], aim: str | None) -> None:
    """ "throws a ball at a wall" ends at the wall, unless the prompt says otherwise later."""
    if aim is None or aim not in things(f.phrase("at")):
        return
    event = NodeEvent.ENTER_REGION if enterable(d, aim) else NodeEvent.COLLISION
    for t in [t for t in moved if moves(d, t)]:
        d.times.pending[t] = (event, f, aim, time_of(d, f))


def heights(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """ "from a height of 2 m", "falls 2 m", "3 m above the ground": where things start."""
    for p, a in amounts_of(d, f):
        before, after = d.text[: a.start].rstrip(), d.text[a.end : a.end + 7].strip()
        if a.dimension != "length" or before.endswith("distance of"):
            continue  # "thrown from a distance of 3 m"
        falls = f.verb.sense in ("fall", "drop") and p == ""  # "falls 2 m onto a bucket"
        high = "height" in d.text[max(0, a.start - 25) : a.end + 12]
        high = high or after.startswith(("above", "high", "up"))
        high = (high and p in ("of", "at", "")) or p in ("from", "above")
        let_go = p == "at" and f.verb.lemma in ("release", "drop")
        if (falls or high or let_go) and not after.startswith(("away", "apart")):
            start_height(d, bodies, a)


@sense("lose")
def read_lose(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "The truck loses a tyre": it falls off."""
    lost = [x for x in o if movable(d, x) and x not in s and entity_of(d, x).known]
    if not lost or not s:
        ignore(d, f, "no physical meaning")
        return
    place(d, lost, s[:1], "on")
    for t in representatives(d, lost, s):
        add_event(d, NodeEvent.FALL, (t,), f, time_of(d, f))
