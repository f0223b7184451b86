r"""Kills a dataset run at random moments until it is done; compares it with an uninterrupted one.

    python -m benchmarks.resume --scenes 60 --kills 20 [--out FOLDER] [--workers 2] [--seed 0] \
        [--shortest 8] [--longest 30] [--options '--render all --cameras 2 --size 64x64']

Every kill is a SIGKILL, by turns of the command, of one of its workers, or of both, at a random
moment; the command is then started again with --resume. At the end both datasets must hold the same
files with the same bytes, timings aside (tables `timings` and `runs`, `meta/run.json`,
`meta/timings.json`, the card's section on cost); of films whose bytes differ, all decoded frames
must be the same. Prints the log of kills and exits with 1 on any difference, or with fewer kills.
"""

from __future__ import annotations

import argparse
import contextlib
import filecmp
import os
from pathlib import Path
import random
import signal
import subprocess
import sys
import tempfile
import time
from typing import Any

import numpy as np

from esg.dataset.card import CARD, untimed
from esg.dataset.clips.encoding import decoded

TIMINGS = ("timings/", "runs/", "meta/run.json", "meta/timings.json", ".lock")
"""Files that hold times."""
FILMS = (".mp4", ".mkv")


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--scenes", type=int, default=60)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--shortest", type=float, default=8.0, help="earliest kill [s]")
    parser.add_argument("--longest", type=float, default=30.0, help="latest kill [s]")
    parser.add_argument("--out", type=Path, help="keep the two datasets here")
    parser.add_argument("--kill-seed", type=int, default=0, help="of moments and victims")
    parser.add_argument("--options", default="", help="more of `esg dataset`, as one text")
    parser.add_argument("--no-finish", action="store_true", help="stop after the kills")
    args = parser.parse_args()
    with contextlib.ExitStack() as stack:
        folder = args.out or Path(stack.enter_context(tempfile.TemporaryDirectory()))
        folder.mkdir(parents=True, exist_ok=True)
        command = [
            *(sys.executable, "-m", "esg.cli", "dataset", "--sample", str(args.scenes)),
            *("--seed", str(args.seed), "--workers", str(args.workers), "--mcap", "sample"),
            *args.options.split(),
        ]
        killed = folder / "killed"
        made = interrupted(command, killed, args)
        if args.no_finish:
            return 0
        print(f"{made} kills, then finished", flush=True)
        whole = folder / "whole"
        if not (whole / "meta" / "info.json").exists():
            subprocess.run([*command, "--out", str(whole), "--resume"], check=False)
        problems = differences(whole, killed)
        names = files(whole)
        films = [n for n in names if n.endswith(FILMS)]
        exact = sum(
            (killed / n).is_file() and filecmp.cmp(whole / n, killed / n, False) for n in films
        )
        print(
            f"{len(names)} files compared, {len(problems)} differences; of {len(films)} films "
            f"{exact} have the same bytes"
        )
        for problem in problems:
            print(f"  {problem}")
        return 1 if problems or made < args.kills else 0


def interrupted(command: list[str], out: Path, args: argparse.Namespace) -> int:
    """Builds a dataset with kills; returns how many there were.

    Whoever is killed before the first scene of a start-up proves little: a kill comes at the
    earliest after `--shortest` seconds, if the run has not ended by then.
    """
    rng = random.Random(args.kill_seed)
    kills = 0
    while not (args.no_finish and kills >= args.kills):
        process = subprocess.Popen(
            [*command, "--out", str(out), "--resume"], stdout=subprocess.PIPE, text=True
        )
        after = rng.uniform(args.shortest, args.longest) if kills < args.kills else None
        victim = ("command", "worker", "both")[kills % 3]
        try:
            process.communicate(timeout=after)
            if process.returncode not in (0, 3):
                raise SystemExit(f"the command failed with exit code {process.returncode}")
            return kills
        except subprocess.TimeoutExpired:
            kills += 1
            done = len(list((out / "marks").glob("*.json"))) if out.exists() else 0
            print(f"kill {kills:2}: {victim} after {after:.1f} s, {done} batches done", flush=True)
            kill(process, victim, rng)
    return kills


def kill(
    process: subprocess.Popen[Any], victim: str = "command", rng: random.Random | None = None
) -> None:
    """Kills what is asked and waits until all processes of the run have ended."""
    rng = rng or random.Random(0)
    family = descendants(process.pid)
    workers = [p for p in family if is_worker(p)]
    if victim in ("worker", "both") and workers:
        with contextlib.suppress(ProcessLookupError):
            os.kill(rng.choice(workers), signal.SIGKILL)
    if victim == "worker":
        # The command lives on and replaces its worker; give it time to do so, then end it too.
        time.sleep(rng.uniform(0.5, 3.0))
        family = descendants(process.pid)
    with contextlib.suppress(ProcessLookupError):
        process.send_signal(signal.SIGKILL)
    process.wait()
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline and any(alive(p) for p in family):
        time.sleep(0.1)


def is_worker(pid: int) -> bool:
    """Whether a process is a worker: spawned, or forked off the one that loads for all."""
    line = command_line(pid)
    if "forkserver" not in line:
        return "spawn_main" in line
    with contextlib.suppress(OSError, IndexError, ValueError):
        status = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        return "forkserver" in command_line(int(status[1]))
    return False


def descendants(pid: int) -> list[int]:
    """All processes below a process."""
    out: list[int] = []
    # Children that a thread started are listed under the thread.
    with contextlib.suppress(OSError):
        for listed in Path(f"/proc/{pid}/task").glob("*/children"):
            with contextlib.suppress(OSError):
                for number in listed.read_text().split():
                    out += [int(number), *descendants(int(number))]
    return out


def command_line(pid: int) -> str:
    """The command line of a process, empty if it is gone."""
    with contextlib.suppress(OSError):
        return Path(f"/proc/{pid}/cmdline").read_text().replace("\0", " ")
    return ""


def alive(pid: int) -> bool:
    """Whether a process runs (a zombie does not)."""
    with contextlib.suppress(OSError, IndexError):
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    return False


def files(folder: Path) -> list[str]:
    """Files of a dataset whose bytes do not depend on time."""
    names = (p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file())
    return sorted(n for n in names if not n.startswith(TIMINGS))


def differences(first: Path, second: Path) -> list[str]:
    """Files that only one of two datasets has, or that differ; of films, their frames."""
    a, b = set(files(first)), set(files(second))
    out = [f"only in {first.name}: {n}" for n in sorted(a - b)]
    out += [f"only in {second.name}: {n}" for n in sorted(b - a)]
    return [*out, *(f"differs: {n}" for n in sorted(a & b) if not alike(first / n, second / n))]


def alike(first: Path, second: Path) -> bool:
    """Whether two files of a dataset say the same."""
    if filecmp.cmp(first, second, shallow=False):
        return True
    if first.name == CARD:
        return untimed(first.read_text()) == untimed(second.read_text())
    return first.name.endswith(FILMS) and np.array_equal(decoded(first), decoded(second))


if __name__ == "__main__":
    sys.exit(main())
