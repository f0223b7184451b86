"""The house in numbers and the ratchet, on a house of a few modules."""

from __future__ import annotations

import importlib.util
from pathlib import Path
import sys
from types import ModuleType

import pytest

from benchmarks.house import Place, main, measure

ROOT = Path(__file__).resolve().parents[2]
_SOURCES = {
    "esg/__init__.py": "",
    "esg/graph/__init__.py": "from esg.graph.models import Node\n",
    "esg/graph/models.py": "class Node: pass\nclass Leaf(Node): pass\n",
    "esg/graph/deep.py": "from esg.graph import Node as Base\n"
    "class One(Base): pass\nclass Two(One): pass\n",
    "esg/layout/__init__.py": "",
    "esg/layout/a.py": "from typing import TYPE_CHECKING\n"
    "if TYPE_CHECKING:\n    from esg.layout.c import C\n"
    "def f():\n    from esg.layout.b import g\n    return g\n",
    "esg/layout/b.py": "from esg.layout import a\ndef g(): return a.f\n",
    "esg/layout/c.py": "from esg.layout.a import f\nclass C: pass\n",
    "tasks/long.py": "def short(): pass\ndef long():\n" + "    pass\n" * 100,
}


@pytest.fixture
def house(tmp_path: Path) -> Path:
    for name, text in _SOURCES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def test_modules_lines_and_functions_are_counted_by_room(house: Path) -> None:
    found = measure(house)
    assert found.modules == {"esg": 1, "graph": 3, "layout": 4, "tasks": 1}
    assert found.lines["tasks"] == 102
    assert found.functions == [Place("tasks", "tasks/long.py:2", "long: 101 lines", 101)]
    assert found.totals()["functions over 100 lines"] == 1


def test_chains_are_followed_through_names_and_packages(house: Path) -> None:
    found = measure(house)
    assert found.deepest_chain == 3
    assert [p.text for p in found.chains] == ["Two: 3 deep"]


def test_circles_count_imports_in_functions_but_none_for_type_checkers(house: Path) -> None:
    found = measure(house)
    assert [(p.room, p.where, p.text) for p in found.circles] == [
        ("layout", "esg.layout.a", "needs itself through esg.layout.b")
    ]
    assert found.start_circles == []
    (house / "esg/layout/a.py").write_text("from esg.layout import b\n")
    assert [p.size for p in measure(house).start_circles] == [2]


def test_two_houses_are_printed_side_by_side(
    house: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([str(house), str(ROOT)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split() == [house.name[-16:], ROOT.name[-16:]]
    assert lines[1].split()[:2] == ["modules", "9"]


@pytest.fixture
def ratchet() -> ModuleType:
    spec = importlib.util.spec_from_file_location("ratchet", ROOT / ".ci" / "ratchet.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["ratchet"] = module
    spec.loader.exec_module(module)
    return module


def test_a_number_that_grows_is_told_with_place_and_remedy(ratchet: ModuleType) -> None:
    circle = Place("layout", "esg.layout.a", "needs itself through esg.layout.b", 2)
    lines = list(ratchet.grown({"import_circles": {"layout": 0}}, {"import_circles": [circle]}))
    assert lines == [
        "layout: import circles at run time: 1, at most 0 allowed",
        "    esg.layout.a  needs itself through esg.layout.b",
        "  remedy: move what both need below them, or pass it as an argument",
    ]
    assert (
        list(ratchet.grown({"import_circles": {"layout": 1}}, {"import_circles": [circle]})) == []
    )
    assert list(ratchet.grown({}, {"import_circles": [circle]})) == lines


def test_numbers_are_lowered_only_where_they_were_counted(ratchet: ModuleType) -> None:
    allowed = {"type_errors": {"draft": 5}, "import_circles": {"layout": 2, "assets": 1}}
    now = {"import_circles": {"layout": 1, "assets": 3}}
    assert ratchet.lowered(allowed, now) == {
        "type_errors": {"draft": 5},
        "import_circles": {"assets": 1, "layout": 1},
    }


def test_the_file_must_be_lowered_when_something_is_gone(
    ratchet: ModuleType,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    file = tmp_path / "ratchet.json"
    file.write_text('{"import_circles": {"layout": 2}}')
    one = Place("layout", "esg.layout.a", "needs itself through esg.layout.b", 2)
    monkeypatch.setattr(ratchet, "FILE", file)
    monkeypatch.setattr(ratchet, "faults", lambda types: {"import_circles": [one]})
    assert ratchet.main([]) == 1
    assert "layout: import circles at run time: 1, no longer 2" in capsys.readouterr().out
    assert ratchet.main(["--update"]) == 0
    assert ratchet.main([]) == 0
    monkeypatch.setattr(ratchet, "faults", lambda types: {"import_circles": [one, one]})
    assert ratchet.main([]) == 1
    assert ratchet.main(["--update"]) == 1
    assert '"layout": 1' in file.read_text()
