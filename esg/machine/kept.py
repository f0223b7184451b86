"""What code alone computes, kept on disk between processes: textures, encoded pictures.

A value lies under a key made of everything that it depends on, behind the SHA-256 of its bytes:
what a crash or a failing disk left damaged is made again. A cache that cannot be written costs time
only.
"""

from __future__ import annotations

from collections.abc import Callable
import contextlib
from functools import cache
import hashlib
from pathlib import Path
import shutil
import time

from esg.files import atomic_file
from esg.paths import cache_dir

OTHER_VERSION_S = 30 * 86400.0
"""What another version of the code keeps goes after so long without a write [s]."""
_DIGEST = 32


def kept(room: str, version: str, name: str, make: Callable[[], bytes]) -> bytes:
    """Bytes from the cache, else made and kept.

    Args:
        room: Folder below the cache's.
        version: Of everything but the name that the bytes depend on (`version_of`).
        name: Of the value in this version; part of a file's name.
        make: Makes it.
    """
    path = cache_dir() / room / version / name
    with contextlib.suppress(OSError):
        found = path.read_bytes()
        if hashlib.sha256(found[_DIGEST:]).digest() == found[:_DIGEST]:
            return found[_DIGEST:]
    data = make()
    if not path.parent.is_dir():
        _sweep(path.parent.parent)
    with contextlib.suppress(OSError), atomic_file(path, durable=False) as file:
        file.write(hashlib.sha256(data).digest() + data)
    return data


@cache
def version_of(folder: Path, *versions: str) -> str:
    """Hex digest of the modules in a folder and of what else results depend on.

    Args:
        folder: Of the code.
        versions: Of libraries; other numbers.
    """
    digest = hashlib.sha256("\0".join(versions).encode())
    for path in sorted(folder.rglob("*.py")):
        digest.update(path.relative_to(folder).as_posix().encode())
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()[:20]


def _sweep(room: Path) -> None:
    """Takes away what versions keep that nobody has used for long."""
    with contextlib.suppress(OSError):
        for folder in room.iterdir():
            if time.time() - folder.stat().st_mtime > OTHER_VERSION_S:
                shutil.rmtree(folder, ignore_errors=True)
