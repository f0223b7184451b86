"""What `esg assets` shows: plain data for tables and JSON."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from esg.assets.library import Entry
from esg.graph.models import AssetRequirement
from esg.outcomes import UserError


def _name(entry: Entry) -> str:
    return entry.name if entry.library == "parametric" else f"{entry.library}/{entry.name}"


def list_assets(library: str | None = None) -> list[dict[str, Any]]:
    """One row an asset: name, kind, size, mass, licence."""
    from esg.assets import catalogue

    return [
        {
            "name": _name(e),
            "library": e.library,
            "category": e.parents[0] if e.parents else "",
            "dimensions_cm": list(e.dimensions_cm),
            "mass_kg": e.mass_kg,
            "movable": e.movable,
            "license": e.license,
        }
        for e in catalogue()
        if library is None or e.library == library
    ]


def show(name: str) -> dict[str, Any]:
    """Everything known about one asset, with the configuration it gives by default.

    Raises:
        UserError: For an unknown name, with the nearest ones.
    """
    from esg.assets import catalogue, search
    from esg.assets.retrieve import Decision, exact
    from esg.assets.stage import build_configuration

    entry = next((e for e in catalogue() if _name(e) == name), None) or exact(name)
    if entry is None:
        near = ", ".join(c.asset_name for c in search(name, 3))
        raise UserError(f"no asset is called {name!r}; the nearest are {near}")
    need = AssetRequirement(
        asset_category=entry.name,
        asset_description=entry.description,
        expected_dimensions_cm=entry.dimensions_cm,
        expected_mass_kg=entry.mass_kg,
        linear_damping=0.0,
    )
    config = build_configuration(entry.name, need, Decision(entry, 1.0, ()))
    return {
        "name": _name(entry),
        "library": entry.library,
        "parents": list(entry.parents),
        "synonyms": list(entry.synonyms),
        "description": entry.description,
        "material": entry.material,
        "reference": entry.reference,
        "license": entry.license,
        "attribution": entry.attribution,
        "configuration": config.model_dump(mode="json"),
    }


def import_assets(path: str | Path, library: str | None = None, **options: Any) -> dict[str, Any]:
    """Imports a folder or a `.sh3f` and says what happened."""
    from esg.assets.importer import import_folder

    report = import_folder(path, library=library, **options)
    return {
        "library": report.library,
        "folder": str(report.folder),
        "imported": len(report.imported),
        "unchanged": len(report.unchanged),
        "problems": [{"asset": k, "problem": p} for k, p in report.problems],
    }
