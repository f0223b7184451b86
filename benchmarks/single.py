"""What one scene costs from a command line, here and in another checkout.

    python -m benchmarks.single [--against CHECKOUT] [--up] [--no-wait] [--runs 3] [--prompt TEXT]…

Seconds elapsed of `esg generate` until it answers and until the scene folder is complete, and
core-seconds of all of it, one prompt and one seed after the other, with every seed new: a cold
process on warm caches (one run of each checkout is thrown away, which warms them), with `--no-wait`
where a checkout has that, or with a worker that `esg up` started. The checkouts take turns. Files
of the folders that they made of one seed are compared byte by byte, but for sums and times.
"""

from __future__ import annotations

import argparse
from collections.abc import Generator, Sequence
import contextlib
import ctypes
from dataclasses import dataclass
import json
import os
from pathlib import Path
import secrets
import statistics
import subprocess
import sys
import tempfile
import time
from typing import Any

HERE = Path(__file__).parents[1]
PROMPTS = {
    "S6": "A car collide with a trashbin, knocking the trashbin to collide with a picnic table by "
    "the street side.",
    "ball": "A ball rolls off a table into a bucket.",
}
NOT_COMPARED = frozenset({"SHA256SUMS", "log.jsonl"})
"""Files that hold times, or sums of those that do."""
FINISHING = ".finishing"
"""The mark of a folder that is not complete yet."""
WAIT_S = 600.0
_TICKS = os.sysconf("SC_CLK_TCK")
_SUBREAPER = 36


@dataclass(frozen=True)
class Cost:
    """Of one command.

    Args:
        seconds: From its start to its end, which is its answer [s].
        whole_s: From its start until the folder is complete [s].
        core_seconds: Of the processor, for all of it: its processes and a worker's [s].
        folder: Of the scene.
        stages: Seconds of each stage [s].
    """

    seconds: float
    whole_s: float
    core_seconds: float
    folder: Path
    stages: dict[str, float]


class Checkout:
    """A checkout whose `esg` makes scenes into a folder of its own.

    Args:
        root: Of the checkout.
        work: For its scenes and its database.
    """

    def __init__(self, root: Path, work: Path) -> None:
        self.root, self.work, self.worker = root, work, 0
        self.options: tuple[str, ...] = ()
        self._environment = os.environ | {
            "PYTHONPATH": str(root),
            "ESG_DB": str(work / "esg.duckdb"),
            "ESG_UP": "0",
        }

    def esg(self, *arguments: str) -> str:
        """Runs a command; what it prints.

        Raises:
            subprocess.CalledProcessError: If it fails; 3, a scene that did, is no failure.
        """
        command = [sys.executable, "-m", "esg.cli", *arguments]
        done = subprocess.run(
            command, cwd=self.work, env=self._environment, stdout=subprocess.PIPE, check=False
        )
        if done.returncode not in (0, 3):
            raise subprocess.CalledProcessError(done.returncode, command, done.stdout)
        return done.stdout.decode()

    @contextlib.contextmanager
    def warm(self) -> Generator[None]:
        """Has commands of the body handed to a worker."""
        self._environment["ESG_UP"] = "1"
        told = json.loads(self.esg("up", "--json"))
        self.worker = int(told["worker"]["pid"])
        try:
            yield
        finally:
            self.esg("up", "--stop")

    def answers_first(self) -> None:
        """Has cold commands answer first, if this checkout can."""
        if "--no-wait" in self.esg("generate", "--help"):
            self.options = ("--no-wait",)

    def made(self, prompt: str, seed: int) -> Cost:
        """Makes a scene and tells what that cost."""
        cores, start = self._spent(), time.perf_counter()
        out = self.esg(
            "generate", prompt, "--seed", str(seed), "--json", "--out", "scenes", *self.options
        )
        seconds = time.perf_counter() - start
        told = json.loads(out)
        folder = self.work / told["folder"]
        finished(folder)
        whole_s = time.perf_counter() - start if told.get("finishing") else seconds
        stages = {row["stage"]: float(row["seconds"]) for row in told["stages"]}
        return Cost(seconds, whole_s, self._spent() - cores, folder, stages)

    def _spent(self) -> float:
        """Processor time of all that has ended of this process's and the worker's children [s]."""
        own = os.times()
        spent = own.children_user + own.children_system
        if self.worker:
            # After the name, in brackets, come the state and eleven numbers before these times.
            told = Path(f"/proc/{self.worker}/stat").read_text().rpartition(")")[2].split()
            spent += sum(int(v) for v in told[11:15]) / _TICKS
        return spent


def finished(folder: Path) -> None:
    """Waits until a scene folder is complete and who completed it has ended.

    Raises:
        TimeoutError: If that never happens.
    """
    deadline = time.monotonic() + WAIT_S
    with contextlib.suppress(FileNotFoundError):
        pid = int(json.loads((folder / FINISHING).read_bytes())["pid"])
        while Path(f"/proc/{pid}").exists():
            with contextlib.suppress(ChildProcessError):  # a worker's
                os.waitpid(pid, os.WNOHANG)
            if time.monotonic() > deadline:
                raise TimeoutError(f"{folder} is not complete after {WAIT_S:g} s")
            time.sleep(0.01)
        if not (folder / "SHA256SUMS").exists():
            raise TimeoutError(f"{folder} was never completed")


def other_files(a: Path, b: Path) -> list[str]:
    """Files that are in one of two scene folders only, or differ; those with times left out."""
    found = [
        {p.relative_to(root).as_posix(): p for p in root.rglob("*") if p.is_file()}
        for root in (a, b)
    ]
    return sorted(
        name
        for name in found[0].keys() | found[1].keys()
        if name not in NOT_COMPARED
        and (
            name not in found[0]
            or name not in found[1]
            or found[0][name].read_bytes() != found[1][name].read_bytes()
        )
    )


def measured(
    checkouts: Sequence[Checkout], prompt: str, seeds: Sequence[int]
) -> tuple[list[list[Cost]], dict[int, list[str]]]:
    """Costs of each checkout, taking turns; and by seed the files that are not the same in all."""
    costs: list[list[Cost]] = [[] for _ in checkouts]
    unlike: dict[int, list[str]] = {}
    for number, seed in enumerate(seeds):
        # Who comes second finds the disk's cache warm: they take turns at that, too.
        order = list(range(len(checkouts)))[:: 1 if number % 2 == 0 else -1]
        now = {k: checkouts[k].made(prompt, seed) for k in order}
        for k, cost in now.items():
            costs[k].append(cost)
            other = other_files(now[0].folder, cost.folder)
            unlike[seed] = sorted({*unlike.get(seed, []), *other})
    return costs, unlike


def line(name: str, costs: Sequence[Cost]) -> str:
    """Minimum and median of a checkout's runs."""
    columns = [
        [c.seconds for c in costs],
        [c.whole_s for c in costs],
        [c.core_seconds for c in costs],
    ]
    told = [f"{min(v):6.2f} {statistics.median(v):6.2f}" for v in columns]
    return f"{name:>24}  {'  '.join(told)}"


def stages_line(costs: Sequence[Cost]) -> str:
    """Median seconds of each stage."""
    return "  ".join(
        f"{stage} {statistics.median(c.stages.get(stage, 0.0) for c in costs):.2f}"
        for stage in costs[0].stages
    )


def report(args: Any, work: Path) -> int:
    """Measures and prints; 1 if bytes differ."""
    trees = [HERE, *([args.against.resolve()] if args.against else [])]
    checkouts: list[Checkout] = []
    for number, tree in enumerate(trees):
        (work / str(number)).mkdir()
        checkouts.append(Checkout(tree, work / str(number)))
        if args.no_wait:
            checkouts[-1].answers_first()
    prompts = {p: p for p in args.prompt} or PROMPTS
    differs = False
    with contextlib.ExitStack() as held:
        if args.up:
            for checkout in checkouts:
                held.enter_context(checkout.warm())
        print(
            f"{'':>24}  seconds        until complete  core-seconds\n"
            f"{'':>24}   least median   least median   least median"
        )
        for name, prompt in prompts.items():
            # Seeds of their own, so that nothing of the scene is found in the store.
            seeds = [secrets.randbelow(10**6) for _ in range(args.runs + 1)]
            measured(checkouts, prompt, seeds[:1])
            costs, unlike = measured(checkouts, prompt, seeds[1:])
            print(name)
            for checkout, own in zip(checkouts, costs, strict=True):
                print(line(checkout.root.name, own))
                print(f"{'':>24}  {stages_line(own)}", flush=True)
            for seed, files in unlike.items():
                if files:
                    differs = True
                    print(f"{'':>24}  seed {seed}: not the same bytes: {', '.join(files)}")
            if args.against and not any(unlike.values()):
                print(f"{'':>24}  the same bytes")
    return int(differs)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--against", type=Path, help="a checkout of another commit")
    parser.add_argument("--up", action="store_true", help="with a worker of `esg up`")
    parser.add_argument("--no-wait", action="store_true", help="cold commands answer first")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--prompt", action="append", default=[], help="in place of the usual two")
    args = parser.parse_args()
    # What goes on after a command's answer becomes a child of this process: its time counts.
    ctypes.CDLL(None).prctl(_SUBREAPER, 1)
    with tempfile.TemporaryDirectory(prefix="esg-single-") as work:
        return report(args, Path(work))


if __name__ == "__main__":
    sys.exit(main())
