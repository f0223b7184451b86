"""Writing files so that a reader sees the whole of one or nothing of it."""

from __future__ import annotations

from collections.abc import Callable, Generator
import contextlib
import errno
import hashlib
import json
import os
from pathlib import Path
import re
import time
from typing import IO, Any
import uuid

from esg.outcomes import UserError

TEMPORARY = ".tmp"
_AT_ONCE = 16

_REMEDIES = {
    errno.ENOSPC: "free some space, or choose a folder on another disk",
    errno.EDQUOT: "your quota is used up: free some space, or choose another folder",
    errno.EROFS: "the disk is read-only: choose a folder on another one",
    errno.EACCES: "you may not write there: change its permissions or choose another folder",
    errno.EPERM: "you may not write there: change its permissions or choose another folder",
    errno.EFBIG: "files may not grow that large here: raise the limit (ulimit -f)",
}


def unwritable(error: BaseException) -> bool:
    """Whether the machine refuses to write: a full, read-only or forbidden disk.

    Nothing is wrong with what was to be written: it can be made again once there is room.
    """
    if not isinstance(error, OSError) or error.errno not in _REMEDIES:
        return False
    # Without a file's name a refusal may be one of a network.
    return error.errno not in (errno.EACCES, errno.EPERM) or error.filename is not None


def explained(error: OSError, path: Path) -> OSError:
    """The same error with the path and what to do about it in its text."""
    remedy = _REMEDIES.get(error.errno or 0)
    if remedy is None:
        return error
    text = f"{os.strerror(error.errno or 0)}; {remedy}"
    return type(error)(error.errno, text, str(path))


@contextlib.contextmanager
def refused(path: Path) -> Generator[None]:
    """Tells of a disk that cannot be written in one message with the remedy.

    Args:
        path: What the block writes.

    Raises:
        UserError: For a full, read-only or forbidden disk; other errors pass.
    """
    try:
        yield
    except OSError as error:
        if not unwritable(error):
            raise
        why = explained(error, path).strerror
        raise UserError(f"cannot write {path}: {why}", exit_code=1) from None


def temporary_name(path: Path) -> Path:
    """A name beside `path` that no other writer uses and no reader looks at."""
    return path.with_name(f".{path.name}.{os.getpid()}-{uuid.uuid4().hex[:8]}{TEMPORARY}")


def final_names(text: str) -> str:
    """A message with temporary names replaced by those of the files they would have become."""
    return re.sub(rf"\.([^/\"']+)\.\d+-[0-9a-f]{{8}}{re.escape(TEMPORARY)}", r"\1", text)


def safe_name(text: str) -> str:
    """A text as the name of a file or folder: one level, only characters safe everywhere."""
    return re.sub(r"[^A-Za-z0-9._-]+", "_", text).strip("._")[:120]


def read_limited(path: Path, limit: int) -> bytes:
    """The bytes of a file that somebody else made.

    Args:
        path: The file.
        limit: Largest size [bytes].

    Raises:
        UserError: If it is larger.
        OSError: If it cannot be read.
    """
    with path.open("rb") as file:
        data = file.read(limit + 1)
    if len(data) > limit:
        raise UserError(f"{path} has more than {limit / 2**20:g} MiB; give a smaller file")
    return data


@contextlib.contextmanager
def atomic_file(path: Path, *, durable: bool = True) -> Generator[IO[bytes]]:
    """Opens a temporary file that becomes `path` when the block ends, or vanishes if it fails.

    Args:
        path: The file; folders above it are made.
        durable: Whether it is forced to the disk. Without that a power failure may leave half of
            it, which is for files whose reader notices and makes them again.

    Raises:
        OSError: With the remedy in its text for a full, read-only or forbidden disk.
    """
    temporary = temporary_name(path)
    try:
        make_folder(path.parent)
        with temporary.open("wb") as file:
            yield file
            if durable:
                file.flush()
                os.fsync(file.fileno())
        os.replace(temporary, path)
        if durable:
            sync_folder(path.parent)
    except OSError as error:
        raise explained(error, path) from error
    finally:
        temporary.unlink(missing_ok=True)


def write_json(path: Path, document: Any) -> None:
    """Writes a JSON document for people, complete or not at all.

    Raises:
        OSError: As for `atomic_file`.
    """
    with atomic_file(path) as file:
        file.write(json.dumps(document, indent=2, ensure_ascii=False).encode() + b"\n")


def atomic_write(path: Path, write: Callable[[Path], object]) -> None:
    """Lets `write` fill a temporary file by name, then renames it to `path`.

    Raises:
        OSError: As for `atomic_file`.
    """
    temporary = temporary_name(path)
    try:
        make_folder(path.parent)
        write(temporary)
        sync_file(temporary)
        os.replace(temporary, path)
        sync_folder(path.parent)
    except OSError as error:
        raise explained(error, path) from error
    finally:
        temporary.unlink(missing_ok=True)


def make_folder(path: Path) -> None:
    """Makes a folder and those above it, and forces their names to the disk."""
    missing = [p for p in (path, *path.parents) if not p.exists()]
    path.mkdir(parents=True, exist_ok=True)
    for made in missing:
        sync_folder(made.parent)


def sync_tree(folder: Path) -> None:
    """Forces everything in a folder to the disk, and the names of it."""
    from concurrent.futures import ThreadPoolExecutor

    paths = [folder, *folder.rglob("*")]
    # A disk that is asked for many files at once writes them in one go: a fifth of the time.
    with ThreadPoolExecutor(min(len(paths), _AT_ONCE)) as pool:
        for _ in pool.map(_sync, paths):
            pass


def _sync(path: Path) -> None:
    if path.is_dir():
        sync_folder(path)
    else:
        sync_file(path)


def sync_file(path: Path) -> None:
    """Forces a file's content to the disk."""
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def sha256_of(path: Path) -> str:
    """The SHA-256 of a file's content, in hexadecimal."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


_MOST_INTACT = 1024
_intact: dict[Path, tuple[tuple[int, ...], str]] = {}
"""Signature and digest of files read last; a batch's compiled classes are new ones every time."""


def is_intact(path: Path, digest: str) -> bool:
    """Whether a file is there and has the content of a digest; it is read again once it changes.

    Args:
        path: Of the file.
        digest: As `sha256_of` gives it.
    """
    try:
        facts = path.stat()
        signature = (facts.st_ino, facts.st_size, facts.st_mtime_ns, facts.st_ctime_ns)
        known = _intact.get(path)
        if known is None or known[0] != signature:
            known = _intact[path] = signature, sha256_of(path)
            while len(_intact) > _MOST_INTACT:
                _intact.pop(next(iter(_intact)), None)
    except OSError:
        return False
    return known[1] == digest


def sync_folder(path: Path) -> None:
    """Forces a folder's entries to the disk, where the file system supports it."""
    with contextlib.suppress(OSError):
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def sweep(folder: Path, older_than_s: float = 86400.0, now: float | None = None) -> int:
    """Deletes temporary files that a killed writer left behind; returns how many.

    Args:
        folder: Searched without its subfolders.
        older_than_s: Younger ones may still be written.
        now: Time to compare with [s since the epoch]; default the clock.
    """
    now = time.time() if now is None else now
    count = 0
    if not folder.is_dir():
        return 0
    for path in folder.iterdir():
        if not path.name.endswith(TEMPORARY) or not path.is_file():
            continue
        with contextlib.suppress(FileNotFoundError):
            if now - path.stat().st_mtime > older_than_s:
                path.unlink()
                count += 1
    return count
