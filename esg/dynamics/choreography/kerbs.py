"""On which side of a street vehicles pass what stands at its kerb, and how far from it."""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.stagecraft import Prop
from esg.layout.problem.streets import (
    CROSSINGS,
    FACE_TRAFFIC,
    KERB_GAP_CM,
    Street,
    is_kerbside,
    street_in,
    street_of,
    words_of,
)


@dataclass(frozen=True)
class Kerb:
    """The kerb beside a vehicle's lane.

    Args:
        street: Cross section of the street.
        turned: Yaw of what stands at the kerb, from the vehicle's heading [rad].
    """

    street: Street
    turned: float

    @property
    def side(self) -> float:
        """-1 for the right of a vehicle, +1 for its left."""
        return self.street.keeps

    def gap_m(self, vehicle: Prop) -> float:
        """From the vehicle, half-way between its lane's middle and edge, to what it passes [m]."""
        slack = max(0.01 * self.street.half_lane - vehicle.half_width, 0.0)
        return 0.5 * slack + 0.01 * KERB_GAP_CM


def street_crossed(stage: Stage, mover: str, other: str) -> Street | None:
    """The street across which a vehicle finds a crosswalk; None for anything else."""
    road = street_in(stage.doc)
    crosses = words_of(stage.doc, stage.member(other)) & CROSSINGS
    if road is None or not crosses or not stage.prop(mover).wheeled:
        return None
    return street_of(stage.doc, road)


def kerb_passed(stage: Stage, mover: str, other: str) -> Kerb | None:
    """The kerb at which a vehicle passes something; None off streets, or for what is on them."""
    doc, name = stage.doc, stage.member(other)
    road = street_in(doc)
    if road is None or not stage.prop(mover).wheeled or not is_kerbside(doc, name):
        return None
    street = street_of(doc, road)
    assert street is not None
    if stage.prop(other).wheeled:
        return Kerb(street, 0.0)
    faces = math.pi if words_of(doc, name) & FACE_TRAFFIC else -street.keeps * 0.5 * math.pi
    return Kerb(street, faces)
