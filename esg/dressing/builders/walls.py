"""Walls of rooms and halls, facades, fences and what else stands in long runs."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from esg.assets.looks import Color
from esg.dressing.builders.table import Wish, builder
from esg.dressing.solids import ALL_SIDES, Drawing

WHITE: Color = (0.9, 0.9, 0.88)
DAY_PANE: Color = (0.5, 0.58, 0.64)
NIGHT_PANE: Color = (0.07, 0.09, 0.13)
LIT_PANE: Color = (1.0, 0.84, 0.52)
OUTSIDE_DAY: Color = (0.82, 0.9, 0.97)
OUTSIDE_NIGHT: Color = (0.05, 0.07, 0.13)
DOOR_AT = 0.3
"""Of a room's door along its wall, in widths from the middle."""
CORNICE_M = 0.22
Row = tuple[float, float, list[tuple[float, "Openings"]]]
"""A storey of a wall: from and to a height [m], openings by their middles along it."""
FRONT_AND_ENDS = frozenset({"+x", "+y", "-y", "+z"})


@dataclass(frozen=True)
class Openings:
    """Windows or doors of one row of a wall.

    Args:
        low, high: Heights of sill and lintel [m].
        wide: Of one opening [m].
        every: Distance of their middles [m].
        kind: window, shop, door, roller or strip.
        frame: Colour of the frames.
    """

    low: float
    high: float
    wide: float
    every: float
    kind: str = "window"
    frame: Color = WHITE

    def middles(self, width: float) -> list[float]:
        """Along the wall [m], as many as fit."""
        count = max(0, int((width - 0.5 * (self.every - self.wide)) / self.every))
        return [self.every * (k - 0.5 * (count - 1)) for k in range(count)]


def _pierced(
    draw: Drawing,
    wish: Wish,
    front: float,
    rows: list[Row],
    surface: str,
) -> None:
    """The front plane x = `front` of a wall, in storeys from `low` to `high` with openings."""
    y0, y1 = -0.5 * wish.width, 0.5 * wish.width

    def piece(ya: float, yb: float, za: float, zb: float) -> None:
        draw.sheet(surface, (front, ya, za), (0, yb - ya, 0), (0, 0, zb - za), wish.color)

    for low, high, openings in rows:
        if not openings:
            piece(y0, y1, low, high)
            continue
        # Openings of a row share sill and lintel where they are of one kind; each kind fills the
        # whole height of its own column.
        at = y0
        for middle, o in sorted(openings, key=lambda pair: pair[0]):
            ya, yb = middle - 0.5 * o.wide, middle + 0.5 * o.wide
            za, zb = max(low, o.low), min(high, o.high)
            piece(at, ya, low, high)
            piece(ya, yb, low, za)
            piece(ya, yb, zb, high)
            _opening(draw, front, (ya, yb, za, zb), o)
            at = yb
        piece(at, y1, low, high)


def _opening(
    draw: Drawing, front: float, hole: tuple[float, float, float, float], o: Openings
) -> None:
    """Reveals, frame and filling of one opening."""
    ya, yb, za, zb = hole
    deep = 0.12 if o.kind != "shop" else 0.25
    back = front - deep
    wide, tall = yb - ya, zb - za
    draw.sheet("plaster", (back, ya, za), (0, 0, tall), (deep, 0, 0), o.frame)
    draw.sheet("plaster", (front, yb, za), (0, 0, tall), (-deep, 0, 0), o.frame)
    draw.sheet("plaster", (back, ya, zb), (0, wide, 0), (deep, 0, 0), o.frame)
    draw.sheet("plaster", (back, ya, za), (deep, 0, 0), (0, wide, 0), o.frame)
    if o.kind == "roller":
        draw.sheet("painted", (back, ya, za), (0, wide, 0), (0, 0, tall), (0.62, 0.65, 0.67))
        for k in range(1, 6):
            z = za + tall * k / 6
            draw.box(
                "painted",
                (back, ya, z - 0.02),
                (back + 0.03, yb, z + 0.02),
                (0.5, 0.53, 0.55),
                ALL_SIDES,
            )
        return
    if o.kind == "door":
        draw.box("painted", (back, ya, za), (back + 0.05, yb, zb), o.frame, FRONT_AND_ENDS)
        knob = yb - 0.1 * wide
        draw.box(
            "steel",
            (back + 0.05, knob - 0.06, za + 1.0),
            (back + 0.1, knob + 0.06, za + 1.03),
            None,
            ALL_SIDES,
        )
        return
    pane, tint = _pane(draw, o.kind)
    draw.sheet(pane, (back, ya, za), (0, wide, 0), (0, 0, tall), tint)
    bar = 0.05 if o.kind != "shop" else 0.07
    edges = [
        (ya, ya + bar, za, zb),
        (yb - bar, yb, za, zb),
        (ya, yb, za, za + bar),
        (ya, yb, zb - bar, zb),
    ]
    across = max(1, round(wide / 1.1))
    edges += [
        (y - 0.5 * bar, y + 0.5 * bar, za, zb)
        for y in (ya + wide * k / across for k in range(1, across))
    ]
    for y, y2, z, z2 in edges:
        draw.box("painted", (back, y, z), (back + 0.04, y2, z2), o.frame, ALL_SIDES - {"-x"})
    if o.kind in ("window", "room"):
        sill = (front + 0.05, yb + 0.05, za)
        draw.box("concrete", (back, ya - 0.05, za - 0.05), sill, WHITE, ALL_SIDES - {"-x"})


def _pane(draw: Drawing, kind: str) -> tuple[str, Color]:
    """What one sees in a pane: from a room the sky, from a street a reflection or a lamp."""
    if kind in ("room", "strip"):
        return ("pane", OUTSIDE_NIGHT) if draw.night else ("glow", OUTSIDE_DAY)
    if not draw.night:
        return "pane", DAY_PANE
    lit = draw.rng.random() < (0.9 if kind == "shop" else 0.4)
    return ("glow", LIT_PANE) if lit else ("pane", NIGHT_PANE)


def _row(openings: Openings, width: float) -> list[tuple[float, Openings]]:
    return [(middle, openings) for middle in openings.middles(width)]


@builder("room_wall")
def room_wall(draw: Drawing, wish: Wish) -> None:
    """A wall of a room with windows, a skirting board and a cornice; front to the room."""
    _room(
        draw, wish, _row(Openings(0.9, min(2.2, wish.height - 0.3), 1.3, 2.6, "room"), wish.width)
    )


@builder("room_wall_door", door=DOOR_AT)
def room_wall_door(draw: Drawing, wish: Wish) -> None:
    """A wall of a room with a door."""
    door = Openings(0.0, 2.05, 0.92, 1.0, "door", (0.78, 0.74, 0.66))
    _room(draw, wish, [(DOOR_AT * wish.width, door)])


@builder("room_wall_plain", bare=True)
def room_wall_plain(draw: Drawing, wish: Wish) -> None:
    """A wall of a room without openings."""
    _room(draw, wish, [])


def _room(draw: Drawing, wish: Wish, openings: list[tuple[float, Openings]]) -> None:
    front = 0.5 * wish.depth
    _pierced(draw, wish, front, [(0.0, wish.height, openings)], wish.surface or "plaster")
    doors = [(m - 0.5 * o.wide, m + 0.5 * o.wide) for m, o in openings if o.low < 0.1]
    at = -0.5 * wish.width
    for left, right in [*doors, (0.5 * wish.width, 0.0)]:
        low, high = (front, at, 0.0), (front + 0.018, left, 0.09)
        draw.box("painted", low, high, WHITE, ALL_SIDES - {"-x", "-z"})
        at = right
    half, h = 0.5 * wish.width, wish.height
    draw.box(
        "plaster", (front, -half, h - 0.05), (front + 0.03, half, h), WHITE, ALL_SIDES - {"-x"}
    )


@builder("hall_wall", bare=True)
def hall_wall(draw: Drawing, wish: Wish) -> None:
    """A wall of a hall: sheet above a solid base, pillars, a strip of windows under the roof."""
    front, h = 0.5 * wish.depth, wish.height
    base = min(1.2, 0.3 * h)
    strip = Openings(0.68 * h, 0.88 * h, 3.6, 5.0, "strip", (0.45, 0.48, 0.5))
    low, high = Wish(wish.depth, wish.width, base, "concrete"), wish
    _pierced(draw, low, front, [(0.0, base, [])], "concrete")
    rows = [(base, h, _row(strip, wish.width))]
    _pierced(draw, high, front, rows, wish.surface or "sheet_metal")
    count = max(2, round(wish.width / 5.0) + 1)
    for k in range(count):
        y = wish.width * (k / (count - 1) - 0.5)
        y = min(max(y, -0.5 * wish.width + 0.12), 0.5 * wish.width - 0.12)
        low_corner, corner = (front, y - 0.12, 0.0), (front + 0.22, y + 0.12, h)
        draw.box("painted", low_corner, corner, (0.5, 0.54, 0.58), ALL_SIDES - {"-x", "-z"})


@builder("hall_wall_gate")
def hall_wall_gate(draw: Drawing, wish: Wish) -> None:
    """A wall of a hall with roller gates."""
    front, h = 0.5 * wish.depth, wish.height
    gate = Openings(0.0, min(4.0, 0.75 * h), 3.6, 7.0, "roller", (0.35, 0.37, 0.4))
    _pierced(draw, wish, front, [(0.0, h, _row(gate, wish.width))], wish.surface or "sheet_metal")


def _facade(draw: Drawing, wish: Wish, ground: Openings, above: Openings, storey: float) -> None:
    """A house of several storeys with windows to the front and to the back."""
    x, half, h = 0.5 * wish.depth - CORNICE_M, 0.5 * wish.width, wish.height
    storeys = max(1, round(h / storey))
    each = h / storeys
    surface = wish.surface or "plaster"
    for behind in (False, True):
        rows: list[Row] = []
        for k in range(storeys):
            below = ground if k == 0 and not behind else above
            row = _row(_raised(below, k * each, each), wish.width)
            if k == 0 and not behind and ground.kind == "window":
                row = _with_door(draw, row, (0.35, 0.22, 0.16))
            rows.append((k * each, (k + 1) * each, row))
        draw.about = behind
        _pierced(draw, wish, x, rows, surface)
    draw.about = False
    low, high = (-x, -half, 0.0), (x, half, h)
    draw.box(surface, low, high, wish.color, frozenset({"+y", "-y"}))
    draw.box("concrete", low, high, (0.45, 0.44, 0.43), frozenset({"+z"}))
    edge = (x - 0.3, -half, h - 0.12), (x + CORNICE_M, half, h + 0.18)
    draw.box("concrete", *edge, (0.8, 0.78, 0.74), ALL_SIDES)
    if ground.kind == "shop":
        z = each - 0.2
        tint = SIGNS[int(draw.rng.integers(len(SIGNS)))]
        draw.box("painted", (x, -half + 0.3, z - 0.5), (x + 0.1, half - 0.3, z), tint, ALL_SIDES)


def _with_door(
    draw: Drawing, row: list[tuple[float, Openings]], color: Color
) -> list[tuple[float, Openings]]:
    """One window of a row becomes a door."""
    if not row:
        return row
    at = int(draw.rng.integers(len(row)))
    middle, window = row[at]
    door = Openings(
        0.0, min(2.15, window.high), min(1.05, window.wide), window.every, "door", color
    )
    return [*row[:at], (middle, door), *row[at + 1 :]]


def _raised(o: Openings, floor: float, storey: float) -> Openings:
    """Openings of a storey that begins at a height [m]."""
    return replace(o, low=floor + o.low, high=floor + min(o.high, storey - 0.25))


SIGNS: tuple[Color, ...] = (
    (0.16, 0.3, 0.28),
    (0.5, 0.14, 0.13),
    (0.13, 0.2, 0.36),
    (0.74, 0.6, 0.2),
    (0.2, 0.2, 0.2),
)


@builder("facade_house")
def facade_house(draw: Drawing, wish: Wish) -> None:
    """A town house: rows of windows and a door."""
    window = Openings(0.9, 2.35, 1.05, 2.3)
    _facade(draw, wish, window, window, 3.0)


@builder("facade_shop")
def facade_shop(draw: Drawing, wish: Wish) -> None:
    """A house with a shop in it."""
    shop = Openings(0.35, 2.75, 2.6, 3.1, "shop", (0.24, 0.25, 0.26))
    _facade(draw, wish, shop, Openings(0.85, 2.4, 1.1, 2.4), 3.3)


@builder("facade_office")
def facade_office(draw: Drawing, wish: Wish) -> None:
    """An office building: bands of glass."""
    band = Openings(0.75, 2.7, 2.9, 3.2, "shop", (0.3, 0.32, 0.34))
    _facade(draw, wish, band, band, 3.4)


@builder("facade_works")
def facade_works(draw: Drawing, wish: Wish) -> None:
    """A warehouse or workshop from outside: gates, small windows above."""
    gate = Openings(0.0, 3.6, 3.4, 5.2, "roller", (0.3, 0.32, 0.34))
    strip = Openings(0.9, 1.9, 1.8, 3.2, "window", (0.36, 0.38, 0.4))
    _facade(
        draw,
        Wish(wish.depth, wish.width, wish.height, wish.surface or "sheet_metal", wish.color),
        gate,
        strip,
        4.4,
    )


@builder("cottage", "house")
def cottage(draw: Drawing, wish: Wish) -> None:
    """A small house with a gable roof."""
    eaves, over, top = 0.58 * wish.height, 0.4, wish.height
    body = Wish(wish.depth, wish.width, eaves, wish.surface or "plaster", wish.color)
    x, half = 0.5 * wish.depth - over, 0.5 * wish.width - over
    window = Openings(0.85, min(2.1, eaves - 0.3), 1.1, 2.3)
    row = _with_door(draw, _row(window, wish.width - 2 * over), (0.3, 0.24, 0.2))
    front = replace(body, width=2 * half)
    _pierced(draw, front, x, [(0.0, eaves, row)], body.surface)
    sides = frozenset({"-x", "+y", "-y"})
    draw.box(body.surface, (-x, -half, 0), (x, half, eaves), wish.color, sides)
    for sign in (1.0, -1.0):
        edge = (sign * (x + over), -sign * (half + over), eaves - 0.15)
        rise = (-sign * (x + over), 0.0, top - eaves + 0.15)
        draw.sheet("roof_tiles", edge, (0, sign * 2 * (half + over), 0), rise)
        gable = [(sign * x, sign * half, eaves), (-sign * x, sign * half, eaves)]
        draw.polygon(body.surface, np.array([*gable, (0.0, sign * half, top)]), wish.color)


@builder("garden_wall", "wall")
def garden_wall(draw: Drawing, wish: Wish) -> None:
    """A low wall with a coping."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    draw.box(wish.surface or "brick", (-x, -half, 0), (x, half, h - 0.06), wish.color)
    draw.box("concrete", (-x - 0.04, -half, h - 0.06), (x + 0.04, half, h), None, ALL_SIDES)


@builder("rails", "fence")
def rails(draw: Drawing, wish: Wish) -> None:
    """A fence of posts and rails."""
    half, h = 0.5 * wish.width, wish.height
    surface = wish.surface or "planks"
    count = max(2, round(wish.width / 2.0) + 1)
    for k in range(count):
        y = wish.width * (k / (count - 1) - 0.5)
        draw.box(surface, (-0.05, y - 0.05, 0), (0.05, y + 0.05, h), wish.color)
    for z in (0.4 * h, 0.72 * h, 0.95 * h):
        draw.box(surface, (0.05, -half, z - 0.05), (0.09, half, z + 0.05), wish.color, ALL_SIDES)


@builder("mesh_fence", "fence")
def mesh_fence(draw: Drawing, wish: Wish) -> None:
    """A fence of steel posts and wires."""
    half, h = 0.5 * wish.width, wish.height
    count = max(2, round(wish.width / 2.5) + 1)
    color = wish.color or (0.3, 0.38, 0.34)
    for k in range(count):
        y = wish.width * (k / (count - 1) - 0.5)
        draw.tube("painted", (0, y, 0), (0.03, 0.03), h, color, sides=6)
    wires = max(4, round(h / 0.3))
    for k in range(wires + 1):
        z = 0.06 + (h - 0.1) * k / wires
        draw.box("painted", (-0.006, -half, z - 0.006), (0.006, half, z + 0.006), color, ALL_SIDES)


@builder("boards")
def boards(draw: Drawing, wish: Wish) -> None:
    """The boards of an ice rink: white, a yellow strip at the foot, a dark rail on top."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    draw.box("plastic", (-x, -half, 0.2), (x, half, h - 0.06), wish.color or (0.94, 0.95, 0.96))
    draw.box("plastic", (-x, -half, 0), (x + 0.015, half, 0.2), (0.93, 0.78, 0.15))
    draw.box("plastic", (-x, -half, h - 0.06), (x + 0.02, half, h), (0.13, 0.25, 0.5), ALL_SIDES)


@builder("kerb_run")
def kerb_run(draw: Drawing, wish: Wish) -> None:
    """A raised kerb of stones a metre long, with the pavement behind it; front to the road."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    stone = 0.16
    draw.box("granite", (x - stone, -half, 0), (x, half, h))
    draw.box(
        "paving", (-x, -half, 0), (x - stone, half, h), None, frozenset({"-x", "+y", "-y", "+z"})
    )


@builder("masking")
def masking(draw: Drawing, wish: Wish) -> None:
    """The end of a bowling alley: a dark opening under a broad painted panel."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    low = min(0.75, 0.4 * h)
    tint = wish.color or (0.16, 0.22, 0.44)
    draw.box("painted", (-x, -half, 0), (x - 0.9 * wish.depth, half, low), (0.03, 0.03, 0.04))
    draw.box("painted", (-x, -half, low), (x, half, h), tint, ALL_SIDES)
    count = max(1, round(wish.width / 2.4))
    for k in range(count + 1):
        y = wish.width * (k / count - 0.5)
        y = min(max(y, -half + 0.06), half - 0.06)
        draw.box("painted", (-x, y - 0.06, 0), (x, y + 0.06, low), (0.2, 0.2, 0.22))
    stripe = (x + 0.01, half, low + 0.18)
    draw.box("painted", (x, -half, low + 0.08), stripe, (0.9, 0.6, 0.2), ALL_SIDES)
