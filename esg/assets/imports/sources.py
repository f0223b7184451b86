"""What can be imported: Sweet Home 3D libraries and folders of meshes with a catalogue."""

from __future__ import annotations

from collections.abc import Iterator
import csv
from dataclasses import dataclass, replace
import json
import math
from pathlib import Path, PurePosixPath
import re
from typing import Any
import zipfile
import zlib

from esg.files import read_limited
from esg.outcomes import UserError
from esg.strangers.arrays import check_archive

MOST_UNPACKED_BYTES = 8 * 2**30
MESH_SUFFIXES = (".glb", ".gltf", ".obj", ".stl", ".ply")
CATALOGUE_FILES = ("catalogue.csv", "catalog.csv", "catalogue.json", "catalog.json")
MAX_CATALOGUE = 64 * 2**20
"""Bytes of a catalogue."""
_NUMBER_FIELDS = ("length_cm", "width_cm", "height_cm", "mass_kg")
_TEXT_FIELDS = (
    "file", "name", "category", "tags", "description", "material", "license", "creator", "source",
    "up", "front", "unit",
)  # fmt: skip
_UNITS_CM = {"mm": 0.1, "cm": 1.0, "m": 100.0, "in": 2.54}


@dataclass(frozen=True)
class Source:
    """One model to import.

    Args:
        key: Stable id inside its library.
        name: Human name, English.
        path: Model file on disk.
        dimensions_cm: (length along its front, width, height), None if unknown.
        tags: Further words for retrieval.
        category: The source's own category.
        description: One line.
        mass_kg: None if unknown.
        material: Word for the material table.
        license: Licence text or identifier.
        creator: Author.
        origin: Where it was published.
        up: Model axis that points up: y or z.
        front: Model axis that its front faces: +x, -x, +y, -y, +z, -z.
        unit_cm: Size of the model's unit; None guesses.
        rotation: Extra rotation of the model, shape [3, 3], row-major, or empty.
        root: Folder of its library; default the file's own.
    """

    key: str
    name: str
    path: Path
    dimensions_cm: tuple[float, float, float] | None = None
    tags: tuple[str, ...] = ()
    category: str = ""
    description: str = ""
    mass_kg: float | None = None
    material: str = ""
    license: str = ""
    creator: str = ""
    origin: str = ""
    up: str = "y"
    front: str = "+z"
    unit_cm: float | None = None
    rotation: tuple[float, ...] = ()
    root: Path | None = None

    @property
    def home(self) -> Path:
        """The folder that nothing of the model may lie outside of."""
        return self.root or self.path.parent


def slug(text: str) -> str:
    """Lower-case words joined by underscores."""
    return "_".join(re.findall(r"[a-z0-9]+", text.lower()))


def parse_properties(text: str) -> dict[str, str]:
    """Java properties: continuation lines, comments, unicode escapes."""
    table: dict[str, str] = {}
    for line in re.sub(r"\\\r?\n[ \t]*", "", text).splitlines():
        line = line.strip()
        if not line or line[0] in "#!":
            continue
        match = re.match(r"((?:\\.|[^\\=:])+?)\s*[=:]\s*(.*)", line)
        if match:
            value = re.sub(r"\\u([0-9a-fA-F]{4})", lambda m: chr(int(m[1], 16)), match[2])
            table[match[1].strip()] = re.sub(r"\\(.)", r"\1", value)
    return table


def read_sh3f(archive: Path, unpack_to: Path) -> Iterator[Source]:
    """Models of a Sweet Home 3D library (`.sh3f`), unpacked on the way.

    Its models are Y-up with fronts towards +Z; the catalogue gives width, depth and height in cm.

    Raises:
        UserError: If the file is not such a library, or unpacks to more than MOST_UNPACKED_BYTES.
    """
    try:
        with zipfile.ZipFile(archive) as bundle:
            check_archive(bundle, MOST_UNPACKED_BYTES)
            names = set(bundle.namelist())
            listing = next((n for n in names if n.endswith("FurnitureCatalog.properties")), None)
            if listing is None:
                raise UserError(
                    f"{archive}: no *FurnitureCatalog.properties inside; is it a .sh3f?"
                )
            for name in names:
                target = (unpack_to / name).resolve()
                if target.is_relative_to(unpack_to.resolve()):
                    bundle.extract(name, unpack_to)
            table = parse_properties(bundle.read(listing).decode("latin-1"))
    except (zipfile.BadZipFile, OSError, EOFError, RuntimeError, ValueError, zlib.error) as error:
        # A damaged archive, an encrypted one, an unknown compression, names that are none.
        raise UserError(f"{archive}: cannot be read as a .sh3f library ({error})") from None
    numbers = sorted(int(k.split("#")[1]) for k in table if re.fullmatch(r"name#\d{1,9}", k))
    for i in numbers:

        def get(field: str, i: int = i) -> str:
            return table.get(f"{field}#{i}", "")

        size = [_number(get(f)) for f in ("depth", "width", "height")]
        yield Source(
            key=f"{slug(archive.stem)}_{slug(get('id').split('#')[-1] or get('name'))}",
            name=get("name"),
            path=unpack_to / PurePosixPath(get("model").lstrip("/")),
            root=unpack_to,
            dimensions_cm=None if None in size else tuple(size),  # type: ignore[arg-type]
            tags=tuple(t.strip() for t in get("tags").split(",") if t.strip()),
            category=get("category"),
            license=get("license") or table.get("license", ""),
            creator=get("creator") or table.get("provider", ""),
            origin=f"Sweet Home 3D, {table.get('name', archive.stem)}",
            rotation=_rotation(get("modelRotation")),
        )


def _number(text: Any) -> float | None:
    try:
        value = float(text)
    except (TypeError, ValueError, OverflowError):
        return None
    return value if 0 < value < math.inf else None


def _rotation(text: str) -> tuple[float, ...]:
    """Nine numbers, or none; what cannot be read is a matrix of NaN, which turns no model."""
    try:
        values = tuple(float(v) for v in text.split())
    except ValueError:
        return (math.nan,) * 9
    return values if len(values) in (0, 9) else (math.nan,) * 9


def read_folder(folder: Path) -> Iterator[Source]:
    """Every mesh below a folder, described by its catalogue where there is one.

    Raises:
        UserError: For a malformed catalogue, with all its faults at once.
    """
    listing = next((folder / n for n in CATALOGUE_FILES if (folder / n).is_file()), None)
    rows = {r["file"]: r for r in _read_catalogue(listing)} if listing else {}
    files = sorted(p for p in folder.rglob("*") if p.suffix.lower() in MESH_SUFFIXES)
    for path in files:
        inside = path.relative_to(folder)
        row = rows.get(inside.as_posix()) or rows.get(path.name) or {}
        yield replace(_described(path, inside, row), root=folder)


def _described(path: Path, inside: Path, row: dict[str, Any]) -> Source:
    """A mesh at a path inside its folder, with its row of the catalogue (empty without one)."""

    def word(column: str, otherwise: str = "") -> str:
        return row.get(column) or otherwise

    size = [_number(row.get(f)) for f in ("length_cm", "width_cm", "height_cm")]
    suffix = path.suffix.lower()
    up, front = ("z", "+x") if suffix in (".stl", ".ply") else ("y", "+z")
    guessed_cm = 100.0 if suffix in (".glb", ".gltf") else None
    return Source(
        key=slug(inside.with_suffix("").as_posix()),
        name=word("name", re.sub(r"[_\-\d]+", " ", path.stem).strip() or path.stem),
        path=path,
        dimensions_cm=None if None in size else tuple(size),  # type: ignore[arg-type]
        tags=tuple(t.strip() for t in str(word("tags")).split(";") if t.strip()),
        category=word("category"),
        description=word("description"),
        mass_kg=_number(row.get("mass_kg")),
        material=word("material"),
        license=word("license"),
        creator=word("creator"),
        origin=word("source"),
        up=word("up", up),
        front=word("front", front),
        unit_cm=_UNITS_CM.get(str(word("unit")), guessed_cm),
    )


def _read_catalogue(path: Path) -> list[dict[str, Any]]:
    rows = _parsed(path)
    if isinstance(rows, dict):
        rows = rows.get("assets", [])
    if not isinstance(rows, list) or not all(isinstance(r, dict) for r in rows):
        raise UserError(f'{path}: expected a list of objects (or {{"assets": [...]}})')
    faults = [f"row {n + 1}: {fault}" for n, row in enumerate(rows) for fault in _faults(row)]
    if faults:
        raise UserError(f"{path}: " + "; ".join(faults[:20]))
    return rows


def _parsed(path: Path) -> Any:
    """The rows of a catalogue, unchecked."""
    try:
        text = read_limited(path, MAX_CATALOGUE).decode("utf-8-sig")
        if path.suffix == ".json":
            return json.loads(text)
        return list(csv.DictReader(text.splitlines()))
    except json.JSONDecodeError as error:
        raise UserError(f"{path}: not JSON, line {error.lineno}: {error.msg}") from None
    except UnicodeDecodeError:
        raise UserError(f"{path}: not UTF-8 text; save it as UTF-8") from None
    except OSError as error:
        raise UserError(f"{path} cannot be read: {error.strerror}") from None
    except (csv.Error, ValueError, RecursionError) as error:
        raise UserError(f"{path}: cannot be read ({error}); correct it") from None


def _faults(row: dict[str, Any]) -> Iterator[str]:
    """What is wrong with a row of a catalogue."""
    if not row.get("file"):
        yield "no `file`"
    for name in _TEXT_FIELDS:
        if row.get(name) is not None and not isinstance(row[name], str):
            yield f"{name} is {row[name]!r:.60}, expected a text"
    if unknown := set(row) - set(_NUMBER_FIELDS) - set(_TEXT_FIELDS):
        yield f"unknown columns {sorted(map(str, unknown))}"
    for name in _NUMBER_FIELDS:
        if row.get(name) not in (None, "") and _number(row[name]) is None:
            given = f"{row[name]!r:.60}"
            yield f"{name} is {given}, expected a positive number"
    if (row.get("up") or "y") not in ("y", "z"):
        yield f"up is {row['up']!r:.60}, expected y or z"
    if not re.fullmatch(r"[+-][xyz]", str(row.get("front") or "+z")):
        yield f"front is {row['front']!r:.60}, expected e.g. +z"
