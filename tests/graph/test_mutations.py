"""The verifier catches every generated corruption with the right code, and nothing besides."""

from __future__ import annotations

from pathlib import Path
import re

import pytest

from esg.graph import RULES, verify
from tests.graph.mutations import Corruption, corruptions

ALL = list(corruptions())
FILE_CODES = {c for c in RULES if c.startswith("FILE_")} | {
    "JSON_DUPLICATE_KEY",
    "DOCUMENT_TOO_LARGE",
}


def failures(cases: list[Corruption]) -> list[str]:
    out: list[str] = []
    for case in cases:
        found = verify(case.raw)
        codes = {v.code for v in found}
        if not any(v.code == case.code and v.pointer.startswith(case.pointer) for v in found):
            out.append(f"{case.name}: missed; found {[str(v) for v in found]}")
        elif codes - {case.code} - case.also:
            extra = [str(v) for v in found if v.code not in case.also | {case.code}]
            out.append(f"{case.name}: false alarm {extra}")
    return out


@pytest.mark.parametrize("code", sorted({c.code for c in ALL}))
def test_corruption_is_caught(code: str) -> None:
    """Report the damage with its code at its place, and no unrelated violation."""
    problems = failures([c for c in ALL if c.code == code])
    assert not problems, "\n".join(problems)


def test_there_are_many_different_corruptions() -> None:
    """Keep the proof large: at least 250 distinct corruptions."""
    assert len({c.name for c in ALL}) == len(ALL) >= 250


def test_every_rule_is_proved() -> None:
    """Leave no rule without a corruption that it alone must catch."""
    assert {c.code for c in ALL} | FILE_CODES | {"SCENE_EMPTY"} == set(RULES)


def test_violations_are_complete() -> None:
    """Give every violation a place, a message and a remedy, and never twice the same."""
    for case in ALL:
        found = verify(case.raw)
        assert len({(v.code, v.pointer, v.message) for v in found}) == len(found), case.name
        for v in found:
            assert v.code in RULES and v.message.endswith(".") and v.remedy.endswith("."), case.name
            assert v.pointer == "" or v.pointer.startswith("/"), case.name


def test_documented_rules_are_in_sync() -> None:
    """Keep the table of codes in docs/graph/codes.md what RULES says."""
    text = (Path(__file__).parents[2] / "docs" / "graph" / "codes.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `([A-Z_]+)` \| (.+) \|$", text, re.MULTILINE)
    assert rows == list(RULES.items())
