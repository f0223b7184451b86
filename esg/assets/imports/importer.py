"""Import of meshes into a library on this machine.

One asset is one JSON file and one GLB, both written under a temporary name and renamed: an import
that was interrupted goes on where it stopped, and a broken model is reported and left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
import hashlib
import json
from pathlib import Path
import tempfile
from typing import Any

import numpy as np

from esg.assets.imports.sources import Source, read_folder, read_sh3f, slug
from esg.assets.imports.store import library_root, read_record, write_index
from esg.files import atomic_file, explained, refused, unwritable
from esg.outcomes import UserError
from esg.strangers import gltf
from esg.strangers.folders import lies_in

IMPORT_VERSION = 2
MAX_FACES = 60_000
MAX_TEXTURE = 1024
_SANE_CM = (0.2, 6000.0)
_ROTATION_ERROR = 0.01
"""By which a rotation matrix may miss: catalogues give three digits."""


@dataclass
class ImportReport:
    """What an import did.

    Args:
        library: Name of the library.
        folder: Where it lies.
        imported: Keys written now.
        unchanged: Keys that were there already.
        problems: (key, what was wrong); `warning:` ones were imported nevertheless.
    """

    library: str
    folder: Path
    imported: list[str] = field(default_factory=list)
    unchanged: list[str] = field(default_factory=list)
    problems: list[tuple[str, str]] = field(default_factory=list)


def import_folder(
    path: str | Path,
    *,
    library: str | None = None,
    limit: int | None = None,
    convex: bool = False,
    progress: Callable[[int, str], None] | None = None,
) -> ImportReport:
    """Imports a `.sh3f` file, or every mesh (and `.sh3f`) below a folder.

    Args:
        path: File or folder.
        library: Name of the library to add to; default the path's stem.
        limit: Stop after so many models.
        convex: Decompose concave meshes by CoACD (slow, exact) instead of boxes (fast).
        progress: Called with the count and name before each model.

    Returns:
        What went in, what was there, and what was wrong with the rest.

    Raises:
        UserError: If the path holds nothing to import or the library cannot be written.
    """
    path = Path(path)
    if not path.exists():
        raise UserError(f"{path} does not exist; give a .sh3f file or a folder of meshes")
    name = slug(library or path.stem) or "imported"
    folder = library_root() / name
    report = ImportReport(name, folder)
    try:
        (folder / "assets").mkdir(parents=True, exist_ok=True)
        (folder / "meshes").mkdir(exist_ok=True)
    except OSError as error:
        why = explained(error, folder).strerror
        raise UserError(f"cannot write the library {folder}: {why}") from None
    seen = 0
    with refused(folder), tempfile.TemporaryDirectory() as unpacked:
        for source in _sources(path, Path(unpacked)):
            if limit is not None and seen >= limit:
                break
            seen += 1
            if progress:
                progress(seen, source.name)
            _import_one(source, folder, report, convex)
    if not seen:
        raise UserError(f"{path}: found no .sh3f, .glb, .gltf, .obj, .stl or .ply to import")
    with refused(folder):
        write_index(folder)
    return report


def _sources(path: Path, unpacked: Path) -> Iterator[Source]:
    archives = [path] if path.is_file() else sorted(path.rglob("*.sh3f"))
    for k, archive in enumerate(archives):
        if archive.suffix.lower() != ".sh3f":
            raise UserError(f"{path}: expected a .sh3f file or a folder")
        target = unpacked / str(k)
        target.mkdir()
        yield from read_sh3f(archive, target)
    if path.is_dir():
        yield from read_folder(path)


def _source_hash(source: Source, convex: bool) -> str:
    digest = hashlib.sha256(f"{IMPORT_VERSION} {convex}".encode())
    meta = {k: v for k, v in source.__dict__.items() if k not in ("path", "root")}
    digest.update(json.dumps(meta, sort_keys=True, default=str).encode())
    digest.update(source.path.read_bytes())
    return digest.hexdigest()


def _import_one(source: Source, folder: Path, report: ImportReport, convex: bool) -> None:
    record = folder / "assets" / f"{source.key}.json"
    if not lies_in(source.path, source.home):
        report.problems.append((source.key, "its model file lies outside the library"))
        return
    try:
        key = _source_hash(source, convex)
        if _recorded_hash(record) == key:
            report.unchanged.append(source.key)
            return
        data, notes = convert(source, convex=convex, cache=folder / "convex")
        report.problems += [(source.key, f"warning: {n}") for n in notes]
        data["source_hash"] = key
        glb = data.pop("glb")
        mesh = folder / "meshes" / f"{data['mesh_sha256']}.glb"
        write_file(mesh, glb)
        write_file(record, json.dumps(data, indent=1).encode())
        report.imported.append(source.key)
    except FileNotFoundError:
        report.problems.append((source.key, f"model file {source.path.name} is missing"))
    except Exception as error:  # one broken model must not stop the rest
        if unwritable(error):
            raise
        report.problems.append((source.key, f"{type(error).__name__}: {error}"))


def _recorded_hash(record: Path) -> str:
    """Of what a record was made; empty if there is none, or a damaged one, which is made anew."""
    try:
        return str(read_record(record).get("source_hash")) if record.is_file() else ""
    except UserError:
        return ""


def write_file(path: Path, data: bytes) -> None:
    """Writes under a temporary name and renames, so that no reader sees half a file."""
    with atomic_file(path) as file:
        file.write(data)


_AXES = {"x": 0, "y": 1, "z": 2}


def frame(up: str, front: str) -> np.ndarray:
    """Rotation from a model's axes to the local frame (front +X, Z up), shape [3, 3]."""
    x, z = np.zeros(3), np.zeros(3)
    x[_AXES[front[1]]] = 1.0 if front[0] == "+" else -1.0
    z[_AXES[up]] = 1.0
    if abs(x @ z) > 0.5:
        raise ValueError(f"front {front} and up {up} are the same axis")
    return np.stack([x, np.cross(z, x), z])


def convert(
    source: Source, *, convex: bool = False, cache: Path | None = None
) -> tuple[dict[str, Any], list[str]]:
    """Loads, orients, scales and describes one model (`describe` says what the options mean).

    Returns:
        The record of the asset (with its GLB bytes under `glb`), and warnings.

    Raises:
        ValueError: If the model is unusable: no faces, not finite, an absurd size.
    """
    import trimesh

    from esg.assets.geometry.rotations import GLTF_FROM_LOCAL
    from esg.assets.imports.describe import describe

    notes = [f"texture {name} is missing" for name in missing_textures(source.path)]
    scene = _loaded(source)
    meshes = [m for m in scene.dump() if isinstance(m, trimesh.Trimesh) and len(m.faces)]
    if not meshes:
        raise ValueError("no triangles in the model")
    if not all(np.isfinite(m.vertices).all() for m in meshes):
        raise ValueError("vertices are not finite")
    matrix = np.eye(4)
    turn = np.reshape(source.rotation, (3, 3)) if source.rotation else np.eye(3)
    if not np.allclose(turn @ turn.T, np.eye(3), atol=_ROTATION_ERROR):
        raise ValueError(f"modelRotation {source.rotation} is no rotation")
    matrix[:3, :3] = frame(source.up, source.front) @ turn
    low, high = _bounds(meshes, matrix)
    extents = np.maximum(high - low, 1e-9)
    factor, dimensions = _scale(source, extents, notes)
    if not (_SANE_CM[0] <= dimensions.max() <= _SANE_CM[1]):
        raise ValueError(f"absurd size {np.round(dimensions, 2).tolist()} cm")
    matrix[:3] *= factor
    shift = -(low + high) / 2 * factor
    shift[2] = -low[2] * factor
    matrix[:3, 3] = shift
    meshes = [thinned(m, notes) for m in meshes]
    local = trimesh.Scene()
    for k, mesh in enumerate(meshes):
        mesh.apply_transform(matrix)
        _shrink_texture(mesh)
        local.add_geometry(mesh, node_name=f"part_{k:03d}", geom_name=f"part_{k:03d}")
    vertices = np.concatenate([m.vertices for m in meshes])
    offsets = np.cumsum([0] + [len(m.vertices) for m in meshes[:-1]])
    faces = np.concatenate([m.faces + o for m, o in zip(meshes, offsets, strict=True)])
    record = describe(
        source,
        np.asarray(vertices, float),
        np.asarray(faces, np.int64),
        dimensions,
        convex=convex,
        cache=cache,
    )
    local.apply_transform(GLTF_FROM_LOCAL)
    glb: Any = local.export(file_type="glb")
    record["mesh_sha256"] = hashlib.sha256(glb).hexdigest()
    record["glb"] = glb
    return record, notes


def _loaded(source: Source) -> Any:
    """A model file as a scene of meshes; what it names is read only from its library.

    Raises:
        ValueError: If it is too large, or declares what it does not hold.
    """
    import trimesh
    from trimesh import resolvers

    size = source.path.stat().st_size
    if size > gltf.MOST_BYTES:
        raise ValueError(f"it has {size} bytes, at most {gltf.MOST_BYTES} are read")

    class Inside(resolvers.FilePathResolver):  # type: ignore[reportUntypedBaseClass]  # no stubs
        """Reads what a model names, unless that lies outside its library."""

        def get(self, name: str) -> bytes:
            path = source.path.parent / name.strip()
            if not lies_in(path, source.home):
                raise ValueError(f"it names a file outside its library: {name.strip()[:80]!r}")
            return super().get(name)

    resolver = Inside(str(source.path))
    suffix = source.path.suffix.lower()
    if suffix == ".glb":
        gltf.read_glb(source.path.read_bytes())
    elif suffix == ".gltf":
        gltf.check(gltf.parsed(source.path.read_bytes()), b"", resolver.get)
    return trimesh.load_scene(source.path, process=False, resolver=resolver)


def missing_textures(path: Path) -> list[str]:
    """Material files and textures that a Wavefront model names and that are not there."""
    if path.suffix.lower() != ".obj":
        return []

    def named(file: Path, keyword: str) -> list[str]:
        lines = file.read_text(encoding="utf-8", errors="replace").splitlines()
        words = [line.split(None, 1) for line in lines]
        return [w[1].strip() for w in words if len(w) == 2 and w[0].lower() == keyword]

    missing: list[str] = []
    for library in named(path, "mtllib"):
        file = path.parent / library
        if not file.is_file():
            missing.append(library)
            continue
        for texture in named(file, "map_kd"):
            # Options may precede the name ("-s 2 2 1 wood.jpg").
            name = texture.split()[-1].replace("\\", "/")
            if not (file.parent / texture).is_file() and not (file.parent / name).is_file():
                missing.append(name)
    return sorted(set(missing))


def _bounds(meshes: list[Any], matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    points = np.concatenate([np.asarray(m.vertices) @ matrix[:3, :3].T for m in meshes])
    return points.min(0), points.max(0)


def _scale(source: Source, extents: np.ndarray, notes: list[str]) -> tuple[float, np.ndarray]:
    """Factor from model units to cm, and the extents it gives."""
    if source.dimensions_cm is not None:
        ratios = np.array(source.dimensions_cm) / extents
        factor = float(np.exp(np.log(ratios).mean()))
        if ratios.max() / ratios.min() > 1.15:
            notes.append("the catalogue's proportions differ from the model's; scaled uniformly")
            factor = float(np.median(ratios))
        return factor, extents * factor
    if source.unit_cm is not None:
        return source.unit_cm, extents * source.unit_cm
    from esg.assets.imports.describe import usual_dimensions

    usual = usual_dimensions(source)
    if usual is None:
        notes.append("no size given; took the model's unit for metres")
        return 100.0, extents * 100.0
    errors = {
        unit: abs(float(np.log(np.sort(extents * unit) / np.sort(usual)).mean()))
        for unit in (0.1, 1.0, 2.54, 100.0)
    }
    unit = min(errors, key=lambda u: (errors[u], u))
    notes.append(f"no size given; guessed a unit of {unit:g} cm from its kind")
    return unit, extents * unit


def thinned(mesh: Any, notes: list[str]) -> Any:
    """Clusters the vertices of a heavy mesh on a grid until it is light enough."""
    if len(mesh.faces) <= MAX_FACES:
        return mesh
    before = len(mesh.faces)
    cells = 160
    while len(mesh.faces) > MAX_FACES and cells > 20:
        v = np.asarray(mesh.vertices)
        step = np.ptp(v, axis=0).max() / cells
        _, first, inverse = np.unique(
            np.floor((v - v.min(0)) / step).astype(np.int64), axis=0, return_index=True,
            return_inverse=True,
        )  # fmt: skip
        faces = first[inverse.reshape(-1)][mesh.faces]
        keep = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2])
        keep &= faces[:, 0] != faces[:, 2]
        mesh.update_faces(np.ones(len(mesh.faces), bool))
        mesh.faces = faces
        mesh.update_faces(keep)
        mesh.remove_unreferenced_vertices()
        cells = int(cells * 0.75)
    notes.append(f"thinned from {before} to {len(mesh.faces)} triangles")
    return mesh


def _shrink_texture(mesh: Any) -> None:
    material = getattr(mesh.visual, "material", None)
    for name in ("image", "baseColorTexture"):
        image = getattr(material, name, None)
        if image is not None and max(image.size) > MAX_TEXTURE:
            ratio = MAX_TEXTURE / max(image.size)
            size = (max(1, round(image.width * ratio)), max(1, round(image.height * ratio)))
            setattr(material, name, image.resize(size))
