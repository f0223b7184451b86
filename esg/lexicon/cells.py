"""Cells of the tables that hold several words."""

from __future__ import annotations


def words(cell: str) -> tuple[str, ...]:
    """The words of a cell, which semicolons part; empty ones are left out."""
    return tuple(word for word in cell.split(";") if word)
