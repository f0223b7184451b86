"""What moves about on a table, a shelf or a roof: who is on it, and how fast it may go there."""

from __future__ import annotations

from collections.abc import Iterator
import math

from esg.draft.discourse.core import entity_of, kind_of, movable, structural
from esg.draft.discourse.decks import is_deck
from esg.draft.discourse.places import carries, elevated, fits_on, place, raised
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND, LIMBED, LIVING, SELF_POWERED, SPEEDS
from esg.draft.events.ends import EDGES
from esg.draft.events.gaits import gaits
from esg.draft.events.motions import flies_itself
from esg.draft.events.timing import PUSHING
from esg.draft.events.told import at_rest, size_of, things
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import EdgeEvent, NodeEvent, Quantity
from esg.graph.rules_segments import LEAST_SPEED_CM_S
from esg.units import GRAVITY_MPS2

_MOTIONS = frozenset(
    {"own", "roll", "slide", "coast", "continue", "cross", "pass", "overtake", "approach"}
)
"""Senses of moving about."""
_PAST = frozenset({"past", "by", "around", "round", "between", "alongside"})
_TOWARD = frozenset({"toward", "towards", "to", "up to"})
_BESIDE = frozenset({"in front of", "next to", "beside", "near", "before", "behind"})
_OVER = frozenset({"over", "across", "along"})
_LEAVING = frozenset({"off", "from", "out of", "down", "onto", "into", "under", "through"})
"""Prepositions of ways that begin or end elsewhere than beside what they are about."""
_STANDS = frozenset({"on", "upon", "atop", "on top of"})
_BEDS = frozenset({"cart", "sliding"})
"""Kinds of low platforms on which something slides about."""
_CARRYING = frozenset({"cart", "vehicle", "building", "wall"})
"""Kinds of other things on whose top something may go about."""
_SMALL_CM = 35.0
"""Longest side of an animal that goes to a thing on a table on the table."""
_STAYING = frozenset(
    {NodeEvent.MISS, NodeEvent.REACH, NodeEvent.STOP, NodeEvent.TRIGGER, NodeEvent.SPIN}
    | {NodeEvent.HEADING_REACHED, NodeEvent.TOPPLE, NodeEvent.COLLISION}
)
"""Events after which something is where it was, on what carried it."""
_ALOFT = frozenset({"throw", "fly", "drop"})
_ABOUT_S = 2.5
"""How long what moves about on something shall need for half of its length [s]."""
_SEEN_CM_S = 30.0
"""Speed at which what moves by itself is surely seen to."""
_GAIT = 1.2
"""Least of the speeds that a gait leaves, over the slowest that it has."""
_RUBS, _ROOM = 0.4, 0.4
"""Usual friction of what slides along a table, and the share of that which it slides at most."""


def stays_up(d: Discourse, mover: str) -> str | None:
    """The table or shelf that a mover starts on and is not told to leave; None without one."""
    host = d.scene.supported_by.get(mover)
    if host is None or host not in d.world.entities or structural(d, host):
        return None
    if entity_of(d, host).noun.name == "billiard table":
        return None  # cushions keep it on
    track = d.timeline.tracks.get(mover)
    aloft = track is not None and track.motion is not None and track.motion.mode in _ALOFT
    flown = (e for e in d.timeline.edges if e.actor == mover and e.params.elevation_deg is not None)
    if aloft or any(flown):
        return None  # "throws a ball across a table"
    if host in d.timeline.tracks and not at_rest(d, host):
        return None
    on_a_bed = kind_of(d, host) in _CARRYING and kind_of(d, mover) not in LIMBED
    if not elevated(d, host) and not (on_a_bed and d.moves.on_top.get(mover) == host):
        return None
    if "incline" in entity_of(d, host).noun.traits:
        return None
    met = [n for n in d.timeline.nodes if mover in n.participants]
    fallen = {n.participants[0] for n in d.timeline.nodes if n.event is NodeEvent.FALL}
    hosts = d.scene.supported_by
    for n in met:
        others = [i for i in n.participants if i != mover]
        if n.event not in _STAYING or any(hosts.get(i) != host and i != host for i in others):
            return None
        if fallen.intersection(others):
            return None  # what knocks something off may well follow it
    return host


def movers_on_top(d: Discourse) -> Iterator[tuple[str, str]]:
    """Who moves about on what, without leaving it."""
    going = [e.actor for e in d.timeline.edges if e.event is not EdgeEvent.INERTIAL_CONNECTOR]
    going += [a for a, t in d.timeline.tracks.items() if t.motion is not None]
    for mover in dict.fromkeys(going):
        host = stays_up(d, mover) if mover in d.world.entities else None
        if host is not None:
            yield mover, host


def join_on_top(d: Discourse, f: Frame) -> None:
    """Puts on a table what moves past a thing on it, and what moves over or is pushed across it.

    "A toy car drives past a vase on a table": it is on the table, too.
    """
    movers, pushed = _movers(d, f)
    movers = [a for a in movers if _is_free(d, a)]
    if not movers or f.unreal or f.verb.negated:
        return
    if any(p.prep in _LEAVING or (p.prep in _STANDS and not pushed) for p in f.phrases):
        return
    if any(p.prep in _OVER | _STANDS | {"in", "down"} and _is_floor(d, p) for p in f.phrases):
        return
    over = next((p for p in f.phrases if p.prep in _OVER and _crossed(d, f, p, movers)), None)
    if over is not None:
        place(d, movers, things(over), "on")
        d.moves.on_top.update((a, things(over)[0]) for a in movers)
        return
    if pushed:
        return
    host = _whose_edge(d, f, movers) or _host_of_landmarks(d, f, movers)
    if host is not None and all(fits_on(d, a, host) or _broad(d, host) for a in movers):
        place(d, movers, [host], "on")
        d.moves.on_top.update((a, host) for a in movers)


def _is_floor(d: Discourse, p: Phrase) -> bool:
    """Whether a phrase names the ground, or what lies on it: "rolls across the floor"."""
    named = [i for i in things(p) if i == GROUND or i in d.world.entities]
    return bool(named) and all(i == GROUND or structural(d, i) for i in named)


def _movers(d: Discourse, f: Frame) -> tuple[list[str], bool]:
    """Whom a clause moves, and whether something pushes them."""
    s = list(f.subject.entities) if f.subject is not None else []
    o = list(f.object.entities) if f.object is not None else []
    if f.verb.lemma in PUSHING and s and o and not f.verb.passive:
        return o, True
    if f.verb.sense not in _MOTIONS:
        return [], False
    sent = f.verb.sense in ("roll", "slide") and o and (not s or kind_of(d, s[0]) in LIVING)
    return (o if sent else s), False


def _is_free(d: Discourse, actor: str) -> bool:
    """Whether something has no place so far from which it could not go about on a table."""
    scene = d.scene
    if actor not in d.world.entities or not movable(d, actor) or not at_rest(d, actor):
        return False
    held = (scene.supported_by, scene.inside_of, scene.attached, scene.marked)
    return not any(actor in places for places in held)


def _crossed(d: Discourse, f: Frame, p: Phrase, movers: list[str]) -> bool:
    """Whether a phrase tells of a top that what moves goes over: "crawls over the table"."""
    hosts = [h for h in things(p) if h in d.world.entities and not structural(d, h)]
    if len(hosts) != 1 or hosts[0] in movers or (p.mention is not None and p.mention.part):
        return False
    host = hosts[0]
    flies = any(flies_itself(d, a) for a in movers) and f.verb.lemma not in gaits()
    if flies or any(kind_of(d, a) == "person" for a in movers):
        return False
    if kind_of(d, host) in _BEDS and f.verb.sense in ("roll", "slide") and p.prep != "along":
        return all(carries(d, host, a) for a in movers)
    return raised(d, host) and all(fits_on(d, a, host) for a in movers)


def _whose_edge(d: Discourse, f: Frame, movers: list[str]) -> str | None:
    """What carries those that go to its edge: "rolls to the edge of a stage and stops"."""
    for p in f.phrases:
        hosts = [h for h in things(p) if h in d.world.entities and h not in movers]
        part = p.mention.part if p.mention is not None else ""
        if part in EDGES and p.prep in _TOWARD and len(hosts) == 1 and elevated(d, hosts[0]):
            return hosts[0]
    return None


def _broad(d: Discourse, host: str) -> bool:
    """Whether a thing is as large as what goes about on it asks for: a stage, a pier."""
    return is_deck(entity_of(d, host))


def _host_of_landmarks(d: Discourse, f: Frame, movers: list[str]) -> str | None:
    """What carries everything that a clause has its movers pass, go round or go to."""
    named = [i for p in f.phrases if p.prep in _PAST for i in things(p)]
    if f.verb.sense in ("pass", "overtake") and f.object is not None:
        named += f.object.entities
    if all(kind_of(d, a) not in LIVING or max(size_of(d, a)) <= _SMALL_CM for a in movers):
        named += [i for p in f.phrases if p.prep in _TOWARD for i in things(p)]
    named = [i for i in named if i in d.world.entities and i not in movers]
    if f.verb.passive or not named or any(flies_itself(d, a) for a in movers):
        return None
    hosts = {_stands_on(d, i) for i in named}
    host = hosts.pop() if len(hosts) == 1 else None
    return host if host is not None and host not in movers and raised(d, host) else None


def _stands_on(d: Discourse, thing: str) -> str | None:
    """What carries a thing by what is told of it, in a later clause if need be."""
    host = d.scene.supported_by.get(thing)
    if host is None:
        for f in d.told:
            stands = f.verb.sense in ("posture", "be") and not (f.unreal or f.verb.negated)
            if stands and f.subject is not None and thing in f.subject.entities:
                host = next((h for p in f.phrases if p.prep in _STANDS for h in things(p)), None)
                if host is not None:
                    break
    return host if host in d.world.entities and not structural(d, host or "") else None


def share_their_top(d: Discourse) -> None:
    """Puts on a table what something that stays on it goes past, round or toward.

    "A toy boat slides along a shelf past a globe": the globe is on the shelf.
    """
    for mover in [*d.timeline.tracks]:
        host = d.scene.supported_by.get(mover) if mover in d.world.entities else None
        if host is None or host not in d.world.entities or not _is_top(d, host):
            continue
        met = [n for n in d.timeline.nodes if mover in n.participants]
        if any(n.event not in _STAYING for n in met):
            continue
        for i in _landmarks(d, mover):
            if i != host and _is_free(d, i) and fits_on(d, i, host) and not _on_the_floor(d, i):
                place(d, [i], [host], "on")


def _is_top(d: Discourse, host: str) -> bool:
    slopes = "incline" in entity_of(d, host).noun.traits
    flat = not structural(d, host) and elevated(d, host) and not slopes
    return flat and host not in d.timeline.tracks


def _on_the_floor(d: Discourse, thing: str) -> bool:
    """Whether a thing is told to be on the ground."""
    return any(r.source == thing and r.kind == "structural" for r in d.scene.relations)


def _landmarks(d: Discourse, mover: str) -> Iterator[str]:
    """What the clauses that move something tell of it in their phrases, plurals whole."""
    passed = (n for n in d.timeline.nodes if n.event in (NodeEvent.MISS, NodeEvent.REACH))
    for n in passed:
        if n.participants[0] == mover:
            for i in n.participants[1:]:
                group = d.world.entities[i].group if i in d.world.entities else None
                yield from d.world.groups.get(group or "", [i])
    for f in d.told:
        if f.subject is None or mover not in f.subject.entities or f.unreal or f.verb.negated:
            continue
        if f.verb.sense in _MOTIONS | {"stop", "brake"}:
            beside = (p for p in f.phrases if p.prep in _PAST | _TOWARD | _BESIDE)
            yield from (i for p in beside for i in things(p) if i != GROUND)


def keep_on(d: Discourse) -> None:
    """Sets speeds at which what moves about on a table or board does not get to its edge."""
    hit = {i for n in d.timeline.nodes if n.event is NodeEvent.COLLISION for i in n.participants}
    for actor, host in [*movers_on_top(d)]:
        if is_deck(entity_of(d, host)) or actor in hit:
            continue
        motion = d.timeline.track(actor).motion
        if motion is not None and not motion.prescribed:
            slides = motion.mode == "slide"
            motion.speed = _slow_enough(d, actor, host, motion.speed, slides=slides)
        for k, e in enumerate(d.timeline.edges):
            flies = e.params.elevation_deg is not None
            if e.actor == actor and not (e.speed_is_prescribed or flies):
                slides = e.params.spin == "slide"
                speed = _slow_enough(d, actor, host, e.params.speed, slides=slides)
                params = e.params.model_copy(update={"speed": speed})
                d.timeline.edges[k] = e.model_copy(update={"params": params})


def _slow_enough(
    d: Discourse, actor: str, host: str, speed: Quantity | None, *, slides: bool
) -> Quantity | None:
    """A range of speeds [cm/s] as it is, or lower where it would lead off what carries."""
    if not isinstance(speed, tuple):
        return speed
    length = max(size_of(d, host)[:2])
    alone = kind_of(d, actor) in SELF_POWERED
    kind = kind_of(d, actor)
    afoot = kind in LIVING and speed != SPEEDS.get(kind)  # whose gait has its speeds
    if slides:
        most = 100.0 * math.sqrt(2.0 * _RUBS * GRAVITY_MPS2 * 0.01 * _ROOM * length)
    else:
        # What starts at one end stops before the other; what rolls off to nowhere has half.
        least = _SEEN_CM_S if alone else LEAST_SPEED_CM_S
        met = (n for n in d.timeline.nodes if actor in n.participants)
        passes = any(n.event is NodeEvent.MISS for n in met)
        most = max(length * (1.0 if alone or passes else 0.5) / _ABOUT_S, least)
    most = max(most, _GAIT * speed[0]) if afoot else most
    if most >= speed[1]:
        return speed
    least = speed[0] if afoot else min(speed[0], 0.5 * most)
    return (round(least, 4), round(most, 4))
