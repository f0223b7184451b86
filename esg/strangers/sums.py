"""`SHA256SUMS`: what the files of a scene folder were when it was written (see `sha256sum -c`)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
import os
from pathlib import Path
import re

from esg.files import atomic_file, sha256_of
from esg.strangers.folders import file_in

SUMS = "SHA256SUMS"
FINISHING = ".finishing"
"""The mark of a folder that lacks its pictures (esg.scenefolder.unfinished): no file of a scene."""
_LINE = re.compile(r"([0-9a-f]{64})  (\S.*)")
_MOST_BYTES = 4 * 2**20


@dataclass(frozen=True)
class Differences:
    """How a folder differs from its list.

    Args:
        changed: Files with another content, sorted.
        missing: Listed files that are not there.
        added: Files that are not listed.
        wrong: Why the list itself cannot be used; empty if it can.
    """

    changed: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    added: tuple[str, ...] = ()
    wrong: str = ""

    @property
    def problem(self) -> str:
        """What is not as it was written, in one sentence; added files are none."""
        if self.wrong:
            return self.wrong
        told = [f"{name} has changed" for name in self.changed]
        told += [f"{name} is missing" for name in self.missing]
        more = f" (and {len(told) - 1} more)" if len(told) > 1 else ""
        return f"{told[0]} since the folder was written{more}" if told else ""


def seal(folder: Path, only: Iterable[Path] | None = None) -> None:
    """Writes the list of a folder.

    Args:
        folder: The folder.
        only: Files that were written anew: the lines of the others stay, and a folder without a
            list gets none.
    """
    if only is None:
        known = digests(folder)
    else:
        known, wrong = _listed(folder)
        if wrong or not known:
            return
        fresh = {Path(os.path.relpath(p, folder)).as_posix(): sha256_of(p) for p in only}
        if all(known.get(name) == digest for name, digest in fresh.items()):
            return
        known |= fresh
    write_sums(folder, known)


def digests(folder: Path) -> dict[str, str]:
    """SHA-256 of every file below a folder, by its path in it."""
    return {name: sha256_of(folder / name) for name in _files(folder)}


def write_sums(folder: Path, known: Mapping[str, str]) -> None:
    """Writes a list, complete or not at all.

    Args:
        folder: The folder.
        known: SHA-256 by file.
    """
    lines = [f"{digest}  {name}\n" for name, digest in sorted(known.items())]
    with atomic_file(folder / SUMS) as file:
        file.write("".join(lines).encode())


def differences(folder: Path) -> Differences | None:
    """How a folder differs from its list; None if it has none."""
    if not (folder / SUMS).exists():
        return None
    known, wrong = _listed(folder)
    if wrong:
        return Differences(wrong=f"{SUMS} {wrong}")
    changed: list[str] = []
    missing: list[str] = []
    for name, digest in known.items():
        path = file_in(folder, name)
        if path is None:
            missing.append(name)
        elif sha256_of(path) != digest:
            changed.append(name)
    added = sorted(set(_files(folder)) - set(known))
    return Differences(tuple(sorted(changed)), tuple(sorted(missing)), tuple(added))


def altered(folder: Path) -> list[str]:
    """That a scene folder is not as it was written, with the remedy; nothing if it is."""
    found = differences(folder)
    if found is None or not found.problem:
        return []
    remedy = f"esg check {folder} tells more; delete {SUMS} if you changed it yourself"
    return [f"{folder}: {found.problem}; {remedy}"]


def _listed(folder: Path) -> tuple[dict[str, str], str]:
    """Digests by file, and what is wrong with the list."""
    path = file_in(folder, SUMS)
    if path is None or path.stat().st_size > _MOST_BYTES:
        return {}, "is no list of files"
    found: dict[str, str] = {}
    for number, line in enumerate(path.read_bytes().decode("utf-8", "replace").splitlines(), 1):
        match = _LINE.fullmatch(line)
        if match is None:
            return {}, f"is damaged in line {number}"
        found[match[2]] = match[1]
    return found, "" if found else "is empty"


def _files(folder: Path) -> list[str]:
    """Every file below a folder but the list and the mark, hidden ones included."""
    found: list[str] = []
    for here, _, names in os.walk(folder):
        for name in names:
            path = Path(here, name)
            relative = path.relative_to(folder).as_posix()
            if path.is_file() and relative not in (SUMS, FINISHING):
                found.append(relative)
    return sorted(found)
