"""Imported asset libraries on this machine.

A library is a folder below the root (`ESG_ASSET_LIBRARY`, else the user's data folder):
`assets/*.json`, `meshes/*.glb`, `index.npz` (embeddings) and `convex/` (cached convex parts).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
import hashlib
import json
import os
from pathlib import Path
import re
from typing import Any

import numpy as np

from esg.assets.library.catalogue import Entry
from esg.assets.library.index import (
    Index,
    compute_vectors,
    embedded_index,
    owners,
    pack,
    unpack,
)
from esg.assets.materials import MATERIALS
from esg.graph.models import Joint, Mount
from esg.outcomes import UserError

INDEX_NAME = "index.npz"
PART = "part"
"""Flag of a part of a model with joints: nobody finds it, a document asks for it."""


def library_root() -> Path:
    """Folder of all imported libraries."""
    chosen = os.environ.get("ESG_ASSET_LIBRARY")
    if chosen:
        return Path(chosen)
    base = os.environ.get("XDG_DATA_HOME") or str(Path.home() / ".local" / "share")
    return Path(base) / "esg" / "assets"


def library_folders() -> list[Path]:
    """Folders of finished libraries, sorted by name."""
    root = library_root()
    return sorted(p.parent for p in root.glob(f"*/{INDEX_NAME}")) if root.is_dir() else []


def read_records(folder: Path) -> list[dict[str, Any]]:
    """Records of a library, sorted by key.

    Raises:
        UserError: For a damaged one.
    """
    return [read_record(p) for p in sorted((folder / "assets").glob("*.json"))]


def read_record(path: Path) -> dict[str, Any]:
    """One record of a library, as `esg.assets.imports.importer` writes it.

    Raises:
        UserError: Naming what is wrong with it.
    """
    record: Any = None
    try:
        record = json.loads(path.read_bytes())
        wrong = [n for n, sound in _FIELDS.items() if not sound(record[n])]
        for name, kind in _LISTS.items():
            _ = [kind.model_validate(one) for one in record.get(name, ())]
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        wrong = [f"{type(error).__name__}: {error}"]
    if wrong:
        raise UserError(
            f"{path} is damaged ({', '.join(wrong)}); import its library again, or delete the file"
        )
    return record


def _texts(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(v, str) for v in value)


def _three(value: Any) -> bool:
    return (
        isinstance(value, list) and len(value) == 3 and all(_positive(v) or v == 0 for v in value)
    )


def _positive(value: Any) -> bool:
    return isinstance(value, int | float) and 0 < value < 1e9 and not isinstance(value, bool)


def _word(value: Any) -> bool:
    return isinstance(value, str)


_FIELDS: dict[str, Callable[[Any], bool]] = {
    "key": lambda v: _word(v) and bool(v),
    "name": _word,
    "parents": _texts,
    "dimensions_cm": lambda v: _three(v) and all(v),
    "mass_kg": _positive,
    "material": lambda v: v in MATERIALS,
    "color_rgb": _three,
    "flags": _texts,
    "tags": _texts,
    "description": _word,
    "mesh_sha256": lambda v: _word(v) and re.fullmatch(r"[0-9a-f]{64}", v) is not None,
    "license": lambda v: v is None or _word(v),
    "attribution": _word,
    "proxies": lambda v: isinstance(v, list),
    "surfaces": lambda v: isinstance(v, list),
}
"""What every record has, and whether a value will do."""
_LISTS: dict[str, type[Joint] | type[Mount]] = {"joints": Joint, "mounts": Mount}
"""What the records of models with joints have besides (`esg.assets.imports.models`)."""


def joined_records() -> list[tuple[Path, dict[str, Any]]]:
    """Folders and records of the roots of models with joints, by library and key."""
    found = _joined(_state())
    return list(found)


@lru_cache(maxsize=2)
def _joined(state: tuple[tuple[str, int], ...]) -> tuple[tuple[Path, dict[str, Any]], ...]:
    folders = [Path(path) for path, _ in state]
    return tuple((f, r) for f in folders for r in read_records(f) if r.get("joints"))


def _listed(folder: Path) -> tuple[Entry, ...]:
    """Entries of a library that may be found: no parts."""
    return tuple(as_entry(r, folder.name) for r in read_records(folder) if PART not in r["flags"])


def as_entry(record: dict[str, Any], library: str) -> Entry:
    """A record as a catalogue entry."""
    return Entry(
        name=record["key"],
        parents=tuple(record["parents"]),
        builder="",
        params=(),
        dimensions_cm=tuple(record["dimensions_cm"]),
        mass_kg=record["mass_kg"],
        material=record["material"],
        color_rgb=tuple(record["color_rgb"]),
        flags=frozenset(record["flags"]),
        synonyms=(record["name"], *record["tags"]),
        description=record["description"],
        library=library,
        mesh_file=f"meshes/{record['mesh_sha256']}.glb",
        license=record["license"] or "unknown",
        attribution=record["attribution"],
    )


def write_index(folder: Path) -> None:
    """Embeds the library's texts into `index.npz`; unchanged texts cost nothing."""
    entries = _listed(folder)
    target = folder / INDEX_NAME
    if target.is_file() and unpack(target.read_bytes(), entries) is not None:
        target.touch()
        return
    partial = target.with_suffix(".part")
    partial.write_bytes(pack(entries))
    partial.replace(target)


def _state() -> tuple[tuple[str, int], ...]:
    return tuple((str(f), (f / INDEX_NAME).stat().st_mtime_ns) for f in library_folders())


def active_index() -> Index:
    """Index of the embedded library and of every imported one."""
    base, state = embedded_index(), _state()
    return _extended(base.fingerprint, state) if state else base


@lru_cache(maxsize=2)
def _extended(fingerprint: str, state: tuple[tuple[str, int], ...]) -> Index:
    base = embedded_index()
    entries, vectors = list(base.entries), [base.vectors]
    digest = hashlib.sha256(fingerprint.encode())
    for path, _ in state:
        folder = Path(path)
        more = _listed(folder)
        data = (folder / INDEX_NAME).read_bytes()
        found = unpack(data, more)
        vectors.append(compute_vectors(more) if found is None else found)
        entries += more
        for entry in more:
            digest.update(f"{folder.name}/{entry.name}/{entry.mesh_file}\n".encode())
    everything = tuple(entries)
    return Index(everything, np.concatenate(vectors), owners(everything), digest.hexdigest()[:16])


def find_record(qualified: str) -> tuple[Path, dict[str, Any]] | None:
    """Library folder and record of an asset named "library/key"; None if it is not here."""
    library, _, key = qualified.partition("/")
    folder = library_root() / library
    path = folder / "assets" / f"{key}.json"
    if not key or ".." in qualified or not path.is_file():
        return None
    return folder, read_record(path)
