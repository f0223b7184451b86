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
from esg.draft.discourse.core import entity_of, kind_of, movable, structural
from esg.draft.discourse.levers import ACROSS
from esg.draft.discourse.places import TOPS, elevated
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import GROUND, LIMBED, Relation
from esg.draft.discourse.windows import Draft
from esg.draft.events.courses import measurable
from esg.draft.events.ends import EDGES
from esg.draft.events.roles import is_tool
from esg.draft.events.stated import comes_later, start_of
from esg.draft.events.told import happened, traits_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.statements.account import (
    NOTHING,
    PASSED_OVER,
    Account,
    Gap,
    about_of,
    held,
    nodes_of,
    starts_somewhere,
    turns,
)
from esg.draft.statements.arranged import FILES, in_line
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent, Predicate, Statement, TimelineEdge
from esg.lexicon.postures import STANDS

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
_OFF = frozenset({"off", "off of"})
_EITHER_SIDE = re.compile(
    r"(?:both|either|opposite|each|all|the (?:far|near|other|same))\s+(?:sides?|ends?|edges?)\b",
    re.IGNORECASE,
)
"""Sides of which one edge that something falls over is not enough, or may be the wrong one."""
_TURNED_TO = frozenset({"left", "right", "front", "back", "forward", "backward"})
_BESIDE_IT = frozenset(
    {"behind", "in front of", "under", "beside", "next to", "past", "around", "above", "over"}
)
NO_REFERENT = "nothing that was named before is meant"
_BORNE = frozenset({"inside_of", "on"})
_TO_A_PART = frozenset({"to", "toward", "towards", "at", "in", "into", "under", "with"})
_BACK_TO = frozenset({"into", "to", "onto", "down", "toward", "towards"})
_TOWARD = frozenset({"to", "toward", "towards"})
_GOING_FOR = lex.word_set("goes for")
_UNEQUAL = lex.word_set("unequal")
_STOPPING = frozenset({"stop", "brake", "slow", "park"})
_SIDED = frozenset({"to", "from", "at", "on"})
_EXTREMES = frozenset({"end", "edge", "corner", "tip"})
_ON = frozenset({"on", "onto", "upon"})
_OF_ROOMS, _IN_A_ROOM = frozenset({"end", "corner"}), frozenset({"in", "at", "to", "into", "near"})
_LEVELLED = frozenset({"same", "different", "various"})
_LEVELS = frozenset({"height", "level", "altitude"})
_BY_THE_EDGE = frozenset({"along", "alongside", "at", "near", "by", "close to", "beside"})
_BEFORE = re.compile(r"\bbefore (?:an? |the )?$", re.IGNORECASE)
_OWN = frozenset({"own", "fly", "reverse"})
_DRIVEN_INTO = lex.word_set("driven into (phrases)")
_GOING = frozenset({"own", "fly", "reverse", "roll", "slide", "coast", "continue"})
_INNER = frozenset({"in", "into", "inside", "within", "inside of"})
_CLOSED = frozenset({"appliance", "electronics", "building", "vehicle"})
"""Kinds of things that have an inside, which nothing is put into."""
_FLAT = frozenset({"support", "structural"})
_ENTERED = frozenset({"building", "structure"})
_ENDS = frozenset({"ends_on", "ends_in", "ends_near", "above", "under"})
_HITS = lex.word_set("hits (phrases)")
ONE_WAY = "its way does not change there: it is on it from the start, or never"
IDLE = "nobody has it in hand: it takes no part"
_TO_PIECES = lex.word_set("to pieces")
_FEET = frozenset({"bottom", "foot"})
_BESIDE = frozenset({"left_of", "right_of", "in_front_of", "behind", "above", "under"})
_PLACES = frozenset(
    {Predicate.BEHIND, Predicate.IN_FRONT_OF, Predicate.LEFT_OF, Predicate.RIGHT_OF}
    | {Predicate.ABOVE, Predicate.UNDER, Predicate.SUPPORTED_BY, Predicate.INSIDE}
)
_OPPOSITE = {
    "left_of": "right_of", "right_of": "left_of", "in_front_of": "behind",
    "behind": "in_front_of", "above": "under", "under": "above",
}  # fmt: skip


_GIVES_WAY = (NodeEvent.BREAK, NodeEvent.TOPPLE)
"""What becomes of a thing that something goes through."""


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


Asked = dict[int, tuple[Phrase, Frame | None, set[str]]]
"""Phrases by the identity of what they name, with their clause and whom they are about."""


def _asked(a: Account) -> tuple[Asked, set[int]]:
    """The phrases to ask, and which of them name a tool."""
    asked: Asked = {}
    for f in a.frames:
        about = about_of(a.d, f)
        for p in f.phrases:
            if not _side_of_a_turn(a.d, f, p):
                asked.setdefault(id(p.mention), (p, f, set()))[2].update(about)
            about |= {*nodes_of(a.d, p.mention)}
    for f in a.lost:
        for p in f.phrases:
            if nodes_of(a.d, p.mention) and p.prep in carriers():
                asked.setdefault(id(p.mention), (p, None, set()))[2].update(about_of(a.d, f))
    for m, p in a.d.attached:
        asked.setdefault(id(p.mention), (p, None, set()))[2].update(nodes_of(a.d, m))
    tools = {id(p.mention) for m, p in a.d.attached if is_tool(a.d, m, p)}
    for p in _of_lost_verbs(a):
        tools.add(id(p.mention))
        asked.setdefault(id(p.mention), (p, None, set()))
    return asked, tools


def phrases(a: Account) -> Iterator[Gap]:
    """Phrases of clauses and nouns ("passes under a bridge", "a cart of laundry")."""
    asked, tools = _asked(a)
    for p, f, about in asked.values():
        m = p.mention
        if id(m) in tools and m is not None and not _acts(a, {*nodes_of(a.d, m)}):
            yield Gap(max(start_of(p, a.d.text), 0), m.end, IDLE, tuple(nodes_of(a.d, m)))
            continue
        if m is None or _needs_no_answer(a, p, m, f):
            continue
        others = {*nodes_of(a.d, m)}
        if m.pronoun and "other" in m.adjectives and about and about <= others:
            yield Gap(max(start_of(p, a.d.text), 0), m.end, "there are no others in the scene")
        if not about and p.prep in _SIDED and {m.head, m.part} & {"left", "right"}:
            yield Gap(max(start_of(p, a.d.text), 0), m.end, NOTHING)  # of whom is not clear
        if m.pronoun and p.prep in _BESIDE_IT and others and about and about <= others:
            yield Gap(max(start_of(p, a.d.text), 0), m.end, NO_REFERENT, tuple(sorted(about))[:1])
            continue
        about -= others
        if _off_a_side(a, about, p):
            yield Gap(max(start_of(p, a.d.text), 0), m.end, "nothing sees to the side")
        elif f is not None and comes_later(p, f, a.d.text) and not _met(a, others):
            start = a.d.text.lower().rfind("then", 0, start_of(p, a.d.text))
            yield Gap(start, m.end, ONE_WAY, tuple(sorted(about))[:1])
        elif about and not (
            _answered(a, about, others, p, f) if others else _no_place(a, about, p)
        ):
            start = max(start_of(p, a.d.text), 0)
            back = p.prep in _BACK_TO and a.d.text[:start].lower().endswith(" back ")
            missing = f'nothing in the scene stands for "{p.prep}"'
            yield Gap(start - 5 * back, m.end, missing, tuple(sorted(about))[:1])


def _met(a: Account, others: set[str]) -> bool:
    """Whether an event is about some of these, or where one ends."""
    regions = {str(n.extra.get("region", "")).split("/")[0] for n in a.d.timeline.nodes}
    return bool(others & (regions | {i for n in a.d.timeline.nodes for i in n.participants}))


def _needs_no_answer(a: Account, p: Phrase, m: Mention, f: Frame | None) -> bool:
    """Phrases of measures, of nothing, of reasons, and of what is compared already."""
    if p.amount is not None or m.amounts or m.count == 0:
        return True  # "with no other cars": none is drawn
    if p.prep in _WHY and not _waited_for(a, p, f):
        return True
    compared = p.prep == "than" and any(0 <= m.start - b <= 1 for _, b in a.d.scene.compared)
    return compared  # "is heavier than a ball": it is


def _off_a_side(a: Account, about: set[str], p: Phrase) -> bool:
    """ "Slides off the left side of the table": over any edge, if no word leads it there."""
    m = p.mention
    words = {*m.part.split(), *([m.head] if m.attribute else [])} if m is not None else set[str]()
    several = m is not None and _EITHER_SIDE.match(a.d.text, m.start) is not None
    if p.prep not in _OFF or not (words & _SIDES.keys() or several):
        return False
    led = (s for s in a.kept if s.direction in _TURNED_TO and about & {*s.object})
    return not any(led)


def _waited_for(a: Account, p: Phrase, f: Frame | None) -> bool:
    """ "Stops for a woman", "reaches for a mug": she has to be where it stops, it is gone for."""
    if f is None or p.prep != "for":
        return False
    stopping = f.verb.sense in _STOPPING or f.verb.lemma in _GOING_FOR
    m = p.mention
    thing = m is not None and bool(m.noun or m.pronoun)  # not "for a second"
    others = {i for i in nodes_of(a.d, p.mention) if thing and not structural(a.d, i)}
    asked = {c.to for n in a.d.timeline.nodes for c in n.constraints}
    return stopping and bool(others) and not others & asked


def _of_lost_verbs(a: Account) -> Iterator[Phrase]:
    """ "With its suction cup, the robot picks boxes off a belt": nothing was made of the verb."""
    for f in a.d.told:
        lost = (f.verb.start, f.verb.end) in a.d.scene.ignored and not (f.unreal or f.verb.negated)
        for p in f.phrases if lost else ():
            loose = [i for i in nodes_of(a.d, p.mention) if movable(a.d, i)]
            if p.prep == "with" and loose and all(kind_of(a.d, i) not in LIMBED for i in loose):
                yield p


def _acts(a: Account, who: set[str]) -> bool:
    """Whether something takes part in an event or moves."""
    acting = {i for n in a.d.timeline.nodes for i in n.participants}
    return bool(who & (acting | {e.actor for e in a.d.timeline.edges}))


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
        if not prep or id(m) in taken or not nodes:
            continue
        if prep in _WHY or (prep in _WAYS and any(structural(d, i) for i in nodes)):
            continue
        if nodes & told and (prep not in carriers() or _told_with_it(a, m, nodes, prep)):
            continue
        start = d.text.lower().rfind(prep, 0, m.start)
        missing = f'nothing in the scene stands for "{prep}"'
        yield Gap(start if start >= 0 else m.start, m.end, missing, tuple(sorted(nodes))[:1])


def _told_with_it(a: Account, m: Mention, nodes: set[str], prep: str) -> bool:
    """Whether the document tells of what a preposition names with anything in its sentence."""
    start = max(a.d.text.rfind(mark, 0, m.start) for mark in (". ", "; ", "! ", "? ", "\n"))
    beside = (x for x in a.d.mentions if start < x.start < m.start)
    about = {i for x in beside for i in nodes_of(a.d, x)} - nodes
    asked = any(c.to in nodes for n in a.d.timeline.nodes for c in n.constraints)
    return asked or not about or _answered(a, about, nodes, Phrase(prep, m), None)


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
    words = set[str]() if p.mention is None else {p.mention.head, p.mention.part}
    about, sided = about_of(d, f), words & {"left", "right"}
    ways = [n.extra.get("turn_direction") for n in d.timeline.nodes if about & {*n.participants}]
    return bool(sided) and turns(d, about) and (not {*ways} <= {None, "any"} or None in ways)


def _no_place(a: Account, about: set[str], p: Phrase) -> bool:
    """Whether a phrase that names nothing in the scene need not be missed."""
    m = p.mention
    assert m is not None
    if _LEVELLED & {*m.adjectives} and m.head in _LEVELS:
        return False  # nothing sees to it that two things start at one height, or at several
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
    unequal = m.attribute and bool(_UNEQUAL & {*m.adjectives})  # "of different weight"
    passed = (
        (p.prep == "of" and not unequal)
        or "same" in m.adjectives
        or m.pronoun
        or m.head in PASSED_OVER
    )
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
        return _leaves(a, about, m)  # "falls off the edge"
    # "breaks upon impact"
    return m.head in _HITS and _takes_part(a, NodeEvent.COLLISION, about)


def _leaves(a: Account, about: set[str], m: Mention) -> bool:
    """Whether what falls off an edge is on something, and that was named last before the edge."""
    d = a.d
    fallen = {i for n in d.timeline.nodes if n.event is NodeEvent.FALL for i in n.participants}
    who = [i for i in about & fallen if i in d.world.entities]
    hosts = {d.scene.supported_by[i] for i in who if i in d.scene.supported_by}
    if not hosts or m.part not in EDGES:
        return not who or any(starts_somewhere(d, i) or i in d.timeline.tracks for i in who)
    named = (nodes_of(d, x) for x in reversed(d.mentions) if x.start < m.start)
    mates = {x for i in who for x in d.world.groups.get(entity_of(d, i).group or "", [])}
    boards = (i for ids in named for i in ids if elevated(d, i) and i not in fallen | mates)
    last = next(boards, None)
    return last is None or last in hosts


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
    if part and _starts_at_part(a, about, others, part):
        return True
    if p.prep in _BY_THE_EDGE and {*part.split()} & _EXTREMES and not _marked(part):
        return False  # "rides along the right edge of the road": anywhere on it
    if part in TOPS and any("incline" in traits_of(d, i) for i in others if i in d.world.entities):
        return _on_its_top(a, about, others)
    by = _carrier(d, others, p, part, f)
    if others and all(d.world.entities[i].lever == "fulcrum" for i in others):
        return p.prep in ACROSS and any(d.world.entities[i].lever for i in about)
    if p.prep == "along" and _stands_along(d, about, others):
        return True
    if part in _OF_ROOMS and p.prep in _IN_A_ROOM and GROUND in others:
        return False  # "in the corner of a room": no wall is drawn
    if part in _EXTREMES and p.prep == "from" and not _takes_part(a, NodeEvent.FALL, about):
        return False  # "rolls from one end of a bench"
    if any(structural(d, i) for i in others):
        hangs = any(_tells(s, about, others, p.prep, by) for s in a.kept)  # "from the ceiling"
        return hangs or _answered_by_ground(a, about, others, p)
    if part and part not in _SIDES and part != "surface" and p.prep in _TO_A_PART:
        return _told_of_a_part(a, about, others)
    if _on_an_end(p, part) and not _shows_an_end(a, about, others):
        return False  # "sits on one end of a plank": it is anywhere on it
    if p.prep == "with" and _at_rest(f) and _has_a_place(a, about, others):
        return True
    return _stands_for_it(a, about, others, p, f, by)


def _stands_along(d: Discourse, about: set[str], others: set[str]) -> bool:
    """ "Boxes are lined up along a wall": what stays where it is, all of it near the wall."""
    near = {
        r.source for r in d.scene.relations if r.kind in ("near", "adjacent") and r.target in others
    }
    going = {e.actor for e in d.timeline.edges}
    return bool(about) and about <= near and not about & going


def _starts_at_part(a: Account, about: set[str], others: set[str], part: str) -> bool:
    """ "A cup at one end of a table": whether a statement has the end, the edge or the corner."""
    word = part.split()[-1]
    at = (s for s in a.kept if s.predicate is Predicate.AT_PART and word in (s.noun or "").split())
    return any(about & {*s.object} and others & {*s.target} for s in at)


def _on_an_end(p: Phrase, part: str) -> bool:
    """ "On one end of a plank"."""
    return bool(part) and part.split()[-1] in _EXTREMES and p.prep in _ON


def _stands_for_it(
    a: Account, about: set[str], others: set[str], p: Phrase, f: Frame | None, by: Carriers
) -> bool:
    """Whether a hold, a relation, a statement, an event or an aim stands for a preposition."""
    d = a.d
    own = {node for g, node in d.times.of_frame if f is not None and g.verb is f.verb}
    return (
        (by.holds and held(d, about, others))
        or _related(d, about, others, by)
        or any(_tells(s, about, others, p.prep, by) for s in a.kept)
        or any(_happens(d, n, about, others, p.prep, by, own) for n in d.timeline.nodes)
        or any(_aims(e, about, others, by.aims) for e in d.timeline.edges)
    )


def _on_its_top(a: Account, about: set[str], others: set[str]) -> bool:
    """ "Is let go at the top of a ramp": what runs down it starts there, with what stays there."""
    runs = any(s.direction == "down" and {*s.target} & others for s in a.kept)
    there = {i for i in about if a.d.scene.supported_by.get(i) in others}
    return runs and bool(there) and all(kind_of(a.d, i) in LIMBED for i in about - there)


def _marked(part: str) -> bool:
    """Whether a part is nothing but the place where something ends ("along the edge")."""
    return part.split()[0] not in ("left", "right", "far", "near", "outer", "inner", "front")


def _at_rest(f: Frame | None) -> bool:
    """Whether a phrase belongs to a noun, or to a verb of what only is somewhere."""
    return f is None or f.verb.sense in ("be", "posture", "have")


def _has_a_place(a: Account, about: set[str], others: set[str]) -> bool:
    """ "A tent with a flag behind it", "a woman with a stick": where they are is told."""
    told = {r.source for r in a.d.scene.relations if r.kind in _BESIDE}
    told |= {i for s in a.kept if s.predicate in _PLACES for i in s.object}
    holders = (a.d.scene.supported_by, a.d.scene.inside_of)
    told |= {i for at in holders for i, host in at.items() if host not in about}
    near = {r.source for r in a.d.scene.relations if r.target in about}
    in_hand = all(kind_of(a.d, i) in LIMBED for i in about) and not _acts(a, about)
    return bool(others) and others <= (told | near if in_hand else told)


def _answered_by_ground(a: Account, about: set[str], others: set[str], p: Phrase) -> bool:
    """Whether the document is about the ground, or what is laid on it, as a phrase is."""
    sunk = p.prep == "through" and any(
        _takes_part(a, n, about) for n in (NodeEvent.FALL, NodeEvent.TOPPLE)
    )  # "falls through the floor"
    return (
        (p.prep in _WAYS and not sunk)
        or (p.prep == "into" and GROUND not in others)
        or (p.prep == "of" and GROUND in others and _definite(p))  # "the boards of the rink"
        or (p.prep in ("above", "over") and _aloft(a, about))
        or (p.prep in ("from", "off") and GROUND in others and _rises(a, about))
        or _laid_out(a.d, about, others, p.prep)
    )


def _shows_an_end(a: Account, about: set[str], others: set[str]) -> bool:
    """ "Stands on the edge and falls off", "lands on one end of a seesaw": what follows shows."""
    comes_down = any(_takes_part(a, n, about) for n in (NodeEvent.FALL, NodeEvent.TOPPLE))
    jolted = any({j.child, j.parent} & others for j in a.d.scene.joints)
    if about <= {*a.d.scene.at_ends}:
        return True  # "sits on one end of a seesaw"
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
    if p.prep == "with":  # "a truck with a car behind it": placed by that
        by = replace(by, relations=by.relations | {*_OPPOSITE, "adjacent", "surround"})
    if p.prep == "with" and all(kind_of(d, i) in LIMBED for i in others):
        by = replace(by, relations=by.relations | {"near"})
    if p.prep == "with" and p.mention is not None and p.mention.pronoun:
        by = replace(by, relations=_BORNE)  # "the cup slides and the ball goes with it"
    side = _SIDES.get(part.removesuffix(" side"), "")
    if side:
        by = replace(by, relations=frozenset({side}))
    open_ = any(kind_of(d, i) in _ENTERED for i in others)
    driven_in = p.mention is not None and p.mention.head in _DRIVEN_INTO and p.prep in _INNER
    if driven_in and f is not None and f.verb.sense in _GOING:
        by = replace(by, events=by.events - {"Collision"})  # "rolls into a garage"
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
    """ "A drone rises from the ground", "gets up from the floor": where it is before."""
    return _takes_part(a, NodeEvent.PICKED_UP, about) or any(
        about & {*s.object} and (s.direction == "up" or s.noun == STANDS) for s in a.kept
    )


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
    if prep == "through" and n.event in _GIVES_WAY and others & also:
        return True  # "crashes through a fence", which breaks
    if not measurable(n.event) or not about & also:
        return False
    if n.id in own and any(c.to in others for c in n.constraints):
        return True  # "stops 1 m in front of a gate"
    if prep in _TOWARD and n.event is NodeEvent.MISS and n.participants[0] in others:
        return False  # "rolls toward a car": that the car gets by is something else
    inner = prep in _INNER and n.event is NodeEvent.PLACED
    closed = (kind_of(d, i) in _CLOSED or not _FLAT & traits_of(d, i) for i in others)
    if inner and any(closed):
        return False  # "puts a cake into the oven": it stands on it
    fits = not by.events or n.event.value in by.events
    return fits and bool(others & also)
