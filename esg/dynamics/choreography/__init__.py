"""Choreography: where the participants of a timeline start, how they meet, what follows.

It tells the story once in closed form, in a frame of its own (`telling`). What can happen between
two participants is one table, `meetings.MEETINGS`; each meeting lives beside its like.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dynamics.choreography.telling import Choreography, choreograph, choreography_of

_HOME = {
    "Choreography": "telling",
    "choreograph": "telling",
    "choreography_of": "telling",
}

__all__ = ["Choreography", "choreograph", "choreography_of"]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.dynamics.choreography.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
