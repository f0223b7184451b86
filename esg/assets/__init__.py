"""Stage 2: the right, simulation-ready object for every noun (docs/assets.md)."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from esg.assets.appearance import USUAL, Appearance
from esg.graph.models import AssetConfiguration, EsgDocument, RetrievalCandidate

if TYPE_CHECKING:
    import trimesh

    from esg.assets.library.catalogue import Entry


def resolve(doc: EsgDocument, *, seed: int = 0, retrieval_only: bool = False) -> EsgDocument:
    """Fills `asset_configurations` for every `asset_requirement`; pure and deterministic."""
    from esg.assets.stage import resolve as run

    return run(doc, seed=seed, retrieval_only=retrieval_only)


def build_mesh(config: AssetConfiguration, appearance: Appearance = USUAL) -> trimesh.Scene:
    """The asset's geometry [cm] in its local frame: origin bottom centre, front +X, Z up.

    Args:
        config: The asset.
        appearance: How one of it looks where its kind leaves it open (`esg.assets.appearances`).
    """
    from esg.assets.geometry.mesh import build_mesh as run

    return run(config, appearance)


def write_meshes(doc: EsgDocument, folder: Path) -> dict[str, str]:
    """Writes each configuration's GLB (metres, Y up, front +X); returns SHA-256 by asset id."""
    from esg.assets.geometry.mesh import write_meshes as run

    return run(doc, folder)


def search(text: str, k: int = 5) -> list[RetrievalCandidate]:
    """The k library entries nearest in meaning to a text, best first."""
    from esg.assets.library.retrieve import rank

    return rank(text, k=k)


def catalogue() -> tuple[Entry, ...]:
    """Every entry of the embedded library and of all imported ones."""
    from esg.assets.imports.store import active_index

    return active_index().entries
