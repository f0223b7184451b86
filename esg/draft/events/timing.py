"""Point events with their stated times, and events that a later one may replace."""

from __future__ import annotations

from dataclasses import replace
import re
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.concurrence import coincide, later, on_its_own, partner_of
from esg.draft.discourse.core import amounts_of, describe, entity_of, kind_of, mark_used, structural
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.scene import SELF_POWERED, pocket_name
from esg.draft.discourse.timeline import START
from esg.draft.discourse.windows import Draft
from esg.draft.events.roles import role
from esg.draft.events.together import lands_in_turn, mates_event
from esg.draft.events.told import constrain, mates_of, moves, unread
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount
from esg.graph.models import EdgeEvent, EventConstraint, NodeEvent, Quantity, Role

HIGHEST_CM = 2e4
"""Highest start of a fall, as the verifier has it."""
_TIMES = frozenset(
    {"after", "in", "within", "at", "by", "", "exactly", "about", "around", "before", "later"}
)
_MEETING = (NodeEvent.COLLISION, NodeEvent.ENTER_REGION)
_REPLACING = (*_MEETING, NodeEvent.REACH, NodeEvent.TOPPLE, NodeEvent.FALL)
_ON_THE_WAY = lex.word_set("on the way")
_DOWN = (NodeEvent.FALL, NodeEvent.TOPPLE, NodeEvent.BREAK)
_WITHIN = ("in", "within", "over")
_LASTS = re.compile(r"(?:over|(?:with)?in) the (?:course|space) of|within|inside|in under", re.I)
SETS_OFF = lex.word_set("sets off")
PUSHING = lex.word_set("pushing")


def representatives(d: Discourse, targets: list[str], movers: list[str]) -> list[str]:
    """A plural counts as one target: its first member."""
    out: list[str] = []
    seen: set[str] = set()
    for t in targets:
        e = entity_of(d, t)
        if t in movers or e.group in seen:
            continue
        mates = [i for i in targets if e.group is not None and entity_of(d, i).group == e.group]
        if t in d.now.each or e.group is None:
            out.append(t)
        elif any(not entity_of(d, i).letter and not entity_of(d, i).place for i in mates):
            out.append(_stands_for(d, mates))  # "hits a row of bins and pushes the red one"
            seen.add(e.group)
        else:
            out.append(t)
    return out


def _stands_for(d: Discourse, mates: list[str]) -> str:
    """The member that stands for its plural: one that the prompt names, not the last."""
    named = [
        i for i in mates if entity_of(d, i).place and entity_of(d, i).place not in ("last", "final")
    ]
    plain = [i for i in mates if not entity_of(d, i).letter and not entity_of(d, i).place]
    return next(iter([*named, *plain]))


def time_of(d: Discourse, f: Frame) -> Time | None:
    """The time that a clause states for its event."""
    for p, a in amounts_of(d, f):
        if a.dimension != "time" or precedes(d, a):
            continue
        if a.low == a.high == 0.0:
            mark_used(d, a, "the start")
            continue
        if p not in _TIMES:
            continue
        value: Quantity = a.value
        before = p == "before" or (p == "by" and a.low == a.high)
        if p == "within" or a.bound == "max" or (before and a.bound is None):
            value = (0.05 * a.high, a.high)
        elif a.bound == "min":
            value = (a.low, 2.0 * a.low + 1.0)
        return value, a, "at" if p in ("at", "by") or a.measure == "start" else "after"
    return None


def record_event(
    d: Discourse,
    kind: NodeEvent,
    participants: tuple[str, ...],
    f: Frame,
    time: Time | None,
    **extra: Any,
) -> str:
    """Adds a point event with the stated time, absolute or relative."""
    mover = participants[0]
    if kind in _DOWN:
        _arrives_first(d, mover)
    if extra.get("stem") != "brake":
        settle(d, mover, kind, participants[1] if len(participants) > 1 else None)
    if kind is NodeEvent.FALL and time is not None and _lands_before(d, f, mover, time[1]):
        time = None  # "falls from the ceiling onto a table after 2 s": the time of the landing
        d.times.before_fall = (f, d.timeline.last_event)
    mate = mates_event(d, kind, participants, f) if kind is not NodeEvent.TRIGGER else None
    partner = mate or partner_of(d, kind, participants, f)
    if partner is not None:
        d.timeline.last_event = d.times.before.get(partner[0])
    told_before = d.timeline.last_event
    time, previous = _since_when(d, f, participants, time)
    at = time is not None and (previous is None or time[2] == "at") and kind is not NodeEvent.STOP
    when: dict[str, Any] = {"time": time[0], "prescribed": True} if at and time else {}
    node_id = d.timeline.event(kind, participants, describe(d, f), **when, **extra)
    draft = d.timeline.node(node_id)
    assert draft is not None
    d.times.of_frame.append((f, node_id))
    d.times.before[node_id] = told_before
    if time is not None:
        mark_used(d, time[1], f"time of {node_id}")
        if not at:
            _time_since(d, draft, time, previous)
    if mate is not None and lands_in_turn(kind, f):
        d.moves.outrun.append((mate[0], node_id))
    coincide(d, draft, partner)
    _ends_gap(d, draft, f, previous)
    _lasts_since(d, draft, mover)
    travelled = d.scene.travel.pop(mover, None)
    if travelled is not None:
        constrain(draft, "distance", travelled.value)
    mark_used(d, f, node_id)
    return node_id


def _arrives_first(d: Discourse, felled: str) -> None:
    """ "Throws a stone at a kite until it comes down": what was aimed at is hit before."""
    for name, (kind, f, other, time) in list(d.times.pending.items()):
        aimed = kind is NodeEvent.COLLISION and other is not None and felled != name
        mates = {*mates_of(d, name)}
        by_mate = any(
            other in n.participants and mates & {*n.participants} for n in d.timeline.nodes
        )
        if aimed and other is not None and moves(d, name) and not by_mate:
            del d.times.pending[name]
            d.add_event(kind, (name, other), f, time)


def _since_when(
    d: Discourse, f: Frame, participants: tuple[str, ...], time: Time | None
) -> tuple[Time | None, str | None]:
    """The stated time, unless it is used, and the event it counts from, None for the start."""
    previous = d.timeline.last_event
    if time is None:
        return None, previous
    if d.times.before_fall is not None and d.times.before_fall[0] is f:
        previous = d.times.before_fall[1]
    if not unread(d, time[1]):
        return None, previous
    if previous is not None and on_its_own(d, f, participants, time):
        time = (time[0], time[1], "at")
    return time, previous if later(d, time[1]) else _begun(d, previous, participants[0])


def _time_since(d: Discourse, draft: Draft, time: Time, previous: str | None) -> None:
    """States a time relative to an earlier event, and how long a stop takes."""
    if draft.event is not NodeEvent.STOP:
        constrain(draft, "time_since", time[0], since=previous)
        return
    braked = any(e.to == draft.id and e.event is EdgeEvent.BRAKE for e in d.timeline.edges)
    if (time[2] == "at" and time[1].bound is None) or (previous is None and not braked):
        draft.time, draft.time_prescribed = time[0], True
    elif braked:
        constrain(draft, "time_to_stop", time[0])
    else:
        constrain(draft, "time_since", time[0], since=previous)


def _begun(d: Discourse, previous: str | None, mover: str) -> str | None:
    """Where a change of speed began, if that is what came last; None at the start.

    "It slows down to 5 m/s and hits a cone after 4 s": not 4 s after it has slowed down.
    """
    node = d.timeline.node(previous) if previous is not None else None
    changes = node is not None and any(c.quantity == "speed_after" for c in node.constraints)
    if node is None or not changes or node.participants != (mover,):
        return previous
    changed = (EdgeEvent.BRAKE, EdgeEvent.ACCELERATED_MOTION)
    begun = next((e.from_ for e in d.timeline.edges if e.to == node.id and e.event in changed), "")
    return None if begun == START else begun or previous


def _lands_before(d: Discourse, f: Frame, mover: str, amount: Amount) -> bool:
    """Whether a clause says on what its mover lands, and only then a time."""
    for p in f.phrases:
        m = p.mention
        if m is None or p.prep not in ("onto", "on", "into", "in", "against"):
            continue
        there = [i for i in m.entities if i != mover and not structural(d, i)]
        if there and f.verb.start < m.start and m.end <= amount.start:
            return True
    return False


def _ends_gap(d: Discourse, draft: Draft, f: Frame, previous: str | None) -> None:
    """The span told before an event ends with it."""
    gap = d.times.gap
    if gap is None or d.times.gap_of is f or draft.event is NodeEvent.TRIGGER:
        return
    d.times.gap = d.times.gap_of = None
    if any(c.quantity in ("time_since", "time_to_stop") for c in draft.constraints):
        return  # it has a time of its own
    if previous is not None:
        constrain(draft, "time_since", gap.value, since=previous)
    elif draft.time is None:  # "for the first two seconds nothing happens"
        draft.time, draft.time_prescribed = gap.value, True
    else:
        return
    mark_used(d, gap, f"time of {draft.id}")


def _lasts_since(d: Discourse, draft: Draft, mover: str) -> None:
    """ "rolls for 2 s and then hits", "turns left, drives on for 4 s": since it set off."""
    if draft.time is not None or draft.event is NodeEvent.STOP:
        return
    ways = [
        (e.from_, e.params.duration)
        for e in d.timeline.edges
        if e.to == draft.id and e.actor == mover and e.params.duration
    ]
    for since, lasting in ways:
        if since == START and draft.time is None:
            draft.time, draft.time_prescribed = lasting, True
    timed = any(c.quantity == "time_since" for c in draft.constraints)
    for since, lasting in ways if draft.time is None and not timed else []:
        constrain(draft, "time_since", lasting, mover, since)


def settle(
    d: Discourse, actor: str | None, kind: NodeEvent | None, target: str | None = None
) -> None:
    """Turns a pending arrival or landing into an event, unless a stronger event replaces it."""
    for name in list(d.times.pending):
        if (actor is not None and name != actor) or name not in d.times.pending:
            continue
        event, f, other, time = d.times.pending.pop(name)
        into = kind in _MEETING and actor == name
        if event is NodeEvent.FALL and f.verb.sense == "fall" and (not into or _leaves(f)):
            d.add_event(event, (name,), f, time)
            continue
        sent = event is NodeEvent.REACH and kind_of(d, name) not in SELF_POWERED
        if sent and into and f.verb.lemma not in PUSHING:
            continue  # "throws the ball to a defender, and it hits the referee"
        if event in _MEETING and other is not None:
            _land_aim(d, f, name, other, kind, target, time)
            continue
        replaced = kind in _REPLACING and (event is NodeEvent.FALL or target in (other, None))
        if replaced or (event is NodeEvent.REACH and kind is NodeEvent.STOP):
            continue
        d.add_event(event, (name,) if other is None else (name, other), f, time)


def _leaves(f: Frame) -> bool:
    """ "falls off", "comes loose", "two drums fall down": a fall from what it stood on."""
    down = "down" in {*f.adverbs, f.verb.extra.get("particle", "")} and not f.phrases
    leaves = role(f, "source") is not None or {"off", "out"} & {*f.adverbs}
    return bool(leaves) or down or f.verb.lemma in ("come", "break", "detach")


def _land_aim(
    d: Discourse,
    f: Frame,
    name: str,
    other: str,
    kind: NodeEvent | None,
    target: str | None,
    time: Time | None,
) -> None:
    """What was thrown at something hits it, unless it does something else with it instead."""
    group = entity_of(d, other).group
    same = target == other or (
        target is not None and group is not None and entity_of(d, target).group == group
    )
    blocked = enterable(d, other) and kind is not None
    at_once = d.now.telling == (f.sentence, f.verb.start, "hit")
    elsewhere = (d.now.instead or at_once) and kind is NodeEvent.COLLISION
    if kind in (NodeEvent.MISS, NodeEvent.ENTER_REGION) or same or blocked or elsewhere:
        return
    if not moves(d, name):
        return
    mates, same = {*mates_of(d, name)}, {node for g, node in d.times.of_frame if g is f}
    for n in (n for n in d.timeline.nodes if n.id not in same):
        there = other in n.participants or str(n.extra.get("region", "")).startswith(f"{other}/")
        if there and n.event in (*_MEETING, NodeEvent.MISS) and mates & {*n.participants}:
            return  # "throws three stones at it; the last one knocks it off"
    if enterable(d, other):
        enter(d, f, name, other, time)
    else:
        d.add_event(NodeEvent.COLLISION, (name, other), f, time)
        d.moves.last_hit = (name, other)


def enterable(d: Discourse, node: str) -> bool:
    noun = entity_of(d, node).noun
    return noun.kind in ("region", "goal", "hole", "hoop", "water") or "goal" in noun.traits


def precedes(d: Discourse, a: Amount) -> bool:
    """Whether a time says how long before the next event: "2 seconds before B hits"."""
    return d.text[a.end : a.end + 8].lower().startswith(" before ")


def hand_on(d: Discourse, f: Frame) -> None:
    """ "closes the gap in 2 s and hits it": the time of what comes next in the sentence."""
    after = [g for g in d.told if g.sentence == f.sentence and g.verb.start > f.verb.start]
    following = next((g for g in after if not g.unreal), None)
    begins = f.verb.lemma in SETS_OFF or f.verb.extra.get("start")
    if f.verb.sense not in _ON_THE_WAY or begins or following is None:
        return  # "after 3 s it drives off and hits": when it sets off
    for p, a in amounts_of(d, f):
        free = a.dimension == "time" and not a.measure and d.times.gap is None and unread(d, a)
        if free and following.link != "purpose" and (p in _WITHIN or _LASTS.match(a.text)):
            within = a.bound == "max" or p == "within"
            d.times.gap = replace(a, low=0.05 * a.high) if within else a
            d.times.gap_of = f


def start_height(d: Discourse, bodies: list[str], a: Amount) -> None:
    """Things start this high above the ground."""
    if a.middle > HIGHEST_CM:
        d.scene.warnings.append(
            f'"{a.text}": what starts higher than {HIGHEST_CM / 100:g} m starts lower here.'
        )
        return
    for t in bodies:
        before = d.scene.heights.get(t)
        if before is None:
            d.scene.heights[t] = a.value
            d.timeline.start_constraints.append(
                EventConstraint(quantity="height", object=t, value=a.value)
            )
        elif before != a.value:
            low = before if isinstance(before, int | float) else before[0]
            told = f"{entity_of(d, t).label} starts at {low:g} cm and {a.low:g} cm"
            d.world.conflicts.append(told)
    mark_used(d, a, "start height")


def speed_after(d: Discourse, body: str, a: Amount) -> bool:
    """States how fast a body is after its last collision; whether it has had one."""
    for draft in reversed(d.timeline.nodes):
        if draft.event is NodeEvent.COLLISION and body in draft.participants:
            constrain(draft, "speed_after", a.value, body)
            mark_used(d, a, f"speed after {draft.id}")
            return True
    return False


def moved_by_others(d: Discourse, actor: str) -> bool:
    track = d.timeline.tracks.get(actor)
    return track is not None and track.hit and track.role is Role.PASSIVE


def is_airborne(d: Discourse, actor: str) -> bool:
    track = d.timeline.tracks.get(actor)
    if track is None:
        return False
    if track.motion is not None and track.motion.mode in ("throw", "drop", "fly"):
        return True
    return any(e.actor == actor and e.params.elevation_deg is not None for e in d.timeline.edges)


def enter(d: Discourse, f: Frame, actor: str, other: str, time: Time | None) -> None:
    """Something enters a goal, a pocket, a vessel or water."""
    noun = entity_of(d, other).noun
    if noun.kind == "region":
        host = next((i for i, e in d.world.entities.items() if e.noun.kind == "billiardtable"), "")
        # The noun's own name may say where: "side pocket".
        words = [*entity_of(d, other).adjectives, *entity_of(d, other).label.split()]
        region = f"{host or 'billiard_table_1'}/{pocket_name(words)}"
        d.scene.needs.append(("billiard_table", actor))
    else:
        region = f"{other}/inside"
    node = d.add_event(NodeEvent.ENTER_REGION, (actor,), f, time, region=region)
    draft = d.timeline.node(node)
    if draft is not None:
        draft.extra["region"] = region
