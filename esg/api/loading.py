"""The process that workers are forked off (esg.machine.forked) imports this module and so loads."""

from __future__ import annotations

from collections.abc import Generator
import contextlib
from functools import partial
import gc
import importlib
import os
from pathlib import Path
import tempfile

from esg.machine.forked import ASKED, DRAFTING

ROOMS = (
    "esg.dataset.shares",
    "esg.dataset.writing",
    "esg.dataset.annotations.rows",
    "esg.store.records",
    "esg.store.tables",
)
"""What workers of datasets use beside the stages."""


def load(search: str) -> None:
    """Imports what scenes need and takes sample scenes through the stages, for nothing else.

    Args:
        search: How workers search; `DRAFTING`: what comes after drafts is left to each.
    """
    from esg.api.warming import SAMPLES, load_usd, warm_up
    from esg.dataset.running import SCENE_STAGES
    from esg.dataset.shares import DRAFT
    from esg.pipeline import SceneRequest, SceneState, run_stage, scratch_store

    if search == DRAFTING:
        load_usd()
        request, stages, samples = SceneRequest, DRAFT, SAMPLES[:1]
    else:
        warm_up()
        request, stages, samples = partial(SceneRequest, strategy=search), SCENE_STAGES, SAMPLES
    for room in ROOMS:
        importlib.import_module(room)
    with tempfile.TemporaryDirectory(prefix="esg-load-") as folder:
        for prompt in samples:
            with scratch_store(Path(folder), durable=False):
                state = SceneState(request(prompt))
                for stage in stages:
                    state = run_stage(stage, state)


@contextlib.contextmanager
def _silent() -> Generator[None]:
    """Sends what libraries say while they load nowhere."""
    kept = [os.dup(1), os.dup(2)]
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        for number in (1, 2):
            os.dup2(nowhere, number)
        yield
    finally:
        for number, old in zip((1, 2), kept, strict=True):
            os.dup2(old, number)
            os.close(old)
        os.close(nowhere)


if (asked := os.environ.get(ASKED)) is not None:
    gc.disable()
    # A worker loads by itself whatever could not be loaded here, and says what is missing.
    with _silent(), contextlib.suppress(Exception):
        load(asked)
    gc.freeze()  # no search for garbage in a fork need touch, and copy, what stays
    gc.enable()
