"""Many different scenes optimized together: scenes per second and where the time goes.

python -m benchmarks.fleet --prepare prepared --scenes 1000      # needs no GPU
python -m benchmarks.fleet --prepared prepared --device cuda:0 --out benchmarks/results --name h200

The scenes are sampled from the dataset's grammar: single events, chains and several phases.
`--prepare` drafts, dresses and lays them out; the second command times what comes after that,
Newton's confirmation included, and writes NAME_fleet.json. A first, small batch with other scenes
compiles the kernels, which is timed on its own.
"""

from __future__ import annotations

import argparse
from collections import Counter
import gzip
import json
from pathlib import Path
import time
from typing import Any

from esg.dynamics.fleet.many import Clock, optimize_many
from esg.graph.models import EsgDocument

SEED = 2026
WARM_UP = 24
FILE = "fleet.jsonl.gz"


def prepare(folder: Path, count: int) -> None:
    """Writes laid-out documents of sampled scenes; those that no draft can be made of are named."""
    from esg.assets import resolve
    from esg.dataset.grammar import sample_scenes
    from esg.draft import draft
    from esg.dynamics import start_hints
    from esg.layout import solve_batch
    from esg.outcomes import UserError

    docs, hints, seeds = [], [], []
    for scene in sample_scenes(count + count // 10 + WARM_UP, SEED):
        if len(docs) == count + WARM_UP:
            break
        try:
            doc = resolve(draft(scene.prompt, seed=scene.seed), seed=scene.seed)
        except UserError as error:
            print(f"skipped: {error}")
            continue
        docs.append(doc)
        hints.append(start_hints(doc, seed=scene.seed))
        seeds.append(scene.seed)
    docs = solve_batch(docs, seeds, hints)
    folder.mkdir(parents=True, exist_ok=True)
    with gzip.open(folder / FILE, "wt") as file:
        for doc, seed in zip(docs, seeds, strict=True):
            line = {"seed": seed, "document": json.loads(doc.model_dump_json())}
            file.write(json.dumps(line) + "\n")


def load(folder: Path) -> tuple[list[EsgDocument], list[int]]:
    """The documents of a folder and their seeds."""
    with gzip.open(folder / FILE, "rt") as file:
        rows = [json.loads(line) for line in file]
    return [EsgDocument.model_validate(r["document"]) for r in rows], [r["seed"] for r in rows]


def measure(
    docs: list[EsgDocument], seeds: list[int], device: str, processes: int, repeats: int
) -> dict[str, Any]:
    """Times one batch: the last `WARM_UP` documents compile the kernels first."""
    begin = time.perf_counter()
    clock = Clock(progress=lambda launch: print(json.dumps(launch), flush=True))
    optimize_many(
        docs[-WARM_UP:], seeds[-WARM_UP:], device=device, processes=processes, clock=clock
    )
    report: dict[str, Any] = {
        "first_batch_with_kernel_compile_s": round(time.perf_counter() - begin, 2),
        "runs": [],
    }
    docs, seeds = docs[:-WARM_UP], seeds[:-WARM_UP]
    for _ in range(repeats):
        clock = Clock(progress=lambda launch: print(json.dumps(launch), flush=True))
        begin = time.perf_counter()
        results = optimize_many(docs, seeds, device=device, processes=processes, clock=clock)
        seconds = time.perf_counter() - begin
        report["runs"].append(_row(results, seconds, clock))
        short = {k: v for k, v in report["runs"][-1].items() if k not in ("launches", "waits_s")}
        print(json.dumps(short), flush=True)
    return report


def _row(results: list[EsgDocument], seconds: float, clock: Clock) -> dict[str, Any]:
    found = [r.dynamics_result for r in results]
    outcomes = Counter(r.outcome for r in found if r is not None)
    return {
        "scenes": len(results),
        "seconds": round(seconds, 3),
        "scenes_per_s": round(len(results) / seconds, 2),
        "outcomes": dict(sorted(outcomes.items())),
        "solved_share": round(outcomes.get("solved", 0) / len(results), 4),
        "stopped": dict(Counter(r.stopped for r in found if r is not None)),
        "newton_rollouts": sum(r.evaluations for r in found if r is not None),
        "surrogate_rollouts": sum(r.explored for r in found if r is not None),
        "wall_s": {k: round(v, 3) for k, v in clock.seconds.items()},
        "processor_s_beside": {k: round(v, 3) for k, v in clock.processor.items()},
        "waits_s": [round(w, 3) for w in clock.waits],
        "launches": clock.launches,
    }


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--prepare", type=Path, help="only make documents here")
    parser.add_argument("--prepared", type=Path, help="use what --prepare made")
    parser.add_argument("--scenes", type=int, default=1000)
    parser.add_argument("--device", default="cuda:0")
    parser.add_argument("--processes", type=int, default=15)
    parser.add_argument("--repeats", type=int, default=1)
    parser.add_argument("--out", type=Path, default=Path("gpu"))
    parser.add_argument("--name", default="gpu", help="how the file's name begins")
    args = parser.parse_args()
    if args.prepare:
        prepare(args.prepare, args.scenes)
        return
    folder = args.prepared or args.out / "prepared"
    if not args.prepared:
        prepare(folder, args.scenes)
    docs, seeds = load(folder)
    docs, seeds = docs[: args.scenes] + docs[-WARM_UP:], seeds[: args.scenes] + seeds[-WARM_UP:]
    report = measure(docs, seeds, args.device, args.processes, args.repeats)
    from benchmarks.gpu import _versions

    command = f"python -m benchmarks.fleet --prepared prepared --scenes {args.scenes}"
    command += f" --device {args.device} --processes {args.processes} --repeats {args.repeats}"
    command += f" --out {args.out.name} --name {args.name}"
    head = {**_versions(args.device), "command": command, "processes": args.processes}
    args.out.mkdir(parents=True, exist_ok=True)
    text = json.dumps(head | report, indent=1) + "\n"
    (args.out / f"{args.name}_fleet.json").write_text(text)


if __name__ == "__main__":
    main()
