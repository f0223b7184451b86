"""What an imported model is: category, mass, proxies, surfaces, as a record for its library."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.geometry.boxes import steadied
from esg.assets.geometry.fitting import fit_proxies, support_surfaces
from esg.assets.imports.sources import Source, slug
from esg.assets.library.catalogue import Entry
from esg.assets.materials import MATERIALS, find_material
from esg.graph.models import Proxy

_PACKED_KG_PER_CM3 = 1.2e-4
"""Mass per volume of the bounding box of an average furnishing."""
_SAMPLES = 6000


def nearest_kind(source: Source) -> Entry | None:
    """The parametric entry of the model's kind, by name, tags or meaning."""
    from esg.assets.library.catalogue import entries_by_name
    from esg.assets.library.index import embedded_index
    from esg.assets.library.lookup import exact, head_match
    from esg.assets.library.retrieve import GATE, confidence, rank

    for text in (source.name, *source.tags):
        found = exact(text) or head_match(text)
        if found is not None:
            return found
    index = embedded_index()
    best = rank(source.name, index=index, k=1)[0]
    if confidence(source.name, best, index) >= GATE:
        return entries_by_name()[best.asset_name]
    return None


def usual_dimensions(source: Source) -> tuple[float, float, float] | None:
    """Usual extents of the model's kind [cm]."""
    kind = nearest_kind(source)
    return kind.dimensions_cm if kind else None


def _mass(source: Source, kind: Entry | None, dimensions: NDArray[np.float64]) -> float:
    if source.mass_kg:
        return source.mass_kg
    volume = float(np.prod(dimensions))
    if kind is None:
        return max(volume * _PACKED_KG_PER_CM3, 0.01)
    return kind.mass_kg * volume / math.prod(kind.dimensions_cm)


def sample(vertices: NDArray[np.float64], faces: NDArray[np.int64]) -> NDArray[np.float64]:
    """Surface points: vertices, and points spread evenly over the area, shape [n, 3]."""
    used = vertices[np.unique(faces)]
    if len(used) > _SAMPLES:
        extreme = [int(f(used[:, k])) for k in range(3) for f in (np.argmin, np.argmax)]
        used = used[np.unique(np.r_[np.linspace(0, len(used) - 1, _SAMPLES).astype(int), extreme])]
    tri = vertices[faces]
    area = np.linalg.norm(np.cross(tri[:, 1] - tri[:, 0], tri[:, 2] - tri[:, 0]), axis=1)
    if area.sum() <= 0:
        return used
    rng = np.random.default_rng(0)
    pick = tri[rng.choice(len(tri), _SAMPLES // 2, p=area / area.sum())]
    u = rng.random((len(pick), 2))
    u = np.where(u.sum(1, keepdims=True) > 1, 1 - u, u)
    spread = (
        pick[:, 0] + u[:, :1] * (pick[:, 1] - pick[:, 0]) + u[:, 1:] * (pick[:, 2] - pick[:, 0])
    )
    return np.concatenate([used, spread])


def _parts(
    vertices: NDArray[np.float64], faces: NDArray[np.int64], convex: bool, cache: Path | None
) -> tuple[Proxy, ...] | None:
    """Parts of a concave mesh, None if it has no inside."""
    from esg.assets.geometry.boxes import box_parts
    from esg.assets.geometry.convex import convex_parts

    return convex_parts(vertices, faces, cache) if convex else box_parts(vertices, faces)


def describe(
    source: Source,
    vertices: NDArray[np.float64],
    faces: NDArray[np.int64],
    dimensions: NDArray[np.float64],
    *,
    convex: bool = False,
    cache: Path | None = None,
) -> dict[str, Any]:
    """Record of an asset whose mesh is already in its local frame.

    Args:
        source: Where it comes from.
        vertices: [cm], shape [n, 3].
        faces: Shape [m, 3].
        dimensions: Extents [cm], shape [3].
        convex: Whether concave meshes get convex parts by CoACD (5-30 s each) instead of boxes.
        cache: Folder of CoACD results.
    """
    kind = nearest_kind(source)
    flags = set(kind.flags) if kind else set()
    flags -= {"container", "any_size", "decal"}
    proxies, concave = fit_proxies(sample(vertices, faces), round_allowed="rolls" in flags)
    if concave:
        proxies = _parts(vertices, faces, convex, cache) or proxies
    proxies = steadied(proxies, vertices)
    if "rolls" in flags and proxies[0].kind.value != "sphere":
        flags.discard("rolls")
    material = find_material(source.material)
    parents = [kind.name, *kind.parents] if kind else [slug(source.category) or "object"]
    attribution = ", ".join(
        t for t in (f'"{source.name}"', source.creator, source.origin, source.license) if t
    )
    return {
        "key": source.key,
        "name": source.name,
        "parents": parents,
        "dimensions_cm": [round(float(v), 3) for v in dimensions],
        "mass_kg": round(_mass(source, kind, dimensions), 4),
        "material": (material or MATERIALS[kind.material if kind else "wood_panel"]).name,
        "color_rgb": list(kind.color_rgb) if kind else [0.6, 0.6, 0.6],
        "flags": sorted(flags),
        "tags": list(source.tags),
        "description": source.description or source.category,
        "license": source.license,
        "attribution": attribution,
        "proxies": [p.model_dump(mode="json") for p in proxies],
        "surfaces": [s.model_dump(mode="json") for s in support_surfaces(vertices, faces)],
    }
