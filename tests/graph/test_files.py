"""Files that are not ESG documents: one clear message each, never a traceback."""

from __future__ import annotations

import json
import os
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
import pytest

from esg.graph import EsgDocument, check_file, load_document, verify
from esg.graph.files import MAX_BYTES, parse_json
from esg.graph.violations import Findings
from esg.outcomes import UserError
from tests.graph.builders import VALID

GOOD = json.dumps(VALID["chain"]())


def write(folder: Path, data: bytes | str) -> Path:
    path = folder / "scene.json"
    path.write_bytes(data.encode() if isinstance(data, str) else data)
    return path


def test_valid_file_passes(tmp_path: Path) -> None:
    """Report a valid file as valid, with its document, exit code 0."""
    report = check_file(write(tmp_path, GOOD))
    assert report.ok and report.exit_code == 0 and report.violations == ()
    assert isinstance(report.document, EsgDocument)
    assert "valid" in report.text()
    assert load_document(tmp_path / "scene.json") == report.document


def test_byte_order_mark_is_skipped(tmp_path: Path) -> None:
    """Read a file that an editor began with a byte order mark."""
    assert check_file(write(tmp_path, b"\xef\xbb\xbf" + GOOD.encode())).ok


@pytest.mark.parametrize(
    ("data", "code", "words"),
    [
        (b"", "FILE_NOT_JSON", "empty"),
        (b"  \n ", "FILE_NOT_JSON", "empty"),
        (GOOD[: len(GOOD) // 2].encode(), "FILE_NOT_JSON", "line 1"),
        (GOOD[:-1].encode(), "FILE_NOT_JSON", "cut off"),
        (GOOD.encode() + b"}", "FILE_NOT_JSON", "Extra data"),
        (b"{'a': 1}", "FILE_NOT_JSON", "column 2"),
        (b"\x00\x01\x02glTF", "FILE_NOT_TEXT", "zero bytes"),
        (b"\x89PNG\r\n\x1a\n\xff", "FILE_NOT_TEXT", "UTF-8"),
        (GOOD.encode("utf-16"), "FILE_NOT_TEXT", "not"),
        (b"[1, 2]", "FILE_NOT_OBJECT", "list"),
        (b"3.5", "FILE_NOT_OBJECT", "float"),
        (b'"text"', "FILE_NOT_OBJECT", "str"),
        (b"null", "FILE_NOT_OBJECT", "NoneType"),
        (b"[" * 100_000, "FILE_NOT_JSON", "nested"),
        (b'{"a": ' * 50_000, "FILE_NOT_JSON", "nested"),
        (b'{"a": 1' + b"0" * 10_000 + b"}", "FILE_NOT_JSON", "digits"),
    ],
)
def test_file_that_is_no_json_object(tmp_path: Path, data: bytes, code: str, words: str) -> None:
    """Say in one violation what is wrong with the file, and refuse to load it."""
    path = write(tmp_path, data)
    report = check_file(path)
    assert [v.code for v in report.violations] == [code]
    assert words in report.text()
    assert report.exit_code == 2 and report.document is None
    with pytest.raises(UserError, match="not an ESG document") as error:
        load_document(path)
    assert error.value.exit_code == 2


def test_missing_file_folder_and_pipe(tmp_path: Path) -> None:
    """Name the path and the reason when there is no file to read; never wait for a pipe."""
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "nowhere.json", tmp_path, tmp_path / "pipe", Path("a\0b")):
        report = check_file(path)
        assert [v.code for v in report.violations] == ["FILE_UNREADABLE"]
        assert str(path) in report.text()


def test_huge_file_is_not_read(tmp_path: Path) -> None:
    """Refuse a file beyond the limit by its size alone."""
    path = tmp_path / "huge.json"
    with path.open("wb") as file:
        file.truncate(MAX_BYTES + 1)
    assert [v.code for v in check_file(path).violations] == ["FILE_TOO_LARGE"]


def test_duplicate_keys_are_found_wherever_they_are(tmp_path: Path) -> None:
    """Report every repeated key with its pointer, beside all other violations."""
    text = GOOD.replace('"car_1": {"asset_id"', '"car_1": {}, "car_1": {"asset_id"', 1)
    text = text.replace('"role": "active"', '"role": "active", "role": "active"', 1)
    text = text.replace('"expected_mass_kg": 12', '"expected_mass_kg": -12', 1)
    report = check_file(write(tmp_path, text))
    assert {(v.code, v.pointer) for v in report.violations} == {
        ("JSON_DUPLICATE_KEY", "/spatial_relation_graph/nodes/car_1"),
        ("JSON_DUPLICATE_KEY", "/timeline_system/actors/car_1/role"),
        ("UNIT_MASS", "/asset_requirement/bin/expected_mass_kg"),
    }


def test_report_is_plain_json(tmp_path: Path) -> None:
    """Write the report as JSON with counts per code."""
    raw = VALID["chain"]()
    raw["asset_requirement"]["bin"]["expected_mass_kg"] = -1.0
    raw["spatial_relation_graph"]["nodes"]["car_1"]["asset_id"] = "x"
    tree = json.loads(json.dumps(check_file(write(tmp_path, json.dumps(raw))).to_json()))
    assert tree["ok"] is False
    assert tree["counts"] == {"ASSET_UNUSED": 1, "REF_ASSET": 1, "UNIT_MASS": 1}
    assert set(tree["violations"][0]) == {"code", "pointer", "value", "remedy", "message"}


def test_schema_damage_does_not_hide_other_damage() -> None:
    """Report a wrong type, a missing field and broken rules of the remainder at once."""
    raw = VALID["chain"]()
    graph = raw["spatial_relation_graph"]
    raw["asset_requirement"]["sedan"]["expected_mass_kg"] = "heavy"
    del graph["nodes"]["car_1"]["asset_id"]
    graph["edges"]["binary_relations"][0]["relation_type"] = "hugs"
    graph["edges"]["binary_relations"][4]["to"] = "nobody"
    raw["timeline_system"]["sequence_graph"]["nodes"][2]["window"] = [4.0, 2.1]
    assert {(v.code, v.pointer) for v in verify(raw)} == {
        ("SCHEMA_TYPE", "/asset_requirement/sedan/expected_mass_kg"),
        ("SCHEMA_MISSING", "/spatial_relation_graph/nodes/car_1/asset_id"),
        ("SCHEMA_VALUE", "/spatial_relation_graph/edges/binary_relations/0/relation_type"),
        ("REF_RELATION", "/spatial_relation_graph/edges/binary_relations/4/to"),
        ("INTERVAL_REVERSED", "/timeline_system/sequence_graph/nodes/2/window"),
    }


def test_unvalidated_model_is_checked_again() -> None:
    """Find damage in a model whose validation was bypassed by model_copy."""
    doc = EsgDocument.model_validate_json(GOOD)
    spec = doc.asset_requirement["bin"].model_copy(update={"expected_mass_kg": float("nan")})
    bad = doc.model_copy(update={"asset_requirement": {**doc.asset_requirement, "bin": spec}})
    assert [v.code for v in verify(bad)] == ["JSON_NOT_FINITE"]


ANY_JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner),
    max_leaves=8,
)


def places(tree: object, path: tuple = ()) -> list[tuple]:
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    out = []
    for key, value in items:
        out.append((*path, key))
        if isinstance(value, (dict, list)):
            out += places(value, (*path, key))
    return out


@settings(max_examples=300, deadline=None)
@given(st.data())
def test_nothing_crashes_the_verifier(data: st.DataObject) -> None:
    """Answer with violations, not an exception, whatever stands at whatever place."""
    raw = VALID[data.draw(st.sampled_from(sorted(VALID)))]()
    for _ in range(data.draw(st.integers(1, 4))):
        *parents, last = data.draw(st.sampled_from(places(raw)))
        node = raw
        for part in parents:
            node = node[part]
        node[last] = data.draw(ANY_JSON)
    for violation in verify(raw):
        json.dumps(violation.to_json())


@settings(max_examples=100, deadline=None)
@given(st.dictionaries(st.text(max_size=8), ANY_JSON, max_size=4))
def test_unrelated_objects_are_refused(raw: dict) -> None:
    """Refuse any other JSON object."""
    assert verify(raw)


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200))
def test_any_bytes_are_answered(data: bytes) -> None:
    """Read or refuse any bytes without an exception."""
    found = Findings()
    tree = parse_json(data, found)
    assert (tree is None) == any(v.code.startswith("FILE_") for v in found.items)


def test_empty_scene_is_found() -> None:
    """Refuse a scene without objects."""
    raw = VALID["study"]()
    raw["spatial_relation_graph"] = {}
    raw["asset_requirement"] = {}
    assert [v.code for v in verify(raw)] == ["SCENE_EMPTY"]
