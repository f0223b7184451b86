"""Convex parts of concave meshes by CoACD, cached by content."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.geometry.fitting import flatten_base, hull_proxy
from esg.graph.models import Proxy

SETTINGS: dict[str, Any] = {"threshold": 0.08, "max_convex_hull": 16, "preprocess_resolution": 30,
            "mcts_iterations": 60, "mcts_nodes": 10, "seed": 1}  # fmt: skip


def available() -> bool:
    """Whether the `coacd` package is installed (an extra)."""
    from importlib.util import find_spec

    return find_spec("coacd") is not None


def content_key(vertices: NDArray[np.float64], faces: NDArray[np.int64]) -> str:
    """Hash of a mesh and the settings."""
    digest = hashlib.sha256(json.dumps(SETTINGS, sort_keys=True).encode())
    digest.update(np.round(np.asarray(vertices), 4).astype("<f8").tobytes())
    digest.update(np.asarray(faces).astype("<i8").tobytes())
    return digest.hexdigest()


def convex_parts(
    vertices: NDArray[np.float64], faces: NDArray[np.int64], cache: Path | None = None
) -> tuple[Proxy, ...] | None:
    """Convex proxies that follow a concave mesh, None without CoACD or if it fails.

    Args:
        vertices: Local frame [cm], shape [n, 3].
        faces: Shape [m, 3].
        cache: Folder of results by content; 1-5 s a mesh are spent once.
    """
    entry = cache / f"{content_key(vertices, faces)}.json" if cache else None
    if entry is not None and entry.is_file():
        return tuple(Proxy.model_validate(p) for p in json.loads(entry.read_text()))
    if not available():
        return None
    import coacd  # type: ignore[import-not-found]  # optional extra

    coacd.set_log_level("error")
    try:
        parts = coacd.run_coacd(coacd.Mesh(vertices, faces), **SETTINGS)
    except RuntimeError:
        return None
    height = float(vertices[:, 2].max())
    proxies = []
    for points, _ in parts:
        points = np.asarray(points, float)
        points[:, 2] = np.maximum(points[:, 2], 0.0)
        if len(points) >= 4 and (np.ptp(points, axis=0) > 1e-3).all():
            proxies.append(hull_proxy(flatten_base(points, height)))
    if not proxies:
        return None
    if entry is not None:
        entry.parent.mkdir(parents=True, exist_ok=True)
        partial = entry.with_suffix(f".{hashlib.sha256(str(entry).encode()).hexdigest()[:8]}.part")
        partial.write_text(json.dumps([p.model_dump(mode="json") for p in proxies]))
        partial.replace(entry)
    return tuple(proxies)
