"""Stage results by content: a folder under the key of everything that determined it.

    <root>/<first two hex digits>/<key>/data/...       what the stage wrote
    <root>/<first two hex digits>/<key>/artifact.json  size and SHA-256 of every file of it
    <root>/tmp/...                                     being written

A result is written aside and renamed into place, so that a key either has its whole result or none.
Every file's hash is checked before a process first uses an artifact and again whenever its size or
modification time changes; a damaged artifact is dropped and counts as never computed. Any number of
processes may write the same key: the first rename wins, the others adopt its result.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Generator, Mapping
import contextlib
import errno
import hashlib
import json
import logging
import os
from pathlib import Path
import re
import shutil
import time
from typing import Any
import uuid

from esg.files import explained, sha256_of, sync_folder, sync_tree
from esg.paths import cache_dir

FORMAT = 1
MARK = "artifact.json"
DATA = "data"
_KEY = re.compile(r"[a-z]+-[0-9a-f]{64}")
_log = logging.getLogger(__name__)


def artifact_key(
    stage: str, *, inputs: Mapping[str, str], config: Mapping[str, Any], code_version: str
) -> str:
    """Key of a stage's result.

    Args:
        stage: Name of the stage, lower-case letters.
        inputs: Keys (or content hashes) of what it reads, by name.
        config: JSON values that change its result.
        code_version: Version of the code that makes it.

    Returns:
        "stage-" and 64 hex digits.

    Raises:
        ValueError: If the configuration holds NaN or infinity.
        TypeError: If it holds anything but JSON values.
    """
    identity = {
        "format": FORMAT,
        "stage": stage,
        "inputs": dict(inputs),
        "config": dict(config),
        "code_version": code_version,
    }
    text = json.dumps(identity, sort_keys=True, allow_nan=False, separators=(",", ":"))
    return f"{stage}-{hashlib.sha256(text.encode()).hexdigest()}"


_MOST_VERIFIED = 16384
_verified: OrderedDict[str, bytes] = OrderedDict()
"""Folders of artifacts that this process has hashed, latest last, with what tells that their files
are still the same; 300 bytes each. Kept for good they were a third of a worker's growth."""


def forget(root: Path) -> None:
    """Drops what is known of the artifacts of a store whose folder goes or has gone.

    Args:
        root: Of the store.
    """
    below = f"{root}{os.sep}"
    for home in [h for h in list(_verified) if h.startswith(below)]:
        _verified.pop(home, None)


def _remember(home: Path, signature: bytes) -> None:
    _verified[str(home)] = signature
    while len(_verified) > _MOST_VERIFIED:
        _verified.popitem(last=False)


class ArtifactStore:
    """A folder of artifacts.

    Args:
        root: The folder; default `artifacts` in the cache folder. Created on first writing.
        durable: Whether results are forced to the disk. Without it they survive a killed process
            and a power failure may damage them, which the hashes tell; ten times faster on disks
            that take forcing seriously.
    """

    def __init__(self, root: Path | None = None, *, durable: bool = True) -> None:
        self.root = root if root is not None else cache_dir() / "artifacts"
        self.durable = durable

    def find(self, key: str) -> Path | None:
        """Folder with the finished, undamaged result of `key`, or None.

        Raises:
            ValueError: If `key` is no artifact key.
        """
        home = self._home(key)
        if not (home / MARK).is_file():
            return None
        if self._intact(home):
            return home / DATA
        _log.warning("artifact %s is damaged: dropped, it will be computed again", key)
        self._discard(home)
        return None

    def create(self, key: str, fill: Callable[[Path], None]) -> Path:
        """Computes a result and stores it, or adopts one that another process stored meanwhile.

        Args:
            key: The artifact's key.
            fill: Writes the result into an empty folder. If it raises, nothing is stored.

        Returns:
            The folder with the result.

        Raises:
            OSError: As of `making`.
        """
        with self.making(key) as folder:
            fill(folder)
        return self._home(key) / DATA

    @contextlib.contextmanager
    def making(self, key: str) -> Generator[Path]:
        """An empty folder for the body to fill, which is stored when the body ends.

        Args:
            key: The artifact's key. If another process stores it meanwhile, that result stays.

        Raises:
            OSError: With the remedy in its text if the disk is full, read-only or forbidden.
        """
        home = self._home(key)
        work = self.root / "tmp" / f"{key}.{os.getpid()}-{uuid.uuid4().hex[:8]}"
        try:
            (work / DATA).mkdir(parents=True)
            yield work / DATA
            self._seal(key, work)
            self._install(key, work, home)
        except OSError as error:
            inside = error.filename is None or str(error.filename).startswith(str(self.root))
            raise explained(error, self.root) if inside else error from error
        finally:
            shutil.rmtree(work, ignore_errors=True)

    def _home(self, key: str) -> Path:
        if not _KEY.fullmatch(key):
            raise ValueError(f"{key!r} is no artifact key (stage-<64 hex digits>)")
        return self.root / key.rsplit("-", 1)[1][:2] / key

    def _seal(self, key: str, work: Path) -> None:
        files = {
            path.relative_to(work / DATA).as_posix(): {
                "size": path.stat().st_size,
                "sha256": sha256_of(path),
            }
            for path in sorted((work / DATA).rglob("*"))
            if path.is_file()
        }
        mark = {"format": FORMAT, "key": key, "files": files}
        mark["sha256"] = _mark_hash(mark)
        (work / MARK).write_text(json.dumps(mark, indent=1, sort_keys=True), encoding="utf-8")
        if self.durable:
            sync_tree(work)

    def _install(self, key: str, work: Path, home: Path) -> None:
        home.parent.mkdir(parents=True, exist_ok=True)
        for _ in range(8):
            try:
                work.rename(home)
            except OSError as error:
                if error.errno not in (errno.EEXIST, errno.ENOTEMPTY):
                    raise
                if self.find(key) is not None:
                    return
                # Half a folder without its mark: not an artifact, whoever left it.
                if home.exists():
                    self._discard(home)
            else:
                if self.durable:
                    sync_folder(home.parent)
                _remember(home, _folded(_signature(home)))
                return
        raise OSError(errno.EBUSY, "other writers keep replacing this artifact", str(home))

    def _intact(self, home: Path) -> bool:
        try:
            signature = _signature(home)
            if _verified.get(str(home)) == _folded(signature):
                return True
            mark = json.loads((home / MARK).read_bytes())
            if mark["format"] != FORMAT or mark["sha256"] != _mark_hash(mark):
                return False
            files = mark["files"]
            found = {name: size for name, size, _ in signature if name != MARK}
            if found != {f"{DATA}/{name}": facts["size"] for name, facts in files.items()}:
                return False
            if any(sha256_of(home / DATA / n) != facts["sha256"] for n, facts in files.items()):
                return False
        except (OSError, ValueError, KeyError, TypeError):
            return False
        _remember(home, _folded(signature))
        return True

    def _discard(self, home: Path) -> None:
        """Moves a folder out of the way in one step, then deletes it."""
        _verified.pop(str(home), None)
        grave = self.root / "tmp" / f"{home.name}.{uuid.uuid4().hex[:8]}.dead"
        with contextlib.suppress(FileNotFoundError):
            grave.parent.mkdir(parents=True, exist_ok=True)
            home.rename(grave)
            shutil.rmtree(grave, ignore_errors=True)

    def sweep(self, older_than_s: float = 86400.0, now: float | None = None) -> int:
        """Deletes what killed writers left in `tmp`; returns the number of folders."""
        now = time.time() if now is None else now
        count = 0
        folder = self.root / "tmp"
        for path in folder.iterdir() if folder.is_dir() else ():
            with contextlib.suppress(FileNotFoundError):
                if now - path.stat().st_mtime > older_than_s:
                    shutil.rmtree(path, ignore_errors=True)
                    count += 1
        return count

    def prune(self, older_than_s: float, now: float | None = None) -> int:
        """Deletes artifacts stored longer ago than `older_than_s`; returns how many."""
        now = time.time() if now is None else now
        count = 0
        for mark in sorted(self.root.glob(f"??/*/{MARK}")):
            with contextlib.suppress(FileNotFoundError):
                if now - mark.stat().st_mtime > older_than_s:
                    self._discard(mark.parent)
                    count += 1
        return count


def _signature(home: Path) -> tuple[tuple[str, int, int], ...]:
    out: list[tuple[str, int, int]] = []
    folders = [(str(home), "")]
    while folders:
        folder, before = folders.pop()
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.is_dir():
                    if not entry.is_symlink():
                        folders.append((entry.path, f"{before}{entry.name}/"))
                else:
                    facts = os.stat(entry.path)
                    out.append((f"{before}{entry.name}", facts.st_size, facts.st_mtime_ns))
    return tuple(sorted(out))


def _folded(signature: tuple[tuple[str, int, int], ...]) -> bytes:
    """What a folder looked like, in few bytes."""
    return hashlib.blake2b(repr(signature).encode(), digest_size=16).digest()


def _mark_hash(mark: Mapping[str, Any]) -> str:
    body = {k: v for k, v in mark.items() if k != "sha256"}
    text = json.dumps(body, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()
