"""The record of one scene as arrays: what the kernels search and the judge reads."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from esg.layout.problem.edges import Term
from esg.layout.problem.joined import Joined
from esg.layout.problem.obstacles import Obstacle
from esg.layout.problem.supports import Shape, SupportMap
from esg.layout.problem.units import Unit

PARAMS = 6


@dataclass(frozen=True)
class LayoutProblem:
    """Arrays of one scene (lengths in cm, angles in rad).

    `names` lists the real nodes; nodes beyond them are corridors of planned motion. Units are in
    placement order (parents and what others depend on first); node indices are local. `ground` are
    the nodes that are the ground itself, `falling` those that fall in the story, `terms_of` the
    terms of each relation, `joined` what joints fix.
    """

    names: tuple[str, ...]
    units: tuple[Unit, ...]
    supports: SupportMap
    shape: dict[str, Shape]
    terms: tuple[Term, ...]
    obstacles: tuple[Obstacle, ...]
    notes: tuple[str, ...]
    ground: frozenset[str]
    falling: frozenset[str]
    terms_of: dict[str, list[Term]]
    joined: Joined
    node_unit: np.ndarray
    node_rel: np.ndarray
    node_z: np.ndarray
    node_half: np.ndarray
    node_round: np.ndarray
    node_height: np.ndarray
    node_radius: np.ndarray
    prim_off: np.ndarray
    prim_kind: np.ndarray
    prim_pose: np.ndarray
    prim_half: np.ndarray
    prim_z: np.ndarray
    unit_parent: np.ndarray
    unit_free: np.ndarray
    unit_pose: np.ndarray
    unit_box: np.ndarray
    unit_anchor: np.ndarray
    unit_center: np.ndarray
    unit_step: np.ndarray
    aff: list[list[int]]
    unit_edges: list[list[int]]
    unit_pairs: list[list[int]]
    edge_kind: np.ndarray
    edge_node: np.ndarray
    edge_w: np.ndarray
    edge_p: np.ndarray
    pair: np.ndarray
    pair_margin: np.ndarray
    pair_avoid: np.ndarray
