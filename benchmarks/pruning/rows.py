"""Rows of data that can be left out: table lines, registered phrases, words, alternatives.

A row goes by importing the package anew without it; `effect.Build` does that.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
import fnmatch
from pathlib import Path

from benchmarks.pruning.purity import called
from benchmarks.pruning.rewrite import Cuts, Text
from benchmarks.pruning.units import Package, Unit

ROW_KINDS = ("row", "pattern", "word")
"""Line of a table or call that registers one; alternative of a regular expression; word."""
VOCABULARY = ("verbs.csv", "words.txt")
"""Tables whose rows are words, not constructions."""
LEFT_ALONE = ("nouns.csv",)
_WIDTH = 99


@dataclass(frozen=True)
class Row:
    """A row and where it stands.

    Args:
        unit: As the other units.
        place: Line and column of its statement or of the display or pattern it is part of.
        index: Which element of that; -1 is the whole statement, or the line of a table.
    """

    unit: Unit
    place: tuple[int, int]
    index: int


def find_rows(package: Package) -> list[Row]:
    """Rows of a package's modules and tables in reading order."""
    out: list[Row] = []
    for name, tree in package.trees.items():
        if name not in package.kept:
            out += _module_rows(package, name, tree)
    for path in sorted((package.root / package.folder).rglob("*")):
        if path.suffix in (".csv", ".txt") and path.name not in LEFT_ALONE:
            name = path.relative_to(package.root).as_posix()
            below = path.relative_to(package.root / package.folder).as_posix()
            if not any(fnmatch.fnmatch(below, p) for p in package.leave):
                out += _table_rows(name, path)
    return out


def _unit(name: str, number: str, kind: str, first: int, last: int, text: str) -> Unit:
    lines = float(last - first + 1) if kind == "row" else round(len(text) / 80.0, 2)
    return Unit(f"{name}#{number}", kind, name, first, last, lines, "", text[:120])


def _module_rows(package: Package, name: str, tree: ast.Module) -> Iterator[Row]:
    source = package.sources[name]
    for node in tree.body:
        place = (node.lineno, node.col_offset)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            if package.purity.defined(called(node.value)):
                text = " ".join((ast.get_source_segment(source, node) or "").split())
                number = f"row{place[0]}"
                yield Row(
                    _unit(name, number, "row", place[0], node.end_lineno or 0, text), place, -1
                )
        elif isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None:
            yield from _value_rows(name, source, node.value)


def _value_rows(name: str, source: str, value: ast.expr) -> Iterator[Row]:
    waiting: list[ast.AST] = [value]
    while waiting:
        node = waiting.pop()
        items = elements(node)
        place = (getattr(node, "lineno", 0), getattr(node, "col_offset", 0))
        for k, (first, last) in enumerate(items):
            kind = "word" if isinstance(first, ast.Constant) else "row"
            text = " ".join((ast.get_source_segment(source, first) or "").split())
            number = f"{kind}{place[0]}.{place[1]}.{k}"
            yield Row(_unit(name, number, kind, first.lineno, last.end_lineno or 0, text), place, k)
        if not items:
            parts = alternatives(node)
            for k, part in enumerate(parts if len(parts) > 1 else ()):
                number = f"pattern{place[0]}.{place[1]}.{k}"
                last = getattr(node, "end_lineno", place[0])
                yield Row(_unit(name, number, "pattern", place[0], last, part), place, k)
            waiting += list(ast.iter_child_nodes(node))


def _table_rows(name: str, path: Path) -> Iterator[Row]:
    kind = "word" if path.name in VOCABULARY else "row"
    lines = path.read_text(encoding="utf-8").splitlines()
    for k, line in enumerate(lines, 1):
        if path.suffix == ".csv" and k > 1 and line:
            yield Row(_unit(name, f"{k}", kind, k, k, line), (k, 0), -1)
        elif path.suffix == ".txt" and line and not line.startswith("["):
            for n, word in enumerate(line.split()):
                yield Row(_unit(name, f"{k}.{n}", "word", k, k, word), (k, 0), n)


def elements(node: ast.AST) -> list[tuple[ast.expr, ast.expr]]:
    """First and last part of every element of a display of words or of records; else nothing."""
    if isinstance(node, ast.Dict):
        pairs = [(k, v) for k, v in zip(node.keys, node.values, strict=True) if k is not None]
        words = len(pairs) == len(node.keys) and all(_is_word(k) for k, _ in pairs)
        return pairs if words and len(pairs) > 1 else []
    if isinstance(node, ast.Set | ast.List | ast.Tuple) and len(node.elts) > 1:
        words = all(map(_is_word, node.elts))
        records = all(
            isinstance(e, ast.Tuple | ast.Call) and any(map(_is_word, ast.walk(e)))
            for e in node.elts
        )
        return [(e, e) for e in node.elts] if words or records else []
    return []


def _is_word(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def alternatives(node: ast.AST) -> list[str]:
    """Top-level alternatives of the pattern of a `re.compile` call."""
    if not (isinstance(node, ast.Call) and called(node) == "compile" and node.args):
        return []
    pattern = node.args[0]
    if not isinstance(pattern, ast.Constant) or not isinstance(pattern.value, str):
        return []
    out, depth, inside, skip = [""], 0, False, False
    for c in pattern.value:
        if skip:
            skip = False
        elif c == "\\":
            skip = True
        elif inside:
            inside = c != "]"
        elif c == "[":
            inside = True
        elif c in "()":
            depth += 1 if c == "(" else -1
        elif c == "|" and depth == 0:
            out.append("")
            continue
        out[-1] += c
    return out


class _Without(ast.NodeTransformer):
    """Takes rows out of a tree."""

    def __init__(self, rows: Iterable[Row]) -> None:
        self._gone: dict[tuple[int, int], set[int]] = {}
        for row in rows:
            self._gone.setdefault(row.place, set()).add(row.index)

    def visit(self, node: ast.AST) -> ast.AST | None:
        """Visits a node."""
        place = (getattr(node, "lineno", 0), getattr(node, "col_offset", 0))
        gone = self._gone.get(place, set())
        if isinstance(node, ast.Expr) and -1 in gone:
            return None
        if gone and elements(node):
            if isinstance(node, ast.Dict):
                node.keys = [k for n, k in enumerate(node.keys) if n not in gone]
                node.values = [v for n, v in enumerate(node.values) if n not in gone]
            elif isinstance(node, ast.Set | ast.List | ast.Tuple):
                node.elts = [e for n, e in enumerate(node.elts) if n not in gone]
                if not node.elts and isinstance(node, ast.Set):
                    return ast.copy_location(ast.Tuple([], ast.Load()), node)
        elif gone and len(parts := alternatives(node)) > 1:
            assert isinstance(node, ast.Call)
            left = "|".join(p for k, p in enumerate(parts) if k not in gone)
            node.args[0] = ast.copy_location(ast.Constant(left or r"(?!)"), node)
        self.generic_visit(node)
        return node


def tree_without(tree: ast.Module, rows: Iterable[Row]) -> ast.Module:
    """A module's tree without rows; changed in place."""
    taken = _Without(rows)
    tree.body = [s for s in tree.body if taken.visit(s) is not None]
    return ast.fix_missing_locations(tree)


def table_without(text: str, rows: Iterable[Row]) -> str:
    """A table's text without rows."""
    gone: dict[int, set[int]] = {}
    for row in rows:
        gone.setdefault(row.place[0], set()).add(row.index)
    out: list[str] = []
    for k, line in enumerate(text.splitlines(), 1):
        if -1 in gone.get(k, ()):
            continue
        if k in gone:
            line = " ".join(w for n, w in enumerate(line.split()) if n not in gone[k])
        if line or k not in gone:
            out.append(line)
    return "\n".join(out) + "\n"


def cut_rows(text: Text, cuts: Cuts, tree: ast.Module, rows: Iterable[Row]) -> None:
    """Cuts rows out of a module's source; of a display's last words one stays."""
    gone: dict[tuple[int, int], set[int]] = {}
    for row in rows:
        gone.setdefault(row.place, set()).add(row.index)
    for node in ast.walk(tree):
        here = gone.get((getattr(node, "lineno", 0), getattr(node, "col_offset", 0)), set())
        if isinstance(node, ast.Expr) and -1 in here:
            cuts.add(*text.whole_lines(node, node, comments=True), lambda: "")
        elif here and elements(node):
            _cut_elements(text, cuts, node, here)
        elif here and len(parts := alternatives(node)) > 1:
            _cut_alternatives(text, cuts, node, parts, here)


def _cut_elements(text: Text, cuts: Cuts, node: ast.AST, gone: set[int]) -> None:
    lo, hi = text.span(node)
    source = text.source
    stay = [p for k, p in enumerate(elements(node)) if k not in gone] or elements(node)[:1]
    pieces = [source[text.span(a)[0] : text.span(b)[1]] for a, b in stay]
    bare = source[lo] not in "([{"
    inner = ", ".join(pieces) + ("," if isinstance(node, ast.Tuple) and len(pieces) == 1 else "")
    start = text.line_start(lo)
    if len(inner) + hi - start > _WIDTH - 10 and not any("\n" in p for p in pieces):
        indent = " " * (len(source[start:]) - len(source[start:].lstrip()) + 4)
        rows, row = [], indent
        for piece in pieces:
            if len(row) + len(piece) + 2 > _WIDTH:
                rows.append(row.rstrip())
                row = indent
            row += f"{piece}, "
        inner = "\n" + "\n".join([*rows, row.rstrip()]) + "\n" + indent[4:]
    new = inner if bare else source[lo] + inner + source[hi - 1]
    cuts.add(lo, hi, lambda: new)


def _cut_alternatives(
    text: Text, cuts: Cuts, node: ast.AST, parts: list[str], gone: set[int]
) -> None:
    """Cuts alternatives that stand unbroken in the source; others stay."""
    assert isinstance(node, ast.Call)
    lo, hi = text.span(node.args[0])
    segment = text.source[lo:hi]
    if len(gone) == len(parts):
        gone = gone - {0}
    for k in sorted(gone):
        for written in ("|" + parts[k], parts[k] + "|"):
            if segment.count(written) == 1 and (k or written[-1] == "|"):
                segment = segment.replace(written, "")
                break
    cuts.add(lo, hi, lambda: segment)
