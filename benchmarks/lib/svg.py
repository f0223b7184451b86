"""Small drawings for the documentation: lines, points, bars, boxes with arrows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
import html
import math

import numpy as np
from numpy.typing import ArrayLike

INK, FAINT, PAPER = "#22303c", "#8a97a3", "#ffffff"
COLORS = ("#2f7de1", "#d0342c", "#1f9d55", "#e08a00", "#7b4fc9")
CHAR = 6.6
"""Width of a letter [px] of 12 px."""
LEFT, TOP, BOTTOM, RIGHT = 62, 26, 44, 14


@dataclass(frozen=True)
class Line:
    """A row of points in the units of its axes; `dots` draws them apart."""

    x: ArrayLike
    y: ArrayLike
    color: str
    name: str = ""
    dots: bool = False
    width: float = 1.6
    opacity: float = 1.0
    dash: str = ""


@dataclass(frozen=True)
class Axis:
    """What is along an axis, and whether in powers of ten."""

    label: str
    log: bool = False

    def ticks(self, low: float, high: float) -> list[float]:
        if self.log:
            powers = range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)
            return [10.0**p for p in powers]
        step = 10 ** math.floor(math.log10((high - low) / 3))
        step *= next(f for f in (1, 2, 5, 10) if (high - low) / (step * f) <= 6)
        return [k * step for k in range(math.ceil(low / step), math.floor(high / step) + 1)]

    def scale(self, low: float, high: float, start: float, end: float) -> Callable[[float], float]:
        if self.log:
            low, high = math.log10(low), math.log10(high)
        return lambda v: (
            start + (((math.log10(v) if self.log else v) - low) / (high - low) * (end - start))
        )


def page(width: float, height: float, inside: Sequence[str]) -> str:
    """An SVG file on white, which dark pages show as well."""
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}" '
        f'width="{width:g}" height="{height:g}" font-family="sans-serif" font-size="12">'
    )
    paper = f'<rect width="100%" height="100%" fill="{PAPER}"/>'
    return "\n".join((head, paper, *inside, "</svg>")) + "\n"


def text(x: float, y: float, words: str, more: str = "") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" fill="{INK}" {more}>{html.escape(words)}</text>'


def plot(
    lines: Sequence[Line],
    x: Axis,
    y: Axis,
    *,
    size: tuple[float, float] = (720, 320),
    equal: bool = False,
) -> str:
    """Lines and points over two axes with a legend of those that have a name.

    Args:
        lines: The later ones lie above.
        x: Across.
        y: Up.
        size: Width and height [px].
        equal: One unit is as long across as up.
    """
    width, height = size
    xs = np.concatenate([np.asarray(line.x, float) for line in lines])
    ys = np.concatenate([np.asarray(line.y, float) for line in lines])
    (x0, x1), (y0, y1) = _span(xs, x.log), _span(ys, y.log)
    if equal:
        room = (width - LEFT - RIGHT) / (height - TOP - BOTTOM)
        spare = (x1 - x0) - room * (y1 - y0)
        if spare > 0:
            y0, y1 = y0 - spare / room / 2, y1 + spare / room / 2
        else:
            x0, x1 = x0 + spare / 2, x1 - spare / 2
    px = x.scale(x0, x1, LEFT, width - RIGHT)
    py = y.scale(y0, y1, height - BOTTOM, TOP)
    out: list[str] = []
    for tick in x.ticks(x0, x1):
        out.append(_rule(px(tick), TOP, px(tick), height - BOTTOM))
        out.append(text(px(tick), height - BOTTOM + 16, f"{tick:g}", 'text-anchor="middle"'))
    for tick in y.ticks(y0, y1):
        out.append(_rule(LEFT, py(tick), width - RIGHT, py(tick)))
        out.append(text(LEFT - 6, py(tick) + 4, f"{tick:g}", 'text-anchor="end"'))
    out += [_drawn(line, px, py) for line in lines]
    out.append(text((LEFT + width) / 2, height - 8, x.label, 'text-anchor="middle"'))
    middle = (TOP + height - BOTTOM) / 2
    turned = f'text-anchor="middle" transform="rotate(-90 14 {middle:.1f})"'
    out.append(text(14, middle, y.label, turned))
    at = LEFT
    for line in lines:
        if line.name:
            out.append(f'<rect x="{at}" y="8" width="12" height="8" fill="{line.color}"/>')
            out.append(text(at + 16, 16, line.name))
            at += 34 + CHAR * len(line.name)
    return page(width, height, out)


def _span(values: np.ndarray, log: bool) -> tuple[float, float]:
    low, high = float(values.min()), float(values.max())
    if log:
        return low / 1.3, high * 1.3
    margin = 0.04 * (high - low) or 1.0
    return low - margin, high + margin


def _rule(x1: float, y1: float, x2: float, y2: float) -> str:
    return f'<path d="M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" stroke="#e3e7eb"/>'


def _drawn(line: Line, px: Callable[[float], float], py: Callable[[float], float]) -> str:
    points = [
        (px(float(a)), py(float(b)))
        for a, b in zip(np.asarray(line.x), np.asarray(line.y), strict=True)
    ]
    if line.dots:
        circles = "".join(
            f'<circle cx="{a:.1f}" cy="{b:.1f}" r="{line.width:g}"/>' for a, b in points
        )
        return f'<g fill="{line.color}" opacity="{line.opacity:g}">{circles}</g>'
    path = "L".join(f"{a:.1f} {b:.1f}" for a, b in points)
    return (
        f'<path d="M{path}" fill="none" stroke="{line.color}" stroke-width="{line.width:g}" '
        f'opacity="{line.opacity:g}" stroke-dasharray="{line.dash}"/>'
    )


@dataclass(frozen=True)
class Box:
    """A box at a column and a row with lines of text, the first of which is its title."""

    name: str
    column: float
    row: float
    lines: tuple[str, ...]
    color: str = COLORS[0]


def boxes(
    found: Sequence[Box],
    arrows: Sequence[tuple[str, str]],
    *,
    column: float = 190,
    row: float = 92,
    wide: float = 150,
) -> str:
    """Boxes and arrows (from, to) between their nearest sides."""
    tall = {b.name: 14 + 16 * len(b.lines) for b in found}
    at = {b.name: (16 + b.column * column + wide / 2, 14 + b.row * row + row * 0.36) for b in found}
    out = [
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" '
        f'markerHeight="7" orient="auto"><path d="M0 0L8 4L0 8z" fill="{FAINT}"/></marker></defs>'
    ]
    for start, end in arrows:
        (x1, y1), (x2, y2) = at[start], at[end]
        if abs(x2 - x1) > 1:
            side = math.copysign(wide / 2, x2 - x1)
            x1, x2 = x1 + side, x2 - side
        else:
            side = math.copysign(1, y2 - y1)
            y1, y2 = y1 + side * tall[start] / 2, y2 - side * tall[end] / 2
        out.append(
            f'<path d="M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" stroke="{FAINT}" '
            'stroke-width="1.4" marker-end="url(#tip)"/>'
        )
    for box in found:
        x, y = at[box.name]
        high = tall[box.name]
        out.append(
            f'<rect x="{x - wide / 2:.1f}" y="{y - high / 2:.1f}" width="{wide}" height="{high}" '
            f'rx="6" fill="{box.color}" fill-opacity=".12" stroke="{box.color}"/>'
        )
        for k, line in enumerate(box.lines):
            bold = 'font-weight="bold"' if k == 0 else 'font-size="11"'
            out.append(text(x, y - high / 2 + 18 + 16 * k, line, f'text-anchor="middle" {bold}'))
    width = max(x for x, _ in at.values()) + wide / 2 + 16
    height = max(y + tall[name] / 2 for name, (_, y) in at.items()) + 14
    return page(width, height, out)
