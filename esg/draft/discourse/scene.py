"""The interpreted scene: what the prompt says, before it is written as a document."""

from __future__ import annotations

from dataclasses import dataclass, field

from esg.draft import lexicon as lex
from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.referents.record import World
from esg.draft.discourse.timeline import TimelineBuilder
from esg.draft.grammar.questions import Question
from esg.draft.text.fillings import Fillings
from esg.draft.text.quantities import Amount
from esg.graph.models import Contents, Joint, Quantity
from esg.lexicon.breakables import Breakable
from esg.lexicon.parts import Part


@dataclass
class Relation:
    """A spatial relation: `source` is <kind> `target`."""

    source: str
    target: str
    kind: str
    distance: Quantity | None = None
    text: str = ""


@dataclass(frozen=True)
class Tow:
    """What something is drawn along by.

    Args:
        by: Node that draws it.
        link: Node of the rope or chain that the prompt names, "" if none.
    """

    by: str
    link: str = ""


@dataclass(frozen=True)
class Untouched:
    """Others that a thing is told not to touch; the words stand between start and end."""

    start: int
    end: int
    who: str
    others: tuple[str, ...]


@dataclass
class Scene:
    """What the prompt says, ready to be written as a document."""

    world: World
    timeline: TimelineBuilder
    text: str = ""
    fillings: Fillings = field(default_factory=lambda: Fillings("", ""))
    """What was taken out of the text: what vessels are filled with."""
    contents: dict[str, Contents] = field(default_factory=dict[str, Contents])
    """The same by vessel."""
    relations: list[Relation] = field(default_factory=list[Relation])
    needs: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    """Implied supports: (kind of need, node id)."""
    supported_by: dict[str, str] = field(default_factory=dict[str, str])
    inside_of: dict[str, str] = field(default_factory=dict[str, str])
    aboard: dict[str, str] = field(default_factory=dict[str, str])
    """Who is told to be in a vehicle or to drive it."""
    shut_in: dict[str, str] = field(default_factory=dict[str, str])
    """What is told to be in something that is hollow only once a door of it is told of."""
    attached: dict[str, str] = field(default_factory=dict[str, str])
    """What hangs on a vertical face: node -> wall."""
    marked: dict[str, str] = field(default_factory=dict[str, str])
    """The road or lane that a node is said to be on."""
    heights: dict[str, Quantity] = field(default_factory=dict[str, Quantity])
    kicked: set[str] = field(default_factory=set[str])
    """What a foot sets in motion: it starts from the ground."""
    facing: dict[str, str] = field(default_factory=dict[str, str])
    travel: dict[str, Amount] = field(default_factory=dict[str, Amount])
    """Stated distance of a motion, by actor."""
    joints: list[Joint] = field(default_factory=list[Joint])
    openings: dict[str, float] = field(default_factory=dict[str, float])
    """Where the joint of a node starts, as events ask for it [deg or cm]."""
    tows: dict[str, Tow] = field(default_factory=dict[str, Tow])
    """What is drawn along, and by what."""
    hung: dict[str, str] = field(default_factory=dict[str, str])
    """What is told to hang, and the rope that the prompt names for it, "" if none."""
    sprung: set[str] = field(default_factory=set[str])
    """What hangs on a spring."""
    at_ends: list[str] = field(default_factory=list[str])
    """What sits on the ends of seesaws, in the order of the text."""
    at_part: dict[str, tuple[str, Part]] = field(default_factory=dict[str, tuple[str, Part]])
    """What starts at an end, an edge or a corner (`esg.lexicon.parts`): of what, at which."""
    loosed: set[str] = field(default_factory=set[str])
    """What hangs on something that gives way."""
    links: set[str] = field(default_factory=set[str])
    """Ropes and chains that joints of the scene stand for."""
    breaking: dict[str, Breakable] = field(default_factory=dict[str, Breakable])
    """What is told to break."""
    compared: list[tuple[int, int]] = field(default_factory=list[tuple[int, int]])
    """Comparisons that set a mass, a size or a speed, by their place in the text."""
    used: dict[tuple[int, int], str] = field(default_factory=dict[tuple[int, int], str])
    """Spans that became something: (start, end) -> pointer or note."""
    ignored: dict[tuple[int, int], str] = field(default_factory=dict[tuple[int, int], str])
    untouched: list[Untouched] = field(default_factory=lambda: list[Untouched]())
    """What is told to be touched by none."""
    asked: list[Question] = field(default_factory=lambda: list[Question]())
    """Questions of the text beside what it tells."""
    warnings: list[str] = field(default_factory=list[str])
    clauses: list[Clause] = field(default_factory=list[Clause])
    """The clauses that were read, with what they move."""


GROUND = "ground_1"
"""Node of what everything stands on."""
STRUCK = lex.word_set("struck")
MAX_TIME_S = 600.0
"""Longest scene [s]."""
LIVING = frozenset({"person", "animal"})
LIMBED = LIVING | {"robot"}
"""Kinds with a body that acts: those who ride, drive, carry, jump and go on foot."""
SELF_POWERED = lex.word_set("self powered")
SPEEDS: dict[str, Quantity] = {
    "vehicle": (300.0, 2000.0), "toyvehicle": (50.0, 300.0), "person": (80.0, 600.0),
    "animal": (80.0, 800.0), "robot": (30.0, 200.0), "cart": (50.0, 400.0),
    "watercraft": (50.0, 500.0), "flyer": (200.0, 1500.0), "roll": (100.0, 1000.0),
    "slide": (100.0, 800.0), "throw": (300.0, 2000.0), "drop": 0.0, "fly": (300.0, 2000.0),
    "billiard": (50.0, 600.0), "projectile": (500.0, 4000.0), "floater": (50.0, 190.0),
    "press": (15.0, 60.0),
}  # fmt: skip

"""Plausible speeds [cm/s] where the prompt gives none; sources in docs/drafting.md."""


def pocket_name(adjectives: list[str]) -> str:
    """Name of the billiard pocket that a phrase means ("bottom pocket", "corner pocket")."""
    words = {w for a in adjectives for w in a.split("-")}
    row = (
        "top"
        if words & {"top", "upper", "far"}
        else "middle"
        if words & {"middle", "side", "center"}
        else "bottom"
    )
    side = "right" if "right" in words else "left"
    return f"{row} {side} pocket"
