"""Whether a class is ours: it must equal, byte for byte, what this version emits.

What this process wrote itself is known; any other class is compared with the class that its
scene's document gives now. The document is data: names in it reach the class only escaped.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

from esg.compile.trust.written import is_remembered
from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.compile.build import ClassFiles
    from esg.compile.emit import EmittedClass
    from esg.graph.models import EsgDocument


class Standing(StrEnum):
    """Whose a class is."""

    OWN = "own"
    """This process emitted it, from a document that it made or was given by its caller."""
    EQUAL = "equal"
    """It is what this version emits from the document beside it."""
    FOREIGN = "foreign"
    """Anything else: edited, of another version, or without a document."""


def standing_of(
    files: ClassFiles, imports: str, document: Callable[[], EsgDocument] | EsgDocument | Path
) -> tuple[Standing, str]:
    """Whose a class is, and for a foreign one why.

    Args:
        files: The class.
        imports: Text of its import manifest.
        document: What it should come from: a function gives the caller's own; a document or its
            file came with the class.
    """
    if is_remembered(files.name, files.header, files.source, imports):
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
    return (Standing.OWN if callable(document) else Standing.EQUAL), ""


def _emitted(document: Callable[[], EsgDocument] | EsgDocument | Path) -> EmittedClass:
    from esg.compile.scene import emit_document
    from esg.graph import load_document

    if isinstance(document, Path):
        document = load_document(document)
    return emit_document(document() if callable(document) else document).emitted
