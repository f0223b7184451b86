"""Power losses: a command dies at an operation on files, and with it what was not forced to disk.

A preloaded library (`losses.c`) writes down every change of names and keeps each file as it was
when it was forced to the disk. After the end, the folder is made what a disk may hold then: of each
folder's changes since it was last forced, the first few (in order); of each file what was forced
last, or what was written since, or some pages of it. That is what POSIX promises and no more.
"""

from __future__ import annotations

from collections.abc import Iterator
import contextlib
import ctypes
from dataclasses import dataclass, field
import os
from pathlib import Path
import random
import shutil
import signal
import sys
import time

from benchmarks.faults.ground import begin, finish, started_fork
from benchmarks.faults.kills import SERVED, Facts, arguments, difference, facts, prepared_copy, run
from benchmarks.faults.shims import compiled

PAGE = 4096
LOADED = "FAULTS_LOSSES_LOADED"
"""Set where the library is in this process and does nothing until it is told to."""
AFTER_END = 0.25
"""Share of the losses that come when the command has just said that it is done."""


@dataclass(eq=False)
class File:
    """A file: what of it is on the disk for certain; None if nothing ever was forced.

    Args:
        synced: Where its forced content lies; nowhere for an empty one.
        origin: Its path before the command, whose content was on the disk.
        link: Text of a symbolic link.
    """

    synced: Path | None = None
    origin: str = ""
    link: str | None = None


@dataclass(eq=False)
class Folder:
    """A folder and what is in it."""

    names: dict[str, File | Folder] = field(default_factory=dict)


@dataclass(frozen=True)
class Loss:
    """A power loss.

    Args:
        after_end: Whether it came when the command had said that it was done.
        lost: How many changes of names and contents of files were lost.
        wrong: What did not hold; empty if all did.
    """

    after_end: bool
    lost: int
    wrong: str = ""


@dataclass(frozen=True)
class Change:
    """A change of names: what it takes away and what it adds.

    Args:
        removed: A folder and the name taken from it.
        added: A folder, the name it gets and what that stands for.
    """

    removed: tuple[Folder, str] | None = None
    added: tuple[Folder, str, File | Folder] | None = None

    def folders(self) -> list[Folder]:
        """Those that it changes."""
        return [end[0] for end in (self.removed, self.added) if end]

    def apply(self) -> None:
        """Makes it."""
        if self.removed:
            self.removed[0].names.pop(self.removed[1], None)
        if self.added:
            self.added[0].names[self.added[1]] = self.added[2]


def scanned(place: Path) -> Folder:
    """The tree of a folder whose content is on the disk."""
    top = Folder()
    for entry in os.scandir(place):
        path = Path(entry.path)
        if entry.is_symlink():
            top.names[entry.name] = File(link=os.readlink(path))
        elif entry.is_dir():
            top.names[entry.name] = scanned(path)
        else:
            top.names[entry.name] = File(origin=str(path))
    return top


def _at(top: Folder, place: Path, path: str) -> tuple[Folder, str] | None:
    """The folder that a path lies in, and its name there."""
    parts = Path(os.path.normpath(path)).relative_to(place).parts
    folder = top
    for part in parts[:-1]:
        inner = folder.names.get(part)
        if not isinstance(inner, Folder):
            return None
        folder = inner
    return (folder, parts[-1]) if parts else None


@dataclass
class Journal:
    """What a command did to names, and what of it is on the disk for certain.

    Args:
        changes: In their order.
        durable: Numbers of those that were forced to the disk.
    """

    changes: list[Change] = field(default_factory=list)
    durable: set[int] = field(default_factory=set)

    def force(self, folder: Folder | None) -> None:
        """A folder, or all, was forced: with each change all that came before it where it acts."""
        folders = {folder} if folder else {f for c in self.changes for f in c.folders()}
        for number in range(len(self.changes) - 1, -1, -1):
            touched = self.changes[number].folders()
            if any(f in folders for f in touched):
                self.durable.add(number)
                folders.update(touched)

    def surviving(self, rng: random.Random) -> Iterator[Change]:
        """The forced changes and, of the others, in each folder the first few."""
        lost, share = set[Folder](), rng.choice((0.0, 0.02, 0.2, 1.0))
        for number, change in enumerate(self.changes):
            if number not in self.durable and (
                any(f in lost for f in change.folders()) or rng.random() < share
            ):
                lost.update(change.folders())
            else:
                yield change


def read_journal(folder: Path, live: Folder, place: Path) -> Journal:
    """Follows a journal; afterwards `live` is the tree as the command left it."""
    journal = Journal()
    text = (folder / "journal").read_text("utf-8", "surrogateescape")
    for line in text.splitlines() if text else ():
        what, one, two = line.split("\t")
        if what == "sync-all":
            journal.force(None)
            continue
        if what == "sync-folder" and Path(one) == place:
            journal.force(live)
            continue
        here = _at(live, place, one) if Path(one).is_relative_to(place) else None
        known = here[0].names.get(here[1]) if here else None
        if what == "sync" and isinstance(known, File):
            known.synced, known.origin = folder / "snap" / two, ""
        elif what == "sync-folder" and isinstance(known, Folder):
            journal.force(known)
        else:
            change = _change(what, here, known, _at(live, place, two) if "/" in two else None, two)
            if change:
                journal.changes.append(change)
                change.apply()
    return journal


def _change(
    what: str,
    here: tuple[Folder, str] | None,
    known: File | Folder | None,
    there: tuple[Folder, str] | None,
    text: str,
) -> Change | None:
    if here is None:
        return None
    made = {"make": File, "folder": Folder, "symlink": lambda: File(link=text)}.get(what)
    if made and (known is None or what == "symlink"):
        return Change(added=(*here, made()))
    if known is None:
        return None
    if what == "remove":
        return Change(removed=here)
    if what == "rename":
        return Change(removed=here, added=(*there, known) if there else None)
    if what == "link" and there:
        return Change(added=(*there, known))
    return None


def lose(place: Path, before: Folder, folder: Path, pristine: Path, rng: random.Random) -> int:
    """Makes a folder what a disk may hold of it after a power loss.

    Args:
        place: The folder as the command left it.
        before: Its tree before the command; changed here.
        folder: Of the journal.
        pristine: A copy of the place as it was before the command.
        rng: Chooses among what may be.

    Returns:
        How many changes of names and files were lost.
    """
    durable = _copied(before)
    journal = read_journal(folder, before, place)
    written = {id(file): path for path, file in _files(before, place)}
    kept = list(journal.surviving(rng))
    # The same changes, made to the tree of before: folders are told by what they were copied from.
    twin = dict(durable[1])
    for change in kept:
        _again(change, twin).apply()
    wanted: dict[Path, bytes | str] = {}
    lost = len(journal.changes) - len(kept)
    for path, file in _files(durable[0], place):
        if file.link is not None:
            wanted[path] = file.link
            continue
        now = written.get(id(file))
        content = now.read_bytes() if now and now.is_file() else b""
        sound = _sound(file, place, pristine)
        if content != sound:
            content = _torn(content, sound, rng)
            lost += 1
        wanted[path] = content
    _make(place, durable[0], wanted)
    return lost


def _copied(top: Folder) -> tuple[Folder, dict[Folder, Folder]]:
    """A copy of a tree with the same files in it, and the twin of each folder."""
    twins: dict[Folder, Folder] = {}

    def copy(folder: Folder) -> Folder:
        twins[folder] = twin = Folder()
        for name, inner in folder.names.items():
            twin.names[name] = copy(inner) if isinstance(inner, Folder) else inner
        return twin

    return copy(top), twins


def _again(change: Change, twins: dict[Folder, Folder]) -> Change:
    """A change as one of the twins of its folders; folders that it makes get a twin."""

    def twin(folder: Folder) -> Folder:
        return twins.setdefault(folder, Folder())

    removed = (twin(change.removed[0]), change.removed[1]) if change.removed else None
    added = None
    if change.added:
        folder, name, what = change.added
        added = (twin(folder), name, twin(what) if isinstance(what, Folder) else what)
    return Change(removed, added)


def _files(folder: Folder, path: Path) -> Iterator[tuple[Path, File]]:
    for name, inner in folder.names.items():
        if isinstance(inner, Folder):
            yield from _files(inner, path / name)
        else:
            yield path / name, inner


def _sound(file: File, place: Path, pristine: Path) -> bytes:
    """What of a file is on the disk for certain."""
    if file.synced is not None:
        return file.synced.read_bytes()
    return (pristine / Path(file.origin).relative_to(place)).read_bytes() if file.origin else b""


def _torn(content: bytes, sound: bytes, rng: random.Random) -> bytes:
    """A file written since it was forced: all of it, nothing, a beginning, or some pages."""
    fate = rng.randrange(4)
    if fate == 0:
        return content
    if fate == 1:
        return sound
    if fate == 2:
        size = rng.randrange(len(content) + 1)
        return content[:size] + b"\0" * (len(content) - size)
    old = sound.ljust(len(content), b"\0")
    pages = range(0, len(content), PAGE)
    return b"".join((content if rng.random() < 0.5 else old)[k : k + PAGE] for k in pages)


def _make(place: Path, tree: Folder, wanted: dict[Path, bytes | str]) -> None:
    """Makes a folder what it is to be; files that are that already stay as they are."""
    for path in sorted(place.rglob("*"), reverse=True):
        if path.is_dir() and not path.is_symlink():
            with contextlib.suppress(OSError):
                path.rmdir()  # an empty one; made again if it is wanted
        elif path not in wanted:
            path.unlink()
    for path in _folders(tree, place):
        path.mkdir(parents=True, exist_ok=True)
    for path, content in wanted.items():
        if isinstance(content, str):
            path.unlink(missing_ok=True)
            path.symlink_to(content)
        elif not path.is_file() or path.read_bytes() != content:
            path.write_bytes(content)


def _folders(folder: Folder, path: Path) -> Iterator[Path]:
    yield path
    for name, inner in folder.names.items():
        if isinstance(inner, Folder):
            yield from _folders(inner, path / name)


def open_journal(folder: Path) -> None:
    """Makes an empty journal."""
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "snap").mkdir(parents=True)
    (folder / "journal").touch()
    (folder / "counter").write_bytes(bytes(8))


def operations(folder: Path) -> int:
    """How many operations on files a journal counts."""
    return int.from_bytes((folder / "counter").read_bytes(), "little")


def variables(place: Path, library: Path, journal: Path, at: int) -> dict[str, str]:
    """The environment of a command whose power fails.

    Args:
        place: Folder whose changes are written down.
        library: To preload.
        journal: Of `open_journal`.
        at: The operation that it does not survive; 0: none.
    """
    return {
        "LD_PRELOAD": str(library),
        "ESG_LOSS_ROOT": str(place),
        "ESG_LOSS_JOURNAL": str(journal),
        "ESG_LOSS_AT": str(at),
    }


def _preloaded(name: str, place: Path, library: Path, journal: Path, at: int) -> int:
    """Runs a command until an operation, or to its end; returns the number of operations."""
    open_journal(journal)
    more = variables(place, library, journal, at)
    line, cache = arguments(name, place), place / "cache"
    if name in SERVED or LOADED not in os.environ:
        process = begin(line, place, cache, **more)
        pid, ended = process.pid, finish(process, 600.0, time.monotonic())
    else:
        command = started_fork(line, place, cache, lambda: _begin(more), **more)
        pid, ended = command.pid, command.finish(600.0)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)
    if ended.wrong((0, 3)) and not (at and ended.code == -signal.SIGKILL):
        raise RuntimeError(f"{name}: {ended.wrong((0, 3))}")
    return operations(journal)


def _begin(more: dict[str, str]) -> None:
    """In a fork: lets the library that this process has preloaded begin."""
    os.environ.update(more)  # which sets them in C as well
    ctypes.CDLL(None).esg_loss_begin()


def preload_here(folder: Path) -> None:
    """Starts this process anew with the library preloaded, unless it is: its forks can use it."""
    if LOADED in os.environ:
        return
    library = compiled("losses", folder)
    os.environ.update({"LD_PRELOAD": str(library), LOADED: "1"})
    os.execv(sys.executable, [sys.executable, *sys.orig_argv[1:]])


def sound(name: str, ground: Path, place: Path) -> tuple[Facts, int]:
    """What a command leaves undisturbed, and how many operations that takes."""
    place = prepared_copy(ground, place, name).resolve()
    library = compiled("losses", place.with_name(place.name + "-library"))
    count = _preloaded(name, place, library, place.with_name(place.name + "-journal"), 0)
    return facts(place), count


def loss(
    name: str, rng: random.Random, ground: Path, place: Path, undisturbed: tuple[Facts, int]
) -> Loss:
    """One power loss during a command, or when it has said that it is done.

    Args:
        name: Of `kills.COMMANDS`.
        rng: Chooses when, and what is lost.
        ground: A prepared folder.
        place: Where it happens.
        undisturbed: What `sound` told.
    """
    place = prepared_copy(ground, place, name).resolve()
    (place / "tmp").mkdir()
    pristine = place.with_name(place.name + "-pristine")
    shutil.rmtree(pristine, ignore_errors=True)
    shutil.copytree(place, pristine, symlinks=True)
    library = compiled("losses", place.with_name(place.name + "-library"))
    journal = place.with_name(place.name + "-journal")
    before = scanned(place)
    after = rng.random() < AFTER_END
    at = 0 if after else rng.randint(1, undisturbed[1])
    _preloaded(name, place, library, journal, at)
    lost = lose(place, before, journal, pristine, rng)
    when = "after its end" if after else f"at operation {at} of {undisturbed[1]}"
    if not after:
        ended = run(name, place)
        if ended.wrong((0, 3)):
            return Loss(after, lost, f"{when}, run again: {ended.wrong((0, 3))}")
    wrong = difference(undisturbed[0], facts(place), "" if after else name)
    return Loss(after, lost, "" if wrong == "same" else f"{when}: {wrong}")
