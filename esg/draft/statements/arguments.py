"""Who and what a clause is about, and the document tells nothing of."""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, movable, structural
from esg.draft.discourse.record import Discourse
from esg.draft.events.stated import start_of
from esg.draft.events.told import happened
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.grammar.clauses.modality import FAILED, STOPPED_FIRST
from esg.draft.statements.account import CHAINS, NOTHING, PASSED_OVER, Account, Gap, held, nodes_of
from esg.draft.statements.adverbs import ONCE
from esg.draft.statements.phrases import NO_REFERENT
from esg.draft.text.elements import Mention
from esg.graph.models import NodeEvent, Predicate

_EACH = frozenset(
    {"own", "fly", "fall", "roll", "slide", "launch", "drop", "bounce", "coast", "topple"}
    | {"carry", "pick", "brake", "stop", "turn", "swerve", "spin", "reverse", "jump"}
)
"""Senses of which each of several things needs a motion of its own."""
_SENT = frozenset({"launch", "drop", "carry", "pick", "phrase"})
"""Senses of which what the clause acts on moves."""
_SWEPT = frozenset({"knock", "hit", "scatter"})
"""Senses of which what the clause acts on moves, where it goes off something."""
_KEEPS = re.compile(r"(?:keep|keeps|kept|keeping)\b(?:\s+on\b)?", re.IGNORECASE)
_SINGLE = frozenset(
    {"hit", "drop", "launch", "fall", "knock", "topple", "jump", "enter", "land", "stop", "pick"}
)
"""Senses of which one event is all that the scene has."""
_ENDS = frozenset({NodeEvent.STOP, NodeEvent.FALL, NodeEvent.TOPPLE, NodeEvent.ENTER_REGION})
"""Events of which one of several that move is no stand-in for the others."""
_STATES = frozenset(
    {"be", "posture", "left_so", "have", "weigh", "contain", "measure", "unknown", "lead", "noop",
     "park"}
)  # fmt: skip
_ALONG = frozenset({"own", "tow", "carry"})
"""Senses of which who does it goes where the object goes."""
_MET = frozenset({"past", "into", "against", "onto", "over", "off"})
_AS_ONE = CHAINS | {"stack"}
_FELLED = frozenset({"domino", "pin"})
_SEEN = frozenset(
    {NodeEvent.COLLISION, NodeEvent.MISS, NodeEvent.FALL, NodeEvent.TOPPLE, NodeEvent.ENTER_REGION}
)
"""Events of which each of several things needs its own."""
_PASSED = frozenset({"overtake", "pass"})
"""Senses of which no member of a row passes on what is done to it."""
_TRIED = "an attempt"
_ALMOST = "almost"
NEARLY = "nothing in the scene shows how near it comes"
_SHARE = re.compile(
    r"(?:one|two|three|four|five|some|many|few|several) of (?:the|its|his|her|their|these|those)\b",
    re.IGNORECASE,
)
_COMES_OFF = frozenset({"fall", "drop", "roll", "slide", "topple", "launch", "fly", "breaking"})
_LOOSENED = frozenset({"head"})
_GIVEN = lex.word_set("blows (light verbs)")
_GIVES = frozenset({"hit", "launch", "knock", "topple"})
_LIFTED = lex.word_set("picks up")
_NAMED_BEFORE = frozenset({"it", "him", "them"})
AT_ONCE = "nothing makes it wait so long"
SOME = "only some of them do"
FEWER = "only some of them do in the scene"
NO_EVENT = "nothing of the kind happens in the scene"


def arguments(a: Account) -> Iterator[Gap]:
    """What a clause says something of and the document does not ("a girl walks a dog")."""
    d, taking = a.d, _taking_part(a)
    for f in a.frames:
        if f.verb.sense in _STATES:
            continue
        for m in (f.subject, f.object):
            ids = nodes_of(d, m)
            if ids and not {*ids} & taking and not structural(d, ids[0]):
                yield Gap(f.verb.start, f.verb.end, NO_EVENT, tuple(ids))
        m = f.object if f.verb.sense not in ("avoid", "miss") else None
        if m is None or nodes_of(d, m) or m.amounts or m.count == 0:
            continue
        if m.pronoun:
            if m.pronoun in _NAMED_BEFORE and f.verb.sense in _SENT | _ALONG:
                yield Gap(m.start, m.end, NO_REFERENT)  # "Smith drives it low"
            continue
        if m.head not in PASSED_OVER and (m.start, m.end) not in d.scene.used:
            yield Gap(m.start, m.end, NOTHING)


def _taking_part(a: Account) -> set[str]:
    """What events, motions, relations, joints and statements of the document are about."""
    d, scene = a.d, a.d.scene
    taking = {i for n in d.timeline.nodes for i in n.participants}
    taking |= {str(n.extra.get("region", "")).split("/")[0] for n in d.timeline.nodes}
    taking |= {i for e in d.timeline.edges for i in (e.actor, e.target) if i}
    told = [r for r in scene.relations if r.kind != "structural"]
    taking |= {i for r in told for i in (r.source, r.target, r.text)}
    for at in (scene.supported_by, scene.inside_of, scene.attached, scene.marked, scene.facing):
        taking |= {i for pair in at.items() if not structural(d, pair[1]) for i in pair}
    taking |= {i for s in a.said for i in (*s.object, *s.target)} | {*d.moves.still}
    return taking | {j.parent for j in scene.joints if j.child in taking and j.parent}


def left_behind(a: Account) -> Iterator[Gap]:
    """ "A woman walks a dog": what goes is only what she takes along."""
    d = a.d
    for c in d.scene.clauses:
        f = c.frame
        takes = f.verb.sense in _ALONG and c.movers and not f.verb.passive and f.object is not None
        if not takes or not any(f.verb is kept.verb for kept in a.frames):
            continue
        if f.verb.lemma in _LIFTED and any(happened(d, NodeEvent.PICKED_UP, i) for i in c.movers):
            continue  # who lifts a thing stays where he is
        doers = [i for i in nodes_of(d, f.subject) if movable(d, i) and i not in c.movers]
        going = {e.actor for e in d.timeline.edges}
        left = [i for i in doers if i not in going and not held(d, {i}, {*c.movers})]
        rides = any(
            s.predicate in (Predicate.INSIDE, Predicate.SUPPORTED_BY) and {*left} & {*s.object}
            for s in a.kept
        )
        if left and not rides:
            yield Gap(f.verb.start, f.verb.end, "who does it does not go along", tuple(left))


def some_of(a: Account) -> Iterator[Gap]:
    """ "Knocks over three of the five vases", "glides past the two buoys": fewer take part."""
    d = a.d
    acting = {i for n in d.timeline.nodes for i in n.participants}
    acting |= {e.actor for e in d.timeline.edges}
    for f in a.frames:
        if f.verb.sense in _STATES:
            continue
        met = {id(p.mention): p for p in f.phrases if p.prep in _MET}
        for m in (f.subject, f.object, *(p.mention for p in met.values())):
            told = (
                0 if m is None else m.subset or (m.count if id(m) in met or not m.head else 0) or 0
            )
            if m is None or told < 2 or _a_pair(d, m):
                continue
            chains = _AS_ONE if id(m) in met else {"row"}
            ids = [i for i in nodes_of(d, m) if entity_of(d, i).pattern not in chains]
            stand_by = tuple(i for i in ids if i not in acting)
            if not 0 < len(ids) - len(stand_by) < min(told, len(ids)):
                continue
            prep = met[id(m)].prep if id(m) in met else ""
            start = start_of(met[id(m)], d.text) if prep else 0
            if prep and d.text.lower().startswith(prep, start):
                yield Gap(start, start + len(prep), SOME, stand_by)
            elif prep:
                yield Gap(m.start, m.end, SOME, stand_by)
            else:
                yield Gap(f.verb.start, f.verb.end, SOME, stand_by)


def fewer(a: Account) -> Iterator[Gap]:
    """ "A car overtakes them", "two dice are thrown onto a table": what is made of it has one."""
    d = a.d
    made: dict[int, set[str]] = {}
    for f, node in d.times.of_frame:
        told = d.timeline.node(node)
        if told is not None and told.event in _SEEN:
            made.setdefault(f.verb.start, set()).update(told.participants)
    ever = set[str]().union(*made.values())
    for f in a.frames:
        acting = made.get(f.verb.start, set())
        if f.verb.sense in _COMES_OFF and acting:
            acting = ever  # "two cubes are dropped; one lands on a sponge": it was dropped
        for m in (f.subject, f.object) if acting else ():
            apart = f.verb.sense in _PASSED
            ids = [i for i in nodes_of(d, m) if apart or entity_of(d, i).pattern not in _AS_ONE]
            ids = [i for i in ids if entity_of(d, i).group not in d.world.vague]
            rest = tuple(i for i in ids if i not in acting)
            if m is not None and not m.single and not _a_pair(d, m) and 0 < len(rest) < len(ids):
                yield Gap(f.verb.start, f.verb.end, FEWER, rest)


def others_of(a: Account) -> Iterator[Gap]:
    """ "A lorry loses one of its barrels": there are more of them."""
    d = a.d
    for m in d.mentions:
        ids = nodes_of(d, m)
        of = _SHARE.match(d.text, m.start) if ids and m.noun is not None else None
        none = d.text[: m.start].lower().endswith("not ")
        if of is None or none or m.head in lex.OWN_PARTS | lex.BODY_PARTS:
            continue
        alike = {e.id for e in d.world.entities.values() if e.noun == entity_of(d, ids[0]).noun}
        if alike <= {*ids}:
            yield Gap(m.start, m.end, "there are no others in the scene", tuple(ids))


def attempts(a: Account) -> Iterator[Gap]:
    """ "Tries to push the peg into the hole", "almost falls off": nothing of it is to be seen."""
    d = a.d
    for f in d.told:
        who, whom = {*nodes_of(d, f.subject)}, {*nodes_of(d, f.object)}
        if f.unreal == STOPPED_FIRST:
            yield from _stops_short(a, f)
        almost = f.unreal.startswith(_ALMOST)
        if f.unreal not in (_TRIED, FAILED) and not almost:
            continue
        met = {*whom}.union(*({*nodes_of(d, p.mention)} for p in f.phrases)) - who
        acts = [{*n.participants} for n in d.timeline.nodes]
        acts += [{e.actor, e.target or ""} for e in d.timeline.edges]
        shown = any(who & act and (act & whom or (not whom and act & met)) for act in acts)
        if who | (whom if almost else set()) and not (shown and f.unreal != FAILED):
            tried = tuple(nodes_of(d, f.subject))
            missing = NEARLY if almost else "nothing of what is tried is shown"
            yield Gap(f.verb.start, f.verb.end, missing, tried)


def by_nobody(a: Account) -> Iterator[Gap]:
    """ "The kick sends the can flying": whose? Nothing in the scene touches it."""
    for f in a.frames:
        m = f.subject
        if m is None or not m.attribute or m.head not in _GIVEN or m.possessor is not None:
            continue
        before = [g for g in a.d.told if g.verb.start < m.start and g.verb.sense in _GIVES]
        whom = {*nodes_of(a.d, f.object)}
        met = (n for n in a.d.timeline.nodes if n.event is NodeEvent.COLLISION)
        if not before and not any(whom & {*n.participants} for n in met):
            yield Gap(m.start, m.end, "nothing in the scene gives it", tuple(sorted(whom)))


def unwaited(a: Account) -> Iterator[Gap]:
    """ "Hovers for three seconds, then drops": it drops at once."""
    for actor, lasting in a.d.moves.waiting.items():
        later = (c for c in a.d.scene.clauses if actor in c.movers)
        if any(c.frame.verb.start > lasting.end for c in later):
            yield Gap(lasting.start, lasting.end, AT_ONCE, (actor,))


def _stops_short(a: Account, f: Frame) -> Iterator[Gap]:
    """ "Stops just before crossing the line": where is that?"""
    named = [f.object, *(p.mention for p in f.phrases)]
    there = {i for m in named for i in nodes_of(a.d, m)}
    asked = {c.to for n in a.d.timeline.nodes for c in n.constraints}
    kept = {i for s in a.kept for i in s.target}
    if any(named) and not there & (asked | kept):
        yield Gap(f.verb.start, max(m.end for m in named if m is not None), NEARLY)


def parts_alone(a: Account) -> Iterator[Gap]:
    """ "The lid of a pot falls off": the pot does, with its lid."""
    for f in a.frames:
        m = f.subject if f.verb.sense in _COMES_OFF and f.object is None else None
        if m is not None and m.part in lex.OWN_PARTS | _LOOSENED and nodes_of(a.d, m):
            missing = f"all of it does, and not its {m.part}"
            yield Gap(f.verb.start, f.verb.end, missing, tuple(nodes_of(a.d, m)))


def _a_pair(d: Discourse, m: Mention) -> bool:
    """ "A pair of slippers" is one thing to meet."""
    return "pair of" in d.text[max(0, m.start - 10) : m.end].lower()


def _in_turn(d: Discourse, f: Frame, node: str) -> bool:
    """Whether it is one of a row of which each fells the next: not of boxes that are pushed."""
    e = entity_of(d, node)
    pushed = f.verb.sense in _SENT and e.noun.kind not in _FELLED and "topples" not in e.noun.traits
    return e.pattern in CHAINS and not pushed


def idle(a: Account) -> Iterator[Gap]:
    """Clauses that tell of several things and move only some of them."""
    moving = {e.actor for e in a.d.timeline.edges}
    moving |= {i for s in a.kept if s.predicate is Predicate.MOVES for i in s.object}
    for c in a.d.scene.clauses:
        f = c.frame
        if not any(f.verb is kept.verb for kept in a.frames) or f.verb.passive:
            continue
        swept = f.verb.sense in _SWEPT and f.phrase("off", "out of") is not None
        told = c.movers and (f.verb.sense in _EACH or swept) and f.verb.auxiliary != "have"
        several = f.object is not None and f.object.plural
        sent = f.object if several and (f.verb.sense in _SENT or swept) else f.subject
        group = nodes_of(a.d, sent) if told else []
        idle = [i for i in group if i not in moving and not _in_turn(a.d, f, i)]
        idle = idle or [i for i in _spared(a.d, f, group) if not _in_turn(a.d, f, i)]
        if 0 < len(idle) < len(group) and f.verb.start < f.verb.end:
            yield Gap(f.verb.start, f.verb.end, "only one of them does", tuple(idle))


def kept_up(a: Account) -> Iterator[Gap]:
    """ "The baby keeps dropping her spoon": it falls once."""
    for f in a.frames:
        m = _KEEPS.match(a.d.text, f.verb.start, f.verb.end)
        if m is not None and f.verb.sense in _SINGLE:
            yield Gap(m.start(), m.end(), ONCE, tuple(nodes_of(a.d, f.subject)))


def _spared(d: Discourse, f: Frame, group: list[str]) -> list[str]:
    """ "Three ice cubes slide along a bar and stop": who goes on where one of them ends."""
    made = d.timeline.node(d.scene.used.get((f.verb.start, f.verb.end), ""))
    if made is None or made.event not in _ENDS or made.participants[0] not in group:
        return []
    does = {n.participants[0] for n in d.timeline.nodes if n.event is made.event}
    return [i for i in group if i not in does]
