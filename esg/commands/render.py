"""`esg render`: ground-truth pictures of a finished scene, for learning."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from esg.commands.datasets.clips import BatchOptions, RenderOptions

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
    from esg.api.inputs import checked, find_scene
    from esg.api.rendering import settings_of
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
    chosen, folder, *_ = checked(
        lambda: settings_of(
            channels, size, fps, cameras, camera=camera or "around", format=format, device=device,
            seed=seed, renderer=renderer, samples=samples, motion_blur=motion_blur,
        ),
        lambda: find_scene(scene),
        lambda: None if out is None else check_writable(out),
        lambda: only_for_datasets(batches),
    )  # fmt: skip
    result = run(folder, out or folder / "render", chosen)
    if json:
        emit(result)
    else:
        print(f"{result['folder']}: {result['pictures']} pictures of {', '.join(chosen.channels)}")
    return 0


def run(folder: Path, out: Path, chosen: Settings) -> dict[str, Any]:
    """Renders one scene folder beside a progress bar (`esg.api.rendering.render_scene`)."""
    from esg.api.rendering import render_scene

    return render_scene(folder, out, chosen, _bar)


@contextlib.contextmanager
def _bar(pictures: int) -> Generator[Callable[[int], None]]:
    from esg.commands.console import progress

    with progress(pictures, "rendering") as bar:
        yield lambda count: bar.step("rendering", count)
