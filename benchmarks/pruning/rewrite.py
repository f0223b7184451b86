"""Source without some of its units: branches, operands and steps cut out, the rest as it was."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable
from dataclasses import dataclass
import re

from benchmarks.pruning.units import Found

_ELSE = re.compile(r"^[ \t]*else[ \t]*:", re.MULTILINE)


class Text:
    """Source with offsets of the positions that `ast` tells (columns there count bytes)."""

    def __init__(self, source: str) -> None:
        self.source = source
        self._rows = source.splitlines(keepends=True)
        self._starts = [0]
        for row in self._rows:
            self._starts.append(self._starts[-1] + len(row))

    def at(self, line: int, column: int) -> int:
        """Offset of a position."""
        row = self._rows[line - 1]
        return self._starts[line - 1] + len(row.encode()[:column].decode())

    def span(self, node: ast.AST) -> tuple[int, int]:
        """Start and end of a node."""
        n: ast.expr = node  # type: ignore[assignment]
        return self.at(n.lineno, n.col_offset), self.at(n.end_lineno or 0, n.end_col_offset or 0)

    def line_start(self, offset: int) -> int:
        """Start of the line of an offset."""
        return self.source.rfind("\n", 0, offset) + 1

    def line_end(self, offset: int) -> int:
        """Start of the line after that of an offset."""
        end = self.source.find("\n", offset)
        return len(self.source) if end < 0 else end + 1

    def whole_lines(self, first: ast.AST, last: ast.AST, comments: bool = False) -> tuple[int, int]:
        """Lines of statements, with the comments right above them if wanted."""
        lo = self.line_start(self.span(first)[0])
        decorators = getattr(first, "decorator_list", [])
        if decorators:
            lo = self.line_start(self.span(decorators[0])[0])
        hi = self.line_end(self.span(last)[1])
        if comments:
            indent = self.source[lo : lo + len(self.source[lo:]) - len(self.source[lo:].lstrip())]
            while lo:
                above = self.line_start(lo - 1)
                row = self.source[above:lo]
                if not row.lstrip().startswith("#") or not row.startswith(indent + "#"):
                    break
                lo = above
        return lo, hi

    def with_parentheses(self, lo: int, hi: int, within: tuple[int, int]) -> tuple[int, int]:
        """A span with the parentheses around it that lie within another."""
        while True:
            before = len(self.source[:lo].rstrip()) - 1
            after = hi + len(self.source[hi:]) - len(self.source[hi:].lstrip())
            inside = within[0] <= before and after < within[1]
            if not inside or self.source[before] != "(" or self.source[after : after + 1] != ")":
                return lo, hi
            lo, hi = before, after + 1


@dataclass(frozen=True)
class Edit:
    """A piece of text and what gives its replacement."""

    lo: int
    hi: int
    new: Callable[[], str]


class Cuts:
    """Replacements of pieces of one source that may lie inside one another."""

    def __init__(self, text: Text) -> None:
        self.text = text
        self._edits: list[Edit] = []

    def add(self, lo: int, hi: int, new: Callable[[], str]) -> None:
        """Replaces a piece; `new` may render smaller pieces."""
        self._edits.append(Edit(lo, hi, new))

    def render(self, lo: int, hi: int, within: Edit | None = None) -> str:
        """A piece of the source with the edits in it made.

        Args:
            lo: Its start.
            hi: Its end.
            within: The edit that asks; only smaller ones are made.
        """
        inside = [e for e in self._edits if lo <= e.lo and e.hi <= hi and e is not within]
        if within is not None:
            size = within.hi - within.lo
            inside = [e for e in inside if e.hi - e.lo < size]
        inside.sort(key=lambda e: (e.lo, -e.hi))
        out: list[str] = []
        at = lo
        for edit in inside:
            if edit.lo < at:
                continue  # inside the one before
            out.append(self.text.source[at : edit.lo])
            out.append(edit.new())
            at = edit.hi
        return "".join(out) + self.text.source[at:hi]

    def result(self) -> str:
        """The whole source."""
        return self.render(0, len(self.text.source))


def without(
    source: str,
    tree: ast.Module,
    found: Iterable[Found],
    more: Callable[[Text, Cuts, ast.Module], None] | None = None,
) -> str:
    """Source without units.

    Args:
        source: Text of a module.
        tree: Its tree, in which the units were found.
        found: Units to take out.
        more: Adds further cuts.
    """
    rewriter = _Rewriter(source, tree, list(found))
    if more is not None:
        more(rewriter.text, rewriter.cuts, tree)
    return rewriter.run()


class _Rewriter:
    def __init__(self, source: str, tree: ast.Module, found: list[Found]) -> None:
        self.text = Text(source)
        self.cuts = Cuts(self.text)
        self.tree = tree
        self.branches = {f.node for f in found if f.unit.kind == "branch"}
        self.steps = {f.node for f in found if f.unit.kind == "step"}
        self.others = [f for f in found if f.unit.kind in ("choice", "stage")]
        self.operands: dict[ast.BoolOp, set[ast.AST]] = {}
        for f in found:
            if f.parent is not None:
                self.operands.setdefault(f.parent, set()).add(f.node)
        self.parents = {c: n for n in ast.walk(tree) for c in ast.iter_child_nodes(n)}

    def run(self) -> str:
        """The source without the units."""
        for node in ast.walk(self.tree):
            for name in ("body", "orelse", "finalbody"):
                suite = getattr(node, name, None)
                if isinstance(suite, list) and suite and isinstance(suite[0], ast.stmt):
                    self._suite(suite, elif_=name == "orelse" and isinstance(node, ast.If))
        for node, gone in self.operands.items():
            self._operands(node, gone)
        for found in self.others:
            self._value(found)
        return self.cuts.result()

    def _goes(self, node: ast.stmt) -> bool:
        """Whether nothing of a statement stays."""
        if node in self.steps:
            return True
        if isinstance(node, ast.If) and node in self.branches:
            return all(map(self._goes, node.orelse))
        return False

    def _suite(self, suite: list[ast.stmt], elif_: bool) -> None:
        if elif_ and len(suite) == 1 and self._is_elif(suite[0]):
            return  # the chain's first `if` does it
        empty = all(map(self._goes, suite))
        for k, node in enumerate(suite):
            if self._goes(node):
                lo, hi = self.text.whole_lines(node, node, comments=True)
                indent = " " * node.col_offset
                filler = f"{indent}pass\n" if empty and k == 0 else ""
                self.cuts.add(lo, hi, lambda filler=filler: filler)
            elif isinstance(node, ast.If):
                self._chain(node)

    def _is_elif(self, node: ast.stmt) -> bool:
        return isinstance(node, ast.If) and self.text.source.startswith(
            "elif", self.text.span(node)[0]
        )

    def _chain(self, first: ast.If) -> None:
        """An `if` with its `elif`s and `else`, of which something stays."""
        chain = [first]
        while len(chain[-1].orelse) == 1 and self._is_elif(chain[-1].orelse[0]):
            chain.append(chain[-1].orelse[0])  # type: ignore[arg-type]
        if not any(node in self.branches for node in chain):
            return
        last = chain[-1].orelse
        lo, hi = self.text.whole_lines(first, first, comments=first in self.branches)
        starts = [self.text.line_start(self.text.span(n)[0]) for n in chain]
        ends = [*starts[1:], hi]
        else_at = hi
        if last:
            body_end = self.text.span(chain[-1].body[-1])[1]
            match = _ELSE.search(self.text.source, self.text.line_end(body_end) - 1)
            assert match is not None
            else_at = self.text.line_start(match.end() - 1)
            ends[-1] = else_at
        edit = Edit(lo, hi, lambda: "")

        def new() -> str:
            out: list[str] = []
            for node, start, end in zip(chain, starts, ends, strict=True):
                if node in self.branches:
                    continue
                piece = self.cuts.render(start, end, edit)
                word = "elif" if out else "if"
                out.append(re.sub(r"^(\s*)(?:el)?if\b", rf"\g<1>{word}", piece, count=1))
            if last and not all(map(self._goes, last)):
                rest = self.cuts.render(else_at, hi, edit)
                if out:
                    out.append(rest)
                else:
                    inner = _ELSE.sub("", rest, count=1)
                    out.append(_dedented(inner.lstrip("\n") if inner[:1] == "\n" else inner))
            return "".join(out)

        edit = Edit(lo, hi, new)
        self.cuts._edits.append(edit)

    def _operands(self, node: ast.BoolOp, gone: set[ast.AST]) -> None:
        lo, hi = self.text.span(node)
        stay = [v for v in node.values if v not in gone]
        word = " or " if isinstance(node.op, ast.Or) else " and "
        if len(stay) <= 1:
            lo, hi = self._bare(node, lo, hi, stay)
        edit = Edit(lo, hi, lambda: "")

        def new() -> str:
            if not stay:
                return str(isinstance(node.op, ast.And))
            pieces: list[str] = []
            for value in stay:
                span = self.text.with_parentheses(*self.text.span(value), self.text.span(node))
                piece = self.cuts.render(*span, edit)
                if "\n" in piece and not (piece[0] == "(" and piece[-1] == ")"):
                    piece = f"({piece})" if not _balanced_lines(piece) else piece
                pieces.append(piece)
            return word.join(pieces)

        edit = Edit(lo, hi, new)
        self.cuts._edits.append(edit)

    def _bare(self, node: ast.BoolOp, lo: int, hi: int, stay: list[ast.expr]) -> tuple[int, int]:
        """The span with its grouping parentheses, where what stays of it needs none."""
        parent = self.parents.get(node)
        alone = not stay or isinstance(
            stay[0],
            ast.Name | ast.Attribute | ast.Call | ast.Subscript | ast.Constant | ast.Compare,
        )
        if not isinstance(parent, ast.BoolOp) or not alone:
            return lo, hi
        return self.text.with_parentheses(lo, hi, self.text.span(parent))

    def _value(self, found: Found) -> None:
        node = found.node
        lo, hi = self.text.span(node)
        edit = Edit(lo, hi, lambda: "")
        if isinstance(node, ast.IfExp):
            rest: ast.expr = node.orelse
        else:
            assert isinstance(node, ast.Call)
            rest = node.args[found.argument]

        def new() -> str:
            span = self.text.with_parentheses(*self.text.span(rest), (lo, hi))
            if isinstance(node, ast.Call):
                span = self.text.span(rest)
            return self.cuts.render(*span, edit)

        edit = Edit(lo, hi, new)
        self.cuts._edits.append(edit)


def _balanced_lines(piece: str) -> bool:
    """Whether every line break of an expression lies inside brackets."""
    try:
        ast.parse(piece.strip(), mode="eval")
    except SyntaxError:
        return False
    return True


def _dedented(block: str) -> str:
    return "".join(
        row[4:] if row.startswith("    ") else row for row in block.splitlines(keepends=True)
    )
