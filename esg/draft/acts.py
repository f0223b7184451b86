"""Acts that the readings of verbs are made of: start a motion, hit, go into, knock on."""

from __future__ import annotations

from typing import Any

from esg.draft.core import Time
from esg.draft.events import Events
from esg.draft.frames import Frame, Phrase
from esg.draft.scene import SELF_POWERED, SPEEDS, Relation
from esg.draft.timeline import LAUNCHES, Motion
from esg.graph.models import ForceDirection, NodeEvent, Quantity

_AIRBORNE = frozenset({"projectile", "tool", "tableware", "book", "rock"})


_PUSHING = frozenset({"push", "shove", "nudge", "prod"})


class Acts(Events):
    """Motions and collisions."""

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
                return (0.3 * a.high, a.high), True
            return a.value, True
        kind = self.kind(actors[0]) if actors else "ball"
        if mode in LAUNCHES:
            if kind in ("billiard", "projectile"):
                return SPEEDS[kind], False
            return SPEEDS[mode], False
        return SPEEDS.get(kind, (50.0, 600.0)), False

    def _direction(self, actor: str, mode: str) -> ForceDirection:
        if mode in ("throw", "drop", "fly") or self.kind(actor) == "flyer":
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
            params = {"spin": "roll" if "round" in self.e(actor).noun.traits else "slide"}
        elif mode == "slide":
            params = {"spin": "slide"}
        self.tl.move(
            actor, Motion(mode, speed, prescribed, target, params), self._direction(actor, mode)
        )

    def _own(
        self, actor: str, speed: Quantity | None, prescribed: bool, target: str | None = None
    ) -> None:
        self.tl.move(actor, Motion("own", speed, prescribed, target), self._direction(actor, "own"))

    def _start_motion(
        self, f: Frame, actors: list[str], mode: str | None = None, target: str | None = None
    ) -> None:
        for actor in actors:
            if not self.movable(actor):
                continue
            chosen = mode or self._natural(actor)
            speed, prescribed = self._speed(f, [actor], chosen)
            if chosen in LAUNCHES:
                self._launch(actor, chosen, speed, prescribed, target)
            else:
                self._own(actor, speed, prescribed, target)

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
            self._start_motion(f, [actor], mode, aim)
        found = self.quantity(f, "speed")
        if found is not None and actors and all(self._moved_by_others(a) for a in actors):
            self._speed_after(actors[0], found[1])
        self._order_of(f, actors)
        self.use(f, "motion")
        self._distance(f, actors, aim)
        if "off" in f.adverbs:
            for actor in actors:
                if actor in self.scene.supported_by:
                    self.event(NodeEvent.FALL, (actor,), f, self._time(f))
        duration = next(
            (a for p, a in self.amounts(f) if a.dimension == "time" and p == "for"), None
        )
        if duration is not None:
            for actor in actors:
                track = self.tl.tracks.get(actor)
                if track is not None and track.motion is not None:
                    track.motion.duration = duration.value
            self.use(duration, "duration")
        self._outcomes(f, actors)

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

    def _distance(self, f: Frame, actors: list[str], aim: str | None) -> None:
        """ "toward a bench 6 m away": how far the target is at the start."""
        for _, a in self.amounts(f):
            if a.dimension != "length" or (a.start, a.end) in self.scene.used:
                continue
            after = self.text[a.end : a.end + 8].strip().lower()
            if after.startswith(("away", "apart", "ahead")) and aim is not None:
                for actor in actors:
                    self.scene.relations.append(Relation(actor, aim, "near", a.value))
                self.use(a, "distance at the start")
            elif f.verb.sense in ("own", "roll", "slide", "fly", "launch") and actors:
                track = self.tl.tracks.get(actors[0])
                if track is not None and (track.motion is not None or track.hit):
                    self.scene.travel[actors[0]] = a
                    self.use(a, "distance travelled")

    def _outcomes(self, f: Frame, actors: list[str], movers_hit: bool = False) -> None:
        """Events that a motion's prepositional phrases state: into, off, onto, against, past."""
        time = self._time(f)
        for p in f.phrases:
            if p.mention is None or (p.mention.attribute and not p.mention.entities):
                continue
            others = [i for i in p.mention.entities if i not in actors]
            if not others:
                continue
            other = others[0]
            for actor in actors:
                if p.prep in ("into", "in", "inside", "through"):
                    self._go_into(f, actor, others, p, time)
                elif p.prep in ("against",):
                    self._hit(f, [actor], [other], time)
                elif p.prep in ("off", "over") or (
                    p.prep in ("from", "out of") and f.verb.sense in ("fall", "slide", "drop")
                ):
                    if self._elevated(other) and (p.prep != "over" or p.mention.part):
                        self.place([actor], [other], "on")
                        self.event(NodeEvent.FALL, (actor,), f, time)
                elif p.prep == "onto" and not self.structural(other):
                    self._hit(f, [actor], [other], time)
                elif p.prep in ("down", "up") and "incline" in self.e(other).noun.traits:
                    self.place([actor], [other], "on" if p.prep == "down" else "near")
                elif p.prep in ("along", "across") and "support" in self.e(other).noun.traits:
                    self.place([actor], [other], "on")
                elif p.prep == "past":
                    self.event(NodeEvent.MISS, (actor, other), f, time)
                elif p.prep == "to" and not self.structural(other) and not p.mention.attribute:
                    self.pending[actor] = (NodeEvent.REACH, f, other, time)

    def _go_into(
        self,
        f: Frame,
        actor: str,
        others: list[str],
        p: Phrase,
        time: Time | None,
    ) -> None:
        other = others[0]
        noun = self.e(other).noun
        if self.structural(other):
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
            self._airborne(actor) and f.verb.sense not in ("roll", "slide")
        ) or f.verb.sense in (
            "fall",
            "drop",
            "land",
            "pocket",
            "fly",
        )
        enterable = (
            noun.kind in ("region", "goal", "hole", "hoop")
            or "goal" in noun.traits
            or noun.kind == "water"
        )
        if enterable or ("container" in noun.traits and airborne):
            self.enter(f, actor, other, p.mention, time)
        else:
            self._hit(f, [actor], others, time)

    def event(
        self,
        kind: NodeEvent,
        participants: tuple[str, ...],
        f: Frame,
        time: Time | None,
        **extra: Any,
    ) -> str:
        """Adds a point event; its first participant is set in motion if nothing moves it yet."""
        first = participants[0]
        track = self.tl.tracks.get(first)
        if track is None or (track.motion is None and not track.hit):
            if not self.movable(first):
                self._free([first])
            if self.movable(first):
                self._start_motion(f, [first])
        return super().event(kind, participants, f, time, **extra)

    def _ensure_mover(self, f: Frame, mover: str, target: str | None) -> None:
        track = self.tl.tracks.get(mover)
        if track is not None and (track.motion is not None or track.hit):
            return
        self._start_motion(f, [mover], None, target)

    def _hit(
        self, f: Frame, movers: list[str], targets: list[str], time: Time | None = None
    ) -> list[str]:
        """Collision events of movers with targets (one for a plural of things in a group)."""
        out: list[str] = []
        targets = self._representatives(targets, movers)
        for mover in movers:
            for target in targets:
                if mover == target or mover not in self.world.entities or self.structural(target):
                    continue
                if not self.movable(mover):
                    mover, target = target, mover
                    if not self.movable(mover):
                        continue
                aimed = self.pending.get(target)
                if aimed is not None and aimed[0] in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION):
                    mover, target = target, mover  # "a keeper blocks the shot": the ball arrives
                self._share_support(f, mover, target)
                self._ensure_mover(f, mover, target)
                out.append(self.event(NodeEvent.COLLISION, (mover, target), f, time))
                self.last_hit = (mover, target)
                time = None
        return out

    def _share_support(self, f: Frame, mover: str, target: str) -> None:
        """What rolls across a table and hits a cup there, or pushes it, shares its table."""
        hosts = self.scene.supported_by
        for one, other in ((mover, target), (target, mover)):
            host = hosts.get(one)
            if host is None or other in hosts or other in self.scene.inside_of or other == host:
                continue
            if not self._fits_on(other, host) or self._airborne(mover):
                continue
            fell = any(n.event is NodeEvent.FALL and one in n.participants for n in self.tl.nodes)
            pushed = f.verb.lemma in _PUSHING or mover in self.rolling
            if self.aim.get(mover) == host:
                continue
            if not fell and (one == mover or pushed):
                self.place([other], [host], "on")

    def _fits_on(self, node: str, host: str) -> bool:
        """Whether something movable can share a table top or shelf."""
        top = self.e(host).noun
        if "support" not in top.traits or "incline" in top.traits or not self.movable(node):
            return False
        if self.kind(node) in ("person", "vehicle") or self.structural(node):
            return False
        size = self.e(node).dimensions_cm or self.e(node).noun.dimensions_cm
        return max(size) <= 0.5 * max(top.dimensions_cm[:2])

    def _kinematics(self, f: Frame, movers: list[str], targets: list[str]) -> None:
        """A stated speed belongs to the mover ("hits the wall at 5 m/s": just before it)."""
        found = self.quantity(f, "speed")
        if found is None or not movers:
            return
        speed, prescribed = self._speed(f, movers, self._natural(movers[0]))
        for mover in movers:
            track = self.tl.tracks.get(mover)
            if track is not None and track.motion is not None and not track.closed:
                track.motion.speed, track.motion.prescribed = speed, prescribed
            elif not self._moved_by_others(mover):
                self._start_motion(f, [mover], None, targets[0] if targets else None)

    def _knock_on(self, f: Frame, bodies: list[str]) -> None:
        """ "hits the ball into the pocket": what happens to the body that was hit."""
        bodies = self._representatives(bodies, [])
        for p in f.phrases:
            if (
                p.mention is not None
                and p.mention.part in ("edge", "side", "end", "rim")
                and not p.mention.entities
            ):
                if p.prep in ("over", "off"):
                    for body in bodies:
                        self.event(NodeEvent.FALL, (body,), f, None)
                continue
            if p.mention is None or p.mention.attribute:
                continue
            others = [i for i in p.mention.entities if i not in bodies]
            if p.prep in ("to", "onto", "on") and others and self.structural(others[0]):
                for body in bodies:
                    self._down(f, body)
                continue
            if p.prep in ("into", "onto", "in", "against", "off", "out of", "over"):
                for body in bodies:
                    if not others:
                        continue
                    if p.prep in ("into", "in"):
                        self._go_into_passive(f, body, others, p)
                    elif p.prep in ("onto", "against") and not self.structural(others[0]):
                        self._hit(f, [body], others, None)
                    elif (
                        p.prep in ("off", "out of", "over")
                        and self._elevated(others[0])
                        and (p.prep != "over" or p.mention.part)
                    ):
                        self.place([body], [others[0]], "on")
                        if self.last_hit is not None and self.last_hit[1] == body:
                            self._share_support(f, *self.last_hit)
                        self.event(NodeEvent.FALL, (body,), f, None)

    def _down(self, f: Frame, body: str) -> None:
        """ "knocks a glass to the floor": it falls off what it stands on, or topples."""
        if body not in self.scene.supported_by:
            hosts = [
                i
                for ids in reversed(self.world.salience)
                for i in ids
                if i != body and "support" in self.e(i).noun.traits
            ]
            if hosts:
                self.place([body], hosts[:1], "on")
        fell = body in self.scene.supported_by
        self.event(NodeEvent.FALL if fell else NodeEvent.TOPPLE, (body,), f, None)

    def _go_into_passive(self, f: Frame, body: str, others: list[str], p: Phrase) -> None:
        other = others[0]
        noun = self.e(other).noun
        if self.structural(other):
            return
        if noun.kind in ("region", "goal", "hole", "hoop", "water") or "goal" in noun.traits:
            self.enter(f, body, other, p.mention, self._time(f))
        else:
            self._hit(f, [body], others, self._time(f))

    def _already_hit(self, f: Frame, s: list[str], o: list[str]) -> bool:
        return any(self.tl.tracks.get(b) is not None and self.tl.tracks[b].hit for b in o) and (
            f.causer is not None
            or (
                f.link in ("cause", "then", "while")
                and self.last_hit is not None
                and self.last_hit[1] in o
            )
        )

    def _consequence(self, f: Frame, bodies: list[str]) -> None:
        words = " ".join(f.adverbs)
        if "over" in f.adverbs or "down" in f.adverbs or "upside down" in words:
            for b in self._representatives(bodies, []):
                self.event(NodeEvent.TOPPLE, (b,), f, None)
        elif f.adverbs and f.adverbs[-1] == "off" and f.verb.sense in ("knock", "launch", "cause"):
            for b in self._representatives(bodies, []):
                if b in self.scene.supported_by:
                    self.event(NodeEvent.FALL, (b,), f, None)

    def _struck_before(self, f: Frame, body: str) -> None:
        """ "thrown at a bottle, which falls": the fall implies the hit."""
        if body in self.tl.tracks:
            return
        for mover, aimed in self.aim.items():
            track = self.tl.tracks.get(mover)
            if aimed == body and track is not None and not track.closed:
                self._hit(f, [mover], [body])
                return

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
