"""A document as a planar problem: supports, units, energy terms, obstacles and search domains.

`hints` is what a planner asks for; `supports` and `grouping` say what carries and what moves with
what; `edges` and `terms` turn relations into energies; `problem` puts it all into the arrays of
`record`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.layout.problem.hints import Constellation, Corridor, Placement, StartHints
    from esg.layout.problem.patterns import DOMINO_PITCH_OVER_HEIGHT, arrange, is_domino_like
    from esg.layout.problem.problem import build_problem
    from esg.layout.problem.record import LayoutProblem
    from esg.layout.problem.supports import FULL, SHELF_THICKNESS_CM

__all__ = [
    "Constellation",
    "Corridor",
    "DOMINO_PITCH_OVER_HEIGHT",
    "FULL",
    "LayoutProblem",
    "Placement",
    "SHELF_THICKNESS_CM",
    "StartHints",
    "arrange",
    "build_problem",
    "is_domino_like",
]

_HOME = {
    "Constellation": "hints",
    "Corridor": "hints",
    "Placement": "hints",
    "StartHints": "hints",
    "DOMINO_PITCH_OVER_HEIGHT": "patterns",
    "arrange": "patterns",
    "is_domino_like": "patterns",
    "build_problem": "problem",
    "LayoutProblem": "record",
    "FULL": "supports",
    "SHELF_THICKNESS_CM": "supports",
}


def __getattr__(name: str) -> Any:
    # what is behind a name loads when it is asked for
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
