"""Event losses: how far a rollout is from the timeline, and in what respect.

What a type of event is, how it is detected, what it costs and how it is differentiated is one row
of the table in `kinds`; what a prompt may prescribe for it is one of the table in `quantities`.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dynamics.losses.assessment import Assessment, assess
    from esg.dynamics.losses.kinds import EventKind, kind_of, register

_HOME = {
    "Assessment": "assessment",
    "EventKind": "kinds",
    "assess": "assessment",
    "kind_of": "kinds",
    "register": "kinds",
}

__all__ = ["Assessment", "EventKind", "assess", "kind_of", "register"]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.dynamics.losses.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
