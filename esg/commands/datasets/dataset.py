"""`esg dataset`: many scenes, from prompts or from the scene grammar, as Parquet."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
import os
from pathlib import Path
import shutil
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from esg.commands.datasets.clips import RenderOptions
from esg.commands.datasets.drawing import DrawOptions
from esg.commands.datasets.layouts import LayoutOptions
from esg.commands.drafting import RULES, Drafting
from esg.dataset.whatifs.options import TEXTS, TruthOptions

if TYPE_CHECKING:
    from esg.dataset.folder import DatasetFolder
    from esg.dataset.job import BatchJob, BatchResult
    from esg.dataset.plan import DatasetSpec, Prompt, Shard
    from esg.dataset.remote import Remote
    from esg.draft.llm.gathering import Gathered


def dataset(
    *,
    out: str,
    prompts: Path | None = None,
    sample: int | None = None,
    shard: str = "1/1",
    resume: Annotated[bool, Parameter(negative="")] = False,
    seed: int = 0,
    draw: Annotated[DrawOptions, Parameter(name="*")] = DrawOptions(),  # noqa: B008  # frozen
    runner: Literal["process", "dask", "ray"] = "process",
    workers: int | None = None,
    batch: int | None = None,
    mcap: Literal["all", "failed", "sample", "none"] = "none",
    previews: Literal["all", "sample", "none"] = "sample",
    drafting: Drafting = RULES,
    strategy: Literal["batched", "hybrid", "fd", "ad", "none"] = "batched",
    engine: Literal["physx", "rapier", "newton"] = "physx",
    device: str = "cpu",
    strict: Annotated[bool, Parameter(negative="")] = False,
    truth: Annotated[TruthOptions, Parameter(name="*")] = TEXTS,
    rendering: RenderOptions | None = None,
    layouts: LayoutOptions | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Make a dataset of proven scenes: Parquet tables, splits, a dataset card.

    Give --prompts or --sample. --resume goes on with an unfinished dataset: finished scenes are
    kept. A failing scene never stops the others; failures.jsonl says why, and the exit code is 3.

    Args:
        out: Folder of the dataset, or a URL such as s3://bucket/name.
        prompts: A prompt a line (.txt), JSON Lines (prompt, seed, family, expect) or a suite.
        sample: Number of scenes drawn from the scene grammar.
        shard: i/n makes the i-th of n parts; whoever finishes last puts the dataset together.
        resume: Go on with the dataset in --out.
        seed: Of every random choice.
        draw: What is drawn and kept.
        runner: Where batches run: worker processes, a Dask or a Ray cluster.
        workers: Batches at once; default one a core.
        batch: Scenes a batch; default by the dataset's size, more on a GPU.
        mcap: Which scenes get an MCAP recording; sample means every 50th.
        previews: Which scenes get a picture.
        strategy: How the physics is searched; none keeps the first guess.
        engine: Engine of the replay: physx runs the emitted class.
        device: cpu or cuda:N.
        strict: Count scenes as failed that are partial (not all is shown) or not plausible.
        truth: Captions, questions, other engines and what-ifs.
        rendering: What cameras see of every scene.
        layouts: How the dataset is laid out.
        json: Print one JSON document with counts and paths.
    """
    from esg.api.inputs import check_device, checked
    from esg.commands.datasets.clips import check_same, render_spec
    from esg.commands.datasets.layouts import check_layouts
    from esg.dataset.plan import DatasetSpec, Shard

    going_on = resume and prompts is None and sample is None
    part, device, render, names, planned, out, beside, _ = checked(
        lambda: Shard.parse(shard),
        lambda: check_device(device),
        lambda: render_spec(rendering, device),
        lambda: check_layouts(layouts),
        lambda: None if going_on else _source(prompts, sample, draw),
        lambda: _place(out),
        lambda: _beside(truth, layouts),
        lambda: _check_numbers(seed, workers, batch, draw.counterfactual),
    )
    folder, remote = opened(out)
    if going_on and (found := folder.spec()) is not None:
        spec, texts = found, folder.prompts()
        check_same(render, spec.render, folder.label)
    else:
        texts, source = planned or _source(prompts, sample, draw)
        spec = DatasetSpec(
            **source, seed=seed, counterfactual=draw.counterfactual, drafter=drafting.drafter,
            strategy=strategy, engine=engine, mcap=mcap, previews=previews, device=device,
            batch=batch or 0, strict=strict, render=render, thin=draw.thin, **beside,
        )  # fmt: skip
    work = _Work(part, names, resume, runner, workers, drafting)
    return _told(*_made(folder, remote, spec, texts, work), as_json=json)


def _beside(truth: TruthOptions, layouts: LayoutOptions | None) -> dict[str, Any]:
    """What the specification says of texts, other engines, what-ifs and meshes."""
    from esg.dataset.whatifs.options import spec_fields

    return {**spec_fields(truth), "meshes": layouts is None or layouts.meshes}


@dataclass(frozen=True)
class _Work:
    """How a dataset is worked through: which part, what beside it, where, and who drafts."""

    part: Shard
    layouts: tuple[str, ...]
    resume: bool
    runner: str
    workers: int | None
    drafting: Drafting


def _made(
    folder: DatasetFolder,
    remote: Remote | None,
    spec: DatasetSpec,
    texts: Sequence[Prompt],
    work: _Work,
) -> tuple[dict[str, Any], Gathered | None]:
    """Makes a dataset, or goes on with it: what became of it, and of the drafts it waits for."""
    from esg.commands.console import progress
    from esg.commands.datasets.layouts import check_rendered
    from esg.dataset.layouts.building import want_layouts

    check_rendered(folder, spec, work.layouts)
    with (
        folder.locked(work.part),
        progress(spec.n, "starting") as bar,
        _answered(spec, texts, work.part.batches(spec), work.drafting) as (asked, numbers),
    ):
        run = folder.begin(spec, texts, resume=work.resume)
        want_layouts(folder.path, work.layouts)
        made = _build(folder, spec, texts, run, numbers, work.runner, work.workers, bar, remote)
    return made, asked


@contextmanager
def _answered(
    spec: DatasetSpec, texts: Sequence[Prompt], numbers: list[int], drafting: Drafting
) -> Generator[tuple[Gathered | None, list[int]]]:
    """The drafts of a shard's scenes from request files, and the batches of which none waits."""
    if drafting.llm_batch is None:
        yield None, numbers
        return
    from esg.commands.drafting import from_answers
    from esg.dataset.plan import plan_batch

    Drafting(spec.drafter, drafting.llm_batch).check()  # type: ignore[arg-type]  # cyclopts checked
    mine = [(n, s.request) for n in numbers for s in plan_batch(spec, n, texts)]
    found = drafting.gathered([r.prompt for _, r in mine], [r.seed for _, r in mine])
    assert found is not None
    held = {n for (n, _), made in zip(mine, found.drafts, strict=True) if made.waiting}
    with from_answers(found):
        yield found, [n for n in numbers if n not in held]


def _told(summary: dict[str, Any], asked: Gathered | None = None, *, as_json: bool) -> int:
    """Prints what was made; returns the exit code."""
    from esg.commands.console import emit

    waiting = asked.waiting if asked is not None else 0
    if asked is not None:
        summary = {**summary, "waiting": waiting, "waiting_for": asked.data()}
    if as_json:
        emit(summary)
    else:
        print(describe(summary))
        if asked is not None and waiting:
            print(asked.text())
    return 3 if summary["failed"] or waiting else 0


def opened(out: str) -> tuple[DatasetFolder, Remote | None]:
    """The local folder of a dataset, and the place it goes to if that is a URL."""
    from esg.dataset.folder import DatasetFolder
    from esg.dataset.remote import Remote, is_url, staging_folder

    if not is_url(out):
        return DatasetFolder(Path(out), out), None
    remote, folder = Remote(out), DatasetFolder(staging_folder(out), out)
    remote.pull_beginning(folder.path)
    return folder, remote


def _place(out: str) -> str:
    """An --out that can be written, as a path or a URL."""
    from esg.dataset.remote import checked_place, is_url, staging_folder
    from esg.scenefolder import check_writable

    place = checked_place(out)
    check_writable(staging_folder(place) if is_url(place) else Path(place))
    return place


def _source(
    prompts: Path | None, sample: int | None, draw: DrawOptions
) -> tuple[list[Prompt], dict[str, Any]]:
    """The prompts of a file, and what the specification says about the source."""
    import hashlib

    from esg.api.inputs import existing_file
    from esg.dataset.distribution import Distribution, load_distribution
    from esg.dataset.plan import MAX_SCENES, prompts_text, read_prompts
    from esg.files import read_limited
    from esg.outcomes import UserError
    from esg.strangers.yamlfile import MAX_CHARACTERS

    if (prompts is None) == (sample is None):
        raise UserError("give either --prompts FILE or --sample N")
    if prompts is not None:
        given = {"--counterfactual": draw.counterfactual, "--distribution": draw.distribution}
        for name, value in given.items():
            if value:
                raise UserError(f"{name} belongs to --sample; a prompts file says it all itself")
        texts = read_prompts(prompts)
        digest = hashlib.sha256(prompts_text(texts).encode()).hexdigest()
        return texts, {"source": "prompts", "n": len(texts), "prompts_sha256": digest}
    assert sample is not None
    if not 1 <= sample <= MAX_SCENES:
        raise UserError(f"--sample {sample}: choose 1 to {MAX_SCENES}")
    mix = Distribution()
    if draw.distribution is not None:
        path = existing_file(draw.distribution, "--distribution")
        try:
            mix = load_distribution(read_limited(path, MAX_CHARACTERS).decode(), str(path))
        except UnicodeDecodeError:
            raise UserError(f"--distribution {path} is not UTF-8 text; save it as UTF-8") from None
    return [], {"source": "sample", "n": sample, "distribution": mix}


def _check_numbers(seed: int, workers: int | None, batch: int | None, counterfactual: bool) -> None:
    """Checks numbers as typed, and that the cache can be written."""
    from esg.api.inputs import check_cache, check_workers, checked, in_range

    checked(
        lambda: in_range("--seed", seed, 0, 2**31 - 1),
        lambda: check_workers(workers, 1),
        lambda: None if batch is None else in_range("--batch", batch, 1, 4096),
        lambda: _check_pairs(batch, counterfactual),
        check_cache,
    )


def _check_pairs(batch: int | None, counterfactual: bool) -> None:
    from esg.outcomes import UserError

    if batch is not None and counterfactual and batch % 2:
        raise UserError(f"--batch {batch}: choose an even number, so that no pair is parted")


def _build(
    folder: DatasetFolder,
    spec: DatasetSpec,
    texts: Sequence[Prompt],
    run: Any,
    numbers: list[int],
    runner: str,
    workers: int | None,
    bar: Any,
    remote: Remote | None,
) -> dict[str, Any]:
    from esg.commands.datasets.layouts import lay_out, push_layouts
    from esg.dataset.finish import clean, describe_again, finish
    from esg.dataset.folder import finish_lock
    from esg.dataset.remote import is_media

    if folder.finished():
        clean(folder.path)
        summary = _summary(folder, spec, {}, remote)
        if lay_out(folder, remote, bar.show):
            describe_again(folder.path, spec)
            if remote is not None:
                push_layouts(folder, remote)
                shutil.rmtree(folder.path, ignore_errors=True)
        return summary
    if remote is not None:
        remote.push_beginning(folder.path)
    done = folder.done(numbers, remote)
    bar.step(f"{sum(r.scenes for r in done.values())} made before", _scenes(done.values()))
    left = [n for n in numbers if n not in done]
    if left:
        for job in _jobs(folder, spec, texts, run, left[:1], remote):
            _load_ahead(job, runner, workers)
        jobs = _jobs(folder, spec, texts, run, left, remote)
        for result in make_batches(jobs, runner, workers, bar):
            done[result.number] = result
    everything = folder.done(range(spec.n_batches), remote)
    if len(everything) < spec.n_batches:
        return _summary(folder, spec, done, remote)
    bar.show("putting together")
    with finish_lock(folder.path):
        if remote is not None:
            parts = [f for r in everything.values() for f in r.files if not is_media(f)]
            remote.pull(folder.path, parts)
        if not folder.finished():
            finish(folder, spec, everything)
        summary = _summary(folder, spec, {}, remote)
        lay_out(folder, remote, bar.show)
        if remote is not None:
            remote.push_dataset(folder.path)
            shutil.rmtree(folder.path, ignore_errors=True)
    return summary


def _scenes(results: Any) -> int:
    return sum(r.scenes for r in results)


def _jobs(
    folder: DatasetFolder,
    spec: DatasetSpec,
    texts: Sequence[Prompt],
    run: Any,
    left: list[int],
    remote: Remote | None,
) -> list[BatchJob]:
    from esg.dataset.job import BatchJob, batch_name
    from esg.dataset.plan import plan_batch
    from esg.settings import STAGE_S

    out = folder.path.resolve()
    return [
        BatchJob(
            number=n,
            spec=spec,
            run=run,
            scenes=plan_batch(spec, n, texts),
            out=out,
            work=out / "work" / batch_name(n),
            stage_limit_s=STAGE_S.value,
            url=remote.url if remote else "",
        )
        for n in left
    ]


def make_batches(
    jobs: list[BatchJob], runner: str, workers: int | None, bar: Any
) -> list[BatchResult]:
    """Makes batches in the processes of a runner.

    Args:
        jobs: At least one.
        runner: process, dask or ray.
        workers: Batches at once; default one a core.
        bar: Shows how far it is.

    Raises:
        UserError: If a disk does not take them; finished batches are kept.
    """
    from dataclasses import replace

    from esg.commands.console import note_first_use
    from esg.outcomes import UserError
    from esg.progress import StageEvent, listening
    from esg.workers import default_processes, usable_cores
    from flows.session import session

    scenes = sum(len(j.scenes) for j in jobs)
    count = default_processes(scenes) if workers is None else workers
    searchers = _searchers(jobs[0]) if runner == "process" else 0
    if searchers:
        count = usable_cores() if workers is None else workers
        count = max(1, min(count, sum(len(j.shares()) for j in jobs)))
    else:
        count = max(1, min(count, len(jobs)))
        # Workers that have no batch left take shares of the last ones.
        last = len(jobs) - (count if count > 1 and runner == "process" else 0)
        jobs = [replace(job, parted=k >= last) for k, job in enumerate(jobs)]
    jobs = [_sharing_cores(job, searchers or count) for job in jobs]

    def show(event: StageEvent) -> None:
        if event.status == "finished":
            bar.show(f"{event.scene} {event.stage}")

    def batch_done(result: BatchResult) -> None:
        bar.step(f"batch {result.number}", result.scenes)

    note_first_use()
    forked = _forked(jobs[0], runner, searchers)
    processes = count if runner == "process" else 0
    with listening(show), session(processes, None, searchers, forked=forked) as call:
        from flows.dataset import begun_ahead, with_runner

        try:
            with begun_ahead(jobs):
                return call(with_runner(runner, count), jobs, batch_done)  # type: ignore[arg-type]  # checked by cyclopts
        except OSError as error:
            raise UserError(
                f"{error.filename or jobs[0].out}: {error.strerror or error}; finished batches are "
                "kept, run the same command with --resume to go on",
                exit_code=1,
            ) from None


def _load_ahead(job: BatchJob, runner: str, workers: int | None) -> None:
    """Lets the process that workers are forked off load while the batches are planned."""
    from esg.machine.forked import begin

    search = _forked(job, runner, _searchers(job) if runner == "process" else 0)
    if search and workers != 1 and job.spec.n_batches > 1:
        begin(search)


def _forked(job: BatchJob, runner: str, searchers: int) -> str:
    """How workers search that are loaded once and forked off; empty if they use a GPU."""
    from esg.machine.forked import DRAFTING

    spec = job.spec
    if runner != "process" or (spec.device != "cpu" and (spec.render or not searchers)):
        return ""
    return DRAFTING if searchers else spec.strategy


def _searchers(job: BatchJob) -> int:
    """Processes that only search; none where every scene is searched by itself, or none is.

    Two share a GPU: while one plans, the other's launches run.
    """
    from esg.limits import stage_limits

    if not _sharing_cores(job, 1).searches_together or job.source is not None:
        return 0
    return stage_limits().get("optimize", 1 if job.spec.device == "cpu" else 2)


def _sharing_cores(job: BatchJob, workers: int) -> BatchJob:
    """A batch whose searches run together has processes beside it: the worker's share of cores.

    `ESG_SEARCH_TOGETHER` asks for it, or for the opposite, whatever the device.
    """
    from dataclasses import replace

    from esg.workers import usable_cores

    asked = os.environ.get("ESG_SEARCH_TOGETHER", "")
    job = replace(job, together=asked != "0" if asked else None)
    if not job.searches_together:
        return job
    return replace(job, processes=max(1, usable_cores() // workers))


def _summary(
    folder: DatasetFolder,
    spec: DatasetSpec,
    done: dict[int, BatchResult],
    remote: Remote | None,
) -> dict[str, Any]:
    """What `--json` prints: of the whole dataset, or of this shard while others are missing."""
    import json

    from esg.dataset.folder import INFO
    from esg.dataset.layouts.building import wanted_layouts
    from esg.dataset.layouts.registry import CANONICAL

    place = remote.url if remote else str(folder.path)
    base = {
        "dataset": spec.name(),
        "folder": place,
        "planned": spec.n,
        "complete": folder.finished(),
    }
    if folder.finished():
        info = json.loads((folder.path / INFO).read_bytes())
        facts = info["statistics"]
        failed = sum(row["scenes"] for row in facts["failures"])
        return {
            **base,
            "scenes": facts["scenes"],
            "verified": facts["verified"],
            "partial": facts.get("partial", 0),
            "failed": failed,
            "outcomes": facts["outcomes"],
            "not_represented": facts.get("not_represented"),
            "splits": info["scenes_per_split"],
            "layouts": [CANONICAL, *wanted_layouts(folder.path)],
            "failures": f"{place}/failures.jsonl" if failed else None,
            "cost": _cost(folder.path),
        }
    outcomes: dict[str, int] = {}
    for result in done.values():
        for name, n in result.outcomes.items():
            outcomes[name] = outcomes.get(name, 0) + n
    return {
        **base,
        "scenes": _scenes(done.values()),
        "verified": sum(r.verified for r in done.values()),
        "partial": outcomes.get("partial", 0),
        "failed": sum(len(r.failures) for r in done.values()),
        "outcomes": dict(sorted(outcomes.items())),
        "not_represented": None,
        "splits": None,
        "failures": None,
        "cost": None,
    }


def _cost(folder: Path) -> dict[str, Any] | None:
    """What the scenes of a finished dataset took; None where nobody wrote it down."""
    import json

    path = folder / "meta" / "timings.json"
    return json.loads(path.read_bytes()).get("cost") if path.is_file() else None


def describe(summary: dict[str, Any]) -> str:
    """The same for people."""
    from esg.costs.spent import line
    from esg.fidelity import counted

    state = "complete" if summary["complete"] else "other shards are missing"
    if summary.get("waiting"):
        state = f"{summary['waiting']} wait for answers, with the other scenes of their batches"
    lines = [
        f"{summary['scenes']} of {summary['planned']} scenes in {summary['folder']} ({state})",
        f"  {summary['verified']} verified, {summary['partial']} partial, "
        f"{summary['failed']} failed",
        "  " + ", ".join(f"{k} {v}" for k, v in summary["outcomes"].items()),
    ]
    if summary["splits"]:
        lines.append("  " + ", ".join(f"{k} {v}" for k, v in summary["splits"].items()))
    if summary["not_represented"]:
        lines.append(f"  most often not shown: {counted(summary['not_represented'])}")
    if summary["failures"]:
        lines.append(f"  why: {summary['failures']}")
    if summary.get("cost"):
        lines.append(f"  {line(summary['cost'])}")
    return "\n".join(lines)
