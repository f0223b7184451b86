"""How a surface is written into a file of another program: factors and encoded pictures.

Looks name seeded maps; files hold pictures. Every map is encoded once a process, and the same bytes
stand for it in every file, so that whoever merges files can tell that two pictures are one.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cache, cached_property
import hashlib
from importlib import metadata
import io
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color, Look
from esg.assets.textures import KEPT, linear, maps, srgb, version
from esg.machine.kept import kept, version_of

PICTURE_PX = 256
"""Edge of a picture in an exported file."""
QUALITY = {"color": 86, "normal": 90, "rough": 80}
"""Of JPEG, by what a picture shows."""
_SIGNATURES = {b"\x89PNG\r\n\x1a\n": "png", b"\xff\xd8\xff": "jpg"}


@dataclass(frozen=True)
class Picture:
    """An encoded picture.

    Args:
        data: Bytes of a PNG or JPEG file.
        name: What it shows.
    """

    data: bytes
    name: str = field(default="", compare=False)

    @property
    def suffix(self) -> str:
        """`png` or `jpg`; empty for what is neither."""
        return next((s for sign, s in _SIGNATURES.items() if self.data.startswith(sign)), "")

    @cached_property
    def sha256(self) -> str:
        """Of the content, as hexadecimal digits."""
        return hashlib.sha256(self.data).hexdigest()

    @property
    def digest(self) -> str:
        """Of the content, short enough for a file's name."""
        return self.sha256[:12]


@dataclass(frozen=True)
class Surface:
    """A surface in the metallic-roughness model of glTF 2.0, whose pictures the factors multiply.

    Args:
        name: Of the material.
        color: Linear RGB.
        roughness, metalness, alpha: In [0, 1].
        base: Base colour, sRGB.
        normal: Normals in tangent space, +Y up.
        normal_scale: What their slopes are multiplied with.
        rough_metal: Roughness in its green channel, metalness in its blue one, linear.
        glow: Light of its colour that it gives itself; 1 is white paper in daylight.
        two_sided: Whether both sides of a face are seen.
        average: sRGB of the surface on average, pictures included; None if nobody told.
    """

    name: str = ""
    color: Color = (0.6, 0.6, 0.6)
    roughness: float = 1.0
    metalness: float = 0.0
    alpha: float = 1.0
    base: Picture | None = None
    normal: Picture | None = None
    normal_scale: float = 1.0
    rough_metal: Picture | None = None
    glow: float = 0.0
    two_sided: bool = False
    average: Color | None = None

    @property
    def shown(self) -> Color:
        """Its colour on average as a screen shows it: sRGB in [0, 1]."""
        if self.average is not None:
            return self.average
        red, green, blue = (float(v) for v in srgb(np.array(self.color)))
        return red, green, blue


def surface_of(look: Look, average: Color | None = None) -> Surface:
    """What a look is in a file.

    Args:
        look: The look.
        average: sRGB of the surface on average, if it is known.
    """
    red, green, blue = (float(v) for v in linear(look.color))
    base, normal, rough_metal = _pictures(look.texture) if look.texture else (None, None, None)
    return Surface(
        name=_name(look),
        color=(red, green, blue),
        roughness=look.roughness,
        metalness=look.metalness,
        alpha=look.alpha,
        base=base,
        normal=normal,
        normal_scale=look.normal_strength,
        glow=look.glow,
        rough_metal=rough_metal,
        average=average,
    )


def _name(look: Look) -> str:
    """Of its material; one that is coloured has its colour in it."""
    color = "".join(f"{round(255 * c):02x}" for c in look.color)
    material = look.material or "plain"
    return material if color == "ffffff" else f"{material}_{color}"


@cache
def _pictures(texture: str) -> tuple[Picture, Picture, Picture | None]:
    """Pictures of a set of maps: colour, normals, and roughness unless it is the same all over."""
    color, normal, rough = (_kept_picture(texture, shows) for shows in QUALITY)
    assert color is not None and normal is not None
    return color, normal, rough


def _kept_picture(texture: str, shows: str) -> Picture | None:
    """A picture of a set of maps as it lies in the cache; none where it would say nothing."""
    settings = str((PICTURE_PX, QUALITY, metadata.version("pillow"), version()))
    name = f"{texture}-{shows}.jpg"
    data = kept(KEPT, version_of(Path(__file__).parent, settings), name,
                lambda: _encoded(texture, shows))  # fmt: skip
    return Picture(data, f"{texture}_{shows}") if data else None


def _encoded(texture: str, shows: str) -> bytes:
    found = maps(texture, PICTURE_PX)
    if shows == "rough":
        if found.roughness.min() == 255:
            return b""
        pixels = rough_metal(found.roughness)
    else:
        pixels = found.base_color if shows == "color" else found.normal
    return picture(pixels, quality=QUALITY[shows]).data


def rough_metal(roughness: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A map of roughness as glTF wants it: in green, with metalness 1 in blue, shape [N, N, 3].

    Args:
        roughness: Shape [N, N].
    """
    full = np.full_like(roughness, 255)
    return np.stack([full, roughness, full], axis=-1)


def picture(pixels: NDArray[np.uint8], name: str = "", quality: int = 90) -> Picture:
    """A picture as a JPEG file; the same pixels give the same bytes.

    Args:
        pixels: Shape [height, width, 3].
        name: What it shows.
        quality: Of JPEG, up to 95.
    """
    from PIL import Image

    out = io.BytesIO()
    Image.fromarray(pixels).save(out, "JPEG", quality=quality, subsampling=0)
    return Picture(out.getvalue(), name)


def tinted(surface: Surface) -> Surface:
    """The same surface with its colour multiplied into its picture, for readers without factors."""
    from PIL import Image

    if surface.base is None or min(surface.color) > 0.999:
        return surface
    with Image.open(io.BytesIO(surface.base.data)) as image:
        pixels = np.asarray(image.convert("RGB"))
    levels = linear(np.arange(256) / 255.0)
    channels = [
        np.rint(255.0 * srgb(levels * factor)).astype(np.uint8)[pixels[..., k]]
        for k, factor in enumerate(surface.color)
    ]
    base = picture(np.stack(channels, axis=-1), surface.base.name)
    return replace(surface, color=(1.0, 1.0, 1.0), base=base)
