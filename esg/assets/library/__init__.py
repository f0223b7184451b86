"""The parametric library and the ways to find an entry in it.

`catalogue` holds the entries, `lookup` finds one by name, `index`, `embed` and `retrieve` by
meaning, `hypernyms` and `nearest` by kinship; `wording` and `proposal` say which entry and what
size a requirement means.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.assets.library.catalogue import Entry, build_sketch, entries_by_name
    from esg.assets.library.proposal import choose_dimensions, choose_mass
    from esg.assets.library.retrieve import Decision, decide, rank

__all__ = [
    "Decision",
    "Entry",
    "build_sketch",
    "choose_dimensions",
    "choose_mass",
    "decide",
    "entries_by_name",
    "rank",
]

_HOME = {
    "Entry": "catalogue",
    "build_sketch": "catalogue",
    "entries_by_name": "catalogue",
    "Decision": "retrieve",
    "decide": "retrieve",
    "rank": "retrieve",
    "choose_dimensions": "proposal",
    "choose_mass": "proposal",
}


def __getattr__(name: str) -> Any:
    # what is behind a name loads when it is asked for
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
