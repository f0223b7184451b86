"""Exact judgement of a layout in double precision: penetration, support, relation predicates."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.graph.models import (
    BinaryRelation,
    EsgDocument,
    MultiRelation,
    MultiRelationType,
    RelationReport,
    RelationType,
)
from esg.layout.problem import terms
from esg.layout.problem.edges import AXES, CARDINAL, Term
from esg.layout.problem.poses import Pose2, compose, inverse
from esg.layout.problem.record import LayoutProblem
from esg.layout.problem.shapes import CIRCLE, Footprint
from esg.layout.problem.supports import Shape

TOUCH_CM = 0.05
HARD = {
    RelationType.ON, RelationType.INSIDE_OF, RelationType.ATTACHED_VERTICAL,
    RelationType.ATTACHED_HORIZONTAL,
}  # fmt: skip


@dataclass(frozen=True)
class World:
    """World poses of all nodes: (x, y, yaw) [cm, rad] and height of the origin [cm]."""

    pose: dict[str, Pose2]
    z: dict[str, float]


def world_poses(problem: LayoutProblem, units: np.ndarray) -> World:
    """Forward kinematics of one start, units [units, 3]."""
    pose: dict[str, Pose2] = {}
    for u, unit in enumerate(problem.units):
        frame: Pose2 = tuple(float(v) for v in units[u])  # type: ignore[assignment]  # three values
        if unit.parent is not None:
            frame = compose(pose[unit.parent], frame)
        for name, rel in unit.members.items():
            pose[name] = compose(frame, rel)
    z = {n: float(problem.node_z[i]) for i, n in enumerate(problem.names)}
    return World(pose, z)


def _frame_gap(
    dx: float, dy: float, ax: float, ay: float, bx: float, by: float, rel: float
) -> float:
    c, s = abs(math.cos(rel)), abs(math.sin(rel))
    gx = abs(dx) - ax - bx * c - by * s
    gy = abs(dy) - ay - bx * s - by * c
    return math.hypot(gx, gy) if gx > 0 and gy > 0 else max(gx, gy)


def plan_separation(
    ka: int, pa: Pose2, ha: tuple[float, float], kb: int, pb: Pose2, hb: tuple[float, float]
) -> float:
    """Signed planar distance of two footprints [cm]; negative is the penetration depth."""
    dx, dy = pb[0] - pa[0], pb[1] - pa[1]
    if ka == CIRCLE and kb == CIRCLE:
        return math.hypot(dx, dy) - ha[0] - hb[0]
    if ka != CIRCLE and kb != CIRCLE:
        ca, sa = math.cos(pa[2]), math.sin(pa[2])
        cb, sb = math.cos(pb[2]), math.sin(pb[2])
        rel = pb[2] - pa[2]
        ga = _frame_gap(ca * dx + sa * dy, -sa * dx + ca * dy, *ha, *hb, rel)
        gb = _frame_gap(cb * dx + sb * dy, -sb * dx + cb * dy, *hb, *ha, rel)
        return max(ga, gb)
    if ka == CIRCLE:
        return plan_separation(kb, pb, hb, ka, pa, ha)
    c, s = math.cos(pa[2]), math.sin(pa[2])
    qx, qy = abs(c * dx + s * dy) - ha[0], abs(-s * dx + c * dy) - ha[1]
    return (math.hypot(qx, qy) if qx > 0 and qy > 0 else max(qx, qy)) - hb[0]


def prim_penetration(
    a: Footprint, pa: Pose2, za: float, b: Footprint, pb: Pose2, zb: float
) -> float:
    """Penetration depth of two prisms [cm], 0 when apart; spheres are exact against flat tops.

    The depth is the shortest way out: sideways or vertically.
    """
    up = min(a.z1 + za, b.z1 + zb) - max(a.z0 + za, b.z0 + zb)
    if up <= 0:
        return 0.0
    qa, qb = compose(pa, (a.x, a.y, a.yaw)), compose(pb, (b.x, b.y, b.yaw))
    plan = plan_separation(a.kind, qa, (a.hx, a.hy), b.kind, qb, (b.hx, b.hy))
    if plan >= 0:
        return 0.0
    if a.is_sphere and b.is_sphere:
        ca, cb = 0.5 * (a.z0 + a.z1) + za, 0.5 * (b.z0 + b.z1) + zb
        return max(0.0, a.hx + b.hx - math.dist((*qa[:2], ca), (*qb[:2], cb)))
    if a.is_sphere or b.is_sphere:
        if b.is_sphere:
            a, b, qa, qb, za, zb = b, a, qb, qa, zb, za
        r, cz = a.hx, 0.5 * (a.z0 + a.z1) + za
        side = plan + r  # planar distance of the centre to the footprint, negative inside
        over = max(cz - b.z1 - zb, b.z0 + zb - cz)
        d = math.hypot(max(side, 0), max(over, 0)) + min(max(side, over), 0)
        return max(0.0, r - d)
    return min(-plan, up)


def penetrations(problem: LayoutProblem, world: World) -> list[tuple[float, str, str]]:
    """All overlapping pairs, deepest first; the ground is excluded (heights are exact there).

    What is joined may overlap: the two do not touch each other.
    """
    out = []
    names = problem.names
    count = len(names)
    radius = problem.node_radius
    xy = np.array([world.pose[n][:2] for n in names]).reshape(-1, 2)
    for i in range(count):
        if radius[i] <= 0:
            continue
        near = np.flatnonzero(
            np.hypot(*(xy[:i] - xy[i]).T) <= radius[:i] + radius[i]
        )  # fmt: skip
        for j in near:
            if radius[j] <= 0:
                continue
            a, b = names[i], names[int(j)]
            if problem.joined.are_joined(a, b):
                continue
            depth = 0.0
            for p in problem.shape[a].prims:
                for q in problem.shape[b].prims:
                    depth = max(
                        depth,
                        prim_penetration(
                            p, world.pose[a], world.z[a], q, world.pose[b], world.z[b]
                        ),
                    )
            if depth > 1e-6:
                out.append((depth, a, b))
    return sorted(out, key=lambda t: (-t[0], t[1], t[2]))


def intrusions(problem: LayoutProblem, world: World) -> list[tuple[float, str, str]]:
    """Objects inside a corridor that must stay clear: (depth [cm], object, corridor)."""
    count = len(problem.names)
    out = []
    for a, b in problem.pair.tolist():
        if b < count or not problem.obstacles[b - count].is_hard:
            continue
        obstacle = problem.obstacles[b - count]
        member = next(iter(problem.units[obstacle.unit].members))
        frame = compose(world.pose[member], inverse(problem.units[obstacle.unit].members[member]))
        here = compose(frame, obstacle.rel)
        name = problem.names[a]
        depth = 0.0
        for p in problem.shape[name].prims:
            q = compose(world.pose[name], (p.x, p.y, p.yaw))
            for k, x, y, yaw, hx, hy, z0, z1 in obstacle.prisms:
                up = min(p.z1 + world.z[name], z1 + obstacle.base_z_cm) - max(
                    p.z0 + world.z[name], z0 + obstacle.base_z_cm
                )
                if up > 0.2:
                    gap = plan_separation(
                        p.kind, q, (p.hx, p.hy), int(k), compose(here, (x, y, yaw)), (hx, hy)
                    )
                    depth = max(depth, -gap)
        if depth > 0.1:
            out.append((depth, name, obstacle.label))
    return sorted(out, key=lambda t: (-t[0], t[1], t[2]))


def _angle(a: float) -> float:
    return abs(math.remainder(a, 2 * math.pi))


def _world_half(problem: LayoutProblem, name: str, yaw: float) -> tuple[float, float]:
    s = problem.shape[name]
    if s.is_round:
        return s.hx, s.hy
    c, n = abs(math.cos(yaw)), abs(math.sin(yaw))
    return s.hx * c + s.hy * n, s.hx * n + s.hy * c


def surface_distance(problem: LayoutProblem, world: World, a: str, b: str) -> float:
    """Distance of two objects' bounding footprints, with the vertical gap [cm]."""
    sa, sb = problem.shape[a], problem.shape[b]
    d = plan_separation(
        0 if sa.is_round else 1, world.pose[a], (sa.hx, sa.hy),
        0 if sb.is_round else 1, world.pose[b], (sb.hx, sb.hy),
    )  # fmt: skip
    up = max(world.z[a] - world.z[b] - sb.height, world.z[b] - world.z[a] - sa.height)
    return math.hypot(max(d, 0.0), up) if up > 0 else d


def _rests(problem: LayoutProblem, world: World, a: str, b: str) -> float:
    """How far a's centre leaves the surface of b that should carry it [cm]."""
    s = problem.supports.of[a]
    if s.parent is None or s.rect is None:
        return 0.0
    if s.parent != b and b not in problem.supports.chain(a):
        return math.inf
    px, py, yaw = world.pose[s.parent]
    dx, dy = world.pose[a][0] - px, world.pose[a][1] - py
    c, n = math.cos(yaw), math.sin(yaw)
    x, y = c * dx + n * dy, -n * dx + c * dy
    x0, y0, x1, y1 = s.rect
    hx, hy = (0.0, 0.0)
    if s.kind == "inside":
        hx, hy = _world_half(problem, a, world.pose[a][2] - yaw)
    return max(x0 + hx - x, x - hx * -1 - x1, y0 + hy - y, y + hy - y1, 0.0)


def held_by_support(problem: LayoutProblem, e: BinaryRelation) -> tuple[float, str] | None:
    """Violation and note of a support relation where they do not depend on poses, else None."""
    s = problem.supports.of[e.from_]
    if any(u.z_cm and e.from_ in u.z_cm for u in problem.units):
        return 0.0, "starts in the air as planned"
    if s.parent is None and s.kind == "ground" and s.rect is None:
        if e.to in problem.ground:
            return 0.0, ""
        return math.inf, f"does not rest on {e.to}"
    on_chain = s.parent is None or s.parent == e.to or e.to in problem.supports.chain(e.from_)
    if not on_chain and e.to in problem.ground:
        return 0.0, ""
    return None


def binary_violation(
    problem: LayoutProblem, world: World, k: int, e: BinaryRelation
) -> tuple[float, str]:
    """How far a relation is from holding (0 holds), and a note; unit cm, or degrees for face."""
    if e.from_ not in problem.shape or e.to not in problem.shape:
        return math.inf, "names an unknown object"
    if e.from_ == e.to:
        return math.inf, "relates an object to itself"
    kind = e.relation_type
    if kind not in HARD and e.cardinal is None and {e.from_, e.to} & problem.ground:
        return 0.0, "the ground is everywhere"
    pa, pb = world.pose[e.from_], world.pose[e.to]
    mine = problem.terms_of.get(f"b{k}", [])
    if kind in HARD:
        held = held_by_support(problem, e)
        if held is not None:
            return held
        return _rests(problem, world, e.from_, e.to), problem.supports.of[e.from_].note
    if kind in AXES:
        axis, sign = AXES[kind]
        d = sign * (pa[axis] - pb[axis])
        return max(0.0, 0.5 - d), ""
    if kind is RelationType.FACE:
        if e.cardinal and problem.shape[e.from_].is_round:
            return 0.0, "round: any heading"
        target = CARDINAL[e.cardinal] if e.cardinal else math.atan2(pb[1] - pa[1], pb[0] - pa[0])
        return max(0.0, math.degrees(_angle(pa[2] - target)) - 20.0), ""
    if kind in (RelationType.NEAR, RelationType.ADJACENT, RelationType.FAR_FROM):
        band = next(t for t in mine if t.kind == terms.BAND)
        low, high, slack = distance_range(e, band, problem.shape[e.to])
        d = surface_distance(problem, world, e.from_, e.to)
        return max(0.0, low - slack - d, d - high - slack), ""
    if kind is RelationType.CENTER_OF:
        t = next(t for t in mine if t.kind == terms.CENTER)
        c = compose(pb, (t.params[1], t.params[2], 0.0))
        return max(0.0, math.dist(pa[:2], c[:2]) - centre_tolerance(problem.shape[e.to])), ""
    if kind is RelationType.ABOVE and problem.supports.of[e.from_].parent == e.to:
        return _rests(problem, world, e.from_, e.to), ""
    if kind in (RelationType.UNDER, RelationType.ABOVE):
        return _covered(problem, world, e), ""
    return _height_order(problem, world, e), "heights follow from the supports"


def distance_range(e: BinaryRelation, band: Term, to: Shape) -> tuple[float, float, float]:
    """Surface distances [cm] at which near, adjacent or far_from holds, and the slack on them.

    Args:
        e: The relation.
        band: Its energy term.
        to: What it is a relation to.
    """
    low, high = band.params[:2]
    slack = 0.25 * (high - low) + 1.0 if high < 1e5 else 0.1 * low
    if e.relation_type is RelationType.NEAR and e.distance_cm is None:
        # closer than preferred is still near, and nobody is closer to the street side than on it
        low = -2.0 * (to.hx + to.hy) if to.is_pavement else 0.0
    return low, high, slack


def centre_tolerance(shape: Shape) -> float:
    """How far from the middle of something its centre may be [cm]."""
    return max(2.0, 0.1 * (shape.hx + shape.hy))


def _covered(problem: LayoutProblem, world: World, e: BinaryRelation) -> float:
    """How far something is from being under, or above, the other's footprint [cm]."""
    pa, pb = world.pose[e.from_], world.pose[e.to]
    c, n = math.cos(pb[2]), math.sin(pb[2])
    dx, dy = pa[0] - pb[0], pa[1] - pb[1]
    s = problem.shape[e.to]
    out = max(abs(c * dx + n * dy) - s.hx, abs(-n * dx + c * dy) - s.hy, 0.0)
    if e.relation_type is RelationType.ABOVE:
        return max(out, world.z[e.to] + s.height - world.z[e.from_] - 0.5)
    return out


def _height_order(problem: LayoutProblem, world: World, e: BinaryRelation) -> float:
    """How far the middles are from being higher, lower or level [cm]."""
    za = world.z[e.from_] + 0.5 * problem.shape[e.from_].height
    zb = world.z[e.to] + 0.5 * problem.shape[e.to].height
    if e.relation_type is RelationType.HIGHER_THAN:
        return max(0.0, zb + 0.5 - za)
    if e.relation_type is RelationType.LOWER_THAN:
        return max(0.0, za + 0.5 - zb)
    level = min(abs(za - zb), abs(world.z[e.from_] - world.z[e.to]))
    return max(0.0, level - 2.0)


def multi_violation(
    problem: LayoutProblem, world: World, k: int, m: MultiRelation
) -> tuple[float, str]:
    """How far a multi relation is from holding [cm]."""
    worst = 0.0
    note = ""
    unknown = [n for n in (*m.subjects, *m.targets) if n not in problem.shape]
    if unknown:
        return math.inf, f"names unknown objects {unknown}"
    for t in problem.terms_of.get(f"m{k}", []):
        a = world.pose[t.nodes[0]]
        b = world.pose[t.nodes[1]] if t.nodes[1] is not None else (0.0, 0.0, 0.0)
        if t.kind == terms.SLOT:
            c = compose(b, (t.params[1], t.params[2], 0.0))
            v = math.dist(a[:2], c[:2]) - 2.0 * t.params[0] - 2.0
        elif t.kind in (terms.BETWEEN, terms.LERP):
            c = world.pose[t.nodes[2]] if t.nodes[2] is not None else b
            f = t.params[1]
            p = (b[0] + f * (c[0] - b[0]), b[1] + f * (c[1] - b[1]))
            v = math.dist(a[:2], p) - 2.0 * t.params[0] - 2.0
        elif t.kind == terms.BAND and m.relation_type is not MultiRelationType.ALIGN:
            d = surface_distance(problem, world, t.nodes[0], t.nodes[1] or t.nodes[0])
            v = max(t.params[0] * 0.75 - 0.5 - d, d - 1.25 * t.params[1])
        else:
            continue
        if v > worst:
            worst, note = v, f"{t.nodes[0]} is off"
    return worst, note


def _is_planned(problem: LayoutProblem, a: str, b: str) -> bool:
    return any(u.is_planned and a in u.members and b in u.members for u in problem.units)


def edge_names(edge: BinaryRelation | MultiRelation) -> tuple[str, str]:
    """An edge as text, and its relation."""
    kind = edge.relation_type.value
    if isinstance(edge, BinaryRelation):
        return f"{edge.from_} {kind} {edge.to}", kind
    return f"{','.join(edge.subjects)} {kind} {','.join(edge.targets)}".strip(), kind


def relation_reports(
    doc: EsgDocument, problem: LayoutProblem, world: World
) -> tuple[RelationReport, ...]:
    """One report per edge of the document."""
    edges = doc.spatial_relation_graph.edges
    out = []
    for k, e in enumerate(edges.binary_relations):
        v, note = binary_violation(problem, world, k, e)
        if v > 0 and _is_planned(problem, e.from_, e.to):
            note = f"{note}; held by the planned start".removeprefix("; ")
        out.append(report(*edge_names(e), v, note))
    for k, m in enumerate(edges.multi_relations):
        out.append(report(*edge_names(m), *multi_violation(problem, world, k, m)))
    return tuple(out)


def report(edge: str, kind: str, violation: float, note: str) -> RelationReport:
    """How one relation came out; a violation of infinity is reported as 10^9."""
    finite = min(violation, 1e9)
    return RelationReport(
        edge=edge,
        relation_type=kind,
        satisfied=violation <= 1e-6,
        violation=round(finite, 4),
        note=note,
    )
