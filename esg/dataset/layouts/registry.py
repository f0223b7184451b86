"""The layouts by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.dataset.layouts.building import LayoutFolder
    from esg.dataset.layouts.source import Source

CANONICAL = "parquet"
"""The dataset itself: always there, and what all others are written from."""


@dataclass(frozen=True)
class Layout:
    """One way to lay a dataset out.

    Args:
        says: What it is, in a few words.
        home: Module of this package whose `write` makes it.
        version: Of what it writes; layouts of another version are written anew.
    """

    says: str
    home: str
    version: int = 1

    @property
    def write(self) -> Callable[[Source, LayoutFolder], Mapping[str, Any]]:
        """Writes the files; returns what is worth knowing of them."""
        return import_module(f"esg.dataset.layouts.{self.home}").write


LAYOUTS: dict[str, Layout] = {
    "webdataset": Layout("tar shards, a sample a clip", "webdataset"),
    "lerobot": Layout("LeRobot v3.0: Parquet and MP4 chunks, an episode a clip", "lerobot"),
    "movi": Layout("MOVi's fields, a NumPy archive a clip", "movi"),
}
"""All but the canonical one, in the order in which they are written."""


def chosen(text: str) -> tuple[str, ...]:
    """Names of layouts separated by commas, each once, without the canonical one.

    Raises:
        UserError: Naming those that do not exist.
    """
    asked = [name.strip().lower() for name in text.split(",")]
    unknown = sorted({name for name in asked if name not in (*LAYOUTS, CANONICAL)})
    if unknown:
        names = ", ".join(map(repr, unknown))
        known = ", ".join([CANONICAL, *LAYOUTS])
        raise UserError(f"--layout {text!r:.80}: there is no layout {names}; choose of {known}")
    return tuple(name for name in LAYOUTS if name in asked)
