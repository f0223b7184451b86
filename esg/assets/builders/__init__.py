"""Parametric builders: one function a family of objects, registered by name.

A builder is called with its sketch, the wanted extents (length along +X, width along Y, height
along Z) [cm] and a main colour, and fills the sketch in the asset's local frame.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import import_module
from pkgutil import walk_packages
from typing import Any, Literal

Policy = Literal["free", "uniform"]
BUILDERS: dict[str, Callable[..., None]] = {}
POLICIES: dict[str, Policy] = {}
DRAWN: dict[str, tuple[float, float, float]] = {}
"""Extents [cm] of what a builder draws, where several sizes of entry share it."""


def builder(
    name: str, policy: Policy = "uniform", drawn: tuple[float, float, float] | None = None
) -> Callable[..., Any]:
    """Registers a builder.

    Args:
        name: What the catalogue calls it.
        policy: `free` builders take any extents; `uniform` ones keep their proportions and are
            scaled as a whole.
        drawn: Extents it draws at, if entries of several sizes share it [cm].
    """

    def register(function: Callable[..., None]) -> Callable[..., None]:
        if name in BUILDERS and BUILDERS[name].__module__ != function.__module__:
            raise ValueError(f"two modules register the builder {name!r}")
        BUILDERS[name] = function
        POLICIES[name] = policy
        if drawn:
            DRAWN[name] = drawn
        return function

    return register


@cache
def modules() -> tuple[str, ...]:
    """Full names of all modules of builders, sorted."""
    found = walk_packages(__path__, f"{__name__}.")
    return tuple(sorted(m.name for m in found if not m.ispkg))


@cache
def load_builders() -> None:
    """Imports every module of builders; the order does not matter, as names are unique."""
    for module in modules():
        import_module(module)
