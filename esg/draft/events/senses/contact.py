"""Verbs of contact: hit, strike, collide, crash, trip, catch."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, movable, quantity_of, structural
from esg.draft.discourse.places import place
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.scene import LIVING, SELF_POWERED
from esg.draft.events.acts import (
    WAYS,
    add_event,
    add_hit,
    braking,
    comes_down_a_slope,
    ensure_mover,
    kinematics,
    outcomes,
)
from esg.draft.events.consequences import knock_on
from esg.draft.events.motions import motion, reverse, start_motion
from esg.draft.events.roles import role
from esg.draft.events.senses.launch import launch_by, motion_of_things, read_launch
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import enterable, moved_by_others, time_of
from esg.draft.events.told import (
    amount,
    at_rest,
    constrain,
    ignore,
    last_of,
    mates_of,
    moves,
    recent,
    things,
)
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

_MEETING = lex.word_set("meeting (contact)")
_NO_THINGS = lex.word_set("no things")
_PLACES_HIT = lex.word_set("places hit")
_FELLING = lex.word_set("felling")
_AHEAD = frozenset({"in front of", "before"})
_STUMBLING = frozenset({"trip", "stumble"})
LATER_S = (0.3, 1.5)
"""How much later comes who does not come first."""
_BESIDE = re.compile(
    r"\s*(?:,\s*)?(?:\(|at|with\s+(?:an?\s+)?(?:constant\s+)?(?:speed|velocity)\s+of|doing|going"
    r"|(?:which\s+is\s+|that\s+is\s+)?(?:moving|travell?ing|driving|rolling|sliding|coming)"
    r"(?:\s+\w+){0,4}\s+(?:at|with))\s*",
    re.IGNORECASE,
)
"""What may stand between a thing and its own speed."""
_ARRIVING = ("hit", "strike", "touch", "meet")
_BLOWS = ("hit", "strike", "tap", "smack", "whack")


@sense("hit")
def read_hit(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Who hits, what is hit, unless the clause tells of something else, and what follows."""
    if _fells(d, f, s, o):
        return
    time = time_of(d, f)
    if f.verb.passive and _runs_in_itself(f, o):
        f.verb.passive, o = False, [i for i in o if i not in s]
    if not s and o and f.subject is None and not f.verb.passive:
        read_launch(d, f, s, o)  # "hit the ball into the goal"
        return
    movers, targets = _who_and_what(d, f, s, o)
    if f.verb.passive and not movers and s:
        thrown = quantity_of(d, f, "angle") is not None
        motion_of_things(d, f, s, "throw") if thrown else motion(d, f, s, None)
        return  # "a cue ball is struck at 3 m/s"
    if any(read(d, f, movers, targets) for read in _NO_HITS):
        return
    if not targets and len(movers) >= 2:
        mutual(d, f, movers, time)
        return
    targets = targets or _implied(d, movers)
    _comes_too(d, f, movers, targets)
    kinematics(d, f, movers, targets)
    _runs_or_reverses(d, f, movers, targets)
    changing = [m for m in movers if braking(d, m) or comes_down_a_slope(d, m)]
    nodes = add_hit(d, f, movers, targets, time)
    _speed_at_hit(d, f, nodes, changing)
    _hits_first(d, f, movers, targets, nodes)
    if not o and not f.verb.passive:
        _hits_more(d, f, movers, targets)
    _goes_on_to(d, f, targets, bool(o and nodes))


def _hits_first(
    d: Discourse, f: Frame, movers: list[str], targets: list[str], nodes: list[str]
) -> None:
    """ "Two balls roll; the left one hits the wall first": the other one hits it later."""
    if "first" not in f.adverbs or len(movers) != 1 or len(targets) != 1 or len(nodes) != 1:
        return
    rivals = [i for i in mates_of(d, movers[0]) if i != movers[0]]
    if len(rivals) != 1 or not moves(d, rivals[0]) or f.verb.negated:
        return
    for later in add_hit(d, f, rivals, targets):
        constrain(d.timeline.node(later), "time_since", LATER_S, rivals[0], since=nodes[0])
        d.moves.outrun.append((nodes[0], later))


def _goes_on_to(d: Discourse, f: Frame, targets: list[str], sent: bool) -> None:
    """ "hits the ball off the table", "hits a box into a wall": where what is hit goes."""
    if things(f.phrase("off")) and targets:
        outcomes(d, f, targets[:1])
    elif sent and f.phrase("into", "onto", "toward", "towards", "against") is not None:
        knock_on(d, f, targets[:1])


def _who_and_what(
    d: Discourse, f: Frame, s: list[str], o: list[str]
) -> tuple[list[str], list[str]]:
    """What hits, and what is hit; of "two cars collide on a bridge" the bridge is neither."""
    movers, targets = (_strikers(d, f, s), s) if f.verb.passive else (s, hit_targets(f, s, o))
    host = f.phrase("on", "in", "at")
    if len(movers) >= 2 and host is not None and targets == things(host):
        place(d, movers, targets, host.prep)
        targets = []
    return movers, targets


def _fells(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    """ "takes out eight pins": they fall over."""
    struck = s if f.verb.passive else o
    out = f.verb.lemma != "take" or "out" in d.text[f.verb.start : f.verb.end + 5].split()
    felled = f.verb.lemma in _FELLING and out and bool(struck)
    if not felled or kind_of(d, struck[0]) not in ("pin", "domino"):
        return False
    read_as(d, "knock", f, s, o)
    for pin in struck if len(struck) <= 3 else struck[:1]:
        add_event(d, NodeEvent.TOPPLE, (pin,), f, None)
    return True


def _runs_in_itself(f: Frame, o: list[str]) -> bool:
    """ "is reversed into a lamp post", "gets stuck in a bush": the subject is what hits."""
    stuck = f.verb.lemma == "stick" and bool(o)
    return role(f, "agent") is None and bool(f.verb.extra.get("motion") or stuck)


def _strikers(d: Discourse, f: Frame, struck: list[str]) -> list[str]:
    """What hits in "is hit": by that, with that, whose way it was in, what moved last."""
    moving = [a for a, t in d.timeline.tracks.items() if t.motion is not None and a not in struck]
    by = role(f, "agent") or f.phrase("with")
    return things(by) or whose_way(d, f, struck) or moving[-1:]


def _strikes_ball(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> bool:
    """ "A player strikes the ball": it flies off."""
    people = bool(movers) and all(kind_of(d, m) == "person" for m in movers)
    played = f.verb.lemma in _BLOWS and (not f.verb.passive or f.reduced)
    ball = bool(targets) and kind_of(d, targets[0]) in ("ball", "billiard", "sliding")
    if people and played and ball:
        launch_by(d, f, movers, targets)
        return True
    return False


def _runs_over(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> bool:
    """ "runs over the hole": a path."""
    over = d.text[f.verb.start : f.verb.end].lower().endswith("over")
    if over and targets and all(map(partial(enterable, d), targets)):
        motion(d, f, movers, None)
        return True
    return False


def _crashes_down(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> bool:
    """ "crashes to the floor": a fall from where it stands."""
    p = f.phrase("to", "onto", "on", "down")
    flat = all(map(partial(structural, d), [*targets, *things(p)]))
    if p is None or f.verb.passive or not flat:
        return False
    for mover in movers:
        fresh = mover not in d.timeline.tracks and kind_of(d, mover) not in SELF_POWERED
        if mover in d.scene.supported_by or (fresh and p.prep == "to"):
            add_event(d, NodeEvent.FALL, (mover,), f, time_of(d, f))
    return any(m in d.scene.supported_by for m in movers)


def _hits_no_thing(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> bool:
    """ "hits the cushion", "hits a snag", "stumbles": nothing that is met, or was understood."""
    m, after = f.object, d.text[f.verb.end : f.verb.end + 12].lower().split()[:1]
    if targets or len(movers) >= 2:
        return False
    article = after and after[0] in ("a", "an", "the", "its", "his", "her")
    named = m is not None and m.attribute and m.head not in _PLACES_HIT and not f.verb.passive
    if m is not None and m.attribute and m.head in ("cushion", "rail"):
        for mover in movers:
            ensure_mover(d, f, mover, None)
            d.scene.needs.append(("billiard_table", mover))
        ignore(d, f, "a part that every ball touches")
    elif m is not None and m.head in _NO_THINGS:
        ignore(d, f, "what is hit is no thing")
    elif (movers and m is None and article) or (named and m and m.determiner in ("a", "an")):
        ignore(d, f, "what is hit was not understood")
    elif f.verb.lemma in _STUMBLING:
        mark_used(d, f, "stumbles")
    else:
        return False
    return True


def _ends_its_fall(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> bool:
    """ "Falls off a table and hits the floor": the end of the fall that was told.

    Or what makes it bounce or break there: "bounces as it hits the floor".
    """
    falls = [last_of(d, m) for m in movers]
    told = [n.id for n in falls if n is not None and n.event in _COMES_DOWN]
    coming = [m for m in movers if d.times.pending.get(m, (None,))[0] is NodeEvent.FALL]
    flat = bool(targets) and all(map(partial(structural, d), targets))
    contact = f.verb.lemma in _ARRIVING or f.verb.extra.get("at") == "1"
    if not (told or coming) or not flat or not contact:
        return False
    mark_used(d, f, told[-1] if told else "end of the fall")
    return True


_COMES_DOWN = (NodeEvent.FALL, NodeEvent.TOPPLE, NodeEvent.BOUNCE, NodeEvent.BREAK)
"""Events at the end of which something is on the ground."""
_NO_HITS: tuple[Callable[[Discourse, Frame, list[str], list[str]], bool], ...] = (
    _strikes_ball,
    _runs_over,
    _crashes_down,
    _ends_its_fall,
    _hits_no_thing,
)
"""What a verb of contact may tell instead of a collision, in the order it is looked for."""


def _implied(d: Discourse, movers: list[str]) -> list[str]:
    """ "throws a ball at a can and hits": what was aimed at, else what was named last."""
    if not movers:
        return []
    aimed = d.moves.aim.get(movers[0]) or aim_of_mates(d, movers[0])
    if aimed is not None and aimed != movers[0]:
        return [aimed]
    return [i for i in recent(d) if i not in movers and not structural(d, i)][:1]


def _runs_or_reverses(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> None:
    """ "reverses into a wall"; "is hit by a ball and runs into a fence": by himself."""
    if f.verb.extra.get("motion") == "reverse":
        reverse(d, movers)
    for m in movers if f.verb.lemma == "run" else ():
        if moved_by_others(d, m) and kind_of(d, m) in LIVING:
            start_motion(d, f, [m], "own", next(iter(targets), None))


def _hits_more(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> None:
    """ "crashes through a fence and into a wall", "collides with a van and with a bus"."""
    seen = [*targets, *movers]
    for p in f.phrases:
        # not "hits the hurdle with his knee"
        meets = p.prep == "with" and f.verb.lemma in _MEETING
        if p.mention is None or p.mention.attribute:
            continue
        if meets or p.prep in ("into", "against", "through"):
            more = [i for i in p.mention.entities if i not in seen and not structural(d, i)]
            seen += more
            add_hit(d, f, movers, more)


def _speed_at_hit(d: Discourse, f: Frame, nodes: list[str], changing: list[str]) -> None:
    """ "brakes and hits the barrier at 4 m/s": the speed left, not the one driven before."""
    speed = amount(d, f, "speed")
    node = d.timeline.node(nodes[0]) if nodes else None
    if speed is not None and node is not None and node.participants[0] in changing:
        constrain(node, "speed_before", speed.value)
        mark_used(d, speed, f"speed before {node.id}")


def _comes_too(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> None:
    """ "A car at 10 m/s collides with a truck at 15 m/s": both have a speed, so both move."""
    if f.verb.passive or len(targets) != 1:
        return
    t = targets[0]
    _speed_beside(d, f, movers, t)
    if t not in d.moves.stated:
        return
    track = d.timeline.tracks.get(t)
    going = track.motion if track is not None else None
    if going is not None and not going.prescribed:
        going.speed, going.prescribed = d.moves.stated[t].value, True
        mark_used(d, d.moves.stated[t], "speed")
    if at_rest(d, t) and movable(d, t) and t not in movers:
        d.moves.own_speed[t] = d.moves.stated[t]
        start_motion(d, f, [t], None, movers[0] if movers and "head-on" in f.adverbs else None)


def _speed_beside(d: Discourse, f: Frame, movers: list[str], target: str) -> None:
    """A speed told beside what is hit is its own, where that of what hits it is known."""
    told = [p for p in f.phrases if any(a.dimension == "speed" for a in p.told)]
    met = [m for m in (f.object, *(p.mention for p in f.phrases)) if m and target in m.entities]
    known = len(told) > 1 or any(m in d.moves.stated or m in d.moves.own_speed for m in movers)
    if not told or not known or not met:
        return
    last = next(a for a in told[-1].told if a.dimension == "speed")
    between = d.text[max(m.end for m in met) : last.start]
    if not last.shares and _BESIDE.fullmatch(between):
        d.moves.stated[target] = last
        f.phrases = [p for p in f.phrases if p is not told[-1]]


def whose_way(d: Discourse, f: Frame, struck: list[str]) -> list[str]:
    """ "gets in the way of a tram and is hit", "runs in front of a bus": by that."""
    now = next((k for k, x in enumerate(d.told) if x.verb is f.verb), 0)
    for g in reversed(d.told[:now]):
        if g.sentence < f.sentence - 1:
            break
        about = g.subject is not None and set(g.subject.entities) & {*struck}
        for p in [Phrase("", g.object), *g.phrases] if about else ():
            ahead = p.mention is not None and (p.mention.part in WAYS or p.prep in _AHEAD)
            others = [i for i in things(p) if i not in struck]
            if ahead and others:
                return [i for i in others if movable(d, i)][:1]
    return []


def aim_of_mates(d: Discourse, mover: str) -> str | None:
    """ "The first stone misses the can. The second one hits.": the can."""
    kind = entity_of(d, mover).noun.name
    like = [a for a in d.moves.aim if a in d.world.entities and entity_of(d, a).noun.name == kind]
    return d.moves.aim[like[-1]] if like else None


def hit_targets(f: Frame, s: list[str], o: list[str]) -> list[str]:
    """What a clause says is hit: its object, else what a phrase names."""
    p = role(f, "met")
    if f.verb.lemma in _STUMBLING:
        p = f.phrase("over", "on", "into", "against") or p
    if o or p is None or (p.prep == "in" and p.mention is not None and p.mention.attribute):
        return o
    return [i for i in things(p) if i not in s]


def mutual(d: Discourse, f: Frame, movers: list[str], time: Time | None) -> None:
    """ "Two cars collide": who moves, who is hit."""
    a, b = movers[0], movers[1]
    first, second = entity_of(d, a), entity_of(d, b)
    comes = b in d.timeline.tracks and a not in d.timeline.tracks
    if first.place == "front" or second.place == "rear" or comes:
        a, b = b, a
    if at_rest(d, a) and at_rest(d, b):
        driven = any(kind_of(d, m) in SELF_POWERED for m in (a, b))
        driven = driven or all(m in d.moves.stated or m in d.moves.own_speed for m in (a, b))
        for m, other in ((a, b), (b, a)) if driven else ((a, b),):
            if movable(d, m):
                start_motion(d, f, [m], None, other)
    add_hit(d, f, [a], [b], time)
