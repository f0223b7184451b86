"""Constructions as rows of `data/rewrites.csv`: a pattern of elements and what stands for them.

A pattern is a row of items: `M` a noun phrase, `V` a verb, `W` a small word, `E` any of them,
`"of|in"` one of some small words, `BLOW` the noun of a contact, `<opens>` a condition on the place.
Tests stand in brackets (`V[lemma=@giving, !passive]`; `@giving` is a word set), a name in front
(`who:M`), `?` or `*` behind; what follows `/` must match but is left as it is.

A result lists named elements (`who`), with changes (`v[form=s, !negated]`), verbs (`hit.s@v`: v as
"hits"; `=b.s`: the verb of a blow), words (`adv/heading@who-v`: over that stretch; `conj/and`:
without a place of its own; `@+who`: behind it), pronouns (`they/`) and the last verb (`again`).
"""

from __future__ import annotations

from collections.abc import Callable
import csv
from dataclasses import dataclass, replace
from functools import cache, partial
import re
from typing import Literal

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import PLACES, PROPERTIES, blow_at, colours
from esg.draft.grammar.rewrites.positions import put
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.verbphrases import verb_readings

WordKind = Literal["adv", "conj", "prep", "sub", "rel", "punct"]

_ITEM = re.compile(
    r'(?:(?P<name>[a-z]\w*):)?(?:(?P<type>[A-Z]+)|"(?P<low>[^"]+)"|<(?P<place>[^>]+)>)'
    r"(?:\[(?P<tests>[^\]]*)\])?(?P<many>[?*])?|/"
)
_MADE = re.compile(
    r"(?P<aside>~?)(?P<what>=?[a-z]\w*)(?:\.(?P<form>\w+))?(?P<word>/(?P<low>[^@\s\[]*))?"
    r"(?:@(?P<after>\+)?(?P<first>\w+)(?:-(?P<last>\w+))?)?(?:\[(?P<changes>[^\]]*)\])?"
)
_TEST = re.compile(r"(?P<no>!?)(?P<name>\w+)(?P<differs>!?)(?:=(?P<values>.*))?")
_TYPES: dict[str, tuple[type, ...]] = {
    "M": (Mention,), "V": (Verb,), "W": (Word,), "E": (Mention, Verb, Word),
    "BLOW": (Mention, Word),
}  # fmt: skip
_KINDS: dict[str, WordKind] = {
    "adv": "adv", "conj": "conj", "prep": "prep", "sub": "sub", "rel": "rel", "punct": "punct",
}  # fmt: skip
_MANY = {"": (1, 1), "?": (0, 1), "*": (0, 12)}
_AS_HITS = frozenset({"blow", "jolt", "touch"})
_VERB_FIELDS = frozenset(Verb.__dataclass_fields__)
Step = Callable[[list[Element], int, list[Element]], int]
"""How many elements an item takes at a place; -1 if it does not match there."""
Spans = dict[str, tuple[int, int]]


@dataclass(frozen=True)
class Item:
    """One item of a pattern; `least` to `most` times."""

    name: str
    step: Step
    types: tuple[type, ...]
    least: int
    most: int


@dataclass(frozen=True)
class Row:
    """A construction: what `items` match up to `cut` becomes what `made` says."""

    items: tuple[Item, ...]
    cut: int
    starts: tuple[type, ...]
    made: tuple[re.Match[str], ...]
    example: str
    plain: str


def rewrite(elements: list[Element], reading: str) -> list[Element]:
    """Puts plain elements in place of every construction of one reading.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
        reading: Which rows of the table apply; the first that matches at a place decides.
    """
    rows = table().get(reading, ())
    out: list[Element] = []
    i = 0
    while i < len(elements):
        for row in rows:
            spans = match(row, elements, i, out)
            if spans is not None:
                out += [e for made in row.made for e in _make(made, elements, spans, out)]
                i = spans["all"][1]
                break
        else:
            out.append(elements[i])
            i += 1
    return out


def match(row: Row, elements: list[Element], i: int, out: list[Element]) -> Spans | None:
    """The stretches of the named items of a row that matches at i, and of "all" it takes."""
    spans: Spans = {}
    if not isinstance(elements[i], row.starts) or not _matches(row, 0, elements, i, out, spans):
        return None
    spans["all"] = (i, spans["all"][1])
    return spans


@cache
def table() -> dict[str, list[Row]]:
    """The rows by the reading they belong to."""
    out: dict[str, list[Row]] = {}
    with open(lex.DATA / "rewrites.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE):
            parts = list(_ITEM.finditer(row["pattern"]))
            cut = next((k for k, m in enumerate(parts) if m[0] == "/"), len(parts))
            items = tuple(_item(m) for m in parts if m[0] != "/")
            starts = _starts(items)
            made = tuple(_MADE.finditer(row["result"]))
            compiled = Row(items, cut, starts, made, row["example"], row["plain"])
            out.setdefault(row["reading"], []).append(compiled)
    return out


def _starts(items: tuple[Item, ...]) -> tuple[type, ...]:
    """What the first element may be."""
    out: tuple[type, ...] = ()
    for item in items:
        out += item.types
        if item.types and item.least:
            break
    return out


def _item(m: re.Match[str]) -> Item:
    least, most = _MANY[m["many"] or ""]
    if m["place"]:
        place = PLACES[m["place"].removeprefix("!")]
        yes = not m["place"].startswith("!")
        return Item("", lambda e, i, out: 0 if place(e, i, out) == yes else -1, (), least, most)
    if m["type"] == "BLOW":
        return Item(m["name"], lambda e, i, _: blow_at(e, i)[1] or -1, (Mention, Word), 1, 1)
    types = _TYPES[m["type"] or "W"]
    tests = [_test(t) for t in (m["tests"] or "").split(", ") if t]
    if m["low"]:
        tests.append(_test(f"low={m['low']}"))

    def step(elements: list[Element], i: int, out: list[Element]) -> int:
        e = elements[i] if i < len(elements) else None
        fits = e is not None and isinstance(e, types) and all(test(e) for test in tests)
        return 1 if fits else -1

    return Item(m["name"] or "", step, types, least, most)


def _test(text: str) -> Callable[[Element], bool]:
    m = _TEST.fullmatch(text)
    assert m is not None, text
    name = m["name"]
    look: Callable[[Element], object] = PROPERTIES.get(name) or partial(_field, name=name)
    if m["values"] is None:
        return lambda e: bool(look(e)) != bool(m["no"])
    words = lex.word_set(m["values"][1:]) if m["values"][:1] == "@" else {*m["values"].split("|")}

    def test(e: Element) -> bool:
        value = look(e)
        return (str(value) in words) != bool(m["differs"])

    return test


def _field(e: Element, name: str) -> object:
    return getattr(e, name, "")


def _matches(
    row: Row, k: int, elements: list[Element], i: int, out: list[Element], spans: Spans
) -> bool:
    """Whether the items from k on match from place i on; fills the stretches of named ones."""
    if k == row.cut:
        spans["all"] = (i, i)
    if k == len(row.items):
        return True
    item = row.items[k]
    ends = [i]
    while len(ends) <= item.most and (used := item.step(elements, ends[-1], out)) >= 0:
        ends.append(ends[-1] + used)
    for end in reversed(ends[item.least :]):
        if _matches(row, k + 1, elements, end, out, spans):
            spans[item.name] = (i, end)
            return True
    return False


def _make(
    made: re.Match[str], elements: list[Element], spans: Spans, out: list[Element]
) -> list[Element]:
    """The elements of one part of a result."""
    what, low = made["what"], (made["low"] or "").replace("_", " ")
    if what in spans and made["word"] is None and not made["form"] and not made["first"]:
        named = elements[slice(*spans[what])]
        if (made["changes"] or "").startswith("as="):
            color = colours(elements[spans[made["changes"][3:]][0]])
            return [_member(e, color) for e in named if isinstance(e, Mention)]
        for e in named:
            _change(e, made["changes"], elements, spans)
        return [] if made["aside"] else named
    first = spans[made["first"] or "all"]
    last = spans[made["last"] or made["first"] or "all"]
    model = elements[first[0]]
    start, end = model.start, elements[max(last[1] - 1, first[0])].end
    if made["after"]:
        start = end = model.end
        model = Word(start, start, "unknown", "")
    if what == "again":
        verb = next(e for e in reversed(out) if isinstance(e, Verb))
        new: Element = replace(verb, start=start, end=end, form="s", extra=dict(verb.extra))
    elif made["word"] is None:
        new = _verb(what, made, model, (start, end), elements, spans)
    elif not low:
        new = Mention(start, start, pronoun=what, text=what)
    else:
        wide = what == "adv" or (made["first"] and what in ("prep", "sub"))
        new = Word(start, end if wide else start, _KINDS[what], low)
    _change(new, made["changes"], elements, spans)
    return [new]


def _verb(
    what: str,
    made: re.Match[str],
    model: Element,
    at: tuple[int, int],
    elements: list[Element],
    spans: Spans,
) -> Verb:
    """The verb that a result names, in the form of the verb in whose place it stands."""
    if what.startswith("="):
        blow = elements[spans[what[1:]][1] - 1]
        what = blow.head if isinstance(blow, Mention) else getattr(blow, "low", "")
        what = "hit" if what in _AS_HITS else what
    reading = next((r for r in verb_readings(what) if r.form == "base"), None)
    lemma, sense, note = (
        (reading.lemma, reading.sense, reading.note) if reading else (what, "hit", "")
    )
    if isinstance(model, Verb):
        form = made["form"] or model.form
        return replace(model, end=at[1], lemma=lemma, sense=sense, note=note, form=form, extra={})
    return Verb(*at, lemma, sense, made["form"] or "s", note)


def _member(m: Mention, color: list[str]) -> Mention:
    """One of several things, told by its colour."""
    return replace(
        m, plural=False, count=None, determiner="a", adjectives=[*m.adjectives, *color],
        text=f"{color[0]} {m.head}", amounts=[*m.amounts], coordinated=[], entities=[],
    )  # fmt: skip


def _change(e: Element, changes: str | None, elements: list[Element], spans: Spans) -> None:
    """Sets fields of an element; what a verb has no field for is a note of its own."""
    for change in (changes or "").split(", "):
        m = _TEST.fullmatch(change)
        if m is None:
            continue
        name, value = m["name"], m["values"]
        if name in _TAKEN and isinstance(e, Mention):
            _TAKEN[name](e, elements[spans[value][0]])
        elif isinstance(e, Verb) and name not in _VERB_FIELDS:
            e.extra = {**e.extra, name: value}
        elif value is None:
            setattr(e, name, None if name == "noun" else not m["no"])
        elif name == "noun":
            setattr(e, name, lex.nouns()[value])
        elif isinstance(getattr(e, name), list):
            setattr(e, name, value.split("|"))
        else:
            setattr(e, name, int(value) if value.isdigit() else value)


def _takes(m: Mention, told: Element) -> None:
    """A thing has what is told beside it: a quantity, "a red one", "a dog"."""
    if isinstance(told, Word) and told.amount is not None:
        m.amounts.append(told.amount)
    elif isinstance(told, Mention):
        m.end, m.adjectives = max(m.end, told.end), [*m.adjectives, *told.adjectives]
        if told.letters:
            m.letters, m.determiner = [*told.letters], ""
            m.text = f"{m.text} {m.letters[0]}"
        elif told.noun is not None and not m.determiner:
            m.noun, m.known = told.noun, True


def _is_like(m: Mention, other: Element) -> None:
    """ "The left and the right cart": a cart, too."""
    if isinstance(other, Mention):
        m.adjectives = m.adjectives or [m.head]
        m.pronoun, m.part, m.attribute = "", "", other.attribute
        m.head, m.noun, m.known = other.head, other.noun, other.known
        m.text = f"{m.text} {other.head}"


_TAKEN: dict[str, Callable[[Mention, Element], None]] = {
    "takes": _takes, "like": _is_like, "put": put,
}  # fmt: skip
