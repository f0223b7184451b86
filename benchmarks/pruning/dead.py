"""What cutting leaves behind: empty branches, unused values, code that nothing reaches."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from pathlib import Path
import re
import subprocess
import sys

from benchmarks.pruning.purity import Functions, Purity, called
from benchmarks.pruning.rewrite import Cuts, Text

Definition = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef
_LEAVES = ast.Return | ast.Raise | ast.Continue | ast.Break
_ATOMS = ast.Name | ast.Attribute | ast.Call | ast.Subscript | ast.Constant


def tidied(source: str, purity: Purity) -> str:
    """Source without empty branches, unreachable statements and unused pure values."""
    while True:
        after = _without_statements(source, purity)
        after = _without_parentheses(after)
        if after == source:
            return source
        source = after


def _is_empty(body: list[ast.stmt]) -> bool:
    return all(isinstance(n, ast.Pass) for n in body)


def _without_statements(source: str, purity: Purity) -> str:
    """One round: takes out every statement that does nothing, innermost first over the rounds."""
    tree, text = ast.parse(source), Text(source)
    cuts = Cuts(text)
    unused = _unused_locals(tree, purity)
    for node in ast.walk(tree):
        for name in ("body", "orelse", "finalbody"):
            suite = getattr(node, name, None)
            if not (isinstance(suite, list) and suite and isinstance(suite[0], ast.stmt)):
                continue
            inside = isinstance(node, ast.If) and name == "orelse"
            if inside and source.startswith("elif", text.span(suite[0])[0]):
                if _does_nothing(suite[0], purity):
                    cuts.add(*text.whole_lines(suite[0], suite[0]), lambda: "")
                continue
            gone = [n for n in suite if _does_nothing(n, purity) or n in unused]
            for k, n in enumerate(suite[:-1]):
                if isinstance(n, _LEAVES):
                    gone += [m for m in suite[k + 1 :] if m not in gone]
                    break
            if len(suite) > 1:
                gone += [n for n in suite if isinstance(n, ast.Pass) and n not in gone]
            all_gone = len(gone) == len(suite)
            for k, n in enumerate(gone):
                if isinstance(n, ast.Pass) and len(suite) == 1:
                    continue
                filler = " " * n.col_offset + "pass\n" if all_gone and k == 0 else ""
                cuts.add(*text.whole_lines(n, n, comments=True), lambda filler=filler: filler)
            if inside and _is_empty(suite):
                start = text.span(suite[0])[0]
                lo = source.rfind("else", 0, start)
                cuts.add(text.line_start(lo), text.line_end(start), lambda: "")
    return cuts.result()


def _does_nothing(node: ast.stmt, purity: Purity) -> bool:
    if isinstance(node, ast.If):
        return _is_empty(node.body) and not node.orelse and purity.pure(node.test)
    if isinstance(node, ast.For):
        return _is_empty(node.body) and not node.orelse and purity.pure(node.iter)
    if isinstance(node, ast.Expr) and not isinstance(node.value, ast.Constant):
        return isinstance(node.value, ast.Name | ast.Attribute)
    return False


def _unused_locals(tree: ast.Module, purity: Purity) -> set[ast.stmt]:
    """Assignments of pure values to local names that nothing reads."""
    out: set[ast.stmt] = set()
    for function in ast.walk(tree):
        if not isinstance(function, Functions):
            continue
        read = {
            n.id
            for n in ast.walk(function)
            if isinstance(n, ast.Name) and not isinstance(n.ctx, ast.Store)
        }
        shared = {
            name
            for n in ast.walk(function)
            if isinstance(n, ast.Global | ast.Nonlocal)
            for name in n.names
        }
        for n in ast.walk(function):
            if isinstance(n, ast.Assign) and len(n.targets) == 1:
                target: ast.AST = n.targets[0]
            elif isinstance(n, ast.AnnAssign) and n.value is not None:
                target = n.target
            else:
                continue
            names = [target] if isinstance(target, ast.Name) else getattr(target, "elts", [])
            simple = bool(names) and all(isinstance(x, ast.Name) for x in names)
            if not simple or any(x.id in read | shared for x in names):
                continue
            if n.value is not None and purity.pure(n.value):
                out.add(n)
    # a class's own names are no locals
    for node in ast.walk(tree):
        if isinstance(node, ast.ClassDef):
            out -= set(node.body)  # type: ignore[arg-type]
    return out


def _without_parentheses(source: str) -> str:
    """Source without parentheses around single names and calls."""
    tree, text = ast.parse(source), Text(source)
    cuts = Cuts(text)
    for node in ast.walk(tree):
        if not isinstance(node, _ATOMS) or not hasattr(node, "lineno"):
            continue
        lo, hi = text.span(node)
        before, after = source[:lo].rstrip(" "), source[hi:].lstrip(" ")
        if not before.endswith("(") or not after.startswith(")") or "\n" in source[lo:hi]:
            continue
        head = before[:-1].rstrip(" ")
        word = re.search(r"[\w\])'\"}]+$", head)
        if word is not None and word[0] not in ("not", "in", "is", "and", "or", "return", "if",
                                                "elif", "else", "while"):  # fmt: skip
            continue
        if not head or head[-1] in "@\n":
            continue
        start, end = len(before) - 1, hi + len(source[hi:]) - len(after) + 1
        new = source[lo:hi]
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            continue
        cuts.add(start, end, lambda new=new: new)
    return cuts.result()


_PLAIN = frozenset(
    {"cache", "lru_cache", "staticmethod", "classmethod", "property", "dataclass",
     "cached_property", "override"}
)  # fmt: skip
"""Decorators that call nothing by themselves."""


class Usage:
    """Definitions of a package and which of them something reaches, by name.

    What modules outside of the package name, and what runs when a module is imported, is reached;
    so is every definition whose name reached code names. Imports alone reach nothing.

    Args:
        root: Root of the repository.
        folder: The package's folder.
        outside: Folders whose code counts as using the package.
    """

    def __init__(self, root: Path, folder: str, outside: Iterable[str]) -> None:
        self.root, self.folder = root, folder
        self.sources: dict[str, str] = {}
        self.trees: dict[str, ast.Module] = {}
        for path in sorted((root / folder).rglob("*.py")):
            name = path.relative_to(root).as_posix()
            self.sources[name] = path.read_text(encoding="utf-8")
            self.trees[name] = ast.parse(self.sources[name])
        self._prefixes: set[str] = set()
        reached: set[str] = set()
        for name in outside:
            for path in sorted((root / name).rglob("*.py")):
                if path.relative_to(root).as_posix() in self.trees:
                    continue
                reached |= self._names(ast.parse(path.read_text(encoding="utf-8")), imports=True)
        self.nodes: list[tuple[str, str, ast.stmt]] = []
        self._uses: dict[str, set[str]] = {}
        for name, tree in self.trees.items():
            own = name.endswith("__init__.py")
            for statement in tree.body:
                reached |= self._statement(name, statement, own)
        while True:
            more = {
                used for name in reached | self._prefixed() for used in self._uses.get(name, ())
            } - reached
            if not more:
                break
            reached |= more
        self.reached = reached | self._prefixed()

    def _statement(self, file: str, node: ast.stmt, exports: bool) -> set[str]:
        """Notes definitions; returns the names that are used when the module is imported."""
        if isinstance(node, Definition):
            self.nodes.append((file, node.name, node))
            uses = self._uses.setdefault(node.name, set())
            for decorator in node.decorator_list:
                if not self._plain_decorator(decorator):
                    return {node.name} | self._names(node)
            if not isinstance(node, ast.ClassDef):
                uses |= self._names(node)
                return set()
            for base in [*node.bases, *node.keywords]:
                uses |= self._names(base)
            for member in node.body:
                if isinstance(member, Functions):
                    special = member.name.startswith("__") or any(
                        not self._plain_decorator(d) for d in member.decorator_list
                    )
                    if special:
                        uses |= self._names(member)
                    else:
                        self.nodes.append((file, member.name, member))
                        self._uses.setdefault(member.name, set()).update(self._names(member))
                else:
                    uses |= self._names(member)
            return set()
        name = _constant(node)
        if name is not None and not name.startswith("__"):
            self.nodes.append((file, name, node))
            self._uses.setdefault(name, set()).update(self._names(node) - {name})
            return set()
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            return set()
        return self._names(node, imports=exports)

    @staticmethod
    def _plain_decorator(node: ast.expr) -> bool:
        name = (
            called(node)
            if isinstance(node, ast.Call)
            else getattr(node, "id", getattr(node, "attr", ""))
        )
        return name in _PLAIN

    def _names(self, node: ast.AST, imports: bool = False) -> set[str]:
        out: set[str] = set()
        for n in ast.walk(node):
            if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load):
                out.add(n.id)
            elif isinstance(n, ast.Attribute):
                out.add(n.attr)
            elif isinstance(n, ast.alias) and imports:
                out.add(n.name.rpartition(".")[2])
            elif isinstance(n, ast.Constant) and isinstance(n.value, str):
                if len(n.value) < 200:
                    out |= (
                        set(re.findall(r"[A-Za-z_]\w*", n.value)) if "." in n.value else {n.value}
                    )
            elif isinstance(n, ast.JoinedStr) and n.values:
                first = n.values[0]
                if isinstance(first, ast.Constant) and re.fullmatch(r"_?[a-z]+_", str(first.value)):
                    self._prefixes.add(str(first.value))
            elif isinstance(n, ast.ImportFrom) and not imports and n.level == 0:
                continue
        return out

    def _prefixed(self) -> set[str]:
        """Names that an f-string may build (`getattr(self, f"_do_{sense}")`)."""
        known = {name for _, name, _ in self.nodes}
        return {n for n in known if any(n.startswith(p) for p in self._prefixes)}

    def dead(self) -> dict[str, list[ast.stmt]]:
        """Definitions that nothing reaches, by file."""
        out: dict[str, list[ast.stmt]] = {}
        for file, name, node in self.nodes:
            if name not in self.reached:
                out.setdefault(file, []).append(node)
        return out


def _constant(node: ast.stmt) -> str | None:
    """Name of a module's constant, of whose value nothing but the name is used."""
    if isinstance(node, ast.Assign) and len(node.targets) == 1:
        target: ast.expr = node.targets[0]
    elif isinstance(node, ast.AnnAssign):
        target = node.target
    else:
        return None
    return target.id if isinstance(target, ast.Name) else None


def without_definitions(source: str, nodes: list[ast.stmt]) -> str:
    """Source without definitions, with the strings that describe constants."""
    text = Text(source)
    tree = ast.parse(source)
    places = {(n.lineno, n.col_offset) for n in nodes}
    cuts = Cuts(text)
    for owner in ast.walk(tree):
        if not isinstance(owner, ast.Module | ast.ClassDef):
            continue
        gone = 0
        for k, node in enumerate(owner.body):
            if (node.lineno, node.col_offset) not in places:
                continue
            last = node
            following = owner.body[k + 1] if k + 1 < len(owner.body) else None
            described = isinstance(following, ast.Expr) and isinstance(
                following.value, ast.Constant
            )
            if _constant(node) and following is not None and described:
                last = following
            gone += 1 if last is node else 2
            cuts.add(*text.whole_lines(node, last, comments=True), lambda: "")
        stays = isinstance(owner, ast.ClassDef) and (owner.lineno, owner.col_offset) not in places
        if stays and gone == len(owner.body):
            at = text.line_end(text.span(owner.body[-1])[1])
            cuts.add(at, at, lambda owner=owner: " " * (owner.col_offset + 4) + "pass\n")
    return cuts.result()


def sweep(
    root: Path, folder: str, outside: Iterable[str], keep: Iterable[str] = ()
) -> dict[str, int]:
    """Takes dead code out of a package's files until nothing is left to take.

    Args:
        root: Root of the repository.
        folder: The package's folder.
        outside: Folders whose code uses it.
        keep: Files, relative to the root, that stay as they are.

    Returns:
        How many definitions went, by file.
    """
    outside, kept = list(outside), set(keep)
    gone: dict[str, int] = {}
    while True:
        changed = False
        trees = [ast.parse(p.read_text(encoding="utf-8")) for p in (root / folder).rglob("*.py")]
        purity = Purity(trees)
        for path in sorted((root / folder).rglob("*.py")):
            name = path.relative_to(root).as_posix()
            if name in kept:
                continue
            source = path.read_text(encoding="utf-8")
            after = tidied(source, purity)
            if after != source:
                path.write_text(after, encoding="utf-8")
                changed = True
        lint(root, folder)
        usage = Usage(root, folder, outside)
        for name, nodes in usage.dead().items():
            if name in kept:
                continue
            after = without_definitions(usage.sources[name], nodes)
            if after != usage.sources[name]:
                (root / name).write_text(after, encoding="utf-8")
                gone[name] = gone.get(name, 0) + len(nodes)
                changed = True
        lint(root, folder)
        if not changed:
            return gone


def lint(root: Path, folder: str) -> None:
    """Takes out unused imports and formats."""
    ruff = Path(sys.executable).with_name("ruff")
    for what in (
        ["check", "--fix", "--quiet", "--select", "F401,I,E713,E714,SIM201,SIM202,PIE790"],
        ["format", "--quiet"],
    ):
        subprocess.run([str(ruff), *what, folder], cwd=root, check=False)


__all__ = ["Usage", "lint", "sweep", "tidied", "without_definitions"]
