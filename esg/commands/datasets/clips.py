"""Options of clips, for `esg dataset --render` and `esg render DATASET`."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from esg.api.rendering import MAX_CAMERAS, directed_by, drawn_by

if TYPE_CHECKING:
    from esg.dataset.plan import RenderSpec


@Parameter(name="*")
@dataclass(frozen=True)
class RenderOptions:
    """What cameras see of every scene of a dataset.

    Args:
        render: Channels with commas between: rgb, depth, flow, backward_flow, segmentation, normal,
            object_coordinates, tracks, boxes; or all. Without it, nothing is rendered.
        cameras: How many, 1 to 8.
        size: Width x height in pixels, both even.
        fps: Frames a second of the clips.
        renderer: Of colours: raster (fast), path (Mitsuba) or cycles (Blender).
        samples: Rays a pixel; default what suits the renderer.
        camera: auto (the director chooses), static, tracking, dolly, orbit, dash or around.
        motion_blur: Let the shutter be open for half of the time between frames.
        lossless: Keep colours as they are, in files that browsers do not play.
    """

    render: str = ""
    cameras: int = 1
    size: str = "256x256"
    fps: float = 24.0
    renderer: str = "raster"
    samples: int | None = None
    camera: str = "auto"
    motion_blur: Annotated[bool, Parameter(negative="")] = False
    lossless: Annotated[bool, Parameter(negative="")] = False


@Parameter(name="*")
@dataclass(frozen=True)
class BatchOptions:
    """How a dataset is worked through when it is rendered.

    Args:
        shard: i/n renders the i-th of n parts; whoever finishes last puts the clips in.
        resume: Go on with a rendering that was begun.
        runner: Where batches run: worker processes, a Dask or a Ray cluster.
        workers: Batches at once; default one a core.
        batch: Scenes a batch.
        lossless: Keep colours as they are, in files that browsers do not play.
    """

    shard: str = "1/1"
    resume: Annotated[bool, Parameter(negative="")] = False
    runner: Literal["process", "dask", "ray"] = "process"
    workers: int | None = None
    batch: int | None = None
    lossless: Annotated[bool, Parameter(negative="")] = False


def is_dataset(place: str) -> bool:
    """Whether what is to be rendered is a dataset: a URL, or a folder with a plan."""
    from esg.dataset.folder import PLAN
    from esg.dataset.remote import is_url

    return is_url(place) or (Path(place) / PLAN).is_file()


def only_for_datasets(batches: BatchOptions | None) -> None:
    """That nothing is asked of a scene that only datasets have.

    Raises:
        UserError: Naming the options.
    """
    from esg.outcomes import UserError

    names = _given(batches or BatchOptions())
    if names:
        raise UserError(f"{names}: only for a dataset")


def _given(options: Any) -> str:
    """Options that are not at their defaults."""
    given = [f.name for f in fields(options) if getattr(options, f.name) != f.default]
    return ", ".join(f"--{name.replace('_', '-')}" for name in given)


def render_spec(options: RenderOptions | None, device: str) -> RenderSpec | None:
    """What is to be rendered; None for nothing.

    Args:
        options: As typed.
        device: As typed; checked by others.

    Raises:
        UserError: With all mistakes.
    """
    from esg.outcomes import UserError

    options = options or RenderOptions()
    if options.render:
        return checked_spec(options, device)
    names = _given(options)
    if names:
        raise UserError(f"{names}: give the channels to render as well, e.g. --render rgb,depth")
    return None


def checked_spec(options: RenderOptions, device: str) -> RenderSpec:
    """What is to be rendered.

    Raises:
        UserError: With all mistakes.
    """
    from esg.api.inputs import checked, in_range
    from esg.dataset.clips.encoding import check_encoders
    from esg.dataset.plan import RenderSpec

    channels, size, *_ = checked(
        lambda: parse_channels(options.render),
        lambda: even_size(options.size),
        lambda: in_range("--fps", options.fps, 0.1, 1000),
        lambda: in_range("--cameras", options.cameras, 1, MAX_CAMERAS),
        lambda: drawn_by(options.renderer, options.samples),
        lambda: directed_by(options.camera),
    )
    check_encoders(channels, lossless=options.lossless)
    return RenderSpec(
        channels=channels,
        cameras=options.cameras,
        size=size,
        fps=options.fps,
        renderer=options.renderer,
        samples=options.samples,
        camera=options.camera,
        motion_blur=options.motion_blur,
        lossless=options.lossless,
        device=device,
    )


def parse_channels(text: str) -> tuple[str, ...]:
    """Channels of a comma-separated list, `all` for all, in the order of the files.

    Raises:
        UserError: Naming every unknown one.
    """
    from esg.dataset.clips.encoding import CHANNELS
    from esg.outcomes import UserError

    if text.strip() == "all":
        return CHANNELS
    names = {n.strip() for n in text.split(",") if n.strip()}
    unknown = sorted(names - set(CHANNELS))
    if unknown or not names:
        what = f"unknown channel {', '.join(map(repr, unknown))}" if unknown else "no channel"
        raise UserError(f"{what}: choose from {', '.join(CHANNELS)}, or all")
    return tuple(c for c in CHANNELS if c in names)


def even_size(text: str) -> tuple[int, int]:
    """Width and height of e.g. `256x192`.

    Raises:
        UserError: If it is none, or odd: H.264 keeps colours for two by two pixels.
    """
    from esg.outcomes import UserError
    from esg.view.seeing.wanted import parse_size

    width, height = parse_size(text)
    if width % 2 or height % 2:
        raise UserError(f"--size {text}: films have an even width and height")
    return width, height


def check_same(asked: RenderSpec | None, begun: RenderSpec | None, place: str) -> None:
    """That a dataset goes on with the clips it was begun with.

    Args:
        asked: On the command line; None for what it was begun with.
        begun: Of the dataset.
        place: What messages call it.

    Raises:
        UserError: Naming every difference.
    """
    from esg.outcomes import UserError

    if asked is None or asked == begun:
        return
    if begun is None:
        raise UserError(
            f"{place} was begun without --render; finish it, then add clips: esg render {place}"
        )
    wanted: dict[str, Any] = asked.model_dump(mode="json")
    had: dict[str, Any] = begun.model_dump(mode="json")
    told = [f"  {k}: {wanted[k]!r}, not {had[k]!r}" for k in wanted if wanted[k] != had[k]]
    raise UserError(
        f"{place} was begun with other clips; repeat those, or choose another --out:\n"
        + "\n".join(told)
    )
