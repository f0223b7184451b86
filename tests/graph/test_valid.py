"""The verifier accepts every valid document, however it is handed over, named or ordered."""

from __future__ import annotations

import json
import random
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st
import pytest

from esg.graph import EsgDocument, verify
from tests.graph.builders import VALID


@pytest.mark.parametrize("name", VALID)
def test_valid_document_has_no_violation(name: str) -> None:
    """Accept a valid document as plain JSON and as a model."""
    raw = VALID[name]()
    assert verify(raw) == ()
    assert verify(EsgDocument.model_validate_json(json.dumps(raw))) == ()


def renamed(tree: Any, names: dict[str, str]) -> Any:
    """The tree with every node name replaced, as key, value and part of a pointer."""
    if isinstance(tree, dict):
        return {names.get(k, k): renamed(v, names) for k, v in tree.items()}
    if isinstance(tree, list):
        return [renamed(v, names) for v in tree]
    if isinstance(tree, str) and "/" in tree:
        return "/".join(names.get(part, part) for part in tree.split("/"))
    return names.get(tree, tree) if isinstance(tree, str) else tree


@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(sorted(VALID)),
    st.randoms(use_true_random=False),
    st.text("abcxyz019_-.äß漢", min_size=1, max_size=8),
)
def test_names_and_order_do_not_matter(name: str, order: random.Random, prefix: str) -> None:
    """Accept a valid document whose objects have other names and whose lists another order."""
    raw = VALID[name]()
    nodes = list(raw["spatial_relation_graph"]["nodes"])
    order.shuffle(nodes)
    raw = renamed(raw, {n: f"{prefix}{i}" for i, n in enumerate(nodes)})
    graph = raw["spatial_relation_graph"]
    order.shuffle(graph["edges"]["binary_relations"])
    items = list(graph["nodes"].items())
    order.shuffle(items)
    graph["nodes"] = dict(items)
    if "timeline_system" in raw:
        order.shuffle(raw["timeline_system"]["sequence_graph"]["nodes"])
        order.shuffle(raw["timeline_system"]["sequence_graph"]["edges"])
    assert verify(raw) == ()


def test_large_documents_are_verified_in_reasonable_work() -> None:
    """Accept a chain of 400 collisions: no recursion, no path enumeration."""
    raw = VALID["chain"]()
    graph, system = raw["spatial_relation_graph"], raw["timeline_system"]
    sequence = system["sequence_graph"]
    last, event, time = "picnic_table_1", "bin_hits_table", 4.0
    for i in range(400):
        name = f"bin_{i}"
        graph["nodes"][name] = {"asset_id": "bin", "semantic_region": "ground_area"}
        system["actors"][name] = {"role": "passive"}
        window = [time + 0.5, time + 1.0]
        hit = {"id": f"hit_{i}", "event": "Collision", "participants": [last, name]}
        sequence["nodes"].append({**hit, "window": window})
        link = {"id": f"link_{i}", "from": event, "to": f"hit_{i}", "actor": last}
        sequence["edges"].append({**link, "event": "InertialConnector"})
        last, event, time = name, f"hit_{i}", window[1]
    assert verify(raw) == ()
    back = {**sequence["edges"][-1], "id": "back", "from": "hit_399", "to": "hit_0"}
    sequence["edges"].append(back)
    assert "TIMELINE_CYCLE" in {v.code for v in verify(raw)}
