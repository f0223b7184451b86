"""Making one batch of scenes: all stages, then its Parquet parts, recordings and mark.

A batch is the unit of work, of resuming and of scheduling. It works in a folder of its own, where
finished stages are kept until the batch is done: a batch that was killed goes on where it stopped.
Its mark is written last; a batch with a mark is never made again.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Generator, Mapping, Sequence
import contextlib
from dataclasses import dataclass, field, replace
import json
import os
from pathlib import Path
import shutil
import threading
import time
from typing import TYPE_CHECKING, Any

from esg.dataset.plan import SAMPLE_EVERY, DatasetSpec, PlannedScene
from esg.pipeline import STAGES, SceneState, crashed, failures, may_pass, run_stage, scratch_store

if TYPE_CHECKING:
    from esg.store.records import RunInfo

SCENE_STAGES = STAGES[: STAGES.index("record")]
"""Datasets keep trajectories, not scene folders: the record stage with its exports is left out."""

RETRIES = 2
_BACKOFF_S = 0.5
_DEAD = "dead.json"


@dataclass(frozen=True)
class BatchJob:
    """One batch; small, so that it can travel to any machine.

    Args:
        number: Of the batch in the dataset.
        spec: Of the dataset.
        run: Of the dataset.
        scenes: Of the batch.
        out: Local folder of the dataset (parts, recordings, marks).
        work: Local folder for the stages of this batch; deleted when it is done.
        stage_limit_s: A stage that runs longer ends the worker; 0: no limit.
        keep_work: Whether to leave the stages' results in `work`.
        url: Where finished batches go (esg.dataset.remote); empty: they stay in `out`.
    """

    number: int
    spec: DatasetSpec
    run: RunInfo
    scenes: tuple[PlannedScene, ...]
    out: Path
    work: Path
    stage_limit_s: float = 0.0
    keep_work: bool = False
    url: str = ""

    @property
    def name(self) -> str:
        """File name of its parts and its mark."""
        return batch_name(self.number)


@dataclass(frozen=True)
class BatchResult:
    """What came of a batch; the content of its mark.

    Args:
        number: Of the batch.
        scenes: Number of scenes.
        verified: Number of verified scenes.
        outcomes: Number of scenes by outcome.
        failures: Rows of `failures.jsonl`.
        crashes: Traceback by scene id.
        seconds: Time spent [s], by stage, for `recordings` and for the `batch` in all; no part of
            the dataset.
        files: Size in bytes of every file written, by path below the dataset's folder.
    """

    number: int
    scenes: int
    verified: int
    outcomes: Mapping[str, int]
    failures: Sequence[Mapping[str, Any]] = ()
    crashes: Mapping[str, str] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)
    files: Mapping[str, int] = field(default_factory=dict)

    def to_json(self) -> str:
        """Text of the mark."""
        return json.dumps(vars(self), indent=1, sort_keys=True, ensure_ascii=False) + "\n"

    @staticmethod
    def from_json(text: str) -> BatchResult:
        """The inverse of `to_json`.

        Raises:
            ValueError, TypeError: If the text is no mark.
        """
        return BatchResult(**json.loads(text))


def batch_name(number: int) -> str:
    """File name of a batch's parts and mark."""
    return f"batch-{number:06d}"


def make_batch(job: BatchJob) -> BatchResult:
    """Makes all scenes of a batch and writes what they leave, or finds that it is done.

    A scene that fails leaves its reason and the others go on. Errors that may pass are retried;
    those that do not pass end the scene as crashed.

    Returns:
        What came of it.

    Raises:
        OSError: If the batch cannot be written; finished stages are kept.
    """
    from esg.dataset.folder import batch_lock, read_mark

    with batch_lock(job.out, job.number):
        done = read_mark(job.out, job.number)
        result = _make(job) if done is None else done
        if job.url:
            _deliver(job, result)
        return result


def _deliver(job: BatchJob, result: BatchResult) -> None:
    """Brings a batch to where the dataset is, its mark last."""
    from esg.dataset.folder import mark_name
    from esg.dataset.remote import Remote

    remote, mark = Remote(job.url), mark_name(job.number)
    if not remote.has(mark):
        remote.push(job.out, [*result.files, mark])


def _make(job: BatchJob) -> BatchResult:
    from esg.dataset.folder import write_mark

    start = time.perf_counter()
    with scratch_store(job.work / "artifacts", durable=False):
        states, together_s = run_scenes(job)
        result, recordings_s = _write(job, states)
    spent = {s: 0.0 for s in SCENE_STAGES}
    for state in states:
        for entry in state.log:
            spent[entry["stage"]] += float(entry["seconds"])
    spent["replay"] += together_s
    spent["recordings"] = recordings_s
    spent["batch"] = time.perf_counter() - start
    result = replace(result, seconds={k: round(v, 4) for k, v in spent.items()})
    write_mark(job.out, result)
    if not job.keep_work:
        shutil.rmtree(job.work, ignore_errors=True)
    return result


def run_scenes(job: BatchJob) -> tuple[list[SceneState], float]:
    """All stages of all scenes; stage by stage, so that classes compile together.

    Returns:
        Final states, and the time it took to compile the classes [s].
    """
    together_s = 0.0
    states = [SceneState(s.request) for s in job.scenes]
    dead = dead_scenes(job)
    for i, scene in enumerate(job.scenes):
        if scene.index in dead:
            stage, reason = dead[scene.index]
            states[i] = crashed(states[i], RuntimeError(reason), stage)
    for stage in SCENE_STAGES:
        if stage == "replay":
            start = time.perf_counter()
            _compile_together(states)
            together_s = time.perf_counter() - start
        for i, scene in enumerate(job.scenes):
            states[i] = _stage(job, stage, states[i], scene.index)
    return states, together_s


def _stage(job: BatchJob, stage: str, state: SceneState, index: int) -> SceneState:
    if state.ended:
        return state
    for attempt in range(RETRIES + 1):
        try:
            with _limited(job, stage, index):
                return run_stage(stage, state)
        except OSError as error:
            if attempt == RETRIES or not may_pass(error):
                return crashed(state, error, stage)
            time.sleep(_BACKOFF_S * 2**attempt)
    raise AssertionError("unreachable")


def _compile_together(states: Sequence[SceneState]) -> None:
    """Compiles the batch's classes, several to a unit; replays then find them.

    Whatever is wrong with a class is reported by its own replay.
    """
    from esg.compile import CompilerMissing, compile_many

    folders = [s.artifact("compile") for s in states if not s.ended and "compile" in s.artifacts]
    physx = any(s.request.engine == "physx" for s in states)
    if folders and physx:
        with contextlib.suppress(CompilerMissing, OSError, RuntimeError):
            compile_many(folders, jobs=1)


# Scenes that end their worker: found one by one, remembered, left out.


def try_scene(job: BatchJob, position: int) -> None:
    """Runs one scene of a batch alone; if it ends the process, it is the one (`mark_dead`)."""
    with scratch_store(job.work / "artifacts", durable=False):
        run_scenes(replace(job, scenes=(job.scenes[position],)))


def mark_dead(job: BatchJob, index: int, reason: str) -> None:
    """Remembers a scene that ends its worker; the batch will count it as crashed."""
    dead = dead_scenes(job)
    stage, known = dead.get(index, ("", ""))
    dead[index] = (stage or "optimize", known or reason)
    _write_dead(job, dead)


def dead_scenes(job: BatchJob) -> dict[int, tuple[str, str]]:
    """Stage and reason of scenes that end their worker, by index."""
    try:
        data = json.loads((job.work / _DEAD).read_bytes())
        return {int(k): (v[0], v[1]) for k, v in data.items()}
    except (OSError, ValueError, TypeError, IndexError):
        return {}


def _write_dead(job: BatchJob, dead: Mapping[int, tuple[str, str]]) -> None:
    job.work.mkdir(parents=True, exist_ok=True)
    partial = job.work / f"{_DEAD}.{os.getpid()}.tmp"
    partial.write_text(json.dumps(dead, sort_keys=True))
    partial.replace(job.work / _DEAD)


@contextlib.contextmanager
def _limited(job: BatchJob, stage: str, index: int) -> Generator[None]:
    """Ends this process if a stage runs too long: native code cannot be interrupted otherwise."""
    if job.stage_limit_s <= 0:
        yield
        return

    def end() -> None:
        reason = f"{stage} ran longer than its limit of {job.stage_limit_s:g} s"
        with contextlib.suppress(OSError):
            _write_dead(job, {**dead_scenes(job), index: (stage, reason)})
        os._exit(70)

    timer = threading.Timer(job.stage_limit_s, end)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


# What a batch leaves.


def _write(job: BatchJob, states: Sequence[SceneState]) -> tuple[BatchResult, float]:
    """Writes all files of a batch; returns its result and the time the recordings took [s]."""
    from esg.store.records import SceneRecord, record_of
    from esg.store.tables import write_tables

    records: list[SceneRecord] = []
    verified: list[bool] = []
    for scene, state in zip(job.scenes, states, strict=True):
        record = record_of(
            state,
            job.run,
            scene_id=scene.scene_id,
            level=scene.level,
            fps=job.spec.fps,
            split=scene.split,
            family=scene.family,
            extra=_columns(scene, state),
        )
        rows = {t: r for t, r in record.rows.items() if t != "runs"}
        # Everything but `timings` is the same whenever and however often a scene is made.
        row = {**rows["scenes"][0], "seconds": None, "cached_stages": None, "artifacts": None}
        verified.append(bool(row["verified"]))
        records.append(SceneRecord({**rows, "scenes": [row]}))
    written = list(write_tables(job.out / "parts", records, name=job.name).values())
    start = time.perf_counter()
    for scene, state, good in zip(job.scenes, states, verified, strict=True):
        written += _recordings(job, scene, state, good)
    recordings_s = time.perf_counter() - start
    result = BatchResult(
        number=job.number,
        scenes=len(states),
        verified=sum(verified),
        outcomes=dict(Counter(s.outcome.value if s.outcome else "unfinished" for s in states)),
        failures=_failures(job, states, verified),
        crashes={
            scene.scene_id: entry["traceback"]
            for scene, state in zip(job.scenes, states, strict=True)
            for entry in state.log
            if "traceback" in entry
        },
        files={p.relative_to(job.out).as_posix(): p.stat().st_size for p in written},
    )
    return result, recordings_s


def _columns(scene: PlannedScene, state: SceneState) -> dict[str, Any]:
    manifest = None
    if "compile" in state.artifacts:
        manifest = (state.artifact("compile") / "manifest.json").read_text("utf-8")
    return {
        "rule": scene.rule or None,
        "pair": scene.pair or None,
        "changed": scene.changed or None,
        "parameters": scene.parameters or None,
        "expectation": scene.request.suite_scene or None,
        "manifest": manifest,
    }


def _failures(
    job: BatchJob, states: Sequence[SceneState], verified: Sequence[bool]
) -> list[dict[str, Any]]:
    """Scenes that are not verified, and why.

    The expectation decides: a scene that replays as its sentence says is no failure, whatever the
    optimizer thought of it; one that ended well but not as its sentence says is.
    """
    told = {row["scene"]: row for row in failures(states)}
    out: list[dict[str, Any]] = []
    for scene, state, good in zip(job.scenes, states, verified, strict=True):
        if good:
            continue
        row = told.get(scene.scene_id)
        if row is None:
            row = {
                "scene": scene.scene_id,
                "prompt": state.request.prompt,
                "seed": state.request.seed,
                "outcome": "not_as_stated",
                "reason": unmet(state),
                "stage": "judge",
            }
        out.append({**row, "index": scene.index, "rule": scene.rule, "level": scene.level})
    return out


def unmet(state: SceneState) -> str:
    """Which expectations a judged scene does not meet."""
    from esg.stages import load_verdict

    verdict = load_verdict(state)
    parts = [f"{e.id} ({e.type}): {e.reason}" for e in verdict.events if not e.completed]
    parts += [f"missing {m}" for m in verdict.layout.missing]
    parts += [
        f"{o.a} and {o.b} overlap by {100 * o.depth_m:.1f} cm" for o in verdict.layout.overlaps
    ]
    return "; ".join(parts) or "the layout is invalid"


def _recordings(
    job: BatchJob, scene: PlannedScene, state: SceneState, verified: bool
) -> list[Path]:
    """MCAP and picture of a scene, if it is one of those that get them."""
    if "judge" not in state.artifacts:
        return []
    sampled = scene.index % SAMPLE_EVERY == 0
    mcap = {"all": True, "failed": not verified, "sample": sampled, "none": False}
    picture = {"all": True, "sample": sampled, "none": False}
    out: list[Path] = []
    if not (mcap[job.spec.mcap] or picture[job.spec.previews]):
        return out
    from esg.engines.rollout_file import load_rollout
    from esg.stages import ROLLOUT, load_doc, load_scene, load_verdict

    doc, verdict = load_doc(state), load_verdict(state)
    physical, program = load_scene(state)
    rollout = load_rollout(state.artifact("replay") / ROLLOUT)
    if mcap[job.spec.mcap]:
        from esg.store.mcap_log import write_mcap

        path = job.out / "mcap" / f"{scene.scene_id}.mcap"
        path.parent.mkdir(parents=True, exist_ok=True)
        write_mcap(path, physical, program, rollout, verdict, doc)
        out.append(path)
    if picture[job.spec.previews]:
        out += _preview(job, scene, state, (physical, rollout, verdict, doc))
    return out


def _preview(
    job: BatchJob, scene: PlannedScene, state: SceneState, parts: tuple[Any, Any, Any, Any]
) -> list[Path]:
    from esg.store.files import atomic_write
    from esg.view.preview import preview

    physical, rollout, verdict, doc = parts
    folder = job.work / "preview"
    folder.mkdir(parents=True, exist_ok=True)
    rate = f"{1 / rollout.dt:.0f} Hz"
    outcome = state.outcome.value if state.outcome else ""
    note = f"{outcome}  |  replayed in {rollout.engine} at {rate}"
    try:
        preview(physical, rollout, verdict, doc, folder, note=note)
        path = job.out / "previews" / f"{scene.scene_id}.png"
        atomic_write(path, lambda target: _copy(folder / "preview.png", target))
        return [path]
    except OSError:
        raise
    except Exception:  # a picture is no reason to fail a scene
        return []


def _copy(source: Path, target: Path) -> None:
    shutil.copyfile(source, target)
