"""The types of events: how each is detected, what it costs, and how it is differentiated.

`KINDS` is the one place that knows them. Whoever needs to know something of a type of event asks
`kind_of`; a new type is a new row, put there by `register`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
import math
from typing import TYPE_CHECKING

import numpy as np

from esg.dynamics.losses import breaking, handling, joints, measures, quantities, residuals
from esg.dynamics.losses.measures import AddTerm, Detected
from esg.dynamics.losses.recording import Floats, Recording
from esg.graph.models import NodeEvent, TimelineNode
from esg.thresholds import MIN_EVENT_GAP_S, MOVING_MPS

if TYPE_CHECKING:
    from esg.dynamics.losses.smooth import EventLosses

Measure = Callable[[Recording, TimelineNode, Floats, AddTerm], Detected]
"""Recording, event, earliest time [s] of shape [W], where further terms go -> what was detected."""
Smooth = Callable[["EventLosses", TimelineNode, list[int], Floats], None]
"""Losses of a taped rollout, event, the worlds in which it may happen, earliest time [s] of shape
[W]: adds the event's residuals there."""

CHAIN_MARGIN_S, FALLEN_MARGIN_S, CLOSE = 0.03, 0.1, 0.4
"""A hit this much later than that survives another engine; loss of one that is not later at all."""
SETTLED_S = 0.2
"""A hit this long after a fall follows it in every engine."""


@dataclass(frozen=True)
class Spacing:
    """What it costs to follow another event so closely that another engine may not see it follow.

    Args:
        term: Name of the loss term.
        cost: Time since the earliest one that counts [s] -> loss, both of shape [W].
    """

    term: str
    cost: Callable[[Floats], Floats]


@dataclass(frozen=True)
class EventKind:
    """One type of event.

    Args:
        event: Its name in a timeline.
        measure: Its detector; None where the program itself sets its time.
        after_s: What follows it and is measured with it lasts so long [s]; inf where anything
            later may undo it: who shall miss something may touch it at any time.
        gap_s: It counts only so long after what it follows [s].
        spacings: By the type of event that it follows.
        distance: What the quantity `distance` means at it (`quantities`).
        smooth: Adds its residuals to a taped rollout's; None where it has none.
        smooth_gap_s: The same as `gap_s` there.
        by_program: The program sets its time.
        contact: Bodies have touched when it happens.
        sends: It sets its second participant in motion.
    """

    event: str
    measure: Measure | None = None
    after_s: float = math.inf
    gap_s: float = 0.0
    spacings: Mapping[str, Spacing] = field(default_factory=dict)
    distance: quantities.Distance = quantities.covered
    smooth: Smooth | None = None
    smooth_gap_s: float = 0.0
    by_program: bool = False
    contact: bool = False
    sends: bool = False


KINDS: dict[str, EventKind] = {}
"""Every type of event by its name."""


def register(kind: EventKind) -> None:
    """Adds a type of event, or replaces the one of its name."""
    KINDS[kind.event] = kind


def kind_of(node: TimelineNode) -> EventKind:
    """The type of an event.

    Raises:
        KeyError: For a type that nobody registered.
    """
    name = _name(node.event)
    if name not in KINDS:
        raise KeyError(f"event {node.id!r} is of the unknown type {name!r}; known: {[*KINDS]}")
    return KINDS[name]


def _name(event: str) -> str:
    return event.value if isinstance(event, NodeEvent) else event


def _apart(margin_s: float) -> Callable[[Floats], Floats]:
    return lambda late: CLOSE * np.clip(1 - late / margin_s, 0, 1)


def _settled(late: Floats) -> Floats:
    return np.clip(SETTLED_S - (late + MIN_EVENT_GAP_S), 0.0, SETTLED_S)


for _kind in (
    EventKind(NodeEvent.SCENE_START.value, after_s=0.1),
    EventKind(NodeEvent.TRIGGER.value, after_s=0.1, by_program=True),
    EventKind(
        NodeEvent.COLLISION.value,
        measures.collision,
        after_s=0.4,
        gap_s=MIN_EVENT_GAP_S,
        spacings={
            # What follows too closely counts as one hit in another engine.
            NodeEvent.COLLISION.value: Spacing("close", _apart(CHAIN_MARGIN_S)),
            # It leans against what it hits before another engine counts it as toppled.
            NodeEvent.TOPPLE.value: Spacing("close", _apart(FALLEN_MARGIN_S)),
            NodeEvent.FALL.value: Spacing("early", _settled),
        },
        smooth=residuals.collision,
        smooth_gap_s=MIN_EVENT_GAP_S,
        contact=True,
        sends=True,
    ),
    EventKind(
        NodeEvent.REACH.value,
        measures.reach,
        distance=quantities.nearest,
        smooth=residuals.crossing(residuals.nearness),
    ),
    EventKind(
        NodeEvent.MISS.value,
        measures.miss,
        distance=quantities.nearest,
        smooth=residuals.miss,
    ),
    EventKind(
        NodeEvent.ENTER_REGION.value,
        measures.enter,
        after_s=1.0,
        smooth=residuals.crossing(residuals.way_into),
        smooth_gap_s=MIN_EVENT_GAP_S,
    ),
    EventKind(
        NodeEvent.STOP.value,
        measures.stop,
        after_s=0.3,
        distance=quantities.braked,
        smooth=residuals.crossing(residuals.speed_of, after_above=MOVING_MPS),
    ),
    EventKind(NodeEvent.TOPPLE.value, measures.topple, after_s=1.0, contact=True),
    EventKind(NodeEvent.FALL.value, measures.fall, after_s=0.3, contact=True),
    EventKind(NodeEvent.HEADING_REACHED.value, measures.heading, after_s=0.3, by_program=True),
    EventKind(
        NodeEvent.POSITION_AT.value, measures.position, after_s=0.3, smooth=residuals.position
    ),
    EventKind(NodeEvent.PICKED_UP.value, handling.picked_up, after_s=0.3),
    EventKind(NodeEvent.PLACED.value, handling.placed, after_s=0.5, contact=True),
    EventKind(NodeEvent.BOUNCE.value, handling.bounce, after_s=0.3, contact=True),
    EventKind(NodeEvent.JUMP.value, handling.jump, after_s=0.3),
    EventKind(NodeEvent.SPIN.value, handling.spin, after_s=0.2),
    EventKind(NodeEvent.OPEN.value, joints.opened, after_s=0.3),
    EventKind(NodeEvent.CLOSE.value, joints.closed, after_s=0.5),
    EventKind(NodeEvent.SWING.value, joints.swung, after_s=0.2),
    EventKind(NodeEvent.BREAK.value, breaking.broke, after_s=0.6, contact=True),
):
    register(_kind)
