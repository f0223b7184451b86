"""Answering first: which scenes may get their pictures after the answer, and how they get them."""

from __future__ import annotations

import contextlib
from pathlib import Path

from esg.alone.guarded import bounded
from esg.files import explained
from esg.limits import StageTimeout, taken
from esg.machine.answering import can_go_on
from esg.pipeline import STAGES, SceneState, Unfinished
from esg.scenefolder import Owed, complete, folder_name
from esg.scenefolder.unfinished import give_up, settled
from esg.strangers.scrubbing import scrub_all
from esg.workers import usable_cores

PLACE = "finishing"


def may_follow(state: SceneState, out: Path, held: contextlib.ExitStack) -> bool:
    """Whether the pictures of a scene may be drawn after the command has answered.

    Not where nobody could draw them, nor where as many scenes as there are cores are being
    finished: a command after the other would leave more behind than the machine can do. Nor where
    they were begun and never finished: what went wrong there is then told by the answer.

    Args:
        state: A scene whose record comes next.
        out: Folder that receives its folder.
        held: Keeps the place among those that are being finished.
    """
    if state.ended or not can_go_on() or settled(out / folder_name(state)):
        return False
    return taken(PLACE, usable_cores(), held)


def finish(rest: Unfinished, owed: Owed, held: contextlib.ExitStack) -> None:
    """Draws the pictures of a scene and completes its folder, or notes there why they are missing.

    Args:
        rest: Of its record.
        owed: Its folder.
        held: What the record needs beside it; ended here.
    """
    with held:
        try:
            with bounded(STAGES[-1]):
                state = rest.finish()
            complete(owed, state)
        except BaseException as error:
            with contextlib.suppress(OSError):  # the folder is gone, or its disk is full
                give_up(owed.here, _reason(error, owed.folder))
            raise


def _reason(error: BaseException, folder: Path) -> str:
    if isinstance(error, OSError):
        told = explained(error, folder)
        return scrub_all(told.strerror or str(told))
    if isinstance(error, StageTimeout):
        return str(error)
    if isinstance(error, KeyboardInterrupt):
        return "the process that drew them was told to end"
    return scrub_all(f"{type(error).__name__}: {error}")
