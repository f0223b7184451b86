"""XML from strangers: nothing that expands, nothing deep, nothing endless."""

from __future__ import annotations

from xml.etree import ElementTree as ET
from xml.parsers import expat

from esg.outcomes import UserError

MOST_ELEMENTS = 20_000
MOST_DEPTH = 200


def parsed(data: bytes, where: str) -> ET.Element:
    """The root of a document without declarations of its own.

    Args:
        data: The file's bytes.
        where: What a message calls it.

    Raises:
        UserError: If it is no XML, declares entities, or is too large or deep.
    """
    count, depth = 0, 0
    tree = ET.TreeBuilder()
    reader = expat.ParserCreate(namespace_separator="}")
    reader.buffer_text = True

    def full(name: str) -> str:
        return f"{{{name}" if "}" in name else name

    def opened(name: str, attributes: dict[str, str]) -> None:
        nonlocal count, depth
        count, depth = count + 1, depth + 1
        if count > MOST_ELEMENTS or depth > MOST_DEPTH:
            raise UserError(
                f"{where}, line {reader.CurrentLineNumber}: more than {MOST_ELEMENTS} elements, "
                f"or more than {MOST_DEPTH} in each other; give a smaller file"
            )
        tree.start(full(name), {full(key): value for key, value in attributes.items()})

    def closed(name: str) -> None:
        nonlocal depth
        depth -= 1
        tree.end(full(name))

    def declared(name: str, *_: object) -> None:
        raise UserError(
            f"{where}, line {reader.CurrentLineNumber}: it declares a document type ({name}), "
            "which may hold entities; delete the declaration"
        )

    reader.StartElementHandler = opened
    reader.EndElementHandler = closed
    reader.StartDoctypeDeclHandler = declared
    reader.CharacterDataHandler = tree.data
    try:
        reader.Parse(data, True)
    except (expat.ExpatError, ValueError, LookupError) as error:
        raise UserError(f"{where}: not XML ({error}); correct it") from None
    return tree.close()
