"""Clauses: who does what to whom, in which order.

A frame is one verb with its subject, object, prepositional phrases, adverbs and quantities. Frames
come out in order of time: "after", "before", "when" and fronted clauses are untangled here.
"""

from __future__ import annotations

from esg.draft.frames import (
    Frame,
    Phrase,
    State,
    background_first,
    finite_ahead,
    in_order,
    next_verb,
)
from esg.draft.quantities import Amount
from esg.draft.syntax import Element, Mention, Verb, Word

CAUSE_SENSES = frozenset({"cause", "knock", "launch", "drop", "lead", "give", "pocket", "scatter"})
_TRANSPARENT = frozenset({"noop"})


class ClauseBuilder:
    """Walks over the elements of a prompt and builds frames, mentions and verbless facts."""

    def __init__(self, elements: list[Element]) -> None:
        self.elements = elements
        self.frames: list[Frame] = []
        self.mentions: list[Mention] = []
        self.attachments: list[tuple[Mention, Phrase]] = []
        """Noun phrase + prepositional phrase outside any verb ("a table with bottles on it")."""
        self.loose: list[tuple[int, Amount]] = []
        self.sentence = 0
        self.nominal: list[Verb] = []
        """Gerunds that name a time span or a means."""
        self._told: set[int] = set()
        """Quantities that a property beside its noun has taken."""
        self._quantified: Mention | None = None
        """Noun that the last quantity was a property of."""

    def run(self) -> None:
        s = State()
        els = self.elements
        i = 0
        while i < len(els):
            e = els[i]
            if isinstance(e, Mention):
                self.mentions.append(e)
                self._mention(s, e, i)
            elif isinstance(e, Verb):
                self._verb(s, e, i)
            else:
                s = self._word(s, e, i)
            i += 1
        self._flush(s)
        for k, f in enumerate(self.frames):
            self._hand_over(f)
            self._takes_time(f, self.frames[k + 1 : k + 2])
            self._fronted(f, [g for g in self.frames[k + 1 :] if g.sentence == f.sentence])
        self.frames = in_order(background_first(self.frames))

    @staticmethod
    def _hand_over(f: Frame) -> None:
        """ "car B, weighing 1500 kg, at 10 m/s": the speed belongs to the clause around it."""
        if f.parent is None or f.verb.sense not in ("weigh", "measure", "have"):
            return
        for p in list(f.phrases):
            if p.amount is not None and p.amount.dimension in ("speed", "time"):
                f.phrases.remove(p)
                f.parent.phrases.append(p)

    @staticmethod
    def _fronted(f: Frame, following: list[Frame]) -> None:
        """ "After hitting a cone, the car ...", "Struck by a car, the bin ...": subject to come."""
        main = next((g for g in following if g.subject is not None), None)
        for p in [p for p in f.phrases if p.prep == _UNTIL_MAIN]:
            p.prep = "after"
            if following:
                f.phrases.remove(p)
                following[0].phrases.append(p)
        if f.subject is not None:
            return
        if main is None or main.subject is None or main.subject.start < f.verb.start:
            return
        agent = f.phrase("by")
        participle = f.verb.form in ("pp", "past") and agent is not None and f.object is None
        if f.verb.form == "ing" or participle or (f.verb.passive and f.link.startswith("sub:")):
            f.subject = main.subject
            f.verb.passive = f.verb.passive or participle

    @staticmethod
    def _takes_time(f: Frame, following: list[Frame]) -> None:
        """ "needs 5 seconds to stop", "takes 2 s to reach the door": the time of what follows."""
        if f.verb.lemma not in _TAKING or not following or following[0].link != "purpose":
            return
        for p in list(f.phrases):
            if p.amount is not None and p.amount.dimension == "time":
                f.phrases.remove(p)
                following[0].phrases.append(p)

    # -- words -----------------------------------------------------------------------------------

    def _word(self, s: State, w: Word, i: int) -> State:
        if w.kind == "punct":
            if w.low in ".;!?\n":
                self._flush(s)
                self.sentence += 1
                new = State(main=s.main)
                return new
            if w.low in ",:-–—()":
                s.boundary, s.boundary_kind = True, "comma"
                s.prep = ""
            return s
        if w.kind == "conj":
            s.boundary, s.boundary_kind = True, "conj"
            if not (s.prep and s.last is None):
                s.prep = s.prep if s.prep and not isinstance(self.elements[i - 1], Mention) else ""
            return s
        if w.kind == "rel":
            s.relative = s.last
            s.boundary, s.boundary_kind = True, "rel"
            if w.low == "whose":
                s.boundary_kind = "whose"
            return s
        if w.kind == "sub":
            s.sub = w.low
            s.boundary, s.boundary_kind = True, "sub"
            s.prep = ""
            return s
        if w.kind in ("prep", "to"):
            nxt = self.elements[i + 1] if i + 1 < len(self.elements) else None
            if nxt is None or (
                isinstance(nxt, Word) and nxt.kind in ("punct", "conj", "sub", "rel")
            ):
                if s.frame is not None:
                    s.frame.adverbs.append(w.low)  # a particle: "knocking them over"
                return s
            s.prep = w.low
            return s
        if id(w) in self._told:
            return s
        if w.kind == "qty" and w.amount is not None and self._belongs_to_noun(s, w, i):
            return s
        if w.kind == "qty" and w.amount is not None:
            phrase = Phrase(s.prep, None, w.amount)
            nxt = self.elements[i + 1] if i + 1 < len(self.elements) else None
            if isinstance(nxt, Word) and nxt.low in ("later", "afterwards", "afterward"):
                phrase.prep = "after"
                rest = self.elements[i + 2 : i + 4]
                if (
                    s.boundary
                    and isinstance(rest[0] if rest else None, Word)
                    and rest[0].low == ","
                ):
                    s.loose.append(phrase)  # "and, 1.5 s later, crashes"
                    s.prep = ""
                    return s
            pair = i >= 2 and isinstance(self.elements[i - 2], Word)
            pair = pair and getattr(self.elements[i - 2], "amount", None) is not None
            if s.frame is not None and (
                pair or not (s.boundary and finite_ahead(self.elements, i + 1) and not s.prep)
            ):
                if s.boundary and s.boundary_kind == "comma" and finite_ahead(self.elements, i + 1):
                    s.loose.append(phrase)
                else:
                    s.frame.phrases.append(phrase)
            else:
                s.loose.append(phrase)
            s.prep = ""
            return s
        if (
            w.kind == "unknown"
            and s.frame is not None
            and s.frame.verb.sense == "be"
            and not s.boundary
        ):
            s.frame.adverbs.append(w.low)
            return s
        if w.kind == "unknown" and w.low in ("suppose", "imagine", "picture", "consider"):
            return s
        if w.kind == "adv":
            if w.low in ("then", "next", "simultaneously", "meanwhile") and w.low != "next":
                s.link = "simultaneously" if w.low in ("simultaneously", "meanwhile") else "then"
                if w.low == "then" and s.boundary_kind != "rel":
                    s.boundary, s.boundary_kind = (
                        True,
                        "conj" if s.boundary_kind != "comma" else "comma",
                    )
                if (
                    s.frame is not None
                    and w.low == "simultaneously"
                    and not finite_ahead(self.elements, i + 1)
                ):
                    s.frame.adverbs.append(w.low)
                    s.frame.link = "simultaneously"
                return s
            side = w.low in ("left", "right")
            if s.frame is not None and (
                side or not (s.boundary and finite_ahead(self.elements, i + 1))
            ):
                s.frame.adverbs.append(w.low)
            else:
                s.loose.append(w.low)
            return s
        return s

    def _belongs_to_noun(self, s: State, w: Word, i: int) -> bool:
        """ "a ball of 2 kg", "the van (3 tons)": a property of the noun before."""
        assert w.amount is not None
        previous = self.elements[i - 1] if i else None
        before = self.elements[i - 2] if i >= 2 else None
        if (
            isinstance(previous, Word)
            and previous.kind == "conj"
            and isinstance(before, Word)
            and before.amount is not None
            and self._quantified is not None
            and before.amount in self._quantified.amounts
        ):
            self._quantified.amounts.append(w.amount)
            return True
        noun = (
            before
            if isinstance(previous, Word) and previous.low in ("of", "at", ",", "(", "about")
            else previous
        )
        if not isinstance(noun, Mention) or noun.pronoun:
            return False
        if noun.attribute:
            if noun.possessor is not None:
                return False
            noun.amounts.append(w.amount)
            s.prep = ""
            return True
        if w.amount.dimension not in ("mass", "length") or (
            isinstance(previous, Word) and previous.low == "at"
        ):
            return False
        after = self.elements[i + 1] if i + 1 < len(self.elements) else None
        if (
            w.amount.dimension == "length"
            and not (isinstance(previous, Word) and previous.low == "of")
            and not (
                isinstance(after, (Word, Mention))
                and getattr(after, "low", getattr(after, "head", "")) in _SIZES
            )
        ):
            return False
        if (
            s.frame is not None
            and s.frame.verb.sense in ("weigh", "measure", "be", "have")
            and noun is s.frame.subject
        ):
            return False
        if isinstance(after, (Word, Mention)):
            word = getattr(after, "low", "") or getattr(after, "head", "")
            if word in _SIZES:
                noun.adjectives.append(f"@{w.amount.start}:{word}")
        noun.amounts.append(w.amount)
        self._quantified = noun
        s.prep = ""
        return True

    # -- mentions --------------------------------------------------------------------------------

    def _mention(self, s: State, m: Mention, i: int) -> None:
        m.after_prep = s.prep
        prep, s.prep = s.prep, ""
        previous = self.elements[i - 1] if i else None
        if self._stated_beside(m, i):
            return
        coordinated = (
            isinstance(previous, Word)
            and (previous.kind == "conj" or previous.low in (",", "then"))
            and s.last is not None
            and isinstance(self.elements[i - 2] if i >= 2 else None, (Mention, Word))
        )
        if (
            coordinated
            and not prep
            and m.attribute
            and m.head in _PROPERTIES
            and s.frame is None
            and s.last is not None
            and not s.last.attribute
            and m.possessor is None
        ):
            self.attachments.append((s.last, Phrase("with", m)))  # "radius 9 cm and mass 2 kg"
            return
        new_clause = s.boundary and not prep and finite_ahead(self.elements, i + 1)
        if s.relative is not None and s.boundary and s.boundary_kind in ("rel", "whose"):
            # object relative: "the box that the ball hits"
            s.subject = m
            s.last = m
            s.boundary = False
            s.boundary_kind = "objrel" if s.boundary_kind == "rel" else ""
            return
        if prep:
            if s.sub and s.frame is None:
                pass
            phrase = Phrase(prep, m)
            self._attach(s, phrase, i)
            if not m.attribute:
                s.last, s.last_after_prep = m, True
            if not s.boundary or s.boundary_kind != "comma" or s.frame is not None:
                s.boundary = s.boundary and s.frame is None
            return
        if coordinated and s.last is not None and not new_clause and s.last is not s.relative:
            s.last.coordinated.append(m)
            if s.frame is None and s.subject is None:
                s.subject = s.last
            return
        if (
            coordinated
            and s.frame is None
            and s.subject is not None
            and new_clause
            and s.boundary_kind in ("conj", "comma")
        ):
            # "a car and a truck drive": one subject
            s.subject.coordinated.append(m)
            s.boundary = False
            return
        if s.boundary or s.frame is None:
            if s.subject is not None and s.frame is None and not s.boundary:
                s.last = m
                return
            if not new_clause and s.frame is not None and s.boundary:
                verb = next_verb(self.elements, i + 1)
                if verb is None or not isinstance(
                    self.elements[min(i + 1, len(self.elements) - 1)], (Verb, Word)
                ):
                    s.last = m
                    self._absolute(s, m, i)
                    return
                s.last = m
                self._absolute(s, m, i)
                return
            s.subject = m
            s.frame = None
            s.boundary = False
            s.last, s.last_after_prep = m, False
            return
        frame = s.frame
        if frame.object is None and not frame.verb.passive:
            frame.object = m
        elif frame.object2 is None:
            frame.object2 = m
        s.last, s.last_after_prep = m, False

    def _stated_beside(self, m: Mention, i: int) -> bool:
        """ "the red sphere (mass 2 kg)": the property belongs to the noun before."""
        els = self.elements
        if not m.attribute or i < 2 or i + 1 >= len(els):
            return False
        owner, mark, value = els[i - 2], els[i - 1], els[i + 1]
        if not (isinstance(owner, Mention) and isinstance(mark, Word) and isinstance(value, Word)):
            return False
        if mark.low not in "(,–—-" or value.amount is None or owner.pronoun or owner.attribute:
            return False
        if value.amount.dimension not in ("mass", "length") or m.head not in _PROPERTIES:
            return False
        owner.amounts.append(value.amount)
        if value.amount.dimension == "length":
            owner.adjectives.append(f"@{value.amount.start}:{m.head}")
        self._told.add(id(value))
        return True

    def _absolute(self, s: State, m: Mention, i: int) -> None:
        """ "..., one in front of the other": a subject that a participle or phrase may follow."""
        s.subject = m
        s.boundary = False
        s.frame = None

    def _attach(self, s: State, phrase: Phrase, i: int) -> None:
        previous = s.last
        aimed = phrase.prep in ("at", "against") and not s.boundary
        if aimed and s.frame is not None and s.frame.verb.sense == "launch":
            s.frame.phrases.append(phrase)  # "throws a ball at a wall": not a ball at a wall
            return
        if phrase.prep == "by" and s.frame is not None and s.frame.verb.passive:
            s.frame.phrases.append(phrase)
            return
        noun_attached = phrase.prep in (
            "with",
            "of",
            "on",
            "in",
            "near",
            "beside",
            "next to",
            "under",
            "behind",
            "in front of",
            "left of",
            "right of",
            "inside",
            "above",
            "between",
            "by",
            "at",
            "around",
            "against",
            "in the middle of",
            "far from",
            "opposite",
            "below",
            "along",
            "underneath",
            "outside",
            "without",
            "from",
        )
        if (
            s.frame is not None
            and phrase.mention is not None
            and phrase.mention.attribute
            and not (
                phrase.prep == "of"
                or (
                    phrase.prep == "with"
                    and phrase.mention.head in _PROPERTIES
                    and s.last is not s.frame.subject
                )
            )
        ):
            s.frame.phrases.append(phrase)
            return
        if s.frame is None:
            owner = s.subject
            if (
                owner is not None
                and owner.attribute
                and owner.head in _OWNED
                and phrase.prep == "of"
                and phrase.mention is not None
                and owner.possessor is None
            ):
                owner.possessor = phrase.mention  # "the speed of the car"
                return
            if s.subject is not None and noun_attached and not s.boundary:
                self.attachments.append((s.last or s.subject, phrase))
            elif s.boundary or s.subject is None:
                s.loose.append(phrase)
            else:
                self.attachments.append((s.subject, phrase))
            return
        if s.boundary and s.boundary_kind == "comma" and finite_ahead(self.elements, i + 1):
            s.loose.append(phrase)
            return
        if (
            previous is not None
            and noun_attached
            and phrase.prep != "of"
            and isinstance(self.elements[i - 2] if i >= 2 else None, Mention)
            and (s.frame.object is previous or s.last_after_prep)
        ):
            self.attachments.append((previous, phrase))
            if s.frame.verb.sense in (
                "posture",
                "be",
                "launch",
                "drop",
                "hit",
                "own",
                "roll",
                "slide",
                "pocket",
                "cause",
                "knock",
            ):
                s.frame.phrases.append(phrase)
            return
        if (
            phrase.prep == "of"
            and previous is not None
            and phrase.mention is not None
            and not previous.attribute
        ):
            self.attachments.append((previous, phrase))
            return
        s.frame.phrases.append(phrase)

    # -- verbs -----------------------------------------------------------------------------------

    def _verb(self, s: State, v: Verb, i: int) -> None:
        before = self.elements[i - 1] if i else None
        after_prep = before.low if isinstance(before, Word) and before.kind == "prep" else ""
        if v.form == "ing" and after_prep in ("of", "for") and s.frame is not None:
            s.frame.adverbs.append(v.lemma)  # "after 6 seconds of braking"
            self.nominal.append(v)
            s.prep = ""
            return
        v.negated = v.negated or after_prep == "without"
        if after_prep in ("after", "before") and s.frame is None and not s.sub:
            s.sub, s.prep = after_prep, ""  # "after being kicked"
        frame = Frame(v, sentence=self.sentence, link=s.link)
        previous = s.frame
        s.link = "then"
        if s.boundary_kind == "objrel":
            frame.subject = s.subject
            frame.object = s.relative
            s.boundary_kind = ""
            frame.reduced = True
        elif s.boundary and s.boundary_kind == "rel":
            frame.subject = s.relative
            frame.reduced = frame.relative = True
            frame.parent = previous
        elif v.form == "ing" and after_prep in ("without", "by", "from") and previous is not None:
            frame.subject, frame.parent = self._agent(previous), previous
            frame.link = "then"
        elif v.infinitive and previous is not None:
            self._infinitive(s, frame, previous)
        elif previous is None:
            self._first(s, frame, i)
        elif s.sub:
            # "while rolling", "after hitting": shares the main subject
            frame.subject = (
                s.subject if s.subject is not None and not s.boundary else self._agent(previous)
            )
        elif v.form == "ing" and not v.auxiliary:
            self._participle(s, frame, previous)
        elif (
            not s.boundary
            and previous.object is not None
            and s.last is previous.object
            and v.form in ("base", "pp")
            and previous.verb.sense in ("cause", "noop")
        ):
            frame.subject = previous.object
            frame.causer = previous
            frame.link = "cause"
        elif not s.boundary and v.form in ("pp", "past") and not v.auxiliary and s.last is not None:
            # reduced relative on the last noun: "a bicycle stopped in the road"
            frame.subject, frame.reduced, frame.parent = s.last, True, previous
            if v.sense not in ("posture", "park", "stop", "hit", "topple", "fall"):
                v.passive = True
        elif (
            previous.relative
            and s.boundary_kind == "conj"
            and v.form != "ing"
            and previous.verb.sense
            not in ("be", "posture", "park", "weigh", "measure", "have", "contain")
        ):
            # ", which rolls away and hits C": the relative clause goes on
            frame.subject, frame.relative, frame.reduced = previous.subject, True, True
            frame.parent = previous.parent
        else:
            frame.subject = self._agent(previous)
            frame.parent = previous
        self._finish(s, frame)

    def _agent(self, frame: Frame) -> Mention | None:
        """Who carries on after this frame: the subject; the thing thrown for an imperative."""
        if frame.reduced and frame.parent is not None:
            return self._agent(frame.parent)
        if frame.subject is None:
            return frame.object
        return frame.subject

    def _first(self, s: State, frame: Frame, i: int) -> None:
        v = frame.verb
        frame.subject = s.subject
        if s.subject is None and s.boundary and s.main is not None and v.form in ("pp",):
            frame.subject = None
        if (
            s.subject is not None
            and v.form in ("pp", "past", "ing")
            and not v.auxiliary
            and self._main_verb_follows(i)
        ):
            # "a ball thrown at the wall bounces", "a car parked by the road is hit"
            frame.reduced = True
            if v.form != "ing" and v.sense not in (
                "posture",
                "park",
                "stop",
                "fall",
                "topple",
                "roll",
                "slide",
            ):
                v.passive = True
            frame.subject = s.subject
        elif s.subject is not None and v.form == "pp" and not v.auxiliary and not v.passive:
            v.passive = v.sense in ("launch", "drop", "pass", "posture")

    def _main_verb_follows(self, i: int) -> bool:
        for e in self.elements[i + 1 :]:
            if (
                isinstance(e, Verb)
                and not e.infinitive
                and not (e.form == "ing" and not e.auxiliary)
            ):
                return True
            if isinstance(e, Word) and (
                (e.kind == "punct" and e.low in ".;:!?,")
                or e.kind in ("conj", "sub", "rel")
                or e.low == "then"
            ):
                return False
        return False

    def _infinitive(self, s: State, frame: Frame, previous: Frame) -> None:
        if previous.verb.sense in CAUSE_SENSES | {"hit"} and previous.object is not None:
            frame.subject = previous.object
            frame.causer = previous
            frame.link = "cause"
        elif previous.verb.sense in CAUSE_SENSES and previous.verb.passive:
            frame.subject = previous.subject
            frame.causer = previous
        else:
            frame.subject = self._agent(previous)
            frame.link = "purpose"
            frame.parent = previous
            frame.verb.negated = frame.verb.negated or previous.verb.lemma in _FAILING

    def _participle(self, s: State, frame: Frame, previous: Frame) -> None:
        v = frame.verb
        if previous.verb.sense == "cause" and previous.object is not None and not s.boundary:
            frame.subject, frame.link, frame.causer = previous.object, "cause", previous
        elif v.sense in ("weigh", "measure", "have", "contain") and s.last is not None:
            frame.subject, frame.reduced, frame.parent = s.last, True, previous
        elif v.sense in CAUSE_SENSES or v.extra.get("transitive"):
            frame.subject = self._agent(previous)
            frame.link = "cause"
            frame.causer = previous
        elif s.boundary or s.last is None or s.last is previous.subject:
            frame.subject = self._agent(previous)
            frame.link = (
                "then" if v.sense in ("hit", "stop", "topple", "enter", "land", "miss") else "while"
            )
            frame.parent = previous
        else:
            frame.subject, frame.reduced = s.last, True
            frame.link = "while"
            frame.parent = previous

    def _finish(self, s: State, frame: Frame) -> None:
        if s.sub:
            frame.link = f"sub:{s.sub}"
            frame.subordinate = s.sub
            s.sub = ""
        for item in s.loose:
            if isinstance(item, Phrase):
                late = item.amount is not None and item.amount.dimension == "time"
                if late and frame.subordinate == "after" and not item.prep:
                    item.prep = _UNTIL_MAIN  # "half a second after being kicked, the ball ..."
                frame.phrases.append(item)
            elif isinstance(item, str):
                frame.adverbs.append(item)
        s.loose = []
        self.frames.append(frame)
        if frame.reduced and s.frame is None:
            # the main verb is still to come; collect arguments for the participle meanwhile
            frame.parent = None
        s.frame = frame
        if s.main is None or not frame.reduced:
            s.main = frame
        s.boundary, s.boundary_kind = False, ""
        s.prep = ""

    def _flush(self, s: State) -> None:
        for item in s.loose:
            if isinstance(item, Phrase) and item.amount is not None and s.frame is not None:
                s.frame.phrases.append(item)
        s.loose = []


_TAKING = frozenset({"need", "needs", "needed", "take", "takes", "took", "require", "requires"})
_UNTIL_MAIN = "until main clause"
_FAILING = frozenset({"fail", "fails", "failed", "refuse", "refuses", "refused", "failing"})
_PROPERTIES = frozenset(
    {"mass", "weight", "height", "length", "width", "diameter", "radius", "size"}
)
_OWNED = _PROPERTIES | {"speed", "velocity"}
_SIZES = frozenset({"tall", "high", "wide", "long", "thick", "deep", "diameter", "in diameter"})
