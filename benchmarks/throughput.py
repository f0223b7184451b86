"""How many verified scenes an hour one core makes, and where the time goes.

    python -m benchmarks.throughput [--scenes 60] [--seed 0] [--levels single chain] [--profile]

Makes the batches of a sampled dataset one after the other in this process, warm (a first batch of
another seed is not counted), and reports CPU seconds by stage: CPU time, because a wall clock says
little on a machine that does other work. A machine makes as many times more as it has cores.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
import os
from pathlib import Path
import resource
import tempfile
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("ESG_THREADS", "1")

from esg.dataset import batch as batches
from esg.dataset.batch import BatchJob, BatchResult, make_batch
from esg.dataset.finish import finish
from esg.dataset.folder import DatasetFolder
from esg.dataset.grammar import Distribution
from esg.dataset.plan import DatasetSpec, plan_scenes


def cpu_s() -> float:
    """CPU time of this process and its children [s]."""
    child = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + child.ru_utime + child.ru_stime


def memory_mib() -> float:
    """Resident memory of this process [MiB]."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


class Meter:
    """CPU seconds by stage, everything else counted as overhead."""

    def __init__(self) -> None:
        self.spent: dict[str, float] = defaultdict(float)
        self._stage, self._together = batches._stage, batches._compile_together

    def install(self) -> None:
        def stage(job, name, state, index):  # type: ignore[no-untyped-def]  # wraps another
            start = cpu_s()
            try:
                return self._stage(job, name, state, index)
            finally:
                self.spent[name] += cpu_s() - start

        def together(states):  # type: ignore[no-untyped-def]  # wraps another
            start = cpu_s()
            self._together(states)
            self.spent["replay"] += cpu_s() - start

        batches._stage, batches._compile_together = stage, together


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--levels", nargs="+", default=["single", "chain"])
    parser.add_argument("--profile", action="store_true", help="print a profile of the functions")
    args = parser.parse_args()
    mix = Distribution(levels={level: 1.0 for level in args.levels})
    meter = Meter()
    with tempfile.TemporaryDirectory() as name:
        make(Path(name) / "warm", DatasetSpec(source="sample", n=6, seed=991, distribution=mix))
        meter.install()
        print(f"warm; resident memory {memory_mib():.0f} MiB")
        spec = DatasetSpec(
            source="sample", n=args.scenes, seed=args.seed, distribution=mix, previews="none"
        )
        start, wall = cpu_s(), time.perf_counter()
        if args.profile:
            import cProfile
            import pstats

            profile = cProfile.Profile()
            results = profile.runcall(make, Path(name) / "set", spec)
            pstats.Stats(profile).sort_stats("tottime").print_stats(35)
        else:
            results = make(Path(name) / "set", spec)
        report(results, meter.spent, cpu_s() - start, time.perf_counter() - wall)


def make(out: Path, spec: DatasetSpec) -> list[BatchResult]:
    """A whole dataset in this process."""
    folder = DatasetFolder(out)
    run = folder.begin(spec, [], resume=False)
    scenes, size = plan_scenes(spec), spec.batch_size
    results: list[BatchResult] = []
    for n in range(spec.n_batches):
        chosen = tuple(scenes[n * size : (n + 1) * size])
        results.append(make_batch(BatchJob(n, spec, run, chosen, out, out / f"work{n}")))
        print(f"{(n + 1) * size} scenes, resident memory {memory_mib():.0f} MiB", flush=True)
    finish(folder, spec, {r.number: r for r in results})
    return results


def report(results: list[BatchResult], spent: dict[str, float], cpu: float, wall: float) -> None:
    """Prints the table."""
    n = sum(r.scenes for r in results)
    good = sum(r.verified for r in results)
    rows = {**{s: spent[s] for s in batches.SCENE_STAGES}, "overhead": cpu - sum(spent.values())}
    print("| stage | CPU s a scene | share |\n| --- | ---: | ---: |")
    for stage, seconds in rows.items():
        print(f"| {stage} | {seconds / n:.3f} | {100 * seconds / cpu:.1f}% |")
    print(f"| all | {cpu / n:.3f} | 100% |\n")
    print(f"{good} of {n} scenes verified; {cpu:.1f} s CPU, {wall:.1f} s wall")
    print(
        f"{3600 * good / cpu:.0f} verified scenes an hour and core, {7200 * good / cpu:.0f} on two"
    )
    print(f"resident memory {memory_mib():.0f} MiB")
    for result in results:
        for row in result.failures:
            print(f"  {row['scene']}: {row['outcome']}: {row['prompt']} -> {row['reason'][:150]}")


if __name__ == "__main__":
    main()
