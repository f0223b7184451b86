"""Rules on spatial relations: ends, arity, contradictions and cycles."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

from esg.graph.context import Context, bounds, components
from esg.graph.models import BinaryRelation, MultiRelation, MultiRelationType, RelationType
from esg.graph.relations import AXES, SUPPORTS, conflict
from esg.graph.rules_scene import SIZE_CM, interval, outside
from esg.graph.violations import listing, pointer

R = RelationType

MAX_DISTANCE_CM = 2e4
SQUARE_RATIO = 0.05
"""Footprints whose sides differ by less have no front to speak of."""

_ARITY: dict[MultiRelationType, tuple[int, int]] = {
    MultiRelationType.BETWEEN: (1, 2),
    MultiRelationType.SURROUND: (1, 1),
    MultiRelationType.ALIGN: (2, 0),
    MultiRelationType.SCATTER_BY: (1, 0),
}
"""Least number of subjects and of targets; `align` may take one of its members as the target."""

_EDGES = ("spatial_relation_graph", "edges")
Indexed = list[tuple[int, BinaryRelation]]


def check(ctx: Context) -> None:
    """Adds violations of binary and multi relations."""
    good: Indexed = []
    for i, edge in enumerate(ctx.graph.edges.binary_relations):
        if _ends(ctx, i, edge):
            good.append((i, edge))
        _numbers(ctx, i, edge)
    _pairs(ctx, good)
    _cycles(ctx, good)
    _supports(ctx, good)
    _faces(ctx, good)
    for i, edge in enumerate(ctx.graph.edges.multi_relations):
        _multi(ctx, i, edge)


def _at(i: int, *parts: str) -> str:
    return pointer(*_EDGES, "binary_relations", i, *parts)


def _text(edge: BinaryRelation) -> str:
    return f"{edge.from_} {edge.relation_type.value} {edge.to}"


def _ends(ctx: Context, i: int, edge: BinaryRelation) -> bool:
    known = True
    for key, name in (("from", edge.from_), ("to", edge.to)):
        if name not in ctx.node_names:
            ctx.add(
                "REF_RELATION",
                _at(i, key),
                name,
                f"Relation {_text(edge)!r} names {name!r}, which is not a node.",
                f"Use one of {listing(ctx.node_names)}.",
            )
            known = False
    if edge.from_ == edge.to:
        ctx.add(
            "RELATION_SELF",
            _at(i),
            _text(edge),
            f"{edge.from_!r} is related to itself.",
            "Name another object, or remove the relation.",
        )
        return False
    return known


def _numbers(ctx: Context, i: int, edge: BinaryRelation) -> None:
    _confidence(ctx, _at(i, "confidence"), edge.confidence)
    if edge.distance_cm is not None:
        _distance(ctx, _at(i, "distance_cm"), edge.distance_cm)
    if edge.cardinal is None:
        return
    if edge.relation_type is not R.FACE:
        ctx.add(
            "RELATION_CARDINAL",
            _at(i, "cardinal"),
            edge.cardinal,
            f"{_text(edge)!r} has a cardinal direction, which only `face` has.",
            "Remove `cardinal`, or make the relation `face`.",
        )
    elif edge.to in ctx.nodes and not ctx.is_structural(edge.to):
        ctx.add(
            "RELATION_CARDINAL",
            _at(i, "to"),
            edge.to,
            f"{_text(edge)!r} names both an object and the direction {edge.cardinal}.",
            "Let `to` be the ground, or remove `cardinal`.",
        )


def _confidence(ctx: Context, where: str, value: float) -> None:
    if not 0.0 <= value <= 1.0:
        ctx.add(
            "RELATION_CONFIDENCE", where, value, f"Confidence {value:g} is not in 0 to 1.", "Use 1."
        )


def _distance(ctx: Context, where: str, value: float | tuple[float, float]) -> None:
    if isinstance(value, tuple) and not interval(ctx, where, value):
        return
    low, high = bounds(value)
    if low < 0.0 or high > MAX_DISTANCE_CM:
        ctx.add(
            "RELATION_DISTANCE",
            where,
            value,
            f"Distance {value} cm is not plausible.",
            f"Use 0 to {MAX_DISTANCE_CM:g} cm (the unit is cm).",
        )


def _pairs(ctx: Context, edges: Indexed) -> None:
    """Compares all relations of one pair, each read from the alphabetically first object."""
    by_pair: dict[tuple[str, str], Indexed] = defaultdict(list)
    for i, edge in edges:
        by_pair[min(edge.from_, edge.to), max(edge.from_, edge.to)].append((i, edge))
    for related in by_pair.values():
        for k, (i, edge) in enumerate(related):
            for _, before in related[:k]:
                _pair(ctx, i, edge, before)


def _pair(ctx: Context, i: int, edge: BinaryRelation, before: BinaryRelation) -> None:
    same_way = edge.from_ == before.from_
    if edge.relation_type is before.relation_type and same_way:
        if edge.cardinal != before.cardinal and edge.relation_type is R.FACE:
            return
        ctx.add(
            "RELATION_DUPLICATE",
            _at(i),
            _text(edge),
            f"{_text(edge)!r} is stated twice.",
            "State it once.",
        )
        return
    reason = conflict(edge.relation_type, before.relation_type, same_way=same_way)
    if reason:
        ctx.add(
            "RELATION_CONTRADICTION",
            _at(i),
            _text(edge),
            f"{_text(edge)!r} contradicts {_text(before)!r}: {reason}.",
            "Remove or correct one of them.",
        )


def _cycles(ctx: Context, edges: Indexed) -> None:
    """Finds circles of three and more; shorter ones are contradictions of a pair."""
    reported: set[tuple[str, ...]] = set()
    for axis, signs in [*AXES.items(), ("support", dict.fromkeys(SUPPORTS, 1))]:
        level: dict[str, str] = {n: n for _, e in edges for n in (e.from_, e.to)}
        if axis == "up-down":
            _merge_levels(level, edges)
        arrows: list[tuple[str, str]] = []
        uses: list[tuple[int, BinaryRelation]] = []
        for i, edge in edges:
            sign = signs.get(edge.relation_type, 0)
            if sign == 0:
                continue
            a, b = level[edge.from_], level[edge.to]
            arrows.append((a, b) if sign > 0 else (b, a))
            uses.append((i, edge))
        for cycle in components(sorted(set(level.values())), arrows):
            members = {n for n, root in level.items() if root in cycle}
            inside = [(i, e) for i, e in uses if e.from_ in members and e.to in members]
            pairs = {frozenset((e.from_, e.to)) for _, e in inside}
            names = tuple(sorted({n for p in pairs for n in p}))
            if len(pairs) < 2 or names in reported:
                continue
            reported.add(names)
            i, last = inside[-1]
            ctx.add(
                "RELATION_CYCLE",
                _at(i),
                _text(last),
                f"The {axis} relations of {listing(names)} form a circle.",
                f"Remove or correct one of: {listing(_text(e) for _, e in inside)}.",
            )


def _merge_levels(level: dict[str, str], edges: Indexed) -> None:
    def root(name: str) -> str:
        while level[name] != name:
            name = level[name]
        return name

    for _, edge in edges:
        if edge.relation_type is R.SAME_LEVEL_AS:
            a, b = root(edge.from_), root(edge.to)
            level[max(a, b)] = min(a, b)
    for name in level:
        level[name] = root(name)


def _supports(ctx: Context, edges: Indexed) -> None:
    held: dict[str, BinaryRelation] = {}
    for i, edge in edges:
        if edge.relation_type not in SUPPORTS:
            continue
        first = held.setdefault(edge.from_, edge)
        if first is not edge and first.to != edge.to:
            ctx.add(
                "RELATION_TWO_SUPPORTS",
                _at(i),
                _text(edge),
                f"{_text(edge)!r}, but also {_text(first)!r}.",
                "Keep the relation to what it directly rests on or in.",
            )
        if ctx.is_structural(edge.from_) and edge.to in ctx.nodes:
            if not ctx.is_structural(edge.to):
                ctx.add(
                    "RELATION_STRUCTURAL",
                    _at(i),
                    _text(edge),
                    f"{edge.from_!r} is structural and cannot rest on or in {edge.to!r}.",
                    "Turn the relation round, or clear is_structural.",
                )
            continue
        _agrees_with_region(ctx, i, edge)
        if edge.relation_type is R.INSIDE_OF:
            _fits(ctx, i, edge)


def _agrees_with_region(ctx: Context, i: int, edge: BinaryRelation) -> None:
    parent = ctx.support_of(edge.from_)
    if parent is None or parent == edge.to or parent not in ctx.nodes:
        return
    if edge.to in ctx.supports(edge.from_) or parent in ctx.supports(edge.to):
        return
    if ctx.is_structural(parent) and ctx.is_structural(edge.to):
        return
    ctx.add(
        "REGION_CONFLICT",
        _at(i, "to"),
        edge.to,
        f"{_text(edge)!r}, but its region {ctx.nodes[edge.from_].semantic_region!r} is a part of "
        f"{parent!r}.",
        "Let the region and the relation name one support.",
    )


def _fits(ctx: Context, i: int, edge: BinaryRelation) -> None:
    """An object goes in when its smallest cross-section passes and its volume is not larger."""
    inner, outer = ctx.dimensions_cm(edge.from_), ctx.dimensions_cm(edge.to)
    if inner is None or outer is None or ctx.is_structural(edge.to):
        return
    a, b = sorted(inner), sorted(outer)
    if any(outside(v, SIZE_CM) for v in (*a, *b)):
        return  # Reported as UNIT_SIZE already.
    if a[0] > b[1] or a[1] > b[2] or a[0] * a[1] * a[2] > b[0] * b[1] * b[2]:
        ctx.add(
            "RELATION_TOO_SMALL",
            _at(i),
            _text(edge),
            f"{edge.from_!r} ({' x '.join(f'{v:g}' for v in inner)} cm) does not fit into "
            f"{edge.to!r} ({' x '.join(f'{v:g}' for v in outer)} cm).",
            "Correct a size, or use `on` or `near`.",
        )


def _faces(ctx: Context, edges: Indexed) -> None:
    facing: dict[str, BinaryRelation] = {}
    for i, edge in edges:
        if edge.relation_type is not R.FACE:
            continue
        first = facing.setdefault(edge.from_, edge)
        if first is not edge and (first.to, first.cardinal) != (edge.to, edge.cardinal):
            ctx.add(
                "FACE_DUPLICATE",
                _at(i),
                _text(edge),
                f"{edge.from_!r} already faces {first.cardinal or first.to!r}.",
                "Keep one `face` per object.",
            )
    if not ctx.parsed.intact(*_EDGES, "binary_relations"):
        return
    # A `face` with a dangling end is reported as such already.
    turned = {e.from_ for e in ctx.graph.edges.binary_relations if e.relation_type is R.FACE}
    for name in ctx.nodes:
        if name not in turned and _has_direction(ctx, name):
            ctx.add(
                "FACE_MISSING",
                pointer("spatial_relation_graph", "nodes", name),
                name,
                f"{name!r} has a direction but faces nothing.",
                "Add one `face` relation to an object, or to the ground with a cardinal.",
            )


def _has_direction(ctx: Context, name: str) -> bool:
    """Whether the paper's "exactly one face" is asked of a node.

    Not of what looks alike from all sides, of group members (their pattern turns them), nor of
    objects that expansion added and that nothing constrains.
    """
    node = ctx.nodes[name]
    asset = ctx.requirement(node)
    if asset is None or node.is_structural or not node.mentioned or node.group is not None:
        return False
    length, width, _ = asset.expected_dimensions_cm
    if outside(length, SIZE_CM) or outside(width, SIZE_CM):
        return False  # Reported as UNIT_SIZE already.
    square = abs(length - width) <= SQUARE_RATIO * max(length, width)
    return asset.shape not in ("sphere", "cylinder", "capsule") and not square


def _multi(ctx: Context, i: int, edge: MultiRelation) -> None:
    where = pointer(*_EDGES, "multi_relations", i)
    kind = edge.relation_type
    for key, names in (("subjects", edge.subjects), ("targets", edge.targets)):
        _members(ctx, where, key, names)
    subjects, targets = set(edge.subjects), set(edge.targets)
    shared = subjects & targets
    if shared and kind is not MultiRelationType.ALIGN:
        ctx.add(
            "RELATION_SELF",
            where,
            sorted(shared),
            f"{listing(shared)} would be arranged {kind.value} itself.",
            "Name an object as subject or as target, not as both.",
        )
    least_subjects, least_targets = _ARITY[kind]
    intact = ctx.parsed.intact(*_EDGES, "multi_relations")
    if intact and (len(subjects) < least_subjects or len(targets) < least_targets):
        ctx.add(
            "RELATION_ARITY",
            where,
            {"subjects": list(edge.subjects), "targets": list(edge.targets)},
            f"{kind.value!r} has {len(subjects)} subjects and {len(targets)} targets.",
            f"Give at least {least_subjects} subjects and {least_targets} targets.",
        )
    _confidence(ctx, where + "/confidence", edge.confidence)
    if edge.spacing_cm is not None:
        _distance(ctx, where + "/spacing_cm", edge.spacing_cm)


def _members(ctx: Context, where: str, key: str, names: Iterable[str]) -> None:
    seen: set[str] = set()
    for k, name in enumerate(names):
        if name not in ctx.node_names:
            ctx.add(
                "REF_GROUP",
                f"{where}/{key}/{k}",
                name,
                f"A group names {name!r}, which is not a node.",
                f"Use one of {listing(ctx.node_names)}.",
            )
        if name in seen:
            ctx.add(
                "RELATION_DUPLICATE",
                f"{where}/{key}/{k}",
                name,
                f"{name!r} is named twice among the {key}.",
                "Name it once.",
            )
        seen.add(name)
