"""Clauses: who does what to whom, in which order.

A frame is one verb with its subject, object, prepositional phrases, adverbs and quantities. Frames
come out in order of time: "after", "before", "when" and fronted clauses are untangled here.
"""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.captions import DOERS, STRUCK
from esg.draft.grammar.clauses.frames import Frame, State, background_first, in_order
from esg.draft.grammar.clauses.idioms import read_idioms
from esg.draft.grammar.clauses.nouns import mention
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.grammar.clauses.verbs import UNTIL_MAIN, verb
from esg.draft.grammar.clauses.words import flush, read_word
from esg.draft.text.elements import Element, Mention, Verb

_GETTING = lex.word_set("getting (builder)")
_TURNED = lex.word_set("senses told as actives (builder)")
_STRUCK_INTO = ("against", "along", "into")
"""What tells where that goes which is struck: "is rammed into a wall by a car"."""
_OTHERWISE = frozenset({"pull"})
"""Of which the particle tells another sense where something acts: "a shelf is pulled over"."""
_CARRYING = frozenset({"carry", "transport", "ferry"})
_TAKING = lex.word_set("taking (builder)")


def build_clauses(elements: list[Element]) -> Clauses:
    """Clauses of a text, in order of time, and what stands outside of any."""
    c = Clauses(elements)
    s = State()
    els = c.elements
    i = 0
    while i < len(els):
        e = els[i]
        if isinstance(e, Mention):
            c.mentions.append(e)
            mention(c, s, e, i)
        elif isinstance(e, Verb):
            verb(c, s, e, i)
        else:
            s = read_word(c, s, e, i)
        i += 1
    flush(c, s)
    for k, f in enumerate(c.frames):
        _takes_time(f, c.frames[k + 1 :])
        _fronted(f, [g for g in c.frames[k + 1 :] if g.sentence == f.sentence])
        if f.subordinate:
            around = [*reversed(c.frames[:k]), *c.frames[k + 1 :]]
            alike = (g for g in around if g.sentence == f.sentence and not g.subordinate)
            f.main = next(alike, None)
    c.frames = _same_again(c, in_order(background_first(c.frames)))
    for f in c.frames:
        _by_who_acts(f)
    read_idioms(c.frames)
    return c


def _same_again(c: Clauses, frames: list[Frame]) -> list[Frame]:
    """ "The blue car does the same": what the clauses before tell of their subject, again."""
    out: list[Frame] = []
    for f in frames:
        o = f.object
        same = f.verb.sense in ("be", "noop") and o is not None and o.attribute | (not o.head)
        if not (same and o is not None and o.adjectives == ["same"] and f.subject and out):
            out.append(f)
            continue
        told = _last_told(out)
        c.mentions = [m for m in c.mentions if m is not o or not told]
        role = f.verb.extra.get("as", "subject")
        if role == "behind" and told:
            out.append(_goes_behind(f, told[-1]))
            continue
        after = ["then"] if "then" in f.verb.extra else []
        for k, g in enumerate(told):
            phrases = [p for p in g.phrases if p.amount is None]
            if role == "place" and phrases:  # "rolls past a box, then a cone"
                phrases[-1] = replace(phrases[-1], mention=f.subject)
            verb = replace(g.verb, extra={**g.verb.extra, "again": "1"})
            own = replace(
                g,
                verb=verb,
                subject=f.subject if role == "subject" else g.subject,
                object=f.subject if role == "object" else g.object,
                phrases=[*phrases, *(f.phrases if k == len(told) - 1 else [])],
                adverbs=[*(a for a in g.adverbs if not after or a != "first"), *after],
                link=f.link if k == 0 else g.link,
                sentence=f.sentence,
                parent=None,
            )
            if k == 0:
                own.verb.start, own.verb.end = f.verb.start, f.verb.end
            out.append(own)
        if not told:
            out.append(f)
    return out


def _by_who_acts(f: Frame) -> None:
    """ "A tray is carried by a waiter": a waiter carries a tray."""
    by = f.phrase("by")
    if not f.verb.passive or f.subject is None or f.object is not None or by is None:
        return
    doer = by.mention
    if doer is None or doer.attribute:
        return
    carried = f.verb.sense == "carry" and f.verb.lemma in _CARRYING
    kind = doer.noun.kind if doer.noun is not None else ""
    into = f.verb.sense in STRUCK and f.phrase(*_STRUCK_INTO) is not None
    told = (f.verb.sense in _TURNED or into) and kind in DOERS and (f.relative or not f.reduced)
    told = told and f.verb.lemma not in _OTHERWISE
    if not carried and not told:
        return
    f.phrases.remove(by)
    f.subject, f.object = doer, f.subject
    f.verb.passive, f.verb.form, f.verb.auxiliary = False, "s", ""
    f.reduced = f.reduced and not carried


def _last_told(out: list[Frame]) -> list[Frame]:
    """The last clauses of one subject; of a command the last one."""
    model = next((g for g in reversed(out) if not g.reduced), None)
    if model is None or model.subject is None:
        return [] if model is None else [model]
    told: list[Frame] = []
    for g in reversed(out):
        if g.subject is not model.subject or g.reduced:
            break
        told.insert(0, g)
    return told


def _goes_behind(f: Frame, ahead: Frame) -> Frame:
    """ "A truck drives along, followed by a car": the car follows the truck."""
    verb = replace(f.verb, lemma="follow", sense="follow", extra={})
    whom = ahead.object if ahead.object is not None and ahead.subject is None else ahead.subject
    return replace(f, verb=verb, object=whom)


def _fronted(f: Frame, following: list[Frame]) -> None:
    """ "After hitting a cone, the car ...", "Struck by a car, the bin ...": subject to come."""
    main = next((g for g in following if g.subject is not None), None)
    for p in [p for p in f.phrases if p.prep == UNTIL_MAIN]:
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


def _takes_time(f: Frame, following: list[Frame]) -> None:
    """ "needs 5 seconds to stop", "takes 2 s to reach the door": the time of what follows."""
    it = f.subject is not None and f.subject.pronoun == "it"
    until = it and following and following[0].subordinate in ("until", "till", "before")
    if f.verb.lemma not in _TAKING or not following:
        return
    if following[0].link != "purpose" and not until:
        return
    last = following[0]
    for g in following[1:]:  # "takes 1.5 s to roll downhill and thump into a gate"
        going = last.verb.sense in _GETTING and g.verb.sense == "hit"
        if g.sentence != f.sentence or g.verb.auxiliary or not (g.verb.form == "base" or going):
            break
        last = g
    for p in list(f.phrases):
        if p.amount is not None and p.amount.dimension in ("time", "length"):
            f.phrases.remove(p)
            f.times = True
            p.prep = "after" if p.amount.dimension == "length" else p.prep
            last.phrases.append(p)  # "needs 14 m to stop"
