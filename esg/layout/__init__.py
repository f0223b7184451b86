"""Stage 3: layout. `solve(doc, seed=, hints=)` places every node; see docs/layout.md."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.layout.config import LayoutConfig
    from esg.layout.problem.hints import (
        Constellation,
        Corridor,
        Placement,
        StartHints,
        stored_hints,
    )
    from esg.layout.solver import solve, solve_batch

__all__ = [
    "Constellation",
    "Corridor",
    "LayoutConfig",
    "Placement",
    "StartHints",
    "solve",
    "solve_batch",
    "stored_hints",
]

_HOME = {
    **dict.fromkeys(
        ("Constellation", "Corridor", "Placement", "StartHints", "stored_hints"), "problem.hints"
    ),
    "LayoutConfig": "config",
    **dict.fromkeys(("solve", "solve_batch"), "solver"),
}


def __getattr__(name: str) -> Any:
    # numpy and Warp load only when a layout is asked for
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    import importlib

    return getattr(importlib.import_module(f"esg.layout.{_HOME[name]}"), name)
