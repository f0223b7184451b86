"""Gestures of arms of somebody who goes meanwhile: angles of his arms, where his legs step."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.engines.wheels import gesturing
from esg.lexicon.gestures import EASES, SWEEPS, Gesture, gestures

if TYPE_CHECKING:
    from esg.engines.scene import Body

Floats = NDArray[np.float64]
FIELDS = ("swing", "out", "bend", "turn")
"""Angles of an arm, as poses have them."""
SOFT_S = 0.05
"""States are steps; between them an arm moves for about so long."""
_PLAN = "people"

Made = tuple[tuple[Gesture, Floats, Floats], ...]
"""Gestures, each with how much it is at its rest and at its far end, 0 to 1, shape [T]."""


def arms_alone(body: Body) -> bool:
    """Whether somebody makes gestures, and all of them with his arms alone."""
    rows = [gestures().get((g.name, _PLAN)) for g in body.gestures]
    joints = (joint for row in rows if row is not None for joint, _ in (*row.rest, *row.far))
    return bool(rows) and None not in rows and all(joint.startswith("arm_") for joint in joints)


def made_by(body: Body, time: Floats, events: Mapping[str, float | None]) -> Made:
    """What somebody makes with his arms.

    Args:
        body: With its gestures.
        time: Of the frames [s], shape [T].
        events: Times of the events [s], None for those that did not happen.
    """
    from scipy.ndimage import gaussian_filter1d

    wide = SOFT_S / max(float(np.median(np.diff(time))), 1e-6)
    out: list[tuple[Gesture, Floats, Floats]] = []
    for own in body.gestures:
        states = gesturing(own, time, events).astype(float) / (EASES, SWEEPS)
        eased: Floats = gaussian_filter1d(states, wide, axis=0, mode="nearest")
        out.append((gestures()[own.name, _PLAN], eased[:, 0], eased[:, 1]))
    return tuple(out)


def gestured(arm: str, angles: list[Floats], made: Made) -> list[Floats]:
    """Angles of an arm with what is made with it.

    Args:
        arm: arm_left or arm_right.
        angles: Without gestures, one of `FIELDS` each [deg], shape [T].
        made: The gestures.
    """
    out = list(angles)
    for row, rest, far in made:
        at_rest, at_far = dict(row.rest), dict(row.far)
        for k, field in enumerate(FIELDS):
            joint = f"{arm}.{field}"
            if joint in at_rest:
                there = at_rest[joint] + (at_far.get(joint, at_rest[joint]) - at_rest[joint]) * far
                out[k] = out[k] + rest * (there - out[k])
    return out
