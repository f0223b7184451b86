"""Racks, counters, lockers, stands: what lines the edges of rooms, halls and pitches."""

from __future__ import annotations

from esg.assets.looks import Color
from esg.dressing.builders.table import Wish, builder
from esg.dressing.solids import ALL_SIDES, Drawing

CARTONS: tuple[Color, ...] = ((0.72, 0.56, 0.38), (0.66, 0.5, 0.33), (0.76, 0.62, 0.45))
WHITE: Color = (0.9, 0.9, 0.88)


@builder("pallet_rack")
def pallet_rack(draw: Drawing, wish: Wish) -> None:
    """Shelving of a warehouse with cartons on its levels."""
    x, h = 0.5 * wish.depth, wish.height
    blue, orange = (0.13, 0.26, 0.5), (0.85, 0.42, 0.12)
    bays = max(1, round(wish.width / 2.7))
    bay = wish.width / bays
    levels = max(2, round(h / 1.5))
    for k in range(bays + 1):
        y = -0.5 * wish.width + bay * k
        y = min(max(y, -0.5 * wish.width + 0.05), 0.5 * wish.width - 0.05)
        for at in (-x, x - 0.08):
            draw.box("painted", (at, y - 0.05, 0), (at + 0.08, y + 0.05, h), blue)
    for level in range(levels):
        z = 0.12 + (h - 0.3) * level / levels
        for at in (-x, x - 0.05):
            low, high = (at, -0.5 * wish.width, z - 0.1), (at + 0.05, 0.5 * wish.width, z)
            draw.box("painted", low, high, orange, ALL_SIDES)
        draw.sheet("planks", (-x, -0.5 * wish.width, z), (wish.depth, 0, 0), (0, wish.width, 0))
        for k in range(bays):
            _cartons(draw, (-0.5 * wish.width + bay * k, bay), z, x, (h - 0.3) / levels)


def _cartons(draw: Drawing, bay: tuple[float, float], z: float, half: float, room: float) -> None:
    start, width = bay
    at = start + 0.15
    while at < start + width - 0.45:
        wide = float(draw.rng.uniform(0.45, 0.95))
        if at + wide > start + width - 0.12:
            return
        if draw.rng.random() < 0.82:
            tall = float(draw.rng.uniform(0.35, 0.75)) * room
            deep = half * float(draw.rng.uniform(0.7, 0.95))
            color = CARTONS[int(draw.rng.integers(len(CARTONS)))]
            draw.box("cardboard", (-deep, at, z), (deep, at + wide, z + tall), color)
        at += wide + 0.08


@builder("kitchen_run", "counter")
def kitchen_run(draw: Drawing, wish: Wish) -> None:
    """Base units with a worktop, tiles and wall units above; back to the wall."""
    x, half = 0.5 * wish.depth, 0.5 * wish.width
    front = wish.color or (0.82, 0.84, 0.8)
    draw.box("painted", (-x, -half, 0.1), (x - 0.02, half, 0.86), front)
    draw.box("painted", (-x, -half, 0), (x - 0.08, half, 0.1), (0.2, 0.2, 0.2))
    draw.box("worktop", (-x, -half, 0.86), (x + 0.02, half, 0.9), (0.35, 0.34, 0.33), ALL_SIDES)
    if wish.height > 1.5:
        back = -x + 0.01
        draw.sheet("tiles_white", (back, -half, 0.9), (0, wish.width, 0), (0, 0, 0.55))
        high = (-x + 0.35, half, wish.height)
        draw.box("painted", (-x, -half, 1.45), high, front, ALL_SIDES)
    count = max(1, round(wish.width / 0.6))
    for k in range(count):
        y = -half + wish.width * k / count
        wide = wish.width / count
        low, top = (x - 0.02, y + 0.008, 0.12), (x, y + wide - 0.008, 0.85)
        draw.box("painted", low, top, front, ALL_SIDES - {"-x"})
        knob = (x, y + 0.5 * wide - 0.07, 0.76), (x + 0.025, y + 0.5 * wide + 0.07, 0.78)
        draw.box("steel", *knob, None, ALL_SIDES - {"-x"})


@builder("lockers", "cabinet")
def lockers(draw: Drawing, wish: Wish) -> None:
    """A row of lockers."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    tint = wish.color or (0.35, 0.45, 0.55)
    draw.box("painted", (-x, -half, 0), (x - 0.02, half, h), (0.3, 0.32, 0.34))
    count = max(1, round(wish.width / 0.4))
    for k in range(count):
        y, wide = -half + wish.width * k / count, wish.width / count
        low, high = (x - 0.02, y + 0.01, 0.08), (x, y + wide - 0.01, h - 0.03)
        draw.box("painted", low, high, tint, ALL_SIDES - {"-x"})
        for z in (0.88, 0.91, 0.94):
            low, high = (x, y + 0.3 * wide, z * h), (x + 0.004, y + 0.7 * wide, z * h + 0.012)
            draw.box("painted", low, high, (0.15, 0.16, 0.18), ALL_SIDES - {"-x"})


@builder("wall_bars")
def wall_bars(draw: Drawing, wish: Wish) -> None:
    """Bars to climb on, as in a school's gym."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    frames = max(1, round(wish.width / 0.95))
    for k in range(frames + 1):
        y = min(max(-half + wish.width * k / frames, -half + 0.03), half - 0.03)
        draw.box("varnished", (-x, y - 0.03, 0), (x - 0.04, y + 0.03, h))
    bars = max(4, round(h / 0.18))
    for k in range(1, bars):
        z = h * k / bars
        low, high = (x - 0.05, -half, z - 0.018), (x, half, z + 0.018)
        draw.box("varnished", low, high, None, ALL_SIDES)


@builder("grandstand")
def grandstand(draw: Drawing, wish: Wish) -> None:
    """Steps with rows of seats."""
    x, half = 0.5 * wish.depth, 0.5 * wish.width
    steps = max(2, round(wish.depth / 0.85))
    tread, rise = wish.depth / steps, wish.height / steps
    seat = wish.color or (0.16, 0.32, 0.58)
    for k in range(steps):
        front = x - tread * k
        top = rise * (k + 0.6)
        low, high = (front - tread, -half, 0.0), (front, half, top)
        draw.box("concrete", low, high, None, frozenset({"+x", "+z", "+y", "-y"}))
        low, high = (front - 0.75 * tread, -half, top), (front - 0.35 * tread, half, top + 0.4)
        draw.box("plastic", low, high, seat)
        back = (front - 0.75 * tread, -half, top + 0.4), (front - 0.68 * tread, half, top + 0.75)
        draw.box("plastic", *back, seat)
    draw.box("concrete", (-x, -half, 0), (-x + 0.15, half, wish.height + 1.0), None)


@builder("notice_board")
def notice_board(draw: Drawing, wish: Wish) -> None:
    """A board on a wall, its bottom at the height where boards hang."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    low, high = (-x, -half, h - 1.2), (x, half, h)
    draw.box("painted", low, high, (0.5, 0.4, 0.28), ALL_SIDES - {"-x"})
    low, high = (x, -half + 0.05, h - 1.15), (x + 0.005, half - 0.05, h - 0.05)
    draw.box("plastic", low, high, wish.color or (0.13, 0.28, 0.22), ALL_SIDES - {"-x"})


@builder("wall_picture", "picture")
def wall_picture(draw: Drawing, wish: Wish) -> None:
    """A framed picture, hung with its middle at eye height."""
    half, h = 0.5 * wish.width, wish.height
    back = -0.5 * wish.depth
    low, high = (back, -half, 1.55 - 0.5 * h), (back + 0.03, half, 1.55 + 0.5 * h)
    draw.box("varnished", low, high, None, ALL_SIDES - {"-x"})
    tint = wish.color or (0.45, 0.52, 0.55)
    edge = 0.06
    corner = (back + 0.031, -half + edge, low[2] + edge)
    draw.sheet("paper", corner, (0, wish.width - 2 * edge, 0), (0, 0, h - 2 * edge), WHITE)
    inner = 0.11
    corner = (back + 0.033, -half + inner, low[2] + inner)
    draw.sheet("paper", corner, (0, wish.width - 2 * inner, 0), (0, 0, h - 2 * inner), tint)


@builder("ball_return")
def ball_return(draw: Drawing, wish: Wish) -> None:
    """Where bowling balls come back."""
    x, half, h = 0.5 * wish.depth, 0.5 * wish.width, wish.height
    draw.box("plastic", (-x, -half, 0), (x, half, 0.55 * h), (0.2, 0.2, 0.23))
    draw.box("steel", (-x, -half, 0.55 * h), (x, half, 0.6 * h))
    for k, color in enumerate(((0.5, 0.1, 0.3), (0.1, 0.3, 0.5), (0.1, 0.4, 0.2))):
        at = (-0.6 * x + 0.6 * x * k, 0.0, 0.6 * h + 0.105)
        draw.clump("plastic", at, (0.108, 0.108, 0.108), color, rough=0.0)


@builder("containers", "shipping_container")
def containers(draw: Drawing, wish: Wish) -> None:
    """A stack of shipping containers, their long sides to the front."""
    colors = (
        (0.55, 0.2, 0.15),
        (0.15, 0.32, 0.5),
        (0.2, 0.42, 0.28),
        (0.75, 0.5, 0.18),
        (0.5, 0.52, 0.54),
    )
    x, long, tall = 0.5 * wish.depth, 6.06, 2.59
    across, up = max(1, int(wish.width / (long + 0.1))), max(1, round(wish.height / tall))
    for i in range(across):
        y = (long + 0.1) * (i - 0.5 * (across - 1))
        for k in range(int(draw.rng.integers(1, up + 1))):
            color = colors[int(draw.rng.integers(len(colors)))]
            low, high = (-x, y - 0.5 * long, tall * k), (x, y + 0.5 * long, tall * (k + 1) - 0.02)
            draw.box("sheet_metal", low, high, color, ALL_SIDES)
            for at in (low[1], high[1] - 0.12):
                post = (x, at, low[2]), (x + 0.03, at + 0.12, high[2])
                draw.box("painted", *post, color, ALL_SIDES - {"-x"})


@builder("warehouse_cartons", "box")
def warehouse_cartons(draw: Drawing, wish: Wish) -> None:
    """Cartons on a pallet."""
    x, half = 0.5 * wish.depth, 0.5 * wish.width
    for k in range(3):
        y = -half + (wish.width - 0.1) * k / 2
        draw.box("planks", (-x, y, 0), (x, y + 0.1, 0.1))
    draw.box("planks", (-x, -half, 0.1), (x, half, 0.14), None, ALL_SIDES)
    layers = max(1, int((wish.height - 0.14) / 0.38))
    for layer in range(layers):
        z = 0.14 + 0.38 * layer
        for i in range(2):
            for k in range(2):
                color = CARTONS[int(draw.rng.integers(len(CARTONS)))]
                low = (-x + wish.depth * i / 2 + 0.01, -half + wish.width * k / 2 + 0.01, z)
                high = (low[0] + wish.depth / 2 - 0.02, low[1] + wish.width / 2 - 0.02, z + 0.375)
                draw.box("cardboard", low, high, color)
