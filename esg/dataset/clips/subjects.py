"""Scenes to render: those of a batch that was just made, and those of a finished dataset."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.dataset.clips.rendering import Replay, Subject
from esg.limits import place_in
from esg.outcomes import UserError
from esg.store.records import scene_key
from esg.store.tables import part_files

if TYPE_CHECKING:
    from esg.dataset.job import BatchJob
    from esg.dataset.plan import PlannedScene
    from esg.engines.scene import Rollout
    from esg.metrics.models import SceneVerdict
    from esg.pipeline import SceneState


def made_subjects(job: BatchJob, states: Sequence[SceneState]) -> list[Subject]:
    """Scenes of a batch that were replayed."""
    return [
        Subject(scene.index, _common(job, scene), lambda state=state: _made(state), scene.camera)
        for scene, state in zip(job.scenes, states, strict=True)
        if "judge" in state.artifacts
    ]


def _common(job: BatchJob, scene: PlannedScene) -> dict[str, Any]:
    run, seed = job.run, scene.request.seed
    return {
        "run_id": run.run_id,
        "scene_key": scene_key(run.run_id, run.suite, scene.scene_id, seed),
        "suite": run.suite,
        "scene_id": scene.scene_id,
        "seed": seed,
        "split": scene.split,
        "prompt": scene.request.prompt,
    }


def _made(state: SceneState) -> Replay:
    """A scene's replay, its place dressed for the pictures."""
    from esg.engines.rollout_file import load_rollout
    from esg.pipeline import run_stage
    from esg.stages import ROLLOUT, load_doc, load_scene, load_verdict

    with place_in("dress"):
        dressed = run_stage("dress", state)
    if "dress" not in dressed.artifacts:
        raise RuntimeError(f"its place cannot be dressed: {dressed.reason}")
    scene, _ = load_scene(state)
    rollout = load_rollout(state.artifact("replay") / ROLLOUT)
    return Replay(scene, rollout, load_verdict(state), load_doc(dressed, "dress"))


# Of a finished dataset: the tables hold all that cameras need.

_TOLD = ("run_id", "scene_key", "suite", "scene_id", "seed", "split", "prompt")


def told_scenes(folder: Path) -> list[dict[str, Any]]:
    """Scenes of a finished dataset that were replayed: what `Subject.common` holds, by key."""
    played = {r["scene_key"] for r in _rows(folder, "trajectories", ["scene_key"])}
    rows = [r for r in _rows(folder, "scenes", list(_TOLD)) if r["scene_key"] in played]
    return sorted(rows, key=lambda r: r["scene_key"])


def told_subjects(job: BatchJob) -> list[Subject]:
    """Scenes of a batch of a finished dataset.

    Args:
        job: Whose scenes stand in the tables of `job.source`.
    """
    assert job.source is not None
    keys = {_common(job, scene)["scene_key"]: scene for scene in job.scenes}
    columns = [*_TOLD, "manifest", "esg_optimize", "engine", "parameters"]
    found = {r["scene_key"]: r for r in _rows(job.source, "scenes", columns, keys)}
    return [
        Subject(
            scene.index,
            {name: found[key][name] for name in _TOLD},
            lambda row=found[key]: _told(job.source, row),
            camera=_drawn_camera(found[key]),
        )
        for key, scene in keys.items()
        if key in found
    ]


def _drawn_camera(row: Mapping[str, Any]) -> str:
    """How the distribution has a scene filmed; empty if it does not say."""
    found = (p["text"] for p in row["parameters"] or () if p["slot"] == "camera")
    return next(found, None) or ""


def _told(folder: Path | None, row: Mapping[str, Any]) -> Replay:
    """A scene's replay as the tables tell it."""
    from esg.dressing import dress
    from esg.engines.manifest import manifest_from_json
    from esg.graph import EsgDocument

    assert folder is not None
    if not row["manifest"] or not row["esg_optimize"]:
        raise UserError("its row in table scenes lacks the manifest or the document")
    scene = manifest_from_json(json.loads(row["manifest"])).scene
    doc = EsgDocument.model_validate_json(row["esg_optimize"])
    key = row["scene_key"]
    moved = [
        r
        for r in _rows(folder, "trajectories", None, [key])
        if r["scene_key"] == key and r["engine"] == row["engine"]
    ]
    if not moved:
        raise UserError(f"table trajectories has no replay of it in {row['engine']}")
    rollout = rollout_of(moved[0])
    verdict = _verdict(folder, row)
    return Replay(scene, rollout, verdict, dress(doc, scene, rollout, seed=row["seed"]))


def rollout_of(row: Mapping[str, Any]) -> Rollout:
    """The replay of a row of table `trajectories`, without its contacts."""
    from esg.engines.scene import ContactLog, Rollout

    shape = (1, row["n_frames"], len(row["bodies"]))

    def array(name: str, width: int) -> Any:
        return np.asarray(row[name], np.float32).reshape(*shape, width)

    return Rollout(
        engine=row["engine"],
        dt=row["dt_s"],
        time=np.asarray(row["time_s"], float),
        position=array("position_m", 3),
        quaternion=array("quaternion_xyzw", 4),
        linear_velocity=array("linear_velocity_mps", 3),
        angular_velocity=array("angular_velocity_radps", 3),
        contacts=ContactLog.empty(),
        valid=np.ones(1, bool),
    )


def _verdict(folder: Path, row: Mapping[str, Any]) -> SceneVerdict:
    """The events of a scene; nothing else of a verdict is seen."""
    from esg.metrics.models import EventVerdict, LayoutVerdict, SceneVerdict

    columns = ["scene_key", "engine", "event_id", "event_index", "event_type", "completed"]
    found = _rows(folder, "metrics", [*columns, "time_s", "bodies", "dt_s"], [row["scene_key"]])
    mine = [r for r in found if r["engine"] == row["engine"]]
    return SceneVerdict(
        scene_id=row["scene_id"],
        suite_scene=row["scene_id"],
        engine=row["engine"],
        dt_s=mine[0]["dt_s"] if mine else 0.0,
        events=tuple(
            EventVerdict(
                id=r["event_id"], type=r["event_type"], completed=r["completed"],
                time_s=r["time_s"], bodies=tuple(r["bodies"]),
            )
            for r in sorted(mine, key=lambda r: r["event_index"])
        ),
        constraints=(),
        layout=LayoutVerdict(valid=True),
    )  # fmt: skip


def _rows(
    folder: Path, table: str, columns: Sequence[str] | None, keys: Any = None
) -> Iterator[dict[str, Any]]:
    """Rows of a table, those of some scenes alone; row groups without any are not read."""
    import pyarrow.parquet as pq

    for path in part_files(folder, table):
        chosen = None if keys is None else [("scene_key", "in", list(keys))]
        found = pq.read_table(path.absolute(), columns=columns, filters=chosen)
        yield from found.to_pylist()
