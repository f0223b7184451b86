"""Verbs of state: be, stand, weigh, contain, face, carry."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

from esg.draft import lexicon as lex
from esg.draft.consequences import Consequences
from esg.draft.elements import Mention
from esg.draft.entities import BODY_PARTS
from esg.draft.frames import Frame, Phrase
from esg.draft.places import RELATION_PREPS
from esg.draft.quantities import Amount
from esg.draft.scene import SELF_POWERED, Relation
from esg.draft.shares import dealt
from esg.graph.models import NodeEvent

_WAITING = frozenset(
    {"wait", "pause", "stay", "remain", "stand", "sit", "idle", "queue", "rest", "hover"}
)
_PATTERN_VERBS = {
    "stack": "stack",
    "pile": "stack",
    "heap": "stack",
    "line": "row",
    "rack": "rack",
    "queue": "queue",
}
"""Arrangement of a plural by the verb that says how it stands."""
_LEANT_ON_CM = 60.0
_UPON = ("on", "in", "inside", "upon")
_LEANING = frozenset({"lean", "prop"})
_HANGING = frozenset({"hang", "suspend", "mount", "attach", "fix", "dangle", "fasten"})
_HUNG_BY = frozenset({"on", "against", "from", "to", "at", "off"})
_SIDES = frozenset({"height", "length", "width", "diameter", "radius", "size", "thickness"})
_CARRIED_ALONG = frozenset(
    {"to", "toward", "towards", "around", "across", "along", "through", "past", "up", "down"}
)
_RESTING = frozenset({"rest", "lie", "settle", "lodge"})


class StateSenses(Consequences):
    """Descriptions of how things are at the start."""

    def upon(self, attachments: list[tuple[Mention, Phrase]]) -> None:
        """ "a cart with a box on it": what "it" is that the box is on."""
        bearers = {id(p.mention): m for m, p in attachments if p.prep == "with" and p.mention}
        for m, p in attachments:
            bearer = bearers.get(id(m))
            it = p.mention is not None and p.mention.pronoun in ("it", "them")
            if bearer is None or not it or p.mention is None or p.prep not in _UPON:
                continue
            p.mention.entities = self.world.resolved[id(p.mention)] = list(bearer.entities)
            self.upon_it.add(id(m))

    def attachment(self, m: Mention, p: Phrase) -> None:
        """A noun phrase with a prepositional phrase: a place or a property."""
        owners = m.entities or self.ids(m)
        at = p.amount.start if p.amount is not None else p.mention.start if p.mention else -1
        later = [i for c in m.coordinated if c.start > at >= m.end for i in c.entities]
        owners = [i for i in owners if i not in later] or owners  # "the first at 2 m/s, the second"
        owners = self._sharers(owners, p)
        if p.amount is not None:
            for o, own in zip(owners, dealt([p.amount], len(owners)), strict=True):
                for a in own:
                    if a.dimension == "speed":
                        self.stated[o] = a
                    elif self.world.apply_amount(self.e(o), a):
                        self.use(a, o)
            return
        if p.mention is None:
            return
        if p.mention.attribute:
            self._arrange(owners, p)
            listed = [p.mention, *[c for c in p.mention.coordinated if c.attribute]]
            told = dealt([a for c in listed for a in c.amounts], len(owners))
            for o, own in zip(owners, told, strict=True):
                for a in own:
                    if a.dimension == "speed":
                        self.stated[o] = a
                    elif a.dimension == "length" and p.prep == "at" and p.mention.head == "height":
                        self._start_height([o], a)
                    elif self.world.apply_amount(self.e(o), a, p.mention.head):
                        self.use(a, o)
            return
        others = p.mention.entities or self.ids(p.mention, avoid=owners)
        if p.prep == "with" and id(p.mention) in self.upon_it:
            return
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
        if p.prep == "on" and p.mention.head in BODY_PARTS:
            # "slides down a ramp on its belly": how it lies, not where the ramp is
            owners = [o for o in owners if not self._carries_beings(o)]
        self.place(owners, others, p.prep, p.mention.part)

    def _carries_beings(self, node: str) -> bool:
        """Whether people and animals are on it, not it on them: slopes, furniture."""
        traits = self.e(node).noun.traits
        return bool({"support", "incline"} & traits) or not self.movable(node)

    def _sharers(self, owners: list[str], p: Phrase) -> list[str]:
        """ "two balls, red and blue, with masses of 1 kg and 3 kg": all that a list is told of."""
        number = max((len(a.shares) for a in p.told), default=0)
        if number < 2 or len(owners) != 1:
            return owners
        wholes = [*self.world.groups.values(), *self.world.salience[::-1]]
        return next((w for w in wholes if len(w) == number and w[-1] == owners[0]), owners)

    def attachment_with(self, owners: list[str], others: list[str]) -> None:
        host = self.e(owners[0]).noun
        prep = "on" if "support" in host.traits else "in" if "container" in host.traits else "near"
        self.place(others, owners, prep)

    def _mass_of_load(self, a: Amount) -> bool:
        """ "loaded with 400 kg of bricks": the mass of what the amount is of."""
        if not self.text[a.end : a.end + 4].startswith(" of "):
            return False
        later = [m for m in self.mentions if m.start >= a.end and m.entities]
        of = min(later, key=lambda m: m.start, default=None)
        if of is None or of.start > a.end + 8:
            return False
        for node in of.entities:
            share = replace(a, low=a.low / len(of.entities), high=a.high / len(of.entities))
            self.world.apply_amount(self.e(self.world.current(node)), share)
        self.use(a, of.entities[0])
        return True

    def _do_be(self, f: Frame, s: list[str], o: list[str]) -> None:
        things = s or o
        if f.subject is not None and f.subject.attribute and f.subject.possessor is None and not s:
            things = o
        if o and s and f.object is not None and f.object.attribute is False:
            self.use(f, "copula")
        self._hovering(f, things)
        self._places(f, things)
        for _, a in self.amounts(f):
            if (a.start, a.end) in self.scene.used:
                continue
            named = f.subject.head if f.subject is not None and f.subject.attribute else ""
            if a.dimension == "length" and named in _SIDES:
                for t in things:
                    self.world.apply_amount(self.e(t), a, named)
                self.use(a, named)
            elif a.dimension == "length":
                word = next((x for x in f.adverbs), "")
                after = self.text[a.end : a.end + 12].strip().split(" ")[0].strip(".,;")
                if after in ("tall", "high", "wide", "long", "thick", "deep"):
                    for t in things:
                        self.world.apply_amount(self.e(t), a, after)
                    self.use(a, word or after)
        self.use(f, "state")

    def _hovering(self, f: Frame, things: list[str]) -> None:
        """ "hovers 3 m above the ground": a height at the start."""
        grounded = f.phrase("above", "over", "off")
        others = grounded.mention.entities if grounded and grounded.mention else []
        for _, a in self.amounts(f):
            above = self.text[a.end : a.end + 7].strip().startswith(("above", "up", "high", "off"))
            tall = f.verb.sense == "posture" and all(map(self.structural, others))
            above = above or (f.verb.lemma in ("hover", "float") and "at " in self._just_before(a))
            if a.dimension == "length" and above and tall:
                self._start_height(things, a)

    def _just_before(self, a: Amount) -> str:
        return self.text[max(0, a.start - 4) : a.start].lower()

    def _do_posture(self, f: Frame, s: list[str], o: list[str]) -> None:
        """A state; of what has moved before, where it ends ("and at the end rests on a towel")."""
        lasting = next((a for _, a in self.amounts(f) if a.dimension == "time"), None)
        if lasting is not None and f.verb.lemma in _WAITING and not f.reduced:
            for actor in s:
                if self.kind(actor) in SELF_POWERED:
                    track = self.tl.tracks.get(actor)
                    if track is not None and track.motion is not None and not track.closed:
                        self.event(NodeEvent.TRIGGER, (actor,), f, None)  # "drives for 4 s, waits"
                        track.motion = None
                    self.waiting[actor] = lasting
                    self.use(lasting, "waiting time")
        if f.verb.lemma == "stick" and not f.reduced and s and self._at_end(f, s[0], "at"):
            p = f.phrase("at", "on", "in", "against", "onto", "upon")
            self._hit(f, s[:1], p.mention.entities[:1] if p and p.mention else [], self._time(f))
            return
        moved = s and not f.reduced and f.link == "then" and f.verb.lemma in _RESTING
        if moved and not f.verb.passive and self._at_end(f, s[0]):
            self._read_as("land", f, s, o)
            return
        self._do_be(f, s, o)

    def _at_end(self, f: Frame, actor: str, *preps: str) -> bool:
        track = self.tl.tracks.get(actor)
        if track is None or (track.motion is None and not track.hit):
            return False
        on = f.phrase("on", "in", "against", "onto", "upon", *preps)
        return on is not None and on.mention is not None and bool(on.mention.entities)

    def _do_unknown(self, f: Frame, s: list[str], o: list[str]) -> None:
        """An unknown verb is a motion if its phrases are; it is reported either way."""
        ways = f.phrase(
            "toward", "towards", "into", "across", "along", "through", "down", "against"
        )
        if s and (ways is not None or self.quantity(f, "speed") is not None):
            self._motion(f, s, None)
            self.scene.used.pop((f.verb.start, f.verb.end), None)

    def _do_acquire(self, f: Frame, s: list[str], o: list[str]) -> None:
        found = self.quantity(f, "speed")
        if found is not None and s and not self._speed_after(s[0], found[1]):
            self._read_as("accelerate", f, s, o)
        self.use(f, "speed")

    def _do_weigh(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.use(f, "mass")

    def _do_have(self, f: Frame, s: list[str], o: list[str]) -> None:
        word = f.object.head if f.object is not None else ""
        self._measured(f, s, word)
        if s and o and f.phrase("on", "in", "inside") is None:
            self.attachment_with(s, o)
        self._places(f, o)
        self.use(f, "property")

    def _do_measure(self, f: Frame, s: list[str], o: list[str]) -> None:
        self._measured(f, s)
        self.use(f, "size")

    def _measured(self, f: Frame, things: list[str], word: str = "") -> None:
        """What the quantities of a clause say of things, one value each where there are as many."""
        told = dealt([a for _, a in self.amounts(f)], len(things))
        for t, own in zip(things, told, strict=True):
            for a in own:
                if self.world.apply_amount(self.e(t), a, word):
                    self.use(a, t)

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
        inner, outer = (
            (
                s,
                [
                    i
                    for p in f.phrases
                    if p.prep in ("by", "with") and p.mention
                    for i in p.mention.entities
                ],
            )
            if f.verb.passive
            else (o, s)
        )
        if inner and outer:
            for t in outer:
                self.scene.relations.append(Relation(t, inner[0], "surround"))
        self.use(f, "state")

    def _places(self, f: Frame, things: list[str]) -> None:
        distance = next(
            (a for p, a in self.amounts(f) if a.dimension == "length" and p in ("", "at", "about")),
            None,
        )
        pattern = _PATTERN_VERBS.get(f.verb.lemma)
        if "in a row" in f.adverbs:
            pattern = "row"
        for t in things if pattern is not None else []:
            self._pattern_of(t, pattern)
        for _, a in self.amounts(f):
            if a.dimension == "length" and self.text[a.end : a.end + 7].strip().startswith("apart"):
                rows = self.world.groups.values()
                whole = next((g for g in rows if things[:1] and things[0] in g), things)
                for one, other in pairwise(things if len(things) > 1 else whole):
                    self.scene.relations.append(Relation(one, other, "near", a.value))
                    self.use(a, "distance")
        for p in f.phrases:
            if p.mention is None or p.mention.attribute:
                self._arrange(things, p)
                continue
            others = p.mention.entities
            if f.verb.lemma in _HANGING and p.prep in _HUNG_BY and others:
                high = self._towers(others[0]) or self.kind(others[0]) == "ceiling"
                hung = [t for t in things if high and not self.structural(t)]
                for t in hung:
                    self.hang(t, others[0])
                if hung:
                    continue
            if f.verb.lemma in _LEANING and p.prep in ("on", "against", "at", "by") and others:
                host = self.e(others[0])
                if (host.dimensions_cm or host.noun.dimensions_cm)[2] >= _LEANT_ON_CM:
                    self._lean(things, others)
                    continue
            if p.prep == "with" and f.verb.lemma in ("cover", "load", "fill", "stack", "set"):
                for t in things[:1]:
                    if f.verb.lemma == "load" and self.kind(t) in SELF_POWERED:
                        self.place(others, [t], "on")  # "a truck loaded with barrels"
                    else:
                        self.attachment_with([t], others)
                continue
            if p.prep in RELATION_PREPS:
                fixed = None
                if distance is not None and things and p.prep not in ("on", "in", "inside"):
                    fixed = distance.value
                    self.use(distance, "distance")
                self.place(things, others, p.prep, p.mention.part, fixed)
            elif p.prep in ("from", "away from") and distance is not None and others and things:
                for t in things:
                    self.scene.relations.append(Relation(t, others[0], "near", distance.value))
                self.use(distance, "distance")

    def _lean(self, things: list[str], others: list[str]) -> None:
        """ "A broom leans on a wall": it stands beside it on its end, and can only tip over."""
        for t in things:
            e = self.e(t)
            dims = list(e.dimensions_cm or e.noun.dimensions_cm)
            if self.movable(t) and max(dims[:2]) > 2.0 * dims[2]:
                long = 0 if dims[0] >= dims[1] else 1
                dims[long], dims[2] = dims[2], dims[long]
                e.dimensions_cm = dims
            self.leaning.add(t)
        self.place(things, others, "against")

    def _arrange(self, things: list[str], p: Phrase) -> None:
        """ "in a triangle", "in a queue": how a plural stands."""
        m = p.mention
        pattern = lex.ARRANGEMENTS.get(m.head) if m is not None else None
        if m is None or not m.attribute or p.prep not in ("in", "into") or pattern is None:
            return
        for t in things:
            self._pattern_of(t, pattern)

    def _pattern_of(self, thing: str, pattern: str | None) -> None:
        e = self.e(thing)
        if e.group is not None and pattern is not None:
            racked = pattern == "pins" and e.noun.kind == "billiard"
            e.pattern = "rack" if racked else pattern

    def _do_carry(self, f: Frame, s: list[str], o: list[str]) -> None:
        if s and o:
            self.place(o, s, "on")
        if s and o and f.verb.lemma in ("carry", "transport") and not self.movable(s[0]):
            self._motion(f, o, "slide")  # "a conveyor carries a box past a guard"
        elif s and (self.quantity(f, "speed") or any(p.prep in _CARRIED_ALONG for p in f.phrases)):
            self._motion(f, s, None)
        self.use(f, "carrying")

    def _do_apply(self, f: Frame, s: list[str], o: list[str]) -> None:
        self.scene.ignored[(f.verb.start, f.verb.end)] = "no physical meaning"

    def _do_start(self, f: Frame, s: list[str], o: list[str]) -> None:
        """ "starts at 5 m/s, 3 m from the pins": how the motion to come begins."""
        self._do_apply(f, s, o)
        speed = self.quantity(f, "speed")
        if speed is not None and len(s) == 1:
            self.stated[s[0]] = speed[1]
        self._sets_off_late(f, s)
        self._starts_apart(f, s)
        self._starts_off(f, s, o)

    def _starts_off(self, f: Frame, s: list[str], o: list[str]) -> None:
        """ "The light turns green and the van starts": it drives off, and nothing more is told."""
        fresh = [a for a in s if not self.tl.track(a).motion and not self.tl.track(a).hit]
        driven = [a for a in fresh if self.kind(a) in SELF_POWERED]
        at = next((k for k, g in enumerate(self.told) if g.verb is f.verb), 0)
        later = {i for g in self.told[at + 1 :] if g.subject for i in g.subject.entities}
        if driven and not o and not f.phrases and not later & {*driven}:
            self._motion(f, driven, None)
