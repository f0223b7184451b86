"""Small helpers that builders share."""

from __future__ import annotations

from esg.assets.sketch import Color

Span = tuple[float, float]


def shade(c: Color, factor: float) -> Color:
    """A lighter or darker tone."""
    return (min(c[0] * factor, 1.0), min(c[1] * factor, 1.0), min(c[2] * factor, 1.0))


def mirrored(sign: int, low: float, high: float) -> Span:
    """The span [low, high], mirrored at 0 for a negative sign."""
    return (low, high) if sign > 0 else (-high, -low)


def edge(sign: int, extent: float, thickness: float) -> Span:
    """The outermost `thickness` of a centred extent, on the side of `sign`."""
    return mirrored(sign, extent / 2 - thickness, extent / 2)
