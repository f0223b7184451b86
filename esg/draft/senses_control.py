"""Verbs of control: accelerate, brake, slow, stop, park."""

from __future__ import annotations

from dataclasses import replace

from esg.draft.core import Time
from esg.draft.frames import Frame
from esg.draft.quantities import Amount
from esg.draft.scene import SELF_POWERED
from esg.draft.senses_outcome import OutcomeSenses
from esg.draft.tracks import Motion
from esg.draft.windows import Draft
from esg.graph.models import EventConstraint, NodeEvent, Quantity, Role

_SHOWN = frozenset({"show", "picture", "film", "animate", "render", "depict", "simulate", "draw"})
"""Requests whose participles tell what happens."""


class ControlSenses(OutcomeSenses):
    """Intentional changes of speed under own power."""

    def _do_accelerate(self, f: Frame, s: list[str], o: list[str]) -> None:
        able = [a for a in s or o if self.movable(a)]
        actors = [a for a in able if self._speeds_up(a) or not self._free_body(a)]
        if not actors and (s or o):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "gravity does it"
            return
        speeds = [(p, a) for p, a in self.amounts(f) if a.dimension == "speed"]
        rate = self.quantity(f, "acceleration")
        for actor in actors:
            self._wait(actor)
            track = self.tl.track(actor)
            if track.motion is not None and not track.closed and track.motion.mode == "own":
                time = self._time(f)
                self.event(NodeEvent.TRIGGER, (actor,), f, time)
            start: Quantity = (0.0, 500.0)
            prescribed = False
            params: dict[str, object] = {"acceleration": rate[1].value if rate else (50.0, 600.0)}
            final: Amount | None = None
            for p, a in speeds:
                self.use(a, "speed")
                if a.low != a.high and a.text.lower().startswith("from"):
                    start, prescribed = a.low, True
                    final = Amount("speed", a.high, a.high, a.start, a.end, a.text)
                elif p == "from":
                    start, prescribed = a.value, True
                elif p in ("to", "until", "up to", ""):
                    final = a
                else:
                    start, prescribed = a.value, True
            if track.motion is not None and track.motion.prescribed and not prescribed:
                start, prescribed = track.motion.speed or start, True
            if "from rest" in f.adverbs:
                start, prescribed = 0.0, True
            if rate is not None:
                self.use(rate[1], "acceleration")
            duration = next(
                (a for p, a in self.amounts(f) if a.dimension == "time" and p == "for"), None
            )
            if duration is not None:
                self.use(duration, "duration")
            self.tl.move(
                actor,
                Motion(
                    "accelerate",
                    start,
                    prescribed,
                    self.aim.get(actor),
                    params,
                    duration.value if duration else None,
                ),
                self._direction(actor, "own"),
            )
            if final is not None:
                node = self.tl.trigger(actor, f"{actor} has reached its speed")
                draft = self.tl.node(node)
                assert draft is not None
                draft.constraints.append(
                    EventConstraint(quantity="speed_after", object=actor, value=final.value)
                )
                time = self._time(f)
                if time is not None and (time[1].start, time[1].end) not in self.scene.used:
                    self.use(time[1], "time")
                    draft.time, draft.time_prescribed = time[0], True
                self.tl.move(actor, Motion("own", final.value, True), self._direction(actor, "own"))
                self.tl.track(actor).closed = True
        self.use(f, "acceleration")
        self._outcomes(f, actors)

    def _speeds_up(self, actor: str) -> bool:
        """Whether what was hit can drive, walk or fly faster by itself, as no cart does."""
        return self._moved_by_others(actor) and self.kind(actor) in SELF_POWERED - {"cart"}

    def _free_body(self, actor: str) -> bool:
        """Whether it was launched or hit, so that nothing drives it."""
        track = self.tl.tracks.get(actor)
        return self._moved_by_others(actor) or (track is not None and track.launched)

    def _brake(self, f: Frame, actor: str, time: Time | None) -> None:
        if not self.movable(actor):
            return
        track = self.tl.track(actor)
        if track.motion is None and not track.hit:
            self._start_motion(f, [actor])
        if track.motion is not None and track.motion.mode == "brake" and not track.closed:
            return
        self.event(NodeEvent.TRIGGER, (actor,), f, time, stem="brake")
        motion = self.tl.track(actor).motion
        target = motion.target if motion is not None else None
        self.tl.move(
            actor,
            Motion("brake", None, False, target, {"damping": (0.3, 6.0)}),
            self._direction(actor, "own"),
        )

    def _do_brake(self, f: Frame, s: list[str], o: list[str]) -> None:
        if self._slows_to(f):
            self._do_slow(f, s, o)
            return
        actors = s or [a for a, t in self.tl.tracks.items() if t.motion is not None][-1:]
        lasting = next((a for p, a in self.amounts(f) if self._lasts(p, a)), None)
        for actor in actors:
            time = self._time(f)
            self._brake(f, actor, None if time is not None and time[1] is lasting else time)
        if lasting is not None and actors:
            lasting = replace(lasting, high=lasting.low) if lasting.bound == "min" else lasting
            self.gap = lasting  # "brakes for 2 s and then hits"
        found = self.quantity(f, "speed")
        rate = self.quantity(f, "acceleration")
        for actor in actors if rate is not None else []:
            start = self._speed_before_brake(actor)
            if start is not None:
                self.rates[actor] = (rate[1], start)
        if found is not None and f.phrase("from") is None:
            self.use(found[1], "speed")
        self.use(f, "braking")

    def _slows_to(self, f: Frame) -> bool:
        """ "brakes to 5 m/s", "brakes from 15 m/s to 5 m/s": the speed that braking leaves."""
        found = self.quantity(f, "speed")
        if found is None:
            return False
        both = found[1].low < found[1].high and found[1].text.lower().startswith("from")
        return both or any(p in ("to", "down to") and a is found[1] for p, a in self.amounts(f))

    def _speed_before_brake(self, actor: str) -> float | None:
        """The stated speed with which it drives when it starts to brake [cm/s]."""
        for edge in reversed(self.tl.edges):
            if edge.actor == actor and edge.speed_is_prescribed:
                speed = edge.params.speed
                return speed if isinstance(speed, (int, float)) else None
        return None

    def _rate_of_braking(self, actor: str, node: str) -> None:
        """ "brakes at 3 m/s² from 9 m/s and stops": the time that this takes."""
        if actor not in self.rates:
            return
        amount, speed = self.rates.pop(actor)
        draft = self.tl.node(node)
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
        self.use(amount, "time to stop at this rate")

    def _do_slow(self, f: Frame, s: list[str], o: list[str]) -> None:
        actors = s or o
        final = next(
            (a for p, a in self.amounts(f) if a.dimension == "speed" and p in ("to", "")), None
        )
        initial: Amount | None = None
        if final is not None and final.low < final.high and final.text.lower().startswith("from"):
            # "from 20 m/s to 8 m/s"
            initial, final = replace(final, low=final.high), replace(final, high=final.low)
        initial = initial or next(
            (a for p, a in self.amounts(f) if a.dimension == "speed" and p == "from"), None
        )
        for actor in actors:
            if not self.movable(actor):
                self.scene.ignored[(f.verb.start, f.verb.end)] = "it cannot move"
                continue
            if initial is not None and not self._free_body(actor):
                self.use(initial, "speed")
                self._own(actor, initial.value, True)
            if self._free_body(actor):
                self.scene.ignored[(f.verb.start, f.verb.end)] = "friction slows it"
                continue
            self._brake(f, actor, self._time(f) if final is None else None)
            if final is not None:
                node = self.tl.trigger(actor, self.describe(f))
                draft = self.tl.node(node)
                assert draft is not None
                draft.constraints.append(
                    EventConstraint(quantity="speed_after", object=actor, value=final.value)
                )
                self.use(final, "speed after slowing")
                time = self._time(f)
                brake = next(
                    (n.id for n in reversed(self.tl.nodes[:-1]) if actor in n.participants), None
                )
                if time is not None and brake is not None:
                    draft.constraints.append(
                        EventConstraint(
                            quantity="time_since", object=actor, value=time[0], since=brake
                        )
                    )
                    self.use(time[1], "time")
                self.tl.move(actor, Motion("own", final.value, True), self._direction(actor, "own"))
                self.tl.track(actor).closed = True
        self.use(f, "slowing")

    def _do_stop(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and o and not f.verb.passive and s[0] != o[0] and self._under_way(o[0]):
            self._hit(f, o[:1], s[:1], self._time(f))  # "the goalie stops the puck"
            return
        blocks = bool(s) and bool(o) and not f.verb.passive and not self.movable(s[0])
        if blocks and self.tl.tracks.get(o[0]) is not None and self.movable(o[0]):
            self._hit(f, o[:1], s[:1], self._time(f))  # "until a wall stops it"
            self._stop(f, o[0], None)
            return
        actors = s or o
        if s and o and not f.verb.passive and set(s) != set(o) and self._halts(f, s, o):
            actors = o  # "a man stops it"
        actors = self._representatives(actors, []) if len(actors) > 2 else actors
        finite = f.relative and f.verb.form in ("s", "past") and not f.verb.passive
        tracks = [self.tl.tracks.get(a) for a in actors]
        told = finite and any(t is not None and t.under_way for t in tracks)
        brought = f.verb.passive and f.verb.lemma == "bring"
        if (f.reduced and not told and not self._shown(f)) or (
            f.verb.passive and not brought and not any(a in self.tl.tracks for a in actors)
        ):
            moving = [
                a for a in actors if a in self.tl.tracks and self.tl.tracks[a].motion is not None
            ]
            if not moving:
                self._do_be(f, s, o)
                return
        earlier, caught = self.tl.last_event, False
        if f.verb.passive:
            by = f.phrase("by")
            if by is not None and by.mention is not None and by.mention.entities:
                caught = bool(self._hit(f, actors, by.mention.entities))
        for actor in actors:
            if not self.movable(actor):
                continue
            time = self._time(f)
            if (time is None and self._stands_by_now(actor)) or self._hangs_still(actor):
                self.use(f, "stands already")  # "pulls up at a light and stops", "the clock stops"
                continue
            rest = f.phrase("against")
            if rest is not None and rest.mention is not None:
                self._hit(f, [actor], [i for i in rest.mention.entities if i != actor][:1])
            way = next(
                (a for p, a in self.amounts(f) if a.dimension == "length" and p == "after"), None
            )
            self._stop(f, actor, time)
            end = self.tl.node(self.tl.last_event or "")
            if caught and end is not None:
                self._count_from(end, earlier)
            if way is not None and end is not None:  # "stops after 30 m"
                end.constraints.append(
                    EventConstraint(quantity="distance", object=actor, value=way.value)
                )
                self.use(way, "distance travelled")
            self._pauses(f, actor)
        self._places_loosely(f, actors)

    @staticmethod
    def _shown(f: Frame) -> bool:
        """ "Show a motorcycle stopping": what is asked for, no state of it."""
        asked = f.parent
        return asked is not None and asked.subject is None and asked.verb.lemma in _SHOWN

    def _stands_by_now(self, actor: str) -> bool:
        """Whether the last thing told of an actor is that it stopped."""
        track = self.tl.tracks.get(actor)
        moves = track is not None and track.motion is not None and not track.closed
        last = next((n for n in reversed(self.tl.nodes) if actor in n.participants), None)
        return last is not None and last.event is NodeEvent.STOP and not moves

    def _hangs_still(self, actor: str) -> bool:
        """Whether it hangs on a wall or from a ceiling and nothing has moved it."""
        track = self.tl.tracks.get(actor)
        moved = track is not None and (track.motion is not None or track.hit)
        return actor in self.scene.attached and not moved

    @staticmethod
    def _count_from(end: Draft, earlier: str | None) -> None:
        """ "is stopped by a foot after 4 s": counted from what came before the foot."""
        for k, c in enumerate(end.constraints):
            if c.quantity != "time_since":
                continue
            if earlier is not None:
                end.constraints[k] = c.model_copy(update={"since": earlier})
            else:
                del end.constraints[k]
                end.time, end.time_prescribed = c.value, True
            return

    def _halts(self, f: Frame, s: list[str], o: list[str]) -> bool:
        """Whether the subject brings something else to a stop."""
        moved = self.tl.tracks.get(s[0])
        own = moved is not None and moved.motion is not None
        going = self.tl.tracks.get(o[0])
        afoot = self.kind(s[0]) in ("person", "animal", "robot")
        if own and afoot and going is not None and going.motion is not None:
            return self.movable(o[0])  # "runs after the cart and stops it"
        return f.object is not None and not own and self.movable(o[0])

    def _under_way(self, body: str) -> bool:
        track = self.tl.tracks.get(body)
        return track is not None and (track.launched or track.hit) and body not in SELF_POWERED

    def _pauses(self, f: Frame, actor: str) -> None:
        """ "stops for 3 s": the time until it moves on."""
        pause = next((a for p, a in self.amounts(f) if a.dimension == "time" and p == "for"), None)
        if pause is not None and self.kind(actor) in SELF_POWERED:
            self.waiting[actor] = pause
            self.use(pause, "waiting time")

    def _places_loosely(self, f: Frame, actors: list[str]) -> None:
        self.use(f, "stop")

    def _stop(self, f: Frame, actor: str, time: Time | None) -> None:
        track = self.tl.track(actor)
        last = next((n for n in reversed(self.tl.nodes) if actor in n.participants), None)
        resting = track.motion is None or track.closed
        if last is not None and last.event is NodeEvent.STOP and resting and not track.hit:
            self._time_of_told(last.id, time)
            self.use(f, last.id)  # "pulls up at the light and stops"
            return
        if track.motion is None and not track.hit:
            self._start_motion(f, [actor])
            track = self.tl.track(actor)
        motion = track.motion
        driven = motion is not None and motion.mode in ("own", "accelerate")
        if driven and track.role is Role.ACTIVE:
            self._brake(f, actor, None)
        node = self.event(NodeEvent.STOP, (actor,), f, time)
        if driven:  # "for 2 s it drives, then it brakes and stops": the brake is told
            self._stands_after(node)
        self._rate_of_braking(actor, node)
        self._stops_short(f, actor, node)

    def _stands_after(self, stop: str) -> None:
        """ "walks for 6 s and then stops": the stop ends the walk, not only the brake before it."""
        end = self.tl.node(stop)
        began = next((e.from_ for e in self.tl.edges if e.to == stop), "")
        brake = self.tl.node(began)
        lasted = any(e.to == began and e.params.duration for e in self.tl.edges)
        if end is None or brake is None or not lasted or not brake.time_prescribed:
            return
        if end.time is None and not end.constraints:
            end.time, end.time_prescribed = brake.time, True
            brake.time, brake.time_prescribed = None, False
            self.tl.forget_duration(began)

    def _do_park(self, f: Frame, s: list[str], o: list[str]) -> None:
        if (
            f.verb.passive
            or f.reduced
            or f.verb.form == "pp"
            or not s
            or self.kind(s[0]) not in SELF_POWERED
        ):
            self._do_be(f, s, o)
            return
        self._stop(f, s[0], self._time(f))
        self._places(f, s)
