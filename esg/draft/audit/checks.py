"""What a text says by its parse and a document does not: one plain function a question.

Each is asked of the propositions and of the facts, and says nothing where the parse and the
drafter disagree about which word is the verb (docs/drafting/audit.md has what each was measured to
catch and to demote).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
import csv
from dataclasses import dataclass
from functools import cache
import re

from esg.draft import lexicon as lex
from esg.draft.audit import courses, things
from esg.draft.audit.case import (
    Case,
    Finding,
    accounted,
    group,
    happens,
    number,
    senses,
    under,
)
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

NOT_ALL = "only some of them do in the scene"
ONE_OF_EACH = "only one of them is in the scene"
ONE_WAY = "only one way of it is in the scene"
IN_PART = "nothing in the scene keeps some of them apart"
SAME = "it is drawn twice: what was named before is meant"
LOOSE = "nothing is tied: it stands on it"
STAYS = "who does it does not go along"
NO_SUCH = "nothing of the kind happens to it in the scene"
NOTHING = "nothing in the scene stands for it"

_ACTS = lex.word_set("acts of each (audit)")
_DONE_TO = frozenset({"launch", "drop", "knock", "topple", "hit"})
"""Senses whose objects each take part."""
_CHAINS = frozenset({"row", "pins", "rack", "stack"})
"""Patterns of which one member passes it on to the next."""
_NO_CHAINS = frozenset({"pins", "rack", "stack"})
"""Those that do not do so surely: one pin that falls is no strike."""
_OPPOSITES = (
    frozenset({"up", "down"}),
    frozenset({"back", "forth"}),
    frozenset({"in", "out"}),
    frozenset({"to", "fro"}),
    frozenset({"left", "right"}),
)
_OSCILLATES = frozenset({"Swing", "Bounce", "joint"})
_STATES = frozenset({"be", "weigh", "have", "measure", "posture"})
_WHERE = frozenset({"along", "across", "through", "up", "down", "around", "past"})
_ROPES = lex.word_set("ropes (audit)")
_PUSHES = lex.word_set("pushes along (audit)")
_BORNE = frozenset({"SUPPORT_SURFACE", "Placed", "supported_by", "ends_on"})
_IN_PART = re.compile(
    rf"\b(?:{'|'.join(sorted(lex.word_set('in part (audit)'), key=len, reverse=True))})\b",
    re.IGNORECASE,
)
_LOST = re.compile(
    rf"\b(?:{'|'.join(sorted(lex.word_set('lost phrases (audit)'), key=len, reverse=True))})\b",
    re.IGNORECASE,
)
_GIVES_WAY = "gives way"
"""What became of a verb by which a rope or a trailer is loosened."""
_ALL_OF = re.compile(r"\b(?:all|both)\s+(?:of\s+)?(?:the\s+|these\s+|those\s+)?$", re.IGNORECASE)
_DOWN = frozenset({"Topple", "Fall"})
_LETS_GO = re.compile(r"\blet(?:s|ting)? $", re.IGNORECASE)
_NAMED = re.compile(r"(?P<which>an?|the)\s+(?P<noun>\w[\w -]*)", re.IGNORECASE)


def audit(case: Case) -> list[Finding]:
    """Everything that is found, in the order of the text."""
    found = {f: None for check in CHECKS.values() for f in check(case)}
    return sorted(found, key=lambda f: (f.start, f.end))


def _members(case: Case) -> Iterator[Finding]:
    """ "A car is pushed by two men", "hits two other stones": each of them takes part."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    for p in case.told:
        meant = senses(p)
        if not meant & _ACTS or any(small in _WHERE for small, _, _ in p.small):
            continue
        acting = p.agents if p.passive else p.subjects
        done_to = (p.subjects if p.passive else p.objects) if meant & _DONE_TO else []
        for a in (*acting, *done_to):
            those, told = group(case, a), number(a)
            if len(those) < 2 or told < 2 or case.facts.owns_up(a.start, a.end):
                continue
            if {nodes[n].group_pattern for n in those} & _CHAINS:
                continue
            act = [n for n in those if happens(case, n)]
            shown = bool(act) or a in done_to
            if shown and len(act) < min(told, len(those)):
                yield Finding(p.start, p.end, NOT_ALL, tuple(sorted(those - {*act})))


def _each(case: Case) -> Iterator[Finding]:
    """ "Tosses a newspaper onto each porch"."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    for p in case.told:
        for a in p.args() if not senses(p) & _STATES else ():
            name, words = case.facts.named(a), {*a.left} & {"each", "every"}
            if words and name and nodes[name].group is None:
                start = case.text.lower().rfind(words.pop(), 0, a.start)
                if not case.facts.owns_up(start, a.end):
                    yield Finding(start, a.end, ONE_OF_EACH, (name,))


def _to_and_fro(case: Case) -> Iterator[Finding]:
    """ "Two boys on a seesaw go up and down"."""
    for p in case.told:
        small = {word: (start, end) for word, start, end in p.small}
        about = frozenset(n for a in (*p.subjects, *p.objects) for n in group(case, a))
        kinds = {f.kind for f in case.facts.about(about)}
        if any(pair <= small.keys() for pair in _OPPOSITES) and not kinds & _OSCILLATES:
            start, end = min(s for s, _ in small.values()), max(e for _, e in small.values())
            if not case.facts.owns_up(start, end):
                yield Finding(start, end, ONE_WAY, tuple(sorted(about)))


def _in_part(case: Case) -> Iterator[Finding]:
    """ "All but one roll under the sofa"."""
    for m in _IN_PART.finditer(case.text):
        if not case.facts.owns_up(*m.span()):
            yield Finding(*m.span(), IN_PART)


def _vanishing(case: Case) -> Iterator[Finding]:
    """ "He lets go, and it rolls back", "stops, waits a while and leaves"."""
    for m in _LOST.finditer(case.text):
        shown = case.text[m.end() :].startswith(" of ") and any(
            m.start() <= v.start < m.end() and v.status == "used" for v in case.facts.verbs
        )  # "lets go of a crate", which falls
        at = case.facts.verb(m.start())
        shown = shown or (at is not None and _GIVES_WAY in (at.pointer, at.note))  # "comes loose"
        if not shown and not accounted(case, *m.span()):
            yield Finding(*m.span(), NOTHING)


def _all_of(case: Case) -> Iterator[Finding]:
    """ "Knocks over all ten pins", "the head pin, and all the pins": what one does, each does."""
    doc = case.facts.doc
    kinds = {
        n: doc.asset_requirement[x.asset_id].asset_category
        for n, x in doc.spatial_relation_graph.nodes.items()
    }
    grouped = {
        kinds[n]
        for n, x in doc.spatial_relation_graph.nodes.items()
        if x.group_pattern in _NO_CHAINS
    }
    for start, end, name in case.facts.spans:
        before = _ALL_OF.search(case.text, 0, start)
        all_of = before or {"all", "both"} & {*case.text[start:end].lower().split()[:1]}
        if not all_of or kinds[name] not in grouped:
            continue
        members = {n for n, kind in kinds.items() if kind == kinds[name]}
        down = {n for n in members for f in case.facts.facts if f.kind in _DOWN and n in f.who}
        start = before.start() if before else start
        if down and down != members and not case.facts.owns_up(start, end):
            yield Finding(start, end, NOT_ALL, tuple(sorted(members - down)))


def _twice(case: Case) -> Iterator[Finding]:
    """ "A board with a pencil on it until the pencil slides off": one pencil."""
    first: dict[str, list[str]] = {}
    for start, end, node in sorted(case.facts.spans):
        m = _NAMED.fullmatch(case.text, start, end)
        if m is None or case.facts.owns_up(start, end):
            continue
        words = m["noun"].lower()
        if m["which"].lower() != "the":
            for name in {words, words.split()[-1]}:
                first.setdefault(name, []).append(node)
        elif len(before := first.get(words, [])) == 1 and before[0] != node:
            yield Finding(start, end, SAME, (node, before[0]))


def _on_a_rope(case: Case) -> Iterator[Finding]:
    """ "A dog on a leash": it does not stand on it."""
    doc = case.facts.doc
    for f in case.facts.facts:
        for host in f.whom if f.kind in _BORNE else ():
            asset = doc.asset_requirement[doc.spatial_relation_graph.nodes[host].asset_id]
            at = next(((a, b) for a, b, n in case.facts.spans if n == host), None)
            if asset.asset_category in _ROPES and at and not case.facts.owns_up(*at):
                yield Finding(*at, LOOSE, tuple(sorted(f.who)))


def _goes_along(case: Case) -> Iterator[Finding]:
    """ "Is pushed along a pier by a nurse": the nurse goes there, too."""
    for p in case.told:
        ways = any(prep in _WHERE for prep, _, _ in p.obliques)
        if not ways or not {r.lemma for r in verb_readings(p.word)} & _PUSHES:
            continue
        for a in p.agents if p.passive else p.subjects if p.objects else ():
            who = group(case, a)
            moving = any(f.kind == "motion" and f.who & who for f in case.facts.facts)
            if who and not moving:
                yield Finding(p.start, p.end, STAYS, tuple(sorted(who)))


@dataclass(frozen=True)
class _Shown:
    """Facts that show a small word of a motion, and the words it has to stand with."""

    kinds: frozenset[str]
    directions: frozenset[str]


_PARTICLES = {
    "down": _Shown(
        frozenset({"Fall", "Topple", "Placed", "Bounce", "EnterRegion", "ends_on", "ends_in"}),
        frozenset({"down", "along"}),
    ),
    "up": _Shown(frozenset({"PickedUp", "Jump", "Open"}), frozenset({"up", "along"})),
    "out": _Shown(
        frozenset({"Fall", "Topple", "EnterRegion", "Miss"}), frozenset({"away_from", "through"})
    ),
    "in": _Shown(frozenset({"EnterRegion", "ends_in", "Close"}), frozenset({"through"})),
}
_GOING = lex.word_set("goes somewhere (audit)")


def _particles(case: Case) -> Iterator[Finding]:
    """ "Hits the boards and comes back out": of what?"""
    for p in case.told:
        if not senses(p) & _GOING or p.obliques:
            continue
        about = frozenset(n for a in (*p.subjects, *p.objects) for n in group(case, a))
        for word, start, end in p.small:
            shown = _PARTICLES.get(word)
            if shown is None or not about or accounted(case, start, end):
                continue
            facts = case.facts.about(about)
            if any(f.kind == "joint" for f in facts):
                continue  # what is hinged or hangs has a way of its own
            if not any(f.kind in shown.kinds or f.way in shown.directions for f in facts):
                yield Finding(start, end, NOTHING, tuple(sorted(about)))


@dataclass(frozen=True)
class _Needs:
    kinds: frozenset[str]
    of: str


@cache
def _needs() -> dict[str, _Needs]:
    """What shows a verb, by its sense; of whom."""
    with open(lex.DATA / "audit_acts.csv", encoding="utf-8", newline="") as file:
        return {
            r["sense"]: _Needs(frozenset(r["facts"].split("|")), r["of"])
            for r in csv.DictReader(file, delimiter=";")
        }


def _acts(case: Case) -> Iterator[Finding]:
    """ "Toppling the last one onto a bell": does it topple?"""
    for p in case.told:
        meant = senses(p)
        need = _needs().get(next(iter(meant))) if len(meant) == 1 else None
        preps = any(word in lex.PREPOSITIONS for word, _, _ in p.small)
        if need is None or (preps and p.objects) or _LETS_GO.search(case.text, 0, p.start):
            continue
        if p.how == "relative" and p.start in case.facts.read:
            continue  # "pushes a bucket off a bench, which falls": the parse says the bench
        who = p.subjects if p.passive else p.objects
        for a in who if need.of == "object" else p.subjects if not p.objects else ():
            about = group(case, a) if not case.facts.owns_up(a.start, a.end) else frozenset[str]()
            facts = case.facts.about(about | under(case, about))
            if _right_before(case, p.start) - about and need.of != "object":
                continue  # "watches as his ball rolls": the parse says who watches
            if about and not any(f.kind in need.kinds for f in facts):
                yield Finding(p.start, p.end, NO_SUCH, tuple(sorted(about)))


def _right_before(case: Case, start: int) -> set[str]:
    """The thing whose name ends where a word starts."""
    return {n for _, end, n in case.facts.spans if 0 <= start - end <= 1}


@dataclass(frozen=True)
class Doubt:
    """A noun of several senses: drawn as what, beside which words it is what else."""

    drawn: str
    cues: frozenset[str]
    meant: str
    example: str


@cache
def doubts() -> dict[tuple[str, str], Doubt]:
    """Nouns of several senses, by what they are drawn as: what beside them tells another one."""
    with open(lex.DATA / "doubts.csv", encoding="utf-8", newline="") as file:
        return {
            (r["noun"], r["drawn"]): Doubt(
                r["drawn"], frozenset(r["beside"].split("|")), r["meant"], r["example"]
            )
            for r in csv.DictReader(file, delimiter=";")
        }


def _doubtful(case: Case) -> Iterator[Finding]:
    """ "A sheepdog herds ten sheep into a pen", which is none to write with."""
    doc = case.facts.doc
    words = {w: None for w in re.findall(r"[a-z]+", case.text.lower())}
    singulars = {lex.singular(w)[0] for w in words} | {*words}
    for start, end, name in case.facts.spans:
        named = re.findall(r"[a-z]+", case.text[start:end].lower()) or [""]
        head = named[-2] if len(named) > 1 and parse_number(named[-1]) else named[-1]
        asset = doc.asset_requirement[doc.spatial_relation_graph.nodes[name].asset_id]
        doubt = doubts().get((lex.singular(head)[0], asset.asset_category))
        if doubt is None:
            continue
        said = any(start <= a < end for a, _ in case.facts.said)  # of the noun, not of its place
        if singulars & doubt.cues and not said:
            article = "an" if doubt.drawn[0] in "aeiou" else "a"
            drawn = f"{article} {doubt.drawn.replace('_', ' ')}"
            missing = f"{drawn} is drawn, and {doubt.meant} is meant"
            yield Finding(start, end, missing, (name,))


CHECKS: dict[str, Callable[[Case], Iterable[Finding]]] = {
    "members": _members,
    "each": _each,
    "to and fro": _to_and_fro,
    "in part": _in_part,
    "vanishing": _vanishing,
    "all of": _all_of,
    "twice": _twice,
    "on a rope": _on_a_rope,
    "goes along": _goes_along,
    "particles": _particles,
    "acts": _acts,
    "doubtful": _doubtful,
    **things.CHECKS,
    **courses.CHECKS,
}
"""The questions by name; docs/drafting/audit.md has a row for each."""
