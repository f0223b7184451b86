"""Acts that the readings of verbs are made of: motions with their outcomes, hits, entries."""

from __future__ import annotations

from typing import Any

from esg.draft.arrivals import Arrivals
from esg.draft.core import Time
from esg.draft.edges import EDGES
from esg.draft.events import PUSHING
from esg.draft.frames import Frame, Phrase
from esg.draft.scene import SELF_POWERED, SPEEDS
from esg.draft.underway import goes_on
from esg.graph.models import NodeEvent

_GOALMOUTH = frozenset({"post", "goalpost", "crossbar", "keeper", "goalkeeper", "goalie", "rim"})
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
_VISITING = frozenset(
    {"come", "go", "pull", "move", "drive", "walk", "ride", "sail", "head", "turn", "run", "step"}
)
WAYS = frozenset({"way", "path", "course", "trajectory"})
"""Parts of what moves that something gets in."""
_HOLDING = frozenset({"gripper", "hand", "hands", "grip", "grasp", "arms", "fingers"})
_OPENINGS = frozenset({"hole", "water"})
_PLACES = frozenset(
    {"station", "tunnel", "garage", "hangar", "harbor", "harbour", "port", "depot", "airport",
     "barn", "stable", "warehouse", "factory", "hall", "room", "kitchen", "shop", "store", "school",
     "village", "town", "city", "mall"}
)  # fmt: skip
"""Where "into" is an arrival and no crash."""


class Acts(Arrivals):
    """Collisions and entries."""

    def _outcomes(self, f: Frame, actors: list[str]) -> None:
        """Events that a motion's prepositional phrases state: into, off, onto, against, past."""
        time = self._time(f)
        fallen: set[str] = set()
        if "in" in f.adverbs and f.verb.lemma in _GOING and f.phrase("into", "in") is None:
            off = f.phrase("off")
            if off is not None and off.mention is not None and not off.mention.attribute:
                solid = [i for i in off.mention.entities if self._aimable(i)]
                self._hit(f, actors, [i for i in solid if i not in actors][:1])
            self._goes_in(f, actors, time)
        for p in f.phrases:
            if p.mention is None or p.mention.part in WAYS:
                continue  # "walks into the path of a tram"
            if self._off_the_edge(f, p, actors, time):
                fallen.update(actors)
                continue
            if p.prep in ("out of", "from") and p.mention.head in _HOLDING:
                for actor in actors if f.verb.sense in ("slide", "drop", "fall") else []:
                    self.event(NodeEvent.FALL, (actor,), f, time)  # "slips out of his hand"
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
                    slips = p.prep == "off" and f.verb.sense in ("roll", "slide", "fall", "drop")
                    high = self._elevated(other) or (slips and self._carries(other, actor))
                    high = high or (p.prep == "off" and f.verb.lemma in ("jump", "leap", "hop"))
                    if high and self.movable(actor) and (p.prep != "over" or p.mention.part):
                        self.place([actor], [other], "on")
                        self.event(NodeEvent.FALL, (actor,), f, time)
                        fallen.add(actor)
                    elif p.prep == "off" and {self.kind(actor), self.kind(other)} == {"billiard"}:
                        self._hit(f, [actor], [other], time)  # "goes in off the blue"
                    elif p.prep == "over" and (
                        self._over_its_top(f, actor, other) or self._over_a_deck(f, actor, other)
                    ):
                        self.place([actor], [other], "on")
                elif p.prep == "onto" and not self.structural(other):
                    self._hit(f, [actor], [other], time)
                elif p.prep in ("down", "up") and "incline" in self.e(other).noun.traits:
                    self.place([actor], [other], "on" if p.prep == "down" else "near")
                elif p.prep in ("along", "across") and "support" in self.e(other).noun.traits:
                    self.place([actor], [other], "on")
                elif p.prep in ("toward", "towards") and p.mention.part in EDGES:
                    if self._elevated(other) and self._fits_on(actor, other):
                        self.place([actor], [other], "on")  # "rolls toward the edge of the desk"
                elif p.prep == "past" and self._touches_later(f, other):
                    self.use(f, "on the way to the contact")
                elif p.prep == "past":
                    self.event(NodeEvent.MISS, (actor, other), f, time)
                elif p.prep == "to" and self.structural(other) and self._comes_down(f, actor, p):
                    self.event(NodeEvent.FALL, (actor,), f, time)
                elif p.prep == "to" and not self.structural(other) and not p.mention.attribute:
                    self._heads_for(f, actor, other, time)

    def _goes_in(self, f: Frame, actors: list[str], time: Time | None) -> None:
        """ "bounces off the rim and goes in": into the goal, hoop or hole named before."""
        named = [i for ids in reversed(self.world.salience) for i in ids]
        known = self.world.entities
        for actor in actors:
            goals = [i for i in named if i in self.world.entities and self._enterable(i)]
            last = self.tl.node(self.tl.last_event or "")
            passed = str(last.extra.get("region", "")).split("/")[0] if last is not None else ""
            goals = [i for i in goals if i != passed] or goals  # "through the hoop and back in"
            goal = next(iter(goals), self.aim.get(actor, ""))
            if not goal and self.kind(actor) in ("ball", "sliding"):
                posts = any(self.e(i).head.split()[-1] in _GOALMOUTH for i in named if i in known)
                goal = self._implied_goal(actor) if posts else ""
            table = self.world.billiards or any(e.noun.kind == "billiard" for e in known.values())
            if not goal and table and self.kind(actor) in ("billiard", "ball"):
                self._read_as("pocket", f, [], [actor])  # "goes in off the cushion"
            if goal and (self._enterable(goal) or self._holds(goal)):
                self._ensure_mover(f, actor, goal)
                self.enter(f, actor, goal, None, time)

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
        if visits and p.prep != "through" and self.kind(actor) in SELF_POWERED:
            self.pending[actor] = (NodeEvent.REACH, f, other, time)  # "comes into the station"
            return
        if p.prep == "through" and self._opening(others):
            self.use(f, "a way, no thing that is met")
            return
        barrier = noun.kind in ("wall", "street") or noun.name in ("hedge", "bush")
        breaks = p.prep == "through" and barrier and not p.mention_plural
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
        airborne = airborne or (f.verb.sense == "bounce" and self._bounces_over(actor, other))
        airborne = airborne or ("there" in f.adverbs and actor in self.came_down)
        enterable = (
            noun.kind in ("region", "goal", "hole", "hoop")
            or "goal" in noun.traits
            or noun.kind == "water"
        )
        if enterable or (airborne and self._takes_up_from_above(other, p.prep)):
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
        if track is None or not track.under_way or track.waiting:
            if not self.movable(first):
                self._free([first])
            if self.movable(first):
                self._start_motion(f, [first])
        return super().event(kind, participants, f, time, **extra)

    def _ensure_mover(self, f: Frame, mover: str, target: str | None) -> None:
        track = self.tl.tracks.get(mover)
        if track is not None and track.under_way and not track.waiting:
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
                if "region" in (self.kind(mover), self.kind(target)):
                    continue  # a pocket is a part of its table
                if f.verb.lemma in ("run", "drive", "slam") and self.kind(target) in _OPENINGS:
                    self._ensure_mover(f, mover, target)
                    self.enter(f, mover, target, None, time)  # "runs into the gutter"
                    continue
                if not self.movable(mover):
                    mover, target = target, mover
                    if not self.movable(mover) or not self._aimable(target):
                        continue  # "is bumped by a sidewalk"
                if (id(f), mover, target) in self.told_hits:
                    continue  # one clause tells one collision of a pair
                self.told_hits.add((id(f), mover, target))
                aimed = self.pending.get(target)
                if aimed is not None and aimed[0] in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION):
                    mover, target = target, mover  # "a keeper blocks the shot": the ball arrives
                self._settle_others(mover, target)
                self._share_support(f, mover, target)
                self._ensure_mover(f, mover, target)
                self._was_under_way(f, target)
                out.append(self.event(NodeEvent.COLLISION, (mover, target), f, time))
                for one, other in ((mover, target), (target, mover)):
                    arrival = self.pending.get(one)
                    same = arrival is not None and arrival[1].sentence == f.sentence
                    if same and arrival[0] is NodeEvent.REACH and arrival[2] == other:
                        del self.pending[one]  # "throws it to a dog, which catches it": once
                self.last_hit = (mover, target)
                time = None
        return out

    def _was_under_way(self, f: Frame, target: str) -> None:
        """Sets what is hit in motion, where the prompt goes on as if it were: "then brakes"."""
        e = self.e(target)
        if target in self.tl.tracks or e.noun.kind not in SELF_POWERED or target in self.still:
            return
        if goes_on(self.told, f.verb, target, e.adjectives, self.text):
            self._own(target, SPEEDS.get(e.noun.kind, (50.0, 600.0)), False)

    def _settle_others(self, mover: str, target: str) -> None:
        """What was sent at a thing before arrives before the next one does."""
        mates = self.world.groups.get(self.e(target).group or "", [target])
        for name, (kind, _, other, _) in list(self.pending.items()):
            aimed = kind is NodeEvent.COLLISION and other in mates
            own = self.e(mover).group
            aimed = aimed and not (own and own == self.e(name).group)
            if aimed and name not in (mover, target) and mover in self.world.entities:
                self._settle(name, None)

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
            pushed = f.verb.lemma in PUSHING or mover in self.rolling
            pushed = pushed or any(
                n.event is NodeEvent.TOPPLE and mover in n.participants for n in self.tl.nodes
            )  # a domino that tips over onto those on a table
            if self.aim.get(mover) == host:
                continue
            if not fell and (one == mover or pushed):
                self.place([other], [host], "on")

    def _comes_down_a_slope(self, mover: str) -> bool:
        """Whether something is on its way down a ramp: it arrives faster than it set off."""
        track, host = self.tl.tracks.get(mover), self.scene.supported_by.get(mover)
        if host is None or track is None or track.motion is None or track.closed:
            return False
        return "incline" in self.e(host).noun.traits

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
            if self._comes_down_a_slope(mover):
                continue
            if track is not None and track.motion is not None and not track.closed:
                track.motion.speed, track.motion.prescribed = speed, prescribed
            elif not self._moved_by_others(mover):
                self._start_motion(f, [mover], None, targets[0] if targets else None)
