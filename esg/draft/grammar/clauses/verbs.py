"""Verbs of a clause: a frame each, with its subject and its link to the frames before."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.captions import DOERS, done_by_somebody
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
    resulting,
    serial,
    whose,
)
from esg.draft.grammar.clauses.nouns import runs_on
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.text.elements import PARTING, Mention, Verb, Word, element_at
from esg.draft.text.quantities import Amount

_LETTING = lex.word_set("letting (verbs)")
UNTIL_MAIN = "until main clause"


_SCENE = lex.word_set("scene")
_AIMING = lex.word_set("aiming")
_BY_ITSELF = frozenset({"posture", "park", "stop", "fall", "topple", "roll", "slide"})
_BY_ITSELF_OR_HIT = frozenset({"posture", "park", "stop", "hit", "topple", "fall"})
_SENDING = frozenset({"drop", "launch", "roll", "slide", "carry", "pick"})
"""Senses of which a command says what hands do: "lift the cube and drop it"."""
_DONE_BY_HAND = lex.word_set("done by hand")
_HANDLING = frozenset({"posture", "pick", "carry", "noop"})
_STATES = frozenset({"be", "posture", "park", "weigh", "measure", "have", "contain"})


def verb(c: Clauses, s: State, v: Verb, i: int) -> None:
    """Opens a frame for a verb, with its subject and its link to the frames before."""
    before = element_at(c.elements, i - 1)
    after_prep = before.low if isinstance(before, Word) and before.kind == "prep" else ""
    if v.form == "ing" and after_prep in ("of", "for") and s.frame is not None:
        s.frame.adverbs.append(v.lemma)  # "after 6 seconds of braking"
        c.nominal.append(v)
        s.prep = ""
        return
    v.negated = v.negated or after_prep == "without"
    if s.frame is None and not s.sub and "perfect" in v.extra:
        s.sub = "after"  # "Having hit it, it stops"
    frame = Frame(v, sentence=c.sentence, link=s.link)
    frame.start_of_sentence = not any(g.sentence == c.sentence for g in c.frames[-1:])
    s.link = "then"
    opening = _Opening(frame, s.frame, i, after_prep)
    for link in LINKS:
        if link(c, s, opening):
            break
    _finish(c, s, frame)


@dataclass(frozen=True)
class _Opening:
    """A frame that is being opened.

    Args:
        frame: The new frame.
        previous: The frame before it, in the same sentence.
        at: Its place among the elements.
        after_prep: The preposition in front of its verb.
    """

    frame: Frame
    previous: Frame | None
    at: int
    after_prep: str


def _relative(c: Clauses, s: State, o: _Opening) -> bool:
    """ "the box that the ball hits", "a bus whose mass is 12 tons", "a car that turns"."""
    frame = o.frame
    if s.boundary_kind == "objrel":
        frame.subject = s.subject
        if s.relative_prep:
            frame.phrases.append(Phrase(s.relative_prep, s.relative))
            s.relative_prep = ""
        else:
            frame.object = s.relative
        frame.reduced, frame.opening, s.boundary_kind = True, o.previous is None, ""
    elif s.boundary_kind == "own":
        frame.subject, s.boundary_kind = s.subject, ""
        frame.reduced, frame.parent, frame.opening = True, o.previous, o.previous is None
    elif s.boundary and s.boundary_kind == "rel":
        frame.subject, frame.parent = s.relative, o.previous
        frame.reduced = frame.relative = True
        frame.resulting = goes_on(c, o.at)
        if frame.resulting:
            frame.subject = resulting(c, s, frame, o.previous)
    else:
        return False
    return True


def _gerund(c: Clauses, s: State, o: _Opening) -> bool:
    """ "makes it fall by hitting it", "without touching it"."""
    previous, v = o.previous, o.frame.verb
    if v.form != "ing" or o.after_prep not in ("without", "by", "from") or previous is None:
        return False
    if o.after_prep == "by" and v.sense in ("hit", "knock"):
        s.sub = s.sub or "after"
        while previous.causer is not None:
            previous = previous.causer
    o.frame.subject, o.frame.parent, o.frame.link = agent(c, previous), previous, "then"
    return True


def _infinitive(c: Clauses, s: State, o: _Opening) -> bool:
    if not o.frame.verb.infinitive or o.previous is None:
        return False
    infinitive(c, s, o.frame, o.previous)
    return True


def _agent_told(c: Clauses, s: State, o: _Opening) -> bool:
    return "agent" in o.frame.verb.extra and by_agent(s, o.frame, o.previous)


def _first(c: Clauses, s: State, o: _Opening) -> bool:
    """The first verb of its sentence."""
    if o.previous is not None:
        return False
    frame, v, i = o.frame, o.frame.verb, o.at
    frame.subject = s.subject
    if s.subject is None:
        kinds = [getattr(e, "kind", "") for e in c.elements[max(0, i - 2) : i]]
        opens = i == 0 or kinds[-1] == "punct" or kinds == ["punct", "conj"]
        if not s.sub and opens and _telegraphic(c, v):
            frame.subject = _subject_before(c) if s.main is None else agent(c, s.main)
        if s.boundary and s.main is not None and v.form == "pp":
            frame.subject = None
    elif _modifies(c, v, i):
        # "a ball thrown at the wall bounces", "a car parked by the road is hit"
        frame.reduced = frame.opening = True
        v.passive = v.passive or (v.form != "ing" and v.sense not in _BY_ITSELF)
    elif _headline(c, s.subject, v, i):
        v.passive = True
    elif done_by_somebody(c, s.subject, v, i):
        v.passive, v.auxiliary = True, "is"
    elif v.form == "pp" and not v.auxiliary and not v.passive:
        v.passive = v.sense in ("launch", "drop", "pass", "posture")
    return True


def _headline(c: Clauses, m: Mention, v: Verb, i: int) -> bool:
    """ "Drawer pulled out, spoon dropped in": what is done to things without an article."""
    things = m.noun is not None and m.noun.kind not in DOERS and not m.attribute
    bare = not (m.determiner or m.pronoun or m.coordinated or m.count or m.letters)
    handled = v.sense in _SENDING | {"own", "posture", "tow"} and v.lemma in _DONE_BY_HAND
    return bare and things and handled and v.form in ("past", "pp") and not _acts_on(c, i)


def _modifies(c: Clauses, v: Verb, i: int) -> bool:
    """Whether a participle after the subject comes before the main verb."""
    if v.form not in ("pp", "past", "ing") or v.auxiliary or v.lemma == "let":
        return False
    if v.form != "ing" and _acts_on(c, i):
        return False
    return _main_verb_follows(c, i) or _parenthetical(c, i)


def _subordinate(c: Clauses, s: State, o: _Opening) -> bool:
    """ "while rolling", "after hitting": shares the main subject."""
    previous, v = o.previous, o.frame.verb
    if not s.sub or previous is None:
        return False
    own = s.subject is not None and not s.boundary
    o.frame.subject = s.subject if own else agent(c, previous)
    if v.form == "ing" and not v.auxiliary and previous.relative and runs_on(c, o.at):
        o.frame.subject = previous.subject  # "that wobbles before tumbling down"
    return True


def _participle(c: Clauses, s: State, o: _Opening) -> bool:
    if o.frame.verb.form != "ing" or o.frame.verb.auxiliary or o.previous is None:
        return False
    participle(c, s, o.frame, o.previous)
    return True


def _caused(c: Clauses, s: State, o: _Opening) -> bool:
    """ "makes a jar fall", "makes a jar that lies on it roll off"."""
    previous, v = o.previous, o.frame.verb
    assert previous is not None
    causer = previous
    if caused_after_relative(previous, v, s):
        assert previous.parent is not None
        causer = previous.parent
    elif s.boundary or previous.object is None or previous.verb.sense not in ("cause", "noop"):
        return False
    else:
        made = s.last_after_prep and v.form == "base" and previous.verb.lemma == "make"
        bare = v.form in ("base", "pp") or (v.form == "past" and v.lemma in UNCHANGED)
        if not bare or not (s.last is previous.object or made):
            return False
    o.frame.subject, o.frame.causer, o.frame.link = causer.object, causer, "cause"
    return True


def _main_at_last(c: Clauses, s: State, o: _Opening) -> bool:
    """ "the tray he carries falls", "Darts thrown by a man hit the board"."""
    previous, v = o.previous, o.frame.verb
    assert previous is not None
    awaited = awaits_main(previous, v)
    if awaited and (previous.object is s.relative is not None or whose(previous, s)):
        o.frame.subject = s.relative
    elif awaited or serial(previous, v, s):
        o.frame.subject = agent(c, previous)
    else:
        return False
    o.frame.parent = previous
    return True


def _reduced(c: Clauses, s: State, o: _Opening) -> bool:
    """ "a bicycle stopped in the road": a relative clause on the last noun."""
    previous, v = o.previous, o.frame.verb
    assert previous is not None
    if s.boundary or s.last is None or v.form not in ("pp", "past") or v.auxiliary:
        return False
    if main_at_last(c, previous, v, o.at):
        return False
    o.frame.subject, o.frame.reduced, o.frame.parent = s.last, True, previous
    v.passive = v.passive or v.sense not in _BY_ITSELF_OR_HIT
    return True


def _relative_goes_on(c: Clauses, s: State, o: _Opening) -> bool:
    """ ", which rolls away and hits C"."""
    previous, v = o.previous, o.frame.verb
    assert previous is not None
    joined = s.boundary_kind == "conj" and not _after_comma(c, o.at)
    listed = s.boundary_kind == "comma" and _listed(c, previous, o.at)
    if not previous.relative or not (joined or listed) or v.form == "ing":
        return False
    if previous.verb.sense in _STATES or of_a_vehicle(previous, v):
        return False
    done = previous.verb.auxiliary in ("has", "have", "had") and not v.auxiliary
    if done and v.form in ("s", "base"):
        return False  # "passes a man who has fallen and stops beside him"
    o.frame.subject, o.frame.relative, o.frame.reduced = previous.subject, True, True
    o.frame.parent = previous.parent
    return True


def _goes_on(c: Clauses, s: State, o: _Opening) -> bool:
    """One more verb of the same subject."""
    previous, v = o.previous, o.frame.verb
    assert previous is not None
    o.frame.parent = previous
    if previous.verb.passive and v.lemma == "let" and not _acts_on(c, o.at):
        v.passive = True  # "is held over a box and let go"
    handed = v.lemma in _HANDED and v.form in ("past", "pp") and not v.auxiliary
    if previous.verb.passive and handed and not _acts_on(c, o.at):
        v.passive = True  # "is lifted, carried over a wall and set down"
    told = v.lemma in _LETTING or (
        v.sense in _HANDLING and (v.form == "base" or v.lemma in UNCHANGED)
    )
    told = told or (v.sense in _SENDING and v.form == "base" and _acts_on(c, o.at))
    if told and v.form != "ing" and not v.passive and previous.subject is None:
        return True  # "Push the ball and let it roll", "open the box and put a ball in it"
    before = before_what_it_waits_for(c, before_what_it_lets(previous, v), s, v)
    o.frame.subject = agent(c, before)
    return True


_HANDED = frozenset({"carry", "lay", "lift", "lower", "place", "put", "raise", "set"})
"""What hands do to a thing, and no thing does by itself."""
LINKS: tuple[Callable[[Clauses, State, _Opening], bool], ...] = (
    _relative,
    _gerund,
    _infinitive,
    _agent_told,
    _first,
    _subordinate,
    _participle,
    _caused,
    _main_at_last,
    _reduced,
    _relative_goes_on,
    _goes_on,
)
"""How a verb is linked to what was told before; the first that fits gives it its subject."""


def _acts_on(c: Clauses, i: int) -> bool:
    """Whether a thing follows directly, which no passive participle has ("struck the pane")."""
    nxt = element_at(c.elements, i + 1)
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
    before = element_at(c.elements, i - 1)
    if not (isinstance(before, Word) and before.low == ","):
        return False
    for k in range(i + 1, len(c.elements)):
        e = c.elements[k]
        if isinstance(e, Verb):
            return False
        if isinstance(e, Word) and e.kind in PARTING:
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
    awaits = frame.relative and s.frame is None  # "until a ball that rolls in hits it"
    if s.sub and not awaits:
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
