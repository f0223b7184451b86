"""Small words and quantities between the nouns and verbs of a clause."""

from __future__ import annotations

from collections.abc import Callable

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Phrase, State, finite_ahead
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.text.elements import PARTING, Element, Mention, Verb, Word, element_at
from esg.draft.text.quantities import Amount

PROPERTIES = lex.word_set("properties")
_PLACES = lex.word_set("places of acts")
OWNED = PROPERTIES | {"speed", "velocity"}
_BEFORE_AMOUNTS = frozenset({"of", "at", ",", "(", "about", "-", "–", "—"})
_PARTICLES = lex.word_set("particles (words)")
_HAPPENING = lex.word_set("happening")
_SIZES = lex.word_set("sizes")


def read_word(c: Clauses, s: State, w: Word, i: int) -> State:
    """Reads a small word or a quantity; the state after it."""
    if id(w) in c.told and w.kind not in PARTING:
        return s
    reader = READERS.get(w.kind)
    return s if reader is None else reader(c, s, w, i) or s


def _punctuation(c: Clauses, s: State, w: Word, i: int) -> State | None:
    if w.low in ".;!?\n":
        flush(c, s)
        c.sentence += 1
        return State(main=s.main)
    stated = element_at(c.elements, i - 1)
    if w.low == ")" and isinstance(stated, Word) and stated.amount is not None:
        s.boundary, s.boundary_kind = False, ""  # "the block (2 kg) travelling at"
    elif w.low in ",:-–—()":
        s.boundary, s.boundary_kind = True, "comma"
        s.prep = ""
    return None


def _conjunction(c: Clauses, s: State, w: Word, i: int) -> None:
    s.boundary, s.boundary_kind = True, "conj"
    open_ = bool(s.prep) and s.last is None
    if not open_ and isinstance(c.elements[i - 1], Mention):
        s.prep = ""


def _relative(c: Clauses, s: State, w: Word, i: int) -> None:
    s.relative = s.last
    s.boundary, s.boundary_kind = True, "whose" if w.low == "whose" else "rel"


def _subordinator(c: Clauses, s: State, w: Word, i: int) -> None:
    s.sub, s.prep = w.low, ""
    s.boundary, s.boundary_kind = True, "sub"


def _preposition(c: Clauses, s: State, w: Word, i: int) -> None:
    nxt = element_at(c.elements, i + 1)
    small = nxt if isinstance(nxt, Word) else None
    plain = small is not None and small.end - small.start == len(small.low)
    if small is not None and small.kind == "adv" and plain and w.low in _PARTICLES:
        rest = element_at(c.elements, i + 2)  # "yanks it out sideways and the rest falls"
        small = rest if isinstance(rest, Word) and _ends_phrase(rest) else small
    if nxt is None or (small is not None and _ends_phrase(small)):
        if small is not None and small.kind == "rel" and small.low in ("which", "whom"):
            s.relative_prep = w.low  # "a rack from which a box falls"
        elif s.frame is not None:
            s.frame.adverbs.append(w.low)  # a particle: "knocking them over"
    elif w.low in _PARTICLES and small is not None and small.kind in ("prep", "to"):
        if s.frame is not None and small.amount is None:
            s.frame.adverbs.append(w.low)  # "slides off onto the road"
    else:
        s.prep = w.low


def _ends_phrase(w: Word) -> bool:
    return w.kind in PARTING or w.low in ("too", "again")


def _quantity(c: Clauses, s: State, w: Word, i: int) -> None:
    if w.amount is None or _belongs_to_noun(c, s, w, i):
        return
    phrase = Phrase(s.prep, None, w.amount)
    owner = _time_apart(c, s, phrase, i)
    if owner is None and s.frame is not None:
        link = element_at(c.elements, i - 2)
        pair = isinstance(link, Word) and link.amount is not None
        ahead = s.boundary and finite_ahead(c.elements, i + 1)
        fronted = s.boundary_kind == "comma" or _opens_clause(c, i)
        if (pair or s.prep or not ahead) and not (ahead and fronted):
            owner = s.frame.phrases
    (s.loose if owner is None else owner).append(phrase)
    s.prep = ""


def _time_apart(
    c: Clauses, s: State, phrase: Phrase, i: int
) -> list[Phrase] | list[Phrase | Amount | str] | None:
    """Where a time goes that is not of its own clause; None for the usual place."""
    assert phrase.amount is not None
    nxt = element_at(c.elements, i + 1)
    timed = phrase.amount.dimension == "time"
    if timed and s.boundary and _set_off_by_commas(c, i):
        phrase.prep = s.prep or "after"
        return s.loose  # "and, a good three seconds on, hits"
    if isinstance(nxt, Word) and nxt.low in ("later", "afterwards", "afterward"):
        phrase.prep = "after"
        rest = element_at(c.elements, i + 2)
        acts = isinstance(rest, Verb) and s.boundary_kind == "conj"
        if s.boundary and (acts or getattr(rest, "low", "") == ","):
            return s.loose  # "and, 1.5 s later, crashes"
    link = element_at(c.elements, i - 2)
    joined = isinstance(link, Word) and link.kind == "conj" and s.prep == "after"
    if timed and joined and isinstance(nxt, Verb):
        return s.loose  # "accelerates and after 2 s hits"
    told = s.frame is not None and s.frame.relative and s.frame.verb.sense in _HAPPENING
    if phrase.prep == "after" and s.frame is not None and s.frame.reduced and not told:
        main = s.frame.parent or s.main
        if main is not None and isinstance(nxt, Word) and not _more_told(c, i):
            return main.phrases  # "hits a block lying there 5 seconds later"
    return None


def _unknown(c: Clauses, s: State, w: Word, i: int) -> None:
    if s.frame is not None and s.frame.verb.sense == "be" and not s.boundary:
        s.frame.adverbs.append(w.low)


def _adverb(c: Clauses, s: State, w: Word, i: int) -> None:
    ahead = finite_ahead(c.elements, i + 1)
    if w.low in ("then", "simultaneously", "meanwhile"):
        s.link = w.low
        if w.low == "then" and s.boundary_kind != "rel":
            s.boundary = True
            s.boundary_kind = "conj" if s.boundary_kind != "comma" else "comma"
        if s.frame is not None and w.low == "simultaneously" and not ahead:
            s.frame.adverbs.append(w.low)
            s.frame.link = "simultaneously"
        return
    if w.low in ("each other", "one another"):
        s.prep = ""  # "20 cm from each other and ..."
    own = w.low in ("left", "right") or not (s.boundary and ahead)
    (s.frame.adverbs if s.frame is not None and own else s.loose).append(w.low)


READERS: dict[str, Callable[[Clauses, State, Word, int], State | None]] = {
    "punct": _punctuation,
    "conj": _conjunction,
    "rel": _relative,
    "sub": _subordinator,
    "prep": _preposition,
    "to": _preposition,
    "qty": _quantity,
    "unknown": _unknown,
    "adv": _adverb,
}
"""What a small word does, by its kind; a reader that begins a sentence returns its state."""


def _set_off_by_commas(c: Clauses, i: int) -> bool:
    """Whether a time stands between commas and a verb follows."""
    verb = element_at(c.elements, i + 2)
    before = next((e for e in reversed(c.elements[:i]) if getattr(e, "kind", "") != "prep"), None)
    commas = getattr(before, "low", "") == "," and _next_low(c, i + 1) == ","
    finite = isinstance(verb, Verb) and verb.form in ("s", "past") and not verb.infinitive
    return commas and finite


def _opens_clause(c: Clauses, i: int) -> bool:
    """ "and after 2 s a box falls": a time between a conjunction and the next subject."""
    before = element_at(c.elements, i - 2)
    subject = next((e for e in c.elements[i + 1 :] if getattr(e, "low", "") != ","), None)
    joined = isinstance(before, Word) and before.kind == "conj"
    now = isinstance(subject, Verb) and subject.form in ("s", "past") and not subject.auxiliary
    return joined and (isinstance(subject, Mention) or now)  # "and after 2 s hits it"


def _more_told(c: Clauses, i: int) -> bool:
    """Whether a verb follows in the same clause."""
    for e in c.elements[i + 1 :]:
        if isinstance(e, Verb):
            return True
        if isinstance(e, Word) and (e.kind in ("conj", "sub") or e.low in ".;,!?"):
            return False
    return False


def _in_list(c: Clauses, s: State, w: Word, i: int) -> bool:
    """ "a crate weighing 40 kg, 1 m wide, ...": one more property of the same noun."""
    assert w.amount is not None
    before = element_at(c.elements, i - 2)
    listed = isinstance(before, Word) and before.amount is not None
    known = c.quantified.amounts if c.quantified is not None else []
    if isinstance(before, Word) and c.quantified is not None and before.amount in known:
        size = _size_word(c, i) or _own_measure(w.amount)
        if size and w.amount.dimension == "length":
            c.quantified.adjectives.append(f"@{w.amount.start}:{size}")
            c.quantified.amounts.append(w.amount)
            return True
    if not listed or s.frame is None or s.frame.verb.sense not in ("weigh", "measure", "have"):
        return False
    owner, size = s.frame.subject, _size_word(c, i) or _own_measure(w.amount)
    if owner is None or not size or w.amount.dimension != "length":
        return False
    owner.adjectives.append(f"@{w.amount.start}:{size}")
    owner.amounts.append(w.amount)
    return True


def _size_word(c: Clauses, i: int) -> str:
    """ "wide" of "1 m wide", "diameter" of "2 cm in diameter"."""
    after = element_at(c.elements, i + 1)
    if isinstance(after, Word) and after.low in ("in", "of"):
        measure = element_at(c.elements, i + 2)
        if isinstance(measure, Mention) and measure.attribute and measure.head in PROPERTIES:
            c.told.update((id(after), id(measure)))
            return measure.head
    word = getattr(after, "low", "") or getattr(after, "head", "")
    return word if word in _SIZES else ""


def _own_measure(amount: Amount) -> str:
    """What a quantity says by itself that it measures: "size" of "2 by 3 m"."""
    return amount.measure or ("size" if amount.sides else "")


def _before_link(c: Clauses, i: int) -> Element | None:
    """What stands before the "and" before a quantity, without the size of "20 cm thick and 2 m"."""
    before = element_at(c.elements, i - 2)
    sized = isinstance(before, Word) and before.low in _SIZES
    return element_at(c.elements, i - 3) if sized else before


def _next_low(c: Clauses, i: int) -> str:
    return getattr(element_at(c.elements, i), "low", "")


def _belongs_to_noun(c: Clauses, s: State, w: Word, i: int) -> bool:
    """ "a ball of 2 kg", "the van (3 tons)": a property of the noun before."""
    assert w.amount is not None
    if _in_list(c, s, w, i) or _one_more(c, w, i):
        return True
    previous = element_at(c.elements, i - 1)
    link = previous.low if isinstance(previous, Word) else ""
    noun = _before_link(c, i) if link in _BEFORE_AMOUNTS else previous
    if not isinstance(noun, Mention):
        return False
    size, dimension = _size_word(c, i), w.amount.dimension
    one = noun.pronoun == "one" and noun.determiner == "the" and size and dimension == "length"
    if noun.pronoun and not one:
        return False
    inclined = noun.noun is not None and "incline" in noun.noun.traits
    if noun.attribute:
        if noun.possessor is not None or (dimension == "time" and link != "of"):
            return False  # "to the right within 6 s"
    elif not (inclined and dimension == "angle"):  # "a slope of 15 degrees"
        size = size if dimension == "length" else ""
        size = size or _own_measure(w.amount)
        if not _is_property(s, w, noun, link, size):
            return False
        if size:
            noun.adjectives.append(f"@{w.amount.start}:{size}")
        c.quantified = noun
    noun.amounts.append(w.amount)
    s.prep = ""
    return True


def _is_property(s: State, w: Word, noun: Mention, link: str, size: str) -> bool:
    """Whether a mass, a length or a volume is one of the noun it follows."""
    assert w.amount is not None
    if w.amount.dimension not in ("mass", "length", "volume") or link == "at":
        return False
    if w.amount.dimension == "length" and link not in ("of", "(") and not size:
        return False
    told = s.frame is not None and s.frame.verb.sense in ("weigh", "measure", "be", "have")
    return not (told and s.frame is not None and noun is s.frame.subject)


def _one_more(c: Clauses, w: Word, i: int) -> bool:
    """ "a crate of 40 kg and 1 m": one more quantity of the noun that the last was of."""
    assert w.amount is not None
    link, before = element_at(c.elements, i - 1), _before_link(c, i)
    if not (isinstance(link, Word) and link.kind == "conj" and isinstance(before, Word)):
        return False
    noun = c.quantified
    if noun is None or before.amount is None or before.amount not in noun.amounts:
        return False
    noun.amounts.append(w.amount)
    if size := _size_word(c, i):
        noun.adjectives.append(f"@{w.amount.start}:{size}")
    return True


def _placed_by(c: Clauses, first: Mention, phrase: Phrase, told: int) -> list[Mention]:
    """Both of "a cup and a spoon on a tray": what is listed before a place and behind the last.

    Args:
        c: What is read; without an "and" only the last of a list is there.
        first: The first of the list.
        phrase: The place.
        told: Where the place before it ends in the text.
    """
    if phrase.mention is None or phrase.prep not in _PLACES:
        return []
    end = phrase.mention.start
    listed = [m for m in (first, *first.coordinated) if told <= m.start and m.end < end]
    last = [m.start for m in listed[-1:]]
    words = (e for e in c.elements if isinstance(e, Word) and e.low in ("and", "&"))
    joined = any(m.end <= w.start < at for w in words for m in listed[-2:-1] for at in last)
    return listed if joined else listed[-1:]


def flush(c: Clauses, s: State) -> None:
    told = 0
    for item in s.loose:
        if not isinstance(item, Phrase):
            continue
        if item.mention is not None and s.frame is None and s.subject is not None:
            c.attachments += [(m, item) for m in _placed_by(c, s.subject, item, told)]
            told = item.mention.end
        if item.amount is None:
            continue
        if s.frame is not None:
            s.frame.phrases.append(item)
        elif s.subject is not None and item.amount.dimension in ("speed", "mass"):
            item.prep = item.prep or "at"
            c.attachments.append((s.subject, item))  # "Jogger at 3 m/s.", "Truck, 9 m/s."
    s.loose = []
