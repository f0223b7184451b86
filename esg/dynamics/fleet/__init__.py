"""Many scenes searched at once, whose rollouts share every launch of the engines.

A `crew` of workers searches scenes, and hands its rollouts to one `server` that plays them
together; `many` runs both.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dynamics.fleet.many import STRATEGIES, Clock, optimize_many

_HOME = {
    "Clock": "many",
    "STRATEGIES": "many",
    "optimize_many": "many",
}

__all__ = ["Clock", "STRATEGIES", "optimize_many"]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.dynamics.fleet.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
