"""What the comparison of exports in other programs calls the same."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.looks.__main__ import Found, compare_materials, compare_places
from esg.assets.gltf.surfaces import Picture, Surface

PAINT = Surface("paint_ff0000", (1.0, 0.0, 0.0), 0.4, 0.1)
OAK = Surface("oak", (1.0, 1.0, 1.0), 0.6, base=Picture(b"\x89PNG\r\n\x1a\n"))


def test_places_tell_how_far_and_how_turned() -> None:
    here = np.tile(np.eye(4), (2, 1, 1))
    there = here.copy()
    there[1, 0, 3] = 0.003
    angle = np.radians(0.2)
    there[0, :2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    found = Found("program", "file")
    places = [{"ball": matrix.tolist()} for matrix in there]
    compare_places(found, {"ball": here, "lost": here}, places)
    assert found.bodies == 1 and found.wrong == ["lost is missing"]
    assert found.apart_m == pytest.approx(0.003) and found.turned_deg == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("change", "wrong"),
    [
        ({}, ""),
        ({"roughness": 0.5}, "roughness"),
        ({"color": [0.9, 0.1, 0.0]}, "color"),
        ({"pictures": {"base": [256, 256]}}, "picture base is there"),
    ],
)
def test_materials_tell_what_differs(change: dict[str, object], wrong: str) -> None:
    seen = {"color": [1.0, 0.0, 0.0], "roughness": 0.4, "metalness": 0.1, "pictures": {}} | change
    found = Found("program", "file")
    compare_materials(found, [PAINT], [("paint_ff0000.001", seen)])
    assert (found.same == 1) == (not wrong)
    assert wrong in "".join(found.wrong)


def test_a_picture_that_could_not_be_read_is_told() -> None:
    seen = {"color": None, "roughness": 0.6, "metalness": 0.0, "pictures": {"base": [0, 0]}}
    found = Found("program", "file")
    compare_materials(found, [OAK, replace(OAK, name="ash")], [("oak", seen)])
    assert found.same == 0 and found.materials == 2
    assert found.wrong == ["material oak: picture base could not be read", "material ash: missing"]
