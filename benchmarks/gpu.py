"""Layout and the reference engine on a GPU: speed, and agreement with the CPU.

python -m benchmarks.gpu --out benchmarks/results --name h200

writes h200_layout.json and h200_newton.json. Drafting, and the CPU's side of every comparison, can
be made on another machine first:

python -m benchmarks.gpu --prepare prepared          # needs no GPU
python -m benchmarks.gpu --prepared prepared --out benchmarks/results --name h200

With `--only layout` nothing is drafted, and one command does it all.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
import json
import multiprocessing
from pathlib import Path
import time
from typing import Any

import numpy as np

from benchmarks.engines import Case, balls, car_bin_table, first_hits
from benchmarks.layout import HARD, batch
from benchmarks.lib.layout_graphs import generate
from esg.engines import get_engine
from esg.engines.program import batch_programs
from esg.engines.scene import Body, Rollout, Shape
from esg.graph.models import EsgDocument
from esg.layout import LayoutConfig, solve_batch

SCENES = 16_384
OBJECTS = 10
FIRST_GRAPH = 9000
KERNEL_SCENES = 256
PROGRAMS = 256
FRAME_S = 1.0 / 60.0
WORLDS = (256, 4096, 16_384)
RATES = (240, 120)
DURATION_S = 4.0


def four_bodies() -> Case:
    """The car, the bin and the table of the engines' benchmark, and a wall behind the table."""
    case = car_bin_table()
    half = (0.2, 3.0, 0.6)
    unit = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    wall = Body("wall", True, 1.0, unit, (Shape("box", half),), (9.0, 0.0, 0.6), friction=0.6)
    scene = replace(case.scene, scene_id="car-bin-table-wall", bodies=(*case.scene.bodies, wall))
    return Case(scene, case.chain, DURATION_S)


CASES: dict[str, Callable[[], Case]] = {"balls": balls, "car-bin-table-wall": four_bodies}


def _timed(run: Callable[[], Any]) -> tuple[float, Any]:
    start = time.perf_counter()
    result = run()
    return time.perf_counter() - start, result


# -- what the CPU prepares -----------------------------------------------------------------------


def prepare(folder: Path, suite: Path, limit: int, only: str | None) -> None:
    """Writes the results of the CPU and, except for the layout alone, laid-out documents."""
    folder.mkdir(parents=True, exist_ok=True)
    rows: list[dict[str, Any]] = []
    arrays: dict[str, np.ndarray] = {}
    if only != "layout":
        rows = _prepare_newton(folder, suite, limit, arrays)
    (folder / "optimize_cpu.json").write_text(json.dumps(rows))
    if only != "newton":
        units, energy = _search(KERNEL_SCENES, "cpu")
        arrays["layout/units"] = np.concatenate(units)
        arrays["layout/count"] = np.array([len(u) for u in units])
        arrays["layout/energy"] = energy
    np.savez_compressed(folder / "cpu.npz", **arrays)  # pyright: ignore[reportArgumentType]


def _prepare_newton(
    folder: Path, suite: Path, limit: int, arrays: dict[str, np.ndarray]
) -> list[dict[str, Any]]:
    from esg.assets import resolve
    from esg.draft import draft
    from esg.dynamics import start_hints
    from esg.layout import solve
    from esg.metrics import load_suite

    rows = []
    for scene in load_suite(suite).scenes[:limit]:
        doc = resolve(draft(scene.prompt), seed=0)
        doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
        (folder / f"{scene.id}.json").write_text(doc.model_dump_json())
        rows.append({"scene": scene.id, **_optimize(doc, "cpu")})
        print(rows[-1], flush=True)
    for name, case in CASES.items():
        rollout = _rollout(case(), PROGRAMS, 240, "cpu")
        arrays[f"{name}/hits"] = first_hits(case(), rollout)
        arrays[f"{name}/position"] = rollout.position[:, ::6].astype(np.float32)
    return rows


def _optimize(doc: EsgDocument, device: str) -> dict[str, Any]:
    from esg.dynamics import optimize

    seconds, out = _timed(lambda: optimize(doc, seed=0, device=device))
    r = out.dynamics_result
    assert r is not None
    return {
        "outcome": r.outcome,
        "loss": r.loss,
        "simulations": r.evaluations,
        "rounds": len(r.history),
        "bodies": len(doc.spatial_relation_graph.nodes),
        "duration_s": r.duration_s,
        "seconds": round(seconds, 3),
    }


def _rollout(case: Case, worlds: int, rate: int, device: str) -> Rollout:
    programs = batch_programs(case.programs(worlds, 0), case.scene.names)
    engine = get_engine("newton", device)
    return engine.rollout(case.scene, programs, dt=1.0 / rate, record_every=rate // 60)


def _problems(count: int) -> list[Any]:
    from esg.layout.problem.problem import build_problem

    return [build_problem(generate(FIRST_GRAPH + k, OBJECTS), k, None) for k in range(count)]


def _search(count: int, device: str) -> tuple[list[np.ndarray], np.ndarray]:
    """Unit poses of the lowest start of every scene, and their energies, shape [count, 3]."""
    from esg.layout.search import evaluate, run_search

    problems, config = _problems(count), LayoutConfig(device=device)
    found = run_search(problems, range(count), config)
    units = [r.units[int(r.energy.sum(axis=1).argmin())] for r in found]
    return units, evaluate(problems, units, config)


# -- layout --------------------------------------------------------------------------------------


def layout_report(cpu: dict[str, np.ndarray], device: str, processes: int) -> dict[str, Any]:
    """Seconds for 16,384 ten-object layouts, in parts and whole, and the kernels' agreement."""
    from esg.layout.search import evaluate

    compile_s, _ = _timed(lambda: _search(1, device))
    report: dict[str, Any] = {"first_search_with_kernel_compile_s": round(compile_s, 2)}
    # The same poses on both devices, then the same searches: sums differ in their last bits, so a
    # search may end elsewhere, but as low.
    cuts = np.cumsum(cpu["layout/count"])[:-1]
    units = np.split(cpu["layout/units"], cuts)
    config = LayoutConfig(device=device)
    same = evaluate(_problems(KERNEL_SCENES), units, config)
    there = cpu["layout/energy"]
    own = _search(KERNEL_SCENES, device)[1]
    report["agreement_with_cpu"] = {
        "scenes": KERNEL_SCENES,
        "largest_energy_difference_at_equal_poses": float(np.abs(same - there).max()),
        "largest_energy_at_these_poses": float(there.max()),
        "median_energy_found": {
            "cpu": float(np.median(there.sum(1))),
            "gpu": float(np.median(own.sum(1))),
        },
        "without_collision_energy": {
            "cpu": float((there[:, 1] < 0.05).mean()),
            "gpu": float((own[:, 1] < 0.05).mean()),
        },
    }
    report["search"] = batch(SCENES, device)
    print(json.dumps(report), flush=True)
    docs = _documents(processes)
    report["solve_batch"] = []
    for count, starts in ((1, 16), (processes - 1, 16), (processes - 1, 4)):
        row = _solve_all(docs, max(1, count), starts, device)
        report["solve_batch"].append(row)
        print(json.dumps(row), flush=True)
    return report


def _documents(processes: int) -> list[EsgDocument]:
    """16,384 different documents that share nothing, as if each had been read from a file."""
    with multiprocessing.get_context("spawn").Pool(processes) as pool:
        texts = pool.map(_graph, range(FIRST_GRAPH, FIRST_GRAPH + SCENES), chunksize=64)
    return [EsgDocument.model_validate_json(t) for t in texts]


def _graph(k: int) -> str:
    return generate(k, OBJECTS).model_dump_json()


def _solve_all(docs: list[EsgDocument], processes: int, starts: int, device: str) -> dict[str, Any]:
    """`solve_batch` from documents to documents, warm; processor seconds of its stages."""
    from esg.layout.clock import Clock

    config = LayoutConfig(starts=starts, device=device, processes=processes)
    solve_batch(docs[:64], list(range(64)), config=config)
    clock = Clock()
    seconds, results = _timed(
        lambda: solve_batch(docs, list(range(len(docs))), config=config, clock=clock)
    )
    total: Counter[str] = Counter()
    for r in results:
        assert r.layout_result is not None
        total["feasible"] += r.layout_result.feasible
        for x in r.layout_result.relations:
            kind = "hard" if x.relation_type in HARD else "soft"
            total[kind] += 1
            total[f"{kind}_broken"] += not x.satisfied
    return {
        "scenes": len(docs),
        "distinct": True,
        "starts": starts,
        "processes_beside_the_search": processes if processes > 1 else 0,
        "seconds": round(seconds, 3),
        "processor_seconds": {k: round(v, 2) for k, v in clock.seconds.items()},
        "feasible": total["feasible"],
        "hard_true": 1.0 - total["hard_broken"] / max(1, total["hard"]),
        "soft_true": 1.0 - total["soft_broken"] / max(1, total["soft"]),
    }


# -- the reference engine ------------------------------------------------------------------------


def newton_report(
    cpu: dict[str, np.ndarray],
    documents: dict[str, EsgDocument],
    optimized: list[dict[str, Any]],
    device: str,
) -> dict[str, Any]:
    """Agreement with the CPU, throughput over worlds, and seconds of a scene's search."""
    compile_s, _ = _timed(lambda: _rollout(four_bodies(), 1, 240, device))
    report: dict[str, Any] = {
        "first_rollout_with_kernel_compile_s": round(compile_s, 1),
        "agreement_with_cpu": [
            _agreement(name, case(), cpu, device) for name, case in CASES.items()
        ],
        "throughput": [],
    }
    print(json.dumps(report), flush=True)
    for name, case in CASES.items():
        for worlds in WORLDS:
            for rate in RATES:
                row = _throughput(case(), worlds, rate, device)
                report["throughput"].append({"scene": name, **row})
                print(json.dumps(report["throughput"][-1]), flush=True)
    report["optimize"] = []
    for there in optimized:
        doc = documents[there["scene"]]
        first, warm = _optimize(doc, device), _optimize(doc, device)
        row = {
            "scene": there["scene"],
            **first,
            "seconds_again": warm["seconds"],
            "repeats": {k: v for k, v in first.items() if k != "seconds"}
            == {k: v for k, v in warm.items() if k != "seconds"},
            "cpu": {k: there[k] for k in ("outcome", "loss", "simulations", "seconds")},
        }
        report["optimize"].append(row)
        print(json.dumps(row), flush=True)
    return report


def _agreement(name: str, case: Case, cpu: dict[str, np.ndarray], device: str) -> dict[str, Any]:
    here, again = (_rollout(case, PROGRAMS, 240, device) for _ in range(2))
    larger = _rollout(case, 4 * PROGRAMS, 240, device)
    there, hits = cpu[f"{name}/hits"], first_hits(case, here)
    out: dict[str, Any] = {
        "scene": name,
        "programs": PROGRAMS,
        "valid": int(here.valid.sum()),
        "same_bytes_again": here.position.tobytes() == again.position.tobytes()
        and here.contacts.impulse.tobytes() == again.contacts.impulse.tobytes(),
        "same_bytes_in_a_larger_batch": here.position.tobytes()
        == larger.position[:PROGRAMS].tobytes(),
    }
    for k, pair in enumerate(case.chain):
        both = ~np.isnan(hits[:, k]) & ~np.isnan(there[:, k])
        late = np.abs(hits[both, k] - there[both, k])
        out["-".join(pair)] = {
            "happens_cpu": int((~np.isnan(there[:, k])).sum()),
            "both_or_neither": float((np.isnan(hits[:, k]) == np.isnan(there[:, k])).mean()),
            "within_one_frame": float((late <= FRAME_S + 1e-9).mean()),
            "within_one_step": float((late <= 1.0 / 240.0 + 1e-9).mean()),
            "largest_difference_ms": 1e3 * float(late.max()) if len(late) else 0.0,
        }
    moved = np.linalg.norm(here.position[:, ::6] - cpu[f"{name}/position"], axis=-1)
    out["position_difference_cm"] = {
        f"{t:g} s": {
            "median": 100.0 * float(np.median(moved[:, round(t * 10)].max(-1))),
            "largest": 100.0 * float(moved[:, round(t * 10)].max()),
        }
        for t in (0.5, 1.0, 2.0, 4.0)
    }
    return out


def _throughput(case: Case, worlds: int, rate: int, device: str) -> dict[str, Any]:
    """Simulated seconds per second: 60 frames a second and all contacts brought to the host."""
    engine = get_engine("newton", device)
    programs = batch_programs(case.programs(worlds, 1), case.scene.names)
    kw: dict[str, Any] = {"dt": 1.0 / rate, "record_every": rate // 60}
    first, _ = _timed(lambda: engine.rollout(case.scene, programs, **kw))
    seconds, rollout = _timed(lambda: engine.rollout(case.scene, programs, **kw))
    return {
        "rate_hz": rate,
        "worlds": worlds,
        "simulated_s_per_s": round(worlds * case.duration / seconds, 1),
        "seconds": round(seconds, 3),
        "first_time_seconds": round(first, 3),
        "valid": int(rollout.valid.sum()),
    }


# -- command -------------------------------------------------------------------------------------


def _versions(device: str) -> dict[str, Any]:
    import newton
    import warp as wp

    wp.init()
    d = wp.get_device(device)
    out: dict[str, Any] = {
        "device": d.name,
        "warp": wp.config.version,
        "newton": newton.__version__,
        "numpy": np.__version__,
    }
    if d.is_cuda:
        out["compute_capability"] = f"{d.arch // 10}.{d.arch % 10}"
        out["memory_gib"] = round(d.total_memory / 2**30)
    return out


def _load(folder: Path) -> tuple[dict[str, np.ndarray], list[dict[str, Any]], dict[str, Any]]:
    with np.load(folder / "cpu.npz") as file:
        arrays = dict(file)
    rows = json.loads((folder / "optimize_cpu.json").read_text())
    documents = {
        r["scene"]: EsgDocument.model_validate_json((folder / f"{r['scene']}.json").read_text())
        for r in rows
    }
    return arrays, rows, documents


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--prepare", type=Path, help="only make documents and CPU results here")
    parser.add_argument("--prepared", type=Path, help="use what --prepare made")
    parser.add_argument("--suite", type=Path, default=Path("data/suites/paper.yaml"))
    parser.add_argument("--prompts", type=int, default=10, help="first prompts of the suite")
    parser.add_argument("--out", type=Path, default=Path("gpu"))
    parser.add_argument("--name", default="gpu", help="how the files' names begin")
    parser.add_argument("--device", default="cuda:0")
    parser.add_argument("--processes", type=int, default=16)
    parser.add_argument("--only", choices=("layout", "newton"))
    args = parser.parse_args()
    if args.prepare:
        prepare(args.prepare, args.suite, args.prompts, args.only)
        return
    args.out.mkdir(parents=True, exist_ok=True)
    folder = args.prepared or args.out / "prepared"
    if not args.prepared:
        prepare(folder, args.suite, args.prompts, args.only)
    cpu, rows, documents = _load(folder)
    given = " --prepared prepared" if args.prepared else ""
    command = f"python -m benchmarks.gpu{given} --out {args.out.name}"
    command += f" --name {args.name}" + (f" --only {args.only}" if args.only else "")
    head = {**_versions(args.device), "command": command}
    if args.only != "newton":
        data = head | layout_report(cpu, args.device, args.processes)
        (args.out / f"{args.name}_layout.json").write_text(json.dumps(data, indent=1) + "\n")
    if args.only != "layout":
        data = head | newton_report(cpu, documents, rows, args.device)
        (args.out / f"{args.name}_newton.json").write_text(json.dumps(data, indent=1) + "\n")


if __name__ == "__main__":
    main()
