"""Layout benchmark: solvable graphs with a settling check, ablations, scaling, pictures.

python -m benchmarks.layout graphs --count 500 --settle 500
python -m benchmarks.layout ablation --count 100
python -m benchmarks.layout scaling
python -m benchmarks.layout pictures --count 20 --out layouts.png
"""

from __future__ import annotations

import argparse
from collections import Counter
from dataclasses import replace
import json
from pathlib import Path
import time
from typing import Any

from benchmarks.lib.layout_graphs import generate
from esg.graph.models import EsgDocument
from esg.layout import LayoutConfig, solve, solve_batch

HARD = ("on", "inside_of", "attached_vertical", "attached_horizontal")
SETTLE_S = 0.5
MAX_SETTLE_CM = 0.5


def settle_cm(doc: EsgDocument) -> dict[str, float]:
    """Lets a layout rest in PhysX for half a second.

    Returns:
        Vertical displacement of every dynamic body [cm].
    """
    import numpy as np

    from esg.dynamics.plan.build import build_scene
    from esg.engines.program import FIELDS, ProgramBatch
    from esg.engines.registry import get_engine

    scene = build_scene(doc)
    count = len(scene.bodies)
    batch = ProgramBatch(
        np.zeros(0, np.int32),
        np.zeros(0, np.int32),
        np.zeros((0, count), bool),
        np.zeros((1, 0, FIELDS)),
        SETTLE_S,
    )
    rollout = get_engine("physx").rollout(scene, batch, dt=1 / 240, duration=SETTLE_S)
    z = rollout.position[0, :, :, 2]
    return {
        b.name: 100.0 * float(z[-1, i] - z[0, i])
        for i, b in enumerate(scene.bodies)
        if not b.static
    }


def summarize(results: list[EsgDocument]) -> dict[str, Any]:
    """Feasibility, penetration and shares of true relations over many layouts."""
    total: Counter[str] = Counter()
    broken: Counter[str] = Counter()
    for r in results:
        assert r.layout_result is not None
        for x in r.layout_result.relations:
            total[x.relation_type] += 1
            broken[x.relation_type] += not x.satisfied
    soft = sum(v for k, v in total.items() if k not in HARD)
    soft_broken = sum(v for k, v in broken.items() if k not in HARD)
    layouts = [r.layout_result for r in results if r.layout_result is not None]
    return {
        "scenes": len(results),
        "feasible": sum(x.feasible for x in layouts),
        "max_penetration_cm": max(x.max_penetration_cm for x in layouts),
        "overlapping": sum(x.max_penetration_cm > 0.05 for x in layouts),
        "hard_true": 1.0 - sum(broken[k] for k in HARD) / max(1, sum(total[k] for k in HARD)),
        "soft_true": 1.0 - soft_broken / max(1, soft),
        "all_true": sum(all(r.satisfied for r in x.relations) for x in layouts),
        "broken": dict(sorted(broken.items())),
    }


def graphs(count: int, settle: int, device: str) -> dict[str, Any]:
    """Solves generated problems one by one and settles the first `settle` of them."""
    docs = [generate(k) for k in range(count)]
    config = LayoutConfig(device=device)
    solve(docs[0], config=config)
    seconds: list[float] = []
    results: list[EsgDocument] = []
    for k, d in enumerate(docs):
        start = time.perf_counter()
        results.append(solve(d, seed=k, config=config))
        seconds.append(time.perf_counter() - start)
    out = summarize(results)
    ordered = sorted(seconds)
    out["seconds_median"] = round(ordered[len(ordered) // 2], 4)
    out["seconds_max"] = round(ordered[-1], 3)
    worst = 0.0
    moved: list[str] = []
    for r in results[:settle]:
        for name, dz in settle_cm(r).items():
            worst = max(worst, abs(dz))
            if abs(dz) > MAX_SETTLE_CM:
                moved.append(f"{r.scene_definition.scene_id}/{name}: {dz:+.2f} cm")
    out |= {"settled": min(settle, count), "settle_worst_cm": round(worst, 3), "moved": moved}
    return out


def ablation(count: int, device: str) -> list[dict[str, Any]]:
    """The paper's ablations; one round each, so that retries do not hide a difference."""
    docs = [generate(k) for k in range(count)]
    full = LayoutConfig(device=device, rounds=1)
    variants = {
        "full": full,
        "full, 3 rounds": replace(full, rounds=3),
        "w/o global refinement": replace(full, refine=False),
        "w/o sampling init": replace(full, sample_init=False),
        "w/o preference": replace(full, preference=False),
        "AABB only": replace(full, collision="aabb"),
        "SDF": replace(full, collision="sdf"),
        "HYBRID": replace(full, collision="hybrid"),
    }
    rows = []
    for name, config in variants.items():
        solve_batch(docs[:1], config=config)
        start = time.perf_counter()
        results = [solve(d, seed=k, config=config) for k, d in enumerate(docs)]
        rows.append(
            {
                "variant": name,
                **summarize(results),
                "seconds_per_scene": (time.perf_counter() - start) / count,
            }
        )
    return rows


def scaling(device: str) -> list[dict[str, Any]]:
    """Wall and processor seconds of the search over objects and starts, warm, one thread."""
    from esg.layout.problem.problem import build_problem
    from esg.layout.search import run_search

    rows = []
    for objects in (5, 10, 20, 40, 80):
        problem = build_problem(generate(5000 + objects, objects), 0, None)
        for starts in (1, 16, 64):
            config = LayoutConfig(starts=starts, threads=1, device=device)
            run_search([problem], [0], replace(config, iterations=1))
            wall, cpu = time.perf_counter(), time.process_time()
            run_search([problem], [0], config)
            rows.append(
                {
                    "objects": objects,
                    "starts": starts,
                    "seconds": round(time.perf_counter() - wall, 4),
                    "cpu_seconds": round(time.process_time() - cpu, 4),
                }
            )
    return rows


def batch(count: int, device: str) -> list[dict[str, Any]]:
    """Seconds of one search over many ten-object scenes: 64 different ones, repeated."""
    from esg.layout.problem.problem import build_problem
    from esg.layout.search import run_search

    start = time.perf_counter()
    distinct = [build_problem(generate(9000 + k, 10), 0, None) for k in range(min(64, count))]
    build = (time.perf_counter() - start) / len(distinct)
    problems = [distinct[k % len(distinct)] for k in range(count)]
    rows = []
    for starts in (1, 4, 16):
        config = LayoutConfig(starts=starts, device=device)
        run_search(problems[:64], range(64), config)
        start = time.perf_counter()
        results = run_search(problems, range(count), config)
        seconds = time.perf_counter() - start
        clear = sum(float(r.energy[:, 1].min()) < 0.05 for r in results) / count
        rows.append(
            {
                "scenes": count,
                "starts": starts,
                "seconds": seconds,
                "share_without_collision_energy": clear,
                "seconds_to_generate_and_build_one": build,
            }
        )
    return rows


PROMPTS = (
    "Six chairs surround a dining table and face it.",
    "A bowling ball rolls down the lane and hits ten pins standing in a triangle.",
    "A queue of five cars waits in a lane.",
    "Twenty dominoes stand in a row on the floor and topple one after another.",
    "A stack of five books lies on a desk.",
    "A laptop stands on a desk and faces a chair in front of the desk.",
    "A picture hangs on the wall above a sofa.",
    "A cup stands on a book that lies on a box on a table.",
    "A bookshelf holds six books and two vases, with a chair next to it.",
    "Twelve laptops stand on a small table.",
)


def pictures(count: int, out: Path) -> None:
    """Two sheets of layouts, from above and in perspective: everyday prompts, then graphs."""
    from benchmarks.lib.layout_pictures import perspective, sheet, top_down
    from esg.assets import resolve
    from esg.draft import draft
    from esg.dynamics import start_hints

    docs = []
    for prompt in PROMPTS[:count]:
        doc = resolve(draft(prompt), seed=0)
        doc = solve(doc, seed=0, hints=start_hints(doc, seed=0))
        head = doc.scene_definition.model_copy(update={"scene_id": prompt})
        docs.append(doc.model_copy(update={"scene_definition": head}))
    docs += [solve(generate(k), seed=k) for k in range(count - len(docs))]
    for name, picture in (("top", top_down), ("perspective", perspective)):
        sheet(docs, out.with_name(f"{out.stem}_{name}{out.suffix}"), picture=picture)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("what", choices=("graphs", "ablation", "scaling", "batch", "pictures"))
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--settle", type=int, default=0)
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--out", type=Path, default=None)
    args = parser.parse_args()
    if args.what == "pictures":
        pictures(args.count, args.out or Path("layouts.png"))
        return
    result: Any
    if args.what == "graphs":
        result = graphs(args.count, args.settle, args.device)
    elif args.what == "ablation":
        result = ablation(args.count, args.device)
    elif args.what == "batch":
        result = batch(args.count, args.device)
    else:
        result = scaling(args.device)
        if args.out:
            from benchmarks.lib.layout_pictures import curve

            curve(result, args.out.with_suffix(".png"))
    text = json.dumps(result, indent=1)
    if args.out:
        args.out.write_text(text + "\n")
    print(text)


if __name__ == "__main__":
    main()
