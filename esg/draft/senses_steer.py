"""Verbs of steering: turn, swerve, overtake, change lanes, reverse."""

from __future__ import annotations

from esg.draft.frames import Frame
from esg.draft.quantities import Amount, find_amounts
from esg.draft.senses_control import ControlSenses
from esg.draft.tracks import Motion
from esg.graph.models import EventConstraint, NodeEvent

_LEAST_TURN_S = 0.01
"""A turn told to last less has no rate of its own."""


def _rates(degrees: float, lasting: Amount | None) -> tuple[float, float]:
    """The rates of a turn [deg/s]: as long as it lasts, or what vehicles and walkers do."""
    if lasting is None or lasting.low < _LEAST_TURN_S:
        return (20.0, 120.0)
    return (0.9 * degrees / lasting.high, 1.1 * degrees / lasting.low)


class SteerSenses(ControlSenses):
    """Changes of heading and lane."""

    def _do_turn(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and not any(self.movable(a) for a in s):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "a fixed object does not turn"
            return
        driven = [i for i in o[:1] if self.kind(i) == "vehicle"]
        if driven and s and self.kind(s[0]) == "person" and f.subject is not None:
            self.mounts[id(f.subject)] = driven  # "The driver turns his car left and hits a tree"
            s, o = driven, []
        own = f.object is not None and f.object.determiner in ("its", "his", "her")
        own = own and not driven
        if own and f.object is not None and (not o or o[:1] != s[:1]):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "a part turns, not the whole"
            return
        words = [*f.adverbs, f.verb.extra.get("dir", "")]
        for p in f.phrases:
            if (p.mention is not None and p.mention.attribute) or (p.mention and p.mention.part):
                words += [p.mention.head, p.mention.part]
        span = self.text[f.verb.start : f.verb.end + 40].lower()
        sides = {"left": "left", "anticlockwise": "left", "counterclockwise": "left"}
        sides |= {"right": "right", "clockwise": "right"}
        direction = next((sides[w] for w in words if w in sides), "")
        if not direction:
            direction = "right" if " right" in span.split(".")[0] else "left"
        degrees = 180.0 if f.verb.extra.get("dir") in ("u", "around", "back") else 90.0
        amount = self.quantity(f, "angle")
        if amount is not None:
            degrees = max(1.0, min(720.0, abs(amount[1].middle)))
            self.use(amount[1], "turn angle")
        for a in find_amounts(self.text[f.verb.start : f.verb.end]):
            degrees = max(1.0, min(720.0, abs(a.middle)))  # "makes a 60-degree turn"
            self.scene.used[(f.verb.start + a.start, f.verb.start + a.end)] = "turn angle"
        actors = s or o
        if not actors:
            actors = [a for a, t in self.tl.tracks.items() if t.motion is not None][-1:]
        self._turn(f, actors, direction, degrees, NodeEvent.HEADING_REACHED)
        self._further_turns(f, actors, degrees)
        cross = f.phrase("at", "into", "onto", "down")
        if cross is not None:
            self.use(f, "turn")

    def _further_turns(self, f: Frame, actors: list[str], degrees: float) -> None:
        """ "turns right, then left": the turns after the first, each with its own angle."""
        sides = [x for x in f.adverbs if x in ("left", "right")]
        sides += [
            p.mention.head
            for p in f.phrases
            if p.mention is not None and p.mention.head in ("left", "right")
        ]
        angles = [a for _, a in self.amounts(f) if a.dimension == "angle"]
        for k, side in enumerate(sides[1:], 1):
            if k < len(angles):
                degrees = max(1.0, min(720.0, abs(angles[k].middle)))
                self.use(angles[k], "turn angle")
            self._turn(f, actors, side, degrees, NodeEvent.HEADING_REACHED)

    def _turn(
        self, f: Frame, actors: list[str], direction: str, degrees: float, kind: NodeEvent
    ) -> None:
        for actor in actors:
            if not self.movable(actor):
                continue
            track = self.tl.track(actor)
            if track.motion is None:
                self._start_motion(f, [actor], "own")
            time, ends = self._time(f), None
            lasting = self._lasting(f) if kind is NodeEvent.HEADING_REACHED else None
            time = None if lasting is not None else time
            if time is not None and (isinstance(time[0], tuple) or f.phrase("by") is not None):
                time, ends = None, time  # "turns right within 6 s": when the turn is done
            speed, prescribed = (
                (track.motion.speed, track.motion.prescribed) if track.motion else (None, False)
            )
            begin = self.event(NodeEvent.TRIGGER, (actor,), f, time, stem="turn_start")
            track.closed = True
            self.tl.move(
                actor,
                Motion(
                    "turn",
                    speed,
                    prescribed,
                    None,
                    {
                        "turn_direction": direction,
                        "turn_degrees": degrees,
                        "turn_rate_deg_s": _rates(degrees, lasting),
                    },
                ),
                self._direction(actor, "own"),
            )
            end = self.event(
                kind, (actor,), f, ends, turn_direction=direction, turn_degrees=degrees
            )
            done = self.tl.node(end)
            if lasting is not None and done is not None:
                done.constraints.append(
                    EventConstraint(
                        quantity="time_since", object=actor, value=lasting.value, since=begin
                    )
                )
                self.use(lasting, f"duration of the turn up to {end}")

    def _lasting(self, f: Frame) -> Amount | None:
        """ "turns right by 90 degrees in 1 s": how long it takes, if the angle is stated too."""
        if self.quantity(f, "angle") is None:
            return None
        times = [p.amount for p in f.phrases if p.amount and p.prep in ("in", "over", "during")]
        return next((a for a in times if a.dimension == "time" and a.measure != "start"), None)

    def _do_swerve(self, f: Frame, s: list[str], o: list[str]) -> None:
        sides = {p.mention.head for p in f.phrases if p.mention is not None} | {*f.adverbs}
        if f.verb.lemma == "dodge" and not sides & {"left", "right"}:
            self._read_as("avoid", f, s, o)  # it says that it is not hit, not where it goes
            return
        direction = (
            "right"
            if "right" in f.adverbs
            or any(p.mention and p.mention.head == "right" for p in f.phrases)
            else "left"
        )
        amount = self.quantity(f, "angle")
        degrees = amount[1].middle if amount is not None else 30.0
        if amount is not None:
            self.use(amount[1], "turn angle")
        self._turn(f, s, direction, degrees, NodeEvent.HEADING_REACHED)
        avoided = o
        around = f.phrase("around", "past")
        if around is not None and around.mention is not None:
            avoided = around.mention.entities
        for actor in s:
            for other in avoided[:1]:
                if other != actor and not self.structural(other):
                    self.event(NodeEvent.MISS, (actor, other), f, None)
        into = f.phrase("into")
        if into is not None and into.mention is not None:
            self._outcomes(f, s)

    def _do_overtake(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            s, o = (list(by.mention.entities) if by and by.mention else []), s
        for actor in s:
            track = self.tl.tracks.get(actor)
            if track is None or track.motion is None:
                self._start_motion(f, [actor])
            for other in self.each_passed(f, o):
                if other != actor and not self.structural(other):
                    if other == o[0]:
                        self.place([actor], [other], "behind")
                    self.event(NodeEvent.MISS, (actor, other), f, self._time(f), stem="overtakes")
        self.use(f, "overtaking")

    def _do_merge(self, f: Frame, s: list[str], o: list[str]) -> None:
        """A change of lane keeps the heading: it is motion."""
        self._motion(f, s, None)
        self.use(f, "change of lane")

    def _do_reverse(self, f: Frame, s: list[str], o: list[str]) -> None:
        actors = s or o
        self._motion(f, actors, "own")
        self._reverse(actors)
