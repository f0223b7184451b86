"""How many frames of clips a machine writes an hour, and how much memory that takes.

    python -m benchmarks.clip_rate [--scenes 2000] [--minutes 10] [--workers 15] [--device cuda:0]
        [--render rgb,depth,segmentation] [--size 256x256] [--cameras 1] [--batch 8]
        [--of FOLDER] [--warm FOLDER] [--json FILE] [--plot FILE.svg]

The real command, `esg render DATASET`, for so many minutes or until all is rendered. The dataset is
made before (untimed, its physics as first guessed: pictures cost the same) unless `--of` has one;
a first small one, made or given by `--warm`, makes what is made once a machine. A frame is one
instant seen by one camera in all channels; those of scenes that are whole on disk count, over the
wall clock from the command's start to its end. Memory is that of every worker, and its slope over
the scenes once a tenth of them is rendered.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
import contextlib
import json
import os
from pathlib import Path
import statistics
import subprocess
import sys
import tempfile
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("ESG_THREADS", "1")

from benchmarks.throughput.wall import Watch, plot
from esg.dataset.clips.adding import SCAFFOLD
from esg.dataset.folder import DatasetFolder
from esg.store.tables import part_files, read_table

ESG = (sys.executable, "-m", "esg.cli")


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--scenes", type=int, default=2000)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--workers", type=int, default=max(1, (os.cpu_count() or 2) - 1))
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--render", default="rgb,depth,segmentation")
    parser.add_argument("--size", default="256x256")
    parser.add_argument("--fps", default="24")
    parser.add_argument("--cameras", default="1")
    parser.add_argument("--batch", default="8")
    parser.add_argument("--of", type=Path, help="a finished dataset, or where to keep the new one")
    parser.add_argument("--warm", type=Path, help="a finished small dataset, rendered first")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--plot", type=Path)
    args = parser.parse_args()
    options = [
        *("--channels", args.render, "--size", args.size, "--fps", args.fps),
        *("--cameras", args.cameras, "--device", args.device),
    ]
    with contextlib.ExitStack() as stack:
        folder = args.of or Path(stack.enter_context(tempfile.TemporaryDirectory())) / "set"
        if not DatasetFolder(folder).finished():
            made_dataset(folder, args.scenes, args.workers)
        warm = args.warm
        if warm is None:
            warm = Path(stack.enter_context(tempfile.TemporaryDirectory())) / "warm"
            made_dataset(warm, 1, 1)
        subprocess.run([*ESG, "render", str(warm), *options], check=True)
        watch = Watch(folder / SCAFFOLD)
        command = [
            *(*ESG, "render", str(folder), *options, "--resume"),
            *("--workers", str(args.workers), "--batch", args.batch),
        ]
        code = watch.run(command, dict(os.environ), limit_s=60 * args.minutes)
        if code not in (0, 3, None):
            return code
        out = told(folder, watch, args) | {"command": ["esg", *command[len(ESG) :]]}
    text = json.dumps(out, indent=2)
    print(text)
    if args.json:
        args.json.write_text(text + "\n")
    if args.plot:
        plot(watch, args.plot)
    return 0


def made_dataset(out: Path, scenes: int, workers: int) -> None:
    """Makes a dataset without clips; some of its scenes may fail."""
    command = [
        *(*ESG, "dataset", "--sample", str(scenes), "--strategy", "none", "--previews", "none"),
        *("--annotations", "none", "--no-meshes", "--workers", str(workers), "--out", str(out)),
    ]
    if subprocess.run([*command, "--resume"], check=False).returncode not in (0, 3):
        raise SystemExit(f"{out} could not be made")


def told(folder: Path, watch: Watch, args: argparse.Namespace) -> dict[str, Any]:
    """Frames an hour, memory, and what the processors did."""
    frames, scenes = rendered(folder)
    memory = watch.memory(warm=max(1, scenes // 10))
    slopes = [m["slope_mib_per_1000_scenes"] for m in memory]
    known = [s for s in slopes if s is not None]
    cpu = watch.cpu_by_role()
    return {
        "device": args.device,
        "cores": os.cpu_count(),
        "wall_s": round(watch.wall_s, 1),
        "scenes": scenes,
        "frames": frames,
        "frames_an_hour": round(frames / watch.wall_s * 3600),
        "cpu_s": cpu,
        "cores_busy": round(sum(cpu.values()) / watch.wall_s, 1),
        "workers": args.workers,
        "worker_processes": len(memory),
        "slope_mib_per_1000_scenes": {
            "median": round(statistics.median(known), 2) if known else None,
            "highest": max(known, default=None),
        },
        "memory": memory,
    }


def rendered(folder: Path) -> tuple[int, int]:
    """Frames and scenes whose clips are whole, of batches under way too."""
    keys: dict[str, int] = {}
    for path in _tables(folder):
        for row in read_table(path, ["scene_id", "n_frames", "camera"]).to_pylist():
            keys[f"{row['scene_id']}/{row['camera']}"] = int(row["n_frames"])
    return sum(keys.values()), len({key.partition("/")[0] for key in keys})


def _tables(folder: Path) -> Iterator[Path]:
    scaffold = folder / SCAFFOLD
    if not scaffold.is_dir():
        yield from part_files(folder, "clips")
        return
    yield from part_files(scaffold / "parts", "clips")
    yield from sorted(scaffold.glob("work/*/clips/*.parquet"))


if __name__ == "__main__":
    sys.exit(main())
