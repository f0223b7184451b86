"""Stages as plain functions, with the limits, retries and ends of scenes of any other run.

What a scheduler adds for many scenes, a place to look at the run and lanes of batches, costs a
single one more than its search.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
import contextlib
from functools import partial
from pathlib import Path

from esg.alone.ahead import AHEAD, MEANWHILE, cold
from esg.files import unwritable
from esg.limits import StageTimeout, limited, place_in
from esg.machine.beside import forking
from esg.machine.companion import accompanied, companion
from esg.pipeline import (
    STAGES,
    SceneRequest,
    SceneState,
    Unfinished,
    begin_record,
    crashed,
    retried,
    run_stage,
    scratch_store,
)

PAUSES_S = (1.0, 2.0)
"""A stage that met an error that may pass is tried again after each of these [s]."""


def guarded_stage(stage: str, state: SceneState, store: Path | None = None) -> SceneState:
    """One stage of one scene in its place among others (ESG_STAGE_LIMITS) and within its time.

    Args:
        stage: One of `esg.pipeline.STAGES`.
        state: A scene that is ready for it, or has ended.
        store: Artifact store; None is the usual one.

    Raises:
        OSError: As `run_stage`.
    """
    with scratch_store(store) if store else contextlib.nullcontext():
        try:
            with bounded(stage):
                return run_stage(stage, state)
        except StageTimeout as error:
            return crashed(state, TimeoutError(str(error)), stage)


@contextlib.contextmanager
def bounded(stage: str) -> Generator[None]:
    """A place in a stage among other scenes, and its time, for the body.

    Args:
        stage: One of `esg.pipeline.STAGES`.

    Raises:
        StageTimeout: In the body, once it takes too long.
    """
    with place_in(stage), limited(stage):
        yield


def run_guarded(request: SceneRequest, pauses: Sequence[float] = PAUSES_S) -> SceneState:
    """All stages of one scene, in this process; what may pass is tried again.

    Args:
        request: What to make.
        pauses: Before each further try of a stage [s].

    Raises:
        OSError: If the disk cannot be written, which is no fault of the scene.
    """
    state = SceneState(request)
    with alongside(request):
        for stage in STAGES:
            state = _tried(stage, state, pauses)
    return state


def begin_guarded(
    request: SceneRequest,
    later: Callable[[SceneState], bool],
    pauses: Sequence[float] = PAUSES_S,
) -> tuple[SceneState, Unfinished | None]:
    """All stages of one scene but for the pictures of its record, where these may follow.

    Args:
        request: What to make.
        later: Whether they may, asked when all but the record is there.
        pauses: Before each further try of a stage [s].

    Returns:
        The scene, and what is left of its record; None if nothing is.

    Raises:
        OSError: As `run_guarded`.
    """
    state = SceneState(request)
    for stage in STAGES[:-1]:
        state = _tried(stage, state, pauses)
    if not later(state):
        return _tried(STAGES[-1], state, pauses), None
    rests: list[Unfinished] = []

    def begin() -> SceneState:
        try:
            with bounded(STAGES[-1]):
                begun, rest = begin_record(state)
        except StageTimeout as error:
            return crashed(state, TimeoutError(str(error)), STAGES[-1])
        rests.extend([rest] if rest else [])
        return begun

    begun = _ended(STAGES[-1], state, begin, pauses)
    return begun, rests[0] if rests else None


@contextlib.contextmanager
def alongside(request: SceneRequest) -> Generator[None]:
    """Allows the body, which makes a scene, a second process, and starts one that loads ahead.

    To be called by a command whose other threads only wait, as soon as it knows what to make.

    Args:
        request: What the body makes.
    """
    searches = request.device == "cpu" and request.strategy != "none"
    with contextlib.ExitStack() as held:
        held.enter_context(forking())
        if searches and cold() and not accompanied():
            held.enter_context(companion(AHEAD, MEANWHILE))
        yield


def _tried(stage: str, state: SceneState, pauses: Sequence[float]) -> SceneState:
    return _ended(stage, state, partial(guarded_stage, stage, state), pauses)


def _ended(
    stage: str, state: SceneState, run: Callable[[], SceneState], pauses: Sequence[float]
) -> SceneState:
    """What running a stage gives, or the scene as one that crashed there."""
    try:
        return retried(run, pauses)
    except OSError as error:
        if unwritable(error):
            raise
        return crashed(state, error, stage)
