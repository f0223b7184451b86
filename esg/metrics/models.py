"""Frozen models of a suite (what must happen) and of a verdict (what did)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from esg.graph.models import Direction, Filming, Predicate, Side

EventType = Literal[
    "collision",
    "moves",
    "brakes",
    "stops",
    "turns",
    "enters",
    "falls",
    "topples",
    "reaches",
    "misses",
    "bounces",
    "picked_up",
    "placed",
    "jumps",
    "spins",
    "opens",
    "closes",
    "swings",
    "breaks",
    "separates",
]
"""From `misses` on, those of the format's second edition."""

EVENT_FIELDS: dict[str, tuple[str, ...]] = {
    "collision": ("a", "b"),
    "moves": ("object",),
    "brakes": ("object",),
    "stops": ("object",),
    "turns": ("object", "direction"),
    "enters": ("object", "target"),
    "falls": ("object",),
    "topples": ("object",),
    "reaches": ("object", "target"),
    "misses": ("object", "target"),
    "bounces": ("object", "target"),
    "picked_up": ("object",),
    "placed": ("object", "target"),
    "jumps": ("object",),
    "spins": ("object",),
    "opens": ("object",),
    "closes": ("object",),
    "swings": ("object",),
    "breaks": ("object",),
    "separates": ("a", "b"),
}
"""Required fields of every event type."""

EVENT_INSTEAD: dict[str, tuple[str, ...]] = {"misses": ("a", "b")}
"""Other fields that may stand for the required ones: a timeline's Miss, at any distance."""
EVENT_OPTIONAL: dict[str, tuple[str, ...]] = {
    "turns": ("degrees",),
    "falls": ("from",),
    "bounces": ("times",),
    "jumps": ("times",),
    "spins": ("degrees",),
    "opens": ("degrees",),
    "closes": ("degrees",),
    "swings": ("times",),
}
EVENT_DEGREES: dict[str, float] = {"spins": 360.0, "opens": 30.0, "closes": 30.0}
"""What `degrees` is where it is left out; 90 for all others."""

OF_EVENTS = frozenset({Predicate.SAME_TIME, Predicate.BEFORE})
"""Predicates whose participants are events."""

Quantity = Literal[
    "mass",
    "speed",
    "speed_after",
    "time",
    "time_since",
    "time_to_stop",
    "distance",
    "height",
    "angle",
]


class _Frozen(BaseModel):
    model_config = ConfigDict(
        frozen=True, extra="forbid", allow_inf_nan=False, populate_by_name=True
    )


class SuiteEvent(_Frozen):
    """One event that must happen.

    Participants (`a`, `b`, `object`, `target`, `from`) are noun phrases, or exact references:
    "=car_1" a body, "=pin_1,pin_2" a set, "=billiard_table_1/bottom pocket" a region,
    "@1.0,2.0,0.5" a point [m].
    """

    id: str
    type: EventType
    a: str | None = None
    b: str | None = None
    object: str | None = None
    target: str | None = None
    from_: Annotated[str | None, Field(alias="from")] = None
    direction: Literal["left", "right"] | None = None
    degrees: float = 90.0
    times: int = 1
    after: tuple[str, ...] = ()
    """Ids of the events that must come before; the default is resolved on loading."""

    @property
    def participants(self) -> tuple[str, ...]:
        """The phrases of all participants, in the order a, b, object, target, from."""
        phrases = (self.a, self.b, self.object, self.target, self.from_)
        return tuple(p for p in phrases if p is not None)

    @property
    def movers(self) -> tuple[str, ...]:
        """The phrases of the participants whose event this is (targets and supports excluded)."""
        return tuple(p for p in (self.a, self.b, self.object) if p is not None)


class SuiteConstraint(_Frozen):
    """One prompt-specified parameter, scored by PPA; `value` and `range` are in base units."""

    kind: Literal["initial", "outcome"]
    quantity: Quantity
    object: str | None = None
    event: str | None = None
    since: str | None = None
    at: str | None = None
    target: str | None = None
    """For distance: the other end."""
    value: float | None = None
    range: tuple[float, float] | None = None
    unit: str = ""
    """Base unit of the quantity (s, m/s, kg, m, deg), whatever the file was written in."""

    @property
    def label(self) -> str:
        """Compact text, e.g. `time e1 = 3 s` or `speed cars @start in [5, 10] m/s`."""
        parts = [self.quantity]
        if self.object:
            parts.append(self.object)
        if self.target:
            parts.append(f"to {self.target}")
        if self.event:
            parts.append(self.event)
        if self.at:
            parts.append(f"@{self.at}")
        if self.since:
            parts.append(f"since {self.since}")
        if self.range is not None:
            parts.append(f"in [{self.range[0]:g}, {self.range[1]:g}]")
        elif self.value is not None:
            parts.append(f"= {self.value:g}")
        return " ".join([*parts, self.unit]).strip()


class SuiteStatement(_Frozen):
    """One thing that a prompt states beyond its events, scored by SKR.

    `object`, `target`, `a` and `b` are noun phrases or exact references as in `SuiteEvent`; of
    `same_time` and `before` the ids of events. `value` is in base units (m, m/s, degrees, 1).
    """

    id: str
    says: Predicate
    words: str = ""
    """The words of the prompt, where the statement is a document's."""
    object: str | None = None
    target: str | None = None
    a: str | None = None
    b: str | None = None
    direction: Direction | None = None
    side: Side | None = None
    filming: Filming | None = None
    quantity: (
        Literal["speed", "deceleration", "distance", "height", "length", "width", "angle", "count"]
        | None
    ) = None
    value: float | None = None
    range: tuple[float, float] | None = None
    alike: str | None = None
    """Of `size`: a thing whose size it has ("as: chair")."""
    noun: str | None = None
    when: str = "throughout"
    note: str = ""

    @property
    def participants(self) -> tuple[str, ...]:
        """The phrases of things (events and nouns excluded), in the order object, target, a, b."""
        if self.says in OF_EVENTS:
            return ()
        phrases = (self.object, self.target, self.a, self.b, self.alike)
        return tuple(p for p in phrases if p is not None)


class SuiteScene(_Frozen):
    """One prompt and what must happen in it."""

    id: str
    prompt: str
    level: str = ""
    events: tuple[SuiteEvent, ...] = ()
    constraints: tuple[SuiteConstraint, ...] = ()
    objects: tuple[str, ...] = ()
    """Further objects that the text prescribes although no event names them (they count in SLR)."""
    statements: tuple[SuiteStatement, ...] = ()


class Suite(_Frozen):
    """A benchmark suite: the ground truth the judge measures against."""

    suite: str
    source: str = ""
    scenes: tuple[SuiteScene, ...]

    @property
    def n_events(self) -> int:
        """Number of events of all scenes."""
        return sum(len(s.events) for s in self.scenes)


class EventVerdict(_Frozen):
    """Whether one event was completed, when, and what was measured."""

    id: str
    type: str
    completed: bool
    time_s: float | None = None
    """Time of the event from scene start; docs/metrics.md defines it for every type."""
    bodies: tuple[str, ...] = ()
    """The bodies that took part (the ones that decided, where a phrase bound to several)."""
    reason: str = ""
    """Why it is incomplete; empty when completed."""
    measured: dict[str, float] = {}


class ConstraintVerdict(_Frozen):
    """The score of one constraint."""

    constraint: str
    kind: str
    quantity: str
    unit: str
    measured: float | None
    score: float
    score_strict: float
    score_lenient: float
    target: float | tuple[float, float]
    reason: str = ""


class StatementVerdict(_Frozen):
    """Whether one statement was kept, and what was measured."""

    id: str
    says: str
    words: str = ""
    """The words of the prompt, where the statement is a document's."""
    kept: bool | None
    """None: not represented, so there is nothing to measure."""
    measured: dict[str, float] = {}
    reason: str = ""
    """Why it is broken or not represented; empty when kept."""


class Overlap(_Frozen):
    """A pair that starts interpenetrating."""

    a: str
    b: str
    depth_m: float


class LayoutVerdict(_Frozen):
    """Static validity before simulation (paper: Scene Layout Rate)."""

    valid: bool
    missing: tuple[str, ...] = ()
    """Phrases that bind to nothing or to too few objects, with the reason."""
    overlaps: tuple[Overlap, ...] = ()
    """Pairs deeper than the limit."""
    hanging: tuple[str, ...] = ()
    """Bodies that start in the air and fall at once although nothing says so."""
    max_penetration_m: float = 0.0
    """Deepest overlap of any pair, 0 if none touches."""

    @property
    def faults(self) -> tuple[str, ...]:
        """What makes the layout invalid, in words."""
        return (
            *(f"missing: {m}" for m in self.missing),
            *(f"{o.a} and {o.b} overlap by {100 * o.depth_m:.1f} cm" for o in self.overlaps),
            *(f"{n} hangs in the air" for n in self.hanging),
        )


class SceneVerdict(_Frozen):
    """Everything the judge says about one replay of one scene."""

    scene_id: str
    suite_scene: str
    engine: str
    dt_s: float
    layout: LayoutVerdict
    events: tuple[EventVerdict, ...] = ()
    constraints: tuple[ConstraintVerdict, ...] = ()
    statements: tuple[StatementVerdict, ...] = ()
    bindings: dict[str, tuple[str, ...]] = {}
    """Phrase to the names of the bodies or regions it was bound to."""

    @property
    def n_events(self) -> int:
        """Number of events that were asked for."""
        return len(self.events)

    @property
    def completed(self) -> int:
        """Number of completed events."""
        return sum(e.completed for e in self.events)

    @property
    def slr(self) -> bool:
        """Whether the initial layout is valid."""
        return self.layout.valid

    @property
    def verified(self) -> bool:
        """Valid layout and every event completed."""
        return self.layout.valid and self.completed == self.n_events

    @property
    def understood(self) -> bool:
        """Whether the document represents every statement."""
        return all(s.kept is not None for s in self.statements)

    @property
    def kept(self) -> bool:
        """Whether no statement that the document represents is broken."""
        return all(s.kept is not False for s in self.statements)

    @property
    def skr(self) -> float | None:
        """Share of statements kept, of those represented and not; None without statements."""
        if not self.statements:
            return None
        return sum(s.kept is True for s in self.statements) / len(self.statements)

    def ppa(
        self, thresholds: Literal["standard", "strict", "lenient"] = "standard"
    ) -> float | None:
        """Mean score over the constraints, None without constraints."""
        if not self.constraints:
            return None
        name = {"standard": "score", "strict": "score_strict", "lenient": "score_lenient"}
        return sum(getattr(c, name[thresholds]) for c in self.constraints) / len(self.constraints)

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> SceneVerdict:
        """What `to_json` wrote; the numbers that it derives are derived again.

        Raises:
            ValidationError: If it is no verdict.
        """
        return cls.model_validate({k: v for k, v in data.items() if k in cls.model_fields})

    def to_json(self) -> dict[str, Any]:
        """Plain JSON of the verdict with the derived numbers, for `metrics.json`."""
        data = self.model_dump(mode="json")
        data["n_events"] = self.n_events
        data["completed"] = self.completed
        data["slr"] = self.slr
        data["skr"] = self.skr
        data["verified"] = self.verified
        data["ppa"] = {t: self.ppa(t) for t in ("standard", "strict", "lenient")}  # type: ignore[arg-type]  # literals of a tuple
        return data
