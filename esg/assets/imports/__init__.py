"""Assets from elsewhere: libraries of meshes, generators, and where both are kept.

`sources` and `importer` read folders and catalogues, `describe` measures a mesh, `store` keeps what
was read and joins it to the index, `providers` and `generated` make a mesh to order.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.assets.imports.imported import configure_imported, load_imported
    from esg.assets.imports.providers import GenerationError, Generator, chosen_generator
    from esg.assets.imports.store import active_index, find_record, library_root

__all__ = [
    "GenerationError",
    "Generator",
    "active_index",
    "chosen_generator",
    "configure_imported",
    "find_record",
    "library_root",
    "load_imported",
]

_HOME = {
    "active_index": "store",
    "find_record": "store",
    "library_root": "store",
    "configure_imported": "imported",
    "load_imported": "imported",
    "GenerationError": "providers",
    "Generator": "providers",
    "chosen_generator": "providers",
}


def __getattr__(name: str) -> Any:
    # what is behind a name loads when it is asked for
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)
