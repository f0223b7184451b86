"""The search for theta: panels of engines, strategy `batched`, baselines and the closed loop.

`simulate` plays candidates in an engine, `panel` judges them in the reference engine under an
ensemble of perturbations, `batched` decides which to play, `results` writes what was found.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dynamics.search.panel import REFERENCE_DT_S, Found, Panel
    from esg.dynamics.search.simulate import Simulator

_HOME = {
    "Found": "panel",
    "Panel": "panel",
    "REFERENCE_DT_S": "panel",
    "Simulator": "simulate",
}

__all__ = ["Found", "Panel", "REFERENCE_DT_S", "Simulator"]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.dynamics.search.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
