"""Time and memory of the optimizer against bodies, events and candidates.

python -m benchmarks.scaling --out benchmarks/results      # writes scaling_cpu.json
python -m benchmarks.scaling --plot benchmarks/results/scaling_cpu.json docs/images/scaling.png

On a GPU's machine, with documents that were made elsewhere:

python -m benchmarks.scaling --prepare prepared            # needs no GPU
python -m benchmarks.scaling --prepared prepared --device cuda:0 --out out

writes scaling_cuda.json. With --sweeps only some are measured; what the file has of others stays.

| sweep | what grows |
| --- | --- |
| bystanders | bodies that stand around while a football rolls into a bin |
| pairs | balls that each roll into something of their own: bodies and events |
| chain | balls that pass a push on: bodies and events that depend on each other |
| candidates | thetas that the surrogate plays at first, each with the whole ensemble |

On the CPU every point is one scene in a process of its own with one thread: processor seconds of a
whole optimization with loaded kernels, and the largest resident set. On a GPU every point is a
batch of 32 seeds of the scene (one for candidates), and memory is what the device's pool held at
most so far.
"""

from __future__ import annotations

import argparse
from collections.abc import Collection, Iterator
from dataclasses import dataclass
import gzip
import json
import math
import os
from pathlib import Path
import platform
import resource
import subprocess
import sys
import time
from typing import Any

from esg.graph.models import EsgDocument

FILE = "scaling.jsonl.gz"
BATCH = 32
ACTORS = (
    "ball", "football", "basketball", "volleyball", "tennis ball", "bowling ball", "baseball",
    "cart", "skateboard", "toy car", "golf ball", "melon", "orange", "wheel", "apple",
)  # fmt: skip
TARGETS = (
    "crate", "box", "bin", "chair", "bucket", "barrel", "vase", "cone", "suitcase", "lamp",
    "bottle", "stool", "cup", "table", "can",
)  # fmt: skip
CHAIN = ("bowling ball", "melon", "basketball", "football", "volleyball", "baseball",
         "orange", "tennis ball", "golf ball")  # fmt: skip
BYSTANDERS = ("chair", "table", "crate", "barrel", "suitcase", "bucket")
COUNTS = ("", "one", "two", "three", "four", "five")
BODIES = (2, 3, 5, 10, 15, 20, 30)
PAIRS = (1, 2, 4, 6, 8, 15)
HITS = (1, 2, 3, 4, 5, 6, 7, 8)
CANDIDATES = (64, 256, 1024, 4096)


@dataclass(frozen=True)
class Point:
    """One measurement.

    Args:
        sweep: What grows.
        bodies: That collide.
        events: Of the timeline.
        candidates: At the start of the search; 0 for as many as usual.
        doc: Laid out.
    """

    sweep: str
    bodies: int
    events: int
    candidates: int
    doc: EsgDocument


def prompts() -> list[tuple[str, int, str]]:
    """Sweep, candidates and prompt of every point."""
    around = [("bystanders", 0, "A football rolls into a trash bin." + _crowd(n)) for n in BODIES]
    meetings = [f"A {a} rolls into a {b}." for a, b in zip(ACTORS, TARGETS, strict=True)]
    pairs = [("pairs", 0, " ".join(meetings[:n])) for n in PAIRS]
    chains = [
        ("chain", 0, f"A {CHAIN[0]} hits a "
         + ", which then hits a ".join(CHAIN[1 : n + 1]) + ".")
        for n in HITS
    ]  # fmt: skip
    many = [("candidates", n, "A football rolls into a trash bin.") for n in CANDIDATES]
    return around + pairs + chains + many


def _crowd(bodies: int) -> str:
    n = bodies - 2
    kinds = len(BYSTANDERS)
    share = [n // kinds + (k < n % kinds) for k in range(kinds)]
    words = [
        f"{COUNTS[c]} {name}{'s' if c > 1 else ''}"
        for c, name in zip(share, BYSTANDERS, strict=True)
        if c
    ]
    return f" {', '.join(words).capitalize()} stand nearby." if words else ""


def prepare(folder: Path) -> None:
    """Writes the laid-out documents of all points."""
    from esg.assets import resolve
    from esg.draft import draft
    from esg.dynamics import start_hints
    from esg.dynamics.casting import fitted
    from esg.layout import solve_batch

    rows = prompts()
    docs = [fitted(resolve(draft(text, seed=0), seed=0)) for _, _, text in rows]
    hints = [start_hints(d, seed=0) for d in docs]
    docs = solve_batch(docs, [0] * len(docs), hints)
    folder.mkdir(parents=True, exist_ok=True)
    with gzip.open(folder / FILE, "wt") as file:
        for (sweep, candidates, _), doc in zip(rows, docs, strict=True):
            document = json.loads(doc.model_dump_json())
            row = {"sweep": sweep, "candidates": candidates, "document": document}
            file.write(json.dumps(row) + "\n")


def load(folder: Path, only: Collection[int] | None = None) -> list[Point]:
    """The points that `prepare` wrote, in order; some of them if `only` gives their numbers."""
    from esg.dynamics.plan.build import build_scene
    from esg.dynamics.plan.planner import make_plan

    out = []
    with gzip.open(folder / FILE, "rt") as file:
        for number, line in enumerate(file):
            if only is not None and number not in only:
                continue
            row = json.loads(line)
            doc = EsgDocument.model_validate(row["document"])
            scene = build_scene(doc)
            story = make_plan(doc, scene, seed=0).story
            events = sum(
                n.event.value not in ("SceneStart", "Trigger") for n in story.nodes.values()
            )
            bodies = sum(b.collides for b in scene.bodies)
            out.append(Point(row["sweep"], bodies, events, row["candidates"], doc))
    return out


# -- CPU -------------------------------------------------------------------------------------------


def measure_point(first: Point, point: Point) -> dict[str, Any]:
    """Optimizes one scene after a first one has loaded the kernels."""
    from esg.dynamics.search import batched
    from esg.dynamics.strategies import optimize

    optimize(first.doc, seed=0)
    if point.candidates:
        batched.STARTS = point.candidates
    begin, wall = time.process_time(), time.perf_counter()
    out = optimize(point.doc, seed=1)
    cpu, wall = time.process_time() - begin, time.perf_counter() - wall
    # The largest set this process ever had, in KiB on Linux.
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return _row(point, [out]) | {
        "cpu_s": round(cpu, 3),
        "wall_s": round(wall, 3),
        "peak_rss_mib": round(peak, 1),
    }


def _row(point: Point, results: list[EsgDocument]) -> dict[str, Any]:
    found = [r.dynamics_result for r in results if r.dynamics_result is not None]
    return {
        "sweep": point.sweep,
        "bodies": point.bodies,
        "events": point.events,
        "candidates": point.candidates or None,
        "variables": len(found[0].parameters),
        "duration_s": found[0].duration_s,
        "solved": sum(r.outcome == "solved" for r in found),
        "scenes": len(found),
        "newton_rollouts": sum(r.evaluations for r in found),
        "surrogate_rollouts": sum(r.explored for r in found),
    }


def on_cpu(folder: Path, sweeps: list[str]) -> Iterator[dict[str, Any]]:
    """Every point in a fresh process; kernels that a first run compiled are loaded from a cache."""
    points = load(folder)
    env = {**os.environ, "ESG_THREADS": "1", "OMP_NUM_THREADS": "1"}
    for k, point in enumerate(points):
        if point.sweep not in sweeps:
            continue
        command = [sys.executable, "-m", "benchmarks.scaling", "--prepared", str(folder)]
        # The solver's kernels are compiled for the size of a scene: a first run does that. The
        # scene of the candidates is the first point's, which every process starts with.
        for _ in range(1 if point.candidates else 2):
            done = subprocess.run([*command, "--point", str(k)], env=env, capture_output=True)
            if done.returncode:
                raise RuntimeError(done.stderr.decode())
        yield json.loads(done.stdout.decode().splitlines()[-1])


# -- GPU -------------------------------------------------------------------------------------------


def on_gpu(
    folder: Path, sweeps: list[str], device: str, processes: int
) -> Iterator[dict[str, Any]]:
    """Batches of seeds of every point, after one seed of each has compiled the kernels."""
    points = [p for p in load(folder) if p.sweep in sweeps]
    begin = time.perf_counter()
    for point in points:
        if not point.candidates:
            _batch(point, device, processes, 1)
    print(json.dumps({"all_points_with_kernel_compile_s": time.perf_counter() - begin}), flush=True)
    for point in points:
        yield _batch(point, device, processes)


def _batch(point: Point, device: str, processes: int, seeds: int = BATCH) -> dict[str, Any]:
    import warp as wp

    from esg.dynamics.fleet.many import optimize_many
    from esg.dynamics.search import batched

    usual, n = batched.STARTS, 1 if point.candidates else seeds
    batched.STARTS = point.candidates or usual
    begin = time.perf_counter()
    try:
        results = optimize_many([point.doc] * n, range(n), device=device, processes=processes)
    finally:
        batched.STARTS = usual
    seconds = time.perf_counter() - begin
    row = _row(point, results) | {"wall_s": round(seconds, 3)}
    row["wall_s_per_scene"] = round(seconds / n, 4)
    if device != "cpu":
        row["pool_high_mib"] = round(wp.get_mempool_used_mem_high(device) / 2**20, 1)
    return row


# -- pictures --------------------------------------------------------------------------------------

COLOURS = {"bystanders": (31, 119, 180), "pairs": (214, 39, 40), "chain": (44, 160, 44),
           "candidates": (148, 103, 189)}  # fmt: skip
PANELS = (
    ("bodies", ("bystanders", "pairs", "chain")),
    ("events", ("pairs", "chain")),
    ("candidates", ("candidates",)),
)
WIDTH, HEIGHT, MARGIN = 460, 330, 62


def plot(rows: list[dict[str, Any]], path: Path) -> None:
    """Seconds (above) and memory (below) against bodies, events and candidates, on log scales."""
    from PIL import Image, ImageDraw, ImageFont

    time_key = "cpu_s" if "cpu_s" in rows[0] else "wall_s"
    memory_key = "peak_rss_mib" if "peak_rss_mib" in rows[0] else "pool_high_mib"
    labels = {"cpu_s": "processor seconds a scene", "wall_s": f"seconds for {BATCH} scenes",
              "peak_rss_mib": "peak memory, MiB", "pool_high_mib": "GPU memory, MiB"}  # fmt: skip
    image = Image.new("RGB", (len(PANELS) * WIDTH, 2 * HEIGHT), "white")
    draw, font = ImageDraw.Draw(image), ImageFont.load_default(14)
    for line, key in enumerate((time_key, memory_key)):
        values = [r[key] for r in rows if r.get(key)]
        for column, (x_key, sweeps) in enumerate(PANELS):
            own = [r for r in rows if r["sweep"] in sweeps and r.get(key)]
            if not own:
                continue
            axes = _Axes(column * WIDTH, line * HEIGHT, [r[x_key] for r in own], values)
            axes.frame(draw, font, x_key, labels[key])
            for number, sweep in enumerate(sweeps):
                points = sorted((r[x_key], r[key]) for r in own if r["sweep"] == sweep)
                at = [axes.at(*p) for p in points]
                colour = COLOURS[sweep]
                draw.line(at, fill=colour, width=2)
                for x, y in at:
                    draw.ellipse((x - 3, y - 3, x + 3, y + 3), fill=colour)
                place = (column * WIDTH + MARGIN + 10, line * HEIGHT + 22 + 17 * number)
                draw.text(place, sweep, fill=colour, font=font)
    path.parent.mkdir(parents=True, exist_ok=True)
    image.save(path, optimize=True)


class _Axes:
    """Logarithmic axes of a panel whose upper left corner is given in pixels."""

    def __init__(self, left: int, top: int, x: list[float], y: list[float]) -> None:
        self.left, self.top = left + MARGIN, top + 18
        self.right, self.bottom = left + WIDTH - 14, top + HEIGHT - 44
        self.x = (math.log10(min(x) / 1.1), math.log10(max(x) * 1.1))
        self.y = (math.log10(min(y) / 1.2), math.log10(max(y) * 2.0))
        self.x_values = sorted(set(x))

    def at(self, x: float, y: float) -> tuple[float, float]:
        u = (math.log10(x) - self.x[0]) / (self.x[1] - self.x[0])
        v = (math.log10(y) - self.y[0]) / (self.y[1] - self.y[0])
        return (
            self.left + u * (self.right - self.left),
            self.bottom - v * (self.bottom - self.top),
        )

    def frame(self, draw: Any, font: Any, x_label: str, y_label: str) -> None:
        draw.rectangle((self.left, self.top, self.right, self.bottom), outline=(120, 120, 120))
        last = -math.inf
        for x in self.x_values:
            place = self.at(x, 10 ** self.y[0])[0]
            draw.line((place, self.bottom, place, self.bottom + 4), fill=(120, 120, 120))
            if place - last > 26:
                draw.text((place, self.bottom + 5), f"{x:g}", fill="black", font=font, anchor="ma")
                last = place
        for power in range(math.floor(self.y[0]), math.ceil(self.y[1]) + 1):
            for factor in (1, 2, 5):
                value = factor * 10.0**power
                if not self.y[0] <= math.log10(value) <= self.y[1]:
                    continue
                y = self.at(10 ** self.x[0], value)[1]
                draw.line((self.left, y, self.right, y), fill=(225, 225, 225))
                draw.text((self.left - 5, y), f"{value:g}", fill="black", font=font, anchor="rm")
        middle = (self.left + self.right) / 2
        draw.text((middle, self.bottom + 22), x_label, fill="black", font=font, anchor="ma")
        draw.text((middle, self.top - 16), y_label, fill="black", font=font, anchor="ma")


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--prepare", type=Path, help="only make documents here")
    parser.add_argument("--prepared", type=Path, help="use what --prepare made")
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--processes", type=int, default=8, help="beside a GPU")
    parser.add_argument("--sweeps", nargs="+", choices=tuple(COLOURS), default=list(COLOURS))
    parser.add_argument("--out", type=Path, default=Path("runs/scaling"))
    parser.add_argument("--name", default="scaling", help="how the file's name begins")
    parser.add_argument("--plot", type=Path, nargs=2, metavar=("JSON", "PNG"))
    parser.add_argument("--point", type=int, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.plot:
        plot(json.loads(args.plot[0].read_text())["points"], args.plot[1])
        return
    if args.prepare:
        prepare(args.prepare)
        return
    folder = args.prepared or args.out / "prepared"
    if not args.prepared:
        prepare(folder)
    if args.point is not None:
        points = load(folder, {0, args.point})
        print(json.dumps(measure_point(points[0], points[-1])))
        return
    cpu = args.device == "cpu"
    from benchmarks.gpu import _versions

    kind = "cpu" if cpu else "cuda"
    head = {**_versions(args.device), "machine": platform.machine()}
    head["command"] = "python -m benchmarks.scaling" + ("" if cpu else f" --device {args.device}")
    args.out.mkdir(parents=True, exist_ok=True)
    file = args.out / f"{args.name}_{kind}.json"
    # Long sweeps may be measured one by one, and a run that ends early keeps what it has.
    rows = json.loads(file.read_text())["points"] if file.exists() else []
    rows = [r for r in rows if r["sweep"] not in args.sweeps]
    new = (
        on_cpu(folder, args.sweeps)
        if cpu
        else on_gpu(folder, args.sweeps, args.device, args.processes)
    )
    for row in new:
        rows.append(row)
        print(json.dumps(row), flush=True)
        lines = ",\n".join("  " + json.dumps(r) for r in rows)
        file.write_text(json.dumps(head, indent=1)[:-2] + f',\n "points": [\n{lines}\n ]\n}}\n')


if __name__ == "__main__":
    main()
