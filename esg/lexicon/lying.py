"""The table of ways in which things lie and stand, `lying.csv`, and what each asks of a shape.

A pose says which of a thing's own axes points up. Which that may be depends on its proportions: a
bottle on its side has its long axis level, a coin on its side is flat, a car has a flank below.
"""

from __future__ import annotations

from collections.abc import Callable
import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path

TABLE = Path(__file__).parent / "lying.csv"
Size = tuple[float, float, float]
Up = tuple[int, int]
"""Index of an own axis, front, left or up, and 1 or -1: the end of it that points up."""
AS_DRAWN: Up = (2, 1)
TIPPED_UP = "tipped up"
"""Stands on the edge of its foot at first, and is let go: it wobbles. No row: no words say it."""
LONG, THIN, ALIKE, ROUND = 3.0, 0.5, 1.3, 1.2
"""Ratios from which on a thing is long as a log or thin as a coin, up to which two sides are as
good as equal, and those of what is round about its length."""
TALL = 1.25
"""So much higher than it is thin, a thing that "lies" does not stand."""


@dataclass(frozen=True)
class Pose:
    """One row.

    Args:
        name: As statements call it.
        words: That tell of it.
        within_deg: By how much the axis that points up may lean.
    """

    name: str
    words: tuple[str, ...]
    within_deg: float


@cache
def poses() -> dict[str, Pose]:
    """Every row by its name."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {
            r["pose"]: Pose(r["pose"], tuple(r["words"].split("|")), float(r["within_deg"]))
            for r in csv.DictReader(file, delimiter=";")
        }


@cache
def pose_said() -> dict[str, str]:
    """Names of poses by the words that tell of them."""
    return {w: row.name for row in poses().values() for w in row.words}


def ups(pose: str, size: Size) -> tuple[Up, ...]:
    """Which own axes may point up in a pose, the likeliest first.

    Args:
        pose: Name of a row.
        size: Extents along the own axes as the thing is drawn; any unit.
    """
    return _UPS[pose](size)


def _axis(size: Size, *, largest: bool) -> int:
    """The longest or shortest axis, upright among equals."""
    order = (2, 0, 1)
    return (max if largest else min)(order, key=lambda k: size[k])


def _others(size: Size, k: int) -> tuple[float, float]:
    a, b = (size[i] for i in range(3) if i != k)
    return min(a, b), max(a, b)


def _lies_as_drawn(size: Size) -> int | None:
    """The axis of what is drawn lying, as logs and pencils are: no side of it is its top."""
    k = _axis(size, largest=True)
    low, high = _others(size, k)
    return k if k != 2 and size[k] >= LONG * high and high <= ROUND * low else None


def _thin(size: Size) -> int | None:
    """The axis of what is as thin as a coin or a book."""
    k = _axis(size, largest=False)
    return k if size[k] <= THIN * _others(size, k)[0] else None


def _ends(*axes: int) -> tuple[Up, ...]:
    return tuple((k, sign) for k in axes for sign in (1, -1))


def _on_its_side(size: Size) -> tuple[Up, ...]:
    thin, long = _thin(size), _lies_as_drawn(size)
    if thin is not None and _alike(_others(size, thin)):
        return _ends(thin)
    if long is not None:
        return _ends(2, 1 - long)
    if _alike((size[0], size[1])):
        return ((1, -1), (1, 1), (0, -1), (0, 1))
    return ((1, -1), (1, 1))


def _alike(sides: tuple[float, float]) -> bool:
    return max(sides) <= ALIKE * min(sides)


def _face(sign: int) -> Callable[[Size], tuple[Up, ...]]:
    """What lies flat as it is drawn shows its top, what stands its front."""

    def of(size: Size) -> tuple[Up, ...]:
        return ((2, sign),) if _axis(size, largest=False) == 2 else ((0, sign),)

    return of


def _on_edge(size: Size) -> tuple[Up, ...]:
    thin = _axis(size, largest=False)
    if thin != 2:
        return (AS_DRAWN, *_ends(*(k for k in (0, 1) if k != thin)), (2, -1))
    low, high = sorted((1, 0), key=lambda k: size[k])
    return ((low, -1), (low, 1), (high, 1), (high, -1))


def _on_end(size: Size) -> tuple[Up, ...]:
    return _ends(_axis(size, largest=True))


def _upright(size: Size) -> tuple[Up, ...]:
    thin, long = _thin(size), _lies_as_drawn(size)
    if long is not None:
        return _ends(long)
    return _ends(_axis(size, largest=True)) if thin == 2 else (AS_DRAWN,)


def _flat(size: Size) -> tuple[Up, ...]:
    k = _axis(size, largest=False)
    if size[2] <= TALL * size[k]:
        return (AS_DRAWN,)
    return _on_its_side(size) if k != 2 and _alike((size[0], size[1])) else _ends(k)


def _overturned(size: Size) -> tuple[Up, ...]:
    """What is low lies on its top, what is tall on its side."""
    over: tuple[Up, ...] = ((2, -1),)
    tall = size[2] > TALL * min(size[:2])
    return tuple(dict.fromkeys((*_tipped(size), *over) if tall else (*over, *_tipped(size))))


def _tipped(size: Size) -> tuple[Up, ...]:
    if _lies_as_drawn(size) is not None or _thin(size) == 2:
        return _ends(2, 1, 0)  # whatever befell it, it lies as it can
    return tuple(dict.fromkeys((*_on_its_side(size), *_ends(1, 0))))


_UPS: dict[str, Callable[[Size], tuple[Up, ...]]] = {
    "on its side": _on_its_side,
    "upside down": lambda _: ((2, -1),),
    "on its roof": lambda _: ((2, -1),),
    "face down": _face(-1),
    "face up": _face(1),
    "on its back": _face(1),
    "on its edge": _on_edge,
    "on end": _on_end,
    "upright": _upright,
    "flat": _flat,
    "overturned": _overturned,
    "tipped over": _tipped,
}
