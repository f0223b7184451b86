"""Seeded, tileable textures, drawn by our own generators (docs/assets/materials.md)."""

from __future__ import annotations

from functools import cache, lru_cache
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple
import zlib

import numpy as np
from numpy.typing import NDArray

from esg.machine.kept import kept, version_of

if TYPE_CHECKING:
    from esg.assets.textures.recipe import Recipe

Color = tuple[float, float, float]
FULL = 512
"""Pixels along each side at which textures are drawn; smaller ones are these, reduced."""


KEPT = "textures"
"""Folder of the cache."""


class Maps(NamedTuple):
    """The maps of a surface; rows from top to bottom, continued across their borders.

    Args:
        base_color: sRGB, shape [n, n, 3].
        normal: In tangent space, +X right and +Y up the picture, shape [n, n, 3].
        roughness: 255 leaves the material's as it is, shape [n, n].
    """

    base_color: NDArray[np.uint8]
    normal: NDArray[np.uint8]
    roughness: NDArray[np.uint8]


def recipes() -> dict[str, Recipe]:
    """Every set of maps by name."""
    from esg.assets.textures.drawers import RECIPES

    return RECIPES


def linear(srgb: NDArray[np.floating] | Color) -> NDArray[np.float64]:
    """Linear light of sRGB values in [0, 1]."""
    c = np.asarray(srgb, float)
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def srgb(light: NDArray[np.floating]) -> NDArray[np.float64]:
    """sRGB values in [0, 1] of linear light."""
    c = np.clip(light, 0.0, 1.0)
    return np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


def tint(name: str | None, color: Color) -> Color:
    """What a texture is multiplied with (in linear light) to be of a colour on average [sRGB].

    A channel that is brighter than the texture's is left as it is.
    """
    if name is None:
        return color
    factor = np.minimum(1.0, linear(color) / linear(recipes()[name].mean))
    red, green, blue = (round(float(c), 4) for c in srgb(factor))
    return red, green, blue


def has_grain(name: str | None) -> bool:
    """Whether a texture has a grain along u, which runs along the length of a part."""
    return name is not None and recipes()[name].along


@cache
def maps(name: str, size: int = FULL) -> Maps:
    """The maps of a texture; the same bytes in every process.

    Args:
        name: One of `recipes()`.
        size: Pixels along each side: a power of two up to 512.
    """
    data = kept(KEPT, version(), f"{name}-{size}", lambda: _packed(drawn(name, size)))
    pixels = np.frombuffer(data, np.uint8)
    edges = np.cumsum([3, 3]) * size * size
    color, normal, roughness = np.split(pixels, edges)
    shape = size, size
    return Maps(color.reshape(*shape, 3), normal.reshape(*shape, 3), roughness.reshape(shape))


def _packed(found: Maps) -> bytes:
    return b"".join(array.tobytes() for array in found)


@cache
def version() -> str:
    """Of what maps depend on besides their names."""
    return version_of(Path(__file__).parent, np.__version__, metadata.version("scipy"))


@lru_cache(maxsize=4)
def drawn(name: str, size: int = FULL) -> Maps:
    """The maps of a texture, drawn in this process; `maps` has them from the cache.

    A few are kept: halves are made of them at once. All sixty were 48 MB.

    Args:
        name: One of `recipes()`.
        size: Pixels along each side: a power of two up to 512.
    """
    if size < FULL:
        return _halved(drawn(name, 2 * size))
    from esg.assets.textures.noise import normals

    recipe = recipes()[name]
    relief = recipe.draw(size, np.random.default_rng(zlib.crc32(name.encode())))
    color = np.asarray(relief.color, float)
    if color.ndim == 2:
        color = np.repeat(color[..., None], 3, axis=2)
    mean = linear(recipe.mean)
    for _ in range(4):  # what is cut off at white is made up for elsewhere
        color = np.clip(color * (mean / color.mean((0, 1))), 0.0, 1.0)
    slopes = normals(relief.height, recipe.depth)
    rough = np.broadcast_to(np.asarray(relief.roughness, float), (size, size))
    return Maps(_bytes(srgb(color)), _bytes(0.5 + 0.5 * slopes), _bytes(rough))


def _bytes(values: NDArray[np.floating]) -> NDArray[np.uint8]:
    out = np.clip(np.rint(values * 255.0), 0, 255).astype(np.uint8)
    out.setflags(write=False)
    return out


def _halved(full: Maps) -> Maps:
    def mean(a: NDArray[np.float64]) -> NDArray[np.float64]:
        return 0.25 * (a[::2, ::2] + a[1::2, ::2] + a[::2, 1::2] + a[1::2, 1::2])

    slopes = mean(full.normal / 127.5 - 1.0)
    slopes /= np.maximum(np.linalg.norm(slopes, axis=-1, keepdims=True), 1e-9)
    return Maps(
        _bytes(srgb(mean(linear(full.base_color / 255.0)))),
        _bytes(0.5 + 0.5 * slopes),
        _bytes(mean(full.roughness / 255.0)),
    )
