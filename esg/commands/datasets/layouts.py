"""Layouts of a dataset, as `esg dataset --layout` asks for them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.dataset.folder import DatasetFolder
    from esg.dataset.plan import DatasetSpec
    from esg.dataset.remote import Remote


@Parameter(name="*")
@dataclass(frozen=True)
class LayoutOptions:
    """How the dataset is laid out.

    Args:
        layout: parquet is always there; webdataset, lerobot and movi (several with commas) are
            written beside it, below layouts/. With --resume, a finished dataset gets them too.
        meshes: Pack the meshes that manifests name beside them.
    """

    layout: str = "parquet"
    meshes: bool = True


def check_layouts(options: LayoutOptions | None) -> tuple[str, ...]:
    """Names of the layouts that are asked for, besides the canonical one.

    Raises:
        UserError: If there is no such layout.
    """
    from esg.dataset.layouts.registry import chosen

    return chosen((options or LayoutOptions()).layout)


def check_rendered(folder: DatasetFolder, spec: DatasetSpec, names: tuple[str, ...]) -> None:
    """Refuses layouts of clips for a dataset that will have none.

    Raises:
        UserError: If it has none.
    """
    from esg.dataset.layouts.building import no_clips
    from esg.dataset.layouts.source import Source
    from esg.outcomes import UserError

    if names and spec.render is None and not Source(folder.path).has_clips:
        raise UserError(no_clips(folder.label, names))


def lay_out(folder: DatasetFolder, remote: Remote | None, show: Callable[[str], object]) -> bool:
    """Writes the layouts that a finished dataset was asked to have and lacks.

    Args:
        folder: Of the dataset.
        remote: Where it is, if it is elsewhere.
        show: Told what is being written.

    Returns:
        Whether any was written.

    Raises:
        UserError: If that fails.
    """
    from esg.dataset.layouts.building import DONE, FOLDER, add_layouts, wanted_layouts

    wanted = wanted_layouts(folder.path)
    if remote is not None and wanted:
        there = remote.names("")
        if all(f"{FOLDER}/{name}/{DONE}" in there for name in wanted):
            return False
        show("fetching clips")
        other = (FOLDER, "parts/", "marks/", "rendering/")
        remote.pull(folder.path, [n for n in there if not n.startswith(other)])
    return bool(add_layouts(folder.path, wanted, show))


def push_layouts(folder: DatasetFolder, remote: Remote) -> None:
    """Uploads the layouts of a dataset that is there already, what says that they are whole last.

    The card, which tells how to read them, comes with them.

    Raises:
        UserError: If that fails.
    """
    from esg.dataset.card import CARD
    from esg.dataset.layouts.building import DONE, FOLDER, WANTED

    paths = [p for p in (folder.path / FOLDER).rglob("*") if p.is_file() and p.name[0] != "."]
    ordered = sorted(paths, key=lambda p: (p.name == DONE, p))
    names = [p.relative_to(folder.path).as_posix() for p in ordered]
    remote.push(folder.path, [*names, WANTED.as_posix(), CARD])
