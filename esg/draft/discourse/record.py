"""The discourse: what has been read of a prompt so far, and the scene that it makes.

Its parts are plain records; everything that reads a clause is a function of a `Discourse`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

from esg.draft.discourse.referents.record import World
from esg.draft.discourse.scene import Scene
from esg.draft.discourse.timeline import TimelineBuilder
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention
from esg.draft.text.quantities import Amount
from esg.graph.models import NodeEvent, Quantity

Time = tuple[Quantity, Amount, str]
"""A stated time, its amount in the prompt, and "at" (absolute) or "after"."""


class AddEvent(Protocol):
    """Adds a point event to the timeline and returns its id."""

    def __call__(
        self,
        kind: NodeEvent,
        participants: tuple[str, ...],
        f: Frame,
        time: Time | None,
        **extra: object,
    ) -> str: ...


class Outcomes(Protocol):
    """Reads what a clause says its motion leads to."""

    def __call__(self, f: Frame, actors: list[str]) -> None: ...


@dataclass
class Now:
    """The clause that is being read."""

    telling: tuple[int, int, str] = (-1, -1, "")
    """Sentence and sense of the present clause, and where the verb before it stands."""
    each: set[str] = field(default_factory=set[str])
    """Members of a plural that the current clause names one by one ("both bricks")."""
    instead: bool = False
    """Whether the clause tells what happens in place of what was aimed at."""
    rereading: set[tuple[int, str]] = field(default_factory=set[tuple[int, str]])
    """Frames with the senses they have been read as."""


@dataclass
class Told:
    """A clause that has been read, with what it is about."""

    frame: Frame
    subject: list[str]
    objects: list[str]

    def named(self) -> list[list[str]]:
        """Everything that it names, the subject first."""
        phrases = [p.mention.entities for p in self.frame.phrases if p.mention is not None]
        return [ids for ids in (self.subject, self.objects, *phrases) if ids]


@dataclass
class References:
    """Who the clauses so far were about: what "it" is chosen from."""

    told: list[Told] = field(default_factory=list[Told])
    """The clauses in the order of the text."""
    mounts: dict[int, list[str]] = field(default_factory=dict[int, list[str]])
    """What the person of a subject phrase rides or drives."""
    thrown: dict[int, list[str]] = field(default_factory=dict[int, list[str]])
    """What the person of a subject phrase launched last."""
    launched_by: dict[str, list[str]] = field(default_factory=dict[str, list[str]])
    """What each person launched last."""


@dataclass(frozen=True)
class Posing:
    """A posture that is told of.

    Args:
        actor: Who holds himself so.
        posture: How.
        words: Where its words stand in the text; empty where it only follows from others.
        node: The event with which it begins; None at the start.
    """

    actor: str
    posture: str
    words: tuple[int, int]
    node: str | None


@dataclass(frozen=True)
class Gesturing:
    """A gesture that is told of.

    Args:
        actor: Who makes it.
        gesture: Row of the table of gestures; empty where he only looks at something.
        words: Where its words stand in the text.
        meanwhile: Whether it is told as going on beside what was told before.
        target: Whom or what it is meant for.
    """

    actor: str
    gesture: str
    words: tuple[int, int]
    meanwhile: bool
    target: str | None


@dataclass(frozen=True)
class Climbing:
    """A climb that is told of.

    Args:
        actor: Who climbs.
        thing: What.
        course: up, down, onto or over.
        node: The event at its end.
        words: Where its words stand in the text.
    """

    actor: str
    thing: str
    course: str
    node: str
    words: tuple[int, int]


@dataclass
class Moves:
    """What is told of those who move."""

    aim: dict[str, str] = field(default_factory=dict[str, str])
    """Last thing an actor moves towards."""
    last_hit: tuple[str, str] | None = None
    stated: dict[str, Amount] = field(default_factory=dict[str, Amount])
    """Speeds stated with the noun ("a car at 50 km/h")."""
    own_speed: dict[str, Amount] = field(default_factory=dict[str, Amount])
    """Speeds stated one for each ("two trains at 20 m/s and 30 m/s")."""
    rates: dict[str, tuple[Amount, float]] = field(default_factory=dict[str, tuple[Amount, float]])
    """Stated rate of braking and the speed it starts from [cm/s]."""
    waiting: dict[str, Amount] = field(default_factory=dict[str, Amount])
    """How long an actor waits before it moves (on)."""
    came_down: set[str] = field(default_factory=set[str])
    """What has dropped or fallen onto something."""
    rolling: set[str] = field(default_factory=set[str])
    """What the prompt says rolls or slides."""
    flying: set[str] = field(default_factory=set[str])
    """What flies by its own power."""
    leaning: set[str] = field(default_factory=set[str])
    """What leans on something, so that it tips over when it falls."""
    on_top: dict[str, str] = field(default_factory=dict[str, str])
    """What moves about on something, and on what."""
    hovering: set[str] = field(default_factory=set[str])
    """What is told to hold its height in the air at first."""
    upon: dict[str, str] = field(default_factory=dict[str, str])
    """What somebody has leapt onto, and is on."""
    climbs: list[Climbing] = field(default_factory=list[Climbing])
    """Who climbs what."""
    postures: list[Posing] = field(default_factory=list[Posing])
    """Who sits, lies, kneels or stands, and when."""
    gestures: list[Gesturing] = field(default_factory=list[Gesturing])
    """Who waves, nods, points or looks where, and when."""
    outrun: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    """Events of those who come first, and the same events of those who come later."""
    still: dict[str, int] = field(default_factory=dict[str, int])
    """What is said not to move, and where the prompt says so."""
    stays: dict[str, int] = field(default_factory=dict[str, int])
    """What is said to stay still for a while at least, and where the prompt says so."""
    held_back: dict[str, list[Frame]] = field(default_factory=dict[str, "list[Frame]"])
    """Clauses after which somebody sets off who has not moved before."""
    patient: set[str] = field(default_factory=set[str])
    """Who waits, nobody says how long."""


@dataclass
class Times:
    """When events take place, and which are not settled yet."""

    pending: dict[str, tuple[NodeEvent, Frame, str | None, Time | None]] = field(
        default_factory=dict[str, tuple[NodeEvent, Frame, "str | None", "Time | None"]]
    )
    """Arrivals ("walks to the door") and falls that a later event may replace."""
    gap: Amount | None = None
    """Time until the next event ("brakes 2 seconds before ...")."""
    gap_of: Frame | None = None
    """The clause that tells it, whose own events do not end it."""
    before_fall: tuple[Frame, str | None] | None = None
    """A clause that tells a fall and a landing, and what was told before it."""
    of_frame: list[tuple[Frame, str]] = field(default_factory=list[tuple[Frame, str]])
    """Point events in the order told, with the clauses that tell them."""
    before: dict[str, str | None] = field(default_factory=dict[str, "str | None"])
    """By point event, what was told last before it."""


@dataclass
class Discourse:
    """A prompt being read: its clauses, its referents, and the scene under construction.

    `add_event` and `outcomes` tie the recursion of the readings together: an event may set its
    mover in motion, a motion has outcomes, and an outcome is an event.
    """

    world: World
    text: str
    timeline: TimelineBuilder
    scene: Scene
    mentions: list[Mention]
    told: list[Frame]
    """All clauses, in order of time."""
    attached: list[tuple[Mention, Phrase]]
    """Noun phrases with a place or a property."""
    add_event: AddEvent
    outcomes: Outcomes
    framed: set[int] = field(default_factory=set[int])
    """Noun phrases that are arguments of a verb."""
    now: Now = field(default_factory=Now)
    refs: References = field(default_factory=References)
    moves: Moves = field(default_factory=Moves)
    times: Times = field(default_factory=Times)
