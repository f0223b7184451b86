"""How a kind is drawn changes nothing that is simulated: digests of everything physical of it."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import pytest

from esg.assets.appearance import USUAL, Appearance
from esg.assets.geometry.sketch import Sketch
from esg.assets.geometry.wheels import wheels_of
from esg.assets.library.catalogue import Entry, build_sketch, catalogue, parts

KEPT = json.loads((Path(__file__).parent / "physics.json").read_text(encoding="utf-8"))
"""A change here changes scenes: it needs a reason, and the datasets' version."""
SIZES = ((1.0, 1.0, 1.0), (0.5, 0.5, 0.5), (2.2, 1.3, 0.8))
"""Factors of the usual length, width and height."""
EVERYTHING = [*catalogue(), *parts().values()]
POSED = Appearance(pose="kick", livery="police_car", seed=7, color=(0.1, 0.2, 0.3))


def rounded(value: Any) -> Any:
    """The same structure with nine significant digits, whatever the machine adds; zeros keep their sign."""
    if isinstance(value, bool | str) or value is None:
        return value
    if isinstance(value, int | float):
        return float(f"{value:.9g}")
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    return [rounded(item) for item in value]


def physics(sketch: Sketch) -> dict[str, Any]:
    """Proxies and what is weighed, densities, surfaces, regions, mounts, wheels."""

    def dumped(models: Any) -> Any:
        return None if models is None else [m.model_dump(mode="json") for m in models]

    return {
        "p": dumped(sketch.proxies),
        "w": dumped(sketch.weighed),
        "d": list(sketch.densities),
        "su": dumped(sketch.surfaces),
        "r": dumped(sketch.regions),
        "m": dumped(sketch.mounts),
        "wh": dumped(wheels_of(sketch) or ()),
    }


def digest(entry: Entry, appearance: Appearance = USUAL) -> str:
    sizes = [tuple(a * b for a, b in zip(entry.dimensions_cm, f, strict=True)) for f in SIZES]
    drawn = [physics(build_sketch(entry, s, entry.color_rgb, appearance)) for s in sizes]  # type: ignore[arg-type]
    return hashlib.sha256(json.dumps(rounded(drawn), sort_keys=True).encode()).hexdigest()[:16]


def test_no_kind_is_forgotten() -> None:
    assert set(KEPT) == {e.name for e in EVERYTHING}


@pytest.mark.parametrize("entry", EVERYTHING, ids=lambda e: e.name)
def test_what_is_simulated_is_what_it_was(entry: Entry) -> None:
    """Collision shapes, masses, surfaces, regions, mounts and wheels at three sizes."""
    assert digest(entry) == KEPT[entry.name]


@pytest.mark.parametrize("entry", EVERYTHING, ids=lambda e: e.name)
def test_appearances_change_nothing_that_is_simulated(entry: Entry) -> None:
    assert digest(entry, POSED) == KEPT[entry.name]
