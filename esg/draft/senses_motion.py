"""Verbs of motion: drive, roll, slide, fly, bounce, reach."""

from __future__ import annotations

from esg.draft.frames import Frame
from esg.draft.scene import SELF_POWERED, STRUCK, Relation
from esg.draft.senses_steer import SteerSenses
from esg.graph.models import NodeEvent

_ON_FOOT = frozenset({"run", "rush", "race"})


class MotionSenses(SteerSenses):
    """Motions and where they lead."""

    def _do_own(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and o and self.kind(s[0]) == "person" and self.kind(o[0]) in STRUCK:
            self._launch_by(f, s, o)  # "the batsman drives the ball past the bowler"
            return
        if f.verb.passive and f.verb.lemma in ("squeeze", "crush", "press") and self._caught(f, s):
            return
        by = f.phrase("by")
        actors = list(s)
        if f.verb.passive and by is not None:
            actors = list(s)
        elif (
            o
            and s
            and self.kind(s[0]) == "person"
            and f.object is not None
            and not f.object.attribute
        ):
            if self.kind(o[0]) in SELF_POWERED:
                actors = o[:1]
                if f.subject is not None:
                    self.mounts[id(f.subject)] = actors
                self.place(s, o, "near")
        elif not s and o:
            actors = o
        mounted = [self.scene.supported_by.get(a, "") for a in actors]
        if (
            actors
            and all(m and self.kind(m) in SELF_POWERED for m in mounted)
            and self.kind(actors[0]) == "person"
        ):
            actors = list(dict.fromkeys(mounted))  # "a man on a bicycle rides"
            if f.subject is not None:
                self.mounts[id(f.subject)] = actors
        actors = [a for a in actors if self.movable(a)]
        sides = [x for x in f.adverbs if x in ("left", "right")]
        if (
            sides
            and actors
            and self.kind(actors[0]) in SELF_POWERED
            and f.verb.lemma in ("go", "move", "drive", "head", "run", "walk", "ride")
        ):
            for side in sides:
                self._turn(f, actors, side, 90.0, NodeEvent.HEADING_REACHED)
            return
        mode = None
        if actors and f.verb.lemma in (
            "go",
            "come",
            "move",
            "travel",
            "race",
            "speed",
            "rush",
            "hurtle",
            "run",
            "proceed",
        ):
            mode = None
        elif actors and self.kind(actors[0]) in SELF_POWERED:
            mode = "own"
        if actors and f.verb.lemma in _ON_FOOT and self.kind(actors[0]) in ("person", "animal"):
            mode = "own"  # also what was hit: "is hit by a ball and runs into a fence"
        self._motion(f, actors, mode)
        if f.verb.lemma in ("charge", "lunge", "leap", "pounce", "spring", "fly", "dive"):
            self._aim_at(f, actors, next(iter(self._target(f, actors)), None))

    def _do_approach(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)
        for actor in s:
            if o:
                self.aim[actor] = o[0]
                track = self.tl.tracks.get(actor)
                if track is not None and track.motion is not None:
                    track.motion.target = o[0]

    def _do_follow(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            s, o = (list(by.mention.entities) if by and by.mention else []), s
        if "in" in f.adverbs and o and self._follows_in(f, s, o[0]):
            return
        self._motion(f, s, None)
        for actor in s:
            if o:
                self.aim.setdefault(actor, o[0])
                gap = self.quantity(f, "length")
                if gap is not None and gap[0] == "at" and actor not in self.scene.travel:
                    relation = Relation(actor, o[0], "behind", gap[1].value)
                    self.scene.relations.append(relation)  # "follows it at a distance of 15 m"
                    self.use(gap[1], "distance")
                else:
                    self.place([actor], o, "behind")
                track = self.tl.tracks.get(o[0])
                if (track is None and self.movable(o[0])) or (
                    track is not None
                    and track.motion is not None
                    and (p := f.phrase("at")) is not None
                    and p.mention is not None
                    and "same" in p.mention.adjectives
                ):
                    self._start_motion(f, o[:1])

    def _follows_in(self, f: Frame, s: list[str], other: str) -> bool:
        """ "The cue ball follows it in": where the other one went."""
        for node in reversed(self.tl.nodes):
            if node.event is NodeEvent.ENTER_REGION and node.participants == (other,):
                for actor in s[:1]:
                    self._ensure_mover(f, actor, other)
                    region = node.extra["region"]
                    self.event(NodeEvent.ENTER_REGION, (actor,), f, self._time(f), region=region)
                return bool(s)
        return False

    def _do_coast(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)

    def _do_continue(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)

    def _do_cross(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)

    def _do_leave(self, f: Frame, s: list[str], o: list[str]) -> None:
        flung = (
            bool(s)
            and self.kind(s[0]) in STRUCK | {"sliding", "rock"}
            and not self._moved_by_others(s[0])
        )
        if flung and self.quantity(f, "angle") is not None:
            self._motion_of_things(f, s, "throw")  # "leaves the boot at an angle of 30 degrees"
            return
        self._motion(f, s, None)

    def _pushes(self, f: Frame, s: list[str], o: list[str]) -> bool:
        """ "hits a bale, rolling it into a fence": the object is moved by the hit."""
        rolls = self.kind(s[0]) == "animal" and not f.reduced if s else False
        other = bool(s and o) and self.kind(s[0]) != "person" and s[0] != o[0]
        if other and not rolls and self.movable(o[0]):
            self._do_knock(f, s, o)
            self.use(f, "consequence of the collision")
            return True
        return False

    def _do_roll(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.object is not None and f.object.pronoun in ("itself", "himself", "herself"):
            self.use(f, "no motion of the whole")  # "rolls itself into a ball"
            return
        if self._pushes(f, s, o):
            return
        actors = o if o and (not s or self.kind(s[0]) in ("person", "animal")) else s
        self.rolling.update(actors)
        if f.subject is not None and actors == o:
            self.thrown[id(f.subject)] = list(o)
        driven = actors and self.kind(actors[0]) in SELF_POWERED and not self._sent_off(f, actors)
        if driven and not o:
            self._motion(f, actors, "own")
            return
        self._motion(
            f,
            actors,
            "roll"
            if actors and "round" in self.e(actors[0]).noun.traits
            else "slide"
            if f.verb.sense == "slide"
            else "roll",
        )
        if f.verb.passive or actors == o:
            aim = next((t for t in self._target(f, actors) if self._aimable(t)), None)
            self._aim_at(f, self._representatives(actors, []), aim)

    def _do_slide(self, f: Frame, s: list[str], o: list[str]) -> None:
        if self._pushes(f, s, o):
            return
        actors = o if o and (not s or self.kind(s[0]) == "person") else s
        self.rolling.update(actors)
        gliding = f.verb.lemma == "glide" and bool(actors) and self.kind(actors[0]) == "person"
        driven = bool(actors) and self.kind(actors[0]) in SELF_POWERED - {"person", "cart"}
        driven = gliding or (driven and not self._sent_off(f, actors))  # a skater glides along
        if driven and not o:
            self._motion(f, actors, "own")
            return
        self._motion(f, actors, "slide")

    def _sent_off(self, f: Frame, actors: list[str]) -> bool:
        """Whether a hit makes it roll or slide: what only drives or walks by itself."""
        if {"away", "off", "on"} & set(f.adverbs) and not f.phrases:
            return False
        return all(self._moved_by_others(a) and self.kind(a) != "robot" for a in actors)

    def _do_fly(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and self._flies_itself(s[0]):
            self._motion(f, s, "own")
        elif self.quantity(f, "angle") is not None and s and not self._moved_by_others(s[0]):
            self._motion_of_things(f, s, "throw")  # "flies off at an angle of 40 degrees"
        else:
            self._motion(f, s, "throw")

    def _do_spin(self, f: Frame, s: list[str], o: list[str]) -> None:
        under = f.phrase("on", "upon")
        about = "around" in f.adverbs or "round" in f.adverbs or self.quantity(f, "angle")
        met = any(
            n.event is NodeEvent.COLLISION and {*s} & {*n.participants} for n in self.tl.nodes
        )
        own = bool(s) and not met and self.kind(s[0]) in SELF_POWERED
        if own and about and f.phrase("to", "into") is None:
            self._read_as("turn", f, s, o)  # "the robot spins around", which no hit makes it do
            return
        if s and under is not None and under.mention is not None and under.mention.entities:
            self.place(s, under.mention.entities, "on")
        elif s and not self._moved_by_others(s[0]):
            self._motion(f, s, None)
        elif s and f.phrase("into", "against", "off") is not None:
            self._read_as("slide", f, s, o)  # hit by a car, it spins into a wall
        self.scene.ignored[(f.verb.start, f.verb.end)] = "spin is not prescribed"

    def _do_bounce(self, f: Frame, s: list[str], o: list[str]) -> None:
        slope = f.phrase("down")
        if (
            slope is not None
            and slope.mention is not None
            and any("incline" in self.e(i).noun.traits for i in slope.mention.entities)
        ):
            self._do_roll(f, s, o)
            return
        p = f.phrase("off", "against", "on", "from", "into", "onto")
        if len(s) > 1 and "apart" in f.adverbs and p is None:
            self._mutual(f, s, self._time(f))
            return
        self._kinematics(f, s, [])
        for actor in s:
            if p is not None and p.mention is not None and p.mention.attribute:
                self._ensure_mover(f, actor, None)
                if p.mention.head in ("cushion", "rail"):
                    self.scene.needs.append(("billiard_table", actor))
                self.use(f, "rebound")
                continue
            if p is not None and p.mention is not None and p.mention.entities:
                other = p.mention.entities[0]
                if self.structural(other):
                    self._ensure_drop(f, actor)
                    self.use(f, "bounce on the ground")
                elif {*(self.last_hit or ())} == {actor, other} and p.prep in ("off", "from"):
                    self.use(f, "rebound of the collision")
                elif p.prep == "into" and self._takes_up(actor, other):
                    self._met_first(f, actor, other)
                    self._ensure_mover(f, actor, other)
                    self._go_into(f, actor, p.mention.entities, p, self._time(f))
                else:
                    nodes = self._hit(f, [actor], [other], self._time(f))
                    self._after_hit(f, nodes, [other])
            else:
                aimed = self.aim.get(actor)
                track = self.tl.tracks.get(actor)
                if aimed is not None and track is not None and not track.closed:
                    self._hit(f, [actor], [aimed], self._time(f))
                elif track is None:
                    self._ensure_drop(f, actor)
                self.use(f, "rebound")
        for q in f.phrases:
            if q is not p and q.prep in ("off", "against") and q.mention is not None:
                others = [i for i in q.mention.entities if i not in s and not self.structural(i)]
                self._hit(f, s, others[:1])
        to = f.phrase("to")
        goal = to.mention.entities if to is not None and to.mention is not None else []
        if goal and not self.structural(goal[0]) and not to.mention.attribute:
            for actor in [a for a in s if a != goal[0]]:
                self.pending[actor] = (NodeEvent.REACH, f, goal[0], None)  # "rebounds to a forward"
        into = f.phrase("into")
        if into is not None and p is not into:
            for actor in s:
                self._go_into(f, actor, into.mention.entities if into.mention else [], into, None)

    def _met_first(self, f: Frame, actor: str, host: str) -> None:
        """ "is thrown at a wall and bounces into a bucket": off what it was aimed at."""
        aimed, track = self.aim.get(actor), self.tl.tracks.get(actor)
        if aimed is not None and aimed != host and track is not None and not track.closed:
            self._hit(f, [actor], [aimed])

    def _takes_up(self, actor: str, host: str) -> bool:
        """Whether a bounce leads into something: a goal always, over a rim out of the air."""
        over = self._airborne(actor) or self._bounces_over(actor, host)
        return self._enterable(host) or (over and self._holds(host))

    def _ensure_drop(self, f: Frame, actor: str) -> None:
        if actor not in self.tl.tracks:
            self._start_motion(f, [actor], "drop")

    def _do_reach(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.object is not None and f.object.attribute and self.quantity(f, "speed") is not None:
            self._do_acquire(f, s, o)
            return
        targets = o or self._hit_targets(f, s, [])
        for actor in s:
            lines = [t for t in targets if self.e(t).noun.name == "finish line"]
            told = [t for t in targets if t != actor and not self.structural(t)]
            target = next(iter(told or lines), None)
            if target is None and f.verb.lemma in ("get", "arrive"):
                target = self.aim.get(actor)  # "runs to the swing and gets there first"
            if target is None or target == actor:
                self._motion(f, [actor], None)
                continue
            into = self.tl.node(self.tl.last_event or "")
            inside = str(into.extra.get("region", "")) if into is not None else ""
            if (
                into is not None
                and into.event is NodeEvent.ENTER_REGION
                and into.participants == (actor,)
                and inside.startswith(f"{target}/")
            ):
                self._time_of_told(into.id, self._time(f))
                self.use(f, into.id)  # "is kicked into the goal and reaches it after 1.5 s"
                continue
            self._ensure_mover(f, actor, target)
            p = f.phrase("in", "into")
            if p is not None and (self._holds(target) or self.kind(target) == "region"):
                self.enter(f, actor, target, p.mention, self._time(f))
            else:
                self.event(NodeEvent.REACH, (actor, target), f, self._time(f))

    def _do_end(self, f: Frame, s: list[str], o: list[str]) -> None:
        """ "ends in the pond", "ends up on the floor": where it comes to be."""
        p = f.phrase("in", "into", "inside", "on", "onto", "against")
        if p is None or p.mention is None or not p.mention.entities or not s:
            if f.verb.sense == "reach":
                self._do_reach(f, s, o)
            return
        place = p.mention.entities[0]
        for actor in [a for a in s if a != place and self.movable(a)]:
            inner = p.prep in ("in", "into", "inside")
            if self.structural(place):
                if p.prep in ("on", "onto") and actor in self.scene.supported_by:
                    self.event(NodeEvent.FALL, (actor,), f, self._time(f))
                self.use(f, "end of the motion")
            elif inner and (self._holds(place) or self._enterable(place)):
                self._ensure_mover(f, actor, place)
                self.enter(f, actor, place, p.mention, self._time(f))
            else:
                self._ensure_mover(f, actor, place)
                self._hit(f, [actor], [place], self._time(f))

    def _do_swing(self, f: Frame, s: list[str], o: list[str]) -> None:
        into = f.phrase("into", "against", "onto")
        if o and into is not None and into.mention is not None and into.mention.entities:
            self._hit(f, o[:1], into.mention.entities[:1], self._time(f))
            return  # "a crane swings a beam into a scaffold"
        target = self._hit_targets(f, s, o)
        if f.phrase("at", "into", "against") is not None and target and s:
            self._hit(f, s[:1], target, self._time(f))
        else:
            self._motion(f, s, None)
