"""Verbs of launching: throw, kick, push, pass, tow, lose."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.frames import Frame
from esg.draft.scene import SELF_POWERED
from esg.draft.senses_state import StateSenses
from esg.graph.models import NodeEvent

_BY_HAND = frozenset({"push", "shove", "nudge", "prod"})
_THROWN = frozenset({"ball", "billiard", "sliding", "projectile", "rock"})
_GUNS = frozenset({"cannon", "catapult", "tank", "gun"})
_SHOTS = frozenset({"ball", "projectile", "rock"})


class LaunchSenses(StateSenses):
    """Bodies that are set in motion once."""

    def _do_launch(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            agents = by.mention.entities if by is not None and by.mention is not None else []
            things = s
        else:
            agents, things = (s, o) if o else ([], s)
            if not o and f.verb.lemma in ("fire", "shoot") and (shot := self._shot_by(s)):
                agents, things = s, shot
            if not o and s and all(self.kind(x) == "person" for x in s):
                ball = self._at_hand(s)
                if ball and f.verb.lemma not in ("push", "shove"):
                    agents, things = s, [ball]  # "he shoots again"
        off, thrown = f.phrase("off", "out"), things
        if not o and off is not None and off.mention is not None:
            thrown = off.mention.entities  # "throws off the rider"
        elsewhere = any(p is not off for p in f.phrases)
        out = off is not None and off.prep == "out" and not o and len(s) == 1
        out = out and bool(thrown) and self.kind(s[0]) != "person"  # "tips over, throwing out ..."
        if not f.verb.passive and not elsewhere and (out or self._throws_off(s, thrown)):
            for thing in thrown:
                self.event(NodeEvent.FALL, (thing,), f, self._time(f))
            return
        if not things:
            p = f.phrase("against", "on", "at")
            if p is not None and p.mention is not None and agents:
                self._read_as("hit", f, agents, p.mention.entities)
            return
        self._launch_by(f, agents, things)

    def _throws_off(self, agents: list[str], things: list[str]) -> bool:
        """ "The horse throws its rider": who rides comes down."""
        ridden = len(agents) == 1 and self.kind(agents[0]) in SELF_POWERED - {"person", "robot"}
        return ridden and bool(things) and all(self.kind(i) == "person" for i in things)

    def _shot_by(self, agents: list[str]) -> list[str]:
        """ "A cannon fires at the gate": a ball, which the prompt may name afterwards."""
        if len(agents) != 1 or self.e(agents[0]).noun.name not in _GUNS:
            return []
        shots = [i for i, e in self.world.entities.items() if e.noun.kind in _SHOTS]
        if shots:
            return shots[:1]
        noun = lex.nouns()["cannonball"]
        return [self.world.add(noun, noun.name, label=noun.name, mentioned=False).id]

    def _at_hand(self, agents: list[str]) -> str:
        """The ball or stone that was spoken of last."""
        for ids in reversed(self.world.salience):
            for i in ids:
                if i in self.world.entities and i not in agents and self.kind(i) in _THROWN:
                    return i
        return ""

    def _do_pass(self, f: Frame, s: list[str], o: list[str]) -> None:
        """A person passes a ball on; a vehicle passes another one, or just passes."""
        thing = bool(o) and self.kind(o[0]) in ("ball", "billiard", "sliding", "projectile")
        handed = bool(s) and self.kind(s[0]) == "person" and (thing or not o)
        by = bool(s) and (self.kind(s[0]) in SELF_POWERED or (bool(o) and not f.verb.passive))
        if len(s) > 1 and (not o or set(o) <= set(s)) and self.kind(s[0]) in SELF_POWERED:
            self._start_motion(f, [x for x in s[:2] if self.movable(x)])
            self.event(NodeEvent.MISS, (s[0], s[1]), f, self._time(f), stem="passes")
            return
        if s and by and not handed:
            self._start_motion(f, [x for x in s if self.movable(x)])
            o = o or self._passed_by(f, s)
            o = [x for x in o if x != s[0]]
            for other in self.each_passed(f, o):
                if other == o[0]:
                    self.place(s, [other], "behind")
                self.event(NodeEvent.MISS, (s[0], other), f, self._time(f), stem="passes")
            self.use(f, "passing")
            return
        self._do_launch(f, s, o)

    def _passed_by(self, f: Frame, s: list[str]) -> list[str]:
        """ "A shelf shakes as a truck passes": what the clause around it is about."""
        around = f.main.subject if f.main is not None else None
        if around is None or f.subordinate not in ("as", "when", "while", "until"):
            return []
        return [i for i in around.entities if i not in s and self._aimable(i)][:1]

    def _do_tow(self, f: Frame, s: list[str], o: list[str]) -> None:
        """Pulling: a person moves the thing; a vehicle drives with the thing behind it."""
        if f.verb.passive:
            by = f.phrase("by")
            s, o = (list(by.mention.entities) if by and by.mention else []), s
        if s and o and self.kind(s[0]) != "person":
            self.place(o, s, "behind")
            into = f.phrase("into", "against", "over")
            ways = [p for p in f.phrases if p.prep not in ("into", "against", "off", "from")]
            self._motion(replace(f, phrases=ways), s, None)
            if into is not None and into.mention is not None and into.prep != "over":
                for other in [i for i in into.mention.entities if i not in s + o][:1]:
                    self._go_into(f, o[0], [other], into, self._time(f))
        elif not o:
            self._motion(f, s, None)  # "pulls out of a driveway"
        else:
            self._launch_by(f, s, o)

    def _launch_by(self, f: Frame, agents: list[str], things: list[str]) -> None:
        if not things:
            self._motion(f, agents, None)
            return
        mode = f.verb.note or "roll"
        if f.verb.passive and not agents and mode == "slide" and self._carried_along(things[0]):
            self._knock_on(f, things)  # "hits three wagons; the last one is pushed into a buffer"
            self._consequence(f, things)
            return
        if f.verb.lemma == "blow":
            agents = []  # the air that a fan moves touches it, not the fan
        bodily = [a for a in agents if self.kind(a) != "person"]
        flung = f.verb.lemma == "kick" and "up" in f.adverbs  # "a pebble kicked up by a lorry"
        if bodily and not flung and f.verb.sense == "launch" and mode in ("slide", "roll"):
            # a robot, car or ball that pushes something hits it
            self._kinematics(f, bodily, things)
            if not self._already_hit(f, bodily, things):
                self._hit(f, bodily[:1], things, self._time(f))
            self._knock_on(f, things)
            self._consequence(f, things)
            return
        pushed = f.verb.lemma in _BY_HAND and self._stands_low(things[0])
        if agents and (pushed or (self.kind(things[0]) == "person" and mode in ("slide", "roll"))):
            # one person pushes another: contact, not a throw
            self._hit(f, agents[:1], things[:1], self._time(f))
            stated = self.quantity(f, "speed")
            if stated is not None:
                self._speed_after(things[0], stated[1])
            self._knock_on(f, things)
            self._consequence(f, things)
            return
        if agents:
            self.place(agents, things, "near")
        for agent in agents:
            if agent != things[0]:
                self.scene.facing.setdefault(agent, things[0])
        self._motion_of_things(f, things, mode)

    def _stands_low(self, thing: str) -> bool:
        """Whether a person can walk into it: it rests on the ground and is no plaything."""
        supported = thing in self.scene.supported_by or thing in self.scene.inside_of
        small = max(self.e(thing).dimensions_cm or self.e(thing).noun.dimensions_cm) < 30.0
        return self.movable(thing) and not supported and not small

    def _motion_of_things(self, f: Frame, things: list[str], mode: str) -> None:
        target = self._target(f, things)
        if self.quantity(f, "angle") is not None and mode in ("roll", "slide"):
            mode = "throw"
        over = f.phrase("over")
        if over is not None and over.mention is not None and not over.mention.part:
            mode = "throw" if mode in ("roll", "slide") else mode
        aim = next((t for t in target if self._aimable(t)), None)
        if mode == "roll" and f.verb.lemma not in ("roll", "bowl", "putt", "dribble"):
            aimed = self.e(aim) if aim else None
            if aimed is not None and (
                aimed.noun.kind in ("hoop", "wall", "goal") and f.verb.lemma in ("shoot",)
            ):
                mode = "throw"
        if mode == "slide" and things and "round" in self.e(things[0]).noun.traits:
            mode = "roll"
        moved = [t for t in self._representatives(things, []) if self.movable(t)]
        for t in moved:
            if self._moved_by_others(t):
                continue
            self._start_motion(f, [t], mode, aim)
            if aim is not None:
                self.aim[t] = aim
            angle = self.quantity(f, "angle")
            track = self.tl.tracks.get(t)
            if (
                angle is not None
                and track is not None
                and track.motion is not None
                and mode in ("throw", "fly")
            ):
                track.motion.params["elevation_deg"] = angle[1].value
                self.use(angle[1], "launch angle")
        self.use(f, "launch")
        self._heights(f, moved)
        self._distance(f, moved, aim)
        for m in [f.subject] if f.subject is not None else []:
            self.thrown[id(m)] = moved
            self.launched_by.update((i, moved) for i in m.entities if self.kind(i) == "person")
        self._outcomes(f, moved)
        self._consequence(f, moved)
        self._aim_at(f, moved, aim)
        if aim is not None:
            for t in moved:
                self.world.note([aim])
                self.world.note([t], subject=f.verb.passive)

    def _aim_at(self, f: Frame, moved: list[str], aim: str | None) -> None:
        """ "throws a ball at a wall" ends at the wall, unless the prompt says otherwise later."""
        p = f.phrase("at")
        if p is None or aim is None or p.mention is None or aim not in p.mention.entities:
            return
        for t in moved:
            track = self.tl.tracks.get(t)
            if track is not None and track.motion is not None and not track.closed:
                goal = self._enterable(aim)
                event = NodeEvent.ENTER_REGION if goal else NodeEvent.COLLISION
                self.pending[t] = (event, f, aim, self._time(f))

    def _heights(self, f: Frame, things: list[str]) -> None:
        for p, a in self.amounts(f):
            if self.text[a.end : a.end + 6].strip().startswith(("away", "apart")):
                continue
            if self.text[max(0, a.start - 14) : a.start].rstrip().endswith("distance of"):
                continue  # "thrown from a distance of 3 m"
            drop = f.verb.sense in ("fall", "drop") and p == ""
            if a.dimension == "length" and drop:
                self._start_height(things, a)  # "falls 2 m onto a bucket"
                continue
            if a.dimension == "length" and (
                p in ("from", "at", "of", "above", "")
                and (
                    "height" in self.text[max(0, a.start - 25) : a.end + 12]
                    or p in ("from", "above")
                    or (p == "at" and f.verb.lemma in ("release", "drop"))
                    or self.text[a.end : a.end + 7].strip().startswith(("above", "high", "up"))
                )
            ):
                self._start_height(things, a)

    def _do_lose(self, f: Frame, s: list[str], o: list[str]) -> None:
        """ "The truck loses a tyre": it falls off."""
        things = [x for x in o if self.movable(x) and x not in s and self.e(x).known]
        if not things or not s:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"
            return
        self.place(things, s[:1], "on")
        for t in self._representatives(things, s):
            self.event(NodeEvent.FALL, (t,), f, self._time(f))
