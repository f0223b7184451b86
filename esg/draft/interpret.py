"""From clause frames to objects, relations, motions and events."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft import lexicon as lex
from esg.draft.frames import Frame, Phrase
from esg.draft.scene import SELF_POWERED, Relation, Scene
from esg.draft.senses_motion import MotionSenses
from esg.draft.syntax import Mention
from esg.graph.models import EventConstraint, NodeEvent, Role

_THINGS_DO = frozenset({"hit", "enter", "land", "bounce", "miss", "scatter", "fall"})
_THINGS_DO_TO = frozenset({"knock", "topple", "scatter"})
"""Senses that, after "the boy throws a ball and ...", are about the ball."""
_FLYING_ON = frozenset({"bounce", "roll", "slide", "fly", "enter", "spin"})
"""Senses of "it" after a throw that are about the thing thrown."""
_BREAKING = frozenset({"break", "shatter", "burst", "splinter", "crack"})
_HALTING = frozenset({"stop", "catch", "grab", "avoid", "dodge", "intercept", "block", "follow"})
_MOVING = frozenset({"own", "roll", "slide", "fly", "fall", "drop", "launch", "coast", "leave"})
_RIDDEN = frozenset(
    {"hit", "miss", "brake", "slow", "stop", "turn", "swerve", "enter", "overtake", "reach",
     "accelerate", "reverse"}
)  # fmt: skip
"""What who rides something does with it."""
_STATES = frozenset(
    {"be", "posture", "have", "weigh", "measure", "contain", "face", "surround", "park", "noop"}
)
_ACTED_ON = frozenset(
    {"slow", "stop", "brake", "accelerate", "turn", "reverse", "launch", "tow", "topple",
     "knock", "drop", "cause", "pocket", "scatter", "spin"}
)  # fmt: skip
"""Senses whose object moves, so that it cannot be the ground."""
_INSTEAD = re.compile(r"\binstead\b(?! of)", re.IGNORECASE)
_BUT = re.compile(r"\b(?:but|yet)\b[^.;,]*$", re.IGNORECASE)
_AT_FIRST = re.compile(
    r"\b(?:first|initially|until|till|before|for|after|yet|while|when|at the start|beginning)\b",
    re.IGNORECASE,
)
_ANIMAL_VERBS = frozenset(
    {
        "run",
        "walk",
        "jog",
        "gallop",
        "trot",
        "jump",
        "leap",
        "hop",
        "crawl",
        "sprint",
        "dash",
        "charge",
        "sleep",
        "sit",
        "chase",
        "wander",
        "swim",
        "climb",
        "stroll",
        "march",
        "pursue",
    }
)

_VEHICLE_VERBS = frozenset(
    {
        "drive",
        "brake",
        "accelerate",
        "overtake",
        "park",
        "steer",
        "cruise",
        "merge",
        "reverse",
        "swerve",
        "speed",
    }
)


class Interpreter(MotionSenses):
    """Walks over frames in order of time and fills a Scene."""

    def run(self, frames: list[Frame], attachments: list[tuple[Mention, Phrase]]) -> Scene:
        # references are resolved in the order of the text, events in the order of time
        self._refer_all(frames)
        for m, p in attachments:
            self.attachment(m, p)
        for f in frames:
            for g in self._one_time_each(f):
                self.frame(g)
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

    def _refer_all(self, frames: list[Frame]) -> None:
        """Resolves every noun phrase, frame by frame and in the order of the text."""
        framed = self.framed
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
            elif (
                id(item) not in self.world.resolved
                and (item.head or item.pronoun)
                and item.count != 0
            ):
                self.world.resolve(item)

    def _refer(self, f: Frame) -> None:
        """Resolves the noun phrases of a frame, subject first."""
        thrown = f.verb.sense in ("fall", "land") or (
            f.verb.sense in ("launch", "topple") and f.verb.passive
        )
        if f.subject is not None and thrown and f.subject.role in ("rider", "cyclist"):
            f.subject.role = ""  # who falls is the rider, not what is ridden
        control = f.verb.sense in _RIDDEN and f.verb.sense not in ("hit", "miss", "enter", "reach")
        if f.subject is not None and f.subject.role and f.subject.role != "rider":
            f.subject.drives = control and f.object is None
        subject = self._subject(f)
        for m in self.mentions:
            between = f.subject is not None and f.subject.start < m.start < f.verb.start
            named = bool(m.head or m.pronoun)
            if between and id(m) not in self.framed and named and m.count != 0:
                self.ids(m, avoid=subject)
        for m in (f.object, *[p.mention for p in f.phrases]):
            # "A lamp falls on the sofa when a dog bumps it": the lamp
            if (
                m is not None
                and m.pronoun == "it"
                and f.subordinate in ("when", "after", "as", "because", "once")
                and self._last_subject
                and len(self._last_subject) == 1
                and self._last_subject != subject
                and id(m) not in self.world.resolved
            ):
                self.world.resolved[id(m)] = m.entities = list(self._last_subject)
            # "It rolls toward a car, but a man stops it": what was moving
            if (
                m is f.object
                and m is not None
                and m.pronoun == "it"
                and id(m) not in self.world.resolved
                and f.verb.lemma in _HALTING
                and f.subject is not None
                and f.subject.pronoun != "it"
                and len(self._last_moving) == 1
                and self._last_moving[0] not in subject
            ):
                self.world.resolved[id(m)] = m.entities = list(self._last_moving)
            # "A log rolls off a truck. The car behind swerves to avoid it.": the log
            if (
                m is not None
                and m.pronoun == "it"
                and id(m) not in self.world.resolved
                and self._lead.get(f.sentence - 1)
                and not self._named_between(f.subject, m)
                and self._lead[f.sentence - 1] not in subject
                and f.subject is not None
                and not f.subject.pronoun
            ):
                self.world.resolved[id(m)] = m.entities = [self._lead[f.sentence - 1]]
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
            both = bool(f.object.pronoun and f.subject.pronoun)  # "Having hit it, it stops"
            objects = list(f.object.entities) or self.ids(f.object, avoid=subject if both else None)
        else:
            for p in f.phrases:  # "heavier than a 1 kg box strikes the box": as the text goes
                m = p.mention
                if f.object is None or m is None or m.pronoun or m.start > f.object.start:
                    continue
                self.ids(m, avoid=subject)
            objects = self.ids(f.object, avoid=subject)
        objects = self._one_for_each(f, subject, objects)
        self.ids(f.object2, avoid=subject + objects)
        for p in f.phrases:
            if p.mention is not None:
                self.ids(p.mention, avoid=subject + objects)
        struck = f.verb.sense in ("launch", "drop") and not f.verb.passive
        self._launched = list(objects) if struck else []
        self._dropped = f.verb.sense == "drop"
        aimed = f.phrase("at", "toward", "towards", "against")
        if f.verb.sense in ("launch", "hit") and aimed is not None and aimed.mention is not None:
            objects = aimed.mention.entities or objects  # "throws a stone at a can and it falls"
        speed = self.quantity(f, "speed")
        if (
            f.verb.sense == "be"
            and f.subject is not None
            and f.subject.attribute
            and speed is not None
            and len(subject) == 1
        ):
            self.stated[subject[0]] = speed[1]  # "the speed of the car is 12 m/s"
        if objects:
            self._patient_at = f.sentence
        self._patient = objects or self._patient
        lone_object = f.object is not None and len(objects) == 1 and self._aimable(objects[0])
        if lone_object and (struck or f.verb.sense in _MOVING):
            self._last_moving = list(objects)
        elif f.verb.sense in _MOVING and len(subject) == 1 and self.kind(subject[0]) != "person":
            self._last_moving = list(subject)
        self._last_subject = subject or self._last_subject
        if f.verb.sense == "be" and subject:
            for word in f.adverbs:  # "the first car is red"
                if (
                    word in lex.COLORS
                    or word in lex.MATERIALS
                    or word in lex.WEIGHTS
                    or word in lex.SIZES
                ):
                    for node in subject:
                        self.e(node).adjectives.append(word)
        moving = f.verb.sense not in _STATES and f.subject is not None and not f.subject.pronoun
        lone = len(subject) == 1 and self.kind(subject[0]) != "person"
        if moving and not f.reduced and f.sentence not in self._lead:
            single = not objects and lone and self._aimable(subject[0])
            self._lead[f.sentence] = subject[0] if single else ""
        if f.verb.sense in ("be", "posture", "have", "park") and (subject or objects):
            self._topic = (f.sentence, subject or objects)

    def _one_for_each(self, f: Frame, subject: list[str], objects: list[str]) -> list[str]:
        """ "Each ball hits a pin": a pin for every ball."""
        s, o = f.subject, f.object
        if s is None or o is None or not 2 <= len(subject) <= 6 or len(objects) != 1:
            return objects
        if "each" not in (s.determiner, s.pronoun) and s.determiner != "every":
            return objects
        if o.determiner not in ("a", "an") or self.e(objects[0]).origin != o.start:
            return objects
        if f.verb.sense not in ("hit", "knock", "topple") or not self._aimable(objects[0]):
            return objects
        like = self.e(objects[0])
        ids = [objects[0]]
        for _ in subject[1:]:
            ids.append(
                self.world.add(
                    like.noun, like.head, adjectives=list(like.adjectives), label=like.label,
                    known=like.known, origin=o.start,
                ).id
            )  # fmt: skip
        o.entities = ids
        self.world.resolved[id(o)] = ids
        self.pairs.update(zip(subject, ids, strict=True))
        return ids

    def _patient_since(self, sentence: int) -> bool:
        """Whether something was acted on in this sentence."""
        return self._patient_at == sentence

    def _named_between(self, subject: Mention | None, m: Mention) -> bool:
        """Whether the clause names something before a pronoun ("hits the nine and pots it")."""
        if subject is None:
            return False
        start, end = subject.end, m.start
        between = [x for x in self.mentions if start <= x.start < end and not x.pronoun]
        return any(x.entities and not self.structural(x.entities[0]) for x in between)

    def _subject(self, f: Frame) -> list[str]:
        """Referents of the subject; what falls after a push is the thing pushed."""
        m = f.subject
        if (
            m is not None
            and m.pronoun == "it"
            and id(m) not in self.world.resolved
            and f.verb.sense in ("fall", "topple", "land")
            and not f.start_of_sentence
            and self._topic is not None
            and self._topic[0] == f.sentence - 1
            and len(self._topic[1]) == 1
            and self._last_subject
            and self.kind(self._last_subject[0]) in SELF_POWERED
            and not self._patient_since(f.sentence)
        ):
            # "A book lies on a shelf. When a truck passes, it falls.": the book
            self.world.resolved[id(m)] = m.entities = list(self._topic[1])
        if (
            m is not None
            and m.pronoun in ("it", "they")
            and id(m) not in self.world.resolved
            and f.verb.sense in ("fall", "topple", "land", "pocket")
            and self._patient
            and (m.pronoun == "it") == (len(self._patient) == 1)
        ):
            self.world.resolved[id(m)] = m.entities = list(self._patient)
        dropped = f.verb.sense in ("miss", "hit", "land") and self._dropped
        if (
            m is not None
            and m.pronoun == "it"
            and id(m) not in self.world.resolved
            and (f.verb.sense in _FLYING_ON or dropped)
            and len(self._launched) == 1
        ):
            self.world.resolved[id(m)] = m.entities = list(self._launched)
        return self.ids(m, subject=True)

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
        if len(subject) == 1 and sense in _RIDDEN and not f.verb.passive and not objects[1:]:
            mount = self.scene.supported_by.get(subject[0], "")
            riding = mount and self.kind(mount) in SELF_POWERED | {"sliding"}
            if riding and self.kind(subject[0]) == "person" and mount not in objects:
                subject = [mount]  # "a girl on a skateboard ... she hits a hydrant"
        if sense not in _STATES:
            moving = [i for i in subject if self._aimable(i)]
            if subject and not moving and not f.verb.passive:
                self.scene.ignored[(f.verb.start, f.verb.end)] = "the ground does not act"
                return
            subject = moving
        if sense in _ACTED_ON:
            objects = [i for i in objects if self._aimable(i)]
        self._settle_aims(f)
        self.instead = _INSTEAD.search(self._sentence(f)) is not None or (
            _BUT.search(self.text, max(0, f.verb.start - 30), f.verb.start) is not None
        )
        subject = self._struck_one(f, subject)
        speed = self.quantity(f, "speed")
        if f.verb.lemma in ("happen", "occur"):
            self._happens(f)
        if sense == "noop" and subject and speed is not None:
            self.stated[subject[0]] = speed[1]  # "a lorry doing 60 mph"
        for _, a in self.amounts(f):
            if a.dimension == "mass" and subject:
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
        for node in subject if not f.verb.passive else []:
            self._guess_kind(node, f.verb.lemma)
        if (
            f.subject is not None
            and id(f.subject) in self.mounts
            and sense not in ("be", "posture", "weigh", "fall", "topple")
        ):
            subject = list(self.mounts[id(f.subject)])
        against = f.phrase("on", "against", "at")
        if f.verb.lemma in ("end", "wind") and sense in ("noop", "reach"):
            sense = "end"
        if sense == "noop" and f.verb.lemma in _BREAKING and against is not None and subject:
            sense = "hit"  # "breaks on a rock"
        handler = getattr(self, f"_do_{sense}", None)
        if handler is None:
            self.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"
            return
        handler(f, subject, objects)
        self._far_away(f, subject)
        for _, a in self.amounts(f):
            if a.dimension == "time" and self._precedes(a):
                self.gap = a

    def _one_time_each(self, f: Frame) -> list[Frame]:
        """ "The cars brake after 2 s and 3 s": a clause for each member, with its own time."""
        m = f.subject
        timed = [p for p in f.phrases if p.amount is not None and p.amount.dimension == "time"]
        at = [p for p in timed if p.prep in ("after", "at", "in", "")]
        if m is None or len(at) < 2 or len(at) != len(timed):
            return [f]
        many = m.plural or bool(m.coordinated) or len(m.entities) > 1
        if not many or len(m.entities) < len(at) or (len(m.entities) > len(at) and m.count):
            return [f]
        prep = at[0].prep or "after"
        out: list[Frame] = []
        for k, p in enumerate(at):
            rest = [q for q in f.phrases if q not in timed]
            own = replace(m, entities=[m.entities[k]], coordinated=[], amounts=[])
            start = prep if k == 0 or self.tl.last_event is not None else "at"
            out.append(replace(f, subject=own, phrases=[*rest, replace(p, prep=start)]))
        return out

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
                self._do_miss(replace(f, object=None), [actor], [other])
        self.use(f, "misses")

    @staticmethod
    def _one_by_one(f: Frame) -> set[str]:
        """Few things that "both" or "each" distributes over; "all" of a row stays one chain."""
        out: set[str] = set()
        for m in (f.subject, f.object, *[p.mention for p in f.phrases]):
            if m is None or not (2 <= len(m.entities) <= 3):
                continue
            if {"both", "each"} & {m.determiner, m.pronoun}:
                out |= set(m.entities)
        return out

    def _far_away(self, f: Frame, subject: list[str]) -> None:
        """ "lands in a bucket 5 m away": how far things are from each other at the start."""
        for _, a in self.amounts(f):
            after = self.text[a.end : a.end + 8].strip().lower()
            if a.dimension != "length" or (a.start, a.end) in self.scene.used:
                continue
            if not after.startswith(("away", "ahead", "further")):
                continue
            near = [
                m
                for m in (f.object, *[p.mention for p in f.phrases])
                if m is not None and m.entities and m.end <= a.start
            ]
            others = [i for i in near[-1].entities if i not in subject] if near else []
            if others and subject and not self.structural(others[0]):
                for node in subject[:1]:
                    self.scene.relations.append(Relation(node, others[0], "near", a.value))
                self.use(a, "distance at the start")

    def _settle_aims(self, f: Frame) -> None:
        """What was thrown at something hits it before the prompt turns to other things."""
        mentions = [f.subject, f.object, f.object2, *[p.mention for p in f.phrases]]
        about = {i for m in mentions if m is not None for i in m.entities}
        about |= {t for m in mentions if m is not None for t in self.thrown.get(id(m), [])}
        for actor, (kind, g, target, _) in list(self.pending.items()):
            aimed = kind in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION)
            if aimed and g.sentence < f.sentence and about and not about & {actor, target}:
                self._settle(actor, None)

    def _happens(self, f: Frame) -> None:
        """ "The crash happens after 3 seconds": the time of the event told last."""
        time, last = self._time(f), self.tl.node(self.tl.last_event or "")
        if (
            time is not None
            and last is not None
            and last.time is None
            and not last.constraints
            and (len(self.tl.nodes) == 1 or time[2] == "at")
        ):
            last.time, last.time_prescribed = time[0], True
            self.use(time[1], f"time of {last.id}")

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
        if model is not None:
            like = lex.nouns()[model]
            entity.noun = replace(
                like, name=entity.head, description=f"{entity.head}, like a {model}", synonyms=()
            )
