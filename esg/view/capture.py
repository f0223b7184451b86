"""Ground truth of a scene on disk: pictures, depth, normals, masks, flow, boxes, tracks.

Every picture is a PNG, in a folder a camera or inside sharded Parquet; `manifest.json` says how to
read them, and holds intrinsics and extrinsics of every camera and the id of every body.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
import json
import math
import os
from pathlib import Path
import shutil
import tempfile
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from esg.engines.breaking import shown
from esg.engines.scene import Rollout, SimScene
from esg.engines.wheels import scene_angles
from esg.files import explained, refused
from esg.outcomes import UserError
from esg.view import png16, truth
from esg.view.camera import Camera
from esg.view.cameras import Takes, action_cameras, directed
from esg.view.containers import PICTURES, FileSink, ParquetSink
from esg.view.director.acting import Action
from esg.view.director.review import PROBE_PX, Viewfinder
from esg.view.director.staging import AUTO
from esg.view.director.takes import standing
from esg.view.film.shooting import viewfinder
from esg.view.parts import scene_parts
from esg.view.pieces import Movers
from esg.view.renderers.kinds import kind_named
from esg.view.renderers.records import Quality
from esg.view.renderers.shutter import OPEN, poses_at
from esg.view.scenery import scenery_of, seen_from
from esg.view.truth import Pinhole
from esg.view.worlds import Views

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict

FORMAT_VERSION = "1.0"
CHANNELS = (*PICTURES, "boxes2d", "boxes3d", "tracks")
DEPTH_UNIT_M = 0.001
FLOW_SCALE, FLOW_ZERO = 64.0, 32768
ENCODINGS = {
    "rgb": "8-bit RGB",
    "depth": "16-bit: distance along the camera's axis [mm]; 0 nothing, 65535 farther than 65.5 m",
    "normal": "16-bit RGB: (n + 1) / 2 * 65534, world frame; black nothing",
    "segmentation": "16-bit: 0 nothing, 1 ground, else the id of a body",
    "flow": "16-bit RGB as of KITTI: (u, v) = (R - 32768, G - 32768) / 64 px to the next frame; "
    "B is 1 where it is known (0 in the last frame and beyond 511 px)",
    "boxes2d": "tight box of what is visible: x0, y0, x1, y1 [px], ends exclusive",
    "boxes3d": "oriented bounding box in the world [m] and its corners [px]",
    "tracks": "pixels of points fixed on the bodies, and whether they are visible",
}


@dataclass(frozen=True)
class Settings:
    """What to render.

    Args:
        channels: Of `CHANNELS`.
        size: Width and height [px].
        fps: Frames a second.
        cameras: How many, 1 to 8.
        container: png writes files, parquet shards of rows.
        device: cpu or cuda:N.
        seed: Of the points that are tracked, of noise and of clouds.
        renderer: Of `esg.view.renderers.kinds`, for colours; the other channels are exact.
        samples: Rays a pixel; None for what the renderer takes by itself.
        motion_blur: Colours are those of all the time the shutter is open.
        camera: `around` for cameras that stand around the whole action, or what the director may
            choose from: `auto`, or one of `esg.view.director.paths.KINDS`.
    """

    channels: tuple[str, ...] = ("rgb", "depth", "segmentation")
    size: tuple[int, int] = (256, 256)
    fps: float = 24.0
    cameras: int = 1
    container: Literal["png", "parquet"] = "png"
    device: str = "cpu"
    seed: int = 0
    renderer: str = "raster"
    samples: int | None = None
    motion_blur: bool = False
    camera: str = "around"

    @property
    def open_s(self) -> float:
        """How long the shutter is open [s]."""
        return OPEN / self.fps if self.motion_blur else 0.0


def parse_channels(text: str) -> tuple[str, ...]:
    """Channels of a comma-separated list, `all` for all.

    Raises:
        UserError: Naming every unknown one.
    """
    if text.strip() == "all":
        return CHANNELS
    names = tuple(dict.fromkeys(n.strip() for n in text.split(",") if n.strip()))
    unknown = [n for n in names if n not in CHANNELS]
    if unknown or not names:
        what = f"unknown channel {', '.join(map(repr, unknown))}" if unknown else "no channel"
        raise UserError(f"{what}: choose from {', '.join(CHANNELS)}, with commas, or all")
    return names


def parse_size(text: str) -> tuple[int, int]:
    """Width and height of e.g. `256x192`.

    Raises:
        UserError: If it is none, or not between 16 and 4096.
    """
    parts = text.lower().replace("×", "x").split("x")
    if len(parts) == 2 and all(p.strip().isdigit() for p in parts):
        width, height = (int(p) for p in parts)
        if 16 <= width <= 4096 and 16 <= height <= 4096:
            return width, height
    raise UserError(f"--size {text!r}: give width x height in pixels, e.g. 256x256 (16 to 4096)")


def capture(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    folder: Path,
    settings: Settings,
    *,
    cameras: Sequence[Camera] | None = None,
    on_frames: Callable[[int], None] = lambda _: None,
) -> Path:
    """Writes the ground truth of a replay.

    Args:
        scene: The bodies.
        rollout: The replay; its first world.
        verdict: Events, for the cameras.
        doc: Asset configurations (meshes) and the prompt.
        folder: Appears complete or not at all; an older capture is replaced.
        settings: What to render.
        cameras: Fixed cameras; default some that see the action.
        on_frames: Called with the number of finished pictures.

    Returns:
        The folder.

    Raises:
        UserError: If the folder exists and is no capture, or cannot be written.
    """
    if folder.exists() and not is_capture(folder):
        raise UserError(f"{folder} exists and holds no capture; move it or choose another --out")
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(prefix=f".{folder.name}.", suffix=".tmp", dir=folder.parent))
    except OSError as error:
        raise UserError(f"cannot write to {folder}: {explained(error, folder).strerror}") from None
    try:
        takes = _takes(scene, rollout, verdict, doc, settings, cameras)
        with refused(folder):
            _write(scene, rollout, doc, takes, work, settings, on_frames)
            work.chmod(0o755)
            if folder.exists():
                shutil.rmtree(folder)
            os.replace(work, folder)
    except BaseException:
        shutil.rmtree(work, ignore_errors=True)
        raise
    return folder


def is_capture(folder: Path) -> bool:
    """Whether `capture` wrote this folder."""
    try:
        return "esg_capture" in json.loads((folder / "manifest.json").read_bytes())
    except (OSError, ValueError):
        return False


def frame_indices(rollout: Rollout, fps: float) -> list[int]:
    """Frames of the rollout nearest to every 1/fps, the first included."""
    time = np.asarray(rollout.time, float)
    wanted = np.arange(math.floor(time[-1] * fps + 1e-6) + 1) / fps
    right = np.clip(np.searchsorted(time, wanted), 0, len(time) - 1)
    left = np.maximum(right - 1, 0)
    return np.where(wanted - time[left] <= time[right] - wanted, left, right).tolist()


def _takes(
    scene: SimScene,
    rollout: Rollout,
    verdict: SceneVerdict | None,
    doc: EsgDocument,
    settings: Settings,
    cameras: Sequence[Camera] | None,
) -> Takes:
    """Cameras at the times of all frames."""
    times = np.asarray(rollout.time, float)[frame_indices(rollout, settings.fps)]
    width, height = settings.size
    if cameras or settings.camera == "around":
        around = partial(action_cameras, scene, rollout, verdict, doc, settings.cameras)
        return [standing(camera, times) for camera in cameras or around(width / height)]
    action = Action(scene, rollout, verdict, doc)
    finder = viewfinder(action, doc, scene_parts(scene, rollout, doc))
    finder = Viewfinder(
        action, finder.scan, (PROBE_PX[0], max(1, PROBE_PX[0] * height // width)), finder.around
    )
    kinds = AUTO if settings.camera == "auto" else (settings.camera,)
    return [take.at(times) for take in directed(finder, kinds, settings.cameras, settings.seed)]


def _write(
    scene: SimScene,
    rollout: Rollout,
    doc: EsgDocument,
    takes: Takes,
    folder: Path,
    settings: Settings,
    on_frames: Callable[[int], None],
) -> None:
    scenery = scenery_of(scene, rollout, doc)
    rollout = shown(scene, rollout)
    frames = frame_indices(rollout, settings.fps)
    points, owner = _tracked(scenery.parts, len(scene.bodies), settings)
    manifest = _manifest(scene, rollout, doc, takes, frames, settings, points, owner)
    sink: Any = ParquetSink(folder) if settings.container == "parquet" else FileSink(folder)
    color = "rgb" in settings.channels
    # Without colours there is nothing for the other renderers to do better.
    kind = kind_named(settings.renderer if color else "raster")
    exact = set(settings.channels) != {"rgb"}
    quality = Quality(
        settings.size, settings.samples, settings.seed, settings.device, exact=exact, color=color
    )
    angles = scene_angles(scene, rollout)
    movers = Movers(scenery.parts, len(scene.bodies))
    moved = movers.poses(rollout.position[0], rollout.quaternion[0], angles)
    for number, take in enumerate(takes):
        cameras = take.cameras
        still = Pinhole.of(cameras[0], settings.size)
        holes = [still if c == cameras[0] else Pinhole.of(c, settings.size) for c in cameras]
        drawer = kind.load(seen_from(scenery, _some(cameras), scene, rollout), quality)
        for first in range(0, len(frames), kind.batch):
            drawn = frames[first : first + kind.batch]
            poses = poses_at(rollout, drawn, angles, settings.open_s)
            views = drawer.draw(poses, cameras[first : first + len(drawn)])
            for k in range(len(drawn)):
                row = _row(
                    views, k, holes, scene, moved, frames, first + k, settings, points, owner
                )
                sink.add(number, first + k, float(rollout.time[drawn[k]]), row)
            on_frames(len(drawn))
    manifest["shards"] = sink.close()
    text = json.dumps(manifest, indent=2, ensure_ascii=False, allow_nan=False)
    (folder / "manifest.json").write_text(text + "\n", encoding="utf-8")


def _some(cameras: Sequence[Camera]) -> list[Camera]:
    """At most eight of a take's cameras, the first one included."""
    return list(dict.fromkeys(cameras[:: max(1, len(cameras) // 7)]))


def _row(
    views: Views,
    k: int,
    pinholes: Sequence[Pinhole],
    scene: SimScene,
    moved: tuple[Any, Any],
    frames: list[int],
    at: int,
    settings: Settings,
    points: Any,
    owner: Any,
) -> dict[str, Any]:
    """Encoded channels of one picture; `moved` are the poses of bodies and wheels."""
    wanted, pinhole = settings.channels, pinholes[at]
    depth, body = views.depth[k], views.body[k]
    f = frames[at]
    position, quaternion = (v[f].astype(float) for v in moved)
    row: dict[str, Any] = {}
    if views.rgb is not None:
        row["rgb"] = png16.encode(views.rgb[k])
    if "depth" in wanted:
        row["depth"] = png16.encode(encode_depth(depth))
    if "normal" in wanted:
        row["normal"] = png16.encode(encode_normal(views.normal[k]))
    if "segmentation" in wanted:
        row["segmentation"] = png16.encode(truth.segment_ids(body))
    if "flow" in wanted:
        shift = None
        if at + 1 < len(frames):
            at_next, turn_next = (v[frames[at + 1]].astype(float) for v in moved)
            now, later = (position, quaternion), (at_next, turn_next)
            moves = pinholes[at + 1] if pinholes[at + 1] is not pinhole else None
            shift = truth.flow(pinhole, depth, views.mover[k], now, later, moves)
        row["flow"] = png16.encode(encode_flow(shift, depth.shape))
    if "boxes2d" in wanted:
        row["boxes2d"] = [_identified(b) for b in truth.boxes_2d(body)]
    if "boxes3d" in wanted:
        half = np.array([b.half_extents for b in scene.bodies])
        offset = np.array([b.origin_offset for b in scene.bodies])
        n = len(scene.bodies)
        found = truth.boxes_3d(pinhole, half, offset, position[:n], quaternion[:n])
        row["boxes3d"] = [_identified(b) for b in found]
    if "tracks" in wanted:
        pixels, seen = truth.track(pinhole, depth, body, owner, points, position, quaternion)
        row["tracks"] = {
            "xy_px": np.round(pixels, 3).tolist(),
            "visible": [bool(v) for v in seen],
        }
    return row


def _identified(box: dict[str, Any]) -> dict[str, Any]:
    return {"id": box["body"] + 2, **{k: v for k, v in box.items() if k != "body"}}


def encode_depth(depth: Any) -> Any:
    """Millimetres as uint16, shape [H, L]; see `ENCODINGS`."""
    return np.clip(np.rint(np.asarray(depth, float) / DEPTH_UNIT_M), 0, 65535).astype(np.uint16)


def encode_normal(normal: Any) -> Any:
    """Components as uint16, shape [H, L, 3]; see `ENCODINGS`."""
    hit = np.abs(normal).sum(axis=-1, keepdims=True) > 0
    codes = np.rint((np.clip(normal, -1, 1) + 1) / 2 * 65534)
    return np.where(hit, codes, 0).astype(np.uint16)


def encode_flow(shift: Any, shape: tuple[int, ...]) -> Any:
    """Shifts as uint16, shape [H, L, 3]; None where there is no next frame; see `ENCODINGS`."""
    out = np.zeros((*shape, 3), np.uint16)
    if shift is None:
        return out
    codes = np.rint(np.asarray(shift, float) * FLOW_SCALE) + FLOW_ZERO
    known = np.all((codes >= 0) & (codes <= 65535), axis=-1)
    out[..., :2] = np.where(known[..., None], codes, 0).astype(np.uint16)
    out[..., 2] = known
    return out


def decode_flow(image: Any) -> tuple[Any, Any]:
    """Shifts [px], shape [H, L, 2], and where they are known, shape [H, L]."""
    return (image[..., :2].astype(float) - FLOW_ZERO) / FLOW_SCALE, image[..., 2] == 1


def _tracked(parts: Any, n_bodies: int, settings: Settings) -> tuple[Any, Any]:
    """Points fixed on the bodies, shape [n, 3], and the body of each, shape [n]."""
    if "tracks" not in settings.channels:
        return np.zeros((0, 3)), np.zeros(0, np.int64)
    points, owner = [], []
    for body in range(n_bodies):
        mine = [p for p in parts if p.body == body and p.wheel is None]
        if not mine:
            continue
        starts = np.cumsum([0, *(len(p.vertices) for p in mine[:-1])])
        vertices = np.concatenate([p.vertices for p in mine])
        faces = np.concatenate([p.faces + s for p, s in zip(mine, starts, strict=True)])
        rng = np.random.default_rng([settings.seed, body])
        points.append(truth.sample_points(vertices, faces, truth.TRACKS_PER_BODY, rng))
        owner += [body] * truth.TRACKS_PER_BODY
    if not points:
        return np.zeros((0, 3)), np.zeros(0, np.int64)
    return np.concatenate(points), np.array(owner)


def _manifest(
    scene: SimScene,
    rollout: Rollout,
    doc: EsgDocument,
    takes: Takes,
    frames: list[int],
    settings: Settings,
    points: Any,
    owner: Any,
) -> dict[str, Any]:
    width, height = settings.size
    out: dict[str, Any] = {
        "esg_capture": FORMAT_VERSION,
        "scene_id": scene.scene_id,
        "prompt": doc.scene_definition.original_description,
        "engine": rollout.engine,
        "dt_s": float(rollout.dt),
        "width_px": width,
        "height_px": height,
        "fps": settings.fps,
        "frames": len(frames),
        "time_s": [round(float(rollout.time[f]), 6) for f in frames],
        "channels": {name: ENCODINGS[name] for name in settings.channels},
        "container": settings.container,
        "renderer": {
            "name": settings.renderer,
            "version": kind_named(settings.renderer).version(),
            "samples": settings.samples or kind_named(settings.renderer).samples,
            "shutter_open_s": settings.open_s,
        },
        "conventions": {
            "world": "right-handed, Z up, metres",
            "camera": "x right, y down, z ahead (OpenCV)",
            "pixels": "x right, y down, centre of the first pixel at (0.5, 0.5)",
            "quaternion": "x, y, z, w",
        },
        "cameras": [],
        "bodies": [
            {
                "id": k + 2,
                "name": b.name,
                "label": b.label,
                "category": b.category,
                "static": b.static,
            }
            for k, b in enumerate(scene.bodies)
        ],
    }
    for number, take in enumerate(takes):
        out["cameras"].append({"name": f"camera_{number}", **take.record(settings.size)})
    if "tracks" in settings.channels:
        out["track_points"] = {
            "id": (owner + 2).tolist(),
            "point_m": np.round(points, 5).tolist(),
        }
    return out
