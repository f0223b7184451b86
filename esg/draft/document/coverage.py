"""Accounts for every noun, event and quantity of the prompt."""

from __future__ import annotations

import re
from typing import Literal

from esg.draft import lexicon as lex
from esg.draft.discourse.scene import Scene
from esg.draft.text.elements import Element, Mention, Token, Verb, Word
from esg.graph.models import Coverage, CoverageItem, NodeEvent

Kind = Literal["object", "event", "quantity", "relation", "modifier"]
Status = Literal["used", "ignored", "not_understood"]

_NEXT = "comes after what is told before it"
_ORDER = {
    **dict.fromkeys(
        ("then", "next", "later", "afterwards", "afterward", "subsequently", "eventually",
         "finally", "thereby", "therefore", "thus", "hence", "consequently", "soon", "shortly",
         "immediately", "now", "once"),
        _NEXT,
    ),
    **dict.fromkeys(("meanwhile", "simultaneously"), "at the same time as what is told before it"),
    "first": "comes first",
    "again": "once more",
    "not": "negation", "never": "negation", "almost": "it does not happen",
    "nearly": "it does not happen", "instead": "in place of what was aimed at",
}  # fmt: skip
"""Adverbs that order events or deny them, and what they say."""
_DIRECTIONS = lex.word_set("directions")

NOTHING_HAPPENS = "No event of the prompt was understood"
"""Start of the warning of a draft whose verbs all failed."""


def account(
    text: str, elements: list[Element], mentions: list[Mention], scene: Scene, tokens: list[Token]
) -> Coverage:
    """The coverage record, in order of the text."""
    items: list[CoverageItem] = []
    warnings: list[str] = list(dict.fromkeys([*scene.world.warnings, *scene.warnings]))

    def add(
        start: int, end: int, kind: Kind, status: Status, pointer: str = "", note: str = ""
    ) -> None:
        items.append(
            CoverageItem(
                text=text[start:end],
                start=start,
                end=end,
                kind=kind,
                status=status,
                pointer=pointer,
                note=note,
            )
        )

    for m in mentions:
        ids = [i for i in scene.world.resolved.get(id(m), m.entities) if i in scene.world.entities]
        if ids:
            note = ""
            e = scene.world.entities[ids[0]]
            if not e.known:
                note = "not in the lexicon: a sized stand-in is used"
                warnings.append(
                    f'"{e.head}" is not in the lexicon; a stand-in of 40 cm and 5 kg is used.'
                )
            add(m.start, m.end, "object", "used", f"/spatial_relation_graph/nodes/{ids[0]}", note)
        elif m.pronoun:
            if m.pronoun in ("i", "we", "you", "something", "everything", "this", "that", "it"):
                add(m.start, m.end, "object", "ignored", note="refers to no object")
            else:
                add(m.start, m.end, "object", "not_understood", note="no referent")
                warnings.append(f'It is not clear what "{text[m.start : m.end]}" refers to.')
        elif m.attribute or m.count == 0:
            add(m.start, m.end, "modifier", "used", note="names a measure or an event")
        elif m.noun is not None and m.noun.kind == "region":
            add(
                m.start,
                m.end,
                "object",
                "used",
                note="region of the table",
            )
        else:
            add(m.start, m.end, "object", "not_understood")
            warnings.append(f'"{text[m.start : m.end]}" was not understood.')
    for token in tokens:
        if token.kind != "qty" or token.amount is None:
            continue
        a = token.amount
        spans = ((x.start, x.end) for x in (a, *a.shares))
        note = next((scene.used[s] for s in spans if s in scene.used), None)
        inside = any(
            a in m.amounts and (m.entities or id(m) in scene.world.resolved) and not m.attribute
            for m in mentions
        )
        if note is not None or inside:
            add(a.start, a.end, "quantity", "used", note=note or "property of the object")
        else:
            add(a.start, a.end, "quantity", "not_understood")
            warnings.append(f'The quantity "{a.text}" was not understood.')
    for e in elements:
        if isinstance(e, Word) and e.kind == "adv" and e.low in _ORDER:
            add(e.start, e.end, "modifier", "used", note=_ORDER[e.low])
        elif isinstance(e, Word) and e.kind == "adv" and " " not in text[e.start : e.end]:
            used = e.low in _DIRECTIONS or e.low == "heading"
            status: Status = "used" if used else "ignored"
            note = "direction" if used else "manner is not simulated"
            add(e.start, e.end, "modifier", status, note=note)
        elif (
            isinstance(e, Word)
            and e.kind in ("prep", "adv", "sub")
            and " " in text[e.start : e.end]
        ):
            add(e.start, e.end, "modifier", "used", note=f'read as "{e.low}"')
        if isinstance(e, Verb):
            key = (e.start, e.end)
            if key in scene.used:
                add(e.start, e.end, "event", "used", note=scene.used[key])
            elif key in scene.ignored:
                add(e.start, e.end, "event", "ignored", note=scene.ignored[key])
            else:
                add(e.start, e.end, "event", "not_understood")
                warnings.append(f'The verb "{text[e.start : e.end]}" was not understood.')
        elif isinstance(e, Word) and e.kind == "unknown" and re.fullmatch(r"[\d.,]*\d", e.low):
            add(e.start, e.end, "quantity", "not_understood", note="a number without a unit")
            warnings.append(f'The number "{text[e.start : e.end]}" has no unit; it was left out.')
        elif isinstance(e, Word) and e.kind == "unknown" and len(e.low) > 1 and e.low[0].isalpha():
            if (
                e.low in lex.COLORS
                or e.low in lex.PLAIN_ADJECTIVES
                or e.low in lex.PLACE_ADJECTIVES
            ):
                add(e.start, e.end, "modifier", "used")
                continue
            if e.low in lex.DETERMINERS or e.low in ("who", "whom"):
                continue
            add(e.start, e.end, "modifier", "not_understood")
            warnings.append(f'The word "{text[e.start : e.end]}" was not understood.')
    verbs = [i for i in items if i.kind == "event"]
    lost = [i for i in verbs if i.status == "not_understood"]
    told = any(n.event is not NodeEvent.TRIGGER for n in scene.timeline.nodes)
    if lost and not told:
        words = ", ".join(f'"{i.text}"' for i in lost[:4])
        warnings.insert(0, f"{NOTHING_HAPPENS} ({words}): the scene shows none of it.")
    items.sort(key=lambda i: (i.start, i.end))
    return Coverage(items=tuple(items), warnings=tuple(dict.fromkeys(warnings)))


def in_prompt(coverage: Coverage, text: str, prompt: str) -> Coverage:
    """A record of where words went, with its places in the prompt as it was typed.

    Args:
        coverage: Places in `text`.
        text: What was read: the prompt without markup, with symbols spelled out.
        prompt: What was typed.
    """
    if text == prompt:
        return coverage
    items = []
    for item in coverage.items:
        found = [m.start() for m in re.finditer(re.escape(item.text), prompt)] if item.text else []
        start = min(found, key=lambda k: abs(k - item.start), default=min(item.start, len(prompt)))
        end = start + len(item.text) if found else min(item.end, len(prompt))
        items.append(item.model_copy(update={"start": start, "end": max(start, end)}))
    return coverage.model_copy(update={"items": tuple(items)})
