"""Accounts for every noun, event and quantity of the prompt."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
import math
import re
from typing import Literal, TypeVar

from esg.draft import lexicon as lex
from esg.draft.discourse.scene import Scene
from esg.draft.grammar.questions import ASKED
from esg.draft.text.amounts import Amount
from esg.draft.text.elements import Element, Mention, Token, Verb, Word
from esg.graph.models import Coverage, CoverageItem, NodeEvent, Statement

_T = TypeVar("_T", CoverageItem, Statement)


@dataclass(frozen=True)
class _Fate:
    """What became of some words of the prompt, and what to warn of."""

    kind: Literal["object", "event", "quantity", "relation", "modifier"]
    status: Literal["used", "ignored", "not_understood"] = "used"
    note: str = ""
    warning: str = ""
    pointer: str = ""


_NEXT = "comes after what is told before it"
_ORDER = {
    **dict.fromkeys(
        ("then", "next", "later", "afterwards", "afterward", "subsequently", "eventually",
         "finally", "thereby", "therefore", "thus", "hence", "consequently", "soon", "shortly",
         "immediately", "now", "once"),
        _NEXT,
    ),
    **dict.fromkeys(("meanwhile", "simultaneously"), "at the same time as what is told before it"),
    "first": "comes first", "again": "once more",
    "not": "negation", "never": "negation", "almost": "it does not happen",
    "nearly": "it does not happen", "instead": "in place of what was aimed at",
}  # fmt: skip
"""Adverbs that order events or deny them, and what they say."""
_DIRECTIONS = lex.word_set("directions") | {"heading"}
_NO_OBJECT = frozenset({"i", "we", "you", "something", "everything", "this", "that", "it"})
_ADJECTIVES = frozenset(lex.COLORS) | lex.PLAIN_ADJECTIVES | lex.PLACE_ADJECTIVES
_PATTERNS = {
    **{word: p for word, p in (lex.GROUP_WORDS | lex.ARRANGEMENTS).items() if p != "scatter"},
    **dict.fromkeys(("stacked", "piled", "heaped", "stack"), "stack"),
    **dict.fromkeys(("lined", "aligned"), "row"), "racked": "pins", "queued": "queue",
    "side by side": "row", "from left to right": "row", "from right to left": "row",
}  # fmt: skip
"""How things stand, by the words that say so."""
_SILENT = lex.DETERMINERS | {"who", "whom"}
_DESCRIBED_AFTER = frozenset({"DET", "ADJ"})
"""Parts of speech after which a participle stands before a noun."""

FILMED = "statement: filmed"
"""Use of words that say how the scene is filmed."""
NOTHING_HAPPENS = "No event of the prompt was understood"
"""Start of the warning of a draft whose verbs all failed."""


def account(
    text: str, elements: list[Element], mentions: list[Mention], scene: Scene, tokens: list[Token]
) -> Coverage:
    """The coverage record, in order of the text."""
    amounts = [t.amount for t in tokens if t.amount is not None]
    acts = _acts(tokens)
    qualities = {word for e in scene.world.entities.values() for word in e.adjectives}
    fates: list[tuple[Mention | Verb | Word | Amount, _Fate]] = [
        *((m, _mention(m, text[m.start : m.end], scene)) for m in mentions),
        *((a, _quantity(a, mentions, scene)) for a in amounts),
    ]
    for e in elements:
        words = text[e.start : e.end]
        if isinstance(e, Verb):
            fates.append((e, _verb(e, words, scene)))
        elif isinstance(e, Word) and (e.kind, e.low in qualities) == ("unknown", True):
            fates.append((e, _Fate("modifier", note="property of the object")))
        elif isinstance(e, Word) and (fate := _word(e, words, scene, e.start in acts)) is not None:
            fates.append((e, fate))
    items = [
        CoverageItem(text=text[at.start : at.end], start=at.start, end=at.end, kind=f.kind,
                     status=f.status, pointer=f.pointer, note=f.note)
        for at, f in fates
    ]  # fmt: skip
    warnings = [*scene.world.warnings, *scene.warnings, *(f.warning for _, f in fates if f.warning)]
    lost = [i.text for i in items if i.kind == "event" and i.status == "not_understood"]
    if lost and all(n.event is NodeEvent.TRIGGER for n in scene.timeline.nodes):
        words = ", ".join(f'"{word}"' for word in lost[:4])
        warnings.insert(0, f"{NOTHING_HAPPENS} ({words}): the scene shows none of it.")
    items.sort(key=lambda i: (i.start, i.end))
    items = _arranged(items, scene, text)
    return Coverage(items=tuple(items), warnings=tuple(dict.fromkeys(warnings)))


def _arranged(items: list[CoverageItem], scene: Scene, text: str) -> list[CoverageItem]:
    """The items, of which those that say how a plural stands point to its pattern."""
    out = list(items)
    for members in scene.world.groups.values():
        entities = [e for i in members if (e := scene.world.entities.get(i)) and e.in_group]
        if len(entities) < 2:
            continue
        own = {f"/spatial_relation_graph/nodes/{i}" for i in members}
        named = [i for i in items if i.pointer in own]
        pattern = "pins" if entities[0].pattern == "rack" else entities[0].pattern
        told = [
            (min((_apart(i, n, text) for n in named), default=math.inf), k)
            for k, i in enumerate(items)
            if pattern in {_PATTERNS.get(w) for w in _names(i.text.lower())}
        ]
        if told and min(told)[0] < math.inf:
            pointer = f"/spatial_relation_graph/nodes/{entities[0].id}/group_pattern"
            k = min(told)[1]
            out[k] = out[k].model_copy(update={"pointer": pointer})
    return out


def _names(text: str) -> Iterator[str]:
    yield text
    for word in text.split():
        yield from (word, lex.singular(word)[0])


def _apart(one: CoverageItem, other: CoverageItem, text: str) -> float:
    """Characters between two items of one sentence."""
    between = text[min(one.end, other.end) : max(one.start, other.start)]
    return math.inf if re.search(r"[.!?]\s", between) else float(len(between))


def _acts(tokens: list[Token]) -> frozenset[int]:
    """Where words begin that tell of an act: not those that describe ("a burning house").

    After a noun that was taken for a verb comes the verb, taken for a noun: "the stand tips over".
    """
    pairs = zip([None, *tokens], tokens, strict=False)
    return frozenset(
        token.start
        for before, token in pairs
        if (token.tag == "VERB" and (before is None or before.tag not in _DESCRIBED_AFTER))
        or (before is not None and before.tag == "VERB" and token.low in lex.verb_forms())
    )


def _mention(m: Mention, words: str, scene: Scene) -> _Fate:
    named = scene.world.resolved.get(id(m), m.entities)
    if named and scene.links.issuperset(named):
        return _Fate("object", note="drawn as the joint that it is")
    ids = [i for i in named if i in scene.world.entities]
    if ids:
        e = scene.world.entities[ids[0]]
        pointer = f"/spatial_relation_graph/nodes/{ids[0]}"
        if e.known:
            return _Fate("object", pointer=pointer)
        if e.noun.like:
            return _Fate("object", note=f"shaped and sized like: {e.noun.like}", pointer=pointer)
        warning = f'"{e.head}" is not in the lexicon; a stand-in of 40 cm and 5 kg is used.'
        note = "not in the lexicon: a sized stand-in is used"
        return _Fate("object", "used", note, warning, pointer)
    if named and scene.aboard.keys() >= {*named}:
        return _Fate("object", note="inside a vehicle, out of sight")
    if m.pronoun in _NO_OBJECT:
        return _Fate("object", "ignored", "refers to no object")
    if m.pronoun:
        warning = f'It is not clear what "{words}" refers to.'
        return _Fate("object", "not_understood", "no referent", warning)
    if any(q.start <= m.start < q.end for q in scene.asked):
        return _Fate("modifier", "ignored", ASKED)
    if m.attribute or m.count == 0:
        return _Fate("modifier", note="names a measure or an event")
    if m.noun is not None and m.noun.kind == "region":
        return _Fate("object", note="region of the table")
    return _Fate("object", "not_understood", warning=f'"{words}" was not understood.')


def _quantity(a: Amount, mentions: list[Mention], scene: Scene) -> _Fate:
    spans = ((x.start, x.end) for x in (a, *a.shares))
    note = next((scene.used[s] for s in spans if s in scene.used), None)
    if note is None and any(
        a in m.amounts and (m.entities or id(m) in scene.world.resolved) and not m.attribute
        for m in mentions
    ):
        note = "property of the object"
    if note is not None:
        return _Fate("quantity", note=note)
    warning = f'The quantity "{a.text}" was not understood.'
    return _Fate("quantity", "not_understood", warning=warning)


def _verb(v: Verb, words: str, scene: Scene) -> _Fate:
    span = (v.start, v.end)
    if span in scene.used:
        return _Fate("event", note=scene.used[span])
    if span in scene.ignored:
        return _Fate("event", "ignored", scene.ignored[span])
    return _Fate("event", "not_understood", warning=f'The verb "{words}" was not understood.')


def _word(w: Word, words: str, scene: Scene, acts: bool) -> _Fate | None:
    """What became of a small word; None for those that need no account.

    Args:
        acts: Whether an unknown word is a verb here.
    """
    if w.kind == "adv" and (w.start, w.end) in scene.used:
        return _Fate("modifier", note=scene.used[w.start, w.end])
    if w.kind == "adv" and w.low in _ORDER:
        return _Fate("modifier", note=_ORDER[w.low])
    if w.kind in ("prep", "adv", "sub") and " " in words:
        return _Fate("modifier", note=f'read as "{w.low}"')
    if w.kind == "adv" and w.low in _DIRECTIONS:
        return _Fate("modifier", note="direction")
    if w.kind == "adv":
        return _Fate("modifier", "ignored", "manner is not simulated")
    if w.kind != "unknown":
        return None
    if any(q.start <= w.start < q.end for q in scene.asked):
        return _Fate("modifier", "ignored", ASKED)
    if scene.used.get((w.start, w.end)) == FILMED:
        return _Fate("modifier", note=FILMED)
    if re.fullmatch(r"[\d.,]*\d", w.low):
        warning = f'The number "{words}" has no unit; it was left out.'
        return _Fate("quantity", "not_understood", "a number without a unit", warning)
    if w.low in _ADJECTIVES:
        return _Fate("modifier")
    if len(w.low) < 2 or not w.low[0].isalpha() or w.low in _SILENT:
        return None
    if acts:
        return _Fate("event", "not_understood", warning=f'The verb "{words}" was not understood.')
    return _Fate("modifier", "not_understood", warning=f'The word "{words}" was not understood.')


def in_prompt(coverage: Coverage, text: str, prompt: str) -> Coverage:
    """A record of where words went, with its places in the prompt as it was typed.

    Args:
        coverage: Places in `text`.
        text: What was read: the prompt without markup, with symbols spelled out.
        prompt: What was typed.
    """
    if text == prompt:
        return coverage
    items = tuple(_moved(item, prompt) for item in coverage.items)
    return coverage.model_copy(update={"items": items})


def stated_in_prompt(
    statements: tuple[Statement, ...] | None, text: str, prompt: str
) -> tuple[Statement, ...] | None:
    """Statements with their places in the prompt as it was typed; see `in_prompt`."""
    if text == prompt or statements is None:
        return statements
    return tuple(_moved(s, prompt) for s in statements)


_MARKUP = r"(?:<[^<>]*>|[^\w<])+"
"""What may stand between two words that were read one after the other ("to the *left*")."""


def _moved(item: _T, prompt: str) -> _T:
    """An item at the place of its words in the prompt that is nearest to where it was read."""
    words = [re.escape(word) for word in item.text.split()]
    found: list[tuple[int, int]] = []
    for gap in (r"\s+", _MARKUP):
        found = found or [m.span() for m in re.finditer(gap.join(words), prompt) if words]
    read = (min(item.start, len(prompt)), min(item.end, len(prompt)))
    start, end = min(found, key=lambda at: abs(at[0] - item.start), default=read)
    return item.model_copy(update={"start": start, "end": max(start, end)})
