"""Documents of strangers: too many values, huge numbers, a hundred thousand mistakes."""

from __future__ import annotations

import json
from pathlib import Path
import time
from typing import Any

import pytest

from esg.draft import draft
from esg.graph import check_file, verify
from esg.graph.canonical import plain
from esg.graph.parsing import MAX_NODES, MAX_VALUES


@pytest.fixture
def raw() -> dict[str, Any]:
    return plain(draft("A ball rolls and hits a box.").model_dump(by_alias=True))


def unknown(raw: dict[str, Any]) -> None:
    raw.update({f"k{k}": 1 for k in range(50_000)})


def no_edges(raw: dict[str, Any]) -> None:
    raw["spatial_relation_graph"]["edges"]["binary_relations"] += [3] * 50_000


def empty_edges(raw: dict[str, Any]) -> None:
    raw["spatial_relation_graph"]["edges"]["binary_relations"] += [{} for _ in range(16_000)]


@pytest.mark.parametrize("damage", [unknown, no_edges, empty_edges])
def test_fifty_thousand_mistakes_are_all_told(damage: Any, raw: dict[str, Any]) -> None:
    """A minute, when every mistake was compared with every other."""
    damage(raw)
    start = time.monotonic()
    found = verify(raw)
    assert time.monotonic() - start < 30
    assert len(found) >= 48_000
    assert len({v.pointer for v in found}) == len(found)


def test_a_document_with_too_much_is_refused_at_once(raw: dict[str, Any], tmp_path: Path) -> None:
    nodes = raw["spatial_relation_graph"]["nodes"]
    some = next(iter(nodes.values()))
    many = {**raw, "spatial_relation_graph": {"nodes": dict.fromkeys(map(str, range(2000)), some)}}
    (found,) = verify(many)
    assert (found.code, str(MAX_NODES) in found.message) == ("DOCUMENT_TOO_LARGE", True)
    (found,) = verify({**raw, "x": [[0] * 1000] * 201})
    assert (found.code, str(MAX_VALUES) in found.message) == ("DOCUMENT_TOO_LARGE", True)
    path = tmp_path / "esg.json"
    path.write_text(json.dumps(many))
    assert check_file(path).exit_code == 2


def test_a_mistake_hides_none_behind_it(raw: dict[str, Any]) -> None:
    """What is cut out of a list moves the rest: pointers go on naming the original places."""
    edges = raw["spatial_relation_graph"]["edges"]["binary_relations"]
    edges.insert(0, 3)
    edges.append({**edges[1], "to": "nobody"})
    found = {v.pointer: v.code for v in verify(raw)}
    where = "/spatial_relation_graph/edges/binary_relations"
    assert found[f"{where}/0"] == "SCHEMA_TYPE"
    assert found[f"{where}/{len(edges) - 1}/to"] == "REF_RELATION"
