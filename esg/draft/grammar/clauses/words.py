"""Small words and quantities between the nouns and verbs of a clause."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Phrase, State, finite_ahead
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.text.elements import Mention, Verb, Word

PROPERTIES = lex.word_set("properties")
OWNED = PROPERTIES | {"speed", "velocity"}
_BEFORE_AMOUNTS = frozenset({"of", "at", ",", "(", "about", "-", "–", "—"})
_PARTICLES = lex.word_set("particles (words)")
_AIMED = lex.word_set("aimed (words)")
_HAPPENING = lex.word_set("happening")
_SIZES = lex.word_set("sizes")


def read_word(c: Clauses, s: State, w: Word, i: int) -> State:
    if w.kind == "punct":
        if w.low in ".;!?\n":
            flush(c, s)
            c.sentence += 1
            new = State(main=s.main)
            return new
        stated = c.elements[i - 1] if i else None
        if w.low == ")" and isinstance(stated, Word) and stated.amount is not None:
            s.boundary, s.boundary_kind = False, ""  # "the block (2 kg) travelling at"
            return s
        if w.low in ",:-–—()":
            s.boundary, s.boundary_kind = True, "comma"
            s.prep = ""
        return s
    if w.kind == "conj":
        s.boundary, s.boundary_kind = True, "conj"
        if not (s.prep and s.last is None):
            s.prep = s.prep if s.prep and not isinstance(c.elements[i - 1], Mention) else ""
        return s
    if w.kind == "rel":
        s.relative = s.last
        s.boundary, s.boundary_kind = True, "rel"
        if w.low == "whose":
            s.boundary_kind = "whose"
        return s
    if w.kind == "sub":
        s.sub = w.low
        s.boundary, s.boundary_kind = True, "sub"
        s.prep = ""
        return s
    if id(w) in c.told:
        return s
    if w.kind in ("prep", "to"):
        nxt = c.elements[i + 1] if i + 1 < len(c.elements) else None
        ends = ("punct", "conj", "sub", "rel")
        if nxt is None or (
            isinstance(nxt, Word) and (nxt.kind in ends or nxt.low in ("too", "again"))
        ):
            if getattr(nxt, "kind", "") == "rel" and getattr(nxt, "low", "") in (
                "which",
                "whom",
            ):
                s.relative_prep = w.low  # "a rack from which a box falls"
            elif s.frame is not None and not _of_what_went_before(s, w):
                s.frame.adverbs.append(w.low)  # a particle: "knocking them over"
            return s
        if w.low in _PARTICLES and isinstance(nxt, Word) and nxt.kind in ("prep", "to"):
            if s.frame is not None and nxt.amount is None:
                s.frame.adverbs.append(w.low)  # "slides off onto the road"
            return s
        s.prep = w.low
        return s
    if id(w) in c.told:
        return s
    if w.kind == "qty" and w.amount is not None and _belongs_to_noun(c, s, w, i):
        return s
    if w.kind == "qty" and w.amount is not None and _fronted_size(c, w, i):
        return s
    if w.kind == "qty" and w.amount is not None:
        phrase = Phrase(s.prep, None, w.amount)
        nxt = c.elements[i + 1] if i + 1 < len(c.elements) else None
        if w.amount.dimension == "time" and s.boundary and _set_off_by_commas(c, i):
            phrase.prep = s.prep or "after"
            s.loose.append(phrase)  # "and, a good three seconds on, hits"
            s.prep = ""
            return s
        if isinstance(nxt, Word) and nxt.low in ("later", "afterwards", "afterward"):
            phrase.prep = "after"
            rest = c.elements[i + 2 : i + 4]
            acts = isinstance(rest[0] if rest else None, Verb) and s.boundary_kind == "conj"
            if s.boundary and (acts or getattr(rest[0] if rest else None, "low", "") == ","):
                s.loose.append(phrase)  # "and, 1.5 s later, crashes"
                s.prep = ""
                return s
        link = c.elements[i - 2] if i >= 2 else None
        joined = isinstance(link, Word) and link.kind == "conj" and s.prep == "after"
        if w.amount.dimension == "time" and joined and isinstance(nxt, Verb):
            s.loose.append(phrase)  # "accelerates and after 2 s hits"
            s.prep = ""
            return s
        pair = i >= 2 and isinstance(c.elements[i - 2], Word)
        pair = pair and getattr(c.elements[i - 2], "amount", None) is not None
        told = s.frame is not None and s.frame.relative and s.frame.verb.sense in _HAPPENING
        if phrase.prep == "after" and s.frame is not None and s.frame.reduced and not told:
            main = s.frame.parent or s.main
            if main is not None and isinstance(nxt, Word) and not _more_told(c, i):
                main.phrases.append(phrase)  # "hits a block lying there 5 seconds later"
                s.prep = ""
                return s
        if s.frame is not None and (
            pair or not (s.boundary and finite_ahead(c.elements, i + 1) and not s.prep)
        ):
            fronted = s.boundary_kind == "comma" or _opens_clause(c, i)
            if s.boundary and fronted and finite_ahead(c.elements, i + 1):
                s.loose.append(phrase)
            else:
                s.frame.phrases.append(phrase)
        else:
            s.loose.append(phrase)
        s.prep = ""
        return s
    if (
        w.kind == "unknown"
        and s.frame is not None
        and s.frame.verb.sense == "be"
        and not s.boundary
    ):
        s.frame.adverbs.append(w.low)
        return s
    if w.kind == "unknown" and w.low in ("suppose", "imagine", "picture", "consider"):
        return s
    if w.kind == "adv":
        if w.low in ("then", "next", "simultaneously", "meanwhile") and w.low != "next":
            s.link = w.low if w.low in ("simultaneously", "meanwhile") else "then"
            if w.low == "then" and s.boundary_kind != "rel":
                s.boundary, s.boundary_kind = (
                    True,
                    "conj" if s.boundary_kind != "comma" else "comma",
                )
            if (
                s.frame is not None
                and w.low == "simultaneously"
                and not finite_ahead(c.elements, i + 1)
            ):
                s.frame.adverbs.append(w.low)
                s.frame.link = "simultaneously"
            return s
        if w.low in ("each other", "one another"):
            s.prep = ""  # "20 cm from each other and ..."
        side = w.low in ("left", "right")
        if s.frame is not None and (side or not (s.boundary and finite_ahead(c.elements, i + 1))):
            s.frame.adverbs.append(w.low)
        else:
            s.loose.append(w.low)
        return s
    return s


def _set_off_by_commas(c: Clauses, i: int) -> bool:
    """Whether a time stands between commas and a verb follows."""
    verb = c.elements[i + 2] if i + 2 < len(c.elements) else None
    before = next((e for e in reversed(c.elements[:i]) if getattr(e, "kind", "") != "prep"), None)
    commas = getattr(before, "low", "") == "," and _next_low(c, i + 1) == ","
    finite = isinstance(verb, Verb) and verb.form in ("s", "past") and not verb.infinitive
    return commas and finite


def _opens_clause(c: Clauses, i: int) -> bool:
    """ "and after 2 s a box falls": a time between a conjunction and the next subject."""
    before = c.elements[i - 2] if i >= 2 else None
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
    before = c.elements[i - 2] if i >= 2 else None
    listed = isinstance(before, Word) and before.amount is not None
    known = c.quantified.amounts if c.quantified is not None else []
    if isinstance(before, Word) and c.quantified is not None and before.amount in known:
        size = _size_word(c, i) or w.amount.measure or ("size" if w.amount.sides else "")
        if size and w.amount.dimension == "length":
            c.quantified.adjectives.append(f"@{w.amount.start}:{size}")
            c.quantified.amounts.append(w.amount)
            return True
    if not listed or s.frame is None or s.frame.verb.sense not in ("weigh", "measure", "have"):
        return False
    owner, size = s.frame.subject, _size_word(c, i) or w.amount.measure
    size = size or ("size" if w.amount.sides else "")
    if owner is None or not size or w.amount.dimension != "length":
        return False
    owner.adjectives.append(f"@{w.amount.start}:{size}")
    owner.amounts.append(w.amount)
    return True


def _size_word(c: Clauses, i: int) -> str:
    """ "wide" of "1 m wide", "diameter" of "2 cm in diameter"."""
    after = c.elements[i + 1] if i + 1 < len(c.elements) else None
    if isinstance(after, Word) and after.low in ("in", "of") and i + 2 < len(c.elements):
        measure = c.elements[i + 2]
        if isinstance(measure, Mention) and measure.attribute and measure.head in PROPERTIES:
            c.told.update((id(after), id(measure)))
            return measure.head
    word = getattr(after, "low", "") or getattr(after, "head", "")
    return word if word in _SIZES else ""


def _fronted_size(c: Clauses, w: Word, i: int) -> bool:
    """ "Two metres tall, the bookcase topples": a property before its noun."""
    assert w.amount is not None
    before = c.elements[i - 1] if i else None
    opens = before is None or (isinstance(before, Word) and before.low in ".;!?:")
    heavy = w.amount.dimension == "mass" and _next_low(c, i + 1) in ("heavy", "in")
    size = _size_word(c, i) if w.amount.dimension == "length" else ""
    if not opens or not (heavy or size):
        return False
    comma = next((k for k in range(i + 1, i + 4) if _next_low(c, k) in (",", ":")), 0)
    noun = c.elements[comma + 1] if comma and comma + 1 < len(c.elements) else None
    if not isinstance(noun, Mention) or noun.pronoun or noun.attribute:
        return False
    if size:
        noun.adjectives.append(f"@{w.amount.start}:{size}")
    noun.amounts.append(w.amount)
    return True


def _next_low(c: Clauses, i: int) -> str:
    return getattr(c.elements[i], "low", "") if i < len(c.elements) else ""


def _belongs_to_noun(c: Clauses, s: State, w: Word, i: int) -> bool:
    """ "a ball of 2 kg", "the van (3 tons)": a property of the noun before."""
    assert w.amount is not None
    if _in_list(c, s, w, i):
        return True
    previous = c.elements[i - 1] if i else None
    before = c.elements[i - 2] if i >= 2 else None
    if i >= 3 and isinstance(before, Word) and before.low in _SIZES:
        before = c.elements[i - 3]  # "20 cm thick and 2 m high"
    if (
        isinstance(previous, Word)
        and previous.kind == "conj"
        and isinstance(before, Word)
        and before.amount is not None
        and c.quantified is not None
        and before.amount in c.quantified.amounts
    ):
        c.quantified.amounts.append(w.amount)
        if size := _size_word(c, i):
            c.quantified.adjectives.append(f"@{w.amount.start}:{size}")
        return True
    noun = before if isinstance(previous, Word) and previous.low in _BEFORE_AMOUNTS else previous
    if not isinstance(noun, Mention):
        return False
    sized = noun.pronoun == "one" and noun.determiner == "the" and _size_word(c, i) != ""
    if noun.pronoun and not (sized and w.amount.dimension == "length"):
        return False
    if noun.attribute:
        of = isinstance(previous, Word) and previous.low == "of"
        if noun.possessor is not None or (w.amount.dimension == "time" and not of):
            return False  # "to the right within 6 s"
        noun.amounts.append(w.amount)
        s.prep = ""
        return True
    inclined = noun.noun is not None and "incline" in noun.noun.traits
    if inclined and w.amount.dimension == "angle":
        noun.amounts.append(w.amount)  # "a slope of 15 degrees"
        s.prep = ""
        return True
    if w.amount.dimension not in ("mass", "length", "volume") or (
        isinstance(previous, Word) and previous.low == "at"
    ):
        return False
    size = _size_word(c, i) if w.amount.dimension == "length" else ""
    size = size or w.amount.measure or ("size" if w.amount.sides else "")
    of = isinstance(previous, Word) and previous.low in ("of", "(")
    if w.amount.dimension == "length" and not of and not size:
        return False
    if (
        s.frame is not None
        and s.frame.verb.sense in ("weigh", "measure", "be", "have")
        and noun is s.frame.subject
    ):
        return False
    if size:
        noun.adjectives.append(f"@{w.amount.start}:{size}")
    noun.amounts.append(w.amount)
    c.quantified = noun
    s.prep = ""
    return True


def _of_what_went_before(s: State, w: Word) -> bool:
    """ "a log, which it drives into": the preposition of the object in front."""
    f = s.frame
    if f is None or f.object is None or f.object is not s.relative or w.low not in _AIMED:
        return False
    f.phrases.append(Phrase(w.low, f.object))
    f.object = None
    return True


def flush(c: Clauses, s: State) -> None:
    for item in s.loose:
        if not isinstance(item, Phrase) or item.amount is None:
            continue
        if s.frame is not None:
            s.frame.phrases.append(item)
        elif s.subject is not None and item.amount.dimension in ("speed", "mass"):
            item.prep = item.prep or "at"
            c.attachments.append((s.subject, item))  # "Jogger at 3 m/s.", "Truck, 9 m/s."
    s.loose = []
