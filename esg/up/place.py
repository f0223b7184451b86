"""Where a warm worker listens, and what tells one from another.

A worker serves callers of its own user, checkout, interpreter and settings: all of these are in
its socket's name. That its code is still the caller's is told by a stamp, sent with every request.
"""

from __future__ import annotations

from collections.abc import Mapping
import hashlib
import os
from pathlib import Path
import stat
import sys
import tempfile

from esg.outcomes import UserError

COMMANDS = frozenset({"draft", "generate", "replay"})
"""What a worker runs."""
OFF = "ESG_UP"
"""Set to 0, a command asks no worker."""
_CODE = ("esg", "tasks", "flows")
_SETTINGS = ("ESG_", "PYTHON", "OMP_", "OPENBLAS_", "MKL_", "WARP_", "LD_", "LC_", "PREFECT_")
"""Variables that libraries read when they are loaded, by their beginning."""
_NAMES = frozenset({"HOME", "LANG", "LANGUAGE", "XDG_CACHE_HOME", "XDG_DATA_HOME"})
_PER_CALL = frozenset({OFF, "ESG_DB", "ESG_STAGE_LIMITS", "ESG_STAGE_SECONDS", "PYTHONWARNINGS"})
"""Read, or set, anew by every command, whatever their beginning."""


def folder() -> Path:
    """Folder of this user's sockets; it may not exist."""
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    if runtime and os.path.isdir(runtime) and os.stat(runtime).st_uid == os.getuid():
        return Path(runtime) / "esg"
    return Path(tempfile.gettempdir()) / f"esg-{os.getuid()}"


def private(path: Path) -> bool:
    """Whether a folder is this user's own and nobody else may look into it."""
    try:
        found = os.lstat(path)
    except OSError:
        return False
    own = stat.S_ISDIR(found.st_mode) and found.st_uid == os.getuid()
    return own and not stat.S_IMODE(found.st_mode) & 0o077


def make_private(path: Path) -> Path:
    """The folder, made if it is not there.

    Raises:
        UserError: If it is somebody else's, or others may look into it.
    """
    try:
        path.mkdir(mode=0o700)
    except FileExistsError:
        pass
    except OSError as error:
        raise UserError(f"{path}: {error.strerror}; set XDG_RUNTIME_DIR or TMPDIR") from None
    if not private(path):
        raise UserError(
            f"{path} is not a folder that only you can open (mode 0700): remove it, or set "
            "XDG_RUNTIME_DIR or TMPDIR to another place"
        )
    return path


def socket_path(environment: Mapping[str, str] | None = None) -> Path:
    """The socket of the worker for a caller with this code, interpreter and settings.

    Args:
        environment: The caller's; default this process's.
    """
    given = os.environ if environment is None else environment
    settings = sorted(
        f"{name}={value}"
        for name, value in given.items()
        if (name.startswith(_SETTINGS) or name in _NAMES) and name not in _PER_CALL
    )
    parts = [str(root()), sys.executable, sys.prefix, *settings]
    key = hashlib.sha256("\0".join(parts).encode("utf-8", "surrogateescape")).hexdigest()
    return folder() / f"up-{key[:20]}.sock"


def root() -> Path:
    """Folder that holds this code."""
    return Path(__file__).resolve().parents[2]


def stamp() -> str:
    """What changes when a file of the code does: names, sizes and times of all of them."""
    digest = hashlib.sha256(sys.version.encode())
    for name in _CODE:
        _add(digest, str(root() / name))
    return digest.hexdigest()


def _add(digest: hashlib._Hash, path: str) -> None:
    try:
        entries = sorted(os.scandir(path), key=lambda entry: entry.name)
    except OSError:
        return
    for entry in entries:
        if entry.is_dir(follow_symlinks=False):
            if entry.name != "__pycache__":
                _add(digest, entry.path)
        else:
            found = entry.stat()
            digest.update(f"{entry.path}:{found.st_size}:{found.st_mtime_ns};".encode())
