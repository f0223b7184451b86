"""Seconds a contact sheet with its loop takes, scene by scene, in a warm process.

    python -m benchmarks.preview RUN [--threads 2] [--out preview.json]

RUN is a folder of scene folders with their replays (`rollout.npz`). Target: under 3 s a scene on
two cores. CPU time is told beside wall time, because wall time means nothing on a busy machine.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
import tempfile
import time
from typing import Any


def measure(folder: Path, threads: int, out: Path) -> dict[str, Any] | None:
    """Draws one scene; None if it was never replayed."""
    from esg.graph import load_document
    from esg.metrics import SceneVerdict
    from esg.report.replays import replays_of
    from esg.report.run import read_scene
    from esg.view import preview as previews

    entry = read_scene(folder)
    replays = replays_of(folder, entry.metrics)
    if not replays:
        return None
    verdict = SceneVerdict.from_json(entry.verdict)
    doc = load_document(folder / "esg.json")
    previews._threads = lambda: threads
    wall, cpu = time.perf_counter(), time.process_time()
    previews.preview(replays[0].scene, replays[0].rollout, verdict, doc, out)
    return {
        "scene": folder.name,
        "wall_s": round(time.perf_counter() - wall, 2),
        "cpu_s": round(time.process_time() - cpu, 2),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run", type=Path)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--out", type=Path)
    args = parser.parse_args()
    from esg.report.run import find_scenes

    scenes = find_scenes(args.run)
    with tempfile.TemporaryDirectory() as work:
        measure(scenes[0], args.threads, Path(work))  # imports and kernels
        rows = [r for s in scenes if (r := measure(s, args.threads, Path(work)))]
    result = {
        "threads": args.threads,
        "mean_wall_s": round(sum(r["wall_s"] for r in rows) / len(rows), 2),
        "worst_wall_s": max(r["wall_s"] for r in rows),
        "mean_cpu_s": round(sum(r["cpu_s"] for r in rows) / len(rows), 2),
        "scenes": rows,
    }
    text = json.dumps(result, indent=2)
    print(text)
    if args.out:
        args.out.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
