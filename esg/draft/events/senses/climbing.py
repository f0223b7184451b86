"""Climbing: up a ladder, a trunk, a wall or stairs, down again, onto a thing, over it."""

from __future__ import annotations

from dataclasses import dataclass
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, quantity_of, structural
from esg.draft.discourse.record import Climbing, Discourse
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import LIMBED, LIVING
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event
from esg.draft.events.stated import said, start_of
from esg.draft.events.timing import time_of
from esg.draft.events.told import at_rest, things
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention
from esg.graph.models import ForceDirection, NodeEvent, Predicate
from esg.graph.rules_segments import LEAST_SPEED_CM_S

COMES_OFF = "it comes down from what it has climbed"
"""What became of a verb of falling or leaping after a climb."""
_CLIMBS = lex.word_set("climbs")
_LEAPS = lex.word_set("jumping") - _CLIMBS
_BETWEEN = lex.word_set("between a climb and its goal")
_UPRIGHT = {"rope": "climbing rope", "cord": "climbing rope", "tree trunk": "tree"}
"""What lies elsewhere, and what stands where it is climbed: a rope hangs from a frame."""
_UNCLIMBED = lex.word_set("not climbed")
_ACTS = frozenset(
    {"own", "hit", "knock", "approach", "follow", "leave", "reverse", "roll", "slide", "fly",
     "pick", "put", "carry", "launch", "turn", "stop", "brake", "accelerate", "open", "tow", "pass"}
)  # fmt: skip
"""Senses of what somebody does elsewhere, on the ground."""
_FALLS = frozenset({"fall", "drop", "topple"})
_FROM = ("down from", "from", "off", "down", "off of", "out of")
_LOW = 1.5
"""What is no more than so many times as high as who climbs it is climbed onto."""
_LEAST_CM, _GRIP = 8.0, 0.5
"""What is lower, or lower than this share of who climbs, is stepped over and not climbed."""
_DOWN = re.compile(r"\s+(?:all the way |straight |back |right )?down\b", re.IGNORECASE)
_OFF = frozenset({"down", "off"})
_PUSHES_OFF_CM_S = (70.0, 130.0)
"""How fast who jumps down from what he has climbed leaves it."""
_USUAL_CM_S, _LENGTHS_S = (18.0, 75.0), 1.8
"""How fast somebody climbs: so many of his lengths a second, within these."""
_PACES = {"": (0.8, 1.2), "fast": (1.8, 2.8), "slow": (0.5, 0.8)}
"""Shares of that which words of pace leave."""
HALFWAY = re.compile(r"\bhalf ?-?way\b", re.IGNORECASE)
"""Half of what is climbed."""


@dataclass(frozen=True)
class _Goal:
    """What is climbed, how, and the words that name it."""

    thing: str
    course: str
    mention: Mention
    start: int


def climbs_something(d: Discourse, f: Frame, s: list[str]) -> bool:
    """ "Climbs a ladder", "runs up the trunk", "climbs over a fence": leads who does it there.

    Returns:
        Whether it is told of; else the clause is read as any other motion.
    """
    goal = _goal(d, f, s)
    who = [a for a in s if kind_of(d, a) in LIMBED]
    if goal is None or not who or who != s or f.verb.passive:
        return False
    if goal.thing in s or goal.thing in d.timeline.tracks or not all(at_rest(d, a) for a in s):
        return False
    if any(d.scene.supported_by.get(a) not in (None, goal.thing) for a in s):
        return False
    if goal.course in ("it", "up") and _goes_on(d, f, s):
        return False  # nothing leads it down again
    for actor in who:
        course = _course(d, actor, goal, climbing=f.verb.lemma in _CLIMBS)
        if course is None:
            return False
        _lead(d, f, actor, goal, course)
    mark_used(d, f, "climb")
    return True


def _goes_on(d: Discourse, f: Frame, s: list[str]) -> bool:
    """ "Climbs a ladder and walks to a box": whether more is told of who has climbed up."""
    for g in d.told:
        if g.verb.start <= f.verb.start or g.subject is None or not {*g.subject.entities} & {*s}:
            continue
        named = {i for p in g.phrases for i in things(p) if not structural(d, i)}
        lands = g.verb.sense in _FALLS and (bool(named - {*_named(f)}) or g.object is not None)
        if lands or (g.verb.sense in _ACTS and g.verb.lemma not in _LEAPS):
            return True
    return False


def _named(f: Frame) -> list[str]:
    """What a clause has as its object and in its phrases."""
    named = [f.object, *(p.mention for p in f.phrases)]
    return [i for m in named if m is not None for i in m.entities]


def _lead(d: Discourse, f: Frame, actor: str, goal: _Goal, course: str) -> None:
    """A guide along what is climbed, to the end of the climb."""
    d.scene.supported_by.pop(actor, None)
    params: dict[str, object] = {"climbs": course}
    speed = _speed(d, f, actor)
    if course in ("up", "down"):
        params["release"] = course == "down"
    length = quantity_of(d, f, "length")
    if length is not None and course in ("up", "down"):
        params["height_cm"] = length[1].value
        mark_used(d, length[1], "how high it climbs")
    half = HALFWAY.search(d.text, f.verb.start, goal.mention.end)
    trunk = entity_of(d, goal.thing).noun.name == "tree"  # its crown is in the way
    if half is not None and length is None and course == "up" and not trunk:
        params["height_cm"] = round(0.5 * dimensions_of(entity_of(d, goal.thing))[2], 1)
        d.scene.used[half.span()] = "how high it climbs"
    motion = Motion("guide", speed, target=goal.thing, params=params)
    d.timeline.move(actor, motion, ForceDirection.ALONG_FORWARD_ONLY)
    node = d.timeline.trigger(actor, f"{actor} has climbed {goal.thing}")
    d.timeline.track(actor).motion = None
    words = _words(d, f, goal)
    d.moves.climbs.append(Climbing(actor, goal.thing, course, node, words))


def _words(d: Discourse, f: Frame, goal: _Goal) -> tuple[int, int]:
    """The verb with what is climbed, or the verb alone where other words stand between them."""
    between = d.text[f.verb.end : goal.start]
    for start, end in d.scene.used:
        if f.verb.end <= start and end <= goal.start:
            between = between.replace(d.text[start:end], "")
    plain = not {*re.findall(r"\w+", between.lower())} - _BETWEEN
    ahead = goal.start < f.verb.start
    return f.verb.start, f.verb.end if ahead or not plain else goal.mention.end


def _speed(d: Discourse, f: Frame, actor: str) -> tuple[float, float]:
    """How fast somebody climbs [cm/s], by his size and the words of pace."""
    size = max(dimensions_of(entity_of(d, actor)))
    usual = min(max(_LENGTHS_S * size, _USUAL_CM_S[0]), _USUAL_CM_S[1])
    told = [s.row.states for s in said(d.text, f)]
    fast, slow = Predicate.FASTER_THAN in told, Predicate.SLOWER_THAN in told
    low, high = _PACES["fast" if fast and not slow else "slow" if slow and not fast else ""]
    low, high = max(low * usual, LEAST_SPEED_CM_S), max(high * usual, 1.2 * LEAST_SPEED_CM_S)
    return round(low, 2), round(high, 2)


def comes_off(d: Discourse, f: Frame, s: list[str]) -> bool:
    """ "Climbs a ladder and jumps down", "climbs a tree and falls": down from where it has got.

    Returns:
        Whether it is told of; else the clause is read as any other fall or leap.
    """
    up = {c.actor: c for c in d.moves.climbs if c.course in ("up", "onto")}
    if not s or f.object is not None or f.unreal or f.verb.negated or f.verb.passive:
        return False
    if any(a not in up or d.timeline.track(a).at != up[a].node for a in s):
        return False
    leaps = f.verb.lemma in _LEAPS
    named = {i for p in f.phrases for i in things(p)}
    elsewhere = {i for i in named if not structural(d, i)} - {up[a].thing for a in s}
    off = _OFF & {*f.adverbs} or _DOWN.match(d.text, f.verb.end) is not None
    off = off or any(p.prep in ("off", "from", "to", "onto") and things(p) for p in f.phrases)
    if elsewhere or (leaps and not off) or "over" in f.adverbs:
        return False
    for actor in s:
        track = d.timeline.track(actor)
        track.motion = Motion("jump", _PUSHES_OFF_CM_S) if leaps else Motion("coast")
        add_event(d, NodeEvent.FALL, (actor,), f, time_of(d, f))
        track.motion = None
    mark_used(d, f, COMES_OFF)
    return True


def _goal(d: Discourse, f: Frame, s: list[str]) -> _Goal | None:
    """What a clause says is climbed; None where it says nothing of the kind."""
    climbing = f.verb.lemma in _CLIMBS
    if f.verb.lemma in _LEAPS or f.unreal or f.verb.negated:
        return None
    down = f.verb.lemma == "descend" or "down" in f.adverbs
    down = down or f.verb.extra.get("particle") == "down"
    down = down or _DOWN.match(d.text, f.verb.end) is not None
    if climbing and f.object is not None and f.object.entities and not f.object.attribute:
        return _Goal(f.object.entities[0], "down" if down else "it", f.object, f.object.start)
    for p in f.phrases:
        if p.mention is None or not things(p) or p.mention.attribute:
            continue
        course = _said_course(p.prep, climbing, down)
        if course is not None:
            return _Goal(things(p)[0], course, p.mention, start_of(p, d.text))
    return None


def _said_course(prep: str, climbing: bool, down: bool) -> str | None:
    if prep in ("up", "down"):
        return prep
    if not climbing:
        return None
    if down:
        return "down" if prep in _FROM else None
    return "over" if prep == "over" else "onto" if prep in lex.ONTO else None


def _course(d: Discourse, actor: str, goal: _Goal, *, climbing: bool) -> str | None:
    """How somebody climbs something; None where that is nothing to climb."""
    thing = entity_of(d, goal.thing)
    if thing.head in _UPRIGHT and goal.course in ("it", "up", "down"):
        thing.head = _UPRIGHT[thing.head]
        thing.noun, thing.known = lex.nouns()[thing.head], True
    mine, other = dimensions_of(entity_of(d, actor)), dimensions_of(thing)
    if structural(d, goal.thing) or kind_of(d, goal.thing) in (*LIVING, "water", "region"):
        return None
    if thing.noun.kind in _UNCLIMBED or thing.noun.name in _UNCLIMBED:
        return None
    sloped = thing.noun.kind == "ramp"
    if "round" in thing.noun.traits or (sloped and not climbing):
        return None  # what is sloped is driven and walked up
    rock = thing.noun.kind == "rock" and goal.course in ("it", "up", "onto")
    if not rock and other[2] < max(_LEAST_CM, _GRIP * min(mine)):
        return None
    if rock and not thing.dimensions_prescribed:
        return "onto"  # as large as who climbs it asks for
    if sloped and goal.course != "down":
        return "up" if goal.course in ("it", "up") else None
    walked = thing.noun.name in ("stairs", "staircase")
    if goal.course in ("it", "up"):
        low = goal.course == "it" and other[2] <= _LOW * max(mine)
        room = min(other[:2]) >= 0.6 * min(mine[:2])
        return "onto" if walked or (low and room and _carries(thing.noun)) else "up"
    return goal.course


def _carries(noun: lex.Noun) -> bool:
    """Whether a thing has a top that somebody can stand on."""
    return "support" in noun.traits or noun.kind in ("rock", "box", "block", "furniture", "table")
