"""Every parser against anything: a value, or a message that names a remedy; never another error."""

from __future__ import annotations

import contextlib
import json
from pathlib import Path
from typing import Any

from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st
import pytest

from esg.api.inputs import check_device
from esg.assets.imports.sources import parse_properties, read_folder
from esg.assets.imports.store import read_record
from esg.commands.serve import check_cron
from esg.dataset.distribution import load_distribution
from esg.dataset.folder import DatasetFolder
from esg.dataset.job import BatchResult
from esg.dataset.plan import Shard, read_prompts
from esg.engines.manifest import load_manifest
from esg.graph import verify
from esg.graph.files import parse_json
from esg.graph.violations import Findings
from esg.limits import stage_limits
from esg.metrics.suite import parse_suite
from esg.outcomes import UserError
from esg.scenereading import read_rollout
from esg.store import ingest, read_table
from esg.store.checking import check_recording
from esg.strangers import gltf
from esg.strangers.sums import SUMS, differences
from esg.strangers.yamlfile import read_yaml
from esg.view import png16

FEW = settings(
    max_examples=60,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)
TREE = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=4)
    ),
    max_leaves=20,
)
"""Any JSON value."""
SCENE = {
    "id": "a",
    "prompt": "A car hits a box.",
    "events": [],
    "constraints": [],
    "statements": [],
}
FIELDS = (
    "id",
    "type",
    "a",
    "b",
    "kind",
    "quantity",
    "event",
    "value",
    "unit",
    "says",
    "object",
    "after",
)
ITEM = st.dictionaries(st.sampled_from(FIELDS), TREE, max_size=6)


def only_told(function: Any, *arguments: Any) -> None:
    """Calls a parser that may refuse, with a message."""
    try:
        function(*arguments)
    except UserError as error:
        assert str(error).strip()
        assert error.exit_code in (1, 2)


@FEW
@given(st.text(max_size=200))
@example("&a [*a]")
@example("a: !!bool maybe")
@example("? [a, b]\n: c")
@example("a: 2001-13-45")
def test_yaml(text: str) -> None:
    value, mistakes = read_yaml(text)
    assert value is None or not mistakes


@FEW
@given(TREE, st.lists(ITEM, max_size=3), st.lists(ITEM, max_size=3), st.lists(ITEM, max_size=3))
@example(None, [{"id": [], "type": {}}], [{"kind": float("nan")}], [{"says": []}])
def test_suites(other: Any, events: Any, constraints: Any, statements: Any) -> None:
    scene = {**SCENE, "events": events, "constraints": constraints, "statements": statements}
    for tree in ({"suite": "x", "scenes": [scene]}, {"suite": other, "scenes": [other]}, other):
        only_told(parse_suite, json.dumps(tree))


@FEW
@given(
    st.dictionaries(
        st.sampled_from(("levels", "rules", "quantified", "speeds", "movers", "x")), TREE
    )
)
def test_distributions(tree: Any) -> None:
    only_told(load_distribution, json.dumps(tree))


@FEW
@given(TREE)
@example({"spatial_relation_graph": {"nodes": []}})
@example({"timeline_system": {"sequence_graph": {"nodes": [[]], "edges": [None]}}})
def test_documents(tree: Any) -> None:
    raw = tree if isinstance(tree, dict) else {"asset_requirement": tree, "timeline_system": tree}
    assert all(v.message and v.remedy for v in verify(raw))


@FEW
@given(st.binary(max_size=300))
@example(b"\xef\xbb\xbf{}")
@example(b"[" * 100_000)
@example(b'{"a": ' + b"1" * 5000 + b"}")
def test_json(data: bytes) -> None:
    found = Findings()
    assert parse_json(data, found) is not None or found.items


@FEW
@given(st.binary(max_size=300))
@example(b"\x80")
@pytest.mark.parametrize(
    ("name", "parser"),
    [("x.parquet", read_table), ("x.mcap", check_recording), ("manifest.json", load_manifest),
     ("x.jsonl", read_prompts), ("x.txt", read_prompts), ("x.yaml", read_prompts),
     ("mug.json", read_record), ("x.duckdb", lambda path: ingest(path, [])),
     ("x.npz", lambda path: read_rollout(path, 2)),
     ("meta/plan.json", lambda path: DatasetFolder(path.parents[1]).spec()),
     ("meta/prompts.jsonl", lambda path: DatasetFolder(path.parents[1]).prompts()),
     ("meta/run.json", lambda path: DatasetFolder(path.parents[1]).run())],
)  # fmt: skip
def test_files(name: str, parser: Any, tmp_path: Path, data: bytes) -> None:
    path = tmp_path / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(data)
    only_told(parser, path)


@FEW
@given(st.binary(max_size=300))
@example(b"glTF\x02\0\0\0\xff\xff\xff\xff")
@example(b"\x89PNG\r\n\x1a\n" + bytes(40))
@pytest.mark.parametrize("parser", [gltf.read_glb, png16.decode])
def test_bytes_of_strangers(parser: Any, data: bytes) -> None:
    """Their readers are told apart by what calls them: a ValueError says what is wrong."""
    with contextlib.suppress(ValueError):
        parser(data)


@FEW
@given(TREE)
def test_marks(tree: Any) -> None:
    with contextlib.suppress(ValueError, TypeError):
        BatchResult.from_json(json.dumps(tree))


@FEW
@given(st.text(max_size=200))
@example(f"{'0' * 64}  ../../etc/passwd")
@example(f"{'0' * 64}  a\0b")
def test_lists_of_sums(tmp_path: Path, text: str) -> None:
    (tmp_path / SUMS).write_bytes(text.encode("utf-8", "surrogatepass"))
    found = differences(tmp_path)
    assert found is not None and isinstance(found.problem, str)


@FEW
@given(TREE)
def test_json_files(tmp_path: Path, tree: Any) -> None:
    for name, parser in (("mug.json", read_record), ("manifest.json", load_manifest)):
        path = tmp_path / name
        path.write_text(json.dumps(tree))
        only_told(parser, path)
    (tmp_path / "catalogue.json").write_text(json.dumps(tree))
    only_told(lambda folder: list(read_folder(folder)), tmp_path)


@FEW
@given(st.text(max_size=60))
@example("optimize=" + "9" * 5000)
@example("9" * 5000 + " * * * *")
@example("9" * 5000 + "/" + "9" * 5001)
@example("²/²")
@example("² * * * *")
@example("cuda:²")
@example("cuda:" + "9" * 5000)
def test_options(text: str) -> None:
    for parser in (stage_limits, check_cron, Shard.parse, check_device):
        only_told(parser, text)
    assert isinstance(parse_properties(text), dict)
