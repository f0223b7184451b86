"""How fast things under their own power speed up, brake and reverse; what the ground allows.

Nothing is at its speed at once: what sets off from rest gains speed at a rate of its kind, and what
brakes loses it at a constant rate that tyres, hooves and soles can pass on to the ground.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
import math
from pathlib import Path

from esg.dynamics.story.stagecraft import Prop, coasting_drag, ground_friction, prop
from esg.dynamics.story.story import bounds
from esg.graph.models import EsgDocument, Quantity, TimelineEdge
from esg.lexicon.hypernyms import hypernyms
from esg.lexicon.kinds import kinds
from esg.metrics.plausibility.limits import motion_of, surface_grip
from esg.metrics.plausibility.told import surface_of
from esg.thresholds import BRAKING_DRY_G
from esg.units import GRAVITY_MPS2

LASTS_S = 1.1
"""How long somebody does nothing else who sits or lies down, or gets up [s]."""

TABLE = Path(__file__).parent / "paces.csv"
EVERYDAY = 0.7
"""Share of its top speed that nothing exceeds without need."""
SHORT_OF_TOP = 0.95
"""Share of that speed that a search may go up to: engines are not exact."""
SLOWEST_G, FASTEST_G = 0.1, 0.5
"""What anything gains at least and at most, over g."""
FAST = 1.25
"""What reverses fast does so at no more of its usual pace without need."""
IN_NEED = 3.0
"""Times that pace at which it reverses where an event needs it: still no faster than a runner."""
STEADY = 0.75
"""Share of its grip that a usual turn takes: 0.6 g of good tyres on dry asphalt."""


@dataclass(frozen=True)
class Pace:
    """Rates of one kind [m/s^2].

    Args:
        gains: With which it sets off.
        brakes: With which it usually brakes, on dry ground.
        hardest: With which it brakes at most there.
        reverses: Usual speed backwards [m/s]; infinite for what goes both ways alike.
    """

    gains: float
    brakes: float
    hardest: float
    reverses: float


USUAL = Pace(0.3 * GRAVITY_MPS2, 0.5 * GRAVITY_MPS2, BRAKING_DRY_G * GRAVITY_MPS2, 2.0)
"""Of what no row of the table is about."""


@cache
def paces() -> dict[str, Pace]:
    """The rows of the table by kind."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {
            row["kind"]: Pace(
                gains=GRAVITY_MPS2 * float(row["sets_off_g"]),
                brakes=GRAVITY_MPS2 * float(row["brakes_g"]),
                hardest=GRAVITY_MPS2 * float(row["hardest_g"]),
                reverses=float(row["reverses_mps"] or math.inf),
            )
            for row in csv.DictReader(file)
        }


@cache
def _broader() -> dict[str, tuple[str, ...]]:
    """What stands above a kind, nearest first, by all of its names."""
    out: dict[str, tuple[str, ...]] = {}
    for kind in kinds():
        above = (kind.name, *(p.replace("_", " ") for p in kind.parents))
        for name in (kind.name, *kind.said_as, *kind.found_as):
            out.setdefault(name, above)
    return out


def pace_of(*names: str) -> Pace:
    """The pace of the first name that the table, or what stands above it, knows.

    Args:
        names: What a thing is called, the most telling first: its label, its category.
    """
    for name in names:
        for known in _chain(name.lower().replace("_", " ")):
            if known in paces():
                return paces()[known]
    return USUAL


def _chain(name: str) -> list[str]:
    """A name, its last words and what stands above them: "red racing car", "racing car", "car"."""
    words = name.split()
    out: list[str] = []
    for k in range(len(words)):
        part = " ".join(words[k:])
        wider = hypernyms().get(part)
        above = _broader().get(part, ())
        if not above and wider is not None:
            above = _broader().get(wider.kind.replace("_", " "), ())
        out += [part, *above]
    return out


def pace(doc: EsgDocument, name: str) -> Pace:
    """How a node speeds up and brakes.

    Args:
        doc: A document with assets.
        name: A node.
    """
    names = _called(doc, name)
    usual, most, holds = pace_of(*names), motion_of(*names), grip(doc, name)
    return Pace(
        min(usual.gains, most.accelerate_mps2, holds),
        min(usual.brakes, holds),
        min(usual.hardest, holds),
        usual.reverses,
    )


def _called(doc: EsgDocument, name: str) -> tuple[str, str]:
    node = doc.spatial_relation_graph.nodes[name]
    return node.label, doc.asset_configurations[node.asset_id].category


def top_speed(doc: EsgDocument, name: str, backward: bool = False) -> float:
    """The speed [m/s] that a guess stays below: nearly the greatest of a node's kind.

    Args:
        doc: A document with assets.
        name: A node.
        backward: Whether it reverses.
    """
    names = _called(doc, name)
    motion = motion_of(*names)
    if backward:
        return min(SHORT_OF_TOP * motion.reverse_mps, IN_NEED * pace_of(*names).reverses)
    return SHORT_OF_TOP * motion.speed_mps


def stated_speeds(doc: EsgDocument, name: str, edge: TimelineEdge) -> Quantity | None:
    """The speed [cm/s] of a segment; backwards a guess is one at which its kind reverses."""
    guess, most = edge.params.speed, FAST * pace_of(*_called(doc, name)).reverses * 100.0
    reverses = edge.params.backward and not edge.speed_is_prescribed
    if not reverses or not isinstance(guess, tuple) or most >= guess[1]:
        return guess
    return (min(guess[0], 0.5 * most), most)


def grip(doc: EsgDocument, name: str) -> float:
    """The hardest braking or turning [m/s^2] of a node that its ground, or the air, bears.

    Its kind's grip and the surface's are those that a replay is held to.
    """
    motion = motion_of(*_called(doc, name))
    ground = ground_friction(doc)
    if motion.flies:
        mu = motion.grip
    elif math.isnan(motion.grip):
        mu = 0.5 * (prop(doc, name).friction + ground)
    else:
        mu = min(motion.grip, surface_grip(surface_of(doc), ground))
    return mu * GRAVITY_MPS2


def turns_at(doc: EsgDocument, name: str) -> float:
    """Sideways acceleration [m/s^2] of a usual turn of a node at most."""
    return STEADY * grip(doc, name)


def stated_rate(edge: TimelineEdge) -> tuple[float, float] | None:
    """The least and greatest rate [m/s^2] at which a document has something brake, or None."""
    if edge.params.acceleration is None:
        return None
    low, high, _ = bounds(edge.params.acceleration, (0.0, 0.0))
    slow, fast = sorted((0.01 * abs(low), 0.01 * abs(high)))
    return slow, fast


def slows_by(doc: EsgDocument, name: str, speed: float) -> float:
    """Mean rate [m/s^2] at which a node comes to rest from a speed [m/s] without any brakes."""
    body = prop(doc, name)
    return coasting_drag(body) + 0.5 * body.damping * speed


def hardest_brake(doc: EsgDocument, name: str, speed: float) -> float:
    """The hardest braking [m/s^2] of a node on its ground, beside what slows it by itself."""
    body = prop(doc, name)
    return max(pace(doc, name).hardest - coasting_drag(body) - body.damping * speed, 0.05)


def usual_brake(doc: EsgDocument, name: str, speed: float) -> float:
    """The usual braking [m/s^2] of a node beside what slows it by itself."""
    return min(pace(doc, name).brakes, hardest_brake(doc, name, speed))


def usual_stop(doc: EsgDocument, name: str, speed: float) -> float:
    """Mean rate [m/s^2] at which a node usually comes to rest from a speed [m/s]."""
    return usual_brake(doc, name, speed) + slows_by(doc, name, speed)


def usual_halt(doc: EsgDocument, name: str, speed: float, *, held: bool) -> float:
    """The rate [m/s^2] at which a node comes to rest: on its feet or wings, or by its brakes."""
    if held:
        return pace(doc, name).brakes
    return usual_stop(doc, name, speed)


def on_foot(body: Prop) -> bool:
    """Whether a body that moves by itself does so on feet or soles, which do not roll."""
    return not (body.wheeled or body.rolls)
