"""`esg render DATASET`: clips for the scenes of a finished dataset."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from esg.commands.datasets.clips import BatchOptions, RenderOptions, checked_spec
from esg.commands.datasets.dataset import make_batches, opened

if TYPE_CHECKING:
    from esg.dataset.clips.adding import Adding
    from esg.dataset.plan import Shard
    from esg.dataset.remote import Remote


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
        remote.pull_tables(folder.path)
    adding = begin_adding(folder, spec, batch=batches.batch, resume=batches.resume)
    with adding.scaffold.locked(shard), progress(len(adding.scenes), "starting") as bar:
        summary = _add(adding, shard, batches, remote, bar)
    if as_json:
        emit(summary)
    else:
        print(_described(summary))
    return 3 if summary["failed"] else 0


def _not_of_scenes(given: Mapping[str, bool]) -> None:
    from esg.outcomes import UserError

    names = [name for name, is_given in given.items() if is_given]
    if names:
        raise UserError(f"{', '.join(names)}: only for a scene, not for a dataset")


def _add(
    adding: Adding, shard: Shard, options: BatchOptions, remote: Remote | None, bar: Any
) -> dict[str, Any]:
    """Renders what this shard has left; whoever is last puts the clips in."""
    from esg.commands.datasets.layouts import lay_out, push_layouts
    from esg.dataset.clips.adding import SCAFFOLD, TABLES, add_clips, moving
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
            if lay_out(adding.folder, remote, bar.show) and remote is not None:
                push_layouts(adding.folder, remote)
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
