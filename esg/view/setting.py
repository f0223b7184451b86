"""What exports show beside the bodies: the surroundings of a scene and the cameras that see it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from esg.compile.export import Target, animation, export
from esg.compile.visuals.setting import Setting, View, spread
from esg.compile.visuals.usd_files import UsdForm
from esg.engines.manifest import load_manifest
from esg.engines.scene import Rollout, SimScene
from esg.scenereading import absent, read_metrics
from esg.view.camera import Camera
from esg.view.cameras import action_cameras
from esg.view.director.takes import Take
from esg.view.filmed import said_take
from esg.view.ground import span
from esg.view.parts import body_parts, ground_bodies
from esg.view.renderers.records import Scenery
from esg.view.scenery import seen_from
from esg.view.seeing.limbs import limb_parts, stepping
from esg.view.seeing.shows import redrawn, shown, shown_parts
from esg.view.surroundings import surroundings_of

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict

ASPECT = 16 / 9
"""Width over height of what the camera of an export sees."""
NEAR = 0.05
"""Nearest of what a camera sees, by its distance from what it looks at."""
SIDES, SIDES_M = 24.0, (30.0, 900.0)
"""Side of the drawn ground by the extent of the action, or by how far off the camera is, so that
one does not look over its edge."""


def setting_of(
    scene: SimScene, rollout: Rollout, verdict: SceneVerdict | None, doc: EsgDocument
) -> Setting:
    """The setting of a replayed scene.

    Args:
        scene: The bodies.
        rollout: Their motion.
        verdict: Events, whose participants the camera keeps in view.
        doc: The scene's document.
    """
    said = said_take(doc, scene, rollout, ASPECT)
    around_it = said is None and bool(scene.bodies)
    cameras = action_cameras(scene, rollout, verdict, doc, 1, ASPECT) if around_it else []
    views = tuple(_still("Camera", camera) for camera in cameras)
    if said is not None:
        cameras, views = said.cameras, (_moving("Camera", said),)
    around = surroundings_of(doc, scene, rollout)
    if cameras:
        seen = seen_from(Scenery((), 0, around), cameras, scene, rollout).surroundings
        around = around if seen is None else seen
    shows = shown_parts(body_parts(scene, doc), scene, rollout, doc) if shown(scene) else ()
    steps = stepping(scene, rollout, doc)
    limbs = limb_parts(steps, scene, rollout, doc) if steps else ()
    stepped = {p.body for p in limbs}
    shows = tuple(p for p in shows if not (p.body in stepped and scene.bodies[p.body].gestures))
    low, high = span(rollout) if scene.bodies else (np.zeros(2), np.zeros(2))
    x, y = (float(v) for v in 0.5 * (low + high))
    away = max((math.dist(camera.eye, camera.target) for camera in cameras), default=0.0)
    return Setting(
        sky=around.sky,
        ground=around.ground,
        middle=(x, y),
        side=float(np.clip(SIDES * max(*(high - low), away), *SIDES_M)),
        covered=frozenset(scene.bodies[i].name for i in ground_bodies(scene, doc)),
        parts=tuple(spread(around.parts)),
        views=views,
        shows=(*shows, *limbs),
        redrawn=frozenset(
            b.name
            for i, b in enumerate(scene.bodies)
            if redrawn(b) or any(p.body == i for p in limbs)
        ),
    )


def setting_in(folder: Path, scene: SimScene, rollout: Rollout) -> Setting | None:
    """The setting of a scene folder; None if it holds no document.

    Args:
        folder: With `esg.json` and, if it was judged, `metrics.json`.
        scene: Its bodies.
        rollout: Their motion.

    Raises:
        UserError: For a file that is damaged.
    """
    from esg.graph import load_document
    from esg.metrics import SceneVerdict

    if absent(folder / "esg.json"):
        return None
    doc = load_document(folder / "esg.json")
    verdict = None
    if not absent(folder / "metrics.json"):
        metrics = read_metrics(folder / "metrics.json")
        found = metrics.get("verdict", {})
        if not found.get("events"):
            found = metrics.get("own_timeline", found)  # a suite that asks for nothing
        if found:
            verdict = SceneVerdict.from_json(found)
    return setting_of(scene, rollout, verdict, doc)


def export_folder(
    folder: Path,
    to: Target,
    out: Path,
    *,
    form: UsdForm = "usda",
    self_contained: bool = False,
) -> list[Path]:
    """Writes a scene folder for another program, in its setting where the format has one.

    Args:
        folder: Compiled scene folder.
        to: As for `esg.compile.export.export`, which tells what it raises.
        out: Folder to write into.
        form: Of `usd`.
        self_contained: Of `unreal`.
    """
    if to not in ("usd", "glb") or not (folder / "manifest.json").is_file():
        return export(folder, to, out, self_contained=self_contained)
    manifest = load_manifest(folder / "manifest.json")
    rollout = animation(folder, manifest)
    setting = setting_in(folder, manifest.scene, rollout)
    return export(folder, to, out, rollout=rollout, setting=setting, form=form)


def _moving(name: str, take: Take) -> View:
    turns = np.array([camera.quaternion() for camera in take.cameras])
    near = NEAR * float(np.linalg.norm(take.target - take.eye, axis=1).min())
    return View(name, take.time_s, take.eye, turns, take.fov, ASPECT, near)


def _still(name: str, camera: Camera) -> View:
    eye, turn = np.array([camera.eye]), camera.quaternion()[None]
    near = NEAR * math.dist(camera.eye, camera.target)
    return View(name, np.zeros(1), eye, turn, camera.fov, ASPECT, near)
