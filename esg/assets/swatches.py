"""The sheet of materials: a ball of each, lit by a sun and a sky, drawn with numpy alone."""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.assets.materials import MATERIALS, look_of
from esg.assets.textures import linear, maps, srgb

Floats = NDArray[np.float64]

_VIEWER = np.array([0.0, 0.0, 1.0])
_SUN = np.array([-0.45, 0.62, 0.64])
_SUN_LIGHT = np.array([2.9, 2.8, 2.6])
_SKY, _GROUND = np.array([0.62, 0.74, 0.92]), np.array([0.30, 0.28, 0.26])
_BACKGROUND = 0.78
_BEHIND = linear((_BACKGROUND, _BACKGROUND, _BACKGROUND))
_LABEL_PX = 11
_ACROSS = 1.3
"""Tiles of its texture across a ball."""


class _Ball(NamedTuple):
    normal: Floats
    u: Floats
    v: Floats
    inside: NDArray[np.bool_]


def _ball(size: int) -> _Ball:
    at = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    x, y = np.meshgrid(1.04 * at, -1.04 * at)
    inside = x * x + y * y < 1.0
    z = np.sqrt(np.clip(1.0 - x * x - y * y, 0.0, 1.0))
    # as far along the surface as it looks: the middle half of a globe's net
    u, v = np.arctan2(x, np.maximum(z, 1e-6)), np.arcsin(np.clip(y, -1.0, 1.0))
    return _Ball(np.stack([x, y, z], axis=-1), u / 2.0, v / 2.0, inside)


def _sampled(pixels: NDArray[np.uint8], ball: _Ball) -> Floats:
    n = len(pixels)
    column = np.floor(ball.u * _ACROSS * n).astype(int) % n
    row = np.floor(-ball.v * _ACROSS * n).astype(int) % n
    return pixels[row, column] / 255.0


def _surroundings(direction: Floats, blur: Floats) -> Floats:
    """Light from a direction: a sky over a ground, their border the softer the rougher."""
    up = direction[..., 1:2] / np.maximum(0.06, blur[..., None])
    share = 0.5 + 0.5 * np.tanh(2.0 * up)
    return _GROUND + (_SKY - _GROUND) * share


def swatch(look: Look, size: int) -> Floats:
    """A ball of a look, linear light, shape [size, size, 3]."""
    ball = _ball(size)
    color = np.broadcast_to(linear(look.color), (size, size, 3))
    rough = np.full((size, size), look.roughness)
    normal = ball.normal
    if look.texture is not None:
        found = maps(look.texture, 1 << size.bit_length() - 1)
        color = color * linear(_sampled(found.base_color, ball))
        rough = rough * _sampled(found.roughness, ball)
        bump = 2.0 * _sampled(found.normal, ball) - 1.0
        right = np.stack([normal[..., 2], np.zeros((size, size)), -normal[..., 0]], axis=-1)
        right /= np.maximum(np.linalg.norm(right, axis=-1, keepdims=True), 1e-9)
        up = np.cross(normal, right)
        slope = look.normal_strength
        normal = normal * bump[..., 2:] + slope * (right * bump[..., :1] + up * bump[..., 1:2])
        normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
    sun = _SUN / np.linalg.norm(_SUN)
    half = sun + _VIEWER
    half /= np.linalg.norm(half)
    facing = np.clip(normal[..., 2], 0.0, 1.0)
    lit = np.clip(normal @ sun, 0.0, 1.0)
    # Cook and Torrance with the distribution of GGX, as glTF 2.0 says (appendix B)
    spread = np.clip(rough, 0.04, 1.0) ** 4
    peak = spread / (math.pi * ((np.clip(normal @ half, 0, 1) ** 2) * (spread - 1.0) + 1.0) ** 2)
    bare = 0.04 + (color - 0.04) * look.metalness
    fresnel = bare + (1.0 - bare) * ((1.0 - facing) ** 5 * (1.0 - rough) ** 2)[..., None]
    mirror = 2.0 * facing[..., None] * normal - _VIEWER
    diffuse = color * (1.0 - look.metalness) * (lit[..., None] * _SUN_LIGHT / math.pi)
    diffuse += 0.5 * color * (1.0 - look.metalness) * _surroundings(normal, np.ones_like(rough))
    shine = fresnel * (np.minimum(0.25 * peak * lit, 8.0))[..., None] * _SUN_LIGHT
    shine += fresnel * _surroundings(mirror, rough)
    alpha = np.clip(look.alpha + fresnel.max(axis=-1, keepdims=True), 0.0, 1.0)
    seen = diffuse * look.alpha + shine + (1.0 - alpha) * _BEHIND
    return np.where(ball.inside[..., None], seen, _BEHIND)


def materials_sheet(path: Path, *, columns: int = 12, size: int = 96) -> int:
    """Writes a picture with a labelled ball of every material.

    Args:
        path: A PNG, JPEG or WebP file.
        columns: Balls in a row.
        size: Pixels along each side of one.

    Returns:
        How many materials it shows.
    """
    from PIL import Image, ImageDraw, ImageFont

    rows = math.ceil(len(MATERIALS) / columns)
    ground = (round(255 * _BACKGROUND),) * 3
    sheet = Image.new("RGB", (columns * size, rows * (size + _LABEL_PX)), ground)
    draw, letters = ImageDraw.Draw(sheet), ImageFont.load_default(9)
    for k, name in enumerate(MATERIALS):
        light = swatch(look_of(name), 2 * size).reshape(size, 2, size, 2, 3).mean((1, 3))
        pixels = np.rint(255.0 * srgb(light / (1.0 + 0.18 * light) * 1.05)).astype(np.uint8)
        x, y = k % columns * size, k // columns * (size + _LABEL_PX)
        sheet.paste(Image.fromarray(pixels), (x, y))
        draw.text((x + size // 2, y + size - 1), name, fill="black", font=letters, anchor="ma")
    sheet.save(path, quality=85)
    return len(MATERIALS)
