"""What somebody wears and how he looks, measured on the parts of which his model is drawn."""

from __future__ import annotations

from esg.assets.colors import COLORS, find_color
from esg.lexicon.garments import Garment, garments, read
from esg.metrics.replay import Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.thresholds import WORN_COLOR

_ANY_HAIR = "hair"
"""A kind that every other drawn hair is, too."""


def wears(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """His model has the part, in the colour, of the material and with the stripes that are said."""
    phrase = q.statement.noun or ""
    worn = read(phrase, COLORS)
    if worn is None or worn.unread:
        return Kept(None, reason=f"nothing is drawn for {phrase!r}")
    names = _names(worn.garment)
    drawn = [part.split() for part in replay.scene.bodies[body].drawn]
    found = [p for p in drawn if any(p[0] == n or p[0].startswith(n + "_") for n in names)]
    if not found:
        return Kept(False, reason=f"its model has no {worn.garment.kind}")
    if worn.surface and not any(p[2] == worn.surface for p in found):
        return Kept(False, reason=f"its {worn.garment.kind} is not of {worn.surface}")
    if worn.pattern and not any(p[0].endswith("_stripes") for p in found):
        return Kept(False, reason=f"its {worn.garment.kind} is not {worn.pattern}")
    color = find_color(worn.color)
    if color is None:
        return Kept(True)
    off = min(_apart(color, find_color(p[1]) or (0.0, 0.0, 0.0)) for p in found)
    reason = f"its {worn.garment.kind} is {off:.2f} off {worn.color}; limit {WORN_COLOR:g}"
    return Kept.when(off <= WORN_COLOR, reason, color_off=off)


def _names(garment: Garment) -> set[str]:
    """How the parts may be called that are such a garment."""
    kinds = {garment.kind}
    if garment.kind == _ANY_HAIR:
        kinds |= {g.kind for g in garments().values() if g.place == "hair" and g.surface == "hair"}
    return {k.replace(" ", "_").replace("-", "_") for k in kinds}


def _apart(a: tuple[float, float, float], b: tuple[float, float, float]) -> float:
    """The largest difference of two colours in a channel."""
    return max(abs(x - y) for x, y in zip(a, b, strict=True))
