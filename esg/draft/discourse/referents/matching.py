"""Whether a noun phrase can mean an object that is already there."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import FRONT, REAR, Entity
from esg.draft.discourse.referents.ranks import told_apart
from esg.draft.discourse.referents.record import World
from esg.draft.text.elements import Mention

_COMPARED = (
    frozenset({"lighter", "heavier"}),
    frozenset({"smaller", "larger"}),
    frozenset({"smaller", "bigger"}),
    frozenset({"slower", "faster"}),
    frozenset({"shorter", "taller"}),
    frozenset({"shorter", "longer"}),
)
"""Comparatives that tell two objects of one kind apart."""
HYPERNYMS: dict[str, frozenset[str]] = {
    "vehicle": frozenset({"vehicle", "cart", "robot", "toyvehicle"}),
    "animal": frozenset({"animal"}),
    "toy": frozenset({"toy", "toyvehicle", "block", "game"}),
    "container": frozenset({"container", "box", "barrel", "bottle"}),
    "furniture": frozenset({"furniture", "table", "seat"}),
    "fruit": frozenset({"food"}),
    "projectile": frozenset({"ball", "rock", "projectile"}),
    "person": frozenset({"person"}),
    "child": frozenset({"person"}),
}
"""Kinds of what a wider noun can name."""
_NUMBERS = frozenset(
    {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"}
    | {"eleven", "twelve", "thirteen", "fourteen", "fifteen"}
    | {str(k) for k in range(1, 16)}
)
_DISTINCT = lex.word_set("distinct")
_ENDS = frozenset({"front", "rear"})
_IN_A_LINE = lex.word_set("in a line")
_ANYTHING = lex.word_set("anything (matching)")


def matches(world: World, m: Mention, e: Entity) -> bool:
    if m.letters:
        return e.letter in m.letters and (m.head == "@" or same_kind(m, e))
    if not same_kind(m, e) or told_apart(m, e, world.facts):
        return False
    for a in m.adjectives:
        if a in lex.COLORS and e.color is not None and lex.COLORS[a] != e.color:
            return False
        if a in lex.COLORS and e.color is None and (e.group is None or e.letter):
            return False
        if a in lex.MATERIALS and a not in e.adjectives and a not in e.head.split():
            return False
        if a in lex.SIZES and any(
            b in lex.SIZES and lex.SIZES[b] != lex.SIZES[a] for b in e.adjectives
        ):
            return False
        if a in lex.WEIGHTS and any(
            b in lex.WEIGHTS and lex.WEIGHTS[b] != lex.WEIGHTS[a] for b in e.adjectives
        ):
            return False
        if any(a in pair and b in pair and a != b for b in e.adjectives for pair in _COMPARED):
            return False
        if a in FRONT and e.place == "rear":
            return False
        if a in REAR and e.place == "front":
            return False
        if a in lex.ORDINALS and (e.place != a):
            return False
        if a in _IN_A_LINE and e.place in _ENDS and e.place != a and not e.group:
            return False
        if (
            a in ("left", "right", "leftmost", "rightmost")
            and e.place
            and not a.startswith(e.place)
        ):
            return False
    return True


def same_kind(m: Mention, e: Entity) -> bool:
    if m.head in _ANYTHING:
        return "structural" not in e.noun.traits
    if m.head == "water" and e.noun.kind == "water":
        return m.determiner == "the"  # "a lake ... the water"
    if m.head in HYPERNYMS and e.noun.kind in HYPERNYMS[m.head]:
        return True
    if m.noun is not None and e.known:
        if m.noun.name == e.noun.name:
            if m.head == e.head:
                return True
            numbered = {
                *m.head.replace("-", " ").split(),
                *e.head.replace("-", " ").split(),
            } & _NUMBERS
            if numbered or m.noun.kind in _DISTINCT:
                return m.head == m.noun.name and not numbered
            return True
        words, own = m.head.split(), e.noun.name.split() + e.head.split()
        if (
            len(words) == 1
            and words[0] in own
            and (e.noun.name.split()[-1] == words[0] or e.head.split()[-1] == words[0])
        ):
            return True
        if len(m.head) >= 3 and e.head.endswith(m.head) and " " not in e.head:
            return m.determiner in ("the", "this", "that")  # "a signpost ... the post"
        return bool(
            m.head == "ball" and "round" in e.noun.traits and e.noun.kind in ("ball", "billiard")
        )
    part = len(m.head) >= 4 and e.head.endswith(m.head) and " " not in e.head
    return m.head == e.head or (part and m.determiner in ("the", "this", "that"))
