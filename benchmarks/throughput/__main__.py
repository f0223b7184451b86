"""How many verified scenes an hour are made, and where the time goes.

    python -m benchmarks.throughput [--scenes 60] [--seed 0] [--levels single chain] [--profile]
    python -m benchmarks.throughput --wall [--scenes 2000] [--workers 2] [--device cpu]
        [--batch N] [--out benchmarks/results/throughput.json] [--keep FOLDER]

Without `--wall`: the batches of a sampled dataset one after the other in this process, warm (a
first batch of another seed is not counted), and CPU seconds by stage: CPU time, because a wall
clock says little on a machine that does other work. A machine makes as many times more as it has
cores.

With `--wall`: the real command, `esg dataset`, from its start to its end, on a machine that does
nothing else. Compiled classes of earlier runs are not there to be found (a cache folder of its own;
a first run of four scenes makes what is made once a machine). Written down are verified scenes an
hour, the share of the workers' time (number of workers times wall clock) by stage and beside the
stages, CPU time by process, and the resident memory of every worker over the finished scenes, with
its slope once a tenth of them is made, by process and, since workers are replaced (esg.workers,
esg.machine.forked), of whichever worker runs; `worker_processes` says how many there were.
"""

from __future__ import annotations

import argparse
from collections import defaultdict
import json
import os
from pathlib import Path
import platform
import resource
import subprocess
import sys
import tempfile
import time
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("ESG_THREADS", "1")

from benchmarks.throughput.wall import Watch, plot
from esg.dataset import running
from esg.dataset.batch import make_batch
from esg.dataset.distribution import Distribution
from esg.dataset.finish import finish
from esg.dataset.folder import DatasetFolder
from esg.dataset.job import BatchJob, BatchResult
from esg.dataset.plan import DatasetSpec, plan_scenes
from esg.paths import kernel_cache_dir

RESULTS = Path(__file__).parents[1] / "results"
PRODUCTS = ("annotations", "meshes", "recordings")
"""What a dataset holds beside what its stages make."""


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
        self._stage, self._together = running._stage, running._compile_together

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

        running._stage, running._compile_together = stage, together


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.throughput", description=__doc__.splitlines()[0]
    )
    parser.add_argument("--scenes", type=int, help="default 60, with --wall 2000")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--levels", nargs="+", default=["single", "chain"])
    parser.add_argument("--profile", action="store_true", help="print a profile of the functions")
    parser.add_argument("--wall", action="store_true", help="time the real command")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--batch", type=int, help="scenes a batch")
    parser.add_argument("--out", type=Path, default=RESULTS / "throughput.json")
    parser.add_argument("--keep", type=Path, help="keep the dataset here")
    args = parser.parse_args()
    args.scenes = args.scenes or (2000 if args.wall else 60)
    if args.wall:
        time_command(args)
        return
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


def time_command(args: argparse.Namespace) -> None:
    """Runs the real command and writes what it took."""
    with tempfile.TemporaryDirectory() as name:
        work = Path(name)
        mix = work / "mix.yaml"
        mix.write_text(json.dumps({"levels": {level: 1.0 for level in args.levels}}))
        environment = {
            **os.environ,
            "ESG_CACHE_DIR": str(work / "cache"),
            "WARP_CACHE_PATH": str(kernel_cache_dir().parent),
        }
        environment.pop("PREFECT_API_URL", None)
        own = ("OMP_NUM_THREADS", "ESG_THREADS")
        environment = {k: v for k, v in environment.items() if k not in own}
        base = [sys.executable, "-m", "esg.cli", "dataset", "--distribution", str(mix),
                "--device", args.device, "--workers", str(args.workers)]  # fmt: skip
        first = [*base, "--sample", "4", "--seed", "991", "--out", str(work / "first")]
        begin = time.perf_counter()
        subprocess.run(first, env=environment, check=False, stdout=subprocess.DEVNULL)
        print(f"first run, 4 scenes: {time.perf_counter() - begin:.1f} s", flush=True)
        out = args.keep or work / "set"
        more = ["--batch", str(args.batch)] if args.batch else []
        command = [*base, *more, "--sample", str(args.scenes), "--seed", str(args.seed)]
        watch = Watch(out)
        code = watch.run([*command, "--out", str(out)], environment)
        if code not in (0, 3):
            raise SystemExit(f"the command failed with exit code {code}")
        facts = wall_facts(watch, out, args)
    facts["command"] = " ".join(["esg", *command[3:]]).replace(str(mix), "MIX.yaml")
    args.out.parent.mkdir(parents=True, exist_ok=True)
    picture = args.out.with_name(f"{args.out.stem}_memory.svg")
    plot(watch, picture)
    args.out.write_text(json.dumps(facts, indent=1) + "\n")
    shown = {k: v for k, v in facts.items() if k != "memory_samples"}
    print(json.dumps(shown, indent=1))
    print(f"{args.out}\n{picture}")


def wall_facts(watch: Watch, out: Path, args: argparse.Namespace) -> dict[str, Any]:
    """What is written down of a run of the real command."""
    statistics = json.loads((out / "meta" / "info.json").read_bytes())["statistics"]
    spent = json.loads((out / "meta" / "timings.json").read_bytes())["seconds"]
    whole = watch.wall_s * args.workers
    inside = sum(spent.values())
    stages = {s: spent[s] for s in running.SCENE_STAGES}
    products = {name: spent.get(name, 0.0) for name in PRODUCTS}
    # Starting the processes, waiting for the last batch, putting the dataset together.
    parts = {**stages, **products, "in batches beside them":
             spent["overhead"], "outside of batches": whole - inside}  # fmt: skip
    times = sorted(t for t, _ in watch.marks.values())
    n, good = statistics["scenes"], statistics["verified"]
    beside = whole - sum(stages.values()) - sum(products.values())
    step = max(1, len(watch.samples) // 200)
    memory = watch.memory(warm=max(1, n // 10))
    return {
        "machine": f"{platform.machine()}, {os.cpu_count()} cores",
        "device": args.device,
        "workers": args.workers,
        "scenes": n,
        "verified": good,
        "outcomes": statistics["outcomes"],
        "wall_s": round(watch.wall_s, 1),
        "verified_scenes_per_hour": round(3600 * good / watch.wall_s),
        "first_batch_done_s": round(times[0], 1) if times else None,
        "last_batch_done_s": round(times[-1], 1) if times else None,
        "worker_s_per_scene": {k: round(v / n, 4) for k, v in parts.items()},
        "share": {k: round(v / whole, 4) for k, v in parts.items()},
        "overhead_share": round(beside / whole, 4),
        "cpu_s": watch.cpu_by_role(),
        "worker_processes": len(memory),
        "memory_by_role": {
            role: watch.memory_of(role, max(1, n // 10)) for role in ("worker", "command")
        },
        "memory": memory,
        "memory_samples": [
            {
                "time_s": round(s.time_s, 1),
                "scenes": s.scenes,
                "rss_mib": {watch.roles[p] + f" {p}": round(v, 1) for p, v in s.rss.items()},
            }
            for s in watch.samples[::step]
        ],
    }


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
    rows = {**{s: spent[s] for s in running.SCENE_STAGES}, "overhead": cpu - sum(spent.values())}
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
