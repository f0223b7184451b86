"""What stands where: things in rows along the sides of the action, walls, and here and there.

Every thing is tried at a seeded place and stands only where it is clear of all paths, of what lies
on the ground and of what stands already.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
import itertools
import math
from typing import TypeVar

import numpy as np

from esg.dressing.builders import BUILDERS
from esg.dressing.clearance import KEEP_M, Box, Clearance
from esg.graph.models import DressingItem, Marking
from esg.lexicon import kinds
from esg.lexicon.kinds import Size
from esg.lexicon.places import Drawn, Place, Span, Standing, drawn, standing
from esg.units import CM_PER_M

_T = TypeVar("_T")
TRIES = 10
MOST_ITEMS = 48
RUN_STEP_M = 0.5
MOST_RUN_M = 90.0
"""A row of things goes no farther than this from its middle."""
BEYOND_M = 70.0
"""How far what is drawn along a side goes on beyond it."""
WATER = "water"
"""The surface on which nothing stands but what floats."""
FLAT_M = 0.2
"""What is lower shares its place with others: a kerb, a mat."""
TALL_M = 1.0
"""What is higher does not stand in front of a window."""
WALL_M = 0.12
LARGE_ROOM_M, LARGE_HEIGHT_M = 15.0, 4.6
"""A room with a side so long is so high."""
HEADROOM_M = 0.6
NORMALS = {"+x": (1.0, 0.0), "-x": (-1.0, 0.0), "+y": (0.0, 1.0), "-y": (0.0, -1.0)}


@dataclass(frozen=True)
class Ban:
    """Things that would be taken for one of the scene's.

    Args:
        kinds: Categories of the library that must not appear.
        near: By category, how far away [m] the bodies keep them.
    """

    kinds: frozenset[str]
    near: dict[str, float]


@dataclass
class Site:
    """A place while it is being dressed.

    Args:
        place: What kind of place.
        clear: What to keep away from, in the frame of the place.
        rect: The action's rectangle, or the street's, or the room.
        height: Of the room [m].
        viewer: Unit vector in the frame's plane from the action to where one looks from.
        axis: Box of the thing along which the place is laid out; None if there is none.
        ban: What must not appear.
        rng: Of every choice.
    """

    place: Place
    clear: Clearance
    rect: Box
    height: float
    viewer: tuple[float, float]
    axis: Box | None
    ban: Ban
    rng: np.random.Generator
    items: list[DressingItem] = field(default_factory=list[DressingItem])
    hung: list[Box] = field(default_factory=list[Box])
    """What hangs on walls, and what is so tall that it would hide it."""
    water: list[Box] = field(default_factory=list[Box])
    """Where only boats are."""
    walls: dict[str, str] = field(default_factory=dict[str, str])
    """Builder of the wall on each side of a room."""
    wall_ids: dict[str, str] = field(default_factory=dict[str, str])
    counts: dict[str, int] = field(default_factory=dict[str, int])
    factors: dict[str, float] = field(default_factory=dict[str, float])
    """Sizes of things of the library; alike things of a place are built once."""
    styles: dict[str, tuple[float, float, float]] = field(
        default_factory=dict[str, tuple[float, float, float]]
    )
    """Colours drawn for what is of one colour all over a place: walls, fences."""


@dataclass(frozen=True)
class Rail:
    """A line along one side, on which things stand.

    Args:
        side: Name of the side.
        normal: Away from the action.
        middle: Of the side.
        length: Of the side [m].
    """

    side: str
    normal: tuple[float, float]
    middle: tuple[float, float]
    length: float

    def at(self, along: float, out: float) -> tuple[float, float]:
        """A point beside it: `along` it from its middle, `out` away from the action [m]."""
        (nx, ny), (x, y) = self.normal, self.middle
        return x + out * nx - along * ny, y + out * ny + along * nx


def arrange(site: Site) -> tuple[tuple[Marking, ...], tuple[DressingItem, ...]]:
    """Puts up everything that the tables want in a place.

    Args:
        site: An empty place.

    Returns:
        What is drawn on its ground and what stands in it, in the world [cm].
    """
    flats = _markings(site)
    site.water += [box for marking, box in flats if marking.surface == WATER]
    rows = standing(site.place.name)
    _walls(site, [row for row in rows if row.where == "wall"])
    rest = [row for row in rows if row.where != "wall"]
    for _, family in itertools.groupby(rest, key=lambda r: (r.where, r.sides, r.away_m)):
        members = list(family)
        if members[0].where == "run":
            _run(site, members)
            continue
        for row in members:
            _scattered(site, row)
    return tuple(marking for marking, _ in flats), tuple(site.items)


def rails(site: Site, sides: str) -> list[Rail]:
    """The sides that a word of the tables means."""
    toward = {name: n[0] * site.viewer[0] + n[1] * site.viewer[1] for name, n in NORMALS.items()}
    front, back = max(toward, key=lambda k: toward[k]), min(toward, key=lambda k: toward[k])
    named = {
        "all": list(NORMALS),
        "long": ["+y", "-y"],
        "ends": ["+x", "-x"],
        "front": [front],
        "back": [back],
        "rest": [name for name in NORMALS if name != front],
    }
    (x, y), (a, b) = site.rect.middle, site.rect.size
    out: list[Rail] = []
    for name in named.get(sides, [sides]):
        nx, ny = NORMALS[name]
        middle = (x + 0.5 * a * nx, y + 0.5 * b * ny)
        out.append(Rail(name, (nx, ny), middle, abs(a * ny) + abs(b * nx)))
    return out


def _walls(site: Site, rows: list[Standing]) -> None:
    """One wall a side; of several kinds that a side may have, one by weight."""
    for rail in rails(site, "all"):
        fit = [r for r in rows if rail in rails(site, r.sides)]
        if not fit:
            continue
        weights = np.array([row.chance for row in fit])
        row = fit[int(site.rng.choice(len(fit), p=weights / weights.sum()))]
        size = (WALL_M, rail.length, site.height)
        box = _box(rail.at(0.0, 0.5 * WALL_M), size, rail.normal)
        if _put(site, row, box.middle, size, _yaw(rail, "in", site.rng), box, keep=KEEP_M):
            site.walls[rail.side] = row.item
            site.wall_ids[rail.side] = site.items[-1].id
            door = BUILDERS[row.item].door
            if door is not None:
                # The wall's own Y runs against the rail: its front looks back at the action.
                step = Box.around(rail.at(door * -rail.length, -0.6), (1.3, 1.3))
                site.clear.placed.append((step, 0.0))


def _run(site: Site, rows: list[Standing]) -> None:
    """Things end to end along a side, as near to it as most of them can stand."""
    low, high = rows[0].away_m
    for rail in rails(site, rows[0].sides):
        if float(site.rng.random()) >= rows[0].chance:
            continue
        wanted = _lined(site, rows, rail)
        best: list[Member] = []
        nearest = low
        for away in np.arange(low, high + 1e-6, RUN_STEP_M):
            fit = [m for m in wanted if _fits(site, m.row, _member_box(m, rail, away), m.size)]
            if len(fit) > len(best):
                best, nearest = fit, float(away)
        for member in _joined(best):
            box = _member_box(member, rail, nearest)
            yaw = _yaw(rail, member.row.facing, site.rng)
            if len(site.items) < MOST_ITEMS:
                _put(site, member.row, box.middle, member.size, yaw, box)


@dataclass(frozen=True)
class Member:
    """One of a row: where its middle is along the side [m], and its extents [m]."""

    row: Standing
    along: float
    size: tuple[float, float, float]


def _lined(site: Site, rows: list[Standing], rail: Rail) -> list[Member]:
    """Things side by side from the middle of a side outwards, until it or they end."""
    counts = np.array([float(row.count[1]) for row in rows])
    half = min(0.5 * rail.length + rows[0].away_m[1], MOST_RUN_M)
    out: list[Member] = []
    ends = [0.0, 0.0]
    for number in range(int(counts.sum())):
        row = rows[int(site.rng.choice(len(rows), p=counts / counts.sum()))]
        size = _size(site, row)
        width = size[0] if row.facing == "along" else size[1]
        side = number % 2
        if number == 0:
            ends = [0.5 * width + row.gap_m] * 2
            out.append(Member(row, 0.0, size))
        elif ends[side] + width <= half:
            along = (ends[side] + 0.5 * width) * (1 if side else -1)
            ends[side] += width + row.gap_m
            out.append(Member(row, along, size))
    return out


def _member_box(member: Member, rail: Rail, away: float) -> Box:
    facing = member.row.facing
    deep = member.size[1] if facing == "along" else member.size[0]
    middle = rail.at(member.along, away + 0.5 * deep)
    return _box(middle, member.size, _turned(rail.normal, facing))


def _joined(members: list[Member]) -> Iterator[Member]:
    """Neighbours of one size without a gap become one longer thing."""
    done = sorted(members, key=lambda m: m.along)
    k = 0
    while k < len(done):
        first = done[k]
        width = first.size[1]
        low, high = first.along - 0.5 * width, first.along + 0.5 * width
        while (
            _fixed(first.row)
            and first.row.gap_m == 0.0
            and k + 1 < len(done)
            and done[k + 1].row is first.row
            and done[k + 1].along - 0.5 * width - high < 1e-6
        ):
            k += 1
            high = done[k].along + 0.5 * width
        yield Member(first.row, 0.5 * (low + high), (first.size[0], high - low, first.size[2]))
        k += 1


def _scattered(site: Site, row: Standing) -> None:
    """So many of a thing, each at the first of some places where it fits."""
    if float(site.rng.random()) >= row.chance:
        return
    for _ in range(int(site.rng.integers(row.count[0], row.count[1] + 1))):
        for _ in range(TRIES):
            size = _size(site, row)
            spot = _spot(site, row, size)
            if spot is None:
                return
            middle, yaw, box, side = spot
            if _fits(site, row, box, size) and _put(site, row, middle, size, yaw, box, side=side):
                break


def _spot(
    site: Site, row: Standing, size: tuple[float, float, float]
) -> tuple[tuple[float, float], float, Box, str] | None:
    """Where a thing that is in no row goes: middle, yaw in the frame, box, side of its wall."""
    rng = site.rng
    choices = rails(site, row.sides)
    if row.where in ("ring", "water"):
        return _in_ring(site, row, size)
    if row.where in ("against", "hung"):
        bare = [r for r in choices if BUILDERS[site.walls[r.side]].bare] if site.walls else []
        if row.where == "hung" or (bare and size[2] > TALL_M):
            choices = bare
    if not choices:
        return None
    rail = choices[int(rng.integers(len(choices)))]
    normal = _turned(rail.normal, row.facing)
    deep = size[1] if row.facing == "along" else size[0]
    wide = size[0] if row.facing == "along" else size[1]
    away = float(rng.uniform(*row.away_m))
    out = -(away + 0.5 * deep) if row.where in ("against", "hung") else away + 0.5 * deep
    room = max(0.0, 0.5 * (rail.length - wide) - 0.15)
    along = float(rng.uniform(-room, room))
    box = _box(rail.at(along, out), size, normal)
    at_wall = rail.side if row.where in ("against", "hung") else ""
    return box.middle, _yaw(rail, row.facing, rng), box, at_wall


def _in_ring(
    site: Site, row: Standing, size: tuple[float, float, float]
) -> tuple[tuple[float, float], float, Box, str] | None:
    rng = site.rng
    near, far = row.away_m
    inner, outer = site.rect.grown(near), site.rect.grown(far)
    allowed = {r.side for r in rails(site, row.sides)}
    x, y = float(rng.uniform(outer.x0, outer.x1)), float(rng.uniform(outer.y0, outer.y1))
    for _ in range(20):
        beyond = {"+x": x - inner.x1, "-x": inner.x0 - x, "+y": y - inner.y1, "-y": inner.y0 - y}
        side = max(beyond, key=lambda k: beyond[k])
        if beyond[side] > 0 and side in allowed:
            break
        x, y = float(rng.uniform(outer.x0, outer.x1)), float(rng.uniform(outer.y0, outer.y1))
    else:
        return None
    mx, my = site.rect.middle
    inward = math.atan2(my - y, mx - x)
    turns = {"in": inward, "out": inward + math.pi, "along": inward + math.pi / 2}
    yaw = turns.get(row.facing, float(rng.uniform(-math.pi, math.pi)))
    if row.facing == "either":
        yaw = inward + math.pi * int(rng.integers(2))
    c, s = abs(math.cos(yaw)), abs(math.sin(yaw))
    box = Box.around((x, y), (c * size[0] + s * size[1], s * size[0] + c * size[1]))
    return (x, y), yaw, box, ""


def _fits(site: Site, row: Standing, box: Box, size: tuple[float, float, float]) -> bool:
    if len(site.items) >= MOST_ITEMS:
        return False
    categories = {row.item, *(BUILDERS[row.item].like if row.item in BUILDERS else ())}
    if categories & site.ban.kinds:
        return False
    keep = max([KEEP_M, *(site.ban.near[c] for c in categories if c in site.ban.near)])
    if not site.clear.free(box, keep):
        return False
    if row.where == "hung":
        return all(box.to(h) >= row.gap_m for h in site.hung) and _inside(box, site.rect)
    if site.walls and not _inside(box, site.rect):
        return False
    wet = [w for w in site.water if box.to(w) < 0.0]
    if row.where == "water":
        return any(_inside(box, w) for w in wet)
    if wet:
        return False
    return size[2] <= FLAT_M or site.clear.open(box, row.gap_m)


def _put(
    site: Site,
    row: Standing,
    middle: tuple[float, float],
    size: tuple[float, float, float],
    yaw: float,
    box: Box,
    *,
    keep: float = 0.0,
    side: str = "",
) -> bool:
    """Enters a thing that fits; with `keep`, only if it is so far from all paths [m]."""
    if keep and not site.clear.free(box, keep):
        return False
    if size[2] > FLAT_M and row.where not in ("hung", "wall"):
        site.clear.placed.append((box, row.gap_m))
    if row.where == "hung" or (row.where != "wall" and size[2] > TALL_M):
        site.hung.append(box)
    x, y = site.clear.frame.out(middle)
    site.counts[row.item] = site.counts.get(row.item, 0) + 1
    turned = math.degrees(yaw + site.clear.frame.yaw)
    site.items.append(
        DressingItem(
            id=f"{row.item}_{site.counts[row.item]}",
            kind=row.item,
            position_cm=(_cm(x), _cm(y), 0.0),
            yaw_deg=round((turned + 180.0) % 360.0 - 180.0, 2),
            size_cm=(_cm(size[0]), _cm(size[1]), _cm(size[2])),
            surface=_one(row.surfaces, site.rng) if row.surfaces else None,
            color_rgb=_color(site, row),
            wall=site.wall_ids.get(side),
            variant=int(site.rng.integers(1 << 16)),
        )
    )
    return True


def _color(site: Site, row: Standing) -> tuple[float, float, float] | None:
    """One of a row's colours; walls, and rows without gaps, have one all over a place."""
    if not row.colors:
        return None
    whole = row.where == "run" and row.gap_m == 0.0 and _fixed(row)
    if row.where != "wall" and not whole:
        return _rounded(_one(row.colors, site.rng))
    key = "wall" if row.where == "wall" else row.item
    if key not in site.styles:
        site.styles[key] = _rounded(_one(row.colors, site.rng))
    return site.styles[key]


def _fixed(row: Standing) -> bool:
    """Whether everything of a row has one size."""
    return row.size_m is not None and all(low == high for low, high in row.size_m)


def _rounded(color: tuple[float, float, float]) -> tuple[float, float, float]:
    r, g, b = (round(c, 4) for c in color)
    return r, g, b


def _one(values: Sequence[_T], rng: np.random.Generator) -> _T:
    return values[int(rng.integers(len(values)))]


def _size(site: Site, row: Standing) -> tuple[float, float, float]:
    """Extents of a thing [m]."""
    if row.size_m is not None:
        a, b, c = (_within(span, site.rng) for span in row.size_m)
        return a, b, c
    factor = site.factors.setdefault(row.item, round(float(site.rng.uniform(0.95, 1.08)), 2))
    a, b, c = (factor * d / CM_PER_M for d in _usual_sizes()[row.item])
    return a, b, c


@cache
def _usual_sizes() -> dict[str, Size]:
    """Of what the library draws [cm]."""
    return {kind.slug: kind.local_cm for kind in kinds() if kind.builder}


def _within(span: Span, rng: np.random.Generator) -> float:
    return round(float(rng.uniform(*span)), 2)


def _turned(normal: tuple[float, float], facing: str) -> tuple[float, float]:
    return (-normal[1], normal[0]) if facing == "along" else normal


def _yaw(rail: Rail, facing: str, rng: np.random.Generator) -> float:
    """Of a thing beside a rail, in the frame [rad]."""
    out = math.atan2(rail.normal[1], rail.normal[0])
    turns = {"in": math.pi, "out": 0.0, "along": 0.5 * math.pi}
    turn = turns.get(facing)
    if turn is None:
        turn = math.pi * int(rng.integers(2))
    return out + turn


def _box(
    middle: tuple[float, float], size: tuple[float, float, float], normal: tuple[float, float]
) -> Box:
    """Of a thing whose front axis lies along a normal of the frame's axes."""
    along_x = abs(normal[0]) > 0.5
    return Box.around(middle, (size[0], size[1]) if along_x else (size[1], size[0]))


def _inside(box: Box, room: Box) -> bool:
    wide = room.grown(0.01)
    return wide.union(box) == wide


def _cm(metres: float) -> float:
    return round(CM_PER_M * metres, 1)


def _markings(site: Site) -> list[tuple[Marking, Box]]:
    """What is drawn on the ground, with the box of each in the frame."""
    out: list[tuple[Marking, Box]] = []
    for row in drawn(site.place.name):
        for middle, half in _flats(site, row):
            x, y = site.clear.frame.out(middle)
            marking = Marking(
                surface=row.surface,
                center_cm=(_cm(x), _cm(y)),
                half_cm=(_cm(half[0]), _cm(half[1])),
                yaw_deg=round(math.degrees(site.clear.frame.yaw), 2),
                shape=row.shape,
                line_cm=row.line_cm or None,
                layer=row.layer,
            )
            out.append((marking, Box.around(middle, (2 * half[0], 2 * half[1]))))
    return out


def _flats(site: Site, row: Drawn) -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
    """Middles and half extents of what a row draws, in the frame [m]."""
    if row.sides in ("axis", "beside"):
        yield from _by_axis(site, row)
        return
    if row.sides == "middle":
        base = site.axis or site.rect
        across = 0.5 * (row.width_m or base.size[1])
        along = 0.5 * (row.length_m or base.size[0] + 2 * BEYOND_M)
        for k in range(row.repeat):
            x = base.middle[0] + 4.0 * along * (k - 0.5 * (row.repeat - 1))
            yield (x, base.middle[1]), (along, across)
        return
    for rail in rails(site, row.sides):
        # The strips along Y end where those along X begin, so that nothing is drawn twice.
        corner = row.away_m + (row.width_m if abs(rail.normal[1]) > 0.5 else 0.0)
        around = row.sides == "all"
        long = row.length_m or rail.length + 2 * (corner if around else BEYOND_M)
        for k in range(row.repeat):
            along = long * (k - 0.5 * (row.repeat - 1))
            middle = rail.at(along, row.away_m + 0.5 * row.width_m)
            half = (0.5 * row.width_m, 0.5 * long)
            yield middle, half if abs(rail.normal[0]) > 0.5 else (half[1], half[0])


def _by_axis(site: Site, row: Drawn) -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
    """What is drawn before the thing along which a place is laid out, or on both sides of it."""
    if site.axis is None:
        return
    (x, y), (a, b) = site.axis.middle, site.axis.size
    if row.sides == "axis":
        yield (x + row.away_m, y), (0.5 * row.length_m, 0.5 * row.width_m)
        return
    for sign in (1.0, -1.0):
        across = y + sign * (0.5 * b + row.away_m + 0.5 * row.width_m)
        yield (x, across), (0.5 * (row.length_m or a), 0.5 * row.width_m)


def room_of(place: Place, clear: Clearance, viewer: tuple[float, float]) -> tuple[Box, float]:
    """The floor of a room around everything that is swept, and its height [m]."""
    box = clear.reach.grown(max(place.clear_m, KEEP_M + WALL_M)).at_least(place.least_m)
    # A little more towards the viewer, who often stands inside.
    dx, dy = (1.5 * v if abs(v) > 0.5 else 0.0 for v in viewer)
    box = box.union(replace(box, x0=box.x0 + dx, x1=box.x1 + dx, y0=box.y0 + dy, y1=box.y1 + dy))
    height = max(place.height_m, clear.top + HEADROOM_M)
    if max(box.size) > LARGE_ROOM_M:
        height = max(height, LARGE_HEIGHT_M)
    return box, round(height, 2)
