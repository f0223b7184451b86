"""While a class is compiled, the assets of the one scene that is made are drawn; no bytes change."""

from __future__ import annotations

from pathlib import Path

import pytest

from esg import stages
from esg.alone.guarded import run_guarded
from esg.assets.geometry import mesh
from esg.machine import beside
from esg.pipeline import SceneRequest, SceneState, artifact_store, run_scene, scratch_store

REQUEST = SceneRequest("A ball rolls off a table into a bucket.", seed=3)


def _files(state: SceneState, stage: str) -> dict[str, bytes]:
    root = state.artifact(stage)
    return {p.relative_to(root).as_posix(): p.read_bytes() for p in root.rglob("*") if p.is_file()}


def test_one_scene_has_the_bytes_of_a_batch(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(beside, "usable_cores", lambda: 2)
    drawn: list[str] = []
    own = stages._draw_assets

    def draw(state: SceneState) -> None:
        drawn.append(state.request.prompt)
        own(state)

    monkeypatch.setattr(stages, "_draw_assets", draw)
    found: list[dict[str, bytes]] = []
    for name, run in (("batch", run_scene), ("alone", run_guarded)):
        mesh._drawn_glb.cache_clear()
        with scratch_store(tmp_path / name, durable=False):
            state = run(REQUEST)
            assert artifact_store().root == tmp_path / name
            found.append(_files(state, "replay") | _files(state, "record"))
    assert drawn == [REQUEST.prompt]
    assert found[0] == found[1]
