from __future__ import annotations

from pathlib import Path

import pytest


@pytest.fixture(scope="session", autouse=True)
def class_cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Compiled classes of the whole test session, away from the user's cache."""
    patch = pytest.MonkeyPatch()
    folder = tmp_path_factory.mktemp("cache")
    patch.setenv("ESG_CACHE_DIR", str(folder))
    yield folder
    patch.undo()
