"""Nodes and joints of a document for the parts of imported models."""

from __future__ import annotations

import re

from esg.assets.imports.imported import configure_imported
from esg.assets.imports.store import as_entry, find_record, joined_records
from esg.assets.library.catalogue import Entry, normalize
from esg.assets.library.lookup import exact, head_phrase
from esg.assets.library.retrieve import Decision
from esg.graph.models import AssetConfiguration, AssetRequirement, EsgDocument, Joint, Node


def named_model(requirement: AssetRequirement) -> Entry | None:
    """The model with joints, or the part of one, that a requirement names; else None.

    The words are compared with the model's name; names of the parametric library stay its own.
    """
    if "/" in requirement.asset_category:
        found = find_record(requirement.asset_category)
        return None if found is None else as_entry(found[1], found[0].name)
    said = requirement.asset_description.partition(":")[0]
    phrases = {head_phrase(said), head_phrase(requirement.asset_category.replace("_", " "))}
    best: Entry | None = None
    for folder, record in joined_records():
        name = normalize(record["name"])
        if exact(name) is None and any(f" {p}".endswith(f" {name}") for p in phrases):
            entry = as_entry(record, folder.name)
            if best is None or len(name) > len(normalize(best.synonyms[0])):
                best = entry
    return best


def with_parts(doc: EsgDocument) -> EsgDocument:
    """The document with the parts of its imported models as nodes, and their joints.

    The node that the prompt names stays the root of its model; of a resolved document.
    """
    graph = doc.spatial_relation_graph
    nodes, joints = dict(graph.nodes), list(graph.joints or ())
    assets, needs = dict(doc.asset_configurations), dict(doc.asset_requirement)
    known = {j.id for j in joints}
    for name, node in graph.nodes.items():
        config = assets.get(node.asset_id)
        found = _model_of(config)
        if config is None or found is None:
            continue
        library = config.asset_name.partition("/")[0]
        here: dict[str, str] = {config.asset_name.partition("/")[2]: name}
        for part in found:
            if f"{name}.{part.id}" in known:
                continue
            record = find_record(f"{library}/{part.child}")
            if record is None:
                continue
            entry = as_entry(record[1], library)
            word = _word(part.child)
            asset, child = f"{node.asset_id}.{word}", f"{name}.{word}"
            here[part.child] = child
            needs[asset] = _need(config.asset_name, entry, needs[node.asset_id])
            assets[asset] = configure_imported(asset, needs[asset], Decision(entry, 1.0, ()))
            nodes[child] = Node(
                asset_id=asset,
                semantic_region=node.semantic_region,
                label=f"{word.replace('_', ' ')} of the {node.label or name}",
                mentioned=False,
            )
            ends = {"child": child, "parent": here[part.parent or ""]}
            joints.append(part.model_copy(update={"id": f"{name}.{part.id}", **ends}))
    if len(nodes) == len(graph.nodes):
        return doc
    graph = graph.model_copy(update={"nodes": nodes, "joints": tuple(joints)})
    return doc.model_copy(
        update={
            "spatial_relation_graph": graph,
            "asset_configurations": assets,
            "asset_requirement": needs,
        }
    )


def _model_of(config: AssetConfiguration | None) -> list[Joint] | None:
    if config is None or config.source != "library":
        return None
    found = find_record(config.asset_name)
    return [Joint.model_validate(j) for j in found[1].get("joints", ())] if found else None


def _word(key: str) -> str:
    return re.sub(r"[^a-z0-9_]+", "_", key.partition(".")[2])


def _need(model: str, entry: Entry, whole: AssetRequirement) -> AssetRequirement:
    """What the document asks for where a model brings a part along."""
    return AssetRequirement(
        asset_category=f"{model.partition('/')[0]}/{entry.name}",
        asset_description=f"{entry.synonyms[0]}: a part of {model}",
        expected_dimensions_cm=entry.dimensions_cm,
        expected_mass_kg=entry.mass_kg,
        is_movable=True,
        linear_damping=whole.linear_damping,
    )
