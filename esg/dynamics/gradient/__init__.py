"""The paper's strategies `ad`, `fd` and `hybrid`, and its refinement by distance fields.

`differentiate` has the gradients of the event losses through the surrogate, `descent` the descents
that follow them or differences of the reference engine, `refine` the pass on distance fields.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dynamics.gradient.descent import descend, descend_from
    from esg.dynamics.gradient.differentiate import ad_valid, check_gradient, gradient, regimes

_HOME = {
    "ad_valid": "differentiate",
    "check_gradient": "differentiate",
    "descend": "descent",
    "descend_from": "descent",
    "gradient": "differentiate",
    "regimes": "differentiate",
}

__all__ = ["ad_valid", "check_gradient", "descend", "descend_from", "gradient", "regimes"]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.dynamics.gradient.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
