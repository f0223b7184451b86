"""The surrogate and Newton for the jobs (`esg.engines.jobs`) of many scenes at once.

What others use is found here; it is imported when it is asked for, since it needs Warp.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.engines.fleet.newton import FleetNewton
    from esg.engines.fleet.surrogate import FleetSurrogate

__all__ = ["FleetNewton", "FleetSurrogate"]

_MODULES = {"newton": ("FleetNewton",), "surrogate": ("FleetSurrogate",)}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    for module, names in _MODULES.items():
        if name in names:
            return vars(import_module(f"{__name__}.{module}"))[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
