"""Reading ESG files: one clear message for whatever is wrong with them."""

from __future__ import annotations

from dataclasses import dataclass
import json
from pathlib import Path
from typing import Any

from esg.graph.models import EsgDocument
from esg.graph.parsing import parse
from esg.graph.verifier import verify
from esg.graph.violations import Findings, Violation, clip, pointer
from esg.outcomes import UserError
from esg.untyped import is_list, is_object

MAX_BYTES = 64 * 1024 * 1024


class _Object(dict[str, Any]):
    """A JSON object that remembers keys that occurred twice."""

    twice: tuple[str, ...] = ()


@dataclass(frozen=True)
class CheckReport:
    """What `esg check` tells about a file.

    Args:
        path: The file, as given.
        violations: All violations; empty for a valid document.
        document: The document, when it is valid.
    """

    path: str
    violations: tuple[Violation, ...]
    document: EsgDocument | None = None

    @property
    def ok(self) -> bool:
        """Whether nothing is wrong."""
        return not self.violations

    @property
    def exit_code(self) -> int:
        """0 for a valid document, 2 for a mistake in the input."""
        return 0 if self.ok else 2

    def to_json(self) -> dict[str, Any]:
        """Plain JSON: path, ok, counts per code and all violations."""
        codes = [v.code for v in self.violations]
        return {
            "path": self.path,
            "ok": self.ok,
            "counts": {code: codes.count(code) for code in sorted(set(codes))},
            "violations": [v.to_json() for v in self.violations],
        }

    def text(self) -> str:
        """The report for people: one line a violation."""
        if self.ok:
            return f"{self.path}: valid ESG document"
        count = len(self.violations)
        head = f"{self.path}: {count} violation{'' if count == 1 else 's'}"
        return "\n".join([head, *(f"  {violation}" for violation in self.violations)])


def read_json(path: Path | str, found: Findings) -> dict[str, Any] | None:
    """Reads a file as one JSON object; None when that is impossible.

    Args:
        path: The file.
        found: Receives what is wrong, duplicate keys included.
    """
    file = Path(path)
    try:
        if file.is_dir():
            remedy = "Name the file itself, such as the esg.json of a scene folder."
            found.add("FILE_UNREADABLE", "", str(path), f"{path} is a folder.", remedy)
            return None
        if file.exists() and not file.is_file():
            remedy = "Name a regular file."
            found.add("FILE_UNREADABLE", "", str(path), f"{path} is not a regular file.", remedy)
            return None
        size = file.stat().st_size
        if size > MAX_BYTES:
            message = f"{path} has {size / 2**20:.0f} MiB, too much for an ESG document."
            found.add("FILE_TOO_LARGE", "", size, message, "Name an ESG document (64 MiB at most).")
            return None
        data = file.read_bytes()
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        message = f"{path} cannot be read: {reason}."
        found.add("FILE_UNREADABLE", "", str(path), message, "Check the path and its permissions.")
        return None
    return parse_json(data, found, str(path))


def parse_json(data: bytes, found: Findings, name: str = "The text") -> dict[str, Any] | None:
    """Reads bytes as one JSON object; None when that is impossible.

    Args:
        data: UTF-8 JSON; a byte order mark is skipped.
        found: Receives what is wrong, duplicate keys included.
        name: How messages call the bytes.
    """
    if b"\0" in data[:65536]:
        remedy = "Name a JSON file in UTF-8."
        found.add("FILE_NOT_TEXT", "", None, f"{name} is not text (it holds zero bytes).", remedy)
        return None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        message = f"{name} is not UTF-8 text (byte {error.start})."
        found.add("FILE_NOT_TEXT", "", error.start, message, "Save it as UTF-8.")
        return None
    if not text.strip():
        message = f"{name} is empty."
        found.add("FILE_NOT_JSON", "", "", message, "Name an ESG document.")
        return None
    try:
        tree = json.loads(text, object_pairs_hook=_collect)
    except json.JSONDecodeError as error:
        message = f"{name} is not JSON: {error.msg} at line {error.lineno}, column {error.colno}."
        cut_off = error.pos >= len(text.rstrip()) - 1 or "Unterminated" in error.msg
        remedy = "The file is cut off: write it again." if cut_off else "Correct the syntax there."
        around = text[max(0, error.pos - 20) : error.pos + 20]
        found.add("FILE_NOT_JSON", "", around, message, remedy)
        return None
    except (RecursionError, ValueError) as error:
        reason = "it is nested too deeply" if isinstance(error, RecursionError) else str(error)
        found.add("FILE_NOT_JSON", "", None, f"{name} cannot be read: {reason}.", "Simplify it.")
        return None
    if not is_object(tree):
        message = f"{name} holds a JSON {type(tree).__name__}, not an object."
        found.add("FILE_NOT_OBJECT", "", clip(tree), message, "Name an ESG document.")
        return None
    _duplicates(tree, found)
    return tree


def _collect(pairs: list[tuple[str, Any]]) -> _Object:
    out = _Object(pairs)
    if len(out) != len(pairs):
        seen: set[str] = set()
        twice = [k for k, _ in pairs if k in seen or seen.add(k)]
        out.twice = tuple(dict.fromkeys(twice))
    return out


def _duplicates(tree: Any, found: Findings) -> None:
    stack: list[tuple[tuple[str | int, ...], Any]] = [((), tree)]
    while stack:
        path, node = stack.pop()
        if isinstance(node, _Object):
            for key in node.twice:
                where = pointer(*path, key)
                message = f"The key {key[:80]!r} occurs more than once in one object."
                found.add("JSON_DUPLICATE_KEY", where, key, message, "Keep one of them.")
        items = node.items() if is_object(node) else enumerate(node)
        stack.extend(((*path, k), v) for k, v in items if is_object(v) or is_list(v))


def check_file(path: Path | str) -> CheckReport:
    """Checks a file: its JSON, its schema and every rule of the verifier.

    Args:
        path: The file; whatever is wrong with it becomes a violation, never an exception.
    """
    found = Findings()
    return _checked(str(path), read_json(path, found), found)


def check_text(text: str) -> CheckReport:
    """Checks a text as `check_file` does a file.

    Args:
        text: JSON; whatever is wrong with it becomes a violation, never an exception.
    """
    found = Findings()
    data = text.encode("utf-8", errors="replace")
    return _checked("", parse_json(data, found), found)


def _checked(path: str, raw: dict[str, Any] | None, found: Findings) -> CheckReport:
    if raw is None:
        return CheckReport(path, tuple(found.items))
    violations = (*found.items, *verify(raw))
    document = None
    if not violations:
        document = parse(raw, Findings()).doc
    return CheckReport(path, violations, document)


def load_document(path: Path | str) -> EsgDocument:
    """Reads a document that fits the schema.

    The rules are not applied: call `verify` for them. Only a place made of what no table knows is
    refused, since it cannot be shown.

    Raises:
        UserError: Naming everything that keeps the file from being read as an ESG document.
    """
    from esg.graph.rules_dressing import unknown_names

    found = Findings()
    raw = read_json(path, found)
    doc = None if raw is None else parse(raw, found).doc
    if doc is None or found.items:
        report = CheckReport(str(path), tuple(found.items))
        raise UserError(f"not an ESG document: {report.text()}")
    for where, name in unknown_names(doc.dressing) if doc.dressing else ():
        raise UserError(
            f"{path}: /dressing/{where}: {name[:80]!r} is in no table of what places are made of; "
            "use one of esg/lexicon, or remove dressing"
        )
    return doc
