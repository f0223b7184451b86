"""Scenes as USD, and the documented player, for the tests."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

from esg.compile.usd import physics_layer
from esg.compile.visuals.usd_files import LOOKS_FILE
from esg.compile.visuals.usd_looks import UsdLooks
from esg.engines.manifest import manifest_from_json, manifest_to_json
from esg.engines.program import Program
from esg.engines.scene import SimScene

DOCS = Path(__file__).parents[2] / "docs"
PLAYER = DOCS / "play_usd.py"


def player(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """docs/play_usd.py as a module."""
    monkeypatch.syspath_prepend(DOCS)
    spec = importlib.util.spec_from_file_location("play_usd", PLAYER)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def usd_of(folder: Path, scene: SimScene, program: Program) -> Path:
    """Writes the scene to simulate."""
    from pxr import Sdf

    data = manifest_to_json(scene, program, dt=1 / 240)
    path = folder / "scene.usda"
    looks = UsdLooks(Sdf.Layer.CreateAnonymous(".usdc"))
    path.write_text(
        physics_layer(manifest_from_json(data), looks, folder).ExportToString(), "utf-8"
    )
    looks.layer.Export(str(folder / LOOKS_FILE))
    return path
