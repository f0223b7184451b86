"""The paper's ablation of the collision model on S6: does the bin reach the table?

python -m benchmarks.collision_model [--seeds 20] [--json FILE]

`proxy` searches with one sphere or box a body; `proxy + exact` starts from that theta and goes on
with the exact parts (the role of the paper's SDF pass); `exact` never sees the proxies. All start
from theta drawn uniformly between its bounds. PhysX at 240 steps a second plays the exact shapes.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
import json
from pathlib import Path

import numpy as np

from benchmarks.theta import case, cold, completed, panel, suite_scene
from esg.dynamics.proxies import coarse
from esg.dynamics.search import run_strategy

PAPER = {"proxy": "1/10", "proxy + exact": "8/10"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--strategy", default="hybrid", help="the search, in all variants")
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    scene = suite_scene("S6")
    wins: dict[str, list[bool]] = {"proxy": [], "proxy + exact": [], "exact": []}
    for seed in range(args.first_seed, args.first_seed + args.seeds):
        found = case(scene, seed)
        plan = cold(found.plan, np.random.default_rng([seed, 6]))

        def run(plan, seed: int = seed):  # type: ignore[no-untyped-def]
            rng = np.random.default_rng([seed, 2])
            return run_strategy(plan, panel(plan), rng, args.strategy)[0].theta

        simple = run(replace(plan, scene=coarse(plan.scene)))
        warm = tuple(
            replace(v, initial=float(t)) for v, t in zip(plan.variables, simple, strict=True)
        )
        thetas = {
            "proxy": simple,
            "proxy + exact": run(replace(plan, variables=warm)),
            "exact": run(plan),
        }
        for name, theta in thetas.items():
            wins[name].append(completed(found, theta)[1])
    print(f"S6, {args.seeds} seeds, {args.strategy}, event 2 in PhysX at 240 Hz")
    for name, won in wins.items():
        print(
            f"{name:<14} {sum(won):>3}/{len(won)}  {np.mean(won):>6.0%}   paper {PAPER.get(name)}"
        )
    if args.json:
        text = json.dumps({"strategy": args.strategy, "event_2": wins}, indent=1)
        args.json.write_text(text + "\n")


if __name__ == "__main__":
    main()
