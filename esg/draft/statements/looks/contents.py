"""What vessels are filled with, and what floats or sinks in it, as statements."""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import LIVING
from esg.draft.statements.book import Told
from esg.draft.text.elements import Mention
from esg.draft.text.fillings import COUNTED, Fillings, Floating
from esg.graph.models import Contents, CoverageItem, EdgeEvent, EsgDocument, NodeEvent, Predicate

SPILLS = "what spills is not simulated"
NO_VESSEL = "no vessel of the scene holds it"
NO_SPLASH = "no splash is shown"
AS_IT_IS = "how it is in the vessel is not shown"
_EMPTIES = re.compile(
    r"\b(?:empt|pour|spill|tip|drink|drank|sip|dump|throw|threw|toss|slosh|upend|overturn)\w*\s+"
    rf"(?:(?:out|over)\s+)?{COUNTED}\s+(?:[\w-]+\s+){{0,2}}$",
    re.IGNORECASE,
)
"""Before a vessel, what is done with what is in it."""
_TIPS = frozenset({NodeEvent.FALL, NodeEvent.TOPPLE, NodeEvent.BREAK})
"""Events in which a vessel spills what is in it."""


def fill(d: Discourse, fillings: Fillings) -> None:
    """Notes what each vessel of the scene is filled with."""
    for f in fillings.fillings:
        for vessel in named_at(d, f.vessel):
            told = Contents(name=f.content, share=f.share, color=f.color)
            d.scene.contents.setdefault(vessel, told)


def contained(t: Told) -> None:
    """ "A bucket filled with water", "floats in a bathtub", "and sinks to the bottom"."""
    d, book = t.d, t.book
    for f in d.scene.fillings.fillings:
        vessels = tuple(i for i in named_at(d, f.vessel) if d.scene.contents[i].name == f.content)
        if not vessels:
            book.add(Predicate.NOT_REPRESENTED, f.start, f.end, note=NO_VESSEL)
            continue
        spilt = any(_spills(d, i) for i in vessels) or _EMPTIES.search(d.text[: f.vessel])
        book.add(
            Predicate.FILLED_WITH, f.start, f.end, object=vessels, noun=f.content,
            when="start" if spilt else "throughout",
        )  # fmt: skip
        if spilt:
            book.add(Predicate.NOT_REPRESENTED, f.start, f.end, object=vessels, note=SPILLS)
        for start, end in f.lacks:
            book.add(Predicate.NOT_REPRESENTED, start, end, object=vessels, note=AS_IT_IS)
    for start, end in d.scene.fillings.splashes:
        book.add(Predicate.NOT_REPRESENTED, start, end, note=NO_SPLASH)
    for floating in d.scene.fillings.floating:
        who, vessels = _who(d, floating), _in_what(d, floating)
        at = floating.start, floating.end
        if not who or not vessels:
            book.add(Predicate.NOT_REPRESENTED, *at, note=NO_VESSEL)
            continue
        moved = {e.actor for e in d.timeline.edges}
        lasts = floating.lasts and not moved & {*who}
        says = floating.says
        if says is Predicate.INSIDE and lasts:
            says = Predicate.FLOATS  # "lies on the surface of"
        book.add(says, *at, object=who, target=vessels, when="throughout" if lasts else "end")


def as_told(doc: EsgDocument, fillings: Fillings, prompt: str) -> EsgDocument:
    """The document with the words of the prompt where others stood in their place for a while."""
    if fillings.text == fillings.told:
        return doc
    items: list[CoverageItem] = []
    for item in doc.coverage.items:
        there = (b for a, b in fillings.changed if item.start <= a < item.end)
        end = max([item.end, *there])
        items.append(item.model_copy(update={"text": prompt[item.start : end], "end": end}))
    return doc.model_copy(
        update={"coverage": doc.coverage.model_copy(update={"items": tuple(items)})}
    )


def named_at(d: Discourse, at: int) -> list[str]:
    """The nodes of the mention that stands there."""
    there = [m for m in _each(d.mentions) if m.start <= at < m.end]
    for m in sorted(there, key=lambda m: m.end - m.start):
        beside = {i for other in m.coordinated for i in d.world.resolved.get(id(other), ())}
        found = d.world.resolved.get(id(m), m.entities)
        if own := [i for i in found if i in d.world.entities and i not in beside]:
            return own
    return []


def _each(mentions: list[Mention]) -> Iterator[Mention]:
    """Mentions, and what is coordinated with them."""
    for m in mentions:
        yield m
        yield from _each(m.coordinated)


def _in_what(d: Discourse, floating: Floating) -> tuple[str, ...]:
    if floating.vessel >= 0:
        return tuple(i for i in named_at(d, floating.vessel) if i in d.scene.contents)
    before = [f for f in d.scene.fillings.fillings if f.vessel < floating.start]
    return tuple(named_at(d, max(f.vessel for f in before))) if before else ()


def _who(d: Discourse, floating: Floating) -> tuple[str, ...]:
    """What was named last before that is no vessel with something in it, and nobody."""
    for m in sorted(d.mentions, key=lambda m: -m.start):
        if m.end > floating.start:
            continue
        found = [i for i in d.world.resolved.get(id(m), m.entities) if i in d.world.entities]
        named = [i for i in found if i not in d.scene.contents]
        alive = floating.vessel < 0
        named = [i for i in named if not alive or d.world.entities[i].noun.kind not in LIVING]
        if named:
            return tuple(named)
    return ()


def _spills(d: Discourse, vessel: str) -> bool:
    """Whether the story tips a vessel over, breaks it or lets it fly."""
    tipped = (n for n in d.timeline.nodes if n.event in _TIPS)
    thrown = (e for e in d.timeline.edges if e.event is EdgeEvent.TOWARD and e.actor == vessel)
    first = any(n.participants[:1] == (vessel,) for n in tipped)
    return first or any(e.params.spin != "slide" for e in thrown)
