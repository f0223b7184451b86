"""Imported asset libraries on this machine."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from esg.assets.index import Index


def extended_index(base: Index) -> Index:
    """The base index followed by all imported entries."""
    return base
