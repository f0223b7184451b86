"""Temporary folders that know whose they are: what a killed process left can be told and removed.

A process killed by SIGKILL cannot tidy up. Its folders carry the id and the start time of their
owner, so that the next process can remove those whose owner is gone and touch no others.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path
import shutil
import sys
import tempfile
import time

OWNER = "owner"
_UNKNOWN_AFTER_S = 86400.0
"""Folders without an owner file (killed in the moment between) go after this time."""


def owned_folder(prefix: str) -> Path:
    """A new temporary folder of this process."""
    folder = Path(tempfile.mkdtemp(prefix=prefix))
    (folder / OWNER).write_text(f"{os.getpid()} {_started(os.getpid())}\n")
    return folder


def sweep_leftovers(prefix: str, root: Path | None = None, now: float | None = None) -> int:
    """Removes folders of processes that are gone; returns how many.

    Args:
        prefix: Beginning of the folders' names.
        root: Where they are; default the system's folder for temporary files.
        now: Time to compare with [s since the epoch]; default the clock.
    """
    place = root or Path(tempfile.gettempdir())
    moment = time.time() if now is None else now
    count = 0
    for folder in place.glob(f"{prefix}*"):
        with contextlib.suppress(OSError):
            if folder.is_symlink() or folder.stat().st_uid != _user():
                continue
            if _abandoned(folder, moment):
                shutil.rmtree(folder, ignore_errors=True)
                count += not folder.exists()
    return count


def _user() -> int:
    return os.getuid() if hasattr(os, "getuid") else 0  # as Windows says of every file


def _abandoned(folder: Path, now: float) -> bool:
    try:
        pid, started = (folder / OWNER).read_text(encoding="ascii").split()
        number = int(pid)
    except (OSError, ValueError):
        return now - folder.stat().st_mtime > _UNKNOWN_AFTER_S
    return _started(number) != started


def _started(pid: int) -> str:
    """When a process started, in the system's own words; "gone" if there is none."""
    with contextlib.suppress(OSError, IndexError):
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[19]
    if sys.platform == "win32":  # signal 0 would end it there; what is left is left
        return "running"
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return "gone"
    except PermissionError:
        pass
    return "running"
