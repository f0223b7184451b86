"""Seconds to optimize a scene, warm, by level: single events, chains, several phases.

python -m benchmarks.cost [--suites SUITE ...] [--seeds 0,1,2] [--json FILE]

Every scene is optimized twice; the second time is measured. By then the kernels are loaded, while
the reference engine's model of the scene is built anew, as for a scene that is met for the first
time. The limits are 1 s for single events, 3 s for chains and 5 s for several phases on two cores.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.lib.theta import Stopwatch, case
from esg.dynamics.strategies import optimize
from esg.engines.newton import clear_cache
from esg.metrics import load_suite

SUITES = (Path("data/suites/paper.yaml"), Path("data/suites/breadth.yaml"))
LIMIT_S = {"single": 1.0, "chain": 3.0, "multi_phase": 5.0}


def measure(suites: list[Path], seeds: list[int]) -> list[dict[str, Any]]:
    """One row per scene and seed."""
    rows: list[dict[str, Any]] = []
    for path in suites:
        suite = load_suite(path)
        for scene in suite.scenes:
            for seed in seeds:
                doc = case(scene, seed).doc
                optimize(doc, seed=seed)
                clear_cache()
                with Stopwatch() as watch:
                    result = optimize(doc, seed=seed).dynamics_result
                assert result is not None
                rows.append(
                    {
                        "suite": suite.suite, "scene": scene.id, "level": scene.level, "seed": seed,
                        "wall_s": round(watch.seconds, 3), "cpu_s": round(watch.cpu, 3),
                        "outcome": result.outcome, "stopped": result.stopped,
                        "newton": result.evaluations, "surrogate": result.explored,
                    }
                )  # fmt: skip
    return rows


def summarize(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Per suite and level: median, mean and longest, and the share within the limit."""
    out: list[dict[str, Any]] = []
    for suite in dict.fromkeys(r["suite"] for r in rows):
        for level, limit in LIMIT_S.items():
            own = [r for r in rows if r["suite"] == suite and r["level"] == level]
            if not own:
                continue
            wall, cpu = (np.array([r[k] for r in own]) for k in ("wall_s", "cpu_s"))
            slowest = own[int(wall.argmax())]
            out.append(
                {
                    "suite": suite, "level": level, "limit_s": limit, "runs": len(own),
                    "wall_median_s": float(np.median(wall)), "wall_mean_s": float(wall.mean()),
                    "wall_max_s": float(wall.max()), "within": float((wall < limit).mean()),
                    "cpu_median_s": float(np.median(cpu)), "cpu_max_s": float(cpu.max()),
                    "slowest": f"{slowest['scene']} seed {slowest['seed']}",
                }
            )  # fmt: skip
    return out


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--suites", nargs="+", type=Path, default=list(SUITES))
    parser.add_argument("--seeds", default="0,1,2")
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    rows = measure(args.suites, [int(s) for s in args.seeds.split(",")])
    summary = summarize(rows)
    print("suite     level        limit  runs  median    mean     max  within   cpu median  max")
    for s in summary:
        print(
            f"{s['suite']:<9} {s['level']:<12} {s['limit_s']:>4.0f}s {s['runs']:>5} "
            f"{s['wall_median_s']:>7.2f} {s['wall_mean_s']:>7.2f} {s['wall_max_s']:>7.2f} "
            f"{s['within']:>7.0%} {s['cpu_median_s']:>12.2f} {s['cpu_max_s']:>5.2f}  {s['slowest']}"
        )
    if args.json:
        lines = ",\n".join("  " + json.dumps(r) for r in rows)
        head = json.dumps(summary, indent=1).replace("\n", "\n ")
        args.json.write_text(f'{{\n "summary": {head},\n "runs": [\n{lines}\n ]\n}}\n')


if __name__ == "__main__":
    main()
