"""What code alone computes is made once; damage and full disks cost time only."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from esg import kept as module
from esg.assets import textures
from esg.assets.gltf import surfaces
from esg.kept import kept, version_of


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path / "cache"))


def refuse() -> bytes:
    raise AssertionError("it was made again")


def test_it_is_made_once() -> None:
    assert kept("room", "v1", "a", lambda: b"made") == b"made"
    assert kept("room", "v1", "a", refuse) == b"made"
    assert kept("room", "v2", "a", lambda: b"other") == b"other"


@pytest.mark.parametrize("damage", [b"", b"short", b"\0" * 64])
def test_what_is_damaged_is_made_again(tmp_path: Path, damage: bytes) -> None:
    kept("room", "v1", "a", lambda: b"made")
    (tmp_path / "cache" / "room" / "v1" / "a").write_bytes(damage)
    assert kept("room", "v1", "a", lambda: b"made") == b"made"
    assert kept("room", "v1", "a", refuse) == b"made"


def test_a_cache_that_cannot_be_written_is_no_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "cache").write_text("a file where a folder should be")
    assert kept("room", "v1", "a", lambda: b"made") == b"made"


def test_versions_nobody_uses_any_more_go(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept("room", "old", "a", lambda: b"made")
    monkeypatch.setattr(module, "OTHER_VERSION_S", -1.0)
    kept("room", "new", "a", lambda: b"made")
    assert [p.name for p in (tmp_path / "cache" / "room").iterdir()] == ["new"]


def test_a_version_is_of_code_and_of_what_it_is_told(tmp_path: Path) -> None:
    one, other = tmp_path / "one", tmp_path / "other"
    for folder, text in ((one, "a = 1"), (other, "a = 2")):
        folder.mkdir()
        (folder / "module.py").write_text(text)
    assert len({version_of(one), version_of(other), version_of(one, "1.0")}) == 3


def test_textures_and_their_pictures_are_the_same_from_the_cache(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    drawn = textures.drawn("oak", 64)
    for _ in range(2):  # made, then found
        found = textures.maps.__wrapped__("oak", 64)
        for ours, theirs in zip(found, drawn, strict=True):
            assert ours.dtype == np.uint8
            np.testing.assert_array_equal(ours, theirs)
            assert not ours.flags.writeable
    first = surfaces._kept_picture("oak", "color")
    monkeypatch.setattr(surfaces, "_encoded", lambda *_: refuse())
    assert surfaces._kept_picture("oak", "color") == first
