"""From plain JSON to a document, with every schema violation and as much as can be saved.

The verifier returns all violations at once, so a misspelled field must not hide a dangling
reference elsewhere. What breaks the schema is reported and cut out, and the remainder is checked by
the rules; names that were cut out still count as declared.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
import json
import math
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from esg.graph.models import SCHEMA_VERSION, EsgDocument
from esg.graph.violations import Findings, clip, pointer
from esg.untyped import is_array, is_list, is_object

MAX_REPAIRS = 200
MAX_DEPTH = 100
MAX_VALUES = 200_000
"""Values of a document; the largest scene so far has 2,310."""
MAX_NODES = 1000
MAX_NUMBER = 1e18
"""Beyond it numbers are no sizes, masses or times of anything, and integers no doubles."""

Path = tuple[str | int, ...]


class _Unknown(frozenset[str]):
    """Names that could not be read: any name may be one of them."""

    def __contains__(self, name: object) -> bool:
        return True


UNKNOWN = _Unknown()


@dataclass(frozen=True)
class Parsed:
    """A document as far as it can be read.

    Args:
        doc: None when nothing could be saved.
        raw: The plain JSON as given.
        cut: Paths, in `raw`, that were removed before `doc` could be built.
        tree: What `doc` was built from.
        origin: id of a list in `tree` -> original index of each of its items.
    """

    doc: EsgDocument | None
    raw: dict[str, Any]
    cut: tuple[Path, ...] = ()
    tree: Any = None
    origin: dict[int, list[int]] = field(default_factory=dict[int, list[int]])

    def declared(self, *path: str) -> frozenset[str]:
        """Keys of the raw object at `path`, whether or not their values could be read."""
        node = self._raw_at(path)
        if is_object(node):
            return frozenset(str(k) for k in node)
        return frozenset() if node is None else UNKNOWN

    def declared_ids(self, *path: str) -> frozenset[str]:
        """Values of `id` in the raw list of objects at `path`."""
        node = self._raw_at(path)
        if not is_array(node):
            return frozenset() if node is None else UNKNOWN
        ids = [i.get("id") if is_object(i) else None for i in node]
        names = [i for i in ids if isinstance(i, str)]
        return frozenset(names) if len(names) == len(ids) else UNKNOWN

    def _raw_at(self, path: tuple[str, ...]) -> Any:
        """The raw value at `path`; None when it is absent."""
        node: Any = self.raw
        for part in path:
            if not is_object(node):
                return node
            node = node.get(part)
        return node

    def intact(self, *path: str) -> bool:
        """Whether nothing at or below `path`, nor a part that contains it, was cut out."""
        above, below = self._cut_places
        return path not in above and not any(path[:k] in below for k in range(len(path) + 1))

    @cached_property
    def cut_pointers(self) -> set[str]:
        """Pointers of what was cut out."""
        return {pointer(*c) for c in self.cut}

    @cached_property
    def _cut_places(self) -> tuple[set[Path], set[Path]]:
        """What was cut out: all paths with whatever contains them, and the paths alone."""
        return {c[:k] for c in self.cut for k in range(len(c) + 1)}, set(self.cut)

    def original(self, where: str) -> str:
        """The pointer into `raw` of a pointer into `doc` (items may have been cut out between)."""
        if not self.origin or not where:
            return where
        parts: list[str | int] = []
        node = self.tree
        for text in where[1:].split("/"):
            part: str | int = text.replace("~1", "/").replace("~0", "~")
            if is_list(node) and text.isdecimal():
                index = int(text)
                indices = self.origin.get(id(node))
                part = indices[index] if indices and index < len(indices) else index
                node = node[index] if index < len(node) else None
            else:
                node = node.get(part) if is_object(node) else None
            parts.append(part)
        return pointer(*parts)


def parse(raw: dict[str, Any], found: Findings) -> Parsed:
    """Validates plain JSON against the schema and adds a violation for each mismatch.

    Args:
        raw: Plain JSON; tuples count as lists.
        found: Receives the violations.

    Returns:
        The document without its broken parts.
    """
    if (excess := _excess(raw)) is not None:
        found.add("DOCUMENT_TOO_LARGE", "", None, f"{excess}.", "Make several scenes of it.")
        return Parsed(None, raw)
    version = raw.get("schema_version", SCHEMA_VERSION)
    tree = _clean(raw, (), found, 0)
    if not isinstance(version, str) or version != SCHEMA_VERSION:
        found.add(
            "SCHEMA_VERSION",
            "/schema_version",
            version,
            f"Schema version {clip(version)!r} is unknown.",
            f"Use {SCHEMA_VERSION!r}.",
        )
        tree["schema_version"] = SCHEMA_VERSION
    cut: list[Path] = []
    origin: dict[int, list[int]] = {}
    for _ in range(MAX_REPAIRS):
        try:
            doc = EsgDocument.model_validate_json(json.dumps(tree), strict=True)
        except ValidationError as error:
            partial = Parsed(None, raw, tuple(cut), tree, origin)
            paths = [_report(e, partial, found) for e in error.errors(include_url=False)]
            removed = _cut(tree, paths, origin)
            if not removed:
                return partial
            cut.extend(removed)
        else:
            return Parsed(doc, raw, tuple(cut), tree, origin)
    return Parsed(None, raw, tuple(cut), tree, origin)


def _excess(raw: dict[str, Any]) -> str | None:
    """What a document has too much of."""
    graph = raw.get("spatial_relation_graph")
    nodes = graph.get("nodes") if is_object(graph) else None
    if is_object(nodes) and len(nodes) > MAX_NODES:
        return f"The document has {len(nodes)} nodes; the limit is {MAX_NODES}"
    count, stack = 0, [raw]
    while stack:
        node: Any = stack.pop()
        children = list(node.values() if is_object(node) else node)
        count += len(children)
        if count > MAX_VALUES:
            return f"The document has more than {MAX_VALUES} values"
        stack += [c for c in children if is_object(c) or is_array(c)]
    return None


def _clean(node: Any, path: Path, found: Findings, depth: int) -> Any:
    """A copy without what JSON and UTF-8 cannot express, which is reported; limits depth."""
    if is_object(node) or is_array(node):
        if depth > MAX_DEPTH:
            _flag(found, "SCHEMA_TYPE", path, None, "is nested too deeply", "Flatten it.")
            return None
        if is_object(node):
            return {str(k): _clean(v, (*path, str(k)), found, depth + 1) for k, v in node.items()}
        return [_clean(v, (*path, i), found, depth + 1) for i, v in enumerate(node)]
    if isinstance(node, float) and not math.isfinite(node):
        _flag(found, "JSON_NOT_FINITE", path, str(node), "is not a finite number", "Give one.")
        return 0.0 if _free_form(path) else None
    if isinstance(node, int | float) and abs(node) >= MAX_NUMBER:
        shown = str(node) if isinstance(node, float) else f"{node.bit_length()} bits"
        _flag(found, "JSON_NUMBER_RANGE", path, shown, "is too large a number", "Give another.")
        return 0 if _free_form(path) else None
    if isinstance(node, str) and not _encodable(node):
        text = node.encode("utf-8", "replace").decode()
        _flag(found, "SCHEMA_VALUE", path, text, "holds half a character", "Give valid text.")
        return text
    if node is None or isinstance(node, (str, int, float, bool)):
        return node
    name = type(node).__name__
    _flag(found, "SCHEMA_TYPE", path, name, f"is a {name}, not JSON", "Give plain JSON.")
    return None


def _free_form(path: Path) -> bool:
    return path[:2] == ("dynamics_result", "program") or "config" in path


def _encodable(text: str) -> bool:
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _flag(found: Findings, code: str, path: Path, value: Any, what: str, remedy: str) -> None:
    where = pointer(*path)
    found.add(code, where, value, f"{_leaf(where)} {what}.", remedy)


def _locate(loc: Path, tree: Any) -> tuple[Path, Any]:
    """The path and value in `tree` of a pydantic location, without the tags of unions."""
    path: list[str | int] = []
    node = tree
    for part in loc:
        if not _has(node, part):
            continue
        node = node[part]
        path.append(part)
    return tuple(path), node


def _report(error: ErrorDetails, parsed: Parsed, found: Findings) -> Path:
    """Adds the violation of one pydantic error; returns the path in the tree of what is wrong."""
    kind, loc, text = error["type"], error["loc"], error["msg"]
    if kind == "missing":
        parent, _ = _locate(loc[:-1], parsed.tree)
        path = (*parent, loc[-1])
        where = parsed.original(pointer(*path))
        if isinstance(loc[-1], int):
            _, value = _locate(parent, parsed.tree)
            here = parsed.original(pointer(*parent))
            message = f"{_leaf(here)} is {_kind(value)}, which is too short."
            if "SCHEMA_TYPE" not in found.codes_at(here):
                remedy = f"Give at least {loc[-1] + 1} items."
                found.add("SCHEMA_TYPE", here, value, message, remedy)
            return parent
        if where not in parsed.cut_pointers:
            remedy = f"Add {loc[-1]!r} to {where.rpartition('/')[0] or 'the document'}."
            found.add("SCHEMA_MISSING", where, None, f"{_leaf(where)} is missing.", remedy)
        return path
    path, value = _locate(loc, parsed.tree)
    where = parsed.original(pointer(*path))
    inner = value if isinstance(value, (str, int, float, bool, type(None))) else None
    known = found.codes_at(where)
    if kind == "extra_forbidden":
        remedy = "Remove it, or correct its spelling; schemas/esg.schema.json lists the fields."
        found.add(
            "SCHEMA_UNKNOWN_FIELD", where, value, f"{_leaf(where)} is an unknown field.", remedy
        )
    elif kind in ("enum", "literal_error") and "SCHEMA_VALUE" not in known:
        expected = str(error.get("ctx", {}).get("expected", ""))
        message = f"{_leaf(where)} is {clip(inner)!r}, which is not an allowed value."
        found.add("SCHEMA_VALUE", where, value, message, f"Use one of: {expected}.")
    elif not known:
        shown = repr(clip(inner)) if value is None or inner is not None else _kind(value)
        message = f"{_leaf(where)} is {shown}: {text[:1].lower()}{text[1:]}."
        remedy = "Give the type that schemas/esg.schema.json states."
        found.add("SCHEMA_TYPE", where, value, message, remedy)
    return path


def _leaf(where: str) -> str:
    return repr(where.rpartition("/")[2].replace("~1", "/").replace("~0", "~"))


def _kind(value: Any) -> str:
    return "an object" if isinstance(value, dict) else f"a list of {len(value)}"


def _cut(tree: Any, paths: list[Path], origin: dict[int, list[int]]) -> list[Path]:
    """Removes what is wrong; a required field that is missing takes its parent with it.

    Returns:
        The removed paths with their original indices; none when the document itself would go.
    """
    # Higher indices first: removing a list item moves the later ones.
    order = sorted(set(paths), key=lambda p: [str(x).zfill(9) for x in p], reverse=True)
    targets = set[Path]()
    for path in order:
        target = path
        while target:
            parent: Any = tree
            for part in target[:-1]:
                parent = parent[part] if _has(parent, part) else None
            fixed_list = isinstance(parent, list) and not _is_collection(target[:-1])
            absent = not isinstance(parent, list) and not _has(parent, target[-1])
            if not (fixed_list or absent):
                break
            target = target[:-1]
        if not target:
            return []
        targets.add(target)
    # What goes with what contains it needs no removal of its own.
    outer = [t for t in targets if not any(t[:k] in targets for k in range(len(t)))]
    outer.sort(key=lambda t: [str(x).zfill(9) for x in t], reverse=True)
    named = Parsed(None, {}, (), tree, origin)
    originals = [_walk(named, t) for t in outer]
    for target in outer:
        *parents, last = target
        node: Any = tree
        for part in parents:
            node = node[part]
        holder: Any = node
        if is_list(node):
            if id(node) not in origin:
                origin[id(node)] = list(range(len(node)))
            origin[id(node)].pop(int(last))
        del holder[last]
    return originals


def _walk(parsed: Parsed, path: Path) -> Path:
    """The path in the raw document of a path in the tree."""
    node: Any = parsed.tree
    out: list[str | int] = []
    for part in path:
        indices = parsed.origin.get(id(node)) if is_list(node) else None
        out.append(indices[int(part)] if indices else part)
        node = _child(node, part)
    return tuple(out)


def _child(node: Any, part: str | int) -> Any:
    return node[part] if _has(node, part) else None


def _has(node: Any, part: str | int) -> bool:
    if is_object(node):
        return part in node
    return is_list(node) and isinstance(part, int) and part < len(node)


_COLLECTIONS = {
    "nodes", "edges", "binary_relations", "multi_relations", "constraints", "proxies", "regions",
    "support_surfaces", "participants", "subjects", "targets", "items", "warnings", "provenance",
    "parameters", "relaxed", "relations", "runners_up", "history", "vertices_cm", "primitives",
    "reasons", "constellations", "placements", "corridors",
}  # fmt: skip


def _is_collection(path: Path) -> bool:
    """Whether items of the list at `path` can go one by one (a vector's cannot)."""
    return bool(path) and path[-1] in _COLLECTIONS
