"""`esg render`: ground-truth pictures of a finished scene, for learning."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from esg.commands.datasets.clips import (
    MAX_CAMERAS,
    BatchOptions,
    RenderOptions,
    directed_by,
    drawn_by,
)

if TYPE_CHECKING:
    from esg.view.seeing.wanted import Settings


def render(
    scene: str,
    *,
    channels: str = "rgb,depth,segmentation",
    size: str = "256x256",
    fps: float = 24.0,
    cameras: int = 1,
    camera: str = "",
    format: Literal["png", "parquet"] = "png",
    device: str = "cpu",
    seed: int = 0,
    renderer: str = "raster",
    samples: int | None = None,
    motion_blur: Annotated[bool, Parameter(negative="")] = False,
    out: Path | None = None,
    batches: BatchOptions | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Render a finished scene with exact depth, normals, masks, flow, boxes and tracks.

    Of a finished dataset, all replayed scenes that lack clips get them (docs/dataset/clips.md).

    Args:
        scene: Scene folder, or id of one below ./runs; or a dataset's folder or URL.
        channels: Of rgb, depth, normal, segmentation, flow, backward_flow, object_coordinates,
            boxes2d, boxes3d (boxes: both), tracks; or all.
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
        out: Folder to write; default render in the scene folder.
        batches: How a dataset is worked through.
        json: Print one JSON document: the folder and what is in it.
    """
    from esg.api.inputs import check_device, check_seed, checked, find_scene
    from esg.commands.console import emit
    from esg.commands.datasets.clips import is_dataset, only_for_datasets
    from esg.scenefolder import check_writable

    if is_dataset(scene):
        from esg.commands.datasets.adding import render_dataset

        wanted = RenderOptions(
            channels, cameras, size, fps, renderer, samples, camera or "auto", motion_blur
        )
        own = {"--format": format != "png", "--seed": seed != 0, "--out": out is not None}
        return render_dataset(scene, wanted, batches or BatchOptions(), device, own, as_json=json)
    chosen, (renderer, samples), camera, device, seed, folder, *_ = checked(
        lambda: settings(channels, size, fps, cameras, format),
        lambda: drawn_by(renderer, samples),
        lambda: directed_by(camera or "around"),
        lambda: check_device(device),
        lambda: check_seed(seed),
        lambda: find_scene(scene),
        lambda: None if out is None else check_writable(out),
        lambda: only_for_datasets(batches),
    )
    chosen = replace(
        chosen, camera=camera, device=device, seed=seed, renderer=renderer, samples=samples,
        motion_blur=motion_blur,
    )  # fmt: skip
    result = run(folder, out or folder / "render", chosen)
    if json:
        emit(result)
    else:
        print(f"{result['folder']}: {result['pictures']} pictures of {', '.join(chosen.channels)}")
    return 0


def settings(
    channels: str, size: str, fps: float, cameras: int, format: Literal["png", "parquet"]
) -> Settings:
    """Checked settings, for the CPU and seed 0.

    Raises:
        UserError: Naming the options and what they take.
    """
    from esg.api.inputs import checked, in_range
    from esg.view.seeing.wanted import Settings, parse_channels, parse_size

    names, pixels, *_ = checked(
        lambda: parse_channels(channels),
        lambda: parse_size(size),
        lambda: in_range("--fps", fps, 0.1, 1000),
        lambda: in_range("--cameras", cameras, 1, MAX_CAMERAS),
    )
    return Settings(names, pixels, fps, cameras, format)


def run(folder: Path, out: Path, chosen: Settings) -> dict[str, Any]:
    """Renders one scene folder.

    Args:
        folder: Scene folder.
        out: The capture's folder.
        chosen: What to render.

    Raises:
        UserError: If the folder holds no replayed scene.
    """
    import json

    from esg.commands.console import progress
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
    with progress(total, "rendering") as bar:
        path = capture(
            scene,
            rollout,
            verdict,
            load_document(folder / "esg.json"),
            out,
            chosen,
            on_frames=lambda n: bar.step("rendering", n),
        )
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
