"""The plan: theta, the control program it stands for, and the physical scene it runs in.

`build` makes the scene of a laid-out document, `variables` the entries of theta, `programs` the
control program of a theta; `planner` puts them together.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.dynamics.plan.build import build_scene, make_body
    from esg.dynamics.plan.feasibility import ruled_out
    from esg.dynamics.plan.planner import Plan, make_plan

_HOME = {
    "Plan": "planner",
    "build_scene": "build",
    "make_body": "build",
    "make_plan": "planner",
    "ruled_out": "feasibility",
}

__all__ = ["Plan", "build_scene", "make_body", "make_plan", "ruled_out"]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"esg.dynamics.plan.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
