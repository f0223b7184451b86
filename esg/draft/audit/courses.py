"""Questions about what happens: of what it is told, what comes after, how often, which way."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.audit.case import Case, Finding, accounted, kind_of, members, number, under
from esg.draft.audit.parse import Arg, Proposition
from esg.graph.models import CoverageItem, Statement, TimelineNode

OF_ANOTHER = "the scene has another thing do it"
GOES_NO_FURTHER = "the scene ends its motion with what is told before"
NOT_COUNTED = "nothing in the scene counts it"
HITS_NOTHING = "nothing in the scene is hit so"
NO_RACE = "nothing in the scene tells who is there first"
SOME_OF_THEM = "it is told of some of them only in the scene"
ANOTHER_WAY = "nothing in the scene leads it there"

_TOLD_OF = frozenset(
    {"rolls", "slides", "moves", "airborne", "spins", "tumbles", "slower_than", "faster_than"}
    | {"behind", "in_front_of", "left_of", "right_of", "above", "below", "under"}
    | {"ends_on", "ends_in", "ends_near"}
)
"""Predicates that are told of who does the verb that they stand with."""
_LEADS = frozenset({"moves", "ends_near", "ends_on", "ends_in", "under", "behind", "in_front_of"})
"""Predicates that say where a motion goes."""
_ENDS = frozenset({"Collision", "Fall", "EnterRegion", "Topple", "Stop", "Miss", "Bounce"})
_MOTIONS = frozenset({"motion", "swings"})
_WAYS = frozenset({"motion", "launch", "jump"})
"""What the record calls a verb that became a motion."""
_AFTER = frozenset({"main", "conj", "clause", "relative"})
_DOES = frozenset({"do", "does", "did"})
_WHICH = re.compile(r"\b(?:which|who|that)\b[^.;]*$", re.IGNORECASE)
_OFTEN = re.compile(
    r"\b(?:once|twice|thrice|(?:two|three|four|five|six|seven|eight|nine|ten|\d+) times)\b"
    r"(?! as\b)",
    re.IGNORECASE,
)
_TWO = re.compile(r"\bboth(?: of them)?$|\bboth(?: of them)?(?=[.,;])", re.IGNORECASE)
_REBOUNDS = lex.word_set("rebounds (audit)")
_RACES = lex.word_set("races (audit)")
_NOT_MEANT = frozenset({"what is hit was not understood"})
_PLACES = lex.word_set("places of things (audit)") | lex.word_set("ways of things (audit)")


def _of_another(case: Case) -> Iterator[Finding]:
    """ "Waits for a lorry to cross from left to right": it is not the car that crosses."""
    for s in case.facts.kept:
        p = _with(case, s) if s.predicate.value in _TOLD_OF and s.object else None
        if p is None or not p.subjects or any(case.facts.verb(a.start) for a in p.subjects):
            continue  # the parse takes a verb for a noun
        those = frozenset(
            n for q in case.facts.kept if (q.start, q.end) == (s.start, s.end) for n in q.object
        )
        args = [a for a in (*p.subjects, *p.objects, *p.agents)]
        named = [case.facts.named(a) for a in args]
        if not all(named) or _concern(case, named, those) or _nearest(case, p.start) in those:
            continue
        if any(kind_of(case, n) == kind_of(case, o) for n in named for o in those):
            continue  # members of a group, which are taken for one another
        if not case.facts.owns_up(s.start, s.end):
            yield Finding(s.start, s.end, OF_ANOTHER, tuple(sorted({*named} | those)))


def _with(case: Case, s: Statement) -> Proposition | None:
    """The proposition whose verb, preposition or adverb a statement has."""
    for p in case.said:
        if p.passive or case.facts.verb(p.start) is None:
            continue
        places = [p.start, *(at for _, at, _ in p.obliques), *(at for _, at, _ in p.small)]
        if any(s.start <= at < s.end for at in places):
            return p
    return None


def _concern(case: Case, named: list[str], those: frozenset[str]) -> bool:
    """Whether some of them are the same, or carry each other."""
    about = frozenset(m for n in named for m in members(case, n))
    return bool(those & (about | under(case, about)) or under(case, those) & about)


def _nearest(case: Case, start: int) -> str:
    """What is named last before a place."""
    return max(((b, n) for _, b, n in case.facts.spans if b <= start), default=(0, ""))[1]


def _goes_on(case: Case) -> Iterator[Finding]:
    """ "Drops into a bowl and runs round the inside": nothing moves it once it is in there."""
    for p in case.said:
        item = case.facts.verb(p.start)
        if item is None or item.note not in _MOTIONS or item.status != "used":
            continue
        if p.negated or p.unreal or p.passive or p.objects or p.how not in _AFTER:
            continue
        if p.word in _DOES:
            continue
        name = case.facts.named(p.subjects[0]) if p.subjects else ""
        if not name or case.facts.verb(p.subjects[0].start) or not _after_which(case, p):
            continue
        if _told_of_others(case, name, item):
            continue
        last = _last(case, name, item)
        if last is None or case.facts.owns_up(item.start, item.end):
            continue
        if not _leads_on(case, name, item) and not _moves_after(case, name, last):
            yield Finding(item.start, item.end, GOES_NO_FURTHER, (name,))


def _told_of_others(case: Case, name: str, item: CoverageItem) -> bool:
    """Whether the drafter has another subject for the verb: by a statement, or right before it."""
    told = [s for s in case.facts.kept if item.start <= s.start < item.end]
    before = max(((b, n) for _, b, n in case.facts.spans if b <= item.start), default=(0, name))
    beside = before[1] != name and not case.text[before[0] : item.start].strip()
    return beside or (bool(told) and not any(name in s.object for s in told))


def _after_which(case: Case, p: Proposition) -> bool:
    """Whether the verb goes on with the tale, and does not tell which thing is meant."""
    return p.how != "relative" or bool(_WHICH.search(case.text, p.subjects[0].end, p.start))


def _last(case: Case, name: str, item: CoverageItem) -> TimelineNode | None:
    """The event of a thing that was told last before a verb, if it may end a motion."""
    events = {n.id: n for n in case.facts.events}
    told = [events[v.note] for v in case.facts.verbs if v.end <= item.start and v.note in events]
    mine = [n for n in told if name in n.participants]
    last = mine[-1] if mine else None
    return last if last and last.event.value in _ENDS and last.participants[0] == name else None


def _leads_on(case: Case, name: str, item: CoverageItem) -> bool:
    """Whether a statement says where the thing goes, before the next verb."""
    after = [v.start for v in case.facts.verbs if v.start > item.start]
    end = min(after, default=len(case.text))
    me = {name} | under(case, frozenset({name}))
    return any(
        s.predicate.value in _LEADS and item.start <= s.start < end and me & {*s.object}
        for s in case.facts.kept
    )


def _moves_after(case: Case, name: str, last: TimelineNode) -> bool:
    """Whether a segment or an event follows that moves the thing, or what carries it."""
    me = {name} | under(case, frozenset({name}))
    order = {n.id: k for k, n in enumerate(case.facts.events)}
    since = order[last.id]
    if any(order.get(e.from_, -1) >= since and {e.actor, e.target} & me for e in case.facts.edges):
        return True
    told = {v.note for v in case.facts.verbs}
    later = [n for n in case.facts.events if order[n.id] > since and name in n.participants]
    return any(n.event.value in _ENDS and n.id not in told for n in later)


def _how_often(case: Case) -> Iterator[Finding]:
    """ "Hits the rim, bounces up once and drops through the hoop": and if it bounces twice?"""
    for m in _OFTEN.finditer(case.text):
        before = [v for v in case.facts.verbs if v.end <= m.start()]
        if not before or len(case.text[before[-1].end : m.start()].split()) > 3:
            continue
        verb = lex.singular(case.text[before[-1].start : before[-1].end].lower())[0]
        counted = any(f.kind == "Bounce" for f in case.facts.facts)
        if verb in _REBOUNDS and not counted and not case.facts.owns_up(*m.span()):
            yield Finding(*m.span(), NOT_COUNTED)


def _hits_nothing(case: Case) -> Iterator[Finding]:
    """ "Scrapes a pile", which became nothing."""
    for v in case.facts.verbs:
        if v.status == "ignored" and v.note in _NOT_MEANT and not accounted(case, v.start, v.end):
            yield Finding(v.start, v.end, HITS_NOTHING)


def _first(case: Case) -> Iterator[Finding]:
    """ "The ball reaches the bottom first": is there a race, and does another thing move?"""
    moving = frozenset(n for f in case.facts.facts if f.kind in ("motion", "pushed") for n in f.who)
    for p in case.said:
        for word, start, end in p.small if p.word in _RACES and not p.negated else ():
            who = frozenset(n for a in p.subjects if (n := case.facts.named(a)))
            reached = any(f.kind == "Reach" and f.who & who for f in case.facts.facts)
            reached = reached and bool(moving - who)
            wins = (word in lex.ORDINALS or word == "last") and start > p.start
            if wins and not reached and not case.facts.owns_up(start, end):
                yield Finding(start, end, NO_RACE, tuple(sorted(who)))


def _toward_fewer(case: Case) -> Iterator[Finding]:
    """ "Leans against both", "falls across two chairs": toward each of them."""
    for s in case.facts.kept:
        alike = [t for t in case.facts.kept if (t.start, t.end) == (s.start, s.end)]
        toward = frozenset(n for t in alike for n in t.target)
        m = _TWO.search(case.text, s.start, s.end) if len(toward) == 1 else None
        said = [m.span()] if m else []
        for n in case.nouns if toward else ():
            arg = n.arg(case.text)
            name = case.facts.named(arg) if s.start <= n.start < s.end and number(arg) else ""
            those = members(case, name) if name in toward else frozenset[str]()
            if len(those & toward) < min(number(arg), len(those)):
                said.append((n.start, n.end))
        for at in said:
            if not case.facts.owns_up(*at):
                yield Finding(*at, SOME_OF_THEM, tuple(sorted(toward)))


def _another_way(case: Case) -> Iterator[Finding]:
    """ "Goes around two shelves", "runs over the hole": does anything lead it there?"""
    for p in case.said:
        item = case.facts.verb(p.start)
        if item is None or item.note not in _WAYS or p.how not in ("main", "conj"):
            continue
        named = [case.facts.named(a) for a in (*p.subjects, *p.objects, *p.agents)]
        if p.negated or p.unreal or not named or not all(named):
            continue
        for prep, at, a in p.obliques:
            place = next((n for x in (a, *a.of) if (n := case.facts.named(x))), "")
            told = prep in _PLACES and place and not accounted(case, at, a.end)
            if told and _unrelated(case, named, place, a):
                yield Finding(at, a.end, ANOTHER_WAY, tuple(sorted({*named, place})))


def _unrelated(case: Case, named: list[str], place: str, a: Arg) -> bool:
    """Whether no fact is about things and a place, with what carries and lies on them."""
    if a.end <= a.start or case.facts.doc.spatial_relation_graph.nodes[place].is_structural:
        return False
    holds = [f for f in case.facts.facts if f.kind in ("SUPPORT_SURFACE", "STORAGE")]

    def with_all(nodes: Iterable[str]) -> frozenset[str]:
        told = frozenset(m for n in nodes for m in members(case, n))
        return told | under(case, told) | {n for f in holds if f.whom & told for n in f.who}

    those, there = with_all(named), with_all([place])
    return not those & there and not any(f.all & those and f.all & there for f in case.facts.facts)


CHECKS: dict[str, Callable[[Case], Iterable[Finding]]] = {
    "of another": _of_another,
    "goes on": _goes_on,
    "how often": _how_often,
    "hits nothing": _hits_nothing,
    "first": _first,
    "toward fewer": _toward_fewer,
    "another way": _another_way,
}
"""The questions by name; docs/drafting/audit.md has a row for each."""
