"""Options of clips, for `esg dataset --render` and `esg render DATASET`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.dataset.clips.adding import Adding
    from esg.dataset.plan import RenderSpec, Shard
    from esg.dataset.remote import Remote


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


def render_dataset(
    place: str,
    options: RenderOptions,
    batches: BatchOptions,
    device: str,
    of_scenes: Mapping[str, bool],
    *,
    as_json: bool,
) -> int:
    """Renders the scenes of a finished dataset that lack clips, and puts the clips in.

    Args:
        place: Folder or URL of the dataset.
        options: What to render.
        batches: How to go about it.
        device: cpu or cuda:N.
        of_scenes: Options that only scenes have, and whether each was given.
        as_json: Whether to print JSON.

    Returns:
        The exit code: 3 if scenes could not be rendered.
    """
    from esg.api.inputs import check_cache, check_device, check_workers, checked, in_range
    from esg.commands.console import emit, progress
    from esg.commands.dataset import opened
    from esg.dataset.clips.adding import begin_adding
    from esg.dataset.plan import Shard
    from esg.dataset.remote import checked_place

    spec, shard, place, *_ = checked(
        lambda: checked_spec(replace(options, lossless=batches.lossless), check_device(device)),
        lambda: Shard.parse(batches.shard),
        lambda: checked_place(place),
        lambda: _not_of_scenes(of_scenes),
        lambda: check_workers(batches.workers, 1),
        lambda: None if batches.batch is None else in_range("--batch", batches.batch, 1, 4096),
        check_cache,
    )
    folder, remote = opened(place)
    if remote is not None:
        remote.pull_tables(folder.path, TABLES)
    adding = begin_adding(folder, spec, batch=batches.batch, resume=batches.resume)
    with adding.scaffold.locked(shard), progress(len(adding.scenes), "starting") as bar:
        summary = _add(adding, shard, batches, remote, bar)
    if as_json:
        emit(summary)
    else:
        print(_described(summary))
    return 3 if summary["failed"] else 0


TABLES = ("scenes", "trajectories", "metrics", "clips")
"""What rendering reads of a dataset, and what it writes anew."""


def _not_of_scenes(given: Mapping[str, bool]) -> None:
    from esg.outcomes import UserError

    names = [name for name, is_given in given.items() if is_given]
    if names:
        raise UserError(f"{', '.join(names)}: only for a scene, not for a dataset")


def _add(
    adding: Adding, shard: Shard, options: BatchOptions, remote: Remote | None, bar: Any
) -> dict[str, Any]:
    """Renders what this shard has left; whoever is last puts the clips in."""
    from esg.commands.dataset import make_batches
    from esg.dataset.clips.adding import SCAFFOLD, add_clips, moving
    from esg.dataset.folder import finish_lock
    from esg.settings import STAGE_S

    far = remote.below(SCAFFOLD) if remote is not None else None
    scaffold, numbers = adding.scaffold, adding.numbers
    if not moving(adding):
        done = scaffold.done(numbers, far)
        bar.step(f"{sum(r.scenes for r in done.values())} rendered before", 0)
        left = [n for n in numbers if n % shard.count == shard.index - 1 and n not in done]
        if left:
            url = remote.url if remote is not None else ""
            jobs = adding.jobs(left, STAGE_S.value, url)
            make_batches(jobs, options.runner, options.workers, bar)
    with finish_lock(scaffold.path):
        done = scaffold.done(numbers, far) if not moving(adding) else scaffold.marked(numbers)
        complete = len(done) == len(numbers)
        failed = sum(len(r.failures) for r in done.values())
        if complete:
            bar.show("putting in")
            if far is not None:
                far.pull(scaffold.path, far.names("parts"))
            add_clips(adding, done)
            if remote is not None:
                remote.push_clips(adding.folder.path, TABLES, SCAFFOLD)
    return {
        "dataset": remote.url if remote is not None else str(adding.folder.path),
        "scenes": len(adding.scenes),
        "cameras": adding.spec.render.cameras if adding.spec.render else 0,
        "failed": failed,
        "complete": complete,
    }


def _described(summary: Mapping[str, Any]) -> str:
    state = "complete" if summary["complete"] else "other shards are missing"
    scenes, failed = summary["scenes"], summary["failed"]
    lines = [
        f"{scenes - failed} of {scenes} scenes rendered by {summary['cameras']} cameras in "
        f"{summary['dataset']} ({state})"
    ]
    if failed:
        lines.append(f"  why others were not: {summary['dataset']}/failures.jsonl")
    return "\n".join(lines)


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
    from esg.commands.render import MAX_CAMERAS, directed_by, drawn_by
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
    from esg.view.wanted import parse_size

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
