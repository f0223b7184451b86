"""From clause frames to objects, relations, motions and events."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from esg.draft import lexicon as lex
from esg.draft.clauses import Frame, Phrase
from esg.draft.quantities import Amount
from esg.draft.syntax import Mention
from esg.draft.timeline import LAUNCHES, Motion, TimelineBuilder
from esg.draft.world import Entity, World
from esg.graph.models import EventConstraint, ForceDirection, NodeEvent, Quantity, Role

SELF_POWERED = frozenset({"vehicle", "person", "animal", "robot", "cart", "toyvehicle", "watercraft", "flyer"})
_THINGS_DO = frozenset({"hit", "enter", "land", "bounce", "miss", "scatter", "fall"})
"""Senses that, after "the boy throws a ball and ...", are about the ball."""
_ANIMAL_VERBS = frozenset(
    {"run", "walk", "jog", "gallop", "trot", "jump", "leap", "hop", "crawl", "sprint", "dash", "charge", "sleep", "sit",
     "chase", "wander", "swim", "climb", "stroll", "march", "pursue"}
)  # fmt: skip
_VEHICLE_VERBS = frozenset({"drive", "brake", "accelerate", "overtake", "park", "steer", "cruise", "merge", "reverse", "swerve", "speed"})
_AIRBORNE = frozenset({"projectile", "tool", "tableware", "book", "rock"})
_OPEN = frozenset({"container", "hoop", "hole", "goal", "region", "box", "water"})
SPEEDS: dict[str, Quantity] = {
    "vehicle": (300.0, 2000.0), "toyvehicle": (50.0, 300.0), "person": (80.0, 600.0),
    "animal": (80.0, 800.0), "robot": (30.0, 200.0), "cart": (50.0, 400.0),
    "watercraft": (50.0, 500.0), "flyer": (200.0, 1500.0), "roll": (100.0, 1000.0),
    "slide": (100.0, 800.0), "throw": (300.0, 2000.0), "drop": 0.0, "fly": (300.0, 2000.0),
    "billiard": (50.0, 600.0), "projectile": (500.0, 4000.0),
}  # fmt: skip
"""Plausible speeds [cm/s] where the prompt gives none; sources in docs/drafting.md."""


@dataclass
class Relation:
    """A spatial relation: `source` is <kind> `target`."""

    source: str
    target: str
    kind: str
    distance: Quantity | None = None
    text: str = ""


@dataclass
class Scene:
    """What the prompt says, ready to be written as a document."""

    world: World
    timeline: TimelineBuilder
    text: str = ""
    relations: list[Relation] = field(default_factory=list)
    needs: list[tuple[str, str]] = field(default_factory=list)
    """Implied supports: (kind of need, node id)."""
    supported_by: dict[str, str] = field(default_factory=dict)
    inside_of: dict[str, str] = field(default_factory=dict)
    heights: dict[str, Quantity] = field(default_factory=dict)
    facing: dict[str, str] = field(default_factory=dict)
    travel: dict[str, Amount] = field(default_factory=dict)
    """Stated distance of a motion, by actor."""
    used: dict[tuple[int, int], str] = field(default_factory=dict)
    """Spans that became something: (start, end) -> pointer or note."""
    ignored: dict[tuple[int, int], str] = field(default_factory=dict)
    warnings: list[str] = field(default_factory=list)


_RELATION_PREPS: dict[str, str] = {
    "on": "on", "onto": "on", "upon": "on", "atop": "on", "under": "under", "beneath": "under",
    "below": "under", "underneath": "under", "in front of": "in_front_of", "behind": "behind",
    "left of": "left_of", "right of": "right_of", "near": "near", "beside": "adjacent",
    "next to": "adjacent", "by": "near", "alongside": "adjacent", "far from": "far_from",
    "above": "above", "over": "above", "inside": "inside_of", "in": "inside_of",
    "within": "inside_of", "against": "adjacent", "around": "near", "at": "near",
    "in the middle of": "center_of", "opposite": "near", "between": "between", "among": "near",
    "across": "near", "outside": "near", "along": "near", "close": "near",
}  # fmt: skip


class Interpreter:
    """Walks over frames in order of time and fills a Scene."""

    def __init__(self, world: World, text: str) -> None:
        self.world = world
        self.text = text
        self.tl = TimelineBuilder()
        self.scene = Scene(world, self.tl)
        self.aim: dict[str, str] = {}
        """Last thing an actor moves towards."""
        self.last_hit: tuple[str, str] | None = None
        self.mentions: list[Mention] = []
        self.pending: dict[str, tuple[NodeEvent, Frame, str | None, tuple[Quantity, Amount, str] | None]] = {}
        """Arrivals ("walks to the door") and falls that a later event may replace."""
        self._patient: list[str] = []
        self.stated: dict[str, Amount] = {}
        """Speeds stated with the noun ("a car at 50 km/h")."""
        self._topic: tuple[int, list[str]] | None = None
        """Sentence and subject of the last description of a state."""
        self.thrown: dict[int, list[str]] = {}
        """What the person of a subject phrase launched last."""

    # -- utilities -------------------------------------------------------------------------------

    def e(self, node: str) -> Entity:
        return self.world.entities[node]

    def kind(self, node: str) -> str:
        return self.e(node).noun.kind

    def structural(self, node: str) -> bool:
        return "structural" in self.e(node).noun.traits

    def _aimable(self, node: str) -> bool:
        return not self.structural(node) and self.kind(node) != "region"

    def movable(self, node: str) -> bool:
        return self.e(node).movable

    def use(self, item: Amount | Frame | Mention | None, note: str) -> None:
        if item is None:
            return
        if isinstance(item, Frame):
            self.scene.used[(item.verb.start, item.verb.end)] = note
        else:
            self.scene.used[(item.start, item.end)] = note

    def describe(self, f: Frame) -> str:
        ends = [f.verb.end]
        starts = [f.verb.start]
        for m in (f.subject, f.object):
            if m is not None:
                starts.append(m.start)
                ends.append(m.end)
        for p in f.phrases:
            if p.mention is not None:
                ends.append(p.mention.end)
            if p.amount is not None:
                ends.append(p.amount.end)
        if max(ends) - min(starts) > 160:
            return self.text[f.verb.start : f.verb.end]
        return self.text[min(starts) : max(ends)]

    def ids(self, m: Mention | None, subject: bool = False, avoid: list[str] | None = None) -> list[str]:
        if m is None:
            return []
        return self.world.resolve(m, subject=subject, avoid=avoid)

    def amounts(self, f: Frame) -> list[tuple[str, Amount]]:
        """(preposition, amount) of a frame, those inside attribute phrases included."""
        out: list[tuple[str, Amount]] = []
        for p in f.phrases:
            if p.amount is not None:
                out.append((p.prep, p.amount))
            if p.mention is not None:
                out += [(p.prep, a) for a in p.mention.amounts if p.mention.attribute]
                for m in p.mention.coordinated:
                    out += [(p.prep, a) for a in m.amounts if m.attribute]
        for m in (f.object, f.object2):
            if m is not None and m.attribute:
                out += [("", a) for a in m.amounts]
        if f.subject is not None:
            out += [("", a) for a in f.subject.amounts if a.dimension == "speed"]
        return out

    def quantity(self, f: Frame, dimension: str) -> tuple[str, Amount] | None:
        return next(((p, a) for p, a in self.amounts(f) if a.dimension == dimension), None)

    # -- entry -----------------------------------------------------------------------------------

    def run(self, frames: list[Frame], attachments: list[tuple[Mention, Phrase]]) -> Scene:
        # references are resolved in the order of the text, events in the order of time
        self._refer_all(frames)
        for m, p in attachments:
            self.attachment(m, p)
        for f in frames:
            self.frame(f)
        self._settle(None, None)
        return self.scene

    def attachment(self, m: Mention, p: Phrase) -> None:
        """A noun phrase with a prepositional phrase: a place or a property."""
        owners = m.entities or self.ids(m)
        if p.amount is not None:
            for o in owners:
                if p.amount.dimension == "speed":
                    self.stated[o] = p.amount
                elif self.world.apply_amount(self.e(o), p.amount):
                    self.use(p.amount, o)
            return
        if p.mention is None:
            return
        if p.mention.attribute:
            for a in p.mention.amounts:
                for o in owners:
                    if a.dimension == "speed":
                        self.stated[o] = a
                    elif self.world.apply_amount(self.e(o), a, p.mention.head):
                        self.use(a, o)
            return
        others = p.mention.entities or self.ids(p.mention, avoid=owners)
        if p.prep == "with":
            # "a table with bottles on it": the on-phrase places them; else they rest on a support
            for o in others:
                if owners and o not in self.scene.supported_by and o not in owners:
                    host = self.e(owners[0]).noun
                    if "support" in host.traits or "container" in host.traits:
                        self.place([o], owners, "on" if "support" in host.traits else "in")
                    else:
                        self.scene.relations.append(Relation(o, owners[0], "near"))
            return
        self.place(owners, others, p.prep, p.mention.part)

    def place(self, things: list[str], others: list[str], prep: str, part: str = "",
              distance: Quantity | None = None) -> None:  # fmt: skip
        """Records where things are with respect to others."""
        kind = _RELATION_PREPS.get(prep)
        if kind is None or not others:
            return
        if part:
            words = part.split()
            if words[-1] in ("edge", "corner", "rim", "end") and "support" in self.e(others[0]).noun.traits:
                kind = "on"
            elif words[-1] in ("middle", "center", "centre"):
                kind = "center_of"
            elif words[-1] in ("side", "front", "back", "end", "left", "right") and kind in ("on", "near", "inside_of"):
                kind = {"front": "in_front_of", "back": "behind"}.get(words[-1], "adjacent")
            elif words[-1] in ("bottom", "foot", "base") and kind != "on":
                kind = "near"
        other = others[0]
        for t in things:
            if t == other or t not in self.world.entities:
                continue
            if self.structural(t):
                continue
            if self.structural(other):
                self.scene.relations.append(Relation(t, other, "structural", text=prep))
                continue
            if kind == "inside_of" and not self._holds(other):
                kind = "on" if "support" in self.e(other).noun.traits else "near"
            if kind == "on" and self.kind(other) in ("ball", "billiard"):
                kind = "near"
            if kind == "between" and len(others) < 2 and len(things) >= 1:
                kind = "near"
            if kind == "between":
                self.scene.relations.append(Relation(t, others[0], "between", text=others[1]))
                continue
            if kind == "on":
                if t in self.scene.supported_by or self._rests_on(other, t):
                    continue
                self.scene.supported_by[t] = other
            elif kind == "inside_of":
                if t in self.scene.supported_by or self._rests_on(other, t):
                    continue
                self.scene.supported_by[t] = other
                self.scene.inside_of[t] = other
            self.scene.relations.append(Relation(t, other, kind, distance))

    def _rests_on(self, a: str, b: str) -> bool:
        seen: set[str] = set()
        while a in self.scene.supported_by and a not in seen:
            seen.add(a)
            a = self.scene.supported_by[a]
            if a == b:
                return True
        return a == b

    def _holds(self, node: str) -> bool:
        return bool({"container", "goal"} & self.e(node).noun.traits)

    # -- frames ----------------------------------------------------------------------------------

    def _refer_all(self, frames: list[Frame]) -> None:
        """Resolves every noun phrase, frame by frame and in the order of the text."""
        framed: set[int] = set()
        items: list[tuple[int, int, Frame | Mention]] = []
        for f in frames:
            mentions = [f.subject, f.object, f.object2, *[p.mention for p in f.phrases]]
            own = [m for m in mentions if m is not None and id(m) not in framed]
            framed |= {id(m) for m in own}
            framed |= {id(c) for m in own for c in m.coordinated}
            items.append((min([f.verb.start, *[m.start for m in own]]), f.verb.start, f))
        for m in self.mentions:
            if id(m) not in framed:
                items.append((m.start, m.start, m))
        items.sort(key=lambda item: item[:2])
        for _, _, item in items:
            if isinstance(item, Frame):
                self._refer(item)
            elif id(item) not in self.world.resolved and (item.head or item.pronoun) and item.count != 0:
                self.world.resolve(item)

    def _refer(self, f: Frame) -> None:
        """Resolves the noun phrases of a frame, subject first."""
        subject = self._subject(f)
        for m in (f.object, *[p.mention for p in f.phrases]):
            # "A vase stands on a table. A ball hits it.": the vase
            if (
                m is not None
                and m.pronoun == "it"
                and self._topic is not None
                and self._topic[0] == f.sentence - 1
                and len(self._topic[1]) == 1
                and self._topic[1] != subject
                and id(m) not in self.world.resolved
                and f.subject is not None
                and f.subject.determiner in ("a", "an")
            ):
                self.world.resolved[id(m)] = m.entities = list(self._topic[1])
        if f.object is not None and f.subject is not None and f.object.start < f.subject.start:
            objects = list(f.object.entities) or self.ids(f.object)
        else:
            objects = self.ids(f.object, avoid=subject)
        self.ids(f.object2, avoid=subject + objects)
        for p in f.phrases:
            if p.mention is not None:
                self.ids(p.mention, avoid=subject + objects)
        self._patient = objects or self._patient
        if f.verb.sense in ("be", "posture", "have", "park") and (subject or objects):
            self._topic = (f.sentence, subject or objects)

    def _subject(self, f: Frame) -> list[str]:
        """Referents of the subject; what falls after a push is the thing pushed."""
        m = f.subject
        if (
            m is not None
            and m.pronoun in ("it", "they")
            and id(m) not in self.world.resolved
            and f.verb.sense in ("fall", "topple", "land", "pocket")
            and self._patient
            and (m.pronoun == "it") == (len(self._patient) == 1)
        ):
            self.world.resolved[id(m)] = m.entities = list(self._patient)
        return self.ids(m, subject=True)

    def _settle(self, actor: str | None, kind: NodeEvent | None, target: str | None = None) -> None:
        """Turns a pending arrival or landing into an event, unless a stronger event replaces it."""
        for name in list(self.pending):
            if actor is not None and name != actor:
                continue
            event, f, other, time = self.pending.pop(name)
            if event is NodeEvent.FALL and f.verb.sense == "fall":
                self.event(event, (name,), f, time)
                continue
            replaced = kind in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION, NodeEvent.REACH, NodeEvent.TOPPLE,
                                NodeEvent.FALL) and (event is NodeEvent.FALL or target in (other, None))  # fmt: skip
            if replaced or (event is NodeEvent.REACH and kind is NodeEvent.STOP):
                continue
            participants = (name,) if other is None else (name, other)
            self.event(event, participants, f, time)

    def frame(self, f: Frame) -> None:
        sense = f.verb.sense
        subject = list(f.subject.entities) if f.subject is not None else []
        objects = list(f.object.entities) if f.object is not None else []
        if f.object2 is not None:
            objects += [i for i in f.object2.entities if i not in objects]
        for p, a in self.amounts(f):
            if a.dimension == "mass" and subject:
                owner = objects[0] if objects and sense not in ("weigh", "be") else subject[0]
                owners = subject if sense in ("weigh", "be", "have") else [owner]
                for o in owners:
                    self.world.apply_amount(self.e(o), a)
                self.use(a, owners[0])
        if f.verb.negated and sense in ("hit", "enter"):
            f.verb.sense = sense = "miss"
        elif f.verb.negated and sense not in ("be", "posture", "miss"):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "negated"
            return
        if f.subject is not None and sense in _THINGS_DO and f.subject.start < f.verb.start:
            flying = self.thrown.get(id(f.subject))
            if flying and not set(flying) & set(objects) and all(self.kind(i) == "person" for i in subject):
                subject = list(flying)
        for node in subject if not f.verb.passive else []:
            self._guess_kind(node, f.verb.lemma)
        handler = getattr(self, f"_do_{sense}", None)
        if handler is None:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"
            return
        handler(f, subject, objects)

    def _guess_kind(self, node: str, lemma: str) -> None:
        """An unknown noun is what its verb says: what gallops is an animal, what brakes a vehicle."""
        entity = self.e(node)
        if entity.known or entity.noun.kind != "generic":
            return
        model = "dog" if lemma in _ANIMAL_VERBS else "car" if lemma in _VEHICLE_VERBS else None
        if model is not None:
            like = lex.nouns()[model]
            entity.noun = replace(like, name=entity.head, description=f"{entity.head}, like a {model}", synonyms=())

    # static -------------------------------------------------------------------------------------

    def _do_be(self, f: Frame, s: list[str], o: list[str]) -> None:
        things = s or o
        if f.subject is not None and f.subject.attribute and f.subject.possessor is None and not s:
            things = o
        if o and s and f.object is not None and f.object.attribute is False:
            self.use(f, "copula")
        self._places(f, things)
        for _, a in self.amounts(f):
            if a.dimension == "length":
                word = next((x for x in f.adverbs), "")
                after = self.text[a.end : a.end + 12].strip().split(" ")[0].strip(".,;")
                if after in ("tall", "high", "wide", "long", "thick", "deep"):
                    for t in things:
                        self.world.apply_amount(self.e(t), a, after)
                    self.use(a, word or after)
        self.use(f, "state")

    _do_posture = _do_be

    def _do_park(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive or f.reduced or f.verb.form == "pp" or not s or self.kind(s[0]) not in SELF_POWERED:
            self._do_be(f, s, o)
            return
        self._stop(f, s[0], self._time(f))
        self._places(f, s)

    def _do_unknown(self, f: Frame, s: list[str], o: list[str]) -> None:
        """Left out of the used spans, so that the coverage record reports the verb."""

    def _do_acquire(self, f: Frame, s: list[str], o: list[str]) -> None:
        found = self.quantity(f, "speed")
        if found is not None and s and not self._speed_after(s[0], found[1]):
            self._do_accelerate(f, s, o)
        self.use(f, "speed")

    def _do_weigh(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.use(f, "mass")

    def _do_have(self, f: Frame, s: list[str], o: list[str]) -> None:
        for _, a in self.amounts(f):
            word = f.object.head if f.object is not None else ""
            for t in s:
                if self.world.apply_amount(self.e(t), a, word):
                    self.use(a, t)
        if s and o and f.phrase("on", "in", "inside") is None:
            self.attachment_with(s, o)
        self._places(f, o)
        self.use(f, "property")

    def attachment_with(self, owners: list[str], others: list[str]) -> None:
        host = self.e(owners[0]).noun
        prep = "on" if "support" in host.traits else "in" if "container" in host.traits else "near"
        self.place(others, owners, prep)

    def _do_measure(self, f: Frame, s: list[str], o: list[str]) -> None:
        for _, a in self.amounts(f):
            for t in s:
                if self.world.apply_amount(self.e(t), a):
                    self.use(a, t)
        self.use(f, "size")

    def _do_contain(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and o:
            self.place(o, s, "in" if self._holds(s[0]) else "on")
        self.use(f, "state")

    def _do_face(self, f: Frame, s: list[str], o: list[str]) -> None:
        target = o or [i for p in f.phrases if p.mention for i in p.mention.entities]
        for t in s:
            if target and target[0] != t:
                self.scene.facing[t] = target[0]
        self.use(f, "facing")

    def _do_surround(self, f: Frame, s: list[str], o: list[str]) -> None:
        inner, outer = (s, [i for p in f.phrases if p.prep in ("by", "with") and p.mention for i in p.mention.entities]) if f.verb.passive else (o, s)
        if inner and outer:
            for t in outer:
                self.scene.relations.append(Relation(t, inner[0], "surround"))
        self.use(f, "state")

    def _places(self, f: Frame, things: list[str]) -> None:
        distance = next((a for p, a in self.amounts(f) if a.dimension == "length" and p in ("", "at", "about")), None)
        for p in f.phrases:
            if p.mention is None or p.mention.attribute:
                continue
            others = p.mention.entities
            if p.prep == "with" and f.verb.lemma in ("cover", "load", "fill", "stack", "set"):
                for t in things[:1]:
                    self.attachment_with([t], others)
                continue
            if p.prep in _RELATION_PREPS:
                fixed = None
                if distance is not None and p.prep not in ("on", "in", "inside"):
                    fixed = distance.value
                    self.use(distance, "distance")
                self.place(things, others, p.prep, p.mention.part, fixed)
            elif p.prep in ("from", "away from") and distance is not None and others:
                for t in things:
                    self.scene.relations.append(Relation(t, others[0], "near", distance.value))
                self.use(distance, "distance")

    # motion -------------------------------------------------------------------------------------

    def _speed(self, f: Frame, actors: list[str], mode: str) -> tuple[Quantity | None, bool]:
        found = self.quantity(f, "speed")
        stated = next((self.stated[x] for x in actors if x in self.stated), None)
        if found is None and stated is not None:
            found = ("at", stated)
        if found is not None:
            self.use(found[1], "speed")
            a = found[1]
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

    def _launch(self, actor: str, mode: str, speed: Quantity | None, prescribed: bool, target: str | None = None) -> None:
        params: dict[str, object] = {}
        if mode == "throw" or mode == "fly":
            params = {"elevation_deg": (-10.0, 60.0), "spin": "none"}
        elif mode == "drop":
            params, speed = {"elevation_deg": -90.0, "spin": "none"}, 0.0
        elif mode == "roll":
            params = {"spin": "roll" if "round" in self.e(actor).noun.traits else "slide"}
        elif mode == "slide":
            params = {"spin": "slide"}
        self.tl.move(actor, Motion(mode, speed, prescribed, target, params), self._direction(actor, mode))

    def _own(self, actor: str, speed: Quantity | None, prescribed: bool, target: str | None = None) -> None:
        self.tl.move(actor, Motion("own", speed, prescribed, target), self._direction(actor, "own"))

    def _start_motion(self, f: Frame, actors: list[str], mode: str | None = None, target: str | None = None) -> None:
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

    def _moved_by_others(self, actor: str) -> bool:
        track = self.tl.tracks.get(actor)
        return track is not None and track.hit and track.role is Role.PASSIVE

    def _target(self, f: Frame, avoid: list[str]) -> list[str]:
        p = f.phrase("towards", "toward", "at", "to", "into", "onto", "against", "after", "on", "in")
        if p is None or p.mention is None:
            return []
        return [i for i in p.mention.entities if i not in avoid]

    def _motion(self, f: Frame, actors: list[str], mode: str | None) -> None:
        """Common part of all self motion: speed, target, and what the phrases say happens."""
        if not actors:
            self.scene.warnings.append(f'It is not clear what "{self.text[f.verb.start:f.verb.end]}" moves.')
            return
        target = self._target(f, actors)
        aim = next((t for t in target if self._aimable(t)), None)
        for actor in actors:
            if aim is not None:
                self.aim[actor] = aim
            if self._moved_by_others(actor) and (mode != "own" or self.kind(actor) not in SELF_POWERED):
                continue
            track = self.tl.tracks.get(actor)
            if track is not None and track.launched and track.motion is not None and mode in (None, *LAUNCHES):
                stated = self.quantity(f, "speed")
                if stated is not None and not track.closed:
                    track.motion.speed, track.motion.prescribed = self._speed(f, [actor], track.motion.mode)
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
        duration = next((a for p, a in self.amounts(f) if a.dimension == "time" and p == "for"), None)
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
        for side, kind in (("ahead", "in_front_of"), ("behind", "behind"), ("in front", "in_front_of")):
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
                if track is not None and track.motion is not None:
                    self.scene.travel[actors[0]] = a
                    self.use(a, "distance travelled")

    def _outcomes(self, f: Frame, actors: list[str], movers_hit: bool = False) -> None:
        """Events that a motion's prepositional phrases state: into, off, onto, against, past."""
        time = self._time(f)
        for p in f.phrases:
            if p.mention is None or p.mention.attribute and not p.mention.entities:
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
                elif p.prep in ("off", "from", "out of", "over") and p.prep != "from" or (
                    p.prep == "from" and f.verb.sense in ("fall", "slide", "drop")
                ):
                    if self._elevated(other) and (p.prep != "over" or p.mention.part):
                        self.place([actor], [other], "on")
                        self.event(NodeEvent.FALL, (actor,), f, time)
                elif p.prep == "onto" and not self.structural(other):
                    self._hit(f, [actor], [other], time)
                elif p.prep in ("down", "up") and "incline" in self.e(other).noun.traits:
                    self.place([actor], [other], "on" if p.prep == "down" else "near")
                elif p.prep == "past":
                    self.event(NodeEvent.MISS, (actor, other), f, time)
                elif p.prep == "to" and not self.structural(other) and not p.mention.attribute:
                    self.pending[actor] = (NodeEvent.REACH, f, other, time)

    def _elevated(self, node: str) -> bool:
        noun = self.e(node).noun
        return not self.structural(node) and ("support" in noun.traits or noun.kind in ("box", "building", "wall", "plant", "block", "vehicle", "statue", "barrel", "appliance"))

    def _go_into(self, f: Frame, actor: str, others: list[str], p: Phrase, time: tuple[Quantity, Amount] | None) -> None:
        other = others[0]
        noun = self.e(other).noun
        if self.structural(other):
            return
        if p.prep in ("in", "inside", "through") and f.verb.sense not in ("cause", "fall", "land", "pocket", "launch", "drop", "reach"):
            if "goal" not in noun.traits and noun.kind != "region":
                return
        airborne = self._airborne(actor) or f.verb.sense in ("fall", "drop", "land", "pocket", "fly")
        enterable = noun.kind in ("region", "goal", "hole", "hoop") or "goal" in noun.traits or noun.kind == "water"
        if enterable or ("container" in noun.traits and airborne):
            self.enter(f, actor, other, p.mention, time)
        else:
            self._hit(f, [actor], others, time)

    def _airborne(self, actor: str) -> bool:
        track = self.tl.tracks.get(actor)
        if track is None:
            return False
        if track.motion is not None and track.motion.mode in ("throw", "drop", "fly"):
            return True
        return any(e.actor == actor and e.params.elevation_deg is not None for e in self.tl.edges)

    def enter(self, f: Frame, actor: str, other: str, m: Mention | None, time: tuple[Quantity, Amount] | None) -> None:
        noun = self.e(other).noun
        if noun.kind == "region":
            host = next((i for i, e in self.world.entities.items() if e.noun.kind == "billiardtable"), "")
            region = f"{host or 'billiard_table_1'}/{pocket_name(self.e(other).adjectives)}"
            self.scene.needs.append(("billiard_table", actor))
        else:
            region = f"{other}/inside"
        node = self.event(NodeEvent.ENTER_REGION, (actor,), f, time, region=region)
        draft = self.tl.node(node)
        if draft is not None:
            draft.extra["region"] = region

    # events -------------------------------------------------------------------------------------

    def _time(self, f: Frame) -> tuple[Quantity, Amount, str] | None:  # type: ignore[override]
        for p, a in self.amounts(f):
            if a.dimension == "time" and p in ("after", "in", "within", "at", "by", "", "exactly", "about", "around", "before", "later"):
                value: Quantity = a.value
                if p == "within" or a.bound == "max" or p == "before":
                    value = (0.05 * a.high, a.high)
                elif a.bound == "min":
                    value = (a.low, 2.0 * a.low + 1.0)
                mode = "at" if p == "at" else "after"
                return value, a, mode
        return None

    def event(self, kind: NodeEvent, participants: tuple[str, ...], f: Frame, time: tuple[Quantity, Amount, str] | None, **extra: object) -> str:  # type: ignore[type-arg]
        """Adds a point event with the stated time, absolute or relative."""
        for actor in participants[:1]:
            if extra.get("stem") == "brake":
                break
            self._settle(actor, kind, participants[1] if len(participants) > 1 else None)
        stop_timed = kind is NodeEvent.STOP
        previous = self.tl.last_event
        node_id = ""
        if time is not None and (time[1].start, time[1].end) in self.scene.used:
            time = None
        if time is not None and (previous is None or time[2] == "at") and not stop_timed:
            node_id = self.tl.event(kind, participants, self.describe(f), time=time[0], prescribed=True, **extra)
        else:
            node_id = self.tl.event(kind, participants, self.describe(f), **extra)
        draft = self.tl.node(node_id)
        assert draft is not None
        if time is not None:
            self.use(time[1], f"time of {node_id}")
            if stop_timed:
                braked = any(e.to == node_id and e.event.value == "Brake" for e in self.tl.edges)
                if braked:
                    draft.constraints.append(EventConstraint(quantity="time_to_stop", object=participants[0], value=time[0]))
                elif previous is None:
                    draft.time, draft.time_prescribed = time[0], True
                else:
                    draft.constraints.append(EventConstraint(quantity="time_since", object=participants[0], value=time[0], since=previous))
            elif previous is not None and time[2] != "at":
                draft.constraints.append(EventConstraint(quantity="time_since", object=participants[0], value=time[0], since=previous))
        travelled = self.scene.travel.pop(participants[0], None)
        if travelled is not None:
            draft.constraints.append(EventConstraint(quantity="distance", object=participants[0], value=travelled.value))
        self.use(f, node_id)
        return node_id

    def _ensure_mover(self, f: Frame, mover: str, target: str | None) -> None:
        track = self.tl.tracks.get(mover)
        if track is not None and (track.motion is not None or track.hit):
            return
        self._start_motion(f, [mover], None, target)

    def _hit(self, f: Frame, movers: list[str], targets: list[str], time: object = None) -> list[str]:
        """Collision events of movers with targets (one for a plural of things in a group)."""
        out: list[str] = []
        targets = self._representatives(targets, movers)
        for mover in movers:
            for target in targets:
                if mover == target or mover not in self.world.entities:
                    continue
                if not self.movable(mover):
                    mover, target = target, mover
                    if not self.movable(mover):
                        continue
                self._ensure_mover(f, mover, target)
                out.append(self.event(NodeEvent.COLLISION, (mover, target), f, time))  # type: ignore[arg-type]
                self.last_hit = (mover, target)
                time = None
        return out

    def _representatives(self, targets: list[str], movers: list[str]) -> list[str]:
        """A plural counts as one target: its first member."""
        out: list[str] = []
        seen: set[str] = set()
        for t in targets:
            group = self.e(t).group
            if t in movers:
                continue
            if group is not None and not self.e(t).letter and not self.e(t).place:
                if group in seen:
                    continue
                seen.add(group)
            out.append(t)
        return out

    def _hit_targets(self, f: Frame, s: list[str], o: list[str]) -> list[str]:
        if o:
            return o
        p = f.phrase("with", "into", "against", "at", "on", "onto", "to", "in")
        if p is not None and p.mention is not None and not (p.prep == "in" and p.mention.attribute):
            found = [i for i in p.mention.entities if i not in s]
            if found:
                return found
        return []

    def _do_hit(self, f: Frame, s: list[str], o: list[str]) -> None:
        time = self._time(f)
        if f.object is not None and f.object.attribute and not o:
            o = []
        if f.verb.passive:
            by = f.phrase("by")
            by = by or f.phrase("with")
            movers = by.mention.entities if by is not None and by.mention is not None else []
            if not movers:
                movers = [a for a, t in self.tl.tracks.items() if t.motion is not None and a not in s][-1:]
            if not movers and s:
                self._motion(f, s, None)  # "a cue ball is struck at 3 m/s"
                return
            targets = s
        else:
            movers, targets = s, self._hit_targets(f, s, o)
            if not s and o and f.subject is None:
                # imperative "hit the ball into the goal": a launch
                self._do_launch(f, s, o)
                return
        if movers and all(self.kind(m) == "person" for m in movers) and targets and not f.verb.passive and f.verb.lemma in ("hit", "strike", "tap", "smack", "whack") and self.kind(targets[0]) in ("ball", "billiard", "sliding"):
            self._launch_by(f, movers, targets)
            return
        host = f.phrase("on", "in", "at")
        if len(movers) >= 2 and host is not None and host.mention is not None and targets == host.mention.entities:
            self.place(movers, targets, host.prep)
            targets = []
        if not targets and len(movers) >= 2:
            self._mutual(f, movers, time)
            return
        if not targets and movers:
            aimed = self.aim.get(movers[0])
            if aimed is not None and aimed != movers[0]:
                targets = [aimed]
            else:
                targets = [i for ids in reversed(self.world.salience) for i in ids if i not in movers and not self.structural(i)][:1]
        self._kinematics(f, movers, targets)
        if f.verb.extra.get("motion") == "reverse":
            self._reverse(movers)
        nodes = self._hit(f, movers, targets, time)
        self._after_hit(f, nodes, targets)
        if not o and not f.verb.passive:
            seen = list(targets)
            for p in f.phrases:
                if p.prep in ("into", "against", "with") and p.mention is not None and not p.mention.attribute:
                    extra = [i for i in p.mention.entities if i not in seen and i not in movers and not self.structural(i)]
                    seen += extra
                    self._hit(f, movers, extra)
        tail = f.phrase("off")
        if tail is not None and tail.mention is not None and targets:
            self._outcomes(f, targets[:1])
        elif o and f.phrase("into", "onto", "toward", "towards") is not None and nodes:
            self._knock_on(f, targets[:1])

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

    def _after_hit(self, f: Frame, nodes: list[str], targets: list[str]) -> None:
        """Angles and the like stated with a hit."""
        angle = self.quantity(f, "angle")
        if angle is not None and nodes:
            draft = self.tl.node(nodes[0])
            if draft is not None:
                draft.constraints.append(EventConstraint(quantity="angle", object=draft.participants[0], value=angle[1].value))
                self.use(angle[1], f"angle of {nodes[0]}")

    def _mutual(self, f: Frame, movers: list[str], time: object) -> None:
        """ "Two cars collide": who moves, who is hit."""
        a, b = movers[0], movers[1]
        ta, tb = self.tl.tracks.get(a), self.tl.tracks.get(b)
        if self.e(a).place == "front" or (self.e(b).place == "rear"):
            a, b = b, a
        elif ta is None and tb is not None:
            a, b = b, a
        moving = [m for m in (a, b) if (t := self.tl.tracks.get(m)) is not None and (t.motion is not None or t.hit)]
        if not moving:
            for m in (a, b):
                if self.movable(m):
                    self._start_motion(f, [m], None, b if m == a else a)
        self._hit(f, [a], [b], time)

    def _knock_on(self, f: Frame, bodies: list[str]) -> None:
        """ "hits the ball into the pocket": what happens to the body that was hit."""
        for p in f.phrases:
            if p.mention is not None and p.mention.part in ("edge", "side", "end", "rim") and not p.mention.entities:
                if p.prep in ("over", "off"):
                    for body in bodies:
                        self.event(NodeEvent.FALL, (body,), f, None)
                continue
            if p.mention is None or p.mention.attribute:
                continue
            others = [i for i in p.mention.entities if i not in bodies]
            if p.prep in ("into", "onto", "in", "against", "off", "out of", "over"):
                for body in bodies:
                    if not others:
                        continue
                    if p.prep in ("into", "in"):
                        self._go_into_passive(f, body, others, p)
                    elif p.prep in ("onto", "against") and not self.structural(others[0]):
                        self._hit(f, [body], others, None)
                    elif p.prep in ("off", "out of", "over") and self._elevated(others[0]) and (p.prep != "over" or p.mention.part):
                        self.place([body], [others[0]], "on")
                        self.event(NodeEvent.FALL, (body,), f, None)

    def _go_into_passive(self, f: Frame, body: str, others: list[str], p: Phrase) -> None:
        other = others[0]
        noun = self.e(other).noun
        if self.structural(other):
            return
        if noun.kind in ("region", "goal", "hole", "hoop", "water") or "goal" in noun.traits:
            self.enter(f, body, other, p.mention, self._time(f))
        else:
            self._hit(f, [body], others, self._time(f))

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
        self._knock_on(f, o)
        self._consequence(f, o)

    def _already_hit(self, f: Frame, s: list[str], o: list[str]) -> bool:
        return any(self.tl.tracks.get(b) is not None and self.tl.tracks[b].hit for b in o) and (
            f.causer is not None or f.link in ("cause", "then", "while") and self.last_hit is not None and self.last_hit[1] in o
        )

    def _consequence(self, f: Frame, bodies: list[str]) -> None:
        words = " ".join(f.adverbs)
        if "over" in f.adverbs or "down" in f.adverbs or "upside down" in words:
            for b in self._representatives(bodies, []):
                self.event(NodeEvent.TOPPLE, (b,), f, None)

    def _do_cause(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.use(f, "consequence")
        if f.verb.passive:
            o, s = s, []
        if not o:
            return
        if f.verb.lemma in ("send", "force") and s and not self._already_hit(f, s, o) and f.causer is None:
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

    def _speed_after(self, body: str, a: Amount) -> bool:
        for draft in reversed(self.tl.nodes):
            if draft.event is NodeEvent.COLLISION and body in draft.participants:
                draft.constraints.append(EventConstraint(quantity="speed_after", object=body, value=a.value))
                self.use(a, f"speed after {draft.id}")
                return True
        return False

    # self motion --------------------------------------------------------------------------------

    def _do_own(self, f: Frame, s: list[str], o: list[str]) -> None:
        by = f.phrase("by")
        actors = list(s)
        if f.verb.passive and by is not None:
            actors = list(s)
        elif o and s and self.kind(s[0]) == "person" and f.object is not None and not f.object.attribute:
            if self.kind(o[0]) in SELF_POWERED:
                actors = o[:1]
                self.place(s, o, "near")
        elif not s and o:
            actors = o
        mounted = [self.scene.supported_by.get(a, "") for a in actors]
        if actors and all(m and self.kind(m) in SELF_POWERED for m in mounted) and self.kind(actors[0]) == "person":
            actors = list(dict.fromkeys(mounted))  # "a man on a bicycle rides"
        actors = [a for a in actors if self.movable(a)]
        sides = [x for x in f.adverbs if x in ("left", "right")]
        if sides and actors and self.kind(actors[0]) in SELF_POWERED and f.verb.lemma in ("go", "move", "drive", "head", "run", "walk", "ride"):
            for side in sides:
                self._turn(f, actors, side, 90.0, NodeEvent.HEADING_REACHED)
            return
        mode = None
        if actors and f.verb.lemma in ("go", "come", "move", "travel", "race", "speed", "rush", "hurtle", "run", "proceed"):
            mode = None
        elif actors and self.kind(actors[0]) in SELF_POWERED:
            mode = "own"
        self._motion(f, actors, mode)

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
        self._motion(f, s, None)
        for actor in s:
            if o:
                self.place([actor], o, "behind")
                track = self.tl.tracks.get(o[0])
                if track is None and self.movable(o[0]):
                    self._start_motion(f, o[:1])
                elif track is not None and track.motion is not None and (p := f.phrase("at")) is not None and p.mention is not None and "same" in p.mention.adjectives:
                    self._start_motion(f, o[:1])

    def _do_coast(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)

    def _do_continue(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)

    def _do_cross(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)

    def _do_leave(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._motion(f, s, None)

    def _pushes(self, f: Frame, s: list[str], o: list[str]) -> bool:
        """ "hits a bale, rolling it into a fence": the object is moved by the hit."""
        if s and o and self.kind(s[0]) != "person" and s[0] != o[0]:
            self._do_knock(f, s, o)
            self.use(f, "consequence of the collision")
            return True
        return False

    def _do_roll(self, f: Frame, s: list[str], o: list[str]) -> None:
        if self._pushes(f, s, o):
            return
        actors = o if o and (not s or self.kind(s[0]) == "person") else s
        if f.subject is not None and actors == o:
            self.thrown[id(f.subject)] = list(o)
        if actors and self.kind(actors[0]) in SELF_POWERED and not o:
            self._motion(f, actors, "own")
            return
        self._motion(f, actors, "roll" if actors and "round" in self.e(actors[0]).noun.traits else "slide" if f.verb.sense == "slide" else "roll")

    def _do_slide(self, f: Frame, s: list[str], o: list[str]) -> None:
        if self._pushes(f, s, o):
            return
        actors = o if o and (not s or self.kind(s[0]) == "person") else s
        if actors and self.kind(actors[0]) in SELF_POWERED - {"person", "cart"} and not o:
            self._motion(f, actors, "own")
            return
        self._motion(f, actors, "slide")

    def _do_fly(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and self.kind(s[0]) in ("flyer",):
            self._motion(f, s, "own")
        else:
            self._motion(f, s, "throw")

    def _do_spin(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and not self._moved_by_others(s[0]):
            self._motion(f, s, None)
        self.scene.ignored[(f.verb.start, f.verb.end)] = "spin is not prescribed"

    def _do_accelerate(self, f: Frame, s: list[str], o: list[str]) -> None:
        actors = s or o
        speeds = [(p, a) for p, a in self.amounts(f) if a.dimension == "speed"]
        rate = self.quantity(f, "acceleration")
        for actor in actors:
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
            duration = next((a for p, a in self.amounts(f) if a.dimension == "time" and p == "for"), None)
            if duration is not None:
                self.use(duration, "duration")
            self.tl.move(
                actor,
                Motion("accelerate", start, prescribed, self.aim.get(actor), params, duration.value if duration else None),
                self._direction(actor, "own"),
            )
            if final is not None:
                node = self.tl.trigger(actor, f"{actor} has reached its speed")
                draft = self.tl.node(node)
                assert draft is not None
                draft.constraints.append(EventConstraint(quantity="speed_after", object=actor, value=final.value))
                time = self._time(f)
                if time is not None and (time[1].start, time[1].end) not in self.scene.used:
                    self.use(time[1], "time")
                    draft.time, draft.time_prescribed = time[0], True
                self.tl.move(actor, Motion("own", final.value, True), self._direction(actor, "own"))
                self.tl.track(actor).closed = True
        self.use(f, "acceleration")
        self._outcomes(f, actors)

    def _brake(self, f: Frame, actor: str, time: tuple[Quantity, Amount, str] | None) -> None:
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
        actors = s or [a for a, t in self.tl.tracks.items() if t.motion is not None][-1:]
        for actor in actors:
            self._brake(f, actor, self._time(f))
        found = self.quantity(f, "speed")
        if found is not None and f.phrase("from") is None:
            self.use(found[1], "speed")
        self.use(f, "braking")

    def _do_slow(self, f: Frame, s: list[str], o: list[str]) -> None:
        actors = s or o
        final = next((a for p, a in self.amounts(f) if a.dimension == "speed" and p in ("to", "")), None)
        for actor in actors:
            if self._moved_by_others(actor) or (self.tl.tracks.get(actor) and self.tl.tracks[actor].launched):
                self.scene.ignored[(f.verb.start, f.verb.end)] = "friction slows it"
                continue
            self._brake(f, actor, self._time(f) if final is None else None)
            if final is not None:
                node = self.tl.trigger(actor, self.describe(f))
                draft = self.tl.node(node)
                assert draft is not None
                draft.constraints.append(EventConstraint(quantity="speed_after", object=actor, value=final.value))
                self.use(final, "speed after slowing")
                time = self._time(f)
                if time is not None:
                    brake = self.tl.nodes[-2].id
                    draft.constraints.append(EventConstraint(quantity="time_since", object=actor, value=time[0], since=brake))
                    self.use(time[1], "time")
                self.tl.move(actor, Motion("own", final.value, True), self._direction(actor, "own"))
                self.tl.track(actor).closed = True
        self.use(f, "slowing")

    def _do_stop(self, f: Frame, s: list[str], o: list[str]) -> None:
        actors = s or o
        if f.reduced or (f.verb.passive and not any(a in self.tl.tracks for a in actors)):
            moving = [a for a in actors if a in self.tl.tracks and self.tl.tracks[a].motion is not None]
            if not moving:
                self._do_be(f, s, o)
                return
        if f.verb.passive:
            by = f.phrase("by")
            if by is not None and by.mention is not None and by.mention.entities:
                self._hit(f, actors, by.mention.entities, self._time(f))
        for actor in actors:
            if not self.movable(actor):
                continue
            time = self._time(f)
            self._stop(f, actor, time)
        self._places_loosely(f, actors)

    def _places_loosely(self, f: Frame, actors: list[str]) -> None:
        self.use(f, "stop")

    def _stop(self, f: Frame, actor: str, time: tuple[Quantity, Amount, str] | None) -> None:
        track = self.tl.track(actor)
        if track.motion is None and not track.hit:
            self._start_motion(f, [actor])
            track = self.tl.track(actor)
        motion = track.motion
        if motion is not None and motion.mode in ("own", "accelerate") and track.role is Role.ACTIVE:
            self._brake(f, actor, None)
        self.event(NodeEvent.STOP, (actor,), f, time)

    def _do_turn(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and not any(self.movable(a) for a in s):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "a fixed object does not turn"
            return
        words = [*f.adverbs, f.verb.extra.get("dir", "")]
        for p in f.phrases:
            if p.mention is not None and p.mention.attribute or (p.mention and p.mention.part):
                words += [p.mention.head, p.mention.part]
        span = self.text[f.verb.start : f.verb.end + 40].lower()
        direction = "left" if "left" in words or "anticlockwise" in words or "counterclockwise" in words else "right" if "right" in words or "clockwise" in words else ""
        if not direction:
            direction = "right" if " right" in span.split(".")[0] else "left"
        degrees = 180.0 if f.verb.extra.get("dir") in ("u", "around", "back") else 90.0
        amount = self.quantity(f, "angle")
        if amount is not None:
            degrees = max(1.0, min(720.0, abs(amount[1].middle)))
            self.use(amount[1], "turn angle")
        actors = s or o
        if not actors:
            actors = [a for a, t in self.tl.tracks.items() if t.motion is not None][-1:]
        self._turn(f, actors, direction, degrees, NodeEvent.HEADING_REACHED)
        cross = f.phrase("at", "into", "onto", "down")
        if cross is not None:
            self.use(f, "turn")

    def _turn(self, f: Frame, actors: list[str], direction: str, degrees: float, kind: NodeEvent) -> None:
        for actor in actors:
            if not self.movable(actor):
                continue
            track = self.tl.track(actor)
            if track.motion is None:
                self._start_motion(f, [actor], "own")
            time = self._time(f)
            speed, prescribed = (track.motion.speed, track.motion.prescribed) if track.motion else (None, False)
            self.event(NodeEvent.TRIGGER, (actor,), f, time, stem="turn_start")
            track.closed = True
            self.tl.move(
                actor,
                Motion("turn", speed, prescribed, None, {
                    "turn_direction": direction, "turn_degrees": degrees, "turn_rate_deg_s": (20.0, 120.0),
                }),
                self._direction(actor, "own"),
            )  # fmt: skip
            self.event(kind, (actor,), f, None, turn_direction=direction, turn_degrees=degrees)

    def _do_swerve(self, f: Frame, s: list[str], o: list[str]) -> None:
        direction = "right" if "right" in f.adverbs or any(p.mention and p.mention.head == "right" for p in f.phrases) else "left"
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

    def _do_avoid(self, f: Frame, s: list[str], o: list[str]) -> None:
        for actor in s:
            for other in o[:1]:
                self._ensure_mover(f, actor, None)
                self.event(NodeEvent.MISS, (actor, other), f, self._time(f))

    def _do_miss(self, f: Frame, s: list[str], o: list[str]) -> None:
        targets = self._hit_targets(f, s, o)
        for actor in s:
            if not targets and actor in self.aim:
                targets = [self.aim[actor]]
            self._ensure_mover(f, actor, targets[0] if targets else None)
            for other in targets[:1]:
                if other != actor:
                    self.event(NodeEvent.MISS, (actor, other), f, self._time(f))

    def _do_overtake(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            s, o = (list(by.mention.entities) if by and by.mention else []), s
        for actor in s:
            track = self.tl.tracks.get(actor)
            if track is None or track.motion is None:
                self._start_motion(f, [actor])
            for other in o[:1]:
                if other != actor:
                    self.place([actor], [other], "behind")
                    self.event(NodeEvent.MISS, (actor, other), f, self._time(f), stem="overtakes")
        self.use(f, "overtaking")

    def _do_merge(self, f: Frame, s: list[str], o: list[str]) -> None:
        direction = "right" if "right" in f.adverbs or "right" in self.text[f.verb.start : f.verb.end + 30] else "left"
        self._turn(f, s, direction, 15.0, NodeEvent.HEADING_REACHED)

    def _do_reverse(self, f: Frame, s: list[str], o: list[str]) -> None:
        actors = s or o
        self._motion(f, actors, "own")
        self._reverse(actors)

    def _reverse(self, actors: list[str]) -> None:
        for actor in actors:
            if not self.movable(actor):
                continue
            track = self.tl.track(actor)
            if track.motion is None:
                self._own(actor, SPEEDS.get(self.kind(actor), (50.0, 400.0)), False, self.aim.get(actor))
            track.direction = ForceDirection.ALONG_FORWARD_OR_BACKWARD

    # launches -----------------------------------------------------------------------------------

    def _do_launch(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.verb.passive:
            by = f.phrase("by")
            agents = by.mention.entities if by is not None and by.mention is not None else []
            things = s
        else:
            agents, things = (s, o) if o else ([], s)
        if not things:
            p = f.phrase("against", "on", "at")
            if p is not None and p.mention is not None and agents:
                self._do_hit(f, agents, p.mention.entities)
            return
        self._launch_by(f, agents, things)

    def _do_tow(self, f: Frame, s: list[str], o: list[str]) -> None:
        """Pulling: a person moves the thing; a vehicle drives with the thing behind it."""
        if f.verb.passive:
            by = f.phrase("by")
            s, o = (list(by.mention.entities) if by and by.mention else []), s
        if s and o and self.kind(s[0]) != "person":
            self.place(o, s, "behind")
            self._motion(f, s, None)
        else:
            self._launch_by(f, s, o)

    _do_pass = _do_launch
    _do_lift = _do_launch

    def _launch_by(self, f: Frame, agents: list[str], things: list[str]) -> None:
        mode = f.verb.note or "roll"
        bodily = [a for a in agents if self.kind(a) != "person"]
        if bodily and f.verb.sense in ("launch",) and mode in ("slide", "roll"):
            # a robot, car or ball that pushes something hits it
            self._kinematics(f, bodily, things)
            if not self._already_hit(f, bodily, things):
                self._hit(f, bodily[:1], things, self._time(f))
            self._knock_on(f, things)
            self._consequence(f, things)
            return
        if agents:
            self.place(agents, things, "near")
        for agent in agents:
            if agent != things[0]:
                self.scene.facing.setdefault(agent, things[0])
        self._motion_of_things(f, things, mode)

    def _motion_of_things(self, f: Frame, things: list[str], mode: str) -> None:
        target = self._target(f, things)
        aim = next((t for t in target if self._aimable(t)), None)
        if mode == "roll" and f.verb.lemma not in ("roll", "bowl", "putt", "dribble"):
            aimed = self.e(aim) if aim else None
            if aimed is not None and (aimed.noun.kind in ("hoop", "wall", "goal") and f.verb.lemma in ("shoot",)):
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
            if angle is not None and track is not None and track.motion is not None and mode in ("throw", "fly"):
                track.motion.params["elevation_deg"] = angle[1].value
                self.use(angle[1], "launch angle")
        self.use(f, "launch")
        self._heights(f, moved)
        self._distance(f, moved, aim)
        for m in ([f.subject] if f.subject is not None else []):
            self.thrown[id(m)] = moved
        self._outcomes(f, moved)
        self._consequence(f, moved)
        if aim is not None:
            for t in moved:
                self.world.note([aim])
                self.world.note([t], subject=f.verb.passive)

    def _heights(self, f: Frame, things: list[str]) -> None:
        for p, a in self.amounts(f):
            if a.dimension == "length" and (p in ("from", "at", "of", "above", "") and ("height" in self.text[max(0, a.start - 25) : a.end + 12] or p in ("from", "above") or self.text[a.end : a.end + 7].strip().startswith(("above", "high", "up")))):
                for t in things:
                    self.scene.heights[t] = a.value
                    self.tl.start_constraints.append(EventConstraint(quantity="height", object=t, value=a.value))
                self.use(a, "start height")

    def _do_drop(self, f: Frame, s: list[str], o: list[str]) -> None:
        things = s if f.verb.passive or not o else o
        agents = [x for x in s if x not in things]
        if agents:
            self.place(agents, things, "near")
        self._drop(f, things)

    def _drop(self, f: Frame, things: list[str]) -> None:
        moved = [t for t in things if self.movable(t)]
        source = f.phrase("off", "from")
        if source is not None and source.mention is not None:
            host = [i for i in source.mention.entities if self._elevated(i)]
            if host:
                for t in moved:
                    self.place([t], host, "on")
                    self._ensure_mover(f, t, None)
                    self.event(NodeEvent.FALL, (t,), f, self._time(f))
                self._landing(f, moved)
                return
        for t in moved:
            if not self._moved_by_others(t):
                track = self.tl.tracks.get(t)
                if track is None or track.motion is None:
                    self._start_motion(f, [t], "drop")
        self._heights(f, moved)
        self.use(f, "drop")
        if not self._landing(f, moved):
            for t in moved:
                self.pending[t] = (NodeEvent.FALL, f, None, self._time(f))

    def _landing(self, f: Frame, moved: list[str]) -> bool:
        p = f.phrase("onto", "on", "into", "in", "through", "to", "upon")
        if p is None or p.mention is None or not p.mention.entities:
            return False
        other = p.mention.entities[0]
        for t in moved:
            if t == other:
                continue
            if self.structural(other):
                if not any(n.event is NodeEvent.FALL and t in n.participants for n in self.tl.nodes):
                    self.event(NodeEvent.FALL, (t,), f, self._time(f))
            elif p.prep in ("into", "in", "through") and self._holds(other) or self.kind(other) in ("region", "water"):
                self.enter(f, t, other, p.mention, self._time(f))
            else:
                self._hit(f, [t], p.mention.entities, self._time(f))
        return True

    def _do_fall(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._free([x for x in s if self.kind(x) in ("post", "plant", "wall", "street")])
        actors = self._representatives(s, [])
        fresh = [a for a in actors if a not in self.tl.tracks]
        upright = [a for a in actors if "topples" in self.e(a).noun.traits or self.kind(a) in ("domino", "plant", "post")]
        if upright and f.phrase("off", "from", "over", "down", "onto", "on", "into", "in") is None and a_rests_low(self, upright[0]):
            self._do_topple(f, s, [])
            return
        source = f.phrase("off", "from", "over", "down")
        if source is not None and source.mention is not None and not source.mention.entities:
            source = None
        for actor in fresh:
            self._struck_before(f, actor)
        fresh = [a for a in fresh if a not in self.tl.tracks]
        into = f.phrase("into", "in", "through")
        if source is None and not fresh and into is not None and into.mention is not None and into.mention.entities:
            if self._landing(f, actors):
                return
        on_something = [a for a in fresh if a in self.scene.supported_by]
        if fresh and source is None and f.phrase("onto", "on", "into", "in") is None and not on_something:
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
                self._start_motion(f, [actor], "roll" if "round" in self.e(actor).noun.traits else "slide")
        if fresh and source is None:
            self._drop(f, fresh)
            return
        for actor in actors:
            if not self.movable(actor):
                continue
            if source is not None and source.mention is not None and source.mention.entities:
                host = source.mention.entities[0]
                if host != actor and self._elevated(host):
                    self.place([actor], [host], "on")
            self._heights(f, [actor])
            if actor in fresh:
                high = source is not None and source.mention is not None and source.mention.entities and not self._elevated(source.mention.entities[0])
                if high or actor in self.scene.heights and actor not in self.scene.supported_by:
                    self._start_motion(f, [actor], "drop")
                else:
                    self._start_motion(f, [actor], "roll" if "round" in self.e(actor).noun.traits else "slide")
            self.event(NodeEvent.FALL, (actor,), f, self._time(f))
        landing = f.phrase("onto", "into", "on", "in")
        if landing is not None and landing.mention is not None and landing.mention.entities and not self.structural(landing.mention.entities[0]):
            self._landing(f, actors)

    def _struck_before(self, f: Frame, body: str) -> None:
        """ "thrown at a bottle, which falls": the fall implies the hit."""
        if body in self.tl.tracks:
            return
        for mover, aimed in self.aim.items():
            track = self.tl.tracks.get(mover)
            if aimed == body and track is not None and not track.closed:
                self._hit(f, [mover], [body])
                return

    def _free(self, nodes: list[str]) -> None:
        for node in nodes:
            if not self.structural(node):
                self.e(node).freed = True

    def _do_topple(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._free(o or s)
        if f.subject is not None and f.subject.determiner in ("each", "every") and f.object is not None and "next" in f.object.adjectives and len(s) > 1:
            s, o = s[:1], s[1:2]
        if f.verb.passive:
            by = f.phrase("by")
            o, s = s, list(by.mention.entities) if by is not None and by.mention is not None else []
        if o:
            bodies = self._representatives(o, s)
            movers = [m for m in s if self.kind(m) != "person"] or s
            if movers and not self._already_hit(f, movers, o):
                self._hit(f, movers[:1], o, self._time(f))
        else:
            bodies = self._representatives(s, []) if not f.verb.passive else []
        for b in bodies:
            if not self.movable(b):
                continue
            self._struck_before(f, b)
            if b not in self.tl.tracks or (self.tl.tracks[b].motion is None and not self.tl.tracks[b].hit):
                self._start_motion(f, [b], "slide")
            self.event(NodeEvent.TOPPLE, (b,), f, self._time(f))
        self._knock_on(f, bodies)

    def _do_enter(self, f: Frame, s: list[str], o: list[str]) -> None:
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
                self.event(NodeEvent.ENTER_REGION, (b,), f, self._time(f), region="billiard_table_1/bottom left pocket")

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

    def _do_land(self, f: Frame, s: list[str], o: list[str]) -> None:
        for actor in s:
            if actor not in self.tl.tracks:
                self._start_motion(f, [actor], "drop")
        if not self._landing(f, s):
            self.use(f, "landing")
        self.use(f, "landing")

    def _do_bounce(self, f: Frame, s: list[str], o: list[str]) -> None:
        slope = f.phrase("down")
        if slope is not None and slope.mention is not None and any("incline" in self.e(i).noun.traits for i in slope.mention.entities):
            self._do_roll(f, s, o)
            return
        p = f.phrase("off", "against", "on", "from", "into", "onto")
        self._kinematics(f, s, [])
        for actor in s:
            if p is not None and p.mention is not None and p.mention.entities:
                other = p.mention.entities[0]
                if self.structural(other):
                    self._ensure_drop(f, actor)
                    self.use(f, "bounce on the ground")
                elif self.last_hit == (actor, other) and p.prep in ("off", "from"):
                    self.use(f, "rebound of the collision")
                else:
                    self._hit(f, [actor], [other], self._time(f))
            else:
                aimed = self.aim.get(actor)
                track = self.tl.tracks.get(actor)
                if aimed is not None and track is not None and not track.closed:
                    self._hit(f, [actor], [aimed], self._time(f))
                elif track is None:
                    self._ensure_drop(f, actor)
                self.use(f, "rebound")
        into = f.phrase("into")
        if into is not None and p is not into:
            for actor in s:
                self._go_into(f, actor, into.mention.entities if into.mention else [], into, None)

    def _ensure_drop(self, f: Frame, actor: str) -> None:
        if actor not in self.tl.tracks:
            self._start_motion(f, [actor], "drop")

    def _do_reach(self, f: Frame, s: list[str], o: list[str]) -> None:
        if f.object is not None and f.object.attribute and self.quantity(f, "speed") is not None:
            self._do_acquire(f, s, o)
            return
        targets = o or self._hit_targets(f, s, [])
        for actor in s:
            target = next((t for t in targets if t != actor and not self.structural(t)), None)
            if target is None:
                self._motion(f, [actor], None)
                continue
            self._ensure_mover(f, actor, target)
            p = f.phrase("in", "into")
            if p is not None and (self._holds(target) or self.kind(target) == "region"):
                self.enter(f, actor, target, p.mention, self._time(f))
            else:
                self.event(NodeEvent.REACH, (actor, target), f, self._time(f))

    def _do_scatter(self, f: Frame, s: list[str], o: list[str]) -> None:
        bodies = o or s
        if o and s and not self._already_hit(f, s, o):
            self._hit(f, s[:1], o, self._time(f))
        if bodies and self.kind(bodies[0]) in ("pin", "domino"):
            self.event(NodeEvent.TOPPLE, (self._representatives(bodies, [])[0],), f, None)
        self.use(f, "scatter")

    def _do_swing(self, f: Frame, s: list[str], o: list[str]) -> None:
        target = self._hit_targets(f, s, o)
        if f.phrase("at", "into", "against") is not None and target and s:
            self._hit(f, s[:1], target, self._time(f))
        else:
            self._motion(f, s, None)

    def _do_carry(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and o:
            self.place(o, s, "on")
        if s and any(p.prep in ("to", "toward", "towards") for p in f.phrases):
            self._motion(f, s, None)
        self.use(f, "carrying")

    def _do_apply(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"

    _do_start = _do_apply


def a_rests_low(interpreter: Interpreter, node: str) -> bool:
    """Whether an upright thing stands on the ground, so that "falls" means that it topples."""
    return node not in interpreter.scene.supported_by and node not in interpreter.scene.heights


def pocket_name(adjectives: list[str]) -> str:
    """Name of the billiard pocket that a phrase means ("bottom pocket", "corner pocket")."""
    words = {w for a in adjectives for w in a.split("-")}
    row = "top" if words & {"top", "upper", "far"} else "middle" if words & {"middle", "side", "center"} else "bottom"
    side = "right" if "right" in words else "left"
    return f"{row} {side} pocket"
