"""Which clause a verb carries on: its subject is that of a clause before it, or its object."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame, State
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.text.elements import Mention, Verb

CAUSE_SENSES = lex.word_set("cause senses")
UNCHANGED = lex.word_set("unchanged")
_AMONG_VEHICLES = lex.word_set("among vehicles")
_ASKING = lex.word_set("asking (links)")
_SHOWING = lex.word_set("showing (links)")
_AWAITING = lex.word_set("awaiting (links)")
_FAILING = lex.word_set("failing")
_DOWN = frozenset({"topple", "fall"})
_LEAVING = _DOWN | {"own", "fly", "roll", "slide"}
_DRIVEN = lex.word_set("self powered")
_PLACES = frozenset(
    {"on", "at", "in", "near", "by", "beside", "against", "in front of", "next to", "behind"}
    | {"under", "on top of", "above", "outside"}
)
_FIRM = frozenset({"support", "fixed", "structural", "container"})
_BUILT = frozenset({"wall", "building", "street", "furniture", "vehicle"})
"""What rarely falls: what carries or holds things, and what is built."""
_LEFT_BY, _GOING = lex.word_set("left by"), lex.word_set("going (links)")


def of_a_vehicle(previous: Frame, v: Verb) -> bool:
    """ "brakes for a duck that crosses the road and is rear-ended": not the duck."""
    who = previous.subject.noun if previous.subject is not None else None
    beast = who is not None and who.kind in ("animal", "person")
    return beast and v.passive and v.lemma in _AMONG_VEHICLES


def by_agent(s: State, frame: Frame, previous: Frame | None) -> bool:
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


def goes_on(c: Clauses, i: int) -> bool:
    """Whether a relative clause tells what happens next: after a comma, or in the present."""
    rel = next((k for k in range(i - 1, -1, -1) if getattr(c.elements[k], "kind", "") == "rel"), 0)
    comma = getattr(c.elements[rel - 1], "low", "") == "," if rel else False
    verb = c.elements[i]
    now = isinstance(verb, Verb) and verb.auxiliary in ("is", "are", "gets", "get")
    return comma or now


def resulting(c: Clauses, s: State, frame: Frame, previous: Frame | None) -> Mention | None:
    """Of what ", which falls" tells: not of the place where that is, nor of what it has left."""
    last = s.relative
    if previous is None or last is None or frame.verb.passive:
        return last
    there = _there(previous, last) if frame.verb.sense in _LEAVING else None
    if there is not None and _is_meant(c, frame.verb, there, last):
        return there
    mover = previous.object or previous.subject
    left = mover is not None and _has_left(frame.verb, previous, mover, last)
    return mover if left else last


def _there(previous: Frame, last: Mention) -> Mention | None:
    """ "Taps the bin standing at the kerb": what is at the place named last."""
    at = next((p for p in previous.phrases if p.mention is last), None)
    if at is None or at.prep not in _PLACES or (at.prep == "against" and not previous.reduced):
        return None
    there = previous.subject
    if not previous.reduced:
        named = (previous.object, *(p.mention for p in previous.phrases if p is not at))
        near = [m for m in named if m is not None and m.end <= last.start]
        there = max(near, key=lambda m: m.end, default=None)
    if there is None or there.noun is None or there.pronoun or there.attribute:
        return None
    return there


def _is_meant(c: Clauses, v: Verb, there: Mention, last: Mention) -> bool:
    """Whether a verb is about what is there, and not about the place."""
    before = reversed(c.elements[: c.elements.index(v)])
    rel = next((e for e in before if getattr(e, "kind", "") == "rel"), None)
    if last.noun is None or getattr(rel, "low", "") == "who":
        return there.noun is not None and there.noun.kind == "person"
    firm = bool(_FIRM & last.noun.traits) or last.noun.kind in _BUILT
    return firm and not (v.sense not in _DOWN and last.noun.kind in _DRIVEN)


def _has_left(v: Verb, previous: Frame, mover: Mention, last: Mention) -> bool:
    """ "Pushes a bucket off a bench, which falls": not the bench."""
    if last.noun is None or last.after_prep not in _LEFT_BY or v.sense not in _GOING:
        return False
    carries = bool({"support", "fixed", "incline", "structural"} & last.noun.traits)
    stays = mover.noun is not None and "fixed" in mover.noun.traits
    own = v.sense == "topple" and previous.object is None  # "a bridge, which collapses"
    return carries and not stays and not own


def before_what_it_lets(previous: Frame, v: Verb) -> Frame:
    """ "stops to let a woman cross, then drives on": who stopped drives on."""
    while (
        previous.causer is not None
        and previous.verb.form == "base"
        and not previous.verb.infinitive
        and v.form in ("s", "past")
    ):
        previous = previous.causer
    return previous


def before_what_it_waits_for(c: Clauses, previous: Frame, s: State, v: Verb) -> Frame:
    """ "waits until the tram has passed and follows it", "until it passes, then": who waits."""
    perfect = previous.verb.auxiliary in ("has", "have", "had") and not v.auxiliary
    between = c.elements[c.elements.index(previous.verb) : c.elements.index(v)]
    then = previous.subordinate == "until" and any(getattr(e, "low", "") == "then" for e in between)
    told = previous.subordinate and s.boundary and v.form in ("s", "past")
    if not told or not (perfect or then):
        return previous
    mine = [g for g in c.frames if g.sentence == previous.sentence and not g.reduced]
    mains = [g for g in mine if not g.subordinate and g.verb.start < previous.verb.start]
    return mains[-1] if mains and mains[-1].verb.form == v.form else previous


def caused_after_relative(previous: Frame, v: Verb, s: State) -> bool:
    """ "makes a jar that lies on it roll off": what the main verb causes."""
    cause = previous.parent
    if not previous.relative or cause is None or cause.verb.sense != "cause" or s.boundary:
        return False
    return v.form == "base" and cause.object is not None and not v.auxiliary


def main_at_last(c: Clauses, previous: Frame, v: Verb, i: int) -> bool:
    """ "A stool that was bumped fell over", "a glass that was on it hit a guest"."""
    if v.form != "past" or v.passive:
        return False
    if not previous.relative or previous.parent is not None:
        return False
    return not any(getattr(e, "low", "") == "by" for e in c.elements[i + 1 : i + 2])


def awaits_main(previous: Frame, v: Verb) -> bool:
    """ "Darts thrown by a man hit the board": the participle's subject has no verb yet."""
    if not previous.reduced or previous.parent is not None or v.form == "ing":
        return False
    return previous.opening and v.sense not in ("posture", "park", "contain")


def whose(previous: Frame, s: State) -> bool:
    """ "A car whose wheel came off hits a wall": the car does."""
    m = s.relative
    return m is not None and previous.subject is not None and m.end <= previous.subject.start


def serial(previous: Frame, v: Verb, s: State) -> bool:
    """ "marble go down ramp hit cup": bare verbs in a row have one subject."""
    bare = previous.verb.form == "base" and not previous.verb.infinitive
    if not bare or previous.verb.auxiliary or previous.subject is None or s.boundary:
        return False
    if previous.subject.plural or previous.subject.coordinated or previous.subject.pronoun:
        return False
    return v.form in ("past", "base") and v.lemma in UNCHANGED


def agent(c: Clauses, frame: Frame) -> Mention | None:
    """Who carries on after this frame: the subject; the thing thrown for an imperative."""
    shown = frame.parent is not None and frame.parent.verb.lemma in _SHOWING
    if frame.reduced and frame.parent is not None and not shown:
        return agent(c, frame.parent)
    if frame.subject is None:
        return frame.object
    return frame.subject


def _who_went_on(c: Clauses, previous: Frame) -> Mention | None:
    """ ", which runs into a trough, upsetting it": what the relative clause is about."""
    told = [g for g in c.frames if g.subject is previous.subject and g.relative]
    going = previous.relative and any(g.resulting and g.sentence == previous.sentence for g in told)
    if going and previous.verb.sense not in ("be", "posture", "park", "have", "noop"):
        return previous.subject
    return agent(c, previous)


def infinitive(c: Clauses, s: State, frame: Frame, previous: Frame) -> None:
    whom = s.last if s.last is not None and s.last.after_prep == "for" else None
    if previous.verb.sense in CAUSE_SENSES | {"hit"} and (whom or previous.object):
        frame.subject = whom or previous.object  # "hits it hard enough for it to fall"
        frame.causer = previous
        frame.link = "cause"
    elif previous.verb.sense in CAUSE_SENSES and previous.verb.passive:
        frame.subject = previous.subject
        frame.causer = previous
    else:
        frame.subject = agent(c, previous)
        if previous.verb.lemma in _ASKING and previous.object is not None:
            frame.subject = previous.object  # "I want a ball to hit a box"
        it = previous.subject is not None and previous.subject.pronoun == "it"
        if it and previous.verb.lemma == "take" and previous.object is not None:
            frame.subject = previous.object  # "it takes the tram 6 s to stop"
        if it and previous.verb.lemma == "take" and (phrase := previous.phrase("for")):
            frame.subject = phrase.mention  # "it takes 2 s for a tram to stop"
        if whom is not None and previous.verb.lemma in _AWAITING:
            frame.subject, frame.reduced = whom, True  # "waits for a lorry to cross"
        frame.link = "purpose"
        frame.parent = previous
        frame.verb.negated = frame.verb.negated or previous.verb.lemma in _FAILING


def _lies_there(m: Mention, v: Verb) -> bool:
    """ "Sails on a river passing trees": not the river passes them."""
    flat = m.noun is not None and ("structural" in m.noun.traits or m.noun.kind == "water")
    return flat and bool(m.after_prep) and v.sense in ("pass", "overtake", "hit", "miss")


def _sends(f: Frame) -> bool:
    """ "Slides a mug across the table, stopping at its edge": the mug stops, nobody who drives."""
    m = f.subject
    by_hand = m is not None and m.noun is not None and m.noun.kind in ("person", "animal")
    sends = f.verb.sense in ("launch", "slide", "roll") and not f.verb.passive
    return by_hand and sends and f.object is not None


def participle(c: Clauses, s: State, frame: Frame, previous: Frame) -> None:
    v = frame.verb
    if previous.verb.sense == "cause" and previous.object is not None and not s.boundary:
        frame.subject, frame.link, frame.causer = previous.object, "cause", previous
    elif v.lemma == "hang" and previous.verb.sense == "carry" and previous.object is not None:
        # "a crane lowers a piano, hanging from a cable"
        frame.subject, frame.reduced, frame.parent = previous.object, True, previous
    elif v.sense in ("weigh", "measure", "have", "contain") and s.last is not None:
        frame.subject, frame.reduced, frame.parent = s.last, True, previous
    elif v.sense in CAUSE_SENSES or v.extra.get("transitive"):
        frame.subject = _who_went_on(c, previous)
        frame.link = "cause"
        frame.causer = previous
    elif s.boundary or s.last is None or s.last is previous.subject or _lies_there(s.last, v):
        sent = v.sense == "stop" and _sends(previous)
        frame.subject = previous.object if sent else _who_went_on(c, previous)
        frame.link = (
            "then" if v.sense in ("hit", "stop", "topple", "enter", "land", "miss") else "while"
        )
        frame.parent = previous
    else:
        frame.subject, frame.reduced = s.last, True
        frame.link = "while"
        frame.parent = previous
