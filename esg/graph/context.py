"""What every rule sees: the document, its declared names, and where to report."""

from __future__ import annotations

from collections import defaultdict
from graphlib import CycleError, TopologicalSorter
from typing import Any

from esg.graph.casting import effective
from esg.graph.models import AssetRequirement, EsgDocument, Node, TimelineNode, Vec3
from esg.graph.parsing import Parsed
from esg.graph.violations import Findings

TIME_EPS_S = 1e-9

Span = tuple[float, float]


class Context:
    """A parsed document with the look-ups that rules share.

    Args:
        doc: The document, without what broke the schema.
        parsed: Where it came from; declared names include the parts that broke the schema, so that
            one mistake is not reported again as a dangling reference.
        found: Receives the violations.
    """

    def __init__(self, doc: EsgDocument, parsed: Parsed, found: Findings) -> None:
        self.doc = doc
        self.parsed = parsed
        self.found = found
        self.graph = doc.spatial_relation_graph
        self.nodes = self.graph.nodes
        self.configurations = effective(doc).asset_configurations
        """What is played: with what casting chose."""
        self.node_names = parsed.declared("spatial_relation_graph", "nodes")
        self.region_names = parsed.declared("spatial_relation_graph", "semantic_regions")
        self.asset_names = parsed.declared("asset_requirement")
        sequence = ("timeline_system", "sequence_graph", "nodes")
        self.event_names = parsed.declared_ids(*sequence)
        self.actor_names = parsed.declared("timeline_system", "actors")
        self.events_before: dict[str, list[str]] = defaultdict(list)
        """Point event -> the events that segments lead from to it."""
        self.actors_leading_to: dict[str, set[str]] = defaultdict(set)
        if doc.timeline_system is not None:
            for edge in doc.timeline_system.sequence_graph.edges:
                self.events_before[edge.to].append(edge.from_)
                if edge.from_ != edge.to:
                    self.actors_leading_to[edge.to].add(edge.actor)

    def add(self, code: str, where: str, value: Any, message: str, remedy: str) -> None:
        """Reports a violation at a pointer into the document."""
        self.found.add(code, self.parsed.original(where), value, message, remedy)

    def is_structural(self, name: str) -> bool:
        """Whether a node is part of the structure (ground, wall, road)."""
        node = self.nodes.get(name)
        return node is not None and node.is_structural

    def requirement(self, node: Node) -> AssetRequirement | None:
        """What a node's asset asks for."""
        return self.doc.asset_requirement.get(node.asset_id)

    def dimensions_cm(self, name: str) -> Vec3 | None:
        """Size of a node: the asset's if it is resolved, else the expected one."""
        node = self.nodes.get(name)
        if node is None:
            return None
        configuration = self.configurations.get(node.asset_id)
        if configuration is not None:
            return configuration.dimensions_cm
        requirement = self.requirement(node)
        return None if requirement is None else requirement.expected_dimensions_cm

    def support_of(self, name: str) -> str | None:
        """The parent object of the region a node belongs to."""
        node = self.nodes.get(name)
        region = self.graph.semantic_regions.get(node.semantic_region or "") if node else None
        return region.parent_object if region else None

    def supports(self, name: str) -> list[str]:
        """The parents of a node's region, their regions' parents and so on, nearest first."""
        chain: list[str] = []
        current = self.support_of(name)
        while current is not None and current not in chain:
            chain.append(current)
            current = self.support_of(current)
        return chain


def time_span(node: TimelineNode) -> Span | None:
    """Earliest and latest time of a point event [s]; None when it states neither."""
    if node.window is not None:
        return (min(node.window), max(node.window))
    if node.timestamp is not None:
        return (node.timestamp, node.timestamp)
    return None


def bounds(value: float | Span) -> Span:
    """A quantity as an interval."""
    return value if isinstance(value, tuple) else (value, value)


def reachable(start: str, edges: list[tuple[str, str]]) -> set[str]:
    """Events that some path leads to from `start`, without `start` unless on a cycle."""
    following: dict[str, list[str]] = defaultdict(list)
    for a, b in edges:
        following[a].append(b)
    seen: set[str] = set()
    stack = list(following[start])
    while stack:
        node = stack.pop()
        if node not in seen:
            seen.add(node)
            stack.extend(following[node])
    return seen


def components(nodes: list[str], edges: list[tuple[str, str]]) -> list[list[str]]:
    """Strongly connected components of more than one node, or of one node with a loop.

    Components and their members are sorted.
    """
    before: dict[str, set[str]] = {n: set() for n in nodes}
    inner = [(a, b) for a, b in edges if a in before and b in before]
    for a, b in inner:
        before[b].add(a)
    try:
        TopologicalSorter(before).prepare()
    except CycleError:
        after = {n: reachable(n, inner) for n in nodes}
        circles = {
            tuple(sorted(m for m in after[n] if n in after[m])) for n in nodes if n in after[n]
        }
        return [list(circle) for circle in sorted(circles)]
    return []
