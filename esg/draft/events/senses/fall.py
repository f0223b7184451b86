"""Verbs of falling: drop, fall, land."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
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
from esg.draft.discourse.jointed import is_flap
from esg.draft.discourse.places import elevated, holds, place, set_free
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import LIVING
from esg.draft.events.acts import add_event, add_hit, goes_in, those_with
from esg.draft.events.consequences import landing_of, met_in_its_row, struck_before
from esg.draft.events.ends import EDGES, off_the_edge
from esg.draft.events.hanging import hanging
from esg.draft.events.motions import (
    can_roll,
    flies_itself,
    jolted_off,
    motion,
    natural,
    on_what_was_hit,
    start_motion,
)
from esg.draft.events.senses.climbing import comes_off
from esg.draft.events.senses.launch import heights, look_at, motion_of_things
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import (
    enter,
    enterable,
    is_airborne,
    moved_by_others,
    representatives,
    time_of,
)
from esg.draft.events.told import ignore, last_of, mates_of, recent, size_of, things, traits_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent

_UPRIGHT = lex.word_set("upright")
_OVERTURNED = lex.word_set("overturned")
_TWO_WHEELED = lex.word_set("two wheeled")
_OTHER_SIDE = re.compile(r"\s+(?:down\s+)?on\s+(?:the|its)\s+(?:other|far)\s+side", re.IGNORECASE)
_HANGING = frozenset({"chandelier"})
_LETS_GO = frozenset({"release", "let", "free", "drop"})
_THERE = frozenset({"at", "on", "from", "atop", "near"})
_BUDGES = frozenset({"move", "budge", "stir", "slide", "roll"})
_FROM_REST = (0.0, 20.0)
"""Speed with which something that is let go on a slope sets off [cm/s]."""
STANDING_CM = 60.0
"""A thing that is this tall stands on the ground."""


@sense("drop")
def read_drop(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if not o and not f.verb.passive and _lets_nothing_go(d, f, s):
        return
    dropped = s if f.verb.passive or not o else o
    agents = [x for x in s if x not in dropped]
    if agents and dropped:
        place(d, agents, dropped, "near")
        look_at(d, [a for a in agents if kind_of(d, a) in LIVING], dropped)
    wheeled = bool(dropped) and kind_of(d, dropped[0]) in ("cart", "vehicle")
    if f.verb.lemma == "let" and wheeled and not _held_up(d, dropped[0]):
        motion(d, f, dropped, None)  # "lets go of a cart"
    elif dropped and all(i in d.scene.attached and i in d.timeline.tracks for i in dropped):
        ignore(d, f, "nothing of the kind happens in the scene")  # "is drawn back and let go"
    elif slope := _slope_of(d, f, dropped):
        _let_run(d, f, dropped, slope)
    elif _goes_its_way(d, f, dropped):
        mark_used(d, f, "let go")
    elif quantity_of(d, f, "speed") is not None and f.verb.lemma == "release":
        motion_of_things(d, f, dropped, natural(d, dropped[0]) if dropped else "roll")
    else:
        drop(d, f, dropped)


def _lets_nothing_go(d: Discourse, f: Frame, s: list[str]) -> bool:
    """ "releases the brakes", "is unloading", "clips the net and drops over": no fall."""
    beyond = "over" in f.adverbs or f.phrase("behind", "beyond", "over", "past") is not None
    beyond = beyond or _OTHER_SIDE.match(d.text, f.verb.end) is not None
    under_way = bool(s) and all(i in d.timeline.tracks or i in d.moves.stated for i in s)
    if f.object is not None and f.object.attribute:
        ignore(d, f, "nothing is let go")
    elif beyond and under_way and s[0] not in d.scene.supported_by:
        mark_used(d, f, "end of the flight")
    elif f.verb.lemma == "unload":
        ignore(d, f, "what is unloaded is not said")
    else:
        return False
    return True


def _goes_its_way(d: Discourse, f: Frame, dropped: list[str]) -> bool:
    """ "Lets go of a curling stone, and it glides on", "of a balloon, which rises": no fall."""
    placed = any(
        p.prep in ("from", "at", "above", "over", "on", "onto", "in", "into") for p in f.phrases
    )
    if f.verb.lemma not in ("let", "release") or not dropped or placed:
        return False
    if any(_held_up(d, i) or i in d.timeline.tracks for i in dropped):
        return False
    later = [g for g in d.told if g.verb.start > f.verb.start and g.subject is not None]
    its = [g for g in later if g.subject is not None and {*g.subject.entities} & {*dropped}]
    return bool(its) and its[0].verb.sense in ("slide", "roll", "own", "fly")


def _slope_of(d: Discourse, f: Frame, bodies: list[str]) -> Mention | None:
    """ "Is released at the top of a ramp", "They stand on a hill and are let go": down what."""
    if f.verb.lemma not in _LETS_GO or not bodies:
        return None
    told = [p for p in f.phrases if p.prep in _THERE and p.mention is not None]
    told += [
        p for g in d.told for p in g.phrases
        if g.verb.start < f.verb.start and p.prep in _THERE and p.mention is not None
        and g.subject is not None and {*bodies} & {*g.subject.entities}
    ]  # fmt: skip
    for m in (p.mention for p in told):
        slopes = [i for i in m.entities if "incline" in traits_of(d, i)] if m is not None else []
        if m is None or not slopes:
            continue
        place(d, [i for i in bodies if i not in d.scene.supported_by], slopes[:1], "on", m.part)
        if all(d.scene.supported_by.get(i) == slopes[0] for i in bodies):
            return m
    return None


def _let_run(d: Discourse, f: Frame, bodies: list[str], slope: Mention) -> None:
    """Lets things go on a slope: they roll or slide down it, but what is told to stay there."""
    stays = {
        i for g in d.told if g.verb.negated and g.verb.lemma in _BUDGES and g.subject is not None
        for i in g.subject.entities
    }  # fmt: skip
    f.phrases.append(Phrase("down", slope))
    for body in [i for i in bodies if i not in stays]:
        start_motion(d, f, [body], "roll" if can_roll(d, body) else "slide")
        now = d.timeline.track(body).motion
        if now is not None and not now.prescribed:
            now.speed = _FROM_REST
    mark_used(d, f, "let go")


def _held_up(d: Discourse, body: str) -> bool:
    """Whether it is above the ground: on something, or at a stated height."""
    return body in d.scene.supported_by or body in d.scene.heights


def _lies_before_its_edge(d: Discourse, f: Frame, actors: list[str]) -> None:
    """ "Pushes blocks toward the edge of a table until one drops off": there they lie."""
    loose = [a for a in actors if a not in d.scene.supported_by]
    if "off" not in f.adverbs or not loose or things(f.phrase("off", "from", "out of")):
        return
    for g in d.told:
        named = {i for m in (g.subject, g.object) if m is not None for i in m.entities}
        if g.verb.start >= f.verb.start or f.sentence - g.sentence > 1 or not named & {*loose}:
            continue
        edges = [p for p in g.phrases if p.mention and p.mention.part.split()[-1:]]
        edges = [p for p in edges if p.mention and p.mention.part.split()[-1] in EDGES]
        hosts = [i for p in edges for i in things(p) if elevated(d, i)]
        mates = [i for a in loose if a in named for i in (mates_of(d, a) or [a])]
        if hosts and hosts[0] not in named:
            place(d, mates, hosts[:1], "on")


def _let_through(d: Discourse, actors: list[str]) -> None:
    """ "The trapdoor opens and the crate falls through": by that, and not by itself."""
    for actor in actors:
        host = d.scene.supported_by.get(actor, "")
        last = last_of(d, host)
        opened = last is not None and last.event is NodeEvent.OPEN
        if last is not None and opened and is_flap(d.scene, d.text, host):
            d.timeline.carry(actor, last.id)


def drop(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """Lets bodies fall: off what the clause names, or from where they are."""
    _lies_before_its_edge(d, f, bodies)
    _let_through(d, bodies)
    moved = representatives(d, bodies, []) if len(bodies) > 2 else bodies  # all, if "one by one"
    moved = [t for t in moved if movable(d, t)]
    source = f.phrase("off", "from")
    host = [i for i in things(source) if elevated(d, i) and not _landed_before(f, source)]
    if host:
        for t in moved:
            place(d, [t, *those_with(d, f, t)], host, "on")
            add_event(d, NodeEvent.FALL, (t,), f, time_of(d, f))
        landing_of(d, f, moved)
        return
    flying = {t for t in moved if is_airborne(d, t) and t not in d.scene.supported_by}
    below = _below(d, f, moved)
    for t in moved:
        track = d.timeline.tracks.get(t)
        if not moved_by_others(d, t) and (track is None or track.motion is None):
            start_motion(d, f, [t], "drop", below)
            if below is not None:
                place(d, [t], [below], "above")
                d.times.pending[t] = (NodeEvent.COLLISION, f, below, time_of(d, f))
    heights(d, f, moved)
    mark_used(d, f, "drop")
    if "in" in f.adverbs and any(map(partial(enterable, d), recent(d))):
        goes_in(d, f, moved, time_of(d, f))  # "circles the hole and drops in"
    elif "in" in f.adverbs and (inner := _open_before(d, moved)):
        for t in moved:
            enter(d, f, t, inner, time_of(d, f))  # "a drawer is opened, a spoon is dropped in"
    elif not landing_of(d, f, moved):
        for t in moved if below is None else []:
            if t not in flying:  # "drops behind the net" after a throw: it leaves no support
                d.times.pending[t] = (NodeEvent.FALL, f, None, time_of(d, f))


def _open_before(d: Discourse, moved: list[str]) -> str:
    """What was named last that things can be dropped into; "" if nothing is."""
    return next((i for i in recent(d) if holds(d, i) and i not in moved), "")


def _below(d: Discourse, f: Frame, moved: list[str]) -> str | None:
    """ "Is released above a table": what it comes down on, unless it is told where it lands."""
    above, lands = f.phrase("above"), f.phrase("on", "onto", "into", "in", "beside", "next to")
    if lands is not None:
        return None
    over = [r for r in d.scene.relations if r.kind == "above" and r.source in moved]
    told = things(above) or [r.target for r in over]  # "it is held above a tray, then let go"
    return next((i for i in told if aimable(d, i) and i not in moved), None)


@dataclass
class Fall:
    """Who falls, from what.

    Args:
        f: The clause.
        whole: Who falls, all of a plural.
        actors: Who falls, one for a plural.
        fresh: Those of them that have not moved yet.
        upright: Those of them that tip over where they stand on the ground.
        source: What they fall from.
    """

    f: Frame
    whole: list[str]
    actors: list[str]
    fresh: list[str]
    upright: list[str]
    source: Phrase | None


@sense("fall")
def read_fall(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """What "falls" means for who does, from the most special reading to a plain fall."""
    if comes_off(d, f, s):
        return
    if _comes(d, f, s, o):
        return
    if _tumbles_on(d, f, s):
        read_as(d, "roll", f, s, o)
        return
    set_free(d, [x for x in s if kind_of(d, x) in ("post", "plant", "wall", "street")])
    set_free(d, [x for x in s if x in d.scene.attached])  # what hangs there comes down
    actors = representatives(d, s, [])
    _lies_before_its_edge(d, f, actors)
    _let_through(d, actors)
    jolted_off(d, f, actors)
    fresh = [a for a in actors if a not in d.timeline.tracks]
    floor = things(f.phrase("to"))
    down = bool(actors and floor) and all(map(partial(structural, d), floor))
    low = down and not _tall(d, actors[0])  # "a vase tumbles to the floor"
    upright = [a for a in actors if _falls_over(d, a) and not low and not hanging(d, [a])]
    source = f.phrase("off", "from", "out of", "over", "down")
    if not things(source) or _landed_before(f, source):
        source = None
    fall = Fall(f, s, actors, fresh, upright, source)
    on_what_was_hit(d, f, fresh)
    if not any(read(d, fall) for read in _FALLS):
        _plain_fall(d, fall)


def _tumbles_on(d: Discourse, f: Frame, s: list[str]) -> bool:
    """ "Throws dice onto a table, tumbling", "rolls, tumbling along": no fall."""
    on = f.verb.lemma == "tumble" and f.verb.form == "ing" and not f.relative
    ways = f.phrase("off", "from", "out of", "down", "over", "into", "in", "onto", "to")
    tracks = [d.timeline.tracks.get(i) for i in s]
    under_way = any(t is not None and (t.motion is not None or t.hit) for t in tracks)
    return on and ways is None and not {"off", "down", "over", "out"} & {*f.adverbs} and under_way


def _comes(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    """Falls that are none: "comes off the post", "a trailer comes loose", "falls in"."""
    if "in" in f.adverbs and not f.phrases and any(map(partial(enterable, d), recent(d))):
        goes_in(d, f, s, time_of(d, f))  # "pushes until the rubble falls in"
        return True
    met = f.phrase("off")
    hosts = things(met) if met is not None else o
    if f.verb.lemma != "come" or not s:
        return False
    if _rebounds(d, s, hosts):
        read_as(d, "hit", f, s, hosts[:1])  # "comes off the defender's knee"
        return True
    if met is None and not hosts and all(entity_of(d, i).noun.name == "trailer" for i in s):
        ignore(d, f, "it is on its own from here on")
        return True
    return False


def _over_the_edge(d: Discourse, fall: Fall) -> bool:
    f = fall.f
    edge = f.phrase("off", "over", "from", "out of") or f.phrase("at")
    if edge is None or not off_the_edge(d, f, edge, fall.actors, time_of(d, f)):
        return False
    landing_of(d, f, fall.actors)
    return True


def _tips_over(d: Discourse, fall: Fall) -> bool:
    """ "The lamp falls": it tips over where it stands."""
    f = fall.f
    where = f.phrase("off", "from", "out of", "over", "down", "onto", "on", "into", "in")
    there = where is not None and where.mention is not None and not where.mention.attribute
    off = {"off", "out"} & {*f.adverbs, f.verb.extra.get("particle", "")}
    if not fall.upright or off or there or not a_rests_low(d, fall.upright[0]):
        return False
    read_as(d, "topple", f, fall.whole, [])
    return True


def _lands_on_its_way(d: Discourse, fall: Fall) -> bool:
    """ "slips and tumbles onto a drum": it moved before, and comes from no named support."""
    f = fall.f
    for actor in fall.fresh:
        struck_before(d, f, actor)
    fall.fresh = [a for a in fall.fresh if a not in d.timeline.tracks]
    into = f.phrase("into", "in", "through", "onto", "on")
    if fall.source is not None or len(fall.fresh) == len(fall.actors) or not things(into):
        return False
    hosts = d.scene.supported_by
    solid = into is not None and not structural(d, things(into)[0])
    held = any(a in hosts or _falls_over(d, a) for a in fall.actors)
    inside = into is not None and into.prep in ("into", "in", "through")
    if not inside and (not solid or held):
        return False
    heights(d, f, fall.actors)
    return landing_of(d, f, fall.actors)


def _falls_onto(d: Discourse, fall: Fall) -> bool:
    """ "A ladder falls against a wall": what tips over meets what is beside it."""
    f, onto = fall.f, fall.f.phrase("on", "onto", "against")
    if not fall.upright or onto is None or fall.source is not None:
        return False
    body, met = fall.upright[0], things(onto)
    struck = [i for i in met if i not in fall.actors and aimable(d, i)]
    flat = bool(met) and all(map(partial(structural, d), met))
    low, being = a_rests_low(d, body), kind_of(d, body) in LIVING
    tips = (flat and kind_of(d, body) in _UPRIGHT) or (struck and kind_of(d, body) != "bottle")
    if struck and being:
        add_hit(d, f, [body], struck[:1], time_of(d, f))
    elif low and tips:
        read_as(d, "topple", f, fall.whole, [])
        add_hit(d, f, [body], struck[:1])
    else:
        return False
    return True


_FALLS: tuple[Callable[[Discourse, Fall], bool], ...] = (
    _over_the_edge,
    _tips_over,
    _lands_on_its_way,
    _falls_onto,
)
"""Readings of a fall, in the order they are tried; what none of them reads is a plain fall."""


def _plain_fall(d: Discourse, fall: Fall) -> None:
    """Falls from a support, or from where it is in the air."""
    f, fresh, source = fall.f, fall.fresh, fall.source
    held = [a for a in fresh if a in d.scene.supported_by]
    for actor in fresh if held else []:
        _slip(d, f, actor)
    if held:
        fresh, source = [], f.phrase("to") or source
    if fresh and source is None:
        drop(d, f, fresh)
        return
    host = next(iter(things(source)), None)
    for actor in fall.actors:
        if not movable(d, actor):
            continue
        lands = source is None and actor not in d.scene.supported_by
        if lands and _thrown_up(d, actor) and not _bounced(d, actor):
            mark_used(d, f, "end of the flight")
            continue
        high = host is not None and elevated(d, host)
        if high and host is not None and host != actor:
            place(d, [actor, *those_with(d, f, actor)], [host], "on")
        heights(d, f, [actor])
        in_the_air = actor in d.scene.heights and actor not in d.scene.supported_by
        if actor in fresh and (in_the_air or (host is not None and not high)):
            start_motion(d, f, [actor], "drop")
        elif actor in fresh:
            _slip(d, f, actor)
        add_event(d, NodeEvent.FALL, (actor,), f, time_of(d, f))
    landing = things(f.phrase("onto", "into", "on", "in"))
    if landing and not structural(d, landing[0]):
        landing_of(d, f, fall.actors)


def _slip(d: Discourse, f: Frame, actor: str) -> None:
    start_motion(d, f, [actor], "roll" if "round" in traits_of(d, actor) else "slide")


def _falls_over(d: Discourse, node: str) -> bool:
    """Whether "falls" means that it topples, where it stands on the ground."""
    e = entity_of(d, node)
    if e.noun.name in _HANGING and node not in d.scene.supported_by:
        return False
    if "topples" in e.noun.traits or e.noun.kind in _UPRIGHT | _OVERTURNED:
        return True
    if node in d.moves.leaning or e.noun.name in _TWO_WHEELED or _stacked(d, node):
        return True
    if node not in d.timeline.tracks and met_in_its_row(d, node) and "round" not in e.noun.traits:
        return True
    runs = node in d.timeline.tracks and node not in d.scene.supported_by
    return runs and e.noun.kind == "animal" and not is_airborne(d, node)


def _stacked(d: Discourse, node: str) -> bool:
    e = entity_of(d, node)
    return e.pattern == "stack" and e.in_group and not e.place


def a_rests_low(d: Discourse, node: str) -> bool:
    """Whether an upright thing stands on the ground, so that "falls" means that it topples."""
    return kind_of(d, node) == "domino" or _stacked(d, node) or not _held_up(d, node)


def _rebounds(d: Discourse, bodies: list[str], hosts: list[str]) -> bool:
    """Whether what comes off is a ball or puck, and what it comes off holds none."""
    flying = all(kind_of(d, i) in ("ball", "billiard", "sliding") for i in bodies)
    firm = ("person", "post", "goal", "wall", "animal", "robot", "hoop")
    return flying and bool(hosts) and kind_of(d, hosts[0]) in firm


def _tall(d: Discourse, node: str) -> bool:
    """Whether it is so tall that it stands on the ground rather than on something."""
    stands = kind_of(d, node) in ("person", "animal", "wall", "domino")
    return stands or size_of(d, node)[2] >= STANDING_CM or node in d.moves.leaning


def _landed_before(f: Frame, source: Phrase | None) -> bool:
    """Whether what it falls from is named after what it first lands in."""
    if source is None or source.mention is None:
        return False
    earlier = [p for p in f.phrases if p.mention and p.mention.start < source.mention.start]
    return any(p.prep in ("onto", "into") for p in earlier)


def _thrown_up(d: Discourse, body: str) -> bool:
    """In flight after a throw, so that it leaves no support when it lands."""
    track = d.timeline.tracks.get(body)
    flights = [e.params.elevation_deg for e in d.timeline.edges if e.actor == body]
    if track is not None and track.motion is not None and track.motion.mode != "coast":
        return track.motion.mode in ("throw", "fly")
    return any(x not in (None, -90.0) for x in flights)


def _bounced(d: Discourse, body: str) -> bool:
    """ "hits the window and falls to the ground": it comes down from what it hit."""
    last = last_of(d, body)
    return last is not None and last.event is NodeEvent.COLLISION


@sense("land")
def read_land(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    whole = len(s) > 1 and entity_of(d, s[0]).group in d.world.collective
    s = representatives(d, s, []) if whole else s  # "a stack of books lands on a dog"
    flat = any(map(partial(structural, d), things(f.phrase("on", "onto", "in", "upon"))))
    for actor in s:
        struck_before(d, f, actor)
        if actor not in d.timeline.tracks and flies_itself(d, actor):
            d.moves.flying.add(actor)
            start_motion(d, f, [actor], "own")  # a bird lands, it does not drop
        elif actor not in d.timeline.tracks:
            start_motion(d, f, [actor], "drop")
            if flat and kind_of(d, actor) not in ("flyer", "animal", "person"):
                add_event(d, NodeEvent.FALL, (actor,), f, time_of(d, f))
    landing_of(d, f, s)
    mark_used(d, f, "landing")
