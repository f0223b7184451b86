"""Placement order, parent cycles and relations that a scene implies."""

from __future__ import annotations

from esg.graph.models import EsgDocument, RelationType
from esg.layout.problem.edges import Term
from esg.layout.problem.units import Unit

SEATS = ("chair", "stool", "seat", "armchair")
FACED = ("desk", "table", "counter", "computer", "monitor", "television", "tv")


def placement_order(
    units: list[Unit], all_terms: list[Term], unit_of: dict[str, int], area: list[float]
) -> list[int]:
    """Placement order: parents first, then `to` before `from`, the larger first among equals."""
    count = len(units)
    parents = [unit_of[u.parent] if u.parent is not None else -1 for u in units]
    needs: list[set[int]] = [set() for _ in units]
    for t in all_terms:
        a = unit_of[t.nodes[0]]
        for other in t.nodes[1:]:
            if other is not None and unit_of[other] != a:
                needs[a].add(unit_of[other])
    placed: set[int] = set()
    out: list[int] = []
    while len(out) < count:
        open_ = [
            i for i in range(count) if i not in placed and (parents[i] < 0 or parents[i] in placed)
        ]

        def rank(i: int) -> tuple[bool, int, bool, float, int]:
            return (
                any(units[i].free),
                len(needs[i] - placed),
                not units[i].is_planned,
                -area[i],
                i,
            )

        best = min(open_, key=rank)
        placed.add(best)
        out.append(best)
    return out


def break_parent_cycles(units: list[Unit], unit_of: dict[str, int], notes: list[str]) -> None:
    for i, u in enumerate(units):
        seen = {i}
        at = u.parent
        while at is not None:
            k = unit_of[at]
            if k in seen:
                notes.append(f"{next(iter(u.members))} cannot stand on itself; placed in the world")
                u.parent = None
                break
            seen.add(k)
            at = units[k].parent


def implied_faces(doc: EsgDocument) -> list[tuple[str, str]]:
    """Seats turn to the desk or table that they are near, unless the prompt says otherwise."""
    graph = doc.spatial_relation_graph
    facing = {e.from_ for e in graph.edges.binary_relations if e.relation_type is RelationType.FACE}

    seats, faced = set(), set()
    for n, node in graph.nodes.items():
        c = doc.asset_configurations[node.asset_id]
        words = set(f"{c.category} {n}".lower().replace("_", " ").replace("-", " ").split())
        if words & set(SEATS):
            seats.add(n)
        elif words & set(FACED):
            faced.add(n)

    out = []
    for e in graph.edges.binary_relations:
        for a, b in ((e.from_, e.to), (e.to, e.from_)):
            if a not in graph.nodes or b not in graph.nodes or a in facing:
                continue
            if a in seats and b in faced:
                facing.add(a)
                out.append((a, b))
    return out
