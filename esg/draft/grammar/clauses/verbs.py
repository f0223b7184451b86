"""Verbs of a clause: a frame each, with its subject and its link to the frames before."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame, Phrase, State
from esg.draft.grammar.clauses.links import (
    UNCHANGED,
    agent,
    awaits_main,
    before_what_it_lets,
    before_what_it_waits_for,
    by_agent,
    caused_after_relative,
    goes_on,
    infinitive,
    main_at_last,
    of_a_vehicle,
    participle,
    serial,
    whose,
)
from esg.draft.grammar.clauses.nouns import runs_on
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.text.elements import Mention, Verb, Word
from esg.draft.text.quantities import Amount

_LETTING = lex.word_set("letting (verbs)")
UNTIL_MAIN = "until main clause"


_SCENE = lex.word_set("scene")
_AIMING = lex.word_set("aiming")


def verb(c: Clauses, s: State, v: Verb, i: int) -> None:
    before = c.elements[i - 1] if i else None
    after_prep = before.low if isinstance(before, Word) and before.kind == "prep" else ""
    if v.form == "ing" and after_prep in ("of", "for") and s.frame is not None:
        s.frame.adverbs.append(v.lemma)  # "after 6 seconds of braking"
        c.nominal.append(v)
        s.prep = ""
        return
    v.negated = v.negated or after_prep == "without"
    if "perfect" in v.extra and s.frame is None and not s.sub:
        s.sub = "after"  # "Having hit it, it stops"
    if after_prep in ("after", "before") and s.frame is None and not s.sub:
        s.sub, s.prep = after_prep, ""  # "after being kicked"
    frame = Frame(v, sentence=c.sentence, link=s.link)
    frame.start_of_sentence = not any(g.sentence == c.sentence for g in c.frames[-1:])
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
        frame.resulting = goes_on(c, i)
    elif v.form == "ing" and after_prep in ("without", "by", "from") and previous is not None:
        if after_prep == "by" and v.sense in ("hit", "knock"):
            s.sub = s.sub or "after"  # "makes it fall by hitting it"
            while previous.causer is not None:
                previous = previous.causer
        frame.subject, frame.parent = agent(c, previous), previous
        frame.link = "then"
    elif v.infinitive and previous is not None:
        infinitive(c, s, frame, previous)
    elif "agent" in v.extra and by_agent(s, frame, previous):
        pass
    elif previous is None:
        _first(c, s, frame, i)
    elif s.sub:
        # "while rolling", "after hitting": shares the main subject
        frame.subject = (
            s.subject if s.subject is not None and not s.boundary else agent(c, previous)
        )
        if v.form == "ing" and not v.auxiliary and previous.relative and runs_on(c, i):
            frame.subject = previous.subject  # "that wobbles before tumbling down"
    elif v.form == "ing" and not v.auxiliary:
        participle(c, s, frame, previous)
    elif (
        not s.boundary
        and previous.object is not None
        and (
            s.last is previous.object
            or (s.last_after_prep and v.form == "base" and previous.verb.lemma == "make")
        )
        and (v.form in ("base", "pp") or (v.form == "past" and v.lemma in UNCHANGED))
        and previous.verb.sense in ("cause", "noop")
    ):
        frame.subject = previous.object
        frame.causer = previous
        frame.link = "cause"
    elif caused_after_relative(previous, v, s):
        causer = previous.parent
        assert causer is not None
        frame.subject, frame.causer, frame.link = causer.object, causer, "cause"
    elif awaits_main(previous, v) and (
        previous.object is s.relative is not None or whose(previous, s)
    ):
        frame.subject, frame.parent = s.relative, previous  # "the tray he carries falls"
    elif awaits_main(previous, v) or serial(previous, v, s):
        frame.subject = agent(c, previous)
        frame.parent = previous
    elif (
        not s.boundary
        and v.form in ("pp", "past")
        and not v.auxiliary
        and s.last is not None
        and not main_at_last(c, previous, v, i)
    ):
        # reduced relative on the last noun: "a bicycle stopped in the road"
        frame.subject, frame.reduced, frame.parent = s.last, True, previous
        if v.sense not in ("posture", "park", "stop", "hit", "topple", "fall"):
            v.passive = True
    elif (
        previous.relative
        and (
            (s.boundary_kind == "conj" and not _after_comma(c, i))
            or (s.boundary_kind == "comma" and _listed(c, previous, i))
        )
        and v.form != "ing"
        and previous.verb.sense
        not in ("be", "posture", "park", "weigh", "measure", "have", "contain")
        and not of_a_vehicle(previous, v)
    ):
        # ", which rolls away and hits C": the relative clause goes on
        frame.subject, frame.relative, frame.reduced = previous.subject, True, True
        frame.parent = previous.parent
    elif v.lemma in _LETTING and v.form != "ing" and previous.subject is None:
        frame.parent = previous  # "Push the ball and let it roll": still the reader's doing
    else:
        before = before_what_it_waits_for(c, before_what_it_lets(previous, v), s, v)
        frame.subject = agent(c, before)
        frame.parent = previous
    _finish(c, s, frame)


def _first(c: Clauses, s: State, frame: Frame, i: int) -> None:
    v = frame.verb
    frame.subject = s.subject
    kinds = [getattr(e, "kind", "") for e in c.elements[max(0, i - 2) : i]]
    opens = i == 0 or kinds[-1] == "punct" or kinds == ["punct", "conj"]
    if s.subject is not None or s.sub or not opens or not _telegraphic(c, v):
        pass
    elif s.main is None:
        frame.subject = _subject_before(c)
    else:
        frame.subject = agent(c, s.main)
    if s.subject is None and s.boundary and s.main is not None and v.form in ("pp",):
        frame.subject = None
    if (
        s.subject is not None
        and v.form in ("pp", "past", "ing")
        and not v.auxiliary
        and v.lemma != "let"
        and (v.form == "ing" or not _acts_on(c, i))
        and (_main_verb_follows(c, i) or _parenthetical(c, i))
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


def _acts_on(c: Clauses, i: int) -> bool:
    """Whether a thing follows directly, which no passive participle has ("struck the pane")."""
    nxt = c.elements[i + 1] if i + 1 < len(c.elements) else None
    return isinstance(nxt, Mention) and not nxt.attribute


def _telegraphic(c: Clauses, v: Verb) -> bool:
    """ "Brakes at 3 s.": a finite verb without a subject at the start of a sentence."""
    gets = v.passive and v.auxiliary in ("gets", "is")  # "Gets shoved at 1 m/s."
    active = v.form == "s" and not v.auxiliary
    return (active or gets) and not v.infinitive and v.sense != "be"


def _subject_before(c: Clauses) -> Mention | None:
    """What a verbless sentence in front named ("Truck, 9 m/s. Brakes.")."""
    named = [m for m in c.mentions if not m.attribute and not m.pronoun]
    return named[-1] if named and not c.frames else None


def _listed(c: Clauses, previous: Frame, i: int) -> bool:
    """ ", which brakes, skids and rams it": a list of verbs of one relative clause."""
    if previous.parent is None or not (c.elements[i - 1 : i] or [None])[0]:
        return False
    if getattr(c.elements[i - 1], "low", "") != ",":
        return False
    for e in c.elements[i + 1 :]:
        if isinstance(e, Word) and e.kind == "conj" and e.low == "and":
            return True
        if isinstance(e, Verb) or (isinstance(e, Word) and e.low in ".;,"):
            return False
    return False


def _after_comma(c: Clauses, i: int) -> bool:
    """ "..., which lands on a drum, and falls": back to the main clause."""
    conj, comma = c.elements[i - 1 : i] or [None], c.elements[i - 2 : i - 1] or [None]
    return getattr(conj[0], "kind", "") == "conj" and getattr(comma[0], "low", "") == ","


def _parenthetical(c: Clauses, i: int) -> bool:
    """ "the puck, sliding at 5 m/s, hits": a participle between commas."""
    before = c.elements[i - 1] if i else None
    if not (isinstance(before, Word) and before.low == ","):
        return False
    for k in range(i + 1, len(c.elements)):
        e = c.elements[k]
        if isinstance(e, Verb):
            return False
        if isinstance(e, Word) and e.kind in ("punct", "conj", "sub", "rel"):
            rest = [x for x in c.elements[k + 1 : k + 3] if getattr(x, "kind", "") != "adv"]
            nxt = rest[0] if rest else None
            finite = isinstance(nxt, Verb) and not nxt.infinitive and nxt.form != "ing"
            return e.low == "," and finite
    return False


def _main_verb_follows(c: Clauses, i: int) -> bool:
    for e in c.elements[i + 1 :]:
        if isinstance(e, Verb) and not e.infinitive and not (e.form == "ing" and not e.auxiliary):
            return True
        if isinstance(e, Word) and (
            (e.kind == "punct" and e.low in ".;:!?,")
            or e.kind in ("conj", "sub", "rel")
            or e.low == "then"
        ):
            return False
    return False


def _finish(c: Clauses, s: State, frame: Frame) -> None:
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
            if _sets_the_scene(frame, item):
                assert frame.subject is not None
                c.attachments.append((frame.subject, item))
                continue
            frame.phrases.append(item)
        elif isinstance(item, str):
            frame.adverbs.append(item)
    s.loose = waiting
    c.frames.append(frame)
    if frame.reduced and s.frame is None:
        # the main verb is still to come; collect arguments for the participle meanwhile
        frame.parent = None
    s.frame = frame
    if s.main is None or not frame.reduced:
        s.main = frame
    s.boundary, s.boundary_kind = False, ""
    s.prep = ""


def _sets_the_scene(frame: Frame, p: Phrase) -> bool:
    """ "At the market, a cat pounces on a ball": where it is, not what the verb aims at."""
    m, subject = p.mention, frame.subject
    if m is None or subject is None or m.attribute or m.pronoun or subject.pronoun:
        return False
    before = m.end <= subject.start < frame.verb.start
    return before and p.prep in _SCENE and frame.verb.sense in _AIMING
