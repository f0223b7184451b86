"""Verbs of falling: drop, fall, land."""

from __future__ import annotations

from functools import partial
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
from esg.draft.discourse.places import elevated, place, set_free
from esg.draft.discourse.record import Discourse
from esg.draft.events.acts import add_event, add_hit, goes_in
from esg.draft.events.consequences import struck_before
from esg.draft.events.edges import off_the_edge
from esg.draft.events.landings import landing_of
from esg.draft.events.motions import motion, natural, on_what_was_hit, start_motion
from esg.draft.events.senses.launch import heights, motion_of_things
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import (
    enterable,
    is_airborne,
    moved_by_others,
    representatives,
    time_of,
)
from esg.draft.events.told import recent
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

_UPRIGHT = lex.word_set("upright")
_OVERTURNED = lex.word_set("overturned")
_TWO_WHEELED = lex.word_set("two wheeled")
_SOURCES = ("off", "from", "out of", "over", "down")
_OTHER_SIDE = re.compile(r"\s+(?:down\s+)?on\s+(?:the|its)\s+(?:other|far)\s+side", re.IGNORECASE)
_HANGING = frozenset({"chandelier"})
STANDING_CM = 60.0
"""A thing that is this tall stands on the ground."""


@sense("drop")
def read_drop(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if not f.verb.passive and not o and f.object is not None and f.object.attribute:
        d.scene.ignored[(f.verb.start, f.verb.end)] = "nothing is let go"
        return  # "releases the brakes"
    beyond = "over" in f.adverbs or f.phrase("behind", "beyond", "over", "past") is not None
    beyond = beyond or _OTHER_SIDE.match(d.text, f.verb.end) is not None
    under_way = bool(s) and all(i in d.timeline.tracks or i in d.moves.stated for i in s)
    if beyond and under_way and not (o or f.verb.passive or s[0] in d.scene.supported_by):
        mark_used(d, f, "end of the flight")  # "clips the net and drops over"
        return
    things = s if f.verb.passive or not o else o
    agents = [x for x in s if x not in things]
    if agents:
        place(d, agents, things, "near")
    wheeled = bool(things) and kind_of(d, things[0]) in ("cart", "vehicle")
    if f.verb.lemma == "let" and wheeled and not _raised(d, things[0]):
        motion(d, f, things, None)  # "lets go of a cart"
        return
    if quantity_of(d, f, "speed") is not None and f.verb.lemma == "release":
        motion_of_things(d, f, things, natural(d, things[0]) if things else "roll")
        return
    drop(d, f, things)


def _raised(d: Discourse, thing: str) -> bool:
    """Whether something holds it up that is no vehicle's driver: a crane, a magnet."""
    return thing in d.scene.supported_by or thing in d.scene.heights


def drop(d: Discourse, f: Frame, things: list[str]) -> None:
    many = len(things) > 2
    moved = representatives(d, things, []) if many else things
    moved = [t for t in moved if movable(d, t)]
    source = f.phrase("off", "from")
    if source is not None and _landed_before(d, f, source):
        source = None
    if source is not None and source.mention is not None:
        host = [i for i in source.mention.entities if elevated(d, i)]
        if host:
            for t in moved:
                place(d, [t], host, "on")
                add_event(d, NodeEvent.FALL, (t,), f, time_of(d, f))
            landing_of(d, f, moved)
            return
    flying = {t for t in moved if is_airborne(d, t) and t not in d.scene.supported_by}
    for t in moved:
        if not moved_by_others(d, t):
            track = d.timeline.tracks.get(t)
            if track is None or track.motion is None:
                start_motion(d, f, [t], "drop")
    heights(d, f, moved)
    mark_used(d, f, "drop")
    if "in" in f.adverbs and any(map(partial(enterable, d), recent(d))):
        goes_in(d, f, moved, time_of(d, f))  # "circles the hole and drops in"
        return
    if not landing_of(d, f, moved):
        for t in moved:
            if t in flying:
                continue  # "drops behind the net" after a throw: it leaves no support
            d.times.pending[t] = (NodeEvent.FALL, f, None, time_of(d, f))


@sense("fall")
def read_fall(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if "in" in f.adverbs and not f.phrases and any(map(partial(enterable, d), recent(d))):
        goes_in(d, f, s, time_of(d, f))  # "pushes until the rubble falls in"
        return
    met = f.phrase("off")
    hosts = met.mention.entities if met is not None and met.mention is not None else o
    if f.verb.lemma == "come" and _rebounds(d, s, hosts):
        read_as(d, "hit", f, s, hosts[:1])  # "comes off the defender's knee"
        return
    towed = f.verb.lemma == "come" and bool(s) and not hosts and met is None
    if towed and all(entity_of(d, i).noun.name == "trailer" for i in s):
        d.scene.ignored[(f.verb.start, f.verb.end)] = "it is on its own from here on"
        return
    set_free(d, [x for x in s if kind_of(d, x) in ("post", "plant", "wall", "street")])
    set_free(d, [x for x in s if x in d.scene.attached])  # what hangs there comes down
    actors = representatives(d, s, [])
    fresh = [a for a in actors if a not in d.timeline.tracks]
    upright = [a for a in actors if _falls_over(d, a)]
    on_what_was_hit(d, f, fresh)
    ground = f.phrase("to")
    floor = ground.mention.entities if ground is not None and ground.mention else ["?"]
    down = bool(actors) and "?" not in floor and all(map(partial(structural, d), floor))
    if down and not _tall(d, actors[0]):
        upright = []
    edge = f.phrase("off", "over", "from", "out of") or f.phrase("at")
    if edge is not None and off_the_edge(d, f, edge, actors, time_of(d, f)):
        landing_of(d, f, actors)
        return
    where = f.phrase("off", "from", "out of", "over", "down", "onto", "on", "into", "in")
    if (
        upright
        and not {"off", "out"} & {*f.adverbs, f.verb.extra.get("particle", "")}
        and (where is None or where.mention is None or where.mention.attribute)
        and a_rests_low(d, upright[0])
    ):
        read_as(d, "topple", f, s, [])
        return
    source = f.phrase(*_SOURCES)
    if source is not None and source.mention is not None and not source.mention.entities:
        source = None
    if source is not None and _landed_before(d, f, source):
        source = None
    for actor in fresh:
        struck_before(d, f, actor)
    fresh = [a for a in fresh if a not in d.timeline.tracks]
    into = f.phrase("into", "in", "through", "onto", "on")
    if (
        source is None
        and len(fresh) < len(actors)
        and into is not None
        and into.mention is not None
        and into.mention.entities
        and (into.prep in ("into", "in", "through") or _on_its_way(d, f, actors, into))
    ):
        heights(d, f, actors)
        if landing_of(d, f, actors):
            return
    onto = f.phrase("on", "onto", "against")
    if upright and onto is not None and onto.mention is not None and source is None:
        struck = [i for i in onto.mention.entities if i not in actors and aimable(d, i)]
        flat = onto.mention.entities and all(map(partial(structural, d), onto.mention.entities))
        if flat and a_rests_low(d, upright[0]) and kind_of(d, upright[0]) in _UPRIGHT:
            read_as(d, "topple", f, s, [])
            return
        if struck and kind_of(d, upright[0]) in ("person", "animal"):
            add_hit(d, f, upright[:1], struck[:1], time_of(d, f))
            return
        if struck and a_rests_low(d, upright[0]) and kind_of(d, upright[0]) != "bottle":
            read_as(d, "topple", f, s, [])
            add_hit(d, f, upright[:1], struck[:1])
            return
    on_something = [a for a in fresh if a in d.scene.supported_by]
    if on_something:
        source = f.phrase("to") or source
        fresh_low: list[str] = []
    else:
        fresh_low = fresh
    fresh, held = fresh_low, fresh
    if held and not fresh:
        for actor in held:
            start_motion(
                d, f, [actor], "roll" if "round" in entity_of(d, actor).noun.traits else "slide"
            )
    if fresh and source is None:
        drop(d, f, fresh)
        return
    for actor in actors:
        if not movable(d, actor):
            continue
        lands = source is None and actor not in d.scene.supported_by
        if lands and _thrown_up(d, actor) and not _bounced(d, actor):
            mark_used(d, f, "end of the flight")
            continue
        if source is not None and source.mention is not None and source.mention.entities:
            host = source.mention.entities[0]
            if host != actor and elevated(d, host):
                place(d, [actor], [host], "on")
        heights(d, f, [actor])
        if actor in fresh:
            high = (
                source is not None
                and source.mention is not None
                and source.mention.entities
                and not elevated(d, source.mention.entities[0])
            )
            if high or (actor in d.scene.heights and actor not in d.scene.supported_by):
                start_motion(d, f, [actor], "drop")
            else:
                start_motion(
                    d, f, [actor], "roll" if "round" in entity_of(d, actor).noun.traits else "slide"
                )
        add_event(d, NodeEvent.FALL, (actor,), f, time_of(d, f))
    landing = f.phrase("onto", "into", "on", "in")
    if (
        landing is not None
        and landing.mention is not None
        and landing.mention.entities
        and not structural(d, landing.mention.entities[0])
    ):
        landing_of(d, f, actors)


def _falls_over(d: Discourse, node: str) -> bool:
    """Whether "falls" means that it topples, where it stands on the ground."""
    e = entity_of(d, node)
    if e.noun.name in _HANGING and node not in d.scene.supported_by:
        return False
    if "topples" in e.noun.traits or e.noun.kind in _UPRIGHT | _OVERTURNED:
        return True
    if e.pattern == "stack" and e.in_group and not e.place:
        return True
    if node in d.moves.leaning or e.noun.name in _TWO_WHEELED:
        return True
    runs = node in d.timeline.tracks and node not in d.scene.supported_by
    return runs and e.noun.kind == "animal" and not is_airborne(d, node)


def _rebounds(d: Discourse, things: list[str], hosts: list[str]) -> bool:
    """Whether what comes off is a ball or puck, and what it comes off holds none."""
    flying = things and all(kind_of(d, i) in ("ball", "billiard", "sliding") for i in things)
    firm = ("person", "post", "goal", "wall", "animal", "robot", "hoop")
    return bool(flying and hosts) and kind_of(d, hosts[0]) in firm


def _tall(d: Discourse, node: str) -> bool:
    """Whether it is so tall that it stands on the ground rather than on something."""
    size = entity_of(d, node).dimensions_cm or entity_of(d, node).noun.dimensions_cm
    tall = size[2] >= STANDING_CM or kind_of(d, node) in ("person", "animal", "wall")
    return tall or kind_of(d, node) == "domino" or node in d.moves.leaning


def _landed_before(d: Discourse, f: Frame, source: Phrase) -> bool:
    """Whether what it falls from is named after what it first lands in."""
    if source.mention is None:
        return False
    earlier = [p for p in f.phrases if p.mention and p.mention.start < source.mention.start]
    return any(p.prep in ("onto", "into") for p in earlier)


def _on_its_way(d: Discourse, f: Frame, actors: list[str], onto: Phrase) -> bool:
    """ "slips and tumbles onto a drum": it comes from no support that the prompt names."""
    hosts = d.scene.supported_by
    solid = onto.mention is not None and not structural(d, onto.mention.entities[0])
    upright = any(_falls_over(d, a) and a not in hosts for a in actors)
    return solid and not upright and not any(a in hosts for a in actors)


def has_toppled(d: Discourse, body: str) -> bool:
    return any(n.event is NodeEvent.TOPPLE and body in n.participants for n in d.timeline.nodes)


def _thrown_up(d: Discourse, body: str) -> bool:
    """In flight after a throw, so that it leaves no support when it lands."""
    track = d.timeline.tracks.get(body)
    flights = [e.params.elevation_deg for e in d.timeline.edges if e.actor == body]
    if track is not None and track.motion is not None and track.motion.mode != "coast":
        return track.motion.mode in ("throw", "fly")
    return any(x not in (None, -90.0) for x in flights)


def _bounced(d: Discourse, body: str) -> bool:
    """ "hits the window and falls to the ground": it comes down from what it hit."""
    last = next((n for n in reversed(d.timeline.nodes) if body in n.participants), None)
    return last is not None and last.event is NodeEvent.COLLISION


@sense("land")
def read_land(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    whole = len(s) > 1 and entity_of(d, s[0]).group in d.world.collective
    s = representatives(d, s, []) if whole else s  # "a stack of books lands on a dog"
    for actor in s:
        struck_before(d, f, actor)
        if actor not in d.timeline.tracks and not moved_by_others(d, actor):
            start_motion(d, f, [actor], "drop")
            ground = f.phrase("on", "onto", "in", "upon")
            under = ground.mention.entities if ground and ground.mention else []
            flat = any(map(partial(structural, d), under))
            if flat and kind_of(d, actor) not in ("flyer", "animal", "person"):
                add_event(d, NodeEvent.FALL, (actor,), f, time_of(d, f))
    if not landing_of(d, f, s):
        mark_used(d, f, "landing")
    mark_used(d, f, "landing")


def a_rests_low(d: Discourse, node: str) -> bool:
    """Whether an upright thing stands on the ground, so that "falls" means that it topples."""
    e = entity_of(d, node)
    if kind_of(d, node) == "domino" or (e.pattern == "stack" and e.in_group and not e.place):
        return True
    return node not in d.scene.supported_by and node not in d.scene.heights
