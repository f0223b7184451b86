"""The packages' public names, whatever was imported before."""

from __future__ import annotations

import importlib
import subprocess
import sys
from types import ModuleType

import pytest


@pytest.mark.parametrize("package", ["esg.store", "esg.metrics"])
def test_every_public_name_is_no_module(package):
    module = importlib.import_module(package)
    for home in set(module._HOME.values()):
        importlib.import_module(f"{package}.{home}")
    for name in module.__all__:
        assert not isinstance(getattr(module, name), ModuleType), name
    assert sorted(module._HOME) == sorted(module.__all__)
    with pytest.raises(AttributeError, match="nothing"):
        module.nothing  # noqa: B018


def test_importing_the_packages_loads_nothing_heavy():
    heavy = "{'duckdb', 'pyarrow', 'scipy', 'mcap', 'google', 'warp', 'trimesh', 'yaml'}"
    code = (
        "import sys, esg.metrics, esg.store, esg.metrics.judging, esg.store.tables, "
        f"esg.store.ingesting; print(sorted({heavy} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
