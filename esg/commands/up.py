"""`esg up`: a warm worker on this machine for single scenes."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter

START_S = 600.0
"""Kernels that are not compiled yet take minutes."""
MOST_IDLE_MIN = 7 * 24 * 60
_BOOT = (
    "import json, sys; from pathlib import Path; sys.path[:] = json.loads(sys.argv[1]); "
    "from esg.up.server import serve; from esg.cli import main; "
    "sys.exit(serve(main, Path(sys.argv[2]), float(sys.argv[3])))"
)


def up(
    *,
    idle: float = 15.0,
    stop: Annotated[bool, Parameter(negative="")] = False,
    status: Annotated[bool, Parameter(negative="")] = False,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Start a warm worker that esg generate, draft and replay use from then on.

    It listens on a socket that only you can open, runs each command in a process of its own, and
    ends when nothing has been asked of it for a while. A worker serves one checkout, interpreter
    and set of ESG_ variables; when the code changes, commands work without it. ESG_UP=0 asks none.

    Args:
        idle: Minutes without a command after which it ends.
        stop: End the worker; what runs is finished first.
        status: Tell whether it runs and what it has done; exit code 1 if it does not run.
        json: Print one JSON document.
    """
    import json as codec
    import sys

    from esg.api.inputs import check_cache, checked, in_range
    from esg.outcomes import UserError
    from esg.up.client import asked
    from esg.up.place import make_private, socket_path

    checked(lambda: in_range("--idle", idle, 0.01, MOST_IDLE_MIN), check_cache)
    if stop and status:
        raise UserError("--stop and --status: give one of them")
    if sys.platform != "linux":
        raise UserError("esg up needs Linux: elsewhere nothing tells who connects to a socket")
    path = socket_path()
    if stop or status:
        return _told(asked("stop" if stop else "status", path), stop, json)
    make_private(path.parent)
    found = asked("status", path)
    if found is not None and not codec.loads(found)["current"]:
        asked("stop", path)
        found = None
    if found is None:
        _start(path, 60.0 * idle)
    return _told(asked("status", path), False, json)


def _start(path: Path, idle_s: float) -> None:
    """Starts a worker and waits until it answers.

    Raises:
        UserError: If it does not.
    """
    import json
    import os
    import subprocess
    import sys
    import time

    from esg.commands.console import progress
    from esg.outcomes import UserError
    from esg.up.client import asked
    from esg.up.server import TAKEN_PLACE

    log = path.with_suffix(".log")
    command = [sys.executable, "-c", _BOOT, json.dumps(sys.path), str(path), str(idle_s)]
    # A fork of a process that uses a GPU cannot use it: commands for one are never asked of it.
    environment = {**os.environ, "CUDA_VISIBLE_DEVICES": "", "PXR_WORK_THREAD_LIMIT": "1"}

    def launched() -> subprocess.Popen[bytes]:
        with log.open("wb") as out:
            return subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=out,
                stderr=out,
                env=environment,
                cwd="/",
                start_new_session=True,
            )

    process = launched()
    deadline = time.monotonic() + START_S
    with progress(1, "loading what scenes need"):
        while asked("status", path) is None:
            code = process.poll()
            if code == TAKEN_PLACE:  # another one starts, or finishes what it runs
                time.sleep(1.0)
                process = launched()
            elif code is not None or time.monotonic() > deadline:
                process.kill()
                said = log.read_text("utf-8", "replace").strip().splitlines()[-1:]
                raise UserError(f"the worker did not start: {' '.join(said) or log}", exit_code=1)
            time.sleep(0.1)


def _told(answer: str | None, stopped: bool, as_json: bool) -> int:
    """Prints what a worker said of itself; the exit code."""
    import json

    from esg.commands.console import emit

    facts: dict[str, Any] = {"running": answer is not None}
    if answer is not None:
        facts = {"running": not stopped, "worker": json.loads(answer)}
    if as_json:
        emit(facts)
    elif answer is None:
        print("no worker runs for this code and these settings")
    else:
        print(_line(facts["worker"], stopped))
    return 0 if answer is not None or stopped else 1


def _line(worker: dict[str, Any], stopped: bool) -> str:
    if stopped:
        return f"stopped the worker (process {worker['pid']}) after {worker['served']} commands"
    code = "" if worker["current"] else "; the code has changed since: start another"
    drawing = f"{n} drawing pictures, " if (n := worker.get("finishing")) else ""
    return (
        f"a worker runs (process {worker['pid']}): {worker['served']} commands, "
        f"{worker['running']} running, {drawing}"
        f"ends after {worker['ends_after_s'] / 60:g} min without one{code}"
    )
