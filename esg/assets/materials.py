"""Materials: how a surface slides, bounces and weighs, and how it looks, in one row of a table.

Friction, restitution and density have their source in the row. Pairs combine by average, so a value
is a property of one surface against an ordinary partner. Ball restitutions follow the rebound rules
of their sports, e = sqrt(h_rebound / h_drop). Roughness and metalness are those of glTF 2.0.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

from esg.assets.looks import Color, Look

TABLE = Path(__file__).parent / "materials.csv"
_OWN = 0.22
"""Distance (sRGB, largest channel) up to which a colour is that of the bare material."""


@dataclass(frozen=True)
class Material:
    """One surface and substance.

    Args:
        name: Key.
        density: Of the substance [kg/m^3].
        friction: Coefficient of dry friction.
        restitution: Coefficient of restitution.
        color: sRGB in [0, 1] it usually has.
        roughness, metalness: In [0, 1].
        alpha: 1 is opaque.
        texture: Name of a set of seeded maps (`esg.assets.textures`); None for a plain surface.
        tile_m: Edge of one tile of the texture [m].
        normal_strength: What the slopes of the normal map are multiplied with.
        coat: What it is covered with where it is of a colour not its own; None if it is dyed.
        words: What prompts call it; no other material has them.
        stands_for: Plain materials that this composite already stands for.
        source: Where the figures come from.
    """

    name: str
    density: float
    friction: float
    restitution: float
    color: Color
    roughness: float
    metalness: float
    alpha: float
    texture: str | None
    tile_m: float
    normal_strength: float
    coat: str | None
    words: tuple[str, ...]
    stands_for: frozenset[str]
    source: str


def _material(row: dict[str, str]) -> Material:
    red, green, blue = bytes.fromhex(row["color"][1:])
    return Material(
        name=row["name"],
        density=float(row["density"]),
        friction=float(row["friction"]),
        restitution=float(row["restitution"]),
        color=(red / 255.0, green / 255.0, blue / 255.0),
        roughness=float(row["roughness"]),
        metalness=float(row["metalness"]),
        alpha=float(row["alpha"]),
        texture=row["texture"] or None,
        tile_m=float(row["tile_m"] or 1.0),
        normal_strength=float(row["normal_strength"] or 1.0),
        coat=row["coat"] or None,
        words=tuple(w for w in row["words"].split(";") if w),
        stands_for=frozenset(w for w in row["stands_for"].split(";") if w),
        source=row["source"],
    )


def _read() -> dict[str, Material]:
    with TABLE.open(encoding="utf-8", newline="") as file:
        return {row["name"]: _material(row) for row in csv.DictReader(file)}


MATERIALS = _read()
_NAMED = {word: material for material in MATERIALS.values() for word in material.words}


def is_usual(asked: Material, own: str) -> bool:
    """Whether a request for `asked` only repeats what an entry of material `own` is made of."""
    return asked.name == own or asked.name in MATERIALS[own].stands_for


def find_material(text: str | None) -> Material | None:
    """The material that a word or phrase names ("wooden", "stainless steel"), or None."""
    if not text:
        return None
    words = text.lower().replace("_", " ").replace("-", " ").strip()
    for key in (words, *reversed(words.split())):
        if key in _NAMED:
            return _NAMED[key]
    return None


def visible(name: str, color: Color | None) -> Material:
    """The row whose look a surface of a material and a colour has: red steel is painted."""
    material = MATERIALS[name]
    if color is None or material.coat is None:
        return material
    off = max(abs(a - b) for a, b in zip(color, material.color, strict=True))
    return MATERIALS[material.coat] if off > _OWN else material


def look_of(
    name: str,
    color: Color | None = None,
    *,
    roughness: float | None = None,
    alpha: float | None = None,
) -> Look:
    """How a surface looks.

    The colour of its texture is divided out, so that the surface has the wanted colour on average.

    Args:
        name: Of its material.
        color: sRGB in [0, 1]; the material's own by default.
        roughness, alpha: In [0, 1]; the material's own by default.
    """
    from esg.assets.textures import tint

    material = visible(name, color)
    rough = material.roughness if roughness is None else roughness
    shown = material.color if color is None else (color[0], color[1], color[2])
    return Look(
        material=material.name,
        color=tint(material.texture, shown),
        roughness=rough,
        metalness=material.metalness,
        alpha=material.alpha if alpha is None else alpha,
        texture=material.texture,
        tile_m=material.tile_m,
        normal_strength=material.normal_strength,
    )
