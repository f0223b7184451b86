"""Undisturbed work that faults are done to, and calls of the command line in copies of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
import contextlib
from dataclasses import dataclass
import os
from pathlib import Path
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from esg.paths import kernel_cache_dir

ROOT = Path(__file__).parents[2]
PROMPT = "A toy truck rolls forward at 3 m/s and hits a wooden crate."
SUITE = f"""\
suite: faults
source: benchmarks/faults
scenes:
  - id: truck
    level: single
    prompt: "{PROMPT}"
    events:
      - {{id: e1, type: collision, a: toy truck, b: wooden crate}}
    constraints:
      - {{kind: initial, quantity: speed, object: toy truck, value: 3, unit: m/s}}
"""
HALF = [
    "dataset",
    "--sample",
    "4",
    "--batch",
    "2",
    "--out",
    "half",
    "--shard",
    "1/2",
    "--workers",
    "1",
]
"""A dataset of which half is made: its batches lie there as a killed run leaves them."""
MEMORY_BYTES = 2 * 2**30
"""What a command may allocate on malformed input."""
PATIENCE_S = 30.0
"""How long it may take."""
UGLY = re.compile(r"Traceback \(most recent call last\)|a defect of this software|core dumped")


@dataclass(frozen=True)
class Ended:
    """How a command ended.

    Args:
        code: Exit code; negative for a signal, None if it hung.
        out: What it printed.
        err: What it said on stderr.
        seconds: How long it took [s].
    """

    code: int | None
    out: str
    err: str
    seconds: float

    def wrong(self, allowed: Sequence[int]) -> str:
        """What is wrong with how it ended; empty if nothing is.

        Args:
            allowed: Exit codes that are right.
        """
        if self.code is None:
            return f"hung for {self.seconds:.0f} s"
        if UGLY.search(self.out + self.err):
            return "a defect or a traceback: " + " ".join((self.err or self.out).split())[-300:]
        if self.code not in allowed:
            return f"exit code {self.code}: " + " ".join((self.err or self.out).split())[-300:]
        if self.code in (1, 2) and not (self.out + self.err).strip():
            return f"exit code {self.code} without a word"
        return ""


def environment(place: Path, cache: Path) -> dict[str, str]:
    """The environment of a command that works in a folder with a cache of its own."""
    variables = {k: v for k, v in os.environ.items() if not k.startswith(("ESG_", "PREFECT_"))}
    return variables | {
        "ESG_CACHE_DIR": str(cache),
        "WARP_CACHE_PATH": str(kernel_cache_dir().parent),  # compiled once
        "ESG_DB": str(place / "runs" / "esg.duckdb"),
        "PYTHONPATH": str(ROOT),
        "TMPDIR": str(place / "tmp"),
        "XDG_DATA_HOME": str(place / "share"),
    }


def begin(arguments: Sequence[str], place: Path, cache: Path, **more: str) -> subprocess.Popen[str]:
    """Starts a command in a folder; its own process group can be killed as a whole."""
    (place / "tmp").mkdir(parents=True, exist_ok=True)
    return subprocess.Popen(
        [sys.executable, "-m", "esg", *arguments], cwd=place, text=True, errors="replace",
        env=environment(place, cache) | more, start_new_session=True, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip


def finish(command: subprocess.Popen[str], patience_s: float, started: float) -> Ended:
    """Waits for a command; one that hangs is killed with all it started."""
    try:
        out, err = command.communicate(timeout=patience_s)
    except subprocess.TimeoutExpired:
        os.killpg(command.pid, signal.SIGKILL)
        out, err = command.communicate()
        return Ended(None, out, err, time.monotonic() - started)
    return Ended(command.returncode, out, err, time.monotonic() - started)


def esg(
    arguments: Sequence[str], place: Path, cache: Path, patience_s: float = 600.0, **more: str
) -> Ended:
    """Runs a command to its end."""
    started = time.monotonic()
    return finish(begin(arguments, place, cache, **more), patience_s, started)


@dataclass(frozen=True)
class Started:
    """A command that runs.

    Args:
        pid: Of its process, which leads its own group.
        finish: Waits for so long [s], kills it if it hangs, and tells how it ended.
    """

    pid: int
    finish: Callable[[float], Ended]


def start(arguments: Sequence[str], place: Path, cache: Path, *, fork: bool) -> Started:
    """Starts a command.

    Args:
        arguments: Of the command line.
        place: Where it runs.
        cache: Its cache folder.
        fork: Whether it may be a fork of this process, which has the libraries loaded already;
            not for commands that start workers or servers.
    """
    if fork:
        return started_fork(arguments, place, cache, _nothing, memory=resource.RLIM_INFINITY)
    command = begin(arguments, place, cache)
    return Started(command.pid, lambda patience: finish(command, patience, time.monotonic()))


def forked(arguments: Sequence[str], place: Path, cache: Path, **more: str) -> Ended:
    """Runs a command to its end in a fork of this process, which has the libraries loaded already.

    Args:
        arguments: Of the command line.
        place: Where it runs.
        cache: Its cache folder.
        more: Further variables of its environment.
    """
    return started_fork(arguments, place, cache, _nothing, **more).finish(PATIENCE_S)


def started_fork(
    arguments: Sequence[str], place: Path, cache: Path,
    first: Callable[[], object], *, memory: int = MEMORY_BYTES, **more: str,
) -> Started:  # fmt: skip
    """Starts a command in a fork of this process.

    Args:
        arguments, place, cache, more: As of `forked`.
        first: Called in the fork before anything else.
        memory: That it may allocate [bytes].
    """
    (place / "tmp").mkdir(parents=True, exist_ok=True)
    said = Path(tempfile.mkdtemp(prefix="esg-said-"))
    started = time.monotonic()
    child = os.fork()
    if child == 0:
        os.setpgid(0, 0)
        for number, name in ((1, "out"), (2, "err")):
            handle = os.open(said / name, os.O_CREAT | os.O_WRONLY | os.O_TRUNC, 0o600)
            os.dup2(handle, number)
        first()
        _child(arguments, place, environment(place, cache) | more, memory)
    with contextlib.suppress(OSError):
        os.setpgid(child, child)  # whoever is first: it shall be killable as a group at once

    def ended(patience_s: float) -> Ended:
        code = _waited(child, patience_s)
        out, err = ((said / n).read_text(errors="replace") for n in ("out", "err"))
        shutil.rmtree(said, ignore_errors=True)
        return Ended(code, out, err, time.monotonic() - started)

    return Started(child, ended)


def _nothing() -> None:
    """What most forks do before their command."""


def _child(arguments: Sequence[str], place: Path, variables: dict[str, str], memory: int) -> None:
    code = 99
    try:
        sys.stdout = open(1, "w", closefd=False)  # noqa: SIM115
        sys.stderr = open(2, "w", closefd=False)  # noqa: SIM115
        resource.setrlimit(resource.RLIMIT_DATA, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        os.chdir(place)
        os.environ.clear()
        os.environ.update(variables)
        sys.argv = ["esg", *arguments]
        from esg.cli import main

        main()
    except SystemExit as ended:
        code = ended.code if isinstance(ended.code, int) else 1
    except BaseException:
        import traceback

        traceback.print_exc()
    finally:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        os._exit(code)


def _waited(child: int, patience_s: float) -> int | None:
    """The exit code of a child, None if it had to be killed."""
    pause, started = 0.002, time.monotonic()
    while True:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status)
        if time.monotonic() - started > patience_s:
            os.killpg(child, signal.SIGKILL)
            os.waitpid(child, 0)
            return None
        time.sleep(pause)
        pause = min(2 * pause, 0.05)


def prepared(folder: Path) -> Path:
    """A folder in which a scene was made, a suite run and a small dataset built, undisturbed.

    Args:
        folder: Kept from call to call if it is complete and the code is the same.

    Raises:
        RuntimeError: If one of the commands fails.
    """
    from esg.up.place import stamp

    done = folder / "complete"
    if done.is_file() and done.read_text() == stamp():
        return folder
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "faults.yaml").write_text(SUITE)
    for arguments in (
        ["setup"],
        ["generate", PROMPT],
        ["bench", "faults.yaml", "--runs", "1"],
        ["dataset", "--sample", "4", "--out", "data", "--workers", "1", "--mcap", "all"],
        HALF,
        ["report", "runs/bench-faults-batched-physx"],
    ):
        ended = esg(arguments, folder, folder / "cache")
        if ended.code not in (0, 3):
            raise RuntimeError(f"esg {' '.join(arguments)}: {ended.err or ended.out}")
    shutil.rmtree(folder / "tmp", ignore_errors=True)
    done.write_text(stamp())
    return folder


def scene_of(folder: Path) -> Path:
    """The scene folder of a prepared folder's single scene."""
    return next(p.parent for p in sorted((folder / "runs").glob("*/prompt.txt")))


def copied(source: Path, target: Path) -> Path:
    """A copy of a prepared folder without its cache, which commands may share or copy."""
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(source, target, ignore=shutil.ignore_patterns("cache", "tmp", "complete"))
    return target
