"""All renderers, by name."""

from __future__ import annotations

from esg.outcomes import UserError
from esg.view.renderers import cycles, path, raster
from esg.view.renderers.records import Kind

KINDS: dict[str, Kind] = {kind.name: kind for kind in (raster.KIND, path.KIND, cycles.KIND)}


def kind_named(name: str) -> Kind:
    """The renderer of a name.

    Raises:
        UserError: If there is none, with those there are.
    """
    if name not in KINDS:
        raise UserError(f"--renderer {name!r}: choose from {', '.join(KINDS)}")
    return KINDS[name]
