"""Verbs of control: accelerate, brake, slow, stop, park."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.discourse.core import amounts_of, describe, kind_of, mark_used, movable, quantity_of
from esg.draft.discourse.event_coreference import time_of_told
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.discourse.tracks import Motion
from esg.draft.events.acts import add_event, add_hit, outcomes
from esg.draft.events.lengths import stops_short
from esg.draft.events.motions import direction_of, lasts, own, start_motion, wait
from esg.draft.events.senses.state import places, read_be
from esg.draft.events.table import sense
from esg.draft.events.timing import moved_by_others, representatives, time_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.quantities import Amount
from esg.graph.models import EventConstraint, NodeEvent, Quantity, Role

_SHOWN = lex.word_set("shown")


@sense("accelerate")
def read_accelerate(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    able = [a for a in s or o if movable(d, a)]
    actors = [a for a in able if _speeds_up(d, a) or not _free_body(d, a)]
    speeds = [(p, a) for p, a in amounts_of(d, f) if a.dimension == "speed"]
    rate = quantity_of(d, f, "acceleration")
    for actor in actors:
        wait(d, actor)
        track = d.timeline.track(actor)
        if track.motion is not None and not track.closed and track.motion.mode == "own":
            time = time_of(d, f)
            add_event(d, NodeEvent.TRIGGER, (actor,), f, time)
        start: Quantity = (0.0, 500.0)
        prescribed = False
        params: dict[str, object] = {"acceleration": rate[1].value if rate else (50.0, 600.0)}
        final: Amount | None = None
        for p, a in speeds:
            mark_used(d, a, "speed")
            if a.low != a.high and a.text.lower().startswith("from"):
                start, prescribed = a.low, True
                final = Amount("speed", a.high, a.high, a.start, a.end, a.text)
            elif p in ("to", "until", "up to", ""):
                final = a
            else:
                start, prescribed = a.value, True
        if track.motion is not None and track.motion.prescribed and not prescribed:
            start, prescribed = track.motion.speed or start, True
        if "from rest" in f.adverbs:
            start, prescribed = 0.0, True
        if rate is not None:
            mark_used(d, rate[1], "acceleration")
        duration = next(
            (a for p, a in amounts_of(d, f) if a.dimension == "time" and p == "for"), None
        )
        if duration is not None:
            mark_used(d, duration, "duration")
        d.timeline.move(
            actor,
            Motion(
                "accelerate",
                start,
                prescribed,
                d.moves.aim.get(actor),
                params,
                duration.value if duration else None,
            ),
            direction_of(d, actor, "own"),
        )
        if final is not None:
            node = d.timeline.trigger(actor, f"{actor} has reached its speed")
            draft = d.timeline.node(node)
            assert draft is not None
            draft.constraints.append(
                EventConstraint(quantity="speed_after", object=actor, value=final.value)
            )
            time = time_of(d, f)
            if time is not None and (time[1].start, time[1].end) not in d.scene.used:
                mark_used(d, time[1], "time")
                draft.time, draft.time_prescribed = time[0], True
            d.timeline.move(actor, Motion("own", final.value, True), direction_of(d, actor, "own"))
            d.timeline.track(actor).closed = True
    mark_used(d, f, "acceleration")
    outcomes(d, f, actors)


def _speeds_up(d: Discourse, actor: str) -> bool:
    """Whether what was hit can drive, walk or fly faster by itself, as no cart does."""
    return moved_by_others(d, actor) and kind_of(d, actor) in SELF_POWERED - {"cart"}


def _free_body(d: Discourse, actor: str) -> bool:
    """Whether it was launched or hit, so that nothing drives it."""
    track = d.timeline.tracks.get(actor)
    return moved_by_others(d, actor) or (track is not None and track.launched)


def add_brake(d: Discourse, f: Frame, actor: str, time: Time | None) -> None:
    if not movable(d, actor):
        return
    track = d.timeline.track(actor)
    if track.motion is None and not track.hit:
        start_motion(d, f, [actor])
    if track.motion is not None and track.motion.mode == "brake" and not track.closed:
        return
    add_event(d, NodeEvent.TRIGGER, (actor,), f, time, stem="brake")
    motion = d.timeline.track(actor).motion
    target = motion.target if motion is not None else None
    d.timeline.move(
        actor,
        Motion("brake", None, False, target, {"damping": (0.3, 6.0)}),
        direction_of(d, actor, "own"),
    )


@sense("brake")
def read_brake(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if _slows_to(d, f):
        read_slow(d, f, s, o)
        return
    actors = s or [a for a, t in d.timeline.tracks.items() if t.motion is not None][-1:]
    lasting = next((a for p, a in amounts_of(d, f) if lasts(p, a)), None)
    for actor in actors:
        time = time_of(d, f)
        add_brake(d, f, actor, None if time is not None and time[1] is lasting else time)
    if lasting is not None and actors:
        lasting = replace(lasting, high=lasting.low) if lasting.bound == "min" else lasting
        d.times.gap = lasting  # "brakes for 2 s and then hits"
    rate = quantity_of(d, f, "acceleration")
    for actor in actors if rate is not None else []:
        start = _speed_before_brake(d, actor)
        if start is not None:
            d.moves.rates[actor] = (rate[1], start)
    mark_used(d, f, "braking")


def _slows_to(d: Discourse, f: Frame) -> bool:
    """ "brakes to 5 m/s", "brakes from 15 m/s to 5 m/s": the speed that braking leaves."""
    found = quantity_of(d, f, "speed")
    if found is None:
        return False
    both = found[1].low < found[1].high and found[1].text.lower().startswith("from")
    return both or any(p in ("to", "down to") and a is found[1] for p, a in amounts_of(d, f))


def _speed_before_brake(d: Discourse, actor: str) -> float | None:
    """The stated speed with which it drives when it starts to brake [cm/s]."""
    for edge in reversed(d.timeline.edges):
        if edge.actor == actor and edge.speed_is_prescribed:
            speed = edge.params.speed
            return speed if isinstance(speed, (int, float)) else None
    return None


def _rate_of_braking(d: Discourse, actor: str, node: str) -> None:
    """ "brakes at 3 m/s² from 9 m/s and stops": the time that this takes."""
    if actor not in d.moves.rates:
        return
    amount, speed = d.moves.rates.pop(actor)
    draft = d.timeline.node(node)
    rate = abs(amount.middle)
    if (
        draft is None
        or rate <= 0.0
        or any(c.quantity in ("time_to_stop", "time_since") for c in draft.constraints)
    ):
        return
    draft.constraints.append(
        EventConstraint(quantity="time_to_stop", object=actor, value=speed / rate)
    )
    mark_used(d, amount, "time to stop at this rate")


@sense("slow")
def read_slow(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    actors = s or o
    final = next(
        (a for p, a in amounts_of(d, f) if a.dimension == "speed" and p in ("to", "")), None
    )
    initial: Amount | None = None
    if final is not None and final.low < final.high and final.text.lower().startswith("from"):
        # "from 20 m/s to 8 m/s"
        initial, final = replace(final, low=final.high), replace(final, high=final.low)
    initial = initial or next(
        (a for p, a in amounts_of(d, f) if a.dimension == "speed" and p == "from"), None
    )
    for actor in actors:
        if not movable(d, actor):
            d.scene.ignored[(f.verb.start, f.verb.end)] = "it cannot move"
            continue
        if initial is not None and not _free_body(d, actor):
            mark_used(d, initial, "speed")
            own(d, actor, initial.value, True)
        if _free_body(d, actor):
            d.scene.ignored[(f.verb.start, f.verb.end)] = "friction slows it"
            continue
        add_brake(d, f, actor, time_of(d, f) if final is None else None)
        if final is not None:
            node = d.timeline.trigger(actor, describe(d, f))
            draft = d.timeline.node(node)
            assert draft is not None
            draft.constraints.append(
                EventConstraint(quantity="speed_after", object=actor, value=final.value)
            )
            mark_used(d, final, "speed after slowing")
            time = time_of(d, f)
            brake = next(
                (n.id for n in reversed(d.timeline.nodes[:-1]) if actor in n.participants), None
            )
            if time is not None and brake is not None:
                draft.constraints.append(
                    EventConstraint(quantity="time_since", object=actor, value=time[0], since=brake)
                )
                mark_used(d, time[1], "time")
            d.timeline.move(actor, Motion("own", final.value, True), direction_of(d, actor, "own"))
            d.timeline.track(actor).closed = True
    mark_used(d, f, "slowing")


@sense("stop")
def read_stop(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if s and o and not f.verb.passive and s[0] != o[0] and _under_way(d, o[0]):
        add_hit(d, f, o[:1], s[:1], time_of(d, f))  # "the goalie stops the puck"
        return
    actors = s or o
    if s and o and not f.verb.passive and set(s) != set(o) and _halts(d, f, s, o):
        actors = o  # "a man stops it"
    actors = representatives(d, actors, []) if len(actors) > 2 else actors
    finite = f.relative and f.verb.form in ("s", "past") and not f.verb.passive
    tracks = [d.timeline.tracks.get(a) for a in actors]
    told = finite and any(t is not None and t.under_way for t in tracks)
    brought = f.verb.passive and f.verb.lemma == "bring"
    if (f.reduced and not told and not _shown(f)) or (
        f.verb.passive and not brought and not any(a in d.timeline.tracks for a in actors)
    ):
        moving = [
            a for a in actors if a in d.timeline.tracks and d.timeline.tracks[a].motion is not None
        ]
        if not moving:
            read_be(d, f, s, o)
            return
    if f.verb.passive:
        by = f.phrase("by")
        if by is not None and by.mention is not None and by.mention.entities:
            caught = bool(add_hit(d, f, actors, by.mention.entities))
    for actor in actors:
        if not movable(d, actor):
            continue
        time = time_of(d, f)
        rest = f.phrase("against")
        if rest is not None and rest.mention is not None:
            add_hit(d, f, [actor], [i for i in rest.mention.entities if i != actor][:1])
        way = next(
            (a for p, a in amounts_of(d, f) if a.dimension == "length" and p == "after"), None
        )
        _stop(d, f, actor, time)
        end = d.timeline.node(d.timeline.last_event or "")
        if way is not None and end is not None:  # "stops after 30 m"
            end.constraints.append(
                EventConstraint(quantity="distance", object=actor, value=way.value)
            )
            mark_used(d, way, "distance travelled")
        _pauses(d, f, actor)


def _shown(f: Frame) -> bool:
    """ "Show a motorcycle stopping": what is asked for, no state of it."""
    asked = f.parent
    return asked is not None and asked.subject is None and asked.verb.lemma in _SHOWN


def _halts(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    """Whether the subject brings something else to a stop."""
    moved = d.timeline.tracks.get(s[0])
    own = moved is not None and moved.motion is not None
    going = d.timeline.tracks.get(o[0])
    afoot = kind_of(d, s[0]) in ("person", "animal", "robot")
    if own and afoot and going is not None and going.motion is not None:
        return movable(d, o[0])  # "runs after the cart and stops it"
    return f.object is not None and not own and movable(d, o[0])


def _under_way(d: Discourse, body: str) -> bool:
    track = d.timeline.tracks.get(body)
    return track is not None and (track.launched or track.hit) and body not in SELF_POWERED


def _pauses(d: Discourse, f: Frame, actor: str) -> None:
    """ "stops for 3 s": the time until it moves on."""
    pause = next((a for p, a in amounts_of(d, f) if a.dimension == "time" and p == "for"), None)
    if pause is not None and kind_of(d, actor) in SELF_POWERED:
        d.moves.waiting[actor] = pause
        mark_used(d, pause, "waiting time")


def _stop(d: Discourse, f: Frame, actor: str, time: Time | None) -> None:
    track = d.timeline.track(actor)
    last = next((n for n in reversed(d.timeline.nodes) if actor in n.participants), None)
    resting = track.motion is None or track.closed
    if last is not None and last.event is NodeEvent.STOP and resting and not track.hit:
        time_of_told(d, last.id, time)
        mark_used(d, f, last.id)  # "pulls up at the light and stops"
        return
    if track.motion is None and not track.hit:
        start_motion(d, f, [actor])
        track = d.timeline.track(actor)
    motion = track.motion
    driven = motion is not None and motion.mode in ("own", "accelerate")
    if driven and track.role is Role.ACTIVE:
        add_brake(d, f, actor, None)
    node = add_event(d, NodeEvent.STOP, (actor,), f, time)
    if driven:  # "for 2 s it drives, then it brakes and stops": the brake is told
        _stands_after(d, node)
    _rate_of_braking(d, actor, node)
    stops_short(d, f, actor, node)


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


@sense("park")
def read_park(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    if (
        f.verb.passive
        or f.reduced
        or f.verb.form == "pp"
        or not s
        or kind_of(d, s[0]) not in SELF_POWERED
    ):
        read_be(d, f, s, o)
        return
    _stop(d, f, s[0], time_of(d, f))
    places(d, f, s)
