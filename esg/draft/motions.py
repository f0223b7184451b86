"""Motions: how fast, in which way and towards what an actor starts to move."""

from __future__ import annotations

from esg.draft.frames import Frame
from esg.draft.leftovers import SETS_OFF, Leftovers
from esg.draft.quantities import Amount
from esg.draft.scene import SELF_POWERED, SPEEDS, Relation
from esg.draft.timeline import LAUNCHES, START
from esg.draft.tracks import Motion
from esg.graph.models import EventConstraint, ForceDirection, NodeEvent, Quantity

_AIRBORNE = frozenset({"projectile", "tool", "tableware", "book", "rock"})


_TALL_CM = 50.0

_IN_THE_AIR = frozenset({"fly", "soar", "cruise", "glide", "flutter", "swoop", "hover", "dive"})
_ON_WHEELS = frozenset({"taxi", "roll", "drive", "skid", "slide", "park", "coast"})
_WITH_OFF = frozenset({"drive", "pull", "take", "move", "head", "ride", "walk", "set", "go"})
"""Verbs that say that something sets off only with "off", "away" or "out"."""
_WINGED = frozenset({"bee", "butterfly", "fly", "beetle", "dragonfly", "wasp", "moth", "bat"})


class Motions(Leftovers):
    """Starts motions."""

    def _outcomes(self, f: Frame, actors: list[str]) -> None:
        raise NotImplementedError

    def _speed(self, f: Frame, actors: list[str], mode: str) -> tuple[Quantity | None, bool]:
        found = self.quantity(f, "speed")
        own = next((self.own_speed[x] for x in actors if x in self.own_speed), None)
        if own is not None:
            found = ("at", own)
        stated = next((self.stated[x] for x in actors if x in self.stated), None)
        if found is None and stated is not None:
            found = ("at", stated)
        if found is not None:
            self.use(found[1], "speed")
            a = found[1]
            falling = f.verb.sense in ("brake", "slow", "stop")
            if falling and a.low < a.high and a.text.lower().startswith("from"):
                return a.high, True  # "brakes from 15 m/s to 5 m/s"
            if a.bound == "min":
                return (a.low, 2.0 * a.low), True
            if a.bound == "max":
                return (0.04 * a.high, a.high), True
            return a.value, True
        kind = self.kind(actors[0]) if actors else "ball"
        if mode in LAUNCHES:
            if kind in ("billiard", "projectile"):
                return SPEEDS[kind], False
            return SPEEDS[mode], False
        return SPEEDS.get(kind, (50.0, 600.0)), False

    def _flies_itself(self, actor: str) -> bool:
        """Whether it stays in the air by its own power: aircraft, birds, winged insects."""
        e = self.e(actor)
        winged = e.noun.material == "feather" or e.label.rpartition(" ")[2] in _WINGED
        return e.noun.kind == "flyer" or (e.noun.kind == "animal" and winged)

    def _direction(self, actor: str, mode: str) -> ForceDirection:
        flies = self.kind(actor) == "flyer" and actor not in self.taxiing
        if mode in ("throw", "drop", "fly") or flies or actor in self.flying:
            return ForceDirection.ANY_3D
        if mode in LAUNCHES:
            return ForceDirection.HORIZONTAL_PLANE
        return ForceDirection.ALONG_FORWARD_ONLY

    def _launch(
        self,
        actor: str,
        mode: str,
        speed: Quantity | None,
        prescribed: bool,
        target: str | None = None,
    ) -> None:
        params: dict[str, object] = {}
        if mode == "throw" or mode == "fly":
            params = {"elevation_deg": (-10.0, 60.0), "spin": "none"}
        elif mode == "drop":
            params, speed = {"elevation_deg": -90.0, "spin": "none"}, 0.0
        elif mode == "roll":
            noun = self.e(actor).noun  # coins, barrels and tyres roll on their rim
            rolls = "round" in noun.traits or noun.shape == "cylinder"
            params = {"spin": "roll" if rolls else "slide"}
        elif mode == "slide":
            params = {"spin": "slide"}
        self.tl.move(
            actor, Motion(mode, speed, prescribed, target, params), self._direction(actor, mode)
        )

    def _wait(self, actor: str) -> None:
        """Stands still for the stated time before the motion that is about to start."""
        amount = self.waiting.pop(actor, None)
        track = self.tl.track(actor)
        if amount is None or (track.motion is not None and not track.closed):
            return
        since = track.at
        if since != START and self.tl.node(since) is None:
            return
        begin = None if since == START else since
        node = self._stand(actor, amount.value, begin, f"{actor} has waited {amount.text}")
        self.use(amount, f"time of {node}")

    def _sets_off_late(self, f: Frame, actors: list[str]) -> None:
        """ "After 3 s it drives off", "starts to roll at 2 s": it stands still until then."""
        begins = f.verb.lemma in SETS_OFF or f.verb.extra.get("start")
        if f.verb.lemma in _WITH_OFF:  # not "after 3 s a car drives into a wall"
            words = {*self.text[f.verb.start : f.verb.end].lower().split(), *f.adverbs}
            begins = bool(words & {"off", "away", "out", "again", "on"})
        met = f.phrase("into", "against", "onto") is not None
        time = self._time(f) if begins and not met else None
        for actor in actors:
            track = self.tl.track(actor)
            if time is None or track.motion is not None or not self.movable(actor):
                continue
            since = track.at if track.at != START else self.tl.last_event
            if time[2] == "at" or self._on_its_own(f, (actor,), time):
                since = None
            self._stand(actor, time[0], since, f"{actor} sets off")
            self.use(time[1], "when it sets off")

    def _stand(self, actor: str, until: Quantity, since: str | None, description: str) -> str:
        """Stands still for a time since an event, or until a time since the start."""
        self.tl.move(actor, Motion("own", 0.0), self._direction(actor, "own"))
        node = self.tl.trigger(actor, description)
        draft = self.tl.node(node)
        assert draft is not None
        if since is None:
            draft.time, draft.time_prescribed = until, True
        else:
            draft.constraints.append(
                EventConstraint(quantity="time_since", object=actor, value=until, since=since)
            )
        return node

    def _own(
        self, actor: str, speed: Quantity | None, prescribed: bool, target: str | None = None
    ) -> None:
        self._wait(actor)
        self.tl.move(actor, Motion("own", speed, prescribed, target), self._direction(actor, "own"))

    def _start_motion(
        self, f: Frame, actors: list[str], mode: str | None = None, target: str | None = None
    ) -> None:
        for actor in actors:
            if not self.movable(actor):
                continue
            chosen = mode or self._natural(actor)
            if f.verb.lemma in _IN_THE_AIR and self._flies_itself(actor):
                self.flying.add(actor)
            elif f.verb.lemma in _ON_WHEELS and actor not in self.flying:
                self.taxiing.add(actor)
            speed, prescribed = self._speed(f, [actor], chosen)
            if chosen in LAUNCHES:
                self._launch(actor, chosen, speed, prescribed, target)
            else:
                self._own(actor, speed, prescribed, target)

    @staticmethod
    def each_passed(f: Frame, o: list[str]) -> list[str]:
        """What is passed one by one: "a bus and a van", "both"; of a plural its first member."""
        m = f.object
        if m is None or f.verb.passive:
            return o[:1]
        if m.pronoun in ("both", "each") or m.determiner in ("both", "each"):
            return o[:3]
        named = [x.entities[0] for x in (m, *m.coordinated) if x.entities and not x.attribute]
        listed = [i for i in dict.fromkeys(named) if i in o]
        return listed if m.coordinated and len(listed) > 1 else o[:1]

    def _natural(self, actor: str) -> str:
        kind = self.kind(actor)
        if kind in SELF_POWERED:
            return "own"
        if kind in _AIRBORNE:
            return "throw"
        return "roll" if "round" in self.e(actor).noun.traits else "slide"

    def _target(self, f: Frame, avoid: list[str]) -> list[str]:
        p = f.phrase(
            "towards", "toward", "at", "to", "into", "onto", "against", "after", "on", "in"
        )
        if p is None or p.mention is None:
            return []
        return [i for i in p.mention.entities if i not in avoid]

    def _motion(self, f: Frame, actors: list[str], mode: str | None) -> None:
        """Common part of all self motion: speed, target, and what the phrases say happens."""
        mounted = [self.scene.supported_by.get(a, "") for a in actors]
        riding = all(m and self.kind(m) in SELF_POWERED | {"sliding"} for m in mounted)
        if actors and riding and self.kind(actors[0]) == "person":
            actors = list(dict.fromkeys(mounted))  # "a man on a bicycle rides"
            if f.subject is not None:
                self.mounts[id(f.subject)] = actors
        speeds = [a for _, a in self.amounts(f) if a.dimension == "speed"]
        if len(speeds) == len(actors) > 1:
            self.own_speed = dict(zip(actors, speeds, strict=True))
        if not actors:
            self.scene.warnings.append(
                f'It is not clear what "{self.text[f.verb.start : f.verb.end]}" moves.'
            )
            return
        target = self._target(f, actors)
        aim = next((t for t in target if self._aimable(t)), None)
        self._sets_off_late(f, actors)
        told = [(a, self.tl.tracks.get(a)) for a in actors]
        fresh = [a for a, t in told if t is None or (t.motion is None and not t.hit)]
        for actor in actors:
            if aim is not None:
                self.aim[actor] = aim
            if self._moved_by_others(actor) and (
                mode != "own" or self.kind(actor) not in SELF_POWERED
            ):
                continue
            track = self.tl.tracks.get(actor)
            if (
                track is not None
                and track.launched
                and track.motion is not None
                and mode in (None, *LAUNCHES)
            ):
                stated = self.quantity(f, "speed")
                if stated is not None and not track.closed:
                    track.motion.speed, track.motion.prescribed = self._speed(
                        f, [actor], track.motion.mode
                    )
                if aim is not None and not track.closed:
                    track.motion.target = aim
                continue
            if f.verb.extra.get("continue") and track is not None and track.motion is not None:
                continue
            if track is not None and self._skids(f, actor):
                continue
            self._start_motion(f, [actor], mode, aim)
        found = self.quantity(f, "speed")
        if found is not None and actors and all(self._moved_by_others(a) for a in actors):
            self._speed_after(actors[0], found[1])
        elif found is not None and len(actors) == 1:
            self._speed_told_late(f, actors[0], found[1])
        self._order_of(f, actors)
        self.use(f, "motion")
        self._distance(f, actors, aim)
        if "off" in f.adverbs:
            if f.verb.sense in ("roll", "slide") and f.phrase("off", "from") is None:
                self._on_what_was_hit(f, fresh)  # "bumps the shelf; two candles roll off"
            for actor in actors:
                slid = f.verb.lemma in ("slide", "slip") and self._lies_on_something(actor)
                came = actor in self.came_down and f.verb.lemma in ("roll", "tumble")
                slid = slid or (came and self._lies_on_something(actor))
                held = actor in self.scene.supported_by or self.e(actor).pattern == "stack"
                held = held or (actor in fresh and self._tipped(actor))
                if held or slid:
                    self.event(NodeEvent.FALL, (actor,), f, self._time(f))
        duration = next((a for p, a in self.amounts(f) if self._lasts(p, a)), None)
        if duration is not None:
            for actor in actors:
                track = self.tl.tracks.get(actor)
                motion = track.motion if track is not None else None
                falls = f.verb.sense in ("fall", "drop")
                if motion is None or motion.mode in ("brake", "coast") or falls:
                    self.gap, self.gap_of = duration, f  # "brakes, skids for 2 s and slams into"
                    continue
                motion.duration = duration.value
            self.use(duration, "duration")
        self._outcomes(f, actors)

    @staticmethod
    def _lasts(prep: str, a: Amount) -> bool:
        """Whether a time says how long a motion lasts: "for", "over", "during the first 2 s"."""
        first = a.text.lower().startswith(("for the", "during the", "over", "through"))
        return a.dimension == "time" and (prep == "for" or first)

    def _skids(self, f: Frame, actor: str) -> bool:
        """ "brakes, skids for 2 s": sliding on locked wheels is how it brakes."""
        motion = self.tl.track(actor).motion
        return f.verb.sense == "slide" and motion is not None and motion.mode == "brake"

    def _speed_told_late(self, f: Frame, actor: str, amount: Amount) -> None:
        """ "Two balls collide; the left one moves at 3 m/s": how fast it came."""
        if (amount.start, amount.end) in self.scene.used or f.link != "then" or f.phrases[1:]:
            return
        plain = f.verb.lemma in ("move", "travel", "go", "drive", "roll", "slide", "come")
        edges = [e for e in self.tl.edges if e.actor == actor]
        if not plain or f.adverbs or len(edges) != 1 or edges[0].speed_is_prescribed:
            return
        self.tl.set_speed(actor, amount.value, prescribed=True)
        self.use(amount, "speed")

    def _lies_on_something(self, actor: str) -> bool:
        """Whether it came to lie on what it last touched ("drops it on a cube. It slides off")."""
        last = next((n for n in reversed(self.tl.nodes) if actor in n.participants), None)
        return last is not None and last.event is NodeEvent.COLLISION

    def _order_of(self, f: Frame, actors: list[str]) -> None:
        """ "a bus and a taxi drive with the taxi ahead"."""
        p = f.phrase("with")
        if p is None or p.mention is None or len(actors) < 2:
            return
        for side, kind in (
            ("ahead", "in_front_of"),
            ("behind", "behind"),
            ("in front", "in_front_of"),
        ):
            if side in f.adverbs:
                for one in p.mention.entities:
                    for other in actors:
                        if other != one:
                            self.scene.relations.append(Relation(one, other, kind))

    def _tipped(self, actor: str) -> bool:
        """ "The seesaw tips and a boy slides off": from what has just toppled."""
        last = self.tl.node(self.tl.last_event or "")
        tipped = last is not None and last.event is NodeEvent.TOPPLE
        if not tipped or last is None or actor in last.participants:
            return False
        host = last.participants[0]
        if self._fits_on(actor, host):
            self.place([actor], [host], "on")
        return self.kind(host) not in ("person", "animal")

    def _on_what_was_hit(self, f: Frame, things: list[str]) -> None:
        """ "pushed into a shelf, causing three jars to fall down": they stood on the shelf."""
        if self.last_hit is None or not (
            {"down", "off"} & {*f.adverbs, f.verb.extra.get("particle", "")}
        ):
            return
        host = self.last_hit[1]
        for t in things:
            fits = host in self.world.entities and self._fits_on(t, host)
            if fits and t not in self.scene.supported_by and t not in self.last_hit:
                self.place([t], [host], "on")

    def _reverse(self, actors: list[str]) -> None:
        for actor in actors:
            if not self.movable(actor):
                continue
            track = self.tl.track(actor)
            if track.motion is None:
                self._own(
                    actor, SPEEDS.get(self.kind(actor), (50.0, 400.0)), False, self.aim.get(actor)
                )
            if track.direction in (None, ForceDirection.ALONG_FORWARD_ONLY):
                track.direction = ForceDirection.ALONG_FORWARD_OR_BACKWARD

    def _stands(self, f: Frame, body: str) -> bool:
        """Whether something tall stands or leans on the ground, where it can only tip over."""
        e = self.e(body)
        tall = (e.dimensions_cm or e.noun.dimensions_cm)[2] >= _TALL_CM
        held = body in self.scene.supported_by or body in self.scene.attached
        down = f.phrase("off", "from", "out of", "over") is not None or "off" in f.adverbs
        lifted = body in self.scene.heights or self._airborne(body)
        in_row = e.pattern == "row" and e.group is not None and not (held or down or lifted)
        if in_row and self._moved_by_others(body):
            return True  # "hits the first of a row of books, which fall one after another"
        upright = body in self.leaning or ("topples" in e.noun.traits and tall)
        return upright and not (held or down or lifted)

    def _speed_of_noun(self, f: Frame, subject: list[str]) -> None:
        """ "a mallet swung at 3 m/s", "a boat making 30 knots": the speed that nothing has read."""
        found = self.quantity(f, "speed")
        if found is None or not f.reduced or len(subject) != 1:
            return
        if (found[1].start, found[1].end) in self.scene.used:
            return
        edges = [e for e in self.tl.edges if e.actor == subject[0]]
        if edges and not any(e.speed_is_prescribed for e in edges):
            self.tl.set_speed(subject[0], found[1].value, prescribed=True)
            self.use(found[1], "speed")
        elif not edges:
            self.stated[subject[0]] = found[1]
