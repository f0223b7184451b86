"""Seeing results: still renders and the contact sheet of a scene (docs/view.md)."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.view.preview import preview

__all__ = ["preview"]


def __getattr__(name: str) -> Any:
    if name == "preview":
        return import_module("esg.view.preview").preview
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
