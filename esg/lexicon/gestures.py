"""The table of gestures, `gestures.csv`: how arms, head or tail go, and when.

A gesture eases from how somebody holds himself to its `rest`, goes from there to `far` and back,
`times` over or on and on, and eases out. What is drawn of it are a few states; `states_at` says
which is there when. Angles of people are those of their poses, of animals turns about neck and
tail [deg].
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

TABLE = Path(__file__).parent / "gestures.csv"
EASE_S = 0.4
"""Time in which somebody comes to the rest of a gesture, and leaves it [s]."""
EASES, SWEEPS = 4, 6
"""States in which the way there is drawn, and the way from the rest to its far end."""
SEEN_S = 5.0
"""A scene in which nobody does anything else plays for so long [s]."""
MARK = "~"
"""Between the name of a pose, a gesture and its state, as a pose's name says them."""

State = tuple[int, int]
"""Share of the way to the rest in `EASES`, and from there to the far end in `SWEEPS`."""
NONE: State = (0, 0)


@dataclass(frozen=True)
class Gesture:
    """One row.

    Args:
        name: As statements call it.
        plan: Of the body: people or beasts.
        tip: What goes farthest: hand_right, head or tail.
        period_s: From rest to far and back [s]; 0 is held.
        times: How often; 0 is on and on.
        rest, far: Angles [deg] by joint.
    """

    name: str
    plan: str
    tip: str
    period_s: float
    times: int
    rest: tuple[tuple[str, float], ...]
    far: tuple[tuple[str, float], ...]

    @property
    def lasts_s(self) -> float:
        """From its beginning to its end [s]; infinite if it goes on."""
        return 2.0 * EASE_S + self.times * self.period_s if self.times else np.inf

    def angles(self, state: State, joint: str, own: float) -> float:
        """The angle of a joint in a state [deg].

        Args:
            state: As `state_at` gives it.
            joint: Its name.
            own: Its angle without the gesture.
        """
        rest = dict(self.rest).get(joint, own)
        far = dict(self.far).get(joint, rest)
        return own + (rest - own) * state[0] / EASES + (far - rest) * state[1] / SWEEPS


@cache
def gestures() -> dict[tuple[str, str], Gesture]:
    """Every row by its name and plan."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {
            (r["gesture"], r["plan"]): Gesture(
                r["gesture"], r["plan"], r["tip"], float(r["period_s"]), int(r["times"]),
                _angles(r["rest"]), _angles(r["far"]),
            )
            for r in csv.DictReader(file)
        }  # fmt: skip


def _angles(text: str) -> tuple[tuple[str, float], ...]:
    out: list[tuple[str, float]] = []
    for item in filter(None, text.split(";")):
        joint, angle = item.split("=")
        side = joint.removeprefix("arms.")
        names = [joint] if side == joint else [f"arm_{s}.{side}" for s in ("left", "right")]
        out += [(name, float(angle)) for name in names]
    return tuple(out)


def states_at(period_s: float, times: int, since: NDArray[np.float64]) -> NDArray[np.int64]:
    """States of a gesture at times since its beginning [s], shape [T, 2].

    Args:
        period_s, times: As of `Gesture`.
        since: Shape [T]; what is negative is before it.
    """
    since = np.asarray(since, float)
    ends = 2.0 * EASE_S + times * period_s if times else np.inf
    ease = np.clip(np.minimum(since, ends - since) / EASE_S, 0.0, 1.0)
    ease = np.rint(EASES * ease * ease * (3.0 - 2.0 * ease))
    sweep = np.zeros_like(since)
    if period_s > 0.0:
        under_way = np.clip(since - EASE_S, 0.0, times * period_s if times else None)
        turn = 2.0 * np.pi * under_way / period_s
        sweep = np.rint(SWEEPS * 0.5 * (1.0 - np.cos(turn))) * (ease == EASES)
    return np.stack([ease, sweep], axis=-1).astype(np.int64)


def posed(pose: str, gesture: str, state: State) -> str:
    """The name of a pose with a gesture in it; the pose alone in the state in which nothing is."""
    return pose if state == NONE else MARK.join((pose, gesture, *map(str, state)))


def told_by(pose: str, plan: str) -> tuple[str, Gesture | None, State]:
    """What `posed` has made: the pose, the gesture and its state."""
    own, *rest = pose.split(MARK)
    if not rest:
        return own, None, NONE
    return own, gestures()[rest[0], plan], (int(rest[1]), int(rest[2]))
