"""What four-legged animals wear: coats about the trunk, sleeves, and where hats and collars go."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.appearance import Appearance
from esg.assets.builders.common import shade
from esg.assets.builders.living.beasts import Beast
from esg.assets.builders.living.headwear import Anchor, Piece, piece
from esg.assets.geometry.sketch import Sketch, rgb
from esg.assets.lazy import forms

NECKED = frozenset({"collar", "scarf", "bandana", "bow tie"})
"""What takes the place of a collar that a kind wears anyway."""
_SLEEVED = frozenset({"t-shirt", "shirt", "sweater", "jacket", "coat", "raincoat"})
_SLEEVELESS = frozenset({"vest", "life jacket"})
_BACK = 0.24
"""Share of a trunk's length at which what it wears begins, so that the tail is free."""


def trunk_wear(look: Appearance) -> list[tuple[str, Piece]]:
    """Kinds and pieces that are worn about a trunk."""
    known = _SLEEVED | _SLEEVELESS | {"cape"}
    return [(w.kind, piece(w)) for w in look.wears if w.kind in known]


def sleeves(look: Appearance) -> Piece | None:
    """What covers the upper fore legs; None if nothing does."""
    return next((p for kind, p in trunk_wear(look) if kind in _SLEEVED), None)


def clothe(s: Sketch, b: Beast) -> None:
    """Draws what an animal wears about its trunk."""
    thick = 0.06 * (b.trunk[2] + b.trunk[3])
    for kind, p in trunk_wear(s.appearance):
        if kind == "cape":
            s.add(lambda: _cape(b, thick), p.color, of=p.surface, name=p.name)
            continue
        s.add(lambda: trunk(b, (_BACK, 0.985), thick), p.color, of=p.surface, name=p.name)
        hem = (_BACK - 0.005, _BACK + 0.03)
        s.add(lambda h=hem: trunk(b, h, 1.3 * thick), shade(p.color, 0.75), of=p.surface,
              name=f"{p.name}_hem")  # fmt: skip
        if kind in _SLEEVELESS:
            for low in (0.42, 0.62):
                s.add(lambda q=low: trunk(b, (q, q + 0.06), 1.2 * thick), rgb(214, 232, 80),
                      of="paint", name=f"{p.name}_band")  # fmt: skip


def _cape(b: Beast, thick: float) -> Any:
    """Cloth over the back that hangs down on both sides."""
    import numpy as np

    whole = trunk(b, (0.12, 0.94), thick).vertices
    length, high = whole[:, 0], whole[:, 2]
    rings = []
    for x in np.linspace(length.min(), length.max(), 14):
        near = np.abs(length - x) < 0.08 * (length.max() - length.min())
        top, wide = high[near].max(), np.abs(whole[near, 1]).max()
        turn = np.radians(np.linspace(-8, 188, 19))
        drop = 0.9 * wide
        outer = np.c_[wide * 1.08 * np.cos(turn), top - drop + drop * np.sin(turn)]
        inner = np.c_[wide * 1.0 * np.cos(turn), top - drop - thick + drop * np.sin(turn)][::-1]
        flat = np.concatenate([outer, inner])
        rings.append(np.c_[np.full(len(flat), x), flat])
    return forms.loft(np.array(rings))


def anchor(b: Beast) -> Anchor:
    """Where an animal wears a hat, glasses and a collar."""
    x, z = b.neck[:2]
    front, zf = b.legs[1], b.trunk[1]
    r = b.head[0]
    t = 0.62
    neck = (front + t * (x - front), 0.0, zf + t * (z - zf) + 0.02 * zf)
    lean = math.degrees(math.atan2(x - front, max(z - zf, 0.2 * r)))
    girth = (1 - t) * b.neck[2] + t * b.neck[3]
    eyes = (0.8 * r, 0.55 * r, 0.36 * r)
    return Anchor((x, 0.0, z + 0.1 * r), r, neck, 0.98 * girth, eyes, lean)


def trunk(b: Beast, cut: tuple[float, float] | None = None, grow: float = 0.0) -> Any:
    """Haunches, belly and chest as one skin, deeper than wide, drawn in at the waist.

    Args:
        b: The animal.
        cut: Shares of its length between which it is drawn; None for all of it.
        grow: Larger all around [cm].
    """
    import numpy as np

    rear, front = b.legs[:2]
    zr, zf, rr, rf = b.trunk
    u = np.sin(np.radians(np.linspace(-84, 86, 22)))
    t = 0.5 + 0.5 * u if cut is None else np.linspace(*cut, 16)
    x = (rear - 0.86 * rr) + t * ((front + 0.9 * rf) - (rear - 0.86 * rr))
    girth = forms.profile(
        [
            (0, 0.34 * rr),
            (0.05, 0.7 * rr),
            (0.17, rr),
            (0.44, (1 - b.waist) * 0.5 * (rr + rf)),
            (0.72, rf),
            (0.9, 0.86 * rf),
            (1, 0.3 * rf),
        ]
    )(t)
    back = forms.profile([(0, zr + 0.1 * rr), (0.3, zr), (0.7, zf), (1, zf + 0.12 * rf)])(t)
    # A waist is drawn in from below: the back stays straight.
    lift = forms.profile(
        [(0, 0), (0.2, 0), (0.44, 0.5 * b.waist * (rr + rf) * 0.5), (0.7, 0), (1, 0)]
    )(t)
    ring = forms.superellipse(24, 2.2)
    y = (girth + grow)[:, None] * ring[:, 0]
    z = (back + lift)[:, None] + (girth + grow)[:, None] * ring[:, 1]
    return forms.loft(np.stack([np.broadcast_to(x[:, None], y.shape), y, z], -1))
