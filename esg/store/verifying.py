"""All data below a folder, read with its checksums (`esg db verify`)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
import json
from pathlib import Path
import zipfile
import zlib

from esg.files import is_intact, sweep
from esg.outcomes import UserError
from esg.store.checking import check_recording
from esg.store.db import query
from esg.store.tables import TABLES, read_table


@dataclass(frozen=True)
class Verified:
    """What a verification read.

    Args:
        files: Number of files read.
        problems: What is damaged, a line each.
        leftovers: Temporary files of killed writers that were removed.
    """

    files: int
    problems: tuple[str, ...]
    leftovers: int = 0


def verify(db: Path | None, folders: Sequence[Path]) -> Verified:
    """Reads all data below folders, and a database, with all their checksums.

    Args:
        db: The database; None, or one that does not exist, is left out.
        folders: Searched for Parquet files, recordings (`.mcap`) and rollouts (`.npz`).

    Raises:
        UserError: If a folder does not exist.
    """
    missing = [str(f) for f in folders if not f.exists()]
    if missing:
        raise UserError(f"{', '.join(missing)}: no such file or folder; check the path")
    problems: list[str] = []
    paths = [p for f in folders for p in ([f] if f.is_file() else sorted(f.rglob("*")))]
    laid_out = {p.parent for p in paths if p.name == _LAYOUT and p.parent.parent.name == "layouts"}
    paths = [p for p in paths if laid_out.isdisjoint(p.parents)]  # these know their files
    paths = [p for p in paths if p.suffix in _CHECKS and p.name[0] != "." and p.is_file()]
    paths = list(dict.fromkeys(paths))
    leftovers = sum(sweep(folder) for f in folders if f.is_dir() for folder in _folders(f))
    for path in paths:
        try:
            _CHECKS[path.suffix](path)
        except UserError as error:
            problems.append(str(error))
    for folder in sorted(laid_out):
        problems += _layout_problems(folder)
    read = len(paths) + len(laid_out)
    if db is None or not db.is_file():
        return Verified(read, tuple(problems), leftovers)
    problems += _database_problems(db)
    return Verified(read + 1, tuple(problems), leftovers)


def _folders(root: Path) -> Iterator[Path]:
    yield root
    yield from (p for p in root.rglob("*") if p.is_dir() and not p.is_symlink())


def _layout_problems(folder: Path) -> list[str]:
    """Files of a layout of a dataset that are not as they were written (esg.dataset.layouts)."""
    try:
        files = json.loads((folder / _LAYOUT).read_bytes())["files"]
        wrong = [n for n, facts in files.items() if not is_intact(folder / n, facts["sha256"])]
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        wrong = [_LAYOUT]
    remedy = f"delete {folder} and add it again (esg dataset --resume --layout {folder.name})"
    return [f"{folder / name} is damaged; {remedy}" for name in wrong]


def _database_problems(db: Path) -> list[str]:
    """Reads every value of every table; DuckDB's blocks have checksums."""
    problems: list[str] = []
    for table in TABLES:
        try:
            query(db, f"SELECT bit_xor(hash(t)) FROM {table} t", timeout_s=0.0)
        except UserError as error:
            problems.append(str(error) if str(db) in str(error) else f"{db}: {error}")
    return list(dict.fromkeys(problems))


def _check_rollout(path: Path) -> None:
    try:
        with zipfile.ZipFile(path) as archive:
            bad = archive.testzip()
    except (zipfile.BadZipFile, zlib.error, OSError, EOFError, ValueError, RuntimeError) as error:
        bad = str(error)
    if bad:
        raise UserError(f"{path} is damaged ({bad}); run its scene again")


_LAYOUT = "layout.json"
_CHECKS = {".parquet": read_table, ".mcap": check_recording, ".npz": _check_rollout}
