"""Import of a robot description: every part an asset, the root with the joints of all."""

from __future__ import annotations

from collections.abc import Iterator
import hashlib
import json
from pathlib import Path
import re
from typing import Any

import numpy as np

from esg.assets.geometry.fitting import support_surfaces
from esg.assets.geometry.rotations import GLTF_FROM_LOCAL
from esg.assets.imports.describe import nearest_kind
from esg.assets.imports.importer import ImportReport, thinned, write_file
from esg.assets.imports.models.admitted import admit
from esg.assets.imports.models.compiled import Part, measured
from esg.assets.imports.sources import Source, slug
from esg.assets.imports.store import PART, library_root, read_record, write_index
from esg.assets.library.lookup import exact
from esg.assets.materials import MATERIALS
from esg.files import explained, refused
from esg.graph.models import Joint
from esg.lexicon.articulations import articulations
from esg.outcomes import UserError

SUFFIXES = (".urdf", ".xml", ".mjcf")
VERSION = 1
_MOST_TOLD = 30


def import_model(path: str | Path, *, library: str | None = None) -> ImportReport:
    """Imports a URDF or MJCF file as one asset with parts and joints.

    Args:
        path: The file; meshes lie in its folder or below.
        library: Name of the library to add to; default the file's stem.

    Raises:
        UserError: With everything that keeps it from being imported; nothing is written then.
    """
    path = Path(path)
    model = admit(path)
    parts: list[Part] = []
    joints: list[Joint] = []
    faults = model.faults
    if not faults:
        parts, joints, faults = measured(model)
    if faults:
        told = "".join(f"\n  {fault}" for fault in faults[:_MOST_TOLD])
        more = len(faults) - _MOST_TOLD
        raise UserError(f"{path} is not imported:{told}" + (f"\n  ({more} more)" * (more > 0)))
    library = slug(library or path.stem) or "imported"
    folder = library_root() / library
    key = slug(model.name) or library
    report = ImportReport(library, folder)
    digest = hashlib.sha256(f"models {VERSION} {key}".encode())
    for data in model.digest:
        digest.update(hashlib.sha256(data).digest())
    if _recorded(folder / "assets" / f"{key}.json") == digest.hexdigest():
        report.unchanged.append(key)
        return report
    words = " ".join(re.findall(r"[a-z0-9]+", model.name.lower()))
    written = list(_records(key, words, parts, joints, report))
    written[0][0]["source_hash"] = digest.hexdigest()
    if told := _taken(words):
        report.problems.append((key, f"warning: {told}"))
    try:
        for inner in ("assets", "meshes"):
            (folder / inner).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        why = explained(error, folder).strerror
        raise UserError(f"cannot write the library {folder}: {why}") from None
    with refused(folder):
        # The root last: until it is there, nothing names the parts.
        for record, glb in reversed(written):
            write_file(folder / "meshes" / f"{record['mesh_sha256']}.glb", glb)
            write_file(folder / "assets" / f"{record['key']}.json", _json(record))
        write_index(folder)
    report.imported.append(key)
    return report


def _taken(words: str) -> str:
    """Why a prompt that says a model's name would get something else; empty if it does not."""
    remedy = 'give the model another name (<robot name="...">, <mujoco model="...">)'
    if (named := exact(words)) is not None:
        return f"{words!r} names {named.name} of the parametric library, which decides; {remedy}"
    own = next((noun for noun in articulations() if f" {words}".endswith(f" {noun}")), None)
    if own is not None:
        return f"{words!r} is read as a {own}, which has parts of its own; {remedy}"
    return ""


def _json(record: dict[str, Any]) -> bytes:
    return json.dumps(record, indent=1).encode()


def _recorded(path: Path) -> str:
    try:
        return str(read_record(path).get("source_hash")) if path.is_file() else ""
    except UserError:
        return ""


def _records(
    key: str, words: str, parts: list[Part], joints: list[Joint], report: ImportReport
) -> Iterator[tuple[dict[str, Any], bytes]]:
    """Record and GLB of every part, the root's first."""
    kind = nearest_kind(Source(key=key, name=words, path=Path()))
    keys = {p.key: key if n == 0 else f"{key}.{p.key}" for n, p in enumerate(parts)}
    told = [
        j.model_copy(update={"child": keys[j.child], "parent": keys[j.parent or ""]})
        for j in joints
    ]
    for n, part in enumerate(parts):
        glb, vertices, faces = _mesh(part, report)
        name = words if n == 0 else f"{words} {part.name}"
        record = {
            "key": keys[part.key],
            "name": name,
            "parents": [kind.name, *kind.parents] if kind and n == 0 else ["object"],
            "dimensions_cm": list(part.dimensions_cm),
            "mass_kg": part.mass_kg,
            "material": (MATERIALS[kind.material] if kind else MATERIALS["plastic_hard"]).name,
            "color_rgb": [round(float(c), 4) for c in part.meshes[0][1][:3]],
            "flags": [*([PART] * (n > 0)), *(["fixed"] * (not part.movable))],
            "tags": [],
            "description": f"{name}, imported with its joints",
            "license": None,
            "attribution": f'"{words}", imported',
            "proxies": [p.model_dump(mode="json") for p in part.proxies],
            "surfaces": [s.model_dump(mode="json") for s in support_surfaces(vertices, faces)],
            "mesh_sha256": hashlib.sha256(glb).hexdigest(),
            "center_of_mass_cm": list(part.center_cm),
            "inertia_kg_cm2": list(part.inertia),
            "mounts": [m.model_dump(mode="json") for m in part.mounts],
        }
        if n == 0:
            record["joints"] = [j.model_dump(mode="json", exclude_none=True) for j in told]
        yield record, glb


def _mesh(part: Part, report: ImportReport) -> tuple[bytes, Any, Any]:
    """A part's GLB, and all its corners and triangles."""
    import trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    scene, vertices, faces, count = trimesh.Scene(), [], [], 0
    notes: list[str] = []
    for k, (mesh, color) in enumerate(part.meshes):
        mesh = thinned(mesh.copy(), notes)
        material = PBRMaterial(
            baseColorFactor=[round(255 * c) for c in color],
            metallicFactor=0.0,
            roughnessFactor=0.6,
            alphaMode="BLEND" if color[3] < 1.0 else None,
        )
        mesh.visual = TextureVisuals(material=material)
        vertices.append(np.asarray(mesh.vertices, float))
        faces.append(np.asarray(mesh.faces, np.int64) + count)
        count += len(mesh.vertices)
        scene.add_geometry(mesh, node_name=f"part_{k:03d}", geom_name=f"part_{k:03d}")
    report.problems += [(part.key, f"warning: {note}") for note in notes]
    scene.apply_transform(GLTF_FROM_LOCAL)
    glb: Any = scene.export(file_type="glb")
    return glb, np.concatenate(vertices), np.concatenate(faces)
