"""The paper's ablation of the collision model on S6: does the bin reach the table?

python -m benchmarks.collision_model [--seeds 20] [--layout line|side] [--json FILE]

`spheres` and `boxes` know nothing but one primitive a body, choreography and layout included;
`boxes + SDF` goes on from that theta with contacts from voxel signed distance fields, made of the
collision parts or of the visible meshes; `parts` searches with the parts from the beginning. All
start from theta drawn uniformly between its bounds. PhysX at 240 steps a second plays the parts.

On the layout `line` every variant's own choreography has put the table where the bin will go. On
`side` the table stands 35 to 50 degrees off that line, as far from the bin as before, and the car
may start up to 1.2 m to either side: only a hit off the bin's centre, whose direction depends on
the contact normal, sends the bin there. Nothing in a theta is free but the car's speed, aim and
offset.

`--merge FILE ...` puts the seeds of several JSON files together and prints their table; of a seed
that occurs twice the later file counts.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.lib.theta import Case, Stopwatch, cold, completed, panel, suite_scene
from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import build_scene, start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.gradient.refine import REFINE_STEPS, Staged, refine
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.story.proxies import coarse, simple_document
from esg.dynamics.strategies import run_strategy
from esg.engines.base import VERIFY_DT_S
from esg.graph.models import EsgDocument, Pose
from esg.layout import solve
from esg.metrics.models import SuiteScene

PAPER = {"boxes": "1/10", "spheres": "1/10", "boxes + SDF (parts)": "8/10",
         "boxes + SDF (meshes)": "8/10"}  # fmt: skip
SIDE_DEG = (35.0, 50.0)
LATERAL_M = 1.2
CACHE = Path.home() / ".cache" / "esg-benchmarks" / "sdf"


@dataclass(frozen=True)
class Laid:
    """A laid-out document with its true assets, and the plan a variant searches."""

    doc: EsgDocument
    plan: Plan


def lay_out(scene: SuiteScene, seed: int, layout: str, kind: str | None) -> Laid:
    """Layout and plan from true assets (`kind` None) or from simple proxies only.

    Args:
        scene: The suite's scene.
        seed: Of drafting, choreography and layout.
        layout: line or side.
        kind: Simple proxies (`esg.dynamics.story.proxies`), or None.
    """
    doc = fitted(resolve(draft(scene.prompt, seed=seed), seed=seed))
    known = simple_document(doc, kind) if kind else doc
    placed = solve(known, seed=seed, hints=start_hints(known, seed=seed)).layout_result
    doc = doc.model_copy(update={"layout_result": placed})
    if layout == "side":
        doc = aside(doc, np.random.default_rng([seed, 9]))
    true = build_scene(doc)
    # What a plan aims by: the proxies, as the contacts of its search.
    told = doc.model_copy(update={"asset_configurations": known.asset_configurations})
    plan = make_plan(told, coarse(true, kind) if kind else true, seed=seed)
    return Laid(doc, widen(plan) if layout == "side" else plan)


def aside(doc: EsgDocument, rng: np.random.Generator) -> EsgDocument:
    """Turns the chain's last body about the one before it, away from the line of the first."""
    assert doc.layout_result is not None
    story = make_plan(doc, build_scene(doc)).story
    hub, last = story.outcomes[-1].participants[:2]
    angle = float(rng.uniform(*SIDE_DEG) * rng.choice([-1.0, 1.0]))
    poses = dict(doc.layout_result.poses)
    (hx, hy, _), (x, y, z) = poses[hub].position_cm, poses[last].position_cm
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    dx, dy = x - hx, y - hy
    turned: Pose = poses[last].model_copy(
        update={
            "position_cm": (hx + c * dx - s * dy, hy + s * dx + c * dy, z),
            "yaw_deg": (poses[last].yaw_deg + angle + 180.0) % 360.0 - 180.0,
        }
    )
    poses[last] = turned
    placed = doc.layout_result.model_copy(update={"poses": poses})
    return doc.model_copy(update={"layout_result": placed})


def widen(plan: Plan) -> Plan:
    """Lets actors start further to the side."""
    variables = tuple(
        replace(v, lower=-LATERAL_M, upper=LATERAL_M, spread=0.25 * LATERAL_M)
        if v.name.endswith("/lateral")
        else v
        for v in plan.variables
    )
    return replace(plan, variables=variables)


def compare(
    scene: SuiteScene, seed: int, layout: str, strategy: str, kinds: tuple[str, ...]
) -> dict[str, dict[str, Any]]:
    """Events and processor seconds of all variants for one seed."""
    rows: dict[str, dict[str, Any]] = {}

    def search(plan: Plan) -> np.ndarray:
        rng = np.random.default_rng([seed, 2])
        return run_strategy(plan, panel(plan), rng, strategy, steps=REFINE_STEPS)[0].theta

    def note(name: str, laid: Laid, theta: np.ndarray, cpu: float) -> None:
        true = replace(laid.plan, scene=build_scene(laid.doc))
        events = completed(Case(scene, laid.doc, true), theta)
        rows[name] = {"seed": seed, "events": events, "cpu_s": round(cpu, 2)}

    for kind, name in (("sphere", "spheres"), ("box", "boxes"), (None, "parts")):
        if name not in kinds:
            continue
        laid = lay_out(scene, seed, layout, kind)
        start = cold(laid.plan, np.random.default_rng([seed, 6]))
        with Stopwatch() as watch:
            theta = search(start)
        note(name, laid, theta, watch.cpu)
        if kind != "box":
            continue
        first = Staged(replace(start, scene=build_scene(laid.doc)), theta, [], 0, 0)
        for source, label in (("parts", "parts"), ("mesh", "meshes")):
            with Stopwatch() as more:
                found = refine(
                    laid.doc, first, lambda plan, judges: search(plan), strategy=strategy,
                    device="cpu", source=source, cache=CACHE,
                )  # fmt: skip
            note(f"boxes + SDF ({label})", laid, found.theta, watch.cpu + more.cpu)
    return rows


def report(result: dict[str, Any]) -> str:
    """The table of one result."""
    lines = [
        f"S6, layout {result['layout']}, strategy {result['strategy']}, events in PhysX at "
        f"{1 / result['dt_s']:.0f} Hz",
        f"{'variant':<22} {'event 1':>8} {'event 2':>8}        paper   median cpu s",
    ]
    for name in ("spheres", "boxes", "boxes + SDF (parts)", "boxes + SDF (meshes)", "parts"):
        rows = result["variants"].get(name, [])
        if not rows:
            continue
        won = np.array([r["events"] for r in rows])
        n = len(rows)
        cpu = float(np.median([r["cpu_s"] for r in rows]))
        lines.append(
            f"{name:<22} {won[:, 0].sum():>5}/{n} {won[:, 1].sum():>5}/{n} "
            f"{won[:, 1].mean():>6.0%}  {PAPER.get(name, ''):>6} {cpu:>10.1f}"
        )
    return "\n".join(lines)


def write(result: dict[str, Any], path: Path | None) -> None:
    """What is known so far, so that a run that is cut short can be continued and merged."""
    if path is not None:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(result, indent=1) + "\n")


def merge(results: list[dict[str, Any]]) -> dict[str, Any]:
    """One result with the seeds of all, which must be of one layout and strategy."""
    head = {k: v for k, v in results[0].items() if k != "variants"}
    for other in results[1:]:
        if {k: v for k, v in other.items() if k != "variants"} != head:
            raise SystemExit("the files differ in layout, strategy or engine")
    variants: dict[str, list[dict[str, Any]]] = {}
    for name in dict.fromkeys(n for r in results for n in r["variants"]):
        found = {row["seed"]: row for r in results for row in r["variants"].get(name, [])}
        variants[name] = [found[seed] for seed in sorted(found)]
    return head | {"variants": variants}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--layout", choices=("line", "side"), default="side")
    parser.add_argument("--strategy", default="hybrid", help="the search, in all variants")
    parser.add_argument("--starts", default="spheres,boxes,parts", help="shapes of the search")
    parser.add_argument("--merge", type=Path, nargs="+")
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    if args.merge:
        result = merge([json.loads(p.read_text()) for p in args.merge])
    else:
        scene = suite_scene("S6")
        kinds = tuple(args.starts.split(","))
        variants: dict[str, list[dict[str, Any]]] = {}
        result = {
            "layout": args.layout, "strategy": args.strategy, "engine": "physx",
            "dt_s": VERIFY_DT_S, "variants": variants,
        }  # fmt: skip
        for seed in range(args.first_seed, args.first_seed + args.seeds):
            for name, row in compare(scene, seed, args.layout, args.strategy, kinds).items():
                variants.setdefault(name, []).append(row)
                print(seed, name, row["events"], row["cpu_s"], flush=True)
            write(result, args.json)
    print(report(result))
    write(result, args.json)


if __name__ == "__main__":
    main()
