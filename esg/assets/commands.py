"""What `esg assets` shows: plain data for tables and JSON."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from esg.assets.library.catalogue import Entry
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


def search_assets(text: str, count: int = 5) -> dict[str, Any]:
    """The assets nearest in meaning to a text, and what a scene that names it would get."""
    from esg.assets import catalogue
    from esg.assets.library.lookup import exact
    from esg.assets.library.retrieve import GATE, confidence, rank

    entries = {_name(e): e for e in catalogue()}
    found = exact(text)
    candidates = rank(text, k=max(count, 5))
    sure = 1.0 if found else confidence(text, candidates[0])
    names = ([_name(found)] if found else []) + [c.asset_name for c in candidates]
    scores = {c.asset_name: c for c in candidates}
    results = []
    for name in list(dict.fromkeys(names))[:count]:
        entry, candidate = entries[name], scores.get(name)
        results.append(
            {
                "name": name,
                "asset_name": name,
                "library": entry.library,
                "category": entry.parents[0] if entry.parents else "",
                "dimensions_cm": list(entry.dimensions_cm),
                "mass_kg": entry.mass_kg,
                "license": entry.license,
                "description": entry.description,
                "score": candidate.score if candidate else 1.0,
                "semantic": candidate.semantic if candidate else 1.0,
            }
        )
    if found:
        verdict = f'"{text}" names {_name(found)}: a scene gets it at once'
    elif sure >= GATE:
        verdict = f"a scene gets {results[0]['name']} (confidence {sure:.2f}, gate {GATE})"
    else:
        verdict = f"a scene gets a plain body (confidence {sure:.2f} is below the gate, {GATE})"
    return {"query": text, "confidence": sure, "gate": GATE, "verdict": verdict, "results": results}


def show(name: str) -> dict[str, Any]:
    """Everything known about one asset, with the configuration it gives by default.

    Raises:
        UserError: For an unknown name, with the nearest ones.
    """
    from esg.assets import catalogue, search
    from esg.assets.library.lookup import exact
    from esg.assets.library.retrieve import Decision
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


def list_materials() -> list[dict[str, Any]]:
    """One row a material: its figures with their source, and how it looks."""
    from dataclasses import asdict

    from esg.assets.materials import MATERIALS

    def row(material: Any) -> dict[str, Any]:
        out = asdict(material)
        red, green, blue = (round(255 * c) for c in material.color)
        out["color"] = f"#{red:02x}{green:02x}{blue:02x}"
        out["stands_for"] = sorted(material.stands_for)
        return out

    return [row(material) for material in MATERIALS.values()]


def draw_materials(path: Path) -> int:
    """Draws a ball of every material into a picture.

    Raises:
        UserError: If it is no picture's name, or cannot be written.
    """
    from esg.assets.swatches import materials_sheet

    if path.suffix.lower() not in {".png", ".jpg", ".jpeg", ".webp"}:
        raise UserError(f"{path}: choose a file that ends in .png, .jpg or .webp")
    try:
        return materials_sheet(path)
    except OSError as error:
        raise UserError(f"cannot write {path}: {error.strerror}; choose another file") from None


def import_assets(path: str | Path, library: str | None = None, **options: Any) -> dict[str, Any]:
    """Imports a folder, a `.sh3f`, or a `.urdf` or MJCF file, and says what happened."""
    from esg.assets.imports.importer import import_folder
    from esg.assets.imports.models.importer import SUFFIXES, import_model

    if Path(path).is_file() and Path(path).suffix.lower() in SUFFIXES:
        report = import_model(path, library=library)
    else:
        report = import_folder(path, library=library, **options)
    return {
        "library": report.library,
        "folder": str(report.folder),
        "imported": len(report.imported),
        "unchanged": len(report.unchanged),
        "problems": [{"asset": k, "problem": p} for k, p in report.problems],
    }
