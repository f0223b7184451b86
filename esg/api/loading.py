"""The process that workers are forked off (esg.machine.forked) imports this module and so loads."""

from __future__ import annotations

from collections.abc import Generator
import contextlib
import gc
import importlib
import os
from pathlib import Path
import tempfile

from esg.machine.forked import ASKED

ROOMS = (
    "esg.dataset.shares",
    "esg.dataset.writing",
    "esg.dataset.annotations.rows",
    "esg.store.records",
    "esg.store.tables",
)
"""What workers of datasets use beside the stages."""


def load(strategy: str) -> None:
    """Imports what scenes need and takes sample scenes through the stages, for nothing else.

    Args:
        strategy: Of the search.
    """
    from esg.api.warming import SAMPLES, warm_up
    from esg.dataset.running import SCENE_STAGES
    from esg.pipeline import SceneRequest, SceneState, run_stage, scratch_store

    warm_up()
    for room in ROOMS:
        importlib.import_module(room)
    with tempfile.TemporaryDirectory(prefix="esg-load-") as folder:
        for prompt in SAMPLES:
            with scratch_store(Path(folder), durable=False):
                state = SceneState(SceneRequest(prompt, strategy=strategy))
                for stage in SCENE_STAGES:
                    state = run_stage(stage, state)
    gc.collect()
    gc.freeze()  # no search for garbage in a fork need touch, and copy, what stays


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
    # A worker loads by itself whatever could not be loaded here, and says what is missing.
    with _silent(), contextlib.suppress(Exception):
        load(asked)
