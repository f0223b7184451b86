"""What `esg setup` has left on this machine, and whether that is still there.

All of it depends on the code, on the libraries, on Python and on devices; what was compiled is
files. Where the former are the same and the latter as large as they were, there is nothing to do.
"""

from __future__ import annotations

from collections.abc import Iterator
import contextlib
import hashlib
import json
import os
from pathlib import Path
import platform
import re
import shutil
import sys

from esg.codeversion import sources_hash
from esg.files import atomic_write
from esg.paths import cache_dir, kernel_cache_dir

NOTE = "setup.json"
_BEING_WRITTEN = re.compile(r"_p\d+_t\d+$")
"""Ends the name of a folder of kernels while a process compiles them."""


def prepared(device: str | None) -> bool:
    """Whether a set-up was done with this code on this machine, and all of it is still there.

    Args:
        device: As of `esg setup`.
    """
    with contextlib.suppress(OSError, ValueError, TypeError, LookupError):
        told = json.loads((cache_dir() / NOTE).read_bytes())[_machine(device)]
        return bool(told) and all(Path(p).stat().st_size == size for p, size in told.items())
    return False


def note_prepared(device: str | None) -> None:
    """Notes what a set-up has left, in place of what earlier code of this machine did.

    Args:
        device: As of `esg setup`.
    """
    left = {str(path): path.stat().st_size for path in _left()}
    text = json.dumps({_machine(device): left}, indent=1, sort_keys=True)
    with contextlib.suppress(OSError):  # a cache that is full makes the next one do it again
        atomic_write(cache_dir() / NOTE, lambda path: path.write_text(text, "utf-8"))


def _machine(device: str | None) -> str:
    """What the result of a set-up depends on, as a digest."""
    libraries = sorted(
        entry.name
        for folder in sys.path
        if os.path.isdir(folder)
        for entry in os.scandir(folder)
        if entry.name.endswith((".dist-info", ".egg-info"))
    )
    compiler = shutil.which(os.environ.get("CXX") or "g++")
    parts = [
        device,
        sources_hash(),
        libraries,
        [sys.version, sys.prefix, platform.machine(), platform.processor()],
        sorted(p.name for p in Path("/dev").glob("nvidia*")),
        os.environ.get("CUDA_VISIBLE_DEVICES"),
        [compiler, compiler and os.stat(compiler).st_mtime_ns],
        str(kernel_cache_dir()),
    ]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()


def _left() -> Iterator[Path]:
    """Files that a set-up has made or found: kernels, the scheduler's database, shared C++."""
    own = cache_dir()
    folders = [p for p in kernel_cache_dir().glob("wp_*") if not _BEING_WRITTEN.search(p.name)]
    for folder in (*folders, *own.glob("classes/include-*")):
        yield from (p for p in folder.rglob("*") if p.is_file())
    yield from own.glob("prefect/template-*.db")
