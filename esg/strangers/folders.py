"""A scene folder is opened only if everything in it lies in it and is a file of a bearable size."""

from __future__ import annotations

from collections.abc import Iterator
import os
from pathlib import Path
import stat

from esg.outcomes import UserError

MOST_FILES = 10_000
MOST_FILE_BYTES = 2**30
MOST_BYTES = 4 * 2**30
_KINDS = {
    stat.S_IFIFO: "a pipe", stat.S_IFSOCK: "a socket", stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}  # fmt: skip
REMEDY = "remove it, or ask whoever sent the folder for one without"


def admitted(folder: Path) -> Path:
    """The folder.

    Raises:
        UserError: If something in it may not be opened.
    """
    wrong = oddity(folder)
    if wrong:
        raise UserError(wrong)
    return folder


def oddity(folder: Path) -> str:
    """What keeps a folder from being opened, with place, value and remedy; empty if nothing does.

    Symbolic links may lead to other files of the folder, and the folder itself may be one.
    """
    home = folder.resolve()
    files, total = 0, 0
    for path in _entries(folder):
        shown = folder / os.path.relpath(path, folder)
        facts = path.lstat()
        if stat.S_ISLNK(facts.st_mode):
            if not lies_in(path, home):
                return f"{shown} is a link out of its folder (to {os.readlink(path)!r}); {REMEDY}"
            continue
        kind = _KINDS.get(stat.S_IFMT(facts.st_mode))
        if kind:
            return f"{shown} is {kind}, not a file; {REMEDY}"
        files, total = files + 1, total + facts.st_size
        if facts.st_size > MOST_FILE_BYTES:
            return f"{shown} has {_size(facts.st_size)}, at most {_size(MOST_FILE_BYTES)} are read"
        if files > MOST_FILES or total > MOST_BYTES:
            return f"{folder} holds more than {MOST_FILES} files or {_size(MOST_BYTES)}; {REMEDY}"
    return ""


def lies_in(path: Path, folder: Path) -> bool:
    """Whether a path, its links followed, is in a folder; a path that cannot be is not."""
    try:
        return path.resolve().is_relative_to(folder.resolve())
    except (OSError, ValueError, RuntimeError):  # a loop of links, a zero byte
        return False


def file_in(folder: Path, relative: str) -> Path | None:
    """A regular file by its path inside a folder; None if it leads out or is none.

    Args:
        folder: The folder.
        relative: Parts with slashes between, as a stranger may have written them.
    """
    parts = relative.split("/")
    if "\0" in relative or "\\" in relative or any(p in ("", ".", "..") for p in parts):
        return None
    path = folder.joinpath(*parts)
    try:
        plain = stat.S_ISREG(path.stat().st_mode)
    except (OSError, ValueError):
        return None
    return path if plain and lies_in(path, folder) else None


def _entries(folder: Path) -> Iterator[Path]:
    """Everything below a folder but its folders; no link is followed."""
    waiting = [folder]
    while waiting:
        here = waiting.pop()
        try:
            with os.scandir(here) as found:
                entries = sorted(found, key=lambda e: e.name)
        except OSError:
            continue  # what cannot be listed cannot be read: its readers say so
        for entry in entries:
            if entry.is_dir(follow_symlinks=False):
                waiting.append(Path(entry.path))
            else:
                yield Path(entry.path)


def _size(count: int) -> str:
    return f"{count / 2**30:.1f} GiB"
