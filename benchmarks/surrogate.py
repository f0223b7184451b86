"""The fused surrogate beside analytic truth and the reference engine, its speed and its gradients.

python -m benchmarks.surrogate analytic
python -m benchmarks.surrogate speed
python -m benchmarks.surrogate agreement [--documents FOLDER]
python -m benchmarks.surrogate gradients [--documents FOLDER]

The last two work on laid-out documents: JSON files of a folder, or else the prompts of
data/suites/paper.yaml, which are drafted and laid out first.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
import json
import math
from pathlib import Path
import time
from typing import Any

import numpy as np

from benchmarks.engines import Case, balls, car_bin_table
from esg.dynamics.gradient.differentiate import Regime, check_gradient, regimes, starts
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import Plan, make_plan
from esg.engines import get_engine
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.scene import Body, Rollout, Shape, SimScene, Variation
from esg.graph import load_document
from esg.graph.models import EsgDocument, NodeEvent

DT = 1.0 / 240.0
SUITE = Path("data/suites/paper.yaml")
SETTLE_S = 0.12
G = 9.81


# -- analytic truth ------------------------------------------------------------------------------


def _inertia(values: list[float]) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(float(v) for v in row) for row in np.diag(values))


def _ball(name: str, x: float, y: float, z: float, **more: Any) -> Body:
    r = 0.1
    return Body(name, False, 1.0, _inertia([0.4 * r * r] * 3), (Shape("sphere", (r, r, r)),),
                (x, y, z), roll_radius=r, **more)  # fmt: skip


def _box(name: str, half: tuple[float, float, float], x: float, y: float, **more: Any) -> Body:
    a, b, c = (2.0 * h for h in half)
    inertia = [(b * b + c * c) / 6.0, (a * a + c * c) / 6.0, (a * a + b * b) / 6.0]
    return Body(name, False, 2.0, _inertia(inertia), (Shape("box", half),), (x, y, half[2]), **more)


def analytic_scene() -> tuple[SimScene, Program]:
    """Experiments side by side, far apart."""
    bodies = (
        _ball("e1 a", 0, 0, 50, restitution=1.0),
        _ball("e1 b", 0.7, 0, 50, restitution=1.0),
        _ball("e.5 a", 0, 4, 50, restitution=0.5),
        _ball("e.5 b", 0.7, 4, 50, restitution=0.5),
        # Offset by one radius: the normal is 30 degrees off, so b leaves at -30 degrees.
        _ball("oblique a", 0, 8, 50, restitution=1.0, friction=0.0),
        _ball("oblique b", 0.7, 7.9, 50, restitution=1.0, friction=0.0),
        _box("slide", (0.2, 0.2, 0.1), 0, 12, friction=0.3),
        _ball("roll", 0, 16, 0.1, friction=0.5),
        _ball("bounce", 0, 20, 2.1, restitution=0.8),
        _box("stands", (0.1, 0.1, 0.4), 0, 24, friction=0.9),
        _box("topples", (0.1, 0.1, 0.4), 0, 28, friction=0.9),
    )
    # Just below and above the energy that lifts the centre over the edge after a push of the
    # whole box about its bottom edge.
    lift = math.hypot(0.1, 0.4) - 0.4
    box = bodies[-1]
    about_edge = box.inertia[1][1] + box.mass * (0.1**2 + 0.4**2)
    omega = math.sqrt(2.0 * box.mass * G * lift / about_edge)

    def push(name: str, factor: float) -> SetVelocity:
        w = factor * omega
        # About the edge at (0.1, 0, -0.4) from the centre: v = w x r.
        return SetVelocity(name, 0.0, (0.4 * w, 0.0, 0.1 * w), (0.0, w, 0.0))

    actions = (
        SetVelocity("e1 a", 0.0, (2.0, 0, 0)),
        SetVelocity("e.5 a", 0.0, (2.0, 0, 0)),
        SetVelocity("oblique a", 0.0, (2.0, 0, 0)),
        SetVelocity("slide", 0.0, (4.0, 0, 0)),
        SetVelocity("roll", 0.0, (3.0, 0, 0), (0, 30.0, 0)),
        push("stands", 0.97),
        push("topples", 1.03),
    )
    return SimScene("analytic", bodies, ground_friction=0.3 + 0.0, ground_restitution=0.4), Program(
        actions, 2.0
    )


def analytic() -> None:
    """Prints what each engine makes of experiments with known results."""
    scene, program = analytic_scene()
    batch = batch_programs([program], scene.names)
    d = 4.0**2 / (2.0 * 0.3 * G)
    print("| quantity | exact | surrogate 240 Hz | surrogate 120 Hz | newton 240 Hz |\n"
          "| --- | --- | --- | --- | --- |")  # fmt: skip
    columns = [
        _measure(scene, get_engine(n).rollout(scene, batch, dt=1.0 / hz, record_every=hz // 120))
        for n, hz in (("surrogate", 240), ("surrogate", 120), ("newton", 240))
    ]
    exact = ["0, 2", "0.5, 1.5", "-30.0", f"{d:.3f}", "6.00", "0.72", "0", "90"]
    for k, (name, truth) in enumerate(zip(columns[0], exact, strict=True)):
        print(f"| {name} | {truth} | " + " | ".join(list(c.values())[k] for c in columns) + " |")


def _measure(scene: SimScene, r: Rollout) -> dict[str, str]:
    def state(field: str, name: str) -> np.ndarray:
        return getattr(r, field)[0, :, scene.index(name)].astype(float)

    v = {n: state("linear_velocity", n) for n in scene.names}
    at = round(0.6 / (r.time[1] - r.time[0]))
    oblique = v["oblique b"][at]
    height = state("position", "bounce")[:, 2] - 0.1
    landed = int(np.argmax(height < 0.03))
    out = {
        "head-on, e = 1 [m/s]": f"{v['e1 a'][at, 0]:.3f}, {v['e1 b'][at, 0]:.3f}",
        "head-on, e = 0.5 [m/s]": f"{v['e.5 a'][at, 0]:.3f}, {v['e.5 b'][at, 0]:.3f}",
        "oblique, direction [deg]": f"{math.degrees(math.atan2(oblique[1], oblique[0])):.1f}",
        "slide at 4 m/s, friction 0.3 [m]": f"{state('position', 'slide')[-1, 0]:.3f}",
        "roll at 3 m/s for 2 s [m]": f"{state('position', 'roll')[-1, 0]:.2f}",
        "bounce from 2 m, e = 0.6 [m]": f"{height[landed:].max():.2f}",
    }
    for name, label in (("stands", "box pushed 3% too weakly to topple [deg]"),
                        ("topples", "box pushed 3% harder than needed [deg]")):  # fmt: skip
        q = state("quaternion", name)[-1]
        up = 1.0 - 2.0 * (q[0] ** 2 + q[1] ** 2)
        out[label] = f"{math.degrees(math.acos(np.clip(up, -1, 1))):.0f}"
    return out


# -- speed -----------------------------------------------------------------------------------------


def _busy(case: Case, name: str, device: str, worlds: int) -> tuple[float, float]:
    """Simulated seconds per second of wall time and of processor time, warm."""
    engine = get_engine(name, device)
    batch = batch_programs(case.programs(worlds, 1), case.scene.names)
    engine.rollout(case.scene, batch, dt=DT, record_every=4, duration=0.1)
    wall = busy = math.inf
    for _ in range(2):
        start, start_busy = time.perf_counter(), time.process_time()
        engine.rollout(case.scene, batch, dt=DT, record_every=4)
        wall = min(wall, time.perf_counter() - start)
        busy = min(busy, time.process_time() - start_busy)
    return worlds * case.duration / wall, worlds * case.duration / busy


def speed(newton_worlds: int) -> None:
    """Prints the speed of the surrogate and of the reference engine in one run."""
    from esg.engines.newton import quiet_warp

    devices = [str(d) for d in quiet_warp().get_devices()]
    print("| scene | device | worlds | surrogate, s per s | newton, s per s | ratio | "
          "ratio by processor time |\n| --- | --- | --- | --- | --- | --- | --- |")  # fmt: skip
    for device in devices:
        for case in (balls(), car_bin_table()):
            for worlds in (1, 32, 1024):
                ours = _busy(case, "surrogate", device, worlds)
                limit = worlds if device != "cpu" else min(worlds, newton_worlds)
                theirs = _busy(case, "newton", device, limit)
                print(f"| {case.scene.scene_id} | {device} | {worlds} | {ours[0]:.0f} | "
                      f"{theirs[0]:.0f} | {ours[0] / theirs[0]:.1f} | {ours[1] / theirs[1]:.1f} |",
                      flush=True)  # fmt: skip


# -- agreement and gradients ---------------------------------------------------------------------


def documents(folder: Path | None) -> Iterator[tuple[str, EsgDocument]]:
    """Laid-out documents with a timeline, by name."""
    if folder is not None:
        for path in sorted(folder.glob("*.json")):
            doc = load_document(path)
            if doc.timeline_system is not None and doc.layout_result is not None:
                yield path.stem, doc
        return
    from esg.assets import resolve
    from esg.draft import draft
    from esg.dynamics import start_hints
    from esg.layout import solve
    from esg.metrics import load_suite

    for scene in load_suite(SUITE).scenes:
        doc = resolve(draft(scene.prompt, seed=0), seed=0)
        yield scene.id, solve(doc, seed=0, hints=start_hints(doc, seed=0))


def plan_of(doc: EsgDocument) -> Plan:
    """The plan of a document as the optimizer starts with it."""
    doc = doc.model_copy(update={"dynamics_result": None})
    return make_plan(doc, build_scene(doc), seed=0)


def draw(plan: Plan, n: int, rng: np.random.Generator, spread: float) -> np.ndarray:
    """Random thetas around the choreographed one, shape [n, variables]."""
    scale = spread * np.array([v.spread for v in plan.variables]) * plan.free()
    thetas = plan.initial() + scale * rng.standard_normal((n, len(scale)))
    return np.clip(thetas, plan.lower(), plan.upper())


def _collisions(plan: Plan) -> list[tuple[list[int], list[int]]]:
    """Members of the two sides of every collision, in causal order."""
    names = plan.scene.names
    return [
        tuple([names.index(m) for m in plan.story.expand(p) if m in names]
              for p in (node.participants[0], node.participants[-1]))
        for node in plan.story.outcomes if node.event is NodeEvent.COLLISION
    ]  # type: ignore[return-value]  # two lists each  # fmt: skip


def _events(rollout: Rollout, pairs: list[tuple[list[int], list[int]]]) -> np.ndarray:
    """Time of each collision after the one before it, NaN if it did not happen, [W, K]."""
    log = rollout.contacts
    out = np.full((len(rollout.valid), len(pairs)), np.nan)
    for k, (a, b) in enumerate(pairs):
        rows = (np.isin(log.a, a) & np.isin(log.b, b)) | (np.isin(log.a, b) & np.isin(log.b, a))
        for w in range(len(out)):
            if k and np.isnan(out[w, k - 1]):
                continue
            earliest = out[w, k - 1] + 0.1 if k else -1.0
            times = log.time[rows & (log.world == w) & (log.time >= earliest)]
            out[w, k] = times.min() if len(times) else np.nan
    return out


def _speeds(
    rollout: Rollout, pairs: list[tuple[list[int], list[int]]], t: np.ndarray
) -> np.ndarray:
    """Speed of the struck body SETTLE_S after each collision [m/s], shape [W, K]."""
    out = np.full(t.shape, np.nan)
    for k, (_, struck) in enumerate(pairs):
        for w in np.flatnonzero(np.isfinite(t[:, k])):
            frame = min(
                int(np.searchsorted(rollout.time, t[w, k] + SETTLE_S)), len(rollout.time) - 1
            )
            v = rollout.linear_velocity[w, frame, struck].astype(float)
            out[w, k] = np.linalg.norm(v, axis=-1).max()
    return out


def agreement(folder: Path | None, n: int, spread: float, out: str | None) -> None:
    """Prints how often and how closely collisions agree with the reference engine."""
    print("| scene | events | 1st agrees | 2nd agrees | 1st, ms | 2nd, ms | speed after 1st, m/s |"
          " later events |\n| --- | --- | --- | --- | --- | --- | --- | --- |")  # fmt: skip
    rows: list[dict[str, Any]] = []
    for name, doc in documents(folder):
        plan = plan_of(doc)
        pairs = _collisions(plan)
        if not pairs or not plan.variables:
            continue
        thetas = draw(plan, n, np.random.default_rng(5), spread)
        batch = batch_programs([plan.compile(t) for t in thetas], plan.scene.names)
        position, quaternion = starts(plan, thetas)
        variation = Variation(position=position, quaternion=quaternion)
        runs = [
            get_engine(e).rollout(plan.scene, batch, dt=DT, record_every=4, variation=variation)
            for e in ("newton", "surrogate")
        ]
        t = [_events(r, pairs) for r in runs]
        v = [_speeds(r, pairs, x) for r, x in zip(runs, t, strict=True)]
        same = np.isnan(t[0]) == np.isnan(t[1])
        late, fast = 1e3 * np.abs(t[1] - t[0]), np.abs(v[1] - v[0])
        row = {
            "scene": name,
            "collisions": len(pairs),
            "agrees": same.mean(axis=0).tolist(),
            "ms": [_pair(late[:, k]) for k in range(len(pairs))],
            "speed": [_pair(fast[:, k]) for k in range(len(pairs))],
            "happened": np.isfinite(t[0]).mean(axis=0).tolist(),
        }
        rows.append(row)
        second = len(pairs) > 1
        later = ", ".join(f"{x:.0%}" for x in same.mean(axis=0)[2:]) or "–"
        cells = [
            f"{same[:, 0].mean():.0%}",
            f"{same[:, 1].mean():.0%}" if second else "–",
            _show(late[:, 0], 0),
            _show(late[:, 1], 0) if second else "–",
            _show(fast[:, 0], 2),
            later,
        ]
        print(f"| {name} | {len(pairs)} | {' | '.join(cells)} |", flush=True)
    for k, label in ((0, "first"), (1, "second")):
        values = [r["agrees"][k] for r in rows if r["collisions"] > k]
        if values:
            print(
                f"{label} collisions agree in {np.mean(values):.1%} of {len(values) * n} rollouts"
            )
    if out:
        Path(out).write_text(json.dumps(rows, indent=1))


def _show(x: np.ndarray, digits: int) -> str:
    median, most = _pair(x)
    return "–" if math.isnan(median) else f"{median:.{digits}f} / {most:.{digits}f}"


def _pair(x: np.ndarray) -> tuple[float, float]:
    """Median and maximum."""
    x = x[np.isfinite(x)]
    return (float(np.median(x)), float(x.max())) if len(x) else (math.nan, math.nan)


def gradients(folder: Path | None, n: int, spread: float, width: float, out: str | None) -> None:
    """Prints how gradients by wp.Tape compare with central differences, by regime."""
    found: dict[str, list[tuple[float, float]]] = {}
    rows: list[dict[str, Any]] = []
    for name, doc in documents(folder):
        plan = plan_of(doc)
        kinds = set(regimes(plan).values())
        if not plan.free().any() or kinds <= {Regime.NONE}:
            continue
        worst = next(r for r in (Regime.CHAIN, Regime.ONE_CONTACT, Regime.DIRECT) if r in kinds)
        for theta in draw(plan, n, np.random.default_rng(6), spread):
            check = check_gradient(plan, theta, width=width)
            size = float(np.linalg.norm(check.differences))
            rows.append(
                {
                    "scene": name,
                    "regime": worst.value,
                    "cosine": check.cosine,
                    "error": check.error,
                    "trusted": check.trusted,
                    "smooth": check.smooth,
                    "size": size,
                }
            )
            if not check.trusted:
                label = f"{worst.value}, something else is hit before"
                found.setdefault(label, []).append((check.cosine, check.error))
            elif not check.smooth:
                found.setdefault(f"{worst.value}, an event appears or vanishes", []).append((0, 0))
            elif size > 1e-3:
                found.setdefault(worst.value, []).append((check.cosine, check.error))
    print("| regime | gradients | cosine > 0.99 | cosine > 0.9 | error, median | 90% below |"
          "\n| --- | --- | --- | --- | --- | --- |")  # fmt: skip
    for label, pairs in sorted(found.items()):
        cosine, error = np.array(pairs).T
        if "appears" in label:
            print(f"| {label} | {len(pairs)} | – | – | – | – |")
            continue
        print(f"| {label} | {len(pairs)} | {np.mean(cosine > 0.99):.0%} | "
              f"{np.mean(cosine > 0.9):.0%} | {np.median(error):.3f} | "
              f"{np.quantile(error, 0.9):.3f} |")  # fmt: skip
    if out:
        Path(out).write_text(json.dumps(rows, indent=1))


def main() -> None:
    """Prints the tables of docs/results/surrogate.md."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("analytic", "speed", "agreement", "gradients"))
    parser.add_argument("--documents", type=Path, help="folder of laid-out documents")
    parser.add_argument("--samples", type=int, default=24, help="thetas a scene")
    parser.add_argument("--spread", type=float, default=1.0, help="of thetas, in spreads")
    parser.add_argument("--width", type=float, default=0.2, help="of differences, in spreads")
    parser.add_argument("--newton-worlds", type=int, default=64, help="most on a CPU")
    parser.add_argument("--json", help="also write the numbers to this file")
    args = parser.parse_args()
    if args.what == "analytic":
        analytic()
    elif args.what == "speed":
        speed(args.newton_worlds)
    elif args.what == "agreement":
        agreement(args.documents, args.samples, args.spread, args.json)
    else:
        gradients(args.documents, args.samples, args.spread, args.width, args.json)


if __name__ == "__main__":
    main()
