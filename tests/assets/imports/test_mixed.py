"""One scene of parametric, imported and generated assets, made by the public command line."""

from __future__ import annotations

import json
from pathlib import Path
import sys

import pytest
import trimesh

from esg.cli import main
from tests.assets.imports.test_generate import Server, wedge_glb


@pytest.mark.slow
def test_scene_mixes_three_sources_and_carries_attribution(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ESG_ASSET_LIBRARY", str(tmp_path / "library"))
    models = tmp_path / "models"
    models.mkdir()
    trimesh.creation.cylinder(radius=0.2, height=0.3).export(models / "samovar.glb")
    (models / "catalogue.csv").write_text(
        "file,name,length_cm,width_cm,height_cm,mass_kg,license,creator\n"
        "samovar.glb,samovar,30,30,45,4,CC-BY-4.0,A. Maker\n"
    )
    assert wedge_glb()[:4] == b"glTF"
    server = Server("good")
    monkeypatch.setenv("ESG_GENERATOR", "trellis")
    monkeypatch.setenv("ESG_TRELLIS_URL", server.url)
    try:
        assert run("assets", "import", str(models), "--library", "kitchenware") == 0
        scene = tmp_path / "scene"
        prompt = "There are a samovar, a zorbulator and a mug on a table."
        assert run("generate", prompt, "--out", str(scene), "--strategy", "none") in (0, 3)
    finally:
        server.shutdown()
        server.server_close()
    document = json.loads(next(scene.rglob("esg.json")).read_text())
    used = document["asset_configurations"].values()
    sources = {c["source"] for c in used}
    assert {"parametric", "library", "generated"} <= sources, [
        (c["category"], c["source"]) for c in used
    ]
    text = next(scene.rglob("ATTRIBUTION.txt")).read_text()
    assert "A. Maker" in text and "CC-BY-4.0" in text and "trellis-http" in text


def run(*words: str) -> int:
    """The exit code of a command."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["esg", *words])
        try:
            main()
        except SystemExit as stop:
            return int(stop.code or 0)
    return 0
