"""The replays of a batch's scenes, each kept as an artifact of the batch."""

from __future__ import annotations

from dataclasses import asdict
import json
from pathlib import Path
from typing import TYPE_CHECKING

from esg.dataset.whatifs.outcomes import Alternatives, Asked, alternatives, failed_rows
from esg.pipeline import SceneState, artifact_store
from esg.scenereading import first_line

if TYPE_CHECKING:
    from esg.metrics.models import SuiteScene

STAGE = "alternatives"
"""Name of its artifacts."""
_FILE = "rows.json"


def replayable(state: SceneState) -> bool:
    """Whether a scene has what replays need: a compiled scene and a verdict."""
    return "judge" in state.artifacts and "compile" in state.artifacts


def replay_alternatives(state: SceneState, asked: Asked, name: str) -> Alternatives:
    """The replays of one scene, or what an earlier call kept of them.

    Args:
        state: The scene.
        asked: What to replay.
        name: Id of the scene in the dataset.

    Raises:
        OSError: If they cannot be kept.
    """
    key = _key(state, asked, name)
    store = artifact_store()
    folder = store.find(key)
    if folder is None:

        def fill(target: Path) -> None:
            rows = asdict(_replayed(state, asked, name))
            (target / _FILE).write_text(json.dumps(rows, allow_nan=False), "utf-8")

        folder = store.create(key, fill)
    return Alternatives(**json.loads((folder / _FILE).read_bytes()))


def _replayed(state: SceneState, asked: Asked, name: str) -> Alternatives:
    from esg.engines.manifest import load_manifest
    from esg.stages import load_verdict

    try:
        manifest = load_manifest(state.artifact("compile") / "manifest.json")
        verdict, expected = load_verdict(state), expectation(state)
    except Exception as error:  # no reason to fail a scene: its rows say what is wrong
        return failed_rows(asked, first_line(error))
    done = [n for e in verdict.events if e.completed for n in e.bodies]
    good = state.outcome is not None and state.outcome.is_good
    wanted = asked if good else Asked(engines=asked.engines)
    return alternatives(
        manifest, expected, list(dict.fromkeys(done)), wanted, name=name, seed=state.request.seed
    )


def expectation(state: SceneState) -> SuiteScene:
    """What a scene is judged by: its suite's scene, else its own timeline.

    Raises:
        ValueError: If neither can be read.
    """
    from esg.metrics.models import SuiteScene
    from esg.stages import load_doc, load_suite_scene

    if state.request.suite_scene:
        return SuiteScene.model_validate_json(state.request.suite_scene)
    return load_suite_scene(state.request, load_doc(state))[0]


def _key(state: SceneState, asked: Asked, name: str) -> str:
    from esg.codeversion import code_version
    from esg.pipeline import content_hash
    from esg.store.artifacts import artifact_key

    inputs = {s: content_hash(state.artifact(s)) for s in ("compile", "judge")}
    version = code_version("judge") + code_version("replay")
    config = {**asdict(asked), "name": name, "expected": state.request.suite_scene}
    return artifact_key(STAGE, inputs=inputs, config=config, code_version=version)
