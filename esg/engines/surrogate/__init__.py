"""The fused surrogate: whole rollouts in one launch, for searches and gradients.

What others use is found here; it is imported when it is asked for, since it needs Warp.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.engines.surrogate.engine import SurrogateEngine
    from esg.engines.surrogate.sdf_engine import BodyField, SdfSurrogateEngine, is_ball
    from esg.engines.surrogate.tape import Pull, Seeds, TapedRollout, Touch, warmup

__all__ = [
    "BodyField",
    "Pull",
    "SdfSurrogateEngine",
    "Seeds",
    "SurrogateEngine",
    "TapedRollout",
    "Touch",
    "is_ball",
    "warmup",
]

_MODULES = {
    "engine": ("SurrogateEngine",),
    "sdf_engine": ("BodyField", "SdfSurrogateEngine", "is_ball"),
    "tape": ("Pull", "Seeds", "TapedRollout", "Touch", "warmup"),
}


def __getattr__(name: str) -> Any:
    from importlib import import_module

    for module, names in _MODULES.items():
        if name in names:
            return vars(import_module(f"{__name__}.{module}"))[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
