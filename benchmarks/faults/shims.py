"""Libraries that are preloaded into commands, compiled when they are needed."""

from __future__ import annotations

from pathlib import Path
import shutil
import subprocess


def compiled(name: str, folder: Path) -> Path:
    """A library of this folder's C, compiled.

    Args:
        name: Of the file, without its ending.
        folder: Receives the library.

    Raises:
        subprocess.CalledProcessError: If it cannot be compiled.
    """
    library = folder / f"{name}.so"
    if not library.is_file():
        folder.mkdir(parents=True, exist_ok=True)
        source = Path(__file__).with_name(f"{name}.c")
        cc = next((c for c in ("cc", "gcc", "clang") if shutil.which(c)), "cc")
        command = [cc, "-shared", "-fPIC", "-O1", str(source), "-o", str(library), "-ldl"]
        subprocess.run(command, check=True, capture_output=True)
    return library
