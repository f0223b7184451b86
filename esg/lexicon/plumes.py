"""The table of plumes, `plumes.csv`: smoke, steam, dust and sparks, which leave something."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

from esg.lexicon.shown import Rgb, rgb

TABLE = Path(__file__).parent / "plumes.csv"
Place = Literal["top", "back", "wheels", "foot"]


@dataclass(frozen=True)
class Plume:
    """One row.

    Args:
        name: As statements call it.
        words: That tell of it.
        place: Of its source where it leaves: its top, the end behind, where it touches the ground
            there, or its foot.
        moving: Whether only what moves gives it off.
        rises_mps, spreads_mps: Upwards, and to any side at most [m/s].
        lasts_s: How long a puff is seen [s].
        per_s: Puffs a second.
        first_m, last_m: Radius of a puff at first and at last [m], at least.
        share: Of the source's smaller side on the ground that a puff is wide at first, at least.
        color: sRGB in [0, 1].
        alpha: How dense it is at first.
        glow: Of what gives light; from 1 on it is of small bright pieces.
    """

    name: str
    words: tuple[str, ...]
    place: Place
    moving: bool
    rises_mps: float
    spreads_mps: float
    lasts_s: float
    per_s: float
    first_m: float
    last_m: float
    share: float
    color: Rgb
    alpha: float
    glow: float


@cache
def plumes() -> dict[str, Plume]:
    """Every row by its name."""
    numbers = ("rises_mps", "spreads_mps", "lasts_s", "per_s", "first_m", "last_m", "share")
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {
            r["name"]: Plume(
                r["name"], tuple(r["words"].split(";")), _place(r["from"]), r["moving"] == "yes",
                color=rgb(r["color"]), alpha=float(r["alpha"]), glow=float(r["glow"]),
                **{k: float(r[k]) for k in numbers},
            )
            for r in csv.DictReader(file)
        }  # fmt: skip


def _place(text: str) -> Place:
    for place in ("top", "back", "wheels", "foot"):
        if text == place:
            return place
    raise ValueError(f"{TABLE.name}: no place {text!r}")
