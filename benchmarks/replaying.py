"""What it costs to replay compiled classes, here and in another checkout.

    python -m benchmarks.replaying SCENE… [--against CHECKOUT] [--times 5]

Processor seconds of `replay_class` and of the child process in which the class runs: the least of
so many replays of each finished scene, its class compiled before. The checkouts take turns, twice.
"""

from __future__ import annotations

import argparse
import json
import os
from pathlib import Path
import subprocess
import sys

HERE = Path(__file__).parents[1]
CHILD = """
import json, resource, sys
from esg.compile.replay import replay_class

def spent():
    uses = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(use.ru_utime + use.ru_stime for use in uses)

def once(folder):
    start = spent()
    replay_class(folder)
    return spent() - start

times, *folders = sys.argv[1:]
for folder in folders:
    replay_class(folder)
print(json.dumps([min(once(f) for _ in range(int(times))) for f in folders]))
"""


def measured(checkout: Path, scenes: list[Path], times: int) -> list[float]:
    """Processor seconds of each scene, in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-c", CHILD, str(times), *map(str, scenes)],
        env=os.environ | {"PYTHONPATH": str(checkout)},
        cwd=checkout,
        stdout=subprocess.PIPE,
        check=True,
    )
    return json.loads(done.stdout.splitlines()[-1])


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("scenes", nargs="+", type=Path, metavar="SCENE")
    parser.add_argument("--against", type=Path, help="a checkout of another commit")
    parser.add_argument("--times", type=int, default=5)
    args = parser.parse_args()
    scenes = [scene.resolve() for scene in args.scenes]
    trees = [HERE, *([args.against.resolve()] if args.against else [])]
    best: dict[Path, list[float]] = {}
    for _ in range(2):
        for tree in trees:
            now = measured(tree, scenes, args.times)
            best[tree] = [min(pair) for pair in zip(best.get(tree, now), now, strict=True)]
    for k, scene in enumerate(scenes):
        line = "  ".join(f"{best[tree][k]:.3f} s" for tree in trees)
        ratio = f"  ratio {best[HERE][k] / best[trees[1]][k]:.2f}" if args.against else ""
        print(f"{scene.name}: {line}{ratio}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
