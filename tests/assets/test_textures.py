"""Seeded textures: tileable, repeatable, of their stated mean, with normals that fit."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

from esg.assets.textures import FULL, linear, maps, recipes

EACH = pytest.mark.parametrize("name", sorted(recipes()))


@EACH
def test_maps_are_whole(name: str) -> None:
    found = maps(name)
    assert found.base_color.shape == found.normal.shape == (FULL, FULL, 3)
    assert found.roughness.shape == (FULL, FULL)
    assert all(m.dtype == np.uint8 for m in found)
    assert found.base_color.std() > 0.8  # something is to be seen


@EACH
def test_it_continues_across_its_border(name: str) -> None:
    """Steps from the last to the first row and column are not larger than those beside them."""
    found = maps(name)
    for pixels in (found.base_color, found.normal):
        light = pixels.astype(float).reshape(FULL, FULL, -1)
        for axis in (0, 1):
            step = np.abs(np.roll(light, -1, axis) - light).mean(axis=(1 - axis, 2))
            inner, border = step[:-1], step[-1]
            assert border <= max(1.25 * np.quantile(inner, 0.99), inner.max()) + 0.5


@EACH
def test_its_colour_is_on_average_the_one_it_states(name: str) -> None:
    mean = linear(maps(name).base_color / 255.0).mean((0, 1))
    assert mean == pytest.approx(linear(recipes()[name].mean), abs=0.02)


@EACH
def test_normals_are_of_unit_length_and_level_on_average(name: str) -> None:
    normal = maps(name).normal / 127.5 - 1.0
    assert np.linalg.norm(normal, axis=-1) == pytest.approx(1.0, abs=0.02)
    assert np.abs((normal[..., :2] / normal[..., 2:].clip(0.05)).mean((0, 1))).max() < 0.08


def test_light_from_above_falls_on_upper_edges() -> None:
    """+Y of a normal map is up in the picture: a brick's upper edge looks up, its lower one down."""
    found = maps("tiles")
    up = (found.normal[..., 1] / 127.5 - 1.0).mean(1)
    bright = found.base_color.mean((1, 2))
    # below a joint, which is dark, comes the upper edge of the next tile
    joint = int(np.argmin(bright[64:192])) + 64
    assert up[joint + 1 : joint + 5].max() > 0.05 > -0.05 > up[joint - 5 : joint].min()


def test_another_process_draws_the_same_bytes() -> None:
    code = (
        "import hashlib; from esg.assets.textures import maps; m = maps('oak');"
        "print(hashlib.sha256(b''.join(x.tobytes() for x in m)).hexdigest())"
    )
    runs = {
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        ).stdout
        for _ in range(2)
    }
    assert len(runs) == 1


def test_smaller_maps_are_the_same_reduced() -> None:
    full, small = maps("brick"), maps("brick", 128)
    assert small.base_color.shape == (128, 128, 3)
    blocks = linear(full.base_color / 255.0).reshape(128, 4, 128, 4, 3).mean((1, 3))
    assert linear(small.base_color / 255.0) == pytest.approx(blocks, abs=0.02)
    assert maps("brick", 128) is small
