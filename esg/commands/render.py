"""`esg render`: ground-truth pictures of a finished scene, for learning."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from esg.api.rendering import Asked
from esg.commands.datasets.clips import BatchOptions, RenderOptions

if TYPE_CHECKING:
    from esg.view.seeing.wanted import Settings

_USUAL = Asked()


def render(
    scene: str,
    *,
    asked: Annotated[Asked, Parameter(name="*", negative="")] = _USUAL,
    out: Path | None = None,
    batches: BatchOptions | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Render a finished scene with exact depth, normals, masks, flow, boxes and tracks.

    Of a finished dataset, all replayed scenes that lack clips get them (docs/dataset/clips.md).

    Args:
        scene: Scene folder, or id of one below ./runs; or a dataset's folder or URL.
        asked: What pictures are made.
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
            asked.channels, asked.cameras, asked.size, asked.fps, asked.renderer, asked.samples,
            asked.camera or "auto", asked.motion_blur,
        )  # fmt: skip
        own = {"--format": asked.format != "png", "--seed": asked.seed != 0}
        own["--out"] = out is not None
        batches = batches or BatchOptions()
        return render_dataset(scene, wanted, batches, asked.device, own, as_json=json)
    chosen, folder, *_ = checked(
        lambda: settings_of(asked),
        lambda: find_scene(scene),
        lambda: None if out is None else check_writable(out),
        lambda: only_for_datasets(batches),
    )
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
