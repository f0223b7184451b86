"""Acts that the readings of verbs are made of: motions with their outcomes, hits, entries."""

from __future__ import annotations

from typing import Any

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
from esg.draft.discourse.event_coreference import goes_on, time_of_told, told_before
from esg.draft.discourse.places import carries, elevated, enterable, fits_on, holds, place, set_free
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.scene import SELF_POWERED, SPEEDS
from esg.draft.events.arrivals import (
    bounces_over,
    heads_for,
    implied_goal,
    over_a_deck,
    over_its_top,
    takes_up_from_above,
    touches_later,
)
from esg.draft.events.edges import EDGES, comes_down, from_an_end, off_the_edge, opening
from esg.draft.events.motions import natural, own, speed_of, stands, start_motion
from esg.draft.events.table import read_as
from esg.draft.events.timing import (
    PUSHING,
    enter,
    is_airborne,
    moved_by_others,
    record_event,
    representatives,
    settle,
    time_of,
)
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

_GOALMOUTH = lex.word_set("goalmouth")
_GOING = lex.word_set("going (acts)")
_VISITING = lex.word_set("visiting")
WAYS = lex.word_set("ways (acts)")
_HOLDING = lex.word_set("holding (acts)")
_OPENINGS = frozenset({"hole", "water"})
_PLACES = lex.word_set("places (acts)")


def outcomes(d: Discourse, f: Frame, actors: list[str]) -> None:
    """Events that a motion's prepositional phrases state: into, off, onto, against, past."""
    time = time_of(d, f)
    fallen: set[str] = set()
    if "in" in f.adverbs and f.verb.lemma in _GOING and f.phrase("into", "in") is None:
        off = f.phrase("off")
        if off is not None and off.mention is not None and not off.mention.attribute:
            solid = [i for i in off.mention.entities if aimable(d, i)]
            add_hit(d, f, actors, [i for i in solid if i not in actors][:1])
        goes_in(d, f, actors, time)
    for p in f.phrases:
        if p.mention is None or p.mention.part in WAYS:
            continue  # "walks into the path of a tram"
        if off_the_edge(d, f, p, actors, time):
            fallen.update(actors)
            continue
        if p.prep in ("out of", "from") and p.mention.head in _HOLDING:
            for actor in actors if f.verb.sense in ("slide", "drop", "fall") else []:
                add_event(d, NodeEvent.FALL, (actor,), f, time)  # "slips out of his hand"
            continue
        if p.mention.attribute and not p.mention.entities:
            continue
        others = [i for i in p.mention.entities if i not in actors]
        if not others:
            continue
        other = others[0]
        if p.prep == "from" and from_an_end(d, f, p, other):
            place(d, actors, [other], "on")  # "roll from opposite ends of a table"
            continue
        for actor in actors:
            if p.prep in ("into", "in", "inside", "through"):
                if actor in fallen and holds(d, other):
                    enter(d, f, actor, other, p.mention, time)
                else:
                    go_into(d, f, actor, others, p, time)
            elif p.prep in ("against",):
                add_hit(d, f, [actor], [other], time)
            elif p.prep in ("off", "over") or (
                p.prep in ("from", "out of") and f.verb.sense in ("fall", "slide", "drop")
            ):
                slips = p.prep == "off" and f.verb.sense in ("roll", "slide", "fall", "drop")
                high = elevated(d, other) or (slips and carries(d, other, actor))
                high = high or (p.prep == "off" and f.verb.lemma in ("jump", "leap", "hop"))
                if high and movable(d, actor) and (p.prep != "over" or p.mention.part):
                    place(d, [actor], [other], "on")
                    add_event(d, NodeEvent.FALL, (actor,), f, time)
                    fallen.add(actor)
                elif p.prep == "off" and {kind_of(d, actor), kind_of(d, other)} == {"billiard"}:
                    add_hit(d, f, [actor], [other], time)  # "goes in off the blue"
                elif p.prep == "over" and (
                    over_its_top(d, f, actor, other) or over_a_deck(d, f, actor, other)
                ):
                    place(d, [actor], [other], "on")
            elif p.prep == "onto" and not structural(d, other):
                add_hit(d, f, [actor], [other], time)
            elif p.prep in ("down", "up") and "incline" in entity_of(d, other).noun.traits:
                place(d, [actor], [other], "on" if p.prep == "down" else "near")
            elif p.prep in ("along", "across") and "support" in entity_of(d, other).noun.traits:
                place(d, [actor], [other], "on")
            elif p.prep in ("toward", "towards") and p.mention.part in EDGES:
                if elevated(d, other) and fits_on(d, actor, other):
                    place(d, [actor], [other], "on")  # "rolls toward the edge of the desk"
            elif p.prep == "past" and touches_later(d, f, other):
                mark_used(d, f, "on the way to the contact")
            elif p.prep == "past":
                add_event(d, NodeEvent.MISS, (actor, other), f, time)
            elif p.prep == "to" and structural(d, other) and comes_down(d, f, actor, p):
                add_event(d, NodeEvent.FALL, (actor,), f, time)
            elif p.prep == "to" and not structural(d, other) and not p.mention.attribute:
                heads_for(d, f, actor, other, time)


def goes_in(d: Discourse, f: Frame, actors: list[str], time: Time | None) -> None:
    """ "bounces off the rim and goes in": into the goal, hoop or hole named before."""
    named = [i for ids in reversed(d.world.salience) for i in ids]
    known = d.world.entities
    for actor in actors:
        goals = [i for i in named if i in d.world.entities and enterable(d, i)]
        last = d.timeline.node(d.timeline.last_event or "")
        passed = str(last.extra.get("region", "")).split("/")[0] if last is not None else ""
        goals = [i for i in goals if i != passed] or goals  # "through the hoop and back in"
        goal = next(iter(goals), d.moves.aim.get(actor, ""))
        if not goal and kind_of(d, actor) in ("ball", "sliding"):
            posts = any(entity_of(d, i).head.split()[-1] in _GOALMOUTH for i in named if i in known)
            goal = implied_goal(d, actor) if posts else ""
        table = d.world.billiards or any(e.noun.kind == "billiard" for e in known.values())
        if not goal and table and kind_of(d, actor) in ("billiard", "ball"):
            read_as(d, "pocket", f, [], [actor])  # "goes in off the cushion"
        if goal and (enterable(d, goal) or holds(d, goal)):
            ensure_mover(d, f, actor, goal)
            enter(d, f, actor, goal, None, time)


def go_into(
    d: Discourse,
    f: Frame,
    actor: str,
    others: list[str],
    p: Phrase,
    time: Time | None,
) -> None:
    other = others[0]
    noun = entity_of(d, other).noun
    if structural(d, other):
        return
    visits = f.verb.lemma in _VISITING and entity_of(d, other).head.split()[-1] in _PLACES
    if visits and p.prep != "through" and kind_of(d, actor) in SELF_POWERED:
        d.times.pending[actor] = (NodeEvent.REACH, f, other, time)  # "comes into the station"
        return
    if p.prep == "through" and opening(d, others):
        mark_used(d, f, "a way, no thing that is met")
        return
    barrier = noun.kind in ("wall", "street") or noun.name in ("hedge", "bush")
    breaks = p.prep == "through" and barrier and not p.mention_plural
    if (
        breaks
        and noun.name not in ("door", "window")
        and f.verb.sense not in ("noop", "be", "posture")
    ):
        add_hit(d, f, [actor], others, time)
        return
    if (
        p.prep in ("in", "inside", "through")
        and f.verb.sense
        not in (
            "cause",
            "fall",
            "land",
            "pocket",
            "launch",
            "drop",
            "reach",
        )
        and "goal" not in noun.traits
        and noun.kind != "region"
    ):
        return
    airborne = (
        is_airborne(d, actor) and f.verb.sense not in ("roll", "slide")
    ) or f.verb.sense in (
        "fall",
        "drop",
        "land",
        "pocket",
        "fly",
    )
    airborne = airborne or (f.verb.sense == "bounce" and bounces_over(d, actor, other))
    airborne = airborne or ("there" in f.adverbs and actor in d.moves.came_down)
    enterable = (
        noun.kind in ("region", "goal", "hole", "hoop")
        or "goal" in noun.traits
        or noun.kind == "water"
    )
    if enterable or (airborne and takes_up_from_above(d, other, p.prep)):
        enter(d, f, actor, other, p.mention, time)
    else:
        add_hit(d, f, [actor], others, time)


def add_event(
    d: Discourse,
    kind: NodeEvent,
    participants: tuple[str, ...],
    f: Frame,
    time: Time | None,
    **extra: Any,
) -> str:
    """Adds a point event; its first participant is set in motion if nothing moves it yet."""
    if kind is NodeEvent.FALL and f.verb.sense == "fall" and stands(d, f, participants[0]):
        kind = NodeEvent.TOPPLE  # "the lamp falls onto the table": it stood beside it
    told = told_before(d, kind, participants, f, extra.get("region", ""))
    if told:
        time_of_told(d, told, time)
        mark_used(d, f, told)
        return told
    first = participants[0]
    track = d.timeline.tracks.get(first)
    if track is None or not track.under_way or track.waiting:
        if not movable(d, first):
            set_free(d, [first])
        if movable(d, first):
            start_motion(d, f, [first])
    return record_event(d, kind, participants, f, time, **extra)


def ensure_mover(d: Discourse, f: Frame, mover: str, target: str | None) -> None:
    track = d.timeline.tracks.get(mover)
    if track is not None and track.under_way and not track.waiting:
        return
    start_motion(d, f, [mover], None, target)


def add_hit(
    d: Discourse, f: Frame, movers: list[str], targets: list[str], time: Time | None = None
) -> list[str]:
    """Collision events of movers with targets (one for a plural of things in a group)."""
    out: list[str] = []
    targets = representatives(d, targets, movers)
    if len(movers) > 3 or any(entity_of(d, m).group in d.world.vague for m in movers):
        movers = representatives(d, movers, [])  # "darts hit the board"
    for mover in movers:
        for target in targets:
            if mover == target or mover not in d.world.entities or structural(d, target):
                continue
            if "region" in (kind_of(d, mover), kind_of(d, target)):
                continue  # a pocket is a part of its table
            if f.verb.lemma in ("run", "drive", "slam") and kind_of(d, target) in _OPENINGS:
                ensure_mover(d, f, mover, target)
                enter(d, f, mover, target, None, time)  # "runs into the gutter"
                continue
            if not movable(d, mover):
                mover, target = target, mover
                if not movable(d, mover) or not aimable(d, target):
                    continue  # "is bumped by a sidewalk"
            if (id(f), mover, target) in d.times.told_hits:
                continue  # one clause tells one collision of a pair
            d.times.told_hits.add((id(f), mover, target))
            aimed = d.times.pending.get(target)
            if aimed is not None and aimed[0] in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION):
                mover, target = target, mover  # "a keeper blocks the shot": the ball arrives
            _settle_others(d, mover, target)
            share_support(d, f, mover, target)
            ensure_mover(d, f, mover, target)
            _was_under_way(d, f, target)
            out.append(add_event(d, NodeEvent.COLLISION, (mover, target), f, time))
            for one, other in ((mover, target), (target, mover)):
                arrival = d.times.pending.get(one)
                same = arrival is not None and arrival[1].sentence == f.sentence
                if same and arrival[0] is NodeEvent.REACH and arrival[2] == other:
                    del d.times.pending[one]  # "throws it to a dog, which catches it": once
            d.moves.last_hit = (mover, target)
            time = None
    return out


def _was_under_way(d: Discourse, f: Frame, target: str) -> None:
    """Sets what is hit in motion, where the prompt goes on as if it were: "then brakes"."""
    e = entity_of(d, target)
    if target in d.timeline.tracks or e.noun.kind not in SELF_POWERED or target in d.moves.still:
        return
    if goes_on(d, f, target):
        own(d, target, SPEEDS.get(e.noun.kind, (50.0, 600.0)), False)


def _settle_others(d: Discourse, mover: str, target: str) -> None:
    """What was sent at a thing before arrives before the next one does."""
    mates = d.world.groups.get(entity_of(d, target).group or "", [target])
    for name, (kind, _, other, _) in list(d.times.pending.items()):
        aimed = kind is NodeEvent.COLLISION and other in mates
        own = entity_of(d, mover).group
        aimed = aimed and not (own and own == entity_of(d, name).group)
        if aimed and name not in (mover, target) and mover in d.world.entities:
            settle(d, name, None)


def share_support(d: Discourse, f: Frame, mover: str, target: str) -> None:
    """What rolls across a table and hits a cup there, or pushes it, shares its table."""
    hosts = d.scene.supported_by
    for one, other in ((mover, target), (target, mover)):
        host = hosts.get(one)
        if host is None or other in hosts or other in d.scene.inside_of or other == host:
            continue
        if not fits_on(d, other, host) or is_airborne(d, mover):
            continue
        fell = any(n.event is NodeEvent.FALL and one in n.participants for n in d.timeline.nodes)
        pushed = f.verb.lemma in PUSHING or mover in d.moves.rolling
        pushed = pushed or any(
            n.event is NodeEvent.TOPPLE and mover in n.participants for n in d.timeline.nodes
        )  # a domino that tips over onto those on a table
        if d.moves.aim.get(mover) == host:
            continue
        if not fell and (one == mover or pushed):
            place(d, [other], [host], "on")


def comes_down_a_slope(d: Discourse, mover: str) -> bool:
    """Whether something is on its way down a ramp: it arrives faster than it set off."""
    track, host = d.timeline.tracks.get(mover), d.scene.supported_by.get(mover)
    if host is None or track is None or track.motion is None or track.closed:
        return False
    return "incline" in entity_of(d, host).noun.traits


def kinematics(d: Discourse, f: Frame, movers: list[str], targets: list[str]) -> None:
    """A stated speed belongs to the mover ("hits the wall at 5 m/s": just before it)."""
    found = quantity_of(d, f, "speed")
    if found is None or not movers:
        return
    speed, prescribed = speed_of(d, f, movers, natural(d, movers[0]))
    for mover in movers:
        track = d.timeline.tracks.get(mover)
        if track is not None and track.motion is not None and track.motion.mode == "brake":
            continue
        if comes_down_a_slope(d, mover):
            continue
        if track is not None and track.motion is not None and not track.closed:
            track.motion.speed, track.motion.prescribed = speed, prescribed
        elif not moved_by_others(d, mover):
            start_motion(d, f, [mover], None, targets[0] if targets else None)
