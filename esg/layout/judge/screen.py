"""Judges many layouts at once: which of them are beyond doubt right.

A layout passes if every relation holds and no two shapes overlap, by more than rounding. Then its
report is known beforehand. All others go to `esg.layout.judge.check`, which says what is wrong and
by how much; whatever only few scenes have (planned paths, supports that do not fit) goes there too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from esg.graph.models import BinaryRelation, EsgDocument, MultiRelationType, RelationReport
from esg.graph.models import RelationType as R
from esg.layout.judge.check import (
    HARD,
    World,
    binary_violation,
    centre_tolerance,
    distance_range,
    edge_names,
    held_by_support,
    report,
)
from esg.layout.judge.resting import carried, centre_offset, is_solid
from esg.layout.problem import terms
from esg.layout.problem.edges import AXES, CARDINAL
from esg.layout.problem.record import LayoutProblem

DOUBT = 1e-7
"""Distance [cm, degrees] from the limit within which the detailed check decides."""
REST, ORDER, FACE, DISTANCE, POINT, COVER, LINE = range(7)
WIDTH = 7
Row = tuple[float, ...]
"""Kind, three nodes, parameters: a condition on world poses."""


@dataclass(frozen=True)
class Screen:
    """What must hold for a scene to be right.

    Args:
        rows: Conditions on poses, shape [n, 4 + WIDTH].
        prim: Pose of every collision shape in its node's frame, shape [p, 3].
        half: Its half extents, shape [p, 2].
        kind: 0 circle, 1 rectangle, shape [p].
        node: Its node, shape [p].
        pairs: Shapes of different nodes that share a height interval, shape [m, 2].
        radius: Of the circle about a node's origin that holds its shapes, shape [nodes].
        half_of: Footprint half extents of the nodes, shape [nodes, 2].
        is_round: Shape [nodes].
        reports: What is reported of a layout that passes.
    """

    rows: np.ndarray
    prim: np.ndarray
    half: np.ndarray
    kind: np.ndarray
    node: np.ndarray
    pairs: np.ndarray
    radius: np.ndarray
    half_of: np.ndarray
    is_round: np.ndarray
    reports: tuple[RelationReport, ...]


def build_screen(doc: EsgDocument, problem: LayoutProblem) -> Screen | None:
    """Conditions of one scene; None if only the detailed check can judge it."""
    if any(o.is_hard for o in problem.obstacles):
        return None
    if any(s.note for s in problem.supports.of.values()):
        return None
    index = {n: i for i, n in enumerate(problem.names)}
    still = World(
        dict.fromkeys(problem.names, (0.0, 0.0, 0.0)),
        {n: float(problem.node_z[i]) for i, n in enumerate(problem.names)},
    )
    rows: list[Row] = []
    reports: list[RelationReport] = []
    edges = doc.spatial_relation_graph.edges
    for k, e in enumerate(edges.binary_relations):
        found = _binary(problem, still, index, k, e)
        if found is None:
            return None
        rows += found[0]
        reports.append(report(*edge_names(e), 0.0, found[1]))
    for k, m in enumerate(edges.multi_relations):
        if any(n not in problem.shape for n in (*m.subjects, *m.targets)):
            return None
        is_line = m.relation_type is MultiRelationType.ALIGN
        rows += _multi(problem, still, index, k, is_line)
        reports.append(report(*edge_names(m), 0.0, ""))

    for n in carried(problem):
        s = problem.supports.of[n]
        if s.rect is None or s.parent is None or not is_solid(problem, n):
            return None
        at = (index[n], index[s.parent])
        rows.append(_row(REST, at, *s.rect, 0.0, *centre_offset(problem, n)))

    count = len(index)
    shown = int(problem.prim_off[count])
    node = np.repeat(np.arange(count), np.diff(problem.prim_off[: count + 1]))
    solid = [n for n in problem.names if n not in problem.ground]
    shapes = [p for n in solid for p in problem.shape[n].prims]
    table = np.array([(p.x, p.y, p.yaw, p.hx, p.hy, p.z0, p.z1) for p in shapes]).reshape(-1, 7)
    assert len(table) == shown
    z = problem.node_z[node].astype(float)
    low, high = table[:, 5] + z, table[:, 6] + z
    up = np.minimum(high[:, None], high) - np.maximum(low[:, None], low)
    pairs = np.argwhere((up > 5 * DOUBT) & (node[:, None] > node) & ~_joined(problem, node))
    return Screen(
        rows=np.array(rows, float).reshape(-1, 4 + WIDTH),
        prim=table[:, :3],
        half=table[:, 3:5],
        kind=problem.prim_kind[:shown],
        node=node,
        pairs=pairs,
        radius=problem.node_radius[:count].astype(float),
        half_of=np.array([(problem.shape[n].hx, problem.shape[n].hy) for n in problem.names]),
        is_round=np.array([problem.shape[n].is_round for n in problem.names], bool),
        reports=tuple(reports),
    )


def _joined(problem: LayoutProblem, node: np.ndarray) -> np.ndarray:
    """Whether two shapes belong to nodes that are joined, shape [p, p]."""
    index = {n: i for i, n in enumerate(problem.names)}
    out = np.zeros((len(index), len(index)), bool)
    for child, parent in problem.joined.parent.items():
        out[index[child], index[parent]] = out[index[parent], index[child]] = True
    return out[np.ix_(node, node)]


def _row(kind: int, nodes: Sequence[int], *params: float) -> Row:
    a, b, c = (*nodes, nodes[0], nodes[0])[:3]
    return (kind, a, b, c, *params, *[0.0] * (WIDTH - len(params)))


def _binary(
    problem: LayoutProblem, still: World, index: dict[str, int], k: int, e: BinaryRelation
) -> tuple[list[Row], str] | None:
    """Conditions of one relation and its note; None if it cannot hold."""
    kind = e.relation_type
    if e.from_ not in index or e.to not in index or e.from_ == e.to:
        return None
    by_rest = kind in HARD or (kind is R.ABOVE and problem.supports.of[e.from_].parent == e.to)
    if kind in HARD or e.cardinal is not None or not {e.from_, e.to} & problem.ground:
        if by_rest:
            return _resting(problem, index, e)
        pair = (index[e.from_], index[e.to])
        if kind in (R.UNDER, R.ABOVE):
            top = still.z[e.to] + problem.shape[e.to].height
            hidden = kind is R.ABOVE and top - still.z[e.from_] - 0.5 > -DOUBT
            return None if hidden else ([_row(COVER, pair)], "")
        row = _row_of(problem, still, pair, k, e)
        if row is not None:
            return [row], ""
    # what is left does not depend on poses
    violation, note = binary_violation(problem, still, k, e)
    return None if violation > 0 else ([], note)


def _resting(
    problem: LayoutProblem, index: dict[str, int], e: BinaryRelation
) -> tuple[list[Row], str] | None:
    """Conditions of a relation that is held by what carries its first object."""
    of = problem.supports.of[e.from_]
    held = held_by_support(problem, e) if e.relation_type in HARD else None
    if held is not None:
        return None if held[0] > 0 else ([], held[1])
    if of.parent is None or of.rect is None:
        return [], of.note
    if of.parent != e.to and e.to not in problem.supports.chain(e.from_):
        return None
    at = (index[e.from_], index[of.parent])
    return [_row(REST, at, *of.rect, float(of.kind == "inside"))], of.note


def _row_of(
    problem: LayoutProblem, still: World, pair: tuple[int, int], k: int, e: BinaryRelation
) -> Row | None:
    """The condition of a direction, face, distance or centre; None for other relations."""
    kind = e.relation_type
    mine = {t.kind: t for t in problem.terms_of.get(f"b{k}", [])}
    if kind in AXES:
        return _row(ORDER, pair, *AXES[kind])
    if kind is R.FACE and not (e.cardinal and problem.shape[e.from_].is_round):
        target = CARDINAL[e.cardinal] if e.cardinal else 0
        return _row(FACE, pair, float(bool(e.cardinal)), target)
    if kind in (R.NEAR, R.ADJACENT, R.FAR_FROM):
        low, high, slack = distance_range(e, mine[terms.BAND], problem.shape[e.to])
        return _row(DISTANCE, pair, low - slack, high + slack, _rise(problem, still, *pair))
    if kind is R.CENTER_OF:
        t = mine[terms.CENTER]
        size = centre_tolerance(problem.shape[e.to])
        return _row(POINT, pair, t.params[1], t.params[2], size)
    return None


def _rise(problem: LayoutProblem, still: World, i: int, j: int) -> float:
    a, b = problem.names[i], problem.names[j]
    return max(
        still.z[a] - still.z[b] - problem.shape[b].height,
        still.z[b] - still.z[a] - problem.shape[a].height,
    )


def _multi(
    problem: LayoutProblem, still: World, index: dict[str, int], k: int, is_line: bool
) -> list[Row]:
    rows = []
    for t in problem.terms_of.get(f"m{k}", []):
        nodes = [index[n] for n in t.nodes if n is not None]
        if t.kind == terms.SLOT:
            rows.append(_row(POINT, nodes, t.params[1], t.params[2], 2.0 * t.params[0] + 2.0))
        elif t.kind in (terms.BETWEEN, terms.LERP):
            rows.append(_row(LINE, nodes, t.params[1], 2.0 * t.params[0] + 2.0))
        elif t.kind == terms.BAND and not is_line:
            low, high = 0.75 * t.params[0] - 0.5, 1.25 * t.params[1]
            rows.append(_row(DISTANCE, nodes, low, high, _rise(problem, still, *nodes[:2])))
    return rows


def passing(screens: Sequence[Screen], poses: Sequence[np.ndarray]) -> np.ndarray:
    """Which layouts are right.

    Args:
        screens: One per scene.
        poses: World poses of every scene's nodes, shape [nodes, 3] (cm, cm, rad).

    Returns:
        Shape [scenes], True where every relation holds and nothing overlaps.
    """
    good = np.ones(len(screens), bool)
    if not screens:
        return good
    first = _starts([len(p) for p in poses])
    pose = np.concatenate(poses)
    half = np.concatenate([s.half_of for s in screens])
    is_round = np.concatenate([s.is_round for s in screens])

    rows = np.concatenate([s.rows for s in screens])
    scene = np.repeat(np.arange(len(screens)), [len(s.rows) for s in screens])
    nodes = rows[:, 1:4].astype(int) + first[scene][:, None]
    for kind in range(7):
        at = np.flatnonzero(rows[:, 0] == kind)
        if len(at):
            a, b, c = nodes[at].T
            over = _violation(kind, rows[at, 4:].T, pose, half, is_round, a, b, c)
            good[scene[at][~(over < -DOUBT)]] = False

    prim_first = _starts([len(s.prim) for s in screens])
    pairs = np.concatenate([s.pairs for s in screens])
    scene = np.repeat(np.arange(len(screens)), [len(s.pairs) for s in screens])
    pairs = pairs + prim_first[scene][:, None]
    node = np.concatenate([s.node + o for s, o in zip(screens, first, strict=False)])
    radius = np.concatenate([s.radius for s in screens])
    i, j = node[pairs].T
    close = np.hypot(*(pose[i] - pose[j])[:, :2].T) <= radius[i] + radius[j] + 0.01
    pairs, scene = pairs[close], scene[close]
    local = np.concatenate([s.prim for s in screens])
    at = _compose(pose[node], local)
    size = np.concatenate([s.half for s in screens])
    shape = np.concatenate([s.kind for s in screens])
    i, j = pairs.T
    gap = separation(shape[i], at[i], size[i], shape[j], at[j], size[j])
    good[scene[~(gap > DOUBT)]] = False
    return good


def _starts(counts: list[int]) -> np.ndarray:
    return np.concatenate([[0], np.cumsum(counts)]).astype(int)


def _compose(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    c, s = np.cos(p[:, 2]), np.sin(p[:, 2])
    return np.stack(
        [
            p[:, 0] + c * q[:, 0] - s * q[:, 1],
            p[:, 1] + s * q[:, 0] + c * q[:, 1],
            p[:, 2] + q[:, 2],
        ],
        axis=1,
    )


def _local(pose: np.ndarray, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    dx, dy = at[:, 0] - pose[:, 0], at[:, 1] - pose[:, 1]
    c, s = np.cos(pose[:, 2]), np.sin(pose[:, 2])
    return c * dx + s * dy, -s * dx + c * dy


def _outside(gx: np.ndarray, gy: np.ndarray) -> np.ndarray:
    return np.where((gx > 0) & (gy > 0), np.hypot(gx, gy), np.maximum(gx, gy))


def separation(
    ka: np.ndarray, pa: np.ndarray, ha: np.ndarray, kb: np.ndarray, pb: np.ndarray, hb: np.ndarray
) -> np.ndarray:
    """Signed planar distances of footprints [cm], as `esg.layout.judge.check.plan_separation`.

    Args:
        ka, kb: 0 circle, 1 rectangle, shape [n].
        pa, pb: Poses, shape [n, 3].
        ha, hb: Half extents, shape [n, 2].
    """
    out = np.hypot(pb[:, 0] - pa[:, 0], pb[:, 1] - pa[:, 1]) - ha[:, 0] - hb[:, 0]
    for mine, other in (((pa, ha), (pb, hb)), ((pb, hb), (pa, ha))):
        at = np.flatnonzero((ka if mine[0] is pa else kb) != 0)
        at = at[(kb if mine[0] is pa else ka)[at] == 0]
        x, y = _local(mine[0][at], other[0][at])
        gap = _outside(np.abs(x) - mine[1][at, 0], np.abs(y) - mine[1][at, 1])
        out[at] = gap - other[1][at, 0]
    at = np.flatnonzero((ka != 0) & (kb != 0))
    c, s = np.abs(np.cos(pb[at, 2] - pa[at, 2])), np.abs(np.sin(pb[at, 2] - pa[at, 2]))
    gaps = []
    for (p, h), (q, g) in (((pa, ha), (pb, hb)), ((pb, hb), (pa, ha))):
        x, y = _local(p[at], q[at])
        gx = np.abs(x) - h[at, 0] - g[at, 0] * c - g[at, 1] * s
        gy = np.abs(y) - h[at, 1] - g[at, 0] * s - g[at, 1] * c
        gaps.append(_outside(gx, gy))
    out[at] = np.maximum(*gaps)
    return out


def _violation(
    kind: int,
    p: np.ndarray,
    pose: np.ndarray,
    half: np.ndarray,
    is_round: np.ndarray,
    a: np.ndarray,
    b: np.ndarray,
    c: np.ndarray,
) -> np.ndarray:
    """How far conditions are from holding; negative: how far they are from failing."""
    pa, pb = pose[a], pose[b]
    if kind == REST:
        x, y = _local(pb, pa)
        turned = pa[:, 2] - pb[:, 2]
        cos, sin = np.abs(np.cos(turned)), np.abs(np.sin(turned))
        wide = np.where(is_round[a], half[a, 0], half[a, 0] * cos + half[a, 1] * sin)
        deep = np.where(is_round[a], half[a, 1], half[a, 0] * sin + half[a, 1] * cos)
        hx, hy = wide * p[4], deep * p[4]
        c, s = np.cos(turned), np.sin(turned)
        x, y = x + c * p[5] - s * p[6], y + s * p[5] + c * p[6]
        return np.max([p[0] + hx - x, x + hx - p[2], p[1] + hy - y, y + hy - p[3]], axis=0)
    if kind == ORDER:
        along = np.where(p[0] == 0, pa[:, 0] - pb[:, 0], pa[:, 1] - pb[:, 1])
        return 0.5 - p[1] * along
    if kind == FACE:
        towards = np.arctan2(pb[:, 1] - pa[:, 1], pb[:, 0] - pa[:, 0])
        off = pa[:, 2] - np.where(p[0] > 0, p[1], towards)
        return np.degrees(np.abs(np.arctan2(np.sin(off), np.cos(off)))) - 20.0
    if kind == DISTANCE:
        d = separation(
            (~is_round[a]).astype(int), pa, half[a], (~is_round[b]).astype(int), pb, half[b]
        )
        d = np.where(p[2] > 0, np.hypot(np.maximum(d, 0.0), p[2]), d)
        return np.maximum(p[0] - d, d - p[1])
    if kind == POINT:
        at = _compose(pb, p[:3].T * np.array([1.0, 1.0, 0.0]))
        return np.hypot(pa[:, 0] - at[:, 0], pa[:, 1] - at[:, 1]) - p[2]
    if kind == COVER:
        x, y = _local(pb, pa)
        return np.maximum(np.abs(x) - half[b, 0], np.abs(y) - half[b, 1])
    pc = pose[c]
    at = pb[:, :2] + p[0][:, None] * (pc[:, :2] - pb[:, :2])
    return np.hypot(pa[:, 0] - at[:, 0], pa[:, 1] - at[:, 1]) - p[1]
