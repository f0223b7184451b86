"""What the cores and the GPU of a machine do while `esg dataset` runs.

    python -m benchmarks.throughput.timeline --out benchmarks/results/timeline.json
        [--limit 290] -- --sample 5000 --device cuda:0 --workers 16 --out SET
    python -m benchmarks.throughput.timeline --draw benchmarks/results/timeline.json --svg FILE

Runs the real command, with all that stands behind `--`, and writes down twice a second: scenes in
batches with a mark, cores that work for searches and the command (`user`), for workers beside
searches (`nice`, as they are niced) and for the system, and the share of the half second in which
the GPU had a kernel, as `nvidia-smi` tells it. Nothing else may run on the machine.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
import contextlib
import json
import os
from pathlib import Path
import signal
import subprocess
import sys
import time

EVERY_S = 0.5
COLUMNS = ("time_s", "scenes", "user", "nice", "system", "idle", "memory_mib", "gpu_percent")
COLORS = {"gpu_percent": "#d95f02", "user": "#1f77b4", "nice": "#7fb3d8", "scenes": "#2ca02c"}


def ticks() -> list[int]:
    """Of all cores since the machine started: user, nice, system, idle, waiting, interrupts."""
    return [int(x) for x in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:8]]


def memory_mib() -> int:
    """Memory of the machine that is in use [MiB]."""
    rows = dict(row.split(":") for row in Path("/proc/meminfo").read_text().splitlines())
    total, free = (int(rows[k].split()[0]) for k in ("MemTotal", "MemAvailable"))
    return (total - free) // 1024


class Gpu:
    """The last line of a running `nvidia-smi`; None without one."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[str] | None = None
        self._last: float | None = None
        with contextlib.suppress(OSError):
            query = ["nvidia-smi", "--query-gpu=utilization.gpu", "--format=csv,noheader,nounits"]
            self._process = subprocess.Popen(
                [*query, "-lms", str(int(1000 * EVERY_S))], stdout=subprocess.PIPE, text=True
            )
            assert self._process.stdout is not None
            os.set_blocking(self._process.stdout.fileno(), False)

    def busy(self) -> float | None:
        if self._process is not None and self._process.stdout is not None:
            with contextlib.suppress(TypeError, ValueError, IndexError):
                self._last = float(self._process.stdout.read().split()[-1])
        return self._last

    def close(self) -> None:
        if self._process is not None:
            self._process.terminate()
            self._process.wait()


def watch(options: Sequence[str], limit_s: float) -> tuple[int | None, list[list[float | None]]]:
    """Runs the command; its exit code, None if it was interrupted at the limit, and the samples."""
    folder = Path(options[options.index("--out") + 1])
    start = time.monotonic()
    command = subprocess.Popen([sys.executable, "-m", "esg.cli", "dataset", *options])
    gpu, before = Gpu(), ticks()
    rows: list[list[float | None]] = []
    scenes: dict[Path, int] = {}
    late = False
    while command.poll() is None:
        time.sleep(EVERY_S)
        now = ticks()
        spent = [b - a for a, b in zip(before, now, strict=True)]
        share = (os.cpu_count() or 1) / max(1, sum(spent))
        before = now
        for mark in set((folder / "marks").glob("*.json")) - set(scenes):
            with contextlib.suppress(OSError, ValueError):
                scenes[mark] = int(json.loads(mark.read_bytes())["scenes"])
        user, nice, system, idle, waiting, *interrupts = spent
        cores = (user, nice, system + sum(interrupts), idle + waiting)
        elapsed = time.monotonic() - start
        rows.append([
            round(elapsed, 1), sum(scenes.values()), *(round(c * share, 2) for c in cores),
            memory_mib(), gpu.busy(),
        ])  # fmt: skip
        if elapsed > limit_s and not late:
            late = True
            command.send_signal(signal.SIGINT)
    gpu.close()
    return (None if late else command.returncode), rows


def facts(rows: Sequence[Sequence[float | None]]) -> dict[str, float | None]:
    """Scenes, and how busy cores and GPU were from the first kernel to the last mark."""
    times = [float(row[0] or 0.0) for row in rows]
    done = [float(row[1] or 0.0) for row in rows]
    busy = [float(row[7] or 0.0) for row in rows]
    last = max((k for k in range(1, len(rows)) if done[k] > done[k - 1]), default=len(rows) - 1)
    first = next((k for k, b in enumerate(busy) if b > 0.0), 0)
    part = rows[first : last + 1]
    return {
        "scenes": done[-1],
        "last_mark_s": times[last],
        "gpu_percent": round(sum(busy[first : last + 1]) / len(part), 1) if any(busy) else None,
        "cores_busy": round(sum(sum(float(v or 0.0) for v in r[2:5]) for r in part) / len(part), 1),
    }


def svg(rows: Sequence[Sequence[float | None]], cores: int) -> str:
    """The GPU above, the cores below, scenes with a mark over both."""
    wide, high, gap, left = 640, 90, 26, 40
    end = float(rows[-1][0] or 1.0)
    most = max(1.0, float(rows[-1][1] or 1.0))
    step = max(1, len(rows) // 200)
    kept = [
        [sum(float(r[c] or 0.0) for r in rows[k : k + step]) / len(rows[k : k + step])
         for c in range(len(COLUMNS))]
        for k in range(0, len(rows), step)
    ]  # fmt: skip

    def line(values: Sequence[float], top: int, full: float, color: str, fill: bool) -> str:
        points = [
            f"{left + wide * row[0] / end:.1f},{top + high - high * min(1.0, v / full):.1f}"
            for row, v in zip(kept, values, strict=True)
        ]
        if not fill:
            return f'<polyline points="{" ".join(points)}" fill="none" stroke="{color}"/>'
        base = f"{left + wide:.1f},{top + high} {left},{top + high}"
        return f'<polygon points="{" ".join(points)} {base}" fill="{color}"/>'

    first, second = gap, 2 * gap + high
    labels = [
        (left, first - 8, f"GPU has a kernel [%]; line: scenes with a mark, to {most:.0f}"),
        (left, second - 8, f"cores of {cores}: searches and command (dark), all else (light)"),
        *((left + wide * t / end - 8, second + high + 14, f"{t:.0f}")
          for t in range(0, int(end) + 1, 60)),
        (left + wide - 24, second + high + 24, "s"),
    ]  # fmt: skip
    user = [r[2] + r[4] for r in kept]
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide + left + 12} '
        f'{second + high + 30}" font-family="sans-serif" font-size="11">',
        '<rect width="100%" height="100%" fill="white"/>',
        line([r[7] for r in kept], first, 100.0, COLORS["gpu_percent"], True),
        line([r[1] for r in kept], first, most, COLORS["scenes"], False),
        line([u + r[3] for u, r in zip(user, kept, strict=True)], second, cores,
             COLORS["nice"], True),
        line(user, second, cores, COLORS["user"], True),
        *(f'<text x="{x:.0f}" y="{y}">{text}</text>' for x, y, text in labels),
    ]  # fmt: skip
    return "\n".join([*out, "</svg>"]) + "\n"


def main() -> None:
    mine, options = sys.argv[1:], []
    if "--" in mine:
        cut = mine.index("--")
        mine, options = mine[:cut], mine[cut + 1 :]
    parser = argparse.ArgumentParser(prog="python -m benchmarks.throughput.timeline")
    parser.add_argument("--out", type=Path, default=Path("timeline.json"))
    parser.add_argument("--limit", type=float, default=1e9, help="interrupt after so long [s]")
    parser.add_argument("--draw", type=Path, help="only draw what an earlier run wrote")
    parser.add_argument("--svg", type=Path)
    args = parser.parse_args(mine)
    if args.draw:
        told = json.loads(args.draw.read_bytes())
    else:
        code, rows = watch(options, args.limit)
        told = {
            "command": " ".join(["esg", "dataset", *options]),
            "cores": os.cpu_count(),
            "exit_code": code,
            **facts(rows),
            "columns": COLUMNS,
            "samples": rows,
        }
        args.out.write_text(json.dumps(told) + "\n")
        print(json.dumps({k: v for k, v in told.items() if k != "samples"}, indent=1))
    if args.svg:
        args.svg.write_text(svg(told["samples"], told["cores"]))


if __name__ == "__main__":
    main()
