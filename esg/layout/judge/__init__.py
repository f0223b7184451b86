"""What a layout is worth, in double precision and apart from the kernels' energies.

`check` measures relations and overlaps, `resting` what stands on air, `screen` passes what is
beyond doubt right, `selection` keeps the best start, `setting` sets planned starts on their
supports.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.layout.judge.check import (
        World,
        binary_violation,
        intrusions,
        penetrations,
        relation_reports,
    )
    from esg.layout.judge.resting import unsupported
    from esg.layout.judge.selection import Found, choose_all

__all__ = [
    "Found",
    "World",
    "binary_violation",
    "choose_all",
    "intrusions",
    "penetrations",
    "relation_reports",
    "unsupported",
]

_HOME = {
    "World": "check",
    "binary_violation": "check",
    "intrusions": "check",
    "penetrations": "check",
    "relation_reports": "check",
    "unsupported": "resting",
    "Found": "selection",
    "choose_all": "selection",
}


def __getattr__(name: str) -> Any:
    # what is behind a name loads when it is asked for
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
