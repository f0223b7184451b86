"""What a row of `data/rewrites.csv` puts in place of what its pattern matched.

A result lists named elements (`who`), with changes (`v[form=s, !negated]`; `~who[...]`: changed
where it stands), verbs (`hit.s@v`: v as "hits"; `=b.s`: the verb of a blow), words
(`adv/heading@who-v`: over that stretch; `conj/and`: without a place of its own; `@+who`: behind
it), pronouns (`they/`) and the last verb (`again`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
import re
from typing import Literal

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.conditions import colours, label_of
from esg.draft.grammar.rewrites.positions import put
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.verbphrases import verb_readings

PART = re.compile(
    r"(?P<aside>~?)(?P<what>=?[a-z]\w*)(?:\.(?P<form>\w+))?(?P<word>/(?P<low>[^@\s\[]*))?"
    r"(?:@(?P<after>\+)?(?P<first>\w+)(?:-(?P<last>\w+))?)?(?:\[(?P<changes>[^\]]*)\])?"
)
TEST = re.compile(r"(?P<no>!?)(?P<name>\w+)(?P<differs>!?)(?:=(?P<values>.*))?")
"""A test or a change: "form=s", "!negated", "low!=of"."""
WordKind = Literal["adv", "conj", "prep", "sub", "rel", "punct"]
_KINDS: dict[str, WordKind] = {
    "adv": "adv", "conj": "conj", "prep": "prep", "sub": "sub", "rel": "rel", "punct": "punct",
}  # fmt: skip
_AS_HITS = frozenset({"blow", "jolt", "touch"})
_VERB_FIELDS = frozenset(Verb.__dataclass_fields__)
Spans = dict[str, tuple[int, int]]
"""Half-open stretches of elements by the name of an item."""


def make(
    made: re.Match[str], elements: list[Element], spans: Spans, out: list[Element]
) -> list[Element]:
    """The elements of one part of a result.

    Args:
        made: The part.
        elements: Where the pattern matched.
        spans: The stretches of its named items, and "all".
        out: What was made of the elements before.
    """
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
        m = TEST.fullmatch(change)
        if m is None:
            continue
        name, value = m["name"], m["values"]
        if name in _TAKEN and isinstance(e, Mention):
            _TAKEN[name](e, elements[spans[value][0]])
        elif isinstance(e, Verb) and name not in _VERB_FIELDS:
            e.extra = {**e.extra, name: value}
        elif value is None:
            text = m["no"] and isinstance(getattr(e, name), str)
            setattr(e, name, None if name == "noun" else "" if text else not m["no"])
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
        m.start, m.end = min(m.start, told.start), max(m.end, told.end)
        if label := label_of(told):
            m.letters, m.determiner = [*label], ""
            m.text = f"{m.text} {m.letters[0]}"
            return
        m.adjectives += told.adjectives
        if told.noun is not None and not m.determiner:
            m.noun, m.known = told.noun, True


def _is_like(m: Mention, other: Element) -> None:
    """ "The left and the right cart": a cart, too."""
    if isinstance(other, Mention):
        m.adjectives = m.adjectives or [m.head]
        m.pronoun, m.part, m.attribute = "", "", other.attribute
        m.head, m.noun, m.known = other.head, other.noun, other.known
        m.text = f"{m.text.removesuffix(' one')} {other.head}"


_TAKEN: dict[str, Callable[[Mention, Element], None]] = {
    "takes": _takes, "like": _is_like, "put": put,
}  # fmt: skip
