"""Watches a real `esg dataset` run: scenes over time, memory and CPU time of its processes.

Used by `python -m benchmarks.throughput --wall`, which says what is measured.
"""

from __future__ import annotations

from collections.abc import Sequence
import contextlib
from dataclasses import dataclass, field
import json
import os
from pathlib import Path
from statistics import median
import subprocess
import threading
import time
from typing import Any

from benchmarks.resume import command_line, descendants, is_worker, kill

MIB = 2**20
ROLES = ("command", "server", "worker", "compiler")


def role_of(pid: int, command: int) -> str:
    """What a process of the run is: one of `ROLES`, or empty for helpers."""
    if pid == command:
        return "command"
    line = command_line(pid)
    if is_worker(pid):
        return "worker"
    if "multiprocessing" in line or not line:
        return ""
    if any(name in line for name in ("g++", "cc1plus", "collect2", "/ld", "/as ")):
        return "compiler"
    return "server"


def rss_mib(pid: int) -> float | None:
    """Resident memory of a process [MiB]."""
    with contextlib.suppress(OSError, IndexError, ValueError):
        pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE") / MIB
    return None


def cpu_s(pid: int, children: bool) -> float:
    """CPU time of a process, with that of its ended children or without [s]."""
    with contextlib.suppress(OSError, IndexError, ValueError):
        values = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
        ticks = [int(v) for v in values[11:15]]  # user and system, then those of the children
        return sum(ticks if children else ticks[:2]) / os.sysconf("SC_CLK_TCK")
    return 0.0


@dataclass
class Sample:
    """What the processes of a run looked like at one moment.

    Args:
        time_s: Since the command was started.
        scenes: Finished, in batches whose mark is written.
        rss: Resident memory by process [MiB].
    """

    time_s: float
    scenes: int
    rss: dict[int, float]


@dataclass
class Watch:
    """Samples a run until it ends.

    Args:
        out: Folder of the dataset.
        every_s: Time between samples.
    """

    out: Path
    every_s: float = 2.0
    samples: list[Sample] = field(default_factory=list)
    marks: dict[str, tuple[float, int]] = field(default_factory=dict)
    roles: dict[int, str] = field(default_factory=dict)
    cpu: dict[int, float] = field(default_factory=dict)
    wall_s: float = 0.0

    def run(
        self, command: Sequence[str], environment: dict[str, str], limit_s: float | None = None
    ) -> int | None:
        """Runs the command to its end, or kills it; returns its exit code.

        Args:
            command: The command.
            environment: Of its processes.
            limit_s: When it is killed, with its workers [s]; there is no exit code then.
        """
        start = time.perf_counter()
        process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL)
        over = threading.Event()
        thread = threading.Thread(target=self._sample, args=(process.pid, start, over), daemon=True)
        thread.start()
        code: int | None = None
        try:
            code = process.wait(limit_s)
            self.wall_s = time.perf_counter() - start
        except subprocess.TimeoutExpired:
            self.wall_s = time.perf_counter() - start
            kill(process)
        over.set()
        thread.join()
        return code

    def _sample(self, pid: int, start: float, over: threading.Event) -> None:
        while not over.wait(self.every_s):
            now = time.perf_counter() - start
            rss: dict[int, float] = {}
            for one in (pid, *descendants(pid)):
                role = self.roles.get(one) or role_of(one, pid)
                self.roles[one] = role
                # The command's children are counted themselves.
                used = cpu_s(one, children=role != "command")
                self.cpu[one] = max(self.cpu.get(one, 0.0), used)
                if role in ("worker", "command") and (size := rss_mib(one)) is not None:
                    rss[one] = size
            for path in sorted(self.out.glob("marks/*.json")):
                if path.name not in self.marks:
                    with contextlib.suppress(OSError, ValueError):
                        data = json.loads(path.read_bytes())
                        self.marks[path.name] = (now, int(data["scenes"]))
            done = sum(scenes for _, scenes in self.marks.values())
            self.samples.append(Sample(now, done, rss))

    def memory(self, warm: int) -> list[dict[str, Any]]:
        """Resident memory of every worker: over all, and its slope once `warm` scenes are made."""
        out: list[dict[str, Any]] = []
        # A process that ends gives its memory back bit by bit: that is no trend.
        end = max((t for t, _ in self.marks.values()), default=float("inf"))
        samples = [s for s in self.samples if s.time_s <= end]
        for pid in sorted(p for p, role in self.roles.items() if role == "worker"):
            all_of = [(s.scenes, s.rss[pid]) for s in samples if pid in s.rss]
            rest = [(n, size) for n, size in all_of if n >= warm]
            sizes = [size for _, size in rest] or [size for _, size in all_of]
            if not sizes:
                continue
            out.append({
                "samples": len(all_of),
                "first_scene": all_of[0][0], "last_scene": all_of[-1][0],
                "warm_min_mib": round(min(sizes), 1), "warm_max_mib": round(max(sizes), 1),
                "last_mib": round(sizes[-1], 1),
                "peak_mib": round(max(size for _, size in all_of), 1),
                "slope_mib_per_1000_scenes": slope(rest),
            })  # fmt: skip
        return out

    def memory_of(self, role: str, warm: int) -> dict[str, Any]:
        """Resident memory of a process of a role, whichever runs: by tenths, and its slope.

        Processes that replace one another are one line; of several at once it is the mean.

        Args:
            role: `worker` or `command`.
            warm: The slope is of what follows so many scenes.
        """
        end = max((t for t, _ in self.marks.values()), default=float("inf"))
        points: list[tuple[int, float]] = []
        for s in self.samples:
            of = [size for pid, size in s.rss.items() if self.roles[pid] == role]
            if of and s.time_s <= end:
                points.append((s.scenes, sum(of) / len(of)))
        rest = [point for point in points if point[0] >= warm]
        tenths = [rest[len(rest) * k // 10 : len(rest) * (k + 1) // 10] for k in range(10)]
        return {
            "median_mib_by_tenths": [round(median(v for _, v in t)) for t in tenths if t],
            "slope_mib_per_1000_scenes": slope(rest),
        }

    def cpu_by_role(self) -> dict[str, float]:
        """CPU time by what the processes are [s]; workers include the compilers they called."""
        out = dict.fromkeys(("command", "server", "worker"), 0.0)
        for pid, seconds in self.cpu.items():
            if self.roles.get(pid) in out:
                out[self.roles[pid]] += seconds
        return {role: round(seconds, 1) for role, seconds in out.items()}


def slope(points: Sequence[tuple[float, float]]) -> float | None:
    """Least-squares slope of memory by scenes [MiB per 1,000]; None with too few scenes."""
    n = len(points)
    if n < 3 or points[0][0] == points[-1][0]:
        return None
    mean_x = sum(x for x, _ in points) / n
    mean_y = sum(y for _, y in points) / n
    spread = sum((x - mean_x) ** 2 for x, _ in points)
    return round(1000 * sum((x - mean_x) * (y - mean_y) for x, y in points) / spread, 2)


def plot(watch: Watch, path: Path) -> None:
    """Resident memory of every worker over finished scenes, as SVG."""
    width, height, left, bottom, top = 640, 280, 56, 40, 24
    workers = sorted(p for p, role in watch.roles.items() if role == "worker")
    lines = {w: [(s.scenes, s.rss[w]) for s in watch.samples if w in s.rss] for w in workers}
    lines = {w: points for w, points in lines.items() if points}
    last = max((s.scenes for s in watch.samples), default=1) or 1
    high = max((size for points in lines.values() for _, size in points), default=1.0) * 1.1
    across, up = (width - left - 16) / last, (height - bottom - top) / high
    colors = ("#1f77b4", "#d95f02", "#2ca02c", "#9467bd", "#8c564b", "#e377c2", "#7f7f7f")
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        'font-family="sans-serif" font-size="11">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
        f'<text x="{left}" y="15">Resident memory of the workers [MiB] over finished scenes</text>',
    ]
    for k in range(5):
        x, y = left + across * last * k / 4, height - bottom - up * high * k / 4
        out += [
            f'<line x1="{left}" x2="{width - 16}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>',
            f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{high * k / 4:.0f}</text>',
            f'<text x="{x:.1f}" y="{height - bottom + 16}" text-anchor="middle">'
            f"{last * k / 4:.0f}</text>",
        ]
    for (_, points), color in zip(lines.items(), colors * len(lines), strict=False):
        path_text = " ".join(
            f"{left + across * n:.1f},{height - bottom - up * size:.1f}" for n, size in points
        )
        out.append(f'<polyline points="{path_text}" fill="none" stroke="{color}"/>')
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join([*out, "</svg>"]) + "\n", encoding="utf-8")
