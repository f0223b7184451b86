"""Joins scenes into one set of arrays with global indices, and such sets into larger ones."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

import numpy as np

from esg.layout.problem.record import PARAMS, LayoutProblem

Arrays = dict[str, np.ndarray]

LARGE_SHAPES = 8
"""Objects with more collision shapes count as large in the hybrid mode."""

COUNTED = {"node": "node_unit", "unit": "unit_parent", "edge": "edge_kind", "pair": "pair"}
PLAIN = {
    "node_z": 0, "node_round": 0, "node_height": 0, "node_radius": 0, "unit_step": 0,
    "node_half": 2, "prim_half": 2, "prim_z": 2, "unit_center": 2,
    "node_rel": 3, "prim_pose": 3, "unit_free": 3, "unit_pose": 3,
    "unit_box": 4, "unit_anchor": 4, "edge_p": PARAMS,
    "prim_kind": 0, "edge_kind": 0, "edge_w": 0, "pair_margin": 0, "pair_avoid": 0,
}  # fmt: skip
"""Arrays without indices and their widths (0: one value an entry)."""
SHIFTED = {"node_unit": "unit", "unit_parent": "node", "edge_node": "node", "pair": "node"}
"""Arrays of indices, -1 for none, and what they count."""
LISTS = {"aff": "node", "ue": "edge", "up": "pair"}
"""Lists per unit, as values and offsets, and what they index."""
OF_PROBLEM = {"ue": "unit_edges", "up": "unit_pairs"}


def pair_modes(problem: LayoutProblem, collision: str) -> np.ndarray:
    """Collision term of every pair: the runtime partition of the supplementary, shape [pairs].

    Corridors are always tested against proxies; a container's box does not exclude its content.
    """
    out = np.zeros(len(problem.pair), np.int32)
    if collision == "proxy":
        return out
    names = problem.names
    large = [len(problem.shape[n].prims) > LARGE_SHAPES for n in names]
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


def _starts(counts: Sequence[int]) -> np.ndarray:
    return np.concatenate([[0], np.cumsum(np.asarray(counts, np.int64))]).astype(np.int32)


def _shifted(parts: list[np.ndarray], by: np.ndarray) -> np.ndarray:
    """Adds each part's offset to its indices; -1 stays -1."""
    flat = np.concatenate(parts)
    add = np.repeat(by[: len(parts)], [len(p) for p in parts])
    if flat.ndim > 1:
        add = add[:, None]
    return np.where(flat >= 0, flat + add, -1).astype(np.int32)


def join(problems: Sequence[LayoutProblem], collision: str) -> Arrays:
    """Joins scenes.

    Args:
        problems: At least one.
        collision: Collision mode of every pair.

    Returns:
        Arrays by name; `scene_node`, `scene_unit`, `scene_edge`, `scene_pair` of shape [scenes + 1]
        say where each scene begins. Some may be empty.
    """
    data: Arrays = {k: np.concatenate([getattr(p, k) for p in problems]) for k in PLAIN}
    for key, name in COUNTED.items():
        data[f"scene_{key}"] = _starts([len(getattr(p, name)) for p in problems])
    for key, of in SHIFTED.items():
        data[key] = _shifted([getattr(p, key) for p in problems], data[f"scene_{of}"])
    prims = _starts([len(p.prim_kind) for p in problems])
    data["prim_off"] = np.concatenate(
        [prims[:1], _shifted([p.prim_off[1:] for p in problems], prims)]
    )
    for key, of in LISTS.items():
        rows = [getattr(p, OF_PROBLEM.get(key, key)) for p in problems]
        flat = [np.fromiter(chain.from_iterable(r), np.int32) for r in rows]
        data[key] = _shifted(flat, data[f"scene_{of}"])
        data[f"{key}_off"] = _starts([len(v) for r in rows for v in r])
    data["pair_mode"] = np.concatenate([pair_modes(p, collision) for p in problems])
    return data


def merge(sets: Sequence[Arrays]) -> Arrays:
    """Joins sets that `join` made; the scenes of a set keep their order."""
    if len(sets) == 1:
        return sets[0]
    data: Arrays = {k: np.concatenate([s[k] for s in sets]) for k in (*PLAIN, "pair_mode")}
    base = {k: _starts([int(s[f"scene_{k}"][-1]) for s in sets]) for k in COUNTED}

    def behind(key: str, by: np.ndarray) -> np.ndarray:
        return np.concatenate([by[:1], _shifted([s[key][1:] for s in sets], by)])

    for key in COUNTED:
        data[f"scene_{key}"] = behind(f"scene_{key}", base[key])
    for key, of in SHIFTED.items():
        data[key] = _shifted([s[key] for s in sets], base[of])
    data["prim_off"] = behind("prim_off", _starts([len(s["prim_kind"]) for s in sets]))
    for key, of in LISTS.items():
        data[key] = _shifted([s[key] for s in sets], base[of])
        data[f"{key}_off"] = behind(f"{key}_off", _starts([len(s[key]) for s in sets]))
    return data
