"""The shape of the house in numbers: what a reader has to hold in mind, room by room.

    python -m benchmarks.house                 # of this checkout
    python -m benchmarks.house OLD . --json FILE    # of several side by side: before and after

Counted from the sources alone: modules and lines, functions over 80 and 100 lines, class chains,
full folders, circles of imports at run time. `.ci/ratchet.py` adds types and complexity and sees to
it that nothing grows.
"""

from __future__ import annotations

import argparse
import ast
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
import json
from pathlib import Path
import sys

PACKAGES = ("esg", "tasks", "flows")
LONG_LINES = 80
TOO_LONG_LINES = 100
DEEPEST_CHAIN = 2
FULL_FOLDER = 25


@dataclass(frozen=True)
class Place:
    """Something to improve: where it is, and what it measures."""

    room: str
    where: str
    text: str
    size: int


@dataclass
class House:
    """What is counted of one checkout; places are listed worst first.

    Args:
        modules: Number of modules by room.
        lines: Lines of source by room.
        functions: Functions over 80 lines.
        chains: Classes more than two deep.
        folders: Folders with more than 25 modules.
        circles: Modules that need each other at run time, imports inside functions included.
        start_circles: Those of them that already need each other while they are imported.
        longest: The longest functions, whatever their length.
        deepest_chain: Most project classes above each other.
        fullest_folder: Most modules of a folder.
    """

    modules: dict[str, int] = field(default_factory=dict[str, int])
    lines: dict[str, int] = field(default_factory=dict[str, int])
    functions: list[Place] = field(default_factory=list[Place])
    chains: list[Place] = field(default_factory=list[Place])
    folders: list[Place] = field(default_factory=list[Place])
    circles: list[Place] = field(default_factory=list[Place])
    start_circles: list[Place] = field(default_factory=list[Place])
    longest: list[Place] = field(default_factory=list[Place])
    deepest_chain: int = 0
    fullest_folder: int = 0

    def totals(self) -> dict[str, int]:
        """The figures of the table."""
        return {
            "modules": sum(self.modules.values()),
            "lines": sum(self.lines.values()),
            "longest function [lines]": max((p.size for p in self.longest), default=0),
            f"functions over {LONG_LINES} lines": len(self.functions),
            f"functions over {TOO_LONG_LINES} lines": len(too_long(self.functions)),
            "deepest class chain": self.deepest_chain,
            f"classes over {DEEPEST_CHAIN} deep": len(self.chains),
            "fullest folder [modules]": self.fullest_folder,
            f"folders over {FULL_FOLDER} modules": len(self.folders),
            "import circles": len(self.circles),
            "modules in import circles": sum(p.size for p in self.circles),
            "import circles at start": len(self.start_circles),
        }


def too_long(functions: list[Place]) -> list[Place]:
    """Those over 100 lines."""
    return [p for p in functions if p.size > TOO_LONG_LINES]


@dataclass(frozen=True)
class Module:
    """A parsed source file."""

    name: str
    path: Path
    room: str
    source: str
    tree: ast.Module


@dataclass(frozen=True)
class Import:
    """One imported name: `module` alone for `import module`; `kind` is start, call or types."""

    module: str
    name: str
    alias: str
    kind: str


def room_of(path: Path) -> str:
    """The room of a file below the checkout: a folder of esg, `esg` for what lies beside them."""
    top, *rest = path.parts
    return rest[0] if top == "esg" and len(rest) > 1 else top


def measure(root: Path) -> House:
    """Counts a checkout."""
    modules = list(_modules(root))
    house = House()
    folders: dict[Path, int] = {}
    functions: list[Place] = []
    for m in modules:
        house.modules[m.room] = house.modules.get(m.room, 0) + 1
        house.lines[m.room] = house.lines.get(m.room, 0) + m.source.count("\n")
        folders[m.path.parent] = folders.get(m.path.parent, 0) + 1
        functions += _functions(m)
    functions = _worst_first(functions)
    house.longest = functions[:12]
    house.functions = [p for p in functions if p.size > LONG_LINES]
    imports = {m.name: list(_imports(m.tree)) for m in modules}
    chains = _worst_first(_chains(modules, imports))
    house.deepest_chain = max((p.size for p in chains), default=0)
    house.chains = [p for p in chains if p.size > DEEPEST_CHAIN]
    house.fullest_folder = max(folders.values(), default=0)
    house.folders = _worst_first(
        Place(room_of(f / "x.py"), f.as_posix(), f"{n} modules", n)
        for f, n in folders.items()
        if n > FULL_FOLDER
    )
    rooms = {m.name: m.room for m in modules}
    house.circles = _circles(imports, rooms, ("start", "call"))
    house.start_circles = _circles(imports, rooms, ("start",))
    return house


def _worst_first(places: Iterator[Place] | list[Place]) -> list[Place]:
    return sorted(places, key=lambda p: (-p.size, p.where))


def _modules(root: Path) -> Iterator[Module]:
    for package in PACKAGES:
        for path in sorted((root / package).rglob("*.py")):
            inner = path.relative_to(root)
            parts = inner.with_suffix("").parts
            name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            source = path.read_text(encoding="utf-8")
            yield Module(name, inner, room_of(inner), source, ast.parse(source))


def _functions(module: Module) -> Iterator[Place]:
    for node in ast.walk(module.tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            length = (node.end_lineno or node.lineno) - node.lineno + 1
            where = f"{module.path.as_posix()}:{node.lineno}"
            yield Place(module.room, where, f"{node.name}: {length} lines", length)


def _imports(node: ast.AST, kind: str = "start") -> Iterator[Import]:
    """All imports below a node; those for type checkers only are of kind "types"."""
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.stmt | ast.ExceptHandler | ast.match_case):
            continue
        if isinstance(child, ast.If) and ast.unparse(child.test).endswith("TYPE_CHECKING"):
            yield from _imports(ast.Module(child.body, []), "types")
            yield from _imports(ast.Module(child.orelse, []), kind)
        elif isinstance(child, ast.Import):
            for a in child.names:
                yield Import(a.name, "", a.asname or a.name, kind)
        elif isinstance(child, ast.ImportFrom) and child.module and not child.level:
            for a in child.names:
                yield Import(child.module, a.name, a.asname or a.name, kind)
        else:
            inner = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef) and kind == "start"
            yield from _imports(child, "call" if inner else kind)


def _home(imports: dict[str, list[Import]], module: str, name: str) -> str:
    """The module behind `from module import name`, through the lists that packages re-export."""
    if f"{module}.{name}" in imports:
        return f"{module}.{name}"
    for other in imports.get(module, ()):
        if other.alias == name and other.name and other.kind != "call" and other.module != module:
            return _home(imports, other.module, other.name)
    return module


def _circles(
    imports: dict[str, list[Import]], rooms: dict[str, str], kinds: tuple[str, ...]
) -> list[Place]:
    needs: dict[str, set[str]] = {}
    for name, made in imports.items():
        homes = {_home(imports, i.module, i.name) for i in made if i.kind in kinds}
        needs[name] = (homes & imports.keys()) - {name}
    places: list[Place] = []
    for circle in _components(needs):
        told = sorted(circle)
        inside = {rooms[m] for m in circle}
        room = inside.pop() if len(inside) == 1 else "esg"
        places.append(
            Place(room, told[0], "needs itself through " + ", ".join(told[1:]), len(told))
        )
    return _worst_first(places)


def _components(needs: dict[str, set[str]]) -> Iterator[set[str]]:
    """Groups of modules of which each reaches every other (two walks; Kosaraju)."""
    order: list[str] = []
    seen: set[str] = set()
    for start in sorted(needs):
        stack = [(start, iter(sorted(needs[start])))] if start not in seen else []
        seen.add(start)
        while stack:
            name, rest = stack[-1]
            following = next((n for n in rest if n not in seen), None)
            if following is None:
                order.append(name)
                stack.pop()
            else:
                seen.add(following)
                stack.append((following, iter(sorted(needs[following]))))
    back: dict[str, set[str]] = {name: set() for name in needs}
    for name, targets in needs.items():
        for target in targets:
            back[target].add(name)
    taken: set[str] = set()
    for start in reversed(order):
        group, todo = set[str](), [start]
        while todo:
            name = todo.pop()
            if name not in taken:
                taken.add(name)
                group.add(name)
                todo += back[name]
        if len(group) > 1:
            yield group


def _chains(modules: list[Module], imports: dict[str, list[Import]]) -> Iterator[Place]:
    """Every class of the project with the number of project classes it stands on, and itself."""
    bases: dict[tuple[str, str], list[tuple[str, str]]] = {}
    places: dict[tuple[str, str], tuple[Module, int]] = {}
    for m in modules:
        known = {i.alias: i for i in imports[m.name]}
        for node in ast.walk(m.tree):
            if isinstance(node, ast.ClassDef):
                places[m.name, node.name] = (m, node.lineno)
                bases[m.name, node.name] = [
                    _class_named(ast.unparse(b), m.name, known, imports) for b in node.bases
                ]

    def depth(key: tuple[str, str], above: tuple[tuple[str, str], ...] = ()) -> int:
        if key not in bases or key in above:
            return 0
        return 1 + max((depth(b, (*above, key)) for b in bases[key]), default=0)

    for key, (module, line) in places.items():
        size = depth(key)
        yield Place(module.room, f"{module.path.as_posix()}:{line}", f"{key[1]}: {size} deep", size)


def _class_named(
    text: str, module: str, known: dict[str, Import], imports: dict[str, list[Import]]
) -> tuple[str, str]:
    name = text.split("[")[0]
    if name in known:
        return _home(imports, known[name].module, known[name].name), known[name].name
    head, _, last = name.rpartition(".")
    if head in known:
        found = known[head]
        return (f"{found.module}.{found.name}" if found.name else found.module), last
    return module, name


def table(houses: dict[str, House]) -> Iterator[str]:
    """The figures of all houses, a column each, then the rooms."""
    names = list(houses)
    yield f"{'':<32}" + "".join(f"{n[-16:]:>18}" for n in names)
    totals = {n: h.totals() for n, h in houses.items()}
    for figure in totals[names[0]]:
        yield f"{figure:<32}" + "".join(f"{totals[n][figure]:>18}" for n in names)
    yield ""
    yield f"{'room':<32}" + f"{'modules    lines':>18}" * len(names)
    rooms = sorted({r for h in houses.values() for r in h.lines},
                   key=lambda r: -max(h.lines.get(r, 0) for h in houses.values()))  # fmt: skip
    for room in rooms:
        yield f"{room:<32}" + "".join(
            f"{h.modules.get(room, 0):>9}{h.lines.get(room, 0):>9}" for h in houses.values()
        )


def details(house: House) -> Iterator[str]:
    """Everything that is listed, with its place."""
    lists = {
        "longest functions": house.longest,
        f"classes over {DEEPEST_CHAIN} deep": house.chains,
        f"folders over {FULL_FOLDER} modules": house.folders,
        "import circles": house.circles,
    }
    for title, places in lists.items():
        yield f"\n{title}: {len(places) or 'none'}"
        for p in places:
            yield f"  {p.where}  {p.text}"


def main(argv: list[str] | None = None) -> int:
    """Prints the table, and for the last root the places; returns the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("roots", nargs="*", default=["."], help="folders of checkouts")
    parser.add_argument("--json", metavar="FILE", help="write everything here")
    args = parser.parse_args(argv)
    short = {Path(root).resolve().name: root for root in args.roots}
    roots = short if len(short) == len(args.roots) else {root: root for root in args.roots}
    houses = {name: measure(Path(root)) for name, root in roots.items()}
    for name, house in houses.items():
        if not house.modules:
            parser.error(f"{name} holds none of the packages {', '.join(PACKAGES)}")
    print("\n".join(table(houses)))
    print("\n".join(details(list(houses.values())[-1])))
    if args.json:
        data = {root: {**asdict(h), "totals": h.totals()} for root, h in houses.items()}
        Path(args.json).write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
