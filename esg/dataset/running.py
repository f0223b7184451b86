"""All stages of a batch's scenes: stage by stage, so that what can be done together is.

Classes compile together, and on a GPU searches run together. A stage that hangs ends its worker; a
scene that ends its worker is found by running the batch's scenes one by one, and left out.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
import contextlib
from dataclasses import dataclass, replace
from functools import partial
import json
import os
import threading
import time
from typing import TYPE_CHECKING

from esg.costs.spent import Meter, core_time
from esg.dataset.job import RENDER
from esg.dataset.whatifs.amounts import ENGINES
from esg.files import unwritable
from esg.limits import place_in
from esg.pipeline import (
    STAGES,
    SceneState,
    artifact_store,
    crashed,
    retried,
    run_stage,
    scratch_store,
    stage_key,
)
from esg.workers import OUT_OF_TIME

if TYPE_CHECKING:
    from esg.dataset.clips.batch import Rendered
    from esg.dataset.job import BatchJob
    from esg.dataset.whatifs.outcomes import Alternatives
    from esg.graph.models import EsgDocument

SCENE_STAGES = STAGES[: STAGES.index("dress")]
"""Datasets keep trajectories, not scene folders: what only pictures need is left out, and done as
part of rendering by datasets that are rendered (esg.dataset.clips)."""

PAUSES_S = (0.5, 1.0)
"""What met an error that may pass is tried again after each of these [s]."""
ALTERNATIVES = "alternatives"
"""Replays in other engines and with other values."""
AFTER = (ALTERNATIVES, RENDER)
"""What comes after the stages: a scene that ends its worker there is lost for that alone."""
_DEAD = "dead.json"
_REACHED = "reached"
"""Names the stage that a scene alone has come to: whoever finds its worker dead reads it."""


@dataclass(frozen=True)
class Made:
    """What became of a batch's scenes.

    Args:
        states: In the end, of every scene.
        others: Their replays in other engines and with other values.
    """

    states: list[SceneState]
    others: list[Alternatives]


def run_scenes(job: BatchJob, spent: Meter) -> Made:
    """All stages of all scenes; stage by stage, so that classes compile together.

    Args:
        job: The batch.
        spent: What it takes to compile the classes, which no scene's log says, is added.
    """
    states = [SceneState(s.request) for s in job.scenes]
    return with_alternatives(job, run_stages(job, states, SCENE_STAGES, spent))


def run_stages(
    job: BatchJob, states: Sequence[SceneState], stages: Sequence[str], spent: Meter
) -> list[SceneState]:
    """Some stages of all scenes, one stage after the other.

    Args:
        job: The batch.
        states: Of its scenes, which have come to the first of these stages.
        stages: Of `SCENE_STAGES`, in order.
        spent: As of `run_scenes`.
    """
    states = _without_dead(job, states)
    for stage in stages:
        if len(job.scenes) == 1:
            job.work.mkdir(parents=True, exist_ok=True)
            (job.work / _REACHED).write_text(stage)
        shares: dict[int, tuple[float, float]] = {}
        if stage == "optimize" and job.searches_together:
            shares = _search_together(job, states)
        if stage == "replay":
            with spent.on(stage):
                _compile_together(states)
        for i, scene in enumerate(job.scenes):
            states[i] = _stage(job, stage, states[i], scene.index)
            if i in shares:
                states[i] = _computed(states[i], *shares[i])
    return states


def _without_dead(job: BatchJob, states: Sequence[SceneState]) -> list[SceneState]:
    """The states, those ended of scenes that end their worker, as if they had not begun."""
    dead, out = dead_scenes(job), list(states)
    for i, scene in enumerate(job.scenes):
        stage, reason = dead.get(scene.index, (RENDER, ""))
        if stage not in AFTER:
            out[i] = crashed(SceneState(scene.request), RuntimeError(reason), stage)
    return out


def with_alternatives(job: BatchJob, states: Sequence[SceneState]) -> Made:
    """Scenes that have come through all stages, with the replays that the dataset asks for."""
    others = _replay_alternatives(job, states)
    return Made([_timed(s, o.seconds) for s, o in zip(states, others, strict=True)], others)


def _timed(state: SceneState, seconds: Mapping[str, float]) -> SceneState:
    """The state with a log that says what came after its stages."""
    more = ({"stage": k, "cached": False, "seconds": round(v, 4)} for k, v in seconds.items() if v)
    return replace(state, log=(*state.log, *more))


def _replay_alternatives(job: BatchJob, states: Sequence[SceneState]) -> list[Alternatives]:
    """The replays of all scenes that the dataset asks for, those made before found again.

    One that ends its worker, or runs longer than a stage may, costs its own rows and no scene.
    """
    from esg.dataset.whatifs import stage
    from esg.dataset.whatifs.outcomes import Alternatives, Asked, failed_rows

    asked = Asked(job.spec.what_if, job.spec.engines)
    if not asked:
        return [Alternatives() for _ in states]
    dead = dead_scenes(job)
    out: list[Alternatives] = []
    for scene, state in zip(job.scenes, states, strict=True):
        if not stage.replayable(state):
            out.append(Alternatives())
        elif dead.get(scene.index, ("", ""))[0] == ALTERNATIVES:
            out.append(failed_rows(asked, dead[scene.index][1]))
        else:
            if len(job.scenes) == 1:
                (job.work / _REACHED).write_text(ALTERNATIVES)
            with _limited(job, ALTERNATIVES, scene.index, len(ENGINES)):
                out.append(stage.replay_alternatives(state, asked, scene.scene_id))
    return out


def _stage(job: BatchJob, stage: str, state: SceneState, index: int) -> SceneState:
    if state.ended:
        return state

    def once() -> SceneState:
        with place_in(stage), _limited(job, stage, index):
            return run_stage(stage, state)

    try:
        return retried(once, PAUSES_S)
    except OSError as error:
        if unwritable(error):
            raise  # the batch is made again once there is room
        return crashed(state, error, stage)


def _search_together(job: BatchJob, states: Sequence[SceneState]) -> dict[int, tuple[float, float]]:
    """Searches all scenes of the batch in shared launches; their stages then find the results.

    All scenes or none: what a launch finds may depend, in the last digits, on who shares it, and a
    batch that was interrupted must go on as an uninterrupted one. A scene whose search fails is
    left to its own stage, which says why.

    Returns:
        Seconds and processor seconds of every scene that was searched, by position: its share of
        the launches.
    """
    from esg.dynamics.fleet import STRATEGIES
    from esg.stages import load_doc, write_doc

    if job.spec.strategy not in STRATEGIES:
        return {}
    docs: dict[int, EsgDocument] = {}
    keys: dict[int, str] = {}
    for i, state in enumerate(states):
        if not state.ended and "layout" in state.artifacts:
            doc = load_doc(state, "layout")
            if doc.timeline_system is not None:
                docs[i], keys[i] = doc, stage_key("optimize", state)
    store = artifact_store()
    if all(store.find(key) is not None for key in keys.values()):
        return {}
    start, core_start = time.perf_counter(), core_time()
    with place_in("optimize"), _limited(job, "optimize", None, len(docs)):
        found = _search_many(job, list(docs.values()), [states[i].request.seed for i in docs])
    seconds, core_seconds = time.perf_counter() - start, core_time() - core_start
    done = {i: doc for i, doc in zip(docs, found, strict=True) if doc is not None}
    for i, doc in done.items():
        store.create(keys[i], partial(write_doc, doc))
    return dict.fromkeys(done, (seconds / len(docs), core_seconds / len(docs)))


def _search_many(
    job: BatchJob, docs: Sequence[EsgDocument], seeds: Sequence[int]
) -> list[EsgDocument | None]:
    """`optimize_many`; what fails together (a broken scene, full memory) is tried in halves."""
    from esg.dynamics.fleet import optimize_many
    from esg.engines.newton import quiet_warp

    quiet_warp()
    try:
        return list(
            optimize_many(
                docs,
                seeds,
                device=job.spec.device,
                strategy=job.spec.strategy,
                processes=job.processes,
            )
        )
    except Exception:
        if len(docs) == 1:
            return [None]
        half = len(docs) // 2
        return [
            *_search_many(job, docs[:half], seeds[:half]),
            *_search_many(job, docs[half:], seeds[half:]),
        ]


def _computed(state: SceneState, seconds: float, core_seconds: float) -> SceneState:
    """The state with a log that says that its last stage was computed, and how long it took."""
    told = {"seconds": round(seconds, 4), "core_seconds": round(core_seconds, 4)}
    entry = {**state.log[-1], "cached": False, **told}
    return replace(state, log=(*state.log[:-1], entry))


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


def batch_store(job: BatchJob) -> contextlib.AbstractContextManager[None]:
    """Where the stages of a batch, and of all its shares, keep their results."""
    return scratch_store(job.work / "artifacts", durable=False)


# Scenes that end their worker: found one by one, remembered, left out.


def try_scene(job: BatchJob, position: int) -> None:
    """Runs one scene of a batch alone; if it ends the process, it is the one (`mark_dead`)."""
    (job.work / _REACHED).unlink(missing_ok=True)
    alone = replace(job, scenes=(job.scenes[position],))
    with batch_store(job):
        states = [] if job.source else run_scenes(alone, Meter()).states
        rendered_scenes(alone, states, Meter())


def rendered_scenes(job: BatchJob, states: Sequence[SceneState], spent: Meter) -> Rendered:
    """The pictures of a batch's scenes, if it is to have any.

    Args:
        job: The batch.
        states: Of its scenes; none where a finished dataset holds them.
        spent: What it takes is added.

    Raises:
        OSError: If they cannot be written; finished scenes are kept.
    """
    from esg.dataset.clips.batch import Rendered, render_batch
    from esg.dataset.clips.subjects import made_subjects, told_subjects

    if job.spec.render is None:
        return Rendered()
    if len(job.scenes) == 1:
        job.work.mkdir(parents=True, exist_ok=True)
        (job.work / _REACHED).write_text(RENDER)
    dead = {k: reason for k, (stage, reason) in dead_scenes(job).items() if stage == RENDER}
    subjects = told_subjects(job) if job.source else made_subjects(job, states)
    with spent.on(RENDER):
        return render_batch(job, job.spec.render, subjects, dead)


def mark_dead(job: BatchJob, index: int, reason: str) -> None:
    """Remembers a scene that ends its worker; the batch will count it as crashed."""
    dead = dead_scenes(job)
    stage, known = dead.get(index, ("", ""))
    dead[index] = (stage or _reached(job), known or reason)
    _write_dead(job, dead)


def forget_dead(job: BatchJob) -> None:
    """Forgets the scenes that were marked: what ended their workers was none of them."""
    (job.work / _DEAD).unlink(missing_ok=True)


def _reached(job: BatchJob) -> str:
    """The stage in which the scene that was tried last ended its worker."""
    with contextlib.suppress(OSError, ValueError):
        stage = (job.work / _REACHED).read_text("utf-8")
        if stage in (*SCENE_STAGES, *AFTER):
            return stage
    return SCENE_STAGES[0]


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
def _limited(job: BatchJob, stage: str, index: int | None, scenes: int = 1) -> Generator[None]:
    """Ends this process if a stage runs too long: native code cannot be interrupted otherwise.

    Args:
        job: The batch.
        stage: What runs.
        index: The scene it runs for; None for several, of which none can be blamed.
        scenes: How many share the time.
    """
    if job.stage_limit_s <= 0:
        yield
        return

    def end() -> None:
        reason = f"{stage} ran longer than its limit of {job.stage_limit_s:g} s"
        if index is not None:
            with contextlib.suppress(OSError):
                _write_dead(job, {**dead_scenes(job), index: (stage, reason)})
        os._exit(OUT_OF_TIME)

    timer = threading.Timer(job.stage_limit_s * scenes, end)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
