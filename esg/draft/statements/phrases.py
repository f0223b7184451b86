"""What in the document stands for a preposition: "passes under a bridge", "a cart of laundry".

`data/carriers.csv` says which relations, statements and events do, and whether holding or going
for it does.
"""

from __future__ import annotations

from collections.abc import Iterator
import csv
from dataclasses import dataclass, replace
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import kind_of, structural
from esg.draft.discourse.levers import ACROSS
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND, LIMBED, Relation
from esg.draft.discourse.windows import Draft
from esg.draft.events.courses import measurable
from esg.draft.events.stated import start_of
from esg.draft.events.told import happened, traits_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.statements.account import PASSED_OVER, Account, Gap, about_of, held, nodes_of, turns
from esg.draft.statements.arranged import FILES, in_line
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent, Predicate, Statement, TimelineEdge

_WAYS = frozenset(
    {"on", "in", "at", "along", "across", "over", "through", "down", "up", "onto", "to"}
)
"""Prepositions that the ground and what is painted on it answer by being there."""
_WHY = frozenset({"for", "like", "as", "because of", "due to", "despite"})
"""Prepositions that tell why, or what something is like, and not where it is."""
_AIR = frozenset({"air", "sky", "midair", "mid-air"})
_SIDES = {
    "front": "in_front_of",
    "back": "behind",
    "rear": "behind",
    "left": "left_of",
    "right": "right_of",
}
"""Parts that name a side, and the relation that has it ("in the front of an apple")."""
_BORNE = frozenset({"inside_of", "on"})
_TO_A_PART = frozenset({"to", "toward", "towards", "at", "in", "into", "under", "with"})
_EXTREMES = frozenset({"end", "edge", "corner", "tip"})
_ON = frozenset({"on", "onto", "upon"})
_LEVELS = frozenset({"height", "level", "altitude"})
_BEFORE = re.compile(r"\bbefore (?:an? |the )?$", re.IGNORECASE)
_OWN = frozenset({"own", "fly", "reverse"})
_INNER = frozenset({"in", "into", "inside", "within", "inside of"})
_CLOSED = frozenset({"appliance", "electronics", "building", "vehicle"})
"""Kinds of things that have an inside, which nothing is put into."""
_FLAT = frozenset({"support", "structural"})
_ENTERED = frozenset({"building", "structure"})
_ENDS = frozenset({"ends_on", "ends_in", "ends_near", "above", "under"})
_HITS = frozenset({"impact", "contact", "collision", "crash"})
_TO_PIECES = lex.word_set("to pieces")
_FEET = frozenset({"bottom", "foot"})
_OPPOSITE = {
    "left_of": "right_of", "right_of": "left_of", "in_front_of": "behind",
    "behind": "in_front_of", "above": "under", "under": "above",
}  # fmt: skip


@dataclass(frozen=True)
class Carriers:
    """What can stand for a preposition: relations, predicates, events (none given: any); support.

    `aims` is "yes" if going for what the phrase names does, "back" if that goes for who is told of.
    """

    relations: frozenset[str] = frozenset()
    states: frozenset[str] = frozenset()
    events: frozenset[str] = frozenset()
    holds: bool = True
    aims: str = "yes"
    example: str = ""


_ANY = Carriers()
"""Of prepositions without a row: anything between the two will do."""


@cache
def carriers() -> dict[str, Carriers]:
    """The table, by preposition; a cell with "none" has nothing."""
    out: dict[str, Carriers] = {}
    with open(lex.DATA / "carriers.csv", encoding="utf-8", newline="") as file:
        for r in csv.DictReader(file, delimiter=";"):
            row = Carriers(
                *[frozenset(r[k].split("|")) for k in ("relations", "states", "events")],
                holds=r["holds"] == "yes",
                aims=r["aims"],
                example=r["example"],
            )
            out.update(dict.fromkeys(r["preps"].split("|"), row))
    return out


def phrases(a: Account) -> Iterator[Gap]:
    """Phrases of clauses and nouns ("passes under a bridge", "a cart of laundry")."""
    asked: dict[int, tuple[Phrase, Frame | None, set[str]]] = {}
    for f in a.frames:
        about = about_of(a.d, f)
        for p in f.phrases:
            if not _side_of_a_turn(a.d, f, p):
                asked.setdefault(id(p.mention), (p, f, set()))[2].update(about)
            about |= {*nodes_of(a.d, p.mention)}
    for m, p in a.d.attached:
        asked.setdefault(id(p.mention), (p, None, set()))[2].update(nodes_of(a.d, m))
    for p, f, about in asked.values():
        m = p.mention
        if m is None or p.amount is not None or m.amounts or p.prep in _WHY or m.count == 0:
            continue  # "with no other cars": none is drawn
        if p.prep == "than" and any(0 <= m.start - b <= 1 for _, b in a.d.scene.compared):
            continue  # "is heavier than a ball": it is
        others = {*nodes_of(a.d, m)}
        if m.pronoun and "other" in m.adjectives and about and about <= others:
            yield Gap(max(start_of(p, a.d.text), 0), m.end, "there are no others in the scene")
        about -= others
        if about and not (_answered(a, about, others, p, f) if others else _no_place(a, about, p)):
            missing = f'nothing in the scene stands for "{p.prep}"'
            yield Gap(max(start_of(p, a.d.text), 0), m.end, missing, tuple(sorted(about))[:1])


def adrift(a: Account) -> Iterator[Gap]:
    """Things after a preposition that no clause or noun took up, and nothing is told of."""
    d = a.d
    heads = [m for f in d.told for m in (f.subject, f.object, f.object2)]
    heads += [p.mention for f in d.told for p in f.phrases]
    heads += [x for m, p in d.attached for x in (m, p.mention)]
    taken = {id(x) for m in heads if m is not None for x in (m, m.possessor, *m.coordinated)}
    told = _placed(a)
    for m in d.mentions:
        nodes = {*nodes_of(d, m)}
        conjunction = _BEFORE.search(d.text, 0, m.start)  # "stops before a crossing"
        prep = m.after_prep or ("before" if conjunction is not None else "")
        if not prep or id(m) in taken or not nodes or nodes & told:
            continue
        if prep in _WHY or (prep in _WAYS and any(structural(d, i) for i in nodes)):
            continue
        start = d.text.lower().rfind(prep, 0, m.start)
        missing = f'nothing in the scene stands for "{prep}"'
        yield Gap(start if start >= 0 else m.start, m.end, missing, tuple(sorted(nodes))[:1])


def _placed(a: Account) -> set[str]:
    """Everything that an event, a motion, a relation or a statement is about."""
    d = a.d
    out = {p for n in d.timeline.nodes for p in n.participants}
    out |= {str(n.extra.get("region", "")).split("/")[0] for n in d.timeline.nodes}
    out |= {c.to for n in d.timeline.nodes for c in n.constraints if c.to}
    out |= {x for e in d.timeline.edges for x in (e.actor, e.target) if x}
    out |= {x for r in d.scene.relations for x in (r.source, r.target)}
    out |= {x for s in a.kept for x in (*s.object, *s.target)}
    for pairs in (d.scene.supported_by, d.scene.inside_of, d.scene.marked):
        out |= {*pairs} | {*pairs.values()}
    return out


def _side_of_a_turn(d: Discourse, f: Frame, p: Phrase) -> bool:
    """ "Turns to the left": an event has the side."""
    sided = p.mention is not None and {p.mention.head, p.mention.part} & {"left", "right"}
    return bool(sided) and turns(d, about_of(d, f))


def _no_place(a: Account, about: set[str], p: Phrase) -> bool:
    """Whether a phrase that names nothing in the scene need not be missed."""
    m = p.mention
    assert m is not None
    if "same" in m.adjectives and m.head in _LEVELS:
        return False  # nothing sees to it that two things start at one height
    if _in_pieces(a, about, m) or _names_nothing(a, p, m):
        return True
    if m.noun is not None and m.noun.kind == "region":  # "into the side pocket"
        return any(n.event is NodeEvent.ENTER_REGION for n in a.d.timeline.nodes)
    return _where_it_happens(a, about, p, m) or _told_already(a, about, p, m)


def _in_pieces(a: Account, about: set[str], m: Mention) -> bool:
    """ "Shatters into pieces"."""
    return m.head in _TO_PIECES and any(happened(a.d, NodeEvent.BREAK, i) for i in about)


def _names_nothing(a: Account, p: Phrase, m: Mention) -> bool:
    """Whether a phrase says how or of what, or was used for something else."""
    passed = p.prep == "of" or "same" in m.adjectives or m.pronoun or m.head in PASSED_OVER
    return bool(passed) or (m.start, m.end) in a.d.scene.used


def _where_it_happens(a: Account, about: set[str], p: Phrase, m: Mention) -> bool:
    """Whether an event has the place that a phrase names."""
    if p.prep == "in" and m.head in FILES and in_line(a.d, about):
        return True
    if m.head in ("spot", "place") and _takes_part(a, NodeEvent.SPIN, about):
        return True  # "spins on the spot"
    if p.prep == "at" and m.head in _FEET and _below_a_slope(a, about):
        return True
    if p.prep in ("off", "over", "from") and _takes_part(a, NodeEvent.FALL, about):
        return True  # "falls off the edge"
    # "breaks upon impact"
    return m.head in _HITS and _takes_part(a, NodeEvent.COLLISION, about)


def _takes_part(a: Account, event: NodeEvent, about: set[str]) -> bool:
    return any(n.event is event and about & {*n.participants} for n in a.d.timeline.nodes)


def _told_already(a: Account, about: set[str], p: Phrase, m: Mention) -> bool:
    """Whether a statement has the phrase's words, or that its things are in the air."""
    start = start_of(p, a.d.text)
    if any(s.start < m.end and start < s.end for s in a.kept):
        return True
    return m.head in _AIR and _flies(a, about)


def _flies(a: Account, about: set[str]) -> bool:
    aloft = (s for s in a.kept if s.predicate is Predicate.AIRBORNE or s.direction == "up")
    return any(about & {*s.object} for s in aloft)


def _below_a_slope(a: Account, about: set[str]) -> bool:
    """ "Slides down a chute and hits a box at the bottom": what is hit stands on the ground."""
    d = a.d
    falls = {
        s.object[0] for s in a.kept if s.predicate is Predicate.MOVES and s.direction == "down"
    }
    for n in d.timeline.nodes:
        who = {*n.participants} & about
        met = who - falls
        slid = who & falls
        if n.event is NodeEvent.COLLISION and slid and met:
            return not any(d.scene.supported_by.get(i) for i in met)
    return False


def _answered(a: Account, about: set[str], others: set[str], p: Phrase, f: Frame | None) -> bool:
    """Whether something in the document is about both what a phrase names and who it is said of."""
    d, part = a.d, p.mention.part if p.mention is not None else ""
    by = _carrier(d, others, p, part, f)
    if others and all(d.world.entities[i].lever == "fulcrum" for i in others):
        return p.prep in ACROSS and any(d.world.entities[i].lever for i in about)
    if any(structural(d, i) for i in others):
        hangs = any(_tells(s, about, others, p.prep, by) for s in a.kept)  # "from the ceiling"
        return hangs or _answered_by_ground(a, about, others, p)
    if part and part not in _SIDES and part != "surface" and p.prep in _TO_A_PART:
        return _told_of_a_part(a, about, others)
    if (
        part
        and part.split()[-1] in _EXTREMES
        and p.prep in _ON
        and not _shows_an_end(a, about, others)
    ):
        return False  # "sits on one end of a plank": it is anywhere on it
    own = {node for g, node in d.times.of_frame if f is not None and g.verb is f.verb}
    return (
        (by.holds and held(d, about, others))
        or _related(d, about, others, by)
        or any(_tells(s, about, others, p.prep, by) for s in a.kept)
        or any(_happens(d, n, about, others, p.prep, by, own) for n in d.timeline.nodes)
        or any(_aims(e, about, others, by.aims) for e in d.timeline.edges)
    )


def _answered_by_ground(a: Account, about: set[str], others: set[str], p: Phrase) -> bool:
    """Whether the document is about the ground, or what is laid on it, as a phrase is."""
    return (
        p.prep in _WAYS
        or (p.prep == "into" and GROUND not in others)
        or (p.prep == "of" and GROUND in others and _definite(p))  # "the boards of the rink"
        or (p.prep in ("above", "over") and _aloft(a, about))
        or (p.prep == "from" and GROUND in others and _rises(a, about))
        or _laid_out(a.d, about, others, p.prep)
    )


def _shows_an_end(a: Account, about: set[str], others: set[str]) -> bool:
    """ "Stands on the edge and falls off", "lands on one end of a seesaw": what follows shows."""
    comes_down = any(_takes_part(a, n, about) for n in (NodeEvent.FALL, NodeEvent.TOPPLE))
    jolted = any({j.child, j.parent} & others for j in a.d.scene.joints)
    return comes_down or (jolted and _takes_part(a, NodeEvent.COLLISION, others))


def _told_of_a_part(a: Account, about: set[str], others: set[str]) -> bool:
    """Whether a statement tells where something ends, or which part of another is struck."""
    return any(
        (about & {*s.object} and s.predicate.value in _ENDS)
        or (others & {*s.object} and s.predicate is Predicate.STRUCK_ON)
        for s in a.kept
    )


def _carrier(d: Discourse, others: set[str], p: Phrase, part: str, f: Frame | None) -> Carriers:
    """What of a document may carry the meaning of a phrase."""
    by = carriers().get(p.prep, _ANY)
    if p.prep == "with" and all(kind_of(d, i) in LIMBED for i in others):
        by = replace(by, relations=by.relations | {"near"})
    if p.prep == "with" and p.mention is not None and p.mention.pronoun:
        by = replace(by, relations=_BORNE)  # "the cup slides and the ball goes with it"
    if part in _SIDES:
        by = replace(by, relations=frozenset({_SIDES[part]}))
    open_ = any(kind_of(d, i) in _ENTERED for i in others)
    leapt = f is not None and any(d.moves.upon.get(i) in others for i in about_of(d, f))
    if not leapt and f is not None and f.verb.sense in _OWN and (open_ or p.prep in ("on", "onto")):
        by = replace(by, events=by.events - {"Collision"})  # "jumps onto a box" is no bump
    return by


def _definite(p: Phrase) -> bool:
    return p.mention is not None and p.mention.determiner == "the"


def _aloft(a: Account, about: set[str]) -> bool:
    """Whether something is said to be in the air, or how high it is."""
    return _flies(a, about) or bool(about & {*a.d.scene.heights})


def _rises(a: Account, about: set[str]) -> bool:
    """ "A drone rises from the ground": where what rises is before."""
    return any(s.direction == "up" and about & {*s.object} for s in a.kept)


def _laid_out(d: Discourse, about: set[str], others: set[str], prep: str) -> bool:
    """Whether the document has something on or beside what is laid ("by the side of the road")."""
    others = others - {GROUND}
    marked = any(i in about and road in others for i, road in d.scene.marked.items())
    told = any(r.source in about and r.target in others and r.text == prep
               for r in d.scene.relations)  # fmt: skip
    return marked or (told and prep in carriers() and "near" in carriers()[prep].relations)


def _aims(e: TimelineEdge, about: set[str], others: set[str], which: str) -> bool:
    """Whether who is told of goes for what a phrase names; "back": the other way round."""
    ends = (e.actor, e.target) if which == "yes" else (e.target, e.actor)
    return bool(which) and ends[0] in about and ends[1] in others


def _related(d: Discourse, about: set[str], others: set[str], by: Carriers) -> bool:
    for r in d.scene.relations:
        ends = {r.source, r.target, r.text}
        fits = not by.relations or r.kind in by.relations
        if ends & others and ends & about and fits and not _changed(d, r):
            return True
    return False


def _changed(d: Discourse, r: Relation) -> bool:
    """ "Is left of a vase, then right of it": only where it is first is kept."""
    first = next(q for q in d.scene.relations if (q.source, q.target) == (r.source, r.target)
                 and q.kind in (r.kind, _OPPOSITE.get(r.kind)))  # fmt: skip
    return first.kind != r.kind


def _tells(s: Statement, about: set[str], others: set[str], prep: str, by: Carriers) -> bool:
    ends = {*s.object, *s.target}
    fits = not by.states or s.predicate.value in by.states
    return fits and bool(ends & about) and bool(ends & others)


def _happens(
    d: Discourse,
    n: Draft,
    about: set[str],
    others: set[str],
    prep: str,
    by: Carriers,
    own: set[str],
) -> bool:
    """Whether an event tells of both, or one of the clause's own is told by its place."""
    also = {*n.participants, str(n.extra.get("region", "")).split("/")[0]}
    if not measurable(n.event) or not about & also:
        return False
    if n.id in own and any(c.to in others for c in n.constraints):
        return True  # "stops 1 m in front of a gate"
    inner = prep in _INNER and n.event is NodeEvent.PLACED
    closed = (kind_of(d, i) in _CLOSED or not _FLAT & traits_of(d, i) for i in others)
    if inner and any(closed):
        return False  # "puts a cake into the oven": it stands on it
    fits = not by.events or n.event.value in by.events
    return fits and bool(others & also)
