"""Senses: what is read from a clause, by the sense of its verb.

Each module registers the readers of related senses in the table; importing this package fills it.
"""

from esg.draft.events.senses import (
    breaking,
    contact,
    control,
    fall,
    handling,
    joints,
    launch,
    motion,
    outcome,
    state,
    steer,
    topple,
)
from esg.draft.events.table import SENSES

__all__ = [
    "SENSES",
    "breaking",
    "contact",
    "control",
    "fall",
    "handling",
    "joints",
    "launch",
    "motion",
    "outcome",
    "state",
    "steer",
    "topple",
]
