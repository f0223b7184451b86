"""Verbs of handling: pick up, lift, put, lower; and of what goes nowhere: jump, spin, bounce."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, movable, structural
from esg.draft.discourse.jointed import CRANES
from esg.draft.discourse.places import carries, elevated, holds, place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import Entity, head_of
from esg.draft.discourse.referents.sizes import dimensions_of, grows
from esg.draft.discourse.scene import GROUND, LIMBED, SELF_POWERED, SPEEDS
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event, add_hit
from esg.draft.events.consequences import already_hit
from esg.draft.events.ends import takes_up_from_above
from esg.draft.events.hanging import turning, turns_told
from esg.draft.events.roles import doer_and_done
from esg.draft.events.senses.climbing import comes_off
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import enter, enterable, moved_by_others, time_of
from esg.draft.events.told import amount, at_rest, ignore, recent, things, traits_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.amounts import Amount
from esg.draft.text.numerals import parse_number
from esg.graph.models import ForceDirection, NodeEvent

_PUT_IN = ("in", "into", "inside")
_PUT_BY = ("left of", "right of", "in front of", "behind", "next to", "beside", "near", "close to")
"""What somebody puts something to the left of stands there, on what carries it."""
_ELSEWHERE = frozenset({"in", "off", "on", "out", "down", "aboard", "aside", "away"})
"""Adverbs that lead a leap somewhere else than back to the ground it left."""
_OFF = frozenset({"down", "off"})
"""Adverbs of a leap from what carries who leaps."""
_HOPPED_ON = lex.word_set("hopped on")
_ONTO = re.compile(r"\b(?:on ?to|upon)\b", re.IGNORECASE)
_OFTEN = re.compile(
    r"\b(?P<least>at\s+least\s+)?(?P<n>once|twice|thrice|(\w+)\s+times)\b", re.IGNORECASE
)
_LIFTED_KG = 20000.0
"""What a crane lifts: a loaded container weighs as much."""
_DOWN = re.compile(r"(?:\w+\s+){1,4}?(?:back\s+)?down\b", re.IGNORECASE)


def _loose(d: Discourse, bodies: list[str]) -> list[str]:
    """What a hand can take: what moves, and is no vehicle."""
    return [i for i in bodies if movable(d, i) and kind_of(d, i) not in ("vehicle", "person")]


def _hoist(d: Discourse, agents: list[str], bodies: list[str]) -> None:
    """What a crane lifts is not fixed: a bathtub, a shipping container."""
    if not any(head_of(entity_of(d, a)) in CRANES for a in agents):
        return
    for e in (entity_of(d, i) for i in bodies if not structural(d, i)):
        e.freed = e.freed or (e.mass_kg or e.noun.mass_kg) <= _LIFTED_KG


def _from_where(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """ "Picks the cup up from the table", "in the box pick up the cup": where it is at first."""
    ahead = f.phrase(*lex.ONTO, *_PUT_IN)
    if ahead is not None and ahead.mention is not None and ahead.mention.start < f.verb.start:
        place(d, [i for i in bodies if i not in d.scene.supported_by], things(ahead), ahead.prep)
    of_it = [p for m, p in d.attached if m is f.object]
    for preps, prep in ((("from", "off"), "on"), (("out of",), "in")):
        told = (f.phrase(*preps), *(p for p in of_it if p.prep in preps))
        host = [i for p in told for i in things(p) if not structural(d, i)]
        if host:
            prep = "in" if holds(d, host[0]) else prep
            place(d, [i for i in bodies if i not in d.scene.supported_by], host[:1], prep)


@sense("pick")
def read_pick(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "Picks up the mug", "lifts a crate off a truck": it rises, held."""
    agents, taken = doer_and_done(f, s, o or things(f.phrase("up")))
    _hoist(d, agents, taken)
    taken = _loose(d, taken)
    if f.object is not None and f.object.part:
        ignore(d, f, "no physical meaning")  # "grasps the handle of the drawer"
        return
    if not taken:
        read_as(d, "carry", f, s, o)
        return
    _from_where(d, f, taken)
    by = [d.scene.inside_of.get(i, i) for i in taken[:1]]  # before the oven that it is taken out of
    place(d, [a for a in agents if kind_of(d, a) != "building"], by, "near")
    goal = _goal(d, f, taken)
    for body in taken:
        if at_rest(d, body):
            d.timeline.move(body, Motion("guide"), ForceDirection.ANY_3D)
            add_event(d, NodeEvent.PICKED_UP, (body,), f, time_of(d, f))
    mark_used(d, f, "picked up")
    if goal is not None:
        _put(d, f, taken, goal)


@sense("put")
def read_put(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "Puts the mug on the shelf", "lowers a crate onto a truck": it ends there, let go."""
    agents, moved = doer_and_done(f, s, o)
    moved = _loose(d, _named_it(d, f) or moved)
    goal = _goal(d, f, moved)
    if f.object is None and {*s} & {*_in_hand(d)}:
        moved, f = s, replace(f, verb=replace(f.verb, passive=True))  # "is lifted and put on"
    act = not f.reduced and (_told_as_act(d, f) if f.verb.passive else f.object is not None)
    several = f.verb.lemma == "stack" and len(moved) > 1  # one upon the other
    pushed = any(moved_by_others(d, i) for i in moved)
    if not moved or goal is None or not act or pushed or several:
        read_as(d, "posture", f, s, o)
        return
    place(d, [a for a in agents if kind_of(d, a) in LIMBED], moved[:1], "near")
    _from_where(d, f, moved)
    _put(d, f, moved, goal)


def _in_hand(d: Discourse) -> list[str]:
    """What has been picked up last, if nothing happened since."""
    held: list[str] = []
    for n in reversed([n for n in d.timeline.nodes if n.participants]):
        if n.event is not NodeEvent.PICKED_UP:
            break
        held.insert(0, n.participants[0])
    return held


def _named_it(d: Discourse, f: Frame) -> list[str]:
    """What "it" is that is put somewhere: what is in hand."""
    m = f.subject if f.verb.passive else f.object
    held = _in_hand(d)
    if m is None or m.pronoun not in ("it", "them"):
        return []
    return held if m.pronoun == "them" else held[-1:]


def _told_as_act(d: Discourse, f: Frame) -> bool:
    """ "Is gently placed", "is lowered onto", "is picked up and placed": no state of what lies."""
    group = {*f.adverbs, *d.text[f.verb.start : f.verb.end].lower().split()}
    known = any(i in d.timeline.tracks for i in (f.subject.entities if f.subject else []))
    being = f.verb.lemma == "lower" or "being" in group or "then" in group
    acted = bool(group & lex.word_set("manners of acting")) or _onto_a_liquid(d, f)
    return being or known or acted


_IS = re.compile(r"(?:is|are)\b", re.IGNORECASE)


def _onto_a_liquid(d: Discourse, f: Frame) -> bool:
    """ "A cork is placed on the surface of a bucket of water": what it does there is the story."""
    found = f.phrase(*lex.ONTO, *_PUT_IN)
    m = found.mention if found is not None else None
    filled = [at.vessel for at in d.scene.fillings.fillings]
    liquid = m is not None and any(m.start <= at < m.end for at in filled)
    return liquid and _IS.match(d.text, f.verb.start) is not None


def _goal(d: Discourse, f: Frame, moved: list[str]) -> tuple[str, str] | None:
    """Where a clause says that things are put: the preposition, and on or in what."""
    found = f.phrase(*lex.ONTO, *_PUT_IN)
    said = found.mention if found is not None and things(found) else None
    again = "again" in f.verb.extra  # "puts a cup on a shelf, then a plate"
    if found is not None and said is not None and (again or said.start > f.verb.start):
        return found.prep, things(found)[0]
    if moved and found is None and {*moved} <= {*_in_hand(d)} and _DOWN.match(d.text, f.verb.start):
        return "on", d.scene.supported_by.get(moved[0]) or _ground(d)  # "and sets it down again"
    by = f.phrase(*_PUT_BY, *(() if f.verb.passive else ("by",))) if found is None else None
    said = by.mention if by is not None and things(by) else None
    if by is not None and said is not None and (again or said.start > f.verb.start):
        return by.prep, d.scene.supported_by.get(things(by)[0]) or _ground(d)
    inner = [i for i in recent(d) if holds(d, i) and i not in moved]
    inner = inner if found is None and "inside" in f.adverbs else []
    return ("inside", inner[0]) if inner else None  # "opens the drawer and puts a bowl inside"


def _put(d: Discourse, f: Frame, moved: list[str], goal: tuple[str, str]) -> None:
    """Guides things to where they are put."""
    prep, target = goal
    held = _in_hand(d)
    for body in [i for i in moved if i != target]:
        if d.scene.supported_by.get(body) == target and body not in held:
            if not at_rest(d, body):
                continue
            if prep not in _PUT_BY:
                _lay_aside(d, body, target)
        d.timeline.move(body, Motion("guide", target=target), ForceDirection.ANY_3D)
        inner = holds(d, target) or enterable(d, target) or takes_up_from_above(d, target, "in")
        if prep in _PUT_IN and inner:
            enter(d, f, body, target, time_of(d, f))
        else:
            add_event(d, NodeEvent.PLACED, (body, target), f, time_of(d, f))
        d.timeline.track(body).motion = None
    mark_used(d, f, "put")


def _lay_aside(d: Discourse, body: str, target: str) -> None:
    """What is to be put on something is not there yet ("put the bowl on the plate")."""
    d.scene.supported_by.pop(body)
    d.scene.inside_of.pop(body, None)
    told = d.scene.relations
    told[:] = [r for r in told if (r.source, r.target) != (body, target)]


@sense("jump")
def read_jump(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "Jumps over the fence", "hops three times": leaps from the ground and back to it."""
    if comes_off(d, f, s):
        return
    springy = [i for i in things(f.phrase(*lex.ONTO)) if entity_of(d, i).noun.name in _HOPPED_ON]
    springy = [] if _ONTO.search(d.text, f.verb.end) else springy
    place(d, s, springy[:1], "on")
    over = [i for i in (*things(f.phrase("over", "across")), *o) if i not in s]
    over = [i for i in over if not structural(d, i)][:1]
    leaps = [a for a in s if kind_of(d, a) in LIMBED and not moved_by_others(d, a)]
    if leaps and not over and not springy and _jumps_away(d, f, leaps):
        return
    elsewhere = f.phrase(*lex.ONTO, "to", "off", "into", "in", "from", "out of", "down", "at")
    leaps = [a for a in leaps if d.scene.supported_by.get(a) in (None, *springy)]
    away = _ELSEWHERE & {*f.adverbs, f.verb.extra.get("particle", "")}
    if away or (things(elsewhere) and not springy) or not leaps:
        read_as(d, "own", f, s, o)
        return
    for actor in leaps:
        node = _leap(d, f, actor, over)
        so_often(d, f, node)
        d.timeline.track(actor).motion = None
    mark_used(d, f, "jump")


def _leap(d: Discourse, f: Frame, actor: str, over: list[str]) -> str:
    """The Jump of an actor, from where it stands or from a motion of its own."""
    speed = SPEEDS.get(kind_of(d, actor))
    jump = Motion("jump", None if not over else speed, target=next(iter(over), None))
    if at_rest(d, actor):
        d.timeline.move(actor, jump, ForceDirection.ALONG_FORWARD_ONLY)
    else:
        d.timeline.trigger(actor, f"{actor} takes off")
        d.timeline.track(actor).motion = jump
    return add_event(d, NodeEvent.JUMP, (actor, *over), f, time_of(d, f))


def _jumps_away(d: Discourse, f: Frame, leaps: list[str]) -> bool:
    """ "Jumps onto the table", "off a box", "from the chair to the shelf"; False for other ways."""
    said = {p.prep: things(p)[0] for p in f.phrases if things(p)}
    bottoms = [said[k] for k in ("off", "from") if k in said]
    lands = [i for k, i in said.items() if k in ("onto", "to", "on") and structural(d, i)]
    if not bottoms and (lands or _OFF & {*f.adverbs, f.verb.extra.get("particle", "")}):
        bottoms = [d.scene.supported_by.get(leaps[0], "")]  # "is on a bench, then it jumps down"
    bottoms = [i for i in bottoms if i and (elevated(d, i) or carries(d, i, leaps[0]))]
    tops = [said[k] for k in lex.ONTO if k in said and _jumped_onto(d, said[k])]
    upward = f.phrase("to")
    to_top = upward is not None and upward.mention is not None and upward.mention.part == "top"
    tops += [i for k, i in said.items() if k == "to" and (bottoms or to_top)]
    pools = [i for k, i in said.items() if k in _PUT_IN and bottoms and enterable(d, i)]
    others = said.keys() - {*lex.ONTO, *_PUT_IN, "to", "off", "from"}
    if "out of" in said and not tops and not bottoms and _fits(d, leaps, said["out of"]):
        bottoms, others = [said["out of"]], others - {"out of"}
    if others & {"out of", "at", "down", "through"} or not (tops or bottoms):
        return False
    if said.keys() & {*_PUT_IN} and not pools:
        return False
    if not all(_can_leap(d, a, bottoms) for a in leaps):
        return False
    for actor in leaps:
        place(d, [actor], bottoms[:1], "in" if "out of" in said else "on")
        _soon(d, [_leap(d, f, actor, [])])
        track = d.timeline.track(actor)
        track.motion = Motion("coast")
        if tops:
            _soon(d, add_hit(d, f, [actor], tops[:1], None))
            track.motion, d.moves.upon[actor] = None, tops[0]
        else:
            _comes_down(d, f, actor, "" if "out of" in said else bottoms[0], pools)
    mark_used(d, f, "jump")
    return True


def _can_leap(d: Discourse, actor: str, bottoms: list[str]) -> bool:
    """Whether somebody is on nothing else, and not on a way that ends elsewhere."""
    if d.scene.supported_by.get(actor) not in (None, *bottoms):
        return False
    return actor not in d.moves.upon and (not bottoms or at_rest(d, actor))


def _fits(d: Discourse, leaps: list[str], host: str) -> bool:
    """Whether who leaps out of something has room in it to leap from."""
    if not holds(d, host) or len(leaps) > 1 or structural(d, host):
        return False
    mine, other = (dimensions_of(entity_of(d, i)) for i in (leaps[0], host))
    wide = grows(entity_of(d, host)) or min(other[:2]) >= _ROOM * max(mine[:2])
    return wide and other[2] <= max(_OVER * mine[2], _HIGH_CM)


def _comes_down(d: Discourse, f: Frame, actor: str, host: str, pools: list[str]) -> None:
    """ "Jumps off a box", "from a pier into the water": a fall, if it is high, or a landing.

    No host: who leaps out of a thing comes down as low as he was.
    """
    if host and _is_far_down(d, actor, host):
        _soon(d, [add_event(d, NodeEvent.FALL, (actor,), f, None)])
    elif not pools:
        _soon(d, [d.timeline.trigger(actor, f"{actor} comes down")])
    if pools:
        enter(d, f, actor, pools[0], None)


def _is_far_down(d: Discourse, actor: str, host: str) -> bool:
    """Whether who gets down from something falls: by more than half of its height."""
    mine, other = (entity_of(d, i).noun.dimensions_cm[2] for i in (actor, host))
    return other > FALLS_SHARE * mine


def _soon(d: Discourse, nodes: list[str]) -> None:
    """A leap takes no longer than a second."""
    for node in nodes:
        if (draft := d.timeline.node(node)) is not None and draft.usual is None:
            draft.usual = LEAP_S


def _jumped_onto(d: Discourse, i: str) -> bool:
    """Whether something stands there whose top somebody can jump onto."""
    still = i not in d.timeline.tracks and i not in d.scene.supported_by
    return still and not structural(d, i) and kind_of(d, i) not in (*LIMBED, "water", "region")


_ROOM, _OVER, _HIGH_CM = 1.3, 1.2, 65.0
"""Of what somebody leaps out of: its narrower side over his longer one, at least; its height over
his, at most, or how high it may be for all."""
FALLS_SHARE = 0.6
"""Height of what somebody jumps off over its own from which on it is a fall."""
LEAP_S = 0.5
"""From the top of a leap, or its start, to where it ends, as a rule [s]."""
PUSHED_DEG = 90.0
"""What is pushed round on its axle turns so far, at least: a turnstile by one arm of four."""


@sense("spin")
def read_spin(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "A top spins on the table", "the car spins around": it turns where it is."""
    on_axle = turning(d, o or s)
    turned = [i for i in (o or s) if movable(d, i) or i in on_axle]
    into = f.phrase("into", "against", "off", "to")
    if into is not None and things(into) and turned:
        read_as(d, "slide" if moved_by_others(d, turned[0]) else "turn", f, s, o)
        return
    angle = amount(d, f, "angle")
    if angle is not None and turned and kind_of(d, turned[0]) in SELF_POWERED:
        read_as(d, "turn", f, s, o)  # "the robot spins around by 180 degrees"
        return
    on = things(f.phrase(*lex.ONTO))
    if turned and on and not structural(d, on[0]):
        place(d, turned, on, "on")
    note = "spin"
    told = turns_told(d, f) if on_axle else None
    doers = [i for i in s if i not in turned and movable(d, i)]
    if on_axle and doers and not already_hit(d, f, doers, on_axle):
        add_hit(d, f, doers[:1], on_axle[:1], time_of(d, f))
    for body in turned:
        if at_rest(d, body):
            node = _turns_by_itself(d, f, body, body in on_axle, told, angle)
            note = node if body in on_axle else note
        elif body in on_axle:
            note = _pushed_round(d, f, body, told or PUSHED_DEG)
    mark_used(d, f, note)


def _pushed_round(d: Discourse, f: Frame, body: str, degrees: float) -> str:
    """What a blow turns on its axle, and how far."""
    node = add_event(d, NodeEvent.SPIN, (body,), f, time_of(d, f))
    if (draft := d.timeline.node(node)) is not None:
        draft.extra["turn_degrees"] = degrees
    return node


def _turns_by_itself(
    d: Discourse, f: Frame, body: str, on_axle: bool, told: float | None, angle: Amount | None
) -> str:
    """A spin of its own, as far as is told: by an angle, or so many times."""
    mode = Motion("drive" if on_axle else "spin")
    d.timeline.move(body, mode, ForceDirection.HORIZONTAL_PLANE)
    node = add_event(d, NodeEvent.SPIN, (body,), f, time_of(d, f))
    so_often(d, f, node)
    if (draft := d.timeline.node(node)) is not None:
        if "times" in draft.extra:
            draft.extra["turn_degrees"] = 360.0 * draft.extra.pop("times")
        if told is not None:
            draft.extra["turn_degrees"] = told
        if angle is not None:
            draft.extra["turn_degrees"] = angle.high
            mark_used(d, angle, "how far it turns")
    d.timeline.track(body).motion = None
    return node


def bounces_on_ground(d: Discourse, f: Frame, s: list[str], met: list[str]) -> bool:
    """ "A ball bounces three times on the floor": off what it falls on; False if off a thing."""
    if met and not structural(d, met[0]) and "support" not in traits_of(d, met[0]):
        return False
    if things(f.phrase("down", "along", "across", "over", "past", "to", "toward", "towards")):
        return False
    free = [i for i in s if "round" in traits_of(d, i) and movable(d, i)]
    free = [i for i in free if not moved_by_others(d, i)]
    target = met[0] if met and not structural(d, met[0]) else _ground(d)
    for body in free:
        target = target if met else _below(d, body) or target
        if at_rest(d, body):
            drop = Motion("drop", 0.0, params={"elevation_deg": -90.0, "spin": "none"})
            drop.target = target
            d.timeline.move(body, drop, ForceDirection.ANY_3D)
        node = add_event(d, NodeEvent.BOUNCE, (body, target), f, time_of(d, f))
        so_often(d, f, node)
    if free:
        mark_used(d, f, "bounce")
    return bool(free)


def _below(d: Discourse, body: str) -> str | None:
    """What a body was released above ("is released above a table and bounces")."""
    above = [r.target for r in d.scene.relations if (r.source, r.kind) == (body, "above")]
    falls_on = d.times.pending.get(body, (None, None, None))[2]
    return next((i for i in above if i == falls_on), None)


def _ground(d: Discourse) -> str:
    """The node of the ground, which is drawn whether it is named or not."""
    noun = lex.nouns()["ground"]
    ground = Entity(GROUND, noun, noun.name, noun.name, mentioned=False)
    return d.world.entities.setdefault(GROUND, ground).id


def so_often(d: Discourse, f: Frame, node: str) -> None:
    """ "Three times", "twice": how often it happens."""
    said, draft = _OFTEN.search(d.text, f.verb.end, f.verb.end + 40), d.timeline.node(node)
    if said is None or draft is None:
        return
    n = {"once": 1, "twice": 2, "thrice": 3}.get(said["n"].lower()) or parse_number(said[3] or "")
    if isinstance(n, int | float) and 1 <= n <= 20:
        draft.extra["times"] = int(n)
        d.scene.used.setdefault(said.span("n"), node)
        for word in re.finditer(r"\w+", said["least"] or ""):  # nothing counts how often at most
            start = said.start("least")
            d.scene.used.setdefault((start + word.start(), start + word.end()), node)
