"""Drawings that are rows of primitives: `drawings.txt`, read and registered as builders.

A section is headed by a builder and its parameters (`[bag kind=sack]`); each row below names a
primitive of the sketch and its arguments, positional ones first: numbers and tuples [cm], names of
colours, `c` for the main colour, `STEEL*0.8` for a shade, `#rrggbb`. `shift` moves what stands
above it; `turns` makes what was drawn last a wheel. All of these keep their proportions.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from esg.assets.builders import builder
from esg.assets.builders.common import LEAF, blob, bone, prism, shade, shift, spokes, wheel
from esg.assets.geometry import sketch as palette
from esg.assets.geometry.sketch import Color, Sketch, rgb

TABLE = Path(__file__).parent / "drawings.txt"
PRIMITIVES: dict[str, Callable[..., object]] = {
    "ball": Sketch.ball,
    "blob": blob,
    "bone": bone,
    "box": Sketch.box,
    "extrude": Sketch.extrude,
    "lathe": Sketch.lathe,
    "only_weighs": Sketch.only_weighs,
    "pipe": Sketch.pipe,
    "prism": prism,
    "proxy": Sketch.proxy,
    "proxy_cylinder": Sketch.proxy_cylinder,
    "proxy_hull": Sketch.proxy_hull,
    "proxy_slab": Sketch.proxy_slab,
    "region": Sketch.region,
    "ring": Sketch.ring,
    "rod": Sketch.rod,
    "shift": shift,
    "slab": Sketch.slab,
    "spokes": spokes,
    "surface": Sketch.surface,
    "torus": Sketch.torus,
    "tub": Sketch.tub,
    "turns": Sketch.wheel,
    "wheel": wheel,
}
Arguments = tuple[tuple[Any, ...], dict[str, Any]]


@cache
def sections() -> dict[str, tuple[str, ...]]:
    """Rows by heading, without comments."""
    out: dict[str, list[str]] = {}
    rows: list[str] = []
    for line in TABLE.read_text(encoding="utf-8").splitlines():
        if line.startswith("["):
            rows = out.setdefault(line.strip("[]"), [])
        elif line and not line.startswith("#"):
            rows.append(line)
    return {heading: tuple(rows) for heading, rows in out.items()}


def _color(text: str, main: Color) -> Color:
    name, *factors = text.split("*")
    if name.startswith("#"):
        color = rgb(*bytes.fromhex(name[1:]))
    else:
        color = {"c": main, "LEAF": LEAF}.get(name) or vars(palette)[name]
    for factor in factors:
        color = shade(color, float(factor))
    return color


def _value(text: str, main: Color) -> Any:
    if text[0] in "([-.0123456789" or text == "None":
        return ast.literal_eval(text)
    if text == "c" or text[0] == "#" or text[0].isupper() or text.startswith("c*"):
        return _color(text, main)
    return text


def _arguments(words: list[str], main: Color) -> Arguments:
    named = [w.split("=", 1) for w in words if "=" in w]
    placed = tuple(_value(w, main) for w in words if "=" not in w)
    return placed, {key: _value(text, main) for key, text in named}


def draw(s: Sketch, heading: str, main: Color) -> None:
    """Draws a section of the table into a sketch."""
    for row in sections()[heading]:
        primitive, *words = row.split()
        placed, named = _arguments(words, main)
        PRIMITIVES[primitive](s, *placed, **named)


def _register(name: str) -> None:
    @builder(name)
    def drawing(s: Sketch, L: float, W: float, H: float, c: Color, **params: object) -> None:  # pyright: ignore[reportUnusedFunction]  # registered
        draw(s, " ".join((name, *(f"{k}={v}" for k, v in sorted(params.items())))), c)


for _name in dict.fromkeys(heading.split()[0] for heading in sections()):
    _register(_name)
