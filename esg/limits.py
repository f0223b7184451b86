"""Limits on how many scenes may be in one stage at a time, on this machine.

`ESG_STAGE_LIMITS="optimize=1,replay=4"`: whatever the number of workers and commands, at most one
search runs at a time (one GPU), and four replays. A place in a stage is a locked file, so that it
is free again the moment its process ends, however it ends.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping
import contextlib
import os
import time

from esg.outcomes import UserError
from esg.paths import cache_dir
from esg.pipeline import STAGES

VARIABLE = "ESG_STAGE_LIMITS"
_WAIT_S = 0.05


def stage_limits(text: str | None = None) -> Mapping[str, int]:
    """The limits that are set.

    Args:
        text: `stage=number` pairs with commas between; default the environment variable.

    Raises:
        UserError: Naming every pair that is none.
    """
    text = os.environ.get(VARIABLE, "") if text is None else text
    out: dict[str, int] = {}
    problems: list[str] = []
    for pair in filter(None, (p.strip() for p in text.split(","))):
        stage, _, number = (p.strip() for p in pair.partition("="))
        if stage not in STAGES:
            problems.append(f"{pair!r}: no stage {stage!r}; stages are {', '.join(STAGES)}")
        elif not number.isdecimal() or not 1 <= int(number) <= 1024:
            problems.append(f"{pair!r}: give a number from 1 to 1024, e.g. {stage}=2")
        else:
            out[stage] = int(number)
    if problems:
        raise UserError("\n".join(f"{VARIABLE} {p}" for p in problems))
    return out


@contextlib.contextmanager
def place_in(stage: str) -> Generator[None]:
    """Waits for a place in a stage and keeps it for the body; without a limit, at once."""
    limit = stage_limits().get(stage)
    if limit is None:
        yield
        return
    import fcntl

    folder = cache_dir() / "limits"
    folder.mkdir(parents=True, exist_ok=True)
    while True:
        for k in range(limit):
            with (folder / f"{stage}-{k}.lock").open("w") as file:
                try:
                    fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                except BlockingIOError:
                    continue
                yield
                return
        time.sleep(_WAIT_S)
