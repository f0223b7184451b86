"""Constructions as rows of `data/rewrites.csv`: a pattern of elements and what stands for them.

A pattern is a row of items: `M` a noun phrase, `V` a verb, `W` a small word, `E` any of them,
`"of|in"` one of some small words, `BLOW` the noun of a contact, `<opens>` a condition on the place.
Tests stand in brackets (`V[lemma=@giving, !passive]`; `@giving` is a word set), a name in front
(`who:M`), `?` or `*` behind; what follows `/` must match but is left as it is.

What stands for it is read by `results`.
"""

from __future__ import annotations

from collections.abc import Callable
import csv
from dataclasses import dataclass
from functools import cache, partial
import re

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import PLACES, PROPERTIES, blow_at
from esg.draft.grammar.rewrites.results import PART, TEST, Spans, make
from esg.draft.text.elements import Element, Mention, Verb, Word, element_at

_ITEM = re.compile(
    r'(?:(?P<name>[a-z]\w*):)?(?:(?P<type>[A-Z]+)|"(?P<low>[^"]+)"|<(?P<place>[^>]+)>)'
    r"(?:\[(?P<tests>[^\]]*)\])?(?P<many>[?*])?|/"
)
_TYPES: dict[str, tuple[type, ...]] = {
    "M": (Mention,), "V": (Verb,), "W": (Word,), "E": (Mention, Verb, Word),
    "BLOW": (Mention, Word),
}  # fmt: skip
_MANY = {"": (1, 1), "?": (0, 1), "*": (0, 12)}
Step = Callable[[list[Element], int, list[Element]], int]
"""How many elements an item takes at a place; -1 if it does not match there."""


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
    out: list[Element] = []
    i = 0
    while i < len(elements):
        for row in _starting_with(reading, type(elements[i])):
            spans = match(row, elements, i, out)
            if spans is not None:
                out += [e for made in row.made for e in make(made, elements, spans, out)]
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
def _starting_with(reading: str, first: type) -> tuple[Row, ...]:
    """The rows of a reading that may begin with an element of a type, in their order."""
    return tuple(row for row in table().get(reading, ()) if issubclass(first, row.starts))


@cache
def table() -> dict[str, list[Row]]:
    """The rows by the reading they belong to."""
    out: dict[str, list[Row]] = {}
    with open(lex.DATA / "rewrites.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE):
            parts = _parts(_ITEM, row["pattern"])
            cut = next((k for k, m in enumerate(parts) if m[0] == "/"), len(parts))
            items = tuple(_item(m) for m in parts if m[0] != "/")
            starts = _starts(items)
            made = tuple(_parts(PART, row["result"]))
            compiled = Row(items, cut, starts, made, row["example"], row["plain"])
            out.setdefault(row["reading"], []).append(compiled)
    return out


def _parts(part: re.Pattern[str], text: str) -> list[re.Match[str]]:
    """The parts of a cell; a row that cannot be read is an error of the table."""
    parts = list(part.finditer(text))
    if " ".join(m[0] for m in parts) != text:
        raise ValueError(f"rewrites.csv: cannot read {text!r}")
    return parts


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
        e = element_at(elements, i)
        fits = e is not None and isinstance(e, types) and all(test(e) for test in tests)
        return 1 if fits else -1

    return Item(m["name"] or "", step, types, least, most)


def _test(text: str) -> Callable[[Element], bool]:
    m = TEST.fullmatch(text)
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
