"""What every reading of a verb needs: entities, places, quantities and events."""

from __future__ import annotations

from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.entities import Entity
from esg.draft.discourse.referents.resolution import resolve
from esg.draft.discourse.scene import MAX_TIME_S
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.grammar.rewrites.shares import dealt
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount


def facts_of(d: Discourse, node: str) -> list[Amount]:
    """The quantities that the prompt tells of a node, in the order of the text."""
    out: list[Amount] = []
    for m, p in d.attached:
        listed = [p.mention, *p.mention.coordinated] if p.mention is not None else []
        told = [a for x in listed if x.attribute for a in x.amounts]
        told += [p.amount] if p.amount is not None else []
        if told and node in m.entities:
            out += dealt(told, len(m.entities))[m.entities.index(node)]
    for f in d.told:
        ids = f.subject.entities if f.subject is not None else []
        if node in ids:
            out += dealt([a for _, a in amounts_of(d, f)], len(ids))[ids.index(node)]
    return out


def entity_of(d: Discourse, node: str) -> Entity:
    return d.world.entities[node]


def kind_of(d: Discourse, node: str) -> str:
    return entity_of(d, node).noun.kind


def structural(d: Discourse, node: str) -> bool:
    return "structural" in entity_of(d, node).noun.traits


def aimable(d: Discourse, node: str) -> bool:
    return not structural(d, node) and kind_of(d, node) != "region"


def movable(d: Discourse, node: str) -> bool:
    return entity_of(d, node).movable


def mark_used(d: Discourse, item: Amount | Frame | Mention | None, note: str) -> None:
    if item is None:
        return
    if isinstance(item, Frame):
        d.scene.used[(item.verb.start, item.verb.end)] = note
    else:
        d.scene.used[(item.start, item.end)] = note


def describe(d: Discourse, f: Frame) -> str:
    ends = [f.verb.end]
    starts = [f.verb.start]
    for m in (f.subject, f.object):
        if m is not None:
            starts.append(m.start)
            ends.append(m.end)
    for p in f.phrases:
        if p.mention is not None:
            ends.append(p.mention.end)
        if p.amount is not None:
            ends.append(p.amount.end)
    if max(ends) - min(starts) > 160:
        return d.text[f.verb.start : f.verb.end]
    return d.text[min(starts) : max(ends)]


def ids_of(
    d: Discourse, m: Mention | None, subject: bool = False, avoid: list[str] | None = None
) -> list[str]:
    if m is None:
        return []
    return resolve(d.world, m, subject=subject, avoid=avoid)


def amounts_of(d: Discourse, f: Frame) -> list[tuple[str, Amount]]:
    """(preposition, amount) of a frame, those inside attribute phrases included."""
    out: list[tuple[str, Amount]] = []
    for p in f.phrases:
        if p.amount is not None:
            out.append((p.prep, p.amount))
        if p.mention is not None:
            out += [(p.prep, a) for a in p.mention.amounts if p.mention.attribute]
            for m in p.mention.coordinated:
                out += [(p.prep, a) for a in m.amounts if m.attribute]
    for m in (f.object, f.object2):
        if m is not None and m.attribute:
            out += [("", a) for a in m.amounts]
    if f.subject is not None:
        out += [("", a) for a in f.subject.amounts if a.dimension == "speed"]
    out = [(p, part) for p, a in out for part in a.shares or (a,)]
    told = [(p, a) for p, a in out if a.dimension != "time" or a.high <= MAX_TIME_S]
    return [(p, a) for p, a in told if a.measure != "period"]  # "every second": what recurs


def quantity_of(d: Discourse, f: Frame, dimension: str) -> tuple[str, Amount] | None:
    return next(((p, a) for p, a in amounts_of(d, f) if a.dimension == dimension), None)
