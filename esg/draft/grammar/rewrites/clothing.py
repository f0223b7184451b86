"""Clothes that are drawn: taken off the text, and told of who wears them.

What the table of garments knows ("a man in a black t-shirt", "a dog wearing a hat and sunglasses",
"a girl with red hair", "she wears a coat") is put down at the noun phrase of the wearer (`Put`),
and its words go. What it does not know, and what is named again, is left to `rewrites.csv`.
"""

from __future__ import annotations

from dataclasses import dataclass

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import PROPERTIES
from esg.draft.text.elements import Element, Mention, Put, Verb, Word, element_at
from esg.lexicon.garments import Garment, read, wearers

_DRESSED = lex.word_set("dressed") | {"dressed", "clad"}
_WITH = frozenset({"in", "with"})
_AGAIN = frozenset({"the", "his", "her", "its", "their", "that", "this"})
"""Determiners of what was named before."""
_OWN = frozenset({"his", "her", "its", "their", "the"})
_BEFORE = frozenset({",", "and", "while", "when"})
_PLACES = frozenset({"on", "over", "around", "across", "round"})
_BODY = frozenset({"head", "back", "face", "neck", "shoulder", "hand", "foot", "eye", "nose",
                   "waist", "body", "brow", "chest"})  # fmt: skip
_PEOPLE = frozenset({"he", "she", "they", "him", "her", "them", "who"})


@dataclass(frozen=True)
class _Phrase:
    """Words that tell what somebody wears.

    Args:
        puts: What is worn.
        items: Their noun phrases.
        end: The first element behind it.
        verb: A finite verb that says so, and which stays; None where all of it goes.
    """

    puts: tuple[Put, ...]
    items: tuple[Mention, ...]
    end: int
    verb: Verb | None = None


def put_on(elements: list[Element]) -> list[Element]:
    """Tells wearers what they wear, and leaves its words out.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    if not any(_bare_word(e) or _garment(e) for e in elements):
        return elements
    again = _named_again(elements)
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        out.append(e)
        i += 1
        while isinstance(e, Mention) and (found := _phrase(elements, i, e, again)) is not None:
            e.wears += found.puts
            if found.verb is not None:
                out.append(found.verb)
                for item in found.items:
                    item.attribute = True
                    out.append(item)
            i = found.end
        if isinstance(e, Verb) and _participle(e):
            i = _detached(elements, i, e, out, again)
    return out


def _garment(e: Element) -> Garment | None:
    """What a noun phrase names of what can be worn."""
    if not isinstance(e, Mention) or e.amounts or e.possessor is not None or not e.head:
        return None
    if (e.count or 1) > 1 or e.pronoun:
        return None
    worn = read(e.text, lex.COLORS)
    return None if worn is None else worn.garment


def _bare_word(e: Element) -> bool:
    """ "In black", "in uniform": a word without an article that no noun phrase took up."""
    if not isinstance(e, Word) or e.kind != "unknown":
        return False
    return e.low in lex.COLORS or read(e.low, lex.COLORS) is not None


def _named_again(elements: list[Element]) -> frozenset[str]:
    """Heads of garments that something else is told of: "his hat falls off"."""
    out: set[str] = set()
    for i, e in enumerate(elements):
        before = element_at(elements, i - 1)
        led = isinstance(before, Word) and before.low in _WITH
        led |= isinstance(before, Verb) and before.lemma in _DRESSED
        if isinstance(e, Mention) and not led and (e.determiner in _AGAIN or e.possessor):
            out.add(e.head)
    return frozenset(out)


def _dresses(e: Element, garment: Garment) -> bool:
    """Whether who a noun phrase means can be drawn with a garment."""
    if not isinstance(e, Mention) or e.attribute:
        return False
    if e.pronoun or e.noun is None:
        return e.text.lower() in _PEOPLE and "people" in garment.on
    return bool(wearers().get(e.noun.name, frozenset()) & garment.on)


def _phrase(elements: list[Element], i: int, who: Mention, again: frozenset[str]) -> _Phrase | None:
    """What is said of a wearer from a place on."""
    start = i
    comma = _low(elements, i) == ","
    i += comma
    relative = _low(elements, i) in ("who", "that", "which")
    i += relative
    e = element_at(elements, i)
    verb: Verb | None = None
    if isinstance(e, Verb) and e.lemma in _DRESSED and not e.negated and not e.modal:
        plain = relative or _participle(e)
        verb = None if plain else e
        i += 1
        i += _low(elements, i) == "in"
    elif isinstance(e, Word) and e.low in _WITH and not relative:
        i += 1
    else:
        return None
    if verb is not None and comma:
        return None
    span = (e.start, e.end) if isinstance(e, Verb) else None
    found = _items(elements, i, who, again, span)
    if found is None:
        return None
    puts, items, i = found
    if verb is not None:
        if _low(elements, i) == "and" and isinstance(element_at(elements, i + 1), Verb):
            return _Phrase(puts, items, i + 1)
        return _Phrase(puts, items, i, verb)
    i += comma and _low(elements, i) == "," and start > 0
    return _Phrase(puts, items, i)


def _items(
    elements: list[Element],
    i: int,
    who: Mention,
    again: frozenset[str],
    verb: tuple[int, int] | None,
) -> tuple[tuple[Put, ...], tuple[Mention, ...], int] | None:
    """A list of garments: what is put on, its noun phrases, and where it ends."""
    e = element_at(elements, i)
    if isinstance(e, Word):
        phrase = f"{e.low} clothes" if e.low in lex.COLORS else e.low if e.kind == "unknown" else ""
        one = read(phrase, lex.COLORS)
        plain = not isinstance(element_at(elements, i + 1), Mention)
        if one is None or not plain or not _dresses(who, one.garment):
            return None
        return (Put(phrase, e.start, e.end, verb),), (), i + 1
    puts, items, end = list[Put](), list[Mention](), i
    while isinstance(e := element_at(elements, i), Mention):
        garment = _garment(e)
        drawn = garment is not None and _dresses(who, garment)
        listed = puts or verb is not None  # of a list all goes, and what is not drawn is missed
        if e.head in again or not (drawn or (listed and PROPERTIES["garment"](e))):
            break
        if drawn:
            items.append(e)
        end = i = _on_him(elements, i + 1)
        if drawn:  # with "on his head"
            last = elements[i - 1].end
            puts.append(Put(e.text, e.end - len(e.text), last, verb))
        i += _low(elements, i) == ","
        i += _low(elements, i) in ("and", "with")
        if i == end:
            break
    return (tuple(puts), tuple(items), end) if puts else None


def _on_him(elements: list[Element], i: int) -> int:
    """Where "on his head", or "on", behind a garment ends."""
    place = element_at(elements, i + 1)
    if _low(elements, i) in _PLACES and isinstance(place, Mention):
        own = place.determiner in _OWN and lex.singular(place.head)[0] in _BODY
        return i + 2 if own else i
    return i + (_low(elements, i) == "on" and isinstance(place, Verb))


def _participle(e: Verb) -> bool:
    """Whether a verb is "wearing" or "dressed", and no finite one."""
    reduced = e.form in ("ing", "pp") and not e.auxiliary
    return e.lemma in _DRESSED and (reduced or e.lemma in ("dressed", "clad")) and not e.negated


def _detached(
    elements: list[Element], i: int, verb: Verb, out: list[Element], again: frozenset[str]
) -> int:
    """ "A girl hits a pole wearing a hat": told of who hits; where what is left goes on."""
    told = [k for k, e in enumerate(out[:-1]) if isinstance(e, Verb)]
    subject = (
        next((e for e in reversed(out[: told[-1]]) if isinstance(e, Mention)), None)
        if told
        else None
    )
    if subject is None:
        return i
    span = (verb.start, verb.end)
    found = _items(elements, i + (_low(elements, i) == "in"), subject, again, span)
    if found is None:
        return i
    subject.wears += found[0]
    out.remove(verb)
    while out and isinstance(out[-1], Word) and out[-1].low in _BEFORE:
        out.pop()
    return found[2]


def _low(elements: list[Element], i: int) -> str:
    e = element_at(elements, i)
    return e.low if isinstance(e, Word) else ""
