"""Clocks that jump while a command runs: its result is that of an undisturbed run."""

from __future__ import annotations

from pathlib import Path
import random
import time

from benchmarks.faults.ground import esg
from benchmarks.faults.kills import arguments, difference, facts, prepared_copy, undisturbed
from benchmarks.faults.shims import compiled

HEADS = ("command", "jump", "exit code", "wrong")
_DAY_S = 86400
JUMPS = {
    "an hour back": -3600,
    "a day ahead": _DAY_S,
    "to 1980": -46 * 365 * _DAY_S,
    "70 years ahead": 70 * 365 * _DAY_S,
}
"""What is added to the time of day [s]."""


def jumped(ground: Path, place: Path, name: str) -> list[tuple[tuple[object, ...], str]]:
    """A command during which the clock jumps, once for every jump.

    Args:
        ground: A prepared folder.
        place: Where it happens.
        name: Of `kills.COMMANDS`.

    Returns:
        Rows for `HEADS`, each with what is wrong.
    """
    sound = undisturbed(name, 1, ground, place)
    library = compiled("clocks", place.with_name("library"))
    rng = random.Random(name)
    rows: list[tuple[tuple[object, ...], str]] = []
    for told, seconds in JUMPS.items():
        prepared_copy(ground, place, name)
        moment = time.time() + rng.uniform(0.0, sound[1])
        variables = {
            "LD_PRELOAD": str(library),
            "ESG_CLOCK_JUMP": str(seconds),
            "ESG_CLOCK_AT": str(int(moment)),
        }
        ended = esg(arguments(name, place), place, place / "cache", 180.0, **variables)
        wrong = ended.wrong((0, 3)) or difference(sound[0], facts(place), "")
        wrong = "" if wrong == "same" else wrong
        rows.append(((name, told, ended.code, int(bool(wrong))), wrong))
    return rows
