"""A small dataset with clips, made without a pipeline or a renderer."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from esg.dataset.clips.records import ClipObject, ClipRecord
from esg.dataset.clips.writing import write_clip
from esg.dataset.finish import finish
from esg.dataset.folder import DatasetFolder
from esg.dataset.plan import DatasetSpec, Prompt
from esg.engines.manifest import manifest_bytes, manifest_to_json
from esg.store.records import RunInfo, SceneRecord
from esg.store.tables import write_tables
from tests.dataset.clips import synthetic
from tests.metrics.worlds import DT
from tests.store import samples

FRAMES = 6
SIZE = (32, 24)
SPLITS = ("train", "train", "train", "validation", "test")


def make_set(out: Path, scenes: int = 5, cameras: int = 2, *, rendered: bool = True) -> Path:
    """Scenes of three balls, seen by cameras that see a box; every split has one."""
    prompts = [Prompt(prompt=f"Ball {k} of scene {k:07d} hits ball 2.") for k in range(scenes)]
    spec = DatasetSpec(source="prompts", n=scenes, previews="none", meshes=False)
    folder = DatasetFolder(out)
    run = folder.begin(spec, prompts, resume=False)
    records = [_scene(out, run, k, cameras if rendered else 0) for k in range(scenes)]
    write_tables(out / "parts", records, name="batch-000000")
    finish(folder, spec, {})
    return out


def _scene(out: Path, run: RunInfo, number: int, cameras: int) -> SceneRecord:
    rows = dict(samples.record(run, f"{number:07d}", number).rows)
    world = samples.world()
    manifest = manifest_to_json(world.scene, world.program, dt=DT)
    split = SPLITS[number % len(SPLITS)]
    scene = {**rows["scenes"][0], "manifest": manifest_bytes(manifest).decode(), "split": split}
    clips = [_clip(out, scene, camera).row(out) for camera in range(cameras)]
    rows |= {"scenes": [scene], "clips": clips, "meshes": []}
    return SceneRecord({table: found for table, found in rows.items() if table != "runs"})


def _clip(out: Path, scene: dict[str, object], camera: int) -> ClipRecord:
    world = samples.world()
    rollout = world.rollout()
    time = (np.arange(FRAMES) / 24.0).astype(np.float32)
    at = np.searchsorted(rollout.time, time - 1e-6)
    bodies = world.scene.bodies
    made = synthetic.record(
        str(scene["run_id"]), str(scene["scene_id"]), camera, seed=int(str(scene["seed"])),
        split=str(scene["split"]), frames=FRAMES, size=SIZE, prompt=str(scene["prompt"]),
    )  # fmt: skip
    half = np.array([b.half_extents for b in bodies], np.float32)
    made = replace(
        made,
        objects=tuple(
            ClipObject(k + 2, b.name, b.name.replace("_", " "), b.category, b.static)
            for k, b in enumerate(bodies)
        ),
        object_bounds_m=np.stack([-half, half], axis=1),
        object_position_m=rollout.position[0, at].astype(np.float32),
        object_quaternion_xyzw=rollout.quaternion[0, at].astype(np.float32),
        camera_position_m=np.tile(np.array([0, -3 - camera, 1], np.float32), (FRAMES, 1)),
    )
    values = synthetic.values(FRAMES, SIZE)
    noise = np.random.default_rng([int(str(scene["seed"])), camera])
    values["rgb"] = noise.integers(0, 60, values["rgb"].shape, np.uint8) + values["rgb"] // 2
    return write_clip(out, made, values)
