"""One small dataset with all its layouts for all tests of readers."""

from __future__ import annotations

from pathlib import Path

import pytest

from esg.dataset.layouts.building import add_layouts
from esg.dataset.layouts.registry import LAYOUTS
from tests.dataset.layouts.sets import make_set


@pytest.fixture(scope="session")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The dataset; not to be changed."""
    out = make_set(tmp_path_factory.mktemp("sets") / "whole")
    add_layouts(out, LAYOUTS, print)
    return out
