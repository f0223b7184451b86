"""Elements at a place, and what patterns ask of them: properties of one, and of where it stands."""

from __future__ import annotations

from collections.abc import Callable
import itertools

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import finite_ahead
from esg.draft.grammar.rewrites.positions import picks, place_of
from esg.draft.text.elements import PARTING, Element, Mention, Verb, Word, element_at
from esg.draft.verbphrases import verb_readings

STOPS = ".;:!?\n"
_BLOWS = lex.word_set("blows (light verbs)")
_HITS = lex.word_set("hits (impacts)")
_TELLING = lex.word_set("telling (reports)")
_GOES_ON = lex.word_set("goes on")
_VERBLESS = lex.word_set("verbless")
_TURNED = lex.word_set("turned")
_ELAPSED = ("passed", "elapsed", "gone by", "gone")
_PEOPLE = ("er", "or", "ist", "ian", "ee", "man", "woman", "boy", "girl")
_LABELLED = lex.word_set("labelled")
_NO_ACTS = frozenset({"be", "have", "park"})
_MOVES_THINGS = frozenset({"launch", "roll", "slide", "tow", "carry", "knock", "fly"})
"""Senses of which the object goes somewhere."""
_MOVING = _MOVES_THINGS | lex.word_set("moving (frames)") | {"pass", "bounce", "reverse"}
_ALONG = lex.word_set("ways (sides)")
_APPROACHES = frozenset({"approach", "own", "roll", "slide", "reach"})


def word_at(elements: list[Element], i: int) -> Word | None:
    """The small word at a place, if one stands there."""
    e = element_at(elements, i)
    return e if isinstance(e, Word) else None


def mention_at(elements: list[Element], i: int) -> Mention | None:
    """The noun phrase at a place, if one stands there."""
    e = element_at(elements, i)
    return e if isinstance(e, Mention) else None


def verb_at(elements: list[Element], i: int) -> Verb | None:
    """The verb at a place, if one stands there."""
    e = element_at(elements, i)
    return e if isinstance(e, Verb) else None


def is_word(e: Element | None, *words: str) -> bool:
    """Whether an element is one of some small words."""
    return isinstance(e, Word) and e.low in words


def is_prep(e: Element) -> bool:
    """Whether an element is a preposition."""
    return isinstance(e, Word) and e.kind in ("prep", "to")


def finite(e: Element | None) -> Verb | None:
    """A main verb with a tense of its own."""
    if not isinstance(e, Verb) or e.infinitive or e.auxiliary or e.passive:
        return None
    return e if e.form in ("s", "past", "base") else None


def kind_of(e: Element) -> str:
    """The kind of thing that a noun phrase names; "" if the lexicon does not know."""
    return e.noun.kind if isinstance(e, Mention) and e.noun is not None else ""


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


def _word(e: Element) -> str:
    if isinstance(e, Word):
        return e.low
    return e.lemma if isinstance(e, Verb) else e.head or e.pronoun


def _stem(words: list[str]) -> str:
    return words[0].lower().removesuffix("s") if words else ""


def _dimension(e: Element) -> str:
    return e.amount.dimension if isinstance(e, Word) and e.amount is not None else ""


def _indefinite(e: Element) -> bool:
    """ "a leaf", "leaves"."""
    bare = isinstance(e, Mention) and not e.determiner and e.plural
    return bare or getattr(e, "determiner", "") in ("a", "an")


def _impact(e: Element) -> bool:
    """The name of a collision; "crash" and "smash" alone are read as unknown words."""
    if isinstance(e, Mention):
        plain = e.possessor is None and e.determiner != "no" and e.noun is None
        return e.attribute and e.head in _HITS and plain
    return isinstance(e, Word) and e.kind == "unknown" and e.low in _HITS


def colours(e: Element) -> list[str]:
    """What "red" or "a red one" says of one of several; nothing if it says something else."""
    if isinstance(e, Word):
        return [e.low] if e.low in lex.COLORS else []
    if not isinstance(e, Mention) or e.pronoun != "one":
        return []
    return [*e.adjectives] if set(e.adjectives) <= lex.COLORS.keys() else []


def _unknown(e: Element) -> Mention | None:
    """A noun that the lexicon does not know."""
    plain = isinstance(e, Mention) and not (e.noun or e.attribute or e.pronoun)
    return e if plain and isinstance(e, Mention) and e.head else None


def _incline(e: Element) -> bool:
    return isinstance(e, Mention) and e.noun is not None and "incline" in e.noun.traits


def _garment(e: Element) -> bool:
    """Clothes, of which nothing else is said, and spectacles."""
    if isinstance(e, Mention) and e.head == "glass" and e.plural:
        return "sun" in e.adjectives or not (e.determiner or e.count)
    if not isinstance(e, Mention) or e.amounts or e.possessor is not None or not e.head:
        return False
    if "-".join([*e.adjectives[-1:], e.head]) in lex.GARMENTS:
        return True  # "a bikini top"
    return "-".join(e.head.split()) in lex.GARMENTS or e.head.split()[-1] in lex.GARMENTS


def label_of(e: Element) -> list[str]:
    """The letter of "object A", "body B"."""
    if not isinstance(e, Mention):
        return []
    if len(e.head) == 1 and _LABELLED & {*e.adjectives}:
        return [e.head.upper()]
    return e.letters if e.head in _LABELLED else []


PROPERTIES: dict[str, Callable[[Element], object]] = {
    "thing": kind_of,
    "dimension": _dimension,
    "indefinite": _indefinite,
    "word": _word,
    "stem": lambda e: _stem([_word(e)]),
    "solid": lambda e: isinstance(e, Mention) and not e.attribute,
    "plain": lambda e: isinstance(e, Mention) and not (e.adjectives or e.possessor or e.amounts),
    "bare": lambda e: not (getattr(e, "determiner", "") or getattr(e, "adjectives", None)),
    "stop": lambda e: is_word(e, *STOPS),
    "turn": lambda e: _dimension(e) == "angle" and isinstance(e, Word) and "turn" in e.low,
    "person": lambda e: kind_of(e) == "person" and isinstance(e, Mention) and not e.attribute,
    "elapsed": lambda e: _dimension(e) == "time" and _word(e).endswith(_ELAPSED),
    "named": lambda e: isinstance(e, Mention) and bool(e.noun or e.pronoun or e.letters),
    "labelled": lambda e: bool(label_of(e)),
    "picked": picks,
    "place": place_of,
    "opposite": lambda e: bool({"other", "opposite", "far"} & {*getattr(e, "adjectives", ())}),
    "sided": lambda e: bool({"left", "right"} & {*getattr(e, "adjectives", ())}),
    "unknown": lambda e: _unknown(e) is not None,
    "acting": lambda e: isinstance(e, Mention) and e.head.endswith(_PEOPLE),
    "coloured": lambda e: bool(colours(e)),
    "impact": _impact,
    "reporter": lambda e: isinstance(e, Mention) and _stem(e.text.split()[-1:]) in _TELLING,
    "verbal": lambda e: isinstance(e, Word) and bool(verb_readings(e.low)),
    "incline": _incline,
    "garment": _garment,
    "none": lambda e: (
        isinstance(e, Mention) and e.text.lower().startswith(("none of", "neither of"))
    ),
}
"""What a test may name besides the fields of an element."""

Place = Callable[[list[Element], int, list[Element]], bool]
"""A condition on the elements, the place in them, and what was made of those before."""


def opens(_: list[Element], __: int, out: list[Element]) -> bool:
    """A sentence starts."""
    last = out[-1] if out else None
    return last is None or (isinstance(last, Word) and last.low in (*STOPS, "heading"))


def starts_clause(_: list[Element], __: int, out: list[Element]) -> bool:
    """A clause starts."""
    last = out[-1] if out else None
    if last is None or is_word(last, "heading", "then"):
        return True
    return isinstance(last, Word) and (
        last.kind in ("conj", "sub") or (last.kind == "punct" and last.low in '.;:,!?\n—–-)"”')
    )


def breaks(elements: list[Element], i: int, _: list[Element]) -> bool:
    """A clause ends."""
    e = element_at(elements, i)
    return e is None or (isinstance(e, Word) and e.kind in PARTING)


def ends(elements: list[Element], i: int, _: list[Element]) -> bool:
    """A sentence, or its part between commas, ends."""
    return i >= len(elements) or is_word(elements[i], *STOPS, ",", "-", "–", "—")


def _told(_: list[Element], __: int, out: list[Element]) -> bool:
    """Its sentence has told what something does."""
    for e in reversed(out):
        if is_word(e, ".", ";", "!", "?"):
            return False
        if isinstance(e, Verb) and e.sense not in _NO_ACTS:
            return True
    return False


def _near(_: list[Element], __: int, out: list[Element]) -> bool:
    """Two things are told of, of which one comes near the other."""
    near = [e for e in out[-12:] if isinstance(e, Verb)]
    return bool(near) and near[-1].sense in _APPROACHES


def _meeting(_: list[Element], __: int, out: list[Element]) -> bool:
    """Things go toward each other, and no contact of theirs is told."""
    told = any(isinstance(e, Verb) and e.sense in ("hit", "knock", "miss", "stop") for e in out)
    return not told and any(is_word(e, "each other") for e in out)


def _aside(_: list[Element], __: int, out: list[Element]) -> bool:
    """A participle may stand here: at the start of a clause, or joined to another one."""
    last = next((e for e in reversed(out) if getattr(e, "kind", "") != "adv"), None)
    if isinstance(last, Word) and last.kind == "conj":
        return any(isinstance(e, Verb) and "agent" in e.extra for e in out[-8:])
    return last is None or (isinstance(last, Word) and last.kind in ("punct", "sub"))


def _verbless(elements: list[Element], i: int, out: list[Element]) -> bool:
    """No verb tells the clause that starts here, nor its sentence, unless where something goes."""
    last = out[-1] if out else None
    begins = isinstance(last, Word) and (last.kind in ("punct", "conj") or last.low == "heading")
    if last is not None and not begins:
        return False
    for e in elements[i:]:
        if isinstance(e, Verb):
            return False
        if isinstance(e, Word) and e.kind in PARTING:
            break
    told = goes = False
    for e in reversed(out):
        if isinstance(e, Word) and e.kind in PARTING:
            if told or e.low in STOPS:
                break
            goes = False
        told = told or isinstance(e, Verb)
        goes = goes or is_word(e, *_VERBLESS)
    return goes or not told


def _after_verb(senses: frozenset[str]) -> Place:
    """The last verb of the sentence has one of some senses."""

    def after(_: list[Element], __: int, out: list[Element]) -> bool:
        for e in reversed(out):
            if is_word(e, *".!?\n"):
                return False
            if isinstance(e, Verb):
                return e.sense in senses and not e.passive
        return False

    return after


def _on_its_way(elements: list[Element], i: int, out: list[Element]) -> bool:
    """ "Slides along the table", "pushes the cup": the side that follows is where to."""
    before = out[-1] if out and getattr(elements[i], "pronoun", "") != "one" else None
    along = is_word(before, *_ALONG)
    verb = before if isinstance(before, Verb) else None
    if along:
        told = itertools.takewhile(lambda e: not is_word(e, *STOPS), reversed(out))
        verb = next((e for e in told if isinstance(e, Verb)), None)
    moving = verb is not None and verb.sense in _MOVING and not verb.passive
    return moving and (along or (verb is not None and verb.sense in _MOVES_THINGS))


def _turned(elements: list[Element], i: int, out: list[Element]) -> bool:
    """Nothing or only a place and a time follow "left"."""
    w = word_at(elements, i)
    return i >= len(elements) or (
        w is not None and (w.kind in ("punct", "conj") or w.low in _TURNED or w.amount is not None)
    )


PLACES: dict[str, Place] = {
    "opens": opens,
    "clause": starts_clause,
    "breaks": breaks,
    "ends": ends,
    "told": _told,
    "near": _near,
    "finite": lambda elements, i, _: finite_ahead(elements, i),
    "aside": _aside,
    "verbless": _verbless,
    "steered": _after_verb(lex.word_set("steered (ellipsis)")),
    "travelling": _after_verb(lex.word_set("travelling (ellipsis)")),
    "hit": _after_verb(frozenset({"hit"})),
    "meeting": _meeting,
    "alone": _after_verb(lex.word_set("alone")),
    "on things": _after_verb(lex.word_set("on things")),
    "turned": _turned,
    "on its way": _on_its_way,
    "goes on": lambda elements, i, out: breaks(elements, i, out) or bool(verb_at(elements, i)),
    "no phrase": lambda elements, i, _: i >= len(elements) or not is_word(elements[i], *_GOES_ON),
    "of": lambda elements, i, _: i < len(elements) and is_word(elements[i], "of"),
    "no verb": lambda elements, i, _: verb_at(elements, i) is None,
    "no object": lambda elements, i, _: mention_at(elements, i) is None,
}
"""What a pattern may ask of a place, in angle brackets."""
