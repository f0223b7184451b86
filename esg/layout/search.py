"""Runs the search kernel over a batch of scenes and starts."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import os
from typing import Any

import numpy as np

from esg.layout.config import LayoutConfig
from esg.layout.problem import LayoutProblem


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


def _csr(
    parts: Sequence[Sequence[Sequence[int]]], bases: Sequence[int]
) -> tuple[np.ndarray, np.ndarray]:
    flat: list[int] = []
    off = [0]
    for part, base in zip(parts, bases, strict=True):
        for row in part:
            flat += [base + v for v in row]
            off.append(len(flat))
    return np.asarray(off, np.int32), np.asarray(flat or [0], np.int32)


def concatenate(problems: Sequence[LayoutProblem]) -> dict[str, np.ndarray]:
    """Joins scenes into one set of arrays with global indices."""

    def base(counts: list[int]) -> list[int]:
        return [0, *np.cumsum(counts).tolist()]

    nodes = base([len(p.node_unit) for p in problems])
    units = base([len(p.units) for p in problems])
    edges = base([len(p.edge_kind) for p in problems])
    pairs = base([len(p.pair) for p in problems])
    prims = base([len(p.prim_kind) for p in problems])

    def cat(name: str, width: int = 0) -> np.ndarray:
        out = np.concatenate([getattr(p, name) for p in problems])
        if len(out) == 0:  # Warp dislikes empty arrays
            out = np.zeros((1, width) if width else (1,), out.dtype)
        return out

    def shift(name: str, by: list[int], width: int = 0) -> np.ndarray:
        rows = [
            np.where(getattr(p, name) >= 0, getattr(p, name) + o, -1)
            for p, o in zip(problems, by, strict=False)
        ]
        out = np.concatenate(rows).astype(np.int32)
        if len(out) == 0:
            out = np.zeros((1, width) if width else (1,), np.int32)
        return out

    data = {k: cat(k) for k in ("node_z", "node_round", "node_height", "node_radius", "unit_step")}
    data |= {k: cat(k, 2) for k in ("node_half", "prim_half", "prim_z", "unit_center")}
    data |= {k: cat(k, 3) for k in ("node_rel", "prim_pose", "unit_free", "unit_pose")}
    data |= {k: cat(k, 4) for k in ("unit_box", "unit_anchor")}
    data |= {k: cat(k) for k in ("prim_kind", "edge_kind", "edge_w", "pair_margin", "pair_avoid")}
    data["edge_p"] = cat("edge_p", 6)
    data["node_unit"] = shift("node_unit", units)
    data["unit_parent"] = shift("unit_parent", nodes)
    data["edge_node"] = shift("edge_node", nodes, 3)
    data["pair"] = shift("pair", nodes, 2)
    data["prim_off"] = np.concatenate(
        [[0], *[p.prim_off[1:] + o for p, o in zip(problems, prims, strict=False)]]
    ).astype(np.int32)
    data["aff_off"], data["aff"] = _csr([p.aff for p in problems], nodes[:-1])
    data["ue_off"], data["ue"] = _csr([p.unit_edges for p in problems], edges[:-1])
    data["up_off"], data["up"] = _csr([p.unit_pairs for p in problems], pairs[:-1])
    for key, value in (("node", nodes), ("unit", units), ("edge", edges), ("pair", pairs)):
        data[f"scene_{key}"] = np.asarray(value, np.int32)
    return data


LARGE_SHAPES = 8
"""Objects with more collision shapes count as large in the hybrid mode."""


def pair_modes(problem: LayoutProblem, collision: str) -> np.ndarray:
    """Collision term of every pair: the runtime partition of the supplementary, shape [pairs].

    Corridors are always tested against proxies; a container's box does not exclude its content.
    """
    names = problem.names
    large = [len(problem.shape[n].prims) > LARGE_SHAPES for n in names]
    out = np.zeros(len(problem.pair), np.int32)
    if collision == "proxy":
        return out
    for k, (a, b) in enumerate(problem.pair.tolist()):
        if b >= len(names):
            continue
        la, lb = large[a], large[b]
        carried = names[a] in problem.supports.chain(names[b]) or names[
            b
        ] in problem.supports.chain(names[a])
        if collision == "aabb" or (collision == "hybrid" and la and lb):
            out[k] = 0 if carried else 1
        elif collision == "sdf" or carried or not (la or lb):
            out[k] = 2
        else:
            out[k] = 3 if la else 4
    return out


def _warp() -> tuple[Any, Any]:
    """Warp and the kernels; silent, because standard output belongs to the caller."""
    import warp as wp

    wp.config.log_level = wp.LOG_WARNING
    from esg.layout import kernels

    return wp, kernels


def _upload(
    problems: Sequence[LayoutProblem], config: LayoutConfig
) -> tuple[Any, dict[str, np.ndarray]]:
    """Copies a batch to the device: the kernel's struct and the arrays on the host."""
    wp, kernels = _warp()
    device = config.device
    data = concatenate(problems)
    data["pair_mode"] = np.concatenate([pair_modes(p, config.collision) for p in problems] or [[]])
    if len(data["pair_mode"]) == 0:
        data["pair_mode"] = np.zeros(1, np.int32)
    vectors: dict[str, Any] = {
        "unit_center": wp.vec2,
        "node_half": wp.vec2, "prim_half": wp.vec2, "prim_z": wp.vec2, "node_rel": wp.vec3,
        "prim_pose": wp.vec3, "unit_free": wp.vec3, "unit_pose": wp.vec3, "unit_anchor": wp.vec4,
        "unit_box": wp.vec4, "edge_node": wp.vec3i, "pair": wp.vec2i,
    }  # fmt: skip
    problem = kernels.Problem()
    for key, value in data.items():
        dtype = vectors.get(key, wp.int32 if value.dtype == np.int32 else wp.float32)
        setattr(problem, key, wp.array(value, dtype=dtype, device=device))
    return problem, data


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
    wp, kernels = _warp()
    problem, data = _upload(problems, config)
    x = wp.array(np.concatenate(units).astype(np.float32), dtype=wp.vec3, device=config.device)
    w = wp.zeros(int(data["scene_node"][-1]), dtype=wp.vec3, device=config.device)
    energy = wp.zeros(len(problems), dtype=wp.vec3, device=config.device)
    wp.launch(
        kernels.evaluate,
        dim=len(problems),
        inputs=[problem, config.alignment_weight, x, w, energy],
        device=config.device,
    )
    return energy.numpy()


def run_search(
    problems: Sequence[LayoutProblem], seeds: Sequence[int], config: LayoutConfig
) -> list[SearchResult]:
    """Searches all scenes with `config.starts` starts each in one launch.

    Args:
        problems: Scenes.
        seeds: One per scene.
        config: Settings.

    Returns:
        One result per scene.
    """
    wp, kernels = _warp()
    device = config.device
    problem, data = _upload(problems, config)
    settings = kernels.Settings()
    settings.candidates = config.candidates
    settings.iterations = config.iterations if config.refine else 0
    settings.sample = int(config.sample_init)
    settings.tolerance = config.tolerance
    settings.soft = config.alignment_weight
    settings.preference = config.preference_weight if config.preference else 0.0

    k = config.starts
    node_count = np.diff(data["scene_node"])
    unit_count = np.diff(data["scene_unit"])
    scene = np.repeat(np.arange(len(problems)), k)
    node_off = np.concatenate([[0], np.cumsum(node_count[scene])])
    unit_off = np.concatenate([[0], np.cumsum(unit_count[scene])])
    seed = np.concatenate(
        [(np.int64(s % 2**31) * 65537 + np.arange(k) * 101 + 1) % (2**30) for s in seeds]
    )
    threads = len(scene)

    def array(values: np.ndarray) -> Any:
        return wp.array(values.astype(np.int32), dtype=wp.int32, device=device)

    def vec(n: int) -> Any:
        return wp.zeros(max(1, int(n)), dtype=wp.vec3, device=device)

    x = vec(unit_off[-1])
    energy, initial = vec(threads), vec(threads)
    steps = wp.zeros(threads, dtype=wp.int32, device=device)
    where = [array(scene), array(seed), array(node_off[:-1]), array(unit_off[:-1])]
    w = vec(node_off[-1])
    memory = [vec(unit_off[-1]) for _ in range(4)]
    wp.load_module(kernels, device=device)

    def launch(first: int, count: int) -> None:
        wp.launch(
            kernels.initialize,
            dim=count,
            inputs=[first, problem, settings, *where],
            outputs=[x, w],
            device=device,
        )
        wp.launch(
            kernels.refine,
            dim=count,
            inputs=[first, problem, settings, where[0], *where[2:]],
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
    x_np, e_np, i_np, s_np = x.numpy(), energy.numpy(), initial.numpy(), steps.numpy()
    out = []
    for i, p in enumerate(problems):
        rows = slice(i * k, (i + 1) * k)
        n = len(p.units)
        units = x_np[unit_off[i * k] : unit_off[(i + 1) * k]].reshape(k, n, 3)
        out.append(SearchResult(units.astype(float), e_np[rows], i_np[rows], s_np[rows]))
    return out
