"""Runs the search kernels over a batch of scenes and starts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import os
from typing import Any

import numpy as np

from esg.layout.config import LayoutConfig
from esg.layout.problem.join import PLAIN, Arrays, join, merge
from esg.layout.problem.record import LayoutProblem

LANES = 8
"""Threads that share the candidates of a unit and the terms of an energy on a GPU."""
SCRATCH = 1 << 26
"""Poses that the gradients of one launch may copy: starts times units times nodes."""
COMPACT_EVERY = 10
"""Steps after which finished starts are taken out of the launches on a GPU."""


@dataclass(frozen=True)
class SearchResult:
    """What the starts of one scene found.

    Args:
        units: Unit poses in their parents' frames, shape [starts, units, 3] (cm, cm, rad).
        energy: Relation, collision and region energy, shape [starts, 3].
        initial: The same before refinement, shape [starts, 3].
        steps: Adam steps used, shape [starts].
    """

    units: np.ndarray
    energy: np.ndarray
    initial: np.ndarray
    steps: np.ndarray


@dataclass(frozen=True)
class Searched:
    """What a search of joined scenes found; scene by scene, within a scene start by start.

    Args:
        units: Unit poses, shape [starts x units, 3].
        energy: Relation, collision and region energy, shape [scenes x starts, 3].
        initial: The same before refinement.
        steps: Adam steps used, shape [scenes x starts].
    """

    units: np.ndarray
    energy: np.ndarray
    initial: np.ndarray
    steps: np.ndarray

    def split(self, unit_count: Sequence[int], starts: int) -> list[SearchResult]:
        """One result per scene, given every scene's number of units."""
        out = []
        at = 0
        for i, n in enumerate(unit_count):
            rows = slice(i * starts, (i + 1) * starts)
            units = self.units[at : at + starts * n].reshape(starts, n, 3).astype(float)
            at += starts * n
            out.append(SearchResult(units, self.energy[rows], self.initial[rows], self.steps[rows]))
        return out


def _warp() -> Any:
    """Warp, silent, because standard output belongs to the caller."""
    import warp as wp

    wp.config.log_level = wp.LOG_WARNING
    return wp


@dataclass(frozen=True)
class SearchRequest:
    """Joined scenes to search.

    Args:
        data: Scenes (`esg.layout.problem.join`).
        seeds: One per scene.
        unit_count: Units of every scene.
        config: Settings.
    """

    data: Arrays
    seeds: np.ndarray
    unit_count: tuple[int, ...]
    config: LayoutConfig


@dataclass(frozen=True)
class EvaluateRequest:
    """Joined scenes whose energies are wanted at given unit poses, shape [units, 3]."""

    data: Arrays
    units: np.ndarray
    config: LayoutConfig


Request = SearchRequest | EvaluateRequest


def answer(requests: Sequence[Request]) -> list[Any]:
    """Serves requests; searches with equal settings share their launches.

    Returns:
        `Searched` or energies of shape [scenes, 3], in the order of the requests.
    """
    out: list[Any] = [None] * len(requests)
    groups: dict[LayoutConfig, list[int]] = {}
    for i, r in enumerate(requests):
        if isinstance(r, EvaluateRequest):
            out[i] = evaluate_arrays(r.data, r.units, r.config)
        else:
            groups.setdefault(r.config, []).append(i)
    for config, members in groups.items():
        rs = [requests[i] for i in members]
        sizes = [
            int((np.diff(r.data["scene_node"]) * np.diff(r.data["scene_unit"])).sum())
            * config.starts
            for r in rs
        ]
        for part in batches(sizes):
            found = search_arrays(
                merge([r.data for r in rs[part]]),
                np.concatenate([r.seeds for r in rs[part]]),  # type: ignore[union-attr]  # searches
                config,
            )
            unit = row = 0
            for i in members[part]:
                r = requests[i]
                assert isinstance(r, SearchRequest)
                units = slice(unit, unit + sum(r.unit_count) * config.starts)
                rows = slice(row, row + len(r.unit_count) * config.starts)
                unit, row = units.stop, rows.stop
                out[i] = Searched(
                    found.units[units], found.energy[rows], found.initial[rows], found.steps[rows]
                )
    return out


VECTORS = {"edge_node": 3, "pair": 2}


def _upload(data: Arrays, device: str) -> Any:
    """Copies joined scenes to the device, as the kernels' struct."""
    wp = _warp()
    from esg.layout.kernels.planar import Problem

    floats = {2: wp.vec2, 3: wp.vec3, 4: wp.vec4}
    ints = {2: wp.vec2i, 3: wp.vec3i}
    problem = Problem()
    for key, value in data.items():
        width = PLAIN.get(key, VECTORS.get(key, 0))
        if len(value) == 0:  # Warp dislikes empty arrays
            value = np.zeros((1, width) if width else (1,), value.dtype)
        is_int = value.dtype == np.int32
        scalar = wp.int32 if is_int else wp.float32
        dtype = scalar if key == "edge_p" else (ints if is_int else floats).get(width, scalar)
        setattr(problem, key, wp.array(value, dtype=dtype, device=device))
    return problem


def evaluate(
    problems: Sequence[LayoutProblem], units: Sequence[np.ndarray], config: LayoutConfig
) -> np.ndarray:
    """Energies of given layouts.

    Args:
        problems: Scenes.
        units: Unit poses per scene, shape [units, 3].
        config: Collision mode and weights.

    Returns:
        Relation, collision and region energy, shape [scenes, 3].
    """
    return evaluate_arrays(join(problems, config.collision), np.concatenate(units), config)


def evaluate_arrays(data: Arrays, units: np.ndarray, config: LayoutConfig) -> np.ndarray:
    """`evaluate` for joined scenes; unit poses of shape [units, 3]."""
    wp = _warp()
    from esg.layout.kernels import evaluation

    problem = _upload(data, config.device)
    scenes = len(data["scene_node"]) - 1
    x = wp.array(units.astype(np.float32), dtype=wp.vec3, device=config.device)
    w = wp.zeros(int(data["scene_node"][-1]), dtype=wp.vec3, device=config.device)
    energy = wp.zeros(scenes, dtype=wp.vec3, device=config.device)
    wp.launch(
        evaluation.evaluate,
        dim=scenes,
        inputs=[problem, config.alignment_weight, x, w, energy],
        device=config.device,
    )
    return energy.numpy()


def run_search(
    problems: Sequence[LayoutProblem], seeds: Sequence[int], config: LayoutConfig
) -> list[SearchResult]:
    """Searches all scenes with `config.starts` starts each.

    Args:
        problems: Scenes.
        seeds: One per scene.
        config: Settings.

    Returns:
        One result per scene.
    """
    out: list[SearchResult] = []
    seeds = list(seeds)
    for part in batches([len(p.units) * len(p.node_unit) * config.starts for p in problems]):
        found = search_arrays(
            join(problems[part], config.collision), np.asarray(seeds[part]), config
        )
        out += found.split([len(p.units) for p in problems[part]], config.starts)
    return out


def batches(sizes: Sequence[int]) -> Iterator[slice]:
    """Cuts scenes into runs whose gradients together copy at most `SCRATCH` poses."""
    first, total = 0, 0
    for i, size in enumerate(sizes):
        if total + size > SCRATCH and i > first:
            yield slice(first, i)
            first, total = i, 0
        total += size
    if first < len(sizes):
        yield slice(first, len(sizes))


def search_arrays(
    data: Arrays, seeds: np.ndarray, config: LayoutConfig, staged: bool | None = None
) -> Searched:
    """`run_search` for joined scenes, in one batch.

    Args:
        data: Joined scenes (`esg.layout.problem.join`).
        seeds: Shape [scenes].
        config: Settings.
        staged: Whether many threads share a start; None does on a GPU.

    Returns:
        What all starts found.
    """
    wp = _warp()
    from esg.layout.kernels.proposals import Settings

    settings = Settings()
    settings.candidates = config.candidates
    settings.iterations = config.iterations if config.refine else 0
    settings.sample = int(config.sample_init)
    settings.tolerance = config.tolerance
    settings.soft = config.alignment_weight
    settings.preference = config.preference_weight if config.preference else 0.0
    k = config.starts
    scene = np.repeat(np.arange(len(seeds)), k)
    node_off = np.concatenate([[0], np.cumsum(np.diff(data["scene_node"])[scene])])
    unit_off = np.concatenate([[0], np.cumsum(np.diff(data["scene_unit"])[scene])])
    seed = (np.asarray(seeds, np.int64)[:, None] % 2**31) * 65537 + np.arange(k) * 101 + 1
    where = [scene, (seed % 2**30).ravel(), node_off, unit_off]
    if staged is None:
        staged = wp.get_device(config.device).is_cuda
    problem = _upload(data, config.device)
    if staged:
        return _staged(problem, data, settings, where, config.device)
    return _sequential(problem, settings, where, config)


def _sequential(
    problem: Any, settings: Any, where: list[np.ndarray], config: LayoutConfig
) -> Searched:
    """One thread searches one start; starts are shared between the threads of a CPU."""
    wp = _warp()
    from esg.layout.kernels import cpu as kernels

    device = config.device
    threads = len(where[0])
    nodes, units = int(where[2][-1]), int(where[3][-1])

    def vec(n: int) -> Any:
        return wp.zeros(max(1, n), dtype=wp.vec3, device=device)

    scene, seed, node, unit = (
        wp.array(v[:threads].astype(np.int32), dtype=wp.int32, device=device) for v in where
    )
    x, w, energy, initial = vec(units), vec(nodes), vec(threads), vec(threads)
    steps = wp.zeros(threads, dtype=wp.int32, device=device)
    memory = [vec(units) for _ in range(4)]
    wp.load_module(kernels, device=device)

    def launch(first: int, count: int) -> None:
        wp.launch(
            kernels.initialize,
            dim=count,
            inputs=[first, problem, settings, scene, seed, node, unit],
            outputs=[x, w],
            device=device,
        )
        wp.launch(
            kernels.refine,
            dim=count,
            inputs=[first, problem, settings, scene, node, unit],
            outputs=[x, *memory, w, energy, initial, steps],
            device=device,
        )

    workers = min(config.threads, os.cpu_count() or 1, threads)
    if wp.get_device(device).is_cpu and workers > 1:
        # a launch on the CPU is one loop over the starts and releases the interpreter
        cuts = np.linspace(0, threads, 4 * workers + 1).astype(int).tolist()
        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(launch, cuts[:-1], np.diff(cuts).tolist()))
    else:
        launch(0, threads)
    return Searched(
        x.numpy()[:units], energy.numpy()[:threads], initial.numpy()[:threads], steps.numpy()
    )


def _staged(
    problem: Any,
    data: Arrays,
    settings: Any,
    where: list[np.ndarray],
    device: str,
    lanes: int = LANES,
) -> Searched:
    """Many threads share a start: a few small launches per unit and per step."""
    wp = _warp()
    from esg.layout.kernels import gpu as stages

    threads = len(where[0])
    nodes, units = int(where[2][-1]), int(where[3][-1])
    n = np.diff(data["scene_node"])[where[0]].astype(np.int64)
    u = np.diff(data["scene_unit"])[where[0]].astype(np.int64)
    most = int(u.max(initial=0))
    scratch_w, scratch_x = np.cumsum(n * u) - n * u, np.cumsum(u * u) - u * u

    def vec(count: int) -> Any:
        return wp.zeros(max(1, count), dtype=wp.vec3, device=device)

    def number(values: np.ndarray) -> Any:
        return wp.array(values[:threads].astype(np.int32), dtype=wp.int32, device=device)

    a = stages.Starts()
    a.scene, a.seed, a.node, a.unit = (number(v) for v in where)
    a.scratch_w, a.scratch_x = number(scratch_w), number(scratch_x)
    a.lowest = wp.zeros(threads, dtype=wp.float32, device=device)
    a.mark = wp.zeros(threads, dtype=wp.float32, device=device)
    a.done = wp.zeros(threads, dtype=wp.int32, device=device)
    a.steps = wp.zeros(threads, dtype=wp.int32, device=device)
    a.energy, a.initial, a.w = vec(threads), vec(threads), vec(nodes)
    a.x, a.best, a.m1, a.m2, a.grad = (vec(units) for _ in range(5))

    def launch(kernel: Any, dim: int, *inputs: Any) -> None:
        wp.launch(kernel, dim=dim, inputs=[problem, settings, a, *inputs], device=device)

    wp.load_module(stages, device=device)
    size = (2, threads * lanes)
    found = [
        wp.zeros(size, dtype=wp.float32, device=device),
        wp.zeros(size, dtype=wp.int32, device=device),
        wp.zeros(size, dtype=wp.vec3, device=device),
    ]
    own = [vec(units * lanes), vec(nodes * lanes)]
    for i in range(most + 1):
        launch(stages.place, threads * lanes, i, lanes, *own, *found)
    del own, found

    xs, ws = vec(int((u * u).sum())), vec(int((n * u).sum()))
    part = wp.zeros((lanes, threads), dtype=wp.vec3, device=device)
    alive = np.arange(threads)
    active = number(alive)
    for it in range(settings.iterations + 1):
        count = len(alive)
        if it > 0:
            launch(stages.slope, count * most, active, count, xs, ws)
            launch(stages.step, count, active, it - 1)
        launch(stages.measure, count * lanes, active, count, lanes, part)
        launch(stages.assess, count, active, lanes, part, it)
        if it % COMPACT_EVERY == 0:
            done = a.done.numpy()
            alive = alive[done[alive] == 0]
            if len(alive) == 0:
                break
            active = number(alive)
    return Searched(
        a.best.numpy()[:units], a.energy.numpy()[:threads], a.initial.numpy()[:threads],
        a.steps.numpy()[:threads],
    )  # fmt: skip
