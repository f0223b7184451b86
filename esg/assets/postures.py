"""Which postures the nodes of a document take, and how they are drawn in each."""

from __future__ import annotations

from dataclasses import dataclass, replace

from esg.assets.appearance import Appearance
from esg.assets.configuration import node_mesh_path, parametric_entry
from esg.graph.casting import effective
from esg.graph.models import AssetConfiguration, EsgDocument, Predicate, Proxy, ProxyKind
from esg.lexicon.postures import PLANS, STANDS, Posture, posture_of


@dataclass(frozen=True)
class Held:
    """A node in one of its postures.

    Args:
        node: Its id.
        row: The posture.
        name: Of the body that it is then: its own as it stands.
        mesh: Path of its GLB below the scene's folder; empty as it stands.
    """

    node: str
    row: Posture
    name: str
    mesh: str

    def drawn(self, look: Appearance) -> Appearance:
        """How it is drawn, by how it is drawn as it stands."""
        return replace(look, pose=self.row.pose)


def plan_drawn(doc: EsgDocument, name: str) -> str | None:
    """The plan of the body that is drawn for a node (`PLANS`); None for no person or animal.

    Args:
        doc: A resolved document.
        name: Id of a node, or of a body that is none.
    """
    node = doc.spatial_relation_graph.nodes.get(name)
    config = None if node is None else doc.asset_configurations.get(node.asset_id)
    entry = None if config is None else parametric_entry(config)
    return None if entry is None else PLANS.get(entry.builder)


def held(doc: EsgDocument, name: str, posture: str, on: str | None) -> Held | None:
    """A node in a posture; None if it has none of the kind.

    Args:
        doc: A resolved document.
        name: Id of the node.
        posture: Which.
        on: Id of what it sits or lies on; None for the ground.
    """
    plan = plan_drawn(doc, name)
    row = None if plan is None else posture_of(plan, posture, "seat" if on else "ground")
    if row is None:
        return None
    if posture == STANDS:
        return Held(name, row, name, "")
    own = f"{name}_{posture}" + ("_on" if row.on == "seat" else "")
    return Held(name, row, own, node_mesh_path(config_of(doc, name).mesh_path, own))


def seat_of(doc: EsgDocument, name: str) -> str | None:
    """What somebody is on at the start that is no ground."""
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions.get(graph.nodes[name].semantic_region or "")
    below = None if region is None else region.parent_object
    return below if below in graph.nodes and not graph.nodes[below].is_structural else None


def at_first(doc: EsgDocument) -> dict[str, Held]:
    """The postures in which nodes begin that do not stand, by node: as statements say it."""
    out: dict[str, Held] = {}
    for s in doc.statements or ():
        if s.predicate is Predicate.POSTURE and s.when.split("..")[0] in ("start", "throughout"):
            for name in s.object:
                found = held(doc, name, s.noun or "", seat_of(doc, name))
                if found is not None and found.mesh:
                    out.setdefault(name, found)
    return out


def changes_posture(doc: EsgDocument) -> set[str]:
    """Who sits, lies down or gets up in the course of a scene."""
    edges = doc.timeline_system.sequence_graph.edges if doc.timeline_system else ()
    return {e.actor for e in edges if e.params.posture is not None}


def taken(doc: EsgDocument) -> dict[str, tuple[Held, ...]]:
    """Every posture but standing that a node takes, by node."""
    doc = effective(doc)
    out: dict[str, dict[str, Held]] = {n: {h.name: h} for n, h in at_first(doc).items()}
    edges = doc.timeline_system.sequence_graph.edges if doc.timeline_system else ()
    for edge in edges:
        told = edge.params.posture
        found = None if told is None else held(doc, edge.actor, told, edge.target)
        if found is not None and found.mesh:
            out.setdefault(edge.actor, {})[found.name] = found
    return {n: tuple(of.values()) for n, of in out.items()}


def config_of(doc: EsgDocument, name: str) -> AssetConfiguration:
    """The configuration of a node."""
    return doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]


def with_room_to_lie(doc: EsgDocument) -> EsgDocument:
    """A resolved document in which people who lie on the ground at first are as large as that."""
    first = {n: h for n, h in at_first(doc).items() if h.row.plan == "people"}
    lying = {n: h for n, h in first.items() if h.row.posture == "lies" and not seat_of(doc, n)}
    if not lying:
        return doc
    configs = dict(doc.asset_configurations)
    nodes = doc.spatial_relation_graph.nodes
    for name, h in lying.items():
        key = nodes[name].asset_id
        if all(n in lying for n, node in nodes.items() if node.asset_id == key):
            size = h.row.size(doc.asset_configurations[key].dimensions_cm)
            x, y, z = (0.5 * v for v in size)
            box = Proxy(kind=ProxyKind.BOX, size_cm=(x, y, z), position_cm=(0.0, 0.0, z))
            configs[key] = configs[key].model_copy(
                update={"dimensions_cm": size, "proxies": (box,), "support_surfaces": ()}
            )
    return doc.model_copy(update={"asset_configurations": configs})
