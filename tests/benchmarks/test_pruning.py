"""Leave-one-out pruning on a toy reader: units, effects, the choice, the shorter source."""

from __future__ import annotations

import ast
from collections.abc import Iterator
import importlib
from pathlib import Path
import sys
from typing import Any

import pytest

from benchmarks.pruning import dead, rewrite
from benchmarks.pruning.choice import Choice
from benchmarks.pruning.effect import Bench, Build, Case, Effect, Outcome, Subject
from benchmarks.pruning.rows import cut_rows
from benchmarks.pruning.units import Package

READER = '''"""A reader of sentences."""

from __future__ import annotations

from functools import lru_cache
import re

_GLIDES = frozenset({"glides"})
"""What serves one prompt."""
_ROLLS = frozenset({"rolls"})


@lru_cache(maxsize=64)
def singular(word: str) -> str:
    if word.endswith("s"):
        return word[:-1]
    return word


def seldom(word: str) -> bool:
    """Only for one branch."""
    return re.match("gl", word) is not None


def tidy(words: list[str]) -> list[str]:
    return [w for w in words if w != "um"]


def note(found: list[str], word: str) -> None:
    found.append(f"noted {word}")


def read(text: str) -> list[str]:
    if not text:
        raise ValueError("no text")
    words = tidy(text.lower().split())
    found: list[str] = []
    for word in words:
        # what moves in silence
        if word in _GLIDES and seldom(word):
            found.append("slide")  # "a puck glides"
        elif word in _ROLLS or word == "spins":
            found.append("turn")
        else:
            found.append(singular(word))
    if len(found) > 20:
        return found[:20]
    if "unheard" in words:
        note(found, "unheard")
    return found
'''
PROMPTS = {
    "a:1": ("Ball rolls", "ball turn"),
    "a:2": ("Can rolls", "can turn"),
    "b:1": ("um two balls rolls", "two ball turn"),
    "b:2": ("um coins", "coin"),
    "c:1": ("um cans", "can"),
    "c:2": ("Puck glides", "puck slide"),
    "d:1": ("Top spins", "top turn"),
}


class Toy(Subject):
    """Judged by words that are found and wanted."""

    package = "toy_reader"

    def reader(self) -> Any:
        return importlib.import_module("toy_reader.reader").read

    def judge(self, case: Case, result: Any) -> tuple[float, tuple[float, ...]]:
        wanted = case.row.split()
        right = sum(w in (result or ()) for w in wanted) - max(0, len(result or ()) - len(wanted))
        return float(right), (float(right), float(len(wanted)))

    def drops(self, before: dict[str, list[float]], after: dict[str, list[float]]) -> Any:
        return {c: 100.0 * (before[c][0] - after[c][0]) / before[c][1] for c in before}


@pytest.fixture
def root(tmp_path: Path) -> Iterator[Path]:
    """A repository with the toy reader; imports are as before afterwards."""
    folder = tmp_path / "toy_reader"
    folder.mkdir()
    (folder / "__init__.py").write_text("", encoding="utf-8")
    (folder / "reader.py").write_text(READER, encoding="utf-8")
    (tmp_path / "user.py").write_text("from toy_reader.reader import read\n", encoding="utf-8")
    finders = list(sys.meta_path)
    yield tmp_path
    sys.meta_path[:] = finders
    for name in [m for m in sys.modules if m.startswith("toy_reader")]:
        del sys.modules[name]


def bench_of(root: Path) -> Bench:
    build = Build(Package(root, "toy_reader"), "toy_reader")
    with build.installed():
        cases = [Case(n, p, n, "toy", row) for n, (p, row) in PROMPTS.items()]
        bench = Bench(build, Toy(), cases)
    bench.warm()
    return bench


def effect(bench: Bench, kind: str, start: str) -> Effect:
    (unit,) = [u for u in bench.build.units if u.kind == kind and u.text.startswith(start)]
    return bench.effect([bench.build.numbers[unit.key]], most=50, enough=3)


def test_units_leave_guards_and_refusals_alone(root: Path) -> None:
    """Emptiness, bounds and refusals are no units."""
    units = Package(root, "toy_reader").units()
    texts = [u.text for u in units if u.kind == "branch"]
    assert not any("no text" in t or "len(found)" in t for t in texts)
    assert sorted(u.kind for u in units) == [
        "and", "and", "branch", "branch", "branch", "branch", "or", "or", "stage", "step",
    ]  # fmt: skip


def test_effect_counts_families_that_lose(root: Path) -> None:
    """A branch is worth the families whose prompts lose without it, cached functions included."""
    bench = bench_of(root)
    assert effect(bench, "branch", "if word in _GLIDES").worse == ("c:2",)
    assert effect(bench, "branch", "elif").helps == 3
    assert effect(bench, "branch", 'if word.endswith("s")').helps == 3
    assert effect(bench, "or", 'word == "spins"').worse == ("d:1",)
    assert effect(bench, "stage", "tidy").helps == 3
    assert effect(bench, "branch", 'if "unheard"').reach == 0
    again = [bench.outcome(k) for k in range(len(bench.cases))]
    assert again == bench.before


def test_pruned_source_reads_as_with_the_units_left_out(root: Path) -> None:
    """What is cut and swept equals the switched-off build; comments of what stays do, too."""
    bench = bench_of(root)
    build = bench.build
    numbers = [
        n
        for n, u in enumerate(build.units)
        if u.kind == "branch" and ("_GLIDES" in u.text[:24] or "unheard" in u.text)
    ]
    effects = {n: bench.effect([n], 50, 3) for n in numbers}
    state = Choice(bench, effects, 1, {"toy": 50.0}).run(numbers)
    assert state.gone == set(numbers)
    assert sum(state.cost.values()) == 1.0
    expected: list[Outcome] = []
    with build.without(state.gone):
        expected += [bench.outcome(k) for k in range(len(bench.cases))]
    package = build.package
    name = "toy_reader/reader.py"
    keys = {build.units[n].key for n in state.gone}
    found = [f for f in package.find(name) if f.unit.key in keys]
    text = rewrite.without(READER, package.trees[name], found)
    (root / name).write_text(text, encoding="utf-8")
    dead.sweep(root, "toy_reader", ["."])
    after = (root / name).read_text(encoding="utf-8")
    for word in ("_GLIDES", "seldom", "import re", "serves one prompt", "in silence", "note"):
        assert word not in after
    assert 'if word in _ROLLS or word == "spins":' in after
    space: dict[str, Any] = {}
    exec(compile(after, name, "exec"), space)
    got = [repr(space["read"](c.prompt)) for c in bench.cases]
    assert got == [o.mark[0] for o in expected]


def test_budget_ends_the_choice(root: Path) -> None:
    """A batch that costs more points than allowed is halved, and its costly half stays."""
    bench = bench_of(root)
    numbers = [n for n, u in enumerate(bench.build.units) if u.kind == "branch"]
    effects = {n: bench.effect([n], 50, 3) for n in numbers}
    state = Choice(bench, effects, 1, {"toy": 0.0}).run(numbers)
    lost = {n for n in numbers if effects[n].lost > 0}
    assert lost and not lost & state.gone


@pytest.mark.parametrize(
    ("source", "gone", "after"),
    [
        ("if a.x == 'p' and (b == 1 or c == 2):\n        return 1", {"or": "b == 1"},
         "if a.x == 'p' and c == 2:\n        return 1"),
        ("if a.x == 'p':\n        return 1\n    elif b == 2:\n        return 2\n    else:\n"
         "        return 3", {"branch": "if a"},
         "if b == 2:\n        return 2\n    else:\n        return 3"),
        ("if a.x == 'p':\n        return 1\n    else:\n        # why\n        return 3",
         {"branch": "if a"}, "# why\n    return 3"),
        ("return 1 + (2 if b == 3 else c)", {"choice": "2 if"}, "return 1 + (c)"),
    ],
)  # fmt: skip
def test_cut(source: str, gone: dict[str, str], after: str, tmp_path: Path) -> None:
    """Operands, branches and choices are cut as a person would."""
    text = f"def f(a: object, b: int, c: int) -> int:\n    {source}\n"
    (tmp_path / "toy").mkdir()
    (tmp_path / "toy" / "m.py").write_text(text, encoding="utf-8")
    package = Package(tmp_path, "toy")
    found = [
        f
        for f in package.find("toy/m.py")
        if any(f.unit.kind == k and f.unit.text.startswith(t) for k, t in gone.items())
    ]
    assert len(found) == len(gone)
    cut = rewrite.without(text, package.trees["toy/m.py"], found)
    assert cut == f"def f(a: object, b: int, c: int) -> int:\n    {after}\n"
    ast.parse(cut)


ROWS = '''"""Words."""

import re

WORDS = frozenset({"one", "two"})
KINDS = {"ball": 1, "box": 2}
NAMED: dict[str, int] = {}


def add(name: str, value: int) -> None:
    NAMED[name] = value


add("red", 1)
add("blue", 2)  # rare
_HIT = re.compile(r"hits|(?:a|b)c|bumps")


def read(text: str) -> list[str]:
    known = WORDS | KINDS.keys() | NAMED.keys()
    return [w for w in text.split() if w in known or _HIT.match(w)]
'''


def test_rows_go_by_importing_anew(root: Path) -> None:
    """Words, keys, registered rows and alternatives are left out and cut alike."""
    name = "toy_reader/reader.py"
    (root / name).write_text(ROWS, encoding="utf-8")
    build = Build(Package(root, "toy_reader"), "toy_reader")
    cases = [
        Case(w, w, w, "toy", w)
        for w in ("one", "two", "ball", "box", "red", "blue", "hits", "ac", "bumps", "none")
    ]
    with build.installed():
        bench = Bench(build, Toy(), cases)
    bench.warm()
    kinds = [build.units[n].kind for n in range(build.switches, len(build.units))]
    assert sorted(kinds) == ["pattern"] * 3 + ["row"] * 2 + ["word"] * 4
    rows = list(range(build.switches, len(build.units)))
    reach = bench.reach_of_rows(rows)
    assert {len(c or ()) for c in reach.values()} == {9}
    for number in rows:
        bench.reached[number] = reach[number] or []
        found = bench.effect([number], 50, 3)
        assert found.helps == 1 and found.read == 9
    assert [bench.outcome(k) for k in range(len(cases))] == bench.before
    gone = [build.rows[n - build.switches] for n in rows
            if any(w in build.units[n].text for w in ("two", "box", "blue", "bumps"))]  # fmt: skip
    package = build.package

    def cut(text: rewrite.Text, cuts: rewrite.Cuts, tree: ast.Module) -> None:
        cut_rows(text, cuts, tree, gone)

    after = rewrite.without(ROWS, package.trees[name], [], cut)
    for word in ("two", "box", "blue", "rare", "bumps"):
        assert word not in after
    assert 'frozenset({"one"})' in after and '{"ball": 1}' in after
    assert 'r"hits|(?:a|b)c")' in after
