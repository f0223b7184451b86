"""Verbs of falling: drop, fall, land."""

from __future__ import annotations

import re

from esg.draft.acts import Acts
from esg.draft.frames import Frame, Phrase
from esg.draft.landings import Landings
from esg.draft.scene import SELF_POWERED
from esg.graph.models import NodeEvent

_UPRIGHT = frozenset({"domino", "plant", "post", "wall", "building", "structure"})
_OVERTURNED = frozenset({"person", "seat", "furniture", "appliance", "upright", "statue", "robot"})
"""What falls over where it stands, like those upright by themselves."""
_TWO_WHEELED = frozenset({"bicycle", "motorcycle", "scooter", "tricycle"})
_SOURCES = ("off", "from", "out of", "over", "down")
_LOOSE = re.compile(r"\b(?:loose|adrift|unhooked|uncoupled)\b", re.IGNORECASE)
_OTHER_SIDE = re.compile(r"\s+(?:down\s+)?on\s+(?:the|its)\s+(?:other|far)\s+side", re.IGNORECASE)
_HANGING = frozenset({"chandelier"})
STANDING_CM = 60.0
"""A thing that is this tall stands on the ground."""


class FallSenses(Landings):
    """Bodies that lose their support, and where they come down."""

    def _do_drop(self, f: Frame, s: list[str], o: list[str]) -> None:
        if not f.verb.passive and not o and f.object is not None and f.object.attribute:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "nothing is let go"
            return  # "releases the brakes"
        beyond = "over" in f.adverbs or f.phrase("behind", "beyond", "over", "past") is not None
        beyond = beyond or _OTHER_SIDE.match(self.text, f.verb.end) is not None
        under_way = bool(s) and all(i in self.tl.tracks or i in self.stated for i in s)
        if beyond and under_way and not (o or f.verb.passive or s[0] in self.scene.supported_by):
            self.use(f, "end of the flight")  # "clips the net and drops over"
            return
        if f.verb.lemma == "unload" and not o and not f.verb.passive:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "what is unloaded is not said"
            return
        things = s if f.verb.passive or not o else o
        agents = [x for x in s if x not in things]
        if agents:
            self.place(agents, things, "near")
        if things and all(self.kind(t) == "flyer" for t in things) and f.verb.lemma == "release":
            self._motion(f, things, "own")  # a glider flies on
            self._heights(f, things)
            return
        wheeled = bool(things) and self.kind(things[0]) in ("cart", "vehicle")
        if f.verb.lemma == "let" and wheeled and not self._raised(things[0]):
            self._motion(f, things, None)  # "lets go of a cart"
            return
        if self.quantity(f, "speed") is not None and f.verb.lemma == "release":
            self._motion_of_things(f, things, self._natural(things[0]) if things else "roll")
            return
        self._drop(f, things)

    def _raised(self, thing: str) -> bool:
        """Whether something holds it up that is no vehicle's driver: a crane, a magnet."""
        return thing in self.scene.supported_by or thing in self.scene.heights

    def _drop(self, f: Frame, things: list[str]) -> None:
        many = len(things) > 2
        moved = self._representatives(things, []) if many else things
        moved = [t for t in moved if self.movable(t)]
        source = f.phrase("off", "from")
        if source is not None and self._landed_before(f, source):
            source = None
        if source is not None and source.mention is not None:
            host = [i for i in source.mention.entities if self._elevated(i)]
            if host:
                for t in moved:
                    self.place([t], host, "on")
                    self._ensure_mover(f, t, None)
                    self.event(NodeEvent.FALL, (t,), f, self._time(f))
                self._landing(f, moved)
                return
        flying = {t for t in moved if self._airborne(t) and t not in self.scene.supported_by}
        for t in moved:
            if not self._moved_by_others(t):
                track = self.tl.tracks.get(t)
                if track is None or track.motion is None:
                    self._start_motion(f, [t], "drop")
        self._heights(f, moved)
        self.use(f, "drop")
        if "in" in f.adverbs and any(map(self._enterable, self._named())):
            self._goes_in(f, moved, self._time(f))  # "circles the hole and drops in"
            return
        if not self._landing(f, moved):
            for t in moved:
                if t in flying:
                    continue  # "drops behind the net" after a throw: it leaves no support
                self.pending[t] = (NodeEvent.FALL, f, None, self._time(f))

    def _leans_over(self, f: Frame, actors: list[str]) -> bool:
        """ "the first book falls against the second": it tips over beside it."""
        p = f.phrase("against")
        m = p.mention if p is not None else None
        met = [i for i in m.entities if i not in actors and self._aimable(i)] if m else []
        alone = f.phrase(*_SOURCES) is None and "off" not in f.adverbs
        solid = [a for a in actors if "round" not in self.e(a).noun.traits and self.movable(a)]
        beings = any(self.kind(a) in ("person", "animal") for a in actors)
        if not met or not alone or not solid or beings or self._airborne(solid[0]):
            return False
        if solid[0] in self.scene.heights or self._has_toppled(solid[0]):
            return False
        self._read_as("topple", f, solid, [])
        self._hit(f, solid[:1], met[:1])
        return True

    def _do_fall(self, f: Frame, s: list[str], o: list[str]) -> None:
        if _LOOSE.search(self.text, f.verb.start, f.verb.end) and s:
            rolling = all({"wheeled", "floating"} & self.e(i).noun.traits for i in s)
            if rolling or all(self.kind(i) in SELF_POWERED for i in s):
                self.scene.ignored[(f.verb.start, f.verb.end)] = "it is on its own from here on"
                return  # "a trailer comes loose from a pickup"
        if "in" in f.adverbs and not f.phrases and any(map(self._enterable, self._named())):
            self._goes_in(f, s, self._time(f))  # "pushes until the rubble falls in"
            return
        met = f.phrase("off")
        hosts = met.mention.entities if met is not None and met.mention is not None else o
        if f.verb.lemma == "come" and self._rebounds(s, hosts):
            self._read_as("hit", f, s, hosts[:1])  # "comes off the defender's knee"
            return
        towed = f.verb.lemma == "come" and bool(s) and not hosts and met is None
        if towed and all(self.e(i).noun.name == "trailer" for i in s):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "it is on its own from here on"
            return
        slope = f.phrase("down")
        if (
            slope is not None
            and slope.mention is not None
            and f.verb.lemma == "tumble"
            and any("incline" in self.e(i).noun.traits for i in slope.mention.entities)
        ):
            self._read_as("roll", f, s, [])
            return
        self._free([x for x in s if self.kind(x) in ("post", "plant", "wall", "street")])
        self._free([x for x in s if x in self.scene.attached])  # what hangs there comes down
        actors = self._representatives(s, [])
        fresh = [a for a in actors if a not in self.tl.tracks]
        if actors and all(map(self._has_toppled, actors)):
            down = f.phrase("off", "from", "out of", "over")
            if down is None and self._landing(f, actors):
                return
        if self._leans_over(f, actors):
            return
        upright = [a for a in actors if self._falls_over(a)]
        self._on_what_was_hit(f, fresh)
        ground = f.phrase("to")
        floor = ground.mention.entities if ground is not None and ground.mention else ["?"]
        down = bool(actors) and "?" not in floor and all(map(self.structural, floor))
        if down and not self._tall(actors[0]):
            self._place_where_hit(actors[0])  # "a vase tumbles to the floor"
            upright = []
        edge = f.phrase("off", "over", "from", "out of") or f.phrase("at")
        if edge is not None and self._off_the_edge(f, edge, actors, self._time(f)):
            self._landing(f, actors)
            return
        where = f.phrase("off", "from", "out of", "over", "down", "onto", "on", "into", "in")
        if (
            upright
            and not {"off", "out"} & {*f.adverbs, f.verb.extra.get("particle", "")}
            and (where is None or where.mention is None or where.mention.attribute)
            and a_rests_low(self, upright[0])
        ):
            self._read_as("topple", f, s, [])
            return
        low = [a for a in upright if a_rests_low(self, a)]
        if len(low) < len(actors) and low and where is None and not f.adverbs:
            self._read_as("topple", f, low, [])  # one of them falls off what he rides
            actors = [a for a in actors if a not in low]
        source = f.phrase(*_SOURCES)
        if source is not None and source.mention is not None and not source.mention.entities:
            source = None
        if source is not None and self._landed_before(f, source):
            source = None
        for actor in fresh:
            self._struck_before(f, actor)
        fresh = [a for a in fresh if a not in self.tl.tracks]
        into = f.phrase("into", "in", "through", "onto", "on")
        if (
            source is None
            and len(fresh) < len(actors)
            and into is not None
            and into.mention is not None
            and into.mention.entities
            and (into.prep in ("into", "in", "through") or self._on_its_way(f, actors, into))
        ):
            self._heights(f, actors)
            if self._landing(f, actors):
                return
        onto = f.phrase("on", "onto", "against")
        if upright and onto is not None and onto.mention is not None and source is None:
            struck = [i for i in onto.mention.entities if i not in actors and self._aimable(i)]
            flat = onto.mention.entities and all(map(self.structural, onto.mention.entities))
            if flat and a_rests_low(self, upright[0]) and self.kind(upright[0]) in _UPRIGHT:
                self._read_as("topple", f, s, [])
                return
            if struck and self.kind(upright[0]) in ("person", "animal"):
                self._hit(f, upright[:1], struck[:1], self._time(f))
                return
            if struck and a_rests_low(self, upright[0]) and self.kind(upright[0]) != "bottle":
                self._read_as("topple", f, s, [])
                self._hit(f, upright[:1], struck[:1])
                return
        on_something = [a for a in fresh if a in self.scene.supported_by]
        if (
            fresh
            and source is None
            and f.phrase("onto", "on", "into", "in") is None
            and not on_something
        ):
            self._drop(f, actors)
            return
        if on_something:
            source = f.phrase("to") or source
            fresh_low: list[str] = []
        else:
            fresh_low = fresh
        fresh, held = fresh_low, fresh
        if held and not fresh:
            for actor in held:
                self._start_motion(
                    f, [actor], "roll" if "round" in self.e(actor).noun.traits else "slide"
                )
        if fresh and source is None:
            self._drop(f, fresh)
            return
        for actor in actors:
            if not self.movable(actor):
                continue
            lands = source is None and actor not in self.scene.supported_by
            if lands and self._thrown_up(actor) and not self._bounced(actor):
                self.use(f, "end of the flight")
                continue
            if source is not None and source.mention is not None and source.mention.entities:
                host = source.mention.entities[0]
                if host != actor and self._elevated(host):
                    self.place([actor], [host], "on")
            self._heights(f, [actor])
            if actor in fresh:
                high = (
                    source is not None
                    and source.mention is not None
                    and source.mention.entities
                    and not self._elevated(source.mention.entities[0])
                )
                if high or (actor in self.scene.heights and actor not in self.scene.supported_by):
                    self._start_motion(f, [actor], "drop")
                else:
                    self._start_motion(
                        f, [actor], "roll" if "round" in self.e(actor).noun.traits else "slide"
                    )
            self.event(NodeEvent.FALL, (actor,), f, self._time(f))
        landing = f.phrase("onto", "into", "on", "in")
        if (
            landing is not None
            and landing.mention is not None
            and landing.mention.entities
            and not self.structural(landing.mention.entities[0])
        ):
            self._landing(f, actors)

    def _falls_over(self, node: str) -> bool:
        """Whether "falls" means that it topples, where it stands on the ground."""
        e = self.e(node)
        if e.noun.name in _HANGING and node not in self.scene.supported_by:
            return False
        if "topples" in e.noun.traits or e.noun.kind in _UPRIGHT | _OVERTURNED:
            return True
        if e.pattern == "stack" and e.in_group and not e.place:
            return True
        if node in self.leaning or e.noun.name in _TWO_WHEELED:
            return True
        runs = node in self.tl.tracks and node not in self.scene.supported_by
        return runs and e.noun.kind == "animal" and not self._airborne(node)

    def _rebounds(self, things: list[str], hosts: list[str]) -> bool:
        """Whether what comes off is a ball or puck, and what it comes off holds none."""
        flying = things and all(self.kind(i) in ("ball", "billiard", "sliding") for i in things)
        firm = ("person", "post", "goal", "wall", "animal", "robot", "hoop")
        return bool(flying and hosts) and self.kind(hosts[0]) in firm

    def _tall(self, node: str) -> bool:
        """Whether it is so tall that it stands on the ground rather than on something."""
        size = self.e(node).dimensions_cm or self.e(node).noun.dimensions_cm
        tall = size[2] >= STANDING_CM or self.kind(node) in ("person", "animal", "wall")
        return tall or self.kind(node) == "domino" or node in self.leaning

    def _landed_before(self, f: Frame, source: Phrase) -> bool:
        """Whether what it falls from is named after what it first lands in."""
        if source.mention is None:
            return False
        earlier = [p for p in f.phrases if p.mention and p.mention.start < source.mention.start]
        return any(p.prep in ("onto", "into") for p in earlier)

    def _on_its_way(self, f: Frame, actors: list[str], onto: Phrase) -> bool:
        """ "slips and tumbles onto a drum": it comes from no support that the prompt names."""
        hosts = self.scene.supported_by
        solid = onto.mention is not None and not self.structural(onto.mention.entities[0])
        upright = any(self._falls_over(a) and a not in hosts for a in actors)
        return solid and not upright and not any(a in hosts for a in actors)

    def _has_toppled(self, body: str) -> bool:
        return any(n.event is NodeEvent.TOPPLE and body in n.participants for n in self.tl.nodes)

    def _thrown_up(self, body: str) -> bool:
        """In flight after a throw, so that it leaves no support when it lands."""
        track = self.tl.tracks.get(body)
        flights = [e.params.elevation_deg for e in self.tl.edges if e.actor == body]
        if track is not None and track.motion is not None and track.motion.mode != "coast":
            return track.motion.mode in ("throw", "fly")
        return any(x not in (None, -90.0) for x in flights)

    def _bounced(self, body: str) -> bool:
        """ "hits the window and falls to the ground": it comes down from what it hit."""
        last = next((n for n in reversed(self.tl.nodes) if body in n.participants), None)
        return last is not None and last.event is NodeEvent.COLLISION

    def _do_land(self, f: Frame, s: list[str], o: list[str]) -> None:
        whole = len(s) > 1 and self.e(s[0]).group in self.world.collective
        s = self._representatives(s, []) if whole else s  # "a stack of books lands on a dog"
        for actor in s:
            self._struck_before(f, actor)
            if actor not in self.tl.tracks and not self._moved_by_others(actor):
                self._start_motion(f, [actor], "drop")
                ground = f.phrase("on", "onto", "in", "upon")
                under = ground.mention.entities if ground and ground.mention else []
                flat = any(map(self.structural, under))
                if flat and self.kind(actor) not in ("flyer", "animal", "person"):
                    self.event(NodeEvent.FALL, (actor,), f, self._time(f))
        if not self._landing(f, s):
            self.use(f, "landing")
        self.use(f, "landing")


def a_rests_low(acts: Acts, node: str) -> bool:
    """Whether an upright thing stands on the ground, so that "falls" means that it topples."""
    e = acts.e(node)
    if acts.kind(node) == "domino" or (e.pattern == "stack" and e.in_group and not e.place):
        return True
    return node not in acts.scene.supported_by and node not in acts.scene.heights
