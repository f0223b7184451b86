"""Units of a package that can be left out one by one, and code with a switch for each."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from dataclasses import dataclass
import fnmatch
from pathlib import Path

from benchmarks.pruning.purity import Functions, Purity, called

KINDS = ("branch", "choice", "or", "and", "step", "stage")
"""Branch of an `if`, first value of `a if b else c`, operand, call statement, `x = call(x)`."""
ON, OFF, FIRST = "__left_in__", "__left_out__", "__argument__"
"""Names, among the builtins, of the switches: true where a unit stays, true where it goes."""
_LOOKS_BOOLEAN = frozenset({"any", "all", "bool", "isinstance", "startswith", "endswith", "isalpha",
                            "isdigit", "issubset", "issuperset", "isdisjoint"})  # fmt: skip
_ENDS = ast.Return | ast.Continue | ast.Break | ast.Pass


@dataclass(frozen=True)
class Unit:
    """Something that can be left out of a package.

    Args:
        key: "file#number", the number counting the units of the file in reading order.
        kind: One of `KINDS`.
        file: Path relative to the root.
        line: First line, from 1.
        end_line: Last line.
        lines: Lines of source that go with it; a part of one for operands.
        function: Qualified name of the function it is in.
        text: Its start.
    """

    key: str
    kind: str
    file: str
    line: int
    end_line: int
    lines: float
    function: str
    text: str


@dataclass(frozen=True)
class Found:
    """A unit with its place in a syntax tree.

    Args:
        unit: The unit.
        node: `If`, `IfExp`, operand, `Expr` or `Call`.
        parent: The `BoolOp` of an operand.
        pure: Whether to evaluate what decides on it changes nothing.
        argument: Of a stage, which of its arguments takes its place.
    """

    unit: Unit
    node: ast.AST
    parent: ast.BoolOp | None = None
    pure: bool = True
    argument: int = 0


class Package:
    """Modules below a folder, parsed.

    Args:
        root: Root of the repository.
        folder: Folder of the package relative to it.
        leave: Patterns of paths below the folder that have no units.
    """

    def __init__(self, root: Path, folder: str, leave: Iterable[str] = ()) -> None:
        self.root, self.folder = root, folder
        self.leave = leave = tuple(leave)
        self.sources: dict[str, str] = {}
        self.kept: set[str] = set()
        for path in sorted((root / folder).rglob("*.py")):
            name = path.relative_to(root).as_posix()
            self.sources[name] = path.read_text(encoding="utf-8")
            below = path.relative_to(root / folder).as_posix()
            if any(fnmatch.fnmatch(below, p) or fnmatch.fnmatch(path.name, p) for p in leave):
                self.kept.add(name)
        self.trees = {name: ast.parse(text) for name, text in self.sources.items()}
        self.purity = Purity(self.trees.values())
        self._booleans = _boolean_attributes(self.trees.values())

    def find(self, name: str, tree: ast.Module | None = None) -> list[Found]:
        """Units of one file in reading order; none of a file that is left alone."""
        if name in self.kept:
            return []
        tree = tree or self.trees[name]
        finder = _Finder(name, self.sources[name], self.purity, self._booleans)
        for node in tree.body:
            finder.statement(node)
        return finder.found

    def units(self) -> list[Unit]:
        """All units of the package."""
        return [f.unit for name in self.trees for f in self.find(name)]


def _boolean_attributes(trees: Iterable[ast.Module]) -> set[str]:
    """Names of attributes, properties and functions that are annotated as truth values."""
    out: set[str] = set()
    for tree in trees:
        for n in ast.walk(tree):
            if isinstance(n, ast.AnnAssign) and _is_bool(n.annotation):
                target = n.target
                out.add(target.id if isinstance(target, ast.Name) else getattr(target, "attr", ""))
            elif isinstance(n, ast.Assign) and isinstance(n.value, ast.Constant):
                if isinstance(n.value.value, bool):
                    out |= {t.attr for t in n.targets if isinstance(t, ast.Attribute)}
            elif isinstance(n, Functions) and _is_bool(n.returns):
                out.add(n.name)
    return out


def _is_bool(annotation: ast.expr | None) -> bool:
    return isinstance(annotation, ast.Name) and annotation.id == "bool"


class _Finder:
    """Walks one module and numbers its units."""

    def __init__(self, file: str, text: str, purity: Purity, booleans: set[str]) -> None:
        self.found: list[Found] = []
        self._file, self._lines, self._purity = file, text.splitlines(), purity
        self._booleans = booleans
        self._inside: list[str] = []
        self._local: list[set[str]] = []
        self._loops: list[ast.AST] = []
        self._whole: ast.AST | None = None

    def _add(self, kind: str, node: ast.AST, **more: object) -> None:
        first, last = node.lineno, node.end_lineno  # type: ignore[attr-defined]
        if isinstance(node, ast.If):
            last = node.body[-1].end_lineno or last
        rows = self._lines[first - 1 : last]
        lines = float(sum(bool(row.strip()) for row in rows))
        start = node.col_offset  # type: ignore[attr-defined]
        segment = " ".join("\n".join(rows).encode()[start:].decode().split())
        if kind not in ("branch", "step"):
            size = node.end_col_offset - start  # type: ignore[attr-defined]
            segment = segment if len(rows) > 1 else segment[:size]
            lines = round(len(segment) / 80.0, 2)
        unit = Unit(
            f"{self._file}#{len(self.found)}", kind, self._file, first, last, lines,
            ".".join(self._inside), segment[:120],
        )  # fmt: skip
        self.found.append(Found(unit, node, **more))  # type: ignore[arg-type]

    def statement(self, node: ast.AST) -> None:
        """Finds the units of a statement and of what it contains."""
        if isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            self._definition(node)
        elif not self._local:
            for child in ast.iter_child_nodes(node):
                if isinstance(child, ast.stmt):
                    self.statement(child)
        elif isinstance(node, ast.If):
            self._branch(node)
        elif isinstance(node, ast.For | ast.While):
            self._loops.append(node)
            if isinstance(node, ast.For):
                self._value(node.iter)
            self._suite([*node.body, *node.orelse])
            self._loops.pop()
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            call = node.value
            if self._purity.defined(called(call)) and not _raises(self._purity, call):
                self._add("step", node, pure=False)
            self._value(call)
        elif isinstance(node, ast.Return) and node.value is not None:
            (self._boolean if "return" in self._local[-1] else self._value)(node.value)
        elif isinstance(node, ast.Assert | ast.Raise):
            return
        else:
            for child in ast.iter_child_nodes(node):
                if isinstance(child, ast.stmt | ast.excepthandler | ast.match_case):
                    self.statement(child)
                elif isinstance(child, ast.expr | ast.withitem):
                    self._value(child)

    def _suite(self, body: Iterable[ast.stmt]) -> None:
        for node in body:
            self.statement(node)

    def _definition(self, node: ast.ClassDef | Functions) -> None:
        self._inside.append(node.name)
        if isinstance(node, ast.ClassDef):
            local, self._local = self._local, []
            self._suite(node.body)
            self._local = local
        elif not (_cached(node) and not node.args.args):  # tables are built once
            loops, self._loops = self._loops, []
            self._local.append(_boolean_names(node, self._booleans))
            self._suite(node.body)
            self._local.pop()
            self._loops = loops
        self._inside.pop()

    def _branch(self, node: ast.If) -> None:
        protected = any(isinstance(n, ast.Raise) for s in node.body for n in ast.walk(s))
        if self._loops and isinstance(self._loops[-1], ast.While):
            protected = protected or any(map(_leaves_loop, node.body))
        short = len(node.body) == 1 and isinstance(
            node.body[0], _ENDS | ast.Assign | ast.AugAssign | ast.AnnAssign
        )
        protected = protected or (short and self._guard(node.test)) or _binds_more(node)
        if not protected:
            self._add("branch", node, pure=self._purity.pure(node.test))
        whole, self._whole = self._whole, node
        self._boolean(node.test)
        self._whole = whole
        self._suite(node.body)
        self._suite(node.orelse)

    def _boolean(self, node: ast.expr) -> None:
        """Finds the units of an expression of which only the truth counts."""
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            self._boolean(node.operand)
        elif isinstance(node, ast.BoolOp):
            kind = "or" if isinstance(node.op, ast.Or) else "and"
            for value in node.values:
                named = any(isinstance(n, ast.NamedExpr) for n in ast.walk(value))
                if not named and not self._guard(value) and not self._protects(value):
                    self._add(kind, value, parent=node, pure=self._purity.pure(value))
                self._boolean(value)
        else:
            self._value(node)

    def _value(self, node: ast.AST) -> None:
        """Finds the units of an expression whose value counts."""
        if isinstance(node, ast.IfExp):
            if not self._guard(node.test) and not any(
                isinstance(n, ast.NamedExpr) for n in ast.walk(node.test)
            ):
                self._add("choice", node, pure=self._purity.pure(node.test))
            self._boolean(node.test)
            self._value(node.body)
            self._value(node.orelse)
            return
        if isinstance(node, ast.BoolOp) and self._looks_boolean(node):
            self._boolean(node)
            return
        if isinstance(node, ast.Call):
            argument = _same_kind(self._purity, node)
            if argument is not None:
                self._add("stage", node, pure=False, argument=argument)
        for child in ast.iter_child_nodes(node):
            if isinstance(child, ast.comprehension):
                self._value(child.iter)
                for test in child.ifs:
                    self._boolean(test)
            else:
                self._value(child)

    def _looks_boolean(self, node: ast.expr) -> bool:
        if isinstance(node, ast.BoolOp):
            return all(map(self._looks_boolean, node.values))
        if isinstance(node, ast.UnaryOp):
            return isinstance(node.op, ast.Not)
        if isinstance(node, ast.Call):
            return called(node) in _LOOKS_BOOLEAN | self._booleans
        if isinstance(node, ast.Name):
            return node.id in self._local[-1]
        if isinstance(node, ast.Attribute):
            return node.attr in self._booleans
        return isinstance(node, ast.Compare)

    def _guard(self, node: ast.expr) -> bool:
        """Whether a test only asks if something is there: None, emptiness, type, bounds."""
        if isinstance(node, ast.BoolOp):
            return all(map(self._guard, node.values))
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            return self._guard(node.operand)
        if isinstance(node, ast.Compare):
            inner = list(ast.walk(node))
            if any(isinstance(o, ast.Is | ast.IsNot) for o in node.ops):
                return True
            if any(isinstance(n, ast.Call) and called(n) == "len" for n in inner):
                return True
            order = all(isinstance(o, ast.Lt | ast.LtE | ast.Gt | ast.GtE) for o in node.ops)
            return order and all(
                isinstance(n, ast.Name | ast.BinOp | ast.operator | ast.cmpop | ast.Load)
                or n is node
                or (isinstance(n, ast.Constant) and isinstance(n.value, int))
                for n in inner
            )
        if isinstance(node, ast.Call):
            return called(node) in ("isinstance", "hasattr", "callable", "len")
        if isinstance(node, ast.Name):
            return node.id not in self._local[-1]
        if isinstance(node, ast.Attribute):
            return node.attr not in self._booleans
        return isinstance(node, ast.Subscript)

    def _protects(self, node: ast.expr) -> bool:
        """Whether a test makes sure of a key that the code it decides on looks up."""
        if not (isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.In | ast.NotIn)):
            return False
        table = ast.dump(node.comparators[0])
        looked_up = (n.value for n in ast.walk(self._whole or node) if isinstance(n, ast.Subscript))
        return any(ast.dump(n) == table for n in looked_up)


def _cached(node: Functions) -> bool:
    return any(
        (called(d) if isinstance(d, ast.Call) else getattr(d, "id", getattr(d, "attr", "")))
        in ("cache", "lru_cache")
        for d in node.decorator_list
    )


def _boolean_names(node: Functions, booleans: set[str]) -> set[str]:
    """Local names that only ever hold truth values; "return" if the function gives one."""
    given = [*node.args.args, *node.args.kwonlyargs]
    sure = {a.arg for a in given if _is_bool(a.annotation)}
    never = {a.arg for a in given} - sure
    values: dict[str, list[ast.expr]] = {}
    for n in ast.walk(node):
        if isinstance(n, ast.Assign) and len(n.targets) == 1:
            if isinstance(n.targets[0], ast.Name):
                values.setdefault(n.targets[0].id, []).append(n.value)
        elif isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store):
            values.setdefault(n.id, [])
    stored: dict[str, int] = {}
    for n in ast.walk(node):
        if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store):
            stored[n.id] = stored.get(n.id, 0) + 1
    finder = _Finder("", "", Purity(()), booleans)
    names = sure | {n for n in values if n not in never and stored.get(n, 0) == len(values[n])}
    while True:
        finder._local = [names]
        wrong = {
            n
            for n in names - sure
            if not values[n]
            or not all(
                finder._looks_boolean(v)
                or (isinstance(v, ast.Constant) and isinstance(v.value, bool))
                for v in values[n]
            )
        }
        if not wrong:
            return names | ({"return"} if _is_bool(node.returns) else set())
        names -= wrong


def _leaves_loop(node: ast.AST) -> bool:
    return any(isinstance(n, ast.Break | ast.Return) for n in ast.walk(node))


def _binds_more(node: ast.If) -> bool:
    """Whether its test names something (`:=`); others may read the name."""
    return any(isinstance(n, ast.NamedExpr) for n in ast.walk(node.test)) and bool(node.orelse)


def _raises(purity: Purity, call: ast.Call) -> bool:
    return any(isinstance(n, ast.Raise) for d in purity.defined(called(call)) for n in ast.walk(d))


def _same_kind(purity: Purity, call: ast.Call) -> int | None:
    """Which argument of a step's call has the type of its result (the step is then a stage)."""
    if not isinstance(call.func, ast.Name):
        return None
    defined = purity.defined(call.func.id)
    if len(defined) != 1 or defined[0].returns is None:
        return None
    kind = ast.dump(defined[0].returns)
    if not isinstance(defined[0].returns, ast.Subscript) or _raises(purity, call):
        return None  # of a plain `str` or number one cannot tell
    for k, parameter in enumerate(defined[0].args.args[: len(call.args)]):
        same = parameter.annotation is not None and ast.dump(parameter.annotation) == kind
        if same and not any(isinstance(a, ast.Starred) for a in call.args):
            return k
    return None


class _Switches(ast.NodeTransformer):
    """Puts a switch at every unit."""

    def __init__(self, numbers: dict[ast.AST, tuple[Found, int]]) -> None:
        self._numbers = numbers

    def visit(self, node: ast.AST) -> ast.AST:
        """Visits a node, then wraps it if it is a unit."""
        found, number = self._numbers.get(node, (None, 0))
        self.generic_visit(node)
        if found is None:
            return node
        kind = found.unit.kind
        if isinstance(node, ast.If | ast.IfExp) and kind in ("branch", "choice"):
            node.test = _both(ast.And(), node.test, _item(ON, number), found.pure)
        elif kind == "step":
            return ast.If(_item(ON, number), [node], [])
        elif kind == "stage" and isinstance(node, ast.Call):
            first = ast.Subscript(ast.Name(FIRST, ast.Load()), ast.Constant(found.argument),
                                  ast.Load())  # fmt: skip
            node.func = ast.IfExp(_item(ON, number), node.func, first)
        return node

    def visit_operands(self, node: ast.BoolOp) -> None:
        """Wraps the operands of a condition that are units."""
        for k, value in enumerate(node.values):
            found, number = self._numbers.get((node, k), (None, 0))  # type: ignore[call-overload]
            if found is not None and found.unit.kind == "or":
                node.values[k] = _both(ast.And(), value, _item(ON, number), found.pure)
            elif found is not None:
                node.values[k] = _both(ast.Or(), value, _item(OFF, number), found.pure)


def _item(name: str, number: int) -> ast.Subscript:
    return ast.Subscript(ast.Name(name, ast.Load()), ast.Constant(number), ast.Load())


def _both(op: ast.boolop, value: ast.expr, switch: ast.expr, pure: bool) -> ast.BoolOp:
    """The switch after the value, to see where it counts; before it, where evaluating it acts."""
    return ast.BoolOp(op, [value, switch] if pure else [switch, value])


def switched(
    package: Package, name: str, numbers: dict[str, int], tree: ast.Module | None = None
) -> ast.Module:
    """A module's tree with a switch at every unit.

    Args:
        package: The package.
        name: File.
        numbers: Number of each unit's switch by its key.
        tree: Its tree, which is changed, if it is not that of the file.
    """
    tree = tree or ast.parse(package.sources[name])
    nodes: dict[object, tuple[Found, int]] = {}
    for found in package.find(name, tree):
        key: object = found.node
        if found.parent is not None:
            key = (found.parent, found.parent.values.index(found.node))  # type: ignore[arg-type]
        nodes[key] = (found, numbers[found.unit.key])
    switches = _Switches(nodes)  # type: ignore[arg-type]
    operations = [n for n in ast.walk(tree) if isinstance(n, ast.BoolOp)]
    switches.visit(tree)
    for node in operations:
        switches.visit_operands(node)
    return ast.fix_missing_locations(tree)
