"""On which side something is hit: "the side of a taxi", "from behind", "rear-ends", "head-on".

`data/sides.csv` says which words mean which side, with a sentence for each: a `part` of what is hit
or hits, a part that only who drives or moves about has, `from` where, an `adverb`, an adverb about
`both`, a `verb`.
"""

from __future__ import annotations

from collections.abc import Iterator
import csv
from dataclasses import dataclass
from functools import cache
from typing import get_args

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import SELF_POWERED
from esg.draft.discourse.windows import Draft
from esg.draft.events.hanging import hanging
from esg.draft.events.stated import adverbs_of, place_of, start_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent, Side

HEADED = SELF_POWERED | {"appliance", "furniture", "seat", "statue"}
"""Kinds of things whose left and right are their own in everybody's words."""
_ROUND = ("ball", "billiard", "barrel", "bottle", "cone", "pin", "wheel")
"""Kinds that look alike from all sides."""

_HANDS = ("left", "right")


@dataclass(frozen=True)
class Struck:
    """What is hit on which side in which event; `start` and `end` are the words that say so.

    Args:
        side: None where the thing has no such side.
    """

    event: str
    struck: str
    by: str
    side: Side | None
    start: int
    end: int
    note: str = ""


@cache
def _rows() -> tuple[dict[str, str], ...]:
    with open(lex.DATA / "sides.csv", encoding="utf-8", newline="") as file:
        return tuple(csv.DictReader(file, delimiter=";"))


def examples() -> list[tuple[str, str]]:
    """Sentence and side, by row of the table."""
    return [(r["example"], r["side"]) for r in _rows()]


@cache
def _sides() -> dict[tuple[str, str], Side]:
    known: dict[str, Side] = {s: s for s in get_args(Side)}
    return {(r["part"], w): known[r["side"]] for r in _rows() for w in r["words"].split("|")}


def struck(d: Discourse, frames: list[Frame]) -> Iterator[Struck]:
    """What the clauses that tell of a hit say of where it is."""
    hits: list[Draft] = []
    for f in frames:
        own = {name for g, name in d.times.of_frame if g.verb is f.verb}
        told = [n for n in d.timeline.nodes if n.id in own and n.event is NodeEvent.COLLISION]
        bare = f.object is None and not f.phrases and ("verb", f.verb.lemma) in _sides()
        hits = told or (hits if bare else [])  # "rams a bus broadside"
        for n in hits if not (f.unreal or f.verb.negated) else ():
            yield from _parts(d, f, n)
            yield from _how(d, f, n)


def _parts(d: Discourse, f: Frame, n: Draft) -> Iterator[Struck]:
    """ "The side of a taxi", "in the back", "with its rear"."""
    told = [Phrase("", m) for m in (f.subject, f.object, f.object2)]
    for p in (*told, *f.phrases):
        m = p.mention
        if m is None or p.prep == "from" or (m.count or 1) > 1:
            continue  # "parked cars on both sides": no side of what is hit
        who = _whose(d, f, n, p, m)
        part = m.part or (m.head if m.attribute or m.noun is None else "")
        if who is not None and part:
            side = _side_of(d, who, " ".join([*m.adjectives, part])) or _side_of(d, who, part)
            at = (start_of(p, d.text) if p.prep else m.start, m.end)
            yield from _on(d, n, who, side, *at)


def _whose(d: Discourse, f: Frame, n: Draft, p: Phrase, m: Mention) -> str | None:
    """Which participant of a hit has the part that a phrase names."""
    own = [i for i in m.entities if i in n.participants and i in d.world.entities]
    if own:
        return own[0]
    its = not p.prep and m.determiner in lex.POSSESSIVES
    if m.entities or not m.attribute or not (its or p.prep in ("in", "on", "at", "with")):
        return None
    hits = p.prep == "with" or m is f.subject
    return n.participants[0 if hits and not f.verb.passive else 1]


def _side_of(d: Discourse, who: str, part: str) -> Side | None:
    found = _sides().get(("part", part))
    if found is None and kind_of(d, who) in SELF_POWERED:
        found = _sides().get(("vehicle part", part))
    return found


def _how(d: Discourse, f: Frame, n: Draft) -> Iterator[Struck]:
    """ "From behind", "from the side", "head-on", "T-bones"."""
    target = n.participants[1]
    verb = _sides().get(("verb", f.verb.lemma))
    if verb is not None:
        yield from _on(d, n, target, verb, f.verb.start, f.verb.end)
    for p in f.phrases:
        if p.prep == "from" and p.mention is not None and p.mention.attribute:
            side = _sides().get(("from", p.mention.part or p.mention.head))
            if side in _HANDS and hanging(d, [target]):
                continue  # a bell has no left: it is where what strikes it comes from
            yield from _on(d, n, target, side, start_of(p, d.text), p.mention.end)
    for word in adverbs_of(d.text, f):
        at = place_of(word, d.text, f) or (f.verb.start, f.verb.end)
        yield from _on(d, n, target, _sides().get(("adverb", word)), *at)
        for who in n.participants if ("both", word) in _sides() else ():
            if kind_of(d, who) in SELF_POWERED:
                yield from _on(d, n, who, _sides()["both", word], *at)


def _on(
    d: Discourse, n: Draft, who: str, side: Side | None, start: int, end: int
) -> Iterator[Struck]:
    if side is None or len(n.participants) < 2 or who not in d.world.entities:
        return
    by = next(p for p in n.participants if p != who)
    kind, noun = kind_of(d, who), entity_of(d, who).noun
    meant: Side | None = side
    if kind not in HEADED and side == "side":
        meant = "any_side"
    elif kind in _ROUND or noun.shape == "sphere" or (kind not in HEADED and side in _HANDS):
        meant = None
    note = "" if meant else f"{entity_of(d, who).head} has no {side} of its own"
    yield Struck(n.id, who, by, meant, start, end, note)
