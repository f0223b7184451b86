"""Verbs that say nothing without their noun, and other ways round: "gives it a nudge".

"Gives the stack a nudge" is nudging it, "gets a push from a cart" being pushed by one, "what the
ball does is hit the bottle" hitting it, "leaves the pin standing" missing it.
"""

from __future__ import annotations

from collections.abc import Callable

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import mention_at, word_at
from esg.draft.grammar.rewrites.headlines import heading
from esg.draft.grammar.rewrites.tellings import told_otherwise
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.verbphrases import verb_readings

_BLOWS = lex.word_set("blows (light verbs)")
_GIVING = lex.word_set("giving")
_GETTING = lex.word_set("getting (light verbs)")
_MEETINGS = lex.word_set("meetings")
_LEFT = lex.word_set("left")


def lighten(elements: list[Element]) -> list[Element]:
    """Makes plain verbs of light verbs and their nouns.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        used = 0
        for reading in _READINGS[type(elements[i])]:
            used = reading(elements, i, out)
            if used:
                break
        if used:
            i += used
            continue
        _no_ditch(elements, i)
        out.append(elements[i])
        i += 1
    return out


def _no_ditch(elements: list[Element], i: int) -> None:
    """ "closes the gap", "the gap between two jeeps is 15 m": a distance."""
    gap = mention_at(elements, i)
    if gap is None or gap.head != "gap":
        return
    before, link = elements[i - 1] if i else None, word_at(elements, i + 1)
    closes = isinstance(before, Verb) and before.lemma in ("close", "narrow", "widen", "shut")
    if closes or (link is not None and link.low in ("between", "of")):
        gap.noun, gap.attribute = None, True


def blow_at(elements: list[Element], i: int) -> tuple[str, int]:
    """The noun of a contact and the elements it takes ("a good shove"); "" for a thing."""
    m = mention_at(elements, i)
    if m is not None:
        plain = m.noun is None and not m.pronoun and m.possessor is None
        return (m.head, 1) if plain and m.head in _BLOWS else ("", 0)
    for n in range(i, i + 4):
        w = word_at(elements, n)
        if w is None or w.kind not in ("unknown", "adv"):
            return "", 0
        if n > i and w.low in _BLOWS:
            return w.low, n + 1 - i
    return "", 0


def _told(elements: list[Element], i: int, used: int) -> Word:
    """The place of a noun that its verb now tells."""
    return Word(elements[i].start, elements[i + used - 1].end, "adv", "indeed")


def as_verb(v: Verb, blow: str) -> Verb:
    """The verb of a blow's noun, in the form of the light verb."""
    readings = [r for r in verb_readings(blow) if r.form == "base"]
    lemma, sense, note = (readings[0].lemma, readings[0].sense, readings[0].note) if readings else (
        "hit", "hit", "",
    )  # fmt: skip
    if blow in ("blow", "jolt", "touch"):
        lemma, sense = "hit", "hit"
    return Verb(
        v.start, v.end, lemma, sense, v.form, note, v.passive, v.negated, v.auxiliary,
        v.infinitive, v.modal,
    )  # fmt: skip


def _given(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "gives the stack a nudge", "gives a nudge to the stack"."""
    give = elements[i]
    if not isinstance(give, Verb) or give.lemma not in _GIVING or give.passive:
        return 0
    one = mention_at(elements, i + 1)
    blow, used = blow_at(elements, i + 2)
    if one is not None and blow and not one.attribute:
        out += [as_verb(give, blow), one, _told(elements, i + 2, used)]
        return 2 + used
    blow, used = blow_at(elements, i + 1)
    to, thing = word_at(elements, i + 1 + used), mention_at(elements, i + 2 + used)
    if blow and to is not None and to.low in ("to", "on") and thing is not None:
        out += [as_verb(give, blow), _told(elements, i + 1, used), thing]
        return 3 + used
    return 0


def _received(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "gets a push from a cart": is pushed by it."""
    get = elements[i]
    if not isinstance(get, Verb) or get.lemma not in _GETTING:
        return 0
    blow, used = blow_at(elements, i + 1)
    link, agent = word_at(elements, i + 1 + used), mention_at(elements, i + 2 + used)
    if not blow or agent is None or agent.attribute:
        return 0
    if link is None or link.low not in ("from", "by"):
        return 0
    verb = as_verb(get, blow)
    verb.form, verb.passive, verb.auxiliary = "pp", True, "gets"
    by = Word(link.start, link.end, "prep", "by")
    out += [verb, _told(elements, i + 1, used), by, agent]
    return 3 + used


def _meeting(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "has a collision with a bus": hits it."""
    have, noun = elements[i], mention_at(elements, i + 1)
    if not isinstance(have, Verb) or have.lemma not in ("have", "suffer", "cause") or noun is None:
        return 0
    link, met = word_at(elements, i + 2), mention_at(elements, i + 3)
    if noun.head not in _MEETINGS or link is None or link.low != "with" or met is None:
        return 0
    out += [Verb(have.start, noun.end, "hit", "hit", have.form, negated=have.negated), met]
    return 4


def _does_it(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "What the ball does is hit the bottle": it hits the bottle."""
    what, thing = word_at(elements, i), mention_at(elements, i + 1)
    if what is None or what.low != "what" or thing is None:
        return 0
    does = elements[i + 2] if i + 2 < len(elements) else None
    if not isinstance(does, Verb):
        return 0
    is_ = elements[i + 3] if i + 3 < len(elements) else None
    if isinstance(is_, Mention) and does.passive and does.auxiliary == "is":
        verb, used = does, 3  # "does is hit" in one group
    elif isinstance(is_, Word) and does.sense == "be" and does.auxiliary == "is":
        reading = next((r for r in verb_readings(is_.low) if r.form == "base"), None)
        if reading is None:
            return 0
        verb, used = Verb(is_.start, is_.end, reading.lemma, reading.sense, "s", reading.note), 4
    elif isinstance(is_, Verb) and does.sense == "be" and not does.negated:
        verb, used = is_, 4
    else:
        return 0
    verb.form, verb.infinitive, verb.passive, verb.auxiliary = "s", False, False, ""
    out += [thing, verb]
    return used


def _left_alone(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "leaves the other one standing": misses it."""
    leave, thing = elements[i], mention_at(elements, i + 1)
    how = elements[i + 2] if i + 2 < len(elements) else None
    if not isinstance(leave, Verb) or leave.lemma != "leave" or leave.passive or thing is None:
        return 0
    word = getattr(how, "low", "") or (getattr(how, "lemma", "") + "ing")
    if word not in _LEFT or thing.attribute:
        return 0
    leave.lemma, leave.sense = "miss", "miss"
    out += [leave, thing]
    if how is not None:
        out.append(Word(how.start, how.end, "adv", word))
    return 3


def _together(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "they both fall": both."""
    they, both = mention_at(elements, i), mention_at(elements, i + 1)
    if they is None or both is None or they.pronoun not in ("they", "we") or both.head:
        return 0
    if both.pronoun != "both" and both.determiner != "both":
        return 0
    both.start, both.pronoun = they.start, "both"
    out.append(both)
    return 2


def _versus(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Man versus door: ...": a title."""
    if out and not (isinstance(out[-1], Word) and out[-1].low in ".;!?\n"):
        return 0
    colon = word_at(elements, i + 3)
    if colon is None:
        return 0
    one, link, other = (
        mention_at(elements, i),
        word_at(elements, i + 1),
        mention_at(elements, i + 2),
    )
    if one is None or link is None or other is None or colon.low not in ":.—–-":
        return 0
    if link.low not in ("versus", "vs", "v", "against", "meets") or len(elements) < i + 6:
        return 0
    again = {e.head for e in elements[i + 4 :] if isinstance(e, Mention)}
    if not {one.head, other.head} <= again:
        return 0
    out.append(Word(one.start, colon.end, "adv", "heading"))
    return 4


def _from_one(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "One push from the child and the swing hits": the child pushes the swing, which hits."""
    if out and not (isinstance(out[-1], Word) and out[-1].low in ".;!?\n:"):
        return 0
    blow, used = blow_at(elements, i)
    one, push = mention_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    if one is not None and one.pronoun == "one" and not one.adjectives and isinstance(push, Verb):
        blow, used = (push.lemma, 2) if push.lemma in _BLOWS and push.form == "base" else ("", 0)
    link, agent = word_at(elements, i + used), mention_at(elements, i + used + 1)
    conj, thing = word_at(elements, i + used + 2), mention_at(elements, i + used + 3)
    if not blow or link is None or link.low not in ("from", "by", "of") or agent is None:
        return 0
    if conj is None or conj.low != "and" or thing is None or agent.attribute or thing.attribute:
        return 0
    verb = as_verb(Verb(elements[i].start, elements[i + used - 1].end, "hit", "hit", "s"), blow)
    it = Mention(thing.end, thing.end, pronoun="it", text="it")
    out += [agent, verb, thing, conj, it]
    return used + 4


def _first_met(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "The first thing it meets is a deckchair": it meets a deckchair."""
    what, subject = mention_at(elements, i), mention_at(elements, i + 1)
    if what is None or subject is None or what.head not in ("thing", "object"):
        return 0
    verb = elements[i + 2] if i + 2 < len(elements) else None
    is_ = elements[i + 3] if i + 3 < len(elements) else None
    met = mention_at(elements, i + 4)
    if met is None:
        return 0
    if not isinstance(verb, Verb) or not isinstance(is_, Verb) or is_.sense != "be" or is_.negated:
        return 0
    if verb.sense not in ("hit", "reach", "enter", "knock") or verb.passive:
        return 0
    verb.sense = "hit" if verb.sense == "reach" else verb.sense
    out += [Word(what.start, what.end, "adv", "then"), subject, verb, met]
    return 5


def _object_of(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "the hatchback it shunts at 5 m/s": a clause of the noun, without "that"."""
    head, subject = mention_at(elements, i), mention_at(elements, i + 1)
    if head is None or subject is None or subject.pronoun not in ("it", "he", "she", "they"):
        return 0
    verb = elements[i + 2] if i + 2 < len(elements) else None
    after = elements[i + 3] if i + 3 < len(elements) else None
    if head.pronoun or head.attribute or not isinstance(verb, Verb) or verb.passive:
        return 0
    if verb.sense not in ("hit", "knock") or verb.infinitive or verb.form not in ("s", "past"):
        return 0
    if isinstance(after, Mention):
        return 0
    out += [head, Word(subject.start, subject.start, "rel", "that"), subject, verb]
    return 3


def _title(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Crash test: ...": words that name no object, in front of a colon."""
    if out and not (isinstance(out[-1], Word) and out[-1].low in ".;!?\n"):
        return 0
    k = i
    while k < len(elements) and k < i + 3:
        e = elements[k]
        if isinstance(e, Word) and e.low == ":":
            break
        unknown = isinstance(e, Word) and e.kind == "unknown"
        told = isinstance(e, Mention) and (e.known or e.noun or e.determiner or e.amounts)
        if not (unknown or isinstance(e, Mention)) or told or getattr(e, "letters", None):
            return 0
        k += 1
    colon = word_at(elements, k)
    if k < i + 2 or colon is None or colon.low != ":" or k + 2 >= len(elements):
        return 0
    out.append(Word(elements[i].start, colon.end, "adv", "heading"))
    return k + 1 - i


_READINGS: dict[type[Element], tuple[Callable[[list[Element], int, list[Element]], int], ...]] = {
    Mention: (_versus, heading, _title, _together, _from_one, _first_met, _object_of,
              told_otherwise),
    Verb: (heading, _given, _received, _meeting, _left_alone, told_otherwise),
    Word: (heading, _title, _does_it, _from_one, told_otherwise),
}  # fmt: skip
"""What may be told around the plain way, by what it begins with."""
