"""What can be lit, falls from the sky and sways in the wind: tables with their sources."""

from __future__ import annotations

from collections.abc import Iterable
import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
import re
from typing import Literal

Rgb = tuple[float, float, float]

LIVELY = {"heavy": 1.7, "thick": 1.5, "dense": 1.5, "strong": 1.5, "light": 0.5, "gentle": 0.6}
"""What such words do to how much falls, or how far something sways."""
_STATES = re.compile(
    r"(?P<light>.+?) (?P<turned>turned )?(?P<how>on|off|flashing)(?: (?P<color>[\w ]+))?"
)


@dataclass(frozen=True)
class Light:
    """A row of `lights.csv`.

    Args:
        name: Of the row.
        words: How a prompt calls the light of its owner.
        of: Kinds that have it; "@vehicle" is all that have wheels.
        parts: How the names of parts of its model begin that shine; none of what burns.
        color: Usual colour, sRGB in [0, 1].
        flame: Whether flames are drawn on it.
    """

    name: str
    words: tuple[str, ...]
    of: frozenset[str]
    parts: tuple[str, ...]
    color: Rgb
    flame: bool


@dataclass(frozen=True)
class Weather:
    """A row of `weathers.csv`; of fog only the last two say something.

    Args:
        name: Of the row.
        said_as: Words that tell of it.
        falls_mps, drifts_mps: Downwards, and to the side [m/s].
        per_m3: Streaks or flakes.
        size_cm: Length along the fall, and width.
        color: sRGB in [0, 1].
        sight_m: Distance at which things are mostly gone.
        not_shown: What the words say beyond it.
    """

    name: str
    said_as: tuple[str, ...]
    falls_mps: float
    drifts_mps: float
    per_m3: float
    size_cm: tuple[float, float]
    color: Rgb
    sight_m: float
    not_shown: str


@dataclass(frozen=True)
class Sway:
    """How parts of a body's model sway in the wind; a row of `swaying.csv`.

    Args:
        how: "bends" about its foot, or "waves" along its length.
        parts: How the names of the parts begin that do; all if empty.
        degrees: Largest angle.
        period_s: Of one sway [s].
    """

    how: Literal["bends", "waves"]
    parts: tuple[str, ...]
    degrees: float
    period_s: float


@cache
def lights() -> dict[str, Light]:
    """All rows of `lights.csv` by name."""
    return {
        r["name"]: Light(
            r["name"], _list(r["words"]), frozenset(_list(r["of"])), _list(r["parts"]),
            rgb(r["color"]), r["kind"] == "flame",
        )
        for r in _rows("lights")
    }  # fmt: skip


@cache
def weathers() -> dict[str, Weather]:
    """All rows of `weathers.csv` by name."""

    def number(row: dict[str, str], key: str) -> float:
        return float(row[key] or 0)

    return {
        r["name"]: Weather(
            r["name"],
            _list(r["said_as"]),
            number(r, "falls_mps"),
            number(r, "drifts_mps"),
            number(r, "per_m3"),
            (number(r, "length_cm"), number(r, "width_cm")),
            rgb(r["color"] or "#ffffff"),
            number(r, "sight_m"),
            r["not_shown"],
        )
        for r in _rows("weathers")
    }


@cache
def swaying() -> dict[str, Sway]:
    """Rows of `swaying.csv` by the kinds that they are of."""
    return {
        name: Sway(
            "waves" if r["how"] == "waves" else "bends",
            _list(r["parts"]),
            float(r["degrees"]),
            float(r["period_s"]),
        )
        for r in _rows("swaying")
        for name in _list(r["names"])
    }  # fmt: skip


def lights_of(names: Iterable[str], *, wheeled: bool) -> list[Light]:
    """The lights that something has.

    Args:
        names: Of its kind, and how it is called.
        wheeled: Whether it has wheels.
    """
    own = {*names, *(("@vehicle",) if wheeled else ())}
    return [row for row in lights().values() if own & row.of]


def read_lit(noun: str) -> tuple[Light, bool, str, str] | None:
    """What a statement of `lit` says: the light, whether it changes, on, off or flashing, colour.

    Args:
        noun: "headlights flashing blue", "lamp turned off".

    Returns:
        None if no row of the table of lights is named so.
    """
    m = _STATES.fullmatch(noun)
    if m is None or m["light"] not in lights():
        return None
    return lights()[m["light"]], bool(m["turned"]), m["how"], m["color"] or ""


def weather_of(noun: str) -> tuple[Weather, float] | None:
    """The weather that a statement names, and how much of it there is; None if there is none."""
    *how, name = noun.split()
    row = weathers().get(name)
    return None if row is None else (row, next((LIVELY[w] for w in how if w in LIVELY), 1.0))


def rgb(text: str) -> Rgb:
    """sRGB in [0, 1] of "#rrggbb"."""
    red, green, blue = (int(text[k : k + 2], 16) / 255.0 for k in (1, 3, 5))
    return red, green, blue


def _list(text: str) -> tuple[str, ...]:
    return tuple(w for w in text.split(";") if w)


def _rows(name: str) -> list[dict[str, str]]:
    path = Path(__file__).with_name(f"{name}.csv")
    with path.open(encoding="utf-8", newline="") as file:
        return [*csv.DictReader(file)]
