"""Stages as plain functions, with the limits, retries and ends of scenes of any other run.

What a scheduler adds for many scenes, a place to look at the run and lanes of batches, costs a
single one more than its search.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
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
    with place_in(stage), scratch_store(store) if store else contextlib.nullcontext():
        try:
            with limited(stage):
                return run_stage(stage, state)
        except StageTimeout as error:
            return crashed(state, TimeoutError(str(error)), stage)


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
    try:
        return retried(partial(guarded_stage, stage, state), pauses)
    except OSError as error:
        if unwritable(error):
            raise
        return crashed(state, error, stage)
