"""Questions about what things are: one or two, part or whole, where they stand, who is meant."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.audit.case import (
    Case,
    Finding,
    accounted,
    group,
    happens,
    kind_of,
    members,
    number,
    under,
)
from esg.draft.audit.parse import Arg, Noun

TWO_NAMES = "what was named before is drawn for it"
ONE_TOO_MANY = "it is drawn beside those that it is one of"
IN_ITS_PART = "it is drawn in what is a part of it"
TWO_PLACES = "it is drawn on what it is to be beside or under"
BESIDE_ITS_WHOLE = "one in a frame of its own is drawn, and no part of the vehicle"
NO_PLACE = "nothing in the scene puts it there"
NO_PART = "it takes part in nothing in the scene"
OTHER_NUMBER = "another number of them does in the scene"
TOO_BIG = "it is drawn on or in what is too small for it"
A_VERB = "a thing is drawn for it, and what happens is meant"
A_PERSON = "somebody is drawn for it, and a thing is meant"

_HOLDS = frozenset({"SUPPORT_SURFACE", "STORAGE"})
_LEAVES = frozenset({"door_leaf", "door"})
_WITH_DOORS = lex.word_set("with doors (audit)")
_DEFINITE = frozenset({"the", "these", "those", "this", "that", "its", "their", "his", "her"})
_SOME = frozenset({"a", "an", "some", "several", "many"})
_LIKE = frozenset({"like", "as", "than", "of", "into"})
_BESIDE = frozenset({"under", "adjacent", "left_of", "right_of", "in_front_of", "behind"})
_FORMS = lex.word_set("forms of many (audit)")
_SIDES = lex.word_set("sides of a thing (audit)")
_PLACES = lex.word_set("places of things (audit)")
_POSTURES = lex.word_set("postures (audit)")
_THEN = re.compile(
    r"(?:[,;]|\band)\s*(?:and\s+)?(?:then|next|finally|lastly|afterwards)\s+"
    r"(?P<what>(?:the|an?|its|his|her)\s[\w -]+?)(?=[.,;]|$)",
    re.IGNORECASE,
)
_BIGGER = 1.3
"""How much wider a thing is than what it stands on, at least, where no word puts it there."""
_SIZED = lex.RANKS.keys() | lex.SIZES.keys() | lex.WEIGHTS.keys()
_ONLY = re.compile(r"\bonly (?:the )?(?P<n>\w+)\b", re.IGNORECASE)


def _two_names(case: Case) -> Iterator[Finding]:
    """ "A candle between two candlesticks", "two cars meet between parked cars": not the same."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    for n in case.nouns:
        found = _span(case, n)
        if found is None or n.prep in _LIKE or n.role in ("attr", "appos", "npadvmod"):
            continue
        start, end, name = found
        bare = n.tag == "NNS" and not number(n.arg(case.text)) and not _DEFINITE & {*n.left}
        said = {*n.left} & _SOME or number(n.arg(case.text))
        head = lex.singular(case.text[n.start : n.end].lower())[0]
        if nodes[name].is_structural or head in _FORMS | _SIDES or end != n.end:
            continue
        if not (said or bare) or case.text[start:end].lower().split()[0] in _DEFINITE:
            continue
        if case.text[n.end : n.end + 4] == " of ":
            continue  # "a wheel of the cart"
        before = [
            case.text[a:b].lower() for a, b, x in case.facts.spans if x == name and b <= start
        ]
        named = [w for w in before if w.split()[0] in _SOME or number(_counted(w))]
        heads = {lex.singular(w.split()[-1])[0] for w in named}
        again = head in heads and not (bare and n.left)  # "one log", "bricks" are of them
        if heads and not again:
            yield Finding(start, end, TWO_NAMES, (name,))


def _counted(words: str) -> Arg:
    *left, word = words.split()
    return Arg(0, 0, word, "", tuple(left))


def _span(case: Case, n: Noun) -> tuple[int, int, str] | None:
    """The phrase that names a noun's node."""
    found = [(b - a, a, b, x) for a, b, x in case.facts.spans if a <= n.start and n.end <= b]
    return min(found)[1:] if found else None


def _one_too_many(case: Case) -> Iterator[Finding]:
    """ "Four tractors; the second is the biggest": it is one of the four."""
    for n in case.nouns:
        told = number(n.arg(case.text)) if n.tag == "NNS" else 0
        name = case.facts.named(n.arg(case.text))
        if not told or not name or {"other", "more", "another"} & {*n.left}:
            continue
        those, kind = members(case, name), kind_of(case, name)
        for start, end, other in case.facts.spans if len(those) >= told else ():
            first = min(a for a, _, x in case.facts.spans if x == other)
            words = case.text[start:end].lower().split()
            if first < n.end or other in those or kind_of(case, other) != kind:
                continue
            if _SIZED & {*n.left} and _SIZED & {*words} - {*n.left}:
                continue  # "the two small cubes hit the large one"
            which = [lex.ORDINALS[w] for w in words if w in lex.ORDINALS]
            if words[0] == "the" and kind != "person" and not (which and which[0] >= told):
                yield Finding(start, end, ONE_TOO_MANY, (other,))
                break


def _in_its_part(case: Case) -> Iterator[Finding]:
    """ "In the bottom drawer of the cabinet": the cabinet is not in its drawer."""
    at = {(n.start, n.end): n for n in case.nouns}
    for n in case.nouns:
        head = at.get(n.governors[-1]) if n.prep == "of" and len(n.governors) > 1 else None
        if head is None or not _DEFINITE & {*n.left}:
            continue
        whole, part = case.facts.named(n.arg(case.text)), case.facts.named(head.arg(case.text))
        held = any(f.kind in _HOLDS and whole in f.who and part in f.whom for f in case.facts.facts)
        if whole and part and held and not case.facts.owns_up(head.start, n.end):
            yield Finding(head.start, n.end, IN_ITS_PART, (whole,))


def _beside_its_whole(case: Case) -> Iterator[Finding]:
    """ "A bus stops and its doors open": doors in frames of their own are drawn, not the bus's."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    wholes = [b for _, b, n in case.facts.spans if _is_vehicle(case, n)]
    for start, end, name in case.facts.spans if any(_is_vehicle(case, n) for n in nodes) else ():
        words = case.text[start:end].lower().split() or [""]
        its = words[0] in ("its", "their") or "'s" in case.text[start:end]
        its = its or case.text[max(0, start - 3) : start].rstrip().endswith("'s")
        theirs = words[0] == "the" and any(b <= start for b in wholes)
        theirs = theirs and not _built(case) and len(words) == 2
        if kind_of(case, name) in _LEAVES and (its or theirs) and not accounted(case, start, end):
            yield Finding(start, end, BESIDE_ITS_WHOLE, (name,))


def _is_vehicle(case: Case, node: str) -> bool:
    noun = lex.nouns().get(kind_of(case, node).replace("_", " "))
    return noun is not None and noun.kind == "vehicle"


def _built(case: Case) -> bool:
    """Whether something else has doors, or a place that has some is named."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    kinds = {kind_of(case, n).replace("_", " ") for n in nodes}
    named = {w for w in re.findall(r"[a-z]+", case.text.lower()) if w in _WITH_DOORS}
    return bool(named) or any((x := lex.nouns().get(k)) and x.kind == "building" for k in kinds)


def _two_places(case: Case) -> Iterator[Finding]:
    """ "A suitcase lies under a table": and not on it."""
    for r in case.facts.doc.spatial_relation_graph.edges.binary_relations:
        on = any(f.kind in _HOLDS and r.from_ in f.who and r.to in f.whom for f in case.facts.facts)
        at = next(((a, b) for a, b, x in case.facts.spans if x == r.from_), None)
        if r.relation_type.value in _BESIDE and on and at and not case.facts.owns_up(*at):
            yield Finding(*at, TWO_PLACES, (r.from_, r.to))


def _no_place(case: Case) -> Iterator[Finding]:
    """ "The pear on the other side", "a woman on a motorcycle": is it there?"""
    at = {(n.start, n.end): n for n in case.nouns}
    for n in case.nouns:
        host, prep, above = n, n.prep, n.governors[-1]
        if prep == "of" and (side := at.get(above)) is not None and _is_side(case, side):
            host, prep, above = side, side.prep, side.governors[-1]
        place = case.facts.named(n.arg(case.text))
        if prep not in _PLACES or not place or len(host.governors) < 2:
            continue
        if re.search(r",|\band\b", case.text[host.governors[0][1] : n.start]):
            continue  # "a television on a cabinet, a guitar and a dog"
        for thing in _who_stands(case, above, at):
            name = case.facts.named(thing)
            start = host.governors[0][0]
            if name and _apart(case, name, place) and not case.facts.owns_up(start, n.end):
                yield Finding(start, n.end, NO_PLACE, (name, place))


def _is_side(case: Case, n: Noun) -> bool:
    return case.text[n.start : n.end].lower() in _SIDES


def _who_stands(
    case: Case, above: tuple[int, int], at: dict[tuple[int, int], Noun]
) -> Iterable[Arg]:
    """The noun that a place is told of, beside it or by a verb of posture."""
    if (n := at.get(above)) is not None:
        return [n.arg(case.text)] if not n.prep or n.prep == "with" else []
    p = next((p for p in case.said if p.start == above[0] and p.word in _POSTURES), None)
    return () if p is None or p.negated or p.unreal or p.objects else p.subjects


def _apart(case: Case, name: str, place: str) -> bool:
    """Whether no fact is about both, with what carries and what lies on them."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    if name == place or nodes[name].is_structural or nodes[place].is_structural:
        return False
    both: list[frozenset[str]] = []
    for node in (name, place):
        told = members(case, node)
        on = {n for f in case.facts.facts if f.kind in _HOLDS and f.whom & told for n in f.who}
        both.append(told | under(case, told) | on)
    return not any(f.all & both[0] and f.all & both[1] for f in case.facts.facts)


def _no_part(case: Case) -> Iterator[Finding]:
    """ "Put the blue cube in the bin, then the red cube": the red one, too."""
    for m in _THEN.finditer(case.text):
        start, end = m.span("what")
        if any(start <= v.start < end for v in case.facts.verbs):
            continue
        for a, b, name in case.facts.spans:
            idle = not any(happens(case, x) for x in members(case, name))
            if a == start and idle and not case.facts.owns_up(a, b):
                yield Finding(a, b, NO_PART, (name,))


def _other_number(case: Case) -> Iterator[Finding]:
    """ "Only six of them fall": do six?"""
    for m in _ONLY.finditer(case.text):
        near = (a for p in case.told for a in (*p.subjects, *p.objects) if a.start >= m.start("n"))
        first = min(near, key=lambda a: a.start, default=None)
        those = group(case, first) if first is not None else frozenset[str]()
        if first is None or not number(first) or first.start > m.end() + 1 or len(those) < 2:
            continue
        act = sum(happens(case, n) for n in those)
        if act != number(first) and not case.facts.owns_up(m.start(), first.end):
            yield Finding(m.start(), first.end, OTHER_NUMBER, tuple(sorted(those)))


def _too_big(case: Case) -> Iterator[Finding]:
    """ "With 30 mph on the clock, the van goes into a lorry": it does not stand on the clock."""
    for f in case.facts.facts:
        for guest, host in ((g, h) for g in f.who for h in f.whom if f.kind in _HOLDS):
            at = next(((a, b) for a, b, x in case.facts.spans if x == guest), None)
            width = sorted(_size(case, guest))[1]
            small = width > _BIGGER * max(_size(case, host)[:2])
            if at and small and not _linked(case, guest, host) and not case.facts.owns_up(*at):
                yield Finding(*at, TOO_BIG, (guest, host))


def _size(case: Case, node: str) -> tuple[float, float, float]:
    """Length, width and height [cm] as drafted."""
    doc = case.facts.doc
    asset = doc.spatial_relation_graph.nodes[node].asset_id
    return doc.asset_requirement[asset].expected_dimensions_cm


def _linked(case: Case, one: str, other: str) -> bool:
    """Whether a verb or a preposition has both: of the parse, or in the words between them."""
    for _, end, x in case.facts.spans:
        for start, _, y in case.facts.spans if x == one else ():
            between = case.text[end:start].split()
            if y == other and 0 < len(between) <= 2 and between[0].lower() in _PLACES:
                return True
    for p in case.said:
        named = {case.facts.named(x) for a in p.args() for x in (a, *a.of)}
        if one in named and other in named:
            return True
    at = {(n.start, n.end): n for n in case.nouns}
    for n in case.nouns:
        above = [at[g] for g in n.governors if g in at]
        named = {case.facts.named(x.arg(case.text)) for x in above}
        own = case.facts.named(n.arg(case.text))
        if (own == one and other in named) or (own == other and one in named):
            return True
    return False


def _a_verb(case: Case) -> Iterator[Finding]:
    """ "The hammer head flies off": no fly is meant."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    verbs = {p.end: p for p in case.said if p.tag == "VBZ"}
    for start, end, name in case.facts.spans:
        p = verbs.get(end)
        if p is None or start > p.start or nodes[name].is_structural or nodes[name].group:
            continue
        if not case.facts.owns_up(start, end):
            yield Finding(start, end, A_VERB, (name,))


def _a_person(case: Case) -> Iterator[Finding]:
    """ "The shot-putter pushes the shot. It flies over the line": not who pushes it."""
    for start, end, name in case.facts.spans:
        it = case.text[start:end].lower() == "it"
        if it and kind_of(case, name) == "person" and not case.facts.owns_up(start, end):
            yield Finding(start, end, A_PERSON, (name,))


CHECKS: dict[str, Callable[[Case], Iterable[Finding]]] = {
    "two names": _two_names,
    "one too many": _one_too_many,
    "in its part": _in_its_part,
    "beside its whole": _beside_its_whole,
    "two places": _two_places,
    "no place": _no_place,
    "no part": _no_part,
    "other number": _other_number,
    "too big": _too_big,
    "a verb": _a_verb,
    "a person": _a_person,
}
"""The questions by name; docs/drafting/audit.md has a row for each."""
