"""How people and four-legged animals hold their limbs while they go: angles by phase and speed.

Angles are those of `builders.living.poses` [deg]: swing forwards at hip or shoulder, bend of the
knee backwards and of the elbow forwards, pitch of the toes down. A cycle is two steps; its phase is
0 where the left foot lands.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from esg.units import GRAVITY_MPS2

Floats = NDArray[np.float64]

STRIDE_DEG, RUN_DEG, PACE_DEG = 24.0, 36.0, 22.0
"""Largest swing of a leg of people who walk and who run, and of animals that walk."""
RUNS_FROM, RUNS_AT = 0.55, 0.95
"""Speed over the root of gravity times the leg's length at which a run begins, and is one. People
change at 0.7 (Alexander, 1989)."""
FLIGHT = 0.45
"""Share by which a run's steps are longer than what the legs span: both feet are in the air."""
MOST_HZ = 2.2
"""Cycles a second of legs of 0.9 m at most; those of shorter ones go with the root of it."""
MOVES_MPS = 0.3
"""Slower is no step."""
LEADS = {
    "leg_left": 0.0,
    "leg_right": 0.5,
    "arm_left": 0.5,
    "arm_right": 0.0,
    "leg_rear_left": 0.0,
    "leg_front_left": 0.25,
    "leg_rear_right": 0.5,
    "leg_front_right": 0.75,
}
"""Share of a cycle by which a limb is ahead; animals walk so: Hildebrand (1965)."""
GALLOP = {
    "leg_rear_left": 0.0,
    "leg_rear_right": 0.1,
    "leg_front_left": 0.5,
    "leg_front_right": 0.6,
}


@dataclass(frozen=True)
class Going:
    """How somebody goes, at T instants.

    Args:
        phase: In cycles, shape [T].
        much: 0 at rest to 1 on the way, shape [T].
        runs: 0 for a walk to 1 for a run, shape [T].
    """

    phase: Floats
    much: Floats
    runs: Floats


def going(time: Floats, speed: Floats, carried: Floats, leg: float, reach: float = 1.0) -> Going:
    """The steps of somebody who moves.

    Args:
        time: [s], shape [T].
        speed: Forwards [m/s], shape [T].
        carried: 1 where he stands on something, 0 in the air, shape [T].
        leg: Length of a leg [m].
        reach: Share of the usual step that what is worn allows.
    """
    fast = np.abs(speed)
    froude = fast / np.sqrt(GRAVITY_MPS2 * leg)
    runs = _eased((froude - RUNS_FROM) / (RUNS_AT - RUNS_FROM))
    swing = np.radians(STRIDE_DEG + (RUN_DEG - STRIDE_DEG) * runs)
    cycle = 4.0 * leg * np.sin(reach * swing) * (1.0 + FLIGHT * runs)
    # Who is much faster than his legs takes longer steps rather than whirl them.
    cycle = np.maximum(cycle, fast / (MOST_HZ * np.sqrt(0.9 / leg)))
    step = np.diff(time, prepend=time[:1])
    phase = np.cumsum(speed * carried / cycle * step)
    return Going(phase, _eased(fast / MOVES_MPS), runs)


def person(name: str, go: Going) -> tuple[Floats, Floats, Floats]:
    """Swing, bend and pitch of a limb of somebody who goes, shape [T] each [deg]."""
    angle = 2.0 * np.pi * (go.phase + LEADS[name])
    ahead, back = np.cos(angle), np.maximum(0.0, -np.sin(angle + 0.25))
    if name.startswith("arm"):
        walk = 2.0 + 20.0 * ahead, 18.0 + 8.0 * ahead
        run = 2.0 + 40.0 * ahead, 86.0 + 0.0 * ahead
        pitch = np.zeros_like(ahead)
        return _mixed(walk[0], run[0], go.runs), _mixed(walk[1], run[1], go.runs), pitch
    walk = 3.0 + STRIDE_DEG * ahead, 6.0 + 50.0 * back
    run = 12.0 + RUN_DEG * ahead, 16.0 + 84.0 * back
    pitch = -8.0 * np.maximum(ahead, 0.0) + 26.0 * np.maximum(-ahead, 0.0) ** 1.5
    return _mixed(walk[0], run[0], go.runs), _mixed(walk[1], run[1], go.runs), pitch


def beast(name: str, go: Going) -> tuple[Floats, Floats]:
    """Swing of a leg of an animal that goes, and of its lower half beyond that [deg]."""
    front = "front" in name
    walk = 2.0 * np.pi * (go.phase + LEADS[name])
    run = 2.0 * np.pi * (go.phase + GALLOP[name])
    swing = _mixed(
        PACE_DEG * np.cos(walk), (10.0 if front else -6.0) + RUN_DEG * np.cos(run), go.runs
    )
    lifted = _mixed(
        42.0 * np.maximum(0.0, -np.sin(walk)), 62.0 * np.maximum(0.0, -np.sin(run)), go.runs
    )
    return swing, -lifted


def _mixed(a: Floats, b: Floats, share: Floats) -> Floats:
    return a + (b - a) * share


def _eased(share: Floats) -> Floats:
    share = np.clip(share, 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)
