"""From clause frames to objects, relations, motions and events."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft import lexicon as lex
from esg.draft.dodging import dodge
from esg.draft.elements import Mention
from esg.draft.entities import ORDINALS
from esg.draft.frames import Frame, Phrase
from esg.draft.in_turn import InTurn
from esg.draft.references import RIDDEN, STATES
from esg.draft.scene import SELF_POWERED, Scene
from esg.draft.underway import by_the_clock
from esg.draft.windows import Draft
from esg.graph.models import EventConstraint, NodeEvent, Role

_THINGS_DO = frozenset({"hit", "enter", "land", "bounce", "miss", "scatter", "fall"})
_THINGS_DO_TO = frozenset({"knock", "topple", "scatter"})
"""Senses that, after "the boy throws a ball and ...", are about the ball."""
_BREAKING = frozenset({"break", "shatter", "burst", "splinter", "crack"})
_ACTED_ON = frozenset(
    {"slow", "stop", "brake", "accelerate", "turn", "reverse", "launch", "tow", "topple",
     "knock", "drop", "cause", "pocket", "scatter", "spin", "roll", "slide"}
)  # fmt: skip
"""Senses whose object moves, so that it cannot be the ground."""
_INSTEAD = re.compile(r"\binstead\b(?! of)", re.IGNORECASE)
_BUT = re.compile(r"\b(?:but|yet)\b[^.;,]*$", re.IGNORECASE)
_AT_FIRST = re.compile(
    r"\b(?:first|initially|until|till|before|for|after|yet|while|when|at the start|beginning)\b",
    re.IGNORECASE,
)
_NOTHING = re.compile(r"\bnothing\s*$", re.IGNORECASE)
_HITS = (NodeEvent.COLLISION,)
_NAMED_EVENTS = {
    **dict.fromkeys(("collision", "impact", "crash", "hit", "strike", "contact", "smash"), _HITS),
    **dict.fromkeys(("bump", "blow", "knock", "accident", "touch"), _HITS),
    "fall": (NodeEvent.FALL, NodeEvent.TOPPLE),
    "stop": (NodeEvent.STOP,),
    "turn": (NodeEvent.HEADING_REACHED,),
}
"""Nouns for events, and the point events they name."""
_UNDER_WAY = re.compile(r"(?:halfway|midway|on the way|on (?:its|his|her|their) way)\b", re.I)
_ANIMAL_VERBS = frozenset(
    {"run", "walk", "jog", "gallop", "trot", "jump", "leap", "hop", "crawl", "sprint", "dash",
     "charge", "sleep", "sit", "chase", "wander", "swim", "climb", "stroll", "march", "pursue"}
)  # fmt: skip

_PERSON_VERBS = frozenset(
    {"kick", "throw", "toss", "hurl", "fling", "lob", "dribble", "juggle", "flick", "serve", "putt"}
)
"""What only somebody does to a thing."""
_VEHICLE_VERBS = frozenset(
    {"drive", "brake", "accelerate", "overtake", "park", "steer", "cruise", "merge", "reverse",
     "swerve", "speed"}
)  # fmt: skip


class Interpreter(InTurn):
    """Walks over frames in order of time and fills a Scene."""

    def run(self, frames: list[Frame], attachments: list[tuple[Mention, Phrase]]) -> Scene:
        # references are resolved in the order of the text, events in the order of time
        self.told, self.attached = frames, attachments
        self._refer_all(frames)
        self.told = frames = by_the_clock(frames)
        dodge(frames, self.text)
        self.upon(attachments)
        for m, p in attachments:
            self.attachment(m, p)
        before = -1
        for f in frames:
            self.telling = (f.sentence, before, f.verb.sense)
            for g in self._one_time_each(f):
                self.frame(g)
            before = f.verb.start
        self._settle(None, None)
        for actor in self.still:
            track = self.tl.tracks.get(actor)
            if track is not None and track.role is Role.ACTIVE and actor in self.world.entities:
                label = self.e(actor).label
                self.world.conflicts.append(f'"{label}" is said to move and not to move')
        for actor, amount in list(self.scene.travel.items()):
            track = self.tl.tracks.get(actor)
            if track is not None and track.motion is not None and not track.closed:
                node = self.tl.trigger(actor, f"{actor} has travelled {amount.text}")
                draft = self.tl.node(node)
                assert draft is not None
                draft.constraints.append(
                    EventConstraint(quantity="distance", object=actor, value=amount.value)
                )
            else:
                self.scene.used.pop((amount.start, amount.end), None)
        return self.scene

    def frame(self, f: Frame) -> None:
        sense = f.verb.sense
        subject = list(f.subject.entities) if f.subject is not None else []
        objects = list(f.object.entities) if f.object is not None else []
        if f.object2 is not None:
            objects += [i for i in f.object2.entities if i not in objects]
        objects = [i for i in objects if self.kind(i) != "region"]
        self.each = self._one_by_one(f)
        paired = subject and set(subject) <= set(self.pairs) and len(objects) > 1
        if paired and set(objects) == set(self.pairs.values()):
            mine, self.pairs = self.pairs, {}
            for actor in subject:
                one = replace(f.subject, entities=[actor]) if f.subject else None
                other = replace(f.object, entities=[mine[actor]]) if f.object else None
                self.frame(replace(f, subject=one, object=other))
            self.use(f, "one for each")
            return
        if len(subject) == 1 and sense in RIDDEN and not f.verb.passive and not objects[1:]:
            mount = self.scene.supported_by.get(subject[0], "")
            riding = mount and self.kind(mount) in SELF_POWERED | {"sliding"}
            if riding and self.kind(subject[0]) == "person" and mount not in objects:
                subject = [mount]  # "a girl on a skateboard ... she hits a hydrant"
        if sense not in STATES:
            still = ("water", "hole")
            moving = [i for i in subject if self._aimable(i) and self.kind(i) not in still]
            if subject and not moving and not f.verb.passive:
                self.scene.ignored[(f.verb.start, f.verb.end)] = "the ground does not act"
                return
            subject = moving
        if sense in _ACTED_ON:
            objects = [i for i in objects if self._aimable(i)]
        if sense in ("roll", "slide") and not f.verb.passive:
            objects = [i for i in objects if "decal" not in self.e(i).noun.traits]
        self._settle_aims(f)
        self.instead = _INSTEAD.search(self._sentence(f)) is not None or (
            _BUT.search(self.text, max(0, f.verb.start - 30), f.verb.start) is not None
        )
        subject = self._struck_one(f, subject)
        speed = self.quantity(f, "speed")
        speeds = [a for _, a in self.amounts(f) if a.dimension == "speed"]
        if len(speeds) == len(subject) > 1 and sense in ("hit", "miss"):
            self.own_speed.update(zip(subject, speeds, strict=True))  # "one at 1 m/s, the other"
        if f.verb.lemma in ("happen", "occur"):
            self._happens(f)
        if sense == "noop" and subject and speed is not None:
            self.stated[subject[0]] = speed[1]  # "a lorry doing 60 mph"
        masses = [a for _, a in self.amounts(f) if a.dimension == "mass"]
        if len(masses) == len(subject) > 1:
            for o, a in zip(subject, masses, strict=True):
                self.world.apply_amount(self.e(o), a)  # "one of 7.5 t and one of 12 t"
                self.use(a, o)
            masses = []
        for a in masses:
            if self._mass_of_load(a):
                continue
            if subject:
                owner = objects[0] if objects and sense not in ("weigh", "be") else subject[0]
                owners = subject if sense in ("weigh", "be", "have") else [owner]
                for o in owners:
                    self.world.apply_amount(self.e(o), a)
                self.use(a, owners[0])
        if f.unreal:
            self._unreal(f, subject, objects)
            return
        if f.object is None and "neither" in f.adverbs and sense == "hit":
            self._neither(f, subject)
            return
        if f.verb.negated and sense in ("hit", "enter"):
            f.verb.sense = sense = "miss"
        elif f.verb.negated and sense not in ("be", "posture", "miss"):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "negated"
            at_first = _AT_FIRST.search(self._sentence(f)) is not None
            if f.verb.lemma in ("move", "budge", "stir") and not at_first:
                self.still.update((i, f.verb.start) for i in subject)
            return
        things_do = sense in _THINGS_DO or (sense in _THINGS_DO_TO and objects)
        if f.subject is not None and things_do and f.subject.start < f.verb.start:
            flying = self.thrown.get(id(f.subject))
            if (
                flying
                and not set(flying) & set(objects)
                and all(self.kind(i) == "person" for i in subject)
            ):
                subject = list(flying)
        subject, objects = self._what_the_thrower_misses(f, subject, objects)
        for node in subject if not f.verb.passive else []:
            self._guess_kind(node, f.verb.lemma)
        if (
            f.subject is not None
            and id(f.subject) in self.mounts
            and sense not in ("be", "posture", "weigh", "fall", "topple")
        ):
            subject = list(self.mounts[id(f.subject)])
        over = sense == "topple" and f.verb.lemma == "roll" and not f.verb.passive
        if over and subject and "round" in self.e(subject[0]).noun.traits:
            f.verb.sense = sense = "roll"  # "a ball rolls over and hits it": comes over
        against = f.phrase("on", "against", "at")
        if f.verb.lemma in ("end", "wind", "finish") and sense in ("noop", "reach"):
            sense = "end"
        if sense == "noop" and f.verb.lemma in _BREAKING and against is not None and subject:
            sense = "hit"  # "breaks on a rock"
        handler = getattr(self, f"_do_{sense}", None)
        if handler is None:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"
            self._hand_on(f)
            return
        self._high_up(f, subject)
        handler(f, subject, objects)
        self._speed_of_noun(f, subject)
        self._far_away(f, subject)
        self._hand_on(f)
        for p, a in self.amounts(f):
            span = self._precedes(a) or (p == "for" and sense in ("fall", "drop"))
            if a.dimension == "time" and span and (a.start, a.end) not in self.scene.used:
                self.gap, self.gap_of = a, f  # "falls for 0.6 s before it hits a bucket"

    def _what_the_thrower_misses(
        self, f: Frame, subject: list[str], objects: list[str]
    ) -> tuple[list[str], list[str]]:
        """ "She throws a ball at a can. She misses it and hits a box": the ball does both."""
        shot = self.launched_by.get(subject[0], []) if len(subject) == 1 else []
        tracks = {t: self.tl.tracks.get(t) for t in shot}
        flying = [t for t, k in tracks.items() if k is not None and k.motion and not k.closed]
        missed = f.verb.sense == "miss"
        if f.verb.passive or f.verb.sense not in ("miss", "hit") or not flying:
            return subject, objects
        aims = [t for t in [self.aim.get(flying[0])] if t] or self._target_of_mates(flying[0])
        target = next(iter(aims), "")
        itself = set(objects) <= set(flying)  # "kicks another ball and hits it"
        mates = self.world.groups.get(self.e(target).group or "", []) if target else []
        told = itself and (missed or target)
        if not told and objects[:1] != [target] and not set(objects) & set(mates):
            return subject, objects
        if f.subject is not None:
            self.thrown[id(f.subject)] = flying
        return flying, (aims[:1] if not missed else []) if itself else objects

    def _unreal(self, f: Frame, subject: list[str], objects: list[str]) -> None:
        """What does not happen: at most the direction of a motion that is under way."""
        self.scene.ignored[(f.verb.start, f.verb.end)] = f.unreal
        for p in f.phrases:
            if p.amount is not None:
                self.scene.used.setdefault((p.amount.start, p.amount.end), f.unreal)
        target = objects[:1] or self._target(f, subject)
        for actor in subject[:1]:
            track = self.tl.tracks.get(actor)
            if target and track is not None and track.motion is not None and not track.closed:
                self.aim[actor] = target[0]

    def _neither(self, f: Frame, subject: list[str]) -> None:
        """ "It hits neither": it misses the two named last."""
        named = [i for ids in reversed(self.world.salience) for i in reversed(ids)]
        fit = [i for i in named if i in self.world.entities and i not in subject]
        two = list(dict.fromkeys(i for i in fit if self._aimable(i)))[:2]
        for actor in subject[:1]:
            for other in reversed(two):
                pair = (NodeEvent.MISS, (actor, other))
                if any((n.event, n.participants) == pair for n in self.tl.nodes):
                    continue  # "drives past a cat and a dog. It hits neither"
                self._do_miss(replace(f, object=None), [actor], [other])
        self.use(f, "misses")

    @staticmethod
    def _one_by_one(f: Frame) -> set[str]:
        """Few things that "both" or "each" distributes over; "all" of a row stays one chain."""
        out: set[str] = set()
        for m in (f.subject, f.object, *[p.mention for p in f.phrases]):
            if m is None or not (2 <= len(m.entities) <= 3):
                continue
            told = m is f.object and m.count == len(m.entities) and not m.vague and not m.single
            felled = told and f.verb.sense in ("knock", "topple")  # "mows down two cones"
            if {"both", "each"} & {m.determiner, m.pronoun} or felled:
                out |= set(m.entities)
        return out

    def _settle_aims(self, f: Frame) -> None:
        """What was thrown at something hits it before the prompt turns to other things."""
        mentions = [f.subject, f.object, f.object2, *[p.mention for p in f.phrases]]
        about = {i for m in mentions if m is not None for i in m.entities}
        about |= {t for m in mentions if m is not None for t in self.thrown.get(id(m), [])}
        if f.verb.sense in ("miss", "hit"):
            about |= {t for i in list(about) for t in self.launched_by.get(i, [])}
        for i in list(about):  # "the first misses": of those thrown at it the turn is the next's
            about |= set(self.world.groups.get(self.e(i).group or "", []))
        for actor, (kind, g, target, _) in list(self.pending.items()):
            if kind is NodeEvent.REACH and g.sentence < f.sentence and self._on_the_way(f):
                del self.pending[actor]
                continue
            aimed = kind in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION)
            if aimed and g.sentence < f.sentence and about and not about & {actor, target}:
                self._settle(actor, None)

    def _on_the_way(self, f: Frame) -> bool:
        """ "walks to the table. Halfway he stumbles": the arrival is not told."""
        return f.start_of_sentence and _UNDER_WAY.match(self._sentence(f).strip()) is not None

    def _happens(self, f: Frame) -> None:
        """ "The crash happens after 3 seconds", "the second collision 2 s after the first"."""
        if _NOTHING.search(self.text, max(0, f.verb.start - 12), f.verb.start):
            self.scene.ignored[(f.verb.start, f.verb.end)] = "nothing happens"
            lull = next((a for _, a in self.amounts(f) if a.dimension == "time"), None)
            self.gap = lull if lull is None or lull.bound is None else replace(lull, low=lull.high)
            return
        last = self._told_event(f.subject) or self.tl.node(self.tl.last_event or "")
        if last is None or last.time is not None or last.constraints:
            return
        p = f.phrase("after")
        since = self._told_event(p.mention) if p is not None else None
        span = next((a for _, a in self.amounts(f) if a.dimension == "time"), None)
        if since is not None and since is not last and span is not None:
            last.constraints.append(
                EventConstraint(
                    quantity="time_since",
                    object=last.participants[0],
                    value=span.value,
                    since=since.id,
                )
            )
            last.after.append(since.id)
            self.use(span, f"time of {last.id}")
            self.use(f, f"time of {last.id}")
            return
        time = self._time(f)
        if time is not None and (last is self.tl.nodes[0] or time[2] == "at"):
            last.time, last.time_prescribed = time[0], True
            self.use(time[1], f"time of {last.id}")
            self.use(f, f"time of {last.id}")

    def _told_event(self, m: Mention | None) -> Draft | None:
        """The event that a noun names: "the second collision", "the fall"."""
        kinds = _NAMED_EVENTS.get(m.head) if m is not None and m.attribute else None
        if m is None or kinds is None:
            return None
        told = [n for n in self.tl.nodes if n.event in kinds]
        place = next((ORDINALS[a] for a in m.adjectives if a in ORDINALS), -1)
        return told[place] if -len(told) <= place < len(told) else None

    def _struck_one(self, f: Frame, subject: list[str]) -> list[str]:
        """ "two balls collide and one of them rolls away": the one that was hit."""
        m = f.subject
        if m is None or self.last_hit is None or len(subject) != 1 or m.adjectives:
            return subject
        unnamed = (m.pronoun == "one" and not m.determiner) or (
            m.pronoun in ("them", "these", "those") and m.count == 1
        )
        mates = self.world.groups.get(self.e(subject[0]).group or "", [])
        if unnamed and set(self.last_hit) <= set(mates) and self._moved_by_others(self.last_hit[1]):
            m.entities = [self.last_hit[1]]
            return list(m.entities)
        return subject

    def _guess_kind(self, node: str, lemma: str) -> None:
        """An unknown noun is what its verb says: what gallops is an animal."""
        entity = self.e(node)
        if entity.known or entity.noun.kind != "generic":
            return
        model = "dog" if lemma in _ANIMAL_VERBS else "car" if lemma in _VEHICLE_VERBS else None
        model = "person" if lemma in _PERSON_VERBS else model
        if model is not None:
            like = lex.nouns()[model]
            entity.noun = replace(
                like, name=entity.head, description=f"{entity.head}, like a {model}", synonyms=()
            )
