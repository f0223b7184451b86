"""A real scene folder to tamper with, and classes that attack."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
import shutil

import pytest

PROMPT = "A bowling ball rolls into a pin."


@pytest.fixture(scope="session", autouse=True)
def class_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Compiled classes of the tests, away from the user's cache."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ESG_CACHE_DIR", str(tmp_path_factory.mktemp("cache")))
        yield


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A scene folder as the pipeline writes it."""
    from esg.pipeline import SceneRequest, run_scene, scratch_store
    from esg.scenefolder import publish

    root = tmp_path_factory.mktemp("made")
    with scratch_store(root / "store", durable=False):
        return publish(run_scene(SceneRequest(PROMPT, strategy="none")), root / "out")


@pytest.fixture
def scene(made: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy that came from a stranger: this process did not write its class."""
    from esg.compile.trust import written

    monkeypatch.setattr(written, "_written", {})
    return Path(shutil.copytree(made, tmp_path / "scene"))
