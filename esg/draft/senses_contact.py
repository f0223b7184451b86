"""Verbs of contact and its results: hit, knock, send, topple, pot, score, miss."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.core import Time
from esg.draft.frames import Frame
from esg.draft.scene import SELF_POWERED
from esg.draft.senses_launch import LaunchSenses
from esg.graph.models import EventConstraint, NodeEvent

_STUMBLING = frozenset({"trip", "stumble"})
_CATCHING = frozenset({"catch", "block", "intercept", "parry", "deflect"})
_LOW_CM = 40.0
"""Height of a pallet or a platform: what hits it hits what stands on it."""


class ContactSenses(LaunchSenses):
    """Collisions and what follows from them."""

    def _do_hit(self, f: Frame, s: list[str], o: list[str]) -> None:
        time = self._time(f)
        if f.object is not None and f.object.attribute and not o:
            o = []
        if f.verb.passive and f.verb.extra.get("motion") and f.phrase("by") is None:
            f.verb.passive = False  # "is reversed into a lamp post"
            o = [i for i in o if i not in s]
        if f.verb.passive:
            by = f.phrase("by")
            by = by or f.phrase("with")
            movers = by.mention.entities if by is not None and by.mention is not None else []
            if not movers:
                movers = [
                    a for a, t in self.tl.tracks.items() if t.motion is not None and a not in s
                ][-1:]
            if not movers and s:
                if self.quantity(f, "angle") is not None:
                    self._motion_of_things(f, s, "throw")
                else:
                    self._motion(f, s, None)  # "a cue ball is struck at 3 m/s"
                return
            targets = s
        else:
            movers, targets = s, self._hit_targets(f, s, o)
            if f.verb.lemma in _CATCHING and not set(targets) & set(self.pending):
                targets = list(self.pending)[-1:] or targets  # "but the keeper catches it"
            if not s and o and f.subject is None:
                # imperative "hit the ball into the goal": a launch
                self._do_launch(f, s, o)
                return
        if (
            movers
            and all(self.kind(m) == "person" for m in movers)
            and targets
            and not f.verb.passive
            and f.verb.lemma in ("hit", "strike", "tap", "smack", "whack")
            and self.kind(targets[0]) in ("ball", "billiard", "sliding")
        ):
            self._launch_by(f, movers, targets)
            return
        host = f.phrase("on", "in", "at")
        if (
            len(movers) >= 2
            and host is not None
            and host.mention is not None
            and targets == host.mention.entities
        ):
            self.place(movers, targets, host.prep)
            targets = []
        flat = all(map(self.structural, targets))
        if flat and movers and not f.verb.passive and self._crashes_down(f, movers):
            return
        encounter = f.verb.lemma == "meet" and all(self.kind(m) in SELF_POWERED for m in movers)
        if encounter and not targets:
            self._motion(f, movers, None)  # "two trains meet at a bridge"
            return
        if not targets and len(movers) >= 2:
            self._mutual(f, movers, time)
            return
        rim = f.object is not None and f.object.head in ("cushion", "rail") and f.object.attribute
        if rim and not targets:
            for mover in movers:
                self._ensure_mover(f, mover, None)
                self.scene.needs.append(("billiard_table", mover))
            self.scene.ignored[(f.verb.start, f.verb.end)] = "a part that every ball touches"
            return
        if not targets and movers and f.object is None and self._names_something(f):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "what is hit was not understood"
            return
        if not targets and f.verb.lemma in _STUMBLING:
            self.use(f, "stumbles")
            return
        if not targets and movers:
            aimed = self.aim.get(movers[0]) or self._aim_of_mates(movers[0])
            if aimed is not None and aimed != movers[0]:
                targets = [aimed]
            else:
                targets = [
                    i
                    for ids in reversed(self.world.salience)
                    for i in ids
                    if i not in movers and not self.structural(i)
                ][:1]
        self._kinematics(f, movers, targets)
        if f.verb.extra.get("motion") == "reverse":
            self._reverse(movers)
        slowing = [m for m in movers if self._brakes_now(m)]
        nodes = self._hit(f, movers, targets, time)
        self._speed_at_hit(f, nodes, slowing)
        self._after_hit(f, nodes, targets)
        if not o and not f.verb.passive:
            seen = list(targets)
            for p in f.phrases:
                if (
                    p.prep in ("into", "against", "with", "through")
                    and p.mention is not None
                    and not p.mention.attribute
                ):
                    extra = [
                        i
                        for i in p.mention.entities
                        if i not in seen and i not in movers and not self.structural(i)
                    ]
                    seen += extra
                    self._hit(f, movers, extra)
        tail = f.phrase("off")
        if tail is not None and tail.mention is not None and targets:
            self._outcomes(f, targets[:1])
        elif o and f.phrase("into", "onto", "toward", "towards") is not None and nodes:
            self._knock_on(f, targets[:1])

    def _crashes_down(self, f: Frame, movers: list[str]) -> bool:
        """ "crashes to the floor": a fall from where it stands."""
        p = f.phrase("to", "onto", "on", "down")
        if p is None or p.mention is None or not all(map(self.structural, p.mention.entities)):
            return False
        for mover in movers:
            if mover in self.scene.supported_by:
                self.event(NodeEvent.FALL, (mover,), f, self._time(f))
        return any(m in self.scene.supported_by for m in movers)

    def _aim_of_mates(self, mover: str) -> str | None:
        """ "The first stone misses the can. The second one hits.": the can."""
        kind = self.e(mover).noun.name
        like = [a for a in self.aim if a in self.world.entities and self.e(a).noun.name == kind]
        return self.aim[like[-1]] if like else None

    def _names_something(self, f: Frame) -> bool:
        """Whether an article follows the verb, so that there is an object that was not read."""
        after = self.text[f.verb.end : f.verb.end + 12].lower().split()
        return bool(after) and after[0] in ("a", "an", "the", "its", "his", "her")

    def _brakes_now(self, actor: str) -> bool:
        track = self.tl.tracks.get(actor)
        return track is not None and track.motion is not None and track.motion.mode == "brake"

    def _speed_at_hit(self, f: Frame, nodes: list[str], slowing: list[str]) -> None:
        """ "brakes and hits the barrier at 4 m/s": the speed left, not the one driven before."""
        found = self.quantity(f, "speed")
        draft = self.tl.node(nodes[0]) if nodes else None
        if found is None or draft is None or draft.participants[0] not in slowing:
            return
        draft.constraints.append(
            EventConstraint(
                quantity="speed_before", object=draft.participants[0], value=found[1].value
            )
        )
        self.use(found[1], f"speed before {draft.id}")

    def _hit_targets(self, f: Frame, s: list[str], o: list[str]) -> list[str]:
        if o:
            return o
        p = f.phrase("with", "through", "into", "against", "at", "on", "onto", "to", "in")
        if f.verb.lemma in _STUMBLING:
            p = f.phrase("over", "on", "into", "against") or p
        if p is not None and p.mention is not None and not (p.prep == "in" and p.mention.attribute):
            found = [i for i in p.mention.entities if i not in s]
            if found:
                return found
        return []

    def _after_hit(self, f: Frame, nodes: list[str], targets: list[str]) -> None:
        """Angles and the like stated with a hit."""
        angle = self.quantity(f, "angle")
        if angle is not None and nodes:
            draft = self.tl.node(nodes[0])
            if draft is not None:
                draft.constraints.append(
                    EventConstraint(
                        quantity="angle", object=draft.participants[0], value=angle[1].value
                    )
                )
                self.use(angle[1], f"angle of {nodes[0]}")

    def _mutual(self, f: Frame, movers: list[str], time: Time | None) -> None:
        """ "Two cars collide": who moves, who is hit."""
        a, b = movers[0], movers[1]
        latest = self.tl.node(self.tl.last_event or "")
        if (
            latest is not None
            and latest.event is NodeEvent.COLLISION
            and set(latest.participants) == {a, b}
            and time is None
        ):
            self.use(f, latest.id)  # "they meet and collide"
            return
        ta, tb = self.tl.tracks.get(a), self.tl.tracks.get(b)
        if (
            self.e(a).place == "front"
            or (self.e(b).place == "rear")
            or (ta is None and tb is not None)
        ):
            a, b = b, a
        moving = [
            m
            for m in (a, b)
            if (t := self.tl.tracks.get(m)) is not None and (t.motion is not None or t.hit)
        ]
        if not moving:
            driven = any(self.kind(m) in SELF_POWERED for m in (a, b))
            for m in (a, b) if driven else (a,):
                if self.movable(m):
                    self._start_motion(f, [m], None, b if m == a else a)
        self._hit(f, [a], [b], time)

    def _do_knock(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            movers = by.mention.entities if by is not None and by.mention is not None else []
            s, o = list(movers), s
        if not o:
            p = f.phrase("into", "against", "on")
            if p is not None and p.mention is not None and s:
                self._do_hit(f, s, [])
            return
        if self._already_hit(f, s, o):
            self.use(f, "consequence of the collision")
        elif s:
            self._kinematics(f, s, o)
            self._hit(f, s, o, self._time(f))
        self._topples_too(f, s, o)
        self._knock_on(f, o)
        self._consequence(f, o)

    def _topples_too(self, f: Frame, s: list[str], o: list[str]) -> None:
        """A member of a row that knocks over the next one falls over itself."""
        for a in s[:1]:
            group = self.e(a).group
            fallen = any(n.event is NodeEvent.TOPPLE and a in n.participants for n in self.tl.nodes)
            upright = self.kind(a) in ("domino", "pin") or "topples" in self.e(a).noun.traits
            if group is None or fallen or not upright or not self._moved_by_others(a):
                continue
            if any(self.e(b).group == group for b in o):
                self.event(NodeEvent.TOPPLE, (a,), f, None)

    def _do_cause(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.use(f, "consequence")
        if f.verb.passive:
            o, s = s, []
        if not o:
            return
        if (
            f.verb.lemma in ("send", "force")
            and s
            and not self._already_hit(f, s, o)
            and f.causer is None
        ):
            if self.kind(s[0]) != "person":
                self._hit(f, s, o, self._time(f))
            else:
                self._start_motion(f, o)
        if f.verb.lemma in ("send", "force"):
            self._knock_on(f, o)
            self._consequence(f, o)
        self.world.note(o)

    def _do_lead(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.use(f, "consequence")

    def _do_give(self, f: Frame, s: list[str], o: list[str]) -> None:
        body = o
        if not body:
            p = f.phrase("to")
            body = p.mention.entities if p is not None and p.mention is not None else []
        found = self.quantity(f, "speed")
        if found is not None and body:
            self._speed_after(body[0], found[1])
        self.use(f, "speed after the collision")

    def _do_topple(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.extra.get("down") and not any(map(self._upright, s)):
            self._motion(f, s, None)  # what goes down need not topple
            return
        off = f.phrase("off", "out of")
        if off is not None and not o and s and not f.verb.passive:
            self._read_as("fall", f, s, o)  # "a pallet tips off a forklift"
            return
        self._free(o or s)
        if (
            f.subject is not None
            and f.subject.determiner in ("each", "every")
            and f.object is not None
            and "next" in f.object.adjectives
            and len(s) > 1
        ):
            s, o = s[:1], s[1:2]
        if f.verb.passive:
            by = f.phrase("by")
            o, s = s, list(by.mention.entities) if by is not None and by.mention is not None else []
        if o:
            bodies = self._representatives(o, s)
            movers = [m for m in s if self.kind(m) != "person"] or s
            if movers and not self._already_hit(f, movers, o):
                self._hit(f, movers[:1], o, self._time(f))
            self._topples_too(f, s, bodies)
        else:
            bodies = self._representatives(s, []) if not f.verb.passive else []
        for b in bodies:
            if not self.movable(b):
                continue
            self._struck_before(f, b)
            if b not in self.tl.tracks and not o:
                self._shaken(f, b)
                b = self._collapsing(b)
            if b not in self.tl.tracks or (
                self.tl.tracks[b].motion is None and not self.tl.tracks[b].hit
            ):
                self._start_motion(f, [b], "slide")
            self.event(NodeEvent.TOPPLE, (b,), f, self._time(f))
        self._knock_on(f, bodies)

    def _collapsing(self, body: str) -> str:
        """The top member of a stack that nothing has touched: the bottom one rarely tips."""
        e = self.e(body)
        mates = self.world.groups.get(e.group or "", [])
        tracked = any(i in self.tl.tracks for i in mates)
        return mates[-1] if e.pattern == "stack" and mates and not tracked else body

    def _shaken(self, f: Frame, body: str) -> None:
        """ "hits the pallet and the stack of boxes collapses": the blow reaches the stack."""
        last = self.tl.node(self.tl.last_event or "")
        e = self.e(body)
        if last is None or self.last_hit is None or last.event is not NodeEvent.COLLISION:
            return
        mates = self.world.groups.get(e.group or "", [])
        striker, host = self.last_hit
        if e.pattern != "stack" or self.last_hit != last.participants or {striker, host} & {*mates}:
            return
        if body not in self.scene.supported_by and self._fits_on(body, host):
            self.place(mates, [host], "on")
        low = (self.e(host).dimensions_cm or self.e(host).noun.dimensions_cm)[2] <= _LOW_CM
        if low and self.scene.supported_by.get(body) == host:
            self._hit(f, [striker], [body])

    def _upright(self, node: str) -> bool:
        traits = self.e(node).noun.traits
        return "topples" in traits or self.kind(node) in ("domino", "pin", "plant", "post", "wall")

    def _do_scatter(self, f: Frame, s: list[str], o: list[str]) -> None:
        bodies = o or s
        if o and s and not self._already_hit(f, s, o):
            self._hit(f, s[:1], o, self._time(f))
        if bodies and self.kind(bodies[0]) in ("pin", "domino"):
            self.event(NodeEvent.TOPPLE, (self._representatives(bodies, [])[0],), f, None)
        self.use(f, "scatter")

    def _do_enter(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.lemma == "splash" and not any(map(self._enterable, o)):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "water is not simulated"
            return
        for actor in s:
            target = next((t for t in o if not self.structural(t)), None)
            if target is not None and actor in self.world.entities and self.movable(actor):
                self._ensure_mover(f, actor, target)
                self.enter(f, actor, target, f.object, self._time(f))
            else:
                self.use(f, "continues on its way")

    def _do_pocket(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            o, s = s, list(by.mention.entities) if by and by.mention else []
        bodies = o
        if f.verb.lemma == "sink" and not o:
            p = f.phrase("in", "into")
            bodies = s
            s = []
            if p is None:
                self.scene.ignored[(f.verb.start, f.verb.end)] = "sinking is not simulated"
                return
        strikers = [x for x in s if self.kind(x) in ("billiard", "ball")]
        if strikers and bodies and not self._already_hit(f, strikers, bodies):
            self._hit(f, strikers[:1], bodies, self._time(f))
        for b in bodies[:1]:
            self._ensure_mover(f, b, None)
            p = f.phrase("in", "into", "to")
            goal = [i for i in (p.mention.entities if p and p.mention else [])]
            if goal:
                self.enter(f, b, goal[0], p.mention if p else None, self._time(f))
            else:
                self.scene.needs.append(("billiard_table", b))
                self.event(
                    NodeEvent.ENTER_REGION,
                    (b,),
                    f,
                    self._time(f),
                    region="billiard_table_1/bottom left pocket",
                )

    def _do_score(self, f: Frame, s: list[str], o: list[str]) -> None:
        balls = [i for i, e in self.world.entities.items() if e.noun.kind in ("ball", "sliding")]
        ball = next((i for i in [*o, *s] if i in balls), balls[-1] if balls else None)
        if ball is None:
            ball = self.world.add(lex.nouns()["soccer ball"], "soccer ball", mentioned=False).id
        goal = next((i for i, e in self.world.entities.items() if "goal" in e.noun.traits), None)
        if goal is None:
            name = "basketball hoop" if self.e(ball).noun.name == "basketball" else "goal"
            goal = self.world.add(lex.nouns()[name], name, mentioned=False).id
        if any(n.event is NodeEvent.ENTER_REGION and ball in n.participants for n in self.tl.nodes):
            self.use(f, "goal")
            return
        self._ensure_mover(f, ball, goal)
        self.enter(f, ball, goal, None, self._time(f))

    def _do_miss(self, f: Frame, s: list[str], o: list[str]) -> None:
        targets = self._hit_targets(f, s, o)
        if f.verb.lemma in ("catch", "grab") and f.verb.negated:
            for thing in o:
                if self.pending.get(thing, (None,))[0] is NodeEvent.REACH:
                    del self.pending[thing]
            self.scene.ignored[(f.verb.start, f.verb.end)] = "negated"
            return
        if not targets and len(s) > 1:
            s, targets = s[:1], s[1:2]  # "they nearly collide"
        for actor in s:
            if not targets and actor in self.aim:
                targets = [self.aim[actor]]
            self._ensure_mover(f, actor, targets[0] if targets else None)
            for other in targets[:1]:
                if other != actor:
                    self.event(NodeEvent.MISS, (actor, other), f, self._time(f))

    def _do_clear(self, f: Frame, s: list[str], o: list[str]) -> None:
        """ "clears the fence": goes over it without touching it."""
        moving = [a for a in s if self.movable(a) and self.kind(a) != "person"] or s
        if moving and o and self.tl.tracks.get(moving[0]) is not None:
            self._do_avoid(f, moving, o)
        else:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "clearing away is not simulated"

    def _do_avoid(self, f: Frame, s: list[str], o: list[str]) -> None:
        for actor in s:
            for other in [x for x in o if x != actor][:1]:
                self._ensure_mover(f, actor, None)
                self.event(NodeEvent.MISS, (actor, other), f, self._time(f))
