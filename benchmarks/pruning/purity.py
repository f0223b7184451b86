"""Which expressions change nothing when they are evaluated, told from names alone."""

from __future__ import annotations

import ast
from collections.abc import Iterable

_MUTATORS = frozenset(
    {"add", "append", "appendleft", "clear", "discard", "extend", "insert", "pop", "popitem",
     "popleft", "remove", "reverse", "setdefault", "sort", "update", "write"}
)  # fmt: skip
_DISPLAYS = ast.List | ast.Dict | ast.Set | ast.ListComp | ast.DictComp | ast.SetComp
Functions = ast.FunctionDef | ast.AsyncFunctionDef


def called(call: ast.Call) -> str:
    """Name of what is called, without what it belongs to; "" where it has none."""
    func = call.func
    return func.id if isinstance(func, ast.Name) else getattr(func, "attr", "")


class Purity:
    """Functions and methods of a package that store nothing, by name.

    A name is pure only if every function of that name is; unknown names count as pure unless they
    are methods that change a container.

    Args:
        trees: Modules of the package.
    """

    def __init__(self, trees: Iterable[ast.Module]) -> None:
        self._bodies: dict[str, list[Functions]] = {}
        self._classes: set[str] = set()
        for tree in trees:
            for node in ast.walk(tree):
                if isinstance(node, Functions):
                    self._bodies.setdefault(node.name, []).append(node)
                elif isinstance(node, ast.ClassDef):
                    self._classes.add(node.name)
        self._impure = {n for n, defs in self._bodies.items() if any(map(_stores, defs))}
        waiting = True
        while waiting:
            found = {
                name
                for name, defs in self._bodies.items()
                if name not in self._impure and any(self._calls_impure(d) for d in defs)
            }
            self._impure |= found
            waiting = bool(found)

    def _calls_impure(self, node: ast.AST) -> bool:
        names = {called(n) for n in ast.walk(node) if isinstance(n, ast.Call)}
        # a function that is passed on may be called by whom it is passed to
        names |= {n.id for n in ast.walk(node) if isinstance(n, ast.Name)} & self._bodies.keys()
        return bool(names & self._impure)

    def pure(self, node: ast.AST) -> bool:
        """Whether an expression changes nothing."""
        return not _stores(node) and not self._calls_impure(node)

    def defined(self, name: str) -> list[Functions]:
        """Functions and methods of a name."""
        return self._bodies.get(name, [])


def _stores(node: ast.AST) -> bool:
    """Whether code writes to what it did not make: attributes, items, containers, globals."""
    own = _made_here(node)
    for n in ast.walk(node):
        if isinstance(n, ast.Global | ast.Nonlocal | ast.Yield | ast.YieldFrom | ast.Await):
            return True
        owner = None
        if isinstance(n, ast.Attribute | ast.Subscript) and not isinstance(n.ctx, ast.Load):
            owner = n.value
        elif isinstance(n, ast.Call) and isinstance(n.func, ast.Attribute):
            owner = n.func.value if n.func.attr in _MUTATORS else None
        if owner is not None and not (isinstance(owner, ast.Name) and owner.id in own):
            return True
    return False


def _made_here(node: ast.AST) -> set[str]:
    """Local names that only ever hold containers made in the same code."""
    made: set[str] = set()
    others: set[str] = set()
    for n in ast.walk(node):
        if isinstance(n, ast.Assign | ast.AnnAssign):
            targets = n.targets if isinstance(n, ast.Assign) else [n.target]
            new = isinstance(n.value, _DISPLAYS) or (
                isinstance(n.value, ast.Call) and called(n.value) in ("list", "set", "dict")
            )
            for target in targets:
                names = {t.id for t in ast.walk(target) if isinstance(t, ast.Name)}
                (made if new and isinstance(target, ast.Name) else others).update(names)
        elif isinstance(n, ast.For | ast.comprehension):
            others |= {t.id for t in ast.walk(n.target) if isinstance(t, ast.Name)}
        elif isinstance(n, ast.arg):
            others.add(n.arg)
    return made - others
