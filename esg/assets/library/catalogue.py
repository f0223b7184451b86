"""The catalogue of the embedded parametric library and the geometry of its entries."""

from __future__ import annotations

import csv
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
import re
from typing import Any

from esg.assets.appearance import USUAL, Appearance
from esg.assets.colors import find_color
from esg.assets.geometry.filling import pour
from esg.assets.geometry.sketch import Sketch
from esg.assets.geometry.stretch import scaled, sound, stretched
from esg.assets.materials import MATERIALS
from esg.graph.models import Contents, NamedRegion, Vec3
from esg.lexicon import Kind, kinds, singular
from esg.lexicon.contents import contents


@dataclass(frozen=True)
class Entry:
    """One kind of object in a library.

    Args:
        name: Canonical singular noun with underscores; unique in its library.
        parents: Chain of broader categories, nearest first.
        builder: Parametric builder; empty for imported meshes.
        params: Arguments of the builder; `like` names the entry at whose size a builder that
            keeps its proportions draws before the whole is scaled (a foal is drawn as a horse).
        dimensions_cm: Usual (length along +X, width, height).
        mass_kg: Usual mass.
        material: Key of the material table.
        color_rgb: Usual main colour.
        flags: rolls, wheeled, fixed, decal, container, any_size (comes in all sizes).
        synonyms: Other names.
        description: One line for retrieval.
        reference: Source of dimensions and mass.
        library: "parametric" or the name of an imported library.
        mesh_file: Path of an imported mesh, relative to its library.
        contents: What one of them is filled with, and where that is.
        license: Of an imported mesh.
        attribution: Creator and source of an imported mesh.
    """

    name: str
    parents: tuple[str, ...]
    builder: str
    params: tuple[tuple[str, Any], ...]
    dimensions_cm: Vec3
    mass_kg: float
    material: str
    color_rgb: tuple[float, float, float]
    flags: frozenset[str]
    synonyms: tuple[str, ...]
    description: str
    reference: str = ""
    library: str = "parametric"
    mesh_file: str = ""
    contents: tuple[NamedRegion, Contents] | None = None
    license: str = "Apache-2.0"
    attribution: str = ""

    @property
    def movable(self) -> bool:
        return not self.flags & {"fixed", "decal"}

    @property
    def finish(self) -> str:
        """Material that parts in its main colour are seen as, where their builder names none."""
        return finishes().get(self.name, self.material)

    @property
    def text(self) -> str:
        """What the embedder reads."""
        name = self.name.replace("_", " ")
        return (
            f"{name}, {', '.join(self.synonyms[:4])}: {self.description}"
            if self.synonyms
            else f"{name}: {self.description}"
        )


@cache
def finishes() -> dict[str, str]:
    """What kinds are seen as where that is not the material they slide as, by name."""
    with (Path(__file__).parent / "finishes.csv").open(encoding="utf-8", newline="") as file:
        return {row["kind"]: row["material"] for row in csv.DictReader(file)}


def parse_hex(text: str) -> tuple[float, float, float]:
    """Colour from "#rrggbb"."""
    r, g, b = (int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return (r, g, b)


def _value(text: str) -> Any:
    return {"": False, "1": True}.get(text, text)


@lru_cache(maxsize=1)
def catalogue() -> tuple[Entry, ...]:
    """Every entry of the embedded library, in the order of the table of kinds."""
    return tuple(_entry(kind) for kind in kinds() if kind.builder and "part" not in kind.flags)


@lru_cache(maxsize=1)
def parts() -> dict[str, Entry]:
    """Parts of jointed things by canonical name: nobody finds them, a document asks for them."""
    found = [_entry(kind) for kind in kinds() if kind.builder and "part" in kind.flags]
    return {entry.name: entry for entry in found}


def _entry(kind: Kind) -> Entry:
    return Entry(
        name=kind.slug,
        parents=kind.parents,
        builder=kind.builder,
        params=tuple((k, _value(v)) for k, v in (p.split("=") for p in kind.params)),
        dimensions_cm=kind.local_cm,
        mass_kg=kind.local_kg,
        material=kind.surface,
        color_rgb=parse_hex(kind.color),
        flags=kind.flags,
        synonyms=kind.found_as,
        description=kind.description,
        reference=kind.reference,
    )


@lru_cache(maxsize=1)
def entries_by_name() -> dict[str, Entry]:
    """The embedded library and its parts of jointed things by canonical name."""
    return {e.name: e for e in catalogue()} | parts()


def normalize(text: str) -> str:
    """Lower case, single spaces, no underscores or hyphens, last word singular."""
    words = re.sub(r"[^a-z0-9]+", " ", text.lower()).split()
    while words and words[0] in {"a", "an", "the", "some", "one", "of", "set", "pair"}:
        words = words[1:]
    if words:
        words[-1] = singular(words[-1])
    return " ".join(words)


@lru_cache(maxsize=1)
def lexicon() -> dict[str, str]:
    """Normalized names and synonyms to canonical names; names win over synonyms."""
    table: dict[str, str] = {}
    for entry in catalogue():
        for synonym in entry.synonyms:
            table.setdefault(normalize(synonym), entry.name)
    for entry in catalogue():
        table[normalize(entry.name)] = entry.name
    return table


def build_sketch(
    entry: Entry,
    dimensions_cm: Vec3,
    color: tuple[float, float, float],
    appearance: Appearance = USUAL,
) -> Sketch:
    """Draws an entry of the parametric library at the given extents.

    Builders that keep their proportions are drawn at the usual size and scaled by the height ratio
    if extents are proportional, else by the cube root of the volume ratio.
    """
    from esg.assets.builders import load_builders

    load_builders()
    sketch = _built(entry, dimensions_cm, appearance.color or color, appearance)
    if entry.contents is not None:
        level, told = entry.contents
        row = contents()[told.name]
        pour(sketch, level, row, find_color(told.color) or row.color)
    return sketch


def _built(
    entry: Entry,
    dimensions_cm: Vec3,
    color: tuple[float, float, float],
    appearance: Appearance,
) -> Sketch:
    from esg.assets.builders import BUILDERS, DRAWN

    sketch = Sketch(material=appearance.material or entry.finish, appearance=appearance)
    if policy(entry) == "free":
        return worn(_free(entry, dimensions_cm, color, appearance), appearance)
    params = dict(entry.params)
    size = entries_by_name()[params.pop("like")].dimensions_cm if "like" in params else None
    size = size or entry.dimensions_cm
    BUILDERS[entry.builder](sketch, *size, color, **params)
    drawn = DRAWN.get(entry.builder, size)
    return worn(scaled(sketch, uniform_factor(drawn, dimensions_cm)), appearance)


def _free(
    entry: Entry,
    dimensions_cm: Vec3,
    color: tuple[float, float, float],
    appearance: Appearance,
) -> Sketch:
    """At any extents: built there, else at the usual volume and scaled, else stretched."""
    from esg.assets.builders import BUILDERS

    usual = entry.dimensions_cm
    factor = uniform_factor(usual, dimensions_cm)
    middling: Vec3 = tuple(d / factor for d in dimensions_cm)  # type: ignore[assignment]
    for size in (dimensions_cm, middling):
        sketch = Sketch(material=appearance.material or entry.finish, appearance=appearance)
        try:
            BUILDERS[entry.builder](sketch, *size, color, **dict(entry.params))
            if sound(sketch):
                return sketch if size is dimensions_cm else scaled(sketch, factor)
        except (ArithmeticError, ValueError):
            continue
    sketch = Sketch(material=appearance.material or entry.finish, appearance=appearance)
    BUILDERS[entry.builder](sketch, *usual, color, **dict(entry.params))
    l, w, h = (b / a for a, b in zip(usual, dimensions_cm, strict=True))  # noqa: E741
    return stretched(sketch, (l, w, h))


def worn(sketch: Sketch, appearance: Appearance) -> Sketch:
    """The sketch as it looks after some use: a little duller and darker, or as good as new."""
    if appearance.seed is None:
        return sketch
    wear = appearance.share("wear")
    tone, rough = 1.04 - 0.1 * wear, 0.9 + 0.4 * wear
    for k, part in enumerate(sketch.parts):
        red, green, blue = (min(1.0, tone * v) for v in part.color)
        own = MATERIALS[part.material].roughness if part.roughness is None else part.roughness
        sketch.parts[k] = replace(
            part, color=(red, green, blue), roughness=min(1.0, round(rough * own, 3))
        )
    return sketch


def uniform_factor(usual: Vec3, wanted: Vec3) -> float:
    """Cube root of the volume ratio."""
    ratio = 1.0
    for a, b in zip(usual, wanted, strict=True):
        ratio *= b / a
    return ratio ** (1.0 / 3.0)


def policy(entry: Entry) -> str:
    """`free` if the entry can be built at any extents, else `uniform`."""
    from esg.assets.builders import POLICIES, load_builders

    load_builders()
    if any(key == "like" for key, _ in entry.params):
        return "uniform"  # drawn at the size of another entry, then scaled as a whole
    return POLICIES.get(entry.builder, "uniform")
