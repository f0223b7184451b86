"""Renderings of fake scenes: balls on a plain ground, two frames a second, no director."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

from esg.assets.looks import Look
from esg.dataset.clips import rendering, subjects
from esg.dataset.clips.rendering import Replay
from esg.dataset.plan import RenderSpec
from esg.engines.scene import SimScene
from esg.graph.models import EsgDocument, Node, SceneDefinition, SpatialRelationGraph
from esg.graph.models import SceneParameters as Parameters
from esg.pipeline import SceneState
from esg.view.pieces import Part
from esg.view.surroundings import Sky, Surroundings
from tests.metrics.test_events import CHAIN, chain

SPEC = RenderSpec(
    channels=(
        "rgb", "depth", "flow", "backward_flow", "segmentation", "normal", "object_coordinates",
        "tracks", "boxes",
    ),
    size=(32, 24), fps=4.0, camera="around", cameras=2,
)  # fmt: skip
FRAMES = 13
"""Of three seconds at four a second."""


def parts(scene: SimScene, *_: object) -> list[Part]:
    """A sphere a body."""
    made = trimesh.creation.icosphere(subdivisions=2, radius=0.1)
    vertices, faces = np.asarray(made.vertices), np.asarray(made.faces)
    return [Part(k, vertices, faces, (0.9, 0.2 * k, 0.1)) for k, _ in enumerate(scene.bodies)]


def document(prompt: str) -> EsgDocument:
    """A document that names the balls."""
    names = chain(0.4, 0.8).scene.names
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id="fake",
            original_description=prompt,
            scene_parameters=Parameters(is_dynamic=True, scene_type="outdoor"),
        ),
        spatial_relation_graph=SpatialRelationGraph(
            nodes={name: Node(asset_id=f"{name}_a") for name in names}
        ),
    )


def replay(state: SceneState) -> Replay:
    """The chain of balls; a prompt with `blind` cannot be rendered."""
    prompt = state.request.prompt
    if "blind" in prompt:
        raise ValueError("no mesh for a unicorn")
    world = chain(0.4, 0.8)
    return Replay(world.scene, world.rollout(), world.judge(CHAIN), document(prompt))


def install(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replaces what looks at meshes and places."""

    def around(*_: object) -> Surroundings:
        return Surroundings(Sky(), Look("", (0.4, 0.5, 0.3)))

    monkeypatch.setattr("esg.view.scenery.body_parts", parts)
    monkeypatch.setattr("esg.view.scenery.surroundings_of", around)
    monkeypatch.setattr(subjects, "_made", replay)


def note_scenes(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Ids of the scenes that are really rendered from now on."""
    done: list[str] = []
    real = rendering.sight_of

    def noted(*args: Any, **more: Any) -> Any:
        done.append(args[3].scene_definition.original_description)
        return real(*args, **more)

    monkeypatch.setattr(rendering, "sight_of", noted)
    return done


def media(out: Path) -> dict[str, bytes]:
    """All files of clips, by name."""
    return {
        p.relative_to(out).as_posix(): p.read_bytes()
        for p in sorted((out / "clips").glob("*/*/*"))
        if p.is_file()
    }
