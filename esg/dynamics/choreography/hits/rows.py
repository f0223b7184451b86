"""Long rows: what is hit sends the next thing on, four times or more.

Every hit and every way takes some of the speed, and every gap multiplies an error of the aim. So a
long row is reckoned backwards, from the impulse of its last hit to the speed of its first, and its
gaps are no longer than the tenth of a second that keeps two hits apart asks for.
"""

from __future__ import annotations

from collections.abc import Sequence
import itertools

from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import back_spin
from esg.dynamics.story.stagecraft import Prop, passed_on, prop
from esg.dynamics.story.story import Story, hits
from esg.graph.models import EsgDocument
from esg.thresholds import SAFE_IMPULSE_NS
from esg.units import GRAVITY_MPS2

LONG = 4
"""Number of hits from which on a row is long."""
ROW_S = (0.13, 0.15)
"""Time between the hits of a long row, a little over `MIN_EVENT_GAP_S`."""
COASTS = 0.97
"""Share of its speed that a ball which rolls has left where it meets the next one."""
ROUGHER = 1.2
"""Friction that is reckoned with over the usual one, so that a row does not end early."""
LEFT = 0.5
"""Least speed of what slides at its next hit, over what friction takes on the way."""


def rows(doc: EsgDocument, story: Story) -> list[list[str]]:
    """Long rows, each as the names of its members in the order of their hits.

    All but the first are carried from hit to hit: they do not move by themselves, and neither fall
    nor topple nor stand fast before the last hit.
    """
    follows: dict[str, str] = {}
    for _, mover, target in hits(doc, story):
        if not story.is_active(target):
            follows.setdefault(mover, target)
    found: list[list[str]] = []
    for first in (a for a in follows if a not in follows.values()):
        row = [first]
        while row[-1] in follows and follows[row[-1]] not in row:
            row.append(follows[row[-1]])
        carried = row[1:-1]
        if len(row) > LONG and not any(_leaves(doc, story, n) for n in carried):
            found.append(row)
    return found


def row_after(stage: Stage, a: str, b: str) -> list[str]:
    """The members of the long row that a hit of two of them belongs to, from these two on."""
    for row in rows(stage.doc, stage.story):
        keys = [stage.key(n) for n in row]
        if (a, b) in itertools.pairwise(keys):
            return keys[keys.index(a) :]
    return []


def asked_of_first(row: Sequence[Prop], last: float = 0.0) -> float:
    """Speed [m/s] at which the first of a row arrives, so that every hit surely counts.

    Args:
        row: In the order of their hits.
        last: Least speed of the last hit [m/s].
    """
    speed = 0.0
    for mover, target in reversed(list(itertools.pairwise(row))):
        hit = passed_on(mover, target)
        if speed > 0.0:
            rubs = ROUGHER * 0.5 * (target.friction + target.rough)
            slowed = rubs * GRAVITY_MPS2 * ROW_S[1]
            slid = (speed if target.rolls else max(speed, LEFT * slowed)) + slowed
            speed = slid / hit
            if target.rolls:
                # It slides no longer than until it rolls.
                speed = min(speed, (slid - slowed) / _rolling_share(mover, target))
        speed = max(speed, SAFE_IMPULSE_NS / (hit * target.mass), last)
        last = 0.0
    return speed


def _rolling_share(mover: Prop, target: Prop) -> float:
    """Speed with which a ball that was hit rolls on, over the mover's.

    It slides at first, which leaves it five sevenths, less two sevenths of the back spin that it
    gets from what rolls into it.
    """
    hit = passed_on(mover, target)
    spin = 0.0
    if mover.rolls:
        rubs = 0.5 * (mover.friction + target.friction)
        spin = back_spin(mover.mass, target.mass, 1.0, rubs, hit)
    return COASTS * (5.0 * hit - 2.0 * spin) / 7.0


def _leaves(doc: EsgDocument, story: Story, name: str) -> bool:
    return story.topples(name) or story.falls(name) or prop(doc, name).fixed
