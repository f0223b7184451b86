"""The paper's ablation of the gradient strategy on S6 (car, trash bin, picnic table).

python -m benchmarks.gradient_strategy [--seeds 20] [--start cold|choreographed] [--json FILE]

AD-only, FD-only and hybrid against ours: events completed in PhysX at 240 steps a second and
seconds a scene, warm, beside the paper's. A cold start draws theta uniformly between its bounds,
the same draw for all strategies; the choreographed one is where the pipeline starts.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np

from benchmarks.lib.theta import Stopwatch, case, cold, completed, panel, suite_scene
from esg.dynamics.strategies import run_strategy

PAPER = {"ad": (5, 0, 35.2), "fd": (5, 4, 153.5), "hybrid": (5, 4, 101.3)}
STRATEGIES = ("ad", "fd", "hybrid", "batched")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--start", choices=("cold", "choreographed"), default="cold")
    parser.add_argument("--strategies", default=",".join(STRATEGIES))
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    scene = suite_scene("S6")
    rows: list[dict[str, object]] = []
    for seed in range(args.first_seed, args.first_seed + args.seeds):
        found = case(scene, seed)
        plan = found.plan
        if args.start == "cold":
            plan = cold(plan, np.random.default_rng([seed, 6]))
        for strategy in args.strategies.split(","):
            judges = panel(plan)
            # The models are built and the kernels loaded before the clock starts.
            judges.reference.assess(np.repeat(plan.initial()[None], 8, axis=0))
            rng = np.random.default_rng([seed, 1])
            with Stopwatch() as watch:
                best, stopped = run_strategy(plan, judges, rng, strategy)
            events = completed(found, best.theta)
            rows.append(
                {
                    "strategy": strategy, "seed": seed, "events": events,
                    "seconds": round(watch.seconds, 3), "cpu": round(watch.cpu, 3),
                    "newton": judges.evaluations - 8, "surrogate": judges.explored,
                    "stopped": stopped,
                }
            )  # fmt: skip
    summary = [_summary(rows, s) for s in args.strategies.split(",")]
    print(f"S6, {args.seeds} seeds, {args.start} start; PhysX at 240 Hz judges")
    print("strategy   event 1   event 2   completion   seconds   paper: ev. 1, ev. 2, seconds")
    for s in summary:
        paper = PAPER.get(str(s["strategy"]))
        beside = f"{paper[0]}/5, {paper[1]}/5, {paper[2]}" if paper else "-"
        print(
            f"{s['strategy']:<10} {s['event_1']:>5}/{args.seeds} {s['event_2']:>6}/{args.seeds} "
            f"{s['completion']:>10.1%} {s['seconds']:>9.2f}   {beside}"
        )
    if args.json:
        result = {"scene": "S6", "start": args.start, "summary": summary, "runs": rows}
        args.json.write_text(json.dumps(result, indent=1) + "\n")


def _summary(rows: list[dict[str, object]], strategy: str) -> dict[str, object]:
    own = [r for r in rows if r["strategy"] == strategy]
    events = np.array([r["events"] for r in own], bool)
    return {
        "strategy": strategy,
        "event_1": int(events[:, 0].sum()),
        "event_2": int(events[:, 1].sum()),
        "completion": float(events.mean()),
        "seconds": float(np.mean([r["seconds"] for r in own])),  # type: ignore[arg-type]
        "cpu_seconds": float(np.mean([r["cpu"] for r in own])),  # type: ignore[arg-type]
        "newton_rollouts": float(np.mean([r["newton"] for r in own])),  # type: ignore[arg-type]
    }


if __name__ == "__main__":
    main()
