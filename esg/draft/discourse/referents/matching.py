"""Whether a noun phrase can mean an object that is already there."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import PLACES, Entity
from esg.draft.discourse.referents.ranks import told_apart
from esg.draft.discourse.referents.record import World
from esg.draft.text.elements import Mention
from esg.lexicon.garments import read

CONTRASTS = tuple(
    frozenset(words.split())
    for words in (
        "heavy light lighter heavier",
        "big large huge small little tiny smaller larger bigger",
        "tall short long taller shorter longer",
        "thick thin",
        "wide narrow",
        "full empty loaded half-empty",
        "old new",
        "fast slow faster slower",
        "wooden metal steel iron plastic rubber glass stone paper",
        "striped solid plain spotted",
        "round square flat",
        "ego lead leading preceding oncoming following trailing",
        "moving parked stationary standing resting stopped",
    )
)
"""Adjectives of which a thing has one, so that another one tells of another thing."""
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
    "robot": frozenset({"robot"}),
    "aircraft": frozenset({"flyer"}),
    "machine": frozenset({"robot", "appliance", "excavator", "bulldozer", "forklift", "tractor"})
    | frozenset({"crane", "bus", "truck"}),
    "boat": frozenset({"watercraft"}),
    "ship": frozenset({"watercraft"}),
    "vessel": frozenset({"watercraft"}),
}
"""Kinds, or names of nouns, of what a wider noun can name."""
_NEW_IF_BARE = frozenset({"robot", "aircraft", "machine", "boat", "ship", "vessel"})
"""Wider nouns that name something else unless they are definite ("a yacht passes a boat")."""
_NUMBER = "one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen"
_NUMBERS = {*_NUMBER.split(), *map(str, range(1, 16))}
_HUES = lex.word_set("hues")
_DISTINCT = lex.word_set("distinct")
_ANYTHING = lex.word_set("anything (matching)")
_THE = ("the", "this", "that")
ONLY_ONE = lex.word_set("only one")
"""Words before a noun that name one thing of a scene."""


def matches(world: World, m: Mention, e: Entity) -> bool:
    """Whether a thing agrees with all that a phrase says of it."""
    if m.letters:
        return e.letter in m.letters and (m.head == "@" or same_kind(m, e))
    if not same_kind(m, e) or told_apart(m, e, world.facts) or _dressed_otherwise(m, e):
        return False
    return not any(unlike(e, a) for a in m.adjectives)


def _dressed_otherwise(m: Mention, e: Entity) -> bool:
    """ "The man in the red shirt" is not the one in the blue shirt."""
    told = [read(put.phrase, lex.COLORS) for put in m.wears if e.wears]
    known = [read(phrase, lex.COLORS) for phrase in e.wears if told]
    return any(
        a.garment.place == b.garment.place and bool(a.color and b.color) and a.color != b.color
        for a in told
        for b in known
        if a is not None and b is not None
    )


def unlike(e: Entity, a: str) -> bool:
    """Whether an adjective tells of another thing: another colour, size, material or place."""
    if a in lex.COLORS:
        told = e.color is not None or e.group is None or bool(e.letter)
        return told and e.color != lex.COLORS[a]
    if a in _HUES and e.color is not None:
        return e.color != a
    if a in lex.ORDINALS:
        return e.place != a
    if a in ONLY_ONE:
        return a not in e.adjectives
    if (a in PLACES or a == "side") and e.place in PLACES.values():
        return e.place != PLACES.get(a, a)
    return any(a in c and a not in e.adjectives and c & {*e.adjectives} for c in CONTRASTS)


def same_kind(m: Mention, e: Entity) -> bool:
    """Whether a thing goes by a noun: its own, a synonym, a wider or a shorter one."""
    if m.head in _ANYTHING:
        return "structural" not in e.noun.traits
    definite = m.determiner in _THE
    wider = HYPERNYMS.get(m.head, ()) if definite or m.head not in _NEW_IF_BARE else ()
    if {e.noun.kind, e.noun.name} & {*wider} or m.head == e.head:
        return True
    if m.noun is None and not m.determiner and m.head in e.adjectives:
        return True  # "the ego vehicle ... ego stops"
    if m.noun is None and definite and e.known and m.head == e.noun.name.split()[-1]:
        return True  # "a conveyor ... off the belt"
    if m.noun is not None and e.known:
        if m.noun.name == e.noun.name:
            numbered = {*(f"{m.head} {e.head}").replace("-", " ").split()} & _NUMBERS
            if numbered or m.noun.kind in _DISTINCT:
                shorter = definite and e.head.endswith(m.head)  # "a watermelon ... the melon"
                return (m.head == m.noun.name or shorter) and not numbered
            return True
        if m.head in (e.noun.name.split()[-1], e.head.split()[-1]):
            return True  # "a tennis ball ... the ball"
    return definite and len(m.head) >= 4 and e.head.endswith(m.head) and " " not in e.head
