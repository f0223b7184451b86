"""Strips of five moments each of finished scenes, one below the other, from one place each.

    python -m benchmarks.strips OUT.jpg SCENE[@AZIMUTH[,ELEVATION]][@T1,T2,T3,T4,T5] ...

A camera stands still where it sees all that moves, beside the motion or at the azimuth that is
told [deg, counter-clockwise from +X]; moments are the start, three on the way of the events and
what came of them, or those that are told [s]. docs/images/joints_strips.jpg is made so.
"""

from __future__ import annotations

import argparse
import json
import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from esg.engines.breaking import shown
from esg.engines.manifest import load_manifest
from esg.engines.rollout_file import load_rollout
from esg.engines.scene import Rollout
from esg.engines.wheels import scene_angles
from esg.graph.models import EsgDocument
from esg.metrics import SceneVerdict
from esg.view.camera import Camera, frame_points
from esg.view.framing import action_points, facing_side, frame_at, pose
from esg.view.lettering import fitted, font
from esg.view.moments import as_seen, moments_of
from esg.view.render import Renderer
from esg.view.ropes import ropes_at
from esg.view.scenery import scenery_of, seen_from
from esg.view.sheet import draw_ropes

SIZE = (240, 150)
"""Of one picture [px]."""
TITLE_PX = 16
ELEVATION_DEG, FILL = 14.0, 0.8
"""Of the camera, and the part of the picture's half size that what moves may use."""
LEAD_S = 0.25
"""So long before the first event the second picture is."""
SAMPLES = 12
"""Rays a pixel."""
QUALITY = 74


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("scenes", nargs="+", help="SCENE, SCENE@AZIMUTH or SCENE@AZIMUTH@TIMES")
    args = parser.parse_args()
    strips = [strip(*told(scene)) for scene in args.scenes]
    Image.fromarray(np.concatenate(strips)).save(args.out, quality=QUALITY)


def told(text: str) -> tuple[Path, tuple[float, ...], tuple[float, ...]]:
    """Folder, angles of the camera [deg] and moments [s] of "SCENE@AZIMUTH,ELEVATION@T1,T2"."""
    folder, _, rest = text.partition("@")
    angles, _, times = rest.partition("@")
    return Path(folder), _numbers(angles), _numbers(times)


def _numbers(text: str) -> tuple[float, ...]:
    return tuple(float(x) for x in text.split(",") if x)


def strip(
    folder: Path, angles: tuple[float, ...] = (), times: tuple[float, ...] = ()
) -> NDArray[np.uint8]:
    """One row: the prompt, and below it five pictures from one place.

    Args:
        folder: Of a finished scene.
        angles: Azimuth and elevation of the camera [deg]; beside the motion if empty.
        times: Of the pictures [s]; by the events if empty.

    Returns:
        Shape [TITLE_PX + height, 5 width, 3].
    """
    doc = EsgDocument.model_validate_json((folder / "esg.json").read_bytes())
    rollout = load_rollout(folder / "rollout.npz")
    scene = as_seen(load_manifest(folder / "manifest.json").scene, doc)
    metrics = json.loads((folder / "metrics.json").read_bytes())
    verdict = SceneVerdict.from_json(metrics["verdict"])
    moments = [m.time for m in moments_of(scene, rollout, verdict, doc)]
    first, last = (moments[1], moments[-2]) if len(moments) > 2 else (moments[0], moments[-1])
    begins = max(0.0, first - LEAD_S)
    usual = (0.0, begins, first, 0.5 * (first + max(last, first + LEAD_S)), moments[-1])
    frames = [frame_at(rollout, time) for time in (times or usual)]
    points = action_points(scene, rollout, verdict, doc, 9)
    azimuth = math.radians(angles[0]) if angles else facing_side(scene, rollout, verdict, doc)
    elevation = math.radians(angles[1] if len(angles) > 1 else ELEVATION_DEG)
    camera = frame_points(points, azimuth, elevation, SIZE[0] / SIZE[1], FILL)
    scenery = seen_from(scenery_of(scene, rollout, doc), [camera], scene, rollout)
    renderer = Renderer(scenery.parts, scenery.n_bodies, *SIZE, scenery.surroundings)
    renderer.light(azimuth)
    seen, wheels = shown(scene, rollout), scene_angles(scene, rollout)
    row = [_picture(renderer, camera, seen, wheels, k) for k in frames]
    row = [
        _lettered(draw_ropes(image, camera, ropes_at(scene, rollout, k)), rollout.time[k])
        for image, k in zip(row, frames, strict=True)
    ]
    title = Image.new("RGB", (5 * SIZE[0], TITLE_PX), "white")
    prompt = fitted(doc.scene_definition.original_description, 11, 5 * SIZE[0] - 6)
    ImageDraw.Draw(title).text((3, 1), prompt, fill="black", font=font(11))
    return np.concatenate([np.asarray(title), np.concatenate(row, axis=1)])


def _picture(
    renderer: Renderer, camera: Camera, seen: Rollout, wheels: NDArray[np.float64], frame: int
) -> NDArray[np.uint8]:
    pose(renderer, seen, frame, wheels)
    return renderer.color(camera, SIZE, SAMPLES)


def _lettered(image: NDArray[np.uint8], time: float) -> NDArray[np.uint8]:
    """The picture with its time in a corner."""
    picture = Image.fromarray(image)
    ImageDraw.Draw(picture).text((4, SIZE[1] - 15), f"{time:.2f} s", fill="white", font=font(10))
    return np.asarray(picture)


if __name__ == "__main__":
    main()
