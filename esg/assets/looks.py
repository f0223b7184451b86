"""How a surface looks: one record, from the builder that paints it to every renderer and export."""

from __future__ import annotations

from dataclasses import dataclass

Color = tuple[float, float, float]


@dataclass(frozen=True)
class Look:
    """A surface in the metallic-roughness model of glTF 2.0.

    Args:
        material: Name of its row in the table of materials; "" if it has none.
        color: sRGB in [0, 1], which the texture's colour is multiplied with, in linear light.
        roughness, metalness: In [0, 1], which those of the texture are multiplied with.
        alpha: 1 is opaque.
        texture: Name of a set of seeded maps; None for a plain surface.
        tile_m: Edge of one tile of the texture [m]; texture coordinates count tiles.
        normal_strength: What the slopes of its normal map are multiplied with.
        glow: Light of its colour that it gives itself; 1 is white paper in daylight.
    """

    material: str
    color: Color
    roughness: float = 0.6
    metalness: float = 0.0
    alpha: float = 1.0
    texture: str | None = None
    tile_m: float = 1.0
    normal_strength: float = 1.0
    glow: float = 0.0
