"""Verbs of a clause: a frame each, with its subject and its link to the frames before."""

from __future__ import annotations

from esg.draft.clause_nouns import ClauseNouns
from esg.draft.elements import Mention, Verb, Word
from esg.draft.frames import Frame, Phrase, State
from esg.draft.quantities import Amount

CAUSE_SENSES = frozenset({"cause", "knock", "launch", "drop", "lead", "give", "pocket", "scatter"})
_LETTING = frozenset({"let", "make", "have", "watch"})
UNTIL_MAIN = "until main clause"
_UNCHANGED = frozenset({"hit", "let", "put", "set", "cut", "burst", "upset"})
"""Verbs whose past is spelled like the infinitive."""
_AMONG_VEHICLES = frozenset({"rear-end", "t-bone", "sideswipe"})
_ASKING = frozenset({"want", "like", "need", "wish", "ask", "tell", "order", "allow", "expect"})
_SHOWING = frozenset({"show", "see", "depict", "capture", "film", "picture", "feature", "watch"})
_FAILING = frozenset({"fail", "fails", "failed", "refuse", "refuses", "refused", "failing"})


_SCENE = frozenset({"at", "in", "on", "inside"})
_AIMING = frozenset(
    {"hit", "launch", "fall", "topple", "drop", "knock", "own", "roll", "slide", "fly", "bounce",
     "pocket", "jump", "overtake", "reach", "miss", "scatter", "leap", "tow"}
)  # fmt: skip
"""Senses that take "at", "in" or "on" for what they end at."""


class ClauseVerbs(ClauseNouns):
    """Opens a frame for every verb."""

    def _verb(self, s: State, v: Verb, i: int) -> None:
        before = self.elements[i - 1] if i else None
        after_prep = before.low if isinstance(before, Word) and before.kind == "prep" else ""
        if v.form == "ing" and after_prep in ("of", "for") and s.frame is not None:
            s.frame.adverbs.append(v.lemma)  # "after 6 seconds of braking"
            self.nominal.append(v)
            s.prep = ""
            return
        v.negated = v.negated or after_prep == "without"
        if "perfect" in v.extra and s.frame is None and not s.sub:
            s.sub = "after"  # "Having hit it, it stops"
        if after_prep in ("after", "before") and s.frame is None and not s.sub:
            s.sub, s.prep = after_prep, ""  # "after being kicked"
        frame = Frame(v, sentence=self.sentence, link=s.link)
        frame.start_of_sentence = not any(g.sentence == self.sentence for g in self.frames[-1:])
        previous = s.frame
        s.link = "then"
        if s.boundary_kind == "objrel":
            frame.subject = s.subject
            if s.relative_prep:
                frame.phrases.append(Phrase(s.relative_prep, s.relative))
                s.relative_prep = ""
            else:
                frame.object = s.relative
            s.boundary_kind = ""
            frame.reduced = True
            frame.opening = previous is None
        elif s.boundary_kind == "own":
            frame.subject, s.boundary_kind = s.subject, ""  # "hits a bus whose mass is 12 tons"
            frame.reduced, frame.parent, frame.opening = True, previous, previous is None
        elif s.boundary and s.boundary_kind == "rel":
            frame.subject = s.relative
            frame.reduced = frame.relative = True
            frame.parent = previous
            frame.resulting = self._goes_on(i)
        elif v.form == "ing" and after_prep in ("without", "by", "from") and previous is not None:
            if after_prep == "by" and v.sense in ("hit", "knock"):
                s.sub = s.sub or "after"  # "makes it fall by hitting it"
                while previous.causer is not None:
                    previous = previous.causer
            frame.subject, frame.parent = self._agent(previous), previous
            frame.link = "then"
        elif v.infinitive and previous is not None:
            self._infinitive(s, frame, previous)
        elif "agent" in v.extra and self._by_agent(s, frame, previous):
            pass
        elif previous is None:
            self._first(s, frame, i)
        elif s.sub:
            # "while rolling", "after hitting": shares the main subject
            frame.subject = (
                s.subject if s.subject is not None and not s.boundary else self._agent(previous)
            )
            if v.form == "ing" and not v.auxiliary and previous.relative and self._runs_on(i):
                frame.subject = previous.subject  # "that wobbles before tumbling down"
        elif v.form == "ing" and not v.auxiliary:
            self._participle(s, frame, previous)
        elif (
            not s.boundary
            and previous.object is not None
            and (
                s.last is previous.object
                or (s.last_after_prep and v.form == "base" and previous.verb.lemma == "make")
            )
            and (v.form in ("base", "pp") or (v.form == "past" and v.lemma in _UNCHANGED))
            and previous.verb.sense in ("cause", "noop")
        ):
            frame.subject = previous.object
            frame.causer = previous
            frame.link = "cause"
        elif self._caused_after_relative(previous, v, s):
            causer = previous.parent
            assert causer is not None
            frame.subject, frame.causer, frame.link = causer.object, causer, "cause"
        elif self._awaits_main(previous, v) and (
            previous.object is s.relative is not None or self._whose(previous, s)
        ):
            frame.subject, frame.parent = s.relative, previous  # "the tray he carries falls"
        elif self._awaits_main(previous, v) or self._serial(previous, v, s):
            frame.subject = self._agent(previous)
            frame.parent = previous
        elif (
            not s.boundary
            and v.form in ("pp", "past")
            and not v.auxiliary
            and s.last is not None
            and not self._main_at_last(previous, v, i)
        ):
            # reduced relative on the last noun: "a bicycle stopped in the road"
            frame.subject, frame.reduced, frame.parent = s.last, True, previous
            if v.sense not in ("posture", "park", "stop", "hit", "topple", "fall"):
                v.passive = True
        elif (
            previous.relative
            and (
                (s.boundary_kind == "conj" and not self._after_comma(i))
                or (s.boundary_kind == "comma" and self._listed(previous, i))
            )
            and v.form != "ing"
            and previous.verb.sense
            not in ("be", "posture", "park", "weigh", "measure", "have", "contain")
            and not self._of_a_vehicle(previous, v)
        ):
            # ", which rolls away and hits C": the relative clause goes on
            frame.subject, frame.relative, frame.reduced = previous.subject, True, True
            frame.parent = previous.parent
        elif v.lemma in _LETTING and v.form != "ing" and previous.subject is None:
            frame.parent = previous  # "Push the ball and let it roll": still the reader's doing
        else:
            before = self._before_what_it_waits_for(self._before_what_it_lets(previous, v), s, v)
            frame.subject = self._agent(before)
            frame.parent = previous
        self._finish(s, frame)

    @staticmethod
    def _of_a_vehicle(previous: Frame, v: Verb) -> bool:
        """ "brakes for a duck that crosses the road and is rear-ended": not the duck."""
        who = previous.subject.noun if previous.subject is not None else None
        beast = who is not None and who.kind in ("animal", "person")
        return beast and v.passive and v.lemma in _AMONG_VEHICLES

    @staticmethod
    def _by_agent(s: State, frame: Frame, previous: Frame | None) -> bool:
        """ "the scooter, bumped by a taxi and then bumped by a van, falls": one subject."""
        if previous is None:
            frame.subject = s.subject
            frame.reduced = frame.opening = s.subject is not None
            return s.subject is not None
        if "agent" not in previous.verb.extra or not previous.reduced:
            return False
        frame.subject, frame.reduced, frame.opening = previous.subject, True, previous.opening
        frame.parent = previous.parent
        return True

    def _goes_on(self, i: int) -> bool:
        """Whether a relative clause tells what happens next: after a comma, or in the present."""
        rel = next(
            (k for k in range(i - 1, -1, -1) if getattr(self.elements[k], "kind", "") == "rel"), 0
        )
        comma = getattr(self.elements[rel - 1], "low", "") == "," if rel else False
        verb = self.elements[i]
        now = isinstance(verb, Verb) and verb.auxiliary in ("is", "are", "gets", "get")
        return comma or now

    @staticmethod
    def _before_what_it_lets(previous: Frame, v: Verb) -> Frame:
        """ "stops to let a woman cross, then drives on": who stopped drives on."""
        while (
            previous.causer is not None
            and previous.verb.form == "base"
            and not previous.verb.infinitive
            and v.form in ("s", "past")
        ):
            previous = previous.causer
        return previous

    def _before_what_it_waits_for(self, previous: Frame, s: State, v: Verb) -> Frame:
        """ "waits until the tram has passed and follows it": who waits follows it."""
        perfect = previous.verb.auxiliary in ("has", "have", "had") and not v.auxiliary
        if not (perfect and previous.subordinate and s.boundary and v.form in ("s", "past")):
            return previous
        mine = [g for g in self.frames if g.sentence == previous.sentence and not g.reduced]
        mains = [g for g in mine if not g.subordinate and g.verb.start < previous.verb.start]
        return mains[-1] if mains and mains[-1].verb.form == v.form else previous

    @staticmethod
    def _caused_after_relative(previous: Frame, v: Verb, s: State) -> bool:
        """ "makes a jar that lies on it roll off": what the main verb causes."""
        cause = previous.parent
        if not previous.relative or cause is None or cause.verb.sense != "cause" or s.boundary:
            return False
        return v.form == "base" and cause.object is not None and not v.auxiliary

    def _main_at_last(self, previous: Frame, v: Verb, i: int) -> bool:
        """ "A stool that was bumped fell over", "a glass that was on it hit a guest"."""
        if v.form != "past" or v.passive:
            return False
        if not previous.relative or previous.parent is not None:
            return False
        return not any(getattr(e, "low", "") == "by" for e in self.elements[i + 1 : i + 2])

    @staticmethod
    def _awaits_main(previous: Frame, v: Verb) -> bool:
        """ "Darts thrown by a man hit the board": the participle's subject has no verb yet."""
        if not previous.reduced or previous.parent is not None or v.form == "ing":
            return False
        return previous.opening and v.sense not in ("posture", "park", "contain")

    @staticmethod
    def _whose(previous: Frame, s: State) -> bool:
        """ "A car whose wheel came off hits a wall": the car does."""
        m = s.relative
        return m is not None and previous.subject is not None and m.end <= previous.subject.start

    @staticmethod
    def _serial(previous: Frame, v: Verb, s: State) -> bool:
        """ "marble go down ramp hit cup": bare verbs in a row have one subject."""
        bare = previous.verb.form == "base" and not previous.verb.infinitive
        if not bare or previous.verb.auxiliary or previous.subject is None or s.boundary:
            return False
        if previous.subject.plural or previous.subject.coordinated or previous.subject.pronoun:
            return False
        return v.form in ("past", "base") and v.lemma in _UNCHANGED

    def _agent(self, frame: Frame) -> Mention | None:
        """Who carries on after this frame: the subject; the thing thrown for an imperative."""
        shown = frame.parent is not None and frame.parent.verb.lemma in _SHOWING
        if frame.reduced and frame.parent is not None and not shown:
            return self._agent(frame.parent)
        if frame.subject is None:
            return frame.object
        return frame.subject

    def _who_went_on(self, previous: Frame) -> Mention | None:
        """ ", which runs into a trough, upsetting it": what the relative clause is about."""
        told = [g for g in self.frames if g.subject is previous.subject and g.relative]
        going = previous.relative and any(
            g.resulting and g.sentence == previous.sentence for g in told
        )
        if going and previous.verb.sense not in ("be", "posture", "park", "have", "noop"):
            return previous.subject
        return self._agent(previous)

    def _first(self, s: State, frame: Frame, i: int) -> None:
        v = frame.verb
        frame.subject = s.subject
        kinds = [getattr(e, "kind", "") for e in self.elements[max(0, i - 2) : i]]
        opens = i == 0 or kinds[-1] == "punct" or kinds == ["punct", "conj"]
        if s.subject is not None or s.sub or not opens or not self._telegraphic(v):
            pass
        elif s.main is None:
            frame.subject = self._subject_before()
        else:
            frame.subject = self._agent(s.main)
        if s.subject is None and s.boundary and s.main is not None and v.form in ("pp",):
            frame.subject = None
        if (
            s.subject is not None
            and v.form in ("pp", "past", "ing")
            and not v.auxiliary
            and v.lemma != "let"
            and (v.form == "ing" or not self._acts_on(i))
            and (self._main_verb_follows(i) or self._parenthetical(i))
        ):
            # "a ball thrown at the wall bounces", "a car parked by the road is hit"
            frame.reduced = frame.opening = True
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

    def _acts_on(self, i: int) -> bool:
        """Whether a thing follows directly, which no passive participle has ("struck the pane")."""
        nxt = self.elements[i + 1] if i + 1 < len(self.elements) else None
        return isinstance(nxt, Mention) and not nxt.attribute

    def _telegraphic(self, v: Verb) -> bool:
        """ "Brakes at 3 s.": a finite verb without a subject at the start of a sentence."""
        gets = v.passive and v.auxiliary in ("gets", "is")  # "Gets shoved at 1 m/s."
        active = v.form == "s" and not v.auxiliary
        return (active or gets) and not v.infinitive and v.sense != "be"

    def _subject_before(self) -> Mention | None:
        """What a verbless sentence in front named ("Truck, 9 m/s. Brakes.")."""
        named = [m for m in self.mentions if not m.attribute and not m.pronoun]
        return named[-1] if named and not self.frames else None

    def _listed(self, previous: Frame, i: int) -> bool:
        """ ", which brakes, skids and rams it": a list of verbs of one relative clause."""
        if previous.parent is None or not (self.elements[i - 1 : i] or [None])[0]:
            return False
        if getattr(self.elements[i - 1], "low", "") != ",":
            return False
        for e in self.elements[i + 1 :]:
            if isinstance(e, Word) and e.kind == "conj" and e.low == "and":
                return True
            if isinstance(e, Verb) or (isinstance(e, Word) and e.low in ".;,"):
                return False
        return False

    def _after_comma(self, i: int) -> bool:
        """ "..., which lands on a drum, and falls": back to the main clause."""
        conj, comma = self.elements[i - 1 : i] or [None], self.elements[i - 2 : i - 1] or [None]
        return getattr(conj[0], "kind", "") == "conj" and getattr(comma[0], "low", "") == ","

    def _parenthetical(self, i: int) -> bool:
        """ "the puck, sliding at 5 m/s, hits": a participle between commas."""
        before = self.elements[i - 1] if i else None
        if not (isinstance(before, Word) and before.low == ","):
            return False
        for k in range(i + 1, len(self.elements)):
            e = self.elements[k]
            if isinstance(e, Verb):
                return False
            if isinstance(e, Word) and e.kind in ("punct", "conj", "sub", "rel"):
                rest = [x for x in self.elements[k + 1 : k + 3] if getattr(x, "kind", "") != "adv"]
                nxt = rest[0] if rest else None
                finite = isinstance(nxt, Verb) and not nxt.infinitive and nxt.form != "ing"
                return e.low == "," and finite
        return False

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
        whom = s.last if s.last is not None and s.last.after_prep == "for" else None
        if previous.verb.sense in CAUSE_SENSES | {"hit"} and (whom or previous.object):
            frame.subject = whom or previous.object  # "hits it hard enough for it to fall"
            frame.causer = previous
            frame.link = "cause"
        elif previous.verb.sense in CAUSE_SENSES and previous.verb.passive:
            frame.subject = previous.subject
            frame.causer = previous
        else:
            frame.subject = self._agent(previous)
            if previous.verb.lemma in _ASKING and previous.object is not None:
                frame.subject = previous.object  # "I want a ball to hit a box"
            it = previous.subject is not None and previous.subject.pronoun == "it"
            if it and previous.verb.lemma == "take" and previous.object is not None:
                frame.subject = previous.object  # "it takes the tram 6 s to stop"
            if it and previous.verb.lemma == "take" and (whom := previous.phrase("for")):
                frame.subject = whom.mention  # "it takes 2 s for a tram to stop"
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
            frame.subject = self._who_went_on(previous)
            frame.link = "cause"
            frame.causer = previous
        elif s.boundary or s.last is None or s.last is previous.subject:
            frame.subject = self._who_went_on(previous)
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
        waiting: list[Phrase | Amount | str] = []
        for item in s.loose:
            if isinstance(item, Phrase):
                timed = item.amount is not None and item.amount.dimension == "time"
                if timed and frame.opening and not frame.subordinate:
                    waiting.append(item)  # "Two seconds later the puck, sliding, hits ..."
                    continue
                late = item.amount is not None and item.amount.dimension == "time"
                if late and frame.subordinate == "after" and not item.prep:
                    item.prep = UNTIL_MAIN  # "half a second after being kicked, the ball ..."
                if self._sets_the_scene(frame, item):
                    assert frame.subject is not None
                    self.attachments.append((frame.subject, item))
                    continue
                frame.phrases.append(item)
            elif isinstance(item, str):
                frame.adverbs.append(item)
        s.loose = waiting
        self.frames.append(frame)
        if frame.reduced and s.frame is None:
            # the main verb is still to come; collect arguments for the participle meanwhile
            frame.parent = None
        s.frame = frame
        if s.main is None or not frame.reduced:
            s.main = frame
        s.boundary, s.boundary_kind = False, ""
        s.prep = ""

    @staticmethod
    def _sets_the_scene(frame: Frame, p: Phrase) -> bool:
        """ "At the market, a cat pounces on a ball": where it is, not what the verb aims at."""
        m, subject = p.mention, frame.subject
        if m is None or subject is None or m.attribute or m.pronoun or subject.pronoun:
            return False
        before = m.end <= subject.start < frame.verb.start
        return before and p.prep in _SCENE and frame.verb.sense in _AIMING
