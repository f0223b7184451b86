"""Whether the members of a plural stand as its pattern says: in a row, stacked, racked."""

from __future__ import annotations

import itertools
import math

import numpy as np

from esg.graph.models import EsgDocument, RelationReport
from esg.layout.judge.check import World, report
from esg.layout.problem.patterns import arrange
from esg.layout.problem.record import LayoutProblem
from esg.layout.problem.units import group_members

LINES = ("row", "column", "queue")
TRIANGLES = ("pins", "rack")
OFF_LINE_CM = 3.0
"""How far a member may be off its row, as of `align` (docs/layout/energy.md)."""
UNEVEN = 2.0
"""How many times the narrowest step of a row its widest may be, besides one member's width."""
LOOSE = 1.25
"""How far apart members of a triangle may be, by the width of their own arrangement."""


def pattern_reports(
    doc: EsgDocument, problem: LayoutProblem, world: World
) -> tuple[RelationReport, ...]:
    """One report for each group that does not stand in its pattern.

    A group without an arrangement of its own (scattered) has none to break; two at a stated
    distance keep that.
    """
    out: list[RelationReport] = []
    nodes = doc.spatial_relation_graph.nodes
    edges = doc.spatial_relation_graph.edges.binary_relations
    spaced = [{e.from_, e.to} for e in edges if e.distance_cm is not None]
    for members in group_members(doc).values():
        pattern = next((p for m in members if (p := nodes[m].group_pattern)), "scatter")
        if len(members) == 2 and set(members) in spaced:
            continue
        off = _off(pattern, members, problem, world)
        if off > 0.0:
            out.append(report(f"{','.join(members)} {pattern}", pattern, off, ""))
    return tuple(out)


def _off(pattern: str, members: list[str], problem: LayoutProblem, world: World) -> float:
    """How far a group is from its pattern [cm]; 0 if it stands in it."""
    if len(members) < 2:
        return 0.0
    if pattern == "stack":
        apart = [m for m in members if problem.supports.of[m].parent not in members]
        return 0.0 if len(apart) == 1 else math.inf
    at = np.array([world.pose[m][:2] for m in members])
    shapes = [problem.shape[m] for m in members]
    widest = 2.0 * max(max(s.hx, s.hy) for s in shapes)
    if pattern not in (*LINES, *TRIANGLES):
        return 0.0
    sizes = [(2.0 * s.hx, 2.0 * s.hy, s.height) for s in shapes]
    own = np.array(arrange(pattern, sizes, np.random.default_rng(0)))[:, :2]
    if pattern in TRIANGLES:
        return max(0.0, _width(at) - LOOSE * _width(own))
    return _off_line(at, widest, _width(own) / (len(own) - 1))


def _off_line(at: np.ndarray, widest: float, step: float) -> float:
    """How far points [members, 2] are from even steps along one line [cm].

    Args:
        step: Between neighbours as their own arrangement has them [cm]; asked of two only.
    """
    if len(at) == 2:
        return max(0.0, _width(at) - UNEVEN * step)
    middle = at - at.mean(axis=0)
    along, across = np.linalg.svd(middle)[2]
    aside = float(np.abs(middle @ across).max()) - max(OFF_LINE_CM, 0.25 * widest)
    steps = np.diff(np.sort(middle @ along))
    return max(aside, float(steps.max() - UNEVEN * steps.min()) - widest, 0.0)


def _width(at: np.ndarray) -> float:
    return max(math.dist(a, b) for a, b in itertools.combinations(at.tolist(), 2))
