"""From the relations of the document to energy terms, with their adaptive parameters.

Sources: Supp. Mat., Layout Optimization Details (near, directional, region terms); the other terms
are ours and documented in docs/layout.md.
"""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.graph.models import BinaryRelation, EsgDocument, MultiRelationType, RelationType
from esg.layout.problem import terms
from esg.layout.problem.supports import Shape, SupportMap

AXES = {
    RelationType.LEFT_OF: (0, 1.0),
    RelationType.RIGHT_OF: (0, -1.0),
    RelationType.IN_FRONT_OF: (1, 1.0),
    RelationType.BEHIND: (1, -1.0),
}
STRICTNESS = {
    RelationType.NEAR: 0.6,
    RelationType.ADJACENT: 1.0,
    RelationType.FAR_FROM: 0.6,
    RelationType.FACE: 1.0,
    RelationType.CENTER_OF: 1.0,
    RelationType.UNDER: 1.5,
}
CARDINAL = {"+X": 0.0, "+Y": 0.5 * math.pi, "-X": math.pi, "-Y": -0.5 * math.pi}
RHO_D, D_MIN, D_MAX = 0.1, 8.0, 300.0
RHO_T, T_MIN, T_MAX = 0.2, 2.0, 80.0
GROUND_SPAN_CM = 3000.0
"""Region scale of the open ground: near on a street means within 3 m, not within 1 km."""


@dataclass(frozen=True)
class Term:
    """One energy term; `params` are those of `esg.layout.kernels.cpu.edge_energy`."""

    kind: int
    nodes: tuple[str, str | None, str | None]
    weight: float
    params: tuple[float, ...]
    source: str = ""
    """Index of the relation it came from: `b3` or `m1`; empty for region terms."""


def characteristic(shape: Shape) -> float:
    """Characteristic size (4 dx + 4 dy + dz) / 9 [cm]."""
    return (8.0 * shape.hx + 8.0 * shape.hy + shape.height) / 9.0


def region_scale(name: str, supports: SupportMap) -> float:
    """Diagonal of the region that holds a node [cm]."""
    rect = supports.of[name].rect
    if rect is None:
        return GROUND_SPAN_CM
    return math.hypot(rect[2] - rect[0], rect[3] - rect[1])


def near_band(a: Shape, b: Shape, scale: float) -> tuple[float, float]:
    """Lower and upper surface distance of `near` [cm]."""
    d = min(0.5 * min(characteristic(a), characteristic(b)), RHO_D * scale)
    d = min(max(d, D_MIN), D_MAX)
    t = min(max(RHO_T * d, T_MIN), T_MAX)
    return d - t, d + t


def adjacent_band(a: Shape, b: Shape) -> tuple[float, float]:
    """Surface distance of `adjacent` [cm]: side by side without touching."""
    return 0.5, min(max(0.15 * min(characteristic(a), characteristic(b)), 2.0), 30.0)


def far_distance(a: Shape, b: Shape, scale: float) -> float:
    """Least surface distance of `far_from` [cm]."""
    return min(max(2.0 * max(characteristic(a), characteristic(b)), 100.0), 1500.0, 0.35 * scale)


def prescribed_band(edge: BinaryRelation) -> tuple[float, float] | None:
    """Band of a stated surface distance [cm]."""
    d = edge.distance_cm
    if d is None:
        return None
    if isinstance(d, tuple):
        return d
    slack = max(1.0, 0.02 * d)
    return max(0.0, d - slack), d + slack


def binary_terms(
    k: int, e: BinaryRelation, shape: dict[str, Shape], supports: SupportMap
) -> list[Term]:
    """Energy terms of one binary relation; none for those that hold by construction."""
    source = f"b{k}"
    a, b = shape[e.from_], shape[e.to]
    w = max(0.05, e.confidence) * STRICTNESS.get(e.relation_type, 1.0)
    pair = (e.from_, e.to, None)
    scale = min(region_scale(e.from_, supports), region_scale(e.to, supports))
    band = prescribed_band(e)
    kind = e.relation_type
    if kind is RelationType.NEAR:
        return [Term(terms.BAND, pair, w, band or near_band(a, b, scale), source)]
    if kind is RelationType.ADJACENT:
        return [Term(terms.BAND, pair, w, band or adjacent_band(a, b), source)]
    if kind is RelationType.FAR_FROM:
        low, high = band or (far_distance(a, b, scale), 1.0e6)
        return [Term(terms.BAND, pair, w, (low, high), source)]
    if kind in AXES:
        axis, sign = AXES[kind]
        size = characteristic(a) + characteristic(b)
        reach = min(max(1.5 * size, 30.0), 0.5 * scale)
        gap = min(max(0.02 * size, 0.5), 10.0)
        lateral = max(0.25 * size, 2.0)
        out = []
        if band is not None:
            gap, reach = band[0], band[1] - band[0] + 0.5 * size
            out.append(Term(terms.BAND, pair, w, band, source))
        out.append(Term(terms.DIRECTION, pair, w, (axis, sign, reach, lateral, size, gap), source))
        return out
    if kind is RelationType.FACE:
        if e.cardinal is not None:
            if a.is_round:
                return []  # a heading has no meaning
            return [Term(terms.FACE, pair, w, (1.0, CARDINAL[e.cardinal]), source)]
        return [Term(terms.FACE, pair, w, (0.0, 0.0), source)]
    if kind is RelationType.CENTER_OF:
        rect = supports.of[e.from_].rect
        x = y = 0.0
        if supports.of[e.from_].parent == e.to and rect is not None:
            x, y = 0.5 * (rect[0] + rect[2]), 0.5 * (rect[1] + rect[3])
        return [Term(terms.CENTER, pair, w, (0.5, x, y), source)]
    if kind is RelationType.UNDER:
        # what lies under is covered: a decal under its users, a bin under a desk
        return [Term(terms.UNDER, pair, w, (0.0,), source)]
    if kind is RelationType.ABOVE and supports.of[e.from_].parent != e.to:
        return [Term(terms.UNDER, pair, w, (0.0,), source)]
    if kind is RelationType.INSIDE_OF and supports.of[e.from_].parent != e.to:
        return [Term(terms.UNDER, pair, w, (min(a.hx, a.hy),), source)]
    return []


def multi_terms(doc: EsgDocument, shape: dict[str, Shape], supports: SupportMap) -> list[Term]:
    """Energy terms of all multi relations."""
    out: list[Term] = []
    for k, m in enumerate(doc.spatial_relation_graph.edges.multi_relations):
        subjects = [s for s in m.subjects if s in shape]
        targets = [t for t in m.targets if t in shape]
        w = max(0.05, m.confidence)
        source = f"m{k}"
        spacing = m.spacing_cm if isinstance(m.spacing_cm, float | int) else None
        if isinstance(m.spacing_cm, tuple):
            spacing = 0.5 * (m.spacing_cm[0] + m.spacing_cm[1])
        if m.relation_type is MultiRelationType.BETWEEN and len(targets) >= 2:
            b, c = targets[0], targets[1]
            n = len(subjects)
            for i, s in enumerate(subjects):
                t = (i + 1) / (n + 1)
                tol = max(1.0, 0.2 * characteristic(shape[s]))
                out.append(Term(terms.BETWEEN, (s, b, c), w, (tol, t), source))
        elif m.relation_type is MultiRelationType.SURROUND and targets:
            out += _surround(subjects, targets[0], shape, supports, w, spacing, source)
        elif m.relation_type is MultiRelationType.ALIGN:
            line = subjects if len(subjects) > 2 else subjects + targets
            if len(line) >= 3:
                for i in range(1, len(line) - 1):
                    t = i / (len(line) - 1)
                    out.append(Term(terms.LERP, (line[i], line[0], line[-1]), w, (0.5, t), source))
            if len(line) >= 2:
                step = spacing if spacing is not None else 0.4 * characteristic(shape[line[0]])
                total = (len(line) - 1) * step + sum(
                    2 * max(shape[n].hx, shape[n].hy) for n in line[1:-1]
                )
                out.append(
                    Term(
                        terms.BAND,
                        (line[0], line[-1], None),
                        w,
                        (0.9 * total, 1.3 * total + 2.0),
                        source,
                    )
                )
        elif m.relation_type is MultiRelationType.SCATTER_BY:
            for i, s in enumerate(subjects):
                gap = spacing if spacing is not None else max(2.0, 0.3 * characteristic(shape[s]))
                for other in subjects[:i]:
                    out.append(Term(terms.BAND, (s, other, None), 0.5 * w, (gap, 1.0e6), source))
                for t in targets[:1]:
                    if supports.of[s].parent != t:
                        reach = 3.0 * characteristic(shape[t]) + characteristic(shape[s]) * len(
                            subjects
                        )
                        out.append(Term(terms.BAND, (s, t, None), w, (1.0, reach), source))
    return out


def _surround(
    subjects: list[str],
    target: str,
    shape: dict[str, Shape],
    supports: SupportMap,
    weight: float,
    spacing: float | None,
    source: str,
) -> list[Term]:
    """Slots around a target, or along the rim of a surface that carries the subjects."""
    t = shape[target]
    on_it = [supports.of[s].parent == target for s in subjects]
    biggest = max(max(shape[s].hx, shape[s].hy) for s in subjects) if subjects else 0.0
    hx, hy = t.hx, t.hy
    rect = supports.of[subjects[0]].rect if subjects else None
    cx = cy = 0.0
    if subjects and all(on_it) and rect is not None:
        cx, cy = 0.5 * (rect[0] + rect[2]), 0.5 * (rect[1] + rect[3])
        inset = biggest + 2.0
        hx = max(0.5, 0.5 * (rect[2] - rect[0]) - inset)
        hy = max(0.5, 0.5 * (rect[3] - rect[1]) - inset)
    else:
        out = biggest + (spacing if spacing is not None else max(5.0, 0.4 * biggest))
        hx, hy = hx + out, hy + out
    points = rim_points(len(subjects), hx, hy, t.is_round)
    terms_out = []
    for s, (x, y) in zip(subjects, points, strict=True):
        tol = max(1.0, 0.1 * characteristic(shape[s]))
        terms_out.append(Term(terms.SLOT, (s, target, None), weight, (tol, cx + x, cy + y), source))
        if not shape[s].is_round:
            terms_out.append(Term(terms.FACE, (s, target, None), 0.3 * weight, (0.0, 0.0), source))
    return terms_out


def rim_points(count: int, hx: float, hy: float, is_round: bool) -> list[tuple[float, float]]:
    """Evenly spaced points on an ellipse or on a rectangle's rim, starting on +X."""
    if is_round:
        return [
            (hx * math.cos(2 * math.pi * k / count), hy * math.sin(2 * math.pi * k / count))
            for k in range(count)
        ]
    perimeter = 4 * (hx + hy)
    out = []
    for k in range(count):
        s = (k + 0.5) * perimeter / count if count > 4 else k * perimeter / count
        # counter-clockwise from the middle of the +X side
        if count <= 4:
            out.append([(hx, 0.0), (-hx, 0.0), (0.0, hy), (0.0, -hy)][k])
            continue
        if s < hy:
            out.append((hx, s))
        elif s < hy + 2 * hx:
            out.append((hx - (s - hy), hy))
        elif s < 3 * hy + 2 * hx:
            out.append((-hx, hy - (s - hy - 2 * hx)))
        elif s < 3 * hy + 4 * hx:
            out.append((-hx + (s - 3 * hy - 2 * hx), -hy))
        else:
            out.append((hx, -hy + (s - 3 * hy - 4 * hx)))
    return out
