"""Objects of the scene, as the prompt introduces them."""

from __future__ import annotations

from dataclasses import dataclass, field
import re
import unicodedata

from esg.draft import lexicon as lex

FRONT = lex.word_set("front")
REAR = lex.word_set("rear")
PLACES = {
    **{w: {-1: "top", 0: "bottom", 1: "middle"}[k] for w, k in lex.STACKED.items()},
    **dict.fromkeys((*FRONT, "head"), "front"), **dict.fromkeys(REAR, "rear"),
    "left": "left", "leftmost": "left", "right": "right", "rightmost": "right",
    "last": "last", "final": "last",
}  # fmt: skip
"""What an adjective of place calls a member of a row, queue or stack."""
ACTING_PARTS = lex.OWN_PARTS | lex.word_set("acting parts")
"""Parts of a machine with which it hits things ("its brush touches a box")."""
WORN = lex.word_set("worn")
OTHER = lex.word_set("other")
_TOYS = lex.word_set("toys (riding)")
UNKNOWN_MASS_KG = 5.0
_HUES, _ANY_COLOR = lex.word_set("hues"), lex.word_set("any colour")
_GOING = lex.word_set("self powered")
_OF_WHAT_GOES = frozenset({"lead", "silver", "gold", "golden"})
"""Names of metals of which no vehicle and no animal is made: "the lead car", "a golden dog"."""


@dataclass
class Entity:
    """One object of the scene (or one member of a plural).

    Args:
        id: Node id.
        noun: Lexicon entry, a fallback for unknown nouns.
        head: The prompt's own noun.
        label: The prompt's phrase without article.
        group: Name shared by the members of a plural.
    """

    id: str
    noun: lex.Noun
    head: str
    label: str
    adjectives: list[str] = field(default_factory=list[str])
    letter: str = ""
    group: str | None = None
    pattern: str | None = None
    mentioned: bool = True
    known: bool = True
    mass_kg: float | None = None
    mass_prescribed: bool = False
    mass_factor: float = 1.0
    dimensions_cm: list[float] | None = None
    dimensions_prescribed: bool = False
    sides: dict[str, float] = field(default_factory=dict[str, float])
    """Stated sides [cm]."""
    static: bool = False
    """Hung on a wall or below a ceiling, and so fixed until the prompt moves it."""
    freed: bool = False
    """Normally fixed, but the prompt moves it (a fence post that falls over)."""
    part: bool = False
    """A part of a jointed thing (`esg/lexicon/articulations.csv`)."""
    implied: bool = False
    """A part that stands as the one that is named does."""
    lever: str = ""
    """What it is of a makeshift lever: "seesaw" of the plank, "fulcrum" of what that lies on."""
    whole: str = ""
    """The jointed thing of which it is one of several parts, by node id."""
    one: bool = False
    """One of several, as its phrase says ("one block"): "another" is one more of them."""
    given: bool = False
    """First read with "the", as something that is known."""
    place: str = ""
    """front, rear, left, right or an ordinal, once known."""
    wears: list[str] = field(default_factory=list[str])
    """What is said to be worn by it: "red shirt"."""
    lies: str | None = None
    """How it lies or stands at first, a row of the table of poses, where that is told."""
    origin: int = -1
    """Offset of the first mention, for coverage."""

    @property
    def in_group(self) -> bool:
        """Whether it stands in its plural's arrangement; a row keeps members named by place."""
        if self.group is None or self.letter:
            return False
        in_row = self.pattern in ("row", "stack") and self.noun.kind != "vehicle"
        return not self.place or (
            in_row and self.place in {*lex.ORDINALS, *lex.STACKED, "last", "final"}
        )

    @property
    def movable(self) -> bool:
        """Whether it can move in the simulation."""
        traits = self.noun.traits
        return not ({"structural", "decal"} & traits) and (
            self.freed or ("fixed" not in traits and not self.static)
        )

    @property
    def color(self) -> str | None:
        """Its stated colour: "a salmon cube" has one, and a salmon fillet is of a fish."""
        hues = _HUES if self.noun.kind in _ANY_COLOR else frozenset[str]()
        told = (lex.COLORS.get(a, a) for a in self.adjectives if a in lex.COLORS or a in hues)
        return next(told, None)

    @property
    def material(self) -> str | None:
        """The word that says what it is made of, and not that it leads, or its colour."""
        other = _OF_WHAT_GOES if self.noun.kind in _GOING and not is_toy(self) else frozenset[str]()
        return next((a for a in self.adjectives if a in lex.MATERIALS and a not in other), None)


def head_of(e: Entity) -> str:
    """The noun as the table of jointed things has it: tokens part a possessive ("newton 's")."""
    if e.lever:
        return e.lever
    return e.head.lower().replace(" 's", "'s")


def slug(text: str) -> str:
    """A text as part of a name: lower case, ASCII, words joined by underscores."""
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return re.sub(r"[^a-z0-9]+", "_", plain.lower()).strip("_")


def nameless(head: str) -> lex.Noun:
    """A sized stand-in for a noun of which nothing is known: a box."""
    return lex.Noun(
        name=head,
        kind="generic",
        dimensions_cm=(40.0, 40.0, 40.0),
        mass_kg=UNKNOWN_MASS_KG,
        material="plastic",
        shape="box",
        traits=frozenset(),
        description=head,
        stand_in="plain box",
    )


def is_toy(e: Entity) -> bool:
    """Whether nobody sits in it: a toy truck, a model plane; a ride-on car is no toy here."""
    said = {*e.adjectives, *e.label.lower().split()}
    return (e.noun.kind == "toyvehicle" or bool(said & _TOYS)) and "ride-on" not in said
