"""Casting: which bodies, sizes and supports the events of a prompt need.

`cast` is the stage; `rules.RULES` is the table of what is chosen, why, and in which order.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dynamics.casting.stage import cast, fitted

__all__ = ["cast", "fitted"]


def __getattr__(name: str) -> Any:
    # numpy and the catalogue load only when something is cast
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from esg.dynamics.casting import stage

    return getattr(stage, name)
