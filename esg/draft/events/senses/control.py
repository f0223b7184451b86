"""Verbs of control: accelerate, brake, slow, stop, park."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.discourse.core import (
    aimable,
    amounts_of,
    describe,
    kind_of,
    mark_used,
    movable,
    quantity_of,
)
from esg.draft.discourse.event_coreference import time_of_told
from esg.draft.discourse.places import at_the_wheel
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.scene import LIMBED, SELF_POWERED
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event, add_hit, braking, outcomes
from esg.draft.events.lengths import stops_short
from esg.draft.events.motions import direction_of, lasts, moves_on_it, own, start_motion, wait
from esg.draft.events.roles import filling
from esg.draft.events.senses.state import places, read_be
from esg.draft.events.table import sense
from esg.draft.events.timing import moved_by_others, representatives, time_of
from esg.draft.events.told import (
    amount,
    at_rest,
    constrain,
    happened,
    ignore,
    last_of,
    moves,
    things,
    unread,
)
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount
from esg.graph.models import NodeEvent, Quantity, Role

_STOPPING_BY = (
    "in front of", "before", "next to", "near", "beside", "by", "at", "close to", "for", "short of",
)  # fmt: skip
_STOPPED_FOR = LIMBED | {"vehicle", "toyvehicle", "cart"}
STOPS_BY_CM = (20.0, 120.0)
"""Gap that is left by what stops in front of something [cm]."""
_STOPS_NEXT_CM = (10.0, 45.0)
"""Gap that is left by what stops beside something [cm]: nearer than `NEAR_END_M`, half a metre."""
_NEXT_TO = frozenset({"next to", "near", "beside", "by", "close to"})
_ROLLING = frozenset({"roll", "slide", "skid", "coast", "glide", "spin"})
"""Verbs of which "to a stop" says how they end, and "on" where they are all the while."""
_SHOWN = lex.word_set("shown")


def _from_to(a: Amount) -> bool:
    """Whether it is a change: "from 15 m/s to 5 m/s"."""
    return a.low != a.high and a.text.lower().startswith("from")


@sense("accelerate")
def read_accelerate(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    able = [a for a in s or o if movable(d, a)]
    actors = [a for a in able if _speeds_up(d, a) or not _free_body(d, a)]
    rate = amount(d, f, "acceleration")
    duration = amount(d, f, "time", "for")
    for actor in actors:
        wait(d, actor)
        track = d.timeline.track(actor)
        if moves(d, actor) and track.motion is not None and track.motion.mode == "own":
            add_event(d, NodeEvent.TRIGGER, (actor,), f, time_of(d, f))
        start, final = _speeds(d, f)
        if start is None and track.motion is not None and track.motion.prescribed:
            start = track.motion.speed
        if "from rest" in f.adverbs:
            start = 0.0
        mark_used(d, rate, "acceleration")
        mark_used(d, duration, "duration")
        motion = Motion(
            "accelerate",
            (0.0, 500.0) if start is None else start,
            start is not None,
            d.moves.aim.get(actor),
            {"acceleration": rate.value if rate else (50.0, 600.0)},
            duration.value if duration else None,
        )
        d.timeline.move(actor, motion, direction_of(d, actor, "own"))
        if final is not None:
            node = d.timeline.trigger(actor, f"{actor} has reached its speed")
            time = time_of(d, f)
            draft = d.timeline.node(node)
            if draft is not None and time is not None and unread(d, time[1]):
                mark_used(d, time[1], "time")
                draft.time, draft.time_prescribed = time[0], True
            _goes_on_at(d, actor, node, final)
    mark_used(d, f, "acceleration")
    outcomes(d, f, actors)


def _speeds(d: Discourse, f: Frame) -> tuple[Quantity | None, Amount | None]:
    """The speeds that an acceleration starts from and leads to."""
    start: Quantity | None = None
    final: Amount | None = None
    for p, a in amounts_of(d, f):
        if a.dimension != "speed":
            continue
        mark_used(d, a, "speed")
        if _from_to(a):
            start, final = a.low, replace(a, low=a.high)
        elif p in ("to", "until", "up to", ""):
            final = a
        else:
            start = a.value
    return start, final


def _goes_on_at(d: Discourse, actor: str, node: str, final: Amount) -> None:
    """From an event on it moves at the speed that a change of speed has led to."""
    constrain(d.timeline.node(node), "speed_after", final.value, actor)
    d.timeline.move(actor, Motion("own", final.value, True), direction_of(d, actor, "own"))
    d.timeline.track(actor).closed = True


def _speeds_up(d: Discourse, actor: str) -> bool:
    """Whether what was hit can drive, walk or fly faster by itself, as no cart does."""
    return moved_by_others(d, actor) and kind_of(d, actor) in SELF_POWERED - {"cart"}


def _free_body(d: Discourse, actor: str) -> bool:
    """Whether it was launched or hit, so that nothing drives it."""
    track = d.timeline.tracks.get(actor)
    return moved_by_others(d, actor) or (track is not None and track.launched)


def add_brake(d: Discourse, f: Frame, actor: str, time: Time | None) -> None:
    """What moves, or starts to move now, brakes from here on."""
    if not movable(d, actor):
        return
    if at_rest(d, actor):
        start_motion(d, f, [actor])
    if braking(d, actor) and moves(d, actor):
        return
    add_event(d, NodeEvent.TRIGGER, (actor,), f, time, stem="brake")
    motion = d.timeline.track(actor).motion
    target = motion.target if motion is not None else None
    brake = Motion("brake", None, False, target, {"damping": (0.3, 6.0)})
    d.timeline.move(actor, brake, direction_of(d, actor, "own"))


@sense("brake")
def read_brake(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    found = quantity_of(d, f, "speed")
    if found is not None and (_from_to(found[1]) or found[0] in ("to", "down to")):
        read_slow(d, f, s, o)  # "brakes to 5 m/s"
        return
    actors = s or [a for a, t in d.timeline.tracks.items() if t.motion is not None][-1:]
    lasting = next((a for p, a in amounts_of(d, f) if lasts(p, a)), None)
    rate = amount(d, f, "acceleration")
    for actor in actors:
        time = time_of(d, f)
        add_brake(d, f, actor, None if time is not None and time[1] is lasting else time)
        start = _speed_before_brake(d, actor)
        if rate is not None and start is not None:
            d.moves.rates[actor] = (rate, start)
    if lasting is not None and actors:  # "brakes for 2 s and then hits"
        d.times.gap = replace(lasting, high=lasting.low) if lasting.bound == "min" else lasting
    mark_used(d, f, "braking")


def _speed_before_brake(d: Discourse, actor: str) -> float | None:
    """The stated speed with which it drives when it starts to brake [cm/s]."""
    for edge in reversed(d.timeline.edges):
        if edge.actor == actor and edge.speed_is_prescribed:
            speed = edge.params.speed
            return speed if isinstance(speed, (int, float)) else None
    return None


def _rate_of_braking(d: Discourse, actor: str, node: str) -> None:
    """ "brakes at 3 m/s² from 9 m/s and stops": the time that this takes."""
    told, speed = d.moves.rates.pop(actor, (None, 0.0))
    draft = d.timeline.node(node)
    if draft is None or told is None or told.middle == 0.0:
        return
    if not any(c.quantity in ("time_to_stop", "time_since") for c in draft.constraints):
        constrain(draft, "time_to_stop", speed / abs(told.middle), actor)
        mark_used(d, told, "time to stop at this rate")


@sense("slow")
def read_slow(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "slows down from 20 m/s to 8 m/s": brakes, and goes on at the speed that is left."""
    final, initial = amount(d, f, "speed", "to", ""), amount(d, f, "speed", "from")
    if final is not None and final.low < final.high and _from_to(final):
        initial, final = replace(final, low=final.high), replace(final, high=final.low)
    for actor in s or o:
        if not movable(d, actor) or _free_body(d, actor):
            ignore(d, f, "friction slows it" if movable(d, actor) else "it cannot move")
            continue
        if initial is not None:
            mark_used(d, initial, "speed")
            own(d, actor, initial.value, True)
        add_brake(d, f, actor, time_of(d, f) if final is None else None)
        if final is None:
            continue
        brake, time = last_of(d, actor), time_of(d, f)
        node = d.timeline.trigger(actor, describe(d, f))
        mark_used(d, final, "speed after slowing")
        _goes_on_at(d, actor, node, final)
        if time is not None and brake is not None:
            constrain(d.timeline.node(node), "time_since", time[0], actor, since=brake.id)
            mark_used(d, time[1], "time")
    mark_used(d, f, "slowing")


@sense("stop")
def read_stop(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """Comes to rest by itself, or is brought to rest by what it meets."""
    on_other = bool(s and o) and not f.verb.passive and s[0] != o[0]
    on_other = on_other and "before" not in f.verb.extra  # "stops just before hitting a child"
    if on_other and _flies(d, o[0]):
        add_hit(d, f, o[:1], s[:1], time_of(d, f))  # "the goalie stops the puck"
        return
    blocks = on_other and not movable(d, s[0]) and movable(d, o[0]) and o[0] in d.timeline.tracks
    if blocks:
        add_hit(d, f, o[:1], s[:1], time_of(d, f))  # "until a wall stops it"
        _stop(d, f, o[0], None)
        return
    actors = o if on_other and _halts(d, f, s, o) else s or o
    actors = representatives(d, actors, []) if len(actors) > 2 else actors
    if _stands_there(d, f, actors):
        read_be(d, f, s, o)
        return
    if f.verb.passive:
        add_hit(d, f, actors, filling(f, "agent"))
    if f.verb.lemma in _ROLLING:  # "slides to a stop on a table"
        moves_on_it(d, f, [a for a in actors if at_rest(d, a)])
    for actor in [a for a in actors if movable(d, a)]:
        time = time_of(d, f)
        rest = things(f.phrase("against"))
        add_hit(d, f, [actor], [i for i in rest if i != actor][:1])
        _stop(d, f, actor, time)
        way = amount(d, f, "length", "after")
        if way is not None:  # "stops after 30 m"
            constrain(d.timeline.node(d.timeline.last_event or ""), "distance", way.value, actor)
            mark_used(d, way, "distance travelled")
        pause = amount(d, f, "time", "for")
        if pause is not None and kind_of(d, actor) in SELF_POWERED:
            d.moves.waiting[actor] = pause  # "stops for 3 s": until it moves on
            mark_used(d, pause, "waiting time")


def _stands_there(d: Discourse, f: Frame, actors: list[str]) -> bool:
    """ "A bicycle stopped in the road": a state of what has not moved."""
    tracks = [t for a in actors if (t := d.timeline.tracks.get(a)) is not None]
    if any(t.motion is not None for t in tracks):
        return False
    finite = f.relative and f.verb.form in ("s", "past") and not f.verb.passive
    told = finite and any(t.under_way for t in tracks)
    brought = f.verb.passive and f.verb.lemma == "bring"
    asked = f.parent  # "Show a motorcycle stopping"
    shown = asked is not None and asked.subject is None and asked.verb.lemma in _SHOWN
    reduced = f.reduced and not (told or shown or _there_is(f))
    return reduced or (f.verb.passive and not brought and not tracks)


def _there_is(f: Frame) -> bool:
    """ "There is a truck that stops near a gate": that it stops is all that is told of it."""
    told, finite = f.parent, f.verb.form == "s" and not f.verb.passive
    there = told is not None and told.verb.sense == "be" and "there" in told.adverbs
    return f.relative and finite and there


def _halts(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    """Whether the subject brings something else to a stop."""
    moved, going = d.timeline.tracks.get(s[0]), d.timeline.tracks.get(o[0])
    own = moved is not None and moved.motion is not None
    afoot = kind_of(d, s[0]) in LIMBED
    if own and afoot and going is not None and going.motion is not None:
        return movable(d, o[0])  # "runs after the cart and stops it"
    return f.object is not None and not own and movable(d, o[0])


def _flies(d: Discourse, body: str) -> bool:
    """Whether it was launched or hit."""
    track = d.timeline.tracks.get(body)
    return track is not None and (track.launched or track.hit)


def _stop(d: Discourse, f: Frame, actor: str, time: Time | None) -> None:
    """It comes to rest, braking if it drives."""
    track, last = d.timeline.track(actor), last_of(d, actor)
    resting = not moves(d, actor) and not track.hit
    if last is not None and last.event is NodeEvent.STOP and resting:
        time_of_told(d, last.id, time)
        mark_used(d, f, last.id)  # "pulls up at the light and stops"
        return
    if at_rest(d, actor):
        start_motion(d, f, [actor])
    driven = track.motion is not None and track.motion.mode in ("own", "accelerate")
    if driven and track.role is Role.ACTIVE:
        add_brake(d, f, actor, None)
    node = add_event(d, NodeEvent.STOP, (actor,), f, time)
    if driven:  # "for 2 s it drives, then it brakes and stops": the brake is told
        _stands_after(d, node)
    _rate_of_braking(d, actor, node)
    stops_short(d, f, actor, node)
    _stops_by(d, f, actor, node)


def _stops_by(d: Discourse, f: Frame, actor: str, node_id: str) -> None:
    """ "Stops in front of a gate": the gap that is left is small, and no hit comes of it."""
    node = d.timeline.node(node_id)
    beside = f.phrase(*_STOPPING_BY)
    if beside is not None and beside.prep == "for":  # not "stops for a second"
        beside = beside if any(kind_of(d, i) in _STOPPED_FOR for i in things(beside)) else None
    unmet = f.object.entities if f.object is not None and "before" in f.verb.extra else []
    others = [i for i in (*unmet, *things(beside)) if aimable(d, i) and i != actor]
    others = [i for i in others if not happened(d, NodeEvent.PICKED_UP, i)]
    if node is None or not others or node.constraints or f.verb.sense not in ("stop", "park"):
        return
    met = any({actor, others[0]} <= {*n.participants} for n in d.timeline.nodes)
    if not met and not moves(d, others[0]):
        near = beside is not None and beside.prep in _NEXT_TO and kind_of(d, actor) != "vehicle"
        gap = _STOPS_NEXT_CM if near else STOPS_BY_CM
        constrain(node, "distance", gap, actor, to=others[0])


def _stands_after(d: Discourse, stop: str) -> None:
    """ "walks for 6 s and then stops": the stop ends the walk, not only the brake before it."""
    end = d.timeline.node(stop)
    began = next((e.from_ for e in d.timeline.edges if e.to == stop), "")
    brake = d.timeline.node(began)
    lasted = any(e.to == began and e.params.duration for e in d.timeline.edges)
    if end is None or brake is None or not lasted or not brake.time_prescribed:
        return
    if end.time is None and not end.constraints:
        end.time, end.time_prescribed = brake.time, True
        brake.time, brake.time_prescribed = None, False
        d.timeline.forget_duration(began)


def _captioned(d: Discourse, f: Frame) -> bool:
    """ "A van parked outside a school": what a caption opens with has no act before it."""
    new = f.subject is not None and f.subject.determiner not in ("the", "this", "that")
    first = all(g.verb.start >= f.verb.start for g in d.told)
    return first and new and f.verb.form == "past" and not (f.adverbs or f.amounts or f.object)


@sense("park")
def read_park(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    reduced = f.reduced and not _there_is(f)
    stands = f.verb.passive or reduced or f.verb.form == "pp" or not s or _captioned(d, f)
    if stands or kind_of(d, s[0]) not in SELF_POWERED:
        read_be(d, f, s, o)
        return
    parked = [i for i in o if movable(d, i)] if kind_of(d, s[0]) == "person" else []
    if parked and kind_of(d, parked[0]) in SELF_POWERED:
        at_the_wheel(d, s, parked[0])
    _stop(d, f, (parked or s)[0], time_of(d, f))
    if not parked and not things(f.phrase(*_STOPPING_BY)):
        places(d, f, s)
