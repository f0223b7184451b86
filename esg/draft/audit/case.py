"""Both readings of a text, side by side, and what the questions ask of them alike."""

from __future__ import annotations

from dataclasses import dataclass

from esg.draft.audit.facts import Facts
from esg.draft.audit.parse import Arg, Noun, Proposition
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

MOST = 40
"""Members that are counted; larger numbers measure something."""
HAPPENS = frozenset(
    {"Collision", "EnterRegion", "Stop", "Topple", "HeadingReached", "Fall", "Reach", "Miss"}
    | {"PickedUp", "Placed", "Bounce", "Jump", "Spin", "Open", "Close", "Swing", "Break"}
    | {"motion", "pushed", "moves", "rolls", "slides", "spins", "tumbles", "airborne"}
    | {"carried_by", "stays_still", "touches", "struck_on", "ends_on", "ends_in", "ends_near"}
    | {"slower_than", "faster_than", "stays_upright", "at_rest", "never_touches"}
)
"""Facts of what happens to a thing, and no mere place."""
ALL = frozenset({"all", "both", "each", "every"})


@dataclass(frozen=True)
class Finding:
    """Words that the document does not account for.

    Args:
        start, end: Their place in the text.
        missing: What is missing, for the reader of a report.
        nodes: What they are about.
    """

    start: int
    end: int
    missing: str
    nodes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Case:
    """Both readings of a text.

    Args:
        text: What was read.
        facts: What the document says.
        told: Propositions whose verbs both readings see, and that tell of what happens.
        nouns: The nouns of the parse.
        said: All propositions of the parse.
    """

    text: str
    facts: Facts
    told: tuple[Proposition, ...]
    nouns: tuple[Noun, ...] = ()
    said: tuple[Proposition, ...] = ()


def senses(p: Proposition) -> set[str]:
    """The senses that the lexicon has for its verb."""
    return {r.sense for r in verb_readings(p.word)}


def group(case: Case, arg: Arg) -> frozenset[str]:
    """All members of what a noun phrase names, or is of ("two of the ten pins")."""
    found = case.facts.named(arg) or next((n for o in arg.of if (n := case.facts.named(o))), "")
    if not found or case.facts.doc.spatial_relation_graph.nodes[found].is_structural:
        return frozenset()
    return members(case, found)


def members(case: Case, node: str) -> frozenset[str]:
    """The node and all that are in one group with it."""
    nodes = case.facts.doc.spatial_relation_graph.nodes
    told = nodes[node].group
    return frozenset(n for n, x in nodes.items() if n == node or (told and x.group == told))


def kind_of(case: Case, node: str) -> str:
    """What a node is drawn as."""
    doc = case.facts.doc
    return doc.asset_requirement[doc.spatial_relation_graph.nodes[node].asset_id].asset_category


def number(arg: Arg) -> int:
    """How many a noun phrase says; 0 if it does not."""
    for word in (*arg.left, arg.word):
        if word == "both":
            return 2
        told = parse_number(word)
        if isinstance(told, float | int) and 2 <= told <= MOST and told == int(told):
            return int(told)
    return MOST if ALL & {*arg.left} else 0


def happens(case: Case, node: str) -> bool:
    """Whether the scene has something happen to it."""
    return any(f.kind in HAPPENS for f in case.facts.about(frozenset({node})))


def accounted(case: Case, start: int, end: int) -> bool:
    """Whether a statement has the words, or the draft owns up to them."""
    held = any(a < end and start < b for a, b in case.facts.held)
    return held or case.facts.owns_up(start, end)


def under(case: Case, nodes: frozenset[str]) -> frozenset[str]:
    """What carries them, as who rides goes where that goes, and what is jointed to them."""
    on = [f for f in case.facts.facts if f.kind in ("SUPPORT_SURFACE", "STORAGE")]
    joined = [f for f in case.facts.facts if f.kind == "joint" and f.all & nodes]
    carriers = {n for f in on if f.who & nodes for n in f.whom}
    return frozenset(carriers.union(*(f.all for f in joined)))
