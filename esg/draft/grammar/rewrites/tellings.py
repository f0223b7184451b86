"""Ways of telling around what happens: reports, results, clefts and times that pass.

"I saw how a truck hits a fence", "which leads to it falling", "it is only when a cat bumps it that
it falls" and "once 2 s have passed" tell what plain clauses and times do.
"""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.gaps import mention_at, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word

_AIMS = lex.word_set("aims (tellings)")
_FILM = lex.word_set("film")
_RESULTS = frozenset({("lead", "to"), ("result", "in")})
_THESE = lex.word_set("these")
_REPORTING = lex.word_set("reporting")


def told_otherwise(elements: list[Element], i: int, out: list[Element]) -> int:
    """Appends the plain words for what stands at i.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
        i: Where to look.
        out: The elements before it, in plain words; takes the new ones.

    Returns:
        How many elements they stand for; 0 if nothing is to change.
    """
    e = elements[i]
    if isinstance(e, Mention):
        return (
            _speed_drops(elements, i, out)
            or _reported(elements, i, out)
            or _leads_to(elements, i, out)
            or _cleft(elements, i, out)
        )
    if isinstance(e, Verb):
        return (
            _into_view(elements, i, out)
            or _following_time(elements, i, out)
            or _leads_to(elements, i, out)
        )
    return _time_passes(elements, i, out) or _leads_to(elements, i, out)


def _speed_drops(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "The truck's speed drops to zero", "its speed falls": it slows down, and nothing falls."""
    speed, verb = mention_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    if speed is None or speed.head not in ("speed", "velocity", "pace") or not speed.attribute:
        return 0
    if not isinstance(verb, Verb) or verb.sense not in ("fall", "drop", "topple", "slide"):
        return 0
    thing = speed.possessor
    if thing is None and speed.determiner in ("its", "his", "her"):
        thing = Mention(speed.start, speed.end, pronoun="it", text="it")
    if thing is None:
        return 0
    to, zero = word_at(elements, i + 2), elements[i + 3] if i + 3 < len(elements) else None
    nought = getattr(zero, "low", "") or getattr(zero, "head", "")
    stops = to is not None and to.low == "to" and nought in ("zero", "0", "nothing", "nil")
    lemma, sense = ("stop", "stop") if stops else ("slow", "slow")
    out += [thing, Verb(verb.start, verb.end, lemma, sense, verb.form, extra={"via": "come"})]
    return 4 if stops else 2


def _into_view(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "enters the frame", "rolls into view": it comes, and enters nothing."""
    verb, into = elements[i], word_at(elements, i + 1)
    if not isinstance(verb, Verb) or verb.passive or verb.negated:
        return 0
    k = i + 1 if into is None else i + 2
    seen = mention_at(elements, k)
    if seen is None or seen.head not in _FILM or seen.adjectives or seen.possessor is not None:
        return 0
    if seen.determiner not in ("the", "") or (into is not None and into.low not in ("into", "in")):
        return 0
    if into is None and verb.lemma not in ("enter", "leave", "exit", "cross"):
        return 0
    if into is not None and verb.sense not in ("own", "roll", "slide", "fly", "enter"):
        return 0
    if getattr(elements[k + 1] if k + 1 < len(elements) else None, "low", "") == "of":
        return 0
    if verb.sense not in ("roll", "slide", "fly"):
        verb.lemma, verb.sense = "come", "own"
    verb.end = seen.end
    out.append(verb)
    return k + 1 - i


def _following_time(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "hits it following 2 s": after 2 s."""
    verb, time = elements[i], word_at(elements, i + 1)
    timed = time is not None and time.amount is not None and time.amount.dimension == "time"
    if not (isinstance(verb, Verb) and verb.lemma == "follow" and verb.form == "ing" and timed):
        return 0
    out.append(Word(verb.start, verb.end, "prep", "after"))
    return 1


def _reported(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "I saw how", "My friend says that", "The clip shows how": a heading of what is told."""
    who, verb = mention_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    how = word_at(elements, i + 2)
    aim = who is not None and who.head in _AIMS and isinstance(verb, Verb) and verb.sense == "be"
    aim = aim and isinstance(verb, Verb) and not verb.negated
    if aim and how is not None and how.low == "that" and (not out or _sentence_ends(out[-1])):
        out.append(Word(elements[i].start, how.end, "adv", "heading"))
        return 3
    if who is None or not isinstance(verb, Verb) or verb.lemma not in _REPORTING or how is None:
        return 0
    if verb.negated or verb.passive or (out and not _sentence_ends(out[-1])):
        return 0
    if how.low not in ("how", "that", "as") or not isinstance(_after(elements, i + 3), Mention):
        return 0
    out.append(Word(who.start, how.end, "adv", "heading"))
    return 3


def _after(elements: list[Element], i: int) -> Element | None:
    """The element at i, past small adverbs and a preposition."""
    while (w := word_at(elements, i)) is not None and w.kind in ("adv", "prep", "sub"):
        i += 1
    return elements[i] if i < len(elements) else None


def _leads_to(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "which leads to it falling", "This results in the vase falling": makes it fall."""
    lead, to = elements[i], word_at(elements, i + 1)
    if to is None:
        return 0
    thing, act = mention_at(elements, i + 2), elements[i + 3] if i + 3 < len(elements) else None
    if thing is None or not isinstance(act, Verb) or act.form != "ing":
        return 0
    this = isinstance(lead, Mention) and lead.head == "result" and lead.determiner in _THESE
    word = getattr(lead, "lemma", "") or getattr(lead, "low", "")
    if (word.removesuffix("s").removesuffix("ing"), to.low) not in _RESULTS and not this:
        return 0
    if (this and to.low != "in") or act.auxiliary or thing.attribute:
        return 0
    if this:
        assert isinstance(lead, Mention)
        here = lead.start + len(lead.determiner)
        out.append(Mention(lead.start, here, pronoun="this", text=lead.determiner))
    form = "ing" if word.endswith("ing") else "s"
    act.form = "base"
    out += [Verb(lead.start, to.end, "make", "cause", form), thing, act]
    return 4


def _cleft(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "It is only when a cat bumps it that a mug falls": when a cat bumps it, a mug falls."""
    it, be = mention_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    if it is None or it.pronoun != "it" or not isinstance(be, Verb) or be.sense != "be":
        return 0
    k = i + 2
    while (small := word_at(elements, k)) is not None and small.kind == "adv":
        k += 1
    sub = word_at(elements, k)
    if be.negated or sub is None or sub.kind != "sub" or (out and not _sentence_ends(out[-1])):
        return 0
    for n in range(k + 1, len(elements)):
        e = elements[n]
        if isinstance(e, Word) and e.low in ".;!?\n":
            return 0
        if isinstance(e, Word) and e.low == "that" and e.kind == "rel":
            elements[n] = Word(e.start, e.end, "punct", ",")
            return k - i
    return 0


def _sentence_ends(e: Element) -> bool:
    return isinstance(e, Word) and e.low in ".;!?\n:"


def _time_passes(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "three seconds pass and they bump", "once 2 s have passed": three seconds later."""
    when, span = word_at(elements, i), word_at(elements, i + 1)
    over = elements[i + 2] if i + 2 < len(elements) else None
    timed = span is not None and span.amount is not None and span.amount.dimension == "time"
    if when is not None and timed and when.low in ("once", "when", "after", "until"):
        assert span is not None
        if span.low.endswith(("passed", "elapsed", "gone by", "gone")):
            out += [Word(when.start, when.end, "prep", "after"), span]
            return 2
        aux = isinstance(over, Verb) and over.sense == "have" and word_at(elements, i + 3)
        gone = isinstance(over, Verb) and over.lemma in ("pass", "elapse", "go")
        past = bool(aux) and getattr(elements[i + 3], "low", "") in ("elapsed", "passed", "gone")
        if gone or past:
            assert span is not None
            used = 4 if past else 3
            by = word_at(elements, i + used)
            used += by is not None and by.low == "by"
            out += [Word(when.start, when.end, "prep", "after"), span]
            return used
    time, verb = word_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    if time is None or time.amount is None or time.amount.dimension != "time":
        return 0
    if not isinstance(verb, Verb) or verb.lemma not in ("pass", "elapse", "go") or verb.infinitive:
        return 0
    k = i + 2
    while (w := word_at(elements, k)) is not None and w.low in (
        "by",
        ",",
        "and",
        "before",
        "until",
        "then",
    ):
        k += 1
    if k == i + 2 or not isinstance(elements[k] if k < len(elements) else None, Mention):
        return 0
    out += [
        time,
        Word(verb.start, verb.end, "adv", "later"),
        Word(verb.end, verb.end, "punct", ","),
    ]
    return k - i
