"""Optimizers at equal budgets of reference rollouts: random search, CEM, CMA-ES, FD and ours.

python -m benchmarks.optimizers [--suite FILE] [--scenes S5,S6,...] [--seeds 3] [--budget 320]

All start from the same theta, drawn uniformly between its bounds, and stop after `--budget`
rollouts of Newton at the latest; ours may also use its surrogate, whose rollouts are listed. Events
are completed in PhysX at 240 steps a second.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np

from benchmarks.theta import PAPER, Stopwatch, case, cold, completed, panel
from esg.dynamics.search import run_strategy
from esg.metrics import load_suite

METHODS = ("random", "cem", "cma", "fd", "batched")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--suite", type=Path, default=PAPER)
    parser.add_argument("--scenes", default="S3,S5,S6,S7,S9,S10")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--budget", type=int, default=320)
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    wanted = args.scenes.split(",")
    scenes = [s for s in load_suite(args.suite).scenes if s.id in wanted]
    rows: list[dict[str, object]] = []
    for scene in scenes:
        for seed in range(args.seeds):
            found = case(scene, seed)
            plan = cold(found.plan, np.random.default_rng([seed, 6]))
            for method in METHODS:
                judges = panel(plan)
                rng = np.random.default_rng([seed, 3])
                steps = max(1, args.budget // (2 * int(plan.free().sum()) + 1))
                with Stopwatch() as watch:
                    best, _ = run_strategy(
                        plan, judges, rng, method, rollouts=args.budget, steps=steps
                    )
                rows.append(
                    {
                        "scene": scene.id, "seed": seed, "method": method,
                        "loss": float(best.nominal.total[0]), "worst": best.worst,
                        "events": completed(found, best.theta), "cpu": round(watch.cpu, 2),
                        "newton": judges.evaluations, "surrogate": judges.explored,
                    }
                )  # fmt: skip
                print(rows[-1], flush=True)
    print("method    events   median loss   median worst case   newton   surrogate   cpu s")
    for method in METHODS:
        own = [r for r in rows if r["method"] == method]
        events = np.concatenate([r["events"] for r in own])  # type: ignore[arg-type]
        median = [float(np.median([r[k] for r in own])) for k in ("loss", "worst")]  # type: ignore[arg-type]
        mean = [float(np.mean([r[k] for r in own])) for k in ("newton", "surrogate", "cpu")]  # type: ignore[arg-type]
        print(
            f"{method:<9} {events.sum():>3}/{len(events):<3} {median[0]:>12.3f} {median[1]:>15.3f} "
            f"{mean[0]:>12.0f} {mean[1]:>10.0f} {mean[2]:>8.2f}"
        )
    if args.json:
        args.json.write_text(json.dumps({"budget": args.budget, "runs": rows}, indent=1) + "\n")


if __name__ == "__main__":
    main()
