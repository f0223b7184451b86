"""A module that is imported at its first use: mesh libraries cost a second that resolving saves."""

from __future__ import annotations

from importlib import import_module
from typing import Any


class LazyModule:
    """Stands for a module until one of its attributes is wanted."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        return getattr(import_module(self._name), attribute)


shapes: Any = LazyModule("esg.assets.geometry.shapes")
forms: Any = LazyModule("esg.assets.geometry.forms")
