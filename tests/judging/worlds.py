"""One motion with a known verdict, written in every format that is judged."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np

from esg.compile.glb import scene_glb
from esg.compile.usd import write_usd
from esg.engines.manifest import Manifest, carried_json
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Body, Rollout, Shape, SimScene
from esg.metrics.suite import parse_suite
from esg.store.mcap_log import write_mcap

SUITE = """
suite: one
scenes:
  - id: S1
    level: chain
    prompt: "A red ball rolls into a crate."
    events:
      - {id: e1, type: moves, object: "red ball"}
      - {id: e2, type: collision, a: "red ball", b: "crate", after: [e1]}
    constraints:
      - {kind: initial, quantity: mass, object: "crate", value: 4.0, unit: kg}
      - {kind: outcome, quantity: time, event: e2, value: 0.6, unit: s}
"""
SCENE = parse_suite(SUITE).scenes[0]
_I = ((0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1))


def _scene() -> SimScene:
    ball = Body(
        "ball_1", False, 2.0, _I, (Shape("sphere", (0.2, 0.2, 0.2)),), (0.0, 0.0, 0.2),
        roll_radius=0.2, origin_offset=(0.0, 0.0, -0.2), half_extents=(0.2, 0.2, 0.2),
        label="red ball", category="ball", color=(0.8, 0.1, 0.1),
    )  # fmt: skip
    crate = Body(
        "crate_1", False, 4.0, _I, (Shape("box", (0.25, 0.25, 0.25)),), (2.2, 0.0, 0.25),
        origin_offset=(0.0, 0.0, -0.25), half_extents=(0.25, 0.25, 0.25), label="crate",
        category="crate",
    )  # fmt: skip
    wall = Body(
        "wall_1", True, 0.0, _I, (Shape("box", (0.1, 1.0, 0.5)),), (6.0, 0.0, 0.5),
        origin_offset=(0.0, 0.0, -0.5), half_extents=(0.1, 1.0, 0.5), category="wall",
    )  # fmt: skip
    return SimScene("one", (ball, crate, wall))


PROGRAM = Program((SetVelocity("ball_1", 0.0, (3.0, 0.0, 0.0), (0.0, 15.0, 0.0)),), 2.0)


def played() -> tuple[SimScene, Rollout]:
    """The ball meets the crate after 1.75 m at 3 m/s; 240 frames a second."""
    scene = _scene()
    batch = batch_programs([PROGRAM], scene.names)
    return scene, get_engine("physx").rollout(scene, batch, dt=1 / 240, record_every=1)


def poses(rollout: Rollout, every: int = 4) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times, positions and quaternions at 60 frames a second."""
    frames = slice(None, None, every)
    position, quaternion = rollout.position[0, frames], rollout.quaternion[0, frames]
    return rollout.time[frames], position.astype(float), quaternion.astype(float)


def facts(scene: SimScene) -> list[dict[str, Any]]:
    rows = []
    for body in scene.bodies:
        kind = body.shapes[0].kind
        half = body.shapes[0].size
        rows.append(
            {"body": body.name, "label": body.label, "shape": kind, "size_x": 2 * half[0],
             "size_y": 2 * half[1], "size_z": 2 * half[2],
             "mass": "" if body.static else body.mass, "static": str(body.static).lower()}
        )  # fmt: skip
    return rows


def rows(scene: SimScene, rollout: Rollout) -> list[dict[str, Any]]:
    time, position, quaternion = poses(rollout)
    names = ("x", "y", "z", "qx", "qy", "qz", "qw")
    return [
        {"time": t, "body": body.name,
         **dict(zip(names, (*position[f, k], *quaternion[f, k]), strict=True))}
        for f, t in enumerate(time)
        for k, body in enumerate(scene.bodies)
    ]  # fmt: skip


def write_table(path: Path, table: list[dict[str, Any]]) -> None:
    with path.open("w", newline="") as file:
        out = csv.DictWriter(file, list(table[0]))
        out.writeheader()
        out.writerows(table)


def csv_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    write_table(folder / "S1.csv", rows(scene, rollout))
    write_table(folder / "S1.bodies.csv", facts(scene))
    return folder / "S1.csv"


def parquet_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    import pyarrow as pa
    import pyarrow.parquet as pq

    pq.write_table(pa.Table.from_pylist(rows(scene, rollout)), folder / "S1.parquet")
    write_table(folder / "S1.bodies.csv", facts(scene))
    return folder / "S1.parquet"


def npz_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    time, position, quaternion = poses(rollout)
    about = facts(scene)
    np.savez(
        folder / "S1.npz", time=time, position=position, quaternion=quaternion,
        names=np.array(scene.names), label=np.array([f["label"] for f in about]),
        shape=np.array([f["shape"] for f in about]),
        size=np.array([[f["size_x"], f["size_y"], f["size_z"]] for f in about]),
        mass=np.array([b.mass if not b.static else np.nan for b in scene.bodies]),
        static=np.array([b.static for b in scene.bodies]),
    )  # fmt: skip
    return folder / "S1.npz"


def kubric_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    time, position, quaternion = poses(rollout)
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    instances = []
    for k, body in enumerate(scene.bodies):
        from esg.units import quat_rotate

        half = np.array(body.half_extents)
        boxes = quat_rotate(quaternion[:, k, None], corners * half) + position[:, k, None]
        instances.append(
            {"category": body.label or body.category, "mass": body.mass,
             "is_dynamic": not body.static,
             "positions": position[:, k].tolist(),
             "quaternions": quaternion[:, k][:, [3, 0, 1, 2]].tolist(),
             "bboxes_3d": boxes.tolist()}
        )  # fmt: skip
    data = {"metadata": {"frame_rate": 60, "num_frames": len(time)}, "instances": instances}
    (folder / "S1.json").write_text(json.dumps(data))
    return folder / "S1.json"


def _manifest(scene: SimScene) -> Manifest:
    return Manifest(scene, PROGRAM, (), 1 / 240)


def _thin(rollout: Rollout) -> Rollout:
    from esg.compile.export import thinned

    return thinned(rollout)


def glb_file(folder: Path, scene: SimScene, rollout: Rollout, *, carried: bool = True) -> Path:
    manifest = carried_json(_manifest(scene)) if carried else None
    data = scene_glb(scene, _thin(rollout), folder, manifest=manifest)
    (folder / "S1.glb").write_bytes(data)
    return folder / "S1.glb"


def bare_glb_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    return glb_file(folder, scene, rollout, carried=False)


def usd_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    write_usd(_manifest(scene), _thin(rollout), folder, folder)
    return (folder / "scene_animation.usda").rename(folder / "S1.usda")


def bare_usd_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    from pxr import Sdf

    path = usd_file(folder, scene, rollout)
    physics = Sdf.Layer.FindOrOpen(str(folder / "scene.usda"))
    world = physics.GetPrimAtPath("/World")
    about = dict(world.customData)
    # Names with colons nest.
    del about["esg"]["manifest"]
    world.SetInfo("customData", about)
    physics.Save()
    return path


def mcap_file(folder: Path, scene: SimScene, rollout: Rollout) -> Path:
    write_mcap(folder / "S1.mcap", scene, PROGRAM, rollout)
    return folder / "S1.mcap"


WRITERS = {
    "csv": csv_file, "parquet": parquet_file, "npz": npz_file, "kubric": kubric_file,
    "glb": glb_file, "bare glb": bare_glb_file, "usd": usd_file, "bare usd": bare_usd_file,
    "mcap": mcap_file,
}  # fmt: skip
