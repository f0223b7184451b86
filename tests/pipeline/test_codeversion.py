"""A cached result depends on all the code that made it."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path
from typing import TypeGuard

import pytest

from esg.codeversion import COMMON, SOURCES

ESG = Path(__file__).resolve().parents[2] / "esg"
NO_RESULT = (
    "files.py", "paths.py", "progress.py", "workers.py", "leftovers.py", "settings.py",
    "engines/newton/__init__.py", "engines/newton/setup.py",  # Other rooms let it quiet Warp.
    "machine/beside.py", "machine/companion.py", "machine/answering.py",  # Which process does it.
)  # fmt: skip
"""How something is stored, shown or limited, which changes no result."""


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def source(module: str) -> Path | None:
    path = ESG.parent / module.replace(".", "/")
    for candidate in (path.with_suffix(".py"), path / "__init__.py"):
        if candidate.is_file():
            return candidate
    return None


def for_types(node: ast.AST) -> TypeGuard[ast.If]:
    """Whether a statement is for type checkers only."""
    return isinstance(node, ast.If) and ast.unparse(node.test).endswith("TYPE_CHECKING")


def imported(node: ast.AST) -> list[tuple[Path, str]]:
    """Files of the package that are imported below a node, each with the name taken from it."""
    found: list[tuple[Path, str]] = []
    for child in ast.iter_child_nodes(node):
        if for_types(child):
            continue
        if isinstance(child, ast.ImportFrom) and (child.module or "").startswith("esg"):
            for name in (a.name for a in child.names):
                path = source(f"{child.module}.{name}") or source(child.module or "")
                found += [(path, name)] if path is not None else []
        else:
            found += imported(child)
    return found


def needs(path: Path, name: str) -> list[tuple[Path, str]]:
    """What a name of a file needs: nothing for a plain value; of a door, what is behind that name.

    A door (`__init__.py`) has a function for the name, or names its home for type checkers and
    imports that when the name is asked for.
    """
    body = tree(path).body
    values = [n for n in body if isinstance(n, ast.Assign) and isinstance(n.value, ast.Constant)]
    if name in {ast.unparse(target) for n in values for target in n.targets}:
        return []
    functions = [n for n in body if isinstance(n, ast.FunctionDef)]
    if path.name != "__init__.py":
        return imported(tree(path))
    if name in {f.name for f in functions}:
        others = [f for f in functions if f.name != name]
        return [i for n in body if n not in others for i in imported(n)]
    homes = [i for n in body if for_types(n) for i in imported(ast.Module(n.body, []))]
    return imported(tree(path)) + [(home, n) for home, n in homes if n == name]


def reached(stage: str) -> set[str]:
    """Files below `esg/` that a stage's function in `esg/stages.py` can reach."""
    body = tree(ESG / "stages.py").body
    functions = {f.name: f for f in body if isinstance(f, ast.FunctionDef)}
    called, open_ = set[str](), {f"_{stage}"}
    while open_:
        called |= open_
        names = {n.id for c in open_ for n in ast.walk(functions[c]) if isinstance(n, ast.Name)}
        open_ = (names & functions.keys()) - called
    always = [n for n in body if not isinstance(n, ast.FunctionDef)]
    todo = imported(ast.Module([*always, *(functions[c] for c in called)], []))
    seen: set[tuple[Path, str]] = set()
    while todo:
        at = todo.pop()
        if at not in seen:
            seen.add(at)
            todo += needs(*at)
    return {path.relative_to(ESG).as_posix() for path, _ in seen}


@pytest.mark.parametrize("stage", SOURCES)
def test_a_stage_is_made_anew_when_code_that_it_reaches_changes(stage: str) -> None:
    parts = {*COMMON, *SOURCES[stage], *NO_RESULT, "stages.py"}
    left = {
        file
        for file in reached(stage)
        if not any(file == part or file.startswith(f"{part}/") for part in parts)
    }
    assert not left
