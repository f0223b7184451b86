"""Ground-truth pictures of finished scenes: what is asked for, checked, and how they are made."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    from esg.view.seeing.wanted import Settings

MAX_CAMERAS = 8
MAX_SAMPLES = 65536
Watch = Callable[[int], contextlib.AbstractContextManager[Callable[[int], None]]]


@contextlib.contextmanager
def _unwatched(_: int) -> Generator[Callable[[int], None]]:
    yield lambda _: None


@dataclass(frozen=True)
class Asked:
    """What pictures are asked for, unchecked.

    Args:
        channels: Of rgb, depth, normal, segmentation, flow, backward_flow, object_coordinates,
            boxes2d, boxes3d (boxes: both), tracks, with commas between; or all.
        size: Width x height in pixels.
        fps: Frames a second.
        cameras: How many, 1 to 8.
        camera: around (they stand around the whole action), or a director's that stay close: auto,
            static, tracking, dolly, orbit or dash (from a vehicle). Default around, of a dataset
            auto.
        format: png writes files, parquet shards of rows; a dataset's clips are films.
        device: cpu or cuda:N.
        seed: Of the points that tracks follow, of noise and of clouds; scenes of a dataset have
            their own.
        renderer: Of colours: raster (fast), path (Mitsuba), cycles (a Blender on this machine); the
            other channels are exact with all of them.
        samples: Rays a pixel; default what suits the renderer.
        motion_blur: Let the shutter be open for half of the time between frames.
    """

    channels: str = "rgb,depth,segmentation"
    size: str = "256x256"
    fps: float = 24.0
    cameras: int = 1
    camera: str = ""
    format: Literal["png", "parquet"] = "png"
    device: str = "cpu"
    seed: int = 0
    renderer: str = "raster"
    samples: int | None = None
    motion_blur: bool = False


def settings_of(asked: Asked) -> Settings:
    """Checked settings.

    Raises:
        UserError: Naming the options and what they take.
    """
    from esg.api.inputs import check_device, check_seed, checked, in_range
    from esg.view.seeing.wanted import Settings, parse_channels, parse_size

    names, pixels, *_, (renderer, samples), camera, device, seed = checked(
        lambda: parse_channels(asked.channels),
        lambda: parse_size(asked.size),
        lambda: in_range("--fps", asked.fps, 0.1, 1000),
        lambda: in_range("--cameras", asked.cameras, 1, MAX_CAMERAS),
        lambda: drawn_by(asked.renderer, asked.samples),
        lambda: directed_by(asked.camera or "around"),
        lambda: check_device(asked.device),
        lambda: check_seed(asked.seed),
    )
    return Settings(
        names, pixels, asked.fps, asked.cameras, asked.format, device, seed, renderer, samples,
        asked.motion_blur, camera,
    )  # fmt: skip


def directed_by(camera: str) -> str:
    """A checked kind of camera.

    Raises:
        UserError: Naming those there are.
    """
    from esg.outcomes import UserError
    from esg.view.director.paths import KINDS

    known = ("around", "auto", *KINDS)
    if camera not in known:
        raise UserError(f"--camera {camera!r}: choose from {', '.join(known)}")
    return camera


def drawn_by(renderer: str, samples: int | None) -> tuple[str, int | None]:
    """Checked renderer and its rays a pixel.

    Raises:
        UserError: Naming the options and what they take, or what the renderer lacks here.
    """
    from esg.api.inputs import checked, in_range
    from esg.view.renderers.kinds import kind_named

    kind, _ = checked(
        lambda: kind_named(renderer),
        lambda: None if samples is None else in_range("--samples", samples, 1, MAX_SAMPLES),
    )
    kind.version()
    return renderer, samples


def render_scene(
    folder: Path,
    out: Path,
    chosen: Settings,
    watch: Watch = _unwatched,
) -> dict[str, Any]:
    """Renders one scene folder.

    Args:
        folder: Scene folder.
        out: The capture's folder.
        chosen: What to render.
        watch: Takes the number of pictures; what it gives is told how many more are drawn.

    Returns:
        The capture's folder and what is in it, as `esg render --json` prints it.

    Raises:
        UserError: If the folder holds no replayed scene.
    """
    import json

    from esg.files import atomic_write, refused
    from esg.graph import load_document
    from esg.metrics import SceneVerdict
    from esg.outcomes import UserError
    from esg.report.replays import replays_of
    from esg.report.run import read_scene
    from esg.view.capture import capture
    from esg.view.seeing.witness import frame_indices
    from esg.view.truth_sheet import truth_sheet

    entry = read_scene(folder)
    if entry.problems:
        raise UserError("\n".join(entry.problems))
    replays = replays_of(folder, entry.metrics)
    if not replays:
        raise UserError(f"{folder} was never replayed; its log.jsonl says why")
    verdict = SceneVerdict.from_json(entry.verdict)
    scene, rollout = replays[0].scene, replays[0].rollout
    total = len(frame_indices(rollout, chosen.fps)) * chosen.cameras
    document = load_document(folder / "esg.json")
    with watch(total) as drawn:
        path = capture(scene, rollout, verdict, document, out, chosen, on_frames=drawn)
    events = [e.time_s for e in verdict.events if e.completed and e.time_s is not None]
    moment = min(events, default=0.0)
    with refused(path / "sheet.png"):
        atomic_write(path / "sheet.png", lambda partial: truth_sheet(path, partial, moment))
    manifest = json.loads((path / "manifest.json").read_bytes())
    return {
        "scene": str(folder),
        "folder": str(path),
        "pictures": total,
        "cameras": chosen.cameras,
        "frames": manifest["frames"],
        "channels": list(chosen.channels),
        "format": chosen.container,
        "renderer": manifest["renderer"],
    }
