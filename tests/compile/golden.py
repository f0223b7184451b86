"""Rewrites the golden files: `python tests/compile/golden.py`; commits say why they change."""

from __future__ import annotations

from pathlib import Path

import scenes

from esg.compile import emit_class
from esg.compile.emit import EmittedClass

FOLDER = Path(__file__).parent / "golden"


def emitted() -> EmittedClass:
    return emit_class(*scenes.street(), watch=scenes.STREET_WATCH)


def files() -> dict[str, str]:
    e = emitted()
    return {f"{e.name}.h": e.header, f"{e.name}.cpp": e.source, "imports.json": e.imports_json}


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for name, text in files().items():
        (FOLDER / name).write_text(text, "utf-8", newline="\n")
