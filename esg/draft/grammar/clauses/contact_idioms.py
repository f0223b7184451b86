"""Verbs that are contacts with their arguments: "takes it out", "shuts on it", "whacks it over"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Mention

_BREAKING = lex.word_set("breaking (contact idioms)")
_SHUTTING = lex.word_set("shutting")
_STEPPING = lex.word_set("stepping (contact idioms)")
TRAVELLING = lex.word_set("travelling (contact idioms)")
ROUND = lex.word_set("round")
_BATTING = lex.word_set("batting")
_SURFACES = lex.word_set("surfaces")


def kind_of(m: Mention | None) -> str:
    return m.noun.kind if m is not None and m.noun is not None else ""


def is_structural(m: Mention | None) -> bool:
    return m is not None and m.noun is not None and "structural" in m.noun.traits


def is_thing(m: Mention | None) -> bool:
    """Whether a phrase names something solid, pronouns included."""
    return m is not None and not m.attribute and not is_structural(m) and bool(m.head or m.pronoun)


def takes_out(f: Frame) -> str:
    """ "The second ball takes it out", "takes out the yellow one": a hit."""
    if f.verb.lemma != "take" or kind_of(f.subject) == "person" or f.verb.sense != "noop":
        return ""
    out = f.phrase("out")
    if f.object is None and out is not None:
        f.object = out.mention
        f.phrases.remove(out)
        return "hit"
    return "hit" if "out" in f.adverbs and is_thing(f.object) else ""


def breaks_it(f: Frame) -> str:
    """ "The stone breaks a pane": nobody breaks it, something moving does."""
    if f.verb.lemma not in _BREAKING or f.verb.sense != "noop" or f.verb.passive:
        return ""
    if f.verb.infinitive:
        return ""  # "throws a stone to break a window"
    moving = is_thing(f.subject) and kind_of(f.subject) not in ("person", "")
    pronoun = f.subject is not None and f.subject.pronoun == "it"
    return "hit" if (moving or pronoun) and is_thing(f.object) and f.object is not None else ""


def shuts_on(f: Frame) -> str:
    """ "The doors shut on a suitcase"."""
    if f.verb.lemma not in _SHUTTING or f.verb.sense != "noop":
        return ""
    p = f.phrase("on")
    if p is not None and is_thing(p.mention):
        p.prep = "against"
        return "hit"
    return ""


def steps_on(f: Frame) -> str:
    """ "steps on a rake" is a contact, "steps onto the road" a motion."""
    if f.verb.lemma not in _STEPPING or f.verb.sense not in ("noop", "own"):
        return ""
    p = f.phrase("on", "onto")
    return "hit" if p is not None and is_thing(p.mention) else "own"


def hits_ground(f: Frame) -> str:
    """ "hits a patch of ice": a surface that it drives over."""
    if f.verb.sense != "hit" or f.verb.passive or f.object is None:
        return ""
    flat = f.object.head.split()[-1:] and f.object.head.split()[-1] in _SURFACES
    return "own" if flat and kind_of(f.subject) in TRAVELLING else ""


def against(f: Frame) -> str:
    """ "gets wedged against the sofa", "is dashed onto the rocks": it hits what it is against."""
    if f.verb.sense not in ("hit", "knock") or not f.verb.passive or f.phrase("by") is not None:
        return ""
    below = f.phrase("under", "beneath", "underneath")
    if below is not None and f.verb.sense == "hit" and is_thing(below.mention):
        below.prep = "by"  # "is crushed under the wheels of a lorry"
        return "hit"
    met = f.phrase("against", "into", "onto")
    if met is None or not is_thing(met.mention) or f.object is not None:
        return ""
    if met.prep != "against" and kind_of(f.subject) in ROUND:
        return ""  # "is hit into the pocket"
    f.verb.passive = False
    return "hit"


def knocks_over(f: Frame) -> str:
    """ "whacks it over", "bowls a bottle over", "takes the mast down": it topples."""
    if (
        f.verb.sense not in ("hit", "launch", "tow", "noop")
        or f.verb.passive
        or not is_thing(f.object)
    ):
        return ""
    moves = f.verb.sense == "noop" and f.verb.lemma not in ("take", "bring", "pull")
    if moves or "over" not in f.verb.extra or kind_of(f.object) in ROUND:
        return ""
    f.verb.extra = {**f.verb.extra, "transitive": "1", "contact": "1"}
    return "topple"


def bats_off(f: Frame) -> str:
    """ "A cat bats a pen off the desk": a blow, not a throw."""
    if f.verb.lemma not in _BATTING or f.verb.sense != "launch" or f.verb.passive:
        return ""
    off = f.phrase("off", "from", "out of") is not None or "off" in f.adverbs
    return "knock" if off and is_thing(f.object) and is_thing(f.subject) else ""


def pulled_over(f: Frame) -> str:
    """ "The bookcase gets pulled over by a toddler": it topples, where a car would stop."""
    if f.verb.lemma != "pull" or f.verb.sense != "stop" or not f.verb.passive:
        return ""
    return "topple" if kind_of(f.subject) not in ("vehicle", "person", "") else ""


def not_avoided(f: Frame) -> str:
    """ "cannot avoid the bus", "fails to miss it": hits it."""
    if f.verb.sense not in ("avoid", "miss") or not f.verb.negated or not is_thing(f.object):
        return ""
    if f.verb.lemma not in ("avoid", "miss", "dodge", "evade"):
        return ""
    f.verb.negated, f.verb.modal = False, ""
    return "hit"


def leaves_alone(f: Frame) -> str:
    """ "leaves the pin untouched": misses it."""
    if f.verb.lemma != "leave":
        return ""
    alone = {"untouched", "unscathed", "unharmed", "undisturbed"} & set(f.adverbs)
    return "miss" if alone and is_thing(f.object) else ""


def takes_along(f: Frame) -> str:
    """ "topples and takes a lamp with it": it hits the lamp."""
    own = f.phrase("with") if f.verb.lemma == "take" else None
    along = own is not None and own.mention is not None and own.mention.pronoun in ("it", "them")
    return "hit" if along and is_thing(f.object) else ""


def deflects(f: Frame) -> str:
    """ "A defender deflects it with his arm": it hits him."""
    deflects = f.verb.lemma == "deflect" and f.verb.sense == "bounce" and not f.verb.passive
    return "hit" if deflects and is_thing(f.object) else ""


def buries(f: Frame) -> str:
    """ "A plough buries a bicycle": under what it moves, not by a hit."""
    buries = f.verb.lemma == "bury" and f.verb.sense == "hit" and not f.verb.extra
    slides = f.subject is not None and f.subject.head in ("snow", "sand", "mud", "rubble", "debris")
    buries = buries and not slides
    return "noop" if buries and kind_of(f.subject) in ("vehicle", "person", "animal") else ""


def stumbles_over(f: Frame) -> str:
    """ "stumbles over a stool into a waiter": it touches both."""
    over = f.phrase("over") if f.verb.lemma == "stumble" else None
    return "hit" if over is not None and is_thing(over.mention) else ""


def jams(f: Frame) -> str:
    """ "The cable jams": nothing is hit."""
    met = f.object is not None or any(p.mention is not None for p in f.phrases)
    alone = f.verb.lemma in ("jam", "stick", "snag") and f.verb.sense == "hit"
    return "noop" if alone and not met and not f.verb.passive else ""
