"""Makes a dataset on a cluster whose nodes are killed and replaced; compares it with one machine's.

    python -m benchmarks.cluster --runner dask|ray [--scenes 24] [--batch 3] [--nodes 3] \\
        [--slots 1,2] [--kills 2] [--seed 0] [--shortest 2] [--longest 10] [--away 8] \\
        [--object-store 80] [--options '--strategy none'] [--out FOLDER] [--json FILE]

A scheduler (Dask) or a head without cores (Ray), and every node, are processes of their own, as
`dask worker` and `ray start` make them; nodes have 1 or 2 slots by turns, Ray's a small object
store [MB]. The real command, `esg dataset --runner`, works at their address. At random moments a
node that is making batches loses all its processes, by turns at once (SIGKILL) and as spot machines
are evicted (SIGTERM, SIGKILL after two seconds); another joins some seconds later. The command is
never started again. Who makes a batch holds its lock, which is how batches that were begun twice
are counted: not more than the killed nodes were making. At the end the same dataset is made by one
process, and both must hold the same files with the same bytes as `benchmarks.resume` compares them.
Exits with 1 on a difference, on a batch made twice for no kill, or with fewer kills than asked.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
import contextlib
from dataclasses import dataclass, field
import itertools
import json
import os
from pathlib import Path
import random
import signal
import socket
import subprocess
import sys
import tempfile
import time
from typing import Any

from benchmarks.resume import alive, descendants, differences, files

TICK_S = 0.1
START_S = 120.0
JOINED = {"dask": "Registered to", "ray": "runtime started"}
"""What a node says once it has joined."""
NOTICE_S = 2.0
"""Between the notice of an eviction and its end [s]."""
ENVIRONMENT = {"OMP_NUM_THREADS": "1", "ESG_THREADS": "1", "RAY_DEDUP_LOGS": "0"}


@dataclass(eq=False)
class Node:
    """One machine of the cluster.

    Args:
        name: Of the node.
        slots: Batches that it makes at once.
        process: The first of its processes.
        making: Batches whose locks its processes hold.
        most: Largest number of them so far.
    """

    name: str
    slots: int
    process: subprocess.Popen[Any]
    making: set[int] = field(default_factory=set)
    most: int = 0


class Cluster:
    """Processes of a cluster; all of them end with the block.

    Args:
        runner: dask or ray.
        folder: For logs and scratch files.
        slots: Of the nodes, by turns.
        object_store_mb: Of a node of Ray [MB].
    """

    def __init__(
        self, runner: str, folder: Path, slots: list[int], object_store_mb: int, nodes: int
    ) -> None:
        self.runner = runner
        self.folder = folder
        self.object_store = str(object_store_mb * 10**6)
        self.nodes: list[Node] = []
        self.former: list[Node] = []
        self._slots = itertools.cycle(slots)
        self._numbers = itertools.count(1)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.address = f"127.0.0.1:{free.getsockname()[1]}"
        self.head = self._start("head", self._head())
        listens(self.address)
        for _ in range(nodes):
            # In turn: raylets that start at once on one host take each other's ports.
            self.wait_for(self.add())

    @property
    def environment(self) -> dict[str, str]:
        """What tells the command where the cluster is."""
        if self.runner == "dask":
            return {**ENVIRONMENT, "ESG_DASK_ADDRESS": f"tcp://{self.address}"}
        return {**ENVIRONMENT, "RAY_ADDRESS": self.address}

    def add(self) -> Node:
        """Starts one more node."""
        name, slots = f"node-{next(self._numbers)}", next(self._slots)
        node = Node(name, slots, self._start(name, self._node(name, slots)))
        self.nodes.append(node)
        return node

    def wait_for(self, node: Node) -> None:
        """Waits until a node has joined."""
        deadline = time.monotonic() + START_S
        while JOINED[self.runner] not in (log := self._log(node.name).read_text()):
            if time.monotonic() > deadline or node.process.poll() is not None:
                raise SystemExit(f"{node.name} did not join: {log[-2000:]}")
            time.sleep(TICK_S)

    def kill(self, node: Node, *, notice: bool) -> None:
        """Ends all processes of a node at once, with `notice` a while after asking for it."""
        self.nodes.remove(node)
        self.former.append(node)
        if notice:
            node.process.send_signal(signal.SIGTERM)
            deadline = time.monotonic() + NOTICE_S
            while node.process.poll() is None and time.monotonic() < deadline:
                time.sleep(TICK_S)
        end(node.process)

    def close(self) -> None:
        for process in [*(n.process for n in self.nodes), self.head]:
            end(process)

    def _log(self, name: str) -> Path:
        return self.folder / f"{name}.log"

    def _start(self, name: str, command: list[str]) -> subprocess.Popen[Any]:
        with self._log(name).open("wb") as log:
            return subprocess.Popen(
                [sys.executable, "-m", *command],
                env={**os.environ, **ENVIRONMENT},
                stdout=log,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )

    def _head(self) -> list[str]:
        host, port = self.address.split(":")
        if self.runner == "dask":
            return ["dask", "scheduler", "--host", host, "--port", port, "--no-dashboard"]
        return [
            *("ray.scripts.scripts", "start", "--head", "--block", "--port", port, "--num-cpus=0"),
            *("--include-dashboard=false", "--object-store-memory", self.object_store),
            *("--node-ip-address", host, "--temp-dir", str(self.folder / "ray")),
        ]

    def _node(self, name: str, slots: int) -> list[str]:
        if self.runner == "dask":
            return [
                *("dask", "worker", f"tcp://{self.address}", "--name", name, "--nthreads=1"),
                *("--nworkers", str(slots), "--no-dashboard"),
                *("--local-directory", str(self.folder / name)),
            ]
        return [
            *("ray.scripts.scripts", "start", "--block", "--address", self.address),
            *("--num-cpus", str(slots), "--object-store-memory", self.object_store),
            *("--node-name", name),
        ]


def listens(address: str) -> None:
    """Waits until somebody listens at an address."""
    host, port = address.split(":")
    deadline = time.monotonic() + START_S
    while True:
        with contextlib.suppress(OSError), socket.create_connection((host, int(port)), 1):
            return
        if time.monotonic() > deadline:
            raise SystemExit(f"nobody listens at {address} after {START_S:.0f} s")
        time.sleep(TICK_S)


def end(process: subprocess.Popen[Any]) -> None:
    """Kills a process and all below it at one moment: none learns of the others' death."""
    family = [process.pid, *descendants(process.pid)]
    for number in (signal.SIGSTOP, signal.SIGKILL):
        for pid in family:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, number)
    process.wait()
    while any(alive(pid) for pid in family):
        time.sleep(TICK_S)


def look(nodes: list[Node], out: Path, makers: dict[int, set[int]]) -> None:
    """Finds who makes which batch: whoever has its lock open."""
    prefix = str(out / "locks" / "batch-")
    for node in nodes:
        node.making = set()
        for pid in [node.process.pid, *descendants(node.process.pid)]:
            with contextlib.suppress(OSError):
                for link in Path(f"/proc/{pid}/fd").iterdir():
                    name = os.readlink(link) if link.is_symlink() else ""
                    if name.startswith(prefix):
                        number = int(name.removeprefix(prefix))
                        node.making.add(number)
                        makers[number].add(pid)
        node.most = max(node.most, len(node.making))


def unfinished(out: Path, batches: set[int]) -> set[int]:
    """Those of some batches that have no mark."""
    return {n for n in batches if not (out / "marks" / f"batch-{n:06d}.json").exists()}


def make(command: list[str], out: Path, cluster: Cluster, args: argparse.Namespace) -> Any:
    """Runs the command on the cluster, kills and adds nodes meanwhile; what came of it."""
    rng, start = random.Random(args.seed), time.monotonic()
    makers: dict[int, set[int]] = defaultdict(set)
    lost: set[int] = set()
    due, joins, kills = None, [], 0
    environment = {**os.environ, **cluster.environment}
    process = subprocess.Popen([*command, "--out", str(out)], env=environment)
    while process.poll() is None:
        time.sleep(TICK_S)
        look(cluster.nodes, out, makers)
        now = time.monotonic()
        busy = [n for n in cluster.nodes if unfinished(out, n.making)]
        if joins and now >= joins[0]:
            joins.pop(0)
            node = cluster.add()
            print(f"{now - start:6.1f} s: {node.name} with {node.slots} slots joins", flush=True)
        if due is None and busy and kills < args.kills:
            due = now + rng.uniform(args.shortest, args.longest)
        elif due is not None and now >= due and busy:
            node, notice = rng.choice(busy), kills % 2 == 1
            before = unfinished(out, node.making)
            cluster.kill(node, notice=notice)
            gone = unfinished(out, before)
            lost |= gone
            kills, due = kills + 1, None
            joins.append(now + rng.uniform(0.5, 1.0) * args.away)
            how = "evicted" if notice else "killed"
            print(f"{now - start:6.1f} s: {node.name} {how}, in batches {sorted(gone)}", flush=True)
    return {
        "exit_code": process.returncode,
        "seconds": round(time.monotonic() - start, 1),
        "kills": kills,
        "lost": sorted(lost),
        "made_twice": sorted(n for n, pids in makers.items() if len(pids) > 1),
        "most_at_once": {
            n.name: f"{n.most} of {n.slots}" for n in [*cluster.former, *cluster.nodes]
        },
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--runner", choices=("dask", "ray"), required=True)
    parser.add_argument("--scenes", type=int, default=24)
    parser.add_argument("--batch", type=int, default=3)
    parser.add_argument("--nodes", type=int, default=3)
    parser.add_argument("--slots", default="1,2", help="of the nodes, by turns")
    parser.add_argument("--kills", type=int, default=2)
    parser.add_argument("--seed", type=int, default=0, help="of moments and victims")
    parser.add_argument("--shortest", type=float, default=2.0, help="to the next kill [s]")
    parser.add_argument("--longest", type=float, default=10.0, help="to the next kill [s]")
    parser.add_argument("--away", type=float, default=8.0, help="until another joins, at most [s]")
    parser.add_argument("--object-store", type=int, default=80, help="of a node of Ray [MB]")
    parser.add_argument("--options", default="", help="more of `esg dataset`, as one text")
    parser.add_argument("--out", type=Path, help="keep the two datasets here")
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    with contextlib.ExitStack() as stack:
        # Sockets of Ray lie below it, whose names are short.
        scratch = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="cl-")))
        folder = (args.out or scratch).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        command = [
            *(sys.executable, "-m", "esg.cli", "dataset", "--sample", str(args.scenes)),
            *("--batch", str(args.batch), *args.options.split()),
        ]
        slots = [int(n) for n in args.slots.split(",")]
        cluster = Cluster(args.runner, scratch, slots, args.object_store, args.nodes)
        with contextlib.closing(cluster):
            made = make([*command, "--runner", args.runner], folder / args.runner, cluster, args)
        start = time.monotonic()
        if not (folder / "one" / "meta" / "info.json").exists():
            subprocess.run([*command, "--workers", "1", "--out", str(folder / "one")], check=False)
        made["seconds_of_one"] = round(time.monotonic() - start, 1)
        problems = differences(folder / "one", folder / args.runner)
        made |= {"files": len(files(folder / "one")), "differences": problems}
    text = json.dumps(made, indent=2)
    print(text)
    if args.json:
        args.json.write_text(text + "\n")
    wrong = problems or made["exit_code"] not in (0, 3) or made["kills"] < args.kills
    return 1 if wrong or set(made["made_twice"]) - set(made["lost"]) else 0


if __name__ == "__main__":
    sys.exit(main())
