"""Agreement of the engines with PhysX at 240 Hz, and their speed: `python -m benchmarks.engines`.

Two scenes with many random programs, none of them chosen for margin: a chain of three balls, and a
car that sends a bin into a table. Agreement is measured on contact events: whether the same pairs
touch first in the same order, when, and how fast the second body leaves.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
import json
import math
import time

import numpy as np

from esg.engines import get_engine
from esg.engines.program import HoldVelocity, Program, ProgramBatch, SetVelocity, batch_programs
from esg.engines.scene import Body, Rollout, Shape, SimScene

VERIFY_DT = 1.0 / 240.0
SETTLE_S = 0.1
"""Speeds after a hit are compared this long after it."""


@dataclass(frozen=True)
class Case:
    """A scene, how to draw random programs for it, and the chain of pairs that should touch."""

    scene: SimScene
    chain: tuple[tuple[str, str], ...]
    duration: float

    def programs(self, n: int, seed: int) -> list[Program]:
        rng = np.random.default_rng(seed)
        if self.scene.scene_id == "balls":
            return [self._ball_program(rng) for _ in range(n)]
        return [self._car_program(rng) for _ in range(n)]

    def _ball_program(self, rng: np.random.Generator) -> Program:
        speed, heading = rng.uniform(1.0, 6.0), rng.uniform(-0.05, 0.12)
        v = (speed * math.cos(heading), speed * math.sin(heading), 0.0)
        spin = (-v[1] / 0.11, v[0] / 0.11, 0.0)
        return Program((SetVelocity("a", 0.0, v, spin),), self.duration)

    def _car_program(self, rng: np.random.Generator) -> Program:
        speed, heading = rng.uniform(6.0, 14.0), rng.uniform(-0.03, 0.03)
        hold = HoldVelocity("car", 0.0, math.inf, speed, heading, until_contact=("bin",))
        return Program((hold,), self.duration)


def _diagonal(values: list[float]) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(float(v) for v in row) for row in np.diag(values))


def _ball(name: str, radius: float, mass: float, xy: tuple[float, float]) -> Body:
    return Body(
        name, False, mass, _diagonal([0.4 * mass * radius**2] * 3),
        (Shape("sphere", (radius, radius, radius)),), (xy[0], xy[1], radius), friction=0.2,
        restitution=0.8, roll_radius=radius,
    )  # fmt: skip


def _box_inertia(half: tuple[float, float, float], mass: float) -> tuple[tuple[float, ...], ...]:
    x, y, z = (2.0 * h for h in half)
    return _diagonal([mass / 12 * k for k in (y * y + z * z, x * x + z * z, x * x + y * y)])


def balls() -> Case:
    bodies = (
        _ball("a", 0.11, 0.43, (0.0, 0.0)),
        _ball("b", 0.11, 0.43, (1.5, 0.05)),
        _ball("c", 0.11, 0.43, (2.8, 0.2)),
    )
    scene = SimScene("balls", bodies, ground_friction=0.4)
    return Case(scene, (("a", "b"), ("b", "c")), 4.0)


def car_bin_table() -> Case:
    half = (2.25, 0.9, 0.75)
    car = Body(
        "car", False, 1200.0, _box_inertia(half, 1200.0), (Shape("box", half),),
        (-9.0, 0.0, 0.75), friction=0.3, restitution=0.1, linear_damping=0.5, wheeled=True,
    )  # fmt: skip
    r, h, m = 0.3, 0.5, 15.0
    lateral = m / 12 * (3 * r * r + 4 * h * h)
    bin_ = Body(
        "bin", False, m, _diagonal([lateral, lateral, m * r * r / 2]),
        (Shape("cylinder", (r, r, h)),), (0.0, 0.0, h), friction=0.3, restitution=0.2,
    )  # fmt: skip
    top, leg = (0.9, 0.75, 0.03), (0.05, 0.05, 0.35)
    legs = tuple(Shape("box", leg, (x, y, -0.03)) for x in (-0.8, 0.8) for y in (-0.65, 0.65))
    table = Body(
        "table", False, 40.0, _box_inertia((0.9, 0.75, 0.38), 40.0),
        (Shape("box", top, (0.0, 0.0, 0.35)), *legs), (3.9, 0.2, 0.38), friction=0.6,
        restitution=0.2,
    )  # fmt: skip
    scene = SimScene("car-bin-table", (car, bin_, table))
    return Case(scene, (("car", "bin"), ("bin", "table")), 4.0)


def first_hits(case: Case, rollout: Rollout) -> np.ndarray:
    """First contact time of each pair of the chain, in order, shape [W, K]; NaN if never."""
    log, names = rollout.contacts, case.scene.names
    out = np.full((len(rollout.valid), len(case.chain)), np.nan)
    for k, pair in enumerate(case.chain):
        a, b = sorted(names.index(n) for n in pair)
        rows = (log.a == a) & (log.b == b)
        for w in range(len(out)):
            times = log.time[rows & (log.world == w)]
            if k and not np.isnan(out[w, k - 1]):
                times = times[times > out[w, k - 1]]
            if len(times) and (k == 0 or not np.isnan(out[w, k - 1])):
                out[w, k] = times[0]
    return out


def speed_after(case: Case, rollout: Rollout, hits: np.ndarray) -> np.ndarray:
    """Speed of the first hit's struck body SETTLE_S after it [m/s], shape [W]."""
    i = case.scene.names.index(case.chain[0][1])
    speed = np.linalg.norm(rollout.linear_velocity[:, :, i], axis=-1)
    frame = np.searchsorted(rollout.time, np.nan_to_num(hits[:, 0]) + SETTLE_S)
    return speed[np.arange(len(hits)), np.minimum(frame, speed.shape[1] - 1)]


def impulse_of_first(case: Case, rollout: Rollout, hits: np.ndarray) -> np.ndarray:
    """Normal impulse of the first pair within SETTLE_S of its first hit [N s], shape [W]."""
    log, names = rollout.contacts, case.scene.names
    a, b = sorted(names.index(n) for n in case.chain[0])
    rows = (log.a == a) & (log.b == b)
    near = rows & (log.time <= hits[log.world, 0] + SETTLE_S)
    return np.bincount(log.world[near], log.impulse[near], minlength=len(hits))


def compare(case: Case, reference: Rollout, other: Rollout) -> dict[str, float]:
    """How another engine's contact events differ from the reference's."""
    t0, t1 = first_hits(case, reference), first_hits(case, other)
    both0 = ~np.isnan(t0[:, 0]) & ~np.isnan(t1[:, 0])
    both1 = ~np.isnan(t0[:, 1]) & ~np.isnan(t1[:, 1])
    v0, v1 = speed_after(case, reference, t0), speed_after(case, other, t1)
    j0, j1 = impulse_of_first(case, reference, t0), impulse_of_first(case, other, t1)
    late, fast = np.abs(t1 - t0), np.abs(v1 - v0)[both0]
    share = np.abs(j1 - j0)[both0] / np.maximum(j0[both0], 1e-9)
    return {
        "first_agrees": float(np.mean(np.isnan(t0[:, 0]) == np.isnan(t1[:, 0]))),
        "second_agrees": float(np.mean(np.isnan(t0[:, 1]) == np.isnan(t1[:, 1]))),
        "first_dt_ms_median": 1e3 * _median(late[both0, 0]),
        "first_dt_ms_max": 1e3 * _max(late[both0, 0]),
        "second_dt_ms_median": 1e3 * _median(late[both1, 1]),
        "second_dt_ms_max": 1e3 * _max(late[both1, 1]),
        "speed_mps_median": _median(fast),
        "speed_mps_max": _max(fast),
        "impulse_share_median": _median(share),
        "impulse_share_max": _max(share),
    }


def _median(x: np.ndarray) -> float:
    return float(np.median(x)) if len(x) else math.nan


def _max(x: np.ndarray) -> float:
    return float(x.max()) if len(x) else math.nan


def throughput(
    case: Case, name: str, dt: float, record_every: int, n: int, repeats: int
) -> tuple[float, float]:
    """Simulated seconds per second of wall time and per second of processor time, warm."""
    engine = get_engine(name)
    batch = batch_programs(case.programs(n, 1), case.scene.names)
    engine.rollout(case.scene, batch, dt=dt, record_every=record_every, duration=0.1)
    wall = busy = math.inf
    for _ in range(repeats):
        start, start_busy = time.perf_counter(), time.process_time()
        engine.rollout(case.scene, batch, dt=dt, record_every=record_every)
        wall = min(wall, time.perf_counter() - start)
        busy = min(busy, time.process_time() - start_busy)
    return n * case.duration / wall, n * case.duration / busy


def _batch(case: Case, n: int) -> ProgramBatch:
    return batch_programs(case.programs(n, 0), case.scene.names)


def main() -> None:
    """Prints the tables of docs/results/engines.md."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=int, default=48)
    parser.add_argument("--repeats", type=int, default=2)
    parser.add_argument("--json", help="also write the numbers to this file")
    args = parser.parse_args()
    variants = [
        ("physx", 480), ("physx", 960), ("newton", 120), ("newton", 240), ("newton", 480),
        ("rapier", 240),
    ]  # fmt: skip
    report: dict[str, list[dict[str, object]]] = {"agreement": [], "speed": []}
    print("| scene | engine, rate | 1st / 2nd event agrees | 1st event, ms | 2nd event, ms | "
          "speed after, m/s | impulse |\n| --- | --- | --- | --- | --- | --- | --- |")  # fmt: skip
    for case in (balls(), car_bin_table()):
        batch = _batch(case, args.programs)
        reference = get_engine("physx").rollout(case.scene, batch, dt=VERIFY_DT)
        for name, rate in variants:
            other = get_engine(name).rollout(
                case.scene, batch, dt=1.0 / rate, record_every=max(1, rate // 240)
            )
            r = compare(case, reference, other)
            report["agreement"].append(
                {"scene": case.scene.scene_id, "engine": name, "rate": rate, **r}
            )
            print(
                f"| {case.scene.scene_id} | {name} {rate} Hz | {r['first_agrees']:.0%} / "
                f"{r['second_agrees']:.0%} | {r['first_dt_ms_median']:.0f} / "
                f"{r['first_dt_ms_max']:.0f} | {r['second_dt_ms_median']:.0f} / "
                f"{r['second_dt_ms_max']:.0f} | {r['speed_mps_median']:.2f} / "
                f"{r['speed_mps_max']:.2f} | {r['impulse_share_median']:.1%} / "
                f"{r['impulse_share_max']:.0%} |",
                flush=True,
            )
    print(
        "\n| scene | engine, rate | worlds | simulated s per s | per processor s |\n"
        "| --- | --- | --- | --- | --- |"
    )
    for case in (balls(), car_bin_table()):
        for name, rate, n in [
            ("newton", 240, 1), ("newton", 240, 16), ("newton", 240, 64), ("newton", 120, 64),
            ("newton", 480, 64), ("physx", 240, 8), ("rapier", 240, 8),
        ]:  # fmt: skip
            every = rate // 60 if name == "newton" else 1
            wall, busy = throughput(case, name, 1.0 / rate, every, n, args.repeats)
            report["speed"].append(
                {
                    "scene": case.scene.scene_id,
                    "engine": name,
                    "rate": rate,
                    "worlds": n,
                    "per_wall_s": wall,
                    "per_processor_s": busy,
                }
            )
            print(
                f"| {case.scene.scene_id} | {name} {rate} Hz | {n} | {wall:.0f} | {busy:.0f} |",
                flush=True,
            )
    if args.json:
        with open(args.json, "w") as file:
            json.dump(report, file, indent=2)


if __name__ == "__main__":
    main()
