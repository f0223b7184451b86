"""Asides in a clause: participles with an agent, relative clauses without "that", "is seen to".

"The scooter, bumped by a taxi and then by a van, ...", "the tray he was carrying falls", "the gnome
is seen falling": what they say of a noun is marked, so that the main verb is found.
"""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import finite, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_DONE_TO = lex.word_set("done to")
_SEEING = lex.word_set("seeing")
_HOLDING = lex.word_set("holding (asides)")
_SIDES = lex.word_set("sides (asides)")
_MEASURES = _SIDES | frozenset({"mass", "weight", "speed", "velocity"})
_MEDIA = lex.word_set("media")
_BLOWS = lex.word_set("blows (asides)")
_MOVES_IT = lex.word_set("moves it")
_NOISES = lex.word_set("noises")
_ADVERBS = lex.word_set("adverbs (rewrites asides)")
_AGENTLESS = lex.word_set("agentless")


def set_apart(elements: list[Element]) -> list[Element]:
    """Marks participles with an agent as passives and gives relative clauses their pronoun.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        nxt = elements[i + 1] if i + 1 < len(elements) else None
        if isinstance(e, Verb) and _by_agent(elements, i, out):
            e.form, e.passive = "pp", True
            e.extra = {**e.extra, "agent": "1"}
        elif (
            (used := _told_by_noun(elements, i, out))
            or (used := _untouched(elements, i, out))
            or (isinstance(e, Mention) and (used := _data_sheet(elements, i, out)))
        ):
            i += used
            continue
        elif isinstance(e, Word) and (thing := _so_much_of(elements, i)) is not None:
            assert e.amount is not None
            thing.amounts.append(e.amount)
            thing.start = e.start
            i += 2
            continue
        elif isinstance(e, Verb) and _sent_flying(elements, i):
            e.lemma, e.sense, e.end = "knock", "knock", elements[i + 1].end
            e.form = "pp" if e.passive or not out else e.form
            e.passive = e.passive or e.form == "pp"
            e.extra = {**e.extra, "agent": "1"} if not e.auxiliary else e.extra
            out.append(e)
            i += 2
            continue
        elif isinstance(e, Verb) and e.lemma == "leave" and isinstance(nxt, Mention):
            alone = word_at(elements, i + 2)
            if alone is not None and alone.low in ("untouched", "unscathed", "undisturbed"):
                e.lemma, e.sense = "miss", "miss"
        elif isinstance(e, Verb) and isinstance(nxt, Mention) and _puts_over(elements, i + 2):
            e.extra = {**e.extra, "over": "1"}
        elif isinstance(e, Verb) and e.lemma in _SEEING and e.passive and isinstance(nxt, Verb):
            if (nxt.form == "ing" and not nxt.auxiliary) or nxt.infinitive:
                nxt.form, nxt.start, nxt.infinitive = "s", e.start, False
                nxt.negated = nxt.negated or e.negated
                i += 1
                continue
        elif isinstance(e, Mention) and _without_that(elements, i, out):
            out.append(e)
            assert nxt is not None
            out.append(Word(nxt.start, nxt.start, "rel", "that"))
            i += 1
            continue
        out.append(e)
        i += 1
    return out


def _by_agent(elements: list[Element], i: int, out: list[Element]) -> bool:
    """ "..., bumped by a taxi": a participle, whatever its form could be besides."""
    v = elements[i]
    if not isinstance(v, Verb) or v.auxiliary or v.infinitive or v.passive:
        return False
    if v.form not in ("past", "pp", "base") or v.sense not in _DONE_TO:
        return False
    k = i + 1
    while (small := word_at(elements, k)) is not None and small.low in _ADVERBS:
        k += 1
    if small is not None and small.low in ("into", "against", "with"):
        k += 1  # "crashed into by a forklift"
    by = word_at(elements, k)
    agent = elements[k + 1] if k + 1 < len(elements) else None
    if by is None or by.low != "by" or not isinstance(agent, Mention) or agent.attribute:
        return False
    if agent.head in _AGENTLESS or agent.pronoun in _AGENTLESS:
        return False
    before = out[-1] if out else None
    while isinstance(before, Word) and before.kind == "adv" and len(out) > 1:
        before = out[out.index(before) - 1]
    if before is None or (isinstance(before, Word) and before.low in ".;:!?\n,(-–—"):
        return v.form != "base" or before is None
    if isinstance(before, Word) and before.kind == "sub":
        return before.low in ("when", "once", "if", "until", "after", "as")
    told = any(isinstance(x, Verb) and "agent" in x.extra for x in out[-8:])
    return isinstance(before, Word) and before.kind == "conj" and told


def _told_by_noun(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "a close-up of a glass", "a nudge from the cart sends", "BOOM": the thing itself is told."""
    noun, link = elements[i], word_at(elements, i + 1)
    if not isinstance(noun, Mention) or noun.possessor is not None:
        return 0
    starts = not out or (isinstance(out[-1], Word) and out[-1].low in ".;!?\n")
    well = starts and noun.head == "well" and link is not None and link.low == ","
    noise = (noun.head in _NOISES or well) and not noun.determiner and not noun.adjectives
    noise = noise and (well or not noun.known)
    if noise and (link is None or link.kind == "punct" or not link.low):
        out.append(Word(noun.start, noun.end, "adv", "suddenly"))
        return 1
    thing = elements[i + 2] if i + 2 < len(elements) else None
    if link is None or not isinstance(thing, Mention) or thing.attribute or noun.noun is not None:
        return 0
    acts = elements[i + 3] if i + 3 < len(elements) else None
    doing = isinstance(acts, Verb) and acts.form == "ing" and not acts.auxiliary
    if noun.head in _MEDIA and (link.low == "of" or (link.low == "with" and doing)):
        out.append(Word(noun.start, link.end, "adv", "indeed"))
        return 2
    if noun.head not in _BLOWS or link.low not in ("of", "from", "by", "with"):
        return 0
    verb = elements[i + 3] if i + 3 < len(elements) else None
    enough, act = word_at(elements, i + 4), elements[i + 5] if i + 5 < len(elements) else None
    if isinstance(verb, Verb) and verb.sense == "be" and enough is not None:
        if enough.low in ("enough", "sufficient") and isinstance(act, Verb) and act.infinitive:
            act.infinitive, act.form, act.start = False, "s", verb.start
            out += [Word(noun.start, link.end, "adv", "indeed"), thing]
            return 5
        return 0
    if not isinstance(verb, Verb) or verb.passive or verb.infinitive or verb.sense not in _MOVES_IT:
        return 0
    if verb.sense in ("own", "launch"):
        verb.lemma, verb.sense = "send", "cause"  # "drives the wedge into the log"
    out += [Word(noun.start, link.end, "adv", "indeed"), thing]
    return 3


def _untouched(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Untouched by the first ball, the pin ...": it missed."""
    word, by = word_at(elements, i), word_at(elements, i + 1)
    if word is None or by is None or by.low != "by" or word.low not in ("untouched", "unhit"):
        return 0
    out.append(Verb(word.start, word.end, "touch", "hit", "pp", passive=True, negated=True))
    return 1


def _data_sheet(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Weight: 12 kg. Height: 80 cm. The keg ...", "Speed of the ball: 6 m/s."."""
    measure = elements[i]
    last = out[-1] if out else None
    if not isinstance(measure, Mention) or measure.head not in _MEASURES or measure.amounts:
        return 0
    if last is not None and not (isinstance(last, Word) and last.low in (*".;:!?,\n", "indeed")):
        return 0
    k, owner = i + 1, None
    of = word_at(elements, k)
    if of is not None and of.low == "of" and isinstance(elements[k + 1 : k + 2], list):
        owner = elements[k + 1] if k + 1 < len(elements) else None
        k += 2
    mark, value = word_at(elements, k), word_at(elements, k + 1)
    if mark is None or mark.low not in (":", "=") or value is None or value.amount is None:
        return 0
    end = word_at(elements, k + 2)
    if end is None or end.low not in ".;,\n":
        return 0
    thing = owner
    for e in elements[k + 3 :] if owner is None else []:
        if isinstance(e, Verb):
            return 0
        if isinstance(e, Mention) and e.head not in _MEASURES:
            thing = e
            break
    if not isinstance(thing, Mention) or thing.attribute or thing.pronoun:
        return 0
    if isinstance(owner, Mention) and value.amount.dimension == "speed":
        out += [owner, Word(mark.start, mark.end, "prep", "at"), value, end]
        return k + 3 - i
    if value.amount.dimension == "length" and measure.head in _SIDES:
        thing.adjectives.append(f"@{value.amount.start}:{measure.head}")
    thing.amounts.append(value.amount)
    out.append(Word(measure.start, value.end, "adv", "indeed"))
    if isinstance(owner, Mention):
        out += [owner, end]
    return k + 3 - i


def _so_much_of(elements: list[Element], i: int) -> Mention | None:
    """ "a tonne and a half of steel beam": the beam weighs that."""
    much, of = word_at(elements, i), word_at(elements, i + 1)
    thing = elements[i + 2] if i + 2 < len(elements) else None
    if much is None or much.amount is None or much.amount.dimension != "mass":
        return None
    if of is None or of.low != "of" or not isinstance(thing, Mention) or thing.determiner:
        return None
    return None if thing.pronoun or thing.attribute or thing.plural else thing


def _sent_flying(elements: list[Element], i: int) -> bool:
    """ "sent flying by the swing", "is sent sprawling by a dog": knocked by it."""
    send, fly, by = elements[i], elements[i + 1] if i + 1 < len(elements) else None, None
    by = word_at(elements, i + 2)
    if not isinstance(send, Verb) or send.lemma != "send" or not isinstance(fly, Verb):
        return False
    loose = send.passive or (not send.auxiliary and send.form in ("past", "pp"))
    return bool(loose and fly.form == "ing" and by is not None and by.low == "by")


def _puts_over(elements: list[Element], i: int) -> bool:
    """ "whacks the lamp over": the particle ends the clause."""
    particle, end = word_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    if particle is None or particle.low not in ("over", "down", "flat"):
        return False
    return end is None or (isinstance(end, Word) and end.kind in ("punct", "conj", "sub", "rel"))


def _without_that(elements: list[Element], i: int, out: list[Element]) -> bool:
    """ "the tray he was carrying falls": a clause between a noun and its verb."""
    head, subject = elements[i], elements[i + 1] if i + 1 < len(elements) else None
    verb = elements[i + 2] if i + 2 < len(elements) else None
    if not isinstance(head, Mention) or not isinstance(subject, Mention) or head.pronoun:
        return False
    known = subject.pronoun in ("he", "she", "it", "they", "we", "i", "you")
    if not (known or subject.determiner in ("the", "his", "her", "its")) or head.attribute:
        return False
    if not isinstance(verb, Verb) or verb.infinitive or verb.sense not in _HOLDING:
        return False
    if not (finite(verb) or verb.auxiliary) or verb.passive:
        return False
    k = i + 3
    while (small := word_at(elements, k)) is not None and small.kind == "adv":
        k += 1
    main = elements[k] if k < len(elements) else None
    if isinstance(main, Verb):
        return not main.infinitive and main.form in ("s", "past", "pp")
    closes = word_at(elements, k)
    before = out[-1] if out else None
    inverted = isinstance(before, Verb) and before.sense in ("own", "roll", "slide", "fly", "fall")
    return inverted and closes is not None and closes.low in ",."
