"""The shadow comparison tells which prompts a change reaches, with two tiny checkouts."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks.shadow import Difference, difference, main, plain

_DRAFT = """
class UserError(Exception): pass

def draft(prompt, *, seed=0):
    if "nothing" in prompt:
        raise UserError(REFUSAL)
    return {"words": prompt.split(), "speed": SPEED, "provenance": [VERSION]}
"""
_METAMORPHIC = """
def rows():
    yield "{a} hits", {"band": "hit", "id": "hit-0", "prompt": "A ball hits."}
    yield "{a} hits", {"band": "hit", "id": "hit-1", "prompt": "A car hits."}
"""


def _checkout(root: Path, speed: str = "3.0", refusal: str = "no thing") -> Path:
    files = {
        "esg/__init__.py": "",
        "esg/draft/__init__.py": f"SPEED = {speed}\nREFUSAL = {refusal!r}\n"
        f"VERSION = {root.name!r}\n{_DRAFT}",
        "benchmarks/__init__.py": "",
        "benchmarks/metamorphic.py": _METAMORPHIC,
        "data/prompts/single.jsonl": "".join(
            json.dumps({"id": id_, "split": split, "prompt": prompt}) + "\n"
            for id_, split, prompt in [
                ("s-1", "dev", "A fast car."),
                ("s-2", "dev", "nothing"),
                ("s-3", "test", "A secret car."),
            ]
        ),
        "data/suites/tiny.yaml": "scenes:\n- {id: T01, prompt: A suite car.}\n",
    }
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    return root


def _compare(tmp_path: Path, old: Path, new: Path, *options: str) -> int:
    return main([str(old), str(new), "--kept", str(tmp_path / "kept"), *options])


def test_equal_results_pass_whatever_their_provenance(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    old, new = _checkout(tmp_path / "old"), _checkout(tmp_path / "new", speed="3")
    assert _compare(tmp_path, old, new) == 0
    assert capsys.readouterr().out.split()[-4:] == ["draft", "5", "0", "100.00"]


def test_differences_are_named_and_fail_but_held_out_prompts_stay_unread(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    old, new = _checkout(tmp_path / "old"), _checkout(tmp_path / "new", speed="4.0")
    out = tmp_path / "out.json"
    assert _compare(tmp_path, old, new, "--out", str(out)) == 1
    text = capsys.readouterr().out
    assert "'A fast car.' differs at 1 places\n    /speed: 3 -> 4\n" in text
    assert "secret" not in text
    assert text.split()[-4:] == ["draft", "1", "4", "20.00"]
    different = json.loads(out.read_text())["draft"]["different"]
    assert different["tiny/T01"] == [{"pointer": "/speed", "old": "3", "new": "4"}]
    assert "single/s-3" not in different
    assert _compare(tmp_path, old, new, "--at-least", "0.2") == 0


def test_a_refusal_is_its_message(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    old, new = _checkout(tmp_path / "old"), _checkout(tmp_path / "new", refusal="say a thing")
    assert _compare(tmp_path, old, new) == 1
    text = capsys.readouterr().out
    assert '/refused: "no thing" -> "say a thing"' in text
    assert text.split()[-4:] == ["draft", "4", "1", "80.00"]


def test_kept_results_are_used_until_the_sources_change(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    old, new = _checkout(tmp_path / "old"), _checkout(tmp_path / "new")
    assert _compare(tmp_path, old, new) == 0
    ran: list[Path] = []
    monkeypatch.setattr("benchmarks.shadow._run_jobs", lambda root, *_: ran.append(root))
    assert _compare(tmp_path, old, new) == 0
    assert ran == []
    _checkout(tmp_path / "new", speed="5.0")
    with pytest.raises(KeyError):
        _compare(tmp_path, old, new)
    assert ran == [new]


def test_a_difference_is_a_json_pointer_with_both_values() -> None:
    old = {"a/b": [1, 2], "c": {"d": True}, "e": 1}
    new = {"a/b": [1], "c": {"d": 1}, "f": 1}
    assert list(difference(old, new)) == [
        Difference("/a~1b/1", "2", ""),
        Difference("/c/d", "true", "1"),
        Difference("/e", "1", ""),
        Difference("/f", "", "1"),
    ]


def test_equal_numbers_read_alike() -> None:
    assert plain([1.0, -0.0, 0.5, float("nan")]) == [1, 0, 0.5, "nan"]
    assert json.dumps(plain(-0.0)) == "0"
