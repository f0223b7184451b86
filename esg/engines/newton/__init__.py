"""The reference engine: Newton's Steel solver.

What others use is found here; it is imported when it is asked for, since it needs Warp.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.engines.newton.declaring import unread
    from esg.engines.newton.engine import NewtonEngine, clear_cache
    from esg.engines.newton.setup import quiet_warp

__all__ = ["NewtonEngine", "clear_cache", "quiet_warp", "unread"]

_MODULES = {
    "declaring": ("unread",),
    "engine": ("NewtonEngine", "clear_cache"),
    "setup": ("quiet_warp",),
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    for module, names in _MODULES.items():
        if name in names:
            return vars(import_module(f"{__name__}.{module}"))[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
