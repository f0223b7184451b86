"""Several times in one clause: "The cars brake after 2 s and 3 s", "hits A at 1 s and B at 3 s"."""

from __future__ import annotations

from dataclasses import replace

from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention


def one_time_each(d: Discourse, f: Frame) -> list[Frame]:
    """ "The cars brake after 2 s and 3 s": a clause for each member, with its own time."""
    m = f.subject
    timed = [p for p in f.phrases if p.amount is not None and p.amount.dimension == "time"]
    at = [p for p in timed if p.prep in ("after", "at", "in", "")]
    if m is None or len(at) < 2 or len(at) != len(timed):
        return [f]
    shared = _times_of_objects(f, timed)
    if len(shared) > 1:
        return shared
    many = m.plural or bool(m.coordinated) or len(m.entities) > 1
    if not many or len(m.entities) < len(at) or (len(m.entities) > len(at) and m.count):
        return [f]
    return _members_in_turn(d, f, m, timed, at)


def _times_of_objects(f: Frame, timed: list[Phrase]) -> list[Frame]:
    """ "hits the wall after 1 s and the box after 3 s": a clause for each object."""
    o = f.object
    if o is None or not o.coordinated or len(timed) != len(o.coordinated) + 1:
        return [f]
    things = [o, *o.coordinated]
    spans = [t.start for t in things] + [10**9]
    out: list[Frame] = []
    for k, (thing, p) in enumerate(zip(things, timed, strict=True)):
        assert p.amount is not None
        if not spans[k] < p.amount.start < spans[k + 1]:
            return [f]
        mine = [i for i in thing.entities if not any(i in c.entities for c in things[k + 1 :])]
        own = replace(thing, entities=mine, coordinated=[])
        rest = [q for q in f.phrases if q not in timed]
        at = replace(p, prep=p.prep if k == 0 else "at")  # both from the start
        out.append(replace(f, object=own, phrases=[*rest, at]))
    return out


def _members_in_turn(
    d: Discourse, f: Frame, m: Mention, timed: list[Phrase], at: list[Phrase]
) -> list[Frame]:
    prep = at[0].prep or "after"
    out: list[Frame] = []
    for k, p in enumerate(at):
        rest = [q for q in f.phrases if q not in timed]
        own = replace(m, entities=[m.entities[k]], coordinated=[], amounts=[])
        start = prep if k == 0 or d.timeline.last_event is not None else "at"
        out.append(replace(f, subject=own, phrases=[*rest, replace(p, prep=start)]))
    return out
