"""Optimizers at equal budgets of reference rollouts: baselines, the paper's descents and ours.

python -m benchmarks.optimizers [--suite FILE] [--scenes S5,S6,...] [--seeds 5] [--budget 320]
    [--json FILE]

All start from the same theta, drawn uniformly between its bounds, and stop after `--budget`
rollouts of Newton at the latest (a judgement by the ensemble, 8 rollouts, comes on top); `ad`,
`hybrid` and ours may also use the surrogate, whose rollouts are listed. Events are completed in
PhysX at 240 steps a second. `--merge FILE ...` prints one table of several JSON files, which are
written after every seed.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.lib.theta import PAPER, Stopwatch, case, cold, completed, panel
from esg.dynamics.strategies import run_strategy
from esg.metrics import load_suite
from esg.metrics.models import SuiteScene

METHODS = ("random", "cem", "cma", "ad", "fd", "hybrid", "batched")


Row = dict[str, Any]


def run(scene: SuiteScene, seed: int, methods: tuple[str, ...], budget: int) -> list[Row]:
    """One row a method for one scene and seed."""
    found = case(scene, seed)
    plan = cold(found.plan, np.random.default_rng([seed, 6]))
    rows: list[Row] = []
    for method in methods:
        judges = panel(plan)
        rng = np.random.default_rng([seed, 3])
        steps = max(1, budget // (2 * int(plan.free().sum()) + 1))
        with Stopwatch() as watch:
            best, _ = run_strategy(plan, judges, rng, method, rollouts=budget, steps=steps)
        rows.append(
            {
                "scene": scene.id, "seed": seed, "method": method,
                "loss": float(best.nominal.total[0]), "worst": best.worst,
                "events": completed(found, best.theta), "cpu": round(watch.cpu, 2),
                "newton": judges.evaluations, "surrogate": judges.explored,
            }
        )  # fmt: skip
        print(rows[-1], flush=True)
    return rows


def report(rows: list[Row]) -> str:
    """The table over all scenes and seeds."""
    lines = [
        "method    events   median loss   median worst case   newton   surrogate   median cpu s"
    ]
    for method in METHODS:
        own = [r for r in rows if r["method"] == method]
        if not own:
            continue
        events = np.concatenate([r["events"] for r in own])
        loss, worst, cpu = (float(np.median([r[k] for r in own])) for k in ("loss", "worst", "cpu"))
        newton, surrogate = (float(np.mean([r[k] for r in own])) for k in ("newton", "surrogate"))
        lines.append(
            f"{method:<9} {events.sum():>3}/{len(events):<3} {loss:>12.3f} {worst:>15.3f} "
            f"{newton:>12.0f} {surrogate:>10.0f} {cpu:>10.2f}"
        )
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--suite", type=Path, default=PAPER)
    parser.add_argument("--scenes", default="S3,S5,S6,S7,S9,S10")
    parser.add_argument("--methods", default=",".join(METHODS))
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--budget", type=int, default=320)
    parser.add_argument("--merge", type=Path, nargs="+")
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    rows: list[Row] = []
    budget = args.budget

    def write() -> None:
        if args.json:
            lines = ",\n".join(f"  {json.dumps(r)}" for r in rows)
            head = f' "suite": {json.dumps(args.suite.stem)},\n "budget": {budget},\n'
            args.json.write_text(f'{{\n{head} "runs": [\n{lines}\n ]\n}}\n')

    if args.merge:
        parts = [json.loads(p.read_text()) for p in args.merge]
        if len({(p["suite"], p["budget"]) for p in parts}) > 1:
            parser.error("the files differ in suite or budget")
        budget = parts[0]["budget"]
        rows = [r for p in parts for r in p["runs"]]
    else:
        wanted = args.scenes.split(",")
        scenes = [s for s in load_suite(args.suite).scenes if s.id in wanted]
        for seed in range(args.first_seed, args.first_seed + args.seeds):
            for scene in scenes:
                rows += run(scene, seed, tuple(args.methods.split(",")), budget)
                write()
    write()
    print(report(rows))


if __name__ == "__main__":
    main()
