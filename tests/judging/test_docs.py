"""The page for authors: its example is what it says."""

from __future__ import annotations

from pathlib import Path
import re

import pytest

from esg.judging.readers import FORMATS
from esg.judging.verdict import judge_file
from esg.metrics.suite import parse_suite

PAGE = (Path(__file__).parents[2] / "docs" / "judging.md").read_text()
SUITE = """
suite: one
scenes:
  - id: S1
    level: single
    prompt: "A ball hits a crate."
    events: [{id: e1, type: moves, object: ball}, {id: e2, type: collision, a: ball, b: crate}]
"""


def test_the_example_is_judged(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    code = re.search(r"fifteen lines\n\n```python\n(.*?)```", PAGE, re.S)
    assert code and len(code[1].splitlines()) <= 16
    exec(code[1], {})
    found = judge_file(tmp_path / "S1.npz", parse_suite(SUITE).scenes[0])
    assert found.verdict.verified and found.verdict.events[1].time_s == pytest.approx(
        0.87, abs=0.02
    )


def test_the_page_names_every_format() -> None:
    assert not [suffix for suffix in FORMATS if f"`{suffix}`" not in PAGE]
