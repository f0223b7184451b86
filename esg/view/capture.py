"""Ground truth of a scene on disk: pictures, depth, normals, masks, flow, boxes, tracks.

Every picture is a PNG, in a folder a camera or inside sharded Parquet; `manifest.json` says how to
read them, and holds intrinsics and extrinsics of every camera and the id of every body.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
import json
import os
from pathlib import Path
import shutil
import tempfile
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.engines.scene import Rollout, SimScene
from esg.files import explained, refused
from esg.outcomes import UserError
from esg.view import png16, truth
from esg.view.camera import Camera
from esg.view.containers import FileSink, ParquetSink
from esg.view.renderers.kinds import kind_named
from esg.view.seeing import codes
from esg.view.seeing.wanted import PICTURES, Settings
from esg.view.seeing.witness import Shot, Sight, shots, sight_of
from esg.view.worlds import Views

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict

FORMAT_VERSION = "2.0"
FLOW_SCALE, FLOW_ZERO = 64.0, 32768
ENCODINGS = {
    "rgb": "8-bit RGB",
    "depth": "16-bit: distance along the camera's axis [m] is exp(offset + scale * code), with "
    "depth_offset and depth_scale of the camera's frame; 0 nothing",
    "normal": "16-bit RGB: (n + 1) / 2 * 65534, world frame; black nothing",
    "segmentation": "16-bit: 0 nothing, 1 ground, else the id of a body",
    "flow": "16-bit RGB as of KITTI: (u, v) = (R - 32768, G - 32768) / 64 px to the next frame; "
    "B is 1 where it is known (0 in the last frame and beyond 511 px)",
    "backward_flow": "as flow, to the frame before; unknown in the first frame",
    "object_coordinates": "16-bit RGB: 1 + 65534 * share of the way from the lower to the upper "
    "corner of the body's bounds_m, in its own axes; black where there is no body",
    "boxes2d": "tight box of what is visible: x0, y0, x1, y1 [px], ends exclusive",
    "boxes3d": "oriented bounding box in the world [m] and its corners [px]",
    "tracks": "pixels of points fixed on the bodies, and whether they are visible",
}


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
        sight = sight_of(scene, rollout, verdict, doc, settings, cameras=cameras)
        with refused(folder):
            _write(sight, doc, work, on_frames)
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


def _write(sight: Sight, doc: EsgDocument, folder: Path, on_frames: Callable[[int], None]) -> None:
    manifest = _manifest(sight, doc)
    sink: Any = ParquetSink(folder) if sight.settings.container == "parquet" else FileSink(folder)
    for number, shot in enumerate(shots(sight)):
        scales: list[tuple[float, float]] = []
        for numbers, views in shot.drawn():
            for k, at in enumerate(numbers):
                sink.add(number, at, float(sight.time_s[at]), _row(shot, views, k, at, scales))
            on_frames(len(numbers))
        if scales:
            offset, scale = (list(values) for values in zip(*scales, strict=True))
            manifest["cameras"][number] |= {"depth_offset": offset, "depth_scale": scale}
    manifest["shards"] = sink.close()
    text = json.dumps(manifest, indent=2, ensure_ascii=False, allow_nan=False)
    (folder / "manifest.json").write_text(text + "\n", encoding="utf-8")


def _row(
    shot: Shot, views: Views, k: int, at: int, scales: list[tuple[float, float]]
) -> dict[str, Any]:
    """Encoded channels of picture `at`, number `k` of its batch; depth adds to `scales`."""
    depth, body = views.depth[k], views.body[k]
    pictures: dict[str, Any] = {}

    def flow(to: int) -> Any:
        return encode_flow(shot.flow(at, to, depth, views.mover[k]))

    def metres() -> Any:
        found, offset, scale = codes.depth_codes(depth)
        scales.append((float(offset), float(scale)))
        return found

    def places() -> Any:
        found = shot.places(at, depth, views, k)
        return codes.place_codes(np.nan_to_num(found), body >= 0)

    draw: dict[str, Callable[[], Any]] = {
        "rgb": lambda: views.rgb[k] if views.rgb is not None else None,
        "depth": metres,
        "normal": lambda: codes.normal_codes(views.normal[k]),
        "segmentation": lambda: truth.segment_ids(body),
        "flow": lambda: flow(at + 1),
        "backward_flow": lambda: flow(at - 1),
        "object_coordinates": places,
    }
    wanted = shot.sight.settings.channels
    for name in (c for c in PICTURES if c in wanted):
        pictures[name] = png16.encode(draw[name]())
    out = pictures
    if "boxes2d" in wanted:
        out["boxes2d"] = shot.boxes_2d(body)
    if "boxes3d" in wanted:
        out["boxes3d"] = shot.boxes_3d(at)
    if "tracks" in wanted:
        pixels, seen = shot.tracks(at, depth, body)
        out["tracks"] = {
            "xy_px": np.round(pixels, 3).tolist(),
            "visible": [bool(v) for v in seen],
        }
    return out


def encode_flow(shift: Any) -> Any:
    """Shifts, NaN where unknown, as uint16, shape [H, L, 3]; see `ENCODINGS`."""
    out = np.zeros((*shift.shape[:2], 3), np.uint16)
    numbers = np.rint(np.nan_to_num(np.asarray(shift, float), nan=np.inf) * FLOW_SCALE) + FLOW_ZERO
    known = np.all((numbers >= 0) & (numbers <= 65535), axis=-1)
    out[..., :2] = np.where(known[..., None], numbers, 0).astype(np.uint16)
    out[..., 2] = known
    return out


def decode_flow(image: Any) -> tuple[Any, Any]:
    """Shifts [px], shape [H, L, 2], and where they are known, shape [H, L]."""
    return (image[..., :2].astype(float) - FLOW_ZERO) / FLOW_SCALE, image[..., 2] == 1


def _manifest(sight: Sight, doc: EsgDocument) -> dict[str, Any]:
    scene, rollout, settings = sight.scene, sight.rollout, sight.settings
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
        "frames": len(sight.frames),
        "time_s": [round(float(t), 6) for t in sight.time_s],
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
    for number, take in enumerate(sight.takes):
        out["cameras"].append({"name": f"camera_{number}", **take.record(settings.size)})
    if "object_coordinates" in settings.channels:
        for body, bounds in zip(out["bodies"], sight.bounds, strict=True):
            body["bounds_m"] = np.round(bounds, 6).tolist()
    if "tracks" in settings.channels:
        out["track_points"] = {
            "id": (sight.tracked.owner + 2).tolist(),
            "point_m": np.round(sight.tracked.points, 5).tolist(),
        }
    return out
