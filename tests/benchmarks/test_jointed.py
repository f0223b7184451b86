"""Every jointed thing leaves the house whole: the nightly job goes over all, a commit over a few."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.jointed import check, compiled, prompts

FEW = ("door", "chest", "rider")
"""A hinge on what stands, one between free bodies, a weld that breaks."""


@pytest.mark.parametrize(
    "name",
    [n if n in FEW else pytest.param(n, marks=pytest.mark.slow) for n in prompts()],
)
def test_a_jointed_thing_leaves_the_house_whole(tmp_path: Path, name: str) -> None:
    compiled(prompts()[name], tmp_path / "scene")
    left = check(name, tmp_path / "scene", tmp_path / "out", "")
    assert left.whole, left
