"""Acts that the readings of verbs are made of: hit, go into, knock on, and consequences."""

from __future__ import annotations

from typing import Any

from esg.draft.core import Time
from esg.draft.frames import Frame, Phrase
from esg.draft.motions import Motions
from esg.draft.scene import SELF_POWERED
from esg.graph.models import NodeEvent

_GOING = frozenset(
    {
        "go",
        "drop",
        "fall",
        "roll",
        "bounce",
        "sink",
        "fly",
        "run",
        "slide",
        "trickle",
        "jump",
        "leap",
        "dive",
        "hop",
        "plunge",
        "tumble",
    }
)
_ENDS = frozenset({"end", "side", "corner", "ends", "sides", "corners"})
_EDGES = frozenset({"edge", "end", "side", "rim", "lip"})
_VISITING = frozenset(
    {"come", "go", "pull", "move", "drive", "walk", "ride", "sail", "head", "turn", "run", "step"}
)
_PLACES = frozenset(
    {"station", "tunnel", "garage", "hangar", "harbor", "harbour", "port", "depot", "airport",
     "barn", "stable", "warehouse", "factory", "hall", "room", "kitchen", "shop", "store", "school",
     "village", "town", "city", "mall"}
)  # fmt: skip
"""Where "into" is an arrival and no crash."""
_PUSHING = frozenset({"push", "shove", "nudge", "prod"})


class Acts(Motions):
    """Collisions, entries and what they cause."""

    def _outcomes(self, f: Frame, actors: list[str]) -> None:
        """Events that a motion's prepositional phrases state: into, off, onto, against, past."""
        time = self._time(f)
        fallen: set[str] = set()
        if "in" in f.adverbs and f.verb.lemma in _GOING and f.phrase("into", "in") is None:
            self._goes_in(f, actors, time)
        for p in f.phrases:
            if p.mention is None:
                continue
            if self._off_the_edge(f, p, actors, time):
                fallen.update(actors)
                continue
            if p.mention.attribute and not p.mention.entities:
                continue
            others = [i for i in p.mention.entities if i not in actors]
            if not others:
                continue
            other = others[0]
            if p.prep == "from" and self._from_an_end(f, p, other):
                self.place(actors, [other], "on")  # "roll from opposite ends of a table"
                continue
            for actor in actors:
                if p.prep in ("into", "in", "inside", "through"):
                    if actor in fallen and self._holds(other):
                        self.enter(f, actor, other, p.mention, time)
                    else:
                        self._go_into(f, actor, others, p, time)
                elif p.prep in ("against",):
                    self._hit(f, [actor], [other], time)
                elif p.prep in ("off", "over") or (
                    p.prep in ("from", "out of") and f.verb.sense in ("fall", "slide", "drop")
                ):
                    if self._elevated(other) and (p.prep != "over" or p.mention.part):
                        self.place([actor], [other], "on")
                        self.event(NodeEvent.FALL, (actor,), f, time)
                        fallen.add(actor)
                    elif p.prep == "off" and {self.kind(actor), self.kind(other)} == {"billiard"}:
                        self._hit(f, [actor], [other], time)  # "goes in off the blue"
                    elif p.prep == "over" and self._over_its_top(f, actor, other):
                        self.place([actor], [other], "on")
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

    def _from_an_end(self, f: Frame, p: Phrase, other: str) -> bool:
        """Whether a motion starts at the end of a table or shelf, and stays on it."""
        end = p.mention is not None and bool(_ENDS & set(p.mention.part.split()))
        top = self.e(other).noun.traits
        return end and "support" in top and "incline" not in top and f.verb.sense != "fall"

    def _over_its_top(self, f: Frame, actor: str, other: str) -> bool:
        """ "A cup slides over the table": on it, unlike a ball that is kicked over a bench."""
        sliding = f.verb.sense in ("slide", "roll") and not f.verb.passive
        return sliding and self.kind(other) == "table" and self._fits_on(actor, other)

    def _goes_in(self, f: Frame, actors: list[str], time: Time | None) -> None:
        """ "bounces off the rim and goes in": into the goal, hoop or hole named before."""
        named = [i for ids in reversed(self.world.salience) for i in ids]
        for actor in actors:
            goal = next(
                (i for i in named if i in self.world.entities and self._enterable(i)),
                self.aim.get(actor, ""),
            )
            if goal and (self._enterable(goal) or self._holds(goal)):
                self._ensure_mover(f, actor, goal)
                self.enter(f, actor, goal, None, time)

    def _off_the_edge(self, f: Frame, p: Phrase, actors: list[str], time: Time | None) -> bool:
        """ "falls off the end", "over its edge": of the support it moves on."""
        m = p.mention
        if m is None or p.prep not in ("off", "over") or m.part not in _EDGES:
            return False
        hosts = [i for i in m.entities if i not in actors]
        if hosts and not self._elevated(hosts[0]):
            return False
        for actor in actors:
            if hosts:
                self.place([actor], hosts[:1], "on")
            if not hosts and actor not in self.scene.supported_by:
                return False
            self.event(NodeEvent.FALL, (actor,), f, time)
        return bool(actors)

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
        visits = f.verb.lemma in _VISITING and self.e(other).head.split()[-1] in _PLACES
        if visits and self.kind(actor) in SELF_POWERED:
            self.pending[actor] = (NodeEvent.REACH, f, other, time)  # "comes into the station"
            return
        breaks = p.prep == "through" and noun.kind in ("wall", "street") and not p.mention_plural
        if (
            breaks
            and noun.name not in ("door", "window")
            and f.verb.sense not in ("noop", "be", "posture")
        ):
            self._hit(f, [actor], others, time)
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
        if kind is NodeEvent.FALL and f.verb.sense == "fall" and self._stands(f, participants[0]):
            kind = NodeEvent.TOPPLE  # "the lamp falls onto the table": it stood beside it
        told = self._told_before(kind, participants, f, extra.get("region", ""))
        if told:
            self._time_of_told(told, time)
            self.use(f, told)
            return told
        first = participants[0]
        track = self.tl.tracks.get(first)
        if track is None or not track.under_way:
            if not self.movable(first):
                self._free([first])
            if self.movable(first):
                self._start_motion(f, [first])
        return super().event(kind, participants, f, time, **extra)

    def _ensure_mover(self, f: Frame, mover: str, target: str | None) -> None:
        track = self.tl.tracks.get(mover)
        if track is not None and track.under_way:
            return
        self._start_motion(f, [mover], None, target)

    def _hit(
        self, f: Frame, movers: list[str], targets: list[str], time: Time | None = None
    ) -> list[str]:
        """Collision events of movers with targets (one for a plural of things in a group)."""
        out: list[str] = []
        targets = self._representatives(targets, movers)
        if len(movers) > 3 or any(self.e(m).group in self.world.vague for m in movers):
            movers = self._representatives(movers, [])  # "darts hit the board"
        for mover in movers:
            for target in targets:
                if mover == target or mover not in self.world.entities or self.structural(target):
                    continue
                if not self.movable(mover):
                    mover, target = target, mover
                    if not self.movable(mover):
                        continue
                if (id(f), mover, target) in self.told_hits:
                    continue  # one clause tells one collision of a pair
                self.told_hits.add((id(f), mover, target))
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
            if track is not None and track.motion is not None and track.motion.mode == "brake":
                continue
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
            if p.prep in ("into", "onto", "in", "against", "off", "out of", "over", "from"):
                for body in bodies:
                    if not others:
                        continue
                    if p.prep in ("into", "in"):
                        self._go_into_passive(f, body, others, p)
                    elif p.prep in ("onto", "against") and not self.structural(others[0]):
                        self._hit(f, [body], others, None)
                    elif (
                        p.prep in ("off", "out of", "over", "from")
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
        last = self.last_hit
        group = self.e(body).group
        if body in self.each and last is not None and group and self.e(last[1]).group == group:
            self._hit(f, [last[0]], [body])  # "hits two boxes and both fall"
            return
        for mover, aimed in self.aim.items():
            track = self.tl.tracks.get(mover)
            if aimed == body and track is not None and not track.closed:
                self._hit(f, [mover], [body])
                return
