"""Long rows of hits, dominoes and many pairs: how often they are solved, and processor seconds.

python -m benchmarks.rows --seeds 10 --json benchmarks/results/rows.json

One process, one thread, kernels loaded by a first scene. Seconds are those of the search alone.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
from pathlib import Path
import statistics
import time
from typing import Any

from benchmarks.scaling import ACTORS, CHAIN, TARGETS

LETTERS = "ABCDEFGHIJK"


def prompts() -> dict[str, str]:
    """What is searched, by name."""
    pairs = [f"A {a} rolls into a {b}." for a, b in zip(ACTORS, TARGETS, strict=True)]
    unequal = f"A {CHAIN[0]} hits a " + ", which then hits a ".join(CHAIN[1:8]) + "."
    return {
        "3 hits, balls": _row("ball", 3),
        "7 hits, balls": _row("ball", 7),
        "10 hits, balls": _row("ball", 10),
        "7 hits, unequal balls": unequal,
        "7 hits, crates": _row("crate", 7),
        "10 hits, crates": _row("crate", 10),
        "10 dominoes, all": "Ten dominoes stand in a row. The first one topples and knocks over "
        "the others.",
        "10 dominoes, a ball": "A ball rolls into a row of ten dominoes and the last one falls.",
        "1 pair": pairs[0],
        "8 pairs": " ".join(pairs[:8]),
    }


def _row(thing: str, hits: int) -> str:
    pairs = itertools.pairwise(LETTERS[: hits + 1])
    told = ", then ".join(f"{thing} {a} hits {thing} {b}" for a, b in pairs)
    return told[0].upper() + told[1:] + "."


def measure(prompt: str, seeds: range) -> dict[str, Any]:
    """Searches a prompt with every seed."""
    from esg.assets import resolve
    from esg.draft import draft
    from esg.dynamics import start_hints
    from esg.dynamics.casting import fitted
    from esg.dynamics.strategies import optimize
    from esg.layout import solve_batch

    found: list[str] = []
    seconds: list[float] = []
    robust = 0
    for seed in seeds:
        doc = fitted(resolve(draft(prompt, seed=seed), seed=seed))
        doc = solve_batch([doc], [seed], [start_hints(doc, seed=seed)])[0]
        begin = time.process_time()
        result = optimize(doc, seed=seed).dynamics_result
        seconds.append(time.process_time() - begin)
        assert result is not None
        found.append(result.outcome)
        robust += result.stopped == "robust"
    return {
        "solved": found.count("solved"),
        "robust": robust,
        "seeds": len(found),
        "median_cpu_s": round(statistics.median(seconds), 2),
        "longest_cpu_s": round(max(seconds), 2),
    }


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--only", nargs="+", choices=tuple(prompts()), default=list(prompts()))
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    os.environ |= {"ESG_THREADS": "1", "OMP_NUM_THREADS": "1"}
    measure("A football rolls into a trash bin.", range(1))
    kept = json.loads(args.json.read_text()) if args.json and args.json.exists() else {}
    for name in args.only:
        kept[name] = measure(prompts()[name], range(args.seeds))
        print(name, json.dumps(kept[name]), flush=True)
        if args.json:
            args.json.write_text(json.dumps(kept, indent=1) + "\n")


if __name__ == "__main__":
    main()
