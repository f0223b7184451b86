"""Whether a class is ours: it must equal, byte for byte, what this version emits.

What this process wrote itself is remembered; any other class is compared with the class that its
scene's document gives now. The document is data: names in it reach the class only escaped.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.compile.build import ClassFiles
    from esg.compile.emit import EmittedClass
    from esg.graph.models import EsgDocument

_MOST_REMEMBERED = 4096
_remembered: dict[str, None] = {}


class Standing(StrEnum):
    """Whose a class is."""

    OWN = "own"
    """This process emitted it, from a document that it made or was given by its caller."""
    EQUAL = "equal"
    """It is what this version emits from the document beside it."""
    FOREIGN = "foreign"
    """Anything else: edited, of another version, or without a document."""


def _key(name: str, header: str, source: str, imports: str) -> str:
    return hashlib.sha256("\0".join((name, header, source, imports)).encode()).hexdigest()


def remember(name: str, header: str, source: str, imports: str) -> None:
    """Notes that this process has written a class, given its name and its texts."""
    _remembered[_key(name, header, source, imports)] = None
    if len(_remembered) > _MOST_REMEMBERED:
        del _remembered[next(iter(_remembered))]


def is_remembered(files: ClassFiles, imports: str) -> bool:
    """Whether this process has written a class, be it into another folder."""
    return _key(files.name, files.header, files.source, imports) in _remembered


def standing_of(
    files: ClassFiles, imports: str, document: Callable[[], EsgDocument] | Path
) -> tuple[Standing, str]:
    """Whose a class is, and for a foreign one why.

    Args:
        files: The class.
        imports: Text of its import manifest.
        document: What it should come from: gives the caller's own, or the file beside the class.
    """
    if is_remembered(files, imports):
        return Standing.OWN, ""
    try:
        emitted = _emitted(document)
    except UserError as error:
        return Standing.FOREIGN, f"there is nothing to compare it with: {error}".splitlines()[0]
    except (ValueError, KeyError, TypeError, ArithmeticError) as error:
        return Standing.FOREIGN, f"esg.json gives no class ({type(error).__name__})"
    texts = {
        f"{emitted.name}.h": (files.header, emitted.header),
        f"{emitted.name}.cpp": (files.source, emitted.source),
        "imports.json": (imports, emitted.imports_json),
    }
    if files.name != emitted.name:
        return Standing.FOREIGN, f"{files.name} is not the class of esg.json, {emitted.name}"
    other = [name for name, (found, right) in texts.items() if found != right]
    if other:
        return Standing.FOREIGN, f"{other[0]} is not what this version emits from esg.json"
    return (Standing.EQUAL if isinstance(document, Path) else Standing.OWN), ""


def _emitted(document: Callable[[], EsgDocument] | Path) -> EmittedClass:
    from esg.compile.scene import emit_document
    from esg.graph import load_document

    found = load_document(document) if isinstance(document, Path) else document()
    return emit_document(found).emitted
